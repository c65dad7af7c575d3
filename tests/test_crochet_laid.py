"""Things that are sewn to nothing lie as a hand lays them: flat ones flat, tents on their rims, cups on their bottoms, in order."""

from functools import cache

import numpy as np

from tambour.core.errors import Text
from tambour.core.progress import Progress
from tambour.crochet.graph.spots import Spots
from tambour.crochet.params import CrochetParams
from tambour.crochet.piece import Plush
from tambour.crochet.plush import make
from tambour.crochet.table import gathered, laid_out

BOWL = """{0}
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnd 3: (sc, inc) x 6 (18)
Rnds 4-7: sc around (18)
Fasten off.

"""
STRIP = """{0}
Ch 6.
Row 1: sc in 2nd ch from hook, sc in next 4 ch, turn (5)
Rows 2-14: ch 1, sc in each st, turn (5)
Fasten off.

"""
SET = "Tea time\n\n" + BOWL.format("CUP") + BOWL.format("TENT") + STRIP.format("NAPKIN")


@cache
def _set() -> Plush:
    return make(Text(SET, "set.txt"), CrochetParams(solver="settle", tolerance=0.2), Progress())


def _own(piece: Plush, name: str) -> np.ndarray:
    part = piece.built.graph.parts[Spots(piece.built).parts[name]]
    return piece.positions[part.start : part.end]


def test_a_flat_piece_lies_and_does_not_stand_on_its_edge() -> None:
    wide, high, deep = np.ptp(_own(_set(), "NAPKIN"), axis=0)
    assert high < 0.2 * min(wide, deep) and wide > deep


def test_a_tent_stands_on_its_rim_and_a_cup_on_its_bottom() -> None:
    piece = _set()
    spots = Spots(piece.built)
    rims = {name: piece.positions[spots.rim(spots.parts[name]), 1].mean() for name in ("CUP", "TENT")}
    assert rims["CUP"] > _own(piece, "CUP")[:, 1].mean() and rims["TENT"] < _own(piece, "TENT")[:, 1].mean()


def test_all_stand_on_one_floor() -> None:
    floors = [_own(_set(), name)[:, 1].min() for name in ("CUP", "TENT", "NAPKIN")]
    assert np.ptp(floors) < 1e-6


def test_laying_a_set_again_changes_nothing_that_counts() -> None:
    piece = _set()
    again = laid_out(piece.built, piece.positions)
    assert np.abs(np.ptp(again, axis=0) - np.ptp(piece.positions, axis=0)).max() < piece.stitch[0]


def test_many_small_things_stand_in_rows_beside_each_other_and_not_in_each_other() -> None:
    text = "Cookies\n\n" + "".join(
        BOWL.format(f"{word} COOKIE") for word in "ONE TWO THREE FOUR FIVE SIX SEVEN".split()
    )
    piece = make(Text(text, "cookies.txt"), CrochetParams(solver="none"), Progress())
    graph = piece.built.graph
    x = piece.positions + gathered(graph, piece.positions, np.ones(len(graph), bool))
    boxes = [(x[p.start : p.end].min(0), x[p.start : p.end].max(0)) for p in graph.parts]
    for k, (low, high) in enumerate(boxes):
        for other in boxes[:k]:
            assert (low > other[1])[[0, 2]].any() or (high < other[0])[[0, 2]].any()
    wide, _, deep = np.ptp(x, axis=0)
    assert wide < 4.0 * deep


def test_a_set_is_looked_at_from_above_so_that_what_lies_is_seen() -> None:
    from tambour.crochet.page import portrait

    assert portrait.stand(_set()) == portrait.OVER


def test_toys_that_are_seen_from_the_side_do_not_hide_each_other() -> None:
    text = "Two worms\n\n" + "".join(
        f"{word} WORM\nR1: 6 sc in MR (6)\nR2-R20: sc around (6)\n\n" for word in ("LONG", "RED")
    )
    piece = make(Text(text, "worms.txt"), CrochetParams(solver="none"), Progress())
    graph, x, azimuth = piece.built.graph, piece.positions[:, [0, 2, 1]], 0.8  # they lie, their noses ahead
    x = x + gathered(graph, x, np.ones(len(graph), bool), azimuth)
    across = x @ np.array([np.cos(azimuth), 0.0, -np.sin(azimuth)])
    one, other = sorted((across[p.start : p.end].min(), across[p.start : p.end].max()) for p in graph.parts)
    assert one[1] < other[0]

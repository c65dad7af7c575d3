"""What is drawn of straight stitches (lines, bands, crosses), where rounds are said to begin, and how far a part reaches that its paragraph is about."""

from __future__ import annotations

import numpy as np
import pytest

from crochet_read import pattern, unread
from tambour.crochet.graph.build import build
from tambour.crochet.graph.spots import Spots
from tambour.crochet.language.finishes import Embroidery, Eye, Placed

_BALL = "Rnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\nRnd 3: (1 sc, inc) x 6 (18)\nRnd 4: (2 sc, inc) x 6 (24)\nRnd 5-{last}: sc in each st (24)\n"
_FISH = (
    "A SMALL WHALE\n\nBODY (blue)\nStart at the nose.\n" + _BALL.format(last=14) + "{seam}\n"
    "Rnd 15: 6 sc, (1 sc, dec) x 4, 6 sc (20)\nRnd 16: sc in each st (20)\nRnd 17: (3 sc, dec) x 4 (16)\nRnd 18: (2 sc, dec) x 4 (12)\nFasten off. Stuff.\n\n"
    "BELLY (white)\nRnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\nRnd 3: (1 sc, inc) x 6 (18)\n\n"
    "TAIL FLUKES (make 2, blue)\nRnd 1: 6 sc in MR (6)\nRnd 2: sc in each st (6)\n\n"
    "FINISHING\nBelly: sew it to the underside of the body over Rnd 5 to Rnd 10. {drawn}\nSew the flukes to the end of the body.\n"
)  # fmt: skip


def _fish(seam: str = "", drawn: str = "") -> str:
    return _FISH.format(seam=seam, drawn=drawn)


def _lowest(words: str) -> float:
    """How high the first stitch of a round is where the whale lies, against the middle of the round."""
    built = build(pattern(words))
    spots = Spots(built)
    spots.stand(0, "side")
    ring = spots.layout[spots.stitches(spots.round_at(0, 10) or 0)]
    return float(ring[0, 2] - ring[:, 2].mean())  # what is ahead while it is worked is above then


@pytest.mark.parametrize(
    ("seam", "above"),
    [
        ("", False),
        ("The stitch you are about to make is the middle of Wally's BACK.", True),
        ("The beginning of the round is at the centre of the back.", True),
        ("The beginning of each round lies along the middle of the belly.", False),
    ],
)
def test_a_whale_lies_as_its_rounds_are_said_to_begin(seam: str, above: bool) -> None:
    assert (_lowest(_fish(seam)) > 0.0) == above


def test_eyes_are_as_far_apart_over_the_back_as_is_counted() -> None:
    words = _fish(
        "Eyes: put them in between Rnd 6 and Rnd 7. You should have 12 stitches between the eyes over the back."
    )
    eyes = [r for r in pattern(words).finish if isinstance(r, Eye)]
    one, other = sorted(e.spot.stitch or 0.0 for e in eyes)
    assert min(other - one, 24 - (other - one)) == pytest.approx(11, abs=0.01)  # of 24: 12 free over the back, 10 below


def test_lines_are_drawn_on_the_part_that_a_paragraph_is_about() -> None:
    words = _fish(drawn="With blue, sew three long straight stitches lengthwise over it for the grooves.")
    lines = [r for r in pattern(words).finish if isinstance(r, Embroidery)]
    assert [r.spots[0].part for r in lines] == ["BELLY"] * 3
    assert not [w for w in pattern(words).warnings if "do without it" in w.message]


_CAT = (
    "CAT\nShe sits about 15 cm tall.\n\nHEAD (ginger)\n" + _BALL.format(last=12) + "Rnd 13: (2 sc, dec) x 6 (18)\nStuff.\n\n"
    "BODY (ginger)\n" + _BALL.format(last=22) + "Rnd 23: (2 sc, dec) x 6 (18)\nStuff.\n\n"
    "BIB (white)\nRnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\n\n"
    "FRONT LEGS (make 2, ginger)\nRnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\nRnd 3-12: sc in each st (12)\nPress the top flat and sc 6 through both layers.\n\n"
    "TAIL (ginger)\nRnd 1: 8 sc in MR (8)\nRnd 2-20: sc in each st (8)\n\n"
    "MAKING UP\nHead to body: both openings have 18 sts. Match them up and sew.\n{how}\n"
)  # fmt: skip


def _drawn(how: str) -> list[Embroidery]:
    return [r for r in pattern(_CAT.format(how=how)).finish if isinstance(r, Embroidery)]


def test_lines_and_bands_in_one_sentence_go_where_each_is_said() -> None:
    how = "With rust, three short straight lines on the forehead, from round 4 down to round 7, and three bands across the top half of the tail."
    made = _drawn(how)
    assert [r.spots[0].part for r in made] == ["HEAD"] * 3 + ["TAIL"] * 3
    assert unread(_CAT.format(how=how)) == []
    for band in made[3:]:
        assert len({s.round for s in band.spots}) == 1 and band.spots[0].round > 10  # around it, by where it is sewn on


@pytest.mark.parametrize(
    ("said", "many"),
    [("two whiskers per cheek", 2), ("three whiskers on each side of the nose", 3), ("whiskers on each side", 3)],
)
def test_whiskers_are_as_many_as_are_said(said: str, many: int) -> None:
    made = _drawn(f"With black, embroider {said}.")
    assert [r.motif for r in made] == ["whiskers"] * (2 * many)


def test_lines_on_nothing_that_is_named_are_told() -> None:
    found = pattern(_CAT.format(how="Embroider three long straight lines as you like."))
    assert not [r for r in found.finish if isinstance(r, Embroidery)]


def test_a_bib_reaches_from_the_neck_to_where_its_lower_edge_is() -> None:
    how = "Bib: pin it in the middle of the chest. The top touches the neck seam and the bottom comes down to about round 17."
    words = _CAT.format(how=how)
    bib = next(r for r in pattern(words).finish if isinstance(r, Placed) and r.part == "BIB")
    assert bib.spot.round == 19.0
    assert unread(words) == [] and not [w for w in pattern(words).warnings if "do without it" in w.message]


def test_legs_that_were_closed_flat_leave_as_many_stitches_between_them_as_are_said() -> None:
    how = "Front legs: The legs hang from round 18, with two sts between them, and the paws stand flat on the table."
    legs = [r for r in pattern(_CAT.format(how=how)).finish if isinstance(r, Placed) and r.part.startswith("FRONT")]
    assert abs((legs[0].spot.stitch or 0.0) - (legs[1].spot.stitch or 0.0)) == pytest.approx(9.0)
    assert all(r.points is not None and np.allclose(np.abs(r.points), (0.0, 1.0, 0.1)) for r in legs)


def test_no_stitch_is_counted_below_the_first() -> None:
    for r in pattern(_fish("The stitch you are about to make is the middle of the back.")).finish:
        if isinstance(r, Placed | Eye) and r.spot.stitch is not None:
            assert r.spot.stitch >= 0.5

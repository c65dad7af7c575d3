"""Skirts and frills worked on the free loops of a round stand on exactly these, hang down outside of the body, and are printed as worked."""

import numpy as np
import pytest

from tambour.core.errors import Text
from tambour.core.progress import Progress
from tambour.crochet.graph.spots import Spots
from tambour.crochet.language.finishes import Placed
from tambour.crochet.page.instructions import instructions
from tambour.crochet.page.own import pattern as written_back
from tambour.crochet.params import CrochetParams
from tambour.crochet.plush import make
from tambour.crochet.printed.choose import read

DOLL = """Doll

Yarn: DK in cream and pink

BODY
Rnd 1: 6 sc in magic ring (6)
Rnd 2: inc x 6 (12)
Rnd 3: (sc, inc) x 6 (18)
Rnd 4-6: 18 sc (18)
Rnd 7: BLO 18 sc (18)
Rnd 8-12: 18 sc (18)
Rnd 13: (sc, dec) x 6 (12)
Rnd 14: dec x 6 (6)
Fasten off. Stuff.

{}
Rnd 1: ch 2, (2 dc, 2 dc in next st) x 6, sl st in first dc (24)
Rnd 2: ch 2, 24 dc, sl st in first dc (24)
Fasten off.
"""
WORDINGS = [
    "Turn the doll upside down. Join pink in a free front loop of Rnd 6 at the back.",
    "Hold the doll upside down. Join pink to a front loop of Rnd 6 at the back.",
    "Fold the doll upside down, join pink in FLO of Rnd 6.",
    "Join pink with sl st in free loops of Rnd 6 of Body.",
    "With the doll upside down, join pink yarn in the front loops of Rnd 6.",
    "Attach pink to any front loop of R6.",
    "Hold the doll with the head down and attach pink to the front loops left over from Rnd 6.",
    "Join pink to a front loop left free in R6.",
    "Insert your hook in a front loop of Rnd 6 and pull up a loop of pink.",
]


@pytest.mark.parametrize("words", WORDINGS)
def test_a_skirt_stands_on_the_loops_that_it_is_joined_in(words: str) -> None:
    pattern = read(Text(DOLL.format(f"SKIRT\n{words}"), "doll.txt"))
    assert not pattern.unread, pattern.unread
    assert not [p.message for p in pattern.warnings]
    (hung,) = [r for r in pattern.finish if isinstance(r, Placed)]
    assert (hung.part, hung.spot.part, hung.spot.round, hung.through, hung.around) == ("SKIRT", "BODY", 6.0, 18, True)
    said = instructions(pattern, exact=False).text
    skirt = said[said.index("## SKIRT") :]
    assert "Use pink." in skirt and "free loop of Rnd 6 of BODY" in skirt and "18 ch" not in skirt
    assert "Rnd 1: 2 ch, [2 dc, dc inc] x 6, join (24)" in skirt and "Assembly" not in skirt
    for back in (read(written_back(pattern)), read(instructions(pattern))):
        assert [r for r in back.finish if isinstance(r, Placed)] == [hung]


def test_only_what_hangs_is_read_so() -> None:
    """A brim that goes on along a cap's loops stays its cap's, as it was."""
    assert not [
        r
        for r in read(Text(DOLL.format("BRIM\nJoin pink in a free front loop of Rnd 6."), "doll.txt")).finish
        if isinstance(r, Placed)
    ]


@pytest.mark.slow
def test_it_hangs_down_outside_of_the_body() -> None:
    piece = make(Text(DOLL.format(f"SKIRT\n{WORDINGS[0]}"), "doll.txt"), CrochetParams(), Progress())
    spots, x, graph = Spots(piece.built), piece.positions, piece.built.graph
    loops = spots.stitches(spots.round_at(spots.parts["BODY"], 6))
    (pairs,) = piece.shape.joined.seams
    assert sorted(pairs[:, 1].tolist()) == sorted(loops.tolist()), "one stitch on each loop"
    skirt, body = (graph.parts[spots.parts[name]] for name in ("SKIRT", "BODY"))
    middle = x[loops].mean(0)
    hem = spots.stitches(spots.round_at(spots.parts["SKIRT"], 2))
    up = x[spots.stitches(spots.round_at(spots.parts["BODY"], 13))].mean(0) - middle
    up /= np.linalg.norm(up)
    assert ((x[hem] - middle) @ up).max() < -5.0, "every stitch of its hem is below the loops"
    out = np.linalg.norm((x[hem] - middle) - ((x[hem] - middle) @ up)[:, None] * up, axis=1)
    under = x[body.start : body.end]
    deep = (under - middle) @ up
    wide = np.linalg.norm((under - middle) - deep[:, None] * up, axis=1)[deep < 0.0]
    assert out.min() > 0.9 * wide.max(), "it hangs outside"
    assert graph.parts[spots.parts["SKIRT"]].stuffing == 0.0 and skirt.end > skirt.start

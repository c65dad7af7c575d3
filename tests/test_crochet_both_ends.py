"""Handles: hands sew a strip on by both its ends, and it arches between them."""

import numpy as np
import pytest

from crochet_sewn import placed
from tambour.core.errors import Text
from tambour.core.progress import Progress
from tambour.crochet.graph.spots import Spots
from tambour.crochet.params import CrochetParams
from tambour.crochet.plush import make
from tambour.crochet.printed.pattern import read_printed

CUP = """CUPS

{0}CUP
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnd 3: (sc, inc) x 6 (18)
Rnd 4: (2 sc, inc) x 6 (24)
Rnds 5-14: sc around (24)
Fasten off.

{0}CUP HANDLE
Ch 17.
Row 1: sc in 2nd ch from hook and in each ch across (16)
Fasten off. {1}
"""
BASKET = """BASKET

BASKET
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnd 3: (sc, inc) x 6 (18)
Rnd 4: (2 sc, inc) x 6 (24)
Rnd 5: (3 sc, inc) x 6 (30)
Rnds 6-12: sc around (30)
Fasten off.

HANDLE
Ch 29.
Row 1: sc in 2nd ch from hook and in each ch across (28)
Row 2: ch 1, turn, sc across (28)
Fasten off.

FINISHING
{0}
"""


@pytest.mark.parametrize(
    "said",
    [
        "Sew one end of the handle near Rounds 12-13 and the opposite end near Rounds 6-7.",
        "Sew one end of handle to Rnd 12 of the cup, the other end to Rnd 6.",
    ],
)
def test_the_other_end_of_a_handle_has_its_round(said: str) -> None:
    made = placed(read_printed(Text(CUP.format("TEA ", said), "cup.txt")))
    (record,) = made.values()
    assert record.to is not None and abs(record.spot.round - 12.25) < 0.6 and abs(record.to.round - 6.25) < 0.6


def test_a_handle_goes_on_the_cup_that_it_is_worked_with() -> None:
    said = "Sew one end of the handle near Rounds 12-13 and the opposite end near Rounds 6-7."
    text = CUP.format("TEA ", said) + CUP.format("EGG ", said.replace("12-13", "11-12")).split("\n\n", 1)[1]
    made = placed(read_printed(Text(text, "cups.txt")))
    assert {n: r.spot.part.split(".")[0] for n, r in made.items()} == {
        "TEA CUP HANDLE": "TEA CUP",
        "EGG CUP HANDLE": "EGG CUP",
    }
    assert made["EGG CUP HANDLE"].spot.round == 11.5


@pytest.mark.parametrize(
    "said",
    [
        "Sew each end of the handle to opposite sides of the basket.",
        "Sew the ends of the handle to each side of the basket.",
        "Sew the handle to the basket.",
    ],
)
def test_the_handle_of_a_basket_arches_over_it(said: str) -> None:
    piece = make(Text(BASKET.format(said), "basket.txt"), CrochetParams(detail="low", tolerance=0.05), Progress())
    built, x = piece.built, piece.positions / piece.built.graph.stitch_width
    spots = Spots(built)
    own, on = (built.graph.parts[spots.parts[name]] for name in ("HANDLE", "BASKET"))
    strip, rim = x[own.start : own.end], x[spots.rim(spots.parts["BASKET"])]
    top = float(x[on.start : on.end, 1].max())
    assert float(strip[:, 1].max()) > top + 4.0
    ends = strip[np.argsort(strip[:, 0])][[0, -1]]
    assert all(float(np.sqrt(((rim - end) ** 2).sum(1)).min()) < 2.5 for end in ends)
    assert float(np.ptp(strip[:, 0])) > 0.8 * float(np.ptp(rim[:, 0]))

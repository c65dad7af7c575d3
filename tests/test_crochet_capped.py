"""Caps: hollow ones come down over a head as far as their fabric reaches and leave its eyes free; others stand where they were put."""

from __future__ import annotations

import numpy as np
import pytest

from tambour.core.errors import Text
from tambour.core.progress import Progress
from tambour.crochet.finish.capped import rim_on
from tambour.crochet.finish.joining import prepare
from tambour.crochet.graph.build import build
from tambour.crochet.params import CrochetParams
from tambour.crochet.plush import make
from tambour.crochet.printed.choose import read

HEAD = (
    "Toy\n\nHEAD\nRnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\nRnd 3: (sc, inc) x 6 (18)\nRnd 4: (2 sc, inc) x 6 (24)\n"
    "Rnd 5-16: sc around (24)\nRnd 17: (2 sc, dec) x 6 (18)\nRnd 18: (sc, dec) x 6 (12)\nRnd 19: dec x 6 (6)\nStuff. Fasten off.\n\n"
)
CAP = "Rnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\nRnd 3: (sc, inc) x 6 (18)\nRnd 4: (2 sc, inc) x 6 (24)\nRnd 5-8: sc around (24)\n"
SEWN = "Fasten off.\n\nASSEMBLY\nSew the wig to the top of the head.\n"


def rim(text: str) -> int:
    """The round of the head that the wig's rim is sewn to; 0 where it stands on the pole's fabric."""
    built = build(read(Text(text, "toy.txt")))
    joining = prepare(built)
    assert joining is not None
    placed, end = next((f, e) for f, e in joining.steps if f.part == "WIG")
    nodes = rim_on(joining.built, joining.spots, placed, end)
    return next((r.number for r in built.rounds if len(nodes) and r.first <= nodes[0] <= r.last), 0)


def test_a_wig_covers_as_many_rounds_as_it_has() -> None:
    assert rim(f"{HEAD}WIG\n{CAP}{SEWN}") in (8, 12)  # eight from its pole: the head's beginning, or its end


def test_a_wig_leaves_eyes_free() -> None:
    assert (
        rim(HEAD.replace("Stuff.", "Insert eyes between rounds 7 and 8, 5 sts apart. Stuff.") + f"WIG\n{CAP}{SEWN}")
        <= 5
    )


@pytest.mark.parametrize(
    "other",
    [
        CAP.replace(
            "Rnd 5-8: sc around (24)\n", "Rnd 5: (sc, inc) x 12 (36)\nRnd 6-8: sc around (36)\n"
        ),  # a brim, or too wide
        "Rnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\nRnd 3-6: sc around (12)\n",  # much narrower
    ],
)
def test_what_is_no_cap_of_this_head_stays_on_top(other: str) -> None:
    assert rim(f"{HEAD}WIG\n{other}{SEWN}") == 0


@pytest.mark.slow
def test_a_cap_s_crown_lies_on_the_head() -> None:
    piece = make(Text(f"{HEAD}WIG\n{CAP}{SEWN}", "toy.txt"), CrochetParams(), Progress())
    parts = {p.name: piece.positions[p.start : p.end] for p in piece.built.graph.parts}
    head, wig = parts["HEAD"], parts["WIG"]
    high = piece.stitch[1]
    assert float(wig[:, 1].max() - head[:, 1].max()) < 2.0 * high  # it stood five stitches above, as a fez does
    assert float(head[:, 1].max() - wig[:, 1].min()) > 3.5 * high
    assert float(np.ptp(head[:, 1])) > 13.5 * high  # and does not press it flat: by itself it is fifteen high


def test_a_sun_hat_is_pushed_back_from_the_eyes() -> None:
    brim = "Rnd 9: inc x 24 (48)\nRnds 10-14: sc around (48)\n"
    said = "Insert safety eyes between rounds 9 and 10, 6 sts apart.\nSew the hat to the top of the head.\n"
    text = f"{HEAD.replace('HEAD', 'HEAD (from the top)')}HAT\n{CAP}{brim}Fasten off.\n\nASSEMBLY\n{said}"
    piece = make(Text(text, "toy.txt"), CrochetParams(tolerance=0.5, detail="low"), Progress())
    assert piece.upright is not None and piece.upright[-1][2] < -0.1 < piece.upright[0][2]

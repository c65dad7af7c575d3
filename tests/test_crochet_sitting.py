"""Toys that sit: their seat is on the table, not over their feet, and arms longer than they are high bear nothing."""

import numpy as np
import pytest

from tambour.core.errors import Text
from tambour.core.progress import Progress
from tambour.crochet.finish.limp import Limb, lain
from tambour.crochet.params import CrochetParams
from tambour.crochet.plush import make

TOY = """DOUG

BODY
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnd 3: (sc, inc) x 6 (18)
Rnd 4: (2 sc, inc) x 6 (24)
Rnd 5: (3 sc, inc) x 6 (30)
Rnds 6-14: sc around (30)
Rnd 15: (3 sc, dec) x 6 (24)
Rnd 16: (2 sc, dec) x 6 (18)
Stuff. Fasten off.

HEAD
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnd 3: (sc, inc) x 6 (18)
Rnd 4: (2 sc, inc) x 6 (24)
Rnds 5-9: sc around (24)
Rnd 10: (2 sc, dec) x 6 (18)
Stuff. Fasten off.

{0}
FINISHING
Sew the head to the body. Attach safety eyes to the head. {1}
"""
FEET = """FOOT (make 2)
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnd 3: (sc, inc) x 6 (18)
Rnds 4-9: sc around (18)
Rnd 10: (sc, dec) x 6 (12)
Stuff. Fasten off.
"""
ARMS = """ARM (make 2)
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnds 3-36: sc around (12)
Stuff. Fasten off.
"""


@pytest.mark.parametrize(
    "limbs, said", [(FEET, "Sew the feet to the body."), (ARMS, "Sew the arms to the body.")], ids=["feet", "arms"]
)
def test_the_seat_of_a_toy_is_on_the_table(limbs: str, said: str) -> None:
    piece = make(Text(TOY.format(limbs, said), "doug.txt"), CrochetParams(detail="low", tolerance=0.05), Progress())
    graph, x = piece.built.graph, piece.positions / piece.built.graph.stitch_width
    body = next(p for p in graph.parts if p.name == "BODY")
    assert float(x[body.start : body.end, 1].min() - x[:, 1].min()) < 0.8


def test_a_stout_leg_falls_until_it_lies_and_rises_only_so_far() -> None:
    seat = np.array([(x, y, z) for x in (-3.0, 3.0) for y in (0.0, 6.0) for z in (-3.0, 3.0)])
    ring = [(1.5 * np.cos(a), 1.5 * np.sin(a)) for a in np.linspace(0.0, 2.0 * np.pi, 12, endpoint=False)]
    leg = np.array([(1.0 + a, 3.0 + b, 3.0 + k) for k in range(9) for a, b in ring])
    x = np.concatenate([seat, leg])
    limb = Limb(np.arange(len(seat), len(x)), np.array([1.0, 3.0, 3.0]), True, sits=True, falls=True)
    laid = lain(x, np.ones(len(x), bool), [limb])
    assert laid[: len(seat)] == pytest.approx(seat)
    assert 0.0 <= float(laid[len(seat) :, 1].min()) < 0.2
    assert (
        float(laid[-12:, 1].mean()) < 2.4 and float(laid[-12:, 2].mean()) > 9.0
    )  # its foot lies low, and is still ahead


NOSE_FIRST = """HIPPO

HEAD
Begin at the nose.
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnd 3: (sc, inc) x 6 (18)
Rnd 4: (2 sc, inc) x 6 (24)
Rnds 5-9: sc around (24)
Rnd 10: (3 sc, inc) x 6 (30)
Rnds 11-15: sc around (30)
Rnd 16: (3 sc, dec) x 6 (24)
Rnd 17: (2 sc, dec) x 6 (18)
Rnd 18: (sc, dec) x 6 (12)
Rnd 19: dec x 6 (6)
Stuff. Fasten off.

BODY
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnd 3: (sc, inc) x 6 (18)
Rnd 4: (2 sc, inc) x 6 (24)
Rnds 5-14: sc around (24)
Rnd 15: (2 sc, dec) x 6 (18)
Stuff. Fasten off, leaving a tail for sewing.

FINISHING
Attach safety eyes between Rnds 9 and 10 of the head, 7 stitches apart. Sew the head to the body.
"""


def test_a_body_hangs_straight_down_from_a_head_that_looks_ahead() -> None:
    """It stood out from its underside where that rounds up to its back, and the toy leaned."""
    piece = make(Text(NOSE_FIRST, "hippo.txt"), CrochetParams(detail="low", tolerance=0.05), Progress())
    graph, x = piece.built.graph, piece.positions
    body, head = (next(p for p in graph.parts if p.name == name) for name in ("BODY", "HEAD"))
    rounds = piece.built.graph.round
    own = np.arange(head.start, head.end)
    ahead = x[own[rounds[own] <= rounds[own].min() + 3]].mean(0) - x[own[rounds[own] >= rounds[own].max() - 3]].mean(0)
    down = x[body.start : body.start + 18].mean(0) - x[body.end - 18 : body.end].mean(0)
    ahead, down = (v / np.sqrt((v**2).sum()) for v in (ahead, down))
    assert abs(float(ahead[1])) < 0.25 and abs(float(ahead @ down)) < 0.1

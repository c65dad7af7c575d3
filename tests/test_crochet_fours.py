"""Toys on their legs: whatever their heads weigh they stand on all four, and two are beside each other below a face."""

import numpy as np
import pytest

from tambour.core.errors import Text
from tambour.core.progress import Progress
from tambour.crochet.graph.build import build
from tambour.crochet.graph.spots import Spots
from tambour.crochet.params import CrochetParams
from tambour.crochet.plush import make
from tambour.crochet.printed.pattern import read_printed

PONY = """PONY

HEAD
Begin at the nose.
Rnd 1: 8 sc in MR (8)
Rnd 2: inc x 8 (16)
Rnd 3: (sc, inc) x 8 (24)
Rnds 4-16: sc around (24)
Rnd 17: (sc, dec) x 8 (16)
Rnd 18: dec x 8 (8)
Fasten off and close.

NECK
Begin at the top of the neck.
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnds 3-12: sc around (12)
Fasten off. Sew the beginning of the neck flat against the back of the head.

BODY
Begin at the neck.
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnd 3: (sc, inc) x 6 (18)
Rnds 4-14: sc around (18)
Rnd 15: (sc, dec) x 6 (12)
Rnd 16: dec x 6 (6)
Fasten off and close. Sew the head and neck piece to the front top of the body.

HIND LEG (make 2)
Rnd 1: 6 sc in MR (6)
Rnds 2-10: sc around (6)
Fasten off. Sew them to the underside of the body between Rnds 12 and 14.

FRONT LEG (make 2)
Rnd 1: 6 sc in MR (6)
Rnds 2-8: sc around (6)
Fasten off. Sew them to the underside of the body between Rnds 6 and 8.

FINISHING
Embroider two eyes to the head between Rnds 10 and 11.
"""
"""A pony with a large head before a small body, and hind legs that are longer."""


def test_a_heavy_head_does_not_bring_a_toy_off_its_feet() -> None:
    piece = make(Text(PONY, "pony.txt"), CrochetParams(detail="low", tolerance=0.05), Progress())
    graph, x = piece.built.graph, piece.positions / piece.built.graph.stitch_width
    feet = [float(x[p.start : p.end, 1].min()) for p in graph.parts if "LEG" in p.name]
    assert len(feet) == 4
    assert max(feet) - float(x[:, 1].min()) < 1.5
    body = next(p for p in graph.parts if p.name == "BODY")
    along = x[body.end - 8 : body.end].mean(0) - x[body.start : body.start + 8].mean(0)
    assert abs(float(along[1])) < 0.6 * float(np.sqrt((along**2).sum()))


HARE = """HARE

Head and Body:
With A, ch 2.
1st rnd: 6 sc in 2nd ch from hook. Join. 6 sc.
2nd rnd: Ch 1. 2 sc in each sc around. Join. 12 sc.
3rd rnd: Ch 1. *1 sc in next sc. 2 sc in next sc. Rep from * around. Join. 18 sc.
4th rnd: Ch 1. *1 sc in each of next 2 sc. 2 sc in next sc. Rep from * around. Join. 24 sc.
5th to 16th rnds: Ch 1. 1 sc in each sc around. Join. Do not fasten off.
Separate for Legs:
Right Leg: Next rnd: Ch 1. 1 sc in each of first 2 sc. Ch 2. Skip next 12 sc. 1 sc in each of last 10 sc. Join. 14 sts.
Next rnd: Ch 1. 1 sc in each of first 2 sc. 1 sc in each of next 2 ch. 1 sc in each sc to end of rnd. Join.
**Next rnd: Ch 1. (Sc2tog) 7 times. Join. 7 sc.
Fasten off.**
Left Leg: Join A with sl st to first skipped sc of {0}.
1st rnd: Ch 1. 1 sc in same sc as sl st. 1 sc in each of next 11 sc. Ch 2. Join with sl st to first sc.
2nd rnd: Ch 1. 1 sc in each of next 12 sc. 1 sc in each of next 2 ch. Join.
Rep from ** to ** as given for Right Leg.

FINISHING
Embroider two eyes on the head. Stuff.
"""


@pytest.mark.parametrize("named", ["17th rnd", "18th rnd", "Rnd 18"])
def test_a_leg_goes_on_from_the_round_that_left_its_stitches(named: str) -> None:
    built = build(read_printed(Text(HARE.format(named), "hare.txt")))
    spots = Spots(built)
    shared = next(k for k, r in enumerate(built.rounds) if r.number == 16)
    on = np.isin(spots.stitches(shared), [*built.graph.anchors.tolist(), *built.sewn.ravel().tolist()])
    assert on.all()


def test_legs_that_a_round_is_shared_out_between_are_at_the_sides_of_a_face() -> None:
    built = build(read_printed(Text(HARE.format("18th rnd"), "hare.txt")))
    spots = Spots(built)
    shared = spots.stitches(next(k for k, r in enumerate(built.rounds) if r.number == 16))
    left = spots.layout[shared[2:14]].mean(0) - spots.layout[shared].mean(0)
    assert abs(float(left[0])) > 4.0 * abs(float(left[2]))

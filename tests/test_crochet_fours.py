"""Toys on four legs: whatever their heads weigh, they stand on all four."""

import numpy as np

from tambour.core.errors import Text
from tambour.core.progress import Progress
from tambour.crochet.params import CrochetParams
from tambour.crochet.plush import make

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

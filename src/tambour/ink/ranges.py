"""Distant ranges: flat soft-mottled silhouettes."""

from __future__ import annotations

import math

import numpy as np

from tambour.core.check import Array
from tambour.core.kernels import kernel
from tambour.ink.brush import OPEN, PI, part, rnd
from tambour.ink.bushes import shatter
from tambour.ink.codes import RANGE
from tambour.noise import value

SPAN = 10.0


@kernel
def distant(
    table: Array, rng: Array, pts: Array, marks: Array, elems: Array, n: Array,
    x: float, y: float, height: float, length: float,
) -> None:  # fmt: skip
    """A range from (x, y) to the right, ``length`` long, in strips ten units wide (dossier 1.8, 2.4).

    The original's strips are five times as wide, their fans of slivers visible; the count of triangles is the same.
    """
    before = part(elems, n, RANGE, x, y)
    seed = math.floor(4096.0 * rnd(rng))
    phase = math.floor(4096.0 * rnd(rng))
    quad = np.empty((4, 2))
    total = length / SPAN
    for i in range(int(total)):
        for c in range(4):
            k = i + (1.0 if c == 1 or c == 2 else 0.0)
            arch = max(0.0, math.sin(PI * k / total))
            quad[c, 0] = x + k * SPAN
            if c < 2:
                quad[c, 1] = y - height * value(table, 0.05 * k, seed, 0.0) * math.sqrt(arch)
            else:
                quad[c, 1] = y + 24.0 * value(table, 0.05 * k, 2.0, seed) * arch
        shatter(table, pts, marks, n, quad, 100.0, 0.012, phase, 200.0, 55.0, 1.0, 1.0)
    n[OPEN] = before

"""Still water: a few fine wavy lines."""

from __future__ import annotations

import math

from tambour.core.check import Array
from tambour.core.kernels import kernel
from tambour.ink.brush import OPEN, SINE, at, between, part, rnd, stroke
from tambour.ink.codes import WATER
from tambour.noise import value


@kernel
def water(
    table: Array, rng: Array, pts: Array, marks: Array, elems: Array, n: Array,
    x: float, y: float, height: float, length: float, lines: int,
) -> None:  # fmt: skip
    """``lines`` lines about (x, y), each up to ``length`` to either side, ``height`` how high they wave (1.11)."""
    before = part(elems, n, WATER, x, y)
    level = 0.0
    for _ in range(lines):
        half = length * between(rng, 0.5, 1.0)
        level += between(rng, 1.0, 6.0)
        phase = 4096.0 * rnd(rng)
        count = int(2.0 * half / 5.0)
        for j in range(count):
            wave = math.sin(0.2 * j) * height * value(table, 0.1 * j, phase, 0.0)
            at(pts, n, x - half + 5.0 * j, y + wave - 20.0 + level)
        stroke(rng, marks, n, 100.0, between(rng, 0.25, 0.55), 0.9, 0.5, SINE, 1.0)
    n[OPEN] = before

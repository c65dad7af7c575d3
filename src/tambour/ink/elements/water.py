"""Still water: a few fine wavy lines."""

from __future__ import annotations

import math

from tambour.core.kernels import kernel
from tambour.ink.brush.stroke import OPEN, SINE, Brush, at, between, part, rnd, stroke
from tambour.ink.ground.codes import WATER
from tambour.noise import value

STEP = 5.0


@kernel
def water(brush: Brush, x: float, y: float, height: float, length: float, lines: int) -> None:
    """``lines`` lines about (x, y), each up to ``length`` to either side, ``height`` how high they wave (1.11).

    Short lines are commoner than long ones, and levels come in bunches: water is close-lined at the shore and thins out.
    """
    before = part(brush, WATER, x, y)
    level = 0.0
    for _ in range(lines):
        u, v = rnd(brush.rng), rnd(brush.rng)
        half = length * (0.6 + 0.4 * u * math.sqrt(u))
        middle = x + 0.3 * (length - half) * between(brush.rng, -1.0, 1.0)
        level += 1.0 + 5.0 * v * v
        phase = 4096.0 * rnd(brush.rng)
        count = int(2.0 * half / STEP)
        for j in range(count):
            a = STEP * j - half
            ripple = math.sin(0.2 * a) * height * value(brush.table, 0.1 * a, phase, 0.0)
            swell = height * (value(brush.table, 0.012 * a, phase + 0.5, 0.0) - 0.47)
            at(brush, middle + a, y + ripple + swell - 20.0 + level)
        stroke(brush, 100.0, between(brush.rng, 0.3, 0.6), 1.0, 0.5, SINE, 0.7)
    brush.n[OPEN] = before

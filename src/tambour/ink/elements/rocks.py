"""Rocks: a squashed bowl of contours, faintly wrinkled."""

from __future__ import annotations

import math

import numpy as np

from tambour.core.kernels import kernel
from tambour.ink.brush.stroke import EVEN, OPEN, PI, Brush, at, part, rnd, stroke
from tambour.ink.elements.cun import SIDES, slope, wrinkles
from tambour.ink.ground.codes import ROCK
from tambour.noise import close, value

LAYERS, COLUMNS = 10, 50


@kernel
def rock(brush: Brush, x: float, y: float, height: float, width: float, wrinkled: int, shade: float) -> None:
    """A rock about (x, y): ``width`` to either side, ``height`` above, a fifth of it below (dossier 1.8)."""
    before = part(brush, ROCK, x, y)
    seed = 4096.0 * rnd(brush.rng)
    grid = np.empty((LAYERS, COLUMNS, 2))
    ring = np.empty(COLUMNS)
    for i in range(LAYERS):
        for j in range(COLUMNS):
            ring[j] = value(brush.table, i + 0.0, 0.2 * j + seed, 0.0)
        close(ring)
        for j in range(COLUMNS):
            angle = 2.0 * PI * j / COLUMNS - 0.5 * PI
            a, b = math.cos(angle), math.sin(angle)
            reach = width * height / math.sqrt((height * a) ** 2 + (width * b) ** 2)
            reach *= (0.7 + 0.3 * ring[j]) * (1.0 - i / LAYERS)
            up = reach * b
            grid[i, j, 0] = reach * a
            grid[i, j, 1] = -up * (0.2 if up < 0.0 else 1.0) + 0.2 * height * i / LAYERS
    slope(brush, grid, x, y, 0.0)
    for j in range(COLUMNS):
        at(brush, grid[0, j, 0] + x, grid[0, j, 1] + y)
    stroke(brush, 100.0, 0.25, 0.8, 0.8, EVEN, 0.8)
    wrinkles(brush, brush.table, grid, x, y, wrinkled, 3.0, 0.2, SIDES, 125.0, 0.38, shade, 30.0)
    brush.n[OPEN] = before

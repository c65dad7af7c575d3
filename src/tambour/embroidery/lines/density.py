"""Density: how much thread lies where."""

from __future__ import annotations

import math

import numpy as np

from tambour.core.arrays import F8x1, F8x2
from tambour.core.check import Array
from tambour.core.kernels import kernel

CELL = 2.0  # mm, the side of a density cell


@kernel
def deposit(xy: F8x2, weight: F8x1, x0: float, y0: float, cell: float, grid: F8x2) -> None:
    """Add the length of each stitch (xy (S, 4): from, to) to the cells that it crosses, cut exactly at their borders."""
    rows, columns = grid.shape
    for i in range(len(xy)):
        if weight[i] == 0:
            continue
        ax, ay, bx, by = (xy[i, 0] - x0) / cell, (xy[i, 1] - y0) / cell, (xy[i, 2] - x0) / cell, (xy[i, 3] - y0) / cell
        span = math.hypot(bx - ax, by - ay) * cell * weight[i]
        t = 0.0
        while t < 1.0:
            # The next border along the stitch.
            x, y = ax + t * (bx - ax), ay + t * (by - ay)
            step = 1.0 - t
            if bx != ax:
                edge = math.floor(x + 1e-12) + 1 if bx > ax else math.ceil(x - 1e-12) - 1
                step = min(step, (edge - x) / (bx - ax))
            if by != ay:
                edge = math.floor(y + 1e-12) + 1 if by > ay else math.ceil(y - 1e-12) - 1
                step = min(step, (edge - y) / (by - ay))
            step = max(step, 1e-9)
            c, r = math.floor(x + 0.5 * step * (bx - ax)), math.floor(y + 0.5 * step * (by - ay))
            if 0 <= r < rows and 0 <= c < columns:
                grid[r, c] += span * min(step, 1.0 - t)
            t += step


def density_map(xy: Array, weight: Array, bounds: tuple[float, float, float, float], cell: float = CELL) -> Array:
    """Thread per area, mm/mm² (rows, columns), in cells from (left, top); xy (S, 4) stitches, weight (S,)."""
    x0, y0, x1, y1 = bounds
    grid = np.zeros((max(1, math.ceil((y1 - y0) / cell)), max(1, math.ceil((x1 - x0) / cell))))
    deposit(np.ascontiguousarray(xy), np.ascontiguousarray(weight, np.float64), x0, y0, cell, grid)
    return grid / cell**2

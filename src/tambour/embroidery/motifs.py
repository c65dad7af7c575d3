"""Motifs: figures that are repeated along a line."""

from __future__ import annotations

import math

import numpy as np

from tambour.core.check import Array

# Figures in a cell 1 long, 1 wide (v from -0.5 to 0.5), from (0, 0) to (1, 0); each is drawn without lifting the needle.
MOTIFS: dict[str, list[tuple[float, float]]] = {
    "zigzag": [(0, 0), (0.25, 0.35), (0.75, -0.35), (1, 0)],
    "wave": [(x / 8, 0.3 * math.sin(2 * math.pi * x / 8)) for x in range(9)],
    "diamond": [(0, 0), (0.5, 0.35), (1, 0), (0.5, -0.35), (0, 0), (0.5, 0.35), (1, 0)],
    "cross": [(0, 0), (0.25, 0), (0.75, 0.3), (0.5, 0), (0.75, -0.3), (0.25, 0.3), (0.5, 0), (0.25, -0.3), (0.5, 0), (1, 0)],
    "e": [(0, 0), (1, 0), (1, 0.5), (1, 0)],
    "leaf": [(0, 0), (0.3, 0), (0.45, 0.3), (0.75, 0.35), (0.6, 0.1), (0.3, 0), (0.5, -0.15), (0.8, -0.35), (0.5, -0.3), (0.3, 0), (1, 0)],
    "star": [(0, 0), (0.5, 0), *(p for k in range(8) for p in ((0.5 + 0.3 * math.cos(k * math.pi / 4), 0.3 * math.sin(k * math.pi / 4)), (0.5, 0))), (1, 0)],
}  # fmt: skip


def figures(line: Array, name: str, size_mm: float) -> Array:
    """Where the needle turns, (N, 2), for a figure of ``size_mm`` repeated along a line a whole number of times.

    Its middle line is bent along with the line.
    """
    way = np.r_[0, np.cumsum(np.hypot(*np.diff(line, axis=0).T))]
    count = max(1, round(way[-1] / size_mm))
    size = way[-1] / count
    figure = np.array(MOTIFS[name])
    u = (figure[:, 0] + np.arange(count)[:, None]) * size
    v = np.broadcast_to(figure[:, 1] * size_mm, u.shape)
    u, v = u.reshape(-1), v.reshape(-1)
    keep = np.r_[True, (np.diff(u) != 0) | (np.diff(v) != 0)]
    u, v = u[keep], v[keep]
    x, y = np.interp(u, way, line[:, 0]), np.interp(u, way, line[:, 1])
    d = 0.25 * size
    ahead, behind = np.minimum(u + d, way[-1]), np.maximum(u - d, 0)
    tx = np.interp(ahead, way, line[:, 0]) - np.interp(behind, way, line[:, 0])
    ty = np.interp(ahead, way, line[:, 1]) - np.interp(behind, way, line[:, 1])
    t = np.maximum(np.hypot(tx, ty), 1e-9)
    return np.c_[x + v * ty / t, y - v * tx / t]

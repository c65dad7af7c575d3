"""Lines: running stitch, bean stitch, and motifs repeated along a line."""

from __future__ import annotations

import math

import numpy as np

from tambour.core.check import Array
from tambour.embroidery.params import EmbroideryParams
from tambour.embroidery.piece import RUNNING
from tambour.embroidery.stitches import Stitches, line_stitches, walk

LONGEST = 12.0  # mm of a stitch that is laid by hand
TOLERANCE = 0.1  # mm that a running stitch may cut a bend

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


def running(line: Array, params: EmbroideryParams) -> Stitches:
    """Running stitch: even stitches of at most ``length``, shorter round bends."""
    return line_stitches(line, params.length, RUNNING, TOLERANCE)


def bean(line: Array, params: EmbroideryParams) -> Stitches:
    """Bean stitch: every stitch sewn an odd number of times, forward and back, for a bold line."""
    xy = walk(np.ascontiguousarray(line, np.float64), params.length, TOLERANCE)
    times = params.repeats | 1
    a, b = xy[:-1], xy[1:]
    there = np.stack([b if k % 2 == 0 else a for k in range(times)], 1).reshape(-1, 2)
    return Stitches.of(np.concatenate([xy[:1], there]), RUNNING)


def manual(line: Array, params: EmbroideryParams) -> Stitches:
    """A stitch from each corner of the line to the next, as a hand laid them; longer ones than a machine makes are parted."""
    size = np.hypot(*np.diff(line, axis=0).T)
    parts = np.maximum(1, np.ceil(size / LONGEST - 1e-9).astype(int))
    at = np.concatenate([np.arange(n) / n + k for k, n in enumerate(parts)] + [[len(size)]])
    place = np.arange(len(line))
    return Stitches.of(np.c_[np.interp(at, place, line[:, 0]), np.interp(at, place, line[:, 1])], RUNNING)


def motif(line: Array, params: EmbroideryParams) -> Stitches:
    """A figure repeated along a line: a whole number of times, its middle line bent along."""
    way = np.r_[0, np.cumsum(np.hypot(*np.diff(line, axis=0).T))]
    count = max(1, round(way[-1] / params.motif_size))
    size = way[-1] / count
    figure = np.array(MOTIFS[params.motif])
    u = (figure[:, 0] + np.arange(count)[:, None]) * size
    v = np.broadcast_to(figure[:, 1] * params.motif_size, u.shape)
    u, v = u.reshape(-1), v.reshape(-1)
    keep = np.r_[True, (np.diff(u) != 0) | (np.diff(v) != 0)]
    u, v = u[keep], v[keep]
    x, y = np.interp(u, way, line[:, 0]), np.interp(u, way, line[:, 1])
    d = 0.25 * size
    ahead, behind = np.minimum(u + d, way[-1]), np.maximum(u - d, 0)
    tx = np.interp(ahead, way, line[:, 0]) - np.interp(behind, way, line[:, 0])
    ty = np.interp(ahead, way, line[:, 1]) - np.interp(behind, way, line[:, 1])
    t = np.maximum(np.hypot(tx, ty), 1e-9)
    xy = np.c_[x + v * ty / t, y - v * tx / t]
    return line_stitches(xy, params.length, RUNNING, 0.0)


def from_nearest(line: Array, start: tuple[float, float] | None) -> Array:
    """The line begun at the end that is nearer to ``start``; a closed one at its nearest vertex."""
    if start is None:
        return line
    here = np.array(start)
    if (line[0] == line[-1]).all() and len(line) > 3:
        k = int(np.argmin(((line - here) ** 2).sum(1)))
        return np.concatenate([line[k:-1], line[: k + 1]]) if k else line
    return line[::-1] if np.hypot(*(line[-1] - here)) < np.hypot(*(line[0] - here)) else line

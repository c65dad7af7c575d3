"""Lines: running stitch, bean stitch, and motifs repeated along a line."""

from __future__ import annotations

import numpy as np

from tambour.core.check import Array
from tambour.embroidery.motifs import figures
from tambour.embroidery.params import EmbroideryParams
from tambour.embroidery.piece import RUNNING
from tambour.embroidery.stitches import Stitches, line_stitches, walk

LONGEST = 12.0  # mm of a stitch that is laid by hand
TOLERANCE = 0.1  # mm that a running stitch may cut a bend


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
    return line_stitches(figures(line, params.motif, params.motif_size), params.length, RUNNING, 0.0)


def from_nearest(line: Array, start: tuple[float, float] | None) -> Array:
    """The line begun at the end that is nearer to ``start``; a closed one at its nearest vertex."""
    if start is None:
        return line
    here = np.array(start)
    if (line[0] == line[-1]).all() and len(line) > 3:
        k = int(np.argmin(((line - here) ** 2).sum(1)))
        return np.concatenate([line[k:-1], line[: k + 1]]) if k else line
    return line[::-1] if np.hypot(*(line[-1] - here)) < np.hypot(*(line[0] - here)) else line

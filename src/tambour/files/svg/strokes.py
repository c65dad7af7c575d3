"""Strokes: lines cut by their dashes."""

from __future__ import annotations

import numpy as np

from tambour.core.check import Array

MOST = 20_000
"""Dashes of one shape."""


def dashed(lines: list[tuple[Array, bool]], pattern: list[float], begin: float) -> list[tuple[Array, bool]]:
    """The dashes of lines (points (n, 2), closed), all open.

    pattern : lengths of dash, gap, dash, …; an odd number of them counts twice; begin : how far into it a line begins.
    Raises ValueError for more than 20,000 dashes.
    """
    if len(pattern) % 2:
        pattern = pattern * 2
    ends = np.cumsum(pattern)
    whole = float(ends[-1])
    made: list[tuple[Array, bool]] = []
    for points, closed in lines:
        line = np.concatenate([points, points[:1]]) if closed else points
        at = np.r_[0.0, np.cumsum(np.hypot(*np.diff(line, axis=0).T))]
        if at[-1] / whole * (len(pattern) / 2) + len(made) > MOST:
            raise ValueError(f"its strokes have more than {MOST:,} dashes")
        turns = np.arange(np.floor(begin / whole) - 1, np.ceil((at[-1] + begin) / whole) + 1)
        starts = (turns[:, None] * whole + np.r_[0.0, ends[1:-1:2]] - begin).ravel()
        stops = (turns[:, None] * whole + ends[0::2] - begin).ravel()
        keep = (stops >= 0) & (starts <= at[-1])
        cuts = np.c_[np.maximum(starts[keep], 0.0), np.minimum(stops[keep], at[-1])]
        found = [_between(line, at, a, b) for a, b in cuts.tolist()]
        if closed and len(found) > 1 and cuts[0, 0] <= 0 and cuts[-1, 1] >= at[-1]:
            found = [np.concatenate([found[-1], found[0][1:]]), *found[1:-1]]  # a dash that goes on past the beginning
        made += [(dash, False) for dash in found if len(dash) > 1]
    return made


def _between(line: Array, at: Array, a: float, b: float) -> Array:
    """The stretch of a line between two distances along it; of no length, a point there twice, hardly apart."""
    b = max(b, a + 1e-6 * max(1.0, float(at[-1])))
    inner = line[(at > a) & (at < b)]
    ends = np.array([[np.interp(s, at, line[:, k]) for k in (0, 1)] for s in (a, b)])
    return np.concatenate([ends[:1], inner, ends[1:]])

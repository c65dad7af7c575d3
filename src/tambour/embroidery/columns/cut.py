"""Cut: a limb that ends in one straight edge, square or aslant, is sewn flush with it: its last stitches turn into the edge."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from tambour.core.check import Array
from tambour.embroidery.columns.satin import STEP, Column, resample

CORNER = math.radians(35)
"""An outline that turns by more has a corner there."""
GRAIN = 0.05
"""mm that an outline may be off when its corners are sought."""
ASLANT = math.radians(60)
"""An edge that lies farther from square is a side, not an end."""
ZONE = 2.4
"""Half widths before an end in which stitches turn into it."""
STRAIGHT = 0.985
"""Share of the way between its corners that an end's edge must have at least as the crow flies."""


def flush(column: Column, area: Any, half: float) -> Column:
    """The column, its end turned into the straight edge of a shapely polygon in which it ends; itself where there is none."""
    import shapely

    ring = area.exterior
    end = shapely.Point(column.middle[-1])
    if ring.distance(end) > 0.5 * half:
        return column
    size = float(ring.length)
    corners = _corners(ring)
    if len(corners) < 2:
        return column
    at = float(ring.project(end))
    ahead, behind = ((corners - at) % size).min(), ((at - corners) % size).min()
    if ahead + behind > 5 * half or min(ahead, behind) > 2 * half:
        return column
    one, two = (np.array(ring.interpolate((at + d) % size).coords[0]) for d in (ahead, -behind))
    edge = two - one
    if float(np.hypot(*edge)) < STRAIGHT * (ahead + behind) or float(np.hypot(*edge)) < 1.2 * half:
        return column
    way = np.r_[0, np.cumsum(np.hypot(*np.diff(column.middle, axis=0).T))]
    first = int(np.searchsorted(way, way[-1] - ZONE * half))
    heading = (
        column.middle[-1]
        - column.middle[max(0, len(way) - 1 - max(2, round(half / max(1e-9, float(way[-1])) * len(way))))]
    )
    across = abs(heading[0] * edge[1] - heading[1] * edge[0]) / max(1e-9, float(np.hypot(*heading) * np.hypot(*edge)))
    if first < 1 or across < math.cos(ASLANT):
        return column
    # The left corner is the one on the left side's way.
    normal = np.array([-heading[1], heading[0]])
    left, right = (one, two) if (one - two) @ normal * _side(column) > 0 else (two, one)
    rails = [_along(ring, side[first], corner, half) for side, corner in ((column.left, left), (column.right, right))]
    if any(r is None for r in rails):
        return column
    n = max(4, math.ceil(max(float(np.hypot(*np.diff(r, axis=0).T).sum()) for r in rails if r is not None) / STEP))
    a, b = (resample(r, n + 1)[1:] for r in rails if r is not None)
    return Column(np.concatenate([column.left[: first + 1], a]), np.concatenate([column.right[: first + 1], b]))


def _side(column: Column) -> float:
    """1 where ``left`` lies to the left of the way (y down: its normal turned), else -1."""
    k = len(column.left) // 2
    d = column.middle[min(k + 1, len(column.left) - 1)] - column.middle[k - 1]
    over = column.left[k] - column.right[k]
    return 1.0 if -d[1] * over[0] + d[0] * over[1] > 0 else -1.0


def _corners(ring: Any) -> Array:
    """How far along a ring its corners lie, mm."""
    import shapely

    at = shapely.get_coordinates(ring.simplify(GRAIN))[:-1]
    before, after = at - np.roll(at, 1, axis=0), np.roll(at, -1, axis=0) - at
    turn = np.arctan2(before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0], (before * after).sum(1))
    spots = at[np.abs(turn) > CORNER]
    return np.sort(np.asarray(shapely.line_locate_point(ring, shapely.points(spots)), np.float64))


def _along(ring: Any, start: Array, to: Array, half: float) -> Array | None:
    """The ring from one place of it to another, the shorter way round; None where the first does not lie on it, or the way is far
    longer than the limb is wide."""
    import shapely
    from shapely.ops import substring

    size = float(ring.length)
    a, b = float(ring.project(shapely.Point(start))), float(ring.project(shapely.Point(to)))
    if ring.distance(shapely.Point(start)) > 0.1 or min((b - a) % size, (a - b) % size) > 3 * ZONE * half:
        return None
    forward = (b - a) % size <= (a - b) % size
    low, high = (a, b) if forward else (b, a)
    line = substring(ring, low, high) if low <= high else None
    made = (
        shapely.get_coordinates(line)
        if line is not None
        else np.concatenate(
            [shapely.get_coordinates(substring(ring, low, size)), shapely.get_coordinates(substring(ring, 0, high))]
        )
    )
    return made if forward else made[::-1]

"""Rails: a plain limb's two sides are its outline's, from tip to tip, so that no stitch ends short of a bend or beyond it."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from tambour.core.check import Array
from tambour.embroidery.columns.satin import STEP, Column

SMOOTH = 0.8
"""Half widths over which the places that face each other are evened out."""
TRUE = 0.01
"""Share of an area that its rails may miss; else chords are better."""


def outlined(column: Column, area: Any, half: float) -> Column:
    """The column of a shapely polygon that is one limb, its sides on the polygon's outline; itself where that goes wrong."""
    import shapely

    ring = shapely.get_coordinates(area.exterior)[:-1]
    sides = [_side(ring, rail) for rail in (column.left, column.right)]
    if sides[0] is None or sides[1] is None:
        return column
    n = len(column.left)
    reach = max(1, min(n // 4, round(SMOOTH * half / max(1e-9, _size(column.middle)) * n)))
    facing = [_facing(side, rail, reach) for side, rail in zip(sides, (column.left, column.right)) if side is not None]
    count = math.ceil(max(_size(s) for s in sides if s is not None) / STEP) + n
    u = np.linspace(0, n - 1, count)
    made = []
    for side, places in zip(sides, facing):
        assert side is not None
        way = np.r_[0, np.cumsum(np.hypot(*np.diff(side, axis=0).T))]
        at = np.interp(u, np.arange(n), places)
        made.append(np.c_[np.interp(at, way, side[:, 0]), np.interp(at, way, side[:, 1])])
    rim = shapely.Polygon(np.concatenate([made[0], made[1][::-1]]))
    if not rim.is_valid or rim.symmetric_difference(area).area > TRUE * area.area + 0.05:
        return column
    chords = shapely.linestrings(np.stack(made, 1)[:: max(1, count // 60)])
    inside = shapely.length(shapely.intersection(chords, area.buffer(0.05)))
    if (shapely.length(chords) - inside).max() > 0.1 * half:
        return column
    return Column(made[0], made[1])


def _side(ring: Array, rail: Array) -> Array | None:
    """The part of a ring along a rail, from where the rail begins to where it ends; None where both are one place."""
    import shapely
    from shapely.ops import substring

    whole = shapely.LinearRing(ring)
    size = float(whole.length)
    a, b, mid = (float(whole.project(shapely.Point(rail[k]))) for k in (0, -1, len(rail) // 2))
    if min((b - a) % size, (a - b) % size) < 1e-6:
        return None
    forward = (mid - a) % size < (b - a) % size
    low, high = (a, b) if forward else (b, a)
    pieces = [(low, high)] if low < high else [(low, size), (0.0, high)]
    made = np.concatenate([shapely.get_coordinates(substring(whole, *p)) for p in pieces if p[1] - p[0] > 1e-9])
    keep = np.r_[True, np.hypot(*np.diff(made, axis=0).T) > 1e-9]
    made = made[keep]
    return made if forward else made[::-1]


def _facing(side: Array, rail: Array, reach: int) -> Array:
    """How far along a side (mm) each place of a rail lies, rising from its start to its end, evened out."""
    import shapely

    line = shapely.LineString(side)
    at = np.maximum.accumulate(np.asarray(shapely.line_locate_point(line, shapely.points(rail)), np.float64))
    at[0], at[-1] = 0.0, line.length
    window = np.hanning(2 * reach + 3)[1:-1]
    padded = np.concatenate([2 * at[0] - at[reach:0:-1], at, 2 * at[-1] - at[-2 : -reach - 2 : -1]])
    even = np.convolve(padded, window / window.sum(), "valid")
    return np.clip(np.maximum.accumulate(even), 0.0, line.length)


def _size(line: Array) -> float:
    return float(np.hypot(*np.diff(line, axis=0).T).sum())

"""Rows of a fill: where parallel lines cross an area (seed 004, section 3 and 4, with its limit to convex shapes lifted).

Coordinates of a row frame: u runs along the stitches, v across them. An angle is counter-clockwise as seen, in
drawings whose y points down, so the stitching direction is (cos a, -sin a).
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from tambour.core.arrays import F8x1, F8x2, I1x1, I8x1
from tambour.core.check import Array
from tambour.core.kernels import kernel
from tambour.core.paths import Paths


def to_rows(xy: Array, angle: float) -> Array:
    """(n, 2) drawing coordinates → (u, v); ``angle`` in radians."""
    c, s = math.cos(angle), math.sin(angle)
    return np.ascontiguousarray(xy @ np.array([[c, s], [-s, c]]))


def from_rows(uv: Array, angle: float) -> Array:
    """(u, v) → drawing coordinates; the inverse of :func:`to_rows`."""
    c, s = math.cos(angle), math.sin(angle)
    return np.ascontiguousarray(uv @ np.array([[c, -s], [s, c]]))


@dataclass(frozen=True, eq=False, slots=True)
class Rings:
    """Closed rings as kernels want them.

    points : (V, 2), the repeated last point left out; ring k is ``points[offsets[k]:offsets[k + 1]]``
    at : (V,) way along the outline up to each vertex, running on from ring to ring
    offsets : (K + 1,) int64
    base : (K + 1,) way at each ring's start; ``base[k + 1] - base[k]`` is its perimeter
    """

    points: Array
    at: Array
    offsets: Array
    base: Array


def rings(paths: Paths, angle: float = 0.0) -> Rings:
    """The rings of ``paths`` in the row frame of ``angle`` (radians); rings of fewer than three points are left out."""
    coords = to_rows(paths.coords, angle) if angle else np.ascontiguousarray(paths.coords)
    points, offsets, at, base = _rings(coords, paths.offsets)
    return Rings(points, at, offsets, base)


def polygon_of(area: Rings) -> Any:
    """The shapely polygon of one outline and its holes."""
    import shapely

    cut = [area.points[a:b] for a, b in zip(area.offsets[:-1], area.offsets[1:])]
    return shapely.Polygon(cut[0], cut[1:]).buffer(0)


@kernel
def _rings(coords: F8x2, ends: I8x1) -> tuple[F8x2, I8x1, F8x1, F8x1]:
    points = np.empty_like(coords)
    at = np.empty(len(coords))
    offsets = np.zeros(len(ends), np.int64)
    base = np.zeros(len(ends))
    n = 0
    k = 0
    way = 0.0
    for r in range(len(ends) - 1):
        lo, hi = ends[r], ends[r + 1]
        if hi - lo > 1 and coords[lo, 0] == coords[hi - 1, 0] and coords[lo, 1] == coords[hi - 1, 1]:
            hi -= 1
        if hi - lo < 3:
            continue
        for i in range(lo, hi):
            points[n] = coords[i]
            at[n] = way
            j = i + 1 if i + 1 < hi else lo
            way += math.hypot(coords[j, 0] - coords[i, 0], coords[j, 1] - coords[i, 1])
            n += 1
        k += 1
        offsets[k] = n
        base[k] = way
    return points[:n].copy(), offsets[: k + 1].copy(), at[:n].copy(), base[: k + 1].copy()


@kernel
def crossings(points: F8x2, offsets: I8x1, levels: F8x1) -> tuple[I8x1, F8x1, I8x1, I1x1]:
    """Where rings cross the lines v = level: (row offsets (R + 1,), u, vertex that the edge starts at, ±1 per crossing).

    points (V, 2), offsets (K + 1,) as in Rings; levels (R,) rising. Sorted by u in each row. Each edge takes the
    levels in [lower end, upper end): a vertex shared by two edges counts once, a horizontal edge never, so that no row
    has an odd count. Two passes of a counting sort, then an insertion sort per row.
    """
    rows = len(levels)
    count = np.zeros(rows + 1, np.int64)
    first = np.empty(len(points), np.int64)
    last = np.empty(len(points), np.int64)
    for k in range(len(offsets) - 1):
        for a in range(offsets[k], offsets[k + 1]):
            b = a + 1 if a + 1 < offsets[k + 1] else offsets[k]
            low, high = min(points[a, 1], points[b, 1]), max(points[a, 1], points[b, 1])
            i = np.searchsorted(levels, low)
            j = i
            while j < rows and levels[j] < high:
                count[j + 1] += 1
                j += 1
            first[a], last[a] = i, j
    starts = np.cumsum(count)
    place = starts[:-1].copy()
    u = np.empty(starts[-1])
    edge = np.empty(starts[-1], np.int64)
    sign = np.empty(starts[-1], np.int8)
    for k in range(len(offsets) - 1):
        for a in range(offsets[k], offsets[k + 1]):
            b = a + 1 if a + 1 < offsets[k + 1] else offsets[k]
            ua, va, ub, vb = points[a, 0], points[a, 1], points[b, 0], points[b, 1]
            for j in range(first[a], last[a]):
                q = place[j]
                u[q] = ua + (levels[j] - va) * ((ub - ua) / (vb - va))
                edge[q] = a
                sign[q] = 1 if vb > va else -1
                place[j] += 1
    for j in range(rows):
        for i in range(starts[j] + 1, starts[j + 1]):
            x, e, s = u[i], edge[i], sign[i]
            p = i - 1
            while p >= starts[j] and u[p] > x:
                u[p + 1], edge[p + 1], sign[p + 1] = u[p], edge[p], sign[p]
                p -= 1
            u[p + 1], edge[p + 1], sign[p + 1] = x, e, s
    return starts, u, edge, sign


@kernel
def inside_pairs(starts: I8x1, sign: I1x1, evenodd: bool) -> tuple[I8x1, I8x1, I8x1]:
    """Crossings that begin and end the inside: (row (S,), first crossing (S,), last crossing (S,)) by the fill rule."""
    most = len(sign) // 2 + 1
    row = np.empty(most, np.int64)
    first = np.empty(most, np.int64)
    last = np.empty(most, np.int64)
    n = 0
    for j in range(len(starts) - 1):
        winding = 0
        for i in range(starts[j], starts[j + 1]):
            before = winding
            winding = 1 - winding if evenodd else winding + sign[i]
            if before == 0 and winding != 0:
                row[n], first[n] = j, i
            elif before != 0 and winding == 0:
                last[n] = i
                n += 1
    return row[:n].copy(), first[:n].copy(), last[:n].copy()


def levels(low: float, high: float, spacing: float, locked: bool = True) -> Array:
    """Heights v of the rows between ``low`` and ``high``.

    Locked rows stand at odd multiples of half the spacing from the origin, so that the fills of neighbouring areas run
    on into each other. Free rows are the seed's: n = floor(l / spacing) of them, centred.
    """
    if locked:
        k = np.arange(math.ceil(low / spacing - 0.5), math.floor(high / spacing - 0.5) + 1)
        return (k + 0.5) * spacing
    n = int((high - low) / spacing + 1e-9)
    return low + (high - low - (n - 1) * spacing) / 2 + spacing * np.arange(n)


@dataclass(frozen=True, eq=False, slots=True)
class Rows:
    """S spans of rows inside an area, in its row frame: ``row`` (S,) index into ``levels`` (R,), ``u`` (S, 2)."""

    levels: Array
    row: Array
    u: Array
    angle: float

    def lines(self) -> Array:
        """(S, 2, 2) start and end of every span in drawing coordinates."""
        v = np.repeat(self.levels[self.row], 2)
        return from_rows(np.c_[self.u.reshape(-1), v], self.angle).reshape(-1, 2, 2)


def rows(
    paths: Paths, angle: float, spacing: float, *, evenodd: bool = True, locked: bool = True, at: Array | None = None
) -> Rows:
    """The spans of parallel rows inside closed rings: concave, with holes and islands, crossing themselves.

    angle : radians; spacing : mm (the seed's 2r); evenodd : fill rule, else non-zero; locked : see :func:`levels`;
    at : heights of the rows, instead of even ones.
    """
    area = rings(paths, angle)
    if not len(area.points):
        return Rows(np.zeros(0), np.zeros(0, np.int64), np.zeros((0, 2)), angle)
    v = area.points[:, 1]
    height = levels(float(v.min()), float(v.max()), spacing, locked) if at is None else np.asarray(at, np.float64)
    starts, u, _, sign = crossings(area.points, area.offsets, height)
    row, first, last = inside_pairs(starts, sign, evenodd)
    return Rows(height, row, np.c_[u[first], u[last]], angle)


@kernel
def along_ring(
    points: F8x2, at: F8x1, offsets: I8x1, base: F8x1, ring: int, begin: float, way: float, first: F8x1, last: F8x1
) -> F8x2:
    """The outline from place ``begin`` on for a signed ``way``: (n, 2), from point ``first`` to point ``last``."""
    lo, hi = offsets[ring], offsets[ring + 1]
    perimeter = base[ring + 1] - base[ring]
    out = np.empty((hi - lo + 2, 2))
    out[0] = first
    n = 1
    if way >= 0:
        i = lo + np.searchsorted(at[lo:hi], begin + 1e-9)
        turn = 0.0
        while True:
            if i == hi:
                i = lo
                turn += perimeter
            if at[i] + turn >= begin + way - 1e-9 or n > hi - lo:
                break
            out[n] = points[i]
            n += 1
            i += 1
    else:
        i = lo + np.searchsorted(at[lo:hi], begin - 1e-9) - 1
        turn = 0.0
        while True:
            if i < lo:
                i = hi - 1
                turn -= perimeter
            if at[i] + turn <= begin + way + 1e-9 or n > hi - lo:
                break
            out[n] = points[i]
            n += 1
            i -= 1
    out[n] = last
    return out[: n + 1].copy()

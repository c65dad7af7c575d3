"""Ways from one place of an area to another that never leave it: straight, through its rows, or round its outline."""

from __future__ import annotations

from functools import lru_cache
from typing import Any

import numpy as np

from tambour.core.check import Array
from tambour.embroidery.lines.corridor import find, leaves, neighbours, straighten
from tambour.embroidery.lines.fill import Rings, crossings, inside_pairs, levels, polygon_of

NEAR = 4.0
"""mm: places that lie no farther apart are joined straight, were they a little outside."""
BESIDE = 0.05
"""mm that a way may lie outside its area, and a needle point beyond what its stitch is longer by for its pull."""


def way(area: Rings, a: Array, b: Array, pull: float = 0.2) -> Array:
    """Polyline (n, 2) from ``a`` to ``b`` inside ``area`` (rings at angle 0), both ends included.

    Straight where that stays inside; else the short way through a net of rows about 1 mm apart (finer in small
    areas); else through the triangles of the area, which lead through any neck. ``a`` and ``b`` may lie on the outline,
    or outside, by ``pull`` mm as needle points do: then they are led to it straight.
    """
    straight = np.array([a, b], np.float64)
    far = float(np.hypot(*(straight[1] - straight[0])))
    if (
        not len(area.points)
        or far < 0.1
        or not leaves(area.points, area.offsets, straight, BESIDE + max(0.0, pull) * (far < NEAR))
    ):
        return straight
    v = area.points[:, 1]
    tall = float(v.max() - v.min())
    for pitch in (max(min(1.0, tall / 20), tall / 2000), max(min(0.25, tall / 60), tall / 4000)):
        line = _through(area, straight[0], straight[1], pitch)
        if line is not None:
            return line
    return _through_triangles(area, straight[0], straight[1])


def _through(area: Rings, a: Array, b: Array, pitch: float) -> Array | None:
    v = area.points[:, 1]
    at = levels(float(v.min()), float(v.max()), pitch)
    starts, u, _, sign = crossings(area.points, area.offsets, at)
    row, first, last = inside_pairs(starts, sign, True)
    if not len(row):
        return None
    lo, hi = u[first], u[last]
    ends = []
    for p in (a, b):
        away = np.hypot(np.maximum(0, np.maximum(lo - p[0], p[0] - hi)), at[row] - p[1])
        ends.append(int(np.argmin(away)))
    margin = min(0.4, pitch)
    ua, ub = (
        float(np.clip(p[0], min(lo[s] + margin, (lo[s] + hi[s]) / 2), max(hi[s] - margin, (lo[s] + hi[s]) / 2)))
        for p, s in zip((a, b), ends)
    )
    if ends[0] == ends[1]:
        line = np.array([[ua, at[row[ends[0]]]], [ub, at[row[ends[0]]]]])
    else:
        offsets, near = neighbours(row, lo, hi)
        rank = np.zeros(len(row), np.int64)
        path, _ = find(offsets, near, row, at, lo, hi, rank, -1, ends[0], ua, ends[1], ub, margin, 1.0, np.inf)
        if not len(path):
            return None
        line = straighten(path, row, at, lo, hi, ua, ub, margin)
    line = np.concatenate([a[None], line, b[None]])
    line = _shortened(area, line)
    return None if leaves(area.points, area.offsets, line, BESIDE) else line


def nearest_on_outline(area: Rings, p: Array) -> tuple[int, float, Array]:
    """(ring, way along the outlines, point) nearest to ``p``."""
    a = area.points
    step = np.arange(len(a)) + 1
    step[area.offsets[1:] - 1] = area.offsets[:-1]
    d = a[step] - a
    f = np.clip(((p - a) * d).sum(1) / np.maximum((d * d).sum(1), 1e-300), 0, 1)
    q = a + f[:, None] * d
    k = int(np.argmin(((q - p) ** 2).sum(1)))
    ring = int(np.searchsorted(area.offsets, k, side="right") - 1)
    return ring, float(area.at[k] + f[k] * np.hypot(*d[k])), q[k]


@lru_cache(maxsize=2)  # ways are asked for area by area, often hundreds in one
def _triangles(area: Rings) -> tuple[Any, Array, Array] | None:
    """The triangles of an area (constrained Delaunay), the middles (n, 2) of their sides, and the sides (t, 3) of each."""
    import shapely

    corners = shapely.get_coordinates(shapely.constrained_delaunay_triangles(polygon_of(area)))
    corners = corners.reshape(-1, 4, 2)[:, :3]
    if not len(corners):
        return None
    ends = corners[:, [[0, 1], [1, 2], [2, 0]]]
    swap = (ends[..., 0, 0] > ends[..., 1, 0]) | (
        (ends[..., 0, 0] == ends[..., 1, 0]) & (ends[..., 0, 1] > ends[..., 1, 1])
    )
    ends = np.where(swap[..., None, None], ends[..., ::-1, :], ends).reshape(-1, 4)
    sides, side = np.unique(ends, axis=0, return_inverse=True)
    return shapely.polygons(corners), (sides[:, :2] + sides[:, 2:]) / 2, side.reshape(-1, 3)


def _through_triangles(area: Rings, a: Array, b: Array) -> Array:
    """From ``a`` to ``b`` over the area's triangles, from middle to middle of the sides that they share: every piece of it lies
    in a triangle. Straight where the two lie in parts that do not hang together."""
    import shapely
    from scipy.sparse import csr_matrix
    from scipy.sparse.csgraph import dijkstra

    net = _triangles(area)
    if net is None:
        return np.array([a, b])
    # Sides that two triangles share are the places of the net; the three of one triangle are joined.
    triangles, middle, side = net
    n = len(middle)
    places = np.concatenate([middle, a[None], b[None]])
    one, two = [side[:, [0, 1, 2]].reshape(-1)], [side[:, [1, 2, 0]].reshape(-1)]
    for k, p in enumerate((a, b)):
        near = int(np.argmin(shapely.distance(triangles, shapely.points(p))))
        one.append(np.full(3, n + k))
        two.append(side[near])
    i, j = np.concatenate(one), np.concatenate(two)
    graph = csr_matrix((np.hypot(*(places[i] - places[j]).T) + 1e-9, (i, j)), (n + 2, n + 2))
    far, came = dijkstra(graph, directed=False, indices=n, return_predecessors=True)
    if not np.isfinite(far[n + 1]):
        return np.array([a, b])
    path = [n + 1]
    while path[-1] != n:
        path.append(int(came[path[-1]]))
    return _shortened(area, places[path[::-1]])


def _shortened(area: Rings, line: Array) -> Array:
    """The way without the corners that it does not need to stay inside."""
    k = 0
    while k + 2 < len(line):
        if leaves(area.points, area.offsets, line[[k, k + 2]], BESIDE):
            k += 1
        else:
            line = np.delete(line, k + 1, axis=0)
            k = max(0, k - 1)
    return line

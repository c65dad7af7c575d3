"""Satin for areas: an area's middle lines, and the columns across them (letters, leaves, stems)."""

from __future__ import annotations

import itertools
import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from tambour.core.check import Array
from tambour.embroidery.satin import Column, resample

SAMPLE = 0.35  # mm between the outline's samples (finer in small areas)
SPUR = 1.6  # a branch that reaches no farther than this many radii beyond its fork is a corner, not a limb


def skeleton(area: Any) -> tuple[Array, Array, list[tuple[int, int]]]:
    """The middle lines of a shapely polygon: (places (n, 2), radii (n,), edges), corners' spurs left out.

    The Voronoi vertices of dense outline samples that lie inside (Blum's medial axis, approximated).
    """
    import shapely
    from scipy.spatial import Voronoi

    step = min(SAMPLE, max(0.05, area.length / 400))
    samples = [shapely.get_coordinates(shapely.segmentize(r, step))[:-1] for r in (area.exterior, *area.interiors)]
    ring = np.concatenate([np.full(len(s), k) for k, s in enumerate(samples)])
    place = np.concatenate([np.arange(len(s)) for s in samples])
    size = np.array([len(s) for s in samples])
    points = np.concatenate(samples)
    # A grain of unevenness keeps Qhull from degenerate fans on perfect circles and grids.
    points = points + 1e-6 * np.c_[np.sin(np.arange(len(points)) * 12.9898), np.cos(np.arange(len(points)) * 78.233)]
    net = Voronoi(points)
    shapely.prepare(area)
    inside = shapely.contains_xy(area, net.vertices)
    edges = []
    for (p, q), (a, b) in zip(net.ridge_points.tolist(), net.ridge_vertices):
        if a < 0 or b < 0 or not inside[a] or not inside[b]:
            continue
        near = abs(int(place[p]) - int(place[q]))
        if ring[p] == ring[q] and min(near, size[ring[p]] - near) < 3:
            continue  # between neighbours of the outline: a branch into its grain
        edges.append((a, b))
    used = np.unique(np.array(edges, np.int64).reshape(-1))
    number = {int(v): k for k, v in enumerate(used)}
    places = net.vertices[used]
    radius = np.asarray(shapely.distance(shapely.points(places), area.boundary)) if len(places) else np.zeros(0)
    return places, radius, [(number[a], number[b]) for a, b in edges]


def branches(places: Array, radius: Array, edges: list[tuple[int, int]]) -> list[tuple[Array, bool, bool]]:
    """The limbs of a skeleton: (indices along it, whether its first end is free, whether its last end is).

    Spurs into corners go first, shortest first, each time joining what is left at their fork.
    """
    near: list[set[int]] = [set() for _ in range(len(places))]
    for a, b in edges:
        if a != b:
            near[a].add(b)
            near[b].add(a)

    def limb(a: int, b: int) -> list[int]:
        path = [a, b]
        while len(near[path[-1]]) == 2 and path[-1] != a:
            step = next(n for n in near[path[-1]] if n != path[-2])
            if step == path[0]:
                path.append(step)
                break
            path.append(step)
        return path

    def length(path: list[int]) -> float:
        return float(np.hypot(*np.diff(places[path], axis=0).T).sum())

    while True:
        worst: tuple[float, list[int]] | None = None
        for a in range(len(near)):
            if len(near[a]) != 1:
                continue
            path = limb(a, next(iter(near[a])))
            if len(near[path[-1]]) <= 1:
                continue
            reach = length(path) + radius[path[0]]
            excess = reach / max(SPUR * radius[path[-1]], 1e-9)
            if excess < 1 and (worst is None or excess < worst[0]):
                worst = (excess, path)
        if worst is None:
            break
        path = worst[1]
        for p, q in itertools.pairwise(path):
            near[p].discard(q)
            near[q].discard(p)
    made = []
    seen: set[tuple[int, int]] = set()
    starts = [a for a in range(len(near)) if len(near[a]) not in (0, 2)]
    for a in starts:
        for b in sorted(near[a]):
            if (a, b) in seen:
                continue
            path = limb(a, b)
            seen.add((a, b))
            seen.add((path[-1], path[-2]))
            made.append((np.array(path), len(near[a]) == 1, len(near[path[-1]]) == 1))
    visited = {i for path, _, _ in made for i in path.tolist()}
    for a in range(len(near)):
        if len(near[a]) == 2 and a not in visited:
            path = limb(a, min(near[a]))
            visited.update(path)
            made.append((np.array(path), False, False))
    return made


@dataclass(frozen=True, eq=False, slots=True)
class Limb:
    """A column of a branched area, and the forks (or free ends) that it begins and ends at."""

    column: Column
    start: int
    end: int


def limbs(area: Any, widest: float) -> tuple[list[Limb], Any]:
    """Satin columns that cover a shapely polygon, and what they leave of it: limbs wider than ``widest`` are left.

    Across every limb of the skeleton chords are cast to both sides; towards a fork they keep within the limb's own
    width, so that the limbs meet there and overlap a little.
    """
    import shapely

    places, radius, edges = skeleton(area)
    made: list[Limb] = []
    same: dict[int, int] = {}

    def fork(k: int) -> int:
        while k in same:
            k = same[k]
        return k

    for path, free_start, free_end in branches(places, radius, edges) if len(places) > 1 else []:
        wide = radius[path]
        if np.median(wide) * 2 > widest:
            continue
        closed = bool(path[0] == path[-1] and len(path) > 3)
        column = across(area, places[path], wide, free_start, free_end, closed)
        if column is not None:
            made.append(Limb(column, int(path[0]), int(path[-1])))
        elif fork(int(path[0])) != fork(int(path[-1])):
            same[fork(int(path[0]))] = fork(int(path[-1]))
    made = [Limb(m.column, fork(m.start), fork(m.end)) for m in made]
    if not made:
        return [], area
    covered = shapely.union_all([_outline(m.column).buffer(0.25, join_style="mitre") for m in made])
    left = area.buffer(-0.1).difference(covered)
    pieces = [
        p.buffer(0.3).intersection(area) for p in shapely.get_parts(left) if p.geom_type == "Polygon" and p.area > 0.4
    ]
    return made, shapely.union_all(pieces) if pieces else shapely.Polygon()


def _outline(column: Column) -> Any:
    import shapely

    n = max(2, len(column.left) // 4)
    a, b = resample(column.left, n), resample(column.right, n)
    quads = [shapely.Polygon([a[i], a[i + 1], b[i + 1], b[i]]).buffer(0) for i in range(n - 1)]
    return shapely.union_all(quads)


def across(area: Any, line: Array, wide: Array, free_start: bool, free_end: bool, closed: bool) -> Column | None:
    """The column across one limb: its middle line smoothed and run out to the outline at free ends, chords cast."""
    import shapely

    step = np.hypot(*np.diff(line, axis=0).T)
    size = float(step.sum())
    half = float(np.median(wide))
    if size + (free_start + free_end) * half < 0.8 * half:
        return None
    way = np.r_[0, np.cumsum(step)]
    n = max(4, math.ceil(size / 0.2))
    at = np.linspace(0, size, n)
    p = np.c_[np.interp(at, way, line[:, 0]), np.interp(at, way, line[:, 1])]
    r = np.interp(at, way, wide)
    reach = max(1, round(0.8 * half / max(size / (n - 1), 1e-9)))
    p = _smoothed(p, min(reach, max(1, n // 4)), closed)
    if free_start:
        p, r = _run_out(area, p[::-1], r[::-1], half)
        p, r = p[::-1], r[::-1]
    if free_end:
        p, r = _run_out(area, p, r, half)
    if len(p) < 3:
        return None
    d = np.gradient(p, axis=0)
    if closed:
        d[0] = d[-1] = p[1] - p[-2]
    heading = np.unwrap(np.arctan2(d[:, 1], d[:, 0]))
    k = min(reach, max(1, len(p) // 4))
    heading = _smoothed(np.c_[heading, heading], k, False)[:, 0] if not closed else heading
    normal = np.c_[-np.sin(heading), np.cos(heading)]
    limit = np.maximum(1.25 * r, 0.3)[:, None]
    limit = np.minimum(limit, 2.0 * half)
    chords = shapely.linestrings(np.stack([p - limit * normal, p + limit * normal], 1))
    left, right = p.copy(), p.copy()
    cut = shapely.intersection(chords, area)
    for i, piece in enumerate(cut):
        parts = [q for q in shapely.get_parts(piece) if q.geom_type == "LineString"]
        if not parts:
            continue
        best = parts[int(np.argmin([shapely.distance(q, shapely.points(p[i])) for q in parts]))]
        ends = np.asarray(shapely.get_coordinates(best))[[0, -1]]
        side = (ends - p[i]) @ normal[i]
        right[i], left[i] = ends[np.argmin(side)], ends[np.argmax(side)]
    return Column(left, right)


def _smoothed(p: Array, reach: int, closed: bool) -> Array:
    window = np.hanning(2 * reach + 3)[1:-1]
    window /= window.sum()
    if closed:
        padded = np.concatenate([p[-reach - 1 : -1], p, p[1 : reach + 1]])
    else:
        # Mirrored through the ends, so that they stay where they are.
        padded = np.concatenate([2 * p[0] - p[reach:0:-1], p, 2 * p[-1] - p[-2 : -reach - 2 : -1]])
    return np.c_[np.convolve(padded[:, 0], window, "valid"), np.convolve(padded[:, 1], window, "valid")]


def _run_out(area: Any, p: Array, r: Array, half: float) -> tuple[Array, Array]:
    """The line carried on in its last direction until it meets the outline."""
    import shapely

    back = min(len(p) - 1, max(2, round(half / 0.2)))
    d = p[-1] - p[-1 - back]
    size = float(np.hypot(*d))
    if size < 1e-9:
        return p, r
    d = d / size
    ray = shapely.intersection(shapely.linestrings([p[-1], p[-1] + 4 * max(float(r[-1]), half) * d]), area)
    parts = [q for q in shapely.get_parts(ray) if q.geom_type == "LineString"]
    if not parts:
        return p, r
    first = min(parts, key=lambda q: shapely.distance(q, shapely.points(p[-1])))
    far = float(np.hypot(*(shapely.get_coordinates(first) - p[-1]).T).max())
    n = max(1, math.ceil(far / 0.2))
    more = p[-1] + np.linspace(0, far - 0.02, n + 1)[1:, None] * d if far > 0.05 else np.zeros((0, 2))
    return np.concatenate([p, more]), np.r_[r, np.full(len(more), max(float(r[-1]), 0.5 * half))]

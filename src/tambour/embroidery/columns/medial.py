"""Satin for areas: an area's middle lines, and the columns across them (letters, leaves, stems)."""

from __future__ import annotations

import itertools
import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from tambour.core.check import Array
from tambour.embroidery.columns.angles import WIDER, beside, parted
from tambour.embroidery.columns.chords import across, passed
from tambour.embroidery.columns.rails import outlined
from tambour.embroidery.columns.satin import Column, resample

SAMPLE = 0.35  # mm between the outline's samples (finer in small areas)
BELOW = 0.4  # mm that a limb which ends at another goes on below it
STUB = 2.2  # radii of its fork that a limb is long at most to be a serif
ROUND = 17.0  # length² / area of a dot: 12.6 for a disc, 16 for a square, 18 for a bar twice as long as wide
TIP = 0.5  # mm that the first and the last stitch of a dot are long at least
SPUR = 1.46  # a branch that reaches no farther than this many radii beyond its fork is a corner, not a limb


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
        spurs: dict[int, list[tuple[float, list[int]]]] = {}
        for a in range(len(near)):
            if len(near[a]) != 1:
                continue
            path = limb(a, next(iter(near[a])))
            if len(near[path[-1]]) <= 1:
                continue
            excess = (length(path) + radius[path[0]]) / max(SPUR * radius[path[-1]], 1e-9)
            if excess < 1:
                spurs.setdefault(path[-1], []).append((excess, path))
        if not spurs:
            break
        fork = min(spurs, key=lambda f: min(spurs[f])[0])
        gone = sorted(spurs[fork])
        if len(near[fork]) <= len(gone):
            gone = gone[:1]  # nothing but corners meet here: the longer ones are its limbs
        for _, path in gone:
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


def _stemmed(limbs: Any, here: Any, pair: tuple[int, int], places: Array, radius: Array) -> bool:
    """Whether a far wider limb ends where a stub and a long limb meet, as a stem does between its serif and its arch: it goes
    through, and they end below it."""

    def size(k: int) -> float:
        return float(np.hypot(*np.diff(places[limbs[k][0]], axis=0).T).sum())

    if len(here) != 3:
        return False
    (third,) = {k for _, k, _ in here} - set(pair) or {-1}
    if third < 0:
        return False
    _, k, last = next(e for e in here if e[1] == third)
    fork = int(limbs[k][0][-1 if last else 0])
    stub = [(limbs[k][1] or limbs[k][2]) and size(k) < STUB * radius[fork] for k in pair]
    half = {k: beside(np.array(limbs[k][0]), bool(last), places, radius) for _, k, last in here}
    return sum(stub) == 1 and half[third] > WIDER * max(half[k] for k in pair)


@dataclass(frozen=True, eq=False, slots=True)
class Limb:
    """A column of a branched area.

    start, end : the forks (or free ends) that it begins and ends at; through : forks that it passes, with their places
    """

    column: Column
    start: int
    end: int
    through: tuple[tuple[int, Array], ...] = ()


def straightened(
    parts: list[tuple[Array, bool, bool]], places: Array, radius: Array
) -> list[tuple[Array, bool, bool, list[int]]]:
    """Limbs joined where two of a fork lie almost in one line, as strokes do: (path, free start, free end, forks passed).

    At each fork the straightest pair (within 50 degrees) goes on; the others end there, below it.
    """
    ends: dict[int, list[tuple[float, int, int]]] = {}
    limbs = [(path.tolist(), a, b, [0][:0]) for path, a, b in parts]
    heading: dict[tuple[int, bool], Array] = {}
    for k, (path, free_a, free_b, _) in enumerate(limbs):
        if path[0] == path[-1]:
            continue
        for last in (False, True):
            line = path[::-1] if last else path
            away = np.hypot(*(places[line] - places[line[0]]).T)
            far = int(np.argmax(away > 1.6 * radius[line[0]])) or len(line) - 1
            near = min(far, int(np.argmax(away > 0.8 * radius[line[0]])))
            d = places[line[far]] - places[line[near if far > near else 0]]
            heading[k, last] = d / max(float(np.hypot(*d)), 1e-9)
            if not (free_b if last else free_a):
                ends.setdefault(line[0], []).append((0.0, k, int(last)))
    pairs = []
    for fork, here in ends.items():
        for i, (_, a, la) in enumerate(here):
            for _, b, lb in here[i + 1 :]:
                if a != b and not _stemmed(limbs, here, (a, b), places, radius):
                    pairs.append(
                        (float(heading[a, bool(la)] @ heading[b, bool(lb)]), fork, (a, bool(la)), (b, bool(lb)))
                    )
    whose = {k: k for k in range(len(limbs))}
    taken: set[tuple[int, bool]] = set()
    joined: dict[int, Any] = dict(enumerate(limbs))
    for straight, fork, one, two in sorted(pairs, key=lambda p: (p[0], p[1], p[2], p[3])):
        if straight > -math.cos(math.radians(50)) or one in taken or two in taken:
            continue
        a, b = whose[one[0]], whose[two[0]]
        if a == b:
            continue
        pa, pb = joined[a], joined.pop(b)
        if pa[0][0] == fork and pa[0][-1] != fork:
            pa = (pa[0][::-1], pa[2], pa[1], pa[3])
        if pb[0][-1] == fork and pb[0][0] != fork:
            pb = (pb[0][::-1], pb[2], pb[1], pb[3])
        taken |= {one, two}
        joined[a] = (pa[0] + pb[0][1:], pa[1], pb[2], [*pa[3], fork, *pb[3]])
        for k, v in whose.items():
            if v == b:
                whose[k] = a
    return [(np.array(p), fa, fb, forks) for p, fa, fb, forks in joined.values()]


def limbs(area: Any, widest: float) -> tuple[list[Limb], Any]:
    """Satin columns that cover a shapely polygon, and what they leave of it: limbs wider than ``widest`` are left.

    Across every limb of the skeleton chords are cast to both sides, no farther than the limb is wide away from forks.
    """
    import shapely

    dot = _dot(area, widest) if round_of(area) else None
    if dot is not None:
        return [Limb(dot, 0, 1)], shapely.Polygon()
    places, radius, edges = skeleton(area)
    made: list[Limb] = []
    same: dict[int, int] = {}  # forks that only a stump lies between are one

    def fork_of(k: int) -> int:
        while k in same:
            k = same[k]
        return k

    parts = branches(places, radius, edges) if len(places) > 1 else []
    joined = parted(straightened(parts, places, radius), places, radius, area)
    through: dict[int, float] = {}  # by fork, half the width of what goes through it
    for path, _, _, forks in joined:
        for f in forks:
            through[f] = min(through.get(f, np.inf), float(np.median(radius[path])))

    def met(k: int) -> tuple[float, float]:
        """A fork's radius, and how far beyond it a limb that ends there is led: a little below what goes through."""
        r = float(radius[k])
        return r, min(0.8 * r, max(-0.15 * r, r - 2 * through.get(k, np.inf) + BELOW))

    for path, free_start, free_end, forks in joined:
        wide = np.minimum(radius[path], 1.2 * float(np.median(radius[path])))
        if np.median(wide) * 2 > widest:
            continue
        closed = bool(path[0] == path[-1] and len(path) > 3)
        line, wide = passed(places[path], wide, [(places[f], float(radius[f])) for f in forks], (free_start, free_end))
        column = across(area, line, wide, (free_start, free_end), closed, (met(int(path[0])), met(int(path[-1]))))
        if column is not None and len(joined) == 1 and free_start and free_end and not area.interiors:
            column = outlined(column, area, float(np.median(wide)))
        if column is not None:
            made.append(Limb(column, int(path[0]), int(path[-1]), tuple((f, places[f]) for f in forks)))
        elif fork_of(int(path[0])) != fork_of(int(path[-1])):
            same[fork_of(int(path[0]))] = fork_of(int(path[-1]))
    if not made:
        return [], area
    made = [
        Limb(m.column, fork_of(m.start), fork_of(m.end), tuple((fork_of(f), at) for f, at in m.through)) for m in made
    ]
    # GEOS leaves the processor's flag of a division by zero behind where a mitre has no length; the outline is right.
    with np.errstate(divide="ignore", invalid="ignore"):
        covered = shapely.union_all([_outline(m.column).buffer(0.25, join_style="mitre") for m in made])
    left = area.buffer(-0.1).difference(covered)
    pieces = [
        p.buffer(0.3).intersection(area) for p in shapely.get_parts(left) if p.geom_type == "Polygon" and p.area > 0.4
    ]
    return made, shapely.union_all(pieces) if pieces else shapely.Polygon()


def round_of(area: Any) -> bool:
    """Whether a shapely polygon is a dot: as wide as it is long, and so without a middle line."""
    return not area.interiors and bool(area.length**2 < ROUND * area.area)


def _dot(area: Any, widest: float) -> Column | None:
    """The column of a dot: straight across it, from one end of its longer side to the other; None where it is too small, or wider
    than ``widest``."""
    import shapely

    box = shapely.get_coordinates(shapely.minimum_rotated_rectangle(area))
    sides = box[1:3] - box[:2]
    size = np.hypot(*sides.T)
    if size.min() > widest:
        return None
    along = sides[int(size.argmax())] / size.max()
    middle = shapely.get_coordinates(area.centroid)[0]
    line = middle + np.linspace(-0.1, 0.1, 5)[:, None] * size.max() * along
    column = across(area, line, np.full(5, float(size.min()) / 2), (True, True), False, ((0.0, 0.0), (0.0, 0.0)))
    seen = np.zeros(0, np.int64) if column is None else np.flatnonzero(np.hypot(*(column.left - column.right).T) > TIP)
    if column is None or len(seen) < 3:
        return None
    return Column(column.left[seen[0] : seen[-1] + 1], column.right[seen[0] : seen[-1] + 1])


def _outline(column: Column) -> Any:
    import shapely

    n = max(2, len(column.left) // 4)
    a, b = resample(column.left, n), resample(column.right, n)
    quads = [shapely.Polygon([a[i], a[i + 1], b[i + 1], b[i]]).buffer(0) for i in range(n - 1)]
    return shapely.union_all(quads)

"""Curved fills as one thread: lines of any form, open or closed, joined into one Eulerian walk (see route).

Ends on the outline are joined along it; ends inside are paired with their nearest; loops, and whatever else hangs by
itself, are hooked to a neighbour by a short way out and back. What has to be crossed stays inside the area.
"""

from __future__ import annotations

import itertools
import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from tambour.core.check import Array
from tambour.core.paths import Paths
from tambour.embroidery.lines.corridor import leaves
from tambour.embroidery.lines.fill import Rings, along_ring
from tambour.embroidery.lines.route import LINE, LINK, RING, adjacency, euler, ring_edges
from tambour.embroidery.lines.ways import way
from tambour.embroidery.piece import FILL, TRAVEL
from tambour.embroidery.stitches import Stitches, join, line_stitches

ON_RING = 1e-4  # mm from the outline that an end may be and still count as on it


@dataclass(slots=True)
class _Line:
    """A line with the nodes on it: places (way along the line) and node numbers, in order."""

    points: Array
    way: Array  # (n,) way along the line
    closed: bool
    nodes: list[tuple[float, int]]


def weave(
    lines: list[Array],
    area: Rings,
    length: float,
    spacing: float,
    *,
    kind: int = FILL,
    start: tuple[float, float] | None = None,
    stagger: int = 4,
    tolerance: float = 0.1,
    per_stitch: bool = False,
) -> Stitches:
    """Join ``lines`` ((n, 2), closed ones repeat their first point) inside ``area`` (rings at angle 0) to one thread.

    length : longest stitch; spacing : the lines' usual distance, mm; start : where to begin
    stagger : every line's first stitch is shortened by another share, so that needle points do not line up
    """
    whole = [np.ascontiguousarray(line, np.float64) for line in lines if len(line) > 1]
    net = [
        _Line(p, np.r_[0, np.cumsum(np.hypot(*np.diff(p, axis=0).T))], bool((p[0] == p[-1]).all()), []) for p in whole
    ]
    net = [n for n in net if n.way[-1] > 1e-6]
    if not net:
        return Stitches.none()
    xy: list[Array] = []

    def node(line: _Line, s: float) -> int:
        for place, k in line.nodes:
            if abs(place - s) < 1e-9 or (line.closed and abs(abs(place - s) - line.way[-1]) < 1e-9):
                return k
        xy.append(np.array([np.interp(s, line.way, line.points[:, 0]), np.interp(s, line.way, line.points[:, 1])]))
        line.nodes.append((s, len(xy) - 1))
        return len(xy) - 1

    for line in net:
        if not line.closed:
            node(line, 0.0)
            node(line, float(line.way[-1]))
    ends = np.array(xy).reshape(-1, 2)
    ring: Array
    at: Array
    ring, at = _on_rings(ends, area)
    order = np.flatnonzero(ring >= 0)
    order = order[np.argsort(at[order], kind="stable")]
    ra, rb, rl = ring_edges(order, ring, at, area.base)
    degree = np.ones(len(ends), np.int64)
    np.add.at(degree, ra, 1)
    np.add.at(degree, rb, 1)
    links = _pairs(ends, np.flatnonzero(degree % 2 == 1), area)
    part = _components(net, ra, rb, links, len(ends))
    hooks = _hooks(net, part, spacing)
    edges: list[tuple[int, int, float, int, Any]] = [
        (int(a), int(b), float(w), RING, None) for a, b, w in zip(ra.tolist(), rb.tolist(), rl.tolist())
    ]
    edges += [(a, b, float(np.hypot(*(xy[a] - xy[b]))), LINK, None) for a, b in links]
    for i, s, j, t in hooks:
        u, v = node(net[i], s), node(net[j], t)
        mm = float(np.hypot(*(xy[u] - xy[v])))
        edges += [(u, v, mm, LINK, None), (u, v, mm, LINK, None)]
    for k, line in enumerate(net):
        places = sorted(line.nodes)
        if not places:
            places = [(0.0, node(line, 0.0))]
        if line.closed:
            places.append((places[0][0] + float(line.way[-1]), places[0][1]))
        edges += [(a, b, t - s, LINE, (k, s, t)) for (s, a), (t, b) in itertools.pairwise(places)]
    a, b = np.array([e[0] for e in edges]), np.array([e[1] for e in edges])
    w, what = np.array([e[2] for e in edges]), np.array([e[3] for e in edges], np.int8)
    offsets, edge = adjacency(len(xy), a, b)
    points = np.array(xy)
    begin = 0 if start is None else int(np.argmin(((points - np.array(start)) ** 2).sum(1)))
    tour, froms = euler(begin, a, b, w, what, offsets, edge)
    all_ring = np.r_[ring, np.full(len(xy) - len(ring), -1)]
    all_at = np.r_[at, np.zeros(len(xy) - len(at))]
    return _emit(tour, froms, edges, net, area, points, all_ring, all_at, length, kind, stagger, tolerance)


def _on_rings(ends: Array, area: Rings) -> tuple[Array, Array]:
    """Which ring each end lies on (-1: none), and its way along the outlines."""
    import shapely

    ring: Array = np.full(len(ends), -1)
    at: Array = np.zeros(len(ends))
    if not len(ends):
        return ring, at
    points: Any = shapely.points(ends)
    for k in range(len(area.offsets) - 1):
        p = area.points[area.offsets[k] : area.offsets[k + 1]]
        outline = shapely.linestrings(np.concatenate([p, p[:1]]))
        shapely.prepare(outline)
        near = shapely.dwithin(outline, points, ON_RING)
        ring[near] = k
        at[near] = area.base[k] + shapely.line_locate_point(outline, points[near])
    return ring, at


def _pairs(ends: Array, odd: Array, area: Rings) -> list[tuple[int, int]]:
    """Odd nodes paired: near ones first, then pairs exchanged while that shortens the ways between them.

    A way that leaves the area counts four times, for it will have to go round.
    """
    from scipy.spatial import cKDTree

    x, y = ends[:, 0].tolist(), ends[:, 1].tolist()

    def far_of(a: int, b: int) -> float:
        return math.hypot(x[a] - x[b], y[a] - y[b])

    def cost(a: int, b: int) -> float:
        d = far_of(a, b)
        if d > 0.3 and leaves(area.points, area.offsets, ends[[a, b]], 0.05):
            return 4 * d
        return d

    made: list[tuple[int, int]] = []
    left = odd
    reach = 8
    while len(left) > 1:
        tree = cKDTree(ends[left])
        k = min(reach, len(left))
        far, who = tree.query(ends[left], k)
        a, b = np.repeat(np.arange(len(left)), k), np.ravel(who)
        keep = a < b
        a, b, d = a[keep], b[keep], np.ravel(far)[keep]
        taken = np.zeros(len(left), bool)
        for i in np.argsort(d, kind="stable").tolist():
            if not taken[a[i]] and not taken[b[i]]:
                taken[a[i]] = taken[b[i]] = True
                made.append((int(left[a[i]]), int(left[b[i]])))
        left = left[~taken]
        reach *= 2
    if len(made) < 2:
        return made
    mate = dict(made) | {b: a for a, b in made}
    tree = cKDTree(ends[odd])
    median = float(np.median([far_of(p, q) for p, q in made]))
    todo: list[int] = [p for p, q in made if far_of(p, q) > 3 * median]
    paid = {p: far_of(p, q) for p, q in mate.items()}
    for p in todo:
        paid[p] = paid[mate[p]] = cost(p, mate[p])
    todo.sort(key=lambda p: -paid[p])
    tries = 0
    while todo and tries < 4000:
        p = todo.pop(0)
        tries += 1
        q, now = mate[p], paid[p]
        gain, swap = 1e-9, None
        for end, other in ((p, q), (q, p)):
            for i in np.atleast_1d(tree.query(ends[end], min(24, len(odd)))[1]).tolist():
                c = int(odd[i])
                f = mate[c]
                if c in (p, q) or now + paid[c] - far_of(end, c) - far_of(other, f) <= gain:
                    continue  # not even as the crow flies
                better = now + paid[c] - cost(end, c) - cost(other, f)
                if better > gain:
                    gain, swap = better, (end, c, other, f)
        if swap is not None:
            e, c, o, f = swap
            mate[e], mate[c], mate[o], mate[f] = c, e, f, o
            paid[e] = paid[c] = cost(e, c)
            paid[o] = paid[f] = cost(o, f)
            todo += [x for x, y in ((e, c), (o, f)) if far_of(x, y) > 3 * median]
    return [(a, b) for a, b in sorted(mate.items()) if a < b]


def _components(net: list[_Line], ra: Array, rb: Array, links: list[tuple[int, int]], nodes: int) -> Array:
    """The connected part that each line belongs to (L,)."""
    from scipy.sparse import coo_matrix
    from scipy.sparse.csgraph import connected_components

    n = nodes + len(net)
    of = [(k, nodes + i) for i, line in enumerate(net) for _, k in line.nodes]
    pairs = np.array([*of, *zip(ra.tolist(), rb.tolist()), *links], np.int64).reshape(-1, 2)
    graph = coo_matrix((np.ones(len(pairs)), (pairs[:, 0], pairs[:, 1])), shape=(n, n))
    return np.asarray(connected_components(graph, directed=False)[1])[nodes:]


def _hooks(net: list[_Line], part: Array, spacing: float) -> list[tuple[int, float, int, float]]:
    """Short ways (line, place, line, place) that join all parts to one: a least spanning tree over near samples."""
    if len(np.unique(part)) == 1:
        return []
    from scipy.spatial import cKDTree

    who, place = [], []
    for i, line in enumerate(net):
        n = max(2, int(line.way[-1] / (0.5 * spacing)) + 1)
        place.append(np.linspace(0, line.way[-1], n + line.closed)[:n])
        who.append(np.full(n, i))
    w, s = np.concatenate(who), np.concatenate(place)
    xy = np.concatenate(
        [
            np.c_[np.interp(p, line.way, line.points[:, 0]), np.interp(p, line.way, line.points[:, 1])]
            for p, line in zip(place, net)
        ]
    )
    made: list[tuple[int, float, int, float]] = []
    root = part.copy()
    tree = cKDTree(xy)
    reach = 12
    while len(np.unique(root)) > 1:
        k = min(reach, len(xy))
        # The largest part needs no search of its own.
        label, size = np.unique(root[w], return_counts=True)
        ask = np.flatnonzero(root[w] != label[np.argmax(size)])
        far, other = tree.query(xy[ask], k)
        a, b, d = np.repeat(ask, k), np.ravel(other), np.ravel(far)
        keep = root[w[a]] != root[w[b]]
        a, b, d = a[keep], b[keep], d[keep]
        joined = False
        for i in np.argsort(d, kind="stable").tolist():
            p, q = root[w[a[i]]], root[w[b[i]]]
            if p != q:
                made.append((int(w[a[i]]), float(s[a[i]]), int(w[b[i]]), float(s[b[i]])))
                root[root == q] = p
                joined = True
        if not joined or k < len(xy):
            reach *= 4
    return made


def _emit(
    tour: Array,
    froms: Array,
    edges: list[tuple[int, int, float, int, Any]],
    net: list[_Line],
    area: Rings,
    xy: Array,
    ring: Array,
    at: Array,
    length: float,
    kind: int,
    stagger: int,
    tolerance: float,
) -> Stitches:
    parts: list[Stitches] = []
    connector = 0.0
    k = 0
    n = len(tour)
    while k < n and edges[tour[k]][3] != LINE:
        k += 1
    lines = 0
    here = -1
    while k < n:
        a, b, _, what, piece = edges[tour[k]]
        u = int(froms[k])
        if what == LINE:
            if here >= 0 and here != u:
                parts, mm = _travel(parts, area, xy, ring, at, here, u, length)
                connector += mm
            i, s, t = piece
            forward = u == a if a != b else True
            line = _slice(net[i], s, t)
            line = line if forward else line[::-1]
            parts.append(_stagger(line, length, kind, tolerance, (lines % stagger) / stagger if stagger > 1 else 0.0))
            lines += 1
            here = b if u == a else a
        k += 1
    made = join(_joined(parts))
    return Stitches(made.xy, made.kind, made.run, {"connector_mm": connector})


def _joined(parts: list[Stitches]) -> list[Stitches]:
    """Each part without its first point where that is the last of the one before."""
    out: list[Stitches] = []
    for p in parts:
        if out and len(p) > 1 and abs(p.xy[0] - out[-1].xy[-1]).max() < 1e-6:
            p = Stitches(p.xy[1:], p.kind[1:], p.run[1:], p.facts)
        out.append(p)
    return out


def _travel(
    parts: list[Stitches], area: Rings, xy: Array, ring: Array, at: Array, a: int, b: int, length: float
) -> tuple[list[Stitches], float]:
    if ring[a] >= 0 and ring[a] == ring[b]:
        r = int(ring[a])
        perimeter = float(area.base[r + 1] - area.base[r])
        signed = float(at[b] - at[a])
        signed -= perimeter * round(signed / perimeter)
        line = along_ring(area.points, area.at, area.offsets, area.base, r, float(at[a]), signed, xy[a], xy[b])
    else:
        line = way(area, xy[a], xy[b])
    return [*parts, line_stitches(line, length, TRAVEL, 0.04)], float(np.hypot(*np.diff(line, axis=0).T).sum())


def _slice(line: _Line, s: float, t: float) -> Array:
    """The points of a line from place s to place t; a loop may run over its end."""
    total = float(line.way[-1])
    points, w = line.points, line.way
    if t > total + 1e-9:
        points, w = np.concatenate([points, points[1:]]), np.r_[w, w[1:] + total]
    inner = (w > s + 1e-9) & (w < t - 1e-9)
    first = [np.interp(s, w, points[:, 0]), np.interp(s, w, points[:, 1])]
    last = [np.interp(t, w, points[:, 0]), np.interp(t, w, points[:, 1])]
    return np.concatenate([[first], points[inner], [last]])


def _stagger(line: Array, length: float, kind: int, tolerance: float, share: float) -> Stitches:
    total = np.hypot(*np.diff(line, axis=0).T)
    if share > 0 and total.sum() > 1.5 * length:
        cut = share * length
        w = np.r_[0, np.cumsum(total)]
        k = int(np.searchsorted(w, cut))
        p = np.array([[np.interp(cut, w, line[:, 0]), np.interp(cut, w, line[:, 1])]])
        first = line_stitches(np.concatenate([line[:k], p]), length, kind, tolerance)
        rest = line_stitches(np.concatenate([p, line[k:]]), length, kind, tolerance)
        whole = np.concatenate([first.xy, rest.xy[1:]])
        return Stitches.of(whole, kind)
    return line_stitches(line, length, kind, tolerance)


def clipped(lines: list[Array], area: Any) -> list[Array]:
    """The pieces of polylines inside a shapely polygon."""
    import shapely

    if not lines:
        return []
    shapely.prepare(area)
    cut = shapely.intersection(np.array([shapely.linestrings(line) for line in lines]), area)
    found = []
    for piece in cut:
        if piece.geom_type == "MultiLineString":
            piece = shapely.line_merge(piece)
        found += [
            shapely.get_coordinates(p)
            for p in shapely.get_parts(piece)
            if p.geom_type == "LineString" and p.length > 0.05
        ]
    return found


def loops(paths: Paths) -> list[Array]:
    """The rings of paths as closed lines."""
    return [ring for ring in paths if len(ring) > 3]

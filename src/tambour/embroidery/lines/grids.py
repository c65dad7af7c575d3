"""Fills on a grid: meander (a line that wanders and never crosses itself) and cross stitch."""

from __future__ import annotations

from typing import Any

import numpy as np

from tambour.core.arrays import B1x1, I8x1
from tambour.core.check import Array
from tambour.core.kernels import kernel
from tambour.embroidery.lines.fill import Rings
from tambour.embroidery.lines.route import LINE, LINK, adjacency, euler
from tambour.embroidery.lines.ways import way
from tambour.embroidery.piece import FILL, TRAVEL
from tambour.embroidery.stitches import Stitches, join, line_stitches
from tambour.noise import stream


def cells_inside(area: Any, size: float, share: float) -> tuple[Array, float, float]:
    """Which squares of a grid locked to the origin lie in a shapely area by at least ``share``: (mask, left, top)."""
    import shapely

    x0, y0, x1, y1 = area.bounds
    left, top = np.floor(x0 / size) * size, np.floor(y0 / size) * size
    columns, rows = int(np.ceil((x1 - left) / size)), int(np.ceil((y1 - top) / size))
    x, y = np.meshgrid(left + size * np.arange(columns), top + size * np.arange(rows))
    boxes = shapely.box(x, y, x + size, y + size)
    shapely.prepare(area)
    if share >= 1:
        return shapely.contains(area, boxes), float(left), float(top)
    part = shapely.area(shapely.intersection(area, boxes)) / size**2
    return np.asarray(part >= share), float(left), float(top)


@kernel
def spanning(a: I8x1, b: I8x1, weight_order: I8x1, cells: int) -> B1x1:
    """Which edges (a, b) belong to the spanning forest that takes them in ``weight_order`` (Kruskal)."""
    root = np.arange(cells)
    keep = np.zeros(len(a), np.bool_)
    for e in weight_order:
        p, q = a[e], b[e]
        while root[p] != p:
            root[p] = root[root[p]]
            p = root[p]
        while root[q] != q:
            root[q] = root[root[q]]
            q = root[q]
        if p != q:
            root[p] = q
            keep[e] = True
    return keep


def meander(area: Any, rings: Rings, lane: float, length: float, seed: str, start: Any = None) -> Stitches:
    """A closed line that fills an area evenly, ``lane`` mm from itself, and never crosses itself.

    It walks round a random spanning tree of cells two lanes wide (a Hamiltonian cycle of the grid half as wide), its
    corners rounded. Parts that are too narrow for a cell stay open; unconnected parts are joined inside the area.
    """
    mask, left, top = cells_inside(area.buffer(0.4 * lane), 2 * lane, 1.0)
    if not mask.any():
        mask, left, top = cells_inside(area, 2 * lane, 0.5)
    if not mask.any():
        return Stitches.none()
    number = np.cumsum(mask.reshape(-1)).reshape(mask.shape) - 1
    across = mask[:, :-1] & mask[:, 1:]
    down = mask[:-1] & mask[1:]
    a = np.concatenate([number[:, :-1][across], number[:-1][down]])
    b = np.concatenate([number[:, 1:][across], number[1:][down]])
    order = np.argsort(stream(seed, "meander").random(len(a)), kind="stable")
    keep = spanning(a, b, order, int(mask.sum()))
    # Fine grid: every cell is four points; neighbours in a cell are joined unless a tree edge passes between them.
    _rows, _columns = mask.shape
    tree_right, tree_down = np.zeros(mask.shape, bool), np.zeros(mask.shape, bool)
    tree_right[:, :-1][across] = keep[: across.sum()]
    tree_down[:-1][down] = keep[across.sum() :]
    cycles = _around(mask, tree_right, tree_down)
    lines = [np.c_[left + lane * (0.5 + c[:, 1]), top + lane * (0.5 + c[:, 0])] for c in cycles]
    parts: list[Stitches] = []
    here = start
    while lines:
        k = 0 if here is None else int(np.argmin([((p - np.array(here)) ** 2).sum(1).min() for p in lines]))
        line = lines.pop(k)
        if here is not None:
            line = np.roll(line[:-1], -int(np.argmin(((line[:-1] - np.array(here)) ** 2).sum(1))), axis=0)
            line = np.concatenate([line, line[:1]])
        line = _rounded(line)
        if parts:
            link = line_stitches(way(rings, parts[-1].xy[-1], line[0]), length, TRAVEL, 0.04)
            parts.append(Stitches(link.xy[1:], link.kind[1:], link.run[1:]))
        made = line_stitches(line, length, FILL, 0.1)
        parts.append(Stitches(made.xy[1:], made.kind[1:], made.run[1:]) if parts else made)
        here = (float(line[-1, 0]), float(line[-1, 1]))
    return join(parts)


def _around(mask: Array, right: Array, down: Array) -> list[Array]:
    """Closed walks (n, 2) of (row, column) on the fine grid, round each tree of the forest."""
    rows, columns = mask.shape
    left, up = np.zeros_like(right), np.zeros_like(down)
    left[:, 1:], up[1:] = right[:, :-1], down[:-1]
    seen = np.zeros((2 * rows, 2 * columns), bool)
    cycles = []
    for r0, c0 in zip(*np.nonzero(mask)):
        if seen[2 * r0, 2 * c0]:
            continue
        walk = []
        r, c = 2 * int(r0), 2 * int(c0)
        while not seen[r, c]:
            seen[r, c] = True
            walk.append((r, c))
            i, j, low, far = r // 2, c // 2, r % 2, c % 2
            # Clockwise round the tree: along the cell's side, or over a tree edge into the neighbour.
            if (low, far) == (0, 0):
                r, c = (r - 1, c) if up[i, j] else (r, c + 1)
            elif (low, far) == (0, 1):
                r, c = (r, c + 1) if right[i, j] else (r + 1, c)
            elif (low, far) == (1, 1):
                r, c = (r + 1, c) if down[i, j] else (r, c - 1)
            else:
                r, c = (r, c - 1) if left[i, j] else (r - 1, c)
        walk.append(walk[0])
        cycles.append(np.array(walk, np.float64))
    return cycles


def _rounded(line: Array) -> Array:
    """A closed line with its corners cut twice (Chaikin), begun and ended at its first point's first cut."""
    for _ in range(3):
        a, b = line[:-1], line[1:]
        cut = np.stack([0.75 * a + 0.25 * b, 0.25 * a + 0.75 * b], 1).reshape(-1, 2)
        line = np.concatenate([cut, cut[:1]])
    return line


def cross(area: Any, rings: Rings, size: float, start: Any = None) -> Stitches:
    """Cross stitch: squares of ``size`` mm that lie in the area by half; every leg sewn twice, as with two strands.

    Sewn twice, every corner has an even number of legs, so that all crosses of one colour of the chessboard of corners
    are one walk that never shows anything but legs; the two colours are joined by one short way.
    """
    mask, left, top = cells_inside(area, size, 0.5)
    rows, columns = np.nonzero(mask)
    if not len(rows):
        return Stitches.none()
    wide = mask.shape[1] + 1

    def corner(r: Array, c: Array) -> Array:
        return r * wide + c

    a = np.concatenate([corner(rows, columns), corner(rows, columns + 1)])
    b = np.concatenate([corner(rows + 1, columns + 1), corner(rows + 1, columns)])
    names, index = np.unique(np.concatenate([a, b]), return_inverse=True)
    a, b = index[: len(a)], index[len(a) :]
    xy = np.c_[left + size * (names % wide), top + size * (names // wide)]
    from scipy.sparse import coo_matrix
    from scipy.sparse.csgraph import connected_components

    graph = coo_matrix((np.ones(len(a)), (a, b)), shape=(len(names), len(names)))
    count, part = connected_components(graph, directed=False)
    ea, eb = np.concatenate([a, a]), np.concatenate([b, b])
    kind = np.full(len(ea), LINE, np.int8)
    kind[len(a) :] = LINK  # the first leg of a pair is taken before any second one
    offsets, edge = adjacency(len(names), ea, eb)
    left_parts = list(range(count))
    here = start
    parts: list[Stitches] = []
    while left_parts:
        if here is None:
            p, begin = left_parts[0], int(np.flatnonzero(part == left_parts[0])[0])
        else:
            mine = np.flatnonzero(np.isin(part, left_parts))
            begin = int(mine[np.argmin(((xy[mine] - np.array(here)) ** 2).sum(1))])
            p = int(part[begin])
        left_parts.remove(p)
        _tour, froms = euler(begin, ea, eb, np.ones(len(ea)), kind, offsets, edge)
        line = np.concatenate([xy[froms], xy[[begin]]])
        if parts:
            link = line_stitches(way(rings, parts[-1].xy[-1], line[0]), 3.0, TRAVEL, 0.04)
            parts.append(Stitches(link.xy[1:], link.kind[1:], link.run[1:]))
        made = Stitches.of(line, FILL, per_stitch=True)
        parts.append(Stitches(made.xy[1:], made.kind[1:], made.run[1:]) if parts else made)
        here = (float(line[-1, 0]), float(line[-1, 1]))
    return join(parts)

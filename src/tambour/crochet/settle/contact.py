"""Contact: fabric that is not joined does not pass through itself, nor parts through one another.

Every two nodes without an edge between them push each other apart once nearer than a reach: that of fabric against
fabric, or the smaller one of nodes two or three edges apart, which lie in the same stretch of fabric.
"""

from __future__ import annotations

import math

import numpy as np

from tambour.core.arrays import F8x1, F8x2, I4x1, I4x2, I8x1, I8x2
from tambour.core.check import Array
from tambour.core.kernels import inner, kernel
from tambour.core.threads import share

BESIDE = 0.25
"""How far beside a triangle, in shares of it, a stitch still lies on it."""
BLOCK = 2048
"""Nodes whose pairs are looked for at once."""


@kernel
def about(offsets: I8x1, neighbours: I4x1) -> tuple[Array, Array]:
    """Of every node i the nodes j < i fewer than four edges away, as ragged lists: (N + 1,), (K,), ~j where it is one edge.

    Neighbours that are sewn stand as ~node: they are one edge away, but nothing is reached through them.
    """
    n = len(offsets) - 1
    starts, out = np.zeros(n + 1, np.int64), np.empty(16 * n, np.int32)
    named, queue, found = np.full(n, -1, np.int32), np.empty(n + 1, np.int32), 0
    for i in range(n):
        if found + i > len(out):
            out = np.concatenate((out, np.empty(found + i, np.int32)))
        queue[0], named[i], begin, end = i, i, 0, 1
        for far in range(3):
            upto = end
            for q in range(begin, upto):
                for k in range(offsets[queue[q]], offsets[queue[q] + 1]):
                    j = neighbours[k]
                    if j >= 0 and named[j] != i:
                        named[j], queue[end] = i, j
                        end += 1
                        if j < i:
                            out[found] = ~j if far == 0 else j
                            found += 1
            begin = upto
        for k in range(offsets[i], offsets[i + 1]):  # last, for what is next to a node may be found another way
            if neighbours[k] < 0 and ~neighbours[k] < i:
                if found == len(out):
                    out = np.concatenate((out, np.empty(found, np.int32)))
                out[found] = neighbours[k]
                found += 1
        starts[i + 1] = found
    return starts, out[:found].copy()


@inner
def _sorted(key: I8x1) -> Array:
    """The order of whole numbers, equal ones as they stand: eleven bits at a time."""
    n, most = len(key), key.max()
    order, other, shift = np.arange(n), np.empty(n, np.int64), 0
    while most >> shift:
        begins = np.zeros(2049, np.int64)
        for i in range(n):
            begins[((key[i] >> shift) & 2047) + 1] += 1
        for k in range(2048):
            begins[k + 1] += begins[k]
        for p in range(n):
            k = (key[order[p]] >> shift) & 2047
            other[begins[k]] = order[p]
            begins[k] += 1
        order, other = other, order
        shift += 11
    return order


@kernel
def _cells(x: F8x2, cell: float) -> tuple[Array, Array, Array, Array]:
    """Nodes in the order of their cells (N,), which cell each lies in (N,), and of the nine rows of three cells about each cell from where (C, 9) to
    where (C, 9) they go in that order."""
    n = len(x)
    low, high = np.empty(3), np.empty(3)
    for q in range(3):
        low[q], high[q] = x[:, q].min(), x[:, q].max()
    # Far-flung nodes share cells rather than overflow a key.
    while ((high - low) / cell).max() > 1e5:
        cell *= 2.0
    nx, ny = int((high[0] - low[0]) / cell) + 3, int((high[1] - low[1]) / cell) + 3
    key = np.empty(n, np.int64)
    for i in range(n):
        u, v, w = (x[i, 0] - low[0]) / cell, (x[i, 1] - low[1]) / cell, (x[i, 2] - low[2]) / cell
        key[i] = ((int(w) + 1) * ny + int(v) + 1) * nx + int(u) + 1
    order = _sorted(key)
    ranked = key[order]
    # Cells and rows are walked along side by side.
    cell_of, cells = np.empty(n, np.int64), np.empty(n, np.int64)
    count = 0
    for k in range(n):
        if k == 0 or ranked[k] != ranked[k - 1]:
            cells[count] = ranked[k]
            count += 1
        cell_of[order[k]] = count - 1
    begins, ends = np.empty((count, 9), np.int64), np.empty((count, 9), np.int64)
    for row in range(9):
        middle = ((row // 3 - 1) * ny + row % 3 - 1) * nx
        begin = end = 0
        for c in range(count):
            while begin < n and ranked[begin] < cells[c] + middle - 1:
                begin += 1
            while end < n and ranked[end] <= cells[c] + middle + 1:
                end += 1
            begins[c, row], ends[c, row] = begin, end
    return order, cell_of, begins, ends


@kernel
def _listed(
    x: F8x2,
    starts: I8x1,
    about: I4x1,
    far: float,
    near: float,
    order: I8x1,
    cell_of: I8x1,
    begins: I8x2,
    ends: I8x2,
    first: int,
    last: int,
    out: I4x2,
    reach: F8x1,
    skin: float,
) -> int:
    """The pairs of nodes i from ``first`` to ``last``, as of :func:`pairs`; gives how many there are: only so many as there is room for are filled in."""
    found, n = 0, len(x)
    named = np.full(n, -1, np.int64)  # i: few edges from node i; -2 - i: next to it
    for i in range(first, last):
        c = cell_of[i]
        for k in range(starts[i], starts[i + 1]):
            j = about[k]
            if j < 0:
                named[~j] = -2 - i
            else:
                named[j] = i
        for row in range(9):
            for k in range(begins[c, row], ends[c, row]):
                j = order[k]
                if j >= i:
                    continue
                dx, dy, dz = x[i, 0] - x[j, 0], x[i, 1] - x[j, 1], x[i, 2] - x[j, 2]
                r2 = dx * dx + dy * dy + dz * dz
                if r2 >= (far + skin) ** 2:
                    continue
                h = near if named[j] == i else far
                if named[j] == -2 - i or r2 >= (h + skin) ** 2:
                    continue
                if found < len(out):
                    out[found, 0], out[found, 1], reach[found] = i, j, h
                found += 1
    return found


def pairs(
    x: Array,
    offsets: Array,
    neighbours: Array,
    far: float,
    near: float,
    skin: float,
    known: tuple[Array, Array] | None = None,
) -> tuple[Array, Array]:
    """The pairs i > j (M, 2) that may touch before anything has moved half the ``skin``, and the reach (M,) of each.

    x : (N, 3); offsets, neighbours : the edges as ragged lists, each rising; far, near : the two reaches, near for what is two or three edges apart
    known : what is :func:`about` each node, if that was asked before
    """
    if not len(x):
        return np.zeros((0, 2), np.int32), np.zeros(0)
    told, known = _cells(x, far + skin), about(offsets, neighbours) if known is None else known
    found: dict[int, tuple[Array, Array]] = {}

    def look(a: int, b: int) -> None:
        asked, size = (x, *known, far, near, *told, a, b), 4 * (b - a)
        while a not in found:
            out, reach = np.empty((size, 2), np.int32), np.empty(size)
            size = int(_listed(*asked, out, reach, skin))
            if size <= len(out):
                found[a] = out[:size], reach[:size]

    share(len(x), BLOCK, look)
    made = [found[a] for a in sorted(found)]
    return np.concatenate([out for out, _ in made]), np.concatenate([reach for _, reach in made])


@kernel
def strayed(x: F8x2, before: F8x2) -> float:
    """The square of the farthest that a node has moved since ``before``."""
    most = 0.0
    for i in range(len(x)):
        dx, dy, dz = x[i, 0] - before[i, 0], x[i, 1] - before[i, 1], x[i, 2] - before[i, 2]
        most = max(most, dx * dx + dy * dy + dz * dz)
    return most


@kernel
def contact(x: F8x2, pair: I4x2, reach: F8x1, stiffness: float, D: F8x2) -> None:
    """Add the contact of listed pairs: stiffness * (reach - r) apart where r < reach."""
    for k in range(len(pair)):
        i, j = pair[k, 0], pair[k, 1]
        dx, dy, dz = x[i, 0] - x[j, 0], x[i, 1] - x[j, 1], x[i, 2] - x[j, 2]
        r2 = dx * dx + dy * dy + dz * dz
        if r2 >= reach[k] * reach[k] or r2 == 0.0:
            continue
        r = math.sqrt(r2)
        s = stiffness * (reach[k] - r) / r
        dx, dy, dz = dx * s, dy * s, dz * s
        D[i, 0] += dx
        D[i, 1] += dy
        D[i, 2] += dz
        D[j, 0] -= dx
        D[j, 1] -= dy
        D[j, 2] -= dz


@kernel
def lie(x: F8x2, lying: I4x2, height: float, stiffness: float, D: F8x2) -> None:
    """Keep stitches of a seam outside of the fabric that they are sewn to: ``height`` above the triangles near them.

    lying : (K, 4) a stitch and the corners of a triangle, counter-clockwise outside. A stitch over the triangle, but
    lower, is pushed out along its normal and the corners back; just beside it, less.
    """
    w, n = np.empty(3), np.empty(3)
    for k in range(len(lying)):
        r, a, b, c = lying[k, 0], lying[k, 1], lying[k, 2], lying[k, 3]
        ux, uy, uz = x[b, 0] - x[a, 0], x[b, 1] - x[a, 1], x[b, 2] - x[a, 2]
        vx, vy, vz = x[c, 0] - x[a, 0], x[c, 1] - x[a, 1], x[c, 2] - x[a, 2]
        n[0], n[1], n[2] = uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx
        area2 = n[0] * n[0] + n[1] * n[1] + n[2] * n[2]
        if area2 == 0.0:
            continue
        px, py, pz = x[r, 0] - x[a, 0], x[r, 1] - x[a, 1], x[r, 2] - x[a, 2]
        size = math.sqrt(area2)
        above = (px * n[0] + py * n[1] + pz * n[2]) / size
        if above >= height:
            continue
        # Shares of the corners in the point under the stitch.
        w[1] = ((py * vz - pz * vy) * n[0] + (pz * vx - px * vz) * n[1] + (px * vy - py * vx) * n[2]) / area2
        w[2] = ((uy * pz - uz * py) * n[0] + (uz * px - ux * pz) * n[1] + (ux * py - uy * px) * n[2]) / area2
        w[0] = 1.0 - w[1] - w[2]
        over = min(min(w[0], w[1]), w[2])
        if over <= -BESIDE:
            continue
        s = stiffness * (height - above) / size * min(1.0, 1.0 + over / BESIDE)
        for q in range(3):
            D[r, q] += s * n[q]
            D[a, q] -= w[0] * s * n[q]
            D[b, q] -= w[1] * s * n[q]
            D[c, q] -= w[2] * s * n[q]


def ragged(n: int, edges: Array, sewn: Array) -> tuple[Array, Array]:
    """The edges (E, 2) as ragged lists of neighbours, each rising: offsets (n + 1,), neighbours (2E,).

    sewn : (E,) bool; across a seam the neighbour stands as ~node: it is joined, but what is next to it is not.
    """
    far = np.where(np.concatenate([sewn, sewn]), ~np.concatenate([edges[:, 1], edges[:, 0]]), 0)
    both = np.concatenate([edges, edges[:, ::-1]]).astype(np.int64)
    both[:, 1] = np.where(far < 0, far, both[:, 1])
    both = both[np.lexsort((both[:, 1], both[:, 0]))]
    offsets = np.zeros(n + 1, np.int64)
    np.cumsum(np.bincount(both[:, 0], minlength=n), out=offsets[1:])
    return offsets, np.ascontiguousarray(both[:, 1], dtype=np.int32)

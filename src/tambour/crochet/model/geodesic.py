"""Geodesic: distances along a surface from a point, and the lines of a surface where a value is met.

Kimmel and Sethian, "Computing geodesic paths on manifolds" (1998): a front marches over the triangles, each of which
tells its third corner what a wave from a point would; here a corner that finds a shorter way later is told again.
"""

from __future__ import annotations

import math

import numpy as np

from tambour.core.arrays import F8x1, F8x2, I4x2, I8x1, I8x2
from tambour.core.check import Array
from tambour.core.kernels import kernel

NEARER = 1e-6
"""A way that is shorter by less than this share is no shorter: on triangles like needles fronts would go on for ever."""


def about(faces: Array, count: int) -> tuple[Array, Array]:
    """The faces about every one of ``count`` vertices: offsets (V + 1,) and faces."""
    flat = faces.ravel().astype(np.int64)
    order = np.argsort(flat, kind="stable") // 3
    return np.concatenate([[0], np.cumsum(np.bincount(flat, minlength=count))]), order.astype(np.int64)


@kernel
def _third(ab: float, ac: float, bc: float, da: float, db: float) -> float:
    """What a wave that met corners a and b at distances da and db needs to c; the sides' lengths are ab, ac, bc."""
    best = min(da + ac, db + bc)
    if ab <= 0.0:
        return best
    cx = (ac * ac - bc * bc + ab * ab) / (2.0 * ab)
    cy2 = ac * ac - cx * cx
    sx = (da * da - db * db + ab * ab) / (2.0 * ab)
    sy2 = da * da - sx * sx
    if cy2 <= 0.0 or sy2 < 0.0:
        return best
    cy, sy = math.sqrt(cy2), math.sqrt(sy2)
    at = sx + (cx - sx) * sy / (cy + sy)
    if at < 0.0 or at > ab:
        return best
    return min(best, math.sqrt((cx - sx) * (cx - sx) + (cy + sy) * (cy + sy)))


@kernel
def _march(
    x: F8x2, faces: I4x2, offsets: I8x1, near: I8x1, far: float, d: F8x1, heap: I8x1, key: F8x1, count: int
) -> None:
    """Fill d (V,), infinite but at the sources, with distances up to ``far``. heap, key : room, with ``count`` sources."""
    size, room = count, len(heap)
    for k in range(count):  # sources are few: a heap by insertion
        i = k
        while i > 0 and key[(i - 1) // 2] > key[i]:
            p = (i - 1) // 2
            heap[i], heap[p] = heap[p], heap[i]
            key[i], key[p] = key[p], key[i]
            i = p
    while size > 0:
        v, dv = heap[0], key[0]
        size -= 1
        heap[0], key[0] = heap[size], key[size]
        i = 0
        while True:
            c = 2 * i + 1
            if c >= size:
                break
            if c + 1 < size and key[c + 1] < key[c]:
                c += 1
            if key[i] <= key[c]:
                break
            heap[i], heap[c] = heap[c], heap[i]
            key[i], key[c] = key[c], key[i]
            i = c
        if dv > d[v] or dv > far:
            continue
        for e in range(offsets[v], offsets[v + 1]):
            f = near[e]
            for k in range(3):
                c = faces[f, k]
                if c == v:
                    continue
                b = faces[f, 0] + faces[f, 1] + faces[f, 2] - v - c
                ux, uy, uz = x[c, 0] - x[v, 0], x[c, 1] - x[v, 1], x[c, 2] - x[v, 2]
                vc = math.sqrt(ux * ux + uy * uy + uz * uz)
                new = dv + vc
                if d[b] < np.inf:
                    wx, wy, wz = x[b, 0] - x[v, 0], x[b, 1] - x[v, 1], x[b, 2] - x[v, 2]
                    zx, zy, zz = x[b, 0] - x[c, 0], x[b, 1] - x[c, 1], x[b, 2] - x[c, 2]
                    vb = math.sqrt(wx * wx + wy * wy + wz * wz)
                    bc = math.sqrt(zx * zx + zy * zy + zz * zz)
                    new = min(new, _third(vb, vc, bc, dv, d[b]))
                if new < d[c] - NEARER * (1.0 + new) and size < room:
                    d[c] = new
                    i = size
                    heap[i], key[i] = c, new
                    size += 1
                    while i > 0 and key[(i - 1) // 2] > key[i]:
                        p = (i - 1) // 2
                        heap[i], heap[p] = heap[p], heap[i]
                        key[i], key[p] = key[p], key[i]
                        i = p


def distances(
    vertices: Array, faces: Array, sources: Array, known: tuple[Array, Array] | None = None, far: float = math.inf
) -> Array:
    """The way (V,) along the surface to the nearest of ``sources`` (vertices), infinite where there is none.

    known : what :func:`about` gives, if there; far : ways longer than this need not be right
    """
    offsets, near = about(faces, len(vertices)) if known is None else known
    sources = np.atleast_1d(np.asarray(sources, np.int64))
    room = 8 * len(faces) + len(sources) + 64
    heap, key = np.zeros(room, np.int64), np.zeros(room)
    heap[: len(sources)] = sources
    d = np.full(len(vertices), np.inf)
    d[sources] = 0.0
    x = np.ascontiguousarray(vertices, np.float64)
    _march(x, np.ascontiguousarray(faces, np.int32), offsets, near, far, d, heap, key, len(sources))
    return d


@kernel
def _link(first: I8x1, second: I8x1, other: I8x2, made: I8x1, ends: I8x1) -> int:
    """Chain segments into loops: segment s leads from crossing first[s] to second[s].

    other : (C, 2) room for the two segments of every crossing, -1 at first; made : (2 S,) the crossings in order of the
    loops, of a line that is open one more than it has segments; ends : (S,) where each loop ends. Gives how many loops there are.
    """
    for s in range(len(first)):
        for c in (first[s], second[s]):
            other[c, 0 if other[c, 0] < 0 else 1] = s
    used = np.zeros(len(first), np.int64)
    count, at = 0, 0
    for begin in range(len(first)):
        if used[begin]:
            continue
        s, c = begin, second[begin]
        made[at] = first[begin]
        at += 1
        used[begin] = 1
        while c != first[begin]:
            made[at] = c
            at += 1
            n = other[c, 0] if other[c, 0] != s else other[c, 1]
            if n < 0 or used[n]:
                break
            used[n] = 1
            c = first[n] + second[n] - c
            s = n
        ends[count] = at
        count += 1
    return count


def lines(vertices: Array, faces: Array, f: Array, value: float) -> list[Array]:
    """The closed lines (K, 3) where ``f`` (V,) is ``value``, those of more than two points; higher f lies on their left
    as seen from outside."""
    low = f < value
    one, two, three = (low[faces[:, k]] for k in range(3))  # by columns: rows of three are slow to reduce
    mixed = np.flatnonzero((one != two) | (two != three))
    if not len(mixed):
        return []
    tri, below = faces[mixed].astype(np.int64), np.column_stack([one, two, three])[mixed]
    # The corner that is alone on its side comes first; the line runs so that higher f is on its left.
    alone = np.where(below.sum(1) == 1, below.argmax(1), (~below).argmax(1))
    rows = np.arange(len(tri))
    a, b, c = tri[rows, alone], tri[rows, (alone + 1) % 3], tri[rows, (alone + 2) % 3]
    up = ~low[a]
    n = len(vertices)
    ab, ca = np.minimum(a, b) * n + np.maximum(a, b), np.minimum(a, c) * n + np.maximum(a, c)
    key, place = np.unique(np.concatenate([ab, ca]), return_inverse=True)
    first, second = (
        np.where(up, place[: len(tri)], place[len(tri) :]),
        np.where(up, place[len(tri) :], place[: len(tri)]),
    )
    p, q = np.divmod(key, n)
    share = ((value - f[p]) / (f[q] - f[p]))[:, None]
    points = vertices[p] + np.clip(share, 0.0, 1.0) * (vertices[q] - vertices[p])
    made, ends = np.zeros(2 * len(first), np.int64), np.zeros(len(first), np.int64)
    count = _link(first, second, np.full((len(key), 2), -1, np.int64), made, ends)
    begins = np.concatenate([[0], ends[: count - 1]])
    return [points[made[i:j]] for i, j in zip(begins, ends[:count]) if j - i > 2]


def girth(line: Array) -> float:
    """The length of a closed line (K, 3)."""
    return float(np.sqrt(((line - np.roll(line, -1, 0)) ** 2).sum(1)).sum())

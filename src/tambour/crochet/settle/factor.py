"""Factor: a sparse symmetric matrix as L D Lᵀ, by kernels of our own, so that every sum has one order everywhere.

Nested dissection (George 1973) orders the nodes: the middle level of a breadth-first search parts the fabric in two,
and so on; the separators come last. The factor is taken row by row (Davis 2005, "LDL: a concise sparse Cholesky").
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from tambour.core.arrays import F8x1, I4x1, I8x1
from tambour.core.check import Array
from tambour.core.kernels import inner, kernel

LEAF = 24
"""Pieces of so few nodes are parted no further."""
WIDE = 4
"""Columns with the same rows that are solved for at once."""


@kernel
def _levels(offsets: Array, neighbours: Array, begin: int, region: Array, name: int, queue: Array, level: Array) -> int:
    """Breadth first from ``begin`` through the nodes of a region: fills queue and level, gives how many it reached."""
    queue[0], level[begin], done, end = begin, 0, 0, 1
    region[begin] = ~name
    while done < end:
        i = queue[done]
        done += 1
        for k in range(offsets[i], offsets[i + 1]):
            j = neighbours[k]
            if region[j] == name:
                region[j] = ~name
                level[j] = level[i] + 1
                queue[end] = j
                end += 1
    for k in range(end):
        region[queue[k]] = name
    return end


@kernel
def dissect(offsets: I8x1, neighbours: I4x1) -> Array:
    """The order (N,) in which nodes are eliminated so that the factor stays sparse; edges as ragged lists."""
    n = len(offsets) - 1
    order, queue, level = np.arange(n), np.empty(n, np.int64), np.zeros(n, np.int64)
    region, names = np.zeros(n, np.int64), 1
    low, high = np.empty(2 * n + 2, np.int64), np.empty(2 * n + 2, np.int64)
    low[0], high[0], depth = 0, n, 1
    while depth:
        depth -= 1
        a, b = low[depth], high[depth]
        if b - a <= LEAF:
            continue
        name = region[order[a]]
        begin = order[a]
        for _ in range(2):  # from the far end of a first search, and once more
            found = _levels(offsets, neighbours, begin, region, name, queue, level)
            begin = queue[found - 1]
        if found < b - a:  # not all hangs together: what was reached, then the rest
            names += 1
            for k in range(found):
                region[queue[k]] = names
            left, right = found, b - a - found
            at = found
            for k in range(a, b):
                if region[order[k]] != names:
                    queue[at] = order[k]
                    at += 1
            order[a:b] = queue[: b - a]
        else:
            found = _levels(offsets, neighbours, begin, region, name, queue, level)
            last = level[queue[found - 1]]
            if last < 2:
                continue
            # The smallest level among those that leave each side a third, else the one in the middle.
            middle, best, k = level[queue[found // 2]], found, 0
            while k < found:
                m = level[queue[k]]
                e = k
                while e < found and level[queue[e]] == m:
                    e += 1
                if 3 * k >= found and 3 * (found - e) >= found and e - k < best:
                    middle, best = m, e - k
                k = e
            middle = min(max(middle, 1), last - 1)
            names += 2
            left, right, cut = 0, 0, 0
            for k in range(found):
                i = queue[k]
                if level[i] > middle:
                    region[i] = names
                    right += 1
                    continue
                beyond = False
                if level[i] == middle:
                    for q in range(offsets[i], offsets[i + 1]):
                        j = neighbours[q]
                        if region[j] == names or (region[j] == name and level[j] > middle):
                            beyond = True
                if beyond:
                    region[i] = -1
                    cut += 1
                else:
                    region[i] = names - 1
                    left += 1
            p, q, r = a, a + left, a + left + right
            for k in range(found):
                i = queue[k]
                if region[i] == names - 1:
                    order[p] = i
                    p += 1
                elif region[i] == names:
                    order[q] = i
                    q += 1
                else:
                    order[r] = i
                    r += 1
        for begin_, count in ((a, left), (a + left, right)):
            if count:
                low[depth], high[depth] = begin_, begin_ + count
                depth += 1
    return order


@kernel
def _columns(offsets: I8x1, neighbours: I4x1, order: I8x1, parent: I8x1, start: I8x1) -> None:
    """The elimination tree ``parent`` (N,) and where every column of L begins (N + 1,)."""
    n = len(order)
    place, flag = np.empty(n, np.int64), np.empty(n, np.int64)
    for k in range(n):
        place[order[k]] = k
    start[:] = 0
    for k in range(n):
        parent[k], flag[k] = -1, k
        for q in range(offsets[order[k]], offsets[order[k] + 1]):
            i = place[neighbours[q]]
            while i < k and flag[i] != k:
                if parent[i] < 0:
                    parent[i] = k
                start[i + 1] += 1
                flag[i] = k
                i = parent[i]
    for k in range(n):
        start[k + 1] += start[k]


@kernel
def _numbers(
    offsets: I8x1,
    neighbours: I4x1,
    weight: F8x1,
    diagonal: F8x1,
    order: I8x1,
    parent: I8x1,
    start: I8x1,
    row: I4x1,
    value: F8x1,
    pivot: F8x1,
) -> None:
    """L by columns (row, value; unit diagonal) and the pivots D (N,), of a matrix with -weight beside its diagonal."""
    n = len(order)
    place, flag, filled = np.empty(n, np.int64), np.full(n, -1), start[:n].copy()
    pattern, walk, y = np.empty(n, np.int64), np.empty(n, np.int64), np.zeros(n)
    for k in range(n):
        place[order[k]] = k
    for k in range(n):
        top = n
        flag[k] = k
        pivot[k] = diagonal[order[k]]
        for q in range(offsets[order[k]], offsets[order[k] + 1]):
            i = place[neighbours[q]]
            if i > k:
                continue
            y[i] -= weight[q]
            length = 0
            while flag[i] != k:
                walk[length] = i
                length += 1
                flag[i] = k
                i = parent[i]
            while length:
                top -= 1
                length -= 1
                pattern[top] = walk[length]
        for t in range(top, n):
            i = pattern[t]
            yi = y[i]
            y[i] = 0.0
            for p in range(start[i], filled[i]):
                y[row[p]] -= value[p] * yi
            lower = yi / pivot[i]
            pivot[k] -= lower * yi
            row[filled[i]], value[filled[i]] = k, lower
            filled[i] += 1


@kernel
def _blocks(parent: I8x1, start: I8x1, first: I8x1) -> int:
    """Where blocks of WIDE columns begin, or of one, (N + 1,) in ``first``; how many there are. Columns of a block have the same rows
    below it, as those of a separator do, and each its successors in the block above them."""
    n, k, found = len(parent), 0, 0
    while k < n:
        wide = 1
        while wide < WIDE and k + wide < n and parent[k + wide - 1] == k + wide:
            before, after = start[k + wide] - start[k + wide - 1], start[k + wide + 1] - start[k + wide]
            if before != after + 1:
                break
            wide += 1
        first[found] = k
        found += 1
        k += wide if wide == WIDE else 1
    first[found] = n
    return found


@kernel
def solve(
    start: I8x1, row: I4x1, value: F8x1, pivot: F8x1, order: I8x1, first: I8x1, blocks: int, q: F8x1, z: F8x1
) -> None:
    """Solve for three columns: q and z (3 N,), a node's three values in a row; four, one of them nothing, are reckoned
    side by side."""
    n = len(order)
    y = np.zeros((n, 4))
    for k in range(n):
        i = 3 * order[k]
        y[k, 0], y[k, 1], y[k, 2] = q[i], q[i + 1], q[i + 2]
    for block in range(blocks):
        k = first[block]
        if first[block + 1] == k + 1:
            _down(start, row, value, y, k)
            continue
        for c in range(WIDE - 1):
            for d in range(c + 1, WIDE):
                v = value[start[k + c] + d - c - 1]
                for t in range(4):
                    y[k + d, t] -= v * y[k + c, t]
        a0, a1, a2, a3 = y[k, 0], y[k, 1], y[k, 2], y[k, 3]
        b0, b1, b2, b3 = y[k + 1, 0], y[k + 1, 1], y[k + 1, 2], y[k + 1, 3]
        c0, c1, c2, c3 = y[k + 2, 0], y[k + 2, 1], y[k + 2, 2], y[k + 2, 3]
        d0, d1, d2, d3 = y[k + 3, 0], y[k + 3, 1], y[k + 3, 2], y[k + 3, 3]
        p, r, s, u = start[k] + 3, start[k + 1] + 2, start[k + 2] + 1, start[k + 3]
        for e in range(start[k + 4] - u):
            i, va, vb, vc, vd = np.uint64(row[u + e]), value[p + e], value[r + e], value[s + e], value[u + e]
            y0 = y[i, 0] - va * a0 - vb * b0 - vc * c0 - vd * d0
            y1 = y[i, 1] - va * a1 - vb * b1 - vc * c1 - vd * d1
            y2 = y[i, 2] - va * a2 - vb * b2 - vc * c2 - vd * d2
            y3 = y[i, 3] - va * a3 - vb * b3 - vc * c3 - vd * d3
            y[i, 0], y[i, 1], y[i, 2], y[i, 3] = y0, y1, y2, y3
    for k in range(n):
        for t in range(4):
            y[k, t] /= pivot[k]
    for block in range(blocks - 1, -1, -1):
        k = first[block]
        if first[block + 1] == k + 1:
            _up(start, row, value, y, k)
            continue
        a0, a1, a2, a3 = y[k, 0], y[k, 1], y[k, 2], y[k, 3]
        b0, b1, b2, b3 = y[k + 1, 0], y[k + 1, 1], y[k + 1, 2], y[k + 1, 3]
        c0, c1, c2, c3 = y[k + 2, 0], y[k + 2, 1], y[k + 2, 2], y[k + 2, 3]
        d0, d1, d2, d3 = y[k + 3, 0], y[k + 3, 1], y[k + 3, 2], y[k + 3, 3]
        p, r, s, u = start[k] + 3, start[k + 1] + 2, start[k + 2] + 1, start[k + 3]
        for e in range(start[k + 4] - u):
            i, va, vb, vc, vd = np.uint64(row[u + e]), value[p + e], value[r + e], value[s + e], value[u + e]
            y0, y1, y2, y3 = y[i, 0], y[i, 1], y[i, 2], y[i, 3]
            a0, a1, a2, a3 = a0 - va * y0, a1 - va * y1, a2 - va * y2, a3 - va * y3
            b0, b1, b2, b3 = b0 - vb * y0, b1 - vb * y1, b2 - vb * y2, b3 - vb * y3
            c0, c1, c2, c3 = c0 - vc * y0, c1 - vc * y1, c2 - vc * y2, c3 - vc * y3
            d0, d1, d2, d3 = d0 - vd * y0, d1 - vd * y1, d2 - vd * y2, d3 - vd * y3
        y[k, 0], y[k, 1], y[k, 2], y[k, 3] = a0, a1, a2, a3
        y[k + 1, 0], y[k + 1, 1], y[k + 1, 2], y[k + 1, 3] = b0, b1, b2, b3
        y[k + 2, 0], y[k + 2, 1], y[k + 2, 2], y[k + 2, 3] = c0, c1, c2, c3
        y[k + 3, 0], y[k + 3, 1], y[k + 3, 2], y[k + 3, 3] = d0, d1, d2, d3
        for c in range(WIDE - 2, -1, -1):
            for d in range(c + 1, WIDE):
                v = value[start[k + c] + d - c - 1]
                for t in range(4):
                    y[k + c, t] -= v * y[k + d, t]
    for k in range(n):
        i = 3 * order[k]
        z[i], z[i + 1], z[i + 2] = y[k, 0], y[k, 1], y[k, 2]


@inner
def _down(start: I8x1, row: I4x1, value: F8x1, y: Array, k: int) -> None:
    """Column ``k`` is done, and the rows below it are rid of it."""
    a0, a1, a2, a3 = y[k, 0], y[k, 1], y[k, 2], y[k, 3]
    for p in range(start[k], start[k + 1]):
        i, v = np.uint64(row[p]), value[p]
        y0, y1, y2, y3 = y[i, 0] - v * a0, y[i, 1] - v * a1, y[i, 2] - v * a2, y[i, 3] - v * a3
        y[i, 0], y[i, 1], y[i, 2], y[i, 3] = y0, y1, y2, y3


@inner
def _up(start: I8x1, row: I4x1, value: F8x1, y: Array, k: int) -> None:
    """The rows below column ``k`` are done, and it is rid of them."""
    a0, a1, a2, a3 = y[k, 0], y[k, 1], y[k, 2], y[k, 3]
    for p in range(start[k], start[k + 1]):
        i, v = np.uint64(row[p]), value[p]
        a0, a1, a2, a3 = a0 - v * y[i, 0], a1 - v * y[i, 1], a2 - v * y[i, 2], a3 - v * y[i, 3]
    y[k, 0], y[k, 1], y[k, 2], y[k, 3] = a0, a1, a2, a3


def factor(offsets: Array, neighbours: Array, weight: Array, diagonal: Array) -> Callable[[Array], Array]:
    """What solves A z = q for three columns, q and z (3 N,).

    offsets (N + 1,), neighbours (K,) : the pattern of A beside its diagonal, both halves, as ragged lists
    weight (K,) : A's values there are -weight; diagonal (N,); A must be symmetric and positive definite
    """
    n = len(diagonal)
    order = dissect(offsets, neighbours)
    parent, start = np.empty(n, np.int64), np.empty(n + 1, np.int64)
    _columns(offsets, neighbours, order, parent, start)
    row, value, pivot = np.empty(start[n], np.int32), np.empty(start[n]), np.empty(n)
    _numbers(offsets, neighbours, weight, diagonal, order, parent, start, row, value, pivot)

    first = np.empty(n + 1, np.int64)
    blocks = int(_blocks(parent, start, first))

    def solved(q: Array) -> Array:
        z = np.empty_like(q)
        solve(start, row, value, pivot, order, first, blocks, q, z)
        return z

    return solved

"""Near: which points lie nearest to which, and who takes which when each is to be taken once."""

from __future__ import annotations

import numpy as np

from tambour.core.arrays import F8x2, I8x1, I8x2
from tambour.core.check import Array
from tambour.core.kernels import kernel


def nearest(points: Array, there: Array, k: int = 1) -> tuple[Array, Array]:
    """For each of ``points`` (N, D) the ``k`` nearest of ``there`` (M, D), M ≥ k: distances and indices, (N, k) each.

    The nearest come first, of equally near ones those of the lower index.
    """
    points, there = (np.ascontiguousarray(p, np.float64) for p in (points, there))
    axis = int(np.ptp(there, axis=0).argmax())
    order = np.argsort(there[:, axis], kind="stable")
    index, square = np.zeros((len(points), k), np.int64), np.full((len(points), k), np.inf)
    _sweep(points, np.ascontiguousarray(there[order]), order, axis, index, square)
    return np.sqrt(square), index


@kernel
def _sweep(points: F8x2, there: F8x2, order: I8x1, axis: int, index: I8x2, square: F8x2) -> None:
    """``there`` rises along ``axis``: from each point's place both ways, until that axis alone is farther than all found."""
    most = index.shape[1] - 1
    for i in range(len(points)):
        x = points[i, axis]
        low, high = 0, len(there)
        while low < high:
            middle = (low + high) // 2
            if there[middle, axis] < x:
                low = middle + 1
            else:
                high = middle
        low -= 1
        while low >= 0 or high < len(there):
            down = x - there[low, axis] if low >= 0 else np.inf
            up = there[high, axis] - x if high < len(there) else np.inf
            at = low if down < up else high
            if min(down, up) ** 2 > square[i, most]:
                break
            if down < up:
                low -= 1
            else:
                high += 1
            far = 0.0
            for c in range(points.shape[1]):
                far += (points[i, c] - there[at, c]) ** 2
            place = most
            if far > square[i, place] or (far == square[i, place] and order[at] > index[i, place]):
                continue
            while place > 0 and (
                far < square[i, place - 1] or (far == square[i, place - 1] and order[at] < index[i, place - 1])
            ):
                square[i, place], index[i, place] = square[i, place - 1], index[i, place - 1]
                place -= 1
            square[i, place], index[i, place] = far, order[at]


def assigned(cost: Array) -> Array:
    """The column (M,) that each row of ``cost`` (M, N), M ≤ N, takes, no column twice, so that the sum is least.

    D. F. Crouse, "On implementing 2D rectangular assignment algorithms" (2016): shortest augmenting paths, a row at a time.
    """
    column = np.full(len(cost), -1, np.int64)
    _assign(np.ascontiguousarray(cost, np.float64), column)
    return column


@kernel
def _assign(cost: F8x2, column: I8x1) -> None:
    m, n = cost.shape
    row, path = np.full(n, -1, np.int64), np.full(n, -1, np.int64)
    u, v, shortest = np.zeros(m), np.zeros(n), np.zeros(n)
    seen, left = np.zeros(m, np.bool_), np.zeros(n, np.int64)
    for new in range(m):
        shortest[:] = np.inf
        seen[:] = False
        for j in range(n):
            left[j] = n - 1 - j
        count, far, i, sink = n, 0.0, new, -1
        while sink < 0:
            seen[i] = True
            best, place = np.inf, -1
            for k in range(count):
                j = left[k]
                reduced = far + cost[i, j] - u[i] - v[j]
                if reduced < shortest[j]:
                    shortest[j], path[j] = reduced, i
                if shortest[j] < best or (shortest[j] == best and row[j] < 0):
                    best, place = shortest[j], k
            far, j = best, left[place]
            count -= 1
            left[place], left[count] = left[count], j  # behind ``count`` lie those that were reached
            if row[j] < 0:
                sink = j
            else:
                i = row[j]
        u[new] += far
        for i in range(m):
            if seen[i] and i != new:
                u[i] += far - shortest[column[i]]
        for k in range(count, n):
            v[left[k]] -= far - shortest[left[k]]
        j = sink
        while j >= 0:  # every row on the path goes over to the column that reached it
            i = path[j]
            row[j], before = i, column[i]
            column[i] = j
            j = before

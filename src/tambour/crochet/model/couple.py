"""Couple: how the stitches of one round come to stand on those of the round below, where both are points of a surface."""

from __future__ import annotations

import numpy as np

from tambour.core.arrays import F8x2, I1x1, I8x2
from tambour.core.check import Array
from tambour.core.kernels import kernel

ORDER = ("sc", "inc", "dec", "inc3", "dec3")
"""The words, as the kernel numbers them."""
SPARE = 0.05
"""What an increase or a decrease costs, in square stitches, beside the way that its yarn goes."""


@kernel
def _couple(p: F8x2, q: F8x2, spare: float, threes: bool, made: I1x1, best: F8x2, how: I8x2) -> int:
    """The cheapest words from points p (n, 3) below to q (m, 3) above, both beginning at the seam; into made, their number out."""
    n, m = len(p), len(q)
    best[:] = np.inf
    best[0, 0] = 0.0
    for i in range(n + 1):
        for j in range(m + 1):
            if best[i, j] == np.inf:
                continue
            for w in range(5 if threes else 3):
                a = 1 if w != 2 else 2
                b = 1 if w != 1 else 2
                if w == 3:
                    b = 3
                if w == 4:
                    a, b = 3, 1
                if i + a > n or j + b > m:
                    continue
                cost = best[i, j] + (spare if w > 0 else 0.0) * (4.0 if w > 2 else 1.0)
                for s in range(a):
                    for t in range(b):
                        dx, dy, dz = p[i + s, 0] - q[j + t, 0], p[i + s, 1] - q[j + t, 1], p[i + s, 2] - q[j + t, 2]
                        cost += dx * dx + dy * dy + dz * dz
                if cost < best[i + a, j + b]:
                    best[i + a, j + b] = cost
                    how[i + a, j + b] = w
    if best[n, m] == np.inf:
        return -1
    i, j, k = n, m, 0
    while i > 0 or j > 0:
        w = how[i, j]
        made[k] = w
        k += 1
        i -= 1 if w not in (2, 4) else (2 if w == 2 else 3)
        j -= 1 if w not in (1, 3) else (2 if w == 1 else 3)
    return k


def couple(below: Array, above: Array) -> tuple[str, ...]:
    """The words that lead from the stitches at ``below`` (n, 3) to those at ``above`` (m, 3), n / 3 <= m <= 3 n."""
    n, m = len(below), len(above)
    threes = m > 2 * n or n > 2 * m
    made = np.zeros(n + m, np.int8)
    room, how = np.empty((n + 1, m + 1)), np.zeros((n + 1, m + 1), np.int64)
    p, q = np.ascontiguousarray(below, np.float64), np.ascontiguousarray(above, np.float64)
    count = _couple(p, q, SPARE, threes, made, room, how)
    return tuple(ORDER[w] for w in made[:count][::-1])

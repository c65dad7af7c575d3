"""Catch: where to trap a long float while knitting, so that it neither snags nor shows."""

from __future__ import annotations

import numpy as np

from tambour.core.arrays import B1x2, F4x2, I8x1
from tambour.core.kernels import kernel

CATCH, SAME, BESIDE, AGAIN, IDLE, UNEVEN = 4.0, 100.0, 4.0, 1.0, 3.0, 0.01
"""Cost of a catch; of one above a catch of the row below, beside one, above one two rows below; of one next to a stitch
of its own yarn; of a stretch of n stitches, times n²."""


@kernel
def mark(row: I8x1, start: I8x1, length: I8x1, absent: B1x2, limit: int, dear: F4x2, marks: B1x2) -> None:
    """Set the catches of floats (N,), ordered by row, in ``marks`` (R, C) bool.

    A dynamic programme over each float's stitches: cost[p] is the least cost of all that lies before a catch at p,
    the last catch being at most ``limit`` + 1 stitches away; position 0 is the stitch before the float and n + 1 the
    one after. ``absent`` (R, C) bool, or empty: cells without stitch, which are passed over. ``dear`` (R, C), or empty:
    what a catch costs more there.
    """
    width = marks.shape[1]
    columns = np.zeros(width + 1, np.int64)
    cost = np.zeros(width + 2)
    back = np.zeros(width + 2, np.int64)
    for i in range(len(row)):
        r, c, n = row[i], start[i], length[i]
        k = 0
        while k < n:
            if absent.size == 0 or not absent[r, c]:
                columns[k] = c
                k += 1
            c = c + 1 if c + 1 < width else 0
        for p in range(1, n + 2):
            own = 0.0
            if p <= n:
                c = columns[p - 1]
                own = CATCH + (dear[r, c] if dear.size else 0.0)
                if r > 0:
                    own += SAME * marks[r - 1, c]
                    if c > 0:
                        own += BESIDE * marks[r - 1, c - 1]
                    if c + 1 < width:
                        own += BESIDE * marks[r - 1, c + 1]
                if r > 1:
                    own += AGAIN * marks[r - 2, c]
            best, least = -1, np.inf
            for q in range(max(0, p - limit - 1), p):
                reach = cost[q] + UNEVEN * (p - q) ** 2
                if p - q == 1:
                    reach += IDLE
                if reach < least:
                    best, least = q, reach
            cost[p], back[p] = least + own, best
        p = back[n + 1]
        while p > 0:
            marks[r, columns[p - 1]] = True
            p = back[p]

"""Co-dithering of one face in two yarns, as its paper states it (Xu and McCann, Co-Dithering for Jacquard Knitting, 2025): a reference of ours.

Row by row from the top: the lawful row of least cost, exactly, by a shortest path over (yarn, stitches of it so far), then what it leaves
is diffused to the next row; what is wanted there is held within 0 and 1. The cost of a stitch is the squared distance of yarn and target in
linear light, or in Oklab. None of the authors' code is in it. With the linear cost it comes as near to our charts as a review found their
program to come (0.06 to 0.6 dB); of their Oklab cost the tables should be taken as a likeness.
"""

from __future__ import annotations

import numpy as np
from numba import njit

SHARES = (0.25, 0.5, 0.25)  # of a stitch's error to the three stitches below it


@njit(cache=False)
def chart(aim: np.ndarray, limit: int, oklab: bool) -> np.ndarray:
    """(R, C) uint8 of a target (R, C) float32 in linear light; runs of at most ``limit``, both yarns to both edges."""
    rows, stitches = aim.shape
    out = np.zeros((rows, stitches), np.uint8)
    error = np.zeros(stitches + 2, np.float32)
    below = np.zeros(stitches + 2, np.float32)
    want = np.zeros(stitches, np.float32)
    value = np.zeros((2, limit), np.float32)
    after = np.zeros((2, limit), np.float32)
    back = np.zeros((stitches, 2), np.uint8)  # how long the run of the other yarn was that ended before
    for k in range(rows):
        y = rows - 1 - k
        value[:] = 1e30
        for x in range(stitches):
            want[x] = min(max(aim[y, x] + error[x + 1], np.float32(0)), np.float32(1))
            if oklab:
                seen = np.sign(want[x]) * abs(want[x]) ** np.float32(1 / 3)
                dark, light = seen * seen, (seen - 1) * (seen - 1)
            else:
                dark, light = want[x] * want[x], (want[x] - 1) * (want[x] - 1)
            for c in range(2):
                price = light if c else dark
                best, at = np.float32(0 if x == 0 else 1e30), 0
                if x > 0:
                    for j in range(limit):
                        if value[1 - c, j] < best:
                            best, at = value[1 - c, j], j
                after[c, 0] = best + price
                back[x, c] = at
                for j in range(1, limit):
                    after[c, j] = value[c, j - 1] + price
            value[:] = after
        c, j = 0, 0
        for d in range(2):
            for i in range(limit):
                if value[d, i] < value[c, j]:
                    c, j = d, i
        for x in range(stitches - 1, -1, -1):
            out[y, x] = c
            if j == 0:
                j = int(back[x, c])
                c = 1 - c
            else:
                j -= 1
        below[:] = 0
        for x in range(stitches):
            rest = want[x] - out[y, x]
            for d in range(3):
                below[x + d] += np.float32(SHARES[d]) * rest
        error[:] = below
    return out

"""Diffused: each row as near to its tones as the law lets it be, exactly; what it cannot show is handed to the row below.

This is one face of co-dithering with its linear cost (Xu and McCann 2025): a stitch costs the squared distance of its yarn
and what is wanted there, a row is a shortest path, and half of what is left goes to the same stitch of the next row, a
quarter to either side. One pass over the chart, where the perceptual solver takes sweeps of a far wider path.
"""

from __future__ import annotations

import numpy as np

from tambour.core.arrays import B1x1, B1x2, F4x2, U1x2
from tambour.core.check import Array
from tambour.core.kernels import kernel
from tambour.knit.solve import exact
from tambour.knit.solve.floats import sequence
from tambour.knit.task import Task

UNIT = 1 << 30  # whole costs of a stitch that is the other yarn altogether: 2^30 of them are far from all there are


def solve(task: Task) -> Array:
    """(R, C) uint8: lawful (unless the task is soft), from the top row down. Raises TambourError when locked stitches leave
    a row no lawful way."""
    out = task.start.copy()
    failed = np.zeros(len(out), np.bool_)
    soft = np.int64(0) if task.soft is None else np.int64(round(task.soft * UNIT))
    cap = min(task.cap, 1 << 30)
    masks = task.knit, task.relaxed, task.locked, task.weights
    diffuse(task.tone, task.limit, task.free, cap, task.ring, soft, *masks, out, failed)
    exact.impossible(failed, task)
    return out


@kernel
def diffuse(
    tone: F4x2, f: int, free: bool, cap: int, ring: bool, soft: np.int64, knit: B1x2, relaxed: B1x2, locked: B1x2,
    weights: F4x2, out: U1x2, failed: B1x1,
) -> None:  # fmt: skip
    """See :func:`solve`; what is wanted of a stitch is held within 0 and 1, or what cannot be shown would pile up."""
    rows, stitches = tone.shape
    columns = np.zeros(stitches, np.int32)
    row = np.zeros(stitches, np.uint8)
    flip = np.zeros(stitches, np.int64)
    loose = np.zeros(stitches, np.bool_)
    found = np.zeros(stitches, np.uint8)
    back = np.zeros((stitches, 2 * (f + 4)), np.int16)
    want = np.zeros(stitches, np.float32)
    error = np.zeros(stitches + 2, np.float32)
    for y in range(rows - 1, -1, -1):
        n = sequence(y, stitches, knit, columns)
        for k in range(n):
            x = columns[k]
            want[x] = min(max(tone[y, x] + error[x + 1], np.float32(0)), np.float32(1))
            row[k] = want[x] > np.float32(0.5)
            weight = np.float32(weights[y, x]) if weights.size else np.float32(1)
            flip[k] = np.int64(abs(2 * np.float64(want[x]) - 1) * weight * UNIT)
            loose[k] = relaxed.size > 0 and relaxed[y, x]
            if locked.size and locked[y, x]:
                row[k] = out[y, x]
                flip[k] = np.int64(1) << 61
        error[:] = 0
        if n == 0:
            continue
        cost = (
            exact.solve_ring(row, flip, loose, n, f, soft, back, found)
            if ring
            else exact.solve_line(row, flip, loose, n, f, free, cap, soft, -1, back, found)
        )
        failed[y] = cost >= np.int64(1) << 60
        for k in range(n):
            x = columns[k]
            out[y, x] = found[k]
            rest = (want[x] - np.float32(found[k])) * np.float32(0.25)
            error[x] += rest
            error[x + 1] += 2 * rest
            error[x + 2] += rest

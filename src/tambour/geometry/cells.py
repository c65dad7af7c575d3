"""Which boxes touch which cells of a grid: the few that can matter at a place, found without asking all."""

from __future__ import annotations

import numpy as np

from tambour.core.arrays import F8x2, I4x1, I8x1
from tambour.core.kernels import kernel


@kernel
def touched(boxes: F8x2, x0: float, y0: float, cell: float, nx: int, ny: int) -> tuple[I8x1, I4x1]:
    """The boxes of every cell, rising within a cell: (C + 1,) offsets and (K,) indices, cell (column, row) at row · nx + column.

    boxes : (N, 4) left, top, right, bottom; one whose left is not at most its right is empty
    x0, y0, cell : the grid's corner and the side of its cells; boxes beyond it touch the cells at its rim
    nx, ny : columns and rows
    """
    offsets = np.zeros(nx * ny + 1, np.int64)
    items = np.empty(0, np.int32)
    at = offsets
    for turn in range(2):
        if turn == 1:
            for c in range(nx * ny):
                offsets[c + 1] += offsets[c]
            items = np.empty(offsets[nx * ny], np.int32)
            at = offsets[:-1].copy()
        for k in range(len(boxes)):
            if not boxes[k, 0] <= boxes[k, 2]:
                continue
            left, right = max(0, int((boxes[k, 0] - x0) / cell)), min(nx - 1, int((boxes[k, 2] - x0) / cell))
            top, bottom = max(0, int((boxes[k, 1] - y0) / cell)), min(ny - 1, int((boxes[k, 3] - y0) / cell))
            for row in range(top, bottom + 1):
                for column in range(left, right + 1):
                    c = row * nx + column
                    if turn == 0:
                        offsets[c + 1] += 1
                    else:
                        items[at[c]] = k
                        at[c] += 1
    return offsets, items

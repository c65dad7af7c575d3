"""How high a stitch lies: on the cloth, or on thread that was laid before it."""

from __future__ import annotations

import numpy as np

from tambour.core.check import Array
from tambour.core.kernels import kernel
from tambour.core.thread import STITCH, ThreadPlan

PRESSED = 0.6
"""Height of a layer of thread, in widths: what lies below is pressed flat."""


@kernel
def _pile(
    a: Array,
    b: Array,
    block: Array,
    thread: float,
    cell: float,
    x0: float,
    y0: float,
    top: Array,
    new: Array,
    out: Array,
) -> None:
    """Fill ``out`` with the height below each stitch a → b; stitches of one block do not lie on each other."""
    first = 0
    for s in range(len(a) + 1):
        if s == len(a) or block[s] != block[first]:
            # The block is laid: it becomes ground for what follows.
            for k in range(first, s):
                n = int(np.hypot(b[k, 0] - a[k, 0], b[k, 1] - a[k, 1]) / cell) + 1
                for i in range(n + 1):
                    x = a[k, 0] + (b[k, 0] - a[k, 0]) * i / n
                    y = a[k, 1] + (b[k, 1] - a[k, 1]) * i / n
                    r, c = int((y - y0) / cell), int((x - x0) / cell)
                    new[r, c] = max(new[r, c], out[k] + PRESSED * thread)
            for k in range(first, s):
                n = int(np.hypot(b[k, 0] - a[k, 0], b[k, 1] - a[k, 1]) / cell) + 1
                for i in range(n + 1):
                    x = a[k, 0] + (b[k, 0] - a[k, 0]) * i / n
                    y = a[k, 1] + (b[k, 1] - a[k, 1]) * i / n
                    r, c = int((y - y0) / cell), int((x - x0) / cell)
                    top[r, c] = max(top[r, c], new[r, c])
            first = s
        if s == len(a):
            break
        length = np.hypot(b[s, 0] - a[s, 0], b[s, 1] - a[s, 1])
        n = int(length / cell) + 1
        total = 0.0
        for i in range(n):
            x = a[s, 0] + (b[s, 0] - a[s, 0]) * (i + 0.5) / n
            y = a[s, 1] + (b[s, 1] - a[s, 1]) * (i + 0.5) / n
            # The highest of the cells beside: thread bridges gaps of its own width.
            r, c = int((y - y0) / cell), int((x - x0) / cell)
            high = 0.0
            for dr in range(-1, 2):
                for dc in range(-1, 2):
                    high = max(high, top[r + dr, c + dc])
            total += high
        out[s] = total / n


def elevation(plan: ThreadPlan, kind: Array, region: Array, thread: float) -> Array:
    """(N,) mm of thread below the stitch that ends at each point of the plan.

    Stitches of one region and kind in a row lie beside each other; a change of either begins a layer that may lie on
    all before it. A layer is ``PRESSED`` thread widths thick.
    """
    laid = np.flatnonzero((plan.command == STITCH) & np.r_[False, np.ones(len(plan) - 1, np.bool_)])
    made = np.zeros(len(plan))
    if not len(laid):
        return made
    a, b = np.ascontiguousarray(plan.xy[laid - 1]), np.ascontiguousarray(plan.xy[laid])
    # Rows of one fill before and after a travel are one layer: they are told apart by region and kind alone.
    ids = region[laid].astype(np.int64) * 64 + kind[laid]
    block = np.r_[0, np.cumsum(np.diff(ids) != 0)]
    cell = thread / 2
    low = np.minimum(a.min(axis=0), b.min(axis=0)) - 3 * cell
    size = np.maximum(a.max(axis=0), b.max(axis=0)) + 3 * cell - low
    shape = (int(size[1] / cell) + 2, int(size[0] / cell) + 2)
    if shape[0] * shape[1] > 50_000_000:  # metres of cloth: too wide for this map, all lies flat
        return made
    out = np.zeros(len(laid))
    _pile(a, b, block, thread, cell, float(low[0]), float(low[1]), np.zeros(shape), np.zeros(shape), out)
    made[laid] = out
    return made

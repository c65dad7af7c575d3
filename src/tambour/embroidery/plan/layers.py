"""How high a stitch lies: on the cloth, or on thread that was laid before it."""

from __future__ import annotations

import numpy as np

from tambour.core.arrays import F8x1, F8x2, I8x1
from tambour.core.check import Array
from tambour.core.kernels import kernel
from tambour.core.thread import STITCH, ThreadPlan

PRESSED = 0.6
"""Height of a layer of thread, in widths: what lies below is pressed flat."""


@kernel
def _pile(
    a: F8x2, b: F8x2, layer: I8x1, thread: float, cell: float, x0: float, y0: float, top: F8x2, out: F8x1
) -> None:
    """Fill ``out`` with the height below each stitch a → b; ``top`` (R, C) is the height of thread so far, zero."""
    whose = np.full(top.shape, -1, np.int64)
    way = np.zeros(top.shape)
    for s in range(len(a)):
        dx, dy = b[s, 0] - a[s, 0], b[s, 1] - a[s, 1]
        angle = np.arctan2(dy, dx)
        n = int(np.hypot(dx, dy) / cell) + 1
        total, most = 0.0, 0.0
        for i in range(n):
            x, y = a[s, 0] + dx * (i + 0.5) / n, a[s, 1] + dy * (i + 0.5) / n
            r, c = int((y - y0) / cell), int((x - x0) / cell)
            if whose[r, c] < 0:
                continue
            # In one layer only the middle of a stitch can lie across another (the sine of 25 degrees): its ends meet
            # the ends of its neighbours.
            end = min(i + 0.5, n - i - 0.5) * cell
            across = end > 2.5 * cell and abs(np.sin(angle - way[r, c])) > 0.4226
            if whose[r, c] != layer[s] or across:
                total += top[r, c]
                most = max(most, top[r, c])
        # Thread is stiff: it bridges between what holds it up.
        out[s] = 0.5 * (total / n + most)
        # Marked a quarter of its width to either side: half as wide as it is, so that it does not lift its neighbour.
        wx, wy = -np.sin(angle) * 0.5 * cell, np.cos(angle) * 0.5 * cell
        for i in range(2 * n):
            side = 1.0 if i % 2 == 0 else -1.0
            x, y = a[s, 0] + dx * (i // 2 + 0.5) / n + side * wx, a[s, 1] + dy * (i // 2 + 0.5) / n + side * wy
            r, c = int((y - y0) / cell), int((x - x0) / cell)
            top[r, c] = max(top[r, c], out[s] + PRESSED * thread)
            whose[r, c], way[r, c] = layer[s], angle


def elevation(plan: ThreadPlan, layer: Array, thread: float) -> Array:
    """(N,) mm of thread below the stitch that ends at each point of the plan.

    layer : (N,) whole numbers; stitches of one layer lie beside each other, unless they cross. A layer is ``PRESSED``
    thread widths thick.
    """
    laid = np.flatnonzero((plan.command == STITCH) & np.r_[False, np.ones(len(plan) - 1, np.bool_)])
    made = np.zeros(len(plan))
    if not len(laid):
        return made
    a, b = np.ascontiguousarray(plan.xy[laid - 1]), np.ascontiguousarray(plan.xy[laid])
    cell = thread / 2
    low = np.minimum(a.min(axis=0), b.min(axis=0)) - 2 * cell
    size = np.maximum(a.max(axis=0), b.max(axis=0)) + 2 * cell - low
    shape = (int(size[1] / cell) + 2, int(size[0] / cell) + 2)
    if shape[0] * shape[1] > 50_000_000:  # metres of cloth: too wide for this map, all lies flat
        return made
    out = np.zeros(len(laid))
    ids = np.asarray(layer, np.int64)[laid]
    _pile(a, b, ids, thread, cell, float(low[0]), float(low[1]), np.zeros(shape), out)
    made[laid] = _evened(out, ids)
    return made


def _evened(high: Array, layer: Array, reach: int = 6) -> Array:
    """Heights (S,) averaged over ``reach`` stitches before and after in the same layer: neighbours carry each other."""
    run = np.r_[0, np.flatnonzero(np.diff(layer)) + 1, len(layer)]
    begin = np.repeat(run[:-1], np.diff(run))
    past = np.repeat(run[1:], np.diff(run))
    at = np.arange(len(high))
    low, top = np.maximum(begin, at - reach), np.minimum(past, at + reach + 1)
    total = np.r_[0.0, np.cumsum(high)]
    return np.asarray((total[top] - total[low]) / (top - low))

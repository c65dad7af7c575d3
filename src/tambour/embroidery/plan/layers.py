"""How high a stitch lies: on the cloth, or on thread that was laid before it."""

from __future__ import annotations

import numpy as np

from tambour.core.arrays import F8x1, F8x2, I8x1
from tambour.core.check import Array
from tambour.core.kernels import kernel
from tambour.core.thread import STITCH, ThreadPlan
from tambour.embroidery.piece import LOCK, TRAVEL

PRESSED = 0.4
"""Height of a layer of thread, in widths: what lies below is pressed flat."""
FIELD = 0.5
"""mm, the cells in which the heights of a layer are evened."""
BRIDGE = 2.0
"""mm over which a layer of thread carries itself: what lies below it shows as a slow rise."""


@kernel
def _pile(
    a: F8x2,
    b: F8x2,
    layer: I8x1,
    least: F8x1,
    thread: float,
    cell: float,
    x0: float,
    y0: float,
    top: F8x2,
    out: F8x1,
) -> None:
    """Fill ``out`` with the height at which each stitch a → b lies, at least ``least``; ``top`` (R, C) is zero.

    Thread lies in sewing order: no stitch lies lower than what it was sewn over.
    """
    whose = np.full(top.shape, -1, np.int64)
    way = np.zeros(top.shape)
    for s in range(len(a)):
        dx, dy = b[s, 0] - a[s, 0], b[s, 1] - a[s, 1]
        angle = np.arctan2(dy, dx)
        n = int(np.hypot(dx, dy) / cell) + 1
        most = least[s]  # thread is stiff: the highest place below it holds up the whole stitch
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
                most = max(most, top[r, c])
        out[s] = most
        # Marked a quarter of its width to either side: half as wide as it is, so that it does not lift its neighbour.
        wx, wy = -np.sin(angle) * 0.5 * cell, np.cos(angle) * 0.5 * cell
        for i in range(2 * n):
            side = 1.0 if i % 2 == 0 else -1.0
            x, y = a[s, 0] + dx * (i // 2 + 0.5) / n + side * wx, a[s, 1] + dy * (i // 2 + 0.5) / n + side * wy
            r, c = int((y - y0) / cell), int((x - x0) / cell)
            top[r, c] = max(top[r, c], out[s] + PRESSED * thread)
            whose[r, c], way[r, c] = layer[s], angle


def layers(region: Array, kind: Array) -> Array:
    """(N,) whole numbers, one for all that is of one region and kind; ways and locks count as what they come after."""
    at = np.arange(len(kind))
    lies = (kind != TRAVEL) & (kind != LOCK)
    before = np.maximum.accumulate(np.where(lies, at, -1))
    after = np.minimum.accumulate(np.where(lies, at, len(kind))[::-1])[::-1]
    known = (before >= 0) & (region[before] == region)
    source = np.where(known, before, np.minimum(after, len(kind) - 1))
    return np.asarray(region.astype(np.int64) * 64 + kind[source])


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
    ids = np.asarray(layer, np.int64)[laid]
    where = (thread, cell, float(low[0]), float(low[1]))
    rough, out = np.zeros(len(laid)), np.zeros(len(laid))
    _pile(a, b, ids, rough.copy(), *where, np.zeros(shape), rough)
    # Neighbours carry each other; and once they do, what lies over them lies higher too.
    _pile(a, b, ids, _evened(a, b, rough, ids), *where, np.zeros(shape), out)
    made[laid] = out
    return made


@kernel
def _along(a: F8x2, b: F8x2, mine: I8x1, x0: float, y0: float, grid: F8x2, high: F8x1, put: bool) -> None:
    """Lift the cells below the stitches ``mine`` to their heights, or the heights to the cells'."""
    for s in mine:
        dx, dy = b[s, 0] - a[s, 0], b[s, 1] - a[s, 1]
        n = int(2 * np.hypot(dx, dy) / FIELD) + 2
        for i in range(n):
            r = int((a[s, 1] + dy * i / (n - 1) - y0) / FIELD)
            c = int((a[s, 0] + dx * i / (n - 1) - x0) / FIELD)
            if put:
                grid[r, c] = max(grid[r, c], high[s])
            else:
                high[s] = max(high[s], grid[r, c])


def _evened(a: Array, b: Array, high: Array, layer: Array) -> Array:
    """Heights (S,) of stitches a → b, none lower than given, that rise and fall slowly over each layer: the highest
    within ``BRIDGE``, then the mean of that."""
    from scipy.ndimage import maximum_filter, uniform_filter

    made = np.array(high)
    size = 2 * round(BRIDGE / FIELD) + 1
    for mine in np.split(np.arange(len(high)), np.flatnonzero(np.diff(layer)) + 1):
        if high[mine].max() == high[mine].min():
            continue
        ends = np.concatenate([a[mine], b[mine]])
        low = ends.min(axis=0) - FIELD
        wide = ((ends.max(axis=0) - low) / FIELD).astype(int) + 2
        grid = np.zeros((int(wide[1]), int(wide[0])))
        _along(a, b, mine, float(low[0]), float(low[1]), grid, made, True)
        grid = uniform_filter(maximum_filter(grid, size, mode="nearest"), size, mode="nearest")
        _along(a, b, mine, float(low[0]), float(low[1]), grid, made, False)
    return made

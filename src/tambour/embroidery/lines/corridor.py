"""Ways inside an area, under the rows that are still to come: a search over its row spans, then pulled straight."""

from __future__ import annotations

import math

import numpy as np

from tambour.core.arrays import F8x1, F8x2, I8x1
from tambour.core.kernels import kernel


@kernel
def neighbours(row: I8x1, lo: F8x1, hi: F8x1) -> tuple[I8x1, I8x1]:
    """Spans of the next and the previous row that overlap each span: (offsets (S + 1,), span). Spans sorted by row."""
    n = len(row)
    count = np.zeros(n + 1, np.int64)
    first = np.zeros(0, np.int64)
    for passing in range(2):
        if passing == 1:
            count = np.cumsum(count)
            first = np.empty(count[-1], np.int64)
            place = count[:-1].copy()
        i = 0
        while i < n:
            j = i
            while j < n and row[j] == row[i]:
                j += 1
            k = j
            while k < n and row[k] == row[i] + 1:
                k += 1
            if j < n and row[j] == row[i] + 1:
                p, q = i, j
                while p < j and q < k:
                    if min(hi[p], hi[q]) > max(lo[p], lo[q]):
                        if passing == 0:
                            count[p + 1] += 1
                            count[q + 1] += 1
                        else:
                            first[place[p]], first[place[q]] = q, p
                            place[p] += 1
                            place[q] += 1
                    if hi[p] < hi[q]:
                        p += 1
                    else:
                        q += 1
            i = j
    return count, first


@kernel
def find(
    offsets: I8x1,
    near: I8x1,
    row: I8x1,
    v: F8x1,
    lo: F8x1,
    hi: F8x1,
    rank: I8x1,
    now: int,
    a: int,
    ua: float,
    b: int,
    ub: float,
    margin: float,
    over: float,
    most: float,
) -> tuple[I8x1, float]:
    """Cheapest way from span ``a`` at ``ua`` to span ``b`` at ``ub``: (spans, cost), empty when dearer than ``most``.

    A millimetre below rows that come later (rank above ``now``) costs 1, on rows that are done ``over``. Dijkstra on
    the spans; where the way crosses a span is the place nearest to where it came from, kept ``margin`` off its ends.
    """
    n = len(row)
    cost = np.full(n, np.inf)
    at = np.zeros(n)
    came = np.full(n, -1, np.int64)
    done = np.zeros(n, np.bool_)
    heap_cost = np.empty(len(near) + 2)
    heap_span = np.empty(len(near) + 2, np.int64)
    size = 1
    heap_cost[0], heap_span[0] = 0.0, a
    cost[a], at[a] = 0.0, ua
    while size > 0:
        c, s = heap_cost[0], heap_span[0]
        size -= 1
        if size > 0:
            tail_cost, tail_span = heap_cost[size], heap_span[size]
            i = 0
            while True:
                j = 2 * i + 1
                if j >= size:
                    break
                if j + 1 < size and heap_cost[j + 1] < heap_cost[j]:
                    j += 1
                if heap_cost[j] >= tail_cost:
                    break
                heap_cost[i], heap_span[i] = heap_cost[j], heap_span[j]
                i = j
            heap_cost[i], heap_span[i] = tail_cost, tail_span
        if done[s]:
            continue
        done[s] = True
        if c > most:
            break
        if s == b:
            break
        for k in range(offsets[s], offsets[s + 1]):
            t = near[k]
            if done[t]:
                continue
            left, right = max(lo[s], lo[t]) + margin, min(hi[s], hi[t]) - margin
            if left > right:
                left = right = (left + right) / 2
            x = min(max(at[s], left), right)
            step = math.hypot(v[row[t]] - v[row[s]], x - at[s])
            w = c + step * (over if rank[t] <= now else 1.0)
            if t == b:
                w += abs(ub - x)
            if w < cost[t]:
                cost[t], at[t], came[t] = w, x, s
                i = size
                size += 1
                while i > 0:
                    j = (i - 1) // 2
                    if heap_cost[j] <= w:
                        break
                    heap_cost[i], heap_span[i] = heap_cost[j], heap_span[j]
                    i = j
                heap_cost[i], heap_span[i] = w, t
    if not done[b] or cost[b] > most:
        return np.zeros(0, np.int64), np.inf
    m = 1
    s = b
    while s != a:
        s = came[s]
        m += 1
    path = np.empty(m, np.int64)
    s = b
    for i in range(m - 1, -1, -1):
        path[i] = s
        s = came[s]
    return path, cost[b]


@kernel
def straighten(path: I8x1, row: I8x1, v: F8x1, lo: F8x1, hi: F8x1, ua: float, ub: float, margin: float) -> F8x2:
    """The way through the spans ``path`` with few corners: (n, 2) of (u, v), both ends included."""
    m = len(path)
    out = np.empty((m + 1, 2))
    out[0, 0], out[0, 1] = ua, v[row[path[0]]]
    n = 1
    i = 0
    u, w = ua, v[row[path[0]]]
    while i < m - 1:
        # From the corner (u, w) on, the slopes that pass through all spans so far; the last corner that still does.
        step = row[path[i + 1]] - row[path[i]]
        least, most = -np.inf, np.inf
        j = i
        while j + 1 < m and row[path[j + 1]] - row[path[j]] == step:
            t = path[j + 1]
            if j + 1 == m - 1:
                left, right = ub, ub
            else:
                left, right = lo[t] + margin, hi[t] - margin
                if left > right:
                    left = right = (lo[t] + hi[t]) / 2
            rise = abs(v[row[t]] - w)
            low, high = max(least, (left - u) / rise), min(most, (right - u) / rise)
            if low > high and j > i:
                break
            if low > high:
                low = high = (low + high) / 2
            least, most = low, high
            j += 1
        rise = abs(v[row[path[j]]] - w)
        slope = (ub - u) / rise
        slope = min(max(slope, least), most)
        u, w = u + slope * rise, v[row[path[j]]]
        out[n, 0], out[n, 1] = u, w
        n += 1
        i = j
    if abs(out[n - 1, 0] - ub) > 1e-9:
        out[n, 0], out[n, 1] = ub, w
        n += 1
    return out[:n].copy()


@kernel
def holds(points: F8x2, offsets: I8x1, x: float, y: float) -> bool:
    """Whether (x, y) is inside the rings (even-odd)."""
    inside = False
    for k in range(len(offsets) - 1):
        b = offsets[k + 1] - 1
        for a in range(offsets[k], offsets[k + 1]):
            if (points[a, 1] > y) != (points[b, 1] > y):
                f = (y - points[a, 1]) / (points[b, 1] - points[a, 1])
                if x < points[a, 0] + f * (points[b, 0] - points[a, 0]):
                    inside = not inside
            b = a
    return inside


@kernel
def leaves(points: F8x2, offsets: I8x1, way: F8x2, slack: float) -> bool:
    """Whether the polyline ``way`` (n, 2) is anywhere outside the rings (even-odd), but for ``slack`` mm at its ends."""
    for i in range(len(way) - 1):
        px, py, qx, qy = way[i, 0], way[i, 1], way[i + 1, 0], way[i + 1, 1]
        span = math.hypot(qx - px, qy - py)
        if span == 0:
            continue
        if i == 0:
            f = min(slack / span, 0.5)
            px, py = px + f * (qx - px), py + f * (qy - py)
        if i == len(way) - 2:
            f = min(slack / span, 0.5)
            qx, qy = qx + f * (px - qx), qy + f * (py - qy)
        if i == 0 and not holds(points, offsets, px, py):
            return True
        if i == len(way) - 2 and not holds(points, offsets, qx, qy):
            return True
        x0, x1, y0, y1 = min(px, qx), max(px, qx), min(py, qy), max(py, qy)
        for k in range(len(offsets) - 1):
            b = offsets[k + 1] - 1
            for a in range(offsets[k], offsets[k + 1]):
                ax, ay, bx, by = points[b, 0], points[b, 1], points[a, 0], points[a, 1]
                b = a
                if max(ax, bx) < x0 or min(ax, bx) > x1 or max(ay, by) < y0 or min(ay, by) > y1:
                    continue
                d1 = (qx - px) * (ay - py) - (qy - py) * (ax - px)
                d2 = (qx - px) * (by - py) - (qy - py) * (bx - px)
                d3 = (bx - ax) * (py - ay) - (by - ay) * (px - ax)
                d4 = (bx - ax) * (qy - ay) - (by - ay) * (qx - ax)
                if (d1 > 0) != (d2 > 0) and (d3 > 0) != (d4 > 0):
                    return True
    return False

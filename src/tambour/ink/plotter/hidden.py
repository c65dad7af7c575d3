"""Hidden lines: what of each line no later opaque polygon covers.

Every segment is cut where it crosses an outline, and every piece is judged by the winding number of its middle. A grid
over the polygons' boxes gives the few that can matter; of those, only the edges beside a short run of segments are
looked at, so a leaf before a mountain costs no more than a leaf before a hut.
"""

from __future__ import annotations

import numpy as np

from tambour.core.arrays import F8x2, I8x1
from tambour.core.check import Array
from tambour.core.kernels import kernel
from tambour.geometry.cells import touched

CELLS = 64
"""Cells of the grid along its longer side."""
RUN = 16
"""Segments that are judged together."""


@kernel
def _bounds(coords: Array, offsets: Array) -> Array:
    n = len(offsets) - 1
    box = np.empty((n, 4))
    for i in range(n):
        x0 = y0 = np.inf
        x1 = y1 = -np.inf
        for p in range(offsets[i], offsets[i + 1]):
            x, y = coords[p, 0], coords[p, 1]
            x0, y0, x1, y1 = min(x0, x), min(y0, y), max(x1, x), max(y1, y)
        box[i, 0], box[i, 1], box[i, 2], box[i, 3] = x0, y0, x1, y1
    return box


@kernel
def _inside(x: float, y: float, edges: Array, count: int) -> bool:
    """Whether the winding number is not 0, of edges (x0, y0, x1, y1) that include all to the right of the point."""
    winding = 0
    for e in range(count):
        ay, by = edges[e, 1], edges[e, 3]
        if (ay <= y) != (by <= y):
            side = (edges[e, 2] - edges[e, 0]) * (y - ay) - (x - edges[e, 0]) * (by - ay)
            if ay <= y:
                if side > 0:
                    winding += 1
            elif side < 0:
                winding -= 1
    return winding != 0


@kernel
def _grown(a: Array, need: int) -> Array:
    if need <= len(a):
        return a
    b = np.empty((max(need, 2 * len(a)), a.shape[1]), a.dtype)
    b[: len(a)] = a
    return b


@kernel
def visible(
    coords: F8x2, offsets: I8x1, order: I8x1, outlines: F8x2, ends: I8x1, rank: I8x1
) -> tuple[F8x2, I8x1, I8x1]:
    """What is seen of lines before which opaque polygons lie.

    coords (P, 2), offsets (N + 1,): lines ; order (N,) int64: when each is drawn
    outlines (Q, 2), ends (M + 1,): polygons, closed by themselves, non-zero winding ; rank (M,) int64: when each is
    painted; it hides lines of a lower order

    Gives the pieces' coords, offsets, and the line each came from, in the lines' order.
    """
    box = _bounds(outlines, ends)
    m, n = len(rank), len(order)
    x0 = y0 = np.inf
    x1 = y1 = -np.inf
    widest = 1
    for i in range(m):
        x0, y0, x1, y1 = min(x0, box[i, 0]), min(y0, box[i, 1]), max(x1, box[i, 2]), max(y1, box[i, 3])
        widest = max(widest, ends[i + 1] - ends[i])
    if not x0 <= x1:
        x0 = y0 = x1 = y1 = 0.0
    cell = max(max(x1 - x0, y1 - y0) / CELLS, 1e-9)
    nx, ny = int((x1 - x0) / cell) + 1, int((y1 - y0) / cell) + 1
    starts, items = touched(box, x0, y0, cell, nx, ny)
    seen = np.full(m, -1, np.int64)
    edges = np.empty((widest + 1, 4))
    cuts = np.empty(2 * widest + 4)
    hidden = np.empty((64, 3))
    out, count = np.empty((len(coords) + 16, 2)), 0
    first, pieces = np.zeros((n + 16, 1), np.int64), 0
    source = np.zeros((n + 16, 1), np.int64)
    whole = np.zeros(RUN, np.bool_)
    stamp = 0
    for line in range(n):
        drawing = False
        for a in range(offsets[line], offsets[line + 1] - 1, RUN):
            b = min(a + RUN, offsets[line + 1] - 1)
            stamp += 1
            left = top = np.inf
            right = bottom = -np.inf
            for p in range(a, b + 1):
                left, right = min(left, coords[p, 0]), max(right, coords[p, 0])
                top, bottom = min(top, coords[p, 1]), max(bottom, coords[p, 1])
            whole[:] = False
            gone, spans = 0, 0
            u0, u1 = max(0, int((left - x0) / cell)), min(nx - 1, int((right - x0) / cell))
            v0, v1 = max(0, int((top - y0) / cell)), min(ny - 1, int((bottom - y0) / cell))
            for v in range(v0, v1 + 1):
                for u in range(u0, u1 + 1):
                    # The last painted hides most: it is asked first.
                    for k in range(starts[v * nx + u + 1] - 1, starts[v * nx + u] - 1, -1):
                        i = items[k]
                        if gone == b - a:
                            break
                        if rank[i] <= order[line] or seen[i] == stamp:
                            continue
                        seen[i] = stamp
                        if box[i, 0] > right or box[i, 2] < left or box[i, 1] > bottom or box[i, 3] < top:
                            continue
                        # Edges beside the run or to the right of it: enough for crossings and for winding.
                        near = 0
                        q = ends[i + 1] - 1
                        for p in range(ends[i], ends[i + 1]):
                            ax, ay, bx, by = outlines[q, 0], outlines[q, 1], outlines[p, 0], outlines[p, 1]
                            q = p
                            if max(ax, bx) >= left and min(ay, by) <= bottom and max(ay, by) >= top:
                                edges[near, 0], edges[near, 1], edges[near, 2], edges[near, 3] = ax, ay, bx, by
                                near += 1
                        if near == 0:
                            continue
                        for s in range(a, b):
                            if whole[s - a]:
                                continue
                            px, py, qx, qy = coords[s, 0], coords[s, 1], coords[s + 1, 0], coords[s + 1, 1]
                            dx, dy = qx - px, qy - py
                            crossed = 1
                            cuts[0] = 0.0
                            for e in range(near):
                                fx, fy = edges[e, 0] - px, edges[e, 1] - py
                                gx, gy = edges[e, 2] - px, edges[e, 3] - py
                                c0, c1 = dx * fy - dy * fx, dx * gy - dy * gx
                                if (c0 > 0) == (c1 > 0):
                                    continue
                                # Where the edge meets the way of the segment, as a part of the segment.
                                w = c0 / (c0 - c1)
                                hx, hy = fx + (gx - fx) * w, fy + (gy - fy) * w
                                t = hx / dx if abs(dx) > abs(dy) else hy / dy
                                if 0.0 < t < 1.0:
                                    cuts[crossed] = t
                                    crossed += 1
                            cuts[crossed] = 1.0
                            if crossed > 1:
                                cuts[1:crossed].sort()
                            for c in range(crossed):
                                t0, t1 = cuts[c], cuts[c + 1]
                                middle = 0.5 * (t0 + t1)
                                if t1 > t0 and _inside(px + dx * middle, py + dy * middle, edges, near):
                                    if t0 == 0.0 and t1 == 1.0:
                                        whole[s - a] = True
                                        gone += 1
                                    else:
                                        hidden = _grown(hidden, spans + 1)
                                        hidden[spans, 0], hidden[spans, 1], hidden[spans, 2] = s, t0, t1
                                        spans += 1
            for s in range(a, b):
                if whole[s - a]:
                    drawing = False
                    continue
                px, py, qx, qy = coords[s, 0], coords[s, 1], coords[s + 1, 0], coords[s + 1, 1]
                t = 0.0
                while t < 1.0:
                    # To the end of what covers t, then to the next cover's beginning.
                    moved = True
                    while moved:
                        moved = False
                        for k in range(spans):
                            if hidden[k, 0] == s and hidden[k, 1] <= t < hidden[k, 2]:
                                t, moved = hidden[k, 2], True
                                drawing = False
                    if t >= 1.0:
                        break
                    stop = 1.0
                    for k in range(spans):
                        if hidden[k, 0] == s and t < hidden[k, 1] < stop:
                            stop = hidden[k, 1]
                    if not drawing:
                        first, source = _grown(first, pieces + 2), _grown(source, pieces + 1)
                        first[pieces, 0], source[pieces, 0] = count, line
                        pieces += 1
                        out = _grown(out, count + 2)
                        out[count, 0], out[count, 1] = px + (qx - px) * t, py + (qy - py) * t
                        count += 1
                        drawing = True
                    out = _grown(out, count + 1)
                    if stop == 1.0:
                        out[count, 0], out[count, 1] = qx, qy
                    else:
                        out[count, 0], out[count, 1] = px + (qx - px) * stop, py + (qy - py) * stop
                    count += 1
                    if stop < 1.0:
                        drawing = False
                    t = stop
    first = _grown(first, pieces + 1)
    first[pieces, 0] = count
    return out[:count].copy(), first[: pieces + 1, 0].copy(), source[:pieces, 0].copy()

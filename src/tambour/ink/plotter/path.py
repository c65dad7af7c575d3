"""Path: lines cut to a page, simplified, and put in the order in which the pen moves least."""

from __future__ import annotations

import math

import numpy as np

from tambour.core.arrays import B1x1, F8x2, I8x1
from tambour.core.kernels import kernel


@kernel
def cut(coords: F8x2, offsets: I8x1, x0: float, y0: float, x1: float, y1: float) -> tuple[F8x2, I8x1, I8x1]:
    """Lines within a rectangle (Liang and Barsky 1984): coords, offsets, and the line each piece came from."""
    n = len(offsets) - 1
    out = np.empty((2 * len(coords) + 2, 2))
    first, source = np.zeros(len(coords) + 2, np.int64), np.zeros(len(coords) + 2, np.int64)
    count = pieces = 0
    for line in range(n):
        drawing = False
        for s in range(offsets[line], offsets[line + 1] - 1):
            px, py = coords[s, 0], coords[s, 1]
            dx, dy = coords[s + 1, 0] - px, coords[s + 1, 1] - py
            t0, t1 = 0.0, 1.0
            for side in range(4):
                if side == 0:
                    p, q = -dx, px - x0
                elif side == 1:
                    p, q = dx, x1 - px
                elif side == 2:
                    p, q = -dy, py - y0
                else:
                    p, q = dy, y1 - py
                if p < 0:
                    t0 = max(t0, q / p)
                elif p > 0:
                    t1 = min(t1, q / p)
                elif q < 0:
                    t1 = -1.0
            if t0 >= t1:
                drawing = False
                continue
            if not drawing or t0 > 0.0:
                first[pieces], source[pieces] = count, line
                pieces += 1
                out[count, 0], out[count, 1] = px + dx * t0, py + dy * t0
                count += 1
            out[count, 0], out[count, 1] = px + dx * t1, py + dy * t1
            count += 1
            drawing = t1 == 1.0
    first[pieces] = count
    return out[:count].copy(), first[: pieces + 1].copy(), source[:pieces].copy()


@kernel
def simplified(coords: F8x2, offsets: I8x1, tolerance: float) -> tuple[F8x2, I8x1]:
    """Lines without the points that lie within ``tolerance`` of what is left (Douglas and Peucker 1973)."""
    kept = np.zeros(len(coords), np.bool_)
    stack = np.empty((len(coords) + 1, 2), np.int64)
    for line in range(len(offsets) - 1):
        a, b = offsets[line], offsets[line + 1] - 1
        if b < a:
            continue
        kept[a] = kept[b] = True
        deep = 1
        stack[0, 0], stack[0, 1] = a, b
        while deep > 0:
            deep -= 1
            i, j = stack[deep, 0], stack[deep, 1]
            px, py = coords[i, 0], coords[i, 1]
            dx, dy = coords[j, 0] - px, coords[j, 1] - py
            square = dx * dx + dy * dy
            far, at = tolerance * tolerance, -1
            for k in range(i + 1, j):
                ex, ey = coords[k, 0] - px, coords[k, 1] - py
                t = min(1.0, max(0.0, (ex * dx + ey * dy) / square)) if square > 0 else 0.0
                away = (ex - t * dx) ** 2 + (ey - t * dy) ** 2
                if away > far:
                    far, at = away, k
            if at >= 0:
                kept[at] = True
                stack[deep, 0], stack[deep, 1] = i, at
                stack[deep + 1, 0], stack[deep + 1, 1] = at, j
                deep += 2
    out = np.empty((int(kept.sum()), 2))
    ends = np.zeros(len(offsets), np.int64)
    count = 0
    for line in range(len(offsets) - 1):
        for p in range(offsets[line], offsets[line + 1]):
            if kept[p]:
                out[count] = coords[p]
                count += 1
        ends[line + 1] = count
    return out, ends


@kernel
def tour(heads: F8x2, tails: F8x2, x: float, y: float) -> tuple[I8x1, B1x1]:
    """From (x, y) always to the nearest end of a line not yet drawn: the order (N,), and whether each is turned round.

    heads, tails (N, 2): first and last points. The ends lie in a grid of about two to a cell, searched ring by ring.
    """
    n = len(heads)
    order, turned = np.empty(n, np.int64), np.zeros(n, np.bool_)
    if n == 0:
        return order, turned
    x0 = min(heads[:, 0].min(), tails[:, 0].min())
    y0 = min(heads[:, 1].min(), tails[:, 1].min())
    wide = max(heads[:, 0].max(), tails[:, 0].max()) - x0
    high = max(heads[:, 1].max(), tails[:, 1].max()) - y0
    cell = max(math.sqrt(wide * high / n), max(wide, high) / 2000.0, 1e-9)
    nx, ny = int(wide / cell) + 1, int(high / cell) + 1
    top = np.full(nx * ny, -1, np.int64)
    after, before = np.full(2 * n, -1, np.int64), np.full(2 * n, -1, np.int64)
    home = np.empty(2 * n, np.int64)
    for e in range(2 * n - 1, -1, -1):
        ex, ey = (heads[e // 2, 0], heads[e // 2, 1]) if e % 2 == 0 else (tails[e // 2, 0], tails[e // 2, 1])
        c = int((ey - y0) / cell) * nx + int((ex - x0) / cell)
        home[e], after[e] = c, top[c]
        if top[c] >= 0:
            before[top[c]] = e
        top[c] = e
    for k in range(n):
        u, v = int((min(max(x, x0), x0 + wide) - x0) / cell), int((min(max(y, y0), y0 + high) - y0) / cell)
        outside = math.hypot(x - min(max(x, x0), x0 + wide), y - min(max(y, y0), y0 + high))
        best, found = np.inf, -1
        for ring in range(max(nx, ny) + 1):
            if found >= 0 and best <= max(0.0, (ring - 1) * cell - outside) ** 2:
                break
            for b in range(max(0, v - ring), min(ny - 1, v + ring) + 1):
                step = 1 if abs(b - v) == ring else max(1, 2 * ring)
                for a in range(u - ring, u + ring + 1, step):
                    if a < 0 or a >= nx:
                        continue
                    e = top[b * nx + a]
                    while e >= 0:
                        i = e // 2
                        ex, ey = (heads[i, 0], heads[i, 1]) if e % 2 == 0 else (tails[i, 0], tails[i, 1])
                        away = (ex - x) ** 2 + (ey - y) ** 2
                        if away < best or (away == best and e < found):
                            best, found = away, e
                        e = after[e]
        i = found // 2
        order[k], turned[k] = i, found % 2 == 1
        for e in range(2 * i, 2 * i + 2):
            if before[e] >= 0:
                after[before[e]] = after[e]
            else:
                top[home[e]] = after[e]
            if after[e] >= 0:
                before[after[e]] = before[e]
        x, y = (heads[i, 0], heads[i, 1]) if turned[k] else (tails[i, 0], tails[i, 1])
    return order, turned


@kernel
def strung(coords: F8x2, offsets: I8x1, order: I8x1, turned: B1x1, gap: float, x: float, y: float) -> tuple[F8x2, I8x1]:
    """Lines in the order of a tour from (x, y); those that begin within ``gap`` of the last one's end go on from it.

    A closed line begins where it lies nearest to the pen.
    """
    out = np.empty((len(coords) + 1, 2))
    first = np.zeros(len(order) + 1, np.int64)
    count = pieces = 0
    for k in range(len(order)):
        i = order[k]
        a, b = offsets[i], offsets[i + 1]
        size = b - a
        shift = 0
        closed = size > 3 and coords[a, 0] == coords[b - 1, 0] and coords[a, 1] == coords[b - 1, 1]
        if closed:
            near = np.inf
            for p in range(a, b - 1):
                away = (coords[p, 0] - x) ** 2 + (coords[p, 1] - y) ** 2
                if away < near:
                    near, shift = away, p - a
        for j in range(size):
            if closed:
                p = a + (shift + j) % (size - 1)
            else:
                p = b - 1 - j if turned[k] else a + j
            if j == 0:
                away = math.hypot(coords[p, 0] - x, coords[p, 1] - y)
                if count == 0 or away > gap:
                    first[pieces] = count
                    pieces += 1
                elif away == 0.0:
                    continue
            out[count] = coords[p]
            count += 1
        x, y = out[count - 1, 0], out[count - 1, 1]
    first[pieces] = count
    return out[:count].copy(), first[: pieces + 1].copy()

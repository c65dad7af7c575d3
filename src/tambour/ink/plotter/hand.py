"""Hand: how a pen, whose line has one width, redraws what a brush left: strokes, dabs, trees, far ranges.

Tone is length of line: a mark of area A and tone t is drawn with about A·t/b of line by a nib b. The line never lifts
within a mark: it goes there and back beside itself.
"""

from __future__ import annotations

import math

import numpy as np

from tambour.core.arrays import F8x1, F8x2, F8x3, I8x1
from tambour.core.kernels import kernel
from tambour.ink.brush.press import curved

BESIDE = 0.85
"""How far apart passes that make one line lie, in nibs."""
MOST = 7
"""Passes of a stroke at most."""
WASHED, BROAD, STREAKS = 0.36, 3.5, 0.9
"""A stroke paler than this and broader than so many nibs is a wash: its lines lie apart from each other."""


@kernel
def passes(coords: F8x2, offsets: I8x1, tone: F8x1, chance: F8x1, nib: float) -> tuple[F8x2, I8x1, I8x1]:
    """Lines that weigh what brush strokes do: their coords, offsets, and the stroke of each.

    coords, offsets: outlines of strokes, as the press leaves them (2 n - 1 points, there and back) ; tone, chance (K,)
    A stroke of width w and tone t is as many neighbouring passes as w·t holds nibs: one where it is thin, all where it
    is pressed. A wash is parallel lines along it, apart.
    """
    out = np.empty((6 * len(coords) + 64, 2))
    ends, source = np.zeros(len(coords) + 2, np.int64), np.zeros(len(coords) + 2, np.int64)
    count = lines = 0
    for k in range(len(offsets) - 1):
        first, last = offsets[k], offsets[k + 1] - 1
        n = (last - first) // 2 + 1
        widest = 0.0
        for i in range(1, n - 1):
            a, b = first + i, last - i
            widest = max(widest, math.hypot(coords[a, 0] - coords[b, 0], coords[a, 1] - coords[b, 1]))
        weight = widest * tone[k] / nib
        if 0.0 < tone[k] < WASHED and widest > BROAD * nib:
            streaks = int(STREAKS * weight + chance[k])
            for j in range(streaks):
                side = 1.5 * ((j + 0.5) / streaks - 0.5)
                begun = count
                for i in range(1, n - 1):
                    a, b = first + i, last - i
                    wide = math.hypot(coords[a, 0] - coords[b, 0], coords[a, 1] - coords[b, 1])
                    if wide > (0.5 + 0.25 * ((7 * j + int(97.0 * chance[k])) % 3) / 2.0) * widest:
                        for d in range(2):
                            out[count, d] = 0.5 * (coords[a, d] + coords[b, d] + side * (coords[a, d] - coords[b, d]))
                        count += 1
                if count - begun > 1:
                    source[lines] = k
                    lines += 1
                    ends[lines] = count
                else:
                    count = begun
            continue
        turns = max(1, min(MOST, int(weight + 0.4)))
        at = 0
        for j in range(turns):
            # From the middle outwards, to one side and the other.
            place = 0.5 * (j + 1) if j % 2 else -0.5 * j
            if turns % 2 == 0:
                place += 0.5 if j % 2 == 0 else -0.5
            away = abs(place) * BESIDE * nib
            low, high = n, -1
            for i in range(n):
                a, b = first + i, last - i
                wide = math.hypot(coords[a, 0] - coords[b, 0], coords[a, 1] - coords[b, 1])
                if j == 0 or 0.5 * (wide * tone[k] - nib) >= away - 0.6 * BESIDE * nib:
                    low, high = min(low, i), max(high, i)
            if high <= low:
                continue
            goal = high if abs(high - at) > abs(low - at) else low
            step = 1 if goal >= at else -1
            i = at
            while True:
                a, b = first + i, last - i
                dx, dy = coords[a, 0] - coords[b, 0], coords[a, 1] - coords[b, 1]
                wide = math.hypot(dx, dy)
                slack = max(0.0, 0.5 * (wide * tone[k] - nib))
                f = math.copysign(min(away, slack), place) / wide if wide > 0.0 else 0.0
                if count < len(out):
                    out[count, 0] = 0.5 * (coords[a, 0] + coords[b, 0]) + f * dx
                    out[count, 1] = 0.5 * (coords[a, 1] + coords[b, 1]) + f * dy
                    count += 1
                if i == goal:
                    break
                i += step
            at = goal
        source[lines] = k
        lines += 1
        ends[lines] = count
    return out[:count].copy(), ends[: lines + 1].copy(), source[:lines].copy()


@kernel
def pressed(coords: F8x2, offsets: I8x1, tone: F8x1, nib: float, heights: int) -> tuple[F8x2, I8x1, I8x1, I8x1]:
    """Strokes for a pen that swells: cut where the pen is lowered or raised; coords, offsets, stroke and height of each piece.

    Height h, 0 … heights - 1, leaves a line h + 1 nibs wide. A paler stroke is pressed less.
    """
    out = np.empty((2 * len(coords) + 64, 2))
    ends = np.zeros(len(coords) + 2, np.int64)
    source, height = np.zeros(len(coords) + 2, np.int64), np.zeros(len(coords) + 2, np.int64)
    count = lines = 0
    for k in range(len(offsets) - 1):
        first, last = offsets[k], offsets[k + 1] - 1
        n = (last - first) // 2 + 1
        held = -1
        for i in range(n):
            a, b = first + i, last - i
            x, y = 0.5 * (coords[a, 0] + coords[b, 0]), 0.5 * (coords[a, 1] + coords[b, 1])
            wide = math.hypot(coords[a, 0] - coords[b, 0], coords[a, 1] - coords[b, 1]) * tone[k]
            level = max(0, min(heights - 1, int(wide / nib - 0.5)))
            out[count, 0], out[count, 1] = x, y
            count += 1
            if i == 0:
                held = level
            elif level != held and i < n - 1:
                source[lines], height[lines] = k, held
                lines += 1
                ends[lines] = count
                out[count, 0], out[count, 1] = x, y
                count += 1
                held = level
        source[lines], height[lines] = k, held
        lines += 1
        ends[lines] = count
    return out[:count].copy(), ends[: lines + 1].copy(), source[:lines].copy(), height[:lines].copy()


@kernel
def dabs(axes: F8x3, breadth: F8x1, turns: I8x1, groups: I8x1, nib: float, link: float) -> tuple[F8x2, I8x1, I8x1]:
    """Touches of the brush, each ``turns`` passes there and back; those of a group, near each other, in one line.

    axes (K, 2, 2): tip and tip ; breadth (K,) ; groups (G + 1,): which touches follow one another ; link: from how far on
    the pen is lifted between them. Gives coords, offsets, and the group of each line.
    """
    total = int(turns.sum())
    out = np.empty((2 * total + 2, 2))
    ends, source = np.zeros(total + 2, np.int64), np.zeros(total + 2, np.int64)
    count = lines = 0
    for g in range(len(groups) - 1):
        begun = count
        for k in range(groups[g], groups[g + 1]):
            px, py, qx, qy = axes[k, 0, 0], axes[k, 0, 1], axes[k, 1, 0], axes[k, 1, 1]
            mx, my, ux, uy = 0.5 * (px + qx), 0.5 * (py + qy), 0.5 * (qx - px), 0.5 * (qy - py)
            half = math.hypot(ux, uy)
            if half == 0.0:
                continue
            if count > begun:
                x, y = out[count - 1, 0], out[count - 1, 1]
                if math.hypot(qx - x, qy - y) < math.hypot(px - x, py - y):
                    ux, uy = -ux, -uy
                if math.hypot(mx - ux - x, my - uy - y) > link:
                    source[lines] = g
                    lines += 1
                    ends[lines] = count
                    begun = count
            for j in range(turns[k]):
                away = (j - 0.5 * (turns[k] - 1)) * BESIDE * nib
                away = max(-0.5 * breadth[k], min(0.5 * breadth[k], away))
                part = 2.0 * away / breadth[k] if breadth[k] > 0.0 else 0.0
                long = math.sqrt(max(0.2, 1.0 - part * part))
                ox, oy = -away * uy / half, away * ux / half
                for s in range(2):
                    f = long if (s == 1) == (j % 2 == 0) else -long
                    out[count, 0], out[count, 1] = mx + f * ux + ox, my + f * uy + oy
                    count += 1
        if count > begun:
            source[lines] = g
            lines += 1
            ends[lines] = count
    return out[:count].copy(), ends[: lines + 1].copy(), source[:lines].copy()


@kernel
def zigzags(axes: F8x3, breadth: F8x1, turns: I8x1, groups: I8x1, link: float, drop: float) -> tuple[F8x2, I8x1, I8x1]:
    """The leaves of trees as one line from side to side: ``turns`` points in each leaf, on its two ends in turn.

    As :func:`dabs`, but the line crosses a leaf aslant, as often as its ink asks for, over all its breadth.
    drop : 0 for lenses, 1 for drops, which taper from their foot to their tip
    """
    out = np.empty((int(turns.sum()) + 2, 2))
    ends, source = np.zeros(len(turns) + 2, np.int64), np.zeros(len(turns) + 2, np.int64)
    count = lines = 0
    for g in range(len(groups) - 1):
        begun, side = count, 1.0
        for k in range(groups[g], groups[g + 1]):
            px, py, qx, qy = axes[k, 0, 0], axes[k, 0, 1], axes[k, 1, 0], axes[k, 1, 1]
            ux, uy = 0.5 * (qx - px), 0.5 * (qy - py)
            half = math.hypot(ux, uy)
            if half == 0.0:
                continue
            for j in range(turns[k]):
                # Upwards: y is down.
                away = breadth[k] * (0.5 - (j + 0.5) / turns[k])
                part = 2.0 * away / breadth[k] if breadth[k] > 0.0 else 0.0
                f = side * ((1.0 - drop) * math.sqrt(max(0.2, 1.0 - part * part)) + drop * 0.5 * (1.0 + part))
                x, y = 0.5 * (px + qx) + f * ux, 0.5 * (py + qy) + f * uy + away
                if count > begun and math.hypot(x - out[count - 1, 0], y - out[count - 1, 1]) > link:
                    if count - begun > 1:
                        source[lines] = g
                        lines += 1
                        ends[lines] = count
                        begun = count
                    else:
                        count = begun
                out[count, 0], out[count, 1] = x, y
                count += 1
                side = -side
        if count - begun > 1:
            source[lines] = g
            lines += 1
            ends[lines] = count
        else:
            count = begun
    return out[:count].copy(), ends[: lines + 1].copy(), source[:lines].copy()


BINS = 12
"""Steps down a far range at which its tone is known."""
GENTLE = 4
"""Columns of facets to either side over which tone is evened out: lines must not jump."""


@kernel
def contours(coords: F8x2, offsets: I8x1, tone: F8x1, nib: float) -> tuple[F8x2, I8x1, I8x1]:
    """A far range as lines that run with its crest, the closer the darker it is; coords, offsets, and each line's number.

    coords, offsets: the facets of one range, column by column from the left and from the crest down ; tone (K,)
    Line j (0: the crest) runs where the ink above it would fill j lines.
    """
    many = len(offsets) - 1
    start = np.zeros(many + 1, np.int64)
    columns = 0
    for k in range(many):
        p, q = offsets[k], offsets[k - 1] + 3 if k > 0 else 0
        if k == 0 or abs(coords[p, 0] - coords[q, 0]) + abs(coords[p, 1] - coords[q, 1]) > 1e-9:
            start[columns] = k
            columns += 1
    start[columns] = many
    ink, drawn = np.zeros((columns, BINS)), np.zeros((columns, BINS))
    x, top, high = np.zeros(columns), np.zeros(columns), np.zeros(columns)
    for c in range(columns):
        head, tail = offsets[start[c]], offsets[start[c + 1] - 1]
        x[c] = 0.5 * (coords[head, 0] + coords[head + 1, 0])
        top[c] = 0.5 * (coords[head, 1] + coords[head + 1, 1])
        high[c] = 0.5 * (coords[tail + 2, 1] + coords[tail + 3, 1]) - top[c]
        for b in range(BINS):
            y = top[c] + (b + 0.5) / BINS * high[c]
            for k in range(start[c], start[c + 1]):
                p = offsets[k]
                ink[c, b] = tone[k]
                if 0.5 * (coords[p + 2, 1] + coords[p + 3, 1]) >= y:
                    break
    for c in range(columns):
        for b in range(BINS):
            total = weight = 0.0
            for d in range(max(0, c - GENTLE), min(columns, c + GENTLE + 1)):
                for e in range(max(0, b - 1), min(BINS, b + 2)):
                    total += ink[d, e]
                    weight += 1.0
            drawn[c, b] = total / weight
    most = 2 + int(drawn.max() * high.max() / nib) if columns else 1
    fine = 3
    out = np.empty((most * (fine * columns + 1) + 1, 2))
    ends, number = np.zeros(most * columns + 2, np.int64), np.zeros(most * columns + 2, np.int64)
    count = lines = 0
    way, smooth = np.empty((columns + 1, 2)), np.empty((fine * columns + 1, 2))
    for j in range(most):
        held = 0
        for c in range(columns + 1):
            found = -1.0
            if c < columns:
                filled = 0.0
                if j == 0:
                    found = 0.0 if high[c] > 6.0 * nib else -1.0
                for b in range(BINS):
                    more = drawn[c, b] * high[c] / BINS / nib
                    if found < 0.0 and 0.0 < j <= filled + more:
                        found = (b + (j - filled) / more) / BINS
                    filled += more
            if found >= 0.0:
                way[held, 0], way[held, 1] = x[c], top[c] + found * high[c]
                held += 1
            elif held > 0:
                if held > 3:
                    size = curved(way[:held], fine, smooth)
                    out[count : count + size] = smooth[:size]
                    count += size
                    number[lines] = j
                    lines += 1
                    ends[lines] = count
                held = 0
    return out[:count].copy(), ends[: lines + 1].copy(), number[:lines].copy()

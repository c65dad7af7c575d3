"""Press: from the way of the brush to the outline of its mark, thousands of marks per call."""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np

from tambour.core.arrays import F8x1, F8x2, F8x3, I8x1
from tambour.core.check import Array
from tambour.core.kernels import kernel
from tambour.ink.brush.stroke import (
    BEAD,
    BREADTH,
    DROP,
    EDGE_WIDTH,
    END,
    EVEN,
    FADE,
    KIND,
    LENS,
    NOISE,
    PUFF,
    ROW,
    SHAPE,
    SINE,
    WEDGE,
)
from tambour.ink.ground.marks import BLOB, RING, STROKE
from tambour.noise import close, lattice, value

TOUCH = 21
"""Points of a blob's outline; the first is repeated."""
ROWS, RUN = 512, 256
STEPS = 256


@lru_cache(maxsize=1)
def tools() -> tuple[Array, Array, Array, Array]:
    """Tables that marks are inked with.

    tapers (5, STEPS + 1) float64: breadth at t in 0…1; sine, even, fade (cosine), bead (three half waves), wedge
    forms (3, TOUCH, 2) float64: a blob's outline for unit length and breadth, along +x from -1/2 to 1/2 and back
    wobble (ROWS, RUN) float64: value noise along a stroke at half steps (dossier 1.4: N(i/2, n0))
    loops (ROWS, TOUCH) float64: value noise round a blob, closed (1.3, 1.5)
    """
    t = np.linspace(0, 1, STEPS + 1)
    tapers = np.zeros((5, STEPS + 1))
    tapers[SINE], tapers[EVEN], tapers[FADE] = np.sin(np.pi * t), 0.84, np.cos(np.pi * t / 2)
    tapers[BEAD] = np.sin(3 * np.pi * t)
    tapers[WEDGE] = np.minimum(1, 8 * t) ** 0.5 * (1 - t) ** 0.8
    p = np.linspace(0, 2, TOUCH)
    q = np.where(p <= 1, p, 2 - p)
    sign = np.where(p <= 1, 1.0, -1.0)
    forms = np.zeros((3, TOUCH, 2))
    forms[:, :, 0] = 0.5 - abs(p - 1)
    forms[LENS, :, 1] = 0.5 * sign * np.sqrt(abs(np.sin(np.pi * q)))
    forms[DROP, :, 1] = 0.5 * sign * np.sqrt(abs(q * np.sin(np.pi * q)))
    forms[PUFF, :, 1] = 0.5 * sign * 2.75 * q * (1 - q) ** (1 / 1.8)
    table = lattice("brush")
    wobble, loops = np.zeros((ROWS, RUN)), np.zeros((ROWS, TOUCH))
    _tremble(table, wobble, loops)
    return tapers, forms, wobble, loops


@kernel
def _tremble(table: F8x1, wobble: F8x2, loops: F8x2) -> None:
    for r in range(len(wobble)):
        y = 10.0 * r / len(wobble)
        for i in range(wobble.shape[1]):
            wobble[r, i] = value(table, 0.5 * i, y, 0.0)
        for i in range(loops.shape[1]):
            loops[r, i] = value(table, 0.05 * i, y, 0.5)
        close(loops[r])


FACET = 5.2
"""Units that a straight piece of a stroke's outline may be long; coarser ways are curved through their points."""
FINEST = 4


@kernel
def fineness(pts: F8x2, marks: F8x2) -> Array:
    """(K,) int64 into how many pieces each step of a stroke's way is cut, so that no facet shows; 1 for other marks."""
    found = np.ones(len(marks), np.int64)
    first = 0
    for k in range(len(marks)):
        end = int(marks[k, END])
        if marks[k, KIND] == STROKE and end - first > 2:
            long = 0.0
            for i in range(first + 1, end):
                long += math.sqrt((pts[i, 0] - pts[i - 1, 0]) ** 2 + (pts[i, 1] - pts[i - 1, 1]) ** 2)
            found[k] = min(FINEST, max(1, math.ceil(long / (FACET * (end - first - 1)))))
        first = end
    return found


def sizes(pts: Array, marks: Array) -> Array:
    """Offsets (K + 1,) int64 of the outlines of noted marks."""
    k = np.diff(marks[:, END], prepend=0.0).astype(np.int64)
    kind = marks[:, KIND]
    line = 2 * ((k - 1) * fineness(pts, marks) + 1) - 1
    count = np.where(kind == STROKE, line, np.where(kind == BLOB, TOUCH, np.where(kind == RING, 2 * TOUCH - 1, k)))
    return np.concatenate([[0], np.cumsum(count)]).astype(np.int64)


@kernel
def curved(way: Array, pieces: int, out: Array) -> int:
    """The way (n, 2) with each step cut into ``pieces`` on a Catmull-Rom curve through its points; gives how many there are."""
    n = len(way)
    k = 0
    for i in range(n - 1):
        for s in range(pieces):
            u = s / pieces
            for d in range(2):
                b, c = way[i, d], way[i + 1, d]
                a = way[i - 1, d] if i > 0 else 2.0 * b - c
                e = way[i + 2, d] if i + 2 < n else 2.0 * c - b
                out[k, d] = b + 0.5 * u * (c - a + u * (2.0 * a - 5.0 * b + 4.0 * c - e + u * (3.0 * (b - c) + e - a)))
            k += 1
    out[k, 0], out[k, 1] = way[n - 1, 0], way[n - 1, 1]
    return k + 1


@kernel
def ink(pts: F8x2, marks: F8x2, offsets: I8x1, tapers: F8x2, forms: F8x3, wobble: F8x2, loops: F8x2, out: F8x2) -> None:
    """Write the outline of every mark k to ``out[offsets[k]:offsets[k + 1]]``.

    pts (P, 2), marks (K, COLUMNS) as in :mod:`tambour.ink.brush.stroke`; offsets from :func:`sizes`; the rest from
    :func:`tools`; out (Q, 2) float64.
    """
    way = np.empty((TOUCH, 2))
    fine = fineness(pts, marks)
    curve = np.empty((1024, 2))
    first = 0
    for k in range(len(marks)):
        m = marks[k]
        end, o = int(m[END]), offsets[k]
        kind, shape = int(m[KIND]), int(m[SHAPE])
        if kind == STROKE:
            row = m[ROW] * len(wobble)
            if fine[k] == 1:
                brush_line(pts[first:end], m[BREADTH], m[NOISE], tapers[shape], 0, wobble[int(row)], row, 1, out[o:])
            else:
                if (end - first) * fine[k] > len(curve):
                    curve = np.empty((2 * (end - first) * fine[k], 2))
                count = curved(pts[first:end], fine[k], curve)
                brush_line(
                    curve[:count], m[BREADTH], m[NOISE], tapers[shape], 0, wobble[int(row)], row, fine[k], out[o:]
                )
        elif kind == BLOB:
            touch(pts[first:end], m[BREADTH], m[NOISE], forms[shape], loops[int(m[ROW] * len(loops))], out[o:])
        elif kind == RING:
            row = m[ROW] * len(wobble)
            touch(pts[first:end], m[BREADTH], m[NOISE], forms[LENS], loops[int(row)], way)
            brush_line(way, m[EDGE_WIDTH], 0.0, tapers[BEAD], shape, wobble[int(row)], row, 1, out[o:])
        else:
            for i in range(first, end):
                out[o + i - first, 0], out[o + i - first, 1] = pts[i, 0], pts[i, 1]
        first = end


@kernel
def brush_line(
    way: Array,
    breadth: float,
    noise: float,
    taper: Array,
    phase: int,
    wobble: Array,
    start: float,
    pieces: int,
    out: Array,
) -> None:
    """The outline of a brush line: there on one side, back on the other; 2 n - 1 points, the first repeated.

    way (n, 2) ; breadth: greatest half width ; taper (STEPS + 1,), begun at step ``phase`` and wrapped ; wobble (RUN,)
    noise of one row, begun at the fraction of ``start``, a place of it to every ``pieces`` points (dossier 1.4).
    """
    n = len(way)
    c = int((start - math.floor(start)) * len(wobble))
    out[0, 0], out[0, 1] = way[0, 0], way[0, 1]
    out[n - 1, 0], out[n - 1, 1] = way[n - 1, 0], way[n - 1, 1]
    out[2 * n - 2, 0], out[2 * n - 2, 1] = way[0, 0], way[0, 1]
    step = (len(taper) - 1) / n
    for i in range(1, n - 1):
        dx, dy = way[i + 1, 0] - way[i - 1, 0], way[i + 1, 1] - way[i - 1, 1]
        d = math.sqrt(dx * dx + dy * dy)
        s = int(i * step) + phase
        if s >= len(taper):
            s -= len(taper)
        j, u = c + i // pieces, (i % pieces) / pieces
        tremble = wobble[j % len(wobble)]
        if u > 0.0:
            tremble += u * (wobble[(j + 1) % len(wobble)] - tremble)
        w = breadth * taper[s] * (1.0 - noise + noise * tremble)
        f = w / d if d > 0.0 else 0.0
        x, y = way[i, 0], way[i, 1]
        out[i, 0], out[i, 1] = x + f * dy, y - f * dx
        out[2 * n - 2 - i, 0], out[2 * n - 2 - i, 1] = x - f * dy, y + f * dx


@kernel
def touch(axis: Array, breadth: float, noise: float, form: Array, loop: Array, out: Array) -> None:
    """The outline of a blob: its form along ``axis`` (2, 2), pulled in by up to ``noise`` round its middle (1.5)."""
    x, y = 0.5 * (axis[0, 0] + axis[1, 0]), 0.5 * (axis[0, 1] + axis[1, 1])
    ux, uy = axis[1, 0] - axis[0, 0], axis[1, 1] - axis[0, 1]
    length = math.sqrt(ux * ux + uy * uy)
    f = breadth / length if length > 0.0 else 0.0
    vx, vy = -f * uy, f * ux
    for i in range(TOUCH):
        r = 1.0 - noise + noise * loop[i]
        a, b = r * form[i, 0], r * form[i, 1]
        out[i, 0], out[i, 1] = x + a * ux + b * vx, y + a * uy + b * vy

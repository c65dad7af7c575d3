"""Brush: how elements put marks down. A mark is noted as the way of the brush and how it is held; ``press`` inks it.

Every drawing kernel takes a :class:`Brush` first: the chance and the noise that move it, and the pages that it writes to.

Kernels never fail for want of room: they raise the flag, and :mod:`tambour.ink.brush.desk` draws the element again on
larger pages. The stream belongs to the element, so the second drawing is the same.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from tambour.core.arrays import F8x1, F8x2, I8x1, U8x1
from tambour.core.check import Array
from tambour.core.kernels import inner, kernel
from tambour.ink.ground.codes import numbers
from tambour.ink.ground.marks import BLOB, BODY, INK, LINE, RING, STROKE, WASH
from tambour.noise import uniform

# Columns of a mark.
END, KIND, FILL, FILL_ALPHA, EDGE, EDGE_ALPHA, EDGE_WIDTH, BREADTH, NOISE, ROW, SHAPE, ELEMENT, TINT = range(13)
COLUMNS = 13
# Places of n.
POINTS, MARKS, ELEMENTS, FULL, OPEN, HUE = range(6)
# Tapers: how a stroke's breadth runs from its start to its end (a wedge is set down at once and drawn out thin).
SINE, EVEN, FADE, BEAD, WEDGE = numbers(5)
# Forms of a blob: a lens; a drop, fat at its end; a puff, round at its start.
LENS, DROP, PUFF = numbers(3)

PI = math.pi


class Brush(NamedTuple):
    """What a drawing kernel holds."""

    table: F8x1
    """(4096,) lattice values of the value noise"""
    rng: U8x1
    """(2,) the element's own stream of chance: its key, and how many numbers were taken"""
    pts: F8x2
    """(P, 2) the points of all spines, one after the other"""
    marks: F8x2
    """(K, COLUMNS) one row per mark"""
    elems: F8x2
    """(E, 4) one row per element: kind, parent, x, y"""
    n: I8x1
    """(8,) how much is used: points, marks, elements; a flag that something did not fit; the open element; the tint"""


@kernel
def rnd(rng: U8x1) -> float:
    """The next number of the element's stream, uniform in [0, 1)."""
    rng[1] += np.uint64(1)
    return uniform(rng[0], rng[1])


@kernel
def lattice(rng: U8x1) -> Array:
    """The element's own noise: (4096,) lattice values hashed from its key, from a stretch of its stream that no drawing reaches.

    What an element is shaped by must come from here: a place in the shared ``table`` would be one of 4096.
    """
    own = np.empty(4096)
    for i in range(4096):
        own[i] = uniform(rng[0], np.uint64(1 << 61) + np.uint64(i))
    return own


@kernel
def between(rng: Array, low: float, high: float) -> float:
    """Uniform in [low, high)."""
    return low + (high - low) * rnd(rng)


@kernel
def pick(rng: Array, count: int) -> int:
    """A whole number in 0 … count - 1."""
    return int(rnd(rng) * count)


@kernel
def side(rng: Array) -> float:
    """-1 or 1."""
    return -1.0 if rnd(rng) < 0.5 else 1.0


@kernel
def bell(rng: U8x1) -> float:
    """A bell over (-1, 1) with deviation 1/√12: half the sum of four uniforms in (-1/2, 1/2).

    The original rejects draws of a normal of the same deviation and support (dossier 1.3); four sums are cheaper.
    """
    return 0.5 * (rnd(rng) + rnd(rng) + rnd(rng) + rnd(rng)) - 1.0


@inner
def at(brush: Brush, x: float, y: float) -> None:
    """The brush goes to (x, y)."""
    k = brush.n[POINTS]
    if k < len(brush.pts):
        brush.pts[k, 0], brush.pts[k, 1] = x, y
        brush.n[POINTS] = k + 1
    else:
        brush.n[FULL] = 1


@inner
def lift(
    brush: Brush,
    kind: int,
    fill: float,
    fill_alpha: float,
    edge: float,
    edge_alpha: float,
    edge_width: float,
    breadth: float,
    noise: float,
    row: float,
    shape: int,
) -> None:
    """The points since the last mark become one. Fewer than two are dropped."""
    k = brush.n[MARKS]
    first = int(brush.marks[k - 1, END]) if k > 0 else 0
    if brush.n[POINTS] - first < 2:
        brush.n[POINTS] = first
        return
    if k >= len(brush.marks):
        brush.n[FULL] = 1
        return
    m = brush.marks[k]
    m[END], m[KIND] = brush.n[POINTS], kind
    m[FILL], m[FILL_ALPHA], m[EDGE], m[EDGE_ALPHA], m[EDGE_WIDTH] = fill, fill_alpha, edge, edge_alpha, edge_width
    m[BREADTH], m[NOISE], m[ROW], m[SHAPE] = breadth, noise, row, shape
    m[ELEMENT], m[TINT] = brush.n[OPEN], brush.n[HUE]
    brush.n[MARKS] = k + 1


@inner
def body(brush: Brush) -> None:
    """The points since the last mark are the outline of something opaque."""
    hue = brush.n[HUE]
    brush.n[HUE] = INK
    lift(brush, BODY, 255.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0)
    brush.n[HUE] = hue


@inner
def wash(brush: Brush, grey: float, alpha: float, seam: float) -> None:
    """The points since the last mark are filled with a flat tone; its edge, ``seam`` wide, hides joints."""
    lift(brush, WASH, grey, alpha, grey, alpha if seam > 0 else 0.0, seam, 0.0, 0.0, 0.0, 0)


@inner
def line(brush: Brush, grey: float, alpha: float, width: float) -> None:
    """The points since the last mark are a thin open line."""
    lift(brush, LINE, 0.0, 0.0, grey, alpha, width, width, 0.0, 0.0, 0)


@inner
def stroke(brush: Brush, grey: float, alpha: float, breadth: float, noise: float, taper: int, edge: float) -> None:
    """The points since the last mark are a stroke with pressure.

    breadth : half the greatest width, units; ``taper`` runs it along the way, and ``noise`` (0…1) makes it tremble
    edge : the original's line around it in its own tone (dossier 0). Laid over the fill it would show as a doubled rim, so
    the stroke is widened by it instead
    """
    lift(brush, STROKE, grey, alpha, grey, 0.0, 0.0, breadth + 0.4 * edge, noise, rnd(brush.rng), taper)


@inner
def drying(brush: Brush, grey: float, alpha: float, breadth: float, noise: float) -> None:
    """The points since the last mark are a stroke of a brush that runs dry: ink pools where it is set down, the stroke
    thins out half way, and two to four hairs of the brush go on (flying white)."""
    k = brush.n[MARKS]
    first = int(brush.marks[k - 1, END]) if k > 0 else 0
    many = brush.n[POINTS] - first
    if many < 8 or brush.n[FULL]:
        stroke(brush, grey, alpha, breadth, noise, WEDGE, 0.0)
        return
    way = brush.pts[first : brush.n[POINTS]].copy()
    wet = int((0.5 + 0.25 * rnd(brush.rng)) * many)
    brush.n[POINTS] = first + wet
    stroke(brush, grey, alpha, breadth, noise, WEDGE, 0.0)
    angle = math.atan2(way[1, 1] - way[0, 1], way[1, 0] - way[0, 0])
    blob(brush, way[1, 0], way[1, 1], 1.8 * breadth, 1.3 * breadth, angle, grey, alpha, 0.5, LENS)
    hairs = 2 + pick(brush.rng, 3)
    for h in range(hairs):
        side_ = 1.5 * breadth * ((h + 0.5) / hairs - 0.5)
        begin, end = int((0.3 + 0.4 * rnd(brush.rng)) * wet), many - int(0.3 * rnd(brush.rng) * many)
        for i in range(begin, end):
            a, b = max(0, i - 1), min(many - 1, i + 1)
            dx, dy = way[b, 0] - way[a, 0], way[b, 1] - way[a, 1]
            d = math.sqrt(dx * dx + dy * dy)
            f = side_ / d if d > 0.0 else 0.0
            at(brush, way[i, 0] - f * dy, way[i, 1] + f * dx)
        stroke(brush, grey, alpha * between(brush.rng, 0.45, 0.85), breadth * 0.24, 0.9, FADE, 0.0)


@inner
def blob(
    brush: Brush,
    x: float,
    y: float,
    length: float,
    breadth: float,
    angle: float,
    grey: float,
    alpha: float,
    noise: float,
    form: int,
) -> None:
    """One touch of the brush about (x, y): ``length`` along ``angle`` (clockwise, y down), ``breadth`` across."""
    dx, dy = 0.5 * length * math.cos(angle), 0.5 * length * math.sin(angle)
    at(brush, x - dx, y - dy)
    at(brush, x + dx, y + dy)
    lift(brush, BLOB, grey, alpha, grey, 0.0, 0.0, breadth, noise, rnd(brush.rng), form)


@inner
def ring(
    brush: Brush, x: float, y: float, length: float, breadth: float, angle: float, grey: float, alpha: float, pen: float
) -> None:
    """The outline of a blob, drawn with a line that swells three half waves on its way round: a scale of bark."""
    dx, dy = 0.5 * length * math.cos(angle), 0.5 * length * math.sin(angle)
    at(brush, x - dx, y - dy)
    at(brush, x + dx, y + dy)
    lift(brush, RING, grey, alpha, grey, 0.0, pen, breadth, 0.5, rnd(brush.rng), int(rnd(brush.rng) * 256.0))


@inner
def part(brush: Brush, kind: int, x: float, y: float) -> int:
    """Open a part of the open element (or, with none open, a whole) standing at (x, y); gives what was open."""
    before = brush.n[OPEN]
    k = brush.n[ELEMENTS]
    if k >= len(brush.elems):
        brush.n[FULL] = 1
        return before
    e = brush.elems[k]
    e[0], e[1], e[2], e[3] = kind, before, x, y
    brush.n[ELEMENTS] = k + 1
    brush.n[OPEN] = k
    return before

"""Pressed: yarn is soft. Where strands lie against each other each gives way, flat between them and round where it is free."""

from __future__ import annotations

from functools import partial
from math import sqrt
from typing import Final

import numpy as np

from tambour.core.arrays import F8x1, F8x2, I4x1, I4x2, I8x1
from tambour.core.check import Array
from tambour.core.kernels import kernel
from tambour.core.strands import Strands
from tambour.core.threads import share
from tambour.crochet.yarn.near import pairs

SHOULDER: Final = 3
"""How round yarn is between where it is free and where it is pressed: the higher this power, the sharper its shoulder."""
LEAST: Final = 0.34
"""What of its radius is left of yarn at the least, to any side."""
FULLER: Final = 1.2
"""So many times as thick grows at the most, to its free sides, what is pressed from others: yarn is not lost."""
KEPT: Final = 0.95
"""What of its section yarn keeps, where it may: a little air is pressed out of it."""
SHARED: Final = 3
"""How often what is pressed is shared with what lies beside it."""
POINTS: Final = 1 << 12
"""Points that are pressed at once."""


@kernel
def _counted(near: I4x2, count: I4x1) -> None:
    """Add to count (P + 1,) how many pairs each segment is in, one place further on."""
    for k in range(len(near)):
        count[near[k, 0] + 1] += 1
        count[near[k, 1] + 1] += 1


@kernel
def _listed(near: I4x2, place: I4x1, beside: I4x1) -> None:
    """Fill beside (2 Q,) with the segments near each one, from its ``place`` on; places are moved on."""
    for k in range(len(near)):
        i, j = near[k, 0], near[k, 1]
        beside[place[i]] = j
        place[i] += 1
        beside[place[j]] = i
        place[j] += 1


@kernel
def _press(
    coords: F8x2,
    radius: F8x1,
    ring: I8x1,
    first: I4x1,
    beside: I4x1,
    sides: int,
    ridge: float,
    begin: int,
    end: int,
    vertices: F8x2,
    left: F8x2,
) -> None:
    """Fill ``left`` (P, sides) for points ``begin`` to ``end``: what is left of how far out each corner of a ring stands, none further
    than half way to another strand.

    ring : (P,) the first vertex of each point's ring, or -1; first, beside : the segments near each segment
    ridge : how far out, in radii, the plies of a ring stand. They are pressed as one
    """
    room, wide, way = np.zeros(sides), np.zeros(sides), np.zeros((sides, 3))
    m = np.zeros(3)
    for i in range(begin, end):
        if ring[i] < 0:
            continue
        for k in range(sides):
            size = 0.0
            for c in range(3):
                way[k, c] = vertices[ring[i] + k, c] - coords[i, c]
                size += way[k, c] * way[k, c]
            wide[k], room[k] = sqrt(size), 1e9
            for c in range(3):
                way[k, c] /= max(wide[k], 1e-12)
            wide[k] = ridge * radius[i]
        touched = False
        for own in range(max(i - 1, 0), i + 1):
            for at in range(first[own], first[own + 1]):
                j = beside[at]
                # The nearest point of that stretch, and the plane half way to it, or nearer to what is thinner.
                dot = square = 0.0
                for c in range(3):
                    step = coords[j + 1, c] - coords[j, c]
                    dot += step * (coords[i, c] - coords[j, c])
                    square += step * step
                t = min(1.0, max(0.0, dot / max(square, 1e-18)))
                far = 0.0
                for c in range(3):
                    m[c] = coords[j, c] + t * (coords[j + 1, c] - coords[j, c]) - coords[i, c]
                    far += m[c] * m[c]
                far = sqrt(far)
                other = (1.0 - t) * radius[j] + t * radius[j + 1]
                if far < 1e-9 or far >= radius[i] + other:
                    continue
                half = far * radius[i] / (radius[i] + other)
                for k in range(sides):
                    lies = (way[k, 0] * m[0] + way[k, 1] * m[1] + way[k, 2] * m[2]) / far
                    if lies > 1e-3:
                        room[k] = min(room[k], half / lies)
                        touched = True
        if not touched:
            continue
        # What gives way on one side is thicker on the others.
        fuller = 1.0
        for _ in range(3):
            kept = whole = 0.0
            for k in range(sides):
                w = fuller * wide[k]
                out = w / (1.0 + (w / room[k]) ** SHOULDER) ** (1.0 / SHOULDER)
                kept += out * out
                whole += wide[k] * wide[k]
            fuller = min(FULLER, max(1.0, fuller * sqrt(KEPT * whole / max(kept, 1e-18))))
        for k in range(sides):
            w = fuller * wide[k]
            left[i, k] = max(LEAST, w / (1.0 + (w / room[k]) ** SHOULDER) ** (1.0 / SHOULDER) / wide[k])


@kernel
def _shared(ring: I8x1, sides: int, begin: int, end: int, least: F8x2, left: F8x2, shared: F8x2) -> None:
    """Fill ``shared`` for points ``begin`` to ``end``: what is ``left`` (P, sides) of each corner, shared with its neighbours, none more than ``least``.

    What is soft has no dent with an edge; and what gives way beside a dent goes in, so that nothing comes out into another strand.
    """
    for i in range(begin, end):
        if ring[i] < 0:
            continue
        before = i - 1 if i > 0 and ring[i - 1] >= 0 and ring[i] - ring[i - 1] == sides else i
        after = i + 1 if i + 1 < len(ring) and ring[i + 1] - ring[i] == sides else i
        for k in range(sides):
            a, b = (k + sides - 1) % sides, (k + 1) % sides
            mean = (
                0.25 * (left[before, k] + left[after, k] + left[i, a] + left[i, b])
                + 0.125 * (left[before, a] + left[before, b] + left[after, a] + left[after, b])
                + 0.5 * left[i, k]
            ) / 2.0
            shared[i, k] = min(mean, least[i, k])


@kernel
def _moved(coords: F8x2, ring: I8x1, sides: int, begin: int, end: int, left: F8x2, vertices: F8x2) -> None:
    """Move the vertices of the rings of points ``begin`` to ``end`` in by ``left``."""
    for i in range(begin, end):
        if ring[i] < 0:
            continue
        for k in range(sides):
            for c in range(3):
                vertices[ring[i] + k, c] = coords[i, c] + left[i, k] * (vertices[ring[i] + k, c] - coords[i, c])


def _over(ring: Array, sides: int, least: Array, left: Array, shared: Array, begin: int, end: int) -> None:
    _shared(ring, sides, begin, end, least, left, shared)


def pressed(made: Strands, vertices: Array, sides: int, along: float, ridge: float = 1.0) -> Array:
    """The vertices of :func:`tambour.geometry.tube.sweep`'s tubes of strands, with ``sides`` corners, pressed against each other.

    along : mm, stretches of one strand nearer to each other along it do not press; ridge : radii that plies stand out to
    """
    coords, ends = made.paths.coords, np.asarray(made.paths.offsets)
    near = pairs(coords, ends, 2.0 * float(made.radius.max(initial=0.0)), along)
    first = np.zeros(len(coords) + 1, np.int32)
    _counted(near, first)
    np.cumsum(first, out=first, dtype=np.int32)
    beside = np.empty(2 * len(near), np.int32)
    _listed(near, first[:-1].copy(), beside)
    count = np.diff(ends)
    swept = np.where(count > 1, (count + 2) * sides + 2, 0)
    # Within a strand: a pole, a ring more than there are points, and these.
    begin = np.cumsum(swept) - swept + 1 + sides
    ring = np.repeat(np.where(count > 1, begin - ends[:-1] * sides, -1), count)
    ring = np.where(ring < 0, -1, ring + sides * np.arange(len(coords))) if len(ring) else ring
    out, left = np.array(vertices), np.ones((len(coords), sides))
    share(
        len(coords),
        POINTS,
        lambda a, b: _press(coords, made.radius, ring, first, beside, sides, ridge, a, b, out, left),
    )
    least = left.copy()
    for _ in range(SHARED):
        last = left.copy()
        share(len(coords), POINTS, partial(_over, ring, sides, least, last, left))
    share(len(coords), POINTS, lambda a, b: _moved(coords, ring, sides, a, b, left, out))
    return out

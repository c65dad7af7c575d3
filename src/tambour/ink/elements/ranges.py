"""Distant ranges: soft clouded silhouettes that thin out at their ends and melt towards their feet."""

from __future__ import annotations

import math

from tambour.core.check import Array
from tambour.core.kernels import kernel
from tambour.ink.brush.stroke import HUE, OPEN, Brush, lattice, part, rnd, wash
from tambour.ink.brush.stroke import at as to
from tambour.ink.ground.codes import RANGE
from tambour.ink.ground.marks import FAR, INK
from tambour.noise import ease, value

STEP = 10.0
"""Width of a column of facets, units."""
FACET = 11.0
"""About how high a facet is."""
LOST = 0.16
"""The part of a range over which it comes out of the mist at each end: a sharp tail would look like a wedge of paper."""
THIN = 0.3
"""The part of a range over which it rises from each end."""


@kernel
def rise(table: Array, k: float, total: float, seed: float) -> float:
    """How high the crest stands at step ``k`` of ``total``, 0…1: noise that thins out towards both ends."""
    p = k / total
    edge = min(p, 1.0 - p) / THIN
    return value(table, 0.05 * k, seed, 0.0) * (ease(edge) if edge < 1.0 else 1.0)


@kernel
def cloud(table: Array, x: float, y: float) -> float:
    """One octave of blended lattice, 0…1: it has no fine grain, so that facets melt into each other."""
    fx, fy = math.floor(x), math.floor(y)
    o = int(fx) + 1619 * int(fy)
    u, v = ease(x - fx), ease(y - fy)
    a, b = table[o & 4095], table[(o + 1619) & 4095]
    a += u * (table[(o + 1) & 4095] - a)
    b += u * (table[(o + 1620) & 4095] - b)
    return a + v * (b - a)


@kernel
def distant(brush: Brush, x: float, y: float, height: float, length: float, pale: float) -> None:
    """A range from (x, y) to the right, ``length`` long, its crest at about half of ``height``; ``pale`` 0…1: how far off.

    Uneven columns of uneven facets, each of one tone: grey 205 + 40 c of its middle (200 + 55 N, with finer clouds, in the original:
    dossier 1.8), c two octaves of blended lattice; and towards the foot paler, here more and there less, as the mist lies.
    """
    before = part(brush, RANGE, x, y)
    brush.n[HUE] = FAR
    own, seed = lattice(brush.rng), 0.0
    phase = math.floor(4096.0 * rnd(brush.rng))
    count = max(2, int(length / STEP))
    a, lean = x, 0.0
    left, under = rise(own, 0.0, count, seed), foot(own, 0.0, count, seed)
    for i in range(count):
        right, below = rise(own, i + 1.0, count, seed), foot(own, i + 1.0, count, seed)
        la, lb, ra, rb = y - height * left, y + under, y - height * right, y + below
        b, slant = x + length * (i + 1) / count, 0.0
        if i < count - 1:
            b += 0.4 * STEP * (brush.table[(phase + i) & 4095] - 0.5)
            slant = 1.2 * STEP * (brush.table[(phase + i + 977) & 4095] - 0.5)
        edge = min(i + 0.5, count - i - 0.5) / (LOST * count)
        lost = 1.0 - ease(edge) if edge < 1.0 else 0.0
        rows = max(1, int((lb - la + rb - ra) / (2.0 * FACET)))
        p, q = 0.0, 0.0
        for r in range(rows):
            c, d = 1.0, 1.0
            if r < rows - 1:
                c = (r + 0.75 + 0.5 * brush.table[(phase + 31 * i + r) & 4095]) / rows
                d = (r + 0.75 + 0.5 * brush.table[(phase + 31 * i + 31 + r) & 4095]) / rows
            low = 0.25 * (p + q + c + d)
            mx, my = 0.5 * (a + b) + 37.0 * phase, 0.5 * (la + ra + low * (lb - la + rb - ra))
            # The lattice lies slanted, so that its cells do not show as upright blocks.
            mx, my = mx + 0.6 * my, my - 0.4 * mx
            grey = 205.0 + 40.0 * (0.65 * cloud(own, mx / 90.0, my / 60.0) + 0.35 * cloud(own, mx / 37.0, my / 30.0))
            mist = 1.5 * cloud(own, mx / 170.0, my / 90.0) - 0.45
            grey += (255.0 - grey) * min(1.0, pale + max(0.0, mist) * (0.1 + 0.9 * low * low))
            grey += (255.0 - grey) * lost
            to(brush, a + lean * p, la + p * (lb - la))
            to(brush, b + slant * q, ra + q * (rb - ra))
            to(brush, b + slant * d, ra + d * (rb - ra))
            to(brush, a + lean * c, la + c * (lb - la))
            to(brush, a + lean * p, la + p * (lb - la))
            wash(brush, math.floor(grey), 1.0, 1.0)
            p, q = c, d
        a, lean, left, under = b, slant, right, below
    brush.n[HUE] = INK
    brush.n[OPEN] = before


@kernel
def foot(table: Array, k: float, total: float, seed: float) -> float:
    """How far the lower edge hangs below the range's level at step ``k``, units."""
    p = k / total
    edge = min(p, 1.0 - p) / THIN
    return 24.0 * value(table, 0.05 * k, 2.0, seed) * (ease(edge) if edge < 1.0 else 1.0)

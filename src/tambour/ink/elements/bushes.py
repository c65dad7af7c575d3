"""Low growth: the washed bush and the fan of dry reeds (tree07 and tree08 of the seed's source)."""

from __future__ import annotations

import math

import numpy as np

from tambour.core.arrays import F8x2, F8x3
from tambour.core.check import Array
from tambour.core.kernels import inner, kernel
from tambour.ink.brush.press import TOUCH, touch
from tambour.ink.brush.stroke import FADE, HUE, OPEN, PI, PUFF, Brush, at, bell, between, part, rnd, side, stroke, wash
from tambour.ink.ground.codes import BUSH, REED
from tambour.ink.ground.marks import INK, LEAF
from tambour.noise import value

LEVELS = 10
GRAIN = 0.02
"""Cells of the field of tones in a unit."""


@inner
def shatter(
    brush: Brush,
    ring: Array,
    largest: float,
    grain: float,
    phase: float,
    low: float,
    range_: float,
    alpha: float,
    seam: float,
) -> None:
    """A wash: a polygon cut to a fan of triangles, each halved across its longest side until below ``largest``.

    ring (k, 2), convex enough for a fan from its second point; each triangle takes the grey ``low + range_ × noise`` at
    ``grain`` × its middle, so that the tone is mottled. ``seam`` > 0 strokes triangles in their own tone and hides the
    joints. (The triangulation that the seed diary left for another day: dossier 1.3, 2.8.)
    """
    todo = np.empty((64, 6))
    for k in range(1, len(ring) - 1):
        t = todo[0]
        t[0], t[1], t[2], t[3], t[4], t[5] = (
            ring[0, 0],
            ring[0, 1],
            ring[k, 0],
            ring[k, 1],
            ring[k + 1, 0],
            ring[k + 1, 1],
        )
        left = 1
        while left > 0:
            left -= 1
            t = todo[left]
            ax, ay, bx, by, cx, cy = t[0], t[1], t[2], t[3], t[4], t[5]
            area = 0.5 * abs((bx - ax) * (cy - ay) - (cx - ax) * (by - ay))
            if area < largest or left > 61:
                if area < 0.01:
                    continue
                mx, my = (ax + bx + cx) / 3.0, (ay + by + cy) / 3.0
                at(brush, ax, ay)
                at(brush, bx, by)
                at(brush, cx, cy)
                at(brush, ax, ay)
                grey = math.floor(low + range_ * value(brush.table, grain * mx, grain * my, phase))
                wash(brush, grey, alpha, seam)
                continue
            ab, bc = (bx - ax) ** 2 + (by - ay) ** 2, (cx - bx) ** 2 + (cy - by) ** 2
            ca = (ax - cx) ** 2 + (ay - cy) ** 2
            if bc >= ab and bc >= ca:
                ax, ay, bx, by, cx, cy = bx, by, cx, cy, ax, ay
            elif ca >= ab:
                ax, ay, bx, by, cx, cy = cx, cy, ax, ay, bx, by
            mx, my = 0.5 * (ax + bx), 0.5 * (ay + by)
            t[0], t[1], t[2], t[3], t[4], t[5] = ax, ay, mx, my, cx, cy
            t = todo[left + 1]
            t[0], t[1], t[2], t[3], t[4], t[5] = mx, my, bx, by, cx, cy
            left += 2


@kernel
def bush(brush: Brush, x: float, y: float, height: float, width: float, tone: float, forms: F8x3, loops: F8x2) -> None:
    """A bush of slanting washes on a thin stem that leans: tree07; forms and loops are the press's tools.

    tone : where the field of tones begins. The field lies over the whole scroll, so that bushes which are given the same
    tone run together to one mass, dark and light in slow drifts, whose strokes show only at its rim.
    """
    before = part(brush, BUSH, x, y)
    phase = 64.0 * rnd(brush.rng)
    stem = np.empty((2 * LEVELS + 1, 2))
    for i in range(LEVELS):
        for s in range(2):
            drift = (value(brush.table, 0.5 * i, phase + 0.5 * s, 0.0) - 0.5) * width + (s - 0.5) * width
            k = i if s == 0 else 2 * LEVELS - 1 - i
            stem[k, 0] = x + 20.0 * math.sqrt(i / LEVELS) + drift
            stem[k, 1] = y + 0.08 * height - i * height / LEVELS
    stem[2 * LEVELS] = stem[0]
    rung = np.empty((5, 2))
    for i in range(LEVELS - 1):
        rung[0], rung[1], rung[2] = stem[i], stem[i + 1], stem[2 * LEVELS - 2 - i]
        rung[3], rung[4] = stem[2 * LEVELS - 1 - i], stem[i]
        shatter(brush, rung, 50.0, GRAIN, tone, 80.0, 205.0, 0.8, 0.0)
    brush.n[HUE] = LEAF
    axis, ring = np.empty((2, 2)), np.empty((TOUCH, 2))
    for i in range(1, LEVELS):
        # Down to the ground: rows of bare stems would look like legs.
        length, breadth = between(brush.rng, 20.0, 70.0) * (0.6 if i < 3 else 1.0), between(brush.rng, 11.0, 23.0)
        angle = -rnd(brush.rng) * PI / 6.0
        cx = x + 20.0 * math.sqrt(i / LEVELS) + between(brush.rng, -0.3, 0.3) * width * (LEVELS - i)
        cy = y - 0.07 * height - i * height / LEVELS + between(brush.rng, -0.25, 0.25) * width
        dx, dy = 0.5 * length * math.cos(angle), 0.5 * length * math.sin(angle)
        axis[0, 0], axis[0, 1], axis[1, 0], axis[1, 1] = cx - dx, cy - dy, cx + dx, cy + dy
        touch(axis, breadth, 0.5, forms[PUFF], loops[int(rnd(brush.rng) * len(loops))], ring)
        shatter(brush, ring, 50.0, GRAIN, tone, 80.0, 205.0, 0.8, 0.0)
    brush.n[HUE] = INK
    brush.n[OPEN] = before


@inner
def grass(brush: Brush, x: float, y: float, height: float) -> None:
    """A tuft: a few short blades that fan out from (x, y)."""
    for _ in range(3 + int(4.0 * rnd(brush.rng))):
        turn, long = 0.75 * bell(brush.rng), height * between(brush.rng, 0.5, 1.0)
        for i in range(6):
            p = i / 5.0
            at(brush, x + long * p * (turn + 0.5 * turn * p), y - long * p * (1.0 - 0.2 * p))
        stroke(brush, 100.0, between(brush.rng, 0.35, 0.7), 0.07 * height, 0.4, FADE, 0.0)


@kernel
def reed(brush: Brush, x: float, y: float, height: float, width: float) -> None:
    """A dry thorny fan: a leaning stem, with sprays of forked curved strokes along it (tree08)."""
    before = part(brush, REED, x, y)
    stem = np.empty((16, 2))
    lean = between(brush.rng, -0.2, 0.2) * PI
    heading, a, b = -0.5 * PI + lean, x, y
    for i in range(16):
        stem[i, 0], stem[i, 1] = a, b
        heading += 0.35 * bell(brush.rng) + 0.1 * (-0.5 * PI + lean - heading)
        a, b = a + math.cos(heading) * height / 15.0, b + math.sin(heading) * height / 15.0
    for i in range(16):
        at(brush, stem[i, 0], stem[i, 1])
    stroke(brush, 100.0, 0.75, 1.7 * width, 0.4, FADE, 1.0)
    todo = np.empty((16, 6))
    for i in range(1, 16):
        if rnd(brush.rng) > 0.35 and i < 15:
            continue
        t = todo[0]
        t[0], t[1], t[2] = stem[i, 0], stem[i, 1], 1.0 + math.floor(3.0 * rnd(brush.rng))
        t[3], t[4], t[5] = (
            -0.5 * PI + lean * rnd(brush.rng) + side(brush.rng) * between(brush.rng, 0.2, 0.8),
            0.2 * height,
            1.0,
        )
        left = 1
        while left > 0:
            left -= 1
            t = todo[left]
            sx, sy, depth, angle, size, thick = t[0], t[1], t[2], t[3], t[4], t[5]
            bow = side(brush.rng) * between(brush.rng, 0.05, 0.2) * size
            c, s = math.cos(angle), math.sin(angle)
            for k in range(11):
                p = 0.1 * k
                off = bow * math.sin(PI * p)
                at(brush, sx + c * size * p - s * off, sy + s * size * p + c * off)
            stroke(brush, 100.0, 0.7, 1.2 * width * thick, 0.5, FADE, 0.9)
            if depth > 0 and left < 13:
                ex, ey = sx + c * size, sy + s * size
                fork = 2 if rnd(brush.rng) < 0.5 else 1
                for f in range(fork):
                    t = todo[left]
                    spread = (2.0 * f - 1.0) * between(brush.rng, 0.2, 0.6) if fork == 2 else 0.35 * bell(brush.rng)
                    # Sprays turn upwards as they go.
                    turn = angle + spread + 0.15 * (-0.5 * PI - angle)
                    t[0], t[1], t[2], t[3] = ex, ey, depth - 1.0, turn
                    t[4], t[5] = size * between(brush.rng, 0.75, 0.95), 0.75 * thick
                    left += 1
    brush.n[OPEN] = before

"""Low growth: the washed bush and the fan of dry reeds (tree07 and tree08 of the seed's source)."""

from __future__ import annotations

import math

import numpy as np

from tambour.core.check import Array
from tambour.core.kernels import kernel
from tambour.ink.brush import FADE, HUE, OPEN, PI, PUFF, at, between, line, part, rnd, side, stroke, wash
from tambour.ink.kinds import BUSH, REED
from tambour.ink.limbs import SIDES, branch
from tambour.ink.marks import INK, LEAF
from tambour.ink.press import TOUCH, touch
from tambour.noise import value


@kernel
def shatter(
    table: Array, pts: Array, marks: Array, n: Array,
    ring: Array, largest: float, grain: float, phase: float, low: float, range_: float, alpha: float, seam: float,
) -> None:  # fmt: skip
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
                at(pts, n, ax, ay)
                at(pts, n, bx, by)
                at(pts, n, cx, cy)
                at(pts, n, ax, ay)
                grey = math.floor(low + range_ * value(table, grain * mx, grain * my, phase))
                wash(marks, n, grey, alpha, seam)
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
def bush(
    table: Array, rng: Array, pts: Array, marks: Array, elems: Array, n: Array,
    x: float, y: float, height: float, width: float, forms: Array, loops: Array,
) -> None:  # fmt: skip
    """A bush of slanting washes over a short stem; forms and loops are the press's tools."""
    before = part(elems, n, BUSH, x, y)
    n[HUE] = LEAF
    phase = math.floor(4096.0 * rnd(rng)) + 0.5
    axis, ring = np.empty((2, 2)), np.empty((TOUCH, 2))
    for i in range(10):
        bend = 20.0 * math.sqrt(0.1 * i)
        cx, cy = x + bend, y - 0.1 * i * height
        if i >= 3:
            length, breadth = between(rng, 20.0, 70.0), between(rng, 12.0, 24.0)
            angle = -rnd(rng) * PI / 6.0
            cx += between(rng, -0.6, 0.6) * width * (10.0 - i)
            dx, dy = 0.5 * length * math.cos(angle), 0.5 * length * math.sin(angle)
            axis[0, 0], axis[0, 1], axis[1, 0], axis[1, 1] = cx - dx, cy - dy, cx + dx, cy + dy
            touch(axis, breadth, 0.5, forms[PUFF], loops[int(rnd(rng) * len(loops))], ring)
            shatter(table, pts, marks, n, ring, 50.0, 0.02, phase, 50.0, 200.0, 0.8, 0.0)
    n[HUE] = INK
    n[OPEN] = before


@kernel
def reed(
    table: Array, rng: Array, pts: Array, marks: Array, elems: Array, n: Array,
    x: float, y: float, height: float, width: float,
) -> None:  # fmt: skip
    """Dry reeds: a thin leaning stem, with sprays of forked curved strokes along it."""
    before = part(elems, n, REED, x, y)
    limb = np.empty((SIDES, 2))
    lean = between(rng, -0.2, 0.2) * PI
    branch(table, rng, limb, x, y, height, width, -0.5 * PI + lean, 0.2 * PI)
    for i in range(SIDES):
        at(pts, n, limb[i, 0], limb[i, 1])
    line(marks, n, 100.0, 0.5, 0.8)
    todo = np.empty((16, 6))
    for i in range(SIDES):
        if rnd(rng) > 0.2:
            continue
        t = todo[0]
        t[0], t[1], t[2], t[3] = limb[i, 0], limb[i, 1], math.floor(4.0 * rnd(rng)), -0.5 * PI - lean * rnd(rng)
        t[4], t[5] = 15.0, 0.0
        left = 1
        while left > 0:
            left -= 1
            t = todo[left]
            sx, sy, depth, angle, size, bend = t[0], t[1], t[2], t[3], t[4], t[5]
            bow = side(rng)
            c, s = math.cos(angle), math.sin(angle)
            for k in range(11):
                p = 0.1 * k
                off = bow * 2.0 * math.sin(PI * p)
                at(pts, n, sx + c * size * p - s * off, sy + s * size * p + c * off)
            stroke(rng, marks, n, 100.0, 0.5, 0.8, 0.5, FADE, 1.0)
            if depth > 0 and left < 13:
                ex, ey = sx + c * size, sy + s * size
                bend += side(rng) * PI * 0.001 * depth * depth
                fork = 2 if rnd(rng) < 0.5 else 1
                for f in range(fork):
                    t = todo[left]
                    spread = (2.0 * f - 1.0) * between(rng, 0.1, 0.35) if fork == 2 else 0.0
                    t[0], t[1], t[2], t[3] = ex, ey, depth - 1.0, angle + bend + spread
                    t[4], t[5] = size * between(rng, 0.8, 0.9), bend
                    left += 1
    n[OPEN] = before

"""Limbs: what great trees are made of: branches with two sides, scales of bark, twigs with needles."""

from __future__ import annotations

import math

import numpy as np

from tambour.core.check import Array
from tambour.core.kernels import inner, kernel
from tambour.ink.brush.stroke import FADE, HUE, LENS, PI, SINE, Brush, at, bell, between, blob, ring, rnd, side, stroke
from tambour.ink.ground.marks import INK, LEAF
from tambour.noise import value

NODES = 31
"""Points on one side of a branch: three runs of ten, and the tip."""
SIDES = 2 * NODES

NEEDLES = 10
"""Needles of a wheel."""


@kernel
def branch(
    table: Array, rng: Array, limb: Array, x: float, y: float, length: float, width: float, angle: float, bend: float
) -> None:
    """Fill ``limb`` (SIDES, 2): up one side of a branch, down the other; the tip is in the middle.

    From (x, y) over three straight runs whose headings wander by up to ``bend``, turned so that the whole points along
    ``angle`` (y down: -π/2 is up); half the width at the tip, trembling sides, a knot at each run's start (1.7).
    """
    knee = np.zeros((4, 2))
    heading = 0.0
    for k in range(3):
        heading += side(rng) * 0.5 * bend * (1.0 + rnd(rng))
        knee[k + 1, 0] = knee[k, 0] + math.cos(heading) * length / 3.0
        knee[k + 1, 1] = knee[k, 1] + math.sin(heading) * length / 3.0
    turn = angle - math.atan2(knee[3, 1], knee[3, 0])
    c, s = math.cos(turn), math.sin(turn)
    left, right = 4096.0 * rnd(rng), 4096.0 * rnd(rng)
    jitter = width * length / 80.0
    knot = 0.0
    for i in range(NODES):
        k = min(i // 10, 2)
        p = i / 10.0 - k
        dx, dy = knee[k + 1, 0] - knee[k, 0], knee[k + 1, 1] - knee[k, 1]
        a, b = knee[k, 0] + p * dx, knee[k, 1] + p * dy
        # Near a knee the way is rounded: a quadratic between points a third of a run from it.
        j = k if p < 0.34 else k + 1
        if (p < 0.34 or p > 0.66) and 0 < j < 3:
            q = 0.5 + 1.5 * (p if p < 0.34 else p - 1.0)
            ex, ey = knee[j, 0] - knee[j - 1, 0], knee[j, 1] - knee[j - 1, 1]
            gx, gy = knee[j + 1, 0] - knee[j, 0], knee[j + 1, 1] - knee[j, 1]
            a = knee[j, 0] + (q * q * gx - (1.0 - q) ** 2 * ex) / 3.0
            b = knee[j, 1] + (q * q * gy - (1.0 - q) ** 2 * ey) / 3.0
            dx, dy = (1.0 - q) * ex + q * gx, (1.0 - q) * ey + q * gy
        d = math.sqrt(dx * dx + dy * dy) + 1e-9
        nx, ny = -(s * dx + c * dy) / d, (c * dx - s * dy) / d
        if i % 10 == 0:
            knot = width * rnd(rng) * (0.3 if i == 0 else 1.0)
        half = width * (1.0 - 0.5 * i / NODES) + knot * max(0.0, 1.0 - 0.55 * min(i % 10, 10 - i % 10))
        # The sides may tremble, but not meet.
        up = max(0.45 * half, half + jitter * (value(table, 0.3 * i, left, 0.0) - 0.5))
        down = max(0.45 * half, half + jitter * (value(table, 0.3 * i, right, 0.0) - 0.5))
        px, py = x + c * a - s * b, y + s * a + c * b
        limb[i, 0], limb[i, 1] = px + nx * up, py + ny * up
        limb[SIDES - 1 - i, 0], limb[SIDES - 1 - i, 1] = px - nx * down, py - ny * down


@inner
def scales(brush: Brush, limb: Array, size: float, often: float) -> None:
    """The bark of a branch: knots and rings across it, moss at its sides, and broken second lines along them (1.7).

    size : of all of it, 1 on a trunk 12 units thick; often : 0…1, how many nodes have a ring or a knot
    """
    for i in range(1, NODES - 1):
        if rnd(brush.rng) > often:
            continue
        lx, ly = limb[i, 0], limb[i, 1]
        rx, ry = limb[SIDES - 1 - i, 0], limb[SIDES - 1 - i, 1]
        along = math.atan2(limb[i, 1] - limb[i - 1, 1], limb[i, 0] - limb[i - 1, 0])
        p = rnd(brush.rng)
        x, y = lx + p * (rx - lx), ly + p * (ry - ly)
        if rnd(brush.rng) < 0.2:
            breadth = size * (6.0 - 10.0 * abs(p - 0.5))
            blob(brush, x, y, 15.0 * size, breadth, along, 100.0, 0.6, 0.9, LENS)
        else:
            breadth = size * (7.0 - 10.0 * abs(p - 0.5))
            length = size * between(brush.rng, 11.0, 22.0)
            ring(brush, x, y, length, breadth, along, 100.0, 0.55, 0.9)
        if rnd(brush.rng) < 0.05:
            edge = rnd(brush.rng) < 0.5
            x, y = (lx, ly) if edge else (rx, ry)
            count = int(between(brush.rng, 2.0, 4.0))
            for k in range(count):
                shift = (k - 0.5 * count) * 4.0
                a, b = x + math.cos(along) * shift, y + math.sin(along) * shift
                length, breadth = size * between(brush.rng, 4.0, 10.0), size * between(brush.rng, 4.0, 8.0)
                blob(brush, a, b, length, breadth, along + 0.5 * PI, 100.0, 0.6, 0.5, LENS)
    fine = 4 if size > 0.6 else 2
    for s in range(2):
        first = 0
        for i in range(1, NODES):
            if i == NODES - 1 or rnd(brush.rng) < 0.06 + 0.44 * size * often:
                phase, loose = 4096.0 * rnd(brush.rng), size * (10.0 + 5.0 * bell(brush.rng))
                for k in range(fine * (i - first) + 1):
                    j, p = first + k // fine, (k % fine) / fine
                    a, b = (j, min(j + 1, i)) if s == 0 else (SIDES - 1 - j, SIDES - 1 - min(j + 1, i))
                    x = limb[a, 0] + p * (limb[b, 0] - limb[a, 0])
                    y = limb[a, 1] + p * (limb[b, 1] - limb[a, 1])
                    x += (value(brush.table, 0.4 * k / fine, phase, 0.0) - 0.5) * loose
                    y += (value(brush.table, 0.4 * k / fine, phase, 0.5) - 0.5) * loose
                    at(brush, x, y)
                stroke(brush, 100.0, 0.5, 0.4 + 0.7 * size, 0.5, SINE, 0.0)
                first = i


@inner
def twig(
    brush: Brush, x: float, y: float, depth: int, scale: float, angle: float, right: float, needles: float, lift: float
) -> None:
    """A twig that leaves sideways and turns up, with smaller ones on it down to ``depth``, and needles at the tips.

    right : 1 or -1, the side it leaves to; ``angle`` turns it; ``needles``: their size, 1 in the original, 0 for none;
    ``lift``: how far they stand above the tip (1.7)
    Needles are the paler the farther out their twig, and stand as half wheels.
    """
    todo = np.empty((32, 5))
    todo[0, 0], todo[0, 1], todo[0, 2], todo[0, 3], todo[0, 4] = x, y, depth, scale, right
    left = 1
    way = np.empty((10, 2))
    while left > 0:
        left -= 1
        sx, sy, level, size, way_out = todo[left, 0], todo[left, 1], todo[left, 2], todo[left, 3], todo[left, 4]
        turn = (rnd(brush.rng) - 0.1) * PI / 5.0 * way_out + angle
        c, s = math.cos(turn), math.sin(turn)
        stretch, rise, bow = between(brush.rng, 0.45, 1.0), between(brush.rng, 3.5, 5.5), between(brush.rng, 2.5, 6.0)
        for i in range(10):
            a = way_out * (1.0 - (1.0 + 0.1 * i) ** -bow) * 50.0 * size * stretch
            b = -rise * i * size
            way[i, 0], way[i, 1] = sx + c * a - s * b, sy + s * a + c * b
            if (i == 3 or i == 6) and level > 0 and left < 30:
                t = todo[left]
                t[0], t[1], t[2], t[3], t[4] = way[i, 0], way[i, 1], level - 1, 0.8 * size, way_out * side(brush.rng)
                left += 1
            at(brush, way[i, 0], way[i, 1])
        stroke(brush, 100.0, 0.5, 1.0, 0.5, FADE, 1.0)
        if needles > 0.0:
            brush.n[HUE] = LEAF
            # A wheel of needles over the tip: the upper half of one, its middle the longest, each as thin as a needle.
            cx, cy = way[9, 0] + needles * 4.0 * bell(brush.rng), way[9, 1] - 0.35 * lift / (level + 1.0)
            alpha = 0.4 + 0.14 * level + 0.16 * rnd(brush.rng)
            for k in range(NEEDLES):
                turn = angle * 0.5 - 0.5 * PI + (k / (NEEDLES - 1.0) - 0.5) * 1.2 * PI + 0.2 * bell(brush.rng)
                length = needles * between(brush.rng, 14.0, 22.0) * (1.0 - 0.25 * abs(2.0 * k / (NEEDLES - 1.0) - 1.0))
                a, b = cx + 0.5 * length * math.cos(turn), cy + 0.5 * length * math.sin(turn)
                blob(brush, a, b, length, needles * between(brush.rng, 1.5, 2.6), turn, 100.0, alpha, 0.4, LENS)
            brush.n[HUE] = INK

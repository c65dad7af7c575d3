"""Great trees: the bent pine, the upright cedar, the bare plum (tree04 to tree06 of the seed's source)."""

from __future__ import annotations

import math

import numpy as np

from tambour.core.check import Array
from tambour.core.kernels import inner, kernel
from tambour.ink.brush.stroke import (
    EVEN,
    HUE,
    LENS,
    OPEN,
    PI,
    Brush,
    at,
    bell,
    between,
    blob,
    body,
    part,
    pick,
    rnd,
    side,
    stroke,
)
from tambour.ink.elements.limbs import NODES, SIDES, branch, scales, twig
from tambour.ink.ground.codes import CEDAR, PINE, PLUM
from tambour.ink.ground.marks import BLOSSOM, INK

LIMBS = 48
"""The most branches of a tree."""


@kernel
def grow(
    table: Array,
    rng: Array,
    limbs: Array,
    above: Array,
    joint: Array,
    k: int,
    parent: int,
    node: int,
    length: float,
    width: float,
    angle: float,
    bend: float,
) -> int:
    """Grow limb ``k`` from ``node`` of limb ``parent``; gives k + 1, or k where there is no room."""
    if k >= len(limbs):
        return k
    # It starts a little inside its parent, which the outline of both does not show.
    other, q = SIDES - 1 - node, 0.5 if node == NODES - 1 else 0.3
    x = (1.0 - q) * limbs[parent, node, 0] + q * limbs[parent, other, 0]
    y = (1.0 - q) * limbs[parent, node, 1] + q * limbs[parent, other, 1]
    branch(table, rng, limbs[k], x, y, length, width, angle, bend)
    above[k], joint[k] = parent, node
    return k + 1


@inner
def bark(brush: Brush, limbs: Array, above: Array, joint: Array, count: int, breadth: float, often: float) -> None:
    """Body, outline and bark of a tree whose limbs grow out of one another: one outline goes round all of them.

    breadth : of the outline; often : as in :func:`scales`, less than half of it from each limb to the next
    limbs (count, SIDES, 2); limb k leaves limb ``above[k]`` at its node ``joint[k]``; limbs of one parent stand in any
    order, and their parent before them.
    """
    at_node, long = np.zeros(count, np.int64), np.zeros(count, np.bool_)
    for k in range(count):
        dx, dy = limbs[k, NODES, 0] - limbs[k, 0, 0], limbs[k, NODES, 1] - limbs[k, 0, 1]
        long[k] = dx * dx + dy * dy > 120.0 * 120.0
    for wet in range(2):
        at_node[:] = 0
        k = 0
        while k >= 0:
            i = at_node[k]
            if i == SIDES:
                k = above[k]
                continue
            # A short limb is drawn from node to every second node.
            if i % 2 == 0 or i >= SIDES - 2 or i == NODES - 1 or long[k]:
                at(brush, limbs[k, i, 0], limbs[k, i, 1])
            at_node[k] = i + 1
            for c in range(k + 1, count):
                if above[c] == k and joint[c] == i:
                    k = c
                    break
        if wet == 0:
            body(brush)
        else:
            stroke(brush, 100.0, 0.5, breadth, 0.9, EVEN, 0.0)
    for k in range(count):
        thick = 0.0
        for i in range(4, NODES, 8):
            dx, dy = limbs[k, i, 0] - limbs[k, SIDES - 1 - i, 0], limbs[k, i, 1] - limbs[k, SIDES - 1 - i, 1]
            thick += 0.25 * math.sqrt(dx * dx + dy * dy)
        size = min(1.0, thick / 12.0)
        depth, j = 0, k
        while above[j] >= 0:
            depth, j = depth + 1, above[j]
        scales(brush, limbs[k], size, often * 0.45**depth)


@kernel
def pine(brush: Brush, x: float, y: float, height: float, width: float) -> None:
    """A big pine: ringed bark, branches in its middle and at its tip, tufts of needles (tree04).

    Half of them are bent, as the seed's, their boughs drooping; of the others some lean far out to one side, some stand
    straight and hold level boughs, one above the other.
    """
    before = part(brush, PINE, x, y)
    form = rnd(brush.rng)
    leaning, level = form < 0.25, form > 0.75
    tilt = between(brush.rng, 0.14, 0.24) * side(brush.rng) if leaning else 0.0
    droop, often = (0.03, 0.17) if level else (0.2, 0.1)
    limbs = np.empty((LIMBS, SIDES, 2))
    above, joint, lean = np.full(LIMBS, -1, np.int64), np.zeros(LIMBS, np.int64), np.zeros(LIMBS)
    branch(brush.table, brush.rng, limbs[0], x, y, height, width, (tilt - 0.5) * PI, (0.05 if level else 0.2) * PI)
    count = 1
    for i in range(SIDES):
        if (0.3 * SIDES <= i <= 0.7 * SIDES and rnd(brush.rng) < often) or i == NODES - 1:
            lean[min(count, LIMBS - 1)] = (droop - (1.0 + 2.0 * droop) * (1.0 if i > NODES else 0.0)) * PI
            length = height * between(brush.rng, 0.3, 0.6)
            count = grow(
                brush.table,
                brush.rng,
                limbs,
                above,
                joint,
                count,
                0,
                i,
                length,
                0.5 * width,
                lean[min(count, LIMBS - 1)],
                0.2 * PI,
            )
    bark(brush, limbs, above, joint, count, 2.5, 1.0)
    for k in range(1, count):
        right = lean[k] > -0.5 * PI
        angle = lean[k] if right else lean[k] + PI
        # Tufts: two or three places along a bough where twigs crowd, and hardly any between.
        beat, start = between(brush.rng, 8.0, 13.0), between(brush.rng, 0.0, 5.0)
        for i in range(NODES):
            crowd = 0.45 if (i + start) % beat > 0.55 * beat else 0.03
            if rnd(brush.rng) < crowd or i == NODES - 1:
                px, py = limbs[k, i, 0], limbs[k, i, 1]
                twig(brush, px, py, 1, 0.5 * height / 300.0, angle, 1.0 if right else -1.0, 1.0, 12.0)
    brush.n[OPEN] = before


@kernel
def cedar(brush: Brush, x: float, y: float, height: float, width: float) -> None:
    """An upright tiered tree: a straight trunk, short dense branches above, few long ones below (tree05)."""
    before = part(brush, CEDAR, x, y)
    limbs = np.empty((LIMBS, SIDES, 2))
    above, joint, lean = np.full(LIMBS, -1, np.int64), np.zeros(LIMBS, np.int64), np.zeros(LIMBS)
    branch(brush.table, brush.rng, limbs[0], x, y, height, width, -0.5 * PI, 0.0)
    count = 1
    for i in range(SIDES):
        p = abs(i - 0.5 * SIDES) / (0.5 * SIDES)
        if (0.2 * SIDES <= i <= 0.8 * SIDES and i % 3 == 0 and rnd(brush.rng) > p) or i == NODES - 1:
            droop = 0.2 * rnd(brush.rng)
            angle = -droop * PI - (1.0 - 2.0 * droop) * PI * (1.0 if i > NODES else 0.0)
            length = height * max(0.04, 0.36 * p - 0.07 * rnd(brush.rng))
            lean[min(count, LIMBS - 1)] = angle
            count = grow(brush.table, brush.rng, limbs, above, joint, count, 0, i, length, 0.5 * width, angle, 0.5)
    bark(brush, limbs, above, joint, count, 2.5, 0.9)
    leaf = 0.5 + 0.5 * min(1.0, height / 250.0)
    for k in range(1, count):
        right = lean[k] > -0.5 * PI
        angle = lean[k] if right else lean[k] + PI
        # Tufts stand on the outer half, and one nearer in now and then: between them the bough is seen.
        for i in range(NODES - 1, 0, -9):
            if i < NODES // 2 and rnd(brush.rng) < 0.68:
                continue
            px, py = limbs[k, i, 0], limbs[k, i, 1]
            twig(brush, px, py, 0, 0.25 * height / 300.0, angle, 1.0 if right else -1.0, leaf, 6.0 * leaf)
    brush.n[OPEN] = before


@kernel
def plum(brush: Brush, x: float, y: float, height: float, width: float, bloom: float) -> None:
    """A bare gnarled tree that forks three times near the tips of its branches (tree06).

    bloom : 0…1, how thick blossoms stand on its outer branches
    """
    before = part(brush, PLUM, x, y)
    limbs = np.empty((LIMBS, SIDES, 2))
    above, joint = np.full(LIMBS, -1, np.int64), np.zeros(LIMBS, np.int64)
    lean, depth = np.zeros(LIMBS), np.zeros(LIMBS)
    lean[0] = -0.5 * PI
    branch(brush.table, brush.rng, limbs[0], x, y, 0.85 * height, width, -0.5 * PI, 0.1 * PI)
    count, k = 1, 0
    while k < count:
        # Mostly both shoots at a limb's tip live; where one died the other goes on.
        dead = pick(brush.rng, 2) if k > 0 and rnd(brush.rng) < 0.45 else 2
        for i in range(SIDES):
            stray = 0.2 * SIDES <= i <= 0.8 * SIDES and rnd(brush.rng) < 0.012
            shoot = (i == NODES - 2 and dead != 0) or (i == NODES and dead != 1)
            if depth[k] < 3 and count < LIMBS and (shoot or stray):
                spread = between(brush.rng, 0.1, 0.22) if stray else between(brush.rng, 0.02, 0.12)
                turn = spread * PI * (1.0 if i < NODES else -1.0)
                lean[count], depth[count] = lean[k] + turn, depth[k] + 1.0
                length = 0.85 * height * between(brush.rng, 0.7, 0.9) ** depth[count]
                thin = width * 0.6 ** depth[count]
                count = grow(brush.table, brush.rng, limbs, above, joint, count, k, i, length, thin, lean[count], 0.55)
        k += 1
    bark(brush, limbs, above, joint, count, 2.0, 0.9)
    for k in range(count):
        # Hands of twigs: at the tip of an outer limb, and here and there along it, never two at one place.
        last = -NODES
        for i in range(4, SIDES - 4):
            tip = i == NODES - 1 and depth[k] == 3 and rnd(brush.rng) < 0.75
            if tip or (i - last > 5 and rnd(brush.rng) < 0.006 + 0.008 * depth[k]):
                last = i
                turn = between(brush.rng, -0.15, 0.1) * PI * (1.0 if i >= NODES else -1.0)
                px, py = limbs[k, i, 0], limbs[k, i, 1]
                reach = between(brush.rng, 0.24, 0.4) * (height / 100.0) ** 0.5
                twig(brush, px, py, 2, reach, turn, -1.0 if i < NODES else 1.0, 0.0, 0.0)
    brush.n[HUE] = BLOSSOM
    for k in range(count):
        for i in range(2, NODES):
            if depth[k] > 1 and rnd(brush.rng) < 0.5 * bloom:
                px, py = limbs[k, i, 0] + 4.0 * bell(brush.rng), limbs[k, i, 1] + 4.0 * bell(brush.rng)
                size = between(brush.rng, 4.0, 7.0)
                blob(
                    brush, px, py, size, 0.9 * size, PI * rnd(brush.rng), 120.0, between(brush.rng, 0.4, 0.8), 0.4, LENS
                )
    brush.n[HUE] = INK
    brush.n[OPEN] = before

"""Where people live: a hamlet on low ground by the water, and the bridge that leads to it."""

from __future__ import annotations

import math

import numpy as np

from tambour.core.arrays import F8x1, F8x2, I8x1, U8x1
from tambour.core.kernels import kernel
from tambour.ink.brush.stroke import OPEN, SINE, at, bell, between, body, lattice, part, pick, rnd, side, stroke
from tambour.ink.elements.cun import slope
from tambour.ink.elements.frames import run
from tambour.ink.elements.hills import DOME, ridge
from tambour.ink.elements.houses import COURT, WING, cottage, homestead, house, pavilion
from tambour.ink.elements.people import BUN, STRAW, WALKS, figure
from tambour.ink.elements.rocks import rock
from tambour.ink.elements.trees import fir, juniper
from tambour.ink.elements.willows import willow
from tambour.ink.ground.codes import BRIDGE, HAMLET
from tambour.noise import value

RISE = 24.0
"""How high the ground of a hamlet rises over the water, units."""


@kernel
def hamlet(
    table: F8x1, rng: U8x1, pts: F8x2, marks: F8x2, elems: F8x2, n: I8x1,
    x: float, y: float, width: float, count: int, planted: float, housed: float, people: float,
) -> None:  # fmt: skip
    """Low ground ``width`` across with its shore at (x, y): trees behind, ``count`` houses in two rows, a path, walkers."""
    before = part(elems, n, HAMLET, x, y)
    own = lattice(rng)
    for _ in range(int((5.0 + 4.0 * rnd(rng)) * planted)):
        a, b = x + 0.33 * width * bell(rng) * 1.6, y - RISE + 6.0 * rnd(rng)
        if rnd(rng) < 0.45:
            fir(table, rng, pts, marks, elems, n, a, b, between(rng, 45.0, 80.0), 4.0, 0.06 * bell(rng), 0.36)
        else:
            juniper(table, rng, pts, marks, elems, n, a, b, between(rng, 22.0, 44.0), between(rng, 1.0, 3.0), 0.36)
    grid = np.empty((4, 40, 2))
    ridge(own, rng, grid, RISE, width, DOME, 0.4 * side(rng))
    slope(rng, pts, marks, n, grid, x, y, 8.0)
    for _ in range(2 + pick(rng, 3)):
        # The shore: short low lines along the water.
        a, b, half = x + 0.3 * width * bell(rng) * 1.6, y + 2.0 + 5.0 * rnd(rng), between(rng, 30.0, 80.0)
        for i in range(9):
            p = i / 4.0 - 1.0
            at(pts, n, a + half * p, b + 1.6 * value(own, 2.0 * p + 9.0, 40.0 + 64.0 * rnd(rng), 0.0))
        stroke(rng, marks, n, 100.0, between(rng, 0.2, 0.4), 1.1, 0.6, SINE, 0.0)
    for row in range(2):
        for k in range(count):
            if (k % 2) != row:
                continue
            a = x + ((k + 0.5) / count - 0.5) * 0.72 * width + 8.0 * bell(rng)
            b = y - RISE * (0.72 - 0.34 * row) + 2.0 * bell(rng)
            kind, turn, wide = pick(rng, 7), between(rng, 0.25, 0.8), between(rng, 34.0, 58.0)
            storeys = 2 if kind == 3 else 1
            if rnd(rng) >= housed:
                continue
            if kind == 5:
                pavilion(table, rng, pts, marks, elems, n, a, b, 13.0, 0.7 * wide, 1)
            elif kind == 6:
                cottage(
                    table, rng, pts, marks, elems, n, a, b, between(rng, 8.0, 11.0), 0.7 * wide, turn, 3.0, 1 + pick(rng, 3)
                )  # fmt: skip
            elif kind == 2 or kind == 4:
                homestead(
                    table, rng, pts, marks, elems, n, a, b, between(rng, 9.0, 11.0), wide, turn, 3.0, 1 + pick(rng, 3),
                    WING if kind == 2 else COURT,
                )  # fmt: skip
            else:
                house(
                    table, rng, pts, marks, elems, n, a, b, between(rng, 8.0, 11.0), wide, turn, 3.0, storeys,
                    1 + pick(rng, 3), kind == 1,
                )  # fmt: skip
    # The path comes up from the shore and is lost behind the houses.
    start, sway = x + 0.2 * width * bell(rng), 26.0 * side(rng)
    for edge in range(2):
        for i in range(14):
            p = i / 13.0
            broad = 5.0 * (1.0 - 0.7 * p)
            at(pts, n, start + sway * math.sin(2.4 * p) + (broad if edge else -broad), y + 3.0 - 0.8 * RISE * p)
        stroke(rng, marks, n, 100.0, 0.3, 0.8, 0.8, SINE, 0.0)
    if rnd(rng) < people:
        for _ in range(1 + pick(rng, 2)):
            p = 0.1 + 0.5 * rnd(rng)
            a, b = start + sway * math.sin(2.4 * p) + 5.0 * bell(rng), y + 4.0 - 0.8 * RISE * p
            figure(
                table,
                rng,
                pts,
                marks,
                elems,
                n,
                a,
                b,
                0.16,
                side(rng),
                BUN if rnd(rng) < 0.5 else STRAW,
                0.7 if rnd(rng) < 0.4 else 0.0,
                WALKS,
            )
    for _ in range(pick(rng, 3) if planted > 0.0 else 0):
        a = x + side(rng) * width * between(rng, 0.3, 0.46)
        willow(table, rng, pts, marks, elems, n, a, y - 1.0, between(rng, 52.0, 84.0), 1.5)
    for _ in range(2 + pick(rng, 3)):
        f = side(rng)
        a, b = x + f * width * between(rng, 0.36, 0.5), y - 2.0 + 6.0 * rnd(rng)
        rock(table, rng, pts, marks, elems, n, a, b, between(rng, 8.0, 18.0), between(rng, 12.0, 26.0), 24, 2.0)
    n[OPEN] = before


@kernel
def bridge(
    table: F8x1, rng: U8x1, pts: F8x2, marks: F8x2, elems: F8x2, n: I8x1,
    x: float, y: float, length: float, right: float, people: float,
) -> None:  # fmt: skip
    """A plank bridge on posts, ``length`` long about (x, y), a little arched, ending on a rock; someone may cross it."""
    before = part(elems, n, BRIDGE, x, y)
    arch = 0.07 * length
    far = x + 0.56 * right * length
    rock(table, rng, pts, marks, elems, n, far, y + 4.0, between(rng, 12.0, 20.0), between(rng, 26.0, 40.0), 30, 2.0)
    for k in range(1, 5):
        p = k / 5.0
        a, b = x + (p - 0.5) * length, y - 6.0 - arch * math.sin(math.pi * p)
        run(rng, pts, marks, n, a, b, a + 0.6 * bell(rng), y + 7.0, 0.9, 0.4)
    for edge in range(2):
        for i in range(21):
            p = i / 20.0 if edge == 0 else 1.0 - i / 20.0
            at(pts, n, x + (p - 0.5) * length, y - 6.0 - arch * math.sin(math.pi * p) - (2.6 if edge else 0.0))
    body(marks, n)
    if rnd(rng) < 0.75 * people:
        p = between(rng, 0.25, 0.75)
        a, b = x + (p - 0.5) * length, y - 7.5 - arch * math.sin(math.pi * p)
        figure(table, rng, pts, marks, elems, n, a, b, 0.17, side(rng), STRAW, 0.8 if rnd(rng) < 0.5 else 0.0, WALKS)
    for edge in range(2):
        for i in range(21):
            p = i / 20.0
            at(pts, n, x + (p - 0.5) * length, y - 6.0 - arch * math.sin(math.pi * p) - (2.6 if edge else 0.0))
        stroke(rng, marks, n, 90.0, 0.6, 0.9, 0.5, SINE, 0.0)
    for i in range(0, 21, 2):
        p = i / 20.0
        a, b = x + (p - 0.5) * length, y - 6.0 - arch * math.sin(math.pi * p)
        run(rng, pts, marks, n, a - 0.8, b, a + 0.8, b - 2.6, 0.4, 0.3)
    n[OPEN] = before

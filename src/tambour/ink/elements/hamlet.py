"""Where people live: a hamlet on low ground by the water, and the bridge that leads to it."""

from __future__ import annotations

import math

import numpy as np

from tambour.core.kernels import kernel
from tambour.ink.brush.stroke import OPEN, SINE, Brush, at, bell, between, body, lattice, part, pick, rnd, side, stroke
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
    brush: Brush, x: float, y: float, width: float, count: int, planted: float, housed: float, people: float
) -> None:
    """Low ground ``width`` across with its shore at (x, y): trees behind, ``count`` houses in two rows, a path, walkers."""
    before = part(brush, HAMLET, x, y)
    own = lattice(brush.rng)
    for _ in range(int((5.0 + 4.0 * rnd(brush.rng)) * planted)):
        a, b = x + 0.33 * width * bell(brush.rng) * 1.6, y - RISE + 6.0 * rnd(brush.rng)
        if rnd(brush.rng) < 0.45:
            fir(brush, a, b, between(brush.rng, 45.0, 80.0), 4.0, 0.06 * bell(brush.rng), 0.36)
        else:
            juniper(brush, a, b, between(brush.rng, 22.0, 44.0), between(brush.rng, 1.0, 3.0), 0.36)
    grid = np.empty((4, 40, 2))
    ridge(own, brush.rng, grid, RISE, width, DOME, 0.4 * side(brush.rng))
    slope(brush, grid, x, y, 8.0)
    for _ in range(2 + pick(brush.rng, 3)):
        # The shore: short low lines along the water.
        a, b, half = (
            x + 0.3 * width * bell(brush.rng) * 1.6,
            y + 2.0 + 5.0 * rnd(brush.rng),
            between(brush.rng, 30.0, 80.0),
        )
        for i in range(9):
            p = i / 4.0 - 1.0
            at(brush, a + half * p, b + 1.6 * value(own, 2.0 * p + 9.0, 40.0 + 64.0 * rnd(brush.rng), 0.0))
        stroke(brush, 100.0, between(brush.rng, 0.2, 0.4), 1.1, 0.6, SINE, 0.0)
    for row in range(2):
        for k in range(count):
            if (k % 2) != row:
                continue
            a = x + ((k + 0.5) / count - 0.5) * 0.72 * width + 8.0 * bell(brush.rng)
            b = y - RISE * (0.72 - 0.34 * row) + 2.0 * bell(brush.rng)
            kind, turn, wide = pick(brush.rng, 7), between(brush.rng, 0.25, 0.8), between(brush.rng, 34.0, 58.0)
            storeys = 2 if kind == 3 else 1
            if rnd(brush.rng) >= housed:
                continue
            if kind == 5:
                pavilion(brush, a, b, 13.0, 0.7 * wide, 1)
            elif kind == 6:
                cottage(brush, a, b, between(brush.rng, 8.0, 11.0), 0.7 * wide, turn, 3.0, 1 + pick(brush.rng, 3))
            elif kind == 2 or kind == 4:
                homestead(
                    brush,
                    a,
                    b,
                    between(brush.rng, 9.0, 11.0),
                    wide,
                    turn,
                    3.0,
                    1 + pick(brush.rng, 3),
                    WING if kind == 2 else COURT,
                )
            else:
                house(
                    brush,
                    a,
                    b,
                    between(brush.rng, 8.0, 11.0),
                    wide,
                    turn,
                    3.0,
                    storeys,
                    1 + pick(brush.rng, 3),
                    kind == 1,
                )
    # The path comes up from the shore and is lost behind the houses.
    start, sway = x + 0.2 * width * bell(brush.rng), 26.0 * side(brush.rng)
    for edge in range(2):
        for i in range(14):
            p = i / 13.0
            broad = 5.0 * (1.0 - 0.7 * p)
            at(brush, start + sway * math.sin(2.4 * p) + (broad if edge else -broad), y + 3.0 - 0.8 * RISE * p)
        stroke(brush, 100.0, 0.3, 0.8, 0.8, SINE, 0.0)
    if rnd(brush.rng) < people:
        for _ in range(1 + pick(brush.rng, 2)):
            p = 0.1 + 0.5 * rnd(brush.rng)
            a, b = start + sway * math.sin(2.4 * p) + 5.0 * bell(brush.rng), y + 4.0 - 0.8 * RISE * p
            figure(
                brush,
                a,
                b,
                0.16,
                side(brush.rng),
                BUN if rnd(brush.rng) < 0.5 else STRAW,
                0.7 if rnd(brush.rng) < 0.4 else 0.0,
                WALKS,
            )
    for _ in range(pick(brush.rng, 3) if planted > 0.0 else 0):
        a = x + side(brush.rng) * width * between(brush.rng, 0.3, 0.46)
        willow(brush, a, y - 1.0, between(brush.rng, 52.0, 84.0), 1.5)
    for _ in range(2 + pick(brush.rng, 3)):
        f = side(brush.rng)
        a, b = x + f * width * between(brush.rng, 0.36, 0.5), y - 2.0 + 6.0 * rnd(brush.rng)
        rock(brush, a, b, between(brush.rng, 8.0, 18.0), between(brush.rng, 12.0, 26.0), 24, 2.0)
    brush.n[OPEN] = before


@kernel
def bridge(brush: Brush, x: float, y: float, length: float, right: float, people: float) -> None:
    """A plank bridge on posts, ``length`` long about (x, y), a little arched, ending on a rock; someone may cross it."""
    before = part(brush, BRIDGE, x, y)
    arch = 0.07 * length
    far = x + 0.56 * right * length
    rock(brush, far, y + 4.0, between(brush.rng, 12.0, 20.0), between(brush.rng, 26.0, 40.0), 30, 2.0)
    for k in range(1, 5):
        p = k / 5.0
        a, b = x + (p - 0.5) * length, y - 6.0 - arch * math.sin(math.pi * p)
        run(brush, a, b, a + 0.6 * bell(brush.rng), y + 7.0, 0.9, 0.4)
    for edge in range(2):
        for i in range(21):
            p = i / 20.0 if edge == 0 else 1.0 - i / 20.0
            at(brush, x + (p - 0.5) * length, y - 6.0 - arch * math.sin(math.pi * p) - (2.6 if edge else 0.0))
    body(brush)
    if rnd(brush.rng) < 0.75 * people:
        p = between(brush.rng, 0.25, 0.75)
        a, b = x + (p - 0.5) * length, y - 7.5 - arch * math.sin(math.pi * p)
        figure(brush, a, b, 0.17, side(brush.rng), STRAW, 0.8 if rnd(brush.rng) < 0.5 else 0.0, WALKS)
    for edge in range(2):
        for i in range(21):
            p = i / 20.0
            at(brush, x + (p - 0.5) * length, y - 6.0 - arch * math.sin(math.pi * p) - (2.6 if edge else 0.0))
        stroke(brush, 90.0, 0.6, 0.9, 0.5, SINE, 0.0)
    for i in range(0, 21, 2):
        p = i / 20.0
        a, b = x + (p - 0.5) * length, y - 6.0 - arch * math.sin(math.pi * p)
        run(brush, a - 0.8, b, a + 0.8, b - 2.6, 0.4, 0.3)
    brush.n[OPEN] = before

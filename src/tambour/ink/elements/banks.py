"""Near banks: low sweeping ground with flat tops, and one group that stands on each."""

from __future__ import annotations

import math

import numpy as np

from tambour.core.arrays import F8x1, F8x2, F8x3
from tambour.core.check import Array
from tambour.core.kernels import kernel
from tambour.ink.brush.stroke import OPEN, PI, SINE, Brush, at, bell, between, body, lattice, part, pick, rnd, stroke
from tambour.ink.elements.bushes import bush, grass, reed
from tambour.ink.elements.cun import SHOULDERS, slope, wrinkles
from tambour.ink.elements.houses import hut
from tambour.ink.elements.pines import cedar, pine, plum
from tambour.ink.elements.rocks import rock
from tambour.ink.elements.willows import willow
from tambour.ink.ground.codes import BANK
from tambour.noise import value

LAYERS, COLUMNS = 5, 50
STONES, CEDARS, PINES, PLUMS, BUSHES, WILLOWS, NOTHING = range(7)
"""The group that a bank carries."""


@kernel
def terrace(
    table: Array, rng: Array, grid: Array, top: Array, seed: float, y: float, height: float, width: float, cut: float
) -> int:
    """Fill ``grid`` (LAYERS, COLUMNS, 2), cut flat at 100 ``cut`` above its foot, and ``top`` (k, 2): the round of the
    flat's edge, cut ends of the contours joined and scalloped; gives k (dossier 1.8)."""
    lefts, rights = np.empty((LAYERS + 6, 2)), np.empty((LAYERS + 6, 2))
    count = 0
    drop = 0.0
    for j in range(LAYERS):
        drop += rnd(rng) * y / 100.0
        p = 1.0 - 0.6 * j / LAYERS
        first, last = -1, -1
        for i in range(COLUMNS):
            t = (i / COLUMNS - 0.5) * PI
            h = (math.cos(2.0 * t) + 1.0) * value(table, t + 10.0, 0.1 * j, seed)
            grid[j, i, 0] = t / PI * width * p
            grid[j, i, 1] = drop - h * height * p
            if grid[j, i, 1] < drop - 100.0 * cut:
                grid[j, i, 1] = drop - 100.0 * cut
                first = i if first < 0 else first
                last = i
        if first >= 0 and last > first + 2:
            lefts[count + 3] = grid[j, first]
            rights[count + 3] = grid[j, last]
            count += 1
    if count < 2:
        return 0
    for k in range(3):
        p = 0.2 + 0.2 * k
        lefts[k, 0], lefts[k, 1] = lefts[3, 0] * p, lefts[3, 1] - 5.0
        rights[k, 0], rights[k, 1] = rights[3, 0] * p, rights[3, 1] - 5.0
        p = 0.6 - 0.1 * k * k
        e = count + 2
        lefts[e + 1 + k, 0], lefts[e + 1 + k, 1] = lefts[e, 0] * p, lefts[e, 1] + 1.0 + k
        rights[e + 1 + k, 0], rights[e + 1 + k, 1] = rights[e, 0] * p, rights[e, 1] + 1.0 + k
    total = count + 6
    k = 0
    for s in range(2):
        for a in range(total - 1):
            i = total - 1 - a if s == 0 else a
            j = i - 1 if s == 0 else i + 1
            edge = lefts if s == 0 else rights
            for q in range(5):
                p = 0.2 * q
                v = (1.0 - abs(q - 2.5) / 2.5) * 0.12
                x, z = edge[i, 0] + p * (edge[j, 0] - edge[i, 0]), edge[i, 1] + p * (edge[j, 1] - edge[i, 1])
                top[k, 0] = x * (1.0 - v + v * value(table, 0.5 * z, seed + s, 0.0))
                top[k, 1] = z
                k += 1
    top[k] = top[0]
    return k + 1


def bank(
    brush: Brush,
    x: float,
    y: float,
    height: float,
    width: float,
    cut: float,
    planted: float,
    bloom: float,
    hutted: float,
    people: float,
    forms: Array,
    loops: Array,
) -> None:
    """A bank with its foot at (x, y), flat at 100 ``cut`` above it, and what grows on it.

    planted, bloom, people : 0…1, how much of the groups, blossoms and figures is there ; hutted : above 0 for a hut

    Two kernels one after the other: one that held both would be compiled, with all trees in it, twice.
    """
    before, flat = brush.n[OPEN], np.zeros(4)
    ground(brush, x, y, height, width, cut, flat)
    left, high, wide, deep = flat.tolist()
    if wide > 0.0:
        group(brush, left, high, wide, deep, planted, bloom, hutted, people, forms, loops)
    brush.n[OPEN] = before


@kernel
def ground(brush: Brush, x: float, y: float, height: float, width: float, cut: float, flat: F8x1) -> None:
    """Open a bank and draw its ground; ``flat`` (4,) becomes left, top, width and depth of its flat, 0 where it has none."""
    part(brush, BANK, x, y)
    own = lattice(brush.rng)
    grid, top = np.empty((LAYERS, COLUMNS, 2)), np.empty((10 * (LAYERS + 6), 2))
    edge = terrace(own, brush.rng, grid, top, 0.0, y, height, width, cut)
    slope(brush, grid, x, y, 20.0)
    wrinkles(brush, own, grid, x, y, 80, 2.0, 0.2, SHOULDERS, 100.0, 0.3, 0.0, 30.0)
    if edge > 0:
        for i in range(edge):
            at(brush, top[i, 0] + x, top[i, 1] + y)
        body(brush)
        for i in range(edge):
            at(brush, top[i, 0] + x, top[i, 1] + y)
        stroke(brush, 100.0, 0.2, 1.4, 0.7, SINE, 1.0)
        left, high, right, low = 1e9, 1e9, -1e9, -1e9
        for i in range(edge):
            left, right = min(left, top[i, 0]), max(right, top[i, 0])
            high, low = min(high, top[i, 1]), max(low, top[i, 1])
        flat[0], flat[1], flat[2], flat[3] = x + left, y + high, right - left, low - high


@kernel
def along(rng: Array, low: float, size: float) -> float:
    """A place between ``low`` and ``low + size``, rather in the middle."""
    return low + size * (0.5 + 0.5 * bell(rng))


@kernel
def group(
    brush: Brush,
    left: float,
    high: float,
    width: float,
    depth: float,
    planted: float,
    bloom: float,
    hutted: float,
    people: float,
    forms: F8x3,
    loops: F8x2,
) -> None:
    """What stands on a flat top that spans (left, high) and ``width`` × ``depth``: dossier 1.8, flatDec."""
    middle = high + 0.5 * depth
    kind = pick(brush.rng, 6)
    kind = STONES if kind == BUSHES and hutted > 0.0 else kind
    if rnd(brush.rng) >= planted:
        kind = NOTHING
    for _ in range(pick(brush.rng, 6)):
        a, b = along(brush.rng, left, width), middle + 10.0 * bell(brush.rng) + 10.0
        rock(brush, a, b, between(brush.rng, 10.0, 30.0), between(brush.rng, 10.0, 30.0), 40, 2.0)
    for _ in range(max(0, pick(brush.rng, 4) - 1) if planted > 0.0 else 0):
        a, b = along(brush.rng, left, width), middle + 5.0 * bell(brush.rng) + 20.0
        for _ in range(2 + pick(brush.rng, 4)):
            c = min(max(a + 30.0 * bell(brush.rng), left), left + width)
            reed(brush, c, b, between(brush.rng, 60.0, 100.0), 1.0)
    if kind == STONES:
        for _ in range(pick(brush.rng, 4)):
            a, b = along(brush.rng, left, width), middle + 5.0 * bell(brush.rng) + 20.0
            rock(brush, a, b, between(brush.rng, 40.0, 60.0), between(brush.rng, 50.0, 70.0), 40, 5.0)
    elif kind == CEDARS:
        first, last = 0.5 * rnd(brush.rng), between(brush.rng, 0.5, 1.0)
        a = left + width * first
        while a < left + width * last:
            tx, ty = a + 20.0 * bell(brush.rng), middle + 10.0 * bell(brush.rng) + 10.0
            cedar(brush, tx, ty, between(brush.rng, 100.0, 300.0), 5.0)
            a += 30.0
        for _ in range(pick(brush.rng, 5)):
            a, b = along(brush.rng, left, width), middle + 5.0 * bell(brush.rng) + 20.0
            rock(brush, a, b, between(brush.rng, 40.0, 60.0), between(brush.rng, 50.0, 70.0), 40, 5.0)
    elif kind == PINES:
        for _ in range(max(1, pick(brush.rng, 7) - 3)):
            a, b = along(brush.rng, left, width), middle + 5.0 * bell(brush.rng) + 20.0
            pine(brush, a, b, 300.0, 6.0)
            for _ in range(pick(brush.rng, 3)):
                c = max(left, min(left + width, a + 50.0 * bell(brush.rng)))
                rock(
                    brush,
                    c,
                    b + 10.0 + 5.0 * bell(brush.rng),
                    between(brush.rng, 40.0, 60.0),
                    between(brush.rng, 50.0, 70.0),
                    40,
                    5.0,
                )
    elif kind == PLUMS:
        for _ in range(max(1, pick(brush.rng, 7) - 3)):
            a, b = along(brush.rng, left, width), middle + 5.0 * bell(brush.rng) + 20.0
            plum(brush, a, b, between(brush.rng, 60.0, 120.0), 6.0, bloom)
    elif kind == WILLOWS:
        for _ in range(1 + pick(brush.rng, 3)):
            a, b = along(brush.rng, left, width), middle + 5.0 * bell(brush.rng) + 20.0
            willow(brush, a, b, between(brush.rng, 120.0, 190.0), 3.0)
            for _ in range(pick(brush.rng, 3)):
                c = max(left, min(left + width, a + 40.0 * bell(brush.rng)))
                rock(brush, c, b + 12.0, between(brush.rng, 20.0, 40.0), between(brush.rng, 25.0, 50.0), 40, 5.0)
    elif kind == BUSHES:
        first, last = 0.5 * rnd(brush.rng), between(brush.rng, 0.5, 1.0)
        a, tone = left + width * first, math.floor(4096.0 * rnd(brush.rng)) + 0.5
        while a < left + width * last:
            tx, ty = a + 20.0 * bell(brush.rng), middle + 5.0 * bell(brush.rng) + 23.0
            bush(brush, tx, ty, 60.0, 4.0, tone, forms, loops)
            a += 20.0
    for _ in range(int(9.0 * rnd(brush.rng) * planted)):
        # Grass stands in clumps on the edge of the flat.
        a, b = along(brush.rng, left, width), middle + 16.0 * bell(brush.rng) + 12.0
        for _ in range(1 + pick(brush.rng, 5)):
            grass(brush, a + 16.0 * bell(brush.rng), b + 4.0 * bell(brush.rng), between(brush.rng, 5.0, 12.0))
    if hutted > 0.0:
        count = pick(brush.rng, 3) if rnd(brush.rng) < people else 0
        # To one side of the flat: what grows on it stands beside the hut, not on its roof.
        a, b = left + width * (0.14 if rnd(brush.rng) < 0.5 else 0.86), middle + 15.0
        hut(brush, a, b, between(brush.rng, 70.0, 80.0), between(brush.rng, 160.0, 200.0), rnd(brush.rng), 4.0, count)

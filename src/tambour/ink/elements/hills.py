"""Hills: a cone of contours, wrinkled, with trees on its ridge and flanks and houses at its foot."""

from __future__ import annotations

import math

import numpy as np

from tambour.core.arrays import F8x1, F8x2, I8x1, U8x1
from tambour.core.check import Array
from tambour.core.kernels import kernel
from tambour.ink.brush.stroke import OPEN, PI, SINE, at, between, part, pick, rnd, stroke
from tambour.ink.elements.cun import FLANKS, foot, slope, wrinkles
from tambour.ink.elements.houses import house, pagoda, pavilion, pylon
from tambour.ink.elements.rocks import rock
from tambour.ink.elements.sky import waterfall
from tambour.ink.elements.trees import fir, juniper, sapling
from tambour.ink.ground.codes import HILL
from tambour.noise import value

LAYERS, COLUMNS = 10, 50


@kernel
def ridge(table: Array, rng: Array, grid: Array, seed: float, y: float, height: float, width: float) -> None:
    """Fill ``grid`` (LAYERS, COLUMNS, 2): contour 0 is the skyline, each next one smaller and lower (dossier 1.8).

    A contour that would rise above the one before it is held under it: no line of the slope shows above its skyline.
    """
    drop = 0.0
    layers, columns = grid.shape[0], grid.shape[1]
    for j in range(layers):
        drop += rnd(rng) * y / 100.0
        p = 1.0 - j / layers
        for i in range(columns):
            t = (i / columns - 0.5) * PI
            h = math.cos(t) * value(table, t + 10.0, 0.15 * j, seed)
            grid[j, i, 0] = t / PI * width * p
            grid[j, i, 1] = drop - h * height * p
            if j > 0:
                above = skyline(grid[j - 1], grid[j, i, 0])
                grid[j, i, 1] = max(grid[j, i, 1], above + 0.012 * height)


@kernel
def skyline(contour: Array, x: float) -> float:
    """The height (y) of a contour (M, 2), evenly spaced along x, at x."""
    last = len(contour) - 1
    place = (x - contour[0, 0]) / (contour[last, 0] - contour[0, 0]) * last
    i = min(max(int(place), 0), last - 1)
    return contour[i, 1] + (place - i) * (contour[i + 1, 1] - contour[i, 1])


@kernel
def hill(
    table: F8x1,
    rng: U8x1,
    pts: F8x2,
    marks: F8x2,
    elems: F8x2,
    n: I8x1,
    x: float,
    y: float,
    height: float,
    width: float,
    wrinkled: int,
    planted: float,
    housed: float,
    falls: float,
) -> None:
    """A hill with its foot at (x, y).

    height, width : units (its crest stands at about half of ``height``); wrinkled : strokes on its flanks
    planted, housed : 0…1, how much of its trees and of its buildings is there (1: as in the original)
    falls : 0…1, the chance of a waterfall on a high hill
    Dossier 1.8, in its order: saplings behind the crest, body, outline, foot, wrinkles, saplings on the crest, groves of
    juniper, firs at the foot, buildings, rocks.
    """
    before = part(elems, n, HILL, x, y)
    seed = math.floor(4096.0 * rnd(rng))
    grid = np.empty((LAYERS, COLUMNS, 2))
    ridge(table, rng, grid, seed, y, height, width)
    crowd = max(0.0, between(rng, -1.0, 1.0))
    fringe(table, rng, pts, marks, elems, n, grid, x, y, height, seed, planted, crowd)
    slope(rng, pts, marks, n, grid, x, y, 40.0)
    for j in range(COLUMNS):
        at(pts, n, grid[0, j, 0] + x, grid[0, j, 1] + y)
    stroke(rng, marks, n, 100.0, 0.35, 0.9, 0.8, SINE, 0.8)  # a firm line in the trembling one
    foot(table, rng, pts, marks, n, grid, x, y)
    shade = 5.0 if pick(rng, 5) == 0 else 0.0
    wrinkles(table, rng, pts, marks, n, grid, x, y, wrinkled, 1.5, 0.2, FLANKS, 100.0, 0.34, shade, 40.0)
    chance, across, down = rnd(rng), between(rng, 0.36, 0.64), between(rng, 0.3, 0.55)
    if chance < falls and height > 300.0:
        i, j = int(down * LAYERS), int(across * COLUMNS)
        a, b = grid[i, j, 0], grid[i, j, 1]
        waterfall(table, rng, pts, marks, elems, n, x + a, y - 4.0, max(60.0, -b - 4.0), between(rng, 7.0, 13.0))
    crown(table, rng, pts, marks, elems, n, grid, x, y, height, seed, planted, crowd)
    grove(table, rng, pts, marks, elems, n, grid, x, y, height, seed, planted)
    for i in range(LAYERS):
        for s in range(2):
            j = s * (COLUMNS - 1)
            if value(table, 0.2 * i, 0.05 * j, seed) ** 4 < 0.012 * planted:
                tall = (height + grid[i, j, 1]) / height * 120.0 * between(rng, 0.5, 1.0)
                bend = 0.1 * rnd(rng)
                a, b = grid[i, j, 0] + x, grid[i, j, 1] + y
                fir(table, rng, pts, marks, elems, n, a, b, tall, 5.0, bend, leaf(table, a, b))
    settle(table, rng, pts, marks, elems, n, grid, x, y, seed, housed)
    for i in range(LAYERS):
        for s in range(2):
            if rnd(rng) < 0.1:
                j = s * (COLUMNS - 1)
                a, b = grid[i, j, 0] + x, grid[i, j, 1] + y
                rock(
                    table, rng, pts, marks, elems, n, a, b, between(rng, 20.0, 40.0), between(rng, 20.0, 40.0), 40, 2.0
                )
    n[OPEN] = before


@kernel
def leaf(table: Array, x: float, y: float) -> float:
    """How dark the trees about (x, y) are: neighbours agree."""
    return 0.5 + 0.3 * value(table, 0.02 * x, 0.02 * y, 0.0)


@kernel
def fringe(
    table: Array,
    rng: Array,
    pts: Array,
    marks: Array,
    elems: Array,
    n: Array,
    grid: Array,
    x: float,
    y: float,
    height: float,
    seed: float,
    planted: float,
    crowd: float,
) -> None:
    """Saplings that look over the skyline from behind: in stretches, bare between them, and crowded on some summits."""
    top = -grid[0, :, 1].min()
    for j in range(COLUMNS - 1):
        summit = crowd * max(0.0, (-grid[0, j, 1] / top - 0.8) / 0.2)
        bare = value(table, 0.1 * j, seed + 5.0, 0.0) ** 3 / 0.1
        if bare < (0.9 + summit) * planted and -grid[0, j, 1] > 0.2 * height:
            cluster = int(max(0.0, 2.4 * (1.0 - bare)) + 3.0 * summit + 0.3 + rnd(rng))
            if cluster > 0:
                p = rnd(rng)
                a = grid[0, j, 0] + p * (grid[0, j + 1, 0] - grid[0, j, 0]) + x
                b = grid[0, j, 1] + p * (grid[0, j + 1, 1] - grid[0, j, 1]) + y - 5.0
                sapling(table, rng, pts, marks, elems, n, a, b, 16.0, 8.0, cluster, leaf(table, a, b))


@kernel
def crown(
    table: Array,
    rng: Array,
    pts: Array,
    marks: Array,
    elems: Array,
    n: Array,
    grid: Array,
    x: float,
    y: float,
    height: float,
    seed: float,
    planted: float,
    crowd: float,
) -> None:
    """Saplings that crowd on the summits and thin out below them; none stand alone on the face."""
    top = -grid[0, :, 1].min()
    for i in range(LAYERS - 1):
        for j in range(COLUMNS):
            summit = max(0.0, (-grid[0, j, 1] / top - 0.75) / 0.25)
            often = (0.07 + 0.15 * crowd * summit) * planted
            if -grid[i, j, 1] > 0.45 * height and value(table, 0.1 * i, 0.1 * j, seed + 2.0) ** 3 < often:
                p = rnd(rng)
                a = grid[i, j, 0] + p * (grid[i + 1, j, 0] - grid[i, j, 0])
                b = grid[i, j, 1] + p * (grid[i + 1, j, 1] - grid[i, j, 1])
                below = b - skyline(grid[0], a)
                if rnd(rng) < 1.15 - below / 35.0:
                    a, b = a + x, b + y
                    sapling(table, rng, pts, marks, elems, n, a, b, 16.0, 8.0, 5, leaf(table, a, b))


@kernel
def grove(
    table: Array,
    rng: Array,
    pts: Array,
    marks: Array,
    elems: Array,
    n: Array,
    grid: Array,
    x: float,
    y: float,
    height: float,
    seed: float,
    planted: float,
) -> None:
    """Junipers low on the flanks where the noise is low, but none that would stand alone."""
    spots = np.empty((LAYERS * COLUMNS, 2))
    k = 0
    for i in range(LAYERS):
        for j in range(1, COLUMNS, 2):
            if -grid[i, j, 1] < 0.3 * height and value(table, 0.2 * i, 0.05 * j, seed) ** 4 < 0.012 * planted:
                spots[k, 0], spots[k, 1] = grid[i, j, 0], grid[i, j, 1]
                k += 1
    for a in range(k):
        near = 0
        for b in range(k):
            dx, dy = spots[a, 0] - spots[b, 0], spots[a, 1] - spots[b, 1]
            if b != a and dx * dx + dy * dy < 900.0:
                near += 1
        if near > 2:
            tall = (height + spots[a, 1]) / height * 70.0 * between(rng, 0.3, 1.0)
            tx, ty = spots[a, 0] + x, spots[a, 1] + y
            juniper(table, rng, pts, marks, elems, n, tx, ty, tall, between(rng, 1.0, 4.0), leaf(table, tx, ty))


@kernel
def settle(
    table: Array,
    rng: Array,
    pts: Array,
    marks: Array,
    elems: Array,
    n: Array,
    grid: Array,
    x: float,
    y: float,
    seed: float,
    housed: float,
) -> None:
    """Houses and pavilions at the feet of a hill, a pagoda on its crest, a pylon, where their noises are low (1.8)."""
    for i in range(1, LAYERS):
        for s in range(2):
            j = 1 + s * (COLUMNS - 3)
            a, b = grid[i, j, 0] + x, grid[i, j, 1] + y
            if value(table, 0.2 * i, 0.05 * j, seed + 10.0) ** 4 < 0.005 * housed:
                choice, storeys, style = pick(rng, 6), 1 + pick(rng, 3), 1 + pick(rng, 3)
                wide, turn = between(rng, 40.0, 70.0), rnd(rng)
                if 2 <= choice <= 4:
                    railed = rnd(rng) < 0.5
                    house(table, rng, pts, marks, elems, n, a, b, 10.0, wide, turn, 3.0, storeys, style, railed)
                elif choice == 5:
                    pavilion(table, rng, pts, marks, elems, n, a, b, 15.0, 0.8 * wide, 1 + pick(rng, 2))
    if rnd(rng) < 0.02 * housed:
        a, b = grid[1, COLUMNS // 2, 0] + x, grid[1, COLUMNS // 2, 1] + y
        pagoda(table, rng, pts, marks, elems, n, a, b, 10.0, between(rng, 40.0, 60.0), 5 + 2 * pick(rng, 2))
    for i in range(0, LAYERS, 2):
        for s in range(2):
            j = 1 + s * (COLUMNS - 3)
            if value(table, 0.2 * i, 0.05 * j, seed + 62.0) ** 4 < 0.0006 * housed:
                a, b = grid[i, j, 0] + x, grid[i, j, 1] + y
                pylon(table, rng, pts, marks, elems, n, a, b, 100.0, 20.0)

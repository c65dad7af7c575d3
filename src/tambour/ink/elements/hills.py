"""Hills: contours under a skyline of one of seven forms, modelled in one family of wrinkles, planted and housed."""

from __future__ import annotations

import math

import numpy as np

from tambour.core.arrays import F8x1, F8x3, U8x1
from tambour.core.check import Array
from tambour.core.kernels import inner, kernel
from tambour.ink.brush.stroke import EVEN, OPEN, PI, Brush, at, between, body, lattice, part, pick, rnd, stroke
from tambour.ink.elements.cun import HEMP, crest, foot, model, moss, slope, wash_flank
from tambour.ink.elements.houses import house, pagoda, pavilion, pylon
from tambour.ink.elements.rocks import rock
from tambour.ink.elements.sky import waterfall
from tambour.ink.elements.trees import fir, juniper, sapling
from tambour.ink.ground.codes import HILL, numbers
from tambour.noise import value

LAYERS, COLUMNS = 10, 64
CLIMBED, TREADS = 0.3, 160
"""How many of the high hills have stairs; places along them."""

CONE, DOME, SPIRE, CLIFF, LEANING, TWIN, RIDGE = numbers(7)
"""Forms of a skyline: the seed's cone; a round dome; a steep spire; a plateau between cliffs; a peak that leans; two
peaks with a saddle; a long broken ridge."""
FORMS = 7


@kernel
def profile(t: float, form: int, lean: float) -> float:
    """How high the skyline of a form stands at t in -π/2 … π/2, 0 … 1, before its noise; ``lean`` (-1 … 1) carries its peak
    to the side."""
    s = t - 0.55 * lean * math.cos(t)
    c = max(0.0, math.cos(s))
    if form == DOME:
        return c**0.6
    if form == SPIRE:
        return 0.25 * c + 0.75 * c**5.0
    if form == CLIFF:
        steep = min(1.0, 1.7 * c**1.2)
        return steep - 0.12 * (1.0 - c)
    if form == LEANING:
        return 0.55 * c + 0.45 * max(0.0, math.cos(s - 0.5 * (1.0 if lean > 0.0 else -1.0))) ** 3.0
    if form == TWIN:
        return c * (0.62 + 0.38 * math.cos(4.0 * s + 2.4 * lean + PI))
    if form == RIDGE:
        return c**0.45 * (0.8 + 0.2 * math.cos(5.0 * s + 3.0 * lean))
    return c


@kernel
def ridge(own: F8x1, rng: U8x1, grid: F8x3, height: float, width: float, form: int, lean: float) -> None:
    """Fill ``grid`` (LAYERS, COLUMNS, 2): contour 0 is the skyline, each next one smaller and lower (dossier 1.8).

    The crest stands ``height`` above the foot. A contour that would rise above the one before it is held under it: no
    line of the slope shows above its skyline.
    """
    drop = 0.0
    layers, columns = grid.shape[0], grid.shape[1]
    rough = 1.5 if form == RIDGE else 1.0
    top = 1e-9
    for j in range(layers):
        drop += 5.0 * rnd(rng)
        p = 1.0 - j / layers
        for i in range(columns):
            t = (i / (columns - 1.0) - 0.5) * PI
            h = profile(t, form, lean) * (0.2 + value(own, rough * (t + 10.0), 0.15 * j, 0.0))
            if j == 0:
                top = max(top, h)
            grid[j, i, 0] = t / PI * width * p
            grid[j, i, 1] = -h
    for j in range(layers):
        p = 1.0 - j / layers
        for i in range(columns):
            grid[j, i, 1] = drop * j / layers + grid[j, i, 1] / top * height * p
            if j > 0:
                above = skyline(grid[j - 1], grid[j, i, 0])
                grid[j, i, 1] = max(grid[j, i, 1], above + 0.02 * height)


@kernel
def skyline(contour: Array, x: float) -> float:
    """The height (y) of a contour (M, 2), evenly spaced along x, at x."""
    last = len(contour) - 1
    place = (x - contour[0, 0]) / (contour[last, 0] - contour[0, 0]) * last
    i = min(max(int(place), 0), last - 1)
    return contour[i, 1] + (place - i) * (contour[i + 1, 1] - contour[i, 1])


@kernel
def hill(
    brush: Brush,
    x: float,
    y: float,
    height: float,
    width: float,
    form: int,
    lean: float,
    family: int,
    wrinkled: int,
    scale: float,
    planted: float,
    housed: float,
    falls: float,
) -> None:
    """A hill with its foot at (x, y) and its crest ``height`` above it.

    width : units ; form, lean : of its skyline ; family : of its wrinkles (see :mod:`tambour.ink.elements.cun`)
    wrinkled : strokes on its flanks ; scale : of trees, buildings and rocks (the farther the smaller)
    planted, housed : 0…1, how much of its trees and of its buildings is there
    falls : 0…1, the chance of a waterfall on a high hill
    Dossier 1.8, in its order: saplings behind the crest, body, outline, foot, wrinkles, saplings on the crest, groves of
    juniper, firs at the foot, buildings, rocks.
    """
    before = part(brush, HILL, x, y)
    own = lattice(brush.rng)
    grid = np.empty((LAYERS, COLUMNS, 2))
    ridge(own, brush.rng, grid, height, width, form, lean)
    crowd = max(0.0, between(brush.rng, -1.0, 1.0))
    fringe(brush, own, grid, x, y, height, scale, planted, crowd)
    slope(brush, grid, x, y, 40.0)
    wash_flank(brush, own, grid, x, y, height)
    crest(brush, own, grid, x, y, height)
    foot(brush, own, grid, x, y)
    model(brush, own, grid, x, y, wrinkled, family)
    if height > 120.0:
        moss(brush, own, grid, x, y, height, planted)
    chance, across, down = rnd(brush.rng), between(brush.rng, 0.36, 0.64), between(brush.rng, 0.3, 0.55)
    if chance < falls and height > 165.0 and family == HEMP:
        i, j = int(down * LAYERS), int(across * COLUMNS)
        a, b = grid[i, j, 0], grid[i, j, 1]
        waterfall(brush, x + a, y - 4.0, max(60.0, -b - 4.0), between(brush.rng, 7.0, 13.0))
    elif height > 150.0 and own[77] < CLIMBED * housed:
        stairs(brush, own, grid, x, y, scale)
    crown(brush, own, grid, x, y, height, scale, planted, crowd)
    grove(brush, own, grid, x, y, height, scale, planted)
    for i in range(LAYERS):
        for s in range(2):
            j = s * (COLUMNS - 1)
            if value(own, 0.2 * i, 0.05 * j + 31.0, 0.0) ** 4 < 0.008 * planted:
                tall = (1.0 + 0.55 * grid[i, j, 1] / height) * 120.0 * scale * between(brush.rng, 0.5, 1.0)
                bend = 0.1 * rnd(brush.rng)
                a, b = grid[i, j, 0] + x, grid[i, j, 1] + y
                fir(brush, a, b, tall, 5.0 * scale, bend, leaf(brush.table, a, b))
    settle(brush, own, grid, x, y, height, scale, housed)
    for i in range(LAYERS):
        for s in range(2):
            if rnd(brush.rng) < 0.1:
                j = s * (COLUMNS - 1)
                a, b = grid[i, j, 0] + x, grid[i, j, 1] + y
                rock(
                    brush, a, b, scale * between(brush.rng, 18.0, 38.0), scale * between(brush.rng, 20.0, 42.0), 40, 2.0
                )
    brush.n[OPEN] = before


@inner
def stairs(brush: Brush, own: Array, grid: Array, x: float, y: float, scale: float) -> None:
    """Steps from the foot of a hill up its slope in bends, ever narrower, and the pavilion where they end."""
    layers, columns = grid.shape[0], grid.shape[1]
    begin, sway = 0.5 + 0.2 * (own[78] - 0.5), 0.05 + 0.05 * own[79]
    way = np.empty((TREADS, 3))
    for k in range(TREADS):
        p = k / (TREADS - 1.0)
        v = (layers - 1.0) * (1.0 - 0.62 * p)
        i, j = min(int(v), layers - 2), int((begin + sway * math.sin(7.0 * p + 6.0 * own[80])) * columns)
        q, f = v - i, (begin + sway * math.sin(7.0 * p + 6.0 * own[80])) * columns - j
        for d in range(2):
            upper = grid[i, j, d] + f * (grid[i, j + 1, d] - grid[i, j, d])
            lower = grid[i + 1, j, d] + f * (grid[i + 1, j + 1, d] - grid[i + 1, j, d])
            way[k, d] = (1.0 - q) * upper + q * lower + (x if d == 0 else y)
        way[k, 2] = scale * (8.0 - 4.4 * p)
    for s in range(2):
        for k in range(TREADS):
            t = way[k if s == 0 else TREADS - 1 - k]
            at(brush, t[0] + (t[2] if s else -t[2]), t[1])
    body(brush)
    last = 1e9
    for k in range(TREADS):
        a, b, half = way[k, 0], way[k, 1], way[k, 2]
        if b < last - 0.55 * half:
            last = b
            at(brush, a - half, b)
            at(brush, a, b - 0.2)
            at(brush, a + half, b)
            stroke(brush, 90.0, 0.9, 0.16 * half + 0.25, 0.5, EVEN, 0.0)
    pavilion(brush, way[TREADS - 1, 0], last, 10.0 * scale, 26.0 * scale, 1)


@kernel
def leaf(table: Array, x: float, y: float) -> float:
    """How dark the trees about (x, y) are: neighbours agree. The mean is the original's .37 (its calls, not its defaults)."""
    return 0.3 + 0.15 * value(table, 0.02 * x, 0.02 * y, 0.0)


@inner
def fringe(
    brush: Brush, own: Array, grid: Array, x: float, y: float, height: float, scale: float, planted: float, crowd: float
) -> None:
    """Saplings that look over the skyline from behind: in stretches, bare between them, and crowded on some summits."""
    for j in range(COLUMNS - 1):
        up = -grid[0, j, 1] / height
        summit = crowd * max(0.0, (up - 0.8) / 0.2)
        bare = value(own, 0.08 * j, 905.0, 0.0) ** 3 / 0.1
        if bare < (0.7 + summit) * planted and up > 0.36:
            cluster = int(max(0.0, 2.2 * (1.0 - bare)) + 3.0 * summit + 0.1 + rnd(brush.rng))
            if cluster > 0:
                p = rnd(brush.rng)
                a = grid[0, j, 0] + p * (grid[0, j + 1, 0] - grid[0, j, 0]) + x
                b = grid[0, j, 1] + p * (grid[0, j + 1, 1] - grid[0, j, 1]) + y - 5.0
                sapling(brush, a, b, 16.0 * scale, 8.0 * scale, cluster, 0.2 + leaf(brush.table, a, b))


@inner
def crown(
    brush: Brush, own: Array, grid: Array, x: float, y: float, height: float, scale: float, planted: float, crowd: float
) -> None:
    """Saplings that crowd on the summits and thin out below them; none stand alone on the face."""
    for i in range(LAYERS - 1):
        for j in range(COLUMNS):
            summit = max(0.0, (-grid[0, j, 1] / height - 0.75) / 0.25)
            often = (0.03 + 0.12 * crowd * summit) * planted
            if -grid[i, j, 1] > 0.8 * height and value(own, 0.1 * i, 0.08 * j, 702.0) ** 3 < often:
                p = rnd(brush.rng)
                a = grid[i, j, 0] + p * (grid[i + 1, j, 0] - grid[i, j, 0])
                b = grid[i, j, 1] + p * (grid[i + 1, j, 1] - grid[i, j, 1])
                below = b - skyline(grid[0], a)
                if rnd(brush.rng) < 1.15 - below / 35.0:
                    a, b = a + x, b + y
                    sapling(brush, a, b, 16.0 * scale, 8.0 * scale, 5, 0.2 + leaf(brush.table, a, b))


@inner
def grove(
    brush: Brush, own: Array, grid: Array, x: float, y: float, height: float, scale: float, planted: float
) -> None:
    """Junipers low on the flanks where the noise is low, but none that would stand alone, and no more than the eye can part."""
    spots = np.empty((LAYERS * COLUMNS, 2))
    k = 0
    for i in range(LAYERS):
        for j in range(1, COLUMNS, 2):
            if -grid[i, j, 1] < 0.55 * height and value(own, 0.2 * i, 0.04 * j + 77.0, 0.0) ** 4 < 0.010 * planted:
                spots[k, 0], spots[k, 1] = grid[i, j, 0], grid[i, j, 1]
                k += 1
    for a in range(k):
        near, taken = 0, False
        for b in range(k):
            dx, dy = spots[a, 0] - spots[b, 0], spots[a, 1] - spots[b, 1]
            if b != a and dx * dx + dy * dy < 900.0:
                near += 1
                taken = taken or (b < a and dx * dx + 4.0 * dy * dy < 90.0)
        if near > 2 and not taken:
            tall = (1.0 + 0.55 * spots[a, 1] / height) * 70.0 * scale * between(brush.rng, 0.3, 1.0)
            tx, ty = spots[a, 0] + x, spots[a, 1] + y
            juniper(brush, tx, ty, tall, between(brush.rng, 1.0, 4.0), leaf(brush.table, tx, ty))


@inner
def settle(
    brush: Brush, own: Array, grid: Array, x: float, y: float, height: float, scale: float, housed: float
) -> None:
    """Houses and pavilions at the feet of a hill, a pagoda on its crest, a pylon, where their noises are low (1.8)."""
    for i in range(1, LAYERS):
        for s in range(2):
            j = 1 + s * (COLUMNS - 3)
            a, b = grid[i, j, 0] + x, grid[i, j, 1] + y
            if value(own, 0.2 * i, 0.05 * j, 210.0) ** 4 < 0.005 * housed:
                choice, storeys, style = pick(brush.rng, 6), 1 + pick(brush.rng, 3), 1 + pick(brush.rng, 3)
                wide, turn = scale * between(brush.rng, 40.0, 70.0), rnd(brush.rng)
                if 2 <= choice <= 4:
                    railed = rnd(brush.rng) < 0.5
                    house(brush, a, b, 10.0 * scale, wide, turn, 3.0, storeys, style, railed)
                elif choice == 5:
                    pavilion(brush, a, b, 15.0 * scale, 0.8 * wide, 1 + pick(brush.rng, 2))
    if rnd(brush.rng) < 0.03 * housed and height > 90.0:
        top = 0
        for j in range(COLUMNS):
            top = j if grid[1, j, 1] < grid[1, top, 1] else top
        a, b = grid[1, top, 0] + x, grid[1, top, 1] + y
        pagoda(brush, a, b, 10.0 * scale, scale * between(brush.rng, 40.0, 60.0), 5 + 2 * pick(brush.rng, 2))
    if rnd(brush.rng) < 0.005 * housed:
        i, s = 2 * pick(brush.rng, LAYERS // 2), pick(brush.rng, 2)
        j = 1 + s * (COLUMNS - 3)
        a, b = grid[i, j, 0] + x, grid[i, j, 1] + y
        pylon(brush, a, b, 100.0 * scale, 20.0 * scale)

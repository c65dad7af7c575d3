"""Cun: the wrinkle strokes that model a slope, and the outline, body and foot that slopes share."""

from __future__ import annotations

import math

import numpy as np

from tambour.core.check import Array
from tambour.core.kernels import inner, kernel
from tambour.ink.brush.stroke import LENS, SINE, WEDGE, Brush, at, bell, between, blob, body, drying, rnd, stroke
from tambour.ink.ground.codes import numbers
from tambour.noise import ease, value

FLANKS, SHOULDERS, SIDES, SPREAD = numbers(4)
"""Where wrinkles gather along a ridge: the outer thirds; broadly beside the middle; narrowly at the sides; more and
more towards one end."""
HEMP, AXE, RAIN = numbers(3)
"""Families of wrinkles: long lines as of parted hemp; short broad cuts as of a small axe; dabs as of rain on a wall."""
OWN = 0.5
"""How much a stroke trembles by itself, as a part of the slope's relief: lines of a bundle touch and part again."""
DRY = 0.22
"""How many of the long wrinkles are drawn with a brush that runs dry."""


@kernel
def place(rng: Array, where: int) -> float:
    """A place in 0…1 along the ridge (dossier 1.6, 1.8)."""
    u, right = rnd(rng), rnd(rng) < 0.5
    if where == FLANKS:
        return (2.0 + u) / 3.0 if right else u / 3.0
    if where == SHOULDERS:
        return 0.9 - 0.4 * u if right else 0.1 + 0.4 * u
    if where == SIDES:
        return 0.85 - 0.15 * u if right else 0.15 + 0.15 * u
    return u ** (1.0 / 3.0)


@kernel
def grit(table: Array, place: int) -> float:
    """A number spread as the value noise is, but without its smoothness: the lattice itself, four octaves of it."""
    return (
        0.5 * table[place & 4095]
        + 0.25 * table[(place + 1619) & 4095]
        + 0.125 * table[(place + 2971) & 4095]
        + 0.0625 * table[(place + 811) & 4095]
    )


@kernel
def relief(table: Array, phase: int, layers: int, columns: int) -> Array:
    """The roughness of a slope: (layers, columns, 2) in about -1/2 … 1/2, smoothed along the contours.

    It belongs to the slope, not to the stroke: strokes that run side by side are pushed the same way, and stay parallel.
    """
    rough = np.empty((layers, columns, 2))
    for i in range(layers):
        for c in range(2):
            row = phase + 977 * i + 2048 * c
            before, here = grit(table, row - 1), grit(table, row)
            for j in range(columns):
                after = grit(table, row + j + 1)
                rough[i, j, c] = 0.2 * before + 0.6 * here + 0.2 * after - 0.47
                before, here = here, after
    return rough


@inner
def wrinkles(
    brush: Brush,
    own: Array,
    grid: Array,
    x: float,
    y: float,
    count: int,
    breadth: float,
    reach: float,
    where: int,
    grey: float,
    alpha: float,
    shade: float,
    tremble: float,
) -> None:
    """``count`` strokes over a surface, each a run along its contours.

    grid : (L, M, 2) contours from the foot (0) inwards, about (x, y)
    reach : greatest half length of a stroke, as a part of M; where : see above; alpha : of the darkest
    shade : breadth of a first, faint pass under every second line, and lines are then thinned by it; 0 for none
    tremble : how far the slope's relief may carry the lines of the foot, falling as 1 / layer (dossier 1.6)
    Each stroke lies between two contours. The skyline itself is not carried away: lines stay on the slope.
    """
    layers, columns = grid.shape[0], grid.shape[1]
    rough = relief(own, int(4096.0 * rnd(brush.rng)), layers, columns)
    for wet in range(0 if shade > 0.0 else 1, 2):
        step = 2.0 if wet == 0 else 1.0 + shade
        for k in range(int(count / step)):
            i = shade + k * step if wet == 1 else k * step
            if i >= count:
                break
            mid = int(place(brush.rng, where) * columns)
            half = math.floor(rnd(brush.rng) * columns * reach)
            first, last = max(0, min(columns, mid - half)), max(0, min(columns, mid + half))
            layer = i / count * (layers - 1)
            low = int(layer)
            high, p = min(low + 1, layers - 1), layer - low
            drift = tremble / (layer + 1.0) * min(1.0, 0.25 + layer)
            q = ease(p)
            spot = int(4096.0 * rnd(brush.rng))
            mine = grit(own, spot + first) - 0.47
            for j in range(first, last):
                before, mine = mine, grit(own, spot + j + 1) - 0.47
                push = OWN * 0.5 * (before + mine)
                a = (1.0 - p) * grid[low, j, 0] + p * grid[high, j, 0]
                b = (1.0 - p) * grid[low, j, 1] + p * grid[high, j, 1]
                a += drift * (rough[low, j, 0] + q * (rough[high, j, 0] - rough[low, j, 0]) + push)
                b += drift * (rough[low, j, 1] + q * (rough[high, j, 1] - rough[low, j, 1]) - push)
                at(brush, a + x, b + y)
            if wet == 0:
                stroke(brush, grey, 0.1, shade, 0.5, SINE, 1.0)
            else:
                dark, broad = alpha * between(brush.rng, 0.1, 1.0), breadth * between(brush.rng, 0.7, 1.2)
                if last - first > 9 and rnd(brush.rng) < DRY:
                    drying(brush, grey, dark, 1.25 * broad, 0.5)
                else:
                    stroke(brush, grey, dark, broad, 0.5, SINE, 1.0)


@inner
def slope(brush: Brush, grid: Array, x: float, y: float, sink: float) -> None:
    """The body of a slope (its outermost contour, closed ``sink`` below its foot) and its soft trembling outline."""
    for j in range(grid.shape[1]):
        at(brush, grid[0, j, 0] + x, grid[0, j, 1] + y)
    if sink > 0.0:
        at(brush, x, y + sink)
    body(brush)
    for j in range(grid.shape[1]):
        at(brush, grid[0, j, 0] + x, grid[0, j, 1] + y)
    stroke(brush, 100.0, 0.22, 2.6, 1.0, SINE, 0.0)


@inner
def crest(brush: Brush, own: Array, grid: Array, x: float, y: float, height: float) -> None:
    """The skyline as lifted strokes: pressed in the hollows and on the shaded side, let go where light falls."""
    columns = grid.shape[1]
    first = 1 + int(3.0 * rnd(brush.rng))
    while first < columns - 4:
        last = min(columns - 1, first + 5 + int(13.0 * rnd(brush.rng)))
        hollow = 0.0
        for j in range(first + 1, last - 1):
            hollow += grid[0, j, 1] - 0.5 * (grid[0, j - 1, 1] + grid[0, j + 1, 1])
        # y is down: a hollow's middle lies above the chord of its neighbours by a negative amount here.
        press = 1.0 + min(0.8, max(-0.45, 0.12 * hollow)) + (0.25 if first + last > columns else -0.2)
        press *= 0.6 + 0.8 * value(own, 0.11 * first, 450.0, 0.0)
        for j in range(first, last + 1):
            at(brush, grid[0, j, 0] + x, grid[0, j, 1] + y - 0.6 * bell(brush.rng))
        stroke(brush, 80.0, min(0.75, 0.34 + 0.22 * press), max(0.6, 1.5 * press), 0.75, SINE, 0.0)
        # Most strokes run on from one another; some leave a breath of paper.
        first = last - 2 if rnd(brush.rng) < 0.7 else last + int(2.0 * rnd(brush.rng))


@inner
def wash_flank(brush: Brush, own: Array, grid: Array, x: float, y: float, height: float) -> None:
    """Thin broad washes on the flank away from the light and in the clefts; the crown and the foot are left as paper."""
    layers, columns = grid.shape[0], grid.shape[1]
    for _ in range(14 + int(0.11 * height)):
        low = 1 + int((layers - 3) * rnd(brush.rng))
        far = rnd(brush.rng)
        middle = 0.55 + 0.38 * far if rnd(brush.rng) < 0.78 else 0.1 + 0.35 * far
        half = 3.0 + 7.0 * rnd(brush.rng)
        first, last = int(middle * columns - half), int(middle * columns + half)
        deep = rnd(brush.rng)
        drift = 5.0 * bell(brush.rng)
        if first < 1 or last > columns - 2:
            continue
        for j in range(first, last):
            a = (1.0 - deep) * grid[low, j, 0] + deep * grid[low + 1, j, 0]
            b = (1.0 - deep) * grid[low, j, 1] + deep * grid[low + 1, j, 1]
            at(brush, a + x + drift, b + y + drift)
        stroke(brush, 110.0, between(brush.rng, 0.05, 0.13), between(brush.rng, 4.0, 11.5), 0.5, SINE, 0.0)


@inner
def model(brush: Brush, own: Array, grid: Array, x: float, y: float, count: int, family: int) -> None:
    """A slope's wrinkles in one family; ``count`` is what the seed draws of the first."""
    shade = 5.0 if rnd(brush.rng) < 0.2 else 0.0
    if family == HEMP:
        wrinkles(brush, own, grid, x, y, count, 1.5, 0.2, FLANKS, 95.0, 0.46, shade, 40.0)
        return
    wrinkles(brush, own, grid, x, y, count // 3, 1.3, 0.16, FLANKS, 95.0, 0.38, 0.0, 30.0)
    layers, columns = grid.shape[0], grid.shape[1]
    for _ in range((9 * count) // 10 if family == AXE else count):
        i = 1 + int((layers - 3) * rnd(brush.rng))
        j = 2 + int((columns - 5) * (place(brush.rng, FLANKS) if rnd(brush.rng) < 0.8 else rnd(brush.rng)))
        # Cuts and dabs stand in bunches, as rock does.
        if value(own, 0.16 * j, 0.5 * i, 300.0) > (0.52 if family == AXE else 0.6):
            continue
        down = 1.0 if j > columns // 2 else -1.0
        ax = grid[i, j, 0] + x + 4.0 * bell(brush.rng)
        ay = grid[i, j, 1] + y + 7.0 * rnd(brush.rng)
        if family == AXE:
            long = between(brush.rng, 7.0, 20.0)
            angle = math.atan2(grid[i, j + 1, 1] - grid[i, j, 1], grid[i, j + 1, 0] - grid[i, j, 0])
            turn = angle + 0.5 * math.pi - 0.55 * down + 0.2 * bell(brush.rng)
            for k4 in range(5):
                p = k4 / 4.0
                at(brush, ax + long * p * math.cos(turn) + 1.2 * down * p * p * 3.0, ay + long * p * math.sin(turn))
            stroke(brush, 90.0, between(brush.rng, 0.16, 0.5), between(brush.rng, 1.2, 3.4), 0.7, WEDGE, 0.0)
        else:
            angle = 0.5 * math.pi - 0.5 * down + 0.25 * bell(brush.rng)
            blob(
                brush,
                ax,
                ay,
                between(brush.rng, 4.0, 9.5),
                between(brush.rng, 1.4, 3.2),
                angle,
                95.0,
                between(brush.rng, 0.14, 0.5),
                0.5,
                LENS,
            )


@inner
def moss(brush: Brush, own: Array, grid: Array, x: float, y: float, height: float, planted: float) -> None:
    """Dots of moss along the skyline and down the clefts, in runs: the darkest accents of a slope."""
    columns = grid.shape[1]
    for _ in range(int((10.0 + 0.16 * height) * planted)):
        i = 0 if rnd(brush.rng) < 0.55 else 1 + int(4.0 * rnd(brush.rng))
        j = 2 + int((columns - 5) * rnd(brush.rng))
        if value(own, 0.22 * j, 0.7 * i, 600.0) > 0.42:
            continue
        for _ in range(1 + int(4.0 * rnd(brush.rng))):
            a = grid[i, j, 0] + x + 9.0 * bell(brush.rng)
            b = grid[i, j, 1] + y + 3.0 * bell(brush.rng) + 1.0
            blob(
                brush,
                a,
                b,
                between(brush.rng, 2.0, 4.5),
                between(brush.rng, 1.5, 3.2),
                0.4 * bell(brush.rng),
                70.0,
                between(brush.rng, 0.35, 0.75),
                0.5,
                LENS,
            )


@inner
def foot(brush: Brush, own: Array, grid: Array, x: float, y: float) -> None:
    """Skirts on both sides that break the contours' ends: paper first, faint strokes over it (dossier 1.8)."""
    layers, columns = grid.shape[0], grid.shape[1]
    phase = 4096.0 * rnd(brush.rng)
    mark = brush.rng[1]
    for wet in range(2):
        brush.rng[1] = mark  # both passes walk the same way
        i = 0
        while i < layers - 2:
            above = min(i + (1 if rnd(brush.rng) < 0.5 else 2), layers - 1)
            for s in range(2):
                edge, inward = (0, 1) if s == 0 else (columns - 1, -1)
                for k in range(min(columns // 8, 10), -1, -1):
                    j = edge + inward * k
                    shift = 10.0 * inward * value(own, 0.1 * k, i + phase, 0.0)
                    at(brush, grid[i, j, 0] + shift + x, grid[i, j, 1] + y)
                if wet == 1:
                    # Down to the ground and gone: the hem itself has no line.
                    tone = 0.14 + 0.14 * value(own, 7.3 * i + s + phase, 0.5, 0.0)
                    stroke(brush, 100.0, tone, 1.0, 0.5, SINE, 1.0)
                    continue
                for k in range(10):
                    p = k / 10.0
                    a = grid[i, edge, 0] * (1.0 - p) + grid[above, edge, 0] * p
                    b = grid[i, edge, 1] * (1.0 - p) + grid[above, edge, 1] * p
                    b += 8.5 * (1.0 - p) * p**0.2 + 5.0 * value(own, 0.05 * (y + b) + phase, i * 1.0, 0.0)
                    at(brush, a + x, b + y)
                body(brush)
            i = above

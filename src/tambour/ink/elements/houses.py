"""Buildings: hut, storeyed house, pagoda, pavilion, pylon."""

from __future__ import annotations

from tambour.core.kernels import kernel
from tambour.ink.brush.stroke import OPEN, Brush, between, part, pick, rnd, side
from tambour.ink.elements.frames import LATTICE, PLAIN, box, quad, rail, roof, run, sign, spire, thatch
from tambour.ink.elements.people import BUN, SITS, STANDS, figure
from tambour.ink.ground.codes import HOUSE, HUT, PAGODA, PAVILION, PYLON, numbers

WING, COURT = numbers(2)
"""Plans of a homestead."""


@kernel
def hut(brush: Brush, x: float, y: float, height: float, width: float, turn: float, depth: float, people: int) -> None:
    """A thatched shelter on four posts over a deck with its railing, and ``people`` in it (1.9 arch01)."""
    before = part(brush, HUT, x, y)
    eaves, rails = 0.52 * height, 0.15 * height
    # Its shade: no line of what stands behind shows between the posts.
    wide, top = 0.335 * width, y - eaves - 0.1 * height
    quad(brush, x - wide, top, x + wide, top, x + wide, y, x - wide, y)
    for k in range(4):
        post = x + width * (0.22 * k - 0.33 + 0.08 * (turn - 0.5) * (1 if k in (1, 2) else 0))
        run(brush, post, top, post, y, 2.0, 0.45)
    run(brush, x - 0.48 * width, y - rails - 2.0, x + 0.48 * width, y - rails - 2.0, 1.0, 0.45)
    for k in range(people):
        where = x + (k - 0.5 * (people - 1)) * 0.42 * width + between(brush.rng, -0.1, 0.1) * width
        inward = side(brush.rng) if people == 1 else 1.0 - 2.0 * k
        figure(
            brush,
            where,
            y + 0.3 * depth,
            0.36 * height / 75.0,
            inward,
            BUN,
            0.0,
            SITS if rnd(brush.rng) < 0.5 else STANDS,
        )
    rail(brush, x, y, rails, 0.97 * width, turn, depth, 6, 1.2, 0.0)
    run(brush, x - 0.48 * width, y, x + 0.48 * width, y, 0.9, 0.4)
    thatch(brush, x, y - eaves, 0.66 * height, width, 190)
    brush.n[OPEN] = before


@kernel
def house(
    brush: Brush,
    x: float,
    y: float,
    height: float,
    width: float,
    turn: float,
    depth: float,
    storeys: int,
    style: int,
    railed: bool,
) -> None:
    """A house of ``storeys`` boxes under hip roofs, each narrower than the one below (1.9 arch02).

    railed : a low fence before it ; a house of one storey has a sign over its door now and then
    """
    before = part(brush, HOUSE, x, y)
    w = width
    for i in range(storeys):
        base = y - 1.5 * height * i
        box(brush, x, base, height, w, turn, depth, 0.8, False, style)
        roof(brush, x, base - height, 0.7 * height, 0.95 * w, turn, depth, 0.8, 5.0)
        w *= 0.85
    if storeys == 1 and rnd(brush.rng) < 1.0 / 3.0:
        # On the longer of the two front faces.
        face, lean = (0.5 * turn, depth) if turn > 0.5 else (0.5 + 0.5 * turn, -depth)
        lean *= 0.3 * width / (max(turn, 1.0 - turn) * width)
        sx, sy = x + (face - 0.5) * width, y - height + 0.5 * depth
        sign(brush, sx, sy - 0.5 * height, 0.55 * height, 0.3 * width, lean)
    if railed:
        rail(brush, x, y + 2.0, 0.3 * height, 1.1 * width, turn, depth + 2.0, 5, 0.4, 0.5)
    brush.n[OPEN] = before


@kernel
def cottage(
    brush: Brush, x: float, y: float, height: float, width: float, turn: float, depth: float, style: int
) -> None:
    """A house of one room under thatch."""
    before = part(brush, HOUSE, x, y)
    box(brush, x, y, height, width, turn, depth, 0.8, False, style)
    thatch(brush, x, y - 0.9 * height, 0.95 * height, 1.3 * width, 70)
    brush.n[OPEN] = before


@kernel
def homestead(
    brush: Brush, x: float, y: float, height: float, width: float, turn: float, depth: float, style: int, plan: int
) -> None:
    """Several roofs that belong together: a hall with a wing before it, or a hall in a walled court with its gate."""
    if plan == WING:
        house(brush, x, y - 3.0, height, width, turn, depth, 1, style, False)
        right = 1.0 if turn < 0.5 else -1.0
        a, wide = x + 0.42 * right * width, 0.55 * width
        house(brush, a, y + 2.0, 0.85 * height, wide, 1.0 - turn, depth, 1, pick(brush.rng, 3) + 1, False)
        return
    house(brush, x, y - 7.0, height, 0.85 * width, turn, depth, 1, style, False)
    before = part(brush, HOUSE, x, y)
    # The wall goes round in front, under a narrow roof of tiles, and opens at the gate.
    low, wide, gate = 0.45 * height, 1.35 * width, 0.22 * width
    for s in range(2):
        f = 1.0 - 2.0 * s
        long = 0.5 * (wide - gate)
        middle = x + f * 0.5 * (gate + long)
        box(brush, middle, y, low, long, 0.5, 0.4 * depth, 0.5, False, PLAIN)
        run(brush, middle - 0.53 * long, y - low, middle + 0.53 * long, y - low, 1.3, 0.5)
    box(brush, x, y, 0.75 * height, gate, 0.5, 0.3 * depth, 0.6, False, PLAIN)
    roof(brush, x, y - 0.75 * height, 0.35 * height, gate, 0.5, 0.3 * depth, 0.6, 2.5)
    brush.n[OPEN] = before


@kernel
def pagoda(brush: Brush, x: float, y: float, height: float, width: float, storeys: int) -> None:
    """A tower of ``storeys``, each ``height`` high under its own pointed roof (1.9 arch03)."""
    before = part(brush, PAGODA, x, y)
    w = width
    for i in range(storeys):
        base = y - 1.5 * height * i
        box(brush, x, base, height, w, 0.7, 0.12 * w, 0.8, False, LATTICE if i % 2 else PLAIN)
        rail(brush, x, base, 0.45 * height, 1.1 * w, 0.7, 0.14 * w, 3, 0.4, 0.5)
        top = 1.5 * height if i == storeys - 1 else 0.75 * height
        spire(brush, x, base - height, top, w, 0.12 * w, 0.8, 4, 10.0 * w / 50.0)
        w *= 0.85
    tip = y - 1.5 * height * storeys - height
    run(brush, x, tip + 0.4 * height, x, tip - 0.4 * height, 0.8, 0.6)
    brush.n[OPEN] = before


@kernel
def pavilion(brush: Brush, x: float, y: float, height: float, width: float, storeys: int) -> None:
    """An open pavilion: posts, railing, pointed roof (1.9 arch04)."""
    before = part(brush, PAVILION, x, y)
    w = width
    for i in range(storeys):
        base = y - 1.6 * height * i
        box(brush, x, base, height, w, 0.7, 0.15 * w, 1.0, True, PLAIN)
        rail(brush, x, base, 0.4 * height, 1.2 * w, 0.7, 0.18 * w, 4, 0.5, 0.5)
        spire(brush, x, base - height, 0.8 * height, w, 0.15 * w, 1.0, 3, 10.0 * w / 50.0)
        w *= 0.85
    brush.n[OPEN] = before


@kernel
def pylon(brush: Brush, x: float, y: float, height: float, width: float) -> None:
    """The power line's pylon that stands now and then among the hills (1.9)."""
    before = part(brush, PYLON, x, y)
    half = 0.5 * width
    levels = 8
    for s in range(2):
        f = 1.0 - 2.0 * s
        run(brush, x - f * half, y, x - f * 0.12 * half, y - height, 0.7, 0.5)
    for i in range(levels):
        p, q = i / levels, (i + 1.0) / levels
        a, b = half * (1.0 - 0.88 * p), half * (1.0 - 0.88 * q)
        run(brush, x - a, y - height * p, x + b, y - height * q, 0.4, 0.4)
        run(brush, x + a, y - height * p, x - b, y - height * q, 0.4, 0.4)
        run(brush, x - b, y - height * q, x + b, y - height * q, 0.4, 0.4)
    for i in range(3):
        level = y - height * (0.68 + 0.13 * i)
        arm = half * (1.9 - 0.3 * i)
        run(brush, x - arm, level, x + arm, level, 0.6, 0.5)
        run(brush, x - arm, level, x, level - 0.07 * height, 0.4, 0.4)
        run(brush, x + arm, level, x, level - 0.07 * height, 0.4, 0.4)
        for s in range(2):
            end = x + arm * (1.0 - 2.0 * s)
            run(brush, end, level, end, level + 0.035 * height, 0.5, 0.5)
    brush.n[OPEN] = before

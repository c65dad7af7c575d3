"""Specimens: every element by itself, and a sheet of all with their names."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from tambour.core.check import Array
from tambour.core.drawing import Label
from tambour.core.kernels import kernel
from tambour.ink.brush import press
from tambour.ink.brush.desk import Desk
from tambour.ink.brush.stroke import OPEN, PI, Brush, at, bell, between, body, part, ring, rnd
from tambour.ink.elements import (
    banks,
    bushes,
    cun,
    hamlet,
    hills,
    houses,
    limbs,
    people,
    pines,
    ranges,
    rocks,
    sky,
    trees,
    water,
    willows,
)
from tambour.ink.elements.limbs import SIDES
from tambour.ink.ground import codes
from tambour.ink.ground.joined import join
from tambour.ink.ground.marks import Marks

MARGIN = 12.0


@dataclass(frozen=True, slots=True)
class Specimen:
    """An element and the numbers it is shown with.

    kernel : draws it ; how : what the kernel is given after the place ; wide, tall : the room it has on the sheet
    """

    kernel: Callable[..., None]
    how: tuple[Any, ...]
    wide: float
    tall: float


def table() -> dict[str, Specimen]:
    """Every element that can be asked for by name, in the sheet's order."""
    _, forms, _, loops = press.tools()
    return {
        "juniper": Specimen(trees.juniper, (60.0, 3.0, 0.5), 80, 90),
        "sapling": Specimen(trees.sapling, (16.0, 8.0, 5, 0.6), 80, 90),
        "fir": Specimen(trees.fir, (110.0, 5.0, 0.05, 0.5), 80, 130),
        "copse": Specimen(copse, (160.0,), 220, 130),
        "bush": Specimen(bushes.bush, (60.0, 4.0, 0.5, forms, loops), 110, 90),
        "reed": Specimen(bushes.reed, (80.0, 1.0), 80, 120),
        "rock": Specimen(rocks.rock, (50.0, 60.0, 40, 10.0), 140, 90),
        "twig": Specimen(twig, (1.0,), 120, 90),
        "bark": Specimen(bark, (24.0, 18.0), 60, 90),
        "branch": Specimen(branch, (200.0, 8.0), 220, 90),
        "pine": Specimen(pines.pine, (300.0, 6.0), 320, 330),
        "cedar": Specimen(pines.cedar, (260.0, 5.0), 130, 330),
        "plum": Specimen(pines.plum, (110.0, 6.0, 0.0), 240, 330),
        "willow": Specimen(willows.willow, (150.0, 2.6), 220, 330),
        "hut": Specimen(houses.hut, (75.0, 180.0, 0.7, 4.0, 1), 220, 110),
        "house": Specimen(houses.house, (12.0, 70.0, 0.7, 4.0, 2, 2, True), 110, 110),
        "pagoda": Specimen(houses.pagoda, (10.0, 50.0, 7), 90, 160),
        "pavilion": Specimen(houses.pavilion, (18.0, 50.0, 2), 90, 110),
        "pylon": Specimen(houses.pylon, (100.0, 20.0), 60, 120),
        "figure": Specimen(people.figure, (0.8, 1.0, people.BUN, 0.9, people.WALKS), 120, 120),
        "boat": Specimen(people.boat, (120.0, 1.0, 1.0, True), 200, 120),
        "waterfall": Specimen(sky.waterfall, (130.0, 12.0), 90, 160),
        "birds": Specimen(sky.birds, (7,), 160, 60),
        "moon": Specimen(sky.moon, (28.0,), 140, 140),
        "sun": Specimen(sky.sun, (28.0,), 90, 90),
        "mist": Specimen(veiled, (0.7, 160.0), 340, 140),
        "water": Specimen(water.water, (2.0, 180.0, 9), 380, 70),
        "hill": Specimen(hills.hill, (230.0, 480.0, hills.CONE, 0.2, cun.HEMP, 180, 1.0, 1.0, 1.0, 1.0), 560, 330),
        "hamlet": Specimen(hamlet.hamlet, (360.0, 4, 1.0, 1.0, 1.0), 460, 130),
        "bridge": Specimen(hamlet.bridge, (110.0, 1.0, 1.0), 200, 90),
        "bank": Specimen(banks.bank, (100.0, 700.0, 0.55, 1.0, 0.0, 1.0, 1.0, forms, loops), 780, 330),
        "range": Specimen(ranges.distant, (150.0, 700.0, 0.0), 720, 150),
    }


def specimen(name: str, seed: str, edition: int = 1) -> Marks:
    """The marks of one element, its foot at (0, 0)."""
    desk = Desk.of("ink", edition)
    s = table()[name]
    desk.draw(s.kernel, ("specimen", seed, edition, name), f"specimen-{name}", 0.0, 0.0, *s.how)
    return desk.inked()


def moved(marks: Marks, x: float, y: float) -> Marks:
    """The same marks elsewhere."""
    by = np.array([x, y])
    e = marks.elements
    elements = replace(e, at=e.at + by, bounds=e.bounds + np.tile(by, 2))
    return replace(marks, coords=marks.coords + by, spine=marks.spine + by, elements=elements)


def sheet(seed: str, edition: int = 1) -> tuple[Marks, tuple[Label, ...], Array]:
    """The marks of all elements in rows, their names, and the sheet's size (2,)."""
    shown = list(table().items())
    width, x, y, row = 1600.0, 0.0, MARGIN, list[tuple[str, Specimen]]()
    placed: list[tuple[str, float, float]] = []

    def lay() -> None:
        nonlocal y
        tall = max(s.tall for _, s in row)
        spare = (width - sum(s.wide for _, s in row)) / (len(row) + 1)
        a = spare
        for name, s in row:
            placed.append((name, a + 0.5 * s.wide, y + tall))
            a += s.wide + spare
        y += tall + 42.0

    for name, s in shown:
        if row and x + s.wide + 2 * MARGIN > width:
            lay()
            row.clear()
            x = 0.0
        row.append((name, s))
        x += s.wide + 2 * MARGIN
    lay()
    drawn, labels = [], []
    for name, cx, base in placed:
        marks = specimen(name, seed, edition)
        left, _, right, low = marks.elements.bounds[0].tolist()
        # Each stands on its base line, in the middle of its room; the names stand below.
        drawn.append(moved(marks, cx - 0.5 * (left + right), base - max(0.0, low)))
        labels.append(Label(name, cx, base + 22.0, 13.0, "middle", 0.0, (110, 100, 88, 255)))
    return join(drawn), tuple(labels), np.array([width, y + MARGIN])


@kernel
def copse(brush: Brush, x: float, y: float, width: float) -> None:
    """A copse of the three small trees, as in the seed diary."""
    before = part(brush, codes.COPSE, x, y)
    for k in range(14):
        a = x + width * ((k + 0.5) / 14.0 - 0.5) + 6.0 * bell(brush.rng)
        b = y - 12.0 * rnd(brush.rng)
        what = rnd(brush.rng)
        if what < 0.5:
            trees.juniper(brush, a, b, between(brush.rng, 30.0, 70.0), between(brush.rng, 1.0, 4.0), 0.5)
        elif what < 0.75:
            trees.fir(brush, a, b, between(brush.rng, 60.0, 110.0), 5.0, 0.05 * rnd(brush.rng), 0.5)
        else:
            trees.sapling(brush, a, b, 16.0, 8.0, 5, 0.55)
    brush.n[OPEN] = before


@kernel
def veiled(brush: Brush, x: float, y: float, thickness: float, width: float) -> None:
    """Mist, and a range behind it: mist alone is paper."""
    before = part(brush, codes.MIST, x, y)
    ranges.distant(brush, x - 0.75 * width, y, 150.0, 1.5 * width, 0.0)
    sky.mist(brush, x, y, thickness, width)
    brush.n[OPEN] = before


@kernel
def branch(brush: Brush, x: float, y: float, length: float, width: float) -> None:
    """A branch by itself, lying almost level, with its bark."""
    before = part(brush, codes.BRANCH, x, y)
    limb = np.empty((SIDES, 2))
    limbs.branch(brush.table, brush.rng, limb, x, y, length, width, -0.12 * PI, 0.2 * PI)
    for i in range(SIDES):
        at(brush, limb[i, 0], limb[i, 1])
    body(brush)
    limbs.scales(brush, limb, 1.0, 1.0)
    brush.n[OPEN] = before


@kernel
def twig(brush: Brush, x: float, y: float, scale: float) -> None:
    """A twig with smaller twigs on it and needles."""
    before = part(brush, codes.TWIG, x, y)
    limbs.twig(brush, x, y, 2, scale, 0.0, 1.0, 1.0, 12.0)
    brush.n[OPEN] = before


@kernel
def bark(brush: Brush, x: float, y: float, length: float, breadth: float) -> None:
    """One scale of bark, large."""
    before = part(brush, codes.BARK, x, y)
    ring(brush, x, y - 0.5 * length, length, breadth, -0.5 * PI, 100.0, 0.6, 1.6)
    brush.n[OPEN] = before

"""Draw: planned wholes become marks, each kind by its kernel."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from tambour.ink.brush import press
from tambour.ink.brush.desk import Desk
from tambour.ink.elements import banks, hamlet, hills, people, ranges, sky, water
from tambour.ink.ground import codes
from tambour.ink.ground.marks import Marks
from tambour.ink.plan.whole import Planned


@dataclass(frozen=True, slots=True)
class Manner:
    """What the drawing of a whole depends on besides its plan; none of it moves anything else."""

    planted: float = 1.0
    bloom: float = 0.0
    buildings: bool = True
    figures: bool = True
    waterfalls: bool = True


def draw(
    planned: Sequence[Planned], manner: Manner, edition: int = 1, begin: float = -np.inf, end: float = np.inf
) -> Marks:
    """The marks of the wholes that lie in [begin, end), in their order."""
    desk = Desk.of("ink", edition, begin=begin, end=end)
    for p in planned:
        element, how = _how(p, manner)
        desk.draw(element, p.stream, p.id, p.x, p.y, *how, ink=p.ink)
    return desk.inked()


def _how(p: Planned, manner: Manner) -> tuple[Callable[..., None], tuple[Any, ...]]:
    """The kernel of a whole, and the numbers it is given after its place."""
    housed, peopled = float(manner.buildings), float(manner.figures)
    if p.kind == codes.HILL:
        return hills.hill, (*p.how, manner.planted, housed, 0.12 * manner.waterfalls)
    if p.kind == codes.BANK:
        _, forms, _, loops = press.tools()
        *ground, hutted = p.how
        return banks.bank, (*ground, manner.planted, manner.bloom, housed * hutted, peopled, forms, loops)
    if p.kind == codes.HAMLET:
        return hamlet.hamlet, (*p.how, manner.planted, housed, peopled)
    if p.kind == codes.BRIDGE:
        long, right, boats = p.how
        return hamlet.bridge, (long, right, peopled * boats)
    if p.kind == codes.BOAT:
        return people.boat, (*p.how, manner.figures)
    kernels: dict[int, Callable[..., None]] = {
        codes.RANGE: ranges.distant,
        codes.WATER: water.water,
        codes.MIST: sky.mist,
        codes.BIRDS: sky.birds,
        codes.MOON: sky.moon,
        codes.SUN: sky.sun,
        codes.SKY: sky.snow_sky,
    }
    return kernels[p.kind], p.how

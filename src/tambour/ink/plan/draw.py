"""Draw: planned wholes become marks, each kind by its kernel."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from tambour.core.check import Array
from tambour.ink.brush import press
from tambour.ink.brush.desk import Desk
from tambour.ink.elements import banks, hamlet, hills, people, ranges, sky, water
from tambour.ink.ground import codes
from tambour.ink.ground.marks import Elements, Marks
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


def roots(parent: Array) -> Array:
    """(E,) int64 the whole that each element belongs to."""
    root = np.where(parent < 0, np.arange(len(parent)), parent).astype(np.int64)
    while (parent[root] >= 0).any():
        root = np.where(parent[root] >= 0, parent[root], root)
    return root


def join(parts: Sequence[Marks]) -> Marks:
    """Marks one after the other."""
    if len(parts) == 1:
        return parts[0]
    first = np.cumsum([0, *(len(p.elements) for p in parts)])
    points = np.cumsum([0, *(len(p.coords) for p in parts)])
    spines = np.cumsum([0, *(len(p.spine) for p in parts)])

    def put(name: str) -> Array:
        return np.concatenate([getattr(p, name) for p in parts])

    def ends(name: str, shift: Array) -> Array:
        return np.concatenate([[0], *(getattr(p, name)[1:] + s for p, s in zip(parts, shift))])

    elements = Elements(
        tuple(name for p in parts for name in p.elements.id),
        np.concatenate([p.elements.kind for p in parts]),
        parts[0].elements.names,
        np.concatenate([np.where(p.elements.parent < 0, -1, p.elements.parent + f) for p, f in zip(parts, first)]),
        np.concatenate([p.elements.at for p in parts]),
        np.concatenate([p.elements.bounds for p in parts]),
    )
    element = np.concatenate([p.element + f for p, f in zip(parts, first)])
    return Marks(
        put("coords"), ends("offsets", points), put("spine"), ends("spines", spines), put("kind"), put("fill"),
        put("stroke"), put("edge"), put("breadth"), put("tint"), element, elements,
    )  # fmt: skip

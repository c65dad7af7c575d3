"""Whole: what a plan is made of: one thing to be drawn, and the rules that it follows."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from tambour.ink.ground import codes, kinds
from tambour.noise import key

_LETTERS = str.maketrans("0123456789", "ghijklmnop")
"""Ids are letters alone: a word such as 46e123 would be read as a number."""


@dataclass(frozen=True, slots=True)
class Rules:
    """What the plan depends on besides the tile: the seed, and the composition."""

    seed: str
    edition: int = 1
    density: float = 1.0
    height: float = 1.0
    mist: float = 0.0
    boats: bool = True
    birds: bool = True
    sky: str = "none"
    snow: bool = False
    reading: str = "rtl"


@dataclass(frozen=True, slots=True)
class Planned:
    """A whole to be drawn.

    kind : see :mod:`tambour.ink.ground.kinds` ; x, y : its foot ; depth : painter's order, the smallest first
    id : of its group ; stream : names of its stream of chance ; how : the numbers its kernel is given
    left, right : how far its marks may lie from x
    ink : how thick its ink is, 0 (far, pale) … 1 (near, black); None: as its kernel has it
    """

    kind: int
    x: float
    y: float
    depth: float
    id: str
    stream: tuple[str | int, ...]
    how: tuple[Any, ...]
    left: float
    right: float
    ink: float | None = None

    @property
    def room(self) -> tuple[float, float, float, float] | None:
        """Left, top, right and lower edge of about what it covers; None for what the eye does not rest on."""
        x, y, how = self.x, self.y, self.how
        if self.kind == codes.HILL:
            return x - 0.45 * how[1], y - how[0] - 20.0, x + 0.45 * how[1], y + 20.0
        if self.kind == codes.BANK:
            return x - 0.5 * how[1], y - 320.0, x + 0.5 * how[1], y + 40.0
        if self.kind == codes.RANGE:
            return x, y - 0.8 * how[0], x + how[1], y + 30.0
        if self.kind in (codes.HAMLET, codes.BRIDGE, codes.BOAT, codes.SUN, codes.MOON, codes.BIRDS):
            return x - 0.6 * self.right, y - 110.0, x + 0.6 * self.right, y + 40.0
        return None

    @property
    def order(self) -> tuple[float, str]:
        """The place in painter's order; the id decides between equals."""
        return self.depth, self.id


def place(
    rules: Rules,
    kind: int,
    m: int,
    number: int,
    x: float,
    y: float,
    depth: float,
    how: tuple[Any, ...],
    left: float,
    right: float,
    ink: float | None = None,
) -> Planned:
    """A whole with the id and the stream of chance that belong to number ``number`` of its kind in stretch ``m``."""
    name = kinds.NAMES[kind]
    names = ("ink", rules.seed, rules.edition, name, m, number)
    word = f"{key(*names) & 0xFFFFFFFFFFFF:012x}".translate(_LETTERS)
    return Planned(kind, x, y, depth, f"{name}-{word}", names, how, left, right, ink)

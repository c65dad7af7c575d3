"""Wholes: everything that stands in a tile. Every tile is a function of the seed and its number alone.

What stands on the ground comes from the scenes about the tile (:mod:`tambour.ink.plan.scenes`), what is in the sky from
the tile itself. The original walks along the scroll and looks at what it has already placed; ours can be planned
anywhere first.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache

import numpy as np

from tambour.ink.ground import codes
from tambour.ink.plan.scenes import REACH, SPACING, scene
from tambour.ink.plan.whole import Planned, Rules, place
from tambour.noise import stream

TILE = 512
"""Width of a tile in scroll units."""
HEIGHT = 700.0
"""Height of the scroll."""
FAR = 4
"""Tiles to either side of a window whose elements may reach into it (a range is up to 2000 long)."""


def window(
    rules: Rules, begin: float, end: float, told: Callable[[int, int], None] = lambda done, total: None
) -> list[Planned]:
    """All wholes that may reach into [begin, end), in painter's order; ``told`` how many tiles of how many are planned."""
    first, last = int(np.floor(begin / TILE)) - FAR, int(np.floor((end - 1e-9) / TILE)) + FAR
    found: list[Planned] = []
    for k in range(first, last + 1):
        told(k - first, last + 1 - first)
        found += [p for p in tile(rules, k) if p.x + p.right >= begin and p.x - p.left < end]
    return sorted(found, key=lambda p: p.order)


@lru_cache(maxsize=256)
def tile(rules: Rules, k: int) -> tuple[Planned, ...]:
    """The wholes whose feet stand in tile ``k``: [512 k, 512 k + 512)."""
    begin, end = k * TILE, (k + 1) * TILE
    first, last = int(np.floor((begin - REACH) / SPACING)) - 1, int(np.floor((end + REACH) / SPACING)) + 1
    made = [p for m in range(first, last + 1) for p in scene(rules, m) if begin <= p.x < end]
    return (*made, *sky(rules, k))


def sky(rules: Rules, k: int) -> list[Planned]:
    """Birds now and then; sun or moon once in 4096 units, in the middle half of its stretch."""
    made: list[Planned] = []
    if rules.snow:
        made.append(
            place(rules, codes.SKY, k, 0, float(k * TILE), -200.0, -30_000.0, (TILE * 1.0, 1200.0), 1.0, TILE + 2.0)
        )
    u = stream("ink", rules.seed, rules.edition, "sky", k).random(4)
    x = (k + float(u[1])) * TILE
    if rules.birds and u[0] < 0.12:
        y = 60.0 + 140.0 * float(u[2])
        made.append(place(rules, codes.BIRDS, k, 0, x, y, 299.0, (3 + int(9 * u[3]),), 150.0, 150.0))
    if rules.sky != "none":
        m = (k * TILE) // 4096
        v = stream("ink", rules.seed, rules.edition, "light", m).random(2)
        x = 4096.0 * (m + 0.25 + 0.5 * float(v[0]))
        if k * TILE <= x < (k + 1) * TILE:
            kind = codes.MOON if rules.sky == "moon" else codes.SUN
            y = 70.0 + 60.0 * float(v[1]) if kind == codes.MOON else 190.0 + 40.0 * float(v[1])
            made.append(place(rules, kind, m, 0, x, y, -20_000.0, (32.0,), 80.0, 80.0))
    return made

"""Plan: where hills, banks, ranges and boats stand. Every tile is a function of the seed and its number alone.

The rules are the original's (dossier 1.12). It walks along the scroll and looks at what it has already placed; here
each rule asks only the noise, and the tiles next to its own, so that any tile can be planned first.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any

import numpy as np

from tambour.core.arrays import F8x2
from tambour.core.kernels import kernel
from tambour.ink.ground import codes, kinds
from tambour.noise import drift, key, stream, uniform

TILE = 512
"""Width of a tile in scroll units."""
STEP = 5
HEIGHT = 700.0
"""Height of the scroll."""
FAR = 4
"""Tiles to either side of a window whose elements may reach into it (a range is up to 2000 long)."""


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


@dataclass(frozen=True, slots=True)
class Planned:
    """A whole to be drawn.

    kind : see :mod:`tambour.ink.ground.kinds` ; x, y : its foot ; depth : painter's order, the smallest first
    id : of its group ; stream : names of its stream of chance ; how : the numbers its kernel is given
    left, right : how far its marks may lie from x
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

    @property
    def order(self) -> tuple[float, str]:
        """The place in painter's order; the id decides between equals."""
        return self.depth, self.id


def window(rules: Rules, begin: float, end: float) -> list[Planned]:
    """All wholes that may reach into [begin, end), in painter's order."""
    first, last = int(np.floor(begin / TILE)), int(np.floor((end - 1e-9) / TILE))
    found = [
        p
        for k in range(first - FAR, last + FAR + 1)
        for p in tile(rules, k)
        if p.x + p.right >= begin and p.x - p.left < end
    ]
    return sorted(found, key=lambda p: p.order)


@lru_cache(maxsize=256)
def tile(rules: Rules, k: int) -> tuple[Planned, ...]:
    """The wholes whose feet stand in tile ``k``: [512 k, 512 k + 512)."""
    made: list[Planned] = []
    for p in (*_near(rules, k, hills, 1), *(_hutted(rules, k, p) for p in _near(rules, k, banks, 2))):
        made.append(p)
    for p in list(made):
        if p.kind == codes.HILL:
            made.append(_water(rules, p))
            if rules.mist > 0:
                made.append(_mist(rules, p))
    made += ranges(rules, k)
    made += boats(rules, k) if rules.boats else []
    made += sky(rules, k)
    return tuple(made)


def _near(rules: Rules, k: int, spread: Any, reach: int) -> list[Planned]:
    """What ``spread`` from tiles k - reach … k + reach puts into tile k."""
    return [p for j in range(k - reach, k + reach + 1) for p in spread(rules, j) if k * TILE <= p.x < (k + 1) * TILE]


def _place(
    rules: Rules,
    kind: int,
    k: int,
    number: int,
    x: float,
    y: float,
    depth: float,
    how: tuple[Any, ...],
    left: float,
    right: float,
) -> Planned:
    name = kinds.NAMES[kind]
    names = ("ink", rules.seed, rules.edition, name, k, number)
    word = f"{key(*names) & 0xFFFFFFFFFFFF:012x}".translate(_LETTERS)
    return Planned(kind, x, y, depth, f"{name}-{word}", names, how, left, right)


@kernel
def _profile(line: np.uint64, begin: int, out: F8x2) -> None:
    """Three noises at every step from ``begin`` (in steps): where columns rise, how deep, where land is: out (k, 3)."""
    for i in range(len(out)):
        x = 5.0 * (begin + i)
        out[i, 0] = drift(line, 0.03 * x)
        out[i, 1] = drift(line + np.uint64(1), 0.01 * x)
        out[i, 2] = drift(line + np.uint64(2), x / 800.0)


@lru_cache(maxsize=512)
def hills(rules: Rules, k: int) -> tuple[Planned, ...]:
    """Hills that columns of tile ``k`` raise: at maxima of the noise, up to twelve, each up to 350 to the side.

    Columns stand only where a slow noise says land: between massifs lie waters a thousand units wide. Far hills are
    lower, so that their crests stay on the paper.
    """
    first, last = -(-k * TILE // STEP), -(-(k + 1) * TILE // STEP)
    profile = np.empty((last - first + 3, 3))
    _profile(np.uint64(key("ink", rules.seed, rules.edition, "columns")), first - 2, profile)
    high, rows, land = profile.T
    chance = stream("ink", rules.seed, rules.edition, "hills", k)
    made: list[Planned] = []
    shore = 0.445 - 0.12 * (rules.density - 1.0)
    for i in range(2, len(profile) - 1):
        if high[i] <= 0.7 or high[i] < high[i - 2 : i + 2].max() or land[i] < shore:
            continue
        x = float(STEP * (first - 2 + i))
        for row in range(0, int(480 * rows[i]), 40):
            u = chance.random(6)
            if u[5] >= rules.density:
                continue
            y = 300.0 + row
            wide, tall = 400.0 + 200.0 * float(u[2]), (100.0 + 400.0 * float(u[1])) * (0.9 + 0.25 * row / 480)
            tall *= rules.height
            at = x + 700.0 * (float(u[0]) - 0.5)
            made.append(
                _place(rules, codes.HILL, k, len(made), at, y, y, (tall, wide), 0.5 * wide + 150.0, 0.5 * wide + 150.0)
            )
    return tuple(made)


@lru_cache(maxsize=512)
def banks(rules: Rules, k: int) -> tuple[Planned, ...]:
    """Banks that tile ``k`` spreads, up to 700 to the side: where no hill's foot lies within 200."""
    feet = np.array([p.x for j in (k - 1, k, k + 1) for p in _near(rules, j, hills, 1)])
    chance = stream("ink", rules.seed, rules.edition, "banks", k)
    made: list[Planned] = []
    for i in range(TILE // STEP):
        u = chance.random(17)
        x = k * TILE + STEP * i
        if u[0] >= 0.013 * rules.density or (feet.size and abs(feet - x).min() < 200.0):
            continue
        for j in range(int(4.0 * u[1]) + 1):
            a, b, c = u[2 + 3 * j : 5 + 3 * j]
            wide, y = 600.0 + 400.0 * float(b), 700.0 - 50.0 * j
            at = x + 1400.0 * (float(a) - 0.5)
            made.append(
                _place(
                    rules,
                    codes.BANK,
                    k,
                    len(made),
                    at,
                    y,
                    y,
                    (100.0, wide, 0.5 + 0.2 * float(c), 0.0),
                    0.5 * wide + 300.0,
                    0.5 * wide + 300.0,
                )
            )
    return tuple(made)


def _hutted(rules: Rules, k: int, bank: Planned) -> Planned:
    """The bank, and whether a hut stands on it: three in five are willing, and of those within 900 the one of highest rank.

    The original gives a hut to one bank in six whatever stands beside it (1.8). Of ours 0.15 have one, which is 0.29 in a
    thousand units, and never do two stand side by side.
    """
    rank = _rank(bank)
    if rank < 0.4:
        return bank
    near = (p for j in range(k - 2, k + 3) for p in _near(rules, j, banks, 2) if abs(p.x - bank.x) < 900.0)
    return bank if any(_rank(p) > rank for p in near) else replace(bank, how=(*bank.how[:3], 1.0))


def _rank(bank: Planned) -> float:
    # A number of the bank's own stream that its drawing never comes to.
    return float(uniform(np.uint64(key(*bank.stream)), np.uint64(1 << 60)))


RIDGES = ((0.0, 1.0, 165.0, 0.0), (-18.0, 0.85, 185.0, 0.25), (-30.0, 0.25, 210.0, 0.5))
"""Distant ranges, near to far: shift of the foot, chance that there is one, height, paleness."""


@lru_cache(maxsize=512)
def _ridges(rules: Rules, m: int) -> tuple[Planned, ...]:
    """Distant ranges of the stretch [1000 m, 1000 m + 1000): up to three, one behind the other."""
    u = stream("ink", rules.seed, rules.edition, "ranges", m).random((len(RIDGES), 4))
    made: list[Planned] = []
    for j, (shift, chance, height, pale) in enumerate(RIDGES):
        if u[j, 0] < chance:
            x, y, long = (
                1000.0 * (m + float(u[j, 1])),
                280.0 + shift - 30.0 * float(u[j, 2]),
                1000.0 + 1000.0 * float(u[j, 3]),
            )
            made.append(_place(rules, codes.RANGE, m, j, x, y, y, (height, long, pale), 5.0, long + 5.0))
    return tuple(made)


def ranges(rules: Rules, k: int) -> list[Planned]:
    """The distant ranges that begin in tile ``k``."""
    first, last = k * TILE // 1000, ((k + 1) * TILE - 1) // 1000
    return [p for m in range(first, last + 1) for p in _ridges(rules, m) if k * TILE <= p.x < (k + 1) * TILE]


def _water(rules: Rules, hill: Planned) -> Planned:
    k, number, reach = int(hill.stream[4]), int(hill.stream[5]), 0.5 * hill.how[1] + 180.0
    return _place(
        rules, codes.WATER, k, number, hill.x, hill.y, hill.y - 10_000.0, (2.0, reach, 9), reach + 5.0, reach + 5.0
    )


def _mist(rules: Rules, hill: Planned) -> Planned:
    k, number = int(hill.stream[4]), int(hill.stream[5])
    return _place(rules, codes.MIST, k, number, hill.x, hill.y, hill.y + 0.5, (rules.mist, hill.how[1]), 700.0, 700.0)


@lru_cache(maxsize=512)
def _moorings(rules: Rules, k: int) -> tuple[tuple[float, float, float], ...]:
    """Places (x, rank, y) in tile k where a boat could lie: each step with one chance in five, 400 from hills' feet and 250
    from banks'."""
    around = range(k - 1, k + 2)
    land = np.array([p.x for j in around for p in _near(rules, j, hills, 1)])
    near = np.array([p.x for j in around for p in _near(rules, j, banks, 2)])
    u = stream("ink", rules.seed, rules.edition, "boats", k).random((TILE // STEP, 3))
    found = []
    for i, (a, b, c) in enumerate(u.tolist()):
        x = float(k * TILE + STEP * i)
        if (
            a < 0.2 * min(1.0, rules.density)
            and abs(land - x).min(initial=1e9) > 400.0
            and abs(near - x).min(initial=1e9) > 250.0
        ):
            found.append((x, b, 300.0 + 390.0 * c))
    return tuple(found)


def boats(rules: Rules, k: int) -> list[Planned]:
    """Boats in tile k: of moorings within 400 of each other the one of highest rank is taken (Matérn's second process)."""
    around = [m for j in (k - 1, k, k + 1) for m in _moorings(rules, j)]
    made: list[Planned] = []
    for x, rank, y in _moorings(rules, k):
        if all(rank >= r for a, r, _ in around if abs(a - x) < 400.0):
            right = 1.0 if rank * 1e6 % 1.0 < 0.5 else -1.0
            made.append(_place(rules, codes.BOAT, k, len(made), x, y, y, (120.0, y / 800.0, right), 150.0, 150.0))
    return made


def sky(rules: Rules, k: int) -> list[Planned]:
    """Birds now and then; sun or moon once in 4096 units, in the middle half of its stretch."""
    made: list[Planned] = []
    if rules.snow:
        made.append(
            _place(rules, codes.SKY, k, 0, float(k * TILE), -200.0, -30_000.0, (TILE * 1.0, 1200.0), 1.0, TILE + 2.0)
        )
    u = stream("ink", rules.seed, rules.edition, "sky", k).random(4)
    x = (k + float(u[1])) * TILE
    if rules.birds and u[0] < 0.12:
        y = 60.0 + 140.0 * float(u[2])
        made.append(_place(rules, codes.BIRDS, k, 0, x, y, 299.0, (3 + int(9 * u[3]),), 150.0, 150.0))
    if rules.sky != "none":
        m = (k * TILE) // 4096
        v = stream("ink", rules.seed, rules.edition, "light", m).random(2)
        x = 4096.0 * (m + 0.25 + 0.5 * float(v[0]))
        if k * TILE <= x < (k + 1) * TILE:
            kind = codes.MOON if rules.sky == "moon" else codes.SUN
            y = 70.0 + 60.0 * float(v[1]) if kind == codes.MOON else 190.0 + 40.0 * float(v[1])
            made.append(_place(rules, kind, m, 0, x, y, -20_000.0, (32.0,), 80.0, 80.0))
    return made

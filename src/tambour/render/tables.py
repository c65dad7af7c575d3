"""Tables: what a thing lies on in its picture: boards, linen, stone or a sheet of paper, as tiles of grain, and its window."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Final

import numpy as np

from tambour.core.check import Array
from tambour.noise import stream
from tambour.render.light import window

SIDE: Final = 1024
"""Texels along the side of a table's tile."""
BOARD: Final = 4
"""Boards that the tile has side by side."""
PLANK: Final = 90.0
"""Width of a board, mm."""
LEVELS: Final = 8
"""Sizes of the tile, each half as fine as the one before: what lies far away or out of focus takes a coarse one."""
NEARER: Final = 5.3
"""How much finer the tile is of what is added near to."""
THREADS: Final = 96
"""Threads of linen along the side of its near tile."""


@dataclass(frozen=True, slots=True)
class Table:
    """A place to take a picture at.

    grain : which tile it has (of :func:`tile`); light, dark : sRGB, between and in its grain
    wall : sRGB of what stands behind it, or None: it bends up behind the thing, as a sheet of paper does
    side : where the window is, radians to the left of the camera; soft : how wide it is, radians; high : how high it stands, radians
    room : what is on the wall or before it (of :mod:`tambour.render.room`): its name, how far from the picture's middle towards the window, how far
        below its top, and its size, in the picture's width
    warm : how much warmer the window's light is than the room's: 1 on a fine morning, below 0 where the sky is blue and a lamp lit
    """

    grain: str
    light: tuple[float, float, float]
    dark: tuple[float, float, float]
    wall: tuple[float, float, float] | None
    side: float = 0.95
    soft: float = 0.22
    high: float = 0.72
    warm: float = 0.6
    room: tuple[tuple[str, float, float, float], ...] = ()

    def lit(self, azimuth: float, sky: int, lamp: int) -> tuple[Array, Array, Array]:
        """Its window's lights, of :func:`tambour.render.light.window`."""
        return window(azimuth, sky, lamp, side=self.side, soft=self.soft, high=self.high, warm=self.warm)


TABLES: Final[dict[str, Table]] = {
    "oak": Table(
        "wood",
        (0.79, 0.69, 0.565),
        (0.58, 0.45, 0.33),
        (0.91, 0.89, 0.855),
        room=(("curtain", 0.44, 0.0, 0.24), ("plant", -0.36, 0.20, 0.20), ("frame", 0.14, 0.04, 0.15)),
    ),
    "paper": Table("paper", (0.91, 0.89, 0.86), (0.85, 0.83, 0.80), None, -0.80, 0.34, 0.80, 0.5),
    "linen": Table(
        "linen",
        (0.86, 0.825, 0.76),
        (0.56, 0.51, 0.44),
        (0.79, 0.81, 0.80),
        -1.05,
        0.26,
        0.62,
        0.8,
        room=(("frame", -0.33, 0.08, 0.22), ("frame", -0.07, 0.02, 0.15), ("lamp", 0.40, 0.16, 0.22)),
    ),
    "painted": Table(
        "painted",
        (0.91, 0.895, 0.87),
        (0.64, 0.615, 0.585),
        (0.86, 0.875, 0.855),
        1.10,
        0.33,
        0.78,
        0.5,
        room=(("books", -0.30, 0.17, 0.27), ("plant", 0.37, 0.22, 0.18)),
    ),
    "stone": Table(
        "stone",
        (0.68, 0.67, 0.655),
        (0.45, 0.445, 0.44),
        (0.83, 0.80, 0.76),
        0.75,
        0.30,
        0.74,
        0.9,
        room=(("cupboard", -0.18, 0.20, 0.3), ("frame", 0.26, 0.06, 0.2)),
    ),
    "walnut": Table(
        "wood",
        (0.50, 0.37, 0.27),
        (0.26, 0.17, 0.11),
        (0.73, 0.74, 0.71),
        -0.90,
        0.22,
        0.60,
        1.0,
        room=(("lamp", -0.36, 0.18, 0.26), ("books", 0.30, 0.16, 0.25)),
    ),
    "birch": Table(
        "wood",
        (0.88, 0.80, 0.69),
        (0.74, 0.63, 0.50),
        (0.74, 0.79, 0.74),
        -0.70,
        0.20,
        0.66,
        0.9,
        room=(("plant", -0.34, 0.17, 0.24), ("curtain", 0.42, 0.0, 0.22), ("frame", 0.12, 0.03, 0.16)),
    ),
    "slate": Table(
        "stone",
        (0.40, 0.41, 0.43),
        (0.22, 0.225, 0.24),
        (0.80, 0.765, 0.72),
        1.15,
        0.24,
        0.58,
        0.3,
        room=(("books", -0.28, 0.15, 0.28), ("frame", 0.32, 0.08, 0.2)),
    ),
    "cherry": Table(
        "wood",
        (0.66, 0.47, 0.34),
        (0.44, 0.27, 0.17),
        (0.71, 0.76, 0.80),
        0.85,
        0.16,
        0.64,
        1.1,
        room=(("frame", -0.34, 0.05, 0.24), ("plant", 0.38, 0.23, 0.2)),
    ),
    "chalk": Table(
        "painted",
        (0.80, 0.83, 0.82),
        (0.55, 0.58, 0.57),
        (0.90, 0.85, 0.80),
        -1.15,
        0.36,
        0.84,
        -0.3,
        room=(("curtain", 0.42, 0.0, 0.26), ("cupboard", -0.26, 0.22, 0.28)),
    ),
    "wool": Table(
        "linen",
        (0.74, 0.71, 0.68),
        (0.44, 0.41, 0.385),
        (0.88, 0.85, 0.82),
        0.95,
        0.30,
        0.70,
        0.2,
        room=(("lamp", -0.38, 0.2, 0.22), ("frame", -0.06, 0.03, 0.17), ("plant", 0.36, 0.2, 0.19)),
    ),
}
"""By name: boards of oak, walnut, birch and cherry; a sheet of paper; cloths of linen and wool; painted boards, white and chalky green; stone and slate."""


@cache
def tile(grain: str) -> Array:
    """(2, 2 SIDE, SIDE) float32: how dark a table is, 0…1, and below it coarser ones; and what is added to that near to, of
    mean 0, a tile of its own. Boards have their rows across them."""
    made, fine = {"wood": _wood, "painted": _painted, "linen": _linen, "stone": _stone, "paper": _paper}[grain]()
    out = np.zeros((2, 2 * SIDE, SIDE), np.float32)
    for k, level in enumerate((np.clip(made, 0.0, 1.6), fine - fine.mean())):
        at = 0
        for _ in range(LEVELS):
            out[k, at : at + len(level), : len(level)] = level
            at += len(level)
            level = 0.25 * (level[::2, ::2] + level[1::2, ::2] + level[::2, 1::2] + level[1::2, 1::2])
    return out


def _wood() -> tuple[Array, Array]:
    """Boards of one kind of tree, sawn flat: each cuts its years as far from their middle as the log happened to lie; and its pores."""
    rough = stream("table", 1)
    wide = SIDE // BOARD
    across = (np.arange(wide)[:, None] + 0.5) / wide * PLANK
    boards = []
    for _ in range(BOARD):
        # mm: where the tree's middle lies beside the board, and how deep below it, as the tree sways along it.
        beside = PLANK * rough.uniform(-0.1, 1.1) + 3.0 * _fine(rough.standard_normal((1, 4)), 1, SIDE)
        below = np.abs(rough.uniform(16.0, 46.0) + 6.0 * _fine(rough.standard_normal((1, 3)), 1, SIDE))
        ripple = 0.3 * _fine(rough.standard_normal((10, 24)), wide, SIDE)
        far = np.sqrt((across - beside) ** 2 + below**2) + ripple
        # A year grows pale first and dark at its end; some are fat and some lean.
        fat = 4.2 + 1.1 * np.interp(far, np.arange(160), rough.standard_normal(160))
        year = far / np.maximum(fat.mean(), 2.0) + 0.25 * np.interp(far, np.arange(160), rough.standard_normal(160))
        year -= np.floor(year)
        boards.append(year**3 * np.clip(9.0 * (1.0 - year), 0.0, 1.0))
    rings = np.concatenate(boards)
    streaks = sum(
        share * _fine(rough.standard_normal(shape), SIDE, SIDE) for shape, share in (((64, 5), 0.5), ((1024, 20), 0.5))
    )
    fine = 0.065 * _fine(rough.standard_normal((1024, 64)), SIDE, SIDE)
    fine += _pores(rough, _patches(rough, 40, 3, 1.0), 6200, 90, 0.5)
    return _boards(0.22 + 0.44 * rings + 0.06 * streaks, rough, 0.10, 1.0), np.asarray(fine)


def _pores(rough: np.random.Generator, where: Array, count: int, longest: int, deep: float) -> Array:
    """Short sharp strokes along the grain, each as long, wide and dark as it happens to be: most are short and faint, few are neither; and
    only as many as ``where`` (SIDE, SIDE), 0…1, lets stand at a place: none in some, many in others."""
    row, column = rough.integers(0, SIDE, (2, count))
    stands = rough.random(count) < where[row, column]
    row, column = row[stands], column[stands]
    rare = rough.random(len(row)) ** 2.2
    long = 4 + ((longest - 4) * rare).astype(int)
    dark = deep * rough.uniform(0.25, 1.0, len(row)) * (0.45 + 0.55 * rare)
    thick = rough.uniform(0.15, 1.0, len(row))
    # The grain is never quite straight: a stroke goes aslant by as little as those about it.
    slant = 0.05 * _fine(rough.standard_normal((6, 6)), SIDE, SIDE)[row, column]
    out = np.zeros((SIDE, SIDE))
    for k in range(longest):
        on = k < long
        # Thin at both ends.
        share = dark[on] * np.minimum(1.0, 3.0 * np.minimum(k + 1, long[on] - k) / long[on])
        beside = row[on] + slant[on] * k
        low = np.floor(beside).astype(int)
        for step in (0, 1, 2):
            part = np.clip(0.55 + thick[on] - abs(low + step - beside - 0.5), 0.0, 1.0)
            at = ((low + step) % SIDE, (column[on] + k) % SIDE)
            out[at] = np.maximum(out[at], part * share)
    return out


def _patches(rough: np.random.Generator, rows: int, columns: int, most: float) -> Array:
    """A field (SIDE, SIDE), 0…``most``, that is naught over about a third of it."""
    made = _fine(rough.standard_normal((rows, columns)), SIDE, SIDE)
    return np.asarray(most * np.clip(0.35 + 0.6 * made, 0.0, 1.0))


def _painted() -> tuple[Array, Array]:
    """Boards under white paint: the brush's way, the pores that it did not fill, and specks where it came off."""
    rough = stream("table", 2)
    brush = sum(
        (_fine(rough.standard_normal(shape), SIDE, SIDE) for shape in ((128, 6), (24, 24), (7, 9))),
        np.zeros((SIDE, SIDE)),
    )
    fine = 0.035 * _fine(rough.standard_normal((1024, 48)), SIDE, SIDE) + _pores(
        rough, _patches(rough, 14, 4, 0.8), 1500, 80, 0.2
    )
    specks = np.maximum(_fine(rough.standard_normal((340, 240)), SIDE, SIDE) - 2.9, 0.0)
    return _boards(0.10 + 0.02 * brush, rough, 0.03, 0.8), np.asarray(fine + 0.7 * specks)


def _boards(grain: Array, rough: np.random.Generator, tones: float, groove: float) -> Array:
    """Every board has a tone of its own, another stretch of the tree, and a rounded edge towards the next."""
    wide = SIDE // BOARD
    tone, shift = rough.uniform(-tones, tones, BOARD), rough.integers(0, SIDE, BOARD)
    made = np.concatenate([np.roll(grain[k * wide : (k + 1) * wide], shift[k], 1) + tone[k] for k in range(BOARD)])
    far = np.abs((np.arange(SIDE) + 0.5 * wide) % wide - 0.5 * wide)[:, None]
    return np.asarray(made + groove * np.exp(-0.5 * (far / 1.1) ** 2) + 0.1 * np.exp(-0.5 * (far / 4.0) ** 2))


def _linen() -> tuple[Array, Array]:
    """A plain weave of threads that are thick and thin."""
    rough = stream("table", 3)
    slubs = [_fine(rough.standard_normal(shape), SIDE, SIDE) for shape in ((1024, 24), (24, 1024))]
    clouds = sum((_fine(rough.standard_normal((n, n)), SIDE, SIDE) for n in (6, 14, 40)), np.zeros((SIDE, SIDE)))
    made = 0.36 + 0.028 * (slubs[0] + slubs[1]) + 0.02 * clouds
    # No thread is as thick as the next, or straight: what lies where is asked of threads that wander.
    ways = []
    for shape, turned in (((THREADS, 9), False), ((9, THREADS), True)):
        wander = 0.22 * _fine(rough.standard_normal(shape), SIDE, SIDE)
        wander += 0.5 * _fine(rough.standard_normal((5, 5)), SIDE, SIDE)
        at = (np.arange(SIDE) * THREADS / SIDE)[None] if turned else (np.arange(SIDE) * THREADS / SIDE)[:, None]
        ways.append(at + wander)
    number = [np.floor(way).astype(int) for way in ways]
    weft_at, warp_at = (way - each - 0.5 for way, each in zip(ways, number))
    tones = [_fine(rough.standard_normal(shape), SIDE, SIDE) for shape in ((THREADS, 10), (10, THREADS))]
    over = (number[0] + number[1]) % 2 == 0
    # A thread is round, and dips under the next one that crosses it.
    weft, warp = np.cos(np.pi * weft_at), np.cos(np.pi * warp_at)
    weft, warp = weft * (0.55 + 0.45 * warp), warp * (0.55 + 0.45 * weft)
    height = np.where(over, weft * (1.0 + 0.16 * tones[0]), warp * (1.0 + 0.16 * tones[1]))
    # Each is twisted of fibres, which show as fine strokes along it.
    spun = np.where(over, *(_fine(rough.standard_normal(shape), SIDE, SIDE) for shape in ((1024, 256), (256, 1024))))
    return np.asarray(made), np.asarray(0.40 * (height.mean() - height) - 0.06 * spun * height)


def _stone() -> tuple[Array, Array]:
    """Cast stone: clouds of every size, a few pits."""
    rough = stream("table", 4)
    made = np.full((SIDE, SIDE), 0.4)
    for n in (5, 11, 23, 61, 150, 400):
        made += 0.45 / n**0.33 * 0.25 * _fine(rough.standard_normal((n, n)), SIDE, SIDE)
    fine = 0.07 * sum(_fine(rough.standard_normal((n, n)), SIDE, SIDE) for n in (120, 300, 700))
    pits = np.maximum(_fine(rough.standard_normal((160, 160)), SIDE, SIDE) - 2.3, 0.0)
    grains = np.clip(_fine(rough.standard_normal((420, 420)), SIDE, SIDE) - 1.9, 0.0, 0.5)
    dust = np.clip(_fine(rough.standard_normal((512, 512)), SIDE, SIDE) - 1.8, 0.0, 0.6)
    return made, np.asarray(fine + 0.9 * np.minimum(pits, 0.5) + 0.5 * grains - 0.4 * dust)


def _paper() -> tuple[Array, Array]:
    """A sheet: hardly anything to be seen."""
    rough = stream("table", 5)
    clouds = sum((_fine(rough.standard_normal((n, n)), SIDE, SIDE) for n in (4, 9, 30)), np.zeros((SIDE, SIDE)))
    return np.asarray(0.3 + 0.04 * clouds), 0.12 * _fine(rough.standard_normal((500, 500)), SIDE, SIDE)


def _fine(field: Array, rows: int, columns: int) -> Array:
    """A field that wraps, blended to a finer one with smooth steps."""
    for axis, size in ((0, rows), (1, columns)):
        n = field.shape[axis]
        at = (np.arange(size) + 0.5) * n / size - 0.5
        low = np.floor(at).astype(int)
        t = at - low
        t = (t * t * (3 - 2 * t)).reshape((-1, 1) if axis == 0 else (1, -1))
        field = np.take(field, low % n, axis) * (1 - t) + np.take(field, (low + 1) % n, axis) * t
    return np.asarray(field)

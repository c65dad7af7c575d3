"""Texture patches: areas of like brightness filled with lawful textures (the paper's section 7).

The tone is sorted into levels; each level has a small tile that repeats, keeps to the float limit by itself and has the
level's mean. The tiles are ready-made (rows of one rhythm, each moved against the last), grown from noise, or taken from
a region that the user marks. Where two textures meet a run may be too long: the solver mends that.
"""

from __future__ import annotations

from fractions import Fraction

import numpy as np

from tambour.core.check import Array
from tambour.core.errors import TambourError
from tambour.knit.params import KnitParams
from tambour.knit.picture import tone
from tambour.knit.solve import exact, percept
from tambour.knit.task import Task
from tambour.noise import stream

LEVELS = 9
NOISE = 32  # stitches of a tile grown from noise


def assign(t: Array, limit: int, params: KnitParams) -> Array:
    """(R, C) uint8: every stitch as the tile of its level has it."""
    from scipy.ndimage import gaussian_filter

    tiles = ready(limit) if params.patches == "ready" else noise(limit, params)
    low, high = tone.reach(limit, 1.0)
    # Areas, not specks: the tone is sorted after a blur.
    smooth = gaussian_filter(t, 1.5)
    level = np.clip(np.round((smooth - low) / max(high - low, 1e-6) * (LEVELS - 1)), 0, LEVELS - 1)
    level = level.astype(np.int64)
    if params.patches == "marked":
        middle, own = marked(t, level, limit, params)
        tiles[middle] = own
    out = np.zeros(t.shape, np.uint8)
    r, x = np.arange(t.shape[0])[:, None], np.arange(t.shape[1])[None]
    for k, tile in enumerate(tiles):
        mine = level == k
        out[mine] = np.broadcast_to(tile[r % tile.shape[0], x % tile.shape[1]], t.shape)[mine]
    return out


def levels(limit: int) -> list[Fraction]:
    """The means of the levels, from 1 / (f + 1) to f / (f + 1)."""
    low = Fraction(1, limit + 1)
    return [low + (1 - 2 * low) * Fraction(k, LEVELS - 1) for k in range(LEVELS)]


def ready(limit: int) -> list[Array]:
    """Twills: every row has the same rhythm of light and dark, and is moved by two or three stitches against the last."""
    tiles = []
    for mean in levels(limit):
        near = mean.limit_denominator(max(2, limit + 1))
        light, period = near.numerator, near.denominator
        if period == 1 or light in (0, period):
            light, period = (1, 2)
        # Spread the light stitches evenly (Bresenham): then no run is longer than it must be.
        row = np.array([(k * light) // period != ((k + 1) * light) // period for k in range(period)], np.uint8)
        step = next(s for s in (2, 3, 1) if np.gcd(s, period) == 1 or s == 1)
        tiles.append(np.stack([np.roll(row, step * k) for k in range(period)]))
    return tiles


def noise(limit: int, params: KnitParams) -> list[Array]:
    """Smoothed noise about the level's mean, solved as rounds, so that rows close upon themselves."""
    from scipy.ndimage import gaussian_filter

    field = stream("knit", params.seed, "patches").random((NOISE, NOISE))
    field = gaussian_filter(field, 0.6, mode="wrap") - gaussian_filter(field, 1.6, mode="wrap")
    spread = 0.15 / max(float(field.std()), 1e-9)
    tiles = []
    for mean in levels(limit):
        aim = np.clip(float(mean) + spread * field, 0, 1).astype(np.float32)
        within = min(limit, percept.LARGEST)
        task = Task(aim, tone.assign(aim, "floyd-steinberg", 0.5), within, ring=True, seed=params.seed)
        tiles.append(percept.solve(task, percept.eye(within)))
    return tiles


def marked(t: Array, level: Array, limit: int, params: KnitParams) -> tuple[int, Array]:
    """The level of the marked region, the median of its stitches', and its tile: the region itself, dithered, and made
    lawful as it repeats. Raises TambourError when the region lies outside the chart.
    """
    assert params.patch_from is not None, "checked by the params"
    left, top, wide, high = map(int, params.patch_from.split(","))
    rows, stitches = t.shape
    if left + wide > stitches or top + high > rows:
        raise TambourError(
            f"the region {params.patch_from} reaches beyond the chart of {stitches} x {rows} stitches",
            where="{--patch-from}",
        )
    part = (slice(rows - top - high, rows - top), slice(left, left + wide))
    texture = tone.assign(np.ascontiguousarray(t[part]), "floyd-steinberg", params.threshold)
    task = Task(np.zeros(texture.shape, np.float32), texture, limit, ring=True, seed=params.seed)
    return int(np.median(level[part])), exact.solve(task)

"""Paper: a warm fibrous sheet, as two glazes that darken what lies under them and repeat without a seam.

The fine one (speckle and short fibres) is laid at the picture's own pixels, whatever its zoom; the clouds belong to the
scroll. The lengths of their copies have no common measure within a window, so that no repeat is seen.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from tambour.core.check import Array
from tambour.core.drawing import Placed
from tambour.core.picture import Picture
from tambour.noise import stream

SIDE = 512
"""Pixels of one copy."""
CLOUDS = 1531.0
"""Scroll units that one copy of the clouds covers."""
NARROWEST = 24.0
"""Scroll units that one copy of the speckle covers at least."""


def glazes(origin: Array, size: Array, pixels: int, mirror: bool = False) -> tuple[Placed, ...]:
    """The glazes over a window at ``origin``, ``size`` (2,) units large, for pictures ``pixels`` wide; or the mirrored one."""
    (x, y), (width, height) = origin.tolist(), size.tolist()
    if mirror:
        return (Placed(_mirrored(), x, y, width, height, (2.0 * SIDE, 2.0 * SIDE), glaze=True),)
    fine = max(NARROWEST, SIDE * width / pixels)
    return tuple(
        Placed(picture, x, y, width, height, (side, side), glaze=True)
        for picture, side in ((_clouds(), CLOUDS), (_speckle(), fine))
    )


@lru_cache(maxsize=1)
def _speckle() -> Picture:
    """A square Picture of black whose opacity is the paper's grain: speckle and short fibres, on a torus.

    The original's paper is 245 + 10 noise - 20 chance of white, in one tone (dossier 1.13); a scalar factor is the same
    as black laid over with opacity 1 - factor.
    """
    chance = stream("paper")
    fibre = np.zeros((SIDE, SIDE))
    for _ in range(700):
        x, y, turn, bow = chance.random(4) * (SIDE, SIDE, np.pi, 0.06)
        t = np.arange(int(12 + 40 * chance.random()))
        angle = turn + bow * t
        i = np.round(y + np.cumsum(np.sin(angle))).astype(int) % SIDE
        j = np.round(x + np.cumsum(np.cos(angle))).astype(int) % SIDE
        fibre[i, j] += 1.0 if chance.random() < 0.5 else -1.0
    soft = _blur(chance.random((SIDE, SIDE)), 3)
    dark = 12.0 * chance.random((SIDE, SIDE)) + 5.0 * (soft - 0.5) + 3.5 * np.clip(_blur(fibre, 1) * 3, -1, 1)
    return _black(dark, 2)


@lru_cache(maxsize=1)
def _clouds() -> Picture:
    """A square Picture of black whose opacity drifts slowly: where the pulp lay thicker, on a torus."""
    chance = stream("paper", "clouds")
    cloud = np.zeros((SIDE, SIDE))
    for scale, weight in ((3, 0.25), (9, 0.45), (30, 0.3)):
        cloud += weight * _blur(chance.random((SIDE, SIDE)), scale)
    return _black(10.5 - 11.0 * cloud, 1)


@lru_cache(maxsize=1)
def _mirrored() -> Picture:
    """The original's kind of sheet, a unit of the scroll to a pixel: grain and slow clouds on a square that knows nothing
    of a torus, and beside and below it itself, mirrored (1.13: 245 + 10 noise - 20 chance)."""
    chance = stream("paper", "mirrored")
    cloud = sum(w * _blur(chance.random((SIDE, SIDE)), s) for s, w in ((2, 0.15), (6, 0.25), (20, 0.6)))
    quarter = _black(10.0 - 10.0 * np.asarray(cloud) + 20.0 * chance.random((SIDE, SIDE)), 2).rgba
    half = np.concatenate([quarter, quarter[:, ::-1]], axis=1)
    return Picture(np.concatenate([half, half[::-1]]))


def _black(dark: Array, step: int) -> Picture:
    """Black of opacity ``dark`` (0…255), in steps that keep files small."""
    rgba = np.zeros((*dark.shape, 4), np.uint8)
    rgba[..., 3] = np.clip(np.round(dark / step) * step, 0, 60)
    return Picture(rgba)


def _blur(field: Array, scale: int) -> Array:
    """Smoothed on the torus by a Gaussian ``scale`` pixels wide, stretched to 0…1 for positive fields."""
    wave = np.fft.fftfreq(SIDE)[:, None] ** 2 + np.fft.rfftfreq(SIDE)[None, :] ** 2
    soft = np.fft.irfft2(np.fft.rfft2(field) * np.exp(-2 * np.pi**2 * scale**2 * wave), s=field.shape)
    return soft if field.min() < 0 else (soft - soft.min()) / (soft.max() - soft.min())

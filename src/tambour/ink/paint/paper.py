"""Paper: a warm fibrous sheet, as a glaze that darkens what lies under it, and repeats without a seam."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from tambour.core.check import Array
from tambour.core.picture import Picture
from tambour.noise import stream

SIDE = 512
"""Pixels, and scroll units, of one copy."""


@lru_cache(maxsize=1)
def grain() -> Picture:
    """A square Picture of black whose opacity is the paper's grain: speckle, clouds and short fibres, all on a torus.

    The original's paper is 245 + 10 noise - 20 chance of white, in one tone (dossier 1.13); a scalar factor is the same
    as black laid over with opacity 1 - factor.
    """
    chance = stream("paper")
    grain_ = chance.random((SIDE, SIDE))
    cloud = np.zeros((SIDE, SIDE))
    for scale, weight in ((4, 0.6), (16, 0.25), (64, 0.15)):
        cloud += weight * _blur(chance.random((SIDE, SIDE)), scale)
    fibre = np.zeros((SIDE, SIDE))
    for _ in range(700):
        x, y, turn, bow = chance.random(4) * (SIDE, SIDE, np.pi, 0.06)
        t = np.arange(int(12 + 40 * chance.random()))
        angle = turn + bow * t
        i = np.round(y + np.cumsum(np.sin(angle))).astype(int) % SIDE
        j = np.round(x + np.cumsum(np.cos(angle))).astype(int) % SIDE
        fibre[i, j] += 1.0 if chance.random() < 0.5 else -1.0
    dark = 7.5 + 19.0 * grain_ - 12.0 * cloud + 3.5 * np.clip(_blur(fibre, 1) * 3, -1, 1)
    rgba = np.zeros((SIDE, SIDE, 4), np.uint8)
    rgba[..., 3] = np.clip(np.round(dark / 3) * 3, 0, 60)
    return Picture(rgba)


def _blur(field: Array, scale: int) -> Array:
    """Smoothed on the torus by a Gaussian ``scale`` pixels wide, stretched to 0…1 for positive fields."""
    wave = np.fft.fftfreq(SIDE)[:, None] ** 2 + np.fft.rfftfreq(SIDE)[None, :] ** 2
    soft = np.fft.irfft2(np.fft.rfft2(field) * np.exp(-2 * np.pi**2 * scale**2 * wave), s=field.shape)
    return soft if field.min() < 0 else (soft - soft.min()) / (soft.max() - soft.min())

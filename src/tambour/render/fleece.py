"""Fleece: what makes a strand look spun: the fibres along its surface, and how its dye wanders."""

from __future__ import annotations

from functools import cache
from typing import Final

import numpy as np

from tambour.core.check import Array
from tambour.noise import stream

AROUND: Final = 96
"""Texels of the fibres' tile around a strand, and along one turn of its twist."""
WISPS: Final = ((0.8, 0, 14), (1.0, 1, 20), (0.9, 4, 30))
"""How strongly single fibres and wisps of them show, how many texels wide they are to either side, and how long."""
TONES: Final = 1024
"""Rows of the table of tones."""


@cache
def fibres() -> Array:
    """(N, N, 3): height of the fibres on a strand, mean 0, spread 1, and its slopes along v (around) and u (along).

    Rows run around the strand, columns along a turn of its twist; both wrap. Fibres are a texel or two wide and a quarter
    of a turn long; they lie in wisps of a few and of many.
    """
    height = np.zeros((AROUND, AROUND))
    for number, (share, wide, long) in enumerate(WISPS):
        height += share * _even(_blurred(stream("fleece", 5, number).random((AROUND, AROUND)), wide, long))
    height = _even(height)
    around = 0.5 * AROUND * (np.roll(height, -1, 0) - np.roll(height, 1, 0))
    along = 0.5 * AROUND * (np.roll(height, -1, 1) - np.roll(height, 1, 1))
    return np.ascontiguousarray(np.stack([height, around, along], axis=2))


@cache
def tones() -> Array:
    """(N, 3): how light yarn is along its way, a row for every other turn of its twist, as shares of each colour's light."""
    rough = stream("fleece", 3)
    light, warm = (
        _even(sum((_blurred(rough.random((1, TONES)), 0, far) for far in wide), np.zeros((1, TONES))))[0]
        for wide in ((1, 6), (4,))
    )
    return np.ascontiguousarray(1.0 + 0.05 * light[:, None] + 0.015 * warm[:, None] * np.array([1.0, 0.0, -1.0]))


def _blurred(field: Array, rows: int, columns: int) -> Array:
    """A field that wraps, averaged over so many texels to either side, twice: no sharp ends."""
    for _ in range(2):
        for axis, far in ((0, rows), (1, columns)):
            total = field.copy()
            for k in range(1, far + 1):
                total = total + np.roll(field, k, axis) + np.roll(field, -k, axis)
            field = total / (2 * far + 1)
    return field


def _even(field: Array) -> Array:
    """A field with mean 0 and spread 1."""
    field = field - field.mean()
    return np.asarray(field / max(float(np.sqrt((field * field).mean())), 1e-12))

"""Fleece: what makes a strand look spun: the fibres along its surface, and how its dye wanders."""

from __future__ import annotations

from functools import cache
from typing import Final

import numpy as np

from tambour.core.check import Array
from tambour.noise import stream

AROUND: Final = 256
"""Texels of the fibres' tile around a strand, and along one turn of its twist."""
FIBRES: Final = 3200
"""Fibres that lie in the tile, one over the other."""
SLANT: Final = (0.2, 0.36)
"""How far fibres lie across the strand's way, in radians: spread of single ones, and how much each turns along its length."""
LONG: Final = (30.0, 110.0)
"""How long fibres are, in texels: the shortest and the longest."""
WISPS: Final = ((0.5, 2, 12), (0.32, 5, 30))
"""How strongly wisps of fibres show, beside single ones, how many texels wide they are to either side, and how long."""
TONES: Final = 1024
"""Rows of the table of tones."""


@cache
def fibres() -> Array:
    """(N, N, 3): height of the fibres on a strand, mean 0, spread 1, and its slopes along v (around) and u (along).

    Rows run around the strand, columns along a turn of its twist; both wrap. Fibres are two texels wide; they cross and bow, none
    as long as the tile: combed ones would look like straw.
    """
    rough = stream("fleece", 5)
    where = rough.random((2, FIBRES)) * AROUND
    slant, bow = rough.standard_normal(FIBRES) * SLANT[0], rough.uniform(-1.0, 1.0, FIBRES) * SLANT[1]
    long = LONG[0] + (LONG[1] - LONG[0]) * rough.random(FIBRES) ** 2
    at = np.arange(-0.5, 0.5, 1.0 / LONG[1])
    along = at * long[:, None]
    across = along * np.tan(slant)[:, None] + bow[:, None] * long[:, None] * (at * at - 0.08)
    # What was drawn last lies on top, highest in the middle of its length: its ends dive.
    lies = rough.uniform(-1.0, 1.0, FIBRES)[:, None] + 0.8 * (1.0 - 8.0 * at**4)
    row, column = np.floor(where[0][:, None] + across).astype(int), np.floor(where[1][:, None] + along).astype(int)
    single = np.zeros((AROUND, AROUND))
    for beside, low in ((1, 0.5), (0, 0.0)):
        single[(row + beside) % AROUND, column % AROUND] = lies - low
    height = _even(_blurred(single, 1, 1))
    for number, (share, wide, far) in enumerate(WISPS):
        height += share * _even(_blurred(stream("fleece", 5, number).random((AROUND, AROUND)), wide, far))
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

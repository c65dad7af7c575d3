"""Fleece: what makes a strand look spun: the fibres along its surface, and how far single samples stray over its edge."""

from __future__ import annotations

from functools import cache
from typing import Final

import numpy as np

from tambour.core.check import Array
from tambour.noise import stream

AROUND: Final = 96
"""Texels of the fibres' tile around a strand, and along one turn of its twist."""
STRAY: Final = 128
"""Samples along the side of the table of strays."""


@cache
def fibres() -> Array:
    """(N, N, 3): height of the fibres on a strand, mean 0, spread 1, and its slopes along v (around) and u (along).

    Rows run around the strand, columns along a turn of its twist; both wrap. Fibres are a texel or two wide and a quarter
    of a turn long; weaker and broader clumps lie under them.
    """
    fine, broad = stream("fleece", 1).random((AROUND, AROUND)), stream("fleece", 2).random((AROUND, AROUND))
    height = _even(_blurred(fine, 1, 24)) + 0.6 * _even(_blurred(broad, 8, 40))
    height = _even(height)
    around = 0.5 * AROUND * (np.roll(height, -1, 0) - np.roll(height, 1, 0))
    along = 0.5 * AROUND * (np.roll(height, -1, 1) - np.roll(height, 1, 1))
    return np.ascontiguousarray(np.stack([height, around, along], axis=2))


@cache
def strays() -> Array:
    """(S, S, 2): how far samples stray, mean 0, within a circle of radius 1; neighbours stray together, as fibres do."""
    rough = stream("fleece", 3).random((2, STRAY, STRAY))
    way = np.stack([_even(_blurred(each, 2, 2)) + 1.2 * _even(each) for each in rough], axis=2)
    way /= 1.6
    size = np.sqrt((way * way).sum(2, keepdims=True))
    return np.ascontiguousarray(way / np.maximum(1.0, size))


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

"""Codes: constants for kernels.

A plain whole number is a type of its own to Numba, and a kernel is compiled once more for every one that it is called
with; a NumPy number is not.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from tambour.ink.ground.kinds import NAMES


def numbers(count: int) -> Any:
    """0 … count - 1, to be unpacked into names."""
    return np.arange(count)


(
    HILL, BANK, RANGE, ROCK, WATER, WATERFALL, MIST, BIRDS, MOON, SUN, SKY,
    JUNIPER, SAPLING, FIR, PINE, CEDAR, PLUM, BUSH, REED,
    HUT, HOUSE, PAGODA, PAVILION, PYLON, BOAT, FIGURE,
    BRANCH, TWIG, BARK, COPSE, STAMP, HAMLET, BRIDGE, WILLOW,
) = numbers(len(NAMES))  # fmt: skip

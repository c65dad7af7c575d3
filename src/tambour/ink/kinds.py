"""Kinds: the names of everything that is drawn."""

from __future__ import annotations

NAMES = (
    "hill", "bank", "range", "rock", "water", "waterfall", "mist", "birds", "moon", "sun",
    "juniper", "sapling", "fir", "pine", "cedar", "plum", "bush", "reed",
    "hut", "house", "pagoda", "pavilion", "pylon", "boat", "figure",
    "branch", "twig", "bark", "copse",
)  # fmt: skip
(
    HILL, BANK, RANGE, ROCK, WATER, WATERFALL, MIST, BIRDS, MOON, SUN,
    JUNIPER, SAPLING, FIR, PINE, CEDAR, PLUM, BUSH, REED,
    HUT, HOUSE, PAGODA, PAVILION, PYLON, BOAT, FIGURE,
    BRANCH, TWIG, BARK, COPSE,
) = range(len(NAMES))  # fmt: skip

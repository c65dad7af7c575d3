"""Kinds: the names of everything that is drawn."""

from __future__ import annotations

NAMES = (
    "hill", "bank", "range", "rock", "water", "waterfall", "mist", "birds", "moon", "sun", "sky",
    "juniper", "sapling", "fir", "pine", "cedar", "plum", "bush", "reed",
    "hut", "house", "pagoda", "pavilion", "pylon", "boat", "figure",
    "branch", "twig", "bark", "copse", "seal",
)  # fmt: skip
(
    HILL, BANK, RANGE, ROCK, WATER, WATERFALL, MIST, BIRDS, MOON, SUN, SKY,
    JUNIPER, SAPLING, FIR, PINE, CEDAR, PLUM, BUSH, REED,
    HUT, HOUSE, PAGODA, PAVILION, PYLON, BOAT, FIGURE,
    BRANCH, TWIG, BARK, COPSE, STAMP,
) = range(len(NAMES))  # fmt: skip

SPECIMENS = ("all", *(name for name in NAMES if name not in ("sky", "seal")))
"""What ``--specimen`` knows."""

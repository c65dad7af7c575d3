"""Kinds: the names of everything that is drawn."""

from __future__ import annotations

NAMES = (
    "hill", "bank", "range", "rock", "water", "waterfall", "mist", "birds", "moon", "sun", "sky",
    "juniper", "sapling", "fir", "pine", "cedar", "plum", "bush", "reed",
    "hut", "house", "pagoda", "pavilion", "pylon", "boat", "figure",
    "branch", "twig", "bark", "copse", "seal", "hamlet", "bridge", "willow",
)  # fmt: skip
SPECIMENS = ("all", *(name for name in NAMES if name not in ("sky", "seal")))
"""What ``--specimen`` knows."""

"""Machines: the largest field, the needles and the files of machines that people have, as commonly given for them.

A figure that matters is better read off one's own manual: hoops are sold separately, and models of one name differ by country.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Machine:
    """A machine: its largest field in mm (width, height as the hoop is put on), its needles, and the suffixes it reads."""

    field: tuple[float, float]
    needles: int
    reads: tuple[str, ...]


_BROTHER, _JANOME = ("pes", "dst"), ("jef", "dst")
MACHINES: dict[str, Machine] = {
    "brother-pe535": Machine((100, 100), 1, _BROTHER),
    "brother-se600": Machine((100, 100), 1, _BROTHER),
    "brother-pe770": Machine((130, 180), 1, _BROTHER),
    "brother-pe800": Machine((130, 180), 1, _BROTHER),
    "brother-se1900": Machine((130, 180), 1, _BROTHER),
    "brother-nq3600d": Machine((160, 260), 1, _BROTHER),
    "brother-pr680w": Machine((300, 200), 6, _BROTHER),
    "brother-pr1055x": Machine((360, 200), 10, _BROTHER),
    "janome-mc400e": Machine((200, 200), 1, _JANOME),
    "janome-mc500e": Machine((200, 280), 1, _JANOME),
    "janome-mc550e": Machine((200, 360), 1, _JANOME),
}

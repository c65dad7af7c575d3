"""Machines: the largest field, the needles and the files of machines that people have, each with what says so.

A figure that matters is better read off one's own manual: hoops are sold separately, and models of one name differ by country.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Machine:
    """A machine: its largest field in mm (width, height as the hoop is put on), its needles, the suffixes it reads, and where
    its field is from: the maker's manual or page, a list of its hoops, or lists in programs."""

    field: tuple[float, float]
    needles: int
    reads: tuple[str, ...]
    source: str


_BROTHER, _JANOME = ("pes", "dst"), ("jef", "dst")
MACHINES: dict[str, Machine] = {
    "brother-pe535": Machine((100, 100), 1, _BROTHER, "a list of machines: 4 x 4 in, Brother's hoop of 100 x 100 mm"),
    "brother-se600": Machine(
        (100, 100), 1, _BROTHER, "lists of machines in two programs: 4 x 4 in, Brother's hoop of 100 x 100 mm"
    ),
    "brother-pe770": Machine((130, 180), 1, _BROTHER, "a list of machines: 13 x 18 cm"),
    "brother-pe800": Machine((130, 180), 1, _BROTHER, "lists of machines in four programs"),
    "brother-se1900": Machine((130, 180), 1, _BROTHER, "a list of machines: 5 x 7 in, Brother's hoop of 130 x 180 mm"),
    "brother-pr680w": Machine((300, 200), 6, _BROTHER, "the maker's page"),
    "brother-pr1055x": Machine((360, 200), 10, (*_BROTHER, "phc"), "the maker's manual"),
    "janome-mc400e": Machine((200, 200), 1, _JANOME, "a list of machines: 7.9 x 7.9 in"),
    "janome-mc500e": Machine((200, 280), 1, _JANOME, "its hoop RE28b"),
    "janome-mc550e": Machine((200, 360), 1, _JANOME, "a list of its hoops"),
    "janome-mb7": Machine((238, 200), 7, _JANOME, "the maker's page"),
    "ricoma-em1010": Machine((309, 210), 10, ("dst",), "the maker's page: 12.2 x 8.3 in"),
    "tajima-tmez-sc": Machine((500, 360), 15, ("dst",), "the maker's page"),
}

"""Weights: the classes of yarn, and what each is usually worked at, in knitting and in crochet."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final


@dataclass(frozen=True, slots=True)
class Weight:
    """A class of yarn.

    number : in the Craft Yarn Council's system; name : as it is written in a sentence
    knit : stitches and rows in 10 cm of stranded stocking stitch
    single : single crochets in 4 in, the middle of the range; hook : mm, the middle of the range (lace: hands' usual)
    amigurumi : mm, the hook for toys, several sizes smaller, so that no stuffing shows
    metres : in 100 g, typically; skein : grams, typically

    >>> WEIGHTS["dk"].knit
    (22.0, 30.0)
    """

    number: int
    name: str
    knit: tuple[float, float]
    single: float
    hook: float
    amigurumi: float
    metres: float
    skein: float


WEIGHTS: Final[dict[str, Weight]] = {
    "lace": Weight(0, "lace", (33.0, 42.0), 37.0, 1.9, 1.5, 800.0, 50.0),
    "fingering": Weight(1, "fingering", (29.0, 36.0), 26.5, 2.9, 2.0, 400.0, 50.0),
    "sport": Weight(2, "sport", (25.0, 32.0), 18.0, 4.0, 2.5, 300.0, 50.0),
    "dk": Weight(3, "DK", (22.0, 30.0), 14.5, 5.0, 2.75, 225.0, 50.0),
    "worsted": Weight(4, "worsted", (19.0, 26.0), 12.5, 6.0, 3.5, 190.0, 100.0),
    "aran": Weight(4, "aran", (17.0, 23.0), 12.5, 6.0, 3.5, 165.0, 100.0),
    "bulky": Weight(5, "bulky", (14.0, 19.0), 9.5, 7.75, 5.0, 110.0, 100.0),
    "super-bulky": Weight(6, "super bulky", (9.0, 13.0), 7.5, 12.0, 8.0, 65.0, 100.0),
    "jumbo": Weight(7, "jumbo", (6.0, 8.5), 5.0, 16.0, 12.0, 40.0, 200.0),
}
"""Stitches and hooks are the middles of the Craft Yarn Council's ranges (Standard Yarn Weight System); rows, hooks for
toys and metres are what bands and patterns usually say. Aran is the Council's class 4 as worsted is, and a little thicker."""

"""Font: typefaces for crafts that set letters: a font file's bytes, or letters that were drawn one by one."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from tambour.core.drawing import Drawing


@dataclass(frozen=True, slots=True)
class Font:
    """A TrueType or OpenType file's content, and the name it is known by."""

    data: bytes
    name: str = "font"


@dataclass(frozen=True, eq=False, slots=True)
class Alphabet:
    """Letters drawn for thread, as Ink/Stitch's fonts are.

    letters : name (one character, or several for a ligature) → its Drawing in mm, baseline at y 0, the pen at x 0
    advance : name → mm from this pen to the next; ``usual`` where it is not said, ``space`` for a space
    kerning : two names parted by a space → mm that the second stands nearer
    capital, leading : mm, height of a capital and from baseline to baseline
    scales : (least, most) times its own size at which it was made to be sewn
    """

    letters: Mapping[str, Drawing]
    advance: Mapping[str, float]
    usual: float | None
    space: float
    kerning: Mapping[str, float]
    capital: float
    leading: float
    scales: tuple[float, float] = (0.0, float("inf"))
    name: str = "font"

"""Fibres: what a yarn is made of: how full it is, how many plies it has, and which surface a picture gives it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final


@dataclass(frozen=True, slots=True)
class Fibre:
    """A kind of yarn.

    surface : the name of its faces' group, which tells the renderer of plies, sheen and hairs
    full : radius drawn, as a share of wool's; plies : twisted together, 0 for none to be seen
    """

    surface: str
    full: float
    plies: int


KINDS: Final[dict[str, Fibre]] = {
    "wool": Fibre("yarn", 1.0, 4),
    "cotton": Fibre("cotton", 0.94, 4),
    "acrylic": Fibre("acrylic", 1.0, 4),
    "chenille": Fibre("chenille", 1.28, 0),
    "mohair": Fibre("mohair", 0.85, 0),
}
"""Materials by name, as one sees them: wool, softly plied; mercerised cotton, smooth and a little shiny; acrylic; chenille,
a thick pile without plies; mohair, a thin core in long hair."""

"""Font: the bytes of a typeface, for crafts that set letters."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Font:
    """A TrueType or OpenType file's content, and the name it is known by."""

    data: bytes
    name: str = "font"

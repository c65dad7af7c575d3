"""Typefaces, read."""

from __future__ import annotations

from pathlib import Path

from tambour.core.errors import TambourError
from tambour.core.font import Font

_STARTS = (b"\x00\x01\x00\x00", b"OTTO", b"true", b"ttcf")
LARGEST = 100_000_000


def read_font(path: Path) -> Font:
    """A .ttf, .otf or .ttc file (of a collection the first face); TambourError when it is none."""
    from tambour.geometry.glyphs import capital_height

    if path.stat().st_size > LARGEST:
        raise TambourError("a font of more than 100 MB is not read", where=str(path))
    data = path.read_bytes()
    if data[:4] not in _STARTS:
        raise TambourError("this is not a TrueType or OpenType font", where=str(path))
    try:
        capital_height(data)
    except TambourError as error:
        raise TambourError(error.problems[0].message, where=str(path)) from None
    return Font(data, path.stem)

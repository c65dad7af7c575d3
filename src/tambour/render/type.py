"""Type: the one typeface that ships with Tambour (Inter, OFL), so that no picture depends on a machine's fonts."""

from __future__ import annotations

from functools import cache
from importlib.resources import files
from typing import Any


def font_bytes(bold: bool = False) -> bytes:
    """The OpenType file of the shipped typeface."""
    return (files("tambour.render") / "fonts" / f"Inter-{'Bold' if bold else 'Regular'}.otf").read_bytes()


@cache
def typeface(bold: bool = False) -> Any:
    """The shipped face as a skia Typeface."""
    import skia

    # An empty font manager: the system's would be asked for its fonts, and complain about its settings.
    return skia.FontMgr.New_Custom_Empty().makeFromData(skia.Data.MakeWithCopy(font_bytes(bold)))


def text_width(text: str, size: float, bold: bool = False) -> float:
    """Advance width of a line of text at font size ``size``, in the same unit."""
    import skia

    return float(skia.Font(typeface(bold), 100).measureText(text)) * size / 100

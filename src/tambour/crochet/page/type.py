"""Type: the sizes and colours of the booklet, and lines of type measured before they are set."""

from __future__ import annotations

import re
from functools import lru_cache

from tambour.core.rgb import RGB
from tambour.render.type import text_width, typeface

INK: RGB = (38, 35, 33)
SOFT: RGB = (86, 80, 75)
HAIR: RGB = (214, 208, 200)
PAPER: RGB = (241, 240, 238)
"""As the rasteriser shows :data:`BACKDROP`: its film rolls off what is bright."""
BACKDROP: RGB = (248, 245, 240)

# The type scale, mm: each step is a fourth or a third above the one before.
SMALL, BODY, LEAD, HEAD, COVER = 2.7, 3.3, 3.9, 5.4, 12.5
LEADING = 1.45

_GLUED = re.compile(r"(?<=\d) (?=(?:mm|cm|m|g|l|in|yd)\b)|(?<=\w) (?=[;:!?»])|(?<=«) ")


_LIGATURES = str.maketrans({"ﬀ": "ff", "ﬁ": "fi", "ﬂ": "fl", "ﬃ": "ffi", "ﬄ": "ffl", "ﬅ": "st", "ﬆ": "st"})
"""Letters that files of others join to one sign, which few fonts have."""


@lru_cache(maxsize=20_000)
def width_of(text: str, size: float, bold: bool = False) -> float:
    """Width of a line of text, mm."""
    return text_width(text, size, bold)


def printable(text: str) -> str:
    """The text without signs that the typeface has no letter for, and the gaps that they would leave."""
    if text.isascii():
        return text
    glyphs = typeface(False).unicharsToGlyphs([ord(c) for c in text])
    kept = "".join(c for c, glyph in zip(text, glyphs) if glyph or c.isspace())
    return kept if kept == text else re.sub(r" {2,}", " ", kept).strip()


def wrap(text: str, size: float, room: float, bold: bool = False) -> list[str]:
    """Lines of at most ``room`` mm; words that are longer are cut."""
    lines: list[str] = []
    line = ""
    # A number stays with its unit, a mark with the word before it.
    glued = _GLUED.sub("\u00a0", " ".join(printable(text.translate(_LIGATURES)).split()))
    for word in glued.split(" ") if glued else []:
        trial = f"{line} {word}" if line else word
        if width_of(trial, size, bold) <= room:
            line = trial
            continue
        if line:
            lines.append(line)
        while width_of(word, size, bold) > room and len(word) > 1:
            fits = next(k for k in range(len(word) - 1, 0, -1) if k == 1 or width_of(word[:k], size, bold) <= room)
            lines.append(word[:fits])
            word = word[fits:]
        line = word
    if line:
        lines.append(line)
    return [line.replace("\u00a0", " ") for line in lines]

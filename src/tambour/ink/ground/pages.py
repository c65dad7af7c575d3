"""Pages: how a plotter's sheets, and the heights of its pen, are told."""

from __future__ import annotations

import re

from tambour.core.params import length
from tambour.render.page import PAPERS

_SIZE = re.compile(r"\s*([\d.]+)\s*[x×*]\s*([\d.]+)\s*(mm|cm|in)?\s*")
_RANGE = re.compile(r"\s*(-?\d+)\s*(?:\.\.\s*(-?\d+)\s*)?")


def page(text: str) -> tuple[float, float]:
    """Width and height in mm, the longer first, of ``a4`` or ``300x200mm``; ValueError for what is neither."""
    known = PAPERS.get(text.strip().lower())
    if known:
        return known[1], known[0]
    found = _SIZE.fullmatch(text.lower())
    if not found:
        raise ValueError(f'there is no page "{text}"; there are {", ".join(PAPERS)}, or a size such as 300x200mm')
    unit = found[3] or "mm"
    a, b = (float(length(f"{found[k]}{unit}")) for k in (1, 2))
    if not 10 <= min(a, b) <= max(a, b) <= 5000:
        raise ValueError(f'a page of "{text}" is not between 10 mm and 5 m')
    return max(a, b), min(a, b)


def sheets(text: str) -> tuple[int, int]:
    """First and last number of ``0..9`` or ``3``; ValueError for what is neither, or more than 500."""
    found = _RANGE.fullmatch(text)
    if not found:
        raise ValueError(f'"{text}" does not number sheets; write 0..9, or 3')
    first = int(found[1])
    last = int(found[2]) if found[2] else first
    if not first <= last < first + 500:
        raise ValueError(f'"{text}": the first sheet comes first, and at most 500 are made at once')
    return first, last


def heights(text: str) -> tuple[float, float]:
    """Per cent at which the pen touches and at which it is pressed all the way, of ``50..30``; ValueError for what is neither."""
    found = _RANGE.fullmatch(text)
    if not found or not found[2]:
        raise ValueError(f'"{text}" is no pair of heights; write 50..30')
    touching, pressed = int(found[1]), int(found[2])
    if not 0 <= pressed <= touching <= 100:
        raise ValueError(f'"{text}": heights are per cent of the way up, and the pressed pen is the lower')
    return float(touching), float(pressed)

"""Printed patterns, leaves: what stands at the head and the foot of each page of a print ("BUNNY  2 of 3", "Page 2 of 4") is no line of the
text, so that a sentence goes on over it."""

from __future__ import annotations

import re
from typing import Final

from tambour.crochet.printed.tokens import Row

_FOOT: Final = re.compile(
    r"[ \t]*(?:(?P<title>\S.{0,80}?)[ \t|·•–—-]+)?(?:page[ \t]*)?(?P<page>\d{1,3})[ \t]*(?:of|/)[ \t]*(?P<pages>\d{1,3})[ \t]*$",
    re.IGNORECASE,
)
_GOES_ON: Final = ("*", "(", "[", "{")


def leaves(text: str, rows: list[Row]) -> list[Row]:
    """``rows`` without feet of pages, where a sentence goes on behind one; others stay, as they part what they stand between."""
    feet = [k for k, row in enumerate(rows) if row.tokens and is_foot(text[row.start : row.end])]
    made: list[Row] = []
    at = 0
    for foot in feet:
        before, after = foot - 1, foot + 1
        while before >= at and not rows[before].tokens:
            before -= 1
        while after < len(rows) and not rows[after].tokens:
            after += 1
        if before < at or after >= len(rows) or foot < at:
            continue
        first = rows[after].tokens[0]
        open_ended = rows[before].tokens[-1].word not in (".", "!", "?", ":")
        if first.word in _GOES_ON or (open_ended and not first.capital):
            made += rows[at : before + 1]
            at = after
    return [*made, *rows[at:]]


def is_foot(line: str) -> bool:
    """Whether a line is the foot of a page."""
    found = _FOOT.match(line) if len(line) <= 120 else None
    if found is None or not 0 < int(found["page"]) <= int(found["pages"]):
        return False
    if found["title"] is not None and not any(c.isalpha() for c in found["title"]):
        return False  # "6 / 12 / 12 / 12": the stitches of rounds
    return found["title"] is None or not any(c in found["title"] for c in ".:;") or "page" in line.lower()

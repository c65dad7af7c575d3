"""Printed patterns, leaves: what stands at the head and the foot of each page of a print ("BUNNY  2 of 3", "Page 2 of 4") is no line of the
text, so that a sentence goes on over it."""

from __future__ import annotations

import re
from collections import Counter
from typing import Final

from tambour.crochet.printed.tokens import Row

_FOOT: Final = re.compile(
    r"[ \t]*(?:(?P<title>\S.{0,80}?)[ \t|·•–—-]+)?(?:page[ \t]*)?(?P<page>\d{1,3})[ \t]*(?:of|/)[ \t]*(?P<pages>\d{1,3})[ \t]*$",
    re.IGNORECASE,
)
_LONGEST: Final = 120
_RUNNING: Final = re.compile(
    r"(?:(?<![.!?:])[ \t]|^)page[ \t]*(\d{1,3})(?:[ \t]*(?:of|/)[ \t]*\d{1,3})?[ \t]*[^\w\n]*$", re.IGNORECASE
)
_GOES_ON: Final = ("*", "(", "[", "{")


def leaves(text: str, rows: list[Row]) -> list[Row]:
    """``rows`` without feet of pages, where a sentence goes on behind one; others stay, as they part what they stand between."""
    rows = _unheaded(text, rows)
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


def _unheaded(text: str, rows: list[Row]) -> list[Row]:
    """``rows`` without heads and feet that say the same on every page but for its number: "-- Pip the mouse ------ page 2 --"."""
    said: dict[str, list[tuple[int, int]]] = {}
    for k, row in enumerate(rows):
        found = _RUNNING.search(text[row.start : row.end]) if row.tokens and row.end - row.start <= _LONGEST else None
        if found is not None:
            same = found.string[: found.start(1)] + found.string[found.end(1) :]
            said.setdefault(same.strip(), []).append((k, int(found[1])))
    running = {
        k
        for places in said.values()
        if len(places) > 1 and [n for _, n in places] == list(range(places[0][1], places[0][1] + len(places)))
        for k, _ in places
    }
    # The next page's head stands below: "Hazel Crochet      Rabbit", after every foot the same.
    below = {next((j for j in range(k + 1, len(rows)) if rows[j].tokens), k) for k in running} - running
    heads = {j: " ".join(text[rows[j].start : rows[j].end].split()) for j in below}
    often = Counter(heads.values())
    running |= {j for j, head in heads.items() if often[head] > max(1, len(running) // 2)}
    return [row for k, row in enumerate(rows) if k not in running] if running else rows


def is_foot(line: str) -> bool:
    """Whether a line is the foot of a page."""
    found = _FOOT.match(line) if len(line) <= _LONGEST else None
    if found is None or not 0 < int(found["page"]) <= int(found["pages"]):
        return False
    if found["title"] is not None and not any(c.isalpha() for c in found["title"]):
        return False  # "6 / 12 / 12 / 12": the stitches of rounds
    return found["title"] is None or not any(c in found["title"] for c in ".:;") or "page" in line.lower()

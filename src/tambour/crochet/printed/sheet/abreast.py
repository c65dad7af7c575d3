"""Printed patterns, abreast: parts that a leaflet sets side by side in columns of blanks, one below the other."""

from __future__ import annotations

import re
from collections import Counter
from typing import Final

from tambour.crochet.printed.tokens import Row, Token

_GAP: Final = 3  # blanks between two columns
_INDENT: Final = 3  # blanks by which the lines of a column differ
_LEAST: Final = 4  # lines that a second column has
_HEADS: Final = 2  # rounds that each column names
_HEAD: Final = re.compile(r"(?:(?:rnd|round|row|rd|r)s?\.? ?)?\d{1,3}(?: ?[-–] ?\d{1,3})?[.:)]\s+\S*\D", re.IGNORECASE)
"""How the line of a round begins, that is no count of a table: "3-4.  Sc around"."""
_TITLE: Final = re.compile(r"[A-Z]{3,}\b|US TERMS|UK TERMS")
"""How a list begins that stands beside the materials: "GAUGE: 20 sc", "US TERMS"."""


def abreast(text: str, rows: list[Row]) -> list[Row]:
    """``rows`` with the lines of the second column of a page behind those of the first."""
    made: list[Row] = []
    block: list[Row] = []
    for row in [*rows, Row([], len(text), len(text))]:
        if row.tokens:
            block.append(row)
            continue
        made += _apart(text, block)
        block = []
        made.append(row)
    return made[:-1]


def _apart(text: str, block: list[Row]) -> list[Row]:
    """The lines between two empty ones, those of each column together."""
    begins = Counter(at for row in block for at in _openings(text, row))
    wide = {at: sum(begins[k] for k in range(at, at + _INDENT)) for at in begins}
    for at, many in sorted(wide.items(), key=lambda one: (-one[1], one[0])):
        if many < _LEAST:
            break
        parted = [_cut(text, row, at) for row in block]
        if any(one is None for one in parted):
            continue
        columns = [[one[k] for one in parted if one is not None and one[k].tokens] for k in (0, 1)]
        rounds = [sum(_HEAD.match(text, row.start, row.end) is not None for row in some) >= _HEADS for some in columns]
        titles = sum(_TITLE.match(text, row.start, row.end) is not None for row in columns[1]) >= _HEADS
        if all(rounds) or (titles and not any(rounds)):
            return [*columns[0], Row([], columns[0][-1].end, columns[0][-1].end), *_joined(text, columns[1])]
    return block


def _joined(text: str, rows: list[Row]) -> list[Row]:
    """The lines of a narrow column with those together that its edge broke: "Sew a small white | pompom to the tip."."""
    made: list[Row] = []
    for row in rows:
        above = made[-1] if made else None
        small = text[row.start : row.start + 1].islower()
        if above is not None and small and text[above.end - 1 : above.end].isalpha():
            made[-1] = Row([*above.tokens, *row.tokens], above.start, row.end, above.marked)
        else:
            made.append(row)
    return made


def _line(text: str, row: Row) -> int:
    """Where the line of a row begins in the text."""
    return text.rfind("\n", 0, row.tokens[0].start) + 1


def _openings(text: str, row: Row) -> list[int]:
    """How far from the line's edge the words stand that blanks part from those before them."""
    begin = _line(text, row)
    found = []
    for before, token in zip([None, *row.tokens], row.tokens, strict=False):
        gap = text[before.end if before is not None else begin : token.start]
        if len(gap) >= _GAP and not gap.strip() and token.start > begin + _GAP:
            found.append(token.start - begin)
    return found


def _cut(text: str, row: Row, at: int) -> tuple[Row, Row] | None:
    """A line's words before and from ``at`` on; None where its words go on past that place."""
    place = _line(text, row) + at
    left, right = ([t for t in row.tokens if (t.start < place) == some] for some in (True, False))
    if right and (right[0].start >= place + _INDENT or (left and place - left[-1].end < _GAP - 1)):
        return None
    if left and left[-1].end > place:
        return None
    return _row(left, row), _row(right, row)


def _row(tokens: list[Token], row: Row) -> Row:
    return Row(tokens, tokens[0].start, tokens[-1].end, row.marked) if tokens else Row([], row.start, row.start)

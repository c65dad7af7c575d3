"""Printed patterns, points: rounds that stand as points of a list, whose numbers are not theirs, and heads of rounds in short words of their own:
"2. Row 1: …", "6   Round 5: …", "Rs2-5: …", "R8: sc around. Repeat through R11"."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Final

from tambour.crochet.printed.tokens import Row, Token


def unlisted(rows: list[Row]) -> list[Row]:
    """Rounds that stand as points of a list, "2. Row 1: …", without the numbers of the list."""
    made = []
    for row in rows:
        listed = (
            len(row.tokens) > _POINT
            and row.tokens[0].kind == "number"
            and row.tokens[1].word in (".", ")")
            and row.tokens[2].word in _ROUNDS
            and row.tokens[3].kind == "number"
            and not row.tokens[3].glued
            and not any(t.word in ("again", "repeat", "same") for t in row.tokens[4:9])
        )
        if listed:
            row = Row(row.tokens[2:], row.tokens[2].start, row.end, row.marked)
        elif _unpointed(row.tokens):
            row = Row(row.tokens[1:], row.tokens[1].start, row.end, row.marked)
        made.append(_through(_plural(row)))
    return made


def _unpointed(tokens: list[Token]) -> bool:
    """Whether a point of a list lacks its mark, "6     Round 5: …"."""
    return (
        len(tokens) > _POINT
        and tokens[0].kind == tokens[2].kind == "number"
        and tokens[1].word in _ROUNDS
        and tokens[1].capital
        and tokens[3].word == ":"
    )


def _plural(row: Row) -> Row:
    """``row`` with the rows that a short word heads, "Rs2-5: …", "Rs. 1-2: …", as they are usually called."""
    tokens = row.tokens
    if len(tokens) < _POINT or tokens[0].kind != "word" or not tokens[0].capital:
        return row
    first = tokens[0]
    if first.word == "rs":
        at = 1 + (tokens[1].word == ".")
        number = tokens[at] if tokens[at].kind == "number" else None
    elif first.word.startswith("rs") and first.word[2:].isdigit():
        at, digits = 0, first.word[2:]
        number = Token("number", digits, first.start + 2, first.end, int(digits), True)
    else:
        return row
    if number is None or [t.word for t in tokens[at + 1 : at + 2]] not in (["-"], ["&"]):
        return row
    rows = Token("word", "rows", first.start, first.start + 2, None, first.glued, True)
    return Row([rows, number, *tokens[at + 1 :]], row.start, row.end, row.marked)


def _through(row: Row) -> Row:
    """``row`` of one round that is said to go on up to another, "R8: sc around. Repeat through R11", as one of all those rounds."""
    tokens = row.tokens
    at = next((k for k in range(len(tokens) - 1, 0, -1) if tokens[k].word in ("through", "thru")), 0)
    if (
        at < _POINT
        or tokens[at - 1].word not in ("repeat", "rep")
        or tokens[at - 2].word not in (".", ",", ";", ")", "-")
    ):
        return row
    end = [t for t in tokens[at + 1 :] if t.word != "."]
    named = re.fullmatch(r"(?:rounds?|rnds?|rows?|r)? ?(\d+)", " ".join(t.word for t in end))
    head = re.match(r"(?:round|rnd|row|r) ?(\d+) :", " ".join(t.word for t in tokens[:3]))
    if named is None or head is None or int(named[1]) <= int(head[1]):
        return row
    colon = next(k for k, t in enumerate(tokens) if t.word == ":")
    last, first = end[-1], tokens[0]
    dash = Token("mark", "-", tokens[colon].start, tokens[colon].start, None, True)
    until = Token("number", named[1], tokens[colon].start, tokens[colon].start, int(named[1]), True)
    begun = [replace(first, word="rounds"), Token("number", head[1], first.end, first.end, int(head[1]))]
    kept = tokens[colon : at - 1]
    while kept[-1].word in (",", ";", "-"):
        kept = kept[:-1]
    return Row([*begun, dash, until, *kept], row.start, max(row.end, last.end), row.marked)


_POINT: Final = 4  # words and signs of a point of a list that is a round, at least
_ROUNDS: Final = frozenset("round rounds rnd rnds row rows".split())

"""Printed patterns, points: rounds that stand as points of a list, whose numbers are not theirs, and heads of rounds in short words of their own:
"2. Row 1: …", "6   Round 5: …", "Rs2-5: …", "R8: sc around. Repeat through R11"."""

from __future__ import annotations

import re
from dataclasses import replace
from itertools import pairwise
from typing import Final

from tambour.crochet.printed.tokens import Row, Token


def unlisted(rows: list[Row]) -> list[Row]:
    """Rounds that stand as points of a list, "2. Row 1: …", without the numbers of the list."""
    made = []
    for row in _lettered(_undashed(_signed(rows))):
        listed = (
            len(row.tokens) > _POINT
            and row.tokens[0].kind == "number"
            and row.tokens[1].word in (".", ")")
            and row.tokens[2].word in _ROUNDS
            and row.tokens[3].kind == "number"
            and not row.tokens[3].glued
            and not any(t.word in ("again", "repeat", "same") for t in row.tokens[4:9])
        )
        if listed or _short(row.tokens) or _explains(row.tokens):
            row = Row(row.tokens[2:], row.tokens[2].start, row.end, row.marked)
        elif _unpointed(row.tokens):
            row = Row(row.tokens[1:], row.tokens[1].start, row.end, row.marked)
        made.append(_through(_plural(_plain_first(row))))
    return made


def _signed(rows: list[Row]) -> list[Row]:
    """``rows`` with a colon behind heads that have no sign, where several follow each other: "1 row 6 sc in ring", "2 rnd inc*6 (12)"."""
    found = {k: end for k, row in enumerate(rows) if (end := _signless(row.tokens))}
    if len(found) < _SIGNLESS:
        return rows
    spans = [(rows[k].tokens[0].value, rows[k].tokens[2 if rows[k].tokens[1].word == "-" else 0].value) for k in found]
    after = sum(begin in (1, last + 1) for (_, last), (begin, _) in pairwise(spans))
    if 2 * after < len(spans) - 1:
        return rows
    made = list(rows)
    for k, end in found.items():
        tokens, at = rows[k].tokens, rows[k].tokens[end - 1].end
        head = (
            [*tokens[: end - 1], replace(tokens[end - 1], word="row")]
            if tokens[end - 1].word == "series"
            else tokens[:end]
        )
        head = [t for t in head if t.word != "a"]
        made[k] = replace(rows[k], tokens=[*head, Token("mark", ":", at, at, None, True), *tokens[end:]])
    return made


def _signless(tokens: list[Token]) -> int:
    """Where the words of a round begin behind a head without a sign, "4-6 rnd 18 sc", "5 a row (2 sc, inc) x 6"; 0 for no such head."""
    if len(tokens) < _POINT or tokens[0].kind not in ("number", "ordinal"):
        return 0
    at = 1
    if tokens[1].word == "-" and tokens[2].kind in ("number", "ordinal"):
        at = 3
    at += at < len(tokens) and tokens[at].word == "a"
    if at + 1 >= len(tokens) or tokens[at].word not in _SINGULAR:
        return 0
    behind = tokens[at + 1]
    works = behind.kind == "number" or behind.word in ("(", "[", "*") or behind.word.rstrip("0123456789") in _WORKED
    return at + 1 if works else 0


def _undashed(rows: list[Row]) -> list[Row]:
    """``rows`` with "6 8." as "6-8." between rounds 5 and 9: a page lost the dash."""
    made, last = list(rows), 0
    for k, row in enumerate(rows):
        tokens = row.tokens
        if len(tokens) < _POINT or tokens[0].kind != "number" or not isinstance(tokens[0].value, int):
            continue
        second = tokens[1]
        if second.kind == "number" and not second.glued and tokens[2].word in (".", ":", ")"):
            if tokens[0].value == last + 1 and isinstance(second.value, int) and second.value > tokens[0].value:
                dash = Token("mark", "-", tokens[0].end, tokens[0].end, None, True)
                made[k] = replace(row, tokens=[tokens[0], dash, *tokens[1:]])
                last = second.value
        elif second.word in (".", ":", ")"):
            last = tokens[0].value
        elif second.word == "-" and isinstance(tokens[2].value, int):
            last = tokens[2].value
    return made


def _lettered(rows: list[Row]) -> list[Row]:
    """``rows`` with "V3–5:" as "R3–5:", which a translator left of Spanish rounds between others."""
    if not any(row.tokens and _FOREIGN.fullmatch(row.tokens[0].word) for row in rows):
        return rows
    if not any(row.tokens and _HEAD.fullmatch(row.tokens[0].word) for row in rows):
        return rows
    made = []
    for row in rows:
        first = row.tokens[0] if len(row.tokens) > _POINT else None
        if first is not None and _FOREIGN.fullmatch(first.word) and any(t.word == ":" for t in row.tokens[1:4]):
            row = replace(row, tokens=[replace(first, word=f"r{first.word[1:]}"), *row.tokens[1:]])
        made.append(row)
    return made


def _plain_first(row: Row) -> Row:
    """``row`` with a colon in "R1 6x", which is no round six times."""
    tokens = row.tokens
    if len(tokens) != _POINT - 1 or tokens[0].word != "r1" or tokens[1].kind != "number" or tokens[2].word != "x":
        return row
    return replace(row, tokens=[tokens[0], Token("mark", ":", tokens[0].end, tokens[0].end, None, True), *tokens[1:]])


def _short(tokens: list[Token]) -> bool:
    """Whether a point of a list is a round whose head is one word: "1. R1: 6 sc in MR", "3. R8-R10: …"."""
    return (
        len(tokens) > _POINT
        and tokens[0].kind == "number"
        and tokens[1].word in (".", ")")
        and _HEAD.fullmatch(tokens[2].word) is not None
        and tokens[3].word in (":", "-")
    )


def _explains(tokens: list[Token]) -> bool:
    """Whether a point of a list is an abbreviation in full: "2. Sc: Single Crochet", "8. St(s): Stitch(es)"."""
    if len(tokens) < _POINT + 1 or tokens[0].kind != "number" or tokens[1].word not in (".", ")"):
        return False
    sign = next((k for k in range(3, min(7, len(tokens) - 1)) if tokens[k].word in (":", "-", "=")), 0)
    if not sign or any(t.kind == "number" for t in tokens[2:sign]) or len(tokens[2].word) > _ABBREVIATION:
        return False
    return tokens[sign + 1].word in _IN_FULL


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
_SIGNLESS: Final = 3  # heads without a sign
_SINGULAR: Final = frozenset(("row", "rnd", "round", "series"))
_WORKED: Final = frozenset(("sc", "inc", "dec", "hdc", "dc", "mr", "sbn", "sb"))
_HEAD: Final = re.compile(r"(?:r|rd|rnd|row|round)\d+")
_FOREIGN: Final = re.compile(r"v\d+")
_ABBREVIATION: Final = 5  # letters
_IN_FULL: Final = frozenset(
    "magic single half double treble increase decrease slip chain stitch stitches invisible back front fasten".split()
)
"""What the full words of an abbreviation begin with."""
_ROUNDS: Final = frozenset("round rounds rnd rnds row rows".split())

"""Printed patterns, tables of counts: rounds that say how many stitches they have, and how many more or fewer than the round before, as charts from Japan do, often
from the last round up: ``4 | 24 | +6``; put as other patterns do: ``Rnd 4: (2 sc, inc) x 6 (24)``."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Final

from tambour.crochet.printed.tokens import Row, Token
from tambour.crochet.printed.wordings.vocabulary import Vocabulary
from tambour.crochet.words.table import Terms

_RUN: Final = 3  # rows that follow each other, before they are a table of counts
_RANGED: Final = frozenset(("-", "~", "to"))
_MOST: Final = 400  # stitches of a round, and rounds
_SIGNS: Final = {"+": 1, "-": -1, "±": 0}
_HEADS: Final = frozenset(
    "rnd rnds round rounds row rows r rd rang rangs tour tours t runde rd段 段 v vuelta toer".split()
)
_GLUED: Final = re.compile(r"(?:r|rd|rnd|row|t|v)(\d{1,3})")
_BESIDE: Final = frozenset(("|", ",", ":", ";", ".", "(", ")", "=", "stitch", "st", "sts", "stitches"))
_REMARKS: Final = frozenset("inc dec increase increases decrease decreases no change none even".split())
"""What a remark may say that its numbers say as well."""


@dataclass(slots=True)
class _Counted:
    """A row of such a table: its rounds from ``first`` to ``last`` have ``count`` stitches, ``change`` more than those before; ``rest`` is what it says besides."""

    at: int
    first: int
    last: int
    count: Token
    change: int | None
    rest: list[Token]


def changes(rows: list[Row], vocabulary: Vocabulary, terms: Terms) -> list[Row]:
    """``rows`` with those of tables of counts as lines of rounds, from the first to the last."""
    made = list(rows)
    for run in _runs(rows):
        ordered = run if run[0].first < run[-1].first else run[::-1]
        if ordered[0].first != 1 or not _agree(ordered):
            continue
        before = 0
        for place, one in zip(
            run, ordered, strict=True
        ):  # a line of the table holds what comes next, wherever that stood
            made[place.at] = replace(
                rows[one.at], tokens=_worked(one, before, rows[one.at].tokens[0], vocabulary, terms)
            )
            before = int(one.count.value)
        title = run[0].at - 1
        if title >= 0 and _titles(rows[title].tokens):
            made[title] = replace(rows[title], tokens=[])
    return made


def _titles(tokens: list[Token]) -> bool:
    """Whether a line says only what the columns hold: "Rnd | Stitches | Inc/Dec"."""
    return bool(tokens) and tokens[0].word in _HEADS and not any(t.kind == "number" for t in tokens)


def _runs(rows: list[Row]) -> Iterator[list[_Counted]]:
    """The rows that bear numbers which follow each other up or down."""
    run: list[_Counted] = []
    way = 0
    for at, row in enumerate([*rows, Row([], 0, 0)]):
        one = _counted(at, row.tokens) if row.tokens else None
        step = 0
        if one is not None and run:
            step = (one.first == run[-1].last + 1) - (one.last == run[-1].first - 1)
        if one is not None and run and step and way in (0, step):
            run.append(one)
            way = step
            continue
        if not row.tokens and run and at < len(rows) and at == run[-1].at + 1:
            continue
        if len(run) >= _RUN:
            yield run
        run, way = ([one] if one is not None else []), 0


def _counted(at: int, tokens: list[Token]) -> _Counted | None:
    """A row that begins with the number of a round, or two, and goes on with a count and how that changed."""
    if (glued := _GLUED.fullmatch(tokens[0].word)) is not None:  # "R4-5"
        tokens = [replace(tokens[0], kind="number", value=int(glued[1])), *tokens[1:]]
    k = int(tokens[0].word in _HEADS)
    numbers = [t for t in tokens[k:] if t.kind == "number"]
    if len(numbers) < 2 or any(not isinstance(t.value, int) or not 0 <= t.value < _MOST for t in numbers):
        return None
    if tokens[k].kind != "number":
        return None
    first = last = int(tokens[k].value)
    k += 1
    if (
        k + 1 < len(tokens)
        and tokens[k].word in _RANGED
        and tokens[k + 1].kind == "number"
        and tokens[k + 1].value > first
    ):
        last = int(tokens[k + 1].value)
        k += 2
    while k < len(tokens) and tokens[k].word in ("|", ":", "."):
        k += 1
    if k >= len(tokens) or tokens[k].kind != "number" or not tokens[k].value:
        return None
    count, k = tokens[k], k + 1
    while k < len(tokens) and tokens[k].word in _BESIDE:
        k += 1
    change: int | None = None
    if k < len(tokens) and tokens[k].word in _SIGNS:
        sign = tokens[k].word
        if k + 1 < len(tokens) and tokens[k + 1].kind == "number":
            change, k = _SIGNS[sign] * int(tokens[k + 1].value), k + 2
        elif sign == "-" and k + 1 == len(tokens):
            change, k = 0, k + 1
    rest = [t for t in tokens[k:] if t.word not in ("|", ")")]
    return _Counted(at, first, last, count, change, rest)


def _agree(run: list[_Counted]) -> bool:
    """Whether what is said of changes is what the counts are, and it is said often enough to be a table of them."""
    said = [(a, b) for a, b in pairwise(run) if b.change is not None]
    right = sum(int(b.count.value) - int(a.count.value) == b.change for a, b in said)
    return 2 * len(said) > len(run) - 1 and 10 * right >= 9 * len(said)


def _worked(one: _Counted, before: int, place: Token, vocabulary: Vocabulary, terms: Terms) -> list[Token]:
    """The line of a round: its head, what is worked, and its count."""
    start, end = one.count.start, one.count.end

    def put(*words: str | int) -> list[Token]:
        made = []
        for word in words:
            if isinstance(word, int):
                made.append(Token("number", str(word), start, end, word))
            else:
                kind = "word" if word[0].isalpha() else "mark"
                made += [Token(kind, part.lower(), start, end) for part in word.split()]
        return made

    sc, inc, dec = (terms.stitches[name][0] for name in ("sc", "inc", "dec"))
    count = int(one.count.value)
    change = count - before
    head = [Token("word", terms.words["round"][0].lower(), place.start, place.start, None, False, True)]
    head += [replace(place, kind="number", word=str(one.first), value=one.first)]
    if one.last > one.first:
        head += put("-", one.last)
    head += put(":")
    works = any(t.kind == "stitch" for t in vocabulary.read(one.rest))
    ringed = any(t.value == "ring" for t in vocabulary.read(one.rest))
    if ringed and all(t.value == count for t in one.rest if t.kind == "number"):
        body, one.rest = put(count, sc, "in", terms.words["ring"][0]), []
    elif works and (one.first == 1 or not _said(one.rest)):
        body = list(one.rest)
        one.rest = []
    elif one.first == 1:
        body = put(count, sc, "in", terms.words["ring"][0])
        one.rest = [] if _said(one.rest) else one.rest
    elif not change:
        body = put(sc, terms.words["around"][0])
    else:
        shaped, many = (inc, change) if change > 0 else (dec, -change)
        taken = before - (1 if change > 0 else 2) * many
        if taken < 0 or before % many:
            body = put(shaped, many, "sts", "evenly", terms.words["around"][0])
        elif not taken:
            body = put(shaped, "x", many)
        else:
            body = put("(", taken // many, sc, ",", shaped, ")", "x", many)
        one.rest = [] if _said(one.rest) else one.rest
    return [
        *head,
        *body,
        *put("("),
        replace(one.count, glued=True),
        *put(")"),
        *(put(".") + one.rest if one.rest else []),
    ]


def _said(rest: list[Token]) -> bool:
    """Whether words say no more than the numbers do: "6 inc", "no change"."""
    return all(t.kind != "word" or t.word in _REMARKS for t in rest)

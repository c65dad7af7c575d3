"""Printed patterns, slashed: rows that follow each other in one line with strokes between them, "CH5. line 1: 4X (4) / line 2: CH1, 1X, A, 1X (3)", each on
a line of its own, and rounds behind the name of their yarn, "Grey  R5-R26: 8X"."""

from __future__ import annotations

import re
from itertools import pairwise
from typing import Final

from tambour.crochet.printed.tokens import Row, Token
from tambour.crochet.printed.yarns.shades import shade

_CALLED: Final = frozenset(("line", "row", "round", "rnd", "r"))
_ROWS: Final = ("line", "row")
_ROUND: Final = re.compile(r"(?:r|rnd|rd|round|row)s?\d*")
_SHADE: Final = 2  # words of a yarn's name


def slashed(rows: list[Row], row: str) -> list[Row]:
    """``rows`` with such lines taken apart. row : the word for a row."""
    made: list[Row] = []
    for one in [part for each in rows for part in _yarned(each)]:
        heads = [k for k in range(len(one.tokens) - 3) if _head(one.tokens, k)]
        apart = len(heads) > 1 and [one.tokens[k + 1].value for k in heads] == list(range(1, len(heads) + 1))
        if not apart or not all(one.tokens[k - 1].word == "/" for k in heads[1:]):
            made.append(one)
            continue
        cuts = [*([0] if heads[0] else []), *heads, len(one.tokens)]
        for a, b in pairwise(cuts):
            some = one.tokens[a:b]
            some = some[:-1] if some[-1].word == "/" else some
            if some[0].word in _ROWS and a in heads:
                some = [Token("word", row, some[0].start, some[0].end, None, False, True), *some[1:]]
            made.append(Row(some, some[0].start, some[-1].end))
    return made


def _yarned(row: Row) -> list[Row]:
    """A yarn and the round behind it as two lines; of a first round the yarn stands there already as that of a part."""
    tokens = row.tokens
    at = next((k for k, t in enumerate(tokens[: _SHADE + 1]) if _ROUND.fullmatch(t.word)), 0)
    first = tokens[at + 1 : at + 2] if at and not tokens[at].word[-1].isdigit() else tokens[at : at + 1]
    number = int("".join(c for c in first[0].word if c.isdigit()) or 0) if at and first else 0
    name = tokens[:at]
    if (
        number < 2
        or not name[0].capital
        or any(t.kind != "word" for t in name)
        or not any(t.word == ":" for t in tokens)
    ):
        return [row]
    if shade(" ".join(t.word for t in name)) is None:
        return [row]
    led = Token("word", "with", name[0].start, name[0].start, capital=True)
    return [Row([led, *name], row.start, name[-1].end), Row(tokens[at:], tokens[at].start, row.end)]


def _head(tokens: list[Token], k: int) -> bool:
    """Whether "line 2:" stands there."""
    named, number, colon = tokens[k : k + 3]
    first = k == 0 or tokens[k - 1].word in ("/", ".", ":", ",")
    return first and named.word in _CALLED and number.kind == "number" and colon.word == ":"

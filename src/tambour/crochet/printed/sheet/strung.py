"""Printed patterns, strung: rounds behind each other in one line, or behind their part's name, whose heads end in a dash as all of the text's do ("Ears (make 2):
Round 1 - 6 sc in ring <6>. Round 2 - inc x 6 <12>"), with the colon that such heads within a line have in most texts."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from typing import Final

from tambour.crochet.printed.tokens import Row, Token

_ROUNDS: Final = frozenset(("round", "rnd", "row", "rounds", "rnds", "rows"))
_ENDS: Final = frozenset((":", ".", ";", ">", ")", "]"))
_HEADED: Final = 4  # tokens of a heading, or fewer
_YARN: Final = 3  # words of a yarn's name
_RUN: Final = 4
"""So many lines of a text begin with such a head."""


def strung(rows: list[Row]) -> list[Row]:
    """``rows`` with a colon behind every such head that a line does not begin with, and a line of its own for a first round behind its yarn."""
    rows = _called(_led(rows))
    if sum(_dash(row.tokens, 0) > 0 for row in rows) < _RUN:
        return rows
    made: list[Row] = []
    for row in rows:
        tokens = row.tokens
        dashes = {_dash(tokens, k) for k in range(1, len(tokens)) if tokens[k - 1].word in _ENDS} - {0}
        said = [replace(t, word=":") if k in dashes else t for k, t in enumerate(tokens)]
        made.append(replace(row, tokens=said) if dashes else row)
    return made


def _dash(tokens: list[Token], at: int) -> int:
    """Where the dash stands behind "Round 3 -" or "Rounds 3 to 9 -" at a token; 0 where no such head does."""
    if at >= len(tokens) or tokens[at].word not in _ROUNDS or not tokens[at].capital:
        return 0
    k = at + 1
    while k < len(tokens) and (tokens[k].kind == "number" or tokens[k].word in ("to", "and", ",", "&")):
        k += 1
    return k if at + 1 < k < len(tokens) - 1 and tokens[k].word == "-" and not tokens[k].glued else 0


def _led(rows: list[Row]) -> list[Row]:
    """``rows`` with "Light blue. 1) 6 sc in ring (6). Then …" in lines of their own, where the text's rounds have such heads."""
    if sum(_point(row.tokens, 0) for row in rows) < _RUN:
        return rows
    made: list[Row] = []
    for row in rows:
        tokens = row.tokens
        stop = next((k for k, t in enumerate(tokens[: _YARN + 1]) if t.word == "."), 0)
        if (
            not stop
            or any(t.kind != "word" for t in tokens[:stop])
            or not _point(tokens, stop + 1)
            or tokens[stop + 1].value != 1
        ):
            made.append(row)
            continue
        ends = [k for k in range(stop + 2, len(tokens) - 1) if tokens[k].word == "." and tokens[k + 1].capital]
        cuts = [0, stop + 1, *(k + 1 for k in ends), len(tokens)]
        for a, b in pairwise(cuts):
            made.append(replace(row, tokens=tokens[a:b], start=tokens[a].start, end=tokens[b - 1].end))
    return made


def _called(rows: list[Row]) -> list[Row]:
    """``rows`` with "Grass round - …", under the heading GRASS, as its first round."""
    headings: set[str] = set()
    made: list[Row] = []
    for row in rows:
        tokens = row.tokens
        if (
            len(tokens) > _HEADED
            and tokens[0].word in headings
            and tokens[1].word in ("round", "rnd", "row")
            and tokens[2].word in ("-", ":", ".")
        ):
            first = Token("number", "1", tokens[1].end, tokens[1].end, 1)
            made.append(
                replace(
                    row, tokens=[replace(tokens[1], capital=True), first, replace(tokens[2], word=":"), *tokens[3:]]
                )
            )
            continue
        if tokens and len(tokens) <= _HEADED:
            headings |= {tokens[0].word, tokens[0].word.removesuffix("s")}
        made.append(row)
    return made


def _point(tokens: list[Token], at: int) -> bool:
    """Whether a round's number and its bracket stand there: "1)"."""
    return at + 2 < len(tokens) and tokens[at].kind == "number" and tokens[at + 1].word == ")" and tokens[at + 1].glued

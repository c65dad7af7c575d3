"""Printed patterns, inlines: rounds with bare numbers that follow each other on one line, whole parts among them ("Tail, white: 1. 6 sc in MR =6; 2. 6 inc
=12; 3-4. 12 sc =12."), each on a line of its own, and what stands before and behind them too."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

from tambour.crochet.printed.tokens import Row, Token
from tambour.crochet.printed.wordings.vocabulary import Vocabulary

_PARTS: Final = (";", ".", ")", "]")
_LEAST: Final = 2  # rounds of such a list
_NAME: Final = 14  # words and signs of what heads one


def inlined(rows: list[Row], vocabulary: Vocabulary) -> list[Row]:
    """``rows`` with such lists as lines of one round each."""
    made: list[Row] = []
    for row in rows:
        cuts = _cuts(row.tokens, vocabulary)
        if not cuts:
            made.append(row)
            continue
        for a, b in zip([0, *cuts] if cuts[0] else cuts, [*cuts, len(row.tokens)][not cuts[0] :]):
            some = row.tokens[a:b]
            while some and some[-1].word in (";", ","):
                some = some[:-1]
            if some:
                made.append(replace(row, tokens=some, start=some[0].start, end=some[-1].end))
    return made


def _cuts(tokens: list[Token], vocabulary: Vocabulary) -> list[int]:
    """Where lines begin: the rounds of every list, what heads it, and what follows it; nothing where a line holds no list."""
    found: set[int] = set()
    at = 0
    while at < len(tokens):
        run, end = _run(tokens, at, vocabulary)
        if len(run) >= _LEAST:
            found |= {at if not found else _begun(tokens, at, max(found)), *run, end}
            at = end
        else:
            at += 1
    return sorted(found - {len(tokens)}) if found and (len(found - {0, len(tokens)}) > 1) else []


def _run(tokens: list[Token], at: int, vocabulary: Vocabulary) -> tuple[list[int], int]:
    """Where the rounds begin of a list that begins at ``at`` with round 1, and where it ends."""
    if at and tokens[at - 1].word not in (":", *_PARTS):
        return [], at
    run: list[int] = []
    last, k = 0, at
    while (head := _head(tokens, k)) is not None and head[0] == last + 1:
        end = next((n for n in range(head[2], len(tokens)) if _ends(tokens, n, head[1])), len(tokens))
        said = vocabulary.read(tokens[head[2] : end])
        if not any(t.kind == "stitch" for t in said) or (not run and not any(t.kind == "number" for t in said)):
            break  # "1. sc - single crochet; 2. dc - double crochet" explains
        run.append(k)
        last, k = head[1], end + (end < len(tokens))
        if end >= len(tokens) or tokens[end].word == ".":
            break
    return run, k


def _ends(tokens: list[Token], k: int, last: int) -> bool:
    """Whether a round ends at ``k`` : before the next number, or where its sentence stops."""
    if tokens[k].word == ";":
        return (head := _head(tokens, k + 1)) is not None and head[0] == last + 1
    return tokens[k].word == "." and (k + 1 == len(tokens) or (tokens[k + 1].capital and not tokens[k + 1].glued))


def _head(tokens: list[Token], k: int) -> tuple[int, int, int] | None:
    """The first and the last number of a round said at ``k``, "3.", "3-4.", "5)", and where its words begin; None where none is said."""
    numbers: list[int] = []
    while k + 1 < len(tokens) and tokens[k].kind == "number" and isinstance(tokens[k].value, int):
        numbers.append(tokens[k].value)
        sign = tokens[k + 1]
        if sign.word in (".", ")", ":") and len(numbers) <= 2:
            glued = k + 2 < len(tokens) and sign.word == "." and tokens[k + 2].kind == "number" and tokens[k + 2].glued
            return None if glued else (numbers[0], numbers[-1], k + 2)
        if sign.word not in ("-", "–", "—") or len(numbers) > 1:
            return None
        k += 2
    return None


def _begun(tokens: list[Token], at: int, after: int) -> int:
    """Where what heads a list at ``at`` begins, behind the list that ends at ``after``."""
    stops = [k + 1 for k in range(after, at) if tokens[k].word == "." and tokens[k + 1].capital]
    return max([after, *(k for k in stops if at - k <= _NAME)])

"""Printed patterns, corners: what goes into one space without a bracket, "3 dc, ch 2, 3 dc in next ch-2 sp", put in one."""

from __future__ import annotations

from typing import Final

from tambour.crochet.printed.tokens import Token

_TALL: Final = ("sc", "hdc", "dc", "tr")
_BETWEEN: Final = (",", "+")
_CORNERS: Final = ("corner", "corners")
PLACES: Final = frozenset(("space", *_CORNERS))


def grouped(tokens: list[Token]) -> list[Token]:
    """``tokens`` with brackets about stitches, chains and stitches that go into one space together; "in corner" is in the next space then."""
    if not any(t.value == "space" or t.word in _CORNERS for t in tokens):
        return tokens
    made: list[Token] = []
    at = 0
    while at < len(tokens):
        end = _several(tokens, at)
        place = _space(tokens, end) if end > at else 0
        if not place:
            made.append(tokens[at])
            at += 1
            continue
        open_, shut = tokens[at], tokens[end - 1]
        enclosed = bool(made) and made[-1].word in ("(", "[", "{") and tokens[end].word in (")", "]", "}")
        inner = tokens[at:end]
        made += (
            inner
            if enclosed
            else [Token("mark", "(", open_.start, open_.start), *inner, Token("mark", ")", shut.end, shut.end)]
        )
        at = end
        if enclosed:
            made.append(tokens[at])
            at += 1
        corner = tokens[place - 1]
        if corner.word in _CORNERS:
            named = tokens[at : place - 1]
            nexts = (
                []
                if any(t.value in ("next", "each", "same") for t in named)
                else [Token("key", "next", corner.start, corner.start, "next")]
            )
            made += [*named, *nexts, Token("key", "space", corner.start, corner.end, "space")]
            at = place + (place < len(tokens) and tokens[place].value == "space")
    return made


def _several(tokens: list[Token], at: int) -> int:
    """Where "3 dc, ch 2, 3 dc" ends that begins at ``at``; ``at`` for other words."""
    if at and (tokens[at - 1].kind in ("number", "ordinal") or tokens[at - 1].value in ("in", "next", "each")):
        return at
    first = _one(tokens, at)
    if first == at or not any(t.value in _TALL for t in tokens[at:first]):
        return at
    chain = _one(tokens, _past(tokens, first))
    if chain <= first or not any(t.value == "ch" for t in tokens[first:chain]):
        return at
    last = _one(tokens, _past(tokens, chain))
    return last if last > chain and any(t.value in _TALL for t in tokens[chain:last]) else at


def _past(tokens: list[Token], at: int) -> int:
    return at + 1 if at < len(tokens) and tokens[at].word in _BETWEEN else len(tokens)


def _one(tokens: list[Token], at: int) -> int:
    """Where one stitch and its number, before or behind it, end."""
    kinds = [t.kind for t in tokens[at : at + 2]]
    if sorted(kinds) == ["number", "stitch"]:
        return at + 2
    return at + 1 if kinds[:1] == ["stitch"] and tokens[at].value != "ch" else at


def _space(tokens: list[Token], at: int) -> int:
    """Where a place that begins at ``at`` and is one space or corner ends; 0 where none stands there. A bracket may close before it."""
    end = at + (at < len(tokens) and tokens[at].word in (")", "]", "}"))
    end += end < len(tokens) and tokens[end].word == "all"
    if end >= len(tokens) or tokens[end].value != "in":
        return 0
    for k in range(end + 1, min(end + 8, len(tokens))):
        if tokens[k].value == "space" or tokens[k].word in _CORNERS:
            return k + 1
        if (tokens[k].kind == "mark" and tokens[k].word != "-") or tokens[k].value == "each":
            return 0
    return 0

"""Printed patterns, bilingual: lines that say all twice, in two languages with a stroke between: ``R2: 6 inc / 6 aum [12]``; the first is read."""

from __future__ import annotations

from typing import Final

from tambour.crochet.printed.tokens import Row, Token

_LEAST: Final = 4  # rounds that say all twice
_ROUNDS: Final = frozenset("row rows round rounds rnd rnds".split())
_CLOSED: Final = {")": "(", "]": "["}


def first(rows: list[Row]) -> list[Row]:
    """The lines with what stands before their strokes, and the count that ends them, where rounds say all twice; else as they are."""
    if sum(_twice(row.tokens) for row in rows) < _LEAST:
        return rows
    return [Row(_before(r.tokens), r.start, r.end, r.marked) if any(map(_stroke, r.tokens)) else r for r in rows]


def _stroke(token: Token) -> bool:
    return token.word == "/" and not token.glued


def _twice(tokens: list[Token]) -> bool:
    """Whether a line is a round with a stroke between words that are not the same on both sides: "R1: 6 sc in MR / 6 pb en AM [6]"."""
    at = next((k for k, t in enumerate(tokens) if _stroke(t)), 0)
    if at < 4 or not any(t.kind == "number" or t.word[-1:].isdigit() for t in tokens[:3]):
        return False
    behind_it = tokens[at + 1 : at + 3]
    if len(behind_it) == 2 and len(behind_it[0].word) < 3 and behind_it[0].capital and behind_it[1].word == ":":
        return False  # "A: 4 sc / B: 9 sc": another yarn
    before = {
        t.word for t in tokens[:at] if t.kind == "word"
    } - _ROUNDS  # "7 - 12 rows / 6 rows / - 36 sc" says all once
    behind = {t.word for t in tokens[at:] if t.kind == "word"}
    return bool(before and behind - before)


def _before(tokens: list[Token]) -> list[Token]:
    """What stands before each stroke, within brackets and without, and the bracket that ends the line."""
    last = _last_bracket(tokens)
    made: list[Token] = []
    depth, left_out = 0, -1  # how deep; where words are left out, the depth of their stroke
    for k, token in enumerate(tokens):
        if left_out == 0 and k == last:
            left_out = -1
        closes = token.word in _CLOSED
        depth -= closes
        if closes and 0 <= depth < left_out:
            left_out = -1
        if left_out < 0 and _stroke(token):
            left_out = depth
        elif left_out < 0:
            made.append(token)
        depth += token.word in ("(", "[")
    return made


def _last_bracket(tokens: list[Token]) -> int:
    """Where the bracket opens that ends a line; its length where none does."""
    end = len(tokens) - 1
    while end > 0 and tokens[end].word in (".", ":"):
        end -= 1
    opens = _CLOSED.get(tokens[end].word)
    return next((k for k in range(end, -1, -1) if tokens[k].word == opens), len(tokens)) if opens else len(tokens)

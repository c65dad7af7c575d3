"""Printed patterns, strung: rounds in one line behind each other, or behind their part's name, whose heads end in a dash as all of the text's do ("Ears (make 2):
Round 1 - 6 sc in ring <6>. Round 2 - inc x 6 <12>"), each put on a line of its own."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

from tambour.crochet.printed.tokens import Row, Token

_ROUNDS: Final = frozenset(("round", "rnd", "row", "rounds", "rnds", "rows"))
_ENDS: Final = frozenset((":", ".", ";", ">", ")", "]"))
_RUN: Final = 4
"""So many lines of a text begin with such a head."""


def strung(rows: list[Row]) -> list[Row]:
    """``rows`` with every such round on its own line."""
    if sum(bool(row.tokens) and _head(row.tokens, 0) for row in rows) < _RUN:
        return rows
    made: list[Row] = []
    for row in rows:
        tokens = row.tokens
        cuts = [k for k in range(1, len(tokens)) if tokens[k - 1].word in _ENDS and _head(tokens, k)]
        if not cuts:
            made.append(row)
            continue
        first = _bare(tokens[: cuts[0]])
        made.append(replace(row, tokens=first, end=first[-1].end))
        for a, b in zip(cuts, [*cuts[1:], len(tokens)]):
            own = _bare(tokens[a:b]) if b < len(tokens) else tokens[a:b]
            made.append(Row(own, own[0].start, own[-1].end if b < len(tokens) else row.end))
    return made


def _head(tokens: list[Token], at: int) -> bool:
    """Whether "Round 3 -" or "Rounds 3 to 9 -" stands at a token."""
    if tokens[at].word not in _ROUNDS or not tokens[at].capital:
        return False
    k = at + 1
    while k < len(tokens) and (tokens[k].kind == "number" or tokens[k].word in ("to", "and", ",", "&")):
        k += 1
    return at + 1 < k < len(tokens) - 1 and tokens[k].word == "-" and not tokens[k].glued


def _bare(tokens: list[Token]) -> list[Token]:
    """Words without the mark that only parts them from what follows."""
    return tokens[:-1] if len(tokens) > 1 and tokens[-1].word in (":", ";") else tokens

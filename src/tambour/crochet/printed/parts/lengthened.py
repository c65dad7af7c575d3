"""Printed patterns, lengthened: rows that begin with a chain and go back along it, "Ch 8. 1 sc in 2nd ch from hook …", are longer than the row below."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

from tambour.core.errors import Span
from tambour.crochet.graph.hook import LIFT
from tambour.crochet.language.source import Source
from tambour.crochet.language.tree import Action, Line
from tambour.crochet.printed.parts.part import Draft
from tambour.crochet.printed.tokens import Token

_STOPS: Final = frozenset(".,;:")
_NTH: Final = (2, 3)  # which chain from the hook is the first that is worked into


def lengthened(source: Source, draft: Draft, tokens: list[Token]) -> list[Token]:
    """The words of a row that begins so, as of one on the edge with its chains, which ``draft`` has then behind the row below; as they
    are where it begins otherwise."""
    chain, end = _chain(tokens)
    at = _hooked(tokens, end) if chain and draft.flat and draft.chain is None and draft.edge else 0
    last = draft.lines[-1] if draft.lines else None
    if not at or last is None or not last.in_round or draft.edge is None:
        return tokens
    nth, span = tokens[at].value, Span(tokens[0].start, tokens[end - 1].end)
    rows = list(last.rounds()) if last.times > 1 or last.again is not None else [last]
    turn = rows[-1].items[-1] if rows[-1].items else None
    if not isinstance(turn, Action) or turn.name != "turn" or chain <= nth:
        return tokens
    if chain - nth + 2 <= LIFT:
        source.doubt(
            "so short a chain is taken to lift the yarn: the row is not drawn longer", "leave it as it is", span
        )
        return tokens
    rows[-1] = replace(rows[-1], items=rows[-1].items[:-1])
    longer = chain - nth + 1
    draft.lines[-1:] = [*rows, Line((Action("ch", span, longer + 1), turn), span, False)]
    draft.edge = draft.edges[draft.last] = draft.edge + longer
    first = Token("key", "next", tokens[at].start, tokens[at].end, "next")
    return [*tokens[end:at], first, tokens[at + 1], *tokens[at + 4 :]]


def _chain(tokens: list[Token]) -> tuple[int, int]:
    """How long the chain is that words begin with, and where what stands behind it begins; 0 where they begin otherwise."""
    words = tokens[:4]
    named = next((k for k, t in enumerate(words[:2]) if t.value == "ch"), None)
    if named is None:
        return 0, 0
    number = words[1 - named] if len(words) > 1 else None
    if number is None or number.kind != "number" or not isinstance(number.value, int):
        return 0, 0
    end = 2
    while end < len(tokens) and (tokens[end].word in _STOPS or tokens[end].value in ("turn", "and")):
        if tokens[end].value == "turn":
            return 0, 0  # the chain is turned at: it hangs down
        end += 1
    return number.value, end


def _hooked(tokens: list[Token], begin: int) -> int:
    """Where the ordinal stands of "1 sc in 2nd ch from hook", right behind the chain; 0 where something else is said there."""
    for at in range(begin, min(begin + 6, len(tokens) - 3)):
        nth, chain, off, hook = tokens[at : at + 4]
        if nth.kind == "ordinal" and nth.value in _NTH and chain.value == "ch" and off.value == "from":
            stitches = [t for t in tokens[begin:at] if t.kind == "stitch"]
            return at if hook.value == "hook" and len(stitches) == 1 and stitches[0].value not in ("slst", "ch") else 0
        if nth.kind == "mark":
            return 0
    return 0

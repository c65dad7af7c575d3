"""Printed patterns, rounds without a number: told by where they join and by their count."""

from __future__ import annotations

from tambour.crochet.printed.between.headlines import headed
from tambour.crochet.printed.rounds.items import bare_count
from tambour.crochet.printed.rounds.moved import moved
from tambour.crochet.printed.state import State
from tambour.crochet.printed.tokens import Row, Token


def unheaded(p: State, row: Row, tokens: list[Token]) -> int | None:
    """Where a round begins that has no number, by its join elsewhere and its count: "Left Leg: Join A with sl st to first
    skipped sc in 63rd rnd. Ch 1. 1 sc in each of next 30 sc. Ch 6. Join. 36 sts."; None where none does."""
    if not p.parts or p.mode in ("materials", "abbreviations", "notes", "assembly"):
        return None
    named = headed(p, row, tokens)
    at = named + 1 if named else 0
    sentences = [s for s in _sentences(tokens[at:]) if s]
    first = sentences[0] if sentences else []
    if len(sentences) < 3 or not any(t.kind == "key" and t.value == "join" for t in first[:1]):
        return None
    there = moved(first)
    if there is None or not (there.number or there.free) or not any(map(_count, sentences[2:])):
        return None
    return at if not any(t.kind == "key" and t.value == "thicknesses" for t in tokens) else None


def _count(tokens: list[Token]) -> bool:
    """Whether a sentence is only a count: "36 sts", "(36)"."""
    return bare_count(tokens) is not None or [t.kind for t in tokens] == ["mark", "number", "mark"]


def _sentences(tokens: list[Token]) -> list[list[Token]]:
    """Words parted at their points."""
    made: list[list[Token]] = [[]]
    for token in tokens:
        if token.word == ".":
            made.append([])
        else:
            made[-1].append(token)
    return made

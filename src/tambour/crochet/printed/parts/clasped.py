"""Printed patterns, clasped: clauses of a round that crochet another part in, in whatever words: what is taken up, held, laid against the body, and the stitches that go through both; put as those stitches alone."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from typing import Final

from tambour.core.errors import Span
from tambour.crochet.places.names import one
from tambour.crochet.printed.cursor import OPEN
from tambour.crochet.printed.tokens import Token

Clasp = tuple[str, str, Span, bool]
"""A part's noun, its rank ("first", "other", "2", "" unsaid), where the words stand, and whether they stand before the stitches."""

_HOLDS: Final = re.compile(
    r"\b(?:through|thru|both|attach\w*|join\w*|add(?:ing)?|hold(?:ing)?|held|plac(?:e|ed|ing)|position\w*|take|put|pick|grab|lay|laid|line|pinch\w*|flatten\w*|bring|"
    r"crochet (?:in|on|the)|sew|work(?:ing)? (?:in|on)|with (?:an?|the|one)|same|tog(?:ether)?|catch\w*|too|as well)\b|:|\bin(?:to)? (?:the )?(?:\w+ )?\w+ and (?:the )?(?:body|head)\b",
    re.IGNORECASE,
)
"""That a clause which names a part holds it to the work, and is not worked along it."""
_THROUGH: Final = re.compile(
    r"\b(?:through|thru|both|all (?:the )?(?:\w+ )?layers?|layers|it|them|too|as well|same|thicknesses)\b",
    re.IGNORECASE,
)
"""That stitches go through what was held before them."""
_ALONG: Final = re.compile(
    r"\b(?:along|around|across|all round|of (?:the )?(?:first|second|other) (?:leg|arm))\b", re.IGNORECASE
)
_WORKED: Final = re.compile(r"\b(?:same|work|as) (?:as )?(?:for|given|in)\b", re.IGNORECASE)
"""What is worked as a part is, and holds none: "repeat Rounds 1-3 same as for Legs"."""
_RANKS: Final = frozenset("first second other left right last 1st 2nd one next".split())
_HOSTS: Final = frozenset(("body", "head", "fabric"))
"""What the stitches between are said to be of: "sc in next 5 sc of body"."""


def clasped(tokens: list[Token], text: str, nouns: Sequence[str]) -> tuple[list[Token], list[Clasp]] | None:
    """The words of a round with each such clause as its stitches alone, and what it holds; None where it has none, or says of it what is not
    understood. nouns : of the parts that may be held, singular."""
    kept, found = list[Token](), list[Clasp]()
    waiting: tuple[str, str, Token] | None = None
    same, past = False, tokens[0].start
    last: list[Token] = []  # the stitches that held the part before
    for clause in _clauses(tokens):
        words = [t for t in clause if t.kind != "mark"]
        if not words:
            counts = clause[0].word in ("-", "=")
            kept += clause if counts else [replace(clause[0], word=",")] if kept and kept[-1].word != "," else []
            continue
        begin, end = clause[0].start, clause[-1].end
        said = text[past:end]  # with its fillers
        past = end
        at = next((k for k, t in enumerate(clause) if one(t.word) in nouns), None)
        some = _some(clause)
        if waiting is not None and same and last and [t.value for t in some] != [t.value for t in last]:
            # "join the second arm same as the first": by as many
            again = [replace(t, start=waiting[2].start, end=waiting[2].end) for t in last]
            found.append((waiting[0], waiting[1], Span(waiting[2].start, waiting[2].start), True))
            kept += [*again, Token("mark", ",", waiting[2].end, waiting[2].end)]
            waiting = None
        told = _WORKED.search(said) is not None
        if at is not None and not told and not _ALONG.search(said) and _HOLDS.search(said):
            noun, rank = one(clause[at].word), _rank(clause, at)
            if some:
                found.append(_clasp(noun, rank, begin, end, some))
                kept, waiting, last = [*kept, *some], None, some
            else:
                waiting, same = (noun, rank, clause[0]), "same" in said
            continue
        if waiting is not None and some and (same or _THROUGH.search(said)):
            found.append(_clasp(waiting[0], waiting[1], waiting[2].start, end, some))
            kept, waiting, last = [*kept, *some], None, some
            continue
        if waiting is not None and not some and not any(t.kind == "stitch" for t in words):
            continue  # "flatten it": what is done with it before
        kept += clause
    kept = [t for t in kept if not (t.kind == "word" and one(t.word) in _HOSTS)]
    if waiting is not None or not found or any(one(t.word) in nouns for t in kept):
        return None
    return kept, found


def _clauses(tokens: list[Token]) -> list[list[Token]]:
    """A round's words at its commas and stops outside of brackets, each clause with the mark that ends it."""
    made, depth = [list[Token]()], 0
    for t in tokens:
        depth += (t.word in OPEN) - (t.word in (")", "]", "}"))
        if t.kind == "mark" and t.word in (",", ";", ".", "-", "=") and depth <= 0:
            made += [[t], []]
        else:
            made[-1].append(t)
    return [c for c in made if c]


def _some(clause: list[Token]) -> list[Token]:
    """The stitches of a clause, so many of one kind, as a number and a stitch; none where it says no number of them, or several."""
    found: list[tuple[Token, Token | None]] = []
    for k, t in enumerate(clause):
        if t.kind != "number" or not isinstance(t.value, int):
            continue
        after = clause[k + 1] if k + 1 < len(clause) else None
        before = clause[k - 1] if k else None
        if after is not None and after.kind == "stitch":
            found.append((t, after))
        elif before is not None and before.kind == "stitch" and before.value not in ("inc", "dec"):
            found.append((t, before))
        elif after is not None and (after.value == "stitch" or after.word in ("st", "sts")):
            led = next((u for u in reversed(clause[:k]) if u.kind == "stitch"), None)
            found.append((t, led))
    if not found or len({t.value for t, _ in found}) > 1:
        return []
    number, stitch = next((pair for pair in reversed(found) if pair[1] is not None), found[-1])
    if stitch is None:
        stitch = Token("stitch", "sc", number.start, number.end, "sc")
    return [number, stitch] if number.start <= stitch.start else [stitch, number]


def _clasp(noun: str, rank: str, begin: int, end: int, some: list[Token]) -> Clasp:
    first, last = some[0].start, some[-1].end
    ahead = first > begin
    return noun, rank, Span(begin, first) if ahead else Span(last, end), ahead


def _rank(clause: list[Token], at: int) -> str:
    """Which of two a clause speaks of."""
    after = clause[at + 1] if at + 1 < len(clause) else None
    if after is not None and after.kind == "number" and after.value in (1, 2):
        told = clause[at + 2] if at + 2 < len(clause) else None
        if told is None or told.kind != "stitch":
            return str(after.value)
    return next((t.word for t in reversed(clause[max(0, at - 3) : at]) if t.word in _RANKS - {"one", "next"}), "")

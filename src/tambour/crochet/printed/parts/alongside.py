"""Printed patterns, alongside: rounds that go on along the edge of a piece: its sides, the other side of its chain, all around it."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Final

from tambour.core.errors import Span
from tambour.crochet.graph.edges import ALL, BASE, SIDE, SIDES
from tambour.crochet.language.tree import Action
from tambour.crochet.printed.heads import Head
from tambour.crochet.printed.parts.bases import base, is_first
from tambour.crochet.printed.parts.naming import named
from tambour.crochet.printed.parts.part import Draft
from tambour.crochet.printed.rounds.doubts import tried
from tambour.crochet.printed.rounds.reader import Body
from tambour.crochet.printed.state import State
from tambour.crochet.printed.tokens import Token

_OPENING: Final = re.compile(r"\b(?:neck(?:line)?|armholes?|(?:arm |sleeve )?openings?|underarms?|toe|tip)\b")
_BASE: Final = re.compile(
    r"\b(?:opposite|other|remaining|rem|free|unused|bottom)\b[^.;:]{0,40}\b(?:foundation|(?:starting|beginning|beg|base) (?:chain|ch)\b)|loops? of (?:the )?(?:\w+ ){0,3}(?:ch|chain)\b"
)
_BOTH: Final = re.compile(r"\bup\b.*\bdown\b|\bdown\b.*\bup\b|\bboth sides\b", re.DOTALL)
_ALL: Final = re.compile(
    r"\b(?:around (?:all|the (?:entire|whole|outer|outside)|entire|whole|outer|outside)|perimeter|all (?:the way )?around)\b"
)
_SIDE: Final = re.compile(
    r"\b(?:side|long|short|straight|flat|lower|upper|bottom|top|raw|curved)\s+(?:side |side)?edges?\b|\b(?:down|up|along|across)\b[^.;]{0,25}\b(?:sides?|edges?)\b"
    r"|\bends of (?:the |each )?rows?\b|\bin (?:the )?end of (?:each|every) row\b|\brow ends?\b|\b(?:along|across)(?: the)? (?:side|bottom|top) of\b"
)
_NTH: Final = re.compile(r"\b(\d{1,2})(?:st|nd|rd|th) (?:ch|chain)\b")
_TWO: Final = re.compile(r"\b(?:both (?:layers|thicknesses|pieces|sides)|tog(?:ether)?\b)")


def bordered(
    p: State, draft: Draft, head: Head, read: Body, begin: int, what: tuple[list[Token], int, Span]
) -> tuple[Draft, Head, Body] | None:
    """A round along an edge that the words from ``begin`` on name, as it goes on there: the part, its head and body; None where no such edge
    is named, or the part has none, or how many stitches go along it is not said."""
    tokens, times, span = what
    words = p.source.text.text[min(begin, span.start) : span.end].lower()
    owner = _owner(p, draft, words)
    if owner is None or owner.chain is not None or is_first(read, p.source.stitches) or read.refers is not None:
        return None
    if draft.copies not in (1, owner.copies) or not owner.flat:
        return None
    count = base(
        [i for i in read.items if not (isinstance(i, Action) and i.name == "goto")], read.stated, p.source.stitches
    )
    which = _which(words)
    if which is None or not count:
        return None
    rows, chained = owner.last, _chained(owner)
    whole = which == BASE
    if which == SIDE and chained > 2 and _ratio(chained, count) < _ratio(rows, count):
        which = BASE  # "across bottom of jumper": the edge that so many stitches fit
    lead: list[Action] = []
    if whole:
        nth = _NTH.search(words)
        passed = int(nth[1]) - 1 if nth is not None else 0
        if passed + count > chained or "skip" in words:
            return None
        lead = [Action("skip", span, passed)] if passed else []
    again = tried(p.source, tokens, p.palette, count, p.phrases, times)
    if again is None or not again.fit:
        return None
    if _TWO.search(words):
        p.source.doubt(
            "pieces that are held together are worked along the edge of one", "the others lie behind it", head.span
        )
    if owner is not draft:
        p.parts.remove(draft)
        owner.lines += [] if draft.begun() else draft.lines
        owner.offset = owner.last if head.numbers and head.numbers[0] <= owner.last else owner.offset
        head = replace(head, numbers=tuple(n + owner.offset for n in head.numbers))
    p.parts.remove(owner)
    p.parts.append(owner)  # what comes next goes on with it
    owner.leave(p.source)
    again.items[:0] = [Action("edge", head.span, numbers=(0 if whole else count, which)), *lead]
    owner.edge, owner.sure = count, True
    return owner, head, again


def _owner(p: State, draft: Draft, words: str) -> Draft | None:
    """The part whose edge is meant: the one named, or else the one under way or just made."""
    begun = [one for one in p.parts if one.begun()]
    said = re.findall(r"\bof (?:the )?((?:[a-z]+ ?){1,3})", words)
    for name in said:
        at = named([one.name for one in begun], name.strip())
        if at is not None and at >= 0:
            return begun[at]
    return draft if draft.begun() else begun[-1] if begun else None


def _which(words: str) -> int | None:
    """Which edge is meant (:mod:`tambour.crochet.graph.edges`); None where none is, or one that is not known."""
    if _BASE.search(words):
        return BASE
    if _OPENING.search(words):
        return None
    if _BOTH.search(words):
        return SIDES
    return ALL if _ALL.search(words) else SIDE if _SIDE.search(words) else None


def _chained(draft: Draft) -> int:
    """How many stitches the chain has that a part in rows stands on."""
    chain = next((i for line in draft.lines for i in line.items if isinstance(i, Action) and i.name == "ch"), None)
    return 0 if chain is None else chain.times - 1


def _ratio(one: int, other: int) -> float:
    """How many times as large the larger of two numbers is."""
    return max(one, other) / max(1, min(one, other))

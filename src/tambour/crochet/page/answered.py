"""Answered: what a designer's text says already, where ours would say it again, or against her: parts that her rounds work onto another."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Final

from tambour.core.errors import Span
from tambour.crochet.language.finishes import Finish, Placed
from tambour.crochet.places.names import Made, mentions
from tambour.crochet.printed.bases import UNKNOWN
from tambour.crochet.printed.doubts import BESIDE
from tambour.crochet.words.gloss import english

if TYPE_CHECKING:
    from tambour.crochet.page.book import Book

_BEGUN: Final = re.compile(
    r"\b(?:begin|start|work)\w*\b[^.\n]{0,25}\b(?:at|from)\b[^.\n]{0,25}\b(?:top|bottom|nose|snout|muzzle|crown|base|neck|front|back|tip|tail)\b",
    re.IGNORECASE,
)
"""How she says where a part is begun: "Begin at bottom.", "starting from the nose"."""
_ABOVE: Final = 160
"""So many letters before a round that joins two pieces name them."""


def onto(book: Book, record: Finish) -> bool:
    """Whether a part that no sentence places is none that is sewn: its own rounds are worked onto the other, or a round goes through
    both, which was drawn as two pieces beside each other."""
    if book.hers is None or not isinstance(record, Placed) or book.words_of(record):
        return False
    built = book.piece.built
    spots = book.taken.spots.parts
    mine, host = (built.parts[spots[name]].section for name in (record.part, record.spot.part))
    told = [p for p in built.pattern.warnings if p.span is not None]
    own = [line.span for line in built.pattern.parts[mine].lines if line.in_round]
    if any(p.message.startswith(UNKNOWN) and any(meet(p.span, line) for line in own) for p in told if p.span):
        return True
    rounds = [*own, *(line.span for line in built.pattern.parts[host].lines if line.in_round)]
    names = {built.pattern.parts[k].name for k in (mine, host)}
    return any(
        p.span is not None
        and p.message.startswith(BESIDE)
        and any(meet(p.span, line) and names <= _named(book, line) for line in rounds)
        for p in told
    )


def says_way(book: Book, section: int) -> bool:
    """Whether she says at which end a part is begun, or which way it is worked."""
    if book.hers is None or section < 0:
        return False
    pattern = book.piece.built.pattern
    part = pattern.parts[section]
    said = " ".join(words for words, _ in book.hers.inside.get(section, []))
    first = next((line.span.start for line in part.lines if line.in_round), part.span.end)
    head = pattern.text.text[part.span.start : max(part.span.end, first)]
    return "worked from" in said.lower() or any(_BEGUN.search(words) for words in (said, head))


def meet(one: Span | None, other: Span | None) -> bool:
    """Whether two places of the text have a letter in common."""
    return one is not None and other is not None and one.start < other.end and other.start < one.end


def _named(book: Book, line: Span) -> set[str]:
    """The parts that a round names, and the sentence before it."""
    pattern = book.piece.built.pattern
    words = pattern.text.text[max(0, line.start - _ABOVE) : line.end].rpartition("\n\n")[2]
    parts = [Made(part.name, part.copies) for part in pattern.parts]
    return {part.name for m in mentions(english(words, pattern.terms).text.lower(), parts) for part, _ in m.copies}

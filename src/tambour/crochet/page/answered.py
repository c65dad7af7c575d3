"""Answered: what a designer's text says already, where ours would say it again, or against her: parts that her rounds work onto another."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Final

from tambour.core.errors import Span
from tambour.crochet.language.finishes import Finish, Placed
from tambour.crochet.places.assembling import TO
from tambour.crochet.places.names import Made, mentions, one
from tambour.crochet.printed.parts.bases import UNKNOWN
from tambour.crochet.printed.rounds.doubts import BESIDE
from tambour.crochet.words.gloss import english

if TYPE_CHECKING:
    from tambour.crochet.page.book import Book

_BEGUN: Final = re.compile(
    r"\b(?:begin|start|work)\w*\b[^.\n]{0,25}\b(?:at|from|in|with|under)\b[^.\n]{0,25}\b(?:top|bottom|nose|snout|muzzle|crown|base|neck|front(?! loop)|back(?! loop)|tip|tail|floor|foot|feet|toes?|sole|underneath|ground)\b"
    r"|\bfrom (?:the )?(?:top|bottom|nose|crown|neck|tip|base)\b[^.\n]{0,20}\b(?:to|up|down)\b",
    re.IGNORECASE,
)
"""How she says where a part is begun: "Begin at bottom.", "starting from the nose"."""
_MIDDLE: Final = re.compile(
    r"\bstitch\b[^.;]{0,40}\bmiddle of\b|\b(?:beginning|start) of (?:the |each |every )?(?:rounds?|rnds?)\b[^.;]{0,40}\b(?:middle|back|belly|front|side|underneath|bottom)\b"
    r"|\brounds? begins?\b[^.;]{0,40}\b(?:middle|back|belly|front|side|underneath|bottom)\b",
    re.IGNORECASE,
)
"""How she says where on a part its rounds begin."""
_PIECE: Final = re.compile(r"[^.!?;\n]+(?:\n[^.!?;\n]+)*?(?=[.!?;]|\n|$)")
_LETTERS: Final = re.compile(r"[^\W\d_]+")
_JOINS: Final = re.compile(
    r"\b(?:sew|sewn|attach|stitch(?!es)|pin|position|place|secure|whip ?stitch|tack|seam|glue|add|fasten(?! off)|join|tie|put|slip|insert)(?:s|d|ed|ing)?\b"
)
_BOTH: Final = re.compile(r"\b(?:join(?:s|ed|ing)?|unsewn|both (?:layers|thicknesses)|through)\b")
"""Words that put a part on another, or work it there."""
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


def spoken_for(book: Book, record: Finish) -> list[str]:
    """Where sentences of hers put or work a part somewhere that no record of ours came of, those; none where her text is silent."""
    if book.hers is None or not isinstance(record, Placed) or book.words_of(record):
        return []
    built = book.piece.built
    pattern, spots = built.pattern, book.taken.spots.parts
    if said := book.hers.about.get(built.parts[spots[record.part]].section):
        return [words for words, _ in said]
    mine, host = (pattern.parts[built.parts[spots[name]].section] for name in (record.part, record.spot.part))
    noun, onto_ = (
        one(re.sub(r"_\d+$", "", part.name).split()[-1].lower()) if part.name else "" for part in (mine, host)
    )
    heads = [at for part in pattern.parts for at in (part.span, *part.also)]
    below = min((at.start for at in heads if at.start > mine.span.start), default=len(pattern.text.text))
    first = min(at.start for at in heads)  # her materials name pins, and a button for the collar
    for m in _PIECE.finditer(pattern.text.text, first):
        if any(meet(Span(*m.span()), at) for at in heads):
            continue
        low = english(m[0], pattern.terms).text.lower()
        verb = _JOINS.search(low)
        if verb is None:
            continue
        words = {one(word) for word in _LETTERS.findall(low)}
        to = TO.search(low, verb.end())
        put = low if _BOTH.search(low) else low[verb.end() : to.start() if to is not None else len(low)]
        near = mine.span.start - _ABOVE <= m.start() < below
        if (noun and noun in {one(word) for word in _LETTERS.findall(put)}) or (onto_ and near and onto_ in words):
            return [" ".join(m[0].split()).rstrip(".") + "."]
    return []


def says_middle(words: str) -> bool:
    """Whether a sentence of hers says on which side of a part its rounds begin, or which stitch is the middle of one."""
    return _MIDDLE.search(words) is not None


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

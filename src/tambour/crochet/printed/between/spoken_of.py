"""Printed patterns, spoken of: parts that go where such parts usually do though a sentence puts them somewhere, in words that were not followed: it is told there, once."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import TYPE_CHECKING, Final

from tambour.core.errors import Span
from tambour.crochet.language.finishes import Finish, Placed
from tambour.crochet.language.tree import Pattern
from tambour.crochet.places.names import Made, mentions
from tambour.crochet.words.gloss import english

if TYPE_CHECKING:
    from tambour.crochet.printed.state import State

_PIECE: Final = re.compile(r"[^.!?;\n]+(?:\n[^.!?;\n]+)*?(?=[.!?;]|\n|$)")
_PUTS: Final = re.compile(
    r"\b(?:sew|attach|stitch(?!es)|pin|position|place|secure|whip ?stitch|tack|seam|glue|add|fasten(?! off))(?:s|ed|ing)?\b"
)
"""Words that put a part on another."""
_WHERETO: Final = re.compile(
    r"\b(?:to|onto|on|over|at|into|around|between|above|below|under|underneath|behind|along|near|with|using|where|so|by|as|in)\b"
)
"""What is put stands before these."""
_ELSE: Final = re.compile(r"\b(?:closed|shut|together|leav\w+)\b")
"""Sentences that close a piece, or say what for a tail of yarn is left, put nothing."""


def spoken_of(p: State, pattern: Pattern, finish: list[Finish]) -> tuple[dict[str, Span], list[Finish]]:
    """The parts put by guess that a sentence speaks of, and where: the next behind each part's heading; and the finishing with these."""
    free = [f for f in finish if isinstance(f, Placed) and f.span.end <= f.span.start]
    if not free:
        return {}, finish
    made = [Made(part.name, part.copies) for part in pattern.parts]
    starts = {part.name: part.span.start for part in pattern.parts}
    said: list[tuple[Span, set[str]]] = []
    for span in _sentences(p, pattern, finish):
        low = english(pattern.text.text[span.start : span.end], pattern.terms).text.lower()
        verb = _PUTS.search(low)
        if verb is None or _ELSE.search(low):
            continue  # what it says is done to the piece itself
        to = _WHERETO.search(low, verb.end())
        end = to.start() if to is not None else len(low)
        names = {part.name for m in mentions(low, made) if verb.end() <= m.start < end for part, _ in m.copies}
        said += [(span, names)] if names else []
    place = dict[str, Span]()
    for name in dict.fromkeys(_base(f, starts) for f in free):
        mine = [span for span, names in said if name in names]
        behind = [span for span in mine if span.start > starts.get(name, 0)]
        alone = sum(one.words == next(m.words for m in made if m.name == name) for one in made) == 1
        if behind or (mine and alone):
            place[name] = behind[0] if behind else mine[-1]
    return place, [
        replace(f, span=place[name])
        if isinstance(f, Placed) and f in free and (name := _base(f, starts)) in place
        else f
        for f in finish
    ]


def remedy(pattern: Pattern, span: Span) -> str:
    """What to say instead of a sentence that puts something nowhere, of the parts that it names itself."""
    low = english(pattern.text.text[span.start : span.end], pattern.terms).text.lower()
    names = list(
        dict.fromkeys(
            part.name for m in mentions(low, [Made(p.name, p.copies) for p in pattern.parts]) for part, _ in m.copies
        )
    )
    many = {part.name: part.copies > 1 for part in pattern.parts}
    part = next((name for name in names if name), "")
    if not part:
        return "name the part, what it is sewn to, and the round: sew the tail to the body at round 9, in the middle of the back"
    host = next((name for name in names[1:] if name), "") or "the part that it goes on"
    host = host if host.startswith("the ") else f"the {host.lower()}"
    where = ", 8 stitches apart" if many.get(part) else ", in the middle of the front"
    return f"say what it is sewn to, the round and the side: sew the {part.lower()} to {host} between rounds 5 and 6{where}"


def _base(record: Placed, starts: dict[str, int]) -> str:
    """The part that a record's is a copy of."""
    return record.part if record.part in starts else record.part.rpartition(".")[0]


def _sentences(p: State, pattern: Pattern, finish: list[Finish]) -> list[Span]:
    """Sentences behind the first heading that nothing came of, in their order."""
    text, first = pattern.text.text, min((part.span.start for part in pattern.parts), default=0)
    notes = [note for part in pattern.parts for line in part.lines for note in line.notes]
    known = [f.span for f in finish if f.span.end > f.span.start]
    made = dict[int, Span]()
    for span in (*p.passed, *p.left_out, *notes, *(one.span for one in p.sentences)):
        for m in _PIECE.finditer(text, span.start, span.end) if span.start >= first else ():
            begin = m.start() + len(m[0]) - len(m[0].lstrip())
            if not any(s.start < m.end() and begin < s.end for s in known):
                made.setdefault(begin, Span(begin, m.end()))
    return [made[at] for at in sorted(made)]

"""Printed patterns, beyond the rounds: sentences that work along an edge, name asterisks that are not there, or add copies."""

from __future__ import annotations

import re
from dataclasses import replace
from itertools import pairwise
from typing import Final

from tambour.core.errors import Span
from tambour.crochet.language.finishes import GUESSED
from tambour.crochet.language.tree import Action, Line
from tambour.crochet.places.assembling import SCULPTED
from tambour.crochet.places.names import kind_of, one
from tambour.crochet.printed.between.stops import starts
from tambour.crochet.printed.cursor import Refers
from tambour.crochet.printed.heads import STARS
from tambour.crochet.printed.parts.copied import copies_of, once_more
from tambour.crochet.printed.parts.hued import dealt
from tambour.crochet.printed.parts.naming import named
from tambour.crochet.printed.rounds.moved import along_edge
from tambour.crochet.printed.rounds.reader import Body
from tambour.crochet.printed.state import State
from tambour.crochet.printed.tokens import Token
from tambour.crochet.printed.yarns.colors import numbered
from tambour.crochet.words.table import TERMS

EDGED: Final = "this goes along an edge that is no round's: it is not drawn"


def marked(p: State, refers: Refers) -> Refers:
    """A reference to asterisks ("from ** to ** as given for Left Wing") that are not both there: what stands for them, which is told."""
    if refers.marks is None or any(draft.between(refers.marks) is not None for draft in p.parts):
        return refers
    here = [k for k, draft in enumerate(p.parts) if any(stars == refers.marks[0] for stars, _ in draft.marks)]
    at = named([draft.name for draft in p.parts], refers.part) if refers.part else (here or [len(p.parts) - 1])[-1]
    origin = p.parts[at] if at is not None and 0 <= at < len(p.parts) else None
    if origin is None:
        return refers
    pairs = [(a, b) for (a, _), (b, _) in pairwise(origin.marks)]
    begun = next((k for k, (stars, _) in enumerate(origin.marks) if stars == refers.marks[0]), None)
    if begun is not None and begun + 1 < len(origin.marks):
        found = replace(refers, marks=(refers.marks[0], origin.marks[begun + 1][0]))
    elif len(pairs) == 1 and begun is None:
        found = replace(refers, marks=pairs[0])
    elif begun is not None:
        at = origin.marks[begun][1]
        first = origin.lines[at].number if at < len(origin.lines) else None
        if first is None:
            return refers
        back = next((k for k, line in enumerate(origin.lines) if k > at and _goes_back(line)), None)
        ends = origin.lines[back].number if back is not None and origin is p.parts[-1] else None
        last = ends - 1 if ends is not None else origin.last  # "Join A to skipped sts …": what is meant ends before
        found = replace(refers, marks=None, part=origin.name, numbers=tuple(range(first, last + 1)))
    elif refers.part:
        after = _next_number(p)
        found = replace(
            refers, marks=None, through=after - 1 if after and 1 < after <= origin.last + 1 else origin.last
        )
    else:
        return refers
    p.source.doubt("these asterisks are not both there: what seems meant is taken", "name the rounds", refers.span)
    return found


def _goes_back(line: Line) -> bool:
    """Whether a round goes back to an edge that was left."""
    return any(isinstance(i, Action) and i.name == "goto" for i in line.items)


def _next_number(p: State) -> int:
    """The number of the round that comes next, 0 where none does."""
    for row in p.rows[p.row_at + 1 : p.row_at + 6]:
        if row.tokens:
            found = p.vocabulary.heads(row.tokens)
            return found[0][1].numbers[0] if found and found[0][1].numbers else 0
    return 0


def edging(p: State, tokens: list[Token]) -> bool:
    """Whether a sentence between the rounds works along an edge that is no round's, in whatever words: that is told as not drawn."""
    stitches = sum(t.kind == "stitch" and t.value not in ("ch", "slst", "skip") for t in tokens)
    slipped = tokens[0].value != "join" and any(
        t.value == "slst" and any(u.word in ("across", "along") for u in tokens[k + 1 :]) for k, t in enumerate(tokens)
    )  # "sl st loosely in front loops across handle"
    said = p.source.text.text[tokens[0].start : tokens[-1].end].lower()
    if not p.parts or not (stitches or slipped) or not along_edge(tokens) or SCULPTED.search(said):
        return False
    not_drawn(p, Span(tokens[0].start, tokens[-1].end))
    return True


def along(p: State, body: Body, tokens: list[Token]) -> bool:
    """A sentence that works along an edge ("Work 1 row of sc up right side of Ear"): read, and told as not drawn."""
    if body.left or not p.parts:
        return False
    not_drawn(p, Span(tokens[0].start, tokens[-1].end))
    return True


def not_drawn(p: State, span: Span) -> None:
    """Tells of an edge that is no round's."""
    p.source.doubt(EDGED, "give it a round of its own", span)
    p.edged = True


def edged_again(p: State, tokens: list[Token], edged: bool) -> bool:
    """Whether a sentence has an edge worked once more that the one before it worked ("Rep for joining second piece"): told as that was."""
    if not edged or not repeats_for(tokens, ("for", "in", "to", "with", "around", "as", "each")):
        return False
    not_drawn(p, Span(tokens[0].start, tokens[-1].end))
    return True


def more_copies(p: State, tokens: list[Token], more: tuple[int, Span, bool]) -> bool:
    """Takes "Make 2 with A and 1 with B" for the part that is headed, or else for the one just made; whether there is one, and no
    other is named ("make 1 flower each with B and C")."""
    count, span, added = more
    name = p.heading.name if p.heading is not None else p.parts[-1].name if p.parts else ""
    end = next((k for k, t in enumerate(tokens) if t.kind == "key" and t.value in ("with", "each", "in", "for")), 0)
    nouns = [t for t in tokens[1:end] if t.kind == "word" and (kind := kind_of(one(t.word))) is not None and kind]
    own = {one(w) for w in name.lower().replace("_", " ").split()}
    if name and nouns and not any(one(t.word) in own for t in nouns):
        return False
    if (
        p.heading is None
        and not p.parts
        and p.mode == ""
        and all(t.kind == "mark" or t.word in _ALIKE or t.value in ("make", count, "same", "each") for t in tokens)
    ):
        p.early |= {"copies": count, "copies_span": span}  # "(Make 2 pieces alike). Ch 11."
        return True
    if p.heading is not None:
        if (hues := dealt(p, tokens, None)) and sum(hue.count for hue in hues) == count:
            p.hued[p.heading.span.start] = hues
        p.heading = replace(p.heading, copies=count, copies_span=span, strong=True)
    elif p.parts:
        draft = p.parts[-1]
        hues = dealt(p, tokens, draft if added else None)
        if hues and sum(hue.count for hue in hues) == (draft.copies + count if added else count):
            p.hued[draft.span.start] = hues
        draft.copies, draft.copies_span = draft.copies + count if added else max(draft.copies, count), span
    return p.heading is not None or bool(p.parts)


def tallied(p: State, line: str, span: Span) -> bool:
    """Whether a line of a list says how many of a part are made in which yarns: "Motif 1: Make 6 using A as Color 1; B as Color 2". That is
    remembered."""
    found = _TALLY.match(line) if not p.parts else None
    if found is None:
        return False
    noun = one(found[1].lower())
    p.tally[noun] = p.tally.get(noun, 0) + int(found[2])
    numbered(p.palette, line)
    p.passed.append(span)
    return True


def repeats_for(tokens: list[Token], after: tuple[str, ...]) -> bool:
    """Whether a sentence has something done again that it does not name by rounds: "Repeat for second ear"."""
    if len(tokens) < 2 or not (tokens[0].kind == "key" and tokens[0].value == "repeat"):
        return False
    again = tokens[1].kind == "key" and tokens[1].value in after
    return again and not any(
        t.kind == "stitch"
        or t.word in ("*", *STARS)
        or (t.kind == "key" and t.value in ("round", "row", "times", "more", "last"))
        for t in tokens
    )


def another(tokens: list[Token]) -> bool:
    """Whether a sentence has what was just done by hand done once more: "repeat for 2nd tire", "repeat on other side"."""
    other = any(t.word in _OTHER or t.value in ("other", 2) for t in tokens[2:])
    return other and repeats_for(tokens, ("for", "in", "to", "with"))


def twin_made(p: State, tokens: list[Token]) -> bool:
    """Takes "Repeat for second arm opening" for another copy of the part just made where that is an arm, made once, and the only one."""
    if not p.parts or p.heading is not None or p.parts[-1].copies > 1 or not repeats_for(tokens, ("for", "in", "with")):
        return False
    words = [{one(w) for w in d.name.lower().replace("_", " ").split()} for d in p.parts]
    nouns = {one(t.word) for t in tokens[2:] if t.kind == "word" and kind_of(one(t.word))}
    second = any(t.word in _OTHER or t.value in ("other", 2) for t in tokens[2:])
    if not second or not nouns & words[-1] or any(nouns & w for w in words[:-1]):
        return False
    return again_made(p, tokens)


def again_made(p: State, tokens: list[Token]) -> bool:
    """Takes "Repeat for other legs" for copies of the part just made, and "Repeat on other armhole" for an edge that is worked once
    more, which is told; whether a sentence is either."""
    if p.parts and (_made_twice(p, tokens) or _twin(p, tokens)):
        return True
    if not p.parts or not repeats_for(tokens, ("for", "in", "to", "with", "around")):
        return False
    draft, rest = p.parts[-1], tokens[2:]
    others = [
        t
        for t in rest
        if (t.kind == "key" and (t.value in ("other", "rest") or t.word == "other side"))
        or t.word in _OTHER
        or t.value == 2
    ]
    if not others:
        return False
    noun = next((t.word for t in rest if t.kind in ("word", "key") and t not in others and t.word != "make"), "")
    span = Span(tokens[0].start, tokens[-1].end)
    side = rest[0] in others and rest[0].word == "other side"
    if noun and not side and one(noun) in {one(w) for w in draft.name.lower().replace("_", " ").split()}:
        many = 4 if noun != one(noun) and kind_of(one(noun)) == "leg" else 2
        if draft.copies < many:
            draft.copies, draft.copies_span = many, span
            if many > 2:
                p.source.doubt(f"{GUESSED}: {many} of {draft.name} are made", "say how many: (make 4)", span)
        return True
    if any(one(t.word.split()[-1]) in _EDGE for t in rest):
        not_drawn(p, span)
        return True
    return False


def once_again(p: State, tokens: list[Token]) -> bool:
    """Takes "Create another one" for one copy more, of which others would read "make one"; whether it is such."""
    text = p.source.text.text
    said = text[starts(text, tokens[0].start) : tokens[-1].end]
    return (
        tokens[0].value != "repeat"
        and _OTHERS.search(said) is not None
        and (_made_twice(p, tokens) or _twin(p, tokens))
    )


def _twin(p: State, tokens: list[Token]) -> bool:
    """Takes "Do the same for the second ear", "Make 2 of these" below a part's rounds for copies of it."""
    draft, heard = p.parts[-1], TERMS[p.language.code].heard
    said = p.source.text.text[p.source.text.text.rfind("\n", 0, tokens[0].start) + 1 : tokens[0].start]
    if p.heading is not None or not draft.last or ";" in said[said.rfind(".") + 1 :]:
        return False  # "The brim is like this; work it twice."
    name = frozenset(w for word in draft.name.lower().replace("_", " ").split() for w in (word, one(word), f"{word}s"))
    several = {f"{one(word)}s" for word in name}  # "Repeat for the other legs" are more than two
    begin = starts(p.source.text.text, tokens[0].start)
    raw = [
        t for row in p.rows[p.row_at : p.row_at + 2] for t in row.tokens if begin <= t.start and t.end <= tokens[-1].end
    ]
    span = Span(begin, tokens[-1].end)
    if many := copies_of(raw, heard, name):
        draft.copies, draft.copies_span = max(draft.copies, many), span
    elif once_more(raw, heard, name, draft.last) and not any(t.word in several for t in raw):
        draft.copies, draft.copies_span = max(draft.copies, 2), span
    else:
        return False
    return True


def _made_twice(p: State, tokens: list[Token]) -> bool:
    """Takes "Make another ear.", "Make a second one the same way" for one copy more of the part it names, or else of the one just made."""
    said = _ANOTHER.match(p.source.text.text, starts(p.source.text.text, tokens[0].start))
    draft = p.parts[-1]
    if said is None or not draft.begun():
        return False
    noun = one((said["noun"] or "").lower())
    noun = "" if noun in ("one", "piece") else noun
    names = [{one(w) for w in d.name.lower().replace("_", " ").split()} for d in p.parts]
    if noun:
        meant = next((k for k in range(len(names) - 1, -1, -1) if noun in names[k]), None)
        if meant is None:
            return False
        draft = p.parts[meant]
    if said["on"] and not said["more"] and (not noun or names[p.parts.index(draft)] != {noun}):
        return False  # "LEGS AND BODY": of what goes on with the second, a body is no more than one
    counted = draft.copies_span is not None and draft.copies > 1  # "Arms (2)", and "Make the second arm the same way"
    many = max(draft.copies, 2) if counted or _SECOND.search(said[0]) else draft.copies + 1
    draft.copies, draft.copies_span = many, Span(tokens[0].start, tokens[-1].end)
    return True


_OTHERS: Final = re.compile(r"\b(?:another|second|2nd|other)\b", re.IGNORECASE)
_SECOND: Final = re.compile(r"\b(?:second|2nd)\b", re.IGNORECASE)
_TALLY: Final = re.compile(r"([A-Z][a-z]+) (?:\d|[A-Z]) ?[:–-] ?[Mm]ake (\d{1,2})\b(?=.*\b(?:using|with|in)\b)")
_ANOTHER: Final = re.compile(
    r"(?:(?:now|then|and)\s+)*(?:make|work|crochet|do|create)\s+(?:(?P<more>another)|(?:a|the)\s+(?:second|2nd))(?:\s+(?P<noun>[A-Za-z]+))?"
    r"(?:,?\s+(?:(?:exactly|just)\s+)?(?:alike|the\s+same|(?:in\s+)?the\s+same\s+(?:way|manner)|like\s+(?:it|this|the\s+first)(?:\s+one)?))?"
    r"(?P<on>,?\s+(?:(?:but|and|this\s+time)\s+)*(?:do\s+not|don['’]t|without)\s+(?:finish|fasten|cut|break)(?:ing)?(?:\s+(?:it|off|the|your|yarn))*)?\s*(?:[.!;]|$)",
    re.IGNORECASE | re.MULTILINE,
)
_ALIKE: Final = frozenset(("alike", "exactly", "pieces", "of", "the", "these"))
_OTHER: Final = frozenset(("second", "opposite", "remaining", "rem"))
_EDGE: Final = frozenset(("armhole", "side", "edge", "end", "corner", "strap", "opening"))

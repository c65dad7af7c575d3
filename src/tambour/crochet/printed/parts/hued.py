"""Printed patterns, hued: copies of several colours ("make 3: 2 fuchsia, 1 yellow"), and those that are two layers of one thing."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from typing import Final

from tambour.core.errors import Span
from tambour.core.rgb import RGB
from tambour.crochet.graph.built import Built
from tambour.crochet.graph.spots import spots_in
from tambour.crochet.language.finishes import Placed, Spot
from tambour.crochet.language.tree import Action, Line, Pattern, Section
from tambour.crochet.places.names import kind_of, one
from tambour.crochet.printed.cursor import Cursor
from tambour.crochet.printed.parts.part import Draft
from tambour.crochet.printed.sheet.notes import plain_name
from tambour.crochet.printed.state import State
from tambour.crochet.printed.tokens import Token
from tambour.crochet.printed.yarns.colors import LETTERS

_BETWEEN: Final = frozenset((",", "and", "&", "+", ";", "/"))
_LED: Final = frozenset(("in", "of", "with", "using"))
_MANY: Final = 60
_FLAT: Final = 4
"""A circle has so many stitches for every round, or more."""
_LAYERED: Final = frozenset(("ear", "wing", "leaf", "fin", "foot", "tail", "bow"))
"""Kinds of things that are sewn together of two layers."""
_TOGETHER: Final = re.compile(
    r"\b(?:through|thru) both\b|\bboth (?:layers|pieces|circles)\b|\b(?:a|one|each) \w+(?: \w+)? (?:and|on|onto|to|with|on top of) (?:a|one)\b[^.]{0,40}\b"
    r"(?:together|circle|piece|ear|wing|one)\b|\binner\b[^.]{0,60}\bouter\b|\bouter\b[^.]{0,60}\binner\b|\bin pairs\b",
    re.IGNORECASE,
)


@dataclass(frozen=True)
class Hue:
    """So many copies in one colour, as it is called."""

    count: int
    words: str
    shade: RGB


def hued(p: State, tokens: list[Token]) -> tuple[list[Token], tuple[Hue, ...]]:
    """The words of a heading with its copies as one number, and their colours; the words as they are where it says none.

    "Flower (make 3: 2 fuchsia, 1 yellow)", "EARS (make 2 in grey and 2 in pink)", "EAR (make 2 in pink and purple)".
    """
    make = next((k for k, t in enumerate(tokens) if t.value == "make"), None)
    if make is None or not make or any(t.kind == "stitch" for t in tokens):
        return tokens, ()
    c, at, found, plain, dealt_out = Cursor(tokens), make + 1, list[Hue](), False, False
    versions = any(t.value == "for" or t.word == "for" for t in tokens)  # "1 with A and 1 with B for Cat" are a pair
    total = tokens[at] if at < len(tokens) and tokens[at].kind == "number" else None
    if total is not None and at + 1 < len(tokens) and tokens[at + 1].word in (":", "-", ",", "("):
        at += 2
    else:
        total = None
    while at < len(tokens) and tokens[at].kind == "number" and isinstance(tokens[at].value, int):
        count, at = tokens[at].value, at + 1
        if at < len(tokens) and tokens[at].word == "each":
            each, at = _each(p, tokens, at + 1, count)
            found += each
            continue
        led = at < len(tokens) and tokens[at].word in _LED
        at += led
        shade = p.palette.color(c, at) or (p.palette.letter(c, at) if led and not versions else None)
        if shade is None and total is not None:  # "make 5: 3 large, 2 small"
            end = next((k for k in range(at, len(tokens)) if tokens[k].word in _BETWEEN or tokens[k].word in ")]"), at)
            shade, plain = ((0, 0, 0), end - at), True
        if shade is None or not shade[1]:
            return tokens, ()
        each, after = _each(p, tokens, at, 1)
        if led and len(each) == count > 1 and all(p.palette.name(hue.words) for hue in each):
            found, at = [*found, *each], after  # "make 2 in pink and purple": one of each
            dealt_out = True
        else:
            found.append(Hue(count, _called(tokens[at : at + shade[1]]), shade[0]))
            at += shade[1]
        while at < len(tokens) and (tokens[at].word in _BETWEEN or tokens[at].value in ("yarn", "and", "make")):
            at += 1
    many = sum(hue.count for hue in found)
    pair = all(hue.count == 1 for hue in found) and not any(p.palette.name(hue.words) for hue in found)
    if pair or len(found) < 2 or not 2 <= many <= _MANY or (total is not None and total.value != many):
        return tokens, ()
    number = replace(tokens[make + 1], word=str(many), value=many)
    if dealt_out:
        hint = "say how many of each: (make 1 in pink and 1 in purple); or in which rounds the yarn changes"
        said = "this can be read as one in each yarn, or as all in both: one in each is made"
        p.source.doubt(said, hint, Span(tokens[make].start, tokens[-1].end))
    return [*tokens[: make + 1], number, *tokens[at:]], () if plain else tuple(found)


def _each(p: State, tokens: list[Token], at: int, count: int) -> tuple[list[Hue], int]:
    """As many copies in each of the yarns that are listed at ``at``, "2 each with A, B, and C", and where the list ends."""
    c, found = Cursor(tokens), list[Hue]()
    at += at < len(tokens) and tokens[at].word in _LED
    while at < len(tokens) and (shade := p.palette.color(c, at) or p.palette.letter(c, at)) is not None and shade[1]:
        found.append(Hue(count, _called(tokens[at : at + shade[1]]), shade[0]))
        at += shade[1]
        while at < len(tokens) and (tokens[at].word in _BETWEEN or tokens[at].value == "and"):
            at += 1
    return found, at


def _called(tokens: list[Token]) -> str:
    """A yarn as its copies are called by it: "yellow", "B", "CC"."""
    return " ".join(t.word.upper() if t.word in LETTERS else t.word for t in tokens)


def dealt(p: State, tokens: list[Token], added: Draft | None) -> tuple[Hue, ...]:
    """The yarns of the copies that a sentence deals out, "Make 1 with A and 2 with B", "Make 2 pieces each CA and CB", and says nothing
    else; where they come to those of a part made already (``added``), its own first. None of them for another sentence."""
    tokens = [t for t in tokens if t.word not in ("(", ")", "[", "]", ".")]
    c, at, found = Cursor(tokens), 0, list[Hue]()
    while at < len(tokens):
        at += tokens[at].value == "make"
        if at >= len(tokens) or tokens[at].kind != "number" or not isinstance(tokens[at].value, int):
            return ()
        count, at = int(tokens[at].value), at + 1
        led = next((k for k in range(at, min(at + 4, len(tokens))) if tokens[k].word in (*_LED, "each")), None)
        if led is None or any(t.kind == "number" or t.word == "," for t in tokens[at:led]):
            return ()
        if tokens[led].word == "each":
            each, at = _each(p, tokens, led + 1, count)
            found += each
            if not each:
                return ()
            continue
        shade = p.palette.letter(c, led + 1) or p.palette.color(c, led + 1)
        if shade is None or not shade[1]:
            return ()
        found.append(Hue(count, _called(tokens[led + 1 : led + 1 + shade[1]]), shade[0]))
        at = led + 1 + shade[1]
        while at < len(tokens) and (tokens[at].word in _BETWEEN or tokens[at].value == "and"):
            at += 1
    if added is None:
        return tuple(found) if len(found) > 1 else ()
    own = next((i.numbers for n in added.lines for i in n.items if isinstance(i, Action) and i.name == "color"), None)
    letter = next((x for x, hue in p.palette.given.items() if hue == own and x in LETTERS), "")
    if not letter:
        return ()
    mine = p.palette.given[letter]
    many = added.copies + sum(hue.count for hue in found if hue.shade == mine)
    return (Hue(many, letter.upper(), mine), *(hue for hue in found if hue.shade != mine))


def by_hue(section: Section, hues: tuple[Hue, ...]) -> list[Section]:
    """A part of the text as one part for each of its colours."""
    if not hues:
        return [section]
    first = next((k for k, line in enumerate(section.lines) if line.in_round), len(section.lines))
    lead = [line for line in section.lines[:first] if not _dyes(line)]
    made = []
    for k, hue in enumerate(hues):
        name = plain_name(f"{hue.words} {section.name}")
        color = Line((Action("color", section.span, 1, None, hue.shade),), section.span, False)
        lines = (color, *lead, *section.lines[first:])
        named = name.upper() if section.name.isupper() else name
        made.append(replace(section, name=named, copies=hue.count, lines=lines, heading=section.name, twin=k > 0))
    return made


def _dyes(line: Line) -> bool:
    return all(isinstance(i, Action) and i.name == "color" for i in line.items) and bool(line.items)


def layered(built: Built) -> list[Placed]:
    """Records of copies that lie on those of another colour, the second on the first, where the text works or sews both together."""
    pattern: Pattern = built.pattern
    text, spots, made = pattern.text.text, spots_in(built), list[Placed]()
    starts = sorted({p.span.start for p in pattern.parts})
    for under, over in zip(pattern.parts, pattern.parts[1:]):
        kind = next((kind_of(one(w)) for w in reversed(re.findall(r"[^\W\d_]+", under.heading.lower()))), "")
        if not over.twin or under.twin or kind not in _LAYERED or under.copies != over.copies:
            continue
        end = next((k for k in starts if k > under.span.start), len(text))
        if not _TOGETHER.search(text[under.span.start : end]):
            continue
        for k in range(1, under.copies + 1):
            names = [p.name if p.copies == 1 else f"{p.name}.{k}" for p in (over, under)]
            last = max(spots.rounds_of(spots.parts[names[1]]), default=0)
            at = spots.round_at(spots.parts[names[1]], last)
            counts = [
                len(spots.stitches(r))
                for n in spots.rounds_of(spots.parts[names[1]])
                if (r := spots.round_at(spots.parts[names[1]], n)) is not None
            ]
            flat = (
                bool(counts) and counts[-1] == max(counts) and counts[-1] >= _FLAT * len(counts)
            )  # of tubes nothing is seen but one
            if last and at is not None and flat:
                spot = Spot(names[1], float(last), None, Span(under.span.start, under.span.end))
                made.append(Placed(names[0], spot, by=float(last), through=len(spots.stitches(at)), span=spot.span))
    return made

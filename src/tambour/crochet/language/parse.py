"""Pattern text → Pattern: line by line, so that all mistakes of a file are found at once."""

from __future__ import annotations

import re
from dataclasses import dataclass, field, replace
from typing import Any

from tambour.core.errors import Span, TambourError, Text, did_you_mean
from tambour.crochet.language.define import define
from tambour.crochet.language.finishes import check_names, is_finish, read_finish
from tambour.crochet.language.grammar import read_line, without_comment
from tambour.crochet.language.items import items
from tambour.crochet.language.source import Source
from tambour.crochet.language.stitches import RULES, STARTS, STUFFING, UPS, standard
from tambour.crochet.language.tree import Action, Again, Item, Line, Pattern, Section, written

# The older dialect's blocks that say where a ring lies.
_BLOCK = re.compile(r"[ \t]*[A-Za-z_]\w*[ \t]*\{[ \t]*$")
_PLACE = re.compile(r"[ \t]*[A-Za-z_]\w*[ \t]*=[ \t]*-?[\w.]+[ \t]*,?[ \t]*$")
# Four words or more and nothing else: a comment that was wrapped.
_PROSE = re.compile(r"[ \t]*[A-Za-z][A-Za-z'-]*(?:[ \t]+[A-Za-z][A-Za-z'-]*){3,}[ \t]*[.!]?[ \t]*$")
_AGAIN = re.compile(
    r"[ \t]*(?P<head>R\d{1,6}(?:[ \t]*-[ \t]*R?\d{1,6})?)[ \t]*:[ \t]*(?P<lead>(?:[^\n]*?,[ \t]*)?)as[ \t]+R(?P<first>\d{1,6})"
    r"(?:[ \t]*-[ \t]*R?(?P<last>\d{1,6}))?(?:[ \t]+of[ \t]+(?P<part>[\w ]+?))?[ \t]*(?:\((?P<count>\d{1,9})\))?[ \t]*$"
)
_TRUTH = {"true": True, "yes": True, "1": True, "false": False, "no": False, "0": False}


def parse(text: Text, *, max_stitches: int = 200_000, strict: bool = False) -> Pattern:
    """The pattern that ``text`` says (docs/crochet-language.md).

    max_stitches : the most nodes it may make; checked when it is built
    strict : doubts about stated numbers are errors

    Raises TambourError with every problem of the text.
    """
    source = Source(text, strict)
    sections = _read(source)
    check_names(source, {part.name: part.copies for part in sections}, source.finish)
    if not any(line.items for section in sections for line in section.lines):
        source.doubt("the pattern is empty", "begin with a magic ring: a line such as : MR(6)", Span(0, 0))
    errors = [p for p in source.problems if not p.warning]
    if errors:
        raise TambourError(sorted(errors, key=lambda p: p.span.start if p.span else 0))
    return Pattern(
        text, sections, source.stitches, source.own, tuple(source.problems), max_stitches, tuple(source.finish)
    )


@dataclass
class _Draft:
    """A part while it is read: parameter → its value, the value's place and its own."""

    name: str = ""
    span: Span = field(default_factory=lambda: Span(0, 0))
    copies: int = 1
    copies_span: Span | None = None
    lines: list[Line] = field(default_factory=list)
    parameters: dict[str, tuple[str, Span, Span]] = field(default_factory=dict)


def _read(source: Source) -> tuple[Section, ...]:
    """Every line of the text, into parts."""
    drafts = [_Draft()]
    commented = block = False
    for whole in source.text.text.split("\n"):
        line = without_comment(whole.rstrip("\r"))
        start = source.offset
        span = Span(start + len(line) - len(line.lstrip()), start + len(line.rstrip()))
        blank = not line.strip()
        if block:
            block = line.strip() != "}"
            if block and not blank and not _PLACE.match(line):
                source.error("this does not fit in a block of places", "lines such as x = 7, and a } after them", span)
        elif _BLOCK.match(line):
            block = True
            source.doubt("places of rings are not used", "a ring finds its own place: leave the block out", span)
        elif is_finish(line):
            finish = read_finish(source, line, span)
            source.finish += [finish] if finish is not None else []
        elif commented and _PROSE.match(line) and not _known(source, line):
            source.doubt("this reads as the comment above, continued", "begin it with #", span)
        elif not blank:
            _line(source, drafts, line, span)
        commented = whole.lstrip().startswith("#") or (commented and not blank)
        source.offset += len(whole) + 1
    if block:
        end = len(source.text.text.rstrip())
        source.error("a block of places is not closed", "a line with } ends it", Span(max(0, end - 1), end))
    if len(drafts) > 1 and all(isinstance(i, Action) and i.name == "color" for d in drafts[0].lines for i in d.items):
        # Nothing is worked before the first header: what is set there holds for every part.
        for draft in drafts[1:]:
            draft.parameters = {**drafts[0].parameters, **draft.parameters}
        drafts[0].parameters = {}
    full = [d for d in drafts if d.name or d.lines or d.parameters]
    return tuple(_section(source, draft) for draft in full or drafts)


def _line(source: Source, drafts: list[_Draft], line: str, span: Span) -> None:
    if (found := _AGAIN.match(line)) is not None:
        _again(source, drafts, found, span)
        return
    tree, problems = read_line(line, source.offset, source.text)
    source.problems += problems
    if tree is None:
        return
    what: Any = tree.children[0]
    match what.data:
        case "header":
            _header(source, drafts, what)
        case "parameter":
            key, value = what.children
            name = key.lower()
            if name in drafts[-1].parameters:
                source.error(f'"{key}" is given twice in this part', "keep one of the two", source.span(key))
            drafts[-1].parameters[name] = (str(value), source.span(value), source.span(key))
        case "definition":
            define(source, what, span)
        case "round":
            drafts[-1].lines.append(_round(source, what, span))
        case _:
            drafts[-1].lines.append(Line(items(source, what.children[0], False), span, False))


def _again(source: Source, drafts: list[_Draft], found: re.Match[str], span: Span) -> None:
    """``R6-R8: as R2-R4 of Head (18)``: rounds that are written elsewhere."""
    at = Span(source.offset + found.start("head"), source.offset + found.end("head"))
    number, times = _range(source, found["head"], at)
    first, last = int(found["first"]), int(found["last"] or found["first"])
    name = (found["part"] or "").strip()
    draft = next((d for d in drafts if d.name == name), None) if name else drafts[-1]
    named = Span(source.offset + found.start("first"), source.offset + found.end("last" if found["last"] else "first"))
    lines = written(draft.lines if draft is not None else (), first, last)
    if not lines:
        source.error("there are no such rounds before this", "name rounds and a part that stand before", named)
        return
    lead: tuple[Item, ...] = ()
    if found["lead"]:
        tree, problems = read_line(
            ": " + found["lead"].rstrip(" ,"), source.offset + found.start("lead") - 2, source.text
        )
        source.problems += problems
        inner: Any = tree.children[0] if tree is not None else None
        if inner is not None and inner.data == "round":
            lead = next((items(source, c, True) for c in inner.children if getattr(c, "data", "") == "items"), ())
    stated = int(found["count"]) if found["count"] else None
    counted = Span(source.offset + found.start("count"), source.offset + found.end("count")) if stated else None
    again = Again(lines, first, last, name, named)
    drafts[-1].lines.append(Line(lead, span, True, times, at, number, stated, counted, again))


def _known(source: Source, line: str) -> bool:
    """Whether a line of plain words is made of stitches and actions only."""
    return all(standard(w) in source.stitches or standard(w) in RULES for w in re.findall(r"[A-Za-z]+", line))


def _header(source: Source, drafts: list[_Draft], tree: Any) -> None:
    names = [t for t in tree.children if t.type == "NAME"]
    draft = _Draft(" ".join(names), source.span(names[0], names[-1]))
    if any(d.name == draft.name for d in drafts):
        hint = "give each part its own name; (make 2) makes copies"
        source.error(f'there is a part "{draft.name}" already', hint, draft.span)
    for token in tree.children:
        if token.type == "INT":
            draft.copies, draft.copies_span = source.number(token)
            if draft.copies == 0:
                source.error("a part is made at least once", "leave the part out instead", draft.copies_span)
    source.copies, source.last_number = max(draft.copies, 1), None
    drafts.append(draft)
    source.part += 1


def _section(source: Source, draft: _Draft) -> Section:
    """The part with its parameters understood."""
    plain = Section(draft.name, draft.span, tuple(draft.lines), max(draft.copies, 1), draft.copies_span)
    other: dict[str, str] = {}
    found: dict[str, Any] = {}
    stands: dict[str, tuple[float, float]] = {}
    for key, (value, at, name) in draft.parameters.items():
        word = value.lower()
        if key == "centroids":
            if re.fullmatch(r"\d{1,6}", value):
                found[key] = int(value)
            else:
                source.error(f'"{value}" is no number of centroids', "a whole number, 0 or more", at)
        elif key == "stuffing":
            if word in STUFFING:
                found[key] = STUFFING[word]
            elif re.fullmatch(r"\d{1,3}(\.\d+)?", value):
                found[key] = float(value)
            else:
                source.error(f'"{value}" is no amount of stuffing', f"one of {', '.join(STUFFING)}, or a factor", at)
        elif key == "initializer":
            if word in STARTS:
                found[key] = STARTS[word]
            else:
                known = did_you_mean(word, STARTS) or "rounds or one-by-one"
                source.error(f'"{value}" is no way to begin', known, at)
        elif key == "up":
            if word in UPS:
                found[key] = word
            else:
                hint = (
                    "start or end: the one that is on top; side: it lies, its start ahead; back: it lies, its end ahead"
                )
                source.error(f'"{value}" is no end of the work', hint, at)
        elif key == "hollow":
            if (pair := re.fullmatch(r"(\d{1,6})(?:-(\d{1,6}))?", value)) and int(pair[1]) <= int(pair[2] or pair[1]):
                found[key], found["hollow_span"] = (int(pair[1]), int(pair[2] or pair[1])), at
            else:
                hint = "the numbers of the rounds that are pushed inside, such as 13-17"
                source.error(f'"{value}" are no rounds', hint, at)
        elif key in ("top", "front"):
            if pair := re.fullmatch(r"(\d{1,6})-(\d{1,6})", value):
                stands[key], found["stands_span"] = (float(pair[1]), float(pair[2])), at
            else:
                hint = "the number of a round, and of a stitch in it, such as 22-14"
                source.error(f'"{value}" is no stitch', hint, at)
        elif key == "tip_from_fo":
            if word in _TRUTH:
                found[key] = _TRUTH[word]
            else:
                source.error(f'"{value}" is neither true nor false', "true: FO closes the edge; false: not", at)
        else:
            other[key] = value
            source.doubt(
                f'the parameter "{key}" has no effect',
                "known: centroids, stuffing, initializer, up, top, front, hollow",
                name,
            )
    if len(stands) == 1:
        hint = "@top and @front, each a round and a stitch in it: as it stands, that is on top, and that in front"
        source.doubt("half of how it stands is said, which has no effect", hint, found["stands_span"])
    elif stands:
        found["stands"] = stands["top"], stands["front"]
    return replace(plain, other=other, **found)


def _round(source: Source, tree: Any, span: Span) -> Line:
    times, at, number, stated, stated_at, note = 1, None, None, None, None, None
    worked: tuple[Item, ...] = ()
    for child in tree.children:
        kind = getattr(child, "type", None) or child.data
        if kind == "RANGE":
            at = source.span(child)
            number, times = _range(source, str(child), at)
        elif kind == "before":
            times, at = source.number(child.children[0])
            if times == 0:
                source.doubt("a round worked no times is left out", "give it a number, or no number", at)
        elif kind == "items":
            last = source.last_number
            worked = items(source, child, True)
            if number is not None:  # a ring in this round begins a piece of work, with this number
                source.last_number = last
        elif kind == "count":
            stated, stated_at = source.number(child.children[0])
        elif kind == "note":
            note = source.number(child.children[1])
    if note and note[0] != times:
        message = f"{note[0]} rounds are said here, {times} at the line's start"
        source.doubt(message, "make them agree", note[1], True)
    return Line(worked, span, True, times, at, number, stated, stated_at)


def _range(source: Source, word: str, at: Span) -> tuple[int, int]:
    """The first number and how many rounds ``R3`` or ``R3-R5`` is; numbers that do not follow are doubted."""
    numbers = [int(n) for n in re.findall(r"\d+", word)]
    first, last = numbers[0], numbers[-1]
    if len(numbers) == 2 and last <= first:
        hint = f"write R{min(numbers)}-R{max(numbers) + (first == last)}"
        source.error(f"the range {word} does not rise", hint, at)
        return first, 1
    before, source.last_number = source.last_number, last
    if before is not None and first not in (1, before + 1):
        said = "is there already" if first <= before else "leaves rounds out"
        source.doubt(f"round {first} {said}: the one before is {before}", f"{before + 1} would follow", at, True)
    return first, last - first + 1

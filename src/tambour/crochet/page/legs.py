"""Legs: two pieces that a round joins are written as people write them: one piece, made twice, and what goes on from both."""

from __future__ import annotations

import re

from tambour.crochet.graph.built import Done
from tambour.crochet.language.tree import Pattern, Section
from tambour.crochet.page.written import Written

_Block = tuple[str, int, list[Written]]
"""What a block is called, how often it is made, its lines."""


def legs(pattern: Pattern, section: Section, written: list[Written]) -> tuple[_Block, _Block, int] | None:
    """The piece that is made twice, what goes on from both, and where its text begins; None of a part that is no such figure."""
    mark = next((k for k, line in enumerate(written) if _only(line, "mark")), None)
    joint = next((k for k, line in enumerate(written) if any(d.what == "attach" for d in _done(line))), None)
    if mark is None or joint is None or not 0 < mark < joint or not section.lines:
        return None
    first, second = written[:mark], _plain(written[mark + 1 : joint])
    if [_words(line) for line in _plain(first)] != [_words(line) for line in second]:
        return None
    done = next(d for d in _done(written[joint]) if d.what == "attach")
    if done.span is None:
        return None
    text = pattern.text.text
    noun = re.sub(r"_\d+$", "", _done(written[mark])[0].labels[0])
    name, at = _heading(text, section, done.span.start)
    begun = text.rfind("\n", 0, section.span.start) + 1
    hers = re.sub(r"\s*[(\[].*", "", text[section.span.start : section.span.end]).strip(" *#_:=")
    called = (
        hers
        if noun in hers.lower() and not section.also and name
        else f"{noun}s".upper()
        if hers.isupper()
        else f"{noun.capitalize()}s"
    )
    body = name or section.name
    # Colours that are changed to before the round that joins belong to what goes on.
    since = next((k for k in range(joint, mark, -1) if not _only(written[k - 1], "color")), joint)
    lead = [line for line in written[since:joint] if at <= (_done(line)[0].span or done.span).start]
    rest = [*lead, *(line for line in written[joint:])]
    return (called, 2, _without(first, lead)), (body, 1, rest), max(at, begun)


def _heading(text: str, section: Section, joint: int) -> tuple[str, int]:
    """What stands as a heading over the round that joins, and where; "" where nothing does, the round's own line."""
    line = text.rfind("\n", 0, joint) + 1
    lines = [(m.start(), m[0]) for m in re.finditer(r"[^\n]+", text[:line])]
    for start, words in reversed(lines[-8:]):
        plain = words.strip(" *#_:=\t")
        if start < section.span.start and start not in (section.span.start,):
            return (
                (text[section.span.start : section.span.end].strip(), section.span.start)
                if section.also
                else ("", line)
            )
        short = 0 < len(plain.split()) <= 5 and not plain.endswith((".", ",", ")", "!")) and not re.search(r"\d", plain)
        if short and (plain.isupper() or text[start - 2 : start] == "\n\n") and plain[:1].isupper():
            return plain, start
    return "", line


def _done(line: Written) -> list[Done]:
    return [d for unit, _ in line.pieces for d in unit]


def _only(line: Written, what: str) -> bool:
    done = _done(line)
    return bool(done) and all(d.what == what for d in done)


def _plain(lines: list[Written]) -> list[Written]:
    """The lines that work stitches."""
    return [line for line in lines if line.makes]


def _words(line: Written) -> tuple[object, ...]:
    """What a line works, whatever its yarn."""
    done = [
        (d.what, d.times, d.numbers) for unit, n in line.pieces for d in [*unit] * n if d.what not in ("color", "join")
    ]
    return line.times, line.count, tuple(done)


def _without(lines: list[Written], lead: list[Written]) -> list[Written]:
    return [line for line in lines if line not in lead]

"""A pattern written back in standard terms: numbered rounds, brackets found, counts stated."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import groupby

from tambour.core.errors import Text
from tambour.crochet.build import Built, Done, build
from tambour.crochet.stitches import RULES, SPELT, STUFFING
from tambour.crochet.syntax import Pattern, Section

# The longest repeat that is looked for, in different stitches in a row.
_LONGEST = 24


def pattern(piece: Built | Pattern) -> Text:
    """The text of a pattern, in standard terms; reading it again gives the same graph (but for the spans).

    Marks keep their names, definitions their words; comments and what has no effect are left out.
    """
    built = build(piece) if isinstance(piece, Pattern) else piece
    source = built.pattern
    blocks: list[str] = []
    own = [source.text.text[span.start : span.end].strip() for span in source.own.values()]
    if own:
        blocks.append("\n".join(own))
    for section, done in _sections(built):
        lines = _head(section) + _body(done)
        if lines:
            blocks.append("\n".join(lines))
    return Text("\n\n".join(blocks) + "\n" if blocks else "", source.text.name)


def _sections(built: Built) -> Iterator[tuple[Section, list[Done]]]:
    """Every part of the text with what the hook did for its first copy."""
    keep: list[Done] = []
    section: Section | None = None
    for done in built.log:
        if done.what == "part":
            if section is not None and keep:
                yield section, keep
            index, copy = done.numbers
            section, keep = (built.pattern.parts[index], []) if copy == 1 else (None, [])
        keep.append(done)
    if section is not None:
        yield section, keep


def _head(section: Section) -> list[str]:
    lines = []
    if section.name:
        lines.append(f"== {section.name}{f' (make {section.copies})' if section.copies > 1 else ''} ==")
    if section.centroids is not None:
        lines.append(f"@centroids = {section.centroids}")
    if section.stuffing is not None:
        word = next((w for w, amount in STUFFING.items() if amount == section.stuffing), f"{section.stuffing:g}")
        lines.append(f"@stuffing = {word}")
    if section.initializer is not None:
        lines.append(f"@initializer = {section.initializer}")
    if section.up is not None:
        lines.append(f"@up = {section.up}")
    if not section.tip_from_fo:
        lines.append("@tip_from_fo = false")
    return lines


def _body(log: list[Done]) -> list[str]:
    """Lines of a part: rounds numbered from 1, equal ones in a row as a range."""
    written: list[tuple[bool, str]] = []
    line: list[Done] = []
    in_round = False
    for done in log:
        if done.what in ("round", "line"):
            in_round = done.what == "round"
            line = []
        elif done.what == "end":
            if line:
                makes = in_round or any(d.what in ("mr", "ch") for d in line)
                count = f" ({done.times})" if makes and done.times else ""
                written.append((makes, ", ".join(_compressed(line)) + count))
        elif done.what != "part":
            line.append(done)
    lines, number = [], 1
    for (is_round, text), same in groupby(written):
        times = len(list(same))
        if not is_round:
            lines += [text] * times
        elif times == 1:
            lines.append(f"R{number}: {text}")
        else:
            lines.append(f"R{number}-R{number + times - 1}: {text}")
        number += times * is_round
    return lines


def _compressed(line: list[Done]) -> list[str]:
    """What was done in one line, repeats in brackets."""
    said = [(_said(d), d.what not in RULES or RULES[d.what].in_brackets) for d in line]
    made: list[str] = []
    at = 0
    while at < len(said):
        best, times = 1, 1
        for period in range(1, min(_LONGEST, (len(said) - at) // 2) + 1):
            unit = said[at : at + period]
            if not all(free for _, free in unit):
                break
            r = 1
            while said[at + r * period : at + (r + 1) * period] == unit:
                r += 1
            if r > 1 and r * period > best * times:
                best, times = period, r
        words = ", ".join(word for word, _ in said[at : at + best])
        made.append(f"[{words}] x {times}" if times > 1 else words)
        at += best * times
    return made


def _said(done: Done) -> str:
    name = SPELT.get(done.what, done.what)
    if done.what not in RULES:
        return name if done.times == 1 else f"{done.times} {name}"
    if done.what == "mr":
        return f"MR({done.numbers[0]})"
    if done.what == "attach":
        size = done.numbers[0]
        return f"attach({done.labels[0]}{', merge' if size < 0 else f', {size}' if size else ''})"
    arguments = [*done.labels, *(str(n) for n in done.numbers)]
    return f"{name}({', '.join(arguments)})" if arguments else name

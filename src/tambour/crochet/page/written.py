"""Written: what the hook did, as lines to write down: brackets found, rounds numbered, equal ones in a row as one."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from tambour.crochet.graph.build import Built, Done
from tambour.crochet.language.stitches import RULES
from tambour.crochet.language.tree import Section

# The longest repeat that is looked for, in different stitches in a row.
_LONGEST = 24

_MAKES = frozenset(("mr", "ch", "oval", "fsc"))

Piece = tuple[tuple[Done, ...], int]
"""Things done in a row, and how often."""


@dataclass(frozen=True, slots=True)
class Written:
    """A line to write.

    number : of its round; 0 for a line outside rounds, and for a chain that a part begins with; times : rounds like it
    makes : it is a round, or begins one; count : stitches on its edge afterwards, 0 for none
    """

    number: int
    times: int
    makes: bool
    pieces: tuple[Piece, ...]
    count: int


def sections(built: Built) -> Iterator[tuple[Section, int, list[Written]]]:
    """Every part of the text with the place of its first copy in the graph's parts, and its lines."""
    keep: list[Done] = []
    section: Section | None = None
    part = first = -1
    for done in [*built.log, Done("part", 1, (-1, 1))]:
        if done.what == "part":
            if section is not None:
                yield section, first, _lines(section, keep)
            index, copy = done.numbers
            part += 1
            section, keep, first = (built.pattern.parts[index] if copy == 1 and index >= 0 else None), [], part
        else:
            keep.append(done)


def _lines(section: Section, log: list[Done]) -> list[Written]:
    numbers = [None if line.number is None else line.number + k for line in section.lines for k in range(line.times)]
    made: list[Written] = []
    line: list[Done] = []
    in_round, last, at = False, 0, 0
    for done in log:
        if done.what in ("round", "line"):
            in_round, line = done.what == "round", []
        elif done.what != "end":
            line.append(done)
        else:
            number, at = numbers[at], at + 1
            makes = in_round or any(d.what in _MAKES for d in line)
            if not line:
                continue
            chain = not last and number is None and all(d.what == "ch" or d.what in RULES for d in line)
            if makes and not (chain and not any(d.what in ("mr", "oval", "fsc") for d in line)):
                last = last + 1 if number is None else number
                number = last
            else:
                number = 0
            written = Written(number, 1, makes, tuple(brackets(line)), done.times if makes else 0)
            before = made[-1] if made else None
            if before and _follows(before, written):
                made[-1] = replace(before, times=before.times + 1)
            else:
                if before and before.number == written.number and before.times == 1 and _only_chain(before):
                    made[-1] = replace(before, number=0)  # the chain that this round is worked on
                made.append(written)
    return made


def _only_chain(line: Written) -> bool:
    return all(d.what in ("ch", "oval", "color") for unit, _ in line.pieces for d in unit)


def _follows(before: Written, written: Written) -> bool:
    return (
        bool(written.number)
        and before.number + before.times == written.number
        and before.count == written.count
        and [(list(map(_key, unit)), n) for unit, n in before.pieces]
        == [(list(map(_key, unit)), n) for unit, n in written.pieces]
    )


def _key(done: Done) -> tuple[object, ...]:
    return done.what, done.times, done.numbers, done.labels


def brackets(line: list[Done]) -> list[Piece]:
    """What was done in one line, its repeats found."""
    said = [(_key(d), d.what not in RULES or RULES[d.what].in_brackets) for d in line]
    made: list[Piece] = []
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
        made.append((tuple(line[at : at + best]), times))
        at += best * times
    return made

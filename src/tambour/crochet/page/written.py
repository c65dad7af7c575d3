"""Written: what the hook did, as lines to write down: brackets found, rounds numbered, equal ones in a row as one."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from itertools import pairwise

from tambour.core.errors import Span
from tambour.crochet.graph.built import SAYS, Built, Done
from tambour.crochet.language.finishes import Placed
from tambour.crochet.language.stitches import RULES, Stitch
from tambour.crochet.language.tree import Line, Section
from tambour.crochet.page.doubted import doubted

# The longest repeat that is looked for, in different stitches in a row.
_LONGEST = 24

_MAKES = frozenset(("mr", "ch", "oval", "fsc"))
_SHOWN = re.compile(r"the round makes (\d+)")

Piece = tuple[tuple[Done, ...], int]
"""Things done in a row, and how often."""


@dataclass(frozen=True, slots=True)
class Written:
    """A line to write.

    number : of its round; 0 for a line outside rounds, and for a chain that a part begins with; times : rounds like it
    makes : it is a round, or begins one; count : stitches on its edge afterwards, 0 for none
    notes : sentences that stand with it; said : the count that the text states where that is another, 0 where it is not
    wrong : how many it makes where that count is told to be wrong, 0 where it is not: people also leave chains or slip stitches out
        of theirs, and are right
    hers : her line, where it was not understood as she says it; line : the line that says it
    """

    number: int
    times: int
    makes: bool
    pieces: tuple[Piece, ...]
    count: int
    notes: tuple[str, ...] = ()
    said: int = 0
    wrong: int = 0
    hers: bool = False
    line: Line | None = None


def sections(built: Built, inside: bool = False) -> Iterator[tuple[Section, int, list[Written]]]:
    """Every part of the text with the place of its first copy in the graph's parts, and its lines.

    inside : stitches that go through a part that is crocheted in name it (``labels``)
    """
    keep: list[Done] = []
    section: Section | None = None
    part = first = -1
    told = doubted(built.pattern) if inside else frozenset[Span]()
    alarms = _alarms(built)
    numbered: dict[str, dict[int, Written]] = {}  # under which numbers a part's rounds can be read
    for done in [*built.log, Done("part", 1, (-1, 1))]:
        if done.what == "part":
            if section is not None:
                through = _through(built, section) if inside else {}
                apart = inside and bool(built.pattern.terms)  # her lines stay lines of their own
                yield (
                    section,
                    first,
                    _lines(section, keep, numbered, through, built.pattern.stitches, told, alarms, apart),
                )
            index, copy = done.numbers
            part += 1
            section, keep, first = (built.pattern.parts[index] if copy == 1 and index >= 0 else None), [], part
        else:
            keep.append(done)


_Runs = list[tuple[int, int, str]]
"""Stitches that go through a part as well: the first of them, from 0, how many, and its name."""


def _through(built: Built, section: Section) -> dict[int, _Runs]:
    """The stitches of a part's rounds, by their numbers, that go through parts which are crocheted in."""
    made: dict[int, _Runs] = {}
    for record in built.pattern.finish:
        if not isinstance(record, Placed) or not record.through:
            continue
        at = record.spot
        if at.stitch is not None and at.part in (section.name, f"{section.name}.1"):
            first = round(at.stitch - 0.5 * (record.through + 1))
            said = (n.number for n in section.lines if n.number and n.span.start <= record.span.start < n.span.end)
            made.setdefault(next(said, int(at.round)), []).append(
                (first, record.through, record.part.replace(".", " "))
            )
    return {number: sorted(runs) for number, runs in made.items()}


def _named(line: list[Done], runs: _Runs, stitches: Mapping[str, Stitch]) -> list[Done]:
    """What was done in a round, with its stitches that go through another part apart from the others."""
    made: list[Done] = []
    at = 0
    for done in line:
        makes = stitches[done.what].makes if done.what not in RULES else 0
        if makes != 1:
            made, at = [*made, done], at + makes * done.times
            continue
        end = at + done.times
        cuts = sorted({at, end, *(c for a, n, _ in runs for c in (a, a + n) if at < c < end)})
        for a, b in pairwise(cuts):
            part = next((name for first, n, name in runs if first <= a < first + n), "")
            made.append(replace(done, times=b - a, labels=(part,) if part else ()))
        at = end
    return made


def _alarms(built: Built) -> dict[Span, int]:
    """Where the text states counts that its rounds do not make, and what they make, as that is told."""
    told = [p for p in built.warnings if p.message.startswith(SAYS)]
    return {p.span: int(found[1]) for p in told if p.span is not None and (found := _SHOWN.search(p.message))}


def _lines(
    section: Section,
    log: list[Done],
    numbered: dict[str, dict[int, Written]],
    through: Mapping[int, _Runs],
    stitches: Mapping[str, Stitch],
    told: frozenset[Span],
    alarms: Mapping[Span, int],
    apart: bool = False,
) -> list[Written]:
    numbers = [None if line.number is None else line.number + k for line in section.lines for k in range(line.times)]
    of = [line for line in section.lines for _ in range(line.times)]
    made: list[Written] = []
    own = numbered.setdefault(section.name, {})
    line: list[Done] = []
    notes: list[str] = []
    in_round, last, at = False, 0, 0
    again: Done | None = None
    named: list[Written | None] = []  # the rounds that are worked again
    rest, since = 0, 0  # rounds still to come of those worked as others, and where in ``made`` they begin
    for done in log:
        if done.what == "again":
            again, rest, since = done, done.times, len(made)
            known = numbered.get(done.labels[0] or section.name, {})
            named = [known.get(n) for n in range(done.numbers[0], done.numbers[1] + 1)]
            if None in named:
                again, rest = None, 0
        elif done.what in ("round", "line"):
            in_round, line, notes = done.what == "round", [], []
        elif done.what == "note":
            notes += [] if done.labels[0] in notes else [done.labels[0]]
        elif done.what != "end":
            line.append(done)
        else:
            number, source, at = numbers[at], of[at], at + 1
            makes = in_round or any(d.what in _MAKES for d in line)
            if not line and not again:
                continue
            above = (
                not last and number is None and numbers[at : at + 1] == [1]
            )  # the ring above Round 1 bears no number
            chain = not last and number is None and all(d.what == "ch" or d.what in RULES for d in line)
            if makes and not above and not (chain and not any(d.what in ("mr", "oval", "fsc") for d in line)):
                last = last + 1 if number is None else number
                number = last
            else:
                number = 0
            if number in through:
                line = _named(line, through[number], stitches)
            count = done.times if makes else 0
            final = at == len(of) or of[at] is not source  # "Rnds 2 and 3: … 24 sc at the end of Rnd 3"
            said = source.stated if source.stated and count and source.stated != count and final else 0
            written = Written(
                number,
                1,
                makes,
                tuple(brackets(line)),
                count,
                tuple(notes) if final else (),
                said,
                alarms.get(source.stated_span, 0) if source.stated_span is not None else 0,
                source.span in told,
                source,
            )
            before = made[-1] if made else None
            if number:
                own[number] = written
            if again is not None:
                made.append(written)
                like = named[(len(made) - 1 - since) % len(named)]
                if like is None or not _alike(like, written, bool(_lead(made[since])) and len(made) - 1 == since):
                    again = None  # on another number of stitches the same words come to others: written out
                    continue
                rest -= 1
                if not rest:
                    lead = tuple(((d,), 1) for d in _lead(made[since]))
                    one = replace(written, number=made[since].number, times=again.times, pieces=(*lead, ((again,), 1)))
                    made[since:], again = [one], None
            elif before and _follows(before, written, apart):
                made[-1] = replace(before, times=before.times + 1, notes=written.notes)
            else:
                if before and before.number == written.number and before.times == 1 and _only_chain(before):
                    made[-1] = replace(before, number=0)  # the chain that this round is worked on
                made.append(written)
    return made


def _alike(one: Written, other: Written, led: bool) -> bool:
    """Whether the same things are done in two rounds; ``led``: but for the colour that the other begins with."""

    def plain(line: Written) -> list[tuple[object, ...]]:
        pieces = line.pieces[1:] if led and _lead(line) else line.pieces
        return [(tuple(map(_key, unit)), n) for unit, n in pieces]

    return plain(one) == plain(other)


def _lead(line: Written) -> list[Done]:
    """The colour that a round begins with."""
    first = line.pieces[0][0][0] if line.pieces else None
    return [first] if first is not None and first.what == "color" else []


def _only_chain(line: Written) -> bool:
    return all(d.what in ("ch", "oval", "color") for unit, _ in line.pieces for d in unit)


def _follows(before: Written, written: Written, apart: bool) -> bool:
    return (
        bool(written.number)
        and (before.notes == written.notes or not before.notes)
        and before.pieces != ()
        and before.pieces[-1][0][0].what != "again"
        and before.number + before.times == written.number
        and (_same_line(before, written) or not (apart or before.hers or written.hers))
        and (before.count, before.said) == (written.count, written.said)
        and [(list(map(_key, unit)), n) for unit, n in before.pieces]
        == [(list(map(_key, unit)), n) for unit, n in written.pieces]
    )


def _same_line(one: Written, other: Written) -> bool:
    return one.line is not None and other.line is not None and one.line.span == other.line.span


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

"""Printed patterns, mended: rounds that cannot be worked as they were read become gaps, so that the rest can be."""

from __future__ import annotations

from collections.abc import Set as AbstractSet
from dataclasses import dataclass, field, replace
from typing import Final

from tambour.core.errors import Problem, Span, TambourError
from tambour.crochet.graph.build import build
from tambour.crochet.graph.built import NOTHING, SAYS, TOO_MANY, Built
from tambour.crochet.language.stitches import Stitch
from tambour.crochet.language.tree import Action, Group, Item, Line, Pattern, Section
from tambour.crochet.printed.rounds.items import goes
from tambour.crochet.printed.rounds.reckoned import after

_ROUNDS = 60  # times that a part is worked to find the next fault
_TRIES = 6  # times that the whole is
_OFF = 1.8  # times the stated count that a mistake of the text is, at most


def is_start(item: Item, stitches: dict[str, Stitch]) -> bool:
    """Whether an item begins a piece of work."""
    if isinstance(item, Group):
        return any(is_start(i, stitches) for i in item.items)
    if item.name in ("mr", "ch", "oval", "fsc", "goto", "attach"):
        return True
    return item.name in stitches and stitches[item.name].where == "ring"


@dataclass
class Found:
    """What is told of a pattern while it is mended: ``unread`` of its gaps, ``doubts`` of what was understood and cannot be worked as it
    is said."""

    sound: set[int] = field(default_factory=set)
    unread: list[Problem] = field(default_factory=list)
    doubts: list[Problem] = field(default_factory=list)


def mended(pattern: Pattern, told: Found) -> tuple[Pattern, Built | None]:
    """``pattern`` with gaps for the rounds that the hook cannot work, worked, and what is told of each gap.

    Each part is mended by itself, so that only those with a fault are worked more than once; None in place of the work
    where it still cannot be done.
    """
    for _ in range(_TRIES):
        try:
            return pattern, build(pattern)
        except TambourError as error:
            wrong = [p for p in error.problems if not p.warning and p.span is not None]
        parts = []
        for section in pattern.parts:
            if any(_inside(p.span, line) for p in wrong for line in section.lines):
                section = _section(pattern, section, wrong, told)
            parts.append(section)
        if tuple(parts) == pattern.parts:
            break
        pattern = replace(pattern, parts=tuple(parts))
    return pattern, None


def agreed(pattern: Pattern, built: Built, sound: set[int], unread: list[Span], told: Found) -> tuple[Pattern, Built]:
    """The same with gaps where the hook makes another count than the one stated, though the words do make it on the count
    that is stated below, or though something since the last count that it did make was not read: there something before
    was read wrongly, and it is no mistake of the text.

    sound : where the lines begin whose words make their counts; unread : what was not understood
    """
    for _ in range(_TRIES):
        alarms = {p.span: p for p in built.warnings if p.span is not None and p.message.startswith(SAYS)}
        wrong = [
            p
            for span, p in alarms.items()
            if _sound(pattern, span, sound)
            or any(_shaken(s, span, set(alarms), unread) for s in pattern.parts)
            or _unsure(built, span, set(alarms))
        ]
        firsts = {next(k for k, s in enumerate(pattern.parts) if _within(p.span, s)): p for p in reversed(wrong)}
        if not firsts:
            break
        parts = list(pattern.parts)
        for k, problem in firsts.items():
            fair = _fair(parts[k], problem.span, alarms.keys() - {p.span for p in wrong}, sound, unread)
            lines = []
            for line in parts[k].lines:
                at = line.stated_span
                if at is not None and at == problem.span and line.stated:
                    line = replace(line, items=_gap(line, at, line.stated, fair), again=None)
                lines.append(line)
            if not fair:  # else only the count below is wrong, which is told there
                said = f"this round does not fit the one below as that was read: it is taken from its count, {_stated(lines, problem)}"
                told.unread.append(replace(problem, message=said, warning=True))
            parts[k] = replace(parts[k], lines=tuple(lines))
        pattern, again = mended(replace(pattern, parts=tuple(parts)), told)
        if again is None:
            break
        built = again
    return pattern, built


def _fair(
    section: Section, span: Span | None, told: AbstractSet[Span | None], sound: set[int], unread: list[Span]
) -> bool:
    """Whether the round whose count stands at ``span`` is understood, and only a count below it that the text gets wrong is amiss, which
    is told there."""
    at = next(k for k, line in enumerate(section.lines) if line.stated_span == span)
    if section.lines[at].span.start not in sound:
        return False
    for line in reversed(section.lines[:at]):
        if any(line.span.start <= one.start < line.span.end for one in unread) or line.gap:
            return False
        if line.stated_span in told or any(isinstance(i, Action) and i.name == "gap" for i in line.items):
            return True
        if line.stated is not None and line.span.start not in sound:
            return False
    return False


def _stated(lines: list[Line], problem: Problem) -> int:
    return next((line.stated or 0 for line in lines if line.stated_span == problem.span), 0)


def _within(span: Span | None, section: Section) -> bool:
    return any(line.stated_span == span for line in section.lines)


def _sound(pattern: Pattern, span: Span, sound: set[int]) -> bool:
    return any(
        line.stated_span == span and line.span.start in sound and not line.gap
        for s in pattern.parts
        for line in s.lines
    )


def _shaken(section: Section, span: Span, alarms: set[Span | None], unread: list[Span]) -> bool:
    """Whether something was not read between the last count that was made and the one stated at ``span``."""
    at = next((k for k, line in enumerate(section.lines) if line.stated_span == span and not line.gap), None)
    if at is None:
        return False
    again = section.lines[at].again
    if again is not None and any(line.gap or (again.part and line.stated_span in alarms) for line in again.lines):
        return True  # a count that is worked again is none
    begin = section.span.start
    for line in reversed(section.lines[:at]):
        if line.gap and not line.stated:
            return True
        if line.stated is not None and line.stated_span not in alarms:
            begin = line.span.end
            break
    end = section.lines[at].span.end
    return any(begin <= one.start < end for one in unread)


def _unsure(built: Built, span: Span, alarms: set[Span | None]) -> bool:
    """Whether the edge below a round is none that a count is held against: rows that end early or go back by slip stitches,
    or a count so far off that words were taken for others."""
    at = next((k for k, w in enumerate(built.worked) if w.line.stated_span == span and w.line.stated), None)
    if at is None:
        return False
    one = built.worked[at]
    stated = one.line.stated or 1
    rounds = [w.made for w in built.worked if w.part == one.part and w.line.span == one.line.span]
    if stated in rounds[:-1]:
        return False  # "2nd and 3rd rows: … 60 sc": the first of them makes it
    if not any(stated <= _OFF * n and n <= _OFF * stated for n in (one.made, one.edge)):
        return True
    for k in range(at, -1, -1):
        w = built.worked[k]
        if w.part != one.part or (k < at and w.line.stated is not None and w.line.stated_span not in alarms):
            return False
        names = _names(w.line.items)
        short = w.left > 0 or "slst" in names
        if w.line.in_round and w.below and not w.ring and short and (k < at or "turn" in names):
            return True
    return False


def _names(items: tuple[Item, ...]) -> set[str]:
    return {n for i in items for n in (_names(i.items) if isinstance(i, Group) else {i.name})}


def _section(pattern: Pattern, section: Section, wrong: list[Problem], told: Found) -> Section:
    """One part with gaps where the hook fails; ``wrong`` : how it fails behind the parts before it."""
    wrong = [p for p in wrong if any(_inside(p.span, line) for line in section.lines)]
    if any(p.message.startswith(TOO_MANY) for p in wrong):
        wrong = _faults(pattern, section)  # without the stitches of those parts it gets further
    for _ in range(_ROUNDS):
        if not wrong:
            break
        (mended,) = _gaps(replace(pattern, parts=(section,)), wrong, told)
        if mended == section:  # what misled it is put right already
            (mended,) = _gaps(replace(pattern, parts=(section,)), wrong, told, False)
        if mended == section:
            break
        section = mended
        wrong = _faults(pattern, section)
    return section


def _faults(pattern: Pattern, section: Section) -> list[Problem]:
    """How the hook fails in a part by itself."""
    try:
        build(replace(pattern, parts=(replace(section, copies=1, copies_span=None),)))
    except TambourError as error:
        return [p for p in error.problems if not p.warning and p.span is not None]
    return []


_EASED: Final = {
    "a single loop needs two rounds below it": (
        ("flo", "blo"),
        "a single loop needs two rounds below it: both loops are taken",
    ),
    "the round has no stitch to join to": (("join",), "a round of chains and slip stitches alone is not joined"),
    "there is no edge to fold": (("fold",), "what is folded here is flat: the seam is not drawn"),
    "rows have no opening to fold": (("fold",), "what is folded here is flat: the seam is not drawn"),
    "there is no edge to turn": (("turn",), "no stitch is left here to turn on"),
    "FO needs at least two stitches": (("fo",), "so few stitches are not drawn together"),
}
"""What the hook refuses → the actions that it can do without, and what is told of that."""


def _eased(line: Line, problem: Problem) -> tuple[Line, str] | None:
    """``line`` without a nicety that the hook cannot work there, and what is told; None where that is not its fault."""
    end = next((k for k in range(len(line.items) - 1, -1, -1) if goes(line.items[k]) and not _ends(line.items[k])), -1)
    rest = line.items[end] if end >= 0 else None
    if problem.message.startswith("there is no stitch left") and isinstance(rest, Action) and rest.name == "skip":
        return replace(line, items=(*line.items[:end], *line.items[end + 1 :])), "no stitches are left unworked here"
    for message, (names, said) in _EASED.items():
        if problem.message.startswith(message):
            items = tuple(i for i in (_without(i, names) for i in line.items) if i is not None)
            again = line.again
            if again is not None:
                kept = [
                    replace(one, items=tuple(j for j in (_without(i, names) for i in one.items) if j is not None))
                    for one in again.lines
                ]
                again = replace(again, lines=tuple(kept))
            if items != line.items or again != line.again:
                return replace(line, items=items, again=again), said
    return None


def _ends(item: Item) -> bool:
    return isinstance(item, Action) and item.name in ("turn", "join", "fo")


def _without(item: Item, names: tuple[str, ...]) -> Item | None:
    if isinstance(item, Action):
        return None if item.name in names else item
    items = tuple(i for i in (_without(i, names) for i in item.items) if i is not None)
    return replace(item, items=items) if items else None


def _gaps(pattern: Pattern, wrong: list[Problem], told: Found, above: bool = True) -> tuple[Section, ...]:
    """The parts with a gap in place of each line that a problem stands in, or, ``above``, of the one that misled it."""
    parts = []
    for section in pattern.parts:
        lines: list[Line] = []
        misled = _first_misled(section, wrong, told.sound, dict(pattern.stitches)) if above else None
        for line in section.lines:
            problem = next((p for p in wrong if _inside(p.span, line)), None)
            if misled is not None and (line is misled or problem is not None):
                # What fails comes of a count further up that the text gets wrong: from there it goes on as it says.
                if line is misled and line.stated_span is not None and line.stated:
                    said = f"this round makes its {line.stated} stitches on the count that is stated below it, which is not what is made there"
                    told.doubts.append(
                        Problem(said, "correct the count below", line.stated_span, pattern.text, warning=True)
                    )
                    line = replace(line, items=_gap(line, line.stated_span, line.stated, True), again=None)
                lines.append(line)
                continue
            if problem is None:
                lines.append(line)
                continue
            eased = _eased(line, problem)
            if eased is not None:
                told.doubts.append(replace(problem, message=eased[1], warning=True))
                lines += [eased[0]] if eased[0].items or eased[0].again else []
                continue
            if any(problem.message.startswith(m) and m.startswith("FO") for m in _EASED) and line.in_round:
                lines.append(line)  # the end of it does without
                continue
            count = line.stated or next((one.stated for one in reversed(lines) if one.stated), None)
            at = line.stated_span or line.span
            if "gap" in _names(line.items) or not count or not line.in_round:
                said = f"{problem.message}: this round is left out"
            elif _grown(problem) or _misled(lines, line, told.sound):
                said = f"{problem.message}: this round is taken to have {count}"
                lines.append(replace(line, items=_gap(line, at, count, True), again=None))
                told.doubts.append(replace(problem, message=said, warning=True))
                continue
            else:
                said = f"{problem.message}: this round is taken from its count, {count}"
                lines.append(replace(line, items=_gap(line, at, count), again=None))
            told.unread.append(replace(problem, message=said, warning=True))
        parts.append(replace(section, lines=tuple(lines)))
    return tuple(parts)


def _grown(problem: Problem) -> bool:
    """Whether a round was understood, and only makes too many stitches."""
    return problem.message.startswith(TOO_MANY) and problem.message != NOTHING


def _first_misled(section: Section, wrong: list[Problem], sound: set[int], stitches: dict[str, Stitch]) -> Line | None:
    """The first round above one that fails whose words make its count, but on a count stated right below it that is not what is made
    there; None where every round stands on what it says, or that cannot be known."""
    edge: int | None = None
    off = False
    for line in section.lines:
        if any(_inside(p.span, line) for p in wrong):
            return None
        if line.gap:
            edge, off = line.stated, False
            continue
        if line.again is not None:
            for one in line.rounds():
                edge = after(one.items, edge, stitches)
            continue
        if off and line.span.start in sound and line.stated and line.in_round:
            return line
        for _ in range(line.times):
            edge = after(line.items, edge, stitches)
        off = line.stated is not None and edge is not None and edge != line.stated
        off = off and line.in_round
    return None


def _misled(before: list[Line], line: Line, sound: set[int]) -> bool:
    """Whether a round's words make its count, but on a count below it that the words there do not make."""
    if line.span.start not in sound or any(one.gap for one in before):
        return False
    stated = [one for one in before if one.stated is not None and one.again is None]
    return any(one.span.start not in sound for one in stated)


def _gap(line: Line, at: Span, count: int, fair: bool = False) -> tuple[Item, ...]:
    """A gap in place of what a line works; its join or turn stays, since the next line counts on it. ``fair`` : it was understood."""
    last = line.items[-1:]
    ends = last if last and isinstance(last[0], Action) and last[0].name in ("join", "turn") else ()
    return (Action("gap", at, numbers=(count, 1) if fair else (count,)), *ends)


def _inside(span: Span | None, line: Line) -> bool:
    if span is None:
        return False
    if any(isinstance(i, Action) and i.name == "turn" and i.span == span for i in line.items):
        return True  # the turn before a row is worked at the end of the one below it
    return line.stated_span == span or (line.span.start <= span.start and span.end <= line.span.end)

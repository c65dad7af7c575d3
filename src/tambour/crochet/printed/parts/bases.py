"""Printed patterns, bases: what rounds are worked on that begin elsewhere than where the hook is: a round made before, which the
hook goes back to, or a chain of as many stitches in place of an edge that the tree does not know."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Final

from tambour.core.errors import Span
from tambour.crochet.graph.hook import LIFT
from tambour.crochet.language.stitches import Stitch
from tambour.crochet.language.tree import Action, Group, Item, Line
from tambour.crochet.places.names import kind_of, one
from tambour.crochet.printed.heads import Head
from tambour.crochet.printed.parts.mend import is_start
from tambour.crochet.printed.parts.naming import named
from tambour.crochet.printed.parts.part import Draft
from tambour.crochet.printed.rounds.counts import makes
from tambour.crochet.printed.rounds.doubts import tried
from tambour.crochet.printed.rounds.items import closes
from tambour.crochet.printed.rounds.moved import Moved
from tambour.crochet.printed.rounds.reader import Body
from tambour.crochet.printed.rounds.reckoned import after, worked
from tambour.crochet.printed.sheet.notes import Heading
from tambour.crochet.printed.state import State
from tambour.crochet.printed.tokens import Token

_MOST: Final = 400
_SEVERAL: Final = 4
"""Stitches skipped for an opening, not to decrease."""
UNKNOWN: Final = "the edge that this is worked on is not known"
_STOP: Final = re.compile(r"[.;:(\[\n]|, ")
MOST: Final = 5000  # stitches of a round that is taken from its count


def base(items: list[Item], stated: int | None, stitches: dict[str, Stitch]) -> int | None:
    """How many stitches ``items`` are worked into, by what they use up or else by their count; None where neither says it."""
    if any(isinstance(i, Group) and i.times is None for i in items):
        if stated is None:
            return None
        return next((n for n in range(1, _MOST) if after(items, n, stitches) == stated), None)
    done = worked(items, _MOST * 10, stitches)
    return done[1] if done is not None and done[1] else None


def foundation(count: int, span: Span, row: bool) -> tuple[Item, ...]:
    """A chain of so many stitches, to work a round or a row on."""
    if row:
        return (Action("ch", span, count + 1), Action("turn", span))
    return (Action("ch", span, count),)


def lifted(items: list[Item]) -> list[Item]:
    """``items`` without the chains that lift the yarn before the first stitch, which a chain below would count as its own."""
    at = next(
        (
            k
            for k, i in enumerate(items)
            if not isinstance(i, Action) or i.name not in ("color", "flo", "blo", "turn", "join")
        ),
        0,
    )
    first = items[at] if items else None
    if isinstance(first, Action) and first.name == "ch" and first.times <= LIFT:
        return [*items[:at], *items[at + 1 :]]
    return items


def back_to(
    draft: Draft, place: Moved, stitches: dict[str, Stitch] | None = None
) -> tuple[Action, int, tuple[int, int]] | None:
    """What brings the hook back to the round of ``draft`` that ``place`` names, where a mark is put, the stitches there that are free, and how
    many before and behind them are not; None where that round is not known."""
    if not (place.number or place.before or place.free):
        return None
    meant = place.number or 0
    if draft.offset and draft.offset < draft.offset + meant <= draft.last:
        meant += draft.offset  # "Row 7", of rows that began at 1 again
    gap = None if stitches is None else _skipped(draft, meant, place, stitches)
    if gap is not None:
        meant = gap[0]
    number = meant or (draft.last + 1 - place.before if place.before else _left_loops(draft))
    edge = draft.edges.get(number, 0)
    at = next(
        (
            k
            for k, line in enumerate(draft.lines)
            if line.in_round and line.number is not None and line.number <= number < line.number + line.times
        ),
        None,
    )
    if at is None or edge < 2:
        return None
    line = draft.lines[at]
    label = next((i.labels[0] for i in line.items[-1:] if isinstance(i, Action) and i.name == "mark"), "")
    if not label or line.times > 1:
        done = number - (line.number or number) + 1
        label = f"{draft.name or 'piece'}_{number}".replace(" ", "_").lower()
        mark = Action("mark", place.span, labels=(label,))
        first = [replace(line, times=done - 1, times_span=line.times_span if done > 2 else None)] if done > 1 else []
        rest = line.times - done
        tail = (
            [replace(line, times=rest, times_span=line.times_span if rest > 1 else None, number=number + 1)]
            if rest
            else []
        )
        one = replace(line, times=1, times_span=None, number=number, notes=() if tail else line.notes)
        if line.again is not None:  # it is written out, so that it can hold the mark
            every = list(line.rounds())
            first, one, tail = every[: done - 1], every[done - 1], every[done:]
        only = replace(one, items=(*one.items, mark))
        draft.lines[at : at + 1] = [*first, only, *tail]
        more = len(first) + len(tail)
        draft.marks = [(stars, where + more if where > at else where) for stars, where in draft.marks]
        if draft.chain is not None and draft.chain > at:
            draft.chain += more
    goto = Action("goto", place.span, labels=(label,))
    if gap is None or (behind := edge - gap[1] - gap[2]) < 0:
        return goto, edge, (0, 0)
    return goto, gap[2], (gap[1], behind)


def _looped(draft: Draft, place: Moved, items: list[Item]) -> list[Item]:
    """The loops that a round which goes back to ``place`` is worked into, where its own words do not say them: those named there, else the
    ones that the rounds above it left."""
    if any(isinstance(i, Action) and i.name in ("flo", "blo", "bl") for i in items):
        return []
    number = place.number or _left_loops(draft)
    used = {
        i.name for line in draft.lines if line.number == number + 1 for i in line.items if isinstance(i, Action)
    } & {"flo", "blo"}
    left = {"flo": "blo", "blo": "flo"}[used.pop()] if place.free and len(used) == 1 else ""
    loops = place.loops or left
    return [Action(loops, place.span)] if loops else []


def _skipped(draft: Draft, number: int, place: Moved, stitches: dict[str, Stitch]) -> tuple[int, int, int] | None:
    """The round whose stitches a round skips that is worked on it, where ``place`` is the skipped ones of Round ``number`` (0: the last
    ones); how many of its stitches lie before them, and how many they are. That the round which skips them, or the next one, is named
    instead is a usual slip. None where it is no such place."""
    if not place.free or place.loops:
        return None
    skips = {
        line.number: (line.items[:k], item.times)
        for line in draft.lines
        for k, item in enumerate(line.items)
        if line.in_round and line.number and isinstance(item, Action) and item.name == "skip" and item.times >= _SEVERAL
    }
    by = [n for n in (number + 1, number, number - 1) if n in skips and n > 1] if number else sorted(skips)[-1:]
    if not by:
        return None
    before, many = skips[by[0]]
    ahead = worked(before, MOST, stitches)
    return by[0] - 1, ahead[1] if ahead else MOST, many


def _limb(name: str) -> bool:
    return any(kind_of(one(w)) in ("leg", "arm") for w in re.split(r"[\W_\d]+", name.lower()))


def _skip(many: int, place: Moved) -> list[Item]:
    return [Action("skip", place.span, many)] if many else []


def _left_loops(draft: Draft) -> int:
    """The last round that one above it leaves loops of."""
    for line in reversed(draft.lines):
        single = any(isinstance(i, Action) and i.name in ("flo", "blo") for i in line.items)
        if single and line.in_round and line.number is not None and line.number > 1:
            return line.number - 1
    return 0


def frilled(p: State, draft: Draft, tokens: list[Token], times: int) -> Body | None:
    """A round that fits only where the one below it, yarn joined "to back loop of Round 41" and worked into back loops, stands on the loops
    that Round 41 left when it was worked into front loops: its body, that one being put there, which is told. None where it is not so."""
    rounds = [k for k, line in enumerate(draft.lines) if line.in_round]
    if len(rounds) < 3 or draft.last < 3:
        return None
    at, frill = draft.lines[rounds[-1]], draft.lines[rounds[-2]]
    said = [{i.name for i in line.items if isinstance(i, Action)} for line in (at, frill)]
    back = draft.edges.get(draft.last - 2, 0)
    if at.times > 1 or frill.times > 1 or not {"color", "blo"} <= said[0] or "flo" not in said[1] or "goto" in said[0]:
        return None
    below = after(at.items, back, p.source.stitches) if back else None
    again = tried(p.source, tokens, p.palette, below, p.phrases, times) if below else None
    if below is None or again is None or not again.fit or again.stated is None:
        return None
    closed = closes(draft.lines[rounds[-3]])
    found = back_to(draft, Moved(at.span, draft.last - 2))
    if found is None:
        return None
    k = next(k for k, line in enumerate(draft.lines) if line is at)
    draft.lines[k] = replace(at, items=(found[0], *(at.items if closed else lifted(list(at.items)))))
    draft.edge = draft.edges[draft.last] = below
    message = f"the loops meant here are those left of Round {draft.last - 2}: the count of the round after it speaks for them"
    p.source.doubt(message, "name that round", at.span)
    return again


def elsewhere(
    p: State, draft: Draft, head: Head, read: Body, place: Moved, what: tuple[list[Token], int, Span]
) -> tuple[Draft, Head, Body]:
    """A round that is worked elsewhere than where the hook is: back on a round of the part, or along an edge, which is a part of
    its own then."""
    tokens, times, span = what
    another = bool(place.words) and named([one.name for one in p.parts], place.words) is not None
    here = place.number == draft.last and draft.begun() and not another
    if place.number and here and _skipped(draft, place.number, place, p.source.stitches) is None:
        return draft, head, read  # the edge at the hook
    owner = draft if draft.begun() else p.parts[-2] if len(p.parts) > 1 and not place.words else draft
    # A limb with a heading of its own is a part of its own, which is sewn to what was skipped.
    limb = _limb(draft.name if not draft.begun() else p.under.name if p.under is not None else "")
    left = _skipped(owner, place.number, place, p.source.stitches) if place.number and owner.begun() else None
    if left is not None and left[0] != place.number:
        limb = False  # a slip: the round that is named leaves none, and the limb goes on from the one that does
    back = back_to(owner, place, None if limb else p.source.stitches) if owner.begun() and read.refers is None else None
    if back is not None:
        goto, edge, (ahead, behind) = back
        again = tried(p.source, tokens, p.palette, edge, p.phrases, times)
        if again is not None and again.items and (again.fit or again.stated is None):
            if owner is not draft:
                p.parts.remove(draft)
                owner.lines += [line for line in draft.lines if not draft.begun()]
            owner.leave(p.source)
            end = -1 if isinstance(last := again.items[-1], Action) and last.name == "join" else None
            items = [
                *_skip(ahead, place),
                *_looped(owner, place, again.items),
                *again.items[:end],
                *_skip(behind, place),
            ]
            again.items[:end] = [goto, *items]
            owner.edge, owner.chain, owner.sure = edge, None, True
            if head.numbers and head.numbers[0] <= owner.last and owner is not draft:
                owner.offset = owner.last
                head = replace(head, numbers=tuple(n + owner.offset for n in head.numbers))
            return owner, head, again
    if draft.begun():
        under = p.under if limb else None
        p.heading = p.heading or under or Heading(f"{draft.name or 'piece'} edging".strip(), place.span)
        lead = draft.last
        p.begin(True, span)
        draft = p.parts[-1]
        draft.offset, draft.last = (0, lead) if head.numbers and head.numbers[0] == lead + 1 else (0, 0)
    return draft, head, based(p, draft, head, read, (tokens, times)) or read


def based(p: State, draft: Draft, head: Head, read: Body, what: tuple[list[Token], int]) -> Body | None:
    """A round on an edge that is not known, on a chain of as many stitches, which is told; None where it does not say how many."""
    if is_first(read, p.source.stitches) or draft.chain is not None:
        return None
    count = base(
        [i for i in read.items if not (isinstance(i, Action) and i.name == "goto")],
        read.stated,
        p.source.stitches,
    )
    if not count or count > MOST:
        return None
    at = head.span
    tokens, times = what
    again = tried(p.source, tokens, p.palette, count, p.phrases, times)
    if again is None:
        return None
    p.source.doubt(
        f"{UNKNOWN}: it is worked on a chain of {count}",
        "name the round: join with sl st to Rnd 5 of Head",
        at,
    )
    said = (_clause(p, read.moved.span),) if read.moved is not None else ()
    hue = read.items[0] if read.items else None
    if isinstance(hue, Action) and hue.name == "color":
        draft.lines.append(Line((hue,), at, False))  # the chain is of the yarn that is joined for the round
    draft.lines.append(
        Line(foundation(count, at, head.row), at, False, notes=said)
    )  # what is amiss in the round is not in its chain; where hands work it stands beside
    draft.edge, draft.flat = count, head.row
    again.items = [i for i in lifted(again.items) if not (isinstance(i, Action) and i.name == "fold")]
    return again


def _clause(p: State, span: Span) -> Span:
    """The clause that words stand in, from them to its end."""
    stop = _STOP.search(p.source.text.text, span.end)
    return Span(span.start, stop.start() if stop is not None else span.end)


def is_first(body: Body, stitches: dict[str, Stitch]) -> bool:
    """Whether a body begins a piece of its own."""
    begun = next((k for k, i in enumerate(body.items) if makes(i)), len(body.items))
    founded = any(
        is_start(i, stitches) and not (isinstance(i, Action) and i.name == "ch" and (i.times <= LIFT or k > begun))
        for k, i in enumerate(body.items)
        if not isinstance(i, Group) or i.times is not None  # "*sl st in next st, ch 3" goes around on what is there
    )
    return bool(body.hook) or body.pending or founded

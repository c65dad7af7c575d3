"""Printed patterns, redyed: rounds that change their yarn at the end of one of them, and rounds worked again in other yarns."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from itertools import pairwise

from tambour.core.rgb import RGB
from tambour.crochet.language.tree import Action, Group, Item, Line
from tambour.crochet.printed.parts.risen import closes
from tambour.crochet.printed.rounds.items import flat, span_of, works


def colored(lines: list[Line], later: list[tuple[Item, int]]) -> list[Line]:
    """``lines`` with the colours behind them that are changed to when they are worked, or in the midst of them: "Rounds 3-6: …; change
    to B at end of Round 4"."""
    for hue, number in later:
        if closes(hue):
            lines = _closed(lines, hue, number)
            continue
        dyed = Line((hue,), span_of(hue), False)
        at = next(
            (k for k, n in enumerate(lines) if n.number is not None and n.number <= number < n.number + n.times - 1),
            None,
        )
        if at is None:
            lines = [*lines, dyed]
            continue
        line = lines[at]
        done = number - (line.number or 0) + 1
        rest = line.times - done
        first = replace(line, times=done, times_span=line.times_span if done > 1 else None)
        more = replace(line, times=rest, times_span=line.times_span if rest > 1 else None, number=number + 1)
        lines = [*lines[:at], first, dyed, more, *lines[at + 1 :]]
    return lines


def spotted(lines: list[Line]) -> list[Line]:
    """``lines`` whose spots are worked in a yarn of their own and leave the round in that of its ground: "(7 sc red, 1 bobble white) x 6", under
    red rounds, is followed by red ones where the text names no other."""
    made = list(lines)
    now: tuple[int, ...] = ()
    for k, line in enumerate(lines):
        dyes = [i for item in line.items for i in flat(item) if isinstance(i, Action) and i.name == "color"]
        last = line.items[-1] if line.items else None
        within = isinstance(last, Group) and (last.times or 0) > 1 and dyes[:1] == flat(last)[:1] != []
        if within and dyes[0].numbers == now != dyes[-1].numbers and not _begins_dyed(lines[k + 1 :]):
            made[k] = replace(line, items=(*line.items, dyes[0]))
            continue
        now = dyes[-1].numbers if dyes else now
    return made


def _begins_dyed(lines: list[Line]) -> bool:
    """Whether the next line that does anything names its yarn before any stitch."""
    after = next((one for line in lines for item in line.items for one in flat(item)), None)
    return isinstance(after, Action) and after.name == "color"


def _closed(lines: list[Line], join: Item, number: int) -> list[Line]:
    """``lines`` of which one round is joined: the one with that number, or the last."""
    at = next((k for k, n in enumerate(lines) if n.number and n.number <= number < n.number + n.times), len(lines) - 1)
    line = lines[at]
    begin = line.number or 0
    done = number - begin if begin <= number < begin + line.times else line.times - 1
    parts = [
        replace(
            line,
            items=(*line.items, *items),
            times=many,
            times_span=line.times_span if many > 1 else None,
            number=None if line.number is None else begin + before,
            notes=line.notes if before + many == line.times else (),
        )
        for many, before, items in ((done, 0, ()), (1, done, (join,)), (line.times - done - 1, done + 1, ()))
        if many
    ]
    return [*lines[:at], *parts, *lines[at + 1 :]]


def handed_on(items: list[Item]) -> tuple[list[Item], Item | None]:
    """``items`` of several rounds without the colour that stands behind their stitches, and that colour: the last of these rounds ends with it."""
    last = next((k for k in range(len(items) - 1, -1, -1) if works(items[k])), len(items))
    hues = [i for i in items[last + 1 :] if isinstance(i, Action) and i.name == "color"]
    return ([i for i in items if i not in hues], hues[-1]) if hues else (items, None)


def dressed(lines: tuple[Line, ...], every: list[Line], anew: bool) -> tuple[Line, ...]:
    """``lines``, rounds of the part whose lines are ``every``, with the changes of colour that stand between them there: "Change to B".

    anew : they are worked again in the same part, so that the first of them goes back to its own colour
    """
    before: dict[int, tuple[Item, ...]] = {}  # where a round begins → the change above it
    colors: dict[int, tuple[Item, ...]] = {}  # … and the colour that it is begun in
    above: tuple[Item, ...] = ()
    now: tuple[Item, ...] = ()
    for line in every:
        hues = tuple(i for i in line.items if isinstance(i, Action) and i.name == "color")[-1:]
        if line.in_round:
            before[line.span.start], colors[line.span.start] = above, above or now
        now = hues or now
        above = () if line.in_round else hues or above
    rest = tuple(replace(one, items=(*before.get(one.span.start, ()), *one.items)) for one in lines[1:])
    changed = anew and any(before.get(one.span.start) for one in lines[1:])
    first = colors.get(lines[0].span.start, ()) if changed else ()
    return (replace(lines[0], items=(*first, *lines[0].items)), *rest)


def redyed(line: Line, lines: list[Line], hues: list[RGB]) -> list[Line]:
    """The rounds of ``line``, which are some of ``lines``, in other yarns: these take the place of the colours there in their order."""
    seen = [i.numbers for one in lines for i in one.items if isinstance(i, Action) and i.name == "color"]
    dyes = dict(zip(dict.fromkeys(seen), hues, strict=False))
    made = [replace(one, items=tuple(dyed(i, dyes) for i in one.items)) for one in line.rounds()]
    begun = Action("color", line.span, numbers=hues[0])
    return [replace(made[0], items=(begun, *made[0].items)), *made[1:]]


def turned_to(made: list[Line], later: list[tuple[Action, int]], first: int) -> list[Line]:
    """Rounds one by one, ``made``, the first of which is numbered ``first`` where it is written, that change their yarn at the end of some of them, "as for
    Head, changing to G at end of Round 4": in place of the yarn that is changed to there, or else of the next."""
    for hue, number in later:
        k = number - first
        items, old = handed_on(list(made[k].items))
        behind = (i for one in made[k + 1 :] for i in one.items if isinstance(i, Action) and i.name == "color")
        old = old or next(behind, None)
        dyes = {old.numbers: hue.numbers} if isinstance(old, Action) else {}
        rest = [replace(one, items=tuple(dyed(i, dyes) for i in one.items)) for one in made[k + 1 :]]
        made = [*made[:k], replace(made[k], items=(*items, hue)), *rest]
    return made


def dyed(item: Item, hues: Mapping[tuple[int, ...], tuple[int, ...]]) -> Item:
    """``item`` with other colours in place of those it changes to."""
    if isinstance(item, Group):
        return replace(item, items=tuple(dyed(i, hues) for i in item.items))
    return replace(item, numbers=hues.get(item.numbers, item.numbers)) if item.name == "color" else item


def worn(lines: list[Line], numbers: tuple[int, ...], hue: Item) -> list[Line] | None:
    """``lines`` whose rounds of these ``numbers`` are worked in a yarn that is said behind them all, "Rnd 9: white"; None where they are not
    all there. The yarn before them goes on after them."""
    first, last = numbers[0], numbers[-1]
    made: list[Line] = []
    before: Line | None = None
    left = last - first + 1
    for line in lines:
        dyed = any(isinstance(i, Action) and i.name == "color" for i in line.items)
        if line.number is None or not line.in_round or line.again is not None:
            before = Line(line.items, line.span, False) if dyed and not any(map(works, line.items)) else before
            made.append(line)
            continue
        for piece in _parted(line, first, last + 1):
            number = piece.number or 0
            if number == first:
                made.append(Line((hue,), span_of(hue), False))
            elif number == last + 1 and before is not None and not left:
                made.append(before)
            left -= piece.times if first <= number <= last else 0
            made.append(piece)
    return None if left else made


def _parted(line: Line, *at: int) -> list[Line]:
    """A line of rounds as several, each of which ends before one of the numbers ``at``."""
    begin = line.number or 0
    cuts = [begin, *(n for n in at if begin < n < begin + line.times), begin + line.times]
    return [
        replace(
            line,
            times=to - since,
            times_span=line.times_span if to - since > 1 else None,
            number=since,
            notes=line.notes if to == cuts[-1] else (),
        )
        for since, to in pairwise(cuts)
    ]

"""Printed patterns, otherwise: other ways to read what a round repeats, tried where the plain reading does not make its count."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Final

from tambour.crochet.language.stitches import Stitch
from tambour.crochet.language.tree import Action, Group, Item
from tambour.crochet.printed.rounds.reckoned import worked
from tambour.crochet.printed.rounds.repeats import led
from tambour.crochet.printed.tokens import Token


def run_on(items: list[Item], edge: int, stitches: dict[str, Stitch]) -> list[Item] | None:
    """``items`` with the beginning of one more repeat where what goes around leaves too few stitches for the whole of it; None where it
    leaves none."""
    for k, group in enumerate(items):
        if not isinstance(group, Group) or group.times is not None:
            continue
        before, once = worked(items[:k], edge, stitches), worked(group.items, edge, stitches)
        if before is None or once is None or not once[1]:
            return None
        left = (edge - before[1] - group.leaves) % once[1]
        more: list[Item] = []
        for item in group.items:
            kind = stitches.get(item.name) if isinstance(item, Action) else None
            fits = left // kind.takes if kind is not None and kind.takes else 0
            if isinstance(item, Action) and item.name in ("color", "flo", "blo", "bl"):
                more.append(item)
                continue
            if kind is None or not fits or not isinstance(item, Action):
                break
            more.append(replace(item, times=min(fits, item.times)))
            left -= kind.takes * min(fits, item.times)
        return [*items[: k + 1], *more, *items[k + 1 :]] if more and not left else None
    return None


def all_times(items: list[Item]) -> list[Item] | None:
    """``items`` with all that stands before the stitch that is worked several times repeated with it, "1 sc, 1 inc x 6" as "(1 sc, 1 inc) x 6";
    None where nothing does."""
    lead, rest = led(items)
    if len(rest) < 2 or not all(isinstance(i, Action) for i in rest[:-1]):
        return None
    last = rest[-1]
    if isinstance(last, Group):
        one, many = last.items[0] if len(last.items) == 1 else None, last.times
    else:
        one, many = replace(last, times=1, times_span=None), last.times
    if one is None or not many or many < 2:
        return None
    return [*lead, Group((*rest[:-1], one), many, last.span)]


def times_first(items: list[Item]) -> list[Item] | None:
    """The same where stitches follow, "3 sc, 1 dec x 7, 1 sc" as "(3 sc, 1 dec) x 7, 1 sc"; None where none do."""
    lead, rest = led(items)
    at = next((k for k, i in enumerate(rest) if isinstance(i, Group)), 0)
    if not 0 < at < len(rest) - 1:
        return None
    first = all_times([*lead, *rest[: at + 1]])
    return [*first, *rest[at + 1 :]] if first is not None else None


_INTO_ONE: Final = re.compile(r"inc([3-9]?)")


def all_around(items: list[Item]) -> list[list[Item]]:
    """``items`` with all that stands before the stitch that goes around repeated with it, "sc 2, dec around" as "(sc 2, dec) around", and
    "inc, 3 sc around", three of which would be in one stitch, as "(inc, 3 sc) around"; none where nothing stands before it."""
    lead, rest = led(items)
    at = next((k for k, i in enumerate(rest) if isinstance(i, Group)), 0)
    group = rest[at] if at else None
    plain = isinstance(group, Group) and group.times is None and not group.leaves and len(group.items) == 1
    if not plain or not isinstance(group, Group) or not all(isinstance(i, Action) for i in rest[:at]):
        return []
    last = group.items[0]
    ways = [last]
    if isinstance(last, Action) and last.times == 1 and (found := _INTO_ONE.fullmatch(last.name)) is not None:
        ways.append(replace(last, name="sc", times=int(found[1] or 2)))
    return [[*lead, replace(group, items=(*rest[:at], way)), *rest[at + 1 :]] for way in ways]


def makes_all(items: list[Item], edge: int, stated: int | None, stitches: dict[str, Stitch]) -> bool:
    """Whether items work the whole round below and make what is stated."""
    return worked(items, edge, stitches) == (stated, edge)


def later(items: list[Item]) -> list[list[Item]]:
    """``items`` whose repeat begins later than after the first of them: "13 sc, inc, 3 sc, rep 3 times" as "13 sc, (inc, 3 sc) x 3"."""
    made = []
    for at, item in enumerate(items):
        if isinstance(item, Group) and item.times is not None and item.times > 1:
            made += [
                [*items[:at], *item.items[:k], replace(item, items=item.items[k:]), *items[at + 1 :]]
                for k in range(1, len(item.items))
            ]
    return made


def singly(items: list[Item], stitches: dict[str, Stitch]) -> list[Item]:
    """``items`` with the increase that each repeat around begins with as so many stitches one by one: "3 sc in next st, 2 sc in next st, repeat",
    which some write for "3 sc, inc"."""
    made = []
    for item in items:
        first = item.items[0] if isinstance(item, Group) and item.times is None and len(item.items) > 1 else None
        kind = stitches.get(first.name) if isinstance(first, Action) and first.times == 1 else None
        made_of = {m.kind for m in kind.moves if m.kind} if kind is not None else set()
        increase = kind is not None and kind.takes == 1 < kind.makes and len(made_of) == 1
        if isinstance(item, Group) and isinstance(first, Action) and kind is not None and increase:
            plain = replace(first, name=made_of.pop(), times=kind.makes)
            item = replace(item, items=(plain, *item.items[1:]))
        made.append(item)
    return made


_SIDES: Final = frozenset(("first", "1st", "right", "left", "second", "2nd", "other"))
_LIMBS: Final = frozenset("leg arm ear wing foot hand paw fin horn sleeve shoe boot eye one piece".split())


def two_sided(tokens: list[Token]) -> tuple[list[Token], list[Token]] | None:
    """The words of a round for one of two pieces, and those for the other: "For the right leg: 7 sc, fasten off; for the left leg: 14 sc"; None
    where none are."""
    other = next((k for k in range(1, len(tokens)) if tokens[k - 1].word in (";", ".") and _for_one(tokens, k)), 0)
    if not other or not all(any(t.kind == "stitch" for t in some) for some in (tokens[:other], tokens[other:])):
        return None
    colon = next(k for k in range(other, len(tokens)) if tokens[k].word == ":")
    begin = next(k for k in range(other) if tokens[k].word == ":") + 1 if _for_one(tokens, 0) else 0
    named = tokens[colon - 1].word in _LIMBS
    return (tokens[begin : other - 1], tokens[other:]) if named else None


def _for_one(tokens: list[Token], k: int) -> bool:
    """Whether "for the right leg:" stands there; fillers may be gone."""
    colon = next((n for n in range(k + 2, min(k + 5, len(tokens))) if tokens[n].word == ":"), 0)
    return bool(colon) and tokens[k].word == "for" and any(t.word in _SIDES for t in tokens[k:colon])

"""Printed patterns, ovals: a first round that goes on along the other side of its chain though no word says so: "4 sc, 3 sc in last ch, 3 sc, inc",
"ch 6, sk 1, 4 sc, [3 sc], 3 sc, inc"."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

from tambour.crochet.language.stitches import Stitch, into_one
from tambour.crochet.language.tree import Action, Group, Item

_END: Final = 3  # stitches in the chain at the turn, at least
_LEAD: Final = ("ch", "color")  # what may stand before the first stitch


def both_sides(items: list[Item], base: int, stitches: dict[str, Stitch]) -> tuple[list[Item], int] | None:
    """``items`` without what only turns the work, and after how many of them it goes on along the other side of a chain of ``base``; None where
    they do not: they use it up with three or more in its last, and go on with about as many. What is bracketed once there is worked into one."""
    lead = next((k for k, i in enumerate(items) if not (isinstance(i, Action) and i.name in _LEAD)), 0)
    if (
        (first := items[lead : lead + 1])
        and isinstance(first[0], Action)
        and (first[0].name, first[0].times) == ("skip", 1)
    ):
        items = [*items[:lead], *items[lead + 1 :]]  # the chain at the hook
    taken = 0
    for k, item in enumerate(items):
        once = _takes(item, stitches)
        if once is None:
            return None
        if taken == base - 1 and once >= _END and (bunch := _bunched(item, stitches)) is not None:
            once, item = 1, bunch
            items = [*items[:k], item, *items[k + 1 :]]
        taken += once
        if taken < base:
            continue
        while isinstance(item, Group) and item.times == 1 and len(item.items) == 1:
            item = item.items[0]
        kind = stitches.get(item.name) if isinstance(item, Action) else None
        if taken > base or kind is None or kind.takes != 1 or kind.makes < _END:
            return None
        rest = items[k + 1 :]
        while rest and isinstance(rest[0], Action) and rest[0].name == "turn":
            rest = rest[1:]
        if rest and isinstance(rest[-1], Action) and (rest[-1].name, rest[-1].times) == ("slst", 1):
            rest = [*rest[:-1], Action("join", rest[-1].span)]
        more = [_takes(i, stitches) for i in rest]
        if None in more or sum(n or 0 for n in more) not in (base - 2, base - 1, base) or base < _END:
            return None
        return [*items[: k + 1], *rest], k + 1
    return None


def _bunched(item: Item, stitches: dict[str, Stitch]) -> Action | None:
    """The stitch into one that a bracket around stitches of one kind is, "[4 sc]"; None for other items."""
    one = item.items[0] if isinstance(item, Group) and item.times == 1 and len(item.items) == 1 else None
    if not isinstance(one, Action) or one.name not in stitches or stitches[one.name].takes != 1:
        return None
    made = into_one([(stitches[one.name], one.times)])
    return replace(one, name=stitches.setdefault(made.name, made).name, times=1, times_span=None)


def _takes(item: Item, stitches: dict[str, Stitch]) -> int | None:
    """How many stitches an item takes; None where that hangs on the round."""
    if isinstance(item, Group):
        inner = [_takes(i, stitches) for i in item.items]
        return None if item.times is None or None in inner else item.times * sum(n or 0 for n in inner)
    if item.name == "ch" or item.name not in stitches:
        return 0
    return stitches[item.name].takes * item.times

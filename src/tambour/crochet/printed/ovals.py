"""Printed patterns, ovals: a first round that goes on along the other side of its chain though no word says so: "4 sc, 3 sc in last ch, 3 sc, inc"."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from tambour.crochet.language.stitches import Stitch
from tambour.crochet.language.tree import Action, Group, Item

_END: Final = 3  # stitches in the chain at the turn, at least


def both_sides(items: list[Item], base: int, stitches: Mapping[str, Stitch]) -> tuple[list[Item], int] | None:
    """``items`` without what only turns the work, and after how many of them it goes on along the other side of a chain of ``base``; None where
    they do not: they use it up with three or more in its last, and go on with about as many."""
    taken = 0
    for k, item in enumerate(items):
        once = _takes(item, stitches)
        if once is None:
            return None
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
        more = [_takes(i, stitches) for i in rest]
        if None in more or sum(n or 0 for n in more) not in (base - 2, base - 1, base) or base < _END:
            return None
        return [*items[: k + 1], *rest], k + 1
    return None


def _takes(item: Item, stitches: Mapping[str, Stitch]) -> int | None:
    """How many stitches an item takes; None where that hangs on the round."""
    if isinstance(item, Group):
        inner = [_takes(i, stitches) for i in item.items]
        return None if item.times is None or None in inner else item.times * sum(n or 0 for n in inner)
    if item.name == "ch" or item.name not in stitches:
        return 0
    return stitches[item.name].takes * item.times

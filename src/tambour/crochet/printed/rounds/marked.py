"""Printed patterns, the marked stitch: where the middle of the last stitches in one place is ("PM on center sc of last group of 3 sc"),
and where rounds carry it, so that the next can go "to marked sc"."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

from tambour.crochet.language.stitches import Stitch
from tambour.crochet.language.tree import Group, Item
from tambour.crochet.printed.cursor import Cursor

_MIDDLE = frozenset(("center", "centre", "middle"))
_MOST: Final = 5000  # stitches of a round that are followed


def _steps(items: tuple[Item, ...] | list[Item], edge: int, stitches: dict[str, Stitch]) -> Iterator[tuple[int, int]]:
    """How many stitches each of ``items`` takes of an edge of so many, and makes, one after the other; of an item not many
    more than _MOST: rows that double, again and again, outgrow every machine."""
    left = edge
    for item in items:
        if isinstance(item, Group):
            once = sum(t for t, _ in _steps(item.items, left, stitches))
            times = item.times if item.times is not None else (max(0, left - item.leaves) // once if once else 0)
            one = list(_steps(item.items, left, stitches))
            one *= min(times, _MOST // max(len(one), 1) + 1)
        else:
            kind = stitches.get(item.name)
            one = [] if kind is None or item.name == "ch" else [(kind.takes, kind.makes)] * min(item.times, _MOST)
        left -= sum(t for t, _ in one)
        yield from one


def taken(items: list[Item], edge: int, stitches: dict[str, Stitch]) -> int:
    """How many stitches of the round below ``items`` use up."""
    return sum(t for t, _ in _steps(items, edge, stitches))


def middle(
    items: tuple[Item, ...] | list[Item], edge: int, mark: int | None, stitches: dict[str, Stitch]
) -> int | None:
    """Which stitch of the round that ``items`` work is the marked one, from 0: the middle of its last three (or five) in one
    place, or what stands over the stitch ``mark`` of the round below; None where neither is there."""
    found = over = None
    below = made = 0
    for takes, makes in _steps(items, edge, stitches):
        if takes == 1 and makes >= 3 and makes % 2:
            found = made + makes // 2
        if mark is not None and below <= mark < below + takes:
            over = made + max(0, makes - 1) // 2
        below, made = below + takes, made + makes
    return over if found is None else found


def named(c: Cursor, ahead: int = 0) -> int:
    """How many tokens at the cursor name the marked stitch: "marked sc", "center st of 3-sc group"; 0 for none."""
    word = c.look(ahead)
    if word is None or not (word.word == "marked" or word.word in _MIDDLE):
        return 0
    if not (c.key("stitch", ahead=ahead + 1) or c.kind("stitch", ahead + 1)):
        return 0
    many = 2
    if word.word in _MIDDLE and c.whole(ahead + 2) is not None:  # "of" is no token
        while many < 7 and (token := c.look(ahead + many)) is not None and token.word not in (",", ".", ";", "(", "["):
            many += 1
            if token.word in ("group", "cluster"):
                break
    return many

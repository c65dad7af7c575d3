"""Printed patterns, reckoned: the stitches that items of a round make and take, and how many stand on the edge after them."""

from __future__ import annotations

from typing import Final

from tambour.crochet.graph.hook import LIFT
from tambour.crochet.language.stitches import Stitch
from tambour.crochet.language.tree import Action, Group, Item, Line
from tambour.crochet.printed.rounds.repeats import led

_MOST: Final = 200  # rounds that are counted through


def worked(
    items: list[Item] | tuple[Item, ...], edge: int, stitches: dict[str, Stitch], begun: bool = False
) -> tuple[int, int] | None:
    """Stitches that ``items`` make and take on an edge of ``edge`` stitches; None when it is not known. ``begun`` : stitches stand before
    them, so that chains are a space."""
    made = taken = 0
    turned = False
    for k, item in enumerate(items):
        if turned and not isinstance(item, Group) and item.name == "ch":
            continue  # it lifts the yarn for the next row
        turned = not isinstance(item, Group) and item.name == "turn"
        if isinstance(item, Group):
            once = worked(item.items, edge - taken, stitches, begun or made > 0)
            if once is None:
                return None
            times = item.times
            if times is None:
                if once[1] == 0 or item.until:
                    return None
                times = max(0, edge - taken - item.leaves) // once[1]
            made, taken = made + once[0] * times, taken + once[1] * times
        elif item.name == "mr":
            made, taken, edge = item.numbers[0], 0, 0
        elif item.name in stitches:
            kind = stitches[item.name]
            if kind.where == "ring":
                made, taken, edge = kind.makes, 0, 0
            elif kind.where == "sp":
                return None
            elif item.name == "slst":
                made, taken = made + item.times, taken + item.times
            elif item.name != "ch" or made or begun:  # chains at the beginning only lift the yarn
                made, taken = made + kind.makes * item.times, taken + kind.takes * item.times
                if item.name == "ch" and item.times > LIFT and _turned(items, k + 1):
                    made -= 1  # the next row goes into this chain, from the 2nd from the hook
        elif item.name in ("turn", "join"):
            continue
        elif item.name == "gap":
            made, taken = item.numbers[0], edge
        elif item.name not in ("flo", "blo", "bl", "color", "fo", "goto", "edge", "tospace"):
            return None
    return made, taken


def _turned(items: list[Item] | tuple[Item, ...], at: int) -> bool:
    """Whether the work is turned at ``at``."""
    return at < len(items) and getattr(items[at], "name", "") == "turn"


def moved_in(items: list[Item]) -> int:
    """How many slip stitches and chains only move the yarn in before the first stitch of a row, which the next row leaves: "Sl st in first 2 sc. Ch 1. …"."""
    many = 0
    for item in items:
        if isinstance(item, Group):
            return 0
        if item.name == "slst":
            many += item.times or 0
        elif item.name == "ch" and many:
            return many + (item.times or 0)  # and the chains that lift it there
        elif item.name not in ("turn", "ch", "color", "flo", "blo", "bl"):
            return 0
    return 0


def after(items: list[Item] | tuple[Item, ...], edge: int | None, stitches: dict[str, Stitch]) -> int | None:
    """Stitches on the edge after ``items``, None when it is not known."""
    done = worked(items, edge or 0, stitches)
    if done is None:
        return None
    if any(not isinstance(i, Group) and (i.name in ("mr", "gap") or i.name.startswith("MR{")) for i in items):
        return done[0]
    return None if edge is None else edge - done[1] + done[0]


def chainless(items: list[Item], edge: int | None, stitches: dict[str, Stitch]) -> int | None:
    """Stitches that ``items`` make, chains aside; None when it is not known."""

    def chains(inner: list[Item] | tuple[Item, ...], left: int) -> int | None:
        total = 0
        for item in inner:
            if isinstance(item, Group):
                once = worked(item.items, left, stitches, True)
                found = chains(item.items, left)
                if once is None or found is None or (item.times is None and not once[1]):
                    return None
                times = (left - item.leaves) // once[1] if item.times is None else item.times
                total, left = total + found * times, left - once[1] * times
            elif item.name in stitches:
                kind = stitches[item.name]
                total += item.times * sum(move.kind == "ch" for move in kind.moves)
                left -= kind.takes * item.times
        return total

    _, items = led(items)
    done, out = worked(items, edge or 0, stitches), chains(items, edge or 0)
    return None if done is None or not out else done[0] - out


def fixed(items: list[Item] | tuple[Item, ...], stitches: dict[str, Stitch]) -> tuple[int, int] | None:
    """Stitches, and chains among them, that ``items`` make on whatever they are worked; None where something goes around."""
    made = chains = 0
    for item in items:
        if isinstance(item, Group):
            once = fixed(item.items, stitches)
            if once is None or item.times is None:
                return None
            made, chains = made + once[0] * item.times, chains + once[1] * item.times
        elif item.name in stitches and (item.name != "ch" or made):
            kind = stitches[item.name]
            made += kind.makes * item.times
            chains += sum(move.kind == "ch" for move in kind.moves) * item.times
        elif item.name == "gap":
            return None
    return made, chains


def after_all(items: list[Item], stitches: dict[str, Stitch]) -> int | None:
    """Stitches that ``items`` make, however many they are worked into."""
    done = worked(items, 0, stitches)
    return None if done is None else done[0]


def reached(items: list[Item], edge: int | None, stitches: dict[str, Stitch], times: int) -> int | None:
    """Stitches on the edge after ``times`` rounds of ``items``, None when it is not known."""
    for _ in range(min(times, _MOST)):
        before, edge = edge, after(items, edge, stitches)
        if edge is None or edge == before:
            break
    return edge


def rounds_until(lines: tuple[Line, ...], edge: int | None, count: int, stitches: dict[str, Stitch]) -> int:
    """How many rounds, ``lines`` again and again, there are until one makes ``count``; 0 where none does."""
    once = [line for line in lines for _ in range(line.times)]
    for k in range(_MOST):
        edge = after(once[k % len(once)].items, edge, stitches)
        if edge is None or edge == count:
            return 0 if edge is None else k + 1
    return 0


def rest_left(items: list[Item], edge: int, stitches: dict[str, Stitch]) -> list[Item]:
    """``items`` with the stitches that they leave of the round below skipped at their end, so that the next row has only these."""
    done = worked(items, edge, stitches)
    if done is None or not 0 < done[1] < edge:
        return items
    at = len(items)
    while at and isinstance(items[at - 1], Action) and items[at - 1].name in ("turn", "join", "color", "fo"):  # type: ignore[union-attr]
        at -= 1
    return [*items[:at], Action("skip", items[at - 1].span, edge - done[1]), *items[at:]]

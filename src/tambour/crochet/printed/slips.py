"""Printed patterns, slip stitches within a round: where the next round works into them, they are stitches, as low as can be."""

from __future__ import annotations

from dataclasses import replace

from tambour.crochet.language.source import Source
from tambour.crochet.language.stitches import Stitch, into_one
from tambour.crochet.language.tree import Group, Item, Line
from tambour.crochet.printed.counts import makes, slips
from tambour.crochet.printed.reckoned import after


def lowered(lines: list[Line], edges: dict[int, int], source: Source) -> list[Line]:
    """``lines`` of a part in rounds, with stitches in place of the slip stitches that their counts, or the round above, go over: "hdc in next
    6 sts, slip st in last 3 sts", worked three times. edges : rounds → stitches after them, slip stitches among them."""
    made = list(lines)
    for k, line in enumerate(lines):
        below = edges.get(line.number - 1) if line.number is not None else None
        if (
            below is None
            or line.again is not None
            or not any(map(slips, line.items))
            or not any(map(makes, line.items))
        ):
            continue
        whole = after(line.items, below, source.stitches)
        above = next((one for one in lines[k + 1 :] if one.in_round), None)
        if whole is None or _without(line, below, source.stitches) == line.stated is not None:
            continue
        if line.times > 1 or whole == line.stated or (above is not None and _fits(above, whole, source.stitches)):
            low = into_one([(source.stitches["slst"], 1)])
            source.stitches.setdefault(low.name, low)
            made[k] = replace(line, items=tuple(_low(i, low.name) for i in line.items))
    return made


def _without(line: Line, below: int, stitches: dict[str, Stitch]) -> int | None:
    """Stitches of a round, its slip stitches aside."""
    return after(line.items, below, {n: s for n, s in stitches.items() if n != "slst"})


def _fits(line: Line, edge: int, stitches: dict[str, Stitch]) -> bool:
    """Whether a round makes its count on so many stitches."""
    return line.again is None and line.stated is not None and after(line.items, edge, stitches) == line.stated


def _low(item: Item, name: str) -> Item:
    if isinstance(item, Group):
        return replace(item, items=tuple(_low(i, name) for i in item.items))
    return replace(item, name=name) if item.name == "slst" else item

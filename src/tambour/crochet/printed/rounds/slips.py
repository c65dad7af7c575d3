"""Printed patterns, slip stitches within a round: where the next round works into them, they are stitches, as low as can be."""

from __future__ import annotations

from dataclasses import replace

from tambour.crochet.language.source import Source
from tambour.crochet.language.stitches import STANDING, Stitch, into_one
from tambour.crochet.language.tree import Action, Group, Item, Line
from tambour.crochet.printed.rounds.counts import makes, slips
from tambour.crochet.printed.rounds.items import closes
from tambour.crochet.printed.rounds.reckoned import after, worked

_IDLE = ("color", "flo", "blo", "bl")
_AFTER = (*_IDLE, "ch", "fo")


def lowered(lines: list[Line], edges: dict[int, int], source: Source, flat: bool = False) -> list[Line]:
    """``lines`` of a part with stitches in place of the slip stitches that their counts, or the round above, go over: "hdc in next 6 sts, slip
    st in last 3 sts", worked three times; of one that is ``flat`` in rows that are worked again as wide as they are: "sl st 1, sc 14, sl st 1,
    ch 1, turn" for 24 rows. edges : rounds → stitches after them, slip stitches among them."""
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
        if flat and not (line.times > 1 and whole == below):
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


def joining(items: list[Item], edge: int | None, stated: int | None, stitches: dict[str, Stitch]) -> list[Item]:
    """``items`` of a round with a join in place of the slip stitch alone that nothing below is left for: "24 sc, sl st, ch 1. [24]".

    edge : stitches below
    """
    at = len(items) - 1
    while at > 0 and isinstance(one := items[at], Action) and one.name in _AFTER:
        at -= 1
    slip = items[at] if at > 0 else None
    if not isinstance(slip, Action) or slip.name != "slst" or slip.times != 1 or not any(map(makes, items[:at])):
        return items
    if any(isinstance(i, Action) and i.name == "join" for i in items[:at]):
        return items  # it goes on from where the round was joined
    done = worked(items[:at], edge or 0, stitches)
    ringed = any(isinstance(i, Action) and (i.name == "mr" or i.name.startswith("MR{")) for i in items[:at])
    if done is None or stated not in (None, done[0]) or not (ringed or done[1] == edge):
        return items
    return [*items[:at], Action("join", slip.span), *items[at + 1 :]]


def joined_last(lines: list[Line], before: list[Line]) -> list[Line]:
    """Rounds in a spiral, behind those ``before``, of which only the last is joined, where the yarn ends: "18th to 32nd rnds: … Sl st in first
    sc of rnd. Fasten off."."""
    one = lines[-1]
    last = one.items[-1] if one.items else None
    lead = next((i for i in one.items if not isinstance(i, Action) or i.name not in _IDLE), None)
    joined = isinstance(last, Action) and last.name == "join"
    lifted = isinstance(lead, Action) and lead.name in ("ch", "turn", *STANDING)
    below = next((line for line in reversed(before) if line.in_round), None)
    spiral = below is not None and below.again is None and not closes(below)
    if len(lines) > 1 or one.times < 2 or not joined or lifted or one.number is None or not spiral:
        return lines
    plain = replace(
        one, items=one.items[:-1], times=one.times - 1, times_span=one.times_span if one.times > 2 else None, notes=()
    )
    return [plain, replace(one, times=1, times_span=None, number=one.number + one.times - 1)]

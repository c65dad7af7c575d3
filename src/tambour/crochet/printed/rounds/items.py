"""Printed patterns, items: what one of a round does: founds a piece, works stitches, closes a round."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Final

from tambour.core.errors import Span
from tambour.crochet.graph.hook import LIFT
from tambour.crochet.language.source import Source
from tambour.crochet.language.stitches import STANDING, into_one
from tambour.crochet.language.tree import Action, Group, Item, Line
from tambour.crochet.printed.tokens import Token

STARTS: Final = ("oval", "fsc", "goto", "attach")


def founds(source: Source, item: Item) -> bool:
    """Whether a piece of work begins with an item."""
    if isinstance(item, Group):
        return any(founds(source, i) for i in item.items)
    return item.name in ("mr", "ch", "gap", *STARTS) or begins_ring(source, item)


def begins_ring(source: Source, action: Action) -> bool:
    """Whether an action is a magic ring."""
    return action.name == "mr" or (action.name in source.stitches and source.stitches[action.name].where == "ring")


def one_more(source: Source, ring: Action, chains: int) -> Action:
    """A ring whose first stitch is so many chains, or one more of its last kind where no stitch is as high as these."""
    inner = [(source.stitches[name], n) for name, n in source.stitches[ring.name].inner] if ring.name != "mr" else []
    inner = inner or [(source.stitches["sc"], ring.numbers[0])]
    name = next((name for name in STANDING if int(name[2]) == chains), "")
    more = [(source.stitches[name], 1), *inner] if name else [*inner[:-1], (inner[-1][0], inner[-1][1] + 1)]
    made = into_one(more, "ring")
    source.stitches.setdefault(made.name, made)
    return replace(ring, name=made.name)


def span_of(item: Item) -> Span:
    """The place of an item."""
    return item.span


def works(item: Item) -> bool:
    """Whether an item works stitches (chains aside)."""
    if isinstance(item, Group):
        return any(map(works, item.items))
    return item.name not in (
        "ch",
        "color",
        "turn",
        "join",
        "flo",
        "blo",
        "bl",
        "fo",
        "mark",
        "goto",
        "edge",
        "tospace",
        "firstspace",
        "sew",
        "attach",
    )


def skips(item: Item) -> bool:
    """Whether an item leaves stitches out."""
    return any(map(skips, item.items)) if isinstance(item, Group) else item.name == "skip"


def slips_only(item: Item) -> bool:
    """Whether an item works slip stitches, or nothing."""
    if isinstance(item, Group):
        return all(map(slips_only, item.items))
    return not works(item) or item.name in ("slst", "skip")


def closes(line: Line) -> bool:
    """Whether a line ends with a join or a turn."""
    ends = next((i for i in reversed(line.items) if goes(i)), None)
    return isinstance(ends, Action) and ends.name in ("join", "turn")


def dyes(items: Sequence[Item]) -> set[tuple[float, ...]]:
    """The colours that items change to, within their groups too."""
    own = {tuple(i.numbers) for i in items if isinstance(i, Action) and i.name == "color"}
    return own.union(*(dyes(i.items) for i in items if isinstance(i, Group)))


def goes(item: Item) -> bool:
    """Whether an item is more than a choice of colour or loops, or a chain."""
    return not isinstance(item, Action) or item.name not in ("color", "flo", "blo", "bl", "ch", "mark")


def sets_mark(item: Item) -> bool:
    """Whether an item sets a mark or goes back to one, which is done once."""
    return isinstance(item, Action) and item.name in ("mark", "goto")


_AFTER: Final = ("stitch", "rest", "total", "last", "round", "row", "to")


def bare_count(tokens: list[Token]) -> Token | None:
    """The number of a sentence that is only a count: ``36 sc``, ``18 sts at end of last rnd``; None for another sentence."""
    words = [t for t in tokens if t.kind != "mark"]
    first = words[0] if words else None
    if first is None or len(words) > 8 or first.kind != "number" or not isinstance(first.value, int):
        return None
    rest = words[1:]
    named = bool(rest) and (rest[0].kind == "stitch" or (rest[0].kind == "key" and rest[0].value == "stitch"))
    plain = all(t.kind == "stitch" or (t.kind == "key" and t.value in _AFTER) or t.word in ("end", "rem") for t in rest)
    return first if named and plain else None


EVENED: Final = 8
"""Stitches of an edge that "1 sc in next st. Sl st in next st. Fasten off." only makes even, at least."""


def evens(items: Sequence[Item]) -> bool:
    """Whether the last round of a piece is only a step down to the one before it: "1 sc in next st. Sl st in next st. Fasten off."."""
    names = [(i.name, i.times) for i in items if isinstance(i, Action) and i.name not in ("fo", "color")]
    ends = any(isinstance(i, Action) and i.name == "fo" for i in items)
    return ends and all(isinstance(i, Action) for i in items) and names in ([("sc", 1), ("slst", 1)], [("slst", 1)])


def lifts(items: list[Item]) -> bool:
    """Whether the chain of a round is as high as its first stitch, and no foundation: "Join B in any st, ch 3, dc in each st around"."""
    rest = [i for i in items if not (isinstance(i, Action) and i.name in ("color", "join", "slst"))]
    first = rest[0] if rest else None
    lift = isinstance(first, Action) and first.name == "ch" and first.times <= LIFT
    return lift and any(map(works, rest[1:]))


def lifts_alone(items: list[Item]) -> bool:
    """Whether a piece would begin with one chain that stitches are not worked into."""
    rest = [i for i in items if not (isinstance(i, Action) and i.name == "color")]
    first = rest[0] if rest else None
    return isinstance(first, Action) and first.name == "ch" and first.times == 1 and any(map(works, rest[1:]))


def smooths(items: list[Item]) -> bool:
    """Whether a sentence works one slip stitch and no more: "Sl st to first sc and fasten off"."""
    worked = [i for i in items if not isinstance(i, Action) or works(i)]
    return len(worked) == 1 and isinstance(worked[0], Action) and worked[0].name == "slst" and worked[0].times == 1


def flat(item: Item) -> list[Action]:
    """The actions of an item, one by one."""
    return [item] * item.times if isinstance(item, Action) else [i for i in item.items if isinstance(i, Action)]


def rings(item: object) -> bool:
    """Whether an item is a ring of several kinds of stitches."""
    return isinstance(item, Action) and item.name.startswith("MR{")

"""Printed patterns, motifs: squares, hexagons and flowers: rounds that are worked into a ring of chains, or begin in a chain space."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

from tambour.crochet.language.stitches import CHAINS, STANDING, Stitch, into_one
from tambour.crochet.language.tree import Action, Group, Item, Line
from tambour.crochet.printed.cursor import NotUnderstood
from tambour.crochet.printed.rounds.reader import Reader
from tambour.crochet.printed.tokens import Token

_MOST: Final = 240  # stitches and chains in one ring
_CORNERS: Final = ("corner", "corners")
_IDLE: Final = ("color", "flo", "blo", "bl")


def spaced(clause: list[Token]) -> bool:
    """Whether words that say where yarn is joined, or how far it is slipped, name a chain space or a corner: "in any ch-2 sp"."""
    if any(t.value in ("same", "as") or t.word == "between" for t in clause):
        return False
    corner = any(t.word in _CORNERS for t in clause) and len(clause) < 6
    return any(t.kind == "key" and t.value == "space" for t in clause) or (
        corner and not any(t.word == "of" for t in clause)
    )


def slipped_to(r: Reader, found: list[Item]) -> bool:
    """Takes slip stitches that a round begins with, "sl st in next 2 dc and in ch-2 sp", "sl st to corner", for the way to that space,
    where the round begins; the cursor stands behind the first of them."""
    c, begin = r.c, r.c.at
    if r.depth or any(not isinstance(i, Action) or i.name not in (*_IDLE, "slst", "ch") for i in found):
        return False
    r.to_separator()
    here = c.tokens[begin : c.at]
    while c.mark(",") and c.kind("stitch", 1) and c.look(1).value == "slst":  # type: ignore[union-attr]
        at = c.at  # "sl st in next dc, sl st in next ch-2 sp"
        c.at += 2
        r.to_separator()
        here += c.tokens[at : c.at]
    if not here or not spaced(here) or any(t.kind == "stitch" and t.value not in ("ch", "slst", *CHAINS) for t in here):
        c.at = begin
        return False
    found[:] = [i for i in found if not isinstance(i, Action) or i.name in _IDLE]
    found.append(Action("tospace", here[0].span, numbers=(0,)))
    return True


def standing_in(r: Reader, found: list[Item], parts: list[tuple[Stitch, int]]) -> list[tuple[Stitch, int]] | None:
    """What a round that begins in a space has there before ``parts``, "in same sp", and takes it out of ``found``: chains that stand for a
    stitch, and those of a space; None where it does not begin so, or has more."""
    at = next((k for k, i in enumerate(found) if isinstance(i, Action) and i.name == "tospace"), None)
    lead = [i for i in found[(at or 0) + 1 :] if not isinstance(i, Action) or i.name not in _IDLE]
    if at is None or any(not isinstance(i, Action) or not _fits_in(r.stitches, i) for i in lead):
        return None
    before = _stood(r.stitches, [i for i in lead if isinstance(i, Action)], parts)
    found[at + 1 :] = [i for i in found[at + 1 :] if i not in lead]
    return before


def _fits_in(stitches: dict[str, Stitch], action: Action) -> bool:
    """Whether an action is a stitch that others go into one place with."""
    return action.name in stitches and stitches[action.name].fits_in_one


def _stood(
    stitches: dict[str, Stitch], lead: list[Action], parts: list[tuple[Stitch, int]]
) -> list[tuple[Stitch, int]]:
    """The stitches that ``lead``, before ``parts``, is: of plain chains as many as ``parts`` are high stand for one of these, more than that
    are a space behind it, fewer only lift the yarn."""
    made = [(stitches[i.name], i.times) for i in lead]
    kind = next((s.name for s, _ in [*made, *parts] if s.name in CHAINS), "")
    if not made or made[0][0].name != "ch":
        return made
    high, many = CHAINS.get(kind, 0), made[0][1]
    if many <= 1 or not high or many < high or kind == "sc":
        return made[1:]
    stand = [(stitches[f"ch{high}{kind}"], 1)]
    return [*stand, *([(stitches["ch"], many - high)] if many > high else []), *made[1:]]


def begun(items: list[Item], stitches: dict[str, Stitch]) -> list[Item]:
    """``items`` of which those that the round begins with, in a space, go into it: "join in any ch-1 sp, ch 3, *3 dc in next sp"; and that
    end in the space that they began in."""
    at = next((k for k, i in enumerate(items) if isinstance(i, Action) and i.name == "tospace"), None)
    again = next((i.span for i in items if _ends_there(i)), None)
    if again is not None and (at is None or any(isinstance(i, Group) and _ends_there(i) for i in items)):
        raise NotUnderstood(Token("mark", "", again.start, again.end), "which space the round began in is not known")
    if at is None:
        return items
    first = next((k for k in range(at + 1, len(items)) if not _idle(items[k])), None)
    one = items[first] if first is not None else None
    if first is not None and isinstance(one, Action) and one.name in (*STANDING, "sc"):
        made = into_one([(stitches[one.name], one.times)], "sp")
        stitches.setdefault(made.name, made)
        items = [*items[:first], replace(one, name=made.name, times=1), *items[first + 1 :]]
    if again is not None:
        halved = Action("tospace", items[at].span, numbers=(1,))
        return [
            halved if k == at else i for k, i in enumerate(items) if not isinstance(i, Action) or i.name != "firstspace"
        ]
    return items


def _ends_there(item: Item) -> bool:
    """Whether an item goes into the space that its round began in."""
    return any(map(_ends_there, item.items)) if isinstance(item, Group) else item.name == "firstspace"


def net(item: Item, stitches: dict[str, Stitch]) -> bool:
    """Whether an item makes chains that stand between stitches worked into spaces, as often as there are spaces."""
    if isinstance(item, Group):
        return any(net(i, stitches) or _spaced_item(i, stitches) for i in item.items) and any(
            isinstance(i, Group) or i.name == "ch" or any(m.kind == "ch" for m in stitches[i.name].moves)
            for i in item.items
            if isinstance(i, Group) or i.name in stitches
        )
    return _spaced_item(item, stitches) and any(m.kind == "ch" for m in stitches[item.name].moves)


def chained(line: Line, stitches: dict[str, Stitch]) -> bool:
    """Whether chains may stand between the stitches that a round makes."""

    def holds(item: Item) -> bool:
        if isinstance(item, Group):
            return any(map(holds, item.items))
        return item.name in ("gap", "ch") or any(m.kind == "ch" for m in getattr(stitches.get(item.name), "moves", ()))

    return any(map(holds, line.items)) or (
        line.again is not None and any(chained(one, stitches) for one in line.again.lines)
    )


def _spaced_item(item: Item, stitches: dict[str, Stitch]) -> bool:
    return isinstance(item, Action) and item.name in stitches and stitches[item.name].where == "sp"


def as_they_come(items: list[Item], stitches: dict[str, Stitch]) -> list[Item]:
    """``items`` with what goes into each stitch around, and what goes into each space around, as one repeat, which works either as the round
    below has them: "sc in each dc and (sc, ch 2, sc) in each ch-2 sp around"."""
    made: list[Item] = []
    for item in items:
        last = made[-1] if made else None
        if (
            isinstance(item, Group)
            and isinstance(last, Group)
            and item.times is None
            and last.times is None
            and not (last.leaves or last.until)
        ):
            into = [all(_spaced_item(i, stitches) for i in g.items) for g in (last, item)]
            if into == [False, True]:
                made[-1] = Group((last, item), None, last.span)
                continue
            if into == [True, True]:
                made[-1] = Group((*last.items, *item.items), None, last.span)
                continue
        made.append(item)
    return made


def _idle(item: Item) -> bool:
    return isinstance(item, Action) and item.name in _IDLE


def gathered(items: list[Item], stitches: dict[str, Stitch], token: Token) -> list[Item]:
    """``items`` of a round of which several go into one ring, "(3 dc in ring, ch 2) 4 times", as that ring of all of them, with the chains
    between: these are its spaces. NotUnderstood where they are too many."""

    def rings(item: Item) -> int:
        if isinstance(item, Group):
            return sum(map(rings, item.items)) * (item.times or 1)
        return item.name == "mr" or (item.name in stitches and stitches[item.name].where == "ring")

    held = [k for k, i in enumerate(items) if rings(i)]
    chained = any(isinstance(i, Group) for k, i in enumerate(items) if k in held)
    if sum(map(rings, items)) < 2 and not chained:
        return items
    begin, end = held[0], held[-1] + 1
    while begin and isinstance(items[begin - 1], Action) and items[begin - 1].name in ("ch", *STANDING):  # type: ignore[union-attr]
        begin -= 1
    while end < len(items) and items[end].name == "ch":  # type: ignore[union-attr]
        end += 1
    turns = end < len(items) and isinstance(items[end], Action) and items[end].name == "turn"  # type: ignore[union-attr]
    end = (
        held[-1] + 1
        if turns or (end == len(items) and _is_chain(items[-1]) and not _is_chain(items[held[-1]]))
        else end
    )
    parts: list[tuple[Stitch, int]] = []
    for item in items[begin:end]:
        _inside(item, 1, stitches, parts, token)
    lead = [i for i in items[begin : held[0]] if isinstance(i, Action)]
    if lead:
        parts = [*_stood(stitches, lead, parts[len(lead) :]), *parts[len(lead) :]]
    if {s.name for s, _ in parts} == {"sc"}:
        one = Action("mr", items[held[0]].span, numbers=(sum(n for _, n in parts), 0))
        return [*items[:begin], one, *items[end:]]
    if any(stitch.name != "slst" and not stitch.fits_in_one for stitch, _ in parts):
        raise NotUnderstood(token, "this does not go into one ring", "say which stitches go into the ring")
    made = into_one(parts, "ring")
    stitches.setdefault(made.name, made)
    return [*items[:begin], Action(made.name, items[held[0]].span), *items[end:]]


def _is_chain(item: Item) -> bool:
    return isinstance(item, Action) and item.name == "ch"


def _inside(item: Item, times: int, stitches: dict[str, Stitch], parts: list[tuple[Stitch, int]], token: Token) -> None:
    """The stitches of ``item`` into ``parts``, those of rings as they are in them."""
    if len(parts) > _MOST:
        raise NotUnderstood(token, "too many stitches in one ring", f"at most {_MOST}")
    if isinstance(item, Group):
        if item.times is None:
            raise NotUnderstood(token, "how often this goes into the ring is not said", "say how many times")
        for _ in range(min(item.times, _MOST)):
            for inner in item.items:
                _inside(inner, times, stitches, parts, token)
    elif item.name == "mr":
        parts.append((stitches["sc"], item.numbers[0]))
    elif item.name in stitches:
        kind = stitches[item.name]
        parts += [(stitches[name], n) for name, n in kind.inner] if kind.where == "ring" else [(kind, item.times)]

"""Printed patterns, risen: how a round or row rises to its first stitch: chains that lift the yarn or stand for a stitch, and turns that nobody
says."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from typing import TYPE_CHECKING

from tambour.core.errors import Span
from tambour.crochet.graph.hook import LIFT
from tambour.crochet.language.stitches import STANDING, Stitch
from tambour.crochet.language.tree import Action, Item, Line
from tambour.crochet.printed.heads import Head
from tambour.crochet.printed.rounds.items import goes, span_of, works
from tambour.crochet.printed.rounds.reader import Body
from tambour.crochet.printed.rounds.reckoned import reached

if TYPE_CHECKING:
    from tambour.crochet.printed.parts.part import Draft


def begun(draft: Draft, head: Head | None, items: list[Item], body: Body) -> list[Item]:
    """``items`` with the chains at a round's beginning understood, and rows turned where nobody says so."""
    at = next((k for k, i in enumerate(items) if not isinstance(i, Action) or i.name not in ("color", "flo", "blo")), 0)
    lead = items[at] if items else None
    turns = any(isinstance(i, Action) and i.name in ("turn", "edge") for i in items[at : _first_worked(items)])
    before = next(
        (line for line in reversed(draft.lines) if line.again is not None or any(map(goes, line.items))), None
    )
    while before is not None and before.again is not None:
        before = before.again.lines[-1]
    last = next((i for i in reversed(before.items) if goes(i)), None) if before is not None else None
    lifted = isinstance(last, Action) and last.name in ("join", "turn")
    turned = isinstance(last, Action) and last.name == "turn"
    several = body.rounds is not None or (head is not None and (len(head.numbers) > 1 or head.many > 1))
    if several and not any(isinstance(i, Action) and i.name in ("join", "turn") for i in items):
        lifted = False  # "3rd to 5th rnds: Ch 1. 1 sc in each sc around. Do not join."
    worked = any(works(line_item) for line in draft.lines for line_item in line.items)
    if draft.flat and worked and not turns and not lifted and (head is None or head.row) and any(map(works, items)):
        turn = Action("turn", span_of(items[at]))
        if turned:
            return [*items, turn]  # rows of which the first is turned already: each ends with its turn
        each = several and closes(items[-1])  # a turn before each of them would be one too many
        if (
            head is not None
            and (each or not several)
            and draft.lines[-1] is before
            and before.in_round
            and before.times == 1
        ):
            draft.lines[-1] = replace(
                before, items=(*before.items, turn)
            )  # a row ends with its turn, so that it can be repeated
            return items
        if each:
            draft.lines.append(Line((turn,), span_of(items[at]), False))
            return items
        return [*items[:at], turn, *items[at:]]
    if isinstance(lead, Action) and lead.name == "ch" and lead.times <= LIFT and not turns and not lifted and worked:
        next_one = items[at + 1] if at + 1 < len(items) else None
        if next_one is not None and not (isinstance(next_one, Action) and next_one.name == "skip"):
            return [*items[:at], *items[at + 1 :]]
    return items


def _first_worked(items: list[Item]) -> int:
    """Where the first item stands that works stitches; chains that stand for one are none."""
    return next(
        (k for k, i in enumerate(items) if works(i) and not (isinstance(i, Action) and i.name in STANDING)), len(items)
    )


def facing(items: list[Item]) -> list[Item]:
    """``items`` with chains that stand for a stitch, or that lift the yarn for the next row, behind the turn that is said after them: "ch 3,
    turn, dc in each st", "… across, ch 1, turn"."""
    made = list(items)
    for k, (one, other) in enumerate(pairwise(items)):
        if not (isinstance(one, Action) and isinstance(other, Action) and other.name == "turn"):
            continue
        ends = k + 2 == len(items) and one.name == "ch" and one.times <= LIFT and any(map(works, items[:k]))
        if one.name in STANDING or ends:
            made[k : k + 2] = [other, one]
    return made


def lifted_last(
    items: list[Item], edge: int | None, stated: int | None, stitches: dict[str, Stitch], times: int
) -> list[Item] | None:
    """``items`` without the chain at their end, where the count says that it is no stitch: "inc around, ch 1 (12)", which lifts the yarn to
    the next round; None where there is no such chain."""
    last = items[-1] if len(items) > 1 else None
    if stated is None or not isinstance(last, Action) or last.name != "ch" or last.times > LIFT:
        return None
    bare = items[:-1]
    return bare if reached(bare, edge, stitches, times) == stated else None


def closes(item: Item) -> bool:
    """Whether a round ends with ``item``, so that a chain behind it is of the next."""
    return isinstance(item, Action) and item.name in ("join", "turn")


def words_of(item: Item) -> Span:
    """Where a chain is said, with its number: "ch 1"."""
    many = item.times_span if isinstance(item, Action) else None
    return item.span if many is None else Span(min(item.span.start, many.start), max(item.span.end, many.end))

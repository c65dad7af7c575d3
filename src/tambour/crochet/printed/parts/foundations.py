"""Printed patterns, foundations: the chain or ring that a part begins with, and what its first stitches make of it."""

from __future__ import annotations

import re
from dataclasses import replace
from functools import lru_cache
from typing import TYPE_CHECKING

from tambour.core.errors import Span
from tambour.crochet.language.source import Source
from tambour.crochet.language.stitches import STANDING, Stitch, into_one
from tambour.crochet.language.tree import Action, Group, Item, Line
from tambour.crochet.printed.heads import Head
from tambour.crochet.printed.rounds.items import STARTS, works
from tambour.crochet.printed.rounds.reader import Body

if TYPE_CHECKING:
    from tambour.crochet.printed.parts.part import Draft

_ROWED = 6  # the same of rows
_TURN = re.compile(r"(?<!not )(?<!never )(?<!n't )(?<!without )\bturn(?:ed|ing)?\b", re.IGNORECASE)
_RISEN = re.compile(r":\s*(?:ch|chain)\s?[23]\b(?!.*\b(?:join|sl|slst|ss)\b)", re.IGNORECASE)
_EVERY = re.compile(r"\b(?:each|every|all|end of) .*\brows?\b", re.IGNORECASE)
_SENTENCE = re.compile(r"[^.\n]+")
_RING = 3  # stitches in one chain that are a ring, at least


def founded(draft: Draft, source: Source, head: Head | None, body: Body, items: list[Item], span: Span) -> list[Item]:
    """``items`` without the chain or ring that the part begins with, which is put before them in ``draft``."""
    fresh = body.fresh
    if (draft.begun() and draft.chain is None) or any(isinstance(i, Action) and i.name in STARTS for i in items):
        return items
    chain: Action | None = None
    if draft.chain is not None:
        chain = next(i for i in draft.lines[draft.chain].items if isinstance(i, Action) and i.name == "ch")
    lead = [i for i in items if isinstance(i, Action) and i.name in ("color", "flo", "blo")]
    if chain is None:
        own = next((k for k, i in enumerate(items) if isinstance(i, Action) and i.name == "ch"), None)
        if own is None or any(works(i) for i in items[:own]):
            if not body.hook and any(isinstance(i, Action) and i.name == "turn" for i in items):
                return items  # "Row 1: Join B, work 25 sc across bottom of sweater, ch 1, turn."
            return _ringed(source, items, body.hook if head is None or not head.row else 0)
        chain = items[own]  # type: ignore[assignment]
        assert isinstance(chain, Action)
        if head is not None and not head.row and not body.hook and _lifts(source, chain, items[own + 1 :]):
            return _ringed(source, [*items[:own], *items[own + 1 :]], 0)  # "Magic ring", "Round 1: Ch 1, 9 hdc"
        begun = next((k for k, i in enumerate(items) if works(i)), len(items))
        tied = [i for i in items[own + 1 : begun] if isinstance(i, Action) and i.name == "join"][:1]
        rest = [i for i in items[own + 1 :] if i not in tied]
        draft.looped = bool(tied)
        draft.lines.append(Line((*items[:own], chain, *tied), span, False))
        draft.chain, draft.edge = len(draft.lines) - 1, chain.times
        turned = rest[:1] if rest and isinstance(rest[0], Action) and rest[0].name == "turn" else []
        items, fresh = rest, max(0, fresh - own - 1)
        if turned and len(rest) == 1:
            return []
    elif all(isinstance(i, Action) and i.name in ("join", "color") for i in items):
        tied = [i for i in items if isinstance(i, Action) and i.name == "join"][: not draft.looped]
        draft.looped = draft.looped or bool(tied)
        line = draft.lines[draft.chain or 0]
        draft.lines[draft.chain or 0] = replace(line, items=(*line.items, *tied))
        return [i for i in items if isinstance(i, Action) and i.name == "color"]
    if not any(works(i) for i in items):
        return [i for i in items if i not in lead or not draft.chain] if items else []
    return _chained(draft, source, head, body, items, fresh, chain)


def _lifts(source: Source, chain: Action, rest: list[Item]) -> bool:
    """Whether a chain only lifts the yarn for the stitches behind it, which are more than go into it."""
    first = next((i for i in rest if works(i)), None)
    if not isinstance(first, Action) or first.name not in source.stitches or source.stitches[first.name].takes != 1:
        return False
    return (chain.times or 1) == 1 and (first.times or 1) > _RING


def _ringed(source: Source, items: list[Item], hook: int) -> list[Item]:
    """A first round that names no ring, or a chain from the ``hook`` that is not there: its plain stitches are one."""
    for k, item in enumerate(items):
        if isinstance(item, Action) and item.name in source.stitches and source.stitches[item.name].makes:
            kind = source.stitches[item.name]
            several = hook and kind.where != "ring" and kind.takes == 1 and kind.makes * item.times >= _RING
            if several and not any(works(i) for i in items[k + 1 :]):
                return [*items[:k], _ring(source, item), *items[k + 1 :]]
            if kind.where == "ring" or item.times < 2 or kind.takes != 1 or any(works(i) for i in items[k + 1 :]):
                return items
            ring: Item = Action("mr", item.span, numbers=(item.times, 0))
            if item.name != "sc":
                made = into_one([(kind, item.times)], "ring")
                source.stitches.setdefault(made.name, made)
                ring = Action(made.name, item.span)
            return [*items[:k], ring, *items[k + 1 :]]
    return items


def _ring(source: Source, item: Action) -> Action:
    """The stitches of ``item``, all in one chain, as a ring of them."""
    kind = source.stitches[item.name]
    if {name for name, _ in kind.inner or ((kind.name, 1),)} == {"sc"}:
        return Action("mr", item.span, numbers=(kind.makes * item.times, 0))
    held = [(source.stitches[name], k) for name, k in kind.inner] or [(kind, item.times)]
    made = into_one(held, "ring")
    source.stitches.setdefault(made.name, made)
    return Action(made.name, item.span)


def _turns(text: str, at: int) -> bool:
    """Whether the row behind the one at ``at`` is turned, or every row is: "Row 2: ch 3, turn, …", "Turn at the end of each row"."""
    below = [line for line in text[at:].split("\n")[1:] if line.strip()][:1]
    if any(_TURN.search(line) or _RISEN.search(line) for line in below):
        return True
    return _always(text)


@lru_cache(maxsize=8)
def _always(text: str) -> bool:
    """Whether a sentence of a text says that every row is turned: the same for all its parts."""
    return any(_TURN.search(said) and _EVERY.search(said) for said in _SENTENCE.findall(text))


def _chained(
    draft: Draft,
    source: Source,
    head: Head | None,
    body: Body,
    items: list[Item],
    fresh: int,
    chain: Action,
) -> list[Item]:
    """The first stitches into a foundation chain: a ring, an oval, a row or a tube."""
    assert draft.chain is not None
    at, draft.chain = draft.chain, None
    base = draft.lines[at]
    before = [i for i in base.items if not isinstance(i, Action) or i.name in ("color", "flo", "blo")]
    items = [
        i for k, i in enumerate(items) if not (k < fresh and isinstance(i, Action) and i.name in ("ch", "turn", "skip"))
    ]
    items = [i for k, i in enumerate(items) if not (k == 0 and isinstance(i, Action) and i.name == "turn")]
    first = next(i for i in items if works(i))
    hook = body.hook or 2
    inner = first.items[0] if isinstance(first, Group) else first
    kind = source.stitches.get(inner.name) if isinstance(inner, Action) else None
    row = head is not None and head.row
    if draft.looped:
        body.hook = 0  # "ch 70, join to form a ring. Round 1: Sc in 2nd ch from hook …": all of them are worked into
    if stood := _stood(source, items, first, 0 if row else body.hook, chain.times):
        draft.lines[at] = replace(base, items=tuple(before))
        return stood
    one = body.hook and chain.times - hook + 1 <= 1 and kind is not None
    # Rows are rounds where six and more begin in one chain, and nothing turns.
    least = _ROWED if row else _RING
    turned = row and (
        any(isinstance(i, Action) and i.name == "turn" for i in items) or _turns(source.text.text, first.span.end)
    )
    if one and kind is not None and isinstance(first, Action) and kind.makes * first.times >= least and not turned:
        draft.lines[at] = replace(base, items=tuple(before))
        ring = _ring(source, first)
        return [ring if i is first else i for i in items]
    if body.sides:
        numbers = (chain.times, hook)
        draft.lines[at] = replace(base, items=(*before, Action("oval", chain.span, numbers=numbers)))
        draft.edge = 2 * (chain.times - hook + 1) - 1  # the chain that it ends on may be left out
        return items
    if body.hook or row:
        draft.flat = True
        lift = Action("ch", chain.span, chain.times - max(0, hook - 2), chain.times_span)
        more = [Action("ch", chain.span, hook - 2)] if hook > 2 else []
        draft.lines[at] = replace(base, items=(*before, lift, Action("turn", chain.span), *more))
        draft.edge = lift.times - 1
    if draft.looped and any(isinstance(i, Action) and i.name == "join" for i in draft.lines[at].items):
        return items  # "ch 12, join. Round 1: Ch 1, …": the chain lifts the yarn as above any joined round
    return [i for k, i in enumerate(items) if not (k == 0 and isinstance(i, Action) and i.name == "ch")]


def _stood(source: Source, items: list[Item], first: Item, hook: int, chains: int) -> list[Item]:
    """``items`` with a ring in place of what all goes into the first of so many ``chains``, the others of which stand for a stitch: "ch 4. 9 dc
    in 4th ch from hook (counts as 10 dc)"; empty where it is not so."""
    at = items.index(first)
    second = items[at + 1] if at + 1 < len(items) else None
    if (
        not isinstance(first, Action)
        or first.name not in STANDING
        or hook + 1 != chains
        or not isinstance(second, Action)
    ):
        return []
    kind = source.stitches.get(second.name)
    if kind is None or kind.takes != 1 or kind.makes * second.times < _RING or any(works(i) for i in items[at + 2 :]):
        return []
    held = [(source.stitches[name], k) for name, k in kind.inner] or [(_each(source, kind), kind.makes * second.times)]
    made = into_one([(source.stitches[first.name], 1), *held], "ring")
    source.stitches.setdefault(made.name, made)
    return [*items[:at], Action(made.name, first.span), *items[at + 2 :]]


def _each(source: Source, kind: Stitch) -> Stitch:
    """The stitch that an increase is made of."""
    over = next(move.kind for move in kind.moves if move.kind)
    return source.stitches[over] if kind.makes > 1 and over in source.stitches else kind

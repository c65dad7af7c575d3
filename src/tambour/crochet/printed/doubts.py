"""Printed patterns, doubtful wordings: their readings, and which of them the stated count bears out."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace
from itertools import combinations
from typing import Final

from tambour.core.errors import Span
from tambour.crochet.language.source import Source
from tambour.crochet.language.stitches import Stitch
from tambour.crochet.language.tree import Action, Group, Item
from tambour.crochet.printed.body import Walk
from tambour.crochet.printed.colors import Palette
from tambour.crochet.printed.cursor import NotUnderstood
from tambour.crochet.printed.reader import Body
from tambour.crochet.printed.repeats import led
from tambour.crochet.printed.stitch import standing
from tambour.crochet.printed.tokens import Token
from tambour.crochet.words.phrases import Phrases

READINGS: Final = {
    "one": ("stitch after stitch", "all in one stitch"),
    "one glued": ("stitch after stitch", "all in one stitch"),
    "more": ("so many times more", "so many times in all"),
    "all": ("so many in each stitch around", "so many stitches, and no more"),
    "pair": ("one stitch", "two stitches"),
    "once": ("once", "again and again, around"),
    "open": ("once", "again and again, around"),
}
"""Wording → its first reading, which is taken unless the count speaks for the second."""

_TO_MARK: Final = re.compile(r"[^\n,.;:()\[\]{}*]{0,40}")

_QUIET: Final = frozenset(("one", "all", "once", "pair"))  # usual enough not to be asked about when no count is stated


def worked(items: list[Item] | tuple[Item, ...], edge: int, stitches: dict[str, Stitch]) -> tuple[int, int] | None:
    """Stitches that ``items`` make and take on an edge of ``edge`` stitches; None when it is not known."""
    made = taken = 0
    for item in items:
        if isinstance(item, Group):
            once = worked(item.items, edge - taken, stitches)
            if once is None:
                return None
            times = item.times
            if times is None:
                if once[1] == 0:
                    return None
                times = max(0, edge - taken) // once[1]
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
            elif item.name != "ch" or made:  # chains at the beginning only lift the yarn
                made, taken = made + kind.makes * item.times, taken + kind.takes * item.times
        elif item.name in ("turn", "join"):
            continue
        elif item.name not in ("flo", "blo", "bl", "color", "fo"):
            return None
    return made, taken


def after(items: list[Item] | tuple[Item, ...], edge: int | None, stitches: dict[str, Stitch]) -> int | None:
    """Stitches on the edge after ``items``, None when it is not known."""
    done = worked(items, edge or 0, stitches)
    if done is None:
        return None
    if any(not isinstance(i, Group) and (i.name == "mr" or i.name.startswith("MR{")) for i in items):
        return done[0]
    return None if edge is None else edge - done[1] + done[0]


def chainless(items: list[Item], edge: int | None, stitches: dict[str, Stitch]) -> int | None:
    """Stitches that ``items`` make, chains aside; None when it is not known."""

    def chains(inner: list[Item] | tuple[Item, ...], left: int) -> int | None:
        total = 0
        for item in inner:
            if isinstance(item, Group):
                once = worked(item.items, left, stitches)
                found = chains(item.items, left)
                if once is None or found is None or (item.times is None and not once[1]):
                    return None
                total += found * (left // once[1] if item.times is None else item.times)
            elif item.name in stitches:
                kind = stitches[item.name]
                total += item.times * sum(move.kind == "ch" for move in kind.moves)
        return total

    _, items = led(items)
    done, out = worked(items, edge or 0, stitches), chains(items, edge or 0)
    return None if done is None or not out else done[0] - out


def decided(source: Source, tokens: list[Token], palette: Palette, edge: int | None, phrases: Phrases) -> Body:
    """The body of a round in the reading that fits its count; doubts that the count leaves are told."""

    def phrase(begin: int, end: int) -> Action | None:
        # Small words are no tokens: "change to color A" goes on to the comma.
        more = _TO_MARK.match(source.text.text, end)
        words = source.text.text[begin : more.end() if more else end]
        span = Span(begin + len(words) - len(words.lstrip()), end)
        said = phrases.item(words)
        return None if said is None else Action(said[0], span, 1, None, said[1], said[2])

    def read(choices: frozenset[str] = frozenset()) -> Body:
        return Walk(list(tokens), source.stitches, palette, choices, phrase).read()

    body = read()
    one = body.items[0] if len(body.items) == 1 else None
    if (
        isinstance(one, Action)
        and one.times_span is None
        and (edge or 0) > 1
        and one.name in source.stitches
        and source.stitches[one.name].takes == 1
        and one.name not in ("slst", "skip")
    ):
        body.items = [Group((one,), None, one.span)]  # "Rounds 4-6: dc": the whole round
    first = body
    if body.stated is not None:
        open_span = _implied(body, edge, source.stitches)
        if open_span is not None and not _fits(body, edge, source.stitches):
            body.asked["open"] = open_span
        if body.asked and (fit := _fits(body, edge, source.stitches)) < 2:
            body = _second(source, read, edge, body, fit) or body
        if body is first and edge is not None and _fits(body, edge, source.stitches) < 2:
            body = _stood(body, edge, source.stitches) or body
    for what, span in first.asked.items():
        first_way, second_way = READINGS[what]
        if body is not first and what in body.asked and what != "pair":
            said = f"this can be read as {first_way}, or as {second_way}: the count speaks for the second"
            source.doubt(said, "say it so that there is one reading", span)
        elif (
            body is first
            and what not in _QUIET
            and what != "open"
            and (body.stated is None or not _fits(body, edge, source.stitches))
        ):
            source.doubt(
                f"this can be read as {first_way}, or as {second_way}; the first is taken",
                "a stated count would decide",
                span,
            )
    return body


def _fits(body: Body, edge: int | None, stitches: dict[str, Stitch]) -> int:
    """How well a body fits its count: 2 also uses up the round below, 1 leaves some of it over, 0 does not fit."""
    done = after(body.items, edge, stitches)
    if done is not None and done != body.stated:
        return 0
    taken = worked(body.items, edge or 0, stitches)
    return 2 if done is None or taken is None or edge is None or taken[1] in (0, edge) else 1


def _stood(body: Body, edge: int, stitches: dict[str, Stitch]) -> Body | None:
    """The body with the chains that it begins with standing for a stitch, when that gives its count."""
    lead, inner = led(body.items)
    chains = next((k for k, i in enumerate(lead) if isinstance(i, Action) and i.name == "ch" and i.times > 1), None)
    if chains is None:
        return None
    standing(stood := lead[: chains + 1])
    other = replace(body, items=[*stood, *lead[chains + 1 :], *inner])
    return other if _fits(other, edge, stitches) == 2 else None


def _implied(body: Body, edge: int | None, stitches: dict[str, Stitch]) -> Span | None:
    """Where a round that leaves stitches over says no repeat, although its count would fit one."""
    if edge is None or body.rounds is not None or any(isinstance(i, Group) for i in body.items):
        return None
    _, inner = led(body.items)
    once = worked(inner, edge, stitches)
    if not inner or once is None or not 0 < once[1] < edge or edge % once[1]:
        return None
    first, last = inner[0], inner[-1]
    return Span(first.span.start, last.span.end)


def _second(
    source: Source, read: Callable[[frozenset[str]], Body], edge: int | None, body: Body, fit: int
) -> Body | None:
    """The first combination of second readings that fits the count better than ``fit``, the fewest of them first."""
    asked = list(body.asked)[:5]
    for many in range(1, len(asked) + 1):
        for chosen in combinations(asked, many):
            try:
                other = read(frozenset(chosen))
            except NotUnderstood:
                continue
            if "open" in chosen:
                lead, inner = led(other.items)
                other.items = [*lead, Group(tuple(inner), None, body.asked["open"])]
            if after(other.items, edge, source.stitches) is not None and _fits(other, edge, source.stitches) > fit:
                other.asked = {what: body.asked[what] for what in chosen}
                return other
    return None

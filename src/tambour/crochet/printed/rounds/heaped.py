"""Printed patterns, heaped: several stitches worked into one place, a stitch, a space or a ring."""

from __future__ import annotations

from dataclasses import replace
from typing import Final, Literal

from tambour.core.errors import Span
from tambour.crochet.language.stitches import STANDING, Stitch, into_one
from tambour.crochet.language.tree import Action, Group, Item
from tambour.crochet.printed.cursor import NotUnderstood
from tambour.crochet.printed.rounds.clauses import Where
from tambour.crochet.printed.rounds.counts import makes
from tambour.crochet.printed.rounds.motifs import standing_in
from tambour.crochet.printed.rounds.reader import Reader
from tambour.crochet.printed.tokens import Token

_MOST: Final = 64  # stitches in one place


def into_ring(r: Reader, found: list[Item], name: str, number: Token | None, token: Token) -> None:
    """Stitches into a magic ring, or into a ring of chains."""
    count = number.value if number is not None else 1
    if r.ring is None and any(isinstance(i, Action) and i.name in ("join", "ch", *STANDING) for i in found):
        r.body.ringed = True
    if not isinstance(count, int) or count < 1:
        raise NotUnderstood(number or token, "a ring has at least one stitch", "say how many: 6 sc in magic ring")
    if r.depth or r.body.rings:  # the chains before it stand between stitches of the same ring
        r.ring, r.body.rings, r.body.ringed = None, r.body.rings + 1, True
        one = Action("mr", token.span, numbers=(count, 0))
        found.append(one if name == "sc" else together(r, [(r.stitches[name], count)], token, "ring"))
        return
    stands = next((i.name for i in found if isinstance(i, Action) and i.name in STANDING), "")
    chains = [i.times for i in found if isinstance(i, Action) and i.name == "ch"]
    r.body.lift = chains[-1] if chains and not r.body.rings else r.body.lift
    found[:] = [i for i in found if not (isinstance(i, Action) and i.name in ("ch", "join", *STANDING))]
    r.ring = None
    r.body.rings += 1
    last = found[-1] if found else None
    stitches = r.stitches[name]
    if name == "sc" and not stands and isinstance(last, Action) and last.name == "mr":
        found[-1] = replace(last, numbers=(last.numbers[0] + count, 0))
        return
    if name == "sc" and not stands and not (isinstance(last, Action) and r.is_ring(last)):
        found.append(Action("mr", number.span if number is not None else token.span, numbers=(count, 0)))
        return
    inner = [(stitches, count)]
    if stands:
        inner.insert(0, (r.stitches[stands], 1))  # "ch 3 (counts as dc), 11 dc in ring"
    if isinstance(last, Action) and r.is_ring(last):
        found.pop()
        old = (
            [(r.stitches["sc"], last.numbers[0])]
            if last.name == "mr"
            else [(r.stitches[s], k) for s, k in r.stitches[last.name].inner]
        )
        inner = [*old, *inner]
    found.append(together(r, inner, token, "ring"))


def again_into_ring(r: Reader, found: list[Item], inner: list[Item], times: int, span: Span) -> bool:
    """Takes a ring that is said as a repeat, "[sc in ring] 6 times", as one of so many stitches, with those that are in it already; whether
    ``inner`` is such."""
    ring, last = inner[0] if len(inner) == 1 else None, found[-1] if found else None
    if not isinstance(ring, Action) or not r.is_ring(ring) or times > _MOST:
        return False
    both = [last, ring] if isinstance(last, Action) and r.is_ring(last) else [ring]
    del found[len(found) - len(both) + 1 :]
    many = [1, times][-len(both) :]
    if all(one.name == "mr" for one in both):
        made = sum(one.numbers[0] * k for one, k in zip(both, many, strict=True))
        found.append(replace(ring, numbers=(made, 0)))
        return True
    parts: list[tuple[Stitch, int]] = []
    for one, k in zip(both, many, strict=True):
        inside = [("sc", one.numbers[0])] if one.name == "mr" else r.stitches[one.name].inner
        parts += [(r.stitches[name], n) for name, n in inside] * k
    found.append(together(r, parts, Token("stitch", "", span.start, span.end), "ring"))
    return True


def together(r: Reader, inner: list[tuple[Stitch, int]], token: Token, place: Literal["", "sp", "ring"] = "") -> Action:
    """One action for stitches that go into one place."""
    if sum(k for _, k in inner) > _MOST:
        raise NotUnderstood(token, "too many stitches in one place", f"at most {_MOST}")
    try:
        made = into_one(inner, place)
    except ValueError as error:
        raise NotUnderstood(token, str(error), "stitches that go into one place are worked ones and chains") from None
    r.stitches.setdefault(made.name, made)
    return Action(made.name, token.span)


def placed(r: Reader, found: list[Item], inner: list[Item], place: Where, span: Span) -> list[Item]:
    """``inner`` worked into one place, once or in each of several."""
    token = Token("stitch", "", span.start, span.end)
    flat = [one for i in inner for one in _flat(i)]
    parts = [(r.stitches[i.name], i.times) for i in flat if isinstance(i, Action) and i.name in r.stitches]
    if len(parts) != len(flat):
        raise NotUnderstood(token, "this does not go into one stitch", "stitches only, without repeats")
    if place.kind == "same" and found and (lead := standing_in(r, found, parts)) is not None:
        return [together(r, [*lead, *parts], token, "sp")]
    if place.spaces and place.kind == "first" and any(map(makes, found)):
        found.append(Action("firstspace", place.span))  # the space that the round began in
    if place.kind == "same" and found:
        held: list[Item] = []  # a change of yarn within the place
        while found and isinstance(found[-1], Action) and found[-1].name in ("color", "flo", "blo", "bl"):
            held.insert(0, found.pop())
        if held and found:
            return [*placed(r, found, inner, place, span), *held]
        found += held
        chains = _on_slip(found)
        if chains:  # "sl st in next ch, ch 2, dc in same ch": the slip stitch is as low as its place
            del found[-2:]
            return [together(r, [(r.stitches["ch"], chains), *parts], token)]
        between: list[tuple[Stitch, int]] = []
        if _on_stitch(r, found) or _on_space(r, found):  # "dc in next st, ch 2, dc in same st"
            chain = found.pop()
            assert isinstance(chain, Action)
            between = [(r.stitches["ch"], chain.times)]
        last = found[-1]
        if isinstance(last, Action) and last.name in r.stitches and r.stitches[last.name].where == "sp":
            more = together(r, [*_inner(r, last), *between, *parts], token, "sp")
            found[-1:] = [replace(last, times=last.times - 1)] if last.times > 1 else []
            return [more]
        if isinstance(last, Action) and last.name in r.stitches and r.stitches[last.name].fits_in_one:
            kind = r.stitches[last.name]
            old = [(r.stitches[s], k) for s, k in kind.inner] or [(kind, 1)]
            more = together(r, [*old, *between, *parts], token)
            found[-1:] = [Action(last.name, last.span, last.times - 1, last.times_span)] if last.times > 1 else []
            return [more]
    if place.kind == "ring":
        r.body.ringed = r.body.ringed or r.ring is None
        if r.depth or r.body.rings:
            r.ring, r.body.rings = None, r.body.rings + 1
            return [together(r, parts, token, "ring")]
        r.body.rings += 1
        found[:] = [i for i in found if not (isinstance(i, Action) and i.name in ("ch", "join"))]
        r.ring = None
        return [together(r, parts, token, "ring")]
    one = together(r, parts, token, "sp" if place.spaces else "")
    if place.kind == "around":
        return [Group((one,), None, place.span, place.leaves, place.until, place.chains if place.spaces else 0)]
    return [Action(one.name, one.span, place.count, place.span)]


def _inner(r: Reader, action: Action) -> list[tuple[Stitch, int]]:
    """The stitches that are in one place together."""
    return [(r.stitches[s], k) for s, k in r.stitches[action.name].inner]


def _on_space(r: Reader, found: list[Item]) -> bool:
    """Whether ``found`` ends with chains behind stitches in a space that others may go into with them: "3 dc in next sp, ch 2, 3 dc in
    same sp"."""
    last, before = (found[-1], found[-2]) if len(found) > 1 else (None, None)
    if not isinstance(last, Action) or last.name != "ch" or not isinstance(before, Action):
        return False
    return before.name in r.stitches and r.stitches[before.name].where == "sp"


def _on_slip(found: list[Item]) -> int:
    """How many chains stand on a slip stitch at the end of ``found``; 0 where that ends otherwise."""
    slip, chain = found[-2:] if len(found) > 1 else (None, None)
    if not isinstance(slip, Action) or not isinstance(chain, Action):
        return 0
    return chain.times if (slip.name, slip.times, chain.name) == ("slst", 1, "ch") else 0


def _on_stitch(r: Reader, found: list[Item]) -> bool:
    """Whether ``found`` ends with chains behind one stitch that others may go into one place with."""
    last, before = (found[-1], found[-2]) if len(found) > 1 else (None, None)
    if (
        not isinstance(last, Action)
        or last.name != "ch"
        or not isinstance(before, Action)
        or before.name not in r.stitches
    ):
        return False
    kind = r.stitches[before.name]
    return kind.fits_in_one and kind.takes == 1 and before.name != "ch" and before.times > 0


def _flat(item: Item) -> list[Item]:
    """An item without brackets, if they say how often; so that it can go into one place."""
    if isinstance(item, Group) and item.times is not None and item.times <= _MOST:
        return [one for i in item.items for one in _flat(i)] * item.times
    return [item]

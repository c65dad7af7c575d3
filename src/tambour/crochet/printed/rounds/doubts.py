"""Printed patterns, doubtful wordings: their readings, and which of them the stated count bears out."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace
from itertools import combinations
from typing import Final

from tambour.core.errors import Span
from tambour.crochet.language.source import Source
from tambour.crochet.language.stitches import STANDING, Stitch, into_one
from tambour.crochet.language.tree import Action, Group, Item
from tambour.crochet.printed.cursor import NotUnderstood
from tambour.crochet.printed.rounds.asides import penned
from tambour.crochet.printed.rounds.body import Walk
from tambour.crochet.printed.rounds.otherwise import (
    all_around,
    all_times,
    later,
    makes_all,
    run_on,
    singly,
    times_first,
)
from tambour.crochet.printed.rounds.ovals import both_sides
from tambour.crochet.printed.rounds.reader import Body
from tambour.crochet.printed.rounds.reckoned import after, after_all, chainless, fixed, reached, rest_left, worked
from tambour.crochet.printed.rounds.repeats import led
from tambour.crochet.printed.tokens import Token
from tambour.crochet.printed.wordings.phrasing import shortened
from tambour.crochet.printed.yarns.colors import Palette
from tambour.crochet.words.phrases import Phrases

BESIDE: Final = "another piece is joined here"
"""How the doubt begins of a round that goes through two pieces, and is drawn on one of them."""
READINGS: Final = {
    "one": ("stitch after stitch", "all in one stitch"),
    "one glued": ("stitch after stitch", "all in one stitch"),
    "more": ("so many times more", "so many times in all"),
    "all": ("so many in each stitch around", "so many stitches, and no more"),
    "places": ("so many in all of these stitches", "so many in each of these stitches"),
    "pair": ("one stitch", "two stitches"),
    "once": ("once", "again and again, around"),
    "open": ("once", "again and again, around"),
    "stands": ("chains that only lift the yarn", "a stitch"),
    "passed": ("chains that only lift the yarn", "a stitch"),
}
"""Wording → its first reading, which is taken unless the count speaks for the second."""


_PLAIN: Final = r"\b(?:sc|hdc|dc|tr) in (?:the )?next (\d+) (?:sc|hdc|dc|tr|sts?|stitches)\b"
_BARE: Final = re.compile(rf"(?<![\d\w] ){_PLAIN}")
_SAME: Final = re.compile(rf"\b(\d+) {_PLAIN}")
_GLUED: Final = re.compile(
    r"^\W*2(sc|dc|hdc)\s*[-–—=:]+\s*(?:work\s+|make\s+)?(?:2|two)\s*(?:\1|(?:single|double|half double) crochets?)\s+(?:in|into)\b",
    re.IGNORECASE | re.MULTILINE,
)
"""An abbreviation for an increase: "2sc - 2 sc in next st"."""
_MANY: Final = 4  # "4 sc in next 4 sts" is one in each: nobody makes sixteen of four
_BEFORE: Final = ("color", "flo", "blo", "bl", "turn", "goto", "edge", "tospace")
_COUNTED: Final = frozenset(("open", "more", "stands", "passed", "pair", "one", "one glued"))


_TO_MARK: Final = re.compile(r"[^\n,.;:()\[\]{}*]{0,40}")


_QUIET: Final = frozenset(
    ("one", "all", "once", "pair", "stands", "places", "passed")
)  # usual enough not to be asked about when no count is stated


def numbered_each(words: str) -> bool:
    """Whether a text writes one stitch in each of several without a number, "sc in next 8 sts", and never "8 sc in next 8 sts", so that its
    "2 dc in next 2 sts" is two in each."""
    words = " ".join(words.lower().split())
    same = [int(m[1]) for m in _SAME.finditer(words) if m[1] == m[2]]
    return sum(int(m[1]) > 1 for m in _BARE.finditer(words)) > 1 and all(n < _MANY for n in same)


def in_one(words: str) -> bool:
    """Whether a text has a number grown to a stitch for an increase, as its abbreviations say."""
    return _GLUED.search(words) is not None


def tried(
    source: Source, tokens: list[Token], palette: Palette, edge: int | None, phrases: Phrases, times: int = 1
) -> Body | None:
    """The body of a round on another edge than the one at the hook, None where its words cannot be worked there."""
    try:
        return decided(source, tokens, palette, edge, phrases, times)
    except NotUnderstood:
        return None


def decided(
    source: Source,
    tokens: list[Token],
    palette: Palette,
    edge: int | None,
    phrases: Phrases,
    times: int = 1,
    chain: int | None = None,
    lying: bool = False,
) -> Body:
    """The body of a round in the reading that fits its count and the round below; doubts that the count leaves are told.

    edge : stitches below, None where they are not known; times : rounds that are worked so
    chain : the foundation chain that it is worked into, None for none; lying : a round lies below, and its part goes round and round
    """
    tokens, slipped = penned(shortened(tokens))
    for token, meant in slipped:
        source.doubt(f'"{token.word}" is read as "{meant}"', f'did you mean "{meant}"?', token.span, True)

    def phrase(begin: int, end: int) -> Action | None:
        # Small words are no tokens: "change to color A" goes on to the comma.
        more = _TO_MARK.match(source.text.text, end)
        words = source.text.text[begin : more.end() if more else end]
        span = Span(begin + len(words) - len(words.lstrip()), end)
        said = phrases.item(words)
        return None if said is None else Action(said[0], span, 1, None, said[1], said[2])

    unworked = any(t.word == "unworked" for t in tokens) and any(t.kind == "key" and t.value == "leave" for t in tokens)
    usual = frozenset((*(("places",) if source.each else ()), *(("one glued",) if source.in_one else ())))

    def read(choices: frozenset[str] = frozenset()) -> Body:
        choices = choices ^ usual
        walk = Walk(list(tokens), source.stitches, palette, choices, phrase)
        walk.spaced = source.spaced
        walk.standing, walk.edge, walk.marked = source.standing, edge, source.marked
        walk.lying, walk.solid = lying, source.solid
        body = walk.read()
        base = _base(body, chain)
        own = next((i.times for i in body.items[:2] if isinstance(i, Action) and i.name == "ch"), 0)
        long = base or max(chain or 0, own or 0) - 1  # "Ch 6. R1: 4 sc, 3 sc in last ch, 3 sc, inc"
        if long > 1 and not body.sides and (turned := both_sides(body.items, long, source.stitches)):
            body.items, body.turned = turned
            body.sides, base, body.hook = True, long, body.hook or 2
        if body.sides and base is None and chain is not None and chain > 2 and not body.hook:
            base, body.hook = chain - 1, 2  # "4 sc, 3 sc in last ch, other side: 3 sc, inc"
        if body.sides and base is not None:
            along(body, base, source.stitches)
        if edge and unworked:
            whole = body.stated is not None and after(body.items, edge, source.stitches) == body.stated
            body.items = rest_left(body.items if whole else _leaving(body.items, tokens), edge, source.stitches)
        return body

    def fit(body: Body) -> int:
        base = _base(body, chain)
        below = edge if base is None else 2 * base - 1 if body.sides else base
        return _fits(body, below, source.stitches, times)

    body = read()
    if edge and unworked and _told_rest(body.items, edge, source.stitches):
        at = next(t for t in tokens if t.word == "unworked")
        source.doubt("no stitches are left to be unworked here", "say how many are worked", at.span)
    if (edge or 0) > 1:
        dyes = [i for i in body.items if isinstance(i, Action) and i.name == "color"] if body.both else []
        # "sc through both layers around, with grey"
        body.items = [*dyes, *_bare([i for i in body.items if i not in dyes], body, source.stitches)]
    first = body
    known = edge is not None or _base(body, chain) is not None
    if body.refers is None and (body.stated is not None or known):
        begun = fit(body)
        open_span = _implied(body, edge, source.stitches)
        lone = begun == 1 and body.stated == edge and _lone(body.items)  # "sc in next sc (12)" on 12
        if body.stated is not None and open_span is not None and (not begun or lone):
            body.asked["open"] = open_span
        if body.asked and begun < 2:
            body = _second(read, body, begun, fit) or body
    if edge and any(isinstance(i, Action) and i.name == "fold" for i in body.items):
        flat = [i for i in body.items if not (isinstance(i, Action) and i.name == "fold")]
        used = worked(flat, edge, source.stitches)
        if used is not None and used[1] > (edge + 1) // 2 and not any(isinstance(i, Group) for i in flat):
            body.items, body.both = flat, True  # more stitches than there are pairs: it is two pieces that lie together
    if edge and body.rounds is None and fit(body) < 2 and (again := _as_rounds(body.items, edge)) is not None:
        plain, many = again
        if body.stated in (None, edge):
            body.items, body.rounds = plain, many
            source.doubt(f"this is read as {many[0]} rounds", "say which rounds they are: Rnds 4-7", many[1])
    last = body.items[-1] if body.items else None
    if isinstance(last, Action) and last.name == "turn" and edge and chain is None and fit(body) < 2:
        done = worked(body.items, edge, source.stitches)
        if done is not None and done[0] == body.stated:  # the row is turned there, and the rest is for another piece
            body.items = rest_left(body.items, edge, source.stitches)
    if (
        body.refers is None
        and edge
        and chain is None
        and fit(body) < 2
        and (whole := all_times(body.items) or times_first(body.items)) is not None
    ):
        made = worked(whole, edge, source.stitches)
        ends = all_times(body.items) is not None  # what others follow is read so by its count alone
        if made is not None and made[1] == edge and body.stated in ((None, made[0]) if ends else (made[0],)):
            body.items = whole
            judge = "round below" if body.stated is None else "count"
            said = f"how often is read of all that is said: the {judge} speaks for it"
            if judge != "count" or not any(p.message == said for p in source.problems):  # a habit is told once
                source.doubt(said, "put what is repeated in brackets", whole[-1].span)
    if body.refers is None and body.stated is not None and edge and chain is None and fit(body) < 2:
        for other in (body, *([read(frozenset(("stands",)))] if "stands" in body.asked else [])):
            run = run_on(other.items, edge, source.stitches)
            if run is not None and after(run, edge, source.stitches) == body.stated:
                body, body.items = other, run
                source.doubt("the last repeat runs on to where it ends", "say what the last stitches are", run[-1].span)
                break
        else:
            if wide := next(
                (w for w in all_around(body.items) if after(w, edge, source.stitches) == body.stated), None
            ):
                body.items = wide
                said = "all that is said is read as repeated around: the count speaks for it"
                source.doubt(said, "put what is repeated in brackets", body.items[-1].span)
            elif late := next((w for w in later(body.items) if makes_all(w, edge, body.stated, source.stitches)), None):
                body.items = late
                said = "only the last of what is said is read as repeated: the count speaks for it"
                source.doubt(said, "put what is repeated in brackets", late[-1].span)
            elif (single := singly(body.items, source.stitches)) != body.items and makes_all(
                single, edge, body.stated, source.stitches
            ):
                body.items = single
                said = "several in the next stitch are read as one in each of so many: the count speaks for it"
                source.doubt(said, "say into how many: 3 sc in next 3 sts", single[-1].span)
    body.fit = fit(body) if body.refers is None else 2
    if body.fit == 2 and body.stated is not None and edge and chain is None:
        body.items = _without_rest(body.items, edge, source.stitches)
    if body.both:
        said = f"{BESIDE}: it is worked on the one at the hook"
        source.doubt(said, "the pieces stand beside each other", Span(tokens[0].start, tokens[-1].end))
    if body.undyed is not None:
        source.doubt(
            "which yarn comes next is not said here: it goes on in the same", "name it: change to white", body.undyed
        )
    if body.bent:
        span = Span(tokens[0].start, tokens[-1].end)
        source.doubt("what is worked back along chains is drawn as a loop of them", "nothing is amiss", span)
    if body.loose and not body.fit:
        body.stated = body.stated_span = None  # what else is counted there is not known
        body.fit = fit(body)
    if body is not first and "places" in body.asked and body.stated is not None and body.fit:
        source.each = not source.each
    if body is not first and "stands" in body.asked and body.stated is not None and body.fit == 2:
        for n in _standing(body.items):
            source.standing.setdefault(n, True)  # what a count says of such chains holds for the rounds that state none
    for what, span in first.asked.items():
        first_way, second_way = READINGS[what]
        if body is not first and what in body.asked and what not in ("pair", "stands", "passed"):
            judge = "the round below" if body.stated is None else "the count"
            said = f"this can be read as {first_way}, or as {second_way}: {judge} speaks for the second"
            source.doubt(said, "say it so that there is one reading", span)
        elif (
            body is first
            and what not in _QUIET
            and what != "open"
            and body.stated is None
            and not _filled(body, edge, source.stitches)
        ):
            source.doubt(
                f"this can be read as {first_way}, or as {second_way}; the first is taken",
                "a stated count would decide",
                span,
            )
    return body


def _filled(body: Body, edge: int | None, stitches: dict[str, Stitch]) -> bool:
    """Whether items that say how often they are worked use up the round below to the last stitch, which speaks for their reading."""
    done = worked(body.items, edge, stitches) if edge else None
    return done is not None and done[1] == edge and any(isinstance(i, Group) and i.times for i in body.items)


def _standing(items: list[Item]) -> list[int]:
    """How many chains the first stitch of a round is, where chains stand for it: ``ch3dc``, ``{ch3dc, dc}``."""
    named = next((i.name.removeprefix("{") for i in items if isinstance(i, Action) and i.name not in _BEFORE), "")
    return [int(name[2]) for name in STANDING if named.split(",")[0].rstrip("}") == name]


def _told_rest(items: list[Item], edge: int, stitches: dict[str, Stitch]) -> bool:
    """Whether items use up all stitches of the round below, those aside that they skip at their end."""
    done = worked([i for i in items if not (isinstance(i, Action) and i.name == "skip")], edge, stitches)
    return done is not None and done[1] >= edge


_BESIDE: Final = frozenset(("flo", "blo", "bl", "join", "color", "turn", "fo", "mark", "fold"))
"""What may stand beside a stitch that is the whole round."""


def _bare(items: list[Item], body: Body, stitches: dict[str, Stitch]) -> list[Item]:
    """``items`` with the stitch that is all they work, of which no number is said, worked all around: "Rounds 4-6: dc", "dc in BLO", and,
    of a round that is counted, "sc (12), sl st, fasten off"."""
    at = [k for k, i in enumerate(items) if not (isinstance(i, Action) and i.name in _BESIDE)]
    last = items[at[-1]] if len(at) == 2 and body.stated is not None else None
    if isinstance(last, Action) and last.name in ("slst", "{slst}") and last.times == 1:
        at.pop()
    one = items[at[0]] if len(at) == 1 else None
    if not isinstance(one, Action) or one.times_span is not None or one.times != 1 or one.name not in stitches:
        return items
    if stitches[one.name].takes != 1 or stitches[one.name].where == "ring" or one.name in ("slst", "skip"):
        return items
    return [*items[: at[0]], Group((one,), None, one.span), *items[at[0] + 1 :]]


def _leaving(items: list[Item], tokens: list[Token]) -> list[Item]:
    """``items`` whose last repeat around ends where the words say: "sc in each st across, leaving last 2 sts unworked"."""
    at = next((k for k, t in enumerate(tokens) if t.word == "unworked"), 0)
    last = next((k for k in range(at, max(at - 6, -1), -1) if tokens[k].value == "last"), None)
    around = next((k for k in range(len(items) - 1, -1, -1) if isinstance(items[k], Group)), None)
    group = items[around] if around is not None else None
    if last is None or around is None or not isinstance(group, Group) or group.times is not None or group.leaves:
        return items
    many = next((t.value for t in tokens[last:at] if t.kind == "number" and isinstance(t.value, int)), 1)
    return [*items[:around], replace(group, leaves=many), *items[around + 1 :]]


def _as_rounds(items: list[Item], edge: int) -> tuple[list[Item], tuple[int, Span]] | None:
    """A round of so many plain stitches as lie below, several times, as several of them: "12 sc x 4 (12)"; None for another."""
    lead, rest = led(items)
    group = rest[0] if len(rest) == 1 else None
    one = group.items[0] if isinstance(group, Group) and len(group.items) == 1 else None
    if not isinstance(group, Group) or not isinstance(one, Action) or not group.times or group.times < 2:
        return None
    if one.name != "sc" or one.times != edge:
        return None
    return [*lead, Group((replace(one, times=1),), None, group.span)], (group.times, group.span)


def _without_rest(items: list[Item], edge: int, stitches: dict[str, Stitch]) -> list[Item]:
    """``items``, which make their count, without a last "sc in remaining sc" where none remain."""
    for k in range(len(items) - 1, 0, -1):
        item = items[k]
        if isinstance(item, Group):
            before = worked(items[:k], edge, stitches)
            if item.times is None and before is not None and before[1] == edge:
                return [*items[:k], *items[k + 1 :]]
            break
    return items


def _base(body: Body, chain: int | None) -> int | None:
    """How many chains the first round of a part goes into; None where it is not worked into a chain."""
    if not body.hook:
        return None
    own = next((i.times for i in body.items if isinstance(i, Action) and i.name == "ch"), None)
    long = own if own is not None and own > (chain or 0) else chain
    return None if long is None or long < body.hook else long - body.hook + 1


def along(body: Body, base: int, stitches: dict[str, Stitch]) -> None:
    """A round on both sides of a chain of ``base``: what goes around goes to the end of its own side."""

    def takes(item: Item) -> int:
        if isinstance(item, Group):
            return (item.times or 0) * sum(map(takes, item.items))
        return stitches[item.name].takes * item.times if item.name in stitches and item.name != "ch" else 0

    def bounded(items: list[Item], room: int) -> list[Item]:
        taken = sum(map(takes, items))
        made: list[Item] = []
        for item in items:
            once = sum(map(takes, item.items)) if isinstance(item, Group) else 0
            if isinstance(item, Group) and item.times is None and once:
                times, alone = max(0, room - taken) // once, item.items[0]
                if len(item.items) == 1 and isinstance(alone, Action) and times:
                    made.append(replace(alone, times=alone.times * times))
                else:
                    made.append(Group(item.items, times, item.span))
            else:
                made.append(item)
        return made

    one, whole = bounded(body.items[: body.turned], base), body.items[body.turned :]
    passed = whole[0] if whole else None
    if isinstance(passed, Action) and passed.name == "skip" and sum(map(takes, bounded(whole, base))) == base:
        whole = [replace(passed, times=passed.times - 1), *whole[1:]][passed.times == 1 :]  # the chain at the turn
    other = bounded(whole, base - 1)
    # The chain at the turn is worked into again on the other side where the count says so.
    both_sides = bounded(whole, base)
    counted = [after_all([*one, *side], stitches) == body.stated for side in (other, both_sides)]
    if body.stated is not None and counted == [False, True]:
        other = both_sides
    if sum(map(takes, one)) + sum(map(takes, other)) == 2 * base and one and other:
        # The chain at the turn is worked into on both its sides: as into one place.
        last, first = one[-1], other[0]
        if (
            isinstance(last, Action)
            and isinstance(first, Action)
            and all(i.name in stitches and stitches[i.name].fits_in_one for i in (last, first))
        ):
            both = into_one([(stitches[last.name], 1), (stitches[first.name], 1)])
            stitches.setdefault(both.name, both)
            one = [
                *one[:-1],
                *([replace(last, times=last.times - 1)] if last.times > 1 else []),
                Action(both.name, last.span),
            ]
            other = [*([replace(first, times=first.times - 1)] if first.times > 1 else []), *other[1:]]
    body.items, body.turned = [*one, *other], len(one)


def _fits(body: Body, edge: int | None, stitches: dict[str, Stitch], times: int) -> int:
    """How well a body fits: 2 gives its count and uses up the round below, 1 leaves some of it over, 0 does not fit."""
    done = reached(body.items, edge, stitches, times)
    if done is None and body.stated is not None and times == 1 and (made := fixed(body.items, stitches)) is not None:
        return 2 * (body.stated in (made[0], made[0] - made[1]))  # into spaces, so many as the words say
    wrong = body.stated is not None and done is not None and done != body.stated
    if wrong and (times > 1 or chainless(body.items, edge, stitches) != body.stated):
        return 0
    taken = worked(body.items, edge or 0, stitches)
    if done is None or taken is None or edge is None or taken[1] in (0, edge):
        return 2
    return int(taken[1] < edge)


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


def _lone(items: list[Item]) -> bool:
    """Whether one stitch is all that items work."""
    _, inner = led(items)
    one = inner[0] if len(inner) == 1 else None
    return isinstance(one, Action) and one.times == 1


def _second(read: Callable[[frozenset[str]], Body], body: Body, begun: int, fit: Callable[[Body], int]) -> Body | None:
    """The first combination of second readings that fits better than ``begun``, the fewest of them first."""
    asked = list(body.asked)[:5]
    best: Body | None = None
    for many in range(1, len(asked) + 1):
        for chosen in combinations(asked, many):
            counted = body.stated is None and bool(set(chosen) & _COUNTED)
            if counted and begun:
                continue  # only a count speaks for these, or a round below that the first readings do not fit on
            try:
                other = read(frozenset(chosen))
            except NotUnderstood:
                continue
            if "open" in chosen:
                lead, inner = led(other.items)
                other.items = [*lead, Group(tuple(inner), None, body.asked["open"])]
            found = fit(other)
            if found > begun and (found > 1 or not counted):
                other.asked = {what: body.asked[what] for what in chosen}
                best, begun = other, found
        if best is not None:
            return best
    return None

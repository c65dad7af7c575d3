"""Printed patterns, strands: what is worked back along a chain that stands off a round ("ch 21, 2 hdc in each ch back"), stitch by stitch."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from tambour.crochet.language.stitches import Stitch, into_one
from tambour.crochet.language.tree import Action, Item
from tambour.crochet.printed.cursor import OPEN
from tambour.crochet.printed.rounds.clauses import Where, where
from tambour.crochet.printed.rounds.counts import closing, multiplier
from tambour.crochet.printed.rounds.reader import Reader

_BACK: Final = frozenset(("back", "down", "along", "across", "backwards", "backward", "up", "again", "to", "the", "whole", "entire", "way", "it",
                          "towards", "toward", "start", "beginning", "length", "of", "chain", "end", "head", "body", "base"))  # fmt: skip
_BEGINS: Final = (
    "start",
    "starting",
    "begin",
    "beginning",
    "from",
    "working",
    "work",
    "worked",
    "then",
    "now",
    "at",
    "in",
    "sts",
    "stitches",
)
_FEWEST: Final = 6  # chains of a strand whose first link is not said, "ch 21, 2 hdc in each ch"
_LONGEST: Final = 400


@dataclass(slots=True)
class _Way:
    """What goes back along a chain of ``size``: how many of its links are behind the hook, the stitches so far, and what was last worked
    into each link."""

    size: int
    past: int
    made: list[tuple[Stitch, int]]
    last: tuple[Stitch, int] | None = None

    def add(self, stitch: Stitch, times: int) -> bool:
        """Whether so many of ``stitch`` still go into the chain; they are added then."""
        takes = stitch.takes * times
        if takes < 1 or self.past + takes > self.size:
            return False
        self.made.append((stitch, times))
        self.past += takes
        return True


def strand(r: Reader, found: list[Item], given: tuple[str, int] | None, passed: int) -> bool:
    """Puts a strand in place of the chains just read; whether it does. ``given`` : the stitch that was read into the link ``passed`` from
    the hook, and how many of it; None where only the place was said."""
    last = found[-1] if found else None
    if not isinstance(last, Action) or last.name != "ch" or not passed <= last.times <= _LONGEST or passed < 2:
        return False
    way = _Way(last.times, passed - 1, [])
    begin = r.c.at
    if given is not None:
        way.last = given = (r.stitches[given[0]], given[1])  # type: ignore[assignment]
        if not way.add(_each(r, *way.last), 1):
            return False
    _along(r, way)
    if not way.made or (given is None and way.past < way.size):
        r.c.at = begin
        return False
    stem = way.size - way.past
    _hang(r, found, way, stem)
    _own_count(r, way)
    return True


def all_along(r: Reader, found: list[Item], name: str, many: int, place: Where) -> bool:
    """Puts a strand in place of the chains just read, where the stitch just read goes into each of them: "ch 21, 2 hdc in each ch back";
    whether it does."""
    c, last = r.c, found[-1] if found else None
    if not isinstance(last, Action) or last.name != "ch" or last.times > _LONGEST or not place.each or place.count > 1:
        return False
    kind = r.stitches[name]
    if kind.takes != 1 or kind.where or name in ("ch", "skip"):
        return False
    said = [t for t in c.tokens if place.span.start <= t.start < place.span.end]
    if not any(t.kind == "stitch" and t.value == "ch" for t in said):
        return False
    begin = c.at
    back = _rest(r)
    first = _first(r)
    if not back and not first and last.times < _FEWEST:
        c.at = begin
        return False
    lift = max(1, round(max((m.height for m in kind.moves), default=1.0)))
    way = _Way(last.times, (first or lift + 1) - 1, [])
    if not way.add(_each(r, kind, many), way.size - way.past):
        c.at = begin
        return False
    _hang(r, found, way, 0)
    _own_count(r, way)
    return True


def _own_count(r: Reader, way: _Way) -> None:
    """Goes past the count of the strand itself, "(48 sc)", in the middle of a round."""
    c = r.c
    number = c.whole(1) if c.mark(*OPEN) else None
    if number is None or number != sum(stitch.makes * many for stitch, many in way.made):
        return
    end = closing(r)
    if end - c.at <= 3 and end + 1 < len(c.tokens):
        c.at = end + 1


def _hang(r: Reader, found: list[Item], way: _Way, stem: int) -> None:
    """The strand in place of its chain, but for the ``stem`` of it that nothing was worked into."""
    last = found.pop()
    assert isinstance(last, Action)
    made = into_one([(r.stitches["ch"], way.size - stem), *way.made], "curl")
    r.stitches.setdefault(made.name, made)
    if stem:
        found.append(Action("ch", last.span, stem, last.times_span))
    found.append(Action(made.name, last.span))
    r.body.curled = True


def _each(r: Reader, stitch: Stitch, many: int) -> Stitch:
    """``many`` of a stitch in one link."""
    if many == 1:
        return stitch
    made = into_one([(stitch, many)])
    r.stitches.setdefault(made.name, made)
    return made


def _along(r: Reader, way: _Way) -> None:
    """Goes past the clauses that are worked into the chain, and adds what they work; what is bare ("sc 3, hdc 2") belongs to it only
    where it ends where the chain does."""
    c = r.c
    sure, kept = c.at, (way.past, len(way.made))
    while way.past < way.size:
        begin = c.at
        named = _clause(r, way)
        if named is None:
            c.at = begin
            break
        if named:
            sure, kept = c.at, (way.past, len(way.made))
    if way.past < way.size:
        c.at, way.past = sure, kept[0]
        del way.made[kept[1] :]
    else:
        _rest(r)


def _clause(r: Reader, way: _Way) -> bool | None:
    """Reads one clause; whether it names the chain, None where it is none of the chain."""
    c = r.c
    while c.mark(",", ".", ";", ":") or c.key("and", "begin") or _word(r, *_BEGINS):
        if c.key("in") and way.last is not None:
            break
        c.at += 1
    if c.mark(*OPEN):
        return _bracket(r, way)
    number = c.take().value if c.whole() is not None and (c.kind("stitch", 1) or c.mark(*OPEN, ahead=1)) else None
    if c.kind("stitch"):
        token = c.take()
        name = str(token.value)
        if name == "skip":
            place = where(c, True)
            way.past += (place.count if place is not None else 0) or 1
            return True if way.past < way.size else None
        if name == "ch" or name not in r.stitches:
            return None
        stitch, many = r.stitches[name], number or 1
        if number is None and c.whole() is not None and not c.kind("stitch", 1):
            many = c.take().value  # "sc 3"
        worded = number
    elif way.last is not None and (c.key("in", "each", "next", "last")):
        stitch, many = way.last
        worded = many
    else:
        return None
    at = c.at
    place = where(c, c.key("next", "each", "last"))
    if place is None:
        back = _rest(r)
        way.last = (stitch, 1)
        if back and many == 1:
            return True if way.add(stitch, (way.size - way.past) // max(1, stitch.takes)) else None
        return False if way.add(stitch, int(many)) else None
    said = c.tokens[at : c.at]
    chained = any(t.kind == "stitch" and t.value == "ch" for t in said) or any(t.value == "foundation" for t in said)
    back = _rest(r)
    if place.kind == "hook":
        return None
    if not chained and not (back and place.each):
        return None
    each = (worded or 1) if isinstance(worded or 1, int) else 1
    one = _each(r, stitch, int(each)) if stitch.takes == 1 else stitch
    way.last = (stitch, int(each)) if stitch.takes == 1 else (stitch, 1)
    rest = place.kind == "around" or (
        place.each and place.count == 1 and (back or any(t.value in ("rest", "around") for t in said))
    )
    whole = rest or (place.each and place.count == 1)
    times = way.size - way.past if whole else place.count
    return True if way.add(one, times // max(1, one.takes) if stitch.takes > 1 else times) else None


def _bracket(r: Reader, way: _Way) -> bool | None:
    """Reads "(2 dc in next ch) 5 times" or "[sc, inc] x 5"."""
    c = r.c
    end = closing(r)
    c.at += 1
    inner = _Way(way.size - way.past, 0, [])
    named: bool | None = False
    while c.at < end:
        one = _clause(r, inner)
        if one is None or c.at > end:
            return None
        named = named or one
    c.at = end + 1
    given = multiplier(r)
    times = given[0] if given is not False and given[0] else 1 if given is False else 0
    if not inner.made or not times or way.past + inner.past * times > way.size:
        return None
    way.made += inner.made * times
    way.past += inner.past * times
    return named


def _first(r: Reader) -> int:
    """Which link from the hook is the first, where it is said behind: "starting from 2nd ch from hook"; 0, the cursor unmoved, where not."""
    c, begin = r.c, r.c.at
    while c.mark(",") or c.key("begin", "in", "from") or _word(r, *_BEGINS):
        c.at += 1
    place = where(c, True) if c.kind("ordinal") else None
    if place is None or place.kind != "hook":
        c.at = begin
        return 0
    return place.ordinal


def _rest(r: Reader) -> bool:
    """Goes past "back", "back down the chain", "across to the head"; whether such words stand there."""
    c, begin = r.c, r.c.at
    while (token := c.look()) is not None and (
        token.word in _BACK or (c.at > begin and token.kind == "stitch" and token.value == "ch")
    ):
        c.at += 1
    if c.at > begin and all(t.word in ("to", "the", "of", "end", "it") for t in c.tokens[begin : c.at]):
        pass
    return c.at > begin


def _word(r: Reader, *words: str) -> bool:
    token = r.c.look()
    return token is not None and token.word in words

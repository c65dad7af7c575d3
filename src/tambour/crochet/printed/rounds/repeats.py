"""Printed patterns, what is repeated: brackets, asterisks, and the words that say how often."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from typing import Final, Literal

from tambour.core.errors import Span
from tambour.crochet.language.stitches import STANDING
from tambour.crochet.language.tree import Action, Group, Item
from tambour.crochet.printed.cursor import OPEN, Cursor, NotUnderstood
from tambour.crochet.printed.rounds.asides import things
from tambour.crochet.printed.rounds.clauses import Where, to_last, to_space, where
from tambour.crochet.printed.rounds.counts import (
    Times,
    bracketed_count,
    checked,
    closing,
    counted_at,
    ends_with_number,
    last_worked,
    multiplier,
)
from tambour.crochet.printed.rounds.curls import curled
from tambour.crochet.printed.rounds.heaped import again_into_ring, placed
from tambour.crochet.printed.rounds.reader import Reader
from tambour.crochet.printed.rounds.standing import standing
from tambour.crochet.printed.tokens import Token

_REMARKED: Final = frozenset(("inc'd", "dec'd", "increased", "decreased", "made", "worked", "group", "groups"))


_BRACKETS: Final = frozenset(("brackets", "bracket", "parentheses", "parenthesis"))
_REMARKS: Final = frozenset(
    ("top", "including", "center", "first", "last", "about", "approx", "see", "for", "longest", "formerly")
)


def bracket(r: Reader, found: list[Item], token: Token) -> None:
    """At an opening bracket: a count, a remark, or items that are repeated or worked into one stitch."""
    c = r.c
    begin, end = c.at, closing(r)
    if bracketed_count(r, found, end):
        return
    words = c.tokens[begin + 1 : end]
    if words and words[-1].word in _REMARKED and not any(t.kind == "mark" for t in words):
        c.at = end + 1  # "(increase made)"
        return
    if any(t.kind == "key" and t.value == "count" for t in words):
        # "(does not count as a stitch)", "(counts as the first dc)"
        stands = not any(t.kind == "key" and t.value == "not" for t in words)
        if (
            any(t.word in ("here", "throughout") for t in words)
            and found
            and isinstance(found[-1], Action)
            and found[-1].name == "ch"
        ):
            if stands and (space := _spaced(found[-1], words)):
                r.spaced[found[-1].times] = space[1]
            else:
                r.standing[found[-1].times] = stands
        if stands and not _with_chains(found, words):
            standing(found)
        c.at = end + 1
        return
    within = _times_within(words)
    outer, c.tokens, before = c.tokens, c.tokens[: end - 3 * bool(within)], r.before
    place = before if before is not None and before.spaces else None  # "in next corner sp work (3 dc, ch 2, 3 dc)"
    r.before = None if place is not None else before
    c.at += 1
    r.depth += 1
    inner: list[Item] = []
    body = (r.body.ends, r.body.sides)
    try:
        r.items(inner, frozenset())
    except NotUnderstood:
        if _instructs(words):
            raise
        inner, (r.body.ends, r.body.sides) = [], body  # words in brackets are a remark
    finally:
        c.tokens = outer
        r.depth -= 1
    r.before = r.before if inner else before  # "hdc2tog (over same st as last sl st and next st)"
    c.at = end + 1
    if inner and all(isinstance(i, Action) and i.name in ("color", "flo", "blo", "bl") for i in inner):
        held = outer[max(0, begin - 2) : begin]
        said = held[-1:] if held and held[-1].kind != "number" else held[:1]  # "6 sc (red)", "sc 6 (red)"
        behind = any(t.kind == "stitch" or t.value in ("stitch", "around") for t in said) and len(inner) == 1
        behind = behind and not any(t.value in ("color", "to") for t in words)  # "(change to red)"
        led_so = outer[r.begun].word in OPEN and c.kind("number") + c.kind("stitch") > 0  # "[white] sc 9 [red] sc 9"
        label = len(inner) == 1 and not any(t.value in ("color", "to") for t in words) and c.look() is None
        label = label and r.body.stated_span is not None and not r.depth  # "sc around (18) [red]"
        at = 0 if label else last_worked(found) if behind and not led_so else len(found)
        found[at:at] = inner
    elif inner and place is not None:
        r.before = None
        found += _into(r, found, inner, place, Span(token.start, outer[end].end))
    elif inner and within is not None:
        found.append(Group(tuple(inner), *checked(within.value, within)))
    elif inner:
        repeated(r, found, inner, Span(token.start, outer[end].end), star=False)


def _times_within(words: list[Token]) -> Token | None:
    """How often a bracket is worked that says so itself, behind a dash: "[2 sc in next st, sc in next st - 6 times]"; None where it does
    not."""
    said = len(words) > 3 and words[-1].value == "times" and words[-3].kind == "mark" and words[-3].word == "-"
    return words[-2] if said and words[-2].kind == "number" and isinstance(words[-2].value, int) else None


def _with_chains(found: list[Item], words: list[Token]) -> bool:
    """Takes chains that count as a stitch and a space ("counts as dc, ch 1") for these; whether they do."""
    last = found[-1] if found else None
    space = _spaced(last, words)
    if space is None or last is None:
        return False
    found[-1:] = [Action(space[0], last.span), Action("ch", last.span, space[1])]
    return True


def _spaced(last: Item | None, words: list[Token]) -> tuple[str, int] | None:
    """The stitch, and the chains of a space behind it, that ``words`` say the chains ``last`` count as; None where they say no such."""
    kind = next((t.value for t in words if t.kind == "stitch"), "")
    words = [t for t in words if t.word != "-"]  # "counts as dc and ch-2 space"
    chained = next(
        (k for k, t in enumerate(words[:-1]) if t.value == "ch" and isinstance(words[k + 1].value, int)), None
    )
    name = next((name for name, of in STANDING.items() if of == kind), "")
    if not isinstance(last, Action) or last.name != "ch" or not name or chained is None or kind == "ch":
        return None
    many = int(words[chained + 1].value)
    return (name, many) if int(name[2]) + many == last.times else None


def _instructs(words: list[Token]) -> bool:
    """Whether words in brackets are instructions, and not a remark that names stitches."""
    if words and ((words[-1].kind == "key" and words[-1].value in ("round", "row")) or words[-1].word in _REMARKED):
        return False  # "(Dec rnd)", "(1 sc inc'd)"
    if words and words[0].value == "same" and any(t.value == "as" for t in words):
        return False  # "(same sc as joining sl st)"
    if words and words[0].word in _REMARKS and not any(t.kind == "key" and t.value == "repeat" for t in words):
        return False  # "(top of ch-4)", "(first hdc)", "(including joining sc)"
    if things(Cursor(words)):
        return False  # "(5 clusters of 7-dc)"
    stitches = sum(t.kind == "stitch" for t in words)
    if stitches and words[-1].value == "times":
        return True
    return stitches * 3 >= sum(t.kind in ("word", "key", "stitch") for t in words) > 0


def star(r: Reader, found: list[Item], token: Token) -> None:
    """``*items; rep from * around``, ``*items* 6 times``; a star without its pair repeats all before it."""
    c = r.c
    c.at += 1
    lead, inner = led(found)
    ends = c.look() is None or c.key("repeat", "around", "times") or c.mark("x", ".", "=")
    if inner and (ends or (c.mark(*OPEN) and counted_at(r, closing(r)))):
        found[:] = lead
        repeated(r, found, inner, token.span, star=True)
        return
    inner = []
    while True:
        _starred(r, inner)
        later = any(t.word in ("*", "**") or (t.kind == "key" and t.value == "repeat") for t in c.tokens[c.at :])
        if not c.mark(".") or not (later or _more_stitches(r)):
            break
        c.at += 1  # a sentence ends, the repeat goes on
    partly = c.mark("**") and token.word == "*" and _ends_at(c.tokens[c.at + 1 :])
    if c.mark("*", "**"):
        c.at += 1
    if not inner:
        raise NotUnderstood(token, "nothing stands after this asterisk", "say what is repeated")
    if partly:
        _partly(r, found, inner, token.span)
        return
    if not later and c.mark(".") and any(t.kind == "key" and t.value == "around" for t in c.tokens[c.at :]):
        found += inner  # a stray star: what goes around is said further on
        return
    if again_later(r):
        r.starred = tuple(inner)
        found.append(Group(r.starred, 1, token.span))
        return
    repeated(r, found, inner, token.span, star=True)


def _ends_at(tokens: list[Token]) -> bool:
    """Whether words behind a double asterisk say that the last repeat ends there: "ending last repeat at **", "then from * to ** once"."""
    repeats = next((k for k, t in enumerate(tokens) if t.kind == "key" and t.value == "repeat"), None)
    said = [t.value if t.kind == "key" else t.word for t in tokens[repeats:]] if repeats is not None else []
    return any(b == "**" and a in ("at", "to", "with", "before", "in", "on") for a, b in pairwise(said))


def _partly(r: Reader, found: list[Item], first: list[Item], span: Span) -> None:
    """``*first** rest; repeat from * around, ending last repeat at **``: what stands before the double asterisk is worked once more than
    what stands behind it."""
    c = r.c
    rest: list[Item] = []
    while True:
        _starred(r, rest)
        if not c.mark("."):
            break
        c.at += 1
    given = times(r, True)
    many = given[0] if given is not False else None
    begin = c.at
    while (word := c.look()) is not None and not c.mark("**") and not c.kind("stitch"):
        c.at += 1
    once = c.key("from", ahead=begin - c.at) or any(t.value in ("from", "repeat") for t in c.tokens[begin : c.at][:4])
    last = any(t.value == "last" for t in c.tokens[begin : c.at])
    if word is None or not c.mark("**"):
        raise NotUnderstood(c.tokens[begin - 1], "where the last repeat ends is not said", "ending last repeat at **")
    c.at += 1
    given = multiplier(r)
    if many is None:
        found += [*first, Group((*rest, *first), None, span)]
    else:  # "rep from * twice more, then from * to ** once" is one more than "3 times, ending last repeat at **"
        found += [Group((*first, *rest), many - (last and not once), span), *first]


def again_later(r: Reader) -> bool:
    """Whether what stands between two asterisks is worked once, and once more behind other stitches: "*…* (2 dc in next st) twice. Rep from
    * to * once more"; the cursor stands behind the second of them."""
    c = r.c
    later = next((k for k in range(c.at, len(c.tokens) - 4) if again_said(c.tokens[k:])), -1)
    return c.mark("*", "**", ahead=-1) and any(t.kind == "stitch" for t in c.tokens[c.at : max(later, c.at)])


def again_said(tokens: list[Token]) -> bool:
    """Whether words begin with "rep from * to *"."""
    said = [t.value if t.kind == "key" else t.word for t in tokens[:5]]
    return said[:3:2] == ["repeat", "*"] and said[1] in ("from", "between") and said[3:] in (["to", "*"], ["and", "*"])


def between_stars(r: Reader, found: list[Item]) -> None:
    """``rep from * to * once more`` behind other stitches, at the word that repeats: what stood between the asterisks."""
    at = r.c.tokens[r.c.at].span
    given = times(r, True)
    many = given[0] if given is not False else 2
    found.append(Group(r.starred, None if many is None else max(1, many - 1), at))
    r.starred = ()


def _more_stitches(r: Reader) -> bool:
    """Whether the sentence behind the point at the cursor is stitches, and no count: of a repeat whose end is not said."""
    c = r.c
    if c.whole(1) != 1 and ends_with_number(r, 1):
        return False
    plain = c.kind("stitch", 1) or (c.whole(1) is not None and c.kind("stitch", 2))
    return plain and not (c.kind("stitch", 1) and c.look(1).value in ("slst", "ch"))  # type: ignore[union-attr]


def _last_count(r: Reader) -> bool:
    """Whether the sign at the cursor stands before the count of the round, and no word repeats after it."""
    depth, r.depth = r.depth, r.depth - 1
    try:
        return ends_with_number(r, 1) and not any(
            t.word == "*" or (t.kind == "key" and t.value == "repeat") for t in r.c.tokens[r.c.at :]
        )
    finally:
        r.depth = depth


def _starred(r: Reader, inner: list[Item]) -> None:
    """Clauses up to the closing star, the word repeat, or a full stop."""
    c = r.c
    r.depth += 1
    r.stars += 1
    try:
        while (token := c.look()) is not None and not c.mark("*", "**", ".") and not c.key("repeat"):
            if inner and c.mark("-", "=") and _last_count(r):
                return  # "*1 sc in next 3 sts, 2 sc in next st—15 sts": the repeat is left open
            if not r.between(token):
                if token.kind == "mark" and token.word in OPEN and counted_at(r, closing(r)):
                    return
                r.clause(inner, token)
    finally:
        r.depth -= 1
        r.stars -= 1


def led(found: list[Item]) -> tuple[list[Item], list[Item]]:
    """Items parted in those that begin a round (chains, turns, colours, loops) and those that repeat."""
    at = 0
    while at < len(found):
        item = found[at]
        if not isinstance(item, Action) or item.name not in (
            "ch",
            "turn",
            "color",
            "flo",
            "blo",
            "join",
            "mr",
            "tospace",
        ):
            break
        at += 1
    return found[:at], found[at:]


def repeated(r: Reader, found: list[Item], inner: list[Item], span: Span, star: bool) -> None:
    """``inner`` as often as the words after it say, or into the one stitch that they name."""
    c = r.c
    begin = c.at
    first = c.look()
    c.at += (
        not star and first is not None and first.word == "all" and c.key("in", ahead=1)
    )  # "(sc, ch 3, sc) all in corner ch-3 sp"
    place = None if star else where(c)
    if place is not None and place.loops:
        given = times(r, star)
        middle = list(inner) if given is False else [Group(tuple(inner), *given)]
        found += [Action(place.loops, place.span), *middle, Action("bl", place.span)]
        return
    if place is not None and place.kind != "loops":
        if place.kind == "around" and not place.each:
            found.append(Group(tuple(inner), None, place.span, place.leaves, place.until))
        else:
            found += _into(r, found, inner, place, span)
        return
    c.at = begin
    given = times(r, star)
    if given is not False and given[0] and not star and (one := _one_place(r)) is not None:
        found += _into(r, found, [Group(tuple(inner), *given)], one, span)  # "(dc, ch 1) 6 times in ring"
        return
    if star and any(isinstance(i, Group) and i.times is None and not i.until for i in inner):
        found += inner  # a stray star: what it holds goes around by itself
    elif given is not False and given[0] and again_into_ring(r, found, inner, given[0], span):
        pass
    elif given is not False:
        found.append(Group(tuple(inner), *given, *((r.leaves, r.until) if given[0] is None else ())))
    elif star:
        found.append(Group(tuple(inner), None, span))
    else:
        r.ask("once", span)
        found.append(Group(tuple(inner), None if "once" in r.choices else 1, span))


def _one_place(r: Reader) -> Where | None:
    """The one place behind how often a bracket is worked ("all in 2nd ch from hook", "in ring", "in next st"); None, the cursor unmoved,
    where none is said or several are."""
    c, begin = r.c, r.c.at
    if c.key("each") and c.key("in", ahead=1):
        c.at += 1
    place = where(c) if c.key("in") else None
    if place is None or place.count != 1 or place.loops or place.each or place.kind in ("around", "loops"):
        c.at = begin
        return None
    return place


def _into(r: Reader, found: list[Item], inner: list[Item], place: Where, span: Span) -> list[Item]:
    """``inner`` worked into one place, which may be a chain from the hook."""
    if place.kind == "hook":
        if curled(r, found, inner, place):
            return []
        r.body.hook, r.body.fresh = place.ordinal, len(found)
    return placed(r, found, inner, place, span)


def more_times(r: Reader, found: list[Item]) -> bool:
    """Works the brackets just read so many times more, where the cursor stands at "work directions in brackets 2 more times"; whether it does."""
    c, last = r.c, found[-1] if found else None
    if not c.key("instructions", "repeat") or not isinstance(last, Group) or last.times is None:
        return False
    ahead = next((k + 1 for k in range(1, 5) if (t := c.look(k)) is not None and t.word in _BRACKETS), 0)
    if not ahead:
        return False
    begin, c.at = c.at, c.at + ahead
    number = c.take() if c.whole() is not None and c.key("more", ahead=1) else None
    given: Times | Literal[False] = (number.value, number.span) if number is not None else multiplier(r)
    if given is False or given[0] is None:
        c.at = begin
        return False
    c.skip_key("more")
    c.skip_key("times")
    found[-1] = replace(last, times=last.times + given[0])
    return True


def _all_round(c: Cursor) -> None:
    """Goes past "all around", "around the whole edge", behind how often a repeat is worked."""
    while c.key("around", "total") or (
        (word := c.look()) is not None and word.word == "all" and c.key("around", ahead=1)
    ):
        c.at += 1


def times(r: Reader, star: bool) -> Times | Literal[False]:
    """How often, by the words at the cursor: a number, or None for around, and its place; False when nothing is said."""
    c = r.c
    begin = c.at
    r.leaves = r.until = 0
    while c.mark(",", ";", "-", ".", ":", "and") and (c.key("repeat", "around", ahead=1) or c.mark("x", ahead=1)):
        c.at += 1
    said = c.at if c.key("repeat") else -1
    from_star = False
    if said >= 0:
        c.at += 1
        # "from * to *", "between * and *", "this", "between brackets"
        while (
            c.key("from", "to", "between", "and")
            or c.mark("*", "**")
            or (c.mark("-") and c.mark("*", ahead=-1))
            or (c.kind("word") and c.at - said < 6)
        ):
            if c.key("to") and (many := to_last(c)) is not None:
                r.leaves = many
                return None, c.tokens[said].span
            if c.key("to") and (until := to_space(c)):
                r.until = until
                return None, c.tokens[said].span
            if c.mark("*") and c.whole(1) is not None and not c.key("from", "to", "between", "and", ahead=-1):
                break
            from_star = from_star or c.key("from")
            c.at += 1
        if c.mark(",") and (c.key("around") or c.whole(1) is not None):
            c.at += 1
    c.skip_key("total")
    if c.mark("(") and c.whole(1) is not None and c.mark(")", ahead=2) and c.key("times", "more", ahead=3):
        number = c.tokens[c.at + 1]
        c.at += 3
        more = c.skip_key("more")
        c.skip_key("times")
        return checked(number.value + more, number)
    given = multiplier(r)
    token = c.look()
    if given is not False:
        count, span = given
        if c.skip_key("more") and count is not None:
            count += 1
        elif star and from_star and count is not None:
            r.ask("more", span)
            count += "more" not in r.choices
        if count is not None:
            _all_round(c)
        return count, span
    if token is not None and c.whole() is not None:
        if c.key("more", ahead=1):
            c.at += 2
            c.skip_key("times")
            _all_round(c)
            return checked(token.value + 1, token)
        if token.glued or (said >= 0 and not c.kind("stitch", 1)):
            c.at += 1
            return checked(token.value, token)
    if token is not None and c.key("around"):
        c.at += 1
        if c.key("to"):
            r.leaves = to_last(c) or 0
            r.until = 0 if r.leaves else to_space(c)
        return None, token.span

    if said >= 0:
        place = where(c)
        return None, place.span if place is not None else c.tokens[said].span
    c.at = begin
    return False

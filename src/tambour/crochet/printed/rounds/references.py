"""Printed patterns, references: rounds that are named instead of written ("as Rnds 2-4 of Head", "rep last rnd 3 times more")."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from typing import Final

from tambour.core.errors import Span
from tambour.crochet.places.names import kind_of, one
from tambour.crochet.printed.cursor import Cursor, NotUnderstood, Refers
from tambour.crochet.printed.heads import STARS, list_of_numbers, list_of_ordinals
from tambour.crochet.printed.rounds.asides import aside
from tambour.crochet.printed.rounds.counts import multiplier
from tambour.crochet.printed.rounds.reader import Reader
from tambour.crochet.printed.tokens import Token

_UNITS: Final = {"in": 25.4, "ins": 25.4, "inch": 25.4, "inches": 25.4, '"': 25.4, "cm": 10.0, "mm": 1.0}
_FRACTIONS: Final = {"1⁄4": 0.25, "1⁄2": 0.5, "3⁄4": 0.75, "1⁄3": 1 / 3, "2⁄3": 2 / 3, "1⁄8": 0.125, "3⁄8": 0.375}
"""As "½" and its kind stand among the tokens."""
_GIVEN: Final = frozenset(
    ("given", "instructions", "directions", "instructed", "written", "described", "done", "previously")
)
_SMALL: Final = frozenset(("the", "very", "your", "its", "this"))
_JOINS: Final = frozenset("join joined joining".split())
_BASES: Final = ("", "base")
"""Kinds of parts that another is not measured from: its own base is where it begins."""
_LEADS: Final = frozenset(("ending", "end", "finishing", "finish", "on", "work", "working"))
_LEFT: Final = frozenset(("rem", "remain", "remaining", "left", "around", "in"))
_ONE: Final = frozenset(("round", "rnd", "row", "rd"))
_ENDS: Final = (".", ",", ";", "(", ")", "[", "]", "-", ":", "*", *STARS, "=")


def refers(r: Reader) -> Refers | None:
    """The reference at the cursor, which goes on to the end of its clause; None, the cursor unmoved, where none is said."""
    c = r.c
    begin = c.at
    first = c.tokens[begin]
    repeats = c.key("repeat")
    while c.key("repeat", "as", "same", "for", "in", "from", "each") or (
        c.kind("word") and c.tokens[c.at].word in _GIVEN
    ):
        if c.key("from") and c.mark("*", *STARS, ahead=1):
            break
        if c.key("each", "in", "from") and not (c.key("round", "row", ahead=1) or c.kind("word", 1)):
            break
        c.at += 1
    found: Refers | None = None
    numbers: list[int] = []
    if c.key("from") and c.mark(*STARS, ahead=1) and c.key("to", ahead=2) and c.mark(*STARS, ahead=3):
        c.at += 4
        found = Refers(first.span, marks=(c.tokens[c.at - 3].word, c.tokens[c.at - 1].word))
    elif c.key("last") and (
        c.key("round", "row", ahead=1) or (c.whole(1) is not None and c.key("round", "row", ahead=2))
    ):
        many = c.whole(1)
        c.at += 2 if many is None else 3
        found = Refers(first.span, latest=1 if many is None else many)
    elif c.key("round", "row") and (only := c.whole(1)) is not None:
        c.at += 1
        if (
            c.tokens[c.at - 1].word in _ONE
            and c.mark("-", ahead=1)
            and (c.kind("stitch", 3) or c.key("stitch", ahead=3))
        ):
            c.at += 1
            numbers.append(only)  # "Repeat Round 8—48 sc"
        else:
            list_of_numbers(c, numbers)
        found = Refers(first.span, tuple(numbers))
    elif (c.kind("ordinal") or c.kind("number")) and list_of_ordinals(c, numbers):
        found = Refers(first.span, tuple(numbers))
    elif not repeats and c.at > begin and c.look() is not None and not c.kind("number"):
        found = Refers(first.span)
    if found is None:
        c.at = begin
        return None
    times, length, whole = None, None, True
    words: list[str] = []
    through, to_count, mirrored, upto, vague = 0, 0, False, 0, False
    while (token := c.look()) is not None:
        if token.kind == "mark" and token.word in _ENDS:
            if (
                token.word == ","
                and words
                and not (numbers or found.latest or found.marks)
                and _named_behind(c, numbers)
            ):
                found = replace(found, numbers=tuple(numbers))  # "as for First Leg, Rnds 1-5"
                continue
            often = c.key("twice", ahead=1) or (c.whole(1) is not None and c.key("times", "more", ahead=2))
            if token.word == "," and often and times is None:
                c.at += 1  # "Rounds 6 and 7, 2 more times"
                continue
            if not (past := _meanwhile(c)):
                break
            r.body.doings.append(c.tokens[c.at + 1 : past])
            c.at = past
            continue
        if (c.key("color") and token.word.startswith("chang")) or (words and r.yarned()):
            break  # "as for Head using D", whose yarn is no word of a name
        if words and token.word == "but":
            break  # "as Front but do not cut the yarn"
        if not numbers and not found.latest and found.marks is None and _named(c, numbers):
            found = replace(found, numbers=tuple(numbers))
            continue
        if (numbers or found.latest) and further(c):
            break  # "Rounds 6 and 7 twice and then Round 6"
        if (given := multiplier(r)) is not False:
            times = given[0]
            if c.skip_key("more"):
                c.skip_key("times")
            continue
        if c.whole() is not None and c.key("more", ahead=1):
            times = c.whole()
            c.at += 2
            c.skip_key("times")
        elif many := until(c):
            to_count = many
        elif c.key("until") or (c.key("to") and c.key("measures", ahead=2)):
            if upto := _in_all(c):
                continue
            length, whole = _length(c)
            if length is None and any(
                t.kind in ("number", "ordinal", "stitch") for t in c.tokens[c.tokens.index(token) : c.at]
            ):
                raise NotUnderstood(
                    token, "how long this goes on is not understood", "say the rounds, or a length in inches or cm"
                )
            vague = length is None
        elif (
            (c.key("to") and c.key("round", "row", ahead=1) and c.whole(2) is not None)
            or (token.word in ("through", "thru") and c.key("round", "row", ahead=1) and c.whole(2) is not None)
            or (
                c.key("in")
                and token.word in ("through", "thru")
                and c.key("round", "row", ahead=1)
                and c.whole(2) is not None
            )
        ):
            through = c.whole(2) or 0
            c.at += 3
        elif token.word in ("reversing", "reverse", "reversed"):
            mirrored = True
            c.at += 1
        else:
            if token.kind in ("word", "ordinal", "stitch") or (
                token.kind == "key" and token.value not in ("as", "for", "in", "from", "round", "row")
            ):
                words += [] if token.word in _GIVEN or token.word in ("alternately", "again") else [token.word]
            c.at += 1
    to_count = _shaped(c) or to_count
    _sided(c)
    part = " ".join(words)
    if not (numbers or found.latest or found.marks or part):
        c.at = begin
        return None
    if len(words) > 5:
        raise NotUnderstood(first, "what is repeated here is not understood", "name the rounds: as Rnds 2-4 of Head")
    span = Span(first.start, c.tokens[c.at - 1].end)
    return Refers(
        span,
        found.numbers,
        found.latest,
        found.marks,
        through,
        part,
        times,
        length,
        whole,
        mirrored,
        to_count,
        upto,
        vague,
    )


def further(c: Cursor) -> int:
    """How many words lead on from one reference to the next, ", and then work Round 6", ", ending with Round 6"; 0 where none does."""
    ahead = int(c.mark(","))
    led = 0
    while c.key("and", "repeat", "with", ahead=ahead) or ((word := c.look(ahead)) is not None and word.word in _LEADS):
        ahead, led = ahead + 1, led + 1
    return ahead if led and c.key("round", "row", ahead=ahead) and c.whole(ahead + 1) is not None else 0


def _named(c: Cursor, numbers: list[int]) -> bool:
    """Goes past "rounds 12 to 16", said behind the part that they are of, and puts them into ``numbers``; whether they stand there."""
    if c.key("round", "row") and c.whole(1) is not None:
        several = c.tokens[c.at].word.endswith("s")
        c.at += 1
        return list_of_numbers(c, numbers, several)
    return c.kind("ordinal") and list_of_ordinals(c, numbers)


def _named_behind(c: Cursor, numbers: list[int]) -> bool:
    """The same behind a comma, where nothing else is said of them."""
    begin = c.at
    c.at += 1
    if _named(c, numbers) and ((after := c.look()) is None or after.word in (".", ";")):
        return True
    c.at = begin
    numbers.clear()
    return False


def _meanwhile(c: Cursor) -> int:
    """Where "until" stands behind clauses that only say how hands go on, ", working in spiral, moving marker up, until …"; 0 for others."""
    at = c.at
    if not c.mark(","):
        return 0
    while at < len(c.tokens) and c.tokens[at].word == ",":
        after = c.tokens[at + 1] if at + 1 < len(c.tokens) else None
        if after is not None and after.kind == "key" and after.value == "until":
            return at + 1 if at > c.at else 0
        hands = after is not None and (
            aside(Cursor(c.tokens, at + 1)) or (after.value in ("in", "over") and after.word.startswith("in"))
        )
        if not hands:
            return 0
        at += 1
        while at < len(c.tokens) and c.tokens[at].word not in (",", ".", ";") and c.tokens[at].value != "until":
            at += 1
        if at < len(c.tokens) and c.tokens[at].value == "until":
            return at
    return 0


def _shaped(c: Cursor) -> int:
    """Goes past ", dec 2 sts every row to 8 sts" behind a reference to a row that does so, and gives the number; 0 where something else is
    said."""
    shapes = c.mark(",") and c.kind("stitch", 1) and c.look(1).value in ("inc", "dec")  # type: ignore[union-attr]
    if not shapes or c.whole(2) is None or not c.key("stitch", ahead=3):
        return 0
    begin = c.at
    c.at += 4
    while c.key("each", "round", "row"):
        c.at += 1
    many = until(c)
    c.at = c.at if many else begin
    return many


def _sided(c: Cursor) -> None:
    """Goes past ", ending on a WS row", behind how long something goes on."""
    first = c.look(1)
    if (
        c.mark(",")
        and first is not None
        and first.word == "or"
        and any(t.word in ("desired", "until") for t in c.tokens[c.at : c.at + 4])
    ):
        while (c.look(1)) is not None and c.look(1).kind != "mark":  # type: ignore[union-attr]
            c.at += 1
        c.at += 1  # ", or desired length"
    if c.mark(",") and first is not None and first.word in ("ending", "end"):
        ahead = 2
        while c.look(ahead) is not None and c.look(ahead).kind != "mark":  # type: ignore[union-attr]
            ahead += 1
        said = [c.look(k) for k in range(2, ahead)]
        if any(t is not None and t.word in ("ws", "rs", "wrong", "right") for t in said):
            c.at += ahead


def _in_all(c: Cursor) -> int:
    """Goes past "until there are 32 rows", or "until 32 rounds have been worked", and gives the number; 0 where something else is said."""
    ahead = 1
    while (word := c.look(ahead)) is not None and word.word in ("there", "are", "you", "have", "is", "total"):
        ahead += 1
    many = c.whole(ahead)
    after = c.look(ahead + 2)
    ends = (
        after is None
        or after.kind == "mark"
        or after.value in ("total", "in")
        or after.word in ("have", "are", "worked", "done")
    )
    if not c.key("until") or many is None or not c.key("round", "row", ahead=ahead + 1) or not ends:
        return 0
    c.at += ahead + 2
    while c.look() is not None and c.look().kind != "mark":  # type: ignore[union-attr]
        c.at += 1
    return many


def until(c: Cursor) -> int:
    """Goes past "to 21 sc", "until there are 63 sts", "until 8 sts rem", and gives the number; 0 where something else is said."""
    begin = c.at
    if not c.key("until", "to"):
        return 0
    c.at += 1
    while (word := c.look()) is not None and word.word in ("there", "are", "you", "have", "is"):
        c.at += 1
    many = c.whole()
    if many is None or not (c.key("stitch", ahead=1) or c.kind("stitch", 1)):
        c.at = begin
        return 0
    c.at += 2
    while (word := c.look()) is not None and (word.word in _LEFT or word.value == "rest"):
        c.at += 1
    return many


def _length(c: Cursor) -> tuple[float | None, bool]:
    """Goes on to the end of "until work measures 3 ins from beg" and gives the length, mm."""
    length, whole = None, True
    while (token := c.look()) is not None and not (token.kind == "mark" and token.word in (".", ",", ";", "(", "[")):
        if token.kind == "number" and length is None:
            value = float(token.value)
            ahead = 1
            part = c.look(ahead)
            if part is not None and part.word in _FRACTIONS:
                value += _FRACTIONS[part.word]
                ahead += 1
            elif c.whole(ahead) is not None and c.mark("/", "⁄", ahead=ahead + 1) and c.whole(ahead + 2):
                value += (c.whole(ahead) or 0) / (c.whole(ahead + 2) or 1)
                ahead += 3
            unit = c.look(ahead)
            if unit is not None and unit.word in _UNITS:
                length = value * _UNITS[unit.word]
                c.at += ahead
        elif token.word in _FRACTIONS and (unit := c.look(1)) is not None and unit.word in _UNITS and length is None:
            length = _FRACTIONS[token.word] * _UNITS[unit.word]
        whole = whole and not (token.kind == "key" and token.value == "marker") and token.word != "marked"
        whole = whole and not _from_elsewhere(c)
        c.at += 1
        end = _measured(c)
        c.at = end or c.at
    return length, whole


_PARTING: Final = frozenset(
    "previous division split dividing increases decreases increase decrease armhole armholes shaping".split()
)


def _from_elsewhere(c: Cursor) -> bool:
    """Whether a length is measured from a join, or from another part, "from joining rnd", "from top of shoe", "from color change": other
    words say where the part itself begins, in more ways than could be listed."""
    if not c.key("from"):
        return False
    ahead = 1
    while (word := c.look(ahead)) is not None and word.word in _SMALL:
        ahead += 1
    if word is None or word.kind == "mark":
        return False
    after = c.look(ahead + 1)
    shaped = after if word.value == "last" else word
    if shaped is not None and (shaped.value in ("inc", "dec") or shaped.word in _PARTING):
        return True  # "from last increase round", "from division for sleeves"
    if after is not None and (word.word == "top" or (word.word in ("color", "colour") and after.word == "change")):
        return after.kind != "mark"
    return word.word in _JOINS or word.value == "join" or kind_of(one(word.word.rstrip("."))) not in _BASES


def _measured(c: Cursor) -> int:
    """Where the bracket at the cursor ends that says a length once more, "[14 cm]"; 0 where none does."""
    end = next((k for k in range(c.at + 1, min(c.at + 8, len(c.tokens))) if c.tokens[k].word in (")", "]")), 0)
    inner = c.tokens[c.at + 1 : end]
    return end + 1 if c.mark("(", "[") and len(inner) > 1 and inner[-1].word in _UNITS else 0


def even_rounds(tokens: list[Token]) -> tuple[int, Span] | None:
    """How many rounds a sentence works plainly: "Work 3 rnds even in sc"; None for another sentence."""
    if len(tokens) > 8 or not any(t.kind == "key" and t.value == "even" for t in tokens):
        return None
    if not all(
        t.kind in ("number", "mark")
        or t.value == "sc"
        or (t.kind == "key" and t.value in ("round", "row", "even", "in", "for", "next", "more"))
        for t in tokens
    ):
        return None
    number = next(
        (t for t, u in pairwise(tokens) if t.kind == "number" and u.kind == "key" and u.value in ("round", "row")), None
    )
    return (
        None
        if number is None or not isinstance(number.value, int)
        else (number.value, Span(tokens[0].start, tokens[-1].end))
    )

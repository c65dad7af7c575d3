"""Printed patterns, numbers: counts that are stated (``[18]``, ``= 18``, ``- 18 sts``), repeats, and where a bracket closes."""

from __future__ import annotations

from typing import Final, Literal

from tambour.core.errors import Span
from tambour.crochet.language.tree import Action, Item
from tambour.crochet.printed.cursor import OPEN, NotUnderstood
from tambour.crochet.printed.reader import Reader
from tambour.crochet.printed.tokens import Token

DEEPEST: Final = 24  # brackets within brackets

Times = tuple[int | None, Span]


def ends_with_number(r: Reader, ahead: int) -> bool:
    """Whether a number stands there that ends the body, or its sentence."""
    c = r.c
    if c.whole(ahead) is None or r.depth:
        return False
    colon = ahead > 0 and c.mark(":")
    ahead += 1
    named = c.key("stitch", ahead=ahead)
    if c.kind("stitch", ahead) and (colon or (c.look(ahead + 1) is not None and not c.mark(".", ahead=ahead + 1))):
        return False
    ahead += named or c.kind("stitch", ahead)
    while c.key("total", "around", "in", "stitch", ahead=ahead):
        ahead += 1
    if c.mark("-", ahead=ahead) and c.look(ahead + 1) is None:
        ahead += 1
    return c.look(ahead) is None or c.mark(".", "(", "[", ahead=ahead) or (named and c.mark(",", ";", ahead=ahead))


def count(r: Reader, found: list[Item]) -> bool:
    """A count without brackets: ``= 18``, ``- 18 sts``, ``18 sts`` or, as a sentence of its own, ``18 sc``."""
    c = r.c
    sign = int(c.mark("-", "=", ":"))
    if not found or not ends_with_number(r, sign):
        return False
    if not sign and not c.key("stitch", "total", ahead=1) and not c.mark(".", "|", ";", ahead=-1):
        return False
    c.at += sign
    _state(r, c.take())
    r.to_separator()
    return True


def _state(r: Reader, token: Token) -> None:
    r.body.stated, r.body.stated_span = token.value, token.span


def counted_at(r: Reader, end: int) -> bool:
    """Whether the bracket at the cursor, which ends at ``end``, looks like a count of the round."""
    c = r.c
    inner = c.tokens[c.at + 1 : end]
    numbers = [t for t in inner if t.kind == "number" and isinstance(t.value, int)]
    if len(numbers) != 1:
        return False
    after = c.tokens[end + 1] if end + 1 < len(c.tokens) else None
    if after is not None and (after.word in ("x",) or (after.kind == "key" and after.value in ("times", "more"))):
        return False
    if all(
        t is numbers[0]
        or (t.kind == "key" and t.value in ("stitch", "total", "around", "count", "in", "round", "row", "each"))
        or (t.kind == "mark" and t.word in ":=~.")
        for t in inner
    ):
        return True
    named = len(inner) == 2 and inner[0] is numbers[0] and inner[1].kind == "stitch"
    return named and (after is None or after.word == ".")


def bracketed_count(r: Reader, found: list[Item], end: int) -> bool:
    """Reads the count of the round, if the bracket at the cursor is one."""
    c = r.c
    if r.depth or not found or not counted_at(r, end):
        return False
    inner = c.tokens[c.at + 1 : end]
    number = next(t for t in inner if t.kind == "number" and isinstance(t.value, int))
    last, after = found[-1], c.tokens[end + 1] if end + 1 < len(c.tokens) else None
    if after is not None and after.word in OPEN and isinstance(last, Action) and last.times == 1 and len(inner) == 1:
        c.at = end + 1
        if last.name in r.stitches and counted_at(r, closing(r)):  # "inc (6) [12]"
            found[-1] = Action(last.name, last.span, number.value, number.span)
            return True
    if any(t.kind == "key" and t.value in ("round", "row") for t in inner):
        r.body.rounds = (number.value, number.span)
    else:
        _state(r, number)
    c.at = end + 1
    c.skip_key("stitch")
    return True


def closing(r: Reader) -> int:
    """Where the bracket at the cursor closes; any closing mark closes any opening one."""
    depth = 0
    tokens, begin = r.c.tokens, r.c.at
    for at in range(begin, len(tokens)):
        token = tokens[at]
        if token.kind == "mark":
            depth += (token.word in OPEN) - (token.word in ")]}>")
            if depth > DEEPEST:
                raise NotUnderstood(token, "brackets are nested too deep", f"at most {DEEPEST} levels")
            if depth == 0:
                return at
    raise NotUnderstood(tokens[begin], "this bracket is not closed", f'"{OPEN[tokens[begin].word]}" closes it')


def multiplier(r: Reader) -> Times | Literal[False]:
    """``x 6``, ``6 times``, ``twice`` right at the cursor."""
    c = r.c
    token = c.look()
    if token is None:
        return False
    if (c.mark("x") or (c.mark("*") and not r.stars)) and c.whole(1) is not None:
        c.at += 1
        number = c.take()
        c.skip_key("times")
        return checked(number.value, number)
    if c.whole() is not None and (c.key("times", ahead=1) or (c.mark("x", ahead=1) and not c.kind("stitch", 2))):
        c.at += 2
        c.skip_key("total")
        return checked(token.value, token)
    if c.key("twice", "once"):
        c.at += 1
        return (2 if token.value == "twice" else 1), token.span
    return False


def checked(number: int, token: Token) -> Times:
    """A number of repeats, which is at least one."""
    if number == 0:
        raise NotUnderstood(token, "a repeat is worked at least once", "leave the brackets out instead")
    return number, token.span

"""Printed patterns, stated counts: ``[18]``, ``(18 sts total)``, ``= 18``, ``- 18 sts``, and ``18 sc.`` as a sentence."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tambour.crochet.language.tree import Action, Item
from tambour.crochet.printed.brackets import OPEN, closing
from tambour.crochet.printed.tokens import Token

if TYPE_CHECKING:
    from tambour.crochet.printed.body import Reader


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

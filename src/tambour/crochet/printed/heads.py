"""Printed patterns, the beginnings of rounds: ``Rnd 7-12:``, ``R7–12``, ``2nd rnd:``, ``Round 3.``, ``3.``, ``Row 3 (RS):``."""

from __future__ import annotations

from dataclasses import dataclass

from tambour.core.errors import Span
from tambour.crochet.printed.cursor import OPEN, Cursor
from tambour.crochet.printed.tokens import Token

_BEFORE = frozenset((".", ",", ")", "]", "}", ";", ":"))
_BEFORE = frozenset((".", ",", ")", "]", "}", ";", ":"))
_AFTER = frozenset((":", ".", ")", "-", "=", ",", "]", "|", "–"))


@dataclass(frozen=True)
class Head:
    """The beginning of a round.

    numbers : those of its rounds, none for "next round"; span : their place
    end : the first token after it; row : it says row; strong : it names a round, and is no bare number
    extra : tokens of a remark in it, such as a colour; stated : a count in it
    """

    numbers: tuple[int, ...]
    span: Span
    end: int
    row: bool
    strong: bool
    extra: tuple[Token, ...] = ()
    parted: bool = False


def head(tokens: list[Token], at: int = 0) -> Head | None:
    """The head that begins at token ``at``, None when none does."""
    c = Cursor(tokens, at)
    if c.mark("(", "[") and c.whole(1) is not None:
        c.at += 1
    first = c.look()
    if first is None:
        return None
    row = strong = False
    numbers: list[int] = []
    if c.key("round", "row"):
        row, strong = c.key("row"), True
        c.at += 1
        if c.mark(".", "#") and c.whole(1) is not None:
            c.at += 1
        if not _numbers(c, numbers):
            return None
    elif c.key("next", "last") and c.key("round", "row", ahead=1):
        row, strong = c.key("row", ahead=1), True
        c.at += 2
    elif (first.kind == "ordinal" or (first.kind == "number" and c.mark(".", ahead=1))) and _ordinals(c, numbers):
        row, strong = c.key("row", ahead=-1), True
    elif isinstance(first.value, int) and first.kind == "number":
        if not _numbers(c, numbers):
            return None
        if not c.mark(":", ".", ")", "|") or (c.mark(".") and c.look(1) is not None and c.look(1).glued):  # type: ignore[union-attr]
            return None
    else:
        return None
    if any(n > 100_000 for n in numbers):
        return None
    span = Span(first.start, tokens[c.at - 1].end)
    extra: tuple[Token, ...] = ()
    # "Rnd 3 (Yellow):", "Row 2 (WS) -"
    if c.mark(*OPEN):
        end = next((k for k in range(c.at, min(c.at + 12, len(tokens))) if tokens[k].word in (")", "]", "}")), None)
        if end is not None and end + 1 < len(tokens) and tokens[end + 1].word in (":", "-", ".", "="):
            extra = tuple(tokens[c.at + 1 : end])
            c.at = end + 1
    parted = False
    while c.look() is not None and c.look().kind == "mark" and c.look().word in _AFTER:  # type: ignore[union-attr]
        if c.mark("-", "=") and parted and c.whole(1) is not None and c.look(2) is None:
            break
        c.at += 1
        parted = True
    if c.key("round", "row") and parted and numbers:
        c.at += 1
    return Head(tuple(numbers), span, c.at, row, strong, extra, parted)


def _numbers(c: Cursor, numbers: list[int]) -> bool:
    """``7-12``, ``3 to 5``, ``4, 6 and 8``, ``R5) to R8)``."""
    first = c.whole()
    if first is None:
        return False
    numbers.append(first)
    c.at += 1
    while True:
        ahead = int(c.mark(")"))
        sign = c.look(ahead)
        ranged = c.mark("-", "~", ahead=ahead) or c.key("to", ahead=ahead)
        ranged = ranged or (sign is not None and sign.word in ("through", "thru"))
        if ranged and c.key("to", "round", "row", ahead=ahead + 1):
            ahead += 1
        listed = not ranged and (c.mark(",", "&", "+", "/", ahead=ahead) or c.key("and", ahead=ahead))
        if not ranged and not listed:
            return True
        ahead += 1
        if c.key("and", ahead=ahead):
            ahead += 1
        named = c.key("round", "row", ahead=ahead)
        ahead += named
        last = c.whole(ahead)
        after = c.look(ahead + 1)
        if last is None or (listed and not named and after is not None and after.kind in ("stitch", "number")):
            return True
        if ranged and not named and last <= numbers[-1]:
            return True  # "R7 - 6 sc": a dash, then the body
        if ranged and after is not None and after.kind == "stitch" and c.mark("-") and not c.look().glued:  # type: ignore[union-attr]
            return True
        if ranged and last > numbers[-1]:
            numbers.extend(range(numbers[-1] + 1, min(last, numbers[-1] + 10_000) + 1))
        else:
            numbers.append(last)
        c.at += ahead + 1


def _ordinals(c: Cursor, numbers: list[int]) -> bool:
    """``2nd rnd``, ``5th to 8th rnds``, ``3. Rd``."""
    found: list[int] = []
    at = c.at
    while True:
        token = c.look(at - c.at)
        if token is None or token.kind not in ("ordinal", "number") or not isinstance(token.value, int):
            return False
        found.append(token.value)
        at += 1
        while at < len(c.tokens) and c.tokens[at].word == "." and c.tokens[at].glued:
            at += 1
        ahead = at - c.at
        if c.key("round", "row", ahead=ahead):
            break
        if not (c.mark("-", ",", "&", ahead=ahead) or c.key("to", "and", ahead=ahead)):
            return False
        ranged = c.mark("-", ahead=ahead) or c.key("to", ahead=ahead)
        at += 1
        if ranged:
            found.append(-1)
    c.at = at + 1
    for k, n in enumerate(found):
        if n == -1:
            numbers.extend(range(found[k - 1] + 1, min(found[k + 1], found[k - 1] + 10_000)))
        else:
            numbers.append(n)
    return True


def heads(tokens: list[Token]) -> list[tuple[int, Head]]:
    """The heads of a line, in order: the one that it begins with, and, when it begins with one that names a round, those
    of later sentences (a pattern whose line ends were lost)."""
    found: list[tuple[int, Head]] = []
    first = head(tokens)
    if first is not None:
        found.append((0, first))
    at = first.end if first is not None else 1
    while at < len(tokens):
        if tokens[at].kind == "key" and tokens[at].value in ("round", "row") and tokens[at - 1].word in _BEFORE:
            later = head(tokens, at)
            if later is not None and later.numbers and tokens[later.end - 1].word == ":":
                found.append((at, later))
                at = later.end
                continue
        at += 1
    return found

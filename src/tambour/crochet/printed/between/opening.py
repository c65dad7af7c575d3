"""Printed patterns, openings: where a piece of work begins, with its name before it or with a chain or a ring alone."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from typing import Final

from tambour.core.errors import Span
from tambour.core.rgb import RGB
from tambour.crochet.printed.cursor import Cursor
from tambour.crochet.printed.sheet.notes import Heading, copies_in, plain_name
from tambour.crochet.printed.state import State
from tambour.crochet.printed.tokens import Token

_NEAR: Final = 4  # lines between what a piece begins with and its first round
_LONGEST: Final = 14  # words of a sentence that begins a piece
_BY_THE_WAY: Final = frozenset(
    "larger smaller large small mm size g h i j e f us strand strands held together double doubled one two each and both slip knot slipknot "
    "foundation chain leaving long tail inch inches cm yarn yarns main start starting referring chart table materials section shown at top right side "
    "plus turning loosely twist twisted twisting careful taking care being placing marker circle make for facing edge lower bottom upper left column of multiple colour color crochet hook".split()
)
"""Words that a sentence which chains may hold beside its yarn, and that change nothing of what it makes."""
_ASKS: Final = frozenset(("strand", "strands", "of", "in", "using"))
_SHORTEST: Final = 2  # chains that a piece begins with
_CAST: Final = 5  # words of a sentence that only chains
_WORDS: Final = 6  # of a part's name


def founding(tokens: list[Token]) -> bool:
    """Whether a sentence begins a piece: "With A, ch 9", "Beginning at tip, with 2 strands of B, ch 2"."""
    if not tokens:
        return False
    c = Cursor(tokens)
    first = tokens[0]
    if first.kind == "number" and len(tokens) > 1 and tokens[1].value == "ch":  # "5 Lm anschlagen"
        return all(t.kind == "word" or t.word == "." for t in tokens[2:]) and len(tokens) <= _CAST
    if first.value != "ch" and not (
        first.kind == "key" and first.value in ("with", "begin", "over", "make", "ring", "leave", "form")
    ):
        return False
    if any(t.kind == "key" and t.value in ("not", "count", "round", "row") for t in tokens):
        return False
    if any(t.kind == "key" and t.value == "ring" and t.word not in ("mc", "mr") for t in tokens):
        return len(tokens) <= _LONGEST
    chained = any(
        t.kind == "stitch" and t.value == "ch" and (c.whole(k + 1) is not None or c.whole(k - 1) is not None)
        for k, t in enumerate(tokens)
        if k
    ) or (first.value == "ch" and c.whole(1) is not None)
    return chained and not any(t.kind == "stitch" and t.value not in ("ch", "slst") for t in tokens)


def as_chain(p: State, tokens: list[Token]) -> list[Token]:
    """A sentence that chains ("With A and larger hook, ch 21 (multiple of 4 + 1)") as "With A, ch 21", and joined where it says so; as it is
    where it says no such thing."""
    at = next((k for k, t in enumerate(tokens) if t.kind == "stitch"), len(tokens))
    c = Cursor(tokens)
    if 0 < at < len(tokens) and tokens[at].value == "ch" and c.whole(at - 1) is not None and c.whole(at + 1) is None:
        many, ch = tokens[at - 1], tokens[at]  # "starting with 7 ch"
        swapped = [replace(ch, start=many.start, end=many.end), replace(many, start=ch.start, end=ch.end)]
        tokens = [*tokens[: at - 1], *swapped, *tokens[at + 1 :]]
        c, at = Cursor(tokens), at - 1
    number = c.whole(at + 1) if at < len(tokens) and tokens[at].value == "ch" else None
    if not number or number < _SHORTEST or any(t.value in ("not", "count", "round", "row") for t in tokens[:at]):
        return tokens
    hue = next(((k, found[1]) for k in range(at) if (found := _hue(p, c, k)) is not None), None)
    dyed = range(hue[0], sum(hue)) if hue is not None else range(0)
    where = {*_where_begun(tokens, at)}
    where |= {0} if p.heading is not None and at > 1 and tokens[1].word == "," else set()  # "Sole, in brown, ch 7"
    if any(
        t.kind == "word" and k not in dyed and k not in where and t.word not in _BY_THE_WAY
        for k, t in enumerate(tokens[:at])
    ):
        return tokens  # a yarn that is not known, or another thing that is done
    chain, rest = [tokens[at], tokens[at + 1]], tokens[at + 2 :]
    if any(t.kind == "stitch" and t.value not in ("slst", "ch") for t in rest):
        return tokens
    plus = rest[1:3] if rest and rest[0].word == "," else rest[:2]
    more = plus[1] if len(plus) > 1 and plus[0].word in ("plus", "+") and isinstance(plus[1].value, int) else None
    opened = next((k for k, t in enumerate(rest) if t.word in ("(", "[")), len(rest))
    if any(t.kind == "word" and t.word not in _BY_THE_WAY for t in rest[:opened]):
        return tokens
    if more is not None:
        chain[1] = replace(chain[1], value=number + more.value)
    led = [Token("key", "with", tokens[0].start, tokens[0].end, "with")]
    led = [] if hue is None else [*led, *tokens[hue[0] : hue[0] + hue[1]]]
    end = tokens[-1]
    joined = (
        [Token("key", "join", end.start, end.end, "join")] if any(t.value in ("slst", "join") for t in rest) else []
    )
    return [*led, *chain, *joined]


def _where_begun(tokens: list[Token], at: int) -> range:
    """The words before ``at`` that say where a piece begins: "starting at the toe", up to their comma; an empty range where none do."""
    begin = next((k for k in range(at - 1) if tokens[k].value == "begin" and tokens[k + 1].word in ("at", "from")), at)
    end = next((k for k in range(begin, at) if tokens[k].word == ","), at)
    return range(begin, end) if end < at else range(0)


def _hue(p: State, c: Cursor, k: int) -> tuple[RGB, int] | None:
    """The yarn that is named at ``k``, by its letter behind what asks for one: "With B held together", "With 2 strands of A"."""
    asked = k > 0 and (c.tokens[k - 1].value in ("with", "color", "yarn", "and") or c.tokens[k - 1].word in _ASKS)
    lettered = p.palette.letter(c, k) if asked and len(c.tokens[k].word) <= 2 else None
    return p.palette.color(c, k) or lettered


def founds(p: State, at: int | None = None, near: int = _NEAR) -> bool:
    """Whether rounds begin at 1 in one of the ``near`` next lines, from the one that is read or from line ``at``."""
    seen = 0
    begin = p.row_at if at is None else at
    for row in p.rows[begin : begin + 12]:
        if row.tokens:
            first = p.firsts.get(row.start)  # lines are looked at more than once
            if first is None:
                found = p.vocabulary.heads(row.tokens)
                first = p.firsts[row.start] = any(head.numbers[:1] == (1,) for _, head in found)
            if first:
                return True
            seen += 1
            if seen > near:
                break
    return False


def opening(text: str, tokens: list[Token]) -> tuple[Heading, int] | None:
    """The name of a part that a sentence begins with, and where what founds it stands: "Antennae (make 2) With B, ch 6"."""
    at = 0
    while at < len(tokens) and at <= _WORDS and _names(tokens[at]) and tokens[at].word != "see":
        at += 1
    if (
        not at
        or at == len(tokens)
        or (tokens[0].value == "in" and tokens[0].word != "inside")  # "In Vanilla, ch 10"
        or tokens[0].kind not in ("word", "ordinal", "key")
        or (not tokens[0].capital and tokens[0].kind != "ordinal" and tokens[at].word != ":")
    ):
        return None
    name = plain_name(text[tokens[0].start : tokens[at - 1].end])
    copies, place = 1, None
    if tokens[at].word in ("(", "["):
        end = next((k for k in range(at, len(tokens)) if tokens[k].word in (")", "]")), len(tokens) - 1)
        found = copies_in(tokens[at : end + 1])
        if found is not None:
            copies, place = found
        at = end + 1
    while at < len(tokens) and tokens[at].word in (":", ".", "-", ","):
        at += 1
    rest = tokens[at:]
    if (
        not name
        or (rest and rest[0].value in ("ring", "form", "leave"))
        or not (
            founding(rest)
            or _at_once(rest, place is not None or name.isupper())
            or (rest and rest[0].word == "see" and (place is not None or name.isupper()))
        )
    ):
        return None
    return Heading(name, Span(tokens[0].start, tokens[at - 1].end), copies, place, True, True), at


def alone(tokens: list[Token]) -> bool:
    """Whether words before a first round are no more than the name of a part: "… Fasten off. Left Wing Edging 1st rnd: …"."""
    return 0 < len(tokens) <= _WORDS and all(
        (t.capital and t.kind == "word") or t.kind == "ordinal" or (k and t.word in ("of", "for", "and", "&", "-"))
        for k, t in enumerate(tokens)
    )


def _at_once(tokens: list[Token], named: bool) -> bool:
    """Whether a piece begins with its chain and is worked in the same sentence: "With B, ch 5, sl st in 2nd ch from hook, sc in next ch"."""
    first = tokens[0] if tokens else None
    if not named or first is None or not (first.value in ("ch", "with") and any(t.value == "hook" for t in tokens)):
        return False
    return any(t.value == "ch" and isinstance(u.value, int) for t, u in pairwise(tokens[:7]))


def _names(token: Token) -> bool:
    """Whether a token may stand in the name of a part."""
    if token.kind == "key":
        return (
            token.value in ("and", "eyes", "side", "other", "last", "face", "assembly", "make", "in")
            and token.value != "make"
        )
    return token.kind in ("word", "ordinal", "number") or token.word in ("/", "&", "-", "#", "'")

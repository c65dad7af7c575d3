"""Printed patterns, numerals: single crochets that are said by their number alone, as kits' cards have them: ``R1: 6 (6)``, ``R6-12: 30``, ``R4: 1,V,2 =5``;
put with the stitch they are of."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Final

from tambour.crochet.printed.tokens import Row, Token

_ROUND: Final = re.compile(r"(?:r|rd|rnd|round|row|v|t)?\d+")
_NUMBERED: Final = re.compile(r"(?:r|rd|rnd|round|row)\d+")
_CALLED: Final = frozenset("r rd rnd round rounds rnds row rows".split())
_SHAPED: Final = frozenset(("v", "w", "a", "m", "inc", "dec", "incs", "decs"))
_STOPS: Final = frozenset((",", ")", "]", "·", "•", ".", ";", "|"))
_OPENS: Final = frozenset(("(", "["))
_PAIR: Final = re.compile(
    r"[(\[] (\d+) (incs?|decs?) [)\]] (?:(?:x|\*|×) ?)?(\d+)(?: times| x)? (?:[(\[]|=) (\d+)(?: (?:sts?|sc))?(?: [)\]])?(?: [.,].*)?"
)
_HEAD: Final = 4  # tokens of a head that ends in a point: "R16-18."
_ALONG: Final = frozenset(("around", "along"))
_TO: Final = frozenset(("-", "–", "+", "&", "to", "and"))


def numerals(rows: list[Row], stitch: str, ring: str) -> list[Row]:
    """``rows`` in which lone numbers are so many of ``stitch``; a lone number that a first round has is worked into a ``ring``."""
    rows = [_parted(row) for row in rows]
    made = [replace(row, tokens=_put(row.tokens, stitch, ring)) if _heads(row.tokens) else row for row in rows]
    made = [replace(row, tokens=_put_noted(row.tokens, stitch)) if noted(row.tokens) else row for row in made]
    return _between(made, stitch)


def _parted(row: Row) -> Row:
    """``row`` with a colon between the number of its round and the first of its stitches: "R4  1, INC, 2, INC (5)"."""
    tokens = row.tokens
    at = 1 if tokens and _NUMBERED.fullmatch(tokens[0].word) else 2
    if len(tokens) < at + 4 or (at == 2 and (tokens[0].word not in _CALLED or tokens[1].kind != "number")):
        return row
    first = tokens[at]
    if (
        first.kind != "number"
        or first.glued
        or tokens[at + 1].word != ","
        or _SHAPED.isdisjoint([t.word for t in tokens])
    ):
        return row
    colon = Token("mark", ":", tokens[at - 1].end, tokens[at - 1].end, None, True)
    return replace(row, tokens=[*tokens[:at], colon, *tokens[at:]])


def _between(rows: list[Row], stitch: str) -> list[Row]:
    """Puts "(2 dec)x6 (18)" as "(2 sc, dec)x6 (18)", in a text whose counts come out so, and in no row only as so many decreases."""
    found: dict[int, tuple[int, bool, bool]] = {}
    for k, row in enumerate(rows):
        at = next((n for n, t in enumerate(row.tokens) if t.word in _OPENS), None)
        said = None if at is None else _PAIR.fullmatch(" ".join(t.word for t in row.tokens[at:]))
        if at is not None and said is not None:
            each, times, count = int(said[1]), int(said[3]), int(said[4])
            grown = said[2].startswith("inc")
            made = times * (each + (2 if grown else 1)) == count, times * each * (2 if grown else 1) == count
            found[k] = (at + 2, *made)
    kinds = list(found.values())
    if not any(apart and not alike for _, apart, alike in kinds) or any(
        alike and not apart for _, apart, alike in kinds
    ):
        return rows
    made_ = list(rows)
    for k, (at, apart, _) in found.items():
        if apart:
            tokens, end = rows[k].tokens, rows[k].tokens[at - 1].end
            worked = [Token("word", stitch, end, end, None, True), Token("mark", ",", end, end)]
            made_[k] = replace(rows[k], tokens=[*tokens[:at], *worked, *tokens[at:]])
    return made_


def noted(tokens: list[Token]) -> bool:
    """Whether a line is a round's head and a number, "r4 18", "rnd 6-7 24", and nothing else: a note of one's own, so many plain stitches."""
    if len(tokens) < 2 or tokens[-1].kind != "number":
        return False
    named, rest = tokens[0].word in _CALLED, tokens[1:-1] if tokens[0].word in _CALLED else tokens[:-1]
    first = rest[0].word if rest else ""
    heads = first.isdigit() if named else _NUMBERED.fullmatch(first) is not None
    more = rest[1:]
    return heads and (not more or (len(more) == 2 and more[0].word in _TO and more[1].kind == "number"))


def _put_noted(tokens: list[Token], stitch: str) -> list[Token]:
    last = tokens[-1]
    return [
        *tokens[:-1],
        Token("mark", ":", last.start, last.start),
        last,
        Token("word", stitch, last.end, last.end, None, True),
    ]


def _heads(tokens: list[Token]) -> list[int]:
    """Where rounds begin to say what they work: behind the colons that stand behind their numbers."""
    named = bool(tokens) and (tokens[0].word in _CALLED or _NUMBERED.fullmatch(tokens[0].word) is not None)
    return [
        k + 1
        for k, t in enumerate(tokens)
        if (
            t.word == ":"
            or (t.word == "." and named and k <= _HEAD and not (tokens[k + 1 : k + 2] and tokens[k + 1].glued))
        )
        and k + 1 < len(tokens)
        and _numbered(tokens, k)
    ]


def _numbered(tokens: list[Token], end: int) -> bool:
    """Whether the number of a round, or the numbers, end there: "R6-12", "Rnd 4", a number that begins the line."""
    k = end - 1
    while k > 0 and (tokens[k].kind == "number" or tokens[k].word in ("-", ",", "&", ".")):
        k -= 1
    if k < 0 or end == k:
        return False
    return (
        tokens[k].kind == "number"
        or _NUMBERED.fullmatch(tokens[k].word) is not None
        or (k < end - 1 and tokens[k].word in _CALLED)
    )


def _put(tokens: list[Token], stitch: str, ring: str) -> list[Token]:
    begins = _heads(tokens)
    made = tokens[: begins[0]]
    for begin, after in zip(begins, [*begins[1:], None], strict=True):
        said = tokens[begin:after]
        shaped = any(t.word in _SHAPED for t in said)
        for k, token in enumerate(said):
            if k and said[k - 1].word == "=" and token.kind == "number" and after is not None and _ends(said, k + 1):
                signs = [Token("mark", sign, token.start, token.end, None, sign == ")") for sign in "()"]
                made[-1:] = [signs[0], token, signs[1]]  # "=18 · R4: …"
                continue
            made.append(token)
            if not (token.kind == "number" and isinstance(token.value, int) and _lone(said, k, after is not None)):
                continue
            along = k + 1 < len(said) and said[k + 1].word in _ALONG
            if k and not shaped and not along:
                continue  # of a list without a shaping nothing says what it counts
            made.append(Token("word", stitch, token.end, token.end, None, True))
            if k == 0 and _first(tokens[begin - 2].word) and not shaped and _whole(said, after is not None):
                made += [Token("word", w, token.end, token.end) for w in ("in", *ring.lower().split())]
    return made


def _ends(said: list[Token], at: int) -> bool:
    """Whether nothing stands there but a sign and the head of the next round."""
    rest = said[at:]
    return len([t for t in rest if t.kind != "mark"]) <= 2 and all(
        t.kind == "mark" or _ROUND.fullmatch(t.word) or t.word.isalpha() for t in rest
    )


def _first(number: str) -> bool:
    return re.sub(r"\D", "", number) == "1"


def _whole(said: list[Token], followed: bool) -> bool:
    """Whether a round is its number alone, and its count."""
    rest = [t for t in said[1:] if t.word not in ("(", ")", "[", "]", "=", "·", "•", ".", "|")]
    return len(rest) - (1 if followed else 0) <= 1 and all(t.kind == "number" or _ROUND.fullmatch(t.word) for t in rest)


def _lone(said: list[Token], k: int, followed: bool) -> bool:
    """Whether nothing says what the number at ``k`` is of: it is no count, and repeats nothing."""
    before = said[k - 1] if k else None
    after = said[k + 1] if k + 1 < len(said) else None
    along = after is not None and after.word in _ALONG
    if before is not None and before.word not in (",", *_OPENS) and not (along and before.word == ":"):
        return False
    if before is not None and before.word in _OPENS and (after is None or after.word in (")", "]")):
        return False  # a count
    if after is None or after.word in _STOPS or after.word == "=" or after.word in _ALONG:
        return True
    if after.word in _OPENS:
        return k + 3 < len(said) and said[k + 2].kind == "number" and said[k + 3].word in (")", "]")
    return followed and k + 2 == len(said) and _ROUND.fullmatch(after.word) is not None and not after.word.isdigit()

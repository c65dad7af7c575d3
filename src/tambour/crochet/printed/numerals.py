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


def numerals(rows: list[Row], stitch: str, ring: str) -> list[Row]:
    """``rows`` in which lone numbers are so many of ``stitch``; a lone number that a first round has is worked into a ``ring``."""
    return [replace(row, tokens=_put(row.tokens, stitch, ring)) if _heads(row.tokens) else row for row in rows]


def _heads(tokens: list[Token]) -> list[int]:
    """Where rounds begin to say what they work: behind the colons that stand behind their numbers."""
    return [k + 1 for k, t in enumerate(tokens) if t.word == ":" and k + 1 < len(tokens) and _numbered(tokens, k)]


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
            if k and not shaped:
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
    if before is not None and before.word not in (",", *_OPENS):
        return False
    if before is not None and before.word in _OPENS and (after is None or after.word in (")", "]")):
        return False  # a count
    if after is None or after.word in _STOPS or after.word == "=":
        return True
    if after.word in _OPENS:
        return k + 3 < len(said) and said[k + 2].kind == "number" and said[k + 3].word in (")", "]")
    return followed and k + 2 == len(said) and _ROUND.fullmatch(after.word) is not None and not after.word.isdigit()

"""Printed patterns, postposed: words that other languages put behind what English puts them before: "dans la m. suiv.", "4 fois 2 m. ens.", "rép. 1 fois de * à *"."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from typing import Final

from tambour.crochet.printed.tokens import Token

_PLACES: Final = ("stitch", "ch")
_LOOPS: Final = ("back loops", "front loops", "both loops")
_LEADS: Final = (",", ":", "(", "[", "*", ".", ";")
_ENDS: Final = (",", ".", ";", ":", "=", ")", "]")
_TURN: Final = "keer"  # behind a number it says how often
_OF: Final = frozenset(("de", "des", "du", "d", "van", "von", "mit", "con", "met", "aus"))


def put_before(tokens: list[Token]) -> list[Token]:
    """Words as read, in the order in which English has them."""
    tokens = _summed(tokens) if len(tokens) <= _SUM else tokens
    made: list[Token] = []
    at = 0
    while at < len(tokens):
        token = tokens[at]
        after = tokens[at + 1] if at + 1 < len(tokens) else None
        if after is not None and after.value == "next" and _place(token) and _ends(tokens, at + 2):
            where = _before(made)
            if where is not None:
                made[where:where] = [after]
                made.append(token)
                at += 2
                continue
        if token.value == "ch" and token.kind == "stitch" and (past := _chained(tokens, at)):
            at = past  # "une chaînette de 7 m. l."
            continue
        if token.kind == "stitch" and (row := _along(tokens, at)) is not None:
            said, at = row
            made += said
            continue
        if token.word in _BACK and (row := _back(tokens, at, made)) is not None:
            said, at = row
            made += said
            continue
        if token.word == "end" and after is not None and after.value == "ch" and made and made[-1].value == "in":
            made += _key(token, "last")
            at += 1
            continue
        if (
            token.value == "around"
            and after is not None
            and after.value == "ch"
            and _founded(made)
            and _stops(tokens, at + 2)
        ):
            made = made[:-1] if made[-1].word == "," else made  # "chain 5, work around the chain."
            at += 2
            continue
        if token.value == "from" and token.word in _OF and made and made[-1].value in _LOOPS and _reached(after):
            at += 1  # "dans le brin arrière de chaque m."
            continue
        if token.value == "times" and token.word == _TURN and not (made and made[-1].kind == "number"):
            made.append(Token("key", token.word, token.start, token.end, "turn", token.glued, token.capital))
            at += 1
            continue
        if (
            after is not None
            and token.value == "each"
            and after.value == "next"
            and at + 2 < len(tokens)
            and tokens[at + 2].value == "ch"
        ):
            made.append(token)
            at += 2  # "in elke volgende l"
            continue
        if (
            token.value == "times"
            and made
            and made[-1].kind == "number"
            and _led(made)
            and (end := _clause(tokens, at + 1))
        ):
            number = made.pop()  # "4 fois 2 m. s. ens."
            opens, closes = (Token("mark", w, token.start, token.start) for w in "()")
            made += [opens, *put_before(tokens[at + 1 : end]), closes, number, token]
            at = end
            continue
        if token.value == "repeat" and (moved := _counted(tokens, at)) is not None:
            made += moved
            at += len(moved)
            continue
        if token.word == "(" and (end := _equal(tokens, at)):
            opens, sign = token, tokens[at + 1]
            count = Token("key", "counts", sign.start, sign.end, "count")
            made += [opens, count, Token("key", "as", sign.end, sign.end, "as"), *tokens[at + 2 : end]]
            at = end
            continue
        made.append(token)
        at += 1
    return made


def _summed(tokens: list[Token]) -> list[Token]:
    """``ch 8 + 1`` and ``8 Lm + 1 Wendeluftmasche``, sentences that say no more, with the sum of their numbers."""
    plus = next((k for k in range(2, len(tokens)) if tokens[k].word == "+"), 0)
    numbers = [k for k, t in enumerate(tokens) if t.kind == "number" and isinstance(t.value, int)]
    said = not plus or len(numbers) != _TWO or not numbers[0] < plus < numbers[1] or numbers[0] > plus - 1
    if (
        said
        or not any(t.value == "ch" for t in tokens[:plus])
        or any(t.kind == "stitch" and t.value != "ch" for t in tokens)
    ):
        return tokens
    one, other = (tokens[k] for k in numbers)
    if other.value > _TURNING or plus > 3 or len(tokens) > plus + 4:
        return tokens
    return [replace(t, value=one.value + other.value) if t is one else t for t in tokens[:plus]]


_TWO: Final = 2
_SUM: Final = 8  # words of a sentence that only chains
_TURNING: Final = 4  # chains that turn a row, at most


def _place(token: Token) -> bool:
    return (token.kind == "key" and token.value == "stitch") or (token.kind == "stitch" and "tog" not in token.word)


def _chained(tokens: list[Token], at: int) -> int:
    """Where the number stands of a chain of so many chains; 0 where none is said."""
    k = at + 1
    k += k < len(tokens) and (tokens[k].value == "from" or tokens[k].word in _OF or tokens[k].word == "of")
    of = k > at + 1
    if k + 1 < len(tokens) and tokens[k].kind == "number" and tokens[k + 1].value in _PLACES and of:
        return k if not (at and made_number(tokens[at - 1])) else 0
    return 0


def made_number(token: Token) -> bool:
    """Whether a number stands there: "3 ch, 5 ch" are two chains."""
    return token.kind in ("number", "ordinal")


_BACK: Final = frozenset("return returning back".split())
SAYING: Final = frozenset(("next", "ch", "times", "repeat")) | _BACK | _OF
"""Words of which a line has one where its order may be another."""
_LONGEST: Final = 20  # words of a sentence about a chain


def _founded(made: list[Token]) -> bool:
    """Whether all that was said is a chain: "Chain 5 sts,"."""
    said = [t for t in made if t.word != ","]
    return 1 < len(said) <= 3 and any(t.value == "ch" for t in said) and any(t.kind == "number" for t in said)


def _stops(tokens: list[Token], at: int) -> bool:
    return at >= len(tokens) or tokens[at].word in (".", ":")


def _key(at: Token, *words: str) -> list[Token]:
    return [Token("key", w, at.start, at.end, w) for w in words]


def _along(tokens: list[Token], at: int) -> tuple[list[Token], int] | None:
    """``2 sc in each ch from 2nd ch`` with the chain that it begins in first; and where those words end."""
    said = [t.value for t in tokens[at + 1 : at + 5]]
    if said[:4] != ["in", "each", "ch", "from"] or len(tokens) < at + 7:
        return None
    nth, chain = tokens[at + 5 : at + 7]
    if nth.kind != "ordinal" or chain.value != "ch":
        return None
    end = at + 7
    if [t.value for t in tokens[end : end + 2]] == ["from", "hook"]:
        end += 2
    many = [tokens[at - 1]] if at and tokens[at - 1].kind == "number" else []
    stitch = tokens[at]
    comma = Token("mark", ",", chain.end, chain.end)
    first = [stitch, *_key(nth, "in"), nth, chain, *_key(chain, "from", "hook")]
    return [*first, comma, *many, stitch, *_key(chain, "in", "each"), chain], end


def _back(tokens: list[Token], at: int, made: list[Token]) -> tuple[list[Token], int] | None:
    """``ch 19, return with 18 sc`` as "begin in 2nd ch from hook, 18 sc"; and where the number stands."""
    k = at + 1
    while k < len(tokens) and (tokens[k].value in ("with", "in", "for") or tokens[k].word in ("by", "along", "back")):
        k += 1
    if k + 1 >= len(tokens) or tokens[k].kind != "number" or tokens[k + 1].kind != "stitch":
        return None
    chains = [
        n.value
        for one, n in pairwise(made[-_LONGEST:])
        for one, n in ((one, n), (n, one))
        if one.value == "ch" and one.kind == "stitch" and n.kind == "number"
    ]
    nth = chains[-1] - tokens[k].value + 1 if chains and isinstance(chains[-1], int) else 0
    if not 2 <= nth <= 4 or any(t.kind == "stitch" and t.value != "ch" for t in made):
        return None
    token = tokens[at]
    ordinal = Token("ordinal", str(nth), token.start, token.end, nth)
    chain = Token("stitch", "ch", token.start, token.end, "ch")
    comma = Token("mark", ",", token.end, token.end)
    return [*_key(token, "begin", "in"), ordinal, chain, *_key(token, "from", "hook"), comma], k


def _ends(tokens: list[Token], at: int) -> bool:
    """Whether nothing stands at ``at`` that "next" would belong to."""
    return at >= len(tokens) or not (tokens[at].value in ("round", "row", "stitch") or tokens[at].kind == "number")


def _before(made: list[Token]) -> int | None:
    """Where "next" goes: before a number of stitches; None where no place is said."""
    if not made:
        return None
    if made[-1].kind == "number":
        return len(made) - 1 if len(made) > 1 and made[-2].value in ("in", "each") else None
    return len(made) if made[-1].value in ("in", "each") else None


def _reached(after: Token | None) -> bool:
    return after is not None and (after.value in ("each", "next", "stitch") or after.kind == "number")


def _clause(tokens: list[Token], at: int) -> int:
    """Where the clause at ``at`` ends that works stitches; 0 for another."""
    end = next((k for k in range(at, len(tokens)) if tokens[k].word in (*_ENDS, "(", "[", "*")), len(tokens))
    return end if any(t.kind == "stitch" and t.value != "ch" for t in tokens[at : min(at + 2, end)]) else 0


def _led(made: list[Token]) -> bool:
    return len(made) == 1 or made[-2].word in _LEADS


def _counted(tokens: list[Token], at: int) -> list[Token] | None:
    """``repeat 3 times from * to *`` with the number at its end."""
    said = tokens[at : at + 7]
    if len(said) < 5 or said[1].kind != "number" or said[2].value != "times" or said[3].value != "from":
        return None
    end = 7 if len(said) > 6 and said[5].value == "to" and said[6].word == said[4].word else 5
    return [said[0], *said[3:end], said[1], said[2]] if said[4].word.startswith("*") else None


def _equal(tokens: list[Token], at: int) -> int:
    """Where a bracket closes that says what chains stand for, "3 m. l. (= 1re B.)"; 0 where none does."""
    said = tokens[at : at + 5]
    chained = at > 1 and tokens[at - 1].value == "ch" and tokens[at - 2].kind == "number"
    if not chained or len(said) < 4 or said[1].word != "=" or said[-1].word != ")":
        return 0
    return at + 4 if said[2].kind in ("ordinal", "number") and said[3].kind == "stitch" and len(said) == 5 else 0

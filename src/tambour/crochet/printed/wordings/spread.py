"""Printed patterns, spread: rounds that say which stitch of how many is increased or decreased: "inc every 3rd st", "jede 3. und 4. M zus."."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Final

from tambour.crochet.printed.tokens import Token

_BOTH: Final = frozenset(
    "zus zusammenhäkeln zusammen abmaschen ens ensemble sh samen samenhaken juntos juntas together tog".split()
)
"""Words behind stitches that are worked as one: the number before these is how many."""
_COUNTED: Final = frozenset(("ttes les", "toutes les", "tous les", "cada", "every"))
"""Words before a number of stitches of which one is meant, "cada 3 puntos"; "all 3 sts" are each of them."""
_COUNTED_REPEAT: Final = re.compile(r"[)\]*] (?:[x*×] )?(\d+)(?: times)?,?(?: [-=:])? [(\[]? ?(\d+)\b")
_KINDS: Final = ("hdc", "dc", "tr", "")


def spread(tokens: list[Token]) -> list[Token]:
    """Words as read, with "inc every 3rd st" as "*2 sc, inc* repeat around", and "2 M zus" as one decrease."""
    made = _placed(_together(tokens))
    at = 0
    while at < len(made):
        found = _every(made, at) or _all(made, at)
        if found is not None:
            length, words = found
            made[at : at + length] = words
            at += len(words)
        else:
            at += 1
    return made


def _together(tokens: list[Token]) -> list[Token]:
    """``2 M zus.``, ``2 ms ens.``: as one decrease; ``3 M zus.`` as one of three."""
    made: list[Token] = []
    for k, token in enumerate(tokens):
        words = token.word.split()
        if token.kind == "stitch" and "dec" in str(token.value) and len(words) > 1 and words[-1] in _BOTH:
            before = made[-1] if made else None
            if before is not None and before.kind == "number" and before.value in (2, 3, 4):
                made.pop()
                many = "" if before.value == 2 else str(before.value)
                token = Token("stitch", token.word, before.start, token.end, f"{token.value}{many}", before.glued)
        doubled = token.value in ("inc", "dcinc") and len(words) > 1 and token.glued and made and made[-1].value == 2
        if doubled and not _apart(tokens, k):
            made.pop()  # "2dc inc": two in one stitch
        made.append(token)
    return made


def _apart(tokens: list[Token], at: int) -> bool:
    """Whether the count of a repeat says that "(2sc inc) x 6 (24)" is two stitches and an increase: four each time."""
    said = " ".join(str(t.value) if t.kind == "number" else t.word for t in tokens[at + 1 :])
    told = _COUNTED_REPEAT.match(said)
    return told is not None and 4 * int(told[1]) == int(told[2])


def _all(tokens: list[Token], at: int) -> tuple[int, list[Token]] | None:
    """``jede M verd.``: how many words at ``at`` say that all stitches are increased or decreased, the stitches first, and what they are."""
    if tokens[at].value != "each" or (at and tokens[at - 1].value == "in"):
        return None
    end = at + 1
    end += end < len(tokens) and tokens[end].value == "stitch"
    if end >= len(tokens) or not _shapes(tokens[end]) or (end == at + 1 and " " not in tokens[end].word):
        return None
    stitch = tokens[end]
    return end + 1 - at, [replace(stitch, start=tokens[at].start), *_keys(stitch, "in", "each", "stitch")]


def _placed(tokens: list[Token]) -> list[Token]:
    """``je 9 fM`` as "9 sc", ``je M 1 fM`` as "in each st 1 sc"."""
    made: list[Token] = []
    for k, token in enumerate(tokens):
        after = tokens[k + 1 : k + 3] if token.value == "each" and token.kind == "key" else []
        before = made[-1] if made else None
        begins = before is None or (before.kind == "mark" and before.word in ",:(;*") or before.value == "and"
        if begins and len(after) > 1:
            if after[0].kind == "number" and after[1].kind == "stitch":
                continue
            if after[0].value == "stitch" and after[1].kind == "number":
                made += _keys(replace(token, end=token.start), "in")
        made.append(token)
    return made


def _keys(at: Token, *words: str) -> list[Token]:
    """Words that mean what they say, at the characters of another."""
    return [Token("key", word, at.start, at.end, word) for word in words]


def _every(tokens: list[Token], at: int) -> tuple[int, list[Token]] | None:
    """How many words at ``at`` say that every so-many-th stitch of a round is increased, or two of them decreased, and what they are."""
    end = at
    stitch = None
    if end < len(tokens) and tokens[end].value == 1 and tokens[end].kind == "number":
        end += 1
    if end < len(tokens) and _shapes(tokens[end]):
        stitch = tokens[end]
        end += 1
        end += end < len(tokens) and tokens[end].value == "in"
    elif end > at:
        return None
    elif tokens[end].value == "in":
        end += 1
    if end >= len(tokens) or tokens[end].value != "each":
        return None
    counted = tokens[end].word in _COUNTED
    end += 1
    places: list[int] = []
    while end < len(tokens) and _place(tokens[end], counted) and len(places) < 2:
        places.append(int(tokens[end].value))
        end += 1
        if (
            len(places) == 1
            and end + 1 < len(tokens)
            and tokens[end].value == "and"
            and _place(tokens[end + 1], counted)
        ):
            end += 1
    if not places:
        return None
    if end < len(tokens) and (tokens[end].value in ("stitch", "sc")):
        end += 1
    if stitch is None:
        if end >= len(tokens) or not _shapes(tokens[end]):
            return None
        stitch = tokens[end]
        end += 1
    if end < len(tokens) and tokens[end].value == "around":
        end += 1
    if end < len(tokens) and not (tokens[end].kind == "mark" and tokens[end].word in "([{=.,;:-"):
        return None  # more is said: "every 3rd st 6 times"
    down = "dec" in str(stitch.value)
    if down != (len(places) == 2 and places[1] == places[0] + 1) or (not down and len(places) == 2):
        if not (down and len(places) == 1):
            return None
        places = [places[0] - 1, places[0]]  # "dec every 4th st": of four two are one
    plain = places[0] - 1
    if plain < 1:
        return None
    return end - at, _repeated(tokens[at], tokens[end - 1], plain, stitch)


def _shapes(token: Token) -> bool:
    return token.kind == "stitch" and str(token.value).removeprefix("hdc").removeprefix("dc") in ("inc", "dec")


def _place(token: Token, counted: bool) -> bool:
    return token.kind == "ordinal" or (counted and token.kind == "number" and isinstance(token.value, int))


def _repeated(first: Token, last: Token, plain: int, stitch: Token) -> list[Token]:
    """``*plain sc, stitch* repeat around``, over the characters from ``first`` to ``last``."""
    kind = next(k for k in _KINDS if str(stitch.value).startswith(k)) or "sc"

    def token(what: str, word: str, value: object = None) -> Token:
        return Token(what, word, first.start, last.end, value)

    return [
        token("mark", "("),
        token("number", str(plain), plain),
        token("stitch", kind, kind),
        token("mark", ","),
        token("stitch", str(stitch.value), stitch.value),
        token("mark", ")"),
        token("key", "repeat", "repeat"),
        token("key", "around", "around"),
    ]

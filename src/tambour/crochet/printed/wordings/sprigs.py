"""Printed patterns, sprigs: leaves of chains that the hook goes back along, in the many words for it ("ch 6, sl st back down the chain", "ch 6, skip 1, sl st in next 5"), put chain by chain; and those that grow from a ring, put on its stitches."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

from tambour.crochet.printed.tokens import Token

_BACK: Final = frozenset("back backwards down along returning".split())
SAYING: Final = _BACK | {"skip"}
_STITCHES: Final = ("slst", "sc", "hdc")
_IN: Final = frozenset(
    (
        "in",
        "next",
        "chain",
        "chains",
        "ch",
        "each",
        "hook",
        "from",
        "and",
        "to",
        "of",
        "the",
        "remaining",
        "rem",
        "all",
        "way",
    )
)
_OPEN: Final = ("(", "[", "*")
_CLOSE: Final = (")", "]", "*")
_LEAST: Final = 3
_FURTHEST: Final = 14  # words of what goes back along a chain


def chained(tokens: list[Token]) -> list[Token]:
    """Words as read, with every way back along a chain as "sl st in 2nd ch from hook and in next 4 ch"."""
    made, at, leafy = list[Token](), 0, False
    while at < len(tokens):
        long = _chain(tokens, at)
        found = _back(tokens, at + 2, long) if long >= _LEAST else None
        if found is None:
            made.append(tokens[at])
            at += 1
            continue
        stitch, end = found
        made += [
            *tokens[at : at + 2],
            replace(tokens[at + 1], kind="mark", word=",", value=None),
            *_along(stitch, long),
        ]
        at, leafy = end, True
    return _on_ring(made) if leafy or any(t.value == "hook" for t in made) else made


def _chain(tokens: list[Token], at: int) -> int:
    """How many chains stand there: "ch 6"; 0 where none do."""
    if at + 1 >= len(tokens) or tokens[at].value != "ch" or tokens[at].kind != "stitch":
        return 0
    many = tokens[at + 1].value
    return many if isinstance(many, int) and tokens[at + 1].kind == "number" else 0


def _back(tokens: list[Token], at: int, long: int) -> tuple[Token, int] | None:
    """The stitch by which the hook goes back along a chain, and where the words end that say it; None where none do, or say it stitch by
    stitch."""
    k = at
    while k < len(tokens) and (tokens[k].word in (",", ".", "and", "then") or tokens[k].value in ("turn", "and")):
        k += 1
    skipped = k + 1 < len(tokens) and tokens[k].value == "skip" and tokens[k + 1].value in (1, "ch")
    if skipped:
        k += 2
        while k < len(tokens) and (tokens[k].word in (",", "and", "then") or tokens[k].value in ("ch", "and")):
            k += 1
    if k + 2 < len(tokens) and tokens[k].value == long - 1 and tokens[k + 2].word in _BACK:
        k += 1  # "ch 31, 30 sc back"
    stitch = tokens[k] if k < len(tokens) else None
    if stitch is None or stitch.value not in _STITCHES or stitch.kind != "stitch":
        return None
    end, back, many = k + 1, False, 0
    while end < len(tokens) and end - k < _FURTHEST:
        t = tokens[end]
        if t.word in _BACK or any(w in _BACK for w in t.word.split()):
            back = True
        elif t.kind == "number" and isinstance(t.value, int):
            many = t.value
        elif (t.word == "ring" and back) or (
            t.word == ","
            and end + 1 < len(tokens)
            and tokens[end + 1].value == stitch.value
            and _goes_back(tokens, end + 2)
        ):
            pass
        elif not (
            t.kind == "ordinal"
            or t.word in _IN
            or t.value in _IN
            or t.value == stitch.value
            or (t.value == "ring" and back)
        ):
            break
        end += 1
    while tokens[end - 1].word in _IN - {"ch", "chain", "chains"} and end > k + 1:
        end -= 1
    said = tokens[k:end]
    plain = any(a.value == "hook" for a in said) and not back
    second = (
        any(t.kind == "ordinal" and t.value == 2 for t in said[:3]) and many == long - 2
    )  # "sl st in 2nd ch and in next 8"
    if plain or not (back or second or (skipped and many == long - 1)):
        return None
    return stitch, end


def _goes_back(tokens: list[Token], at: int) -> bool:
    """Whether the clause there goes back along a chain."""
    end = next((k for k in range(at, min(at + _FURTHEST, len(tokens))) if tokens[k].kind == "mark"), len(tokens))
    return any(t.word in _BACK or any(w in _BACK for w in t.word.split()) for t in tokens[at:end])


def _along(stitch: Token, long: int) -> list[Token]:
    """The words "sl st in 2nd ch from hook and in next 4 ch"."""
    a, b = stitch.start, stitch.end

    def key(word: str, value: str) -> Token:
        return Token("key", word, a, b, value)

    chain = replace(stitch, word="ch", value="ch")
    made = [stitch, key("in", "in"), Token("ordinal", "2nd", a, b, 2), chain, key("from", "from"), key("hook", "hook")]
    if long > _LEAST - 1 and long - 2 > 0:
        made += [
            key("and", "and"),
            key("in", "in"),
            key("next", "next"),
            Token("number", str(long - 2), a, b, long - 2),
            chain,
        ]
    return made


def _on_ring(tokens: list[Token]) -> list[Token]:
    """Leaves that grow out of a ring, "(ch 6, …, 1 sc in ring) 5 times", on the stitches of that ring."""
    ring = next(
        (k for k, t in enumerate(tokens) if t.value == "ring" and k and any(u.value == "hook" for u in tokens[:k])), 0
    )
    begin = next((k for k in range(ring, -1, -1) if tokens[k].word in _OPEN), -1)
    end = next((k for k in range(ring, len(tokens)) if tokens[k].word in _CLOSE), -1)
    if not ring or begin < 0 or end < 0 or not any(_chain(tokens, k) for k in range(begin, ring)):
        return tokens
    first = next((k for k in range(ring, begin, -1) if tokens[k].kind == "stitch"), ring)
    many = next((t for t in tokens[end : end + 4] if t.kind == "number" and isinstance(t.value, int)), None)
    if many is None or tokens[first].value not in _STITCHES:
        return tokens
    begin_ = next((k for k in range(first, begin, -1) if tokens[k].word == ","), first - 1)
    s = tokens[first]
    place = [
        replace(s, word="slst", value="slst"),
        Token("key", "in", s.start, s.end, "in"),
        Token("key", "next", s.start, s.end, "next"),
        Token("key", "st", s.start, s.end, "stitch"),
    ]
    lead = [
        replace(many, start=s.start, end=s.end),
        replace(s, word="sc", value="sc"),
        Token("key", "in", s.start, s.end, "in"),
        replace(tokens[ring]),
        Token("mark", ",", s.end, s.end),
    ]
    return [*tokens[:begin], *lead, *tokens[begin : begin_ + 1], *place, *tokens[end:]]

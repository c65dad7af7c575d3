"""Printed patterns, stops: where a sentence between the rounds ends, and its words in the order in which they are meant."""

from __future__ import annotations

import re
from typing import Final

from tambour.crochet.printed.rounds.items import bare_count
from tambour.crochet.printed.tokens import Token


def same_row(tokens: list[Token], begin: int, at: int) -> bool:
    """Whether the sentence behind the point at ``at`` goes on in the row that the one from ``begin`` begins in a chain: "4 dc in 4th ch from
    hook. *5 dc in next ch. Rep from * to end of chain."."""
    after = tokens[at + 1] if at + 1 < len(tokens) else None
    hooked = any(t.kind == "key" and t.value == "hook" for t in tokens[begin:at])
    onward = after is not None and _onward(tokens, at + 1)
    if after is None or not hooked or (tokens[begin].value == "ch" and not onward):
        return False
    if onward:
        return True
    stop = next((k for k in range(at + 1, len(tokens)) if tokens[k].word in (".", ";")), len(tokens))
    starred = after.word == "*" or (after.value == "repeat" and any(t.word == "*" for t in tokens[begin:at]))
    numbered = after.kind == "number" and at + 2 < len(tokens) and tokens[at + 2].kind == "stitch"
    return starred or (numbered and bare_count(tokens[at + 1 : stop]) is None)


def _onward(tokens: list[Token], at: int) -> bool:
    """Whether the words from ``at`` go on along the other side of the chain: "3 sc in last ch. Now work along the other side: …"."""
    for token in tokens[at : at + _LED]:
        if token.kind == "key" and token.value == "side":
            return True
        if token.kind in ("stitch", "number") and token.value not in ("ch", "sc"):
            return False
    return False


_LED: Final = 6  # words before those that name the other side


def held(tokens: list[Token]) -> set[int]:
    """The points between an asterisk and the words that repeat from it, which end no sentence."""
    held: set[int] = set()
    begin = -1
    for at, token in enumerate(tokens):
        before = tokens[at - 1] if at else None
        if token.word == "*" and not (before is not None and before.kind == "key" and before.value in ("from", "to")):
            begin = at
        elif begin >= 0 and token.kind == "key" and token.value == "repeat":
            held |= {k for k in range(begin, at) if tokens[k].kind == "mark" and tokens[k].word in ".;"}
            begin = -1
    return held


def turned(tokens: list[Token], through: tuple[str, ...]) -> list[Token]:
    """A sentence with "through Round 12" behind the part whose rounds are meant: "Work through Round 12 as for Large Body".
    ``through`` : the words for it."""
    for k, t in enumerate(tokens[:-3]):
        if t.word in through and tokens[k + 1].value in ("round", "row") and tokens[k + 3].value in ("as", "same"):
            end = next((n for n in range(k + 3, len(tokens)) if tokens[n].word in (",", ".", ";", "(")), len(tokens))
            return [*tokens[:k], *tokens[k + 3 : end], *tokens[k : k + 3], *tokens[end:]]
    return tokens


def founded(tokens: list[Token]) -> list[Token]:
    """A sentence that makes a ring "as given for Head", without what only says how."""
    ring = next((k for k, t in enumerate(tokens[:8]) if t.kind == "key" and t.value == "ring" and t.word != "mc"), None)
    as_at = next(
        (k for k, t in enumerate(tokens) if t.kind == "key" and t.value in ("as", "same") and k > (ring or 0)), None
    )
    if (
        ring is None
        or as_at is None
        or any(t.kind == "stitch" or t.value in ("repeat", "round", "row") for t in tokens)
    ):
        return tokens
    return tokens[: as_at - (tokens[as_at - 1].word == ",")]


def starts(text: str, at: int) -> int:
    """Where the sentence of a token begins: small words before it are no tokens ("Crochet a | second one")."""
    led = _SMALL.search(text, max(0, text.rfind("\n", 0, at)), at)
    return led.start(1) if led is not None else at


_SMALL: Final = re.compile(r"(?:^|[\n.!?;:,)\]])[^\S\n]*((?:[^\W\d_]+[^\S\n]+)+)$")

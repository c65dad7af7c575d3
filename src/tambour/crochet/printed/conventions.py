"""Printed patterns, conventions: sentences that say how all of a text is meant, and work nothing themselves."""

from __future__ import annotations

from typing import Final

from tambour.crochet.printed.doings import works
from tambour.crochet.printed.state import State
from tambour.crochet.printed.tokens import Token

_COURSE: Final = frozenset(
    (
        "spiral",
        "spirals",
        "continuous",
        "continuously",
        "joined",
        "worked",
        "rounds",
        "rnds",
        "rows",
        "seam",
        "seamless",
    )
)
_TOLD: Final = frozenset(("is", "are", "will", "be"))
_WORK: Final = frozenset(("worked", "crocheted", "made", "joined", "shown", "given", "written", "measured"))


def convention(p: State, tokens: list[Token]) -> bool:
    """Whether a sentence is one of these: chains that count or do not, rounds that are all joined, work that goes on in a
    spiral, how colours are changed. Whether chains count is remembered."""
    tokens = _said(tokens)
    if not tokens or p.mode in ("materials", "abbreviations"):
        return False
    words = {t.word for t in tokens}
    keys = {t.value for t in tokens if t.kind == "key"}
    if "count" in keys and any(t.kind == "stitch" and t.value == "ch" for t in tokens[:3]):
        many = next((t.value for t in tokens[:4] if t.kind == "number"), 0)
        if isinstance(many, int) and many:
            p.source.standing[many] = "not" not in keys
            return True
    first = tokens[0]
    if (
        first.word == "to"
        and len(tokens) > 1
        and (tokens[1].word in ("change", "color", "colour") or tokens[1].value == "color")
    ):
        return True  # "To change color, work to last 2 loops on hook …"
    every = {"each", "all"} & keys or {"all", "every"} & words
    if every and "round" in keys and "join" in keys and not any(t.kind == "number" for t in tokens):
        return True  # "Join all rnds with sl st to first sc"
    plain = not any(works(tokens, k) for k in range(len(tokens))) and not any(
        t.kind == "number" or (t.kind == "ordinal" and t.word[0].isdigit()) for t in tokens
    )
    if plain and words & _COURSE and ("round" in keys or "row" in keys or {"spiral", "spirals"} & words):
        return not {"repeat", "as", "same"} & keys or ("as" in keys and "follows" in words)
    return plain and "follows" in words and bool(words & {"proceed", "follows"}) and not keys & {"repeat"}


def _said(tokens: list[Token]) -> list[Token]:
    """A sentence without "Note:" before it."""
    if len(tokens) > 2 and tokens[0].kind == "key" and tokens[0].value == "notes" and tokens[1].word in (":", "-"):
        return tokens[2:]
    return tokens

"""Printed patterns, asides: words within a round that work nothing, and slips of the pen that have one reading."""

from __future__ import annotations

from functools import lru_cache
from typing import Final

from tambour.crochet.printed.cursor import OPEN, Cursor
from tambour.crochet.printed.tokens import Token

_ASIDE: Final = frozenset(
    ("but", "instead", "being", "so", "omitting", "without", "adding", "noting", "including", "while")
)
_HANDS: Final = frozenset(
    (
        "taking",
        "making",
        "being",
        "ensuring",
        "holding",
        "pushing",
        "placing",
        "weaving",
        "pulling",
        "keeping",
        "carrying",
        "moving",
        "matching",
        "stuffing",
        "removing",
        "dropping",
        "demonstrated",
        "pictured",
        "illustrated",
    )
)
_NO: Final = frozenset(
    (
        "ending",
        "string",
        "spring",
        "during",
        "changing",
        "turning",
        "alternating",
        "nothing",
        "opening",
        "edging",
        "stocking",
    )
)
_WORKS: Final = frozenset(("working", "skipping", "inserting", "using", "leaving", "slipping", "crocheting"))
_STOPS: Final = (",", ".", ";", ":", "(", "[", "{", ")", "]", "}", "*", "**", "=")
_PEN: Final = {"next": "next", "around": "around", "each": "each", "repeat": "repeat", "stitch": "stitch"}
_TRUE: Final = frozenset(("round", "ach"))  # words that are no slips
_THINGS: Final = frozenset(
    (
        "petal", "petals", "leg", "legs", "ear", "ears", "group", "groups", "toe", "toes", "point", "points", "spine", "spines",
        "thumb", "finger", "fingers", "tentacle", "tentacles", "pompom", "pompoms", "cluster", "clusters", "shell", "shells",
        "picot", "picots", "loops", "corner", "corners", "v", "leaf", "leaves", "claw", "claws", "curl", "curls", "horn", "horns",
        "repeats", "rays", "tooth", "teeth", "scale", "scales", "wing", "wings", "bobbles", "ruffle", "fan", "fans", "center",
    )
)  # fmt: skip


def aside(c: Cursor) -> bool:
    """Whether the clause at the cursor only says how hands go ("pushing chains to the front"): it names no number of stitches."""
    first = c.look()
    if first is not None and first.value == "with":
        return _on_hook(c)
    if first is None or first.kind != "word":
        return False
    if first.word in _HANDS:
        return True
    worked = first.word in _WORKS and not c.key("stuff", "marker", "eyes", ahead=1)  # "inserting stuffing as you go"
    ing = first.word.endswith("ing") and len(first.word) > 5 and not worked and first.word not in _NO
    if not ing and first.word not in _ASIDE:
        return False
    ahead = 1
    while (token := c.look(ahead)) is not None and not (token.kind == "mark" and token.word in _STOPS):
        after = c.look(ahead + 1)
        if token.kind in ("number", "stitch") and after is not None and (after.kind == "stitch" or after.value == "in"):
            return False
        ahead += 1
    return True


def _on_hook(c: Cursor) -> bool:
    """Whether a clause only says what the hook holds: "with the second leg still on your hook"."""
    ahead = 1
    while (token := c.look(ahead)) is not None and token.kind in ("word", "key", "ordinal") and ahead < 10:
        ahead += 1
    last = c.look(ahead - 1)
    return last is not None and last.value == "hook" and any(c.look(k).word == "on" for k in range(1, ahead))  # type: ignore[union-attr]


def things(c: Cursor) -> int:
    """How many tokens a count of other things is that stands at the cursor: "5 petals", "4 (sc, 2 dc) groups"; 0 for none."""
    if c.whole() is None:
        return 0
    ahead = 1
    if c.mark("-", ahead=1) and c.look(2) is not None:
        ahead = 3
    if c.mark(*OPEN, ahead=ahead):
        while c.look(ahead) is not None and not c.mark(")", "]", "}", ahead=ahead):
            ahead += 1
        ahead += 1
    while (token := c.look(ahead)) is not None and token.kind in ("word", "stitch", "key", "number") and ahead < 8:
        if token.word in _THINGS:
            return ahead + 1
        if token.kind == "key" and token.value not in ("loop", "space", "front loops", "back loops"):
            return 0
        ahead += 1
    return 0


def penned(tokens: list[Token]) -> tuple[list[Token], list[tuple[Token, str]]]:
    """``tokens`` with slips of the pen put right ("nex" for "next", "arund"), and each of them with what it is read as."""
    found = [(t, meant) for t in tokens if t.kind == "word" and (meant := _slips().get(t.word)) is not None]
    if not found:
        return tokens, []
    known = {id(t): meant for t, meant in found}
    made = [
        Token("key", known[id(t)], t.start, t.end, _PEN[known[id(t)]], t.glued, t.capital) if id(t) in known else t
        for t in tokens
    ]
    return made, found


@lru_cache(maxsize=1)
def _slips() -> dict[str, str]:
    """Words with a letter left out, doubled, or two in the wrong order → the word meant."""
    made: dict[str, str] = {}
    for word in _PEN:
        for k in range(len(word)):
            made.setdefault(word[:k] + word[k + 1 :], word)
            made.setdefault(word[: k + 1] + word[k:], word)
            if k:
                made.setdefault(word[: k - 1] + word[k] + word[k - 1] + word[k + 1 :], word)
    for word in (*_PEN, *_TRUE):
        made.pop(word, None)
    return made

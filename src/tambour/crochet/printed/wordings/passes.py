"""Printed patterns, passes: what puts the words of a line as most patterns have them, in order, and by which words a line concerns each."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

from tambour.crochet.printed.parts import recolored
from tambour.crochet.printed.tokens import Token
from tambour.crochet.printed.wordings import (
    corners,
    folded,
    hooks,
    inner,
    minor,
    postposed,
    shorthand,
    spread,
    sprigs,
    underside,
)

_ORDINAL: Final = " ordinal"
_GROWN: Final = " grown"  # a number right behind a stitch: "2sc6"
_PHRASE: Final = " phrase"  # several words that are one stitch: "dc inc"


@dataclass(frozen=True)
class _Pass:
    """``put`` changes nothing of a line that has none of the words or meanings ``any``, nor all those of one of ``together``."""

    put: Callable[[list[Token]], list[Token]]
    any: frozenset[str] = frozenset()
    together: tuple[frozenset[str], ...] = ()


def _all(*said: str) -> tuple[frozenset[str], ...]:
    return tuple(frozenset(one.split()) for one in said)


_PASSES: Final = (
    _Pass(shorthand.apart, shorthand.BETWEEN),
    _Pass(shorthand.beside, frozenset(("x", "*", "times"))),
    _Pass(shorthand.singles, frozenset(",")),
    _Pass(shorthand.grouped, frozenset("x*")),
    _Pass(shorthand.had, frozenset(("have",))),
    _Pass(minor.listed, frozenset(";")),
    _Pass(minor.summed, frozenset("([-=")),
    _Pass(minor.plainer, minor.SAYING, _all("in each stitch ,", "- hdc", "- dc", "- tr")),
    _Pass(minor.often, frozenset(("x", "times", "repeat"))),
    _Pass(inner.looped, inner.LOOPS),
    _Pass(inner.anywhere, frozenset(), tuple(frozenset((_ORDINAL, "round", w)) for w in ("join", "draw", "attach"))),
    _Pass(inner.counted, frozenset("-")),
    _Pass(inner.nth, frozenset(), (frozenset((_ORDINAL, "each")),)),
    _Pass(inner.named, frozenset("(")),
    _Pass(inner.together, frozenset(), _all("and in stitch next", "and in stitch same")),
    _Pass(inner.rests, inner.LEFT_OVER),
    _Pass(spread.spread, frozenset(("each", _PHRASE))),
    _Pass(postposed.put_before, postposed.SAYING),
    _Pass(folded.shut, folded.LAYERS),
    _Pass(shorthand.grown, shorthand.SAYING | {_GROWN}, _all("each round", "each row")),
    _Pass(recolored.undyed, recolored.SAYING),
    _Pass(hooks.unsized, frozenset(("hook",))),
    _Pass(corners.grouped, corners.PLACES),
    _Pass(sprigs.chained, frozenset(), tuple(frozenset(("ch", w)) for w in (*sprigs.SAYING, "ring", "hook", _ORDINAL))),
    _Pass(
        underside.plainly_put,
        underside.SIDES,
        (frozenset(("ch", _ORDINAL)), *_all("ch begin", "back along", "back down")),
    ),
)

_ANY: Final = {
    word: sum(1 << k for k, one in enumerate(_PASSES) if word in one.any)
    for word in frozenset().union(*(one.any for one in _PASSES))
}
"""Word → the passes that it concerns by itself, a bit each."""
_TOGETHER: Final = tuple((words, 1 << k) for k, one in enumerate(_PASSES) for words in one.together)


def plain(tokens: list[Token]) -> list[Token]:
    """Words as read, put as most patterns have them: "sc twice in next st" as "2 sc in next st"."""
    concerned = _concerned(tokens)
    for k, one in enumerate(_PASSES):
        if concerned >> k & 1:
            made = one.put(tokens)
            if made != tokens:
                tokens, concerned = made, _concerned(made)
    return tokens


def _concerned(tokens: list[Token]) -> int:
    """Which passes may change a line, a bit each."""
    said = _said(tokens)
    found = 0
    for word in said:
        found |= _ANY.get(word, 0)
    for words, one in _TOGETHER:
        if words <= said:
            found |= one
    return found


def _said(tokens: list[Token]) -> set[str]:
    """The words of a line, and what they mean."""
    said = {t.word for t in tokens}
    stitch = False
    for t in tokens:
        if type(t.value) is str:
            said.add(t.value)
        if " " in t.word:
            said.update(t.word.split(" "))
            if t.kind == "stitch":
                said.add(_PHRASE)
        if t.kind == "ordinal":
            said.add(_ORDINAL)
        elif stitch and t.kind == "number" and t.glued:
            said.add(_GROWN)
        stitch = t.kind == "stitch"
    return said

"""Printed patterns, folded: an end that is pressed flat and worked shut, in the many words for it: "vouw de vleugel plat en haak hem dicht met 6 v door beide
lagen", "fold the edge in half and knit 4 sc for both sides"."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

from tambour.crochet.printed.tokens import Token

_FOLDS: Final = (
    "fold flat press pinch squash squeeze vouw plat knijp druk pli plat pinc aplat falt zusammenleg drück dobl aplast zgi slož"
).split()
_BOTH: Final = frozenset("both two 2 beide beiden deux ambos ambas dos zwei twee".split())
_LAYERS: Final = frozenset(
    "layers layer sides edges walls halves thicknesses lagen lage zijden kanten épaisseurs côtés bords capas lados lagen schichten seiten".split()
)
LAYERS: Final = _LAYERS | {"thicknesses"}
_STOPS: Final = (".", ";", "!", ":")
_FURTHEST: Final = 8  # words between the stitches and the layers


def shut(tokens: list[Token]) -> list[Token]:
    """Words as read, with sentences that fold an end and work it shut as "6 sc through both layers"."""
    if not any(t.value == "thicknesses" or t.word.rpartition(" ")[2] in _LAYERS for t in tokens):
        return tokens
    made: list[Token] = []
    at = 0
    while at < len(tokens):
        end = next((k for k in range(at, len(tokens)) if tokens[k].word in _STOPS), len(tokens))
        named = _named_behind(tokens, at, end)
        if named is not None:
            made += named
            at = end + 3
            continue
        made += _shut(tokens[at:end]) + tokens[end : end + 1]
        at = end + 1
    return made


def _named_behind(tokens: list[Token], at: int, end: int) -> list[Token] | None:
    """A sentence that names its stitches behind the layers, "Fold flat and crochet through both layers: 5 sc", as what shuts the end; None
    for another."""
    behind = tokens[end + 1 : end + 4]
    ends = len(behind) == 2 or (len(behind) == 3 and behind[2].word in (".", ";", "!", "(", "["))
    where = _layers(tokens[at:end]) if end < len(tokens) and tokens[end].word in (":", ",") and ends else None
    if where is None or not _worked(behind[0], behind[1]):
        return None
    begin, stop = at + where[0], at + where[1]
    said = [*tokens[at:begin], *behind[:2], *tokens[begin:stop]]
    made = _shut(said)
    return made if made is not said else None


def _shut(some: list[Token]) -> list[Token]:
    """One sentence; what stands behind the layers stays."""
    where = _layers(some)
    if where is None or not any(_folds(t) for t in some[: where[0]]):
        return some
    begin, end = where
    pairs = [k for k in range(begin - 1) if _worked(some[k], some[k + 1])]
    if len(pairs) != 1 or begin - pairs[0] > _FURTHEST or any(t.value in ("ch", "skip") for t in some[pairs[0] :]):
        return some
    behind = some[pairs[0] + 2 : begin]
    if any(t.kind in ("number", "stitch") or t.word in ("*", "(") for t in behind):
        return some
    first, last = some[begin], some[end - 1]
    through = Token("key", "both layers", first.start, last.end, "thicknesses")
    within = Token("key", "in", first.start, first.start, "in")
    fold = next(t for t in some if _folds(t))
    said = [replace(fold, kind="word", word="flatten", value=None), Token("key", "and", fold.end, fold.end, "and")]
    work = Token("word", "work", fold.end, fold.end)
    lead = next((k for k in range(pairs[0]) if some[k] is fold), 0)
    works = any(t.word == ":" or t.kind in ("number", "stitch") or t.value in ("round", "row") for t in some[:lead])
    lead = lead if works else 0
    return [*some[:lead], *said, work, *some[pairs[0] : pairs[0] + 2], within, through, *some[end:]]


def _worked(one: Token, other: Token) -> bool:
    """Whether two words are a number and a stitch: "6 sc", "sc 6"."""
    kinds = {one.kind, other.kind}
    stitch = one if one.kind == "stitch" else other
    return kinds == {"number", "stitch"} and stitch.value in ("sc", "slst", "hdc", "dc")


def _folds(token: Token) -> bool:
    return token.kind != "number" and any(token.word.startswith(w) for w in _FOLDS)


def _layers(some: list[Token]) -> tuple[int, int] | None:
    """Where the words stand that name both layers."""
    for k, token in enumerate(some):
        if token.value == "thicknesses":
            return k, k + 1
        if token.value == "both sides" or token.word == "both sides":
            return k, k + 1
        numbered = token.word in _BOTH or token.value == 2
        if numbered and k + 1 < len(some) and some[k + 1].word in _LAYERS:
            return k, k + 2
        if k and token.word in _LAYERS and some[k - 1].value in ("in", "for"):
            return k, k + 1  # "through both layers", where "both" was left out as a word that says nothing
    return None

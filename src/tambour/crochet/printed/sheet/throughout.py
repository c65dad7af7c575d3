"""Printed patterns, throughout: rounds whose one word says that every stitch is worked plainly, as tables and short cards have them: ``7-16 | 21 | all``,
``9. blo, around [54]``, ``R6: all (3 rounds)``; put with the stitch they are of."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

from tambour.crochet.printed.tokens import Row, Token
from tambour.crochet.printed.wordings.vocabulary import Vocabulary

_PLAIN: Final = frozenset(("sc", "hdc", "dc", "tr"))
_ABOVE: Final = 4  # lines
_ALL: Final = frozenset(("all", "around"))
_LOOPS: Final = ("back loops", "front loops")
_OPENS: Final = frozenset(("(", "[", "{", "="))
_ENDS: Final = frozenset((",", ".", ";"))


def throughout(rows: list[Row], vocabulary: Vocabulary, stitch: str) -> list[Row]:
    """``rows`` in which a round that says "all" or "around" and no stitch works so many plain ones of ``stitch``."""
    made: list[Row] = []
    for row in rows:
        even = _put(row, vocabulary, stitch)
        made.append(even if even is row else _put(row, vocabulary, _worked(made, vocabulary, stitch)))
    return made


def _worked(rows: list[Row], vocabulary: Vocabulary, stitch: str) -> str:
    """The plain stitch that the nearest round above is worked in, "hdc"; ``stitch`` where none is."""
    for row in rows[: -_ABOVE - 1 : -1]:
        if words := {t.value: t.word for t in vocabulary.read(row.tokens) if t.kind == "stitch" and t.value in _PLAIN}:
            return stitch if "sc" in words or len(words) > 1 else next(iter(words.values()))
    return stitch


def _put(row: Row, vocabulary: Vocabulary, stitch: str) -> Row:
    at = next((k for k, t in enumerate(row.tokens) if t.word in _ALL), 0)
    tokens = row.tokens
    end = at + 1 + (at + 1 < len(tokens) and tokens[at + 1].word == "around")  # "all around"
    if not at or not _before(tokens[:at], vocabulary) or not _behind(tokens[end:]):
        return row
    said = tokens[at]
    if tokens[at - 1].word == ",":
        at -= 1  # "blo, around"
    place = said.start
    even = [Token("word", w, place, said.end) for w in (stitch, "in", "each", "st", "around")]
    return replace(row, tokens=[*tokens[:at], *even, *tokens[end:]])


def _before(tokens: list[Token], vocabulary: Vocabulary) -> bool:
    """Whether nothing stands there but the head of a round and loops: "11.-15.", "Rnd 4: BL,"."""
    read = vocabulary.read(tokens)
    while read and (read[-1].value in _LOOPS or read[-1].word == ","):
        read.pop()
    return bool(read) and all(
        t.kind in ("number", "ordinal", "mark") or t.value in ("round", "row", "to", "and") for t in read
    )


def _behind(tokens: list[Token]) -> bool:
    """Whether a round's count or nothing stands there: "[54]", "(9 rounds)", "= 54"."""
    if not tokens or tokens[0].word in _ENDS:
        return len(tokens) < 2 or tokens[0].word != "." or tokens[1].capital
    return tokens[0].word in _OPENS and len(tokens) > 1 and tokens[1].kind == "number"

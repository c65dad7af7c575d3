"""Printed patterns, counted yarns: a round told by how many stitches are of which yarn, ``B 18, W 12, B 18``, ``4A, 2B``, ``(2 white, 1 red) x 6``,
as its stitches: ``with B, 18 sc, with W, 12 sc, …``."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from typing import Final

from tambour.crochet.printed.tokens import Row, Token
from tambour.crochet.printed.wordings.vocabulary import Vocabulary
from tambour.crochet.printed.yarns.colors import LETTERS, Palette

_WORDS: Final = 2  # of a yarn's name
_ENDS: Final = frozenset((",", ";", "(", ")", "[", "]", "*", ".", "/", "|", "=", "+"))
_GROWN: Final = re.compile(r"([a-z])(\d{1,3})")
"""A letter and its count as one word: "b4"."""


@dataclass(frozen=True)
class _Run:
    """So many stitches of one yarn, and where they end."""

    yarn: tuple[Token, ...]
    many: Token
    stitch: tuple[Token, ...]
    end: int


def counted(rows: list[Row], palette: Palette, vocabulary: Vocabulary, sc: str) -> list[Row]:
    """``rows`` with such rounds as most others have them. sc : what a stitch is called that the text does not name."""
    rows = [_led(row, palette, vocabulary) for row in rows]
    return [_row(row, palette, vocabulary, sc) if len(row.tokens) > 4 else row for row in rows]


def _led(row: Row, palette: Palette, vocabulary: Vocabulary) -> Row:
    """``row`` with the word that a yarn's letter lacks which is a line by itself, or begins one: "W", "O, from the top", "T, in rows: ch 61"."""
    tokens = row.tokens
    if not tokens or tokens[0].word not in palette.given or not tokens[0].capital or len(tokens[0].word) > 2:
        return row
    if tokens[0].word == "a" or (len(tokens) > 1 and tokens[1].word != ","):
        return row
    begin, end = tokens[0].start, tokens[0].end
    stop = [Token("mark", ".", end, end, None, True)] if len(tokens) > 1 else []
    return replace(
        row, tokens=[Token("word", "with", begin, begin, None, False, True), tokens[0], *stop, *tokens[2:]], marked=0
    )


def _row(row: Row, palette: Palette, vocabulary: Vocabulary, sc: str) -> Row:
    tokens = row.tokens
    if not any(t.word[-1].isdigit() for t in tokens[:2]):
        return row  # no head of a round
    parts = [
        k for k in range(1, len(tokens)) if tokens[k - 1].kind == "mark" and _heads(tokens, k, palette, vocabulary)
    ]
    if len(parts) > 1:  # "O: (4 sc, dec) x 2 / W: 9 sc"
        tokens = _parted(tokens, parts)
        row = replace(row, tokens=tokens)
    found: dict[int, _Run] = {}
    at = 1
    while at < len(tokens):
        run = _run(tokens, at, palette, vocabulary) if tokens[at - 1].kind == "mark" else None
        if run is not None:
            found[at] = run
        at = run.end if run is not None else at + 1
    if len(found) < 2 or len({tuple(t.word for t in run.yarn) for run in found.values()}) < 2:
        return row
    made: list[Token] = []
    at = 0
    while at < len(tokens):
        run = found.get(at)
        if run is None:
            made.append(tokens[at])
            at += 1
            continue
        start = run.yarn[0].start
        made.append(Token("word", "with", start, start))
        made += [replace(t, glued=False, value="A" if t.word == "a" else t.value) for t in run.yarn]
        made += [Token("mark", ",", run.yarn[-1].end, run.yarn[-1].end, None, True), replace(run.many, glued=False)]
        made += run.stitch or [Token("word", sc, run.many.end, run.many.end)]
        at = run.end
    return replace(row, tokens=made)


def _parted(tokens: list[Token], parts: list[int]) -> list[Token]:
    """A round whose yarns head what is worked in them, each with "with" before it and a comma behind: "with O, (4 sc, dec) x 2; with W, 9 sc"."""
    made: list[Token] = []
    for k, token in enumerate(tokens):
        if k in parts:
            made.append(Token("word", "with", token.start, token.start))
            token = replace(token, glued=False, value="A" if token.word == "a" else token.value)
        elif k + 1 in parts and token.word == "/":
            token = replace(token, word=";")
        elif token.word == ":" and any(0 < k - at <= _WORDS for at in parts):
            token = replace(token, word=",")
        made.append(token)
    return made


def _heads(tokens: list[Token], at: int, palette: Palette, vocabulary: Vocabulary) -> bool:
    """Whether a yarn with a colon behind it stands at ``at``: "W:"."""
    end = at + len(_yarn(tokens, at, palette, vocabulary))
    return at < end < len(tokens) and tokens[end].word == ":"


def _run(tokens: list[Token], at: int, palette: Palette, vocabulary: Vocabulary) -> _Run | None:
    """The run of one yarn that begins at ``at`` and fills its clause; None where none does."""
    first = tokens[at]
    if (grown := _GROWN.fullmatch(first.word)) and first.capital and first.kind == "word":
        letter = replace(first, word=grown[1], end=first.start + 1)
        many = Token("number", grown[2], first.start + 1, first.end, int(grown[2]))
        return _whole(tokens, (letter,), many, at + 1, vocabulary) if _lettered(letter, palette, vocabulary) else None
    if first.kind == "number" and isinstance(first.value, int):
        end = at + 1
        stitch = _stitch(tokens, end, vocabulary)
        end += len(stitch)
        end += end < len(tokens) and tokens[end].word == "in"  # "3 sc in B, 10 in W"
        yarn = _yarn(tokens, end, palette, vocabulary)
        end += len(yarn)
        return _Run(yarn, first, stitch, end) if yarn and _ended(tokens, end) else None
    yarn = _yarn(tokens, at, palette, vocabulary)
    end = at + len(yarn)
    end += bool(yarn) and end < len(tokens) and tokens[end].word == ":"
    if yarn and (stitch := _stitch(tokens, end, vocabulary)):  # "MC sc 5"
        number = tokens[end + 1] if end + 1 < len(tokens) else None
        if number is not None and isinstance(number.value, int) and _ended(tokens, end + 2):
            return _Run(yarn, number, stitch, end + 2)
    many_ = tokens[end] if yarn and end < len(tokens) else None
    if many_ is None or many_.kind != "number" or not isinstance(many_.value, int):
        return None
    return _whole(tokens, yarn, many_, end + 1, vocabulary)


def _whole(tokens: list[Token], yarn: tuple[Token, ...], many: Token, end: int, vocabulary: Vocabulary) -> _Run | None:
    stitch = _stitch(tokens, end, vocabulary)
    end += len(stitch)
    return _Run(yarn, many, stitch, end) if _ended(tokens, end) else None


def _ended(tokens: list[Token], at: int) -> bool:
    return at >= len(tokens) or tokens[at].word in _ENDS


def _stitch(tokens: list[Token], at: int, vocabulary: Vocabulary) -> tuple[Token, ...]:
    """The one word there that means a stitch; none where none does."""
    some = tokens[at : at + 1]
    read = vocabulary.read(some) if some and some[0].kind == "word" and len(some[0].word) > 1 else []
    return tuple(some) if len(read) == 1 and read[0].kind == "stitch" else ()


def _yarn(tokens: list[Token], at: int, palette: Palette, vocabulary: Vocabulary) -> tuple[Token, ...]:
    """The words there that name a yarn, by its colour or its letter."""
    if at < len(tokens) and _lettered(tokens[at], palette, vocabulary):
        return (tokens[at],)
    for many in range(_WORDS, 0, -1):
        some = tokens[at : at + many]
        words = " ".join(t.word for t in some)
        if len(some) == many and all(t.kind == "word" and len(t.word) > 1 for t in some) and palette.name(words):
            return tuple(some)
    return ()


def _lettered(token: Token, palette: Palette, vocabulary: Vocabulary) -> bool:
    """Whether a token is a yarn's letter: one that the text explains, or a capital that means nothing else."""
    if token.kind != "word" or not token.capital or len(token.word) > 2:
        return False
    if token.word in palette.given and len(token.word) == 1:
        return True
    read = vocabulary.read([token]) if token.word != "a" else []
    return token.word in LETTERS and all(t.kind == "word" for t in read)

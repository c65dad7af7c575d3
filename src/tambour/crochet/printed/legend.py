"""Printed patterns, the legend: words that a text gives to stitches, rings and rounds in a list of its own, before they are read: ``x – single crochet``,
``KA - amigurumi ring``, ``MR = magischer Ring, fM = feste Masche``."""

from __future__ import annotations

import re
from typing import Final

from tambour.crochet.printed.tokens import Row, Token
from tambour.crochet.printed.vocabulary import Vocabulary

_LOOKED_AT: Final = 150  # lines
_SIGNS: Final = ("=", "-", ":")
_PARTS: Final = (",", ";", "|", "•", "·")
_SHORT: Final = 5  # letters of a word that stands for another
_KEYS: Final = frozenset(("ring", "stitch", "round", "back loops", "front loops"))
_SHAPED: Final = re.compile(
    r"(?:work )?(?P<into>[23]) (?:(?:sc|x) )?(?:in|into) (?:1|one|same|the same|1 st|one st|the same st|same st)|(?P<of>[23]) (?:(?:sc|x) )?(?:tog|together)"
)
"""What an increase or a decrease is, in figures: "V = 2 in 1", "A = 2 tog"."""
_MOST: Final = 7  # words that say what one means


def explained(rows: list[Row], vocabulary: Vocabulary) -> None:
    """Teaches ``vocabulary`` the short words that the lines of a list explain, where it knows what stands behind them."""
    for row in rows[:_LOOKED_AT]:
        if len(row.tokens) > 2 and any(t.word in _SIGNS for t in row.tokens[1:]):
            for some in _parted(row.tokens):
                _one(some, vocabulary)


def _parted(tokens: list[Token]) -> list[list[Token]]:
    """What a line explains, one by one."""
    made: list[list[Token]] = [[]]
    depth = 0
    for token in tokens:
        depth += (token.word in ("(", "[")) - (token.word in (")", "]"))
        if depth <= 0 and token.word in _PARTS:
            made.append([])
        else:
            made[-1].append(token)
    return made


def _one(tokens: list[Token], vocabulary: Vocabulary) -> None:
    """Teaches one word: "sb - single crochet"; none that means as much already, and no letter of a yarn."""
    at = 2 if len(tokens) > 3 and tokens[1].word == "." and tokens[1].glued else 1
    if len(tokens) < at + 2 or tokens[at].word not in _SIGNS or (tokens[at].glued and tokens[at + 1].glued):
        return
    name = tokens[0]
    if name.kind != "word" or len(name.word) > _SHORT or not name.word.isalpha():
        return
    end = next(
        (k for k in range(at + 1, len(tokens)) if tokens[k].kind == "mark" and tokens[k].word not in ("-", "'")),
        len(tokens),
    )
    if end < len(tokens) and tokens[end].word == "=" and tokens[at].word == ":":
        _one(tokens[at + 1 :], vocabulary)  # "Key: sc = single crochet"
        return
    shaped = _SHAPED.fullmatch(" ".join(t.word for t in tokens[at + 1 : end]))
    if shaped is not None:
        many = shaped["into"] or shaped["of"]
        vocabulary.define(name.word, ("inc" if shaped["into"] else "dec") + ("" if many == "2" else many))
        return
    said = vocabulary.read(tokens[at + 1 : end]) if 0 < end - at - 1 <= _MOST else []
    if len(said) != 1 or said[0].word == name.word:
        return
    meant = said[0]
    known = vocabulary.read([name])
    if known and (known[0].kind, known[0].value) == (meant.kind, meant.value):
        return
    if known and known[0].kind == meant.kind == "stitch" and end - at == 2 and len(tokens[at + 1].word) <= _SHORT:
        return  # "US readers: dc = sc, tr = dc" says what others call them
    if meant.kind == "stitch" and meant.value is not None and meant.value != name.word:
        vocabulary.define(name.word, meant.value)
    elif meant.kind == "key" and meant.value in _KEYS and not (known and known[0].kind == "key"):
        vocabulary.mean(name.word, meant.value)

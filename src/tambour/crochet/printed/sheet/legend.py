"""Printed patterns, the legend: words that a text gives to stitches, rings and rounds in a list of its own, before they are read: ``x – single crochet``,
``KA - amigurumi ring``, ``MR = magischer Ring, fM = feste Masche``."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Final

from tambour.crochet.printed.tokens import Row, Token
from tambour.crochet.printed.wordings.vocabulary import Vocabulary

_LOOKED_AT: Final = 150  # lines
_SIGNS: Final = ("=", "-", ":")
_PARTS: Final = (",", ";", "|", "•", "·")
_LONGEST, _GAP, _LINES = 6, 2, 4
"""A list whose words stand above each other has so many lines, words of no more letters, and so many spaces behind them."""
_SHORT: Final = 5  # letters of a word that stands for another
_KEYS: Final = frozenset(("ring", "stitch", "round", "hook", "back loops", "front loops"))
_SHAPED: Final = re.compile(
    r"(?:work )?(?P<into>[23]) (?:(?P<kind>[a-z]{1,6}) )?(?:in|into) (?:1|one|(?:1|one|the same|same) (?:st|stitch)|same|the same)|(?P<of>[23]) (?:(?P<some>[a-z]{1,8}) )?(?:tog|together)"
)
"""What an increase or a decrease is, in figures: "V = 2 in 1", "A = 2 stitches together"."""
_PLAIN: Final = frozenset(("sc", "x", "st", "sts", "stitch", "stitches"))
_MOST: Final = 7  # words that say what one means


def aligned(text: str, rows: list[Row]) -> list[Row]:
    """``rows`` with a sign between the short words of a list and what they mean, where only a column's gap parts them: "lp     loop stitch"."""
    columns: dict[int, list[int]] = {}
    for k, row in enumerate(rows[:_LOOKED_AT]):
        if len(row.tokens) < 2 or not (row.tokens[0].word.isalpha() and 1 < len(row.tokens[0].word) <= _LONGEST):
            continue
        name, said = row.tokens[0], row.tokens[1]
        gap = text[name.end : said.start]
        if len(gap) >= _GAP and not gap.strip() and said.kind != "mark":
            columns.setdefault(said.start - text.rfind("\n", 0, said.start), []).append(k)
    found = {k for some in columns.values() if len(some) >= _LINES for k in some}
    return [
        replace(row, tokens=[row.tokens[0], Token("mark", "=", row.tokens[0].end, row.tokens[0].end), *row.tokens[1:]])
        if k in found
        else row
        for k, row in enumerate(rows)
    ]


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
    for k, token in enumerate(tokens):
        depth += (token.word in ("(", "[")) - (token.word in (")", "]"))
        ended = (  # "dis – decrease. aum – increase", and no "12. row: 6 sc"
            token.word == "."
            and 0 < k < len(tokens) - 2
            and tokens[k - 1].kind != "number"
            and tokens[k + 2].word in _SIGNS
        )
        if depth <= 0 and (
            ended or token.word in _PARTS or (token.word == "/" and not token.glued and len(made[-1]) > 2)
        ):
            made.append([])
        else:
            made[-1].append(token)
    return made


def _one(tokens: list[Token], vocabulary: Vocabulary) -> None:
    """Teaches one word: "sb - single crochet"; none that means as much already, and no letter of a yarn."""
    if (turned := _behind(tokens, vocabulary)) is not None:
        vocabulary.mean(*turned)
        return
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
    if shaped is not None and _of_sc(shaped["kind"] or shaped["some"], tokens, vocabulary):
        many = shaped["into"] or shaped["of"]
        vocabulary.define(name.word, ("inc" if shaped["into"] else "dec") + ("" if many == "2" else many))
        return
    said = vocabulary.read(tokens[at + 1 : end]) if 0 < end - at - 1 <= _MOST else []
    if (
        len(said) > 1
        and said[-1].value in _LOOPS
        and not any(t.kind in ("stitch", "number", "mark") for t in said[:-1])
    ):
        said = said[-1:]  # "tbl: through the back loop"
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
    elif meant.kind == "key" and meant.value in _KEYS and not (known and known[0].kind in ("key", "stitch")):
        vocabulary.mean(name.word, meant.value)


def _of_sc(word: str | None, tokens: list[Token], vocabulary: Vocabulary) -> bool:
    """Whether what two are worked of is a single crochet, or a loop stitch, which is one: "2 lp in the same stitch", and no "2 hdc"."""
    if word is None or word in _PLAIN:
        return True
    read = vocabulary.read([t for t in tokens if t.word == word][:1])
    return bool(read) and read[0].value in ("sc", "loopst", "fur", "stitch")


def _behind(tokens: list[Token], vocabulary: Vocabulary) -> tuple[str, str] | None:
    """The short word that stands behind what it means, a loop of a stitch: "back loop: BKL", "brins arrière : BAR"; and that meaning."""
    sign = next((k for k in range(1, len(tokens)) if tokens[k].word in _SIGNS), 0)
    if not sign or len(tokens) != sign + 2:
        return None
    short = tokens[sign + 1]
    if short.kind != "word" or not 1 < len(short.word) <= _SHORT or not short.word.isalpha() or not short.capital:
        return None
    said = vocabulary.read(tokens[:sign])
    known = vocabulary.read([short])
    if len(said) != 1 or said[0].kind != "key" or said[0].value not in _LOOPS or (known and known[0].kind != "word"):
        return None
    return short.word, said[0].value


_LOOPS: Final = ("back loops", "front loops")

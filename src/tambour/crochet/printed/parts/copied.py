"""Printed patterns, copies: how many of a piece are made, in the many words for it: ``x2``, ``2 pcs.``, ``you need two``, ``a pair``, ``left and right``."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from tambour.crochet.printed.tokens import Token
from tambour.crochet.words.table import Heard

_MARKS: Final = frozenset(
    (",", ".", ":", "x", "*", "**", "!", "-", "/", "&", "+", "(", ")", "[", "]", "=", "{", "}", "<", ">", "|", "_")
)
_AND: Final = frozenset("and und et y e en".split())
_RANGED: Final = frozenset(("-", "to", "or"))
_MOST: Final = 60
_LONGEST: Final = 12  # words


def number_of(token: Token, heard: Heard) -> int:
    """The number that a word is, in digits or letters; 0 for another."""
    if token.kind == "number" and isinstance(token.value, int):
        return token.value
    return heard.counting.get(token.word, 0)


def copies_of(tokens: Sequence[Token], heard: Heard, name: frozenset[str] = frozenset()) -> int:
    """How many copies words ask for that say nothing else, besides a part's ``name``; 0 where they say another thing, or a number alone."""
    if not 0 < len(tokens) <= _LONGEST:
        return 0
    if _sides(tokens, heard, name):
        return 2
    counts, worded = [], False
    for k, token in enumerate(tokens):
        if k > 1 and tokens[k - 1].word in _RANGED and 0 < number_of(tokens[k - 2], heard) < number_of(token, heard):
            continue  # "5-7": the fewest that are asked for
        grown = token.word[1:] if token.word[:1] == "x" and token.word[1:].isdigit() else token.word.removesuffix("x")
        if token.word in heard.pairs:
            counts.append(2)
        elif (many := number_of(token, heard)) or (grown != token.word and grown.isdigit()):
            counts.append(many or int(grown))
            worded = worded or not many
        elif token.word in _RANGED and counts and k + 1 < len(tokens) and number_of(tokens[k + 1], heard):
            continue
        elif token.word not in _MARKS and token.word not in heard.copied and token.word not in name:
            return 0
        worded = worded or token.word in heard.copied or token.word in heard.pairs or token.word in ("x", "*")
    for a, x, b in zip(tokens, tokens[1:], tokens[2:], strict=False):
        if (
            x.word in ("x", "×")
            and len(counts) == 2
            and 1 < (many := number_of(a, heard) * number_of(b, heard)) <= _MOST
        ):
            return many  # "2 x 2 paws"
    many = max(counts, default=0)
    return many if worded and 1 <= many <= _MOST and len({*counts}) == 1 else 0


def _sides(tokens: Sequence[Token], heard: Heard, name: frozenset[str]) -> bool:
    """Whether words name both sides of a toy, or a first and a second: "left and right", "1 left, 1 right", "#1 and #2"."""
    said = [t for t in tokens if t.word not in _MARKS and t.word not in ("#", *_AND, *name)]
    if not said or any(
        t.word not in heard.sides and number_of(t, heard) not in (1, 2) and t.value not in (1, 2) for t in said
    ):
        return False
    sides = {heard.sides.index(t.word) % 2 for t in said if t.word in heard.sides}
    if sides:
        return len(sides) == 2 and all(number_of(t, heard) in (0, 1) for t in said)
    return [t.value or number_of(t, heard) for t in said] == [1, 2] and len(tokens) > 2


def once_more(tokens: Sequence[Token], heard: Heard, name: frozenset[str], rounds: int) -> bool:
    """Whether words have a part made again and say nothing else: "Do the same for the second ear", "Crochet another one in the same way", "Other
    ear: repeat rnds 1-3" where it has three ``rounds``."""
    words = [t for t in tokens if t.word not in _MARKS and t.kind != "mark"]
    others = [t for t in words if t.word in heard.others or t.value == 2]
    numbers = [t.value for t in words if t.kind == "number" and t.word.isdigit()]
    if not others or (numbers and numbers != [1] and numbers != [1, rounds]) or len(words) > 2 * _LONGEST:
        return False
    if all(t in others or t.word in name or t.word in heard.leads for t in words):
        return False  # "Second ear" heads one
    known = {*heard.again, *heard.copied, *heard.leads, *heard.others, *heard.numbers}
    if any(
        word not in known and word not in name
        for t in words
        if t.kind not in ("number", "ordinal")
        for word in t.word.split()
    ):
        return False
    return any(t.word in name for t in words) or any(word in heard.made for t in words for word in t.word.split())

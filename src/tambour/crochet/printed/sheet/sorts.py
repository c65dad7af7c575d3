"""Printed patterns, sorts: parts under one heading that are told apart by a word alone, "PATCHES ON THE SHELL" and below it "One big:" and "Six small,
each:", or "Large, make 3: work Rounds 1 to 3 of the walls", each put as a heading of its own."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from typing import Final

from tambour.crochet.places.names import kind_of, one
from tambour.crochet.printed.parts.copied import number_of
from tambour.crochet.printed.tokens import Row, Token
from tambour.crochet.printed.wordings.vocabulary import Vocabulary
from tambour.crochet.printed.yarns.shades import shade
from tambour.crochet.words.table import TERMS, Heard

_SORTS: Final = frozenset(
    "big bigger biggest large larger largest small smaller smallest little tiny mini medium middle long short wide narrow thin thick".split()
)
_EACH: Final = frozenset((",", "each", "of", "them", "one", "ones", "(", ")", "."))
_MAKE: Final = frozenset(("make", "work", "crochet"))
_WORK: Final = frozenset(("work", "as", "like"))
_ROUNDS: Final = frozenset(("round", "rounds", "rnd", "rnds", "row", "rows"))
_NAME: Final = 8  # words of a heading
_FAR: Final = 3  # lines between it and the first sort


def sorted_out(rows: list[Row], vocabulary: Vocabulary) -> list[Row]:
    """``rows`` with each sort under the noun of the heading above it, and the yarn of that heading for each."""
    made: list[Row] = []
    noun: Token | None = None
    yarn: list[Token] = []
    near, heard = 0, TERMS[vocabulary.code].heard
    make, round_ = (TERMS[vocabulary.code].words[key][0] for key in ("make", "round"))
    for row in [part for one_ in rows for part in _inline(one_, heard)]:
        tokens = row.tokens
        if tokens and (found := _headed(tokens)) is not None:
            noun, yarn = found
            near = len(made) + _FAR
        sort = _sort(tokens, heard) if noun is not None and tokens else None
        if noun is None or sort is None or (near and len(made) > near):
            made.append(row)
            continue
        if near:
            made[near - _FAR] = replace(made[near - _FAR], marked=1)
        many, word, rest = sort
        place = tokens[0].start
        named = replace(noun, start=word.end, end=word.end, word=one(noun.word) if many < 2 else noun.word)
        signs = [Token("mark", s, word.end, word.end, None, s == ")") for s in "()"]
        said = [Token("word", make, place, place), Token("number", str(many), place, tokens[0].end, many)]
        end = rest[0].start if rest else row.end
        made.append(Row([replace(word, capital=True), named, signs[0], *said, signs[1]], row.start, end, 1))
        if yarn:
            made.append(Row([Token("word", heard.using[0], place, place, capital=True), *yarn], place, end))
        made += _rounds(rest, round_)
        near = 0
    return made


def _inline(row: Row, heard: Heard) -> list[Row]:
    """A heading and its sorts in one line as lines of their own: "DOTS (white). 3 big ones: 6 sc in ring (6) / inc around (12). 2 small: 6 sc in ring (6)"."""
    tokens = row.tokens
    cuts = [k for k in range(1, len(tokens) - 2) if tokens[k - 1].word == "." and _sort(tokens[k:], heard) is not None]
    if not cuts or (_headed(tokens[: cuts[0]]) is None and _sort(tokens, heard) is None):
        return [row]
    parts = [tokens[a:b] for a, b in pairwise([0, *cuts, len(tokens)])]
    return [replace(row, tokens=some, start=some[0].start, end=some[-1].end) for some in parts]


def _rounds(rest: list[Token], round_: str) -> list[Row]:
    """What is said of a sort behind its name: rounds that strokes part, with a head each; "work Rounds 1 to 3 of the walls" as rounds that are worked as
    those; else as it stands."""
    if not rest:
        return []
    cuts = [k for k, t in enumerate(rest) if t.word == "/"]
    if not cuts:
        at = 1 if rest[0].word in _WORK else 0
        refers = len(rest) > at and rest[at].word in _ROUNDS and not any(t.word in (":", ".") for t in rest[:-1])
        led = [Token("word", "as", rest[0].start, rest[0].start)] if refers else []
        return [Row([*led, *rest], rest[0].start, rest[-1].end)]
    made = []
    for n, (a, b) in enumerate(pairwise([-1, *cuts, len(rest)]), 1):
        some = rest[a + 1 : b]
        if some:
            at = some[0].start
            head = [
                Token("word", round_, at, at, None, False, True),
                Token("number", str(n), at, at, n),
                Token("mark", ":", at, at),
            ]
            made.append(Row([*head, *some], at, some[-1].end))
    return made


def _headed(tokens: list[Token]) -> tuple[Token, list[Token]] | None:
    """The noun of parts that a line heads, and its yarn; None where it is no such heading."""
    words = [t for t in tokens if t.kind == "word"]
    if (
        not words
        or len(words) > _NAME - 2
        or not words[0].capital
        or tokens[0].kind != "word"
        or any(t.kind == "number" for t in tokens)
    ):
        return None
    name = next((k for k, t in enumerate(tokens) if t.word in (".", ",", "(", "-", ":", "on", "for")), len(tokens))
    noun = tokens[name - 1] if name else None
    if noun is None or one(noun.word) == noun.word or not kind_of(one(noun.word)):
        return None
    behind = next((k for k, t in enumerate(tokens) if t.word in (".", ",", "(", "-", ":")), len(tokens))
    yarn = [t for t in tokens[behind:] if t.kind == "word"]
    return (noun, yarn) if not yarn or shade(" ".join(t.word for t in yarn)) is not None else None


def _sort(tokens: list[Token], heard: Heard) -> tuple[int, Token, list[Token]] | None:
    """How many a line heads of one sort, its word, and what stands behind: "Six small, each:", "Large, make 3: …"; None where it is none."""
    colon = next((k for k, t in enumerate(tokens[:_NAME]) if t.word == ":"), 0)
    head, rest = tokens[:colon], tokens[colon + 1 :]
    if len(head) < 2:
        return None
    if (many := number_of(head[0], heard)) and head[1].word in _SORTS:
        return (many, head[1], rest) if all(t.word in _EACH for t in head[2:]) else None
    copies = [many for t in head[1:] if (many := number_of(t, heard))]
    plain = all(t.word in (*_EACH, *_MAKE) or number_of(t, heard) for t in head[1:])
    made = any(t.word in _MAKE for t in head[1:])
    return (copies[0], head[0], rest) if head[0].word in _SORTS and made and plain and len(copies) == 1 else None

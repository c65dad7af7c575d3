"""Printed patterns, sorts: parts under one heading that are told apart by a word alone, "PATCHES ON THE SHELL" and below it "One big:" and "Six small,
each:", each put as a heading of its own."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

from tambour.crochet.places.names import kind_of, one
from tambour.crochet.printed.parts.copied import number_of
from tambour.crochet.printed.tokens import Row, Token
from tambour.crochet.printed.wordings.vocabulary import Vocabulary
from tambour.crochet.printed.yarns.shades import shade
from tambour.crochet.words.table import TERMS

_SORTS: Final = frozenset(
    "big bigger large larger small smaller little tiny medium long short wide narrow thin thick".split()
)
_EACH: Final = frozenset((",", "each", "of", "them", ":", "."))
_NAME: Final = 6  # words of a heading
_FAR: Final = 3  # lines between it and the first sort


def sorted_out(rows: list[Row], vocabulary: Vocabulary) -> list[Row]:
    """``rows`` with each sort under the noun of the heading above it, and the yarn of that heading for each."""
    made: list[Row] = []
    noun: Token | None = None
    yarn: list[Token] = []
    near, heard = 0, TERMS[vocabulary.code].heard
    for row in rows:
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
        many, word = sort
        place = tokens[0].start
        named = replace(noun, start=word.end, end=word.end, word=one(noun.word) if many < 2 else noun.word)
        signs = [Token("mark", s, word.end, word.end, None, s == ")") for s in "()"]
        make = Token("word", TERMS[vocabulary.code].words["make"][0], place, place)
        number = Token("number", str(many), place, tokens[0].end, many)
        made.append(Row([replace(word, capital=True), named, signs[0], make, number, signs[1]], row.start, row.end, 1))
        if yarn:
            made.append(Row([Token("word", heard.using[0], place, place, capital=True), *yarn], place, row.end))
        near = 0
    return made


def _headed(tokens: list[Token]) -> tuple[Token, list[Token]] | None:
    """The noun of parts that a line heads, and its yarn; None where it is no such heading."""
    words = [t for t in tokens if t.kind == "word"]
    if (
        not words
        or len(words) > _NAME
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


def _sort(tokens: list[Token], heard: object) -> tuple[int, Token] | None:
    """How many a line heads of one sort, and its word: "Six small, each:"; None where it is none."""
    many = number_of(tokens[0], heard)  # type: ignore[arg-type]
    if not many or len(tokens) < 3 or tokens[1].word not in _SORTS or tokens[-1].word != ":":
        return None
    return (many, tokens[1]) if all(t.word in _EACH for t in tokens[2:]) else None

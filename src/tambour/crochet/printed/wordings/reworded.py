"""Printed patterns, reworded: words of a line put as other words, which stand at the same characters."""

from __future__ import annotations

import re
from itertools import accumulate

from tambour.crochet.printed.tokens import Token
from tambour.crochet.words.sayings import Sayings


def reworded(tokens: list[Token], sayings: Sayings[str]) -> list[Token]:
    """``tokens`` with whatever each of the ``sayings`` finds in their words as what it means; the same list where none finds anything."""
    words = " ".join([t.word for t in tokens])
    k = sayings.next(words)
    while k < sayings.n:
        said, meant = sayings[k]
        if said.search(words):
            tokens = _put(tokens, said, meant)
            words = " ".join([t.word for t in tokens])
        k = sayings.next(words, k + 1)
    return tokens


def _put(tokens: list[Token], said: re.Pattern[str], meant: str) -> list[Token]:
    """``tokens`` with what ``said`` finds in their words as ``meant``, whose numbers in braces are its groups."""
    words = " ".join([t.word for t in tokens])
    found = list(said.finditer(words))
    if not found:
        return tokens
    begins = [0, *accumulate(len(t.word) + 1 for t in tokens)]
    made: list[Token] = []
    done = 0
    for one in found:
        first, last = between(begins, one.start(), one.end())
        if last <= first:
            continue
        made += tokens[done:first]
        for one_word in meant.split():
            if one_word[0] == "{":
                at = one.span(int(one_word[1:-1]))
                if at[0] < 0:
                    continue  # a group that took no part
                a, b = between(begins, *at)
                within = at[0] not in begins  # the 3 of "x3"
                made += [word(one[int(one_word[1:-1])], tokens[first], tokens[last - 1])] if within else tokens[a:b]
            else:
                made.append(word(one_word, tokens[first], tokens[last - 1]))
        done = last
    return [*made, *tokens[done:]]


def between(begins: list[int], start: int, end: int) -> tuple[int, int]:
    """The tokens that stand from one character of the words to another."""
    first = next((k for k, at in enumerate(begins) if at >= start), len(begins) - 1)
    last = next((k for k, at in enumerate(begins) if at >= end), len(begins) - 1)
    return first, last


def word(said: str, first: Token, last: Token) -> Token:
    """A token of another word, at the characters from one token to another."""
    number = said.isdigit()
    kind = "number" if number else "word" if said[0].isalpha() else "mark"
    return Token(kind, said, first.start, last.end, int(said) if number else None, False, first.capital)

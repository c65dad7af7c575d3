"""Printed patterns, lumps: whole sections on one line, as pages come out of a browser: headings, rounds, sentences and abbreviations each on a line again."""

from __future__ import annotations

from itertools import pairwise
from typing import Final

from tambour.crochet.printed.sheet.runs import round_starts
from tambour.crochet.printed.tokens import Row, Token
from tambour.crochet.printed.wordings.vocabulary import Vocabulary

_ROUNDS: Final = 3
"""A line of so many rounds is several."""
_TERMS: Final = 3
"""A line of so many abbreviations too."""
_NAME: Final = 4
"""Words of a part's name."""
_TITLES: Final = frozenset(("abbreviations", "abbreviation", "terms", "stitches"))
_DOING: Final = frozenset(
    """start begin beginning stuff fasten cut leave do don't place insert attach sew stitch weave close with using use work make change join continue
    crochet pull put add fill finish note now then repeat mark""".split()
)
"""What sentences of doing begin with; behind a title they are no part of it."""


def unlumped(rows: list[Row], vocabulary: Vocabulary) -> list[Row]:
    """``rows`` with those that hold a whole section parted: before its numbered titles, its rounds, and what is done behind a count."""
    made: list[Row] = []
    for row in rows:
        tokens = row.tokens
        places: set[int] = set()
        if len(tokens) > 8 and tokens[0].word in _TITLES:
            places = _terms(tokens)
        elif len(tokens) > 30:
            places = _section(tokens, round_starts(tokens, vocabulary), vocabulary)
        if not places:
            made.append(row)
            continue
        for a, b in pairwise([0, *sorted(places - {0}), len(tokens)]):
            some = tokens[a:b]
            while some and some[-1].word in ("-", ";", ","):
                some = some[:-1]
            if some:
                made.append(Row(some, some[0].start, some[-1].end, row.marked if not a else 0))
    return made


def _terms(tokens: list[Token]) -> set[int]:
    """Where abbreviations begin in a line of them: "Abbreviations MR: Magic Ring sc: Single crochet"."""
    places = {k - 1 for k in range(2, len(tokens)) if tokens[k].word in (":", "=") and tokens[k - 1].kind == "word"}
    first = min(places, default=0)
    while first > 1 and tokens[first - 1].kind == "word" and not tokens[first - 1].capital and first - 1 in places:
        first -= 1
    return places | {first} if len(places) >= _TERMS else set()


def _section(tokens: list[Token], rounds: list[int], vocabulary: Vocabulary) -> set[int]:
    """Where lines begin in a section whose ``rounds`` begin there."""
    if sum(k > 0 and _closes(tokens[k - 1]) for k in rounds) < _ROUNDS:
        return set()  # "—12 sts. Round 3: …" is read as it stands
    places = set(rounds)
    title = 1  # the number of the next
    for k in range(1, len(tokens) - 1):
        token, before = tokens[k], tokens[k - 1]
        ended = before.word in (".", ")", "]", "}", "!", "-", ";")
        titled = token.kind == "number" and tokens[k + 1].word == "." and tokens[k + 1].glued and not token.glued
        titled = titled and k + 2 < len(tokens) and tokens[k + 2].capital
        if titled and (ended or (token.value == title and k - 1 not in places)):
            places.add(k)  # "2. Arms (make 2)"
            title = int(token.value) + 1 if isinstance(token.value, int) else title
        elif (
            (token.word == "(" and tokens[k + 1].word == "make")
            or (token.word == "with" and token.capital)
            or k in rounds
        ):
            begin = k
            while begin > max(0, k - _NAME) and (tokens[begin - 1].kind == "ordinal" or _named(tokens[begin - 1])):
                begin -= 1
            if begin < k and begin and tokens[begin - 1].word in (".", ")"):
                places.add(begin)  # "Fasten off. OUTER EAR (make 2) With A, ch 2.", "Fasten off. 2nd Fin Row 1: …"
        elif token.word == ":" and k + 1 in rounds:
            begin = k - 1
            while begin > max(0, k - _NAME) and tokens[begin].kind == "word" and not tokens[begin].capital:
                begin -= 1
            while begin > max(0, k - _NAME) and tokens[begin - 1].kind == "word" and tokens[begin - 1].capital:
                begin -= 1
            if tokens[begin].capital and tokens[begin - 1].word == ".":
                places.add(begin)  # "Start with the shoe colour. Left Leg: Round 1: …"
        elif (
            token.capital
            and token.kind == "word"
            and len(token.word) > 1
            and token.word != "with"  # a title goes on with its yarn and its chain
            and (_closes(before) or (before.word == "-" and _closes(tokens[k - 2])))
            and vocabulary.read([token])[:1] != []
            and vocabulary.read([token])[0].kind != "stitch"
        ):
            places.add(k)  # "(18) Stuff firmly", "= (60) Placing the eyes:"
        elif token.capital and token.word in _DOING and _entitled(tokens, k, places):
            places.add(k)  # "2. Legs and body Start with the shoe colour"
    return places


def _named(token: Token) -> bool:
    """Whether a word may be of a part's name."""
    return token.kind == "word" and token.capital and token.word not in _DOING


def _closes(token: Token) -> bool:
    return token.word in (")", "]", "}")


def _entitled(tokens: list[Token], k: int, places: set[int]) -> bool:
    """Whether a numbered title, and no sentence, goes before ``k``."""
    begin = max((p for p in places if p < k), default=0)
    titled = tokens[begin].kind == "number" and tokens[begin + 1].word == "."
    return titled and k > begin + 2 and not any(t.word in (".", ":", ";") for t in tokens[begin + 2 : k])

"""Printed patterns, the language they are in: US or UK terms, letters, or one of the other tables."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise
from typing import Final

from tambour.core.errors import Span
from tambour.crochet.language.source import Source
from tambour.crochet.printed.restated import printed_in
from tambour.crochet.printed.tokens import Row, Token
from tambour.crochet.words.table import TERMS

_ABOUT: Final = frozenset(
    ("terms", "term", "terminology", "abbreviations", "crochet", "pattern", "stitches", "notation", "instructions")
)
_US: Final = ("sc", "hdc", "scs", "hdcs", "sctog")
_UK: Final = ("htr", "htrs", "dtr", "miss", "htrtog", "yrh", "tension")
_GAUGE: Final = frozenset(("measure", "measures", "tension", "gauge", "cm", "cms", "square"))
_LOOKED_AT: Final = 3000  # lines


@dataclass(frozen=True)
class Language:
    """The terms of a pattern: ``code``; ``span``: the words that say so, None when they were recognised."""

    code: str
    span: Span | None = None


def recognised(source: Source, rows: list[Row]) -> Language:
    """The terms that a text is written in; when they cannot be told, a doubt that names both readings."""
    printed = printed_in(source.text.text)
    if printed is not None:
        return Language(printed.code)
    rows = [row for row in rows if row.tokens][:_LOOKED_AT]
    said = _said(rows)
    if said is not None and said.code == "uk" and said.span is not None and _worked(rows, _US) >= _SURE:
        told = "this says UK terms, and its rounds are worked in sc, which UK terms have none of: US terms are taken"
        source.doubt(told, "say it in the text: @terms = uk, or @terms = us", said.span)
        return Language("us", said.span)
    if said is not None:
        return said
    words: dict[str, int] = {}
    for row in rows:
        for token in row.tokens:
            if token.kind == "word":
                plain = token.word.translate(_DIGITS)
                words[plain] = words.get(plain, 0) + 1
    foreign = _foreign(rows, words)
    if foreign:
        return Language(foreign)
    us = sum(words.get(w, 0) for w in _US) + _pairs(rows, "single", "crochet") + _pairs(rows, "half", "double")
    uk = sum(words.get(w, 0) for w in _UK) + _pairs(rows, "half", "treble") + _pairs(rows, "double", "treble")
    if not us and not words.get("dc") and _letters(source, rows) >= _FEW:
        return Language("letters")
    if us or not (uk or words.get("dc") or words.get("dctog") or words.get("tr") or _pairs(rows, "double", "crochet")):
        return Language("us")
    if uk:
        return Language("uk")
    rings = _rings(rows)
    tall = _chains(rows)
    if rings and max(rings) <= 7 and not tall:
        return Language("uk")
    if not tall and (not rings or min(rings) < 10):
        at = next(t for row in rows for t in row.tokens if t.word.startswith(("dc", "tr", "double")))
        source.doubt(
            "US or UK terms? In US terms dc is a double crochet, in UK terms a single one; US is taken",
            "say it in the text: @terms = uk, or @terms = us",
            at.span,
        )
    return Language("us")


def _worked(rows: list[Row], stitches: tuple[str, ...]) -> int:
    """How often rounds, on lines that begin with a round or a number, name any of these stitches."""
    rounds = [
        r.tokens
        for r in rows
        if r.tokens[0].kind in ("number", "ordinal") or r.tokens[0].word.rstrip("0123456789") in _ROUNDS
    ]
    return sum(t.word in stitches for tokens in rounds for t in tokens)


_SURE: Final = 4
"""So often do rounds name a stitch that the terms a text says have not, before it is not believed."""
_FEW: Final = 3
"""Letters that stand for stitches, of a text that is in letters."""
_SHAPED: Final = frozenset("inc dec incs decs increase decrease".split())
_ROUNDS: Final = frozenset("r rd rnd rnds round rounds row rows".split())
_DIGITS: Final = str.maketrans("", "", "0123456789")


@lru_cache(maxsize=1)
def _called() -> dict[str, str]:
    """What texts call a language → its code; "" for words that say it only with the next ones."""
    return {"u": "", "english": "", **{word: code for code, terms in TERMS.items() for word in terms.called}}


def _said(rows: list[Row]) -> Language | None:
    called = _called()
    for row in rows:
        tokens = row.tokens
        if tokens[0].word == "@" and len(tokens) >= 4 and tokens[1].word == "terms":
            code = called.get(tokens[3].word, tokens[3].word)
            if code in TERMS:
                return Language(code, Span(tokens[0].start, tokens[3].end))
        for k, token in enumerate(tokens):
            code = called.get(token.word, "")
            near = tokens[k + 1 : k + 4]
            if token.word == "u" and len(near) >= 2 and near[0].word == "." and near[1].word in ("s", "k"):
                code, near = ("us" if near[1].word == "s" else "uk"), tokens[k + 3 : k + 6]
            if token.word == "english" and _british(tokens, k):
                code = "uk"
            if not code:
                continue
            about = next((t for t in near[:2] if t.word in _ABOUT), None)
            about = None if near and near[0].kind == "mark" and near[0].word != "-" else about
            if about is not None and not (code == "us" and token.word == "us" and _lower(row, token)):
                return Language(code, Span(token.start, about.end))
    return None


def _british(tokens: list[Token], k: int) -> bool:
    """Whether "English" means terms, and no language: "(English terms used)", beside none of the US."""
    terms = k + 1 < len(tokens) and tokens[k + 1].word in ("terms", "terminology")
    return terms and not any(t.word in ("us", "usa", "american", "u", "in") for t in tokens)


def _lower(row: Row, token: Token) -> bool:
    """A lone pronoun: "tell us crochet is fun"."""
    return row.tokens[0] is not token and len(row.tokens) > 12


def _pairs(rows: list[Row], one: str, other: str) -> int:
    return sum(
        [a.word == one and b.word in (other, other + "s") for row in rows for a, b in zip(row.tokens, row.tokens[1:])]
    )


def _foreign(rows: list[Row], words: dict[str, int]) -> str:
    """The code of another language whose stitches the text names more than the English ones."""

    def score(code: str) -> int:
        return sum(n for word, n in words.items() if word in _own(code))

    english = max(score("us"), score("uk"))
    best = max((code for code, terms in TERMS.items() if terms.base != "us"), key=score, default="")
    return best if best and score(best) > english else ""


@lru_cache(maxsize=16)
def _own(code: str) -> frozenset[str]:
    """First words of a language's stitches, rings, rounds and rows."""
    table = TERMS[code]
    said = (*table.stitches.values(), *(table.words[key] for key in ("ring", "round", "row", "stitch")))
    found = {s.lower().split()[0].translate(_DIGITS) for spellings in said for s in spellings}
    return frozenset(word for word in found if len(word) > 1)


def _letters(source: Source, rows: list[Row]) -> int:
    """How many capital letters stand for stitches: ``6X``, ``V``, ``(X, V)``."""
    text = source.text.text
    found = [
        (token.word, text[token.start].isupper())
        for row in rows
        for k, token in enumerate(row.tokens)
        if token.word in ("x", "v", "a", "t", "f") and _beside(row.tokens, k)
    ]
    capitals = sum(capital for _, capital in found)
    if capitals < _FEW and sum(word == "v" for word, _ in found) > 1 and len(found) > _FEW:
        return len(found) if not any(t.word in _SHAPED for row in rows for t in row.tokens) else capitals
    return capitals


def _beside(tokens: list[Token], k: int) -> bool:
    before = tokens[k - 1] if k else None
    after = tokens[k + 1] if k + 1 < len(tokens) else None
    if before is not None and before.word == ":" and tokens[k].word in ("v", "x") and after is not None:
        return after.kind == "number" or after.word == "*"  # "R2: V*6"
    return (before is not None and (before.kind == "number" or before.word in "([,*")) and (
        after is None or after.kind == "mark" or after.kind == "number" or after.word == "in"
    )


def _chains(rows: list[Row]) -> bool:
    """Whether rounds begin with two or three chains, as they do under tall stitches."""
    pairs = ((a.word, b.value) for row in rows for a, b in pairwise(row.tokens))
    return sum(word in ("ch", "chain") and number in (2, 3) for word, number in pairs) >= 2


def _rings(rows: list[Row]) -> list[int]:
    """How many dc the magic rings of a text begin with."""
    found = []
    for row in rows:
        words = [t.word for t in row.tokens]
        if not {"ring", "mr", "circle", "loop", "hook"} & set(words) or not _GAUGE.isdisjoint(words):
            continue
        for k, token in enumerate(row.tokens[:-1]):
            if token.kind == "number" and isinstance(token.value, int) and row.tokens[k + 1].word in ("dc", "double"):
                found.append(token.value)
            elif token.word == "dc" and row.tokens[k + 1].kind == "number" and isinstance(row.tokens[k + 1].value, int):
                found.append(row.tokens[k + 1].value)
    return found

"""Printed patterns, the preface: size, yarn, hook and fibre that the lines before the first part tell without a heading of their own."""

from __future__ import annotations

import re
from functools import lru_cache
from typing import Final

from tambour.core.errors import Span
from tambour.crochet.printed.state import State
from tambour.crochet.printed.tokens import Row, Token
from tambour.crochet.words.table import TERMS
from tambour.crochet.yarns import class_of, hook_of, tells_gauge

FIBRES: Final = ("cotton", "acrylic", "chenille", "mohair", "wool")
"""What yarn may be of, as :attr:`CrochetParams.material` calls it, and the table of words says it."""

_CLAUSE: Final = re.compile(r"(?:[^.!?|;•,\n]|[.!?](?!\s+[A-Z])(?!(?<!approx\.)(?<!ca\.)(?<!no\.)\s+\d)|,(?!\s))+")
_SENTENCE: Final = re.compile(r"[^\s.!?](?:[^.!?\n]|[.](?=\d)|[.](?=[xX ]*[a-z]))*")
"""A sentence of a line, with the points of its numbers."""
_LENGTH: Final = re.compile(r"(?<![\d.,])\d+(?:[.,]\d+)?\s*(?:cm\b|inch(?:es)?\b|ins?\b|\"|″|”)", re.IGNORECASE)
_OTHER: Final = ("hook", "round", "row", "stitch", "eyes", "yarn", "gauge", "leave", "ring", "stuff", "foundation")
"""What a length is of that is no size of the toy."""
_SIZED: Final = re.compile(r"(?:size|#)\s*#?\s*\d", re.IGNORECASE)


def prefaced(p: State, row: Row, tokens: list[Token]) -> None:
    """Takes what a line above the first part tells of the toy's size, its yarn and the hook, where no heading says it."""
    if p.parts or p.mode == "abbreviations":
        return
    begin = row.tokens[0].start
    line = p.source.text.text[begin : row.tokens[-1].end]
    fibre = _fibre(p.language.code, line)
    if fibre is not None and (_whole(line) or class_of(line) or any(t.value == "yarn" for t in tokens)):
        p.hinted.setdefault("fibre", (fibre, Span(begin, begin + len(line))))
    for told in _SENTENCE.finditer(line):
        if tells_gauge(told[0]):
            span = Span(begin + told.start(), begin + told.end())
            p.hinted.setdefault("gauge", (" ".join(told[0].split()), span))
    if p.mode == "materials" or p.below:
        return
    sized: list[Span] = []
    for clause in _CLAUSE.finditer(line):
        words = clause[0]
        span = Span(begin + clause.start(), begin + clause.end())
        keys = {t.value for t in tokens if t.kind == "key" and span.start <= t.start < span.end}
        if _LENGTH.search(words) and not keys & set(_OTHER) and _size(p.language.code).search(words):
            sized.append(span)
        if "hook" in keys and hook_of(words) is not None:
            p.hinted.setdefault("hook", (words.strip(), span))
        if ("yarn" in keys or fibre is not None) and class_of(_SIZED.sub("", words)):
            p.hinted.setdefault("yarn", (words.strip(), span))
            p.palette.listed(line, begin)
    if sized:
        span = Span(sized[0].start, sized[-1].end)
        p.hinted.setdefault("size", (p.source.text.text[span.start : span.end].strip(" *_#|."), span))


def _whole(line: str) -> bool:
    return re.search(r"\b100\s?%", line) is not None


@lru_cache(maxsize=16)
def _size(code: str) -> re.Pattern[str]:
    return _any(TERMS[code].heard.said.get("size", ()))


@lru_cache(maxsize=64)
def _of(code: str, fibre: str) -> re.Pattern[str]:
    return _any(TERMS[code].heard.said.get(fibre, ()))


def _any(words: tuple[str, ...]) -> re.Pattern[str]:
    return re.compile(rf"\b(?:{'|'.join(map(re.escape, words)) or '(?!)'})\b", re.IGNORECASE)


def _fibre(code: str, line: str) -> str | None:
    """The one fibre that a line names; None where it names none, or a blend."""
    found = [fibre for fibre in FIBRES if _of(code, fibre).search(line)]
    return found[0] if len(found) == 1 else None

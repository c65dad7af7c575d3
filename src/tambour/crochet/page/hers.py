"""Hers: what the designer's own text says besides the rounds: its introduction, its notes, its sentences between rounds."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import Final

from tambour.core.errors import Span
from tambour.crochet.language.tree import Pattern
from tambour.crochet.page.instructions import by_people
from tambour.crochet.words.table import TERMS

_HEAD: Final = re.compile(r"^[\s#*_=|]*(.*?)[\s*_=:|]*$")
_LISTED: Final = ("materials", "abbreviations", "gauge", "finished size", "special stitches", "yarn", "hook", "eyes")
_MORE: Final = frozenset(
    [
        "supplies",
        "you will need",
        "what you need",
        "tools",
        "tension",
        "size",
        "measurements",
        "finished measurements",
        "stitches used",
        "terms",
        "stitch guide",
        "legend",
        "special stitch",
        "notions",
        "skills",
        "safety eyes",
        "material",
    ]
)
_ASSEMBLY: Final = frozenset(
    [
        "assembly",
        "finishing",
        "making up",
        "to make up",
        "assembling",
        "putting it together",
        "to finish",
        "sewing",
        "sewing up",
        "finishing touches",
        "details",
        "face",
        "final assembly",
    ]
)
_BULLET: Final = re.compile(r"^[\s#>*•–-]+(?=\S)")
_SENTENCE: Final = re.compile(r"(?<=[.!?])\s+(?=[A-ZÀ-Þ\"“(])")
_LETTER: Final = re.compile(r"[^\W\d_]{2}")


@dataclass
class Hers:
    """A designer's sentences. intro : before the parts; closing : after them, but what puts the parts together.

    inside : place of a part among the pattern's → (the round after which it stands, 0 before the first; sentence)
    """

    intro: list[str] = field(default_factory=list)
    inside: dict[int, list[tuple[int, str, Span]]] = field(default_factory=dict)
    closing: list[str] = field(default_factory=list)


def hers(pattern: Pattern, code: str) -> Hers | None:
    """What the text says in its designer's words; None where it is tambour's own or another language is asked for."""
    text = pattern.text.text
    terms = TERMS.get(pattern.terms)
    if terms is None or pattern.terms != code:
        return None
    if not by_people(pattern):
        return None
    made = Hers()
    spoken = [s.lower() for name in _LISTED for s in (terms.word(name), name)]
    listed = {*_MORE, *spoken}
    assembly = {*_ASSEMBLY, terms.word("assembly").lower()}
    lines = [(m.start(), m.end(), m[0]) for m in re.finditer(r"[^\n]+", text)]
    starts = sorted((s.span.start, k) for k, s in enumerate(pattern.parts))
    heads = {text.rfind("\n", 0, a) + 1 for a, _ in starts}
    last = starts[-1][0] if starts else len(text)
    after = next((a for a, _, line in lines if a > last and _plain(line) in assembly), len(text))
    title = " ".join(pattern.stated["title"][0].split()).lower() if "title" in pattern.stated else ""
    named = [part.span for part in pattern.parts]
    covered = [line.span for part in pattern.parts for line in part.lines]
    loose = [s for s in pattern.passed if any(c.start < s.start and s.end <= c.end for c in covered)]
    finishing = {_span(record) for record in pattern.finish}
    mode = ""
    for a, b, line in lines:
        plain = _plain(line)
        if a < (starts[0][0] if starts else 0) and a not in heads:
            if plain in listed or plain.rstrip("s") in listed:
                mode = "listed"
            elif plain in ("notes", "note", "pattern notes", "tips") or (
                mode and not _BULLET.match(line) and len(plain) > 60
            ):
                mode = ""
            elif mode == "" and plain != title and _LETTER.search(plain) and not _stated(pattern, a, b):
                made.intro.append(_clean(line))
        elif a >= after:
            made.closing += (
                [] if plain in assembly else [s for s, span in _sentences(text, a, b) if not _among(span, finishing)]
            )
        else:
            part = max(((start, k) for start, k in starts if start <= a), default=(0, 0))[1]
            for words, span in _sentences(text, a, b):
                if not any(c.start < span.end and span.start < c.end for c in named if a in heads) and not any(
                    c.start < span.end and span.start < c.end for c in covered
                ):
                    made.inside.setdefault(part, []).append((_round(pattern, part, span.start), words, span))
    for span in loose:
        part = max(((start, k) for start, k in starts if start <= span.start), default=(0, 0))[1]
        words = _clean(text[span.start : span.end])
        if _LETTER.search(words):
            made.inside.setdefault(part, []).append((_round(pattern, part, span.start), words, span))
    for said in made.inside.values():
        said.sort(key=lambda one: one[2].start)
    return made


def _plain(line: str) -> str:
    found = _HEAD.match(line)
    return found[1].strip().lower() if found else ""


def _clean(words: str) -> str:
    words = " ".join(_BULLET.sub("", words).replace("**", "").split())
    return words if not words or words[-1] in ".!?:" else f"{words}."


def _sentences(text: str, a: int, b: int) -> list[tuple[str, Span]]:
    """The sentences of a line, with their places; headings and bare counts are none."""
    made = []
    at = a
    for piece in _SENTENCE.split(text[a:b]):
        begin = text.index(piece, at)
        at = begin + len(piece)
        words = _clean(piece)
        if _LETTER.search(words):
            made.append((words, Span(begin, at)))
    return made


def _round(pattern: Pattern, part: int, at: int) -> int:
    """The number of the last round of a part that stands before a place of the text."""
    return max((x.number + x.times - 1 for x in pattern.parts[part].lines if x.number and x.span.start < at), default=0)


def _stated(pattern: Pattern, a: int, b: int) -> bool:
    """Whether a line says something that is told elsewhere: its gauge, its size."""
    return any(a <= span.start < b for key, (_, span) in pattern.stated.items() if key != "title")


def _span(record: object) -> tuple[int, int]:
    span = getattr(record, "span", Span(0, 0))
    return span.start, span.end


def _among(span: Span, spans: set[tuple[int, int]]) -> bool:
    return any(a < span.end and span.start < b for a, b in spans)

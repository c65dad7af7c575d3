"""Doubted: rounds that were not understood as the designer says them; they are printed in her words, never in ours."""

from __future__ import annotations

import re
from typing import Final

from tambour.core.errors import Span
from tambour.crochet.language.tree import Action, Line, Pattern
from tambour.crochet.words.table import Terms

_OTHERWISE: Final = ("is not drawn", "is drawn as", "both loops are taken", "approximated")
"""What is said where the pictures have something else than the text."""
_COUNT: Final = re.compile(r"[\s\-–—=:.,(\[{]*\d+\s*(?:\w+)?[)\]}]?\W*$")
_STITCHES: Final = r"(?:sts?|stitches|total|in all|[Mm]aschen|[Mm]|mailles|puntos|steken)\b"
"""What is counted behind a round, that no hook works."""
_JOINT: Final = r"(?:-|–|—|to|and|&|,|bis|und|a|y|à|et|t/m|tot|en)"


def doubted(pattern: Pattern) -> frozenset[Span]:
    """The lines of rounds that are not worked as they say: taken from their counts, with words that nobody read, or drawn otherwise."""
    told = [p.span for p in pattern.unread if p.span is not None]
    told += [p.span for p in pattern.warnings if p.span is not None and any(w in p.message for w in _OTHERWISE)]
    told = [span for span in told if span.end > span.start]
    return frozenset(
        line.span
        for part in pattern.parts
        for line in part.lines
        if line.in_round
        and (_gap(line) or any(line.span.start <= span.start and span.end <= line.span.end for span in told))
    )


def _gap(line: Line) -> bool:
    """Whether a round is worked from a count, its own or one that is stated below."""
    return any(isinstance(item, Action) and item.name == "gap" for item in line.items)


def her_words(pattern: Pattern, line: Line, terms: Terms, count: int = 0) -> str:
    """What a line says, without the number of its round and its ``count``, which stand beside it."""
    begin, end = line.span.start, line.span.end
    text, stated = pattern.text.text, line.stated_span
    words = text[begin:end]
    if stated is not None and begin < stated.start < end and _COUNT.fullmatch(text[stated.start : end]):
        words = text[begin : stated.start].rstrip(" \t-–—=:([{")
    if line.number is not None:
        spelt = {re.escape(w) for key in ("round", "row") for w in terms.words[key]} | {
            "rounds?",
            "rnds?",
            "rows?",
            "rd",
            "r",
        }
        named = rf"(?:{'|'.join(sorted(spelt, key=len, reverse=True))})\.?\s*"
        numbers = rf"\d+(?:st|nd|rd|th)?(?:\s*{_JOINT}\s*(?:{named})?\d+(?!\s*[^\W\d]))*"
        head = rf"^[\W_]*(?:{named}{numbers}\s*[^\w\s(\[*]*|{numbers}\s*[^\w\s(\[*]+)\s*"
        words = re.sub(head, "", words, count=1, flags=re.IGNORECASE)
    if count:  # "(18)", "= 14"
        words = re.sub(
            rf"(?:\s*[-–—:]*\s*[(\[{{=]\s*{count}(?:\s+[^\W\d]+\.?)?|(?<=[.;,])\s+{count}(?:\s+{_STITCHES}\.?)?)\s*[)\]}}]?\W*$",
            "",
            words,
        )  # but no "ch 1, 9 sc", which is worked
    return re.sub(r"\\([*_\[\]()-])", r"\1", " ".join(words.split()))  # as Markdown escapes them

"""Undrawn: what a designer tells and no picture has: embroidery, edgings, poses, in her own words."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Final

from tambour.core.errors import Span
from tambour.crochet.language.finishes import Embroidery, Eye, Felt, Hair
from tambour.crochet.page.answered import meet
from tambour.crochet.page.book import Book
from tambour.crochet.places.names import Made, mentions
from tambour.crochet.words.gloss import english

_DECOR: Final = re.compile(
    r"\b(?:embroider\w*|french knots?|cross(?:es)?|knobs?|planks?|edging|veins?|grooves?|stripes? (?:on|across|over)|bands? (?:on|across|over)"
    r"|whiskers?|nostrils?|mouth|smile|eyebrows?|brows|(?:eye)?lashes|blush|freckles|(?:long|short|straight|small|tiny|little)(?: \w+){0,2} (?:stitch(?:es)?|lines?))\b",
    re.IGNORECASE,
)
"""What is put on by needle and thread when a part is made."""
_PUT: Final = re.compile(
    r"\b(?:embroider\w*|sew\w*|stitch\w*|make|work|add|draw|edging|in|with|across|over|like)\b", re.IGNORECASE
)
_POSE: Final = re.compile(
    r"\b(?:bring|wrap|curl|bend|twist) (?:it|them|the|her|his|its|their)\b|\bturn it to (?:her|his|the)\b|\b(?:catch|tack) the\b|\bpull (?:it|its|the)\b[^.;]{0,30}\b(?:down|up|in)\b",
    re.IGNORECASE,
)
"""How a part is held in another way than it was sewn on."""
_NONE: Final = re.compile(
    r"\b(?:no|inside|behind|outside|above|below|under|beside|without|around) (?:the |any )?(?:\w+ )?(?:edging|smile|mouth|cheeks|cross)\b|\bwith (?:small|tiny|little|short|neat) stitch\w*|\bembroider\b[^.]*\binstead\b",
    re.IGNORECASE,
)
"""What is named only to say where something else is, or that it is not there."""
_NAMES: Final = 3
"""A clause of fewer words names what the next ones tell."""
_CLAUSE: Final = re.compile(r"[^.;:!?(),]+")
_MOST: Final = 11
"""So many words of a clause are quoted."""


def undrawn(book: Book) -> list[str]:
    """The clauses of hers that tell what no picture has, in their order."""
    return list(dict.fromkeys(_clauses(book)))


def _clauses(book: Book) -> Iterator[str]:
    hers, pattern = book.hers, book.piece.built.pattern
    if hers is None or book.code not in ("us", "uk", "letters"):
        return
    drawn = [r.span for r in pattern.finish if isinstance(r, Embroidery | Felt | Hair | Eye)]
    parts = [Made(part.name, part.copies) for part in pattern.parts]
    said = [*(one for some in hers.inside.values() for one in some), *hers.finishing]
    for _, span in sorted(said, key=lambda one: one[1].start):
        text = pattern.text.text[span.start : span.end]
        for m in _CLAUSE.finditer(text):
            words = " ".join(m[0].split()).strip(" -–—")
            here = Span(span.start + m.start(), span.start + m.end())
            decor, pose = _DECOR.search(_NONE.sub("", words)), _POSE.search(words)
            if len(words.split()) < _NAMES and pose is None:  # "Edging, light gray - …": with what follows
                here, words = span, " ".join(text.split()).strip(" .")
            if pose is None and (decor is None or not _PUT.search(text) or any(meet(here, one) for one in drawn)):
                continue
            if pose is None and _is_part(words, parts, pattern.terms, decor[0] if decor is not None else ""):
                continue
            short = words.split()
            yield " ".join(short[:_MOST]) + ("…" if len(short) > _MOST else "")


def _is_part(words: str, parts: list[Made], code: str, noun: str) -> bool:
    """Whether what a clause speaks of is a part that is crocheted: "the smile" sewn on."""
    low = english(words, code).text.lower()
    return any(noun.lower().rstrip("s") in found.word for found in mentions(low, parts))

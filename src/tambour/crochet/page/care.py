"""Care: how the piece is washed, in a box at the foot of a page that has room for it."""

from __future__ import annotations

import re

from tambour.crochet.language.finishes import Eye
from tambour.crochet.page.book import FOOT, MARGIN, TOP, Book, short
from tambour.crochet.page.type import BODY, HAIR, LEAD, PAPER, SMALL, SOFT, wrap

_WASHED = re.compile(
    r"\b(?:hand|machine|spot)?[ -]?wash(?:ed|able|ing)?\b|\bspot[ -]clean|\bsurface clean", re.IGNORECASE
)
"""How she says how the piece is washed."""
_ABOVE = 8.0
"""Between the box and what stands above it, mm."""


def care(book: Book) -> list[str]:
    """How the piece is washed, and what it takes to be safe for small children: of eyes and parts that it has."""
    built = book.piece.built
    hers = " ".join([*book.hers.intro, *book.hers.sentences]) if book.hers is not None else ""
    washed = [] if _WASHED.search(hers) else [book.own["care text"]]  # how she says it it stands among her sentences
    if any(isinstance(record, Eye) for record in built.pattern.finish):
        return [*washed, book.own["care eyes"]]
    return [*washed, *([book.own["care parts"]] if len(built.graph.parts) > 1 else [])]


def care_room(book: Book) -> float:
    """How much of a page the box takes, mm; 0 where it is set already, or there is room for it before the rounds."""
    if book.cared:
        return 0.0
    tall = _lines(book)[2] + _ABOVE
    return 0.0 if any(sheet.lowest + tall <= book.size[1] - FOOT for sheet in book.pages[1:2]) else tall


def _lines(book: Book) -> tuple[list[str], list[str], float]:
    """The words, the small words below them, and how high the box of both is."""
    room = book.size[0] - 2 * MARGIN - 12.0
    text = wrap(book.marked(" ".join(care(book))), BODY, room)
    small = wrap(book.marked(book.own["made"]), SMALL, room)
    return text, small, 17.0 + len(text) * BODY * 1.45 + len(small) * SMALL * 1.45


def set_care(book: Book, since: int) -> None:
    """Care, at the foot of the last page that has room, none before page ``since`` (the last of the rounds), else with
    what is needed, else on one of its own; nothing where it is set already."""
    if book.cared:
        return
    wide, high = book.size
    text, small, tall = _lines(book)
    fit = [*book.pages[:since:-1], *book.pages[1:2]]  # with what is needed, before it takes a page for itself
    sheet = next((s for s in fit if s.lowest + tall + _ABOVE <= high - FOOT), None)
    if sheet is None:
        sheet, y = book.page(short(book, book.own["care"])), TOP
    else:
        y = high - FOOT - tall
    sheet.box(MARGIN, y, wide - 2 * MARGIN, tall, None if book.low else PAPER, HAIR if book.low else None, 0.2, 2.0)
    sheet.text(book.own["care"], MARGIN + 6.0, y + 8.0, LEAD, True, book.accent)
    y = sheet.paragraph(text, MARGIN + 6.0, y + 14.0, BODY)
    sheet.paragraph(small, MARGIN + 6.0, y + 1.0, SMALL, color=SOFT)

"""Reprint: a text of people's as a written pattern, with its designer's own sentences where they stand in it, as in the booklet."""

from __future__ import annotations

from dataclasses import replace

from tambour.crochet.page.assembly import steps_said
from tambour.crochet.page.book import Book
from tambour.crochet.page.parts import with_hers
from tambour.crochet.page.wording import PartText, Row, Words
from tambour.crochet.piece import Plush


def reprinted(piece: Plush) -> Words | None:
    """The words of a pattern among those of its designer: her list of materials, her notes, what hands do between the rounds and behind
    them, her sentences of the assembly; None where the text is ours, or another language is asked for."""
    book = Book(piece)
    hers = book.hers
    if hers is None:
        return None
    made = book.said
    finish = tuple("\n  › ".join((words, *notes)) for words, notes in steps_said(book))  # ours as the booklet has it
    meant = {said.lower() for said, _ in made.abbreviations}
    terms = tuple((said, meaning) for said, meaning in hers.terms.items() if said.lower() not in meant)
    return replace(
        made,
        intro=(*([book.own["by"].format(name=book.designer)] if book.designer else []), *hers.intro),
        materials=tuple(hers.materials) or made.materials,
        abbreviations=(*made.abbreviations, *terms),
        parts=tuple(_part(book, part) for part in made.parts),
        seams=(),
        finish=(*finish, *hers.closing),
    )


def _part(book: Book, part: PartText) -> PartText:
    """A part's lines with her sentences, each once: what stands beside a round already is no sentence of its own, nor the other way about."""
    known = {id(row) for row in part.lines}
    rows = with_hers(book, part)
    beside = {_plain(row.words) for row in rows if id(row) in known and not row.label}
    said = [_plain(row.words) for row in rows if id(row) not in known]

    def stays(row: Row) -> bool:
        words = _plain(row.words)
        return bool(row.label or row.colors) or (
            not any(words in other for other in said) if id(row) in known else words not in beside
        )

    return replace(part, lines=tuple(row for row in rows if stays(row)))


def _plain(words: str) -> str:
    return " ".join(words.strip("*").split()).rstrip(".").lower()

"""Reprint: a text of people's as a written pattern, in the order and the words of its designer, with what is ours beside them."""

from __future__ import annotations

import re
from dataclasses import replace

from tambour.crochet.page.among import noted, notes_at, with_hers
from tambour.crochet.page.assembly import guesses
from tambour.crochet.page.book import Book
from tambour.crochet.page.hers import Hers
from tambour.crochet.page.wording import PartText, Words
from tambour.crochet.piece import Plush


def reprinted(piece: Plush) -> Words | None:
    """The words of a pattern among those of its designer: her lists, her notes, what hands do between the rounds and behind
    them, her sentences of the assembly, each once and where she has it; None where the text is ours, or another language is asked for."""
    book = Book(piece)
    hers = book.hers
    if hers is None:
        return None
    made = book.said
    parts = tuple(_part(book, part) for part in made.parts)
    finish = ["\n  › ".join((words, *notes_at(book, span))) for words, span in hers.finishing]
    finish += ["\n  ".join(f"› {said}" for said in (words, *notes)) for words, notes in guesses(book)]
    return replace(
        made,
        intro=(*([book.own["by"].format(name=book.designer)] if book.designer else []), *hers.intro),
        materials=tuple(hers.materials) or made.materials,
        colors=tuple(one for one in made.colors if not _named(one[0], hers)),
        abbreviations=(*((line, "") for line in hers.listed), *_ours(book, parts)),
        parts=parts,
        seams=(),
        finish=tuple(finish),
    )


def _named(letter: str, hers: Hers) -> bool:
    """Whether she says herself which yarn a letter or a number means."""
    said = re.compile(
        rf"(?:(?:colou?r|contrast|yarn|main|shade)\s+|[(,]\s*|^\W*){re.escape(letter)}(?=\s*[),:=–-]|\s+[A-Z])|\w {re.escape(letter)}(?=[,;.]|\W*$)|\bis (?:colou?r )?{re.escape(letter)}\b",
        re.IGNORECASE,
    )
    return bool(letter) and any(said.search(line) for line in (*hers.materials, *hers.intro, *hers.listed))


def _part(book: Book, part: PartText) -> PartText:
    """A part's lines with her sentences; what is noted with a round stands as a sentence of its own."""
    rows = with_hers(book, part, steps=True)
    start = next((at for at, k in book.hers.starts if k == part.section), 0) if book.hers is not None else 0
    above = [
        r for r in rows if r.hers and not r.label and r.words.isupper() and r.span is not None and r.span.end <= start
    ]
    rows = [replace(r, words=r.words.strip("*")) if noted(r) else r for r in rows if r not in above]
    return replace(part, lines=tuple(rows), above=tuple(r.words for r in above))


def _ours(book: Book, parts: tuple[PartText, ...]) -> list[tuple[str, str]]:
    """The abbreviations of our words that stand in the text, of which her lists say nothing."""
    assert book.hers is not None
    hers = {said.lower() for said in book.hers.terms}
    text = " ".join(f"{row.label} {row.words}" for part in parts for row in part.lines)
    return [
        (said, meaning)
        for said, meaning in book.said.abbreviations
        if said.lower() not in hers and re.search(rf"(?<!\w){re.escape(said)}(?!\w)", text)
    ]

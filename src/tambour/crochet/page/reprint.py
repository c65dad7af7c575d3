"""Reprint: a text of people's as a written pattern, in the order and the words of its designer, with what is ours beside them."""

from __future__ import annotations

import re
from dataclasses import replace

from tambour.core.errors import Span
from tambour.crochet.page.among import noted, notes_at, with_hers
from tambour.crochet.page.answered import meet
from tambour.crochet.page.assembly import guesses
from tambour.crochet.page.book import Book
from tambour.crochet.page.glossary import explained
from tambour.crochet.page.hers import Hers
from tambour.crochet.page.ordered import names_in
from tambour.crochet.page.wording import PartText, Words
from tambour.crochet.piece import Plush
from tambour.crochet.printed.rounds.doubts import BESIDE


def reprinted(piece: Plush) -> Words | None:
    """The words of a pattern among those of its designer: her lists, her notes, what hands do between the rounds and behind
    them, her sentences of the assembly, each once and where she has it; None where the text is ours, or another language is asked for."""
    book = Book(piece)
    hers = book.hers
    if hers is None:
        return None
    made = book.said
    parts = tuple(_part(book, part) for part in made.parts)
    parts, joins = _joining(book, parts)
    said = [(span.start, "\n  › ".join((words, *notes_at(book, span)))) for words, span in hers.finishing]
    finish = [words for _, words in sorted([*said, *joins], key=lambda one: one[0])]
    finish += ["\n  ".join(f"› {said}" for said in (words, *notes)) for words, notes in guesses(book)]
    return replace(
        made,
        intro=(*([book.own["by"].format(name=book.designer)] if book.designer else []), *hers.intro),
        materials=tuple(hers.materials) or made.materials,
        colors=tuple(one for one in made.colors if not _named(one[0], hers)),
        abbreviations=(*((line, "") for line in hers.listed), *_ours(book, parts), *_sign(book, parts, finish)),
        parts=parts,
        seams=(),
        finish=tuple(finish),
    )


def _named(letter: str, hers: Hers) -> bool:
    """Whether she says herself which yarn a letter or a number means."""
    said = re.compile(
        rf"(?:(?:colou?r|contrast|yarn|main|shade)\s+|[(,]\s*|^\W*){re.escape(letter)}(?=\s*[(),:=–-]|\s+[A-Z])|\w {re.escape(letter)}(?=[,;.]|\W*$)|\bis (?:colou?r )?{re.escape(letter)}\b",
        re.IGNORECASE,
    )
    return bool(letter) and any(said.search(line) for line in (*hers.materials, *hers.intro, *hers.listed))


def _part(book: Book, part: PartText) -> PartText:
    """A part's lines with her sentences; what is noted with a round stands as a sentence of its own."""
    rows = with_hers(book, part, steps=True)
    start = next((at for at, k in book.hers.starts if k == part.section), 0) if book.hers is not None else 0
    before = [r.hers and not r.label and r.span is not None and r.span.end <= start for r in rows]
    first = next((k for k, row in enumerate(rows) if before[k] and row.words.isupper()), len(rows))
    for k in range(first + 1, len(rows)):
        before[k] = before[k] or (rows[k].ours and before[k - 1])  # with what is ours about a sentence
    above = [row for k, row in enumerate(rows) if k >= first and before[k]]  # the heading, and her sentences below it
    rows = [replace(r, words=r.words.strip("*")) if noted(r) else r for r in rows if r not in above]
    said = "\0".join(f"  \n› {r.words}" if r.ours else r.words for r in above).replace("\0  \n", "  \n")
    return replace(part, lines=tuple(rows), above=tuple(said.split("\0")) if said else ())


def _joining(book: Book, parts: tuple[PartText, ...]) -> tuple[tuple[PartText, ...], list[tuple[int, str]]]:
    """The parts without the rounds that join them when all else is done, and these, each with its place: eyes come before."""
    assert book.hers is not None
    after, made, joins = book.hers.assembly, list[PartText](), list[tuple[int, str]]()
    for part in parts:
        late = [row for row in part.lines if row.label and row.span is not None and row.span.start >= after]
        late = [row for row in late if _joins(book, row.span)]  # other rounds stay with their part
        if len(late) == sum(bool(row.label) for row in part.lines):
            made.append(part)  # a part that is worked among the steps
            continue
        said = ((row.span, replace(row, label="" if row.hers else row.label)) for row in late)  # "1st joining rnd: …"
        joins += [(span.start, str(row)) for span, row in said if span is not None]
        made.append(replace(part, lines=tuple(row for row in part.lines if row not in late)))
    return tuple(made), joins


def _joins(book: Book, span: Span | None) -> bool:
    """Whether a round goes through two pieces."""
    pattern = book.piece.built.pattern
    lines = [line for part in pattern.parts for line in part.lines if meet(line.span, span)]
    told = [p for p in pattern.warnings if p.message.startswith(BESIDE) and meet(p.span, span)]
    return bool(told) or any("attach" in names_in(line.items) for line in lines)


def _sign(book: Book, parts: tuple[PartText, ...], finish: list[str]) -> list[tuple[str, str]]:
    """What a line of ours begins with, where there is one."""
    ours = any(row.ours for part in parts for row in part.lines) or any("›" in words for words in finish)
    return [("›", book.own["ours sign"])] if ours else []


def _ours(book: Book, parts: tuple[PartText, ...]) -> list[tuple[str, str]]:
    """The abbreviations of our words that stand in the text, of which her lists say nothing."""
    assert book.hers is not None
    hers = {said.lower() for said in book.hers.terms} | {said for line in book.hers.listed for said in explained(line)}
    text = " ".join(f"{row.label} {row.words}" for part in parts for row in part.lines)
    return [
        (said, meaning)
        for said, meaning in book.said.abbreviations
        if said.lower() not in hers and re.search(rf"(?<!\w){re.escape(said)}(?!\w)", text)
    ]

"""Instructions: a pattern written for makers, in the words and the style of print of one language."""

from __future__ import annotations

from tambour.core.errors import TambourError, Text
from tambour.crochet.graph.build import build
from tambour.crochet.graph.built import Built
from tambour.crochet.language.tree import Pattern
from tambour.crochet.page.ofmodel import dressed, of_model
from tambour.crochet.page.plain import as_she_writes, unmarked, with_eyes
from tambour.crochet.page.wording import Words
from tambour.crochet.page.writer import Writer
from tambour.crochet.piece import Plush
from tambour.crochet.words.table import TERMS


def view(piece: Plush) -> Text:
    """The pattern of a piece as a printed text, in the words that its params ask for."""
    if of_model(piece):
        return _text(dressed(words(piece.built, piece.params.terms), piece), piece.built.pattern.text.name)
    if by_people(piece.built.pattern):
        from tambour.crochet.page.reprint import reprinted

        hers = reprinted(piece)
        if hers is not None:
            return _text(hers, piece.built.pattern.text.name)
    return instructions(piece.built, piece.params.terms, exact=not by_people(piece.built.pattern))


def plain(piece: Plush) -> Text:
    """The same without the marks of Markdown, where people wrote it; ours keeps them, to be read again by the letter."""
    text = view(piece)
    return Text(unmarked(text.text), text.name) if by_people(piece.built.pattern) else text


def instructions(piece: Built | Pattern, terms: str | None = None, *, exact: bool = True) -> Text:
    """The pattern as a printed text, Markdown that is good to read as it is.

    terms : code of the words (:data:`TERMS`); None for those that the pattern is written in, else US terms

    exact : places by their numbers, and all that was guessed, so that reading it again gives the same graph and the same
        finishing; else as a person says them, without the guesses
    """
    made = words(piece, terms, exact=exact)
    if not exact:
        made = with_eyes(made, build(piece) if isinstance(piece, Pattern) else piece)
    return _text(made, piece.text.name if isinstance(piece, Pattern) else piece.pattern.text.name)


def _text(made: Words, name: str) -> Text:
    """Words as a printed text."""
    word = made.terms.word
    lines = [f"# {made.title}", ""] if made.title else []
    lines += [line for said in made.intro for line in (said, "")]
    if made.materials or made.colors:
        listed = [*made.materials, *(line for *_, line in made.colors)]
        lines += [f"## {word('materials')}", "", *(f"- {said}" for said in listed), ""]
    for key, said in (("gauge", made.gauge), ("finished size", made.size)):
        lines += [f"**{word(key)}:** {said}", ""] if said else []
    lines += [f"## {word('abbreviations')} ({made.named})", ""]
    lines += [*(f"- {said} = {meaning}" if meaning else f"- {said}" for said, meaning in made.abbreviations), ""]
    if made.special:
        lines += [
            f"## {word('special stitches')}",
            "",
            *(f"- {said} = {meaning}" for said, meaning in made.special),
            "",
        ]
    for part in made.parts:
        lines += [line for said in part.above for line in (said, "")]
        lines += [f"## {part.title}", "", *part.settings]
        lines += [*(f"{said}  " for said in part.lines), ""]  # each a line of its own in Markdown as well
    if made.seams or made.finish:
        said_ = [said if said.startswith("›") else f"- {said}" for said in (*made.seams, *made.finish)]
        lines += [f"## {word('assembly')}", "", *said_, ""]
    return Text("\n".join(lines).rstrip("\n") + "\n", name)


def by_people(pattern: Pattern) -> bool:
    """Whether a pattern's text was written by people, and neither in tambour's language nor printed by it."""
    terms = TERMS.get(pattern.terms)
    return terms is not None and not terms.prints(pattern.text.text)


def words(piece: Built | Pattern, terms: str | None = None, *, exact: bool = True) -> Words:
    """The words of a pattern in the parts that a page sets apart; see :func:`instructions`."""
    built = build(piece) if isinstance(piece, Pattern) else piece
    code = terms or built.pattern.terms or "us"
    if code not in TERMS:
        raise TambourError(f'there are no terms "{code}"', hint=f"one of {', '.join(TERMS)}", where="{--terms}")
    text = built.pattern.text.text
    table = TERMS[code] if exact else as_she_writes(TERMS[code], text)
    return Writer(built, table, exact).words()

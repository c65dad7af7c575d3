"""The middle of the front, of what lies the middle of the top, by its stitch: what a maker marks while she is on that round, and counts from when she sews on."""

from __future__ import annotations

from collections.abc import Set
from math import ceil
from typing import TYPE_CHECKING, Final

from tambour.crochet.graph.spots import Spots
from tambour.crochet.language.finishes import Embroidery, Finish, Placed, spots_of
from tambour.crochet.page.answered import says_middle
from tambour.crochet.page.ofmodel import of_model
from tambour.crochet.page.wording import PartText, Row

if TYPE_CHECKING:
    from tambour.crochet.page.book import Book

_AROUND: Final = 8
"""On a round of so few stitches no middle is counted."""
_WHOLE: Final = 0.25
"""A middle so near to a stitch is on it; else it is between two."""


def named(book: Book, record: Finish) -> set[int]:
    """The rounds by which the place of a part, of eyes or of a seam is told, in her words and in ours."""
    at = [float(spot.round) for spot in spots_of(record)]
    hers = book.taken.rounds(record) if isinstance(record, Placed | Embroidery) else ()
    return {int(n) for n in at} | {ceil(n) for n in at} | set(hers)


def lies(book: Book, part: int) -> bool:
    """Whether a part of the graph lies, so that opposite of where its rounds begin is its top."""
    built = book.piece.built
    return built.pattern.parts[built.parts[part].section].lies


def middles(book: Book, spots: Spots, host: int, wanted: Set[int], on: float = 0.0) -> dict[int, str]:
    """Round → at which stitch of a part the middle of the front is, or of the top of one that lies, for the first and the last of the rounds that something is
    counted on; on : what is so much of a round on from it, 0.5 the middle of the back or of the underside."""
    rounds = {
        spots.numbers[k]: k
        for k, r in enumerate(spots.built.rounds)
        if r.part == host and not r.aside and len(spots.stitches(k)) > _AROUND
    }
    of = [n for n in sorted(wanted) if n in rounds]
    found = {}
    for n in dict.fromkeys((*of[:1], *of[-1:])):
        many = len(spots.stitches(rounds[n]))
        at = spots.front(rounds[n]) + on * many + 1.0
        whole = abs(at - round(at)) < _WHOLE
        s = ((round(at) if whole else int(at)) - 1) % many + 1
        of_round, between = book.own["middle of round"], book.own["middle between"]
        found[n] = (of_round if whole else between).format(n=n, s=s, s2=s % many + 1)
    return found


def marked(book: Book, block: PartText, rows: list[Row]) -> list[Row]:
    """The lines of a part with what is to be marked on the rounds from whose middle others are counted; a model's patterns say it
    themselves."""
    built = book.piece.built
    spots = Spots(built)
    if block.part < 0 or block.section < 0 or of_model(book.piece) or spots.in_rows[block.part]:
        return rows
    if book.hers is not None and any(says_middle(words) for words, _ in book.hers.inside.get(block.section, [])):
        return rows  # she has it marked herself
    name = built.pattern.parts[block.section].name
    wanted = {
        n
        for record in built.pattern.finish
        if any(s.part in (name, f"{name}.1") for s in spots_of(record))
        for n in named(book, record)
    }
    made = list(rows)
    for n, place in sorted(middles(book, spots, block.part, wanted).items(), reverse=True):
        at = next((k for k, row in enumerate(made) if row.label and row.number >= n > row.number - row.times), None)
        if at is not None:
            made.insert(
                at + 1,
                Row(
                    "", book.own["mark top" if lies(book, block.part) else "mark middle"].format(place=place), ours=True
                ),
            )
    return made

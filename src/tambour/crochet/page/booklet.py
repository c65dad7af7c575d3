"""The page to sell: a pattern as a booklet: cover, what is needed, the rounds, diagrams, assembly and care."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Final

import numpy as np

from tambour.core.drawing import Drawing
from tambour.core.picture import Picture
from tambour.crochet.language.finishes import Embroidery
from tambour.crochet.maker.size import skin, whole_size
from tambour.crochet.page.assembly import assembly, finished
from tambour.crochet.page.begin import begin, heading, spoken_by_her
from tambour.crochet.page.book import MARGIN, WHITE, Book, along, cropped, cut, short, weight_name
from tambour.crochet.page.care import set_care
from tambour.crochet.page.charted import charts
from tambour.crochet.page.flow import flow, together
from tambour.crochet.page.glossary import glossary
from tambour.crochet.page.parts import rounds
from tambour.crochet.page.pictures import whole
from tambour.crochet.page.type import COVER, HAIR, INK, LEAD, PAPER, SMALL, SOFT, wrap
from tambour.render.page import Page

if TYPE_CHECKING:
    from tambour.crochet.piece import Plush

_ASIDE: Final = re.compile(r",?\s+(?:with|w/|using|when|in the yarn|depending|if)(?=\s|$).*$", re.IGNORECASE)
"""Of what her size depends, which the page after the cover says."""


def pages(piece: Plush) -> tuple[Drawing, ...]:
    """The booklet, a Drawing per page."""
    from tambour.crochet.piece import not_empty

    not_empty(piece)
    book = Book(piece)
    _cover(book)
    begin(book, glossary(book))
    again = book.own["continued"]
    worked = short(book, book.said.terms.word("instructions"))
    flow(rounds(book), book.frame, lambda: book.page(worked), again, book.below)
    since = len(book.pages) - 1
    steps = assembly(book, skin(piece, np.flatnonzero(np.isin(piece.built.graph.part, book.album.all))))
    closing = book.hers.closing if book.hers is not None else []
    name = book.said.terms.word("assembly") if steps else book.own["last words"]
    if closing:
        width = book.frame.width
        said = [
            atom
            for k, words in enumerate(closing)
            for atom in spoken_by_her(book, words, width, space=1.2 if k or steps else 6.0)
        ]
        heads = heading(book, book.own["last words"], width) if steps else []
        steps += together(heads, said, book.own["last words"])
    if steps:
        head = heading(book, name, book.size[0] - 2 * MARGIN)[0]
        flow(steps, book.frame, lambda: book.page(short(book, name)), again, book.below, head)
    if not book.low:
        finished(book)
    charts(book)
    set_care(book, since)
    total = len(book.pages)
    foot = book.title if not book.designer else f"{book.title} · {book.designer}"
    for k, sheet in enumerate(book.pages):
        if k:
            y = book.size[1] - 11.0
            room = book.size[0] - 2 * MARGIN - 20.0
            sheet.text(cut(foot, SMALL, room), MARGIN, y, SMALL, color=SOFT)
            sheet.text(f"{k + 1} / {total}", book.size[0] - MARGIN, y, SMALL, color=SOFT, anchor="end")
    about = {"title": book.title, **({"author": book.designer} if book.designer else {})}
    return tuple(_printed(book, sheet).drawing(**about) for sheet in book.pages)


def _printed(book: Book, sheet: Page) -> Page:
    """A page on its paper, as large as it is printed."""
    if book.scale == 1.0:
        return sheet
    made = Page(*book.paper, sheet.background, INK)
    made.place(sheet.drawing(), 0.0, 0.0, book.scale)
    return made


def _cover(book: Book) -> None:
    """A large picture, the title, and what a buyer asks first."""
    wide, high = book.size
    sheet = Page(wide, high, WHITE if book.low else PAPER, INK)
    book.pages.append(sheet)
    tall, room = high - 93.0, wide - 2 * MARGIN
    if book.photos:
        _hers(book, sheet, tall)
    elif book.low:
        side = min(0.5 * wide, tall - 2 * MARGIN)
        picture = whole(book.album, round(side * 8.2), round(side * 8.2))
        sheet.image(picture, 0.5 * (wide - side), 0.5 * (tall - side), side, side, photo=True)
    else:
        sheet.image(whole(book.album, round(wide * 8.2), round(tall * 8.2)), 0.0, 0.0, wide, tall, photo=True)
    size = COVER
    while len(wrap(book.title, size, room, True)) > (1 if size > 8.0 else 2) and size > 5.5:
        size *= 0.94
    lines = wrap(book.title, size, room, True)[:4]
    y = tall + 8.0 + size * 0.8
    y = sheet.paragraph(lines, MARGIN, y, size, True, INK, 1.18) - size * 1.18
    y += 4.0 + LEAD
    under = book.own["pattern"]
    if book.designer:
        under += f" · {book.own['by'].format(name=book.designer)}"
    for line in wrap(under, LEAD, room)[:2]:
        sheet.text(line, MARGIN, y, LEAD, color=SOFT)
        y += LEAD * 1.45
    # Three facts in a row at the foot.
    whole_ = whole_size(book.piece)
    upright, long = whole_.how != "laid flat", along(book.piece, whole_)
    size_of = (
        f"{book.said.terms.word('finished size')}, {book.own['length' if long else 'height' if upright else 'width']}"
    )
    of = whole_.extent[2] if long else whole_.extent[1] if upright else max(whole_.extent[0], whole_.extent[2])
    hers = _ASIDE.sub("", " ".join(book.sized.split()))
    if len(wrap(hers, LEAD, room / 3 - 4.0, True)) > 2 and book.hers is not None:
        hers = book.hers.size  # of all that she says of it
    if hers and len(wrap(hers, LEAD, room / 3 - 4.0, True)) <= 2:
        facts = [(book.said.terms.word("finished size"), hers)]  # what she says is what a buyer will hold her to
    else:
        facts = [(size_of, book.length(of))]
    facts += [
        (book.said.terms.word("yarn"), weight_name(book)),
        (book.own["hook"][:1].upper() + book.own["hook"][1:], f"{book.number(book.piece.gauge.hook, 2)} mm"),
    ]
    top = high - 32.0
    sheet.line(MARGIN, top, wide - MARGIN, top, book.accent, 0.4)
    step = room / 3
    for k, (what, much) in enumerate(facts):
        x = MARGIN + k * step
        sheet.text(what, x, top + 6.5, SMALL, color=SOFT)
        sheet.paragraph(wrap(much, LEAD, step - 4.0, True)[:2], x, top + 12.0, LEAD, True)
    threads = [r.color for r in book.piece.built.pattern.finish if isinstance(r, Embroidery)]
    dots = list(dict.fromkeys([*book.used, *threads]))[:12]
    for k, color in enumerate(dots):
        sheet.circles([(wide - MARGIN - 2.4 - 6.4 * (len(dots) - 1 - k), high - 12.5)], 2.4, color, HAIR)


def _hers(book: Book, sheet: Page, tall: float) -> None:
    """Her own photo leads the cover; the picture that is computed stands small in its corner, and says what it is."""
    wide = book.size[0]
    x, y, w, h = (0.0, 0.0, wide, tall) if not book.low else (MARGIN, MARGIN, wide - 2 * MARGIN, 0.6 * tall)
    sheet.image(cropped(book.photos[0][1], w / h), x, y, w, h, photo=True)
    side = 0.24 * wide
    left, top = x + w - side - 6.0, y + h - side - 10.0
    sheet.image(whole(book.album, round(side * 8.2), round(side * 8.2)), left, top, side, side, photo=True)
    sheet.box(left, top, side, side + 5.6, None, HAIR, 0.3)
    for k, line in enumerate(wrap(book.own["computed"], SMALL, side)[:1]):
        sheet.image(_white(), left, top + side, side, 5.6)
        sheet.text(line, left + 0.5 * side, top + side + 3.8 + k * SMALL, SMALL, color=SOFT, anchor="middle")


def _white() -> Picture:
    """A white ground for words on a photo."""
    return Picture(np.full((2, 2, 4), 255, np.uint8))

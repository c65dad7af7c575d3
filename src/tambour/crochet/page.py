"""The page to sell: a pattern as a booklet: cover, what is needed, the rounds, diagrams, assembly and care."""

from __future__ import annotations

from pathlib import PurePath
from typing import TYPE_CHECKING, Final

import numpy as np

from tambour.color import linear
from tambour.core.drawing import Drawing
from tambour.crochet.page_begin import begin
from tambour.crochet.page_flow import Frame, flow
from tambour.crochet.page_parts import assembly, charts, rounds
from tambour.crochet.page_pictures import whole
from tambour.crochet.page_sheet import BODY, COVER, HAIR, INK, LEAD, PAPER, RGB, SMALL, SOFT, Sheet, wrap
from tambour.crochet.page_text import Words, words
from tambour.crochet.page_words import IMPERIAL, WORDS
from tambour.crochet.size import Size, skin, whole_size

if TYPE_CHECKING:
    from tambour.crochet.plush import Plush

PAGES: Final = {"a4": (210.0, 297.0), "letter": (215.9, 279.4)}
MARGIN, TOP, FOOT, GUTTER = 18.0, 24.0, 20.0, 9.0


class Book:
    """What all pages of a booklet share, and the pages so far.

    piece, said : the plush and its words; own : the page's own words; code : of the terms; accent : a colour for
    headings, the main yarn's, dark enough to read
    """

    def __init__(self, piece: Plush) -> None:
        params = piece.params
        self.piece = piece
        self.said: Words = words(piece.built, params.terms)
        self.code = self.said.terms.code
        self.own = WORDS[self.code]
        stated = piece.built.pattern.stated
        stem = PurePath(piece.built.pattern.text.name).stem.replace("_", " ").strip("<> ")
        title = params.title or stated.get("title", ("",))[0] or self.said.title or stem
        self.title = " ".join(title.split()) or self.own["pattern"]
        self.designer = " ".join((params.designer or stated.get("designer", ("",))[0]).split())
        self.size = PAGES[params.page]
        self.pages: list[Sheet] = []
        self.used: list[RGB] = [(int(r), int(g), int(b)) for r, g, b in _in_order(piece.yarn.color)]
        self.accent = _readable(_main(piece))

    @property
    def frame(self) -> Frame:
        """Two columns."""
        width = (self.size[0] - 2 * MARGIN - GUTTER) / 2
        return Frame((MARGIN, MARGIN + width + GUTTER), width, TOP, self.size[1] - FOOT)

    @property
    def imperial(self) -> bool:
        """Whether inches and yards are told as well."""
        return self.code in IMPERIAL

    def number(self, value: float, digits: int = 1) -> str:
        """A number as the language writes it, without needless noughts."""
        said = f"{value:.{digits}f}"
        said = said.rstrip("0").rstrip(".") if "." in said else said
        return said if self.imperial else said.replace(".", ",")

    def length(self, mm: float) -> str:
        """A length in cm, and in inches where readers want them."""
        cm = f"{self.number(mm / 10)} cm"
        return f"{cm} ({self.number(mm / 25.4)} in)" if self.imperial else cm

    @property
    def below(self) -> tuple[Sheet, float]:
        """The last page, and where something else may begin on it."""
        sheet = self.pages[-1]
        return sheet, sheet.lowest + 12.0

    def page(self, heading: str = "") -> Sheet:
        """A new page; ``heading`` stands at its head."""
        sheet = Sheet(*self.size)
        if heading:
            sheet.text(heading, MARGIN, TOP - 8.0, LEAD, True, self.accent)
            sheet.line(MARGIN, TOP - 5.2, self.size[0] - MARGIN, TOP - 5.2, HAIR)
        self.pages.append(sheet)
        return sheet


def pages(piece: Plush) -> tuple[Drawing, ...]:
    """The booklet, a Drawing per page."""
    from tambour.crochet.plush import not_empty

    not_empty(piece)
    book = Book(piece)
    _cover(book)
    begin(book)
    again = book.own["continued"]
    heading = short(book, book.said.terms.word("instructions"))
    flow(rounds(book), book.frame, lambda: book.page(heading), again, book.below)
    charts(book)
    steps = assembly(book, skin(piece, np.arange(len(piece.positions))))
    if steps:
        title = short(book, book.said.terms.word("assembly"))
        flow(steps, book.frame, lambda: book.page(title), again, book.below)
    _care(book)
    total = len(book.pages)
    foot = book.title if not book.designer else f"{book.title} · {book.designer}"
    for k, sheet in enumerate(book.pages):
        if k:
            y = book.size[1] - 11.0
            room = book.size[0] - 2 * MARGIN - 20.0
            sheet.text(_cut(foot, SMALL, room), MARGIN, y, SMALL, color=SOFT)
            sheet.text(f"{k + 1} / {total}", book.size[0] - MARGIN, y, SMALL, color=SOFT, anchor="end")
    about = {"title": book.title, **({"author": book.designer} if book.designer else {})}
    return tuple(sheet.drawing(**about) for sheet in book.pages)


def size_lines(book: Book, size: Size) -> list[tuple[str, str]]:
    """The finished size: (what, how much)."""
    width, height, depth = size.extent
    flat = size.how == "laid flat"
    made = [("height", depth if flat else height), ("width", width)]
    made += [] if flat else [("depth", depth)]
    said = [(book.own[name], book.length(mm)) for name, mm in made]
    if size.stitches and not flat:
        said.append((book.own["around"], book.length(size.around)))
    return said


def short(book: Book, what: str) -> str:
    return f"{_cut(book.title, LEAD, 90.0)} · {what}" if what else book.title


def _cut(text: str, size: float, room: float) -> str:
    """The text, or its first words and an ellipsis."""
    lines = wrap(text, size, room)
    return text if len(lines) < 2 else wrap(text, size, room - 3.0)[0] + " …"


def _cover(book: Book) -> None:
    """A large picture, the title, and what a buyer asks first."""
    wide, high = book.size
    sheet = Sheet(wide, high, PAPER)
    book.pages.append(sheet)
    tall = high - 93.0
    sheet.image(whole(book.piece, round(wide * 8.2), round(tall * 8.2)), 0.0, 0.0, wide, tall)
    room = wide - 2 * MARGIN
    size = COVER
    while len(wrap(book.title, size, room, True)) > (1 if size > 8.0 else 2) and size > 5.5:
        size *= 0.94
    lines = wrap(book.title, size, room, True)[:4]
    y = tall + 8.0 + size * 0.8
    y = sheet.lines(lines, MARGIN, y, size, True, INK, 1.18) - size * 1.18
    y += 4.0 + LEAD
    under = book.own["pattern"]
    if book.designer:
        under += f" · {book.own['by'].format(name=book.designer)}"
    for line in wrap(under, LEAD, room)[:2]:
        sheet.text(line, MARGIN, y, LEAD, color=SOFT)
        y += LEAD * 1.45
    # Three facts in a row at the foot.
    whole_ = whole_size(book.piece)
    upright = whole_.how != "laid flat"
    size_of = f"{book.said.terms.word('finished size')}, {book.own['height' if upright else 'width']}"
    facts = [
        (size_of, book.length(whole_.extent[1] if upright else max(whole_.extent[0], whole_.extent[2]))),
        (book.said.terms.word("yarn"), weight_name(book)),
        (book.own["hook"][:1].upper() + book.own["hook"][1:], f"{book.number(book.piece.gauge.hook, 2)} mm"),
    ]  # fmt: skip
    top = high - 32.0
    sheet.line(MARGIN, top, wide - MARGIN, top, book.accent, 0.4)
    step = room / 3
    for k, (what, much) in enumerate(facts):
        x = MARGIN + k * step
        sheet.text(what, x, top + 6.5, SMALL, color=SOFT)
        sheet.lines(wrap(much, LEAD, step - 4.0, True)[:2], x, top + 12.0, LEAD, True)
    dots = book.used[:12]
    for k, color in enumerate(dots):
        sheet.disc(wide - MARGIN - 2.4 - 6.4 * (len(dots) - 1 - k), high - 12.5, 2.4, color, HAIR)


def weight_name(book: Book) -> str:
    """The class of the yarn, as the language's makers call it."""
    from tambour.crochet.gauge import WEIGHTS

    kind = WEIGHTS[book.piece.gauge.weight]
    name = kind.uk if book.code == "uk" else kind.name
    return book.own["weight"].format(name=name, number=kind.number)


def _care(book: Book) -> None:
    """Care, on the last page where there is room, else on one of its own."""
    own = book.own
    wide, high = book.size
    room = wide - 2 * MARGIN - 12.0
    text = wrap(own["care text"], BODY, room)
    small = wrap(own["made"], SMALL, room)
    tall = 17.0 + len(text) * BODY * 1.45 + len(small) * SMALL * 1.45
    sheet = book.pages[-1]
    if sheet.lowest + tall + 8.0 > high - FOOT:
        sheet = book.page(short(book, own["care"]))
        y = TOP
    else:
        y = high - FOOT - tall
    sheet.box(MARGIN, y, wide - 2 * MARGIN, tall, PAPER, None, 0.0, 2.0)
    sheet.text(own["care"], MARGIN + 6.0, y + 8.0, LEAD, True, book.accent)
    y = sheet.lines(text, MARGIN + 6.0, y + 14.0, BODY)
    sheet.lines(small, MARGIN + 6.0, y + 1.0, SMALL, color=SOFT)


def _main(piece: Plush) -> tuple[int, int, int]:
    """The colour that most of the yarn has."""
    from tambour.crochet.materials import lengths

    metres = lengths(piece)
    r, g, b = max(metres, key=lambda color: metres[color], default=(90, 80, 70))
    return int(r), int(g), int(b)


def _readable(color: RGB) -> RGB:
    """The colour, darkened until it reads on white (contrast 4.5 to 1, WCAG 2)."""
    shade = np.array(color, float)
    for _ in range(60):
        light = float(np.array([0.2126, 0.7152, 0.0722]) @ linear(shade / 255.0))
        if 1.05 / (light + 0.05) >= 4.5:
            break
        shade *= 0.95
    r, g, b = (int(v) for v in shade)
    return r, g, b


def _in_order(colors: np.ndarray) -> list[tuple[int, ...]]:
    return list(dict.fromkeys(tuple(c) for c in colors.tolist()))

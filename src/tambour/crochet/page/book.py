"""The booklet: its pages so far, and what they share: title, colours, sizes of paper, the words of its language."""

from __future__ import annotations

import re
from dataclasses import replace
from functools import cached_property
from pathlib import PurePath
from typing import TYPE_CHECKING

import numpy as np

from tambour.color import linear
from tambour.core.check import Array
from tambour.core.errors import Text
from tambour.core.picture import Picture
from tambour.core.rgb import RGB
from tambour.crochet.language.finishes import Finish
from tambour.crochet.maker.size import Size
from tambour.crochet.maker.taken import Taken
from tambour.crochet.page.album import Album
from tambour.crochet.page.cleaned import titled
from tambour.crochet.page.flow import Frame
from tambour.crochet.page.hers import Hers, hers
from tambour.crochet.page.instructions import words
from tambour.crochet.page.ofmodel import noted, of_model, spoken
from tambour.crochet.page.placed import Spoken
from tambour.crochet.page.type import BACKDROP, HAIR, INK, LEAD, printable, wrap
from tambour.crochet.page.wording import PartText, Words
from tambour.crochet.yarns import WEIGHTS
from tambour.render.page import PAPERS, Page

if TYPE_CHECKING:
    from tambour.crochet.piece import Plush

MARGIN, TOP, FOOT, GUTTER = 18.0, 24.0, 20.0, 9.0


OURS = "› "
"""What stands before words that are not the designer's."""
OWN = 52.0
"""How high the designer's own photos are, mm."""
LARGE = 1.4
"""How much larger large print is."""
WHITE: RGB = (255, 255, 255)
_LONG = 1.4
"""What is so much deeper than high is long: a whale on its belly."""
_HUE = 60
"""What is no grey differs in its red, green and blue by so much."""
_BRACKETED = re.compile(r"\W*([^()\[\]]+?)\s*[(\[][^()\[\]]{1,40}[)\]]\W*")
"""A heading with something in brackets behind its name."""
_LEAST = 200
"""Pixels of a photo's shorter side; what is smaller is an ornament."""


def photos(text: Text) -> list[tuple[int, Picture]]:
    """The photos that stand in a text: where, and as pictures; those that are none are left out."""
    from io import BytesIO

    from PIL import Image

    found = []
    for at, data in sorted(text.photos, key=lambda one: one[0]):
        try:
            with Image.open(BytesIO(data)) as image:
                image.draft("RGB", (1600, 1600))
                seen = image.convert("RGBA")
        except (OSError, ValueError, Image.DecompressionBombError):
            continue
        if min(seen.size) >= _LEAST:
            seen.thumbnail((1600, 1600))
            found.append((at, Picture(np.asarray(seen).copy())))
    return found


def cropped(picture: Picture, shape: float) -> Picture:
    """The middle of a picture, of a shape (width by height)."""
    high, wide = picture.rgba.shape[:2]
    if wide > shape * high:
        cut_ = max(1, round(shape * high))
        return Picture(picture.rgba[:, (wide - cut_) // 2 : (wide - cut_) // 2 + cut_].copy())
    cut_ = max(1, round(wide / shape))
    return Picture(picture.rgba[(high - cut_) // 2 : (high - cut_) // 2 + cut_].copy())


class Book:
    """What all pages of a booklet share, and the pages so far.

    piece, said : the plush and its words; own : the page's own words
    hers : the designer's own sentences, None where they are ours; spoken : says where parts go; code : of the terms
    taken : says what the pictures have where she leaves something open
    sized : the finished size in her words, "" where she says none; low : little ink is used
    scale : how much larger than they are set its pages are printed; cared : whether care is set already

    Words alone need no yarn: what pictures need is made when it is first looked at.
    """

    def __init__(self, piece: Plush) -> None:
        params = piece.params
        self.piece = piece
        self.said: Words = words(piece.built, params.terms, exact=False)
        if of_model(piece):
            self.said = noted(self.said, piece)
        self.code = self.said.terms.code
        self.hers = hers(piece.built.pattern, self.code)
        if self.hers is not None:  # as she has them: a part may be done with after others that she begins later
            parts = sorted(self.said.parts, key=lambda part: _begun(piece, part))
            self.said = replace(self.said, parts=tuple(_as_headed(self.hers, part) for part in parts))
        self.spoken = spoken(piece, self.said) if of_model(piece) else Spoken(piece.built, self.said.terms)
        self.own = self.said.terms.page
        self.headed = _headed(piece, self.said)
        self.taken = Taken(piece, self.own)
        stated = piece.built.pattern.stated
        stem = PurePath(piece.built.pattern.text.name).stem.replace("_", " ").strip("<> ")
        title = params.title or stated.get("title", ("",))[0] or self.said.title or stem
        self.title = printable(titled(title)) or self.own["pattern"]
        said = self.hers.designer if self.hers is not None else ""
        self.designer = " ".join((params.designer or stated.get("designer", ("",))[0] or said).split())
        self.sized = self.said.size or (self.hers.size if self.hers is not None else "")
        if self.hers is not None and self.said.size and self.hers.size.startswith(self.said.size):
            self.sized = self.hers.size  # all of the sentence
        self.scale = LARGE if params.large_print else 1.0
        wide, high = PAPERS[params.page]
        self.paper, self.size = (wide, high), (wide / self.scale, high / self.scale)
        self.low = params.ink == "low"
        self.pages: list[Page] = []
        self.cared = False

    @cached_property
    def album(self) -> Album:
        """What its small pictures share."""
        made = Album(self.piece)
        made.backdrop = WHITE if self.low else BACKDROP
        return made

    @cached_property
    def photos(self) -> list[tuple[int, Picture]]:
        """The designer's own, (where in her text, picture), the first for the cover."""
        return photos(self.piece.built.pattern.text)

    @cached_property
    def used(self) -> list[RGB]:
        """The yarn's colours, in the order in which they are taken up."""
        return [(int(r), int(g), int(b)) for r, g, b in _in_order(self.piece.yarn.color)]

    @cached_property
    def accent(self) -> RGB:
        """A colour for headings, the main yarn's, dark enough to read."""
        return _readable(_main(self.piece))

    def called(self, said: str) -> str:
        """What is ours, with the parts as they are headed: "The Bear's Head" for The Bear s Head, "Part 3" for part_3."""
        for name, heading in self.headed.items():
            said = re.sub(rf"(?<!\w){re.escape(name)}(?!\w)", heading.replace("\\", ""), said)
        return said

    def words_of(self, record: Finish) -> str:
        """The designer's own sentence that a finishing record came of; "" where it is ours."""
        a, b = record.span.start, record.span.end
        if self.hers is None or b <= a or any(head.start <= a < head.end for _, _, head in self.hers.headed):
            return ""  # what a heading has in brackets is no sentence
        return " ".join(self.piece.built.pattern.text.text[a:b].split())

    def sentence_of(self, record: Finish) -> str:
        """The whole sentence of hers that a finishing record came of, with what stands before it ("Ears:"); "" where it is ours."""
        said = self.words_of(record)
        if not said or self.hers is None:
            return said
        a, b = record.span.start, record.span.end
        whole = [words for words, span in self.hers.finishing if span.start < b and a < span.end]
        said = " ".join(whole) if whole else said
        return said if said.endswith((".", "!", "?", ")", ":")) else f"{said}."

    def marked(self, words: str) -> str:
        """Words of ours, marked as such where a designer's stand beside them."""
        return words if self.hers is None or not words else OURS + words

    @property
    def frame(self) -> Frame:
        """Two columns; one in large print."""
        if self.scale > 1.0:
            return Frame((MARGIN,), self.size[0] - 2 * MARGIN, TOP, self.size[1] - FOOT)
        width = (self.size[0] - 2 * MARGIN - GUTTER) / 2
        return Frame((MARGIN, MARGIN + width + GUTTER), width, TOP, self.size[1] - FOOT)

    @property
    def imperial(self) -> bool:
        """Whether inches and yards are told as well."""
        return self.said.terms.inches

    def number(self, value: float, digits: int = 1) -> str:
        """A number as the language writes it, without needless noughts."""
        said = f"{value:.{digits}f}"
        said = said.rstrip("0").rstrip(".") if "." in said else said
        return said if self.imperial else said.replace(".", ",")

    def length(self, mm: float) -> str:
        """A length in cm, and in inches where readers want them."""
        cm = f"{self.number(mm / 10)} cm"
        return f"{cm} ({self.number(round(mm / 10, 1) / 2.54)} in)" if self.imperial else cm

    @property
    def below(self) -> tuple[Page, float]:
        """The last page, and where something else may begin on it."""
        sheet = self.pages[-1]
        return sheet, sheet.lowest + 12.0

    def page(self, heading: str = "") -> Page:
        """A new page; ``heading`` stands at its head."""
        sheet = Page(*self.size, ink=INK)
        if heading:
            sheet.text(heading, MARGIN, TOP - 8.0, LEAD, True, self.accent)
            sheet.line(MARGIN, TOP - 5.2, self.size[0] - MARGIN, TOP - 5.2, HAIR)
        self.pages.append(sheet)
        return sheet


def _headed(piece: Plush, said: Words) -> dict[str, str]:
    """The parts that are headed otherwise than they are called: name → heading."""
    parts = piece.built.pattern.parts
    own = [b for b in said.blocks if b.section >= 0 and b.span is None and not parts[b.section].heading]
    return {name: b.name for b in own if (name := parts[b.section].name) and name != b.name}


def _as_headed(hers: Hers, part: PartText) -> PartText:
    """A part headed as she heads it, where its heading says more than its name in brackets: "EARS (grey, make 2)"."""
    for section, said, span in hers.headed:
        if section == part.section and (part.span is None or part.span[0] <= span.start < part.span[1]):
            found = _BRACKETED.fullmatch(said)
            if found is not None and " ".join(re.findall(r"\w+", found[1].lower())) == part.name.lower():
                return replace(part, headed=said.rstrip(".:"))
    return part


def _begun(piece: Plush, part: PartText) -> int:
    """Where a part is begun in its designer's text."""
    if part.section < 0:
        return -1
    section = piece.built.pattern.parts[part.section]
    return max(min(at.start for at in (section.span, *section.also)), part.span[0] if part.span is not None else 0)


def size_lines(book: Book, size: Size) -> list[tuple[str, str]]:
    """The finished size: (what, how much)."""
    width, height, depth = size.extent
    flat = size.how == "laid flat"
    made = [("height", depth if flat else height), ("width", width)]
    made += [] if flat else [("length" if along(book.piece, size) else "depth", depth)]
    said = [(book.own[name], book.length(mm)) for name, mm in made]
    if size.stitches and not flat:
        said.append((book.own["around"], book.length(size.around)))
    return said


def along(piece: Plush, size: Size) -> bool:
    """Whether a piece is longer than high: one that swims, or goes on four legs."""
    lies = any(part.lies for part in piece.built.pattern.parts)
    return size.how != "laid flat" and size.extent[2] > (1.0 if lies else _LONG) * size.extent[1]


def short(book: Book, what: str) -> str:
    """What stands at the head of a page: the title, cut where it is long, and what follows."""
    return f"{cut(book.title, LEAD, 90.0)} · {what}" if what else book.title


def cut(text: str, size: float, room: float) -> str:
    """The text, or its first words and an ellipsis."""
    lines = wrap(text, size, room)
    return text if len(lines) < 2 else wrap(text, size, room - 3.0)[0] + " …"


def weight_name(book: Book) -> str:
    """The class of the yarn, as the language's makers call it."""
    return book.own["weight"].format(name=yarn_name(book), number=WEIGHTS[book.piece.gauge.weight].number)


def yarn_name(book: Book) -> str:
    """The same without its number."""
    weight = book.piece.gauge.weight
    return book.said.terms.yarns.get(weight, WEIGHTS[weight].name)


def _main(piece: Plush) -> tuple[int, int, int]:
    """The colour that most of the yarn has that is no grey: in grey stands what is noted."""
    from tambour.crochet.maker.materials import lengths

    metres = lengths(piece)
    hues = {color: much for color, much in metres.items() if max(color) - min(color) >= _HUE}
    r, g, b = max(hues, key=lambda color: hues[color], default=(60, 54, 50))
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


def _in_order(colors: Array) -> list[tuple[int, ...]]:
    return list(dict.fromkeys(tuple(c) for c in colors.tolist()))

"""The diagrams of the booklet: of the parts that words alone tell badly, and the symbols that these hold."""

from __future__ import annotations

import re
from itertools import pairwise
from typing import Final

from tambour.core.drawing import Drawing
from tambour.crochet.graph.built import Built
from tambour.crochet.language.stitches import RULES
from tambour.crochet.page.book import FOOT, MARGIN, TOP, Book, short
from tambour.crochet.page.chart import Chart
from tambour.crochet.page.chart import charts as laid_out
from tambour.crochet.page.diagram import plates, symbols
from tambour.crochet.page.doubted import doubted
from tambour.crochet.page.type import BODY, HAIR, HEAD, INK, LEAD, LEADING, SMALL, SOFT, width_of, wrap
from tambour.crochet.page.written import Written, sections
from tambour.render.page import Page

_LARGEST: Final = 0.75
"""Scale at which a chart is large enough: a stitch is 5.2 mm wide."""
_READ: Final = {"chart rounds": False, "chart rows": True, "chart patch": None}
"""How charts are read → whether that is said of those in rows."""
_LEFT: Final = {"chart rounds": "chart rounds left"}
_PLAIN: Final = frozenset(
    ("sc", "inc", "dec", "mr", "ch", "slst", "again", "color", "blo", "flo", "bl", "join", "turn", "mark", "fo", "gap")
)
"""What a chart shows no better than words do."""
_INTO: Final = re.compile(r"(?:inc|dec)\d*")
_CHAIN: Final = frozenset(("ch", "turn", "color", "fo"))
_READABLE: Final = 0.42
"""Scale at which a chart is too small to read: a stitch is 3 mm wide."""
_LEAST, _TUBE, _EVEN = 8, 6, 0.5
"""Stitches of the smallest chart; of more rounds than these, of which so many are as the one before, a disc shows less than words."""
_FEW: Final = 4
"""A round or row of no more than so many different things is told by words."""


def helps(built: Built) -> frozenset[int]:
    """The parts that a chart tells better than words: of other stitches than the plain ones, or shaped unevenly."""
    found = set[int]()
    told = doubted(built.pattern) if built.pattern.terms else frozenset()
    for section, part, lines in sections(built):
        if any(line.span in told for line in section.lines):
            continue  # it would show what was taken, and not what she says
        done = [d.what for line in lines if not _joins(line) for unit, _ in line.pieces for d in unit]
        spaces = any(_spaces(line) for line in lines if line.number)
        odd = any(what not in _PLAIN and not _INTO.fullmatch(what) for what in done)
        plain = [line for line in lines if line.number and not _joins(line)]
        uneven = any(_units(line) > _FEW for line in plain)
        if (odd or spaces or uneven) and not set(done) <= _CHAIN:
            found.add(part)
    return frozenset(found)


def shows(chart: Chart, drawing: Drawing, wide: float, high: float) -> bool:
    """Whether a chart can be read, and says more than its outline: it is no single round about a hole, no long tube drawn as a disc, and
    no stitch of it is small on a page that is so ``wide`` and ``high``."""
    stitches = [node for node in chart.cells if node not in chart.base]
    if len(stitches) < _LEAST or (chart.base and len(chart.rounds) < 3):
        return False  # what is worked along an edge
    if not chart.rows:
        counts = [r.count for r in chart.rounds if r.count]
        plain = sum(a == b for a, b in pairwise(counts))
        if len(counts) > _TUBE and plain > _EVEN * len(counts):
            return False
    w, h = drawing.size.tolist()
    return min(_LARGEST, wide / w, high / h) >= _READABLE


def _joins(line: Written) -> bool:
    """Whether a round joins two pieces, or only closes an end."""
    return any(d.what in ("attach", "fold") for unit, _ in line.pieces for d in unit)


def _worked(line: Written) -> list[list[str]]:
    """What works stitches in a round, in its order, thing by thing."""
    made = [[d.what for d in unit if d.what not in RULES or d.what in ("mr", "ch")] for unit, _ in line.pieces]
    return [one for one in made if one]


def _units(line: Written) -> int:
    """Of how many different things, one after the other, a round is made."""
    return len(_worked(line))


def _spaces(line: Written) -> bool:
    """Whether chains stand among the stitches of a round, and do not only lift the hook at its beginning or its end."""
    done = _worked(line)
    inner = done[1:-1] if len(done) > 1 and done[-1] == ["ch"] else done[1:]
    return any("ch" in one for one in inner) or bool(done and len(done[0]) > 1 and "ch" in done[0])


def charts(book: Book) -> None:
    """The diagrams, as large as they may be, several on a page where they fit; the symbols on the first page."""
    mirrored = book.piece.params.hand == "left"
    wanted = helps(book.piece.built)
    wide = book.size[0] - 2 * MARGIN
    bottom = book.size[1] - FOOT
    each = zip(plates(book.piece.built, left=mirrored), laid_out(book.piece.built))
    found = [plate for plate, chart in each if plate[0] in wanted and shows(chart, plate[2], wide, bottom - TOP - 12.0)]
    wanted = frozenset(part for part, *_ in found)
    if not found:
        return
    title = short(book, book.own["charts"])
    scales = [min(_LARGEST, wide / d.size[0], (bottom - TOP - 12.0) / d.size[1]) for *_, d in found]
    sheet, y = book.below
    if y + 20.0 + float(found[0][2].size[1]) * scales[0] + LEAD > bottom:
        sheet, y = book.page(title), TOP
    else:
        sheet.text(book.own["charts"], MARGIN, y + HEAD * 0.8, HEAD, True, book.accent)
        sheet.line(MARGIN, y + HEAD * 1.2 + 0.6, MARGIN + wide, y + HEAD * 1.2 + 0.6, HAIR)
        y += HEAD * 1.2 + 3.0
    ways = {rows for _, rows, _ in found}
    note = " ".join(
        book.own[_LEFT.get(key, key) if mirrored else key]
        for key, there in _READ.items()
        if there in ways or there is None
    )
    y = sheet.paragraph(wrap(book.marked(note), BODY, wide), MARGIN, y + BODY, BODY, color=SOFT) + 0.5
    y = _symbols(book, sheet, wanted, MARGIN, y, wide)
    names = {block.part: block.title if len(book.said.blocks) > 1 else "" for block in book.said.blocks}
    row: list[tuple[str, float, float, int]] = []

    def placed(row: list[tuple[str, float, float, int]], y: float) -> float:
        x, tall = MARGIN, 0.0
        for name, scale, _, k in row:
            drawing = found[k][2]
            w, h = (drawing.size * scale).tolist()
            sheet.text(name, x, y + LEAD, LEAD, True)
            sheet.place(drawing, x, y + LEAD + 2.0, scale)
            x, tall = x + max(w, width_of(name, LEAD, True)) + 6.0, max(tall, h + LEAD + 6.0)
        return y + tall

    room = 0.0
    for k, (part, _, drawing) in enumerate(found):
        w, h = drawing.size.tolist()
        name = names.get(part, "")
        scale = scales[k]
        least = max(w * scale, width_of(name, LEAD, True))
        if row and room + 6.0 + least > wide:
            y = placed(row, y)
            row, room = [], 0.0
        tall = h * scale + LEAD + 6.0
        highest = max([found[j][2].size[1] * s + LEAD + 6.0 for _, s, _, j in row], default=0.0)
        if y + max(tall, highest) > bottom + 1.0:
            # Somewhat smaller on this page rather than a page of its own.
            left = bottom - y - LEAD - 6.0
            if not row and left > 0.72 * h * scale:
                scale = left / h
            else:
                y = placed(row, y) if row else y
                row, room = [], 0.0
                sheet, y = book.page(title), TOP
        row.append((name, scale, w * scale, k))
        room += (6.0 if len(row) > 1 else 0.0) + max(w * scale, width_of(name, LEAD, True))
    placed(row, y)


def _symbols(book: Book, sheet: Page, wanted: frozenset[int], x: float, y: float, wide: float) -> float:
    """The symbols that occur and what they mean; the height they end at."""
    left = x
    tall = 0.0
    terms = book.said.terms
    for name, drawing in symbols(book.piece.built, wanted):
        meaning = terms.meaning.get(name) or (terms.stitches.get(name) or terms.words.get(name) or (name,))[0]
        lines = wrap(meaning, SMALL, 40.0)
        w = 8.0 + max(width_of(line, SMALL) for line in lines) + 5.0
        if left + w > x + wide + 5.0 and left > x:
            left, y, tall = x, y + tall, 0.0
        scale = 0.85
        high = float(drawing.size[1]) * scale
        sheet.place(drawing, left, y + (0.0 if high > 5 else 1.0), scale)
        sheet.paragraph(lines, left + 7.6, y + 4.2, SMALL, color=INK)
        left, tall = left + w, max(tall, high + 2.0, len(lines) * SMALL * LEADING + 4.0)
    return y + tall + 3.0

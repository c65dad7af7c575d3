"""The body of the booklet: rounds part by part, with what the designer says between them, and eyes where hands still reach."""

from __future__ import annotations

import re
from dataclasses import replace

from tambour.core.picture import Picture
from tambour.crochet.finish.sewing import end_of
from tambour.crochet.graph.spots import Spots
from tambour.crochet.language.finishes import Placed, spots_of
from tambour.crochet.maker import sure
from tambour.crochet.page.among import noted, with_hers
from tambour.crochet.page.answered import says_way
from tambour.crochet.page.assembly import DOTS
from tambour.crochet.page.begin import heading, photo
from tambour.crochet.page.book import OURS, OWN, Book, cropped
from tambour.crochet.page.cleaned import heads
from tambour.crochet.page.flow import Atom, Chunk, plan, together
from tambour.crochet.page.middle import marked
from tambour.crochet.page.pictures import of_parts
from tambour.crochet.page.type import BODY, HAIR, INK, LEADING, SMALL, SOFT, width_of, wrap
from tambour.crochet.page.wording import PartText, Row
from tambour.render.page import Page

_THUMBS = (30.0, 25.0, 21.0)
"""How high pictures of a part are, mm: as high as costs no page."""
_SOME, _UPRIGHT = 6, 0.8
"""Rounds of a part that others are put on, or more; and how upright it is, as a cosine."""
_WHOLE = 0.8
"""A part that takes no more than this of a column is not broken."""
_HOLDS = 1000.0
"""What holds less than this, in cubic millimetres, is nothing that is stuffed: a curl."""
_TICK, _NEXT, _FIVE = 2.5, 3.2, 1.0
"""A box to tick, from one to the next, and the gap after five, mm."""
_STUFFS = re.compile(
    r"\bstuff(?!ing\b)|\bstuffing (?=the\b|it\b|them\b|each\b|before\b|as\b)|\b(?:start|begin|go on|continue|keep|keep on)\w* stuffing|\b(?:add|insert|put|push|fill)\w*\b[^.]{0,30}\bstuffing|\bfill(?:er|ing|ed)?\b|\b(?:no|without) stuffing|\bunstuffed\b"
)
"""How a designer says that something is stuffed; "weigh your stuffing" does not."""


def rounds(book: Book) -> list[Chunk]:
    """Every part: its heading and picture, then a row per line; the pictures as high as costs no page."""
    under = book.below[1]
    tried = [_rounds(book, high) for high in _THUMBS]
    return min(tried, key=lambda chunks: len(plan(chunks, book.frame, under)[1]))


def _rounds(book: Book, high: float) -> list[Chunk]:
    """The same with pictures of a height."""
    piece, said = book.piece, book.said
    width = book.frame.width
    chunks: list[Chunk] = []
    parts = piece.built.graph.parts
    for block in said.blocks:
        heads = heading(book, block.title, width)
        heads += [photo(cropped(one, width / OWN), width, OWN) for one in _hers_of(book, block)]
        if (
            not book.low
            and len(said.blocks) > 1
            and block.part >= 0
            and parts[block.part].end - parts[block.part].start > 2
        ):
            heads.append(_picture(book, block, width, high))
        rows = _rows(book, block, width)
        whole = Chunk([*heads, *rows], block.title)
        fits = whole.height <= _WHOLE * (book.frame.bottom - book.frame.top)
        chunks += [whole] if fits else together(heads, rows, block.title)
    return chunks


def _picture(book: Book, block: PartText, width: float, high: float) -> Atom:
    """A part by itself, drawn when its place is known."""

    def draw(sheet: Page, x: float, y: float) -> None:
        picture = of_parts(book.album, _alike(book, block), round(width * DOTS), round(high * DOTS))
        sheet.image(picture, x, y, width, high, photo=True)

    return Atom(high + 2.0, draw)


def _alike(book: Book, block: PartText) -> list[int]:
    """The first copy of a part, and of those that are the same in other colours."""
    made, built = [block.part], book.piece.built
    for k, fact in enumerate(built.parts):
        if (
            k > block.part
            and fact.copy == 1
            and built.pattern.parts[fact.section].twin
            and fact.section == block.section + len(made)
        ):
            made.append(k)
    return made


def _hers_of(book: Book, block: PartText) -> list[Picture]:
    """The designer's photos that stand with a part in her text; the first of all is on the cover."""
    starts = [section.span.start for section in book.piece.built.pattern.parts]
    if not 0 <= block.section < len(starts):
        return []
    begin = starts[block.section]
    after = book.hers.assembly if book.hers is not None else 1 << 60  # those of the assembly stand there
    end = min((at for at in (*starts, after) if at > begin), default=1 << 60)
    return [photo for at, photo in book.photos[1:] if begin <= at < end]


def _rows(book: Book, block: PartText, width: float) -> list[Atom]:
    rows = _explained(book, block, marked(book, block, with_hers(book, block)))
    labelled = [row for row in rows if row.label]
    label = max((width_of(row.label, BODY, True) for row in labelled), default=0.0) + 2.8
    count = max((width_of(f"({row.count})", BODY, True) for row in labelled if row.count), default=0.0) + 2.0
    return [_row(book, row, width, label, count) for row in rows]


def _ticks(times: int, room: float, taken: float) -> tuple[list[tuple[int, float]], int]:
    """A box for each of several rounds, in fives: the line and the place of each; and how many lines they take below the words.

    room : the width of the words' column, mm; taken : how much of it the last line of words takes
    """
    if times == 1:
        return [], 0
    long = (times - 1) * _NEXT + (times - 1) // 5 * _FIVE + _TICK
    if taken + long <= room:
        return [(0, room - long + k * _NEXT + k // 5 * _FIVE) for k in range(times)], 0
    each = max(5, int((room + _FIVE) / (5 * _NEXT + _FIVE)) * 5)
    places = [(1 + k // each, (k % each) * _NEXT + (k % each) // 5 * _FIVE) for k in range(times)]
    return places, places[-1][0]


def _row(book: Book, row: Row, width: float, label: float, count: float) -> Atom:
    """A line of a part: a box to tick, the round, what is done, its count; and the colours that it changes to."""
    changes = [color for color in row.colors if color in book.used]
    if not row.label:
        size, bold = SMALL if row.ours else BODY, row.hers and heads(row.words)
        said = OURS + row.words if row.ours else row.words
        lines = wrap(said, size, width - (7.0 if changes else 0.0), bold)
        ink = SOFT if row.ours else book.accent if bold else INK

        def alone(sheet: Page, x: float, y: float) -> None:
            for k, color in enumerate(changes[:1]):
                sheet.box(x + 5.4 * k, y + 0.5, 4.2, BODY + 0.2, color, HAIR, 0.15, 0.8)
            sheet.paragraph(lines, x + (6.2 if changes else 0.0), y + size, size, bold, ink)

        return Atom(len(lines) * size * LEADING + 1.0, alone, 2.4 if bold else 0.4, keep=bool(changes) or bold)
    left = _TICK + 2.0 + label
    lines = wrap(f"{row.words} {row.doubt}".strip(), BODY, width - left - count) or [""]
    ticks, below = _ticks(row.times, width - left - count, width_of(lines[-1], BODY) + 2.0)
    lines += [""] * below
    tall = len(lines) * BODY * LEADING + 1.1

    def draw(sheet: Page, x: float, y: float) -> None:
        base = y + BODY + 0.2
        for line, at in ticks if row.times > 1 else [(0, 0.1 - left)]:
            down = (line + len(lines) - 1 - below if row.times > 1 else 0) * BODY * LEADING
            sheet.box(x + left + at, base + down - _TICK + 0.15, _TICK, _TICK, None, SOFT, 0.2, 0.4)
        sheet.text(row.label, x + _TICK + 2.0, base, BODY, True)
        sheet.paragraph(lines, x + left, base, BODY)
        if row.count:
            sheet.text(f"({row.count})", x + width, base, BODY, True, anchor="end")
        for k, color in enumerate(changes[:6]):
            sheet.circles([(x + width - 1.0 - 2.6 * k, base + BODY * 0.9)], 0.95, color, HAIR)
        sheet.line(x, y + tall - 0.2, x + width, y + tall - 0.2, (236, 232, 226), 0.12)

    if changes and len(lines) == 1:
        tall += 2.0
    return Atom(tall, draw)


def _explained(book: Book, block: PartText, rows: list[Row]) -> list[Row]:
    """The lines with what hands must know besides: where a chain is begun on, in which loop a colour changes, which way up rounds run."""
    own, made, begun = book.own, list[Row](), False
    chain = _first_chain(book, block)
    for row in rows:
        words = row.words.strip("*") if noted(row) else row.words  # set in italics elsewhere
        if row.hers:
            pass  # in her own words
        elif not row.label and row.colors and begun:
            words = f"{own['in last loop'].format(change=words.rstrip('.:'))}."
        elif row.label and not begun and 2 <= chain <= 9:
            words = own["from chain"].format(n=own["chain places"].split(",")[chain - 1], items=words)
        elif not row.label and not begun and chain:
            words = _begun_with(book, words)
        begun = begun or bool(row.label)
        made.append(replace(row, words=words) if words != row.words else row)
    if book.hers is not None and block.part >= 0 and (end := book.taken.end(block.part)):
        made.append(Row("", end, ours=True))
    if made and (stuffed := _stuffed(book, block)):
        last = next(
            (k for k, row in enumerate(made) if k and row.hers and not row.label and heads(row.words)), len(made)
        )
        made.insert(last, Row("", stuffed, ours=True))
    if (way := _way_up(book, block)) and made:
        made.insert(0, Row("", way, ours=True))
    return made


def _begun_with(book: Book, words: str) -> str:
    """The chain that a piece begins with, in one: it is not turned before its first row, and what lifts the hook there is of it."""
    turn, ch = re.escape(book.said.terms.sentences["turn"]), re.escape(book.said.terms.word("ch"))
    found = re.search(rf"(\d+)( {ch}), {turn}(?:, (?:(\d+) )?({ch}))?\.$", words)
    if found is None:
        return words
    more = int(found[3] or 1) if found[4] else 0
    return f"{words[: found.start()]}{int(found[1]) + more}{found[2]}."


def _stuffed(book: Book, block: PartText) -> str:
    """That a part that is sewn on is stuffed, where she says nothing of it."""
    built = book.piece.built
    if book.hers is None or block.part < 0 or block.section < 0:
        return ""
    section, part = built.pattern.parts[block.section], built.graph.parts[block.part]
    sewn = [r for r in built.pattern.finish if isinstance(r, Placed) and r.part in (section.name, f"{section.name}.1")]
    if (
        not sewn
        or any(end_of(built, Spots(built), r).laid for r in sewn)
        or section.guessed
        or section.stuffing is not None
        or part.stuffing <= 0.0
        or float(book.piece.shape.volume[block.part]) * book.piece.stitch[0] ** 3 < _HOLDS
    ):
        return ""
    text, heads_ = built.pattern.text.text, [at.start for p in built.pattern.parts for at in (p.span, *p.also)]
    end = min((at for at in heads_ if at > section.span.start), default=len(text))
    rest = " ".join([*book.hers.intro, *book.hers.closing, *(w for w, _ in book.hers.about.get(block.section, []))])
    rest += " ".join(sure.paragraph(text, r.span.start, r.span.end, 3) for r in sewn if r.span.end > r.span.start)
    return "" if _STUFFS.search(f"{text[section.span.start : end]} {rest}".lower()) else book.own["is stuffed"]


def _first_chain(book: Book, block: PartText) -> int:
    """Into which chain from the hook the first row of a part is begun; 0 where it is begun on none."""
    graph = book.piece.built.graph
    mine = [r for r in book.piece.built.rounds if r.part == block.part and r.last >= r.first]
    if len(mine) < 2 or mine[0].number != 0 or not Spots(book.piece.built).in_rows[block.part]:
        return 0
    for node in range(mine[1].first, mine[1].last + 1):
        anchors = graph.anchors[graph.anchor_offsets[node] : graph.anchor_offsets[node + 1]]
        if len(anchors):
            return node - int(anchors[0])  # with the chains that lift the hook
    return 0


def _way_up(book: Book, block: PartText) -> str:
    """Whether a part that others are put on by its rounds is worked upwards or downwards, where the designer does not say it."""
    built = book.piece.built
    section = built.pattern.parts[block.section] if block.section >= 0 else None
    if book.hers is None or section is None or section.up is not None or block.part < 0:
        return ""
    if not any(spot.part == section.name for f in built.pattern.finish for spot in spots_of(f)):
        return ""
    mine = [r for r in built.rounds if r.part == block.part and r.count]
    if len(mine) < _SOME or says_way(book, block.section):
        return ""
    ends = [book.piece.positions[r.first : r.last + 1].mean(0) for r in (mine[0], mine[-1])]
    way = ends[1] - ends[0]
    if abs(way[1]) < _UPRIGHT * float((way @ way) ** 0.5):
        return ""
    said = book.said.terms.sentences["up end" if way[1] > 0.0 else "up start"]
    return f"{said[:1].upper()}{said[1:]}."

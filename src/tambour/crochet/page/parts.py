"""The body of the booklet: rounds part by part, their diagrams, and the steps that put the parts together."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from typing import Final

from tambour.core.check import Array
from tambour.core.picture import Picture
from tambour.crochet.language.finishes import Eye, Placed
from tambour.crochet.page.angle import angle, called
from tambour.crochet.page.begin import heading, paragraph
from tambour.crochet.page.book import FOOT, MARGIN, TOP, Book, cropped, short
from tambour.crochet.page.diagram import plates, symbols
from tambour.crochet.page.flow import Atom, Chunk, together
from tambour.crochet.page.pictures import Step, from_side, lies, of_parts, of_step, steps
from tambour.crochet.page.plain import eyes_now, reach
from tambour.crochet.page.type import BODY, HAIR, HEAD, INK, LEAD, LEADING, SMALL, SOFT, width_of, wrap
from tambour.crochet.page.wording import PartText, Row
from tambour.render.page import Page

_DOTS = 7.6  # pixels a mm of the small pictures
_THUMB = 30.0
_OWN = 52.0
"""How high pictures of a part are, and the designer's own photos, mm."""
_TICK = 2.5
_WITH = re.compile(r"(?:with|using|use|in|start|begin)\b.{0,60}$", re.IGNORECASE)
_LARGEST = 0.55
"""Scale at which a chart is large enough: a stitch is 3.9 mm wide."""
_READ: Final = {"chart rounds": False, "chart rows": True, "chart patch": None}
"""How charts are read → whether that is said of those in rows."""
_LEFT: Final = {"chart rounds": "chart rounds left"}


def rounds(book: Book) -> list[Chunk]:
    """Every part: its heading and picture, then a row per line."""
    piece, said = book.piece, book.said
    width = book.frame.width
    chunks: list[Chunk] = []
    parts = piece.built.graph.parts
    for block in said.blocks:
        heads = heading(book, block.title, width)
        heads += [_photo(cropped(photo, width / _OWN), width, _OWN) for photo in _hers_of(book, block)]
        if (
            not book.low
            and len(said.blocks) > 1
            and block.part >= 0
            and parts[block.part].end - parts[block.part].start > 2
        ):
            picture = of_parts(book.album, [block.part], round(width * _DOTS), round(_THUMB * _DOTS))
            heads.append(_photo(picture, width, _THUMB))
        chunks += together(heads, _rows(book, block, width), block.title)
    return chunks


def _hers_of(book: Book, block: PartText) -> list[Picture]:
    """The designer's photos that stand with a part in her text; the first of all is on the cover."""
    starts = [section.span.start for section in book.piece.built.pattern.parts]
    if not 0 <= block.section < len(starts):
        return []
    begin = starts[block.section]
    end = min((at for at in starts if at > begin), default=1 << 60)
    return [photo for at, photo in book.photos[1:] if begin <= at < end]


def _photo(picture: Picture, width: float, high: float) -> Atom:
    """A picture in the middle of a column."""
    return Atom(high + 2.0, lambda sheet, x, y: sheet.image(picture, x, y, width, high, photo=True))


def _rows(book: Book, block: PartText, width: float) -> list[Atom]:
    rows = with_hers(book, block)
    labelled = [row for row in rows if row.label]
    label = max((width_of(row.label, BODY, True) for row in labelled), default=0.0) + 2.8
    count = max((width_of(f"({row.count})", BODY, True) for row in labelled if row.count), default=0.0) + 2.0
    return [_row(book, row, width, label, count) for row in rows]


def _row(book: Book, row: Row, width: float, label: float, count: float) -> Atom:
    """A line of a part: a box to tick, the round, what is done, its count; and the colours that it changes to."""
    changes = [color for color in row.colors if color in book.used]
    if not row.label:
        lines = wrap(row.words, BODY, width - (7.0 if changes else 0.0))

        def alone(sheet: Page, x: float, y: float) -> None:
            for k, color in enumerate(changes[:1]):
                sheet.box(x + 5.4 * k, y + 0.5, 4.2, BODY + 0.2, color, HAIR, 0.15, 0.8)
            sheet.paragraph(lines, x + (6.2 if changes else 0.0), y + BODY, BODY)

        return Atom(len(lines) * BODY * LEADING + 1.0, alone, 0.4, keep=bool(changes))
    left = _TICK + 2.0 + label
    lines = wrap(row.words, BODY, width - left - count) or [""]
    tall = len(lines) * BODY * LEADING + 1.1

    def draw(sheet: Page, x: float, y: float) -> None:
        base = y + BODY + 0.2
        sheet.box(x + 0.1, base - _TICK + 0.15, _TICK, _TICK, None, HAIR, 0.25, 0.4)
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


def charts(book: Book) -> None:
    """The diagrams, as large as they may be, several on a page where they fit; the symbols on the first page."""
    mirrored = book.piece.params.hand == "left"
    found = plates(book.piece.built, left=mirrored)
    if not found:
        return
    wide = book.size[0] - 2 * MARGIN
    bottom = book.size[1] - FOOT
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
    y = sheet.paragraph(wrap(note, BODY, wide), MARGIN, y + BODY, BODY, color=SOFT) + 0.5
    y = _symbols(book, sheet, MARGIN, y, wide)
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


def _symbols(book: Book, sheet: Page, x: float, y: float, wide: float) -> float:
    """The symbols that occur and what they mean; the height they end at."""
    left = x
    tall = 0.0
    terms = book.said.terms
    for name, drawing in symbols(book.piece.built):
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


def sides(book: Book, sheets: Sequence[Page]) -> None:
    """The piece from three sides at the foot of the first of these pages that is still white there."""
    bottom, wide = book.size[1] - FOOT, book.size[0] - 2 * MARGIN
    gap = 5.0
    width = (wide - 2 * gap) / 3
    room = [min(bottom - sheet.lowest - 20.0, width * 1.2) for sheet in sheets]
    k = next((k for k, high in enumerate(room) if high >= 0.6 * width), None)
    if k is None or lies(book.piece):
        return
    sheet, high = sheets[k], room[k]
    y = bottom - high - 6.0
    long = any(part.up == "side" for part in book.piece.built.pattern.parts)
    for k, side in enumerate(("right", "top", "back") if long else ("front", "right", "back")):
        x = MARGIN + k * (width + gap)
        sheet.image(
            from_side(book.album, side, round(width * _DOTS), round(high * _DOTS)), x, y, width, high, photo=True
        )
        name = book.own["above" if side == "top" else side]
        sheet.text(name, x, y + high + SMALL + 1.6, SMALL, color=SOFT)


def assembly(book: Book, frame: Array) -> list[Chunk]:
    """The steps: a picture each, what is new in full colour, and the sentences."""
    piece, width = book.piece, book.frame.width
    # Eyes that are put in while the piece is open stand with the rounds.
    found = [step for step in steps(piece) if not _eyes_only(book, step)]
    if not found:
        return []
    high = width * (0.66 if len(found) <= 4 else 0.55)
    sentences = _sentences(book, found)
    chunks = []
    for k, (step, said) in enumerate(zip(found, sentences)):
        view = angle(piece, step.parts, step.fresh, " ".join(said))
        picture = of_step(book.album, step, frame, view, round(width * _DOTS), round(high * _DOTS))
        names = _names(book, step)
        if step.fresh and (where := called(view)):
            names += f" ({book.own[where]})"
        head = f"{book.own['step'].format(n=k + 1)}: {names}"

        def draw(sheet: Page, x: float, y: float, picture: Picture = picture, head: str = head) -> None:
            sheet.image(picture, x, y, width, high, photo=True)
            sheet.text(head, x, y + high + LEAD + 1.8, LEAD, True, book.accent)

        # Long lists of points are set smaller.
        size = BODY if max(map(len, said), default=0) < 160 else SMALL
        lines = [
            atom
            for k, sentence in enumerate(said)
            for atom in paragraph(sentence, width, size, None, 0.9 if k else 0.0)
        ]
        for note in _held(book, step):
            lines += paragraph(note, width, SMALL, SOFT, 0.9)
        chunks.append(Chunk([Atom(high + LEAD * 1.6 + 2.4, draw, 7.0), *lines], head))
    if any(step.fresh for step in found):
        chunks[0].atoms += paragraph(book.own["new"], width, SMALL, SOFT, 1.0)
    return chunks


def _held(book: Book, step: Step) -> list[str]:
    """How the ends of a designer's parts are sewn on in the pictures, which her sentence seldom says: pressed flat, as a ring, by the edge."""
    from tambour.crochet.finish.sewing import end_of
    from tambour.crochet.graph.spots import Spots

    built = book.piece.built
    if book.hers is None:
        return []
    spots, made = Spots(built), dict[str, None]()
    for record in (built.pattern.finish[n] for n in step.records):
        if not isinstance(record, Placed) or spots.in_rows[spots.parts[record.part]]:
            continue
        end = end_of(built, spots, record)
        open_ = len(spots.sewn_rim(spots.parts[record.part])) > 0
        if end.laid:
            made[book.own["sewn edge"]] = None
        elif open_ and end.ring and record.spot.stitch is not None:
            made[book.own["sewn ring"]] = None
        elif open_ and len(end.pinched):
            made[book.own["sewn flat"].format(n=len(end.nodes) - len(end.pinched))] = None
    return list(made)


def _eyes_only(book: Book, step: Step) -> bool:
    finish = book.piece.built.pattern.finish
    return bool(step.records) and all(isinstance(finish[n], Eye) for n in step.records)


def with_hers(book: Book, block: PartText) -> list[Row]:
    """A part's lines with what the designer says between them, and with the eyes where hands can still reach."""
    rows = list(block.lines)
    said = book.hers.inside.get(block.section, []) if book.hers is not None else []
    if said:
        whole = " ".join(words.lower() for _, words, _ in said)
        ours = [(row, row.words.lower()) for row in rows if not row.label and not row.colors]
        stuffs = _said(book, "stuff")
        drop = [
            row
            for row, words in ours
            if (stuffs & set(words.rstrip(".").split()[:1]) and "stuff" in whole)
            or (
                words in _ends(book)
                and re.search(r"fasten off|finish off|\bfo\b|break yarn|cut yarn|\bsl(?:ip)? ?st|\bjoin", whole)
            )
        ]
        rows = [row for row in rows if row not in drop]
    if said and said[0][0] == 0 and rows and rows[0].colors and not rows[0].label and _WITH.match(said[0][1]):
        rows[0], said = replace(rows[0], words=said[0][1]), said[1:]  # the colour in her words
    for after, words, _ in reversed(said):
        at = next((k + 1 for k, row in enumerate(rows) if row.number >= after > 0), 0 if after == 0 else len(rows))
        if words.split()[0].lower() in _said(book, "stuff"):
            inside = reach([(row.count, bool(row.label)) for row in rows])
            at = min(at, inside + 1) if inside >= 0 else at  # a closed piece takes no stuffing
        rows.insert(at, Row("", words))
    eyes = _eyes_here(book, block)
    if eyes and not any("eye" in words.lower() for _, words, _ in said):
        level = max(r.spot.round for r in eyes)
        last = max((row.count for row in rows), default=0)
        open_ = [k for k, row in enumerate(rows) if row.number >= level and 2 * row.count >= last]
        at = (max(open_) if open_ else max((k for k, row in enumerate(rows) if row.label), default=-1)) + 1
        rows.insert(at, Row("", eyes_now(book.own, book.spoken(eyes))))
    return rows


def _eyes_here(book: Book, block: PartText) -> list[Eye]:
    built = book.piece.built
    name = built.pattern.parts[block.section].name
    return [r for r in built.pattern.finish if isinstance(r, Eye) and r.spot.part in (name, f"{name}.1")]


def _said(book: Book, key: str) -> set[str]:
    """The first words of what the language says of stuffing."""
    return {s.split()[0].lower() for name, s in book.said.terms.sentences.items() if name.startswith(key)}


def _ends(book: Book) -> set[str]:
    return {f"{book.said.terms.sentences[key].lower()}." for key in ("close", "fasten off", "join")}


def _names(book: Book, step: Step) -> str:
    built = book.piece.built
    if not step.fresh:
        kinds = dict.fromkeys(type(built.pattern.finish[n]).__name__.lower() for n in step.records)
        return ", ".join(book.own[f"a {kind}"] for kind in kinds)
    found = dict.fromkeys(built.pattern.parts[built.parts[k].section].name for k in step.fresh)
    return ", ".join(name for name in found if name)


def _by_marks(book: Book, found: list[Step]) -> list[list[str]] | None:
    """Seams from marker to marker, a sentence for every part that is sewn on, by steps; None where stitches have no marks."""
    built = book.piece.built
    label = {node: name for name, node in built.marks.items()}
    if not len(built.sewn) or not all(int(n) in label for pair in built.sewn for n in pair):
        return None
    part, names = built.graph.part, [p.name for p in built.graph.parts]
    made: list[list[str]] = []
    for step in found:
        sewn: dict[tuple[int, int], list[str]] = {}
        for a, b in built.sewn.tolist():
            one, other = (a, b) if int(part[a]) in step.fresh else (b, a)
            if step.seams and int(part[one]) in step.fresh:
                said = (label[n].rsplit(".", 1)[0] for n in (one, other))
                pair = book.own["mark to"].format(**dict(zip(("one", "other"), said)))
                sewn.setdefault((int(part[one]), int(part[other])), []).append(pair)
        lines = [
            book.own["sewn by marks"].format(part=names[one], host=names[other], pairs=", ".join(pairs))
            for (one, other), pairs in sewn.items()
        ]
        made.append(lines)
    return made


def _sentences(book: Book, found: list[Step]) -> list[list[str]]:
    """The assembly's sentences, each with the step that it belongs to: the designer's own where there are, else ours."""
    built, seams = book.piece.built, book.said.seams
    finish = built.pattern.finish
    made: list[list[str]] = [[] for _ in found]
    part = built.graph.part
    marked = _by_marks(book, found)
    for k, line in enumerate(seams if marked is None else ()):
        at = 0
        if len(seams) == len(built.sewn):
            ends = set(part[built.sewn[k]].tolist())
            at = next((i for i, step in enumerate(found) if ends & set(step.fresh) and step.seams), 0)
        made[at].append(line)
    made = marked if marked is not None else [[" ".join(lines)] if lines else [] for lines in made]
    told: set[str] = set()
    for i, step in enumerate(found):
        records = [finish[n] for n in step.records]
        own = [r for r in records if book.words_of(r)]
        for record in own:
            words = book.words_of(record).rstrip(".") + "."
            if words not in told:
                told.add(words)
                more = book.hers.beside.get((record.span.start, record.span.end), []) if book.hers is not None else []
                made[i].append(" ".join([words, *more]))
        ours = [r for r in records if r not in own]
        made[i] += book.spoken(ours)
        if ours and book.hers is not None:
            made[i].append(book.own["guess"])
        if not made[i]:
            made[i] = book.spoken(records)
    return made

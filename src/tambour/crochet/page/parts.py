"""The body of the booklet: rounds part by part, with what the designer says between them, and eyes where hands still reach."""

from __future__ import annotations

import re
from dataclasses import replace

from tambour.core.errors import Span
from tambour.core.picture import Picture
from tambour.crochet.graph.spots import Spots
from tambour.crochet.language.finishes import Eye, Placed, spots_of
from tambour.crochet.page.assembly import DOTS
from tambour.crochet.page.begin import heading, photo
from tambour.crochet.page.book import OWN, Book, cropped
from tambour.crochet.page.flow import Atom, Chunk, plan, together
from tambour.crochet.page.middle import marked
from tambour.crochet.page.pictures import of_parts
from tambour.crochet.page.plain import eyes_now, reach
from tambour.crochet.page.type import BODY, HAIR, INK, LEADING, SMALL, SOFT, width_of, wrap
from tambour.crochet.page.wording import PartText, Row
from tambour.render.page import Page

_THUMBS = (30.0, 25.0, 21.0)
"""How high pictures of a part are, mm: as high as costs no page."""
_SOME, _UPRIGHT = 6, 0.8
"""Rounds of a part that others are put on, or more; and how upright it is, as a cosine."""
_WHOLE = 0.8
"""A part that takes no more than this of a column is not broken."""
_TICK, _NEXT, _FIVE = 2.5, 3.2, 1.0
"""A box to tick, from one to the next, and the gap after five, mm."""
_WHICH = re.compile(r"(?:the )?(?:first|second|1st|2nd|other|left|right) \w+\W*$", re.IGNORECASE)
"""A heading of one of two pieces that are written as one."""
_STUFFS = re.compile(
    r"\bstuff(?!ing\b)|\b(?:start|begin|go on|continue|keep|keep on)\w* stuffing|\b(?:add|insert|put|push|fill)\w*\b[^.]{0,30}\bstuffing|\bfill\b"
)
"""How a designer says that something is stuffed; "weigh your stuffing" does not."""
_FASTENS = re.compile(r"\b(?:fasten|finish|bind|tie) off\b[^.;\n]*", re.IGNORECASE)
"""How she says that a piece is done, up to the end of the sentence."""
_ROUND = re.compile(r"^\W*(?:rounds?|rnds?|rd|r)\.?\s*(\d+)(?:\s*[-–]\s*(?:r)?(\d+))?", re.IGNORECASE | re.MULTILINE)
_WITH = re.compile(r"(?:with|using|use|in|start|begin)\b.{0,60}$", re.IGNORECASE)


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
        size = SMALL if row.ours else BODY
        lines = wrap(row.words, size, width - (7.0 if changes else 0.0))

        def alone(sheet: Page, x: float, y: float) -> None:
            for k, color in enumerate(changes[:1]):
                sheet.box(x + 5.4 * k, y + 0.5, 4.2, BODY + 0.2, color, HAIR, 0.15, 0.8)
            sheet.paragraph(lines, x + (6.2 if changes else 0.0), y + size, size, color=SOFT if row.ours else INK)

        return Atom(len(lines) * size * LEADING + 1.0, alone, 0.4, keep=bool(changes))
    left = _TICK + 2.0 + label
    lines = wrap(row.words, BODY, width - left - count) or [""]
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
        words = row.words.strip("*") if _noted(row) else row.words  # set in italics elsewhere
        if not row.label and row.colors and begun:
            words = f"{own['in last loop'].format(change=words.rstrip('.'))}."
        elif row.label and not begun and 2 <= chain <= 9:
            words = own["from chain"].format(n=own["chain places"].split(",")[chain - 1], items=words)
        elif not row.label and not begun and chain:
            words = _begun_with(book, words)
        begun = begun or bool(row.label)
        made.append(replace(row, words=words) if words != row.words else row)
    if book.hers is not None and block.part >= 0 and (end := book.taken.end(block.part)):
        made.append(Row("", end, ours=True))
    if made and (stuffed := _stuffed(book, block)):
        made.append(Row("", stuffed, ours=True))
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
    sewn = any(isinstance(r, Placed) and r.part in (section.name, f"{section.name}.1") for r in built.pattern.finish)
    if not sewn or section.guessed or section.stuffing is not None or part.stuffing <= 0.0:
        return ""
    said = " ".join(words.lower() for _, words, _ in book.hers.inside.get(block.section, []))
    rest = " ".join([*book.hers.intro, *book.hers.closing]).lower()
    return "" if _STUFFS.search(f"{said} {rest}") else book.own["is stuffed"]


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
    said = " ".join(words.lower() for _, words, _ in book.hers.inside.get(block.section, []))
    if len(mine) < _SOME or "worked from" in said:
        return ""
    ends = [book.piece.positions[r.first : r.last + 1].mean(0) for r in (mine[0], mine[-1])]
    way = ends[1] - ends[0]
    if abs(way[1]) < _UPRIGHT * float((way @ way) ** 0.5):
        return ""
    said = book.said.terms.sentences["up end" if way[1] > 0.0 else "up start"]
    return f"{said[:1].upper()}{said[1:]}."


def with_hers(book: Book, block: PartText) -> list[Row]:
    """A part's lines with what the designer says between them, and with the eyes where hands can still reach."""
    rows = list(block.lines)
    said = book.hers.inside.get(block.section, []) if book.hers is not None else []
    if block.span is not None:
        said = [one for one in said if block.span[0] <= one[2].start < block.span[1]]
        heads = {name.lower() for other in book.said.blocks for name in (other.name, other.title)}
        said = [one for one in said if one[1].rstrip(".:").lower() not in heads and not _WHICH.match(one[1])]
        said = [(_after(book, one[2]) or one[0], *one[1:]) for one in said]
    if said:
        whole = " ".join(words.lower() for _, words, _ in said)
        ours = [(row, row.words.lower()) for row in rows if not row.label and not row.colors]
        stuffs = _said(book, "stuff")
        drop = [
            row
            for row, words in ours
            if (stuffs & set(words.rstrip(".").split()[:1]) and _STUFFS.search(whole))
            or (
                words in _ends(book)
                and re.search(
                    r"fasten off|finish off|\bfo\b|break yarn|cut (?:the )?yarn|\bsl(?:ip)? ?st|\bjoin", whole
                )
            )
        ]
        drop += [row for row in rows if not row.label and row.words == _hung_on(book, block)]
        rows = [row for row in rows if row not in drop]
    # The colour, and which way it is worked, in her words.
    dyed = next((k for k, row in enumerate(rows) if row.label or row.colors), 0)
    mine = next((k for k, one in enumerate(said) if one[0] == 0 and _WITH.match(one[1])), -1)
    if mine >= 0 and rows and rows[dyed].colors and not rows[dyed].label and _colour_alone(book, rows[dyed]):
        rows[dyed], said = replace(rows[dyed], words=said[mine][1]), [*said[:mine], *said[mine + 1 :]]
    if any("worked from" in words.lower() for _, words, _ in said):
        ways = {f"{book.said.terms.sentences[key]}.".lower() for key in ("up end", "up start", "up side", "up back")}
        rows = [row for row in rows if row.label or row.words.lower() not in ways]
    eyes = _eyes_here(book, block)
    end = len(rows)
    for after, words, span in reversed(said):
        begun = 1 if _begun(book, block, rows, span) else 0
        at = next((k + 1 for k, row in enumerate(rows) if row.number >= after > 0), begun if after == 0 else end)
        while after and at < len(rows) and _noted(rows[at]):
            at += 1  # what is noted with the round stands with it
        if words.split()[0].lower() in _said(book, "stuff"):
            inside = reach([(row.count, bool(row.label)) for row in rows])
            at = min(at, inside + 1) if inside >= 0 else at  # a closed piece takes no stuffing
        rows.insert(at, Row("", words))
        if (
            eyes
            and span.start < eyes[0].span.end
            and eyes[0].span.start < span.end
            and (apart := book.taken.eyes(eyes))
        ):
            rows.insert(at + 1, Row("", apart, ours=True))
    if eyes and not any("eye" in words.lower() for _, words, _ in said):
        level = max(r.spot.round for r in eyes)
        last = max((row.count for row in rows), default=0)
        open_ = next(
            found
            for share in (0.66, 0.5, 0.0)  # fingers and a washer want room, and as much of it as there is
            if (found := [k for k, row in enumerate(rows) if row.number >= level and row.count >= share * last > 0.0])
            or not share
        )
        at = (max(open_) if open_ else max((k for k, row in enumerate(rows) if row.label), default=-1)) + 1
        hers = book.words_of(eyes[0]) if _alone(book, eyes) else ""
        rows.insert(at, Row("", eyes_now(book.own, [hers.rstrip(".") + "."] if hers else book.spoken(eyes))))
        if hers and (apart := book.taken.eyes(eyes)):
            rows.insert(at + 1, Row("", apart, ours=True))
    return _fastened(book, block, rows)


def _fastened(book: Book, block: PartText, rows: list[Row]) -> list[Row]:
    """The lines of a part with her word that it is fastened off, where it stands behind its last round: an open end is no stitch of
    the round, and goes with it."""
    lines = book.piece.built.pattern.parts[block.section].lines if book.hers is not None and block.section >= 0 else ()
    last = next((k for k in range(len(rows) - 1, -1, -1) if rows[k].label), -1)
    if not lines or last < 0 or block.span is not None or any(_FASTENS.search(row.words) for row in rows[last:]):
        return rows
    text, start = book.piece.built.pattern.text.text, lines[-1].span.start
    end = text.find("\n", lines[-1].span.end - 1)
    found = _FASTENS.search(text, start, len(text) if end < 0 else end)
    if found is None:
        return rows
    words = " ".join(found[0].split())
    said = f"{words[:1].upper()}{words[1:]}."
    rest = [row for row in rows[last + 1 :] if not (_noted(row) and row.words.strip("*.").lower() in said.lower())]
    return [*rows[: last + 1], Row("", said), *rest]


def _noted(row: Row) -> bool:
    return not row.label and row.words[:1] == row.words[-1:] == "*"


def _hung_on(book: Book, block: PartText) -> str:
    """What is said of a part that hangs from the loops of a round, which a designer says herself."""
    name = book.piece.built.pattern.parts[block.section].name
    hung = next(
        (r for r in book.piece.built.pattern.finish if isinstance(r, Placed) and r.around and r.part == name), None
    )
    return "" if hung is None else f"{book.own['hung on'].format(n=f'{hung.spot.round:g}', part=hung.spot.part)}."


def _after(book: Book, span: Span) -> int:
    """The number of the round that stands before a sentence, by her text: of a piece that is made twice it is written once."""
    text = book.piece.built.pattern.text.text
    heads = list(_ROUND.finditer(text, max(0, text.rfind("\n\n", 0, span.start)), span.start))
    return int(heads[-1][2] or heads[-1][1]) if heads else 0


def _colour_alone(book: Book, row: Row) -> bool:
    """Whether a row says a colour and no stitches."""
    chain = book.said.terms.word("ch")
    return re.search(rf"\b{re.escape(chain)}\b", row.words) is None


def _begun(book: Book, block: PartText, rows: list[Row], span: Span) -> bool:
    """Whether the chain that a part begins with stands before a sentence of hers, and is its first row."""
    chain = book.said.terms.word("ch")
    if not rows or rows[0].label or not re.search(rf"\b{re.escape(chain)}\b", rows[0].words):
        return False
    text, lines = book.piece.built.pattern.text.text, book.piece.built.pattern.parts[block.section].lines
    heads = [line.span for line in lines if not line.number]
    return any(s.start < span.start and re.search(r"\d", text[s.start : s.end]) for s in heads)


def _alone(book: Book, eyes: list[Eye]) -> bool:
    """Whether a sentence of hers says these eyes, and nothing else."""
    spans = {r.span for r in eyes}
    others = [r for r in book.piece.built.pattern.finish if r.span in spans and r not in eyes]
    return len(spans) == 1 and not others


def _eyes_here(book: Book, block: PartText) -> list[Eye]:
    built = book.piece.built
    name = built.pattern.parts[block.section].name
    last = max((row.number for row in block.lines), default=0)
    return [
        r
        for r in built.pattern.finish
        if isinstance(r, Eye) and r.spot.part in (name, f"{name}.1") and r.spot.round <= last + 1
    ]


def _said(book: Book, key: str) -> set[str]:
    """The first words of what the language says of stuffing."""
    return {s.split()[0].lower() for name, s in book.said.terms.sentences.items() if name.startswith(key)}


def _ends(book: Book) -> set[str]:
    return {f"{book.said.terms.sentences[key].lower()}." for key in ("close", "fasten off", "join")}

"""The assembly of the booklet: its steps, a picture each, with the designer's sentences, and the finished toy from its sides."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from tambour.core.check import Array
from tambour.core.graph import SEWN
from tambour.crochet.finish.sewing import end_of, shut
from tambour.crochet.graph.spots import Spots
from tambour.crochet.language.finishes import Eye, Placed
from tambour.crochet.maker.size import skin
from tambour.crochet.maker.sure import joined
from tambour.crochet.page.angle import angle, called
from tambour.crochet.page.answered import onto, spoken_for
from tambour.crochet.page.begin import paragraph, photo, spoken_by_her
from tambour.crochet.page.book import FOOT, MARGIN, OWN, TOP, Book, cropped, short
from tambour.crochet.page.care import care_room
from tambour.crochet.page.flow import Atom, Chunk, plan
from tambour.crochet.page.pictures import Step, from_side, lies, of_step, steps
from tambour.crochet.page.placement import placement
from tambour.crochet.page.type import BODY, HEAD, LEAD, SMALL, SOFT
from tambour.crochet.page.undrawn import undrawn
from tambour.render.page import Page

DOTS = 7.6
"""Pixels a mm of the small pictures."""
_CLOSED = re.compile(
    r"\bboth (?:layers|thicknesses|sides)\b|\b(?:sew|stitch|sc|whip\w*)\b[^.]{0,25}\b(?:closed|shut)\b|\bto close\b",
    re.IGNORECASE,
)
"""How she says that an end is closed."""
_LOCKED = re.compile(r"\b(?:safety|snap|plastic|lock\w*|washers?)\b", re.IGNORECASE)
"""Eyes that are put in from outside and locked inside."""
_SEWN = re.compile(
    r"\b(?:beads?|buttons?|felt|glue\w*|embroider\w*|sew\w*|stitch(?:ed|ing)|(?<!\d )stitch|french|crochet\w*)\b",
    re.IGNORECASE,
)
"""Words of eyes that are put on from outside, when all else is done; "5 stitches apart" says only where."""
_LOWEST = 0.65
"""How high pictures of the finished toy are for their width, at the least."""
_SMALL = 0.6
"""What a step is about is shown from near where it is so small beside all that is there."""
_MORE = 1.35
"""So much more than that is in the picture: where it is, is seen."""
_SHARES = (0.85, 0.74, 0.62, 0.5, 0.38)
"""How high a step's picture is for its width: as high as costs no page."""
_SIDES = 55.0
"""Room for the finished toy from its sides, mm."""
_LOW_SIDES = 48.0
"""The same where care is to stand below them, mm."""
_GAP = 4.0
"""Between pictures, mm."""


def assembly(book: Book, frame: Array) -> list[Chunk]:
    """The steps: a picture each, what is new in full colour, and the sentences."""
    piece, width = book.piece, book.frame.width
    said = _told(book)
    found = [step for step, _ in said]
    placed = {k for step in found for k in step.fresh}
    beside = {k for k in range(len(piece.built.graph.parts)) if k not in book.album.all} - placed
    found = [replace(step, parts=tuple(k for k in step.parts if k not in beside)) for step in found]
    if not found:
        return []
    told = []
    for step, (_, sentences) in zip(found, said):
        # Long lists of points are set smaller.
        size = BODY if max((len(words) for words, _ in sentences), default=0) < 160 else SMALL
        lines: list[Atom] = []
        for sentence, notes in sentences:
            lines += spoken_by_her(book, sentence, width, size, 0.9 if lines else 0.0)
            for note in notes:
                lines += paragraph(f"› {note}", width, size, None, 0.9)
        told.append((angle(piece, step.parts, step.fresh, " ".join(words for words, _ in sentences)), lines))
    charts, tried = [*_not_drawn(book, beside), *placement(book)], []
    single = len(book.frame.lefts) == 1  # in a wide column lower ones are large enough
    for share in _SHARES[1:] if single else _SHARES[:-1]:
        chunks = [
            _step(book, k, step, view, lines, frame, width * share)
            for k, (step, (view, lines)) in enumerate(zip(found, told), 1)
        ]
        tried.append([*charts, *_with_hers(book, found, chunks)])
    return min(tried, key=lambda chunks: _pages(book, chunks))


def _not_drawn(book: Book, beside: set[int]) -> list[Chunk]:
    """Which of a designer's parts stand in no picture, since nothing says where they go."""
    built = book.piece.built
    made = [k for k in sorted(beside) if built.graph.parts[k].end - built.graph.parts[k].start > 2]
    names = dict.fromkeys(built.pattern.parts[built.parts[k].section].name for k in made)
    told = [*(book.called(name) for name in names if name), *(f"“{words}”" for words in undrawn(book))]
    if book.hers is None or not told:
        return []
    said = book.own["not drawn"].format(parts="; ".join(told))
    return [Chunk(paragraph(f"› {said}", book.frame.width))]


def guesses(book: Book) -> list[tuple[str, list[str]]]:
    """What we put on a designer's toy of which no sentence of hers says where, a sentence each with what is noted under it."""
    finish = book.piece.built.pattern.finish
    made = list[tuple[str, list[str]]]()
    for step in steps(book.piece):
        ours = [n for n in step.records if not book.words_of(finish[n]) and not onto(book, finish[n])]
        hers = [n for n in ours if spoken_for(book, finish[n])]
        for name in dict.fromkeys(
            record.part.rpartition(".")[0] or record.part for n in hers if isinstance(record := finish[n], Placed)
        ):
            made.append((f"{book.called(name)}: {book.own['not followed']}", []))
        ours = [n for n in ours if n not in hers]
        if ours and not _eyes_only(book, step):
            said = [*map(book.called, book.spoken([finish[n] for n in ours]))]
            made += [(words, []) for words in said[:-1]]
            made.append((said[-1], [book.own["guess"], *held(book, ours)]))
    return made


def _told(book: Book) -> list[tuple[Step, list[tuple[str, list[str]]]]]:
    """The steps, each with its sentences and what is noted under each; eyes that are put in while the piece is open stand with the rounds."""
    found = [step for step in steps(book.piece) if not _eyes_only(book, step)]
    return [(step, list(zip(said, _under(book, step, said)))) for step, said in zip(found, _sentences(book, found))]


def _step(
    book: Book, k: int, step: Step, view: tuple[float, float], lines: list[Atom], frame: Array, high: float
) -> Chunk:
    """The ``k``-th step, its picture ``high`` mm high, drawn when its place is known."""
    width = book.frame.width
    where = called(view) if step.fresh else ""
    seen = book.own[where] if where else ""
    head = f"{book.own['step'].format(n=k)}: {_names(book, step)}"

    def draw(sheet: Page, x: float, y: float) -> None:
        near = _near(book, step) if step.fresh else frame
        picture = of_step(book.album, step, near, view, round(width * DOTS), round(high * DOTS))
        sheet.image(picture, x, y, width, high, photo=True)
        sheet.text(seen, x + width - 1.6, y + high - 1.6, SMALL, color=SOFT, anchor="end")
        sheet.text(head, x, y + high + LEAD + 1.8, LEAD, True, book.accent)

    return Chunk([Atom(high + LEAD * 1.6 + 2.4, draw, 7.0), *lines], head)


def _pages(book: Book, chunks: list[Chunk]) -> tuple[int, bool]:
    """How many columns the steps begin, and one more where the finished toy finds no room below them; then whether care does not."""
    frame = book.frame
    under = book.below[1] if book.pages else frame.top
    first, rest = plan(chunks, frame, under + HEAD * 1.2 + 3.0)
    many = len(frame.lefts)
    last = rest[(len(rest) - 1) // many * many :] if rest else []
    top = frame.top if rest else under
    deep = max((sum(c.height + c.above for c in column) for column in last or first), default=0.0)
    room, care = frame.bottom - top - deep, care_room(book)
    return 2 * -(-len(rest) // many) + (room < _SIDES), care > 0.0 and room < _LOW_SIDES + care


def _near(book: Book, step: Step) -> Array:
    """What fills a step's picture: what is new and what it is sewn to, where that is small beside all that is there already."""
    graph = book.piece.built.graph
    pairs = graph.part[graph.edges[graph.edge_kind == SEWN]]
    beside = pairs[np.isin(pairs, step.fresh).any(1)].ravel()
    about = sorted({*step.fresh, *(int(k) for k in beside if k in step.parts)})
    there, near = (skin(book.piece, np.flatnonzero(np.isin(graph.part, parts))) for parts in (step.parts, about))
    if np.ptp(near, axis=0).max() > _SMALL * np.ptp(there, axis=0).max():
        return there
    middle = 0.5 * (near.min(0) + near.max(0))
    return np.asarray(middle + _MORE * (near - middle))


def _with_hers(book: Book, found: list[Step], chunks: list[Chunk]) -> list[Chunk]:
    """The steps with her photos of the assembly, each before the step that it stands before in her text."""
    if book.hers is None:
        return chunks
    width, finish, made = book.frame.width, book.piece.built.pattern.finish, list[Chunk]()
    waiting = [(at, one) for at, one in book.photos[1:] if at >= book.hers.assembly]
    for step, chunk in zip(found, chunks):
        last = max((finish[n].span.start for n in step.records), default=0)
        made += [Chunk([photo(cropped(one, width / OWN), width, OWN)]) for at, one in waiting if at <= last]
        waiting = [one for one in waiting if one[0] > last]
        made.append(chunk)
    return [*made, *(Chunk([photo(cropped(one, width / OWN), width, OWN)]) for _, one in waiting)]


def _under(book: Book, step: Step, said: list[str]) -> list[list[str]]:
    """What is noted under each sentence of a step: of several of hers each its own, else all under the last."""
    finish = book.piece.built.pattern.finish
    of = [[n for n in step.records if (w := book.sentence_of(finish[n])) and s.startswith(w.rstrip("."))] for s in said]
    if sum(map(bool, of)) < 2 or {n for one in of for n in one} != set(step.records):
        return [*([] for _ in said[1:]), held(book, step.records)]
    return [held(book, one) if one else [] for one in of]


def held(book: Book, numbers: Sequence[int]) -> list[str]:
    """How the ends of a designer's parts are sewn on, which her sentence seldom says, and what else the pictures had to choose."""
    built = book.piece.built
    if book.hers is None:
        return []
    spots, ways = (
        Spots(built),
        dict[str, dict[str, None]](),
    )  # of each part all the ways in which its copies are sewn on
    records = [built.pattern.finish[n] for n in numbers]
    for record in records:
        if not isinstance(record, Placed):
            continue
        made = ways.setdefault(built.pattern.parts[built.parts[spots.parts[record.part]].section].name, {})
        end = end_of(built, spots, record)
        if joined(book.words_of(record), built.pattern.terms) and not spots.place(record.spot).opening:
            continue  # edge to edge, which she says
        if spots.in_rows[spots.parts[record.part]] and not end.laid:
            continue
        open_ = len(spots.sewn_rim(spots.parts[record.part])) > 0
        many = "s" if sum(isinstance(r, Placed) for r in records) > 1 else ""
        if end.laid:
            made[book.own[f"sewn edge{many}"]] = None
        elif shut(spots, end.nodes) or _closed(book, record):
            made[book.own[f"sewn shut{many}"]] = None
        elif open_ and end.ring and record.spot.stitch is not None:
            made[book.own["sewn ring"]] = None
        elif open_ and len(end.pinched):
            key = "sewn odd" if len(end.nodes) % 2 else "sewn flat"
            made[book.own[key].format(n=len(end.pinched))] = None
    return [
        *dict.fromkeys(way for made in ways.values() if len(made) == 1 for way in made),
        *map(book.called, book.taken([r for r in records if book.words_of(r)])),
    ]  # of what is ours all is said already


def _closed(book: Book, record: Placed) -> bool:
    """Whether her sentences have an end closed before it is sewn on, by stitches that are no round."""
    assert book.hers is not None
    section = book.piece.built.parts[Spots(book.piece.built).parts[record.part]].section
    return any(_CLOSED.search(words) for words, _ in book.hers.inside.get(section, []))


def _eyes_only(book: Book, step: Step) -> bool:
    finish = book.piece.built.pattern.finish
    eyes = [r for r in (finish[n] for n in step.records) if isinstance(r, Eye)]
    return bool(eyes) and len(eyes) == len(step.records) and put_early(book, eyes)


def put_early(book: Book, eyes: Sequence[Eye]) -> bool:
    """Whether eyes are put in while their part is open: such as are locked inside, and not beads, felt or thread."""
    words = " ".join(dict.fromkeys(book.words_of(r) for r in eyes)).strip() if book.hers is not None else ""
    return locked(words)


def locked(words: str) -> bool:
    """Whether what is said of eyes has them locked inside; where nothing is said they are."""
    return bool(_LOCKED.search(words)) or not _SEWN.search(words)


def _names(book: Book, step: Step) -> str:
    built = book.piece.built
    if not step.fresh:
        kinds = dict.fromkeys(type(built.pattern.finish[n]).__name__.lower() for n in step.records)
        return ", ".join(book.own[f"a {kind}"] for kind in kinds)
    found = dict.fromkeys(built.pattern.parts[built.parts[k].section].name for k in step.fresh)
    return book.called(", ".join(name for name in found if name))


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
    told, places = set[str](), set[tuple[int, int]]()
    for i, step in enumerate(found):
        records = [finish[n] for n in step.records]
        own = [r for r in records if book.words_of(r)]
        for record in own:
            words, place = book.sentence_of(record), (record.span.start, record.span.end)
            if book.hers is None or place in places:
                continue
            places.add(place)
            made[i] += book.hers.ahead.get(place, [])
            more = [*([words] if words not in told else []), *book.hers.beside.get(place, [])]
            made[i] += [" ".join(more)] if more else []
            told.add(words)
        hers = {k: said for k, r in enumerate(records) if not onto(book, r) and (said := spoken_for(book, r))}
        made[i] += [w for w in dict.fromkeys(w for said in hers.values() for w in said) if w not in made[i]]
        made[i] += [f"› {book.own['not followed']}"] if hers else []
        here = dict.fromkeys(built.parts[k].section for k in step.fresh)
        more = [w for k in here for w, _ in book.hers.about.get(k, [])] if book.hers is not None else []
        made[i] += [w for w in more if w not in made[i]]  # of what is put on when all is sewn
        ours = [r for k, r in enumerate(records) if r not in own and k not in hers and not onto(book, r)]
        mark = "› " if book.hers is not None else ""  # of words that are none of hers
        made[i] += [f"{mark}{book.called(words)}" for words in book.spoken(ours)]
        for record in records:
            if isinstance(record, Placed) and onto(book, record):
                name, host = (one.rpartition(".")[0] or one for one in (record.part, record.spot.part))
                words = mark + book.called(book.own["worked onto"].format(part=name, onto=host))
                made[i] += [words] if words not in made[i] else []
        if ours and book.hers is not None:
            made[i].append(f"{mark}{book.own['guess']}")
        if not made[i] and not records and book.hers is not None:
            names = [n for n in _names(book, step).lower().split(", ") if n]  # "Tie on the scarf", at the end
            mine = [words for words in book.hers.closing if any(n in words.lower() for n in names)]
            book.hers.closing[:] = [words for words in book.hers.closing if words not in mine]
            made[i] = mine
        if not made[i]:
            made[i] = [book.marked(book.called(words)) for words in book.spoken(records)]
    if book.hers is not None:  # of parts that are in no picture
        seen = {built.parts[k].section for step in found for k in step.fresh}
        left = (one for k, said in book.hers.about.items() if k not in seen for one in said)
        book.hers.closing[:0] = [words for words, _ in sorted(left, key=lambda one: one[1].start)]
    return made


def finished(book: Book) -> None:
    """The finished toy from its sides, below the last step or on a page of its own: left and right are the toy's."""
    if lies(book.piece):
        return
    bottom, wide = book.size[1] - FOOT, book.size[0] - 2 * MARGIN
    long = any(part.lies for part in book.piece.built.pattern.parts)
    views = ("front", "right", "top", "below") if long else ("front", "right", "back", "top")
    care, under = care_room(book), 2.0 * SMALL + 1.6
    across = len(views)
    width = (wide - _GAP * (across - 1)) / across
    high = 1.2 * width
    sheet, y = book.below
    room = bottom - y - 1.6 * LEAD - under
    if room >= _LOWEST * width:
        high = min(high, room - care if room - care >= _LOWEST * width else room)
    if room < high:
        # On a page of its own it is large: two beside two.
        sheet, y, across = book.page(short(book, book.own["finished"])), TOP, 2
        width = (wide - _GAP) / across
        high = min(1.2 * width, 0.5 * (bottom - TOP - care) - under - _GAP)
    else:
        sheet.text(book.own["finished"], MARGIN, y + LEAD, LEAD, True, book.accent)
        y += LEAD * 1.6
    for k, side in enumerate(views):
        down, aside = divmod(k, across)
        x, top = MARGIN + aside * (width + _GAP), y + down * (high + under + _GAP)
        picture = from_side(book.album, side, round(width * DOTS), round(high * DOTS))
        sheet.image(picture, x, top, width, high, photo=True)
        name = book.own[{"top": "above", "right": "its left"}.get(side, side)]
        sheet.text(name, x, top + high + SMALL + 1.6, SMALL, color=SOFT)

"""The page before the first round: materials, size, gauge, abbreviations, how to read."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from math import ceil
from typing import Final

from tambour.core.picture import Picture
from tambour.core.rgb import RGB, unhexed
from tambour.crochet.language.finishes import Embroidery, Finish, Placed
from tambour.crochet.maker.materials import TAIL, materials
from tambour.crochet.maker.size import whole_size
from tambour.crochet.page.answered import says_middle
from tambour.crochet.page.book import OURS, OWN, Book, cropped, short, size_lines, weight_name, yarn_name
from tambour.crochet.page.care import care
from tambour.crochet.page.cleaned import heads
from tambour.crochet.page.flow import Atom, Chunk, flow, plan, together
from tambour.crochet.page.type import BODY, HAIR, HEAD, LEADING, SMALL, SOFT, width_of, wrap
from tambour.crochet.page.written import sections
from tambour.render.page import Page

_LISTED: Final = {
    "needle": re.compile(r"\bneedle"),
    "ends": re.compile(r"\bneedle"),
    "marker": re.compile(r"\bmarker"),
    "scissors": re.compile(r"\bscissors"),
}
"""What of the small things a designer's own list holds."""
_SPIRAL: Final = re.compile(r"\bspiral|\bcontinuous rounds|\b(?:do not|don.t) join", re.IGNORECASE)
_CHANGING: Final = re.compile(
    r"\b(?:to|when) chang(?:e|ing) colou?r|\bchange (?:the )?colou?rs? (?:on|in|with|at)\b|\bcolou?r changes?\s*:",
    re.IGNORECASE,
)
_COUNTED: Final = re.compile(
    r"\b(?:pairs?|one|two|three|four|six|[1-9]\d?(?!\s*-?\s*mm))\b(?!\s*-?\s*mm)[^.;\n]{0,25}\beyes?\b"
)
"""How a list of materials says how many eyes are needed."""
_FILLED: Final = re.compile(
    r"\b(?:stuffing|fill(?:er|ing)|fib(?:er|re)fill|polyfill|holofib(?:er|re))\b[^.;\n]{0,30}\d+\s*(?:g|gr|oz)\b|\d+\s*(?:g|gr|oz)\b[^.;\n]{0,20}\b(?:stuffing|fill(?:er|ing)|fib(?:er|re)fill)\b",
    re.IGNORECASE,
)
"""How much she says is stuffed."""
_HOWS: Final = ("french knot", "satin stitch", "backstitch", "whipstitch")
_BETWEEN: Final = re.compile(r"\b(?:between|betw?\.|zwischen|entre|tussen)", re.IGNORECASE)
_CLOSES: Final = re.compile(
    r"\bclos(?:e|ed|ing)\b(?: up)? (?:the |up )?(?:hole|opening|top|end|piece|remaining)\b|^close\b"
)
"""How she has a hole closed."""
_THROUGH: Final = re.compile(r"\b(?:through|thread|weave)\b[^.]{0,40}\b(?:loops?|last|remaining)\b")
"""How she says how that is done."""
_NAME: Final = 3
"""What says no more words than this of a thing names it and explains nothing."""
LEFTOVER = 5.0
"""Grams of yarn for which nobody buys a skein."""


def heading(book: Book, text: str, width: float, note: str = "") -> list[Atom]:
    """A section's title; ``note`` at its right."""
    side = width_of(note, SMALL) + 3.0 if note else 0.0
    lines = wrap(text, HEAD, width - side, True)

    def draw(sheet: Page, x: float, y: float) -> None:
        sheet.paragraph(lines, x, y + HEAD * 0.8, HEAD, True, book.accent, 1.2)
        sheet.text(note, x + width, y + HEAD * 0.8, SMALL, color=SOFT, anchor="end")
        sheet.line(x, y + HEAD * 1.2 * len(lines) + 0.6, x + width, y + HEAD * 1.2 * len(lines) + 0.6, HAIR)

    return [Atom(HEAD * 1.2 * len(lines) + 3.0, draw, 8.0)]


def paragraph(
    text: str, width: float, size: float = BODY, color: RGB | None = None, space: float = 0.0, bold: bool = False
) -> list[Atom]:
    """A paragraph, each line an atom of its own."""
    made = []
    for k, line in enumerate(wrap(text, size, width, bold)):

        def draw(sheet: Page, x: float, y: float, line: str = line) -> None:
            if color is None:
                sheet.text(line, x, y + size, size, bold)
            else:
                sheet.text(line, x, y + size, size, bold, color)

        made.append(Atom(size * LEADING, draw, space if k == 0 else 0.0))
    return made


def spoken_by_her(book: Book, words: str, width: float, size: float = BODY, space: float = 0.0) -> list[Atom]:
    """A sentence of hers, or a heading that stands among them."""
    if not heads(words):
        return paragraph(words, width, size, None, space)
    made = paragraph(words, width, BODY, book.accent, 2.4, True)
    return [replace(atom, keep=True) for atom in made]


def photo(picture: Picture, width: float, high: float) -> Atom:
    """A picture in the middle of a column."""
    return Atom(high + 2.0, lambda sheet, x, y: sheet.image(picture, x, y, width, high, photo=True), 4.0)


def pair(left: str, right: str, width: float, share: float = 0.45, bold: bool = True) -> Atom:
    """A row of a table of two columns."""
    a = wrap(left, BODY, width * share - 2.0, bold)
    b = wrap(right, BODY, width * (1 - share))
    tall = max(len(a), len(b)) * BODY * LEADING + 0.6

    def draw(sheet: Page, x: float, y: float) -> None:
        sheet.paragraph(a, x, y + BODY, BODY, bold)
        sheet.paragraph(b, x + width * share, y + BODY, BODY)

    return Atom(tall, draw)


def begin(book: Book, listed: Sequence[tuple[str, str]]) -> None:
    """Set what comes before the first round; ``listed``: the abbreviations and what they mean."""
    width = book.frame.width
    word, own = book.said.terms.word, book.own
    chunks: list[Chunk] = []
    if book.hers is not None and book.hers.intro:
        told = [
            atom
            for k, words in enumerate(book.hers.intro)
            for atom in spoken_by_her(book, words, width, space=1.4 if k else 0.0)
        ]
        chunks += together(heading(book, book.title, width), told, book.title)
    starts = [section.span.start for section in book.piece.built.pattern.parts]
    for at, picture in book.photos[1:]:
        if at < min(starts, default=0):
            chunks.append(Chunk([photo(cropped(picture, width / OWN), width, OWN)], book.title))
    if book.hers is not None:
        chunks.append(Chunk(paragraph(f"{OURS}= {own['ours sign']}.", width, SMALL), book.title))
    chunks += together(heading(book, word("materials"), width), _materials(book, width), word("materials"))
    size = whole_size(book.piece)

    rows = paragraph(book.sized, width, bold=True) if book.sized else []
    # What she says is on the cover, and is what a buyer holds her to: ours beside it would be a second size.
    rows += [] if book.sized else [pair(book.marked(what), much, width) for what, much in size_lines(book, size)]
    if size.how in own and not book.sized:
        rows += paragraph(book.marked(own[size.how]), width, SMALL, SOFT, 1.0)
    chunks.append(Chunk([*heading(book, word("finished size"), width), *rows], word("finished size")))
    chunks.append(Chunk([*heading(book, word("gauge"), width), *_gauge(book, width)], word("gauge")))
    measured = len(chunks)
    said = [
        atom
        for word_, meaning in listed
        for atom in ([pair(word_, meaning, width, 0.26)] if word_ else paragraph(meaning, width))
    ]
    if said:
        name = word("abbreviations")
        chunks += together(heading(book, name, width, book.said.named), said, name)
    hows = [(book.marked(word_), meaning) for word_, meaning in (*_hows(book), *_closing(book))]
    explained = (*((book.marked(word_), meaning) for word_, meaning in _ring(book)), *book.said.special, *hows)
    special = [pair(said, meaning, width, 0.3) for said, meaning in explained]
    if special:
        chunks += together(heading(book, word("special stitches"), width), special, word("special stitches"))
    notes = paragraph(book.marked(own["notes text" if book.hers is None else "notes hers"]), width)
    pattern = book.piece.built.pattern
    for key in _ways(book):
        notes += paragraph(book.marked(own[key]), width, space=1.4)
    if pattern.finish:
        lying = any(part.lies for part in pattern.parts)
        hers = [*book.hers.sentences, *book.hers.intro] if book.hers is not None else []
        said_ = [] if any(map(says_middle, hers)) else [own["below text" if lying else "front text"]]
        if book.hers is None or book.code not in ("us", "uk") or "apart" in pattern.text.text.lower():
            said_.append(own["apart below" if lying else "apart text"])
        if book.hers is not None and any(_between(book, record) for record in pattern.finish):
            said_.append(own["between text"])
        notes += paragraph(book.marked(" ".join(said_)), width, space=1.4) if said_ else []
    if any(isinstance(record, Placed) for record in pattern.finish):
        notes += paragraph(book.marked(_tails(book)), width, space=1.4)
        notes += paragraph(book.marked(own["new"]), width, space=1.4)
    chunks += together(heading(book, own["notes"], width), notes, own["notes"])
    cared = [
        *chunks[:measured],
        Chunk([*heading(book, own["care"], width), *_care(book, width)], own["care"]),
        *chunks[measured:],
    ]
    fits = [len(plan(some, book.frame, book.frame.bottom)[1]) for some in (chunks, cared)]
    if len(book.frame.lefts) > 1 and fits[1] <= min(fits[0], len(book.frame.lefts)):
        chunks, book.cared = cared, True  # white that the columns leave, rather than a page of its own at the end
    flow(chunks, book.frame, lambda: book.page(short(book, own["before"])), own["continued"])


def _care(book: Book, width: float) -> list[Atom]:
    """How the piece is washed, in a column."""
    told = [
        atom
        for k, words in enumerate(care(book))
        for atom in paragraph(book.marked(words), width, space=1.4 if k else 0.0)
    ]
    return [*told, *paragraph(book.marked(book.own["made"]), width, SMALL, SOFT, 1.0)]


def _ring(book: Book) -> list[tuple[str, str]]:
    """What a magic ring is, where a part begins with one and she does not explain it."""
    if not any(done.what == "mr" for done in book.piece.built.log):
        return []
    word = book.said.terms.word("ring")
    if book.hers is not None and any(len(meaning.split()) > _NAME for meaning in _meant(book, word)):
        return []
    return [(word[:1].upper() + word[1:], book.own["ring text"])]


def _meant(book: Book, word: str) -> list[str]:
    """What her list of abbreviations says of a word, and of what stands for it."""
    assert book.hers is not None
    return [
        meaning for said, meaning in book.hers.terms.items() if said.lower() == word or meaning.lower().startswith(word)
    ]


def _between(book: Book, record: Finish) -> bool:
    """Whether her sentence has something between rounds."""
    if not isinstance(record, Placed | Embroidery) or _BETWEEN.search(book.words_of(record)) is None:
        return False
    return bool(book.taken.rounds(record))


def _ways(book: Book) -> list[str]:
    """What is to be known of how this pattern is worked: in a spiral, in rows, in several colours."""
    spirals, turning = False, False
    for _, _, written in sections(book.piece.built):
        done = [[d.what for unit, _ in line.pieces for d in unit] for line in written if line.number]
        if any("turn" in line for line in done):
            turning = turning or any(line[0] == "ch" for line in done)
        elif sum(line.times for line in written if line.number) > 2:
            spirals = spirals or not any("join" in line for line in done)
    changed = False
    for block in book.said.blocks:
        begun = [k for k, row in enumerate(block.lines) if row.label]
        # Where a line says the change alone, how it is done stands there.
        later = block.lines[begun[0] + 1 :] if begun else ()
        changed = changed or any(row.colors and (row.label or book.hers is not None) for row in later)
    intro = " ".join(book.hers.intro) if book.hers is not None else ""
    spirals = spirals and not _SPIRAL.search(intro)  # she says it herself
    changed = changed and not _CHANGING.search(intro)
    return ["spiral"] * spirals + ["turning text"] * turning + ["change text"] * changed


def _hows(book: Book) -> list[tuple[str, str]]:
    """How the stitches are made that her sentences name, and nobody explains."""
    if book.hers is None or book.code not in ("us", "uk"):
        return []
    pattern = book.piece.built.pattern
    ours = book.taken([r for r in pattern.finish if isinstance(r, Embroidery) and book.words_of(r)])
    tails = [_tails(book)] if any(isinstance(record, Placed) for record in pattern.finish) else []
    text = " ".join([pattern.text.text, *ours, *tails])
    found = [
        (word, re.search(rf"\b{word.replace(' ', ' ?')}(?:es|s)?\b(?!\s*[=:(–-])", text, re.IGNORECASE))
        for word in _HOWS
    ]
    return [(word.capitalize(), book.own[f"how {word}"]) for word, there in found if there]


def _tails(book: Book) -> str:
    """How much yarn is left to sew parts on with, and how that is done: as much as the list of yarns counts for it."""
    much = f"{book.number(100.0 * TAIL, 0)} cm"
    return book.own["tail text"].format(
        length=f"{much} ({book.number(TAIL / 0.0254, 0)} in)" if book.imperial else much
    )


def _closing(book: Book) -> list[tuple[str, str]]:
    """How a hole is closed, where a line has one closed, and she does not say how."""
    closes = book.said.terms.sentences["close"].lower()
    said = [row.words.lower() for block in book.said.blocks for row in block.lines if not row.label]
    if not any(closes in words or (book.code in ("us", "uk") and _CLOSES.search(words)) for words in said):
        return []
    if any(_THROUGH.search(words) for words in said):
        return []
    return [(book.own["closing"], book.own["how close"])]


def _materials(book: Book, width: float) -> list[Atom]:
    """Yarn by colour with swatches, then all that else is needed."""
    own, number = book.own, book.number
    found = materials(book.piece)
    made: list[Atom] = []
    hers = book.hers.materials if book.hers is not None else []
    listed = hers or list(book.said.materials)
    for line in listed:
        made += paragraph(f"• {line}" if hers else line, width)
    said = hers and "yarn" in book.piece.built.pattern.stated  # her own line names its class, in her words
    if not said and not any(yarn_name(book).lower() in line.lower() for line in listed):
        fibre = own.get(f"of {book.piece.params.material}", "")
        named = f"{book.said.terms.word('yarn')}: {weight_name(book)}" + (f", {fibre}" if fibre else "")
        made += paragraph(book.marked(named), width, BODY, None, 1.0 if made else 0.0, True)
    if said:
        made += paragraph(book.marked(own["used"]), width, SMALL, SOFT, 1.6)
    for yarn in found["yarn"]:
        color = unhexed(yarn["color"])
        letter, name = book.said.color(color)
        key = "leftover" if yarn["grams"] < LEFTOVER else "skein" if yarn["skeins"] == 1 else "skeins"
        skein = own[key].format(n=yarn["skeins"], grams=number(found["weight"]["skein_g"], 0))
        skein = "" if said else skein  # what is bought she says herself
        metres = float(ceil(yarn["metres"]))
        much = f"{number(metres, 0)} m"
        if book.imperial:
            much += f" / {number(metres / 0.9144, 0)} yd"
        grams = f"{number(ceil(yarn['grams']), 0)} g"
        made.append(_yarn(color, letter, name, much, grams, skein, width))
    threads: dict[RGB, float] = {}
    for thread in found["embroidery"]:
        color = unhexed(thread["color"])
        threads[color] = threads.get(color, 0.0) + thread["cm"]
    held = {unhexed(yarn["color"]) for yarn in found["yarn"]}
    for color, cm in threads.items():
        if color in held:
            continue  # a little of a yarn that is there already
        letter, name = book.said.color(color)
        made.append(_yarn(color, letter, name, "", own["embroidery"].format(cm=number(cm, 0)), "", width))
    note = own["typical" if found["weight"]["from"] == "typical" else "ball"].format(
        name=yarn_name(book), metres=number(found["weight"]["metres_100_g"], 0)
    )
    made += paragraph(book.marked(note), width, SMALL, SOFT, 0.8)
    other: list[tuple[str, str]] = []
    if "hook" not in book.piece.built.pattern.stated:
        other.append((own["hook"], f"{number(book.piece.gauge.hook, 2)} mm"))
    listed_ = " ".join(hers).lower() if book.code in ("us", "uk") else ""
    for eye in found["eyes"] if "eye" not in listed_ or not _COUNTED.search(listed_) else ():
        word = own["eye" if eye["count"] == 1 else "eyes"]
        name = book.said.color(unhexed(eye["color"]))[1]
        other.append(
            (book.said.terms.word("eyes"), f"{word.format(n=eye['count'], size=number(eye['size_mm']))}, {name}")
        )
    for felt in found["felt"]:
        words = own["felt"].format(n=felt["count"], w=number(felt["width_mm"]), h=number(felt["height_mm"]))
        other.append((book.said.color(unhexed(felt["color"]))[1], words))
    for hair in found["hair"]:
        words = own["hair"].format(n=hair["strands"], cm=number(hair["cut_mm"] / 10, 0))
        other.append((book.said.color(unhexed(hair["color"]))[1], words))
    filling = found["stuffing"]
    if filling["grams"] > 0.05 and not _FILLED.search(" ".join(hers)):
        other.append(
            (
                own["stuffing"],
                own["fill"].format(grams=number(max(1.0, filling["grams"]), 0)),
            )
        )
    lacking = [n for n in found["notions"] if not _LISTED[n].search(listed_)]
    if lacking and lacking != ["scissors"]:
        other.append((own["notions"], "; ".join(own[n] for n in lacking)))
    for k, (what, much) in enumerate(other):
        row = pair(book.marked(what[:1].upper() + what[1:]), much, width, 0.3)
        made.append(Atom(row.height, row.draw, 2.0 if k == 0 else 0.0))
    return made


def _yarn(color: RGB, letter: str, name: str, much: str, grams: str, skein: str, width: float) -> Atom:
    """A row of the yarn table: swatch, letter and name, length, mass, skeins."""

    def draw(sheet: Page, x: float, y: float) -> None:
        sheet.box(x, y + 0.2, 6.0, 4.6, color, HAIR, 0.15, 0.9)
        base = y + BODY + 0.6
        sheet.text(letter, x + 8.0, base, BODY, True)
        sheet.text(wrap(name, BODY, width - 50.0)[0] if name else "", x + (12.0 if letter else 8.0), base, BODY)
        sheet.text(much, x + width - 17.0, base, BODY, anchor="end")
        sheet.text(grams, x + width, base, BODY, bool(much), anchor="end")
        sheet.text(skein, x + width, base + SMALL * 1.35, SMALL, color=SOFT, anchor="end")
        sheet.line(x, y + tall - 0.8, x + width, y + tall - 0.8, HAIR, 0.12)

    tall = 9.4 if skein else 6.8
    return Atom(tall, draw, 0.6)


def _gauge(book: Book, width: float) -> list[Atom]:
    """The gauge, flat and as a circle, and where it comes from."""
    known, own = book.piece.gauge, book.own
    flat = own["swatch"].format(stitches=book.number(100.0 / known.width, 0), rows=book.number(100.0 / known.height, 0))
    across = known.circle
    circle = own["circle"].format(cm=book.number(across / 10), inch=book.number(across / 25.4))
    made = [*paragraph(book.marked(flat), width), *paragraph(book.marked(circle), width, space=0.8)]
    stated = book.piece.built.pattern.stated
    if "gauge" in stated:
        made = [*paragraph(" ".join(stated["gauge"][0].split()), width, bold=True), *made]
    if "gauge" not in known.told:
        made += paragraph(book.marked(own["expected"]), width, space=0.8)
    return [*made, *paragraph(book.marked(own["tight"]), width, SMALL, SOFT, 1.0)]

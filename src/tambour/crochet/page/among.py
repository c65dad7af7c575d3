"""Among: the lines of a part in the order of its designer's text, each of her sentences once, and ours beside them, as ours."""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Final

from tambour.core.errors import Span
from tambour.crochet.language.finishes import Eye, Finish, Placed
from tambour.crochet.page.answered import says_way
from tambour.crochet.page.assembly import held, put_early
from tambour.crochet.page.book import Book
from tambour.crochet.page.cleaned import cleaned
from tambour.crochet.page.ordered import Stretch, her_round
from tambour.crochet.page.plain import eyes_now, reach
from tambour.crochet.page.wording import PartText, Row
from tambour.crochet.words.table import TERMS

_WHICH: Final = re.compile(r"(?:the )?(?:first|second|1st|2nd|other|left|right) \w+\W*$", re.IGNORECASE)
"""A heading of one of two pieces that are written as one."""
_HEAD_ALONE: Final = re.compile(
    r"\W*(?:next\s+)?(?:[^\W\d]{1,8}\.?\s*)?\d*(?:\s*[-–—]\s*\d+)?(?:st|nd|rd|th)?(?:\s*[^\W\d]{1,8})?\W*"
)
"""The number of a round and nothing else."""
_NUMBERED: Final = re.compile(
    r"\W*(?:(?P<before>rounds?|rnds?|rows?)\s*[.:#]*\s*(?P<a>\d+)\b|(?P<b>\d+)(?:st|nd|rd|th)\s+(?P<behind>rounds?|rnds?|rows?)\b"
    r"|(?:next|last)\s+(?:\w+\s+)?(?P<next>rounds?|rnds?|rows?)\b)",
    re.IGNORECASE,
)
"""How a round is headed: "Row 3", "3rd row"."""
_CLOSED: Final = 8
"""A part whose last round has so few stitches is closed by it."""
_COPIES: Final = frozenset(
    (
        "make",
        "makes",
        "of",
        "x",
        "each",
        "both",
        "two",
        "three",
        "four",
        "six",
        "times",
        "pieces",
        "piece",
        "pcs",
        "pc",
        "the",
        "and",
        "a",
        "1",
    )
)
_FOLDS: Final = re.compile(r"\W*(?:fold|flatten|press|pinch|squash)\b", re.IGNORECASE)
"""How a sentence begins that closes an end and is no round: nothing is counted or ticked there."""
_WORD: Final = re.compile(r"[^\W_]+")


@dataclass(frozen=True, slots=True)
class _Spoken:
    """Words of a language. yarn : how she says which yarn a part is begun in; count : a count within a round; done : what ends one → our
    words for it."""

    yarn: re.Pattern[str]
    count: re.Pattern[str]
    done: Mapping[str, str]


@lru_cache(maxsize=8)
def _spoken(code: str) -> _Spoken:
    terms = TERMS[code]

    def spelled(*keys: str) -> list[str]:
        tables = (terms.stitches, terms.words, terms.heard.stitches, terms.heard.words)
        return sorted(
            {s.lower() for key in keys for table in tables for s in table.get(key, ())}, key=len, reverse=True
        )

    def one_of(words: Iterable[str]) -> str:
        return f"(?:{'|'.join(re.escape(word) for word in words)})"

    st, adverbs = one_of(spelled("sc", "hdc", "dc", "tr", "stitch")), terms.sentences["gap"].split()[2:]
    spread = rf"\b(\d+) {st} {one_of(adverbs)}(?: \w+)? {one_of(spelled('around'))}\b"
    return _Spoken(
        re.compile(rf"\b{one_of([*spelled('with'), terms.word('join')])}\b", re.IGNORECASE),
        re.compile(rf"(?:[–—]|\s-\s|=)\s*(\d+) {st}\b|{spread}", re.IGNORECASE),
        {f"{said}.": terms.sentences[key] for key in ("turn", "join") for said in spelled(key)},
    )


def with_hers(book: Book, block: PartText, steps: bool = False) -> list[Row]:
    """A part's lines with what the designer says between them, and with the eyes where hands can still reach.

    steps : her sentences of putting it together stand here as well, where she wrote them, with what is ours about them
    """
    if book.hers is None:
        return [row for row, _ in _eyes(book, block, [(row, -1) for row in block.lines], [], steps)]
    placed = list(_worked(book, block))
    said = list(_said(book, block, steps))
    for words, span in said:
        _insert(placed, Row("", words, span=span, hers=True), span.start)
        if steps:
            at = next(k for k, (row, _) in enumerate(placed) if row.span == span and row.hers)
            placed[at + 1 : at + 1] = [(Row("", note, ours=True), span.start) for note in notes_at(book, span)]
    first = next((k for k, (row, _) in enumerate(placed) if row.label), len(placed))
    heard = _spoken(book.code)
    named = {word.lower() for word in _WORD.findall(block.headed)}
    hued = [
        {w.lower() for w in _WORD.findall(book.said.color(row.colors[0])[1])}
        for row, _ in placed
        if row.ours and row.colors
    ]
    lead = " ".join(row.words.lower() for row, _ in placed[: first + 1] if row.hers)
    hues = {word for words in book.said.terms.colors.values() for word in words} | {*book.said.hues}
    dyed = any(re.search(rf"(?<!\w){re.escape(word.lower())}(?!\w)", lead) for word in hues)
    if (
        dyed
        or any(heard.yarn.search(row.words) for row, _ in placed[: first + 1] if row.hers)
        or any(hue and hue <= named for hue in hued)
    ):
        placed = [one for k, one in enumerate(placed) if k >= first or not (one[0].ours and one[0].colors)]
    placed = [one for k, one in enumerate(placed) if not _done_there(placed, k, heard.done)]
    placed = _filled(book, block, _eyes(book, block, placed, said, steps))
    return _as_she_numbers(book, placed)


def _done_there(placed: list[tuple[Row, int]], k: int, done: Mapping[str, str]) -> bool:
    """Whether a sentence of hers is a turn, a join or another yarn that stands in our words of the round before it: "7 sc. Turn."."""
    row = placed[k][0]
    if not row.hers or row.label or not k:
        return False
    before, words = placed[k - 1][0], row.words.lower()
    ended = done.get(words) or f", {words.rstrip('.')}"  # "9 sc, change to ginger"
    return bool(before.label) and not before.hers and before.words.lower().endswith(ended)


def _as_she_numbers(book: Book, placed: list[tuple[Row, int]]) -> list[Row]:
    """The rows with her word for each, and her number where hers begin again within a part: "Row 2 of the bib" is looked for."""
    text, terms = book.piece.built.pattern.text.text, book.said.terms
    if terms.code not in ("us", "uk"):
        return [row for row, _ in placed]
    heads = [
        _NUMBERED.match(text, row.span.start) if row.label and row.span is not None and place >= 0 else None
        for row, place in placed
    ]
    kinds = [next(w for w in (m["before"], m["behind"], m["next"]) if w) if m is not None else "" for m in heads]
    word, off, made = next((kind for kind in kinds if kind), ""), 0, list[Row]()
    for (row, _), found, kind in zip(placed, heads, kinds):
        word, label = kind or word, row.label
        if found is not None and not found["next"]:
            number, ours = int(found["a"] or found["b"]), int(re.findall(r"\d+", label)[0])
            off = number - ours if number in (1, ours) else off
        if word and label:
            label = re.sub(r"^\D+", f"{terms.word('row' if word.lower().startswith('row') else 'round')} ", label)
            label = "".join(f"{int(w) + off}" if w.isdigit() else w for w in re.split(r"(\d+)", label))
        made.append(replace(row, label=label))
    return made


def notes_at(book: Book, span: Span) -> list[str]:
    """What is ours about a sentence of hers: how ends are sewn on, and what the pictures had to choose."""
    finish = book.piece.built.pattern.finish
    mine = [n for n, r in enumerate(finish) if r.span.start < span.end and span.start < r.span.end and book.words_of(r)]
    eyes = [r for r in (finish[n] for n in mine) if isinstance(r, Eye)]
    apart = book.taken.eyes(eyes) if eyes else ""
    return [*(_by_parts(book, mine) if mine else []), *([apart] if apart else [])]


def _by_parts(book: Book, mine: list[int]) -> list[str]:
    """What is noted of several parts that one sentence sews on, each note with the parts that it is of."""
    finish, of = book.piece.built.pattern.finish, dict[str, list[int]]()
    for n in mine:
        record = finish[n]
        of.setdefault(record.part.split(".")[0] if isinstance(record, Placed) else "", []).append(n)
    if len(of) < 2:
        return held(book, mine)
    told = dict[str, list[str]]()
    for name, numbers in of.items():
        for note in held(book, numbers):
            told.setdefault(note, []).append(name)
    return [
        note if not all(names) or len(names) == len(of) else f"{book.called(', '.join(names))}: {note}"
        for note, names in told.items()
    ]


# -- rounds -------------------------------------------------------------------------------------------------------------


def _worked(book: Book, block: PartText) -> Iterator[tuple[Row, int]]:
    """The rows of a part in her words, those that she writes under another part in ours, each with its place in her text, -1 for none."""
    assert book.hers is not None
    text = book.piece.built.pattern.text.text
    many = len({hue for one in book.said.blocks for row in one.lines for hue in row.colors}) > 1
    her_way = says_way(book, block.section)
    blocks = {one.section for one in book.said.blocks}
    told: set[int] = set()
    rows: list[tuple[Row, int]] = []
    of: dict[int, list[Row]] = {}
    for row in block.lines:
        of.setdefault(_at(book, row.span), []).append(row)
    rowed = {k for one in book.said.parts for row in one.lines if _owns(book, one, k := _at(book, row.span))}
    for row in block.lines:
        k = _at(book, row.span)
        if k < 0:
            if row.label:
                rows.append((row, -1))
            elif (row.colors and not many) or _is_of(book, row, "stuff") or (her_way and _is_of(book, row, "up")):
                continue  # she says it, or nobody need
            elif row.words != _hung_on(book, block):
                rows.append((replace(row, ours=True), -1))
            continue
        stretch = book.hers.worked[k]
        place = stretch.span.start if book.hers.part_at(stretch.span.start) == block.section else -1
        mine = of[k]
        if k not in rowed and stretch.plain and book.hers.part_at(stretch.span.start) in blocks:
            continue  # stands where she has it, below another part: "WALLS, part two"
        if _after_all(book, stretch):
            continue
        if stretch.plain and place < 0 and any(one.label for one in mine):
            alone = row.span is not None and _HEAD_ALONE.fullmatch(text[row.span.start : row.span.end])
            behind = row.span is not None and row.span.start >= stretch.span.end  # a sentence of hers says it
            if row.label or not (alone or noted(row) or behind):
                rows.append((row, place))
        elif place < 0:  # written under another part
            rows += (
                [(row, -1)]
                if row.label and (stretch.plain or book.hers.part_at(stretch.span.start) not in blocks)
                else []
            )
        elif k not in told:
            told.add(k)
            rows += [(one, place) for one in _in_her_words(book, stretch, mine)]
    printed = {_same(book.hers.worked[k]) for k in rowed if k >= 0}
    for k, stretch in enumerate(book.hers.worked):
        at = stretch.span.start
        if k in rowed or book.hers.part_at(at) != block.section or not _within(block, at) or _after_all(book, stretch):
            continue
        theirs = [row for one in book.said.parts for row in one.lines if row.label and _at(book, row.span) == k]
        if stretch.plain and theirs:
            for row in _in_her_words(book, stretch, theirs):
                _insert(rows, row, at)
            continue
        if (same := _same(stretch)) not in printed:  # the second leg is written as the first
            _insert(rows, Row("", cleaned(stretch.words, text), span=stretch.span, hers=True), at)
            printed.add(same)
    return iter(rows)


def _in_her_words(book: Book, stretch: Stretch, rows: list[Row]) -> list[Row]:
    """A stretch as she wrote it, with the numbers and the count of its rounds."""
    text = stretch.words
    colors = tuple(dict.fromkeys(hue for row in rows for hue in row.colors))
    labelled = [row for row in rows if row.label]
    if not labelled or (_FOLDS.match(text) and len(labelled) == 1):
        words = cleaned(text, book.piece.built.pattern.text.text)
        return [Row("", words[:1].upper() + words[1:], colors=colors, span=stretch.span, hers=True)]
    first, last = labelled[0], labelled[-1]
    stated = any(line.stated is not None for line in stretch.lines)
    drawn = not any(line.gap for line in stretch.lines)
    many = sum(row.times for row in labelled) if first.number else 0
    words, count = her_round(text, many, last.count), last.count
    if not stated and not drawn and words == her_round(text, many, 0):
        count = 0  # ours alone, and not drawn as she says
    if not last.doubt and _says_other(words, count, book.code):
        count = 0
    if not _WORD.search(words):
        return labelled
    a, b, times = first.number - first.times + 1, last.number, sum(row.times for row in labelled)
    said = f"{a}-{b}" if b > a else f"{b}"
    if times != b - a + 1:  # "23rd and alt rnds"
        said = ", ".join(row.label.split()[-1] for row in labelled)
    label = re.sub(r"\d.*", said, first.label)
    return [Row(label, words, count, b, colors, times=times, span=stretch.span, hers=True, doubt=last.doubt)]


def _says_other(words: str, count: int, code: str) -> bool:
    """Whether her words say another count than ours, which counts chains as well, or what an edge has room for."""
    said = [int(found[0] or found[1]) for found in _spoken(code).count.findall(words)]
    return bool(said) and count not in said


def _at(book: Book, span: Span | None) -> int:
    """Which stretch of her text a line came of; -1 for none."""
    assert book.hers is not None
    if span is None or span.end <= span.start:
        return -1
    k = bisect_right(book.hers.worked, span.start, key=lambda one: one.span.start) - 1
    if k < 0:
        return -1
    one = book.hers.worked[k]
    return k if span.start < one.span.end or any(line.span == span for line in one.lines) else -1


def _owns(book: Book, block: PartText, k: int) -> bool:
    assert book.hers is not None
    return k >= 0 and book.hers.part_at(book.hers.worked[k].span.start) == block.section


def _after_all(book: Book, stretch: Stretch) -> bool:
    """Whether something that is no round stands behind the parts, among her sentences of the assembly."""
    assert book.hers is not None
    return stretch.span.start >= book.hers.assembly and not any(line.in_round for line in stretch.lines)


def _same(stretch: Stretch) -> str:
    return " ".join(_WORD.findall(stretch.words.lower()))


def _within(block: PartText, at: int) -> bool:
    return block.span is None or block.span[0] <= at < block.span[1]


def _insert(placed: list[tuple[Row, int]], row: Row, at: int) -> None:
    """Puts a row behind the last that stands before it in her text."""
    k = max((n for n, (_, place) in enumerate(placed) if 0 <= place < at), default=-1)
    placed.insert(k + 1, (row, at))


# -- sentences ----------------------------------------------------------------------------------------------------------


def _said(book: Book, block: PartText, steps: bool) -> list[tuple[str, Span]]:
    """Her sentences of a part, in their order, and what its heading says besides its name."""
    assert book.hers is not None
    titles = {name.lower() for other in book.said.blocks for name in (other.name, other.title)}
    said = [
        (words, span)
        for words, span in book.hers.inside.get(block.section, [])
        if _within(block, span.start)
        and (steps or (span.start, span.end) not in book.hers.told)
        and words.rstrip(".:").lower() not in titles
        and not (block.span is not None and _WHICH.match(words))
    ]
    known = {*_WORD.findall(block.title.lower()), *_COPIES}
    for part, words, span in book.hers.headed:
        rest = [w for w in _WORD.findall(words) if w.lower() not in known or w == "A"]  # "EARS (A, make 2)" says a yarn
        if part == block.section and _within(block, span.start) and rest and words.rstrip(".:") != block.headed:
            said.append((words, span))
    return sorted(said, key=lambda one: one[1].start)


def _is_of(book: Book, row: Row, key: str) -> bool:
    """Whether a row is one of our sentences of a kind: of stuffing, of which way up it is worked."""
    words = {s.split("{")[0].strip().lower() for name, s in book.said.terms.sentences.items() if name.split()[0] == key}
    return any(w and row.words.lower().startswith(w) for w in words)


def noted(row: Row) -> bool:
    """Whether a row is what is noted with the round above it."""
    return not row.label and row.words[:1] == row.words[-1:] == "*"


def _hung_on(book: Book, block: PartText) -> str:
    """What is said of a part that hangs from the loops of a round, which a designer says herself."""
    name = book.piece.built.pattern.parts[block.section].name
    hung = next(
        (r for r in book.piece.built.pattern.finish if isinstance(r, Placed) and r.around and r.part == name), None
    )
    return "" if hung is None else f"{book.own['hung on'].format(n=f'{hung.spot.round:g}', part=hung.spot.part)}."


def _filled(book: Book, block: PartText, placed: list[tuple[Row, int]]) -> list[tuple[Row, int]]:
    """The rows with a word of ours where hands still reach inside, if she has a piece stuffed when it is closed."""
    first = {s.split()[0].lower() for name, s in book.said.terms.sentences.items() if name.startswith("stuff")}
    rows = [row for row, _ in placed]
    stuffed = next((k for k, r in enumerate(rows) if r.hers and r.words.split()[0].lower() in first), -1)
    inside = reach([(row.count, bool(row.label)) for row in rows])
    closed = 0 < next((row.count for row in reversed(rows) if row.label), 0) <= _CLOSED
    if stuffed < 0 or inside < 0 or not closed or not any(row.label for row in rows[inside + 1 : stuffed]):
        return placed
    said = book.own["stuff now"]
    ours = Row("", f"{said[:1].upper()}{said[1:]}.", ours=True)
    if any(row.label for row in rows[stuffed:]):
        return placed  # she does it while the piece is open still
    return [*placed[: inside + 1], (ours, -1), *placed[inside + 1 :]]


# -- eyes ---------------------------------------------------------------------------------------------------------------


def _eyes(
    book: Book, block: PartText, placed: list[tuple[Row, int]], said: list[tuple[str, Span]], steps: bool
) -> list[tuple[Row, int]]:
    """The rows with the eyes where fingers still reach inside, if she has them put in elsewhere or says nothing of it."""
    eyes = _eyes_here(book, block)
    if not eyes:
        return placed
    mine = [span for _, span in said if any(e.span.start < span.end and span.start < e.span.end for e in eyes)]
    if mine or not put_early(book, eyes):
        apart = book.taken.eyes(eyes) if mine else ""
        at = next((k for k, (row, _) in enumerate(placed) if row.span in mine and row.hers), -1)
        if apart and at >= 0 and not any(row.words == apart for row, _ in placed):
            placed.insert(at + 1, (Row("", apart, ours=True), mine[0].start))
        return placed
    rows = [row for row, _ in placed]
    level = max(r.spot.round for r in eyes)
    last = max((row.count for row in rows), default=0)
    open_ = next(
        found
        for share in (0.66, 0.5, 0.0)  # fingers and a washer want room, and as much of it as there is
        if (found := [k for k, row in enumerate(rows) if row.number >= level and row.count >= share * last > 0.0])
        or not share
    )
    at = (max(open_) if open_ else max((k for k, row in enumerate(rows) if row.label), default=-1)) + 1
    if steps and book.words_of(eyes[0]) and not any(row.label for row in rows[at:]):
        return placed  # nothing is closed before she has them put in
    hers = book.words_of(eyes[0]) if _alone(book, eyes) else ""
    told = eyes_now(book.own, [hers.rstrip(".") + "."] if hers else [book.called(words) for words in book.spoken(eyes)])
    more = [Row("", told, ours=book.hers is not None)]
    if hers and (apart := book.taken.eyes(eyes)):
        more.append(Row("", apart, ours=True))
    placed[at:at] = [(row, -1) for row in more]
    return placed


def _alone(book: Book, eyes: list[Eye]) -> bool:
    """Whether a sentence of hers says these eyes, and nothing else."""
    spans = {r.span for r in eyes}
    finish: tuple[Finish, ...] = book.piece.built.pattern.finish
    return len(spans) == 1 and not [r for r in finish if r.span in spans and r not in eyes]


def _eyes_here(book: Book, block: PartText) -> list[Eye]:
    built = book.piece.built
    name = built.pattern.parts[block.section].name
    last = max((row.number for row in block.lines), default=0)
    return [
        r
        for r in built.pattern.finish
        if isinstance(r, Eye) and r.spot.part in (name, f"{name}.1") and r.spot.round <= last + 1
    ]

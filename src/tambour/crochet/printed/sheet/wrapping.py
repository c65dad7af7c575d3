"""Printed patterns, wrapping: lines that the edge of a page or column broke are one again. A break is one of these where the next word had no
room left on the line; a writer's own break leaves room, or begins a round, a heading or a point of a list."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace
from typing import Final

from tambour.crochet.printed.sheet.listings import ranged
from tambour.crochet.printed.tokens import Row, Token

_NEAR: Final = 9  # lines before and after that show how wide the column is, where the whole text does not
_WIDEST: Final = 130  # characters of a line that was broken
_NARROWEST: Final = 24
_BROKEN: Final = 2  # lines near by that end in mid-sentence, for a column at all
_WHOLLY: Final = 5  # such lines in all of a text that no line is wider of, and a thirtieth of its lines
_FEW: Final = 0.03  # of the lines of such a text may be wider, in lists
_FULL: Final = 0.72  # of the column's width, from where a line may have been broken
_ROOM: Final = 0.9  # of the width: letters differ in theirs
_ENDED: Final = re.compile(r"[.!?:)\]}”\"*][ \t]*$")
_OWN: Final = 3  # lines that begin in small letters behind what a mark ended, before that is a writer's habit
_COUNTED: Final = re.compile(
    r"\d[ \t]+(?:sts?|stitches|sc|dc|rounds|rnds|rows|m|maschen|mailles|puntos|steken)(?:[ \t]*|[)\]][ \t]*)$",
    re.IGNORECASE,
)
"""A line that ends with its round's count: "… rep from * to end. 18 sts", "sc in each st (48 sts)"."""
_COUNT: Final = re.compile(r"= ?\d+(?: sc| sts?)?[ \t]*$")
_LESS: Final = 0.8  # where a small letter goes on with what no mark ended
_POINT: Final = re.compile(r"[ \t]*(?:[•▪●■○✓☐◦]|[A-Za-z][\w ]{0,20} = )")
_NUMBERED: Final = re.compile(r"[ \t]*\d{1,2}[.)][ \t]+[A-Z]")
_STEP: Final = re.compile(
    r"(?:(?:step|stage|part)[ \t]*#?(\d{1,2})[ \t]*[.:)–—-]*|[(\[][ \t]*(\d{1,2})[ \t]*[)\]][ \t]*[.:–—-]?|#(\d{1,2})[ \t]*[.:)–—-]?|(\d{1,2})\ufe0f?\u20e3|(\d{1,2})[ \t]*[.:)–—-])[ \t]*"
    r"(?=[^\W\d_]{2}|$)",
    re.IGNORECASE | re.MULTILINE,
)
"""What numbers a step: "Step 2:", "(3)", "#4", "2." on a line of its own, "2" on a key."""
_ROUND: Final = re.compile(r"[ \t]*(?:rnd|round|row|rd|r)[ \t]*(\d{1,3})[ \t]*[.:)]", re.IGNORECASE)
_COUNTING: Final = re.compile(r"[ \t]*(\d{1,3})(?:[ \t]*[-–—/][ \t]*(\d{1,3}))?[ \t]*[.:)](?![.\d])")
"""A line with a number of its own, or of several rounds: "15-18. 12 sc"."""
_LABEL: Final = re.compile(r"[A-Z][\w/&’' ]{0,30}(?:\([^()]{0,20}\)[ ]?)?:")
_TITLE: Final = re.compile(r"[A-Z][^.:,;()]{1,40}(?:\([^()]{2,40}\)[ ]?){1,2}[.:]?$")  # "Wings (make 2)"
_COPIES: Final = re.compile(r"[A-Za-z][\w /&-]{1,40}\((?:make|work) [^()]{1,20}\)")
_UNENDED: Final = frozenset(
    "in into each every next of the to from and with back front work working same first last".split()
)
"""Words that no sentence ends with, and the next line goes on from in small letters."""
_TO: Final = frozenset("from to of between and at over on along through with behind near until".split())
_ROUNDS: Final = re.compile(
    r"[ \t]*(?:rnd|round|row|rd|r)s?[ \t]*\d+\b(?![ \t]*[:)|])(?![ \t]*[.–-][ \t]*(?:\d+ |[a-z(*\[]))", re.IGNORECASE
)
"""A round that a sentence names, in the midst of which a line was broken: "… running from | Rnd 13 to Rnd 16."."""
_SHORT: Final = 6  # words of a heading
_ALONE: Final = re.compile(
    r"[ \t]*(?:rnd|round|row|rd|r)s?[ \t]*\d+(?:[ \t]*[-–][ \t]*\d+)?[ \t]*[:.)]+[ \t]*\w+[ \t]*", re.IGNORECASE
)
_BEGUN: Final = re.compile(r"[ \t•*-]*(?:(?:in|for)[ \t]+)?(?:rnd|round|row|rd|r)s?[ \t]*\d", re.IGNORECASE)
_HEAD: Final = re.compile(
    r"[ \t]*(?:(?:in|for)[ \t]+)?(?:rnd|round|row|rd)s?[ \t]*\d+(?:[ \t]*[-–][ \t]*\d+)?[ \t]*(?:\([^()\n]{1,60}\))?[ \t]*:[ \t]*",
    re.IGNORECASE,
)
"""The head of a round on a line of its own: "For Rows 6-9:", "Row 10 (closing row for the head):"."""
_LEADS: Final = frozenset(("in", "for"))
_POINTS: Final = frozenset(("-", "•", "*", "–", "·"))
_LABELS: Final = frozenset(("rnd", "round", "row", "rnds", "rounds", "rows"))
_STITCHES: Final = frozenset("sc hdc dc tr ch inc dec st sts stitch stitches slst sl".split())
_BEHIND: Final = frozenset(("in", "into", "next", "each", "around", "from", "together"))


def unwrapped(text: str, rows: list[Row], begins: Callable[[list[Token], bool], bool]) -> list[Row]:
    """``rows`` with those together that a page's edge parted.

    begins : whether words begin a round, or a sentence of their own although no mark ends the line above them (the flag)
    """
    lengths = [row.end - row.start if row.tokens else 0 for row in rows]
    cut = [
        0 < n <= _WIDEST and not _ENDED.search(text, max(row.start, row.end - 4), row.end)
        for n, row in zip(lengths, rows, strict=True)
    ]
    whole = _column(lengths, cut)
    own = small(text, rows)
    made: list[Row] = []
    reached = 0  # the number of the last line that bears the next one
    for at, row in enumerate(rows):
        above = rows[at - 1] if at else row
        counted = _COUNTING.match(text, row.start, row.end) if row.tokens else None
        if counted is not None and int(counted[1]) in (1, reached + 1):
            follows = int(counted[1]) == reached + 1 or _anew(text, rows, at, int(counted[2] or counted[1]))
            reached = int(counted[2] or counted[1])
            if follows and (not above.tokens or above.tokens[-1].word not in ("ch", "chain")):
                made.append(row)
                continue
        ruled = all(t.kind == "mark" for t in above.tokens)  # a line of dashes is as wide as the page
        if not (made and row.tokens and above.tokens) or ruled or row.marked or above.marked:
            made.append(row)
            continue
        open_ended = cut[at - 1] and above.tokens[-1].word in _UNENDED and text[row.start : row.start + 1].islower()
        named = cut[at - 1] and above.tokens[-1].word in _TO and _ROUNDS.match(text, row.start, row.end) is not None
        going = above.tokens[-1].word in (";", ",") and _round_goes_on(text, made[-1], row)
        if named or going or (open_ended and not _begins(text, above, row, False, begins)):
            more = row.tokens
            if going and more[0].word == "a" and more[0].capital:
                more = [replace(more[0], value="A"), *more[1:]]  # a yarn's letter, no article
            made[-1] = Row([*made[-1].tokens, *more], made[-1].start, row.end, made[-1].marked)
            continue
        near = slice(max(0, at - _NEAR), at + _NEAR)
        width = whole or max(lengths[near])
        if not _NARROWEST <= width <= _WIDEST or lengths[at - 1] < _FULL * width:
            made.append(row)
            continue
        sure = cut[at - 1] and text[row.start : row.start + 1].islower()
        if sure and own and not whole:
            made.append(row)
            continue
        broken = (
            sure
            or whole
            or sum(c and n >= _FULL * width for c, n in zip(cut[near], lengths[near], strict=True)) >= _BROKEN
        )
        first = text[row.start : row.end].split(None, 1)[0]
        room = (_ROOM if not sure else _LESS) * width
        if _follows(text, made[-1], row):
            made.append(row)
            continue
        if not broken or lengths[at - 1] + 1 + len(first) <= room or _begins(text, above, row, not cut[at - 1], begins):
            made.append(row)
            continue
        last, more = made[-1], row.tokens
        if more[0].word == "a" and more[0].capital and cut[at - 1]:
            more = [replace(more[0], value="A"), *more[1:]]  # a yarn's letter, no article
        made[-1] = Row([*last.tokens, *more], last.start, row.end, last.marked)
    return made


def _round_goes_on(text: str, above: Row, row: Row) -> bool:
    """Whether a round whose line ends in mid-sentence goes on in a line that stands further in: "Rnd 19: A: 6 sc, dec; | B: 9 sc; | A: 12 sc (42)"."""
    further = row.tokens[0].start - row.start > above.tokens[0].start - above.start
    begun, again = (_BEGUN.match(text, r.start, r.end) is not None for r in (above, row))
    return begun and further and not again


def _anew(text: str, rows: list[Row], at: int, last: int) -> bool:
    """Whether the line below one that is numbered ``last`` is the next of its list."""
    below = next((row for row in rows[at + 1 : at + 3] if row.tokens), None)
    found = _COUNTING.match(text, below.start, below.end) if below is not None else None
    return found is not None and int(found[1]) == last + 1


def torn(text: str, rows: list[Row]) -> list[Row]:
    """``rows`` with the heads of rounds that stand alone, or with one word behind them, together with what they head, as pages have it that were
    copied from a narrow column: "Rnd 3: 1 | hdc in next st, 2 hdc in next st, repeat to | end (18)"."""
    made: list[Row] = []
    points = False  # the lines above are points of a round whose head stands alone
    for at, row in enumerate(rows):
        above = rows[at - 1] if at else row
        point = bool(row.tokens) and text[row.start : row.end].lstrip()[:1] in _POINTS
        if made and point and points and not _BEGUN.match(text, row.start, row.end):
            end = made[-1].tokens[-1]
            stop = [] if end.word in (".", ",", ":", ";") else [Token("mark", ".", end.end, end.end, None, True)]
            made[-1] = Row([*made[-1].tokens, *stop, *row.tokens], made[-1].start, row.end)
        elif made and row.tokens and above.tokens and not above.marked and _breaks(text, above, row):
            begun, more = made[-1].tokens, row.tokens
            points = point and _HEAD.fullmatch(text[above.start : above.end]) is not None
            if _HEAD.fullmatch(text[above.start : above.end]):
                begun = begun[1:] if begun[0].word in _LEADS else begun
            made[-1] = Row([*begun, *more], begun[0].start, row.end)
        else:
            points = False
            made.append(row)
    return made


_POINTED: Final = re.compile(r"\n\s*\((?i:see) [^()\n]{2,40}\)(?=,)|\((?i:see)\s*\n\s*[^()\n]{2,40}\)")
"""What points to another page, and has a line to itself or is broken in two: "form a ring | (see illustration), 6 sc"."""


_PARTED: Final = re.compile(
    r"\(\d+ (?:sts?|stitches|sc|hdc|dc)\.?\s*\n\s*(?:made|total|in all|left|around)\.?\)", re.IGNORECASE
)
"""A count that is broken in two: "(72 sts | made.)"."""


def pointed(text: str, rows: list[Row]) -> list[Row]:
    """``rows`` without what points to another page in the midst of a sentence, whose lines are one again."""
    for found in (*_POINTED.finditer(text), *_PARTED.finditer(text)):
        first = next((k for k, row in enumerate(rows) if row.start <= found.start() <= row.end), None)
        last = next((k for k, row in enumerate(rows) if row.start < found.end() <= row.end), None)
        if first is None or last is None or not rows[first].tokens:
            continue
        tokens = [t for row in rows[first : last + 1] for t in row.tokens]
        kept = [t for t in tokens if t.end <= found.start() or t.start >= found.end() or found.re is _PARTED]
        rows = [*rows[:first], Row(kept, rows[first].start, rows[last].end), *rows[last + 1 :]]
    return rows


def _breaks(text: str, above: Row, row: Row) -> bool:
    """Whether a line is the head of a round, and at most a word that ``row`` goes on from."""
    last, first = above.tokens[-1], row.tokens[0]
    if len(above.tokens) == 1:
        # Without a sign "Row" heads a column: "1 ch 11, …" stands below it.
        colon = len(row.tokens) > 1 and row.tokens[1].word in (":", "-", "–")
        return last.word in _LABELS and first.kind == "number" and colon  # "Rnd | 27-29: hdc in each st"
    if _HEAD.fullmatch(text[above.start : above.end]) and not _BEGUN.match(text, row.start, row.end):
        return text[row.start : row.end].lstrip()[:1] in _POINTS  # "In Row 3: | - Sc in the first stitch, …"
    if row.marked:
        return False
    if not _ALONE.fullmatch(text[above.start : above.end]):
        return False
    if last.kind == "number":
        return first.word in _STITCHES and not first.capital
    # A capital may be a telephone's, but not of "Next rnd: dec".
    small = not first.capital or (first.word == "in" and len(row.tokens) > 1 and row.tokens[1].word in _BEHIND)
    return last.word in _STITCHES and first.word in _BEHIND and small


_ROMAN: Final = re.compile(
    r"(?:[(\[](?:x{0,2}(?:ix|iv|v?i{1,3}|v)|x{1,2}|[a-h])[)\]]|(?:x{0,2}(?:ix|iv|v?i{1,3}|v)|x{1,2}|[a-h])[.)])[ \t]+(?=[A-Z])"
)
"""The same in Roman numbers or letters: "(iv) Mouth: …", "b) Ears: …"."""


def step(text: str, row: Row) -> int:
    """Where the number of a step ends that a line begins with: "Step 2:", "(3)", "(iv)", "b)"; 0 where none does."""
    line = text[row.start : row.end]
    found = _numbered(text, row) or _ROMAN.match(text, row.start + len(line) - len(line.lstrip()))
    return found.end() if found is not None else 0


def _numbered(text: str, row: Row) -> re.Match[str] | None:
    line = text[row.start : row.end]
    return _STEP.match(text, row.start + len(line) - len(line.lstrip()))


def _follows(text: str, above: Row, row: Row) -> bool:
    """Whether the number of a line's step, or of its round, is the next after that of the line above."""
    one, two = (_ROUND.match(text, r.start) for r in (above, row))
    if one is not None and two is not None and int(one[1]) + 1 == int(two[1]):
        return True  # "round 1. 6 sc in magic ring", in small letters
    one, two = (_numbered(text, r) for r in (above, row))
    return one is not None and two is not None and int(one[one.lastindex or 0]) + 1 == int(two[two.lastindex or 0])


def small(text: str, rows: list[Row]) -> bool:
    """Whether a writer begins lines of his own in small letters, as in a chat: "stuff", "switch to black"."""
    own = on = 0
    above = Row([], 0, 0)
    for row in rows:
        if row.tokens and text[row.start : row.start + 1].islower():
            ended = not above.tokens or _ENDED.search(text, max(above.start, above.end - 4), above.end)
            own, on = own + bool(ended), on + (not ended)
        above = row
    return own >= _OWN and own > on


def _column(lengths: list[int], cut: list[bool]) -> int:
    """How wide the column is that all of a text is broken at, 0 where it is not."""
    known = sorted(n for n in lengths if n)
    widest = known[min(len(known) - 1, int(len(known) * (1 - _FEW)))] if known else 0
    full = sum(c and n >= _FULL * widest for c, n in zip(cut, lengths, strict=True))
    return widest if _NARROWEST <= widest <= _WIDEST and full >= max(_WHOLLY, len(known) // 30) else 0


def _dashed(line: str) -> bool:
    return line.lstrip()[:2] in ("- ", "– ")


def _begins(text: str, above: Row, row: Row, ended: bool, begins: Callable[[list[Token], bool], bool]) -> bool:
    """Whether a line begins a round, a point of a list, a sentence that the line above it cannot go on with, or a heading; or whether that
    line is a heading itself."""
    said = text[row.start : row.end].strip()
    if "|" in (said[:1], text[above.start : above.end].lstrip()[:1]):  # a row of a table is whole
        return True
    if said.count("|") > 1 and text[above.start : above.end].count("|") > 1:
        return True
    if (
        _POINT.match(said)
        or _ROMAN.match(said)
        or begins(row.tokens, not ended)
        or _TITLE.match(text[above.start : above.end].strip())
    ):
        return True
    if said[:1].isupper() and _COUNTED.search(text, above.start, above.end):
        return True
    line = text[above.start : above.end]
    pointed = _dashed(said) and (_dashed(line) or _COUNT.search(line) is not None)
    if pointed or (ranged(row.tokens, 0) and row.tokens[4].kind == "number"):
        return True  # a point of a list below another, "8-12. 42 sc"
    words = said.split()
    named = _TITLE.match(said) is not None or _COPIES.match(said) is not None
    titled = said[:1].isupper() and len(words) <= _SHORT and not said.endswith(".")
    labelled = _LABEL.match(said) is not None
    return ended and (
        labelled
        or named
        or _NUMBERED.match(said) is not None
        or (titled and (said.isupper() or not _ENDED.search(said) or said.endswith((":", ")"))))
    )

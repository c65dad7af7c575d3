"""Ordered: a designer's text as stretches that are worked and sentences between them, so that each of her words is printed once.

A stretch is what lines of the tree came of, grown to whole sentences. It is *plain* where it holds nothing but words of stitches and
counts: then our words say all of it. Every other stretch is printed as she wrote it.
"""

from __future__ import annotations

import re
from bisect import bisect_left, bisect_right
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import lru_cache
from typing import Final

from tambour.core.errors import Span
from tambour.crochet.language.stitches import STITCHES
from tambour.crochet.language.tree import Action, Group, Item, Line, Pattern
from tambour.crochet.page.doubted import doubted
from tambour.crochet.words.table import TERMS, Terms

_SPELT: Final = frozenset(
    """a across again all along an and around as at beg beginning between bl blo both by ch chain chains chs corresponding crochet dc dec
    decrease each end every fl flo following foll from front back hdc hook half double in inc increase into join last loop loops lp lps more
    magic mr make next now of once one only opposite other over rem remain remaining rep repeat repeating rest ring rnd rnds round rounds
    row rows s same sc second side single sk skip sl slip sp space spaces st start starting stitch stitches sts the them then there these
    they this three till time times to tog together total tr treble triple turn turning twice two until up v will with work worked x yo
    you r rd rds d are is that foundation four five six seven eight nine ten eleven twelve first third fourth fifth sixth reach have""".split()
)
"""English words of which rounds are made, besides those of the table."""
_NAMED: Final = ("round", "row", "front loops", "back loops", "ring", *STITCHES)
_WORD: Final = re.compile(r"[^\W_]+")
_NUMBER: Final = re.compile(r"\d+(?:st|nd|rd|th|x|ch|sc|dc|hdc|tr|tog)*|x\d+|r\d+|\d+r\d+")
_TOGETHER: Final = re.compile(r"[a-z]*\d(?:tog)?|(?:sc|dc|hdc|tr)\d*tog")
_JOINT: Final = r"\s*(?:-|–|—|,|/|to|and|&|bis|und|y|à|et|t/m|tot|en|through|thru)\s*"
_RING: Final = re.compile(
    r"\b(?:ring|circle|loop|mr|mc|ml|ma|kreis|fadenring|cercle|anneau|anillo|cerchio|anello)\b", re.IGNORECASE
)
_ODD: Final = frozenset(("goto", "attach", "sew", "edge", "tospace", "gap", "oval", "fsc", "fold"))
"""What a round does that our words tell worse than hers."""
_FROM_HOOK: Final = re.compile(r"\b(?:ch|chain|st|stitch)\w*\.? from (?:the |your )?hook\b", re.IGNORECASE)
"""In which chain a row begins, of which our words say nothing."""
_SPANS: Final = re.compile(r"\*{2,}\s+to\s+\*{2,}|\b(?:from|between|after) \*{2,}\s|\* (?:or|and|to) \*\*")
"""Asterisks that mark what is worked again, and set nothing bold: "work from ** to **"."""
_AT_END: Final = re.compile(
    r"\s*\d+ [a-z ]{1,20} (?:at|after) (?:the )?end of [\w ]*(?:rnd|round|row)s?\.?\s*", re.IGNORECASE
)
"""A count of several rounds: "24 sc at end of 3rd rnd"."""
_BOTH_COUNTED: Final = re.compile(r"\d+ \w+,? (?:and|&|,) \d+ ch\b", re.IGNORECASE)
_LEGEND: Final = re.compile(r"(?:^|[,;|])[ \t]*([A-Z]{1,2})[ \t]*=", re.MULTILINE)
_COUNTED: Final = re.compile(r"\d*([A-Z]{1,2})")
_END: Final = re.compile(r"[.!?](?=\s|$)|(?=\n)|$")
_BEGIN: Final = re.compile(r"(?:[.!?:;)]\s+|\n\s*|^)(?=\S)")
_MAKES: Final = re.compile(
    r"\d|\b(?:sc|dc|hdc|tr|ch|st|sts|stitch|stitches|inc|dec|sl|join|turn|chain|crochet)\b", re.IGNORECASE
)


@lru_cache(maxsize=8)
def _signs(text: str) -> frozenset[str]:
    """The capital letters that a text's own legend says the meaning of: "X = single crochet"."""
    return frozenset(_LEGEND.findall(text))


@lru_cache(maxsize=8)
def spans_marked(text: str) -> bool:
    """Whether a text marks with two asterisks what is worked again."""
    return _SPANS.search(text) is not None


@dataclass(frozen=True, slots=True)
class Stretch:
    """Words of hers that lines of the tree came of.

    words : as they stand in her text; span : where; lines : the lines; plain : our words say all of it
    """

    words: str
    span: Span
    lines: tuple[Line, ...]
    plain: bool


def stretches(pattern: Pattern, first: int, end: int) -> list[Stretch]:
    """The stretches of a text between its first part and its end, in their order."""
    text = pattern.text.text
    rounds = [line.span for part in pattern.parts for line in part.lines if line.in_round]
    heads = [
        at
        for part in pattern.parts
        for at in (part.span, *part.also)
        if not any(r.start < at.end and at.start < r.end for r in rounds)
    ]
    lines = sorted(
        {
            id(line): line
            for part in pattern.parts
            for line in part.lines
            if line.span.end > line.span.start
            and first <= line.span.start < end
            and not any(h.start <= line.span.start and line.span.end <= h.end for h in heads)
            and not _in_heading(text, line, heads)
        }.values(),
        key=lambda line: (line.span.start, -line.span.end),
    )
    groups: list[tuple[int, int, list[Line]]] = []
    for line in lines:
        if groups and line.span.start < groups[-1][1]:
            a, b, some = groups[-1]
            groups[-1] = (a, max(b, line.span.end), [*some, line])
        else:
            groups.append((line.span.start, line.span.end, [line]))
    starts = sorted([*(a for a, _, _ in groups), *(h.start for h in heads)])
    ends = sorted([*(b for _, b, _ in groups), *(h.end for h in heads)])
    told = doubted(pattern)
    found: list[tuple[int, int, list[Line]]] = []
    for a, b, some in groups:
        before, behind = bisect_right(ends, a), bisect_left(starts, b)
        low = ends[before - 1] if before else first
        high = starts[behind] if behind < len(starts) else end
        begin, stop = _grown(text, a, b, low, high)
        stop = min(stop, _counted(text, a, stop, some))
        if found and found[-1][1] > begin:
            found[-1] = (found[-1][0], begin, found[-1][2])
        if found and _goes_on(text, found[-1][1], begin) and not any(line.in_round for line in some):
            found[-1] = (found[-1][0], stop, [*found[-1][2], *some])
        else:
            found.append((begin, stop, some))
    spans = [(Span(a, _signed(text, a + len(text[a:b].rstrip()))), some) for a, b, some in found]
    return [
        Stretch(text[span.start : span.end], span, tuple(some), _plain(pattern, span, some, told))
        for span, some in spans
    ]


def _signed(text: str, end: int) -> int:
    """Where a stretch ends with the asterisks that close what is worked again: "12 sc. **"."""
    found = re.compile(r"[ \t]?\*{2,}").match(text, end) if spans_marked(text) else None
    return found.end() if found is not None else end


def _in_heading(text: str, line: Line, heads: list[Span]) -> bool:
    """Whether a line is only the yarn that stands in brackets behind a part's name: "HEAD (A, 3 mm hook)"."""
    return not any(name != "color" for name in names_in(line.items)) and any(
        h.end <= line.span.start and re.fullmatch(r"[^\n)]*\([^\n)]*", text[h.end : line.span.start]) for h in heads
    )


def _goes_on(text: str, end: int, begin: int) -> bool:
    """Whether a stretch stands in the sentence of the one before it."""
    return text[end - 1 : end] not in ".!?:)]" and not text[end:begin].strip(" \t,;")


def sentences_between(text: str, a: int, b: int, worked: Iterable[Stretch]) -> Iterator[tuple[int, int]]:
    """What of a stretch of text no line came of: (from, to), a piece each."""
    at = a
    for one in worked:
        if one.span.end <= a or one.span.start >= b:
            continue
        if one.span.start > at:
            yield at, one.span.start
        at = max(at, one.span.end)
    if at < b:
        yield at, b


def _grown(text: str, a: int, b: int, low: int, high: int) -> tuple[int, int]:
    """A stretch to both ends of its sentence, no further than what stands beside it is."""
    line = max(low, text.rfind("\n", 0, a) + 1)
    begin = line
    for found in _BEGIN.finditer(text, line, a + 1):
        begin = max(begin, found.end()) if found.end() <= a else begin
    marked = text.find("**", begin, a) if spans_marked(text) else -1
    begin = begin if _WORD.search(text, begin, a) else a if marked < 0 else marked  # "**With A, ch 2": from here
    last = text[b - 1 : b]
    if last in ".!?" or text[b : b + 1] in ("\n", ""):
        return begin, b
    after = _END.search(text, b, high)
    stop = after.end() if after is not None else high
    rest = text[b:stop]
    if last in ")]" and re.match(r"\s+[A-Z]", rest):
        return begin, b  # a count, and another sentence
    return begin, min(stop, high)


def _counted(text: str, a: int, b: int, lines: list[Line]) -> int:
    """Where the round of a stretch ends and what hands do besides begins: behind its count, or its last sentence with stitches."""
    line = next((one for one in reversed(lines) if one.in_round), None)
    if line is None:
        return b
    stated = line.stated_span
    if stated is not None and a <= stated.start < b:
        end = _END.search(text, stated.end, b)
        stop = min(b, end.end() if end is not None and end.end() < b else b)
        if "\n" in text[stated.end : stop]:
            return b
        inner = re.match(r"[^.!?\n]{0,16}[)\]](?=\s)", text[stated.end : b])
        return stated.end + inner.end() if inner is not None and stated.end + inner.end() < stop else stop
    cuts = [m.end() for m in re.finditer(r"[.!?]\s+(?=[A-Z])", text[a:b])]
    stop = b
    for k in range(len(cuts) - 1, -1, -1):
        if _MAKES.search(text[a + cuts[k] : stop]):
            break
        stop = a + cuts[k]
    return a + len(text[a:stop].rstrip())


def _plain(pattern: Pattern, span: Span, lines: list[Line], told: frozenset[Span]) -> bool:
    """Whether nothing but stitches and counts is said in a stretch, and the pictures have them as she says."""
    text = pattern.text.text
    noted = [text[n.start : n.end] for line in lines for n in line.notes]
    if any(line.span in told for line in lines) or not any(line.in_round for line in lines):
        return False
    if not all(_AT_END.fullmatch(note) for note in noted):
        return False
    words = text[span.start : span.end]
    if _BOTH_COUNTED.search(words):
        return False  # "88 sc and 88 ch-4 spaces": no one number says it
    if "**" in words and spans_marked(text):
        return False  # "12 sc.**": as far as here
    done = [name for line in lines for name in names_in(line.items)]
    if (
        any(name in _ODD for name in done)
        or _FROM_HOOK.search(words)
        or (_begins_ring(done) and not _RING.search(words))
    ):
        return False
    terms = TERMS.get(pattern.terms)
    if terms is None:
        return False
    if not _english(terms):
        inner = (*pattern.passed, *(n for line in lines for n in line.notes))
        return not any(s.start < span.end and span.start < s.end for s in inner)
    spelt = _SPELT | {
        w for key in _NAMED if key in terms.words for s in terms.words[key] for w in _WORD.findall(s.lower())
    }
    return all(
        (w.lower() in spelt and (w.islower() or len(w) > 2 or w not in pattern.letters) and (len(w) > 1 or w in "axX"))
        or _NUMBER.fullmatch(w.lower())
        or _TOGETHER.fullmatch(w.lower())
        or w.lower() in pattern.stitches
        or ((sign := _COUNTED.fullmatch(w)) is not None and sign[1] in _signs(text) and sign[1] not in pattern.letters)
        for w in _WORD.findall(words)
    )


def _english(terms: Terms) -> bool:
    return terms.code in ("us", "uk", "letters")


def paragraph(words: str, text: str) -> str:
    """The paragraph that a sentence stands in: what a sign means elsewhere it does not mean here, where a list's points have it."""
    at = text.find(words.strip())
    end = text.find("\n\n", max(at, 0))
    return "" if at < 0 else text[text.rfind("\n\n", 0, at) + 1 : end if end >= 0 else len(text)]


def names_in(items: Iterable[Item]) -> Iterator[str]:
    """The names of all that is done in some items."""
    for item in items:
        if isinstance(item, Group):
            yield from names_in(item.items)
        elif isinstance(item, Action):
            yield item.name


def _begins_ring(done: list[str]) -> bool:
    return any(name == "mr" or name.startswith("MR") for name in done)


_RISES: Final = re.compile(
    r"\b(?:ch(?:ain)?s?\s*\d+|\d+\s*(?:chs?|lm|ml|cad|l)|turn|wenden|tourner|girar|keren)\b", re.IGNORECASE
)
_COUNTS: Final = re.compile(
    r"\d+\s*(?:(?:sts?|stitches|total|maschen|m|mailles|puntos|steken)\b\.?)?\s*", re.IGNORECASE
)


def _works(before: str, last: str) -> bool:
    """Whether so many stitches at the end of a round are what is worked in it, and no count: "Ch 1, turn, 9 sc", and not "… around. 9 sc"."""
    if _COUNTS.fullmatch(last.strip()):
        return False
    rest = _RISES.sub("", before)
    return before.rstrip().endswith(",") or not re.search(r"[^\W\d_]{2,}", rest)


def her_round(words: str, number: int, count: int) -> str:
    """Her words of a round, or of several (``number``, 0 of none), without their numbers and their count, which stand beside them.

    >>> her_round("Round 1 - 6 sc in ring - 6", 1, 6), her_round("Rounds 4 - 6 - sc around - 18", 3, 18)
    ('6 sc in ring', 'sc around')
    """
    if number:
        named = r"(?:rounds?|rnds?|rows?|lines?|rds?|r|rang|rangs|runden?|rd|reihen?|vueltas?|toer(?:en)?)\.?\s*"
        alt = r"(?:\s*(?:and|&)\s+(?:every\s+)?alt\w*(?:\s+foll\w*)?)?\s*"
        many = r"\d+(?:st|nd|rd|th|e|ª)?"
        # Of one round a number behind a dash is of its stitches.
        many += rf"(?:{_JOINT}(?:{named})?\d+(?:st|nd|rd|th|e|ª)?(?![\w]))*" if number > 1 else ""
        head = rf"^\s*(?:[•–-]\s*|\*\s+)?(?P<sign>\**)(?:{named}{many}\s*[.:=)\]–—-]*|{many}{alt}{named}[.:=)–—-]*|{many}\s*[.:)]+)\s*"
        words = re.sub(head, lambda m: m["sign"] if len(m["sign"]) > 1 else "", words, count=1, flags=re.IGNORECASE)
        words = re.sub(
            r"^\s*next\s+(?:(?:\d+|two|three|four)\s+)?(?:rounds?|rnds?|rows?)\s*:\s*",
            "",
            words,
            count=1,
            flags=re.IGNORECASE,
        )
    if count:
        word = r"\s*(?:(?!cm|mm|in|yd|g\b|m\b)[a-z]+\.?\s*)?"
        end = rf"(?:(?:[\s.,;:]*[–—-]+\s*|\s*[(\[{{=]+\s*){count}{word}|(?P<alone>(?<=[.;,])\s+{count}{word}))[)\]}}]?\W*$"
        sign = re.search(r"\*{2,}\s*$", words)
        found = re.search(end, words, flags=re.IGNORECASE)
        if found is not None and not (found["alone"] and _works(words[: found.start()], found["alone"])):
            words = words[: found.start()] + (sign[0] if sign is not None else "")
    return re.sub(r"\\([*_\[\]()-])", r"\1", " ".join(words.split()))

"""Sure: whether what the pictures took may stand beside a designer's sentence: it is true in her numbers and her words, or it is not said."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Final

import numpy as np

from tambour.core.check import Array
from tambour.crochet.language.tree import Pattern
from tambour.crochet.words.gloss import english

_HEADS: Final = re.compile(
    r"\W*(?:(?:rounds?|rnds?|rows?|rd|r)\s*[.:#]*\s*(?P<a>\d+)\b|(?P<b>\d+)(?:st|nd|rd|th)\s+(?:\S+\s+){0,4}?(?:rounds?|rnds?|rows?)\b)",
    re.IGNORECASE,
)
"""How a round is headed: "Rnd 3", "3rd rnd", "3rd to 8th rnds"."""
_NAUGHT: Final = re.compile(r"(?<!\d)(?<!\d[.,])0(?![\d½]|[.,]\d)")
_TOGETHER: Final = re.compile(
    r"\btog(?:ether)?\b|\bseparately\b|\bedge to edge\b|\b(?:to|against) the (?:flat|open|closed) (?:edge|end)\b"
)
_SIDES: Final = {
    "front": re.compile(r"\bfront\b(?! (?:loop|post|and back loop))"),
    "back": re.compile(r"\bback\b(?! (?:loop|post|and forth|stitch|in\b))"),
    "side": re.compile(r"(?<!each )(?<!right )(?<!wrong )\bsides?\b(?! (?:up|out|in|facing|together)\b)"),
    "top": re.compile(r"\btop\b"),
    "under": re.compile(r"\b(?:bottom|base|under(?:side|neath)?|belly|tummy)\b"),
}
_STANDING: Final = {"front": (0.0, 0.3), "side": (0.06, 0.44), "back": (0.2, 0.5)}
_LYING: Final = {"top": (0.0, 0.3), "side": (0.06, 0.44), "under": (0.2, 0.5)}
"""From what to what share of its round a part is from the middle of the front, or of the top, that is where a word says."""
_ROUND: Final = 0.55
"""A seam over such a share of a round lies about the part's axis, and is at no side of it."""
_POINTS: Final = {"top": "upwards", "under": "downwards", "front": "forwards", "back": "backwards", "side": "outwards"}
"""Where a part points that is at a side, unless it leans otherwise, which is not said."""
INCHES: Final = ('"', "”", "in", "inch", "inches")
_APART: Final = re.compile(
    r"(\d+(?:\.\d+)?)\s*(cm|inch(?:es)?|in|[\"”])[^.;\d]{0,12}(?:[\[(][^\])]*[\])]\s*)?\bapart\b"
)
_COUNTED: Final = re.compile(
    r"(?<![\w/])(\d+)\s*(?:visible |free |empty )?(?:sts?|stitch(?:es)?|loops?)\b(?!\s*(?:wide|high|long|around|in (?:this|the) round))(?=([^.;]{0,30}))"
)
_EACH: Final = re.compile(r"\b(?:each|either) (?:side|way)\b|\bfrom (?:the )?(?:middle|cent(?:er|re))\b")
"""What is counted from the middle to each of two."""
_BESIDE: Final = re.compile(
    r"\b(?:just|right|directly|\w+ (?:sts?|stitch(?:es)?|loops?|rounds?|rnds?|rows?)) (?:above|below|beside|behind|under|over|from|off)\b(?! (?:the )?(?:middle|center|centre|front|back|top))"
    r"|\b(?:above|below|beside|along|next to|touching) the (?:[a-z]+ ){0,2}(?:edge|frame|border|belly|patch|bib|seam|stripe)\b"
)
_AT_BACK: Final = re.compile(
    r"\bstitch\b[^.;]{0,40}\bmiddle of\b[^.;]{0,20}\bback\b|\brounds? begins?\b[^.;]{0,40}\bback\b", re.IGNORECASE
)
_STROKES: Final = re.compile(
    r"\b(?:\d+|one|two|three|four|five|a) (?:[a-z]+ ){0,3}?(?:short|long|straight|small|little|tiny)(?: [a-z]+){0,2} (?:stitch(?:es)?|sts?|lines?|strokes?)\b"
)
_MISSED: Final = 0.5
_END: Final = re.compile(r"[.;!?](?=\s)|\n|$")
_TWO: Final = re.compile(r"\b(?:2|two|both|either side|each side)\b")
_EYES: Final = re.compile(
    r"\b(?:put|insert|attach|sew|place|add|secure|fix|glue|position|pop|snap|install|push|use|embroider|make)\w*\b[^.;]{0,45}\beyes?\b"
    r"|\beyes?\b[^.;]{0,25}\b(?:are|go|goes|between|at|in|on|into|to)\b|\bfor (?:the )?eyes\b"
)


def paragraph(text: str, start: int, end: int, more: int = 0) -> str:
    """A sentence to its end, with so many ``more`` behind it in its line, in small letters: there people say more of where it goes."""
    stop = text.find("\n", max(start, end - 1))
    line = text[start : stop if stop >= 0 else len(text)].lower()
    ends = [m.end() for m in re.finditer(r"[.!?](?=\s|$)", line) if m.end() >= end - start]
    return line[: ends[more]] if len(ends) > more else line


def begins_at_back(text: str) -> bool:
    """Whether she has rounds begin on a back: what is underneath is not where they begin."""
    return _AT_BACK.search(text) is not None


def of_stitches(words: str) -> bool:
    """Whether she counts the stitches that something is embroidered of: "3 short pink stitches"."""
    return _STROKES.search(words) is not None


def counted(words: str) -> list[int]:
    """The stitches that she counts between two things: "10 stitches apart", "9 loops free between", "13 stitches down on each side"."""
    return [int(n) * (2 if _EACH.search(behind) else 1) for n, behind in _COUNTED.findall(words)]


def miscounts(words: str, gaps: Sequence[float], count: int) -> float:
    """By how many stitches two things so far apart, in one or the other way of counting, on a round of ``count`` are elsewhere than her words
    count; 0 where they count nothing, or as we do: the way round either side, or from the middle to each."""
    return min((abs(n - have) for n in counted(words) for gap in gaps for have in (gap, count - gap)), default=0.0)


def beside(words: str) -> bool:
    """Whether she says a place by what is near it: "just above the cream edge", "4 loops from the frame", "two stitches above the belly"."""
    return _BESIDE.search(words) is not None


def whole(words: str) -> bool:
    """Whether what we say counts from the first round on: a chain that a part begins with is round 0 for nobody else."""
    return _NAUGHT.search(words) is None


def hers_too(pattern: Pattern, section: int, low: float, high: float) -> bool:
    """Whether a part's rounds from ``low`` to ``high`` have the same numbers in her text: a body may begin at 1 again below its head."""
    off = 0
    text = pattern.text.text
    for line in pattern.parts[section].lines:
        found = _HEADS.match(text, line.span.start)
        if line.number is None:
            continue
        if found is not None:
            off = line.number - int(found["a"] or found["b"])
        if off and line.number <= high + 0.5 and line.number + line.times - 1 >= low - 0.5:
            return False
    return True


def sides(sentence: str, pattern: Pattern) -> frozenset[str]:
    """The sides of what a part is sewn to that a sentence names; those in names of parts ("Front Legs") are none."""
    low = english(sentence, pattern.terms).text.lower()
    for name in sorted((part.name for part in pattern.parts if part.name), key=len, reverse=True):
        low = re.sub(rf"\b{re.escape(name.lower().rstrip('s'))}(?:s|es)?\b", " ", low)
    return frozenset(side for side, said in _SIDES.items() if said.search(low))


def contradicts(named: frozenset[str], share: float, lies: bool) -> bool:
    """Whether a place so far round from the middle of the front, or of the top where it ``lies``, is not at the one side that she names."""
    known = _LYING if lies else _STANDING
    hers = [side for side in known if side in named]
    return len(hers) == 1 and not known[hers[0]][0] <= share <= known[hers[0]][1]


def pointing(named: frozenset[str], ways: Sequence[str]) -> bool:
    """Whether it may be said where a part points: as the sides that she names, if she names any, would have it."""
    asked = [_POINTS[side] for side in named]
    return not asked or any(way in asked for way in ways)


def about_axis(offs: Array, count: int) -> bool:
    """Whether a seam goes round the part that it is on: so many stitches from the middle, on rounds of ``count``."""
    if count <= 0 or len(offs) < 3:
        return False
    at = np.sort(offs % count)
    bare = np.diff(np.append(at, at[0] + count)).max()  # what it leaves free of the round, also behind
    return bool(count - bare >= _ROUND * count)


def gap_on(level: float, seams: Sequence[Array]) -> int:
    """How many stitches of the round of their middles are between two ends; 0 where they are on no one round."""
    near = [abs(s[abs(s[:, 0] - level) < 0.6, 1]).min(initial=np.inf) for s in seams]
    return round(float(sum(near))) if np.isfinite(near).all() else 0


def level_named(hers: tuple[int, ...], level: int) -> int:
    """The number of a round, by her own; 0 for one between two of hers."""
    if hers and hers[1] - hers[0] == 1:
        return 0
    return min(hers, key=lambda n: abs(n - level), default=level)


def joined(sentence: str, code: str) -> bool:
    """Whether a sentence sews pieces together edge to edge, where none is put on another, or only tells how all is made: "worked separately"."""
    return _TOGETHER.search(english(sentence, code).text.lower()) is not None


def of_two(sentence: str, code: str) -> bool:
    """Whether a sentence speaks of two things, or of one on either side: where one is alone, the other was not heard."""
    return _TWO.search(english(sentence, code).text.lower()) is not None


def to_its_end(text: str, begin: int, end: int) -> str:
    """A sentence to its end, where a record came of its beginning; "" for a record of none."""
    found = _END.search(text, end)
    return text[begin : end if found is None else found.start()] if end > begin else ""


def as_far(sentence: str, wide: float) -> bool:
    """Whether two things are about as far from each other as a sentence says in centimetres or inches, if it does."""
    found = _APART.search(sentence)
    return found is None or abs(float(found[1]) * (25.4 if found[2] in INCHES else 10.0) - wide) <= _MISSED * wide


def puts_eyes(sentence: str, code: str) -> bool:
    """Whether a sentence puts eyes somewhere, and does not only name them: "to the left of the dc eyes"."""
    return _EYES.search(english(sentence, code).text.lower()) is not None

"""Lines: straight stitches, bands and crosses that are embroidered on a part, as many and as long as its text says."""

from __future__ import annotations

import re
from typing import Final

import numpy as np

from tambour.core.check import Array
from tambour.core.errors import Span
from tambour.core.rgb import RGB
from tambour.crochet.language.finishes import Embroidery, Spot
from tambour.crochet.places.habits import ROUND
from tambour.crochet.places.said import Where
from tambour.crochet.places.stand import Host
from tambour.crochet.words.numbers import QUANTITY, quantity

_HOW: Final = r"(?:straight|upright|vertical|horizontal|slanted|diagonal|lengthwise|parallel|long|short)"
LINES: Final = re.compile(
    rf"\b(?P<many>{QUANTITY}|some|several|a few)\s+(?:(?!or\b|and\b|of\b)[a-z-]+\s+){{0,3}}?(?P<what>lines|stripes|bands|grooves|bars|{_HOW}\s+(?:[a-z]+\s+){{0,2}}?(?:stitches|sts))\b"
    r"(?!\s+(?:apart|between|from|below|above|free|wide|of|to the (?:left|right)))"
)
"""Lines that are told by their number: "three short straight lines", "3 short upright stitches"."""
CROSS: Final = re.compile(
    r"\b(?:an?|the)\s+(?:[a-z]+\s+){0,2}?cross\b(?!\s+(?:st|stitch)\b)|\bcross\b(?=\s+(?:in|of|over)\s+(?:the\s+)?[a-z]+)(?!\s+over\b)"
)
_LENGTHWISE: Final = re.compile(
    r"\blengthwise\b|\blengthways\b|\bfrom (?:the )?(?:nose|head|front) to (?:the )?(?:tail|back|end)\b"
)
_LEVEL: Final = re.compile(r"\bhorizontal(?:ly)?\b|\bacross\b|\bside to side\b")
_AROUND: Final = re.compile(r"\b(?:bands|stripes)\b|\baround\b")
_SHORT, _LONG, _GAP = 2.4, 0.75, 1.6
"""How long lines are, short ones in stitches, long ones as a share of what they are on; how far apart, in stitches."""
_FLAT: Final = 0.3
"""A part is flat that is so thin for its width."""
_TUBE: Final = 2.0
"""A part is a tube that is so many times as long as wide."""
_HALF: Final = 0.5
_ALSO: Final = re.compile(
    r"\b(?:embroider|sew|make|add|stitch|work)\w*\b.*\b(?:knots?|nose|mouth|smile|eyes|eyebrows?|cheeks)\b.*,?\s+and\s+$"
)
"""What is drawn before them in the same sentence: "Embroider one yellow French knot, and two long stitches down the door"."""
_NEAR: Final = 3
_HEADS: Final = re.compile(rf"\W*(?:{ROUND}s?\s?\.?\s*\d|\d{{1,2}}\s*[.):]\s)", re.IGNORECASE)
"""So many lines, the sentence's own with them, hold the last round of the part that it stands in; how rounds begin."""
_THICK: Final = 1.8


def called(low: str) -> str:
    """What a sentence (in small letters) has drawn of straight stitches: "lines", "cross", or nothing."""
    return "cross" if CROSS.search(low) else "lines" if LINES.search(low) else ""


def worked(low: str, parts: list[tuple[int, int]]) -> bool:
    """Whether the lines of a sentence are parts that were crocheted. parts : where it names some."""
    return any(
        m.start() < end and begin < m.end()
        for said in (LINES, CROSS)
        for m in said.finditer(low)
        for begin, end in parts
    )


def behind_rounds(text: str, begin: int, near: int = _NEAR) -> bool:
    """Whether a sentence, at ``begin`` of a text, stands right behind rounds, and so in their part."""
    before = [line for line in text[:begin].split("\n")[-near:] if line.strip()]
    return any(_HEADS.match(line) for line in before)


def second(low: str) -> int:
    """Where a sentence (in small letters) goes on with other lines somewhere else, "…, and three bands across the tail"; 0 where it does not."""
    found = [m.start() for m in LINES.finditer(low)]
    behind = found[:1] if found and _ALSO.search(low[: found[0]]) else found[1:2]
    return behind[0] if behind else 0


def drawn(host: Host, name: str, middle: Array | None, low: str, at: Where, color: RGB, span: Span) -> list[Embroidery]:
    """Their strokes on a part. middle : the point about which they lie; None: that of the part."""
    points = np.concatenate([p for _, p in host.levels])
    centre = points.mean(0)
    ways = np.linalg.svd(points - centre, full_matrices=False)[2]
    reach = np.ptp((points - centre) @ ways.T, axis=0)
    flat = bool(reach[2] < _FLAT * reach[1])
    spot = host.near(centre if middle is None or (flat and at.rounds is None) else middle, 0.1)
    frame = host.stand.frame(spot)
    point, along, up = frame.points[0], frame.along[0], frame.up[0]
    if name == "cross":
        arm = 0.33 * float(min(reach[0], reach[1]))
        return [_stroke(host, point, way, arm, color, span) for way in (up, along)]
    said = LINES.search(low)
    many = 3 if said is None or said["many"] in ("some", "several", "a few") else round(quantity(said["many"]))
    many = min(max(many, 1), 12)
    if _AROUND.search(low) and not flat and reach[0] > _TUBE * reach[1] and not _LENGTHWISE.search(low):
        return _rings(host, many, low, at, color, span)
    if flat and _LENGTHWISE.search(low):
        up = ways[0]
        along = np.cross(frame.normals[0], up)
    way, aside = (along, up) if _LEVEL.search(low) and at.rounds is None and not flat else (up, along)
    wide = float(np.ptp((points - centre) @ aside))
    rounds = None if at.rounds is None or at.rounds[2] else at.rounds[1] - at.rounds[0]
    half = 0.5 * (rounds or (_LONG * float(np.ptp((points - centre) @ way)) if re.search(r"\blong\b", low) else _SHORT))
    gap = at.apart or (wide / (many + 1.0) if flat else _GAP)
    return [_stroke(host, point + (k - 0.5 * (many - 1)) * gap * aside, way, half, color, span) for k in range(many)]


def _stroke(host: Host, point: Array, way: Array, half: float, color: RGB, span: Span) -> Embroidery:
    """A line of thread over the fabric, through holes a stitch and a half apart."""
    steps = max(2, round(half / 0.75) + 1)
    places: list[Spot] = []
    for t in np.linspace(-half, half, steps):
        at = host.near(point + t * way, 0.1)
        if not places or at != places[-1]:
            places.append(at)
    return Embroidery(tuple(places), color, _THICK, span)


def _rings(host: Host, many: int, low: str, at: Where, color: RGB, span: Span) -> list[Embroidery]:
    """Bands about a tube, in the half of it that is said: its top half is where it is sewn on, or what is above."""
    numbers = [n for n, _ in host.levels]
    begin, end = (at.rounds[0], at.rounds[1]) if at.rounds is not None else (float(numbers[0]), float(numbers[-1]))
    if at.rounds is None:
        quarter = 0.5 * (end - begin)
        if re.search(r"\b(?:top|upper) (?:half|part|end)\b", low):
            begin += quarter
        elif re.search(r"\b(?:bottom|lower) (?:half|part|end)\b|\btip\b", low):
            end -= quarter
    made = []
    for k in range(many):
        level = round(begin + (k + _HALF) * (end - begin) / many)
        n = host.count(level)
        places = tuple(Spot(host.name, float(level), float(s)) for s in (*range(1, n + 1), 1))
        made.append(Embroidery(places, color, _THICK, span))
    return made

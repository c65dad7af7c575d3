"""Hairdo: hair of yarn as people knot it: along a parting, all over the crown, in rounds that are said; loose, in bunches, in a bun."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from dataclasses import replace
from typing import Final

import numpy as np

from tambour.core.check import Array
from tambour.core.errors import Span
from tambour.core.rgb import RGB
from tambour.crochet.language.finishes import Hair, Spot
from tambour.crochet.places.said import LONG, length
from tambour.crochet.places.stand import Host
from tambour.crochet.words.numbers import QUANTITY, quantity

KNOTTED: Final = re.compile(
    r"\b(?:attach|knot|latch|hook|loop|pull|draw|thread|sew|stitch|lay|work|add|tie|glue)\w*\b(?:(?!\b(?:to|on|onto|in|into|at|over|under|behind|near|below|above|between|around|of)\b)[^.]){0,60}\bhair\b(?!\s*(?:bow|tie|band|clip|ribbon|line\b))"
    r"|\bhair\b[^.]*\b(?:attach|knot|latch|loop|pull|draw|thread|sew|lay|fold|add|cut)\w*\b"
    r"|\b(?:strands?|pieces? of (?:\w+ )?yarn|lengths?(?: of (?:\w+ )?yarn)?)\b[^.]*\b(?:attach|knot|latch|loop|pull|draw|sew|stitch|lay)\w*\b[^.]*\b(?:head|crown|scalp|hairline|parting)\b"
    r"|\b(?:attach|knot|latch|loop|pull|draw|sew|lay)\w*\b[^.]*\b(?:strands?|pieces? of (?:\w+ )?yarn|lengths?(?: of (?:\w+ )?yarn)?)\b[^.]*\b(?:head|crown|scalp|hairline|parting)\b"
    r"|\b(?:fold|pull|draw|loop)\w*\b[^.]*\b(?:head|crown|scalp)\b[^.]*\b(?:hook|loop|all over|every st)"
)
"""A sentence that puts strands of yarn on a head."""
SEWN_HAIR: Final = re.compile(
    r"\b(?:sew|stitch|knot|attach)\w*\b(?:(?!\b(?:to|on|onto|in|into|at|over|under|behind|near|below|above|between|around)\b)[^.,;]){0,40}"
    r"(?P<hair>(?:\band\s+(?:the\s+)?)?\bhair\b)(?!\s*(?:bow|tie|band|clip|ribbon|line))"
)
"""Strands of yarn that are sewn to a head along with something else."""
CUT: Final = re.compile(r"\b(?:cut|wrap|wind)\w*\b[^.]*\b(?:strands?|pieces?|lengths?|yarn)\b")
"""What is done before: strands are cut, yarn is wound about a book."""
COMBED: Final = re.compile(
    r"\b(?:pig ?tails?|pony ?tails?|bunch(?:es)?|braid\w*|plait\w*|buns?|top ?knots?|fringe|bangs)\b|\b(?:fold|gather|pull|put)\w*\s+(?:the\s+)?hair\s+up\b|\btrim\w*\b[^.]*\bhair\b"
)
"""What is done with hair that is there."""
_ELSE: Final = re.compile(
    r"\b(?:whiskers?|tail|mane|scarf|tassels?|beard|mustache|moustache|blanket|poncho|ears?|pompo?ms?|body|nose|mouth|forelock)\b"
)
"""What strands are knotted to as well, and that is no head."""
_MANY: Final = re.compile(
    rf"\b({QUANTITY})\s+(?:x\s+\d+\W{{1,3}}(?:cm|mm|in|inch)?(?:\s*\[[^\]]*\])?\s*)?(?:\w+\s+){{0,2}}?(?:strands?|pieces?|lengths?)\b|\b({QUANTITY})\s+times\b"
)
_CUT: Final = re.compile(r"\b(\d+(?:\.\d+)?)\s*-?\s*(cms?|mms?|ins?|inch(?:es)?|\"|centimet\w+)(?=\W|$)")
_ALL: Final = re.compile(
    r"\ball over\b|\b(?:every|each|all) (?:of the )?(?:st\b|stitch|sts\b)|\bspiral|\bhairline\b|\brug\b|\bwhole (?:head|crown)\b|\b(?:rows?|rounds?) of (?:hair|strands)\b|\bcrown\b"
)
_PARTED: Final = re.compile(r"\b(?:part(?:ing|ed)?|cent(?:er|re)|middle)\b")
_TWO: Final = re.compile(
    r"\bpig ?tails\b|\bbunches\b|\b(?:two|2|both) (?:pony ?tails|braids|plaits)\b|\b(?:braids|plaits|pony ?tails)\b|\b(?:braid|plait)\w*\b[^.]*\b(?:each|both) side"
)
_ONE: Final = re.compile(r"\bpony ?tail\b|\b(?:a|one|single) (?:braid|plait)\b")
_BUN: Final = re.compile(r"\bbuns?\b|\btop ?knots?\b|\bhair\s+up\b")
_FRINGE: Final = re.compile(r"\b(?:bangs|fringe)\b")
_CUT_TO: Final = {"chin": 1.9, "shoulder": 2.8, "waist": 5.0}
"""How long hair is, in halves of a head's height, that is trimmed to a place."""
_CROWN: Final = ((0.0, 0.9, -0.4), (0.0, 0.5, -0.85))
_NAPE: Final = np.array([0.0, 0.5, -0.85])
"""A mane's way over a head, behind its ears, and where it is on a neck."""
USUAL: Final = 2.6
"""The same where nothing says it."""
CLOSE: Final = 1.1
"""How many strands there are to a stitch of a line."""
_BARE: Final = math.radians(62.0)
"""A face is free so far to either side."""
_HIGH: Final = 0.86
"""Above this share of half a head's height hair grows all round."""


def is_hair(low: str) -> bool:
    """Whether a sentence (in small letters) puts hair on a head."""
    return KNOTTED.search(low) is not None and ("hair" in low or not _ELSE.search(low))


def hairs(
    host: Host,
    at: Callable[[Spot], bool],
    text: str,
    rounds: tuple[float, float] | None,
    stitch: float,
    color: RGB,
    spans: list[Span],
) -> list[Hair]:
    """The strands of a head's hair. text : all that is said of it; at : whether a spot is there; stitch : its width, mm;
    spans : of the sentences that say it, shared out among the records."""
    middle, half = host.box
    high = float(half[1])
    cut = 2.0 * _hangs(text) * high * stitch if said_length(text) is None else float(said_length(text) or 0.0)
    tied = bool(_TWO.search(text) or _ONE.search(text) or _BUN.search(text))
    lines: list[list[Spot]] = []
    if rounds is not None:
        step = max(1, round((rounds[1] - rounds[0]) / 4.0))
        for level in np.arange(rounds[0], rounds[1] + 0.5, step):
            ring = [p for n, p in host.levels if n == int(level)]
            up = (float(ring[0][:, 1].mean()) - middle[1]) / high if ring else 0.0
            lines.append(
                [Spot(host.name, float(level), round(host.in_round(float(level), way), 3)) for way in _arc(0.0, up)]
            )
    elif tied or (_ALL.search(text) and not _PARTED.search(text)):  # what is gathered up comes from all over the head
        for up in (0.95, 0.75, 0.5, 0.25):
            lines.append([host.near(middle + way * half) for way in _arc(up, up)])
    else:
        ways = ((0.0, 0.99, 0.12), (0.0, 0.93, -0.4), (0.0, 0.65, -0.8), (0.0, 0.3, -0.95))
        lines.append([host.near(middle + np.array(way) * half) for way in ways])
    if _FRINGE.search(text):
        lines.append(
            [host.near(middle + np.array(way) * half) for way in ((-0.5, 0.8, 0.4), (0.0, 0.9, 0.45), (0.5, 0.8, 0.4))]
        )
    lines = [
        line
        for line in ([s for k, s in enumerate(line) if at(s) and (not k or s != line[k - 1])] for line in lines)
        if len(line) > 1
    ]
    least = max(6, round((strands(text) or 0) / max(len(lines), 1)))
    made = []
    for k, line in enumerate(lines):
        count = max(least, round(CLOSE * _far(host, line) * (2.2 if len(lines) == 1 else 1.0)))
        short = min(cut, 2.4 * high * stitch) if tied else cut
        fringe = _FRINGE.search(text) is not None and k == len(lines) - 1
        made.append(Hair(tuple(line), min(count, 90), round(1.3 * high * stitch if fringe else short, 1), color))
    for way in _bunches(text):
        spot = host.near(middle + np.array(way) * half)
        long = 1.1 * high * stitch if _BUN.search(text) else cut
        made.append(Hair((spot,), 16, round(long, 1), color))
    return [replace(one, spots=tuple(replace(s, span=span) for s in one.spots), span=span)
            for one, span in zip(made, [*spans, *[spans[-1]] * len(made)])]  # fmt: skip


def mane(hosts: list[Host], at: Callable[[Spot], bool], text: str, stitch: float, color: RGB, span: Span) -> list[Hair]:
    """A mane: strands along the crown and down the nape of every part of a head and its neck."""
    cut = said_length(text) or 2.0 * USUAL * float(hosts[0].box[1][1]) * stitch
    made = []
    for k, host in enumerate(hosts):
        middle, half = host.box
        if k:  # from end to end of a neck
            numbers = [float(n) for n, ring in host.levels if len(ring)]
            numbers = [numbers[round(share * (len(numbers) - 1))] for share in (0.1, 0.4, 0.65, 0.9)]
            line = [Spot(host.name, n, round(host.in_round(n, _NAPE), 3)) for n in numbers]
        else:
            line = [host.near(middle + np.array(way) * half) for way in _CROWN]
        line = [spot for spot in line if at(spot)]
        line = [replace(s, span=span) for i, s in enumerate(line) if not i or s != line[i - 1]]
        if len(line) > 1:
            count = min(90, max(6, round(2.2 * CLOSE * _far(host, line))))
            made.append(Hair(tuple(line), count, round(cut, 1), color, span))
    return made


def said_length(text: str) -> float | None:
    """How long strands are cut, mm, where it is said."""
    long, strands = LONG.search(text), re.search(r"\bcut\b|\b(?:strand|piece|length)s?\b", text)
    if long:  # a strand is folded in half; hair is as long as it hangs
        return float(length(long[1], long[2])) * (1.0 if strands else 2.0)
    found = _CUT.search(text)
    unit = {"c": "cm", "m": "mm"}.get(found[2][0], "in") if found else ""
    return float(length(found[1], unit)) if found else None


def before(text: str, start: int) -> str:
    """What is said of strands just before a sentence that begins at ``start``: how many are cut, how long."""
    said = re.split(r"\.\s|\n", text[max(0, start - 260) : start])
    return ". ".join(one for one in said if CUT.search(one) and not _ELSE.search(one)) + " "


def _hangs(text: str) -> float:
    return next((far for word, far in _CUT_TO.items() if word in text), USUAL)


def strands(text: str) -> int | None:
    """How many strands are cut, where it is said."""
    found = _MANY.search(text)
    return None if found is None else min(int(quantity(found[1] or found[2]) or 0), 160)


def _arc(up: float, high: float) -> list[Array]:
    """The ways from a head's middle to a row of hair that leaves the face free; all round near the crown."""
    bare = 0.0 if high > _HIGH else _BARE
    turns = np.linspace(bare, 2.0 * math.pi - bare, 9 if bare else 10)
    flat = math.sqrt(max(1.0 - up * up, 0.05))
    return [np.array([flat * math.sin(t), up, flat * math.cos(t)]) for t in (turns if bare else turns[:-1])]


def _bunches(text: str) -> list[tuple[float, float, float]]:
    if _BUN.search(text):
        return [(0.0, 1.0, -0.1)]
    if _TWO.search(text):
        return [(-0.9, 0.3, -0.2), (0.9, 0.3, -0.2)]
    return [(0.0, 0.72, -0.75)] if _ONE.search(text) else []


def _far(host: Host, line: list[Spot]) -> float:
    """How long a line of spots is, in stitches."""
    points = np.array([host.stand.frame(s).points[0] for s in line])
    return float(np.sqrt((np.diff(points, axis=0) ** 2).sum(1)).sum())

"""Agree: whether what is ours beside a designer's sentence agrees with it: the rounds, the stitches and the sides that both name."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from tambour.core.errors import Span
from tambour.crochet.language.tree import Pattern
from tambour.crochet.words.gloss import english
from tambour.crochet.words.numbers import NUMBERS, TEENS, TENS

_COUNTS: Final = {**NUMBERS, **TEENS, **TENS}
_SPELT: Final = re.compile(rf"\b(?:{'|'.join(_COUNTS)})\b")
_NEAR: Final = 1.0
"""Places that differ by no more than so many rounds or stitches are one place."""
_JOINT: Final = r"\s*(?:-|–|—|/|to|and|&|through|thru|up to|down to)\s*"
_ROUND: Final = re.compile(
    rf"\b(?:rounds?|rnds?|rows?|rds?|r)\b\.?\s*(?P<a>\d+)(?:{_JOINT}(?:(?:rounds?|rnds?|rds?|r)\b\.?\s*)?(?P<b>\d+))?(?!\s*(?:sts?|stitch|mm|cm|x)\b)"
    rf"|\b(?P<c>\d+)(?:st|nd|rd|th)(?:{_JOINT}(?P<d>\d+)(?:st|nd|rd|th))?\s+(?:rounds?|rnds?|rds?)\b"
    rf"|\br(?P<e>\d+)(?:{_JOINT}r?(?P<f>\d+))?\b(?!\s*(?:sts?|stitch)\b)"
)
_EDGE: Final = re.compile(
    r"\b(?:edges?|ends?|corners?|tips?|top|bottom|sides?|line|rim|start\w*|begin\w*|from|down(?: to)?|up to|reach\w*|doorstep|under|below|above|until)\b[^.;,]{0,22}$|\bthe other (?:one )?(?:is )?(?:at|on|by)\b[^.;,]{0,10}$"
)
"""What says before a round that an end of something is there, and not its middle."""
_MIDDLE: Final = re.compile(r"\b(?:middles?|cent(?:er|re)s?|centered|centred)\b[^.;,]{0,24}$")
_BETWEEN: Final = re.compile(r"\b(?:between|betw?)\W*$")
_COUNTED_ON: Final = re.compile(r"\bcounted on\W*$")
_GAP: Final = re.compile(
    r"(?<![\w/])(\d+)\s*(?:visible |free |empty )?(?:sts?|stitch(?:es)?|loops?)\b(?: \w+)? (?:apart|between|free between|in between|left free)"
)
_GAP_TO: Final = re.compile(r"\bbetween (?:the )?(?!two\b|them\b)[a-z]+ and\b")
"""Stitches that are between a thing and another, and not between two of a kind."""
_OFF: Final = re.compile(r"(\d+)(½)?(?:–\d+)? (?:sts?|stitch(?:es)?) from the middle of the (front|back|top|underside)")
_PAIRED: Final = re.compile(
    r"(\d+) (?:sts?|stitch(?:es)?) (?:to|against) (?:the )?(\d+)|(\d+) to (\d+) (?:sts?|stitch(?:es)?)|\b(?:both|each)(?: \w+){0,3} have (\d+)\b"
)
_SEEN: Final = (
    ("front", re.compile(r"\bin the middle of the front\b"), re.compile(r"\b(?:front|face|chest|muzzle|snout|tummy|belly)\b(?! (?:loop|post|legs?|paws?|edge|end|corner))")),
    ("back", re.compile(r"\bin the middle of the back\b"), re.compile(r"\bback\b(?! (?:loop|post|legs?|paws?|edge|end|corner|stitch|and|on (?:the|your) hook|in\b|marker))")),
    ("side", re.compile(r"\bat the side\b"), re.compile(r"\bsides? of\b|\b(?:each|either|both|left|right)(?: and (?:left|right))?(?:[- ]hand)? sides?\b|\b(?:left|right)[- ]hand\b|\bto the (?:left|right)\b|\bleft and (?:to the )?right\b|\bright and left\b")),
    ("top", re.compile(r"\bon top\b"), re.compile(r"\b(?:crown|on top|top of)\b")),
    ("under", re.compile(r"\bunderneath\b"), re.compile(r"\b(?:under(?:side|neath)|belly side|bottom of)\b")),
)  # fmt: skip
"""Sides: how ours says that something is there, and how hers names them."""
_GROUPS: Final = (frozenset(("front", "back", "side")), frozenset(("top", "under")))
"""Sides that exclude one another: ears are on top, and at the sides."""
_WAYS: Final = {
    "up": re.compile(r"\b(?:up|upwards?|upright)\b"),
    "down": re.compile(r"\b(?:down|downwards?|hang\w*|droop\w*)\b"),
    "forwards": re.compile(r"\b(?:forwards?|ahead|to(?:wards)? the front)\b"),
    "backwards": re.compile(r"\b(?:backwards?|point back|look back|to(?:wards)? the back|back and)\b"),
    "outwards": re.compile(r"\b(?:outwards?|outside|out to the sides?|left and right|to the sides?)\b"),
}
_POSED: Final = re.compile(
    r"\b(?:hang|stand|point|look|lean|lies?|lying|rests?|resting|bring|brought|curl|wrap|bend|bent|turn(?! inside| right)|tilt|upright|level|flat on|floor|table|tips?|flap|catch|fall|droop|rais)\w*\b"
)
"""How she says in which pose a part is held."""
_POINTING: Final = re.compile(r"\bpointing ([\w, ]+)|\bresting on\b")
_LEVEL: Final = re.compile(r"\b(?:as high as|level with|same height|in (?:one )?line with|at the height of)\b")
"""A place by that of something else."""


@dataclass(frozen=True, slots=True)
class Claims:
    """What words say of a place.

    middles, edges, spans : rounds: where the middle of something is, where its ends are, from and to which it reaches; ons : rounds of which
    neither is said; gaps : stitches between two things; offs : from the middle; pairs : stitches sewn to stitches
    sides, ways : where, and where to; posed : how it is held; relative : its height is that of something else
    """

    middles: tuple[float, ...] = ()
    edges: tuple[int, ...] = ()
    spans: tuple[tuple[int, int], ...] = ()
    ons: tuple[float, ...] = ()
    gaps: tuple[int, ...] = ()
    offs: tuple[float, ...] = ()
    pairs: tuple[int, ...] = ()
    sides: frozenset[str] = frozenset()
    ways: frozenset[str] = frozenset()
    posed: bool = False
    relative: bool = False


def claims(words: str, code: str, ours: bool = False) -> Claims:
    """What a sentence claims, of hers or of ours."""
    low = _SPELT.sub(lambda m: str(_COUNTS[m[0]]), english(words, code).text.lower())
    middles, edges, spans, ons = list[float](), list[int](), list[tuple[int, int]](), list[float]()
    for m in _ROUND.finditer(low):
        a, b = next((int(m[x]), int(m[y]) if m[y] else None) for x, y in ("ab", "cd", "ef") if m[x])
        before = low[max(0, m.start() - 40) : m.start()]
        if ours and m[0].startswith("row"):
            continue  # which way up a piece is
        if _COUNTED_ON.search(before):
            continue
        if b is not None and _BETWEEN.search(before) and b - a == 1:
            (middles if _MIDDLE.search(before) else ons).append(a + 0.5)
        elif b is not None:
            spans.append((min(a, b), max(a, b)))
        elif _MIDDLE.search(before):
            middles.append(float(a))
        elif _EDGE.search(before):
            edges.append(a)
        else:
            ons.append(float(a))
    if len(edges) == 2 and not spans:
        spans, edges = [(min(edges), max(edges))], []
    pointing = _POINTING.search(low)
    told = low if not ours else (pointing[1] or pointing[0]) if pointing is not None else ""
    return Claims(
        tuple(middles),
        tuple(edges),
        tuple(spans),
        tuple(ons),
        tuple(-1 if _GAP_TO.search(low, m.end(1), m.end() + 30) else int(m[1]) for m in _GAP.finditer(low)),
        tuple(int(n) + 0.5 * bool(half) for n, half, _ in _OFF.findall(low)),
        tuple(int(n) for found in _PAIRED.findall(low) for n in found if n),
        frozenset(side for side, mine, hers in _SEEN if (mine if ours else hers).search(low)),
        frozenset(way for way, said in _WAYS.items() if said.search(told)),
        bool(told if ours else _POSED.search(low)),
        _LEVEL.search(low) is not None,
    )


def against(hers: Claims, ours: Claims, wide: float = 1.0) -> list[str]:
    """What of ours contradicts hers, a few words each; ``wide``: how many stitches each of two things takes up."""
    return [*placed_otherwise(hers, ours, wide), *_posed_otherwise(hers, ours)]


def placed_otherwise(hers: Claims, ours: Claims, wide: float = 1.0) -> list[str]:
    """What of ours has something in another place than she says."""
    return [*_rounds(hers, ours), *_stitches(hers, ours, wide), *_looks(hers, ours)]


def _rounds(hers: Claims, ours: Claims) -> list[str]:
    made = []
    known = [*hers.spans, *((n, n) for n in (*hers.ons, *hers.middles))]
    for n in ours.middles:
        if known and not any(_in(n, a, b) for a, b in known):
            made.append(f"its middle at round {n:g}, hers is elsewhere")
        elif hers.edges and not known and any(abs(n - e) <= _NEAR for e in hers.edges):
            made.append(f"its middle at round {n:g}, where she has an edge")
    for a, b in ours.spans:
        if any(max(abs(a - c), abs(b - d)) <= _NEAR for c, d in hers.spans):
            continue
        if hers.spans:
            made.append(f"rounds {a} to {b}, hers are others")
        elif hers.edges and min(abs(e - end) for e in hers.edges for end in (a, b)) > _NEAR:
            made.append(f"rounds {a} to {b}, none of which is the end she names")
        elif any(not _in(n, a, b) for n in (*hers.ons, *hers.middles)):
            made.append(f"rounds {a} to {b}, hers is none of them")
    for n in ours.ons:
        where = [*known, *((e, e) for e in hers.edges)]
        if where and not any(_in(n, a, b) for a, b in where):
            made.append(f"round {n:g}, hers is another")
    return made


def _in(n: float, a: float, b: float) -> bool:
    return a - _NEAR <= n <= b + _NEAR


def _stitches(hers: Claims, ours: Claims, wide: float) -> list[str]:
    made = []
    if hers.gaps and ours.gaps and not any(abs(g - n) <= _NEAR for g in ours.gaps for n in hers.gaps):
        made.append(f"{ours.gaps[0]} stitches between, hers are {hers.gaps[0]}")
    if hers.gaps and ours.offs and not ours.gaps and not ours.spans:  # an edge across rounds is counted over the top
        apart = [2.0 * off - wide for off in ours.offs]
        if not any(abs(g - n) <= 2.0 * _NEAR for g in apart for n in hers.gaps):
            made.append(f"{ours.offs[0]:g} stitches from the middle, {hers.gaps[0]} between the two are hers")
    if hers.pairs and ours.pairs and not set(hers.pairs) & set(ours.pairs):
        made.append(f"{ours.pairs[0]} stitches sewn, hers are {hers.pairs[0]}")
    return made


def _looks(hers: Claims, ours: Claims) -> list[str]:
    made = []
    for group in _GROUPS:
        mine, said_ = ours.sides & group, hers.sides & group
        if mine and said_ and not mine & said_:
            made.append(f"at the {'/'.join(sorted(mine))}, hers is the {'/'.join(sorted(said_))}")
    if "side" in hers.sides and not hers.sides & {"front", "back"} and ours.offs and max(ours.offs) <= 3.0:
        made.append(f"{ours.offs[0]:g} stitches from the middle, hers is at a side")
    return made


def _posed_otherwise(hers: Claims, ours: Claims) -> list[str]:
    """What of ours has something in another pose than she says, or at a height that she says by something else."""
    made = []
    if ours.middles and hers.relative and not (hers.spans or hers.ons or hers.middles or hers.edges):
        made.append(f"its middle at round {ours.middles[0]:g}, which she says by something else")
    if ours.posed and hers.posed and not (ours.ways and ours.ways <= hers.ways):
        made.append(f"held {'/'.join(sorted(ours.ways - hers.ways)) or 'on something'}, which she does not say")
    return made


def said(pattern: Pattern, span: Span, others: Sequence[int]) -> str:
    """All that she says of a part where she puts it: to the end of the line, or to where one of the ``others`` is put somewhere in it."""
    text = pattern.text.text
    if span.end <= span.start:
        return ""
    stop = text.find("\n", span.end - 1)
    return text[span.start : min([stop if stop >= 0 else len(text), *(at for at in others if at >= span.end)])]


def kept(pieces: Sequence[str], hers: Claims, code: str) -> list[str]:
    """Of the pieces of a sentence of ours, whose place agrees with hers, those that also agree with how she holds it.

    >>> kept(["at round 22", "pointing forwards"], claims("The legs hang from round 22", "us"), "us")
    ['at round 22']
    """
    return [one for one in pieces if one and not _posed_otherwise(hers, claims(one, code, True))]

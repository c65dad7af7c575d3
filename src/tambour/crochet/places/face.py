"""Faces: what people embroider, by its name: noses, smiles, brows, cheeks, whiskers, as strokes about a place."""

from __future__ import annotations

import re
from typing import Final

import numpy as np

from tambour.core.check import Array
from tambour.core.errors import Span
from tambour.core.rgb import RGB
from tambour.crochet.language.finishes import Embroidery, Spot
from tambour.crochet.places import lines
from tambour.crochet.places.stand import Host
from tambour.crochet.words.numbers import QUANTITY, quantity

Stroke = list[tuple[float, float]]

WORDS: Final[dict[str, str]] = {
    "whiskers": r"\bwhiskers?\b",
    "lashes": r"\b(?:eye)?lash(?:es)?\b",
    "brows": r"\b(?:eye)?brows?\b",
    "cheeks": r"\b(?:cheeks?|blush)\b",
    "freckles": r"\bfreckles?\b",
    "smile": r"\b(?:smil\w*|grin)\b",
    "mouth": r"\b(?:mouth|lips?|line|muzzle line)\b",
    "glints": r"\blines?\b(?=[^.;]*\b(?:below|under|beneath|beside|next to) (?:of )?(?:each|both|every) (?:\w+ )?eyes?\b)",
    "nostrils": r"\bnostrils?\b",
    "nose": r"\b(?:nose|snout)\b",
    "claws": r"\b(?:claws?|toes|toe-?nails?|paw details?|fingers)\b",
    "navel": r"\b(?:navel|belly ?button)\b",
    "eyes": r"\beye(?:s|lids?)?\b",
    "dots": r"\b(?:dots?|spots?|french knots?|seeds?)\b",
}
"""What is embroidered → how it is called; the first that fits is meant."""
PAIRED: Final = frozenset(
    ("whiskers", "lashes", "glints", "brows", "cheeks", "freckles", "eyes", "closed eyes", "nostrils")
)
PINK: Final[RGB] = (232, 150, 160)
DARK: Final[RGB] = (40, 30, 26)
_SEEN: Final = {name: re.compile(words) for name, words in WORDS.items()}


_WORKED: Final = re.compile(
    r"^(?!.*\b(?:embroider|knot|sew|felt|glue|paint)).*\bdots? (?:is|are)\b.*\b(?:worked|sts?|stitches|rounds?|rnds?)\b"
)
"""Dots that are worked into the rounds in another yarn, and not drawn on them."""


def motifs(text: str) -> list[str]:
    """What of :data:`WORDS` a sentence (in small letters) speaks of, in its order; places it is beside left out."""
    text = re.sub(r"\bbetween (?:the )?(?:ears?|head|neck) and (?:the )?(?:nose|mouth|eyes?)\b", " ", text)
    plain = re.sub(
        r"\b(?:below|under|beneath|above|over|between|beside|next to|in line with|level with|bottom of|top of|tip of|"
        r"cent(?:er|re) of|sides? of|per|from|near|to|towards?|facing|behind|against|of|onto|(?<!stitch )(?<!sew )(?<!embroider )on|around|across)\s+"
        r"(?:the\s+|each\s+|both\s+|safety\s+|its\s+|your\s+|left\s+|right\s+|his\s+|her\s+)*(?:bottom of the )?"
        r"(?:eyes?|nose|mouth|muzzle|snout|cheeks?|ears?|smile|eyebrows?)\b",
        " ",
        text,
    )
    found = [(m.start(), name) for name, seen in _SEEN.items() if (m := seen.search(plain))]
    names = [name for _, name in sorted(found)]
    if _SEEN["glints"].search(text) and not re.search(r"\b(?:mouth|lips?|smile)\b", plain):
        names = ["glints" if name == "mouth" else name for name in names]  # "a white line below each eye" is no mouth
    if "smile" in names and "mouth" in names:
        names.remove("mouth")
    if len(names) > 1 and "cheeks" in names and "cheek" not in plain:
        names.remove("cheeks")  # "Use the blush to sew a small nose": a yarn
    if {"nostrils", "nose"} <= set(names) and not re.search(r"\bnose\b", plain):
        names.remove("nose")  # in a snout
    if "dots" in names and _WORKED.search(text):
        names.remove("dots")
    if len(names) > 1 and "dots" in names:
        names.remove("dots")
    return names or [drawn for drawn in (lines.called(text),) if drawn]


def found(name: str, text: str) -> tuple[int, int] | None:
    """Where a text speaks of a motif for the first time."""
    seen = (lines.CROSS if name == "cross" else lines.LINES if name == "lines" else _SEEN[name]).search(text)
    return (seen.start(), seen.end()) if seen else None


def styled(name: str, text: str) -> str:
    """The name of a motif with the way it is made, where that is said: "v nose", "closed eyes"."""
    if name == "nose" and re.search(r"\by\b|upside[- ]down .?y", text):
        return "y nose"
    if name == "nose" and re.search(r"\b[\"'“]?v\b", text):
        return "v nose"
    if name == "mouth" and re.search(r"\b[\"'“]?v\b|\bcurv\w*|\barc\b|\bu[- ]shape", text):
        return "smile"
    if name == "eyes" and re.search(r"\b(?:closed|sleep\w*|asleep|eyelids?)\b", text):
        return "closed eyes"
    return name


_WHISKERS: Final = re.compile(
    rf"\b({QUANTITY})\s+(?:[a-z]+\s+)?whiskers?\s+(?:per|on|to|at|in)\s+(?:each|either|every|both|(?:a\s+)?(?:cheek|side))"
    rf"|\bwhiskers?\W+({QUANTITY})\s+(?:and\s+({QUANTITY})\b|(?:on|per|to|at)\s+(?:each|either|every|side|cheek))"
)


def of_whiskers(text: str) -> int:
    """How many whiskers a sentence (in small letters) has on each side; three where it does not say it."""
    said = _WHISKERS.search(text)
    return 3 if said is None else min(max(round(quantity(said[1] or said[2])), 1), 5)


def strokes(name: str, wide: float, many: int = 3) -> list[Stroke]:
    """The strokes of a motif ``wide`` stitches wide, about (0, 0): to the right, up; of a pair those of the right one; ``many`` whiskers."""
    w = wide
    if name == "nose":
        rows = max(6, round(2.8 * w))  # yarn beside yarn, on a nose that bulges too
        made: Stroke = []
        for k in range(rows + 1):
            t = k / rows
            half = 0.5 * w * (1.0 - 0.85 * t)
            y = 0.32 * w - 0.64 * w * t
            made += [(-half, y), (half, y)] if k % 2 == 0 else [(half, y), (-half, y)]
        return [made]
    if name in ("v nose", "y nose"):
        v = [(-0.5 * w, 0.35 * w), (0.0, -0.2 * w), (0.5 * w, 0.35 * w)]
        return [v, [(0.0, -0.2 * w), (0.0, -0.9 * w)]] if name == "y nose" else [v]
    if name == "smile":
        return [_arc(w, 0.24, 9)]
    if name in ("eyes", "closed eyes"):
        if name == "closed eyes":
            return [_arc(w, 0.3, 7)]
        return [_oval(w, 1.25 * w)]
    if name == "cheeks":
        return [_oval(w, 0.6 * w)]
    if name == "glints":
        return [_arc(w, 0.3, 5)]
    if name == "brows":
        return [[(-0.5 * w, -0.08 * w), (0.5 * w, 0.16 * w)]]
    if name == "whiskers":
        return [[(0.0, 0.27 * k * w), (w, 0.6 * k * w)] for k in np.linspace(1.0, -1.0, many)]
    if name == "lashes":
        return [[(0.25 * w * k, 0.0), (0.45 * w * k, 0.4 * w)] for k in (-1, 0, 1)]
    if name == "lashes down":
        return [[(0.3 * w * k, -0.1 * w), (0.42 * w * k, -0.5 * w)] for k in (-1, 0, 1)]
    if name == "freckles":
        return [[(-0.4 * w, 0.0)], [(0.4 * w, 0.1 * w)], [(0.0, -0.35 * w)]]
    if name == "claws":
        return [[(0.32 * w * k, 0.3 * w), (0.34 * w * k, -0.3 * w)] for k in (-1, 0, 1)]
    if name == "nostrils":
        return [[(0.0, -0.5 * w), (0.0, 0.5 * w)]]
    if name == "navel":
        return [[(-0.3, -0.3), (0.3, 0.3)], [(-0.3, 0.3), (0.3, -0.3)]]
    if name == "dots":
        return [[(0.0, 0.0)]]
    if name == "mouth":
        return [_arc(w, 0.1, 7)]
    return [[(-0.5 * w, 0.0), (0.5 * w, 0.0)]]


def _arc(wide: float, deep: float, points: int) -> Stroke:
    """An arc that hangs, ``deep`` of its width."""
    t = np.linspace(-1.0, 1.0, points)
    return [(0.5 * wide * float(x), deep * wide * float(x * x - 1.0)) for x in t]


def _oval(wide: float, high: float) -> Stroke:
    """An oval in satin stitch, upright."""
    rows = max(3, round(2.6 * wide))
    made: Stroke = []
    for k in range(rows + 1):
        x = wide * (k / rows - 0.5) * 0.96
        half = 0.5 * high * float(np.sqrt(max(1.0 - (2.0 * x / wide) ** 2, 0.06)))
        made += [(x, -half), (x, half)] if k % 2 == 0 else [(x, half), (x, -half)]
    return made


USUAL: Final[dict[str, float]] = {
    "nose": 3.0,
    "v nose": 2.6,
    "y nose": 2.4,
    "mouth": 4.0,
    "smile": 5.0,
    "brows": 2.6,
    "cheeks": 2.4,
    "whiskers": 4.0,
    "lashes": 1.8,
    "glints": 1.8,
    "freckles": 1.6,
    "eyes": 1.5,
    "closed eyes": 3.0,
    "claws": 2.4,
    "navel": 1.0,
    "nostrils": 0.7,
    "dots": 1.0,
    "lines": 3.0,
    "cross": 3.0,
}
"""How many stitches wide a motif is, unless it is said."""
_THICK: Final = {
    "nose": 2.2,
    "eyes": 2.0,
    "cheeks": 2.0,
    "whiskers": 1.2,
    "lashes": 1.2,
    "freckles": 1.4,
    "nostrils": 2.2,
}

_YARN: Final = 0.24
"""How thick thread is at the least for a stitch's width: on thick yarn faces are made in thicker."""


def embroidered(
    host: Host,
    name: str,
    point: Array,
    wide: float,
    mirror: bool,
    color: RGB,
    span: Span,
    tall: float | None = None,
    stitch: float = 0.0,
    many: int = 3,
) -> list[Embroidery]:
    """A motif about a point of a host, in strokes that lie on its fabric; ``mirror``: the left one of a pair;
    ``tall``: how many rounds it is high, where that is said; ``stitch``: its width, mm, which thread goes with."""
    spot = host.near(point, 0.1)
    frame = host.stand.frame(spot)
    along, up = frame.along[0], frame.up[0]
    made = []
    thick = max(_THICK.get(name.removesuffix(" down"), 1.8), round(_YARN * stitch, 1))
    drawn = strokes(name, wide, many)
    heights = [y for stroke in drawn for _, y in stroke]
    high, middle = max(heights) - min(heights), 0.5 * (max(heights) + min(heights))
    for stroke in drawn:
        places: list[Spot] = []
        for x, y in stroke:
            if tall is not None and high > 0.0:
                y = (y - middle) * tall / high
            at = host.near(point + (-x if mirror else x) * along + y * up, 0.1)
            if not places or at != places[-1]:
                places.append(at)
        made.append(Embroidery(tuple(places), color, thick, span, motif=name.removesuffix(" down")))
    return made


def pieces(low: str, features: list[str]) -> list[str]:
    """What a clause says of each of several things that are embroidered: the words from its name on."""
    starts = [place[0] for name in features if (place := found(name, low)) is not None]
    ends = [*starts[1:], len(low)]
    return [low[a:b] for a, b in zip(starts, ends)] if len(starts) == len(features) else [low] * len(features)

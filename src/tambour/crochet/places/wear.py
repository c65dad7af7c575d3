"""Wear: which clothes a toy wears, and where: those that are made for it and fit; the others stay beside it."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Final

import numpy as np

from tambour.core.check import Array
from tambour.crochet.finish.dressed import OFF, Cloth, Wearer, base, fits, wears
from tambour.crochet.language.tree import Worn
from tambour.crochet.places.names import Made

if TYPE_CHECKING:
    from tambour.crochet.places.assemble import Assembly

_WHERE: Final = {
    "neck": "dress nightgown gown sweater coat bodice shirt tunic robe jacket vest cardigan undershirt overall dungaree jumper romper pajama swimsuit",
    "waist": "skirt apron tutu belt",
    "scarf": "scarf collar",
    "nape": "cape cloak",
    "brow": "headband tiara",
}
"""Where clothes are worn → their words: from the neck down, from the waist down, wound about the neck, down the back, about the head."""
_WORDS: Final = {word: where for where, words in _WHERE.items() for word in words.split()}
_PIECES: Final = frozenset(
    "edging trim ruffle strap lace tie sleeve buckle emblem gusset band pocket button bag side front back".split()
)
"""Words of parts that are pieces of clothes, and none by themselves."""
_STRIP: Final = 4.0
"""A scarf is so many times longer than wide, or more."""
_CLOSE: Final = 0.8
"""A strip is closed about a neck that it nearly reaches around: it is pulled tight."""
_FRONT: Final = np.array([0.0, 0.0, 1.0])


def where_worn(part: Made) -> str:
    """Where a part is worn by its name; "" for what is not put on a toy by itself."""
    if part.kind == "collar" and part.single and part.words[-1] == "collar":
        return "scarf"  # a strip that reaches about the neck; others are sewn on
    if not part.worn or part.copies > 1 or _PIECES & set(part.words):
        return ""
    return next((_WORDS[w] for w in reversed(part.words) if w in _WORDS), "")


def clothes(toy: Assembly) -> list[Worn]:
    """What the toy wears: of each place the first garment that the text makes, where it fits."""
    body, head = _body(toy), toy.of_kind("head")
    if body is None:
        return []
    made: list[Worn] = []
    for part in toy.parts:
        where = where_worn(part)
        index = toy.spots.parts.get(part.copy(1))
        if not where or part == toy.main or index is None or index in toy.sewn:
            continue
        host = head if where == "brow" else body
        taken = {one.where for one in made}
        if host is None or (where in taken and "belt" not in part.words):
            continue
        low, high = _rounds(toy, host, where)
        own = wears(toy.spots, toy.spots.parts[host.copy(1)], low, high)
        if len(own) < 12 or not _goes_on(toy, index, toy.stand.x[own], where):
            continue
        made.append(Worn(part.copy(1), host.copy(1), where, low, high))
    return made


def _body(toy: Assembly) -> Made | None:
    """What wears clothes: a body that stands or sits upright; nothing of what lies."""
    found = toy.of_kind("body") or (toy.main if toy.main.single and not toy.main.worn else None)
    if (
        found is None
        or (toy.made.ups.get(found.name) or toy.up.get(found.name)) in ("side", "back")
        or toy.spots.in_rows[toy.spots.parts[found.copy(1)]]
    ):
        return None
    faced = toy.of_kind("head", "face") is not None or bool(toy.heard.features)
    return found if faced else None


def _rounds(toy: Assembly, host: Made, where: str) -> tuple[int, int]:
    """The rounds of the body; of what is head and body in one without a neck its lower half."""
    whole = toy.host((host, 1))
    if where == "brow":
        own = toy.host((host, 1), "head")
        return own.low, own.high
    own = toy.host((host, 1), "body")
    separate = toy.of_kind("head") not in (None, host)
    if separate or (own.low, own.high) != (whole.low, whole.high):
        return own.low, own.high
    level = {n: float(p[:, 1].mean()) for n, p in whole.levels}
    middle = 0.5 * (max(level.values()) + min(level.values()))
    below = [n for n, y in level.items() if y <= middle]
    return min(below), max(below)


def _goes_on(toy: Assembly, part: int, x: Array, where: str) -> bool:
    """Whether a garment fits: its upper end goes over the body, and a strip is long enough to be wound about the neck."""
    wearer = Wearer(x, np.array([0.0, 1.0, 0.0]), _FRONT)
    span = toy.spots.built.graph.parts[part]
    own = toy.spots.layout[span.start : span.end]
    wide, high = (float(np.ptp(own[:, k])) + 1.0 for k in (0, 1))
    if where == "scarf":
        about = 2.0 * math.pi * (wearer.mean(0.04 * wearer.long) + OFF)
        return bool(toy.spots.in_rows[part]) and max(wide, high) > max(_STRIP * min(wide, high), _CLOSE * about)
    around = 2.0 * math.pi * (wearer.mean(wearer.catches(base(where), 0.0)) + OFF)
    cloth = Cloth(toy.spots, part, around)
    if not cloth.closed:
        return cloth.even and 0.25 * around < float(np.ptp(cloth.angle)) * float(cloth.wide[0]) < 1.2 * around
    return fits(wearer, base(where), float(cloth.wide[0]))

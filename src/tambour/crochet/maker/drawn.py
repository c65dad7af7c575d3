"""Drawn: how large the pictures have what is embroidered, and over which rounds, where a designer leaves it open."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import TYPE_CHECKING, Final

import numpy as np

from tambour.core.check import Array
from tambour.crochet.finish.features import placed
from tambour.crochet.finish.motif import CURVED, SATIN, UPRIGHT, extent
from tambour.crochet.finish.placing import frames
from tambour.crochet.language.finishes import Embroidery
from tambour.crochet.maker.agree import claims, placed_otherwise
from tambour.crochet.maker.sure import hers_too, of_stitches, of_two

if TYPE_CHECKING:
    from tambour.crochet.maker.taken import Taken

_FEW: Final = 4
"""A part of so many rounds is small: a place on it is seen."""
_FILLED: Final = re.compile(r"satin|satén|plattstich|passé", re.IGNORECASE)
_STITCH: Final = re.compile(
    r"back ?-?stitch|stem st|chain st|split st|straight st|long st|running st|rückstich|stielstich|kettenstich"
    r"|pespunte|punto atrás|cadeneta|point (?:arrière|de tige)|stiksteek|stiel?steek",
    re.IGNORECASE,
)
"""How she names the stitch of a line."""
_BOUGHT: Final = re.compile(
    r"\b(?:safety|plastic)(?: \w+)? nose|\bnose (?:of|in|from) (?:\w+ )?plastic\b", re.IGNORECASE
)
"""How she says that a nose is bought; safety eyes in the same sentence buy no mouth."""
_FACES: Final = (
    "smile",
    "mouth",
    "nose",
    "v nose",
    "y nose",
    "brows",
    "cheeks",
    "lashes",
    "navel",
    "closed eyes",
    "eyes",
    "claws",
)


def sized(taken: Taken, alike: list[Embroidery]) -> list[str]:
    """The pieces of the sentence of what is embroidered of one kind on one part, those whose rounds and sides agree with hers."""
    code = taken.built.pattern.terms
    hers = claims(taken.words(alike[0]), code)
    return [one for one in _sized(taken, alike) if one and not placed_otherwise(hers, claims(one, code, True))]


def _sized(taken: Taken, alike: list[Embroidery]) -> list[str]:
    own, first = taken.own, alike[0]
    if of_stitches(taken.words(first).lower()):
        return []  # she says how it is made
    part = taken.spots.parts[first.spots[0].part]
    rows = bool(taken.spots.in_rows[part])
    known = [(r, s) for r in alike for s in r.spots]
    points = frames(taken.spots, taken.piece.positions, [s for _, s in known]).points
    rounds = [s.round for _, s in known]
    many = max(
        1, round(max(rounds) - min(rounds))
    )  # as many as it is high: a place between two is in both, and counts once
    a = max(1, round(0.5 * (max(rounds) + min(rounds)) - 0.5 * (many - 1) - 0.01))
    b = a + many - 1
    if len(known) == 1:
        stitch = first.spots[0].stitch
        if stitch is None or of_two(taken.words(first), taken.built.pattern.terms):
            return []
        return [own["took knot row" if rows else "took knot"].format(a=round(rounds[0]), b=round(stitch))]
    over = own["took rounds"].format(a=a, b=b) if a < b else own["took round"].format(n=a)
    mine = (min(rounds), max(rounds))
    if rows or not hers_too(taken.built.pattern, taken.built.parts[part].section, *mine):
        over = ""  # nobody counts these so
    elif taken.rounds(first) or sum(r.part == part and r.number > 0 for r in taken.built.rounds) <= _FEW:
        over = ""  # she says it, or a snout is too small to be counted
    elif len(taken.built.graph.parts) > 1:
        over += f" ({taken.built.pattern.parts[taken.built.parts[part].section].name})"
    long = [float(np.sqrt(((p[-1] - p[0]) ** 2).sum())) for p in _each(alike, points)]
    if first.motif == "whiskers":
        begins = [abs(taken.off(r.spots[0])[0]) for r in alike]
        from_ = taken.from_middle(first.spots[0].part, [float(np.mean(begins))], taken.off(first.spots[0])[1])
        return [own["took lines"].format(n=len(alike) // 2 or 1, mm=round(float(np.mean(long)))), over, from_]
    if "nose" in first.motif and _BOUGHT.search(taken.words(first)):
        return [over]  # a nose of plastic is as large as it was bought
    if first.motif not in _FACES:
        return [over]
    if len(first.spots) > 1 and first.motif in SATIN | frozenset(CURVED):
        located = placed(taken.built, taken.piece.positions, taken.piece.upright)
        at = next(where for record, where in zip(located.records, located.where) if record is first)
        size = _mm(own, *extent(at, first.motif, first.width))
    else:
        size = _size(own, _each([first], points)[0])
    if len(alike) == 2 and first.motif not in ("eyes", "claws"):
        apart = [float(np.mean([abs(taken.off(s)[0]) for s in r.spots])) for r in alike]
        many_there = taken.off(first.spots[0])[1]
        where = taken.from_middle(first.spots[0].part, [float(np.mean(apart))], many_there)
        if np.mean(apart) < 0.5 or np.mean(apart) > many_there / 4:
            where = ""  # the two strokes of one thing; or a face that is not in front
        return [own["each"].format(what=size), over, where, _stitched(taken, first)]
    return [size, over, _stitched(taken, first)] if len(alike) == 1 else [over]


def _stitched(taken: Taken, record: Embroidery) -> str:
    """In which stitch a motif is embroidered, where she leaves it open; of a filled one how its threads lie."""
    own, words = taken.own, taken.words(record).lower()
    if record.motif in SATIN:
        lie = own["threads upright" if record.motif in UPRIGHT else "threads level"]
        lie = (
            f"{own['nose tip']}, {lie}"
            if record.motif == "nose" and "triang" not in words and "dreieck" not in words
            else lie
        )
        return lie if _FILLED.search(words) else f"{own['in satin']}, {lie}"
    return own["in backstitch"] if record.motif in CURVED and _STITCH.search(words) is None else ""


def _size(own: Mapping[str, str], points: Array) -> str:
    """How large what goes through points is."""
    across = points[:, None, [0, 2]] - points[:, [0, 2]]
    return _mm(own, float(np.sqrt((across**2).sum(2)).max()), float(np.ptp(points[:, 1])))


def _mm(own: Mapping[str, str], *size: float) -> str:
    wide, high = (max(1, round(v)) for v in size)
    return own["took size" if high > 2 else "took wide"].format(w=wide, h=high)


def _each(alike: list[Embroidery], points: Array) -> list[Array]:
    made, at = [], 0
    for record in alike:
        made.append(points[at : at + len(record.spots)])
        at += len(record.spots)
    return made

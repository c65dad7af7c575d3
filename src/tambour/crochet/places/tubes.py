"""Tubes: pieces worked in rows whose edges the text sews together and stuffs → the stitches that are sewn to each other."""

from __future__ import annotations

import re
from dataclasses import replace
from itertools import pairwise
from typing import Final

import numpy as np

from tambour.core.check import Array
from tambour.crochet.graph.assemble import assemble
from tambour.crochet.graph.built import Built
from tambour.crochet.graph.spots import spots_in
from tambour.crochet.places.names import Made

_SEWN: Final = r"[^.\n]{0,80}\b(?:tog(?:ether)?\b|to form (?:a )?(?:tube|ring|circle)|seam)"
_BY: Final = r"\b(?:sew|seam|join|close|connect|(?:whip|mattress)\s?-?stitch|sl(?:ip)?\s?-?st(?:itch(?:es)?)?s?|sc|single crochet|crochet)\b"
_LAST: Final = r"(?:last row|row \d+|final row)"
_FIRST: Final = r"(?:the )?(?:first|1st|row 1\b|foundation|beginning|starting|initial|chain)"
_ROWS: Final = re.compile(
    rf"{_BY}[^.\n]{{0,60}}\b(?:(?:first|1st) and last rows?|last and (?:first|1st) rows?|{_LAST} (?:to|with|and|onto|on|against) {_FIRST})"
    rf"|\b{_LAST} (?:meets?|touch(?:es)?|lies (?:up)?on|is (?:up)?on|(?:to|with|and|against)) {_FIRST}[^\n]{{0,60}}{_BY}"
)
_GATHERED: Final = re.compile(
    r"\b(?:gather(?:ed)?|cinch|pull(?:ed)? (?:it |the (?:tail|yarn|thread) )?(?:tight|closed|shut|to (?:gather|close))|draw(?:n)? (?:it )?(?:up|closed|together|tight))\b"
)
_BOTH: Final = re.compile(
    r"\b(?:both|each|other|second|opposite|bottom) ends?\b[^.\n]{0,40}|\b(?:bottom|lower) (?:edge|opening)\b"
)
_SIDES: Final = re.compile(
    r"\b(?:sew|seam|join|whip\s?stitch)[^.\n]{0,40}\b(?:side edges|ends of (?:the )?rows|row ends)\b" + _SEWN
)
_SHORT: Final = re.compile(r"\b(?:sew|seam|join|whip\s?stitch)[^.\n]{0,40}\bshort (?:edges?|ends?|sides?)\b" + _SEWN)
_BACK: Final = re.compile(r"\b(?:sew|seam)\s+(?:the\s+)?(?:back|centre back|center back)\s+seam\b")
_FOLDED: Final = re.compile(
    r"\bfold[^.\n]{0,40}\bin half lengthwise\b[^\n]{0,60}\b(?:both thicknesses|along edge|edges)\b"
)
_TUBE: Final = re.compile(r"\b(?:sew|seam)[^.\n]{0,60}\bto form (?:a )?(?:tube|ring|circle)\b")
_FLAT: Final = re.compile(
    r"\b(?:flatten|fold|press|lay)\w*\b[^.\n]{0,60}\b(?:both (?:thicknesses|layers)|flat)\b[^.\n]{0,60}\b(?:across|along) (?:the |its )?(?:top|upper|one) (?:edge|end|opening)\b"
    r"|\b(?:sew|seam|whip\s?stitch)\s+(?:the\s+|its\s+)?(?:top|upper|one) (?:edge|end|opening)\s+(?:closed|shut|flat)\b"
)
"""A tube that is pressed flat at its top and sewn shut there: a hat with two corners."""
_LEAST: Final = 4
"""A piece of fewer rows is no tube."""
_SAME: Final = 0.6
"""A row that has this share of the widest is one of the piece's own, and no gathering of its edge."""


def closed(built: Built) -> Built:
    """``built`` with the seams that close pieces in rows to tubes."""
    pairs = tubes(built)
    if not pairs:
        return built
    sewn = [*((a, b) for a, b in built.sewn.tolist()), *pairs]
    graph, shell = assemble(
        built.hook, list(built.graph.parts), sewn, (built.graph.stitch_width, built.graph.stitch_width)
    )
    return replace(built, graph=graph, shell=shell, sewn=np.array(sewn, np.int32))


def tubes(built: Built) -> list[tuple[int, int]]:
    """Pairs of nodes, the later first, that are sewn together where the text closes a piece in rows to a tube and stuffs it."""
    pattern, spots = built.pattern, spots_in(built)
    text = pattern.text.text.lower()
    starts = sorted(p.span.start for p in pattern.parts)
    found: list[tuple[int, int]] = []
    for part, fact in enumerate(built.parts):
        section = pattern.parts[fact.section]
        end = next((k for k in starts if k > section.span.start), len(text))
        said = text[section.span.start : end]
        # An arm, a leg that is folded is two layers thick, with nothing in it or little; a hat is a tube without any.
        folded = _FOLDED.search(said) is not None
        hollow = folded or _TUBE.search(said) is not None
        if not spots.in_rows[part] or Made(section.name, 1).worn or not (hollow or re.search(r"\bstuff", said)):
            continue
        rows = [spots.stitches(k) for k, r in enumerate(built.rounds) if r.part == part]
        widest = max((len(r) for r in rows), default=0)
        rows = [r for r in rows if len(r) >= max(2, _SAME * widest)]
        if len(rows) < _LEAST:
            continue
        across = folded or _ROWS.search(said) or (_SHORT.search(said) and len(rows) > widest)
        along = _SIDES.search(said) or _BACK.search(said) or _SHORT.search(said) or (hollow and not folded)
        if not (across or along):
            continue
        x = spots.layout[:, 0]
        if across:
            one, other = (r[np.argsort(x[r], kind="stable")] for r in (rows[0], rows[-1]))
            at = np.round(np.linspace(0, len(other) - 1, len(one))).astype(int)
            found += list(zip(other[at].tolist(), one.tolist()))
            found += _gathered(rows, x, said) or _flattened(rows, x, said)
        else:
            found += [(int(r[x[r].argmin()]), int(r[x[r].argmax()])) for r in rows]
    return [(max(a, b), min(a, b)) for a, b in found if a != b]


def _flattened(rows: list[Array], x: Array, said: str) -> list[tuple[int, int]]:
    """Pairs of row ends of a tube's top, which is sewn shut from corner to corner; the edge where its rows begin is the brim."""
    if _FLAT.search(said) is None:
        return []
    last = x[rows[0][0]] > x[rows[0][-1]]
    rim = [int(r[x[r].argmin() if last else x[r].argmax()]) for r in rows]
    return [(rim[k], rim[-1 - k]) for k in range(1, len(rim) // 2)]


def _gathered(rows: list[Array], x: Array, said: str) -> list[tuple[int, int]]:
    """Pairs of row ends that a thread through all of them draws to each other: at one end of a tube, or where it is said of the other
    too, at both."""
    drawn = [sentence for sentence in re.split(r"[.\n]", said) if _GATHERED.search(sentence)]
    ends = (len(drawn) > 0) + any(_BOTH.search(sentence) is not None for sentence in drawn)
    found: list[tuple[int, int]] = []
    for k in range(ends):
        rim = [int(r[x[r].argmin() if k else x[r].argmax()]) for r in rows]
        half = len(rim) // 2
        found += [(rim[i], rim[i + half]) for i in range(half)]
        found += list(pairwise(rim))
    return found

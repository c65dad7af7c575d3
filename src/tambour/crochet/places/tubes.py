"""Tubes: pieces worked in rows whose edges the text sews together and stuffs → the stitches that are sewn to each other."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Final

import numpy as np

from tambour.crochet.graph.assemble import assemble
from tambour.crochet.graph.built import Built
from tambour.crochet.graph.spots import Spots
from tambour.crochet.places.names import Made

_SEWN: Final = r"[^.\n]{0,80}\b(?:tog(?:ether)?\b|to form (?:a )?tube|to form (?:a )?ring|seam)"
_ROWS: Final = re.compile(
    r"\b(?:sew|seam|join|whip\s?stitch)[^.\n]{0,60}\b(?:first and last rows?|last row to (?:the )?first)\b"
)
_SIDES: Final = re.compile(
    r"\b(?:sew|seam|join|whip\s?stitch)[^.\n]{0,40}\b(?:side edges|ends of (?:the )?rows|row ends)\b" + _SEWN
)
_SHORT: Final = re.compile(r"\b(?:sew|seam|join|whip\s?stitch)[^.\n]{0,40}\bshort (?:edges?|ends?|sides?)\b" + _SEWN)
_BACK: Final = re.compile(r"\b(?:sew|seam)\s+(?:the\s+)?(?:back|centre back|center back)\s+seam\b")
_FOLDED: Final = re.compile(
    r"\bfold[^.\n]{0,40}\bin half lengthwise\b[^\n]{0,60}\b(?:both thicknesses|along edge|edges)\b"
)
_TUBE: Final = re.compile(r"\b(?:sew|seam)[^.\n]{0,60}\bto form (?:a )?(?:tube|ring)\b")
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
    pattern, spots = built.pattern, Spots(built)
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
        along = _SIDES.search(said) or _BACK.search(said) or _SHORT.search(said)
        x = spots.layout[:, 0]
        if across:
            one, other = (r[np.argsort(x[r], kind="stable")] for r in (rows[0], rows[-1]))
            at = np.round(np.linspace(0, len(other) - 1, len(one))).astype(int)
            found += list(zip(other[at].tolist(), one.tolist()))
        elif along:
            found += [(int(r[x[r].argmin()]), int(r[x[r].argmax()])) for r in rows]
    return [(max(a, b), min(a, b)) for a, b in found if a != b]

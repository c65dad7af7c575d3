"""Letters as outlines, from the bytes of any TrueType or OpenType font."""

from __future__ import annotations

import io
import itertools
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np

from tambour.core.check import Array
from tambour.core.errors import TambourError

STEPS = 8  # chords per curve of a glyph; the error on a 100 mm letter stays below 0.1 mm


@dataclass(frozen=True, eq=False, slots=True)
class Glyph:
    """One letter's closed rings ((n, 2), y down, em = 1, baseline at 0, first point not repeated) and its advance."""

    rings: tuple[Array, ...]
    advance: float


@lru_cache(maxsize=8)
def _font(data: bytes) -> tuple[Any, Any, Any, float, float]:
    from fontTools.ttLib import TTFont

    try:
        font = TTFont(io.BytesIO(data), fontNumber=0, lazy=True)
        glyphs, cmap, em = font.getGlyphSet(), font.getBestCmap(), float(font["head"].unitsPerEm)
        os2 = font.get("OS/2", None)
        capital = float(getattr(os2, "sCapHeight", 0) or 0) / em
    except Exception as error:  # noqa: BLE001 - fontTools raises many kinds for a broken file
        raise TambourError(f"this is no font that can be used ({type(error).__name__}: {error})") from None
    if not cmap or em <= 0:
        raise TambourError("this font has no letters that can be asked for by their character")
    return font, glyphs, cmap, em, capital if 0.2 < capital < 2 else 0.7


def capital_height(data: bytes) -> float:
    """Height of a capital letter in em."""
    return float(_font(data)[4])


def glyph(data: bytes, letter: str) -> Glyph | None:
    """The outline of one character; None when the font has none for it."""
    _, glyphs, cmap, em, _ = _font(data)
    name = cmap.get(ord(letter))
    if name is None:
        return None
    from fontTools.pens.recordingPen import DecomposingRecordingPen

    try:
        pen = DecomposingRecordingPen(glyphs)
        glyphs[name].draw(pen)
        advance = float(glyphs[name].width) / em
    except Exception as error:  # noqa: BLE001
        raise TambourError(f"the font's glyph for {letter!r} is broken ({type(error).__name__})") from None
    rings: list[Array] = []
    line: list[Array] = []
    for verb, points in pen.value:
        p = [np.array(q, np.float64) for q in points if q is not None]
        if verb == "moveTo":
            line = [p[0]]
        elif verb == "lineTo":
            line.append(p[0])
        elif verb == "curveTo":
            line += _bezier([line[-1], *p])
        elif verb == "qCurveTo":
            if points[-1] is None:  # a ring of control points only
                p.append((p[0] + p[-1]) / 2)
                line = [p[-1]]
            for k in range(len(p) - 1):
                end = p[k + 1] if k == len(p) - 2 else (p[k] + p[k + 1]) / 2
                line += _bezier([line[-1], p[k], end])
        elif verb in ("closePath", "endPath") and len(line) > 2:
            ring = np.array(line) / em * np.array([1.0, -1.0])
            if np.allclose(ring[0], ring[-1]):
                ring = ring[:-1]
            if len(ring) > 2 and np.isfinite(ring).all():
                rings.append(ring)
            line = []
    return Glyph(tuple(rings), advance)


def _bezier(control: list[Array]) -> list[Array]:
    t = (np.arange(1, STEPS + 1) / STEPS)[:, None]
    layer = [c[None, :] for c in control]
    while len(layer) > 1:
        layer = [(1 - t) * a + t * b for a, b in itertools.pairwise(layer)]
    return list(layer[0])


def outlines(
    text: str, data: bytes, size: float, spacing: float = 0.0
) -> tuple[list[tuple[str, list[Array]]], float, str]:
    """A line of text with its kerning: ([(letter, rings in size units, moved to their place)], its width, letters the font lacks)."""
    x = 0.0
    found: list[tuple[str, list[Array]]] = []
    missing = before = ""
    for letter in text:
        drawn = glyph(data, letter)
        if drawn is None:
            missing += letter
            continue
        x += kerned(data, before, letter) * size if before else 0.0
        before = letter
        if drawn.rings:
            found.append((letter, [r * size + np.array([x, 0.0]) for r in drawn.rings]))
        x += drawn.advance * size + spacing
    return found, x, missing


@lru_cache(maxsize=4096)
def kerned(data: bytes, left: str, right: str) -> float:
    """How much farther (in em) the second of two letters stands than their advances say; 0 where the font is silent."""
    font, _, cmap, em, _ = _font(data)
    a, b = cmap.get(ord(left)), cmap.get(ord(right))
    if a is None or b is None:
        return 0.0
    try:
        for pairs in _pairs(data):
            found = _pair(pairs, a, b)
            if found is not None:
                return found / em
        for table in getattr(font.get("kern", None), "kernTables", ()):
            if (a, b) in getattr(table, "kernTable", {}):
                return float(table.kernTable[a, b]) / em
    except Exception as error:  # noqa: BLE001 - fontTools raises many kinds for a broken file
        raise TambourError(f"the font's kerning is broken ({type(error).__name__})") from None
    return 0.0


@lru_cache(maxsize=8)
def _pairs(data: bytes) -> tuple[Any, ...]:
    """The subtables of the font's ``kern`` feature that place pairs of glyphs."""
    font = _font(data)[0]
    table = font["GPOS"].table if "GPOS" in font else None
    if table is None or table.FeatureList is None:
        return ()
    lookups = {k for f in table.FeatureList.FeatureRecord if f.FeatureTag == "kern" for k in f.Feature.LookupListIndex}
    found = []
    for k in sorted(lookups):
        for sub in table.LookupList.Lookup[k].SubTable:
            pairs = sub.ExtSubTable if sub.LookupType == 9 else sub
            if pairs.LookupType == 2:
                found.append(pairs)
    return tuple(found)


def _pair(pairs: Any, a: str, b: str) -> float | None:
    """What one subtable says of two glyphs, in the font's units; None for nothing."""
    if a not in pairs.Coverage.glyphs:
        return None
    if pairs.Format == 1:
        for record in pairs.PairSet[pairs.Coverage.glyphs.index(a)].PairValueRecord:
            if record.SecondGlyph == b:
                return float(getattr(record.Value1, "XAdvance", 0) or 0)
        return None
    record = pairs.Class1Record[pairs.ClassDef1.classDefs.get(a, 0)].Class2Record[pairs.ClassDef2.classDefs.get(b, 0)]
    return float(getattr(record.Value1, "XAdvance", 0) or 0)

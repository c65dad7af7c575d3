"""Style: how a picture becomes stitches, chosen by what it is and how large, and said in one line."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from tambour.core.check import Array
from tambour.core.params import length
from tambour.knit.params import KnitParams
from tambour.knit.picture.tone import Kind, recognise

LARGE = 150  # stitches and rows from which dithered tones show more than areas do
NEAR = {"garment": 2.0, "mitten": 2.0, "child": 2.0, "blanket": 4.0}  # metres one looks from, by use
FEW, FLAT = 8, 0.6  # colours that make up at least this share of flat art
FAR = 8.0  # metres from which dithered tones are tones: nearer the eye sees every stitch


@dataclass(frozen=True, slots=True)
class Style:
    """The choice. ``metres`` is how far the eye is; ``why`` one line for the knitter."""

    name: Literal["graphic", "texture", "tonal", "plain"]
    kind: Kind
    metres: float
    why: str

    @property
    def flat(self) -> bool:
        """Areas of one colour each: nothing to smooth, nothing to sharpen."""
        return self.kind != "photograph"


def recognised(picture: Array, luma: Array) -> Kind:
    """What the picture (R, C, 3) uint8 is, ``luma`` its brightness (R, C).

    Flat art has few colours, each exactly the same wherever it stands; photographs do not.
    """
    if recognise(luma) == "line drawing":
        return "line drawing"
    whole = picture.astype(np.int32) @ np.array([65536, 256, 1])
    count = np.sort(np.unique(whole[:: max(1, len(whole) // 400)], return_counts=True)[1])
    return "flat art" if count[-FEW:].sum() >= FLAT * count.sum() else "photograph"


def chosen(kind: Kind, shape: tuple[int, int], params: KnitParams) -> Style:
    """The style of a picture of ``kind`` and (rows, stitches) under ``params``."""
    near = NEAR[params.use]
    asked = length(params.seen_from) / 1000 if params.seen_from else None
    if params.style != "auto":
        metres = asked or (FAR if params.style == "tonal" else near)
        return Style(params.style, kind, metres, f"{params.style}: as asked")
    if params.method is not None or params.start is not None or of_plain(params):
        return Style(
            "plain", kind, asked or FAR, "plain: solved by the method, start or tone mapping that was asked for"
        )
    if params.tone is not None or params.keep:
        return Style("tonal", kind, asked or FAR, "tonal: tone or keep was asked for")
    rows, stitches = shape
    if kind != "photograph":
        return Style("graphic", kind, asked or near, f"graphic: {kind}, its areas and lines are kept")
    if (asked or 0.0) >= FAR and params.technique != "intarsia":
        return Style("tonal", kind, asked or FAR, f"tonal: from {asked:g} m stitches mix into tones")
    if params.technique == "intarsia":
        return Style("graphic", kind, asked or near, "graphic: intarsia is knitted in areas")
    if min(rows, stitches) >= LARGE and params.floats == "short":
        return Style("tonal", kind, asked or FAR, f"tonal: a photograph, large enough ({stitches} x {rows}) for tones")
    return Style("graphic", kind, asked or near, f"graphic: a photograph of {stitches} stitches reads best as areas")


def suggested(kind: Kind, shape: tuple[int, int], colours: int, params: KnitParams) -> str:
    """Which technique suits the picture and its use, in one line. ``colours``: of flat art, how many it is made of."""
    if params.round or params.use in ("mitten", "child"):
        return "stranded: in the round and for small hands, two yarns in a row and short floats"
    if kind != "photograph" and colours <= 2:
        return "stranded: two colours; with floats caught every line stays as it is"
    if kind == "photograph" and min(shape) >= LARGE:
        return "stranded: large enough for tones; in colours, intarsia"
    what = f"{colours} flat colours" if kind != "photograph" else "a photograph reads best in areas of its own colours"
    if params.machine is not None:
        return f"jacquard: {what}, on a double bed"
    return f"intarsia: {what}, nothing carried behind"


def of_plain(params: KnitParams) -> bool:
    """Whether something was asked for that only the plain style has."""
    return bool(params.detail) or params.threshold != 0.5 or params.patches != "ready"


def settled(params: KnitParams, style: Style) -> KnitParams:
    """``params`` with nothing left open: what the style fills in where nothing was said."""
    areas = style.name in ("graphic", "texture")
    return params.model_copy(
        update={
            "style": style.name,
            "seen_from": params.seen_from or (None if style.name == "plain" else f"{style.metres:g}m"),
            "method": params.method or ("exact" if areas else "perceptual"),
            "tone": params.tone or ("raw" if style.name == "tonal" else "reachable"),
            "light": params.light or ("linear" if style.name == "tonal" else "code"),
        }
    )

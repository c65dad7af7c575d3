"""Drawing → Picture, and Drawing → any skia canvas (the PDF writer's page is one too)."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from dataclasses import replace
from itertools import pairwise
from typing import Any

import numpy as np

from tambour.core.check import Array
from tambour.core.drawing import Drawing, Placed
from tambour.core.errors import TambourError
from tambour.core.paths import Paths
from tambour.core.picture import Picture
from tambour.core.reveal import Reveal, stretch
from tambour.render.packed import HEAD, packed
from tambour.render.type import typeface

_QUALITY = 90
"""Of photographs kept as JPEG, of 100."""

LARGEST = 400_000_000
"""Pixels above which a picture is refused rather than the machine's memory filled."""


def picture(
    drawing: Drawing | Iterable[Drawing], pixels_per_mm: float | None = None, width: int | None = None
) -> Picture:
    """Rasterise a drawing, or a stream of drawings on one sheet (the first one's), one over the other.

    pixels_per_mm : resolution; or
    width : width in pixels; by default the larger of 1600 pixels and 96 dpi, at most 4000 pixels

    Raises TambourError when the picture would hold more than 400 million pixels.
    """
    import skia

    stream = iter([drawing] if isinstance(drawing, Drawing) else drawing)
    drawing = next(stream)
    size = drawing.size * drawing.unit
    if width is not None:
        scale = width / size[0]
    elif pixels_per_mm is not None:
        scale = pixels_per_mm
    else:
        scale = min(max(1600 / max(size), 96 / 25.4), 4000 / max(size))
    w, h = max(1, round(size[0] * scale)), max(1, round(size[1] * scale))
    if w * h > LARGEST:
        raise TambourError(f"a picture of {w} x {h} pixels is too large", hint="ask for a smaller one, or for .svg")
    pixels = np.zeros((h, w, 4), np.uint8)
    surface = skia.Surface.MakeRasterDirect(
        skia.ImageInfo.Make(w, h, skia.kRGBA_8888_ColorType, skia.kPremul_AlphaType), pixels, 4 * w
    )
    canvas = surface.getCanvas()
    canvas.scale(w / drawing.size[0], h / drawing.size[1])
    draw(canvas, drawing)
    for more in stream:
        draw(canvas, replace(more, background=None))
    surface.flushAndSubmit()
    alpha = pixels[..., 3:].astype(np.uint16)
    if alpha.min(initial=255) < 255:
        straight = (pixels[..., :3].astype(np.uint16) * 255 + alpha // 2) // np.maximum(alpha, 1)
        pixels[..., :3] = np.minimum(straight, 255)
    return Picture(pixels, pixel=1 / scale)


def draw(canvas: Any, drawing: Drawing) -> None:
    """Draw onto a skia canvas whose unit is the drawing's; the sheet's top left corner comes to (0, 0)."""
    import skia

    origin = drawing.origin
    drawing = _at_zero(drawing)
    canvas.save()
    sheet = skia.Rect.MakeXYWH(0.0, 0.0, *map(float, drawing.size))
    canvas.clipRect(sheet)
    if drawing.background is not None:
        canvas.drawRect(sheet, skia.Paint(Color=_argb(drawing.background)))
    for placed in drawing.images:
        if not placed.glaze:
            _image(canvas, placed, origin)
    _shapes(canvas, drawing)
    for label in drawing.labels:
        # The font is set at 100 and scaled: tiny sizes in mm would otherwise lose their spacing to rounding.
        font = skia.Font(typeface(label.bold), 100)
        font.setSubpixel(True)
        font.setHinting(skia.FontHinting.kNone)
        shift = {"start": 0.0, "middle": 0.5, "end": 1.0}[label.anchor] * font.measureText(label.text)
        canvas.save()
        canvas.translate(label.x, label.y)
        canvas.rotate(-math.degrees(label.angle))
        canvas.scale(label.size / 100, label.size / 100)
        canvas.drawString(label.text, -shift, 0, font, skia.Paint(Color=_argb(label.color), AntiAlias=True))
        canvas.restore()
    for placed in drawing.images:
        if placed.glaze:
            _image(canvas, placed, origin)
    canvas.restore()


def _at_zero(drawing: Drawing) -> Drawing:
    """The same drawing with its sheet's corner at (0, 0): skia counts in single precision, and a scroll goes far."""
    if not drawing.origin.any():
        return drawing
    x, y = drawing.origin.tolist()
    paths = drawing.paths
    return replace(
        drawing,
        paths=Paths(paths.coords - drawing.origin, paths.offsets, paths.parts),
        labels=tuple(replace(label, x=label.x - x, y=label.y - y) for label in drawing.labels),
        images=tuple(replace(placed, x=placed.x - x, y=placed.y - y) for placed in drawing.images),
        origin=np.zeros(2),
    )


def _image(canvas: Any, placed: Placed, origin: Array) -> None:
    """A picture; copies of one stand on a grid through the drawing's own (0, 0), which lies ``origin`` before ours."""
    import skia

    rgba = np.ascontiguousarray(placed.picture.rgba)
    image = skia.Image.fromarray(rgba, skia.kRGBA_8888_ColorType, skia.kUnpremul_AlphaType)
    where = skia.Rect.MakeXYWH(placed.x, placed.y, placed.width, placed.height)
    linear = skia.SamplingOptions(skia.FilterMode.kLinear)
    if placed.photo and not placed.glaze and rgba[..., 3].min(initial=255) == 255:
        # A page of a PDF takes the file as it is: a tenth of the bytes.
        image = skia.Image.MakeFromEncoded(image.encodeToData(skia.kJPEG, _QUALITY)) or image
    if placed.repeat is None:
        canvas.drawImageRect(image, where, linear)
        return
    width, height = placed.repeat
    scale = skia.Matrix.Translate(-float(origin[0]) % width, -float(origin[1]) % height)
    scale.preScale(width / image.width(), height / image.height())
    shader = image.makeShader(skia.TileMode.kRepeat, skia.TileMode.kRepeat, linear, scale)
    canvas.drawRect(where, skia.Paint(Shader=shader))


def _shapes(canvas: Any, drawing: Drawing) -> None:
    import skia

    styles, paths = drawing.styles, drawing.paths
    fills = [
        skia.Paint(Color=_argb(f), AntiAlias=True, Style=skia.Paint.kFill_Style) if f[3] else None
        for f in styles.fill.tolist()
    ]
    caps = (skia.Paint.kRound_Cap, skia.Paint.kButt_Cap, skia.Paint.kSquare_Cap)  # as CAPS and JOINS
    joins = (skia.Paint.kRound_Join, skia.Paint.kMiter_Join, skia.Paint.kBevel_Join)
    ends = (styles.cap, styles.join, styles.miter)
    strokes = [
        skia.Paint(
            Color=_argb(s),
            AntiAlias=True,
            Style=skia.Paint.kStroke_Style,
            StrokeWidth=w,
            StrokeJoin=joins[join],
            StrokeCap=caps[cap],
            StrokeMiter=miter,
        )
        if s[3] and w > 0
        else None
        for s, w, cap, join, miter in zip(*(a.tolist() for a in (styles.stroke, styles.width, *ends)))
    ]
    parts = np.arange(len(paths.offsets)) if paths.parts is None else paths.parts
    data, begins = packed(paths.coords, paths.offsets, parts, styles.evenodd[drawing.style])
    view, path = memoryview(data.data), skia.Path()
    bounds = begins.tolist()
    for first, last, style in zip(bounds, bounds[1:], drawing.style.tolist()):
        if last - first == HEAD:
            continue
        if not path.readFromMemory(view[first:last]):
            raise ValueError("this version of skia keeps its paths in another form: see tambour.render.packed")
        if fills[style]:
            canvas.drawPath(path, fills[style])
        if strokes[style]:
            canvas.drawPath(path, strokes[style])


def _argb(rgba: Any) -> int:
    import skia

    return int(skia.Color(*(int(c) for c in rgba)))


def frames(value: Reveal, width: int) -> Iterator[Picture]:
    """The pictures of a drawing being drawn, ``width`` pixels wide: one per step; each stroke is painted once."""
    import skia

    drawing = value.drawing
    nothing = stretch(drawing, 0, 0)
    ground = replace(nothing, background=drawing.background, images=tuple(i for i in drawing.images if not i.glaze))
    over = replace(nothing, images=tuple(i for i in drawing.images if i.glaze))
    scale = width / drawing.size[0]
    height = max(1, round(drawing.size[1] * scale))

    def onto(pixels: Array) -> Any:
        info = skia.ImageInfo.Make(width, height, skia.kRGBA_8888_ColorType, skia.kPremul_AlphaType)
        surface = skia.Surface.MakeRasterDirect(info, pixels, 4 * width)
        surface.getCanvas().scale(scale, height / drawing.size[1])
        return surface

    sheet = np.zeros((height, width, 4), np.uint8)
    held = onto(sheet)
    draw(held.getCanvas(), ground)
    cuts = value.shares().tolist()
    for k, (first, last) in enumerate(pairwise(cuts), 1):
        draw(held.getCanvas(), stretch(drawing, first, last))
        held.flushAndSubmit()
        shown = sheet.copy()
        top = onto(shown)
        draw(top.getCanvas(), replace(over, labels=drawing.labels if k == len(cuts) - 1 else ()))
        top.flushAndSubmit()
        yield Picture(shown, pixel=drawing.unit / scale)

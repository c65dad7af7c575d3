"""Thumbs: a small picture of a piece, for a shelf or a contact sheet."""

from __future__ import annotations

import io
from typing import Any

SIDE = 320
"""Pixels of its longer side, usually."""
PLAIN, FAR = 32, 125
"""A chart of so few stitches is shown as cloth; of larger ones, what is finer than the FARth part is blurred."""


def thumb(craft: str, piece: Any, side: int = SIDE) -> bytes:
    """A small picture of a piece, as WebP."""
    from PIL import Image

    rgba = {"crochet": _crochet, "knit": _knit, "ink": _ink, "embroidery": _embroidery}[craft](piece)
    return _small(Image.fromarray(rgba), side)


def shrunk(raw: bytes, side: int = SIDE) -> bytes:
    """A picture's file, as :func:`thumb` would give it."""
    from PIL import Image

    picture = Image.open(io.BytesIO(raw))
    picture.draft("RGB", (2 * side, 2 * side))  # a JPEG is decoded no finer than is needed
    return _small(picture.convert("RGBA"), side)


def _small(picture: Any, side: int) -> bytes:
    from PIL import Image

    # Whole pixels are averaged first: a tenth of the time, and no difference that one sees.
    picture.thumbnail((side, side), Image.Resampling.LANCZOS, reducing_gap=2.0)
    raw = io.BytesIO()
    picture.save(raw, "WEBP", quality=80, method=4)
    return raw.getvalue()


def _crochet(piece: Any) -> Any:
    from tambour.crochet.page.portrait import portrait

    return portrait(piece, "front", width=SIDE, height=SIDE).rgba


def _knit(piece: Any) -> Any:
    """As it is seen from afar: at this size single stitches would be noise. A small chart as its cloth."""
    import numpy as np
    from PIL import Image, ImageFilter

    from tambour.color import coded, linear
    from tambour.knit.views import fabric

    rows, columns = piece.chart.shape
    if max(rows, columns) <= PLAIN:
        return fabric(piece).rgba
    light = linear(piece.chart.palette.rgb / 255.0)[piece.chart.cells[::-1]]
    tall = 1.0 if piece.chart.gauge is None else piece.chart.gauge.height / piece.chart.gauge.width
    scale = 2 * SIDE / max(columns, rows * tall)
    size = max(1, round(columns * scale)), max(1, round(rows * tall * scale))
    afar = ImageFilter.GaussianBlur(scale * max(columns, rows) / FAR)
    seen = [Image.fromarray(np.uint8(np.round(255 * np.sqrt(light[..., c])))) for c in range(3)]
    soft = [np.asarray(p.resize(size, Image.Resampling.BOX).filter(afar), float) / 255 for p in seen]
    rgb = coded(np.stack(soft, -1) ** 2)
    return np.uint8(np.round(255 * np.concatenate([rgb, np.ones((*rgb.shape[:2], 1))], -1)))


def _ink(piece: Any) -> Any:
    from tambour.ink.views import whole
    from tambour.render import flat

    made = whole(piece)
    return flat.picture(made[0] if isinstance(made, (list, tuple)) else made, width=2 * SIDE).rgba


def _embroidery(piece: Any) -> Any:
    from tambour.embroidery.looks.scene import preview

    return preview(piece).rgba

"""Thumbs: a small picture of a piece, for the shelf."""

from __future__ import annotations

import io
from typing import Any

SIDE = 320
"""Pixels of its longer side."""


def thumb(craft: str, piece: Any) -> bytes:
    """A small picture of a piece, as WebP."""
    from PIL import Image

    rgba = {"crochet": _crochet, "knit": _knit, "ink": _ink, "embroidery": _embroidery}[craft](piece)
    picture = Image.fromarray(rgba)
    picture.thumbnail((SIDE, SIDE), Image.Resampling.LANCZOS)
    raw = io.BytesIO()
    picture.save(raw, "WEBP", quality=80, method=4)
    return raw.getvalue()


def _crochet(piece: Any) -> Any:
    from tambour.crochet.page.portrait import portrait

    return portrait(piece, "front", width=SIDE, height=SIDE).rgba


def _knit(piece: Any) -> Any:
    from tambour.knit.views import fabric

    return fabric(piece).rgba


def _ink(piece: Any) -> Any:
    from tambour.ink.views import whole
    from tambour.render import flat

    made = whole(piece)
    return flat.picture(made[0] if isinstance(made, (list, tuple)) else made, width=2 * SIDE).rgba


def _embroidery(piece: Any) -> Any:
    from tambour.embroidery.looks.scene import preview

    return preview(piece).rgba

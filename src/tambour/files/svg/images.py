"""Images: pictures inside an SVG, decoded and put in their place below its shapes."""

from __future__ import annotations

import base64
import binascii
import io
import re
import urllib.parse
from collections.abc import Callable
from typing import Any

import numpy as np

from tambour.core.drawing import Placed
from tambour.core.picture import Picture
from tambour.files.svg.looks import Look
from tambour.files.svg.path import after, fitted
from tambour.files.svg.tree import Node

LARGEST = 50_000_000
"""Pixels of a picture inside an SVG."""


def placed(node: Node, look: Look, size: Any, leave: Callable[[str], None]) -> Placed | None:
    """The picture of an ``<image>`` in mm; None, and ``leave`` told, where it lies outside the file, is none, or is turned."""
    a = node.attributes
    href = a.get("href", a.get("xlink:href", "")).strip()
    found = re.match(r"data:(image/(?:png|jpe?g|gif|webp|bmp))?\s*(?:;[^,;]*)*?(;base64)?,", href, re.I)
    if not found:
        leave("image" if href.startswith("data:") else "an image outside the file")
        return None
    try:
        body = href[found.end() :]
        data = base64.b64decode(body) if found[2] else urllib.parse.unquote_to_bytes(body)
        picture = _decoded(data)
    except (OSError, ValueError, SyntaxError, binascii.Error):
        leave("an image that cannot be read")
        return None
    high, wide = picture.rgba.shape[:2]
    x, y = size("x"), size("y", "0", look.view[1])
    w = size("width", f"{wide}") if a.get("width", "auto") != "auto" else 0.0
    h = size("height", f"{high}", look.view[1]) if a.get("height", "auto") != "auto" else 0.0
    w, h = w or (h * wide / high if h else wide), h or (w * high / wide if w else high)
    if min(w, h) <= 0:
        return None
    aspect = a.get("preserveAspectRatio", "")
    matrix = after(look.matrix, fitted([0, 0, wide, high], x, y, w, h, aspect))
    turned = abs(matrix[0, 1]) + abs(matrix[1, 0]) > 1e-6 * abs(matrix[0, 0]) or matrix[0, 0] <= 0 or matrix[1, 1] <= 0
    if turned or look.window is not None or "slice" in aspect:
        leave("an image that is turned, skewed or cut")
        return None
    rgba = picture.rgba
    if look.shown < 1:
        rgba = rgba.copy()
        rgba[..., 3] = np.round(rgba[..., 3] * look.shown)
    px, py = float(matrix[0, 0]), float(matrix[1, 1])
    return Placed(Picture(rgba, pixel=px), float(matrix[0, 2]), float(matrix[1, 2]), px * wide, py * high)


def _decoded(data: bytes) -> Picture:
    from PIL import Image, ImageOps

    with Image.open(io.BytesIO(data)) as image:
        if image.width * image.height > LARGEST:
            raise ValueError("too large")
        return Picture(np.array(ImageOps.exif_transpose(image).convert("RGBA")))

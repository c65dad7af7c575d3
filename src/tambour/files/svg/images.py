"""Images: pictures inside an SVG, decoded and put in their place below its shapes."""

from __future__ import annotations

import base64
import binascii
import io
import re
import urllib.parse
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np

from tambour.core.check import Array
from tambour.core.drawing import Placed
from tambour.core.picture import Picture
from tambour.files.svg.looks import Look
from tambour.files.svg.path import after, fitted
from tambour.files.svg.tree import Node

GRID = 1000
"""Cells a side in which what shows of a picture is found."""
LIGHT = np.array([0.2125, 0.7154, 0.0721])
"""What the colours weigh in a mask."""
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
    if turned or "slice" in aspect:
        leave("an image that is turned or skewed")
        return None
    px, py = float(matrix[0, 0]), float(matrix[1, 1])
    whole = Placed(Picture(picture.rgba, pixel=px), float(matrix[0, 2]), float(matrix[1, 2]), px * wide, py * high)
    if look.shown == 1 and look.window is None and not look.veils:
        return whole
    rgba = picture.rgba.copy()
    rgba[..., 3] = np.round(rgba[..., 3] * look.shown * _seen(whole, look))
    return replace(whole, picture=Picture(rgba, pixel=px)) if rgba[..., 3].any() else None


def _seen(whole: Placed, look: Look) -> Array:
    """How much of each pixel of a picture shows through its clips and masks: (rows, columns), 0 … 1."""
    import shapely

    rows, columns = whole.picture.rgba.shape[:2]
    # A grid of a thousand cells a side is finer than thread.
    n, m = min(rows, GRID), min(columns, GRID)
    x = whole.x + whole.width * (np.arange(m) + 0.5) / m
    y = whole.y + whole.height * (np.arange(n) + 0.5) / n
    share = np.ones((n, m))
    if look.window is not None:
        share[:] = 0
        for area, part in look.window:
            shapely.prepare(area)
            share = np.maximum(share, part * shapely.contains_xy(area, *np.meshgrid(x, y)))
    for veil in look.veils:
        rgba = veil.picture.rgba / 255
        j = np.floor((x - veil.x) / veil.width * rgba.shape[1]).astype(int)
        i = np.floor((y - veil.y) / veil.height * rgba.shape[0]).astype(int)
        light = (rgba[..., :3] @ LIGHT) * rgba[..., 3]
        lit = light[np.clip(i, 0, len(light) - 1)[:, None], np.clip(j, 0, light.shape[1] - 1)]
        inside = ((i >= 0) & (i < len(light)))[:, None] & ((j >= 0) & (j < light.shape[1]))
        share = share * np.where(inside, lit, 0.0)
    return np.asarray(share[(np.arange(rows) * n // rows)[:, None], np.arange(columns) * m // columns])


def _decoded(data: bytes) -> Picture:
    from PIL import Image, ImageOps

    with Image.open(io.BytesIO(data)) as image:
        if image.width * image.height > LARGEST:
            raise ValueError("too large")
        return Picture(np.array(ImageOps.exif_transpose(image).convert("RGBA")))

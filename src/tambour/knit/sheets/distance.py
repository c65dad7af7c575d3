"""From a distance: what was aimed at and what was knitted, side by side, blurred alike."""

from __future__ import annotations

import numpy as np

from tambour.color import coded, linear
from tambour.core.chart import Chart
from tambour.core.check import Array
from tambour.core.drawing import Drawing
from tambour.core.picture import Picture
from tambour.knit.sheets.fabric import aspect_of
from tambour.render.page import GREY, Page

SIGMAS = (1.5, 3.0)
"""Blur in stitches: near and far."""
ARC_MINUTE = np.pi / 180 / 60
"""Spread of the eye's own blur, by which a blur in stitches becomes a distance."""
_PANEL = 80.0
_PIXELS = 900
_FINE = 1500


def distance(chart: Chart, picture: Array, tone: Array, light: bool = False) -> Drawing:
    """Two rows, nearer and farther; in each the source, the tone aimed at in yarn colours (two yarns), the knitting.

    picture : (R, C, 3) uint8 source at chart size; tone : (R, C) in 0…1, 0 the dark yarn; both row 0 at the cast-on
    light : blur linear light instead of code values
    """
    rows, width = chart.shape
    table = np.arange(256) / 255.0
    table = (linear(table) if light else table).astype(np.float32)
    k = max(1, min(rows, width) // _FINE)  # far more stitches than pixels: their means will do
    panels = [("source", _means(table[picture], k))]
    if len(chart.palette) == 2:
        dark, pale = table[chart.palette.rgb[np.argsort(chart.palette.rgb.sum(axis=1), kind="stable")]]
        aim = _means(np.asarray(tone, np.float32)[..., None], k)
        panels.append(("aimed at", dark + (pale - dark) * aim))
    panels.append(("knitted", _means(table[chart.palette.rgb][chart.cells], k)))

    tall = _PANEL * rows / width / aspect_of(chart)
    scale = min(1.0, 120.0 / tall)
    w, h = _PANEL * scale, tall * scale
    sheet = Page(10 + len(panels) * (w + 5) + 5, 14 + len(SIGMAS) * (h + 12) + 2)
    for j, sigma in enumerate(SIGMAS):
        y = 12 + j * (h + 12)
        sheet.text(_seen(chart, sigma), 10, y + h + 4.6, 3.2, color=GREY)
        for i, (name, value) in enumerate(panels):
            x = 10 + i * (w + 5)
            sheet.image(Picture(_blurred(value, sigma / k, light, aspect_of(chart))), x, y, w, h)
            sheet.boxes([(x, y, x + w, y + h)], None, GREY, 0.12)
            if j == 0:
                sheet.text(name, x, 8.5, 4.0, bold=True)
    return sheet.drawing(title="From a distance")


def _seen(chart: Chart, sigma: float) -> str:
    """What the blur means."""
    if chart.gauge is None:
        return f"blurred by {sigma:g} stitches"
    away = sigma * chart.gauge.width / 1000 / ARC_MINUTE
    return f"blurred by {sigma:g} stitches: seen from about {away:.0f} m"


def _means(value: Array, k: int) -> Array:
    """Means over blocks of k x k stitches."""
    if k == 1:
        return value
    rows, width = value.shape[0] // k * k, value.shape[1] // k * k
    return value[:rows, :width].reshape(rows // k, k, width // k, k, -1).mean(axis=(1, 3))


def _blurred(value: Array, sigma: float, light: bool, aspect: float) -> Array:
    """Pixels (H, W, 4) of a chart-sized picture after blur, enlarged smoothly to its true shape."""
    from PIL import Image
    from scipy.ndimage import gaussian_filter

    value = gaussian_filter(value, (sigma * aspect, sigma, 0), mode="mirror")
    value = coded(value) if light else value
    image = Image.fromarray(np.round(np.clip(value[::-1], 0, 1) * 255).astype(np.uint8))
    rows, width = value.shape[:2]
    size = (_PIXELS, max(1, round(_PIXELS * rows / width / aspect)))
    return np.asarray(image.resize(size, Image.Resampling.BICUBIC).convert("RGBA"))

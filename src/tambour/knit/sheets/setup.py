"""Setup: the card to print and lay beside a knitting machine."""

from __future__ import annotations

import numpy as np

from tambour.core.chart import Chart
from tambour.core.drawing import Drawing
from tambour.core.picture import Picture
from tambour.knit.machines.limits import MODELS, steps
from tambour.render.page import GREY, Page


def card(chart: Chart, name: str, anchored: bool, title: str, limit: int = 0) -> Drawing:
    """A card (A5) for the machine: the steps, the chart as it will look and as it hangs before you."""
    sheet = Page(148.0, 210.0)
    rows, width = chart.shape
    sheet.text(title, 10, 16, 6.0, bold=True)
    sheet.text(MODELS[name].title, 10, 23, 4.0, color=GREY)
    y = sheet.paragraph(steps(chart, name, anchored, limit), 10, 33, 2.9, leading=1.6)
    aspect = chart.gauge.width / chart.gauge.height if chart.gauge else 1.0
    room = (60.0, 200.0 - y - 12)
    cell = min(room[0] / width, room[1] / rows * aspect)
    w, h = width * cell, rows * cell / aspect
    rgba = np.full((rows, width, 4), 255, np.uint8)
    rgba[..., :3] = chart.palette.rgb[chart.cells[::-1]]
    k = max(1, round(600 / max(rows, width)))  # viewers smooth small pictures
    rgba = rgba.repeat(k, axis=0).repeat(k, axis=1)
    for x, view, words in ((10.0, rgba, "the right side"), (78.0, rgba[:, ::-1], "as it hangs before you")):
        sheet.image(Picture(np.ascontiguousarray(view)), x, y + 4, w, h)
        sheet.boxes([(x, y + 4, x + w, y + 4 + h)], None, GREY, 0.2)
        sheet.text(words, x, y + 8.5 + h, 2.9, color=GREY)
    return sheet.drawing(title=f"{title}, {MODELS[name].title}")

"""A swatch worth knitting: the most typical part of the chart, and the one with the worst floats."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tambour.core.chart import Chart
from tambour.core.check import Array
from tambour.knit.hands.working import floats, roles
from tambour.knit.hands.yarn import gauge_of
from tambour.knit.sheets.draw import Look, Window, grid
from tambour.render.page import Page

STITCHES, ROWS = 28, 34


class Swatch(NamedTuple):
    """Two windows of a chart of equal size."""

    typical: Window
    worst: Window


def swatch(chart: Chart, anchored: bool = True, stitches: int = STITCHES, rows: int = ROWS) -> Swatch:
    """The window whose share of colours and lengths of floats are nearest the whole chart's, and the one whose
    floats are longest (by the mean square of the float behind each stitch)."""
    high, wide = min(rows, chart.shape[0]), min(stitches, chart.shape[1])
    behind = _behind(chart, anchored)
    main = next(iter(roles(chart)), 0)
    kept = np.ones(chart.shape) if chart.no_stitch is None else (~chart.no_stitch).astype(np.float64)
    maps = [(chart.cells == main) * kept, behind, behind**2]
    means = [_windows(m, high, wide) / (high * wide) for m in maps]
    total = max(1.0, kept.sum())
    far = np.zeros_like(means[0])
    for m, mean in zip(maps, means):
        whole = m.sum() / total
        far += ((mean - whole) / max(abs(whole), 1e-9)) ** 2
    empty = _windows(1 - kept, high, wide) > 0
    if empty.all():
        empty[:] = False
    typical = np.unravel_index(np.argmin(np.where(empty, np.inf, far)), far.shape)
    worst = np.unravel_index(np.argmax(np.where(empty, -1, means[2])), far.shape)
    made = [Window(int(r), int(r) + high, int(c), int(c) + wide) for r, c in (typical, worst)]
    return Swatch(made[0], made[1])


def _behind(chart: Chart, anchored: bool) -> Array:
    """Length of the float behind every stitch (R, C), 0 where there is none."""
    rows, width = chart.shape
    found = floats(chart, anchored)
    step = np.zeros((rows, 2 * width + 1))
    stop = found.start + found.length
    np.add.at(step, (found.row, found.start), found.length)
    np.add.at(step, (found.row, stop), -found.length)
    lengths = step.cumsum(axis=1)
    return lengths[:, :width] + lengths[:, width : 2 * width]


def _windows(m: Array, high: int, wide: int) -> Array:
    """Sums (R - high + 1, C - wide + 1) over all windows."""
    s = np.pad(np.asarray(m, np.float64).cumsum(axis=0).cumsum(axis=1), ((1, 0), (1, 0)))
    return s[high:, wide:] - s[:-high, wide:] - s[high:, :-wide] + s[:-high, :-wide]


def cut(chart: Chart, window: Window) -> Chart:
    """The part of a chart in a window, as a flat chart of its own."""
    pick = (slice(window.bottom, window.top), slice(window.left, window.right))
    absent = None if chart.no_stitch is None else chart.no_stitch[pick]
    return Chart(chart.cells[pick], chart.palette, no_stitch=absent, gauge=chart.gauge, technique=chart.technique)


def page(chart: Chart, look: Look, title: str, weight: str, size: tuple[float, float]) -> Page:
    """One page: both windows as small charts, and beside them the card to fill in when they are knitted."""
    sheet = Page(*size)
    gauge = gauge_of(chart, weight)
    aspect = gauge.width / gauge.height if chart.gauge else 1.0
    found = swatch(chart, look.anchored)
    high, wide = found.typical.top - found.typical.bottom, found.typical.right - found.typical.left
    sheet.text(f"{title}: swatch", 12, 20, 6.0, bold=True)
    w = min((size[0] - 24) * 0.56 / wide, (size[1] - 80) / 2 / high * aspect)
    step = high * w / aspect + 20
    for k, (window, words) in enumerate(((found.typical, "typical"), (found.worst, "longest floats"))):
        y = 38 + k * step
        where = f"stitches {chart.shape[1] - window.right + 1}–{chart.shape[1] - window.left} of the chart"
        sheet.text(f"{words}: {where}, rows {window.bottom + 1}–{window.top}", 18, y - 3, 2.9, bold=True)
        plain = look._replace(cell=(w, w / aspect), repeat=None)
        grid(sheet, cut(chart, window), Window(0, high, 0, wide), 18, y, plain)
    lines = [
        "Knit one or both: the upper is like most of",
        "the piece, the lower has its longest floats.",
        "",
        f"1  Cast on {wide} stitches and two more at each",
        "    side; knit the chart, the extra stitches in",
        "    both yarns in turn.",
        "2  Wash and dry it as you will the piece. Lay",
        "    it flat, without stretching.",
        "3  Measure the middle 20 stitches and rows:",
        "",
        "    20 stitches = ___________ mm",
        "",
        "    20 rows = ___________ mm",
        "",
        "4  Gauge in 10 cm is 2000 / mm:",
        "",
        "    _________ stitches × _________ rows",
        "",
        "5  Solve the piece again with",
        "    --gauge STITCHESxROWS",
        f"    (it was solved for {gauge.stitches:g}x{gauge.rows:g}" + (")" if chart.gauge else ","),
        *([] if chart.gauge else ["    the usual one, as none was given)"]),
        "6  Do the floats lie flat? If the cloth puckers,",
        "    strand more loosely, or ask for a shorter",
        "    --max-float.",
    ]
    x = max(18 + wide * w + 14, size[0] - 76)
    sheet.text("Card", x, 38, 4.4, bold=True)
    sheet.paragraph(lines, x, 45, 3.0, leading=1.6)
    return sheet

"""The chart as knitters draw it: gauge-true cells, numbers on the working side, heavy tens, signs for every colour."""

from __future__ import annotations

from dataclasses import replace
from typing import Literal, NamedTuple

import numpy as np

from tambour.color import luminance
from tambour.core.chart import Chart
from tambour.core.check import Array
from tambour.core.drawing import Drawing
from tambour.core.errors import TambourError
from tambour.core.palette import Palette
from tambour.knit.hands.working import catches, floats, roles, wrong_side
from tambour.knit.hands.written import color_name
from tambour.render.page import GREY, INK, Color, Page

Cells = Literal["both", "colour", "symbol"]
LARGEST = 1_000_000
"""Stitches above which a chart is not drawn."""
RED: Color = (200, 30, 40)
PALE: Color = (226, 226, 230)


class Look(NamedTuple):
    """How a chart is drawn.

    cells : colours, signs, or both; cell : width and height of a stitch in mm; limit : the longest float that is left
    free (catches of longer ones are marked; None marks none); anchored : both yarns go to both sides; repeat :
    stitches of the repeat to frame; dominant : the colour held below
    """

    cells: Cells = "both"
    cell: tuple[float, float] = (4.0, 4.0)
    limit: int | None = None
    anchored: bool = True
    repeat: int | None = None
    dominant: int | None = None


class Window(NamedTuple):
    """Part of a chart: rows ``bottom`` to ``top`` - 1, columns ``left`` to ``right`` - 1."""

    bottom: int
    top: int
    left: int
    right: int


def _shape(name: str) -> list[list[tuple[float, float]]]:
    """A sign's rings in the unit square round (0, 0)."""
    a = np.arange(16) * (np.pi / 8)
    dot = [(0.25 * float(np.cos(t)), 0.25 * float(np.sin(t))) for t in a]
    return {
        "dot": [dot],
        "diamond": [[(0, -0.34), (0.34, 0), (0, 0.34), (-0.34, 0)]],
        "cross": [
            [(-0.34, -0.25), (-0.25, -0.34), (0.34, 0.25), (0.25, 0.34)],
            [(0.34, -0.25), (0.25, -0.34), (-0.34, 0.25), (-0.25, 0.34)],
        ],
        "bar": [[(-0.09, -0.34), (0.09, -0.34), (0.09, 0.34), (-0.09, 0.34)]],
        "triangle": [[(0, -0.32), (0.34, 0.28), (-0.34, 0.28)]],
        "dash": [[(-0.34, -0.09), (0.34, -0.09), (0.34, 0.09), (-0.34, 0.09)]],
        "slash": [[(0.22, -0.34), (0.34, -0.22), (-0.22, 0.34), (-0.34, 0.22)]],
        "square": [[(-0.27, -0.27), (0.27, -0.27), (0.27, 0.27), (-0.27, 0.27)]],
    }[name]


SIGNS = ("", "dot", "cross", "diamond", "bar", "triangle", "slash", "dash", "square")
"""The main colour is left blank, the others take these in order of use (and begin again after eight)."""


def sign(chart: Chart, color: int) -> str:
    """The sign of a colour."""
    place = list(roles(chart)).index(color)
    return SIGNS[place] if place < len(SIGNS) else SIGNS[1 + (place - 1) % (len(SIGNS) - 1)]


def _rgb(chart: Chart, color: int) -> Color:
    r, g, b = chart.palette.rgb[color].tolist()
    return r, g, b


def _shown(chart: Chart, color: int) -> Color:
    """A colour as the chart shows it: a little paler, so that lines and signs are seen on black, and ink is spared."""
    r, g, b = (255 - round((255 - v) * 0.86) for v in _rgb(chart, color))
    return r, g, b


def _against(chart: Chart, color: int, look: Look) -> Color:
    """Ink that reads on a colour."""
    if look.cells == "symbol":
        return INK
    return (255, 255, 255) if float(luminance(chart.palette.rgb[color])) < 0.25 else INK


def grid(sheet: Page, chart: Chart, window: Window, x: float, y: float, look: Look) -> None:
    """Draw part of a chart with its numbers; ``x, y`` is the top left corner of its cells."""
    w, h = look.cell
    _rows, width = chart.shape
    b, t, left, right = window
    cells = chart.cells[b:t, left:right]
    absent = np.zeros(cells.shape, np.bool_) if chart.no_stitch is None else chart.no_stitch[b:t, left:right]
    high, wide = cells.shape
    x1, y1 = x + wide * w, y + high * h

    if look.cells != "symbol":
        for color in roles(chart):
            sheet.boxes(_run_boxes((cells == color) & ~absent, x, y, w, h), _shown(chart, color))
    rule: Color = (160, 160, 164)
    at = np.arange(wide + 1)
    column = width - left - at  # stitches that lie right of each vertical line
    up = np.arange(high + 1)
    row = b + high - up  # rows that lie below each horizontal line

    def across(pick: Array) -> Array:
        return np.stack([np.full(pick.sum(), x), y + up[pick] * h, np.full(pick.sum(), x1), y + up[pick] * h], axis=1)

    def down(pick: Array) -> Array:
        return np.stack([x + at[pick] * w, np.full(pick.sum(), y), x + at[pick] * w, np.full(pick.sum(), y1)], axis=1)

    thin = max(0.06, 0.02 * w)
    sheet.segments(np.concatenate([across(row % 5 > 0), down(column % 5 > 0)]), rule, thin)
    for color in roles(chart):
        name = sign(chart, color)
        if name and look.cells != "colour":
            r, c = np.nonzero((cells == color) & ~absent)
            centre = np.stack([x + (c + 0.5) * w, y + (high - r - 0.5) * h], axis=1)
            size = 0.9 * min(w, h)
            for ring in _shape(name):
                sheet.rings(centre[:, None] + np.array(ring) * size, _against(chart, color, look))
    sheet.segments(np.concatenate([across(row % 10 == 5), down(column % 10 == 5)]), GREY, 2 * thin)
    heavy = min(0.45, max(0.3, 0.09 * w))
    tens = np.concatenate([across(row % 10 == 0), down(column % 10 == 0)])
    sheet.segments(tens, (255, 255, 255), 1.9 * heavy)  # a light halo: the line shows on dark yarn too
    sheet.segments(tens, INK, heavy)
    if absent.any():
        sheet.boxes(_run_boxes(absent, x, y, w, h), PALE)
        sheet.segments(_outline(absent, x, y, w, h), INK, heavy)
    sheet.boxes([(x, y, x1, y1)], None, INK, heavy)
    if look.limit is not None:
        _catch_marks(sheet, chart, window, x, y, look)
    if look.repeat and 1 < look.repeat < width:
        _frame_repeat(sheet, chart, window, x, y, look, 2 * heavy)
    _numbers(sheet, chart, window, x, y, look)


def _frame_repeat(sheet: Page, chart: Chart, window: Window, x: float, y: float, look: Look, thick: float) -> None:
    """The sides of the repeat, counted from the right, that lie in the window."""
    w, h = look.cell
    rows, width = chart.shape
    b, t, left, right = window
    first, last = max(left, width - (look.repeat or 0)), right
    if first >= last:
        return
    x0, x1, y1 = x + (first - left) * w, x + (last - left) * w, y + (t - b) * h
    sides = [
        (first == width - (look.repeat or 0), (x0, y, x0, y1)),
        (right == width, (x1, y, x1, y1)),
        (t == rows, (x0, y, x1, y)),
        (b == 0, (x0, y1, x1, y1)),
    ]
    sheet.segments([line for seen, line in sides if seen], RED, thick)


def _run_boxes(mask: Array, x: float, y: float, w: float, h: float) -> Array:
    """Rectangles (N, 4) over the horizontal runs of a mask whose row 0 is the lowest."""
    high, _wide = mask.shape
    edge = np.diff(np.pad(mask, ((0, 0), (1, 1))).astype(np.int8), axis=1)
    row, start = np.nonzero(edge == 1)
    _, stop = np.nonzero(edge == -1)
    return np.stack([x + start * w, y + (high - 1 - row) * h, x + stop * w, y + (high - row) * h], axis=1)


def _outline(mask: Array, x: float, y: float, w: float, h: float) -> Array:
    """Segments (N, 4) where a mask begins or ends."""
    high, _ = mask.shape
    r, c = np.nonzero(mask[:, 1:] != mask[:, :-1])
    upright = np.stack([x + (c + 1) * w, y + (high - 1 - r) * h, x + (c + 1) * w, y + (high - r) * h], axis=1)
    r, c = np.nonzero(mask[1:] != mask[:-1])
    level = np.stack([x + c * w, y + (high - 1 - r) * h, x + (c + 1) * w, y + (high - 1 - r) * h], axis=1)
    return np.concatenate([upright, level])


def _catch_marks(sheet: Page, chart: Chart, window: Window, x: float, y: float, look: Look) -> None:
    """A small wedge at the foot of each stitch behind which a float is caught."""
    assert look.limit is not None
    w, h = look.cell
    b, t, left, right = window
    row, column = np.nonzero(catches(chart, look.limit, look.anchored)[b:t, left:right])
    marks = np.stack([x + (column + 0.5) * w, y + (t - b - row) * h], axis=1)
    if len(marks):
        wedge = np.array([(0, -0.40 * h), (0.27 * w, -0.03 * h), (-0.27 * w, -0.03 * h)])
        sheet.rings(marks[:, None] + wedge, INK, (255, 255, 255), 0.07 * w)


def _numbers(sheet: Page, chart: Chart, window: Window, x: float, y: float, look: Look) -> None:
    """Row numbers where each row begins, stitch numbers at the foot, counted from the right."""
    w, h = look.cell
    b, t, left, right = window
    width = chart.shape[1]
    x1, y1 = x + (right - left) * w, y + (t - b) * h
    size = min(2.7, max(1.3, 0.78 * h))
    every = 1 if h * (1 if chart.circular else 2) > 0.95 * size else 5 if 5 * h > size else 10
    for r in range(b, t):
        number = r + 1
        if number % every and number != 1:
            continue
        base = y + (t - r - 0.5) * h + 0.36 * size
        if wrong_side(chart, r):
            sheet.text(str(number), x - 0.9, base, size, number % 10 == 0, anchor="end")
        else:
            sheet.text(str(number), x1 + 0.9, base, size, number % 10 == 0)
    size = min(2.7, max(1.3, 0.55 * w))
    room = 0.62 * size * len(str(width - left)) + 0.5
    step = 1 if w > room else 5 if 5 * w > room else 10
    for c in range(left, right):
        number = width - c
        if number == 1 or number % step == 0:
            sheet.text(str(number), x + (c - left + 0.5) * w, y1 + 0.6 + size, size, number % 10 == 0, anchor="middle")


def key_rows(chart: Chart, look: Look) -> list[tuple[int, str, str]]:
    """Colour, role, and name with what to do with it."""
    return [
        (c, role, color_name(chart, c) + (" · dominant: held below" if c == look.dominant else ""))
        for c, role in roles(chart).items()
    ]


def key(sheet: Page, chart: Chart, x: float, y: float, look: Look, size: float = 3.0) -> float:
    """Draw the key downwards from ``y``; gives the y below it."""
    box = 1.7 * size

    def entry(text: str) -> None:
        nonlocal y
        sheet.text(text, x + box + 2.0, y + 0.5 * box + 0.36 * size, size)
        y += 1.25 * box

    for color, role, name in key_rows(chart, look):
        fill = None if look.cells == "symbol" else _shown(chart, color)
        sheet.boxes([(x, y, x + box, y + box)], fill, INK, 0.2)
        if look.cells != "colour" and sign(chart, color):
            for ring in _shape(sign(chart, color)):
                centre = np.array([x + 0.5 * box, y + 0.5 * box])
                sheet.rings((centre + 0.9 * box * np.array(ring))[None], _against(chart, color, look))
        sheet.text(role, x + box + 2.0, y + 0.5 * box + 0.36 * size, size, bold=True)
        sheet.text(name, x + box + 2.0 + 4.2 * size, y + 0.5 * box + 0.36 * size, size)
        y += 1.25 * box
    if chart.no_stitch is not None and chart.no_stitch.any():
        sheet.boxes([(x, y, x + box, y + box)], PALE, INK, 0.2)
        entry("no stitch: skip this square")
    if look.limit is not None and len(floats(chart, look.anchored, look.limit).row):
        centre = np.array([x + 0.5 * box, y + box])
        wedge = np.array([(0, -0.4 * box), (0.3 * box, 0), (-0.3 * box, 0)])
        sheet.boxes([(x, y, x + box, y + box)], None, INK, 0.2)
        sheet.rings((centre + wedge)[None], INK)
        entry("catch the float behind this stitch")
    if look.repeat and 1 < look.repeat < chart.shape[1]:
        sheet.boxes([(x, y, x + box, y + box)], None, RED, 0.7)
        entry(f"repeat of {look.repeat} stitches")
    return y


def drawable(chart: Chart) -> None:
    """Raise TambourError for a chart of more stitches than anyone prints."""
    if chart.cells.size > LARGEST:
        raise TambourError(
            f"{chart.cells.size:,} stitches are too many to draw one by one",
            hint="-o name.png has a pixel for each, -o name.fabric.jpg shows the cloth",
        )


def sheet_of(chart: Chart, look: Look, title: str = "", lines: tuple[str, ...] = ()) -> Drawing:
    """The whole chart on one sheet as large as it needs, with title and key."""
    drawable(chart)
    w, h = look.cell
    rows, width = chart.shape
    margin, head = 14.0, 16.0 if title else 8.0
    foot = 12.0 + 6.5 * (len(roles(chart)) + 3) + 4.5 * len(lines)
    sheet = Page(max(2 * margin + width * w, 110.0), head + rows * h + foot + 6)
    if title:
        sheet.text(title, margin, 10.0, 5.5, bold=True)
    grid(sheet, chart, Window(0, rows, 0, width), margin, head, look)
    y = key(sheet, chart, margin, head + rows * h + 9.0, look)
    sheet.paragraph(lines, margin, y + 3.0, 3.0)
    return sheet.drawing(title=title or "Stranded chart")


def float_sheet(chart: Chart, look: Look, title: str = "") -> Drawing:
    """The chart in pale colours with a bar for every float of three stitches or more, red where it is above the limit."""
    drawable(chart)
    w, h = look.cell
    rows, width = chart.shape
    limit = look.limit or 5
    sheet = Page(max(2 * 14.0 + width * w, 110.0), 16 + rows * h + 40)
    sheet.text(f"{title}: floats" if title else "Floats", 14, 10.0, 5.5, bold=True)
    pale = np.round(255 - (255 - chart.palette.rgb.astype(np.float64)) * 0.45).astype(np.uint8)
    light = replace(chart, palette=Palette(pale, tuple(map(str, range(len(pale))))), relaxed=None, locked=None)
    grid(sheet, light, Window(0, rows, 0, width), 14, 16, look._replace(cells="colour", limit=None))
    found = floats(chart, look.anchored)
    y = 16 + rows * h + 10
    for name, pick, color in (
        (f"3 to {limit} stitches", (found.length >= 3) & (found.length <= limit), (30, 110, 170)),
        (f"above {limit}: to be caught", found.length > limit, RED),
    ):
        row, start, length = found.row[pick], found.start[pick], found.length[pick]
        level = 16 + (rows - row - 0.5) * h
        stop = np.minimum(start + length, width)
        bars = np.stack([14 + (start + 0.3) * w, level, 14 + (stop - 0.3) * w, level], axis=1)
        over = start + length > width  # round the seam: the rest begins at the left again
        rest = np.stack(
            [np.full(over.sum(), 14.0), level[over], 14 + (start + length - width - 0.3)[over] * w, level[over]], axis=1
        )
        sheet.segments(np.concatenate([bars, rest]), color, 0.22 * min(w, h))
        sheet.segments([(14, y, 22, y)], color, 0.9)
        sheet.text(f"{name}: {int(pick.sum())}", 25, y + 1.1, 3.0)
        y += 6
    sheet.text(f"longest {int(found.length.max(initial=0))} stitches", 25, y + 1.1, 3.0)
    return sheet.drawing(title=title or "Floats")

"""The printed pattern: a cover, the chart in tiles that overlap, the floats to catch; a page per Drawing."""

from __future__ import annotations

import re
from math import ceil, floor
from textwrap import wrap
from typing import NamedTuple

import numpy as np

from tambour.core.chart import Chart
from tambour.core.drawing import Drawing
from tambour.core.picture import Picture
from tambour.knit.hands.working import roles
from tambour.knit.hands.written import bobbin_list, color_name, float_list, how_to_read, ladder_list
from tambour.knit.hands.yarn import Amount, gauge_of
from tambour.knit.params import Paper
from tambour.knit.sheets.draw import RED, Look, Window, drawable, grid, key
from tambour.knit.sheets.swatch import page as swatch_page
from tambour.render.page import GREY, INK, PAPERS, Page

MARGIN = 12.0
HEAD = 12.0
GUTTER = 8.0
"""Room for row numbers on either side of the cells."""
FOOT = 13.0
OVERLAP = 2
"""Stitches and rows that neighbouring tiles share."""
TALLEST_CELL = 9.0


class Layout(NamedTuple):
    """How a chart falls onto pages: size of the page, size of a cell, the windows in reading order (bottom row of
    tiles first, each from the right), how many stand side by side and above each other."""

    page: tuple[float, float]
    cell: tuple[float, float]
    windows: tuple[Window, ...]
    across: int
    up: int


def layout(chart: Chart, page: Paper = "a4", aspect: float = 1.0, large: bool = False) -> Layout:
    """Fit the chart onto as few pages as legible cells allow, upright or across.

    aspect : width of a stitch over the height of a row; large : cells for tired eyes
    """
    rows, width = chart.shape
    least = 6.5 if large else 3.3  # the smaller side of a cell, mm
    choices = []
    for turned in (False, True):
        sheet = PAPERS[page][::-1] if turned else PAPERS[page]
        room = (sheet[0] - 2 * MARGIN - 2 * GUTTER, sheet[1] - 2 * MARGIN - HEAD - FOOT)
        w = least * max(1.0, aspect)
        h = w / aspect
        whole = min(room[0] / width, room[1] / rows * aspect)
        if whole >= w * (1.0 if large else 0.85):
            w = min(whole, TALLEST_CELL * min(1.0, aspect))
            choices.append((1, -w, turned, Layout(sheet, (w, w / aspect), (Window(0, rows, 0, width),), 1, 1)))
            continue
        nx, stepx = _tiles(width, floor(room[0] / w))
        ny, stepy = _tiles(rows, floor(room[1] / h))
        shown = (min(width, stepx + OVERLAP), min(rows, stepy + OVERLAP))
        w = min(room[0] / shown[0], room[1] / shown[1] * aspect, TALLEST_CELL)
        windows = tuple(
            Window(
                j * stepy,
                min(rows, (j + 1) * stepy + OVERLAP),
                max(0, width - (i + 1) * stepx - OVERLAP),
                width - i * stepx,
            )
            for j in range(ny)
            for i in range(nx)
        )
        choices.append((nx * ny, -w, turned, Layout(sheet, (w, w / aspect), windows, nx, ny)))
    return min(choices, key=lambda c: c[:3])[3]


def _tiles(length: int, fits: int) -> tuple[int, int]:
    """How many tiles cover ``length`` when ``fits`` are legible on a page, and their step: fives where there is room,
    so that a ruled line begins a page."""
    if length <= fits:
        return 1, length
    step = fits - OVERLAP
    count = ceil((length - OVERLAP) / step)
    even = ceil((length - OVERLAP) / count)
    fives = ceil(even / 5) * 5
    return (count, fives) if fives <= step else (count, even)


KNITTING = {"stranded": "stranded knitting", "intarsia": "stocking stitch", "jacquard": "jacquard on both beds"}
COUNTED = {
    "stranded": "Floats and a tenth to spare are counted.",
    "intarsia": "A tenth to spare and the bobbins' ends are counted.",
    "jacquard": "The back bed and a tenth to spare are counted.",
}
TECHNIQUES = {
    "intarsia": "Intarsia: a bobbin for each area, nothing carried behind",
    "jacquard": "Jacquard on a double bed, nothing floats",
}


class Words(NamedTuple):
    """What the cover says: title, the float allowed, the longest there is, yarn weight, whether both yarns go to both sides, lines about the
    making (tools, machine, source)."""

    title: str
    limit: int
    longest: int
    weight: str
    anchored: bool = True
    about: tuple[str, ...] = ()


def booklet(
    chart: Chart,
    look: Look,
    words: Words,
    amounts: list[Amount],
    fabric: Picture,
    page: Paper = "a4",
    large: bool = False,
    swatch: bool = False,
) -> tuple[Drawing, ...]:
    """Cover, swatch when asked for, tiles, float list.

    fabric : how the piece will look, for the cover; amounts : from :func:`tambour.knit.hands.yarn.amounts`
    """
    drawable(chart)
    gauge = gauge_of(chart, words.weight)
    aspect = gauge.width / gauge.height if chart.gauge else 1.0
    plan = layout(chart, page, aspect, large)
    look = look._replace(cell=plan.cell)
    catch = look.limit or words.limit
    listed = float_list(chart, catch, look.anchored)
    ladder = ladder_list(chart, catch, look.anchored) if listed else []
    texts = _columns(_floats_told(listed, ladder, catch), PAPERS[page]) if listed else []
    if chart.technique == "intarsia":
        texts = _columns([line for one in bobbin_list(chart, words.weight) for line in wrap(one, 66)], PAPERS[page])
    first = 3 if swatch else 2  # the page of the first tile
    total = first - 1 + len(plan.windows) + len(texts)
    pages = [_cover(chart, look, words, amounts, fabric, plan, PAPERS[page], first, total, bool(listed))]
    if swatch:
        pages.append(swatch_page(chart, look, words.title, words.weight, PAPERS[page]))
        page_number(pages[-1], 2, total)
    pages += [_tile(chart, look, words, plan, k, first, total) for k in range(len(plan.windows))]
    for k, columns in enumerate(texts):
        sheet = Page(*PAPERS[page])
        _head(sheet, words.title, "floats to catch" if listed else "bobbins", first + len(plan.windows) + k, total)
        wide = (PAPERS[page][0] - 2 * MARGIN) / 2
        for c, lines in enumerate(columns):
            sheet.paragraph(lines, MARGIN + c * wide, MARGIN + HEAD + 4, 2.6)
        pages.append(sheet)
    return tuple(sheet.drawing(title=words.title) for sheet in pages)


def page_number(sheet: Page, number: int, total: int) -> None:
    """The page's number at the foot."""
    width, height = sheet.size
    sheet.text(f"{number} / {total}", width - MARGIN, height - MARGIN + 4, 2.8, color=GREY, anchor="end")


def _head(sheet: Page, title: str, what: str, number: int, total: int) -> None:
    width = sheet.size[0]
    sheet.text(title, MARGIN, MARGIN + 3.5, 3.6, bold=True)
    sheet.text(what, width - MARGIN, MARGIN + 3.5, 3.2, color=GREY, anchor="end")
    sheet.segments([(MARGIN, MARGIN + 5.5, width - MARGIN, MARGIN + 5.5)], GREY, 0.15)
    page_number(sheet, number, total)


def _tile(chart: Chart, look: Look, words: Words, plan: Layout, k: int, first: int, total: int) -> Page:
    """One page of the chart."""
    _rows, width = chart.shape
    w, h = look.cell
    window = plan.windows[k]
    sheet = Page(*plan.page)
    word = "rounds" if chart.circular else "rows"
    where = f"{word} {window.bottom + 1}–{window.top}, stitches {width - window.right + 1}–{width - window.left}"
    _head(sheet, words.title, where, first + k, total)
    wide, high = (window.right - window.left) * w, (window.top - window.bottom) * h
    x = (plan.page[0] - wide) / 2
    y = MARGIN + HEAD
    # What a neighbouring page repeats is shaded beyond the cells and cut off by dashes.
    i, j = k % plan.across, k // plan.across
    band = 2.2
    if i + 1 < plan.across:
        sheet.boxes([(x, y - band - 0.4, x + OVERLAP * w, y - 0.4)], (255, 205, 120))
        sheet.text(f"again on page {first + 1 + k}", x + OVERLAP * w + 1, y - 0.9, 2.0, color=GREY)
    if i:
        sheet.boxes([(x + wide - OVERLAP * w, y - band - 0.4, x + wide, y - 0.4)], (255, 205, 120))
        sheet.text(f"also on page {first - 1 + k}", x + wide - OVERLAP * w - 1, y - 0.9, 2.0, color=GREY, anchor="end")
    if j + 1 < plan.up:
        sheet.boxes([(x - band - 5.6, y, x - 5.6, y + OVERLAP * h)], (255, 205, 120))
        sheet.text(
            f"again on page {first + k + plan.across}",
            x - 5.9,
            y + OVERLAP * h + 1,
            2.0,
            color=GREY,
            anchor="end",
            angle=np.pi / 2,
        )
    if j:
        sheet.boxes([(x - band - 5.6, y + high - OVERLAP * h, x - 5.6, y + high)], (255, 205, 120))
        sheet.text(
            f"also on page {first + k - plan.across}",
            x - 5.9,
            y + high - OVERLAP * h - 1,
            2.0,
            color=GREY,
            angle=np.pi / 2,
        )
    grid(sheet, chart, window, x, y, look)
    if i + 1 < plan.across:
        sheet.dashes(x + OVERLAP * w, y, x + OVERLAP * w, y + high, RED, 0.35)
    if j + 1 < plan.up:
        sheet.dashes(x, y + OVERLAP * h, x + wide, y + OVERLAP * h, RED, 0.35)
    foot = "  ".join(f"{role} {color_name(chart, c)}" for c, role in roles(chart).items())
    sheet.text(foot, MARGIN, plan.page[1] - MARGIN + 4, 2.8, color=GREY)
    return sheet


def _cover(
    chart: Chart,
    look: Look,
    words: Words,
    amounts: list[Amount],
    fabric: Picture,
    plan: Layout,
    page: tuple[float, float],
    first: int,
    total: int,
    listed: bool,
) -> Page:
    """Title, how it will look with the pages marked on it, size, gauge, key, yarn, how to read."""
    sheet = Page(*page)
    rows, width = chart.shape
    gauge = gauge_of(chart, words.weight)
    word = "round" if chart.circular else "row"
    sheet.text(words.title, MARGIN, MARGIN + 8, 8.0, bold=True)
    size = f"{width} stitches × {rows} {word}s · {width * gauge.width / 10:.1f} × {rows * gauge.height / 10:.1f} cm"
    sheet.text(
        f"{size} ({width * gauge.width / 25.4:.1f} × {rows * gauge.height / 25.4:.1f} in)", MARGIN, MARGIN + 15, 3.6
    )
    high, wide = fabric.rgba.shape[:2]
    room = (page[0] - 2 * MARGIN, page[1] * 0.46)
    scale = min(room[0] / wide, room[1] / high)
    w, h = wide * scale, high * scale
    x, y = (page[0] - w) / 2, MARGIN + 20
    sheet.image(fabric, x, y, w, h)
    sheet.boxes([(x, y, x + w, y + h)], None, GREY, 0.15)
    if len(plan.windows) > 1:
        for k, window in enumerate(plan.windows):
            box = (
                x + w * window.left / width,
                y + h * (rows - window.top) / rows,
                x + w * window.right / width,
                y + h * (rows - window.bottom) / rows,
            )
            sheet.boxes([box], None, RED, 0.3)
            middle = ((box[0] + box[2]) / 2, (box[1] + box[3]) / 2)
            sheet.circles([middle], 3.2, (255, 255, 255), RED, 0.3)
            sheet.text(str(first + k), middle[0], middle[1] + 1.2, 3.4, bold=True, anchor="middle")
    y += h + 10
    left, right = MARGIN, page[0] / 2 + 4
    sheet.text("Key", left, y, 4.2, bold=True)
    below = key(sheet, chart, left, y + 3, look, 2.9)
    sheet.text("Yarn", left, below + 7, 4.2, bold=True)
    lines = [
        f"{roles(chart)[a.color]}: {a.metres:.0f} m / {a.yards:.0f} yd, {a.grams:.0f} g, "
        f"{a.skeins} skein{'s' if a.skeins > 1 else ''}"
        for a in amounts
    ]
    sheet.paragraph([*lines, COUNTED[chart.technique]], left, below + 12.5, 2.9)
    sheet.text("How to read it", right, y, 4.2, bold=True)
    sheet.paragraph(_reading(chart, look, words, plan, listed), right, y + 5.5, 2.9)
    page_number(sheet, 1, total)
    sheet.segments([(MARGIN, page[1] - MARGIN, page[0] - MARGIN, page[1] - MARGIN)], GREY, 0.15)
    if chart.technique != "stranded":
        sheet.text(TECHNIQUES[chart.technique], MARGIN, page[1] - MARGIN + 4, 2.8, color=INK)
        return sheet
    catch = look.limit or words.limit
    caught = f", caught so that at most {catch} lie free" if words.longest > catch else ""
    sheet.text(f"Longest float {words.longest} stitches{caught}", MARGIN, page[1] - MARGIN + 4, 2.8, color=INK)
    return sheet


def _reading(chart: Chart, look: Look, words: Words, plan: Layout, listed: bool) -> list[str]:
    gauge = gauge_of(chart, words.weight)
    lines = [f"Gauge {gauge.stitches:g} stitches × {gauge.rows:g} rows in 10 cm"]
    lines.append(
        f"in {KNITTING[chart.technique]}."
        if chart.gauge
        else f"(usual for {words.weight}; none was given: swatch first)."
    )
    lines.append("")
    if chart.technique == "jacquard":
        lines += _said(how_to_read(chart))
    else:
        lines += _flat_or_round(chart)
    if chart.technique == "intarsia":
        lines += ["", *_said(how_to_read(chart)[1:])]
    elif chart.technique == "stranded":
        lines += _stranding(chart, look, words)
    if listed:
        lines += ["Catch floats where a small wedge stands; the list is", "at the end."]
    if len(plan.windows) > 1:
        lines += [
            "Pages overlap by 2 stitches and 2 rows: cut along",
            "the dashes and lay the page over its neighbour.",
        ]
    return [*lines, *words.about]


def _said(lines: list[str]) -> list[str]:
    return wrap(" ".join(lines), 52)


def _flat_or_round(chart: Chart) -> list[str]:
    if chart.circular:
        return ["Begin at the bottom right. Every round is knit and", "read from right to left."]
    return [
        "Begin at the bottom right. Odd rows (numbers on the",
        "right) are knit, right to left. Even rows (numbers on",
        "the left) are purled on the wrong side, left to right.",
    ]


def _stranding(chart: Chart, look: Look, words: Words) -> list[str]:
    lines = [""]
    if look.dominant is not None and look.dominant in roles(chart):
        name = roles(chart)[look.dominant]
        lines += [
            f"Hold {name} below the other yarn throughout: the yarn",
            "held below stands out (it is the dominant one).",
        ]
    elif len(roles(chart)) > 2:
        lines += [
            "In each row hold the yarn with fewer stitches below the",
            "other: it stands out (it is the dominant one).",
        ]
    lines += ["Strand loosely; spread the stitches on the needle."]
    if not chart.circular and words.anchored:
        lines += ["Carry both yarns to both ends of every row."]
    return lines


def _floats_told(listed: list[str], ladder: list[str], catch: int) -> list[str]:
    """The lines of the float list."""
    lines = [
        f"Floats above {catch} stitches: yarn, the stitches that it lies behind,",
        "counted from the right (how many): catch at",
        "",
    ]
    for line in listed:
        # A float's words stay together.
        glued = re.sub(r"(CC\d?|MC) behind (\S+) (\S+) ", "\\1\u00a0behind\u00a0\\2\u00a0\\3\u00a0", line)
        lines += [part.replace("\u00a0", " ") for part in wrap(glued, 66, subsequent_indent="   ")]
    if ladder:
        lines += [
            "",
            "Or ladder-back: cast on these extra stitches behind,",
            "purl them with the idle yarn, bind off where they end.",
            "",
        ]
        lines += ladder
    return lines


def _columns(lines: list[str], page: tuple[float, float]) -> list[list[list[str]]]:
    """Lines on pages of two columns."""
    per = int((page[1] - 2 * MARGIN - HEAD - 8) / (2.6 * 1.45))
    columns = [lines[i : i + per] for i in range(0, len(lines), per)]
    return [columns[i : i + 2] for i in range(0, len(columns), 2)]

"""Charts as they are given: one pixel per stitch, at most two colours in a row."""

from __future__ import annotations

import numpy as np

from tambour.core.chart import Chart, Technique
from tambour.core.check import Array
from tambour.core.errors import Problem, TambourError
from tambour.core.palette import Palette
from tambour.core.picture import Picture
from tambour.knit.picture.resample import LUMA

MOST = 24  # colours in a chart; a picture with more is no chart


def chart_of(picture: Picture, two: bool = True) -> Chart:
    """The Chart of a picture of one pixel per stitch: its colours, dark to light, at most ``two`` in a row, or any.

    Transparent pixels are cells that are not knitted. Raises TambourError naming every row of more than two colours.
    """
    rgba = picture.rgba[::-1]
    rows, stitches = rgba.shape[:2]
    if max(rows, stitches) > 20000:
        raise TambourError(f"{stitches} x {rows} stitches are too many", hint="at most 20000 in a row, and 20000 rows")
    hidden = rgba[..., 3] < 128
    packed = rgba[..., 0].astype(np.uint32) << 16 | rgba[..., 1].astype(np.uint32) << 8 | rgba[..., 2]
    colours = np.unique(packed[~hidden])
    if len(colours) > MOST:
        raise TambourError(
            f"this picture has {len(colours):,} colours, a chart has a few",
            hint="{--check} takes a chart of one pixel per stitch; make one of a picture without {--check}",
        )
    problems = []
    for r in range(rows):
        n = len(np.unique(packed[r][~hidden[r]]))
        if n > 2 and two:
            problems.append(Problem(f"row {r + 1} (from the bottom) has {n} colours, at most two can be stranded"))
    if problems:
        rest = len(problems) - 20
        raise TambourError(problems[:20] + ([Problem(f"and {rest} rows more")] if rest > 0 else []))
    if not len(colours):
        raise TambourError("the chart has no stitches", hint="every pixel is transparent")
    rgb = np.stack([colours >> 16, (colours >> 8) & 255, colours & 255], 1).astype(np.uint8)
    order = np.argsort(rgb.astype(float) @ LUMA, kind="stable")
    place = np.zeros(len(colours), np.uint8)
    place[order] = np.arange(len(colours))
    cells = place[np.searchsorted(colours, np.where(hidden, colours[0], packed))]
    technique: Technique = "stranded" if two else "intarsia"
    return Chart(cells, Palette(rgb[order]), no_stitch=hidden if hidden.any() else None, technique=technique)


def two_per_row(chart: Chart) -> tuple[Array, Array]:
    """(R, C) bits and (R, 2) pairs of palette entries, dark and light, of a chart with at most two colours in a row."""
    cells = chart.cells
    bright = chart.palette.rgb.astype(float) @ LUMA
    bits = np.zeros(cells.shape, np.uint8)
    pairs = np.zeros((len(cells), 2), np.uint8)
    for r, row in enumerate(cells):
        held = np.unique(row if chart.no_stitch is None else row[~chart.no_stitch[r]])
        if len(held) == 2:
            dark, light = sorted(held.tolist(), key=lambda k: (bright[k], k))
        else:
            # One colour in the row: its partner is the main colour, or, if that is it, the next.
            one = int(held[0]) if len(held) else 0
            other = 0 if one else min(1, len(chart.palette) - 1)
            dark, light = (one, other) if (bright[one], one) <= (bright[other], other) else (other, one)
            if len(chart.palette) == 1:
                dark, light = 0, 1
        pairs[r] = dark, light
        bits[r] = row == light
    return bits, pairs

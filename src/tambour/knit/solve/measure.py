"""Measure: how like its target a chart looks, and how orderly its flips stand."""

from __future__ import annotations

from typing import Any

import numpy as np

from tambour.core.check import Array
from tambour.knit.piece import Piece

SIGMAS = (1.0, 1.5, 2.0, 3.0)
SAMPLE = 1 << 20  # stitches; of larger charts evenly spread bands of rows are measured


def lined_up(flips: Array, least: int = 3) -> float:
    """Per 1000 flips (R, C) bool, those that stand in a column of ``least`` or more, row upon row."""
    total = int(flips.sum())
    if total == 0:
        return 0.0
    height = np.zeros(flips.shape[1], np.int32)
    lined = 0
    for row in flips:
        height = np.where(row, height + 1, 0)
        lined += int((height == least).sum()) * least + int((height > least).sum())
    return 1000.0 * lined / total


def upright(cells: Array, least: int = 4) -> float:
    """Per 1000 stitches of ``cells`` (R, C), those that one sees as an upright bar or a dotted column.

    A stitch that differs from both its neighbours in the row stands alone there; ``least`` such stitches of one colour,
    one above the other or in every second row, draw a line.
    """
    alone = np.zeros(cells.shape, np.bool_)
    alone[:, 1:-1] = (cells[:, 1:-1] != cells[:, :-2]) & (cells[:, 1:-1] != cells[:, 2:])
    seen_ = np.zeros(cells.shape, np.bool_)
    for colour in np.unique(cells):
        mine = alone & (cells == colour)
        seen_ |= standing(mine, least, 1) | (standing(mine, least, 2) & ~np.roll(mine, 1, axis=0))
    return 1000.0 * float(seen_.mean()) if cells.size else 0.0


def standing(marks: Array, least: int, step: int) -> Array:
    """The ``marks`` (R, C) bool that belong to ``least`` or more in a column, each ``step`` rows above the last."""
    out = np.zeros(marks.shape, np.bool_)
    for first in range(step):
        part = marks[first::step]
        if len(part) < least:
            continue
        whole = np.asarray(np.lib.stride_tricks.sliding_window_view(part, least, axis=0).all(axis=-1))
        for k in range(least):
            out[first::step][k : k + len(whole)] |= whole
    return out


def lone(cells: Array) -> Array:
    """(R, C) bool: stitches whose neighbours, beside, above and below, are all of another colour."""
    around = np.pad(cells.astype(np.int16), 1, constant_values=-1)
    found = np.ones(cells.shape, np.bool_)
    for dy, dx in ((0, 1), (2, 1), (1, 0), (1, 2)):
        found &= around[dy : dy + cells.shape[0], dx : dx + cells.shape[1]] != cells
    return found


def kept(start: Array, changed: Array, plain: Array) -> float:
    """Percent of the ``plain`` stitches of ``start`` (R, C) at a border, beside or above another colour, that are not
    ``changed``: 100 where every border is closed."""
    edge = np.zeros(start.shape, np.bool_)
    for axis in (0, 1):
        apart = np.diff(start.astype(np.int16), axis=axis) != 0
        for side in ((0, 1), (1, 0)):
            edge |= np.pad(apart, [side if k == axis else (0, 0) for k in (0, 1)])
    edge &= plain
    return 100.0 * float((~changed[edge]).mean()) if edge.any() else 100.0


def blurred_error(cells: Array, tone: Array, sigma: float) -> float:
    """Mean squared difference of ``cells`` and ``tone`` (R, C) after a Gaussian blur of ``sigma`` stitches each."""
    from scipy.ndimage import gaussian_filter

    return float(
        (gaussian_filter(cells.astype(np.float32) - tone.astype(np.float32), sigma).astype(np.float64) ** 2).mean()
    )


def psnr(error: float) -> float:
    """Decibels of a mean squared error, the range being 1; 120 at the most."""
    return float(min(120.0, -10 * np.log10(max(error, 1e-12))))


def ssim(a: Array, b: Array) -> float:
    """Structural similarity (Wang, Bovik, Sheikh, Simoncelli 2004): Gaussian window of 1.5, range 1, mean of the map."""
    from scipy.ndimage import gaussian_filter

    a, b = a.astype(np.float64), b.astype(np.float64)
    c1, c2 = 0.01**2, 0.03**2

    def mean(v: Array) -> Array:
        return np.asarray(gaussian_filter(v, 1.5, truncate=3.5))

    ma, mb = mean(a), mean(b)
    va, vb, vab = mean(a * a) - ma * ma, mean(b * b) - mb * mb, mean(a * b) - ma * mb
    return float((((2 * ma * mb + c1) * (2 * vab + c2)) / ((ma * ma + mb * mb + c1) * (va + vb + c2))).mean())


def seen(cells: Array, tone: Array) -> dict[str, dict[str, float]]:
    """PSNR and SSIM of the blurred chart against the blurred target, by blur."""
    from scipy.ndimage import gaussian_filter

    found: dict[str, dict[str, float]] = {"psnr": {}, "ssim": {}}
    for sigma in SIGMAS:
        found["psnr"][f"{sigma:g}"] = round(psnr(blurred_error(cells, tone, sigma)), 2)
        a, b = gaussian_filter(cells.astype(np.float32), sigma), gaussian_filter(tone.astype(np.float32), sigma)
        found["ssim"][f"{sigma:g}"] = round(ssim(a, b), 4)
    return found


def bands(rows: int, stitches: int) -> list[slice]:
    """All rows, or, of a large chart, eight evenly spread bands that hold SAMPLE stitches."""
    if rows * stitches <= SAMPLE:
        return [slice(0, rows)]
    high = max(16, SAMPLE // (8 * stitches))
    return [slice(k, k + high) for k in np.linspace(0, rows - high, 8).astype(int)]


def facts(piece: Piece) -> dict[str, Any]:
    """What the report says beside the piece's own figures: lined-up flips, and how like its target it looks."""
    chart = piece.chart
    out: dict[str, Any] = {}
    flips = chart.cells != piece.start
    if chart.no_stitch is not None:
        flips &= ~chart.no_stitch
    if piece.params.style == "plain" and piece.params.method not in ("perceptual", "diffused", "none"):
        out["lined_up"] = round(lined_up(flips), 2)  # elsewhere flips are a ground that stands in order, or no measure
    out["upright"] = round(float(np.mean([upright(chart.cells[b]) for b in bands(*chart.cells.shape)])), 2)
    if piece.textured is not None:
        plain = ~piece.textured & ~flips
        out["borders"] = round(kept(piece.start, flips, ~piece.textured), 2)
        out["alone"] = round(100.0 * float((lone(chart.cells) & plain).sum()) / max(1, chart.cells.size), 2)
    if len(chart.palette) == 2:
        out["likeness"] = likenesses(piece)
    if len(chart.palette) == 2:
        parts = [
            seen(masked(chart.cells[b], chart.no_stitch, b), masked(piece.tone[b], chart.no_stitch, b))
            for b in bands(*chart.cells.shape)
        ]
        out["seen"] = {
            kind: {sigma: round(float(np.mean([p[kind][sigma] for p in parts])), 4) for sigma in parts[0][kind]}
            for kind in ("psnr", "ssim")
        }
    return out


def masked(values: Array, no_stitch: Array | None, band: slice) -> Array:
    """``values`` with nothing where nothing is knitted."""
    return values if no_stitch is None else np.where(no_stitch[band], 0, values)


DISTANCES = (1.0, 2.0, 4.0, 8.0)


def likenesses(piece: Piece) -> dict[str, float]:
    """How like its picture, before any preparation, the chart looks from 1, 2, 4 and 8 m: see :func:`sight.likenesses`."""
    from tambour.knit.picture.tone import brightness
    from tambour.knit.solve import sight

    chart = piece.chart
    first = bands(*chart.cells.shape)[len(bands(*chart.cells.shape)) // 2]
    luma = brightness(piece.picture[first], "code")
    light = brightness(chart.palette.rgb[None], "code")[0]
    cells = light[chart.cells[first]]
    if chart.no_stitch is not None:
        cells, luma = (np.where(chart.no_stitch[first], 0, v) for v in (cells, luma))
    found = sight.likenesses(cells, luma, chart.gauge, DISTANCES)
    return {f"{m:g}": round(like, 3) for m, like in zip(DISTANCES, found)}

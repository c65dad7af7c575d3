"""Worn: a yoke or a hat as one looks down on it, the rounds laid about the neck or the crown."""

from __future__ import annotations

from dataclasses import replace
from math import pi

import numpy as np

from tambour.core.chart import Chart
from tambour.core.check import Array
from tambour.core.picture import Picture
from tambour.knit.hands.yarn import gauge_of
from tambour.knit.sheets.fabric import front

SIDE = 1600
"""Pixels of the picture's side."""
HOLE = 0.2
"""The smallest hole, of the radius: a yoke has a neck, the crown of a hat is drawn together in one stitch's width."""
GROUND = (231, 228, 222)
SMOOTH = 2
"""Rays per pixel and axis."""


def from_above(chart: Chart, round_: float, weight: str, hole: bool) -> Picture:
    """The rounds of ``chart`` as rings, the first outermost, as many copies of the chart as go ``round_`` mm.

    hole : leave a neck open; else the rings reach the middle
    """
    gauge = gauge_of(chart, weight)
    rows, stitches = chart.shape
    copies = max(1, round(round_ / (stitches * gauge.width)))
    outer = copies * stitches * gauge.width / (2 * pi)
    inner = max(outer - rows * gauge.height, HOLE * outer) if hole else 0.0
    cloth = front(filled(chart), max(4, min(16, 3200 // stitches))).rgba[..., :3].astype(np.float32)
    tall, wide = cloth.shape[0] / rows, cloth.shape[1] / stitches
    place, count = knitted(chart)
    side = SIDE * SMOOTH
    at = (np.arange(side) + 0.5) / side * 2.08 - 1.04
    out = np.empty((side, side, 3), np.float32)
    for k in range(0, side, 200):
        x, y = at[None], at[k : k + 200, None]
        r = np.hypot(x, y) * outer
        share = (outer - r) / (outer - inner)  # 0 at the outermost round, 1 within the last
        on = (share >= 0) & (share < 1)
        up = np.clip(share, 0, 1 - 1e-9) * rows
        row = up.astype(int)
        turn = (np.arctan2(x, y) / (2 * pi) + 0.5) % 1.0 * copies % 1.0 * count[row]
        stitch = np.minimum(turn.astype(int), count[row] - 1)
        column = place[row, stitch] + (turn - stitch)
        py = np.clip(((rows - up) * tall).astype(int), 0, cloth.shape[0] - 1)
        px = np.clip((column * wide).astype(int), 0, cloth.shape[1] - 1)
        out[k : k + 200] = np.where(on[..., None], cloth[py, px], np.array(GROUND, np.float32))
    small = out.reshape(SIDE, SMOOTH, SIDE, SMOOTH, 3).mean((1, 3))
    rgba = np.full((SIDE, SIDE, 4), 255, np.uint8)
    rgba[..., :3] = np.round(small)
    return Picture(rgba)


def filled(chart: Chart) -> Chart:
    """The chart with a stitch in every cell: a wedge is drawn together where it is worn, so its sides meet without a gap."""
    if chart.no_stitch is None:
        return chart
    from scipy.ndimage import distance_transform_edt

    near = distance_transform_edt(chart.no_stitch, sampling=(1e6, 1.0), return_distances=False, return_indices=True)
    return replace(chart, cells=np.ascontiguousarray(chart.cells[tuple(near)]), no_stitch=None)


def knitted(chart: Chart) -> tuple[Array, Array]:
    """(R, C) columns of each round's stitches from the left, and how many (R,); rounds without any have one, the first."""
    rows, stitches = chart.shape
    if chart.no_stitch is None:
        return np.tile(np.arange(stitches), (rows, 1)), np.full(rows, stitches)
    order = np.argsort(chart.no_stitch, axis=1, kind="stable")
    return order, np.maximum((~chart.no_stitch).sum(1), 1)

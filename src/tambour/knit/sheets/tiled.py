"""Tiled: a motif as one sees it worn, before it is fitted: about a hat, on a mitten, round a yoke.

The woman's sizes of the table: whole repeats go round each, and the motif is repeated upwards as often as there is room.
"""

from __future__ import annotations

from math import pi

import numpy as np

from tambour.core.chart import Chart, Gauge
from tambour.core.check import Array
from tambour.core.picture import Picture
from tambour.knit.hands.sizes import GARMENTS
from tambour.knit.hands.yarn import gauge_of
from tambour.knit.sheets.fabric import front
from tambour.knit.sheets.worn import GROUND, SIDE, filled, from_above

SIZES = {"hat": 2, "mitten": 1, "yoke": 2}  # which size of each garment's table
HAT = (21.0, 0.62)  # cm high, and the share below its crown
MITTEN = (24.0, 5.0)  # cm long, and the cm at its top that narrow
THUMB = (7.0, 6.0, 3.4)  # cm: from the cuff to the thumb, its length beside the hand, its width
PIXELS = 8  # to a stitch, of the cloth that is looked at
MARGIN = 0.05


def garments(chart: Chart, repeat: int | None, weight: str) -> Picture:
    """Hat from the side, mitten from its back, yoke from above, in one picture; ``repeat`` stitches of the chart go round
    and round, the whole width without one."""
    gauge = gauge_of(chart, weight)
    wide = repeat or chart.shape[1]
    # What a shape drew in is its first rows' width here: each garment has a shape of its own.
    motif = Chart(
        filled(chart).cells[:, :wide],
        chart.palette,
        gauge=chart.gauge,
        technique=chart.technique,
        backing=chart.backing,
    )
    cloth = front(motif, PIXELS).rgba[..., :3]
    round_ = {name: GARMENTS[name][size][1] for name, size in SIZES.items()}
    yoke = from_above(motif, 10 * round_["yoke"], weight, True).rgba[..., :3]
    parts = [
        _hat(cloth, motif.shape, gauge, round_["hat"]),
        _mitten(cloth, motif.shape, gauge, round_["mitten"]),
        yoke[:: SIDE // 800, :: SIDE // 800],
    ]
    out = np.full((max(p.shape[0] for p in parts), sum(p.shape[1] for p in parts), 4), 255, np.uint8)
    out[..., :3] = GROUND
    x = 0
    for part in parts:
        y = (out.shape[0] - part.shape[0]) // 2
        out[y : y + part.shape[0], x : x + part.shape[1], :3] = part
        x += part.shape[1]
    return Picture(out)


def _at(cloth: Array, shape: tuple[int, int], stitch: Array, row: Array) -> Array:
    """The cloth's colour at places in stitches and rows, the motif going on both ways."""
    rows, wide = shape
    tall, across = cloth.shape[0] / rows, cloth.shape[1] / wide
    y = ((rows - row % rows) * tall - 0.5).astype(int) % cloth.shape[0]
    x = (stitch % wide * across).astype(int) % cloth.shape[1]
    return np.asarray(cloth[y, x], np.float32)


def _frame(width: float, height: float) -> tuple[Array, Array, int, int]:
    """Places in cm of a picture of that size, x from its middle and y from its foot up, twice as fine as it is shown."""
    scale = 800 * (1 - 2 * MARGIN) / 24.0  # pixels to a centimetre
    w, h = int(width * scale * (1 + 2 * MARGIN)), int(height * scale * (1 + 2 * MARGIN))
    x = ((np.arange(2 * w) + 0.5) / 2 - w / 2) / scale
    y = (h * (1 - MARGIN / (1 + 2 * MARGIN)) - (np.arange(2 * h) + 0.5) / 2) / scale
    return x[None], y[:, None], w, h


def _shown(colour: Array, on: Array, w: int, h: int) -> Array:
    shown = np.where(on[..., None], colour, np.array(GROUND, np.float32))
    return np.asarray(np.round(shown.reshape(h, 2, w, 2, 3).mean((1, 3))), np.uint8)


def _hat(cloth: Array, shape: tuple[int, int], gauge: Gauge, round_: float) -> Array:
    """A hat from the side: a cylinder and a round crown, whole repeats about it."""
    high, straight = HAT
    x, y, w, h = _frame(round_ / pi, high)
    copies = max(2, round(10 * round_ / gauge.width / shape[1]))
    up = np.clip((y / high - straight) / (1 - straight), 0, 1)
    r = round_ / (2 * pi) * np.sqrt(1 - up**2)
    on = (np.abs(x) < r) & (y >= 0) & (y < high)
    turn = np.arcsin(np.clip(x / np.maximum(r, 1e-6), -1, 1)) / (2 * pi)  # a quarter of the round to either side
    light = np.sqrt(1 - np.clip(x / np.maximum(r, 1e-6), -1, 1) ** 2) * 0.45 + 0.55
    colour = _at(cloth, shape, (turn * copies + 0.5) * shape[1], np.broadcast_to(10 * y / gauge.height, turn.shape))
    return _shown(colour * light[..., None], on, w, h)


def _mitten(cloth: Array, shape: tuple[int, int], gauge: Gauge, round_: float) -> Array:
    """The back of a mitten with its thumb, the motif amid it."""
    high, top = MITTEN
    low, long_, thick = THUMB
    half = round_ / 4
    x, y, w, h = _frame(round_ / 2 + 2 * thick, high)
    point = np.clip((y - (high - top)) / top, 0, 1)
    hand = (np.abs(x) < half * (1 - 0.85 * point**1.6)) & (y >= 0) & (y < high)
    along = np.clip((y - low) / long_, 0, 1)
    middle = half - 0.2 * thick + along * thick * 0.75
    # It grows out of the gusset, and is rounded at its tip.
    side = (
        thick
        / 2
        * np.sqrt(np.clip((y - low + 3.5) / 4, 0, 1) * np.clip(1 - np.maximum(0, along - 0.6) ** 2 / 0.16, 0, 1))
    )
    thumb = (np.abs(x - middle) < side) & (y < low + long_)
    stitch, row = 10 * x / gauge.width + shape[1] / 2, 10 * y / gauge.height
    colour = _at(cloth, shape, np.broadcast_to(stitch, (y.size, x.size)), np.broadcast_to(row, (y.size, x.size)))
    edge = np.where(hand, 1.0, 0.82)
    return _shown(colour * edge[..., None], hand | thumb, w, h)

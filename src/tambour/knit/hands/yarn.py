"""How much yarn: the chart knows every stitch and every float, so each colour is counted by itself."""

from __future__ import annotations

from math import ceil
from typing import NamedTuple

import numpy as np

from tambour.core.chart import Chart, Gauge
from tambour.core.check import Array
from tambour.knit.hands.bobbins import ENDS, bobbins
from tambour.knit.hands.jacquard import back_cells
from tambour.knit.hands.working import carried, tally
from tambour.weights import WEIGHTS

STITCH = 3.2
"""Yarn in one stitch, in stitch widths (hand knitters count 3 to 3.5)."""

SPARE = 1.1
"""For tails, swatch and joins."""


class Amount(NamedTuple):
    """What one colour takes: stitches, metres with a tenth to spare, yards, grams, whole skeins."""

    color: int
    stitches: int
    metres: float
    yards: float
    grams: float
    skeins: int


def gauge_of(chart: Chart, weight: str) -> Gauge:
    """The chart's gauge, or the usual one of a yarn weight where it has none."""
    return chart.gauge or Gauge(*WEIGHTS[weight].knit)


def amounts(
    chart: Chart,
    weight: str = "dk",
    skein_metres: float | None = None,
    skein_grams: float = 50.0,
    anchored: bool = True,
) -> list[Amount]:
    """The yarn that each colour takes: ``STITCH`` widths for a stitch, a width per stitch for what lies behind.

    Intarsia adds the ends of its bobbins, jacquard what the back bed knits.

    weight : a key of :data:`tambour.weights.WEIGHTS`; gives the gauge where the chart has none, and metres per gram
    skein_metres : metres in a skein (default: by the weight), skein_grams : its mass
    """
    width = gauge_of(chart, weight).width / 1000
    per_gram = skein_metres / skein_grams if skein_metres else WEIGHTS[weight].metres / 100
    behind = carried(chart, anchored)
    hidden: Array = np.zeros(len(chart.palette), np.int64)
    bobbined: Array = np.zeros(len(chart.palette), np.int64)
    if chart.technique == "jacquard":
        hidden = np.bincount(back_cells(chart).ravel(), minlength=len(chart.palette))
    elif chart.technique == "intarsia":
        bobbined = np.bincount([b.color for b in bobbins(chart)], minlength=len(chart.palette))
    made = []
    for color, stitches in enumerate(tally(chart).tolist()):
        if stitches:
            metres = float(STITCH * (stitches + hidden[color]) + behind[color]) * width * SPARE + ENDS * int(
                bobbined[color]
            )
            grams = metres / per_gram
            made.append(Amount(color, stitches, metres, metres / 0.9144, grams, max(1, ceil(grams / skein_grams))))
    return sorted(made, key=lambda a: (-a.stitches, a.color))

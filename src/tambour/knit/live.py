"""Live: a chart as a screen draws it, and the rows that it is knitted in."""

from __future__ import annotations

from typing import Any

import numpy as np

from tambour.color import plain_name
from tambour.core.packed import Packed
from tambour.core.steps import Step, told
from tambour.knit.hands.working import catches, floats, roles, wrong_side
from tambour.knit.hands.written import sentence
from tambour.knit.hands.yarn import gauge_of
from tambour.knit.piece import Piece


def live(piece: Piece) -> Packed:
    """The chart and its masks, row 0 the cast-on row, column 0 the left edge.

    ``cells``, ``start`` (R, C) → ``palette`` (K, 3); ``tone`` (R, C) the brightness aimed at, 0…255; ``pairs`` (R, 2 or K)
    the yarns that a row may be knitted with; ``longest`` (R,) the longest float of each row; ``no_stitch``,
    ``relaxed``, ``locked``, ``caught`` (stitches at which a float is caught behind) (R, C) where the chart has them.
    """
    chart = piece.chart
    rows, stitches = chart.shape
    behind = floats(chart, not piece.free_edges)
    longest = np.zeros(rows, np.int64)
    np.maximum.at(longest, behind.row, behind.length)
    caught = (
        catches(chart, piece.limit, not piece.free_edges)
        if piece.limit and longest.max(initial=0) > piece.limit
        else None
    )
    masks = {"no_stitch": chart.no_stitch, "relaxed": chart.relaxed, "locked": chart.locked, "caught": caught}
    arrays = {
        "cells": chart.cells,
        "start": piece.start,
        "tone": np.round(255 * np.clip(piece.tone, 0, 1)).astype(np.uint8),
        "palette": chart.palette.rgb,
        "pairs": np.asarray(piece.state.pairs, np.uint8),
        "longest": np.minimum(longest, 65535).astype(np.uint16),
        **{name: mask for name, mask in masks.items() if mask is not None},
    }
    gauge, weight = chart.gauge, piece.params.yarn_weight
    knit, called = gauge_of(chart, weight), roles(chart)
    facts = {
        "craft": "knit",
        "unit": "stitch",
        "units": rows * stitches,
        "gauge": [knit.stitches, knit.rows],
        "usual": None if gauge else weight,  # whose gauge it is, where none was given
        "aspect": 1.0 if gauge is None else gauge.width / gauge.height,
        "circular": chart.circular,
        "limit": piece.limit,
        "background": piece.background,
        "dominant": piece.dominant,
        "repeat": None if piece.repeat is None else list(piece.repeat),
        "names": list(chart.palette.names),
        "yarns": [
            " ".join(filter(None, (called.get(k, ""), name or plain_name(rgb))))
            for k, (rgb, name) in enumerate(zip(chart.palette.rgb, chart.palette.names))
        ],
        "codes": list(chart.palette.codes),
        "figures": dict(piece.figures),
    }
    return Packed(arrays, facts)


def steps(piece: Piece) -> dict[str, Any]:
    """The rows in the order of work; a row's units are its stitches, in the direction that it is knitted in."""
    chart = piece.chart
    rows, stitches = chart.shape
    repeat = piece.repeat[0] if piece.repeat else None
    names = roles(chart)
    absent = np.zeros(rows, int) if chart.no_stitch is None else chart.no_stitch.sum(1)
    made = [
        Step(
            f"{'Rnd' if chart.circular else 'Row'} {r + 1}",
            sentence(chart, r, repeat, names),
            r * stitches,
            (r + 1) * stitches,
            stitches - int(absent[r]),
            direction=1 if wrong_side(chart, r) else -1,
        )
        for r in range(rows)
    ]
    return told("knit", "stitch", rows * stitches, made)

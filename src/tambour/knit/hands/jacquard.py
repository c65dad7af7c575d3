"""Jacquard: what the back bed knits while the front bed shows the picture."""

from __future__ import annotations

import numpy as np

from tambour.core.chart import Chart
from tambour.core.check import Array


def used(chart: Chart) -> list[int]:
    """The palette entries that are knitted, in the palette's order, as carriers are numbered."""
    cells = chart.cells if chart.no_stitch is None else chart.cells[~chart.no_stitch]
    found: list[int] = np.unique(cells if chart.behind is None else np.concatenate([cells, chart.behind])).tolist()
    return found


def back_cells(chart: Chart) -> Array:
    """The back of a jacquard chart (R, C) uint8 → palette, row 0 the cast-on row, columns as seen from the right side.

    Birdseye: each needle takes the yarns by turns, one a row, neighbours a turn apart. Stripes: every yarn knits a whole
    row of the back in every row of the front, (R times yarns, C). Picture: its own.
    """
    if chart.behind is not None:
        return chart.behind
    rows, stitches = chart.shape
    yarns = np.array(used(chart), np.uint8)
    if chart.backing == "stripes":
        return np.repeat(np.tile(yarns, rows)[:, None], stitches, axis=1)
    return np.asarray(yarns[(np.arange(rows)[:, None] + np.arange(stitches)[None]) % len(yarns)])

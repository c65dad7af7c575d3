"""Chart: colourwork, a cell per stitch."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tambour.core.check import Array, array, put, within
from tambour.core.errors import LawError
from tambour.core.palette import Palette


@dataclass(frozen=True, slots=True)
class Gauge:
    """Stitches and rows per 10 cm."""

    stitches: float
    rows: float

    def __post_init__(self) -> None:
        if not (self.stitches > 0 and self.rows > 0):
            raise LawError("Gauge: stitches and rows per 10 cm must be above 0")

    @property
    def width(self) -> float:
        """Width of one stitch, mm."""
        return 100.0 / self.stitches

    @property
    def height(self) -> float:
        """Height of one row, mm."""
        return 100.0 / self.rows


@dataclass(frozen=True, eq=False, slots=True)
class Chart:
    """A knitting chart; at most two colours in a row.

    cells : (R, C) uint8 → palette; row 0 is the cast-on row, column 0 the left edge as one sees the right side
    palette : Palette
    no_stitch, relaxed, locked : (R, C) bool or None: cells that are not knitted, cells free of the float limit, cells
        that no solver may change
    circular : knitted in the round (rows wrap)
    gauge : Gauge or None
    """

    cells: Array
    palette: Palette
    no_stitch: Array | None = None
    relaxed: Array | None = None
    locked: Array | None = None
    circular: bool = False
    gauge: Gauge | None = None

    def __post_init__(self) -> None:
        cells = array("Chart.cells", self.cells, np.uint8, (None, None))
        within("Chart.cells", cells, 0, len(self.palette))
        masks = {
            name: None if mask is None else array(f"Chart.{name}", mask, np.bool_, cells.shape)
            for name, mask in (("no_stitch", self.no_stitch), ("relaxed", self.relaxed), ("locked", self.locked))
        }
        if len(self.palette) > 2 and cells.size:
            held = cells if masks["no_stitch"] is None else np.where(masks["no_stitch"], cells[:, :1], cells)
            for r, row in enumerate(held):
                knitted = row if masks["no_stitch"] is None else cells[r][~masks["no_stitch"][r]]
                if len(np.unique(knitted)) > 2:
                    raise LawError(
                        f"Chart.cells: row {r} holds {len(np.unique(knitted))} colours, at most 2 can be knitted"
                    )
        put(self, cells=cells, **masks)

"""Piece: a solved chart, and all that was known when it was solved."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from tambour.core.chart import Chart
from tambour.core.check import Array, array, put, within
from tambour.knit.params import KnitParams


@dataclass(frozen=True, eq=False, slots=True)
class Piece:
    """What the knit craft makes; every array has the chart's shape (R, C), row 0 being the cast-on row.

    chart : the solved chart; for two yarns, palette entry 0 is the darker and 1 the lighter yarn
    params : what was asked
    tone : (R, C) float32 in 0…1: the brightness aimed at, after tone mapping (0 the dark yarn, 1 the light one; with
        more yarns, the luma of the target)
    start : (R, C) uint8 → palette: the start assignment, exactly what the method "none" writes
    limit : longest run of one colour that is allowed, which is the longest float (f in the paper)
    picture : (R, C, 3) uint8 sRGB: the source at chart size, before tone mapping
    dominant : palette entry of the dominant yarn (carried below; it stands out): the one with fewer stitches
    background : palette entry of the main colour (MC): the one with most stitches
    kind : "photograph", "line drawing", "flat art" or "chart" (taken stitch for stitch)
    weights : (R, C) float32 or None: how much a flip costs there
    repeat : (n, k): the chart is a multiple of n stitches plus k; None without a repeat
    textured : (R, C) bool or None: stitches of the middle tones' textures, where the style lays grounds
    figures : what was measured while solving: conflicts, conflicts_before, flips, violations, longest_float …
    state : what :func:`tambour.knit.solve.edit.resolve` needs to solve again after an edit
    """

    chart: Chart
    params: KnitParams
    tone: Array
    start: Array
    limit: int
    picture: Array
    dominant: int
    background: int
    kind: str
    weights: Array | None = None
    repeat: tuple[int, int] | None = None
    figures: Mapping[str, Any] = field(default_factory=dict)
    state: Any = None
    textured: Array | None = None

    @property
    def free_edges(self) -> bool:
        """The first and the last run of a row may be of any length (never so in the round)."""
        return self.params.edges == "free" and not self.chart.circular

    def __post_init__(self) -> None:
        shape = self.chart.cells.shape
        start = array("Piece.start", self.start, np.uint8, shape)
        within("Piece.start", start, 0, len(self.chart.palette))
        put(
            self,
            start=start,
            tone=array("Piece.tone", self.tone, np.float32, shape),
            picture=array("Piece.picture", self.picture, np.uint8, (*shape, 3)),
            textured=None if self.textured is None else array("Piece.textured", self.textured, np.bool_, shape),
            weights=None if self.weights is None else array("Piece.weights", self.weights, np.float32, shape),
        )

"""Rolls: a piece in rows whose edges are sewn to each other stands as a tube at first, its seam at the back."""

from __future__ import annotations

import math
from typing import Final

import numpy as np

from tambour.core.check import Array
from tambour.core.graph import SEWN, StitchGraph

_FEW: Final = 4
"""So few stitches sewn to each other are a fold, and no tube."""


def roll(graph: StitchGraph, x: Array, part: int) -> None:
    """Rolls a flat part, in place, about the way along its seam. x : (N, 3) in stitches, the sheet in x and y.

    Rows sewn last to first run upwards round the tube; rows whose ends are sewn go round it.
    """
    own = slice(graph.parts[part].start, graph.parts[part].end)
    sewn = graph.edges[(graph.edge_kind == SEWN) & (graph.part[graph.edges] == part).all(1)]
    if len(sewn) < _FEW:
        return
    flat = x[own, :2].copy()
    off = np.abs(x[sewn[:, 0], :2] - x[sewn[:, 1], :2]).mean(0)
    seam = x[np.unique(sewn)][:, :2]
    if off[1] > off[0]:  # the first row to the last
        low, wide = float(seam[:, 1].min()), float(np.ptp(seam[:, 1])) + 1.0
        angle = 2.0 * math.pi * (flat[:, 1] - low) / wide
        radius = np.full(len(flat), wide / (2.0 * math.pi))
        high = flat[:, 0]
    else:
        rows = np.round(flat[:, 1], 3)
        angle, radius = np.zeros(len(flat)), np.zeros(len(flat))
        for row in np.unique(rows):
            mine = rows == row
            wide = float(np.ptp(flat[mine, 0])) + 1.0
            angle[mine] = 2.0 * math.pi * (flat[mine, 0] - flat[mine, 0].min() + 0.5) / wide
            radius[mine] = wide / (2.0 * math.pi)
        high = flat[:, 1]
    angle = angle - 0.5 * math.pi  # the seam at the back
    made = np.column_stack([radius * np.cos(angle), high, radius * np.sin(angle)])
    faces = graph.faces[(graph.part[graph.faces] == part).all(1)] - graph.parts[part].start
    a, b, c = (made[faces[:, k]] - made.mean(0) for k in range(3))
    if float((a * np.cross(b, c)).sum()) < 0.0:
        made[:, 0] = -made[:, 0]  # its right side is outside
    x[own] = made

"""Curves: a chart's stitches as knitted loops in space, a curve for each stretch of one yarn, for look development."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from tambour.core.scene import Scene
    from tambour.knit.piece import Piece

POINTS = 24
"""Points of one loop."""
WIDE = 5.0
"""mm of a stitch where no gauge is given."""
PLIES, LAY = 4, 6.0
MOST = 40_000
"""Stitches above which the loops would not fit into memory."""


def curves(piece: Piece) -> Scene:
    """The right side's loops in mm, y up, z towards the eye. Of every point: ``st`` (turns of the lay along the yarn, 0),
    ``twist`` (degrees), ``stitch``, ``row``; of every curve: ``ply``. Floats at the back are not shown.

    Raises TambourError above 40,000 stitches.
    """
    from tambour.core.errors import TambourError
    from tambour.core.paths import Paths
    from tambour.core.scene import Scene
    from tambour.core.strands import Strands
    from tambour.knit.sheets.fabric import RADIUS, aspect_of, loop

    chart = piece.chart
    rows, columns = chart.shape
    if rows * columns > MOST:
        raise TambourError(f"{rows * columns:,} loops are more than {MOST:,}", hint="{--stitches} fewer, or {--crop}")
    turn = loop(aspect_of(chart), POINTS + 1) * [1.0, 1.0, -1.0]  # its z is away from the eye
    width = 100 / chart.gauge.stitches if chart.gauge is not None else WIDE
    height = width / aspect_of(chart)
    knitted = np.ones(chart.shape, np.bool_) if chart.no_stitch is None else ~chart.no_stitch
    coords, colors, stitch, row, sizes = [], [], [], [], []
    for r in range(rows):
        cells = np.where(knitted[r], chart.cells[r].astype(int), -1)
        for stretch in np.split(np.arange(columns), np.flatnonzero(np.diff(cells)) + 1):
            if cells[stretch[0]] < 0:
                continue
            n = len(stretch)
            parts = np.stack([turn + np.array([c, 0.0, 0.0]) for c in range(n)])
            line = np.concatenate([parts[:, :-1].reshape(-1, 3), parts[-1:, -1]])
            coords.append((line + np.array([stretch[0] + 0.5, (r + 0.5) * height / width, 0.0])) * width)
            colors.append(chart.palette.rgb[cells[stretch[0]]])
            stitch.append(r * columns + stretch[0] + np.minimum(np.arange(len(line)) // POINTS, n - 1))
            row.append(np.full(len(line), r))
            sizes.append(len(line))
    offsets = np.r_[0, np.cumsum(sizes)].astype(np.int64)
    xyz = np.concatenate(coords) if coords else np.zeros((0, 3))
    step = np.r_[0.0, np.sqrt((np.diff(xyz, axis=0) ** 2).sum(axis=1))][: len(xyz)]
    step[offsets[:-1]] = 0.0
    along = np.cumsum(step)
    along -= np.repeat(along[offsets[:-1]], np.diff(offsets))
    turns = along / (LAY * 2 * RADIUS * width)
    whole = np.concatenate(stitch) if stitch else np.zeros(0, int)
    told = {
        "st": np.c_[turns, np.zeros(len(turns))].astype(np.float32),
        "twist": (360 * turns).astype(np.float32),
        "stitch": whole.astype(np.int32),
        "row": (np.concatenate(row) if row else whole).astype(np.int32),
    }
    yarn = Strands(
        Paths(xyz, offsets),
        np.full(len(xyz), RADIUS * width),
        np.array(colors, np.uint8).reshape(-1, 3),
        strand_data={"ply": np.full(len(sizes), PLIES, np.int32)},
        point_data=told,
    )
    return Scene((), (yarn,), ("yarn",), root="knit")

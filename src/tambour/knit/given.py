"""A chart that is given, not solved: taken stitch for stitch, measured, and made."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tambour.color import luminance
from tambour.core.chart import Chart
from tambour.core.errors import TambourError
from tambour.core.progress import Progress
from tambour.knit.floats import limit_of, measure
from tambour.knit.hand import roles
from tambour.knit.params import KnitParams
from tambour.knit.piece import Piece
from tambour.knit.resample import gauge_of
from tambour.knit.task import NONE, Task


def taken(chart: Chart, params: KnitParams, progress: Progress) -> Piece:
    """The Piece of a chart as it is; ``--gauge`` and ``--round`` are added to it, nothing is changed.

    Runs above the limit are warned of: they are listed for catching. Raises TambourError for a chart without stitches.
    """
    order = list(roles(chart))
    if not order:
        raise TambourError("the chart has no stitch to knit")
    chart = replace(chart, gauge=gauge_of(params) or chart.gauge, circular=chart.circular or params.round)
    limit = limit_of(params)
    light = luminance(chart.palette.rgb)[chart.cells]
    with progress.stage("solve"):
        task = Task(
            light.astype(np.float32),
            _second(chart),
            limit,
            free=params.edges == "free" and not chart.circular,
            cap=params.edge_run or 1 << 30,
            ring=chart.circular,
            knit=NONE if chart.no_stitch is None else ~chart.no_stitch,
            relaxed=NONE if chart.relaxed is None else chart.relaxed,
        )
        found = measure(task, task.start)
    if found.conflicts:
        progress.warn(
            f"{found.conflicts} stitches stand in runs above {limit}; their floats are listed for catching",
            hint="solve the chart's picture instead, or allow more with --max-float",
            where="--max-float",
        )
    figures = {
        "stitches": found.stitches,
        "rows": chart.shape[0],
        "conflicts": found.conflicts,
        "consistent": round(found.consistent, 2),
        "flips": 0,
        "longest_float": found.longest,
        "violations": found.violations,
        "kind": "chart",
    }
    repeat = None
    if params.repeat:
        n, _, k = params.repeat.partition("+")
        repeat = (int(n), int(k or 0))
    return Piece(
        chart,
        params,
        light.astype(np.float32),
        chart.cells,
        limit,
        chart.palette.rgb[chart.cells],
        dominant=order[min(1, len(order) - 1)],
        background=order[0],
        kind="chart",
        repeat=repeat,
        figures=figures,
    )


def _second(chart: Chart) -> np.ndarray[tuple[int, ...], np.dtype[np.uint8]]:
    """1 where a row's second colour is knitted: the runs of a chart of any number of yarns, as two."""
    cells = chart.cells.astype(np.int16)
    if chart.no_stitch is None:
        low = cells.min(axis=1, keepdims=True)
    else:
        low = np.where(chart.no_stitch, 256, cells).min(axis=1, keepdims=True)
    return np.ascontiguousarray(cells != low, np.uint8)

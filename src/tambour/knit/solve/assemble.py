"""Assemble: solved cells become a Piece: colours instead of bits, the repeat laid out, the law checked once more."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np

from tambour.core.chart import Chart
from tambour.core.check import Array
from tambour.core.palette import Palette
from tambour.core.progress import Progress
from tambour.core.rgb import hexed
from tambour.knit.params import KnitParams
from tambour.knit.picture import resample
from tambour.knit.picture.layout import Layout
from tambour.knit.piece import Piece
from tambour.knit.solve import floats
from tambour.knit.task import Task


@dataclass(frozen=True, eq=False, slots=True)
class State:
    """What it takes to solve again: the task, its two-colour cells, and how they lie in the chart.

    pairs : (R, 2) uint8 → palette: dark and light yarn of each row
    """

    task: Task
    cells: Array
    layout: Layout
    pairs: Array


def assemble(
    state: State,
    palette: Palette,
    kind: str,
    how: str,
    params: KnitParams,
    before: floats.Floats,
    progress: Progress,
) -> Piece:
    """The Piece of solved cells: colours instead of bits, the repeat laid out, the law checked once more."""
    task, layout, tiled = state.task, state.layout, state.layout.tiled
    after = floats.measure(task, state.cells)
    lawful = params.method in ("exact", "diffused", "perceptual") and params.soft is None and not params.check
    if lawful and after.violations:
        raise RuntimeError(f"the {params.method} solver left {after.violations} violations")
    if after.violations and not params.check and params.method != "none" and params.soft is None:
        progress.warn(
            f"{params.method} leaves {after.conflicts} stitches in floats longer than {task.limit}",
            hint="{--method} exact or perceptual leaves none",
        )
    flips = state.cells != task.start
    if task.knit.size:
        flips &= task.knit

    def coloured(bits: Array) -> Array:
        if len(palette) == 2 and (state.pairs[:, 1] > state.pairs[:, 0]).all():
            return tiled(bits)  # a chart that was given may have its lighter yarn first
        return tiled(np.where(bits == 1, state.pairs[:, 1:], state.pairs[:, :1]).astype(np.uint8))

    def optional(mask: Array) -> Array | None:
        return tiled(mask) if mask.size else None

    chart = Chart(
        coloured(state.cells),
        palette,
        no_stitch=optional(~task.knit),
        relaxed=optional(task.relaxed),
        locked=optional(task.locked),
        circular=params.round,
        gauge=resample.gauge_of(params),
    )
    knitted = chart.cells if chart.no_stitch is None else chart.cells[~chart.no_stitch]
    counts = np.array([np.count_nonzero(knitted == k) for k in range(len(palette))])
    figures: dict[str, Any] = {
        "width": chart.cells.shape[1],
        "rows": chart.cells.shape[0],
        "stitches": int(counts.sum()),
        "conflicts": after.conflicts,
        "consistent": round(after.consistent, 2),
        "conflicts_before": before.conflicts,
        "consistent_before": round(before.consistent, 2),
        "flips": int(flips.sum()),
        "longest_float": after.longest,
        "max_float": task.limit,
        "violations": after.violations,
        "method": "check" if params.check else params.method,
        "kind": kind,
        "start": how,
        "floats": {str(k): int(n) for k, n in enumerate(after.histogram) if n},
        "stitches_by_colour": {name_of(palette, k): int(n) for k, n in enumerate(counts)},
    }
    if task.free:
        figures["edge_travel"] = travel(state.cells, task)
    # The dominant yarn is carried below and stands out: the one that draws the figure, so the rarer.
    order = np.argsort(-counts, kind="stable")
    return Piece(
        chart,
        params,
        tiled(task.tone),
        coloured(task.start),
        task.limit,
        tiled(layout.picture),
        int(order[1]) if len(order) > 1 else 0,
        int(order[0]),
        kind,
        tiled(task.weights) if task.weights.size else None,
        layout.repeat,
        figures,
        state,
    )


def name_of(palette: Palette, k: int) -> str:
    """A yarn's name, or its colour as #rrggbb."""
    return palette.names[k] or hexed(palette.rgb[k])


def travel(cells: Array, task: Task) -> int:
    """The farthest, in stitches, that an idle yarn goes at a free edge from its last stitch in a row to its next."""
    farthest = 0
    for c in range(2):
        held = cells == c
        if task.knit.size:
            held &= task.knit
        some = held.any(1)
        first = np.where(some, held.argmax(1), -1)
        last = np.where(some, held.shape[1] - 1 - held[:, ::-1].argmax(1), -1)
        # Rows go to and fro, the first from right to left: the work turns on the left after rows 0, 2, 4 …
        for a, b in pairwise(np.flatnonzero(some).tolist()):
            ends = first if b % 2 else last
            farthest = max(farthest, int(abs(int(ends[b]) - int(ends[a]))))
    return farthest

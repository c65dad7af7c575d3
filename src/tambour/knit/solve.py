"""Solve: from a picture, or an existing chart, to a lawful Piece; and again after an edit."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tambour.core.chart import Chart
from tambour.core.check import Array
from tambour.core.palette import Palette
from tambour.core.picture import Picture
from tambour.core.progress import Progress
from tambour.knit import exact, floats, paper, percept, resample, tone
from tambour.knit.params import KnitParams
from tambour.knit.piece import Piece
from tambour.knit.task import Task

PAPER = ("random-walk", "min-conflict", "gsat", "hybrid", "texture")


def make(source: Picture, params: KnitParams, progress: Progress) -> Piece:
    """The Piece of a picture."""
    limit = floats.limit_of(params)
    with progress.stage("tone"):
        whole = resample.upright(source, params, progress)
        shape = resample.size(params, whole.shape[1], whole.shape[0])
        picture = np.ascontiguousarray(resample.resample(whole, *shape)[::-1])
        raw = tone.brightness(picture, params.light)
        kind = tone.recognise(raw)
        aim = tone.toned(raw, params, limit)
        del raw
    with progress.stage("start_assignment"):
        how = params.start or ("threshold" if kind == "line drawing" else "floyd-steinberg")
        start = tone.assign(aim, how, params.threshold)
    task = Task(aim, start, limit, free=params.edges == "free", ring=params.round, soft=params.soft, seed=params.seed)
    with progress.stage("solve"):
        cells = solved(task, params, progress)
    chart = Chart(
        cells,
        Palette(np.array([[0, 0, 0], [255, 255, 255]], np.uint8), ("black", "white")),
        circular=params.round,
        gauge=resample.gauge_of(params),
    )
    before, after = floats.measure(task, start), floats.measure(task, cells)
    figures = {
        "stitches": after.stitches,
        "conflicts": after.conflicts,
        "consistent": round(after.consistent, 2),
        "conflicts_before": before.conflicts,
        "flips": int((cells != start).sum()),
        "longest_float": after.longest,
        "violations": after.violations,
    }
    return Piece(chart, params, aim, start, limit, picture, 0, 1, kind, figures=figures, state=task)


def solved(task: Task, params: KnitParams, progress: Progress) -> Array:
    """The chart that ``params.method`` makes of the start assignment."""
    if params.method == "none":
        return task.start.copy()
    if params.method in PAPER:
        return paper.solve(task, params.method, params)
    if params.method == "exact":
        return exact.solve(task)
    limit = min(task.limit, percept.LARGEST)
    squash = 1.0
    return percept.solve(replace(task, limit=limit), percept.eye(limit, squash), params.keep, progress=progress)

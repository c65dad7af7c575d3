"""Stages: what every way from a picture to a chart shares: the task, the method, the eye."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tambour.core.check import Array
from tambour.core.params import length
from tambour.core.progress import Progress
from tambour.knit.params import KnitParams
from tambour.knit.picture import resample
from tambour.knit.picture.layout import Layout
from tambour.knit.solve import diffused, exact, floats, percept, sight
from tambour.knit.solve import paper2013 as paper
from tambour.knit.task import Task

PAPER = ("random-walk", "min-conflict", "gsat", "hybrid", "texture")
GRIP = 0.002  # what a weight above 1 adds to the perceptual cost of a flip
ADVICE = 70.0  # percent consistent below which the 2013 paper advises against GSAT alone


def squash_of(params: KnitParams) -> float:
    """Rows per stitch width: 1 without a gauge."""
    gauge = resample.gauge_of(params)
    return gauge.rows / gauge.stitches if gauge else 1.0


def task_of(aim: Array, start: Array, limit: int, params: KnitParams, layout: Layout) -> Task:
    """The Task that ``params`` ask for."""
    return Task(
        aim,
        start,
        limit,
        free=params.edges == "free",
        cap=params.edge_run or 1 << 30,
        ring=params.round or layout.repeat is not None,
        soft=params.soft,
        knit=layout.knit,
        relaxed=np.ones(start.shape, np.bool_) if params.floats == "caught" else layout.relaxed,
        locked=layout.locked,
        weights=layout.weights,
        seed=params.seed,
    )


def advise(before: floats.Floats, params: KnitParams, progress: Progress) -> None:
    """The paper's advice: with less than 70 % consistent, GSAT alone draws lines."""
    if params.method == "gsat" and before.consistent < ADVICE:
        progress.warn(
            f"only {before.consistent:.0f} % of the start assignment is consistent, GSAT alone will draw lines",
            hint="from 70 % on it does well; try {--start} ordered, {--method} hybrid, or {--method} exact",
        )


def solved(task: Task, params: KnitParams, progress: Progress) -> Array:
    """The cells that ``params.method`` makes of the start assignment."""
    if params.method == "none":
        return task.start.copy()
    if params.method in PAPER:
        return paper.solve(task, params.method, params)
    if params.method == "diffused":
        return diffused.solve(task)
    if params.method == "exact":
        return exact.solve(task, tidy=0.0 if params.style in ("graphic", "texture") else params.tidy)
    if task.limit > percept.LARGEST:
        progress.warn(f"perceptual keeps floats to {percept.LARGEST} stitches, though {task.limit} are allowed")
    return percept.solve(
        seen_task(task, params),
        sight_of(task.limit, params),
        1.0 if priced(task, params) else 0.0,
        params.sweeps or sweeps_for(task),
        progress,
    )


def sweeps_for(task: Task) -> int:
    """Sweeps over the rows: until nothing changes, but few over very large charts, whose first ones gain the most."""
    return 8 if task.start.size <= 1 << 20 else 3 if task.start.size <= 1 << 22 else 2


def priced(task: Task, params: KnitParams) -> bool:
    """Whether flips cost anything in the perceptual energy."""
    return params.keep > 0 or task.weights.size > 0


def seen_task(task: Task, params: KnitParams) -> Task:
    """The task as the perceptual solver takes it: a limit it can tell apart, and weights that are whole prices."""
    limit = min(task.limit, percept.LARGEST)
    if not priced(task, params):
        return replace(task, limit=limit)
    weights = task.weights if task.weights.size else np.ones(task.start.shape, np.float32)
    return replace(task, limit=limit, weights=(params.keep * weights + GRIP * (weights - 1)).astype(np.float32))


def sight_of(limit: int, params: KnitParams) -> percept.Eye:
    """The eye for these params: with a gauge it sees rows as flat as they are knitted.

    Plain charts keep the eye of two scales; where the style says from how far one looks, it is the eye at that distance.
    """
    limit = min(limit, percept.LARGEST)
    if params.seen_from is None:
        return percept.eye(limit, squash_of(params))
    return sight.eye(limit, resample.gauge_of(params), length(params.seen_from) / 1000)


def mirrored(task: Task, cells: Array) -> Array:
    """``cells`` (R, C) with each row's right half the mirror of its left, or its left that of its right, whichever
    changes less of the start; a row whose both mirrors break the law stays as it was solved."""
    stitches = cells.shape[1]
    half = stitches // 2
    left, right = cells[:, :half], cells[:, stitches - half :]
    out = cells.copy()
    least = np.full(len(cells), np.inf)
    weights = task.weights if task.weights.size else np.ones(cells.shape, np.float32)
    for made in (np.concatenate([left, left[:, ::-1]], 1), np.concatenate([right[:, ::-1], right], 1)):
        made = np.ascontiguousarray(made)
        price = (weights * (made != task.start)).sum(1)
        lawful = np.array(
            [not floats.measure(task.rows(r, r + 1), made[r : r + 1]).violations for r in range(len(made))]
        )
        better = lawful & (price < least)
        out[better], least[better] = made[better], price[better]
    return out

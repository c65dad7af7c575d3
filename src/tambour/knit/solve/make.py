"""Solve: from a picture, or an existing chart, to a lawful Piece."""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Any

import numpy as np

from tambour.core.chart import Chart
from tambour.core.check import Array
from tambour.core.errors import TambourError
from tambour.core.palette import Palette
from tambour.core.params import length
from tambour.core.picture import Picture
from tambour.core.progress import Progress
from tambour.knit.hands.charts import chart_of, two_per_row
from tambour.knit.params import KnitParams
from tambour.knit.picture import resample, tone
from tambour.knit.picture.grounds import laid
from tambour.knit.picture.layout import Layout, lay
from tambour.knit.picture.prepare import mixed, prepared
from tambour.knit.picture.regions import divided
from tambour.knit.picture.style import Style, chosen, of_plain, settled
from tambour.knit.piece import Piece
from tambour.knit.solve import exact, floats, percept, sight
from tambour.knit.solve import paper2013 as paper
from tambour.knit.task import NONE, PLAIN, Task

PAPER = ("random-walk", "min-conflict", "gsat", "hybrid", "texture")
GRIP = 0.002  # what a weight above 1 adds to the perceptual cost of a flip
ADVICE = 70.0  # percent consistent below which the 2013 paper advises against GSAT alone


@dataclass(frozen=True, eq=False, slots=True)
class State:
    """What it takes to solve again: the task, its two-colour cells, and how they lie in the chart.

    pairs : (R, 2) uint8 → palette: dark and light yarn of each row
    """

    task: Task
    cells: Array
    layout: Layout | None
    pairs: Array


def make(source: Picture | Chart, params: KnitParams, progress: Progress) -> Piece:
    """The Piece of a picture, or of a chart that is to be mended or checked.

    Raises TambourError for pictures, masks and limits that cannot be used together.
    """
    limit = floats.limit_of(params)
    if params.edge_stitches > limit and params.edges == "anchored":
        raise TambourError(
            f"{params.edge_stitches} edge stitches of one colour are longer than a float may be ({limit})",
            where="{--edge-stitches}",
        )
    if limit == 1 and params.floats == "short" and not params.check:
        progress.warn(
            "with floats of one stitch every row is a check, whatever the picture",
            hint="{--max-float} 3 and more leave room for one; {--floats} caught leaves it as it is",
        )
    if isinstance(source, Chart) or params.check:
        wanted = params.model_copy(update={"method": params.method or "exact", "style": "plain"})
        return of_chart(source, wanted, limit, progress)
    if params.yarns > 2:
        from tambour.knit.solve import yarns

        return yarns.make(source, params, limit, progress)
    with progress.stage("tone"):
        layout = lay(source, params, progress)
        luma = tone.brightness(layout.picture, "code")
        style = chosen(layout.picture, luma, params)
        if style.name != "plain" and of_plain(params):
            progress.warn(
                f"{style.name} has no part for {{--detail}}, {{--threshold}} and {{--patches}}: they are for plain"
            )
        params = settled(params, style)
        palette = two_yarns(layout.picture, params, progress)
        aim = aimed(layout, luma, palette, style, params, limit)
    with progress.stage("start_assignment"):
        start, weights, textured, how = started(aim, layout, style, params, limit)
        if layout.frame.size:
            start[layout.frame] = layout.pattern[layout.frame]
    if params.gauge is None and params.stitches is not None:
        progress.warn(
            "stitches are taken as square, though knitted ones are wider than tall",
            hint="knit a swatch and give its stitches x rows in 10 cm, such as {--gauge} 24x32",
        )
    task = task_of(aim, start, limit, params, replace(layout, weights=weights))
    piece = finished(task, layout, palette, style.kind, how, params, progress)
    told = {"style": style.name, "why": style.why, "technique": "stranded", "seen_from": style.metres}
    return replace(
        piece,
        textured=layout.tiled(textured) if textured.size else None,
        figures={**told, **piece.figures},
    )


def aimed(layout: Layout, luma: Array, palette: Palette, style: Style, params: KnitParams, limit: int) -> Array:
    """(R, C) float32: the tone that each stitch should have, 0 the dark yarn and 1 the light one."""
    squash = squash_of(params)
    if style.name == "plain":
        raw = luma if params.light == "code" else tone.brightness(layout.picture, params.light)
        aim = tone.toned(raw, params, limit)
    else:
        aim = prepared(layout.picture, params, squash, style.flat)
    if style.name == "tonal":
        if params.light == "linear":
            luma = np.sort(tone.brightness(palette.rgb[None], "code")[0])
            aim = mixed(aim, float(luma[0]), float(luma[-1]))
        low, high = tone.reach(limit, tone.amount(params.tone))
        aim = np.ascontiguousarray(low + aim * np.float32(high - low), np.float32)
    if layout.frame.size:
        aim[layout.frame] = layout.pattern[layout.frame]
    return aim


def started(
    aim: Array, layout: Layout, style: Style, params: KnitParams, limit: int
) -> tuple[Array, Array, Array, str]:
    """(start assignment, weights of its flips, where it is a texture, what it is called) of a style."""
    if style.name in ("graphic", "texture"):
        tones = params.tones or (4 if style.name == "texture" else None)
        found, tones = divided(aim, tones, style.flat)
        start, weights, textured = laid(found, tones, limit, squash_of(params), params.ground)
        return start, weights * layout.weights if layout.weights.size else weights, textured, f"{tones} tones"
    how = params.start or ("threshold" if style.kind == "line drawing" else "floyd-steinberg")
    if how == "patches":
        from tambour.knit.solve import texture

        return texture.assign(aim, limit, params), layout.weights, NONE, how
    return tone.assign(aim, how, params.threshold), layout.weights, NONE, how


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


def two_yarns(picture: Array, params: KnitParams, progress: Progress) -> Palette:
    """Dark and light yarn: black and white unless colours, a shade card or a stash are given."""
    if not params.colors and params.card == "none" and params.stash is None:
        return Palette(np.array([[0, 0, 0], [255, 255, 255]], np.uint8), ("black", "white"))
    from tambour.knit.picture import shades

    return shades.palette_of(picture, params, progress)


def finished(
    task: Task, layout: Layout, palette: Palette, kind: str, how: str, params: KnitParams, progress: Progress
) -> Piece:
    """Solve a two-yarn task and put the Piece together."""
    before = floats.measure(task, task.start)
    advise(before, params, progress)
    with progress.stage("solve"):
        cells = solved(task, params, progress)
    pairs = np.tile(np.array([0, 1], np.uint8), (len(cells), 1))
    return assemble(State(task, cells, layout, pairs), palette, kind, how, params, before, progress)


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
    if params.method == "exact":
        return exact.solve(task, tidy=0.0 if params.style in ("graphic", "texture") else params.tidy)
    if task.limit > percept.LARGEST:
        progress.warn(f"perceptual keeps floats to {percept.LARGEST} stitches, though {task.limit} are allowed")
    return percept.solve(
        seen_task(task, params),
        sight_of(task.limit, params),
        1.0 if priced(task, params) else 0.0,
        sweeps_for(task),
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
    task, layout = state.task, state.layout
    after = floats.measure(task, state.cells)
    lawful = params.method in ("exact", "perceptual") and params.soft is None and not params.check
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
    tiled = layout.tiled if layout else (lambda cells: cells)

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
    picture = layout.picture if layout else np.ascontiguousarray(palette.rgb[coloured(task.start)])
    return Piece(
        chart,
        params,
        tiled(task.tone),
        coloured(task.start),
        task.limit,
        tiled(picture) if layout else picture,
        int(order[1]) if len(order) > 1 else 0,
        int(order[0]),
        kind,
        tiled(task.weights) if task.weights.size else None,
        layout.repeat if layout else None,
        figures,
        state,
    )


def name_of(palette: Palette, k: int) -> str:
    """A yarn's name, or its colour as #rrggbb."""
    return palette.names[k] or "#" + bytes(palette.rgb[k].tolist()).hex()


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


def of_chart(source: Picture | Chart, params: KnitParams, limit: int, progress: Progress) -> Piece:
    """The Piece of an existing chart: checked, or mended by the method that was asked for."""
    with progress.stage("start_assignment"):
        chart = source if isinstance(source, Chart) else chart_of(source)
        bits, pairs = two_per_row(chart)
        empty = chart.cells.shape[1] == 0 or chart.cells.shape[0] == 0
        if empty:
            raise TambourError("the chart has no stitches")
        task = Task(
            bits.astype(np.float32),
            bits,
            limit,
            free=params.edges == "free",
            cap=params.edge_run or 1 << 30,
            ring=params.round or chart.circular,
            soft=params.soft,
            knit=NONE if chart.no_stitch is None else ~chart.no_stitch,
            relaxed=NONE if chart.relaxed is None else chart.relaxed,
            locked=NONE if chart.locked is None else chart.locked,
            weights=PLAIN,
            seed=params.seed,
        )
    before = floats.measure(task, bits)
    with progress.stage("solve"):
        cells = bits.copy() if params.check else solved(task, params, progress)
    wanted = params if not chart.circular else params.model_copy(update={"round": True, "edges": "anchored"})
    palette = chart.palette
    if len(palette) < 2:
        other = 0 if int(palette.rgb[0].sum()) > 382 else 255
        palette = Palette(np.vstack([palette.rgb, [[other] * 3]]).astype(np.uint8), (*palette.names, ""))
    return assemble(State(task, cells, None, pairs), palette, "chart", "chart", wanted, before, progress)

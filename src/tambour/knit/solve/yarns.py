"""More than two yarns, two in a row: which pair each row has, and the lawful row of that pair that looks most like it.

Colours mix between rows as well as along them, so the pair of a row is chosen by what the rows before it have left to be
shown: for each pair the exact best row is found (eight pairs at a time) and the pair that leaves least error, with a
price for changing it, is taken. The rows' costs then go through a dynamic programme over rows that keeps to a limit of
changes, and sweeps over the rows with their pairs fixed end it. Errors are taken in the three channels alike.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from tambour import color
from tambour.core.check import Array
from tambour.core.errors import Problem, TambourError, option
from tambour.core.palette import Palette
from tambour.core.progress import Progress
from tambour.knit.params import KnitParams
from tambour.knit.picture import shades, tone
from tambour.knit.picture.layout import Layout
from tambour.knit.picture.style import Style, settled
from tambour.knit.piece import Piece
from tambour.knit.solve import blocks, exact, floats, percept, stages
from tambour.knit.solve.assemble import State, assemble
from tambour.knit.solve.lanes import FORBIDDEN
from tambour.knit.solve.pairs import colour_batches, pair_rows
from tambour.knit.task import Task

SWITCH = 1e-3  # squared error on every stitch of a row that a change of pair is worth
SWEEPS = 4


def make(layout: Layout, style: Style, params: KnitParams, limit: int, progress: Progress) -> Piece:
    """The Piece of a picture in as many yarns as ``params`` ask for.

    Raises TambourError for what needs two yarns only (locked stitches, frames, weights, patches), and for yarns that
    have too little contrast to share any row.
    """
    only = [
        f"{{{option(name)}}}" for name in params.said(("lock", "weights", "border", "edge_stitches", "keep", "focus"))
    ]
    only += ["{--start} patches"] * (params.start == "patches")
    if only:
        why = f"this is for two yarns ({params.count} were asked for)"
        raise TambourError([Problem(why, where=where) for where in only])
    with progress.stage("tone"):
        params = settled(params, style)
        kind = style.kind
        areas = style.name in ("graphic", "texture")
        if areas:
            palette, cost = blocks.yarns_of(layout, style, params)
        else:
            palette = shades.palette_of(layout.picture, params, progress)
        space = space_of(palette, params)
        aim = target(layout.picture, space, params, limit)
        possible = pairs_of(palette, params)
    with progress.stage("start_assignment"):
        if areas:
            chosen, start, weights = blocks.started(cost, possible, layout, limit, params)
            layout = replace(layout, weights=weights)
            pairs = possible[chosen]
            projected, how = project(aim, space, pairs), "blocks"
        else:
            blank = np.zeros(aim.shape[:2], np.uint8)
            seen = min(limit, percept.LARGEST)
            task = stages.task_of(blank.astype(np.float32), blank, seen, params, layout)
            eye = stages.sight_of(limit, params)
            chosen, bits = choose(task, aim, space, possible, eye, params)
            pairs = possible[chosen]
            projected = project(aim, space, pairs)
            how = params.start or ("threshold" if kind == "line drawing" else "floyd-steinberg")
            start = tone.assign(projected, how, params.threshold)
    whole = stages.task_of(projected, start, limit, params, layout)
    before = floats.measure(whole, start)
    stages.advise(before, params, progress)
    with progress.stage("solve"):
        if params.method == "perceptual" and not areas:
            cells = sweep(task, aim, space, pairs, bits, eye, params.sweeps or SWEEPS)
        else:
            cells = stages.solved(whole, params, progress)
    switches = int((chosen[1:] != chosen[:-1]).sum())
    piece = assemble(State(whole, cells, layout, pairs), palette, kind, how, params, before, progress)
    if kind == "photograph" and areas and switches:
        other = "jacquard" if params.machine else "intarsia"
        progress.warn(
            f"two of the {len(palette)} yarns in a row: {switches} change(s) of them go right across the photograph",
            hint=f"{{--yarns}} 2 keeps its shapes whole; {{--technique}} {other} has all yarns in a row",
        )
    told = {"style": style.name, "why": style.why, "technique": "stranded", "seen_from": style.metres}
    more = {"yarns": len(palette), "switches": switches, **colour_error(piece, aim, space)}
    figures = {**told, **piece.figures, **more}
    return replace(piece, weights=None, figures=figures)


def colour_error(piece: Piece, aim: Array, space: Array) -> dict[str, float]:
    """PSNR of the chart's colours against the target, both blurred by 1.5 stitches, over all channels."""
    from scipy.ndimage import gaussian_filter

    wide = aim.shape[1]
    error = space[piece.chart.cells[:, :wide]] - aim
    if piece.chart.no_stitch is not None:
        error = np.where(piece.chart.no_stitch[:, :wide, None], 0, error)
    mean = float((gaussian_filter(error.astype(np.float32), (1.5, 1.5, 0)) ** 2).mean())
    return {"colour_psnr": round(float(-10 * np.log10(max(mean, 1e-12))), 2)}


def space_of(palette: Palette, params: KnitParams) -> Array:
    """(K, 3) float32: the yarns where errors are taken: code values in 0…1, or linear light."""
    rgb = palette.rgb / 255.0
    return np.asarray(color.linear(rgb) if params.light == "linear" else rgb, np.float32)


def target(picture: Array, space: Array, params: KnitParams, limit: int) -> Array:
    """(R, C, 3) float32: the picture, its contrast drawn in towards the yarns' middle as far as ``tone`` asks."""
    t = picture.astype(np.float32) / np.float32(255)
    if params.light == "linear":
        t = color.linear(t).astype(np.float32)
    t = tone.adjusted(t, params)
    low, high = tone.reach(limit, tone.amount(params.tone))
    middle = (space.min(0) + space.max(0)) / 2
    return np.ascontiguousarray(middle + (t - middle) * np.float32(high - low), np.float32)


def pairs_of(palette: Palette, params: KnitParams) -> Array:
    """(N, 2) uint8: the pairs that may share a row, dark and light, by their contrast."""
    count = len(palette)
    rgb = [(int(c[0]), int(c[1]), int(c[2])) for c in palette.rgb]
    found = [
        (a, b)
        for a in range(count)
        for b in range(a + 1, count)
        if shades.contrast(rgb[a], rgb[b]) >= params.min_contrast
    ]
    if not found:
        raise TambourError(
            f"no two of the yarns have a contrast of {params.min_contrast:g}, so none can share a row",
            where="{--min-contrast}",
        )
    return np.array(found, np.uint8)


def project(aim: Array, space: Array, pairs: Array) -> Array:
    """(R, C) float32 in 0…1: where each target colour lies between its row's dark and its light yarn."""
    dark, light = space[pairs[:, 0]], space[pairs[:, 1]]
    way = light - dark
    share = ((aim - dark[:, None]) * way[:, None]).sum(2) / (way * way).sum(1)[:, None]
    return np.ascontiguousarray(np.clip(share, 0, 1), np.float32)


def choose(
    task: Task, aim: Array, space: Array, possible: Array, eye: percept.Eye, params: KnitParams
) -> tuple[Array, Array]:
    """(R,) index of each row's pair, and (R, C) uint8 bits of a first chart with these pairs."""
    rows, stitches = aim.shape[:2]
    price = params.switch * SWITCH * stitches
    chosen, bits, error = first_pass(task, aim, space, possible, eye, price, np.full(rows, -1, np.int64))
    if len(possible) == 1:
        return chosen, bits
    costs = np.zeros((rows, len(possible)), np.float64)
    table_of(task, aim, space, possible, eye, error, costs)
    better = blocks.over_rows(costs, price, params.max_switches)
    again, more, rest = first_pass(task, aim, space, possible, eye, price, better)
    changes = int((chosen[1:] != chosen[:-1]).sum())
    fits = params.max_switches is None or changes <= params.max_switches
    old = energy(error, eye) + price * changes
    new = energy(rest, eye) + price * int((again[1:] != again[:-1]).sum())
    return (chosen, bits) if fits and old <= new else (again, more)


def energy(error: Array, eye: percept.Eye) -> float:
    """The perceptual energy of an error (R, C, 3)."""
    from scipy.ndimage import correlate1d

    total = 0.0
    for across, down in zip(eye.across.astype(np.float64), eye.down.astype(np.float64)):
        along = correlate1d(error.astype(np.float64), np.r_[across[:0:-1], across], axis=1, mode="constant")
        total += float((error * correlate1d(along, np.r_[down[:0:-1], down], axis=0, mode="constant")).sum())
    return total


def masks(task: Task) -> tuple[Array, Array, float]:
    """Masks and the price of a long window, as the kernels take them."""
    return task.knit, task.relaxed, float(FORBIDDEN) if task.soft is None else task.soft


def each_pair(
    task: Task, aim: Array, space: Array, possible: Array, eye: percept.Eye
) -> Callable[[int, Array, Array, Array], None]:
    """What fills ``costs`` (N,) and ``out`` (N, C) of row y: the least error with each of N pairs, and its stitches; all other
    rows are as ``error`` (R, C, 3) has them: called as (y, error, costs, out)."""
    table = percept.trellis(eye.across, eye.down)
    knit, relaxed, soft = masks(task)
    first, ways = space[possible[:, 0]], space[possible[:, 1]] - space[possible[:, 0]]
    law = (task.limit, task.free, task.cap)

    def row(y: int, error: Array, costs: Array, out: Array) -> None:
        pair_rows(y, error, aim, first, ways, knit, relaxed, soft, *law, eye.across, eye.down, table, costs, out)

    return row


def first_pass(
    task: Task, aim: Array, space: Array, possible: Array, eye: percept.Eye, price: float, fixed: Array
) -> tuple[Array, Array, Array]:
    """(pairs, bits, error): row by row upwards, each the best given those below; ``fixed`` pairs (or -1) are kept."""
    rows, stitches = aim.shape[:2]
    bits = np.zeros((rows, stitches), np.uint8)
    error = np.zeros(aim.shape, np.float32)
    chosen = np.zeros(rows, np.int64)
    row = each_pair(task, aim, space, possible, eye)
    for y in range(rows):
        costs = np.zeros(len(possible))
        out = np.zeros((len(possible), stitches), np.uint8)
        row(y, error, costs, out)
        if y and price:
            costs[np.arange(len(possible)) != chosen[y - 1]] += price
        k = int(costs.argmin()) if fixed[y] < 0 else int(fixed[y])
        chosen[y] = k
        line = out[k : k + 1]
        if task.ring:
            sub = task.rows(y, y + 1)
            line = exact.solve(
                Task(sub.tone, line, task.limit, ring=True, knit=sub.knit, relaxed=sub.relaxed, seed=task.seed)
            )
        bits[y] = line[0]
        error[y] = space[possible[k]][bits[y]] - aim[y]
        if task.knit.size:
            error[y][~task.knit[y]] = 0
    return chosen, bits, error


def table_of(
    task: Task, aim: Array, space: Array, possible: Array, eye: percept.Eye, error: Array, costs: Array
) -> None:
    """Fill ``costs`` (R, N): the least error of each row with each pair, all other rows as they are."""
    row = each_pair(task, aim, space, possible, eye)
    out = np.zeros((len(possible), aim.shape[1]), np.uint8)
    for y in range(len(aim)):
        row(y, error, costs[y], out)


def sweep(task: Task, aim: Array, space: Array, pairs: Array, bits: Array, eye: percept.Eye, sweeps: int) -> Array:
    """(R, C) uint8: the chart after sweeps of exact row steps with the pairs fixed."""
    error = space[np.where(bits == 1, pairs[:, 1:], pairs[:, :1])] - aim
    if task.knit.size:
        error[~task.knit] = 0
    error = np.ascontiguousarray(error, np.float32)
    table = percept.trellis(eye.across, eye.down)
    knit, relaxed, soft = masks(task)
    dark = space[pairs[:, 0]]
    ways = space[pairs[:, 1]] - dark
    reach = eye.down.shape[1] - 1
    for turn in range(sweeps):
        changed = np.zeros(len(bits), np.bool_)
        for phase in range(min(reach + 1, len(bits))):
            mine = np.arange(phase, len(bits), reach + 1)
            colour_batches(
                mine,
                bits,
                error,
                aim,
                dark,
                ways,
                knit,
                relaxed,
                soft,
                task.limit,
                task.free,
                task.cap,
                task.ring,
                turn,
                eye.across,
                eye.down,
                table,
                changed,
            )
        if not changed.any():
            break
    return bits

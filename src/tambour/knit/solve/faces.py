"""Faces: two pictures on one double-bed cloth, in front and behind, each row solved exactly under the laws of its yarns.

What a row cannot show is handed to the next one, a half to the same stitch and a quarter to either side, in linear light.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from tambour import color
from tambour.core.chart import Chart
from tambour.core.check import Array
from tambour.core.progress import Progress
from tambour.knit.params import KnitParams
from tambour.knit.picture import resample, tone, wools
from tambour.knit.picture.layout import Layout
from tambour.knit.picture.style import Style
from tambour.knit.piece import Piece
from tambour.knit.solve import twofold
from tambour.knit.solve.assemble import name_of

MORE = 4  # stitches in which every yarn is used, more than there are yarns
HELD = 0.5  # linear light: the most that is handed on, so that what no yarn can show does not pile up


def make(layout: Layout, style: Style, params: KnitParams, progress: Progress) -> Piece:
    """The Piece of two pictures, the second being ``params.behind``, brought to the first one's stitches.

    Raises TambourError for laws that no row can keep.
    """
    front = layout.picture
    rows, stitches = front.shape[:2]
    with progress.stage("tone"):
        plain = params.model_copy(update={"crop": None, "rotate": "0"})
        whole = resample.upright(params.behind, plain, progress)
        back = np.ascontiguousarray(resample.resample(whole, rows, stitches)[::-1, ::-1])
        palette = wools.chosen(np.concatenate([front, back]), params, style.flat)
        light = color.linear(np.arange(256) / 255).astype(np.float32)
        aim = np.stack([light[front], light[back]], 2).reshape(rows, 2 * stitches, 3)
    use = params.use_within or min(len(palette) + MORE, twofold.widest(len(palette)))
    # What no row can show would only be seen through the other picture: both are drawn in to the most that one yarn may
    # have of a row where both faces want it.
    middle = light[palette.rgb].mean(0)
    most = (use - len(palette) + 1) / use
    aim = np.asarray(middle + (aim - middle) * (1 - tone.amount(params.tone) * (1 - most)), np.float32)
    room = twofold.Room.of(2 * stitches, len(palette), use, params.cross_within)
    with progress.stage("solve"):
        line, proven = dithered(aim, light[palette.rgb], room, progress)
    cells, behind = (np.ascontiguousarray(line[:, k::2]) for k in (0, 1))
    broken, uncrossed = laws(line, len(palette), use, params.cross_within)
    if broken or uncrossed:
        raise RuntimeError(f"{broken} windows lack a yarn, {uncrossed} do not cross")
    chart = Chart(
        cells,
        palette,
        gauge=resample.gauge_of(params),
        technique="jacquard",
        backing="picture",
        behind=behind,
    )
    told = {
        "style": "tonal",
        "why": "two pictures: both faces are dithered under the laws of their yarns",
        "seen_from": style.metres,
        "method": "twofold",
        "kind": style.kind,
        "use_within": use,
        "cross_within": params.cross_within,
        "rows_proven": proven,
        "violations": broken + uncrossed,
    }
    settled = {"technique": "jacquard", "style": "tonal", "seen_from": params.seen_from or f"{style.metres:g}m"}
    return assembled(chart, front, params.model_copy(update=settled), told)


def of_chart(chart: Chart, params: KnitParams) -> Piece:
    """The Piece of a two-faced chart that was given: as it is."""
    rgb = np.ascontiguousarray(chart.palette.rgb[chart.cells])
    told = {"style": "tonal", "why": "a chart is taken as it is", "method": "check", "kind": "chart", "violations": 0}
    return assembled(chart, rgb, params.model_copy(update={"technique": "jacquard", "style": "tonal"}), told)


@dataclass(frozen=True, slots=True)
class Yarns:
    """What screens ask of a piece's state: the palette entries that each row may hold, all of them."""

    rows: int
    count: int

    @property
    def pairs(self) -> Array:
        """(R, K) uint8."""
        return np.tile(np.arange(self.count, dtype=np.uint8), (self.rows, 1))


def assembled(chart: Chart, picture: Array, params: KnitParams, told: dict[str, Any]) -> Piece:
    """The Piece of a two-faced chart; ``told`` is the report's."""
    behind = chart.cells if chart.behind is None else chart.behind
    counts = np.bincount(np.concatenate([chart.cells, behind]).ravel(), minlength=len(chart.palette))
    order = np.argsort(-np.bincount(chart.cells.ravel(), minlength=len(chart.palette)), kind="stable")
    rows, stitches = chart.shape
    figures = {
        **told,
        "technique": "jacquard",
        "width": stitches,
        "rows": rows,
        "stitches": 2 * rows * stitches,
        "yarns": len(chart.palette),
        "longest_float": 0,
        "stitches_by_colour": {name_of(chart.palette, k): int(n) for k, n in enumerate(counts)},
    }
    return Piece(
        chart,
        params,
        np.ascontiguousarray(tone.brightness(picture, "code")),
        chart.cells,
        stitches,
        picture,
        int(order[1]) if len(order) > 1 else 0,
        int(order[0]),
        told["kind"],
        None,
        None,
        figures,
        Yarns(rows, len(chart.palette)),
    )


def dithered(aim: Array, yarns: Array, room: twofold.Room, progress: Progress, step: int = 2) -> tuple[Array, int]:
    """(R, N) uint8, the yarns of lines whose faces take turns, from the top row (the last) down, and how many rows are proven.

    aim : (R, N, 3) float32, yarns : (K, 3) float32, both where errors are taken; step : from a stitch to its neighbour
    on the same face
    """
    rows, n = aim.shape[:2]
    out = np.zeros((rows, n), np.uint8)
    error = np.zeros((n, 3), np.float32)
    proven = 0
    for k, y in enumerate(range(rows - 1, -1, -1)):
        want = aim[y] + np.clip(error, -HELD, HELD)
        cost = ((want[:, None] - yarns[None]) ** 2).sum(2)
        line, sure = twofold.solve(cost, room)
        proven += sure
        out[y] = line
        rest = want - yarns[line]
        error = rest / 2
        if n > step:
            error[step:] += rest[:-step] / 4
            error[:-step] += rest[step:] / 4
        progress.step(k + 1, rows)
    return out, proven


def laws(lines: Array, yarns: int, use: int, cross: int) -> tuple[int, int]:
    """How many windows of ``lines`` (R, N), faces by turns, lack a yarn, and how many have none on both faces."""
    lacking = uncrossed = 0
    n = lines.shape[1]
    if n >= use:
        at = np.lib.stride_tricks.sliding_window_view(lines, use, axis=1)
        lacking = sum(int((~(at == k).any(2)).sum()) for k in range(yarns))
    if n >= cross:
        even = np.arange(n) % 2 == 0
        crossed = np.zeros((len(lines), n - cross + 1), np.bool_)
        for k in range(yarns):
            mine = lines == k
            both = [
                np.lib.stride_tricks.sliding_window_view(mine & face, cross, axis=1).any(2) for face in (even, ~even)
            ]
            crossed |= both[0] & both[1]
        uncrossed = int((~crossed).sum())
    return lacking, uncrossed

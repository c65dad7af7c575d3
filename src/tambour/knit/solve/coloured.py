"""Coloured: intarsia and jacquard, where a row may hold any of the yarns: areas of plain colour instead of a law of floats."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from tambour.core.chart import Chart
from tambour.core.check import Array
from tambour.core.palette import Palette
from tambour.core.progress import Progress
from tambour.knit.params import KnitParams
from tambour.knit.picture import resample, tone, wools
from tambour.knit.picture.layout import Layout, unframed
from tambour.knit.picture.prepare import prepared
from tambour.knit.picture.style import NEAR, Style, suggested
from tambour.knit.piece import Piece
from tambour.knit.solve import areas
from tambour.knit.solve.assemble import name_of
from tambour.knit.solve.stages import squash_of

LEAST = {"intarsia": 3, "jacquard": 1}  # stitches of an area in a row: a bobbin for fewer is not worth its two ends
BORDER = {"intarsia": 0.008, "jacquard": 0.004}  # squared distance that a border is worth
FEWEST = {"intarsia": 10, "jacquard": 0}  # stitches of an area, all its rows together, in a photograph
SOFT = 0.02  # squared distance of neighbours at which the price of a border between them has fallen to a third
FIXED = np.float32(1e6)
BESIDE = "set the stitches beside it, too, and it is an area for a bobbin of its own"


@dataclass(frozen=True, eq=False, slots=True)
class Field:
    """What it takes to change it by hand: how many yarns, the narrowest area it was solved for, how cells lie in the chart,
    (R, C) their yarns, and which are held."""

    yarns: int
    least: int
    layout: Layout
    cells: Array
    locked: Array

    @property
    def pairs(self) -> Array:
        """(R, K) uint8: the palette entries that each row may hold: all."""
        return np.tile(np.arange(self.yarns, dtype=np.uint8), (len(self.cells), 1))


def make(layout: Layout, style: Style, params: KnitParams, exact: bool, progress: Progress) -> Piece:
    """The Piece of a picture in areas: intarsia, or one picture on a double bed. With ``exact`` each stitch has the yarn
    nearest to it, however narrow an area is: pixel art, a stitch for each pixel.

    Raises TambourError for what does not fit together.
    """
    least = 1 if exact else LEAST[params.technique]
    with progress.stage("tone"):
        params = params.model_copy(update={"style": style.name, "seen_from": params.seen_from or f"{style.metres:g}m"})
        palette, cost = costs(layout, params, style, exact)
    with progress.stage("start_assignment"):
        start = np.ascontiguousarray(cost.argmin(2), np.uint8)
        locked = layout.locked if layout.locked.size else np.zeros(start.shape, np.bool_)
        if locked.any():
            cost = held(cost, start, locked)
        across, up = prices(cost, params) if not exact else (np.zeros(start.shape, np.float32),) * 2
    with progress.stage("solve"):
        if style.name == "tonal":
            cells = diffused(layout.picture, palette)
        elif exact:
            cells = start
        else:
            fewest = 0 if style.flat else FEWEST[params.technique]
            cells = areas.solve(cost, across, up, least, layout.knit, fewest)
    field = Field(len(palette), least, layout, cells, locked)
    colours = len(palette) if style.flat else 0
    figures = {
        "style": style.name,
        "why": style.why,
        "suggested": suggested(style.kind, start.shape, colours, params),
        "seen_from": style.metres,
    }
    if least < LEAST[params.technique]:
        wider = "{--stitches} lets areas be as wide as a bobbin wants"
        figures |= embroidered(field, params.technique, wider, progress)
    return assembled(field, palette, start, style.kind, figures, params)


def of_chart(chart: Chart, params: KnitParams, progress: Progress) -> Piece:
    """The Piece of an existing chart: as it is where ``check`` says so or a hand held stitches of it, else with the fewest
    stitches changed that make every area wide enough."""
    params = params.model_copy(update={"technique": chart.technique, "back": chart.backing, "style": "graphic"})
    layout = unframed(chart)
    locked = np.zeros(chart.shape, np.bool_) if chart.locked is None else chart.locked
    least, by_hand = LEAST[chart.technique], bool(locked.any())
    with progress.stage("solve"):
        if params.check or by_hand:
            cells = chart.cells.copy()
        else:
            cost = (np.arange(len(chart.palette)) != chart.cells[..., None]).astype(np.float32)
            free = np.zeros(chart.shape, np.float32)
            cells = areas.solve(cost, free, free, least, layout.knit)
    field = Field(len(chart.palette), 1 if by_hand else least, layout, cells, locked)
    told = {"style": "graphic", "why": "graphic: a chart is taken as it is", "seen_from": NEAR[params.use]}
    if by_hand:
        told |= embroidered(field, chart.technique, BESIDE, progress)
    return assembled(field, chart.palette, chart.cells, "chart", told, params)


def costs(layout: Layout, params: KnitParams, style: Style, exact: bool) -> tuple[Palette, Array]:
    """The yarns, and (R, C, K) float32, what each stitch costs in each: two yarns without colours of their own show
    lightness, prepared as for stranded knitting; others are compared in colour."""
    own = bool(params.colors) or params.card != "none" or params.stash is not None
    if params.yarns == 2 and not own:
        t = prepared(layout.picture, params, squash_of(params), style.flat)
        palette = Palette(np.array([[0, 0, 0], [255, 255, 255]], np.uint8), ("black", "white"))
        return palette, np.ascontiguousarray(np.stack([t**2, (1 - t) ** 2], -1), np.float32)
    picture = layout.picture if style.flat else wools.cleared(layout.picture)
    palette = wools.chosen(picture, params, style.flat)
    cost = wools.distances(picture, palette)
    return palette, wools.pure(cost) if style.flat and not exact else cost


def prices(cost: Array, params: KnitParams) -> tuple[Array, Array]:
    """(across, up), (R, C) float32: the price of a border to the left and below, less where the costs differ much."""
    price = BORDER[params.technique]

    def between(a: Array, b: Array) -> Array:
        return np.asarray(price * (0.15 + 0.85 * np.exp(-((np.sqrt(a) - np.sqrt(b)) ** 2).mean(-1) / SOFT)), np.float32)

    across = np.full(cost.shape[:2], price, np.float32)
    across[:, 1:] = between(cost[:, 1:], cost[:, :-1])
    up = np.full(cost.shape[:2], price, np.float32)
    up[1:] = between(cost[1:], cost[:-1])
    return across, up


def held(cost: Array, cells: Array, locked: Array) -> Array:
    """The costs with every other yarn of a locked stitch too dear."""
    others = np.arange(cost.shape[2]) != cells[..., None]
    return np.where(locked[..., None] & others, FIXED, cost).astype(np.float32)


def diffused(picture: Array, palette: Palette) -> Array:
    """(R, C) uint8 by error diffusion (Floyd and Steinberg 1976) in linear light, from the top row down."""
    from tambour import color

    light = color.linear(np.arange(256) / 255)
    out = np.zeros(picture.shape[:2], np.uint8)
    areas.diffuse(light[picture].astype(np.float32), light[palette.rgb].astype(np.float32), out)
    return out


def assembled(
    field: Field, palette: Palette, start: Array, kind: str, told: dict[str, Any], params: KnitParams
) -> Piece:
    """The Piece of solved cells."""
    layout, tiled = field.layout, field.layout.tiled
    chart = Chart(
        tiled(field.cells),
        palette,
        no_stitch=tiled(~layout.knit) if layout.knit.size else None,
        locked=tiled(field.locked) if field.locked.any() else None,
        gauge=resample.gauge_of(params),
        technique="jacquard" if params.technique == "jacquard" else "intarsia",
        backing=params.back,
    )
    narrow = areas.narrow(field.cells, field.least, layout.knit)
    if narrow and not params.check:
        raise RuntimeError(f"the solver left {narrow} areas narrower than {field.least} stitches")
    knitted = chart.cells if chart.no_stitch is None else chart.cells[~chart.no_stitch]
    counts = np.bincount(knitted.ravel(), minlength=len(palette))
    order = np.argsort(-counts, kind="stable")
    figures = {
        **told,
        "technique": params.technique,
        "width": chart.shape[1],
        "rows": chart.shape[0],
        "stitches": int(counts.sum()),
        "method": "check" if params.check else "areas" if params.style != "tonal" else "diffused",
        "kind": kind,
        "yarns": len(palette),
        "violations": narrow,
        "longest_float": 0,
        "stitches_by_colour": {name_of(palette, k): int(n) for k, n in enumerate(counts)},
    }
    return Piece(
        chart,
        params,
        np.ascontiguousarray(tone.brightness(tiled(layout.picture), "code")),
        tiled(start),
        chart.shape[1],
        tiled(layout.picture),
        int(order[1]) if len(order) > 1 else 0,
        int(order[0]),
        kind,
        None,
        layout.repeat,
        figures,
        field,
    )


def edited(piece: Piece, edits: list[tuple[int, int, int]], progress: Progress) -> Piece:
    """The piece with stitches (row, stitch, palette entry) set, and no other: what is narrower than an area then is told."""
    field: Field = piece.state
    cells, locked = field.cells.copy(), field.locked.copy()
    wide = cells.shape[1]
    for r, x, colour in edits:
        cells[r, x % wide] = colour
        locked[r, x % wide] = True
    told = {k: piece.figures[k] for k in ("style", "why", "suggested", "seen_from") if k in piece.figures}
    again = replace(field, cells=cells, locked=locked, least=1)
    told |= embroidered(again, piece.params.technique, BESIDE, progress)
    start = np.ascontiguousarray(piece.start[:, :wide])
    return assembled(again, piece.chart.palette, start, piece.kind, told, piece.params)


def embroidered(field: Field, technique: str, hint: str, progress: Progress) -> dict[str, int]:
    """How many places are narrower than an area should be, told with what one does about them."""
    least, knit = LEAST[technique], field.layout.knit
    count = areas.narrow(field.cells, least, knit)
    if count:
        one = "one stitch stands alone" if areas.narrow(field.cells, 2, knit) else f"one place is narrower than {least}"
        many = f"{count} places are narrower than {least} stitches"
        it = "it" if count == 1 else "them"
        progress.warn(
            f"{one if count == 1 else many} in {'its' if count == 1 else 'their'} row: embroider {it} afterwards in "
            f"duplicate stitch, or strand {it}",
            hint=hint,
        )
    return {"embroidered": count} if least > 1 else {}

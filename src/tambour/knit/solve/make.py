"""Solve: from a picture, or an existing chart, to a lawful Piece."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from tambour.core.chart import Chart, Technique
from tambour.core.check import Array
from tambour.core.errors import TambourError, option
from tambour.core.palette import Palette
from tambour.core.picture import Picture
from tambour.core.progress import Progress
from tambour.knit.params import PICTURED, YARNS, KnitParams
from tambour.knit.picture import shades, tone
from tambour.knit.picture.charts import chart_of, two_per_row
from tambour.knit.picture.grounds import laid
from tambour.knit.picture.layout import Layout, lay, unframed
from tambour.knit.picture.prepare import mixed, prepared
from tambour.knit.picture.regions import divided
from tambour.knit.picture.resample import gauge_of
from tambour.knit.picture.style import Style, chosen, of_plain, recognised, settled, suggested
from tambour.knit.picture.usual import coloured
from tambour.knit.piece import Piece
from tambour.knit.solve import coloured as areas
from tambour.knit.solve import faces, floats, yarns
from tambour.knit.solve.assemble import State, assemble
from tambour.knit.solve.stages import advise, mirrored, solved, squash_of, task_of
from tambour.knit.task import NONE, Task


def make(source: Picture | Chart, params: KnitParams, progress: Progress) -> Piece:
    """The Piece of a picture, or of a chart that is to be mended or checked.

    Raises TambourError for pictures, masks and limits that cannot be used together.
    """
    if isinstance(source, Chart) or params.check:
        for name in params.said(PICTURED):
            progress.warn("has no effect on a chart, whose stitches are there already", where=f"{{{option(name)}}}")
        return given(source, params, progress)
    limit = floats.limit_of(params)
    if params.edge_stitches > limit and params.edges == "anchored":
        raise TambourError(
            f"{params.edge_stitches} edge stitches of one colour are longer than a float may be ({limit})",
            where="{--edge-stitches}",
        )
    if limit == 1 and params.floats == "short" and params.technique in ("auto", "stranded"):
        progress.warn(
            "with floats of one stitch every row is a check, whatever the picture",
            hint="{--max-float} 3 and more leave room for one; {--floats} caught leaves it as it is",
        )
    with progress.stage("tone"):
        layout = lay(source, params, progress)
        if (layout.picture == layout.picture[:1, :1]).all():
            progress.warn("the picture is of one colour throughout: its chart shows nothing of it")
        luma = tone.brightness(layout.picture, "code")
        kind = recognised(layout.picture, luma)
        # Pixel art that is given to us, and no word said, stays as it is.
        exact = params.technique == "auto" and kind != "photograph" and layout.pixels
        params = coloured(layout.picture, kind, params)
        style = chosen(kind, luma.shape, params)
    if params.behind is not None:
        return faces.make(layout, style, params, progress)
    if params.technique != "stranded":
        return areas.make(layout, style, params, exact, progress)
    if params.count > 2:
        return yarns.make(layout, style, params, limit, progress)
    return two(layout, luma, style, params, limit, progress)


def two(layout: Layout, luma: Array, style: Style, params: KnitParams, limit: int, progress: Progress) -> Piece:
    """The Piece of a picture in two stranded yarns; ``luma`` (R, C) its brightness."""
    with progress.stage("tone"):
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
        layout = ended(layout, start, params, limit)
    if params.gauge is None and params.stitches is not None:
        progress.warn(
            "stitches are taken as square, though knitted ones are wider than tall",
            hint="knit a swatch and give its stitches x rows in 10 cm, such as {--gauge} 24x32",
        )
    task = task_of(aim, start, limit, params, replace(layout, weights=weights))
    piece = finished(task, layout, palette, style.kind, how, params, progress)
    colours = len(shades.few(layout.picture, YARNS)) if style.flat else 0
    told = {
        "style": style.name,
        "why": style.why,
        "technique": "stranded",
        "suggested": suggested(style.kind, aim.shape, colours, params),
        "seen_from": style.metres,
    }
    return replace(
        piece,
        textured=layout.tiled(textured) if textured.size else None,
        figures={**told, **piece.figures},
    )


def ended(layout: Layout, start: Array, params: KnitParams, limit: int) -> Layout:
    """The layout with the outermost stitches fixed in the rarer yarn, where the machine knits them so; ``start`` too."""
    if not params.end_needles or limit < 2 or start.shape[1] < 4 or layout.frame.size or layout.knit.size:
        return layout
    locked = layout.locked.copy() if layout.locked.size else np.zeros(start.shape, np.bool_)
    start[:, [0, -1]] = int(start.mean() < 0.5)
    locked[:, [0, -1]] = True
    return replace(layout, locked=locked)


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


def two_yarns(picture: Array, params: KnitParams, progress: Progress) -> Palette:
    """Dark and light yarn: black and white unless colours, a shade card or a stash are given."""
    if not params.colors and params.card == "none" and params.stash is None:
        return Palette(np.array([[0, 0, 0], [255, 255, 255]], np.uint8), ("black", "white"))
    return shades.palette_of(picture, params, progress)


def finished(
    task: Task, layout: Layout, palette: Palette, kind: str, how: str, params: KnitParams, progress: Progress
) -> Piece:
    """Solve a two-yarn task and put the Piece together."""
    before = floats.measure(task, task.start)
    advise(before, params, progress)
    with progress.stage("solve"):
        cells = solved(task, params, progress)
        if params.arrange == "mirror" and params.method == "exact" and not cells.shape[1] % 2:
            cells = mirrored(task, cells)
    pairs = np.tile(np.array([0, 1], np.uint8), (len(cells), 1))
    return assemble(State(task, cells, layout, pairs), palette, kind, how, params, before, progress)


def given(source: Picture | Chart, params: KnitParams, progress: Progress) -> Piece:
    """The Piece of an existing chart, in the technique that it says, or that was asked for."""
    technique = source.technique if isinstance(source, Chart) and source.technique != "stranded" else params.technique
    stranded = technique in ("auto", "stranded")
    chart = source if isinstance(source, Chart) else chart_of(source, two=stranded)
    if not chart.cells.size:
        raise TambourError("the chart has no stitches")
    if stranded:
        piece = of_chart(chart, params, progress)
    elif chart.behind is not None:
        piece = faces.of_chart(chart, params)
    else:
        worked: Technique = "jacquard" if technique == "jacquard" else "intarsia"
        if chart.technique != worked:
            chart = replace(chart, technique=worked, backing=params.back)
        piece = areas.of_chart(chart, params, progress)
    return replace(piece, chart=replace(piece.chart, gauge=gauge_of(params) or chart.gauge))


def of_chart(chart: Chart, params: KnitParams, progress: Progress) -> Piece:
    """The Piece of a stranded chart: checked, or mended by the method that was asked for."""
    said: dict[str, Any] = {"technique": "stranded", "method": params.method or "exact", "style": "plain"}
    params = params.model_copy(update=said | ({"round": True, "edges": "anchored"} if chart.circular else {}))
    with progress.stage("start_assignment"):
        bits, pairs = two_per_row(chart)
        layout = unframed(chart)
        task = task_of(bits.astype(np.float32), bits, floats.limit_of(params), params, layout)
    before = floats.measure(task, bits)
    with progress.stage("solve"):
        cells = bits.copy() if params.check else solved(task, params, progress)
    palette = chart.palette
    if len(palette) < 2:
        other = 0 if int(palette.rgb[0].sum()) > 382 else 255
        palette = Palette(np.vstack([palette.rgb, [[other] * 3]]).astype(np.uint8), (*palette.names, ""))
    return assemble(State(task, cells, layout, pairs), palette, "chart", "chart", params, before, progress)

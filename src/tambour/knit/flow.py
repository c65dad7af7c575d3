"""Flow: a picture or a chart becomes the piece, and what is told of it; the whole craft on one page."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from tambour.core.progress import Progress
from tambour.knit.params import KnitParams

if TYPE_CHECKING:
    from tambour.knit.piece import Piece


def make(source: Any, params: KnitParams, progress: Progress) -> Piece:
    """The piece of a Picture, a Chart or a Drawing; TambourError for what --stash or --machine cannot do."""
    from dataclasses import replace

    from tambour.core.drawing import Drawing
    from tambour.knit.solve.make import make as solved

    if isinstance(source, Drawing):
        from tambour.render.flat import picture

        with progress.stage("read"):
            source = picture(source)
    piece = solved(source, params, progress)
    if params.relax is not None and piece.chart.technique != "stranded":
        progress.warn(
            "nothing is carried behind this: to relax areas of it changes nothing", hint="{--technique} stranded"
        )
    _told(piece, progress)
    if params.yarn:
        from tambour.knit.hands.dyed import dyed

        said = [(one, *one.split("=")) for one in params.yarn]
        told = [(yarn, colour, f"{{--yarn}} {one}") for one, colour, yarn in said]
        piece = replace(piece, chart=dyed(piece.chart, told))
    if params.stash is not None:
        from tambour.knit.picture.shades import warn_of_shortage
        from tambour.knit.views import yarn

        warn_of_shortage(piece.chart.palette, [(a.color, a.metres) for a in yarn(piece)], params, progress)
    return fitting(piece)


def _told(piece: Piece, progress: Progress) -> None:
    """What of the wishes did not come out: yarns that are nowhere, and a garment of odd proportions."""
    import numpy as np

    from tambour.knit.hands.sizes import misshapen
    from tambour.knit.hands.yarn import gauge_of

    chart, params = piece.chart, piece.params
    unused = np.setdiff1d(np.arange(len(chart.palette)), chart.cells)
    if params.colors and len(unused) and chart.behind is None:
        names = ", ".join("#{:02x}{:02x}{:02x}".format(*chart.palette.rgb[k].tolist()) for k in unused)
        progress.warn(
            f"no stitch is of {names}",
            "nothing of the picture is nearest to it, or another pair of yarns served those rows better",
        )
    if isinstance(params.shape, str) and params.gauge is not None:
        said = misshapen(params.shape, gauge_of(chart, params.yarn_weight), *chart.cells.shape)
        if said is not None:
            progress.warn(*said)


def fitting(piece: Piece) -> Piece:
    """The piece, if its machine can knit it; else TambourError."""
    if piece.params.machine is not None:
        from tambour.core.errors import TambourError
        from tambour.knit.machines.limits import check

        problems = check(piece.chart, piece.params.machine)
        if problems:
            raise TambourError(problems)
    return piece


def facts(piece: Piece) -> dict[str, Any]:
    """What the report says."""
    from tambour.knit.solve import measure
    from tambour.knit.views import facts as told

    return {**piece.figures, **measure.facts(piece), **told(piece)}

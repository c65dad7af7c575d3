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

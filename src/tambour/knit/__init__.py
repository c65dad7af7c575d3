"""Knit: from a picture to a stranded (Fair-Isle) chart that keeps its floats short."""

from __future__ import annotations

from typing import Any

from tambour.core.progress import Progress
from tambour.craft import Craft
from tambour.knit.params import KnitParams
from tambour.knit.views import VIEWS

__all__ = ["CRAFT"]


def _make(source: Any, params: Any, progress: Progress) -> Any:
    from dataclasses import replace

    from tambour.core.chart import Chart
    from tambour.knit.solve.make import make

    piece = make(source, params, progress)
    if isinstance(source, Chart) and piece.chart.gauge is None:
        piece = replace(piece, chart=replace(piece.chart, gauge=source.gauge))
    if params.stash is not None:
        from tambour.knit.picture.shades import warn_of_shortage
        from tambour.knit.views import yarn

        warn_of_shortage(piece.chart.palette, [(a.color, a.metres) for a in yarn(piece)], params, progress)
    if params.machine is not None:
        from tambour.core.errors import TambourError
        from tambour.knit.machines.limits import check

        problems = check(piece.chart, params.machine)
        if problems:
            raise TambourError(problems)
    return piece


def _facts(piece: Any) -> dict[str, Any]:
    from tambour.knit.solve import measure
    from tambour.knit.views import facts

    return {**piece.figures, **measure.facts(piece), **facts(piece)}


def _warm() -> None:
    import numpy as np

    from tambour.core.picture import Picture
    from tambour.knit.solve.make import make

    grey = np.tile(np.linspace(0, 255, 24).astype(np.uint8)[None, :, None], (12, 1, 4))
    grey[..., 3] = 255
    for method in ("exact", "perceptual"):
        make(Picture(grey), KnitParams(method=method, start="floyd-steinberg"), Progress())


CRAFT = Craft(
    name="knit",
    help="Knit: a picture becomes a stranded (Fair-Isle) chart that keeps its floats short.",
    params=KnitParams,
    reads=("Picture", "Chart"),
    make=_make,
    views=VIEWS,
    facts=_facts,
    warm=_warm,
)

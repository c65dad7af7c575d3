"""Knit: from a picture to a stranded (Fair-Isle) chart that keeps its floats short."""

from __future__ import annotations

from typing import Any

from tambour.core.progress import Progress
from tambour.craft import Craft
from tambour.knit.params import KnitParams
from tambour.knit.views import VIEWS

__all__ = ["CRAFT"]


def _make(source: Any, params: Any, progress: Progress) -> Any:
    from tambour.knit.solve import make

    piece = make(source, params, progress)
    if params.machine is not None:
        from tambour.core.errors import TambourError
        from tambour.knit.machine import check

        problems = check(piece.chart, params.machine)
        if problems:
            raise TambourError(problems)
    return piece


def _facts(piece: Any) -> dict[str, Any]:
    from tambour.knit.views import facts

    return {**piece.figures, **facts(piece)}


CRAFT = Craft(
    name="knit",
    help="Knit: a picture becomes a stranded (Fair-Isle) chart that keeps its floats short.",
    params=KnitParams,
    reads=("Picture",),
    make=_make,
    views=VIEWS,
    facts=_facts,
)

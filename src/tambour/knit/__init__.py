"""Knit: from a picture to a stranded (Fair-Isle) chart that keeps its floats short."""

from __future__ import annotations

from typing import Any

from tambour.core.progress import Progress
from tambour.craft import Craft, View
from tambour.knit.params import KnitParams

__all__ = ["CRAFT"]


def _make(source: Any, params: Any, progress: Progress) -> Any:
    from tambour.knit.solve import make

    return make(source, params, progress)


def _pixels(piece: Any) -> Any:
    import numpy as np

    from tambour.core.picture import Picture

    rgb = piece.chart.palette.rgb[piece.chart.cells[::-1]]
    return Picture(np.dstack([rgb, np.full(rgb.shape[:2], 255, np.uint8)]))


def _facts(piece: Any) -> dict[str, Any]:
    return dict(piece.figures)


CRAFT = Craft(
    name="knit",
    help="Knit: a picture becomes a stranded (Fair-Isle) chart that keeps its floats short.",
    params=KnitParams,
    reads=("Picture",),
    make=_make,
    views={"stitches": View(_pixels, "Picture", "one pixel per stitch, upright", (".png",))},
    facts=_facts,
)

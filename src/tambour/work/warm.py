"""Warm: what making needs, loaded by making something small of each craft."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any


def warm(crafts: Iterable[str], views: Iterable[str] = ()) -> None:
    """Make a small piece of each craft, and look at it in ``views``."""
    from tambour.core.errors import Text
    from tambour.run import craft, make

    small: dict[str, tuple[Any, dict[str, Any]]] = {
        "crochet": (Text("R1: MR(6) (6)\nR2: 6 inc (12)\nR3: 12 sc (12)\nR4: 6 dec (6)\nFO\n"), {}),
        "ink": (None, {"span": 64.0}),
        "embroidery": (None, {"text": "o", "text_size": 10.0}),
    }
    for name in crafts:
        source, values = small[name] if name in small else (_chart(), {})
        what = craft(name)
        piece = make(what, source, what.params.of(values)).piece
        for view in views:
            what.views[view].make(piece)


def _chart() -> Any:
    """A small chart to knit."""
    import numpy as np

    from tambour.core.chart import Chart
    from tambour.core.palette import Palette

    return Chart(
        (np.indices((12, 12)).sum(0) // 3 % 2).astype(np.uint8), Palette(np.array([[0] * 3, [255] * 3], np.uint8))
    )

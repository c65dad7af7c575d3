"""Windows: what clips and masks leave of a drawing: areas, each with how much of a colour comes through."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from tambour.core.check import Array
from tambour.files.svg.canvas import RGBA
from tambour.files.svg.path import apply

Window = list[tuple[Any, float]]
"""Areas (shapely, mm) that lie beside each other, and the share (0 … 1] that shows in each."""
FAINT, FULL = 0.04, 0.96
"""Shares that count as nothing and as all."""
LEVELS = 16
"""Shares that are told apart."""


def clipped(window: Window | None, area: Any) -> Window:
    """A window cut by an area."""
    if window is None:
        return [(area, 1.0)]
    return [(piece, share) for a, share in window if not (piece := a.intersection(area)).is_empty]


def both(window: Window | None, other: Window) -> Window:
    """What shows through two windows."""
    if window is None:
        return other
    return [(a & b, p * q) for a, p in window for b, q in other if a.intersects(b) and p * q > FAINT]


def cut(area: Any, window: Window | None) -> list[tuple[Any, float]] | None:
    """The pieces of a shapely area that show, with their shares; None where all of it does."""
    import shapely

    if window is None:
        return None
    for seen, share in window:
        if share == 1.0 and shapely.contains_properly(seen, area):
            return None
    pieces = [(area.intersection(seen), share) for seen, share in window]
    return [(piece, share) for piece, share in pieces if piece.area > 0]


def masked(content: Sequence[tuple[Any, RGBA]], alpha: bool) -> Window:
    """The window of a mask's content (areas and colours, lowest first): by luminance, or by alpha alone."""
    import shapely

    levels: dict[int, Any] = {}
    for area, (r, g, b, a) in content:
        own = a / 255 * (1.0 if alpha else (0.2125 * r + 0.7154 * g + 0.0721 * b) / 255)
        rest = area
        made: dict[int, list[Any]] = {}
        for level, piece in levels.items():
            under = piece.intersection(area)
            _add(made, level, piece.difference(area))
            _add(made, round(level * (1 - a / 255) + LEVELS * own), under)
            rest = rest.difference(under)
        _add(made, round(LEVELS * own), rest)
        levels = {k: shapely.union_all(v) for k, v in made.items()}
    shares = ((area, level / LEVELS) for level, area in levels.items())
    return [(area, 1.0 if share > FULL else share) for area, share in shares if share > FAINT]


def _add(made: dict[int, list[Any]], level: int, area: Any) -> None:
    if not area.is_empty and area.area > 0:
        made.setdefault(level, []).append(area)


def ring(matrix: Array, x: float, y: float, w: float, h: float) -> Any:
    """A rectangle, transformed, as a shapely area."""
    import shapely

    return shapely.Polygon(apply(matrix, np.array([[x, y], [x + w, y], [x + w, y + h], [x, y + h]])))

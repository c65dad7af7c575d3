"""Angle: from where a step of the assembly is seen, so that what is newly sewn does not hide behind what was there."""

from __future__ import annotations

from math import cos, pi, radians, sin
from typing import TYPE_CHECKING, Final

import numpy as np

from tambour.core.check import Array
from tambour.core.graph import SEWN
from tambour.crochet.maker.size import skin

if TYPE_CHECKING:
    from collections.abc import Sequence

    from tambour.crochet.piece import Plush

VIEW: Final = (radians(24.0), radians(14.0))
"""Azimuth and elevation from which a piece is shown unless something hides there."""
_BACK: Final = (pi + VIEW[0], radians(20.0))
_LEFT, _RIGHT = (radians(75.0), VIEW[1]), (radians(-75.0), VIEW[1])
_OVER, _UNDER = (pi - VIEW[0], radians(62.0)), (0.0, radians(-78.0))
_OTHERS: Final = {_BACK: "back", _LEFT: "side", _RIGHT: "side", _UNDER: "below", _OVER: "above"}
"""Other views, and how they are called."""
_STEEP: Final = 0.75
"""What views from above and below count: there one does not know the toy again."""
_SEAM: Final = 2.5
"""How much more a stitch of a seam tells than another of a part that is sewn on."""
_ENOUGH: Final = 0.6
"""The usual view is kept where it shows so much of what the best one shows."""


def angle(piece: Plush, there: Sequence[int], fresh: Sequence[int], words: str = "") -> tuple[float, float]:
    """Azimuth and elevation, radians, that show the parts ``fresh`` among those that are ``there``: the usual ones, or those of
    the back, a side, below or above where much more of them is in sight; from above where ``words`` say so."""
    if fresh and "from above" in words.lower():
        return _OVER
    graph = piece.built.graph
    part = graph.part
    nodes = np.flatnonzero(np.isin(part, list(there)))
    new = np.tile(np.isin(part[nodes], list(fresh)), 2).astype(float)
    if not new.any() or new.all():
        return VIEW
    # Where it is sewn on is what a step is about.
    new[np.tile(np.isin(nodes, graph.edges[graph.edge_kind == SEWN]), 2) & (new > 0.0)] = _SEAM
    points = skin(piece, nodes)
    seen = [_seen(points, new, 0.7 * piece.stitch[0], view) for view in (VIEW, *_OTHERS)]
    seen = [much * (_STEEP if view in (_OVER, _UNDER) else 1.0) for much, view in zip(seen, (VIEW, *_OTHERS))]
    return VIEW if seen[0] >= _ENOUGH * max(seen) else list(_OTHERS)[int(np.argmax(seen[1:]))]


def steep(view: tuple[float, float]) -> bool:
    """Whether a view is from above or from below."""
    return view in (_OVER, _UNDER)


def called(view: tuple[float, float]) -> str:
    """What a view is called: back, side, above, below; "" the usual one."""
    return _OTHERS.get(view, "")


def _seen(points: Array, new: Array, cell: float, view: tuple[float, float]) -> float:
    """How much of what is ``new`` (P,), by its weight, the cells of a picture without perspective show: of ``points`` (P, 3) the nearest
    in each."""
    a, e = view
    right = np.array([cos(a), 0.0, -sin(a)])
    back = np.array([cos(e) * sin(a), sin(e), cos(e) * cos(a)])
    flat = np.floor(np.column_stack([points @ right, points @ np.cross(back, right)]) / cell).astype(int)
    # Points are a stitch apart: each covers the cells beside its own, too.
    spread = np.array([(i, j) for i in (-1, 0, 1) for j in (-1, 0, 1)])
    cells = (flat[:, None] + spread).reshape(-1, 2)
    near = np.argsort(-np.repeat(points @ back, len(spread)), kind="stable")
    _, first = np.unique(cells[near], axis=0, return_index=True)
    return float(np.repeat(new, len(spread))[near][first].sum())

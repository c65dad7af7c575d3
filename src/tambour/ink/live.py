"""Live: a window of the scroll as a screen paints it, and the wholes that it is painted in."""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from tambour.core.packed import Packed, box, quantised
from tambour.core.steps import Step, told
from tambour.ink.ground.joined import roots

if TYPE_CHECKING:
    from tambour.core.check import Array
    from tambour.core.drawing import Drawing
    from tambour.ink.params import Ink
    from tambour.ink.plan.scroll import Scroll
    from tambour.ink.plotter.job import Plot


def live(piece: Scroll | Plot) -> Packed:
    """The marks in painter's order; of a plot, its lines. The paper's grain and labels are left out."""
    return drawn(_first(piece)[0])


def _first(piece: Scroll | Plot) -> tuple[Drawing, int]:
    """What is shown: the drawing, or a plot's first sheet; and how many sheets there are."""
    from tambour.ink.views import whole

    made = whole(piece)
    return (made[0], len(made)) if isinstance(made, (tuple, list)) else (made, 1)


def drawn(drawing: Drawing) -> Packed:
    """A drawing of open or closed lines, without holes, as arrays.

    ``points`` (P, 2) uint16 of the ``box``, scroll units, y down; ``offsets`` (K + 1,): mark k is the points from
    ``offsets[k]`` on; ``style`` (K,) → ``fill``, ``stroke`` (S, 4), alpha 0 for none, ``width`` (S,) units;
    ``whole`` (K,) → ``wholes``: the hill, bank, boat … that each mark belongs to.
    """
    low, high = box(drawing.paths.coords, 2)
    wholes, whole = _wholes(drawing)
    arrays = {
        "points": quantised(drawing.paths.coords, low, high),
        "offsets": drawing.paths.offsets.astype(np.uint32),
        "style": drawing.style.astype(np.uint16 if len(drawing.styles) <= 1 << 16 else np.uint32),
        "fill": drawing.styles.fill,
        "stroke": drawing.styles.stroke,
        "width": drawing.styles.width.astype(np.float32),
        "whole": whole.astype(np.uint32),
    }
    facts = {
        "craft": "ink",
        "unit": "mark",
        "units": len(drawing),
        "box": [low.tolist(), high.tolist()],
        "origin": drawing.origin.tolist(),
        "size": drawing.size.tolist(),
        "mm": drawing.unit,
        "background": list(drawing.background or (255, 255, 255, 255))[:3],
        "wholes": wholes,
    }
    return Packed(arrays, facts)


def tile(params: Ink, k: int) -> Packed:
    """Tile ``k`` of the scroll of ``params``: all that lies in [512 k, 512 k + 512), or reaches into it.

    What a window has besides (an inscription, a seal) is left out.
    """
    from tambour.core.drawing import Drawing, Styles
    from tambour.core.paths import Paths
    from tambour.ink.ground.joined import join
    from tambour.ink.paint import layers
    from tambour.ink.plan.scroll import batches, rules
    from tambour.ink.plan.wholes import HEIGHT, TILE, window

    begin = float(k * TILE)
    here = params.model_copy(update={"from_": begin, "span": float(TILE)})
    planned = tuple(p for p in window(rules(here), begin, begin + TILE) if p.id not in params.left_out)
    white = (255, 255, 255) if not params.paper and params.time != "night" else None
    origin, size = np.array([begin, 0.0]), np.array([float(TILE), HEIGHT])
    if not planned:
        ground = (*(white or layers.LIGHTS[params.time].paper), 255)
        return drawn(Drawing(Paths.of([]), np.zeros(0, np.int32), Styles.of(), size, origin=origin, background=ground))
    marks = join(list(batches(here, planned)))
    return drawn(layers.drawing(marks, origin, size, params.tall / HEIGHT, params.season, params.time, white))


def _wholes(drawing: Drawing) -> tuple[list[str], Array]:
    """The ids of the groups on top that have marks, in painter's order, and which of them each mark is in."""
    ids = (*drawing.groups.ids, "")
    top = roots(drawing.groups.parent) if len(drawing.groups) else np.zeros(0, np.int64)
    of = np.r_[top, len(drawing.groups)][drawing.group]
    found, first, which = np.unique(of, return_index=True, return_inverse=True)
    order = np.argsort(first)
    rank = np.empty(len(order), np.int64)
    rank[order] = np.arange(len(order))
    return [ids[int(found[k])] for k in order], rank[which.ravel()]


def steps(piece: Scroll | Plot) -> dict[str, Any]:
    """The hills, banks, boats … in painter's order; of a plot's sheets, the first."""
    drawing, _ = _first(piece)
    wholes, whole = _wholes(drawing)
    cuts = np.concatenate([[0], np.flatnonzero(np.diff(whole)) + 1, [len(whole)]]) if len(whole) else np.zeros(1, int)
    made = [
        Step(f"{k + 1}", _words(wholes[int(whole[a])]), int(a), int(b), int(b - a), wholes[int(whole[a])])
        for k, (a, b) in enumerate(pairwise(cuts))
    ]
    return told("ink", "mark", len(whole), made)


def _words(name: str) -> str:
    """What an id such as ``hill-3-1`` says for people."""
    return name.split("-")[0].split(":")[0] or "lines"

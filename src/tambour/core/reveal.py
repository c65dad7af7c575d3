"""Reveal: a drawing that comes into being in painter's order."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from tambour.core.check import Array
from tambour.core.drawing import Drawing
from tambour.core.errors import LawError
from tambour.core.paths import Paths


@dataclass(frozen=True, eq=False, slots=True)
class Reveal:
    """``drawing`` being drawn in ``seconds``, in ``steps`` shares with about as many points each."""

    drawing: Drawing
    seconds: float
    steps: int

    def __post_init__(self) -> None:
        if not (self.seconds > 0 and self.steps > 0):
            raise LawError("Reveal: seconds and steps must be above 0")

    def shares(self) -> Array:
        """(steps + 1,) int64: step k draws the shapes from ``shares[k]`` to ``shares[k + 1]``; all are drawn, once."""
        paths = self.drawing.paths
        ends = paths.offsets[1:] if paths.parts is None else paths.offsets[paths.parts[1:]]
        wanted = np.linspace(0, len(paths.coords), self.steps + 1)
        cuts = np.searchsorted(ends, wanted, side="left")
        cuts[0], cuts[-1] = 0, len(self.drawing)
        return np.asarray(np.minimum(cuts, len(self.drawing)), np.int64)


def stretch(drawing: Drawing, first: int, last: int) -> Drawing:
    """The shapes ``first`` to ``last`` - 1 alone on the same sheet: no ground, no pictures, no labels."""
    paths, parts = drawing.paths, drawing.paths.parts
    a, b = (first, last) if parts is None else (int(parts[first]), int(parts[last]))
    start = paths.offsets[a]
    cut = Paths(
        paths.coords[start : paths.offsets[b]],
        paths.offsets[a : b + 1] - start,
        None if parts is None else parts[first : last + 1] - a,
    )
    return replace(
        drawing,
        paths=cut,
        style=drawing.style[first:last],
        group=drawing.group[first:last],
        labels=(),
        images=(),
        background=None,
    )

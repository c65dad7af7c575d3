"""Areas: rectangles of a chart that a hand marked, laid over a mask that was given as a picture."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tambour.core.check import Array
from tambour.core.errors import Problem, TambourError
from tambour.core.picture import Picture


@dataclass(frozen=True, slots=True)
class Area:
    """Rows from ``row`` up and stitches from ``stitch`` on to the left, both numbered from 1 as charts are; ``said``: by which words."""

    row: int
    stitch: int
    rows: int
    stitches: int
    said: str


@dataclass(frozen=True, slots=True)
class Areas:
    """What is marked: the light of ``given``, and these areas."""

    given: Picture | None
    areas: tuple[Area, ...]

    def over(self, mask: Array | None, shape: tuple[int, int]) -> Array:
        """The mask (R, C) float32 in 0…1, row 0 the cast-on row, with the areas in it. Raises TambourError for one outside.

        >>> Areas(None, (Area(1, 1, 2, 1, "here"),)).over(None, (2, 3)).tolist()
        [[0.0, 0.0, 1.0], [0.0, 0.0, 1.0]]
        """
        rows, stitches = shape
        made = np.zeros(shape, np.float32) if mask is None else mask.copy()
        wrong = [a for a in self.areas if a.row + a.rows - 1 > rows or a.stitch + a.stitches - 1 > stitches]
        if wrong:
            words = f"the chart has {rows} rows of {stitches} stitches"
            raise TambourError([Problem("this area is not within the chart", words, where=a.said) for a in wrong])
        for a in self.areas:
            left = stitches - (a.stitch - 1) - a.stitches
            made[a.row - 1 : a.row - 1 + a.rows, left : left + a.stitches] = 1.0
        return made

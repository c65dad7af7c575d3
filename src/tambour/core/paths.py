"""Paths: the one ragged buffer for polylines, rings and polygons, in the plane or in space."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from tambour.core.check import Array, array, offsets, put


@dataclass(frozen=True, eq=False, slots=True)
class Paths:
    """N polylines in one buffer (the layout of Arrow's nested lists).

    coords : (P, 2) or (P, 3) float64, mm
    offsets : (N + 1,) int64; path i is ``coords[offsets[i]:offsets[i + 1]]``; rises from 0 to P
    parts : (M + 1,) int64 or None; when given, shape m is made of the paths ``parts[m]`` to ``parts[m + 1]``: rings that
        repeat their first point (a polygon's outline and holes), or open lines

    >>> both = Paths.of([[(0, 0), (3, 4)], [(1, 1), (2, 1), (2, 2)]])
    >>> len(both), both[1].tolist()
    (2, [[1.0, 1.0], [2.0, 1.0], [2.0, 2.0]])
    """

    coords: Array
    offsets: Array
    parts: Array | None = None

    def __post_init__(self) -> None:
        coords = array("Paths.coords", self.coords, np.float64, (None, (2, 3)))
        ends = offsets("Paths.offsets", self.offsets, len(coords))
        parts = None if self.parts is None else offsets("Paths.parts", self.parts, len(ends) - 1)
        put(self, coords=coords, offsets=ends, parts=parts)

    def __len__(self) -> int:
        return len(self.offsets) - 1

    def __getitem__(self, i: int) -> Array:
        return self.coords[self.offsets[i] : self.offsets[i + 1]]

    def __iter__(self) -> Iterator[Array]:
        return (self[i] for i in range(len(self)))

    @property
    def shapes(self) -> int:
        """How many shapes these are: polygons where there are parts, else paths.

        >>> ring = [(0, 0), (9, 0), (0, 9), (0, 0)]
        >>> Paths.of([ring, ring]).shapes
        2
        """
        return len(self) if self.parts is None else len(self.parts) - 1

    @classmethod
    def of(cls, lines: Iterable[ArrayLike], dimensions: int = 2) -> Paths:
        """Paths from a sequence of (n, 2) or (n, 3) arrays.

        >>> Paths.of([[(0, 0), (3, 4)]]).offsets.tolist()
        [0, 2]
        """
        arrays = [np.asarray(line, np.float64) for line in lines]
        if not arrays:
            return cls(np.zeros((0, dimensions)), np.zeros(1, np.int64))
        return cls(np.concatenate(arrays), np.concatenate([[0], np.cumsum([len(a) for a in arrays])]))

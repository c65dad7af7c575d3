"""Strands: yarn and thread in space."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field

import numpy as np

from tambour.core.check import Array, array, put
from tambour.core.errors import LawError
from tambour.core.paths import Paths


@dataclass(frozen=True, eq=False, slots=True)
class Strands:
    """N round strands.

    paths : Paths with coords (P, 3) mm, the centre lines
    radius : (P,) float64 mm
    color : (N, 3) uint8 sRGB
    source : (N,) int32, the stitch that made the strand (-1: none)
    strand_data, point_data : named attributes, one row per strand (N, …) or per point (P, …)
    frames : None, or a function that starts a new iterator of (P, 3) positions
    frame_count, seconds_per_frame : as in Mesh

    >>> yarn = Strands(Paths.of([[(0, 0, 0), (9, 0, 0)]]), np.array([1.5, 1.5]), np.array([[200, 30, 40]]))
    >>> len(yarn.paths), yarn.source.tolist()
    (1, [-1])
    """

    paths: Paths
    radius: Array
    color: Array
    source: Array | None = None
    strand_data: Mapping[str, Array] = field(default_factory=dict)
    point_data: Mapping[str, Array] = field(default_factory=dict)
    frames: Callable[[], Iterator[Array]] | None = None
    frame_count: int = 1
    seconds_per_frame: float = 1 / 24

    def __post_init__(self) -> None:
        if self.paths.coords.shape[1] != 3:
            raise LawError("Strands.paths: coords must be (P, 3)")
        n, p = len(self.paths), len(self.paths.coords)
        source = np.full(n, -1, np.int32) if self.source is None else self.source
        for names, length in ((self.strand_data, n), (self.point_data, p)):
            for name, values in names.items():
                if len(values) != length:
                    raise LawError(f"Strands: attribute {name} has {len(values)} rows, wanted {length}")
        put(
            self,
            radius=array("Strands.radius", self.radius, np.float64, (p,)),
            color=array("Strands.color", self.color, np.uint8, (n, 3)),
            source=array("Strands.source", source, np.int32, (n,)),
        )

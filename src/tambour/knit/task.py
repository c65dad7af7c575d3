"""Task: a two-yarn chart to be made lawful, as arrays that kernels take."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np

from tambour.core.check import Array
from tambour.noise import key

NONE = np.zeros((0, 0), np.bool_)
PLAIN = np.zeros((0, 0), np.float32)


@dataclass(frozen=True, eq=False, slots=True)
class Task:
    """What a solver is given; arrays are (R, C), row 0 the cast-on row.

    tone : float32 in 0…1 aimed at
    start : uint8, 1 the light yarn and 0 the dark: the start assignment
    limit : longest allowed run, f
    free : the first and the last run of a row may reach ``cap`` stitches
    ring : rows close upon themselves
    soft : cost, in flips, of each stitch beyond the limit; None forbids them
    knit, relaxed, locked : bool, or empty: stitches that are knitted (all), free of the limit (none), fixed (none)
    weights : float32, or empty: the cost of a flip (1)
    seed : of random choices
    first : which row of the chart the first one is, where the task is a part of it

    A cell that is not knitted is passed over: the stitches on either side of it are neighbours in the row. A relaxed
    stitch breaks a run in two: only windows of f + 1 stitches without one count.
    """

    tone: Array
    start: Array
    limit: int
    free: bool = False
    cap: int = 1 << 30
    ring: bool = False
    soft: float | None = None
    knit: Array = field(default_factory=lambda: NONE)
    relaxed: Array = field(default_factory=lambda: NONE)
    locked: Array = field(default_factory=lambda: NONE)
    weights: Array = field(default_factory=lambda: PLAIN)
    seed: str = "knit"
    first: int = 0

    @property
    def key(self) -> np.uint64:
        """64 bits of the seed for kernels."""
        return np.uint64(key("knit", self.seed))

    @property
    def plain(self) -> bool:
        """Flat, anchored, hard, every stitch alike: the case with a closed form."""
        return (
            not (self.free or self.ring or self.soft or self.knit.size or self.relaxed.size or self.locked.size)
            and not self.weights.size
        )

    def rows(self, low: int, high: int) -> Task:
        """The task of rows ``low`` to ``high`` alone."""
        cut = {
            name: array[low:high] if array.size else array
            for name, array in (
                (n, getattr(self, n)) for n in ("tone", "start", "knit", "relaxed", "locked", "weights")
            )
        }
        return replace(self, **cut, first=self.first + low)

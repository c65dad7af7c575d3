"""Floats: the constraint, and what a chart has of it.

A run is a stretch of stitches of one colour in a row; while one yarn knits it, the other floats behind. A run of
length L is a float of length L of the other yarn. The law: no run is longer than f. (Kryven and Fourquet 2013,
section 3; their text says "less than f" and their formula f + 1 equal neighbours: only "up to f" fits their figure 8.)
"""

from __future__ import annotations

from dataclasses import dataclass
from math import floor

import numpy as np

from tambour.core.arrays import B1x1, B1x2, I8x1, I8x2, U1x1, U1x2
from tambour.core.check import Array
from tambour.core.errors import TambourError
from tambour.core.kernels import kernel
from tambour.core.params import length
from tambour.core.threads import share
from tambour.knit.params import KnitParams
from tambour.knit.picture.resample import gauge_of
from tambour.knit.task import Task

HISTOGRAM = 64


BY_HAND, BY_MACHINE, SMALL = (
    25.0,
    5,
    3,
)  # mm a hand knitter leaves free; stitches on a single bed; on mittens, for children
USUAL = (3, 4, 7)  # stitches by hand: the least, that without a gauge, and the most


def limit_of(params: KnitParams) -> int:
    """f in stitches: ``--max-float`` itself, or the whole stitches that its length holds at the gauge; else by use."""
    gauge = gauge_of(params)
    if params.max_float is None:
        if params.machine:
            return BY_MACHINE
        if params.use in ("mitten", "child"):
            return SMALL
        return USUAL[1] if gauge is None else min(max(floor(BY_HAND / gauge.width + 1e-9), USUAL[0]), USUAL[2])
    if params.max_float.isdigit():
        return int(params.max_float)
    assert gauge is not None, "checked by the params"
    found = floor(length(params.max_float) / gauge.width + 1e-9)
    if found < 1:
        raise TambourError(
            f"a float of {params.max_float} is less than one stitch of {gauge.width:.1f} mm", where="{--max-float}"
        )
    return min(found, 1000)


@dataclass(frozen=True, slots=True)
class Floats:
    """What a chart has of the constraint.

    stitches : knitted stitches
    conflicts : stitches in runs longer than allowed (the paper's "conflicting variables")
    violations : windows of f + 1 equal stitches that the law forbids; a run of length L has L - f
    longest : the longest float: of a run that the yarn must cross, so not of free edge runs
    histogram : floats of length 1, 2, 3 … (the last entry counts all that are longer)
    """

    stitches: int
    conflicts: int
    violations: int
    longest: int
    histogram: Array

    @property
    def consistent(self) -> float:
        """Percent of stitches that are not in conflict."""
        return 100.0 * (1 - self.conflicts / self.stitches) if self.stitches else 100.0


def measure(task: Task, cells: Array) -> Floats:
    """The floats of ``cells`` (R, C) uint8 under the task's constraint."""
    rows = len(cells)
    found = np.zeros((rows, 4), np.int64)
    block = 256
    histogram = np.zeros((-(-rows // block), HISTOGRAM + 1), np.int64)

    def work(low: int, high: int) -> None:
        measure_rows(
            cells,
            low,
            high,
            task.limit,
            task.free,
            task.cap,
            task.ring,
            task.knit,
            task.relaxed,
            found,
            histogram[low // block],
        )

    share(rows, block, work)
    return Floats(
        int(found[:, 0].sum()),
        int(found[:, 1].sum()),
        int(found[:, 2].sum()),
        int(found[:, 3].max(initial=0)),
        np.trim_zeros(histogram.sum(0), "b"),
    )


def fewest(start: Array, limit: int) -> int:
    """The least flips that make anchored, unmasked rows lawful: Σ⌊L / (f + 1)⌋ over their runs, for f ≥ 2.

    Disjoint windows of f + 1 equal stitches each need a flip of their own, which bounds it from below; flipping every
    (f + 1)th stitch attains it, as f ≥ 2 leaves room to keep off the ends. It is false for f = 1.
    """
    rows, stitches = start.shape
    edge = np.ones((rows, stitches + 1), np.bool_)
    edge[:, 1:-1] = start[:, 1:] != start[:, :-1]
    at = np.flatnonzero(edge.ravel())
    lengths = np.diff(at)
    return int((lengths[(at[:-1] % (stitches + 1)) != stitches] // (limit + 1)).sum())


@kernel
def sequence(y: int, stitches: int, knit: Array, columns: Array) -> int:
    """Fill ``columns`` with the knitted columns of row ``y``, in order; gives how many."""
    n = 0
    for x in range(stitches):
        if knit.size == 0 or knit[y, x]:
            columns[n] = x
            n += 1
    return n


@kernel
def measure_rows(
    cells: U1x2,
    low: int,
    high: int,
    f: int,
    free: bool,
    cap: int,
    ring: bool,
    knit: B1x2,
    relaxed: B1x2,
    found: I8x2,
    histogram: I8x1,
) -> None:
    """For each row: stitches, conflicts, violations, longest float; and the histogram of floats of them all."""
    stitches = cells.shape[1]
    columns = np.zeros(stitches, np.int32)
    row = np.zeros(stitches, np.uint8)
    loose = np.zeros(stitches, np.bool_)
    bad = np.zeros(stitches, np.bool_)
    for y in range(low, high):
        n = sequence(y, stitches, knit, columns)
        found[y, 0] = n
        for k in range(n):
            row[k] = cells[y, columns[k]]
            loose[k] = relaxed.size > 0 and relaxed[y, columns[k]]
        found[y, 1], found[y, 2] = mark(row, loose, n, f, free, cap, ring, bad)
        turn = turning(row, loose, n, ring)
        begin = 0
        while begin < n:
            end = begin
            while end < n and row[(end + turn) % n] == row[(begin + turn) % n]:
                end += 1
            if not (free and (begin == 0 or end == n)):
                found[y, 3] = max(found[y, 3], end - begin)
                histogram[min(end - begin, histogram.size - 1)] += 1
            begin = end


@kernel
def turning(row: Array, loose: Array, n: int, ring: bool) -> int:
    """Where to begin a round so that no run is cut: at a change of colour, else at a relaxed stitch, else at 0."""
    if ring:
        for k in range(n):
            if row[k] != row[(k if k else n) - 1]:
                return k
        for k in range(n):
            if loose[k]:
                return k
    return 0


@kernel
def mark(row: U1x1, loose: B1x1, n: int, f: int, free: bool, cap: int, ring: bool, bad: B1x1) -> tuple[int, int]:
    """Mark the stitches in conflict among the first ``n`` of ``row``; gives (conflicts, violated windows)."""
    turn = turning(row, loose, n, ring)
    conflicts = violations = 0
    begin = 0
    while begin < n:
        end = begin
        while end < n and row[(end + turn) % n] == row[(begin + turn) % n]:
            end += 1
        exempt = free and (begin == 0 or end == n) and end - begin <= cap
        first = begin
        while first < end:
            # A stretch without a relaxed stitch.
            last = first
            while last < end and not loose[(last + turn) % n]:
                last += 1
            wrong = last - first > f and not exempt
            for k in range(first, min(last + 1, end)):
                bad[(k + turn) % n] = wrong and k < last
            if wrong:
                conflicts += last - first
                # A whole round of one colour has a window at every stitch.
                violations += last - first - (0 if ring and last - first == n else f)
            first = last + 1
        begin = end
    return conflicts, violations

"""Twofold: the best row of a double-faced cloth, two pictures back to back, under two laws of its yarns.

A row's stitches lie in one line, front and back by turns. In every ``use`` of them each yarn is used at least once, so
that none floats far; in every ``cross`` some yarn is used on both faces, so that the two cloths hold together. These are
the rules of co-dithering for jacquard (Xu and McCann 2025); the method is our own.

The first law is a shortest path (:mod:`uses`). The second is asked for only where it is broken: windows without a crossing
are added, and the row is solved again from there, until none is broken. What is optimal among fewer laws and keeps all of
them is optimal.
"""

from __future__ import annotations

from bisect import bisect_right
from dataclasses import dataclass
from math import perm

import numpy as np

from tambour.core.arrays import B1x1, I8x1
from tambour.core.check import Array
from tambour.core.errors import TambourError
from tambour.core.kernels import kernel
from tambour.knit.solve.uses import CODE, COSTS, LANES, OPEN, SLOTS, STEP, Ways, solve_row, ways
from tambour.knit.task import NONE

ROUNDS = 32  # in which windows are added; then windows enough for all take their place
LARGEST = 50_000  # states of a row, the yarn in use not counted
MEMORY = 1 << 29  # bytes at most of where values came from


@dataclass(eq=False, slots=True)
class Room:
    """What a row needs to be solved in, kept from row to row; see :func:`uses.solve_row`."""

    stitches: int
    yarns: int
    use: int
    cross: int
    slots: int
    ways: Ways
    levels: int = 0
    arrays: tuple[Array, Array, Array, Array] = (NONE, NONE, NONE, NONE)

    @classmethod
    def of(cls, stitches: int, yarns: int, use: int, cross: int) -> Room:
        """For rows of ``stitches`` (both faces together). Raises TambourError for laws that cannot be kept or are too wide."""
        if use < yarns:
            raise TambourError(
                f"{yarns} yarns cannot all be used in {use} stitches", hint=f"at least {yarns}", where="{--use-within}"
            )
        if use > widest(yarns):
            raise TambourError(
                f"{yarns} yarns used within {use} stitches are more than can be solved exactly",
                hint=f"at most {widest(yarns)} with {yarns} yarns",
                where="{--use-within}",
            )
        # A row that is shorter than the law has no window of it: slots enough that no use is ever too long ago.
        slots = use - 1 if stitches >= use else stitches + yarns - 2
        return cls(stitches, yarns, use, cross, slots, ways(slots, max(1, yarns - 1)))

    def sizes(self) -> tuple[int, int]:
        """How many values a level has, and how many of them are new at each stitch."""
        return LANES * perm(self.slots, self.yarns - 1), LANES * (self.ways.went.size // self.slots)

    def open(self) -> int:
        """How many windows may be open at a time."""
        return max(2, min(OPEN, MEMORY // (self.stitches * sum(self.sizes())) - 1))

    def grown(self, levels: int) -> bool:
        """Whether there was no room yet for so many levels: none, one, two ... windows wait."""
        if levels <= self.levels:
            return False
        values, new = self.sizes()
        self.levels = levels
        self.arrays = (
            np.zeros(levels * values, np.int32),
            np.zeros(levels * self.stitches * new, np.uint8),
            np.zeros(levels * self.stitches * values if levels > 1 else 1, np.uint8),
            np.zeros((self.stitches // STEP + 1) * (values + LANES), np.int32),
        )
        return True


def widest(yarns: int) -> int:
    """The most stitches within which so many yarns can be asked for."""
    return max(use for use in range(yarns, SLOTS + 2) if perm(use - 1, yarns - 1) <= LARGEST)


def solve(cost: Array, room: Room) -> tuple[Array, bool]:
    """(N,) the yarns of the row of least total ``cost`` (N, K) float under the laws, and whether that is proven.

    It is not where ``ROUNDS`` of windows, or as many at a time as there is room for, do not suffice: there windows of two thirds, every third,
    stand for all, which asks a little more than the law.
    """
    n = len(cost)
    if room.yarns == 1:
        return np.zeros(n, np.int64), True
    scale = (COSTS // CODE - 1) / max(1e-9, float(cost.max(axis=1).sum()))
    whole = np.ascontiguousarray(np.floor(cost * min(scale, 1e6)) * CODE, np.int32)
    out = np.zeros(n, np.int64)
    starts: list[int] = []
    span, begin = room.cross, 0
    for turn in range(ROUNDS + 1):
        if turn == ROUNDS or most_open(starts, span) > room.open():
            third = max(1, (room.cross + 1) // 3)
            span, begin = max(2, 2 * third), 0
            starts = list(range(0, max(1, n - room.cross + third + 1), third))
        if room.grown(most_open(starts, span) + 1):
            begin = 0
        solve_row(whole, room.slots, span, np.array(starts, np.int64), begin, room.ways, *room.arrays, out)
        if out[0] < 0:
            raise impossible(room)
        broken = np.zeros(n, np.bool_)
        uncrossed(out, room.cross, broken)
        more = apart(np.flatnonzero(broken).tolist(), max(1, room.cross // 3))
        if (span != room.cross and more) or set(more) & set(starts):
            raise impossible(room)
        if not more:
            break
        begin = more[0] // STEP * STEP
        while any(s < begin <= s + span for s in starts):
            begin -= STEP
        starts = sorted({*starts, *more})
    return out, span == room.cross


def most_open(starts: list[int], span: int) -> int:
    """How many windows are open at a time, at most; ``starts`` in order."""
    return max((k + 1 - bisect_right(starts, s - span) for k, s in enumerate(starts)), default=0)


def impossible(room: Room) -> TambourError:
    """What is said where no row was found that keeps both laws."""
    return TambourError(
        f"no row was found in which {room.yarns} yarns are used within {room.use} stitches and cross within {room.cross}",
        hint="a larger {--cross-within} or {--use-within}",
        where="{--cross-within}",
    )


def apart(starts: list[int], span: int) -> list[int]:
    """Of the windows that begin at ``starts``, the first, and each next that begins ``span`` and more after the one before."""
    out: list[int] = []
    for s in starts:
        if not out or s >= out[-1] + span:
            out.append(s)
    return out


@kernel
def uncrossed(row: I8x1, cross: int, broken: B1x1) -> None:
    """Mark where windows of ``cross`` stitches begin in which no yarn is used on both faces."""
    n = row.size
    last = np.full(64, -1, np.int64)
    pair = -1  # where the latest pair of both faces begins
    for t in range(n):
        k = row[t]
        if last[k] >= 0 and (t - last[k]) % 2 == 1:
            pair = max(pair, last[k])
        last[k] = t
        if t >= cross - 1 and pair < t - cross + 1:
            broken[t - cross + 1] = True

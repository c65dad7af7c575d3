"""A chart in the hand: rows in working order, the floats behind them, where to catch, where a ladder carries."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from tambour.core.chart import Chart
from tambour.core.check import Array

_BLOCK = 1 << 19
_CATCH, _SAME, _BESIDE, _AGAIN, _IDLE = 4.0, 100.0, 4.0, 1.0, 3.0
"""Cost of a catch; of one over a catch of the row below, beside one, over one two rows below; at a float's end."""


class Floats(NamedTuple):
    """Every float of a chart: ``row``, ``start`` (its leftmost column), ``length`` in stitches, ``yarn`` (the colour
    that is carried) and ``edge`` (it ends at a side of flat knitting), each (N,). A float that wraps in the round has
    its start near the right side."""

    row: Array
    start: Array
    length: Array
    yarn: Array
    edge: Array


class Ladder(NamedTuple):
    """A column of extra stitches on the back that carries floats: chart column, first and last row (included)."""

    column: int
    first: int
    last: int


def worked(chart: Chart, row: int) -> Array:
    """The row's columns in the order they are knitted: leftwards on the right side, rightwards on the wrong side.

    Cells without stitch are left out.
    """
    columns = np.arange(chart.shape[1])
    if chart.no_stitch is not None:
        columns = columns[~chart.no_stitch[row]]
    return columns if wrong_side(chart, row) else columns[::-1]


def wrong_side(chart: Chart, row: int) -> bool:
    """Whether the row is worked from the wrong side (even rows of flat knitting)."""
    return not chart.circular and row % 2 == 1


def roles(chart: Chart) -> dict[int, str]:
    """Colour → MC for the one most used, CC (or CC1, CC2 …) for the others by use; only colours that are knitted."""
    count = tally(chart)
    order = sorted((c for c in range(len(count)) if count[c]), key=lambda c: (-count[c], c))
    names = ["MC", "CC"] if len(order) <= 2 else ["MC", *(f"CC{k}" for k in range(1, len(order)))]
    return dict(zip(order, names))


def tally(chart: Chart) -> Array:
    """Stitches (K,) of each colour."""
    cells = chart.cells if chart.no_stitch is None else chart.cells[~chart.no_stitch]
    return np.bincount(cells.ravel(), minlength=len(chart.palette))


def runs(chart: Chart, row: int) -> list[tuple[int, int]]:
    """The row as ``(colour, stitches)`` in working order."""
    cells = chart.cells[row][worked(chart, row)]
    if not len(cells):
        return []
    cut = np.flatnonzero(np.diff(cells)) + 1
    bounds = np.concatenate([[0], cut, [len(cells)]])
    return [(int(cells[a]), int(b - a)) for a, b in itertools.pairwise(bounds)]


def floats(chart: Chart, anchored: bool = True, above: int = 0) -> Floats:
    """The floats of every row that holds two colours, those of more than ``above`` stitches.

    anchored : both yarns go to both sides of flat knitting, so the runs at the sides have floats behind them too;
        otherwise they have none. In the round there are no sides.
    """
    found = [_floats(chart.cells[:0], False, anchored)]
    found += [Floats(*(part[block.length > above] for part in block)) for block in _blocks(chart, anchored)]
    return Floats(*(np.concatenate(parts) for parts in zip(*found)))


def _blocks(chart: Chart, anchored: bool) -> Iterator[Floats]:
    """The floats some rows at a time: those of a whole large chart would fill the memory."""
    rows, width = chart.shape
    if chart.no_stitch is None or not chart.no_stitch.any():
        step = max(1, _BLOCK // max(1, width))
        for r in range(0, rows, step):
            one = _floats(chart.cells[r : r + step], chart.circular, anchored)
            yield one._replace(row=one.row + r)
        return
    for r in range(rows):
        columns = np.flatnonzero(~chart.no_stitch[r])
        if len(columns):
            one = _floats(chart.cells[r : r + 1, columns], chart.circular, anchored)
            yield one._replace(row=one.row + r, start=columns[one.start])


def carried(chart: Chart, anchored: bool = True) -> Array:
    """Stitches (K,) that each colour crosses behind others."""
    total = np.zeros(len(chart.palette))
    for block in _blocks(chart, anchored):
        total += np.bincount(block.yarn, block.length, len(total))
    return np.round(total).astype(np.int64)


def _floats(cells: Array, circular: bool, anchored: bool) -> Floats:
    rows, width = cells.shape
    low, high = (cells.min(axis=1), cells.max(axis=1)) if cells.size else (cells[:, 0], cells[:, 0])
    begin = np.ones((rows, width), np.bool_)
    begin[:, 1:] = cells[:, 1:] != cells[:, :-1]
    begin[low == high] = False
    row, start = np.nonzero(begin)
    same = np.zeros(len(row), np.bool_)  # the next run is of the same row
    same[:-1] = row[1:] == row[:-1]
    following = np.where(same, np.roll(start, -1), width)
    length = following - start
    first, last = start == 0, ~same
    edge = first | last
    if circular:
        # A run over the seam is one: its right part takes the length of its left part.
        head, tail = np.flatnonzero(first), np.flatnonzero(last)
        join = cells[row[head], 0] == cells[row[head], -1]
        length[tail[join]] += length[head[join]]
        keep = np.ones(len(row), np.bool_)
        keep[head[join]] = False
        edge[:] = False
    else:
        keep = np.ones(len(row), np.bool_) if anchored else ~edge
    row, start, length, edge = row[keep], start[keep], length[keep], edge[keep]
    yarn = (low[row].astype(np.int64) + high[row] - cells[row, start]).astype(np.int64)
    return Floats(row.astype(np.int64), start.astype(np.int64), length.astype(np.int64), yarn, edge)


def catches(chart: Chart, limit: int, anchored: bool = True) -> list[list[int]]:
    """Columns, per row, at which to catch the floats above ``limit``, so that no more than ``limit`` stitches lie free.

    The cheapest places by dynamic programming over each float: few, even, never over a catch of the row below when
    that can be helped (a column of catches shows on the right side), nor beside one.
    """
    rows, width = chart.shape
    marks: list[list[int]] = [[] for _ in range(rows)]
    long = floats(chart, anchored, limit)
    for row, start, length in sorted(zip(long.row.tolist(), long.start.tolist(), long.length.tolist())):
        columns = [(start + k) % width for k in range(length)]
        if chart.no_stitch is not None:
            free = np.flatnonzero(~chart.no_stitch[row])
            at = int(np.searchsorted(free, start))
            columns = [int(free[(at + k) % len(free)]) for k in range(length)]
        below = set(marks[row - 1]) if row else set()
        again = set(marks[row - 2]) if row > 1 else set()
        marks[row] += [columns[k] for k in _places(columns, limit, below, again)]
    return [sorted(row) for row in marks]


def _places(columns: list[int], limit: int, below: set[int], again: set[int]) -> list[int]:
    """Positions of the catches of one float (indices into ``columns``)."""
    n = len(columns)
    cost, back = [0.0] * (n + 2), [0] * (n + 2)  # position p + 1; 0 is the stitch before the float, n + 1 the one after
    for p in range(1, n + 2):
        own = 0.0
        if p <= n:
            c = columns[p - 1]
            own = (
                _CATCH + _SAME * (c in below) + _BESIDE * ((c - 1 in below) + (c + 1 in below)) + _AGAIN * (c in again)
            )

        def reach(q: int, p: int = p) -> float:  # long stretches are uneven, and a catch beside a stitch is none
            return cost[q] + 0.01 * (p - q) ** 2 + _IDLE * (p - q == 1)

        best = min(range(max(0, p - limit - 1), p), key=lambda q: (reach(q), q))
        cost[p], back[p] = reach(best) + own, best
    found, p = [], back[n + 1]
    while p > 0:
        found.append(p - 1)
        p = back[p]
    return found[::-1]


def ladders(chart: Chart, limit: int, anchored: bool = True, least: int | None = None) -> list[Ladder]:
    """Ladder columns for the floats above ``least`` stitches (default: those that would want three catches or more).

    Columns stand ``limit`` + 1 apart, so between two of them no float lies free over more than ``limit`` stitches;
    their phase is the one that stands farthest from the floats' ends. A ladder begins at the first float that it
    carries and ends at the last; gaps of two rows and less are bridged.
    """
    least = 3 * limit + 2 if least is None else least
    long = floats(chart, anchored, least)
    width, step = chart.shape[1], limit + 1
    if not len(long.row):
        return []
    ends = np.concatenate([long.start - 1, long.start + long.length]) % width
    near = [np.abs((ends - o + step // 2) % step - step // 2).sum() for o in range(step)]
    phase = int(np.argmax(near))
    crossed: dict[int, list[int]] = {}
    for row, start, length in zip(long.row.tolist(), long.start.tolist(), long.length.tolist()):
        for k in range(length):
            if (start + k) % width % step == phase:
                crossed.setdefault((start + k) % width, []).append(row)
    found = []
    for column, at in sorted(crossed.items()):
        first = last = at[0]
        for row in at[1:]:
            if row > last + 3:
                found.append(Ladder(column, first, last))
                first = row
            last = row
        found.append(Ladder(column, first, last))
    return found

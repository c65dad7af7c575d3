"""A chart in the hand: rows in working order, the floats behind them, where to catch, where a ladder carries."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from tambour.core.chart import Chart
from tambour.core.check import Array

_BLOCK = 1 << 19


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
    """The floats some rows at a time: those of a whole large chart would fill the memory. Intarsia and jacquard have none."""
    if chart.technique != "stranded":
        return
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


def crossed(chart: Chart, row: int, start: int, length: int) -> Array:
    """The columns (length,) of the stitches that a float lies behind, from its start rightwards."""
    if chart.no_stitch is None:
        return (start + np.arange(length)) % chart.shape[1]
    knitted = np.flatnonzero(~chart.no_stitch[row])
    return knitted[(np.searchsorted(knitted, start) + np.arange(length)) % len(knitted)]


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


def catches(chart: Chart, limit: int, anchored: bool = True, dear: Array | None = None) -> Array:
    """Where (R, C) bool to catch the floats above ``limit``, so that no more than ``limit`` stitches lie free.

    Few, even, never over a catch of the row below when that can be helped (a column of catches shows on the right
    side), nor beside one; see :mod:`tambour.knit.hands.catch`. ``dear`` (R, C) float32: what a catch costs more there.
    """
    marks = np.zeros(chart.shape, np.bool_)
    long = floats(chart, anchored, limit)
    if len(long.row):
        from tambour.knit.hands.catch import mark

        absent = np.zeros((0, 0), np.bool_) if chart.no_stitch is None else chart.no_stitch
        dear = np.zeros((0, 0), np.float32) if dear is None else dear
        mark(long.row, long.start, long.length, absent, limit, dear, marks)
    return marks


def longest_span(chart: Chart, limit: int, marks: Array, anchored: bool = True) -> int:
    """The most stitches that a float lies free over, between the stitches it comes from and its catches ``marks``."""
    every = floats(chart, anchored)
    short = every.length <= limit
    longest = int(every.length[short].max(initial=0))
    for row, start, length in zip(*(part[~short].tolist() for part in every[:3])):
        at = np.flatnonzero(marks[row, crossed(chart, row, start, length)])
        longest = max(longest, int(np.diff(np.concatenate([[-1], at, [length]])).max()) - 1)
    return longest


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
    column, row = _standing(chart, long, phase, step)
    order = np.lexsort((row, column))
    column, row = column[order], row[order]
    begin = np.ones(len(row), np.bool_)
    begin[1:] = (column[1:] != column[:-1]) | (row[1:] > row[:-1] + 3)
    first = np.flatnonzero(begin)
    last = np.append(first[1:], len(row)) - 1
    return [Ladder(*found) for found in zip(column[first].tolist(), row[first].tolist(), row[last].tolist())]


def _standing(chart: Chart, long: Floats, phase: int, step: int) -> tuple[Array, Array]:
    """Columns ≡ ``phase`` (mod ``step``) that each float crosses, and its row, (P,) each."""
    width = chart.shape[1]
    if chart.no_stitch is not None:
        crossings = [crossed(chart, *one) for one in zip(long.row.tolist(), long.start.tolist(), long.length.tolist())]
        column, row = np.concatenate(crossings), np.repeat(long.row, long.length)
        keep = column % step == phase
        return column[keep], row[keep]
    # A float round the seam is two pieces.
    over = np.maximum(long.start + long.length - width, 0)
    row = np.concatenate([long.row, long.row[over > 0]])
    start = np.concatenate([long.start, np.zeros(int((over > 0).sum()), np.int64)])
    length = np.concatenate([long.length - over, over[over > 0]])
    lead = (phase - start) % step
    count = np.maximum(0, -(-(length - lead) // step))
    place = np.arange(count.sum()) - np.repeat(count.cumsum() - count, count)
    return np.repeat(start + lead, count) + step * place, np.repeat(row, count)

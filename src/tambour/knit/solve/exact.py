"""Exact: the fewest flips (or the least weight of flips) that make each row lawful, proven, without lined-up flips.

Rows are independent, so the whole problem of the 2013 paper falls into rows, and each is solved by dynamic programming
over (colour, length of the run so far). Costs are integers in two parts, the weight of the flips and, far below it, a
preference against flips that stand above each other: so the weight is the least there is, and among the charts of that
weight one is taken whose flips do not line up (greedily over rows).
"""

from __future__ import annotations

import numpy as np

from tambour.core.arrays import B1x1, B1x2, F4x2, U1x2
from tambour.core.check import Array
from tambour.core.errors import Problem, TambourError
from tambour.core.kernels import kernel
from tambour.core.threads import share
from tambour.knit.solve.floats import sequence
from tambour.knit.task import Task
from tambour.noise import mix

UNIT = 1000  # weights count to three decimals
SCALE = np.int64(1) << 27  # one unit of weight outweighs all the preferences of a row
INFINITE = np.int64(1) << 61
BLOCK = 64
LARGE = 1 << 22  # stitches; larger charts are gone through once


def solve(task: Task, cells: Array | None = None, tidy: float = 0.0) -> Array:
    """(R, C) uint8: the lawful chart nearest to the start assignment.

    ``cells``: a chart solved before, whose other rows are kept in view so that new flips do not line up with them.
    ``tidy``: what the most unwelcome place adds to a flip's cost, in flips; above 0 there may be more than the fewest.
    Raises TambourError when locked stitches leave a row no lawful way.
    """
    out = task.start.copy() if cells is None else cells
    rows = len(out)
    failed = np.zeros(rows, np.bool_)

    def work(low: int, high: int) -> None:
        if task.plain and task.limit >= 2 and not tidy:
            break_runs(task.start, task.limit, low, high, task.key, out)
        else:
            soft = np.int64(0) if task.soft is None else np.int64(round(task.soft * UNIT)) * SCALE
            solve_rows(
                task.start,
                task.limit,
                task.free,
                min(task.cap, 1 << 30),
                task.ring,
                soft,
                task.knit,
                task.relaxed,
                task.locked,
                task.weights,
                np.int64(round(tidy * UNIT / 4095 * SCALE)),
                low,
                high,
                task.key,
                out,
                failed,
            )

    # Every second block first: a block sees the finished rows on both its sides, whoever works on it. Then all again:
    # a row now knows where the flips above it came to stand.
    for turn in range(4 if out.size <= LARGE else 2):
        first = turn % 2 * BLOCK
        if first < rows:
            blocks = len(range(first, rows, 2 * BLOCK))

            def nth(k: int, _: int, first: int = first) -> None:
                work(first + k * 2 * BLOCK, min(first + k * 2 * BLOCK + BLOCK, rows))

            share(blocks, 1, nth)
    impossible(failed, task)
    return out


def impossible(failed: Array, task: Task) -> None:
    """Raise TambourError naming the rows that have no lawful way."""
    length = f"{task.limit} stitch" + "es" * (task.limit != 1)
    rows = np.flatnonzero(failed)
    if len(rows):
        raise TambourError(
            [
                Problem(
                    f"the floats in row {task.first + r + 1} would be longer than {length}: too many stitches of one colour"
                    " are held side by side",
                    "hold fewer, let floats be longer there ({--relax}), or everywhere ({--max-float})",
                    where="{--lock}",
                )
                for r in rows[:20]
            ]
        )


# How much a flip dislikes another dx columns and dy rows away: (dy, dx), a Gaussian of 1.5 stitches, half as much again in
# the same column, where the eye joins dots into lines.
DISLIKE = np.round(
    600 * np.exp(-(np.arange(4)[:, None] ** 2 + np.arange(3)[None] ** 2) / 4.5) * np.array([1.5, 1.0, 1.0])
).astype(np.int64)


@kernel
def preference(start: Array, cells: Array, y: int, x: int, key: np.uint64) -> np.int64:
    """How unwelcome a flip at (y, x) is, by the flips about it: below 2^12.

    Flips keep apart, as dots of blue noise do; three in a column, or on a diagonal, are a line, which is worst.
    """
    rows, stitches = start.shape
    cost = np.int64(mix(key, np.uint64(y * stitches + x)) >> np.uint64(57))  # 0 … 127
    upright = rising = falling = 0  # bit k: a flip k - 2 rows away along the line
    for dy in range(max(-3, -y), min(4, rows - y)):
        if dy == 0:
            continue
        for dx in range(max(-2, -x), min(3, stitches - x)):
            if cells[y + dy, x + dx] == start[y + dy, x + dx]:
                continue
            cost += DISLIKE[abs(dy), abs(dx)]
            if abs(dy) <= 2:
                bit = 1 << (dy + 2)
                upright |= bit if dx == 0 else 0
                rising |= bit if dx == dy else 0
                falling |= bit if dx == -dy else 0
    if upright & 3 == 3 or upright & 10 == 10 or upright & 24 == 24:
        cost += 1500
    for line in (rising, falling):
        if line & 3 == 3 or line & 10 == 10 or line & 24 == 24:
            cost += 400
    return min(cost, np.int64(4095))


@kernel
def break_runs(start: U1x2, f: int, low: int, high: int, key: np.uint64, out: U1x2) -> None:
    """Flip ⌊L / (f + 1)⌋ stitches of every run, where they line up least; for plain anchored rows, f ≥ 2.

    In a run of L = q (f + 1) + r the j-th flip stands at most f - r before stitch j (f + 1) of it, and no flip lags
    less behind than the one before it: a small dynamic programme over the lags.
    """
    stitches = start.shape[1]
    best = np.zeros((stitches // (f + 1) + 1, f + 1), np.int64)
    back = np.zeros((stitches // (f + 1) + 1, f + 1), np.int32)
    huge = np.int64(1) << 50
    for y in range(low, high):
        begin = 0
        while begin < stitches:
            end = begin + 1
            while end < stitches and start[y, end] == start[y, begin]:
                end += 1
            for x in range(begin, end):
                out[y, x] = start[y, x]
            q = (end - begin) // (f + 1)
            slack = f - (end - begin) % (f + 1)
            for j in range(q):
                for lag in range(slack + 1):
                    x = begin + (j + 1) * (f + 1) - 1 - lag
                    if slack == 0:
                        best[j, 0], back[j, 0] = 0, 0  # there is but one way
                        break
                    best[j, lag] = huge
                    # Both ends stay as they are: a flip there would lengthen the run beside it.
                    if x <= begin or x >= end - 1:
                        continue
                    cost = preference(start, out, y, x, key)
                    if j == 0:
                        best[j, lag] = cost
                        continue
                    for before in range(max(0, lag - f + 1), lag + 1):
                        if best[j - 1, before] + cost < best[j, lag]:
                            best[j, lag] = best[j - 1, before] + cost
                            back[j, lag] = before
            if q:
                lag = 0
                for k in range(slack + 1):
                    if best[q - 1, k] < best[q - 1, lag]:
                        lag = k
                for j in range(q - 1, -1, -1):
                    x = begin + (j + 1) * (f + 1) - 1 - lag
                    out[y, x] = 1 - start[y, x]
                    lag = back[j, lag]
            begin = end


@kernel
def solve_rows(
    start: U1x2,
    f: int,
    free: bool,
    cap: int,
    ring: bool,
    soft: np.int64,
    knit: B1x2,
    relaxed: B1x2,
    locked: B1x2,
    weights: F4x2,
    tidy: np.int64,
    low: int,
    high: int,
    key: np.uint64,
    out: U1x2,
    failed: B1x1,
) -> None:
    """The general case, row by row."""
    stitches = start.shape[1]
    columns = np.zeros(stitches, np.int32)
    row = np.zeros(stitches, np.uint8)
    flip = np.zeros(stitches, np.int64)
    loose = np.zeros(stitches, np.bool_)
    found = np.zeros(stitches, np.uint8)
    states = 2 * (f + 4)
    back = np.zeros((stitches, states), np.int16)
    for y in range(low, high):
        n = sequence(y, stitches, knit, columns)
        if n == 0:
            continue
        for x in range(stitches):
            out[y, x] = start[y, x]
        for k in range(n):
            x = columns[k]
            row[k] = start[y, x]
            loose[k] = relaxed.size > 0 and relaxed[y, x]
            weight = np.int64(round(weights[y, x] * UNIT)) if weights.size else np.int64(UNIT)
            dislike = preference(start, out, y, x, key)
            flip[k] = weight * SCALE + dislike * (1 + tidy)
            if locked.size and locked[y, x]:
                flip[k] = INFINITE
        cost = (
            solve_ring(row, flip, loose, n, f, soft, back, found)
            if ring
            else solve_line(row, flip, loose, n, f, free, cap, soft, -1, back, found)
        )
        failed[y] = cost >= np.int64(1) << 60
        if not failed[y]:
            for k in range(n):
                out[y, columns[k]] = found[k]


@kernel
def solve_ring(
    row: Array, flip: Array, loose: Array, n: int, f: int, soft: np.int64, back: Array, found: Array
) -> np.int64:
    """A closed row: the best over every state that it can be entered in and left in again."""
    best = INFINITE
    chosen = -1
    if n <= f:
        # So short a round may be all of one colour, or anything else.
        for k in range(n):
            found[k] = row[k]
        return np.int64(0)
    width = f + 4
    for state in range(2 * width):
        k = state % width
        if k > f + 1 or (k == f + 1 and soft == 0) or (k == 0) != loose[n - 1]:
            continue
        cost = solve_line(row, flip, loose, n, f, False, 0, soft, state, back, found)
        if cost < best:
            best, chosen = cost, state
    if chosen >= 0:
        solve_line(row, flip, loose, n, f, False, 0, soft, chosen, back, found)
    return best


@kernel
def solve_line(
    row: Array,
    flip: Array,
    loose: Array,
    n: int,
    f: int,
    free: bool,
    cap: int,
    soft: np.int64,
    enter: int,
    back: Array,
    found: Array,
) -> np.int64:
    """Least cost of ``row`` with runs up to f; fills ``found``; 2^60 and more when there is no way.

    State c (f + 4) + k: colour c, and k = 1 … f the run since the last relaxed stitch, 0 just after one, f + 1 too long
    (at a price, when ``soft``), f + 2 still in the first run of the row, f + 3 in its last, both free up to ``cap``.
    ``enter``: -1, or the state that a closed row is entered in, and must be left in.
    """
    width = f + 4
    now = np.full(2 * width, INFINITE, np.int64)
    then = np.full(2 * width, INFINITE, np.int64)
    if enter >= 0:
        now[enter] = 0
    for x in range(n):
        for c in range(2):
            price = np.int64(0) if row[x] == c else flip[x]
            o, other = c * width, (1 - c) * width
            for k in range(width):
                then[o + k] = INFINITE
            # The best way to change colour here.
            change, source = INFINITE, 0
            if x == 0 and enter < 0:
                change, source = np.int64(0), -1
            else:
                for k in range(f + 3):
                    if now[other + k] < change:
                        change, source = now[other + k], other + k
            if price >= INFINITE:
                continue
            if loose[x]:
                value, origin = change, source
                for k in range(f + 2):
                    if now[o + k] < value:
                        value, origin = now[o + k], o + k
                then[o] = value + price
                back[x, o] = origin
            else:
                value, origin = change, source
                if now[o] < value:
                    value, origin = now[o], o
                then[o + 1] = value + price
                back[x, o + 1] = origin
                for k in range(2, f + 1):
                    then[o + k] = now[o + k - 1] + price
                    back[x, o + k] = o + k - 1
                if soft:
                    origin = o + f if now[o + f] <= now[o + f + 1] else o + f + 1
                    then[o + f + 1] = now[origin] + price + soft
                    back[x, o + f + 1] = origin
            if free:
                if x + 1 <= cap:
                    then[o + f + 2] = price if x == 0 else now[o + f + 2] + price
                    back[x, o + f + 2] = o + f + 2
                if n - x <= cap:
                    value, origin = change, source
                    if now[o + f + 3] < value:
                        value, origin = now[o + f + 3], o + f + 3
                    then[o + f + 3] = value + price
                    back[x, o + f + 3] = origin
        for s in range(2 * width):
            now[s] = min(then[s], INFINITE)
    state = 0 if enter < 0 else enter
    if enter < 0:
        for s in range(2 * width):
            if now[s] < now[state]:
                state = s
    cost = now[state]
    for x in range(n - 1, -1, -1):
        found[x] = state // width
        state = back[x, state]
    return cost

"""The solvers of Kryven and Fourquet (2013), with their readings settled.

A "conflict" is a stitch in a run that is too long. A flip's gain is the drop in conflicts, so that a run of 2f + 1 broken
in its middle gains 2f + 1, as their figure 8 says. Random Walk goes on while at least q of n sampled stitches are in
conflict (their caption, not their text). Texturing steps f + 1, the first illegal length.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from tambour.core.arrays import B1x1, B1x2, U1x1, U1x2
from tambour.core.check import Array
from tambour.core.kernels import kernel
from tambour.knit.params import KnitParams
from tambour.knit.solve.floats import mark, sequence
from tambour.knit.task import Task
from tambour.noise import mix


def solve(task: Task, method: str, params: KnitParams) -> Array:
    """(R, C) uint8: the start assignment after ``method``; Random Walk and texturing may leave conflicts, by design."""
    out = task.start.copy()
    law = (task.limit, task.free, task.cap, task.ring, task.knit, task.relaxed, task.locked)
    if method in ("random-walk", "hybrid"):
        # The paper leaves the duration to its user; by default each stitch is looked at about four times.
        steps = 4 * out.size // params.walk_sample + 1 if params.walk_steps is None else params.walk_steps
        random_walk(out, *law, params.walk_sample, params.walk_stop, params.walk_gain, steps, task.key)
    if method in ("gsat", "hybrid"):
        greedy(out, *law, task.key)
    if method == "min-conflict":
        min_conflict(out, *law, task.key)
    if method == "texture":
        texturing(out, *law, task.key)
    return out


@kernel
def pick_of(key: Any, draw: Any, count: int) -> Any:
    """Number ``draw`` of the stream ``key``, in 0 … ``count`` - 1."""
    return np.int64(mix(key, draw) % np.uint64(count))


@kernel
def load(
    cells: Array,
    y: int,
    knit: Array,
    relaxed: Array,
    locked: Array,
    columns: Array,
    row: Array,
    loose: Array,
    held: Array,
) -> int:
    """The knitted stitches of row ``y`` as a sequence; gives how many."""
    n = sequence(y, cells.shape[1], knit, columns)
    for k in range(n):
        row[k] = cells[y, columns[k]]
        loose[k] = relaxed.size > 0 and relaxed[y, columns[k]]
        held[k] = locked.size > 0 and locked[y, columns[k]]
    return n


@kernel
def stretch(row: Array, loose: Array, n: int, f: int, free: bool, cap: int, ring: bool, x: int) -> tuple[int, int, int]:
    """(first, last, conflicts) of the stretch of one colour, without relaxed stitches, that stitch ``x`` stands in.

    In the round ``first`` and ``last`` may lie outside 0 … n - 1.
    """
    if loose[x % n]:
        return x, x, 0
    colour = row[x % n]
    a = b = x
    while b - a + 1 < n and (ring or a > 0) and row[(a - 1) % n] == colour and not loose[(a - 1) % n]:
        a -= 1
    while b - a + 1 < n and (ring or b < n - 1) and row[(b + 1) % n] == colour and not loose[(b + 1) % n]:
        b += 1
    size = b - a + 1
    if size <= f:
        return a, b, 0
    if free:
        left, right = a, b
        while left > 0 and row[left - 1] == colour:
            left -= 1
        while right < n - 1 and row[right + 1] == colour:
            right += 1
        if (left == 0 or right == n - 1) and right - left + 1 <= cap:
            return a, b, 0
    return a, b, size


@kernel
def gain(row: U1x1, loose: B1x1, n: int, f: int, free: bool, cap: int, ring: bool, x: int) -> int:
    """By how much the conflicts of a row fall when stitch ``x`` is flipped."""
    before = conflicts_within(row, loose, n, f, free, cap, ring, x)
    row[x] = 1 - row[x]
    after = conflicts_within(row, loose, n, f, free, cap, ring, x)
    row[x] = 1 - row[x]
    return before - after


@kernel
def conflicts_within(row: Array, loose: Array, n: int, f: int, free: bool, cap: int, ring: bool, x: int) -> int:
    """Conflicts in the stretches of ``x`` - 1, ``x`` and ``x`` + 1, each stretch once."""
    a, b, total = stretch(row, loose, n, f, free, cap, ring, x)
    if b - a + 1 >= n:
        return total
    c = a
    if a == x and (ring or x > 0):
        c, _, more = stretch(row, loose, n, f, free, cap, ring, x - 1)
        total += more
    if b == x and (ring or x < n - 1) and not (ring and x + 1 - c >= n):
        total += stretch(row, loose, n, f, free, cap, ring, x + 1)[2]
    return total


@kernel
def greedy(
    cells: U1x2, f: int, free: bool, cap: int, ring: bool, knit: B1x2, relaxed: B1x2, locked: B1x2, key: np.uint64
) -> None:
    """GSAT (section 4.3): rank the row's stitches by gain, flip one of the best, rank that row again.

    Flips that gain nothing are taken while the row stays in conflict, at most four for every stitch.
    """
    rows, stitches = cells.shape
    columns = np.zeros(stitches, np.int32)
    row = np.zeros(stitches, np.uint8)
    loose = np.zeros(stitches, np.bool_)
    held = np.zeros(stitches, np.bool_)
    bad = np.zeros(stitches, np.bool_)
    gains = np.zeros(stitches, np.int64)
    draw = np.uint64(0)
    for y in range(rows):
        n = load(cells, y, knit, relaxed, locked, columns, row, loose, held)
        for _ in range(4 * n):
            if mark(row, loose, n, f, free, cap, ring, bad)[0] == 0:
                break
            best, ties = -(1 << 40), 0
            for x in range(n):
                if not bad[x] or held[x]:
                    continue
                gains[x] = gain(row, loose, n, f, free, cap, ring, x)
                if gains[x] > best:
                    best, ties = gains[x], 0
                ties += gains[x] == best
                # A flip that mends a longest breakable run is taken at once by the paper; it is the best there is.
            if ties == 0:
                break
            draw += np.uint64(1)
            pick = pick_of(key, draw, ties)
            for x in range(n):
                if bad[x] and not held[x] and gains[x] == best:
                    if pick == 0:
                        row[x] = 1 - row[x]
                        break
                    pick -= 1
        for k in range(n):
            cells[y, columns[k]] = row[k]


@kernel
def random_walk(
    cells: U1x2,
    f: int,
    free: bool,
    cap: int,
    ring: bool,
    knit: B1x2,
    relaxed: B1x2,
    locked: B1x2,
    sample: int,
    stop: int,
    threshold: int,
    steps: int,
    key: np.uint64,
) -> None:
    """Random Walk (section 4.1): of ``sample`` random stitches flip those in conflict that gain ``threshold`` or more.

    Ends when fewer than ``stop`` of a sample were in conflict, or after ``steps`` samples.
    """
    rows, stitches = cells.shape
    columns = np.zeros(stitches, np.int32)
    row = np.zeros(stitches, np.uint8)
    loose = np.zeros(stitches, np.bool_)
    held = np.zeros(stitches, np.bool_)
    draw = np.uint64(1) << np.uint64(40)
    for _ in range(steps):
        found = 0
        for _ in range(sample):
            draw += np.uint64(1)
            y = pick_of(key, draw, rows)
            n = load(cells, y, knit, relaxed, locked, columns, row, loose, held)
            if n == 0:
                continue
            draw += np.uint64(1)
            x = pick_of(key, draw, n)
            if stretch(row, loose, n, f, free, cap, ring, x)[2] == 0:
                continue
            found += 1
            if not held[x] and gain(row, loose, n, f, free, cap, ring, x) >= threshold:
                cells[y, columns[x]] = 1 - row[x]
        if found < stop or found == 0:
            break


@kernel
def min_conflict(
    cells: U1x2, f: int, free: bool, cap: int, ring: bool, knit: B1x2, relaxed: B1x2, locked: B1x2, key: np.uint64
) -> None:
    """Min-Conflict (section 4.2), averse to flips: a random stitch in conflict is flipped if that lessens conflicts.

    Runs to the end. Rows are independent, so their order does not matter. A row is left when fifty stitches in turn for
    each of its own gained nothing, which only locked stitches, free edges and tiny rows can cause.
    """
    rows, stitches = cells.shape
    columns = np.zeros(stitches, np.int32)
    row = np.zeros(stitches, np.uint8)
    loose = np.zeros(stitches, np.bool_)
    held = np.zeros(stitches, np.bool_)
    bad = np.zeros(stitches, np.bool_)
    draw = np.uint64(2) << np.uint64(40)
    for y in range(rows):
        n = load(cells, y, knit, relaxed, locked, columns, row, loose, held)
        total = mark(row, loose, n, f, free, cap, ring, bad)[0]
        idle = 0
        while total > 0 and idle < 50 * n:
            draw += np.uint64(1)
            pick = pick_of(key, draw, total)
            idle += 1
            for x in range(n):
                if bad[x]:
                    if pick == 0:
                        if not held[x] and gain(row, loose, n, f, free, cap, ring, x) > 0:
                            row[x] = 1 - row[x]
                            total = mark(row, loose, n, f, free, cap, ring, bad)[0]
                            idle = 0
                        break
                    pick -= 1
        for k in range(n):
            cells[y, columns[k]] = row[k]


@kernel
def texturing(
    cells: U1x2, f: int, free: bool, cap: int, ring: bool, knit: B1x2, relaxed: B1x2, locked: B1x2, key: np.uint64
) -> None:
    """Pseudo-random texturing (section 4.5, algorithm 4.2): break each long run at a random shift, then every f + 1.

    As written it does not look at the run after; where a last flip lengthens that, a conflict may remain.
    """
    rows, stitches = cells.shape
    columns = np.zeros(stitches, np.int32)
    row = np.zeros(stitches, np.uint8)
    loose = np.zeros(stitches, np.bool_)
    held = np.zeros(stitches, np.bool_)
    bad = np.zeros(stitches, np.bool_)
    draw = np.uint64(3) << np.uint64(40)
    for y in range(rows):
        n = load(cells, y, knit, relaxed, locked, columns, row, loose, held)
        mark(row, loose, n, f, free, cap, ring, bad)
        x = 0
        while x < n:
            if not bad[x]:
                x += 1
                continue
            end = x
            while end < n and bad[end] and row[end] == row[x]:
                end += 1
            draw += np.uint64(1)
            at = x + pick_of(key, draw, f)
            while at < end:
                if not held[at]:
                    cells[y, columns[at]] = 1 - row[at]
                at += f + 1
            x = end

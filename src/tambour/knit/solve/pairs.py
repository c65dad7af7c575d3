"""Pairs: the exact best row in colour, for each pair of yarns, or for rows whose pairs are known.

A row of dark and light yarn has the colours dark + b (light - dark), so the blurred error in three channels is again a
quadratic form of its bits; only |light - dark|² scales its pair terms. Divided by that it is the form of ``lanes``.
"""

from __future__ import annotations

import numpy as np

from tambour.core.arrays import B1x1, B1x2, F4x1, F4x2, F4x3, F8x1, I8x1, U1x2
from tambour.core.check import Array
from tambour.core.kernels import kernel
from tambour.knit.solve.floats import sequence
from tambour.knit.solve.lanes import best_rows, cleared, lanes_of
from tambour.knit.solve.percept import lay, linear


@kernel
def terms(
    y: int,
    error: Array,
    aim: Array,
    across: Array,
    down: Array,
    columns: Array,
    n: int,
    ring: bool,
    z: Array,
    rest: Array,
    goal: Array,
    one: Array,
) -> None:
    """What the costs of row ``y`` are made of, filtered along the row (twice the sum over scales), at knitted columns.

    rest (3, n) : of the error of the rows about it; goal (3, n) : of its own target; one (n,) : of 1.
    """
    rows, stitches = aim.shape[:2]
    reach = down.shape[1] - 1
    for c in range(3):
        for s in range(down.shape[0]):
            for x in range(stitches):
                z[s, x] = 0
            for d in range(-reach, reach + 1):
                w = down[s, abs(d)]
                if d != 0 and 0 <= y + d < rows and w != 0:
                    for x in range(stitches):
                        z[s, x] += w * error[y + d, x, c]
        linear(z, across, columns, n, ring, rest[c])
        for s in range(down.shape[0]):
            z[s, :] = 0
            for k in range(n):
                z[s, columns[k]] = down[s, 0] * aim[y, columns[k], c]
        linear(z, across, columns, n, ring, goal[c])
    for s in range(down.shape[0]):
        z[s, :] = 0
        for k in range(n):
            z[s, columns[k]] = down[s, 0]
    linear(z, across, columns, n, ring, one)


@kernel
def colour_line(
    y: int,
    aim: Array,
    dark: Array,
    way: Array,
    own: np.float32,
    columns: Array,
    n: int,
    rest: Array,
    goal: Array,
    one: Array,
    u: Array,
) -> float:
    """u (n,): linear costs of the light yarn, over |way|²; gives the cost of an all dark row."""
    size = way[0] * way[0] + way[1] * way[1] + way[2] * way[2]
    constant = 0.0
    for k in range(n):
        u[k] = own
    for c in range(3):
        for k in range(n):
            whole = rest[c, k] + dark[c] * one[k] - goal[c, k]
            u[k] += way[c] * whole / size
            constant += 0.5 * (dark[c] - aim[y, columns[k], c]) * (rest[c, k] + whole)
    return constant


@kernel
def pair_rows(
    y: int,
    error: F4x3,
    aim: F4x3,
    dark: F4x2,
    ways: F4x2,
    knit: B1x2,
    relaxed: B1x2,
    soft: float,
    f: int,
    free: bool,
    cap: int,
    across: F4x2,
    down: F4x2,
    table: F4x1,
    costs: F8x1,
    rows_out: U1x2,
) -> None:
    """For each pair of yarns (dark, dark + way; (N, 3)) the best row ``y`` and its cost, the other rows as they are."""
    stitches = aim.shape[1]
    pairs = len(dark)
    bits = across.shape[1] - 1
    columns = np.zeros(stitches, np.int32)
    n = sequence(y, stitches, knit, columns)
    if n == 0:
        return
    z = np.zeros((across.shape[0], stitches), np.float32)
    rest = np.zeros((3, stitches), np.float32)
    goal = np.zeros((3, stitches), np.float32)
    one = np.zeros(stitches, np.float32)
    u = np.zeros(stitches, np.float32)
    terms(y, error, aim, across, down, columns, n, False, z, rest, goal, one)
    own = np.float32(0)
    for s in range(across.shape[0]):
        own += across[s, 0] * down[s, 0]
    to = lanes_of(n, bits, f, free)
    constant = np.zeros(8, np.float64)
    nothing = np.zeros((0, 0), np.bool_)
    blank = np.zeros((1, 1), np.uint8)
    for first in range(0, pairs, 8):
        used = min(8, pairs - first)
        for lane in range(8):
            p = min(first + lane, pairs - 1)
            way = ways[p]
            constant[lane] = colour_line(y, aim, dark[p], way, own, columns, n, rest, goal, one, u)
            size = way[0] * way[0] + way[1] * way[1] + way[2] * way[2]
            to.Z[:] = np.float32(0)
            lay(y, blank, u, columns, n, bits, f, np.float32(soft / size), False, 0, relaxed, nothing, lane, to)
        best_rows(to, n, table, bits, f, free, cap)
        for lane in range(used):
            way = ways[first + lane]
            size = way[0] * way[0] + way[1] * way[1] + way[2] * way[2]
            costs[first + lane] = constant[lane] + size * to.cost[lane]
            for k in range(n):
                rows_out[first + lane, columns[k]] = to.out[k * 8 + lane]


@kernel
def colour_batches(
    mine: I8x1,
    cells: U1x2,
    error: F4x3,
    aim: F4x3,
    dark: F4x2,
    ways: F4x2,
    knit: B1x2,
    relaxed: B1x2,
    soft: float,
    f: int,
    free: bool,
    cap: int,
    ring: bool,
    shift: int,
    across: F4x2,
    down: F4x2,
    table: F4x1,
    changed: B1x1,
) -> None:
    """Solve the rows ``mine`` with their pairs, eight at a time, given all others; keeps ``error`` true."""
    stitches = cells.shape[1]
    bits = across.shape[1] - 1
    to = lanes_of(stitches + (bits if ring else 0), bits, f, free)
    columns = np.zeros((8, stitches), np.int32)
    z = np.zeros((across.shape[0], stitches), np.float32)
    rest = np.zeros((3, stitches), np.float32)
    goal = np.zeros((3, stitches), np.float32)
    one = np.zeros(stitches, np.float32)
    u = np.zeros(stitches, np.float32)
    nothing = np.zeros((0, 0), np.bool_)
    own = np.float32(0)
    for s in range(across.shape[0]):
        own += across[s, 0] * down[s, 0]
    for first in range(0, mine.size, 8):
        used = min(8, mine.size - first)
        longest = 0
        cleared(to)
        for lane in range(used):
            y = mine[first + lane]
            n = sequence(y, stitches, knit, columns[lane])
            # Short rounds stay as the exact solver left them.
            if n == 0 or (ring and n <= 2 * bits):
                continue
            terms(y, error, aim, across, down, columns[lane], n, ring, z, rest, goal, one)
            way = ways[y]
            colour_line(y, aim, dark[y], way, own, columns[lane], n, rest, goal, one, u)
            size = way[0] * way[0] + way[1] * way[1] + way[2] * way[2]
            price = np.float32(soft / size)
            lay(y, cells, u, columns[lane], n, bits, f, price, ring, shift, relaxed, nothing, lane, to)
            longest = max(longest, to.stitches[lane])
        if longest == 0:
            continue
        best_rows(to, longest, table, bits, f, free, cap)
        for lane in range(used):
            if to.stitches[lane] == 0 or to.cost[lane] >= 1e29:
                continue
            y = mine[first + lane]
            n = to.stitches[lane] - bits if ring else to.stitches[lane]
            turn = (shift * (n // 2 + 1)) % n if ring else 0
            for k in range(n):
                x = columns[lane, (k + turn) % n]
                bit = to.out[k * 8 + lane]
                if cells[y, x] != bit:
                    cells[y, x] = bit
                    changed[y] = True
                    for c in range(3):
                        error[y, x, c] = dark[y, c] + bit * ways[y, c] - aim[y, x, c]

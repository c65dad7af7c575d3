"""Perceptual: the lawful chart that looks most like the picture from two distances, row by row exactly.

The energy is the squared error seen through two Gaussian blurs, of 2.3 and of 1.0 stitches (the paper judges by a
blur; one blur alone is over-fitted by stripes that another distance shows), plus, if wished, a price for every flip:

    E(b) = Σ_s w_s |k_s * (b - t)|²  +  keep Σ weight [b ≠ start]

With all other rows fixed, the part of E that a row has is a quadratic form of its bits whose terms reach 2r stitches, r
being the radius at which the kernel is cut off. Its least lawful value is found exactly (see ``lanes``). Rows further
apart than the kernels reach do not see each other and are solved at once; sweeps go on until nothing changes, so E
never rises. Zero is assumed beyond the chart.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from tambour.core.arrays import B1x1, B1x2, F4x1, F4x2, I8x1, U1x2
from tambour.core.check import Array
from tambour.core.kernels import kernel
from tambour.core.progress import Progress
from tambour.core.threads import share
from tambour.knit.picture.tone import diffuse_floyd
from tambour.knit.solve import exact
from tambour.knit.solve.floats import sequence
from tambour.knit.solve.lanes import FORBIDDEN, LANES, Lanes, best_rows, cleared, lanes_of
from tambour.knit.task import Task

SCALES = ((2.3, 1.0), (1.0, 0.4))  # blur in stitches, weight
RADIUS = 4  # stitches at which the blurs are cut off: their products reach twice as far
ALONE = 50_000  # stitches that one thread solves before another is worth its start
LARGEST = 11  # longest float that the trellis can tell apart


@dataclass(frozen=True, eq=False, slots=True)
class Eye:
    """The energy's kernels: autocorrelations of the blurs.

    across : (S, R + 1) float32 along a row; down : (S, D + 1) float32 over rows, the scales' weights in it
    """

    across: Array
    down: Array

    @property
    def bits(self) -> int:
        return self.across.shape[1] - 1


def eye(limit: int, squash: float = 1.0, scales: tuple[tuple[float, float], ...] = SCALES, radius: int = RADIUS) -> Eye:
    """The kernels for floats up to ``limit``; ``squash`` = rows per stitch width (1 without a gauge)."""
    bits = max(2 * radius, limit + 1)
    wide = [autocorrelation(sigma, radius) for sigma, _ in scales]
    tall = [weight * autocorrelation(sigma * squash, max(1, round(radius * squash))) for sigma, weight in scales]
    across = np.zeros((len(scales), bits + 1), np.float32)
    down = np.zeros((len(scales), len(tall[0])), np.float32)
    for s in range(len(scales)):
        across[s, : len(wide[s])] = wide[s]
        down[s, : len(tall[s])] = tall[s]
    return Eye(across, down)


def autocorrelation(sigma: float, radius: int) -> Array:
    """(2 radius + 1,) of a Gaussian cut off at ``radius`` and summing to 1, at lags 0, 1, 2 and so on."""
    k = np.exp(-0.5 * (np.arange(-radius, radius + 1) / sigma) ** 2)
    k /= k.sum()
    return np.asarray(np.correlate(k, k, "full")[2 * radius :])


def trellis(across: Array, down: Array) -> Array:
    """(2^bits,) float32: what the latest stitches, as bits, add to the cost of a light stitch."""
    q = (across * down[:, :1]).sum(0, dtype=np.float64)
    bits = len(q) - 1
    h = np.arange(1 << bits)
    table = np.zeros(1 << bits)
    for k in range(1, bits + 1):
        table += 2 * q[k] * ((h >> (k - 1)) & 1)
    return table.astype(np.float32)


def solve(
    task: Task,
    sight: Eye,
    keep: float = 0.0,
    sweeps: int = 8,
    progress: Progress | None = None,
    cells: Array | None = None,
    dirty: Array | None = None,
) -> Array:
    """(R, C) uint8: lawful (unless the task is soft), and for each row the best there is given the others.

    task : its limit at most LARGEST
    keep : cost of a flip
    sweeps : at most so many times over all rows; fewer when nothing changes any more
    cells, dirty : go on from a chart, whose rows marked ``dirty`` (R,) are to be solved again
    """
    if cells is None:
        cells = np.zeros(task.start.shape, np.uint8)
        diffuse_floyd(task.tone, 0.5, cells)
        if task.locked.size:
            cells[task.locked] = task.start[task.locked]
        if task.ring:
            # Rounds are solved between stitches that stay, so they must be lawful from the beginning.
            cells = exact.solve(replace(task, start=cells, soft=None, weights=np.zeros((0, 0), np.float32)))
    tone = task.tone
    if task.knit.size:
        cells[~task.knit] = 0
        tone = np.where(task.knit, tone, np.float32(0))
    rows = len(cells)
    reach = sight.down.shape[1] - 1
    table = trellis(sight.across, sight.down)
    todo = np.ones(rows, np.bool_) if dirty is None else dirty.copy()
    failed = np.zeros(rows, np.bool_)
    soft = np.float32(FORBIDDEN if task.soft is None else task.soft)
    for sweep in range(sweeps):
        changed = np.zeros(rows, np.bool_)
        for phase in range(min(reach + 1, rows)):
            mine = np.arange(phase, rows, reach + 1)
            mine = mine[todo[mine]]
            if not len(mine):
                continue
            batches = -(-len(mine) // LANES)

            def work(low: int, high: int, mine: Array = mine, shift: int = sweep, changed: Array = changed) -> None:
                solve_batches(
                    mine[low * LANES : high * LANES],
                    cells,
                    tone,
                    task.start,
                    task.knit,
                    task.relaxed,
                    task.locked,
                    task.weights,
                    np.float32(keep),
                    soft,
                    task.limit,
                    task.free,
                    task.cap,
                    task.ring,
                    shift,
                    sight.across,
                    sight.down,
                    table,
                    changed,
                    failed,
                )

            share(batches, max(-(-ALONE // (LANES * cells.shape[1])), min(32, -(-batches // 2))), work)
            if progress is not None:
                progress.step(sweep * (reach + 1) + phase + 1, sweeps * (reach + 1))
        exact.impossible(failed, task)
        near = np.convolve(changed, np.ones(2 * reach + 1), "full")[reach : reach + rows] > 0.5
        # In the round every sweep moves the stitches that are held, so all rows may still gain.
        todo = near | changed if not task.ring else near | (np.full(rows, sweep < 2))
        if not todo.any():
            break
    return cells


@kernel
def solve_batches(
    mine: I8x1,
    cells: U1x2,
    tone: F4x2,
    start: U1x2,
    knit: B1x2,
    relaxed: B1x2,
    locked: B1x2,
    weights: F4x2,
    keep: np.float32,
    soft: np.float32,
    f: int,
    free: bool,
    cap: int,
    ring: bool,
    shift: int,
    across: F4x2,
    down: F4x2,
    table: F4x1,
    changed: B1x1,
    failed: B1x1,
) -> None:
    """Solve the rows ``mine``, eight at a time, given all others; note which changed, and which have no lawful way."""
    stitches = cells.shape[1]
    bits = across.shape[1] - 1
    to = lanes_of(stitches + (bits if ring else 0), bits, f, free)
    columns = np.zeros((8, stitches), np.int32)
    z = np.zeros((across.shape[0], stitches), np.float32)
    u = np.zeros(stitches, np.float32)
    for first in range(0, mine.size, 8):
        used = min(8, mine.size - first)
        longest = 0
        cleared(to)
        for lane in range(used):
            y = mine[first + lane]
            n = sequence(y, stitches, knit, columns[lane])
            if n == 0:
                continue
            seen(y, cells, tone, down, z)
            linear(z, across, columns[lane], n, ring, u)
            own = np.float32(0)
            for s in range(across.shape[0]):
                own += across[s, 0] * down[s, 0]
            for k in range(n):
                x = columns[lane, k]
                u[k] += own
                if keep > 0:
                    price = keep * weights[y, x] if weights.size else keep
                    u[k] += price if start[y, x] == 0 else -price
            if ring and n <= 2 * bits:
                best_ring(y, cells, u, columns[lane], n, across, down, f, soft, relaxed, locked, changed)
                continue
            lay(y, cells, u, columns[lane], n, bits, f, soft, ring, shift, relaxed, locked, lane, to)
            longest = max(longest, to.stitches[lane])
        if longest == 0:
            continue
        best_rows(to, longest, table, bits, f, free, cap)
        for lane in range(used):
            y = mine[first + lane]
            if to.stitches[lane] == 0:
                continue
            if to.cost[lane] >= 1e29:
                failed[y] = True
                continue
            n = to.stitches[lane] - bits if ring else to.stitches[lane]
            turn = (shift * (n // 2 + 1)) % n if ring else 0
            for k in range(n):
                x = columns[lane, (k + turn) % n]
                if cells[y, x] != to.out[k * 8 + lane]:
                    cells[y, x] = to.out[k * 8 + lane]
                    changed[y] = True


@kernel
def seen(y: int, cells: Array, tone: Array, down: Array, z: Array) -> None:
    """z (S, C): per scale, the error of the rows about ``y`` as seen from it, less the tone of ``y`` itself."""
    rows, stitches = cells.shape
    reach = down.shape[1] - 1
    for s in range(z.shape[0]):
        c = down[s, 0]
        for x in range(stitches):
            z[s, x] = -c * tone[y, x]
        for d in range(-reach, reach + 1):
            c = down[s, abs(d)]
            if d == 0 or y + d < 0 or y + d >= rows or c == 0:
                continue
            there, aim, sum_ = cells[y + d], tone[y + d], z[s]
            for x in range(stitches):
                sum_[x] += c * (np.float32(there[x]) - aim[x])


@kernel
def linear(z: Array, across: Array, columns: Array, n: int, ring: bool, u: Array) -> None:
    """u (n,): twice the sum over scales of z (S, C) filtered along the row, at the ``n`` knitted columns."""
    reach = across.shape[1] - 1
    stitches = z.shape[1]
    padded = np.zeros(stitches + 2 * reach, np.float32)
    found = np.zeros(stitches, np.float32)
    for s in range(z.shape[0]):
        for x in range(stitches):
            padded[reach + x] = z[s, x]
        if ring:
            for k in range(reach):
                padded[reach - 1 - k] = z[s, (stitches - 1 - k) % stitches]
                padded[reach + stitches + k] = z[s, k % stitches]
        for d in range(-reach, reach + 1):
            c = np.float64(2) * across[s, abs(d)]  # double: products are rounded once, as they are added
            if c == 0:
                continue
            moved = padded[reach + d : reach + d + stitches]
            for x in range(stitches):
                found[x] += c * moved[x]
    for k in range(n):
        u[k] = found[columns[k]]


@kernel
def lay(
    y: int, cells: Array, u: Array, columns: Array, n: int, bits: int, f: int, soft: np.float32, ring: bool, shift: int,
    relaxed: Array, locked: Array, lane: int, to: Lanes,
) -> None:  # fmt: skip
    """Lay a row of ``n`` stitches into a lane, closed or flat."""
    if ring:
        lay_ring(y, cells, u, columns, n, bits, f, soft, shift, relaxed, locked, lane, to)
    else:
        lay_line(y, cells, u, columns, n, f, soft, relaxed, locked, lane, to)
    to.stitches[lane] = n + bits if ring else n


@kernel
def lay_line(
    y: int,
    cells: Array,
    u: Array,
    columns: Array,
    n: int,
    f: int,
    soft: np.float32,
    relaxed: Array,
    locked: Array,
    lane: int,
    to: Lanes,
) -> None:
    """Lay a flat row into lane ``lane``."""
    firm = 0
    for k in range(n):
        x = columns[k]
        to.U[k * 8 + lane] = u[k]
        if locked.size and locked[y, x]:
            if cells[y, x]:
                to.Z[k * 8 + lane] = np.float32(1e30)
            else:
                to.U[k * 8 + lane] = np.float32(1e30)
        firm = 0 if relaxed.size and relaxed[y, x] else firm + 1
        to.pen[k * 8 + lane] = soft if firm > f else np.float32(0)


@kernel
def lay_ring(
    y: int,
    cells: Array,
    u: Array,
    columns: Array,
    n: int,
    bits: int,
    f: int,
    soft: np.float32,
    shift: int,
    relaxed: Array,
    locked: Array,
    lane: int,
    to: Lanes,
) -> None:
    """Lay a closed row into lane ``lane``: cut somewhere, ``bits`` stitches held there, and told again at its end."""
    turn = (shift * (n // 2 + 1)) % n
    firm = 0
    for k in range(n + bits):
        x = columns[(k + turn) % n]
        to.U[k * 8 + lane] = u[(k + turn) % n] if bits <= k < n else np.float32(0)
        if k < bits or k >= n or (locked.size and locked[y, x]):
            if cells[y, x]:
                to.Z[k * 8 + lane] = np.float32(1e30)
            else:
                to.U[k * 8 + lane] = np.float32(1e30)
        firm = 0 if relaxed.size and relaxed[y, x] else firm + 1
        # Windows that lie in the held stitches alone are as they are.
        to.pen[k * 8 + lane] = soft if firm > f and bits <= k < n + f else np.float32(0)


@kernel
def best_ring(
    y: int,
    cells: Array,
    u: Array,
    columns: Array,
    n: int,
    across: Array,
    down: Array,
    f: int,
    soft: np.float32,
    relaxed: Array,
    locked: Array,
    changed: Array,
) -> None:
    """The best of a round too short for a trellis, by trying single flips and pairs of them until none is better."""
    reach = across.shape[1] - 1
    q = np.zeros(n, np.float64)
    for s in range(across.shape[0]):
        for d in range(-reach, reach + 1):
            q[d % n] += across[s, abs(d)] * down[s, 0]
    row = np.zeros(n, np.uint8)
    for k in range(n):
        row[k] = cells[y, columns[k]]
    best = float(ring_energy(row, u, q, f, soft, relaxed, y, columns))
    better = True
    while better:
        better = False
        for a in range(n):
            for b in range(a, n):
                if locked.size and (locked[y, columns[a]] or locked[y, columns[b]]):
                    continue
                row[a] = 1 - row[a]
                if b > a:
                    row[b] = 1 - row[b]
                energy = ring_energy(row, u, q, f, soft, relaxed, y, columns)
                if energy < best - 1e-9:
                    best = energy
                    better = True
                else:
                    row[a] = 1 - row[a]
                    if b > a:
                        row[b] = 1 - row[b]
    for k in range(n):
        if cells[y, columns[k]] != row[k]:
            cells[y, columns[k]] = row[k]
            changed[y] = True


@kernel
def ring_energy(
    row: Array, u: Array, q: Array, f: int, soft: np.float32, relaxed: Array, y: int, columns: Array
) -> float:
    """Cost of a short round: its linear and pair terms, and its windows that are too long."""
    n = row.size
    total = np.float64(0)
    for k in range(n):
        if row[k]:
            total += u[k]
            for j in range(k):
                if row[j]:
                    total += 2 * q[k - j]
    run = 0
    if n > f:
        for k in range(n + f):
            if k and row[k % n] != row[(k - 1) % n]:
                run = 0
            run = 0 if relaxed.size and relaxed[y, columns[k % n]] else run + 1
            if run > f and k >= f:
                total += float(soft)
    return total

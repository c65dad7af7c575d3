"""Areas: each stitch one of many yarns, in areas as large as the picture lets them be and no narrower than a law says.

The energy is a distance to each stitch's yarn and a price for each border between two yarns, less where the picture has
an edge of its own (a Potts model with contrast, as in Boykov and Jolly 2001). A row is solved exactly, the rows above
and below it being as they are, by a shortest path over (yarn, stitches of it so far); sweeps go on until nothing changes.
"""

from __future__ import annotations

import numpy as np

from tambour.core.arrays import B1x2, F4x1, F4x2, F4x3, I8x1, U1x2
from tambour.core.check import Array
from tambour.core.kernels import kernel
from tambour.knit.solve.floats import sequence

SWEEPS = 24
ROUNDS = 8  # at most, of sweeps and of giving small areas away
DEAR = np.float32(0.05)  # squared distance by which a small area's own yarn grows dearer
FAR = np.float32(1e30)


def solve(cost: Array, across: Array, up: Array, least: int, knit: Array, fewest: int = 0) -> Array:
    """(R, C) uint8: the yarn of each stitch.

    cost : (R, C, K) float32 of each yarn; across, up : (R, C) float32, prices of a border to the stitch on the left
        and to the one below; least : stitches that an area has in a row, at least; knit : (R, C) bool, or empty;
        fewest : stitches below which a whole area is given to its neighbours
    """
    cells = np.ascontiguousarray(cost.argmin(2), np.uint8)
    sweep(cost, across, np.zeros_like(up), least, knit, cells, 0)
    for _ in range(ROUNDS):
        for turn in range(SWEEPS):
            if not sweep(cost, across, up, least, knit, cells, turn):
                break
        small = too_small(cells, fewest)
        if not small.any():
            break
        # Neighbours take what is too small: there its own yarn is too dear from now on.
        r, x = np.nonzero(small)
        cost = cost.copy()
        cost[r, x, cells[r, x]] += DEAR
    return cells


def too_small(cells: Array, fewest: int) -> Array:
    """(R, C) bool: stitches in areas of fewer than ``fewest`` stitches."""
    from scipy.ndimage import label

    found = np.zeros(cells.shape, np.bool_)
    for k in range(int(cells.max(initial=0)) + 1) if fewest else ():
        island, _ = label(cells == k)
        found |= (np.bincount(island.ravel()) < fewest)[island] & (island > 0)
    return found


@kernel
def sweep(cost: F4x3, across: F4x2, up: F4x2, least: int, knit: B1x2, cells: U1x2, turn: int) -> bool:
    """Solve the rows of ``cells`` once, upwards or (odd turns) downwards; whether any changed."""
    rows, stitches, yarns = cost.shape
    columns = np.zeros(stitches, np.int64)
    one = np.zeros((stitches, yarns), np.float32)
    gate = np.zeros(stitches, np.float32)
    found = np.zeros(stitches, np.int64)
    changed = False
    for k in range(rows):
        y = k if turn % 2 == 0 else rows - 1 - k
        n = sequence(y, stitches, knit, columns)
        if n == 0:
            continue
        for i in range(n):
            x = columns[i]
            gate[i] = across[y, x]
            for c in range(yarns):
                price = cost[y, x, c]
                if y > 0 and (knit.size == 0 or knit[y - 1, x]) and cells[y - 1, x] != c:
                    price += up[y, x]
                if y + 1 < rows and (knit.size == 0 or knit[y + 1, x]) and cells[y + 1, x] != c:
                    price += up[y + 1, x]
                one[i, c] = price
        best_line(one[:n], gate[:n], least, found)
        for i in range(n):
            if cells[y, columns[i]] != found[i]:
                cells[y, columns[i]] = found[i]
                changed = True
    return changed


@kernel
def best_line(cost: F4x2, gate: F4x1, least: int, found: I8x1) -> None:
    """The row of least cost (N, K) with a price ``gate`` (N,) of each border and runs of ``least`` and more, in
    ``found``; a row too short for two areas is of one yarn."""
    n, yarns = cost.shape
    m = max(1, min(least, n))
    value = np.full((yarns, m), FAR, np.float32)
    after = np.full((yarns, m), FAR, np.float32)
    back = np.zeros((n, yarns, m), np.int32)  # where from: the yarn times m plus the state
    for c in range(yarns):
        value[c, 0] = cost[0, c]
    for i in range(1, n):
        # The two best yarns that may end here: a border comes from the better one that is another yarn.
        first, second = -1, -1
        for c in range(yarns):
            if first < 0 or value[c, m - 1] < value[first, m - 1]:
                second = first
                first = c
            elif second < 0 or value[c, m - 1] < value[second, m - 1]:
                second = c
        for c in range(yarns):
            source = first if c != first else second
            border = value[source, m - 1] + gate[i] if source >= 0 else FAR
            for j in range(m):
                if j == 0:
                    best, where = border, source * m + m - 1
                    if m == 1 and value[c, 0] <= best:
                        best, where = value[c, 0], c
                else:
                    best, where = value[c, j - 1], c * m + j - 1
                    if j == m - 1 and value[c, j] <= best:
                        best, where = value[c, j], c * m + j
                after[c, j] = best + cost[i, c] if best < FAR else FAR
                back[i, c, j] = where
        for c in range(yarns):
            for j in range(m):
                value[c, j] = after[c, j]
    c = 0
    for k in range(yarns):
        if value[k, m - 1] < value[c, m - 1]:
            c = k
    j = m - 1
    for i in range(n - 1, -1, -1):
        found[i] = c
        where = back[i, c, j]
        c, j = where // m, where % m


def narrow(cells: Array, least: int, knit: Array) -> int:
    """How many areas of (R, C) ``cells`` are narrower than ``least`` stitches in some row."""
    count = 0
    for r, row in enumerate(cells):
        line = row if not knit.size else row[knit[r]]
        at = np.flatnonzero(np.diff(line)) + 1
        widths = np.diff(np.concatenate([[0], at, [len(line)]]))
        count += int((widths < min(least, len(line))).sum())
    return count


@kernel
def diffuse(light: F4x3, yarns: F4x2, out: U1x2) -> None:
    """The nearest yarn (K, 3) of each stitch of ``light`` (R, C, 3), the rest going on to its neighbours: 7, 3, 5 and 1
    sixteenths, from the top row (the last) down. What goes on is held within the range, so that no colour bleeds far."""
    rows, stitches = out.shape
    error = np.zeros((2, stitches + 2, 3), np.float32)
    want = np.zeros(3, np.float32)
    for k in range(rows):
        y = rows - 1 - k
        here, below = error[k % 2], error[(k + 1) % 2]
        below[:] = 0
        for x in range(stitches):
            for c in range(3):
                want[c] = min(max(light[y, x, c] + here[x + 1, c], np.float32(-0.25)), np.float32(1.25))
            best, least = 0, np.float32(1e30)
            for i in range(yarns.shape[0]):
                far = np.float32(0)
                for c in range(3):
                    far += (want[c] - yarns[i, c]) ** 2
                if far < least:
                    best, least = i, far
            out[y, x] = best
            for c in range(3):
                rest = (want[c] - yarns[best, c]) / 16
                here[x + 2, c] += 7 * rest
                below[x, c] += 3 * rest
                below[x + 1, c] += 5 * rest
                below[x + 2, c] += rest

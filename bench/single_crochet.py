"""The course of the yarn through a single crochet: found once, in a lattice of equal stitches; what it prints stands in
`tambour/crochet/yarn/loops.py`.

python bench/single_crochet.py [--under]

A course is drawn by hand, thin and loose, with the crossings that a hook makes. Then the yarn is thickened step by step
while it is drawn tight, may not come nearer to itself or to its neighbours than its own width, resists bending and is
held, softly, to the drawing. The lattice may shear: that columns of stitches lean is found, not asked for. How tight is
chosen so that a stitch takes the yarn that hands take (`LENGTH`).
"""

from __future__ import annotations

import sys

import numpy as np

from tambour.core.arrays import F8x1, F8x2
from tambour.core.kernels import kernel
from tambour.crochet.yarn import clearance, loops, near
from tambour.crochet.yarn.loops import BAR, LOOP, RATIO, TOP

LENGTH = 8.0
"""Yarn in a stitch, in its widths, as makers unravelled and published it."""
POINTS = 88

# u to the next stitch, v up, w towards the worker, and how strongly the yarn is held there. Behind the work down to the hole;
BEHIND = [
    (-0.26, 0.60, -0.24, 0.02),
    (-0.27, 0.30, -0.30, 0.02),
    (-0.20, 0.06, -0.28, 0.02),
    (-0.14, -0.10, -0.20, 0.02),
]
# under both top strands of the stitch below, up in front, over and behind the yarn that will be drawn through, and back;
OVER = [
    (-0.13, -0.14, 0.00, 0.02), (-0.15, -0.08, 0.19, 0.05), (-0.19, 0.12, 0.29, 0.10), (-0.17, 0.40, 0.31, 0.10),
    (-0.10, 0.66, 0.27, 0.10), (0.02, 0.88, 0.14, 0.05), (0.26, 0.95, -0.02, 0.05), (0.48, 0.90, -0.22, 0.05),
    (0.58, 0.74, -0.32, 0.05), (0.58, 0.60, -0.16, 0.08), (0.52, 0.50, 0.12, 0.10), (0.42, 0.32, 0.26, 0.10),
    (0.24, 0.06, 0.24, 0.10), (0.13, -0.10, 0.10, 0.02), (0.13, -0.14, -0.10, 0.02),
]  # fmt: skip
# or, the yarn laid under the hook, the same loop twisted once: its legs cross;
UNDER = [
    (-0.13, -0.14, 0.00, 0.02), (-0.13, -0.08, 0.17, 0.05), (0.02, 0.08, 0.24, 0.08), (0.26, 0.28, 0.22, 0.10),
    (0.48, 0.46, 0.14, 0.10), (0.58, 0.60, -0.12, 0.08), (0.58, 0.74, -0.32, 0.05), (0.48, 0.90, -0.22, 0.05),
    (0.26, 0.95, -0.02, 0.05), (0.02, 0.88, 0.14, 0.05), (-0.09, 0.66, 0.28, 0.10), (-0.08, 0.46, 0.36, 0.10),
    (0.02, 0.24, 0.42, 0.10), (0.12, 0.04, 0.34, 0.10), (0.13, -0.10, 0.10, 0.02), (0.13, -0.14, -0.10, 0.02),
]  # fmt: skip
# up behind, through that loop and the head of the stitch before, around both, over to the next stitch and back.
HEAD = [
    (0.18, -0.04, -0.26, 0.02), (0.34, 0.22, -0.31, 0.02), (0.56, 0.42, -0.32, 0.02), (0.80, 0.60, -0.20, 0.02),
    (0.80, 0.70, 0.00, 0.02), (0.52, 0.72, 0.13, 0.05), (0.22, 0.76, 0.10, 0.03), (0.03, 0.94, 0.06, 0.03),
    (0.03, 1.10, 0.13, 0.05), (0.20, 1.17, 0.20, 0.10), (0.50, 1.15, 0.22, 0.10), (0.88, 1.08, 0.20, 0.10),
    (1.12, 0.99, 0.13, 0.05), (1.24, 0.95, -0.02, 0.05), (1.12, 1.04, -0.15, 0.03), (0.85, 1.14, -0.19, 0.03),
    (0.40, 1.18, -0.18, 0.03), (0.12, 1.12, -0.16, 0.03), (0.03, 0.95, -0.15, 0.03), (0.20, 0.78, -0.13, 0.03),
    (0.42, 0.71, -0.09, 0.03), (0.62, 0.69, -0.11, 0.02),
]  # fmt: skip

# Where the loop's legs stand in the end, from the column's foot (row of the table, u with the lean taken off): close together
# in their hole and apart above, a V, as close-ups of amigurumi show it, and the next row's Vs come out of the middle of it; drawn tight
# alone they stay parallel.
LEGS = {0: -0.3, 1: -0.19, 2: -0.13, 3: -0.12, 5: -0.04, 6: 0.08, 7: 0.07, 8: -0.03, 9: -0.19, 10: -0.4, 11: -0.22, 12: 0.1, 13: 0.32, 14: 0.35, 15: 0.39, 16: 0.36, 17: 0.28, 18: 0.25, 43: 0.22, 44: 0.34, 45: 0.47}  # fmt: skip

# Behind, the yarn from a head lies over to the next stitch before it goes down to the hole: the bump across every stitch
# that a row shows on its other side. Drawn tight alone it runs straight down there, a hook.

# And how far before the fabric (row, w): both legs outside, equally far, all the way up, so that a V is seen from either side;
# and behind them, hidden, the yarn that comes through the loop to be the next head. Drawn tight alone the left leg sinks in
# half way up behind the right one, and from the right a row reads as a rope.
DEEP = {0: -0.42, 1: -0.37, 2: -0.33, 3: -0.31, 4: -0.22, 5: -0.08, 6: 0.1, 7: 0.31, 8: 0.355, 9: 0.355, 10: 0.3, 11: 0.06, 12: -0.04, 13: 0.05, 14: 0.31, 15: 0.36, 16: 0.355, 17: 0.31, 18: 0.12, 19: -0.04, 21: -0.1, 22: -0.02, 23: 0.0, 24: -0.03, 25: -0.06, 26: -0.06, 27: -0.06, 28: 0.0, 29: 0.09, 30: 0.19, 31: 0.15, 32: 0.04, 33: 0.05, 43: -0.35, 44: -0.42, 45: -0.43}  # fmt: skip

# And how high it is (row, v): legs come out as low as their hole lets them and reach up beside the legs worked over them before they go
# in, so that rows lie in each other; drawn tight alone they end below that, and a row is a ring of kernels with a groove above it. The head
# begins down in the gap between the stitches worked over it: alone it stands up there before them, and where the colour changes the old one has teeth.
LOW = {0: 0.66, 1: 0.55, 2: 0.4, 3: 0.24, 5: -0.02, 6: -0.06, 7: 0.07, 8: 0.32, 9: 0.58, 10: 0.84, 11: 0.76, 12: 0.73, 13: 0.76, 14: 0.81, 15: 0.55, 16: 0.31, 17: 0.07, 18: -0.07, 27: 0.9, 28: 0.97, 29: 1.02, 30: 1.02, 31: 1.07, 32: 1.155, 39: 1.24, 40: 1.18, 43: 0.86, 44: 0.79, 45: 0.74}  # fmt: skip

# The same of the yarn laid under the hook, whose legs cross half way up and stand as far apart below as above, an x: the leg that comes
# down lies before the other, and steeper, so that the other is seen on either side of it. Drawn tight alone they cross in their hole, and one sees a single slanted leg, a kernel; and its head
# lies before them.
CROSSED = {6: -0.30, 7: -0.22, 8: 0.0, 9: 0.28, 10: 0.56, 11: 0.70, 12: 0.50, 13: 0.14, 14: 0.03, 15: 0.09, 16: 0.21, 17: 0.32, 18: 0.36}  # fmt: skip
BEFORE = {6: 0.18, 7: 0.33, 8: 0.27, 9: 0.25, 10: 0.34, 11: 0.12, 13: 0.03, 14: 0.28, 15: 0.42, 16: 0.44, 17: 0.34, 18: 0.1, 0: -0.44, 1: -0.38, 2: -0.345, 3: -0.34, 43: -0.36, 44: -0.43, 45: -0.45, 21: -0.10, 22: -0.02, 23: 0.0, 24: -0.03, 25: -0.06, 26: -0.06, 27: -0.06, 28: 0.0, 29: 0.06, 30: 0.10, 31: 0.10, 32: 0.04, 33: 0.05}  # fmt: skip
UP = {6: 0.02, 7: 0.13, 8: 0.28, 9: 0.43, 10: 0.58, 11: 0.72, 14: 0.70, 15: 0.52, 16: 0.32, 17: 0.12, 18: 0.02, 0: 0.62, 1: 0.52, 2: 0.40, 3: 0.24, 27: 0.9, 28: 0.97, 29: 1.02, 30: 1.02, 31: 1.07, 32: 1.155, 39: 1.24, 40: 1.18, 43: 0.86, 44: 0.8, 45: 0.72}  # fmt: skip


def evenly(course: np.ndarray, count: int) -> np.ndarray:
    """A course (N, 4) of a stitch, the next one behind it, as a smooth line of ``count`` points at even distances."""
    next_one = np.array([1.0, 0.0, 0.0, 0.0])
    p = np.vstack([course[-1:] - next_one, course, course[:2] + next_one])
    t = np.linspace(0, 1, 24, endpoint=False)[:, None]
    fine = [
        0.5 * (2 * b + (c - a) * t + (2 * a - 5 * b + 4 * c - d) * t * t + (3 * b - a - 3 * c + d) * t**3)
        for a, b, c, d in zip(p, p[1:], p[2:], p[3:])
    ]
    line = np.vstack([*fine, course[:1] + next_one])
    along = np.concatenate([[0.0], np.cumsum(np.sqrt((np.diff(line[:, :3], axis=0) ** 2).sum(1)))])
    at = np.linspace(0.0, along[-1], count + 1)[:-1]
    return np.stack([np.interp(at, along, line[:, c]) for c in range(4)], axis=1)


@kernel
def forces(x: F8x2, up: F8x1, width: float, tight: float, bend: float, pull: F8x2, sheared: F8x1) -> float:
    """Fill the pull (N, 3) on a stitch of the lattice and on its shear (3,); the yarn's length."""
    n, total, contact = len(x), 0.0, 4.0
    pull[:] = 0.0
    sheared[:] = 0.0
    e = np.zeros(3)
    for k in range(n):
        m, o = (k + 1) % n, (k - 1) % n
        for c in range(3):
            ahead = x[m, c] + (1.0 if m == 0 and c == 0 else 0.0)
            back = x[o, c] - (1.0 if k == 0 and c == 0 else 0.0)
            e[c] = ahead - x[k, c]
            turn = bend * (back + ahead - 2.0 * x[k, c])
            pull[k, c] += 2.0 * turn
            pull[m, c] -= turn
            pull[o, c] -= turn
        size = (e[0] ** 2 + e[1] ** 2 + e[2] ** 2) ** 0.5
        total += size
        for c in range(3):
            f = tight * (size - 3.5 / n) / size * e[c]
            pull[k, c] += f
            pull[m, c] -= f
    own = 1.45 * width * n / total  # points along one strand that are near by nature
    for row in range(2):
        for beside in range(-3 if row else 0, 4):
            for k in range(n):
                for m in range(n):
                    if row == 0 and ((beside == 0 and m <= k) or abs(m + beside * n - k) < own):
                        continue
                    e[0] = x[m, 0] + beside + row * up[0] - x[k, 0]
                    e[1] = x[m, 1] + row * up[1] - x[k, 1]
                    e[2] = x[m, 2] + row * up[2] - x[k, 2]
                    size = e[0] ** 2 + e[1] ** 2 + e[2] ** 2
                    if size < width * width:
                        size = size**0.5 + 1e-9
                        for c in range(3):
                            f = contact * (width - size) / size * e[c]
                            pull[m, c] += f
                            pull[k, c] -= f
                            if row:
                                sheared[c] += f
    return total


@kernel
def relax(x: F8x2, drawn: F8x2, up: F8x1, free: float, width: float, tight: float, bend: float, steps: int) -> float:
    """Let the stitch x (N, 3), and as far as it is free the lattice's way up (3,), follow their pulls; the yarn's length."""
    pull, speed, sheared, length, lean = np.zeros_like(x), np.zeros_like(x), np.zeros(3), 0.0, 0.0
    for _ in range(steps):
        length = forces(x, up, width, tight, bend, pull, sheared)
        for k in range(len(x)):
            for c in range(3):
                speed[k, c] = 0.9 * speed[k, c] + 0.03 * (pull[k, c] + drawn[k, 3] * (drawn[k, c] - x[k, c]))
                speed[k, c] = max(-0.01, min(0.01, speed[k, c]))
                x[k, c] += speed[k, c]
        lean = 0.9 * lean + 0.003 * free * sheared[0]
        up[0] += max(-0.005, min(0.005, lean))
    return length


def found(course: np.ndarray, high: float, lean: float, tight: float) -> tuple[np.ndarray, np.ndarray, float]:
    """The stitch (N, 3), the lattice's way up (3,) and the yarn's length, for rows ``high`` widths apart.

    lean : how far to the right each row stands of the one below, widths; NaN where that is to be found
    """
    free = 1.0 if np.isnan(lean) else 0.0
    drawn = evenly(course, POINTS)
    drawn[:, 1] *= high / 0.92
    x, up = drawn[:, :3].copy(), np.array([-0.25 if free else -lean, high, 0.0])
    for width in np.linspace(0.05, RATIO, 20):
        relax(x, drawn, up, free, float(width), tight, 0.02, 400)
    return x, up, relax(x, drawn, up, free, RATIO, tight, 0.02, 9000)


def table(x: np.ndarray, up: np.ndarray) -> np.ndarray:
    """The course in a cell whose columns stand upright and are one high, with as many points as loops.py takes."""
    cell = np.stack([x[:, 0] - up[0] * x[:, 1] / up[1], x[:, 1] / up[1], x[:, 2]], axis=1)
    # The hole is passed where the yarn comes through it to the front, and where it is behind again.
    low = np.flatnonzero((cell[:, 1] < 0.12) & (abs(cell[:, 0]) < 0.45))
    front, back = low[0] + np.argmin(abs(cell[low[0] : low[0] + 14, 2] + 0.12)), 0
    for k in low[low > front + 10]:
        if cell[k, 2] < -0.12:
            back = int(k)
            break
    line = np.vstack([cell, cell[:1] + np.array([1.0, 0.0, 0.0])])
    rows = []
    for (first, last), (a, b) in zip((BAR, LOOP, TOP), ((0, front), (front, back), (back, len(cell)))):
        at = np.linspace(a, b, last - first + 1)[:-1]
        rows += [[np.interp(t, np.arange(len(line)), line[:, c]) for c in range(3)] for t in at]
    return np.array(rows)


def rested(
    line: np.ndarray,
    high: float,
    lean: float,
    legs: dict[int, float],
    deep: dict[int, float],
    low: dict[int, float],
    snug: float,
    rounds: int = 300,
) -> np.ndarray:
    """The table (46, 3), its loop drawn to where hands leave it (``legs`` aside, ``deep`` before the fabric, its head ``low``), as :mod:`tambour.crochet.yarn.clearance` leaves it: its few points cut the corners of the course,
    so that a lattice of it is pushed apart as pieces are, until nothing in it is nearer than the yarn's width."""
    made, ends = line.copy(), np.arange(8) * 9 * len(line)

    def lattice() -> np.ndarray:
        rows = [spread(made, high, lean, row, column) for row in range(7) for column in range(9)]
        return np.concatenate(rows) / RATIO

    for number in range(rounds):
        for k, u in legs.items() if number < rounds - 60 else ():
            made[k, 0] += 0.15 * (u + lean * made[k, 1] - made[k, 0])
        for k, w in deep.items() if number < rounds - 60 else ():
            made[k, 2] += 0.15 * (w - made[k, 2])
        for k, v in low.items() if number < rounds - 60 else ():
            made[k, 1] += 0.15 * (v - made[k, 1])
        if number < rounds - 60:  # and the yarn is drawn tight, for the legs take more
            one = np.array([1.0, 0.0, 0.0])
            made += snug * (
                0.5 * (np.vstack([made[-1:] - one, made[:-1]]) + np.vstack([made[1:], made[:1] + one])) - made
            )
        before = lattice()
        after = before.copy()
        close = near.pairs(after, ends, 1.15, clearance.ALONG)
        clearance.push(after, close, 1.005, 1.005, 2, 1.0, 0, np.zeros(len(after), np.bool_))
        # What happens to the stitches in the middle happens to all.
        move = RATIO * (after - before).reshape(7, 9, len(line), 3)[2:5, 3:6].mean((0, 1))
        made += np.column_stack([move[:, 0] + lean * move[:, 1] / high, move[:, 1] / high, move[:, 2]])
        one = np.array([1.0, 0.0, 0.0])
        around = np.vstack([made[-1:] - one, made, made[:1] + one])
        back, on = (np.linalg.norm(np.diff(around, axis=0)[k : k + len(made)], axis=1) for k in (0, 1))
        way = around[2:] - around[:-2]
        slide = 0.05 * (on - back)[:, None] * way / np.linalg.norm(way, axis=1)[:, None]
        slide[[0, BAR[1], LOOP[1], loops.HEAD]] = 0.0
        made += slide
    return made


def measured(made: np.ndarray, high: float, lean: float) -> tuple[float, float]:
    """The yarn's length in a stitch, in its widths, and the least distance in a lattice of it, in the yarn's."""
    one = np.array([1.0, 0.0, 0.0])
    line = np.vstack([made, made[:1] + one])
    length = np.linalg.norm(np.diff(spread(line, high, lean, 0, 0), axis=0), axis=1).sum()
    every = np.concatenate([spread(made, high, lean, row, column) for row in range(5) for column in range(7)]) / RATIO
    return float(length), float(clearance.distances(every, np.arange(6) * 7 * len(made), 1.0, 1.1)[1].min())


def spread(line: np.ndarray, high: float, lean: float, row: int, column: int) -> np.ndarray:
    """A course in cells (N, 3) as it lies in a row and a column of the lattice, in widths."""
    return np.column_stack([line[:, 0] - lean * (line[:, 1] + row) + column, high * (line[:, 1] + row), line[:, 2]])


def main(arguments: list[str]) -> None:
    """Find the course, print it and how it was found."""
    under = "--under" in arguments
    course = np.array([*BEHIND, *(UNDER if under else OVER), *HEAD])
    # Columns of yarn under are taken to stand all but straight; a lattice of equal stitches leans by 0.28.
    high, lean = (0.9, 0.08) if under else (1.0, float("nan"))
    low, most = 0.03, 0.6
    for _ in range(7):
        tight = (low * most) ** 0.5
        x, up, length = found(course, high, lean, tight)
        print(f"tight {tight:.3f}: {length:.2f} widths", file=sys.stderr, flush=True)
        if abs(length - LENGTH) < 0.03:
            break
        low, most = (tight, most) if length > LENGTH else (low, tight)
    # Its few points cut corners, and its legs take more: drawn tight once more, by as much as it needs.
    low, most, made, held = 1e-4, 0.1, table(x, up), (CROSSED, BEFORE, UP) if under else (LEGS, DEEP, LOW)
    for _ in range(9):
        snug = (low * most) ** 0.5
        made = rested(table(x, up), high, -up[0], *held, snug)
        length, near = measured(made, high, -up[0])
        print(f"snug {snug:.5f}: {length:.2f} widths", file=sys.stderr, flush=True)
        if abs(length - LENGTH) < 0.03:
            break
        low, most = (snug, most) if length > LENGTH else (low, snug)
    print(
        f"# {length:.2f} widths of yarn, nothing nearer than {near:.3f} of the yarn's width, a lean of {-up[0]:.3f} widths a row"
    )
    for k, (u, v, w) in enumerate(made.tolist()):
        print(f"({u:.3f}, {v:.3f}, {w:.3f}),", end="\n" if k % 4 == 3 else " ")
    print()


if __name__ == "__main__":
    main(sys.argv[1:])

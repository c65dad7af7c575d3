"""The course of the yarn through one stitch, in the stitch's own cell.

Coordinates: u along the work from the stitch's own column (-1 is the stitch before), v up from the row it is worked
into (0) to its own (1), w towards the worker; all in widths of a single crochet. The yarn of a single crochet comes
from the head of the stitch before, runs down behind the work, under both top strands of the stitch below, up in front as
a loop (the V: its right leg, and its left leg, which dips behind what is drawn through it), back behind, up again, and
through that loop and the head of the stitch before as the next head, which turns around both and lies over to the next
stitch and back. `bench/single_crochet.py` found the numbers: there no two centre lines of a lattice of equal stitches are
nearer than a diameter, and a stitch takes 8 widths of yarn, as in the hand.
"""

from __future__ import annotations

import math
from typing import Final

import numpy as np

from tambour.core.arrays import B1x1, F8x1, F8x2, F8x3, I1x1, I4x1, I8x1
from tambour.core.check import Array
from tambour.core.kernels import kernel

RATIO: Final = 0.2
"""Yarn diameter, in stitch widths, for which the course was found: drawn tight, where strands press on each other."""

BLOOM: Final = 2.6
"""Radius drawn, in radii of that: wool is soft outside, and neighbours press into each other. At 2.5 holes of .28 of the yarn showed."""

THICK: Final = 0.66
"""Thickness of the fabric, in stitch widths, when it is measured with a tape: the fibres outside give way."""

BAR: Final = (0, 5)
LOOP: Final = (5, 19)
TOP: Final = (19, 46)
HEAD: Final = 23
"""Stretches of SINGLE: down to the hole, the loop drawn up through it, up behind and the head from HEAD on."""

LEAN: Final = {"over": 0.271, "under": 0.08}
"""How far to the right of its column's foot each stitch stands, in widths, by how the yarn lies on the hook."""

SINGLE: Final[Array] = np.array(
    [
        (-0.124, 0.659, -0.419), (-0.039, 0.535, -0.366), (-0.025, 0.379, -0.327), (-0.058, 0.220, -0.304),
        (-0.072, 0.079, -0.215), (-0.043, -0.018, -0.079), (0.066, -0.033, 0.135), (0.088, 0.114, 0.331),
        (0.046, 0.364, 0.357), (-0.047, 0.610, 0.349), (-0.169, 0.839, 0.273), (-0.017, 0.748, 0.061),
        (0.243, 0.730, -0.034), (0.505, 0.757, 0.037), (0.564, 0.811, 0.292), (0.540, 0.560, 0.357),
        (0.449, 0.324, 0.355), (0.324, 0.112, 0.329), (0.255, -0.058, 0.173), (0.315, 0.029, -0.037),
        (0.406, 0.146, -0.103), (0.513, 0.268, -0.098), (0.611, 0.372, -0.022), (0.717, 0.494, -0.001),
        (0.770, 0.590, -0.029), (0.782, 0.698, -0.058), (0.748, 0.804, -0.060), (0.686, 0.897, -0.059),
        (0.637, 0.974, 0.006), (0.672, 1.022, 0.102), (0.747, 1.025, 0.190), (0.841, 1.077, 0.142),
        (0.867, 1.147, 0.050), (0.984, 1.165, 0.050), (1.099, 1.187, 0.061), (1.205, 1.212, 0.018),
        (1.164, 1.252, -0.087), (1.050, 1.285, -0.118), (0.924, 1.297, -0.106), (0.809, 1.233, -0.126),
        (0.689, 1.168, -0.148), (0.597, 1.069, -0.194), (0.516, 0.968, -0.264), (0.459, 0.858, -0.352),
        (0.574, 0.780, -0.425), (0.723, 0.718, -0.429),
    ]
)  # fmt: skip
"""A single crochet worked under both loops (46, 3), yarn over: the yarn's end is the next stitch's beginning."""

UNDER: Final[Array] = np.array(
    [
        (-0.342, 0.620, -0.439), (-0.245, 0.506, -0.375), (-0.165, 0.362, -0.344), (-0.143, 0.191, -0.320),
        (-0.134, 0.074, -0.182), (-0.104, 0.060, -0.001), (-0.266, 0.019, 0.192), (-0.136, 0.192, 0.343),
        (0.091, 0.315, 0.244), (0.346, 0.444, 0.240), (0.592, 0.572, 0.339), (0.753, 0.714, 0.132),
        (0.544, 0.668, -0.072), (0.262, 0.684, -0.015), (0.106, 0.722, 0.211), (0.122, 0.551, 0.413),
        (0.234, 0.326, 0.456), (0.327, 0.126, 0.343), (0.350, 0.024, 0.123), (0.244, 0.080, -0.086),
        (0.293, 0.225, -0.158), (0.410, 0.331, -0.097), (0.544, 0.405, -0.020), (0.699, 0.474, -0.001),
        (0.806, 0.552, -0.028), (0.863, 0.668, -0.058), (0.844, 0.794, -0.060), (0.757, 0.877, -0.067),
        (0.666, 0.930, -0.029), (0.598, 0.994, 0.020), (0.550, 1.040, 0.098), (0.600, 1.128, 0.072),
        (0.682, 1.190, 0.037), (0.772, 1.258, 0.054), (0.891, 1.277, 0.067), (1.011, 1.266, 0.038),
        (1.023, 1.282, -0.089), (0.906, 1.327, -0.129), (0.773, 1.318, -0.140), (0.666, 1.235, -0.162),
        (0.540, 1.175, -0.172), (0.439, 1.081, -0.198), (0.369, 0.976, -0.264), (0.349, 0.868, -0.353),
        (0.448, 0.801, -0.428), (0.561, 0.720, -0.450),
    ]
)  # fmt: skip
"""The same with the yarn laid under the hook: the legs of its loop cross half way up, an x; the leg that comes down lies before the other."""


def with_rows(course: Array, rows: dict[int, tuple[float, float, float]]) -> Array:
    """A course with some of its rows replaced."""
    made = course.copy()
    for k, row in rows.items():
        made[k] = row
    return made


BACK_ONLY: Final[dict[int, tuple[float, float, float]]] = {
    5: (-0.06, 0.01, -0.14), 6: (0.03, 0.15, 0.0), 7: (0.05, 0.34, 0.14), 8: (0.03, 0.50, 0.27),
    15: (0.56, 0.58, 0.31), 16: (0.47, 0.45, 0.23), 17: (0.37, 0.34, 0.10), 18: (0.30, 0.14, -0.01), 19: (0.33, 0.02, -0.13),
}  # fmt: skip
"""Rows of a stitch worked under the back strand alone: the front one stays outside, a ridge."""

FRONT_ONLY: Final[dict[int, tuple[float, float, float]]] = {
    2: (-0.08, 0.46, -0.24), 3: (-0.07, 0.46, -0.08), 4: (-0.06, 0.26, 0.01), 5: (-0.02, 0.06, 0.06), 6: (0.04, -0.03, 0.22),
    7: (0.06, 0.10, 0.35), 17: (0.33, 0.05, 0.32), 18: (0.28, -0.03, 0.12), 19: (0.32, 0.18, 0.02), 20: (0.41, 0.38, -0.05),
    21: (0.50, 0.42, -0.19),
}  # fmt: skip
"""Rows of a stitch worked under the front strand alone: the back one stays inside, a ridge there."""

UNDER_BACK: Final[dict[int, tuple[float, float, float]]] = {
    5: (-0.17, 0.03, -0.14), 6: (-0.185, 0.15, 0.0), 7: (-0.10, 0.29, 0.13), 8: (0.09, 0.38, 0.20),
    15: (0.096, 0.54, 0.38), 16: (0.24, 0.43, 0.35), 17: (0.34, 0.30, 0.15), 18: (0.33, 0.14, -0.01), 19: (0.27, 0.02, -0.15),
}  # fmt: skip
UNDER_FRONT: Final[dict[int, tuple[float, float, float]]] = {
    2: (-0.19, 0.46, -0.24), 3: (-0.18, 0.46, -0.08), 4: (-0.175, 0.26, 0.01), 5: (-0.166, 0.06, 0.06), 6: (-0.19, -0.03, 0.22),
    7: (-0.13, 0.12, 0.35), 17: (0.36, 0.06, 0.30), 18: (0.31, -0.02, 0.10), 19: (0.27, 0.18, 0.02), 20: (0.36, 0.40, -0.05),
    21: (0.49, 0.44, -0.20),
}  # fmt: skip
"""The same rows with the yarn laid under the hook: the legs cross above them."""

LOOSE: Final[dict[int, tuple[float, float, float]]] = {
    27: (0.677, 0.968, -0.042), 28: (0.563, 1.047, -0.018), 29: (0.541, 1.179, 0.024), 30: (0.616, 1.216, 0.139),
    31: (0.753, 1.255, 0.150), 32: (0.888, 1.291, 0.121), 33: (1.031, 1.298, 0.128), 38: (0.982, 1.283, -0.115),
    39: (0.835, 1.282, -0.094), 40: (0.704, 1.218, -0.129), 41: (0.607, 1.133, -0.210), 42: (0.513, 1.021, -0.254),
}  # fmt: skip
"""Rows of a head over which nothing is worked: no stitch draws its front strand down and in, into the gap to the next."""

CHAIN: Final[Array] = np.array([(-0.234, 0.535, -0.313), (0.04, 0.52, -0.33), (0.34, 0.48, -0.31), (0.62, 0.47, -0.22)])
"""What comes before the head in a chain: the bump behind it."""


def _open(course: Array) -> Array:
    """A course whose V stands open: its legs lie as near below, and further apart above."""
    made = course.copy()
    legs = made[LOOP[0] + 2 : LOOP[1] - 1]
    axis = 0.08 + 0.41 * legs[:, 1]
    front = np.clip((legs[:, 2] - 0.02) / 0.2, 0.0, 1.0) * np.clip((legs[:, 1] - 0.15) / 0.5, 0.0, 1.0)
    legs[:, 0] += SPREAD * front * np.sign(legs[:, 0] - axis)
    return made


def tables(hold: str) -> tuple[Array, Array]:
    """The courses (6, 46, 3) of a stitch under both loops, the front and the back one, and of each with its head LOOSE; and a chain's."""
    under = hold == "under"
    single = UNDER if under else _open(SINGLE)
    front, back = (UNDER_FRONT, UNDER_BACK) if under else (FRONT_ONLY, BACK_ONLY)
    made = [single, with_rows(single, front), with_rows(single, back)]
    free = [with_rows(table, LOOSE) for table in made]
    return np.stack(made + free), np.vstack([CHAIN, free[0][HEAD:]])


SPREAD: Final = 0.054
"""How much further to its side each leg of a V lies above than where the course was found, in widths."""

SUNK: Final = (0.1, 0.1)
"""How far down and in the front strand of a head is drawn that lies before a decrease: no loop covers it."""

ASTRIDE: Final = 0.12
"""How much further apart, each, the legs of a loop stand that is drawn through two stitches."""

POST, NARROW, CLOSE = 0.13, 0.5, 0.34
"""Where a tall stitch's post stands, and how far apart its legs stand, as a share of a single crochet's; and of one worked around a post, which
is drawn out long and stands alone before the fabric, or behind it: one column."""

TALL: Final = 1.75
"""Stitches of this height, in single crochets, and higher have a post of several loops, one above the other."""

SHEAR: Final = 0.5
"""A tall stitch's next loop comes through the arch of the last, which lies this far from a hole's place."""


@kernel
def _stories(height: float) -> int:
    """Loops one above the other in a post: one up to a half double crochet, then one per stitch height."""
    return 1 if height < TALL else int(height + 0.5)


@kernel
def count_points(role: I1x1, offsets: I8x1, height: F8x1, drawn: B1x1, out: I8x1) -> None:
    """Fill ``out`` (N,): control points of every node's stretch of yarn. drawn : (N,) see :func:`lead`."""
    for i in range(len(role)):
        if role[i] == 2:
            out[i] = 4 + 46 - HEAD
        elif role[i] == 1:
            loops = (1 if drawn[i] else offsets[i + 1] - offsets[i]) + _stories(height[i]) - 1
            out[i] = 5 + 14 * loops + 27
        else:
            out[i] = 0


@kernel
def _stretched(v: float, more: float) -> float:
    """A height in a single crochet's cell as one in a cell that is ``more`` higher: its foot and its top keep theirs."""
    if v <= 0.1:
        return v
    if v >= 0.6:
        return v + more
    return v + more * (v - 0.1) / 0.5


@kernel
def lead(
    role: I1x1,
    start: I8x1,
    anchors: I4x1,
    offsets: I8x1,
    height: F8x1,
    table_of: I8x1,
    ridge: I1x1,
    sunk: B1x1,
    drawn: B1x1,
    tables: F8x3,
    chain: F8x2,
    deep: F8x1,
    relief: F8x1,
    bump: F8x1,
    lean: float,
    cell: I4x1,
    below: I4x1,
    at: F8x2,
) -> None:
    """Fill cell, below (P,) and at (P, 3), from ``start[i]`` on, with the course of the yarn through every node.

    table_of : (N,) which of ``tables`` (K, 46, 3) is the course by the loops worked under, 0 being both, and by whether its head is LOOSE
    ridge : (N,) whether a stitch above leaves this one's front strand (1) or its back one (-1) free; sunk : (N,) whether its head is drawn in, since
    the loops of a decrease lean away from it; chain : (27, 3), of a chain
    drawn : (N,) whether all its anchors are taken up by one loop, drawn through them together: an invisible decrease
    deep : (N,) how far below its row a stitch is worked (around a post, in the row below); relief : (N,) how far it stands
    out; bump : (N,) how far the loops of one that are all in one anchor bulge, negative to the other side; lean : of the tables
    """
    for i in range(len(role)):
        p = start[i]
        if role[i] == 2:
            for k in range(4 + 46 - HEAD):
                cell[p], below[p] = i, -1
                at[p] = chain[k]
                p += 1
        if role[i] != 1:
            continue
        first, last = offsets[i], offsets[i + 1]
        high = max(height[i], 0.5)
        stories = _stories(high)
        part = high / stories
        table = tables[table_of[i]]
        begin = p
        # One loop comes out in the middle of all that it is drawn through.
        loops = 1 if drawn[i] else last - first
        middle = 0.5 * (last - first - 1) if drawn[i] else 0.0
        bulging = last - first > 1 and anchors[first] == anchors[last - 1]
        for k in range(5):
            cell[p], below[p] = i, anchors[first]
            at[p, 0], at[p, 1], at[p, 2] = table[k, 0], _stretched(table[k, 1], high - 1.0), table[k, 2]
            p += 1
        for number in range(loops + stories - 1):
            story = max(0, number - loops + 1)
            use = table if story == 0 else tables[0]
            # The loops of a decrease lie side by side under one top loop.
            beside = 0.0 if loops == 1 else (number + 0.5) / loops - 0.5
            for k in range(5, 19):
                u, v, w = use[k, 0], use[k, 1], use[k, 2]
                if stories > 1 and not bulging:
                    # A tall stitch stands upright, its legs side by side: a post, and air beside it.
                    u = POST + (NARROW if relief[i] == 0.0 else CLOSE) * (u - lean * v - POST)
                elif story > 0:
                    u += SHEAR * min(1.0, max(0.0, 0.6 - v))
                if bulging and v > 0.3 and story < stories - 1:
                    # An arch that a loop comes through, not the top loop: narrower.
                    u = 0.1 + 0.7 * (u - 0.1)
                if bulging and story == 0:
                    # Loops of one anchor stand around a bulge, and gather at its head.
                    t = min(1.0, max(0.0, (_stretched(v, part - 1.0) + 0.2) / (high + 0.1)))
                    out = math.sin(math.pi * t) * bump[i]
                    u = 0.1 + 0.6 * (u - 0.1) + 0.75 * abs(out) * math.sin(2.4 * beside)
                    w = w + out * (0.35 + 0.65 * math.cos(2.4 * beside))
                elif v > 0.3 and story == 0 and loops > 1:
                    # Wide below, where each stands in its own hole.
                    aside = 0.3 + 0.6 * max(0.0, 1.0 - abs(v / part - 0.5) / 0.35)
                    u, v, w = u + aside * beside, v - 0.1 * (0.5 - beside), w - 0.2 * (0.5 - beside)
                cell[p], below[p] = i, anchors[min(first + number, last - 1)]
                at[p, 0], at[p, 1], at[p, 2] = u, part * story + _stretched(v, part - 1.0), w
                p += 1
        for k in range(19, 46):
            v = table[k, 1]
            if stories > 1 and k < HEAD:
                v = part * (stories - 1) + _stretched(v, part - 1.0)
            else:
                v = _stretched(v, high - 1.0)
            cell[p], below[p] = i, anchors[last - 1]
            at[p, 0], at[p, 1], at[p, 2] = table[k, 0], v, table[k, 2]
            if ridge[i] == 1 and 30 <= k <= 34:
                at[p, 1] -= 0.06
                at[p, 2] += 0.12
            elif ridge[i] == -1 and 36 <= k <= 40:
                # What is left free inside lies there as a bar, below the row that passes it by.
                at[p, 1] -= 0.22
                at[p, 2] -= 0.40
            if sunk[i] and k >= 25 and k <= 36:
                at[p, 1] -= SUNK[0]
                at[p, 2] -= SUNK[1]
            p += 1
        if middle > 0.0:
            for q in range(begin, p):
                low = max(0.0, 1.0 - at[q, 1] / high) if at[q, 1] > 0.0 else 1.0
                # Its legs stand a little further apart below: it is about two heads.
                aside = ASTRIDE if at[q, 0] > 0.12 else -ASTRIDE
                outside = min(1.0, max(0.0, (at[q, 2] - 0.1) / 0.15))
                at[q, 0] += low * ((middle if below[q] == anchors[first] else -middle) + outside * aside)
        if deep[i] != 0.0 or relief[i] != 0.0:
            for q in range(begin, p):
                v = at[q, 1]
                at[q, 2] += relief[i] * min(1.0, max(0.0, 1.6 * (high - v)))
                if v < 0.5:
                    at[q, 1] -= deep[i] * min(1.0, (0.5 - v) / 0.5)

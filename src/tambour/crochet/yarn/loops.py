"""The course of the yarn through one stitch, in the stitch's own cell.

Coordinates: u along the work from the stitch's own column (-1 is the stitch before), v up from the row it is worked
into (0) to its own (1), w towards the worker; all in widths of a single crochet. The yarn of a single crochet comes
from the stitch before, runs down behind the work, under both top strands of the stitch below, up in front as a loop
(the V), back behind, up again, and through that loop and the head of the stitch before as the next top loop, which
lies over to the next stitch and back. The numbers are what this course, drawn with thin yarn and the right crossings,
came to when its yarn was thickened step by step to a quarter of the stitch in a lattice of equal stitches, with bending
and tension at work: there no two centre lines are nearer than 0.98 diameters.
"""

from __future__ import annotations

import math
from typing import Final

import numpy as np

from tambour.core.arrays import B1x1, F8x1, F8x2, F8x3, I1x1, I4x1, I8x1
from tambour.core.check import Array
from tambour.core.kernels import kernel

RATIO: Final = 0.25
"""Yarn diameter, in stitch widths, for which the course was found."""

BLOOM: Final = 1.32
"""Radius drawn, in radii of the yarn's core: wool is soft outside, and neighbours press into each other."""

THICK: Final = 2 * RATIO * BLOOM
"""Thickness of the fabric, in stitch widths: two strands of yarn, as they lie on each other."""

BAR: Final = (0, 7)
LOOP: Final = (7, 27)
TOP: Final = (27, 48)
HEAD: Final = 29
"""Stretches of SINGLE: down to the hole, the loop drawn up through it, up behind and the top loop from HEAD on."""

SINGLE: Final[Array] = np.array(
    [
        (-1.252, 0.777, -0.092), (-1.047, 0.568, -0.305), (-0.901, 0.470, -0.338), (-0.548, 0.402, -0.322),
        (-0.228, 0.259, -0.399), (0.051, 0.028, -0.419), (0.157, -0.111, -0.377),
        (0.191, -0.258, -0.280), (0.137, -0.368, -0.148), (0.056, -0.415, 0.005), (0.043, -0.391, 0.181),
        (0.118, -0.303, 0.317), (0.133, -0.148, 0.404), (-0.004, 0.174, 0.480), (-0.123, 0.294, 0.419),
        (-0.390, 0.433, 0.217), (-0.477, 0.516, 0.084), (-0.502, 0.770, -0.170), (-0.406, 0.882, -0.268),
        (-0.235, 0.933, -0.286), (-0.066, 0.917, -0.229), (0.182, 0.821, 0.009), (0.288, 0.532, 0.184),
        (0.269, 0.239, 0.392), (0.312, 0.067, 0.380), (0.370, -0.045, 0.256), (0.349, -0.005, -0.086),
        (0.097, 0.194, -0.225), (-0.148, 0.428, -0.112), (-0.272, 0.662, 0.134), (-0.328, 0.815, 0.212),
        (-0.284, 0.981, 0.256), (-0.139, 1.085, 0.263), (0.204, 1.146, 0.165), (0.377, 1.190, 0.171),
        (0.512, 1.183, 0.287), (0.591, 1.107, 0.430), (0.695, 0.983, 0.504), (0.820, 0.868, 0.453),
        (0.906, 0.827, 0.303), (0.921, 0.880, 0.133), (0.820, 1.122, -0.110), (0.670, 1.192, -0.173),
        (0.497, 1.235, -0.141), (0.166, 1.317, -0.016), (-0.170, 1.276, 0.100), (-0.322, 1.183, 0.086),
        (-0.371, 1.025, 0.024),
    ]
)  # fmt: skip
"""A single crochet worked under both loops (48, 3): the yarn's end is the next stitch's beginning."""


def _changed(rows: dict[int, tuple[float, float, float]]) -> Array:
    made = SINGLE.copy()
    for k, row in rows.items():
        made[k] = row
    return made


BACK_ONLY: Final[Array] = _changed(
    {
        7: (0.19, -0.16, -0.30), 8: (0.15, -0.16, -0.16), 9: (0.08, -0.06, -0.02), 10: (0.05, 0.10, 0.06),
        11: (0.08, 0.25, 0.14), 12: (0.08, 0.36, 0.30), 13: (0.0, 0.42, 0.44), 14: (-0.13, 0.46, 0.42),
        15: (-0.39, 0.55, 0.24), 16: (-0.47, 0.62, 0.09), 23: (0.28, 0.42, 0.36), 24: (0.31, 0.30, 0.22),
        25: (0.36, 0.10, 0.08), 26: (0.35, -0.02, -0.14),
    }
)  # fmt: skip
"""Under the back strand alone: the front one stays outside, a ridge."""

FRONT_ONLY: Final[Array] = _changed(
    {
        4: (-0.23, 0.42, -0.40), 5: (0.02, 0.46, -0.36), 6: (0.13, 0.47, -0.24), 7: (0.17, 0.40, -0.06),
        8: (0.14, 0.16, 0.03), 9: (0.07, -0.10, 0.05), 10: (0.05, -0.27, 0.18), 25: (0.37, -0.08, 0.18),
        26: (0.36, 0.18, 0.04), 27: (0.22, 0.42, -0.14), 28: (-0.10, 0.52, -0.12),
    }
)  # fmt: skip
"""Under the front strand alone: the back one stays inside, a ridge there."""

CHAIN: Final[Array] = np.array(
    [(-1.252, 0.777, -0.092), (-0.95, 0.62, -0.20), (-0.62, 0.55, -0.18), (-0.38, 0.56, -0.03)]
)
"""What comes before the top loop in a chain: the bump behind it."""

SHEAR: Final = -0.38
"""A tall stitch's next loop comes through the arch of the last, which lies this far from a hole's place."""


@kernel
def _stories(height: float) -> int:
    """Loops one above the other in a post: one up to a half double crochet, then one per stitch height."""
    return 1 if height < 1.75 else int(height + 0.5)


@kernel
def count_points(role: I1x1, offsets: I8x1, height: F8x1, out: I8x1) -> None:
    """Fill ``out`` (N,): control points of every node's stretch of yarn."""
    for i in range(len(role)):
        if role[i] == 2:
            out[i] = 4 + 48 - HEAD
        elif role[i] == 1:
            loops = offsets[i + 1] - offsets[i] + _stories(height[i]) - 1
            out[i] = 7 + 20 * loops + 21
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
    ridge: B1x1,
    tables: F8x3,
    chain: F8x2,
    deep: F8x1,
    relief: F8x1,
    bump: F8x1,
    cell: I4x1,
    below: I4x1,
    at: F8x2,
) -> None:
    """Fill cell, below (P,) and at (P, 3), from ``start[i]`` on, with the course of the yarn through every node.

    table_of : (N,) which of ``tables`` (K, 48, 3) is the course by the loops worked under, 0 being both
    ridge : (N,) whether a stitch above leaves this one's front strand free; chain : (4, 3), before a chain's loop
    deep : (N,) how far below its row a stitch is worked (around a post, in the row below); relief : (N,) how far it stands
    out; bump : (N,) how far the loops of one that are all in one anchor bulge, negative to the other side
    """
    for i in range(len(role)):
        p = start[i]
        if role[i] == 2:
            for k in range(4 + 48 - HEAD):
                cell[p], below[p] = i, -1
                at[p] = chain[k] if k < 4 else tables[0, HEAD + k - 4]
                p += 1
        if role[i] != 1:
            continue
        first, last = offsets[i], offsets[i + 1]
        high = max(height[i], 0.5)
        stories = _stories(high)
        part = high / stories
        table = tables[table_of[i]]
        begin = p
        bulging = last - first > 1 and anchors[first] == anchors[last - 1]
        for k in range(7):
            cell[p], below[p] = i, anchors[first]
            at[p, 0], at[p, 1], at[p, 2] = table[k, 0], _stretched(table[k, 1], high - 1.0), table[k, 2]
            p += 1
        for number in range(last - first + stories - 1):
            story = max(0, number - (last - first) + 1)
            use = table if story == 0 else tables[0]
            # The loops of a decrease lie side by side under one top loop.
            beside = 0.0 if last - first == 1 else (number + 0.5) / (last - first) - 0.5
            for k in range(7, 27):
                u, v, w = use[k, 0], use[k, 1], use[k, 2]
                if story > 0:
                    u += SHEAR * min(1.0, max(0.0, 0.6 - v))
                if v > 0.3 and story < stories - 1:
                    # An arch that a loop comes through, not the top loop: narrower.
                    u = -0.1 + 0.8 * (u + 0.1)
                if bulging and story == 0:
                    # Loops of one anchor stand around a bulge, and gather at its head.
                    t = min(1.0, max(0.0, (_stretched(v, part - 1.0) + 0.2) / (high + 0.1)))
                    out = math.sin(math.pi * t) * bump[i]
                    u = 0.75 * u + abs(out) * math.sin(2.4 * beside)
                    w = w + out * (0.35 + 0.65 * math.cos(2.4 * beside))
                elif v > 0.3 and story == 0 and last - first > 1:
                    u, v, w = u + 0.3 * beside, v - 0.1 * (0.5 - beside), w - 0.2 * (0.5 - beside)
                cell[p], below[p] = i, anchors[min(first + number, last - 1)]
                at[p, 0], at[p, 1], at[p, 2] = u, part * story + _stretched(v, part - 1.0), w
                p += 1
        for k in range(27, 48):
            v = table[k, 1]
            if stories > 1 and k < HEAD:
                v = part * (stories - 1) + _stretched(v, part - 1.0)
            else:
                v = _stretched(v, high - 1.0)
            cell[p], below[p] = i, anchors[last - 1]
            at[p, 0], at[p, 1], at[p, 2] = table[k, 0], v, table[k, 2]
            if ridge[i] and 33 <= k <= 38:
                at[p, 1] -= 0.06
                at[p, 2] += 0.12
            p += 1
        if deep[i] != 0.0 or relief[i] != 0.0:
            for q in range(begin, p):
                v = at[q, 1]
                at[q, 2] += relief[i] * min(1.0, max(0.0, 1.6 * (high - v)))
                if v < 0.5:
                    at[q, 1] -= deep[i] * min(1.0, (0.5 - v) / 0.5)

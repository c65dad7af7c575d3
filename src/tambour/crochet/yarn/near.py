"""Near: which stretches of the yarn may be near to each other, found on a grid, several slabs of it at a time."""

from __future__ import annotations

import math

import numpy as np

from tambour.core.arrays import B1x1, F4x1, F4x2, F8x1, F8x2, I4x1, I4x2, I8x1
from tambour.core.check import Array
from tambour.core.kernels import inner, kernel
from tambour.core.threads import share
from tambour.crochet.yarn.points import BLOCK

CELLS = 4e6
"""Cells of the grid that pairs are found in, at the most."""
BESIDE, ABOVE = (0, 0, 1, 1, 1, 0, -1, -1, -1), (0, 1, -1, 0, 1, -1, -1, 0, 1)
"""The rows of cells about one: its own, the four behind it, and the four before it."""
SLABS = 16
"""Stretches of the grid in which pairs are looked for, at the most."""


@kernel
def _segments(coords: F8x2, last: B1x1, begin: int, end: int, middle: F8x2, half: F8x1, box: F8x1) -> None:
    """Per point from ``begin`` to ``end``, the segment to the next one: middle, half its length; -1 where it is the ``last`` of its strand.

    box : (7,) the least and the greatest middle, and half the greatest length
    """
    for c in range(3):
        box[c], box[3 + c] = np.inf, -np.inf
    box[6] = 0.0
    for i in range(begin, end):
        half[i] = -1.0
        if last[i]:
            continue
        size = 0.0
        for c in range(3):
            middle[i, c] = 0.5 * (coords[i, c] + coords[i + 1, c])
            box[c], box[3 + c] = min(box[c], middle[i, c]), max(box[3 + c], middle[i, c])
            step = coords[i + 1, c] - coords[i, c]
            size += step * step
        half[i] = 0.5 * math.sqrt(size)
        box[6] = max(box[6], half[i])


@kernel
def _arcs(ends: I8x1, half: F8x1, strand: I4x1, arc: F8x1) -> int:
    """Per point its strand (-1 for the last of one) and the arc length at its segment's middle. Gives how many segments there are."""
    count = 0
    for s in range(len(ends) - 1):
        run = 0.0
        for i in range(ends[s], ends[s + 1] - 1):
            strand[i] = s
            arc[i] = run + half[i]
            run += 2.0 * half[i]
            count += 1
        if ends[s + 1] > ends[s]:
            strand[ends[s + 1] - 1] = -1
    return count


@kernel
def _live(
    half: F8x1, middle: F8x2, low: F8x1, cell: float, shape: I8x1, every: bool, only: B1x1, where: I4x1, live: B1x1
) -> None:
    """Fill where (N,), the cell of each segment of a grid, and unless ``every`` one is wanted mark those in and about which one of ``only`` (N,) lies."""
    for i in range(len(half)):
        where[i] = -1
        if half[i] < 0.0:
            continue
        p, q, r = (
            int((middle[i, 0] - low[0]) / cell),
            int((middle[i, 1] - low[1]) / cell),
            int((middle[i, 2] - low[2]) / cell),
        )
        where[i] = (p * shape[1] + q) * shape[2] + r
        if only[i] and not every:
            for a in range(max(0, p - 1), min(p + 2, shape[0])):
                for b in range(max(0, q - 1), min(q + 2, shape[1])):
                    row = (a * shape[1] + b) * shape[2]
                    for c in range(max(0, r - 1), min(r + 2, shape[2])):
                        live[row + c] = True


@kernel
def _sorted(where: I4x1, live: B1x1, head: I4x1, order: I4x1) -> int:
    """Segments of live cells by cell: those of cell k are order[head[k]:head[k + 1]]. Gives how many there are."""
    n = len(where)
    for i in range(n):
        if where[i] >= 0 and live[where[i]]:
            head[where[i] + 1] += 1
    for k in range(len(head) - 1):
        head[k + 1] += head[k]
    at = head[:-1].copy()
    for i in range(n):
        if where[i] >= 0 and live[where[i]]:
            order[at[where[i]]] = i
            at[where[i]] += 1
    return head[-1]


@kernel
def _told(
    coords: F8x2,
    strand: I4x1,
    arc: F8x1,
    middle: F8x2,
    half: F8x1,
    low: F8x1,
    only: B1x1,
    order: I4x1,
    begin: int,
    end: int,
    near: F4x2,
    owner: I4x1,
    wanted: B1x1,
) -> None:
    """Of segments ``begin`` to ``end`` in their ``order``, near : (8, M) float32, middle from ``low``, half the length, arc length, direction;
    owner : (M,) strand; wanted : (M,) whether it is among ``only`` (P,)."""
    for k in range(begin, end):
        i = order[k]
        owner[k], wanted[k] = strand[i], only[i]
        for c in range(3):
            near[c, k] = middle[i, c] - low[c]
            near[5 + c, k] = (coords[i + 1, c] - coords[i, c]) / max(2.0 * half[i], 1e-9)
        near[3, k], near[4, k] = half[i], arc[i]


@inner
def _reached(
    x: F4x1,
    y: F4x1,
    z: F4x1,
    half: F4x1,
    px: float,
    py: float,
    pz: float,
    most: float,
    of: I4x1,
    hit: I4x1,
    within: I4x1,
) -> np.int64:
    """Fill ``within`` with those ``of`` some segments whose middles lie so near to a place that they may touch: first all at once, then what is
    near enough is kept by counting on, without a branch."""
    for n in range(len(hit)):
        dx, dy, dz, far = px - x[n], py - y[n], pz - z[n], most + half[n]
        hit[n] = dx * dx + dy * dy + dz * dz < far * far
    many = np.uint64(0)
    for n in range(len(hit)):
        within[many] = of[n]
        many += np.uint64(hit[n])
    return np.int64(many)


@kernel
def close_pairs(
    shape: I8x1,
    head: I4x1,
    order: I4x1,
    near: F4x2,
    owner: I4x1,
    wanted: B1x1,
    every: bool,
    reach: float,
    along: float,
    begin: int,
    end: int,
    pairs: I4x2,
) -> int:
    """Pairs (Q, 2) of segments, one or both wanted, that may be nearer than ``reach``: all that are, and some that are not quite;
    further apart than ``along`` on a common strand; those that the layers of cells from ``begin`` to ``end`` find.

    every : whether all are wanted. Returns how many there are; those that ``pairs`` has no room for are only counted.
    """
    count = 0
    # Single precision only leaves out what is clearly too far.
    wide = np.float32(reach * 1.0001)
    size = len(order) + 1
    x, y, z = np.empty(size, np.float32), np.empty(size, np.float32), np.empty(size, np.float32)
    half, of = np.empty(size, np.float32), np.empty(size, np.int32)
    hit, within = np.empty(size, np.int32), np.empty(size, np.int32)
    for p in range(begin, end):
        for q in range(shape[1]):
            for r in range(shape[2]):
                here = (p * shape[1] + q) * shape[2] + r
                own = head[here]
                some = False
                for k in range(own, head[here + 1]):
                    some |= wanted[k]
                if not some:
                    continue
                # Where all are wanted, this cell and half of those around it: every pair once. Where some are, each of them
                # looks all around, and of two that are the first finds the other. Cells along r lie one behind the other.
                total = 0
                for side in range(5 if every else 9):
                    a, b = p + BESIDE[side], q + ABOVE[side]
                    if a < 0 or a >= shape[0] or b < 0 or b >= shape[1]:
                        continue
                    row = (a * shape[1] + b) * shape[2]
                    first, last = head[row + max(r - 1, 0)], head[row + min(r + 2, shape[2])]
                    if side == 0 and every:
                        first = own
                    to = total + last - first
                    x[total:to], y[total:to], z[total:to] = (
                        near[0, first:last],
                        near[1, first:last],
                        near[2, first:last],
                    )
                    half[total:to] = near[3, first:last]
                    for n in range(last - first):
                        of[total + n] = first + n
                    total = to
                for k in range(own, head[here + 1]):
                    if not wanted[k]:
                        continue
                    px, py, pz, most = near[0, k], near[1, k], near[2, k], near[3, k] + wide
                    far = along + near[3, k]
                    f = k + 1 - own if every else 0
                    many = _reached(
                        x[f:total],
                        y[f:total],
                        z[f:total],
                        half[f:total],
                        px,
                        py,
                        pz,
                        most,
                        of[f:total],
                        hit[f:total],
                        within,
                    )
                    # Nor by its distance from the line of the one or of the other; again without a branch.
                    left = 0
                    for number in range(many):
                        m = within[number]
                        within[left] = m
                        dx, dy, dz = px - near[0, m], py - near[1, m], pz - near[2, m]
                        square = dx * dx + dy * dy + dz * dz
                        t = dx * near[5, k] + dy * near[6, k] + dz * near[7, k]
                        s = dx * near[5, m] + dy * near[6, m] + dz * near[7, m]
                        other = wide + near[3, m]
                        beside = (square - t * t < other * other) & (square - s * s < most * most)
                        away = (owner[k] != owner[m]) | (abs(near[4, k] - near[4, m]) >= far + near[3, m])
                        left += 1 if beside & away & (every | (not wanted[m]) | (m > k)) else 0
                    for number in range(left):
                        if count < len(pairs):
                            pairs[count, 0], pairs[count, 1] = order[k], order[within[number]]
                        count += 1
    return count


@kernel
def _firsts(pairs: I4x2, count: I4x1) -> None:
    """Add to count (P + 1,) how many pairs begin with each point, one place further on."""
    for k in range(len(pairs)):
        count[min(pairs[k, 0], pairs[k, 1]) + 1] += 1


@kernel
def _along(pairs: I4x2, count: I4x1, out: I4x2) -> None:
    """Put pairs into ``out`` (Q, 2) in the order of their first along the yarn: what is pushed lies side by side in memory.

    count : (P + 1,) where those that begin with each point go; moved on
    """
    for k in range(len(pairs)):
        i = min(pairs[k, 0], pairs[k, 1])
        out[count[i], 0], out[count[i], 1] = i, max(pairs[k, 0], pairs[k, 1])
        count[i] += 1


def pairs(coords: Array, ends: Array, reach: float, along: float, only: Array | None = None) -> Array:
    """Pairs (Q, 2) of segments (point i to i + 1) that may be nearer than ``reach``: of all, or those of which one is marked in ``only`` (P,).

    along : stretches of one strand nearer to each other along it are no pair
    """
    n = len(coords)
    strand, arc, middle, half = np.empty(n, np.int32), np.empty(n), np.empty((n, 3)), np.empty(n)
    last = np.zeros(n, np.bool_)
    last[ends[1:][np.diff(ends) > 0] - 1] = True
    boxes = np.empty((n // BLOCK + 1, 7))
    boxes[:] = (np.inf,) * 3 + (-np.inf,) * 3 + (0.0,)
    share(n, BLOCK, lambda a, b: _segments(coords, last, a, b, middle, half, boxes[a // BLOCK]))
    count = int(_arcs(ends, half, strand, arc))
    if not count:
        return np.zeros((0, 2), np.int32)
    low, high = boxes[:, :3].min(0), boxes[:, 3:6].max(0)
    cell = 1.0001 * (reach + 2 * float(boxes[:, 6].max()))
    # A few strands far apart must not ask for a grid of any size.
    while np.prod(np.floor((high - low) / cell) + 1) > CELLS:
        cell *= 1.1
    shape = np.floor((high - low) / cell).astype(np.int64) + 1
    every = only is None
    some = np.ones(n, np.bool_) if only is None else only
    where, live = np.empty(n, np.int32), np.full(int(shape.prod()), every)
    share(n, BLOCK, lambda a, b: _live(half[a:b], middle[a:b], low, cell, shape, every, some[a:b], where[a:b], live))
    head, order = np.zeros(len(live) + 1, np.int32), np.empty(count, np.int32)
    count = int(_sorted(where, live, head, order))
    order, owner, near = order[:count], np.empty(count, np.int32), np.empty((8, count), np.float32)
    wanted = np.empty(count, np.bool_)
    share(
        count,
        BLOCK,
        lambda a, b: _told(coords, strand, arc, middle, half, low, some, order, a, b, near, owner, wanted),
    )
    layer = int(shape[1] * shape[2])
    block = max(1, -(-int(shape[0]) // SLABS)) if count > BLOCK else int(shape[0])
    found: dict[int, Array] = {}

    def look(a: int, b: int) -> None:
        asked = (shape, head, order, near, owner, wanted, every, reach, along, a, b)
        made = np.empty((max(64, 4 * int(head[b * layer] - head[a * layer])), 2), np.int32)
        size = int(close_pairs(*asked, made))
        if size > len(made):
            made = np.empty((size, 2), np.int32)
            close_pairs(*asked, made)
        found[a] = made[:size]

    share(int(shape[0]), block, look)
    slabs = [found[a] for a in sorted(found)]
    places = np.zeros(n + 1, np.int32)
    for slab in slabs:
        _firsts(slab, places)
    np.cumsum(places, out=places, dtype=np.int32)
    out = np.empty((sum(map(len, slabs)), 2), np.int32)
    for slab in slabs:
        _along(slab, places, out)
    return out

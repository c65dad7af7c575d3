"""Room between strands: how near the yarn's centre lines come to each other, and pushing them apart."""

from __future__ import annotations

import math

import numpy as np

from tambour.core.arrays import B1x1, F4x2, F8x1, F8x2, I4x1, I4x2, I8x1
from tambour.core.check import Array
from tambour.core.kernels import kernel

ALONG = 1.6
"""Stretches of one strand nearer to each other along it than so many diameters are not two that touch: yarn that turns
back on itself as tightly as it can is half a circle, π/2 diameters, away."""
BENT = 0.9
"""As a share of that, from where on they are pushed apart: what is pushed grows longer."""
ENOUGH, NEARLY = 0.975, 0.965
"""What is as near as the one to the aim has its room, and is not pushed; what is pushed comes to the other, at the least."""
GENTLE = 0.3
"""How far two are pushed apart at once, at the most, in diameters: yarn that lies crossed comes free without being stretched."""
SOON, NEVER = 12, 100
"""After so many rounds pairs are looked at again that are enough apart; further ones never."""
KNOWN = 1.2
"""Pairs are known up to so many diameters."""
STRAYED, MOVED = 0.11, 0.05
"""What has moved so many diameters in the first look may be near to something new: two that were not moved by more, and were
not known, are still ENOUGH apart. Later, what others have moved by the second may be too near to what it just had room from."""
CELLS = 4e6
"""Cells of the grid that pairs are found in, at the most."""
AROUND = 2
"""Points of the yarn to either side of what is too near that move with it."""
BESIDE, ABOVE = (0, 0, 1, 1, 1, 0, -1, -1, -1), (0, 1, -1, 0, 1, -1, -1, 0, 1)
"""The rows of cells about one: its own, the four behind it, and the four before it."""


@kernel
def _segments(coords: F8x2, ends: I8x1, strand: I4x1, arc: F8x1, middle: F8x2, half: F8x1, box: F8x2) -> int:
    """Per point, the segment to the next one: strand (-1 for none), arc length at its middle, middle, half its length.

    Returns how many there are; box : (3, 3), the least and the greatest middle, and (first) half the greatest length.
    """
    count = 0
    for c in range(3):
        box[0, c], box[1, c], box[2, c] = np.inf, -np.inf, 0.0
    for s in range(len(ends) - 1):
        run = 0.0
        for i in range(ends[s], ends[s + 1]):
            strand[i] = -1
            if i + 1 < ends[s + 1]:
                size = 0.0
                for c in range(3):
                    middle[i, c] = 0.5 * (coords[i, c] + coords[i + 1, c])
                    box[0, c], box[1, c] = min(box[0, c], middle[i, c]), max(box[1, c], middle[i, c])
                    step = coords[i + 1, c] - coords[i, c]
                    size += step * step
                half[i] = 0.5 * math.sqrt(size)
                strand[i] = s
                arc[i] = run + half[i]
                run += 2.0 * half[i]
                box[2, 0] = max(box[2, 0], half[i])
                count += 1
    return count


@kernel
def nearest(coords: F8x2, i: int, j: int, found: F8x1) -> float:
    """Squared distance of segments (i, i + 1) and (j, j + 1); found = (s, t), where on them, 0…1.

    C. Ericson, "Real-Time Collision Detection" (2005), 5.1.9.
    """
    a = e = f = b = c = 0.0
    for k in range(3):
        d1, d2, r = coords[i + 1, k] - coords[i, k], coords[j + 1, k] - coords[j, k], coords[i, k] - coords[j, k]
        a += d1 * d1
        e += d2 * d2
        b += d1 * d2
        c += d1 * r
        f += d2 * r
    a, e = max(a, 1e-18), max(e, 1e-18)
    whole = a * e - b * b
    s = min(1.0, max(0.0, (b * f - c * e) / whole)) if whole > 1e-12 * a * e else 0.5
    t = (b * s + f) / e
    if t < 0.0:
        t, s = 0.0, min(1.0, max(0.0, -c / a))
    elif t > 1.0:
        t, s = 1.0, min(1.0, max(0.0, (b - c) / a))
    found[0], found[1] = s, t
    size = 0.0
    for k in range(3):
        x = coords[i, k] + s * (coords[i + 1, k] - coords[i, k]) - coords[j, k] - t * (coords[j + 1, k] - coords[j, k])
        size += x * x
    return size


@kernel
def _live(strand: I4x1, middle: F8x2, low: F8x1, cell: float, shape: I8x1, only: B1x1, where: I4x1, live: B1x1) -> None:
    """Fill where (N,), the cell of each segment of a grid, and mark those in and about which one of ``only`` (N,) lies."""
    for i in range(len(strand)):
        where[i] = -1
        if strand[i] < 0:
            continue
        p, q, r = (
            int((middle[i, 0] - low[0]) / cell),
            int((middle[i, 1] - low[1]) / cell),
            int((middle[i, 2] - low[2]) / cell),
        )
        where[i] = (p * shape[1] + q) * shape[2] + r
        if only[i]:
            for a in range(max(0, p - 1), min(p + 2, shape[0])):
                for b in range(max(0, q - 1), min(q + 2, shape[1])):
                    row = (a * shape[1] + b) * shape[2]
                    for c in range(max(0, r - 1), min(r + 2, shape[2])):
                        live[row + c] = True


@kernel
def _bins(
    coords: F8x2,
    strand: I4x1,
    arc: F8x1,
    middle: F8x2,
    half: F8x1,
    low: F8x1,
    only: B1x1,
    where: I4x1,
    live: B1x1,
    head: I4x1,
    order: I4x1,
    near: F4x2,
    owner: I4x1,
    wanted: B1x1,
) -> None:
    """Segments of live cells by cell: those of cell k are order[head[k]:head[k + 1]].

    In that order, near : (8, M) float32, middle from ``low``, half the length, arc length, direction; owner : (M,) strand; wanted : (M,) whether it is
    among ``only`` (P,)
    """
    n = len(strand)
    for i in range(n):
        if where[i] >= 0 and live[where[i]]:
            head[where[i] + 1] += 1
    for k in range(len(head) - 1):
        head[k + 1] += head[k]
    at = head[:-1].copy()
    for i in range(n):
        if where[i] >= 0 and live[where[i]]:
            k = at[where[i]]
            at[where[i]] += 1
            order[k], owner[k], wanted[k] = i, strand[i], only[i]
            for c in range(3):
                near[c, k] = middle[i, c] - low[c]
                near[5 + c, k] = (coords[i + 1, c] - coords[i, c]) / max(2.0 * half[i], 1e-9)
            near[3, k], near[4, k] = half[i], arc[i]


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
    pairs: I4x2,
) -> int:
    """Pairs (Q, 2) of segments, one or both wanted, that may be nearer than ``reach``: all that are, and some that are not quite;
    further apart than ``along`` on a common strand.

    every : whether all are wanted. Returns how many there are; those that ``pairs`` has no room for are only counted.
    """
    count = 0
    # Single precision only leaves out what is clearly too far.
    wide = np.float32(reach * 1.0001)
    within = np.empty(max(64, len(order)), np.int32)
    for p in range(shape[0]):
        for q in range(shape[1]):
            for r in range(shape[2]):
                here = (p * shape[1] + q) * shape[2] + r
                if head[here] == head[here + 1]:
                    continue
                # Where all are wanted, this cell and half of those around it: every pair once. Where some are, each of them
                # looks all around, and of two that are the first finds the other. Cells along r lie one behind the other.
                for side in range(5 if every else 9):
                    a, b = p + BESIDE[side], q + ABOVE[side]
                    if a < 0 or a >= shape[0] or b < 0 or b >= shape[1]:
                        continue
                    row = (a * shape[1] + b) * shape[2]
                    first, last = head[row + max(r - 1, 0)], head[row + min(r + 2, shape[2])]
                    if first == last:
                        continue
                    for k in range(head[here], head[here + 1]):
                        if not wanted[k]:
                            continue
                        x, y, z, size = near[0, k], near[1, k], near[2, k], near[3, k] + wide
                        far = along + near[3, k]
                        # No branch: what is near enough is kept by counting on.
                        many = 0
                        for m in range(k + 1 if side == 0 and every else first, last):
                            dx, dy, dz, most = x - near[0, m], y - near[1, m], z - near[2, m], size + near[3, m]
                            within[many] = m
                            many += 1 if dx * dx + dy * dy + dz * dz < most * most else 0
                        # Nor by its distance from the line of the one or of the other; again without a branch.
                        left = 0
                        for number in range(many):
                            m = within[number]
                            within[left] = m
                            dx, dy, dz = x - near[0, m], y - near[1, m], z - near[2, m]
                            square = dx * dx + dy * dy + dz * dz
                            t = dx * near[5, k] + dy * near[6, k] + dz * near[7, k]
                            s = dx * near[5, m] + dy * near[6, m] + dz * near[7, m]
                            other, own = wide + near[3, m], wide + near[3, k]
                            beside = (square - t * t < other * other) & (square - s * s < own * own)
                            away = (owner[k] != owner[m]) | (abs(near[4, k] - near[4, m]) >= far + near[3, m])
                            left += 1 if beside & away & (every | (not wanted[m]) | (m > k)) else 0
                        for number in range(left):
                            if count < len(pairs):
                                pairs[count, 0], pairs[count, 1] = order[k], order[within[number]]
                            count += 1
    return count


@kernel
def push(
    coords: F8x2, pairs: I4x2, apart: float, enough: float, rounds: int, nearly: float, around: int, marked: B1x1
) -> None:
    """Push pairs of segments that are not ``enough`` apart ``apart``, one after the other, ``rounds`` times.

    Pairs that are enough apart are looked at again after some rounds, the later the further apart they are, and at the end;
    but for those so far apart that one of them must stray before they are too near.
    marked : (P,) becomes true at the points of pairs that are not even ``nearly`` apart then, and ``around`` to either side of them
    """
    found = np.zeros(2)
    n = len(coords)
    wait = np.zeros(len(pairs), np.int8)
    for number in range(rounds + 1):
        for k in range(len(pairs)):
            if wait[k] > 0 and (number < rounds or wait[k] > NEVER - rounds):
                wait[k] -= 1
                continue
            i, j = pairs[k, 0], pairs[k, 1]
            gap = nearest(coords, i, j, found)
            if number == rounds:
                if gap < nearly * nearly:
                    for m in range(max(0, i - around), min(n, i + around + 2)):
                        marked[m] = True
                    for m in range(max(0, j - around), min(n, j + around + 2)):
                        marked[m] = True
                continue
            if gap >= enough * enough:
                later = 1 + int((math.sqrt(gap) / enough - 1.0) / 0.015)
                wait[k] = later if later <= SOON else NEVER
                continue
            gap = max(math.sqrt(gap), 1e-9)
            s, t = found[0], found[1]
            # The four ends move so that the nearest points part by what is missing.
            share = 0.5 * min(apart - gap, GENTLE * apart) / gap
            own, other = (1 - s) * (1 - s) + s * s, (1 - t) * (1 - t) + t * t
            for c in range(3):
                d = (
                    coords[i, c]
                    + s * (coords[i + 1, c] - coords[i, c])
                    - coords[j, c]
                    - t * (coords[j + 1, c] - coords[j, c])
                ) * share
                coords[i, c] += (1 - s) * d / own
                coords[i + 1, c] += s * d / own
                coords[j, c] -= (1 - t) * d / other
                coords[j + 1, c] -= t * d / other


def _pairs(coords: Array, ends: Array, reach: float, along: float, only: Array | None = None) -> Array:
    """Pairs (Q, 2) of segments that may be nearer than ``reach``: of all, or those of which one is marked in ``only`` (P,)."""
    n = len(coords)
    strand, arc, middle, half, box = np.empty(n, np.int32), np.empty(n), np.empty((n, 3)), np.empty(n), np.zeros((3, 3))
    count = int(_segments(coords, ends, strand, arc, middle, half, box))
    if not count:
        return np.zeros((0, 2), np.int32)
    low, high = box[0], box[1]
    cell = 1.0001 * (reach + 2 * float(box[2, 0]))
    # A few strands far apart must not ask for a grid of any size.
    while np.prod(np.floor((high - low) / cell) + 1) > CELLS:
        cell *= 1.1
    shape = np.floor((high - low) / cell).astype(np.int64) + 1
    where, live = np.empty(n, np.int32), np.zeros(int(shape.prod()), np.bool_)
    some = np.ones(n, np.bool_) if only is None else only
    if only is None:
        live[:] = True
    _live(strand, middle, low, cell, shape, np.zeros(n, np.bool_) if only is None else only, where, live)
    if only is not None:
        count = int(np.count_nonzero(live[where[where >= 0]]))
    head = np.zeros(len(live) + 1, np.int32)
    order, owner, near = np.empty(count, np.int32), np.empty(count, np.int32), np.empty((8, count), np.float32)
    wanted = np.zeros(count, np.bool_)
    _bins(coords, strand, arc, middle, half, low, some, where, live, head, order, near, owner, wanted)
    pairs = np.empty((max(64, 4 * count), 2), np.int32)
    found = int(close_pairs(shape, head, order, near, owner, wanted, only is None, reach, along, pairs))
    if found > len(pairs):
        pairs = np.zeros((found, 2), np.int32)
        close_pairs(shape, head, order, near, owner, wanted, only is None, reach, along, pairs)
    out = np.empty((found, 2), np.int32)
    _along(pairs[:found], np.zeros(n + 1, np.int32), out)
    return out


@kernel
def _along(pairs: I4x2, count: I4x1, out: I4x2) -> None:
    """Fill ``out`` (Q, 2) with pairs in the order of their first along the yarn: what is pushed lies side by side in memory.

    count : (P + 1,) zeros
    """
    for k in range(len(pairs)):
        count[min(pairs[k, 0], pairs[k, 1]) + 1] += 1
    for i in range(len(count) - 1):
        count[i + 1] += count[i]
    for k in range(len(pairs)):
        i = min(pairs[k, 0], pairs[k, 1])
        out[count[i], 0], out[count[i], 1] = i, max(pairs[k, 0], pairs[k, 1])
        count[i] += 1


def distances(coords: Array, ends: Array, diameter: float, reach: float) -> tuple[Array, Array]:
    """Where centre lines are nearer than ``reach`` (mm): pairs (Q, 2) of segments (point i to i + 1), distances (Q,).

    coords : (P, 3) mm; ends : (S + 1,) offsets of the strands; diameter : of the yarn, mm, see ALONG
    """
    pairs = _pairs(coords, ends, reach, ALONG * diameter)
    found = np.zeros(2)
    far = np.array([nearest(coords, i, j, found) for i, j in pairs.tolist()]) ** 0.5
    return pairs[far < reach], far[far < reach]


def clear(coords: Array, ends: Array, diameter: float, *, looks: int = 3, rounds: int = 8, apart: float = 1.0) -> None:
    """Move the points (P, 3) of strands so that their centre lines come to be a diameter apart, as far as they can.

    looks : how often near pairs are searched anew; rounds : pushes in between; apart : the aim, in diameters

    Yarn that already has its room is looked at once: the later looks are only at what was too near or has moved since, and
    about it.
    """
    only, seen = None, coords.copy()
    for look in range(looks):
        pairs = _pairs(coords, ends, KNOWN * diameter, BENT * ALONG * diameter, only)
        if not len(pairs):
            return
        if only is not None:
            seen[only] = coords[only]
        only = np.zeros(len(coords), np.bool_)
        aim = apart * diameter
        push(coords, pairs, aim, ENOUGH * aim, rounds, NEARLY * aim, AROUND, only)
        strayed(coords, seen, (MOVED if look else STRAYED) * diameter, only)
        if look == 0:
            seen = coords.copy()
        if not only.any():
            return


@kernel
def strayed(coords: F8x2, seen: F8x2, far: float, marked: B1x1) -> None:
    """Mark the points (P,) that are ``far`` from where they were ``seen``: they may have come near to others."""
    for i in range(len(coords)):
        size = 0.0
        for c in range(3):
            step = coords[i, c] - seen[i, c]
            size += step * step
        if size > far * far:
            marked[max(0, i - 1)] = marked[i] = True

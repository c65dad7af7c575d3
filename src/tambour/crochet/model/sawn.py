"""Sawn: where a plane cuts a limb off a body at the narrowest, for limbs whose tip is no good middle of them, as that of a flat ear."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from tambour.core.arrays import F8x1, F8x2, I4x2, I8x1
from tambour.core.check import Array
from tambour.core.kernels import kernel

STEP = 0.5
"""Planes are looked at so far apart, in stitches."""
WAYS = 90
"""So many ways over all sides; a plane faces those of them that look out of the body."""
OUT = 0.15
"""How far out a plane faces, at the least, as a cosine."""
FINER = 0.22, 8
"""By what angle a plane is turned about the best one, in how many directions, to find a better."""
EVEN, WIDENS = 2.6, 3.2
"""A limb's section grows by no more than the one for every stitch on, just before the cut, and by more than the other beyond it."""
STOUT = 0.12
"""A limb has at least so much surface for the square of what it is around: half a ball has .16, a bump on it less."""
SHARE = 0.3
"""What has more of the surface than this is no limb."""


@dataclass(frozen=True, eq=False, slots=True)
class Saw:
    """A plane that cuts a limb off: unit normal (3,), and how far along it; around : the length of the cut; size : the limb's surface
    for the square of that; inside : (V,) bool, the vertices of the limb."""

    normal: Array
    level: float
    around: float
    size: float
    inside: Array


@kernel
def _flood(
    high: F8x1, weight: F8x1, most: float, faces: I4x2, offsets: I8x1, near: I8x1, start: int, low: F8x1, heap: I8x1
) -> None:
    """Fill low (V,), -infinite at first, with how low one must go from ``start`` to come to a vertex, from the highest on, until they
    weigh ``most``. heap : room for (V,)."""
    size, total = 1, 0.0
    heap[0] = start
    low[start] = high[start]
    seen = np.zeros(len(high), np.int64)
    seen[start] = 1
    while size > 0:
        v = heap[0]
        size -= 1
        last, i = heap[size], 0
        heap[0] = last
        while True:
            c = 2 * i + 1
            if c >= size:
                break
            if c + 1 < size and low[heap[c + 1]] > low[heap[c]]:
                c += 1
            if low[heap[i]] >= low[heap[c]]:
                break
            heap[i], heap[c] = heap[c], heap[i]
            i = c
        total += weight[v]
        if total > most:
            for k in range(size):
                low[heap[k]] = -np.inf
            low[v] = -np.inf
            return
        for e in range(offsets[v], offsets[v + 1]):
            for k in range(3):
                n = faces[near[e], k]
                if seen[n]:
                    continue
                seen[n] = 1
                low[n] = min(high[n], low[v])
                i = size
                heap[i] = n
                size += 1
                while i > 0 and low[heap[(i - 1) // 2]] < low[heap[i]]:
                    p = (i - 1) // 2
                    heap[i], heap[p] = heap[p], heap[i]
                    i = p


@kernel
def _sections(x: F8x2, faces: I4x2, low: F8x1, top: float, step: float, around: F8x1) -> None:
    """Add to around (K,) how long the line is on which ``low`` is ``top - step * k``, on the average about there."""
    for f in range(len(faces)):
        a, b, c = faces[f, 0], faces[f, 1], faces[f, 2]
        least, most = min(low[a], low[b], low[c]), max(low[a], low[b], low[c])
        if most == -np.inf:
            continue
        ux, uy, uz = x[b, 0] - x[a, 0], x[b, 1] - x[a, 1], x[b, 2] - x[a, 2]
        wx, wy, wz = x[c, 0] - x[a, 0], x[c, 1] - x[a, 1], x[c, 2] - x[a, 2]
        if least == -np.inf:
            continue
        # The slope of ``low`` on the triangle times its area is the length of its lines times how far apart they are.
        p, q = low[b] - low[a], low[c] - low[a]
        gx, gy, gz = p * wx - q * ux, p * wy - q * uy, p * wz - q * uz
        total = 0.5 * math.sqrt(gx * gx + gy * gy + gz * gz)
        first, last = int((top - most) / step + 0.5), int((top - least) / step + 0.5)
        if most - least < 1e-9:
            continue
        for k in range(max(first, 0), min(last, len(around) - 1) + 1):
            upper, lower = min(most, top - step * (k - 0.5)), max(least, top - step * (k + 0.5))
            if upper > lower:
                around[k] += total * (upper - lower) / (most - least) / step


class Saws:
    """Looks for planes that cut limbs off one surface. vertices (V, 3), faces (F, 3), in stitches; known : the faces about each vertex."""

    def __init__(self, vertices: Array, faces: Array, known: tuple[Array, Array], weight: Array) -> None:
        self.x = np.ascontiguousarray(vertices, np.float64)
        self.faces = np.ascontiguousarray(faces, np.int32)
        self.known, self.weight = known, weight
        k = np.arange(WAYS) + 0.5
        up, turn = 1.0 - 2.0 * k / WAYS, math.pi * (1.0 + math.sqrt(5.0)) * k
        flat = np.sqrt(1.0 - up**2)
        self.ways = np.column_stack([flat * np.cos(turn), flat * np.sin(turn), up])

    def best(self, tip: int, others: Array, out: Array, least: float, short: float) -> Saw | None:
        """The plane that cuts off a limb about vertex ``tip``, without the vertices ``others``, with the most surface for what it is
        around. out : (3,) where the tip looks; least : how long the cut is, short : how far out of it the limb stands, at the least."""
        found: Saw | None = None
        ways = self.ways[(self.ways * out).sum(1) > OUT]
        for _ in range(2):
            for way in ways:
                one = self._along(tip, others, way, least, short)
                if one is not None and (found is None or one.size > found.size):
                    found = one
            if found is None:
                return None
            side = np.cross(found.normal, np.eye(3)[int(np.abs(found.normal).argmin())])
            side = side / np.sqrt((side**2).sum())
            other = np.cross(found.normal, side)
            angle = 2.0 * math.pi * np.arange(FINER[1])[:, None] / FINER[1]
            ways = found.normal + math.tan(FINER[0]) * (np.cos(angle) * side + np.sin(angle) * other)
            ways = ways / np.sqrt((ways**2).sum(1, keepdims=True))
        return found

    def _along(self, tip: int, others: Array, way: Array, least: float, short: float) -> Saw | None:
        """The best plane across ``way`` (3,)."""
        high = np.ascontiguousarray((self.x * way).sum(1))
        low = np.full(len(high), -np.inf)
        most = SHARE * float(self.weight.sum())
        heap = np.zeros(len(high), np.int64)
        _flood(high, self.weight, most, self.faces, *self.known, tip, low, heap)
        own = np.isfinite(low)
        top, end = float(low[tip]), float(low[own].min())
        count = int((top - end) / STEP)
        if count < 5:
            return None
        around = np.zeros(count + 1)
        _sections(self.x, self.faces, low, top, STEP, around)
        level = top - STEP * np.arange(count + 1)
        order = np.argsort(-low[own])
        upto = np.concatenate([[0.0], np.cumsum(self.weight[own][order])])
        inside = upto[np.searchsorted(-low[own][order], -level, "right")]
        last = float(low[others].max()) if len(others) else -np.inf
        size = np.convolve(np.pad(around, 1, mode="edge"), [0.25, 0.5, 0.25], "valid")
        peak = float(high[own & (low >= level[-1])].max())
        best: tuple[float, int] | None = None
        for k in range(2, count - 2):
            if level[k] <= last or size[k] < least or peak - level[k] < short:
                continue
            ahead = min(2, k)
            on = min(count, k + max(2, round(0.25 * size[k] / (2.0 * math.pi) / STEP)))
            before = (size[k] - size[k - ahead]) / (STEP * ahead)
            beyond = (size[on] - size[k]) / (STEP * (on - k))
            share = inside[k] / size[k] ** 2
            if before < EVEN and beyond > WIDENS and share > STOUT and (best is None or share > best[0]):
                best = float(share), k
        if best is None:
            return None
        k = best[1]
        # Where the line is shortest in the crease, not where it began to widen.
        return Saw(way, float(level[k]), float(size[k]), best[0], low > level[k])

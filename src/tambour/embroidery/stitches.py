"""Stitches: needle points of one unbroken thread, what each is for, and the small steps every family shares."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

import numpy as np

from tambour.core.arrays import F8x2
from tambour.core.check import Array
from tambour.core.kernels import kernel
from tambour.embroidery.piece import RUNNING, TRAVEL


@dataclass(frozen=True, eq=False, slots=True)
class Stitches:
    """n needle points in order, without a jump between them.

    xy : (n, 2) mm; kind : (n,) uint8; run : (n,) int64, never falling: points of one row or one turn share it
    facts : mm of connectors and the like, added up over a design
    """

    xy: Array
    kind: Array
    run: Array
    facts: Mapping[str, float] = field(default_factory=dict)

    def __len__(self) -> int:
        return len(self.xy)

    @classmethod
    def none(cls) -> Stitches:
        """No stitches."""
        return cls(np.zeros((0, 2)), np.zeros(0, np.uint8), np.zeros(0, np.int64))

    @classmethod
    def of(cls, xy: Array, kind: int, per_stitch: bool = False) -> Stitches:
        """One run through ``xy`` (n, 2), or a run per stitch (satin: each side-to-side stitch lies by itself)."""
        n = len(xy)
        run = np.arange(n) if per_stitch else np.zeros(n, np.int64)
        return cls(np.ascontiguousarray(xy, np.float64), np.full(n, kind, np.uint8), run)

    def reversed(self) -> Stitches:
        """The same thread from its other end."""
        n = len(self)
        if n < 2:
            return self
        kind = np.r_[self.kind[-1:], self.kind[:0:-1]]
        run = self.run[-1] - np.r_[self.run[-1:], self.run[:0:-1]]
        return Stitches(np.ascontiguousarray(self.xy[::-1]), kind, run, self.facts)


def join(parts: Iterable[Stitches]) -> Stitches:
    """Several threads as one: the way from each to the next is a single stitch, whatever its length."""
    parts = [p for p in parts if len(p)]
    if not parts:
        return Stitches.none()
    facts: dict[str, float] = {}
    runs, base = [], 0
    for p in parts:
        runs.append(p.run - p.run[0] + base)
        base = int(runs[-1][-1]) + 1
        for name, value in p.facts.items():
            facts[name] = facts.get(name, 0.0) + value
    return Stitches(
        np.concatenate([p.xy for p in parts]), np.concatenate([p.kind for p in parts]), np.concatenate(runs), facts
    )


@kernel
def walk(line: F8x2, length: float, tolerance: float) -> F8x2:
    """Needle points along a polyline (n, 2): stitches of at most ``length`` that keep within ``tolerance`` of it.

    From each point on, the farthest place is taken that a straight stitch reaches so; the places left over at the end
    are evened out by halving the last two.
    """
    n = len(line)
    if n < 2:
        return line.copy()
    total = 0.0
    for i in range(n - 1):
        total += math.hypot(line[i + 1, 0] - line[i, 0], line[i + 1, 1] - line[i, 1])
    out = np.empty((int(2 * total / length) + 2 * n + 4, 2))
    out[0] = line[0]
    m = 1
    i = 0  # the needle is on the piece from vertex i to i + 1, at (x, y)
    x, y = line[0, 0], line[0, 1]
    while True:
        # Take in vertices while all that is passed lies near the chord.
        j = i + 1
        while j < n - 1 and math.hypot(line[j + 1, 0] - x, line[j + 1, 1] - y) <= length:
            qx, qy = line[j + 1, 0], line[j + 1, 1]
            span = (qx - x) ** 2 + (qy - y) ** 2
            good = True
            for k in range(i + 1, j + 1):
                dx, dy = line[k, 0] - x, line[k, 1] - y
                f = 0.0 if span == 0 else min(1.0, max(0.0, (dx * (qx - x) + dy * (qy - y)) / span))
                if math.hypot(dx - f * (qx - x), dy - f * (qy - y)) > tolerance:
                    good = False
                    break
            if not good:
                break
            j += 1
        px, py, qx, qy = line[j - 1, 0], line[j - 1, 1], line[j, 0], line[j, 1]
        reach = math.hypot(qx - x, qy - y)
        if reach <= length + 1e-9 and j < n - 1 and m > 0:
            # Go on past vertex j on its next piece, as far as length and tolerance allow.
            rx, ry = line[j + 1, 0], line[j + 1, 1]
            low, high = 0.0, 1.0
            for _ in range(20):
                f = (low + high) / 2
                tx, ty = qx + f * (rx - qx), qy + f * (ry - qy)
                span = (tx - x) ** 2 + (ty - y) ** 2
                good = span <= length * length
                for k in range(i + 1, j + 1):
                    dx, dy = line[k, 0] - x, line[k, 1] - y
                    g = 0.0 if span == 0 else min(1.0, max(0.0, (dx * (tx - x) + dy * (ty - y)) / span))
                    if math.hypot(dx - g * (tx - x), dy - g * (ty - y)) > tolerance:
                        good = False
                        break
                if good:
                    low = f
                else:
                    high = f
            x, y = qx + low * (rx - qx), qy + low * (ry - qy)
            i = j
        elif reach <= length + 1e-9:
            x, y = qx, qy
            i = j
        else:
            # The piece is longer than a stitch: its far end is reached in equal steps.
            ax, ay = (x, y) if i == j - 1 else (px, py)
            if i < j - 1:
                x, y = px, py
                i = j - 1
            else:
                parts = math.ceil(reach / length - 1e-9)
                x, y = ax + (qx - ax) / parts, ay + (qy - ay) / parts
        out[m, 0], out[m, 1] = x, y
        m += 1
        if i >= n - 1 or (i == n - 2 and math.hypot(x - line[n - 1, 0], y - line[n - 1, 1]) < 1e-9):
            break
        if m >= len(out) - 1:
            break
    out[m - 1] = line[n - 1]
    return out[:m].copy()


def chain(parts: Iterable[Stitches], length: float) -> Stitches:
    """Several threads as one, straight ways of stitches no longer than ``length`` between them."""
    made: list[Stitches] = []
    for part in parts:
        if made and len(part) and np.hypot(*(part.xy[0] - made[-1].xy[-1])) > length:
            link = line_stitches(np.array([made[-1].xy[-1], part.xy[0]]), length, TRAVEL, 0.0)
            made.append(Stitches(link.xy[1:-1], link.kind[1:-1], link.run[1:-1]))
        if len(part):
            made.append(part)
    return join(made)


def line_stitches(line: Array, length: float, kind: int = RUNNING, tolerance: float = 0.1) -> Stitches:
    """Running stitch along a polyline (n, 2)."""
    return Stitches.of(walk(np.ascontiguousarray(line, np.float64), length, tolerance), kind)

"""Fronts: a surface as the lines that rounds lie on, one row of stitches apart, from a tip to its far end or its rim."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tambour.core.check import Array
from tambour.crochet.model.geodesic import girth, lines

DRAWN = 12
"""The most stitches that are drawn together at the end."""


@dataclass(frozen=True, eq=False, slots=True)
class Fronts:
    """The lines of a part's rounds, lengths in stitches.

    tip, end : points (3,) where it begins and where it is drawn together, the middle of the rim where it is open
    lines : of every round, (K, 3), in the direction of work; closed : whether it is drawn together
    lost : the share of the length of all lines that no round follows: bumps beside the part's own way
    closing : how many of the lines, the last ones, close an end that is wide where the way ends: they take up nothing of it
    """

    tip: Array
    end: Array
    lines: tuple[Array, ...]
    closed: bool
    lost: float
    closing: int = 0

    @property
    def rows(self) -> int:
        """How many lines lie along the way."""
        return len(self.lines) - self.closing

    @property
    def girths(self) -> Array:
        """The length of every line."""
        return np.array([girth(line) for line in self.lines])


def fronts(
    vertices: Array, faces: Array, f: Array, rows: int, tip: int, rim: float | None = None, heights: Array | None = None
) -> Fronts:
    """The lines of ``rows`` rounds where the way ``f`` (V,) from vertex ``tip`` rises evenly, or as their ``heights`` (rows,) do.

    rim : the value at which the part ends open; None: it ends where f is largest, one row after its last round
    """
    far = float(f.max()) if rim is None else rim
    upto = np.cumsum(np.ones(rows) if heights is None else heights)
    step = far / (upto[-1] + 1.0 if rim is None else upto[-1])
    made: list[Array] = []
    lost = total = 0.0
    middle = vertices[tip]
    for k in range(1, rows + 1):
        value = step * float(upto[k - 1]) if rim is None or k < rows else far - 0.02 * step
        found = lines(vertices, faces, f, value)
        if not found:
            break
        sizes = np.array([girth(line) for line in found])
        # Of several the longest goes on, unless another is much nearer to where the last one was.
        kept = int(sizes.argmax())
        near = np.array([float(np.sqrt(((line.mean(0) - middle) ** 2).sum())) for line in found])
        likely = np.flatnonzero(sizes > 0.75 * sizes.max())
        if len(likely) > 1:
            kept = int(likely[near[likely].argmin()])
        lost += float(sizes.sum() - sizes[kept])
        total += float(sizes.sum())
        made.append(found[kept][::-1])
        middle = found[kept].mean(0)
    end = vertices[int(f.argmax())] if rim is None else made[-1].mean(0)
    led = len(made)
    # A flat end is worked to its middle: what is still wide is halved until it can be drawn together.
    while rim is None and girth(made[-1]) > DRAWN:
        made.append(end + 0.5 * (made[-1] - end))
    return Fronts(vertices[tip], end, tuple(made), rim is None, lost / max(total, 1e-12), len(made) - led)


def along(line: Array, count: int, start: float) -> Array:
    """``count`` points (count, 3) even along a closed line, the first at the way ``start`` along it."""
    size = np.sqrt(((np.roll(line, -1, 0) - line) ** 2).sum(1))
    way = np.concatenate([[0.0], np.cumsum(size)])
    at = (start + np.arange(count) / count * way[-1]) % way[-1]
    closed = np.vstack([line, line[:1]])
    return np.column_stack([np.interp(at, way, closed[:, k]) for k in range(3)])


def beside(line: Array, points: Array) -> Array:
    """The points (P, 3) of a closed line that are nearest to ``points`` (P, 3)."""
    ahead = np.roll(line, -1, 0) - line
    size = np.maximum((ahead**2).sum(1), 1e-12)
    x, y, z = (points[:, k, None] - line[:, k] for k in range(3))  # a coordinate at a time: sums over three are slow
    share = np.clip((x * ahead[:, 0] + y * ahead[:, 1] + z * ahead[:, 2]) / size, 0.0, 1.0)
    x, y, z = (share * ahead[:, k] - off for k, off in enumerate((x, y, z)))
    best = (x * x + y * y + z * z).argmin(1)
    return np.asarray(line[best] + share[np.arange(len(points)), best, None] * ahead[best])


def nearest_way(line: Array, point: Array) -> float:
    """The way along a closed line to where it is nearest to ``point``."""
    ahead = np.roll(line, -1, 0) - line
    size = (ahead**2).sum(1)
    share = np.clip(((point - line) * ahead).sum(1) / np.maximum(size, 1e-12), 0.0, 1.0)
    best = int(((line + share[:, None] * ahead - point) ** 2).sum(1).argmin())
    long = np.sqrt(size)
    return float(long[:best].sum() + share[best] * long[best])


def laid(way: Fronts, counts: list[int], seam: Array) -> list[Array]:
    """The stitches of every round as points (n, 3): even along its line, the first above that of the round below; that of
    the first round lies towards ``seam`` (3,)."""
    made: list[Array] = []
    for line, count in zip(way.lines, counts):
        if made:
            start = nearest_way(line, made[-1][0])
        else:
            start = nearest_way(line, line.mean(0) + 100.0 * seam)
        made.append(along(line, count, start))
    return made

"""Markers: where along a line its arrowheads and dots stand, and which way they point."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from tambour.core.check import Array

MOST = 5_000
"""Markers of one shape."""


def places(lines: list[tuple[Array, bool]], vertices: list[Array]) -> Iterator[tuple[str, Array, float, float]]:
    """(start, mid or end; point (2,); angle in degrees; its angle were it turned round) of each marker of a shape.

    lines : points (n, 2) and whether they are closed; vertices : indices of the points that count
    """
    spots: list[tuple[Array, Array, Array]] = []
    for (points, closed), named in zip(lines, vertices):
        line = np.concatenate([points, points[:1]]) if closed else points
        at = [*named.tolist(), *([len(line) - 1] if closed else [])]
        step = np.diff(line, axis=0)
        moves = np.hypot(*step.T) > 1e-12
        for k in at:
            before = step[:k][moves[:k]][-1:]
            after = step[k:][moves[k:]][:1]
            if closed and k in (0, at[-1]):
                before, after = step[moves][-1:], step[moves][:1]
            spots.append((line[k], before, after))
    last = len(spots) - 1
    for k, (point, before, after) in enumerate(spots[:MOST]):
        ways = [w[0] / np.hypot(*w[0]) for w in (before, after) if len(w)]
        way = sum(ways, np.zeros(2)) if ways else np.array([1.0, 0.0])
        if len(ways) == 2 and np.hypot(*way) < 1e-9:
            way = np.array([-ways[0][1], ways[0][0]])
        angle = math.degrees(math.atan2(way[1], way[0]))
        kinds = (["start"] if k == 0 else []) + (["mid"] if 0 < k < last else []) + (["end"] if k == last else [])
        for kind in kinds:
            yield kind, point, angle, angle + 180 if kind == "start" else angle

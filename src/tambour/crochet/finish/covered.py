"""Covered: fabric that nobody sees, because the open end of another part is sewn over it."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from tambour.core.check import Array

if TYPE_CHECKING:
    from tambour.core.graph import StitchGraph
    from tambour.crochet.finish.joining import Joined

ROOM = 0.5
"""How far, in radii of an end, fabric bulges into it or lies below it."""
FEW = 5
"""An end of fewer stitches covers nothing to speak of."""


def seen(graph: StitchGraph, x: Array, joined: Joined | None, shell: Array) -> Array:
    """The triangles (F, 3) of ``shell`` that are to be seen: not those which lie under an end that is sewn on all round.

    x : (N, 3), in any unit, the toy at rest; joined : how its parts were sewn on, None where none are
    """
    hidden = np.zeros(len(graph), bool)
    for pairs in () if joined is None else joined.seams:
        own = np.unique(pairs[:, 0])
        if len(own) < FEW:
            continue
        rim = x[own]  # in the order of work, which is that of the rim
        middle = rim.mean(0)
        _, _, ways = np.linalg.svd(rim - middle, full_matrices=False)
        host = graph.parts[int(graph.part[pairs[0, 1]])]
        flat = (rim - middle) @ ways[:2].T
        points = (x[host.start : host.end] - middle) @ ways.T
        radius = float(np.sqrt((flat**2).sum(1)).mean())
        near = np.abs(points[:, 2]) < ROOM * radius
        hidden[host.start : host.end] |= near & _within(flat, points[:, :2])
    return np.asarray(shell[~hidden[shell].all(1)])


def _within(ring: Array, points: Array) -> Array:
    """Which points (P, 2) lie within the polygon ``ring`` (K, 2): a ray to the right crosses it an odd number of times."""
    a, b = ring, np.roll(ring, -1, 0)
    y = points[:, 1:]
    over = (a[:, 1] > y) != (b[:, 1] > y)
    rise = np.where(a[:, 1] == b[:, 1], 1.0, b[:, 1] - a[:, 1])
    at = a[:, 0] + (y - a[:, 1]) / rise * (b[:, 0] - a[:, 0])
    return np.asarray((over & (points[:, :1] < at)).sum(1) % 2 == 1)

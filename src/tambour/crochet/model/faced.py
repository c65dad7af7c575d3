"""Faced: to which side of a model its small forms look and lie: eyes, a nose, a mouth and ears are on its face, the back of a head is smooth."""

from __future__ import annotations

from typing import Final

import numpy as np

from tambour.core.check import Array
from tambour.crochet.model.distance import spread
from tambour.geometry.motion import length
from tambour.geometry.near import nearest
from tambour.geometry.surface import vertex_normals

POINTS: Final = 6000
"""Points, even on the surface, that are looked at."""
NEAR, ABOUT = 6, 30
"""A form is small that turns the surface among so many neighbours of a point, and not as much more among so many."""
ROUND = 0.4
"""What of the turning among many neighbours is that of a round body, among few."""


def faced(vertices: Array, faces: Array) -> float:
    """How far the small forms of a surface look ahead (z), as the mean cosine, and lie ahead of its middle, as a share of its depth: above 0
    where its face is ahead, below where it is behind, about 0 of one that has none.

    >>> import numpy as np
    >>> ball = np.array([(0, 0, 1), (1, 0, 0), (0, 1, 0), (-1, 0, 0), (0, -1, 0), (0, 0, -1.0)])
    >>> sides = np.array([(0, 1, 2), (0, 2, 3), (0, 3, 4), (0, 4, 1), (5, 2, 1), (5, 3, 2), (5, 4, 3), (5, 1, 4)])
    >>> round(abs(faced(ball, sides)), 1)
    0.0
    """
    points = spread(vertices, faces, POINTS)
    normals = vertex_normals(vertices, faces)
    own = normals[nearest(points, vertices, 1)[1][:, 0]]
    about = nearest(points, points, ABOUT)[1]
    turns = length(own[about] - own[:, None])
    small = np.maximum(turns[:, :NEAR].mean(1) - ROUND * turns.mean(1), 0.0)
    whole, deep = float(small.sum()), float(np.ptp(points[:, 2]))
    if whole <= 0.0 or deep <= 0.0:
        return 0.0
    looks = float((small * own[:, 2]).sum()) / whole
    lies = (float((small * points[:, 2]).sum()) / whole - float(points[:, 2].mean())) / deep
    return looks + lies

"""Stance: how a thing comes to stand by itself, turned as little as may be."""

from __future__ import annotations

import math

import numpy as np

from tambour.core.check import Array
from tambour.geometry.motion import dot, length

FLAT = 1e-6
"""Facets whose corners lie nearer to one line than this, as a share of their size squared, bear nothing."""


def set_down(x: Array, most: float) -> Array:
    """The rotation (3, 3) that sets points x (K, 3), up +y, on the facet of their hull on which they do not tip over.

    Of several the one that turns them least, by ``most`` degrees at the most; where there is none, no rotation.
    """
    from scipy.spatial import ConvexHull

    still = np.eye(3)
    if len(x) < 4 or float(np.ptp(x, axis=0).min()) < 1e-6:
        return still
    hull = ConvexHull(x)
    normals, corners = hull.equations[:, :3], x[hull.simplices]
    under = normals[:, 1] < -math.cos(math.radians(most))
    normals, corners = normals[under], corners[under]
    # The middle falls along a facet's normal: inside its corners it is borne.
    off = corners - x.mean(0)
    held = np.ones(len(normals), bool)
    around = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    way = np.where(dot(around, normals) > 0.0, 1.0, -1.0)
    size = length(around)
    for k in range(3):
        side = dot(np.cross(off[:, k], off[:, (k + 1) % 3]), normals) * way
        held &= side > -FLAT * size
    held &= size > FLAT * np.ptp(x, axis=0).max() ** 2
    if not held.any():
        return still
    best = normals[held][int(normals[held][:, 1].argmin())]
    return _turn(best, np.array([0.0, -1.0, 0.0]))


def _turn(a: Array, b: Array) -> Array:
    """The smallest rotation (3, 3) that brings the unit vector a to b, which does not point against it."""
    k = np.cross(a, b)
    cross = np.array([[0.0, -k[2], k[1]], [k[2], 0.0, -k[0]], [-k[1], k[0], 0.0]])
    square = np.array([[float(cross[i] @ cross[:, j]) for j in range(3)] for i in range(3)])
    return np.asarray(np.eye(3) + cross + square / (1.0 + float(a @ b)))

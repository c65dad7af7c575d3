"""Stance: how a thing comes to stand by itself, turned as little as may be."""

from __future__ import annotations

import math

import numpy as np

from tambour.core.check import Array
from tambour.geometry.motion import length

FAR = 1e3
"""How far beyond a thing's size the three corners lie with which the search for its facet begins, and how far above it."""
NEAR = 1e-9
"""What counts as on a facet, as a share of the thing's size."""
RESTS = 0.04
"""What is in this lowest share of a thing's height bears it."""
HELD = 0.12
"""A soft thing whose middle is so much of its height beside what bears it does not stand."""
MOST, DEAR, FIRM = 60, 0.001, 0.08
"""By how many degrees at the most a thing is turned ahead or back to stand, what each costs, and how far within its feet
its middle ought to be, as a share of its height."""
AHEAD = 0.8
"""A face looks ahead by this cosine."""
STEPS = 500
"""Facets that are tried, and ways that it rolls, before it is left as it was."""


def set_down(x: Array, most: float) -> Array:
    """The rotation (3, 3) that sets points x (K, 3), up +y, on the facet of their hull on which they do not tip over.

    They roll from facet to facet, their middle lower each time, until it falls within the one they lie on. Where that turns
    them by more than ``most`` degrees on the way, or they are flat: no rotation.
    """
    still, down = np.eye(3), np.array([0.0, -1.0, 0.0])
    off = x - x.mean(0) if len(x) else x
    if len(x) < 4 or float(np.ptp(x, axis=0).min()) < 1e-6:
        return still
    way = down
    for _ in range(STEPS):
        facet = facet_below(off, way)
        if facet is None or float(facet @ down) < math.cos(math.radians(most)):
            return still
        if float(length(facet - way)) < NEAR:
            return _turn(facet, down)
        way = facet
    return still


def facet_below(x: Array, way: Array) -> Array | None:
    """The outward normal of the hull's facet that a ray from the origin along ``way`` meets; None where there is none.

    The simplex method on the plane that holds all points x (K, 3) on one side and is nearest along the ray: three corners
    around it, of which the one in the way leaves for the point that lies farthest beyond them.
    """
    aside = np.cross(way, np.eye(3)[int(np.abs(way).argmin())])
    aside /= length(aside)
    across = np.cross(way, aside)
    size = float(np.ptp(x, axis=0).max())
    flat = np.stack([(x * aside).sum(1), (x * across).sum(1), (x * way).sum(1)], 1)
    angles = np.arange(3) * (2.0 * math.pi / 3.0)
    begin = FAR * size * np.stack([np.cos(angles), np.sin(angles), np.full(3, -FAR)], 1)
    points = np.concatenate([flat, begin])
    corners = len(x) + np.arange(3)
    for _ in range(STEPS):
        a, b, c = points[corners]
        normal = np.cross(b - a, c - a)
        if normal[2] == 0.0:
            return None
        beyond = ((flat - a) * normal).sum(1) / normal[2]
        new = int(beyond.argmax())
        if beyond[new] <= NEAR * size:
            if corners.max() >= len(x):
                return None
            normal *= math.copysign(1.0, normal[2]) / length(normal)
            return np.asarray(normal[0] * aside + normal[1] * across + normal[2] * way)
        here, there = _weights(a, b, c, np.zeros(2)), _weights(a, b, c, points[new])
        leaving = np.where(there > 0.0, here / np.where(there > 0.0, there, 1.0), np.inf)
        corners[int(leaving.argmin())] = new
    return None


def _weights(a: Array, b: Array, c: Array, p: Array) -> Array:
    """The weights of a triangle's corners that make p of them, in the plane of the first two axes."""

    def area(p: Array, q: Array, r: Array) -> float:
        return float((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]))

    return np.array([area(p, b, c), area(a, p, c), area(a, b, p)]) / area(a, b, c)


def _turn(a: Array, b: Array) -> Array:
    """The smallest rotation (3, 3) that brings the unit vector a to b, which does not point against it."""
    k = np.cross(a, b)
    cross = np.array([[0.0, -k[2], k[1]], [k[2], 0.0, -k[0]], [-k[1], k[0], 0.0]])
    square = np.array([[float(cross[i] @ cross[:, j]) for j in range(3)] for i in range(3)])
    return np.asarray(np.eye(3) + cross + square / (1.0 + float(a @ b)))


def beside(x: Array, pitch: float, within: float = 0.0) -> float:
    """How far the middle of points x (K, 3), turned ahead by ``pitch`` radians, lies before or behind what they rest on then, as a
    share of their height; ``within`` : so far from the edge of that it ought to be, as such a share."""
    y, z = _pitched(x, pitch)
    high = max(float(np.ptp(y)), 1e-9)
    low = z[y < float(y.min()) + RESTS * high]
    middle = float(z.mean())
    return max(0.0, within + (float(low.min()) - middle) / high, within + (middle - float(low.max())) / high)


def righted(x: Array, looks: Array) -> float:
    """By how many radians points x (K, 3), up +y, front +z, are turned ahead (or back, below 0) to stand: as little as may be, with the
    face looking ahead. looks : (M, 3) the ways that a face looks; nothing is turned that stands already."""
    if beside(x, 0.0) < HELD:
        return 0.0
    best, turn = math.inf, 0.0
    for degrees in range(-MOST, MOST + 1, 3):
        pitch = math.radians(degrees)
        ahead = float(_pitched(looks, pitch)[1].mean()) if len(looks) else AHEAD
        cost = beside(x, pitch, FIRM) + max(0.0, AHEAD - ahead) + abs(degrees) * DEAR
        if cost < best - 1e-9:
            best, turn = cost, pitch
    return turn if beside(x, turn) < 0.5 * HELD else 0.0


def _pitched(x: Array, pitch: float) -> tuple[Array, Array]:
    """Heights and depths (K,) of points turned ahead."""
    c, s = math.cos(pitch), math.sin(pitch)
    return np.asarray(c * x[:, 1] - s * x[:, 2]), np.asarray(s * x[:, 1] + c * x[:, 2])

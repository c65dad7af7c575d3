"""Ways: how far along a body every point of its surface lies, for rounds to follow, and how near rings along such a way come to it."""

from __future__ import annotations

import numpy as np

from tambour.core.check import Array
from tambour.crochet.model.distance import Target, distance
from tambour.crochet.model.fronts import along, fronts, nearest_way
from tambour.crochet.model.geodesic import girth, lines
from tambour.crochet.model.whole import area
from tambour.geometry.motion import axes

LOOKS = 20
"""How many lines are looked at to see what a way is worth, and how many points of each."""
AROUND = 24
SAMPLES = 500
"""Points of each surface that rings are held against the body by."""


def between(vertices: Array, faces: Array, near: Array, far: Array) -> Array:
    """The way (V,) from one end to another, 0 at the first, its lines as far from each other, on the average, as their values.

    near, far : (V,) distances from the two ends. The lines of one alone run ahead along the inside of a bend; those of both
    together lie square to it, and close in on either end.
    """
    share = near / np.maximum(near + far, 1e-9)
    own = share[faces]
    low = own.min(1)
    wide = np.maximum(own.max(1) - low, 1e-12)
    values = np.linspace(0.0, float(own.max()), 2 * LOOKS + 1)
    size = area(vertices, faces)
    surface = np.diff([float((size * np.clip((value - low) / wide, 0.0, 1.0)).sum()) for value in values])
    found = [lines(vertices, faces, share, float(value)) for value in 0.5 * (values[1:] + values[:-1])]
    girths = np.array([sum(girth(line) for line in every) for every in found])
    return np.interp(share, values, np.concatenate([[0.0], np.cumsum(surface / np.maximum(girths, 1e-9))]))


def ringed(surface: Target, f: Array, tip: int) -> tuple[float, float]:
    """How far, on the average, rings along the way ``f`` (V,) from vertex ``tip`` lie from the surface, each as long as its line and
    a true circle, as stuffing makes them; and the share of all lines that no ring follows."""
    way = fronts(surface.vertices, surface.faces, f, LOOKS, tip)
    points, before = [way.tip[None]], None
    for line in way.lines:
        own = along(line, AROUND, 0.0 if before is None else nearest_way(line, before))
        before = own[0]
        points.append(_circle(own, girth(line)))
    points.append(way.end[None])
    first = 1 + AROUND * np.arange(len(way.lines))[:, None]
    a, b = first + np.arange(AROUND), first + (np.arange(AROUND) + 1) % AROUND
    start, end = np.zeros(AROUND, int), np.full(AROUND, 1 + AROUND * len(way.lines))
    threes = [(start, a[0], b[0]), (a[-1], end, b[-1]), (a[:-1], a[1:], b[1:]), (a[:-1], b[1:], b[:-1])]
    faces = np.concatenate([np.column_stack([corner.ravel() for corner in three]) for three in threes])
    x, still = np.concatenate(points), (np.eye(3), np.zeros(3))
    return distance(surface, x, faces, still, samples=SAMPLES, moves=False).mean, way.lost


def _circle(line: Array, size: float) -> Array:
    """The circle ``size`` round in the plane that points of a closed line (K, 3) lie nearest to, as near to them as it can lie."""
    middle = line.mean(0)
    plane = axes(line)[1][:2]
    at = ((line - middle) * plane[0]).sum(1) + 1j * ((line - middle) * plane[1]).sum(1)
    way = 1.0 if (at.conj() * np.roll(at, -1)).imag.sum() >= 0.0 else -1.0
    turn = np.exp(2j * np.pi * way * np.arange(len(line)) / len(line))
    start = (at * turn.conj()).sum()
    ring = size / (2.0 * np.pi) * turn * (start / max(abs(start), 1e-12))
    return np.asarray(middle + ring.real[:, None] * plane[0] + ring.imag[:, None] * plane[1])

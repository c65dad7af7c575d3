"""Splines through polylines, and polylines with fewer points."""

from __future__ import annotations

import math

import numpy as np

from tambour.core.arrays import B1x1, F8x2, I8x1
from tambour.core.check import Array
from tambour.core.kernels import kernel
from tambour.core.threads import share
from tambour.crochet.yarn.points import BLOCK


@kernel
def _root(coords: Array, i: int) -> float:
    """The root of the distance between a point and the next."""
    size = 0.0
    for c in range(3):
        step = coords[i + 1, c] - coords[i, c]
        size += step * step
    return max(math.sqrt(math.sqrt(size)), 1e-9)


@kernel
def _smoothed(coords: F8x2, offsets: I8x1, places: I8x1, times: int, begin: int, end: int, out: F8x2) -> None:
    """Those of points ``begin`` to ``end``; places : (S,) where each polyline's begin in ``out``."""
    for s in range(len(offsets) - 1):
        first, last = offsets[s], offsets[s + 1] - 1
        low, high = max(first, begin), min(last, end)
        size = _root(coords, low) if low < high else 0.0
        before = _root(coords, low - 1) if first < low < high else size
        at = places[s] + (low - first) * times
        for i in range(low, high):
            after = _root(coords, i + 1) if i + 2 <= last else size
            for c in range(3):
                b, d = coords[i, c], coords[i + 1, c]
                a = coords[i - 1, c] if i > first else 2 * b - d
                e = coords[i + 2, c] if i + 1 < last else 2 * d - b
                p = d - b + size * ((b - a) / before - (d - a) / (before + size))
                q = d - b + size * ((e - d) / after - (e - b) / (size + after))
                for k in range(times):
                    t = k / times
                    r = t * t
                    u = r * (3.0 - 2.0 * t)
                    out[at + k, c] = b + (d - b) * u + (t - r) * ((1.0 - t) * p - t * q)
            at += times
            before, size = size, after
        if last >= first and begin <= last < end:
            out[places[s] + (last - first) * times] = coords[last]


def smooth(coords: Array, offsets: Array, times: int, out: Array) -> None:
    """Splines through polylines: every segment in ``times`` pieces; out (sum of (n - 1) times + 1, 3).

    Catmull-Rom's, with knots as far apart as the roots of the distances: where points lie unevenly the others overshoot.
    P. J. Barry, R. N. Goldman (1988); C. Yuksel, S. Schaefer, J. Keyser, "Parameterization and applications of
    Catmull-Rom curves" (2011).
    """
    many = np.diff(offsets)
    places = np.concatenate([[0], np.cumsum(np.where(many > 0, (many - 1) * times + 1, 0))])
    share(len(coords), BLOCK, lambda a, b: _smoothed(coords, offsets, places, times, a, b, out))


@kernel
def thin(coords: F8x2, offsets: I8x1, tolerance: float, keep: B1x1) -> None:
    """Mark in ``keep`` (P,) the points of polylines without which they would stray by more than ``tolerance``.

    Walks along: a point may go while the straight line over all that went stays near them; at most five in a row go.
    """
    for s in range(len(offsets) - 1):
        first, last = offsets[s], offsets[s + 1] - 1
        if last < first:
            continue
        keep[first] = keep[last] = True
        a = first
        i = first + 1
        while i < last:
            b = i + 1
            far = 0.0
            dx, dy, dz = coords[b, 0] - coords[a, 0], coords[b, 1] - coords[a, 1], coords[b, 2] - coords[a, 2]
            size = dx * dx + dy * dy + dz * dz + 1e-18
            for k in range(a + 1, b):
                px, py, pz = coords[k, 0] - coords[a, 0], coords[k, 1] - coords[a, 1], coords[k, 2] - coords[a, 2]
                t = (px * dx + py * dy + pz * dz) / size
                px, py, pz = px - t * dx, py - t * dy, pz - t * dz
                far = max(far, px * px + py * py + pz * pz)
            if far > tolerance * tolerance or b - a > 6:
                keep[i] = True
                a = i
            i += 1

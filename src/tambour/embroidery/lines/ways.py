"""Ways from one place of an area to another that never leave it: straight, through its rows, or round its outline."""

from __future__ import annotations

import numpy as np

from tambour.core.check import Array
from tambour.embroidery.lines.corridor import find, holds, leaves, neighbours, straighten
from tambour.embroidery.lines.fill import Rings, along_ring, crossings, inside_pairs, levels


def way(area: Rings, a: Array, b: Array) -> Array:
    """Polyline (n, 2) from ``a`` to ``b`` inside ``area`` (rings at angle 0), both ends included.

    Straight where that stays inside; else the short way through a net of rows about 1 mm apart (finer in small
    areas); else round the outline. ``a`` and ``b`` may lie on the outline, or a little outside.
    """
    straight = np.array([a, b], np.float64)
    if (
        not len(area.points)
        or np.hypot(*(straight[1] - straight[0])) < 0.1
        or not leaves(area.points, area.offsets, straight, 0.05)
    ):
        return straight
    v = area.points[:, 1]
    tall = float(v.max() - v.min())
    for pitch in (max(min(1.0, tall / 20), tall / 2000), max(min(0.25, tall / 60), tall / 4000)):
        line = _through(area, straight[0], straight[1], pitch)
        if line is not None:
            return line
    return round_outline(area, straight[0], straight[1])


def _through(area: Rings, a: Array, b: Array, pitch: float) -> Array | None:
    v = area.points[:, 1]
    at = levels(float(v.min()), float(v.max()), pitch)
    starts, u, _, sign = crossings(area.points, area.offsets, at)
    row, first, last = inside_pairs(starts, sign, True)
    if not len(row):
        return None
    lo, hi = u[first], u[last]
    ends = []
    for p in (a, b):
        away = np.hypot(np.maximum(0, np.maximum(lo - p[0], p[0] - hi)), at[row] - p[1])
        ends.append(int(np.argmin(away)))
    margin = min(0.4, pitch)
    ua, ub = (
        float(np.clip(p[0], min(lo[s] + margin, (lo[s] + hi[s]) / 2), max(hi[s] - margin, (lo[s] + hi[s]) / 2)))
        for p, s in zip((a, b), ends)
    )
    if ends[0] == ends[1]:
        line = np.array([[ua, at[row[ends[0]]]], [ub, at[row[ends[0]]]]])
    else:
        offsets, near = neighbours(row, lo, hi)
        rank = np.zeros(len(row), np.int64)
        path, _ = find(offsets, near, row, at, lo, hi, rank, -1, ends[0], ua, ends[1], ub, margin, 1.0, np.inf)
        if not len(path):
            return None
        line = straighten(path, row, at, lo, hi, ua, ub, margin)
    line = np.concatenate([a[None], line, b[None]])
    # Corners that are not needed go, first from the ends inwards.
    k = 0
    while k + 2 < len(line):
        if leaves(area.points, area.offsets, line[[k, k + 2]], 0.05):
            k += 1
        else:
            line = np.delete(line, k + 1, axis=0)
    return None if leaves(area.points, area.offsets, line, 0.05) else line


def nearest_on_outline(area: Rings, p: Array) -> tuple[int, float, Array]:
    """(ring, way along the outlines, point) nearest to ``p``."""
    a = area.points
    step = np.arange(len(a)) + 1
    step[area.offsets[1:] - 1] = area.offsets[:-1]
    d = a[step] - a
    f = np.clip(((p - a) * d).sum(1) / np.maximum((d * d).sum(1), 1e-300), 0, 1)
    q = a + f[:, None] * d
    k = int(np.argmin(((q - p) ** 2).sum(1)))
    ring = int(np.searchsorted(area.offsets, k, side="right") - 1)
    return ring, float(area.at[k] + f[k] * np.hypot(*d[k])), q[k]


def round_outline(area: Rings, a: Array, b: Array) -> Array:
    """From ``a`` to the outline, along it, and to ``b``; straight when they are nearest to different rings."""
    ring, begin, p = nearest_on_outline(area, a)
    other, end, q = nearest_on_outline(area, b)
    if ring != other:
        return np.array([a, p, q, b])
    perimeter = float(area.base[ring + 1] - area.base[ring])
    signed = end - begin
    signed -= perimeter * round(signed / perimeter)
    line = along_ring(area.points, area.at, area.offsets, area.base, ring, begin, signed, p, q)
    return np.concatenate([a[None], line, b[None]])


def inside(area: Rings, p: Array) -> bool:
    """Whether ``p`` lies in the area."""
    return bool(holds(area.points, area.offsets, float(p[0]), float(p[1])))

"""Chords: the column across one limb of an area: its middle line led past forks and out to the outline, and chords cast from it."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from tambour.core.check import Array
from tambour.embroidery.columns.cut import flush
from tambour.embroidery.columns.satin import Column

REACH = 1.25  # radii of a fork on both sides of it in which it bends the limb that goes through


def passed(
    line: Array, wide: Array, forks: list[tuple[Array, float]], free: tuple[bool, bool] = (False, False)
) -> tuple[Array, Array]:
    """A limb's middle line and half widths (n,) past the forks (place, radius) that it goes through: as if none were there.

    Where a bar meets a stem the middle line leans towards the bar, and its stitches would fan out and leave nicks; it is led on
    from before the fork to behind it by its directions there (a cubic), as wide as it is there; straight on to an end that is
    free and too near for that.
    """
    for fork, radius in forks:
        way = np.r_[0, np.cumsum(np.hypot(*np.diff(line, axis=0).T))]
        middle = float(way[int(((line - fork) ** 2).sum(1).argmin())])
        a, b = middle - REACH * radius, middle + REACH * radius
        if a < 0.3 * radius or b > way[-1] - 0.3 * radius:
            if a < 0.3 * radius and free[0] and b < way[-1] - 0.3 * radius:
                line, wide = _led(line, wide, way, b, radius)
            elif b > way[-1] - 0.3 * radius and free[1] and a > 0.3 * radius:
                back = _led(line[::-1], wide[::-1], way[-1] - way[::-1], float(way[-1] - a), radius)
                line, wide = back[0][::-1], back[1][::-1]
            continue
        at = [
            np.array([np.interp(v, way, line[:, i]) for i in (0, 1)])
            for v in (a - 0.3 * radius, a, b, b + 0.3 * radius)
        ]
        d0, d1 = (at[1] - at[0], at[3] - at[2])
        d0, d1 = (d / max(1e-9, float(np.hypot(*d))) for d in (d0, d1))
        if d0 @ d1 < 0.8:
            continue  # a stroke that turns there
        t = np.linspace(0, 1, max(4, math.ceil((b - a) / 0.2)))[:, None]
        size = float(np.hypot(*(at[2] - at[1])))
        curve = (
            (2 * t**3 - 3 * t**2 + 1) * at[1]
            + (t**3 - 2 * t**2 + t) * size * d0
            + (3 * t**2 - 2 * t**3) * at[2]
            + (t**3 - t**2) * size * d1
        )
        half = np.interp([a, b], way, wide)
        between = (
            half[0] + (half[1] - half[0]) * t[:, 0]
        ) * 0.82  # chords reach 1.25 of it: to the stroke's edge, not into the bar
        low, high = way < a, way > b
        line = np.concatenate([line[low], curve, line[high]])
        wide = np.r_[wide[low], between, wide[high]]
    return line, wide


def _led(line: Array, wide: Array, way: Array, past: float, radius: float) -> tuple[Array, Array]:
    """A limb's middle line and half widths, straight from so far along it (mm) back to its beginning."""
    at = [np.array([np.interp(v, way, line[:, i]) for i in (0, 1)]) for v in (past, past + 0.5 * radius)]
    d = at[0] - at[1]
    d = d / max(1e-9, float(np.hypot(*d)))
    far = float(np.interp(past, way, wide))
    begin = at[0] + np.linspace(past, 0, max(3, math.ceil(past / 0.2)))[:-1, None] * d
    keep = way > past
    return np.concatenate([begin, at[0][None], line[keep]]), np.r_[np.full(len(begin) + 1, 0.9 * far), wide[keep]]


def across(
    area: Any,
    line: Array,
    wide: Array,
    free: tuple[bool, bool],
    closed: bool,
    forks: tuple[tuple[float, float], tuple[float, float]],
) -> Column | None:
    """The column across one limb: its middle line smoothed, run out to the outline at free ends and straight into
    forks (whose radii are given, and how far beyond them) at the others; then chords are cast."""
    import shapely

    step = np.hypot(*np.diff(line, axis=0).T)
    size = float(step.sum())
    half = float(np.median(wide))
    if size + (free[0] + free[1]) * half < 0.8 * half:
        return None
    way = np.r_[0, np.cumsum(step)]
    n = max(4, math.ceil(size / 0.2))
    at = np.linspace(0, size, n)
    p = np.c_[np.interp(at, way, line[:, 0]), np.interp(at, way, line[:, 1])]
    r = np.interp(at, way, wide)
    reach = max(1, round(0.8 * half / max(size / (n - 1), 1e-9)))
    p = _smoothed(p, min(reach, max(1, n // 4)), closed)
    if not closed:
        for last in (False, True):
            p, r = (p, r) if last else (p[::-1], r[::-1])
            p, r = _run_out(area, p, r, half) if free[last] else _into_fork(p, r, *forks[last])
            p, r = (p, r) if last else (p[::-1], r[::-1])
    if len(p) < 3:
        return None
    d = np.gradient(p, axis=0)
    if closed:
        d[0] = d[-1] = p[1] - p[-2]
    heading = np.unwrap(np.arctan2(d[:, 1], d[:, 0]))
    k = min(reach, max(1, len(p) // 4))
    heading = _smoothed(np.c_[heading, heading], k, False)[:, 0] if not closed else heading
    normal = np.c_[-np.sin(heading), np.cos(heading)]
    limit = np.maximum(1.25 * r, 0.3)[:, None]
    limit = np.minimum(limit, 1.5 * half)
    chords = shapely.linestrings(np.stack([p - limit * normal, p + limit * normal], 1))
    left, right = p.copy(), p.copy()
    cut = shapely.intersection(chords, area)
    for i, piece in enumerate(cut):
        parts = [q for q in shapely.get_parts(piece) if q.geom_type == "LineString" and not q.is_empty]
        if not parts:
            continue
        best = parts[int(np.argmin([shapely.distance(q, shapely.points(p[i])) for q in parts]))]
        ends = np.asarray(shapely.get_coordinates(best))[[0, -1]]
        side = (ends - p[i]) @ normal[i]
        right[i], left[i] = ends[np.argmin(side)], ends[np.argmax(side)]
    column = Column(left, right)
    for last in (True, False) if not closed else ():
        if free[last]:
            turned = column if last else column.reversed()
            turned = flush(turned, area, half)
            column = turned if last else turned.reversed()
    return column


def _smoothed(p: Array, reach: int, closed: bool) -> Array:
    window = np.hanning(2 * reach + 3)[1:-1]
    window /= window.sum()
    if closed:
        padded = np.concatenate([p[-reach - 1 : -1], p, p[1 : reach + 1]])
    else:
        # Mirrored through the ends, so that they stay where they are.
        padded = np.concatenate([2 * p[0] - p[reach:0:-1], p, 2 * p[-1] - p[-2 : -reach - 2 : -1]])
    return np.c_[np.convolve(padded[:, 0], window, "valid"), np.convolve(padded[:, 1], window, "valid")]


def _into_fork(p: Array, r: Array, fork: float, beyond: float) -> tuple[Array, Array]:
    """The line cut where the fork begins to bend it, and carried on straight to so far beyond the fork's middle."""
    away = np.hypot(*(p - p[-1]).T)
    keep = away > 0.9 * fork
    if keep.sum() < 4:
        return p, r
    last = int(np.flatnonzero(keep)[-1])
    back = max(0, last - max(2, round(fork / 0.2)))
    d = p[last] - p[back]
    d = d / max(float(np.hypot(*d)), 1e-9)
    size = 0.9 * fork + beyond
    n = max(1, math.ceil(size / 0.2))
    more = p[last] + np.linspace(0, size, n + 1)[1:, None] * d
    return np.concatenate([p[: last + 1], more]), np.r_[r[: last + 1], np.full(n, r[last])]


def _run_out(area: Any, p: Array, r: Array, half: float) -> tuple[Array, Array]:
    """The line carried on in its last direction until it meets the outline."""
    import shapely

    back = min(len(p) - 1, max(2, round(half / 0.2)))
    d = p[-1] - p[-1 - back]
    size = float(np.hypot(*d))
    if size < 1e-9:
        return p, r
    d = d / size
    ray = shapely.intersection(shapely.linestrings([p[-1], p[-1] + 4 * max(float(r[-1]), half) * d]), area)
    parts = [q for q in shapely.get_parts(ray) if q.geom_type == "LineString" and not q.is_empty]
    if not parts:
        return p, r
    first = min(parts, key=lambda q: shapely.distance(q, shapely.points(p[-1])))
    far = float(np.hypot(*(shapely.get_coordinates(first) - p[-1]).T).max())
    n = max(1, math.ceil(far / 0.2))
    more = p[-1] + np.linspace(0, far - 0.02, n + 1)[1:, None] * d if far > 0.05 else np.zeros((0, 2))
    return np.concatenate([p, more]), np.r_[r, np.full(len(more), max(float(r[-1]), 0.5 * half))]

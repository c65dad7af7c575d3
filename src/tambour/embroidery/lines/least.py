"""Least: stitches too short for thread joined with their neighbours, wherever what takes their place stays inside."""

from __future__ import annotations

import math

import numpy as np

from tambour.core.arrays import B1x1, F8x2, I8x1
from tambour.core.kernels import kernel
from tambour.embroidery.lines.corridor import holds
from tambour.embroidery.lines.fill import Rings
from tambour.embroidery.piece import TRAVEL
from tambour.embroidery.stitches import Stitches

SLACK = 0.05  # mm that thread may move, and that a joined stitch may leave its area
WELCOME_FAR = 0.12  # mm that a place may move for that
WELCOME = 4 / 3  # times the least stitch: so long they should be where the thread's shape allows it


@kernel
def beside(xy: F8x2, k: int, a: int, b: int) -> tuple[float, float]:
    """How far the point ``k`` lies beside the stitch from point ``a`` to ``b``, and how long that is."""
    qx, qy = xy[b, 0] - xy[a, 0], xy[b, 1] - xy[a, 1]
    x, y = xy[k, 0] - xy[a, 0], xy[k, 1] - xy[a, 1]
    span = qx * qx + qy * qy
    f = 0.0 if span == 0 else min(1.0, max(0.0, (x * qx + y * qy) / span))
    return math.hypot(x - f * qx, y - f * qy), math.sqrt(span)


@kernel
def strays(points: F8x2, offsets: I8x1, px: float, py: float, qx: float, qy: float, slack: float) -> bool:
    """Whether the stitch from p to q is anywhere more than ``slack`` mm outside the rings (seen each 0.04 mm); never for no rings."""
    if not len(points):
        return False
    n = max(2, math.ceil(math.hypot(qx - px, qy - py) / 0.04))
    for k in range(n + 1):
        x, y = px + (qx - px) * k / n, py + (qy - py) * k / n
        if holds(points, offsets, x, y):
            continue
        near = np.inf
        for r in range(len(offsets) - 1):
            b = offsets[r + 1] - 1
            for a in range(offsets[r], offsets[r + 1]):
                dx, dy = points[a, 0] - points[b, 0], points[a, 1] - points[b, 1]
                ex, ey = x - points[b, 0], y - points[b, 1]
                span = dx * dx + dy * dy
                f = 0.0 if span == 0 else min(1.0, max(0.0, (ex * dx + ey * dy) / span))
                near = min(near, (ex - f * dx) ** 2 + (ey - f * dy) ** 2)
                b = a
        if near > slack * slack:
            return True
    return False


@kernel
def drop_short(xy: F8x2, least: float, slack: float) -> B1x1:
    """Which needle points stay when stitches shorter than ``least`` are joined with the next: (n,) bool.

    A point goes only when it lies within ``slack`` of the stitch that takes its place, so that outlines keep their
    shape, and when that stitch is no longer than the longest there was; the first and the last stay.
    """
    n = len(xy)
    most = 0.0
    for i in range(n - 1):
        most = max(most, math.hypot(xy[i + 1, 0] - xy[i, 0], xy[i + 1, 1] - xy[i, 1]))
    keep = np.ones(n, np.bool_)
    p, before = 0, -1  # the last point kept, and the one before it
    for i in range(1, n - 1):
        if math.hypot(xy[i, 0] - xy[p, 0], xy[i, 1] - xy[p, 1]) < least:
            off, span = beside(xy, i, p, i + 1)
            other, wide = (np.inf, np.inf) if before < 0 else beside(xy, p, before, i)
            if off <= slack and span <= most + 1e-9 and (off <= other or wide > most + 1e-9):
                keep[i] = False
                continue
            if other <= slack and wide <= most + 1e-9:
                keep[p] = False
                p = i
                continue
        before, p = p, i
    return keep


@kernel
def merge_short(
    xy: F8x2, ways: B1x1, least: float, far: float, points: F8x2, offsets: I8x1, slack: float
) -> tuple[F8x2, B1x1]:
    """Needle points, and which of them stay, so that no stitch is shorter than ``least``: ((n, 2), (n,) bool).

    Of the two ends of a short stitch the second goes, or the first, or one place between takes both, as long as no stitch of
    these leaves the rings by more than ``slack`` or is longer than the longest there was (a way, by ``SLACK``), and no point
    that goes lies farther than ``far`` beside what takes its place. Where a row meets a way (``ways``: points between two
    stitches of travel) the way's point goes rather than the row's end, for a row that ends aslant leaves a slit beside it. What
    nothing helps stays short.
    """
    xy = xy.copy()
    n = len(xy)
    most = 0.0
    for i in range(n - 1):
        most = max(most, math.hypot(xy[i + 1, 0] - xy[i, 0], xy[i + 1, 1] - xy[i, 1]))
    keep = np.ones(n, np.bool_)
    p, before = 0, -1
    for i in range(1, n):
        if math.hypot(xy[i, 0] - xy[p, 0], xy[i, 1] - xy[p, 1]) < least:
            off, span = beside(xy, i, p, i + 1) if i + 1 < n else (np.inf, np.inf)
            other, wide = (np.inf, np.inf) if before < 0 else beside(xy, p, before, i)
            second = off <= far and span <= most + (SLACK if ways[i] else 1e-9)
            first = other <= far and wide <= most + (SLACK if ways[p] else 1e-9)
            if second:
                second = not strays(points, offsets, xy[p, 0], xy[p, 1], xy[i + 1, 0], xy[i + 1, 1], slack)
            if first:
                first = not strays(points, offsets, xy[before, 0], xy[before, 1], xy[i, 0], xy[i, 1], slack)
            near = off <= other if ways[p] == ways[i] else ways[i]
            if second and (near or not first):
                keep[i] = False
                continue
            if first:
                keep[p] = False
                p = i
                continue
            merged = False
            for quarter in (2, 1, 3):
                if merged or before < 0 or i + 1 >= n or not len(points) or far < least:
                    break
                x = xy[p, 0] + (xy[i, 0] - xy[p, 0]) * quarter / 4
                y = xy[p, 1] + (xy[i, 1] - xy[p, 1]) * quarter / 4
                one = math.hypot(x - xy[before, 0], y - xy[before, 1])
                two = math.hypot(x - xy[i + 1, 0], y - xy[i + 1, 1])
                good = least <= one <= most + 1e-9 and least <= two <= most + 1e-9
                good = good and not strays(points, offsets, xy[before, 0], xy[before, 1], x, y, slack)
                if good and not strays(points, offsets, x, y, xy[i + 1, 0], xy[i + 1, 1], slack):
                    xy[p, 0], xy[p, 1] = x, y
                    merged = True
            if merged:
                keep[i] = False
                continue
        before, p = p, i
    return xy, keep


def tidy(stitches: Stitches, least: float, area: Rings | None = None) -> Stitches:
    """Without stitches shorter than ``least`` mm, but for those that only thread outside ``area`` could replace.

    First go those, a third longer too, that the thread does not need for its shape. The first and the last point stay.
    """
    if least <= 0 or len(stitches) < 3:
        return stitches
    keep = drop_short(stitches.xy, WELCOME * least, SLACK)
    xy, kind, run = stitches.xy[keep], stitches.kind[keep], stitches.run[keep]
    none = (np.zeros((0, 2)), np.zeros(1, np.int64))
    points, offsets = none if area is None else (area.points, area.offsets)
    for short, far, heed in ((WELCOME * least, WELCOME_FAR, False), (least, math.inf, True)):
        travel = (kind == TRAVEL) & heed
        ways = travel & np.r_[travel[1:], heed]
        xy, keep = merge_short(xy, ways, short, far, points, offsets, 0.8 * SLACK)
        xy, kind, run = xy[keep], kind[keep], run[keep]
    return Stitches(xy, kind, run, stitches.facts)

"""Embroidery: yarn led over the fabric from hole to hole, and knots."""

from __future__ import annotations

from math import pi

import numpy as np

from tambour.core.check import Array
from tambour.crochet.finish.eyes import across
from tambour.crochet.finish.ground import Ground
from tambour.geometry.motion import length

SOFT = 0.55
"""Radius, as a share of its own, with which a stitch lifts those that are laid over it: yarn gives way."""
LONGEST = 200
"""Points of one stitch, about; a longer one has them further apart."""
INSIDE, ONWARD = 2.4, 0.5
"""How deep, in radii under the fabric's top, a stitch's ends are drawn in; and where the next one goes on the same way: deeper, a thin
line is crumbs."""


def line(ground: Ground, points: Array, width: float) -> list[Array]:
    """The centre lines of stitches from each of ``points`` (K, 3) to the next."""
    way = np.diff(points, axis=0)
    way /= np.maximum(length(way)[:, None], 1e-12)
    deep = np.where((way[1:] * way[:-1]).sum(1) > 0.3, ONWARD, INSIDE)
    deep = np.concatenate([[INSIDE], deep, [INSIDE]])
    return [
        stitch(ground, points[k], points[k + 1], width, (float(deep[k]), float(deep[k + 1])))
        for k in range(len(points) - 1)
    ]


def stitch(
    ground: Ground, start: Array, end: Array, width: float, inside: tuple[float, float] = (INSIDE, INSIDE)
) -> Array:
    """The centre line (P, 3) of a straight stitch in yarn ``width`` mm thick between two places of the fabric.

    It lies on the highest yarn beneath it as a string that is drawn tight, and goes down through the fabric at both ends,
    ``inside`` radii deep.
    """
    radius = width / 2
    far = float(np.sqrt(((end - start) ** 2).sum()))
    step = max(min(0.35 * width, 0.25 * ground.stitch), far / LONGEST)
    base, normal = ground.line(np.stack([start, end]), step)
    along = np.concatenate([[0.0], np.cumsum(np.sqrt((np.diff(base, axis=0) ** 2).sum(1)))])
    high = supported(ground, base, normal, radius)
    # Tight, but not a wire: it gives a little towards what is beneath it between two heights.
    line = 0.6 * hull(along, high) + 0.4 * high
    for _ in range(3):
        line[1:-1] = 0.25 * line[:-2] + 0.5 * line[1:-1] + 0.25 * line[2:]
        line = np.maximum(line, high)
    bend = min(1.4 * radius, along[-1] / 3)
    for deep, near in zip(inside, (along, along[-1] - along)):
        line = line - deep * radius * np.maximum(0.0, 1.0 - near / max(bend, 1e-9)) ** 2
    return np.asarray(base + (line + 0.82 * radius)[:, None] * normal)


def supported(ground: Ground, base: Array, normal: Array, radius: float) -> Array:
    """Heights (P,) over ``base`` on which yarn of a radius rests: the highest beneath half its width."""
    forward = np.gradient(base, axis=0)
    side = np.cross(normal, forward)
    side *= 0.5 * radius / np.maximum(length(side)[:, None], 1e-12)
    return np.max([ground.top(base + k * side, normal) for k in (-1.0, 0.0, 1.0)], axis=0)


def hull(along: Array, high: Array) -> Array:
    """The string drawn tight over heights (P,) at ``along`` (P,): their upper convex hull, at each of them."""
    kept: list[int] = []
    for i in range(len(along)):
        while len(kept) > 1:
            a, b = kept[-2], kept[-1]
            if (high[b] - high[a]) * (along[i] - along[a]) > (high[i] - high[a]) * (along[b] - along[a]):
                break
            kept.pop()
        kept.append(i)
    return np.asarray(np.interp(along, along[kept], high[kept]))


def knot(ground: Ground, point: Array, normal: Array, width: float) -> Array:
    """The centre line (P, 3) of a knot, a dot about twice as wide as its yarn: twice around, then down its middle."""
    radius = width / 2
    flat = across(normal)
    turn = np.linspace(0, 4.4 * pi, 45)
    beneath = point + 0.8 * radius * (np.cos(turn)[:, None] * flat[0] + np.sin(turn)[:, None] * flat[1])
    floor = float(np.quantile(ground.top(beneath, np.repeat(normal[None], len(turn), 0)), 0.5))
    t = turn / turn[-1]
    wide = radius * (0.95 - 0.2 * t)
    rise = floor + radius * (0.45 + 1.25 * t)
    # Its end goes over the coil and down its middle.
    over = np.linspace(0, 1, 9)[1:]
    wide = np.concatenate([wide, wide[-1] * (1 - over)])
    rise = np.concatenate([rise, rise[-1] + radius * (0.5 * np.sin(pi * over) - 2.2 * over**3)])
    turn = np.concatenate([turn, turn[-1] + 1.2 * over])
    ring = np.cos(turn)[:, None] * flat[0] + np.sin(turn)[:, None] * flat[1]
    return np.asarray(point + wide[:, None] * ring + rise[:, None] * normal)


def needed(points: Array, width: float) -> float:
    """Yarn, mm, for stitches from hole to hole (K, 3): over the fabric, and as far behind it; a knot's wraps.

    The ends that are hidden inside are not counted here.
    """
    if len(points) == 1:
        return 2.4 * 2 * pi * width
    return 2 * float(np.sqrt((np.diff(points, axis=0) ** 2).sum(1)).sum())

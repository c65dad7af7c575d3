"""Hair: strands of yarn, folded in half and knotted in along a line, that hang over the fabric."""

from __future__ import annotations

from itertools import pairwise
from math import pi

import numpy as np

from tambour.core.check import Array
from tambour.core.paths import Paths
from tambour.core.strands import Strands
from tambour.crochet.clearance import clear
from tambour.crochet.finish import Hair
from tambour.crochet.ground import Ground, unit
from tambour.noise import stream

FALL = 0.2
"""How much of its way a strand turns towards the ground over one diameter of its yarn: yarn is limp."""
SPREAD = 0.12
"""Largest angle by which a strand lies beside the way it is combed, radians."""
LONGEST = 160
"""Points of a strand; longer ones take longer steps."""


def roots(ground: Ground, points: Array, count: int, thick: float) -> tuple[Array, Array]:
    """Places (count, 3) where strands are knotted in, and the line's direction there (count, 3): evenly from the first
    to the last of the spots (K, 3); about a single spot in a sunflower, as close as yarn ``thick`` mm lets them."""
    if len(points) == 1:
        k = np.arange(count) + 0.5
        angle = pi * (3 - 5**0.5) * k
        base, normal, _ = ground.foot(points)
        helper = np.array([1.0, 0.0, 0.0]) if abs(normal[0, 0]) < 0.9 else np.array([0.0, 0.0, 1.0])
        right = unit(np.cross(helper[None], normal))[0]
        rays = np.cos(angle)[:, None] * right + np.sin(angle)[:, None] * np.cross(normal[0], right)
        places, normals = ground.walk(base[0], rays, (0.8 * thick * np.sqrt(k))[:, None])
        return places[:, 0], np.cross(normals[:, 0], rays)
    line, normals = ground.line(points, 0.25 * ground.stitch)
    along = np.concatenate([[0.0], np.cumsum(np.sqrt((np.diff(line, axis=0) ** 2).sum(1)))])
    at = np.linspace(0, along[-1], count) if count > 1 else np.array([along[-1] / 2])
    places = np.column_stack([np.interp(at, along, line[:, c]) for c in range(3)])
    forward = unit(np.gradient(line, axis=0))
    return places, unit(np.column_stack([np.interp(at, along, forward[:, c]) for c in range(3)]))


def hair(ground: Ground, records: list[tuple[Hair, Array]], thick: float, eyes: Array) -> tuple[Strands, Array]:
    """All strands, and their knots: two ends of ``length`` mm for every strand.

    records : what is asked for and its spots (K, 3); thick : diameter of the yarn as drawn, mm
    eyes : (E, 4) balls that hair falls over

    Returns the strands (knots among them) and, per strand, the record it is of, those of knots -1 - record.
    """
    lines: list[Array] = []
    of: list[int] = []
    for number, (record, points) in enumerate(records):
        places, forward = roots(ground, points, record.count, thick)
        base, normal, _ = ground.foot(places)
        rows = ground.top(base, normal)
        high = np.where(rows > 0, np.minimum(rows, ground.lift), ground.lift)
        side = np.cross(forward, normal)
        for k in range(record.count):
            lines.append(_loop(base[k] + high[k] * normal[k], normal[k], forward[k], side[k], thick))
            of.append(-1 - number)
        start = base + (high + 0.6 * thick)[:, None] * normal
        made = _comb(ground, record, number, start, normal, forward, side, thick, eyes)
        lines += made
        of += [number] * len(made)
    lines = _apart(ground, lines, np.array(of), thick, eyes)
    paths = Paths.of(lines, 3)
    color = np.array([records[k if k >= 0 else -1 - k][0].color for k in of], np.uint8).reshape(-1, 3)
    return Strands(paths, np.full(len(paths.coords), thick / 2), color), np.array(of)


def _loop(middle: Array, normal: Array, forward: Array, side: Array, thick: float) -> Array:
    """The fold of a strand, drawn tight about its two ends: an arch across the line."""
    t = np.linspace(-0.15 * pi, 1.15 * pi, 15)
    return np.asarray(
        middle
        + thick * (0.95 * np.cos(t)[:, None] * forward + (0.95 * np.sin(t) - 0.1)[:, None] * normal)
        + 0.1 * thick * side
    )


def _comb(
    ground: Ground, record: Hair, number: int, start: Array, normal: Array, forward: Array, side: Array, thick: float,
    eyes: Array,
) -> list[Array]:  # fmt: skip
    """Both ends of every strand (2 count) as they fall: step by step, limp, and outside the fabric."""
    count = len(start)
    draw = stream("hair", number, count).random((2 * count, 4)) - 0.5
    down = np.array([0.0, -1.0, 0.0])
    slope = down + normal[:, 1:2] * normal
    steep = np.linalg.norm(slope, axis=1, keepdims=True)
    # On a slope hair is combed down it; where it is level, the two ends go to either side of the line.
    level = np.maximum(0.0, 1.0 - steep / 0.35)
    position = np.repeat(start, 2, 0)
    end = np.tile([1.0, -1.0], count)[:, None]
    position = position + 0.45 * thick * end * np.repeat(forward, 2, 0)
    heading = np.repeat(unit(slope) * (1 - level), 2, 0) + np.repeat(level * side, 2, 0) * end
    heading = unit(unit(heading) + 0.35 * np.repeat(normal, 2, 0))
    turned = 2 * SPREAD * draw[:, :1]
    heading = unit(heading * np.cos(turned) + np.cross(np.repeat(normal, 2, 0), heading) * np.sin(turned))
    length = record.length * (1 + 0.1 * (draw[:, 1] - 0.5))
    steps = int(np.clip(np.ceil(record.length / (0.55 * thick)), 4, LONGEST))
    step = (length / steps)[:, None]
    limp = 1 - (1 - FALL) ** (record.length / steps / thick)
    wave = 2 * pi * (record.length / 45.0) * (0.7 + 0.6 * (draw[:, 2] + 0.5))
    clearance = ground.lift + 0.5 * thick
    points = np.zeros((2 * count, steps + 1, 3))
    points[:, 0] = position
    for s in range(1, steps + 1):
        _, out, high = ground.foot(position)
        touching = np.clip(1.5 - (high - clearance) / thick, 0, 1)[:, None]
        pull = down - touching * np.minimum((down * out).sum(1, keepdims=True), 0.0) * out
        heading = unit(heading + limp / (1 - limp) * pull)
        # A slow wave from side to side, as yarn keeps from its ball.
        sway = 0.05 * np.cos(wave * s / steps + 2 * pi * draw[:, 3])[:, None]
        heading = unit(heading + sway * np.cross(out, heading))
        position = outside(ground, position + step * heading, clearance * np.minimum(1.0, 0.55 + 0.3 * s), eyes, thick)
        moved = position - points[:, s - 1]
        heading = unit(moved)
        position = points[:, s - 1] + step * heading
        points[:, s] = position
    return list(points)


def outside(ground: Ground, points: Array, clearance: float, eyes: Array, thick: float) -> Array:
    """Points (P, 3) moved out of the fabric, to ``clearance`` mm over it, and out of the eyes."""
    _, normal, high = ground.foot(points)
    points = points + np.maximum(0.0, clearance - high)[:, None] * normal
    for middle, radius in zip(eyes[:, :3], eyes[:, 3]):
        off = points - middle
        far = np.linalg.norm(off, axis=1)
        wanted = radius + 0.5 * thick
        points = np.where((far < wanted)[:, None], middle + off * (wanted / np.maximum(far, 1e-9))[:, None], points)
    return points


def _apart(ground: Ground, lines: list[Array], of: Array, thick: float, eyes: Array) -> list[Array]:
    """Strands beside one another instead of through one another; roots and knots stay."""
    if not lines:
        return lines
    ends = np.concatenate([[0], np.cumsum([len(line) for line in lines])])
    coords = np.concatenate(lines)
    strand = np.repeat(np.arange(len(lines)), np.diff(ends))
    place = np.arange(len(coords)) - ends[strand]
    fixed = (of[strand] < 0) | (place < 2)
    held = coords[fixed].copy()
    free = ~fixed
    inner = free & (place < np.diff(ends)[strand] - 1)
    before, after = np.flatnonzero(inner) - 1, np.flatnonzero(inner) + 1
    for _ in range(5):
        clear(coords, ends, 0.94 * thick, looks=1, rounds=8)
        for _ in range(2):  # yarn has no kinks
            coords[inner] = 0.5 * coords[inner] + 0.25 * (coords[before] + coords[after])
        coords[fixed] = held
        coords[free] = outside(ground, coords[free], ground.lift + 0.5 * thick, eyes, thick)
    return [coords[a:b] for a, b in pairwise(ends)]

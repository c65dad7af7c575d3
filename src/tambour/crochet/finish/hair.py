"""Hair: strands of yarn, folded in half and knotted in along a line, that hang over the fabric."""

from __future__ import annotations

from math import pi

import numpy as np

from tambour.core.check import Array
from tambour.core.paths import Paths
from tambour.core.strands import Strands
from tambour.crochet.finish.ground import Ground, unit
from tambour.crochet.language.finishes import Hair
from tambour.crochet.yarn.clearance import clear
from tambour.crochet.yarn.loops import RATIO
from tambour.geometry import motion
from tambour.noise import stream

FALL = 0.2
"""How much of its way a strand turns towards the ground over one diameter of its yarn: yarn is limp."""
SPREAD = 0.12
"""Largest angle by which a strand lies beside the way it is combed, radians."""
FOLD = 8.0
"""Yarn that the knot of a strand takes, in diameters."""
SETTLING = 24
"""Turns in which strands sink and push each other aside."""
LONGEST = 160
"""Points of a strand; longer ones take longer steps."""


def hangs(length: float, stitch: float) -> float:
    """How long, mm, the two ends of a strand cut to ``length`` are below its knot; stitch : the stitch's width."""
    return max(0.5 * (length - FOLD * RATIO * stitch), 0.2 * length)


def cut(hangs: float, stitch: float) -> float:
    """How long a strand is cut that hangs so far, mm: it is folded, and its loop is drawn through a stitch."""
    return 2.0 * hangs + FOLD * RATIO * stitch


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
    line, _ = ground.line(points, 0.25 * ground.stitch)
    along = np.concatenate([[0.0], np.cumsum(np.sqrt((np.diff(line, axis=0) ** 2).sum(1)))])
    at = np.linspace(0, along[-1], count) if count > 1 else np.array([along[-1] / 2])
    places = np.column_stack([np.interp(at, along, line[:, c]) for c in range(3)])
    ahead, behind = at + ground.stitch, at - ground.stitch
    forward = [np.interp(ahead, along, line[:, c]) - np.interp(behind, along, line[:, c]) for c in range(3)]
    return places, unit(np.column_stack(forward))


def _lie(ground: Ground, places: Array, forward: Array) -> tuple[Array, Array, Array]:
    """The fabric at places (P, 3): its points, its normals as a stitch's width around makes them, and ``forward`` (P, 3)
    across those."""
    base, normal, _ = ground.foot(places)
    side = np.cross(forward, normal)
    around = [ground.foot(base + 0.8 * ground.stitch * way)[1] for way in (forward, -forward, side, -side)]
    normal = unit(normal + sum(around))
    return base, normal, unit(forward - (forward * normal).sum(1, keepdims=True) * normal)


def hair(ground: Ground, records: list[tuple[Hair, Array]], thick: float, eyes: Array) -> Strands:
    """The knots of all strands, and their two ends each.

    records : what is asked for and its spots (K, 3); thick : diameter of the yarn as drawn, mm
    eyes : (E, 4) balls that hair falls over
    """
    knots: list[Array] = []
    locks: list[Array] = []
    for number, (record, points) in enumerate(records):
        places, forward = roots(ground, points, record.count, thick)
        base, normal, forward = _lie(ground, places, forward)
        # Drawn through a stitch, its fold lies on the yarn, and not in the hole between two legs.
        high = np.full(len(base), ground.lift + 0.1 * thick)
        side = np.cross(forward, normal)
        for k in range(record.count):
            knots.append(_loop(base[k] + high[k] * normal[k], normal[k], forward[k], side[k], thick))
        start = base + (np.maximum(high, ground.lift) + 0.4 * thick)[:, None] * normal
        locks.append(_comb(ground, record, number, start, normal, forward, side, thick, eyes))
    locks = _settled(ground, knots, locks, thick, eyes)
    shades = [r.color for r, _ in records for _ in range(r.count)]
    shades += [r.color for r, _ in records for _ in range(2 * r.count)]
    paths = Paths.of([*knots, *(line for lock in locks for line in lock)], 3)
    return Strands(paths, np.full(len(paths.coords), thick / 2), np.array(shades, np.uint8).reshape(-1, 3))


def _loop(middle: Array, normal: Array, forward: Array, side: Array, thick: float) -> Array:
    """The fold of a strand, drawn tight about its two ends: an arch across the line."""
    t = np.linspace(-0.15 * pi, 1.15 * pi, 15)
    return np.asarray(
        middle
        + thick * (0.95 * np.cos(t)[:, None] * forward + (0.95 * np.sin(t) - 0.1)[:, None] * normal)
        + 0.1 * thick * side
    )


def _comb(
    ground: Ground,
    record: Hair,
    number: int,
    start: Array,
    normal: Array,
    forward: Array,
    side: Array,
    thick: float,
    eyes: Array,
) -> Array:
    """Both ends of every strand (2 count, K, 3) as they fall: step by step, limp, and outside the fabric."""
    count = len(start)
    draw = stream("hair", number, count).random((2 * count, 4)) - 0.5
    down = np.array([0.0, -1.0, 0.0])
    slope = down + normal[:, 1:2] * normal
    steep = motion.length(slope)[:, None]
    # On a slope hair is combed down it. Where it is level, or the line itself runs down the slope as a parting does,
    # the two ends go to either side of the line.
    level = np.maximum(0.0, 1.0 - steep / 0.35)
    level = np.maximum(level, (unit(slope) * forward).sum(1, keepdims=True) ** 2)
    position = np.repeat(start, 2, 0)
    end = np.tile([1.0, -1.0], count)[:, None]
    position = position + 0.45 * thick * end * np.repeat(forward, 2, 0)
    heading = np.repeat(unit(slope) * (1 - level), 2, 0) + np.repeat(level * side, 2, 0) * end
    heading = unit(unit(heading) + 0.15 * np.repeat(normal, 2, 0))
    turned = 2 * SPREAD * draw[:, :1]
    heading = unit(heading * np.cos(turned) + np.cross(np.repeat(normal, 2, 0), heading) * np.sin(turned))
    hang = hangs(record.length, ground.stitch)
    length = hang * (1 + 0.1 * (draw[:, 1] - 0.5))
    steps = int(np.clip(np.ceil(hang / (0.55 * thick)), 4, LONGEST))
    step = (length / steps)[:, None]
    limp = 1 - (1 - FALL) ** (hang / steps / thick)
    wave = 2 * pi * (hang / 45.0) * (0.7 + 0.6 * (draw[:, 2] + 0.5))
    clearance = ground.lift + 0.5 * thick
    points = np.zeros((2 * count, steps + 1, 3))
    points[:, 0] = position
    _, out, high = ground.foot(position)
    for s in range(1, steps + 1):
        touching = np.clip(1.5 - (high - clearance) / thick, 0, 1)[:, None]
        pull = down - touching * np.minimum((down * out).sum(1, keepdims=True), 0.0) * out
        heading = unit(heading + limp / (1 - limp) * pull)
        # A slow wave from side to side, as yarn keeps from its ball.
        sway = 0.05 * np.cos(wave * s / steps + 2 * pi * draw[:, 3])[:, None]
        heading = unit(heading + sway * np.cross(out, heading))
        position, out, high = outside(ground, position + step * heading, clearance, eyes, thick)
        # What stops a strand turns it along the fabric, not away from it.
        moved = unit(position - points[:, s - 1])
        away = (moved * out).sum(1, keepdims=True)
        heading = unit(moved - np.maximum(0.0, away - np.maximum(0.0, (heading * out).sum(1, keepdims=True))) * out)
        points[:, s] = position
    return points


def outside(ground: Ground, points: Array, clearance: float, eyes: Array, thick: float) -> tuple[Array, Array, Array]:
    """Points (P, 3) moved out of the fabric, to ``clearance`` mm over it, out of what was laid on it and of the eyes; the
    fabric's normals there, and how high over it they are (P,)."""
    base, normal, high = ground.foot(points)
    over = np.maximum(clearance, ground.covered(base, normal) + 0.5 * thick) if ground.laid else clearance
    points = points + np.maximum(0.0, over - high)[:, None] * normal
    for middle, radius in zip(eyes[:, :3], eyes[:, 3]):
        off = points - middle
        far = np.sqrt((off**2).sum(1))
        wanted = radius + 0.5 * thick
        points = np.where((far < wanted)[:, None], middle + off * (wanted / np.maximum(far, 1e-9))[:, None], points)
    return points, normal, np.maximum(high, over)


def _settled(ground: Ground, knots: list[Array], locks: list[Array], thick: float, eyes: Array) -> list[Array]:
    """Strands (n, K, 3) that have sunk under their weight on the fabric and on one another; their roots stay."""
    lines = [*knots, *(line for lock in locks for line in lock)]
    ends = np.concatenate([[0], np.cumsum([len(line) for line in lines])])
    coords = np.concatenate(lines)
    held = sum(len(knot) for knot in knots)
    knotted = coords[:held].copy()
    shapes, lengths = [lock.shape for lock in locks], [_steps(lock) for lock in locks]
    for turn in range(SETTLING):
        clear(coords, ends, 0.94 * thick, looks=1, rounds=6)
        coords[:held] = knotted
        at, moved = held, []
        for (count, many, _), far, first in zip(shapes, lengths, locks):
            lock = coords[at : at + count * many].reshape(count, many, 3)
            at += count * many
            lock[:, 0] = first[:, 0]
            # Sunk a little, without kinks, as long as it was, and outside.
            if turn < SETTLING - 3:
                lock[:, 1:, 1] -= 0.3 * thick
            lock[:, 1:-1] = 0.5 * lock[:, 1:-1] + 0.25 * (lock[:, :-2] + lock[:, 2:])
            for k in range(1, many):
                way = lock[:, k] - lock[:, k - 1]
                lock[:, k] = lock[:, k - 1] + unit(way) * far[:, k - 1, None]
            free, _, _ = outside(ground, lock[:, 1:].reshape(-1, 3), ground.lift + 0.5 * thick, eyes, thick)
            lock[:, 1:] = free.reshape(count, many - 1, 3)
            moved.append(lock)
        coords = np.concatenate([knotted, *(lock.reshape(-1, 3) for lock in moved)])
    return moved


def _steps(lock: Array) -> Array:
    return np.asarray(np.sqrt((np.diff(lock, axis=1) ** 2).sum(2)))

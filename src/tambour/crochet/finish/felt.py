"""Felt: flat pieces cut to a shape, draped over the fabric, with a soft edge."""

from __future__ import annotations

from itertools import pairwise
from math import exp, pi, radians

import numpy as np

from tambour.core.arrays import F8x1, F8x2
from tambour.core.check import Array
from tambour.core.kernels import kernel
from tambour.core.mesh import Mesh
from tambour.crochet.finish.eyes import fan
from tambour.crochet.finish.ground import Ground
from tambour.geometry.motion import least_squares
from tambour.noise import stream

THICK = 1.5
"""Thickness of craft felt, mm."""
ROUND = 9.0
"""Radius, mm, of the tightest hollow that felt follows: into smaller ones it does not bend."""
RAYS = 120


def outline(shape: str, width: float, height: float) -> Array:
    """The cut (K, 2), mm, right and up of the middle of its width and height, counter-clockwise, without its end again."""
    t = np.arange(RAYS) * (2 * pi / RAYS)
    if shape == "half":
        t = np.linspace(0, pi, RAYS)
        line = np.column_stack([np.cos(t), 2 * np.sin(t) - 1])
    elif shape == "triangle":
        line = _sides([(-1, -1), (1, -1), (0, 1)])
    elif shape == "square":
        line = _sides([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    elif shape == "heart":
        # Two lobes and a point: x = sin³ t, y = 13 cos t - 5 cos 2t - 2 cos 3t - cos 4t (Weisstein, "Heart Curve").
        line = np.column_stack(
            [16 * np.sin(-t) ** 3, 13 * np.cos(t) - 5 * np.cos(2 * t) - 2 * np.cos(3 * t) - np.cos(4 * t)]
        )
        low, high = line.min(0), line.max(0)
        line = 2 * (line - low) / (high - low) - 1
    else:
        line = np.column_stack([np.cos(t), np.sin(t)])
    return np.asarray(line * (width / 2, height / 2))


def _sides(corners: list[tuple[float, float]]) -> Array:
    """Points along a polygon's sides, its corners among them."""
    each = RAYS // len(corners)
    t = np.arange(each)[:, None] / each
    ends = np.array([*corners, corners[0]], np.float64)
    return np.concatenate([a + t * (b - a) for a, b in pairwise(ends)])


def area(shape: str, width: float, height: float) -> float:
    """The area of the cut, mm²."""
    x, y = outline(shape, width, height).T
    return float(0.5 * abs((x * np.roll(y, -1) - np.roll(x, -1) * y).sum()))


def felt(
    ground: Ground,
    point: Array,
    right: Array,
    up: Array,
    shape: str,
    width: float,
    height: float,
    turn: float,
    color: tuple[int, int, int],
) -> tuple[Mesh, Array]:
    """The piece as a closed mesh, and places (P, 3) in the middle of its thickness.

    point : (3,) on the fabric; right, up : (3,) along it as seen from outside; turn : degrees counter-clockwise

    Every point of the cut lies as far from the spot, over the fabric, as it does in the flat piece.
    """
    cut = outline(shape, width, height)
    middle = (0.0, _heart_of(shape) * height)
    cut = cut - middle
    c, s = np.cos(radians(turn)), np.sin(radians(turn))
    cut, shift = (
        np.column_stack([c * cut[:, 0] - s * cut[:, 1], s * cut[:, 0] + c * cut[:, 1]]),
        np.array([c * middle[0] - s * middle[1], s * middle[0] + c * middle[1]]),
    )
    if np.abs(shift).sum() > 0:
        moved, _ = ground.walk(
            point, (shift[0] * right + shift[1] * up)[None], np.full((1, 1), float(np.hypot(*shift)))
        )
        point = moved[0, 0]
    far = np.hypot(*cut.T)
    directions = (cut[:, :1] * right + cut[:, 1:] * up) / far[:, None]
    rings = min(40, max(4, int(np.ceil(far.max() / 0.9))))
    # The last rings lie where the edge is rounded off.
    soft = 0.45 * THICK
    share = np.linspace(0, 1, rings + 1)[1:]
    distance = far[:, None] * share - np.minimum(soft, 0.3 * far)[:, None] * share
    edge = np.array([0.5, 0.85, 1.0])
    distance = np.concatenate([distance, distance[:, -1:] + (far[:, None] - distance[:, -1:]) * edge], axis=1)
    fit = _fit(ground, point, directions, np.arctan2(cut[:, 1], cut[:, 0]), far)
    base, normal = ground.walk(point, directions, distance * fit[:, None])
    base0, normal0, _ = ground.foot(point[None])
    places = np.concatenate([base0, base.swapaxes(0, 1).reshape(-1, 3)])
    normals = np.concatenate([normal0, normal.swapaxes(0, 1).reshape(-1, 3)])
    flat = np.concatenate([[[0.0, 0.0]], (distance.T[:, :, None] * (cut / far[:, None])[None]).reshape(-1, 2)])
    rows, around = distance.shape[1], len(cut)
    under = drape(flat, ground.top(places, normals))
    # Felt is never quite even; towards the middle, where rays meet, what is drawn for them must not show.
    rough = 0.09 * (stream("felt", shape, len(places)).random(len(places)) - 0.5)
    rough *= np.concatenate([[0.0], np.minimum(1.0, distance.T.ravel() * (2 * pi / around) / 0.6)])
    edge_drop = np.concatenate([np.zeros(rings - 1), [0.0], THICK * (1 - np.sqrt(1 - 0.85 * edge**2))])
    over = under + THICK + rough - np.concatenate([[0.0], np.repeat(edge_drop, around)])
    upper = places + over[:, None] * normals
    # Below, the outermost ring is drawn in a little; the rest is out of sight.
    inner = 1 + (rows - 1 - len(edge)) * around
    lower = places[: inner + around] + (under[: inner + around] + 0.05)[:, None] * normals[: inner + around]
    outer = slice(1 + (rows - 2) * around, 1 + (rows - 1) * around)
    rim = places[outer] + (under[outer] + 0.12 * THICK)[:, None] * normals[outer]
    keep = lower[1:].reshape(-1, around, 3)[::-1]
    vertices = np.concatenate([upper, rim, keep.reshape(-1, 3), lower[:1]])
    faces = fan(rows + 1 + len(keep), around)
    mesh = Mesh(
        vertices,
        faces,
        color=np.full((len(vertices), 3), color, np.uint8),
        face_group=np.zeros(len(faces), np.int32),
        group_names=("felt",),
    )
    return mesh, np.asarray(places + (under + THICK / 2)[:, None] * normals)


def _fit(ground: Ground, point: Array, directions: Array, angle: Array, far: Array) -> Array:
    """By how much walks (D,) over the fabric are to be shorter, so that they are as long as they should be on the yarn's
    top: that goes further where the fabric is bent. Smooth over directions, as bending is: a + b cos 2θ + c sin 2θ."""
    steps = np.linspace(0, 1, 9)[1:]
    base, normal = ground.walk(point, directions, far[:, None] * steps)
    top = base + ground.lift * normal
    start, upright, _ = ground.foot(point[None])
    ways = np.diff(np.concatenate([np.repeat((start + ground.lift * upright)[None], len(top), 0), top], axis=1), axis=1)
    longer = np.sqrt((ways**2).sum(2)).sum(1) / far
    terms = np.column_stack([np.ones_like(angle), np.cos(2 * angle), np.sin(2 * angle)])
    smooth = least_squares(terms, longer)
    return np.asarray(1.0 / np.clip(smooth, 0.7, 1.6))


def _heart_of(shape: str) -> float:
    """A point within the cut that sees all of its edge: how far up of the middle, in heights."""
    return {"half": -0.25, "triangle": -0.18, "heart": 0.02}.get(shape, 0.0)


def drape(flat: Array, high: Array) -> Array:
    """Heights (P,) of a stiff sheet's underside at ``flat`` (P, 2) mm over bumps ``high`` (P,): nowhere under them."""
    over, smooth = np.zeros(len(flat)), np.zeros(len(flat))
    _drape(np.ascontiguousarray(flat), high, 2 * ROUND, 2 * 1.2**2, over, smooth)
    return np.asarray(np.maximum(smooth, high) + 0.1)


@kernel
def _drape(flat: F8x2, high: F8x1, bend: float, blur: float, over: F8x1, smooth: F8x1) -> None:
    """Hollows bridged by arcs of the radius that felt bends to (over, (P,)), then smoothed (smooth, (P,))."""
    n = len(flat)
    for i in range(n):
        over[i] = high[i]
        for j in range(n):
            off = (flat[i, 0] - flat[j, 0]) ** 2 + (flat[i, 1] - flat[j, 1]) ** 2
            over[i] = max(over[i], high[j] - off / bend)
    for i in range(n):
        total, whole = 0.0, 0.0
        for j in range(n):
            off = (flat[i, 0] - flat[j, 0]) ** 2 + (flat[i, 1] - flat[j, 1]) ** 2
            if off < 4.0 * blur:
                weight = exp(-off / blur)
                total += weight * over[j]
                whole += weight
        smooth[i] = total / whole

"""Safety eyes: glossy half-balls that sit in the fabric; black, or with an iris round a black pupil."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import cos, pi, sin

import numpy as np

from tambour.core.check import Array
from tambour.core.mesh import Mesh
from tambour.core.paths import Paths
from tambour.core.rgb import RGB
from tambour.core.strands import Strands
from tambour.crochet.finish.ground import Ground, unit
from tambour.geometry.motion import dot

BLACK: RGB = (24, 22, 22)
DARK = 52
"""An eye is one colour where no channel is brighter than this; else it has a pupil."""
PUPIL = 0.55
"""Where the pupil ends, as a share of the radius seen from above."""
HELD, PRESS = 0.8, 0.15
"""An eye's widest place lies PRESS radii under the height that this share of the fabric beneath it does not reach."""
BACK = 0.34
"""How far behind its widest place an eye's back lies, in radii."""
AROUND = 48


def seat(ground: Ground, point: Array, normal: Array, size: float) -> tuple[Array, Array]:
    """Where an eye ``size`` mm across sits: the middle (3,) of its ball and its axis (3,)."""
    radius = size / 2
    turns = np.arange(16) * (2 * pi / 16)
    flat = across(normal)
    rays = np.cos(turns)[:, None] * flat[0] + np.sin(turns)[:, None] * flat[1]
    _, around = ground.walk(point, rays, np.full((16, 1), radius))
    axis = unit((normal + around[:, 0].mean(0))[None])[0]
    flat = across(axis)
    # A sunflower of places under it: how high the fabric comes there, over the plane through the spot.
    k = np.arange(160) + 0.5
    far = radius * np.sqrt(k / 160)
    angle = pi * (3 - 5**0.5) * k
    under = point + far[:, None] * (np.cos(angle)[:, None] * flat[0] + np.sin(angle)[:, None] * flat[1])
    high = ground.top(under, np.repeat(axis[None], len(under), 0))
    return point + (float(np.quantile(high, HELD)) - PRESS * radius) * axis, axis


def pressed(yarn: Strands, seats: Sequence[tuple[Array, Array, float]]) -> Strands:
    """Yarn that gives way to eyes (middle, axis, size): down behind their backs, and aside at their rims."""
    if not seats:
        return yarn
    near = np.zeros(len(yarn.paths.coords), np.bool_)
    for middle, _, size in seats:
        near |= ((yarn.paths.coords - middle) ** 2).sum(1) < (0.75 * size + 3 * yarn.radius) ** 2
    dense = _finer(yarn, near)
    coords, ends = dense.paths.coords.copy(), dense.paths.offsets
    inner = np.ones(len(coords), np.bool_)
    inner[ends[:-1][np.diff(ends) > 0]] = inner[ends[1:][np.diff(ends) > 0] - 1] = False
    touched = np.zeros(len(coords), np.bool_)
    for turn in range(5):
        if turn:  # no kinks where it begins to give way
            soft = inner & (touched | np.roll(touched, 1) | np.roll(touched, -1))
            k = np.flatnonzero(soft)
            coords[k] = 0.4 * coords[k] + 0.3 * (coords[k - 1] + coords[k + 1])
        for middle, axis, size in seats:
            moved = _pressed(coords, dense.radius, middle, axis, size)
            touched |= (moved != coords).any(1)
            coords = moved
    return replace(dense, paths=Paths(coords, ends))


def _finer(yarn: Strands, near: Array) -> Strands:
    """Strands with points no further than half their radius apart beside points that are ``near``."""
    coords, ends = yarn.paths.coords, yarn.paths.offsets
    step = np.zeros(len(coords))
    step[:-1] = np.sqrt((np.diff(coords, axis=0) ** 2).sum(1)) * (near[:-1] | near[1:])
    step[ends[1:][ends[1:] > 0] - 1] = 0.0
    times = np.maximum(1, np.ceil(step / (0.5 * yarn.radius))).astype(np.int64)
    begin = np.concatenate([[0], np.cumsum(times)])
    of = np.repeat(np.arange(len(coords)), times)
    part = ((np.arange(len(of)) - begin[of]) / times[of])[:, None]
    after = np.minimum(of + 1, len(coords) - 1)
    paths = Paths((1 - part) * coords[of] + part * coords[after], begin[ends])
    data = {name: values[of] for name, values in yarn.point_data.items()}
    return replace(yarn, paths=paths, radius=yarn.radius[of], point_data=data)


def _pressed(coords: Array, thick: Array, middle: Array, axis: Array, size: float) -> Array:
    radius = size / 2
    off = coords - middle
    high = dot(off, axis)
    out = off - high[:, None] * axis
    beside = np.sqrt((out**2).sum(1))
    room = radius + 0.75 * thick
    inside = (beside**2 + np.maximum(high, 0.0) ** 2 < room**2) & (high > -BACK * radius - thick) & (high < 3 * radius)
    aside = inside & (beside > 0.86 * radius)
    moved = coords + np.where(aside, room / np.maximum(beside, 1e-9) - 1.0, 0.0)[:, None] * out
    down = np.where(inside & ~aside, -BACK * radius - thick - high, 0.0)
    return np.asarray(moved + down[:, None] * axis)


def across(normal: Array) -> Array:
    """Two unit vectors (2, 3) across a unit vector and each other."""
    helper = np.array([0.0, 1.0, 0.0]) if abs(normal[1]) < 0.9 else np.array([0.0, 0.0, 1.0])
    right = unit(np.cross(helper, normal)[None])[0]
    return np.stack([right, np.cross(normal, right)])


def eye(middle: Array, axis: Array, size: float, color: RGB) -> Mesh:
    """The eye as a closed mesh: a half-ball about ``middle``, and below it a rim that narrows to a flat back."""
    radius = size / 2
    angles = np.linspace(0, pi / 2, 19)[1:]
    if max(color) > DARK:
        # Rings close together where one tone ends and the next begins.
        edges = np.arcsin([PUPIL - 0.012, PUPIL + 0.012])
        angles = np.unique(np.concatenate([angles, edges]))
    out = np.concatenate([np.sin(angles), [0.97, 0.86, 0.6]])
    up = np.concatenate([np.cos(angles), [-0.16, -0.28, -BACK]])
    out, up = radius * out, radius * up
    flat = across(axis)
    turns = np.arange(AROUND) * (2 * pi / AROUND)
    ring = np.array([cos(t) * flat[0] + sin(t) * flat[1] for t in turns])
    rows = middle + out[:, None, None] * ring + (up[:, None] * axis)[:, None]
    vertices = np.concatenate([[middle + radius * axis], rows.reshape(-1, 3), [middle + up[-1] * axis]])
    faces = fan(len(out), AROUND)
    share = np.concatenate([[0.0], np.repeat(out / radius, AROUND), [1.0]])
    beneath = np.concatenate([[False], np.repeat(np.arange(len(out)) > len(angles), AROUND), [True]])
    tone = np.empty((len(vertices), 3), np.uint8)
    tone[:] = color
    if max(color) > DARK:
        iris = np.array(color, np.float64)
        # Towards its rim an iris is a little darker.
        tone[:] = np.round(iris * np.clip(1.12 - 0.35 * share**3, 0, 1)[:, None]).astype(np.uint8)
        tone[beneath] = np.round(0.6 * iris).astype(np.uint8)
        tone[share < PUPIL] = BLACK
    return Mesh(vertices, faces, color=tone, face_group=np.zeros(len(faces), np.int32), group_names=("glass",))


def fan(rows: int, around: int) -> Array:
    """Faces (F, 3) of a pole, ``rows`` rings of ``around`` vertices each, and a pole: counter-clockwise from outside
    where rings run counter-clockwise about the way from the last pole to the first."""
    k = np.arange(around)
    after = (k + 1) % around
    first = np.stack([np.zeros(around, np.int64), 1 + k, 1 + after], axis=1)
    parts = [first]
    for row in range(rows - 1):
        a, b = 1 + row * around + k, 1 + row * around + after
        parts += [np.stack([a, a + around, b + around], axis=1), np.stack([a, b + around, b], axis=1)]
    last, end = 1 + (rows - 1) * around, 1 + rows * around
    parts.append(np.stack([np.full(around, end), last + after, last + k], axis=1))
    return np.concatenate(parts).astype(np.int32)

"""Light: a sky and a soft key lamp as many parallel lights, each with its own shadow map.

One mechanism gives the open shade of a sky (ambient occlusion), soft shadows and the contact shadow on the ground: the
share of the lights that a point sees.
"""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from math import cos, pi, sin, sqrt
from typing import Final

import numpy as np

from tambour.core.arrays import F4x3, F8x1, F8x2, F8x3
from tambour.core.check import Array
from tambour.core.kernels import kernel
from tambour.render.cover import cover, turn

TOUCHES: Final = ((0.012, 0.85, 1.0), (0.055, 0.55, 0.6))
"""How high a gap under a thing is, in its sizes, that a third as much light gets into; what part of it is kept out where it stands; how
far that reaches beside it, in gaps. Where it touches, and close above: without the second what stands on few places hovers."""
FLAT: Final = 2.5
"""A thing's size is so many times its height at the most where its gap is asked for: under what lies flat there is none, and its holes show the table."""
GOLDEN = pi * (3 - sqrt(5))


@dataclass(frozen=True, slots=True)
class Lights:
    """L parallel lights and what each of them sees.

    direction : (L, 3), unit, towards the light
    weight : (L, 3), linear light
    key : (L,) bool, whether it belongs to the lamp (which gives highlights) or to the sky
    axes : (L, 2, 3), right and up of each shadow map; origin : (L, 2), texel : (L,) mm
    depth : (L, S, S) float32, the height towards the light of what it sees first, -inf for nothing
    """

    direction: Array
    weight: Array
    key: Array
    axes: Array
    origin: Array
    texel: Array
    depth: Array


def directions(count: int, axis: Array | None = None, spread: float = pi) -> Array:
    """``count`` unit vectors (count, 3) evenly over the cap within ``spread`` radians of ``axis`` (y when None).

    A Fibonacci spiral: equal areas, successive points the golden angle apart.
    """
    k = np.arange(count) + 0.5
    up = 1 - k / count * (1 - cos(spread))
    flat = np.sqrt(np.maximum(0, 1 - up * up))
    cap = np.stack([flat * np.cos(GOLDEN * k), up, flat * np.sin(GOLDEN * k)], axis=1)
    if axis is None:
        return cap
    right, forward = basis(axis)
    return np.asarray(cap[:, :1] * right + cap[:, 1:2] * axis + cap[:, 2:] * forward)


def basis(axis: Array) -> tuple[Array, Array]:
    """Two unit vectors across ``axis`` and each other."""
    helper = np.array([0.0, 1.0, 0.0]) if abs(axis[1]) < 0.9 else np.array([1.0, 0.0, 0.0])
    right = np.cross(helper, axis)
    right /= np.linalg.norm(right)
    return right, np.cross(axis, right)


def studio(azimuth: float, sky: int = 40, lamp: int = 10) -> tuple[Array, Array, Array]:
    """A pale sky, its darker reflection from the ground, and a warm lamp to the left of and above the camera.

    Returns direction (L, 3), weight (L, 3), key (L,). The weights are such that a white matte surface under the open
    sky and lamp is just white.
    """
    dome = directions(sky)
    height = dome[:, 1]
    cool, warm = np.array([0.95, 0.99, 1.06]), np.array([1.05, 1.0, 0.93])
    bright = np.where(height > 0, 0.75 + 0.5 * height, 0.34 - 0.1 * height)
    sky_weight = bright[:, None] * np.where(height[:, None] > 0, cool, warm) * (2.35 / sky)
    turn = azimuth - 0.75
    towards = np.array([cos(0.82) * sin(turn), sin(0.82), cos(0.82) * cos(turn)])
    lamps = directions(lamp, towards, 0.24)
    lamp_weight = np.broadcast_to(np.array([1.06, 1.0, 0.92]) * (0.62 / lamp), (lamp, 3))
    return np.vstack([dome, lamps]), np.vstack([sky_weight, lamp_weight]), np.arange(sky + lamp) >= sky


def window(
    azimuth: float,
    sky: int = 40,
    lamp: int = 10,
    *,
    side: float = 0.95,
    soft: float = 0.22,
    high: float = 0.72,
    warm: float = 0.6,
) -> tuple[Array, Array, Array]:
    """A pale room lit by a window beside and above the camera: softer than a lamp, and more of the light.

    side : where the window is, radians to the left of the camera; soft : half its width, high : how high it stands, radians
    warm : how much warmer its light is than the room's, which fills the shadows

    As :func:`studio`: direction (L, 3), weight (L, 3), key (L,).
    """
    dome = directions(sky)
    height = dome[:, 1]
    turn = azimuth - side
    towards = np.array([cos(high) * sin(turn), sin(high), cos(high) * cos(turn)])
    # The room is brighter on the window's side; the table sends up what is left.
    cool, sent = 1.0 + warm * np.array([-0.06, -0.005, 0.08]), np.array([1.03, 1.0, 0.95])
    bright = np.where(height > 0, 0.42 + 0.3 * height, 0.22 - 0.06 * height) * (1.0 + 0.45 * (dome @ towards))
    sky_weight = bright[:, None] * np.where(height[:, None] > 0, cool, sent) * (1.48 / sky)
    lamps = directions(lamp, towards, soft)
    lamp_weight = np.broadcast_to((1.0 + warm * np.array([0.025, 0.0, -0.04])) * (2.08 / lamp), (lamp, 3))
    return np.vstack([dome, lamps]), np.vstack([sky_weight, lamp_weight]), np.arange(sky + lamp) >= sky


def shine(
    vertices: Array,
    faces: Array,
    directions: Array,
    weight: Array,
    key: Array,
    *,
    size: int,
    threads: int,
    shut: Array,
) -> Lights:
    """The shadow maps of parallel lights over a mesh.

    vertices : (V, 3) mm; faces : (F, 3); directions, weight : (L, 3); key : (L,); size : texels along a map's side
    shut : (F,) int8, see :func:`stand`
    """
    made = unbroken(vertices, directions, weight, key, size=size)
    stand(made, vertices, faces, shut, threads=threads)
    return made


def unbroken(points: Array, directions: Array, weight: Array, key: Array, *, size: int) -> Lights:
    """Lights in which nothing stands yet; their maps have room for what lies within ``points`` (P, 3)."""
    axes = np.array([np.stack(basis(d)) for d in directions])
    origin, texel = np.zeros((len(directions), 2)), np.zeros(len(directions))
    for k, axis in enumerate(axes):
        x, y, _ = turn(points if len(points) else np.zeros((1, 3)), np.vstack([axis, directions[k]]))
        low, high = np.array([x.min(), y.min()]), np.array([x.max(), y.max()])
        texel[k] = max(float((high - low).max()), 1e-9) / (size - 4)
        origin[k] = low - 2 * texel[k]
    depth = np.full((len(directions), size, size), -np.inf, np.float32)
    return Lights(directions, np.ascontiguousarray(weight), key, axes, origin, texel, depth)


def stand(lights: Lights, vertices: Array, faces: Array, shut: Array, *, threads: int) -> None:
    """Put a mesh into the lights, beside what stands there already: their maps are drawn on.

    shut : (F,) int8, 1 for the faces of surfaces without a rim: those turned to a light cast the same shadow as all;
        where nothing has a rim those turned away are drawn, so that what is lit is not shaded by itself
    """
    side = -shut if shut.all() else shut

    def draw(k: int) -> None:
        x, y, z = turn(vertices, np.vstack([lights.axes[k], lights.direction[k]]))
        x -= lights.origin[k, 0]
        x /= lights.texel[k]
        y -= lights.origin[k, 1]
        y /= lights.texel[k]
        # Rows of a map run up: faces turned to the light have positive area there.
        cover(x, y, z, faces, lights.depth[k], np.zeros((0, 0), np.int32), side)

    with ThreadPoolExecutor(threads) as pool:
        list(pool.map(draw, range(len(lights.direction))))


def together(*lights: Lights) -> Lights:
    """All of the lights, whose maps are of one size."""
    fields = ("direction", "weight", "key", "axes", "origin", "texel", "depth")
    return Lights(*(np.concatenate([getattr(each, name) for each in lights]) for name in fields))


@kernel
def above(
    k: int,
    px: float,
    py: float,
    pz: float,
    axes: F8x3,
    origin: F8x2,
    texel: F8x1,
    direction: F8x2,
    depth: F4x3,
    slack: float,
) -> float:
    """How far, mm, towards light ``k`` what keeps it from a point is; 0 where nothing does; ``slack`` texels in height count as nothing."""
    size = depth.shape[1]
    s = (px * axes[k, 0, 0] + py * axes[k, 0, 1] + pz * axes[k, 0, 2] - origin[k, 0]) / texel[k]
    t = (px * axes[k, 1, 0] + py * axes[k, 1, 1] + pz * axes[k, 1, 2] - origin[k, 1]) / texel[k]
    if s < 0.0 or t < 0.0 or s >= size or t >= size:
        return 0.0
    height = px * direction[k, 0] + py * direction[k, 1] + pz * direction[k, 2]
    top = depth[k, int(t), int(s)]
    return top - height if top > height + slack * texel[k] else 0.0


@kernel
def seen(
    k: int,
    px: float,
    py: float,
    pz: float,
    axes: F8x3,
    origin: F8x2,
    texel: F8x1,
    direction: F8x2,
    depth: F4x3,
    slack: float,
) -> float:
    """1 when nothing stands between a point and light ``k``, else 0; slack : see :func:`above`."""
    return 0.0 if above(k, px, py, pz, axes, origin, texel, direction, depth, slack) > 0.0 else 1.0


@kernel
def _pool(
    share: F8x3,
    low_x: float,
    low_z: float,
    step: float,
    height: float,
    middle: F8x1,
    width: F8x1,
    direction: F8x2,
    weight: F8x2,
    axes: F8x3,
    origin: F8x2,
    texel: F8x1,
    depth: F4x3,
    taps: int,
) -> None:
    """Fill ``share`` (G, G, 3): the part of the open light that reaches cells of the floor."""
    whole = np.zeros(3)
    # Every cell asks at the same places about it.
    root, across, up = np.zeros(taps), np.zeros(taps), np.zeros(taps)
    for tap in range(taps):
        turn = 2.399963229728653 * tap
        root[tap], across[tap], up[tap] = sqrt((tap + 0.5) / taps), cos(turn), sin(turn)
    for k in range(len(direction)):
        if direction[k, 1] > 0.0:
            for c in range(3):
                whole[c] += weight[k, c] * direction[k, 1]
    for row in range(share.shape[0]):
        for column in range(share.shape[1]):
            px, pz = low_x + (column + 0.5) * step, low_z + (row + 0.5) * step
            for k in range(len(direction)):
                if direction[k, 1] <= 0.0:
                    continue
                # A light stands for a patch of the sky: its shadow is blurred by the patch's size, as seen past what
                # throws it (Fernando 2005): sharp where it touches the floor, whatever the thing's size. What throws it is
                # looked for as far about as if it were the thing's middle.
                away = (
                    (middle[0] - px) * direction[k, 0]
                    + (middle[1] - height) * direction[k, 1]
                    + (middle[2] - pz) * direction[k, 2]
                )
                blur = max(away, 0.0) * width[k]
                over, hidden = 0.0, 0
                for tap in range(taps):
                    far = blur * root[tap]
                    u, v = far * across[tap], far * up[tap]
                    gap = above(
                        k,
                        px + u * axes[k, 0, 0] + v * axes[k, 1, 0],
                        height + u * axes[k, 0, 1] + v * axes[k, 1, 1],
                        pz + u * axes[k, 0, 2] + v * axes[k, 1, 2],
                        axes,
                        origin,
                        texel,
                        direction,
                        depth,
                        0.5,
                    )
                    if gap > 0.0:
                        over += gap
                        hidden += 1
                if hidden == 0:
                    for c in range(3):
                        share[row, column, c] += weight[k, c] * direction[k, 1] / whole[c]
                    continue
                blur = over / hidden * width[k]
                lit = 0.0
                for tap in range(taps):
                    far = blur * root[tap]
                    u, v = far * across[tap], far * up[tap]
                    lit += seen(
                        k,
                        px + u * axes[k, 0, 0] + v * axes[k, 1, 0],
                        height + u * axes[k, 0, 1] + v * axes[k, 1, 1],
                        pz + u * axes[k, 0, 2] + v * axes[k, 1, 2],
                        axes,
                        origin,
                        texel,
                        direction,
                        depth,
                        0.5,
                    )
                for c in range(3):
                    share[row, column, c] += lit / taps * weight[k, c] * direction[k, 1] / whole[c]


def touched(share: Array, plot: Array, points: Array, size: float) -> tuple[Array, Array]:
    """A floor's light (G, G, 3) with cells half as wide, darker where a thing of ``points`` (P, 3) stands on it or is close above.

    share, plot : of :func:`floor_light`, whose few lights do not find the narrow gap where a round thing touches; size : of the thing
    """
    from scipy.ndimage import gaussian_filter, minimum_filter, zoom

    fine = zoom(share, (2, 2, 1), order=1, grid_mode=True, mode="nearest")
    step = 0.5 * float(plot[2])
    plot = np.array([plot[0], plot[1], step])
    height = points[:, 1] - points[:, 1].min() if len(points) else np.zeros(0)
    size = max(min(size, FLAT * float(height.max(initial=0.0))), 1e-9)
    for share_of, kept, beside in TOUCHES:
        deep = share_of * size
        low = np.flatnonzero(height < 4.0 * deep)
        row, column = (((points[low, k] - plot[m]) / step).astype(np.int64) for k, m in ((2, 1), (0, 0)))
        inside = (row >= 0) & (column >= 0) & (row < len(fine)) & (column < len(fine))
        gap = np.full(fine.shape[:2], np.inf)
        np.minimum.at(gap, (row[inside], column[inside]), height[low[inside]] / deep)
        near = gaussian_filter(np.exp(-minimum_filter(gap, 3)), beside * deep / step)
        fine = fine * (1.0 - kept * near)[..., None]
    return fine, plot


def floor_light(lights: Lights, low: Array, high: Array, cells: int = 160, taps: int = 8) -> tuple[Array, Array]:
    """The shadow on the floor under a thing.

    low, high : (3,) the thing's box, mm; the floor lies at low[1]

    Returns share (cells, cells, 3) of the open light, rows along z and columns along x, and (3,) the x and z of its
    first corner and its cells' size, mm.
    """
    middle, reach = (low + high) / 2, float(np.linalg.norm(high - low)) * 1.1 + 1e-9
    step = 2 * reach / cells
    share = np.zeros((cells, cells, 3))
    lamps, skies = max(1, int(lights.key.sum())), max(1, int((~lights.key).sum()))
    width = np.where(lights.key, 0.24 / sqrt(lamps), 2 / sqrt(skies))
    _pool(
        share,
        middle[0] - reach,
        middle[2] - reach,
        step,
        low[1],
        middle,
        width,
        lights.direction,
        lights.weight,
        lights.axes,
        lights.origin,
        lights.texel,
        lights.depth,
        taps,
    )
    # Towards the rim the floor fades into the open one.
    t = np.abs(np.linspace(-1, 1, cells))
    rim = np.clip((1 - np.maximum(t[:, None], t[None, :])) / 0.3, 0, 1)[..., None]
    return 1 - (1 - share) * rim * rim * (3 - 2 * rim), np.array([middle[0] - reach, middle[2] - reach, step])

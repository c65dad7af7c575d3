"""Mesh → Picture as a camera would take it: by a window, on a table, sharp where it is looked at, with a film's tone and grain."""

from __future__ import annotations

from itertools import pairwise
from math import radians
from typing import Any, Final

import numpy as np

from tambour.color import coded
from tambour.core.check import Array
from tambour.core.mesh import Mesh
from tambour.core.picture import Picture
from tambour.core.threads import WORKERS
from tambour.noise import stream
from tambour.render import raster
from tambour.render.camera import THREE_QUARTER
from tambour.render.light import stand, unbroken
from tambour.render.tables import TABLES

SAMPLES: Final = 4
"""Samples along each side of a pixel."""
LIGHTS: Final = 160
"""Lights that sky and window are made of."""
OPEN: Final = 0.022
"""How wide the lens is open, as a share of the thing's size."""
NEARER: Final = 0.42
"""How soft the thing itself is, before and behind what is looked at, as a share of what such a lens would make of it."""
BEHIND: Final = 0.4
"""How soft what stands behind the thing is, as a share of what such a lens would make of it: soft, but its windings are seen."""
FALLOFF: Final = 0.16
"""How much less light the picture's corners get."""
BRIGHT: Final = 0.72
"""Light of the brightest fiftieth of a thing as a camera sets it, where it may."""
EXPOSED: Final = (0.78, 0.96)
"""How long the film sees it at least and at most, against one that shows a white wall by the window just white."""
GRAIN: Final = 0.8
"""Spread of the grain, in codes of 256."""
CONTRAST: Final = 0.24
"""How much steeper the film is in its middle."""
ROOM: Final = 0.76
"""What of the picture the thing fills."""
SOFT: Final = 0.45
"""How wide a point is drawn by the lens, in pixels."""
COLORED: Final = 0.90
"""What a film keeps of a colour's strength."""
SHARP: Final = 0.3
"""How much a camera sets edges off."""
CELLS: Final = 512
"""Cells along the side of the light on the table."""
FINEST: Final = 560
"""Texels along the side of a shadow map."""
COARSE: Final = 4.0
"""What is blurred wider than this, in pixels, is blurred at half the size."""
AROUND: Final = 40
"""How many pixels around the thing its hairs and its blur may reach."""
_BLURS: Final = (0.0, 0.7, 1.4, 2.4, 4.0, 6.5)


def picture(
    mesh: Mesh,
    *,
    width: int = 800,
    height: int | None = None,
    azimuth: float = THREE_QUARTER[0],
    elevation: float = THREE_QUARTER[1],
    lens: float = radians(26.0),
    samples: int = SAMPLES,
    lights: int = LIGHTS,
    table: str = "oak",
    open: float = OPEN,
    cast: Mesh | None = None,
    beside: Mesh | None = None,
) -> Picture:
    """A picture of a mesh on a table by a window, framed as :func:`tambour.render.raster.picture` does, with more room about it.

    width, height : pixels; without a height it follows the mesh's shape
    azimuth, elevation, lens : radians, see :func:`tambour.render.camera.look`
    samples : along each side of a pixel; lights : parallel lights that sky and window are made of
    table : what it stands on, a name of :data:`tambour.render.tables.TABLES`
    open : how wide the lens is open, as a share of the thing's size; 0: all of the thing is sharp
    cast : a mesh of fewer faces within the same surface, which throws the shadows
    beside : what stands behind the thing on its table, out of focus; the picture is framed without it

    The same bytes for any number of threads. Raises nothing for any mesh that is one.

    >>> picture(Mesh(np.zeros((0, 3)), np.zeros((0, 3), np.int32)), width=16, height=12, samples=1, lights=5).rgba.shape
    (12, 16, 4)
    """
    lamps = max(1, lights // 5)
    dark = mesh if cast is None else cast
    lit = unbroken(
        dark.vertices if beside is None else np.vstack([dark.vertices, beside.vertices]),
        *TABLES[table].lit(azimuth, lights - lamps, lamps),
        size=FINEST,
    )
    for each in (dark,) if beside is None else (dark, beside):
        stand(lit, each.vertices, each.faces, raster.shut(each), threads=WORKERS)
    view: dict[str, Any] = {
        "width": width,
        "azimuth": azimuth,
        "elevation": elevation,
        "lens": lens,
        "lights": lights,
        "lit": lit,
        "table": table,
        "margin": ROOM,
    }
    made = raster.shot(mesh, height=height, samples=samples, beside=beside, cells=CELLS, **view)
    thing, behind = _focused(made, samples, open) if open else made.light, made.behind
    if beside is not None and len(beside.faces):
        whole = raster.shot(beside, height=len(behind), samples=2, frame=raster.shown(mesh), ground=False, **view)
        far = _far(whole, made, open)
        behind = far[..., :3] + (1.0 - far[..., 3:]) * behind
    light = thing[..., :3] + (1.0 - thing[..., 3:]) * behind
    high, wide = light.shape[:2]
    # Glass and film scatter a little of what is bright.
    light = 0.975 * light + 0.025 * _blurred(light, 0.012 * max(high, wide))
    y, x = np.linspace(-1.0, 1.0, high)[:, None], np.linspace(-1.0, 1.0, wide)[None]
    square = 0.5 * (x * x + y * y)
    light = light * (1.0 - FALLOFF * square)[..., None] * _exposure(made.light)
    # As cameras do: a lens's softness, and an edge set off against it.
    light = _blurred(light, SOFT)
    shown = coded(raster.film(np.maximum(light + SHARP * (light - _blurred(light, 1.0)), 0.0)))
    shown = shown + CONTRAST * shown * (1.0 - shown) * (2.0 * shown - 1.0)
    grey = shown @ np.array([0.299, 0.587, 0.114])
    shown = grey[..., None] + COLORED * (shown - grey[..., None])
    # Grain is no single dots.
    grain = 3.0 * GRAIN * _blurred(stream("grain", wide, high).standard_normal((high, wide, 1)), 0.6)
    codes = np.clip(np.round(255.0 * shown + grain), 0, 255).astype(np.uint8)
    return Picture(np.dstack([codes, np.full((high, wide), 255, np.uint8)]))


def _exposure(thing: Array) -> float:
    """How long a camera lets the film see a thing (H, W, 4): until its brightest parts are bright, and no longer."""
    seen = thing[thing[..., 3] > 0.5]
    if not len(seen):
        return 1.0
    bright = float(np.quantile(seen[..., :3] @ np.array([0.2126, 0.7152, 0.0722], np.float32), 0.98))
    return float(np.clip(BRIGHT / max(bright, 1e-6), *EXPOSED))


def _far(whole: raster.Shot, made: raster.Shot, open: float) -> Array:
    """The light and coverage (H, W, 4) of what stands behind a thing, as blurred as it lies behind what is sharp."""
    near = whole.near[np.isfinite(whole.near)]
    if not len(near) or not open:
        return whole.light
    there = made.near[np.isfinite(made.near)]
    sharp = float(np.quantile(there, 0.6)) if len(there) else float(near.max())
    spread = BEHIND * open * made.size * made.camera.scale * abs(sharp - float(np.median(near)))
    return _blurred(whole.light, min(spread, 0.04 * max(whole.light.shape[:2])))


def _focused(made: raster.Shot, samples: int, open: float) -> Array:
    """The thing's light and coverage (H, W, 4), blurred where it lies before or behind what is looked at."""
    high, wide = made.light.shape[:2]
    near = made.near.reshape(high, samples, wide, samples).max((1, 3))
    there = near > 0.0
    if not there.any():
        return made.light
    # Around the thing there is nothing to blur, but what its hairs and its own blur reach.
    rows, columns = (np.flatnonzero(there.any(axis)) for axis in (1, 0))
    part = tuple(slice(max(0, int(each[0]) - AROUND), int(each[-1]) + AROUND) for each in (rows, columns))
    near, there, light = near[part], there[part], made.light[part]
    # What lies a little before the middle of all that is seen is sharp.
    sharp = float(np.quantile(near[there], 0.6))
    spread = np.where(
        there, NEARER * open * made.size * made.camera.scale * np.abs(sharp - np.where(there, near, 0.0)), 0.0
    )
    # Around it, where only its hairs are, as beside.
    share = _blurred(there.astype(np.float64)[..., None], 3.0)[..., 0]
    spread = np.where(there, spread, _blurred(spread[..., None], 3.0)[..., 0] / np.maximum(share, 1e-6))
    spread = np.clip(spread, 0.0, _BLURS[-1])
    spread = spread.astype(np.float32)
    out, before, most = light.copy(), light, float(spread.max())
    for low, up in pairwise(_BLURS):
        if low >= most:
            break
        after = _blurred(light, up)
        inside = np.nonzero((spread > low) & (spread <= up))
        t = ((spread[inside] - low) / (up - low))[:, None]
        out[inside] = (1.0 - t) * before[inside] + t * after[inside]
        before = after
    whole = np.array(made.light)
    whole[part] = out
    return whole


def _blurred(light: Array, spread: float) -> Array:
    """A picture (H, W, C), float32, with every point a bell ``spread`` pixels wide; a wide one by fewer pixels."""
    from scipy.ndimage import gaussian_filter1d

    out = np.asarray(light, np.float32)
    if spread >= COARSE and min(out.shape[:2]) >= 16:
        return _doubled(_blurred(_halved(out), 0.5 * (spread * spread - 0.5) ** 0.5), light.shape)
    for axis in (0, 1):
        out = gaussian_filter1d(out, spread, axis=axis, mode="nearest", truncate=3.0)
    return np.asarray(out)


def _halved(light: Array) -> Array:
    """A picture of half as many pixels, an odd last one said twice."""
    light = np.pad(light, ((0, light.shape[0] % 2), (0, light.shape[1] % 2), (0, 0)), mode="edge")
    rows = light[::2] + light[1::2]
    return np.asarray(0.25 * (rows[:, ::2] + rows[:, 1::2]))


def _doubled(light: Array, shape: tuple[int, ...]) -> Array:
    """A picture of twice as many pixels, straight between those that there are, cut to ``shape``."""
    for axis in (0, 1):
        light = np.moveaxis(light, axis, 0)
        before, after = np.concatenate([light[:1], light[:-1]]), np.concatenate([light[1:], light[-1:]])
        out = np.empty((2 * len(light), *light.shape[1:]), np.float32)
        out[::2], out[1::2] = 0.75 * light + 0.25 * before, 0.75 * light + 0.25 * after
        light = np.moveaxis(out[: shape[axis]], 0, axis)
    return np.ascontiguousarray(light)

"""Cloths that need not be brought: flat, wave, flag, and a drape over a sphere; each a sheet that is flat at rest.

Wave and flag bend along their length only as far as a thread in them could: the way along each row of vertices is laid
out by its angle, so rows keep their length in every frame. The drape wraps its middle on the sphere and hangs the rest
in folds whose depth takes up the cloth that a narrower ring leaves over.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np

from tambour.core.check import Array
from tambour.core.mesh import Mesh

CLOTHS = ("flat", "wave", "flag", "drape")
CELL = 2.5
"""Side of a cloth's cells, mm, unless that made more than 160 of them along a side."""


def sheet(width: float, height: float) -> Mesh:
    """A flat sheet of width x height mm in the plane z = 0, facing +z, the origin in its middle; uv in units of its
    longer side, so that a unit is as long across as up."""
    cell = max(CELL, max(width, height) / 160)
    nx, ny = max(2, round(width / cell)) + 1, max(2, round(height / cell)) + 1
    x, y = np.meshgrid(np.linspace(-width / 2, width / 2, nx), np.linspace(-height / 2, height / 2, ny))
    at = np.arange(nx * ny).reshape(ny, nx)
    a, b, c, d = at[:-1, :-1].ravel(), at[:-1, 1:].ravel(), at[1:, 1:].ravel(), at[1:, :-1].ravel()
    # Diagonals alternate, so that the sheet bends alike to both sides.
    odd = ((np.arange(ny - 1)[:, None] + np.arange(nx - 1)) % 2 == 1).ravel()
    first = np.where(odd[:, None], np.stack([a, b, d], 1), np.stack([a, b, c], 1))
    second = np.where(odd[:, None], np.stack([b, c, d], 1), np.stack([a, c, d], 1))
    vertices = np.stack([x, y, np.zeros_like(x)], axis=-1).reshape(-1, 3)
    longest = max(width, height)
    return Mesh(
        vertices,
        np.stack([first, second], axis=1).reshape(-1, 3),
        uv=vertices[:, :2] / longest + 0.5,
        face_group=np.zeros(len(a) * 2, np.int32),
        group_names=("cloth",),
    )


def cloth(name: str, width: float, height: float, frames: int = 1, seconds_per_frame: float = 1 / 24) -> Mesh:
    """The built-in cloth ``name``, width x height mm; ``frames`` frames of a loop (of its fall, for the drape)."""
    flat = sheet(width, height)
    if name == "flat":
        return flat
    shape = {"wave": _wave, "flag": _flag, "drape": _drape}[name]

    def moving() -> Iterator[Array]:
        for k in range(frames):
            yield shape(flat, width, height, k / frames, k / max(frames - 1, 1) if frames > 1 else 1.0)

    return Mesh(
        flat.vertices,
        flat.faces,
        uv=flat.uv,
        face_group=flat.face_group,
        group_names=flat.group_names,
        frames=moving,
        frame_count=frames,
        seconds_per_frame=seconds_per_frame,
    )


def _along(flat: Mesh, angle: Callable[[Array, Array], Array], hold: float) -> Array:
    """The sheet with each row laid out by its ``angle(s, y)`` to the x axis at distance s from the left end; ``hold``
    is the x that the row's left end keeps (its middle is kept when NaN)."""
    nx = int((flat.vertices[:, 1] == flat.vertices[0, 1]).sum())
    rest = flat.vertices.reshape(-1, nx, 3)
    s = rest[..., 0] - rest[:, :1, 0]
    step = np.diff(s, axis=1)
    turn = angle((s[:, :-1] + s[:, 1:]) / 2, rest[:, :-1, 1])
    made = rest.copy()
    made[:, 0, 0] = made[:, 0, 2] = 0.0
    made[:, 1:, 0] = np.cumsum(step * np.cos(turn), axis=1)
    made[:, 1:, 2] = np.cumsum(step * np.sin(turn), axis=1)
    if np.isnan(hold):
        made[..., 0] -= (made[:, :1, 0] + made[:, -1:, 0]) / 2
        made[..., 2] -= made[..., 2].mean()
    else:
        made[..., 0] += hold
    return made.reshape(-1, 3)


def _wave(flat: Mesh, width: float, height: float, phase: float, settled: float) -> Array:
    length = max(width, 40.0) / 2.2

    def angle(s: Array, y: Array) -> Array:
        return 0.62 * np.sin(2 * np.pi * (s / length - phase) + 0.9 * y / height)

    return _along(flat, angle, np.nan)


def _flag(flat: Mesh, width: float, height: float, phase: float, settled: float) -> Array:
    def angle(s: Array, y: Array) -> Array:
        free = 1 - np.exp(-4.0 * s / width)
        slow = np.sin(2 * np.pi * (1.4 * s / width - 2 * phase) + 0.7 * y / height)
        quick = np.sin(2 * np.pi * (2.7 * s / width - 3 * phase) - 1.1 * y / height + 1.0)
        return free * (0.72 * slow + 0.26 * quick)

    return _along(flat, angle, -width / 2)


def _drape(flat: Mesh, width: float, height: float, phase: float, settled: float) -> Array:
    radius = 0.3 * min(width, height)
    bend = max(settled, 1e-3) / radius
    x, z = flat.vertices[:, 0], -flat.vertices[:, 1]
    s, around = np.hypot(x, z), np.arctan2(z, x)
    # On the sphere down to 72 degrees, then straight on, steeper by the fold.
    tilt = np.minimum(bend * s, np.radians(72))
    past = np.maximum(s - np.radians(72) / bend, 0.0)
    out = np.sin(tilt) / bend + past * np.cos(tilt)
    down = (1 - np.cos(tilt)) / bend + past * np.sin(tilt)
    spare = np.sqrt(np.maximum(s / np.maximum(out, 1e-6) - 1, 0.0))
    folds = 8
    grown = np.minimum(past / (0.5 * radius), 1.0)
    deep = 1.3 * out / folds * spare * grown * grown * (3 - 2 * grown)
    out = out + deep * np.cos(folds * around + 0.4)
    return np.stack([out * np.cos(around), -down, out * np.sin(around)], axis=1)

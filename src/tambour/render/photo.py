"""Mesh → Picture as a camera would take it: the raster in soft, dense light, with a lens's falloff and a film's grain."""

from __future__ import annotations

from math import radians
from typing import Final

import numpy as np

from tambour.core.mesh import Mesh
from tambour.core.picture import Picture
from tambour.noise import stream
from tambour.render import raster
from tambour.render.camera import THREE_QUARTER

SAMPLES: Final = 4
"""Samples along each side of a pixel."""
LIGHTS: Final = 240
"""Lights that sky and lamp are made of."""
FALLOFF: Final = 0.16
"""How much less light the picture's corners get."""
GRAIN: Final = 1.6
"""Spread of the grain, in codes of 256."""


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
) -> Picture:
    """A picture of a mesh that stands on a floor, framed as :func:`tambour.render.raster.picture` does, and as it lit, only finer.

    width, height : pixels; without a height it follows the mesh's shape
    azimuth, elevation, lens : radians, see :func:`tambour.render.camera.look`
    samples : along each side of a pixel; lights : parallel lights that sky and lamp are made of

    The same bytes for any number of threads. Raises nothing for any mesh that is one.

    >>> picture(Mesh(np.zeros((0, 3)), np.zeros((0, 3), np.int32)), width=16, height=12, samples=1, lights=5).rgba.shape
    (12, 16, 4)
    """
    seen = raster.picture(
        mesh,
        width=width,
        height=height,
        azimuth=azimuth,
        elevation=elevation,
        lens=lens,
        samples=samples,
        lights=lights,
    ).rgba
    high, wide = seen.shape[:2]
    y, x = np.linspace(-1.0, 1.0, high)[:, None], np.linspace(-1.0, 1.0, wide)[None]
    square = 0.5 * (x * x + y * y)
    # Two rough fields, one of them twice as coarse: grain is no single dots.
    rough = stream("grain", wide, high)
    fine, coarse = (rough.random(shape) - 0.5 for shape in ((high, wide), (-(-high // 2), -(-wide // 2))))
    grain = GRAIN * (2.4 * fine + 2.4 * np.repeat(np.repeat(coarse, 2, 0), 2, 1)[:high, :wide])
    shown = seen[..., :3] * (1.0 - FALLOFF * square * square)[..., None] + grain[..., None]
    return Picture(np.dstack([np.clip(np.round(shown), 0, 255).astype(np.uint8), seen[..., 3:]]))

"""Portraits: the piece in yarn as one sees it from a side, as a picture."""

from __future__ import annotations

from functools import partial
from math import pi, radians
from typing import TYPE_CHECKING, Final

if TYPE_CHECKING:
    from tambour.core.mesh import Mesh
    from tambour.core.picture import Picture
    from tambour.crochet.piece import Plush

SIDES: Final[dict[str, tuple[float, float]]] = {
    "front": (0.0, radians(8.0)),
    "back": (pi, radians(8.0)),
    "left": (-pi / 2, radians(8.0)),
    "right": (pi / 2, radians(8.0)),
    "top": (0.0, radians(80.0)),
}
"""Side → azimuth and elevation of the camera; left and right are those of one who looks at the front."""


def portrait(piece: Plush, side: str, *, width: int = 1200, height: int | None = None, ground: bool = True) -> Picture:
    """The piece in yarn, with its face, seen from a side of SIDES."""
    from tambour.crochet.looks import toy

    return seen(toy(piece), side, width=width, height=height, ground=ground)


front, back, left, right, top = (partial(portrait, side=side) for side in SIDES)


def seen(mesh: Mesh, side: str, *, width: int = 1200, height: int | None = None, ground: bool = True) -> Picture:
    """A mesh from a side of SIDES, or from "" as most pictures show it: for several pictures of one sweep."""
    from tambour.render.camera import THREE_QUARTER
    from tambour.render.raster import picture

    azimuth, elevation = SIDES.get(side, THREE_QUARTER)
    return picture(mesh, width=width, height=height, azimuth=azimuth, elevation=elevation, ground=ground)

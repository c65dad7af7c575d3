"""Camera: where one stands to look at a thing, so that it fills the picture."""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, radians, sin, tan

import numpy as np

from tambour.core.check import Array
from tambour.render.cover import turn


@dataclass(frozen=True, slots=True)
class Camera:
    """A pinhole camera.

    eye : (3,) mm
    axes : (3, 3), rows right, up and back (from the scene to the eye), orthonormal
    scale : pixels per unit of slope: a point at (x, y) to the right and up, d in front, is drawn x * scale / d beside
        the picture's centre
    width, height : pixels
    """

    eye: Array
    axes: Array
    scale: float
    width: int
    height: int


MARGIN = 0.86


def look(
    points: Array,
    *,
    width: int,
    height: int | None,
    azimuth: float,
    elevation: float,
    lens: float,
    margin: float = MARGIN,
) -> Camera:
    """The nearest camera that sees every point with a margin.

    points : (P, 3) mm
    width, height : pixels; without a height it follows the points' own shape, between half and 1.25 times the width
    azimuth, elevation : radians; azimuth 0 looks along -z, counter-clockwise from above; elevation above the horizon
    lens : full angle of view of the wider side, radians
    margin : what of the picture's side the points fill

    For a fixed direction each side of the frustum is a half-space: the largest of x + t z (t the side's slope) over all
    points gives the distance in closed form.
    """
    back = np.array([cos(elevation) * sin(azimuth), sin(elevation), cos(elevation) * cos(azimuth)])
    right = np.array([cos(azimuth), 0.0, -sin(azimuth)])
    axes = np.array([right, np.cross(back, right), back])
    q = turn(points, axes).T
    slope = tan(lens / 2)
    t = slope * margin
    if height is None:
        spread = q.max(0) - q.min(0)
        shape = spread[1] / max(spread[0], 1e-9)
        height = round(width * float(np.clip(shape, 0.5, 1.25)))
    aspect = height / width
    side = t if aspect <= 1 else t / aspect
    rise = t * aspect if aspect <= 1 else t
    wide = ((q[:, 0] + side * q[:, 2]).max(), (side * q[:, 2] - q[:, 0]).max())
    tall = ((q[:, 1] + rise * q[:, 2]).max(), (rise * q[:, 2] - q[:, 1]).max())
    away = max((wide[0] + wide[1]) / (2 * side), (tall[0] + tall[1]) / (2 * rise), q[:, 2].max() + 1e-3)
    eye = axes.T @ np.array([(wide[0] - wide[1]) / 2, (tall[0] - tall[1]) / 2, away])
    scale = max(width, height) / 2 / slope
    return Camera(eye, axes, scale, width, height)


THREE_QUARTER = (radians(28.0), radians(24.0))
"""Azimuth and elevation from which most things are shown: a little from the right and above."""

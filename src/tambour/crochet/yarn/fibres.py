"""Fibres: what a yarn is made of, how soft it is outside, and the halo of single fibres that stands about it."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

import numpy as np

from tambour.core.arrays import F8x1, F8x2, I4x2, I8x1
from tambour.core.kernels import kernel
from tambour.core.mesh import Mesh
from tambour.core.strands import Strands
from tambour.geometry.tube import frames
from tambour.noise import stream


@dataclass(frozen=True, slots=True)
class Fibre:
    """A kind of yarn.

    surface : the name of its faces' group, which tells the renderer of plies and sheen
    full : radius drawn, as a share of wool's; count : fibres of the halo per millimetre of a yarn 2 mm thick
    long : how far they reach, and thick : how thick they are at their root, both in radii of the yarn drawn
    """

    surface: str
    full: float
    count: float
    long: float
    thick: float


KINDS: Final[dict[str, Fibre]] = {
    "wool": Fibre("yarn", 1.0, 0.2, 0.75, 0.035),
    "cotton": Fibre("cotton", 0.94, 0.08, 0.5, 0.025),
    "acrylic": Fibre("acrylic", 1.0, 0.2, 0.6, 0.03),
    "chenille": Fibre("chenille", 1.22, 4.0, 0.3, 0.10),
    "mohair": Fibre("mohair", 0.85, 2.2, 2.2, 0.03),
}
"""Materials by name, as one sees them: wool, softly plied; mercerised cotton, smooth and a little shiny; acrylic; chenille,
a thick pile without plies; mohair, a thin core in long hair."""


def halo(yarn: Strands, kind: Fibre, dense: float = 1.0) -> Mesh:
    """The single fibres (each a closed needle of four faces) that stand about the yarn, in its colours; ``dense`` times as
    many as in a usual picture."""
    coords, offsets = yarn.paths.coords, np.asarray(yarn.paths.offsets)
    tangent, across = np.zeros_like(coords), np.zeros_like(coords)
    frames(coords, offsets, tangent, across, np.zeros((0, 3)))
    step = np.zeros(len(coords))
    step[:-1] = np.sqrt((np.diff(coords, axis=0) ** 2).sum(1))
    step[offsets[1:][offsets[1:] > 0] - 1] = 0.0
    radius = float(yarn.radius[0]) if len(yarn.radius) else 1.0
    total = int(dense * step.sum() * kind.count / max(radius, 1e-9))
    draw = stream("halo", total).random((total, 6))
    # Evenly along the yarn, each a little off its place.
    along = (np.arange(total) + draw[:, 0]) / max(total, 1) * step.sum()
    end = np.cumsum(step)
    at = np.minimum(np.searchsorted(end, along, side="right"), max(len(coords) - 2, 0))
    part = 1.0 - (end[at] - along) / np.maximum(step[at], 1e-12)
    vertices, faces = np.zeros((4 * total, 3)), np.zeros((4 * total, 3), np.int32)
    _needles(coords, tangent, across, radius, at, np.clip(part, 0.0, 1.0), draw, kind.long, kind.thick, vertices, faces)
    own = np.searchsorted(offsets[1:], at, side="right")
    color = yarn.color[own].astype(np.float64) if total else np.zeros((0, 3))
    return Mesh(
        vertices,
        faces,
        color=np.repeat((color + 0.12 * (255.0 - color)).astype(np.uint8), 4, axis=0),
        uv=np.zeros((len(vertices), 2)),
        face_group=np.zeros(len(faces), np.int32),
        group_names=("fibres",),
    )


@kernel
def _needles(
    coords: F8x2,
    tangent: F8x2,
    across: F8x2,
    radius: float,
    at: I8x1,
    part: F8x1,
    draw: F8x2,
    long: float,
    thick: float,
    vertices: F8x2,
    faces: I4x2,
) -> None:
    """Vertices (4 M, 3) and faces (4 M, 3) of M needles; draw (M, 6) in 0…1."""
    out, side = np.zeros(3), np.zeros(3)
    for k in range(len(at)):
        i = at[k]
        # A way out of the yarn without an angle's sine: two draws, made a direction.
        p, q = 2.0 * draw[k, 1] - 1.0, 2.0 * draw[k, 2] - 1.0
        lean = 1.6 * (draw[k, 3] - 0.5)
        t, a = tangent[i], across[i]
        b0, b1, b2 = t[1] * a[2] - t[2] * a[1], t[2] * a[0] - t[0] * a[2], t[0] * a[1] - t[1] * a[0]
        size = max(math.sqrt(p * p + q * q), 1e-6)
        p, q = p / size, q / size
        for c in range(3):
            b = b0 if c == 0 else b1 if c == 1 else b2
            out[c] = p * a[c] + q * b
            side[c] = p * b - q * a[c]
        reach = radius * long * (0.35 + 0.65 * draw[k, 4])
        bow = 0.5 * (draw[k, 5] - 0.5)
        for c in range(3):
            foot = coords[i, c] + part[k] * (coords[i + 1, c] - coords[i, c]) + 0.9 * radius * out[c]
            vertices[4 * k, c] = foot + radius * thick * side[c]
            vertices[4 * k + 1, c] = foot - 0.5 * radius * thick * side[c] + 0.87 * radius * thick * t[c]
            vertices[4 * k + 2, c] = foot - 0.5 * radius * thick * side[c] - 0.87 * radius * thick * t[c]
            vertices[4 * k + 3, c] = foot + reach * (out[c] + lean * t[c] + bow * side[c])
        v = 4 * k
        faces[v, 0], faces[v, 1], faces[v, 2] = v, v + 1, v + 2
        faces[v + 1, 0], faces[v + 1, 1], faces[v + 1, 2] = v, v + 3, v + 1
        faces[v + 2, 0], faces[v + 2, 1], faces[v + 2, 2] = v + 1, v + 3, v + 2
        faces[v + 3, 0], faces[v + 3, 1], faces[v + 3, 2] = v + 2, v + 3, v

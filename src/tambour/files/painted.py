"""Painted: what a model's materials say of its colours, their pictures too, as colours of its vertices."""

from __future__ import annotations

import io
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from tambour.color import coded, linear
from tambour.core.check import Array
from tambour.core.errors import TambourError
from tambour.core.mesh import Mesh

FINE = 256
"""Pixels that a texture keeps along its longer side: a stitch sees no finer."""
PIXELS = 100_000_000
"""Pixels of a texture that are read at the most."""
FACES = 40_000
"""Triangles that a textured model is cut into, at the most, so that its vertices see its picture."""


@dataclass(frozen=True, eq=False, slots=True)
class Paint:
    """A material: ``tone`` (3,), what its colour is multiplied by, linear; ``picture`` (H, W, 3), sRGB, or None."""

    tone: tuple[float, float, float] = (1.0, 1.0, 1.0)
    picture: Array | None = None


def texture(raw: bytes, where: Path) -> Array:
    """The picture (H, W, 3) of a texture's file, as fine as it is of use. TambourError where it cannot be read."""
    from PIL import Image

    try:
        with Image.open(io.BytesIO(raw)) as image:
            if image.width * image.height > PIXELS:
                raise ValueError(f"{image.width} × {image.height} pixels")
            image.draft("RGB", (2 * FINE, 2 * FINE))
            small = image.convert("RGB")
            small.thumbnail((FINE, FINE), Image.Resampling.BOX)
            return np.asarray(small, np.uint8)
    except (OSError, ValueError, SyntaxError, Image.DecompressionBombError) as bad:
        raise TambourError(
            f"the picture of its surface cannot be read ({bad})", hint="leave the texture out", where=str(where)
        ) from None


def painted(mesh: Mesh, on: Array, paints: Sequence[Paint]) -> Mesh:
    """``mesh`` with the colours of its materials, times those that its vertices have; cut finer where it has pictures, so that
    large triangles show what is painted on them.

    on : (F,) the paint of every face; mesh.uv : where its vertices lie on the pictures, from the upper left corner
    """
    key = on[:, None] * np.int64(len(mesh.vertices)) + mesh.faces
    used, faces = np.unique(key, return_inverse=True)
    faces = faces.reshape(-1, 3)
    paint, vertex = np.divmod(used, len(mesh.vertices))
    x, group = mesh.vertices[vertex], mesh.face_group
    uv = np.zeros((len(vertex), 2)) if mesh.uv is None else mesh.uv[vertex]
    light = np.ones((len(vertex), 3)) if mesh.color is None else linear(mesh.color[vertex] / 255.0)
    while 4 * len(faces) <= FACES and any(p.picture is not None for p in paints):
        pairs = np.sort(np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]), axis=1)
        edges, at = np.unique(pairs, axis=0, return_inverse=True)
        ab, bc, ca = len(x) + at.reshape(3, -1)
        a, b, c = faces.T
        faces = np.concatenate([np.column_stack(t) for t in ((a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca))])
        group = None if group is None else np.tile(group, 4)
        paint = np.concatenate([paint, paint[edges[:, 0]]])
        x, uv, light = (np.concatenate([v, 0.5 * (v[edges[:, 0]] + v[edges[:, 1]])]) for v in (x, uv, light))
    for k, one in enumerate(paints):
        own = paint == k
        light[own] *= np.array(one.tone)
        if one.picture is not None:
            high, wide = one.picture.shape[:2]
            share = uv[own] % 1.0
            share[(share == 0.0) & (uv[own] > 0.0)] = 1.0 - 1e-9  # the far edge, not the near one again
            at = np.floor(share * (wide, high)).astype(int)
            light[own] *= linear(one.picture[at[:, 1] % high, at[:, 0] % wide] / 255.0)
    color = np.round(coded(np.clip(light, 0.0, 1.0)) * 255).astype(np.uint8)
    return replace(mesh, vertices=x, faces=faces, color=color, uv=None if mesh.uv is None else uv, face_group=group)

"""Eyed: where the eyes of a head would be that its model has none on, by its ears and its nose: what is proposed is told as such."""

from __future__ import annotations

import numpy as np

from tambour.core.check import Array
from tambour.crochet.model.assemble import Piece
from tambour.crochet.model.bumps import AHEAD, Bump
from tambour.crochet.model.tips import Mirror
from tambour.geometry.motion import length
from tambour.geometry.surface import vertex_normals

EARS = "Ear"
"""How the parts are called by which a head is known."""
HIGH, NEAR = 0.5, 1.5
"""Ears stand so high, or so far ahead, as a share of the model, and its nose lies no farther from their middle than so many times what they
are apart."""
DOWN, ASIDE = 0.45, 0.27
"""How far from the ears' middle down to the nose eyes lie, and how far aside, as a share of what the ears are apart."""
WIDE, LEAST = 0.12, 1.2
"""How wide eyes are, as such a share, and at the least, in stitches."""
IMAGE = 0.3
"""Ears are a pair where one lies no farther from the other's image than such a share."""
MIDDLE = 1.0
"""What lies so near to the mirror, in stitches, is in the middle."""
ABOUT = 1.5
"""An eye lies on the foremost of the surface within so many stitches of it, seen from the front."""


def eyed(vertices: Array, faces: Array, pieces: list[Piece], plane: Mirror) -> tuple[Bump, ...]:
    """Two eyes for a model in stitches, z ahead, on the sides of its mirror ``plane``, the one on the right of the toy's picture first; none where no
    pair of ears says where its head is, or where they would not look ahead."""
    bases = [base for p in pieces if p.rounds.name.startswith(EARS) for base in p.bases if base is not None]
    if len(bases) != 2:
        return ()
    one, other = sorted(bases, key=lambda base: -float(plane.off(base)))
    middle, apart = 0.5 * (one + other), float(length(one - other))
    share = (middle - vertices.min(0)) / np.maximum(np.ptp(vertices, axis=0), 1e-9)
    if float(length(plane.image(one) - other)) > IMAGE * apart or max(share[1], share[2]) < HIGH:
        return ()
    off = np.abs(plane.off(vertices))
    about = (off < MIDDLE) & (length(vertices - middle) < NEAR * apart) & (vertices[:, 1] < middle[1])
    if not about.any():
        return ()
    nose = vertices[about][int(vertices[about][:, 2].argmax())]
    normals = vertex_normals(vertices, faces)
    found: list[int] = []
    for side in (1.0, -1.0):
        aim = middle + DOWN * (nose - middle) + side * ASIDE * apart * plane.normal
        near = np.flatnonzero((np.abs(vertices[:, :2] - aim[:2]) < ABOUT).all(1))
        near = near[(length(vertices[near] - middle) < NEAR * apart) & (normals[near, 2] > AHEAD)]
        if not len(near):
            return ()
        # The foremost surface there, and of that the corner nearest to the aim, or to the other eye's image.
        front = near[vertices[near, 2] > vertices[near, 2].max() - ABOUT]
        off = vertices[front] - plane.image(vertices[found[0]]) if found else (vertices[front] - aim)[:, :2]
        found.append(int(front[int((off**2).sum(1).argmin())]))
    wide = max(WIDE * apart, LEAST)
    return tuple(Bump(vertices[at], normals[at], wide, vertices[at], 0.0) for at in found)

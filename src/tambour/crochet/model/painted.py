"""Painted: eyes and a nose that a model has by its colours alone, as small spots of them, taken as bumps of a face are."""

from __future__ import annotations

import math

import numpy as np

from tambour.color import oklab
from tambour.core.check import Array
from tambour.crochet.model.bumps import AHEAD, Bump
from tambour.crochet.model.tips import Mirror
from tambour.crochet.model.whole import area
from tambour.crochet.settle.arrange import labels
from tambour.geometry.motion import length
from tambour.geometry.surface import vertex_normals

SMALL, LARGE = 0.4, 14.0
"""A spot of a face has so much of the surface at the least and at the most, in stitches: less is a speck, more is worked in its yarn."""
ALIKE = 0.08
"""Neighbouring corners are of one colour that lie so near to each other in Oklab."""
DARKER = 0.15
"""How much darker than what is about it a spot is at the least, in Oklab: eyes and noses are."""
IMAGE, ASIDE = 1.2, 0.7
"""How far, in stitches, an eye lies from the other's image at the most, and from the middle at the least."""


def painted(vertices: Array, faces: Array, color: Array, plane: Mirror | None) -> tuple[Bump, ...]:
    """The two eyes, the one on the right of the toy's picture first, and the nose if there is one, of a surface in stitches whose corners have
    colours (V, 3); none of one that is not its own mirror image."""
    if plane is None:
        return ()
    lab = oklab(color)
    spots = _spots(vertices, faces, lab)
    best: tuple[float, Bump, Bump] | None = None
    for k, (dark, one) in enumerate(spots):
        for other_dark, other in spots[k + 1 :]:
            far = float(length(plane.image(one.at) - other.at))
            if abs(float(plane.off(one.at))) < ASIDE or far > IMAGE or one.out[2] + other.out[2] < 2.0 * AHEAD:
                continue
            if best is None or dark + other_dark > best[0]:
                best = dark + other_dark, *((one, other) if plane.off(one.at) > 0.0 else (other, one))
    if best is None:
        return ()
    eyes = best[1:]
    level = 0.5 * float(eyes[0].at[1] + eyes[1].at[1])
    nose = [
        (dark, spot)
        for dark, spot in spots
        if abs(float(plane.off(spot.at))) < ASIDE and spot.out[2] > AHEAD and spot.at[1] < level
    ]
    return (*eyes, max(nose, key=lambda one: one[0])[1]) if nose else eyes


def _spots(vertices: Array, faces: Array, lab: Array) -> list[tuple[float, Bump]]:
    """The small spots that are darker than what is about them, and by how much."""
    edges = np.concatenate([faces[:, :2], faces[:, 1:], faces[:, ::2]])
    same = length(lab[edges[:, 0]] - lab[edges[:, 1]]) < ALIKE
    group = labels(len(vertices), edges[same])
    weight = np.bincount(faces.ravel(), np.repeat(area(vertices, faces) / 3.0, 3), len(vertices))
    size = np.bincount(group, weight)
    normals = vertex_normals(vertices, faces)
    found = []
    for k in np.flatnonzero((size > SMALL) & (size < LARGE)).tolist():
        own = np.flatnonzero(group == k)
        mine = np.isin(edges, own)
        about = np.unique(edges[mine.any(1) & ~mine.all(1)])
        about = about[group[about] != k]
        if not len(about):
            continue
        darker = float(lab[about, 0].mean() - np.average(lab[own, 0], weights=weight[own] + 1e-12))
        if darker < DARKER:
            continue
        middle = np.average(vertices[own], axis=0, weights=weight[own] + 1e-12)
        off = length(vertices[own] - middle)
        out = normals[own].sum(0)
        wide = 2.0 * math.sqrt(float(size[k]) / math.pi)
        found.append(
            (
                darker,
                Bump(
                    middle,
                    out / max(float(length(out)), 1e-9),
                    wide,
                    vertices[own[int(off.argmin())]],
                    float(off.max()),
                ),
            )
        )
    return found

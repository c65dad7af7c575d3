"""Trunk: which limbs go on where the body ends, a head on its neck or a snout, and are worked with it in one piece."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from tambour.core.check import Array
from tambour.crochet.model.geodesic import about, distances
from tambour.crochet.model.whole import area, corners

if TYPE_CHECKING:
    from tambour.crochet.model.cut import Limb
    from tambour.crochet.model.tips import Mirror

END = 0.85
"""A limb stands at an end of the body where the way to what lies farthest is so large a share of the longest there is."""
AHEAD = 0.7
"""The cosine of the angle, at the least, between where such a limb points and the way to it from the middle of the body."""
LARGE = 0.04
"""What has less of the whole surface than this is sewn on."""
ASTRAY = 0.05
"""Nor does a limb go on that lies beside the model's plane of symmetry by more than this, as a share of the size: its twin differs."""


def trunk(vertices: Array, faces: Array, groups: list[list[Limb]], plane: Mirror | None) -> list[Array]:
    """The tips (3,) of at most two limbs that are not to be cut off a body with ``vertices`` (V, 3) and ``faces`` (F, 3), as rounds
    that come from them go on into it: no seam is as true as none. groups : the limbs that were cut off it, pairs together."""
    used = corners(faces)
    x = vertices[used]
    known = about(faces, len(vertices))
    size = float(np.sqrt((np.ptp(x, axis=0) ** 2).sum()))
    whole = float(area(vertices, faces).sum()) + sum(_area(limb) for group in groups for limb in group)

    def ways(point: Array) -> Array:
        start = used[[int(((x - point) ** 2).sum(1).argmin())]]
        return distances(vertices, faces, start, known)[used]

    first = ways(x[int(ways(x[0]).argmax())])
    longest = float(first.max())
    middle = x.mean(0)
    found: list[tuple[float, Limb]] = []
    for limb in (group[0] for group in groups if len(group) == 1):
        share = _area(limb) / whole
        ahead, out = limb.vertices[limb.tip] - limb.base, limb.base - middle
        cosine = float((ahead * out).sum() / (np.sqrt((ahead**2).sum() * (out**2).sum()) + 1e-12))
        beside = plane is not None and abs(float(plane.off(limb.base))) > ASTRAY * size
        if share >= LARGE and cosine >= AHEAD and not beside and float(ways(limb.base).max()) >= END * longest:
            found.append((share, limb))
    found.sort(key=lambda one: -one[0])
    kept: list[Limb] = []
    for _, limb in found:
        near = ways(limb.base)
        apart = [float(near[int(((x - other.base) ** 2).sum(1).argmin())]) for other in kept]
        if len(kept) < 2 and all(far >= END * longest for far in apart):
            kept.append(limb)
    return [limb.vertices[limb.tip] for limb in kept]


def _area(limb: Limb) -> float:
    return float(area(limb.vertices, limb.faces[limb.own]).sum())

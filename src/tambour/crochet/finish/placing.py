"""Placing: the frames of spots on the settled fabric, in which parts are sewn on and faces are made."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from tambour.core.check import Array
from tambour.core.graph import Part
from tambour.crochet.graph.built import Built
from tambour.crochet.graph.spots import Spots
from tambour.crochet.language.finishes import Embroidery, Eye, Placed, Spot
from tambour.geometry.motion import dot
from tambour.geometry.surface import vertex_normals

LEVEL = (0.94, 0.985)
"""Fabric as level as this (the cosine of its slope) begins to have, and has, its up at the back of the toy (underneath:
at the front), for no slope tells it there: 20 and 10 degrees."""
LAID = 0.5
"""A piece lies on what bears it, and does not stand off it, whose normal looks so nearly out of it, or into it, as a cosine."""

STANDS = 0.6
"""A part stands, and has a front, where its axis is so upright (as a cosine); else it lies, and has a top."""
AROUND = 0.38
"""Up to so far round it is told from the middle of the front, or of the top; beyond from the other side."""


class Frames(NamedTuple):
    """K points (K, 3) and three unit directions (K, 3) at each: outwards, level to the right as one sees it, and up.

    along × up = normals: from outside ``along`` is right, ``up`` up, and angles are counter-clockwise.
    """

    points: Array
    normals: Array
    along: Array
    up: Array


def standing(x: Array, up: str) -> Array:
    """``x`` (K, 3), worked upwards, as it stands with its ``up``: its end or its start on top, or lying with its start
    (``side``) or its end (``back``) ahead and what was its front above. The front stays in front when it is turned upside down."""
    if up == "side":
        return np.column_stack([x[:, 0], x[:, 2], -x[:, 1]])
    if up == "back":
        return np.column_stack([-x[:, 0], x[:, 2], x[:, 1]])
    return x * (-1.0, -1.0, 1.0) if up == "start" else x


def frames(
    known: Spots,
    positions: Array,
    spots: Sequence[Spot],
    upright: Array | None = None,
    normal: Array | None = None,
) -> Frames:
    """Where ``spots`` are on the fabric and how it lies there.

    positions : (N, 3) of the graph's nodes, in any unit, front +z
    upright : (P, 3) which way is up on every part; None: +y on all. Up on a part that leans leans with it
    normal : what :func:`outward` gives of the parts that the spots are on, where that is known
    """
    built, x = known.built, np.ascontiguousarray(positions, np.float64)
    normal = outward(known, x, {known.parts[spot.part] for spot in spots}) if normal is None else normal
    points, normals, tops = np.zeros((len(spots), 3)), np.zeros((len(spots), 3)), np.zeros((len(spots), 3))
    for k, spot in enumerate(spots):
        place = known.place(spot)
        nodes, weights = list(place.nodes), np.array(place.weights)
        part = known.parts[spot.part]
        points[k], normals[k] = (weights[:, None] * x[nodes]).sum(0), (weights[:, None] * normal[nodes]).sum(0)
        if place.opening:
            normals[k] = _out_of(x, nodes, built.graph.parts[part])
        tops[k] = (0.0, 1.0, 0.0) if upright is None else upright[part]
    normals = _unit(normals)
    return Frames(points, normals, *level(normals, tops))


def outward(known: Spots, x: Array, parts: Iterable[int]) -> Array:
    """The normals (N, 3) of the fabric of ``parts``; up (0, 1, 0) on others."""
    made = np.tile([0.0, 1.0, 0.0], (len(x), 1))
    for part in parts:
        faces = known.faces(part)
        if len(faces):
            first, end = int(faces.min()), int(faces.max()) + 1
            made[first:end] = vertex_normals(x[first:end], faces - first)
            if _inside_out(known, x, part, made):
                made[first:end] *= -1.0
    return made


def _inside_out(known: Spots, x: Array, part: int, normal: Array) -> bool:
    """Whether a piece worked in rows lies on another part with what its rows call its right side inwards: an eye on it is seen all the same."""
    if not known.in_rows[part]:
        return False
    on = (f for f in known.built.pattern.finish if isinstance(f, Placed) and f.flat and known.parts.get(f.part) == part)
    record = next(on, None)
    host = None if record is None else known.parts.get(record.spot.part)
    if host is None:
        return False
    own, other = (known.built.graph.parts[k] for k in (part, host))
    out = x[own.start : own.end].mean(0) - x[other.start : other.end].mean(0)
    looks = normal[own.start : own.end].mean(0)
    return bool(dot(out, looks) < -LAID * math.sqrt(dot(out, out) * dot(looks, looks)))


def _out_of(x: Array, rim: list[int], part: Part) -> Array:
    """Out of an opening: across its rim, away from the part."""
    off = x[rim] - x[rim].mean(0)
    across = np.cross(off, np.roll(off, -1, 0)).sum(0)
    away = x[rim].mean(0) - x[part.start : part.end].mean(0)
    return np.asarray(across if dot(across, away) >= 0.0 else -across)


def level(normals: Array, tops: Array) -> tuple[Array, Array]:
    """Along and up (K, 3) in the planes across ``normals`` (K, 3), where ``tops`` (K, 3) is up."""
    made = np.array([_level(*n, *t) for n, t in zip(normals.tolist(), tops.tolist())]).reshape(-1, 2, 3)
    return np.ascontiguousarray(made[:, 0]), np.ascontiguousarray(made[:, 1])


def _level(a: float, b: float, c: float, d: float, e: float, f: float) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """The same of one normal (a, b, c), where (d, e, f) is up: plain numbers, since few are asked for at a time."""
    rise = a * d + b * e + c * f
    share = min(max((abs(rise) - LEVEL[0]) / (LEVEL[1] - LEVEL[0]), 0.0), 1.0)
    share = share * share * (3.0 - 2.0 * share)
    kept, back = 1.0 - share, -share if rise >= 0.0 else share
    x, y, z = kept * d - 0.0 * back, kept * e - 0.0 * back, kept * f + back
    off = x * a + y * b + z * c
    x, y, z = x - off * a, y - off * b, z - off * c
    long = math.sqrt(x * x + y * y + z * z)
    x, y, z = (x / long, y / long, z / long) if long > 1e-12 else (0.0, 0.0, 0.0)
    return (y * c - z * b, z * a - x * c, x * b - y * a), (x, y, z)


def sides(x: Array) -> dict[str, Array]:
    """The sides of a round at x (K, 3), as it lies, that are told by the stitch in their middle, and where (3,) each looks: the front and the
    back, of what lies the top and what is under it, and of what points sideways none."""
    off = x - x.mean(0)
    axis = np.cross(off, np.roll(off, -1, 0)).sum(0)
    axis = axis / max(float(np.sqrt((axis**2).sum())), 1e-9)
    if abs(float(axis[0])) > STANDS:
        return {}
    if abs(float(axis[1])) >= STANDS:
        return {"mid front": np.array([0.0, 0.0, 1.0]), "mid back": np.array([0.0, 0.0, -1.0])}
    return {"mid top": np.array([0.0, 1.0, 0.0]), "mid under": np.array([0.0, -1.0, 0.0])}


def _unit(v: Array) -> Array:
    length = np.sqrt((v**2).sum(1, keepdims=True))
    return np.asarray(np.divide(v, length, out=np.zeros_like(v), where=length > 1e-12))


def off_middle(known: Spots, part: int, spot: Spot) -> tuple[float, int]:
    """How many stitches a spot is off the middle of the front, and how many its round has."""
    k = known.round_at(part, int(spot.round))
    if k is None:
        return 0.0, 1
    n = len(known.stitches(k))
    off = 0.0 if spot.stitch is None else spot.stitch - 1.0 - known.front(k)
    return (off + n / 2) % n - n / 2, n


def mirrored(known: Spots, part: int, spot: Spot, skew: float) -> Spot:
    """The spot on the other side of the middle of the front, which the round's stitches are ``skew`` beside."""
    off, n = off_middle(known, part, spot)
    k = known.round_at(part, int(spot.round))
    assert k is not None
    return replace(spot, stitch=(known.front(k) + skew - off) % n + 1.0)


def eyes_on(built: Built, part: str = "") -> list[Spot]:
    """The places of eyes on a part, or on any: of beads and of safety eyes, and of those that are embroidered every point."""
    found = [f.spot for f in built.pattern.finish if isinstance(f, Eye)]
    for f in built.pattern.finish:
        found += f.spots if isinstance(f, Embroidery) and f.motif.endswith("eyes") else ()
    return [spot for spot in found if spot.part == part or not part]

"""Sound: whether a toy that was put together looks like one: no part beside it or inside of another, no eye covered."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Final

import numpy as np

from tambour.core.check import Array
from tambour.core.errors import Problem
from tambour.core.graph import SEWN
from tambour.crochet.finish.capped import lid_on
from tambour.crochet.finish.placing import frames
from tambour.crochet.finish.sewing import end_of
from tambour.crochet.graph.built import Built
from tambour.crochet.graph.spots import Spots, whole
from tambour.crochet.language.finishes import Eye, Placed
from tambour.crochet.settle.arrange import clusters
from tambour.geometry.closest import Tree, nearest, tree
from tambour.geometry.surface import face_normals

TOUCH: Final = 1.6
"""Fabric nearer than this, in stitches, touches."""
DEEP: Final = 0.6
"""A stitch is inside of a stuffed part where it lies so many stitches below its fabric, or deeper."""
SUNK: Final = 0.5
"""A part is sunk that has this share of its stitches inside of another."""
BEFORE: Final = (0.7, 1.4, 2.1)
"""How far in front of an eye, in stitches beyond its own half width, nothing may be."""


@dataclass(frozen=True, slots=True)
class Fault:
    """What is wrong with one part: ``what`` is "floating", "sunk" or "covered"; ``other`` the part that it is in, or behind."""

    what: str
    part: str
    other: str = ""


@dataclass(frozen=True, eq=False, slots=True)
class _Fabric:
    """A part's outside: its nodes' places (n, 3), a tree over its triangles, their normals, and its box."""

    own: Array
    near: Tree
    normals: Array
    low: Array
    high: Array


def faults(built: Built, x: Array, parts: Iterable[int], upright: Array | None = None) -> list[Fault]:
    """What is wrong with a toy whose nodes are at ``x`` (N, 3) mm.

    parts : those that belong to it, and are seen
    """
    graph, width = built.graph, built.graph.stitch_width
    shell = graph.faces[built.shell]
    fabric: dict[int, _Fabric] = {}
    for k in parts:
        first, last = whole(graph, k)
        faces = shell[(shell >= first).all(1) & (shell < last).all(1)]
        if len(faces):
            own = x[first:last]
            corners = x[faces.ravel()]
            fabric[k] = _Fabric(own, tree(x, faces), face_normals(x, faces), corners.min(0), corners.max(0))
    names = [p.name for p in graph.parts]
    return [
        *(Fault("floating", names[k]) for k in _floating(built, fabric, width)),
        *(Fault("sunk", names[k], names[j]) for k, j in _sunk(built, fabric, width)),
        *(Fault("covered", "eye", names[j]) for j in _covered(built, x, fabric, width, upright)),
    ]


def told(built: Built, x: Array, parts: Iterable[int] | None, upright: Array | None = None) -> list[Problem]:
    """The same as doubts, each kind once, with what can be done; ``parts`` None: all of them."""
    found = faults(built, x, range(len(built.graph.parts)) if parts is None else parts, upright)
    made = []
    for what, message, hint in _WORDS:
        names = dict.fromkeys(f"{f.part} ({f.other})" if f.other else f.part for f in found if f.what == what)
        if names:
            made.append(Problem(f"{message}: {', '.join(names)}", hint, None, built.pattern.text, warning=True))
    return made


_WORDS: Final = (
    ("floating", "these touch nothing of the toy", "say where they are sewn, or whether they are worn"),
    ("sunk", "these are for the most part inside of another part", "say the rounds between which they are sewn"),
    ("covered", "an eye is behind another part", "say the round of the eyes, and how many stitches they are apart"),
)


def _floating(built: Built, fabric: dict[int, _Fabric], width: float) -> list[int]:
    """Parts that neither touch the largest one of their toy, nor what touches it; and those sewn to nothing beside a toy."""
    graph = built.graph
    toy = clusters(graph)
    ties = graph.edges[graph.edge_kind != SEWN]
    tied = {(int(a), int(b)) for a, b in np.unique(graph.part[ties], axis=0) if a != b}
    of: dict[int, list[int]] = {}
    for k in fabric:
        of.setdefault(int(toy[graph.parts[k].start]), []).append(k)
    loose = []
    things = {name for toy in built.pattern.toys for name in toy}
    for own in of.values():
        main = max(own, key=lambda k: graph.parts[k].end - graph.parts[k].start)
        found, ahead = {main}, [main]
        while ahead:
            k = ahead.pop()
            for j in own:
                if j not in found and ((k, j) in tied or (j, k) in tied or _touch(fabric[k], fabric[j], TOUCH * width)):
                    found.add(j)
                    ahead.append(j)
        alone = len(own) == 1 < len(of) and graph.parts[main].name.partition(".")[0] not in things
        loose += [k for k in own if k not in found or alone]  # a carrot beside a tomato is a thing for itself
    return loose


def _touch(one: _Fabric, other: _Fabric, reach: float) -> bool:
    if (one.low - reach > other.high).any() or (other.low - reach > one.high).any():
        return False
    few, many = (one, other) if len(one.own) < len(other.own) else (other, one)
    there = few.own[((few.own > many.low - reach) & (few.own < many.high + reach)).all(1)]
    return len(there) > 0 and float(nearest(many.near, there)[2].min()) < reach


def _inside(one: _Fabric, points: Array, deep: float) -> Array:
    """Which of points (P, 3) lie deeper than ``deep`` under the fabric."""
    found = np.zeros(len(points), bool)
    about = np.flatnonzero(((points > one.low) & (points < one.high)).all(1))
    if len(about):
        face, uv, far = nearest(one.near, points[about])
        corner = one.near.corner[face].reshape(-1, 3, 3)
        at = corner[:, 0] + uv[:, :1] * (corner[:, 1] - corner[:, 0]) + uv[:, 1:] * (corner[:, 2] - corner[:, 0])
        found[about] = (((points[about] - at) * one.normals[face]).sum(1) < 0.0) & (far > deep)
    return found


def _sunk(built: Built, fabric: dict[int, _Fabric], width: float) -> list[tuple[int, int]]:
    """Parts most of which is inside of a larger, stuffed one, with that."""
    graph, found, known = built.graph, [], Spots(built)
    placed = [f for f in built.pattern.finish if isinstance(f, Placed) and f.part in known.parts]
    lids = {known.parts[f.part] for f in placed if len(lid_on(built, known, f, end_of(built, known, f)))}
    for k, one in fabric.items():
        if k in lids:
            continue
        for j, other in fabric.items():
            larger = j != k and graph.parts[j].stuffing > 0.0 and len(other.own) > len(one.own)
            if larger and _inside(other, one.own, DEEP * width).mean() > SUNK:
                found.append((k, j))
                break
    return found


def _covered(built: Built, x: Array, fabric: dict[int, _Fabric], width: float, upright: Array | None) -> list[int]:
    """Parts that lie in front of an eye."""
    eyes = [f for f in built.pattern.finish if isinstance(f, Eye)]
    known, found = Spots(built), []
    if not eyes:
        return []
    where = frames(known, x, [e.spot for e in eyes], upright)
    for eye, point, normal in zip(eyes, where.points, where.normals):
        ahead = point + np.array(BEFORE)[:, None] * width * normal + 0.5 * eye.size * normal
        for j, other in fabric.items():
            if j != known.parts[eye.spot.part] and (
                (nearest(other.near, ahead)[2] < 0.5 * width).any() or _inside(other, ahead, 0.0).any()
            ):
                found.append(j)
                break
    return found

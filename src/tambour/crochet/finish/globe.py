"""Globe: a ball of twelve motifs, each on a face of the dodecahedron, sewn to its five neighbours along its sides."""

from __future__ import annotations

import re
from typing import Final

import numpy as np

from tambour.core.check import Array
from tambour.crochet.graph.spots import Spots
from tambour.geometry.motion import turned
from tambour.geometry.near import nearest
from tambour.geometry.surface import vertex_normals

_GOLDEN: Final = (1.0 + 5.0**0.5) / 2.0
_MOTIFS: Final = 12
_DEEP: Final = 1.309
"""How far a dodecahedron's faces lie from its middle, for the circle through their corners (Weisstein, "Dodecahedron")."""
_REACH: Final = 2.5
"""Stitches of two sides that come nearer than this, in stitches, are sewn to each other."""


def motifs(spots: Spots) -> list[int]:
    """The parts of a printed text that make a ball: twelve alike with five sides, in rounds; else none."""
    built = spots.built
    pattern = built.pattern
    if not pattern.terms or not re.search(r"\bball\b", pattern.text.text[:4000].lower()):
        return []
    for number, section in enumerate(pattern.parts):
        own = [k for k, fact in enumerate(built.parts) if fact.section == number]
        if section.copies == len(own) == _MOTIFS and not spots.in_rows[own[0]]:
            sides = len(spots.rim(own[0]))
            return own if sides >= 20 and sides % 5 == 0 else []
    return []


def faces() -> tuple[Array, Array]:
    """The outward ways (12, 3) of a dodecahedron's faces, and the way (12, 3) from the middle of each to a corner."""
    ways = np.array(
        [v for a in (-1, 1) for b in (-1, 1) for v in ((0, a, b * _GOLDEN), (a, b * _GOLDEN, 0), (b * _GOLDEN, 0, a))]
    )
    ways = ways / np.sqrt((ways**2).sum(1, keepdims=True))
    corners = []
    for way in ways:
        # Neighbours lie across the sides: a corner is between two of them that are neighbours of each other.
        near = ways[np.argsort(-(ways @ way))[1:6]]
        one = near[0]
        other = near[np.argsort(-(near @ one))[1]]
        corner = way + one + other
        corner = corner - (corner @ way) * way
        corners.append(corner / np.sqrt((corner**2).sum()))
    return ways, np.array(corners)


def rolled(spots: Spots, x: Array, own: list[int]) -> tuple[Array, Array, Array, Array]:
    """Motifs as a ball: positions (N, 3) of all nodes, pairs (S, 2) to sew, pairs (11, 2) of nodes that hold together, and the
    triangles (T, 3) of its seams, which close what the motifs enclose.

    x : (N, 3) in stitches, every part by itself
    """
    graph, x = spots.built.graph, x.copy()
    outward = vertex_normals(x, graph.faces[spots.built.shell])
    ways, corners = faces()
    rims = [spots.rim(k) for k in own]
    for rim, k, way, corner in zip(rims, own, ways, corners):
        nodes = np.arange(graph.parts[k].start, graph.parts[k].end)
        middle = x[rim].mean(0)
        axis = outward[nodes].sum(0)
        axis = axis / max(float(np.sqrt(axis @ axis)), 1e-9)
        off = x[rim] - middle
        off = off - (off @ axis)[:, None] * axis
        right = off[0] / max(float(np.sqrt(off[0] @ off[0])), 1e-9)
        ahead = np.cross(axis, right)
        radius = np.sqrt((off**2).sum(1))
        angle = np.arctan2(off @ ahead, off @ right)
        # The corners are where five waves of the rim are highest.
        turn = np.angle(((radius - radius.mean()) * np.exp(5j * angle)).sum()) / 5.0
        to = np.cos(turn) * right + np.sin(turn) * ahead
        before = np.column_stack([axis, to, np.cross(axis, to)])
        after = np.column_stack([way, corner, np.cross(way, corner)])
        x[nodes] = turned(x[nodes] - middle, turned(after, before)) + _DEEP * float(radius.mean()) * way
    label = np.concatenate([np.full(len(rim), k) for k, rim in enumerate(rims)])
    every = np.concatenate(rims)
    pairs, across = [], dict[int, int]()
    for k in range(len(own)):
        mine, others = every[label == k], every[label != k]
        far, at = nearest(x[mine], x[others])
        near = np.column_stack([mine, others[at[:, 0]]])[far[:, 0] < _REACH]
        pairs.append(near)
        across |= dict(near.tolist())
    held = np.array([(graph.parts[k].start, graph.parts[own[0]].start) for k in own[1:]], int)
    shell = graph.faces[spots.built.shell]
    return x, np.concatenate(pairs), held, strips(shell[np.isin(graph.part[shell[:, 0]], own)], graph.part, across)


def strips(faces: Array, part: Array, across: dict[int, int]) -> Array:
    """The triangles (T, 3) between edges that are sewn to each other, turned as the fabric beside them.

    faces : (F, 3) of the pieces; part : (N,) which piece every node is of; across : node of an edge → the one that it is sewn to
    """
    directed = {(u, v) for a, b, c in faces.tolist() for u, v in ((a, b), (b, c), (c, a))}
    made = []
    for u, v in sorted(directed):
        if (v, u) in directed or u not in across or v not in across:
            continue
        over_u, over_v = across[u], across[v]
        if part[over_u] != part[over_v] or part[u] > part[over_u]:
            continue  # a corner, or the other piece has this seam
        made.append((v, u, over_u))
        if over_u != over_v:
            made.append((v, over_u, over_v))
    return np.array(made, int).reshape(-1, 3)

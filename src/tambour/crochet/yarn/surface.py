"""The fabric as a surface: the triangles that the hook's walk left, and a dark lining inside them."""

from __future__ import annotations

import numpy as np

from tambour.core.check import Array
from tambour.core.graph import StitchGraph
from tambour.core.mesh import Mesh
from tambour.geometry.surface import closed, vertex_normals

DEPTH = 0.2
"""How far inside the stitches' nodes the lining lies, in stitches."""


def mesh(graph: StitchGraph, positions: Array) -> Mesh:
    """The fabric's triangles through its nodes (N, 3) mm, in their colours; a closed part gives a closed mesh."""
    return Mesh(
        positions,
        graph.faces,
        color=graph.color,
        face_group=np.zeros(len(graph.faces), np.int32),
        group_names=("cloth",),
    )


def lining(graph: StitchGraph, positions: Array, width: float) -> Mesh:
    """A dark surface a little inside the closed parts, so that gaps between stitches do not show the other side.

    width : of a stitch, mm. Parts with an opening get none: one looks into them.
    """
    faces = _shut(graph)
    used = lined(graph)
    renamed = np.zeros(len(graph), np.int32)
    renamed[used] = np.arange(len(used))
    inward = positions - DEPTH * width * vertex_normals(positions, faces)
    tone = 0.8 * graph.color
    return Mesh(
        inward[used],
        renamed[faces],
        color=tone[used].astype(np.uint8),
        face_group=np.zeros(len(faces), np.int32),
        group_names=("lining",),
    )


def lined(graph: StitchGraph) -> Array:
    """The stitch (V,) that every vertex of the lining lies under."""
    return np.unique(_shut(graph))


def _shut(graph: StitchGraph) -> Array:
    """The faces of closed parts."""
    part = graph.part[graph.faces[:, 0]]
    shut = [number for number in range(len(graph.parts)) if _whole(graph, part == number)]
    return np.asarray(graph.faces[np.isin(part, shut)])


def _whole(graph: StitchGraph, own: Array) -> bool:
    return bool(own.any()) and closed(graph.faces[own])

"""The fabric as a surface: the triangles that the hook's walk left, and a dark lining inside them."""

from __future__ import annotations

import numpy as np

from tambour.core.check import Array
from tambour.core.graph import SEWN, StitchGraph
from tambour.core.mesh import Mesh
from tambour.crochet.yarn.edges import gathered
from tambour.geometry.surface import closed, vertex_normals

SHADE = 0.8
"""How bright the lining is, as a share of the yarn above it: what light comes through the gaps."""
DEPTH = 0.5
"""How far inside the stitches' nodes the lining lies, in stitches: behind the yarn. At .2 it lay amid it and hid the strands that close a gap:
holes of a bear's photo were .57 of the yarn, and are .36."""
BACK = 0.7
"""How far inside it lies where it is seen from behind, too."""


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
    """What one sees between stitches instead of the other side: a surface a little inside of parts that are filled.

    width : of a stitch, mm. It lies under parts that are closed, and on both sides of those that stuffing fills and whose
    opening is sewn to another part; one looks into any other opening. A last round that is drawn together takes it along: where the
    yarn had gone in alone it stood bare about the rims of arms.
    """
    positions = gathered(graph, positions)
    shut, sewn = _filled(graph)
    faces = np.concatenate([shut, sewn])
    normals = vertex_normals(positions, faces)
    outer, inner = np.unique(faces), np.unique(sewn)
    renamed, behind = np.zeros(len(graph), np.int32), np.zeros(len(graph), np.int32)
    renamed[outer] = np.arange(len(outer))
    behind[inner] = len(outer) + np.arange(len(inner))
    used = np.concatenate([outer, inner])
    deep = np.repeat([DEPTH, BACK], [len(outer), len(inner)])[:, None]
    faces = np.concatenate([renamed[faces], behind[sewn[:, ::-1]]])
    return Mesh(
        positions[used] - deep * width * normals[used],
        faces,
        color=(SHADE * graph.color[used]).astype(np.uint8),
        face_group=np.zeros(len(faces), np.int32),
        group_names=("lining",),
    )


def lined(graph: StitchGraph) -> Array:
    """The stitch (V,) that every vertex of the lining lies under."""
    shut, sewn = _filled(graph)
    return np.concatenate([np.unique(np.concatenate([shut, sewn])), np.unique(sewn)])


def _filled(graph: StitchGraph) -> tuple[Array, Array]:
    """The faces of closed parts, and of filled parts whose opening is sewn to another part."""
    part = graph.part[graph.faces[:, 0]]
    sewn = np.zeros(len(graph), np.bool_)
    sewn[graph.edges[graph.edge_kind == SEWN].ravel()] = True
    shut, filled = [], []
    for number, own in enumerate(graph.parts):
        faces = graph.faces[part == number]
        if not len(faces):
            continue
        if closed(faces):
            shut.append(number)
        elif own.stuffing > 0.0 and 2 * int(sewn[_rim(faces)].sum()) > len(_rim(faces)):
            filled.append(number)
    return np.asarray(graph.faces[np.isin(part, shut)]), np.asarray(graph.faces[np.isin(part, filled)])


def _rim(faces: Array) -> Array:
    """The nodes on edges that only one face has."""
    edges = np.sort(np.concatenate([faces[:, :2], faces[:, 1:], faces[:, ::2]]), axis=1)
    every, count = np.unique(edges, axis=0, return_counts=True)
    return np.unique(every[count == 1])

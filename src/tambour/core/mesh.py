"""Mesh: a triangulated surface, still or moving, and Binding: points that ride on it."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

from tambour.core.check import Array, array, put, within
from tambour.core.errors import LawError

FARTHEST = 10**9
"""Of a vertex from the middle of space along an axis, mm: a thousand kilometres. Squares and volumes beyond it are no numbers."""


@dataclass(frozen=True, eq=False, slots=True)
class Mesh:
    """Triangles in space, y up.

    vertices : (V, 3) float64 mm, the rest position
    faces : (F, 3) int32, counter-clockwise seen from outside
    color : (V, 3) uint8 sRGB or None
    uv : (V, 2) float64 or None
    face_group : (F,) int32 → group_names, or None
    frames : None for a still mesh; (T, V, 3) float64; or a function that starts a new iterator of (V, 3) arrays, so
        that a long sequence never lies in memory whole
    frame_count : number of frames (1 for a still mesh); seconds_per_frame their distance in time
    smooth : the shape is meant to be round between its vertices (shading, glTF normals)
    doubts : what its file says and this mesh does not show, a line each
    name : of its file, without the suffix; "" for none

    >>> one = Mesh(np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]]), np.array([[0, 1, 2]]))
    >>> one.vertices.dtype.name, one.frame_count
    ('float64', 1)
    """

    vertices: Array
    faces: Array
    color: Array | None = None
    uv: Array | None = None
    face_group: Array | None = None
    group_names: tuple[str, ...] = ()
    frames: Array | Callable[[], Iterator[Array]] | None = None
    frame_count: int = 1
    seconds_per_frame: float = 1 / 24
    smooth: bool = True
    doubts: tuple[str, ...] = ()
    name: str = ""

    def __post_init__(self) -> None:
        vertices = array("Mesh.vertices", self.vertices, np.float64, (None, 3))
        within("Mesh.vertices", vertices, -FARTHEST, FARTHEST + 1)
        n = len(vertices)
        faces = array("Mesh.faces", self.faces, np.int32, (None, 3))
        within("Mesh.faces", faces, 0, n)
        color = None if self.color is None else array("Mesh.color", self.color, np.uint8, (n, 3))
        uv = None if self.uv is None else array("Mesh.uv", self.uv, np.float64, (n, 2))
        group = None if self.face_group is None else array("Mesh.face_group", self.face_group, np.int32, (len(faces),))
        if group is not None:
            within("Mesh.face_group", group, 0, len(self.group_names))
        frames = self.frames
        if frames is not None and not callable(frames):
            frames = array("Mesh.frames", frames, np.float64, (None, n, 3))
            within("Mesh.frames", frames, -FARTHEST, FARTHEST + 1)
            if self.frame_count not in (1, len(frames)):
                raise LawError(f"Mesh.frame_count: {self.frame_count}, but frames holds {len(frames)}")
            put(self, frame_count=len(frames))
        put(self, vertices=vertices, faces=faces, color=color, uv=uv, face_group=group, frames=frames)

    def positions(self) -> Iterator[Array]:
        """Every frame's vertices (V, 3), one at a time; the rest position for a still mesh.

        >>> moving = Mesh(np.zeros((3, 3)), np.array([[0, 1, 2]]), frames=np.zeros((24, 3, 3)))
        >>> len(list(moving.positions()))
        24
        """
        if self.frames is None:
            yield self.vertices
        elif callable(self.frames):
            yield from self.frames()
        else:
            yield from self.frames


@dataclass(frozen=True, eq=False, slots=True)
class Binding:
    """Points that ride on a mesh: at barycentric ``uv`` of ``face``, ``elevation`` along the normal there.

    face : (P,) int32; uv : (P, 2) float64, the weights of the face's second and third vertex; elevation : (P,) mm

    >>> Binding(np.array([0]), np.array([[0.25, 0.25]]), np.array([0.4])).elevation.tolist()
    [0.4]
    """

    face: Array
    uv: Array
    elevation: Array

    def __post_init__(self) -> None:
        face = array("Binding.face", self.face, np.int32, (None,))
        put(
            self,
            face=face,
            uv=array("Binding.uv", self.uv, np.float64, (len(face), 2)),
            elevation=array("Binding.elevation", self.elevation, np.float64, (len(face),)),
        )

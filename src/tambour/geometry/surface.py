"""Surfaces: normals of triangles and of the vertices they meet in."""

from __future__ import annotations

import numpy as np

from tambour.core.arrays import F8x2, I4x2
from tambour.core.check import Array
from tambour.core.kernels import kernel


@kernel
def _gather(vertices: F8x2, faces: I4x2, normals: F8x2) -> None:
    for f in range(len(faces)):
        a, b, c = faces[f, 0], faces[f, 1], faces[f, 2]
        ux, uy, uz = vertices[b, 0] - vertices[a, 0], vertices[b, 1] - vertices[a, 1], vertices[b, 2] - vertices[a, 2]
        vx, vy, vz = vertices[c, 0] - vertices[a, 0], vertices[c, 1] - vertices[a, 1], vertices[c, 2] - vertices[a, 2]
        nx, ny, nz = uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx
        for k in (a, b, c):
            normals[k, 0] += nx
            normals[k, 1] += ny
            normals[k, 2] += nz
    for k in range(len(normals)):
        x, y, z = normals[k, 0], normals[k, 1], normals[k, 2]
        length = (x * x + y * y + z * z) ** 0.5
        if length > 0.0:
            normals[k, 0] = x / length
            normals[k, 1] = y / length
            normals[k, 2] = z / length
        else:
            normals[k, 1] = 1.0


def vertex_normals(vertices: Array, faces: Array) -> Array:
    """Unit normals (V, 3) of vertices (V, 3), the mean of their faces' (F, 3) weighted by area; (0, 1, 0) where none."""
    normals = np.zeros_like(vertices, np.float64)
    _gather(np.ascontiguousarray(vertices, np.float64), np.ascontiguousarray(faces, np.int32), normals)
    return normals


def face_normals(vertices: Array, faces: Array) -> Array:
    """Unit normals (F, 3), outward for counter-clockwise faces; zero for faces without area."""
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    n = np.cross(b - a, c - a)
    length = np.sqrt((n * n).sum(1, keepdims=True))
    return np.asarray(np.divide(n, length, out=np.zeros_like(n), where=length > 0))


@kernel
def _tally(faces: I4x2) -> np.uint64:
    total = np.uint64(0)
    for f in range(len(faces)):
        for k in range(3):
            a, b = np.uint64(faces[f, k]), np.uint64(faces[f, (k + 1) % 3])
            total += _scatter(a, b) - _scatter(b, a)
    return total


@kernel
def _scatter(a: np.uint64, b: np.uint64) -> np.uint64:
    z = a * np.uint64(0x9E3779B97F4A7C15) + b * np.uint64(0xC2B2AE3D27D4EB4F)
    z = (z ^ (z >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
    return z ^ (z >> np.uint64(27))


def closed(faces: Array) -> bool:
    """Whether every edge of faces (F, 3) is run through as often in one direction as in the other: there is no rim.

    Edges are summed as 64-bit hashes, one direction positive and the other negative: a wrong "yes" has a chance of
    2⁻⁶⁴, a wrong "no" none.
    """
    return bool(_tally(np.ascontiguousarray(faces, np.int32)) == 0)

"""Coarse: a closed surface with fewer triangles, small enough that ways along it are found at once, its corners all the model's own.

Edges are collapsed, the shortest first, where the surface stays one skin (Dey, Edelsbrunner and others, "Topology preserving edge
contraction", 1999: the two ends share no neighbours but two) and hardly moves.
"""

from __future__ import annotations

import math

import numpy as np

from tambour.core.arrays import F8x2, I4x2, I8x1, I8x2
from tambour.core.check import Array
from tambour.core.kernels import kernel
from tambour.crochet.model.geodesic import about

ENOUGH = 0.03
"""A pass that collapses a smaller share of the corners than this is the last."""


@kernel
def _collapse(
    x: F8x2, faces: I4x2, offsets: I8x1, near: I8x1, edges: I8x2, off: float, to: I8x1, locked: I8x1, seen: I8x1
) -> int:
    """Collapse of ``edges`` (E, 2), in their order, those that may be, none beside another: to[b] = a. Gives how many they are.

    off : how far the surface may move, rms; to : (V,) at first every corner itself; locked, seen : (V,) room, at first 0
    """
    count = 0
    for e in range(len(edges)):
        if locked[edges[e, 0]] or locked[edges[e, 1]]:
            continue
        common = 0
        for k in range(offsets[edges[e, 0]], offsets[edges[e, 0] + 1]):
            for c in range(3):
                seen[faces[near[k], c]] = 2 * e + 1
        for k in range(offsets[edges[e, 1]], offsets[edges[e, 1] + 1]):
            for c in range(3):
                v = faces[near[k], c]
                if seen[v] == 2 * e + 1 and v != edges[e, 0] and v != edges[e, 1]:
                    common += 1
                    seen[v] = 2 * e + 2
        if common != 2:
            continue
        best, goes = off * off, -1
        for way in range(2):
            a, b = edges[e, way], edges[e, 1 - way]
            total, moved, turned = 0.0, 0.0, False
            for k in range(offsets[b], offsets[b + 1]):
                f = near[k]
                i = 0 if faces[f, 0] == b else (1 if faces[f, 1] == b else 2)
                p, q = faces[f, (i + 1) % 3], faces[f, (i + 2) % 3]
                ux, uy, uz = x[q, 0] - x[p, 0], x[q, 1] - x[p, 1], x[q, 2] - x[p, 2]
                vx, vy, vz = x[b, 0] - x[p, 0], x[b, 1] - x[p, 1], x[b, 2] - x[p, 2]
                nx, ny, nz = uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx
                size = math.sqrt(nx * nx + ny * ny + nz * nz)
                dx, dy, dz = x[a, 0] - x[b, 0], x[a, 1] - x[b, 1], x[a, 2] - x[b, 2]
                if size > 0.0:
                    out = (nx * dx + ny * dy + nz * dz) / size
                    moved += size * out * out
                    total += size
                if p != a and q != a:
                    vx, vy, vz = x[a, 0] - x[p, 0], x[a, 1] - x[p, 1], x[a, 2] - x[p, 2]
                    mx, my, mz = uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx
                    turn = nx * mx + ny * my + nz * mz
                    turned = turned or turn <= 0.5 * size * math.sqrt(mx * mx + my * my + mz * mz)
            if not turned and total > 0.0 and moved / total < best:
                best, goes = moved / total, way
        if goes < 0:
            continue
        a, b = edges[e, goes], edges[e, 1 - goes]
        to[b] = a
        count += 1
        for k in range(offsets[b], offsets[b + 1]):
            for c in range(3):
                locked[faces[near[k], c]] = 1
    return count


def coarse(vertices: Array, faces: Array, short: float, off: float) -> tuple[Array, Array]:
    """The closed surface of vertices (V, 3) and faces (F, 3) without edges shorter than ``short``, where it moves by less than ``off``
    (both in its unit) and stays one skin: corners that are left lie where they lay."""
    x = np.ascontiguousarray(vertices, np.float64)
    while True:
        count = len(x)
        a, b = np.concatenate([faces[:, :2], faces[:, 1:], faces[:, ::-2]]).astype(np.int64).T
        one = a < b  # of a closed surface every edge is there once each way
        edges = np.column_stack([a[one], b[one]])
        size = ((x[edges[:, 0]] - x[edges[:, 1]]) ** 2).sum(1)
        here = np.flatnonzero(size < short * short)
        edges = edges[here[np.argsort(size[here], kind="stable")]]
        to = np.arange(count)
        room = np.zeros((2, count), np.int64)
        small = np.ascontiguousarray(faces, np.int32)
        many = _collapse(x, small, *about(faces, count), np.ascontiguousarray(edges), off, to, room[0], room[1])
        faces = to[faces]
        faces = faces[(faces[:, 0] != faces[:, 1]) & (faces[:, 1] != faces[:, 2]) & (faces[:, 2] != faces[:, 0])]
        left = np.flatnonzero(to == np.arange(count))
        number = np.full(count, -1)
        number[left] = np.arange(len(left))
        x, faces = np.ascontiguousarray(x[left]), number[faces]
        if many <= ENOUGH * count:
            return x, faces

"""Binding thread to cloth: which face a point rides on, where on it, how high above it; and the ride.

Steps 3, 5 and 6 of the seed article. Parallel rays are points in the plane across them, so a ray's first hit is a
look-up in a grid of projected triangles; where no ray hits (folded, vertical, closed surfaces) the nearest point does.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tambour.core.arrays import B1x1, F8x1, F8x2, I4x1, I4x2, I8x1
from tambour.core.check import Array
from tambour.core.kernels import kernel
from tambour.core.mesh import Binding
from tambour.core.threads import share
from tambour.geometry.cells import touched

_BLOCK = 4096  # points that one thread takes at a time
_EDGE = 1e-9  # weights this far below zero still count as on the face


@dataclass(frozen=True, slots=True)
class Net:
    """Triangles of a cloth laid flat in the design's plane, in a grid of square cells.

    flat : (F, 3, 2) mm · depth : (F, 3) distance towards the viewer · face : (F,) their numbers in the mesh
    plane : (F, 9) for each triangle, rows (1, x, y) → weight of corner 2, weight of corner 3, depth
    offsets, items : triangles per cell · edges : (E, 4) unique edges · edge_offsets, edge_items : edges per cell
    origin, cell, shape : the grid's corner, its cells' side, its columns and rows
    """

    flat: Array
    depth: Array
    face: Array
    plane: Array
    offsets: Array
    items: Array
    edges: Array
    edge_offsets: Array
    edge_items: Array
    origin: tuple[float, float]
    cell: float
    shape: tuple[int, int]


def net(flat: Array, depth: Array, face: Array, corners: Array) -> Net:
    """The grid of triangles ``flat`` (F, 3, 2) at ``depth`` (F, 3); ``corners`` (F, 3) tell which share a corner.

    Triangles without area in the plane must be left out by the caller.
    """
    flat = np.ascontiguousarray(flat, np.float64)
    low, high = flat.min(axis=(0, 1)), flat.max(axis=(0, 1))
    size = np.maximum(high - low, 1e-6)
    cell = max(float(np.sqrt(size[0] * size[1] / len(flat)) * 1.2), float(size.max()) / 4000)
    shape = (int(size[0] / cell) + 1, int(size[1] / cell) + 1)
    a, b, c = flat[:, 0], flat[:, 1] - flat[:, 0], flat[:, 2] - flat[:, 0]
    det = b[:, 0] * c[:, 1] - b[:, 1] * c[:, 0]
    plane = np.empty((len(flat), 9))
    plane[:, 1], plane[:, 2] = c[:, 1] / det, -c[:, 0] / det
    plane[:, 4], plane[:, 5] = -b[:, 1] / det, b[:, 0] / det
    for k in (0, 3):
        plane[:, k] = -(plane[:, k + 1] * a[:, 0] + plane[:, k + 2] * a[:, 1])
    rise = depth[:, 1:] - depth[:, :1]
    plane[:, 6:9] = plane[:, 0:3] * rise[:, :1] + plane[:, 3:6] * rise[:, 1:]
    plane[:, 6] += depth[:, 0]
    pair = np.sort(np.concatenate([corners[:, [0, 1]], corners[:, [1, 2]], corners[:, [2, 0]]]), axis=1)
    ends = np.concatenate([flat[:, [0, 1]], flat[:, [1, 2]], flat[:, [2, 0]]]).reshape(-1, 4)
    _, once = np.unique(pair, axis=0, return_index=True)
    edges = np.ascontiguousarray(ends[np.sort(once)])
    boxes = np.hstack([flat.min(axis=1), flat.max(axis=1)])
    edge_boxes = np.hstack([np.minimum(edges[:, :2], edges[:, 2:]), np.maximum(edges[:, :2], edges[:, 2:])])
    grid = (float(low[0]), float(low[1]), cell, shape[0], shape[1])
    return Net(
        flat,
        depth,
        np.ascontiguousarray(face, np.int32),
        plane,
        *touched(boxes, *grid),
        edges,
        *touched(edge_boxes, *grid),
        (grid[0], grid[1]),
        cell,
        shape,
    )


@kernel
def _locate(
    low: int,
    high: int,
    points: F8x2,
    plane: F8x2,
    offsets: I8x1,
    items: I4x1,
    x0: float,
    y0: float,
    cell: float,
    nx: int,
    ny: int,
    found: I4x1,
    uv: F8x2,
) -> None:
    for q in range(low, high):
        x, y = points[q, 0], points[q, 1]
        found[q] = -1
        if not (x >= x0 - cell and y >= y0 - cell):
            continue
        i, j = max(0, int((x - x0) / cell)), max(0, int((y - y0) / cell))
        if i > nx or j > ny:
            continue
        c = min(j, ny - 1) * nx + min(i, nx - 1)
        best = -np.inf
        for s in range(offsets[c], offsets[c + 1]):
            t = items[s]
            u = plane[t, 0] + plane[t, 1] * x + plane[t, 2] * y
            v = plane[t, 3] + plane[t, 4] * x + plane[t, 5] * y
            if u >= -_EDGE and v >= -_EDGE and u + v <= 1.0 + _EDGE:
                d = plane[t, 6] + plane[t, 7] * x + plane[t, 8] * y
                if d > best + _EDGE:
                    best = d
                    found[q] = t
                    uv[q, 0], uv[q, 1] = max(u, 0.0), max(v, 0.0)


def bind_ray(n: Net, points: Array, elevation: Array) -> Binding:
    """Points (P, 2) of the design's plane on the first face that a ray from the viewer meets; face -1 where none is.

    elevation : (P,) mm, kept as it is.
    """
    points = np.ascontiguousarray(points, np.float64)
    found, uv = np.empty(len(points), np.int32), np.zeros((len(points), 2))
    share(
        len(points),
        _BLOCK,
        lambda low, high: _locate(
            low, high, points, n.plane, n.offsets, n.items, *n.origin, n.cell, *n.shape, found, uv
        ),
    )
    return Binding(np.where(found >= 0, n.face[found], -1), uv, np.asarray(elevation, np.float64))


@kernel
def _cross(
    a: F8x2,
    b: F8x2,
    edges: F8x2,
    offsets: I8x1,
    items: I4x1,
    x0: float,
    y0: float,
    cell: float,
    nx: int,
    ny: int,
    starts: I8x1,
    out: F8x1,
) -> None:
    """Fill ``starts`` with counts (when ``out`` is empty) or ``out`` with parameters along a → b, unsorted."""
    fill = len(out) > 0
    for s in range(len(a)):
        ax, ay, dx, dy = a[s, 0], a[s, 1], b[s, 0] - a[s, 0], b[s, 1] - a[s, 1]
        n = 0
        lo_x, hi_x = min(ax, ax + dx), max(ax, ax + dx)
        i0, i1 = int(np.floor((lo_x - x0) / cell)), int(np.floor((hi_x - x0) / cell))
        for i in range(max(i0, 0), min(i1, nx - 1) + 1):
            # The stretch of the segment above this column of cells, a little widened.
            left, right = max(lo_x, x0 + i * cell), min(hi_x, x0 + (i + 1) * cell)
            ya = ay + dy * (left - ax) / dx if dx != 0.0 else ay
            yb = ay + dy * (right - ax) / dx if dx != 0.0 else ay + dy
            j0 = int(np.floor((min(ya, yb) - y0) / cell - 1e-7))
            j1 = int(np.floor((max(ya, yb) - y0) / cell + 1e-7))
            for j in range(max(j0, 0), min(j1, ny - 1) + 1):
                for k in range(offsets[j * nx + i], offsets[j * nx + i + 1]):
                    e = items[k]
                    ex, ey = edges[e, 2] - edges[e, 0], edges[e, 3] - edges[e, 1]
                    det = dx * ey - dy * ex
                    if det == 0.0:
                        continue
                    wx, wy = edges[e, 0] - ax, edges[e, 1] - ay
                    t, r = (wx * ey - wy * ex) / det, (wx * dy - wy * dx) / det
                    if t > 1e-9 and t < 1.0 - 1e-9 and r >= -1e-12 and r <= 1.0 + 1e-12:
                        if fill:
                            out[starts[s] + n] = t
                        n += 1
        if not fill:
            starts[s + 1] = n


@kernel
def _tidy(offsets: I8x1, t: F8x1, kept: I8x1) -> int:
    """Sort each segment's parameters and drop those met twice (an edge lies in several cells); gives how many stay."""
    total = 0
    for s in range(len(offsets) - 1):
        part = np.sort(t[offsets[s] : offsets[s + 1]])
        last = -1.0
        for k in range(len(part)):
            if part[k] > last + 1e-7:
                last = part[k]
                t[total] = last
                total += 1
        kept[s + 1] = total
    return total


def crossings(n: Net, a: Array, b: Array) -> tuple[Array, Array]:
    """Where segments ``a`` → ``b`` (S, 2) cross edges of the cloth: offsets (S + 1,) and rising parameters in (0, 1)."""
    a, b = np.ascontiguousarray(a, np.float64), np.ascontiguousarray(b, np.float64)
    grid = (n.edges, n.edge_offsets, n.edge_items, *n.origin, n.cell, *n.shape)
    starts = np.zeros(len(a) + 1, np.int64)
    _cross(a, b, *grid, starts, np.zeros(0))
    starts = np.cumsum(starts)
    t = np.empty(int(starts[-1]))
    if len(t):
        _cross(a, b, *grid, starts, t)
    kept = np.zeros(len(a) + 1, np.int64)
    return kept, t[: _tidy(starts, t, kept)].copy()


@kernel
def _ride(low: int, high: int, face: I4x1, uv: F8x2, lift: F8x1, faces: I4x2, both: F8x2, out: F8x2) -> None:
    for q in range(low, high):
        f = face[q]
        a, b, c = faces[f, 0], faces[f, 1], faces[f, 2]
        u, v = uv[q, 0], uv[q, 1]
        s = 1.0 - u - v
        nx = s * both[a, 3] + u * both[b, 3] + v * both[c, 3]
        ny = s * both[a, 4] + u * both[b, 4] + v * both[c, 4]
        nz = s * both[a, 5] + u * both[b, 5] + v * both[c, 5]
        h = lift[q] / np.sqrt(nx * nx + ny * ny + nz * nz)
        out[q, 0] = s * both[a, 0] + u * both[b, 0] + v * both[c, 0] + h * nx
        out[q, 1] = s * both[a, 1] + u * both[b, 1] + v * both[c, 1] + h * ny
        out[q, 2] = s * both[a, 2] + u * both[b, 2] + v * both[c, 2] + h * nz


def deform(binding: Binding, faces: Array, vertices: Array, normals: Array, out: Array | None = None) -> Array:
    """Positions (P, 3) of bound points on a cloth with vertices and unit normals (V, 3).

    Step 6 of the seed, with the interpolated normal made one long, so that the elevation is kept exactly.
    """
    both = np.hstack([vertices, normals])
    made = np.empty((len(binding.face), 3)) if out is None else out
    flat = np.ascontiguousarray(faces, np.int32)
    share(
        len(made),
        _BLOCK,
        lambda low, high: _ride(low, high, binding.face, binding.uv, binding.elevation, flat, both, made),
    )
    return made


@kernel
def _settle(
    low: int, high: int, points: F8x2, faces: I4x2, both: F8x2, face: I4x1, uv: F8x2, lift: F8x1, left: B1x1
) -> None:
    """Newton steps on each point's face towards the foot from which the interpolated normal meets the point; ``left``
    stays True where the foot lies beyond the face."""
    for q in range(low, high):
        f = face[q]
        a, b, c = faces[f, 0], faces[f, 1], faces[f, 2]
        u, v, h = uv[q, 0], uv[q, 1], 0.0
        left[q] = True
        for turn in range(6):
            s = 1.0 - u - v
            r = np.empty(3)
            n = np.empty(3)
            e = np.empty((3, 2))
            m = np.empty((3, 2))
            length = 0.0
            for k in range(3):
                n[k] = s * both[a, 3 + k] + u * both[b, 3 + k] + v * both[c, 3 + k]
                length += n[k] * n[k]
            length = np.sqrt(length)
            for k in range(3):
                n[k] /= length
                r[k] = points[q, k] - s * both[a, k] - u * both[b, k] - v * both[c, k]
            if turn == 0:
                h = r[0] * n[0] + r[1] * n[1] + r[2] * n[2]
            along0 = along1 = 0.0
            for k in range(3):
                r[k] -= h * n[k]
                e[k, 0], e[k, 1] = both[b, k] - both[a, k], both[c, k] - both[a, k]
                m[k, 0] = (both[b, 3 + k] - both[a, 3 + k]) / length
                m[k, 1] = (both[c, 3 + k] - both[a, 3 + k]) / length
                along0 += m[k, 0] * n[k]
                along1 += m[k, 1] * n[k]
            if r[0] * r[0] + r[1] * r[1] + r[2] * r[2] < 1e-14:
                left[q] = False
                break
            # Columns of the derivative: along the face, with the normal's own turn, and along the normal.
            for k in range(3):
                e[k, 0] += h * (m[k, 0] - along0 * n[k])
                e[k, 1] += h * (m[k, 1] - along1 * n[k])
            x0 = e[1, 1] * n[2] - e[2, 1] * n[1]
            x1 = e[2, 1] * n[0] - e[0, 1] * n[2]
            x2 = e[0, 1] * n[1] - e[1, 1] * n[0]
            det = e[0, 0] * x0 + e[1, 0] * x1 + e[2, 0] * x2
            if det == 0.0:
                break
            du = (r[0] * x0 + r[1] * x1 + r[2] * x2) / det
            y0 = n[1] * e[2, 0] - n[2] * e[1, 0]
            y1 = n[2] * e[0, 0] - n[0] * e[2, 0]
            y2 = n[0] * e[1, 0] - n[1] * e[0, 0]
            dv = (r[0] * y0 + r[1] * y1 + r[2] * y2) / det
            z0 = e[1, 0] * e[2, 1] - e[2, 0] * e[1, 1]
            z1 = e[2, 0] * e[0, 1] - e[0, 0] * e[2, 1]
            z2 = e[0, 0] * e[1, 1] - e[1, 0] * e[0, 1]
            u, v, h = u + du, v + dv, h + (r[0] * z0 + r[1] * z1 + r[2] * z2) / det
        if u < -_EDGE or v < -_EDGE or u + v > 1.0 + _EDGE:
            left[q] = True
        if not left[q]:
            uv[q, 0], uv[q, 1], lift[q] = max(u, 0.0), max(v, 0.0), h


def bind_nearest(vertices: Array, faces: Array, normals: Array, points: Array) -> Binding:
    """Points (P, 3) in space on a mesh, however it is folded, so that they come back where they were.

    The foot of a point is where the interpolated normal meets it: sought from the nearest point by Newton steps on its
    face, and where it lies beyond that face, from the point nearest to where the normal tells, until they agree to
    1 µm. The bend of the cloth must be wider than the elevation, which is negative behind the surface.
    """
    from tambour.geometry.closest import nearest, tree

    points = np.ascontiguousarray(points, np.float64)
    flat, both = np.ascontiguousarray(faces, np.int32), np.hstack([vertices, normals])
    box = tree(vertices, faces)
    face, uv, _ = nearest(box, points)
    lift, wrong = np.zeros(len(points)), np.ones(len(points), np.bool_)
    share(len(points), _BLOCK, lambda low, high: _settle(low, high, points, flat, both, face, uv, lift, wrong))
    left = np.flatnonzero(wrong)
    for _ in range(6):
        if not len(left):
            break
        on = deform(Binding(face[left], uv[left], np.zeros(len(left))), faces, vertices, normals)
        up = deform(Binding(face[left], uv[left], np.ones(len(left))), faces, vertices, normals) - on
        lift[left] = ((points[left] - on) * up).sum(axis=1)
        foot = points[left] - lift[left, None] * up
        off = np.linalg.norm(foot - on, axis=1) > 1e-3
        left, foot = left[off], foot[off]
        face[left], uv[left], _ = nearest(box, foot, face[left])
    return Binding(face, uv, lift)

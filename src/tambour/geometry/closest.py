"""The nearest point of a mesh: a tree of boxes over the triangles, and Ericson's point-triangle regions.

C. Ericson, Real-Time Collision Detection (2005), 5.1.5 for the triangle, 6.1 for the tree.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tambour.core.arrays import F8x1, F8x2, I4x1, I8x1, I8x2
from tambour.core.check import Array
from tambour.core.kernels import kernel
from tambour.core.threads import share

_LEAF = 4
_RUN = 512  # points that one thread takes in a row, each starting from where the last one ended
_FEW = 5000
"""So few points are found sooner than threads for them begin."""


@dataclass(frozen=True, slots=True)
class Tree:
    """Boxes over triangles: ``box`` (B, 6) low and high, ``child`` (B, 2) the two children, or -1 - first and the count
    of the triangles in ``order``; ``corner`` (F, 9) the triangles' corners."""

    box: Array
    child: Array
    order: Array
    corner: Array


def tree(vertices: Array, faces: Array) -> Tree:
    """The tree of a mesh with vertices (V, 3) and faces (F, 3). Raises ValueError where there are no faces."""
    if not len(faces):
        raise ValueError(
            "a mesh without faces has no place that is nearest"
        )  # the kernel writes a first box in any case
    corner = np.ascontiguousarray(np.asarray(vertices, np.float64)[faces].reshape(-1, 9))
    middle = corner.reshape(-1, 3, 3).mean(axis=1)
    count = 2 * len(corner)
    box, child = np.empty((count, 6)), np.empty((count, 2), np.int64)
    order = np.arange(len(corner))
    used = _grow(corner, middle, order, box, child)
    return Tree(box[:used], child[:used], order, corner)


@kernel
def _grow(corner: F8x2, middle: F8x2, order: I8x1, box: F8x2, child: I8x2) -> int:
    stack = np.empty((128, 3), np.int64)
    stack[0, 0], stack[0, 1], stack[0, 2] = 0, 0, len(order)
    top, used = 1, 1
    while top > 0:
        top -= 1
        node, first, past = stack[top, 0], stack[top, 1], stack[top, 2]
        for k in range(3):
            box[node, k], box[node, 3 + k] = np.inf, -np.inf
        low, high = np.full(3, np.inf), np.full(3, -np.inf)
        for i in range(first, past):
            f = order[i]
            for k in range(3):
                for c in range(3):
                    x = corner[f, 3 * c + k]
                    box[node, k] = min(box[node, k], x)
                    box[node, 3 + k] = max(box[node, 3 + k], x)
                low[k], high[k] = min(low[k], middle[f, k]), max(high[k], middle[f, k])
        if past - first <= _LEAF:
            child[node, 0], child[node, 1] = -1 - first, past - first
            continue
        axis = int(np.argmax(high - low))
        part = order[first:past]
        order[first:past] = part[np.argsort(middle[part, axis], kind="mergesort")]
        mid = (first + past) // 2
        child[node, 0], child[node, 1] = used, used + 1
        stack[top, 0], stack[top, 1], stack[top, 2] = used, first, mid
        stack[top + 1, 0], stack[top + 1, 1], stack[top + 1, 2] = used + 1, mid, past
        top, used = top + 2, used + 2
    return used


@kernel
def on_triangle(corner: F8x2, f: int, x: float, y: float, z: float) -> tuple[float, float, float]:
    """Squared distance of (x, y, z) from triangle ``f``, and the nearest point's weights of its 2nd and 3rd corner."""
    ax, ay, az = corner[f, 0], corner[f, 1], corner[f, 2]
    bx, by, bz = corner[f, 3] - ax, corner[f, 4] - ay, corner[f, 5] - az
    cx, cy, cz = corner[f, 6] - ax, corner[f, 7] - ay, corner[f, 8] - az
    px, py, pz = x - ax, y - ay, z - az
    d1, d2 = bx * px + by * py + bz * pz, cx * px + cy * py + cz * pz
    bb, bc, cc = bx * bx + by * by + bz * bz, bx * cx + by * cy + bz * cz, cx * cx + cy * cy + cz * cz
    d3, d4, d5, d6 = d1 - bb, d2 - bc, d1 - bc, d2 - cc
    va, vb, vc = d3 * d6 - d5 * d4, d5 * d2 - d1 * d6, d1 * d4 - d3 * d2
    if d1 <= 0.0 and d2 <= 0.0:
        u, v = 0.0, 0.0
    elif d3 >= 0.0 and d4 <= d3:
        u, v = 1.0, 0.0
    elif d6 >= 0.0 and d5 <= d6:
        u, v = 0.0, 1.0
    elif vc <= 0.0 and d1 >= 0.0 and d3 <= 0.0:
        u, v = d1 / (d1 - d3) if d1 != d3 else 0.0, 0.0
    elif vb <= 0.0 and d2 >= 0.0 and d6 <= 0.0:
        u, v = 0.0, d2 / (d2 - d6) if d2 != d6 else 0.0
    elif va <= 0.0 and d4 - d3 >= 0.0 and d5 - d6 >= 0.0:
        w = (d4 - d3) / ((d4 - d3) + (d5 - d6)) if (d4 - d3) + (d5 - d6) > 0.0 else 0.0
        u, v = 1.0 - w, w
    else:
        s = va + vb + vc
        u, v = vb / s, vc / s
    qx, qy, qz = u * bx + v * cx - px, u * by + v * cy - py, u * bz + v * cz - pz
    return qx * qx + qy * qy + qz * qz, u, v


@kernel
def _apart(box: Array, node: int, x: float, y: float, z: float) -> float:
    dx = max(box[node, 0] - x, 0.0, x - box[node, 3])
    dy = max(box[node, 1] - y, 0.0, y - box[node, 4])
    dz = max(box[node, 2] - z, 0.0, z - box[node, 5])
    return dx * dx + dy * dy + dz * dz


@kernel
def _nearest(
    low: int,
    high: int,
    points: F8x2,
    box: F8x2,
    child: I8x2,
    order: I8x1,
    corner: F8x2,
    near: I4x1,
    face: I4x1,
    uv: F8x2,
    far: F8x1,
) -> None:
    """Fill the answers for points ``low`` … ``high`` - 1, each sought from where the last one's was found."""
    stack = np.empty(128, np.int64)
    keys = np.empty(128, np.float64)
    guess = 0
    for q in range(low, high):
        x, y, z = points[q, 0], points[q, 1], points[q, 2]
        if len(near) > 0:
            guess = near[q]
        best, bu, bv = on_triangle(corner, guess, x, y, z)
        found = guess
        stack[0], keys[0], top = 0, _apart(box, 0, x, y, z), 1
        while top > 0:
            top -= 1
            if keys[top] > best:
                continue
            node = stack[top]
            if child[node, 0] < 0:
                first = -1 - child[node, 0]
                for i in range(first, first + child[node, 1]):
                    f = order[i]
                    d, u, v = on_triangle(corner, f, x, y, z)
                    if d < best or (d == best and f < found):
                        best, bu, bv, found = d, u, v, f
                continue
            a, b = child[node, 0], child[node, 1]
            da, db = _apart(box, a, x, y, z), _apart(box, b, x, y, z)
            if da < db:
                a, b, da, db = b, a, db, da
            if da <= best:
                stack[top], keys[top] = a, da
                top += 1
            if db <= best:
                stack[top], keys[top] = b, db
                top += 1
        guess = found
        face[q], uv[q, 0], uv[q, 1], far[q] = found, bu, bv, best


def nearest(t: Tree, points: Array, near: Array | None = None) -> tuple[Array, Array, Array]:
    """For points (P, 3): the nearest face (P,) int32, the weights (P, 2) of its second and third corner there, and the
    distance (P,) mm. Of faces equally near the first is taken. ``near`` (P,): faces that are close, to be quicker."""
    points = np.ascontiguousarray(points, np.float64)
    face, uv, far = np.empty(len(points), np.int32), np.empty((len(points), 2)), np.empty(len(points))
    close = np.zeros(0, np.int32) if near is None else np.ascontiguousarray(near, np.int32)
    share(
        len(points),
        _RUN if len(points) > _FEW else _FEW,
        lambda low, high: _nearest(low, high, points, t.box, t.child, t.order, t.corner, close, face, uv, far),
    )
    return face, uv, np.sqrt(far)

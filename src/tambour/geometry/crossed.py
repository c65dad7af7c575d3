"""Crossed: where a surface passes through itself."""

from __future__ import annotations

import numpy as np

from tambour.core.check import Array
from tambour.geometry.near import nearest

NEAR = 48
"""Against so many triangles, those nearest by their middles, every edge is held: about a dozen share a corner with it."""


def crossed(x: Array, faces: Array) -> Array:
    """The faces, as numbers (K,), of a surface with vertices x (N, 3) that an edge of another face passes through.

    Faces are about as large as each other, as fabric's are. What shares a corner is not held against each other, and what
    only touches does not cross.
    """
    if len(faces) < 2:
        return np.zeros(0, np.int64)
    edges = np.unique(np.sort(np.concatenate([faces[:, :2], faces[:, 1:], faces[:, ::2]]), axis=1), axis=0)
    a, b, c = (x[faces[:, k]] for k in range(3))
    p, q = x[edges[:, 0]], x[edges[:, 1]]
    # A triangle can meet an edge only where its middle is no farther than half the one and the whole of the other.
    found = nearest(0.5 * (p + q), (a + b + c) / 3.0, min(NEAR, len(faces)))[1]
    e, f = np.repeat(np.arange(len(edges)), found.shape[1]), found.ravel()
    apart = (faces[f][:, :, None] != edges[e][:, None, :]).all((1, 2))
    e, f = e[apart], f[apart]

    def side(u: Array, v: Array, w: Array, t: Array) -> Array:
        return np.asarray(np.sign((np.cross(v - u, w - u) * (t - u)).sum(1)))

    below, above = side(a[f], b[f], c[f], p[e]), side(a[f], b[f], c[f], q[e])
    ahead = below * above < 0.0
    e, f = e[ahead], f[ahead]
    ab, bc, ca = side(p[e], q[e], a[f], b[f]), side(p[e], q[e], b[f], c[f]), side(p[e], q[e], c[f], a[f])
    return np.unique(f[(ab == bc) & (bc == ca) & (ab != 0.0)])

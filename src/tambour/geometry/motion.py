"""Motion: the turn and shift that bring points onto points, and the main axes of points.

By Jacobi's rotations, in one order of sums: no vendor's linear algebra, whose last bits differ between processors.
"""

from __future__ import annotations

import math

import numpy as np

from tambour.core.arrays import F8x2
from tambour.core.check import Array
from tambour.core.kernels import kernel

SWEEPS = 30
"""Jacobi's sweeps at the most; four or five reach the last bit of so small a matrix."""
ALIKE = 1e-9
"""Shares of the largest eigenvalue that two of them may differ by and still be one."""


@kernel
def _jacobi(A: F8x2, V: F8x2, sweeps: int) -> None:
    """Turn the symmetric matrix A into its eigenvalues on the diagonal, and V, the identity, into its eigenvectors."""
    n = len(A)
    for _ in range(sweeps):
        off = 0.0
        for p in range(n):
            for q in range(p + 1, n):
                off += A[p, q] * A[p, q]
        if off == 0.0:
            return
        for p in range(n):
            for q in range(p + 1, n):
                if A[p, q] == 0.0:
                    continue
                theta = (A[q, q] - A[p, p]) / (2.0 * A[p, q])
                t = 1.0 / (abs(theta) + math.sqrt(theta * theta + 1.0))
                t = -t if theta < 0.0 else t
                c = 1.0 / math.sqrt(t * t + 1.0)
                s = t * c
                for k in range(n):
                    a, b = A[k, p], A[k, q]
                    A[k, p], A[k, q] = c * a - s * b, s * a + c * b
                for k in range(n):
                    a, b = A[p, k], A[q, k]
                    A[p, k], A[q, k] = c * a - s * b, s * a + c * b
                for k in range(n):
                    a, b = V[k, p], V[k, q]
                    V[k, p], V[k, q] = c * a - s * b, s * a + c * b
                A[p, q] = A[q, p] = 0.0


def eigen(symmetric: Array) -> tuple[Array, Array]:
    """Eigenvalues (n,), the largest first, and unit eigenvectors as rows (n, n); each one's largest entry is positive."""
    A, V = np.array(symmetric, np.float64), np.eye(len(symmetric))
    _jacobi(A, V, SWEEPS)
    order = np.argsort(-np.diag(A), kind="stable")
    rows = V.T[order]
    sign = np.sign(rows[np.arange(len(rows)), abs(rows).argmax(1)])
    return np.diag(A)[order], np.ascontiguousarray(rows * sign[:, None])


def axes(x: Array) -> tuple[Array, Array]:
    """The spread (3,) of points x (K, 3) along their main axes, the widest first, and those axes as rows (3, 3)."""
    r = x - x.mean(0)
    value, rows = eigen((r[:, :, None] * r[:, None, :]).sum(0))
    return np.sqrt(np.maximum(value, 0.0)), rows


def turned(x: Array, turn: Array) -> Array:
    """Points or directions (…, 3) turned by a matrix (3, 3): R x, its products added one after the other."""
    return np.asarray(x[..., 0:1] * turn[:, 0] + x[..., 1:2] * turn[:, 1] + x[..., 2:3] * turn[:, 2])


def dot(a: Array, b: Array) -> Array:
    """The scalar product of directions a and b (…, 3), its products added one after the other."""
    return np.asarray(a[..., 0] * b[..., 0] + a[..., 1] * b[..., 1] + a[..., 2] * b[..., 2])


def length(a: Array) -> Array:
    """The length of a (…, 3)."""
    return np.asarray(np.sqrt(dot(a, a)))


def least_squares(terms: Array, values: Array) -> Array:
    """The nearest (K,) to ``values`` that a sum of few ``terms`` (K, n) comes, by the main axes of their products."""
    value, rows = eigen((terms[:, :, None] * terms[:, None, :]).sum(0))
    made = np.zeros(len(values))
    for size, row in zip(value, rows):
        if size > ALIKE * value[0]:
            way = (terms * row).sum(1)
            made += (way * values).sum() / size * way
    return made


def fit(moving: Array, fixed: Array, weight: Array) -> tuple[Array, Array]:
    """The rotation R and shift t that bring ``moving`` nearest to ``fixed`` (both (K, 3)): x → R x + t.

    Horn, "Closed-form solution of absolute orientation using unit quaternions" (1987), without reflections. Where
    several turns serve as well (points in one place or on one line) the smallest is taken.
    """
    w = (weight / weight.sum())[:, None]
    a, b = (w * moving).sum(0), (w * fixed).sum(0)
    S = ((w * (moving - a))[:, :, None] * (fixed - b)[:, None, :]).sum(0)
    N = np.empty((4, 4))
    N[1:, 1:] = S + S.T - S.trace() * np.eye(3)
    N[0, 0] = S.trace()
    N[0, 1:] = N[1:, 0] = S[1, 2] - S[2, 1], S[2, 0] - S[0, 2], S[0, 1] - S[1, 0]
    value, rows = eigen(N)
    best = rows[value >= value[0] - ALIKE * abs(value).max()]
    q = (best[:, :1] * best).sum(0)
    size = math.sqrt((q * q).sum())
    w0, x, y, z = q / size if size > ALIKE else best[0]
    turn = np.array(
        [
            [w0 * w0 + x * x - y * y - z * z, 2 * (x * y - w0 * z), 2 * (x * z + w0 * y)],
            [2 * (x * y + w0 * z), w0 * w0 - x * x + y * y - z * z, 2 * (y * z - w0 * x)],
            [2 * (x * z - w0 * y), 2 * (y * z + w0 * x), w0 * w0 - x * x - y * y + z * z],
        ]
    )
    return turn, b - turned(a, turn)

"""Settle: the shape at rest under exactly the forces of the plain steps, by preconditioned quasi-Newton moves.

The forces are not all a potential's (single loops push without reaction, centroids move after the nodes), so moves
are judged by forces alone: L-BFGS (Liu & Nocedal 1989), its first guess the inverse of the fabric's graph Laplacian,
which is what the springs look like to a long wave; a move is shortened when it carries past where the forces turn.
Rigid motion of a piece is no change of shape and is left out. Sums run in a fixed order: same bytes for any threads.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from tambour.core.arrays import F8x1, F8x2, I8x1
from tambour.core.check import Array
from tambour.core.kernels import kernel
from tambour.crochet.settle.body import Body, State, displacement

MEMORY = 10
"""Moves remembered."""
CAP = 0.5
"""The farthest that a node moves at once, in stitches: less than would carry it through fabric."""
SOFT = 1e-3
"""Stiffness of the ground in the preconditioner, which makes it invertible."""
SURE = 1e-3
"""The rms length of the quasi-Newton move, in stitches, below which the shape is taken to be at rest."""


@dataclass(frozen=True, slots=True)
class Rest:
    """How settling ended: the largest residual force, the rms of the last move, both in stitches; evaluations."""

    residual: float
    move: float
    evaluations: int
    settled: bool


def tolerance(n: int) -> float:
    """The default residual for n nodes: longer waves are softer, so larger pieces need a smaller one."""
    return 3e-4 * min(1.0, math.sqrt(20000.0 / max(n, 1)))


def budget(n: int) -> int:
    """The most evaluations for n nodes: enough for every piece that settles, bounded for those that do not."""
    n = max(n, 1)
    return int(min(max(1_500_000 / n, min(300, 6_000_000 / n)), 3000))


@kernel
def dot(a: F8x1, b: F8x1) -> float:
    """Sum of products in a fixed order; eight sums side by side for speed."""
    n = len(a) - len(a) % 8
    s0, s1, s2, s3, s4, s5, s6, s7 = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    for i in range(0, n, 8):
        s0 += a[i] * b[i]
        s1 += a[i + 1] * b[i + 1]
        s2 += a[i + 2] * b[i + 2]
        s3 += a[i + 3] * b[i + 3]
        s4 += a[i + 4] * b[i + 4]
        s5 += a[i + 5] * b[i + 5]
        s6 += a[i + 6] * b[i + 6]
        s7 += a[i + 7] * b[i + 7]
    for i in range(n, len(a)):
        s0 += a[i] * b[i]
    return ((s0 + s1) + (s2 + s3)) + ((s4 + s5) + (s6 + s7))


@kernel
def newest_first(S: F8x2, Y: F8x2, rho: F8x1, order: I8x1, q: F8x1, a: F8x1) -> None:
    """The first half of the two-loop recursion, on q in place; a keeps its coefficients."""
    for t in range(len(order) - 1, -1, -1):
        k = order[t]
        a[k] = rho[k] * dot(S[k], q)
        for i in range(len(q)):
            q[i] -= a[k] * Y[k, i]


@kernel
def oldest_first(S: F8x2, Y: F8x2, rho: F8x1, order: I8x1, z: F8x1, a: F8x1) -> None:
    """The second half, on z in place."""
    for t in range(len(order)):
        k = order[t]
        b = a[k] - rho[k] * dot(Y[k], z)
        for i in range(len(z)):
            z[i] += b * S[k, i]


@kernel
def _moments(x: F8x2, D: F8x2, label: I8x1, out: F8x2) -> None:
    """Per piece: nodes, Σx, ΣD, then about the mean the six of Σ r rᵀ and the torque Σ r × D; out (K, 16)."""
    out[:] = 0.0
    for i in range(len(x)):
        k = label[i]
        out[k, 0] += 1.0
        for q in range(3):
            out[k, 1 + q] += x[i, q]
            out[k, 4 + q] += D[i, q]
    for i in range(len(x)):
        k = label[i]
        n = out[k, 0]
        rx, ry, rz = x[i, 0] - out[k, 1] / n, x[i, 1] - out[k, 2] / n, x[i, 2] - out[k, 3] / n
        dx, dy, dz = D[i, 0], D[i, 1], D[i, 2]
        out[k, 7] += rx * rx
        out[k, 8] += ry * ry
        out[k, 9] += rz * rz
        out[k, 10] += rx * ry
        out[k, 11] += rx * rz
        out[k, 12] += ry * rz
        out[k, 13] += ry * dz - rz * dy
        out[k, 14] += rz * dx - rx * dz
        out[k, 15] += rx * dy - ry * dx


@kernel
def _still(x: F8x2, label: I8x1, moments: F8x2, spin: F8x2, D: F8x2) -> None:
    """Take the pieces' mean motion and their spin (K, 3) out of D."""
    for i in range(len(x)):
        k = label[i]
        n = moments[k, 0]
        rx, ry, rz = x[i, 0] - moments[k, 1] / n, x[i, 1] - moments[k, 2] / n, x[i, 2] - moments[k, 3] / n
        D[i, 0] -= moments[k, 4] / n + spin[k, 1] * rz - spin[k, 2] * ry
        D[i, 1] -= moments[k, 5] / n + spin[k, 2] * rx - spin[k, 0] * rz
        D[i, 2] -= moments[k, 6] / n + spin[k, 0] * ry - spin[k, 1] * rx


def rigid(x: Array, D: Array, label: Array) -> Array:
    """D (N, 3) less the rigid motion, translation and small rotation, of every piece; label (N,) numbers them."""
    out = D.copy()
    moments = np.zeros((int(label.max(initial=-1)) + 1, 16))
    _moments(x, D, label, moments)
    spin = np.zeros((len(moments), 3))
    for k, (n, xx, yy, zz, xy, xz, yz, *torque) in enumerate(moments[:, [0, *range(7, 16)]].tolist()):
        if n > 2 and xx + zz > 0.0 and not (yy or xy or yz or torque[0] or torque[2]):
            spin[k, 1] = torque[1] / (xx + zz)  # what lies flat stays flat, to the last bit
        elif n > 2:
            inertia = np.array([[yy + zz, -xy, -xz], [-xy, xx + zz, -yz], [-xz, -yz, xx + yy]])
            spin[k] = np.linalg.lstsq(inertia, np.array(torque), rcond=1e-9)[0]
    _still(x, label, moments, spin, out)
    return out


def laplacian(body: Body) -> Callable[[Array], Array]:
    """The preconditioner: solves (L + soft) z = q for three columns, L the Laplacian of the fabric's edges."""
    from scipy.sparse import coo_matrix, diags, eye
    from scipy.sparse.linalg import splu

    n = len(body)
    i, j = body.edges[:, 0], body.edges[:, 1]
    weight = 0.2 if body.cubic else 1.0
    half = coo_matrix((np.full(len(i), weight), (i, j)), shape=(n, n))
    W = (half + half.T).tocsr()
    L = (diags(np.asarray(W.sum(1)).ravel()) - W + SOFT * eye(n)).tocsc()
    factor = splu(L, permc_spec="MMD_AT_PLUS_A", options={"SymmetricMode": True}, diag_pivot_thresh=0.0)
    return lambda q: factor.solve(q.reshape(-1, 3)).ravel()


def settle(
    body: Body,
    state: State,
    goal: float | None = None,
    most: int | None = None,
    tell: Callable[[int, int], None] = lambda done, total: None,
) -> Rest:
    """Bring ``state`` to rest.

    goal : largest residual force in stitches; None takes :func:`tolerance` and asks for a short last move as well
    most : evaluations at the most; None takes :func:`budget`, and four times it for a goal that was set
    """
    n = len(body)
    if n < 2:
        return Rest(0.0, 0.0, 0, True)
    wanted, limit = (tolerance(n) if goal is None else goal), most
    if limit is None:
        limit = budget(n) * (1 if goal is None else 4)
    _, label = np.unique(body.root, return_inverse=True)
    solve = laplacian(body)
    full = (body.pressure > 0.0) & (body.stuffing == "pressure")
    S, Y, rho, a = np.zeros((MEMORY, 3 * n)), np.zeros((MEMORY, 3 * n)), np.zeros(MEMORY), np.zeros(MEMORY)
    order: list[int] = []
    begun, scale, accepted = state.evaluations, 1.0, 0
    G = rigid(state.x, displacement(body, state), label).ravel()
    residual, move = _largest(G), math.inf
    while True:
        z = G.copy()
        ranks = np.array(order, np.int64)
        newest_first(S, Y, rho, ranks, z, a)
        z = solve(z) * scale
        oldest_first(S, Y, rho, ranks, z, a)
        slope = dot(G, z)
        if slope <= 0.0:
            order = []
            z = solve(G) * scale
            slope = dot(G, z)
        move = math.sqrt(dot(z, z) / n)
        spent = state.evaluations - begun
        settled = residual <= wanted and (goal is not None or move <= SURE)
        if settled or spent >= limit or slope <= 0.0:
            return Rest(residual, move, spent, settled)
        longest = _largest(z)
        if longest > CAP:
            z *= CAP / longest
            slope *= CAP / longest
        x, c, volume, t = state.x, state.c, state.volume.copy(), 1.0
        for _ in range(6):
            state.x, state.c = x + t * z.reshape(-1, 3), c.copy()
            new = rigid(state.x, displacement(body, state), label).ravel()
            turned = dot(new, z)
            burst = full & (volume > body.least) & (state.volume < 0.3 * volume)
            if turned > -0.5 * slope and not burst.any():
                break
            t *= min(max(slope / (slope - turned), 0.1), 0.7) if turned < slope else 0.5
        z *= t
        y = G - new
        bent = dot(z, y)
        if bent > 1e-10 * dot(z, z):
            k = order.pop(0) if len(order) == MEMORY else len(order)
            S[k], Y[k], rho[k] = z, y, 1.0 / bent
            order.append(k)
            if accepted % 4 == 0:
                scale = bent / dot(y, solve(y))
        accepted += 1
        G = new
        residual = _largest(G)
        tell(min(spent, limit), limit)


@kernel
def _largest(v: F8x1) -> float:
    most = 0.0
    for i in range(0, len(v), 3):
        most = max(most, v[i] * v[i] + v[i + 1] * v[i + 1] + v[i + 2] * v[i + 2])
    return math.sqrt(most)

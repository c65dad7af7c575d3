"""Settle: the shape at rest under exactly the forces of the plain steps, by preconditioned quasi-Newton moves.

The forces are not all a potential's (centroids move after the nodes, seams lie on fabric), so moves
are judged by forces alone: L-BFGS (Liu & Nocedal 1989), its first guess the inverse of the fabric's graph Laplacian,
which is what the springs look like to a long wave; a move is shortened when it carries past where the forces turn.
Rigid motion of a piece is no change of shape and is left out. Sums run in a fixed order: same bytes for any threads.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Generator
from dataclasses import dataclass

import numpy as np

from tambour.core.arrays import B1x1, F8x1, F8x2, I8x1
from tambour.core.check import Array
from tambour.core.kernels import kernel
from tambour.crochet.settle.body import Body, State, displacement

MEMORY = 10
"""Moves remembered."""
CAP = 0.5
"""The farthest that a node moves at once, in stitches: less than would carry it through fabric."""
SOFT = 1e-3
"""Stiffness of the ground in the preconditioner, which makes it invertible."""
HELD = 1e9
"""The same below a node that is held."""
SEWN = 2
"""How many times as long a piece with seams may take: they lie on now this triangle of the fabric, now that."""
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
def rigid(x: F8x2, label: I8x1, loose: B1x1, D: F8x2) -> None:
    """Take the rigid motion, translation and small rotation, of every loose piece out of D (N, 3).

    label : (N,) numbers the pieces; loose : (K,) whether a piece is free to move as a whole
    """
    m = np.zeros((len(loose), 16))  # nodes, Σx, ΣD, then about the mean the six of Σ r rᵀ and the torque Σ r × D
    spin = np.zeros((len(loose), 3))
    i = 0
    while i < len(x):  # sums of a run of nodes of one piece are held apart until it ends
        k = label[i]
        n, ax, ay, az, bx, by, bz = m[k, 0], m[k, 1], m[k, 2], m[k, 3], m[k, 4], m[k, 5], m[k, 6]
        while i < len(x) and label[i] == k:
            n += 1.0
            ax, ay, az = ax + x[i, 0], ay + x[i, 1], az + x[i, 2]
            bx, by, bz = bx + D[i, 0], by + D[i, 1], bz + D[i, 2]
            i += 1
        m[k, 0], m[k, 1], m[k, 2], m[k, 3], m[k, 4], m[k, 5], m[k, 6] = n, ax, ay, az, bx, by, bz
    i = 0
    while i < len(x):
        k = label[i]
        n = m[k, 0]
        cx, cy, cz = m[k, 1] / n, m[k, 2] / n, m[k, 3] / n
        xx, yy, zz, xy, xz, yz = m[k, 7], m[k, 8], m[k, 9], m[k, 10], m[k, 11], m[k, 12]
        tx, ty, tz = m[k, 13], m[k, 14], m[k, 15]
        while i < len(x) and label[i] == k:
            rx, ry, rz = x[i, 0] - cx, x[i, 1] - cy, x[i, 2] - cz
            dx, dy, dz = D[i, 0], D[i, 1], D[i, 2]
            xx, yy, zz = xx + rx * rx, yy + ry * ry, zz + rz * rz
            xy, xz, yz = xy + rx * ry, xz + rx * rz, yz + ry * rz
            tx, ty, tz = tx + (ry * dz - rz * dy), ty + (rz * dx - rx * dz), tz + (rx * dy - ry * dx)
            i += 1
        m[k, 7], m[k, 8], m[k, 9], m[k, 10], m[k, 11], m[k, 12] = xx, yy, zz, xy, xz, yz
        m[k, 13], m[k, 14], m[k, 15] = tx, ty, tz
    for k in range(len(loose)):
        xx, yy, zz, xy, xz, yz = m[k, 7], m[k, 8], m[k, 9], m[k, 10], m[k, 11], m[k, 12]
        tx, ty, tz = m[k, 13], m[k, 14], m[k, 15]
        # The inertia's cofactors: spin = inertia⁻¹ torque.
        a, b, c = yy + zz, xx + zz, xx + yy
        aa, bb, cc = b * c - yz * yz, a * c - xz * xz, a * b - xy * xy
        ab, ac, bc = xy * c + xz * yz, xz * b + xy * yz, yz * a + xy * xz
        det = a * aa - xy * ab - xz * ac
        trace = a + b + c
        if trace == 0.0:
            continue
        if det > 1e-9 * trace * trace * trace:
            spin[k, 0] = (aa * tx + ab * ty + ac * tz) / det
            spin[k, 1] = (ab * tx + bb * ty + bc * tz) / det
            spin[k, 2] = (ac * tx + bc * ty + cc * tz) / det
        else:  # all on one line: no torque about it, half the trace across it
            spin[k, 0], spin[k, 1], spin[k, 2] = 2.0 * tx / trace, 2.0 * ty / trace, 2.0 * tz / trace
    for k in range(len(loose)):  # the means in place of the sums
        n = max(m[k, 0], 1.0)
        for q in range(1, 7):
            m[k, q] /= n
    for i in range(len(x)):
        k = label[i]
        if not loose[k]:
            continue
        rx, ry, rz = x[i, 0] - m[k, 1], x[i, 1] - m[k, 2], x[i, 2] - m[k, 3]
        D[i, 0] -= m[k, 4] + spin[k, 1] * rz - spin[k, 2] * ry
        D[i, 1] -= m[k, 5] + spin[k, 2] * rx - spin[k, 0] * rz
        D[i, 2] -= m[k, 6] + spin[k, 0] * ry - spin[k, 1] * rx


def laplacian(body: Body, held: Array) -> Callable[[Array], Array]:
    """The preconditioner: solves (L + soft) z = q for three columns, L the Laplacian of the fabric's edges.

    held : (N,) bool, nodes that do not move
    """
    from tambour.crochet.settle.contact import ragged
    from tambour.crochet.settle.factor import factor

    stiff = 0.2 if body.cubic else 1.0
    pairs = np.concatenate([body.edges, body.threads])
    offsets, neighbours = ragged(len(body), pairs, np.zeros(len(pairs), bool))
    diagonal = stiff * np.diff(offsets) + np.where(held, HELD, SOFT)
    return factor(offsets, neighbours, np.full(len(neighbours), stiff), diagonal)


def settle(
    body: Body,
    state: State,
    goal: float | None = None,
    most: int | None = None,
    held: Array | None = None,
    solve: Callable[[Array], Array] | None = None,
) -> Generator[tuple[int, int], None, Rest]:
    """Bring ``state`` to rest; a generator, so that whoever runs it can look at ``state.x`` after every move.

    goal : largest residual force in stitches; None takes :func:`tolerance` and asks for a short last move as well
    most : evaluations at the most; None takes :func:`budget`, SEWN times it where parts are sewn on, and four times it for a goal that was set
    held : (N,) bool, nodes that stay where they are; solve : the :func:`laplacian` of the same edges, if there is one

    Yields the evaluations so far and the most there will be, after every accepted move; returns how it ended.
    """
    n = len(body)
    if n < 2:
        return Rest(0.0, 0.0, 0, True)
    wanted, limit = (tolerance(n) if goal is None else goal), most
    if limit is None:
        limit = budget(n) * (4 if goal is not None else SEWN if len(body.lying) else 1)
    fixed = np.zeros(n, bool) if held is None else held
    _, label = np.unique(body.root, return_inverse=True)
    loose = np.bincount(label, fixed) == 0.0
    still = np.repeat(~fixed, 3).astype(np.float64)
    factored = laplacian(body, fixed) if solve is None else solve

    def forces() -> Array:
        D = displacement(body, state, held=fixed)
        rigid(state.x, label, loose, D)
        return D.ravel()

    def preconditioned(q: Array) -> Array:
        return factored(q) * still

    full = (body.pressure > 0.0) & (body.stuffing == "pressure")
    S, Y, rho, a = np.zeros((MEMORY, 3 * n)), np.zeros((MEMORY, 3 * n)), np.zeros(MEMORY), np.zeros(MEMORY)
    order: list[int] = []
    begun, scale, accepted = state.evaluations, 1.0, 0
    G = forces()
    residual, move = _largest(G), math.inf
    while True:
        z = G.copy()
        ranks = np.array(order, np.int64)
        newest_first(S, Y, rho, ranks, z, a)
        z = preconditioned(z) * scale
        oldest_first(S, Y, rho, ranks, z, a)
        slope = dot(G, z)
        if slope <= 0.0:
            order = []
            z = preconditioned(G) * scale
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
            new = forces()
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
                scale = bent / dot(y, preconditioned(y))
        accepted += 1
        G = new
        residual = _largest(G)
        yield min(spent, limit), limit


@kernel
def _largest(v: F8x1) -> float:
    most = 0.0
    for i in range(0, len(v), 3):
        most = max(most, v[i] * v[i] + v[i + 1] * v[i + 1] + v[i + 2] * v[i + 2])
    return math.sqrt(most)

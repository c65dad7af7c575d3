"""Forces of the fabric itself: along its edges, and of stitches worked into one loop.

Everything here is in stitches (the stitch's width is 1); forces are displacements per step, as the seed has them
(section "Simulation overview"): each kernel adds to D, and positions move only when all of D is known.
"""

from __future__ import annotations

import math

import numpy as np

from tambour.core.arrays import F8x1, F8x2, I4x1, I4x2
from tambour.core.check import Array
from tambour.core.kernels import kernel

LEAN = 0.3
"""How far, in stitches, a stitch in one loop leans to that loop's side; as far on the other side it is let be."""


@kernel
def link(x: F8x2, edges: I4x2, rest: F8x1, cubic: bool, D: F8x2) -> None:
    """Add the link force of every edge to D (N, 3).

    x : (N, 3) positions; edges : (E, 2); rest : (E,) the distance d at which the two nodes leave each other alone
    cubic : the seed's law ((r - d) / (r/2 + d))³ (section "Link force"), else the spring r - d

    Nodes in one place (r = 0) have no direction and leave each other alone.
    """
    for e in range(len(edges)):
        i, j = edges[e, 0], edges[e, 1]
        dx, dy, dz = x[i, 0] - x[j, 0], x[i, 1] - x[j, 1], x[i, 2] - x[j, 2]
        r = math.sqrt(dx * dx + dy * dy + dz * dz)
        if r == 0.0:
            continue
        t = r - rest[e]
        if cubic:
            t /= 0.5 * r + rest[e]
            t = t * t * t
        t /= r
        dx, dy, dz = dx * t, dy * t, dz * t
        D[i, 0] -= dx
        D[i, 1] -= dy
        D[i, 2] -= dz
        D[j, 0] += dx
        D[j, 1] += dy
        D[j, 2] += dz


@kernel
def against(root: I4x1, D: F8x2) -> None:
    """Take from every node's D (N, 3) what its root has."""
    own = D.copy()
    for i in range(len(D)):
        k = root[i]
        D[i, 0], D[i, 1], D[i, 2] = own[i, 0] - own[k, 0], own[i, 1] - own[k, 1], own[i, 2] - own[k, 2]


@kernel
def thread(x: F8x2, threads: I4x2, most: F8x1, D: F8x2) -> None:
    """Pull on the ends of every thread (K, 2) that is longer than its ``most`` (K,), as a spring would; a slack one does nothing."""
    for k in range(len(threads)):
        i, j = threads[k, 0], threads[k, 1]
        dx, dy, dz = x[i, 0] - x[j, 0], x[i, 1] - x[j, 1], x[i, 2] - x[j, 2]
        r = math.sqrt(dx * dx + dy * dy + dz * dz)
        if r <= most[k]:
            continue
        t = (r - most[k]) / r
        D[i, 0] -= dx * t
        D[i, 1] -= dy * t
        D[i, 2] -= dz * t
        D[j, 0] += dx * t
        D[j, 1] += dy * t
        D[j, 2] += dz * t


@kernel
def single_loop(x: F8x2, nodes: I4x1, planes: I4x2, strength: F8x1, D: F8x2) -> None:
    """Push each node worked into one loop along its plane's normal (seed, "Handling front-loop-only …").

    nodes : (L,); planes : (L, 3) nodes a, b, c with the normal (b - a) × (c - a); strength : (L,) signed
    There is no reaction, and three points on one line push nothing.
    """
    for k in range(len(nodes)):
        a, b, c = planes[k, 0], planes[k, 1], planes[k, 2]
        ux, uy, uz = x[b, 0] - x[a, 0], x[b, 1] - x[a, 1], x[b, 2] - x[a, 2]
        vx, vy, vz = x[c, 0] - x[a, 0], x[c, 1] - x[a, 1], x[c, 2] - x[a, 2]
        nx, ny, nz = uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx
        length = math.sqrt(nx * nx + ny * ny + nz * nz)
        if length > 0.0:
            s = strength[k] / length
            i = nodes[k]
            D[i, 0] += nx * s
            D[i, 1] += ny * s
            D[i, 2] += nz * s


@kernel
def fold(x: F8x2, nodes: I4x1, planes: I4x2, strength: F8x1, D: F8x2) -> None:
    """Fold fabric where it is worked into one loop, towards the side of that loop, as a hinge does.

    nodes, planes, strength : as of :func:`single_loop`, the same push on the stitch; but the fabric that it stands on
    answers, and it fades as the stitch leans, LEAN to either side: a fold that the work makes is neither undone nor
    driven on. So it belongs to an energy. Where the plane has next to no area it has no side.
    """
    n = np.empty(3)
    for k in range(len(nodes)):
        i, a, b, c = nodes[k], planes[k, 0], planes[k, 1], planes[k, 2]
        ux, uy, uz = x[b, 0] - x[a, 0], x[b, 1] - x[a, 1], x[b, 2] - x[a, 2]
        vx, vy, vz = x[c, 0] - x[a, 0], x[c, 1] - x[a, 1], x[c, 2] - x[a, 2]
        n[0], n[1], n[2] = uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx
        area2 = n[0] * n[0] + n[1] * n[1] + n[2] * n[2]
        if area2 < 0.01 * (ux * ux + uy * uy + uz * uz) * (vx * vx + vy * vy + vz * vz):
            continue
        px, py, pz = x[i, 0] - x[a, 0], x[i, 1] - x[a, 1], x[i, 2] - x[a, 2]
        wb = ((py * vz - pz * vy) * n[0] + (pz * vx - px * vz) * n[1] + (px * vy - py * vx) * n[2]) / area2
        wc = ((uy * pz - uz * py) * n[0] + (uz * px - ux * pz) * n[1] + (ux * py - uy * px) * n[2]) / area2
        size = math.sqrt(area2)
        height = (px * n[0] + py * n[1] + pz * n[2]) / size
        s = strength[k] / size * max(1.0 - abs(height) / LEAN, 0.0)
        for q in range(3):
            D[i, q] += s * n[q]
            D[a, q] -= (1.0 - wb - wc) * s * n[q]
            D[b, q] -= wb * s * n[q]
            D[c, q] -= wc * s * n[q]


@kernel
def bend(x: F8x2, triples: I4x2, stiffness: F8x1, D: F8x2) -> None:
    """Keep a → b → c straight: energy ½ s |a - 2b + c|², with triples (T, 3) and stiffness s (T,)."""
    for t in range(len(triples)):
        a, b, c = triples[t, 0], triples[t, 1], triples[t, 2]
        for q in range(3):
            f = stiffness[t] * (x[a, q] - 2.0 * x[b, q] + x[c, q])
            D[a, q] -= f
            D[b, q] += 2.0 * f
            D[c, q] -= f


@kernel
def flat(x: F8x2, hinges: I4x2, weights: F8x2, stiffness: float, D: F8x2) -> None:
    """Keep four points in one plane: energy ½ s |Σ w x|², with hinges (H, 4) and weights (H, 4) whose sum is nothing, as is
    that of the points where they lie flat: in the plane itself nothing is pulled (Bergou et al. 2006)."""
    for h in range(len(hinges)):
        for q in range(3):
            off = 0.0
            for k in range(4):
                off += weights[h, k] * x[hinges[h, k], q]
            for k in range(4):
                D[hinges[h, k], q] -= stiffness * weights[h, k] * off


def lengths(x: Array, edges: Array) -> Array:
    """The length of every edge (E,)."""
    return np.sqrt(((x[edges[:, 0]] - x[edges[:, 1]]) ** 2).sum(1))

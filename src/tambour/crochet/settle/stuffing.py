"""Stuffing: what presses the fabric outwards. Three ways: moving centroids, a skeleton of the rounds, pressure."""

from __future__ import annotations

import math

import numpy as np

from tambour.core.arrays import F8x1, F8x2, I4x1, I4x2, I8x1
from tambour.core.kernels import inner, kernel

LOFT = 0.1
"""The share of its loose volume over which fibre comes to press fully when it is squeezed."""


@kernel
def centroids(
    x: F8x2,
    owner: I4x1,
    first: I8x1,
    c: F8x2,
    force: float,
    cap: float,
    b: float,
    w: float,
    amount: F8x1,
    D: F8x2,
) -> None:
    """Push every node from every centroid of its part, then move the centroids (seed, "Centroid stuffing").

    x : (N, 3); owner : (N,) part; first : (P + 1,) each part's centroids are c[first[p]:first[p + 1]]
    c : (C, 3) centroids, moved in place to the weighted mean of the nodes that they are nearest to, with the weight
        exp(-(ln r - b)² / w²)
    force, cap : the push is amount * force * min(1 / r², cap), away from the centroid; amount : (P,)

    A centroid that is nearest to no node, or whose weights are all zero, stays.
    """
    weight = np.zeros(len(c))
    total = np.zeros((len(c), 3))
    for i in range(len(x)):
        p = owner[i]
        nearest, best = -1, np.inf
        for k in range(first[p], first[p + 1]):
            dx, dy, dz = x[i, 0] - c[k, 0], x[i, 1] - c[k, 1], x[i, 2] - c[k, 2]
            r2 = dx * dx + dy * dy + dz * dz
            if r2 < best:
                nearest, best = k, r2
            if r2 > 0.0:
                s = amount[p] * force * min(1.0 / r2, cap) / math.sqrt(r2)
                D[i, 0] += dx * s
                D[i, 1] += dy * s
                D[i, 2] += dz * s
        if nearest >= 0 and best > 0.0:
            u = (0.5 * math.log(best) - b) / w
            u = math.exp(-u * u)
            weight[nearest] += u
            for q in range(3):
                total[nearest, q] += u * x[i, q]
    for k in range(len(c)):
        if weight[k] > 0.0:
            for q in range(3):
                c[k, q] = total[k, q] / weight[k]


@kernel
def sections(x: F8x2, offsets: I8x1, members: I4x1, neighbours: I4x2, passes: int, out: F8x2) -> None:
    """Centres (S, 3) of the skeleton's sections: means of their nodes, then smoothed ``passes`` times.

    offsets, members : ragged nodes of each section; neighbours : (S, 2) sections before and after, -1 for none
    A section with both neighbours becomes half itself and a quarter of each; ends stay.
    """
    for s in range(len(out)):
        out[s] = 0.0
        for k in range(offsets[s], offsets[s + 1]):
            for q in range(3):
                out[s, q] += x[members[k], q]
        for q in range(3):
            out[s, q] /= offsets[s + 1] - offsets[s]
    old = np.empty_like(out)
    for _ in range(passes):
        old[:] = out
        for s in range(len(out)):
            a, b = neighbours[s, 0], neighbours[s, 1]
            if a >= 0 and b >= 0:
                for q in range(3):
                    out[s, q] = 0.5 * old[s, q] + 0.25 * (old[a, q] + old[b, q])


@kernel
def skeleton(
    x: F8x2,
    owner: I4x1,
    first: I8x1,
    centres: F8x2,
    radius: F8x1,
    force: float,
    cap: float,
    amount: F8x1,
    D: F8x2,
) -> None:
    """Push every node from every section centre of its part: amount * force / R * min((R / r)², cap).

    x : (N, 3); owner : (N,) part; first : (P + 1,) each part's sections; centres : (S, 3)
    radius : (S,) the radius R that the section's round wants
    """
    for i in range(len(x)):
        p = owner[i]
        for k in range(first[p], first[p + 1]):
            dx, dy, dz = x[i, 0] - centres[k, 0], x[i, 1] - centres[k, 1], x[i, 2] - centres[k, 2]
            r2 = dx * dx + dy * dy + dz * dz
            if r2 > 0.0:
                s = amount[p] * force / radius[k] * min(radius[k] * radius[k] / r2, cap) / math.sqrt(r2)
                D[i, 0] += dx * s
                D[i, 1] += dy * s
                D[i, 2] += dz * s


@inner
def _corners(x: F8x2, apex: F8x2, faces: I4x2, f: int, p: F8x1) -> None:
    """The corners of a face, nine numbers; those from len(x) on are the middles of lids."""
    for k in range(3):
        v = faces[f, k]
        if v < len(x):
            p[3 * k], p[3 * k + 1], p[3 * k + 2] = x[v, 0], x[v, 1], x[v, 2]
        else:
            v -= len(x)
            p[3 * k], p[3 * k + 1], p[3 * k + 2] = apex[v, 0], apex[v, 1], apex[v, 2]


@kernel
def pressure(
    x: F8x2,
    faces: I4x2,
    face_part: I4x1,
    lid_offsets: I8x1,
    lid_nodes: I4x1,
    amount: F8x1,
    least: F8x1,
    most: F8x1,
    volume: F8x1,
    D: F8x2,
) -> None:
    """Press outwards: add amount / V * dV/dx, the force of the energy -amount ln V, part by part.

    Fibre has a volume of its own: from (1 - LOFT) ``most`` on it presses less and less, at ``most`` (P,) it lies loose.

    faces : (F, 3), counter-clockwise outside; a corner of index N + l is the middle of lid l's rim
    lid_offsets, lid_nodes : ragged rims; lids close the volume and have no fabric
    amount, least : (P,); where V is below ``least`` the pressure stays amount / least
    volume : (P,) out
    """
    n, lids = len(x), len(lid_offsets) - 1
    apex, pull = np.zeros((lids, 3)), np.zeros((lids, 3))
    for m in range(lids):
        for k in range(lid_offsets[m], lid_offsets[m + 1]):
            for q in range(3):
                apex[m, q] += x[lid_nodes[k], q]
        for q in range(3):
            apex[m, q] /= lid_offsets[m + 1] - lid_offsets[m]
    volume[:] = 0.0
    p = np.empty(9)
    for f in range(len(faces)):
        _corners(x, apex, faces, f, p)
        volume[face_part[f]] += (
            p[0] * (p[4] * p[8] - p[5] * p[7]) + p[1] * (p[5] * p[6] - p[3] * p[8]) + p[2] * (p[3] * p[7] - p[4] * p[6])
        ) / 6.0
    for f in range(len(faces)):
        part = face_part[f]
        if amount[part] == 0.0:
            continue
        s = amount[part] / max(volume[part], least[part]) / 6.0
        if volume[part] > (1.0 - LOFT) * most[part]:
            s *= max(most[part] - volume[part], 0.0) / (LOFT * most[part])
        _corners(x, apex, faces, f, p)
        for k in range(3):
            a, b = 3 * ((k + 1) % 3), 3 * ((k + 2) % 3)
            gx, gy, gz = (
                s * (p[a + 1] * p[b + 2] - p[a + 2] * p[b + 1]),
                s * (p[a + 2] * p[b] - p[a] * p[b + 2]),
                s * (p[a] * p[b + 1] - p[a + 1] * p[b]),
            )
            v = faces[f, k]
            if v < n:
                D[v, 0] += gx
                D[v, 1] += gy
                D[v, 2] += gz
            else:
                pull[v - n, 0] += gx
                pull[v - n, 1] += gy
                pull[v - n, 2] += gz
    for m in range(lids):
        count = lid_offsets[m + 1] - lid_offsets[m]
        for k in range(lid_offsets[m], lid_offsets[m + 1]):
            for q in range(3):
                D[lid_nodes[k], q] += pull[m, q] / count

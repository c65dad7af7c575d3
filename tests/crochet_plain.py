"""The formulas of docs/crochet-method.md once more, in plain NumPy and Python: what the kernels are held against."""

from __future__ import annotations

import math

import numpy as np

from tambour.core import graph as g


def unit(v):
    size = math.sqrt((v * v).sum())
    return v / size if size > 0 else v * 0.0


def link(x, edges, rest, cubic):
    D = np.zeros_like(x)
    for (i, j), d in zip(edges, rest):
        r = np.linalg.norm(x[i] - x[j])
        if r == 0:
            continue
        pull = ((r - d) / (r / 2 + d)) ** 3 if cubic else r - d
        D[i] -= pull * (x[i] - x[j]) / r
        D[j] += pull * (x[i] - x[j]) / r
    return D


def centroids(x, part, owners, c, f, cap, b, w, amount):
    """owners: the part of every centroid. Gives D and the centroids' new places."""
    D, nearest = np.zeros_like(x), []
    for i in range(len(x)):
        mine = [k for k in range(len(c)) if owners[k] == part[i]]
        if not mine:
            nearest.append(-1)
            continue
        distance = [np.linalg.norm(x[i] - c[k]) for k in mine]
        nearest.append(mine[int(np.argmin(distance))])
        for k, r in zip(mine, distance):
            if r > 0:
                D[i] += amount[part[i]] * f * min(1 / r**2, cap) * (x[i] - c[k]) / r
    new = c.copy()
    for k in range(len(c)):
        own = [i for i in range(len(x)) if nearest[i] == k and np.linalg.norm(x[i] - c[k]) > 0]
        weight = np.array([math.exp(-((math.log(np.linalg.norm(x[i] - c[k])) - b) ** 2) / w**2) for i in own])
        if len(own) and weight.sum() > 0:
            new[k] = (weight[:, None] * x[own]).sum(0) / weight.sum()
    return D, new


def single_loop(x, graph, strength):
    D = np.zeros_like(x)
    for i in range(len(x)):
        if graph.peculiarity[i] in (g.FLO, g.BLO) and (graph.plane[i] >= 0).all() and graph.plane[i].max() < len(x):
            a, b, c = x[graph.plane[i]]
            sign = 1.0 if graph.peculiarity[i] == g.BLO else -1.0
            D[i] += sign * strength * unit(np.cross(b - a, c - a))
    return D


def rims(faces):
    """Openings of the faces as closed walks, against the faces' own sense."""
    left = {}
    for face in faces.tolist():
        for a, b in zip(face, face[1:] + face[:1]):
            if (b, a) in left:
                left.pop((b, a))
            else:
                left[a, b] = True
    after = {b: a for a, b in left}
    walks = []
    while after:
        begin = min(after)
        walk, at = [begin], after.pop(begin)
        while at != begin:
            walk.append(at)
            at = after.pop(at)
        walks.append(walk)
    return walks


def volume_of(x, faces):
    """Signed volume within the faces and a fan over every opening, about the middle of its rim."""
    points, corners = list(x), faces.tolist()
    for walk in rims(faces):
        points.append(x[walk].mean(0))
        corners += [[a, b, len(points) - 1] for a, b in zip(walk, walk[1:] + walk[:1])]
    p = np.array(points)[np.array(corners, int).reshape(-1, 3)]
    return (p[:, 0] * np.cross(p[:, 1], p[:, 2])).sum() / 6


def pressure(x, faces, amount, least):
    """amount / V times the gradient of V, taken corner by corner; V at least ``least``. One part."""
    D = np.zeros_like(x)
    if not len(faces):
        return D
    V = volume_of(x, faces)
    shares = [(face, None) for face in faces.tolist()]
    for walk in rims(faces):
        shares += [([a, b], walk) for a, b in zip(walk, walk[1:] + walk[:1])]
    for face, walk in shares:
        corner = [x[k] for k in face] + ([x[walk].mean(0)] if walk else [])
        for k in range(3):
            grad = np.cross(corner[(k + 1) % 3], corner[(k + 2) % 3]) / 6
            if k < len(face):
                D[face[k]] += amount / max(V, least) * grad
            else:
                for node in walk:
                    D[node] += amount / max(V, least) * grad / len(walk)
    return D


def contact(x, edges, far, near, stiffness):
    n = len(x)
    beside = [set() for _ in range(max(n, int(edges.max(initial=-1)) + 1))]
    for i, j in edges.tolist():
        beside[i].add(j)
        beside[j].add(i)
    D = np.zeros_like(x)
    for i in range(n):
        for j in range(i):
            reach = near if beside[i] & beside[j] or any(beside[k] & beside[j] for k in beside[i]) else far
            r = np.linalg.norm(x[i] - x[j])
            if j in beside[i] or r >= reach or r == 0:
                continue
            push = stiffness * (reach - r) * (x[i] - x[j]) / r
            D[i] += push
            D[j] -= push
    return D


def straight(graph, n):
    """Stitch, the one before it, the one before that, along the yarn and down the rounds; not about root or tip, nor where
    the yarn turns a corner (a row's or joined round's beginning); and across the join of a round.

    A chain between stitches stands on what the stitch before it stands on, and the yarn may turn a corner there; of the
    stitches that spread from one chain only the middle one, or two, go straight on over it.
    """
    odd = (g.ROOT, g.TIP)
    chain, below = [], []
    for i in range(len(graph)):
        bare = graph.anchor_offsets[i] == graph.anchor_offsets[i + 1]
        chain.append(bool(bare and graph.peculiarity[i] != g.ROOT and graph.previous[i] >= 0))
        below.append(below[graph.previous[i]] if chain[i] else graph.parent[i])
    found, spread, along = [], {}, set()
    for i in range(len(graph)):
        j = graph.previous[i]
        k = graph.previous[j] if j >= 0 else -1
        if k >= 0 and graph.peculiarity[i] != g.TIP and graph.peculiarity[j] not in odd:
            up, under = graph.parent[i], graph.parent[j]
            corner = k in (up, under) or up == j or (up < 0 <= under)
            if not corner and not (chain[j] and below[j] >= 0):
                found.append((i, j, k))
                along.add((i, j, k))
        j = graph.parent[i]
        k = below[j] if j >= 0 else -1
        if k >= 0 and graph.peculiarity[i] != g.TIP and graph.peculiarity[j] not in odd:
            if chain[j]:
                spread.setdefault(int(j), []).append((i, j, k))
            else:
                found.append((i, j, k))
    for fan in spread.values():
        half = len(fan) / 2
        found += [fan[m] for m in range(len(fan)) if abs(m + 0.5 - half) < 1]
    found = [t for t in found if t[0] < n]
    for last, first in graph.edges[graph.edge_kind == g.JOIN]:
        if last < n and first + 1 < len(graph) and graph.previous[first + 1] == first:
            found.append((first + 1, first, last))
            along.add(found[-1])
        if last < n and graph.previous[last] >= 0:
            found.append((first, last, graph.previous[last]))
            along.add(found[-1])
    rows = (
        (graph.direction < 0).any()
        and not (graph.peculiarity == g.ROOT).any()
        and not (graph.edge_kind == g.JOIN).any()
    )
    around = [int((graph.round == graph.round[j]).sum()) for _, j, _ in found]
    return found, [1.0 if rows or t not in along else min(1.0, (m / 24) ** 2) for t, m in zip(found, around)]


def bend(x, triples, stiffness):
    D = np.zeros_like(x)
    for (a, b, c), s in zip(triples, np.broadcast_to(stiffness, len(triples))):
        f = s * (x[a] - 2 * x[b] + x[c])
        D[a] -= f
        D[b] += 2 * f
        D[c] -= f
    return D


def skeleton(x, made):
    """made: the Body, for its sections. Every node is pushed from every section's centre."""
    centres = []
    for s in range(len(made.radius)):
        members = made.members[made.section_offsets[s] : made.section_offsets[s + 1]]
        centres.append(x[members[members < len(x)]].mean(0))
    for _ in range(2):
        old = [c.copy() for c in centres]
        for s, (a, b) in enumerate(made.section_neighbours):
            if a >= 0 and b >= 0:
                centres[s] = old[s] / 2 + (old[a] + old[b]) / 4
    D = np.zeros_like(x)
    for p in range(len(made.amount)):
        for k in range(made.bone[p], made.bone[p + 1]):
            R = made.radius[k]
            for i in np.flatnonzero(made.part[: len(x)] == p):
                v = x[i] - centres[k]
                r = np.linalg.norm(v)
                D[i] += made.amount[p] * made.skeleton / R * min((R / r) ** 2, made.centroid[1]) * v / r
    return D


def displacement(x, c, graph, stuffing, rest, made):
    """All the forces on the first len(x) nodes of a graph of one part, with the default constants; c moves after."""
    n = len(x)
    cubic = stuffing in ("centroid", "skeleton")
    there = graph.edges[:, 0] < n
    edges, rest = graph.edges[there], rest[there]
    faces = graph.faces[graph.faces.max(1) < n]
    amount = graph.parts[0].stuffing
    D = link(x, edges, rest, cubic)
    if stuffing == "pressure":
        area = graph.parts[0].end - graph.parts[0].start
        D += pressure(x, faces, 0.02 * amount * len(edges), 0.01 * area**1.5)
    elif stuffing == "centroid":
        push, c = centroids(x, [0] * n, [0] * len(c), c, 0.05, 1000.0, 1.0, 1.4, [amount])
        D += push
    elif stuffing == "skeleton":
        D += skeleton(x, made)
    if stuffing == "none":
        triples, shares = straight(graph, n)
        D += bend(x, triples, 0.05 * np.array(shares))
    D += single_loop(x, graph, 0.05)
    D += contact(x, graph.edges, 1.2, 1.0, 0.2 if cubic else 1.0)
    return D - D[0], c


def steps(x, c, count, graph, stuffing, rest, made):
    """The seed's loop from given positions."""
    for _ in range(count):
        D, c = displacement(x, c, graph, stuffing, rest, made)
        x = x + (1.0 if stuffing in ("centroid", "skeleton") else 0.2) * D
    return x, c


def building(count, graph, stuffing, rest, grown):
    """The seed's loop from one node; ``grown(m)`` gives the Body of the first m nodes, for its skeleton."""
    x, c = np.zeros((1, 3)), np.zeros((1 if stuffing == "centroid" else 0, 3))
    last, waited = 0.0, 0
    for _ in range(count):
        if len(x) < len(graph) and (last < 0.03 or waited >= 100):
            i = len(x)
            below = [j for a, j in graph.edges.tolist() if a == i]
            place = x[below].mean(0) + np.array([0, 1, 0])
            if i == 1:
                place = x[0] + [1, 0.1, 0]
            if i == 2:
                place = x[0] + [0, 0.2, 1]
            x = np.vstack([x, place])
            if stuffing == "centroid" and math.ceil(len(x) / 60) > len(c):
                c = np.vstack([c, x[-60:].mean(0)])
            waited = 0
        old = x
        x, c = steps(x, c, 1, graph, stuffing, rest, grown(len(x)))
        last, waited = np.linalg.norm(x[-1] - old[-1]), waited + 1
    return x, c

"""Routing without jumps: every line of a fill once, outlines in between, in one Eulerian walk.

Lines end on the outline's rings. Each ring's pieces between neighbouring ends are edges once, and every other piece a
second time, so that each end has four edges and a closed walk over all of them exists (spec 4.3: better than ordering
sections). Of that walk only the order of the lines is kept; between two lines the thread takes the shorter way round.
"""

from __future__ import annotations

import numpy as np

from tambour.core.arrays import B1x1, F8x1, I1x1, I8x1
from tambour.core.check import Array
from tambour.core.kernels import kernel

LINE = 0
RING = 1
LINK = 2


@kernel
def ring_edges(order: I8x1, ring: I8x1, at: F8x1, base: F8x1) -> tuple[I8x1, I8x1, F8x1]:
    """Edges along rings between neighbouring nodes: (a, b, length), every other one doubled.

    order : nodes sorted by their way along the outlines; ring, at : per node; base : (K + 1,) see Rings. Of the two
    ways to double every other edge the shorter is taken. With an odd number of nodes on a ring one stays odd.
    """
    n = len(order)
    a = np.empty(2 * n + 2, np.int64)
    b = np.empty(2 * n + 2, np.int64)
    length = np.empty(2 * n + 2)
    m = 0
    i = 0
    while i < n:
        r = ring[order[i]]
        j = i
        while j < n and ring[order[j]] == r:
            j += 1
        size = j - i
        if size > 1:
            even = 0.0
            odd = 0.0
            begin = m
            for k in range(size):
                p, q = order[i + k], order[i + (k + 1) % size]
                way = at[q] - at[p]
                if k == size - 1:
                    way += base[r + 1] - base[r]
                a[m], b[m], length[m] = p, q, way
                m += 1
                if k % 2 == 0:
                    even += way
                else:
                    odd += way
            first = 0 if even <= odd else 1
            for k in range(first, first + 2 * (size // 2), 2):
                a[m], b[m], length[m] = a[begin + k % size], b[begin + k % size], length[begin + k % size]
                m += 1
        i = j
    return a[:m].copy(), b[:m].copy(), length[:m].copy()


@kernel
def adjacency(nodes: int, a: I8x1, b: I8x1) -> tuple[I8x1, I8x1]:
    """Edges at each node: (offsets (nodes + 1,), edge). A loop stands twice at its node."""
    offsets = np.zeros(nodes + 1, np.int64)
    for e in range(len(a)):
        offsets[a[e] + 1] += 1
        offsets[b[e] + 1] += 1
    offsets = np.cumsum(offsets)
    place = offsets[:-1].copy()
    edge = np.empty(2 * len(a), np.int64)
    for e in range(len(a)):
        edge[place[a[e]]] = e
        place[a[e]] += 1
        edge[place[b[e]]] = e
        place[b[e]] += 1
    return offsets, edge


@kernel
def euler(start: int, a: I8x1, b: I8x1, length: F8x1, kind: I1x1, offsets: I8x1, edge: I8x1) -> tuple[I8x1, I8x1]:
    """An Eulerian walk from ``start`` (Hierholzer): edges in order, and the node each one begins at.

    All nodes reached must have even degree, or ``start`` and one other odd degree. At a node the walk takes a LINE
    first, then the shortest edge.
    """
    used = np.zeros(len(a), np.bool_)
    node = np.empty(len(a) + 1, np.int64)
    came = np.empty(len(a) + 1, np.int64)
    walk = np.empty(len(a) + 1, np.int64)
    begin = np.empty(len(a) + 1, np.int64)
    node[0], came[0] = start, -1
    top = 1
    n = 0
    while top > 0:
        u = node[top - 1]
        best = -1
        weight = np.inf
        for i in range(offsets[u], offsets[u + 1]):
            e = edge[i]
            if not used[e]:
                w = -1.0 if kind[e] == LINE else length[e]
                if w < weight:
                    weight, best = w, e
        if best >= 0:
            used[best] = True
            node[top] = b[best] if a[best] == u else a[best]
            came[top] = best
            top += 1
        else:
            top -= 1
            if came[top] >= 0:
                walk[n] = came[top]
                begin[n] = node[top]
                n += 1
    # Hierholzer's stack empties backwards; walked backwards, an undirected circuit is a circuit, begun at node[top].
    return walk[:n].copy(), begin[:n].copy()


@kernel
def ring_way(p: int, q: int, ring: Array, at: Array, base: Array) -> float:
    """Shorter signed way from node p to node q of one ring: positive along the ring."""
    perimeter = base[ring[p] + 1] - base[ring[p]]
    way = at[q] - at[p]
    if way > perimeter / 2:
        way -= perimeter
    elif way < -perimeter / 2:
        way += perimeter
    return way


@kernel
def row_tour(spans: int, order: I8x1, ring: I8x1, at: F8x1, base: F8x1, starts: int) -> tuple[I8x1, B1x1, float]:
    """Best of several Eulerian tours over spans whose ends are nodes 2k and 2k + 1: (span (S,), reversed (S,), mm).

    starts : how many starting nodes are tried, evenly spread. mm is the way between spans, the longest left out.
    """
    a, b, length = ring_edges(order, ring, at, base)
    n = spans
    ea = np.concatenate((2 * np.arange(n), a))
    eb = np.concatenate((2 * np.arange(n) + 1, b))
    el = np.concatenate((np.zeros(n), length))
    kind = np.ones(len(ea), np.int8)
    kind[:n] = LINE
    offsets, edge = adjacency(2 * n, ea, eb)
    best = np.inf
    tour = np.zeros(0, np.int64)
    turned = np.zeros(0, np.bool_)
    for s in range(starts):
        walk, begin = euler((2 * n * s) // starts, ea, eb, el, kind, offsets, edge)
        sequence = np.empty(n, np.int64)
        back = np.empty(n, np.bool_)
        m = 0
        for i in range(len(walk)):
            if walk[i] < n:
                sequence[m] = walk[i]
                back[m] = begin[i] == 2 * walk[i] + 1
                m += 1
        total = 0.0
        longest = 0.0
        for i in range(m):
            p = 2 * sequence[i] + (0 if back[i] else 1)
            j = i + 1 if i + 1 < m else 0
            q = 2 * sequence[j] + (1 if back[j] else 0)
            way = abs(ring_way(p, q, ring, at, base)) if ring[p] == ring[q] else np.inf
            total += way
            longest = max(longest, way)
        if total - longest < best:
            best = total - longest
            tour, turned = sequence[:m].copy(), back[:m].copy()
    return tour, turned, best

"""First positions of ovals: rounds as stadiums about the chain that they began on, and of openings laid flat."""

from __future__ import annotations

import math

import numpy as np

from tambour.core.check import Array
from tambour.core.graph import LAID, PLAIN, StitchGraph

SMALLEST = 0.3
"""Radius of a stadium's ends at least, in stitches."""


def base(graph: StitchGraph, a: int, b: int) -> int:
    """How many of the chains ``a`` to ``b`` - 1 the next stitches go round, one side after the other; 0: no oval."""
    if b - a < 2 or graph.anchor_offsets[b] > graph.anchor_offsets[a] or b >= len(graph):
        return 0
    end = b
    while end < len(graph) and graph.round[end] == graph.round[b]:
        end += 1
    into = graph.anchors[graph.anchor_offsets[b] : graph.anchor_offsets[end]]
    if not len(into) or (into < a).any() or (into >= b).any() or graph.direction[b] != graph.direction[a]:
        return 0
    turn = int(into.argmin())
    there, back = into[: turn + 1], into[turn:]
    down = (np.diff(there) <= 0).all() and there[0] > there[-1]
    return int(into.max()) - a + 1 if down and (np.diff(back) >= 0).all() and back[-1] > back[0] else 0


def straight(count: int, half: float) -> tuple[float, float]:
    """Half the straight side and the radius of the ends of a round of ``count`` stitches, which add up to it."""
    half = min(half, max(0.0, 0.25 * (count - 2.0 * math.pi * SMALLEST)))
    return half, (count - 4.0 * half) / (2.0 * math.pi)


def stadium(share: Array, half: float, radius: float) -> Array:
    """Places (N, 2), x and z, at a ``share`` of the way round: from the back (-z) by +x to the front."""
    arc = 0.5 * math.pi * radius
    way = (share % 1.0) * (4.0 * half + 4.0 * arc)
    x, z = np.zeros(len(way)), np.zeros(len(way))
    # Turned to begin where the straight side by +x does.
    way = (way - arc) % (4.0 * half + 4.0 * arc)
    side, over = way // (2.0 * half + 2.0 * arc), way % (2.0 * half + 2.0 * arc)
    sign = np.where(side > 0, -1.0, 1.0)
    on = over < 2.0 * half
    x[on], z[on] = sign[on] * radius, sign[on] * (over[on] - half)
    angle = (over[~on] - 2.0 * half) / max(radius, 1e-9)
    x[~on] = sign[~on] * radius * np.cos(angle)
    z[~on] = sign[~on] * (half + radius * np.sin(angle))
    return np.column_stack([x, z])


def turned(count: int, half: float, radius: float, stand: Array) -> Array:
    """Places (count, 2) of a round's stitches, begun where they stand best over ``stand`` (count, 2)."""
    own = np.arange(count) / count
    best, step = 0.0, 1.0
    for tries in (64, 32):
        starts = best + step * (np.arange(tries) - tries // 2) / tries
        every = stadium((own + starts[:, None]).ravel(), half, radius).reshape(tries, count, 2)
        off = ((every - stand) ** 2).reshape(tries, -1).sum(1)
        best, step = float(starts[int(off.argmin())]), 2.0 * step / tries
    return stadium(own + best, half, radius)


def layers(graph: StitchGraph) -> Array:
    """Whether each node (N,) is worked through two stitches that lie on each other."""
    laid = {(int(a), int(b)) for a, b in graph.edges[graph.edge_kind == LAID]}
    made = np.zeros(len(graph), np.bool_)
    if laid:
        for n in np.flatnonzero(np.diff(graph.anchor_offsets) > 1).tolist():
            first, second = graph.anchors[graph.anchor_offsets[n] : graph.anchor_offsets[n] + 2].tolist()
            made[n] = (max(first, second), min(first, second)) in laid
            if not made[n] and made[n - 1]:
                # At the bend the two layers' stitches are neighbours, which lie on each other anyway.
                before = graph.anchors[graph.anchor_offsets[n - 1] : graph.anchor_offsets[n - 1] + 2].tolist()
                made[n] = first == second + 1 and before[0] > first > second > before[1]
    return made


def openwork(graph: StitchGraph) -> Array:
    """Which parts (P,) are worked into spaces between stitches and not stuffed: squares and doilies lie flat."""
    free = (np.diff(graph.anchor_offsets) == 0) & (graph.peculiarity == PLAIN)
    between = np.zeros(len(graph), np.bool_)
    # A stretch of chains that a stitch came before, and that stitches were worked into.
    for n in np.flatnonzero(free).tolist():
        before = graph.previous[n]
        between[n] = before >= 0 and (between[before] if free[before] else graph.round[before] == graph.round[n])
    made = np.zeros(len(graph.parts), np.bool_)
    into = graph.anchors[between[graph.anchors]]
    made[np.unique(graph.part[into])] = True
    return made & np.array([p.stuffing == 0.0 for p in graph.parts], np.bool_)


def corners(graph: StitchGraph, a: int, b: int) -> list[float]:
    """Where among the stitches ``a`` to ``b`` - 1 of a round its corners are: chains between stitches of one place."""
    found = []
    n = a
    while n < b:
        end = n
        while end < b and graph.anchor_offsets[end + 1] == graph.anchor_offsets[end]:
            end += 1
        if end > n > a:
            after = graph.parent[end] if end < b else graph.parent[a]
            if 0 <= after - graph.parent[n - 1] <= 1:
                found.append(0.5 * (n + end - 1) - a)
        n = max(end, n + 1)
    return found


def polygon(count: int, at: list[float]) -> Array:
    """Places (count, 2) of a round with corners at the stitches ``at``, all sides as long, one stitch to a stitch."""
    sides = len(at)
    radius = count / sides / (2.0 * math.sin(math.pi / sides))
    angle = 2.0 * math.pi * np.arange(sides + 2) / sides
    tops = radius * np.column_stack([np.cos(angle), np.sin(angle)])
    bounds = np.array([*at, at[0] + count])
    own = np.arange(count) + np.where(np.arange(count) < at[0], count, 0)
    side = np.clip(np.searchsorted(bounds, own, "right") - 1, 0, sides - 1)
    share = ((own - bounds[side]) / (bounds[side + 1] - bounds[side]))[:, None]
    return (1.0 - share) * tops[side] + share * tops[side + 1]

"""Arrange: pieces apart, and sewn parts where a maker would hold them: outside, at their seams."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tambour.core.arrays import I8x2
from tambour.core.check import Array
from tambour.core.graph import SEWN, StitchGraph
from tambour.core.kernels import kernel
from tambour.geometry.motion import dot, fit, turned
from tambour.geometry.surface import vertex_normals

ROUND, WHOLE, FLAT = 16, 0.9, 0.3
"""Seams of so many stitches that are as wide as this share of both parts run all round them; a part is flat whose middle is
no farther than this from its edge's, in stitches."""
GAP = 2.0
"""Stitches between pieces that are not joined, and between the two sides of a seam at first."""


@kernel
def _firsts(n: int, edges: I8x2) -> Array:
    """The first node (N,) of the piece that every node hangs together with."""
    first = np.arange(n)
    for e in range(len(edges)):
        i, j = edges[e, 0], edges[e, 1]
        while first[i] != i:
            first[i] = first[first[i]]
            i = first[i]
        while first[j] != j:
            first[j] = first[first[j]]
            j = first[j]
        first[max(i, j)] = min(i, j)
    for i in range(n):
        first[i] = first[first[i]]
    return first


def labels(n: int, edges: Array) -> Array:
    """The connected piece of every node (N,), numbered by first node."""
    return np.asarray(np.unique(_firsts(n, np.ascontiguousarray(edges, np.int64)), return_inverse=True)[1])


def parts(graph: StitchGraph, held: Array | None = None) -> list[Array]:
    """The nodes of every body of fabric: a part, or several that are worked into one another; sewing aside.

    held : pairs (H, 2) of nodes whose parts are taken for one body
    """
    made = graph.edges[graph.edge_kind != SEWN]
    made = made if held is None else np.concatenate([made, held])
    whole = np.array([(p.start, p.end - 1) for p in graph.parts if p.end > p.start], int).reshape(-1, 2)
    spans = [np.column_stack([np.full(b - a, a), np.arange(a + 1, b + 1)]) for a, b in whole]
    label = labels(len(graph), np.concatenate([made, *spans]))
    return [np.flatnonzero(label == k) for k in range(int(label.max(initial=-1)) + 1)]


def clusters(graph: StitchGraph) -> Array:
    """The number (N,) of the piece that every node belongs to, its part and all that is sewn to it."""
    spans = [np.column_stack([np.full(p.end - p.start, p.start), np.arange(p.start, p.end)]) for p in graph.parts]
    return labels(len(graph), np.concatenate([graph.edges, *spans]) if spans else graph.edges)


def cut(graph: StitchGraph, nodes: Array) -> StitchGraph:
    """The graph of ``nodes`` (rising) alone, with what lies between them."""
    n = len(graph)
    if len(nodes) == n and all(p.end > p.start for p in graph.parts):
        return graph
    new = np.full(n + 1, -1)
    new[nodes] = np.arange(len(nodes))
    inside = (new[graph.edges] >= 0).all(1)
    faces = new[graph.faces]
    lists = [graph.anchors[graph.anchor_offsets[i] : graph.anchor_offsets[i + 1]] for i in nodes]
    lists = [new[a][new[a] >= 0] for a in lists]
    own = np.unique(graph.part[nodes])
    number = np.full(len(graph.parts), -1)
    number[own] = np.arange(len(own))
    kept = []
    for p in own:
        mine = np.flatnonzero(graph.part[nodes] == p)
        hollow = tuple(np.searchsorted(nodes, graph.parts[p].hollow).tolist())
        kept.append(replace(graph.parts[p], start=int(mine[0]), end=int(mine[-1]) + 1, hollow=hollow))
    plane = new[graph.plane[nodes]]
    plane[(plane < 0).any(1)] = -1
    return replace(
        graph,
        kind=graph.kind[nodes],
        part=number[graph.part[nodes]],
        color=graph.color[nodes],
        parent=new[graph.parent[nodes]],
        round=graph.round[nodes],
        loop=graph.loop[nodes],
        direction=graph.direction[nodes],
        height=graph.height[nodes],
        peculiarity=graph.peculiarity[nodes],
        plane=plane,
        span=graph.span[nodes],
        edges=new[graph.edges[inside]],
        edge_kind=graph.edge_kind[inside],
        rest=graph.rest[inside],
        faces=faces[(faces >= 0).all(1)],
        parts=tuple(kept),
        anchors=np.concatenate(lists) if lists else np.zeros(0, int),
        anchor_offsets=np.cumsum([0] + [len(a) for a in lists]),
        previous=new[graph.previous[nodes]],
    )


def arrange(graph: StitchGraph, x: Array, held: Array | None = None) -> Array:
    """Positions (N, 3) in stitches with every part moved as a whole to where it belongs; x holds parts by themselves.

    The largest part of a piece stays. A part sewn to one that has its place goes to its seam, out along the normal
    there, turned so that its own seam faces the other and stitches meet. Pieces that are not joined stand in a row.

    held : pairs (H, 2) of nodes whose parts have their places to one another already, and move as one
    """
    x = x.copy()
    bodies = parts(graph, held)
    owner = np.zeros(len(graph), int)
    for k, nodes in enumerate(bodies):
        owner[nodes] = k
    sewn = graph.edges[graph.edge_kind == SEWN]
    sewn = sewn[owner[sewn[:, 0]] != owner[sewn[:, 1]]]
    outward = vertex_normals(x, graph.faces)
    piece = clusters(graph)
    right = None
    for k in range(int(piece.max(initial=-1)) + 1):
        mine = [b for b in range(len(bodies)) if piece[bodies[b][0]] == k]
        mine.sort(key=lambda b: -len(bodies[b]))
        placed = mine[:1]
        while len(placed) < len(mine):
            b = next((b for b in mine if b not in placed and len(_seam(sewn, owner, b, placed))), None)
            if b is None:
                break
            seam = _seam(sewn, owner, b, placed)
            base = np.flatnonzero(np.isin(owner, np.unique(owner[seam[:, 1]])))
            x[bodies[b]], turn = _attach(x, outward, bodies[b], seam, base, _onwards(graph, x, seam[:, 1]))
            outward[bodies[b]] = turned(outward[bodies[b]], turn)
            placed.append(b)
        nodes = np.flatnonzero(piece == k)
        if right is not None:
            x[nodes, 0] += right + GAP - x[nodes, 0].min()
        right = x[nodes, 0].max()
    return x


def _seam(sewn: Array, owner: Array, b: int, placed: list[int]) -> Array:
    """Seam pairs (K, 2) between part b (first) and parts that have their place (second)."""
    forward = sewn[(owner[sewn[:, 0]] == b) & np.isin(owner[sewn[:, 1]], placed)]
    backward = sewn[(owner[sewn[:, 1]] == b) & np.isin(owner[sewn[:, 0]], placed)]
    return np.concatenate([forward, backward[:, ::-1]])


def _onwards(graph: StitchGraph, x: Array, edge: Array) -> Array | None:
    """The way (3,) in which fabric goes on from stitches that nothing is worked into; None where something is."""
    if np.isin(edge, graph.anchors).mean() > 0.5:
        return None
    below = np.concatenate([graph.anchors[graph.anchor_offsets[n] : graph.anchor_offsets[n + 1]] for n in edge])
    return np.asarray(x[edge].mean(0) - x[below].mean(0)) if len(below) else None


def _attach(
    x: Array, outward: Array, nodes: Array, seam: Array, base: Array, onwards: Array | None
) -> tuple[Array, Array]:
    """The part ``nodes`` brought to its seam with the nodes ``base``: its positions and its rotation.

    onwards : the way in which it goes on from there, where it is sewn to an edge
    """
    own, other = x[seam[:, 0]], x[seam[:, 1]]
    out = outward[seam[:, 1]].mean(0)
    if len(seam) >= ROUND and min(_spread(own) / _spread(x[nodes]), _spread(other) / _spread(x[base])) > WHOLE:
        out = other.mean(0) - x[base].mean(
            0
        )  # edge to edge: it closes what the other begins, and lies on its hollow side
        if np.sqrt((out**2).sum()) < FLAT:
            out = -outward[base].mean(0)
    elif onwards is not None:
        out = onwards
    if np.sqrt((out**2).sum()) < 1e-6:
        out = other.mean(0) - x[nodes].mean(0) + [0.0, 1e-3, 0.0]
    out = out / np.sqrt((out**2).sum())
    middle = x[nodes].mean(0)
    deep = max(float(np.sqrt(((middle - own.mean(0)) ** 2).sum())), 0.5)
    moving = np.vstack([own, middle])
    fixed = np.vstack([other + 0.5 * GAP * out, other.mean(0) + (deep + 0.5 * GAP) * out])
    turn, shift = fit(moving, fixed, np.append(np.ones(len(own)), float(len(own))))
    moved = turned(x[nodes], turn) + shift
    # No stitch of it may begin behind the fabric that it is sewn to.
    behind = float(dot(other.mean(0) - moved, out).max())
    return moved + max(behind + 0.5 * GAP, 0.0) * out, turn


def _spread(points: Array) -> float:
    """How far points (K, 3) are from their middle, root of the mean of squares."""
    return float(np.sqrt(((points - points.mean(0)) ** 2).sum(1).mean())) + 1e-9

"""The rows of the fabric as smooth courses, and the cells between them: where a point of a stitch lies in space."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from tambour.core.arrays import B1x1, F8x1, F8x2, I1x1, I4x1, I8x1
from tambour.core.check import Array
from tambour.core.graph import JOIN, ROOT, SEWN, TIP, StitchGraph
from tambour.core.kernels import kernel
from tambour.geometry.motion import length
from tambour.geometry.surface import vertex_normals

RING = 0.43
"""Stitches in a magic ring begin on a circle this share of their distance from its middle."""


EASE = 3.0
"""Turns of a spiral before its open end over which its columns come back."""


@dataclass(frozen=True, slots=True)
class Course:
    """What the cells are made of; all per node.

    x : (N, 3) mm; normal : (N, 3) towards the outside; along : (N, 3) mm, to the next stitch; up : (N, 3) mm, one
    stitch height up the fabric
    after, before : (N,) neighbours along the yarn, -1 at its ends (a ring's first stitch follows its last)
    foot : (N,) where on its anchor a stitch stands, in stitches along the anchor's row; pace : (N,) how far feet move
    from stitch to stitch, negative in turned rows
    host : (N,) and slip : (N,) where a stitch shows: so many stitches along the yarn from that node (:func:`leaning`)
    """

    x: Array
    normal: Array
    along: Array
    up: Array
    after: Array
    before: Array
    foot: Array
    pace: Array
    host: Array
    slip: Array


def course(graph: StitchGraph, x: Array, lean: float = 0.0) -> Course:
    """The courses of a graph at positions (N, 3) mm; lean : how far columns move to the right in a round, in widths."""
    n = len(graph)
    normal = vertex_normals(x, graph.faces)
    after, before = np.full(n, -1, np.int32), np.full(n, -1, np.int32)
    plain = (graph.peculiarity != ROOT) & (graph.peculiarity != TIP)
    along, up = np.zeros((n, 3)), np.zeros((n, 3))
    foot, pace = np.zeros(n), np.zeros(n)
    _neighbours(graph.previous, graph.part, plain, graph.parent, graph.peculiarity == ROOT, after, before)
    _around(graph, x, plain, after)
    width = float(graph.rest[graph.edge_kind == 0].mean()) if (graph.edge_kind == 0).any() else 5.0
    _vectors(x, normal, after, before, graph.anchors, graph.anchor_offsets, graph.height, plain, width, along, up)
    _feet(graph.anchors, graph.anchor_offsets, along, graph.direction, plain, foot, pace)
    host, slip = leaning(graph, lean)
    return Course(np.ascontiguousarray(x), normal, along, up, after, before, foot, pace, host, slip)


def _around(graph: StitchGraph, x: Array, plain: Array, after: Array) -> None:
    """A round's last stitch, that none follows, lies over to the round's first: it is joined to it, or stands next to it."""
    joined: dict[int, int] = {}
    for i, k in graph.edges[graph.edge_kind == JOIN].tolist():
        # A chain that lifts the round is joined too: the nearer of both.
        if i not in joined or length((x[k] - x[i])[None])[0] < length((x[joined[i]] - x[i])[None])[0]:
            joined[i] = k
    worked = np.diff(graph.anchor_offsets) > 0
    for i in np.flatnonzero(plain & worked & (after < 0)).tolist():
        a = int(graph.anchors[graph.anchor_offsets[i + 1] - 1])
        k = joined.get(i, -1)
        if k < 0 and graph.peculiarity[a] == ROOT:
            k = a + 1
        elif k < 0 and graph.direction[a] == graph.direction[i]:
            k = int(after[a])
        own = (
            k >= 0
            and k != i
            and plain[k]
            and graph.part[k] == graph.part[i]
            and graph.direction[k] == graph.direction[i]
        )
        if own and length((x[k] - x[i])[None])[0] < 2.0 * graph.stitch_width:
            after[i] = k


def leaning(graph: StitchGraph, lean: float) -> tuple[Array, Array]:
    """Where every stitch shows: ``slip`` (N,) stitches along the yarn from its node or, further on, from ``host`` (N,).

    A stitch's head lies to the right of its post, so in rounds that are not turned every stitch stands a little to the
    right of the one that it is worked into: columns lean, pictures in them too. The shape is as round as before, so the
    stitches glide along their own spiral. Where a part holds a picture, its middle stays where its nodes are. An end that is sewn
    to something stays too: half the part's turns before it, EASE at the least, the gliding begins to fade.
    Parts with turns, joins or anything but a spiral from a ring keep their columns.
    """
    n = len(graph)
    host, slip = np.arange(n, dtype=np.int32), np.zeros(n)
    if lean == 0.0:
        return host, slip
    joined = np.zeros(n, np.bool_)
    joined[graph.edges[graph.edge_kind == JOIN].ravel()] = True
    sewn = np.zeros(n, np.bool_)
    sewn[graph.edges[graph.edge_kind == SEWN].ravel()] = True
    single = np.diff(graph.anchor_offsets) > 0
    for part in graph.parts:
        first, last, end = part.start + 1, part.end, part.end
        while last > first and graph.peculiarity[last - 1] == TIP:
            last -= 1
        own = slice(first, last)
        if (
            last - first < 12
            or graph.peculiarity[part.start] != ROOT
            or joined[own].any()
            or not single[own].all()
            or (graph.direction[own] != graph.direction[first]).any()
            or (graph.previous[first + 1 : last] != np.arange(first, last - 1)).any()
        ):
            continue
        number = np.arange(last - first)
        _, begin, count = np.unique(graph.round[own], return_index=True, return_counts=True)
        # Stitches in a turn, growing evenly; turns from the ring on; how far a stitch has moved back by then.
        around = np.interp(number, begin + 0.5 * (count - 1), count)
        turns = np.cumsum(1.0 / around)
        drift = -lean * np.cumsum(1.0 / around**2)
        seen = _pictured(graph, own)
        slip_of = drift - (drift[seen] if seen >= 0 else 0.0)
        if last == end and sewn[own][-3:].any():
            # Towards an end that is sewn to something the gliding fades.
            slip_of *= np.clip((turns[-1] - turns) / max(EASE, 0.5 * turns[-1]), 0.0, 1.0)
        where = np.interp(turns + slip_of, turns, number)
        host[own] = first + where.astype(np.int32)
        slip[own] = where - where.astype(np.int32)
    return host, slip


def _pictured(graph: StitchGraph, own: slice) -> int:
    """The stitch in the middle of those whose colour differs from their round's, counted from the first; or -1."""
    color = graph.color[own].astype(np.int64) @ np.array([65536, 256, 1])
    rounds = graph.round[own]
    change = np.flatnonzero((color[1:] != color[:-1]) & (rounds[1:] == rounds[:-1]))
    return int(np.median(change)) if len(change) > 2 else -1


@kernel
def _neighbours(previous: I4x1, part: I4x1, plain: B1x1, parent: I4x1, root: B1x1, after: I4x1, before: I4x1) -> None:
    for i in range(len(previous)):
        p = previous[i]
        if p >= 0 and plain[i] and plain[p] and part[i] == part[p]:
            before[i] = p
            if after[p] < 0:
                after[p] = i
    # A ring is round: its first stitch follows its last.
    for i in range(len(previous)):
        if plain[i] and before[i] < 0 and parent[i] >= 0 and root[parent[i]]:
            last = i
            while after[last] >= 0 and parent[after[last]] == parent[i]:
                last = after[last]
            if last != i:
                before[i] = last


@kernel
def _vectors(
    x: F8x2,
    normal: F8x2,
    after: I4x1,
    before: I4x1,
    anchors: I4x1,
    offsets: I8x1,
    height: F8x1,
    plain: B1x1,
    width: float,
    along: F8x2,
    up: F8x2,
) -> None:
    n = len(x)
    count = np.zeros(n)
    for i in range(n):
        if not plain[i]:
            continue
        a, b = before[i], after[i]
        if a >= 0 and b >= 0:
            along[i] = 0.5 * (x[b] - x[a])
        elif b >= 0:
            along[i] = x[b] - x[i]
        elif a >= 0:
            along[i] = x[i] - x[a]
        else:
            along[i, 0] = width
        first, last = offsets[i], offsets[i + 1]
        if last > first:
            mean = np.zeros(3)
            for k in range(first, last):
                mean += x[anchors[k]]
            rise = (x[i] - mean / (last - first)) / max(height[i], 0.5)
            up[i] += rise
            count[i] += 1.0
            for k in range(first, last):
                if plain[anchors[k]]:
                    up[anchors[k]] += rise
                    count[anchors[k]] += 1.0
    for i in range(n):
        if not plain[i] and offsets[i + 1] > offsets[i]:
            # A tip gathers the last round's tops: they lean to it and are short.
            for k in range(offsets[i], offsets[i + 1]):
                a = anchors[k]
                up[a] = 0.4 * (x[i] - x[a])
                count[a] = 1.0
    for i in range(n):
        # A chain that is worked into on both its sides has no way up.
        size = math.sqrt(up[i, 0] * up[i, 0] + up[i, 1] * up[i, 1] + up[i, 2] * up[i, 2])
        if plain[i] and offsets[i + 1] == offsets[i] and size < 0.3 * width * count[i]:
            count[i] = 0.0
    for i in range(n):
        if not plain[i]:
            continue
        if count[i] > 0.0:
            up[i] /= count[i]
        else:
            # A free chain, or one with fabric on both sides: across its own course, within the fabric.
            up[i, 0] = along[i, 1] * normal[i, 2] - along[i, 2] * normal[i, 1]
            up[i, 1] = along[i, 2] * normal[i, 0] - along[i, 0] * normal[i, 2]
            up[i, 2] = along[i, 0] * normal[i, 1] - along[i, 1] * normal[i, 0]
        size = math.sqrt(up[i, 0] * up[i, 0] + up[i, 1] * up[i, 1] + up[i, 2] * up[i, 2])
        if size < 0.3 * width:
            if size > 0.0:
                up[i] *= 0.3 * width / size
            else:
                up[i, 1] = width


@kernel
def _feet(
    anchors: I4x1,
    offsets: I8x1,
    along: F8x2,
    direction: I1x1,
    plain: B1x1,
    foot: F8x1,
    pace: F8x1,
) -> None:
    n = len(foot)
    i = 0
    while i < n:
        # Stitches in a row into the same single anchor share it out.
        last = i + 1
        if offsets[i + 1] - offsets[i] == 1 and plain[anchors[offsets[i]]]:
            while last < n and offsets[last + 1] - offsets[last] == 1 and anchors[offsets[last]] == anchors[offsets[i]]:
                last += 1
        count = last - i
        for k in range(i, last):
            if offsets[k + 1] > offsets[k]:
                a = anchors[offsets[k]]
                turn = 1.0 if direction[k] == direction[a] else -1.0
                if offsets[a + 1] == offsets[a] and (along[k] * along[a]).sum() < 0.0:
                    turn = -1.0  # back along the other side of a chain
                foot[k] = turn * ((k - i + 0.5) / count - 0.5)
                pace[k] = turn * max(1.0 / count, 0.8 if count == 2 else 0.66)
        i = last


@kernel
def on_row(
    j: int,
    u: float,
    x: Array,
    along: Array,
    normal: Array,
    up: Array,
    after: Array,
    before: Array,
    rises: bool,
    out: Array,
) -> None:
    """Place (out[0]), normal (out[1]) and, where it is asked for, up (out[2]) at ``u`` stitches along the yarn from node ``j``."""
    k = after[j]
    for _ in range(4):
        if u >= 1.0 and k >= 0 and after[k] >= 0:
            j, u = k, u - 1.0
            k = after[j]
        elif u < 0.0 and before[j] >= 0:
            j, k, u = before[j], j, u + 1.0
        else:
            break
    if u < 0.0 or k < 0 or u > 1.5:
        for c in range(3):
            out[0, c] = x[j, c] + u * along[j, c]
            out[1, c] = normal[j, c]
            if rises:
                out[2, c] = up[j, c]
        return
    # Hermite's cubic: tangents as of a spline through the row.
    s = u * u * (3.0 - 2.0 * u)
    p, q = u * (1.0 - u) * (1.0 - u), -u * u * (1.0 - u)
    for c in range(3):
        out[0, c] = (1.0 - s) * x[j, c] + s * x[k, c] + p * along[j, c] + q * along[k, c]
        out[1, c] = (1.0 - u) * normal[j, c] + u * normal[k, c]
    if rises:
        for c in range(3):
            out[2, c] = (1.0 - u) * up[j, c] + u * up[k, c]


STANDS = -(2**30)
"""In place of what a point's cell stands on: it belongs to the node itself, wherever its stitch shows."""


@kernel
def place(
    cell: I4x1,
    below: I4x1,
    at: F8x2,
    height: F8x1,
    direction: I1x1,
    thick: float,
    x: F8x2,
    along: F8x2,
    normal: F8x2,
    up: F8x2,
    after: I4x1,
    before: I4x1,
    foot: F8x1,
    pace: F8x1,
    host: I4x1,
    slip: F8x1,
    root: B1x1,
    free: B1x1,
    out: F8x2,
) -> None:
    """Fill ``out`` (P, 3) with the places of points in stitches' cells.

    cell : (P,) the stitch; below : (P,) the node its cell stands on, or -1 for a cell of its own; -2 - t for points
    between the stitch (v = 0) and node t (v = 1); STANDS for a cell of its own about the node
    at : (P, 3) u, v, w; v counts stitch heights from the foot; thick : mm of one unit of w
    root : (N,) whether a node is the middle of a ring; free : (N,) whether it is a chain, that knows no way up
    """
    low, top = np.zeros((3, 3)), np.zeros((3, 3))
    for p in range(len(cell)):
        i, a = cell[p], below[p]
        u, v, w = at[p, 0], at[p, 1], at[p, 2]
        w *= thick if direction[i] >= 0 else -thick
        high = max(height[i], 0.5)
        # Which way is up matters only below and above a cell, and in one of its own.
        rises = a == -1 or a == STANDS or v < 0.0 or v > high
        if a == STANDS:
            on_row(i, u, x, along, normal, up, after, before, rises, top)
            a = -1
        else:
            on_row(host[i], slip[i] + u, x, along, normal, up, after, before, rises, top)
        if a == -1:
            for c in range(3):
                out[p, c] = top[0, c] + (v - high) * top[2, c] + w * top[1, c]
            continue
        if a < -1:
            for c in range(3):
                low[0, c], low[1, c] = top[0, c], normal[-2 - a, c]
                top[0, c] = x[-2 - a, c]
            t, v, high = v, 0.5, 1.0
            for c in range(3):
                top[1, c], low[1, c] = low[1, c], top[1, c]
        else:
            if root[a]:
                # Taller stitches are drawn as close together at their feet.
                ring = RING * (0.5 + 0.5 / high)
                for c in range(3):
                    low[0, c] = x[a, c] + ring * (top[0, c] - x[a, c])
                    low[1, c] = 0.5 * (normal[a, c] + top[1, c])
                    low[2, c] = 0.5 * (top[0, c] - x[a, c])
            else:
                on_row(host[a], slip[a] + foot[i] + pace[i] * u, x, along, normal, up, after, before, v < 0.0, low)
                if free[a]:
                    for c in range(3):
                        low[2, c] = top[2, c]
            t = min(1.0, max(0.0, v / high))
        size = 0.0
        for c in range(3):
            low[1, c] = (1.0 - t) * low[1, c] + t * top[1, c]
            size += low[1, c] * low[1, c]
        size = w / math.sqrt(max(size, 1e-9))
        for c in range(3):
            out[p, c] = (1.0 - t) * low[0, c] + t * top[0, c] + size * low[1, c]
            if v < 0.0:
                out[p, c] += v * low[2, c]
            elif v > high:
                out[p, c] += (v - high) * top[2, c]

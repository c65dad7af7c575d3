"""What the hook made, as a StitchGraph: arrays, edges with rest lengths, the planes of single-loop stitches."""

from __future__ import annotations

from itertools import chain

import numpy as np

from tambour.core.check import Array
from tambour.core.graph import BLO, FLO, JOIN, LAID, OVER, SEWN, THROUGH, YARN, Part, StitchGraph
from tambour.crochet.graph.hook import Hook
from tambour.crochet.graph.spaces import BETWEEN

# Stitches sewn together lie side by side: nearer than neighbours in a round, not in the same place.
SEWN_SHORT = 0.5
# Stitches side by side in a chain space.
CROWDED = 0.95
# How much farther a ring is opened for chains between its stitches.
OPEN = 0.3
# A chain that lifts the yarn takes less room along the round than a stitch.
BESIDE = 0.4


def assemble(
    hook: Hook, parts: list[Part], sewn: list[tuple[int, int]], stitch: tuple[float, float]
) -> tuple[StitchGraph, Array]:
    """The graph and, for each face, whether it bounds the outside.

    stitch : width and height of a single crochet, mm
    """
    n = len(hook)
    look = np.array(hook.style, np.int32)
    kinds = tuple(dict.fromkeys(s[0] for s in hook.styles))
    of = {kind: k for k, kind in enumerate(kinds)}
    table: dict[str, Array] = {
        "kind": np.array([of[s[0]] for s in hook.styles], np.uint8),
        "height": np.array([s[1] for s in hook.styles], np.float64),
        "part": np.array([s[2] for s in hook.styles], np.int32),
        "color": np.array([s[3] for s in hook.styles], np.uint8).reshape(-1, 3),
        "loop": np.array([s[4] for s in hook.styles], np.uint8),
        "direction": np.array([s[5] for s in hook.styles], np.int8),
        "peculiarity": np.array([s[6] for s in hook.styles], np.uint8),
        "span": np.array([(s[7].start, s[7].end) for s in hook.styles], np.int32).reshape(-1, 2),
    }
    fields = {name: column[look] for name, column in table.items()}
    anchors, ends = np.array(hook.anchors, np.int32), np.array(hook.ends, np.int64)
    previous = np.array(hook.previous, np.int32)
    edges, kind = _edges(n, anchors, ends, previous, hook.joins, hook.laid, [o[:2] for o in hook.over], sewn)
    width, height = stitch
    rest = np.where(kind == THROUGH, height * fields["height"][edges[:, 0]], width)
    # A chain that lifts the yarn is a post: as high as a row, close beside the stitch that follows it.
    lift = np.zeros(n, np.bool_)
    lift[list(hook.lifts)] = True
    yarn = kind == YARN
    rest[yarn & lift[edges[:, 0]]] = height
    rest[yarn & lift[edges[:, 1]] & ~lift[edges[:, 0]]] = BESIDE * width
    chained = np.array([s[0] == "ch" for s in hook.styles], np.bool_)[look] & ~lift
    chained[list(hook.strung)] = False
    if chained.any():
        # Not those of foundations and of bridges between edges.
        kinds_at = [hook.styles[hook.style[r.last]][0] for r in hook.rounds]
        worked = [ends[r.last + 1] > ends[r.first] and at != "attach" for r, at in zip(hook.rounds, kinds_at)]
        chained &= np.array(worked, np.bool_)[np.array(hook.round, np.int32)]
        rest[yarn & chained[edges].any(1) & ~lift[edges].any(1)] = BETWEEN * width
    rest[(kind == JOIN) & lift[edges].any(1)] = (1.0 - BESIDE) * width
    rest[kind == SEWN] = SEWN_SHORT * width
    if hook.laid:
        # Layers worked together lie on each other as if sewn, also where slip stitches join them.
        pairs = np.sort(np.array(hook.laid, np.int64), 1)
        apart = np.isin(edges[:, 0].astype(np.int64) * n + edges[:, 1], pairs[:, 1] * n + pairs[:, 0])
        rest[apart & ((kind == LAID) | (kind == JOIN))] = SEWN_SHORT * width
    if hook.aside:
        aside = np.zeros(n)
        aside[list(hook.aside)] = list(hook.aside.values())
        rest = np.where(kind == THROUGH, np.hypot(rest, width * aside[edges[:, 0]]), rest)
        inside = np.zeros(n, np.bool_)
        inside[list(hook.aside)] = True
        off = {(node, beside): far for node, beside, far in hook.over}
        for e in np.flatnonzero(kind == OVER).tolist():
            node, beside = edges[e].tolist()
            rest[e] = np.hypot(height * fields["height"][node], width * off[node, beside])
        level = np.array(hook.round, np.int32)[edges]
        rest[yarn & inside[edges].all(1) & (level[:, 0] == level[:, 1])] = CROWDED * width
    first = np.searchsorted(edges[:, 0], np.array(list(hook.risen), np.int32))
    for at, (node, (lifted, passed)) in zip(first.tolist(), hook.risen.items()):
        # The yarn comes up from the edge below, or across from the chain that has lifted it.
        high = 0.0 if lifted else height * fields["height"][node]
        if high or passed:
            while at < len(edges) and edges[at, 0] == node:
                if edges[at, 1] == previous[node]:
                    rest[at] = np.hypot(high, width * passed)
                at += 1
    for root, count in hook.rings.items():
        # A ring opens as far as what stands around it asks for; chains between its stitches turn its corners.
        at = (edges[:, 1] == root) & (kind == THROUGH)
        whole, posts = count * width / (2.0 * np.pi), int(at.sum()) * width / (2.0 * np.pi)
        rest[at] = np.maximum(rest[at], np.maximum(posts, np.minimum(whole, rest[at] + OPEN * width)))
    faces = np.fromiter(chain.from_iterable(hook.faces), np.int32, 3 * len(hook.faces)).reshape(-1, 3)
    stretch = np.array(hook.face_stretch, np.int64)
    for number, count in enumerate(np.bincount(stretch, minlength=len(hook.stretches.all))):
        hook.stretches.all[number].faces = int(count)
    outside = np.array(hook.stretches.shell(), np.bool_)
    graph = StitchGraph(
        kinds=kinds,
        parent=np.array(hook.parent, np.int32),
        round=np.array(hook.round, np.int32),
        plane=_planes(hook, fields["peculiarity"], fields["direction"]),
        edges=edges,
        edge_kind=kind,
        rest=rest,
        faces=faces,
        parts=tuple(parts),
        anchors=anchors,
        anchor_offsets=ends,
        previous=previous,
        **fields,
    )
    return graph, outside[stretch] if len(stretch) else np.zeros(0, np.bool_)


def _edges(
    n: int,
    anchors: Array,
    ends: Array,
    previous: Array,
    joins: list[tuple[int, int]],
    laid: list[tuple[int, int]],
    over: list[tuple[int, int]],
    sewn: list[tuple[int, int]],
) -> tuple[Array, Array]:
    """Edges (E, 2) with the later node first, sorted, none twice, and their kinds; a yarn edge outranks the others."""
    own = np.arange(n, dtype=np.int32)
    through = np.stack([np.repeat(own, np.diff(ends)), anchors], 1)
    yarn = np.stack([own, previous], 1)[previous >= 0]
    groups = [(YARN, yarn), (THROUGH, through)]
    for kind, pairs in ((JOIN, joins), (LAID, laid), (OVER, over), (SEWN, sewn)):
        both = np.array(pairs, np.int32).reshape(-1, 2)
        groups.append((kind, np.stack([both.max(1, initial=-1), both.min(1, initial=n)], 1)))
    edges = np.concatenate([pairs for _, pairs in groups])
    kinds = np.concatenate([np.full(len(pairs), kind, np.uint8) for kind, pairs in groups])
    apart = edges[:, 0] != edges[:, 1]
    edges, kinds = edges[apart], kinds[apart]
    _, first = np.unique(edges[:, 0].astype(np.int64) * max(n, 1) + edges[:, 1], return_index=True)
    return np.ascontiguousarray(edges[first], np.int32), kinds[first]


def _planes(hook: Hook, peculiarity: Array, direction: Array) -> Array:
    """Nodes a, b, c of each single-loop stitch's plane: the one after its anchor, its anchor, the anchor's own anchor.

    The normal (b - a) x (c - a) points inside: towards the back loop. Where the yarn does not lead from the anchor b to
    b + 1 (after a goto or an attach, or at an edge's end), a is the node that it does lead to, else a and b are the
    anchor and the node before it, which span the same plane on the same side (the seed leaves this corner open).
    """
    plane = np.full((len(hook), 3), -1, np.int32)
    single = np.flatnonzero((peculiarity == FLO) | (peculiarity == BLO))
    if not len(single):
        return plane
    after: dict[int, int] = {}
    for node in range(len(hook) - 1, -1, -1):
        if hook.previous[node] >= 0 and hook.ends[node + 1] > hook.ends[node]:
            after[hook.previous[node]] = node
    for n in single.tolist():
        anchor = hook.parent[n]
        c = hook.parent[anchor]
        follower = anchor + 1
        if follower >= n or hook.previous[follower] != anchor:
            follower = after.get(anchor, n)
        a, b = (follower, anchor) if follower < n else (anchor, hook.previous[anchor])
        if direction[n] != direction[anchor]:
            a, b = b, a
        if min(a, b, c) >= 0 and len({a, b, c}) == 3:
            plane[n] = (a, b, c)
    return plane

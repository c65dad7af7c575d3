"""Edges: how the yarn lies where a piece ends: heads as links of a chain, a spiral whose last stitch is slipped in, chains that turn."""

from __future__ import annotations

import numpy as np

from tambour.core.check import Array
from tambour.core.graph import JOIN, ROOT, SEWN, TIP, StitchGraph
from tambour.crochet.yarn.ends import CHAINED, NONE, STITCH
from tambour.crochet.yarn.loops import HEAD, TALL, TOP
from tambour.geometry.motion import length
from tambour.geometry.surface import vertex_normals

# The head of a stitch that nothing is worked into lies as a link of a chain: narrow where it comes out of the link before, wide where it
# lies about the next, and lower, for nothing draws it up. What is added to its points from BRAID on.
BRAID = 29
_LINK = np.array(
    [
        (0.00, -0.20, 0.00), (0.00, -0.17, -0.04), (0.02, -0.14, 0.02), (0.04, -0.12, 0.10), (0.06, -0.11, 0.13),
        (0.08, -0.11, 0.10), (0.08, -0.12, 0.02), (0.08, -0.12, -0.04), (0.06, -0.12, -0.10), (0.04, -0.12, -0.10),
        (0.02, -0.14, -0.05), (0.00, -0.16, 0.00),
    ]
)  # fmt: skip

# A slip stitch, from the top of the stitch that it is worked into.
_SLIP = np.array(
    [
        (-0.05, 0.05, -0.30),
        (-0.08, -0.05, 0.0),
        (-0.02, 0.10, 0.33),
        (0.15, 0.35, 0.34),
        (0.35, 0.48, 0.10),
        (0.42, 0.35, -0.28),
    ]
)
# The next round, worked over it, draws it down and behind; at an edge it lies within that.
_COVERED, _EDGED = np.array([0.0, -0.3, -0.2]), np.array([0.0, -0.18, 0.0])

TIGHT = 0.5
"""As far along the work, in stitches, a head keeps its place that is drawn tight."""

EASED = 10
"""The last stitches of a spiral that goes no further, which come down to the round below, gently at first and at last."""
STEP = 0.75
"""How far down the last of them comes, of its height."""

DRAWN, BEYOND = 0.7, 0.15
"""How far the chains that turn a row are drawn in towards its first stitch, as a share of how far they stand out; how far, in
widths, they still do at the most."""
DOMES, DOME = (0.28, 0.36), 2.4
"""How far a ring's and a tip's middle is pushed out, and over how far about it that falls off; in widths."""
GATHERED = (0.65, 0.35, 0.12)
"""How far the heads of a last round are drawn in to its tip, as a share of how far they are from it; those of the round that it stands on,
and of the one before."""
PULLED = (0.2, 0.08, 0.02)
"""How far in they are drawn, in widths."""
STOUT = 24
"""Parts of fewer stitches around are limbs, whose ends are round by themselves."""
ARCHED = 0.5
"""How high an arch of chains rises at a corner, as a share of how high it could."""
SUNK = np.array([0.0, 0.45, 0.25])
"""How far down and behind the chain lies that lifts a joined round."""
WRAPPED = np.array([0.0, 0.28, 0.25])
"""How far down and behind chains lie about which several tall stitches stand."""
LAST = 0.35
"""How far the last stitch of all is drawn in towards the one before it, as a share of how far it is from it."""


def slip(covered: bool) -> Array:
    """A slip stitch's points (6, 3), from the top of the stitch that it is worked into; covered : whether stitches are worked over it."""
    return np.asarray(_SLIP + (_COVERED if covered else _EDGED))


def braided(graph: StitchGraph, role: Array, start: Array, at: Array) -> None:
    """Turn the heads at an edge to links: ``at`` (P, 3) is the way of the yarn, ``start`` (N + 1,) where each node's begins."""
    for i in np.flatnonzero(_free(graph, role)).tolist():
        link = int(start[i + 1]) - (TOP[1] - BRAID)
        at[link : link + len(_LINK)] += _LINK


def _free(graph: StitchGraph, role: Array) -> Array:
    """Stitches (N,) in whose head nothing is worked, joined or sewn: an edge."""
    free = role == STITCH
    free[graph.anchors] = False
    free[graph.edges[np.isin(graph.edge_kind, (JOIN, SEWN))].ravel()] = False
    for kind in ("crab", "picot"):
        if kind in graph.kinds:
            free[graph.kind == graph.kinds.index(kind)] = False
    return np.asarray(free)


def slipped(graph: StitchGraph, role: Array) -> dict[int, int]:
    """The last stitch of every spiral that is left open, and the one of its last round that its maker slips it into: so its step is
    made low, and its end lies in the edge."""
    return {i: k for i, (k, joined) in _stepped(graph, role).items() if not joined}


def _stepped(graph: StitchGraph, role: Array) -> dict[int, tuple[int, bool]]:
    """The last stitch of every spiral that ends in an edge, the one of its last round that it comes to, and whether it is joined to that
    by a slip stitch as written."""
    held = np.zeros(len(graph), np.bool_)
    held[graph.edges[graph.edge_kind == SEWN].ravel()] = True
    joins = graph.edges[graph.edge_kind == JOIN]
    made = {}
    for part in graph.parts:
        own = np.flatnonzero(role[part.start : part.end] == STITCH) + part.start
        if (
            len(own) < EASED
            or graph.peculiarity[part.start] != ROOT
            or (graph.peculiarity[part.start : part.end] == TIP).any()
        ):
            continue
        i = int(own[-1])
        k = int(graph.anchors[graph.anchor_offsets[i + 1] - 1]) + 1
        spiral = k < i and role[k] == STITCH and graph.previous[k] == k - 1 and graph.round[k] == graph.round[i]
        joined = joins[((joins >= part.start) & (joins < part.end)).any(1)]
        closed = len(joined) == 1 and joined[0].tolist() == [i, k]
        if (
            spiral
            and i == part.end - 1
            and (closed or not np.isin(joined, own[-EASED:]).any())
            and not held[own[-EASED:]].any()
            and (graph.direction[own] == graph.direction[i]).all()
        ):
            made[i] = (k, closed)
    return made


def eased(graph: StitchGraph, x: Array, role: Array, host: Array, slip: Array) -> Array:
    """Positions (N, 3) with the last stitches of every spiral that ends in an edge lower, each more than the one before it.

    host, slip : where every stitch shows, of :func:`tambour.crochet.yarn.course.leaning`
    """
    last = _stepped(graph, role)
    made = x.copy() if last else x
    for i in last:
        end = host[i] + slip[i]
        for j in range(int(end) - EASED + 1, i + 1):
            on = graph.anchors[graph.anchor_offsets[j] : graph.anchor_offsets[j + 1]]
            t = min(1.0, max(0.0, 1.0 - (end - j) / EASED))
            made[j] += STEP * t * t * (3.0 - 2.0 * t) * (x[on].mean(0) - x[j])
    return made


def level(graph: StitchGraph, x: Array, role: Array) -> Array:
    """Positions (N, 3) with the chains that lift a turned row drawn in: where nothing is worked into them they stand out at its
    beginning, and the edge of the piece goes in steps of two rows. And with the last stitch of a last row, about which no chain turns."""
    over = np.zeros(len(graph), np.bool_)
    over[graph.anchors] = True
    lifts = (role == CHAINED) & ~over
    made = x.copy()
    for first in (np.flatnonzero(lifts[1:] & ~lifts[:-1]) + 1).tolist():
        s = first
        while s < len(graph) and lifts[s] and graph.previous[s] == s - 1:
            s += 1
        turns = s + 1 < len(graph) and role[first - 1] != NONE and role[s] == STITCH == role[s + 1]
        if not turns or graph.previous[s] != s - 1 or graph.direction[first - 1] == graph.direction[s]:
            continue
        out = x[s] - x[s + 1]
        out = out / max(float(np.sqrt((out**2).sum())), 1e-9)
        far = np.maximum((x[first:s] - x[s]) @ out, 0.0)
        made[first:s] -= (far - np.minimum((1.0 - DRAWN) * far, BEYOND * graph.stitch_width))[:, None] * out
    for part in graph.parts:
        i = part.end - 1
        own = int(graph.anchors[graph.anchor_offsets[i + 1] - 1]) if i > part.start and role[i] == STITCH else -1
        if own >= 0 and role[i - 1] == STITCH == role[own] and graph.direction[own] != graph.direction[i]:
            made[i] += LAST * (x[i - 1] - x[i])
    return made


def domed(graph: StitchGraph, x: Array) -> Array:
    """Positions (N, 3) with the middles of stuffed ends pushed out: stitches lie there on their sides, and heads that are drawn
    together lie deeper than legs stand elsewhere, so that a ball of such yarn would have a flat crown. A flat base stays flat."""
    normal, width, made = None, graph.stitch_width, x
    for part in graph.parts:
        own = slice(part.start, part.end)
        if part.stuffing <= 0.0 or np.unique(graph.round[own], return_counts=True)[1].max(initial=0) < STOUT:
            continue
        for pole in np.flatnonzero(np.isin(graph.peculiarity[own], (ROOT, TIP))) + part.start:
            if normal is None:
                normal, made = vertex_normals(x, graph.faces), x.copy()
            far = length(x[own] - x[pole]) / width
            around = (far > 3.0) & (far < 5.0)
            if not around.any():
                continue
            bent = 1.0 - float(np.median(normal[own][around] @ normal[pole]))
            high = DOMES[int(graph.peculiarity[pole] == TIP)] * min(1.0, max(0.0, bent / 0.08 - 0.25))
            made[own] += high * width * np.exp(-((far / DOME) ** 2))[:, None] * normal[own]
    return made


def gathered(graph: StitchGraph, x: Array) -> Array:
    """Positions (N, 3) with the last round drawn together where it is closed: the yarn's end goes through its heads and is pulled tight,
    so that no hole is left, and its stitches lie there like those of a ring. What they stand on comes along: where it stayed, holes opened
    between the feet of the last round."""
    tips = np.flatnonzero(graph.peculiarity == TIP).tolist()
    made, normal = x.copy(), vertex_normals(x, graph.faces) if tips else x
    for t in tips:
        ring, drawn = np.array([t]), np.zeros(len(graph), np.bool_)
        drawn[(graph.part != graph.part[t]) | (graph.peculiarity == ROOT)] = True
        for share, deep in zip(GATHERED, PULLED):
            below = np.unique(
                np.concatenate([graph.anchors[graph.anchor_offsets[i] : graph.anchor_offsets[i + 1]] for i in ring])
            )
            ring = below[~drawn[below]]
            if not len(ring):
                break
            # The end is pulled inside: where twelve legs meet they lie deeper than their neighbours, and are no knob on top.
            made[ring] += share * (x[t] - x[ring]) - deep * graph.stitch_width * normal[t]
            drawn[ring] = True
    return made


def arched(graph: StitchGraph, x: Array, role: Array) -> Array:
    """Positions (N, 3) with chains at an edge that lead from stitch to stitch in even arches: two of a corner, that have little room,
    come to rest one behind the other, and the corner has a horn."""
    free = role == CHAINED
    free[graph.anchors] = False
    free[graph.edges[np.isin(graph.edge_kind, (JOIN, SEWN))].ravel()] = False
    made = x.copy()
    for first in (np.flatnonzero(free[1:] & ~free[:-1]) + 1).tolist():
        last = first
        while last < len(graph) and free[last] and graph.previous[last] == last - 1:
            last += 1
        a, many = first - 1, last - first
        spans = last < len(graph) and graph.previous[last] == last - 1 and graph.previous[first] == a
        if many < 2 or not spans or not role[a] == STITCH == role[last] or graph.direction[a] != graph.direction[last]:
            continue
        under = [graph.anchors[graph.anchor_offsets[i] : graph.anchor_offsets[i + 1]] for i in (a, last)]
        out, across = x[a] - x[under[0]].mean(0) + x[last] - x[under[1]].mean(0), x[last] - x[a]
        wide = float(np.sqrt((across**2).sum()))
        out = out - (out @ across) / max(wide**2, 1e-9) * across
        size = float(np.sqrt((out**2).sum()))
        slack = ((many + 1) * graph.stitch_width) ** 2 - wide**2
        if size < 1e-9 or slack <= 0.0 or wide > 0.8 * (many + 1) * graph.stitch_width:
            continue
        t = (np.arange(many) + 1.0)[:, None] / (many + 1)
        made[first:last] = x[a] + t * across + ARCHED * slack**0.5 * 2.0 * t * (1.0 - t) * out / size
    return made


def lowered(graph: StitchGraph, role: Array, start: Array, at: Array) -> None:
    """Draw the chain that lifts a joined round, where nothing is worked into it, down behind the round's first stitch: at its height it
    would hang into the next round, a drop of the old colour."""
    over = np.zeros(len(graph), np.bool_)
    over[graph.anchors] = True
    joined = graph.edges[graph.edge_kind == JOIN][:, 0]
    for i in (np.unique(joined) + 1).tolist():
        if i < len(graph) and role[i] == CHAINED and not over[i] and graph.part[i] == graph.part[i - 1]:
            at[int(start[i]) : int(start[i + 1])] -= SUNK


def covered(graph: StitchGraph, role: Array, start: Array, at: Array) -> None:
    """Draw chains down and behind into which tall stitches are worked: their posts stand about them and hide them; as high as others
    they poke out between, tips of the old colour at the corners of a square."""
    tall = np.repeat(graph.height >= TALL, np.diff(graph.anchor_offsets))
    under = np.bincount(graph.anchors[tall], minlength=len(graph)) > 1
    for i in np.flatnonzero(under & (role == CHAINED)).tolist():
        at[int(start[i]) : int(start[i + 1])] -= WRAPPED


def tightened(graph: StitchGraph, role: Array, follows: Array, start: Array, at: Array) -> None:
    """Where a flat row is fastened off the last head is drawn tight: nothing comes that it could lie over to."""
    last = role != NONE
    last[:-1] &= ~follows[1:]
    joined = graph.edges[graph.edge_kind == JOIN][:, 0]
    for i in np.setdiff1d(np.flatnonzero(last), joined).tolist():
        own = int(graph.anchors[graph.anchor_offsets[i + 1] - 1]) if role[i] == STITCH else -1
        if own >= 0 and (role[own] == NONE or (role[own] == STITCH and graph.direction[own] == graph.direction[i])):
            continue  # a round: the head lies over to the round's first stitch
        head = at[int(start[i + 1]) - (TOP[1] - HEAD) : int(start[i + 1]), 0]
        head[head > TIGHT] -= 0.75 * (head[head > TIGHT] - TIGHT)

"""The yarn's way through the whole piece: stitch after stitch, its ends, rings, closings, joins and seams."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tambour.core.check import Array
from tambour.core.graph import BACK, FRONT, JOIN, ROOT, SEWN, TIP, StitchGraph
from tambour.crochet.language.stitches import POSTS
from tambour.crochet.yarn.course import STANDS
from tambour.crochet.yarn.edges import braided, covered, lowered, slip, slipped, tightened
from tambour.crochet.yarn.ends import (
    AFTER,
    CHAINED,
    CUT,
    END,
    INWARD,
    NONE,
    ONWARD,
    OUTWARD,
    START,
    STITCH,
    Pieces,
    begun,
    behind,
    ended,
)
from tambour.crochet.yarn.loops import HEAD, LEAN, TALL, TOP, count_points, lead, tables
from tambour.crochet.yarn.points import merged
from tambour.geometry.motion import length
from tambour.noise import stream

# The hanging loop of a loop stitch, after the LOOPED-th point of the stitch.
LOOPED = 8
_HANGING = np.array(
    [
        (-0.08, 0.10, 0.62),
        (-0.26, -0.30, 0.95),
        (-0.34, -1.00, 1.10),
        (-0.22, -1.60, 1.05),
        (0.02, -1.85, 1.00),
        (0.26, -1.60, 1.05),
        (0.36, -1.00, 1.10),
        (0.24, -0.30, 0.95),
        (0.06, 0.05, 0.60),
    ]
)
SWAY = 0.3
"""How far the lower end of one hanging loop lies beside another's, in widths; their lengths differ by as much."""
CRIMP = 0.15
"""How far what hangs bends to and fro, in widths."""
# The tops of a popcorn's stitches, folded together in front, before its head; out as far as it bulges.
_CROWN = np.array(
    [
        (0.1 + 0.42 * t, 0.86 + (0.16 if k % 2 else -0.1), 0.12 - 0.35 * t * t)
        for k, t in enumerate(np.linspace(-1, 1, 9))
    ]
)
# The head of a reverse single crochet: from behind over the edge and down in front, against the way of the work, and once
# more; then down behind to the next.
_WOUND = np.array(
    [
        (
            0.86 - 1.02 * t,
            0.90 + 0.36 * np.sin(2.6 * np.pi * t - 0.25 * np.pi),
            -0.36 * np.cos(2.6 * np.pi * t - 0.25 * np.pi),
        )
        for t in np.linspace(0.0, 1.0, TOP[1] - HEAD - 5)
    ]
    + [(0.02, 0.66, -0.30), (0.14, 0.56, -0.42), (0.30, 0.54, -0.46), (0.48, 0.56, -0.42), (0.65, 0.636, -0.33)]
)
# The yarn over of a half double lies behind its top: the third loop; v from the top.
_THIRD = np.array(
    [(0.80, -0.36, -0.32), (0.90, -0.24, -0.42), (0.45, -0.20, -0.46), (0.0, -0.26, -0.42), (0.04, -0.42, -0.32)]
)
# A yarn over of a tall stitch is wound once about its post: up across the front, and around behind; v from its middle.
_WRAP = np.array(
    [
        (-0.12, -0.10, -0.24), (-0.16, -0.30, 0.0), (-0.07, -0.26, 0.28), (0.14, -0.04, 0.48), (0.34, 0.18, 0.38),
        (0.43, 0.30, 0.08), (0.36, 0.24, -0.24), (0.18, -0.02, -0.42), (-0.02, -0.30, -0.42),
    ]
)  # fmt: skip
# A stitch of a seam, from the top of the stitch that is sewn on: out of its last round, aslant over its edge, where one sees it, and down
# into what it is sewn to, close before that edge; inside to the next. Pulled tight it lies amid the
# edge's own strands; higher over the edge it stood up as a row of loops.
_SEAM = np.array(
    [(-0.14, -0.50, -0.15), (-0.12, -0.44, 0.28), (0.0, -0.24, 0.40), (0.14, -0.04, 0.38), (0.24, 0.10, 0.12)]
)
_UNDER = np.array([(0.0, -0.1, -0.45)])

# How far kinds bulge, against other groups of stitches in one place: clusters lie flat, bobbles and popcorns stand out.
_BULGE = {"bobble": 1.2, "cl": 0.5, "popcorn": 1.45, "puff": 0.85}


@dataclass(frozen=True, slots=True)
class Way:
    """P control points of S strands.

    cell, below : (P,) and at : (P, 3), as :func:`tambour.crochet.yarn.course.place` takes them; ends : (S + 1,)
    first : (S,) the first stitch of each strand, -1 for a seam; color : (S, 3) uint8
    """

    cell: Array
    below: Array
    at: Array
    ends: Array
    first: Array
    color: Array


def roles(graph: StitchGraph) -> Array:
    """What every node is to the yarn: NONE, STITCH or CHAINED."""
    role = np.full(len(graph), STITCH, np.int8)
    role[np.diff(graph.anchor_offsets) == 0] = CHAINED
    role[(graph.peculiarity == ROOT) | (graph.peculiarity == TIP)] = NONE
    return role


_LOW = 1.05
"""Height under which a stitch is a single crochet, in single crochets."""


def invisible(graph: StitchGraph, role: Array) -> Array:
    """Decreases (N,) of single crochets in rounds: makers of toys draw one loop through the front strands of both stitches, and it
    looks like any other V; in turned rows each stitch has a loop of its own, and so has each layer that is worked through."""
    first, count = graph.anchor_offsets[:-1], np.diff(graph.anchor_offsets)
    made = (role == STITCH) & (count > 1) & (graph.height < _LOW)
    i = np.flatnonzero(made)
    a, b = graph.anchors[first[i]], graph.anchors[first[i] + count[i] - 1]
    ahead, back = a, b
    for k in range(1, 3):  # stitches of two layers do not follow one another
        ahead = np.where(count[i] > k, graph.previous[ahead], ahead)
        back = np.where(count[i] > k, graph.previous[back], back)
    beside = (back == a) | (ahead == b)
    made[i] = (a != b) & beside & (graph.direction[a] == graph.direction[i]) & (role[a] == STITCH) & (count[i] < 4)
    return np.asarray(made)


def way(graph: StitchGraph, hold: str = "over") -> Way:
    """The way of the yarn through a graph; hold : how it lies on the hook, over or under."""
    n = len(graph)
    role = roles(graph)
    count = np.zeros(n, np.int64)
    drawn = invisible(graph, role)
    count_points(role, graph.anchor_offsets, graph.height, drawn, count)
    start = np.concatenate([[0], np.cumsum(count)])
    total = int(start[-1])
    cell, below, at = np.zeros(total, np.int32), np.zeros(total, np.int32), np.zeros((total, 3))
    ridge = np.zeros(n, np.int8)
    for loop, free in ((BACK, 1), (FRONT, -1)):
        ridge[graph.parent[(graph.loop == loop) & (graph.parent >= 0)]] = free
    loose = role == STITCH
    loose[graph.anchors] = False
    loose |= ridge == 1
    sunk = np.zeros(n, np.bool_)
    wide = np.flatnonzero(
        (np.diff(graph.anchor_offsets) > 1) & ~drawn
    )  # their loops lean away from the head before them
    sunk[np.maximum(graph.previous[graph.anchors[graph.anchor_offsets[wide]]], 0)] = True
    sunk &= role == STITCH
    ring = (graph.parent >= 0) & (graph.peculiarity[np.maximum(graph.parent, 0)] == ROOT) & (role == STITCH)
    courses, chain = tables(hold)
    lead(
        role,
        start,
        graph.anchors,
        graph.anchor_offsets,
        graph.height,
        np.where(ring, 0, np.where(drawn & (graph.loop == 0), 1, graph.loop.astype(np.int64)))
        + len(courses) // 2 * loose,
        ridge,
        sunk,
        drawn,
        courses,
        chain,
        *_shapes(graph),
        LEAN[hold],
        cell,
        below,
        at,
    )
    if "crab" in graph.kinds:
        for i in np.flatnonzero((graph.kind == graph.kinds.index("crab")) & (role == STITCH)).tolist():
            # Worked backwards: the head is wound about the edge, outwards over it.
            head = at[int(start[i + 1]) - len(_WOUND) : int(start[i + 1])]
            head[:, :2] = _WOUND[:, :2]
            head[:, 2] = _WOUND[:, 2] * (graph.direction[i] or 1)
    braided(graph, role, start, at)
    lowered(graph, role, start, at)
    covered(graph, role, start, at)
    # A seam draws the heads of a part's last round down to what they are sewn to.
    sewn = np.zeros(n, np.bool_)
    sewn[graph.edges[graph.edge_kind == SEWN].ravel()] = True
    sewn[graph.anchors] = False
    if sewn.any():
        low = sewn[cell] & (at[:, 1] > graph.height[cell] - 0.4)
        at[low, 1] -= 0.6 * (at[low, 1] - graph.height[cell[low]] + 0.4)
    follows = np.zeros(n, np.bool_)  # the yarn comes straight from the node before
    worked = np.flatnonzero(role != NONE)
    later = worked[worked > 0]
    follows[later] = (
        (graph.previous[later] == later - 1) & (role[later - 1] != NONE) & (graph.part[later] == graph.part[later - 1])
    )
    # The last node that a stitch was worked into; a chain has none.
    on = np.full(n, -1, np.int64)
    on[role == STITCH] = graph.anchors[graph.anchor_offsets[1:][role == STITCH] - 1]
    pieces = Pieces()
    for i, loops in _loops(graph):
        where = int(start[i]) + LOOPED
        for k in range(loops):
            if loops == 1:
                pieces.put(where, AFTER, i, int(on[i]), _hanging(i, k, loops))
                continue
            # Fur is cut: two ends hang where a loop hung, each straight down.
            cut, middle = CUT + 2 * k, len(_HANGING) // 2
            left, right = _hanging(i, 2 * k, 2 * loops)[: middle + 1], _hanging(i, 2 * k + 1, 2 * loops)[middle:]
            left[-1, 0], right[0, 0] = left[-2, 0], right[1, 0]
            pieces.put(where, cut, i, int(on[i]), left)
            pieces.begin(where, i, cut + 1)
            pieces.put(where, cut + 1, i, int(on[i]), right)
    for i, out in _crowned(graph):
        loops = int(np.diff(graph.anchor_offsets)[i])
        crown = _CROWN * (1.0, 1.0, out) + (0.0, 0.0, out)
        pieces.put(int(start[i]) + 5 + 14 * loops, AFTER, i, int(on[i]), crown, float(graph.height[i]) - 1)
    for i, before, rows, rise in _overs(graph, role):
        pieces.put(int(start[i]) + before, AFTER, i, int(on[i]), rows, rise)
    for i, before, rows in _wraps(graph, role):
        pieces.put(int(start[i]) + before, AFTER, i, int(on[i]), rows)
    tightened(graph, role, follows, start, at)
    drop = np.zeros(total, np.bool_)
    uncut = _uncut(graph, role, ring)
    carried = _carried(graph, role, follows, uncut)
    for i in np.flatnonzero(uncut).tolist():
        uncut[i] = i in carried
    for i, path in carried.items():
        follows[i] = not uncut[i]
        for node in path:
            pieces.put(int(start[i]), AFTER, node, STANDS, _UNDER, float(graph.height[node]))
    for i in worked[~follows[worked]].tolist():
        begun(graph, pieces, i, int(on[i]), int(start[i]), role, ring, follows, drop, anew=not uncut[i])
    follows[:-1] |= uncut[1:]
    changed = worked[follows[worked]]
    changed = changed[(graph.color[changed] != graph.color[changed - 1]).any(1)]
    for i in changed.tolist():
        # The new colour is taken up with the top loop of the stitch before.
        p, where = i - 1, int(start[i]) - (TOP[1] - HEAD)
        rise = float(graph.height[p]) - 1
        pieces.put(where, END, p, int(on[p]), behind(graph, p, INWARD), rise)
        pieces.begin(where, i)
        pieces.put(where, START, p, int(on[p]), behind(graph, p, OUTWARD), rise)
    joins, over = graph.edges[graph.edge_kind == JOIN], np.zeros(n, np.bool_)
    over[graph.anchors] = True
    # Into the round's first stitch, not into the chain beside it that lifts the round too.
    into = set(joins[role[joins[:, 1]] == STITCH, 0].tolist())
    for i, a in joins[(role[joins] != NONE).all(1)].tolist():
        if role[a] == CHAINED and i in into:
            continue
        pieces.put(int(start[i + 1]), AFTER, a, -1, slip(bool(over[a])), float(graph.height[a]))
    for i, k in slipped(graph, role).items():
        pieces.put(int(start[i + 1]), AFTER, k, -1, slip(False), float(graph.height[k]))
    tips = {int(graph.previous[t]) if graph.previous[t] >= 0 else int(t) - 1: t for t in _tips(graph)}
    last = np.ones(n, np.bool_)
    last[:-1] = ~follows[1:]
    joined = {i: a for i, a in joins.tolist() if role[i] == CHAINED and role[a] == STITCH}
    for i in worked[last[worked]].tolist():
        if i in joined:
            # After chains that are joined to a stitch the end is woven in behind that one and the next: behind chains one would see it.
            a = joined[i]
            pieces.put(
                int(start[i + 1]), END, a, int(on[a]), behind(graph, a, ONWARD), 0.5 * float(graph.height[a]) - 0.5
            )
            continue
        ended(graph, pieces, i, int(on[i]), int(start[i + 1]), tips.get(i))
        if i in tips:
            # The last top loop is not left lying: its yarn is drawn on.
            drop[int(start[i + 1]) - (TOP[1] - HEAD) + 3 : int(start[i + 1])] = True
    return _joined(graph, cell, below, at, drop, pieces)


def _uncut(graph: StitchGraph, role: Array, ring: Array) -> Array:
    """First stitches (N,) of rings whose yarn comes from what was worked before them in their part: a second hump's, that is joined to the
    first. It was not cut, and lies across the ring in the tail's place."""
    made = np.zeros(len(graph), np.bool_)
    first = np.flatnonzero(ring)
    first = first[(first > 1) & (graph.previous[first] < 0)]
    before = first - 2
    own = (role[first - 1] == NONE) & (role[before] == STITCH) & (graph.part[before] == graph.part[first])
    made[first[own & (graph.color[before] == graph.color[first]).all(1)]] = True
    return made


def _carried(graph: StitchGraph, role: Array, follows: Array, uncut: Array) -> dict[int, list[int]]:
    """Stitches that the work goes back to (goto), or that begin an ``uncut`` ring, and the nodes behind which the yarn is carried there from
    the last stitch made: it was not cut, so it is one strand, led from stitch to stitch behind the fabric."""
    later = np.flatnonzero((role[1:] != NONE) & (role[:-1] != NONE) & ~follows[1:]) + 1
    later = later[(graph.part[later] == graph.part[later - 1]) & (graph.previous[later] >= 0)]
    later = later[(graph.color[later] == graph.color[later - 1]).all(1)]
    ways = [(i, i - 1, int(graph.previous[i]), i) for i in later.tolist()]
    # To a ring through what joins it to the first hump later: straight there the yarn would leave the one and pierce the other.
    ways += [(i, i - 2, i, len(graph)) for i in np.flatnonzero(uncut).tolist()]
    made = {}
    if ways:
        order = np.argsort(np.concatenate([graph.edges[:, 0], graph.edges[:, 1]]), kind="stable")
        other = np.concatenate([graph.edges[:, 1], graph.edges[:, 0]])[order]
        at = np.searchsorted(np.concatenate([graph.edges[:, 0], graph.edges[:, 1]])[order], np.arange(len(graph) + 1))
    for i, start, goal, end in ways:
        came, front = {start: start}, [start]
        while front and goal not in came:
            nodes, front = front, []
            for a in nodes:
                for b in other[at[a] : at[a + 1]].tolist():
                    if b < end and b not in came and role[b] != NONE and graph.part[b] == graph.part[i]:
                        came[b] = a
                        front.append(b)
        if goal in came:
            path = [goal]
            while path[-1] != start:
                path.append(came[path[-1]])
            made[i] = path[::-1]
    return made


def takes(graph: StitchGraph, stitch: tuple[float, float], hold: str = "over") -> Array:
    """How much yarn every node (N,) takes, mm: its course in a flat cell of its own size, and a seam's two passes.

    stitch : mm, width and height of a single crochet. It needs no shape; where stitches crowd, the yarn that is led in space is up to a tenth longer.
    """
    led, lean = way(graph, hold), LEAN[hold]
    high = stitch[1] / stitch[0]
    step = np.diff(led.at, axis=0, append=led.at[-1:])
    # From one stitch to the next, or to another anchor's hole, the cell changes: what lies between is short.
    same = (np.diff(led.cell, append=-1) == 0) & (np.diff(led.below, append=-9) == 0)
    step[~same] = (0.12, 0.0, 0.0)
    size = length(np.stack([step[:, 0] - lean * step[:, 1], high * step[:, 1], step[:, 2]], axis=1))
    worked = np.bincount(led.cell, size, len(graph))
    seams = graph.edges[graph.edge_kind == SEWN]
    return np.asarray((worked + 1.5 * np.bincount(seams[:, 0], minlength=len(graph))) * stitch[0])


def _shapes(graph: StitchGraph) -> tuple[Array, Array, Array]:
    """How deep every node (N,) is worked, how far it stands out, and how far it bulges, for :func:`loops.lead`."""
    deep, relief = np.zeros(len(graph.kinds)), np.zeros(len(graph.kinds))
    for k, kind in enumerate(graph.kinds):
        if kind in POSTS:
            deep[k], relief[k] = 0.45, 0.42 if kind.startswith("fp") else -0.42
        elif kind == "spike":
            deep[k] = 1.0
    count = np.diff(graph.anchor_offsets)
    # It bulges outwards, also where rows are seen from their back.
    flat = np.array([_BULGE.get(kind, 1.0) for kind in graph.kinds])[graph.kind]
    bump = np.where(count > 1, 0.3 + 0.16 * np.minimum(count, 6), 0.0) * flat * graph.direction
    return deep[graph.kind], relief[graph.kind], bump


def _hanging(i: int, k: int, loops: int) -> Array:
    """The ``k``-th loop that hangs out of stitch ``i``: no two fall alike; the later ones lie farther out."""
    longer, aside, out = stream("hanging", i, k).uniform(-1.0, 1.0, 3)
    down = np.clip(-_HANGING[:, 1] / 1.85, 0.0, 1.0)
    made = _HANGING * (1.0, (1.15 if loops == 1 else 1.5) + 0.35 * longer * SWAY, 1.0)
    made[:, 0] += down * SWAY * aside + (k - 0.5 * (loops - 1)) * 0.3 * down
    made[:, 2] += (0.25 * out + 0.35 * k) * down
    # Wool remembers how it was wound: no two hang straight.
    for c, phase in ((0, 3.0 * longer), (2, 3.0 * aside)):
        made[:, c] += CRIMP * down * np.sin(4.5 * down + phase)
    return made


def _overs(graph: StitchGraph, role: Array) -> list[tuple[int, int, Array, float]]:
    """The third loops of half doubles: the stitch, before which of its points, where, and how high up."""
    half = (role == STITCH) & (graph.height > 1.3) & (graph.height < TALL)
    made = []
    for i in np.flatnonzero(half).tolist():
        own = graph.anchors[graph.anchor_offsets[i] : graph.anchor_offsets[i + 1]]
        if len(own) == 1 or own[0] != own[-1]:  # many loops in one place hide them
            made.append((i, 5 + 14 * len(own), _THIRD, float(graph.height[i])))
    return made


def _wraps(graph: StitchGraph, role: Array) -> list[tuple[int, int, Array]]:
    """The yarn overs about the posts of tall stitches, from the top down: the stitch, before which of its points, and where."""
    made = []
    for i in np.flatnonzero((role == STITCH) & (graph.height >= TALL)).tolist():
        own = graph.anchors[graph.anchor_offsets[i] : graph.anchor_offsets[i + 1]]
        high = float(graph.height[i])
        stories = int(high + 0.5)
        if len(own) == 1:
            made += [(i, 2, _WRAP + np.array([0.0, high * k / stories, 0.0])) for k in range(stories - 1, 0, -1)]
    return made


def _crowned(graph: StitchGraph) -> list[tuple[int, float]]:
    """Popcorns, and how far they bulge, negative to the other side."""
    if "popcorn" not in graph.kinds:
        return []
    bump = _shapes(graph)[2]
    return [(n, 0.8 * float(bump[n])) for n in np.flatnonzero(graph.kind == graph.kinds.index("popcorn")).tolist()]


def _loops(graph: StitchGraph) -> list[tuple[int, int]]:
    """Stitches whose yarn hangs out in loops, and how many."""
    found = []
    for kind, loops in (("loopst", 1), ("fur", 2)):
        if kind in graph.kinds:
            found += [(n, loops) for n in np.flatnonzero(graph.kind == graph.kinds.index(kind)).tolist()]
    return found


def _tips(graph: StitchGraph) -> list[int]:
    return [int(t) for t in np.flatnonzero(graph.peculiarity == TIP)]


def _joined(graph: StitchGraph, cell: Array, below: Array, at: Array, drop: Array, pieces: Pieces) -> Way:
    """Stitches, pieces in between and the seams' yarn, in the order of the yarn."""
    total = len(cell)
    seams = _seams(graph)
    for number, (later, earlier) in enumerate(seams):
        if number == 0 or (graph.part[seams[number - 1]] != graph.part[[later, earlier]]).any():
            seam = len(pieces.breaks) + 1
            pieces.begin(total, -1 - later, START + seam)
        for node, rows in ((earlier, _UNDER), (later, _SEAM)):
            pieces.put(total, START + seam, node, STANDS, rows, float(graph.height[node]))
    rows = np.array(pieces.rows).reshape(-1, 7)
    order = np.lexsort((np.arange(len(rows)), rows[:, 1], rows[:, 0]))
    rows = rows[order]
    where, when = rows[:, 0].astype(np.int64), rows[:, 1].astype(np.int64)
    gone = np.flatnonzero(drop)
    size = total + len(where) - len(gone)
    cells, belows, ats = np.empty(size, np.int32), np.empty(size, np.int32), np.empty((size, 3))
    merged(cell, below, at, drop, where, np.ascontiguousarray(rows[:, 2:]), cells, belows, ats)
    gone += np.searchsorted(where, gone, "right")
    # A strand begins behind what ends there and before what starts there.
    marks = []
    for place, stitch, level in pieces.breaks:
        marks.append((place + int(((where < place) | ((where == place) & (when < level))).sum()), stitch))
    marks.sort()
    places = np.array([place for place, _ in marks], np.int64)
    begins = places - np.searchsorted(gone, places)
    first = np.array([stitch for _, stitch in marks], np.int64)
    color = graph.color[np.where(first >= 0, first, -1 - first)] if len(first) else np.zeros((0, 3), np.uint8)
    return Way(
        cells,
        belows,
        ats,
        np.concatenate([begins, [size]]).astype(np.int64),
        np.maximum(first, -1).astype(np.int32),
        color,
    )


def _seams(graph: StitchGraph) -> Array:
    """Pairs (S, 2) sewn together, later node first, in the order that a needle would take them."""
    pairs = graph.edges[graph.edge_kind == SEWN]
    part = graph.part[pairs]
    return np.asarray(pairs[np.lexsort((pairs[:, 0], part[:, 1], part[:, 0]))])

"""First positions by rounds: the seed's generalised cylinder ("Cylinder initializer"), a ring per round and part.

All in stitches, y up. Seen from outside, at the ring that a part begins with, work goes counter-clockwise.
"""

from __future__ import annotations

import math
from hashlib import blake2b

import numpy as np

from tambour.core.check import Array
from tambour.core.graph import JOIN, ROOT, THROUGH, TIP, StitchGraph
from tambour.crochet.graph import dangling, ovals, rolls

LEAST_RISE = 0.3
"""The share of a row's height that a round lies above the one before, however much wider it is; openwork lies flat."""


BACK = -0.5 * math.pi
"""Where a first round begins: at the back, so that its middle is in front, towards +z."""
NEARLY = 0.85
"""A square whose sides grow by this share of its rows' height lies flat."""
WAVE = 0.1
"""How far rows lie off their plane at first, in stitches: what wants to leave it could not begin to otherwise."""
WITHIN, AMID = 0.25, 0.3
"""Rings of two branches whose middles are so near, in stitches, or in radii of the smaller, are about each other, and not side by side."""
WHOLE = 0.85
"""A round that so much of the one below is worked into stands over all of it."""
CLEAR = 1.0
"""Stitches that rings of different branches of one part keep between them."""
_KEPT, _LARGE = 64, 4000
"""So many parts are remembered, of so many stitches at the most."""


def sections(graph: StitchGraph) -> Array:
    """The section of every node (N,), rising: a stretch of work within one round; roots and tips stand alone."""
    if not len(graph):
        return np.zeros(0, np.int32)
    alone = np.isin(graph.peculiarity, (ROOT, TIP))
    new = (np.diff(graph.part) != 0) | (np.diff(graph.round) != 0) | alone[1:] | alone[:-1]
    return np.concatenate([[0], np.cumsum(new)]).astype(np.int32)


def rise(graph: StitchGraph, rest: Array) -> Array:
    """How high above its anchors each node wants to stand (N,): its edges' rest length, 1 where it has no anchor."""
    total, count = np.zeros(len(graph)), np.zeros(len(graph))
    through = graph.edge_kind == THROUGH
    np.add.at(total, graph.edges[through, 0], rest[through])
    np.add.at(count, graph.edges[through, 0], 1.0)
    return np.where(count > 0, total / np.maximum(count, 1.0), 1.0)


EDGED = 4
"""Rows back and forth about which a last round is an edging, so many of them with the wrong side ahead or more."""


def in_rows(graph: StitchGraph) -> Array:
    """Which parts (P,) are worked in rows: turned, and never joined to rounds, but for an edging round many rows. Slip stitches
    into the row below join nothing, where the piece is turned again and again."""
    of_join = graph.edges[graph.edge_kind == JOIN]
    of_join = of_join[~_hanging(graph, of_join[:, 0])]  # slip stitches back along a strand join nothing
    closes = (graph.round[of_join[:, 0]] == graph.round[of_join[:, 1]]) & ~_along_chains(graph, of_join)
    levels = int(graph.round.max(initial=0)) + 2  # -1 is one
    of_round = graph.part.astype(np.int64) * levels + graph.round + 1
    back, every = (np.unique(of_round[some]) // levels for some in (graph.direction < 0, ...))
    often = 3 * np.bincount(back, minlength=len(graph.parts)) >= np.bincount(every, minlength=len(graph.parts))
    of_join = of_join[closes | ~often[graph.part[of_join[:, 0]]], 0]
    joined, turned, rooted = (np.zeros(len(graph.parts), bool) for _ in range(3))
    joined[graph.part[of_join]] = True
    turned[graph.part[graph.direction < 0]] = True
    rooted[graph.part[graph.peculiarity == ROOT]] = True
    for part in np.flatnonzero(joined & turned & ~rooted).tolist():
        p = graph.parts[part]
        back = np.unique(graph.round[p.start : p.end][graph.direction[p.start : p.end] < 0])
        joins = np.unique(graph.round[of_join[graph.part[of_join] == part]])
        joined[part] = len(back) < EDGED or bool((joins < graph.round[p.start : p.end].max()).any())
    return turned & ~joined & ~rooted


def _along_chains(graph: StitchGraph, of_join: Array) -> Array:
    """Which of the joins (K, 2) are slip stitches along the chain that a part begins with, and make no ring of it: those of a
    chain of which one goes into the half of it that was worked last."""
    first = np.array([p.start for p in graph.parts])[graph.part[of_join[:, 1]]]
    begun = (graph.round[of_join] == graph.round[first][:, None]).all(1)
    n = np.bincount(graph.round, minlength=1)[graph.round[first]]
    late = begun & (2 * (of_join[:, 1] - first) > n)
    return np.asarray(begun & np.isin(first, first[late]))


def _hanging(graph: StitchGraph, nodes: Array) -> Array:
    """Which of the ``nodes`` (K,) are those of strands."""
    if not len(nodes):
        return np.zeros(0, bool)
    section = sections(graph)
    bounds = np.append(np.flatnonzero(np.diff(section, prepend=-1)), len(graph))
    own, of = np.unique(section[nodes], return_inverse=True)
    return np.array([dangling.strung(graph, int(bounds[k]), int(bounds[k + 1])) for k in own.tolist()])[of]


def rounds(graph: StitchGraph, rest: Array) -> Array:
    """First positions (N, 3), every part by itself with its beginning at the origin.

    A round of n stitches is a horizontal ring of radius n / 2π about the middle of the stitches it is worked into,
    turned so that its stitches stand over theirs, and higher than those by √(h² - ΔR²), at least 0.3 h, where ΔR is
    the change of radius and h the height of its stitches; as much lower in a part's hollow. Rows that are turned and never joined lie flat instead, or are rolled where edges of the piece are sewn to each other;
    rounds about a chain are stadiums, as long as it; an opening closed through both layers is a line.
    """
    n = len(graph)
    x = np.zeros((n, 3))
    section = sections(graph)
    heights = rise(graph, rest)
    starts = np.flatnonzero(np.diff(section, prepend=-1))
    ends = np.append(starts[1:], n)
    rows = in_rows(graph)
    flat = rows.copy()
    edging = np.zeros(n, bool)  # begins with a round about rows
    later = graph.edges[graph.edge_kind == JOIN, 0]
    later = later[flat[graph.part[later]]]
    edging[starts[np.searchsorted(starts, later, side="right") - 1]] = True
    half = np.full(len(graph.parts), -1.0)  # of the straight sides, in parts that are ovals
    ends_of = np.zeros(len(graph))  # the radius of the stadium that a node is in
    folded = ovals.layers(graph)
    flats = ovals.openwork(graph)
    least = np.where(flats, 0.0, LEAST_RISE)
    width = np.zeros(len(graph.parts))
    np.maximum.at(width, graph.part[starts], (ends - starts) / (2.0 * math.pi))
    begun = np.zeros(len(graph.parts), int)
    aside: dict[int, float | None] = {}  # of sections of ovals, how far beside the first one's middle theirs is
    forks = Forks()
    inside = np.zeros(n, bool)
    for p in graph.parts:
        inside[p.hollow[0] : p.hollow[1]] = True
    keys = _keys(graph, heights, flat, least, folded, inside)
    known = {part: made for part, key in keys.items() if (made := _laid.get(key)) is not None}
    for part, made in known.items():
        x[graph.parts[part].start : graph.parts[part].end] = made
    first: dict[bytes, int] = {}
    copied = {part: one for part, key in keys.items() if (one := first.setdefault(key, part)) != part}
    into = np.repeat(np.arange(n), np.diff(graph.anchor_offsets))
    for k, (part, a, b) in enumerate(zip(graph.part[starts].tolist(), starts.tolist(), ends.tolist())):
        if part in known or part in copied:
            continue
        count, nodes = b - a, slice(a, b)
        anchors = graph.anchors[graph.anchor_offsets[a] : graph.anchor_offsets[b]]
        over = into[graph.anchor_offsets[a] : graph.anchor_offsets[b]] - a  # which node is worked into each
        if len(anchors) and int(anchors.max()) >= a:
            over, anchors = over[anchors < a], anchors[anchors < a]
        under = anchors if bool((anchors[1:] > anchors[:-1]).all()) else np.unique(anchors)
        if not len(under) and dangling.strung(graph, a, b):
            dangling.placed(graph, x, heights, (a, b), bool(flat[part]))
            continue
        if not len(under):
            again = half[part] >= 0.0 and graph.previous[a] < graph.parts[part].start  # the second of two soles
            on = ovals.base(graph, a, b) if half[part] < 0.0 or again else 0
            if on:
                # The hook's end at the back: the middle of a round is in front.
                half[part], flat[part] = 0.5 * (on - 1), False
                x[nodes, 2] = 0.5 * (on - 1) - np.arange(count)
                x[a + on : b, 2], x[a + on : b, 1] = x[a + on - 1, 2], np.arange(1, count - on + 1)
                aside[k] = float(begun[part] * (2.0 * width[part] + 2.0))
                x[nodes, 0] = aside[k]
                begun[part] += 1
                continue
            x[nodes] = _begin(graph, x, np.arange(a, b), width[part], begun[part], bool(flat[part]))
            begun[part] += int(graph.previous[a] < 0 or graph.previous[a] < graph.parts[part].start)
            continue
        centre = _middle(x[under])
        below = section[under]
        below = below[:1] if below[0] == below[-1] else np.unique(below)
        if len(below) == 1:
            c, d = int(starts[below[0]]), int(ends[below[0]])
            if WHOLE * (d - c) < len(under) < d - c and not flat[part] and half[part] < 0.0:
                centre = _middle(x[c:d])  # the stitch that joins a round is not worked into, and is no reason to lean
        h = float(np.add.reduce(heights[nodes]) / count)
        many = np.bincount(over, minlength=count)[:, None]
        stand = np.empty((count, 3))
        for axis, values in enumerate(x[anchors].T):
            stand[:, axis] = np.bincount(over, values, count)
        stand = np.where(many > 0, stand / np.maximum(many, 1), centre)
        if flat[part] and edging[a]:
            off = stand - _middle(x[graph.parts[part].start : a])
            x[nodes] = stand + h * off / np.maximum(np.sqrt((off**2).sum(1, keepdims=True)), 1e-9)
            continue
        if flat[part]:
            x[nodes, 0] = stand[:, 0].mean() + graph.direction[nodes] * (np.arange(count) - 0.5 * (count - 1))
            x[nodes, 1] = centre[1] + h
            x[nodes, 2] = WAVE * np.sin(0.7 * x[nodes, 0] + 1.3 * x[nodes, 1])
            continue
        if folded[a:b].any():
            x[nodes] = stand + np.array([0.0, h, 0.0])
            continue
        where = {aside.get(int(j), 0.0) for j in below}  # None: two soles have become one
        beside = aside[k] = where.pop() if len(where) == 1 else None
        if half[part] >= 0.0 and count > 3 and beside is not None:
            side, radius = ovals.straight(count, float(half[part]))
            spread = float(ends_of[under].mean())
            up = math.sqrt(max(h * h - (radius - spread) ** 2, (least[part] * h) ** 2))
            x[nodes, 0], x[nodes, 2] = ovals.turned(count, side, radius, stand[:, [0, 2]] - [beside, 0.0]).T
            x[nodes, 0] += beside
            x[nodes, 1], ends_of[nodes] = centre[1] + (-up if inside[a] else up), radius
            continue
        turns = ovals.corners(graph, a, b) if flats[part] else []
        radius = count / (2.0 * math.pi) if count > 1 else 0.0
        off = x[under] - centre
        spread = float(np.add.reduce(np.hypot(off[:, 0], off[:, 2])) / len(off))
        up = math.sqrt(max(h * h - (radius - spread) ** 2, (least[part] * h) ** 2))
        if 3 <= len(turns) <= 8:
            flat_at = ovals.polygon(count, turns) * [1.0, float(graph.direction[a])]
            # Its sides are as far out as the rows are high, or nearly: it lies flat. Else its rows rise.
            apothem = float(np.hypot(*flat_at.T).min())
            out = apothem - float(ends_of[under].mean())
            up = math.sqrt(h * h - out * out) if out < NEARLY * h else 0.0
            ends_of[nodes] = apothem
            own, there = flat_at[:, 0] + 1j * flat_at[:, 1], (stand - centre)[:, 0] + 1j * (stand - centre)[:, 2]
            turn = (there * own.conj()).sum()
            own = own * (turn / abs(turn) if abs(turn) > 1e-9 else np.exp(1j * BACK) * own[0].conj() / abs(own[0]))
            x[nodes] = centre + np.column_stack([own.real, np.full(count, up), own.imag])
            continue
        angle = graph.direction[nodes] * np.arange(count) * (2.0 * math.pi / count)
        turn = np.exp(1j * (np.arctan2(stand[:, 2] - centre[2], stand[:, 0] - centre[0]) - angle)).sum()
        angle = angle + (math.atan2(turn.imag, turn.real) if abs(turn) > 1e-9 else BACK)
        place = centre + np.array([0.0, -up if inside[a] else up, 0.0])
        if count > 1:
            place = forks.clear(k, below, place, radius, part)
        x[nodes, 0], x[nodes, 1] = place[0] + radius * np.cos(angle), place[1]
        x[nodes, 2] = place[2] + radius * np.sin(angle)
    for part in np.flatnonzero(rows).tolist():
        if part not in known and part not in copied:
            rolls.roll(graph, x, part)
    for part, one in copied.items():
        x[graph.parts[part].start : graph.parts[part].end] = x[graph.parts[one].start : graph.parts[one].end]
    for part, key in keys.items():
        if part not in known:
            _laid[key] = x[graph.parts[part].start : graph.parts[part].end].copy()
            while len(_laid) > _KEPT:
                _laid.pop(next(iter(_laid)), None)
    return x


def _middle(points: Array) -> Array:
    return np.add.reduce(points) / len(points)


_laid: dict[bytes, Array] = {}
"""Parts that were laid out last, by all that it depends on: between two keys of one who types, most parts stay as they are."""


def _keys(
    graph: StitchGraph, heights: Array, flat: Array, least: Array, folded: Array, inside: Array
) -> dict[int, bytes]:
    """Part → digest of all that its layout depends on; of those that no other part is worked into, or joined to."""
    part, offsets = graph.part, graph.anchor_offsets
    holder = np.repeat(np.arange(len(graph)), np.diff(offsets))
    before = np.where(graph.previous < 0, np.arange(len(graph)), graph.previous)
    crossing = [part[a[m]] for a, b in ((holder, graph.anchors), (np.arange(len(graph)), before), graph.edges.T)
                for m in [part[a] != part[b]] for a in (a, b)]  # fmt: skip
    mixed = set(np.concatenate(crossing).tolist())
    of_edge = part[graph.edges[:, 0]]
    keys: dict[int, bytes] = {}
    for k, p in enumerate(graph.parts):
        if k in mixed or not 0 < p.end - p.start <= _LARGE:
            continue
        own = slice(p.start, p.end)
        held = [
            graph.round[own] - graph.round[p.start], graph.peculiarity[own], graph.direction[own], heights[own],
            graph.previous[own] - p.start, graph.parent[own] - p.start, folded[own], np.diff(offsets[p.start : p.end + 1]),
            graph.anchors[offsets[p.start] : offsets[p.end]] - p.start, graph.edges[of_edge == k] - p.start, graph.edge_kind[of_edge == k],
            np.array([flat[k], least[k] > 0.0]), inside[own],
        ]  # fmt: skip
        digest = blake2b(digest_size=16)
        for array in held:
            digest.update(array.tobytes() + b"|")
        keys[k] = digest.digest()
    return keys


class Forks:
    """Rings placed so far, by the branch of the work that they belong to, so that branches keep clear of each other.

    A branch ends where it is worked on twice, or together with another. ``upto`` says for every branch which of its
    and of other branches' sections lie below: all up to a number.
    """

    def __init__(self) -> None:
        self.branch: dict[int, int] = {}  # section → branch
        self.upto: list[dict[int, int]] = []
        self.worked: set[int] = set()
        self.rings: dict[int, list[tuple[int, int, Array, float]]] = {}  # part → section, branch, place, radius
        self.forked: set[int] = set()

    def clear(self, k: int, below: Array, place: Array, radius: float, part: int) -> Array:
        """Where ring ``k`` goes that is worked into the sections ``below``: beside rings of other branches, not in."""
        known = [int(s) for s in below if int(s) in self.branch]
        if len(known) == 1 and known[0] not in self.worked:
            mine = self.branch[known[0]]
        else:
            mine = len(self.upto)
            self.upto.append({})
            for s in known:
                for b, last in [*self.upto[self.branch[s]].items(), (self.branch[s], s)]:
                    self.upto[mine][b] = max(last, self.upto[mine].get(b, -1))
        self.worked.update(known)
        self.branch[k] = mine
        rings = self.rings.setdefault(part, [])
        if rings and rings[0][1] != mine:
            self.forked.add(part)
        if part in self.forked:
            for _ in range(8):
                least, away = 0.0, place
                for s, b, at, size in rings:
                    if b == mine or s <= self.upto[mine].get(b, -1) or abs(at[1] - place[1]) >= 1.0:
                        continue
                    off = (place - at) * [1.0, 0.0, 1.0]
                    far = float(np.sqrt((off**2).sum()))
                    if far < max(WITHIN, AMID * min(size, radius)):
                        continue  # a frill round what goes on: both were worked into the whole round below
                    if far - size - radius - CLEAR < least:
                        least = far - size - radius - CLEAR
                        away = place - least * (off / far if far > 1e-9 else np.array([1.0, 0.0, 0.0]))
                place = away
        rings.append((k, mine, place, radius))
        return place


def _begin(graph: StitchGraph, x: Array, nodes: Array, width: float, begun: int, flat: bool) -> Array:
    """Where a section goes that is worked into nothing: a new ring, a chain, or a bridge of chains."""
    a, count = int(nodes[0]), len(nodes)
    part = graph.parts[int(graph.part[a])]
    before = int(graph.previous[a])
    if before >= part.start:
        # A chain hangs on the work: to the stitch it is joined to, or up from where it began.
        last = graph.edges[graph.edges[:, 0] == nodes[-1], 1]
        last = last[(last < a) & (last != before)]
        t = np.arange(1, count + 1)[:, None] / (count + (0 if len(last) else 1))
        far = x[last[0]] if len(last) else x[before] + [0.0, float(count + 1), 0.0]
        arch = np.sin(math.pi * t) * (0.25 * count if len(last) else 0.0)
        return x[before] + (far - x[before]) * np.minimum(t, 1 - 0.5 / count) + arch * [0.0, 1.0, 0.0]
    origin = np.array([begun * (2.0 * width + 2.0), 0.0, 0.0])
    if count == 1:
        return origin[None]
    if flat:
        return origin + np.column_stack([np.arange(count) - 0.5 * (count - 1), np.zeros(count), np.zeros(count)])
    angle = BACK + graph.direction[nodes] * np.arange(count) * (2.0 * math.pi / count)
    radius = count / (2.0 * math.pi)
    return origin + np.column_stack([radius * np.cos(angle), np.zeros(count), radius * np.sin(angle)])


def on_axis(x: Array, start: int, end: int, count: int) -> Array:
    """``count`` points (count, 3) at regular intervals on the axis of the part ``start`` … ``end``.

    They divide its height into equal slices, one in the middle of each, at the middle of the nodes of that slice.
    """
    mine = x[start:end]
    low, high = mine[:, 1].min(), mine[:, 1].max()
    made = np.empty((count, 3))
    for k in range(count):
        a, b = low + (high - low) * k / count, low + (high - low) * (k + 1) / count
        inside = (mine[:, 1] >= a) & (mine[:, 1] <= b)
        made[k] = mine[inside].mean(0) if inside.any() else mine.mean(0)
        made[k, 1] = 0.5 * (a + b)
    return made

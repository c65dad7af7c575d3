"""Laid: rounds that grow as a circle does lie flat, whatever their stitches' heights say to the last twentieth."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import Final

import numpy as np

from tambour.core.check import Array
from tambour.core.graph import BLO, FLO, ROOT, SEWN, THROUGH, TIP, StitchGraph
from tambour.crochet.graph.layout import in_rows
from tambour.crochet.settle.arrange import cut
from tambour.crochet.settle.body import Body, State, joined_up
from tambour.crochet.settle.forces import lengths
from tambour.crochet.settle.rest import settle, tolerance

NEARLY: Final = (0.85, 1.1)
"""Rounds lie flat whose way out is so much of their rows' height, from the least to the most."""
TUBE: Final = 0.8
"""A tube has such a share of its stitches over single ones, or more."""
EDGE: Final = 0.1
"""How stiff fabric is at a sheet's edge, as a share of what it is elsewhere: there it was worked to turn."""
STIFF: Final = 5.0
"""How strongly a sheet keeps its plane, against 1 for stretching: where a spiral turns up into a wall it steps, by a row, and at 2 the rim gave way by half of one."""
MOST: Final = 2.5
"""The largest weight of a hinge."""
WITHIN: Final = 0.2
"""How far within their round chains lie that lift it, in stitches."""
ROUGHLY: Final = 3.0
"""How many times farther from rest than others a sheet may be that only tells its lengths."""


@dataclass(frozen=True, slots=True)
class Sheets:
    """The flat middles of parts: from their rings to their ``last`` stitches, (S,) each; and what braces them: ``pairs`` (K, 2) of
    stitches beside each other in two rounds, and how far they are ``apart`` (K,), in stitches; ``hinges`` (H, 4) of two triangles
    each with ``weights`` (H, 4), as :func:`tambour.crochet.settle.forces.flat` takes them."""

    first: tuple[int, ...] = ()
    last: tuple[int, ...] = ()
    pairs: Array = field(default_factory=lambda: np.zeros((0, 2), np.int64))
    apart: Array = field(default_factory=lambda: np.zeros(0))
    hinges: Array = field(default_factory=lambda: np.zeros((0, 4), np.int64))
    weights: Array = field(default_factory=lambda: np.zeros((0, 4)))


def laid(graph: StitchGraph, body: Callable[[StitchGraph], Body]) -> tuple[StitchGraph, Sheets]:
    """The graph with rest lengths by which the middles of unstuffed parts lie flat, as they do in the hand.

    Six single crochets more in each round are a circle, all but exactly: rows a little high, or legs that lean beside an
    increase, make a cone of it, and a cone of a twentieth is already as deep as a fifth of its radius. Wool gives way
    by so much. So where rounds from a ring on grow as a circle's do, to the end or to a wall that is worked in one loop,
    they are settled in a plane, and keep the lengths that they have there. (A wall without such an edge makes a bowl.) Along the work and
    across it alone stitches could shear, and what was flat be a cone again: so they are braced, and the wall too, which would
    lean over, as tubes do that are open below.

    body : what makes a body of a graph
    """
    rest = graph.rest.copy()
    braces, apart, spans = [np.zeros((0, 2), np.int64)], [np.zeros(0)], []
    hinges, weights = [np.zeros((0, 4), np.int64)], [np.zeros((0, 4))]
    known: dict[tuple[bytes, ...], Array] = {}
    for part in graph.parts:
        if part.stuffing > 0.0 or part.end - part.start < 12 or graph.peculiarity[part.start] != ROOT:
            continue
        last = _flat(graph, part.start, part.end)
        if last <= part.start:
            continue
        spans.append((part.start, last))
        piece = cut(graph, np.arange(part.start, last + 1))
        mine = np.flatnonzero((graph.edges >= part.start).all(1) & (graph.edges <= last).all(1))
        key = (piece.edges.tobytes(), piece.rest.tobytes(), piece.round.tobytes())
        if key not in known:
            sheet = body(piece)
            state = State(_spiral(piece), np.zeros((0, 3)), np.zeros(1))
            for _ in settle(sheet, state, ROUGHLY * tolerance(len(sheet))):
                pass
            known[key] = _lifted(piece, state.x)
        x = known[key]
        rest[mine] = lengths(x, piece.edges) * graph.stitch_width
        through = piece.edges[(piece.edge_kind == THROUGH) & (piece.edges[:, 1] > 0)]
        for step in (-1, 1):
            pairs = through + np.array([0, step])
            pairs = pairs[(pairs[:, 1] > 0) & (pairs[:, 1] < pairs[:, 0])]
            braces.append(pairs + part.start)
            apart.append(lengths(x, pairs))
        four = _hinges(piece.faces)
        hinges.append(four + part.start)
        weights.append(_weights(x[:, [0, 2]][four]))
    first, ends = zip(*spans) if spans else ((), ())
    pairs, far = _cells(graph)
    stands = _tubes(graph, pairs)
    stands[graph.part[list(first)]] = True
    new = stands[graph.part[pairs[:, 0]]] & ~np.isin(pairs[:, 0], np.concatenate(braces))
    braces.append(pairs[new])
    apart.append(far[new])
    return replace(graph, rest=rest), Sheets(
        first, ends, *(np.concatenate(each) for each in (braces, apart, hinges, weights))
    )


def _lifted(graph: StitchGraph, x: Array) -> Array:
    """Places (N, 3) in a plane with the chains that lift rounds a little within the line from a round's last stitch to its first: as
    long as that together they lay on either side of it, and triangles upon triangles."""
    x = x.copy()
    for c in np.flatnonzero((np.diff(graph.anchor_offsets) == 0) & (graph.peculiarity != ROOT)).tolist():
        others = [int(e.sum()) - c for e in graph.edges[(graph.edges == c).any(1)]]
        beside = [k for k in others if graph.round[k] == graph.round[c]]
        if len(beside) == 2 and graph.previous[c] >= 0:
            middle = x[beside].mean(0)
            inwards = x[graph.previous[c]] - middle
            x[c] = middle + WITHIN * inwards / max(float(np.linalg.norm(inwards)), 0.1)
    return x


def _hinges(faces: Array) -> Array:
    """The corners (H, 4) of every two triangles with an edge in common: first the edge's, then those off it."""
    sides = np.concatenate([faces[:, [0, 1, 2]], faces[:, [1, 2, 0]], faces[:, [2, 0, 1]]])
    low, high = sides[:, :2].min(1), sides[:, :2].max(1)
    order = np.lexsort((high, low))
    one, two = order[:-1], order[1:]
    same = (low[one] == low[two]) & (high[one] == high[two])
    return np.column_stack([low[one], high[one], sides[one, 2], sides[two, 2]])[same]


def _weights(at: Array) -> Array:
    """Weights (H, 4), the last -1 (about slivers less than that), by which four places (H, 4, 2) in a plane sum to nothing, however the plane is turned or drawn out."""
    a, b, c, d = np.moveaxis(at, 1, 0)

    def area(p: Array, q: Array, r: Array) -> Array:
        u, v = q - p, r - p
        return np.asarray(u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0])

    whole = area(a, b, c)
    whole = np.where(abs(whole) > 0.05, whole, np.inf)  # next to no triangle: no hinge
    made = np.column_stack([area(d, b, c) / whole, area(a, d, c) / whole, area(a, b, d) / whole, -np.ones(len(at))])
    made = np.where(np.isfinite(whole)[:, None], made, 0.0)
    # About a sliver of a triangle, as beside the chain that lifts a round, they would be many times as stiff as elsewhere.
    return np.asarray(made / np.maximum(1.0, abs(made).max(1) / MOST)[:, None])


def _cells(graph: StitchGraph) -> tuple[Array, Array]:
    """The diagonals (K, 2) of fabric's plain cells, two stitches over two beside each other, and their lengths (K,)."""
    n = len(graph)
    single = (np.diff(graph.anchor_offsets) == 1) & ~np.isin(graph.peculiarity, (ROOT, TIP))
    i = np.flatnonzero(
        single[1:] & single[:-1] & (graph.previous[1:] == np.arange(n - 1)) & (graph.part[1:] == graph.part[:-1])
    )
    a, b = graph.anchors[graph.anchor_offsets[i]], graph.anchors[graph.anchor_offsets[i + 1]]
    ok = (abs(a - b) == 1) & (graph.previous[np.maximum(a, b)] == np.minimum(a, b)) & (np.maximum(a, b) < i)
    i, a, b = i[ok], a[ok], b[ok]
    high = np.zeros(n)
    through = graph.edge_kind == THROUGH
    high[graph.edges[through, 0]] = graph.rest[through] / graph.stitch_width
    return np.concatenate([np.column_stack([i, b]), np.column_stack([i + 1, a])]), np.hypot(
        1.0, np.concatenate([high[i], high[i + 1]])
    )


def _tubes(graph: StitchGraph, pairs: Array) -> Array:
    """Which parts (P,) are unstuffed tubes that stand by themselves: all but sheer rounds, sewn to nothing. ``pairs``: as of :func:`_cells`."""
    count = len(graph.parts)
    worked = np.bincount(graph.part[np.diff(graph.anchor_offsets) > 0], minlength=count)
    plain = np.bincount(graph.part[pairs[:, 0]], minlength=count) // 2
    sewn = np.zeros(count, np.bool_)
    sewn[graph.part[graph.edges[graph.edge_kind == SEWN]].ravel()] = True
    empty = np.array([p.stuffing == 0.0 for p in graph.parts])
    return np.asarray(empty & ~sewn & ~in_rows(graph) & (plain > TUBE * np.maximum(worked, 1)))


def flattened(graph: StitchGraph, x: Array, sheets: Sheets) -> Array:
    """First positions (N, 3) with every sheet in its plane, and what follows it as far from it as before: to lie flat takes next
    to no force, so what begins hollow stays so."""
    x = x.copy()
    for first, last in zip(sheets.first, sheets.last):
        end = next(p.end for p in graph.parts if p.start == first)
        rim = x[: last + 1][graph.round[: last + 1] == graph.round[last], 1].mean()
        x[last + 1 : end, 1] -= rim - x[first, 1]
        x[first : last + 1, 1] = x[first, 1]
    return x


def braced(body: Body, nodes: Array, sheets: Sheets) -> Body:
    """The body of ``nodes`` (rising) with what :func:`laid` says of its sheets: braced, free to turn up at their edges, and
    kept in their planes; what else keeps fabric straight would draw upon rounds that are bent in the plane."""
    if not len(sheets.pairs):
        return body
    made = joined_up(body, nodes, sheets.pairs, sheets.apart, np.zeros((0, 4), np.int64))
    flat = np.isin(nodes, np.concatenate([np.arange(a, b + 1) for a, b in zip((0, *sheets.first), (-1, *sheets.last))]))
    inside = flat[made.triples]
    within, edge = inside.all(1), inside.any(1)
    own = np.isin(sheets.hinges, nodes).all(1)
    return replace(
        made,
        bending=np.where(within, 0.0, np.where(edge, EDGE, 1.0) * made.bending),
        hinges=np.searchsorted(nodes, sheets.hinges[own]).astype(np.int32),
        weights=np.ascontiguousarray(sheets.weights[own]),
        plane=STIFF,
    )


def _flat(graph: StitchGraph, start: int, end: int) -> int:
    """The last stitch of the rounds from the ring ``start`` on that lie flat, single stitches in a spiral or in joined rounds, which chains lift; or the ring itself."""
    own = np.arange(start + 1, end)
    over = np.diff(graph.anchor_offsets)[own]
    begins = np.concatenate([[True], graph.round[own[1:]] != graph.round[own[:-1]]])
    lifts = (over == 0) & begins
    for _ in range(3):  # a chain lifts single crochets, three a double
        lifts[1:] |= (over[1:] == 0) & lifts[:-1]
    plain = (
        (graph.part[own] == graph.part[start])
        & ~np.isin(graph.peculiarity[own], (ROOT, TIP))
        & ((over == 1) | lifts)
        & (graph.direction[own] == graph.direction[start + 1])
        & (graph.round[own] >= 0)
    )
    plain[1:] &= (graph.previous[own[1:]] == own[:-1]) | (lifts & begins)[1:]
    if not plain.all():
        own = own[: int(np.argmin(plain))]
    if not len(own):
        return start
    _, begin, size = np.unique(graph.round[own], return_index=True, return_counts=True)
    stop = begin + size
    chains = np.add.reduceat(lifts[: len(own)].astype(np.int64), begin)
    begin, size = begin + chains, size - chains
    if size[-1] == 0 and len(size) > 1:  # chains after the last join, for a round that does not come
        begin, size, end = begin[:-1], size[:-1], int(own[0] + stop[-2])
    if not size[0]:
        return start  # chains alone are no base
    edge = np.isin(graph.peculiarity[own], (BLO, FLO))
    through = graph.edge_kind == THROUGH
    high = np.zeros(len(graph))
    high[graph.edges[through, 0]] = graph.rest[through] / graph.stitch_width
    last, way = -1, 0.0
    for k in range(len(size)):
        row = float(high[own[begin[k]] : own[begin[k]] + size[k]].mean())
        way += row
        grown = float(size[k] - (size[k - 1] if k else 0)) / (2.0 * np.pi)
        if edge[begin[k]] or not NEARLY[0] * way <= size[k] / (2.0 * np.pi) <= NEARLY[1] * way:
            break
        if not NEARLY[0] * row <= grown <= NEARLY[1] * row and k:
            break
        last = k
    # A wall without an edge is a bowl's, and what is not closed to its end no sheet by itself.
    turns = last + 1 < len(size) and edge[begin[last + 1]]
    if last < 2 or not (turns or own[0] + stop[last] == end):
        return start
    return int(own[0] + stop[last] - 1)


def _spiral(graph: StitchGraph) -> Array:
    """Places (N, 3), in widths, of a ring and the rounds about it on a flat spiral, a stitch on every width of it."""
    number = np.arange(len(graph) - 1)
    _, begin, count = np.unique(graph.round[1:], return_index=True, return_counts=True)
    around = np.interp(number, begin + 0.5 * (count - 1), count)
    turn = 2.0 * np.pi * np.concatenate([[0.0], np.cumsum(1.0 / around)[:-1]])
    radius = around / (2.0 * np.pi)
    made = np.zeros((len(graph), 3))
    made[1:, 0], made[1:, 2] = radius * np.cos(turn), -radius * np.sin(turn)
    return made

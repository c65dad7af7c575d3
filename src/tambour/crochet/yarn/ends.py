"""The yarn's ends: how it begins at a ring, a chain or anew, how it is woven in, and the points put in between those of stitches."""

from __future__ import annotations

import numpy as np

from tambour.core.check import Array
from tambour.core.graph import StitchGraph
from tambour.crochet.yarn.loops import TALL

# What a node is to the yarn.
NONE, STITCH, CHAINED = 0, 1, 2

# Ends and joins in (u, v, w); heights are those in a single crochet.
# An end is woven in: it runs along its own row, close behind the fabric, whichever side that is in a turned row.
INWARD = np.array([(0.50, 0.42, -0.50), (0.0, 0.38, -0.53), (-0.55, 0.38, -0.53), (-1.1, 0.40, -0.50)])
OUTWARD = np.array([(2.3, 0.48, -0.50), (1.7, 0.46, -0.53), (1.2, 0.46, -0.53), (0.86, 0.46, -0.36)])
ONWARD = np.array([(0.45, 0.62, -0.50), (0.9, 0.5, -0.53), (1.4, 0.5, -0.53), (1.9, 0.52, -0.50)])
_BEGIN = np.array([(1.2, 0.44, -0.50), (0.65, 0.42, -0.53), (0.1, 0.45, -0.53), (-0.22, 0.52, -0.45)])
# From a stitch in the front of a turned row an end gets behind the fabric around the edge.
_EDGE = np.array([(0.70, 0.46, 0.0)])
# The first chain's loop begins where the edge is: a slip knot, about which the yarn comes to the front.
_KNOT = np.array(
    [(0.40, 0.50, -0.46), (0.0, 0.62, -0.34), (-0.06, 0.78, -0.06), (0.10, 0.74, 0.16), (0.38, 0.60, 0.14)]
)
# Where a magic ring is drawn tight its end lies across the middle: over the far side of the ring, the middle, this side.
_FAR = np.array([(0.0, 0.75, -0.50), (0.0, 0.25, -0.48)])
_MIDDLE = np.array([(0.0, 1.0, -0.30)])
_RING = np.array([(-0.2, 0.15, -0.15)])
_ROUND = np.array([(-0.25, 0.22, 0.0), (0.05, 0.24, 0.02), (0.42, 0.22, 0.0)])
_GATHER = np.array([(0.3, 0.3, -0.2), (0.75, 0.3, -0.2)])
_CLOSE = np.array([(0.2, 0.8, -0.3), (0.2, 1.0, -0.7), (0.2, 0.9, -1.2)])

OPEN = 1.3
"""A magic ring of stitches as high as this stays open: its end is woven in behind them, and does not cross it."""

# What comes first where several things happen at one place of the yarn.
AFTER, END, BREAK, START = range(4)
CUT = -20  # and on: what hangs out of fur


class Pieces:
    """Points to put in between those of the stitches, and where strands begin."""

    def __init__(self) -> None:
        self.rows: list[tuple[int, int, int, int, float, float, float]] = []
        self.breaks: list[tuple[int, int, int]] = []

    def put(self, where: int, when: int, cell: int, below: int, rows: Array, rise: float = 0.0) -> None:
        """Points ``rows`` (K, 3) in a cell, before the point that is now number ``where``."""
        self.rows += [(where, when, cell, below, u, v + rise, w) for u, v, w in rows.tolist()]

    def begin(self, where: int, stitch: int, when: int = BREAK) -> None:
        """A strand begins with the point that is now number ``where``, or with what is put before it from ``when`` on."""
        self.breaks.append((where, stitch, when))


def behind(graph: StitchGraph, i: int, rows: Array, edge: Array | None = None) -> Array:
    """An end's points at stitch ``i``, behind the fabric also where its row shows its back; around the ``edge`` to there."""
    if graph.direction[i] >= 0:
        return rows
    turned = rows * np.array([1.0, 1.0, -1.0])
    if edge is None:
        return turned
    return np.vstack([turned, edge] if rows is OUTWARD else [edge, turned])


def begun(
    graph: StitchGraph,
    pieces: Pieces,
    i: int,
    on: int,
    where: int,
    role: Array,
    ring: Array,
    follows: Array,
    drop: Array,
    *,
    anew: bool = True,
) -> None:
    """The yarn's beginning before stitch ``i``: a magic ring, the first chain, or yarn joined anew; not ``anew``: it comes from the stitch before."""
    if anew:
        pieces.begin(where, i)
    if ring[i]:
        # A tail across the middle, once around the ring, then into it.
        k = i
        while k < len(graph) and ring[k] and graph.parent[k] == graph.parent[i] and (k == i or follows[k]):
            k += 1
        if graph.height[i] < OPEN:
            pieces.put(where, START, (i + k) // 2, on, behind(graph, i, _FAR))
            pieces.put(where, START, i, -2 - on, behind(graph, i, _MIDDLE))
        else:
            pieces.put(where, START, i, on, behind(graph, i, _BEGIN))
        pieces.put(where, START, i, on, _RING)
        for n in range(i, k):
            pieces.put(where, START, n, on, _ROUND)
        drop[where : where + 4] = True
    elif role[i] == CHAINED:
        # Posts of tall stitches stand further in than the legs of others.
        at = np.searchsorted(graph.anchor_offsets, np.flatnonzero(graph.anchors == i), side="right") - 1
        wide = bool((graph.height[at] < TALL).any())
        pieces.put(where, START, i, -1, behind(graph, i, np.vstack([OUTWARD, _KNOT]) if wide else OUTWARD))
        drop[where : where + 4] = True
    else:
        pieces.put(where, START, i, on, behind(graph, i, _BEGIN), float(graph.height[i]) - 1)


def ended(graph: StitchGraph, pieces: Pieces, i: int, on: int, where: int, tip: int | None) -> None:
    """The yarn's end after stitch ``i``: drawn through the last round's stitches and inside, or only inside."""
    if tip is None:
        pieces.put(where, END, i, on, behind(graph, i, INWARD, _EDGE), float(graph.height[i]) - 0.9)
        return
    for a in graph.anchors[graph.anchor_offsets[tip] : graph.anchor_offsets[tip + 1]].tolist():
        pieces.put(where, END, a, -2 - tip, _GATHER)
    pieces.put(where, END, i, -2 - tip, _CLOSE)

"""Steps: the seed's simulation as it stands, a step at a time, from rounds or building one by one."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from tambour.core.check import Array
from tambour.core.graph import SEWN, StitchGraph
from tambour.crochet.body import Body, State, displacement, grown

APART = 10.0
"""One by one: how far from one another the beginnings of parts are placed, in d."""

Step = Callable[[int, int], None]


def step(body: Body, state: State) -> Array:
    """One step: all forces on the positions as they are, then positions move. Gives what was added (N, 3)."""
    moved = body.step * displacement(body, state)
    state.x = state.x + moved
    return moved


def run(body: Body, state: State, count: int, tell: Step = lambda done, total: None) -> None:
    """Take ``count`` steps."""
    for k in range(count):
        step(body, state)
        if k % 64 == 0:
            tell(k, count)


def first_place(graph: StitchGraph, x: Array, i: int, d: float) -> Array:
    """Where node ``i`` appears (3,), from the nodes x (i, 3) that are there (seed, "One by one initializer").

    The first of a part's nodes stands at the origin (later beginnings 10 d further along x each), the next two at
    (d, 0.1 d, 0) and (0, 0.2 d, d) from it, every other one d above the middle of the earlier nodes it is joined to.
    """
    starts = _starts(graph)
    begin = int(starts[np.searchsorted(starts, i, side="right") - 1])
    if i == begin:
        return np.array([APART * d * int(np.searchsorted(starts, i)), 0.0, 0.0])
    if i == begin + 1:
        return x[begin] + [d, 0.1 * d, 0.0]
    if i == begin + 2:
        return x[begin] + [0.0, 0.2 * d, d]
    return x[_joined(graph, i)].mean(0) + np.array([0.0, d, 0.0])


def _starts(graph: StitchGraph) -> Array:
    """Nodes that are joined to nothing earlier (sewing aside), rising."""
    bound = np.zeros(len(graph), bool)
    bound[graph.edges[graph.edge_kind != SEWN, 0]] = True
    return np.flatnonzero(~bound)


def _joined(graph: StitchGraph, i: int) -> Array:
    return graph.edges[(graph.edges[:, 0] == i) & (graph.edge_kind != SEWN), 1]


class Building:
    """A piece that is worked while it moves: nodes come once the last one is at rest, or has had its time.

    graph, body : the whole piece; d, force, wait : link distance, and when the next node comes
    counts : (P,) centroids of each part in the end; every : a part gets its next one with each so many nodes
    """

    def __init__(
        self, graph: StitchGraph, body: Body, d: float, force: float, wait: int, counts: Array, every: int
    ) -> None:
        self.graph, self.whole, self.d = graph, body, d
        self.force, self.wait, self.counts, self.every = force, wait, counts, every
        self.body = grown(body, 0)
        self.state = State(np.zeros((0, 3)), np.zeros((0, 3)), np.zeros(len(graph.parts)))
        self.last, self.waited = 0.0, 0

    @property
    def done(self) -> bool:
        """Whether every node is there."""
        return len(self.body) == len(self.whole)

    def tick(self) -> None:
        """Add a node when it is time, then take a step. The first tick begins with the first node alone."""
        if not len(self.body):
            self.grow()
        if not self.done and (self.last < self.force or self.waited >= self.wait):
            self.grow()
        moved = step(self.body, self.state)
        self.last, self.waited = float(np.sqrt((moved[-1] ** 2).sum())), self.waited + 1

    def grow(self) -> None:
        """Add the next node, and a centroid where one is due: amid the part's latest nodes."""
        m = len(self.body)
        if m >= len(self.whole):
            return
        x = np.vstack([self.state.x, first_place(self.graph, self.state.x, m, self.d)])
        self.state.x, self.state.listed = x, None
        body = grown(self.whole, m + 1)
        if body.stuffing == "centroid":
            here = np.bincount(body.part, minlength=len(self.counts))
            due = np.minimum(self.counts, -(-here // self.every))
            first = np.concatenate([[0], np.cumsum(due)])
            p = int(body.part[m])
            if first[-1] > len(self.state.c):
                latest = np.flatnonzero(body.part == p)[-self.every :]
                self.state.c = np.insert(self.state.c, first[p + 1] - 1, x[latest].mean(0), axis=0)
            body = _with_first(body, first)
        self.body, self.waited = body, 0


def _with_first(body: Body, first: Array) -> Body:
    from dataclasses import replace

    return replace(body, first=first.astype(np.int64))

"""Steps: the seed's simulation as it stands, a step at a time, from rounds or building one by one."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from tambour.core.check import Array
from tambour.core.graph import SEWN, StitchGraph
from tambour.crochet.settle.body import Body, State, displacement, grown
from tambour.geometry.motion import length

APART = 10.0
"""One by one: how far from one another the beginnings of parts are placed, in d."""
USUAL = 8
"""One by one: steps that a node takes in all but the oddest shapes; how many it may, is said."""
LEAP = 1.0
"""One by one: how far a node moves in a step at the most, in d, once one has had its time and is not at rest. A centroid that comes upon a
stitch throws it a hundred stitches off, and links, which pull all but as hard however far it is, throw it and in the end all others to and
fro for ever: of a ball of 974 none came to rest from the 692nd on, and each waited its whole time."""


def step(body: Body, state: State, held: Array | None = None) -> Array:
    """One step: all forces on the positions as they are, then positions move. Gives what was added (N, 3).

    held : (N,) bool, nodes that stay where they are
    """
    moved = body.step * displacement(body, state, held=held)
    state.x = state.x + moved
    return moved


def steps(body: Body, state: State, count: int, held: Array | None = None) -> Iterator[int]:
    """Take ``count`` steps; yields how many were taken, after each, so that whoever runs it can look at ``state.x``."""
    for k in range(count):
        step(body, state, held)
        yield k + 1


def first_place(starts: Array, joined: Array, x: Array, i: int, d: float) -> Array:
    """Where node ``i`` appears (3,), from the nodes x that are there (seed, "One by one initializer").

    starts : nodes joined to nothing earlier, rising; joined : the earlier nodes that node i is joined to

    The first of a part's nodes stands at the origin (later beginnings 10 d further along x each), the next two at
    (d, 0.1 d, 0) and (0, 0.2 d, d) from it, every other one d above the middle of the earlier nodes it is joined to.
    """
    begin = int(starts[np.searchsorted(starts, i, side="right") - 1])
    if i == begin:
        return np.array([APART * d * int(np.searchsorted(starts, i)), 0.0, 0.0])
    if i == begin + 1:
        return x[begin] + [d, 0.1 * d, 0.0]
    if i == begin + 2:
        return x[begin] + [0.0, 0.2 * d, d]
    return x[joined].mean(0) + np.array([0.0, d, 0.0])


def _starts(graph: StitchGraph) -> Array:
    """Nodes that are joined to nothing earlier (sewing aside), rising."""
    bound = np.zeros(len(graph), bool)
    bound[graph.edges[graph.edge_kind != SEWN, 0]] = True
    return np.flatnonzero(~bound)


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
        self.last, self.waited, self.restless = 0.0, 0, False
        self._first = np.zeros(len(graph.parts) + 1, np.int64)
        self._starts = _starts(graph)
        made = graph.edges[graph.edge_kind != SEWN]
        made = made[np.argsort(made[:, 0], kind="stable")]
        self._ends = np.searchsorted(made[:, 0], np.arange(len(graph) + 1))
        self._earlier = made[:, 1]

    def _place(self, x: Array, i: int) -> Array:
        return first_place(self._starts, self._earlier[self._ends[i] : self._ends[i + 1]], x, i, self.d)

    def finish(self) -> None:
        """Place all nodes that are still to come, without any step between."""
        m, n = len(self.body), len(self.whole)
        if m == n:
            return
        x = np.concatenate([self.state.x, np.zeros((n - m, 3))])
        for i in range(m, n):
            x[i] = self._place(x, i)
        self.body, self.state.x, self.state.listed = self.whole, x, None
        if self.whole.stuffing == "centroid":
            first = np.concatenate([[0], np.cumsum(self.counts)])
            c, had = np.zeros((int(first[-1]), 3)), self._first
            for p, part in enumerate(self.graph.parts):
                old = self.state.c[had[p] : had[p + 1]]
                c[first[p] : first[p] + len(old)] = old
                if part.end > part.start:
                    c[first[p] + len(old) : first[p + 1]] = x[part.start : part.end].mean(0)
            self.state.c = c

    @property
    def done(self) -> bool:
        """Whether every node is there."""
        return len(self.body) == len(self.whole)

    def tick(self, held: Array | None = None) -> None:
        """Add a node when it is time, then take a step. The first tick begins with the first node alone.

        held : (N,) bool over the whole piece, nodes that stay where they appear
        """
        if not len(self.body):
            self.grow()
        if not self.done and (self.last < self.force or self.waited >= self.wait):
            self.restless |= self.last >= self.force and len(self.body) > 0
            self.grow()
        moved = step(self.body, self.state, None if held is None else held[: len(self.body)])
        if self.restless:
            size = length(moved)
            more = moved * np.maximum(1.0 - LEAP * self.d / np.maximum(size, 1e-9), 0.0)[:, None]
            self.state.x, moved = self.state.x - more, moved - more
        self.last, self.waited = float(np.sqrt((moved[-1] ** 2).sum())), self.waited + 1

    def grow(self) -> None:
        """Add the next node, and a centroid where one is due: amid the part's latest nodes."""
        m = len(self.body)
        if m >= len(self.whole):
            return
        x = np.vstack([self.state.x, self._place(self.state.x, m)])
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
            self._first = first
            body = replace(body, first=first.astype(np.int64))
        self.body, self.waited = body, 0

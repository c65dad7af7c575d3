"""Tiny crochet graphs made without the language: balls, tubes and bowls, for tests of the simulation."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from tambour.core import graph as g

Rows = list[list[str]]
TEXT_BALL = """== Ball ==
R1: MR(6)
R2: 6 inc
R3: [sc, inc] x 6
R4: [2 sc, inc] x 6
R5-R8: 24 sc
R9: [2 sc, dec] x 6
R10: [sc, dec] x 6
R11: 6 dec
FO
"""
"""A ball of 24 stitches around, in the language."""


def ball_rows(k: int, m: int) -> Rows:
    """k rounds of six increases each (the ring is the first), m plain rounds, and back again."""
    up = [(["sc"] * (i - 1) + ["inc"]) * 6 for i in range(1, k)]
    return up + [["sc"] * (6 * k)] * m + [(["sc"] * (i - 1) + ["dec"]) * 6 for i in range(k - 1, 0, -1)]


def tube_rows(around: int, m: int) -> Rows:
    """A tube of ``around`` stitches with flat ends, m plain rounds."""
    return ball_rows(around // 6, m)


def make(rows: Rows, ring: int = 6, closed: bool = True, stuffing: float = 1.0) -> g.StitchGraph:
    """One part worked in a spiral from a ring; ``closed``: fastened off through the stitches left."""
    edges, faces, anchors, previous = [], [], [[]], [-1]
    parent, rounds, kinds = [-1], [0], ["ring"]
    for i in range(1, ring + 1):
        anchors.append([0])
        previous.append(i - 1 if i > 1 else -1)
        parent.append(0)
        rounds.append(1)
        kinds.append("sc")
        edges.append((i, 0))
        if i > 1:
            edges.append((i, i - 1))
            faces.append((0, i - 1, i))
    faces.append((0, ring, 1))
    queue, last, n = list(range(1, ring + 1)), None, ring + 1
    for r, row in enumerate(rows):
        for op in row:
            taken = [queue.pop(0), queue.pop(0)] if op == "dec" else [queue.pop(0)]
            for _ in range(2 if op == "inc" else 1):
                below = taken[0] if last is None else last
                chain = [below] + [a for a in taken if a != below]
                edges += [(n, a) for a in taken]
                edges.append((n, n - 1))
                faces += [(b, a, n) for a, b in pairwise(chain)]
                if n - 1 not in chain:
                    faces.append((chain[0], n - 1, n))
                anchors.append(taken)
                previous.append(n - 1)
                parent.append(taken[-1])
                rounds.append(r + 2)
                kinds.append(op)
                last = taken[-1]
                queue.append(n)
                n += 1
    if closed:
        faces.append((last, n - 1, queue[0]))
        edges += [(n, a) for a in queue]
        faces += [(b, a, n) for a, b in zip(queue, queue[1:] + queue[:1])]
        anchors.append(list(queue))
        previous.append(n - 1)
        parent.append(-1)
        rounds.append(len(rows) + 2)
        kinds.append("tip")
        n += 1
    names = tuple(sorted(set(kinds)))
    peculiarity = np.zeros(n, np.uint8)
    peculiarity[0] = g.ROOT
    if closed:
        peculiarity[-1] = g.TIP
    pairs = np.array(sorted(set(edges)))
    return g.StitchGraph(
        kind=np.array([names.index(k) for k in kinds]),
        kinds=names,
        part=np.zeros(n, int),
        color=np.full((n, 3), 200),
        parent=np.array(parent),
        round=np.array(rounds),
        loop=np.zeros(n, int),
        direction=np.ones(n, int),
        height=np.ones(n),
        peculiarity=peculiarity,
        plane=np.full((n, 3), -1),
        span=np.zeros((n, 2), int),
        edges=pairs,
        edge_kind=np.zeros(len(pairs), int),
        rest=np.full(len(pairs), 5.0),
        faces=np.array(faces),
        parts=(g.Part("toy", 0, n, stuffing),),
        anchors=np.concatenate([np.array(a, int) for a in anchors]),
        anchor_offsets=np.cumsum([0] + [len(a) for a in anchors]),
        previous=np.array(previous),
    )


def ball(k: int, m: int) -> g.StitchGraph:
    return make(ball_rows(k, m))


def tube(around: int, m: int) -> g.StitchGraph:
    return make(tube_rows(around, m))

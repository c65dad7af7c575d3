"""Bones: the skeleton of a piece, from its rounds.

A point-cloud method must search for a shape's axis (Jayadevan, Delp, Pizlo: arXiv 1912.11932); a crochet pattern
tells it. A round is a cross-section, the middle of its stitches a point of the axis, and the stitches it is worked
into say which round is below. Towards an end the axis stops one radius short, as that of a ball does in its middle.
"""

from __future__ import annotations

import math

import numpy as np

from tambour.core.check import Array
from tambour.core.graph import StitchGraph

LEAST = 3
"""A section of fewer stitches is not a cross-section."""


def bones(graph: StitchGraph, section: Array, heights: Array) -> tuple[Array, Array, Array, Array]:
    """The skeleton: radius (S,) of its sections, their nodes as ragged lists, and their neighbours (S, 2).

    section : (N,) as of layout.sections; heights : (N,) row heights in stitches
    A section may serve when it lies as deep, by 2/π of the way over the fabric, as it is wide (a half ball's pole is
    π/2 radii from its rim); the deepest of a part always may. Of those, one for each radius of the way is taken.
    """
    n = len(graph)
    count = int(section[-1]) + 1 if n else 0
    size = np.bincount(section, minlength=count)
    radius = size / (2.0 * math.pi)
    start = np.searchsorted(section, np.arange(count))
    part = graph.part[start] if n else np.zeros(0, int)
    tall = np.bincount(section, heights, minlength=count) / np.maximum(size, 1)
    below = np.full(count, -1)
    for s in range(count):
        a, b = start[s], start[s] + size[s]
        under = graph.anchors[graph.anchor_offsets[a] : graph.anchor_offsets[b]]
        under = section[under[under < a]]
        if len(under):
            below[s] = np.bincount(under).argmax()
    down, up = np.zeros(count), np.zeros(count)
    for s in range(count):
        if below[s] >= 0:
            down[s] = down[below[s]] + tall[s]
    for s in range(count - 1, -1, -1):
        if below[s] >= 0:
            up[below[s]] = max(up[below[s]], up[s] + tall[s])
    depth = 2.0 / math.pi * np.minimum(down, up) - radius
    able = (depth >= 0.0) & (size >= LEAST)
    for p in np.unique(part):
        mine = np.flatnonzero((part == p) & (size >= LEAST))
        if len(mine) and not able[mine].any():
            able[mine[depth[mine].argmax()]] = True

    # Up every branch, the next that is a radius away from the last one taken.
    keep, last = np.zeros(count, bool), np.full(count, -1)
    for s in range(count):
        last[s] = last[below[s]] if below[s] >= 0 else -1
        if able[s] and (last[s] < 0 or down[s] - down[last[s]] >= radius[s]):
            keep[s], last[s] = True, s

    number = np.cumsum(keep) - 1
    neighbours = np.full((int(keep.sum()), 2), -1)
    for s in np.flatnonzero(keep).tolist():
        t = int(last[below[s]]) if below[s] >= 0 else -1
        if t >= 0:
            neighbours[number[s], 0] = number[t]
            if neighbours[number[t], 1] < 0:
                neighbours[number[t], 1] = number[s]
    members = np.flatnonzero(keep[section]) if n else np.zeros(0, int)
    offsets = np.concatenate([[0], np.cumsum(size[keep])])
    return radius[keep], offsets.astype(np.int64), members.astype(np.int32), neighbours.astype(np.int32)

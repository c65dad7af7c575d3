"""Upright: the Vs of stitches stand upright, whatever way their columns go."""

from __future__ import annotations

from typing import Final

import numpy as np

from tambour.core.arrays import B1x1, F8x1, F8x2, I4x1, I8x1
from tambour.core.check import Array
from tambour.core.graph import ROOT, StitchGraph
from tambour.core.kernels import kernel
from tambour.core.threads import share
from tambour.crochet.yarn.course import Course, on_row
from tambour.crochet.yarn.lead import Way
from tambour.crochet.yarn.points import BLOCK, erect

SLANTS: Final = {"over": 0.14, "under": 0.08}
"""How far the middle of a V moves along the work in a cell whose column stands upright, in widths over its height; what of it is brought upright."""
MIDDLE: Final = 0.23
"""Where in its cell a V stands."""
CLIMB: Final = 1.5
"""A spiral's rows climb by a row a round, and what stands upright on them leans back in a thin limb: by so much over the stitches around."""
MOST: Final = 0.8
"""Legs are brought upright by so much at the most, in widths over a stitch's height."""


def upright(at: Array, led: Way, graph: StitchGraph, rows: Course, hold: str) -> Array:
    """The way's points (P, 3) with the legs of stitches brought upright, each by what its own column leans: where work is joined or
    turned, towards ends that are sewn on, beside increases and decreases, and in thin limbs, whose columns stuffing winds about
    them, by two stitches in as many rounds as they have stitches."""
    aside = np.zeros(len(graph))
    ring = graph.peculiarity == ROOT
    _leaning(
        graph.anchors,
        graph.anchor_offsets,
        ring,
        np.ascontiguousarray(rows.x),
        rows.along,
        rows.normal,
        rows.up,
        rows.after,
        rows.before,
        rows.foot,
        rows.pace,
        rows.host,
        rows.slip,
        aside,
    )
    _, number, count = np.unique(graph.round, return_inverse=True, return_counts=True)
    wanted = np.clip(aside + SLANTS[hold] - CLIMB / count[number], -MOST, MOST)
    bring = np.where(np.diff(graph.anchor_offsets) > 0, wanted, 0.0)
    out = at.copy()
    share(len(out), BLOCK, lambda a, b: erect(led.cell[a:b], out[a:b], graph.height, bring))
    return out


@kernel
def _leaning(
    anchors: I4x1,
    offsets: I8x1,
    ring: B1x1,
    x: F8x2,
    along: F8x2,
    normal: F8x2,
    up: F8x2,
    after: I4x1,
    before: I4x1,
    foot: F8x1,
    pace: F8x1,
    host: I4x1,
    slip: F8x1,
    aside: F8x1,
) -> None:
    """Fill aside (N,): how far along the work every stitch's top stands from what it is worked into, in widths there; those
    of one place stand together as much as they do in the mean."""
    low, top, way = np.zeros((3, 3)), np.zeros((3, 3)), np.zeros(3)
    n = len(aside)
    for i in range(n):
        first, last = offsets[i], offsets[i + 1]
        if last == first or ring[anchors[first]]:
            continue
        j = host[i]
        # The way of the work there: in a limb of six a stitch further it is another by 60 degrees.
        on_row(j, slip[i] + MIDDLE + 0.25, x, along, normal, up, after, before, False, top)
        on_row(j, slip[i] + MIDDLE - 0.25, x, along, normal, up, after, before, False, low)
        for c in range(3):
            way[c] = 2.0 * (top[0, c] - low[0, c])
        on_row(j, slip[i] + MIDDLE, x, along, normal, up, after, before, False, top)
        far = size = 0.0
        for k in range(first, last):
            a = anchors[k]
            on_row(host[a], slip[a] + foot[i] + pace[i] * MIDDLE, x, along, normal, up, after, before, False, low)
            for c in range(3):
                far += (top[0, c] - low[0, c]) * way[c] / (last - first)
        for c in range(3):
            size += way[c] * way[c]
        aside[i] = far / max(size, 1e-9)
    i = 0
    while i < n:
        last = i + 1
        if offsets[i + 1] - offsets[i] == 1:
            while last < n and offsets[last + 1] - offsets[last] == 1 and anchors[offsets[last]] == anchors[offsets[i]]:
                last += 1
        if last > i + 1:
            mean = 0.0
            for k in range(i, last):
                mean += aside[k] / (last - i)
            for k in range(i, last):
                aside[k] = mean
        i = last

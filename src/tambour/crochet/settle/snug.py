"""Snug: fabric that stuffing stretches no more than it stretches yarn in the hand, whatever the shape."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tambour.core.check import Array
from tambour.core.graph import JOIN, THROUGH, YARN, StitchGraph

STRETCH = 0.02
"""How much longer and wider than in a gauge swatch a stitch is that medium stuffing presses: 1 % light, 5 % firm."""


def stretch(amount: float) -> float:
    """The share by which stuffing of this amount (1: medium) stretches the fabric."""
    return STRETCH * amount


def snug(graph: StitchGraph, x: Array, width: float) -> StitchGraph:
    """The graph with rest lengths that leave stuffed parts, at rest, as large as their gauge and stuffing say.

    x : (N, 3) the graph at rest, in stitches; width : mm of a stitch

    Springs that are pressed round give way: by 6 % in a ball, by 11 % round a tube. Wool does not. A spring's pull is
    m - 1 where its mean stretch is m, and a ring's pull times its length is what the stuffing asks of it: m (m - 1). So
    a rest length of t - m (m - 1) / t brings it to the stretch t. It is taken round by round, along the work and into
    the round below: the tension that makes the part round stays, its size is that of the gauge.
    """
    a, b = graph.edges.T
    if not len(a) or not len(graph.parts):
        return graph
    size = np.sqrt(((x[a] - x[b]) ** 2).sum(1)) * width / np.maximum(graph.rest, 1e-9)
    own = graph.part[a] == graph.part[b]
    want = np.array([1.0 + stretch(p.stuffing) for p in graph.parts])[graph.part[a]]
    filled = np.array([p.stuffing > 0.0 for p in graph.parts])[graph.part[a]]
    rest = graph.rest.copy()
    for kinds in ((YARN, JOIN), (THROUGH,)):
        mine = np.flatnonzero(own & filled & np.isin(graph.edge_kind, kinds) & (graph.round[a] >= 0))
        if len(mine):
            group = graph.round[a[mine]]
            mean = np.bincount(group, size[mine]) / np.maximum(np.bincount(group), 1)
            m = np.clip(mean[group], 1.0, 1.5)
            rest[mine] *= np.maximum(want[mine] - m * (m - 1.0) / want[mine], 0.5)
    return replace(graph, rest=rest)

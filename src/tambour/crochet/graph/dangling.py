"""First positions of strands: each straight away from where it hangs, its stitches wound about its chain as far as they crowd."""

from __future__ import annotations

import math

import numpy as np

from tambour.core.check import Array
from tambour.core.graph import StitchGraph

_ONWARD = 0.6
"""How far a strand leads on, the way that the work grows, for each stitch that it leads outwards."""


def strung(graph: StitchGraph, a: int, b: int) -> bool:
    """Whether the nodes ``a`` to ``b`` - 1, worked into nothing that was there, are strands: chains off a stitch, and stitches into them."""
    before = int(graph.previous[a])
    into = graph.anchors[graph.anchor_offsets[a] : graph.anchor_offsets[b]]
    return graph.parts[int(graph.part[a])].start <= before < a and len(into) > 0 and bool((into >= a).all())


def placed(graph: StitchGraph, x: Array, heights: Array, nodes: tuple[int, int], flat: bool) -> Array:
    """Where the strands of the ``nodes`` from the first to before the second begin to settle (K, 3); x : all nodes, those that they hang on
    being placed."""
    a, b = nodes
    into = np.diff(graph.anchor_offsets[a : b + 1])
    begun = [n for n in range(a, b) if into[n - a] == 0 and graph.previous[n] < a]
    for first, end in zip(begun, [*begun[1:], b]):
        base = int(graph.previous[first])
        ring = np.flatnonzero(graph.round[: base + 1] == graph.round[base])
        off = (x[base] - x[ring].mean(0)) * [1.0, 0.0, 1.0]
        far = float(np.sqrt((off**2).sum()))
        out = off / far if far > 0.5 else np.array([0.0, 0.0, 1.0])
        along = np.array([0.0, 1.0, 0.0]) if flat else (out + np.array([0.0, _ONWARD, 0.0])) / math.hypot(1.0, _ONWARD)
        aside = np.array([0.0, 0.0, 1.0]) if flat and far <= 0.5 else np.cross([0.0, 1.0, 0.0], out)
        third = np.cross(along, aside)
        worked = [n for n in range(first, end) if into[n - a]]
        chain = [n for n in range(first, end) if not into[n - a]]
        takes = len(np.unique(graph.anchors[graph.anchor_offsets[worked[0]] : graph.anchor_offsets[end]]))
        high = float(heights[worked].mean())
        turns = math.sqrt(max(0.0, len(worked) ** 2 - takes**2)) / (2.0 * math.pi * high)
        for k, n in enumerate(chain):
            x[n] = x[base] + along * (min(k, takes) + 1.0) + aside * 0.5 * max(0, k - takes + 1)
        for k, n in enumerate(worked):
            share = (k + 0.5) / len(worked)
            angle = 2.0 * math.pi * turns * share
            on = graph.anchors[graph.anchor_offsets[n] : graph.anchor_offsets[n + 1]]
            at = x[base] + along * (1.0 + takes * (1.0 - share) - 0.5) if turns else x[on].mean(0)
            x[n] = at + heights[n] * (math.cos(angle) * aside + math.sin(angle) * third)
    return x[a:b]

"""Pulled: threads that are led through a stuffed part, from one stitch to another, and pulled: needle sculpting."""

from __future__ import annotations

from dataclasses import replace
from itertools import product

import numpy as np

from tambour.core.check import Array
from tambour.core.graph import THREAD, StitchGraph
from tambour.crochet.graph.built import Built
from tambour.crochet.graph.spots import Spots
from tambour.crochet.language.finishes import Spot, Tie


def pulled(built: Built, graph: StitchGraph) -> StitchGraph:
    """``graph``, the one that ``built`` has or what became of it, with the threads that its pattern pulls through its parts.

    A thread holds two stitches at either end: one would be drawn out of the fabric.
    """
    ties = [f for f in built.pattern.finish if isinstance(f, Tie)]
    if not ties:
        return graph
    spots = Spots(built)
    made: dict[tuple[int, int], float] = {}
    for tie in ties:
        for a, b in product(*(_caught(spots, spot) for spot in tie.spots)):
            if a != b:
                made[max(a, b), min(a, b)] = tie.apart
    known = set(map(tuple, graph.edges.tolist()))
    made = {pair: apart for pair, apart in made.items() if pair not in known}
    pairs = np.array(list(made), np.int64).reshape(-1, 2)
    edges = np.concatenate([graph.edges, pairs])
    order = np.lexsort((edges[:, 1], edges[:, 0]))
    kind = np.concatenate([graph.edge_kind, np.full(len(pairs), THREAD, np.uint8)])
    rest = np.concatenate([graph.rest, np.array(list(made.values()), float)])
    return replace(graph, edges=np.ascontiguousarray(edges[order], np.int32), edge_kind=kind[order], rest=rest[order])


def _caught(spots: Spots, spot: Spot) -> list[int]:
    """The stitch at ``spot`` and the one worked after it; in a tip the tip."""
    nodes: Array = np.array(spots.place(spot).nodes)
    weights = np.array(spots.place(spot).weights)
    stitch = int(nodes[int(weights.argmax())])
    graph = spots.built.graph
    after = stitch + 1
    there = after < len(graph) and graph.part[after] == graph.part[stitch] and graph.previous[after] == stitch
    return [stitch, after] if there else [stitch]

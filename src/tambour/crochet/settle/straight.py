"""Straight: which stitches of fabric without stuffing resist bending, along the yarn and from round to round, and how much."""

from __future__ import annotations

import numpy as np

from tambour.core.check import Array
from tambour.core.graph import JOIN, ROOT, TIP, StitchGraph

ROUND = 24.0
"""Yarn of a round of fewer stitches is bent so much where it lies flat that it is not kept as straight."""


def straight(graph: StitchGraph, amount: Array, stiffness: float) -> tuple[Array, Array]:
    """Triples a, b, c that fabric without stuffing keeps straight: along the yarn, and from round to round."""
    loose = amount[graph.part] == 0.0
    if stiffness == 0.0 or not loose.any():
        return np.zeros((0, 3)), np.zeros(0)
    b, p = graph.previous, graph.parent
    # Below a chain between stitches lies what the stitch before it stands on.
    below, free = p.copy(), (np.diff(graph.anchor_offsets) == 0) & (graph.peculiarity != ROOT) & (b >= 0)
    for n in np.flatnonzero(free & loose).tolist():
        below[n] = below[b[n]]
    found, share = [], []
    bent = bent_yarn(graph)
    for before in (b, p):
        middle = before
        last = np.where(middle >= 0, (b if before is b else below)[middle], -1)
        ok = loose & (middle >= 0) & (last >= 0) & (graph.peculiarity != TIP)
        same = graph.part[middle] == graph.part
        ok &= same & ~np.isin(graph.peculiarity[middle], (ROOT, TIP))
        if before is b:
            # The yarn turns a corner where a row or a joined round begins: it rises from the stitch it goes on in.
            rises = (p < 0) & (p[middle] >= 0)
            ok &= (p != last) & (p[middle] != last) & (p != middle) & ~rises
            # Chains between stitches turn corners as they please.
            ok &= ~(free[middle] & (below[middle] >= 0))
        else:
            # Of the stitches that spread from one chain, those in the middle stand straight over it.
            spread = np.flatnonzero(ok & free[middle])
            for m in np.unique(middle[spread]).tolist():
                own = spread[middle[spread] == m]
                ok[own] = False
                ok[own[(len(own) - 1) // 2 : len(own) // 2 + 1]] = True
        nodes = np.flatnonzero(ok)
        found.append(np.column_stack([nodes, middle[nodes], last[nodes]]))
        share.append(bent[middle[nodes]] if before is b else np.ones(len(nodes)))
    # Across the join of a round the yarn does not lead on, but the fabric does.
    last, first = graph.edges[(graph.edge_kind == JOIN) & loose[graph.edges[:, 0]]].T
    second = np.minimum(first + 1, len(graph) - 1)
    for ends, ok in (((second, first, last), b[second] == first), ((first, last, b[last]), b[last] >= 0)):
        found.append(np.column_stack(ends)[ok])
        share.append(bent[found[-1][:, 1]])
    triples = np.concatenate(found)
    order = np.argsort(triples.max(1, initial=0), kind="stable")
    return triples[order], stiffness * np.concatenate(share)[order]


def bent_yarn(graph: StitchGraph) -> Array:
    """How much of its stiffness along the yarn counts at each node (N,): little in small rounds, which are bent as they lie."""
    from tambour.crochet.graph.layout import in_rows

    own = graph.part.astype(np.int64) * (int(graph.round.max(initial=0)) + 2) + graph.round + 1
    _, number, count = np.unique(own, return_inverse=True, return_counts=True)
    rows = in_rows(graph)[graph.part]
    return np.where(rows, 1.0, np.minimum(1.0, (count[number] / ROUND) ** 2))

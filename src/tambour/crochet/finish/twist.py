"""Twist: parts whose marks are sewn in mirrored order, so that no way of holding them brings the marks together."""

from __future__ import annotations

import numpy as np

from tambour.core.check import Array
from tambour.core.errors import Problem
from tambour.crochet.graph.built import Built

FEW = 4
"""A seam of fewer marks than this has no order that could be mirrored."""
FAR = 1.0
"""Stitches (rms) that the marks must stay apart for a seam to be doubted."""
BETTER = 0.5
"""How much nearer, as a share, a mirrored part's marks would have to come."""


def twisted(built: Built) -> list[Problem]:
    """Doubts about seams that twist: a part's mirror image would fit them far better than the part does."""
    from tambour.crochet.graph.layout import rounds
    from tambour.geometry.motion import fit, length, turned
    from tambour.geometry.surface import vertex_normals

    graph, sewn = built.graph, np.asarray(built.sewn, int)
    if len(sewn) < FEW:
        return []
    x = rounds(graph, graph.rest / graph.stitch_width)
    outward = vertex_normals(x, graph.faces[built.shell])
    part = graph.part[sewn]
    found = []
    for later, earlier in np.unique(part, axis=0).tolist():
        pairs = sewn[(part == [later, earlier]).all(1)]
        if later == earlier or len(pairs) < FEW:
            continue
        size = [graph.parts[p].end - graph.parts[p].start for p in (later, earlier)]
        own, other = (pairs[:, 0], pairs[:, 1]) if size[0] <= size[1] else (pairs[:, 1], pairs[:, 0])
        p = graph.parts[int(graph.part[own[0]])]
        middle = x[p.start : p.end].mean(0)
        out = outward[other].mean(0)
        out = out / max(float(length(out)), 1e-9)
        deep = max(float(np.sqrt(((middle - x[own].mean(0)) ** 2).sum())), 0.5)
        fixed = np.vstack([x[other], x[other].mean(0) + deep * out])
        weight = np.append(np.ones(len(own)), float(len(own)))

        def left(moving: Array, fixed: Array = fixed, weight: Array = weight) -> float:
            turn, shift = fit(moving, fixed, weight)
            return float(np.sqrt(((turned(moving[:-1], turn) + shift - fixed[:-1]) ** 2).sum(1).mean()))

        held = np.vstack([x[own], middle])
        as_is, mirrored = left(held), left(held * (-1.0, 1.0, 1.0))
        if as_is > FAR and mirrored < BETTER * as_is:
            name, on = p.name, graph.parts[int(graph.part[other[0]])].name
            message = f"the marks of {name} and {on} are sewn in mirrored order: the part is twisted"
            hint = "go round both edges as they meet: exchange the marks on the left with those on the right"
            marks = {label for label, node in built.marks.items() if node in own}
            span = next((d.span for d in built.log if d.what == "sew" and marks & set(d.labels)), None)
            found.append(Problem(message, hint, span, built.pattern.text, warning=True))
    return found

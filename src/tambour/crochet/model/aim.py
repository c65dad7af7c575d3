"""Aim: a plush laid upon a model that it was not made from, both upright, and how far it lies from it."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from tambour.core.check import Array
from tambour.core.mesh import Mesh
from tambour.crochet.model.distance import Distance, Target, distance, spread

if TYPE_CHECKING:
    from tambour.crochet.piece import Aim, Plush

LOOKS = 4
"""How many ways round, even about the upright, a plush is tried."""
FEW = 400
"""Points of each surface that these tries, and the laying of one upon the other, go by."""


def lain(target: Target, x: Array, faces: Array) -> Distance:
    """How far the surface of x (N, 3) and faces (F, 3) lies from ``target``, turned about the upright and moved as is best.

    >>> import numpy as np
    >>> x = np.array([(0, 0, 0), (4, 0, 0), (0, 3, 0), (0, 0, 2.0)])
    >>> faces = np.array([(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)])
    >>> bool(lain(Target.of(x, faces), x @ np.diag([-1.0, 1, -1]) + 7, faces).mean < 1e-3)
    True
    """
    used = x[np.unique(faces)]
    middle, goal = 0.5 * (used.min(0) + used.max(0)), target.vertices[np.unique(target.faces)]
    place = 0.5 * (goal.min(0) + goal.max(0))
    # Few points say how the two lie on each other; how far apart is then measured at many.
    few = replace(target, points=spread(target.vertices, target.faces, FEW))
    tries = []
    for k in range(LOOKS):
        c, s = np.cos(2 * np.pi * k / LOOKS).round(12), np.sin(2 * np.pi * k / LOOKS).round(12)
        turn = np.array([[c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]])
        start = (turn, place - turn @ middle)
        tries.append((distance(few, x, faces, start, samples=FEW, moves=False).mean, k, start))
    best = min(tries, key=lambda one: (round(one[0], 6), one[1]))
    near = distance(few, x, faces, best[2], samples=FEW)
    return distance(target, x, faces, (near.turn, near.shift), moves=False)


def sought(model: Mesh, piece: Plush) -> Aim:
    """The model that a plush is compared with, laid upon it."""
    from tambour.crochet.finish.covered import seen
    from tambour.crochet.model.loop import signed
    from tambour.crochet.piece import Aim
    from tambour.geometry.motion import turned

    x = piece.positions
    target = Target.of(model.vertices, model.faces)
    graph = piece.built.graph
    found = lain(target, x, seen(graph, x, piece.shape.joined, graph.faces[piece.built.shell]))
    back = turned(target.vertices - found.shift, found.turn.T)
    return Aim(back, model.faces, found.plain(piece.stitch[0]), signed(target, x, found), {}, {}, np.zeros((0, 3)), "")

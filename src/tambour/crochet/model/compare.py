"""Compare: a plush beside the model that its pattern was made for: distances as numbers, and as a picture."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

from tambour.core.check import Array
from tambour.core.errors import TambourError
from tambour.crochet.piece import Aim

if TYPE_CHECKING:
    from tambour.core.picture import Picture
    from tambour.crochet.model.design import Design
    from tambour.crochet.piece import Plush

INSIDE, ON, OUTSIDE = (44, 102, 178), (238, 234, 226), (196, 54, 40)
"""Colours of stitches that lie inside the model, on it, and outside of it."""
FULL: Final = 1.5
"""How many stitches off a colour is full."""
GHOST: Final = 0.3
"""How much of the ghost is seen."""


def aimed(made: Design, piece: Plush) -> Aim:
    """The model laid upon the plush, without scaling, and how far they lie apart."""
    from tambour.crochet.finish.covered import seen
    from tambour.crochet.model.distance import Target, distance
    from tambour.crochet.model.loop import signed
    from tambour.geometry.motion import fit, turned

    graph, x = piece.built.graph, piece.positions
    target = Target.of(made.vertices, made.faces, samples=4000)
    start = fit(x, made.goals, np.ones(len(x)))
    faces = seen(graph, x, piece.shape.joined, graph.faces[piece.built.shell])
    lain = distance(target, x, faces, start, samples=4000)
    off = signed(target, x, lain)
    back, goals = (turned(p - lain.shift, lain.turn.T) for p in (made.vertices, made.goals))
    return Aim(back, made.faces, lain.plain(piece.stitch[0]), off, made.history, made.parts, goals, made.stands)


def compare(piece: Plush) -> Picture:
    """The plush, blue where it lies inside the model and red where outside, from the front and the side; the model as a ghost."""
    from math import radians

    from tambour.core.mesh import Mesh
    from tambour.core.picture import Picture
    from tambour.crochet.looks import surface
    from tambour.render.raster import picture

    if piece.aim is None:
        raise TambourError(
            "there is no model to compare this plush with", hint="compare is for patterns made of a model: toy.stl"
        )
    plain = surface(piece)
    plush = Mesh(plain.vertices, plain.faces, color=shades(piece.aim.off / piece.stitch[0]))
    ghost = Mesh(piece.aim.vertices, piece.aim.faces, color=np.full((len(piece.aim.vertices), 3), 150, np.uint8))
    frame = np.concatenate([plush.vertices, ghost.vertices])
    made = []
    for azimuth in (radians(18.0), radians(90.0)):
        sides = [
            picture(
                one, width=700, height=800, azimuth=azimuth, elevation=radians(10.0), frame=frame, ground=False
            ).rgba
            for one in (plush, ghost)
        ]
        a, b = sides[0].astype(float), sides[1].astype(float)
        made.append((1.0 - GHOST) * a + GHOST * b)
    return Picture(np.concatenate(made, axis=1).round().astype(np.uint8))


def shades(off: Array) -> Array:
    """Colours (N, 3) uint8 of distances (N,) in stitches: INSIDE, ON, OUTSIDE."""
    share = np.clip(off / FULL, -1.0, 1.0)[:, None]
    to = np.where(share < 0.0, np.array(INSIDE, float), np.array(OUTSIDE, float))
    return np.asarray((np.array(ON) + np.abs(share) * (to - np.array(ON))).round().astype(np.uint8))

"""Poised: a part turned to stand as its text says: which of its stitches is on top, and which is in front."""

from __future__ import annotations

import numpy as np

from tambour.core.check import Array
from tambour.core.errors import Problem
from tambour.crochet.graph.spots import Spots
from tambour.crochet.language.finishes import Spot
from tambour.geometry.motion import length, turned
from tambour.geometry.stance import set_down

TIPS = 12.0
"""By how many degrees a toy is turned at the most to stand on what it stands on; what tips farther is held by hand."""


def poised(spots: Spots, x: Array, part: int) -> Array:
    """Positions ``x`` (N, 3) with a part turned about its own middle as its text says it stands; as they are where it says nothing."""
    said = _places(spots, part)
    if said is None or any(spots.problems_of(spot) for spot in said):
        return x
    span = spots.built.graph.parts[part]
    own = x[span.start : span.end]
    middle = own.mean(0)
    ways = [_unit((np.array(p.weights)[:, None] * x[list(p.nodes)]).sum(0) - middle) for p in map(spots.place, said)]
    made = x.copy()
    made[span.start : span.end] = turned(own - middle, turn(*ways)) + middle
    return made


def set_up(spots: Spots, x: Array) -> Array:
    """Positions ``x`` (N, 3) of parts that nothing is sewn to, each that says how it stands turned so, and the little that it takes to
    rest on its ground."""
    for part, span in enumerate(spots.built.graph.parts):
        if _places(spots, part) is not None:
            x = poised(spots, x, part)
            own = x[span.start : span.end]
            middle = own.mean(0)
            off = own - middle
            x[span.start : span.end] = (
                turned(off, set_down(np.concatenate([off, off * (-1.0, 1.0, 1.0)]), TIPS)) + middle
            )
    return x


def turn(top: Array, front: Array) -> Array:
    """The rotations (…, 3, 3) that bring the ways (…, 3) ``top`` upwards and ``front`` ahead, each as near as the other allows."""
    along, across = _unit(top + front), _unit(top - front)
    up, ahead = (along + across) / np.sqrt(2.0), (along - across) / np.sqrt(2.0)
    return np.stack([np.cross(up, ahead), up, ahead], axis=-2)


def doubts(spots: Spots) -> list[Problem]:
    """What is wrong with the places by which parts say how they stand."""
    found: dict[Problem, None] = {}
    for part in range(len(spots.built.parts)):
        for spot in _places(spots, part) or ():
            found.update(dict.fromkeys(spots.problems_of(spot)))
    return list(found)


def _places(spots: Spots, part: int) -> tuple[Spot, Spot] | None:
    fact = spots.built.parts[part]
    section = spots.built.pattern.parts[fact.section]
    if section.stands is None or fact.copy > 1:
        return None
    name = next(name for name, k in spots.parts.items() if k == part)
    (top, one), (front, other) = section.stands
    at = section.stands_span or section.span
    return Spot(name, top, one, at), Spot(name, front, other, at)


def _unit(way: Array) -> Array:
    return np.asarray(way / np.maximum(length(way)[..., None], 1e-9))

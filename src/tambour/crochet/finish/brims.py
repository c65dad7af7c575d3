"""Brims: a hat or a wig that hangs before the eyes is pushed back on its head, and up, as far as they need."""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING

import numpy as np

from tambour.core.check import Array
from tambour.crochet.finish.placing import eyes_on, frames
from tambour.geometry.motion import turned

if TYPE_CHECKING:
    from tambour.crochet.finish.joining import Joined
    from tambour.crochet.finish.shape import Task

HATS = re.compile(
    r"\b(?:hats?|caps?|bonnets?|helmets?|hoods?|beanies?|hair|wigs?|hut|mütze|haare?|sombrero|gorro|pelo|chapeau|bonnet|cheveux|hoed|muts|haar)\b"
)
ANGLES = (8.0, 16.0, 24.0, 32.0, 40.0, 48.0)
"""A hat is pushed back by the least of these, in degrees, that frees the eyes."""
LIFTS = (0.0, 1.0, 2.0, 3.0, 4.5, 6.0)
"""Where none does it is lifted too, by the least of these, in stitches; where that does not help it stays."""
SIGHT = math.radians(13.0)
"""Who looks at the toy looks down on it by so much."""
FREE = 0.9
"""So many stitches about the line of sight nothing hangs."""
FAR = np.arange(1.0, 16.0)
"""Where on the line of sight, in stitches before an eye."""


def pushed_back(task: Task, x: Array, joined: Joined, own: Array) -> list[tuple[Array, Array, Array, Array]]:
    """Of the toy with the nodes ``own`` (N,) every hat that is before the eyes: its parts (K,), the rotation, the point it is about,
    and the way (3,) up."""
    joining = task.joining
    if joining is None:
        return []
    spots, graph = joining.spots, task.graph
    eyes = eyes_on(joining.built)
    on = {spots.parts[f.part]: spots.parts[f.spot.part] for f, _ in joining.steps}
    found, x = [], x.copy()
    for f, _ in joining.steps:
        part, host = spots.parts[f.part], spots.parts[f.spot.part]
        if not HATS.search(f.part.lower()) or f.spot.stitch is not None or not own[graph.parts[part].start]:
            continue
        if HATS.search(graph.parts[host].name.lower()):
            host = on.get(host, host)  # over the hair, which is on the head
        mine = [e for e in eyes if spots.parts[e.part] == host]
        if not mine:
            continue
        bear = {part}
        while more := {p for p, below in on.items() if below in bear} - bear:
            bear |= more
        worn, head = graph.parts[part], graph.parts[host]
        middle = x[head.start : head.end].mean(0)
        where = frames(spots, x, mine, joined.upright)
        ahead = np.broadcast_to([0.0, math.sin(SIGHT), math.cos(SIGHT)], where.normals.shape)
        ways = np.stack([ahead, where.normals])[:, :, None]
        sight = (where.points[:, None] + FAR[:, None] * graph.stitch_width * ways).reshape(-1, 3)
        hat = x[worn.start : worn.end] - middle
        for lift, angle in [(lift, angle) for lift in LIFTS for angle in (0.0, *ANGLES)]:
            turn, up = _back(angle), np.array([0.0, lift * graph.stitch_width, 0.0])
            away = np.sqrt(((sight[:, None] - (turned(hat, turn) + middle + up)) ** 2).sum(2).min())
            if away > FREE * graph.stitch_width:
                if angle or lift:
                    found.append((np.array(sorted(bear)), turn, middle, up))
                    moved = np.isin(graph.part, found[-1][0])  # what is on it has moved with it
                    x[moved] = turned(x[moved] - middle, turn) + middle + up
                break
    return found


def _back(angle: float) -> Array:
    c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    return np.array([[1.0, 0.0, 0.0], [0.0, c, s], [0.0, -s, c]])

"""Gaze: heads nod until their eyes look ahead, whatever way the fabric that they are sewn to looks."""

from __future__ import annotations

import math
import re
from dataclasses import replace

import numpy as np

from tambour.core.check import Array
from tambour.crochet.finish import sewing
from tambour.crochet.finish.placing import Frames, frames
from tambour.crochet.graph.spots import Spots
from tambour.crochet.language.finishes import Embroidery, Eye, Placed, Spot
from tambour.geometry.motion import turned

LIFTED = 35.0
"""Eyes that look higher or lower than this, in degrees, look at the sky or at the ground, and nobody in the face."""
EASY = 15.0
"""So high or low they look when the head has nodded."""
MOST = 60.0
"""No neck gives way by more degrees."""
SEWN = 80.0
"""What is sewn on leans by so many degrees at the most."""
AWAY = -0.3
"""What looks so far back, as a cosine, is no face that was only lifted."""
_NOSE = re.compile(
    r"\b(?:nose|snout|muzzle|beak|nase|schnauze|schnabel|nariz|hocico|pico|nez|museau|bec|neus|snuit|snavel)\b"
)


def looking(spots: Spots, part: int) -> list[list[Spot]]:
    """What of a part looks ahead: its eyes, of glass or else embroidered, and its nose."""
    finish = spots.built.pattern.finish
    glass = [f.spot for f in finish if isinstance(f, Eye)]
    sewn = [s for f in finish if isinstance(f, Embroidery) and f.motif.endswith("eyes") for s in f.spots[:1]]
    nose = [s for f in finish if isinstance(f, Embroidery) and f.motif.endswith("nose") for s in f.spots[:1]]
    nose += [f.spot for f in finish if isinstance(f, Placed) and _NOSE.search(f.part.lower())]
    own = [[s for s in some if spots.parts.get(s.part) == part] for some in (glass, sewn, nose)]
    return [some for some in (own[0] or own[1], own[2]) if some]


def nod(spots: Spots, x: Array, part: int) -> Array | None:
    """The rotation (3, 3) ahead or back that lets a head at x (N, 3) look ahead; None where it does, or has no face."""
    for some in looking(spots, part):
        looks = frames(spots, x, some).normals
        rise = math.degrees(float(np.arcsin(np.clip(looks[:, 1], -1.0, 1.0)).mean()))
        if abs(rise) > LIFTED and float(looks[:, 2].mean()) > AWAY:
            angle = math.radians(min(MOST, abs(rise) - EASY)) * math.copysign(1.0, rise)
            return _about(np.array([1.0, 0.0, 0.0]), angle)
    return None


def _about(axis: Array, angle: float) -> Array:
    k = np.array([[0.0, -axis[2], axis[1]], [axis[2], 0.0, -axis[0]], [-axis[1], axis[0], 0.0]])
    return np.asarray(np.eye(3) + math.sin(angle) * k + (1.0 - math.cos(angle)) * turned(k, k.T))


def leant(placed: Placed, frame: Frames, axis: Array) -> Placed:
    """``placed`` so that it leans from its spot to where ``axis`` (3,) points."""
    n, along, up = frame.normals[0], frame.along[0], frame.up[0]
    tilt = math.degrees(math.acos(max(-1.0, min(1.0, float((axis * n).sum())))))
    towards = math.degrees(math.atan2(-float((axis * along).sum()), float((axis * up).sum())))
    return replace(placed, tilt=tilt, towards=towards % 360.0)


def pointing(placed: Placed, frame: Frames) -> Placed:
    """``placed`` so that it points where it is said to, as far as what is sewn on can lean."""
    made = leant(placed, frame, _unit(np.array(placed.points)))
    return replace(made, tilt=min(made.tilt, SEWN))


def _unit(v: Array) -> Array:
    return np.asarray(v / np.sqrt((v**2).sum()))


def nodding(
    spots: Spots, x: Array, own: Array, how: sewing.Held, placed: Placed, end: sewing.End, frame: Frames
) -> Placed:
    """A head as it is sewn on an end (N, 3) of what bears it: leaning so that its eyes look ahead."""
    part = spots.parts[placed.part]
    if placed.spot.stitch is not None or not looking(spots, part):
        return placed
    trial = x.copy()
    axis, front = sewing.ways(placed, end, frame)
    trial[own] = sewing.brought(x, own, how, axis, front, frame.points[0])
    turn = nod(spots, trial, part)
    return placed if turn is None else leant(placed, frame, turned(axis, turn))

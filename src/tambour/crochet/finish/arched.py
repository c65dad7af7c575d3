"""Arched: a strip that is sewn on by both its ends, bent from the one to the other: the handle of a cup, of a basket, a strap."""

from __future__ import annotations

import math

import numpy as np

from tambour.core.check import Array
from tambour.crochet.finish.placing import Frames
from tambour.crochet.finish.sewing import End, Held
from tambour.geometry.motion import dot, length
from tambour.geometry.near import nearest

TIP = 0.6
"""What is so near to the far end of a strip, in stitches, is sewn there."""
_TAUT = 1.02
"""A strip that is no longer than this, as a share of the way between its ends, is drawn straight."""
_ROUNDEST = 1.7 * math.pi
"""A long strip makes so much of a circle at the most."""
_ALIKE = 1.0
"""Where the fabric at both ends looks so much the same way, that is the way a strip stands out; else it is away from the middle."""
_HALVINGS = 50


def arched(
    x: Array, own: Array, how: Held, end: End, ends: tuple[Frames, Frames], target: Array
) -> tuple[Array, Array, Array]:
    """Where the nodes ``own`` of a strip are, (O, 3), and the pairs (S, 2) that it is sewn by, at its end and at its other one.

    x : (N, 3) in stitches; how : how it is held by its ``end``; ends : the frames of its two spots; target : the fabric's nodes
    """
    (here, there), normals = (f.points[0] for f in ends), ends[0].normals[0] + ends[1].normals[0]
    chord = there - here
    wide = max(float(length(chord)), 1e-6)
    chord = chord / wide
    out = normals if float(length(normals)) > _ALIKE else 0.5 * (here + there) - x[target].mean(0)
    out = out - dot(out, chord) * chord
    if float(length(out)) < 1e-6:
        out = np.cross(chord, ends[0].along[0])
    out = out / length(out)
    off = x[own] - how.middle
    side = np.cross(how.axis, how.front)
    along, across, thick = (dot(off, way) for way in (how.axis, how.front, side))
    long = max(float(along.max()), 1e-6)
    turn = _turn(wide / long)
    angle = turn * (along / long - 0.5)
    radius = 0.5 * wide / math.sin(0.5 * turn)
    radial = np.sin(angle)[:, None] * chord + np.cos(angle)[:, None] * out
    middle = 0.5 * (here + there) - radius * math.cos(0.5 * turn) * out
    moved = middle + (radius + thick)[:, None] * radial + across[:, None] * np.cross(chord, out)

    def sewn(nodes: Array) -> Array:
        return np.column_stack([nodes, target[nearest(moved[np.searchsorted(own, nodes)], x[target])[1][:, 0]]])

    return moved, sewn(end.nodes), sewn(own[along > long - TIP])


def _turn(share: float) -> float:
    """The angle, in radians, of the arc whose chord is such a share of its length."""
    if share >= 1.0 / _TAUT:
        share = 1.0 / _TAUT
    low, high = 1e-3, _ROUNDEST
    for _ in range(_HALVINGS):
        turn = 0.5 * (low + high)
        low, high = (turn, high) if math.sin(0.5 * turn) / (0.5 * turn) > share else (low, turn)
    return 0.5 * (low + high)

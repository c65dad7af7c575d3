"""Hanging: a part that is worked on a whole round of another brought there: a skirt around its body, and down; a layer on its like."""

from __future__ import annotations

import numpy as np

from tambour.core.check import Array
from tambour.crochet.finish.sewing import CLEARANCE, End, brought, held
from tambour.geometry.motion import axes, dot, length

_UPWARDS = 0.5
"""Of a layer that looks up as much as ahead, which of both counts for less."""
_BAND = 1.5
"""How far above and below a stitch, in stitches, the fabric is that it must hang outside of."""


def hung(x: Array, own: Array, end: End, ring: Array, host: Array, up: Array) -> tuple[Array, Array]:
    """Where the nodes ``own`` hang (K, 3) from the stitches ``ring`` of the fabric ``host``, and the pairs (S, 2) that hold them there.

    x : (N, 3), the part by itself and the host in its place; up : (3,) of the host. A part that begins with a ring hangs by it.
    """
    how = held(x, own, end)
    middle = x[ring].mean(0)
    down = -up / max(float(length(up)), 1e-9)
    ahead = np.array([0.0, 0.0, 1.0]) if abs(down[2]) < 0.9 else np.array([0.0, 1.0, 0.0])
    front = ahead - dot(ahead, down) * down
    moved = brought(x, own, how, down, front / float(length(front)), middle)
    moved = _outside(moved, x[host], middle, down)
    return moved, _pairs(moved[np.searchsorted(own, end.nodes)], end.nodes, x[ring], ring)


def laid_on(x: Array, own: Array, end: End, ring: Array, host: Array) -> tuple[Array, Array]:
    """Where the nodes ``own`` lie (K, 3) that are the second layer of ``host``, worked alike: before it, stitch on stitch; and the pairs
    (S, 2) of their edges."""
    there = x[host]
    _, ways = axes(there)
    ahead = ways[2] if ways[2][2] + _UPWARDS * ways[2][1] >= 0.0 else -ways[2]
    return there + CLEARANCE * ahead, np.column_stack([end.nodes, ring])


def _outside(moved: Array, fabric: Array, middle: Array, down: Array) -> Array:
    """``moved`` as much wider as it must be to hang outside of ``fabric`` about the axis through ``middle``."""
    deep, there = (moved - middle) @ down, (fabric - middle) @ down
    off = moved - middle - deep[:, None] * down
    wide = np.sqrt((off**2).sum(1))
    about = np.sqrt(((fabric - middle - there[:, None] * down) ** 2).sum(1))
    made = off.copy()
    for k in range(len(moved)):
        near = about[np.abs(there - deep[k]) < _BAND]
        least = (float(near.max()) if len(near) else 0.0) + CLEARANCE
        made[k] *= max(1.0, least / max(float(wide[k]), 1e-9))
    return np.asarray(middle + deep[:, None] * down + made)


def _pairs(loop: Array, nodes: Array, there: Array, ring: Array) -> Array:
    """Pairs (S, 2): every stitch of a loop (M, 3) with that of the ring which it is worked on, round by round in step."""
    m, n = len(nodes), len(ring)
    step = np.arange(m) * n / m
    best: tuple[float, Array] | None = None
    for way in (1.0, -1.0):
        for begin in range(n):
            at = np.round(begin + way * step).astype(int) % n
            far = float(((loop - there[at]) ** 2).sum())
            if best is None or far < best[0]:
                best = far, at
    assert best is not None
    return np.column_stack([nodes, ring[best[1]]])

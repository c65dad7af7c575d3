"""Motifs: what is embroidered by its name (eyes, a nose, a smile), laid cleanly on the settled fabric.

Where its stitches go is known by stitches of the fabric, which lean and stretch once it is stuffed; hands see a face and
lay an oval as an oval, a smile level. So the places only say where a motif is and how large; its shape is its own.
"""

from __future__ import annotations

from itertools import pairwise
from typing import Final

import numpy as np

from tambour.core.check import Array
from tambour.crochet.finish.felt import drape
from tambour.crochet.finish.ground import Ground, unit
from tambour.crochet.finish.placing import Frames

SATIN: Final = frozenset(("eyes", "nose", "cheeks"))
"""Motifs that are filled, thread beside thread."""
UPRIGHT: Final = frozenset(("eyes",))
"""Those of them whose threads are upright; the others' lie level."""
_FORM: Final = {"eyes": 1.25, "nose": 0.64, "cheeks": 0.6}
"""How high they are for their width."""
_ODD: Final = 0.6
"""The share of that by which they may differ, either way."""
CURVED: Final = {"smile": 0.24, "mouth": 0.1, "closed eyes": 0.3}
"""Motifs that are arcs, and how deep they hang for their width at the least."""
_BESIDE: Final = 0.72
"""How far apart threads of a satin stitch lie, in widths."""
_PADDED: Final = 0.55
"""How much higher, in widths, the middle of a satin stitch lies than its rim: threads cross under it."""
_INSIDE: Final = 1.3
"""How deep, in widths under where they lie, ends of threads are drawn in."""


def threads(ground: Ground, at: Frames, name: str, width: float) -> list[Array] | None:
    """The centre lines of a motif's yarn, ``width`` mm thick; None for those that are knots, or have no shape of their own.

    at : the frames of its places, as the record gives them
    """
    if len(at.points) < 2:
        return None
    middle, _, _ = ground.foot(at.points.mean(0)[None])
    _, normal, _ = ground.foot(middle)
    flat, along, up = _laid(at, middle[0], normal[0])
    lines = _satin(flat, name, width) if name in SATIN else [_line(flat, name)]
    lines = [_dense(line, 0.35 * width) for line in lines if len(line) > 1]
    if not lines:
        return None
    ends = np.cumsum([0, *map(len, lines)])
    every = np.concatenate(lines)
    far = np.sqrt((every**2).sum(1))
    ways = (every[:, :1] * along + every[:, 1:] * up) / np.maximum(far, 1e-9)[:, None]
    places, normals = ground.walk(middle[0], ways, far[:, None])
    places, normals = places[:, 0], normals[:, 0]
    high = drape(every, ground.top(places, normals)) + 0.4 * width
    if name in SATIN:
        size = np.maximum(np.abs(every).max(0), 1e-9)
        high = high + _PADDED * width * np.maximum(0.0, 1.0 - ((every / size) ** 2).sum(1))
    made = []
    for a, b in pairwise(ends.tolist()):
        run = np.concatenate([[0.0], np.cumsum(np.sqrt((np.diff(every[a:b], axis=0) ** 2).sum(1)))])
        near = np.minimum(run, run[-1] - run) / max(min(0.8 * width, run[-1] / 3), 1e-9)
        rise = high[a:b] - _INSIDE * width * np.maximum(0.0, 1.0 - near) ** 2
        made.append(np.asarray(places[a:b] + rise[:, None] * normals[a:b]))
    return made


def extent(at: Frames, name: str, width: float) -> tuple[float, float]:
    """How wide and how high a motif is that is embroidered at two places or more, mm, its yarn ``width`` thick with it."""
    flat, _, _ = _laid(at, at.points.mean(0), unit(at.normals.mean(0)[None])[0])
    lines = _satin(flat, name, width) if name in SATIN else [_line(flat, name)]
    wide, high = (np.ptp(np.concatenate(lines), axis=0) + width).tolist()
    return wide, high


def _laid(at: Frames, middle: Array, normal: Array) -> tuple[Array, Array, Array]:
    """The places of a motif in the plane about its middle (N, 2), and that plane's level and upright directions."""
    up = at.up.mean(0) - (at.up.mean(0) @ normal) * normal
    up = unit(up[None])[0]
    along = np.cross(up, normal)
    off = at.points - middle
    return np.column_stack([off @ along, off @ up]), along, up


def _satin(flat: Array, name: str, width: float) -> list[Array]:
    """Threads side by side within an oval, or, a nose, within a rounded triangle that stands on its tip."""
    low, high = flat.min(0), flat.max(0)
    half = np.maximum(0.5 * (high - low), 0.9 * width)
    # Fabric that is stretched one way does not stretch a face: the longer of its sides gives in.
    form = half[1] / half[0] / _FORM[name]
    half = half * ((form / _ODD, 1.0) if form < _ODD else (1.0, min(1.0, 1.0 / (_ODD * form))))
    middle = 0.5 * (high + low)
    across = 0 if name in UPRIGHT else 1
    count = max(3, 2 * round(half[across] / (_BESIDE * width)) // 1 + 1)
    made = []
    for s in np.linspace(-1.0, 1.0, count + 2)[1:-1]:
        reach = float(np.sqrt(max(1.0 - s * s, 0.0)))
        if name == "nose":
            reach *= float(np.interp(s, [-1.0, 1.0], [0.45, 1.0]))
        a = np.zeros((2, 2))
        a[:, across] = s * half[across]
        a[:, 1 - across] = (-reach * half[1 - across], reach * half[1 - across])
        made.append(middle + a)
    return made


def _line(flat: Array, name: str) -> Array:
    """A line through its places: an arc that hangs level, a V, or straight."""
    if name in CURVED:
        low, high = flat.min(0), flat.max(0)
        wide = high[0] - low[0]
        deep = max(min(high[1] - low[1], 0.5 * wide), CURVED[name] * wide)
        t = np.linspace(-1.0, 1.0, 25)
        return np.column_stack(
            [0.5 * (low[0] + high[0]) + 0.5 * wide * t, 0.5 * (low[1] + high[1]) + deep * (t * t - 0.5)]
        )
    if name in ("v nose", "y nose") and len(flat) == 3:
        (ax, ay), (_, ty), (bx, by) = flat
        return np.array([[ax, 0.5 * (ay + by)], [0.5 * (ax + bx), ty], [bx, 0.5 * (ay + by)]])
    if name == "y nose" and len(flat) == 2:
        return np.column_stack([np.full(2, flat[:, 0].mean()), flat[:, 1]])
    return flat


def _dense(line: Array, step: float) -> Array:
    """The line (K, 2) with points no further apart than ``step``."""
    far = np.concatenate([[0.0], np.cumsum(np.sqrt((np.diff(line, axis=0) ** 2).sum(1)))])
    at = np.unique(np.concatenate([far, np.linspace(0.0, far[-1], max(4, int(np.ceil(far[-1] / step)) + 1))]))
    return np.column_stack([np.interp(at, far, line[:, 0]), np.interp(at, far, line[:, 1])])

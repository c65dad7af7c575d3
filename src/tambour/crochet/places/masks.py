"""Masks: faces that are sewn on, and where eyes are on them: seen from before, however the piece was turned or leans."""

from __future__ import annotations

from typing import Final

import numpy as np

from tambour.core.check import Array
from tambour.crochet.places.stand import Host
from tambour.crochet.places.toy import Toy

_ON_MASK: Final = (0.52, 0.22)
"""Where the left eye is on a face that is sewn on, from its middle, in halves of its size."""
_OBLONG: Final = 1.3
"""A piece so much wider than high has its eyes in its middle line."""


def is_mask(work: Toy, host: Host) -> bool:
    """Whether a part is a face that is sewn on, or the patch about both eyes."""
    return host.name in {m.name for m in work.parts if m.single and m.kind in ("face", "eye")}


def eye_on(host: Host, side: float, apart: float | None = None) -> Array:
    """The place (3,) of an eye on a mask; side : 1 on the toy's left, -1 on its right; apart : the two, in stitches, if said."""
    centre, half = host.box
    up = _ON_MASK[1] if half[0] < _OBLONG * half[1] else 0.0
    x = _ON_MASK[0] * float(half[0]) if apart is None else 0.5 * apart
    points = np.concatenate([ring for _, ring in host.levels])
    off = points[:, :2] - np.array([centre[0] + side * x, centre[1] + up * half[1]])
    return np.asarray(points[np.argmin((off**2).sum(1))])

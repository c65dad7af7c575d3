"""Packed: polygons as skia reads paths from memory, all of them in one call and without an object per point."""

from __future__ import annotations

import numpy as np

from tambour.core.arrays import B1x1, I8x1, U1x1, U1x2
from tambour.core.check import Array
from tambour.core.kernels import kernel

VERSION, EVEN_ODD = 5, 1 << 8
"""What skia's own serialisation begins with (its version 5, from release 138 on; a test holds it against ``serialize``)."""
HEAD = 16
"""Bytes before the points: version and filling, and how many points, weights of conics and verbs there are."""
MOVE, LINE, CLOSE = 0, 1, 5


def packed(coords: Array, offsets: Array, parts: Array, evenodd: Array) -> tuple[Array, Array]:
    """The bytes of K shapes one after the other (uint8), and where each begins (K + 1,) int64.

    coords (P, 2) float64, offsets (R + 1,) int64 of lines and rings, parts (K + 1,) int64 of the shapes that they make
    evenodd (K,) bool: the rule that a shape is filled by. What begins where it ends, and has three points or more, is closed.
    """
    count = np.diff(offsets)
    closed = np.zeros(len(count), np.bool_)
    rings = np.flatnonzero(count > 2)
    closed[rings] = (coords[offsets[rings]] == coords[offsets[rings + 1] - 1]).all(1)
    verbs = np.concatenate([[0], np.cumsum(count + closed)])[parts]
    points = offsets[parts]
    size = HEAD + 8 * np.diff(points) + (np.diff(verbs) + 3) // 4 * 4
    begins = np.concatenate([[0], np.cumsum(size)]).astype(np.int64)
    out = np.zeros(begins[-1], np.uint8)
    head = np.zeros((len(size), 4), np.uint32)
    head[:, 0] = VERSION + EVEN_ODD * evenodd
    head[:, 1], head[:, 3] = np.diff(points), np.diff(verbs)
    _fill(out, begins, head.view(np.uint8), coords.astype(np.float32).view(np.uint8), offsets, parts, closed)
    return out, begins


@kernel
def _fill(out: U1x1, begins: I8x1, head: U1x2, points: U1x2, offsets: I8x1, parts: I8x1, closed: B1x1) -> None:
    """Write heads (K, 16), points (P, 8, as bytes) and verbs to ``out``."""
    for k in range(len(begins) - 1):
        at = begins[k]
        for i in range(HEAD):
            out[at + i] = head[k, i]
        at += HEAD
        for p in range(offsets[parts[k]], offsets[parts[k + 1]]):
            for i in range(8):
                out[at + i] = points[p, i]
            at += 8
        for r in range(parts[k], parts[k + 1]):
            for p in range(offsets[r], offsets[r + 1]):
                out[at] = LINE if p > offsets[r] else MOVE
                at += 1
            if closed[r]:
                out[at] = CLOSE
                at += 1

"""Hatch: flat tones as parallel lines, all on one set, so that neighbouring tones join without a seam."""

from __future__ import annotations

import numpy as np

from tambour.core.arrays import F8x1, F8x2, I8x1
from tambour.core.kernels import kernel


@kernel
def areas(coords: F8x2, offsets: I8x1) -> tuple[F8x1, F8x1]:
    """Area and perimeter of closed outlines."""
    n = len(offsets) - 1
    area, around = np.zeros(n), np.zeros(n)
    for i in range(n):
        q = offsets[i + 1] - 1
        for p in range(offsets[i], offsets[i + 1]):
            area[i] += 0.5 * (coords[q, 0] * coords[p, 1] - coords[p, 0] * coords[q, 1])
            around[i] += np.hypot(coords[p, 0] - coords[q, 0], coords[p, 1] - coords[q, 1])
            q = p
        area[i] = abs(area[i])
    return area, around


@kernel
def hatched(coords: F8x2, offsets: I8x1, pitch: float, level: F8x1, slant: float) -> tuple[F8x2, I8x1]:
    """Segments (S, 4) of hatching within outlines (even-odd) and the outline (S,) each is in.

    Lines lie ``pitch`` apart from the origin on; an outline of level j takes every 2^j-th.
    """
    c, s = np.cos(slant), np.sin(slant)
    out, owner = np.empty((1024, 4)), np.empty(1024, np.int64)
    count, most = 0, 1
    for i in range(len(offsets) - 1):
        most = max(most, offsets[i + 1] - offsets[i])
    crossing = np.empty(most + 1)
    for i in range(len(offsets) - 1):
        low, high = np.inf, -np.inf
        for p in range(offsets[i], offsets[i + 1]):
            v = c * coords[p, 1] - s * coords[p, 0]
            low, high = min(low, v), max(high, v)
        if not low <= high:
            continue
        step = pitch * 2.0 ** level[i]
        for k in range(int(np.ceil(low / step)), int(np.floor(high / step)) + 1):
            v, n = k * step, 0
            q = offsets[i + 1] - 1
            for p in range(offsets[i], offsets[i + 1]):
                va, vb = c * coords[q, 1] - s * coords[q, 0], c * coords[p, 1] - s * coords[p, 0]
                if (va <= v) != (vb <= v):
                    ua, ub = c * coords[q, 0] + s * coords[q, 1], c * coords[p, 0] + s * coords[p, 1]
                    crossing[n] = ua + (ub - ua) * (v - va) / (vb - va)
                    n += 1
                q = p
            crossing[:n].sort()
            for j in range(0, n - 1, 2):
                if count == len(out):
                    more, whose = np.empty((2 * count, 4)), np.empty(2 * count, np.int64)
                    more[:count], whose[:count] = out, owner
                    out, owner = more, whose
                a, b = crossing[j], crossing[j + 1]
                out[count, 0], out[count, 1] = c * a - s * v, s * a + c * v
                out[count, 2], out[count, 3] = c * b - s * v, s * b + c * v
                owner[count] = i
                count += 1
    return out[:count].copy(), owner[:count].copy()

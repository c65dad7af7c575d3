"""Thread curves: every stitch as it lies on cloth, with its round ends (step 4 of the seed article).

Put a circle of the thread's radius r at each end of a stitch. The thread runs flat at height r, rolls round the circle,
and leaves it on the tangent of slope θ, which meets the cloth at distance r·cscθ from the circle's centre: there the
needle went in. ``exact`` insets the circles so that these holes are the needle points; ``bleed`` puts the circles at
the needle points, as the article prints it, and the holes lie r·cscθ outside. Below the cloth the way is mirrored at
the hole, down to -r·cosθ. A stitch shorter than 2r·cscθ has no room for two ends and is removed.

Where thread lies below, flat and round are lifted by its height, and the last straight is steeper: it still goes through
the hole.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tambour.core.arrays import F8x1, F8x2, I8x1
from tambour.core.check import Array
from tambour.core.kernels import kernel

ARC = 2
"""Points on the round between the tangent and the top, at each end."""


@dataclass(frozen=True, slots=True)
class Curves:
    """N stitches as curves over the plan: ``offsets`` (N + 1,), ``plan`` (P, 2) mm, ``height`` (P,) mm above the cloth,
    ``u`` (P,) share of the curve's length, ``stitch`` (N,) which of the given stitches each is."""

    offsets: Array
    plan: Array
    height: Array
    u: Array
    stitch: Array


@kernel
def _lay(
    start: F8x2,
    end: F8x2,
    length: F8x1,
    lift: F8x1,
    exact: bool,
    offsets: I8x1,
    t: F8x1,
    r: float,
    theta: float,
    arc: int,
    first: I8x1,
    plan: F8x2,
    height: F8x1,
    u: F8x1,
    stitch: I8x1,
) -> int:
    """Fill the curves; with an empty ``plan`` count points into ``first``. Gives the number of curves."""
    sine, cosine = np.sin(theta), np.cos(theta)
    fill = len(plan) > 0
    hole = r / sine
    inset = hole if exact else 0.0
    n = q = 0
    for s in range(len(start)):
        if length[s] < 2.0 * hole:
            continue
        low, high = inset, length[s] - inset
        inside = 0
        for k in range(offsets[s], offsets[s + 1]):
            if low + 1e-6 < t[k] * length[s] < high - 1e-6:
                inside += 1
        count = 2 * (arc + 3) + inside
        if fill:
            dx, dy = (end[s, 0] - start[s, 0]) / length[s], (end[s, 1] - start[s, 1]) / length[s]
            begin = q
            # The way's end below the cloth: on the line from the round through the hole.
            foot = hole
            if cosine > 1e-9:
                foot += (hole - r * sine) * r * cosine / (lift[s] + r * cosine)
            for side in range(2):
                base, way = (low, -1.0) if side == 0 else (high, 1.0)
                if side == 1:
                    for k in range(offsets[s], offsets[s + 1]):
                        x = t[k] * length[s]
                        if low + 1e-6 < x < high - 1e-6:
                            u[q], height[q] = x, r + lift[s]
                            q += 1
                for step in range(arc + 3):
                    k = step if side == 0 else arc + 2 - step
                    if k == 0:
                        u[q], height[q] = base + way * foot, -r * cosine
                    else:
                        angle = theta * (1.0 - (k - 1.0) / (arc + 1.0))
                        u[q], height[q] = base + way * r * np.sin(angle), r * np.cos(angle) + lift[s]
                    q += 1
            for i in range(begin, q):
                plan[i, 0], plan[i, 1] = start[s, 0] + dx * u[i], start[s, 1] + dy * u[i]
            way = 0.0
            last = 0.0
            for i in range(begin, q):
                if i > begin:
                    way += np.sqrt((u[i] - last) ** 2 + (height[i] - height[i - 1]) ** 2)
                last = u[i]
                u[i] = way
            for i in range(begin, q):
                u[i] = u[i] / way
            stitch[n] = s
        else:
            q += count
        first[n + 1] = q
        n += 1
    return n


def curves(
    start: Array,
    end: Array,
    *,
    radius: float,
    theta: float = np.pi / 3,
    ends: str = "exact",
    base: Array | None = None,
    cuts: tuple[Array, Array] | None = None,
    arc: int = ARC,
) -> Curves:
    """Curves of straight stitches ``start`` → ``end`` (S, 2) mm.

    radius : of the thread, mm · theta : entry angle, radians, 0 < θ ≤ π/2 · ends : "exact" or "bleed"
    base : (S,) mm of thread below each stitch · cuts : offsets (S + 1,) and parameters in (0, 1) where the stitch crosses
    edges of the cloth, from ``bind.crossings`` · arc : points on each round besides its two ends

    Seed section 5: P0 = (s - (2r·cscθ - r·sinθ), -r·cosθ), P1 = (s - r·sinθ, r·cosθ), interior at height r.
    """
    start, end = np.ascontiguousarray(start, np.float64), np.ascontiguousarray(end, np.float64)
    count = len(start)
    length = np.hypot(*(end - start).T) if count else np.zeros(0)
    lift = np.zeros(count) if base is None else np.ascontiguousarray(base, np.float64)
    offsets, t = (np.zeros(count + 1, np.int64), np.zeros(0)) if cuts is None else cuts
    first = np.zeros(count + 1, np.int64)
    given = (start, end, length, lift, ends == "exact", offsets, t, radius, theta, arc, first)
    stays = _lay(*given, np.zeros((0, 2)), np.zeros(0), np.zeros(0), np.zeros(0, np.int64))
    first = first[: stays + 1]
    total = int(first[-1])
    plan, height, u, stitch = np.empty((total, 2)), np.empty(total), np.empty(total), np.zeros(stays, np.int64)
    if total:
        _lay(*given, plan, height, u, stitch)
    return Curves(first.copy(), plan, height, u, stitch)

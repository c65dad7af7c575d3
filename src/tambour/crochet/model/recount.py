"""Recount: the counts of a part for another outline, its own rounds kept where they still fit."""

from __future__ import annotations

import math

import numpy as np

from tambour.core.check import Array
from tambour.crochet.model.cheapest import cheapest
from tambour.crochet.model.outline import Outline
from tambour.crochet.model.readable import LEAST, MOST_RING, trouble

FIT, SHARE = 1.5, 0.04
"""A round still fits when it is off by so many stitches, or by this share of them."""
NEAR = 3
"""How many stitches a new round's count may be moved for one that reads better."""
DRAWN = 12
"""The most stitches that are drawn together."""


def wanted(now: list[int], old: Outline, new: Outline, row: float, width: float, closed: bool) -> Array:
    """How many stitches (R,) the rounds of ``new`` want: as many as ``now`` where it is like ``old``, more where it is wider.

    old, new : outlines in mm from the beginning of the work; row, width : mm of a row and of a stitch, as stuffed
    The length decides how many rounds there are; at either end they compare to the old ones as many from that end.
    """
    ring = np.arange(len(old.line))[0 if old.line[0, 0] > 0 else 1 :][: len(now)]
    rows = max(3, len(now) + round((new.way[-1] - old.way[-1]) / row))
    over = np.asarray(now) - _girth(old, old.way[ring], width)
    # Rounds lie as far from the beginning, and beyond the middle from the end, as they did.
    half = min(rows, len(now)) // 2
    at = np.concatenate(
        [np.arange(half), np.linspace(half, len(now) - half - 1, rows - 2 * half), len(now) + np.arange(-half, 0)]
    )
    way = np.interp(at, np.arange(len(now)), old.way[ring])
    way[rows - half :] += new.way[-1] - old.way[-1]
    way[half : rows - half] = np.interp(
        np.arange(half, rows - half), [half - 1, rows - half], way[[half - 1, rows - half]]
    )
    if rows == len(now) and abs(new.way[-1] - old.way[-1]) < 0.5 * row:  # as many as before, each where it was
        way = old.way[ring] * (new.way[-1] / old.way[-1])
    made = _girth(new, way, width) + np.interp(at, np.arange(len(now)), over)
    made[0] = min(made[0], max(MOST_RING, now[0]))
    if closed:
        made[-1] = min(made[-1], DRAWN)
    return np.asarray(np.maximum(made, LEAST))


def _girth(outline: Outline, way: Array, width: float) -> Array:
    return np.asarray(2.0 * math.pi * outline.at(way)[:, 0] / width)


def kept(now: list[int], goal: Array) -> list[int]:
    """For each round that is wanted (R,) the old one that serves for it, rising, or -1: as many as possible fit."""
    rows, old = len(goal), len(now)
    cost = np.full((rows + 1, old + 1), np.inf)
    cost[0] = 0.0
    step = np.zeros((rows + 1, old + 1), np.int8)
    for j in range(1, rows + 1):
        fits = max(FIT, SHARE * goal[j - 1])
        for k in range(old + 1):
            best, way = cost[j - 1, k] + (1.5 if j in (1, rows) else 1.0), 1
            if k:
                if cost[j, k - 1] + 1e-6 < best:
                    best, way = cost[j, k - 1] + 1e-6, 2
                off = abs(now[k - 1] - goal[j - 1])
                # A round that is as far from one end as it was comes before one that merely has as many stitches.
                far = min(abs(k - j), abs((old - k) - (rows - j)))
                price = cost[j - 1, k - 1] + 0.1 * off / fits + 0.05 * far
                if off <= fits and price <= best:
                    best, way = price, 3
            cost[j, k], step[j, k] = best, way
    found = [-1] * rows
    j, k = rows, old
    while j:
        if step[j, k] == 3:
            found[j - 1] = k - 1
            j, k = j - 1, k - 1
        elif step[j, k] == 2:
            k -= 1
        else:
            j -= 1
    return found


def chosen(goal: Array, fixed: list[int | None], plain: float) -> list[int]:
    """Whole counts near ``goal`` (R,), those that are fixed as they are where the others can come to them and go on from them."""

    def tries(k: int) -> list[int]:
        old = fixed[k]
        near = {*range(max(LEAST, math.floor(goal[k]) - NEAR), math.ceil(goal[k]) + NEAR + 1)} | (
            {old} if old is not None else set()
        )
        return sorted(n for n in near if k or n <= max(MOST_RING, old or 0))

    def own(k: int, n: int) -> float:
        if n == fixed[k]:
            return 0.0
        return float((n - goal[k]) ** 2 / (0.6 + 0.02 * goal[k]) + (0.0 if fixed[k] is None else 1e4))

    return cheapest(goal.tolist(), tries, own, lambda k, before, n: 4.0 * plain * trouble(before, n))

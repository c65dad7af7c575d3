"""Paired: the two of a pair sewn on by the same words: in one round, as many stitches from the middle of a side, leaning as each other's mirror image,
or as each has to so that they come to lie as that."""

from __future__ import annotations

import numpy as np

from tambour.core.check import Array
from tambour.crochet.finish.placing import AROUND, sides
from tambour.crochet.language.finishes import Spot
from tambour.crochet.model.posed import BESIDE, LEANED, Host, Wish, levels, point_of, priced
from tambour.crochet.model.tips import Mirror
from tambour.geometry.motion import length

How = tuple[Spot, int, int]
"""A spot, the number of a lean among LEANED, and that of a turn about itself among WAYS."""
NEAR = 6
"""So many stitches of a round are looked at more closely than by where the round itself lies."""
OWN = 0.2
"""What leans of their own have to win, in stitches and over both of a pair, to be worth their words: a part is worked the same way round
as its twin, so it is none of its mirror images and may have to lean otherwise to come to lie as one."""
IMAGE = [LEANED.index((tilt, -towards % 360)) for tilt, towards in LEANED]
"""Of every lean the number of its mirror image."""


def paired(
    one: Wish, two: Wish, plane: Mirror, had: list[tuple[Spot, float, float, float]], same: list[float]
) -> tuple[float, tuple[How, How]] | None:
    """The best ways to sew on a pair by the same words, and the price of both; None where there is no place for that.

    plane : the mirror, as the hosts lie. How each is turned about itself is free: both are worked the same way, so a part that is not round
    or bends is no mirror image of its twin; and how each leans, at the price of OWN
    had : ways of the first (spot, tilt, towards, turn) not to be found again, nor turned as is the ``same``
    """
    spots = [both for level in levels(one.host, one.near) for both in _opposite(one, two, plane, *level)]
    if not spots:
        return None
    here = priced(one, [a for a, _ in spots]).but(had, same).price
    there = priced(two, [b for _, b in spots]).price
    own, its = here.min(2), there.min(2)
    alike = own + its[:, IMAGE]
    apart = own.min(1) + its.min(1) + OWN
    s = int(np.minimum(alike.min(1), apart).argmin())
    if not np.isfinite(min(alike[s].min(), apart[s])):
        return None
    k = int(alike[s].argmin())
    one_, two_ = (k, IMAGE[k]) if alike[s, k] <= apart[s] else (int(own[s].argmin()), int(its[s].argmin()))
    how = (spots[s][0], one_, int(here[s, one_].argmin())), (spots[s][1], two_, int(there[s, two_].argmin()))
    return float(own[s, one_] + its[s, two_]), how


def _opposite(one: Wish, two: Wish, plane: Mirror, number: float, k: int, nodes: Array) -> list[tuple[Spot, Spot]]:
    """Of a round the stitches nearest to where the two are wished, each as far from the middle of its side as the other is."""
    low = two.host.spots.round_at(two.host.part, int(np.floor(number)))
    others = two.host.spots.stitches(low) if low is not None else nodes[:0]
    n = len(nodes)
    if n < 3 or len(others) != n:
        return []
    across = opposites(one.host, nodes, others, plane, two.host.part == one.host.part)
    far = length(one.host.x[nodes] - one.point) + length(two.host.x[others[across]] - two.point)
    near = np.argsort(far, kind="stable")[: BESIDE + NEAR].tolist()
    tries = [(Spot(one.host.name, number, s + 1.0), Spot(two.host.name, number, float(across[s]) + 1.0)) for s in near]
    off = [
        float(length(point_of(one.host, a) - one.point) + length(point_of(two.host, b) - two.point)) for a, b in tries
    ]
    return [tries[j] for j in np.argsort(off, kind="stable")[:BESIDE]]


def opposites(host: Host, nodes: Array, others: Array, plane: Mirror, alone: bool) -> Array:
    """Of every stitch of a round, ``nodes`` (K,) of the host, the number (K,), from 0, of its mirror image among the stitches ``others`` (K,).

    alone : both are the same round: they are counted from the stitch in the middle of the front, or of the back for what is nearer to that
    """
    x, s, n = host.x[nodes], np.arange(len(nodes)), len(nodes)
    image = plane.image(x)

    def miss(to: int) -> float:
        """How far the stitches lie from each other's images where the first one's is the number ``to``."""
        return float(length(host.x[others[(to - s) % n]] - image).sum())

    if not alone:
        return np.asarray((min(range(n), key=miss) - s) % n)
    found = sides(x)
    ways = list(found.values()) if found else [np.array([0.0, 0.0, 1.0]), np.array([0.0, 0.0, -1.0])]
    middles = [int(((x - x.mean(0)) * way).sum(1).argmax()) for way in ways]
    front, back = (min((m, m - 1, m + 1), key=lambda one: miss(2 * one)) for m in middles)
    off = (s - front + n // 2) % n - n // 2
    return np.asarray(np.where(np.abs(off) <= AROUND * n, 2 * front - s, 2 * back - s) % n)

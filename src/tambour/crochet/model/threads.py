"""Threads: where a stuffed part is to be pulled in, from stitch to stitch through its stuffing, so that it comes nearer its model."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from tambour.crochet.model.distance import outside
from tambour.geometry.motion import turned
from tambour.geometry.surface import vertex_normals

if TYPE_CHECKING:
    from tambour.crochet.model.loop import Tried

EVERY = 40
"""A part that shall be as near as can be has a thread for so many of its stitches, at the most."""
FEW, NEAR, FLAT = 2, 30, 8
"""Any other has one for NEAR stitches up to FLAT of them, as a fin needs to lie flat, but FEW at the least,"""
PER, MANY = 64, 24
"""and where that is more, one for PER stitches up to MANY of them."""
EACH = 0.003
"""A batch of threads is kept where each of them takes so much, in stitches, off the part's mean distance,"""
WINS, AMOUNT = 0.12, 0.05
"""and all of them only where they take such a share, and so much, off it."""
APART = 2.5
"""Ends of threads lie at least so far from each other, in stitches: each wants fabric of its own."""
PROUD, MORE = 0.3, 0.6
"""Both ends lie so far outside of the model, and by so much more apart than they should, in stitches, or it is not worth it."""
ACROSS = 0.5
"""The cosine of the angle at which a thread leaves the fabric, at the least: it goes through the stuffing."""
SHORT, LONG = 1.5, 12.0
"""A thread is not pulled shorter than this, in stitches; nor is one led farther, for no needle is as long."""

FIRST, TIGHT = 0.4, 0.35
"""A thread is pulled tighter than its ends belong, as fabric bulges on all sides of them: at first by such a share of what they
are too far apart, and at the most by such a share of their way."""

Hold = tuple[int, float, int, float, float]
"""A thread: the round, from 0, and the share of the way round it, of either end; and how much tighter than its ends belong, in stitches."""


def most(stitches: int, plain: float) -> int:
    """How many threads a part of so many stitches has at the most; the easiest rounds have none."""
    if plain <= 0.0:
        return int(1.5 * stitches / EVERY)
    return min(max(FEW, min(stitches // NEAR, FLAT), stitches // PER), MANY) if plain < 1.0 else 0


def worth(bare: Tried, pulled: Tried) -> bool:
    """Whether threads win so much that a maker is asked to pull them."""
    won = bare.distance.mean - pulled.distance.mean
    return won >= max(AMOUNT, WINS * bare.distance.mean)


def held(holds: tuple[Hold, ...], counts: list[int]) -> list[tuple[int, int, float]]:
    """The nodes that threads hold in a part of rounds of ``counts`` stitches, its ring's middle first, and how much tighter each is."""
    first = np.concatenate([[1], 1 + np.cumsum(counts)]).tolist()

    def node(k: int, share: float) -> int:
        return int(first[k]) + round(share * counts[k]) % counts[k]

    made = {(node(k, s), node(n, t)): more for k, s, n, t, more in holds if max(k, n) < len(counts)}
    return [(a, b, more) for (a, b), more in made.items() if a != b]


def tightened(last: Tried, step: float) -> tuple[Hold, ...]:
    """The threads of ``last``, each pulled tighter by what the fabric about its two ends lies outside of the model, or let out."""
    lain = turned(last.worked.x, last.distance.turn) + last.distance.shift
    off = outside(last.target, lain)
    made = []
    for hold in last.holds:
        found = held((hold,), last.counts)
        if not found:
            made.append(hold)
            continue
        a, b, more = found[0]
        far = float(np.sqrt(((last.goal[a] - last.goal[b]) ** 2).sum()))
        proud = sum(float(off[((last.goal - last.goal[v]) ** 2).sum(1) < APART**2].mean()) for v in (a, b))
        made.append((*hold[:4], float(np.clip(more + step * proud, 0.0, TIGHT * far))))
    return tuple(made)


def chosen(last: Tried, many: int, tighter: float = FIRST) -> tuple[Hold, ...]:
    """The threads of ``last`` and up to ``many`` more: between stitches that lie outside of the model on either side of it, those
    first that are too far apart by most. ``tighter``: by what share of that they are pulled closer than they belong."""
    counts = last.counts
    first = np.concatenate([[1], 1 + np.cumsum(counts)])
    n = np.arange(1, first[-1])
    number = np.repeat(np.arange(len(counts)), counts)
    goal = last.goal[n]
    lain = turned(last.worked.x, last.distance.turn) + last.distance.shift
    normal = vertex_normals(lain, last.worked.graph.faces)[n]
    free = outside(last.target, lain)[n] > PROUD
    for node in [v for a, b, _ in held(last.holds, counts) for v in (a, b)]:
        free &= ((goal - last.goal[node]) ** 2).sum(1) > APART**2
    open_ = np.flatnonzero(free)
    x, g, out = lain[n][open_], goal[open_], normal[open_]
    way = x[None] - x[:, None]
    far = np.sqrt((way**2).sum(2)) + 1e-9
    wanted = np.sqrt(((g[None] - g[:, None]) ** 2).sum(2))
    leaves, comes = -(way * out[:, None]).sum(2) / far, (way * out[None]).sum(2) / far
    across = np.minimum(leaves, comes)
    price = np.where((across > ACROSS) & (wanted > SHORT) & (wanted < LONG), (far - wanted) * across, 0.0)
    made = list(last.holds)
    for _ in range(many if len(open_) else 0):
        a, b = np.unravel_index(int(price.argmax()), price.shape)
        if price[a, b] < MORE:
            break
        ends = sorted((int(open_[a]), int(open_[b])))
        share = [(int(number[v]), float((n[v] - first[number[v]]) / counts[number[v]])) for v in ends]
        made.append((*share[0], *share[1], tighter * float(far[a, b] - wanted[a, b])))
        for v in (a, b):
            near = ((g - g[v]) ** 2).sum(1) < APART**2
            price[near] = 0.0
            price[:, near] = 0.0
    return tuple(made)

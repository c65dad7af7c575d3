"""Dyed: the colours of a model as yarns, stitch by stitch."""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Final

import numpy as np

from tambour.color import from_oklab, nearest_distinct, oklab
from tambour.core.check import Array
from tambour.core.graph import StitchGraph
from tambour.core.rgb import RGB
from tambour.crochet.model.rounds import WORDS, Rounds
from tambour.crochet.printed.yarns.shades import YARNS
from tambour.crochet.yarn.course import leaning
from tambour.crochet.yarn.loops import LEAN
from tambour.geometry.closest import Tree, nearest

ENOUGH: Final = 0.05
"""Where no number of yarns is asked for: as many as bring all but two per cent of the surface so near, in Oklab."""
MOST_YARNS: Final = 6
"""But never more than this."""
TURNS: Final = 12
"""Rounds of k-means."""


@dataclass(frozen=True, eq=False, slots=True)
class Dye:
    """A coloured surface and the yarns that it becomes.

    tree, faces, lab : the surface, and the colour (V, 3), Oklab, of every vertex; means (K, 3), Oklab, and yarns (K, 3) : what
    each colour near a mean is worked in
    """

    tree: Tree
    faces: Array
    lab: Array
    means: Array
    yarns: Array

    def yarn(self, points: Array) -> Array:
        """The yarn (K,) of points (K, 3), by its number."""
        face, uv, _ = nearest(self.tree, points)
        corner = self.lab[self.faces[face]]
        lab = (1.0 - uv.sum(1, keepdims=True)) * corner[:, 0] + uv[:, :1] * corner[:, 1] + uv[:, 1:] * corner[:, 2]
        return np.asarray(((lab[:, None] - self.means) ** 2).sum(2).argmin(1))


def _corner(tree: Tree, faces: Array, points: Array) -> Array:
    """The nearest corner (K,) of the triangle that points (K, 3) lie on: where two colours meet there is no third one."""
    face, uv, _ = nearest(tree, points)
    weight = np.column_stack([1.0 - uv.sum(1), uv])
    return np.asarray(faces[face, weight.argmax(1)])


def dye(tree: Tree, faces: Array, color: Array, points: Array, count: int | None) -> Dye | None:
    """The yarns of a surface with colours (V, 3) uint8; None where it has one colour only and that is white or none.

    points : (P, 3) even over it, by which colours count; count : of the yarns, None for as many as it takes, six at most
    """
    lab = oklab(color)
    seen = lab[_corner(tree, faces, points)]
    means, off = _means(seen, count or 1)
    while count is None and off > ENOUGH and len(means) < MOST_YARNS:
        means, off = _means(seen, len(means) + 1)
    if len(means) == 1 and means[0, 0] > 0.98:
        return None
    shades = np.array(list(dict.fromkeys(YARNS.values())), np.uint8)
    wanted = from_oklab(means)
    return Dye(tree, faces, lab, means, shades[nearest_distinct(wanted, shades)])


def _means(seen: Array, count: int) -> tuple[Array, float]:
    """The means (K, 3), K <= count, of colours (P, 3), begun at those farthest from each other; how far off colours are."""
    means = seen[[int(((seen - np.median(seen, axis=0)) ** 2).sum(1).argmin())]]
    while len(means) < count:
        off = ((seen[:, None] - means) ** 2).sum(2).min(1)
        if off.max() < 1e-4:
            break
        means = np.vstack([means, seen[int(off.argmax())]])
    for _ in range(TURNS):
        own = ((seen[:, None] - means) ** 2).sum(2).argmin(1)
        means = np.array([seen[own == k].mean(0) if (own == k).any() else means[k] for k in range(len(means))])
    off = np.sqrt(((seen[:, None] - means) ** 2).sum(2).min(1))
    return means, float(np.quantile(off, 0.98))


def dyed(part: Rounds, goal: Array, how: Dye, graph: StitchGraph, hold: str) -> Rounds:
    """A part with the yarn of every stitch. goal : (N, 3) where the nodes of its ``graph`` belong, the ring's middle first.

    Rounds are a spiral: from a round's first stitch to its last they climb by a row, and so does where their colour is looked up.
    Columns of stitches lean, by how the yarn is held, and pictures in them: a stitch has the colour of where it shows.
    Single stitches of a colour among others take that of their neighbours.
    """
    counts = part.counts()
    first = np.concatenate([[1], 1 + np.cumsum(counts)])
    spiral = _climbed(goal, first)
    color = graph.color.copy()
    color[1 : first[-1]] = how.yarns[how.yarn(spiral[1 : first[-1]])]
    host, slip = leaning(replace(graph, color=color), LEAN[hold])
    after = np.minimum(host + 1, len(goal) - 1)
    yarn = how.yarn(spiral[host] + slip[:, None] * (spiral[after] - spiral[host]))
    found = [yarn[a:b] for a, b in pairwise(first)]
    for _ in range(2):
        found = _calmed(found)
    base = _rgb(how, int(np.bincount(found[0]).argmax()))
    rounds = []
    for one, yarns in zip(part.rounds, found[1:]):
        ends = np.cumsum([WORDS[word][1] for word in one.words]) - 1
        rounds.append(replace(one, colors=tuple(_rgb(how, int(yarns[e])) for e in ends)))
    return replace(part, color=base, rounds=tuple(rounds))


def _climbed(goal: Array, first: Array) -> Array:
    """The nodes (N, 3) on one spiral: each round, begun at the nodes ``first``, climbs by a row from its start to its end."""
    made = goal.copy()
    for k, (a, b) in enumerate(pairwise(first)):
        share = (np.arange(b - a) + 0.5) / (b - a) - 0.5
        for way, half in ((1, share > 0.0), (-1, share < 0.0)):
            if 0 <= k + way < len(first) - 1:
                other = goal[first[k + way] : first[k + way + 1]]
                at = np.minimum(((share[half] + 0.5) * len(other)).astype(int), len(other) - 1)
                own = np.flatnonzero(half) + a
                made[own] += np.abs(share[half])[:, None] * (other[at] - goal[own])
    return made


def _rgb(how: Dye, yarn: int) -> RGB:
    r, g, b = (int(v) for v in how.yarns[yarn])
    return r, g, b


def _calmed(rows: list[Array]) -> list[Array]:
    """Rows of yarns without single stitches: what differs from both neighbours, and from all but one of the stitches above
    and below, becomes as they are."""
    made = []
    for k, row in enumerate(rows):
        n = len(row)
        left, right = np.roll(row, 1), np.roll(row, -1)
        share = (np.arange(n) + 0.5) / n
        beside = [left, right]
        for other in (k - 1, k + 1):
            if 0 <= other < len(rows):
                at = (share * len(rows[other])).astype(int)
                beside += [rows[other][at]]
        alike = sum((b == row).astype(int) for b in beside)
        alone = (alike < 2) & (left != row) & (right != row)
        made.append(np.where(alone, left, row))
    return made

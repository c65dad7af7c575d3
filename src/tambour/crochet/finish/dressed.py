"""Dressed: clothes on the toy that they are made for, as they hang: a dress from the shoulders, a skirt from the waist, a scarf."""

from __future__ import annotations

import math
from typing import Final

import numpy as np

from tambour.core.check import Array
from tambour.crochet.finish.limp import LEGS
from tambour.crochet.graph.spots import Spots
from tambour.crochet.language.tree import Worn
from tambour.geometry.motion import length
from tambour.geometry.near import nearest

OFF: Final = 0.75
"""How far, in stitches, the fabric of clothes lies outside of the fabric below it."""
STEEP: Final = 0.75
"""Fabric that hangs widens by so much of a row's height at the most; what is wider falls in folds."""
GENTLY, BACK = 0.3, 0.6 * math.pi
"""So much of a row's height a cape widens, and so far, in radians, it reaches from the middle of the back to either side."""
HEAPED: Final = 0.25
"""So much of its height a row that has reached the ground lies farther out than the one above: it is heaped there, and no disc."""
FOLDS: Final = 9
"""Folds of a ruffle, all round."""
_ABOUT: Final = (1.3, 0.4)
"""How far along the body, in stitches, and about it, in radians, fabric is that clothes must lie outside of."""
_SLIDE: Final = {"neck": (0.0, 0.45), "waist": (0.42, 0.8), "brow": (0.25, 0.6)}
"""Between which shares of the way down what wears it a garment's upper end comes to lie, by where it is worn."""
_BESIDE: Final = 1.1
"""The two ends of a scarf hang so many of their widths apart."""
_UNEVEN: Final = 3.0
"""A sheet of which a row is so many times as wide as others is no plain one."""
_HANGS: Final = 0.6
"""A leg hangs of which so much is below the body."""
FITS: Final = 0.15
"""A row goes about who wears it whose width differs from what is about there by this, as a logarithm, or less."""
SLIM: Final = 0.3
"""A row of a garment that is so much slimmer than the one before was not laid out round it."""
FEW: Final = 0.25
"""A row of fewer stitches than this share of the middle one is none."""
TACKS: Final = 4
"""Stitches that hold clothes in their place."""


class Wearer:
    """What wears clothes, seen about its own axis.

    x : (K, 3) the places of its fabric, in stitches; up : (3,) the way to its upper end; front : (3,) ahead
    below : (L, 3) those of legs, which clothes lie outside of too
    """

    def __init__(self, x: Array, up: Array, front: Array, below: Array | None = None) -> None:
        self.down = -up / float(length(up))
        ahead = front - (front @ self.down) * self.down
        self.front = ahead / float(length(ahead))
        self.side = np.cross(self.front, self.down)
        self.middle = 0.5 * (x.min(0) + x.max(0))
        deep = (x - self.middle) @ self.down
        self.top, self.long = float(deep.min()), float(np.ptp(deep))
        self.middle = self.middle + self.top * self.down
        off = x - self.middle
        self.deep = off @ self.down
        self.far = np.hypot(off @ self.side, off @ self.front)
        self.angle = np.arctan2(off @ self.side, off @ self.front)
        legs = (np.zeros((0, 3)) if below is None else below) - self.middle
        self._deep = np.concatenate([self.deep, legs @ self.down])
        self._far = np.concatenate([self.far, np.hypot(legs @ self.side, legs @ self.front)])
        self._angle = np.concatenate([self.angle, np.arctan2(legs @ self.side, legs @ self.front)])

    def wide(self, deep: Array, angle: Array) -> Array:
        """How far (N,) its fabric reaches from its axis at places so far down and at angles about it, 0 its front."""
        made = np.zeros(len(deep))
        for begin in range(0, len(deep), 256):
            part = slice(begin, begin + 256)
            turn = np.abs((self._angle[None] - angle[part, None] + math.pi) % (2.0 * math.pi) - math.pi)
            near = (np.abs(self._deep[None] - deep[part, None]) < _ABOUT[0]) & (turn < _ABOUT[1])
            made[part] = np.where(near, self._far[None], 0.0).max(1, initial=0.0)
        return made

    def mean(self, deep: float) -> float:
        """How far its fabric is from its axis at one level, in the mean."""
        near = np.abs(self.deep - deep) < _ABOUT[0]
        return float(self.far[near].mean()) if near.any() else 0.0

    def at(self, deep: Array, angle: Array, far: Array) -> Array:
        """Places (N, 3) so far down, at angles about its axis and so far from that."""
        about = np.cos(angle)[:, None] * self.front + np.sin(angle)[:, None] * self.side
        return np.asarray(self.middle + deep[:, None] * self.down + far[:, None] * about)

    def catches(self, where: str, wide: float) -> float:
        """How far down an end that is so wide, from its axis, comes to lie: where the body is as wide, and no farther."""
        low, high = (share * self.long for share in _SLIDE[base(where)])
        for deep in np.arange(low, high, 0.5):
            if self.mean(float(deep)) + OFF >= wide:
                return float(deep)
        return low


def fits(wearer: Wearer, where: str, wide: float) -> bool:
    """Whether an end that is so wide goes on: crochet stretches by half, and what is far wider would fall off."""
    below = wearer.mean(wearer.catches(where, wide)) + OFF
    return 0.6 * below <= wide <= 2.0 * below


class Cloth:
    """A garment as it was worked, about its own axis, its upper end first.

    level : (K,) the row of each node; angle : (K,) radians, 0 the middle; off : (K,) how much farther out it is than its row
    wide, step : of every row, how far it is from the axis and how far from the row above, in stitches
    even : no row is far wider than the others: of what is worked on from the side of a bodice the rows run two ways
    """

    def __init__(self, spots: Spots, part: int, around: float) -> None:
        graph = spots.built.graph
        span = graph.parts[part]
        x = spots.layout[span.start : span.end]
        level = _whole(np.unique(graph.round[span.start : span.end], return_inverse=True)[1].reshape(-1))
        numbers = np.unique(level)
        self.rows = bool(spots.in_rows[part])
        if self.rows:
            across, along = x[:, 0], x[:, 1]
            if self._sideways(x, level, around):  # worked from one side to the other
                across, along = along, -across
                level = np.round(along - along.min()).astype(int)
                numbers, level = np.unique(level, return_inverse=True)
            width = np.array([float(np.ptp(across[level == k])) + 1.0 for k in range(len(numbers))])
            height = np.array([float(along[level == k].mean()) for k in range(len(numbers))])
            self.even = float(width.max()) < _UNEVEN * float(np.median(width))
            closed = width > 0.8 * around
            self.closed = bool(closed.mean() > 0.5)
            wide = np.where(closed, width, around) / (2.0 * math.pi)
            middle = np.array([float(across[level == k].mean()) for k in range(len(numbers))])
            self.angle, self.off = (across - middle[level]) / wide[level], np.zeros(len(x))
        else:
            middle2 = np.array([x[level == k][:, [0, 2]].mean(0) for k in range(len(numbers))])
            off = x[:, [0, 2]] - middle2[level]
            far = np.hypot(off[:, 0], off[:, 1])
            wide = np.array([float(far[level == k].mean()) for k in range(len(numbers))])
            height = np.array([float(x[level == k, 1].mean()) for k in range(len(numbers))])
            self.angle, self.off, self.closed = np.arctan2(off[:, 0], off[:, 1]), far - wide[level], True
            self.even = True
            for k in range(
                1, len(numbers)
            ):  # picots and loops along an edge are laid out as one strand: they go round it
                if wide[k] < SLIM * wide[k - 1]:
                    self._around(level == k - 1, level == k)
                    wide[k], height[k] = wide[k - 1], 2.0 * height[k - 1] - height[max(k - 2, 0)]
        order = np.arange(len(numbers))
        ends = [float(np.median(wide[:2])), float(np.median(wide[-2:]))]
        if ends[1] < 0.9 * ends[0] and (not self.rows or self.closed):
            order = order[::-1]
            self.angle = -self.angle
        elif self.rows and not self.closed:
            order = order[::-1]  # the last row is the upper edge
        rank = np.argsort(order)
        self.level, self.wide = rank[level], wide[order]
        high = height[order]
        self.step = np.concatenate([[0.0], np.minimum(np.hypot(np.diff(self.wide), np.diff(high)), 3.0)])

    def _around(self, edge: Array, row: Array) -> None:
        """Lays a row (K,) bool of nodes evenly round the one before, ``edge``, as that runs."""
        turn = np.unwrap(self.angle[edge])
        way = 1.0 if turn[-1] >= turn[0] else -1.0
        self.angle[row] = turn[0] + way * np.linspace(0.0, 2.0 * math.pi, int(row.sum()), endpoint=False)
        self.off[row] = 0.0

    @staticmethod
    def _sideways(x: Array, level: Array, around: float) -> bool:
        """Whether the rows of a piece run up and down on who wears it: its length goes about there better than its rows do, those about its
        upper or its lower edge among them."""
        across, along = (float(np.ptp(x[:, k])) + 1.0 for k in (0, 1))
        last = int(level.max(initial=0))
        edges = [k for k in range(last + 1) if 3 * min(k, last - k) <= last]
        rows = [across, *(float(np.ptp(x[level == k, 0])) + 1.0 for k in edges)]
        off = min(abs(math.log(row / around)) for row in rows)
        return off > FITS and abs(math.log(along / around)) < off and along > 0.7 * around

    def on(self, wearer: Wearer, where: str, floor: float) -> Array:
        """Its nodes (K, 3) as they hang on who wears it; floor : how far down, from its upper end, the ground is."""
        deep, far, fold = [], [], []
        s = wearer.catches(where, float(self.wide[0]))
        r = max(float(self.wide[0]), wearer.mean(s) + OFF) if self.closed else wearer.mean(s) + OFF
        behind = where == "nape"
        for wide, step in zip(self.wide, self.step):
            widest = r + (GENTLY if behind else STEEP) * step
            least = wearer.mean(s) + OFF
            new = max(min(float(wide), widest), least)
            if s + step > floor:  # it lies on the ground
                new, s = r + HEAPED * step, floor
            else:
                s += math.sqrt(max(step * step - (new - r) ** 2, 0.1 * step * step))
            r = new
            deep.append(s)
            far.append(r)
            fold.append(max(1.0, float(wide) / max(r, 1e-6)))
        # A cape hangs down the back in folds, and leaves the front free, however wide it is.
        spread = min(1.0, BACK / max(float(np.abs(self.angle).max()), BACK)) if behind else 1.0
        turn = spread * self.angle + (math.pi if behind else 0.0)
        down, out, more = (np.array(v)[self.level] for v in (deep, far, fold))
        wave = np.minimum(out / FOLDS * np.sqrt(2.0 * (np.minimum(more, 2.5) ** 2 - 1.0)), 1.6)
        below = wearer.wide(down, turn) + OFF
        return wearer.at(down, turn, np.maximum(out + self.off + wave * np.sin(FOLDS * turn), below))


def _whole(level: Array) -> Array:
    """Rows (K,) of a garment's nodes, those of a few stitches counted to the row before: chains that lift the work, loops of an edging
    and the slip stitch that ends it are no row that goes round."""
    many = np.bincount(level)
    some = many >= FEW * np.median(many)
    row = np.maximum(np.cumsum(some) - 1, 0)
    return np.asarray(row[level])


def wound(x: Array, wearer: Wearer, at: float) -> Array:
    """A strip (K, 3), as it was worked, once about a neck ``at`` so far down, its two ends hanging in front."""
    along, across = (0, 1) if np.ptp(x[:, 0]) > np.ptp(x[:, 1]) else (1, 0)
    u = x[:, along] - 0.5 * (x[:, along].min() + x[:, along].max())
    v = x[:, across] - 0.5 * (x[:, across].min() + x[:, across].max())
    high = float(np.ptp(v)) + 1.0
    slim = 0.5  # a scarf about a neck is gathered
    r = wearer.mean(at) + OFF
    round_ = math.pi * r
    turn = np.clip(u / r, -math.pi, math.pi) + math.pi
    left = np.sign(u) * np.maximum(np.abs(u) - round_, 0.0)
    ends = left != 0.0
    apart = 0.5 * _BESIDE * slim * high
    deep = at + slim * v + np.abs(left)
    # Where it hangs, its width lies across.
    hung = np.minimum(np.abs(left) / max(high, 1.0), 1.0)
    deep = np.where(ends, at + (1.0 - hung) * slim * v + np.abs(left), deep)
    side = np.where(ends, np.sign(u) * apart * hung + hung * slim * v, 0.0)
    angle = np.where(ends, side / max(r, 1e-6), turn)
    least = wearer.wide(deep, angle) + OFF
    knot = np.where(ends & (u > 0.0), OFF, 0.0)
    return wearer.at(deep, angle, np.maximum(least, r) + knot)


def dressed(spots: Spots, x: Array, upright: Array, worn: tuple[Worn, ...], piece: Array) -> tuple[Array, Array]:
    """Places (N, 3) with every garment on who wears it, and the pairs (S, 2) of the stitches that hold it there.

    x : in stitches, the toys as they stand; upright : (P, 3) which way is up on every part; piece : (N,) the toy of every node
    """
    x, pairs = x.copy(), [np.zeros((0, 2), int)]
    graph = spots.built.graph
    layers: dict[int, list[Array]] = {}
    for one in worn:
        part, host = spots.parts[one.part], spots.parts[one.host]
        span, own = graph.parts[part], wears(spots, host, one.low, one.high)
        under = np.concatenate([x[own], *layers.get(host, [])])
        wearer = Wearer(under, upright[host], np.array([0.0, 0.0, 1.0]), _legs(spots, x, own, piece))
        nodes = np.arange(span.start, span.end)
        if one.where == "scarf":
            moved = wound(spots.layout[nodes], wearer, 0.04 * wearer.long)
        else:
            cloth = Cloth(spots, part, 2.0 * math.pi * (wearer.mean(wearer.catches(base(one.where), 0.0)) + OFF))
            toy = x[piece == piece[own[0]]]
            floor = float(((toy - wearer.middle) @ wearer.down).max()) - OFF
            moved = cloth.on(wearer, one.where, floor)
        x[nodes] = moved
        layers.setdefault(host, []).append(moved)
        pairs.append(_tacks(moved, nodes, x[own], own))
    return x, np.concatenate(pairs)


def _legs(spots: Spots, x: Array, own: Array, piece: Array) -> Array:
    """The places (L, 3) of the legs of a toy with the body ``own`` that hang down from it; of those that it sits with none."""
    graph, found = spots.built.graph, [np.zeros((0, 3))]
    low = float(x[own, 1].min())
    for span in graph.parts:
        leg = x[span.start : span.end]
        if not LEGS.search(span.name.lower()) or not len(leg) or piece[span.start] != piece[own[0]]:
            continue
        if low - float(leg[:, 1].min()) > _HANGS * float(np.ptp(leg, axis=0).max()):
            found.append(leg)
    return np.concatenate(found)


def base(where: str) -> str:
    """Where the upper end is of what is worn so."""
    return {"nape": "neck"}.get(where, where)


def wears(spots: Spots, host: int, low: int, high: int) -> Array:
    """The nodes of what wears clothes: the rounds from ``low`` to ``high`` of a part."""
    found = [spots.stitches(k) for n in range(low, high + 1) if (k := spots.round_at(host, n)) is not None]
    return np.unique(np.concatenate(found)) if found else np.zeros(0, int)


def _tacks(moved: Array, nodes: Array, there: Array, own: Array) -> Array:
    """Pairs (S, 2): the few stitches of a garment that come nearest to what wears it, each with that."""
    far, index = nearest(moved, there)
    best = np.argsort(far[:, 0], kind="stable")[:TACKS]
    return np.column_stack([nodes[best], own[index[best, 0]]])

"""Posed: where a part is sewn on and how it leans, of what there are words for, so that all of it lies nearest to where it belongs."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from tambour.core.check import Array
from tambour.crochet.finish.placing import level
from tambour.crochet.finish.sewing import UNDER
from tambour.crochet.graph.spots import Spots
from tambour.crochet.language.finishes import Spot
from tambour.crochet.words.phrases import CLOCK, LEANS, TURN
from tambour.geometry.motion import dot, length

WAYS: Final = tuple(range(0, 360, TURN))
"""How far a part can be said to be turned about itself, in degrees."""
LEANED: Final = ((0, 0), *((tilt, towards) for tilt in LEANS for towards in range(0, 360, CLOCK)))
"""How a part can be said to lean: its tilt and where to, in degrees."""
BESIDE, AROUND = 3, 6
"""How many stitches of a round are tried, the nearest ones; and among how many more they are looked for: between two rounds places lie beside stitches."""
LIFT = 1.5
"""How far out of the fabric a part comes to lie at the most, in stitches: it is sewn onto it, not into it."""
ALONG = 0.1
"""What a square that a node lies off along the fabric counts, against one across it: that of a part that is round shows hardly."""
WORDS = 0.15
"""What a lean, or a turn about itself, has to win, in stitches, to be worth its words."""


@dataclass(frozen=True, eq=False, slots=True)
class Poses:
    """Ways to sew a part on. spots : (S) places; price : (S, L, A) how far, in stitches, the part lies off as a whole, at each of them,
    leaning as in LEANED and turned about itself as in WAYS."""

    spots: tuple[Spot, ...]
    price: Array

    def best(self) -> tuple[float, tuple[Spot, int, int]]:
        """The least price, and the spot, the number of the lean and that of the turn about itself that have it."""
        s, k, a = np.unravel_index(int(self.price.argmin()), self.price.shape)
        return float(self.price[s, k, a]), (self.spots[s], int(k), int(a))

    def but(self, ways: list[tuple[Spot, float, float, float]], alike: list[float]) -> Poses:
        """The same without some ``ways``: the spot, tilt, towards and the turn about itself, in degrees, of each; nor, where that is 0,
        with the turns that are ``alike`` to none."""
        price = self.price.copy()
        for spot, tilt, towards, across in ways:
            lean = int(tilt), int(towards)
            if spot in self.spots and lean in LEANED:
                turns = [WAYS.index(int(turn)) for turn in ([across] if across else [across, *alike])]
                price[self.spots.index(spot), LEANED.index(lean), turns] = np.inf
        return Poses(self.spots, price)

    def at(self, number: float) -> tuple[Array, Array]:
        """For every lean (L,), what it costs at the best in round ``number``, and the spot and the turn (L, 2) that do it."""
        own = [s for s, spot in enumerate(self.spots) if spot.round == number]
        flat = self.price[own].transpose(1, 0, 2).reshape(len(LEANED), -1)
        found = flat.argmin(1)
        turns = self.price.shape[2]
        return flat.min(1), np.column_stack([np.array(own)[found // turns], found % turns])


@dataclass(frozen=True, eq=False, slots=True)
class Host:
    """What a part is sewn on.

    spots : of the whole pattern; part, name : its number and what it is called; nodes : its fabric; x, normals (N, 3) : of all;
    upright : (3,) its own
    """

    spots: Spots
    part: int
    name: str
    nodes: Array
    x: Array
    normals: Array
    upright: Array


def poses(host: Host, near: Spot, point: Array, own: Array, want: Array, out: Array, room: float) -> Poses:
    """The ways to sew a part on at places about ``near``, the one nearest to ``point``, on the fabric within ``room``.

    own : (K, 3) its nodes, from the middle of its end: along its axis, its front and across both; want : (K, 3) where they belong;
    out : (K, 3) the normals of its fabric there
    """
    spots, numbers = [], {r.number for r in host.spots.built.rounds if r.part == host.part}
    for number in near.round + np.arange(-1.0, 1.1, 0.5):
        low = host.spots.round_at(host.part, int(np.floor(number)))
        if low is None or not min(numbers) <= number <= max(numbers):
            continue
        about = np.argsort(length(host.x[host.spots.stitches(low)] - point), kind="stable")[: BESIDE + AROUND]
        tries = [Spot(host.name, float(number), s + 1.0) for s in sorted(about.tolist())]
        far = [float(length(_point(host, spot) - point)) for spot in tries]
        spots += [tries[k] for k in np.argsort(far, kind="stable")[:BESIDE]]
    off = _off(own, want, out)
    return Poses(tuple(spots), np.array([_prices(host, _point(host, spot), off, room) for spot in spots]))


def _off(own: Array, want: Array, out: Array) -> Array:
    """The mean square (13, 13) that nodes lie off, of a turn's nine numbers, a place's three and 1: along the normals ``out``, and
    ALONG of that in every direction, as a part that is round may be turned about itself."""
    many = len(own)

    def terms(way: Array) -> Array:
        rows = np.column_stack([(way[:, :, None] * own[:, None, :]).reshape(many, 9), way, -(way * want).sum(1)])
        return np.asarray((rows[:, :, None] * rows[:, None, :]).mean(0))

    every = [terms(np.broadcast_to(axis, own.shape)) for axis in np.eye(3)]
    return np.asarray(terms(out) + ALONG * (every[0] + every[1] + every[2]))


def _point(host: Host, spot: Spot) -> Array:
    place = host.spots.place(spot)
    return np.asarray((np.array(place.weights)[:, None] * host.x[list(place.nodes)]).sum(0))


def _prices(host: Host, point: Array, off: Array, room: float) -> Array:
    """What every lean and turn costs (L, A) at ``point``: the root of the mean square that its nodes lie ``off`` (13, 13)."""
    far = length(host.x[host.nodes] - point)
    looks = host.normals[host.nodes[int(far.argmin())]]
    outward = host.normals[host.nodes[far < room]]
    n = outward[dot(outward, looks) > 0.0].sum(0) if (far < room).any() else looks
    n = n / max(float(length(n)), 1e-9)
    along, up = (row[0] for row in level(n[None], host.upright[None]))
    turns = np.radians(WAYS)[:, None]
    ahead = up if n[1] < UNDER else -up
    front = np.cos(turns) * ahead + np.sin(turns) * np.cross(n, ahead)
    held = np.stack([np.broadcast_to(n, front.shape), front, np.cross(n, front)], axis=2)
    tilt, towards = np.radians(np.array(LEANED, float)).T[:, :, None]
    to = np.cos(towards) * up - np.sin(towards) * along
    k = np.cross(n, to)
    cross = np.zeros((len(k), 3, 3))
    cross[:, [2, 0, 1], [1, 2, 0]], cross[:, [1, 2, 0], [2, 0, 1]] = k, -k
    lean = np.eye(3) + np.sin(tilt)[..., None] * cross
    lean += (1.0 - np.cos(tilt))[..., None] * np.einsum("lij,ljk->lik", cross, cross)
    turned = np.einsum("lij,ajk->laik", lean, held)
    place = np.broadcast_to(np.append(point, 1.0), (*turned.shape[:2], 4))
    how = np.concatenate([turned.reshape(*turned.shape[:2], 9), place], axis=2)
    # How far out it lies is not said: it lies on the fabric.
    up_ = np.concatenate([np.zeros(9), n, np.zeros(1)])
    there = (up_[:, None] * off).sum(0)
    lift = np.clip(-(how * there).sum(2) / max(float((there * up_).sum()), 1e-12), 0.0, LIFT)
    how = how + lift[..., None] * up_
    price = np.sqrt(np.maximum((np.einsum("lai,ij->laj", how, off) * how).sum(2), 0.0))
    price[1:] += WORDS
    price[:, 1:] += WORDS
    return np.asarray(price)


def pair(one: Poses, two: Poses) -> tuple[float, tuple[tuple[Spot, int, int], tuple[Spot, int, int]]] | None:
    """The best ways to sew on a pair, in the same round, leaning as each other's mirror image, and the price of both; None where they share
    no round."""
    image = [LEANED.index((tilt, -towards % 360)) for tilt, towards in LEANED]
    best: tuple[float, tuple[Spot, int, int], tuple[Spot, int, int]] | None = None
    for number in sorted({s.round for s in one.spots} & {s.round for s in two.spots}):
        (cost, how), (other, way) = one.at(number), two.at(number)
        both = cost + other[image]
        k = int(both.argmin())
        if best is None or both[k] < best[0]:
            (s, a), (t, b) = how[k], way[image[k]]
            best = float(both[k]), (one.spots[s], k, int(a)), (two.spots[t], image[k], int(b))
    return None if best is None else (best[0], best[1:])

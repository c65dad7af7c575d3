"""Posed: where a part is sewn on and how it leans, of what there are words for, so that all of it lies nearest to where it belongs."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from tambour.core.check import Array
from tambour.crochet.finish.placing import level
from tambour.crochet.finish.sewing import ahead_on
from tambour.crochet.graph.spots import Spots
from tambour.crochet.language.finishes import Placed, Spot
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
OTHERWISE, ELSEWHERE = 0.003, 0.1
"""What it costs, in stitches, to be held otherwise by a degree, or elsewhere by a stitch, than in the way that tells how a part gives way:
there it gives way otherwise (a leg that is turned about itself by an eighth more leans by ten degrees less)."""


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


@dataclass(frozen=True, eq=False, slots=True)
class Wish:
    """Where a part belongs.

    host : what it is sewn on, near ``near``, the place nearest to ``point`` (3,), on the fabric within ``room``
    own : (K, 3) its nodes, from the middle of its end: along its axis, its front and across both; want : (K, 3) where they belong;
    out : (K, 3) the normals of its fabric there; as_then : how it was sewn on when it gave way as is reckoned with, None where it was not yet
    """

    host: Host
    near: Spot
    point: Array
    own: Array
    want: Array
    out: Array
    room: float
    as_then: Placed | None = None


def poses(wish: Wish) -> Poses:
    """The ways to sew a part on at the places nearest to where it is wished."""
    host, found = wish.host, list[Spot]()
    for number, _, nodes in levels(host, wish.near):
        about = np.argsort(length(host.x[nodes] - wish.point), kind="stable")[: BESIDE + AROUND]
        tries = [Spot(host.name, number, s + 1.0) for s in sorted(about.tolist())]
        far = [float(length(point_of(host, spot) - wish.point)) for spot in tries]
        found += [tries[k] for k in np.argsort(far, kind="stable")[:BESIDE]]
    return priced(wish, found)


def levels(host: Host, near: Spot) -> list[tuple[float, int, Array]]:
    """The rounds, and what lies between two, about ``near``: what each is called, the round it is counted on, and the stitches (K,) of that."""
    found, numbers = [], {r.number for r in host.spots.built.rounds if r.part == host.part}
    for number in (near.round + np.arange(-1.0, 1.1, 0.5)).tolist():
        low = host.spots.round_at(host.part, int(np.floor(number)))
        if low is not None and min(numbers) <= number <= max(numbers):
            found.append((number, low, host.spots.stitches(low)))
    return found


def priced(wish: Wish, spots: list[Spot]) -> Poses:
    """The ways to sew a part on at ``spots``, with what each costs."""
    off, points = _off(wish.own, wish.want, wish.out), [point_of(wish.host, spot) for spot in spots]
    price = np.array([_prices(wish.host, point, off, wish.room) for point in points])
    if wish.as_then is not None:
        far = length(np.array(points).reshape(-1, 3) - point_of(wish.host, wish.as_then.spot))
        price = price + OTHERWISE * _otherwise(wish.as_then) + ELSEWHERE * far[:, None, None]
    return Poses(tuple(spots), price)


def _otherwise(then: Placed) -> Array:
    """By how many degrees every lean and turn (L, A) is another than ``then``."""
    tilt, towards = np.radians(np.array([*LEANED, (then.tilt, then.towards)], float)).T
    way = np.column_stack([np.sin(tilt) * np.cos(towards), np.sin(tilt) * np.sin(towards), np.cos(tilt)])
    leans = np.degrees(np.arccos(np.clip((way[:-1] * way[-1]).sum(1), -1.0, 1.0)))
    turns = np.abs((np.array(WAYS, float) - then.across + 180.0) % 360.0 - 180.0)
    return np.asarray(leans[:, None] + turns)


def _off(own: Array, want: Array, out: Array) -> Array:
    """The mean square (13, 13) that nodes lie off, of a turn's nine numbers, a place's three and 1: along the normals ``out``, and
    ALONG of that in every direction, as a part that is round may be turned about itself."""
    many = len(own)

    def terms(way: Array) -> Array:
        rows = np.column_stack([(way[:, :, None] * own[:, None, :]).reshape(many, 9), way, -(way * want).sum(1)])
        return np.asarray((rows[:, :, None] * rows[:, None, :]).mean(0))

    every = [terms(np.broadcast_to(axis, own.shape)) for axis in np.eye(3)]
    return np.asarray(terms(out) + ALONG * (every[0] + every[1] + every[2]))


def point_of(host: Host, spot: Spot) -> Array:
    """Where a spot is on the fabric, (3,)."""
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
    ahead = ahead_on(n, up)
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

"""Stand: parts as they will stand in the toy, before anything settles: which way is up, where the head is, and the
stitch that lies nearest to a point or a direction."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from tambour.core.check import Array
from tambour.core.graph import ROOT, TIP
from tambour.crochet.finish import sewing
from tambour.crochet.finish.capped import across, lid_on
from tambour.crochet.finish.placing import Frames, frames, level, outward, standing
from tambour.crochet.graph.spots import Spots
from tambour.crochet.language.finishes import Eye, Placed, Spot

NECK = 0.82
"""A part has a neck where it is this much narrower than the narrower of what lies above and below."""
TIP_OF = 8
"""A limb's tip is closed from so many stitches or fewer."""


class Stand:
    """All parts of a pattern in the poses that are known so far; ``x`` (N, 3) in stitches, front +z, up +y."""

    def __init__(self, spots: Spots) -> None:
        self.spots = spots
        self.x = spots.layout.copy()
        self.upright = np.tile([0.0, 1.0, 0.0], (len(spots.built.graph.parts), 1))
        # Of parts, since they were turned last:
        self._frames: dict[int, dict[tuple[float, float | None], Frames]] = {}
        self._outward: dict[int, Array] = {}
        self._hosts: dict[int, dict[tuple[str, int, int], Host]] = {}

    def nodes(self, part: int) -> Array:
        """The nodes of a part."""
        p = self.spots.built.graph.parts[part]
        return np.arange(p.start, p.end)

    def set_up(self, part: int, up: str) -> None:
        """Stand a part that others stand on: its end on top, its start, or on its side."""
        own = self.nodes(part)
        self.spots.stand(part, up)
        self.x[own] = standing(self.spots.layout[own], up)
        self._turned(part)

    def _turned(self, part: int) -> None:
        """Forgets how a part lay; of all parts where some are worked into each other."""
        for known in (self._frames, self._outward, self._hosts):
            if self._woven:
                known.clear()
            known.pop(part, None)

    @cached_property
    def _woven(self) -> bool:
        """Whether some parts are worked into each other."""
        of = self.spots.built.graph.part[self.spots.built.graph.faces]
        return bool((of != of[:, :1]).any())

    def there(self, spot: Spot) -> bool:
        """Whether a spot is on the fabric."""
        return all(problem.warning for problem in self.spots.problems([Eye(spot)]))

    def frame(self, spot: Spot) -> Frames:
        """How the fabric lies at a spot (K = 1)."""
        part, place = self.spots.parts[spot.part], (spot.round, spot.stitch)
        known = self._frames.setdefault(part, {})
        if place not in known:
            if part not in self._outward:
                self._outward[part] = outward(self.spots, self.x, [part])
            made = self._outwards(spot, frames(self.spots, self.x, [spot], self.upright, self._outward[part]))
            known[place] = made
            for array in made:
                array.setflags(write=False)
        return known[place]

    def _outwards(self, spot: Spot, made: Frames) -> Frames:
        """The frame of an end that is drawn together: its last two stitches may look anywhere, also into the part."""
        if spot.stitch is not None or self.spots.place(spot).opening:
            return made
        part = self.spots.parts[spot.part]
        away = made.points[0] - self.x[self.nodes(part)].mean(0)
        if float(away @ made.normals[0]) >= 0.0:
            return made
        normals = (away / np.sqrt(away @ away))[None]
        return Frames(made.points, normals, *level(normals, self.upright[[part]]))

    def host(self, name: str, low: int, high: int) -> Host:
        """A part, or some of its rounds, that things are put on."""
        known = self._hosts.setdefault(self.spots.parts[name], {})
        place = (name, low, high)
        if place not in known:
            known[place] = Host(self, *place)
        return known[place]

    def place(self, placed: Placed) -> None:
        """Turn a part as it will be where it is placed."""
        part = self.spots.parts[placed.part]
        own = self.nodes(part)
        end = sewing.end_of(self.spots.built, self.spots, placed)
        if len(end.nodes) < 2:
            return
        layout = self.spots.layout
        how = sewing.held(layout, own, end)
        frame = self.frame(placed.spot)
        if len(lid := lid_on(self.spots.built, self.spots, placed, end)):
            frame = across(self.spots, self.x, lid, self.spots.parts[placed.spot.part], self.upright)
        axis, front = sewing.ways(placed, end, frame)
        self.x[own] = sewing.brought(layout, own, how, axis, front, frame.points[0])
        self.upright[part] = sewing.leaning(placed, frame) @ self.upright[self.spots.parts[placed.spot.part]]
        self._turned(part)


@dataclass(frozen=True, eq=False)
class Host:
    """A part, or the head or the body of one that is both, that things are put on.

    name : of the part, with its copy; low, high : numbers of its first and last round here
    """

    stand: Stand
    name: str
    low: int
    high: int

    @property
    def part(self) -> int:
        """Its number among the graph's parts."""
        return self.stand.spots.parts[self.name]

    @cached_property
    def levels(self) -> list[tuple[int, Array]]:
        """Its rounds: the number of each, and where its stitches are (n, 3)."""
        spots = self.stand.spots
        made, last = [], spots.round_at(self.part, self.high)
        for number in range(self.low, self.high + 1):
            k = spots.round_at(self.part, number)
            if k is not None and (last is None or k <= last) and len(nodes := spots.stitches(k)):
                made.append((number, self.stand.x[nodes]))
        return made or [(self.low, self.stand.x[self.stand.nodes(self.part)])]  # a chain alone has no rounds

    @cached_property
    def box(self) -> tuple[Array, Array]:
        """Its middle and half its extent (3,) along every axis."""
        points = np.concatenate([p for _, p in self.levels])
        low, high = points.min(0), points.max(0)
        return 0.5 * (low + high), np.maximum(0.5 * (high - low), 0.5)

    @cached_property
    def axis(self) -> Array:
        """The way from its first round to its last, of length 1; upwards where it has one round only."""
        way = self.levels[-1][1].mean(0) - self.levels[0][1].mean(0)
        long = float(np.sqrt(way @ way))
        return way / long if long > 1e-6 else np.array([0.0, 1.0, 0.0])

    def count(self, number: float) -> int:
        """How many stitches the round has."""
        k = self.stand.spots.round_at(self.part, int(number))
        return len(self.levels[-1][1]) if k is None else len(self.stand.spots.stitches(k))

    def within(self, spot: Spot) -> Spot:
        """The spot with its stitch counted on from the round's beginning where it lies beyond the round's end."""
        if spot.stitch is None:
            return spot
        many = max(self.count(number) for number in (spot.round, min(np.ceil(spot.round), self.high)))
        if 0.5 <= spot.stitch < many + 1:
            return spot
        rows = bool(self.stand.spots.in_rows[self.part])
        return replace(spot, stitch=float(many) if rows else round((spot.stitch - 1.0) % many + 1.0, 3))

    def _turned(self, number: int) -> bool:
        """Whether a round was worked from the wrong side."""
        k = self.stand.spots.round_at(self.part, number)
        nodes = np.zeros(0, int) if k is None else self.stand.spots.stitches(k)
        return len(nodes) > 0 and bool(self.stand.spots.built.graph.direction[nodes[0]] < 0)

    def middle(self, number: float) -> float:
        """The stitch in the middle of the front of a round."""
        k = self.stand.spots.round_at(self.part, int(number))
        return 1.0 if k is None else 1.0 + self.stand.spots.front(k)

    def aside(self, number: float, stitches: float) -> float:
        """The stitch of a round so many stitches to the toy's left of the middle of its front; negative: to its right."""
        middle, ring = self.middle(number), next((p for n, p in self.levels if n == int(number)), self.levels[-1][1])
        after, before = (ring[int(middle - 1 + k) % len(ring), 0] for k in (1, -1))
        return round(middle + (stitches if after > before else -stitches), 3)

    def pole(self, direction: Array, least: float = 0.9) -> Spot | None:
        """The middle of an end that looks in ``direction`` (by ``least``, a cosine): the ring, the tip, or the middle of the opening."""
        if self.stand.spots.in_rows[self.part]:  # its ends are edges, and no openings
            along = float(self.axis @ direction)
            return Spot(self.name, float(self.high if along > 0 else self.low), None) if abs(along) > least else None
        if float(self.axis @ direction) > least and self.high == self._ends[1]:
            g, p = self.stand.spots.built.graph, self.stand.spots.built.graph.parts[self.part]
            if (g.peculiarity[p.start : p.end] == TIP).any() or len(self.stand.spots.rim(self.part)):
                return Spot(self.name, float(self.high + 1), None)
        if float(self.axis @ direction) < -least and self.low == self._ends[0]:
            g, p = self.stand.spots.built.graph, self.stand.spots.built.graph.parts[self.part]
            if (g.peculiarity[p.start : p.end] == ROOT).any() or len(self.stand.spots.begun(self.part)):
                return Spot(self.name, float(self.low - 1), None)
        return None

    @property
    def begun(self) -> Spot | None:
        """The ring in the middle of a disc; None where it is no disc, or begins with no ring."""
        g, p = self.stand.spots.built.graph, self.stand.spots.built.graph.parts[self.part]
        wide = max(len(ring) for _, ring in self.levels)
        disc = wide > 4 * len(self.levels) and len(self.levels[-1][1]) == wide
        return (
            Spot(self.name, float(self.low - 1), None)
            if disc and (g.peculiarity[p.start : p.end] == ROOT).any()
            else None
        )

    @property
    def _ends(self) -> tuple[int, int]:
        return numbers_of(self.stand.spots, self.part)

    def towards(self, direction: Array) -> Array:
        """The point on the surface that lies in ``direction`` from its middle, as if it were an ellipsoid."""
        middle, half = self.box
        d = direction / max(float(np.sqrt(direction @ direction)), 1e-9)
        return np.asarray(middle + d * half)

    def ahead(self, x: float, y: float) -> Array:
        """The point of its front that one sees at (x, y) from before it."""
        points = np.concatenate([p for _, p in self._with_poles])
        away = (points[:, 0] - x) ** 2 + (points[:, 1] - y) ** 2
        # Of what is about there the foremost.
        about = away <= max(float(away.min()), 1.0)
        found = points[about][np.argmax(points[about, 2])].copy()
        found[0] = x
        return np.asarray(found)

    def near(self, point: Array, fine: float = 0.5) -> Spot:
        """The place nearest to a point: its round and stitch, in halves, or in tenths (``fine`` = 0.1)."""
        rows = bool(self.stand.spots.in_rows[self.part])
        rings, (threads, begins) = (
            (self.levels, self._threads) if fine >= 0.5 else (self._with_poles, self._threads_with_poles)
        )
        i = int(np.minimum.reduceat(_away(threads, point)[0], begins).argmin())
        level, (best, index), many = float(rings[i][0]), _on(rings[i][1], point, rows), len(rings[i][1])
        if fine >= 0.5:
            # Mirrored things stay mirrored: steps are counted from the middle of the front.
            middle = self.middle(level)
            off = round((index + 1.0 - middle) / fine) * fine
            return Spot(self.name, level, round(middle + off, 3))
        for k in (i - 1, i):
            if not 0 <= k < len(rings) - 1 or self._turned(rings[k][0]) != self._turned(rings[k + 1][0]):
                continue  # between rounds that run against each other no stitch stands on its number
            one, other = rings[k][1], _alike(rings[k + 1][1], len(rings[k][1]))
            if len(one) == 1:
                one, other = np.repeat(one, len(rings[k + 1][1]), 0), rings[k + 1][1]
            tenths = np.arange(1, 10)[:, None, None] / 10
            between = (1 - tenths) * one + tenths * other
            away, share = _away(_threads(between, rows), point)
            s = int(away.min(1).argmin())
            at = int(away[s].argmin())
            if away[s, at] < best:
                best, level, index = float(away[s, at]), rings[k][0] + (s + 1) / 10, at + float(share[s, at])
                many = len(one)
        stitch = round(index + 1.0, 1)
        return Spot(self.name, round(level, 1), stitch if rows or stitch < many + 1 else 1.0)

    @cached_property
    def _threads(self) -> tuple[Threads, Array]:
        return _all_threads([ring for _, ring in self.levels], bool(self.stand.spots.in_rows[self.part]))

    @cached_property
    def _threads_with_poles(self) -> tuple[Threads, Array]:
        return _all_threads([ring for _, ring in self._with_poles], bool(self.stand.spots.in_rows[self.part]))

    @cached_property
    def _with_poles(self) -> list[tuple[int, Array]]:
        """Its rounds, with the ring's root before them and the tip behind, where it has them."""
        graph, x = self.stand.spots.built.graph, self.stand.x
        p = graph.parts[self.part]
        made = list(self.levels)
        for kind, at, number in ((ROOT, 0, self.low - 1), (TIP, -1, self.high + 1)):
            nodes = p.start + np.flatnonzero(graph.peculiarity[p.start : p.end] == kind)
            if len(nodes) and (self.low, self.high)[at] == self._ends[at]:
                made.insert(0 if at == 0 else len(made), (number, x[nodes[[at]]]))
        return made

    def in_round(self, level: float, direction: Array) -> float:
        """The stitch of a round that looks in ``direction``, in half stitches from the middle of the front."""
        number = min(max(int(level), self.low), self.high)
        ring = next((p for n, p in self.levels if n == number), self.levels[-1][1])
        reach = ring.mean(0) + 100.0 * direction
        index = _on(ring, reach, bool(self.stand.spots.in_rows[self.part]))[1] + 1.0
        middle = self.middle(number)
        n = len(ring)
        off = (index - middle + n / 2) % n - n / 2
        return round(middle + round(2.0 * off) / 2.0, 3)


def _on(ring: Array, point: Array, rows: bool) -> tuple[float, float]:
    """How near a point comes to a ring of stitches (n, 3), squared, and at which position from 0."""
    off, share = _away(_threads(ring, rows), point)
    k = int(off.argmin())
    return float(off[k]), k + float(share[k])


Threads = tuple[Array, Array, Array]
"""From each stitch of rings (…, n, 3) to the next: where it starts and its way, (…, m, 3), and how long that is, squared."""


def _threads(rings: Array, rows: bool) -> Threads:
    """The threads of rings of one size; of one stitch its place."""
    n = rings.shape[-2]
    after = rings if n == 1 else rings[..., 1:, :]
    if n > 2 and not rows:
        after = np.concatenate([after, rings[..., :1, :]], -2)
    start = rings[..., : after.shape[-2], :]
    way = after - start
    return start, way, np.maximum(_dot(way, way), 1e-12)


def _all_threads(rings: list[Array], rows: bool) -> tuple[Threads, Array]:
    """Those of rings of any size one behind the other, and where each ring's begin."""
    each = [_threads(ring, rows) for ring in rings]
    begins = np.cumsum([0, *(len(one[0]) for one in each[:-1])])
    start, way, long = (np.concatenate(some) for some in zip(*each))
    return (start, way, long), begins


def _away(threads: Threads, point: Array) -> tuple[Array, Array]:
    """How far a point is from every thread, squared, and at which share of its way it is nearest."""
    start, way, long = threads
    share = np.minimum(np.maximum(_dot(point - start, way) / long, 0.0), 1.0)
    off = start + share[..., None] * way - point
    return _dot(off, off), share


def _dot(a: Array, b: Array) -> Array:
    """The products of vectors (…, 3); sums along so short an axis would cost more than all else here."""
    each = a * b
    return np.asarray(each[..., 0] + each[..., 1] + each[..., 2])


def _alike(ring: Array, n: int) -> Array:
    """A ring with ``n`` points, as even as its own."""
    m = len(ring)
    at = np.arange(n) * m / n
    low = at.astype(int)
    share = (at - low)[:, None]
    return np.asarray((1 - share) * ring[low % m] + share * ring[(low + 1) % m])


def numbers_of(spots: Spots, part: int) -> tuple[int, int]:
    """The numbers of the first and the last round of a part."""
    mine = spots.rounds_of(part)
    return (min(mine), max(mine)) if mine else (1, 1)


def neck(spots: Spots, part: int) -> int | None:
    """The number of the round that is the neck of a part that is head and body in one; None where it has none."""
    low, high = numbers_of(spots, part)
    counts = [(n, len(spots.stitches(k))) for n in range(low, high + 1) if (k := spots.round_at(part, n)) is not None]
    # Behind a tip that was closed and a round that nobody increases to another limb begins, and no body.
    end = next(
        (i for i in range(1, len(counts)) if counts[i - 1][1] <= TIP_OF and counts[i][1] > 3 * counts[i - 1][1]), None
    )
    counts = counts[:end]
    best: tuple[float, int] | None = None
    for i, (n, c) in enumerate(counts):
        before, after = max((c for _, c in counts[:i]), default=0), max((c for _, c in counts[i + 1 :]), default=0)
        depth = c / max(min(before, after), 1)
        if depth <= NECK and min(before, after) >= 12 and (best is None or depth < best[0]):
            best = (depth, n)
    return best[1] if best else None

"""Room: which places on a toy's parts are taken by seams, so that a part whose place is not said finds a free one."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Final

import numpy as np

from tambour.core.check import Array
from tambour.crochet.finish import sewing
from tambour.crochet.finish.joining import SAME_SIDE
from tambour.crochet.language.finishes import Placed, Spot
from tambour.crochet.places.stand import Host, Stand
from tambour.crochet.places.usual import Way

_APART: Final = 1.5
"""Two seams that come nearer to each other than this, in stitches, are in each other's way."""
_STEP: Final = 0.12
"""A part is moved aside by so much of half its host's width at a time."""
_MIDDLE: Final = 0.15
"""What is no further from the middle, of half its host's width, is in the middle."""
_MOST: Final = 9
"""How often at the most."""
_LAYERS: Final = frozenset(
    ("face", "belly", "inner", "collar", "hat", "worn", "spot", "cheek", "eye", "muzzle", "nose")
)
"""Kinds of parts that others may lie on, or in: only their like is in their way."""


@dataclass(frozen=True, eq=False)
class Seam:
    """Where a part is sewn: points (K, 3) of its line; the fabric's normal; how far they are from their middle; whether they run round."""

    kind: str
    host: str
    points: Array
    normal: Array
    wide: float
    ring: bool


class Room:
    """The seams on a toy's parts."""

    def __init__(self, stand: Stand) -> None:
        self._stand = stand
        self._taken: list[Seam] = []

    def seams(self, records: list[Placed], kind: str) -> list[Seam]:
        """Where ``records`` would be sewn."""
        spots, made = self._stand.spots, []
        for record in records:
            end = sewing.end_of(spots.built, spots, record)
            frame = self._stand.frame(record.spot)
            own = self._stand.nodes(spots.parts[record.part])
            points = sewing.outline(spots.layout, own, record, end, frame)
            wide = float(np.sqrt(((points - points.mean(0)) ** 2).sum(1).max()))
            made.append(Seam(kind, record.spot.part, points, frame.normals[0], wide, end.ring))
        return made

    def free(self, seams: list[Seam]) -> bool:
        """Whether seams are in nobody's way, nor in each other's."""
        return not any(_meet(one, other) for k, one in enumerate(seams) for other in (*self._taken, *seams[:k]))

    def take(self, seams: list[Seam]) -> None:
        """These places are taken now."""
        self._taken += seams


_STREWN, _STREWN_TO, _GOLDEN = 6, 0.94, 0.618034
"""So many spots are strewn over as much of a part's stitches, each so much of a turn after the one before."""
_STREWN_ON, _SIDE_OF, _ENDS = 3, math.radians(58.0), 0.2
"""So many are strewn over one side of it, so far round it to both sides, and so much of its rounds from both its ends."""
_UP, _ALONG = np.array([0.0, 1.0, 0.0]), np.array([0.0, 0.0, 1.0])


def _meet(one: Seam, other: Seam) -> bool:
    if one.host != other.host or (one.kind != other.kind and {one.kind, other.kind} & _LAYERS):
        return False
    off = (one.points[:, None] - other.points) ** 2
    apart = math.sqrt(float((off[..., 0] + off[..., 1] + off[..., 2]).min()))  # summed so, since the axis is so short
    if apart < _APART:
        return True
    middles = float(np.sqrt(((one.points.mean(0) - other.points.mean(0)) ** 2).sum()))
    inside = (other.ring and middles < other.wide) or (one.ring and middles < one.wide)
    return inside and float(one.normal @ other.normal) > SAME_SIDE


def strewn(kind: str, many: int, host: Host, before: int = 0, total: int = 0) -> list[Spot]:
    """Places for many spots all over a part, as far as it widens: as evenly as a sunflower's seeds; none for a few, and for other things.

    before, total : how many of other sorts are strewn there before these, and how many there are of all (0: these alone); sorts are mixed
    """
    total = max(total, many)
    if kind != "spot" or total < _STREWN or host.stand.spots.in_rows[host.part]:
        return []
    counts = [len(ring) for _, ring in host.levels]
    widest = max(k for k, c in enumerate(counts) if c == max(counts))
    rounds = [float(n) for n, _ in host.levels[: widest + 1]]
    behind = np.cumsum(counts[: widest + 1])
    made = []
    order = range(total) if total == many else sorted(range(total), key=lambda i: (i * _GOLDEN) % 1.0)
    for k in order[before : before + many]:
        share = (k + 0.5) / total * _STREWN_TO * float(behind[-1])
        n = int(np.searchsorted(behind, share))
        turn = (k * _GOLDEN + 0.25) % 1.0
        made.append(Spot(host.name, rounds[n], round(1.0 + turn * counts[n], 1)))
    return made


def strewn_on(kind: str, many: int, host: Host, way: tuple[float, float, float]) -> list[Spot]:
    """Places for many spots on one side of a part, which looks ``way``: as evenly as seeds, off its edges and its ends; none for a few, and for
    other things, as of "Scatter the five patches over the back".
    """
    if kind != "spot" or many < _STREWN_ON or host.stand.spots.in_rows[host.part]:
        return []
    ahead, wide = np.array(way), np.cross(np.array(way), _UP if not way[1] else _ALONG)
    made = []
    for k in range(many):
        high, turn = (k + 0.5) / many, ((k * _GOLDEN + 0.5) % 1.0 - 0.5) * 2.0 * _SIDE_OF
        level = host.low + (_ENDS + (1.0 - 2.0 * _ENDS) * high) * (host.high - host.low)
        about = math.cos(turn) * ahead + math.sin(turn) * wide
        made.append(Spot(host.name, round(level), host.in_round(round(level), about)))
    return made


def spread(spots: list[Spot], host: Host, wide: float) -> list[Spot]:
    """``spots`` of copies, those at one place ("four on each side") side by side: along the part, else around it.

    wide : how wide a copy is, in stitches
    """
    found = list(spots)
    for place in dict.fromkeys((s.round, s.stitch) for s in spots if s.stitch is not None):
        own = [k for k, s in enumerate(spots) if (s.round, s.stitch) == place]
        step, last = wide + _APART, len(own) - 1
        along = last * step <= host.high - host.low
        first = place[0] - 0.5 * last * step
        first = min(max(first, host.low), host.high - last * step)
        for i, k in enumerate(own if last else ()):
            off = (i - 0.5 * last) * step
            at = {"round": round(first + i * step)} if along else {"stitch": (place[1] or 1.0) + off}
            found[k] = replace(spots[k], **at)
    return found


def aside(ways: list[Way]) -> Iterator[list[Way]]:
    """Ways farther and farther from the ``ways`` of a part: of a pair outwards, down or up, of a single one to either side, up or down."""
    yield ways
    for k in range(1, _MOST + 1):
        off = k * _STEP
        if len(ways) == 2:
            yield [replace(w, at=(w.at[0] + math.copysign(off, w.at[0]), w.at[1], w.at[2])) for w in ways]
            for dy in (-off, off):
                yield [replace(w, at=(w.at[0], w.at[1] + dy, w.at[2])) for w in ways]
        elif len(ways) == 4:  # at the corners of a body
            corners = [
                (w.at[0] + math.copysign(off, w.at[0]), w.at[1], w.at[2] + math.copysign(off, w.at[2])) for w in ways
            ]
            yield [replace(w, at=at) for w, at in zip(ways, corners)]
        elif len(ways) == 1:
            x, y, z = ways[0].at
            out = math.copysign(off, x) if x else off
            beside = ((out, 0.0, 0.0), (-out, 0.0, 0.0))
            along = ((0.0, -off, 0.0), (0.0, off, 0.0), (0.0, 0.0, off), (0.0, 0.0, -off))
            # What is in the middle stays there as long as it can.
            for dx, dy, dz in (*along, *beside) if abs(x) < _MIDDLE else (*beside, *along):
                yield [replace(ways[0], at=(x + dx, y + dy, z + dz))]

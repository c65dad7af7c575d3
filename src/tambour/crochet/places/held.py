"""Held: how a part is held where it is sewn: pinched or round, leaning how far and which way, and by which of its rounds."""

from __future__ import annotations

import math
import re
from dataclasses import replace
from typing import Final

import numpy as np

from tambour.core.check import Array
from tambour.core.graph import BLO, FLO
from tambour.crochet.finish import sewing
from tambour.crochet.finish.capped import rim_on
from tambour.crochet.finish.joining import BODY, GATHER
from tambour.crochet.finish.limp import FEW, strings
from tambour.crochet.finish.placing import level
from tambour.crochet.language.finishes import Placed, Spot
from tambour.crochet.places.hear import Copy, Put
from tambour.crochet.places.names import one
from tambour.crochet.places.snouts import Snouts
from tambour.crochet.places.stand import Host
from tambour.crochet.places.usual import SPREAD, Way

_STEP: Final = 5.0
"""Angles are rounded to so many degrees."""
_ALONG_OUT: Final = 0.85
"""A seam that would run so nearly out of the fabric, as a cosine, runs level."""
_STEADY: Final = 0.2
"""A leg that would point farther back than this is held by its fabric alone: nobody sits so."""
_MOST: Final = 90.0
"""What hangs straight down lies along the fabric."""
_STILL: Final = 10.0
"""A part that leans less than this stands straight out."""
_WIDE: Final = 1.15
"""An open end wider than this, as a share of what it is put over, is sewn by a narrower round."""
_LOWEST: Final = 0.7
"""An end is below that lies so far under the middle, in halves of the height."""
_ROUND: Final = 1.5
"""How much more the way out of an ellipsoid counts than that of the fabric before it is stuffed."""
LAID: Final = frozenset(
    ("belly", "spot", "face", "eye", "cheek", "muzzle", "nose", "door", "bow", "inner", "bumper", "beard")
)
"""Kinds of pieces that lie on the fabric, sewn all round, where they are worked in rows."""
BESIDE: Final = frozenset(("elephant", "monkey", "koala", "mouse", "chimp", "sloth", "sheep", "lamb", "cow", "giraffe"))
"""Toys, by their titles, whose ears are at the sides of their heads."""
_LOW, _ON_TOP = 45.0, 0.8
"""An ear that leans by so many degrees or more, where fabric looks upwards by so much, as a cosine, or more, points where it is said to."""
_WIDE_ONES: Final = frozenset(("muzzle", "nose", "beak"))
"""Kinds of things that are wider than high on a face, where they are ovals."""
_OVAL: Final = 1.25
"""What is so many times as long as wide is an oval."""
_FIRST_OF: Final = re.compile(
    r"\b(?:first|1st) (?:rounds?|rnds?) of (?:the |each |both |every |left |right |two )*([a-z]+)\b"
)
"""The end that a part was begun at, where that is sewn on: "whipstitch the first round of each wing to the body"."""
_RING: Final = 4
"""So many stitches, or more, make a round that something is sewn by."""
_AT_SHOULDERS: Final = frozenset(("arm", "wing", "fin"))
"""Kinds of limbs that are sewn to the sides of a body that stands."""
_STANDS: Final = 0.7
"""A body stands whose axis is so upright, as a cosine."""
_NARROWS: Final = 0.75
"""A body narrows to its neck that ends there with less than this share of its widest round."""
_CAP: Final = 0.75
"""The rim of a cap has this share of its widest round, or more."""
_ROUNDS, _HEAD = 3, 18
"""So many rounds that are as wide, and so many stitches, make a cap of hair."""
_PINCHED: Final = frozenset(("ear", "wing", "fin", "fluke", "leaf"))
"""Kinds of open pieces that stand on a line, where they are not stuffed."""


class Holder(Snouts):
    """Knows how parts are held where they are put."""

    def _flat(self, copy: Copy, way: Way) -> bool:
        """Whether an end is pinched."""
        name = copy[0].copy(copy[1])
        edge = self.work.open(name)
        if "inner" in copy[0].words:  # it lies on what it is the inner side of
            return bool(self.work.spots.in_rows[self.work.spots.parts[name]])
        if self.work.spots.in_rows[self.work.spots.parts[name]]:
            if copy[0].kind == "tuft" and "mane" in copy[0].words and self._strip(copy):
                return True  # a band along the nape
            return copy[0].kind in LAID or (not copy[0].kind and copy[0].name in self.work.made.unstuffed)
        if copy[0].name in self.work.made.unstuffed and copy[0].kind in _PINCHED:
            return edge >= 4
        if way.flat is None:
            levels = self.work.host((copy[0], 1)).levels
            return (
                edge >= 4
                and copy[0].kind not in ("muzzle", "eye", "cheek", "belly", "spot", "nose", "beak")
                and len(levels) >= max(3.0, 0.3 * edge)
            )
        return way.flat and edge >= 4

    def _placed(self, put: Put, copy: Copy, spot: Spot, way: Way, host: Host) -> Placed:
        """The record of a copy at its spot, turned as its way says."""
        at = put.where
        flat = self._flat(copy, way) or (bool(at.through) and not self._shut(copy))
        if at.rounds is not None and not flat and way.flat is None and abs(at.rounds[1] - at.rounds[0]) >= 3:
            flat = self.work.open(copy[0].copy(copy[1])) >= 4
        frame = self.stand.frame(spot)
        n, along, up = frame.normals[0], frame.along[0], frame.up[0]
        end = bool(len(self.work.spots.rim(host.part))) and spot.round >= host.high - 1
        if put.kind == "fluke" and end and abs(float(host.axis[1])) < 0.5:
            # The open end of what lies will be sewn shut, flat from side to side: it looks backwards.
            n, along, up = np.array([0.0, 0.0, -1.0]), np.array([-1.0, 0.0, 0.0]), np.array([0.0, 1.0, 0.0])
        elif put.kind in ("leg", "foot") and spot.round == self._shut_below(host):
            n, along, up = np.array([0.0, -1.0, 0.0]), np.array([1.0, 0.0, 0.0]), np.array([0.0, 0.0, 1.0])
            way = replace(way, axis=(0.0, -1.0, 0.0))
        elif spot.stitch is not None and not self.work.spots.in_rows[host.part]:
            # Before it is stuffed the top of a ball is flat: where it will be round its fabric leans more.
            middle, half = host.box
            round_ = (frame.points[0] - middle) / half**2
            round_ = round_ / max(float(np.sqrt(round_ @ round_)), 1e-9)
            mean = (n + _ROUND * round_)[None]
            normals = mean / np.sqrt((mean**2).sum())
            turns = level(normals, self.stand.upright[[host.part]])
            n, along, up = normals[0], turns[0][0], turns[1][0]
        tilt = towards = across = 0.0
        if way.axis is not None:
            axis = np.array(way.axis) / math.sqrt(sum(c * c for c in way.axis))
            tilt = math.degrees(math.acos(max(-1.0, min(1.0, float(axis @ n)))))
            towards = math.degrees(math.atan2(-float(axis @ along), float(axis @ up))) % 360.0
        if at.angle is not None and at.rounds is not None:
            tilt = at.angle
        tilt = min(_MOST if re.search(r"\bstraight(?: down)?\b", at.text) else 80.0, _STEP * round(tilt / _STEP))
        if tilt < _STILL:
            tilt = towards = 0.0
        standing = copy[0].kind in _PINCHED and bool(
            self.work.spots.in_rows[self.work.spots.parts[copy[0].copy(copy[1])]]
        )
        closed = self._shut(copy)
        if flat or standing or closed:
            line = np.array(way.line)
            rows = bool(self.work.spots.in_rows[self.work.spots.parts[copy[0].copy(copy[1])]])
            upright = rows and copy[0].kind in LAID  # a door's rows lie level, over however many rounds it reaches
            if at.rounds is not None and abs(at.rounds[1] - at.rounds[0]) >= 3 and not upright:
                line = host.axis - float(host.axis @ n) * n  # from round to round, also where they lie about the top
            if (
                at.rounds is not None
                and at.rounds[2]
                and at.rounds[1] - at.rounds[0] <= 1
                and copy[0].kind in ("arm", "leg", "wing")
            ) or at.through:
                line = np.cross(n, host.axis)
            if abs(float(line @ n)) > _ALONG_OUT * math.sqrt(float(line @ line)):
                line = along  # what is sewn to the front runs across it
            a, b = float(line @ along), float(line @ up)
            across = _STEP * round(math.degrees(math.atan2(b, a)) / _STEP) if a * a + b * b > 1e-6 else 0.0
            across = across - 180.0 if across > 90.0 else across + 180.0 if across <= -90.0 else across
            if across == 90.0 and float(n[0]) > 0.05:
                across = -90.0
            if closed < 0 and copy[0].kind in ("leg", "foot"):
                across += -180.0 if across > 0.0 else 180.0  # toes look ahead, or up
        else:
            across = way.turn if abs(way.turn) == 180.0 and tilt else 0.0
            wide = put.kind in _WIDE_ONES or (put.kind == "eye" and copy[0].single)
            if wide and self._lengthwise(copy):
                across = 90.0
        name = copy[0].copy(copy[1])
        towards = _STEP * round(towards / _STEP) % 360.0
        record = Placed(name, spot, flat, across, tilt, towards, None, at.through, put.span)
        ahead = way.axis is not None and way.axis[2] > -_STEADY
        if put.kind in ("leg", "foot") and tilt and ahead and at.angle is None and spot.stitch is not None:
            record = replace(record, points=way.axis)  # which way a toy sits is not left to how its stuffing bulges
        upwards = float(n @ self.stand.upright[host.part])
        if put.kind == "ear" and tilt >= _LOW and upwards > _ON_TOP and way.axis is not None and at.angle is None:
            record = replace(record, points=way.axis)  # which way is up on the top of a head is left to a trifle
        if put.kind == "wing" and self.butterfly and (narrow := self._narrow(copy)):
            return replace(record, flat=False, across=90.0, by=narrow)  # two alike are mirrored
        if (begun := self._by_beginning(put, copy) or self._above_strands(copy)) is not None:
            return replace(record, by=begun)
        return replace(record, by=self._by(record, host, n)) if not flat else record

    def _by_beginning(self, put: Put, copy: Copy) -> float | None:
        """The first round of a part worked in rounds, where that is what is said to be sewn on."""
        said = _FIRST_OF.search(put.where.text)
        if said is None or one(said[1]) not in copy[0].words:
            return None
        part = self.work.spots.parts[copy[0].copy(copy[1])]
        numbers = [n for n, ring in self.work.host(copy).levels if len(ring) >= _RING]
        return float(numbers[0]) if numbers and not self.work.spots.in_rows[part] else None

    def _above_strands(self, copy: Copy) -> float | None:
        """The last whole round of a cap of hair whose rim is strands, which hang from there; None of all else."""
        spots, part = self.work.spots, self.work.spots.parts[copy[0].copy(copy[1])]
        if not copy[0].hair or spots.in_rows[part]:
            return None
        graph = self.work.built.graph
        hung = [base for _, base in strings(graph) if graph.part[base] == part]
        wide = max((len(ring) for _, ring in self.work.host(copy).levels), default=0)
        whole = [n for n, ring in self.work.host(copy).levels if len(ring) >= _CAP * wide]
        round_ = len(whole) >= _ROUNDS and wide >= _HEAD  # and no beard, whose strands hang from a chain
        return (
            float(whole[-1])
            if round_ and len(hung) > FEW and self.work.open(copy[0].copy(copy[1])) < _CAP * wide
            else None
        )

    def _shut_below(self, host: Host) -> float | None:
        """The round of a stuffed body's lower end, where that stays open and is sewn shut from side to side; None else."""
        spots, part = self.work.spots, host.part
        section = self.work.built.pattern.parts[self.work.built.parts[part].section]
        if spots.in_rows[part] or section.stuffing == 0.0 or not BODY.search(section.name.lower()):
            return None
        for edge, number in ((spots.begun(part), host.low), (spots.rim(part), host.high)):
            low = float(host.box[0][1] - _LOWEST * host.box[1][1])
            if len(edge) >= 2 * GATHER and float(self.stand.x[edge][:, 1].mean()) < low:
                return float(number)
        return None

    def _shut(self, copy: Copy) -> int:
        """Whether a part's end is a line, closed through both layers: 1, or -1 where that runs to the part's right; else 0."""
        spots, index = self.work.spots, self.work.spots.parts[copy[0].copy(copy[1])]
        nodes = np.zeros(0, int) if spots.in_rows[index] else spots.stitches(spots.last(index))
        if not sewing.shut(spots, nodes):
            return 0
        return -1 if spots.layout[nodes[-1], 0] < spots.layout[nodes[0], 0] else 1

    def _lengthwise(self, copy: Copy) -> bool:
        """Whether a part is an oval, which is worked from a chain that runs from front to back."""
        index = self.work.spots.parts[copy[0].copy(copy[1])]
        size = np.ptp(self.work.spots.layout[self.stand.nodes(index)], axis=0)
        return bool(size[2] > _OVAL * size[0])

    @property
    def butterfly(self) -> bool:
        """Whether the toy's wings are spread beside it."""
        return bool(SPREAD & {one(w) for w in re.findall(r"[^\W\d_]+", self.work.text[:200])})

    def _narrow(self, copy: Copy) -> float | None:
        """The first round of a piece that begins much narrower than it becomes."""
        levels = self.work.host((copy[0], 1)).levels
        widest = max((len(p) for _, p in levels), default=0)
        return float(levels[0][0]) if levels and 2 * len(levels[0][1]) < widest else None

    def _by(self, placed: Placed, host: Host, n: Array) -> float | None:
        """The round that a wide open part is sewn by, where its rim would hang free about what it is put on."""
        edge = self.work.open(placed.part)
        if not edge:
            return None
        onto = self.work.spots.opening(host.part, placed.spot.round) if placed.spot.stitch is None else ()
        if len(onto) and (left := self._loops(placed.part, len(onto))) is not None:
            return left
        _, half = host.box
        across = float(np.sqrt(max(((half**2) * (1.0 - np.abs(n))).sum(), 0.25)))
        if placed.spot.stitch is None and (rim := self.work.open(host.name)):
            across = min(across, rim / (2.0 * math.pi) / 0.9)  # a cap over an open end is sewn where it is as wide
        if edge / (2.0 * math.pi) <= _WIDE * across:
            return None
        spots, part = self.work.spots, self.work.spots.parts[placed.part]
        made = next(p for p in self.work.parts if placed.part.rsplit(".", 1)[0] in (p.name,) or placed.part == p.name)
        empty = made.worn or made.name in self.work.made.unstuffed
        if len(rim_on(spots.built, spots, placed, sewing.end_of(spots.built, spots, placed), empty)):
            return None  # a loose cap comes down over all of it
        own = self.work.host((made, 1))
        fits = [num for num, ring in own.levels if len(ring) / (2.0 * math.pi) <= 0.9 * across]
        fits = [
            num for num in fits if spots.round_at(part, num) is not None
        ]  # copies may differ where rounds were not read
        return float(max(fits)) if fits else None

    def _loops(self, part: str, rim: int) -> float | None:
        """The round of a part whose unworked loops are sewn to an end of ``rim`` stitches: as many of them as there are."""
        spots, graph = self.work.spots, self.work.built.graph
        own = spots.parts[part]
        for number in [n for r, n in zip(spots.built.rounds, spots.numbers) if r.part == own]:
            k, below = spots.round_at(own, number), spots.round_at(own, number - 1)
            if k is None or below is None or len(spots.stitches(below)) != rim:
                continue
            if np.isin(graph.peculiarity[spots.stitches(k)], (BLO, FLO)).all():
                return float(number - 1)
        return None

    def _right_side_ahead(self, copy: Copy, record: Placed) -> Placed:
        """An ear worked in rows, turned so that its right side, which bears an inner ear, looks ahead."""
        host = self.work.host(copy)
        if not self.work.spots.in_rows[host.part]:
            return record
        turned = replace(record, across=(record.across + 360.0) % 360.0 - 180.0)

        def looks(one: Placed) -> float:
            self.stand.place(one)
            placed = self.work.host(copy)
            level = float(placed.levels[len(placed.levels) // 2][0])
            return float(self.stand.frame(Spot(placed.name, level, placed.middle(level))).normals[0][2])

        return max((record, turned), key=looks)

    def _brow(self, put: Put, host: Host) -> float | None:
        """The round of patches about the eyes on a head that looks ahead: where its eyes would be, and not on its snout; None for all else."""
        snout = put.kind == "eye" and len(put.copies) == 2 and not put.where.beside and self._ahead(host)
        return self._behind_snout(host) if snout and not self._begins_at_face(host) else None

    def _on_wall(self, copy: Copy, host: Host, point: Array) -> Array:
        """A place of a patch that lies on the front of a standing body, moved up or down until it lies on its wall, and reaches neither round
        its neck nor under it; a patch that is higher lies in the middle."""
        rows, upright = self.work.spots.in_rows, abs(float(host.axis[1])) >= _STANDS
        if copy[0].kind != "belly" or not upright or rows[host.part]:
            return point
        wide = max(len(ring) for _, ring in host.levels)
        wall = [float(ring[:, 1].mean()) for _, ring in host.levels if len(ring) >= _NARROWS * wide]
        own = self.work.host(copy)
        half = 0.5 * len(own.levels) if rows[own.part] else max(len(ring) for _, ring in own.levels) / (2.0 * math.pi)
        half = min(half, 0.5 * (max(wall) - min(wall)))
        high = min(max(float(point[1]), min(wall) + half), max(wall) - half)
        return host.ahead(float(point[0]), high)

    def _shoulder(self, put: Put, host: Host, way: Way) -> float | None:
        """The round at which arms and wings are as high on a standing body as on a ball, though it narrows to its neck like a pear, whose
        nearest fabric is far below; None for other parts, and on other bodies."""
        if put.kind not in _AT_SHOULDERS or len(put.copies) > 2 or abs(float(host.axis[1])) < _STANDS:
            return None
        upper = host.levels if host.levels[-1][1][:, 1].mean() > host.levels[0][1][:, 1].mean() else host.levels[::-1]
        wide = max(len(ring) for _, ring in host.levels)
        if self.work.spots.in_rows[host.part] or len(upper[-1][1]) > _NARROWS * wide or way.at[1] <= 0.0:
            return None
        height = float(host.towards(way.direction)[1])
        return float(min(host.levels, key=lambda level: abs(float(level[1][:, 1].mean()) - height))[0])

    def _strip(self, copy: Copy) -> bool:
        """Whether a piece is worked in a few long rows."""
        levels = self.work.host(copy).levels
        return bool(self.work.spots.in_rows[self.work.spots.parts[copy[0].copy(copy[1])]]) and len(
            levels[0][1]
        ) > 3 * len(levels)

    @staticmethod
    def _at_end(put: Put) -> bool:
        """Whether no more is told of legs than that they are at the bottom."""
        at = put.where
        return at.words <= {"bottom", "flat"} and at.rounds is None and not at.beside

    def _side_by_side(self, host: Host, level: float, off: float, half: float) -> tuple[float, float]:
        """The round nearest to ``level``, and the stitches from its middle there, where two things ``half`` wide do not overlap."""
        share = min(off / max(host.count(level), 1), 0.25)
        tried: list[tuple[float, float, float]] = []
        for number in sorted((float(n) for n, _ in host.levels), key=lambda n: abs(n - level)):
            middle, aside = host.middle(number), share * host.count(number)
            one, other = (
                self.stand.frame(host.within(Spot(host.name, number, middle + s * aside))).points[0]
                for s in (-1.0, 1.0)
            )
            apart = float(np.sqrt(((one - other) ** 2).sum()))
            if apart >= 2.0 * half:
                return number, off if number == level else aside
            tried.append((apart, number, aside))
        _, number, aside = max(tried)
        return number, aside

    @staticmethod
    def _wider(host: Host, level: float, least: float) -> float | None:
        """The nearest round of at least so many stitches, or as many as it has, where the one at ``level`` is narrower; else None."""
        least = min(least, max(len(ring) for _, ring in host.levels))
        if host.count(level) >= least:
            return None
        return min((float(n) for n, ring in host.levels if len(ring) >= least), key=lambda n: abs(n - level))

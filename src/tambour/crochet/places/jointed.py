"""Jointed: heads, bodies and necks, and what is sewn rim to rim: how the trunk of a toy is put together."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

import numpy as np

from tambour.core.check import Array
from tambour.crochet.finish import sewing
from tambour.crochet.finish.capped import lid_on
from tambour.crochet.language.finishes import Placed, Spot
from tambour.crochet.places.hear import Copy, Put
from tambour.crochet.places.held import Holder
from tambour.crochet.places.hosts import RIM, RIM_OFF
from tambour.crochet.places.stand import Host
from tambour.crochet.places.usual import Way

_UNDER: Final = np.array([0.0, -0.9, -0.45])
"""Where the body is on a head that lies: under it, behind its middle."""
_DOWN: Final = 0.85
"""Fabric looks down so far, as a cosine."""
_ROLL: Final = 5.0
"""By how many degrees at a time a head is turned about its nose until its face is above."""
_RIM_SHARE: Final = 0.1
"""A rim that is wider by this share is eased in."""
_ON_NECK: Final = Way((0.0, 0.9, 0.4), (0.0, -0.35, 1.0), flat=False)
"""A head on the neck of what lies: its back on the neck, its nose ahead."""
_ON_FRONT: Final = np.array([0.0, 0.7, 0.72])
"""Where such a head is on a body without a neck."""
_BEHIND_EYES: Final = 4.0
"""So many rounds behind the eyes are the ears of what looks ahead, or more."""
_FULL: Final = 0.85
"""Where a head has so much of its widest round its snout and its brow are past."""
_NECK_OF, _THINNER = 0.2, 0.6
"""A neck is so much of a body's rounds, or more, with no more than this share of its widest; its trunk has more."""
_TRUNK = 0.2, 0.6
"""A trunk has so much of a body's rounds, and no more than that where a neck or a tail is worked in one with it."""
_BESIDE_BELLY: Final = -0.15
"""How high the arms of a ball with a face are."""


class Jointer(Holder):
    """Puts a toy's trunk together."""

    def _ahead_on_neck(self, put: Put, neck: Copy) -> Placed:
        """A head that looks ahead, on the neck of what lies, or on its front where it has none; its face above."""
        host, copy, way = self.work.host(neck), put.copies[0], _ON_NECK
        pole = None if self._lies(neck) else host.pole(way.direction, 0.3)
        if pole is None and self._long_neck(host):
            pole = host.pole(np.array([0.0, 0.0, 1.0]))  # its end, and not the back of it
        far = pole or host.near(host.towards(_ON_FRONT if pole is None else way.direction))
        spot = replace(far, span=put.span)
        record = self._face_up(self._placed(put, copy, spot, way, host), copy)
        if pole is not None:
            record = replace(record, points=way.axis)  # which way it looks is not left to how its neck leans
        self.stand.place(record)
        return record

    @staticmethod
    def _long_neck(host: Host) -> bool:
        """Whether what lies begins with a neck that is much narrower than the body behind it, over a good part of its rounds."""
        counts = [len(ring) for _, ring in host.levels]
        first = counts[: max(2, int(_NECK_OF * len(counts)))]
        return max(first) <= _THINNER * max(counts) and counts.index(max(counts)) >= len(first)

    def _trunk(self, host: Host) -> Host:
        """Of a body that is worked in one with a neck or a tail the rounds that are as wide as its trunk, which bears its legs."""
        counts, numbers = [len(ring) for _, ring in host.levels], [n for n, _ in host.levels]
        widest = counts.index(max(counts))
        wide = [c >= _THINNER * counts[widest] for c in counts]
        low = next((k + 1 for k in range(widest, -1, -1) if not wide[k]), 0)
        high = next((k - 1 for k in range(widest, len(wide)) if not wide[k]), len(wide) - 1)
        if not _TRUNK[0] * len(counts) <= high - low + 1 < _TRUNK[1] * len(counts):
            return host
        return self.stand.host(host.name, numbers[low], numbers[high])

    def _face_up(self, record: Placed, copy: Copy) -> Placed:
        """A head that looks ahead, turned about its nose so that the front of its rounds, where its face is, is above."""

        def rises(across: float) -> float:
            self.stand.place(replace(record, across=across))
            host = self.work.host(copy)
            number, ring = host.levels[len(host.levels) // 2]
            k, share = divmod(host.middle(number) - 1.0, 1.0)
            one, other = ring[int(k) % len(ring)], ring[(int(k) + 1) % len(ring)]
            front = (1.0 - share) * one + share * other - ring.mean(0)
            return float(front[1] / max(float(np.sqrt(front @ front)), 1e-9))

        about = max(np.arange(-180.0, 180.0, 6.0 * _ROLL).tolist(), key=rises)
        turns = [about + k * _ROLL for k in range(-9, 10)]
        return replace(record, across=(max(turns, key=rises) + 180.0) % 360.0 - 180.0)

    def _behind_face(self, put: Put, host: Host, near: Spot, direction: Array, half: float) -> Spot:
        """Where ears and horns are on what looks ahead: behind its eyes, whose rounds may be said, and behind its snout."""
        eyes, level = self.known.get("eye"), near.round
        if eyes is not None and eyes[0] == host.name and float(host.axis[2]) < -0.7:
            clear = max(_BEHIND_EYES if put.kind == "ear" else 1.0, float(np.ceil(half + self.deep.get("eye", 0.5))))
            level = max(level, min(max(host.near(p).round for p in eyes[1]) + clear, float(host.high)))
        if put.host is not None and self.work.nose_first(put.host[0]):
            widest = max(len(ring) for _, ring in host.levels)
            level = max(level, float(next(n for n, ring in host.levels if len(ring) >= _FULL * widest)))
        return near if level == near.round else Spot(host.name, float(int(level)), host.in_round(level, direction))

    def _headed(self, put: Put) -> bool:
        """Whether a part is put on a body that bears a head of its own, or on that end of what is both."""
        assert put.host is not None
        head = self.work.of_kind("head")
        return put.region == "body" or (put.host[0].kind == "body" and head is not None and head != put.host[0])

    def _rims(self, put: Put) -> list[Placed] | None:
        """A part whose open end is as wide as the other's, sewn to it rim to rim, where nothing else is said."""
        assert put.host is not None
        part, host = put.copies[0][0].copy(put.copies[0][1]), put.host[0].copy(max(1, put.host[1]))
        own, other = self.work.open(part), self.work.open(host)
        index = self.work.spots.parts[part]
        begun, by = len(self.work.spots.begun(index)), None
        if abs(own - other) > RIM_OFF >= abs(begun - other) and own >= RIM:  # a ring, by its inner edge
            own, by = begun, float(self.work.host(put.copies[0]).low)
        if (
            len(put.copies) > 1
            or put.where.rounds
            or min(own, other) < RIM
            or abs(own - other) > max(RIM_OFF, _RIM_SHARE * other)
        ):
            return None
        h = self.work.host((put.host[0], max(1, put.host[1])))
        ends = [edge for edge in (self.work.spots.rim(h.part), self.work.spots.begun(h.part)) if len(edge)]
        if len(ends) == 1 and any(isinstance(r, Placed) and r.part == host for _, r in self.work.out):
            return None  # a snout is sewn down by its one open end: its nose is on its tip
        number = h.high + 1 if len(self.work.spots.rim(h.part)) else h.low - 1
        record = Placed(part, Spot(host, float(number), None, put.span), by=by, span=put.span)
        self.stand.place(record)
        return [record]

    def _joint(self, put: Put) -> list[Placed] | None:
        """A head on a body, whichever of the two is open."""
        assert put.host is not None
        part, host = put.copies[0][0].copy(1), put.host[0].copy(1)
        if len(put.copies) > 1 or self._lies(put.host):
            return None
        first, last = self.work.nose_first(put.copies[0][0]), self.work.nose_last(put.copies[0][0])
        if put.host[0] == self.work.main and (first or last):
            return self._hung(put, part, host, "side" if first else "back")
        own, other = self.work.open(part), self.work.open(host)
        h = self.work.host(put.host)
        span = put.span
        if not own and other and put.host[0] == self.work.main:
            # Only the body is open: it hangs on the head, which then stands on its end.
            top = float(self.work.host(put.copies[0]).high + 1)
            record = Placed(host, Spot(part, top, None, span), span=span)
            self.work.made.ups.pop(put.host[0].name, None)
            self.work.made.ups[put.copies[0][0].name] = "start"
            self.stand.set_up(self.work.spots.parts[part], "start")
            self.stand.place(record)
            return [record]
        pole = h.pole(np.array([0.0, 1.0, 0.0]))
        if pole is None:
            return None
        record = Placed(part, replace(pole, span=span), span=span)
        self.stand.place(record)
        return [record]

    def _hung(self, put: Put, part: str, host: str, up: str) -> list[Placed] | None:
        """A head that was worked from its nose, or to it, lies on the body: the body's end is sewn to its underside."""
        assert put.host is not None
        work, index = self.work, self.work.spots.parts[part]
        if not work.open(host) and self.work.host(put.host).pole(np.array([0.0, 1.0, 0.0])) is None:
            return None
        self.stand.set_up(index, up)
        head = work.host((put.copies[0][0], 1))
        spot = replace(self._beneath(head), span=put.span)
        if not self.stand.there(spot):
            return None
        # A head that looks ahead looks ahead over a body that hangs straight down from it, however its underside is round there.
        record = Placed(host, spot, span=put.span, points=(0.0, -1.0, 0.0))
        work.made.ups.pop(put.host[0].name, None)
        work.made.ups[put.copies[0][0].name] = up
        self.stand.place(record)
        return [record]

    def _beneath(self, head: Host) -> Spot:
        """Where a head that lies sits on what is under it: as far back on its underside as its fabric still looks down."""
        wanted = head.near(head.towards(_UNDER))
        level, _ = min(head.levels, key=lambda pair: abs(pair[0] - wanted.round))
        for number in [n for n, _ in reversed(head.levels) if n <= level]:
            spot = head.within(Spot(head.name, float(number), head.in_round(number, np.array([0.0, -1.0, 0.0]))))
            if float(self.stand.frame(spot).normals[0][1]) < -_DOWN:
                return spot
        return wanted

    def _lids(self, copy: Copy, spot: Spot) -> bool:
        """Whether a part is a disc as wide as the round that is said: it is sewn into it all round, as soil in a pot."""
        record, spots = Placed(copy[0].copy(copy[1]), spot), self.work.spots
        there = self.stand.there(spot)
        return there and len(lid_on(spots.built, spots, record, sewing.end_of(spots.built, spots, record))) > 0

    @staticmethod
    def _below_face(way: Way) -> Way:
        """Arms of a ball are beside its belly, and not beside its eyes."""
        x, y, z = way.at
        return replace(way, at=(x, _BESIDE_BELLY, max(z, 0.25))) if abs(x) > 0.6 and y > _BESIDE_BELLY else way

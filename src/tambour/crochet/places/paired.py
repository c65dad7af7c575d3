"""Paired: two copies of a part, each the mirror image of the other, and how far off the middle of the front they are."""

from __future__ import annotations

import math
import re
from dataclasses import replace
from typing import Final

import numpy as np

from tambour.crochet.language.finishes import Placed, Spot
from tambour.crochet.places.hear import Copy, Put
from tambour.crochet.places.jointed import Jointer
from tambour.crochet.places.stand import Host
from tambour.crochet.places.usual import Way

_ROOM: Final = 3.6
"""Two things that are so far from the middle as a round has stitches divided by this stand left and right of it, not behind it."""
_BULGES: Final = 0.85
"""How much of its widest round a snout covers of what is behind it."""
_OVER_TOP: Final = 1.5
"""Ears so many stitches apart as there are rounds over the crown between them, within this, stand at the sides."""
_FROM_DOOR: Final = re.compile(
    r"\bstitches between (?:(?:the|its) )?(?:edge of (?:the )?)?(?:frame|door)(?: of (?:the )?door)? and (?:(?:the|each|both|every) )*windows?\b"
)
"""What is left free between a door and the windows on both sides of it."""
_CORNERS: Final = re.compile(r"\bbetween (?:the |their |both )*(?:two )?inner (?:corners|edges|points)\b")
"""Where stitches between two ears are counted: in the round where they begin."""
_SPIRAL: Final = 1.0
"""Rounds that spiral lean by no more than one from side to side: limbs that are so far apart are as high as each other."""


class Pairer(Jointer):
    """Knows where the two of a pair are."""

    def _half(self, copy: Copy) -> float:
        """Half the width of a part's end, in stitches."""
        edge = self.work.open(copy[0].copy(copy[1])) or 6
        return edge / (2.0 * math.pi)

    def _bulge(self, copy: Copy) -> float:
        """Half the width of a snout, in stitches: it may be wider than the end that it is sewn by."""
        widest = max(len(ring) for _, ring in self.work.host(copy).levels)
        rows = bool(self.work.spots.in_rows[self.work.spots.parts[copy[0].copy(copy[1])]])
        return max(self._half(copy), 0.0 if rows else _BULGES * widest / (2.0 * math.pi))

    def _paired(
        self, put: Put, host: Host, both: list[tuple[Copy, tuple[Spot, Way]]]
    ) -> list[tuple[Copy, tuple[Spot, Way]]]:
        """Two copies: mirrored about the middle of the front, as far apart as is said; the lower stitch comes first."""
        (one, (a, way)), (_, (b, _)) = both
        if a.stitch is None or b.stitch is None or (self.work.spots.in_rows[host.part] and put.where.rounds is None):
            return both
        middle = host.middle(a.round)
        count = host.count(a.round)
        off = abs((a.stitch - middle + count / 2) % count - count / 2)
        apart = self._apart(put.where)
        if apart is not None:
            edge = self.work.open(one[0].copy(1)) or 0
            flat = self._flat(one, way)
            upright = flat and put.where.rounds is not None and abs(put.where.rounds[1] - put.where.rounds[0]) >= 2
            wide = edge / 4 if flat else edge / (2.0 * math.pi)
            if not edge and self._shut(one):  # closed through both layers, a line that lies level
                wide = 0.5 * len(self.work.spots.stitches(self.work.spots.last(self.work.spots.parts[one[0].copy(1)])))
            door = self.known.get("door")
            if _FROM_DOOR.search(put.where.text) and door is not None and door[0] == host.name:
                apart = 2.0 * (
                    apart - 1.0 + self.deep.get("door", 0.0) + 0.5
                )  # from its frame to the one and to the other
            off = 0.5 * apart + (0.0 if upright else wide)
            low_end = min(put.where.rounds[:2]) if put.where.rounds is not None else 0.0
            if put.kind == "ear" and upright and _CORNERS.search(put.where.text):
                off *= count / max(
                    host.count(low_end), 1
                )  # counted in the round of their inner corners, which has fewer
            if put.kind == "ear" and upright and abs(apart - 2.0 * low_end) <= _OVER_TOP and "top" in put.where.words:
                off = 0.25 * count  # counted over the crown, from the round where the one begins to that of the other
            if put.where.rounds is None and (wider := self._wider(host, a.round, _ROOM * off)) is not None:
                a, b = replace(a, round=wider), replace(b, round=wider)
                middle, count = host.middle(wider), host.count(wider)
        elif put.kind == "eye" and put.where.rounds is None and not put.where.beside:
            level, off = self._side_by_side(host, a.round, off, self._half(one))
            a, b = replace(a, round=level), replace(b, round=level)
            middle, count = host.middle(level), host.count(level)
        elif put.kind in ("leg", "foot") and self._at_end(put) and (low := self._shut_below(host)) is not None:
            a, b = replace(a, round=low), replace(b, round=low)
            middle, count = host.middle(low), host.count(low)
            off = count / 8.0  # side by side on the line of the closed end
        elif put.kind == "fluke" and self._lies_name(host) and a.round >= host.high - 1:
            off = (self.work.open(one[0].copy(1)) or 6) / 4  # side by side on the edge of a flat end
        elif "tip" in put.where.words:
            if (far := self._far_end(host)) is not None and put.where.rounds is None:
                level = sorted((n for n, _ in host.levels), key=lambda n: abs(n - far.round))[:2][-1]
                a, b = replace(a, round=float(level)), replace(b, round=float(level))
                middle, count = host.middle(a.round), host.count(a.round)
            off = 0.25 * count  # on both sides of it, not both in front, nor one above the other
            if self._lies_name(host) and (side := self._stood_on(host, a.round)) is not None:
                middle = side + off
        if apart is not None and self._lies_name(host) and way.at[1] < -0.3:
            middle += 0.5 * count  # legs of what lies: from the middle of its underside
        return self._sides(host, both, a, middle, off)

    def _sides(
        self, host: Host, both: list[tuple[Copy, tuple[Spot, Way]]], at: Spot, middle: float, off: float
    ) -> list[tuple[Copy, tuple[Spot, Way]]]:
        """Two copies so many stitches off the middle of a round, each with the way of its side."""
        (one, (_, way)), (other, (_, mirror)) = both
        off = round(off, 3)
        first = replace(at, stitch=round(middle - off, 3))
        last = replace(at, stitch=round(middle + off, 3))
        # Which of the two ways is on the side of the lower stitch?
        x = self.stand.frame(first).points[0][0] - host.box[0][0]
        ways = (way, mirror) if (x >= 0.0) == (way.at[0] >= 0.0) else (mirror, way)
        return [(one, (first, ways[0])), (other, (last, ways[1]))]

    def _evened(self, host: Host, made: list[tuple[Copy, tuple[Spot, Way]]]) -> list[tuple[Copy, tuple[Spot, Way]]]:
        """Two pairs of limbs, each the mirror image of itself, though rounds that spiral lean a little."""
        even: list[tuple[Copy, tuple[Spot, Way]]] = []
        for both in (made[:2], made[2:]):
            (_, (a, way)), (_, (b, mirror)) = both
            far = abs(a.round - b.round) > _SPIRAL or mirror.at[0] * way.at[0] >= 0.0
            if a.stitch is None or b.stitch is None or far:
                even += both
                continue
            middle, count = host.middle(a.round), host.count(a.round)
            offs = [abs((s - middle + count / 2) % count - count / 2) for s in (a.stitch, b.stitch)]
            even += self._sides(host, both, a, middle, 0.5 * sum(offs))
        return even

    def _far_end(self, host: Host) -> Spot | None:
        """The end of a part away from where it is sewn; of the main part, which lies, its hind end."""
        away = np.array([0.0, 0.0, -1.0])
        if host.name.split(".")[0] != self.work.main.name:
            sewn = next((r for _, r in self.work.out if isinstance(r, Placed) and r.part == host.name), None)
            first, last = host.levels[0][1].mean(0), host.levels[-1][1].mean(0)
            seam = last if sewn is None else self.stand.frame(sewn.spot).points[0]
            nearer = ((last - seam) ** 2).sum() < ((first - seam) ** 2).sum()
            away = -host.axis if nearer else host.axis
        return next((host.pole(way) for way in (host.axis, -host.axis) if float(way @ away) > 0.5), None)

    def _stood_on(self, host: Host, level: float) -> float | None:
        """The stitch of a round near a part's tip that those stand on which are at the toy's side where the part is sewn on:
        rounds of few stitches turn on their way there."""
        graph, spots = self.work.built.graph, self.work.spots
        last = host.levels[-1][0]
        begin, end = (spots.round_at(host.part, int(n)) for n in (last, level))
        if begin is None or end is None or begin <= end:
            return None
        ring, goal = spots.stitches(begin), spots.stitches(end).tolist()
        at = host.in_round(last, np.array([1.0, 0.0, 0.0]))
        node = int(ring[round(at - 1.0) % len(ring)])
        for _ in range(int(last - level)):
            anchors = graph.anchors[graph.anchor_offsets[node] : graph.anchor_offsets[node + 1]]
            if not len(anchors):
                return None
            node = int(anchors[0])
        return goal.index(node) + 1.0 if node in goal else None

    def _lies_name(self, host: Host) -> bool:
        return abs(float(host.axis[1])) < 0.5

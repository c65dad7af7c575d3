"""Placed, in a person's words: "Sew Ears to Head, between Rnd 5 and 6, 10 stitches apart, leaning outwards"."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import groupby

from tambour.crochet.finish.placing import frames
from tambour.crochet.graph.built import Built
from tambour.crochet.graph.spots import Spots
from tambour.crochet.language.finishes import Embroidery, Eye, Felt, Finish, Hair, Placed, Spot, Tie
from tambour.crochet.words.phrases import Phrases
from tambour.crochet.words.table import Terms

_LEANS = 25.0
"""A part that leans less than this, in degrees, is not said to lean."""


class Spoken:
    """Says finishing records in words and round numbers, in the language of ``terms``; spots as near as hands count."""

    def __init__(self, built: Built, terms: Terms) -> None:
        self.built, self.terms, self.page = built, terms, terms.page
        self.spots = Spots(built)
        self.phrases = Phrases(terms, {}, {})

    def __call__(self, records: Sequence[Finish]) -> list[str]:
        """A sentence for every group of records that belong together, in their order."""
        made: list[str] = []
        for _, group in groupby(records, self._alike):
            said = self._group(list(group))
            made.append(said[:1].upper() + said[1:] + ".")
        return list(dict.fromkeys(made))

    def _alike(self, record: Finish) -> tuple[object, ...]:
        match record:
            case Placed():
                return "place", self._base(record.part), self._base(record.spot.part), record.spot.round
            case Tie():
                return "tie", record
            case Eye():
                return "eye", record.spot.part, record.spot.round, record.size
            case Embroidery():
                return "embroider", record.spots[0].part, record.motif
            case Felt():
                return "felt", record.spot.part, record.spot.round
            case Hair():
                return "hair", record.spots[0].part

    def _base(self, part: str) -> str:
        base, _, copy = part.rpartition(".")
        return base if copy.isdigit() and part not in {s.name for s in self.built.pattern.parts} else part

    def _group(self, group: list[Finish]) -> str:
        first, page = group[0], self.page
        match first:
            case Placed():
                placed = [r for r in group if isinstance(r, Placed)]
                every = self._copies(first.part) == len(placed)
                names = self._base(first.part) if every else ", ".join(r.part.replace(".", " ") for r in placed)
                onto = " / ".join(dict.fromkeys(r.spot.part.replace(".", " ") for r in placed))
                said = [
                    page["put"].format(part=names, onto=onto),
                    *self.where([r.spot for r in placed], self._breadth(first)),
                ]
                return ", ".join([*said, *self._held(placed)])
            case Tie():
                return self.phrases.finish(first)
            case Eye():
                many = "put eyes" if len(group) > 1 else "put eye"
                said = [page[many].format(n=len(group), size=f"{first.size:g}", part=first.spot.part)]
                return ", ".join([*said, *self.where([r.spot for r in group if isinstance(r, Eye)])])
            case Embroidery():
                key = {"eyes": "embroidered eyes"}.get(first.motif, first.motif) or (
                    "lines" if len(first.spots) > 1 else "dots"
                )
                rounds = [s.round for r in group if isinstance(r, Embroidery) for s in r.spots]
                done = page["stitched"].format(what=page[key], part=first.spots[0].part)
                return f"{done}, {self._rounds(min(rounds), max(rounds))}"
            case Felt():
                done = page["felt on"].format(part=first.spot.part)
                return ", ".join([done, *self.where([r.spot for r in group if isinstance(r, Felt)])])
            case Hair():
                rounds = [s.round for r in group if isinstance(r, Hair) for s in r.spots]
                done = page["hair on"].format(part=first.spots[0].part)
                return f"{done}, {self._rounds(min(rounds), max(rounds))}"

    def _copies(self, part: str) -> int:
        return next((s.copies for s in self.built.pattern.parts if s.name == self._base(part)), 1)

    def _rounds(self, low: float, high: float) -> str:
        """A stretch of rounds: those that it lies between, or the one that it is on."""
        a, b = math.floor(low + 0.25), math.ceil(high - 0.25)
        a = max(a, 1)  # before the first round is the ring, which has no number
        if b - a > 1:  # over several rounds, and not in the gap between two
            return self.page["took rounds"].format(a=a, b=b)
        if a >= b:
            return self.phrases.say("at round", round=a, stitch=None, front=None)
        return self.phrases.say("at between", round=a, next=b, stitch=None, front=None)

    def _breadth(self, record: Placed) -> float:
        """How many stitches a part's end takes up along the round that it is sewn to."""
        part = self.spots.parts[record.part if record.part in self.spots.parts else f"{record.part}.1"]
        if self.spots.in_rows[part] or (record.flat and abs(abs(record.across) - 90.0) < _LEANS):
            return 0.0
        edge = len(self.spots.sewn_rim(part))
        return edge / 2.0 if record.flat else edge / math.pi

    def where(self, spots: list[Spot], breadth: float = 0.0) -> list[str]:
        """The round, and where in it: apart (between the edges of what takes up ``breadth`` stitches), in the middle, at a side."""
        spot, page = spots[0], self.page
        part = self.spots.parts[spot.part]
        number = int(spot.round)
        k = self.spots.round_at(part, number)
        if k is None or (spot.stitch is None and number < 1):
            frame = frames(self.spots, self.spots.layout, [spot])
            up = self.built.pattern.parts[self.built.parts[part].section].up
            upward = float(frame.normals[0][1]) > 0.0
            placed = any(
                isinstance(r, Placed) and r.part in (spot.part, f"{spot.part}.1") for r in self.built.pattern.finish
            )
            turned = up == "start" or (placed and up is None)
            return [page["underneath" if upward == turned else "on top"]]
        said = [self._rounds(math.floor(spot.round), math.ceil(spot.round))]
        n = len(self.spots.stitches(k))
        middle = 1.0 + self.spots.front(k)
        offs = [0.0 if s.stitch is None else (s.stitch - middle + n / 2) % n - n / 2 for s in spots]
        if len(offs) == 2:
            if abs(sum(offs)) <= 1.01:
                apart = max(0, round(abs(offs[1] - offs[0]) - breadth))
                return (
                    [*said, page["each side"]]
                    if abs(abs(offs[0]) - n / 4) <= (0.06 * n if breadth else 0.5)
                    else [*said, *([page["apart one" if apart == 1 else "apart"].format(n=apart)] if apart else [])]
                )
            return said
        if len(offs) > 2:
            return said
        (off,) = offs
        # A part that hangs by its end is worked round the other way.
        if abs(off) < 1.0:
            return [*said, page["in front"]]
        if abs(off) > n / 2 - 1.0:
            return [*said, page["behind"]]
        left = bool(self._left(spot))
        if abs(abs(off) - n / 4) < 1.5:
            return [*said, page["on its left" if left else "on its right"]]
        return [*said, page["left of front" if left else "right of front"].format(n=round(abs(off)))]

    def _left(self, spot: Spot) -> bool:
        """Whether a spot is on the toy's left, by the layout; parts that hang are turned over."""
        place = self.spots.place(spot)
        x = sum(w * float(self.spots.layout[node, 0]) for node, w in zip(place.nodes, place.weights))
        part = self.spots.parts[spot.part]
        up = self.built.pattern.parts[self.built.parts[part].section].up
        placed = any(isinstance(r, Placed) and self.spots.parts.get(r.part) == part for r in self.built.pattern.finish)
        return (x > 0.0) != (placed or up == "start")

    def _held(self, placed: list[Placed]) -> list[str]:
        """How the parts' ends are, and where they point, as one sees it at the toy."""
        rows = bool(self.spots.in_rows[self.spots.parts[placed[0].part]])  # laid on the fabric
        said = [self.page["pinched"]] if placed[0].flat and not rows else []
        if placed[0].tilt < _LEANS:
            return said
        w = placed[0].towards % 360.0
        if w <= 40.0 or w >= 320.0:
            return [*said, self.page["upwards"]]
        if 140.0 <= w <= 220.0:
            return [*said, self.page["downwards"]]
        return [*said, self.page["outwards"]] if len(placed) == 2 else said

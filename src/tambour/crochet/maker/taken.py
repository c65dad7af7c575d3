"""Taken: what the pictures have where a designer's sentence leaves something open, told next to it as ours."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Final

import numpy as np

from tambour.core.check import Array
from tambour.core.graph import SEWN
from tambour.crochet.finish.sewing import end_of
from tambour.crochet.graph.spots import Spots
from tambour.crochet.language.finishes import Embroidery, Eye, Placed, Spot
from tambour.crochet.maker import agree, sure
from tambour.crochet.maker.drawn import sized
from tambour.crochet.maker.named import rounds_named
from tambour.geometry.near import nearest

if TYPE_CHECKING:
    from tambour.crochet.piece import Plush

_SIDE: Final = 0.04
"""What is so near a quarter of its round from the middle, as a share of the round, is at the side."""
_POINTS: Final = 0.42
"""A part points where this much of its way goes, as a cosine."""
_APART: Final = re.compile(r"(\d+)\s+st(?:itche)?s?\s+apart")
_NUMBERED: Final = re.compile(r"\b(?:sts?|stitch(?:es)?)\.? ?(?:nos?\.? )?\d")
"""She says by their numbers which stitches."""
_FLAT: Final = 0.25
"""An end is sewn flat where for so many of its stitches a pair is sewn to one another; the outermost are neighbours anyway."""
_TOUCHES: Final = 1.2
"""Parts that come so near to one another touch, in stitches."""
_NARROW: Final = 9
"""On a round of so few stitches no place is counted."""
_NEAR: Final = 1.5
"""An end so many rounds from those that she names is where she says."""
_FAR: Final = 0.5
"""Two parts are another way apart than she says where they miss it by this share."""
_EXACT, _COUNTS = 0.6, 2.0
"""By so few stitches eyes are as far apart as she says; by no more than these nothing is said: people count from hole to hole, or whole ones."""
_LEVEL: Final = 2
"""An edge over no more rounds than this runs along a round."""


class Taken:
    """Says of finishing records how the pictures have them, in rounds, stitches and millimetres; ``own``: the page's words."""

    def __init__(self, piece: Plush, own: Mapping[str, str]) -> None:
        self.piece, self.own = piece, own
        self.built = piece.built
        self.spots = Spots(self.built)
        graph = self.built.graph
        self.sewn = graph.edges[graph.edge_kind == SEWN]
        self._placed = {self.spots.parts.get(f.part) for f in self.built.pattern.finish if isinstance(f, Placed)}

    def __call__(self, records: Sequence[object]) -> list[str]:
        """A sentence for each kind of thing among ``records``: parts sewn on, faces; nothing where nothing is open."""
        made: dict[str, None] = {}
        placed = [r for r in records if isinstance(r, Placed)]
        for base in dict.fromkeys(self._base(r) for r in placed):
            alike = [r for r in placed if self._base(r) == base]
            pieces = self._part(alike) if self._sure(alike) else []
            said = self._agreed(alike, pieces) if any(pieces) else []
            made |= dict.fromkeys(said)
        drawn = [r for r in records if isinstance(r, Embroidery)]
        for motif in dict.fromkeys((r.motif, r.spots[0].part) for r in drawn):
            said = sized(self, [r for r in drawn if (r.motif, r.spots[0].part) == motif])
            made |= dict.fromkeys(self._said(said, self._called(motif[0]) if len({m.motif for m in drawn}) > 1 else ""))
        return [words for words in made if sure.whole(words)]

    def _agreed(self, alike: list[Placed], pieces: Sequence[str]) -> list[str]:
        """Of the pieces of a sentence those that agree with all that she says of a part where she puts it; where its place does not, that."""
        first, pattern, end = alike[0], self.built.pattern, end_of(self.built, self.spots, alike[0])
        other = [f.span.start for f in pattern.finish if isinstance(f, Placed) and self._base(f) != self._base(first)]
        hers = agree.claims(agree.said(pattern, first.span, other), pattern.terms)
        wide = len(end.nodes) / np.pi if end.ring else len(end.pinched) or len(end.nodes) / 2.0
        ours = agree.claims("; ".join(pieces), pattern.terms, True)
        if self._against(alike) or agree.placed_otherwise(hers, ours, wide if len(alike) == 2 else 1.0):
            return [self.own["took elsewhere"]]
        return self._said(agree.kept(pieces, hers, pattern.terms))

    def _sure(self, alike: list[Placed]) -> bool:
        """Whether parts are where she says, on rounds that she numbers as we do."""
        first, pattern = alike[0], self.built.pattern
        if self.spots.place(first.spot).opening:
            return True
        if sure.joined(self.words(first), pattern.terms):
            return False
        levels = [s[:, 0] for r in alike if len(s := self._seam(r))] or [np.array([first.spot.round])]
        host = self._base_of(first.spot.part)
        if not sure.hers_too(pattern, host, *(float(f(np.concatenate(levels))) for f in (np.min, np.max))):
            return False
        count = self.off(first.spot)[1]
        if not count or first.spot.stitch is None or len(alike) > 2:
            return True
        return not sure.contradicts(self._sides(first), self._mean_off(alike) / count, self._lies(first.spot.part))

    def _sides(self, record: Placed) -> frozenset[str]:
        return sure.sides(self.words(record), self.built.pattern)

    def eyes(self, eyes: Sequence[Eye]) -> str:
        """How many stitches from the middle each of two eyes is; "" where they are not two."""
        if len(eyes) != 2 or not self._eyed(eyes):
            return ""
        off = [float(int(np.mean([abs(self.off(e.spot)[0]) for e in eyes]) + 0.01))]
        count = self.off(eyes[0].spot)[1]
        if not off[0]:  # each on a disc of its own
            return ""
        each = self.own["each"].format(what=self.from_middle(eyes[0].spot.part, off, count))
        words = sure.paragraph(self.built.pattern.text.text, eyes[0].span.start, eyes[0].span.end, 2)
        gap = 2.0 * float(np.mean([abs(self.off(e.spot)[0]) for e in eyes]))
        on = abs((eyes[0].spot.stitch or 0.0) % 1.0 - 0.5) >= 0.26  # on a stitch each, which is none between them
        if (far := sure.miscounts(words, (gap, gap - 1.0) if on else (gap,), count)) > _EXACT:
            return self.own["took elsewhere"] if far > _COUNTS else ""
        counted = "" if _NUMBERED.search(words) else self._counted([e.spot for e in eyes])
        return "".join(words for words in self._said([each, counted]) if sure.whole(words))

    def _eyed(self, eyes: Sequence[Eye]) -> bool:
        """Whether her sentence puts eyes there, on the front of a round that she numbers as we do."""
        pattern, spot = self.built.pattern, eyes[0].spot
        span = eyes[0].span
        text = sure.to_its_end(pattern.text.text, span.start, span.end)
        off, count = self.off(spot)
        wide = 2.0 * abs(off) * self.piece.stitch[0]
        if text and not (sure.puts_eyes(text, pattern.terms) and sure.as_far(text, wide)):
            return False
        behind = not self._lies(spot.part) and abs(off) > count / 4
        levels = [e.spot.round for e in eyes]
        return not behind and sure.hers_too(pattern, self._base_of(spot.part), min(levels), max(levels))

    def _counted(self, spots: list[Spot]) -> str:
        """At which stitches of their round two spots are, counted from its first; "" where they are on no one round."""
        at = sorted(s.stitch for s in spots if s.stitch is not None)
        if len(at) != 2 or len({int(s.round) for s in spots}) > 1:
            return ""
        n = int(spots[0].round)
        if all(abs(s % 1.0 - 0.5) < 0.26 for s in at):
            a, b = (int(s) for s in at)
            return self.own["eyes between"].format(n=n, a=a, a2=a + 1, b=b, b2=b + 1)
        a, b = (round(s) for s in at)
        return self.own["eyes on"].format(n=n, a=a, b=b)

    def end(self, part: int) -> str:
        """How the end of a stuffed part lies that is sewn shut; "" where it stays open, or something is sewn to it."""
        if part in self._placed:
            return ""
        graph = self.built.graph
        rim = self.spots.rim(part)
        pairs = int((np.isin(self.sewn, rim).all(1) & (graph.part[self.sewn[:, 0]] == part)).sum()) if len(rim) else 0
        return (
            "".join(self._said([self.own["took flat end"].format(n=len(rim) // 2)]))
            if pairs >= _FLAT * len(rim) > 0
            else ""
        )

    def _said(self, words: list[str], of: str = "") -> list[str]:
        words = [w for w in words if w]
        what = ", ".join(words)
        what = f"{of}: {what}" if of else what
        return [f"{what[0].upper()}{what[1:]}."] if what else []

    def _called(self, motif: str) -> str:
        key = {"eyes": "embroidered eyes"}.get(motif, motif)
        return self.own.get(key, "")

    def _against(self, alike: list[Placed]) -> bool:
        """Whether the pictures have parts elsewhere than her sentence says: on other rounds, or another way apart."""
        first = alike[0]
        seams = [s for r in alike if len(s := self._seam(r))]
        if len(seams) < len(alike) or len(alike) > 2:
            return False
        hers = self.rounds(first)
        levels = np.concatenate([s[:, 0] for s in seams])
        if hers and (levels.min() > hers[1] + _NEAR or levels.max() < hers[0] - _NEAR):
            return True
        apart = self._apart(first)
        gaps = [sure.gap_on(first.spot.round, seams), 2 * round(levels.min())]  # or counted over the top
        gap = min(gaps, key=lambda n: abs(n - apart))
        return len(alike) == 2 and apart > 0 and gaps[0] > 0 and abs(gap - apart) > max(3.0, _FAR * apart)

    def _apart(self, record: Placed) -> int:
        """How many stitches she has between two; 0 where she says nothing of it."""
        found = _APART.search(self.words(record).lower())
        return int(found[1]) if found is not None else 0

    def _base(self, record: Placed) -> int:
        return self._base_of(record.part)

    def _base_of(self, part: str) -> int:
        return self.built.parts[self.spots.parts[part]].section

    # -- parts ------------------------------------------------------------------------------------------------------

    def _part(self, alike: list[Placed]) -> list[str]:
        """The pieces of the sentence of a part, of all its copies."""
        first, own = alike[0], self.own
        part, host = self.spots.parts[first.part], self.spots.parts[first.spot.part]
        if self.spots.in_rows[host]:
            return []
        if self.spots.place(first.spot).opening:
            rims = len(self.spots.sewn_rim(part)), len(self.spots.opening(host, first.spot.round))
            seam = [own["took rim"].format(n=rims[0])] if rims[0] == rims[1] and rims[0] else []
            return [*seam, *([own["took neck"]] if self.built.parts[part].stuffing and rims[0] else [])]
        rim = self.spots.rim(host)
        if len(rim) and self._lies(first.spot.part) and np.isin(self.spots.place(first.spot).nodes, rim).all():
            each = len(rim) // 2 // len(alike)
            return [*([own["took halves"].format(n=each)] if len(alike) == 2 else []), *self._points(alike)]
        if len(alike) > 2:
            return [own["took middles"].format(places=self._listed(alike))]
        end = end_of(self.built, self.spots, first)
        seams = [s for r in alike if len(s := self._seam(r))]
        if len(seams) < len(alike):
            return []
        if end.laid:
            at = self._middle(first, self._mean_off(alike), self._count(host, round(first.spot.round)), True)
            if len(alike) == 2 and self._mean_off(alike) > 1.0:
                return [own["each"].format(what=at), *self._laid(first, part)]
            return [*self._laid(first, part), at]
        low = round(float(np.mean([s[:, 0].min() for s in seams])))
        high = round(float(np.mean([s[:, 0].max() for s in seams])))
        turn, hers = min(first.across % 180.0, -first.across % 180.0), self.rounds(first)
        if hers and hers[1] - hers[0] > 1:
            low, high = hers  # the numbers are those that she says
        if end.ring:
            plain = bool(hers) and hers[1] - hers[0] <= 1  # its middle is spoken of before
            said = [
                self._at(sum(hers) / 2.0)
                if hers and hers[1] - hers[0] <= 1
                else ""  # she says it
                if hers
                else own["took ring"].format(a=low, b=high)
                if low < high
                else own["took round"].format(n=low),
                ""
                if any(sure.about_axis(s[:, 1], self._count(host, round(float(s[:, 0].mean())))) for s in seams)
                else self._middle(first, self._mean_off(alike), self._count(host, round(first.spot.round)), plain),
            ]
            if high < 1:
                return [
                    self._middle(first, self._mean_off(alike), self._count(host, 1)),
                    *self._points(alike),
                ]  # at its very end
            gap = sure.gap_on(first.spot.round, seams)
            if len(alike) == 2 and gap and (not self._apart(first) or self._against(alike)):
                said.append(own["took gap on"].format(n=gap, r=round(first.spot.round)))
        elif high - low <= _LEVEL and turn < 60.0:
            level = round((low + high) / 2)
            said = self._along(first, seams, level, len(alike), sure.level_named(hers, level))
        else:
            said = self._across(alike, low, high, len(end.nodes) - len(end.pinched))
        if sure.beside(sure.paragraph(self.built.pattern.text.text, first.span.start, first.span.end)):
            keys = (
                "off front",
                "off back",
                "off top",
                "off under",
                "took gap",
                "took edge",
            )  # she says it by what is near
            counts = [re.split(r"\{\w+\}", self.own[key])[-2 if key == "took edge" else -1] for key in keys]
            said = [words for words in said if not any(one in words for one in counts)]
        return [*said, *self._points(alike), *self._rests(alike, host)]

    def _rests(self, alike: list[Placed], host: int) -> list[str]:
        """What parts that hang down lie on at last, other than what they are sewn to."""
        piece, graph = self.piece, self.built.graph
        names = dict[str, None]()
        finish = self.built.pattern.finish
        since = max((k for k, f in enumerate(finish) if f in alike), default=0)
        on = {r.part for r in alike}
        worn = {self.spots.parts[f.part] for f in finish if isinstance(f, Placed) and f.spot.part in on}  # sewn to it
        hanging = {self.spots.parts[f.part] for f in finish[since + 1 :] if isinstance(f, Placed)}  # not there yet
        for record in alike:
            mine = graph.parts[self.spots.parts[record.part]]
            own = piece.positions[mine.start : mine.end]
            for k, other in enumerate(graph.parts):
                section = self.built.parts[k].section
                if (
                    k == host
                    or k in hanging
                    or k in worn
                    or other.end <= other.start
                    or section == self.built.parts[self.spots.parts[record.part]].section
                ):
                    continue
                far, at = nearest(own, piece.positions[other.start : other.end])
                near = far[:, 0] < _TOUCHES * piece.stitch[0]
                below = own[near, 1] > piece.positions[other.start + at[near, 0], 1]
                if near.sum() >= 3 and below.mean() > 0.5:
                    names[self.built.pattern.parts[section].name] = None
        return [self.own["took rests"].format(part=name) for name in names if len(names) == 1]

    def _listed(self, alike: list[Placed]) -> str:
        """Where the middles of many copies are, in the order in which one comes to them on a round."""
        around = [(self._share(r.spot), r.spot) for r in alike]
        said = []
        for _, spot in sorted(around, key=lambda a: (a[0], a[1].round)):
            a, b = round(spot.round), 0 if spot.stitch is None else max(1, round(spot.stitch))
            said.append(self.own["took knot"].format(a=a, b=b) if b else self.own["took round"].format(n=a))
        return "; ".join(said)

    def _share(self, spot: Spot) -> float:
        """How much of its round lies before a spot."""
        count = self._count(self.spots.parts[spot.part], int(spot.round))
        return (spot.stitch or 0.0) / count if count else 0.0

    def _mean_off(self, alike: list[Placed]) -> float:
        return float(np.mean([abs(self.off(r.spot)[0]) for r in alike]))

    def _laid(self, record: Placed, part: int) -> list[str]:
        """How far a flat piece reaches: of one in rows from its first to its last, of a disc its middle."""
        level, hers = record.spot.round, self.rounds(record)
        text = self.built.pattern.text.text
        near = rounds_named(sure.paragraph(text, record.span.start, record.span.end, 2), self.built.pattern.terms)
        if near and not hers:
            return (
                [self._row_one(part)] if self.spots.in_rows[part] else []
            )  # the next sentence says which rounds it reaches
        if self.spots.in_rows[part]:
            rows = sum(r.part == part and r.number > 0 and not r.aside for r in self.built.rounds)
            low = round(level - 0.5 * rows)
            if rows <= 1:
                return ["" if hers else self._at(level)]
            named = self.own["took from row"].format(a=low, b=low + rows - 1)
            return ["" if hers and hers[1] - hers[0] > 1 else named, self._row_one(part)]
        return ["" if hers and hers[1] - hers[0] <= 1 else self._at(level)]

    def _at(self, level: float) -> str:
        """The middle of something on its round, or between two."""
        if abs(level - round(level)) < 0.3:
            return self.own["took at middle"].format(n=round(level))
        between = self.own["took between"].format(a=int(level), b=int(level) + 1)
        return self.own["its middle"].format(what=between)

    def _along(self, first: Placed, seams: list[Array], level: int, copies: int, named: int) -> list[str]:
        """Of an edge along a round the stitches from the middle, the first of them beside it; how many are between two.

        named : the number that the round has in her sentence; 0 where she says it to be between two
        """
        count = self._count(self.spots.parts[first.spot.part], level)
        if count <= _NARROW and len(self.spots.place(first.spot).nodes) and copies > 1:
            return [self.own["took round"].format(n=named or level)]  # the tip of a tail: nobody counts there
        lone = any(s[:, 1].min() * s[:, 1].max() < 0.0 and abs(s[:, 1]).max() < count / 4 for s in seams)
        if lone or not count:
            return [
                self.own["took round"].format(n=named or level),
                self._middle(first, abs(self.off(first.spot)[0]), count),
            ]
        far = float(np.mean([abs(s[:, 1]).mean() for s in seams])) > count / 4
        offs = [count / 2 - abs(s[:, 1]) if far else abs(s[:, 1]) for s in seams]
        a, b = (max(1, round(float(np.mean([end(o) for o in offs])) + 0.49)) for end in (np.min, np.max))
        if a == b:
            where = self.from_middle(first.spot.part, [count / 2 - a if far else a], count)
            return [self.own["took round"].format(n=named or level), where]
        key = (
            ("side under" if far else "side top")
            if self._lies(first.spot.part)
            else ("side back" if far else "side front")
        )
        edge = self.own["took edge"].format(n=named or level, a=a, b=b, side=self.own[key])
        said = [edge if named else edge.partition(",")[2].strip()]  # "between rounds 8 and 9" she says herself
        gap = copies == 2 and a > 1 and (not self._apart(first) or abs(self._apart(first) - 2 * (a - 1)) > 2)
        return [*said, *([self.own["took gap"].format(n=2 * (a - 1))] if gap else [])]

    def _across(self, alike: list[Placed], low: int, high: int, stitches: int) -> list[str]:
        """Of an edge across rounds those that it runs over, where on them, and how it is eased onto them."""
        first, own = alike[0], self.own
        count = self._count(self.spots.parts[first.spot.part], round(first.spot.round))
        where = self._middle(first, self._mean_off(alike), count)
        if self._lies(first.spot.part):
            level = first.spot.round
            at = own["took round"].format(n=round(level))
            if abs(level - round(level)) >= 0.3:
                at = own["took between"].format(a=int(level), b=int(level) + 1)
            return [own["took lengthwise"].format(where=at), where]
        said = [own["took run"].format(a=low, b=high), where]
        if len(alike) == 2 and low < high and any(c.isdigit() for c in where):
            said.append(own["took counted"].format(r=round(first.spot.round)))
        if stitches > high - low + 1:
            said.append(own["took eased"].format(m=stitches, n=high - low + 1))
        apart = _APART.search(self.words(first).lower())
        if len(alike) == 2 and apart is not None and abs(int(apart[1]) - 2 * low) <= 1.5:
            said.append(own["took crown"].format(n=apart[1]))
        return said

    def rounds(self, record: Placed | Embroidery) -> tuple[int, ...]:
        """The rounds that her sentence of a record names."""
        return rounds_named(self.words(record), self.built.pattern.terms)

    def words(self, record: Placed | Embroidery) -> str:
        """Her sentence of a record."""
        return self.built.pattern.text.text[record.span.start : record.span.end]

    def _seam(self, record: Placed) -> Array:
        """Where a part is sewn on, (K, 2): round, and stitches from the middle of the front, left of it negative."""
        graph, part = self.built.graph, self.built.graph.part
        a, b = self.spots.parts[record.part], self.spots.parts[record.spot.part]
        one, other = part[self.sewn[:, 0]], part[self.sewn[:, 1]]
        nodes = np.concatenate([self.sewn[(one == a) & (other == b), 1], self.sewn[(one == b) & (other == a), 0]])
        made = []
        for node in nodes.tolist():
            k = int(graph.round[node])
            ring = self.spots.stitches(k)
            at = np.flatnonzero(ring == node)
            if len(at):
                n = len(ring)
                off = (float(at[0]) - self.spots.front(k) + n / 2) % n - n / 2
                made.append((float(self.built.rounds[k].number), off))
        return np.array(made).reshape(-1, 2)

    def _row_one(self, part: int) -> str:
        """Which way up a piece in rows is sewn."""
        mine = [k for k, r in enumerate(self.built.rounds) if r.part == part and len(self.spots.stitches(k))]
        heights = [float(self.piece.positions[self.spots.stitches(k), 1].mean()) for k in (mine[0], mine[-1])]
        wide = float(np.ptp(self.piece.positions[:, 1]))
        if abs(heights[1] - heights[0]) < 0.05 * wide:
            return ""
        return self.own["took row below" if heights[0] < heights[1] else "took row above"]

    def _points(self, alike: list[Placed]) -> list[str]:
        """Where parts point, as they are held at last."""
        piece, graph = self.piece, self.built.graph
        ways = []
        for record in alike:
            p = graph.parts[self.spots.parts[record.part]]
            own = np.arange(p.start, p.end)
            ends = np.unique(self.sewn[(self.sewn >= p.start) & (self.sewn < p.end)])
            if not len(ends) or self._pointed(record):
                return []
            middle = piece.positions[ends].mean(0)
            way = piece.positions[own].mean(0) - middle
            way = way / max(float(np.sqrt(way @ way)), 1e-9)
            ways.append(way * (1.0 if middle[0] >= 0.0 else -1.0, 1.0, 1.0))
        x, y, z = np.mean(ways, axis=0).tolist()
        if len(alike) == 1:
            x = 0.0
        found = [("outwards", x), ("upwards", y), ("downwards", -y), ("forwards", z), ("backwards", -z)]
        strong = sorted((f for f in found if f[1] >= _POINTS), key=lambda f: -f[1])
        if not sure.pointing(self._sides(alike[0]), [key for key, _ in strong]):
            return []
        said = [self.own[f"way {key}"] for key, _ in strong[:1]]
        for key, share in strong[1:]:
            way = self.own[f"way {key}"]
            said.append(way if share > 0.85 * strong[0][1] else self.own["slightly"].format(way=way))
        return [self.own["points"].format(ways=", ".join(said))] if said else []

    def _pointed(self, record: Placed) -> bool:
        """Whether her sentence says where a part points."""
        ways = [self.own[f"way {key}"] for key in ("outwards", "upwards", "downwards", "forwards", "backwards")]
        said = "|".join(re.escape(way.removesuffix("s")) for way in ways)
        return re.search(rf"\b(?:{said})(?:s|wards?)?\b", self.words(record).lower()) is not None

    # -- places on a round ------------------------------------------------------------------------------------------

    def off(self, spot: Spot) -> tuple[float, int]:
        """How many stitches a spot is from the middle of the front, and how many its round has."""
        part = self.spots.parts[spot.part]
        k = self.spots.round_at(part, int(spot.round))
        if k is None:
            return 0.0, 0
        n = len(self.spots.stitches(k))
        if spot.stitch is None:
            return 0.0, n
        return (spot.stitch - 1.0 - self.spots.front(k) + n / 2) % n - n / 2, n

    def _count(self, part: int, number: int) -> int:
        k = self.spots.round_at(part, number)
        return 0 if k is None else len(self.spots.stitches(k))

    def _lies(self, part: str) -> bool:
        section = self.built.parts[self.spots.parts[part]].section
        return self.built.pattern.parts[section].lies

    def _middle(self, record: Placed, off: float, count: int, plain: bool = False) -> str:
        """Where the middle of a part is on its round of ``count``; ``plain``: of which its middle was spoken before."""
        lies = self._lies(record.spot.part)
        if off <= 1.0:
            return self.own["on top" if lies else "in front"]
        if off >= count / 2 - 1.0:
            plain_ = lies and sure.begins_at_back(self.built.pattern.text.text)
            return self.own["underneath" if plain_ else "took under" if lies else "behind"]
        if abs(off - count / 4) <= _SIDE * count:
            side = "" if self.own["at side"].split()[-1] in self.words(record).lower() else self.own["at side"]
            said = self.from_middle(record.spot.part, [off], count)
            return ", ".join(w for w in (side, said if plain else self.own["its middle"].format(what=said)) if w)
        said = self.from_middle(record.spot.part, [off], count)
        return said if plain else self.own["its middle"].format(what=said)

    def from_middle(self, part: str, offs: Sequence[float], count: int) -> str:
        """So many stitches, or from so many to so many, from the nearer middle: of front or back, of top or underside."""
        far = float(np.mean(offs)) > count / 4 + 0.5
        exact = sorted(count / 2 - o if far else o for o in offs)
        found = [round(o) for o in exact]
        n = str(found[0]) if found[0] == found[-1] else f"{found[0]}–{found[-1]}"
        if len(exact) == 1 and abs(exact[0] % 1.0 - 0.5) < 0.1:
            n = f"{int(exact[0])}½"
        key = ("off under" if far else "off top") if self._lies(part) else ("off back" if far else "off front")
        return self.own[key.replace("off", "off one") if n == "1" else key].format(n=n)

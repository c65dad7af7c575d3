"""Of model: what a maker is told beside the rounds of a pattern that was made from a model, in words and whole numbers."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from itertools import combinations, groupby

import numpy as np

from tambour.core.check import Array
from tambour.crochet.finish.placing import AROUND, frames, sides
from tambour.crochet.finish.sewing import end_of
from tambour.crochet.graph.spots import Spots
from tambour.crochet.language.finishes import Finish, Placed
from tambour.crochet.maker.materials import materials
from tambour.crochet.page.placed import Spoken
from tambour.crochet.page.plain import reach
from tambour.crochet.page.wording import Row, Words
from tambour.crochet.piece import Plush
from tambour.crochet.words.phrases import WAYS, Phrases, number
from tambour.weights import WEIGHTS

LEVEL = 0.96
"""A place is on top, or underneath, where its fabric is so level (the cosine of its slope)."""
BESIDE = 8
"""The middle between the two of a pair is the middle of a side if it is no farther from it than one of so many shares of the round."""
FEW = 5
"""A part of fewer rounds is stuffed at its end."""
_RIGHT = {"mid back": -1.0}
"""Which way along x is the right of a side of a toy, as one sees it; 1 unless said."""


def of_model(piece: Plush) -> bool:
    """Whether a piece's pattern was made from a model."""
    return piece.aim is not None and len(piece.aim.goals) > 0


def dressed(made: Words, piece: Plush) -> Words:
    """The words of such a pattern with materials, size and gauge, when it is stuffed and fastened off, and where parts are sewn on."""
    sewn = Sewn(piece, made)
    finish = tuple(
        (sewn.said(record) if isinstance(record, Placed) else "") or words
        for record, words in zip(piece.built.pattern.finish, made.finish)
    )
    high = float(np.ptp(piece.positions[:, 1])) / 10.0
    tall = made.terms.page["tall"].format(cm=f"{high:.1f}", inch=f"{high / 2.54:.1f}")
    said = [(words, meaning) for words, meaning in _explained(made) if any(words in line for line in finish)]
    return replace(
        made,
        materials=_materials(made, piece),
        gauge=_gauge(made, piece),
        size=tall,
        parts=noted(made, piece).parts,
        finish=finish,
        abbreviations=(*made.abbreviations, *said),
    )


def noted(made: Words, piece: Plush) -> Words:
    """The words with what is said between the rounds: when it is stuffed, which stitch is the middle of the front, how it ends."""
    sewn = Sewn(piece, made)
    return replace(
        made,
        parts=tuple(
            replace(part, lines=_rows(part.lines, part.part, sewn, made)) if part.part >= 0 else part
            for part in made.parts
        ),
    )


def spoken(piece: Plush, made: Words) -> Callable[[Sequence[Finish]], list[str]]:
    """Says finishing records as :class:`tambour.crochet.page.placed.Spoken` does, but seams of a model's parts with their stitches."""
    sewn, others = Sewn(piece, made), Spoken(piece.built, made.terms)

    def said(records: Sequence[Finish]) -> list[str]:
        lines: list[str] = []
        for of, group in groupby(records, lambda r: bool(isinstance(r, Placed) and sewn.said(r))):
            mine = list(group)
            lines += [sewn.said(r) for r in mine if isinstance(r, Placed)] if of else others(mine)
        return lines

    return said


def _explained(made: Words) -> list[tuple[str, str]]:
    """What sentences of seams mean by a word, as a list of abbreviations explains it."""
    page = made.terms.page
    pairs = [line.partition(" = ") for line in page["seams mean"].split(";")]
    return [(said.strip(), meaning.strip()) for said, _, meaning in pairs]


def _materials(made: Words, piece: Plush) -> tuple[str, ...]:
    """Yarn and how much of it, hook, eyes, stuffing."""
    found, terms, page = materials(piece), made.terms, made.terms.page
    kind = terms.yarns.get(piece.gauge.weight, WEIGHTS[piece.gauge.weight].name)
    metres = sum(yarn["metres"] for yarn in found["yarn"])
    much = f"{metres:.0f} m" + (f" ({metres / 0.9144:.0f} yd)" if terms.inches else "")
    lines = [f"{terms.word('yarn')}: {page['yarn about'].format(much=much, yarn=kind)}"]
    lines.append(f"{terms.word('hook')}: {number(piece.gauge.hook)} mm")
    eyes = [
        page["eye" if e["count"] == 1 else "eyes"].format(n=e["count"], size=number(e["size_mm"]))
        for e in found["eyes"]
    ]
    lines += [f"{terms.word('eyes')}: {'; '.join(eyes)}"] if eyes else []
    fill = found["stuffing"]
    if fill["grams"] > 0.05:
        grams, litres = f"{max(1.0, fill['grams']):.0f}", f"{fill['litres']:.2g}"
        lines.append(f"{page['stuffing']}: {page['fill'].format(grams=grams, litres=litres)}")
    return tuple(lines)


def _gauge(made: Words, piece: Plush) -> str:
    wide, high = (number(float(f"{100.0 / size:.5g}")) for size in (piece.gauge.width, piece.gauge.height))
    return f"{wide} {made.terms.word('sc')} x {high} {made.terms.word('round')} = 10 cm"


def _rows(rows: tuple[Row, ...], part: int, sewn: Sewn, made: Words) -> tuple[Row, ...]:
    """The lines of a part with when it is stuffed, where the middle of its front is, and how it ends."""
    page, graph = made.terms.page, sewn.spots.built.graph
    notes: dict[int, list[str]] = {}
    worked = [k for k, row in enumerate(rows) if row.label]
    told = made.terms.sentences["stuff medium"].capitalize() + "."
    if graph.parts[part].stuffing > 0.0 and worked and all(row.words != told for row in rows):
        inside = reach([(row.count, bool(row.label)) for row in rows])
        at = next((k for k in worked if rows[k].number >= FEW), worked[-1])
        notes.setdefault(min(at, inside) if inside >= 0 else at, []).append(page["stuff now"])
    for level, said in sewn.middles(part):
        at = next((k for k in worked if rows[k].number >= level), worked[-1])
        notes.setdefault(at, []).append(said)
    if len(sewn.spots.rim(part)):
        notes.setdefault(len(rows) - 1, []).append(page["leave tail"])
    lines: list[Row] = []
    for k, row in enumerate(rows):
        lines += [row, *(Row("", f"*{said[:1].upper()}{said[1:]}.*") for said in notes.get(k, ()))]
    return tuple(lines)


def _twins(one: Placed, other: Placed) -> bool:
    """Whether two parts are a pair sewn on in one round of one part."""
    (name, _, copy), (twin, _, second) = one.part.rpartition("."), other.part.rpartition(".")
    where, there = one.spot, other.spot
    return name == twin != "" and copy != second and (where.part, where.round) == (there.part, there.round)


class Sewn:
    """Says where the parts of a piece are sewn on: the rounds that an end lies over, and how far it is from the middle of a side."""

    def __init__(self, piece: Plush, made: Words) -> None:
        self.built, self.x, self.page, self.stitch = piece.built, piece.positions, made.terms.page, piece.stitch
        self.spots = Spots(piece.built)
        copies = {s.name: s.copies for s in piece.built.pattern.parts if s.name}
        self.phrases = Phrases(made.terms, copies, {})
        self._seams = [f for f in piece.built.pattern.finish if isinstance(f, Placed)]

    def said(self, record: Placed) -> str:
        """The sentence of a part sewn on; "" where it has no words for its place or its angles."""
        spot = record.spot
        if spot.stitch is None or spot.stitch % 1.0 or spot.round % 0.5:
            return ""
        pair = [spot, *(other.spot for other in self._seams if _twins(record, other))]  # one wording for both
        up = float(frames(self.spots, self.x, pair).normals[:, 1].mean())
        ways = WAYS[1] if up > LEVEL else WAYS[2] if up < -LEVEL else WAYS[0]
        where = ", ".join(said for said in (self._rounds(record), self._side(record)) if said)
        words = self.phrases.sewn(record, where, ways) or ""
        return words[:1].upper() + words[1:] + "." if words else ""

    def _rounds(self, record: Placed) -> str:
        """The rounds that an end lies over, whole ones."""
        part, middle = self.spots.parts[record.spot.part], record.spot.round
        half = 0.5 * len(end_of(self.built, self.spots, record).nodes) / math.pi * self.stitch[0] / self.stitch[1]
        reach_ = max(round(half - middle % 1.0), 0)
        low, high = math.floor(middle) - reach_, math.ceil(middle) + reach_
        mine = self.spots.rounds_of(part)
        if record.flat or low < min(mine) or high > max(mine) or low == high:
            low, high = math.floor(middle), math.ceil(middle)
        if low == high:
            return self.phrases.say("at round", round=low, stitch=None, front=None)
        return self.phrases.say("at between", round=low, next=high, stitch=None, front=None)

    def _ring(self, part: int, number: int) -> tuple[Array, dict[str, int]] | None:
        """The stitches of a round, and of the sides that it has the stitch in the middle of each, from 0."""
        k = self.spots.round_at(part, number)
        nodes = self.spots.stitches(k) if k is not None else np.zeros(0, int)
        if len(nodes) < 3:
            return None
        off = self.x[nodes] - self.x[nodes].mean(0)
        found = {side: int((off * way).sum(1).argmax()) for side, way in sides(self.x[nodes]).items()}
        return (
            (nodes, {side: self._halfway(part, number, i, len(nodes)) for side, i in found.items()}) if found else None
        )

    def _halfway(self, part: int, number: int, middle: int, n: int) -> int:
        """The ``middle`` of a round of ``n`` stitches, or the stitch near it that is as far from the one of a pair as from the other."""
        sums = {
            (int(one.spot.stitch) + int(two.spot.stitch) - 2) % n
            for one, two in combinations(self._seams, 2)
            if one.spot.stitch is not None and two.spot.stitch is not None and _twins(one, two)
            if self.spots.parts[one.spot.part] == part and math.floor(one.spot.round) == number
        }
        near = sorted(range(-max(1, n // BESIDE), max(1, n // BESIDE) + 1), key=abs)
        return next(((middle + k) % n for k in near if 2 * (middle + k) % n in sums), middle)

    def _side(self, record: Placed) -> str:
        """How many stitches it is from the middle of the nearer side."""
        ring = self._ring(self.spots.parts[record.spot.part], math.floor(record.spot.round))
        if ring is None or record.spot.stitch is None:
            return ""
        nodes, middles = ring
        n, at = len(nodes), int(record.spot.stitch) - 1
        off = {side: (at - i + n // 2) % n - n // 2 for side, i in middles.items()}
        first, other = off
        side = first if abs(off[first]) <= AROUND * n else other  # a pair is told from one side
        what = self.page[side]
        if not off[side]:
            return self.page["at mid"].format(what=what)
        way = float(self.x[nodes[at % n], 0] - self.x[nodes[middles[side]], 0]) * _RIGHT.get(side, 1.0)
        key = "right of" if way > 0.0 else "left of"
        one = abs(off[side]) == 1
        return self.page[key.replace(" of", " one") if one else key].format(n=abs(off[side]), what=what)

    def middles(self, part: int) -> list[tuple[int, str]]:
        """After which round it is said which stitch is the middle of a side: the lowest that something is sewn over."""
        levels = [
            math.floor(f.spot.round)
            for f in self.built.pattern.finish
            if isinstance(f, Placed) and self.spots.parts[f.spot.part] == part
        ]
        ring = self._ring(part, min(levels)) if levels else None
        if ring is None:
            return []
        where = self.phrases.say("at round", round=min(levels), stitch=None, front=None)
        side, i = next(iter(ring[1].items()))
        return [(min(levels), self.page["mid is"].format(what=self.page[side], n=i + 1, round=where))]

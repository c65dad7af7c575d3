"""Spots: a round and a stitch as a place on the fabric; which numbers the rounds bear; what is wrong with a spot."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from itertools import pairwise

import numpy as np

from tambour.core.check import Array
from tambour.core.errors import Problem
from tambour.core.graph import JOIN, ROOT, TIP, StitchGraph
from tambour.crochet.graph.built import Built
from tambour.crochet.graph.lids import lids
from tambour.crochet.graph.moment import Round
from tambour.crochet.language.finishes import Finish, Spot, spots_of

MOSTLY = 0.25
"""The first stretch of a part that has this share of its nodes is the part; what hangs together with nothing of it is not."""
LEFT_OFF = 2
"""A last round of so many stitches on a wide one is how its yarn is left off."""
SLANT = -0.15
"""How far a joined round of a stuffed part comes to lie from where its stitches stand over those below, in stitches: measured
on forty parts that were settled, 0.11 to 0.17 in joined rounds, 0.00 to 0.05 in spirals."""
LEAST = 12
"""Rounds of fewer stitches turn with those about them."""
FLAPPED, FREE = 0.6, 0.3
"""A round has so many of the stitches of the widest one, and leaves so many of them free, that flaps are worked on."""
GATHERED = 8
"""An open end of so few stitches is drawn together."""


@dataclass(frozen=True, slots=True)
class Place:
    """A point of the fabric: the mean of ``nodes`` by ``weights``, which sum to 1; ``opening``: the middle of a rim."""

    nodes: tuple[int, ...]
    weights: tuple[float, ...]
    opening: bool = False


class Spots:
    """The rounds of a pattern that was worked, by part and by the number that is written."""

    def __init__(self, built: Built) -> None:
        self.built = built
        self.numbers = [r.number for r in built.rounds]
        self._at: dict[tuple[int, int], list[int]] = {}
        self._open: dict[int, list[Array]] = {}
        self._faces: list[Array] = []
        self._rims: dict[int, Array] = {}
        self._begun: dict[int, Array] = {}
        self._ends: dict[int, int] = {}
        self._numbers: dict[int, list[int]] = {}
        self._standing: dict[tuple[int, int], tuple[Array, Array]] = {}
        self._stitches: dict[int, Array] = {}
        self._fronts: dict[int, float] = {}
        self._ups: dict[int, str] = {}
        made: dict[int, int] = {}  # part → its last round with stitches
        into = np.diff(built.graph.anchor_offsets)
        for k, (round_, number) in enumerate(zip(built.rounds, self.numbers)):
            if round_.aside:
                continue
            if round_.count > 0 or len(self.stitches(k)):
                made[round_.part] = k
            if (round_.part, number) in self._at and not into[round_.first : round_.last].any():
                continue  # chains over to another edge bear no number of their own
            if round_.part in made:
                # A round of no stitch, chains that lift and a turn, is a place all the same: it lies on the one below.
                self._at.setdefault((round_.part, number), []).append(made[round_.part])

    @cached_property
    def parts(self) -> dict[str, int]:
        """Name of a part, as patterns call it → its index."""
        known: dict[str, int] = {}
        for k, fact in enumerate(self.built.parts):
            section = self.built.pattern.parts[fact.section]
            known[f"{section.name}.{fact.copy}"] = k
            if section.copies == 1:
                known[section.name] = k
        return known

    def up(self, part: int) -> str | None:
        """Which way a part stands, as far as that is known: its end on top, its start, or on its side."""
        return self._ups.get(part) or self.built.pattern.parts[self.built.parts[part].section].up

    def stand(self, part: int, up: str) -> None:
        """Takes a part to stand so: what lies with its belly below is laid out anew."""
        if self.up(part) != up:
            self._ups[part] = up
            for known in ("layout", "turns", "_wandered"):
                self.__dict__.pop(known, None)
            self._fronts.clear()

    @cached_property
    def layout(self) -> Array:
        """Where the rounds were laid out (N, 3), in stitches, before anything settled: every part by itself. Of a printed toy
        as their seams will run: what hands sew is put where it looks right, however a seam has wandered."""
        from tambour.crochet.graph.sided import turned_by

        return turned_by(self, self._wandered, self.turns)

    @cached_property
    def turns(self) -> list[tuple[int, int, float]]:
        """How parts of a printed toy are turned so that the legs that they are shared out between are at their sides."""
        from tambour.crochet.graph.sided import turns

        return turns(self, self._wandered) if self.built.pattern.terms else []

    @cached_property
    def _wandered(self) -> Array:
        """Where rounds were laid out (N, 3), of a printed toy as their seams wander."""
        from tambour.crochet.graph.sided import sided

        x = sided(self, _laid_out(self.built.graph).copy())
        return self._slanted(x) if self.built.pattern.terms else x

    def _slanted(self, x: Array) -> Array:
        """``x`` with every joined round of a stuffed part turned as far as seams of joined rounds wander."""
        graph, x = self.built.graph, x.copy()
        joins = graph.edges[graph.edge_kind == JOIN, 0]
        joined = set(zip(graph.part[joins].tolist(), graph.round[joins].tolist()))
        wide: dict[int, list[Round]] = {}
        for r in self.built.rounds:
            if not r.aside and r.last + 1 - r.first >= LEAST:
                wide.setdefault(r.part, []).append(r)
        for part, p in enumerate(graph.parts):
            if p.stuffing <= 0.0 or self.in_rows[part]:
                continue
            turns, weights = [0.0], [0.0]
            rings: list[tuple[slice, Array, Array]] = []
            if not any((part, int(graph.round[r.first])) in joined for r in wide.get(part, ())):
                continue
            for r in wide[part]:
                nodes = slice(r.first, r.last + 1)
                middle = x[nodes].mean(0)
                off = (x[nodes] - middle)[:, [0, 2]]
                wanders = (part, int(graph.round[r.first])) in joined
                turns.append(turns[-1] + (SLANT * 2.0 * math.pi / len(off) if wanders else 0.0))
                weights.append(float((off**2).sum()))
                rings.append((nodes, middle, off))
            mean = float(np.average(turns, weights=weights))
            for turn, (nodes, middle, off) in zip(turns[1:], rings):
                c, s = math.cos(turn - mean), math.sin(turn - mean)
                a, b = off.T
                x[nodes, 0], x[nodes, 2] = middle[0] + c * a - s * b, middle[2] + s * a + c * b
        return x

    @cached_property
    def folded(self) -> Array:
        """Which nodes (N,) are worked through both layers of an opening that was laid flat."""
        from tambour.crochet.graph.ovals import layers

        return layers(self.built.graph)

    @cached_property
    def in_rows(self) -> Array:
        """Which parts (P,) are worked in rows."""
        from tambour.crochet.graph.layout import in_rows

        return in_rows(self.built.graph)

    def stitches(self, k: int) -> Array:
        """The nodes of round ``k`` (an index of Built.rounds) that count, in order: lifting chains left out. Not to be written."""
        if k not in self._stitches:
            self._stitches[k] = nodes = self._counted(k)
            nodes.setflags(write=False)
        return self._stitches[k]

    def _counted(self, k: int) -> Array:
        r, graph = self.built.rounds[k], self.built.graph
        nodes = np.arange(r.first, r.last + 1)
        spare = len(nodes) - r.count
        if spare > 0:
            chains = np.flatnonzero(np.diff(graph.anchor_offsets[r.first : r.last + 2]) == 0)[:spare]
            nodes = np.delete(nodes, chains)
        return nodes

    def last(self, part: int) -> int:
        """The last round of a part, an index of Built.rounds."""
        end = self._end(part)
        mine = [(r.first, k) for k, r in enumerate(self.built.rounds) if r.part == part and not r.aside]
        return max((k for first, k in mine if first <= end), default=mine[-1][1])

    def rounds_of(self, part: int) -> list[int]:
        """The numbers of a part's rounds, in order; those of stray rings are none of it."""
        if part not in self._numbers:
            end = self._end(part)
            mine = [(r.first, n) for r, n in zip(self.built.rounds, self.numbers) if r.part == part and not r.aside]
            self._numbers[part] = [n for first, n in mine if first <= end] or [n for _, n in mine]
        return self._numbers[part]

    def round_at(self, part: int, number: int) -> int | None:
        """The round of a part that bears ``number``: the last, if there are several; None where there is none.

        Of a round that made no stitch it is the one below."""
        found = self._at.get((part, number))
        return found[-1] if found else None

    def _special(self, part: int, number: int) -> int | None:
        """The ring's root for the number before the first round's, the tip for the one after the last's."""
        p, graph = self.built.graph.parts[part], self.built.graph
        mine = self.rounds_of(part)
        if not mine:
            return None
        kind = ROOT if number == min(mine) - 1 else TIP
        if kind == TIP and number != max(mine) + 1:
            return None
        nodes = np.flatnonzero(graph.peculiarity[p.start : p.end] == kind)
        return p.start + int(nodes[0 if kind == ROOT else -1]) if len(nodes) else None

    def opening(self, part: int, number: float) -> Array:
        """The rim of an open part, in the order of work: ``number`` is the one after its last round's, or before its first's."""
        mine = self.rounds_of(part)
        if not mine or self.in_rows[part] or number not in (min(mine) - 1, max(mine) + 1):
            return np.zeros(0, int)
        return self.rim(part) if number > max(mine) else self.begun(part)

    def place(self, spot: Spot) -> Place:
        """Where a spot is; it must be one that :func:`problems` has nothing against."""
        part = self.parts[spot.part]
        opening = self.opening(part, spot.round)
        if len(opening):
            return Place(tuple(opening.tolist()), (1.0 / len(opening),) * len(opening), True)
        low, share = math.floor(spot.round), spot.round - math.floor(spot.round)
        k, node = self.round_at(part, low), self._special(part, low)
        at: dict[int, float] = {}
        index = None
        if k is not None:
            index = self._index(k, spot.stitch)
            self._add(at, k, index, 1.0 - share)
        elif node is not None:
            at[node] = 1.0 - share
        if share:
            above, tip = self.round_at(part, low + 1), self._special(part, low + 1)
            if above is not None:
                free = spot.stitch is None or k is None
                self._add(at, above, self._index(above, spot.stitch) if free else self._above(k, above, index), share)
            elif tip is not None:
                at[tip] = at.get(tip, 0.0) + share
        kept = {n: w for n, w in at.items() if w > 0.0}
        return Place(tuple(kept), tuple(kept.values()))

    def _index(self, k: int, stitch: float | None) -> float:
        """Position in round ``k``, from 0: of a stitch, or of the middle of the front."""
        return self.front(k) if stitch is None else stitch - 1.0

    def front(self, k: int) -> float:
        """Position in round ``k``, from 0, of the middle of the front."""
        if k not in self._fronts:
            self._fronts[k] = self._front(k)
        return self._fronts[k]

    def _front(self, k: int) -> float:
        nodes = self.stitches(k)
        n = len(nodes)
        if self.in_rows[self.built.rounds[k].part] or n < 3:
            return 0.5 * (n - 1)
        x = self.layout[nodes]
        off = x - x.mean(0)
        angle = np.arctan2(off[:, 0], off[:, 2])  # 0 towards the front
        after = np.roll(angle, -1)
        for i in np.flatnonzero((np.minimum(angle, after) <= 0) & (np.maximum(angle, after) > 0)):
            if abs(angle[i] - after[i]) < math.pi:
                return float(i + angle[i] / (angle[i] - after[i]))
        return 0.5 * n

    def _add(self, at: dict[int, float], k: int, index: float, weight: float) -> None:
        """Adds the point at ``index`` of round ``k`` to ``at``, between its two stitches."""
        nodes = self.stitches(k)
        n = len(nodes)
        if self.in_rows[self.built.rounds[k].part]:
            index = min(max(index, 0.0), n - 1.0)
        i, share = math.floor(index), index - math.floor(index)
        for node, w in ((int(nodes[i % n]), 1.0 - share), (int(nodes[(i + 1) % n]), share)):
            at[node] = at.get(node, 0.0) + w * weight

    def _above(self, k: int | None, above: int, index: float | None) -> float:
        """The position in round ``above`` that stands on position ``index`` of round ``k``."""
        assert k is not None and index is not None
        if (k, above) not in self._standing:
            self._standing[k, above] = self._stands(k, above)
        below, over = self._standing[k, above]
        if not len(below):
            return (index + 0.5) / len(self.stitches(k)) * len(self.stitches(above)) - 0.5
        return float(np.interp(index, below, over))

    def _stands(self, k: int, above: int) -> tuple[Array, Array]:
        """Positions in round ``k``, rising, and those in round ``above`` that stand on them, over three turns."""
        graph, lower, upper = self.built.graph, self.stitches(k), self.stitches(above)
        n, rank = len(lower), {int(node): i for i, node in enumerate(lower)}
        stands: list[tuple[float, int]] = []  # position below, position above
        for j, node in enumerate(upper.tolist()):
            under = graph.anchors[graph.anchor_offsets[node] : graph.anchor_offsets[node + 1]]
            found = [rank[int(a)] for a in under if int(a) in rank]
            if found:
                # A decrease over the last and the first stitch stands between them, not in the middle of the round.
                found = [f + n if f < found[0] - n / 2 else f for f in found]
                stands.append((sum(found) / len(found), j))
        if not stands:
            return np.zeros(0), np.zeros(0)
        below = np.unwrap([s for s, _ in stands], period=n)
        over = np.array([j for _, j in stands], float)
        # Stitches of an increase share an anchor: they stand beside each other on it.
        for value in np.unique(below):
            same = np.flatnonzero(below == value)
            if len(same) > 1:
                below[same] += 0.5 * ((np.arange(len(same)) + 0.5) / len(same) - 0.5)
        turns = (-1, 0, 1)
        return np.concatenate([below + t * n for t in turns]), np.concatenate([over + t * len(upper) for t in turns])

    # -- open edges -----------------------------------------------------------------------------------------------

    def _loops(self, part: int) -> list[Array]:
        """The edges of a part's shell, each all round: nodes in order."""
        if part not in self._open:
            faces, found = self.faces(part), []
            if len(faces):
                first = int(faces.min())
                _, _, offsets, nodes = lids(faces - first, np.zeros(len(faces), np.int32), int(faces.max()) - first + 1)
                found = [nodes[a:b] + first for a, b in pairwise(offsets)]
            self._open[part] = found
        return self._open[part]

    def faces(self, part: int) -> Array:
        """The faces (F, 3) of a part's shell."""
        if not self._faces:
            faces = self.built.graph.faces[self.built.shell]
            of = self.built.graph.part[faces[:, 0]]
            order = np.argsort(of, kind="stable")
            ends = np.searchsorted(of[order], np.arange(len(self.built.graph.parts) + 1))
            self._faces = [faces[order[a:b]] for a, b in pairwise(ends)]
        return self._faces[part]

    def _end(self, part: int) -> int:
        """The last node of a part; of one that hangs together with nothing of the rest, a stray ring, that of the rest;
        and before the stitch or two by which an open rim is left smooth, though the text counts them as a round."""
        if part not in self._ends:
            self._ends[part] = end = whole(self.built.graph, part)[1] - 1
            mine = [r for r in self.built.rounds if r.part == part and not r.aside and r.first <= end]
            while len(mine) > 1 and mine[-1].count <= LEFT_OFF and self.built.pattern.terms:
                mine.pop()
            if mine and mine[-1].count >= 2 * GATHERED and self.built.graph.peculiarity[end] != TIP:
                self._ends[part] = min(end, mine[-1].last)
        return self._ends[part]

    @cached_property
    def _worked_into(self) -> Array:
        """Which nodes (N,) stitches are worked into."""
        graph = self.built.graph
        made = np.zeros(len(graph), bool)
        made[graph.anchors] = True
        return made

    def edge(self, part: int, at: int | None = None) -> Array:
        """The edge of a part that its last stitch (or node ``at``) is on, all round: nodes in order; empty where none is."""
        graph = self.built.graph
        p = graph.parts[part]
        end = self._end(part)
        if at is None and p.end > p.start and graph.peculiarity[end] == TIP:
            return np.zeros(0, int)
        node = end if at is None else at
        return np.asarray(next((r for r in self._loops(part) if node in r), np.zeros(0, int)), int)

    def sewn_rim(self, part: int) -> Array:
        """The edge that a part in rounds is sewn by: that of its last round, else that of its first; empty where both are closed.

        An end of a few stitches is gathered: a cap that narrows to six is sewn by its brim.
        """
        last, first = self.rim(part), self.begun(part)
        last = last if len(last) or len(first) else self._flapped(part)
        return first if not len(last) or (len(last) <= GATHERED and len(first) >= 2 * len(last)) else last

    def _flapped(self, part: int) -> Array:
        """The last whole round of what flaps are worked on, over some of its stitches: a hat with its ears; empty of what has none."""
        rounds = [k for k, r in enumerate(self.built.rounds) if r.part == part and not r.aside]
        widest = max((self.built.rounds[k].count for k in rounds), default=0)
        if self.in_rows[part] or widest < 2 * GATHERED:
            return np.zeros(0, int)
        for k in reversed(rounds):
            nodes = self.stitches(k)
            if len(nodes) >= FLAPPED * widest and FREE <= float((~self._worked_into[nodes]).mean()) < 1.0:
                return nodes
        return np.zeros(0, int)

    def begun(self, part: int) -> Array:
        """The edge of a part that was worked first, where it is open: a chain joined to a ring; empty where it is closed."""
        if part not in self._begun:
            p = self.built.graph.parts[part]
            rooted = p.end <= p.start or (self.built.graph.peculiarity[p.start : p.end] == ROOT).any()
            self._begun[part] = np.zeros(0, int) if rooted else self.edge(part, p.start)
        return self._begun[part].copy()

    def rim(self, part: int) -> Array:
        """The edge of a part that was worked last, where it is open: nodes in the order of work; empty where it is closed."""
        if part not in self._rims:
            self._rims[part] = self._rim(part)
        return self._rims[part].copy()

    def _rim(self, part: int) -> Array:
        loop = self.edge(part)
        if not len(loop):
            return loop
        end = self._end(part)
        last = int(np.flatnonzero(loop == end)[0])
        loop = np.roll(loop, -1 - last)  # the stitch worked last comes last
        if len(loop) > 2 and loop[0] == end - 1:
            loop = np.append(loop[:-1][::-1], loop[-1])
        # Where a spiral ends the edge steps down by a stitch that is worked into already: no needle goes there.
        free = loop[~self._worked_into[loop]]
        return np.asarray(free if len(free) > 2 else loop, int)

    # -- what is wrong ----------------------------------------------------------------------------------------------

    def problems(self, finishes: Sequence[Finish]) -> Iterator[Problem]:
        """What is wrong with the spots of ``finishes``: rounds and stitches that are not there."""
        seen: set[Spot] = set()
        for finish in finishes:
            for spot in spots_of(finish):
                if spot not in seen and spot.part in self.parts:
                    seen.add(spot)
                    yield from self._problem(spot)

    def problems_of(self, spot: Spot) -> list[Problem]:
        """What is wrong with a spot."""
        return list(self._problem(spot))

    def _problem(self, spot: Spot) -> Iterator[Problem]:
        part, text = self.parts[spot.part], self.built.pattern.text
        mine = self.rounds_of(part)
        wanted = [math.floor(spot.round), math.ceil(spot.round)]
        there = [
            self.round_at(part, n) is not None
            or self._special(part, n) is not None
            or (n == spot.round and len(self.opening(part, n)) > 0)
            for n in wanted
        ]
        if not mine or not all(there):
            hint = f"its rounds are {min(mine)} to {max(mine)}" if mine else "it has no rounds"
            broken = [n for n, found in zip(wanted, there) if not found and mine and min(mine) < n < max(mine)]
            if broken:
                hint = f"round {broken[0]} does not come round to where it began: see its count"
            yield Problem(f'"{spot.part}" has no round {spot.round:g}', hint, spot.span, text)
            return
        if len(self._at.get((part, wanted[0]), ())) > 1:
            many = len(self._at[part, wanted[0]])
            hint = "the last one is taken; number the rounds without repeats"
            yield Problem(f'"{spot.part}" has {many} rounds {wanted[0]}', hint, spot.span, text, warning=True)
        counts = [len(self.stitches(k)) for n in wanted if (k := self.round_at(part, n)) is not None]
        if spot.stitch is not None and counts and spot.stitch >= max(counts) + 1:
            message = f'round {spot.round:g} of "{spot.part}" has {max(counts)} stitches, not {spot.stitch:g}'
            yield Problem(message, "count from its first stitch, which is 1", spot.span, text)


@lru_cache(maxsize=2)
def _laid_out(graph: StitchGraph) -> Array:
    """First positions (N, 3), which stay the same whichever way parts stand and whatever becomes known of them. Not to be written."""
    from tambour.crochet.graph.layout import rounds

    x = rounds(graph, graph.rest / graph.stitch_width)
    x.setflags(write=False)
    return x


@lru_cache(maxsize=2)
def spots_in(built: Built) -> Spots:
    """The spots of ``built``, found once for all who ask one after the other while it is read."""
    return Spots(built)


def whole(graph: StitchGraph, part: int) -> tuple[int, int]:
    """The nodes of a part, from the first to the one behind the last, without those that hang together with nothing of the
    rest: stray rings, which the reader took for rounds of it."""
    p = graph.parts[part]
    later, earlier = graph.edges[:, 0], graph.edges[:, 1]
    inside = (earlier >= p.start) & (later < p.end)
    n = p.end - p.start + 1
    # How many edges lead over the gap before each node.
    over = np.bincount(earlier[inside] - p.start + 1, minlength=n) - np.bincount(
        later[inside] - p.start + 1, minlength=n
    )
    cuts = [0, *(np.flatnonzero(np.cumsum(over)[1:-1] == 0) + 1).tolist(), p.end - p.start]
    pieces = list(pairwise(cuts))
    least = MOSTLY * (p.end - p.start)
    first, last = next((ends for ends in pieces if ends[1] - ends[0] >= least), pieces[0])
    return p.start + first, p.start + last

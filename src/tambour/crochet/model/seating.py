"""Seating: parts sewn on, brought to rest, and tried elsewhere, each keeping the best it had, until the whole lies best upon its model."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

import numpy as np

from tambour.core.check import Array
from tambour.crochet.model.assemble import Key, Nudges, Piece, Put, chain, placed
from tambour.crochet.model.distance import Target
from tambour.crochet.model.nudged import Rest, alike, between, nudged, rested
from tambour.crochet.model.rounds import Round
from tambour.crochet.model.settled import settled
from tambour.crochet.model.tips import Mirror
from tambour.geometry.motion import fit, length, turned

if TYPE_CHECKING:
    from tambour.crochet.finish.shape import Known
    from tambour.crochet.language.finishes import Placed
    from tambour.crochet.params import CrochetParams

ALL = 4
"""How often the parts are put together, all aimed by what all gave way."""
SOUGHT, SINGLY, PAIRED = 4, 7, 5
"""How often each part, or each pair, is then tried elsewhere, all at once, and keeps the best it had; and how often, after that, one by itself,
kept where the whole comes nearer; and how often of a toy that has pairs."""
FREE, SINGLY_FREE, SAME = 3, 8, 0.02
"""So many tries of either kind a toy with pairs is then given with words of their own for the two of each, and what these have to win, in stitches:
bodies at rest are not quite their own mirror image, as rounds climb by half a row from one side to the other, nor are two limbs that are worked
the same way round each other's, so that what is said alike lies less alike (over five models .40 stitch in the same words, and .36 without)."""
LARGE = 4000
"""Stitches of a toy that is tried fewer times than a smaller one, as its simulation takes longer."""
WORTH = 0.3
"""How much farther off than it was at its best, in stitches, a part may be likely to come, to be tried there: how it gives way is other in
another place."""
ROOTED, ROWS, LESS, KEPT = (1, 3), 3, 1, 4
"""After so many times parts are made longer, or shorter, by so many rounds at the most; so many rounds are left of one at the least."""
AWAY = 0.4
"""By how much two parts whose seams are in each other's way are moved apart at once, each, in stitches."""


def seated(
    pieces: list[Piece], target: Target, params: CrochetParams, stitch: tuple[float, float], plane: Mirror | None
) -> tuple[list[Piece], list[str], list[float]]:
    """The pieces, made longer where they are sewn on deeper than on the model and shorter where they stand out, the lines that sew them on, corrected by how the
    whole comes to rest, and the mean distances on the way.

    plane : across which the model is its own mirror image, left and right; None where it is not
    """
    if all(base is None for p in pieces for base in p.bases):
        return pieces, [], []
    seats = Seats(pieces, target, params, stitch, plane)
    nudges: Nudges = {}
    far: dict[Key, float] = {}
    pairs = [((k, 0), (k, 1)) for k, p in enumerate(pieces) if p.rounds.copies == 2 and p.bases[0] is not None]
    mirror, spare = plane if pairs else None, 0
    for k in range(ALL):
        if k in ROOTED:
            longer = [
                fitted(p, [far[n, c] for c in range(len(p.goals))], params, stitch) for n, p in enumerate(seats.pieces)
            ]
            if any(one is not p for one, p in zip(longer, seats.pieces)):
                seats.pieces = longer
        aims = nudges if mirror is None else alike(seats.pieces, nudges, mirror)
        put = placed(
            seats.pieces, seats.aimed(aims), mirror, seats.fine, then=seats.had[-1].put.said if seats.had else {}
        )
        if seats.known(put):  # in the same words it comes to rest as it did
            spare += 1
            continue
        now = seats.rest(put, aims, mirror is not None)
        nudges, far = nudged(seats.pieces, now.first, now.x)
    seats.pieces = seats.best.pieces
    many = min(1.0, LARGE / sum(len(g) for p in pieces for g in p.goals))
    singles: list[tuple[Key, ...]] = [(key,) for key in seats.keys]
    both = {key for pair in pairs for key in pair} if mirror is not None else set()
    units = singles if mirror is None else [*pairs, *(one for one in singles if one[0] not in both)]
    sought(seats, units, mirror, max(2, round(SOUGHT * many)) + spare)
    changed(seats, units, mirror, max(2, round((SINGLY if mirror is None else PAIRED) * many)))
    if mirror is not None:
        sought(seats, singles, None, max(2, round(FREE * many)))
        changed(seats, singles, None, max(2, round(SINGLY_FREE * many)))
    return seats.best.pieces, seats.best.put.lines, seats.way


@dataclass(frozen=True, eq=False, slots=True)
class Seat:
    """One way in which all parts were sewn on.

    nudges : how they were aimed; price : what it came to
    """

    pieces: list[Piece]
    put: Put
    rest: Rest
    nudges: Nudges
    price: float


@dataclass(eq=False, slots=True)
class Seats:
    """The ways that parts were sewn on, one after another, and the best of them.

    pieces : as they are sewn on now; had : all ways; away : how parts are moved whose seams were in each other's way
    rests : how parts came to rest before they were sewn on, which is the same wherever that is
    """

    pieces: list[Piece]
    target: Target
    params: CrochetParams
    stitch: tuple[float, float]
    plane: Mirror | None = None
    had: list[Seat] = field(default_factory=list)
    away: dict[Key, Array] = field(default_factory=dict)
    rests: Known = field(default_factory=dict)

    @property
    def fine(self) -> bool:
        """Whether places and angles are as near as can be, not those that there are words for."""
        return self.params.plain_ <= 0.0

    @property
    def keys(self) -> list[Key]:
        """All that is sewn on."""
        return [(k, c) for k, p in enumerate(self.pieces) for c, base in enumerate(p.bases) if base is not None]

    @property
    def best(self) -> Seat:
        """The way of the least price; of several the first."""
        return min(self.had, key=lambda seat: seat.price)

    @property
    def way(self) -> list[float]:
        """The mean distances, in stitches."""
        return [round(seat.rest.far, 4) for seat in self.had]

    def aimed(self, nudges: Nudges) -> Nudges:
        """The nudges, with those that keep seams out of each other's way."""
        return {key: (turn, to + self.away.get(key, 0.0)) for key, (turn, to) in nudges.items()}

    def known(self, put: Put) -> bool:
        """Whether parts were sewn on so before."""
        return any(seat.pieces is self.pieces and seat.put.lines == put.lines for seat in self.had)

    def rest(self, put: Put, nudges: Nudges, same: bool = False) -> Rest:
        """How all comes to rest that is put so. Pairs in the ``same`` words are worth SAME."""
        now = rested(self.pieces, put.lines, put.x, self.target, self.params, self.stitch, self.plane, self.rests)
        self.had.append(Seat(self.pieces, put, now, nudges, now.price - SAME * same))
        self.away = {}
        names = {p.name(c): (k, c) for k, p in enumerate(self.pieces) for c in range(len(p.goals))}
        for one, other in now.crowd:
            a, b = names[one.part], names[other.part]
            here, there = self.pieces[a[0]].bases[a[1]], self.pieces[b[0]].bases[b[1]]
            assert here is not None and there is not None
            step = AWAY * (here - there) / max(float(length(here - there)), 1e-9)
            self.away[a] = self.away.get(a, np.zeros(3)) + step
            self.away[b] = self.away.get(b, np.zeros(3)) - step
        return now


def sought(seats: Seats, units: list[tuple[Key, ...]], plane: Mirror | None, times: int) -> None:
    """Tries every unit, a part or a pair of parts, elsewhere, all at once: where it is the likeliest to come to rest where it belongs,
    gives it way as it did the best time; each keeps the best that it had. In the end all of them are sewn on as was best for each.

    plane : of pairs in the same words, as each other's mirror image
    """
    mine = [seat for seat in seats.had if seat.pieces is seats.pieces]

    def best(unit: tuple[Key, ...]) -> Seat:
        """The way in which a unit lay best."""
        return min(mine, key=lambda seat: sum(seat.rest.off[key] for key in unit))

    for k in range(times + 1):
        aims: Nudges = {}
        last = k == times
        for unit in units:
            seat = best(unit)
            home = nudged(seats.pieces, seat.rest.first, seat.rest.x)[0]
            tries = len(mine) - mine.index(seat)
            for key in unit:
                aims[key] = between(seat.nudges.get(key), home[key], 0.5 ** (tries - 1)) if seats.fine else home[key]
        if plane is not None:
            aims = alike(seats.pieces, aims, plane)
        had = {unit[0]: [seat.put.said for seat in mine] for unit in units}
        stays: dict[Key, Placed] = {}
        then = {key: best(unit).put.said[key] for unit in units for key in unit}
        put = placed(seats.pieces, seats.aimed(aims), plane, seats.fine, {}, had, then)
        for unit in sorted(units, key=lambda unit: len(chain(seats.pieces, unit[0]))):
            seat = best(unit)
            now = float(np.mean([seat.rest.off[key] for key in unit]))
            likely = float(np.mean([put.likely.get(key, 0.0) for key in unit]))
            below = {on for key in unit for on in chain(seats.pieces, key)[:-1]}
            # What it was best on may be sewn on in another way now.
            if (last or likely > now + WORTH) and all(stays.get(on) == seat.put.said[on] for on in below):
                stays |= {key: seat.put.said[key] for key in unit}
                aims |= {key: seat.nudges[key] for key in unit if key in seat.nudges}
        put = placed(seats.pieces, seats.aimed(aims), plane, seats.fine, stays, had, then)
        if seats.known(put):
            break
        seats.rest(put, aims, plane is not None)
        mine.append(seats.had[-1])


def changed(seats: Seats, units: list[tuple[Key, ...]], plane: Mirror | None, times: int) -> None:
    """Tries one unit after another elsewhere in the best toy there is, all others where they are, and keeps what brings the whole nearer; the
    one that lies off by most, for its size, first: what is best for each part is not for all of them, which give way together.

    plane : of pairs in the same words, as each other's mirror image
    """
    same = [seat for seat in seats.had if seat.pieces is seats.pieces]
    if not same:
        return
    now = min(same, key=lambda seat: seat.rest.price)
    had = {unit[0]: [seat.put.said for seat in same] for unit in units}
    size = {(k, c): len(goal) for k, p in enumerate(seats.pieces) for c, goal in enumerate(p.goals)}
    order: list[tuple[Key, ...]] = []
    for _ in range(times):
        if not order:
            order = sorted(units, key=lambda unit: -sum(size[key] * now.rest.off[key] for key in unit))
        unit = order.pop(0)
        home = nudged(seats.pieces, now.rest.first, now.rest.x)[0]
        free = [key for key in now.put.said if set(unit) & {key, *chain(seats.pieces, key)}]
        aims = {**now.nudges, **{key: home[key] for key in free}}
        if plane is not None:
            aims = alike(seats.pieces, aims, plane)
        stays = {key: said for key, said in now.put.said.items() if key not in free}
        put = placed(seats.pieces, seats.aimed(aims), plane, seats.fine, stays, had, now.put.said)
        had[unit[0]].append(put.said)
        if seats.known(put):
            continue
        seats.rest(put, aims, plane is not None)
        if seats.had[-1].rest.price < now.rest.price:
            now = seats.had[-1]


def fitted(piece: Piece, far: list[float], params: CrochetParams, stitch: tuple[float, float]) -> Piece:
    """A piece with as many more plain rounds at its end as its copies lie too deep (``far``, below 0, in stitches), or as many fewer of
    its last ones as they stand out too far: fabric that is stuffed bulges where a limb of the model goes over into its body."""
    row = stitch[1] / stitch[0]
    more = max(min(round(-float(np.mean(far)) / row), ROWS), -LESS)
    kept = len(piece.tried.counts) + min(more, 0)
    held = max((side[0] for one in piece.rounds.threads for side in (one.first, one.second)), default=0)
    if not more or piece.bases[0] is None or (more < 0 and kept < max(KEPT, held)):
        return piece
    counts = piece.tried.counts[:kept]
    last = counts[-1]
    now = replace(piece.rounds, rounds=(*piece.rounds.rounds[: kept - 1], *(Round(("sc",) * last),) * max(more, 0)))
    worked = settled(replace(now, copies=1), params, stitch)

    def grown(goal: Array) -> Array:
        goal = goal[: 1 + sum(counts)]
        ring = goal[-last:]
        ahead = ring.mean(0) - goal[-last - counts[-2] : -last].mean(0)
        ahead = ahead / max(float(length(ahead)), 1e-9)
        return np.concatenate([goal, *(ring + (j + 1) * row * ahead for j in range(more))])

    def lies(old: Array) -> Array:
        many = min(len(old), len(worked.x))
        turn, shift = fit(worked.x[:many], old[:many], np.ones(many))
        return turned(worked.x, turn) + shift

    tried = replace(
        piece.tried,
        rounds=now,
        counts=[*counts, *[last] * max(more, 0)],
        worked=worked,
        goal=grown(piece.tried.goal),
    )
    goals, lain = tuple(map(grown, piece.goals)), tuple(map(lies, piece.lain))
    return replace(piece, rounds=now, tried=tried, goals=goals, lain=lain)

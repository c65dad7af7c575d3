"""Seating: parts sewn on, brought to rest, and moved and turned until the whole lies best upon its model."""

from __future__ import annotations

import itertools
import math
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from tambour.core.check import Array
from tambour.crochet.finish.joining import clashes, prepare
from tambour.crochet.model.assemble import Key, Nudges, Piece, placed
from tambour.crochet.model.distance import Target, distance
from tambour.crochet.model.rounds import Round, pattern
from tambour.crochet.model.settled import settled, together
from tambour.crochet.model.tips import Mirror
from tambour.geometry.crossed import crossed
from tambour.geometry.motion import dot, fit, length, turned

if TYPE_CHECKING:
    from tambour.crochet.language.finishes import Placed
    from tambour.crochet.params import CrochetParams

LOPSIDED, MIRRORED = 9, 3
"""How often the parts are put together, and after that with pairs that say the same angles."""
ALL, ALIKE = 4, 1
"""How often all parts are moved at once, in each; then one at a time, from the best so far: they move one another as they come to rest."""
PAIR = 0.03
"""How much farther off, in stitches, a toy whose pairs say the same angles may be."""
CLASH = 0.03
"""How much farther off, in stitches, a toy may be for two seams that are not in each other's way."""
CROSSED, RESTLESS = 8.0, 0.05
"""The same for fabric that does not pass through itself, times the share of it that does; and for a toy that comes to rest."""
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
    names = {p.name(c): (k, c) for k, p in enumerate(pieces) for c in range(len(p.goals))}
    best: tuple[float, list[Piece], list[str]] | None = None
    way: list[float] = []
    nudges: Nudges = {}
    good: Nudges = {}
    far: dict[Key, float] = {}
    away: dict[Key, Array] = {}
    kept: tuple[Rest, dict[Key, Array]] | None = None
    known: dict[str, Rest] = {}
    for mirrored, times, together_ in [(None, LOPSIDED, ALL), (plane, MIRRORED, ALIKE)][: 1 if plane is None else 2]:
        turns: list[Nudges] | None = None
        if mirrored is not None and kept is not None:
            nudges, away = alike(pieces, good, mirrored), dict(kept[1])
        upto = len(way) + times
        for k in itertools.count():
            if len(way) in ROOTED and known:
                pieces = [
                    fitted(p, [far[n, c] for c in range(len(p.goals))], params, stitch) for n, p in enumerate(pieces)
                ]
                known = {}
            aims = {key: (turn, to + away.get(key, 0.0)) for key, (turn, to) in nudges.items()}
            lines, first = placed(pieces, aims, mirrored is not None, params.plain_ <= 0.0)
            said = "\n".join(lines)
            if said not in known:
                if len(way) == upto:
                    break
                known[said] = rested(pieces, lines, first, target, params, stitch)
                way.append(round(known[said].far, 4))
            now = known[said]
            price = now.price - (PAIR if mirrored is not None else 0.0)
            if best is None or price < best[0]:
                best, good, kept, turns = (price, pieces, lines), nudges, (now, dict(away)), None
            if k + 1 < together_:
                nudges, far, _ = nudged(pieces, now.first, now.x)
            else:
                assert kept is not None
                turns = singly(best[1], kept[0], good) if turns is None else turns
                if not turns:
                    break
                pieces, nudges, away = best[1], turns.pop(0), dict(kept[1])
            if mirrored is not None:
                nudges = alike(pieces, nudges, mirrored)
            for one, other in now.crowd:
                a, b = names[one.part], names[other.part]
                here, there = pieces[a[0]].bases[a[1]], pieces[b[0]].bases[b[1]]
                assert here is not None and there is not None
                step = AWAY * (here - there) / max(float(length(here - there)), 1e-9)
                away[a] = away.get(a, np.zeros(3)) + step
                away[b] = away.get(b, np.zeros(3)) - step
    assert best is not None
    return best[1], best[2], way


@dataclass(frozen=True, eq=False, slots=True)
class Rest:
    """Parts sewn on and at rest together. first, x : (N, 3) as they were put, and at rest; far : the mean distance from the model;
    price : that and what else is wrong; crowd : whose seams are in each other's way."""

    first: Array
    x: Array
    far: float
    price: float
    crowd: list[tuple[Placed, Placed]]


def rested(
    pieces: list[Piece],
    lines: list[str],
    first: Array,
    target: Target,
    params: CrochetParams,
    stitch: tuple[float, float],
) -> Rest:
    """The pieces sewn on as ``lines`` say, which put them at ``first`` (N, 3), at rest."""
    built, x, faces, rests = together(pattern([p.rounds for p in pieces], lines), params, stitch)
    goal = np.concatenate([g for p in pieces for g in p.goals])
    far = distance(target, x, faces, fit(x, goal, np.ones(len(x)))).mean
    joining = prepare(built)
    assert joining is not None
    crowd = clashes(joining)
    price = far + CLASH * len(crowd) + CROSSED * len(crossed(x, faces)) / len(faces)
    return Rest(first, x, far, price + (0.0 if rests else RESTLESS), crowd)


def singly(pieces: list[Piece], now: Rest, nudges: Nudges) -> list[Nudges]:
    """``nudges`` with those of one piece brought home from where it lies ``now``, the one first that lies off by most; then each by
    half of that."""
    home, _, off = nudged(pieces, now.first, now.x)
    order = sorted((k for k in off if off[k] > 0.0), key=lambda k: -off[k])
    return [
        nudges | {key: between(nudges.get(key), aim, step) for key, aim in home.items() if key[0] == k}
        for step in (1.0, 0.5)
        for k in order
    ]


def between(one: tuple[Array, Array] | None, other: tuple[Array, Array], step: float) -> tuple[Array, Array]:
    """A nudge ``step`` of the way from one (None: none) to another."""
    turn, shift = (np.eye(3), np.zeros(3)) if one is None else one
    return turned(turn.T, share(turned(other[0], turn), step)).T, shift + step * (other[1] - shift)


def nudged(pieces: list[Piece], first: Array, x: Array) -> tuple[Nudges, dict[Key, float], dict[int, float]]:
    """Where parts are to be aimed next, so that they come to rest where they belong: as fabric gives way they come to lie elsewhere
    than they were put, and will so again. Also how far out along itself each one lies, and how far off all copies of a piece do.

    first, x : (N, 3) all parts as they were put, and at rest together
    """
    keys = [(k, c) for k, p in enumerate(pieces) for c in range(len(p.goals))]
    ends = np.cumsum([len(pieces[k].goals[c]) for k, c in keys])
    span = {key: slice(end - len(pieces[key[0]].goals[key[1]]), end) for key, end in zip(keys, ends.tolist())}
    made: Nudges = {}
    far, off = dict.fromkeys(keys, 0.0), dict.fromkeys(range(len(pieces)), 0.0)
    for k, c in keys:
        base, goal, on = pieces[k].bases[c], pieces[k].lain[c], pieces[k].onto[c]
        if base is None:
            continue
        # Against what it is sewn to, which may itself not lie where it belongs yet.
        host, even = pieces[on[0]].lain[on[1]], np.ones(len(goal))
        put, own = (
            turned(at[span[k, c]], turn) + shift
            for at in (first, x)
            for turn, shift in [fit(at[span[on]], host, np.ones(len(host)))]
        )
        rim = len(goal) - pieces[k].tried.counts[-1]
        out = goal[0] - goal[rim:].mean(0)
        out = out / max(float(length(out)), 1e-9)
        at_end, whole = (float(dot(own[n].mean(0) - goal[n].mean(0), out)) for n in (slice(rim, None), slice(None)))
        far[k, c] = min(at_end, max(whole, 0.0))
        off[k] += float(length(own - goal).sum())
        turn, shift = fit(put, own, even)
        made[k, c] = turn.T, turned(base - shift, turn.T) - base
    return made, far, off


def alike(pieces: list[Piece], nudges: Nudges, plane: Mirror) -> Nudges:
    """The nudges with those of every pair as each other's mirror image: half of what one wants and half of what the other does."""
    made = dict(nudges)
    for k, piece in enumerate(pieces):
        if piece.rounds.copies == 2 and (k, 1) in nudges:
            (turn, shift), (other, to) = nudges[k, 0], plane.moved(*nudges[k, 1])
            mean = turned(turn.T, share(turned(other, turn), 0.5)).T, 0.5 * (shift + to)
            made[k, 0], made[k, 1] = mean, plane.moved(*mean)
    return made


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


def share(turn: Array, part: float) -> Array:
    """A ``part``, 0 to 1, of a turn (3, 3) about its own axis."""
    angle = math.acos(float(np.clip((np.trace(turn) - 1.0) / 2.0, -1.0, 1.0)))
    skew = turn - turn.T
    axis = np.array([skew[2, 1], skew[0, 2], skew[1, 0]])
    size = float(length(axis))
    if size < 1e-9:
        return turn if part >= 1.0 else np.eye(3)
    n = axis / size
    cross = np.array([[0.0, -n[2], n[1]], [n[2], 0.0, -n[0]], [-n[1], n[0], 0.0]])
    return np.asarray(np.eye(3) + math.sin(part * angle) * cross + (1.0 - math.cos(part * angle)) * (cross @ cross))

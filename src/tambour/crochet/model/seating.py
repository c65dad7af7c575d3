"""Seating: parts sewn on, brought to rest, and moved and turned until the whole lies best upon its model."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from tambour.core.check import Array
from tambour.crochet.finish.joining import clashes, prepare
from tambour.crochet.model.assemble import Key, Nudges, Piece, placed
from tambour.crochet.model.distance import Target, distance
from tambour.crochet.model.rounds import pattern
from tambour.crochet.model.settled import together
from tambour.geometry.crossed import crossed
from tambour.geometry.motion import fit, length, turned

if TYPE_CHECKING:
    from tambour.crochet.params import CrochetParams

MIRRORED, LOPSIDED = 4, 7
"""How often the parts are put together; and after that with what pairs say left to each of the two."""
PAIR = 0.05
"""How much farther off, in stitches, a toy whose pairs say the same angles may be."""
NUDGE = 0.7
"""How much of what a part is off it is moved at once."""
CLASH = 0.03
"""How much farther off, in stitches, a toy may be for two seams that are not in each other's way."""
CROSSED = 2.0
"""The same for fabric that does not pass through itself: times the share of it that does."""
AWAY = 0.4
"""By how much two parts whose seams are in each other's way are moved apart at once, each, in stitches."""


def seated(
    pieces: list[Piece], target: Target, params: CrochetParams, stitch: tuple[float, float], even: bool
) -> tuple[list[str], list[float]]:
    """The lines that sew the parts on, corrected by how the whole comes to rest, and the mean distances on the way.

    even : the model is its own mirror image, left and right
    """
    if all(base is None for p in pieces for base in p.bases):
        return [], []
    goal = np.concatenate([g for p in pieces for g in p.goals])
    names = {p.name(c): (k, c) for k, p in enumerate(pieces) for c in range(len(p.goals))}
    best: tuple[float, list[str]] | None = None
    way: list[float] = []
    nudges: Nudges = {}
    away: dict[Key, Array] = {}
    for mirrored, times in ((True, MIRRORED), (False, LOPSIDED)) if even else ((False, LOPSIDED),):
        seats: dict[Key, Seat] = {}
        for _ in range(times):
            lines = placed(
                pieces, {key: (turn, to + away.get(key, 0.0)) for key, (turn, to) in nudges.items()}, mirrored
            )
            built, x, faces = together(pattern([p.rounds for p in pieces], lines), params, stitch)
            lain = distance(target, x, faces, fit(x, goal, np.ones(len(x))))
            way.append(round(lain.mean, 4))
            joining = prepare(built)
            assert joining is not None
            crowd = clashes(joining)
            price = lain.mean + CLASH * len(crowd) + CROSSED * len(crossed(x, faces)) / len(faces)
            price -= PAIR if mirrored else 0.0
            if best is None or price < best[0]:
                best = price, lines
            nudges = nudged(pieces, x, nudges, seats)
            for one, other in crowd:
                a, b = names[one.part], names[other.part]
                here, there = pieces[a[0]].bases[a[1]], pieces[b[0]].bases[b[1]]
                assert here is not None and there is not None
                step = AWAY * (here - there) / max(float(length(here - there)), 1e-9)
                away[a] = away.get(a, np.zeros(3)) + step
                away[b] = away.get(b, np.zeros(3)) - step
    assert best is not None
    return best[1], way


@dataclass(eq=False, slots=True)
class Seat:
    """How a copy came to lie: the nudge it was aimed by, how far off it came to lie, and what would bring it home.

    aim : the nudge; off : stitches, of its nodes on the average; turn (3, 3), shift (3,) : what mends it; step : how much of
    that is tried next
    """

    aim: tuple[Array, Array]
    off: float
    turn: Array
    shift: Array
    step: float = 1.0


def nudged(pieces: list[Piece], x: Array, nudges: Nudges, seats: dict[Key, Seat]) -> Nudges:
    """Where parts are to be aimed next, so that they come to rest where they belong.

    x : (N, 3) all parts at rest together; nudges : what they were aimed by
    seats : the best that each came to lie so far, brought up to date; a part that came to lie worse goes half the way from there
    """
    keys = [(k, c) for k, p in enumerate(pieces) for c in range(len(p.goals))]
    ends = np.cumsum([len(pieces[k].goals[c]) for k, c in keys])
    lies = {key: x[end - len(pieces[key[0]].goals[key[1]]) : end] for key, end in zip(keys, ends.tolist())}
    made: Nudges = {}
    for k, c in keys:
        base, goal, on = pieces[k].bases[c], pieces[k].lain[c], pieces[k].onto[c]
        if base is None:
            continue
        # Against what it is sewn to, which may itself not lie where it belongs yet.
        host = pieces[on[0]].lain[on[1]]
        turn, shift = fit(lies[on], host, np.ones(len(host)))
        own = turned(lies[k, c], turn) + shift
        off = float(np.sqrt(((own - goal) ** 2).sum(1)).mean())
        best = seats.get((k, c))
        if best is None or off < best.off:
            turn, shift = fit(own, goal, np.ones(len(goal)))
            aim = nudges.get((k, c), (np.eye(3), np.zeros(3)))
            best = seats[k, c] = Seat(aim, off, turn, NUDGE * (base - turned(base - shift, turn.T)))
        else:
            best.step *= 0.5
        made[k, c] = turned(best.aim[0].T, share(best.turn, best.step)).T, best.aim[1] + best.step * best.shift
    return made


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

"""Nudged: how sewn parts give way as they come to rest together, how far off they lie, and where they are aimed against that."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from tambour.core.check import Array
from tambour.crochet.finish.joining import clashes, prepare
from tambour.crochet.model.assemble import Key, Nudges, Piece, chain
from tambour.crochet.model.distance import Target, distance
from tambour.crochet.model.posed import ALONG
from tambour.crochet.model.rounds import pattern
from tambour.crochet.model.settled import together
from tambour.crochet.model.tips import Mirror
from tambour.geometry.closest import nearest, tree
from tambour.geometry.crossed import crossed
from tambour.geometry.motion import dot, fit, length, turned
from tambour.geometry.surface import vertex_normals

if TYPE_CHECKING:
    from tambour.crochet.finish.shape import Known
    from tambour.crochet.language.finishes import Placed
    from tambour.crochet.params import CrochetParams

CLASH = 0.03
"""How much farther off, in stitches, a toy may be for two seams that are not in each other's way."""
CROSSED, RESTLESS = 8.0, 0.05
"""The same for fabric that does not pass through itself, times the share of it that does; and for a toy that comes to rest."""
UNEVEN = 0.05
"""The same for each stitch by which the two of a pair do not lie at rest as each other's mirror image."""


@dataclass(frozen=True, eq=False, slots=True)
class Rest:
    """Parts sewn on and at rest together. first, x : (N, 3) as they were put, and at rest; far : the mean distance from the model;
    price : that and what else is wrong; crowd : whose seams are in each other's way; off : how far each part that is sewn on lies off,
    against its body, and what else is wrong with it; uneven : as of :func:`uneven`."""

    first: Array
    x: Array
    far: float
    price: float
    crowd: list[tuple[Placed, Placed]]
    off: dict[Key, float]
    uneven: float = 0.0


def rested(
    pieces: list[Piece],
    lines: list[str],
    first: Array,
    target: Target,
    params: CrochetParams,
    stitch: tuple[float, float],
    plane: Mirror | None = None,
    known: Known | None = None,
) -> Rest:
    """The pieces sewn on as ``lines`` say, which put them at ``first`` (N, 3), at rest. plane : the model's mirror, left and right;
    known : as of :func:`together`."""
    built, x, faces, rests = together(pattern([p.rounds for p in pieces], lines), params, stitch, known)
    goal = np.concatenate([g for p in pieces for g in p.goals])
    lain = distance(target, x, faces, fit(x, goal, np.ones(len(x))))
    far = lain.mean
    joining = prepare(built)
    assert joining is not None
    crowd = clashes(joining)
    through = crossed(x, faces)
    price = far + CLASH * len(crowd) + CROSSED * len(through) / len(faces) + (0.0 if rests else RESTLESS)
    apart = 0.0 if plane is None else uneven(pieces, turned(x, lain.turn) + lain.shift, plane)
    price += UNEVEN * apart
    return Rest(first, x, far, price, crowd, missing(pieces, x, faces[:, 0], faces[through, 0], crowd), apart)


def uneven(pieces: list[Piece], x: Array, plane: Mirror) -> float:
    """How far off, in stitches, the fabric of the one of a pair lies from where the other's is in the mirror ``plane``, on the average.

    x : (N, 3) all nodes, upon the model; 0 where there are no pairs. The toy is asked, not its words: rounds climb and columns lean the same way on either side, so that two parts whose seams are said
    as each other's image do not come to lie so.
    """
    span, off = spans(pieces), []
    for k, piece in enumerate(pieces):
        if piece.rounds.copies == 2 and piece.bases[0] is not None:
            one, two = (x[span[k, c]] for c in range(2))
            off.append(float(nearest(tree(two, piece.tried.worked.graph.faces), plane.image(one))[2].mean()))
    return float(np.mean(off)) if off else 0.0


def missing(
    pieces: list[Piece], x: Array, seen: Array, through: Array, crowd: list[tuple[Placed, Placed]]
) -> dict[Key, float]:
    """How far off, in stitches, every part lies that is sewn on, at rest at x (N, 3), against the body that it hangs on: the root of the mean square, along the fabric by less than across it; more where its fabric passes
    through other, as a share of its own, or its seam is in another's way.

    seen, through : (K,) a node of every face that is seen, and of those that others pass through
    """
    span, made = spans(pieces), dict[Key, float]()
    for (k, c), own in span.items():
        piece = pieces[k]
        if piece.bases[c] is None:
            continue
        goal, on = piece.lain[c], chain(pieces, (k, c))[-1]
        miss = against(x, own, span[on], pieces[on[0]].lain[on[1]]) - goal
        across = dot(miss, vertex_normals(goal, piece.tried.worked.graph.faces))
        far = math.sqrt(float((across**2 + ALONG * (miss**2).sum(1)).mean()))
        faces, bad = (int(((nodes >= own.start) & (nodes < own.stop)).sum()) for nodes in (seen, through))
        crowded = sum(piece.name(c) in (one.part, other.part) for one, other in crowd)
        made[k, c] = far + CROSSED * bad / max(faces, 1) + CLASH * crowded * len(x) / len(goal)
    return made


def spans(pieces: list[Piece]) -> dict[Key, slice]:
    """Where the nodes of every copy lie among those of all."""
    keys = [(k, c) for k, p in enumerate(pieces) for c in range(len(p.goals))]
    ends = np.cumsum([len(pieces[k].goals[c]) for k, c in keys]).tolist()
    return {key: slice(end - len(pieces[key[0]].goals[key[1]]), end) for key, end in zip(keys, ends)}


def against(x: Array, own: slice, on: slice, host: Array) -> Array:
    """Where a part's nodes, ``own`` of x (N, 3), are once the body that it hangs on, ``on``, lies at ``host``."""
    turn, shift = fit(x[on], host, np.ones(len(host)))
    return turned(x[own], turn) + shift


def between(one: tuple[Array, Array] | None, other: tuple[Array, Array], step: float) -> tuple[Array, Array]:
    """A nudge ``step`` of the way from one (None: none) to another."""
    turn, shift = (np.eye(3), np.zeros(3)) if one is None else one
    return turned(turn.T, share(turned(other[0], turn), step)).T, shift + step * (other[1] - shift)


def nudged(pieces: list[Piece], first: Array, x: Array) -> tuple[Nudges, dict[Key, float]]:
    """Where parts are to be aimed next, so that they come to rest where they belong: as fabric gives way they come to lie elsewhere
    than they were put, and will so again; what hangs on a limb gives way with that. Also how far out along itself each one lies,
    of what hangs on a limb that is off by the lesser of what it is against the body and against that.

    first, x : (N, 3) all parts as they were put, and at rest together
    """
    span = spans(pieces)
    made: Nudges = {}
    far = dict.fromkeys(span, 0.0)
    for k, c in span:
        base, goal = pieces[k].bases[c], pieces[k].lain[c]
        if base is None:
            continue
        below, there = chain(pieces, (k, c)), dict[Key, tuple[Array, Array]]()
        for on in (below[-1], below[0]):
            host = pieces[on[0]].lain[on[1]]
            put, own = (against(at, span[k, c], span[on], host) for at in (first, x))
            there[on] = put, own
        rim = len(goal) - pieces[k].tried.counts[-1]
        out = goal[0] - goal[rim:].mean(0)
        out = out / max(float(length(out)), 1e-9)
        lies = []
        for _, own in there.values():
            at_end, whole = (float(dot(own[n].mean(0) - goal[n].mean(0), out)) for n in (slice(rim, None), slice(None)))
            lies.append(min(at_end, max(whole, 0.0)))
        far[k, c] = min(lies, key=abs)
        put, own = there[below[-1]]
        turn, shift = fit(put, own, np.ones(len(goal)))
        made[k, c] = turn.T, turned(base - shift, turn.T) - base
    return made, far


def alike(pieces: list[Piece], nudges: Nudges, plane: Mirror) -> Nudges:
    """The nudges with those of every pair as each other's mirror image: half of what one wants and half of what the other does."""
    made = dict(nudges)
    for k, piece in enumerate(pieces):
        if piece.rounds.copies == 2 and (k, 1) in nudges:
            (turn, shift), (other, to) = nudges[k, 0], plane.moved(*nudges[k, 1])
            mean = turned(turn.T, share(turned(other, turn), 0.5)).T, 0.5 * (shift + to)
            made[k, 0], made[k, 1] = mean, plane.moved(*mean)
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

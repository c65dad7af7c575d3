"""Assemble: parts of a model brought back to where they were cut off, as lines that say where they are sewn on."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np

from tambour.core.check import Array
from tambour.core.graph import ROOT, TIP
from tambour.crochet.finish.capped import lid_on
from tambour.crochet.finish.joining import Joining, frame_of, join
from tambour.crochet.finish.placing import Frames
from tambour.crochet.finish.sewing import End, Held, ahead_on, end_of, held, leaning
from tambour.crochet.graph.build import build
from tambour.crochet.graph.spots import Spots
from tambour.crochet.language.finishes import Placed, Spot
from tambour.crochet.model.distance import Target
from tambour.crochet.model.loop import Tried
from tambour.crochet.model.paired import How, paired
from tambour.crochet.model.posed import LEANED, WAYS, Host, Wish, poses
from tambour.crochet.model.rounds import Rounds, pattern
from tambour.crochet.model.tips import Mirror
from tambour.crochet.settle.arrange import parts
from tambour.crochet.words.phrases import CLOCK, LEANS, TURN
from tambour.geometry.closest import nearest, tree
from tambour.geometry.motion import dot, fit, length, turned
from tambour.geometry.surface import vertex_normals

QUARTER = 0.25
"""Where nothing is to be easy, places are said to a quarter of a round and of a stitch; else between two rounds, and to a stitch."""
STEEP = 85.0
"""How far a part leans at the most, in degrees."""
UNSEEN = 0.2
"""What a lean, or a turn about itself, moves a part by on the average, in stitches, that it is worth no words."""
SIDEWAYS = 0.5
"""How much farther off a place may be, in radii of the end, whose fabric looks where the part points, than one that looks across."""


@dataclass(frozen=True, eq=False, slots=True)
class Piece:
    """A part and where each of its copies belongs.

    rounds : the part, with its copies; tried : what the simulation made of one; target : the piece of the model that one is
    faithful : the mean distance of one whose rounds were not made easier to read
    goals : of every copy (n, 3), where its nodes belong; lain : where they come to lie when it lies there, as it is by itself
    bases : the middles (3,) of their ends, None for what is sewn to nothing
    onto : for every copy the piece, and the copy of it, that it is sewn to
    """

    rounds: Rounds
    tried: Tried
    target: Target
    faithful: float
    goals: tuple[Array, ...]
    lain: tuple[Array, ...]
    bases: tuple[Array | None, ...]
    onto: tuple[tuple[int, int], ...]

    def name(self, copy: int) -> str:
        """What a copy is called."""
        return f"{self.rounds.name}.{copy + 1}" if self.rounds.copies > 1 else self.rounds.name


Key = tuple[int, int]
"""A piece and a copy of it."""
Nudges = dict[Key, tuple[Array, Array]]
"""How a copy is aimed elsewhere than where it belongs: a turn (3, 3) and a shift (3,), in the model's frame."""


@dataclass(frozen=True, eq=False, slots=True)
class Put:
    """Parts as they are said to be sewn on, before anything gives way.

    lines : what says so, such as ``place(Arm.1, Body, round=17.5, stitch=8, tilt=60, towards=135)``; x : (N, 3) all nodes
    said : how every one is; likely : how far, in stitches, one lies off so, of those that were chosen by that
    """

    lines: list[str]
    x: Array
    said: dict[Key, Placed]
    likely: dict[Key, float]


def chain(pieces: list[Piece], key: Key) -> list[Key]:
    """What a part is sewn to, and what that is sewn to, up to the body that stands by itself; of that nothing."""
    made: list[Key] = []
    while pieces[key[0]].bases[key[1]] is not None:
        key = pieces[key[0]].onto[key[1]]
        made.append(key)
    return made


def placed(
    pieces: list[Piece],
    nudges: Nudges,
    even: Mirror | None,
    fine: bool,
    stays: dict[Key, Placed] | None = None,
    had: dict[Key, list[dict[Key, Placed]]] | None = None,
    then: dict[Key, Placed] | None = None,
) -> Put:
    """Every piece sewn on. Where each belongs is told from the body that all of it hangs on: what is sewn to a limb would else have all that
    the limb leans, or is turned about itself, too much, and add its own.

    even : the model is its own mirror image there, left and right, and a pair is sewn on by the same words, each as the other's image
    fine : places and angles as near as can be; else those that there are words for
    stays : how those are sewn on that are not to be looked for
    then : how each was sewn on when it gave way as its nudge is for
    had : how all were sewn on, where a part's ways are not to be found again, of a pair its first's; of what hangs on a limb those where that was as it is now
    """
    stays, had, then = stays or {}, had or {}, then or {}
    likely: dict[Key, float] = {}
    spots = _spots(tuple(p.rounds for p in pieces))
    built, graph = spots.built, spots.built.graph
    alone = np.concatenate([p.tried.worked.x for p in pieces for _ in p.goals])
    goal = np.concatenate([g for p in pieces for g in p.lain])
    bodies = parts(graph)
    number = {(k, c): spots.parts[p.name(c)] for k, p in enumerate(pieces) for c in range(len(p.goals))}
    steps: dict[Key, tuple[Placed, End]] = {}
    points: dict[Key, Array] = {}
    wishes: dict[Key, Wish] = {}
    pairs: dict[Key, How] = {}
    held_by: dict[Key, tuple[Array, Held]] = {}

    def barred(key: Key) -> tuple[list[tuple[Spot, float, float, float]], list[float]]:
        """The ways of a part that are not to be found again, and the turns about itself that are as good as none."""
        below = chain(pieces, key)[:-1]
        same = [all(said[on] == steps[on][0] for on in below) for said in had.get(key, [])]
        once = [said[key] for said, one in zip(had.get(key, []), same) if one]
        ways = [(one.spot, one.tilt, one.towards, one.across) for one in once]
        return ways, unseen(alone, graph.faces[built.shell], *held_by[key]) if ways else []

    def stand(body: Key, x: Array) -> tuple[Array, Array]:
        """The turn and the shift from where a body belongs to where it is in x (N, 3)."""
        part = graph.parts[number[body]]
        return fit(goal[part.start : part.end], x[part.start : part.end], np.ones(part.end - part.start))

    waiting = [(k, c) for k, p in enumerate(pieces) for c, base in enumerate(p.bases) if base is not None]
    standing = set(number) - set(waiting)
    while ready := [key for key in waiting if pieces[key[0]].onto[key[1]] in standing]:
        joining = Joining(built, spots, tuple(steps.values()), ())
        joined = join(joining, alone, bodies)
        normals = vertex_normals(joined.x, graph.faces[built.shell])
        for k, c in ready:
            piece, base = pieces[k], pieces[k].bases[c]
            assert base is not None
            there, here = graph.parts[number[piece.onto[c]]], graph.parts[number[k, c]]
            turn, shift = stand(chain(pieces, (k, c))[-1], joined.x)
            aim, to = nudges.get((k, c), (np.eye(3), np.zeros(3)))
            point = turned(base + to, turn) + shift
            other = pieces[piece.onto[c][0]].name(piece.onto[c][1])
            ahead = turned(turned(goal[here.start] - base, aim), turn)
            spot = spot_of(
                spots,
                joined.x,
                number[piece.onto[c]],
                other,
                point,
                looks=(normals, ahead, piece.tried.counts[-1] / (2.0 * math.pi)),
                fine=fine,
            )
            plain = Placed(piece.name(c), spot)
            end = end_of(built, spots, plain)
            if (k, c) in stays:
                steps[k, c] = stays[k, c], end
                continue
            frame = frame_of(joining, joined.x, plain, end, joined.upright, bodies_of(bodies, there.start))
            nodes = bodies_of(bodies, here.start)
            how = held(alone, nodes, end)
            lay, _ = fit(alone[nodes], goal[nodes], np.ones(len(nodes)))
            axis, front = (turned(turned(turned(way, lay), aim), turn) for way in (how.axis, how.front))
            steps[k, c], points[k, c] = (angled(plain, frame, axis, front, fine), end), point
            if fine:
                continue
            if (
                end.ring
                and not end.laid
                and not spots.place(spot).opening
                and not len(lid_on(built, spots, plain, end))
            ):
                on = number[piece.onto[c]]
                host = Host(spots, on, other, bodies_of(bodies, there.start), joined.x, normals, joined.upright[on])
                off = alone[nodes] - how.middle
                own = np.column_stack([dot(off, way) for way in (how.axis, how.front, np.cross(how.axis, how.front))])
                want = turned(turned(goal[nodes] - base, aim), turn) + point
                there_ = joined.x.copy()
                there_[nodes] = want
                out = vertex_normals(there_, graph.faces[built.shell])[nodes]
                room = max(1.5, len(end.nodes) / (2.0 * math.pi))
                wishes[k, c] = Wish(host, spot, point, own, want, out, room, then.get((k, c)))
            held_by[k, c] = nodes, how
        waiting = [key for key in waiting if key not in ready]
        standing |= set(ready)
        for k in {k for k, c in ready if even is not None and pieces[k].rounds.copies == 2 and c == 0}:
            both = (k, 0), (k, 1)
            if even is None or not set(both) <= set(points):
                continue
            if not set(both) <= set(wishes):
                for key, one in zip(both, mirrored(steps[k, 0][0], steps[k, 1][0], fine)):
                    on = number[pieces[k].onto[key[1]]]
                    spot = spot_of(spots, joined.x, on, one.spot.part, points[key], one.spot.round, fine=fine)
                    steps[key] = replace(one, spot=spot), steps[key][1]
                continue
            turn, shift = stand(chain(pieces, (k, 0))[-1], joined.x)
            plane = Mirror(turned(even.point, turn) + shift, turned(even.normal, turn))
            if found := paired(wishes[k, 0], wishes[k, 1], plane, *barred((k, 0))):
                for key, how_ in zip(both, found[1]):
                    pairs[key], likely[key] = how_, 0.5 * found[0]
                    steps[key] = _posed(steps[key][0], how_), steps[key][1]
        for key in [key for key in ready if key in wishes and key not in pairs]:
            likely[key], best = poses(wishes[key]).but(*barred(key)).best()
            steps[key] = _posed(steps[key][0], best), steps[key][1]
        for key, (nodes, how) in held_by.items():
            said, end = steps[key]
            steps[key] = eased(said, graph.faces[built.shell], alone, nodes, how, key not in wishes), end
        for k in {k for k, _ in held_by if (k, 0) in pairs}:
            _as_one(steps, (k, 0), (k, 1), pairs)
        held_by.clear()
    made = join(Joining(built, spots, tuple(steps.values()), ()), alone, bodies)
    # Where its words put it: that a part begins clear of the fabric is gone as its seam is pulled.
    return Put(
        [_line(said) for said, _ in steps.values()],
        made.x - made.cleared,
        {key: said for key, (said, _) in steps.items()},
        likely,
    )


@lru_cache(maxsize=4)
def _spots(rounds: tuple[Rounds, ...]) -> Spots:
    """The places of a pattern of parts: the same ones are put elsewhere again and again."""
    return Spots(build(pattern(rounds)))


def angled(plain: Placed, frame: Frames, axis: Array, front: Array, fine: bool) -> Placed:
    """``plain`` with the angles at which its axis and its front point as wanted: in whole degrees, or, not ``fine``, the nearest
    that there are words for."""
    n, along, up = frame.normals[0], frame.along[0], frame.up[0]
    tilt = min(math.degrees(math.acos(float(np.clip(dot(n, axis), -1.0, 1.0)))), STEEP)
    flat = axis - dot(n, axis) * n
    towards = math.degrees(math.atan2(-float(dot(flat, along)), float(dot(flat, up))))
    tilt, towards = _leans(tilt, towards, fine)
    said = replace(plain, tilt=tilt, towards=towards)
    back = turned(front, leaning(said, frame).T)
    ahead = ahead_on(n, up)
    across = math.degrees(math.atan2(float(dot(back, np.cross(n, ahead))), float(dot(back, ahead))))
    return replace(said, across=_said(across, 1 if fine else TURN))


def _posed(plain: Placed, how: tuple[Spot, int, int]) -> Placed:
    """``plain`` at the spot, with the lean and the turn about itself, that were found for it."""
    tilt, towards = LEANED[how[1]]
    return replace(plain, spot=how[0], tilt=float(tilt), towards=float(towards), across=float(WAYS[how[2]]))


def _as_one(steps: dict[Key, tuple[Placed, End]], one: Key, two: Key, found: dict[Key, How]) -> None:
    """Says the lean, and the turn about itself, of both of a pair as ``found`` where it was dropped of only one of them."""
    said = [steps[key][0] for key in (one, two)]
    leans, turns = (len({bool(getattr(s, what)) for s in said}) > 1 for what in ("tilt", "across"))
    for key, now in zip((one, two), said):
        full = _posed(now, found[key])
        now = replace(now, tilt=full.tilt, towards=full.towards) if leans else now
        steps[key] = replace(now, across=full.across) if turns else now, steps[key][1]


def eased(said: Placed, faces: Array, x: Array, nodes: Array, how: Held, leans: bool) -> Placed:
    """``said`` without a lean (where ``leans``), or a turn about itself, that nobody would see.

    A short part hardly moves by the one, one that is as wide all round by the other. faces (F, 3), x (N, 3) : all parts; nodes : its own; how : it is held
    """
    off = x[nodes] - how.middle
    if leans and float(np.abs(dot(off, how.axis)).mean()) * math.sin(math.radians(said.tilt)) < UNSEEN:
        said = replace(said, tilt=0.0, towards=0.0)
    return replace(said, across=0.0) if unseen(x, faces, nodes, how, (said.across,)) else said


def unseen(x: Array, faces: Array, nodes: Array, how: Held, turns: tuple[float, ...] = WAYS) -> list[float]:
    """Those of the ``turns`` of a part about itself, in degrees, that nobody would see.

    faces (F, 3), x (N, 3) : all parts; nodes : its own; how : it is held
    """
    own = faces[np.isin(faces[:, 0], nodes)]
    if not len(own):
        return []
    off, side, found, by = x[nodes] - how.middle, np.cross(how.axis, how.front), [], tree(x, own)
    a, b, c = (dot(off, way)[:, None] for way in (how.axis, how.front, side))
    for turn in turns:
        cos, sin = math.cos(math.radians(turn)), math.sin(math.radians(turn))
        turned_ = how.middle + a * how.axis + (cos * b - sin * c) * how.front + (sin * b + cos * c) * side
        if turn and float(nearest(by, turned_)[2].mean()) < UNSEEN:
            found.append(turn)
    return found


def _leans(tilt: float, towards: float, fine: bool) -> tuple[float, float]:
    """The tilt and where it goes towards, in degrees, as they are said."""
    if fine:
        tilt = _said(tilt, 1)
        return tilt, _said(towards, 1) if tilt else 0.0
    w = math.radians(towards)

    def off(one: tuple[int, int]) -> float:
        """How far a way that is said is from the one that is meant: the cosine between them."""
        a, b, t = math.radians(one[0]), math.radians(one[1]), math.radians(tilt)
        return -(math.cos(a) * math.cos(t) + math.sin(a) * math.sin(t) * math.cos(b - w))

    best = min([(0, 0), *((a, b) for a in LEANS for b in range(0, 360, CLOCK))], key=off)
    return float(best[0]), float(best[1])


def mirrored(one: Placed, two: Placed, fine: bool) -> tuple[Placed, Placed]:
    """A pair that leans as each other's mirror image, by what both say on the average, at the same round. How each is turned
    about itself stays: both are worked the same way round, and lean the same way as they are."""
    half = _between(one.towards, -two.towards)
    step = QUARTER if fine else 0.5
    rounds = round(0.5 * (one.spot.round + two.spot.round) / step) * step
    tilt, towards = _leans(0.5 * (one.tilt + two.tilt), half, fine)
    return (
        replace(one, tilt=tilt, towards=towards, spot=replace(one.spot, round=rounds)),
        replace(two, tilt=tilt, towards=-towards % 360.0, spot=replace(two.spot, round=rounds)),
    )


def _between(a: float, b: float) -> float:
    """The angle in the middle between two, in degrees."""
    x = math.cos(math.radians(a)) + math.cos(math.radians(b))
    y = math.sin(math.radians(a)) + math.sin(math.radians(b))
    return math.degrees(math.atan2(y, x))


def bodies_of(bodies: list[Array], node: int) -> Array:
    """The body of fabric that a node belongs to."""
    return next(nodes for nodes in bodies if node in nodes)


def _said(angle: float, step: int) -> float:
    return float(step * round(angle / step) % 360)


def _line(said: Placed) -> str:
    more = "".join(f", {name}={getattr(said, name):g}" for name in ("across", "tilt", "towards") if getattr(said, name))
    spot = said.spot
    stitch = "" if spot.stitch is None else f", stitch={spot.stitch:g}"
    return f"place({said.part}, {spot.part}, round={spot.round:g}{stitch}{more})"


def spot_of(
    spots: Spots,
    x: Array,
    part: int,
    name: str,
    point: Array,
    only: float | None = None,
    looks: tuple[Array, Array, float] | None = None,
    fine: bool = True,
) -> Spot:
    """The place of a part that is nearest to ``point``; in the round ``only``. ``fine``: to a quarter of a round and of a stitch, else
    on a round or between two, and on a stitch.

    looks : normals (N, 3), a way (3,) and the end's radius: of places that are hardly farther off, the one whose fabric looks that way
    """
    built = spots.built
    graph = built.graph
    own = np.arange(graph.parts[part].start, graph.parts[part].end)
    plain = own[~np.isin(graph.peculiarity[own], (ROOT, TIP))]
    far = length(x[plain] - point)
    if looks is not None:
        far = far + SIDEWAYS * looks[2] * (
            1.0 - (looks[0][plain] * looks[1]).sum(1) / max(float(length(looks[1])), 1e-9)
        )
    node = int(plain[int(far.argmin())])
    k = int(graph.round[node])
    number = built.rounds[k].number
    numbers = [r.number for r in built.rounds if r.part == part]
    nodes = spots.stitches(k)
    at = int(np.flatnonzero(nodes == node)[0])
    point = point if looks is None else 0.5 * (point + x[node])
    best: tuple[float, Spot] | None = None
    half, share = (0.5, 1.0) if not fine else (QUARTER, QUARTER)
    for r in np.arange(number - 1.0, number + 1.01, half):
        if not min(numbers) <= r <= max(numbers) or (only is not None and r != only):
            continue
        low = math.floor(r)
        low_k = spots.round_at(part, low)
        if low_k is None:
            continue
        count = len(spots.stitches(low_k))
        middle = at if low_k == k else (at + 0.5) / len(nodes) * count - 0.5
        for s in np.arange(round(middle) - 2.0, round(middle) + 2.01, share):
            stitch = float(s % count) + 1.0
            place = spots.place(Spot(name, float(r), stitch))
            there = (np.array(place.weights)[:, None] * x[list(place.nodes)]).sum(0)
            off = float(length(there - point))
            if best is None or off < best[0] - 1e-9:
                best = off, Spot(name, float(r), stitch)
    return best[1] if best is not None else Spot(name, number, at + 1.0)

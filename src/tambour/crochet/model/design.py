"""Design: from a mesh to the text of a pattern; the whole way on one page."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from tambour.core.check import Array
from tambour.core.errors import TambourError, Text
from tambour.core.mesh import Mesh
from tambour.core.progress import Progress
from tambour.crochet.model import tips
from tambour.crochet.model.assemble import Piece
from tambour.crochet.model.bends import heights
from tambour.crochet.model.bumps import Bump, faces_of, taken_off, uncoloured
from tambour.crochet.model.coarse import coarse
from tambour.crochet.model.cut import Limb
from tambour.crochet.model.distance import Target
from tambour.crochet.model.dyed import dye, dyed
from tambour.crochet.model.eyed import eyed
from tambour.crochet.model.fronts import Fronts, fronts, laid
from tambour.crochet.model.limbs import limbs
from tambour.crochet.model.loop import (
    ROUND,
    STEP,
    TRIES,
    Task,
    Tried,
    bare,
    corrected,
    faithful,
    looped,
    missed,
    pulled,
    roundness,
    stretched,
    tried,
)
from tambour.crochet.model.named import names
from tambour.crochet.model.painted import painted
from tambour.crochet.model.rounds import printed
from tambour.crochet.model.seating import seated
from tambour.crochet.model.stance import stands
from tambour.crochet.model.whole import area, bodies, refined, volume
from tambour.geometry.closest import nearest

if TYPE_CHECKING:
    from tambour.crochet.params import CrochetParams

STITCHES = 2000
"""Stitches of a model where neither they nor its height are asked for."""
FEW, MANY = 40, 60_000
"""Fewer stitches than this show no shape; more are no toy."""
THIN = 3.0
"""A model whose parts are thinner around than this, in stitches and on the average, is none for crochet."""
FINE, COARSE, MOVED = 1.0, 0.5, 0.1
"""The longest edge of the surface that rounds are led over, and how short they are at the least where it then moves by no more than
the last, in stitches."""
BEGINNINGS, FINAL, CLOSE = 3, 2, 1.2
"""How many tips are tried in the simulation, each corrected once; and from how many of these a whole loop goes on, those that come to no more than so
many times what the best does."""
ALIKE = 1.05
"""Threads are pulled through what comes to no more than so many times what the best of these does without them."""
LARGE = 4000
"""Stitches of a part that is corrected fewer times than a smaller one, as its simulation takes longer."""
TURNED = 8
"""How many ways the twin of a part that bends is turned about itself to find how it belongs."""
INSIDE = -0.3
"""Rounds that look so far inwards lie inside: of a cup, say."""
LOST = 0.03
"""A larger share of the surface than this that no round follows is told."""
OFF = 1.2
"""A part of which a twentieth lies farther from its model than this, in stitches, is told."""


@dataclass(frozen=True, eq=False, slots=True)
class Design:
    """A pattern made for a model.

    text : the pattern, in tambour's own language
    vertices (V, 3), faces (F, 3) : the model as the pattern aims at it, mm, y up, z ahead
    goals : (N, 3) mm, where every node of the pattern belongs
    history : part → the mean distances, in stitches, that its corrections went through
    parts : part → how far it lies from its own piece of the model, in stitches; stands : which axes of the file are up and ahead
    """

    text: Text
    vertices: Array
    faces: Array
    goals: Array
    history: dict[str, list[float]]
    parts: dict[str, dict[str, float]]
    stands: str


def design(mesh: Mesh, params: CrochetParams, progress: Progress, name: str = "model") -> Design:
    """The pattern of ``mesh``. TambourError, in one line, for a mesh that no pattern can be made of."""
    from tambour.crochet.maker.gauge import gauge

    tell: list[str] = []
    known = gauge(params, {})
    stitch = (known.width, known.height)
    with progress.stage("model"):
        found = bodies(mesh, tell)
        every = [(x, faces) for x, faces, _ in found]
        total = sum(float(area(x, faces).sum()) for x, faces in every)
        extent = np.ptp(np.concatenate([x for x, _ in every]), axis=0)
        guess = _scale(total, float(extent.min()), params, stitch)  # of whichever side is up the largest
        light = [coarse(x, faces, COARSE / guess, MOVED / guess) for x, faces in every]
        turn = tips.level(*light[0], params.model_up)
        turn = tips.facing(light[0][0] @ turn.T, light[0][1], params.model_front) @ turn
        size = _scale(total, float(extent[int(np.abs(turn[1]).argmax())]), params, stitch)
        _likely(total * size * size * stitch[0] / stitch[1])
        whole = [(size * (x @ turn.T), faces) for x, faces in every]
        light = [(size * (x @ turn.T), faces) for x, faces in light]
    for x, faces in whole:
        around = 4.0 * math.pi * volume(x, faces) / float(area(x, faces).sum())  # of a rod, what it is around
        if around < THIN:
            raise TambourError(
                f"the model is too thin for its stitches: about {around:.1f} around, on the average",
                hint="more {--stitches}, or a stouter model",
            )
    pieces: list[Piece] = []
    history: dict[str, list[float]] = {}
    bumps: list[tuple[Bump, ...]] = []
    for x, faces in light:
        pieces += _pieces(x, faces, params, stitch, progress, tell, pieces, history, bumps)
    target = Target.of(np.concatenate([x for x, _ in whole]), _one([f for _, f in whole], [len(x) for x, _ in whole]))
    with progress.stage("assembly"):
        plane = tips.mirror(target.vertices, target.faces)
        even = plane is not None and abs(float(plane.normal[0])) > 0.9
        pieces = [_said(p) for p in pieces]
        pieces, lines, way = seated(pieces, target, params, stitch, plane if even else None)
        if way:
            history["assembly"] = way
        shades = None
        if mesh.color is not None:
            first = np.concatenate([origin for _, _, origin in found])
            shades = target.vertices, mesh.color[first]
            if not any(bumps) and (face := painted(target.vertices, target.faces, shades[1], plane)):
                said = "a spot of the model's colours", "two spots of the model's colours"
                lines += faces_of(face, pieces, stitch, params.plain_ <= 0.0, shades, tell, said)
                shades = target.vertices, uncoloured(*shades, face)
        if even and plane is not None and not any(bumps) and not any(line.startswith("eye(") for line in lines):
            own = eyed(target.vertices, target.faces, pieces, plane)
            said = "", "two eyes that the model does not have, proposed where its ears and its nose would have them,"
            lines += faces_of(own, pieces, stitch, params.plain_ <= 0.0, None, tell, said)
        lines += [line for face in bumps for line in faces_of(face, pieces, stitch, params.plain_ <= 0.0, shades, tell)]
    if shades is not None:
        plain = uncoloured(*shades, tuple(b for face in bumps for b in face))
        how = dye(target.tree, target.faces, plain, target.points, params.colors)
        if how is not None:
            pieces = [
                replace(p, rounds=dyed(p.rounds, p.goals[0], how, p.tried.worked.graph, params.hold)) for p in pieces
            ]
    elif params.colors is not None:
        progress.warn("has no effect: the model has no colours", where="{--colors}")
    for line in [*tell, *(line for p in pieces for line in _missed(p))]:
        progress.warn(line)
    text = printed([p.rounds for p in pieces], lines, name)
    return Design(
        text,
        target.vertices * stitch[0],
        target.faces,
        np.concatenate([goal for p in pieces for goal in p.goals]) * stitch[0],
        history,
        {p.rounds.name: {**p.tried.distance.plain(), "faithful": round(p.faithful, 4)} for p in pieces},
        tips.stands(turn),
    )


def _missed(piece: Piece) -> list[str]:
    """What is said of a part that does not come out as its model."""
    far = piece.tried.distance.p95
    if far <= OFF:
        return []
    number, how = missed(piece.target, piece.tried)
    return [
        f"{piece.rounds.name} misses its model: a twentieth of it by more than {far:.1f} stitches, most about its round {number}, "
        f"which lies {how} of it; the view compare shows where"
    ]


def _said(piece: Piece) -> Piece:
    """A piece that stands by itself, with how it stands."""
    if piece.bases[0] is not None:
        return piece
    return replace(
        piece, rounds=replace(piece.rounds, stands=stands(piece.rounds, piece.tried.worked.x, piece.lain[0]))
    )


def _one(faces: list[Array], counts: list[int]) -> Array:
    """The faces of several bodies, their vertices one after the other."""
    first = np.cumsum([0, *counts])
    return np.concatenate([f + n for f, n in zip(faces, first)])


def _scale(total: float, tall: float, params: CrochetParams, stitch: tuple[float, float]) -> float:
    """What a model of so much surface, and so ``tall``, is enlarged by, that its unit is a stitch's width: to the stitches, or the
    height, that are asked for."""
    if params.height is not None:
        return params.height / tall / stitch[0]
    return math.sqrt((params.stitches or STITCHES) * stitch[1] / stitch[0] / total)


def _likely(count: float) -> None:
    """TambourError for so many stitches that they are no toy."""
    if not FEW <= count <= MANY:
        raise TambourError(
            f"that is about {count:,.0f} stitches, "
            + ("too few to show a shape" if count < FEW else f"more than {MANY:,}"),
            hint="another {--height}, or {--stitches} 1000",
        )


def _pieces(
    x: Array,
    faces: Array,
    params: CrochetParams,
    stitch: tuple[float, float],
    progress: Progress,
    tell: list[str],
    known: list[Piece],
    history: dict[str, list[float]],
    bumps: list[tuple[Bump, ...]],
) -> list[Piece]:
    """The parts of one body of the model, the one that the others stand on first.

    known : those that there are already; bumps : room for those of its face
    """
    with progress.stage("model"):
        y, fine, _ = refined(x, faces, FINE)
        plane = tips.mirror(x, faces)
        face, y, fine = taken_off(y, fine, plane, tell)
        bumps.append(face)
        body, rest, groups = limbs(y, fine, plane, tell)
        said = names((body, rest), groups, {p.rounds.name for p in known})
    with progress.stage("rounds"):
        begun = _begun(said[0], body, rest, plane, params, stitch)
    count = sum(begun[0][1].counts)
    tries = max(2, round(TRIES * min(1.0, LARGE / max(count, 1))))
    with progress.stage("loop"):
        task, best, history[said[0]] = _best(begun[: FINAL if count < LARGE else 1], tries)
    if task.way.lost > LOST:
        tell.append(f"{100 * task.way.lost:.0f} % of {said[0]} is left out: bumps beside the way of its rounds")
    made = [Piece(best.rounds, best, task.target, faithful(task, best), (best.goal,), (best.lain,), (None,), ((0, 0),))]
    targets = [[task.target]]
    for title, group in zip(said[1:], groups):
        targets.append([Target.of(limb.vertices, limb.faces[limb.own]) for limb in group])
        way = _way(group[0], stitch, group[0].rim)
        led = [partial(_heightened, limb.vertices, limb.faces, limb.f, limb.tip, limb.rim) for limb in group]
        task = Task(title, way, targets[-1][0], _hidden(way), params.plain_, "", params, stitch, lines=led[0])
        with progress.stage("rounds"):
            first = tried(task, task.way.girths)
        with progress.stage("loop"):
            task, best, history[title] = _looped(task, first, tries)
        goals, lain = [best.goal], [best.lain]
        high = heights(task.leans or (None,) * len(task.way.lines))
        for way, own in zip([lines(high) for lines in led[1:]], targets[-1][1:]):
            goal, lies = _twin(best, way, own, any(lean is not None for lean in task.leans))
            goals.append(goal)
            lain.append(lies)
        copies = replace(best.rounds, copies=len(group))
        bases = tuple(limb.base for limb in group)
        made.append(Piece(copies, best, task.target, faithful(task, best), tuple(goals), tuple(lain), bases, ()))
    for k, group in enumerate(groups):
        onto = tuple(_owner(limb, k + 1, targets, len(known)) for limb in group)
        made[k + 1] = replace(made[k + 1], onto=onto)
    return made


def _looped(task: Task, first: Tried, tries: int) -> tuple[Task, Tried, list[float]]:
    task, best, way = looped(task, first, tries)
    return task, best, [round(v, 4) for v in way]


def _best(begun: list[tuple[Task, Tried]], tries: int) -> tuple[Task, Tried, list[float]]:
    """The best that comes of several beginnings, each led through the loop, as which one promises most does not tell; but threads, which
    take as long as all the rest, are only pulled through those that are then about as near; and, of what is not round, through the beginnings
    as their lines are."""
    made = [bare(task, first, tries) for task, first in begun]
    near = min(best.price for _, best, _ in made)
    ends = []
    for task, best, way in made:
        if best.price <= ALIKE * near:
            best, more = pulled(task, best, tries)
            ends.append((task, best, [round(v, 4) for v in way + more]))
    for task, first in begun:
        if roundness(task.way) < ROUND:
            best, more = pulled(task, first, tries)
            ends.append((task, best, [round(v, 4) for v in more]))
    task, best, way = min(ends, key=lambda end: end[1].price)
    task, best, more = stretched(task, best, tries)
    return task, best, way + [round(v, 4) for v in more]


def _begun(
    name: str, x: Array, faces: Array, plane: tips.Mirror | None, params: CrochetParams, stitch: tuple[float, float]
) -> list[tuple[Task, Tried]]:
    """The tasks of a body worked in one piece, with its first rounds, from the tips that the simulation likes best, the best first."""
    target = Target.of(x, faces)
    found: list[tuple[float, Task, Tried]] = []
    for tip, f in tips.choose(target, plane, params.tip, BEGINNINGS):
        f = tips.evened(target, f, tip, plane)
        rows = max(3, round(float(f.max()) * stitch[0] / stitch[1]) - 1)
        way = fronts(x, faces, f, rows, tip)
        ahead = way.tip - np.mean([line.mean(0) for line in way.lines], axis=0)
        side = int(np.abs(ahead).argmax())
        if side == 1:
            up = "start" if ahead[1] > 0.0 else ""
        else:
            up = "back" if side == 2 and ahead[2] < 0.0 else "side"
        seam = np.array([0.0, 0.0, -1.0]) if side == 1 else np.array([0.0, -1.0, 0.0])
        task = Task(name, way, target, seam, params.plain_, up, params, stitch)
        task = replace(task, lines=partial(_heightened, x, faces, f, tip, None))
        looks = [tips.inward(target, line) for line in way.lines]
        inside = [k + 1 for k, value in enumerate(looks) if value < INSIDE]
        if len(inside) > 2 and inside[0] > 3:
            task = replace(
                task, hollow=(inside[0], len(looks)) if inside[-1] > 0.8 * len(looks) else (inside[0], inside[-1])
            )
        now = tried(task, task.way.girths)
        price = min(now.distance.mean, tried(task, corrected(task, now, STEP)).distance.mean)
        found.append((price, task, now))
    found.sort(key=lambda one: one[0])
    return [(task, now) for price, task, now in found if price <= CLOSE * found[0][0]]


def _way(limb: Limb, stitch: tuple[float, float], long: float) -> Fronts:
    """The lines of a limb's rounds, as many as one so ``long`` has: all copies have the same."""
    rows = max(2, round(long * stitch[0] / stitch[1]))
    return fronts(limb.vertices, limb.faces, limb.f, rows, limb.tip, limb.rim)


def _heightened(vertices: Array, faces: Array, f: Array, tip: int, rim: float | None, high: Array) -> Fronts:
    """The lines of rounds as ``high`` (R,) as is said along the way ``f`` (V,)."""
    return fronts(vertices, faces, f, len(high), tip, rim, high)


def _hidden(way: Fronts) -> Array:
    """Where the seam of a limb is least seen: behind it, below one that points ahead."""
    axis = way.end - way.tip
    ahead = abs(float(axis[2])) > 0.8 * float(np.sqrt((axis**2).sum()))
    return np.array([0.0, -1.0, 0.0]) if ahead else np.array([0.0, 0.0, -1.0])


def _twin(best: Tried, way: Fronts, target: Target, bends: bool) -> tuple[Array, Array]:
    """Where the nodes (N, 3) of another copy belong, and where they come to lie: with its seam hidden, or, of one that ``bends``, turned
    about itself as is best, for its twin may bend to the other side."""
    found = []
    seam, axis = _hidden(way), way.end - way.tip
    axis = axis / max(float(np.sqrt((axis**2).sum())), 1e-9)
    for angle in 2.0 * math.pi * np.arange(TURNED if bends else 1) / TURNED:
        cos, sin = math.cos(angle), math.sin(angle)
        to = cos * seam + sin * np.cross(axis, seam) + (1.0 - cos) * (axis * seam).sum() * axis
        goal = np.concatenate([way.tip[None], *laid(way, best.counts, to)])
        lies, off = best.upon(target, goal)
        found.append((off, goal, lies))
    return min(found, key=lambda one: one[0])[1:]


def _owner(limb: Limb, k: int, targets: list[list[Target]], first: int) -> tuple[int, int]:
    """The piece, and which copy of it, that a limb was cut off: the body, or a limb that was cut off later."""
    found = [(float(nearest(targets[0][0].tree, limb.base[None])[2][0]), first, 0)]
    for j in range(k + 1, len(targets)):
        found += [
            (float(nearest(one.tree, limb.base[None])[2][0]) + 0.3, first + j, c) for c, one in enumerate(targets[j])
        ]
    _, piece, copy = min(found)
    return piece, copy

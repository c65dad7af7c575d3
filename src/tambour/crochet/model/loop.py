"""Loop: a part's rounds tried in the simulation and corrected against the model, until that brings nothing more."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from tambour.core.check import Array
from tambour.crochet.model import readable
from tambour.crochet.model.distance import Distance, Target, distance
from tambour.crochet.model.fronts import DRAWN, Fronts, laid
from tambour.crochet.model.rounds import Rounds
from tambour.crochet.model.settled import Settled, settled
from tambour.geometry.closest import nearest
from tambour.geometry.motion import fit, turned

if TYPE_CHECKING:
    from tambour.crochet.params import CrochetParams

TRIES = 10
"""How often a part is corrected at the most."""
STEP = 0.8
"""How much of what a round is too wide is taken off it at once."""
GAIN = 0.004
"""An improvement of the mean distance by less than this, in stitches, is none."""
BOUNDS = 0.6, 1.5
"""Shares of a line's length that its round may come to."""


@dataclass(frozen=True, eq=False, slots=True)
class Tried:
    """Rounds and what the simulation made of them.

    goal : (N, 3) where each node of the part belongs on the model; wanted : the lengths that the counts were made for
    """

    rounds: Rounds
    counts: list[int]
    goal: Array
    wanted: Array
    worked: Settled
    distance: Distance


@dataclass(frozen=True, eq=False, slots=True)
class Task:
    """A part to be found rounds for. All lengths in stitches, the model's frame.

    way : the lines of its rounds; target : its surface; seam : (3,) where its rounds begin; plain : 0 to 1; hollow : its rounds that lie inside
    """

    name: str
    way: Fronts
    target: Target
    seam: Array
    plain: float
    up: str
    params: CrochetParams
    stitch: tuple[float, float]
    stuffing: str = ""
    hollow: tuple[int, int] = (0, 0)


def drafted(task: Task, wanted: Array) -> tuple[Rounds, list[int], Array]:
    """Rounds as long as ``wanted`` (R,): the part, its counts, and where every stitch belongs (N, 3)."""
    made = readable.sparing(list(wanted), task.plain)
    points = laid(task.way, made, task.seam)
    rounds = readable.rounds(task.way.lines, points, task.plain)
    closed = task.way.closed and made[-1] <= DRAWN
    part = Rounds(task.name, made[0], rounds, closed, stuffing=task.stuffing, up=task.up, hollow=task.hollow)
    tip = [task.way.end[None]] if closed else []
    return part, made, np.concatenate([task.way.tip[None], *points, *tip])


def tried(task: Task, wanted: Array) -> Tried:
    """Rounds as long as ``wanted``, worked and measured."""
    part, made, goal = drafted(task, wanted)
    worked = settled(part, task.params, task.stitch)
    start = fit(worked.x, goal, np.ones(len(goal)))
    return Tried(part, made, goal, wanted, worked, distance(task.target, worked.x, worked.graph.faces, start))


def looped(task: Task, first: Tried | None = None, tries: int = TRIES) -> tuple[Tried, list[float]]:
    """The best rounds that corrections lead to, and the mean distances on the way."""
    best = tried(task, task.way.girths) if first is None else first
    history, step, idle = [best.distance.mean], STEP, 0
    for _ in range(tries):
        now = tried(task, corrected(task, best, step))
        history.append(now.distance.mean)
        if now.distance.mean < best.distance.mean - GAIN:
            best, idle = now, 0
        else:
            step, idle = 0.5 * step, idle + 1
            if idle == 3:
                break
    return best, history


def faithful(task: Task, best: Tried) -> float:
    """The mean distance, in stitches, of the same lengths where increases lie wherever the shape wants them: what rounds that
    read more easily are to be held against."""
    return best.distance.mean if task.plain <= 0.0 else tried(replace(task, plain=0.0), best.wanted).distance.mean


def corrected(task: Task, last: Tried, step: float) -> Array:
    """The lengths (R,) that would bring every round to the model: those that lie outside of it become shorter."""
    off = signed(task.target, last.worked.x, last.distance)
    number = last.worked.graph.round
    count = len(last.counts)
    number = np.clip(number, 0, count - 1)
    mean = np.bincount(number, off, count) / np.maximum(np.bincount(number, minlength=count), 1)
    smooth = np.convolve(np.pad(mean, 1, mode="edge"), [0.25, 0.5, 0.25], "valid")
    wide = task.way.girths
    return np.clip(last.wanted - step * 2.0 * math.pi * smooth, BOUNDS[0] * wide, BOUNDS[1] * wide)


def signed(target: Target, x: Array, lain: Distance) -> Array:
    """How far (N,) points lie outside of ``target``, once they are laid upon it; inside is negative."""
    points = turned(x, lain.turn) + lain.shift
    face, uv, far = nearest(target.tree, points)
    corner = target.vertices[target.faces[face]]
    at = corner[:, 0] + uv[:, :1] * (corner[:, 1] - corner[:, 0]) + uv[:, 1:] * (corner[:, 2] - corner[:, 0])
    return np.asarray(far * np.sign(((points - at) * target.normals[face]).sum(1)))


def missed(target: Target, made: Tried) -> tuple[int, str]:
    """The round that lies farthest from ``target``, and on which side of it that is."""
    off = signed(target, made.worked.x, made.distance)
    number = np.clip(made.worked.graph.round, 0, len(made.counts) - 1)
    nodes = np.bincount(number)
    size, lean = (np.bincount(number, value) / nodes for value in (np.abs(off), off))
    worst = int(size.argmax())
    side = "outside" if lean[worst] > 0 else "inside"
    return worst + 1, "partly outside, partly inside" if abs(lean[worst]) < 0.5 * size[worst] else side

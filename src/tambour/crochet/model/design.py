"""Design: from a mesh to the text of a pattern; the whole way on one page."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from tambour.core.check import Array
from tambour.core.errors import TambourError, Text
from tambour.core.mesh import Mesh
from tambour.core.progress import Progress
from tambour.crochet.model import tips
from tambour.crochet.model.distance import Target
from tambour.crochet.model.fronts import Fronts, fronts
from tambour.crochet.model.loop import Task, Tried, looped, tried
from tambour.crochet.model.rounds import printed
from tambour.crochet.model.whole import area, bodies, refined

if TYPE_CHECKING:
    from tambour.crochet.params import CrochetParams

STITCHES = 2000
"""Stitches of a model where neither they nor its height are asked for."""
FEW, MANY = 40, 60_000
"""Fewer stitches than this show no shape; more are no toy."""
FINE = 1.0
"""The longest edge of the surface that rounds are led over, in stitches."""
BEGINNINGS = 2
"""How many tips are tried in the simulation."""


@dataclass(frozen=True, eq=False, slots=True)
class Design:
    """A pattern made for a model.

    text : the pattern, in tambour's own language
    vertices (V, 3), faces (F, 3) : the model as the pattern aims at it, mm, y up, z ahead
    goals : (N, 3) mm, where every node of the pattern belongs; NaN where nowhere
    history : part → the mean distances, in stitches, that its corrections went through
    """

    text: Text
    vertices: Array
    faces: Array
    goals: Array
    history: dict[str, list[float]]


def design(mesh: Mesh, params: CrochetParams, progress: Progress, name: str = "model") -> Design:
    """The pattern of ``mesh``. TambourError, in one line, for a mesh that no pattern can be made of."""
    from tambour.crochet.maker.gauge import gauge

    tell: list[str] = []
    known = gauge(params, {})
    stitch = (known.width, known.height)
    with progress.stage("model"):
        found = bodies(mesh, tell)
        turn = tips.level(found[0][0], found[0][1], params.model_up)
        size = _scale([(x @ turn.T, faces) for x, faces, _ in found], params, stitch)
        whole = [(size / stitch[0] * (x @ turn.T), faces) for x, faces, _ in found]
    made: list[tuple[Tried, list[float]]] = []
    for k, (x, faces) in enumerate(whole):
        title = "Body" if len(whole) == 1 else f"Body {_NUMBERS[k] if k < len(_NUMBERS) else k + 1}"
        with progress.stage("rounds"):
            first = _first(title, x, faces, params, stitch)
        with progress.stage("loop"):
            made.append(looped(*first))
    for line in tell:
        progress.warn(line)
    parts = [one.rounds for one, _ in made]
    text = printed(parts, (), name, [f"Made for the model {name}"])
    vertices = np.concatenate([x for x, _ in whole]) * stitch[0]
    first_of = np.cumsum([0] + [len(x) for x, _ in whole])
    faces = np.concatenate([f + n for (_, f), n in zip(whole, first_of)])
    goals = np.concatenate([one.goal for one, _ in made]) * stitch[0]
    history = {one.rounds.name: [round(v, 4) for v in way] for one, way in made}
    return Design(text, vertices, faces, goals, history)


_NUMBERS = ("One", "Two", "Three", "Four", "Five", "Six")


def _scale(whole: list[tuple[Array, Array]], params: CrochetParams, stitch: tuple[float, float]) -> float:
    """What the model is enlarged by: to the stitches, or the height, that are asked for. TambourError where that is no toy."""
    total = sum(float(area(x, faces).sum()) for x, faces in whole)
    if params.height is not None:
        low, high = min(x[:, 1].min() for x, _ in whole), max(x[:, 1].max() for x, _ in whole)
        size = params.height / (high - low)
    else:
        size = math.sqrt((params.stitches or STITCHES) * stitch[0] * stitch[1] / total)
    count = total * size * size / (stitch[0] * stitch[1])
    if not FEW <= count <= MANY:
        raise TambourError(
            f"that is about {count:,.0f} stitches, "
            + ("too few to show a shape" if count < FEW else f"more than {MANY:,}"),
            hint="another {--height}, or {--stitches} 1000",
        )
    return float(size)


def _first(name: str, x: Array, faces: Array, params: CrochetParams, stitch: tuple[float, float]) -> tuple[Task, Tried]:
    """The task of a body worked in one piece, with its first rounds, from the tip that the simulation likes best."""
    target = Target.of(x, faces)
    y, fine, _ = refined(x, faces, FINE)
    plane = tips.mirror(x, faces)
    best: tuple[Task, Tried] | None = None
    for tip, f in tips.choose(y, fine, plane, params.tip, BEGINNINGS):
        rows = max(3, round(float(f.max()) * stitch[0] / stitch[1]) - 1)
        way = fronts(y, fine, f, rows, tip)
        task = _task(name, way, target, params, stitch)
        now = tried(task, task.way.girths)
        if best is None or now.distance.mean < best[1].distance.mean:
            best = task, now
    assert best is not None
    return best


def _task(name: str, way: Fronts, target: Target, params: CrochetParams, stitch: tuple[float, float]) -> Task:
    """The task of a part by itself: which way up it is worked, and its seam at the back."""
    ahead = way.tip - way.end
    side = int(np.abs(ahead).argmax())
    up = "" if side == 1 and ahead[1] < 0 else "start" if side == 1 else "side"
    seam = np.array([0.0, 0.0, -1.0]) if side == 1 else np.array([0.0, -1.0, 0.0])
    return Task(name, way, target, seam, params.plain_, up, params, stitch)

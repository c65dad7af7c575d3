"""Profile: the outline that a worked part has at rest, round by round, to be drawn anew or compared."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from tambour.core.check import Array
from tambour.core.drawing import Drawing, Groups, Styles
from tambour.core.errors import TambourError
from tambour.core.graph import ROOT, TIP, StitchGraph
from tambour.core.paths import Paths
from tambour.crochet.graph.built import Built
from tambour.crochet.model.outline import Outline

if TYPE_CHECKING:
    from tambour.core.mesh import Mesh
    from tambour.crochet.params import CrochetParams
    from tambour.crochet.piece import Plush

MARGIN = 10.0
"""Mm about the outlines on their sheet, and between them."""


def alone(built: Built, part: int, params: CrochetParams, width: float) -> tuple[StitchGraph, Array]:
    """A worked part's graph, and where its nodes lie (N, 3), in stitches of ``width`` mm, when it settles by itself."""
    from tambour.crochet.finish.shape import Task, simulate
    from tambour.crochet.settle.arrange import cut

    stuffing = params.stuffing or "pressure"
    graph = replace(built.graph, faces=built.graph.faces[built.shell])
    here = graph.parts[part]
    piece = cut(graph, np.arange(here.start, here.end))
    none = np.zeros(len(piece.parts), np.int64)
    return piece, simulate(Task(piece, params, width, stuffing, "rounds", none, stuffing == "pressure")).x


def turning(graph: StitchGraph, x: Array) -> tuple[Array, Array]:
    """Radius and height (R, 2) of every round of a part whose nodes lie at x (N, 3), about its own axis, and the same
    (2, 2) of its root and its tip, nan where there is none.
    """
    plain = (graph.peculiarity != ROOT) & (graph.peculiarity != TIP)
    number = np.maximum(graph.round - graph.round[plain].min(initial=0), 0)
    count = int(number.max(initial=-1)) + 1
    many = np.maximum(np.bincount(number[plain], minlength=count), 1)
    middle = np.column_stack([np.bincount(number[plain], x[plain, k], count) / many for k in range(3)])
    # The axis is upright, as the part was laid out: rings lie level, but for the spiral.
    off = x - middle[number]
    radius = np.bincount(number[plain], np.hypot(off[plain, 0], off[plain, 2]), count) / many
    ends = np.full((2, 2), np.nan)
    for k, kind in enumerate((ROOT, TIP)):
        found = np.flatnonzero(graph.peculiarity == kind)
        if len(found):
            ends[k] = 0.0, x[found[0], 1]
    return np.column_stack([radius, middle[:, 1]]), ends


def outline_of(built: Built, part: int, params: CrochetParams, stitch: tuple[float, float], name: str = "") -> Outline:
    """The outline of a part at rest, mm, from where its work begins to where it ends."""
    graph, x = alone(built, part, params, stitch[0])
    rings, ends = turning(graph, x)
    line = np.concatenate([ends[:1], rings, ends[1:]])
    return Outline(line[np.isfinite(line).all(1)] * stitch[0], name)


def swept(outline: Outline, around: int = 48, along: int = 72) -> tuple[Array, Array]:
    """The surface that an outline sweeps about its axis: vertices (V, 3) mm and faces (F, 3), up +y, seen from outside."""
    line = outline.at(np.linspace(0.0, outline.way[-1], along))
    angle = np.arange(around) * (2.0 * np.pi / around)
    ring = np.column_stack([np.cos(angle), np.zeros(around), -np.sin(angle)])
    vertices = line[:, None, :1] * ring + line[:, None, 1:] * np.array([0.0, 1.0, 0.0])
    a = np.arange(around)
    b = (a + 1) % around
    strip = np.concatenate([np.column_stack([a, b, a + around]), np.column_stack([b, b + around, a + around])])
    faces = (np.arange(along - 1)[:, None, None] * around + strip).reshape(-1, 3)
    return vertices.reshape(-1, 3), faces.astype(np.int32)


def girths(mesh: Mesh, levels: int = 120) -> Outline:
    """The outline of a body of revolution as wide, all the way up, as the mesh is round: at every height the girth of its
    section, shared by 2π. TambourError where it has no height."""
    x = np.asarray(mesh.vertices, float)[mesh.faces]
    low, high = float(x[..., 1].min()), float(x[..., 1].max())
    if high - low <= 1e-6 * float(np.ptp(x.reshape(-1, 3), axis=0).max()):
        raise TambourError("the target is flat", hint="a body of some height is wanted, upright")
    # Fine at the ends, where a round end widens at once.
    level = low + (high - low) * 0.5 * (1.0 - np.cos(np.pi * (np.arange(levels) + 0.5) / levels))
    line = np.zeros((levels + 2, 2))
    line[1:-1, 1], line[0, 1], line[-1, 1] = level, low, high
    for k, at in enumerate(level, start=1):
        side = x[..., 1] - at
        cut = x[(side.min(1) < 0.0) & (side.max(1) >= 0.0)]
        ends = []
        for i, j in ((0, 1), (1, 2), (2, 0)):
            a, b = cut[:, i], cut[:, j]
            crosses = (a[:, 1] < at) != (b[:, 1] < at)
            t = np.where(crosses, (at - a[:, 1]) / np.where(crosses, b[:, 1] - a[:, 1], 1.0), np.nan)[:, None]
            ends.append(a + t * (b - a))
        three = np.stack(ends, axis=1)
        known = np.isfinite(three[..., 0])
        pair = np.argsort(~known, axis=1, kind="stable")[:, :2]
        two = np.take_along_axis(three, pair[..., None], axis=1)[known.sum(1) == 2]
        line[k, 0] = np.sqrt(((two[:, 0] - two[:, 1]) ** 2).sum(1)).sum() / (2.0 * np.pi)
    return Outline(line)


def view(piece: Plush) -> Drawing:
    """The half outlines of all parts that are worked round upon round from a ring, side by side, each a line with its part's name.

    Drawn anew and given back with ``--reshape``, they change the pattern.
    """
    from tambour.crochet.model.reshape import rows

    built, lines, names, right = piece.built, [], [], MARGIN
    for k, fact in enumerate(built.parts):
        section = built.pattern.parts[fact.section]
        if fact.copy != 1 or isinstance(rows(built, k), str):
            continue
        found = outline_of(built, k, piece.params, piece.stitch).line
        down = found[:, 1] - found[:, 1].min()
        line = np.column_stack([found[:, 0], down if built.up == "start" else down.max() - down])
        lines.append(line + np.array([right, MARGIN]))
        right += float(line[:, 0].max()) + MARGIN
        names.append(section.name or "piece")
    if not lines:
        hint = "an outline is that of a part worked in rounds from a ring"
        raise TambourError("no part of this pattern has an outline", hint=hint, where=built.pattern.text.name)
    high = max(float(line[:, 1].max()) for line in lines) + MARGIN
    return Drawing(
        Paths.of(lines),
        np.zeros(len(lines), np.int32),
        Styles.of((None, (40, 40, 40, 255), 0.5)),
        np.array([right, high]),
        group=np.arange(len(lines)),
        groups=Groups(
            tuple(f"part-{k + 1}" for k in range(len(names))),
            tuple(names),
            np.full(len(names), -1, np.int32),
            data=tuple({} for _ in names),
        ),
        about={"title": "Outlines"},
    )

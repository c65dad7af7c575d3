"""Settled: a part of rounds worked and brought to rest by itself, as the plush would be, without its yarn."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from tambour.core.check import Array
from tambour.core.graph import StitchGraph
from tambour.crochet.model.rounds import Rounds, pattern

if TYPE_CHECKING:
    from tambour.crochet.finish.shape import Known
    from tambour.crochet.graph.built import Built
    from tambour.crochet.language.tree import Pattern
    from tambour.crochet.params import CrochetParams


@dataclass(frozen=True, eq=False, slots=True)
class Settled:
    """A worked part at rest: its graph, positions x (N, 3) in stitches (the stitch's width is 1), and whether it rests."""

    graph: StitchGraph
    x: Array
    settled: bool


def settled(part: Rounds, params: CrochetParams, stitch: tuple[float, float] = (5.0, 5.0)) -> Settled:
    """A single part (of its copies one) at rest by itself, as upright as it is sewn on. stitch : width and height of a single crochet, mm."""
    import numpy as np

    from tambour.crochet.finish.pulled import pulled
    from tambour.crochet.finish.shape import Task, first_positions, risen, simulate
    from tambour.crochet.graph.build import build

    built = build(pattern([replace(part, copies=1, name="Part")]), stitch=stitch)
    graph = pulled(built, built.graph)
    task = Task(
        replace(graph, faces=graph.faces[built.shell]),
        params,
        stitch[0],
        params.stuffing or "pressure",
        "rounds",
        np.zeros(len(graph.parts), np.int64),
        (params.stuffing or "pressure") == "pressure",
    )
    shape = simulate(task)
    return Settled(task.graph, risen(shape.x, first_positions(task)[0], [np.arange(len(graph))]), shape.settled)


def together(
    pattern: Pattern, params: CrochetParams, stitch: tuple[float, float], known: Known | None = None
) -> tuple[Built, Array, Array, bool]:
    """A pattern worked, its parts sewn on and brought to rest together: positions (N, 3) in stitches, the faces that are seen, and
    whether it rests. known : how its parts came to rest by themselves, of patterns before and of this one."""
    import numpy as np

    from tambour.crochet.finish.covered import seen
    from tambour.crochet.finish.joining import prepare
    from tambour.crochet.finish.pulled import pulled
    from tambour.crochet.finish.shape import Task, simulate
    from tambour.crochet.graph.build import build

    built = build(pattern, stitch=stitch)
    graph = pulled(built, built.graph)
    stuffing = params.stuffing or "pressure"
    task = Task(
        replace(graph, faces=graph.faces[built.shell]),
        params,
        stitch[0],
        stuffing,
        "rounds",
        np.zeros(len(graph.parts), np.int64),
        stuffing == "pressure",
        prepare(built),
        known=known,
    )
    shape = simulate(task)
    return built, shape.x, seen(graph, shape.x, shape.joined, task.graph.faces), shape.settled

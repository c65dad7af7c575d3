"""Piece: Plush, the pattern in its shape."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, Final

from tambour.core.check import Array
from tambour.core.errors import TambourError

if TYPE_CHECKING:
    from tambour.core.graph import StitchGraph
    from tambour.core.strands import Strands
    from tambour.crochet.finish.joining import Joining
    from tambour.crochet.finish.shape import Shape
    from tambour.crochet.graph.built import Built
    from tambour.crochet.params import CrochetParams
    from tambour.crochet.yarns import Gauge

MIRROR: Final = (-1.0, 1.0, 1.0)
"""What a left hand makes is the mirror image, left and right changed."""


def turned(graph: StitchGraph) -> StitchGraph:
    """The graph of a piece's mirror image: its outside stays outside. Twice is the graph itself."""
    return replace(graph, faces=graph.faces[:, ::-1].copy(), plane=graph.plane[:, [0, 2, 1]].copy())


@dataclass(frozen=True, eq=False)
class Aim:
    """The model that a pattern was made for.

    vertices (V, 3) mm, faces (F, 3) : the model, laid upon the plush
    distance : how far the plush lies from it, as reports hold it; off : (N,) mm, how far outside of it every stitch lies
    history : part → the mean distances, in stitches, that its corrections went through
    parts : part → how far it lies, by itself, from its own piece of the model
    goals : (N, 3) mm, where every stitch belongs on it; empty for a model that the pattern was not made from; stands : which axes
        of the file are up and ahead
    """

    vertices: Array
    faces: Array
    distance: dict[str, float]
    off: Array
    history: dict[str, list[float]]
    parts: dict[str, dict[str, float]]
    goals: Array
    stands: str


@dataclass(frozen=True, eq=False)
class Plush:
    """A pattern in its shape.

    built : the pattern worked; params : what was asked for; stitch : width and height of a single crochet, mm
    gauge : where that size comes from; stuffing, start : what the options and the pattern together chose
    shape : how the shape was reached, in stitches; positions (N, 3) and centroids (C, 3) : the same in mm, turned as the
        model stands where it was made for one
    joining : what was sewn on and where, None where the pattern says nothing of it
    aim : the model that the pattern was made for, None for a pattern that was given
    """

    built: Built
    params: CrochetParams
    stitch: tuple[float, float]
    gauge: Gauge
    stuffing: str
    start: str
    shape: Shape
    positions: Array
    centroids: Array
    joining: Joining | None = None
    aim: Aim | None = None

    @cached_property
    def yarn(self) -> Strands:
        """The yarn of every stitch, in mm; led when it is first looked at."""
        from tambour.core.paths import Paths
        from tambour.crochet.yarn.fabric import strands
        from tambour.crochet.yarn.fibres import KINDS
        from tambour.crochet.yarn.loops import BLOOM

        bloom = BLOOM * KINDS[self.params.material].full
        detail, hold, graph = self.params.detail, self.params.hold, self.built.graph
        if self.params.hand == "right":
            return strands(graph, self.positions, detail=detail, bloom=bloom, hold=hold)
        # Led as a right hand leads it, and mirrored: so no stitch lies otherwise out of line.
        led = strands(turned(graph), self.positions * MIRROR, detail=detail, bloom=bloom, hold=hold)
        return replace(led, paths=Paths(led.paths.coords * MIRROR, led.paths.offsets))

    @property
    def upright(self) -> Array | None:
        """Which way is up on every part (P, 3), None where all stand as they were worked."""
        return None if self.shape.joined is None else self.shape.joined.upright


def not_empty(piece: Plush) -> None:
    """Refuses a piece without a stitch, for views that show one."""
    if not len(piece.built.graph):
        raise TambourError(
            "the pattern makes no stitch: there is nothing to show",
            hint="begin with a magic ring: a line such as : MR(6)",
            where=piece.built.pattern.text.name,
        )


def mirrored(piece: Plush) -> Plush:
    """What a left hand makes of the same words: the mirror image, left and right changed.

    The yarn follows: it is led along the graph's own ways.
    """
    joined, shape = piece.shape.joined, piece.shape
    if joined is not None:
        shape = replace(shape, joined=replace(joined, upright=joined.upright * MIRROR))
    return replace(
        piece,
        built=replace(piece.built, graph=turned(piece.built.graph)),
        shape=shape,
        positions=piece.positions * MIRROR,
        centroids=piece.centroids * MIRROR,
    )

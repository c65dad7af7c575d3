"""Piece: what the craft makes of a drawing, before any file or view is chosen."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from tambour.core.check import Array, array, offsets, put, within
from tambour.core.drawing import Drawing
from tambour.core.errors import LawError
from tambour.core.paths import Paths
from tambour.core.thread import ThreadPlan

if TYPE_CHECKING:
    from tambour.embroidery.params import EmbroideryParams

# What a needle point was made for; the stitch that ends at the point is of this kind.
FILL: Final = 0
SATIN: Final = 1
RUNNING: Final = 2
UNDERLAY: Final = 3
TRAVEL: Final = 4
LOCK: Final = 5
KINDS: Final = ("fill", "satin", "running", "underlay", "travel", "lock")


AUTO: Final = "auto"  # the stitch of a region that nobody has chosen yet
MANY: Final = 1500  # regions, or lines of them, above which none are compared with each other


@dataclass(frozen=True, eq=False, slots=True)
class Region:
    """One thing to embroider: an area or a line, of one colour, with its own parameters.

    id : the element's id in the source, for people and for errors
    paths : mm, y down, origin at the hoop's centre. Areas are valid polygons (``paths.parts`` given, outline first,
        then holes); lines are polylines without parts; rails of a satin column are two paths, its rungs follow
    stitch : family (tatami, satin, running, …), or AUTO until it is decided
    color : sRGB
    params : the craft's parameters with this region's overrides
    role : "area", "line" or "rails"
    width : width of a line, mm (0 for areas)
    guide : lines that guided, flow and ripple stitches follow, or None
    start, end : places asked for by the source (command symbols), or None
    flags : "trim" and "stop": what is done after it; "whole": laid out by hand, and not to be cut or joined;
        "letter": of a line of text, which is sewn in the order in which it is read
    cap, join : of lines, how they end and turn, as in Styles
    alpha : how much of its colour covers what is below, 0 … 1; 1 for all once the drawing is flat
    rank : its place in the order of sewing among those that have one, or None
    """

    id: str
    paths: Paths
    stitch: str
    color: tuple[int, int, int]
    params: EmbroideryParams
    role: str = "area"
    width: float = 0.0
    guide: Paths | None = None
    start: tuple[float, float] | None = None
    end: tuple[float, float] | None = None
    flags: frozenset[str] = frozenset()
    rank: int | None = None
    cap: int = 1
    join: int = 1
    alpha: float = 1.0

    @property
    def turn(self) -> float:
        """The angle of its rows, radians."""
        return math.radians(self.params.angle or 0.0)


@dataclass(frozen=True, eq=False, slots=True)
class Piece:
    """An embroidery.

    drawing : the source, as it was read
    regions : R regions in painter's order
    params : what was asked for
    plan : ThreadPlan of N needle points and commands
    region : (N,) int32 → regions, -1 for none
    kind : (N,) uint8, one of FILL, SATIN, RUNNING, UNDERLAY, TRAVEL, LOCK: of the stitch that ends at this point
    elevation : (N,) float64 mm, how much thread lies below the stitch that ends here (0: on the cloth)
    rows : (S + 1,) int64, rising; needle points ``rows[k]`` … ``rows[k + 1] - 1`` are one run that is stitched without
        a change of kind, region or direction beyond a turn: a row of a fill, one side-to-side stitch of a satin. A
        run begins at the needle point before its first stitch, so a strand of run k goes through
        ``rows[k] - 1 … rows[k + 1] - 1`` (see ``strands()``)
    facts : what was measured while it was made
    """

    drawing: Drawing | None
    regions: tuple[Region, ...]
    params: EmbroideryParams
    plan: ThreadPlan
    region: Array
    kind: Array
    elevation: Array
    rows: Array
    facts: Mapping[str, Any] = field(default_factory=dict)

    def __post_init__(self) -> None:
        n = len(self.plan)
        kind = array("Piece.kind", self.kind, np.uint8, (n,))
        region = array("Piece.region", self.region, np.int32, (n,))
        within("Piece.kind", kind, 0, len(KINDS))
        within("Piece.region", region, -1, max(1, len(self.regions)))
        rows = offsets("Piece.rows", self.rows, n)
        if (np.diff(rows) == 0).any():
            raise LawError("Piece.rows: an empty run")
        put(self, kind=kind, region=region, rows=rows, elevation=array("Piece.elevation", self.elevation, "f8", (n,)))

    def strands(self) -> tuple[Array, Array]:
        """Runs as index ranges: (first, last) (S',) int64 needle points, both included, of every run that is thread.

        A run's first index is the point its first stitch leaves from; runs of commands and jumps are left out.
        """
        first, last = self.rows[:-1] - 1, self.rows[1:] - 1
        thread = (self.plan.command[self.rows[:-1]] == 0) & (first >= 0)
        return first[thread], last[thread]

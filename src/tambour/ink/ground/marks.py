"""Marks: what the brush left on the paper, in painter's order, and which element each mark belongs to."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tambour.core.check import Array, array, offsets, put, within
from tambour.core.errors import LawError
from tambour.ink.ground.codes import numbers

BODY, VEIL, WASH, STROKE, BLOB, RING, LINE = numbers(7)
KINDS = ("body", "veil", "wash", "stroke", "blob", "ring", "line")
"""What a mark is. ``body``: an opaque paper-coloured outline that hides what lies behind. ``veil``: translucent paper
(mist, snow). ``wash``: a flat tone without a line. ``stroke``: a brush line. ``blob``: one touch of the brush (a leaf,
a needle, a drop, a knot). ``ring``: the outline of a blob, drawn as a brush line (bark). ``line``: a thin open line."""

INK, LEAF, BLOSSOM, SEAL, LIGHT, FAR = numbers(6)
TINTS = ("ink", "leaf", "blossom", "seal", "light", "far")
"""Which colour a mark's grey is mixed with: the ink, what the season colours, the seal's vermilion, moon and lamps, far hills."""


@dataclass(frozen=True, eq=False, slots=True)
class Elements:
    """E things drawn: hills, trees, boats; a part (a tree on a hill) names its whole as ``parent``.

    id : E unique names that depend on the seed and the thing alone
    kind : (E,) uint8 → ``names``
    names : the kinds, in words
    parent : (E,) int32, -1 for a whole; a whole stands before its parts, and its parts follow it without a gap
    at : (E, 2) float64, where it stands (its foot), scroll units
    bounds : (E, 4) float64, left, top, right, bottom of its marks with its parts' (of ``at`` where it has none)
    """

    id: tuple[str, ...]
    kind: Array
    names: tuple[str, ...]
    parent: Array
    at: Array
    bounds: Array

    def __post_init__(self) -> None:
        n = len(self.id)
        kind = array("Elements.kind", self.kind, np.uint8, (n,))
        within("Elements.kind", kind, 0, len(self.names))
        parent = array("Elements.parent", self.parent, np.int32, (n,))
        if n and ((parent >= np.arange(n)).any() or (parent < -1).any()):
            raise LawError("Elements.parent: a whole must stand before its parts")
        put(
            self,
            kind=kind,
            parent=parent,
            at=array("Elements.at", self.at, np.float64, (n, 2)),
            bounds=array("Elements.bounds", self.bounds, np.float64, (n, 4)),
        )

    def __len__(self) -> int:
        return len(self.id)

    @property
    def counts(self) -> dict[str, int]:
        """How many of each kind, in the order of ``names``; kinds that do not occur are left out."""
        found = np.bincount(self.kind, minlength=len(self.names))
        return {name: int(k) for name, k in zip(self.names, found) if k}


@dataclass(frozen=True, eq=False, slots=True)
class Marks:
    """K marks in painter's order: the first is painted first.

    coords : (P, 2) float64 outlines, scroll units, y down; ``offsets`` (K + 1,) int64. A filled outline closes itself;
        a ``line`` is open
    spine : (Q, 2) float64 the way of the brush, ``spines`` (K + 1,) int64: the centre line of a stroke or line, the axis
        (two points, tip to tip) of a blob or ring; for bodies, veils and washes the outline itself
    kind : (K,) uint8 → KINDS
    fill, stroke : (K, 2) uint8 grey (0 black, 255 paper) and opacity (0 none, 255 opaque) of the inside and the edge
    edge : (K,) float64 width of the edge line, units
    breadth : (K,) float64 greatest width of a stroke, blob or ring's line across its spine, units; 0 for others
    tint : (K,) uint8 → TINTS
    element : (K,) int32 → elements; marks of one whole (with its parts) stand together
    elements : Elements
    """

    coords: Array
    offsets: Array
    spine: Array
    spines: Array
    kind: Array
    fill: Array
    stroke: Array
    edge: Array
    breadth: Array
    tint: Array
    element: Array
    elements: Elements

    def __post_init__(self) -> None:
        coords = array("Marks.coords", self.coords, np.float64, (None, 2))
        ends = offsets("Marks.offsets", self.offsets, len(coords))
        n = len(ends) - 1
        spine = array("Marks.spine", self.spine, np.float64, (None, 2))
        kind = array("Marks.kind", self.kind, np.uint8, (n,))
        within("Marks.kind", kind, 0, len(KINDS))
        tint = array("Marks.tint", self.tint, np.uint8, (n,))
        within("Marks.tint", tint, 0, len(TINTS))
        element = array("Marks.element", self.element, np.int32, (n,))
        within("Marks.element", element, 0, max(1, len(self.elements)))
        spines = offsets("Marks.spines", self.spines, len(spine))
        if len(spines) != n + 1:
            raise LawError(f"Marks.spines: {len(spines)} offsets for {n} marks")
        put(
            self,
            coords=coords,
            offsets=ends,
            spine=spine,
            spines=spines,
            kind=kind,
            fill=array("Marks.fill", self.fill, np.uint8, (n, 2)),
            stroke=array("Marks.stroke", self.stroke, np.uint8, (n, 2)),
            edge=array("Marks.edge", self.edge, np.float64, (n,)),
            breadth=array("Marks.breadth", self.breadth, np.float64, (n,)),
            tint=tint,
            element=element,
        )

    def __len__(self) -> int:
        return len(self.kind)

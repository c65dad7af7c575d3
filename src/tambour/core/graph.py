"""StitchGraph: crochet as a graph, a node where the hook pulls a loop over, edges where fabric joins them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from tambour.core.check import Array, array, offsets, put, within
from tambour.core.errors import LawError

# Edge kinds: along the working yarn, into the anchor below, sewn together afterwards, a slip stitch's join, two stitches
# that one stitch was worked through, so that they lie on each other, a stitch in a chain space and the one beside the space
# that it stands over; a thread that is pulled through the stuffing from one stitch to another.
YARN: Final = 0
THROUGH: Final = 1
SEWN: Final = 2
JOIN: Final = 3
LAID: Final = 4
OVER: Final = 5
THREAD: Final = 6

# Loops worked into.
BOTH: Final = 0
FRONT: Final = 1
BACK: Final = 2

# Peculiarities.
PLAIN: Final = 0
ROOT: Final = 1
TIP: Final = 2
FLO: Final = 3
BLO: Final = 4


@dataclass(frozen=True, slots=True)
class Part:
    """A piece worked on its own: nodes ``start`` to ``end`` - 1. ``stuffing`` scales the amount (0 none, 1 as chosen).

    hollow : its nodes from the first to before the second lie inside, pushed in by hand; none where they are equal
    """

    name: str
    start: int
    end: int
    stuffing: float = 1.0
    hollow: tuple[int, int] = (0, 0)


@dataclass(frozen=True, eq=False, slots=True)
class StitchGraph:
    """N nodes, E edges, F faces; index order is the order of work.

    kind : (N,) uint8 → kinds (names such as "sc", "ring", "ch", "tip")
    part : (N,) int32 → parts
    color : (N, 3) uint8 sRGB
    parent : (N,) int32, the node it is worked into (the last, for a decrease), -1 for none
    round : (N,) int32, the round within the whole piece (rising), -1 for none
    loop : (N,) uint8: BOTH, FRONT, BACK
    direction : (N,) int8: +1 worked in the first direction, -1 after a turn
    height : (N,) float64, in stitch heights (sc 1)
    peculiarity : (N,) uint8: PLAIN, ROOT, TIP, FLO, BLO
    plane : (N, 3) int32, nodes a, b, c that span the plane of a single-loop stitch, -1 where there is none; the normal
        (b - a) x (c - a) points to the back loop's side
    span : (N, 2) int32, character offsets of the action's name in the pattern
    edges : (E, 2) int32, edges[:, 0] > edges[:, 1], no pair twice; edge_kind : (E,) uint8
    rest : (E,) float64, rest length in mm
    faces : (F, 3) int32, the fabric's triangles as the hook's walk leaves them, outside counter-clockwise
    parts : tuple[Part]
    anchors, anchor_offsets : ragged list (N + 1 offsets) of the nodes each node is worked into, in order
    previous : (N,) int32, the node that the yarn comes from, -1 at a start

    >>> from tambour.run import make
    >>> graph = make("crochet", "examples/crochet/coaster.acl").piece.built.graph
    >>> len(graph.kind) == len(graph), "sc" in graph.kinds
    (True, True)
    """

    kind: Array
    kinds: tuple[str, ...]
    part: Array
    color: Array
    parent: Array
    round: Array
    loop: Array
    direction: Array
    height: Array
    peculiarity: Array
    plane: Array
    span: Array
    edges: Array
    edge_kind: Array
    rest: Array
    faces: Array
    parts: tuple[Part, ...]
    anchors: Array
    anchor_offsets: Array
    previous: Array

    def __post_init__(self) -> None:
        kind = array("StitchGraph.kind", self.kind, np.uint8, (None,))
        n = len(kind)
        edges = array("StitchGraph.edges", self.edges, np.int32, (None, 2))
        e = len(edges)
        if e and (edges[:, 0] <= edges[:, 1]).any():
            raise LawError("StitchGraph.edges: the first node of an edge must be the later one")
        within("StitchGraph.kind", kind, 0, max(1, len(self.kinds)))
        within("StitchGraph.edges", edges, 0, n)
        anchors = array("StitchGraph.anchors", self.anchors, np.int32, (None,))
        fields = {
            "part": (np.int32, (n,)),
            "color": (np.uint8, (n, 3)),
            "parent": (np.int32, (n,)),
            "round": (np.int32, (n,)),
            "loop": (np.uint8, (n,)),
            "direction": (np.int8, (n,)),
            "height": (np.float64, (n,)),
            "peculiarity": (np.uint8, (n,)),
            "plane": (np.int32, (n, 3)),
            "span": (np.int32, (n, 2)),
            "edge_kind": (np.uint8, (e,)),
            "rest": (np.float64, (e,)),
            "faces": (np.int32, (None, 3)),
            "previous": (np.int32, (n,)),
        }
        made = {
            name: array(f"StitchGraph.{name}", getattr(self, name), dtype, shape)
            for name, (dtype, shape) in fields.items()
        }
        within("StitchGraph.part", made["part"], 0, max(1, len(self.parts)))
        for name in ("parent", "plane", "previous"):
            within(f"StitchGraph.{name}", made[name], -1, max(1, n))
        within("StitchGraph.faces", made["faces"], 0, max(1, n))
        ends = offsets("StitchGraph.anchor_offsets", self.anchor_offsets, len(anchors))
        if len(ends) != n + 1:
            raise LawError("StitchGraph.anchor_offsets: must be one longer than the nodes")
        put(self, kind=kind, edges=edges, anchors=anchors, anchor_offsets=ends, **made)

    def __len__(self) -> int:
        return len(self.kind)

    @property
    def stitch_width(self) -> float:
        """Width of a stitch, mm: the mean rest length along the yarn; 5 where there is no such edge.

        >>> from tambour.run import make
        >>> make("crochet", "examples/crochet/coaster.acl").piece.built.graph.stitch_width > 2
        True
        """
        along = self.edge_kind == YARN
        return float(self.rest[along].mean()) if along.any() else 5.0

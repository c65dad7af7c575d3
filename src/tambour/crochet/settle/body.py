"""Body: a stitch graph as arrays for the kernels, and the one function that sums all of its forces.

Lengths are in stitches (the stitch's width is 1). `displacement` is the seed's D: what a step adds to the positions.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

import numpy as np

from tambour.core.check import Array
from tambour.core.graph import BLO, FLO, ROOT, SEWN, THREAD, StitchGraph
from tambour.crochet.settle.straight import straight

if TYPE_CHECKING:
    from tambour.crochet.params import CrochetParams

SKIN = 0.5
"""How much farther than the reach of contact pairs are listed, so that the list serves several evaluations."""
LEAST_VOLUME = 0.01
"""Below this share of A^1.5, A the part's area in stitches, the pressure rises no further (a ball has 0.094)."""
SEAM_HEIGHT = 0.4
"""How far above the fabric that they are sewn to stitches of a seam lie at least, in stitches."""
LAID = 1.5
"""How strongly flat parts of printed toys resist bending: hands lay them smooth where they sew them on."""
HINGE = 0.2
"""How stiff unstuffed fabric is where it hangs on one loop, as a share of what it is elsewhere."""
SMOOTHING = 2
"""How often the skeleton's centres are smoothed."""


@dataclass(frozen=True, eq=False, slots=True)
class Body:
    """Everything that the forces need and that does not move. Every list is sorted by its latest node.

    Shapes: part (N,), root (N,) the node that stays where it is for each node; edges (E, 2), rest (E,);
    loop_nodes (L,), loop_planes (L, 3), loop_strength (L,); triples (T, 3), bending (T,);
    fabric (G, 3) faces without lids; faces (F, 3), face_part (F,), lid_offsets, lid_nodes with them; amount (P,) of
    stuffing, per_edge and pressure (P,) its ln V energy per edge and in all, least (P,) volume, and most (P,), where fibre lies loose;
    folds : whether the fabric answers the push of a single loop, as a hinge does (the seed's steps push one-sidedly)
    threads (K, 2), thread_most (K,) : pulled through the stuffing, from stitch to stitch, and how long they are
    lying (K, 4) : stitches of placed parts' seams and triangles that they lie on
    hinges (H, 4), weights (H, 4), plane : what keeps sheets flat (:mod:`tambour.crochet.settle.laid`), and how strongly
    offsets, neighbours : the edges as ragged lists; reach, near, touch : contact's distances and stiffness (0: none)
    centroid : f, cap, b, c; first (P + 1,) each part's centroids
    radius (S,), section_offsets, members, section_neighbours : the skeleton, see bones; bone (P + 1,) each part's sections
    """

    stuffing: str
    part: Array
    root: Array
    edges: Array
    rest: Array
    loop_nodes: Array
    loop_planes: Array
    loop_strength: Array
    triples: Array
    bending: Array
    fabric: Array
    faces: Array
    face_part: Array
    lid_offsets: Array
    lid_nodes: Array
    amount: Array
    per_edge: Array
    pressure: Array
    least: Array
    most: Array
    offsets: Array
    neighbours: Array
    reach: float
    near: float
    touch: float
    centroid: tuple[float, float, float, float]
    first: Array
    bone: Array
    radius: Array
    section_offsets: Array
    members: Array
    section_neighbours: Array
    skeleton: float
    threads: Array
    thread_most: Array
    lying: Array
    folds: bool
    hinges: Array = field(default_factory=lambda: np.zeros((0, 4), np.int32))
    weights: Array = field(default_factory=lambda: np.zeros((0, 4)))
    plane: float = 0.0

    def __len__(self) -> int:
        return len(self.part)

    @property
    def cubic(self) -> bool:
        """Whether links follow the seed's cubic law rather than springs."""
        return self.stuffing in ("centroid", "skeleton")

    @property
    def step(self) -> float:
        """The factor of a plain step: the seed's 1, and 0.2 for springs, which would swing at 1."""
        return 1.0 if self.cubic else 0.2


@dataclass(eq=False, slots=True)
class State:
    """What moves: positions x (N, 3) and centroids c (C, 3); what was last measured; the edges' offsets, and what
    is about each node of that fabric (:func:`tambour.crochet.settle.contact.about`)."""

    x: Array
    c: Array
    volume: Array
    pair: Array = field(default_factory=lambda: np.zeros((0, 2), np.int32))
    reach: Array = field(default_factory=lambda: np.zeros(0))
    listed: Array | None = None
    about: tuple[Array, Array, Array] | None = None
    evaluations: int = 0


def volumes(body: Body, x: Array) -> Array:
    """The volume of every part (P,) in cubic stitches, openings closed by lids."""
    from tambour.crochet.settle.stuffing import pressure

    made, none = np.zeros(len(body.amount)), np.zeros(len(body.amount))
    lids = (body.lid_offsets, body.lid_nodes)
    pressure(x, body.faces, body.face_part, *lids, none, body.least, body.most, made, np.zeros_like(x))
    return made


def displacement(body: Body, state: State, move_centroids: bool = True, held: Array | None = None) -> Array:
    """D (N, 3): the sum of all forces on every node, less that on its root. Moves the centroids of ``state``.

    held : (N,) bool, nodes that stay; a piece with such a node moves against them, not against its root
    """
    from tambour.crochet.settle import contact, forces, stuffing

    x = state.x
    D = np.zeros_like(x)
    forces.link(x, body.edges, body.rest, body.cubic, D)
    if len(body.threads):
        forces.thread(x, body.threads, body.thread_most, D)
    if len(body.triples):
        forces.bend(x, body.triples, body.bending, D)
    if len(body.hinges):
        forces.flat(x, body.hinges, body.weights, body.plane, D)
    if body.stuffing == "pressure":
        lids = (body.lid_offsets, body.lid_nodes)
        stuffing.pressure(x, body.faces, body.face_part, *lids, body.pressure, body.least, body.most, state.volume, D)
    elif body.stuffing == "centroid":
        c = state.c if move_centroids else state.c.copy()
        stuffing.centroids(x, body.part, body.first, c, *body.centroid, body.amount, D)
    elif body.stuffing == "skeleton":
        centres = np.zeros((len(body.radius), 3))
        stuffing.sections(x, body.section_offsets, body.members, body.section_neighbours, SMOOTHING, centres)
        cap = body.centroid[1]
        stuffing.skeleton(x, body.part, body.bone, centres, body.radius, body.skeleton, cap, body.amount, D)
        state.c = centres
    lean = forces.fold if body.folds else forces.single_loop
    lean(x, body.loop_nodes, body.loop_planes, body.loop_strength, D)
    if body.touch > 0.0:
        touching(body, state)
        contact.contact(x, state.pair, state.reach, body.touch, D)
        if len(body.lying):
            contact.lie(x, body.lying, SEAM_HEIGHT, body.touch, D)
    state.evaluations += 1
    if held is None or not held.any():
        forces.against(body.root, D)
        return D
    anchored = np.zeros(len(D), bool)
    anchored[body.root[held]] = True
    D -= np.where(anchored[body.root, None], 0.0, D[body.root])
    D[held] = 0.0
    return D


def touching(body: Body, state: State) -> None:
    """List the pairs of ``state`` that may touch, unless the last list still serves."""
    from tambour.crochet.settle import contact

    x = state.x
    known = state.listed
    if known is not None and len(known) == len(x) and contact.strayed(x, known) < (0.5 * SKIN) ** 2:
        return
    if state.about is None or state.about[0] is not body.offsets:
        state.about = (body.offsets, *contact.about(body.offsets, body.neighbours))
    asked = (body.offsets, body.neighbours, body.reach, body.near, SKIN)
    state.pair, state.reach = contact.pairs(x, *asked, state.about[1:])
    state.listed = x.copy()


def build(
    graph: StitchGraph,
    params: CrochetParams,
    width: float,
    stuffing: str,
    centroids: Array | None = None,
    laid: frozenset[str] = frozenset(),
) -> Body:
    """The body of a graph.

    width : the stitch's width in mm, the unit of length; stuffing : what fills it
    centroids : (P,) the number of each part's centroids, for centroid stuffing; laid : parts that hands lay smooth, by name
    """
    from tambour.crochet.graph.layout import rise, sections
    from tambour.crochet.graph.lids import lids
    from tambour.crochet.settle.bones import bones
    from tambour.crochet.settle.contact import ragged

    n, parts, folds = len(graph), len(graph.parts), params.solver == "settle"
    order = np.argsort(graph.edges[:, 0], kind="stable")
    pulled = order[graph.edge_kind[order] == THREAD]
    order = order[graph.edge_kind[order] != THREAD]
    edges = graph.edges[order]
    rest = graph.rest[order] / width * params.link_distance
    faces = graph.faces[np.argsort(graph.faces.max(1, initial=0), kind="stable")]
    face_part = graph.part[faces.max(1, initial=0)]
    fabric = faces
    faces, face_part, rims, rim = lids(faces, face_part, n)
    inside = np.bincount(graph.part[edges[:, 0]], minlength=parts)
    amount = np.array([0.0 if stuffing == "none" else p.stuffing for p in graph.parts], np.float64)
    area = np.array([p.end - p.start for p in graph.parts], np.float64)
    loops = np.flatnonzero(np.isin(graph.peculiarity, (FLO, BLO)) & (graph.plane >= 0).all(1))
    loops = loops[np.argsort(np.maximum(loops, graph.plane[loops].max(1, initial=0)), kind="stable")]
    if folds:
        loops = loops[_turning(graph, loops)]
    sign = np.where(graph.peculiarity[loops] == BLO, 1.0, -1.0)
    offsets, neighbours = ragged(n, edges, graph.edge_kind[order] == SEWN)
    radius, section_offsets, members, beside = bones(graph, sections(graph), rise(graph, graph.rest / width))
    bone = np.searchsorted(graph.part[members[section_offsets[:-1]]], np.arange(parts + 1)).astype(np.int64)
    triples, stiff = straight(graph, amount, 0.0 if _cubic(stuffing) else params.bending)
    if len(triples) and laid and not _cubic(stuffing):
        smooth = np.array([p.name in laid for p in graph.parts])[graph.part[triples[:, 0]]]
        stiff = np.where(smooth, LAID / params.bending * stiff, stiff)
    if folds and len(triples):
        single = np.isin(graph.peculiarity[triples[:, 0]], (FLO, BLO)) & (graph.parent[triples[:, 0]] == triples[:, 1])
        stiff = np.where(single, HINGE * stiff, stiff)
    first = np.zeros(parts + 1, np.int64)
    if centroids is not None:
        np.cumsum(centroids, out=first[1:])
    stiffness = params.contact_stiffness or (0.2 if _cubic(stuffing) else 1.0)
    made = Body(
        stuffing=stuffing,
        part=graph.part,
        root=roots(graph),
        edges=edges,
        rest=rest,
        loop_nodes=loops.astype(np.int32),
        loop_planes=np.ascontiguousarray(graph.plane[loops]),
        loop_strength=sign * params.single_loop_force,
        triples=np.asarray(triples, np.int32).reshape(-1, 3),
        bending=np.asarray(stiff, np.float64),
        fabric=fabric,
        faces=faces.astype(np.int32),
        face_part=face_part.astype(np.int32),
        lid_offsets=rims,
        lid_nodes=rim,
        amount=amount,
        per_edge=params.pressure * amount,
        pressure=params.pressure * amount * inside,
        least=LEAST_VOLUME * area**1.5,
        most=np.full(parts, np.inf),
        offsets=offsets,
        neighbours=neighbours,
        reach=params.contact_distance,
        near=params.contact_near,
        touch=stiffness if params.contact else 0.0,
        centroid=(params.centroid_force, params.centroid_cap, params.weight_peak, params.weight_width),
        first=first,
        bone=bone,
        radius=radius,
        section_offsets=section_offsets,
        members=members,
        section_neighbours=beside,
        skeleton=params.skeleton_force,
        threads=np.ascontiguousarray(graph.edges[pulled]),
        thread_most=graph.rest[pulled] / width,
        lying=np.zeros((0, 4), np.int32),
        folds=folds,
    )
    hollow = stuffing == "pressure" and any(p.hollow[0] < p.hollow[1] for p in graph.parts)
    return replace(made, most=_loose(made, graph, width)) if hollow else made


def _turning(graph: StitchGraph, loops: Array) -> Array:
    """Which of the stitches (L,) in one loop turn the fabric: not those that stand on stitches in the loop of the same side. Ridge
    upon ridge they all lean alike, and a wall worked so is as straight as one in both loops."""
    side = np.where(graph.peculiarity == BLO, 1, -1) * graph.direction * np.isin(graph.peculiarity, (FLO, BLO))
    below = graph.parent[loops]
    return np.asarray((below < 0) | (side[np.maximum(below, 0)] != side[loops]))


def _loose(body: Body, graph: StitchGraph, width: float) -> Array:
    """The volume (P,) at which the fibre of a part with a hollow lies loose: that of its rings, the hollow pushed in, for
    it was filled while hands held it so. Others have none: fabric does not let them swell so far."""
    from tambour.crochet.graph.layout import rounds

    hollow = np.array([p.hollow[0] < p.hollow[1] for p in graph.parts])
    return np.where(hollow, volumes(body, rounds(graph, graph.rest / width)), np.inf)


def grown(body: Body, m: int) -> Body:
    """The body when only its first ``m`` nodes are worked."""
    from tambour.crochet.graph.lids import lids

    def upto(latest: Array) -> int:
        return int(np.searchsorted(latest, m))

    edges = body.edges[: upto(body.edges[:, 0])]
    loops = upto(np.maximum(body.loop_nodes, body.loop_planes.max(1, initial=0)))
    straight = upto(body.triples.max(1, initial=0))
    fabric = body.fabric[: upto(body.fabric.max(1, initial=0))]
    part = body.part[:m]
    faces, face_part, rims, rim = lids(fabric, part[fabric.max(1, initial=0)], m)
    root = body.root[:m]
    lowest = np.full(len(body), m)
    np.minimum.at(lowest, root, np.arange(m))
    kept = upto(body.members)
    sections = int(np.searchsorted(body.section_offsets[:-1], kept))
    beside = body.section_neighbours[:sections]
    return replace(
        body,
        part=part,
        root=np.where(root < m, root, lowest[root]).astype(np.int32),
        edges=edges,
        rest=body.rest[: len(edges)],
        loop_nodes=body.loop_nodes[:loops],
        loop_planes=body.loop_planes[:loops],
        loop_strength=body.loop_strength[:loops],
        triples=body.triples[:straight],
        bending=body.bending[:straight],
        fabric=fabric,
        faces=faces.astype(np.int32),
        face_part=face_part.astype(np.int32),
        lid_offsets=rims,
        lid_nodes=rim,
        threads=body.threads[: upto(body.threads[:, 0])],
        thread_most=body.thread_most[: upto(body.threads[:, 0])],
        pressure=body.per_edge * np.bincount(part[edges[:, 0]], minlength=len(body.amount)),
        bone=np.minimum(body.bone, sections),
        radius=body.radius[:sections],
        section_offsets=np.minimum(body.section_offsets[: sections + 1], kept),
        members=body.members[:kept],
        section_neighbours=np.where(beside < sections, beside, -1).astype(np.int32),
    )


def joined_up(body: Body, nodes: Array, stays: Array, rest: Array, lying: Array) -> Body:
    """The body of ``nodes`` (rising) whose parts were placed.

    stays : pairs (K, 2) of nodes with springs of lengths ``rest`` (K,) between them, no fabric; lying : (L, 4), as in Body
    """
    inside = np.isin(stays, nodes).all(1)
    own = np.searchsorted(nodes, stays[inside])
    edges = np.concatenate([body.edges, np.column_stack([own.max(1, initial=0), own.min(1, initial=len(nodes))])])
    order = np.argsort(edges[:, 0], kind="stable")
    return replace(
        body,
        edges=np.ascontiguousarray(edges[order], body.edges.dtype),
        rest=np.concatenate([body.rest, rest[inside]])[order],
        lying=np.searchsorted(nodes, lying[np.isin(lying, nodes).all(1)]).astype(np.int32),
    )


def enclosing(body: Body, around: Array) -> Body:
    """The body whose parts enclose one volume where ``around`` (T, 3), triangles of their seams, join them: what stuffs each
    presses in all of them, and what the seams leave open is closed by lids."""
    from tambour.crochet.graph.lids import lids

    own = np.unique(body.part[around])
    mine = np.isin(body.part[body.fabric.max(1, initial=0)], own)
    fabric = np.concatenate([body.fabric[mine], around, body.fabric[~mine]]).astype(np.int32)
    of = body.part[fabric.max(1, initial=0)]
    of = np.where(np.isin(of, own), own[0], of)
    faces, face_part, rims, rim = lids(fabric, of, len(body))
    pressure, least = body.pressure.copy(), body.least.copy()
    pressure[own[0]], least[own[0]] = body.pressure[own].sum(), body.least[own].sum()
    pressure[own[1:]] = 0.0
    return replace(
        body,
        faces=faces.astype(np.int32),
        face_part=face_part.astype(np.int32),
        lid_offsets=rims,
        lid_nodes=rim,
        pressure=pressure,
        least=least,
    )


def _cubic(stuffing: str) -> bool:
    return stuffing in ("centroid", "skeleton")


def roots(graph: StitchGraph) -> Array:
    """For each node the node of its connected piece that stays in place (N,): its first root, else its first node."""
    from tambour.crochet.settle.arrange import labels

    n = len(graph)
    if not n:
        return np.zeros(0, np.int32)
    label = labels(n, graph.edges)
    order = np.lexsort((np.arange(n), graph.peculiarity != ROOT, label))
    _, first = np.unique(label[order], return_index=True)
    return order[first][label].astype(np.int32)


def centroid_counts(graph: StitchGraph, params: CrochetParams, told: Sequence[int | None] = ()) -> Array:
    """How many centroids each part has (P,): the option's, else what the pattern told, else one per so many nodes."""
    made = []
    for k, part in enumerate(graph.parts):
        size = part.end - part.start
        wanted = params.centroids
        if wanted is None and k < len(told):
            wanted = told[k]
        made.append(min(size, math.ceil(size / params.nodes_per_centroid) if wanted is None else wanted))
    return np.array(made, np.int64)

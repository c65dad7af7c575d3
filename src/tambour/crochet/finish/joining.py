"""Joining: parts brought onto settled parts, in the order in which one stands on the other, and sewn there."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from tambour.core.check import Array
from tambour.core.errors import Problem, TambourError
from tambour.core.graph import SEWN, StitchGraph
from tambour.crochet.finish import gaze, sewing
from tambour.crochet.finish.arched import arched
from tambour.crochet.finish.capped import across, drawn_over, lid_on, rim_on
from tambour.crochet.finish.globe import motifs, rolled
from tambour.crochet.finish.hanging import hung, laid_on
from tambour.crochet.finish.placing import Frames, frames, level, standing
from tambour.crochet.finish.poised import poised
from tambour.crochet.graph.assemble import SEWN_SHORT
from tambour.crochet.graph.built import Built
from tambour.crochet.graph.spots import Spots
from tambour.crochet.language.finishes import Placed, spots_of
from tambour.crochet.settle.body import Body, enclosing, joined_up
from tambour.geometry.motion import dot, length, turned
from tambour.geometry.near import nearest
from tambour.geometry.surface import vertex_normals

TRUNK = re.compile(r"\b(?:head|body|kopf|k(?:ö|oe)rper|cabeza|cuerpo|tête|corps|hoofd|lichaam)(?![^\W\d_])")
"""Names of parts that are filled, and closed if nothing is sewn to their end."""
BODY = re.compile(r"\b(?:body|k(?:ö|oe)rper|cuerpo|corps|lichaam)(?![^\W\d_])")
"""Of these a free end is closed though the other hangs on a head."""
UPRIGHT = 0.95
"""The cosine of the angle up to which the fabric of an end leans by chance."""
GATHER = 8
"""An edge of fewer stitches closes by itself."""
DISC = 5
"""A disc has so many stitches round its edge for every round or more; with twice as many it is a ruffle."""
APART = 0.5
"""Two seams that come nearer to each other than this, in stitches, are in each other's way."""
SAME_SIDE = 0.5
"""One seam can be inside another where the fabric under both looks so nearly the same way, as a cosine."""
_DEEP = 3
"""So many rounds before its last tell which way an end looks."""
BESIDE = 0.8
"""Seams whose middles are so far apart, as a share of half their widths together, are beside each other."""


@dataclass(frozen=True, eq=False, slots=True)
class Joining:
    """What is to be sewn on: the placed parts with the ends they are sewn by, those that others stand on first."""

    built: Built
    spots: Spots
    steps: tuple[tuple[Placed, sewing.End], ...]
    doubts: tuple[Problem, ...]  # of its spots
    ball: tuple[int, ...] = ()  # parts that make a ball of motifs

    @property
    def joins(self) -> bool:
        """Whether anything is sewn on."""
        return bool(self.steps or self.ball)

    @property
    def pinched(self) -> Array:
        """Pairs (K, 2) of nodes drawn together where an end is pinched, or sewn shut."""
        return np.concatenate(
            [np.zeros((0, 2), int), *(end.pinched for _, end in self.steps), *shut(self.spots, self.steps)]
        )


@dataclass(frozen=True, eq=False, slots=True)
class Joined:
    """Parts in their places, not yet at rest.

    x : (N, 3); upright : (P, 3) which way is up on every part
    seams : for every placed part the pairs (S, 2) sewn, its own stitch first
    held : pairs (H, 2) of nodes, one of either part, whose parts have their places to one another
    stays, rest : pairs (K, 2) of nodes and lengths (K,), in stitches, that keep parts at their angles
    lying : (L, 4) stitches of the seams and the triangles of the fabric that they lie on
    around : (T, 3) triangles of seams by which several pieces enclose one volume: a ball of motifs
    cleared : (N, 3) how far each node was moved, with all of its part, from where it is said to be, to be clear of what is there
    """

    x: Array
    upright: Array
    seams: tuple[Array, ...]
    held: Array
    stays: Array
    rest: Array
    lying: Array
    around: Array
    cleared: Array

    def on(self, body: Body, nodes: Array) -> Body:
        """The body of ``nodes`` (rising) with its parts in their places."""
        body = joined_up(body, nodes, self.stays, self.rest, self.lying)
        within = np.isin(self.around, nodes).all(1)
        return enclosing(body, np.searchsorted(nodes, self.around[within])) if within.any() else body


def prepare(built: Built) -> Joining | None:
    """What a pattern places; None when nothing is done to its parts.

    TambourError with all that is wrong: spots that are not there (of eyes and the like too), parts placed twice or on
    one another in a circle.
    """
    finishes, text = built.pattern.finish, built.pattern.text
    ball = tuple(motifs(Spots(built))) if built.pattern.terms else ()
    if not finishes and not ball:
        return None
    spots = Spots(built)
    problems = list(spots.problems(finishes))
    placed = [f for f in finishes if isinstance(f, Placed) and f.part in spots.parts and f.spot.part in spots.parts]
    first: dict[int, Placed] = {}
    for f in placed:
        part = spots.parts[f.part]
        if part in first:
            hint = f"it is on {first[part].spot.part} already: keep one of the two"
            problems.append(Problem(f'"{f.part}" is placed twice', hint, f.span, text))
            continue
        first[part] = f
        if f.by is not None and spots.round_at(part, round(f.by)) is None:
            problems.append(
                Problem(f'"{f.part}" has no round {f.by:g} to sew it by', "by=… is its number", f.span, text)
            )
    order: list[Placed] = []
    waiting = dict(first)
    while waiting:
        ready = [p for p, f in waiting.items() if spots.parts[f.spot.part] not in waiting]
        if not ready:
            names = ", ".join(f.part for f in waiting.values())
            f = next(iter(waiting.values()))
            message = f"these parts stand on one another in a circle: {names}"
            problems.append(Problem(message, "one of them must stand on another part, or by itself", f.span, text))
            break
        order += [waiting.pop(p) for p in ready]
    if any(not p.warning for p in problems):
        raise TambourError(sorted(problems, key=lambda p: p.span.start if p.span else 0))
    return Joining(built, spots, tuple((f, sewing.end_of(built, spots, f)) for f in order), tuple(problems), ball)


def prepare_what_stands(built: Built) -> tuple[Built, Joining | None]:
    """As :func:`prepare`, for a text as people write it: what cannot be placed is left out and told with what was not read.

    Where a round was not read its number may be missing; the rest of the toy is still to be seen.
    """
    while True:
        try:
            return built, prepare(built)
        except TambourError as error:
            wrong = [p for p in error.problems if not p.warning]
            spans = {p.span for p in wrong}
            kept = tuple(f for f in built.pattern.finish if not spans & {f.span, *(s.span for s in spots_of(f))})
            if len(kept) == len(built.pattern.finish):
                raise
            out = dict.fromkeys(replace(p, message=f"left out: {p.message}", warning=True) for p in wrong)
            told = (*built.pattern.unread, *out)
            built = replace(built, pattern=replace(built.pattern, finish=kept, unread=told))


def shut(spots: Spots, steps: Sequence[tuple[Placed, sewing.End]]) -> list[Array]:
    """Pairs (K, 2) for every stuffed head or body of a printed toy that stays open: hands sew it shut, flat from side to side."""
    built, found = spots.built, list[Array]()
    graph, pattern = built.graph, built.pattern
    if not pattern.terms or not re.search(r"\bstuff|\bfiber\s?fil", pattern.text.text.lower()):
        return found
    taken = {spots.parts[f.part] for f, _ in steps}
    used = [set(place.nodes) for f, _ in steps if (place := spots.place(f.spot)).opening]
    used += [set(end.nodes.tolist()) for _, end in steps]
    crossing = graph.edges[graph.part[graph.edges[:, 0]] != graph.part[graph.edges[:, 1]]]
    for k, fact in enumerate(built.parts):
        section = pattern.parts[fact.section]
        if section.stuffing == 0.0 or spots.in_rows[k] or not TRUNK.search(section.name.lower()):
            continue
        if k in taken and not BODY.search(section.name.lower()):
            continue
        for edge in (spots.rim(k), spots.begun(k)):
            free = len(edge) >= GATHER and not any(set(edge.tolist()) & nodes for nodes in used)
            if free and not np.isin(edge, crossing).any():
                found.append(_level_pairs(edge, spots.layout[edge, 0]))
    return found


def _level_pairs(edge: Array, across: Array) -> Array:
    """Pairs (K, 2) of a round edge (M,) pressed flat from side to side: each stitch with the one above or below it.

    across : (M,) how far to the side each lies
    """
    m = len(edge)
    here = np.arange(m)
    other = min(((c - here) % m for c in range(m)), key=lambda o: float(((across - across[o]) ** 2).sum()))
    some = here < other
    return np.column_stack([edge[here[some]], edge[other[some]]])


def flat_parts(built: Built) -> frozenset[str]:
    """The names of parts without stuffing that lie flat: those in rows, and discs, whose every round has more stitches."""
    graph, spots = built.graph, Spots(built)
    names = set()
    for k, part in enumerate(graph.parts):
        counts = [r.count for r in built.rounds if r.part == k and not r.aside]
        grows = (
            bool(counts) and counts[-1] == max(counts) and DISC * len(counts) <= counts[-1] <= 2 * DISC * len(counts)
        )
        if part.stuffing == 0.0 and (spots.in_rows[k] or grows):
            names.add(part.name)
    return frozenset(names)


def clashes(joining: Joining) -> list[tuple[Placed, Placed]]:
    """Parts whose seams are in each other's way, or one inside of the other, with the one before that they are in the way of."""
    spots, steps = joining.spots, joining.steps
    found: list[tuple[Placed, Placed]] = []
    known: list[tuple[Placed, bool, Array, Array]] = []
    for f, end in steps:
        if f.around:
            continue
        frame = frames(spots, spots.layout, [f.spot])
        span = spots.built.graph.parts[spots.parts[f.part]]
        points = sewing.outline(spots.layout, np.arange(span.start, span.end), f, end, frame)
        normal = frame.normals[0]
        for other, ring, its, way in known:
            if spots.parts[f.spot.part] != spots.parts[other.spot.part]:
                continue
            apart = np.sqrt(((points[:, None] - its) ** 2).sum(2))
            middles = float(np.sqrt(((points.mean(0) - its.mean(0)) ** 2).sum()))
            sizes = [float(np.sqrt(((p - p.mean(0)) ** 2).sum(1).max())) for p in (points, its)]
            # A door on a wall is not inside of the roof's ring over it.
            inside = ((ring and middles < sizes[1]) or (end.ring and middles < sizes[0])) and normal @ way > SAME_SIDE
            # Flukes, legs, petals are sewn side by side, and touch: two alike are in each other's way where they overlap.
            over = middles < BESIDE * sum(sizes) or f.part.rsplit(".", 1)[0] != other.part.rsplit(".", 1)[0]
            if (float(apart.min()) < APART and over) or inside:
                found.append((f, other))
        known.append((f, end.ring, points, normal))
    return found


def crowded(joining: Joining) -> list[Problem]:
    """Doubts about parts whose seams are in each other's way; of twenty leaves one is enough."""
    found: list[Problem] = []
    told: set[tuple[object, ...]] = set()
    for f, other in clashes(joining):
        pair = (f.span, f.part.rsplit(".", 1)[0], other.part.rsplit(".", 1)[0])
        if pair not in told:
            told.add(pair)
            message = f'"{f.part}" and "{other.part}" are sewn to the same place'
            hint = "their seams are in each other's way: move one of the two"
            heads = [p.span for p in joining.built.pattern.parts if p.name in (f.part, f.part.rpartition(".")[0])]
            span = f.span if f.span.end > f.span.start or not heads else heads[0]  # where it is placed by guess
            found.append(Problem(message, hint, span, joining.built.pattern.text, warning=True))
    return found


def with_seams(graph: StitchGraph, pairs: Array, width: float) -> StitchGraph:
    """``graph`` with the ``pairs`` (S, 2) sewn; those that are joined already stay as they are. width : a stitch's, mm."""
    pairs = np.sort(np.asarray(pairs, np.int64).reshape(-1, 2), axis=1)[:, ::-1]
    n = max(len(graph), 1)
    key = np.unique(pairs[:, 0] * n + pairs[:, 1])
    key = key[~np.isin(key, graph.edges[:, 0].astype(np.int64) * n + graph.edges[:, 1])]
    key = key[key // n != key % n]
    edges = np.concatenate([graph.edges, np.column_stack([key // n, key % n])])
    order = np.lexsort((edges[:, 1], edges[:, 0]))
    kind = np.concatenate([graph.edge_kind, np.full(len(key), SEWN, np.uint8)])
    rest = np.concatenate([graph.rest, np.full(len(key), SEWN_SHORT * width)])
    return replace(graph, edges=np.ascontiguousarray(edges[order], np.int32), edge_kind=kind[order], rest=rest[order])


def join(joining: Joining, x: Array, bodies: list[Array]) -> Joined:
    """Every placed part brought to its place.

    x : (N, 3) in stitches, every part by itself, front +z; bodies : the nodes of every body of fabric
    """
    built, spots = joining.built, joining.spots
    graph, x = built.graph, x.copy()
    owner = np.zeros(len(graph), int)
    for b, nodes in enumerate(bodies):
        owner[nodes] = b
    body = [int(owner[p.start]) if p.end > p.start else -1 for p in graph.parts]
    onto = {body[spots.parts[f.part]] for f, _ in joining.steps}
    for span, fact, b in zip(graph.parts, built.parts, body):
        # What stands by itself stands as its pattern says; the rest is turned where it is placed.
        if b not in onto and (up := built.pattern.parts[fact.section].up):
            x[span.start : span.end] = standing(x[span.start : span.end], up)
    for k, b in enumerate(body):
        x = poised(spots, x, k) if b not in onto else x
    nodded = {} if built.pattern.exact else _nodded(joining, x, body, onto)
    upright = np.tile([0.0, 1.0, 0.0], (len(graph.parts), 1))
    cleared = np.zeros_like(x)
    group = {b: [b] for b in range(len(bodies))}
    shell = graph.faces[built.shell]
    seams, held, stays, rest = [], [], [], []
    for f, end in joining.steps:
        part, other = spots.parts[f.part], spots.parts[f.spot.part]
        own = bodies[body[part]]
        if f.around:
            ring = spots.stitches(_round_of(spots, f))
            there = bodies[body[other]]
            layer = len(own) == len(there) and f.by == f.spot.round and len(end.nodes) == len(ring)
            x[own], pairs = (
                laid_on(x, own, end, ring, there) if layer else hung(x, own, end, ring, there, upright[other])
            )
            seams.append(pairs)
            held.append((int(own[0]), int(ring[0])))
            group[body[other]].extend(group[body[part]])
            for b in group[body[other]]:
                group[b] = group[body[other]]
            continue
        frame = frame_of(joining, x, f, end, upright, bodies[body[other]])
        how = sewing.held(x, own, end)
        if f.to is not None:
            target = bodies[body[other]]
            both = (frame, frames(spots, x, [f.to], upright))
            x[own], pairs, other_end = arched(x, own, how, end, both, target)
            seams.append(pairs)
            # Of a thread that went from end to end one would see the way between: the other end is held without it.
            stays.append(other_end)
            rest.append(np.full(len(other_end), SEWN_SHORT))
            held.append((int(own[0]), int(target[0])))
            group[body[other]].extend(group[body[part]])
            for b in group[body[other]]:
                group[b] = group[body[other]]
            continue
        if other in nodded and f.spot.stitch is None and BODY.search(f.part.lower()):
            f = gaze.leant(
                f, frame, turned(frame.normals[0], nodded[other].T)
            )  # a body hangs straight down from a head
        elif f.points is not None:
            f = gaze.pointing(f, frame)
        elif not built.pattern.exact:
            f = gaze.nodding(spots, x, own, how, f, end, frame)
        straight = sewing.brought(x, own, how, *sewing.ways(f, end, frame, False), frame.points[0])
        fixed = np.concatenate([bodies[b] for b in group[body[other]]])
        outward = vertex_normals(x, shell[np.isin(shell[:, 0], fixed)])
        at_end = np.isin(own, end.nodes)
        if not built.pattern.exact:
            f = sewing.swung_out(x, own, how, f, end, frame, at_end, x[fixed], outward[fixed])
        ways = sewing.ways(f, end, frame)
        moved = sewing.brought(x, own, how, *ways, frame.points[0])
        rank = np.searchsorted(own, end.nodes)
        low, lid = rim_on(built, spots, f, end), lid_on(built, spots, f, end)
        fabric = low if len(low) else lid if len(lid) else bodies[body[other]]
        seams.append(sewing.seam(x, graph, end, straight[rank], fabric, frame))
        host = np.isin(fixed, bodies[body[other]])
        if len(low):
            x[own] = moved = drawn_over(
                moved, at_end, x[low], x[bodies[body[other]]], frame.points[0], frame.normals[0]
            )
        elif len(lid):
            x[own] = moved
        else:
            x[own] = sewing.clear_of(moved, at_end, x[fixed], outward[fixed], host, frame.normals[0])
            cleared[own] = x[own[0]] - moved[0] + cleared[bodies[body[other]][0]]
        upright[part] = turned(upright[other], sewing.leaning(f, frame))
        if end.ring and not end.laid and not len(low) and len(end.nodes) >= sewing.WIDE:
            springs, lengths = sewing.rounded(x, seams[-1], straight[rank], bodies[body[other]], frame)
            stays.append(springs)
            rest.append(lengths)
        springs, lengths = sewing.stays(x, moved, own, end, *ways, bodies[body[other]], frame)
        stays.append(springs)
        rest.append(lengths)
        held.append((int(own[0]), int(fixed[0])))
        group[body[other]].extend(group[body[part]])
        for b in group[body[other]]:
            group[b] = group[body[other]]
    around = np.zeros((0, 3), int)
    if joining.ball:
        x, pairs, together, around = rolled(spots, x, list(joining.ball))
        seams.append(pairs)
        held += [(int(a), int(b)) for a, b in together]
    for k, turn in nodded.items():
        own = np.concatenate([bodies[b] for b in group[body[k]]])
        x[own], cleared[own] = turned(x[own], turn), turned(cleared[own], turn)
        mine = np.unique(graph.part[own])
        upright[mine] = turned(upright[mine], turn)
    return Joined(
        x,
        upright,
        tuple(seams),
        np.array(held, int).reshape(-1, 2),
        np.concatenate([np.zeros((0, 2), int), *stays]),
        np.concatenate([np.zeros(0), *rest]),
        np.concatenate([np.zeros((0, 4), int), *(sewing.lying(shell, pairs) for pairs in seams[: len(joining.steps)])]),
        around,
        cleared,
    )


def _nodded(joining: Joining, x: Array, body: list[int], onto: set[int]) -> dict[int, Array]:
    """Part → how a head is turned that stands by itself, its body hanging on it, so that its eyes look ahead."""
    spots, found = joining.spots, dict[int, Array]()
    for f, _ in joining.steps:
        k = spots.parts[f.spot.part]
        hangs = f.spot.stitch is None and body[k] not in onto and BODY.search(f.part.lower())
        if hangs and k not in found and (turn := gaze.nod(spots, x, k)) is not None:
            found[k] = turn
    return found


def _round_of(spots: Spots, placed: Placed) -> int:
    """The round that ``placed`` hangs from."""
    k = spots.round_at(spots.parts[placed.spot.part], int(placed.spot.round))
    assert k is not None, "prepare has told of it"
    return k


def frame_of(joining: Joining, x: Array, placed: Placed, end: sewing.End, upright: Array, target: Array) -> Frames:
    """The frame at the spot of ``placed``, level with as much of the fabric (its nodes are ``target``) as its end covers."""
    built = joining.built
    if len(lid := lid_on(built, joining.spots, placed, end)):
        return across(joining.spots, x, lid, joining.spots.parts[placed.spot.part], upright)
    frame = frames(joining.spots, x, [placed.spot], upright)
    if joining.spots.place(placed.spot).opening:
        return frame
    if (closed := _on_shut(joining, x, placed, upright)) is not None:
        return closed
    away = frame.points[0] - x[target].mean(0)
    if placed.spot.stitch is None and float(dot(away, frame.normals[0])) < 0.0:
        frame = frame._replace(normals=(away / length(away))[None])  # two last stitches, pulled in, may look anywhere
    m = len(end.nodes)
    room = max(1.5, m / (2.0 * math.pi) if end.ring else 0.25 * m)
    near = target[((x[target] - frame.points[0]) ** 2).sum(1) < room * room]
    faces = built.graph.faces[built.shell]
    outward = vertex_normals(x, faces[np.isin(faces, near).any(1)])[near]
    # What lies on the other side of a thin part looks the other way.
    mean = outward[dot(outward, frame.normals[0]) > 0.0].sum(0)
    if placed.spot.stitch is None and dot(away, mean) > UPRIGHT * length(away) * length(mean):
        mean = away  # where a spiral ends its fabric leans a little; what stands on it stands on the axis of the whole
    size = float(length(mean))
    normals = frame.normals if size < 1e-9 else (mean / size)[None]
    return Frames(frame.points, normals, *level(normals, upright[[joining.spots.parts[placed.spot.part]]]))


def _on_shut(joining: Joining, x: Array, placed: Placed, upright: Array) -> Frames | None:
    """The frame at a spot on an end that is sewn shut: between its two layers, looking out of it; None for every other spot."""
    spots, part = joining.spots, joining.spots.parts[placed.spot.part]
    graph, nodes, pairs = joining.built.graph, np.array(spots.place(placed.spot).nodes), joining.pinched
    for rim, inwards in ((spots.rim(part), -1), (spots.begun(part), 1)):
        if not len(rim) or np.isin(rim, pairs).mean() < 0.7:
            continue
        # A foundation chain is an edge: what is sewn to the round on it is sewn to that.
        near = np.abs(graph.round[nodes].astype(int) - int(graph.round[rim[0]])) <= (1 if inwards > 0 else 0)
        if not near.all() or not (inwards > 0 or np.isin(nodes, rim).all()):
            continue
        here = x[nodes].mean(0)
        between = 0.5 * (x[pairs[:, 0]] + x[pairs[:, 1]])[np.isin(pairs[:, 0], rim)]
        point = between[nearest(here[None], between)[1][0, 0]]
        before = np.flatnonzero((graph.part == part) & (graph.round == graph.round[rim[0]] + inwards * _DEEP))
        out = x[rim].mean(0) - (x[before] if len(before) else x[graph.part == part]).mean(0)
        normal = (out / max(float(length(out)), 1e-9))[None]
        return Frames(point[None], normal, *level(normal, upright[[part]]))
    return None


def assembly(joining: Joining, joined: Joined, x: Array) -> list[dict[str, Any]]:
    """What the report says of every seam: the stitches sewn, and the gap that is left between them; x : (N, 3) mm."""
    told = []
    for (placed, _), pairs in zip(joining.steps, joined.seams):
        gap = np.sqrt(((x[pairs[:, 0]] - x[pairs[:, 1]]) ** 2).sum(1))
        told.append(
            {
                "part": placed.part,
                "on": placed.spot.part,
                "round": placed.spot.round,
                "stitches": len(pairs),
                "gap_mm": round(float(gap.mean()), 2),
                "widest_mm": round(float(gap.max()), 2),
                "tilt": placed.tilt,
                "towards": placed.towards,
                "across": placed.across,
            }
        )
    return told

"""Sewing: a settled part brought to its place on another, and the stitches of its end paired with those of the fabric."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, replace

import numpy as np

from tambour.core.check import Array
from tambour.core.graph import ROOT, TIP, StitchGraph
from tambour.crochet.finish.brims import HATS
from tambour.crochet.finish.placing import Frames
from tambour.crochet.graph.built import Built
from tambour.crochet.graph.spots import Spots, whole
from tambour.crochet.language.finishes import Placed
from tambour.crochet.settle.body import SEAM_HEIGHT
from tambour.geometry.motion import dot, length, turned
from tambour.geometry.near import assigned, nearest

CLEARANCE = 0.8
"""Stitches that a part keeps at first from the fabric that it is sewn to; the end that is sewn half of that."""
UNDER = -0.6
"""Fabric whose outward normal falls more steeply than this (37 degrees) is underneath: parts on it look ahead, not down."""
MOST_LIFT = 5.0
"""Stitches that a part is moved out at the most to be clear of others: a hand would push them aside, not sew it on in the air."""
SWING, NEARLY = 15.0, 3.5
"""By so many degrees a part leans less at a time until it is clear, or nearly, by so many stitches, of what it would be inside of."""
AGAIN = 0.5
"""What it costs, in square stitches, to sew into a stitch that is sewn into already."""
OFF = 0.75
"""How far from the middle between its neighbours' a stitch lies off their row, in stitches."""
WIDE, BETWEEN = 15, 4
"""An edge of so many stitches or more is sewn down in a round; and how many stitches each of its own is held between there."""
AROUND = 1.6
"""A last row of so many times the stitches of every other runs round the piece."""
CLOSES = 0.7
"""A round closes an end that has no more than so many stitches for each of the one that it is worked through."""
OVER = 1.5
"""An edge is sewn down in a round where all of it lies on fabric, no farther than this from a stitch."""
STAY, OUTSIDE = 2.5, 1.0
"""How far from a seam's middle stays begin on the fabric, in stitches; and how far outside a ring's: under a part it is slack."""
BEND = 1.0
"""Radians that a flat piece reaches around what it is sewn to, at the most, from its middle."""
DISC, GROWS = 12, 5.0
"""A flat circle has so many stitches or more round its edge, and so many for every round."""
FAN = 3
"""A fan begins with so few stitches, and its last row has so many for every row, or more."""
CROWN = re.compile(r"\b(?:crowns?|krone|corona|couronne|kroon)\b")
"""What stands on a head on its lower edge, as a hat does."""
STRIP = 3
"""A piece in rows is a strip where its last row has so many stitches to a row, or more."""
ALONG = 0.9
"""An end whose line runs so nearly along its part, as a cosine, says nothing of how it is held."""
ROUND = 0.3
"""An end that encloses less than this share of a circle of as many stitches is no ring."""
REACH = 5.0
"""How far up a part they hold it at the most."""


@dataclass(frozen=True, eq=False, slots=True)
class End:
    """The stitches by which a part is sewn.

    nodes : (M,) in the order of work; ring : they run round; pinched : pairs (K, 2) of them that are drawn together
    laid : it is the edge of a flat piece that lies on the fabric; disc : of one that is a circle; leaf : of one worked along both
    sides of a chain, held by the chain and not by where its stitches happen to begin
    """

    nodes: Array
    ring: bool
    pinched: Array
    laid: bool = False
    disc: bool = False
    leaf: bool = False


def end_of(built: Built, spots: Spots, placed: Placed) -> End:
    """The end by which ``placed`` is sewn: its rim where it is open, else its last round; or the round that it says.

    Of a piece in rows: its edge all round where it is laid flat, the short end of a strip, the wider of its ends.
    """
    graph, part = built.graph, spots.parts[placed.part]
    rows = bool(spots.in_rows[part])
    none = np.zeros((0, 2), int)
    number = spots.round_at(part, round(placed.by)) if placed.by is not None else None
    if number is not None:  # a round that is not there is told where names are checked
        nodes = spots.stitches(number)
    elif rows:
        if placed.flat and len(loop := spots.edge(part)) > 3:
            return End(loop, True, none, True)
        if (HATS.search(placed.part.lower()) or CROWN.search(placed.part.lower())) and len(
            brim := _brim_of_rows(built, spots, part)
        ) > 3:
            return End(brim, True, none)
        nodes = _end_of_rows(built, spots, part)
    else:
        nodes = spots.sewn_rim(part)
        if len(closed := _closing(spots, part)):
            nodes = closed  # what is left open beside the closing stitches is no rim
        if placed.flat and not _oval(built, part) and is_disc(built, part, 2) and len(nodes) >= DISC:
            # A full circle is sewn by a piece of its edge: the part of it that is worked last.
            nodes = nodes[~np.isin(graph.peculiarity[nodes], (ROOT, TIP))]
            return End(nodes[-max(4, len(nodes) // 5) :], False, none)
        if placed.flat and graph.parts[part].stuffing == 0.0 and _oval(built, part):
            # A leaf worked along both sides of a chain is sewn by the end where its round begins and ends.
            nodes = nodes[~np.isin(graph.peculiarity[nodes], (ROOT, TIP))]
            some = max(2, len(nodes) // 7)
            return End(np.concatenate([nodes[-some:], nodes[:some]]), False, none, leaf=True)
        if not len(nodes):
            nodes = spots.stitches(spots.last(part))
    nodes = nodes[~np.isin(graph.peculiarity[nodes], (ROOT, TIP))]
    if len(nodes) < 2:
        first, last = whole(graph, part)
        nodes = np.arange(max(first, last - 3), last)
    m = len(nodes)
    if shut(spots, nodes):
        return End(nodes, False, none)
    if (
        not placed.flat
        and not rows
        and (graph.parts[part].stuffing == 0.0 or _one_round(built, part))
        and is_disc(built, part, 1)
    ):
        return End(nodes, True, none, laid=True, disc=True)
    pinch = placed.flat and not rows
    nodes = _along_lobes(spots, part, nodes) if pinch else nodes
    pairs = np.column_stack([nodes[: m // 2], nodes[::-1][: m // 2]]) if pinch else none
    return End(nodes, not rows and not placed.flat, pairs)


def _along_lobes(spots: Spots, part: int, nodes: Array) -> Array:
    """An end (M,) that is pinched, begun so that it is pinched along the two lobes that it goes on from: the flukes of a tail."""
    begins = [k for k, r in enumerate(spots.built.rounds) if r.part == part and r.number == 1 and r.count]
    if len(begins) != 2 or len(nodes) < 4:
        return nodes
    one, other = (spots.layout[spots.stitches(k)].mean(0) for k in begins)
    half = len(nodes) // 2
    lines = [
        loop[half - 1] + loop[half] - loop[0] - loop[-1]
        for k in range(len(nodes))
        for loop in (spots.layout[np.roll(nodes, -k)],)
    ]
    return np.roll(nodes, -int(np.abs(np.array(lines) @ (other - one)).argmax()))


def _closing(spots: Spots, part: int) -> Array:
    """The last round of a part that closes its end through both layers: half as many stitches as the round has that it closes. Of
    two layers that are worked together all round no end is closed."""
    mine = [k for k, r in enumerate(spots.built.rounds) if r.part == part and r.count]
    last, before = (spots.stitches(k) for k in mine[:-3:-1]) if len(mine) > 1 else (np.zeros(0, int), np.zeros(0, int))
    return last if shut(spots, last) and len(last) <= CLOSES * len(before) else np.zeros(0, int)


def shut(spots: Spots, nodes: Array) -> bool:
    """Whether an end was closed by stitches through both its layers: a line, and no ring."""
    return len(nodes) > 1 and bool(spots.folded[nodes].mean() > 0.5)


def is_disc(built: Built, part: int, least: int = 4) -> bool:
    """Whether a part is a flat circle of ``least`` rounds or more: about six stitches more in every round."""
    counts = [r.count for r in built.rounds if r.part == part and not r.aside]
    return len(counts) >= least and counts[-1] == max(counts) and counts[-1] >= GROWS * len(counts)


def _one_round(built: Built, part: int) -> bool:
    """Whether a part is a single round: there is nothing to be stuffed, whatever is said of stuffing."""
    return sum(r.part == part and r.count > 0 for r in built.rounds) == 1


def _oval(built: Built, part: int) -> bool:
    """Whether a part is a leaf: a few rounds along both sides of a chain that is much longer than they are high."""
    found = [(r.number, r.count) for r in built.rounds if r.part == part and not r.aside]
    (number, chain), *rounds = found or [(1, 0)]
    return number == 0 and chain >= 3 and 1 <= len(rounds) <= max(1, chain // 3) and rounds[0][1] >= 2 * chain


def _end_of_rows(built: Built, spots: Spots, part: int) -> Array:
    """The stitches by which a piece in rows is sewn that stands out from the fabric."""
    mine = [spots.stitches(k) for k, r in enumerate(built.rounds) if r.part == part and not (r.aside and not r.count)]
    mine = [nodes for nodes in mine if len(nodes)]
    *rows, end = [len(nodes) for nodes in mine]
    if len(rows) > 1 and end >= AROUND * max(rows) and rows[-1] <= max(rows[:-1]):
        mine = mine[:-1]  # an edging all round is no end; a fan grows in all its rows
    first, last = mine[0], mine[-1]
    if len(mine) > 1 and len(first) <= FAN and len(last) >= FAN * len(mine):
        # A fan is sewn by its straight edge: where its rows begin and end.
        ends = np.unique(np.concatenate([row[[0, -1]] for row in mine]))
        way = spots.layout[last[-1]] - spots.layout[last[0]]
        return ends[np.argsort(dot(spots.layout[ends], _unit(way)), kind="stable")]
    if len(last) >= STRIP * len(mine):
        x = spots.layout
        own = np.concatenate(mine)
        way = x[last[-1]] - x[last[0]]
        reach = dot(x[own] - x[last[-1]], _unit(way))
        return np.sort(own[reach > -0.6])
    wide = mine[1] if len(mine) > 1 and len(mine[1]) >= len(first) else first
    return wide if len(last) <= 2 < len(wide) else last


def _brim_of_rows(built: Built, spots: Spots, part: int) -> Array:
    """The edge (M,) of a hat that was worked in rows and sewn to a tube: of one whose last row is sewn to its first where its rows begin,
    all round; of one whose rows are closed, a crown, its first row; none of what is no tube."""
    rows = [spots.stitches(k) for k, r in enumerate(built.rounds) if r.part == part and r.count]
    pairs = built.sewn.reshape(-1, 2)
    pairs = pairs[(built.graph.part[pairs] == part).all(1)]
    if len(rows) < 2 or not len(pairs):
        return np.zeros(0, int)
    ends = np.isin(pairs, rows[0]).any(1) & np.isin(pairs, rows[-1]).any(1)
    if ends.mean() > 0.5:
        edge = [int(rows[0][0])]
        for row in rows[1:]:  # rows are turned: the edge goes on where the next one begins, or ends
            tips = row[[0, -1]]
            edge.append(int(tips[np.argmin(length(spots.layout[tips] - spots.layout[edge[-1]]))]))
        return np.array(edge)
    of = built.graph.round[pairs]
    return rows[0] if (of[:, 0] == of[:, 1]).mean() > 0.5 else np.zeros(0, int)


@dataclass(frozen=True, eq=False, slots=True)
class Held:
    """How a part is held before it is placed: the middle of its end, its axis out of it, and its front across that."""

    middle: Array
    axis: Array
    front: Array


def held(x: Array, own: Array, end: End) -> Held:
    """How the part ``own`` (its nodes) is held by ``end``. x : (N, 3), the part as it stands by itself, front +z."""
    loop = x[end.nodes]
    middle = loop.mean(0)
    rest = own[own < end.nodes.min()]
    away = x[rest if len(rest) > 2 else own].mean(0) - middle
    if not end.ring:
        m = len(end.nodes)
        if len(end.pinched):
            line = 0.5 * (loop[m // 2 - 1] + loop[m // 2]) - 0.5 * (loop[0] + loop[-1])
        else:
            line = loop[-1] - loop[0]
        front = _unit(line)
        if end.leaf and length(across := line - dot(line, _unit(away)) * _unit(away)) > 1e-6:
            return Held(middle, _unit(away), _unit(across))
        if abs(dot(front, away)) > ALONG * length(
            away
        ):  # the edge of a slit, along the part: held by its end all the same
            side = np.cross(away, [0.0, 0.0, 1.0] if abs(away[2]) < 0.9 * length(away) else [1.0, 0.0, 0.0])
            return Held(middle, _unit(away), _unit(side))
        return Held(middle, _unit(away - dot(away, front) * front), front)
    off = loop - middle
    axis = np.cross(off, np.roll(off, -1, 0)).sum(0)
    axis = axis if dot(axis, away) >= 0 else -axis
    # What lies flat has no plane of its own.
    plain = length(axis) > ROUND * len(loop) ** 2 / (2.0 * math.pi)
    axis = _unit(axis) if plain else _unit(away)
    ahead = np.array([0.0, 0.0, 1.0]) if abs(axis[2]) < 0.95 else np.array([0.0, -1.0, 0.0])
    return Held(middle, axis, _unit(ahead - dot(ahead, axis) * axis))


def ways(placed: Placed, end: End, frame: Frames, tilted: bool = True) -> tuple[Array, Array]:
    """Where the axis and the front of ``placed`` point on a spot with ``frame`` (K = 1): two unit vectors (3,)."""
    n, along, up = frame.normals[0], frame.along[0], frame.up[0]
    a = math.radians(placed.across)
    if end.ring:
        ahead = ahead_on(n, up)
        front = math.cos(a) * ahead + math.sin(a) * np.cross(n, ahead)
    else:
        front = math.cos(a) * along + math.sin(a) * up
    if not tilted:
        return n, front
    turn = leaning(placed, frame)
    return turned(n, turn), turned(front, turn)


def ahead_on(n: Array, up: Array) -> Array:
    """Where the front of a ring looks that stands on fabric with the normal n (3,) and ``up`` (3,) on it: down (on top: ahead); under the
    toy, where fabric leans a little either way, ahead."""
    return np.asarray(math.copysign(1.0, float(up[2])) * up if n[1] < UNDER else -up)


def leaning(placed: Placed, frame: Frames) -> Array:
    """The rotation (3, 3) by which ``placed`` leans from straight out."""
    n, along, up = frame.normals[0], frame.along[0], frame.up[0]
    w, t = math.radians(placed.towards), math.radians(placed.tilt)
    to = math.cos(w) * up - math.sin(w) * along
    k = np.cross(n, to)
    cross = np.array([[0.0, -k[2], k[1]], [k[2], 0.0, -k[0]], [-k[1], k[0], 0.0]])
    made = np.eye(3) + math.sin(t) * cross + (1.0 - math.cos(t)) * turned(cross, cross.T)
    return np.asarray(made)


def brought(x: Array, own: Array, how: Held, axis: Array, front: Array, point: Array) -> Array:
    """The part's nodes with the middle of its end at ``point`` and its axis and front turned as told."""
    before = np.column_stack([how.axis, how.front, np.cross(how.axis, how.front)])
    after = np.column_stack([axis, front, np.cross(axis, front)])
    return np.asarray(turned(x[own] - how.middle, turned(after, before)) + point)


def clear_of(moved: Array, sewn: Array, others: Array, outward: Array, host: Array, n: Array) -> Array:
    """``moved`` (K, 3), shifted along n until it is outside of the fabric ``others`` (J, 3) with normals ``outward``.

    sewn : (K,) bool, the stitches of its end, which come nearer; host : (J,) bool, the fabric that it is sewn to: where
        it would be too far away to be clear of all, it is clear of that, or, in a hollow, where it was put
    """
    for of in (np.ones(len(others), bool), host):
        lift = _lift(moved, sewn, others[of], outward[of], n)
        if lift < MOST_LIFT:
            return np.asarray(moved + lift * n)
    return moved


def swung_out(
    x: Array, own: Array, how: Held, placed: Placed, end: End, frame: Frames, sewn: Array, others: Array, outward: Array
) -> Placed:
    """``placed`` leaning no more than lets its part be outside of the fabric ``others`` (J, 3): an arm sewn to a narrow neck
    leans out over the belly below, and does not hang down inside of it. Where no angle does that, the one that is nearest."""
    best, least = placed, math.inf
    for back in np.arange(0.0, placed.tilt + 1.0, SWING):
        tried = replace(placed, tilt=placed.tilt - float(back))
        moved = brought(x, own, how, *ways(tried, end, frame), frame.points[0])
        lift = _lift(moved, sewn, others, outward, frame.normals[0])
        if lift < NEARLY:
            return tried
        if lift < least - NEARLY:
            best, least = tried, lift
    return best


def _lift(moved: Array, sewn: Array, others: Array, outward: Array, n: Array) -> float:
    """How far along n ``moved`` is clear of ``others``; MOST_LIFT or more where it is not before."""
    want = np.where(sewn, 0.5 * CLEARANCE, CLEARANCE)
    lift = 0.0
    while lift < MOST_LIFT:
        at = moved + lift * n
        near = nearest(at, others)[1][:, 0]
        short = float((want - ((at - others[near]) * outward[near]).sum(1)).max())
        if short <= 0.0:
            break
        lift += max(0.1, min(short, 1.0))
    return lift


def line(placed: Placed, end: End, frame: Frames) -> Array:
    """Where a seam runs about its spot, in its tangent plane: points (K, 3) no farther apart than half a stitch."""
    m = len(end.nodes)
    p, along, up = frame.points[0], frame.along[0], frame.up[0]
    if end.ring:
        angle = np.linspace(0.0, 2.0 * math.pi, 2 * m, endpoint=False)[:, None]
        return np.asarray(p + m / (2.0 * math.pi) * (np.cos(angle) * along + np.sin(angle) * up))
    a, long = math.radians(placed.across), m - len(end.pinched)
    t = (np.arange(2 * long - 1) * 0.5 - 0.5 * (long - 1))[:, None]
    return np.asarray(p + t * (math.cos(a) * along + math.sin(a) * up))


def outline(layout: Array, own: Array, placed: Placed, end: End, frame: Frames) -> Array:
    """The same (K, 3); of a piece in rows that is laid flat its own edge; ``layout`` (N, 3) has parts by themselves, ``own`` its nodes."""
    if not end.laid or end.disc:
        return line(placed, end, frame)
    return brought(layout, end.nodes, held(layout, own, end), *ways(placed, end, frame, False), frame.points[0])


def seam(x: Array, graph: StitchGraph, end: End, straight: Array, target: Array, frame: Frames) -> Array:
    """Pairs (S, 2): every stitch of ``end`` with the stitch among ``target`` (nodes) that it is sewn to.

    straight : (M, 3) the end's stitches where they are when the part stands straight out from its spot
    """
    p, n = frame.points[0], frame.normals[0]
    m = len(end.nodes)
    target = target[~np.isin(graph.peculiarity[target], (ROOT, TIP))]
    off = straight - p
    off = off - dot(off, n)[:, None] * n
    if end.ring:
        length = np.sqrt((off**2).sum(1, keepdims=True))
        wanted = p + off / np.maximum(length, 1e-9) * (m / (2.0 * math.pi))
        if end.laid:
            off = off if not end.disc else wanted - p
            wanted = p + off * _over(off, x[target[_nearest(p + off, x[target])]] - p, n)
        near = _nearest(wanted, x[target])
        return np.column_stack([end.nodes, target[near if end.laid else _followed(near, wanted, x[target])]])
    half = len(end.pinched)
    line = off[m // 2] - off[0] if half else off[-1] - off[0]
    wanted = p + (np.arange(m - half) - 0.5 * (m - half - 1))[:, None] * _unit(line)
    near = target[_nearest(wanted, x[target])]
    # Both sides of a pinched end go to the same stitches.
    return np.column_stack([end.nodes, np.concatenate([near, near[:half][::-1]])])


def _over(off: Array, found: Array, n: Array) -> float:
    """How much larger than flat (``off``, (M, 3)) an edge is wanted, so that the piece lies on fabric that curves away.

    found : where the flat edge came to lie, from the spot; n : the fabric's normal there. Of a ball of radius R what is
    nearest to a point r off its tangent plane's foot is atan(r / R) around it; r / R is wanted.
    """
    flat, came = (float(np.sqrt((v**2).sum(1)).mean()) for v in (off, found - dot(found, n)[:, None] * n))
    bend = math.sqrt(max((flat / max(came, 1e-9)) ** 2 - 1.0, 0.0))
    return math.tan(min(bend, BEND)) / bend if bend > 0.05 else 1.0


def _followed(taken: Array, wanted: Array, there: Array) -> Array:
    """Stitches (M,) that a ring is sewn to, without single ones beside their neighbours' row: a hand follows the row."""
    width = float(np.median(np.sqrt(((there[taken] - there[np.roll(taken, 1)]) ** 2).sum(1))))
    made = taken.copy()
    for k in range(len(made)):
        before, after = there[made[k - 1]], there[made[(k + 1) % len(made)]]
        middle, far = 0.5 * (before + after), ((after - before) ** 2).sum() > (1.6 * width) ** 2
        if far or ((there[made[k]] - middle) ** 2).sum() < (OFF * width) ** 2:
            continue
        # Of the stitches about the middle the one nearest to where it was wanted.
        close = np.flatnonzero(((there - middle) ** 2).sum(1) < (OFF * width) ** 2)
        if len(close):
            made[k] = close[np.argmin(((there[close] - wanted[k]) ** 2).sum(1))]
    return made


def _nearest(wanted: Array, there: Array) -> Array:
    """For each of the points ``wanted`` (M, 3) one of ``there`` (J, 3), in all as near as can be; few are taken twice."""
    some = np.unique(nearest(wanted, there, min(8, len(there)))[1])
    cost = ((wanted[:, None] - there[some]) ** 2).sum(2)
    times = 2 if 2 * len(some) >= len(wanted) else math.ceil(len(wanted) / len(some))
    choices = np.concatenate([cost + AGAIN * k for k in range(times)], axis=1)
    return np.asarray(some[assigned(choices) % len(some)])


def lying(faces: Array, pairs: Array) -> Array:
    """Every stitch of a seam with the triangles about the stitch that it is sewn to: (L, 4).

    faces : (F, 3) of the fabric; pairs : (S, 2) as :func:`seam` gives them
    """
    about = faces[np.isin(faces, pairs[:, 1]).any(1)]
    near: dict[int, list[int]] = {}
    for a, b, c in about.tolist():
        for node in (a, b, c):
            near.setdefault(node, []).extend((a, b, c))
    at: dict[int, list[int]] = {}
    faces = faces[np.isin(faces, about).any(1)]
    for f, corners in enumerate(faces.tolist()):
        for node in corners:
            at.setdefault(node, []).append(f)
    made = []
    for stitch, on in pairs.tolist():
        own = sorted({f for node in near.get(on, [on]) for f in at.get(node, ())})
        made += [(stitch, *faces[f].tolist()) for f in own]
    return np.array(made, int).reshape(-1, 4)


def stays(
    x: Array, moved: Array, own: Array, end: End, axis: Array, front: Array, target: Array, frame: Frames
) -> tuple[Array, Array]:
    """Springs that keep a part at the angle that it is given, as a hand and a tight seam do: pairs (K, 2), rest (K,).

    From stitches about its middle to as many about the seam, of a ring eight, else four, each to four, as long as in the pose.
    moved : (O, 3) where the nodes ``own`` are in it; axis, front : how they are turned; target : nodes of the fabric
    """
    p, along, up = frame.points[0], frame.along[0], frame.up[0]
    turn = np.linspace(0.0, 2.0 * math.pi, 8 if end.ring else 4, endpoint=False)[:, None]
    out = max(STAY, len(end.nodes) / (2.0 * math.pi) + OUTSIDE) if end.ring else STAY
    ground = nearest(p + out * (np.cos(turn) * along + np.sin(turn) * up), x[target])[1]
    off = moved - p
    height = dot(off, axis)
    middle = min(0.6 * float(height.max()), REACH)
    side = np.cross(axis, front)
    ring = np.abs(height - middle) < 1.0
    wide = float(np.sqrt(((off - height[:, None] * axis) ** 2).sum(1))[ring].mean()) if ring.any() else 1.0
    held_by = nearest(p + middle * axis + wide * (np.cos(turn) * front + np.sin(turn) * side), moved)[1]
    # Every stitch that is held is held from four others: more than that and steps of a fixed length overshoot.
    k = np.arange(len(turn))
    one, two = np.nonzero((k[:, None] + k) % (len(k) // 4) == 0)
    a, b = np.unique(np.column_stack([held_by[one], ground[two]]), axis=0).T
    rest = np.sqrt(((moved[a] - x[target[b]]) ** 2).sum(1))
    return np.column_stack([own[a], target[b]]), rest


def rounded(x: Array, pairs: Array, straight: Array, target: Array, frame: Frames) -> tuple[Array, Array]:
    """Springs by which a ring's edge is sewn down in a round, and not from stitch to stitch of what is below, that lie in rows: pairs
    (K, 2) of its stitches with the BETWEEN nearest stitches to where each is wanted, and how far they are from there (K,).

    pairs, straight, target : as :func:`seam` gives and takes them
    """
    p, n = frame.points[0], frame.normals[0]
    off = straight - p
    off = off - dot(off, n)[:, None] * n
    wanted = p + off / np.maximum(np.sqrt((off**2).sum(1, keepdims=True)), 1e-9) * (len(pairs) / (2.0 * math.pi))
    wanted = wanted + (dot(x[pairs[:, 1]] - wanted, n) + SEAM_HEIGHT)[:, None] * n
    far, near = nearest(wanted, x[target], min(BETWEEN, len(target)))
    if float(far[:, 0].max()) > OVER:  # rim on rim, or wide on narrow: no fabric is under it
        return np.zeros((0, 2), int), np.zeros(0)
    return np.column_stack([np.repeat(pairs[:, 0], near.shape[1]), target[near.ravel()]]), far.ravel()


def _unit(v: Array) -> Array:
    return np.asarray(v / max(float(length(v)), 1e-12))

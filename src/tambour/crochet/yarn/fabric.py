"""The fabric: the piece's yarn in space, one unbroken strand per run of a colour, as a hook would have led it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tambour.core.check import Array
from tambour.core.graph import ROOT, StitchGraph
from tambour.core.mesh import Mesh
from tambour.core.paths import Paths
from tambour.core.strands import Strands
from tambour.core.threads import share
from tambour.crochet.yarn import points
from tambour.crochet.yarn.clearance import ALONG, clear
from tambour.crochet.yarn.course import Course, course, leaning, place
from tambour.crochet.yarn.edges import arched, domed, eased, gathered, level
from tambour.crochet.yarn.fibres import KINDS
from tambour.crochet.yarn.frayed import frayed
from tambour.crochet.yarn.lead import Way, roles, way
from tambour.crochet.yarn.loops import BLOOM, LEAN, RATIO
from tambour.crochet.yarn.points import BLOCK
from tambour.crochet.yarn.pressed import pressed
from tambour.crochet.yarn.spline import smooth, thin
from tambour.crochet.yarn.surface import lining
from tambour.crochet.yarn.upright import upright
from tambour.geometry.motion import length
from tambour.geometry.surface import vertex_normals
from tambour.geometry.tube import MEAN, sweep
from tambour.noise import stream

OUT = 0.55
"""What of a loop stitch lies further out than this, in widths, hangs."""
OPENED = 0.62
"""Radius of the ends that hang out of fur, as a share of the yarn's: cut, it opens."""
FRAYED = 0.92
"""What is left of that at its very end, where its fibres are of all lengths."""
TAUT = 0.86
"""Radius of what is sewn with, as a share of the yarn's: it is pulled tight, and lies on top, where one sees it."""
BOWED = 1.1
"""How much of its length what hangs falls where the fabric slopes away under it."""
LIMP, LIES = 0.55, 6.0
"""So far, in widths, what hangs comes out of the fabric before it hangs straight down; by how much further where that slopes away."""
LOOKS = 16
"""How often strands that are too near to each other are looked for."""

LONGEST = 5.0
"""Segments are shorter than this, in radii, where strands are pushed apart: one long one makes pairs dear to find."""

_DETAIL = {"low": (1, 0.66), "medium": (2, 0.3), "high": (3, 0.03)}
"""Detail → pieces that a segment is split into, and how far points may stray, in radii."""


def strands(
    graph: StitchGraph,
    positions: Array,
    *,
    yarn_radius: float | None = None,
    detail: str = "medium",
    bloom: float = BLOOM,
    hold: str = "over",
) -> Strands:
    """The yarn of a piece.

    positions : (N, 3) mm of the graph's nodes
    yarn_radius : mm; None takes a tenth of the stitch's width
    detail : low, medium, high: points along the yarn
    bloom : radius drawn, in yarn radii; hold : how the yarn lies on the hook, over or under

    Returns a strand per run of one colour within which every stitch follows the one before, in the order of work, then
    the yarn of the seams. ``source`` is the first stitch of a strand (-1 for seams), ``point_data["stitch"]`` (P,)
    the stitch that every point belongs to.
    """
    x = np.ascontiguousarray(positions, np.float64)
    x = x + graph.stitch_width * _uneven(len(x))
    radius = graph.stitch_width * RATIO / 2 if yarn_radius is None else yarn_radius
    led = way(graph, hold)
    role = roles(graph)
    x = eased(graph, x, role, *leaning(graph, LEAN[hold]))
    x = gathered(graph, domed(graph, arched(graph, level(graph, x, role), role)))
    rows = course(graph, x, LEAN[hold])
    at = upright(_varied(led), led, graph, rows, hold)
    coords, ends = np.zeros((len(led.cell), 3)), led.ends
    root, free = graph.peculiarity == ROOT, np.diff(graph.anchor_offsets) == 0
    share(
        len(coords),
        BLOCK,
        lambda a, b: place(
            led.cell[a:b],
            led.below[a:b],
            at[a:b],
            graph.height,
            graph.direction,
            2 * radius / RATIO,
            rows.x,
            rows.along,
            rows.normal,
            rows.up,
            rows.after,
            rows.before,
            rows.foot,
            rows.pace,
            rows.host,
            rows.slip,
            root,
            free,
            coords[a:b],
        ),
    )
    hung = hanging(graph, led)
    if hung.any():
        _fall(coords, hung, led.cell, rows)
    wide = _thick(led, graph)
    wide[np.repeat(led.first < 0, np.diff(ends))] *= TAUT
    fur = _named(graph, "fur")
    if fur:
        wide[hung & np.isin(graph.kind[led.cell], fur)] = OPENED
    for last in (led.ends[:-1], led.ends[1:] - 1):
        wide[last[wide[last] == OPENED]] *= FRAYED
    pieces, stray = _DETAIL[detail]
    coords, ends, of = _rounder(coords, ends, max(2, pieces))
    coords, ends, of = _thinner(coords, ends, of, min(stray, 0.3) * radius)
    coords, ends, again = points.dense(coords, ends, LONGEST * radius)
    of = points.between(of, again)
    # What is drawn is what has its room: nothing is rounded or left out after this, but in low detail.
    clear(coords, ends, 2 * radius, looks=LOOKS)
    if stray > 0.3:
        coords, ends, of = _thinner(coords, ends, of, stray * radius)
    stitch, wide = led.cell[of.astype(np.int64)], points.between(wide, of)
    return Strands(
        Paths(coords, ends),
        radius * bloom * wide,
        led.color,
        source=led.first,
        point_data={"stitch": stitch},
    )


def _thinner(coords: Array, ends: Array, of: Array, stray: float) -> tuple[Array, Array, Array]:
    """Polylines without the points that they do not need: none strays by more than ``stray``; and what each point is ``of``."""
    keep = np.zeros(len(coords), np.bool_)
    thin(coords, ends, stray, keep)
    left = np.concatenate([[0], np.cumsum(keep)])[ends]
    fewer, of_fewer = np.empty((int(left[-1]), 3)), np.empty(int(left[-1]))
    points.taken(coords, of, keep, fewer, of_fewer)
    return fewer, left, of_fewer


def _uneven(n: int) -> Array:
    """How far (n, 3), in widths, every stitch lies out of line: by its number, so that more stitches leave the first as they are."""
    knots = stream("tension").uniform(-1.0, 1.0, (n // HELD + 2, 3))
    at = np.arange(n) / HELD
    held = np.stack([np.interp(at, np.arange(len(knots)), knots[:, k]) for k in range(3)], axis=1)
    return np.asarray(UNEVEN * stream("uneven").uniform(-1.0, 1.0, (n, 3)) + DRIFT * held)


def _varied(led: Way) -> Array:
    """The way's points (P, 3) in their cells as hands leave them: loops that lean a little, and are drawn tight and loose."""
    cells = int(led.cell.max(initial=-1)) + 1
    hands, out = stream("loops").uniform(-1.0, 1.0, (cells, 3)) * (LEANING, LOOSE, HIGH), np.empty_like(led.at)
    share(len(out), BLOCK, lambda a, b: points.varied(led.cell[a:b], led.at[a:b], hands, out[a:b]))
    return out


def _thick(led: Way, graph: StitchGraph) -> Array:
    """How thick (P,) the yarn is along its way."""
    over, out = np.zeros(len(graph), np.bool_), np.empty(len(led.cell))
    over[graph.anchors[np.repeat(graph.loop == 0, np.diff(graph.anchor_offsets))]] = True
    root = graph.peculiarity == ROOT
    stuffed = np.array([part.stuffing > 0.0 for part in graph.parts])
    behind = np.where(stuffed[graph.part], points.SPREAD, points.BEHIND)
    share(
        len(out),
        BLOCK,
        lambda a, b: points.thick(
            led.cell[a:b], led.below[a:b], led.at[a:b], graph.height, over, root, behind, out[a:b]
        ),
    )
    return out


def _rounder(coords: Array, ends: Array, pieces: int) -> tuple[Array, Array, Array]:
    """Polylines with every segment in ``pieces``, along smooth curves through their points; and which point each is, with its share of the next."""
    lengths = np.where(np.diff(ends) > 0, (np.diff(ends) - 1) * pieces + 1, 0)
    later = np.concatenate([[0], np.cumsum(lengths)])
    fine = np.zeros((int(later[-1]), 3))
    smooth(coords, ends, pieces, fine)
    return fine, later, points.counted(lengths, ends, pieces)


def eased_out(coords: Array, ends: Array, times: int) -> Array:
    """Polylines without their kinks, as long as before: every bend is shared with its neighbours, ``times`` over, and what that draws
    in is given back (Taubin 1995)."""
    held = np.zeros(len(coords), np.bool_)
    some = np.diff(ends) > 0
    held[ends[:-1][some]] = held[ends[1:][some] - 1] = True
    for share_of in (0.5, -0.52) * times:
        bend = np.zeros_like(coords)
        bend[1:-1] = 0.5 * (coords[:-2] + coords[2:]) - coords[1:-1]
        bend[held] = 0.0
        coords = coords + share_of * bend
    return np.ascontiguousarray(coords)


def _named(graph: StitchGraph, kind: str) -> list[int]:
    return [k for k, name in enumerate(graph.kinds) if name == kind]


def hanging(graph: StitchGraph, led: Way) -> Array:
    """Which points (P,) of the yarn's way hang out of loop and fur stitches."""
    loops = _named(graph, "loopst") + _named(graph, "fur")
    if not loops:
        return np.zeros(len(led.cell), np.bool_)
    return np.isin(graph.kind[led.cell], loops) & (led.at[:, 2] > OUT)


def _fall(coords: Array, hung: Array, cell: Array, rows: Course) -> None:
    """Turn what hangs out of the fabric down: straight down, or down the fabric's slope where that is below it."""
    run = np.flatnonzero(hung)
    first = run[np.concatenate([[True], (np.diff(run) > 1) | (np.diff(cell[run]) != 0)])]
    foot = coords[first[np.searchsorted(first, run, side="right") - 1]]
    way, normal = -rows.up[cell[run]], rows.normal[cell[run]]
    way = way / np.maximum(length(way), 1e-9)[:, None]
    normal = normal / np.maximum(length(normal), 1e-9)[:, None]
    down = np.broadcast_to([0.0, -1.0, 0.0], way.shape)
    into = np.minimum((down * normal).sum(1), 0.0)[:, None]
    wanted = down - into * normal + 0.3 * way + 0.12 * normal
    wanted /= np.maximum(length(wanted), 1e-9)[:, None]
    # The least turn from the one to the other.
    axis, cosine = np.cross(way, wanted), (way * wanted).sum(1)[:, None]
    off = coords[run] - foot
    turned = off * cosine + np.cross(axis, off) + axis * (axis * off).sum(1)[:, None] / np.maximum(1.0 + cosine, 0.05)
    # Where the fabric slopes away under it, it bends over the further it hangs.
    far, slope = length(turned), np.clip(normal[:, 1], 0.0, 0.8)
    wide = length(rows.along[cell[run]]) + 1e-9
    turned[:, 1] -= BOWED * slope * far * np.minimum(far / (3.0 * wide), 1.0)
    # Yarn is limp: a little out of the fabric it has turned down, and hangs beside its neighbours. What lies on a slope leans on that all its way.
    level = normal * (1.0, 0.0, 1.0)
    level /= np.maximum(length(level), 1e-9)[:, None]
    out = np.maximum((turned * level).sum(1), 0.0)
    limp = wide * (LIMP + LIES * np.clip(normal[:, 1] - 0.15, 0.0, 0.6))
    fallen = turned - (out - limp * out / (limp + out))[:, None] * level
    square = (turned * turned).sum(1) - fallen[:, 0] ** 2 - fallen[:, 2] ** 2
    fallen[:, 1] = np.where(turned[:, 1] < 0.0, -np.sqrt(np.maximum(square, 0.0)), turned[:, 1])
    coords[run] = foot + turned + np.clip(2.0 * far / wide - 0.4, 0.0, 1.0)[:, None] * (fallen - turned)


def _spun(made: Strands, full: float) -> Strands:
    """Yarn as thick and thin as spinning leaves it, ``full`` times as thick."""
    n = len(made.radius)
    rough = stream("spun").uniform(-1.0, 1.0, n // SLUB + 2)
    return replace(
        made, radius=full * made.radius * (1.0 + THIN * np.interp(np.arange(n) / SLUB, np.arange(len(rough)), rough))
    )


def _outward(made: Strands, graph: StitchGraph, positions: Array) -> Array:
    """Where (P, 3) the outside of the fabric is from every point of its yarn; the same for neighbours, as nearly as the fabric bends.

    Asked of the stitches it lies at, not of the one it belongs to: columns lean, and after many rounds a stitch shows several further on.
    """
    from scipy.ndimage import uniform_filter1d
    from scipy.spatial import cKDTree

    normals, out = vertex_normals(positions, graph.faces), np.empty_like(made.paths.coords)
    part, of = graph.part[made.point_data["stitch"]], np.flatnonzero(np.isfinite(positions).all(1))
    for k in np.unique(part).tolist():
        own, points = of[graph.part[of] == k], np.flatnonzero(part == k)
        near = cKDTree(positions[own]).query(made.paths.coords[points], min(4, len(own)))[1].reshape(len(points), -1)
        out[points] = normals[own[near]].sum(1)
    smoothed = uniform_filter1d(out, 25, axis=0, mode="nearest")
    return np.ascontiguousarray(smoothed / np.maximum(length(smoothed), 1e-9)[:, None])


SIDES = {"low": 4, "medium": 6, "high": 10, "near": 10, "photo": 10}
"""Detail → corners of the yarn's cross-section; near: for pictures that show few stitches, photo: for those of a camera."""
NEAR = 1200
"""Pictures of fewer stitches show their yarn near to: as round as in high detail."""
SLUB, THIN = 9, 0.07
"""Yarn grows thicker and thinner every so many points, by so much of its radius."""
GROOVE = 0.12
"""How deep the plies of such yarn lie apart in its outline, in radii drawn."""
WANDER = 0.06
"""Yarn is twisted more and less along its way, by so many turns."""
SWOLLEN = 1.15
"""Spun yarn that gives way to its neighbours is drawn so much thicker: legs of Vs touch, and leave no web of heads to be seen between them."""
PLIED = 400
"""Pictures of fewer stitches show its plies in the yarn's outline."""
KINKS = 6
"""How often the bends of such yarn are shared with their neighbours: strands that were pushed apart have kinks."""
RINGED = 0.4
"""How far apart, in radii drawn, the rings of such an outline lie."""
LAY = 4.6
"""Radii along which plies wind once about the yarn, as worsted of four plies is twisted. At 13 a leg of a V showed one shallow groove, and nobody
saw plies; at 7.4 they lay along the leg that leans against the twist, which was a smooth petal."""
LEANING, LOOSE, HIGH = 0.13, 0.11, 0.04
"""How far loops lean, how much fuller or flatter they are, and how much higher or lower, at the most."""
UNEVEN, DRIFT, HELD = 0.03, 0.07, 6
"""How far single stitches lie out of line, in widths, and how far several do, of about as many: hands are not machines."""


def mesh(
    graph: StitchGraph,
    positions: Array,
    *,
    detail: str = "medium",
    made: Strands | None = None,
    material: str = "wool",
) -> Mesh:
    """The piece as one sees it: its yarn, ``made`` by :func:`strands` or here, as tubes over a lining."""
    kind = KINDS[material]
    made = strands(graph, positions, detail=detail, bloom=BLOOM * kind.full) if made is None else made
    locks, full = None, SWOLLEN * (1.0 + THIN) if detail in ("near", "photo") and kind.plies else 1.0
    # Twist and rings are those of the yarn, not of where it is spread thickest.
    wide = 0.5 * graph.stitch_width * RATIO * BLOOM * kind.full * (1.0 + points.BEHIND) * full
    if detail in ("near", "photo"):
        if kind.plies:
            made, locks = frayed(made, graph)
        coords, ends, of = _rounder(made.paths.coords, np.asarray(made.paths.offsets), 2)
        coords = eased_out(coords, ends, 2)
        clear(coords, ends, graph.stitch_width * RATIO, looks=LOOKS)
        data = {name: values[of.astype(np.int64)] for name, values in made.point_data.items()}
        # Only here: elsewhere some of the strands may be asked for, and must be what they are among all.
        made = _spun(
            replace(made, paths=Paths(coords, ends), radius=points.between(made.radius, of), point_data=data),
            SWOLLEN if kind.plies else 1.0,
        )
    if detail in ("near", "photo") and len(graph) < PLIED and kind.plies:
        # As many rings as its plies ask for: with fewer their lobes are cut to facets where the yarn runs straight.
        coords, ends, of = points.dense(made.paths.coords, np.asarray(made.paths.offsets), RINGED * wide)
        # Long segments hide how near hairpins come to themselves: what is drawn is looked at once more, without its kinks.
        coords = eased_out(coords, ends, KINKS)
        clear(coords, ends, graph.stitch_width * RATIO, looks=LOOKS)
        data = {name: values[of.astype(np.int64)] for name, values in made.point_data.items()}
        made = replace(made, paths=Paths(coords, ends), radius=points.between(made.radius, of), point_data=data)
        plies, sides = kind.plies, 20
    else:
        plies, sides = 0, SIDES[detail]
    yarn = sweep(
        made,
        sides=sides,
        lay=LAY * wide / float(made.radius.max(initial=0.0) or 1.0),
        plies=plies,
        groove=GROOVE,
        wander=WANDER,
        material=kind.surface,
        outward=_outward(made, graph, positions) if plies else None,
    )
    if detail in ("near", "photo") and kind.plies:
        # Pile and halo lie in each other; spun yarn gives way.
        along = ALONG * graph.stitch_width * RATIO
        yarn = replace(
            yarn, vertices=pressed(made, yarn.vertices, sides, along, 1.0 + GROOVE * (1.0 - MEAN) if plies else 1.0)
        )
    inner = lining(graph, positions, graph.stitch_width)
    loose = [] if locks is None or not len(locks.radius) else [sweep(locks, sides=6, lay=LAY, material="plied")]
    every = (yarn, *loose, inner)
    first = np.cumsum([0, *(len(m.vertices) for m in every)])
    return Mesh(
        np.vstack([m.vertices for m in every]),
        np.vstack([m.faces + v for m, v in zip(every, first)]),
        color=np.vstack([np.asarray(m.color) for m in every]),
        uv=np.vstack([np.zeros((len(m.vertices), 2)) if m.uv is None else m.uv for m in every]),
        face_group=np.repeat(np.arange(len(every), dtype=np.int32), [len(m.faces) for m in every]),
        group_names=(kind.surface, *(["plied"] if loose else []), "lining"),
    )

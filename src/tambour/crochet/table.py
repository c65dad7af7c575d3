"""Table: how things lie that are sewn to nothing: clothes, cups, cookies beside each other, flat ones flat, open ones on their rims."""

from __future__ import annotations

import math
from typing import Final

import numpy as np

from tambour.core.check import Array
from tambour.core.graph import StitchGraph
from tambour.crochet.graph.built import Built
from tambour.crochet.graph.spots import Spots
from tambour.crochet.language.finishes import Placed, Tie, spots_of
from tambour.crochet.places.names import Made
from tambour.crochet.settle.arrange import clusters
from tambour.geometry.motion import axes, fit, least_squares, length, turned
from tambour.geometry.surface import vertex_normals

THIN: Final = 0.3
"""What is less thick than so much of its width, root of the mean of squares, is flat."""
PUFFED: Final = 0.85
"""The same of two pieces in rows that are sewn to each other round some stuffing: a fish, a star, a cookie."""
HEM: Final = 1.3
"""A garment's hem is so many times as wide as its waist, or more."""
LONG: Final = 1.5
"""A flat thing so much deeper than wide lies across."""
OPEN: Final = 12
"""An end of so many stitches or more is an opening, and not the place where a ball was closed."""
LIES: Final = frozenset(("fish", "starfish"))
"""What is made of two pieces in rows and lies on one of them."""
UP: Final = np.array([0.0, 1.0, 0.0])
SPACE: Final = 3.0
"""Stitches between toys that stand beside each other in a picture."""
SHAPE: Final = 1.5
"""A row of them is so much longer than the square has sides that they would all fill."""
DEEP: Final = 0.25
"""A thing is open on one side whose rim lies so far from its middle, as a share of its size."""


def laid_out(built: Built, x: Array) -> Array:
    """``x`` (N, 3) mm with every thing that nothing is sewn to laid as a hand would lay it, its floor at the common one.

    What is flat lies flat, its right side up, what was its top away from who looks; what is hollow and open on one side
    stands on its rim, but a vessel on its bottom. What has a face, or parts, stays as it stands. Of one piece alone
    nothing is changed.
    """
    graph = built.graph
    piece = clusters(graph)
    fish = any(LIES & set(Made(section.name, 1).words) for section in built.pattern.parts)
    if not len(x) or (piece.max() < 1 and not fish):
        return x
    spots, x = Spots(built), x.copy()
    bare = [spots_of(r)[0].part for r in built.pattern.finish if not isinstance(r, Tie)]
    bare += [r.part for r in built.pattern.finish if isinstance(r, Placed)]
    sewn = [spots.parts[name] for name in bare if name in spots.parts]
    # A fish of two pieces lies on its side, whether it has an eye or not: nothing is sewn to it that would stand.
    bears = {
        spots.parts[r.spot.part] for r in built.pattern.finish if isinstance(r, Placed) and r.spot.part in spots.parts
    }
    sewn = [k for k in sewn if k in bears or not (LIES & set(_named(built, k).words) and spots.in_rows[k])]
    kept = {int(piece[graph.parts[k].start]) for k in sewn if not _named(built, k).worn}
    floor = float(min(x[piece == k, 1].min() for k in (kept or {int(np.bincount(piece).argmax())})))
    for k in range(int(piece.max()) + 1):
        own = np.flatnonzero(piece == k)
        if k in kept or len(own) < 4:
            continue
        faces = graph.faces[np.isin(graph.faces, own).all(1)]
        middle = x[own].mean(0)
        off = x[own] - middle
        outward = vertex_normals(x, faces)[own].sum(0) if len(faces) else np.zeros(3)
        parts = [p for p in np.unique(graph.part[own]).tolist() if graph.parts[p].end > graph.parts[p].start]
        puffed = len(parts) == 2 and all(spots.in_rows[p] for p in parts)
        if (flat := _flat(off, outward, PUFFED if puffed else THIN)) is not None:
            off = flat if puffed else _unbowed(flat)
        elif (one := _hollow(built, spots, parts)) is not None and (
            way := _mouth(spots, x, one, _named(built, one).worn)
        ) is not None:
            vessel = _named(built, one).vessel
            rim = UP if vessel else -UP
            off = turned(off, fit(np.array([way, -way]), np.array([rim, -rim]), np.ones(2))[0])
        x[own] = off + middle
        x[own, 1] += floor - x[own, 1].min()
    return x


def _flat(off: Array, outward: Array, thin: float) -> Array | None:
    """A thing (K, 3) about its middle, turned to lie; None for what is not flat. outward : the sum of its normals."""
    size, ways = axes(off)
    if size[2] > thin * size[1]:
        return None
    right = outward if float(length(outward)) > 1e-6 else np.array([0.0, 0.1, 1.0])
    up = ways[2] if float(ways[2] @ right) >= 0.0 else -ways[2]
    top = np.array([0.0, 1.0, 0.0]) - up[1] * up
    top = top if float(length(top)) > 0.5 else up[2] * up - np.array([0.0, 0.0, 1.0])  # it lies already
    top = top / length(top)
    lying = np.column_stack([off @ np.cross(top, up), off @ up, -(off @ top)])
    wide, _, deep = np.ptp(lying, axis=0)
    return np.column_stack([lying[:, 2], lying[:, 1], -lying[:, 0]]) if deep > LONG * wide else lying


def _unbowed(x: Array) -> Array:
    """A lying thing (K, 3) without what it bows as a whole: on a table it lies flat."""
    a, b = x[:, 0], x[:, 2]
    bow = np.stack([np.ones(len(a)), a, b, a * a, a * b, b * b], axis=1)
    flat = x.copy()
    flat[:, 1] -= least_squares(bow, x[:, 1])
    return flat


def _named(built: Built, part: int) -> Made:
    return Made(built.pattern.parts[built.parts[part].section].name, 1)


def _hollow(built: Built, spots: Spots, parts: list[int]) -> int | None:
    """Which part of a thing says how it stands: its only one, or the widest skirt of a garment."""
    if len(parts) == 1:
        return parts[0]
    skirts = [p for p in parts if _named(built, p).worn and not spots.in_rows[p]]
    return max(skirts, key=lambda p: len(spots.rim(p)), default=None)


def _mouth(spots: Spots, x: Array, part: int, hem: bool) -> Array | None:
    """The way (3,) out of the one opening of a part worked in rounds, or out of the wider of two (``hem``); None for what is closed, or open
    at both ends."""
    if spots.in_rows[part]:
        return None
    rims = [rim for rim in (spots.rim(part), spots.begun(part)) if len(rim) >= OPEN]
    rims = sorted(rims, key=len)
    if len(rims) != 1 and not (hem and rims and len(rims[-1]) > HEM * len(rims[0])):
        return None
    rims = rims[-1:]
    span = spots.built.graph.parts[part]
    own = x[span.start : span.end]
    out = x[rims[0]].mean(0) - own.mean(0)
    size = float(np.sqrt(((own - own.mean(0)) ** 2).sum(1).mean()))
    return np.asarray(out / length(out)) if float(length(out)) > DEEP * size else None


def gathered(graph: StitchGraph, x: Array, wanted: Array, azimuth: float = 0.0) -> Array:
    """How far (N, 3), mm, to move every node so that the toys in sight stand together as for one photograph.

    Up to three stand in a row, more in several, the higher ones behind. wanted : (N,) which nodes are in sight; azimuth : of
    who looks, radians: the rows run from that one's left to the right
    """
    if azimuth:
        c, s = math.cos(azimuth), math.sin(azimuth)
        seen = np.array([[c, 0.0, -s], [0.0, 1.0, 0.0], [s, 0.0, c]])
        return turned(gathered(graph, turned(x, seen), wanted), seen.T)
    label, shift = clusters(graph), np.zeros_like(x)
    groups = [np.flatnonzero((label == k) & wanted) for k in range(int(label.max(initial=-1)) + 1)]
    groups = sorted((nodes for nodes in groups if len(nodes)), key=lambda nodes: -float(np.ptp(x[nodes, 1])))
    if len(groups) < 2:
        return shift
    gap, floor = SPACE * graph.stitch_width, float(min(x[nodes, 1].min() for nodes in groups))
    sizes = np.array([np.ptp(x[nodes], axis=0) for nodes in groups]) + gap
    # Small things, cookies or chips, stand in several rows: about as deep, all together, as a page is.
    long = max(float(sizes[:, 0].max()), SHAPE * float(np.sqrt((sizes[:, 0] * sizes[:, 2]).sum())))
    rows: list[list[int]] = [[]]
    for k in range(len(groups)):
        if rows[-1] and sizes[[*rows[-1], k], 0].sum() > long and len(groups) > 3:
            rows.append([])
        rows[-1].append(k)
    ahead = 0.0
    for row in rows:
        right, deep = -0.5 * float(sizes[row, 0].sum()), float(sizes[row, 2].max())
        for k in row:
            low, high = x[groups[k]].min(0), x[groups[k]].max(0)
            middle = 0.5 * (low[2] + high[2])
            shift[groups[k]] = (right - low[0], floor - low[1], ahead + 0.5 * deep - middle)
            right += sizes[k, 0]
        ahead += deep
    return shift

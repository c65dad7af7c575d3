"""Bumps: what stands out of a model and is too small to be worked, taken off; a pair that looks ahead is two safety eyes."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from tambour.core.check import Array
from tambour.core.rgb import RGB, hexed
from tambour.crochet.graph.build import build
from tambour.crochet.graph.spots import Spots
from tambour.crochet.model.assemble import Piece, spot_of
from tambour.crochet.model.cut import severed
from tambour.crochet.model.geodesic import distances, girth, lines
from tambour.crochet.model.rounds import pattern
from tambour.crochet.model.tips import Mirror
from tambour.crochet.model.whole import area, corners
from tambour.geometry.motion import dot, length
from tambour.geometry.near import nearest as closest
from tambour.geometry.surface import vertex_normals

SMALL = 8.0
"""A bump has less of the surface than so many stitches."""
PROUD = 0.35
"""How far it stands out of what lies about it, in stitches, at the least."""
ABOUT = 2.5
"""What lies so near, in stitches, is about it."""
STEP = 0.25
"""Lines about a tip are looked at so far apart, in stitches."""
NECK, SPREADS = 5.0, 0.9
"""Where a line about a tip grows by less than the one for every stitch on, and soon after by more than the least by the other, a bump
ends (on flat fabric it grows by 6.3 all along; along a limb ever less)."""
AHEAD, HIGH, ASIDE = 0.25, 0.5, 0.6
"""What looks ahead so far, as a cosine, lies so high, as a share of the whole, and no farther aside, as a share of half the width, is on
the face."""
STANDS = 0.2
"""How far its tip stands over all its rim, as a share of its width: along an edge it does not."""
EYES = (4, 5, 6, 7, 8, 9, 10, 12, 14, 15, 16, 18, 20, 24)
"""How wide safety eyes are sold, in mm."""
MOST = 12
"""The most bumps that are looked for."""
BLACK, BROWN = (24, 22, 22), (40, 30, 26)


@dataclass(frozen=True, eq=False, slots=True)
class Bump:
    """A bump: where it stands (3,), the way out of it (3,) and how wide it is, in stitches; its tip (3,), and the way from there
    to where it ends."""

    at: Array
    out: Array
    wide: float
    tip: Array
    rim: float


def taken_off(
    vertices: Array, faces: Array, plane: Mirror | None, tell: list[str]
) -> tuple[tuple[Bump, ...], Array, Array]:
    """The bumps of a face, a pair of eyes and a nose, on a closed surface (V, 3), (F, 3) in stitches, and the surface without
    them, closed where they stood. What else is as small is told: rounds go over it.

    plane : across which the surface is its own mirror image; without one there is no telling what is an eye
    """
    every = [one for point in _proud(vertices, faces) if (one := _cut(vertices, faces, point)) is not None][:MOST]
    face: list[Bump] = []
    if plane is not None:
        all_ = vertices[corners(faces)]
        low, high, half = all_[:, 1].min(), all_[:, 1].max(), float(np.abs(plane.off(all_)).max())
        ahead = [b for b in every if b.out[2] > AHEAD and b.at[1] > low + HIGH * (high - low)]
        ahead = [b for b in ahead if abs(float(plane.off(b.at))) < ASIDE * half]
        for pair in sorted(_pairs(ahead, plane), key=lambda pair: -float(pair[0].at[1]))[:1]:
            face += pair
        noses = [b for b in ahead if abs(float(plane.off(b.at))) < 1.0]
        face += [max(noses, key=lambda b: float(b.at[2]))] if noses and face else []  # alone it would look like an eye
    x, f = vertices, faces
    for one in face:
        tip = int(((x - one.tip) ** 2).sum(1).argmin())
        way = distances(x, f, np.array([tip]))
        if (made := severed(x, f, np.where(np.isfinite(way), way, 1e9), tip, one.rim)) is not None:
            _, x, f = made
    if more := len(every) - len(face):
        what, them = ("a bump or corner", "it is") if more == 1 else (f"{more} bumps or corners", "they are")
        tell.append(
            f"rounds go over {what} of the model, smaller than {SMALL:g} stitches: sew on beads or knots for what {them}"
        )
    return tuple(face), *_used(x, f)


def _cut(x: Array, faces: Array, point: Array) -> Bump | None:
    """The bump with its tip at ``point`` (3,), where there is one."""
    near = ((x - point) ** 2).sum(1) < (ABOUT + 2.5) ** 2
    here, own = _used(x, faces[near[faces].any(1)])
    tip = int(((here - point) ** 2).sum(1).argmin())
    way = distances(here, own, np.array([tip]))
    way = np.where(np.isfinite(way), way, 1e9)
    rim = _ends(here, own, way)
    loops = [] if rim is None else lines(here, own, way, rim)
    if rim is None or len(loops) != 1:
        return None
    size = float(area(here, own[way[own].mean(1) < rim]).sum())
    base = loops[0].mean(0)
    out = (point - base) / max(float(length(point - base)), 1e-9)
    wide = 2.0 * math.sqrt(size / (2.0 * math.pi))  # of half a ball
    if size > SMALL or float(dot(point - loops[0], out).min()) < STANDS * wide:
        return None
    return Bump(base, out, wide, point, rim)


def _used(x: Array, faces: Array) -> tuple[Array, Array]:
    """Only the vertices that faces use, and the faces of those."""
    used = corners(faces)
    return x[used], np.searchsorted(used, faces)


def _proud(x: Array, faces: Array) -> list[Array]:
    """The vertices (3,) that stand out of what lies about them, farthest first, none beside another."""
    used = corners(faces)
    normal = vertex_normals(x, faces)
    points = x[used]
    weight = np.zeros(len(x))
    np.add.at(weight, faces.ravel(), np.repeat(area(x, faces) / 3.0, 3))
    cells = np.floor(points / ABOUT).astype(np.int64)
    _, cell = np.unique(cells, axis=0, return_inverse=True)
    cell = cell.reshape(-1)
    many = np.bincount(cell, weight[used])
    middles = np.column_stack([np.bincount(cell, weight[used] * points[:, k]) for k in range(3)]) / many[:, None]
    near = closest(points, middles, min(7, len(middles)))[1]
    share = many[near] / many[near].sum(1, keepdims=True)
    mean = (share[..., None] * middles[near]).sum(1)
    high = dot(points - mean, normal[used])
    found: list[Array] = []
    for k in np.argsort(-high, kind="stable").tolist():
        if high[k] < PROUD or len(found) >= 4 * MOST:
            break
        if all(((points[k] - p) ** 2).sum() > ABOUT**2 for p in found):
            found.append(points[k])
    return found


def _ends(x: Array, faces: Array, way: Array) -> float | None:
    """The way from its tip at which a bump ends; None where it goes on, or is none."""
    sizes, ways = [0.0], [0.0]
    value = STEP
    while value < ABOUT + 1.5:
        found = lines(x, faces, way, value)
        sizes.append(max((girth(line) for line in found), default=0.0))
        ways.append(value)
        value += STEP
    size = np.convolve(np.pad(np.array(sizes), 1, mode="edge"), [0.25, 0.5, 0.25], "valid")
    slope = np.gradient(size, STEP)
    least, at = math.inf, 0
    for k in range(3, len(ways) - 1):
        if slope[k] < least:
            least, at = float(slope[k]), k
        if least < NECK and slope[k] > least + SPREADS:
            return float(ways[at + 1])
    return None


def uncoloured(vertices: Array, color: Array, bumps: tuple[Bump, ...]) -> Array:
    """Colours (V, 3) without those of the bumps: there that of what lies about them."""
    made = color.copy()
    for one in bumps:
        far = np.sqrt(((vertices - one.tip) ** 2).sum(1))
        own, about = far < one.rim + 0.3, np.flatnonzero((far > one.rim + 0.3) & (far < one.rim + 2.0))
        if len(about):
            made[own] = color[about[closest(vertices[own], vertices[about])[1][:, 0]]]
    return made


def faces_of(
    bumps: tuple[Bump, ...],
    pieces: list[Piece],
    stitch: tuple[float, float],
    fine: bool,
    color: tuple[Array, Array] | None,
    tell: list[str],
    what: tuple[str, str] = ("a bump too small to be worked", "two bumps too small to be worked"),
) -> list[str]:
    """The lines that make eyes and a nose of the bumps of a face, the two eyes first.

    pieces : with the places of their copies; stitch : mm; fine : places as near as can be; color : the model's vertices (V, 3) and their colours (V, 3), if it has any
    what : one of them, and two, as they are told
    """
    if not bumps:
        return []
    built = build(pattern([p.rounds for p in pieces]))
    spots = Spots(built)
    x = np.concatenate([lain for p in pieces for lain in p.lain])
    owner = np.concatenate([np.full(len(lain), k) for k, p in enumerate(pieces) for lain in p.lain])
    number = np.concatenate([np.full(len(lain), c) for p in pieces for c, lain in enumerate(p.lain)])

    def far(point: Array) -> Array:
        return np.asarray(np.sqrt(((x - point) ** 2).sum(1)))

    def spot(point: Array, on: int | None = None) -> tuple[str, float, float]:
        node = int(np.where((owner == on) | (on is None), far(point), np.inf).argmin())
        name = pieces[int(owner[node])].name(int(number[node]))
        there = spot_of(spots, x, spots.parts[name], name, point, fine=fine)
        return name, there.round, there.stitch or 1.0

    def shade(bump: Bump, other: RGB) -> str:
        if color is None:
            return hexed(other)
        vertex = int(((color[0] - bump.tip) ** 2).sum(1).argmin())
        red, green, blue = (int(v) for v in color[1][vertex][:3])
        return hexed((red, green, blue))

    made: list[str] = []
    if len(bumps) > 1:
        wide = 0.5 * (bumps[0].wide + bumps[1].wide) * stitch[0]
        size = min(EYES, key=lambda s: abs(s - wide))
        both = [
            far(one.at) for one in bumps[:2]
        ]  # a pair is on parts of one kind: not one of them on the head and one on a horn
        on = min(range(len(pieces)), key=lambda k: sum(float(off[owner == k].min()) for off in both))
        for one in bumps[:2]:
            name, r, s = spot(one.at, on)
            made.append(f"eye({name}, round={r:g}, stitch={s:g}, size={size}, color={shade(bumps[0], BLACK)})")
        tell.append(f"{what[1]} are safety eyes of {size} mm")
    for one in bumps[2:] if len(bumps) > 1 else bumps:
        ends = []
        for k in range(5):
            high = 0.3 - 0.15 * k
            reach = math.sqrt(0.25 - high**2) * one.wide
            for side in (-1.0, 1.0) if k % 2 else (1.0, -1.0):
                ends.append(spot(one.at + np.array([side * reach, high * one.wide, 0.0])))
        places = ", ".join(f"{r:g}:{s:g}" for part, r, s in ends if part == ends[0][0])
        made.append(f"embroider({ends[0][0]}, {places}, color={shade(one, BROWN)}, width=2)")
        tell.append(f"{what[0]} is an embroidered nose")
    return made


def _pairs(bumps: list[Bump], plane: Mirror) -> list[tuple[Bump, Bump]]:
    """Bumps that are each other's mirror image."""
    found = []
    for k, one in enumerate(bumps):
        for other in bumps[k + 1 :]:
            if abs(float(plane.off(one.at))) > 0.7 and float(length(plane.image(one.at) - other.at)) < 1.0:
                found.append((one, other) if plane.off(one.at) > 0 else (other, one))
    return found

"""Decide: what nobody asked for of a region: satin, tatami or a line, by how wide its limbs are; and the rows' angle."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from tambour.embroidery.columns.medial import branches, round_of, skeleton
from tambour.embroidery.lines.angle import STEP, angle, spans
from tambour.embroidery.piece import AUTO, MANY, Region
from tambour.embroidery.regions.flat import shape
from tambour.geometry.areas import of_shapely, to_shapely

SATIN = 7.0  # mm: limbs up to this width are satin
SPLIT = 12.1  # mm: up to this satin that is split, above it tatami
BODY = 0.15  # share of an area that may be wider and still be left to what satin leaves
DOT = 5.0  # mm: dots up to this width are satin, straight across: rows as short would be all ends
LONG = 3.0  # times as long as it is wide: a limb of a filled area that is sewn by itself
FLARE = 1.35  # times as wide as it is in the mean where a limb widens into the wide part
THIN = 0.25  # share of the wide part's width below which a limb hardly flares
HORN = 0.9  # of that width: what is thinner there belongs to the wide part too
EVEN = 0.72  # share of its length by its width that such a limb's area must have
COVERED = 0.01  # share of an area above which it counts as lying below another
LEAN = 0.7  # share of the width of the rest that it may have
SEAM = 0.1  # mm that the wide part goes beyond what discs of its width reach
LARGE = 0.25  # share of the largest one's box: areas of a colour whose neighbours its direction heeds
WORSE = 1.6  # times as many pieces of rows as in its best direction an area may need in that of its colour
UNDER = 0.6  # mm that it goes on below the limbs
BUNCH = 0.3  # share of an area that the widest disc in it must have to count as a middle; a T has 0.16, a star 0.4
ROWS = ("tatami", "gradient")


def decided(found: Sequence[Region]) -> tuple[Region, ...]:
    """Regions with a stitch and an angle each; an area whose parts differ becomes one region for each kind.

    What was asked for stays: a region's ``stitch`` where it is not AUTO, its ``angle`` where it is not None.
    """
    made: list[Region] = []
    for k, region in enumerate(found):
        made += _parts(region, found[k + 1 :]) if region.stitch == AUTO else [region]
    return _angled(_alike(made, {id(r) for r in found}))


def _alike(found: list[Region], asked: set[int]) -> list[Region]:
    """The regions, those that are satin only because they are plain and long as tatami where they lie beside other fills: a
    flag's bands are sewn one way."""
    fills = [r for r in found if r.role == "area" and r.stitch == "tatami"]
    wide = [r for r in found if r.role == "area" and r.stitch == "satin" and id(r) not in asked]
    wide = [r for r in wide if any(_wider(p, SATIN) > BODY for p in to_shapely(r.paths))]
    if not wide or len(found) > MANY:
        return found
    import shapely

    near = shapely.union_all([shape(r) for r in fills]).buffer(UNDER)
    turned = {id(r) for r in wide if near.intersects(shape(r))}
    turned |= {
        id(r)
        for r in wide
        if any(s is not r and s.color != r.color and shape(s).distance(shape(r)) < UNDER for s in wide)
    }
    return [replace(r, stitch="tatami") if id(r) in turned else r for r in found]


def stitch_of(area: Any) -> str:
    """Satin or tatami for one shapely polygon, by the share of it that is wider than satin can be."""
    import shapely

    if round_of(area):
        return "satin" if 2 * shapely.maximum_inscribed_circle(area, 0.05).length < DOT else "tatami"
    if _wider(area, SATIN) <= BODY:
        return "tatami" if _bunched(area) else "satin"
    # Between the two a plain long shape is satin that is split; what branches or turns back is better filled.
    plain = not area.interiors and area.area > 0.88 * area.convex_hull.area
    long = area.length**2 > 24 * area.area  # a square has 16, a bar twice as long as wide 18, thrice 21
    return "satin" if plain and long and _wider(area, SPLIT) <= 0.02 else "tatami"


def divided(area: Any) -> list[Any]:
    """A shapely polygon as a hand would divide it: its wide part, and long limbs far narrower than that by themselves (the frame
    round a page, a letter that hangs on a swoosh); the wide part goes on a little below them."""
    import shapely

    widest = 2 * float(shapely.maximum_inscribed_circle(area, 0.05).length)
    filled = widest > SATIN and _wider(area, SATIN) > BODY
    at, length = (SATIN, LONG) if filled else (LEAN * widest, 5 * LONG)
    core = area.buffer(-at / 2, quad_segs=8).buffer(at / 2 + SEAM, quad_segs=8)
    pieces = [p for p in shapely.get_parts(area.difference(core)) if p.area > 1]
    wide = [2 * float(shapely.maximum_inscribed_circle(p, 0.05).length) for p in pieces]
    # What only tapers off is as wide at its foot as the wide part is at least, or far from as wide everywhere.
    found = [
        p for p, w in zip(pieces, wide) if w < LEAN * at and p.area > max(length * w**2, EVEN * w * (p.length / 2 - w))
    ]
    like = [w for p, w in zip(pieces, wide) if p in found]
    found += [
        p
        for p, w in zip(pieces, wide)
        if p not in found and p.area > w**2 and any(abs(w - other) < 0.2 * other for other in like)
    ]
    if not found:
        return [area]
    found = [_blunt(p, core) for p in found]
    rest = area.difference(shapely.union_all(found).buffer(1e-3))
    left = [p for p in shapely.get_parts(rest) if p.area > 0.5]
    grown = [p for b in left for p in shapely.get_parts(b.buffer(UNDER).intersection(area)) if p.geom_type == "Polygon"]
    return [*grown, *found]


def _blunt(limb: Any, core: Any) -> Any:
    """A limb without the flare with which it meets the wide part, and without the thin horns that are left of it there."""
    import shapely

    half = limb.area / limb.length
    if half < THIN * shapely.maximum_inscribed_circle(core, 0.05).length:
        return limb
    flare = [p for p in shapely.get_parts(_opened(limb, FLARE * half)) if p.distance(core) < FLARE * half]
    left = (
        limb.difference(shapely.union_all(flare).buffer(SEAM))
        if sum(p.area for p in flare) < 0.25 * limb.area
        else limb
    )
    near = shapely.union_all([core, *flare]).buffer(2 * SEAM)
    horns = [p for p in shapely.get_parts(left.difference(_opened(left, HORN * half))) if p.intersects(near)]
    parts = shapely.get_parts(left.difference(shapely.union_all(horns).buffer(1e-6)))
    return max(parts, key=lambda p: p.area) if len(parts) else limb


def _opened(area: Any, by: float) -> Any:
    """What discs of a radius reach in an area."""
    return area.buffer(-by, quad_segs=8).buffer(by, quad_segs=8)


def _bunched(area: Any) -> bool:
    """Whether limbs meet in a middle that is much of an area, as a star's do: columns would heap up there."""
    import shapely

    disc = math.pi * shapely.maximum_inscribed_circle(area, 0.05).length ** 2
    if disc < BUNCH * area.area:
        return False
    places, radius, edges = skeleton(area)
    return len(branches(places, radius, edges)) > 1 if len(places) > 1 else False


def _wider(area: Any, width: float) -> float:
    """The share of an area that is wider than ``width``: what discs of that size reach."""
    import shapely

    if 2 * shapely.maximum_inscribed_circle(area, 0.05).length + 0.1 < width:
        return 0.0  # said at once: drawing in something with a hundred holes takes seconds
    body = area.buffer(-width / 2, quad_segs=8)
    return 0.0 if body.is_empty else float(body.buffer(width / 2, quad_segs=8).intersection(area).area / area.area)


def _parts(region: Region, later: Sequence[Region]) -> list[Region]:
    """One region for the satins of an area, and one for each of its parts that is tatami."""
    satin: list[Any] = []
    rows: list[Any] = []
    for whole in to_shapely(region.paths):
        parts = divided(whole)
        if len(parts) > 1 and any(shape(r).intersection(whole).area > COVERED * whole.area for r in later):
            parts = [whole]  # what lies below others is better one piece
        for part in parts:
            (satin if stitch_of(part) == "satin" else rows).append(part)
    made = []
    for kind, parts in (("tatami", [p]) for p in rows):
        made.append((kind, of_shapely(parts[0])))
    if satin:
        import shapely

        made.append(("satin", of_shapely(shapely.GeometryCollection(satin))))
    held = [(kind, paths) for kind, paths in made if paths is not None]
    return [
        replace(region, id=region.id if not k else f"{region.id} ({k + 1})", stitch=kind, paths=paths)
        for k, (kind, paths) in enumerate(held)
    ]


def _angled(found: list[Region]) -> tuple[Region, ...]:
    """Rows along areas' own shapes where no angle was asked for, apart from those of neighbours of other colours; areas of one
    colour in one direction, for threads that lie otherwise shine otherwise, unless that suits one of them far worse."""
    boxes = np.array([[*r.paths.coords.min(0) - 0.5, *r.paths.coords.max(0) + 0.5] for r in found]).reshape(-1, 4)
    size = (boxes[:, 2:] - boxes[:, :2]).prod(axis=1)
    free = [k for k, r in enumerate(found) if r.params.angle is None and r.role == "area" and r.stitch == "tatami"]
    counts = {k: spans(found[k].paths, 1.0) for k in free}
    angles = {k: math.degrees(r.turn) for k, r in enumerate(found) if r.params.angle is not None and r.stitch in ROWS}
    by_color: dict[tuple[int, int, int], list[int]] = {}
    for k in free:
        by_color.setdefault(found[k].color, []).append(k)
    for same in by_color.values():
        large = [k for k in same if size[k] >= LARGE * size[same].max()]
        meets = np.zeros(len(found), bool)
        for k in large:
            meets |= ((boxes[k, :2] <= boxes[:, 2:]) & (boxes[:, :2] <= boxes[k, 2:])).all(axis=1)
        beside = [angles[j] for j in np.flatnonzero(meets)[-20:].tolist() if j in angles]
        one = angle(np.sum([counts[k] for k in same], axis=0), beside)
        for k in same:
            fits = counts[k][round(one / STEP) % len(counts[k])] <= WORSE * counts[k].min()
            angles[k] = one if fits else angle(counts[k], beside)
    made = []
    for k, region in enumerate(found):
        own = region.params.angle
        own = angles.get(k, 0.0) if own is None else own
        made.append(replace(region, params=region.params.model_copy(update={"angle": own})))
    return tuple(made)

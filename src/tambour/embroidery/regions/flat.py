"""Flat: regions as a digitiser lays them out: what shines through mixed, equal neighbours one, nothing sewn that is hidden."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from tambour.core.check import Array
from tambour.core.paths import Paths
from tambour.embroidery.piece import AUTO, Region
from tambour.geometry.areas import of_shapely, to_shapely

FAINT = 0.06
"""What covers less than this share is left out."""
UNDER = 0.3
"""mm that a part goes on below what hides it: the cloth draws in. Fills reach farther, by `plan/overlap`."""
BRIDGED = 8.0
"""mm: what is narrower lies on a fill without a hole in it, so that rows need not end there; two of them cut the hole."""
TOUCH = 0.02
"""mm: areas of one colour that are no farther apart are one."""
BARE = 0.25
"""mm² of an area that must show for it to be sewn."""
EDGE = 0.6
"""mm that what is hidden keeps from the edge of what hides it where cloth begins."""
HAIR = 0.1
"""mm: half of what holds two parts of an area together."""
MITRE = 1.5
"""How far a corner stands out at the most, in half widths: satin leads no farther."""
CLOTH = (255, 255, 255)
"""What shines through where nothing lies below."""
DENSE = (AUTO, "tatami", "contour", "spiral", "radial", "guided", "flow", "satin")


@dataclass(frozen=True, slots=True)
class Flat:
    """Flat regions, and what became of the rest: faint and hidden ones, and how many were joined to others."""

    regions: tuple[Region, ...]
    faint: int = 0
    hidden: int = 0
    joined: int = 0


def shape(region: Region) -> Any:
    """The shapely area that a region covers."""
    import shapely

    if region.role == "area":
        return shapely.union_all(to_shapely(region.paths))
    return shapely.union_all(stroked(region, region.paths, max(region.width, 0.3)))


def stroked(region: Region, lines: Iterable[Array], width: float) -> list[Any]:
    """The shapely areas of ``lines`` of a region, ``width`` mm wide, each ended and turned as the region's are sewn."""
    import shapely

    how = {"cap_style": ("round", "flat", "square")[region.cap], "join_style": ("round", "mitre", "mitre")[region.join]}
    return [
        shapely.LineString(p).buffer(width / 2, quad_segs=16, mitre_limit=MITRE, **how) for p in lines if len(p) > 1
    ]


def mixed(found: Sequence[Region]) -> Flat:
    """Regions of whole colours: a translucent one becomes one for each colour that shines through it, or through which
    the cloth does; a line takes the colour that is below most of it."""
    import shapely

    made: list[Region] = []
    shapes: list[Any] = []
    faint = 0
    for region in found:
        if region.alpha < FAINT:
            faint += 1
            continue
        if region.alpha >= 1:
            made.append(region)
            shapes.append(None)  # asked for only if something shines through
            continue
        own = shape(region)
        pieces: list[tuple[Any, tuple[int, int, int]]] = []
        for k in range(len(made) - 1, -1, -1):
            if own.is_empty:
                break
            if not _solid(made[k]):
                continue
            below = shapes[k] = shape(made[k]) if shapes[k] is None else shapes[k]
            if below.intersects(own):
                pieces.append((own.intersection(below), _mix(region, made[k].color)))
                own = own.difference(below)
        pieces.append((own, _mix(region, CLOTH)))
        if region.role != "area":
            color = max(pieces, key=lambda piece: piece[0].area)[1]
            made.append(replace(region, color=color, alpha=1.0))
            shapes.append(None)
            continue
        by_color: dict[tuple[int, int, int], list[Any]] = {}
        for area, color in pieces:
            by_color.setdefault(color, []).append(area)
        many = len(by_color) > 1
        for n, (color, areas) in enumerate(by_color.items()):
            paths = of_shapely(shapely.union_all(areas))
            if paths is not None:
                name = region.id if not (many and n) else f"{region.id} over {n + 1}"
                made.append(replace(region, id=name, color=color, alpha=1.0, paths=paths))
                shapes.append(None)
    return Flat(tuple(made), faint=faint)


def _mix(region: Region, below: tuple[int, int, int]) -> tuple[int, int, int]:
    r, g, b = (round(a * region.alpha + c * (1 - region.alpha)) for a, c in zip(region.color, below))
    return r, g, b


def _solid(region: Region) -> bool:
    """Whether nothing shows through the thread of a region."""
    p = region.params
    if region.role == "area":
        return region.stitch in DENSE and p.row_spacing <= 1.75 * p.thread
    return region.stitch == "satin" and region.role == "line"


def _free(region: Region) -> bool:
    """Whether a region's shape is ours to change: not laid out by hand, no patch, no border along its edge."""
    p = region.params
    return region.role == "area" and "whole" not in region.flags and not p.applique and p.border == 0


def joined(found: Sequence[Region]) -> Flat:
    """Areas of one colour and one stitch that touch, as one; nothing that lies between them is covered by that."""
    import shapely

    if len(found) < 2:
        return Flat(tuple(found))
    shapes: list[Any] = [shape(r) if r.role == "area" else None for r in found]
    boxes = [shapely.box(*_bounds(r)) for r in found]
    made: list[Region | None] = list(found)
    last: dict[tuple[Any, ...], list[int]] = {}
    count = 0
    for k, region in enumerate(found):
        if not _free(region) or region.stitch not in (AUTO, "tatami", "satin"):
            continue
        key = (
            region.color,
            region.stitch,
            region.params,
            region.flags,
            region.start,
            region.end,
            region.rank,
            id(region.guide),
        )
        names = last.setdefault(_hashed(key), [])
        x0, y0, x1, y1 = shapes[k].bounds
        near = [j for j in names if made[j] is not None and _meets(shapes[j].bounds, (x0, y0, x1, y1))]
        for j in [j for j in near if shapes[j].distance(shapes[k]) < TOUCH]:
            between = [m for m in range(j + 1, k) if made[m] is not None and boxes[m].intersects(boxes[j])]
            if any(shape(made[m]).intersects(shapes[j]) for m in between):  # type: ignore[arg-type]
                continue
            whole = shapely.union_all([shapes[j].buffer(0.01, join_style="mitre"), shapes[k]])
            paths = of_shapely(whole)
            if paths is None:
                continue
            shapes[k], boxes[k] = whole, shapely.box(*whole.bounds)
            before = made[j]
            assert before is not None
            made[k] = replace(region, id=before.id, paths=paths)
            region = made[k]  # type: ignore[assignment]
            made[j] = None
            count += 1
        names.append(k)
    return Flat(tuple(r for r in made if r is not None), joined=count)


def _meets(a: tuple[float, ...], b: tuple[float, ...]) -> bool:
    return a[0] < b[2] + TOUCH and b[0] < a[2] + TOUCH and a[1] < b[3] + TOUCH and b[1] < a[3] + TOUCH


def _hashed(key: tuple[Any, ...]) -> tuple[Any, ...]:
    color, stitch, params, *rest = key
    return (color, stitch, repr(params), *map(repr, rest))


def _bounds(region: Region) -> tuple[float, float, float, float]:
    low, high = region.paths.coords.min(0) - region.width / 2, region.paths.coords.max(0) + region.width / 2
    return float(low[0]), float(low[1]), float(high[0]), float(high[1])


def uncovered(found: Sequence[Region]) -> Flat:
    """Regions without what later ones hide, but for ``UNDER`` mm below their edges and for what a fill can bridge."""
    import shapely

    if len(found) < 2:
        return Flat(tuple(found))
    shapes = [shape(r) for r in found]
    solid = [_solid(r) for r in found]
    tree = shapely.STRtree(shapes)
    made: list[Region] = []
    hidden = 0
    for k, region in enumerate(found):
        later = [j for j in tree.query(shapes[k]).tolist() if j > k and solid[j]]
        free = _free(region) or (region.role == "line" and "whole" not in region.flags)
        over = [shapes[j] for j in later if shapes[j].intersects(shapes[k])] if free else []
        if not over:
            made.append(region)
            continue
        cover = shapely.union_all(over)
        shown = shapes[k].difference(cover)
        if shown.area < min(BARE, 0.5 * shapes[k].area):
            hidden += 1
            continue
        if region.role == "line":
            # Lines of one thread meet in joints (plan/joints): which of them lies below is not yet said.
            cut = [shapes[j] for j in later if found[j].role != "line" or found[j].color != region.color]
            made.append(_line(region, shapely.union_all(cut)))
        else:
            made.append(_area(region, shapes[k], cover, over))
    return Flat(tuple(made), hidden=hidden)


def _area(region: Region, area: Any, cover: Any, over: list[Any]) -> Region:
    import shapely

    below = area.intersection(cover.buffer(-UNDER))
    cut = [below.buffer(-BRIDGED / 2).buffer(BRIDGED / 2 - 1e-3)]
    if 1 < len(over) <= 60:
        twice = [a.intersection(b) for n, a in enumerate(over) for b in over[:n] if a.intersects(b)]
        if twice:
            deep = shapely.union_all(twice).buffer(-UNDER).intersection(below)
            cut.append(deep.buffer(-UNDER).buffer(UNDER - 1e-3))
    gone = shapely.union_all(cut)
    # Where nothing of it is seen at the edge of all, its ends would stand out below what covers it, sewn in another direction.
    whole = shapely.union(area, cover)
    seen = area.difference(cover).buffer(UNDER)
    rim = area.difference(whole.buffer(-EDGE)).difference(seen)
    rim = shapely.union_all([p for p in shapely.get_parts(rim) if p.area > EDGE**2 / 4])
    if gone.area < 1.0 and rim.is_empty:
        return region
    gone = shapely.union(gone, rim) if gone.area >= 1.0 else rim
    # What hangs together only by a thread's breadth of hidden rim is looked at apart.
    rest = area.difference(gone).buffer(-HAIR, join_style="mitre").buffer(HAIR, join_style="mitre")
    left = [p for p in shapely.get_parts(rest) if p.difference(cover).area > BARE / 5]
    paths = of_shapely(shapely.GeometryCollection(left))
    return region if paths is None else replace(region, paths=paths)


def _line(region: Region, cover: Any) -> Region:
    """A line without the stretches that lie hidden for longer than a fill would bridge."""
    import shapely

    core = cover.buffer(-UNDER)
    made = []
    for points in region.paths:
        line = shapely.LineString(points)
        gone = [p for p in shapely.get_parts(line.intersection(core)) if p.length > BRIDGED]
        if not gone:
            made.append(points)
            continue
        rest = shapely.get_parts(shapely.line_merge(line.difference(shapely.union_all(gone).buffer(1e-6))))
        closed = len(points) > 2 and (points[0] == points[-1]).all()
        pieces = [shapely.get_coordinates(p) for p in rest if p.geom_type == "LineString" and p.length > 1.0]
        if closed and len(pieces) > 1 and (pieces[0][0] == pieces[-1][-1]).all():
            pieces = [np.concatenate([pieces[-1], pieces[0][1:]]), *pieces[1:-1]]
        made += pieces
    return replace(region, paths=Paths.of(made)) if made else region

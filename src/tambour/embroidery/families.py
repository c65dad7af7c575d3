"""Families: which stitches a region is made of, in the order in which they are sewn."""

from __future__ import annotations

import math

import numpy as np

from tambour.core.paths import Paths
from tambour.core.progress import Progress
from tambour.embroidery.fill import Rings, rings
from tambour.embroidery.piece import TRAVEL, Region
from tambour.embroidery.stitches import Stitches, join, line_stitches
from tambour.embroidery.tatami import tatami
from tambour.embroidery.ways import way
from tambour.noise import key

Place = tuple[float, float] | None


def region_stitches(region: Region, start: Place, end: Place, progress: Progress) -> list[Stitches]:
    """The threads of a region: one per connected area or line; between them the needle jumps.

    start : where the needle comes from; end : where it will go on; both in drawing coordinates, None when free
    """
    if region.role == "area":
        return area_stitches(region, start, end, progress)
    raise AssertionError(region.role)


def area_stitches(region: Region, start: Place, end: Place, progress: Progress) -> list[Stitches]:
    """Every polygon of an area, nearest first."""
    p = region.params
    polygons = _split(grown(region.paths, p.pull))
    made = []
    here = start
    while polygons:
        k = _nearest(polygons, here)
        made.append(polygon_stitches(region, polygons.pop(k), here, end))
        if len(made[-1]):
            here = (float(made[-1].xy[-1, 0]), float(made[-1].xy[-1, 1]))
    return made


def polygon_stitches(region: Region, polygon: Paths, start: Place, end: Place) -> Stitches:
    """Underlay and fill of one connected polygon, without a jump."""
    p = region.params
    area = rings(polygon)
    angle = math.radians(p.angle)
    parts = []
    fill = tatami(
        rings(polygon, angle), angle, p.row_spacing, p.length, stagger=p.stagger, jitter=p.jitter,
        key=key(p.seed, region.id), travel=p.travel, start=region.start or start,
    )  # fmt: skip
    parts.append(fill)
    return linked(parts, area, p.length)


def linked(parts: list[Stitches], area: Rings, length: float) -> Stitches:
    """Threads of one area as one, with ways between them that stay inside."""
    made: list[Stitches] = []
    for part in parts:
        if not len(part):
            continue
        if made:
            a, b = made[-1].xy[-1], part.xy[0]
            away = float(np.hypot(*(b - a)))
            if away > 1e-9:
                line = way(area, a, b)
                link = line_stitches(line, length, TRAVEL, 0.04)
                mm = float(np.hypot(*np.diff(line, axis=0).T).sum())
                made.append(Stitches(link.xy[1:], link.kind[1:], link.run[1:], {"connector_mm": mm}))
            part = Stitches(part.xy[1:], part.kind[1:], part.run[1:], part.facts)
        made.append(part)
    return join(made)


def grown(area: Paths, by: float) -> Paths:
    """An area grown (or shrunk) on all sides."""
    if by == 0:
        return area
    import shapely

    from tambour.embroidery.regions import of_shapely, to_shapely

    made = of_shapely(shapely.union_all([a.buffer(by, join_style="mitre") for a in to_shapely(area)]))
    return area if made is None else made


def _split(area: Paths) -> list[Paths]:
    assert area.parts is not None
    found = []
    for a, b in zip(area.parts[:-1].tolist(), area.parts[1:].tolist()):
        found.append(Paths.of([area[i] for i in range(a, b)]))
    return found


def _nearest(polygons: list[Paths], here: Place) -> int:
    if here is None:
        return 0
    return int(np.argmin([((p.coords - np.array(here)) ** 2).sum(1).min() for p in polygons]))

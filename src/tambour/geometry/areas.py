"""Areas: rings as valid polygons by a fill rule, and between Paths with parts and shapely."""

from __future__ import annotations

from typing import Any

import numpy as np

from tambour.core.check import Array
from tambour.core.paths import Paths

SMALLEST = 0.05
"""mm²: smaller areas are left out."""


def polygons(lines: list[Array], evenodd: bool) -> Paths | None:
    """Valid polygons (``parts`` given) of the area that rings enclose by a fill rule; None when there is none."""
    return of_shapely(enclosed(lines, evenodd))


def enclosed(lines: list[Array], evenodd: bool) -> Any:
    """The shapely area that rings enclose by a fill rule.

    Open lines are closed. Where rings cross themselves or each other the plane is cut into faces along all of them,
    and each face judged by its winding number.
    """
    import shapely

    closed = [line for line in lines if len(line) >= 3]
    if not closed:
        return shapely.GeometryCollection()
    if len(closed) == 1:
        simple = shapely.polygons(closed[0])
        if shapely.is_valid(simple):
            return simple
    rings = [np.concatenate([c, c[:1]]) if (c[0] != c[-1]).any() else c for c in closed]
    noded = shapely.unary_union(shapely.MultiLineString(rings))
    faces = shapely.get_parts(shapely.polygonize([noded]))
    if not len(faces):
        return shapely.GeometryCollection()
    inside = shapely.get_coordinates(shapely.point_on_surface(faces))
    winding = np.zeros(len(faces), np.int64)
    for ring in rings:
        a, b = ring[:-1], ring[1:]
        for k in range(0, len(faces), 256):
            x, y = inside[k : k + 256, 0, None], inside[k : k + 256, 1, None]
            up, down = (a[:, 1] <= y) & (b[:, 1] > y), (a[:, 1] > y) & (b[:, 1] <= y)
            left = (b[:, 0] - a[:, 0]) * (y - a[:, 1]) - (x - a[:, 0]) * (b[:, 1] - a[:, 1])
            winding[k : k + 256] += (up & (left > 0)).sum(1) - (down & (left < 0)).sum(1)
    keep = winding % 2 == 1 if evenodd else winding != 0
    return shapely.union_all(faces[keep])


def of_shapely(area: Any) -> Paths | None:
    """Polygons of a shapely area as Paths with parts, slivers left out; None when nothing stays."""
    import shapely

    rings, parts = [], [0]
    for polygon in shapely.get_parts(area):
        if polygon.geom_type != "Polygon" or polygon.area < SMALLEST:
            continue
        outline = [polygon.exterior, *(h for h in polygon.interiors if shapely.Polygon(h).area >= SMALLEST)]
        rings += [shapely.get_coordinates(r) for r in outline]
        parts.append(len(rings))
    if not rings:
        return None
    made = Paths.of(rings)
    return Paths(made.coords, made.offsets, np.array(parts))


def to_shapely(area: Paths) -> list[Any]:
    """Each polygon of an area as a shapely Polygon."""
    import shapely

    assert area.parts is not None
    return [
        shapely.Polygon(area[int(a)], [area[i] for i in range(int(a) + 1, int(b))])
        for a, b in zip(area.parts[:-1], area.parts[1:])
    ]

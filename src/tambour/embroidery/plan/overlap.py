"""Overlap: fills go on a little below what is sewn over their edge, so that no cloth shows when it draws in."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from tambour.embroidery.piece import MANY, Region
from tambour.embroidery.regions.flat import EDGE, shape

UNDER = 0.5
"""mm that a fill goes on below its neighbour (what Wilcom lets neighbours overlap by)."""
NEAR = 0.3
"""mm: what lies no farther apart was meant to meet."""


def overlapped(found: Sequence[Region]) -> tuple[Region, ...]:
    """Regions whose fills reach ``UNDER`` mm below the later regions of another colour that meet them."""
    fills = [k for k, r in enumerate(found) if r.role == "area" and r.stitch != "satin" and not r.params.applique]
    if not fills or not 1 < len(found) <= MANY:
        return tuple(found)
    import shapely

    from tambour.geometry.areas import of_shapely, to_shapely

    shapes = [shape(r) for r in found]
    tree = shapely.STRtree(shapes)
    made = list(found)
    for k in fills:
        near = [
            j for j in tree.query(shapes[k], "dwithin", NEAR).tolist() if j > k and found[j].color != found[k].color
        ]
        if not near:
            continue
        below = shapely.union_all([shapes[j] for j in near])
        reach = shapes[k].buffer(UNDER + NEAR, quad_segs=8) & below
        # Only what is seen has an edge to hide: what lies below already keeps from the cover's other edges (regions/flat).
        seen = shapes[k].difference(below).buffer(UNDER + NEAR, quad_segs=8)
        reach = reach.difference(reach.difference(seen) - (shapes[k] | below).buffer(-EDGE))
        paths = of_shapely(shapely.union_all([*to_shapely(found[k].paths), *_polygons(reach)]))
        if paths is not None:
            made[k] = replace(found[k], paths=paths)
    return tuple(made)


def _polygons(shape: Any) -> list[Any]:
    parts = getattr(shape, "geoms", [shape])
    return [p for p in parts if p.geom_type == "Polygon" and p.area > 1e-6]

"""Rows: fills of straight rows: where they must be sewn to come out as drawn, the run along their rim, the rows themselves."""

from __future__ import annotations

from typing import Any

import numpy as np

from tambour.core.check import Array
from tambour.core.paths import Paths
from tambour.embroidery.families.tatami import tatami
from tambour.embroidery.lines.fill import from_rows, polygon_of, rings
from tambour.embroidery.lines.net import weave
from tambour.embroidery.piece import UNDERLAY, Region
from tambour.embroidery.stitches import Stitches
from tambour.noise import key

ROWS = ("tatami", "gradient")
BEND = 0.03  # mm that the run along a rim may cut its bends


def dense(region: Region) -> bool:
    """Whether a region's rows hide what lies below them."""
    return region.stitch == "tatami" and region.params.row_spacing <= 1.75 * region.params.thread


def rimmed(region: Region) -> bool:
    """Whether a run lies along the rim of a region's fill: below dense rows, unless a border does so or a hand said what lies there."""
    p = region.params
    return p.rim and dense(region) and p.border == 0 and "whole" not in region.flags and p.underlay != "none"


def compensated(region: Region) -> Paths:
    """An area of rows as it must be sewn to come out as drawn: longer by the pull on each side, the outermost rows in by
    the push."""
    import shapely

    from tambour.geometry.areas import of_shapely, to_shapely

    p = region.params
    along = from_rows(np.array([[1.0, 0.0], [0.0, 1.0]]), region.turn)
    made = [swept(held_back(area, p.push * along[1]), p.pull * along[0]) for area in to_shapely(region.paths)]
    found = of_shapely(shapely.union_all(made))
    return region.paths if found is None else found


def held_back(area: Any, by: Array) -> Any:
    """A shapely area without what lies nearer than ``by`` to its edges along that direction; half of it stays at least."""
    import shapely
    from shapely.affinity import translate

    if not by.any():
        return area
    kept = shapely.intersection_all([area, translate(area, *by), translate(area, *-by)])
    # What only touches itself when moved leaves a line or a point: nothing to sew.
    kept = shapely.MultiPolygon([a for a in flat(kept) if a.area > 0])
    return area if kept.area < 0.5 * area.area else kept


def swept(area: Any, by: Array) -> Any:
    """A shapely area moved from ``-by`` to ``by``: all that it passes."""
    import shapely
    from shapely.affinity import translate

    if not by.any():
        return area
    parts = [translate(area, *-by), translate(area, *by)]
    for polygon in flat(area):
        for ring in (polygon.exterior, *polygon.interiors):
            line = shapely.get_coordinates(ring)
            corners = np.stack([line[:-1] - by, line[1:] - by, line[1:] + by, line[:-1] + by], axis=1)
            flat_ = np.abs((line[1:] - line[:-1]) @ np.array([-by[1], by[0]])) > 1e-12
            parts += list(shapely.polygons(corners[flat_]))
    return shapely.union_all(parts)


def flat(shape: Any) -> list[Any]:
    """The polygons of a shapely shape."""
    return [part for part in getattr(shape, "geoms", [shape]) if part.geom_type == "Polygon"]


def body(polygon: Paths, region: Region) -> Paths:
    """Where the rows of a polygon with a run along its rim lie: half a thread inside it at its sides, so that none of them lies
    beyond the run, and what is between the outermost row and the rim is thread and no cloth."""
    from tambour.geometry.areas import of_shapely

    across = from_rows(np.array([[0.0, 1.0]]), region.turn)[0]
    found = of_shapely(held_back(polygon_of(rings(polygon)), region.params.thread / 2 * across))
    return polygon if found is None else found


def rim(inner: Paths, region: Region, start: Any) -> Stitches:
    """The run along the rim of a polygon, ``inner`` : it drawn in by half a thread."""
    length = min(region.params.length, 2.5)
    return weave(list(inner), rings(inner), length, 1.0, kind=UNDERLAY, start=start, stagger=1, tolerance=BEND)


def filled(region: Region, polygon: Paths, start: Any) -> Stitches:
    """The rows of one connected polygon."""
    p = region.params
    turned = rings(polygon, region.turn)
    at = None
    if region.stitch == "gradient":
        v = turned.points[:, 1]
        at = gradient_levels(float(v.min()), float(v.max()), p.row_spacing, p.row_spacing_end or 3 * p.row_spacing)
    return tatami(
        turned,
        region.turn,
        p.row_spacing,
        p.length,
        stagger=p.stagger,
        jitter=p.jitter,
        key=key(p.seed, region.id),
        travel=p.travel if dense(region) else "outline",  # thin rows hide nothing
        start=start,
        at=at,
    )


def gradient_levels(low: float, high: float, first: float, last: float) -> Array:
    """Row heights from ``high`` (drawn below) up to ``low``, their distance growing evenly from first to last."""
    n = max(1, round((high - low) / ((first + last) / 2)))
    gap = np.linspace(first, last, n)
    at = high - first / 2 - np.r_[0, np.cumsum(gap[:-1])]
    return np.ascontiguousarray(np.sort(at[(at > low) & (at < high)]))

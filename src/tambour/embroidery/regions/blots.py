"""Blots: closed strokes that leave nothing bare inside are areas, as the eye sees them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from tambour.core.paths import Paths
from tambour.embroidery.piece import AUTO, Region
from tambour.embroidery.regions.flat import shape
from tambour.geometry.areas import of_shapely, to_shapely


def blotted(found: Sequence[Region]) -> tuple[Region, ...]:
    """Regions in which closed lines that cover all they enclose are areas, one with the fill of their shape where that has their
    colour: columns along them would turn about one place (a dot drawn as a ring) or cross (a star's outline). A stroke that is
    hidden for the most part is one with its fill too: what shows of it would be stubs of columns.

    What somebody said the stitch of, and what was laid out by hand, stays.
    """
    made: list[Region] = []
    for k, region in enumerate(found):
        if region.role != "line" or region.stitch != "satin" or region.params.stitch or "whole" in region.flags:
            made.append(region)
            continue
        below = made[-1] if made else None
        one = below is not None and below.stitch == AUTO and _same(below, region)
        if below is not None and one and (_bold(region, below) or _hidden(region, found[k + 1 :])):
            made[-1] = replace(below, paths=_joined([*to_shapely(below.paths), *_strokes(region, list(region.paths))]))
            continue
        full = [k for k, line in enumerate(region.paths) if _full(line, region.width)]
        if full:
            area = _joined([_inside(region.paths[k]).buffer(region.width / 2) for k in full])
            made.append(replace(region, paths=area, stitch=AUTO, role="area", width=0.0))
        rest = [line for k, line in enumerate(region.paths) if k not in full]
        if rest:
            made.append(replace(region, paths=Paths.of(rest)))
    return tuple(made)


def _same(fill: Region, stroke: Region) -> bool:
    """Whether they are the fill and the stroke of one shape, of one colour that covers what is below."""
    alike = fill.id == stroke.id and fill.color == stroke.color and fill.params == stroke.params
    return alike and fill.alpha >= 1 <= stroke.alpha and fill.flags == stroke.flags


def _bold(stroke: Region, fill: Region) -> bool:
    """Whether a stroke is of closed lines, and no thinner than a third of the fill inside them."""
    import shapely

    shut = all((line[0] == line[-1]).all() for line in stroke.paths)
    return shut and bool(shapely.union_all(to_shapely(fill.paths)).buffer(-1.5 * stroke.width).is_empty)


def _hidden(stroke: Region, later: Sequence[Region]) -> bool:
    """Whether later regions hide more than half of a stroke."""
    import shapely

    own = shape(stroke)
    over = [s for r in later if r.color != stroke.color and (s := shape(r)).intersects(own)]
    return bool(shapely.union_all(over).intersection(own).area > 0.5 * own.area) if over else False


def _inside(line: Any) -> Any:
    import shapely

    return shapely.Polygon(line).buffer(0)


def _full(line: Any, width: float) -> bool:
    """Whether a closed line covers all that it encloses."""
    if len(line) < 4 or (line[0] != line[-1]).any():
        return False
    inside = _inside(line)
    return inside.area > 0 and inside.buffer(-width / 2).is_empty


def _strokes(region: Region, lines: list[Any]) -> list[Any]:
    """The areas of lines as they are drawn, which sewn they would not quite have (``flat.stroked``)."""
    import shapely

    how = {"cap_style": ("round", "flat", "square")[region.cap], "join_style": ("round", "mitre", "bevel")[region.join]}
    return [shapely.LineString(line).buffer(region.width / 2, quad_segs=16, **how) for line in lines]


def _joined(shapes: list[Any]) -> Paths:
    import shapely

    made = of_shapely(shapely.union_all(shapes))
    assert made is not None  # each of them has an area
    return made

"""Gaps: cloth that shows as a hair line between areas of one colour is widened, so that thread does not close it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from tambour.embroidery.piece import AUTO, Region
from tambour.embroidery.regions.flat import TOUCH, shape
from tambour.geometry.areas import of_shapely, to_shapely

SHOWN = 0.8
"""mm that a gap is wide at least before thread is drawn out over both its edges."""
LONG = 6.0
"""times as long as that a gap must be: shorter ones are notches."""
SEEN = 0.1
"""mm: what is narrower, in the mean, is no gap that somebody drew."""


def opened(found: Sequence[Region]) -> tuple[tuple[Region, ...], int]:
    """The regions with narrow gaps between areas of one colour widened, and how many there are."""
    import shapely

    asked = [k for k, r in enumerate(found) if _may(r)]
    if not asked:
        return tuple(found), 0
    made = list(found)
    count = 0
    for color in sorted({found[k].color for k in asked}):
        own = [k for k in asked if found[k].color == color]
        shapes = {k: shapely.union_all(to_shapely(found[k].paths)) for k in own}
        least = SHOWN + 2 * max(found[k].params.pull for k in own)
        whole = shapely.union_all(list(shapes.values()))
        # What something else covers is no cloth.
        gaps = _slits(whole, least)
        covered = shapely.union_all([shape(r) for k, r in enumerate(found) if gaps and k not in shapes])
        gaps = [g for g in gaps if covered.intersection(g).area < 0.3 * g.area]
        count += len(gaps)
        wider = [g.buffer((least - 2 * g.area / g.length) / 2, cap_style="flat", quad_segs=4) for g in gaps]
        cut = shapely.union_all(wider)
        for k in own if wider else []:
            if not shapes[k].intersects(cut):
                continue
            left = shapes[k].difference(cut)
            paths = of_shapely(shapely.GeometryCollection([p for p in shapely.get_parts(left) if p.area > 0.5]))
            if paths is not None:
                made[k] = replace(found[k], paths=paths)
    return tuple(made), count


def _slits(whole: Any, least: float) -> list[Any]:
    """The long narrow places, less than ``least`` mm wide, that a shapely area leaves between its parts."""
    import shapely

    closed = whole.buffer(least / 2, quad_segs=8).buffer(-least / 2, quad_segs=8)
    found = []
    for gap in shapely.get_parts(closed.difference(whole.buffer(TOUCH))):
        wide = 2 * gap.area / max(1e-9, gap.length)
        if gap.geom_type == "Polygon" and gap.length / 2 > LONG * least and SEEN < wide < least:
            found.append(gap)
    return found


def _may(region: Region) -> bool:
    p = region.params
    free = region.role == "area" and region.stitch in (AUTO, "tatami", "satin") and not region.flags
    return free and not p.applique and p.border == 0

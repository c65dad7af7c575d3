"""Massed: a filled area and the lines of its colour that run along its edge are one mass, sewn as one fill without a ridge."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from tambour.core.paths import Paths
from tambour.embroidery.families.decide import stitch_of
from tambour.embroidery.piece import AUTO, Region
from tambour.embroidery.regions.flat import shape
from tambour.geometry.areas import of_shapely, to_shapely

ALONG = 0.35
"""Widths: a line whose middle lies no farther from an area runs along it."""
LONG = 2.5
"""Widths that a line must run along an area to be part of it."""
EDGE = 0.35
"""Share of an area's edge that lines must run along for them and it to be one mass."""
MASS = 1.5
"""Widths of the lines that half of the area must have at least that they and the fill give."""
LAP = 0.5
"""Widths of a line that lie on the mass where it leaves it."""


def massed(found: Sequence[Region]) -> tuple[Region, ...]:
    """The regions, areas grown by the lines of their colour along their edges, and those lines without these stretches; only
    where the area that this gives is far wider than they are, and nobody said how either is sewn."""
    import shapely

    by_color: dict[tuple[int, int, int], list[int]] = {}
    for k, r in enumerate(found):
        if r.rank is None and not r.flags and r.start is None and r.end is None:
            by_color.setdefault(r.color, []).append(k)
    made: list[list[Region]] = [[r] for r in found]
    for same in by_color.values():
        areas = [k for k in same if found[k].role == "area" and found[k].stitch == AUTO and not _own(found[k])]
        lines = {k: found[k] for k in same if found[k].role == "line" and found[k].stitch == "satin"}
        if not areas or not lines:
            continue
        for k in areas:
            own = shape(found[k])
            near = [j for j, r in lines.items() if _near(own, r)]
            if not near:
                continue
            last = max([k, *near])
            between = [shape(r) for r in found[min([k, *near]) + 1 : last] if r.color != found[k].color]
            seen = own.difference(shapely.union_all([b for b in between if b.intersects(own)]))
            taken = {j: _along(seen, lines[j]) for j in near}
            if sum(p.length for parts in taken.values() for p in parts) < EDGE * seen.length:
                continue
            strokes = [p.buffer(found[j].width / 2, cap_style="round") for j, parts in taken.items() for p in parts]
            whole = shapely.union_all([seen, *strokes]).buffer(0.02)
            parts = [p for p in shapely.get_parts(whole) if any(p.intersects(s) for s in strokes)]
            wide = max(found[j].width for j in near)
            body = shapely.union_all(parts).buffer(-MASS * wide / 2).buffer(MASS * wide / 2)
            if not strokes or body.area < 0.5 * sum(p.area for p in parts):
                continue
            kind = "tatami" if any(stitch_of(p) == "satin" for p in parts) else AUTO
            paths = of_shapely(shapely.GeometryCollection([p for p in shapely.get_parts(whole) if p.area > 0.25]))
            if paths is None:
                continue
            for j in near:
                lines[j] = _rest(lines[j], taken[j])
                made[j] = [lines[j]] * bool(len(lines[j].paths)) + [r for r in made[j] if r.role == "area"]
            made[k] = [r for r in made[k] if r is not found[k]]
            made[last].append(replace(found[k], paths=paths, stitch=kind))
            lines = {j: r for j, r in lines.items() if len(r.paths)}
    return tuple(r for here in made for r in here)


def _own(region: Region) -> bool:
    p = region.params
    return region.alpha < 1 or bool(p.applique) or p.border > 0 or not to_shapely(region.paths)


def _near(area: Any, line: Region) -> bool:
    import shapely

    return any(shapely.LineString(p).distance(area) < ALONG * line.width for p in line.paths)


def _along(area: Any, line: Region) -> list[Any]:
    """The stretches of a line that run along an area, as shapely lines."""
    import shapely

    reach = area.buffer(ALONG * line.width)
    found: list[Any] = []
    for p in line.paths:
        met = shapely.get_parts(shapely.line_merge(shapely.LineString(p).intersection(reach)))
        found += [q for q in met if q.geom_type == "LineString" and q.length > LONG * line.width]
    return found


def _rest(line: Region, taken: list[Any]) -> Region:
    """A line without the stretches taken, but for what laps them at their ends."""
    import shapely
    from shapely.ops import substring

    lap = LAP * line.width
    gone = shapely.union_all([(q if q.is_ring else substring(q, lap, q.length - lap)).buffer(1e-6) for q in taken])
    left: list[Any] = []
    for p in line.paths:
        rest = shapely.LineString(p).difference(gone)
        left += [q for q in shapely.get_parts(shapely.line_merge(rest)) if q.length > 2.1 * lap]
    return replace(line, paths=Paths.of([shapely.get_coordinates(q) for q in left]))

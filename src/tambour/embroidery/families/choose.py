"""Families: which stitches a region is made of, in the order in which they are sewn."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np

from tambour.core.check import Array
from tambour.core.paths import Paths
from tambour.embroidery.columns.branch import branched
from tambour.embroidery.columns.ends import ended
from tambour.embroidery.columns.satin import drawn_back, from_rails
from tambour.embroidery.columns.stroke import closed, from_stroke, stroke_stitches
from tambour.embroidery.families.rows import ROWS, body, compensated, filled, rim, rimmed
from tambour.embroidery.families.tatami import tatami
from tambour.embroidery.lines import curves, grids
from tambour.embroidery.lines.fill import Rings, polygon_of, rings
from tambour.embroidery.lines.flow import flow
from tambour.embroidery.lines.least import tidy
from tambour.embroidery.lines.net import weave
from tambour.embroidery.lines.run import bean, from_nearest, manual, motif, running
from tambour.embroidery.lines.ways import nearest_on_outline, way
from tambour.embroidery.params import EmbroideryParams
from tambour.embroidery.piece import TRAVEL, UNDERLAY, Region
from tambour.embroidery.regions.flat import stroked
from tambour.embroidery.stitches import Stitches, join, line_stitches

Place = tuple[float, float] | None
RIMMED = (
    1.0  # mm that thin rows keep from an edge along which a run lies already: their turns would show as a ridge there
)
NARROW = 8.0  # mm: where an area is no wider, as a column might be, its edge walk is underlay enough
COVERED = ("tatami", "contour", "spiral", "radial", "guided", "flow", "gradient", "satin")


def region_stitches(region: Region, start: Place, end: Place, over: Any = None) -> list[Stitches]:
    """The threads of a region: one per connected area or line; between them the needle jumps.

    start : where the needle comes from; end : where it will go on; both in drawing coordinates, None when free
    over : the shapely area of lines that the same thread sews later: satin lines end below them
    """
    if region.role == "area":
        return area_stitches(region, start, end)
    if region.role == "rails":
        column = drawn_back(from_rails(list(region.paths)), region.params.push, region.params.push)
        made = [stroke_stitches([column], region.params, region.id, region.start or start)]
    else:
        made = line_family(region, region.start or start, over)
    return [tidy(thread, region.params.min_length) for thread in made]


def line_family(region: Region, start: Place, over: Any = None) -> list[Stitches]:
    """Every line of a region, nearest first; those of satin end below the ones that are sewn after them."""
    p = region.params
    lines = list(region.paths)
    ends = np.array([line[[0, -1]] for line in lines])
    free = np.ones(len(lines), bool)
    made: list[Stitches] = []
    here = start
    while free.any():
        far = ((ends - np.array(here or (0.0, 0.0))) ** 2).sum(2).min(1)
        k = int(np.argmin(np.where(free, far, np.inf))) if here is not None else int(np.argmax(free))
        free[k] = False
        line = from_nearest(lines[k], here)
        if region.stitch == "satin":
            columns = from_stroke(line, region.width, region.join)
            if columns and not closed(line, region.width):
                columns[0] = drawn_back(columns[0], p.push, 0.0)
                columns[-1] = drawn_back(columns[-1], 0.0, p.push)
                columns = ended(columns, region.width / 2, region.cap)
            rest = [over, *(stroke(line, region) for line, left in zip(lines, free) if left)]
            threads = [stroke_stitches(columns, p, region.id, here, union(rest))]
        elif region.stitch == "bean":
            threads = [bean(line, p)]
        elif region.stitch == "motif":
            threads = [motif(line, p)]
        elif region.stitch == "manual":
            threads = [manual(line, p)]
        else:
            threads = [running(line, p)]
        for thread in threads:
            if len(thread):
                made.append(thread)
                here = (float(thread.xy[-1, 0]), float(thread.xy[-1, 1]))
    return made


def stroke(line: Array, region: Region) -> Any:
    """The shapely area that a line of a region covers when it is sewn as satin."""
    import shapely

    return shapely.union_all(stroked(region, [line], region.width) if region.stitch == "satin" else [])


def union(shapes: list[Any]) -> Any:
    """Shapely areas as one; None stands for none."""
    import shapely

    return shapely.union_all([s for s in shapes if s is not None])


def area_stitches(region: Region, start: Place, end: Place) -> list[Stitches]:
    """Every polygon of an area, nearest first."""
    polygons = _split(sewn_area(region))
    made = []
    here = region.start or start
    while polygons:
        k = _nearest(polygons, here)
        made.append(polygon_stitches(region, polygons.pop(k), here, region.end or end))
        if len(made[-1]):
            here = (float(made[-1].xy[-1, 0]), float(made[-1].xy[-1, 1]))
    return [*made, *bordered(region, here)]


def bordered(region: Region, here: Place) -> list[Stitches]:
    """The satin border of a fill, along the inside of its edges; none where it is too narrow for one."""
    p = region.params
    if p.border <= 0 or region.stitch not in COVERED or region.stitch == "satin":
        return []
    inner = grown(region.paths, -p.border / 2, empty=True)
    made = []
    for ring in [] if inner is None else inner:
        made.append(stroke_stitches(from_stroke(from_nearest(ring, here), p.border), p, region.id, here))
    return [tidy(m, p.min_length) for m in made if len(m)]


def sewn_area(region: Region) -> Paths:
    """An area as it must be sewn to come out as drawn: rows by their own law; satin is lengthened stitch by stitch; lines that
    bend follow all directions, and grow on all sides."""
    if region.stitch in ROWS:
        return compensated(region)
    return (
        grown(region.paths, region.params.pull)
        if region.stitch in COVERED and region.stitch != "satin"
        else region.paths
    )


def polygon_stitches(region: Region, polygon: Paths, start: Place, end: Place) -> Stitches:
    """Underlay and fill of one connected polygon, without a jump."""
    p = region.params
    area = rings(polygon)
    parts = area_underlay(polygon, region, start) if region.stitch in COVERED else []
    if region.start is not None:  # the way from there lies below all the rest
        begin = nearest_on_outline(area, np.array(region.start))[2]
        parts.insert(0, Stitches.of(np.array([begin]), TRAVEL))
    leave = None if end is None else nearest_on_outline(area, np.array(end))[2]
    if leave is not None and parts and math.hypot(*(leave - np.array(end))) > p.trim and region.end is None:
        leave = None  # the thread is cut there all the same: a way to it would only lie below the rows
    if leave is not None and (parts or start is not None):
        # The fill begins, and so ends, at the place nearest to where the thread goes on; the way there lies below it.
        start = _place(leave)
    elif parts:
        start = _place(parts[-1].xy[-1])
    if region.stitch == "satin":
        satin, left = branched(polygon_of(area), p, region.id, start)
        rest = _rest(left, region, parts, satin)
        return tidy(linked([*rest, *satin], area, p), p.min_length)
    made = fill(region, polygon, area, start)
    if region.end is not None:
        made = _ending(made, region.end, lambda begin: fill(region, polygon, area, begin))
    parts.append(made)
    return tidy(linked(parts, area, p), p.min_length, area)


def _ending(made: Stitches, end: tuple[float, float], again: Callable[[Place], Stitches]) -> Stitches:
    """The thread of a fill that ends where a hand wants it: itself, from its other end, or begun on the other side."""
    if len(made) < 2:
        return made
    ways = [made]
    if not made.facts.get("hidden_mm", 0.0):  # turned about, ways that lay below rows would lie on them
        ways.append(made.reversed())
    x, y = made.xy.min(0) + made.xy.max(0) - np.array(end)
    ways.append(again((float(x), float(y))))
    return min(ways, key=lambda w: float(np.hypot(*(w.xy[-1] - np.array(end)))))


def _rest(left: Any, region: Region, below: list[Stitches], satin: list[Stitches]) -> list[Stitches]:
    """What satin leaves of an area, as tatami below it; the whole area's underlay only when it is all tatami."""
    from tambour.geometry.areas import of_shapely, to_shapely

    rest = None if left.is_empty else of_shapely(left)
    if rest is None:
        return []
    p = region.params
    angle = region.turn
    made = [] if satin else below
    for piece in _split(rest):
        fill = tatami(rings(piece, angle), angle, p.row_spacing, p.length, stagger=p.stagger, travel=p.travel)
        # Told only where satin was asked for.
        wide = sum(a.area for a in to_shapely(piece)) if p.stitch == "satin" else 0.0
        made.append(Stitches(fill.xy, fill.kind, fill.run, {**fill.facts, "not_satin_mm2": wide}))
    return made


def fill(region: Region, polygon: Paths, area: Rings, start: Place) -> Stitches:
    """The visible stitches of one connected polygon."""
    p = region.params
    angle, name = region.turn, region.stitch
    if name in ROWS:
        return rows_of(region, polygon, area, start)
    shape = polygon_of(area)
    if name == "meander":
        return grids.meander(shape, area, p.motif_size, p.length, f"{p.seed} {region.id}", start)
    if name == "cross":
        return grids.cross(shape, area, p.motif_size / 2, start)
    lines: list[Array]
    if name == "contour":
        lines = curves.contour(shape, p.row_spacing)
    elif name == "spiral":
        lines = curves.spiral(shape, p.row_spacing)
    elif name == "radial":
        lines = curves.radial(shape, p.row_spacing, p.seed)
    elif name == "guided":
        lines = curves.guided(shape, region.guide, p.row_spacing, angle)
    elif name == "flow":
        lines = flow(shape, p.row_spacing, region.guide, angle, f"{p.seed} {region.id}")
    elif name == "ripple":
        lines = curves.ripple(shape, max(2, round(math.sqrt(shape.area) / 4)))
    else:
        raise AssertionError(name)
    return weave(lines, area, p.length, p.row_spacing, start=start, stagger=p.stagger, tolerance=0.05)


def rows_of(region: Region, polygon: Paths, area: Rings, start: Place) -> Stitches:
    """The rows of one connected polygon: of each part of what lies inside the run along its rim, if it has one."""
    if not rimmed(region):
        return filled(region, polygon, start)
    parts = _split(body(polygon, region))
    made: list[Stitches] = []
    here = start
    while parts:
        made.append(filled(region, parts.pop(_nearest(parts, here)), here))
        here = _last(made, here)
    return linked(made, area, region.params)


def area_underlay(polygon: Paths, region: Region, start: Place) -> list[Stitches]:
    """What lies below a fill: a run along its rim or outlines drawn in, and thin rows across the fill's."""
    p = region.params
    words = p.underlay.split("+")
    wide = 4 * 2 * p.row_spacing
    if "none" in words:
        return []
    made: list[Stitches] = []
    here = start
    under = rimmed(region)
    edge = grown(polygon, -p.thread / 2, empty=True) if under else None
    for piece in [] if edge is None else _split(edge):
        made.append(rim(piece, region, here))
        here = _last(made, here)
    drawn = RIMMED if under else min(0.5, 1.25 * p.row_spacing)
    inner = grown(polygon, -drawn - max(p.pull, 0.0), empty=True)
    if inner is None:
        return made
    for piece in _split(inner):
        broad = float(np.ptp(piece.coords, axis=0).min()) > wide
        if "edge" in words or ("auto" in words and broad and not under):
            made.append(weave(list(piece), rings(piece), min(p.length, 2.5), 1.0, kind=UNDERLAY, start=here, stagger=1))
            here = _last(made, here)
        if "tatami" in words or "zigzag" in words or ("auto" in words and broad):
            across = math.radians((p.angle or 0.0) + 90)
            # The edge walk holds narrow places; rows there would be all ends, and ways between them.
            body = piece if words == ["tatami"] else opened(piece, NARROW)
            for part in [] if body is None else _split(body):
                made.append(
                    tatami(
                        rings(part, across),
                        across,
                        3 * p.row_spacing,
                        p.length,
                        stagger=p.stagger,
                        start=here,
                        kind=UNDERLAY,
                    )
                )
                here = _last(made, here)
    return [m for m in made if len(m)]


def _last(made: list[Stitches], here: Place) -> Place:
    return _place(made[-1].xy[-1]) if made and len(made[-1]) else here


def _place(point: Array) -> Place:
    return float(point[0]), float(point[1])


def linked(parts: list[Stitches], area: Rings, p: EmbroideryParams) -> Stitches:
    """Threads of one area as one, with ways between them that stay inside."""
    made: list[Stitches] = []
    for part in parts:
        if not len(part):
            continue
        if made:
            a, b = made[-1].xy[-1], part.xy[0]
            away = float(np.hypot(*(b - a)))
            if away > 1e-9:
                line = way(area, a, b, p.pull)
                link = line_stitches(line, p.length, TRAVEL, 0.04)
                mm = float(np.hypot(*np.diff(line, axis=0).T).sum())
                made.append(Stitches(link.xy[1:], link.kind[1:], link.run[1:], {"connector_mm": mm}))
            part = Stitches(part.xy[1:], part.kind[1:], part.run[1:], part.facts)
        if len(part):  # a thread of one needle point is in the way that leads to it
            made.append(part)
    return join(made)


def grown(area: Paths, by: float, empty: bool = False) -> Any:
    """An area grown (or shrunk) on all sides; where nothing stays, the area itself, or None if ``empty``."""
    if by == 0:
        return area
    import shapely

    from tambour.geometry.areas import of_shapely, to_shapely

    made = of_shapely(shapely.union_all([a.buffer(by, join_style="mitre", mitre_limit=2) for a in to_shapely(area)]))
    return (None if empty else area) if made is None else made


def opened(area: Paths, width: float) -> Paths | None:
    """An area without what is narrower than ``width``; None where it is so everywhere."""
    import shapely

    from tambour.geometry.areas import of_shapely, to_shapely

    shape = shapely.union_all(to_shapely(area))
    body = shape.buffer(-width / 2, quad_segs=4)
    return of_shapely(body.buffer(width / 2, quad_segs=4).intersection(shape))


def polygon_parts(polygon: Paths) -> Paths:
    """The rings of one polygon as Paths with parts."""
    return Paths(polygon.coords, polygon.offsets, np.array([0, len(polygon)]))


def _split(area: Paths) -> list[Paths]:
    assert area.parts is not None
    found = []
    for a, b in zip(area.parts[:-1].tolist(), area.parts[1:].tolist()):
        found.append(polygon_parts(Paths.of([area[i] for i in range(a, b)])))
    return found


def _nearest(polygons: list[Paths], here: Place) -> int:
    if here is None:
        return 0
    return int(np.argmin([((p.coords - np.array(here)) ** 2).sum(1).min() for p in polygons]))

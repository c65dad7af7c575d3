"""Drawn: areas that are lines of one width, as programs make them of strokes, become lines again, and are sewn as lines are."""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from tambour.core.check import Array
from tambour.core.paths import Paths
from tambour.embroidery.columns.medial import branches, skeleton
from tambour.embroidery.piece import AUTO, Region
from tambour.embroidery.regions.flat import shape
from tambour.geometry.areas import of_shapely, to_shapely

LEAST = 1.2
"""mm: thinner lines are as well sewn as areas."""
EVEN = 0.08
"""Share by which a line's half width may differ from place to place."""
MOSTLY = 0.6
"""Share of its middle line where an area must be as wide as that."""
BULGE = 0.04
"""Share above its half width where the middle line of a corner or of a fork begins to lean."""
PEAK = 0.1
"""Share above its half width that a corner's middle reaches at least: less is a line that is not quite even."""
LEANS = 0.4
"""Half widths before that place where it surely does not."""
TRUE = 0.08
"""mm that the lines' edge may lie beside the area's, at most (four per cent of the width, where that is more)."""
LONG = 4.6
"""Square of half its outline's length by its area that an area must have to be a line: that of one thrice as long as wide."""


def drawn(found: Sequence[Region]) -> tuple[Region, ...]:
    """The regions, areas that are lines of one width as lines; only where nobody said how the area is sewn."""
    asked = [r for r in found if _may(r)]
    if not asked:
        return tuple(found)
    from shapely import union_all

    of_color: dict[tuple[int, int, int], list[Any]] = {}
    for region in found:
        of_color.setdefault(region.color, []).append(shape(region))
    around = {color: union_all(of_color[color]) for color in {r.color for r in asked}}
    made: list[Region] = []
    for region in found:
        made += _as_lines(region, around[region.color]) if _may(region) else [region]
    return tuple(made)


def _may(region: Region) -> bool:
    p = region.params
    free = region.role == "area" and region.stitch == AUTO and region.rank is None and region.alpha >= 1
    return (
        free and not region.flags and region.start is None and region.end is None and not (p.applique or p.border > 0)
    )


def _as_lines(region: Region, around: Any) -> list[Region]:
    """One region for each kind of lines of an area, and one for what is no line; ``around`` : what is of its colour."""
    from shapely import GeometryCollection

    kinds: dict[tuple[float, int, int], list[Array]] = {}
    left = []
    for polygon in to_shapely(region.paths):
        found = lines_of(polygon, around) if polygon.length > LONG * LEAST else None
        if found is None or found[1] < max(LEAST, region.params.satin_from) or found[1] > region.params.split:
            left.append(polygon)
            continue
        lines, width, cap, join = found
        like = next((k for k in kinds if k[1:] == (cap, join) and abs(k[0] - width) < 0.03 * width), (width, cap, join))
        kinds.setdefault(like, []).extend(lines)
    if not kinds:
        return [region]
    made = []
    if left and (rest := of_shapely(GeometryCollection(left))) is not None:
        made.append(replace(region, paths=rest))
    for (width, cap, join), lines in kinds.items():
        name = region.id if not made else f"{region.id} ({len(made) + 1})"
        kind = {"role": "line", "stitch": "satin", "width": width, "cap": cap, "join": join}
        made.append(replace(region, id=name, paths=Paths.of(lines), **kind))  # type: ignore[arg-type]
    return made


def lines_of(area: Any, around: Any = None) -> tuple[list[Array], float, int, int] | None:
    """The lines of a shapely polygon, their width (mm), cap and join (as in Styles); None where it is not made of lines of
    one width. Lines that meet at a fork share a place there. ``around`` : an area of the same colour that holds it, below
    which ends may go on that are cut off there."""
    import shapely

    if (area.length / 2) ** 2 < LONG * area.area:
        return None
    places, radius, edges = skeleton(area)
    limbs = branches(places, radius, edges) if len(places) > 1 else []
    if not limbs:
        return None
    half = _half(limbs, places, radius)
    if half is None:
        return None
    ends: dict[int, list[tuple[int, bool]]] = {}
    lines: list[Array] = []
    free: list[tuple[int, bool]] = []
    tips: dict[int, Array] = {}
    for path, free_start, free_end in limbs:
        line = _limb(
            places[path], radius[path], half, bool(path[0] == path[-1] and len(path) > 3), free_start, free_end
        )
        if line is None and free_start != free_end and len(limbs) > 1:  # lines run together into an acute corner
            tip, fork = (path[0], path[-1]) if free_start else (path[-1], path[0])
            if radius[tip] > 0.9 * half:  # of a round corner; a sharp one lies where both lead
                tips[int(fork)] = places[tip]
            continue
        if line is None:
            return None
        for last, open_end in ((False, free_start), (True, free_end)):
            if open_end:
                free.append((len(lines), last))
            elif (line[0] != line[-1]).any():
                ends.setdefault(int(path[-1 if last else 0]), []).append((len(lines), last))
        lines.append(line)
    for fork, here in ends.items():
        if fork in tips and len(here) == 2:
            for k, last in here:
                on = _curve(lines[k], last, tips[fork], half)
                lines[k] = np.concatenate([lines[k], on] if last else [on[::-1], lines[k]])
            continue
        _meet(lines, here, places[fork], half)
    flat = [_flat(area, lines[k], last, half) for k, last in free]
    cap = 1 if flat and all(flat) else 0
    for (k, last), cut in zip(free, flat):
        if cut:  # where others are round it is cut off below something else
            lines[k] = _longer(lines[k], last, half if cap == 1 else 1.3 * half)
    lines = [shapely.get_coordinates(shapely.simplify(shapely.LineString(line), 0.02)) for line in lines]
    away = max(TRUE, 0.08 * half)
    for join in (0, 1):
        style = {"cap_style": "round" if cap == 0 else "flat", "join_style": "round" if join == 0 else "mitre"}
        again = shapely.union_all([_buffered(line, half, style) for line in lines])
        off = shapely.union(area.difference(again), again.difference(area if around is None else around))
        if off.buffer(-away / 2).area < 0.01 * half**2:
            return lines, 2 * half, cap, join
    return None


def _buffered(line: Array, half: float, style: dict[str, str]) -> Any:
    import shapely

    shape = shapely.LinearRing(line) if len(line) > 3 and (line[0] == line[-1]).all() else shapely.LineString(line)
    return shape.buffer(half, quad_segs=16, **style)


def _half(limbs: Sequence[tuple[Array, bool, bool]], places: Array, radius: Array) -> float | None:
    """Half the width that most of a middle line has; None where it has none."""
    pieces = [
        np.c_[(radius[path[:-1]] + radius[path[1:]]) / 2, np.hypot(*np.diff(places[path], axis=0).T)]
        for path, _, _ in limbs
    ]
    found = np.concatenate(pieces)
    found = found[np.argsort(found[:, 0], kind="stable")]
    total = np.cumsum(found[:, 1])
    half = float(found[np.searchsorted(total, total[-1] / 2), 0])
    same = float(found[np.abs(found[:, 0] - half) < EVEN * half, 1].sum())
    return half if same > MOSTLY * total[-1] else None


def _limb(line: Array, radius: Array, half: float, ring: bool, free_start: bool, free_end: bool) -> Array | None:
    """One limb's middle line without what leans towards corners and forks, corners put back where both sides lead."""
    if ring:  # begun where it is straightest, so that no corner is cut in two
        k = int(np.argmin(_blurred(radius[:-1], half, line)))
        line, radius = np.r_[line[k:-1], line[: k + 1]], np.r_[radius[k:-1], radius[: k + 1]]
    way = np.r_[0, np.cumsum(np.hypot(*np.diff(line, axis=0).T))]
    leans = radius > (1 + BULGE) * half
    for a, b in _runs(leans):
        leans[a : b + 1] &= radius[a : b + 1].max() > (1 + PEAK) * half
    if not ring:
        leans[0] |= not free_start
        leans[-1] |= not free_end
    clear = np.ones(len(line), bool)
    for a, b in _runs(leans):
        clear &= (way < way[a] - LEANS * half) | (way > way[b] + LEANS * half)
    parts = [line[a : b + 1] for a, b in _runs(clear) if way[b] - way[a] > 0.3 * half]
    if not parts:
        return None
    made = parts[0]
    for part in parts[1:]:
        made = np.concatenate([made, _crossing(made, part, half), part])
    return np.concatenate([made, made[:1]]) if ring and (made[0] != made[-1]).any() else made


def _blurred(radius: Array, half: float, line: Array) -> Array:
    n = max(1, round(2 * half / max(1e-9, float(np.hypot(*np.diff(line, axis=0).T).mean()))))
    n = min(n, len(radius) // 2)
    around = np.r_[radius[len(radius) - n :], radius, radius[:n]]
    return np.array([around[k : k + 2 * n + 1].max() for k in range(len(radius))])


def _runs(mask: Array) -> list[tuple[int, int]]:
    """The first and last index of each run of True."""
    edge = np.flatnonzero(np.diff(np.r_[False, mask, False].astype(np.int8)))
    return [(int(a), int(b) - 1) for a, b in edge.reshape(-1, 2)]


def _out(line: Array, last: bool, half: float) -> Array:
    """The direction in which a line leaves its first or last place."""
    line = line[::-1] if last else line
    way = np.r_[0, np.cumsum(np.hypot(*np.diff(line, axis=0).T))]
    inner = np.array([np.interp(0.8 * half, way, line[:, i]) for i in (0, 1)])
    d = line[0] - inner
    return np.asarray(d / max(1e-12, float(np.hypot(*d))))


def _crossing(a: Array, b: Array, half: float) -> Array:
    """The place (1, 2) where a line's end and the next one's beginning lead to; none (0, 2) where they go straight on, or where
    that is far off."""
    u, v = _out(a, True, half), _out(b, False, half)
    cross = float(u[0] * v[1] - u[1] * v[0])
    if abs(cross) < 0.2:
        return np.zeros((0, 2))
    d = b[0] - a[-1]
    s, t = float(d[0] * v[1] - d[1] * v[0]) / cross, float(d[0] * u[1] - d[1] * u[0]) / cross
    if min(s, t) < 0 or max(s, t) > 8 * half:
        return np.zeros((0, 2))
    return (a[-1] + s * u)[None]


def _curve(line: Array, last: bool, to: Array, half: float) -> Array:
    """Places that lead a line on to another place, in its direction at first."""
    at = line[-1 if last else 0]
    turn = at + 0.5 * float(np.hypot(*(to - at))) * _out(line, last, half)
    t = np.linspace(0, 1, 9)[1:, None]
    return np.asarray((1 - t) ** 2 * at + 2 * t * (1 - t) * turn + t**2 * to)


def _meet(lines: list[Array], here: list[tuple[int, bool]], fork: Array, half: float) -> None:
    """Lead the lines that end at a fork there: the straightest pair to where both lead, others on to that line."""
    import shapely

    outs = {end: _out(lines[end[0]], end[1], half) for end in here}
    free = list(here)
    while len(free) > 1:
        one, two = min(itertools.combinations(free, 2), key=lambda pair: float(outs[pair[0]] @ outs[pair[1]]))
        if outs[one] @ outs[two] > math.cos(math.radians(30)) and len(free) < len(here):
            break
        a, b = (lines[k] if last else lines[k][::-1] for k, last in (one, two))
        at = _crossing(a, b[::-1], half)
        at = at[0] if len(at) else (a[-1] + b[-1]) / 2
        if len(free) == len(here):
            through = shapely.LineString([a[-1], at, b[-1]]) if (a[-1] != at).any() else None
            fork = at
        for k, last in (one, two):
            lines[k] = np.concatenate([lines[k], at[None]] if last else [at[None], lines[k]])
        free = [end for end in free if end not in (one, two)]
        if len(here) == 3:
            break
    for k, last in free:
        end = lines[k][-1 if last else 0]
        ray = shapely.LineString([end, end + 6 * half * outs[k, last]])
        met = shapely.get_coordinates(ray.intersection(through)) if len(here) > 1 and through is not None else []
        at = met[0] if len(met) else fork
        lines[k] = np.concatenate([lines[k], at[None]] if last else [at[None], lines[k]])


def _flat(area: Any, line: Array, last: bool, half: float) -> bool:
    """Whether a line's end is cut off straight, half a width beyond its middle line's."""
    import shapely

    out = _out(line, last, half)
    corners = [(line[-1] if last else line[0]) + 0.88 * half * (out + s * np.array([-out[1], out[0]])) for s in (1, -1)]
    return bool(shapely.contains_xy(area, np.array(corners)).all())


def _longer(line: Array, last: bool, by: float) -> Array:
    at = (line[-1] if last else line[0]) + by * _out(line, last, by)
    return np.concatenate([line, at[None]] if last else [at[None], line])

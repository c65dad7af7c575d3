"""Strung: lines of one thread that meet end to end become one line, so that a corner of two drawn lines is sewn as a corner."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from tambour.core.check import Array
from tambour.core.paths import Paths
from tambour.embroidery.piece import Region
from tambour.embroidery.regions.flat import shape

NEAR = 0.3
"""Widths: ends that lie no farther apart were meant to meet."""
LIKE = 0.03
"""Share by which the widths of lines may differ that become one."""
HAIRPIN = math.radians(150)
"""Lines that turn back by more at their ends are no corner: they lie side by side."""
BEND = math.radians(30)
"""Lines that turn by more are led on to where they cross."""
ABREAST = 0.15
"""Widths: how far beside a line another may run that ends side by side with it."""
LED = 1.0
"""Widths that an end is led on, to end side by side with another."""
LAID = 1.0
"""mm of a line that must lie below something else for it to have to stay there."""


def strung(found: Sequence[Region]) -> tuple[Region, ...]:
    """The regions with satin lines of one thread joined where their ends meet: of several ends at one place the straightest
    pair. A line that ends beside another's end, both running one way, and a little short of it is led on as far: the one
    that lies on top hides the other's end."""
    kinds: dict[Any, list[int]] = {}
    for k, region in enumerate(found):
        if _joins(region):
            key = (region.color, region.cap, region.join, region.flags, repr(region.params))
            kinds.setdefault(key, []).append(k)
    held = {k: list(found[k].paths) for ks in kinds.values() for k in ks}
    for ks in kinds.values():
        while ks:
            like = [k for k in ks if abs(found[k].width - found[ks[0]].width) <= LIKE * found[ks[0]].width]
            ks = [k for k in ks if k not in like]
            lines = [(k, line) for k in like for line in held[k]]
            lines = _led_on(_joined(lines, found[like[0]].width, found), found[like[0]].width)
            for k in like:
                held[k] = [line for at, line in lines if at == k]
    made = []
    for k, region in enumerate(found):
        if k not in held:
            made.append(region)
        elif held[k]:
            made.append(replace(region, paths=Paths.of(held[k])))
    return tuple(made)


def _joins(region: Region) -> bool:
    free = region.role == "line" and region.stitch == "satin" and region.rank is None and "whole" not in region.flags
    return free and region.start is None and region.end is None and all(len(line) > 1 for line in region.paths)


def _joined(lines: list[tuple[int, Array]], width: float, found: Sequence[Region]) -> list[tuple[int, Array]]:
    """Lines (region, places), those that meet end to end as one; it belongs to that region at whose place in the drawing's
    order nothing of another colour comes between it and what it lies on."""
    lines = list(lines)
    ends = _ends(lines, width)
    if len(ends) < 2:
        return lines
    from scipy.spatial import cKDTree

    spots = np.array([at for _, _, at, _ in ends])
    meets = []
    for i, j in sorted(cKDTree(spots).query_pairs(NEAR * width)):
        turn = _turn(ends[i][3], -ends[j][3])
        if turn <= HAIRPIN:
            # What a line closes by itself was drawn closed, however straight another goes on from there.
            other = ends[i][0] != ends[j][0]
            meets.append((other, round(turn, 6), round(float(np.hypot(*(spots[i] - spots[j]))), 6), i, j))
    whose = {(k, last): (k, last) for k, last, _, _ in ends}  # where each line's ends are now
    used: set[int] = set()
    gone: set[int] = set()
    for *_, i, j in sorted(meets):
        if i in used or j in used:
            continue
        (a, last_a), (b, last_b) = whose[ends[i][:2]], whose[ends[j][:2]]
        first = lines[a][1] if last_a else lines[a][1][::-1]
        second = lines[b][1][::-1] if last_b else lines[b][1]
        if a == b:
            if len(first) > 3:
                lines[a] = (lines[a][0], np.concatenate([lines[a][1][:-1], lines[a][1][:1]]))
                used |= {i, j}
            continue
        owner = _owner(lines[a], lines[b], found)
        if owner is None:
            continue
        used |= {i, j}
        gone.add(b)
        lines[a] = (owner, _corner(first, second, ends[i][3], ends[j][3], width))
        ends_of_a, ends_of_b = (a, not last_a), (b, not last_b)
        for key, now in list(whose.items()):
            if now == ends_of_a:
                whose[key] = (a, False)
            elif now == ends_of_b:
                whose[key] = (a, True)
    return [line for k, line in enumerate(lines) if k not in gone]


def _ends(lines: Sequence[tuple[int, Array]], width: float) -> list[tuple[int, bool, Array, Array]]:
    """The free ends of lines: (line, whether its last, place, direction out of it)."""
    made = []
    for k, (_, line) in enumerate(lines):
        if (line[0] != line[-1]).any():
            made += [(k, last, (line[-1] if last else line[0]), _heading(line, last, width)) for last in (False, True)]
    return made


def _heading(line: Array, last: bool, width: float) -> Array:
    """The direction (unit vector) in which a line comes out of one of its ends, over half its width."""
    line = line[::-1] if last else line
    way = np.r_[0, np.cumsum(np.hypot(*np.diff(line, axis=0).T))]
    inner = np.array([np.interp(width / 2, way, line[:, i]) for i in (0, 1)])
    out = line[0] - inner
    return np.asarray(out / max(1e-12, float(np.hypot(*out))))


def _turn(a: Array, b: Array) -> float:
    return float(abs(math.atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1])))


def _corner(first: Array, second: Array, out: Array, other: Array, width: float) -> Array:
    """One line from two: the second begins where the first ends, or where both lead."""
    p, q = first[-1], second[0]
    if float(np.hypot(*(p - q))) < 1e-6:
        return np.concatenate([first, second[1:]])
    at = (p + q) / 2
    cross = out[0] * other[1] - out[1] * other[0]
    if abs(cross) > math.sin(BEND):
        d = q - p
        s, t = (d[0] * other[1] - d[1] * other[0]) / cross, (d[0] * out[1] - d[1] * out[0]) / cross
        if max(abs(s), abs(t)) < width / 2:
            at = p + s * out
    return np.concatenate([_short(first, at)[:-1], [at], _short(second[::-1], at)[::-1][1:]])


def _short(line: Array, at: Array) -> Array:
    """A line without the places near its end that lie no farther from there than ``at`` does."""
    away = np.hypot(*(line - line[-1]).T)
    far = np.flatnonzero(away > float(np.hypot(*(at - line[-1]))))
    last = int(far[-1]) if len(far) else 0
    return np.concatenate([line[: last + 1], line[-1:]])


def _owner(a: tuple[int, Array], b: tuple[int, Array], found: Sequence[Region]) -> int | None:
    """The region to which the line of two belongs: the later one where nothing of another colour between them lies on the
    earlier; else the earlier one where the later lies on nothing of them; else none."""
    import shapely

    (first, one), (second, two) = sorted([a, b], key=lambda line: line[0])
    between = [r for r in found[first + 1 : second] if r.color != found[first].color]

    def meets(line: Array) -> bool:
        low, high = line.min(0), line.max(0)
        near = [r for r in between if (r.paths.coords.min(0) <= high).all() and (r.paths.coords.max(0) >= low).all()]
        way = shapely.LineString(line)
        return any(way.intersection(shape(r)).length > LAID for r in near)

    return second if not meets(one) else first if not meets(two) else None


def _led_on(lines: list[tuple[int, Array]], width: float) -> list[tuple[int, Array]]:
    """Lines of which one ends a little short of another that runs beside it the same way end side by side."""
    ends = _ends(lines, width)
    made = dict(enumerate(lines))
    for k, last, at, out in ends:
        far, way = 0.0, out
        for j, _, other, leads in ends:
            step = other - at
            along, aside = float(step @ out), abs(float(step[0] * out[1] - step[1] * out[0]))
            if (
                j != k
                and aside < ABREAST * width
                and _turn(out, leads) < math.pi - HAIRPIN
                and far < along < LED * width
            ):
                far, way = along, leads  # where that one leads: this one may come out of a bend
        if far > 0:
            owner, line = made[k]
            on = (at + far * way)[None]
            made[k] = (owner, np.concatenate([line, on] if last else [on, line]))
    return list(made.values())

"""Angles: where limbs of an area meet in a sharp corner, as a stem and its serif do, one is sewn through, others end below it."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from tambour.core.check import Array

Part = tuple[Array, bool, bool, list[int]]
"""A limb: its way over the skeleton, whether its first end is free, whether its last is, the forks that it passes."""

TURN = math.radians(55)
"""A limb that turns by less bends as a whole."""
BACK = math.radians(120)
"""A limb that turns by more turns back: the leg that went through would not reach the tip between both."""
VERTEX = math.radians(50)
"""An outline that turns by less has no corner there."""
GRAIN = 0.05
"""mm that an outline may be off when its corners are sought."""
INNER = 1.3
"""Radii from the bend within which its inner corner lies."""
OUTER = 2.3
"""Radii from the bend within which its outer corner lies."""
AHEAD = 0.5
"""Cosine of the angle to the bend's bisector within which its corners lie."""
FLAT = math.radians(8)
"""By how much less than most a limb may turn at a place that counts as the bend."""
LEG = 1.1
"""Radii beyond the bend that a leg must reach at least."""
WIDER = 1.4
"""Times as wide as all others at its fork that a limb must be to go through it alone."""
ALIKE = 0.12
"""Share by which legs' widths may differ for the longer one, and not the wider, to go through."""


def parted(joined: list[Part], places: Array, radius: Array, area: Any) -> list[Part]:
    """The limbs, those that bend at a sharp corner of a shapely polygon as two: one runs through to the outline and passes the
    bend as a fork, the other ends at it."""
    inner, outer = _corners(area)
    if not len(inner) or not len(outer):
        return joined
    made: list[Part] = []
    todo = _headed(joined, places, radius)
    while todo:
        part = todo.pop()
        path = part[0]
        bend = None if path[0] == path[-1] else _bend(path, places, radius, inner, outer)
        if bend is None:
            made.append(part)
        else:
            todo += _two(part, bend, places, radius)
    return made[::-1]


def _headed(joined: list[Part], places: Array, radius: Array) -> list[Part]:
    """The limbs; where three end at a fork that none goes through, the one that is far wider than the others there does."""
    made = list(joined)
    ends: dict[int, list[tuple[int, bool]]] = {}
    for k, (path, free_start, free_end, _) in enumerate(made):
        if path[0] != path[-1]:
            for last, free in ((False, free_start), (True, free_end)):
                if not free:
                    ends.setdefault(int(path[-1 if last else 0]), []).append((k, last))
    for fork, here in ends.items():
        wide = np.array([beside(made[k][0], last, places, radius) for k, last in here])
        one = int(wide.argmax())
        if len(here) != 3 or wide[one] < WIDER * np.delete(wide, one).max():
            continue
        k, last = here[one]
        path, free_start, free_end, forks = made[k]
        inside = np.flatnonzero(np.hypot(*(places[path] - places[fork]).T) > LEG * radius[fork])
        if len(inside) > 3:
            cut = path[: int(inside[-1]) + 1] if last else path[int(inside[0]) :]
            made[k] = (cut, free_start, True, [*forks, fork]) if last else (cut, True, free_end, [fork, *forks])
    return made


def beside(path: Array, last: bool, places: Array, radius: Array) -> float:
    """Half the width of a limb beside the fork at one of its ends."""
    path = path[::-1] if last else path
    away = np.hypot(*(places[path] - places[path[0]]).T)
    near = (away > 1.3 * radius[path[0]]) & (away < 2.5 * radius[path[0]])
    return float(np.median(radius[path][near])) if near.any() else float(radius[path[-1]])


def _corners(area: Any) -> tuple[Array, Array]:
    """The places of a shapely polygon's inner (reflex) and outer corners, (n, 2) each."""
    import shapely

    found: tuple[list[Array], list[Array]] = ([], [])
    for k, ring in enumerate((area.exterior, *area.interiors)):
        at = shapely.get_coordinates(ring.simplify(GRAIN))[:-1]
        at = at if shapely.LinearRing(at).is_ccw == (k == 0) else at[::-1]
        before, after = at - np.roll(at, 1, axis=0), np.roll(at, -1, axis=0) - at
        turn = np.arctan2(before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0], (before * after).sum(1))
        found[0].append(at[turn < -VERTEX])
        found[1].append(at[turn > VERTEX])
    return np.concatenate(found[0]), np.concatenate(found[1])


def _bend(path: Array, places: Array, radius: Array, inner: Array, outer: Array) -> int | None:
    """The index in a path where it turns sharply between an inner and an outer corner; None where it nowhere does."""
    line, wide = places[path], radius[path]
    way = np.r_[0, np.cumsum(np.hypot(*np.diff(line, axis=0).T))]
    found: list[tuple[int, float]] = []
    for k in range(1, len(path) - 1):
        reach = LEG * wide[k]
        if way[k] < reach or way[-1] - way[k] < reach:
            continue
        at = [
            np.array([np.interp(way[k] + d, way, line[:, i]) for i in (0, 1)])
            for d in (-2 * reach, -reach, reach, 2 * reach)
        ]
        one, two = at[1] - at[0], at[3] - at[2]
        if min(float(np.hypot(*one)), float(np.hypot(*two))) < 1e-9:
            one, two = line[k] - at[1], at[2] - line[k]
        turn = abs(math.atan2(one[0] * two[1] - one[1] * two[0], float(one @ two)))
        out = one / max(1e-9, float(np.hypot(*one))) - two / max(1e-9, float(np.hypot(*two)))
        if (
            turn > TURN
            and _faces(inner - line[k], -out, INNER * wide[k])
            and _faces(outer - line[k], out, OUTER * wide[k])
        ):
            found.append((k, turn))
    # It turns as much from a little before a bend to a little after it: the bend is the middle.
    turns = dict(found)
    while turns:
        most = max(turns, key=lambda k: turns[k])
        top, low, high = turns[most], most, most
        while turns.get(low - 1, 0.0) > top - FLAT:
            low -= 1
        while turns.get(high + 1, 0.0) > top - FLAT:
            high += 1
        if top < BACK:
            return (low + high) // 2
        reach = 2 * LEG * wide[most]
        turns = {k: t for k, t in turns.items() if abs(way[k] - way[most]) > reach}
    return None


def _faces(corners: Array, way: Array, near: float) -> bool:
    """Whether one of some places (n, 2) lies ``near`` and ahead in a direction (2,)."""
    far = np.hypot(*corners.T)
    ahead = corners @ way > AHEAD * far * float(np.hypot(*way))
    return bool((ahead & (far < near)).any())


def _two(part: Part, k: int, places: Array, radius: Array) -> list[Part]:
    """A limb that bends at an index of its path as two, the one that goes through cut off before it leans into the bend."""
    path, free_start, free_end, forks = part
    legs = [path[: k + 1][::-1], path[k:]]  # each from the bend on
    free = [free_start, free_end]
    ways = [np.r_[0, np.cumsum(np.hypot(*np.diff(places[leg], axis=0).T))] for leg in legs]
    wide = [
        float(np.median(radius[leg[way > min(float(radius[path[k]]), 0.5 * way[-1])]])) for leg, way in zip(legs, ways)
    ]
    if abs(wide[0] - wide[1]) < ALIKE * max(wide):
        on = int(ways[1][-1] > ways[0][-1])
    else:
        on = int(wide[1] > wide[0])
    first = int(np.argmax(ways[on] > LEG * radius[path[k]]))
    # A fork at which the limb was cut off before lies on neither leg, but near the end of one.
    at = {f: int(np.argmin([np.hypot(*(places[leg] - places[f]).T).min() for leg in legs])) for f in forks}
    passed = [[f for f in forks[:: 1 if leg else -1] if at[f] == leg] for leg in (on, 1 - on)]
    return [
        (legs[on][first:], True, free[on], [int(path[k]), *passed[0]]),
        (legs[1 - on], False, free[1 - on], passed[1]),
    ]

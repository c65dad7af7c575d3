"""Ends: how the column of a line ends: in a cap, or at a corner, where it meets the next one."""

from __future__ import annotations

import itertools
import math

import numpy as np

from tambour.core.check import Array
from tambour.embroidery.columns.satin import STEP, Column

CORNER = math.radians(50)  # a line that turns by more is sewn as two columns
SHARP = math.radians(105)  # a corner that turns by more leaves no room for a mitre
NEAR = 0.15  # widths before and after a vertex between which its turn is measured
BENT = 0.2  # half widths that a line may leave its direction where it is cut off at a corner's bisector
TIGHT = 0.8  # half widths: lines that turn round with a smaller radius turn at a corner
HAIRPIN = math.radians(150)  # at a corner that turns by more, columns that end at its bisector taper for too long
TIP = 0.4  # mm: half of the shortest stitch of a round end, as far as three tenths of its width are not less
LAP = 0.2  # mm that a column goes on beyond the bisector of a corner
TIP_LAP = 0.6  # mm that it does so, at most, at the corner's outside, where both columns taper to nothing and would leave a nick


def sharpened(line: Array, half: float) -> tuple[Array, dict[tuple[float, float], float]]:
    """The line with a corner in place of each turn between two straight legs that is tighter than ``TIGHT`` half widths, where
    stitches would fan out from one place; and the radius of the turn for each of these corners."""
    step = np.diff(line, axis=0)
    size = np.hypot(*step.T)
    long = np.flatnonzero(size >= half)
    made: list[Array] = [line[: int(long[0]) + 1]] if len(long) else [line]
    rounds: dict[tuple[float, float], float] = {}
    for a, b in itertools.pairwise(long.tolist()):
        between = line[a + 1 : b + 1]
        u, v = step[a] / size[a], step[b] / size[b]
        turn = math.atan2(u[0] * v[1] - u[1] * v[0], float(u @ v))
        sharp = CORNER < abs(turn) < HAIRPIN
        if sharp and b > a + 1:
            way = between[-1] - between[0]
            along, on = ((way[0] * e[1] - way[1] * e[0]) / math.sin(turn) for e in (v, -u))
            near = min(along, on)
            radius = near / math.tan(abs(turn) / 2)
            # Legs must reach as far as the bisector does across the line, and the turn be one round, not a jog.
            reach = half * math.tan(abs(turn) / 2)
            if (
                near > 0
                and max(along, on) < 1.3 * near
                and radius < TIGHT * half
                and min(size[a] + along, size[b] + on) > reach
            ):
                corner = between[0] + along * u
                rounds[float(corner[0]), float(corner[1])] = float(radius)
                between = corner[None]
        made.append(between)
    if len(long):
        made.append(line[int(long[-1]) + 1 :])
    return np.concatenate(made), rounds


def turns_of(line: Array, width: float, closed: bool) -> Array:
    """By how much the line turns at each vertex (radians), seen from a little before it to a little after."""
    way = np.r_[0, np.cumsum(np.hypot(*np.diff(line, axis=0).T))]
    if closed:
        line, at = np.concatenate([line[:-1], line, line[1:]]), np.r_[way[:-1] - way[-1], way, way[1:] + way[-1]]
    else:
        at = way
    here, before, after = (
        np.c_[np.interp(way + d, at, line[:, 0]), np.interp(way + d, at, line[:, 1])]
        for d in (0.0, -NEAR * width, NEAR * width)
    )
    (a, b), (c, d) = (here - before).T, (after - here).T
    return np.arctan2(a * d - b * c, a * c + b * d)


def corners_of(line: Array, turns: Array, width: float, closed: bool) -> list[int]:
    """The vertices at which the line turns by more than ``CORNER``; of several close together the sharpest."""
    way = np.r_[0, np.cumsum(np.hypot(*np.diff(line, axis=0).T))]
    found: list[int] = []
    for k in np.flatnonzero(np.abs(turns) > CORNER).tolist():
        if (k == len(line) - 1) if closed else not 0.25 * width < way[k] < way[-1] - 0.25 * width:
            continue
        if found and way[k] - way[found[-1]] < 0.3 * width:
            found[-1] = max(found[-1], k, key=lambda j: abs(turns[j]))
        else:
            found.append(k)
    if closed and len(found) > 1 and way[-1] - way[found[-1]] + way[found[0]] < 0.3 * width:
        found.remove(min(found[0], found[-1], key=lambda j: abs(turns[j])))
    return found


def cornered(
    column: Column, line: Array, after: Array, half: float, turn: float, join: int, radius: float = 0.0
) -> Column:
    """The column of a line with its end made to meet that of the line ``after`` it: slanted; at a sharp or a round corner cut
    off at the bisector, or where there is no room for that rounded over the other. ``radius`` : of a line that turns round."""
    if abs(turn) > SHARP or (turn and (join == 0 or radius > 0)):
        legs = _legs(line[::-1], after, half)
        if legs is None:
            return ended([column], half, 0, starts=False)[0]
        return _bisected(column, line[-1], *legs, half, radius)
    return _mitred(column, half, turn)


def _legs(back: Array, on: Array, half: float) -> tuple[Array, Array] | None:
    """The directions (unit vectors) in which a line comes to a corner and leaves it, from the line back and on from there;
    None where one of them is too short or too bent to be parted from the other at the bisector."""
    ways = [np.r_[0, np.cumsum(np.hypot(*np.diff(leg, axis=0).T))] for leg in (back, on)]

    def point(k: int, far: float) -> Array:
        return np.array([np.interp(far, ways[k], (back, on)[k][:, i]) for i in (0, 1)]) - back[0]

    first, second = (point(k, min(half, ways[k][-1])) for k in (0, 1))
    heading, leaving = -first / max(1e-9, np.hypot(*first)), second / max(1e-9, np.hypot(*second))
    turn = math.acos(max(-1.0, min(1.0, float(heading @ leaving))))
    reach = half * math.tan(min(turn, HAIRPIN) / 2)
    if turn > HAIRPIN or min(ways[0][-1], ways[1][-1]) < reach:
        return None
    for k, along in ((0, heading), (1, leaving)):
        at = [point(k, f * reach) for f in (0.25, 0.5, 0.75, 1)]
        if max(abs(float(along[0] * p[1] - along[1] * p[0])) for p in at) > BENT * half:
            return None
    return heading, leaving


def _bisected(
    column: Column, vertex: Array, heading: Array, leaving: Array, half: float, radius: float = 0.0
) -> Column:
    """The column with its end cut off ``LAP`` mm beyond the bisector of a corner: the outer ends of its stitches lie on the
    round corner as it is drawn, the inner ones on the bisector, so that the two columns of a corner do not lie double.
    ``radius`` : with which the line itself turns there."""
    if radius > 0:  # the column goes straight as far as the turn, and the outline is round about the turn's middle
        back = radius * math.tan(math.acos(max(-1.0, min(1.0, float(heading @ leaving)))) / 2)
        middle = column.middle
        most = float(np.hypot(*np.diff(middle, axis=0).T).sum()) - back
        keep = max(3, int(np.searchsorted(np.cumsum(np.hypot(*np.diff(middle, axis=0).T)), most)))
        column = Column(column.left[:keep], column.right[:keep])
        vertex = vertex - back * heading
    normal = -(heading + leaving) / np.hypot(*(heading + leaving))
    outside = heading[0] * leaving[1] - heading[1] * leaving[0] < 0  # whether the left side is the outer one
    x = np.linspace(0, half + radius, max(3, math.ceil((half + radius) / STEP) + 1))[1:, None]
    aside = np.array([-heading[1], heading[0]])
    arc = (np.sqrt(np.maximum(0.0, (half + radius) ** 2 - x**2)) - radius) * aside
    left = np.concatenate([column.left, vertex + x * heading + (arc if outside else half * aside)])
    right = np.concatenate([column.right, vertex + x * heading - (half * aside if outside else arc)])
    outer, inner = (left, right) if outside else (right, left)
    vertex = vertex - radius * (aside if outside else -aside)  # the middle of the turn lies on the bisector
    along = (leaving - heading) / np.hypot(*(leaving - heading))  # on the bisector, to the corner's inside
    high, low = (
        (side - vertex) @ normal
        + LAP
        + (max(LAP, min(TIP_LAP, 0.05 + 0.25 * half)) - LAP) * np.clip(-((side - vertex) @ along) / half, 0, 1) ** 4
        for side in (outer, inner)
    )
    whole = np.flatnonzero((low >= 0) & (high >= 0))
    # A bent leg may run along the bisector, or come back across it: only so much of its end is cut off as a straight one's.
    reach = half * math.hypot(*(heading - leaving)) / max(1e-9, math.hypot(*(heading + leaving))) + 3 * LAP
    start = max(0, len(column.left) - math.ceil(reach / STEP), int(whole[-1]) + 1 if len(whole) else 0)
    share = np.clip(high[start:] / np.maximum(1e-9, high[start:] - low[start:]), 0, 1)[:, None]
    inner = np.concatenate([inner[:start], outer[start:] + share * (inner[start:] - outer[start:])])
    thin = (high < 0) | (np.hypot(*(outer - inner).T) < 2 * LAP)
    thin[:start] = False
    end = int(np.argmax(thin)) if thin.any() else len(thin)
    if end < 3:
        return column
    outer, inner = outer[:end], inner[:end]
    return Column(outer, inner) if outside else Column(inner, outer)


def ended(columns: list[Column], half: float, cap: int, starts: bool = True) -> list[Column]:
    """Columns of an open line with its ends as its caps say (as in Styles): longer by half the width, and rounded or not;
    its start only if ``starts``."""
    if cap == 1 or not columns:
        return columns
    made = list(columns)
    for last in (True, False) if starts else (True,):
        column = made[-1] if last else made[0].reversed()
        step = column.middle[-1] - column.middle[max(0, len(column.left) - 4)]
        ahead = step / max(1e-9, float(np.hypot(*step)))
        tip = min(0.3, TIP / half) if cap == 0 else 0.0
        s = np.linspace(0, 1, max(3, math.ceil((1.5 if cap == 0 else 1) * half / STEP) + 1))[1:, None]
        s, wide = (np.sin(s * math.acos(tip)), np.cos(s * math.acos(tip))) if cap == 0 else (s, np.ones_like(s))
        middle, side = column.middle[-1] + half * s * ahead, (column.left[-1] - column.right[-1]) / 2
        column = Column(
            np.concatenate([column.left, middle + wide * side]), np.concatenate([column.right, middle - wide * side])
        )
        made[-1 if last else 0] = column if last else column.reversed()
    return made


def _mitred(column: Column, half: float, turn: float) -> Column:
    """The column with its end slanted to meet the next one after a turn (radians, positive towards ``left``)."""
    if turn == 0:
        return column
    slant = math.copysign(min(abs(math.tan(turn / 2)), 1.2) * half, turn)
    middle = column.middle
    way = np.r_[0, np.cumsum(np.hypot(*np.diff(middle, axis=0).T))]
    zone = min(3 * half, 0.5 * way[-1])
    share = np.clip(1 - (way[-1] - way) / max(zone, 1e-9), 0, 1)[:, None] ** 2
    ahead = np.gradient(middle, axis=0)
    ahead /= np.maximum(np.hypot(*ahead.T)[:, None], 1e-12)
    return Column(column.left - slant * share * ahead, column.right + slant * share * ahead)

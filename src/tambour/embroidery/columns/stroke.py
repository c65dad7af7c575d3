"""Strokes: lines with a width as satin columns: bends, corners, caps, and where one line meets another."""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from tambour.core.check import Array
from tambour.embroidery.columns.ends import CORNER, cornered, corners_of, sharpened, turns_of
from tambour.embroidery.columns.satin import (
    STEP,
    Column,
    center_walk,
    resample,
    side_to_side,
    side_walk,
    underlays,
    zigzag_walk,
)
from tambour.embroidery.params import EmbroideryParams
from tambour.embroidery.stitches import Stitches, chain

SMALL = 0.12  # widths: what is smaller in a line is no part of its shape
CLOSED = 0.25  # widths: ends that lie no farther apart were meant to meet
KEPT = 0.4  # mm that a column goes on below another that hides its end


def from_stroke(line: Array, width: float, join: int = 1) -> list[Column]:
    """Columns of a line with a width: one, or several where the line turns by more than 50° at a corner.

    ``join`` : how corners are drawn, as in Styles: round ones are rounded, the others meet in a mitre. Either way the
    columns part at the corner's bisector, where both sides have room for that.

    What is smaller than a tenth of the width (hooks and jogs that drawing programs leave in their paths) is no corner.
    Along a bend the inner side is kept from folding over itself: where the bend's radius is below half the width the
    inner points stay at its centre.
    """
    line = _smoothed(line, width)
    if len(line) < 2:
        return []
    line, rounds = sharpened(line, width / 2)
    loop = bool((line[0] == line[-1]).all())
    turns = turns_of(line, width, loop)
    corners = corners_of(line, turns, width, loop)
    ring = loop and not corners
    if loop and corners:
        line = np.concatenate([line[corners[0] : -1], line[: corners[0] + 1]])
        turns = np.r_[turns[corners[0] : -1], turns[: corners[0] + 1]]
        corners = [c - corners[0] for c in corners[1:]]
    else:
        turns[[0, -1]] = 0.0  # an open end meets nothing
    if ring:
        return [_swept(line, width / 2, True)]
    bounds = [0, *corners, len(line) - 1]
    parts = [line[a : b + 1] for a, b in itertools.pairwise(bounds)]
    made = []
    for k, part in enumerate(parts):
        before, after = parts[k - 1][::-1], parts[(k + 1) % len(parts)]
        first, last = (rounds.get((float(p[0]), float(p[1])), 0.0) for p in (part[0], part[-1]))
        column = _swept(part, width / 2, False)
        column = cornered(column, part, after, width / 2, float(turns[bounds[k + 1]]), join, last)
        back = cornered(column.reversed(), part[::-1], before, width / 2, -float(turns[bounds[k]]), join, first)
        made.append(back.reversed())
    return made


def closed(line: Array, width: float) -> bool:
    """Whether a line of a width ends where it begins, or all but."""
    line = _smoothed(line, width)
    return len(line) > 2 and bool((line[0] == line[-1]).all())


def _smoothed(line: Array, width: float) -> Array:
    """The line without vertices that lie nearer than ``SMALL`` widths to the one before, without hooks at its ends; closed
    where the ends all but meet."""
    keep = [0]
    for k in range(1, len(line)):
        if math.hypot(*(line[k] - line[keep[-1]])) > SMALL * width:
            keep.append(k)
    if keep[-1] != len(line) - 1:
        keep[-1 if len(keep) > 1 else 1 :] = [len(line) - 1]
    line = line[keep]
    while len(line) > 2 and (line[0] != line[-1]).any() and _hooked(line[:3], width):
        line = line[1:]
    while len(line) > 2 and (line[0] != line[-1]).any() and _hooked(line[:-4:-1], width):
        line = line[:-1]
    if len(line) > 3 and 0 < math.hypot(*(line[-1] - line[0])) < CLOSED * width:
        line = np.concatenate([line[:-1], line[:1]])
    return line if (line[1:] != line[:-1]).any() else line[:1]


def _hooked(three: Array, width: float) -> bool:
    """Whether a line begins with a step of less than a quarter of its width and then turns sharply."""
    (a, b), (c, d) = three[1] - three[0], three[2] - three[1]
    return math.hypot(a, b) < 0.25 * width and abs(math.atan2(a * d - b * c, a * c + b * d)) > CORNER


def _swept(line: Array, half: float, closed: bool) -> Column:
    size = float(np.hypot(*np.diff(line, axis=0).T).sum())
    n = max(3, math.ceil(size / STEP) + 1)
    p = resample(line, n)
    d = np.diff(p, axis=0)
    heading = np.unwrap(np.arctan2(d[:, 1], d[:, 0]))
    # Directions are averaged over half a width, so that a polyline's kinks become bends.
    reach = max(1, int(0.5 * half / (size / (n - 1))))
    window = np.hanning(2 * reach + 3)[1:-1]
    window /= window.sum()
    if closed:
        turn = heading[-1] - heading[0] + _wrapped(heading[0] - heading[-1])
        padded = np.concatenate([heading[-reach:] - turn, heading, heading[:reach] + turn])
    else:
        padded = np.concatenate([np.full(reach, heading[0]), heading, np.full(reach, heading[-1])])
    smooth = np.convolve(padded, window, "valid")
    at = np.r_[smooth[0], (smooth[:-1] + smooth[1:]) / 2, smooth[-1]]
    if closed:
        at[0] = at[-1] = (smooth[0] + smooth[-1] - (smooth[-1] - smooth[0] - _wrapped(smooth[-1] - smooth[0]))) / 2
        at[-1] = at[0] + (smooth[-1] - smooth[0] - _wrapped(smooth[-1] - smooth[0]))
    bend = np.gradient(at) / (size / (n - 1))
    normal = np.c_[-np.sin(at), np.cos(at)]
    inner = np.minimum(half, 1 / np.maximum(np.abs(bend), 1e-9))
    to_left = np.where(bend > 0, inner, half)[:, None]
    to_right = np.where(bend < 0, inner, half)[:, None]
    return Column(p + to_left * normal, p - to_right * normal)


def _wrapped(angle: float) -> float:
    return (angle + math.pi) % (2 * math.pi) - math.pi


def covered(column: Column) -> Any:
    """The shapely area that a column of even width surely covers: its ends as round ones, inside it."""
    import shapely

    wide = np.hypot(*(column.left - column.right).T)
    width = float(np.median(wide))
    full = np.flatnonzero(wide > 0.999 * width)
    first, last = int(full[0]), int(full[-1])
    cut: list[Any] = []
    if last > first:
        for end in (column, column.reversed()):
            k = last if end is column else len(wide) - 1 - first
            aside = end.left[k] - end.right[k]
            if np.abs((end.middle[k:] - end.middle[k]) @ aside).max() > 0.2 * (aside @ aside):
                # Cut off at a corner's bisector: what narrows leaves the middle line.
                k = max(0, k - round(width / 2 / STEP))
                tip = shapely.Polygon(np.concatenate([end.left[k:], end.right[k:][::-1]]))
                cut += [tip] if tip.is_valid else []
                first, last = (first, k) if end is column else (max(first, len(wide) - 1 - k), last)
        # An end that does not narrow is cut off straight: its corners lie outside a round one.
        inset = max(1, round(width / 2 / STEP))
        first += inset * (first == 0)
        last -= inset * (last == len(wide) - 1)
    core = column.middle[first : last + 1]
    return shapely.union_all([*cut, shapely.LineString(core).buffer(width / 2, quad_segs=8)] if len(core) > 1 else cut)


def trimmed(column: Column, over: Any) -> Column | None:
    """The column without those parts of its ends that lie wholly below ``over`` (a shapely area that the same thread covers
    later), but for ``KEPT`` mm; None where nothing else is left of it."""
    if over.is_empty:
        return column
    import shapely

    near = over.buffer(0.05)
    shapely.prepare(near)
    for _ in range(2):
        hidden = shapely.covers(near, shapely.linestrings(np.stack([column.left, column.right], axis=1)[::-1]))
        gone = len(hidden) if hidden.all() else int(np.argmin(hidden))
        if gone == len(hidden):
            return None
        keep = len(column.left) - max(0, gone - round(KEPT / STEP))
        if keep < 3:
            return None
        column = Column(column.left[:keep], column.right[:keep]).reversed()
    return column


def satin_below(column: Column, params: EmbroideryParams, name: str, over: Any) -> Stitches:
    """The satin of a column as far as ``over`` (a shapely area that the same thread covers later) does not hide it: a
    stitch with one end more than ``KEPT`` mm below its edge ends there, those that lie wholly deeper are left out."""
    import shapely

    made = side_to_side(column, params, name)
    deep = over.buffer(-KEPT)
    if deep.is_empty or len(made) < 3:
        return made
    shapely.prepare(deep)
    xy = made.xy.copy()
    inside = shapely.covers(deep, shapely.points(xy))
    if not inside.any():
        return made
    hidden = shapely.covers(deep, shapely.linestrings(np.stack([xy[:-1], xy[1:]], axis=1)))
    gone = inside & np.r_[True, hidden] & np.r_[hidden, True]
    edge = deep.boundary
    for k in np.flatnonzero(inside & ~gone).tolist():
        for other in (k + 1, k - 1):
            if 0 <= other < len(xy) and not inside[other]:
                met = shapely.get_coordinates(shapely.intersection(edge, shapely.LineString(made.xy[[k, other]])))
                if len(met):
                    xy[k] = met[np.argmin(((met - xy[k]) ** 2).sum(1))]
                break
    return Stitches(xy[~gone], made.kind[~gone], made.run[~gone], made.facts)


def stroke_stitches(
    columns: Sequence[Column], params: EmbroideryParams, name: str, start: Any = None, over: Any = None
) -> Stitches:
    """Underlay and satin of the columns of one line, one thread: what runs one way along all of them is followed by what
    runs back. ``over`` is what the same thread covers later: columns end a little below it."""
    import shapely

    columns = list(columns)
    if start is not None and columns:
        begin, end = (float(np.hypot(*(p - np.array(start)))) for p in (columns[0].middle[0], columns[-1].middle[-1]))
        if end < begin:
            columns = [c.reversed() for c in columns[::-1]]
    words = underlays(columns[0], params.underlay) if columns else []
    back = sum(word != "edge" for word in words) % 2 == 1  # the satin is sewn from the last column to the first
    later = shapely.Polygon() if over is None else over
    left: list[tuple[Column, Any]] = []
    for column in columns if back else columns[::-1]:
        kept = trimmed(column, later)
        if kept is not None:
            left.append((kept, later))
        if len(columns) > 1:
            later = shapely.union(later, covered(column))
    left = left if back else left[::-1]
    columns = [column for column, _ in left]
    parts: list[Stitches] = []
    there = True
    for word in words:
        run = columns if there else [c.reversed() for c in columns[::-1]]
        if word == "edge":
            parts += [side_walk(c, params) for c in run]
            parts += [side_walk(c.reversed(), params) for c in run[::-1]]
        else:
            parts += [center_walk(c, params) if word == "center" else zigzag_walk(c, params) for c in run]
            there = not there
    for column, later in left if there else left[::-1]:
        parts.append(satin_below(column if there else column.reversed(), params, name, later))
    return chain(parts, params.length)

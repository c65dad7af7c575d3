"""Satin columns: thread from side to side between two rails, close together."""

from __future__ import annotations

import itertools
import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from tambour.core.arrays import F8x2
from tambour.core.check import Array
from tambour.core.kernels import inner, kernel
from tambour.embroidery.fabric import MOST
from tambour.embroidery.params import EmbroideryParams
from tambour.embroidery.piece import RUNNING, SATIN, TRAVEL, UNDERLAY
from tambour.embroidery.stitches import Stitches, chain, line_stitches
from tambour.noise import key, uniform

CROWDED = 0.2  # mm: where stitches of a bend come closer than this, some of them end before the inner side
DRAWN = 0.45  # share of the width that they may end before it
EDGE_INSET = 0.4  # mm that underlay keeps from a column's edges
GOLDEN = (math.sqrt(5) - 1) / 2
SLANT = 0.4  # share of its way along a side that a column goes on at least, however far its stitches slant
STEP = 0.1  # mm between samples of a column


@dataclass(frozen=True, eq=False, slots=True)
class Column:
    """A satin column: ``left`` and ``right`` (n, 2), opposite points on its two sides, dense, from start to end."""

    left: Array
    right: Array

    @property
    def middle(self) -> Array:
        """The centre line (n, 2)."""
        return (self.left + self.right) / 2

    def reversed(self) -> Column:
        """The column from its other end."""
        return Column(np.ascontiguousarray(self.right[::-1]), np.ascontiguousarray(self.left[::-1]))


def resample(line: Array, n: int) -> Array:
    """``n`` points at even distance along a polyline."""
    way = np.r_[0, np.cumsum(np.hypot(*np.diff(line, axis=0).T))]
    at = np.linspace(0, way[-1], n)
    return np.c_[np.interp(at, way, line[:, 0]), np.interp(at, way, line[:, 1])]


def from_rails(lines: list[Array]) -> Column:
    """A column between two rails; the other lines are rungs that tie a place of one rail to a place of the other.

    The rails are the two lines that the most others cross (a rung crosses two), of equals the longest: in a short wide
    column rungs are longer than rails. Between neighbouring rungs places are paired by their share of the way.
    """
    import shapely

    size = [float(np.hypot(*np.diff(line, axis=0).T).sum()) for line in lines]
    shapes = np.array([shapely.linestrings(line) for line in lines])
    met = [int(shapely.intersects(shapes, shape).sum()) for shape in shapes]
    # With one rung each rail is crossed once, the rung twice.
    order = [-m for m in met] if len(lines) == 3 and sorted(met) == [2, 2, 3] else met
    by_size = sorted(range(len(lines)), key=lambda i: (-order[i], -size[i]))
    a, b = (np.array(lines[i], np.float64) for i in sorted(by_size[:2]))
    if np.hypot(*(a[0] - b[0])) + np.hypot(*(a[-1] - b[-1])) > np.hypot(*(a[0] - b[-1])) + np.hypot(*(a[-1] - b[0])):
        b = b[::-1]
    wa, wb = (np.r_[0, np.cumsum(np.hypot(*np.diff(r, axis=0).T))] for r in (a, b))
    ties = [(0.0, 0.0), (float(wa[-1]), float(wb[-1]))]
    la, lb = shapely.linestrings(a), shapely.linestrings(b)
    for i in by_size[2:]:
        rung = shapely.linestrings(lines[i])
        s, t = (_meets(rail, rung) for rail in (la, lb))
        ties.append((s, t))
    ties.sort()
    good = [ties[0]]
    for s, t in ties[1:]:
        if s > good[-1][0] + 1e-6 and t > good[-1][1] + 1e-6:
            good.append((s, t))
    if good[-1] != ties[-1]:
        good[-1:] = [ties[-1]] if len(good) > 1 else [good[0], ties[-1]]
    left: list[Array] = []
    right: list[Array] = []
    for (s0, t0), (s1, t1) in itertools.pairwise(good):
        n = max(2, math.ceil(max(s1 - s0, t1 - t0) / STEP) + 1)
        sa, ta = np.linspace(s0, s1, n), np.linspace(t0, t1, n)
        keep = slice(None) if not left else slice(1, None)
        left.append(np.c_[np.interp(sa, wa, a[:, 0]), np.interp(sa, wa, a[:, 1])][keep])
        right.append(np.c_[np.interp(ta, wb, b[:, 0]), np.interp(ta, wb, b[:, 1])][keep])
    return Column(np.concatenate(left), np.concatenate(right))


def _meets(rail: Any, rung: Any) -> float:
    """The place of a rail nearest to a rung."""
    import shapely

    near = shapely.get_point(shapely.shortest_line(rail, rung), 0)
    return float(shapely.line_locate_point(rail, near))


@inner
def _advance(left: F8x2, right: F8x2, i: int) -> float:
    """How far a column goes on after sample ``i``, mm, on the side that goes on more: across its stitches, for it is there that
    threads lie beside each other, and not along sides that draw together."""
    ax, ay = left[i + 1, 0] - left[i, 0], left[i + 1, 1] - left[i, 1]
    bx, by = right[i + 1, 0] - right[i, 0], right[i + 1, 1] - right[i, 1]
    far = max(math.hypot(ax, ay), math.hypot(bx, by))
    cx = right[i, 0] + right[i + 1, 0] - left[i, 0] - left[i + 1, 0]
    cy = right[i, 1] + right[i + 1, 1] - left[i, 1] - left[i + 1, 1]
    wide = math.hypot(cx, cy)
    if wide < 1e-9:
        return far
    return max(SLANT * far, max(abs(ax * cy - ay * cx), abs(bx * cy - by * cx)) / wide)


@kernel
def zigzag(
    left: F8x2,
    right: F8x2,
    spacing: float,
    crowded: float,
    drawn: float,
    pull: float,
    share: float,
    jagged: float,
    key: np.uint64,
) -> F8x2:
    """Needle points from side to side: (n, 2), both sides going on by at most ``spacing``, across the stitches, from pair to pair.

    Where the points of one side come closer than ``crowded`` and fan out to the other, stitches end, by up to ``drawn`` of
    the width, where those that go on stand that far apart: each eighth of them at its own depth, neighbours far from
    each other. ``pull`` mm and a ``share`` of the width, together at most ``MOST``, widen on each side; ``jagged``
    draws ends back at random (mm).
    """
    n = len(left)
    total = 0.0
    for i in range(n - 1):
        total += _advance(left, right, i)
    pairs = max(1, round(total / spacing))
    step = total / pairs / 2
    out = np.empty((2 * pairs + 1, 2))
    m = 0
    i = 0
    run = 0.0
    here = 0.0
    last = np.zeros((2, 2))
    have = np.zeros(2, np.bool_)
    beyond = np.zeros((2, 2))  # the other end of the last stitch of each side
    turn = np.ones(2, np.int64)
    while m <= 2 * pairs:
        target = m * step
        while i < n - 2:
            d = _advance(left, right, i)
            if run + d >= target:
                break
            run += d
            i += 1
        here = _advance(left, right, i)
        f = min(1.0, max(0.0, (target - run) / here)) if here > 0 else 0.0
        lx, ly = left[i, 0] + f * (left[i + 1, 0] - left[i, 0]), left[i, 1] + f * (left[i + 1, 1] - left[i, 1])
        rx, ry = right[i, 0] + f * (right[i + 1, 0] - right[i, 0]), right[i, 1] + f * (right[i + 1, 1] - right[i, 1])
        side = m % 2
        x, y, ox, oy = (lx, ly, rx, ry) if side == 0 else (rx, ry, lx, ly)
        wide = math.hypot(ox - x, oy - y)
        back = -min(MOST, pull + share * wide)
        near = math.hypot(x - last[side, 0], y - last[side, 1])
        far = math.hypot(ox - beyond[side, 0], oy - beyond[side, 1])
        bx, by = beyond[side, 0] - last[side, 0], beyond[side, 1] - last[side, 1]
        fans = abs(bx * (oy - y) - by * (ox - x)) > 1e-3 * wide * math.hypot(
            bx, by
        )  # parallel ones are nowhere farther apart
        if have[side] and near < crowded and far > near + 1e-6 and fans:
            c = turn[side] % 8
            depth = ((c & 1) * 4 + (c & 2) + c // 4) / 8.0  # 0, 4, 2, 6, 1, 5, 3, 7 of eight
            least = 0.15 if c & 1 else 0.0  # every other one at least so far: holes in one line would cut the cloth
            back += wide * min(drawn, max(least, (depth * crowded - near) / (far - near)))
            turn[side] += 1
        else:
            turn[side] = 1  # the first that is too near ends early
        beyond[side, 0], beyond[side, 1] = ox, oy
        if jagged > 0:
            back += min(jagged, 0.4 * wide) * uniform(np.uint64(key), np.uint64(m))
        last[side, 0], last[side, 1] = x, y
        have[side] = True
        if wide > 1e-9:
            x, y = x + back * (ox - x) / wide, y + back * (oy - y) / wide
        out[m, 0], out[m, 1] = x, y
        m += 1
    return out


def drawn_back(column: Column, start: float, end: float) -> Column:
    """The column without so many mm of its start and end, against its being pushed out there; half of it stays."""
    middle = column.middle
    way = np.r_[0, np.cumsum(np.hypot(*np.diff(middle, axis=0).T))]
    most = way[-1] / 4
    low, high = min(start, most), way[-1] - min(end, most)
    if high - low >= way[-1]:
        return column
    at = np.r_[low, way[(way > low) & (way < high)], high]
    left, right = (np.c_[np.interp(at, way, s[:, 0]), np.interp(at, way, s[:, 1])] for s in (column.left, column.right))
    return Column(left, right)


def split(points: Array, most: float) -> Array:
    """Side-to-side points with needle points put into stitches longer than ``most``, strewn from stitch to stitch."""
    size = np.hypot(*np.diff(points, axis=0).T)
    if not len(size) or size.max() <= most:
        return points
    parts = [points[:1]]
    for k, d in enumerate(size.tolist()):
        if d > most:
            # Strewn by the golden section over four fifths of a part, so that the places of neighbours form no line.
            n = math.ceil(1.4 * d / most)
            f = (np.arange(1, n) + 0.8 * (k * GOLDEN % 1 - 0.5)) / n
            parts.append(points[k] + f[:, None] * (points[k + 1] - points[k]))
        parts.append(points[k + 1 : k + 2])
    return np.concatenate(parts)


def side_to_side(column: Column, params: EmbroideryParams, name: str, spacing: float | None = None) -> Stitches:
    """The satin stitches of a column, from its start to its end; a run per stitch."""
    pair = params.row_spacing if spacing is None else spacing
    number = np.uint64(key(params.seed, name, "jagged"))
    xy = zigzag(
        column.left, column.right, pair, CROWDED, DRAWN, params.pull, params.pull_percent / 200, params.jagged, number
    )
    made = Stitches.of(xy, SATIN, per_stitch=True)
    size = np.hypot(*np.diff(xy, axis=0).T)
    if not len(size) or size.max() <= params.split:
        return made
    cut = split(xy, params.split)
    # A split stitch stays one run: its thread lies in one line.
    ends = {(float(x), float(y)) for x, y in xy}
    run = np.cumsum([0, *(1 if (float(x), float(y)) in ends else 0 for x, y in cut[:-1])])
    return Stitches(cut, np.full(len(cut), SATIN, np.uint8), run)


def underlays(column: Column, asked: str) -> list[str]:
    """Which underlays a column gets: what was asked for, or by its width (spec 2.4)."""
    wide = float(np.median(np.hypot(*(column.left - column.right).T)))
    if asked == "auto":
        return ["center"] if wide < 2 else ["edge"] if wide < 4 else ["edge", "zigzag"]
    return [] if asked == "none" else ["zigzag" if w == "tatami" else w for w in asked.split("+")]


def side_walk(column: Column, params: EmbroideryParams) -> Stitches:
    """Running stitch along the left edge, drawn in, from start to end."""
    across = column.right - column.left
    wide = np.hypot(*across.T)[:, None]
    line = column.left + across * np.minimum(0.4, EDGE_INSET / np.maximum(wide, 1e-9))
    return line_stitches(line, min(params.length, 2.5), UNDERLAY, 0.1)


def center_walk(column: Column, params: EmbroideryParams, kind: int = UNDERLAY) -> Stitches:
    """Running stitch along the middle."""
    return line_stitches(column.middle, min(params.length, 2.5), kind, 0.1)


def zigzag_walk(column: Column, params: EmbroideryParams) -> Stitches:
    """Wide zigzag, drawn in."""
    across = column.right - column.left
    share = np.minimum(0.4, EDGE_INSET / np.maximum(np.hypot(*across.T)[:, None], 1e-9))
    left, right = (
        np.ascontiguousarray(column.left + share * across),
        np.ascontiguousarray(column.right - share * across),
    )
    return Stitches.of(split(zigzag(left, right, 2.0, 0.0, 0.0, 0.0, 0.0, 0.0, np.uint64(0)), params.split), UNDERLAY)


def there_and_back(column: Column, params: EmbroideryParams, name: str) -> tuple[Stitches, Stitches]:
    """A limb of a branched satin: underlay that ends at its far end, and the satin that comes back over it."""
    words = underlays(column, params.underlay)
    parts = [side_walk(c, params) for c in (column, column.reversed())] if "edge" in words else []
    if float(np.median(np.hypot(*(column.left - column.right).T))) < params.line_below:
        line = line_stitches(column.middle, min(params.length, 2.0), RUNNING, 0.1)
        return line, line.reversed()
    there = (
        zigzag_walk(column, params) if "zigzag" in words else center_walk(column, params, UNDERLAY if words else TRAVEL)
    )
    return chain([*parts, there], params.length), side_to_side(column.reversed(), params, name)

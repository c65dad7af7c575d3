"""Tatami: straight rows, needle points staggered from row to row, one walk without a jump."""

from __future__ import annotations

import math

import numpy as np

from tambour.core.arrays import B1x1, F8x1, F8x2, I8x1, U1x1
from tambour.core.check import Array
from tambour.core.kernels import kernel
from tambour.embroidery.lines.corridor import find, leaves, neighbours, straighten
from tambour.embroidery.lines.fill import Rings, along_ring, crossings, from_rows, inside_pairs, levels
from tambour.embroidery.lines.route import ring_way, row_tour
from tambour.embroidery.piece import FILL, TRAVEL
from tambour.embroidery.stitches import Stitches
from tambour.noise import uniform

TOLERANCE = 0.04  # mm that a way along an outline may cut its bends
OVER = 4.0  # what a millimetre of travel on finished rows counts, beside 1 below later ones
EDGE = 1.5  # what a millimetre of travel along the outline counts
STARTS = 16
GOLDEN = (3 - math.sqrt(5)) / 2


@kernel
def put_line(xy: Array, n: int, px: float, py: float, qx: float, qy: float, most: float) -> int:
    """Write the points of a straight way from p (left out) to q in equal stitches of at most ``most``; gives the new n."""
    parts = max(1, math.ceil(math.hypot(qx - px, qy - py) / most - 1e-9))
    for k in range(1, parts + 1):
        xy[n, 0], xy[n, 1] = px + (qx - px) * k / parts, py + (qy - py) * k / parts
        n += 1
    return n


@kernel
def simplify_into(xy: Array, n: int, way: Array, m: int, most: float, tolerance: float) -> int:
    """Write ``way[:m]`` (its first point left out) with as few stitches as keep within ``tolerance`` of it."""
    i = 0
    while i < m - 1:
        j = i + 1
        while j + 1 < m:
            px, py, qx, qy = way[i, 0], way[i, 1], way[j + 1, 0], way[j + 1, 1]
            span = math.hypot(qx - px, qy - py)
            if span > most:
                break
            good = True
            for k in range(i + 1, j + 1):
                dx, dy = way[k, 0] - px, way[k, 1] - py
                f = 0.0 if span == 0 else min(1.0, max(0.0, (dx * (qx - px) + dy * (qy - py)) / (span * span)))
                if math.hypot(dx - f * (qx - px), dy - f * (qy - py)) > tolerance:
                    good = False
                    break
            if not good:
                break
            j += 1
        n = put_line(xy, n, way[i, 0], way[i, 1], way[j, 0], way[j, 1], most)
        i = j
    return n


@kernel
def tour_start(
    tour: I8x1,
    turned: B1x1,
    lo: F8x1,
    hi: F8x1,
    v: F8x1,
    row: I8x1,
    ring: I8x1,
    at: F8x1,
    base: F8x1,
    u: float,
    w: float,
) -> int:
    """Where the closed tour is best cut open: near (u, w) if that is finite, and before a long way."""
    best, cut = np.inf, 0
    n = len(tour)
    for i in range(n):
        s, t = tour[i - 1], tour[i]
        p, q = 2 * s + (0 if turned[i - 1] else 1), 2 * t + (1 if turned[i] else 0)
        cost = -abs(ring_way(p, q, ring, at, base)) if ring[p] == ring[q] else 0.0
        if not math.isnan(u):
            cost += math.hypot((hi[t] if turned[i] else lo[t]) - u, v[row[t]] - w)
        if cost < best:
            best, cut = cost, i
    return cut


@kernel
def emit(
    points: F8x2,
    way_at: F8x1,
    offsets: I8x1,
    base: F8x1,
    v: F8x1,
    row: I8x1,
    number: I8x1,
    lo: F8x1,
    hi: F8x1,
    ring: I8x1,
    at: F8x1,
    tour: I8x1,
    turned: B1x1,
    length: float,
    stagger: int,
    stride: int,
    least: float,
    jitter: float,
    key: np.uint64,
    hidden: bool,
) -> tuple[F8x2, U1x1, I8x1, float, float, float]:
    """Needle points of a tour over spans: (uv (n, 2), kind (n,), run (n,), mm of ways, mm of hidden ways, mm covered).

    v, row, lo, hi : heights, and the spans in them; number : (R,) the row's number from the origin, for the stagger
    ring, at : per end of span; tour, turned : order and direction; least : shortest stitch at a row's end
    """
    n = len(tour)
    spans = len(row)
    rank = np.zeros(spans, np.int64)
    room = 16
    for i in range(n):
        s = tour[i]
        rank[s] = i
        room += int((hi[s] - lo[s]) / length) + 4
    total = 0.0
    long = 3 * (v[1] - v[0]) if len(v) > 1 else 1.0
    search = False
    for i in range(n - 1):
        s, t = tour[i], tour[i + 1]
        p, q = 2 * s + (0 if turned[i] else 1), 2 * t + (1 if turned[i + 1] else 0)
        w = abs(ring_way(p, q, ring, at, base))
        total += w
        search = search or w > long
        share = w / max(base[ring[p] + 1] - base[ring[p]], 1e-9)
        room += int(share * (offsets[ring[p] + 1] - offsets[ring[p]])) + int(4 * w / length) + 8
    xy = np.empty((2 * room + 1000, 2))
    kind = np.empty(len(xy), np.uint8)
    run = np.empty(len(xy), np.int64)
    near_at = np.zeros(1, np.int64)
    near = np.zeros(0, np.int64)
    if hidden and search:
        near_at, near = neighbours(row, lo, hi)
    m = 0
    runs = 0
    ways, hidden_mm, covered = 0.0, 0.0, 0.0
    for i in range(n):
        s = tour[i]
        back = turned[i]
        a, b = (hi[s], lo[s]) if back else (lo[s], hi[s])
        w = v[row[s]]
        if i == 0:
            xy[0, 0], xy[0, 1] = a, w
            kind[0], run[0] = TRAVEL, 0
            m, runs = 1, 1
        else:
            z = tour[i - 1]
            p, q = 2 * z + (0 if turned[i - 1] else 1), 2 * s + (1 if back else 0)
            step = ring_way(p, q, ring, at, base)
            begin = np.array([lo[z] if turned[i - 1] else hi[z], v[row[z]]])
            end = np.array([a, w])
            before = m
            under = False
            if hidden and abs(step) > long:
                margin = 0.5
                path, _ = find(
                    near_at, near, row, v, lo, hi, rank, i - 1, z, begin[0], s, a, margin, OVER, EDGE * abs(step)
                )
                if len(path):
                    line = straighten(path, row, v, lo, hi, begin[0], a, margin)
                    good = not leaves(points, offsets, line, 0.05)
                    if not good:
                        # Begin and end along the rows themselves, where their thread lies already or will lie.
                        ia = begin[0] + min(margin, (hi[z] - lo[z]) / 2) * (1 if turned[i - 1] else -1)
                        ib = a + min(margin, (hi[s] - lo[s]) / 2) * (-1 if back else 1)
                        inner = straighten(path, row, v, lo, hi, ia, ib, margin)
                        line = np.concatenate((begin.reshape(1, 2), inner, end.reshape(1, 2)))
                        good = not leaves(points, offsets, line, 0.05)
                    if good:
                        under = True
                        need = m + 2 * len(line) + 8
                        for k in range(len(line) - 1):
                            need += int(math.hypot(line[k + 1, 0] - line[k, 0], line[k + 1, 1] - line[k, 1]) / length)
                        if need + room > len(xy):
                            xy = np.concatenate((xy, np.empty((need + room, 2))))
                            kind = np.concatenate((kind, np.empty(need + room, np.uint8)))
                            run = np.concatenate((run, np.empty(need + room, np.int64)))
                        for k in range(len(line) - 1):
                            d = math.hypot(line[k + 1, 0] - line[k, 0], line[k + 1, 1] - line[k, 1])
                            ways += d
                            hidden_mm += d
                            m = put_line(xy, m, line[k, 0], line[k, 1], line[k + 1, 0], line[k + 1, 1], length)
                        later = 0
                        for k in range(len(path)):
                            if rank[path[k]] >= i:
                                later += 1
                        d = 0.0
                        for k in range(len(line) - 1):
                            d += math.hypot(line[k + 1, 0] - line[k, 0], line[k + 1, 1] - line[k, 1])
                        covered += d * later / len(path)
            if not under:
                line = along_ring(points, way_at, offsets, base, ring[p], at[p], step, begin, end)
                ways += abs(step)
                m = simplify_into(xy, m, line, len(line), length, TOLERANCE)
            if m > before:
                kind[before:m] = TRAVEL
                run[before:m] = runs
                runs += 1
        # The row: needle points at fixed places of the plane, shifted by the row's place in the stagger.
        before = m
        shift = (number[row[s]] * stride % stagger) / stagger * length
        if jitter > 0:
            near_end = min(jitter, 0.3 * (hi[s] - lo[s]))
            a += (1 if b > a else -1) * near_end * uniform(np.uint64(key), np.uint64(4 * s))
            b -= (1 if b > a else -1) * near_end * uniform(np.uint64(key), np.uint64(4 * s + 1))
            xy[m, 0], xy[m, 1] = a, w
            m += 1
        left, right = min(a, b), max(a, b)
        k0 = math.floor((left + least - shift) / length) + 1
        k1 = math.ceil((right - least - shift) / length) - 1
        if k1 < k0:
            near_a, near_b = right - left, 0.0
        else:
            far_left, far_right = k0 * length + shift - left, right - k1 * length - shift
            near_a, near_b = (far_right, far_left) if b < a else (far_left, far_right)
        # Where the first or the last stitch would be longer than ``length`` it is halved.
        if near_a > length:
            xy[m, 0], xy[m, 1] = a + (near_a / 2 if b > a else -near_a / 2), w
            m += 1
        for j in range(k1 - k0 + 1):
            x = (k1 - j if b < a else k0 + j) * length + shift
            if jitter > 0:
                x += min(jitter, 0.2 * length) * (
                    uniform(np.uint64(key), np.uint64(k0 + j + 7919 * s + (1 << 40))) - 0.5
                )
            xy[m, 0], xy[m, 1] = x, w
            m += 1
        if near_b > length:
            xy[m, 0], xy[m, 1] = b - (near_b / 2 if b > a else -near_b / 2), w
            m += 1
        xy[m, 0], xy[m, 1] = b, w
        m += 1
        kind[before:m] = FILL
        run[before:m] = runs
        runs += 1
    return xy[:m].copy(), kind[:m].copy(), run[:m].copy(), ways, hidden_mm, covered


def stride(stagger: int) -> int:
    """How many of ``stagger`` equal parts of a stitch the needle points move by from row to row: near the golden section's share, so
    that they lie like a honeycomb's and in no line that cuts the cloth; 1 of 4, 3 of 8."""
    return min((k for k in range(1, stagger + 1) if math.gcd(k, stagger) == 1), key=lambda k: abs(k - GOLDEN * stagger))


def tatami(
    area: Rings,
    angle: float,
    spacing: float,
    length: float,
    *,
    stagger: int = 4,
    jitter: float = 0.0,
    key: int = 0,
    travel: str = "hidden",
    start: tuple[float, float] | None = None,
    at: Array | None = None,
    kind: int = FILL,
) -> Stitches:
    """Fill one connected area (rings in the row frame of ``angle``) with rows; a walk without jumps.

    angle : radians; spacing, length : mm; start : where the walk should begin (drawing coordinates);
    at : heights of the rows instead of even ones; kind : what the rows count as.

    Rows and needle points stand at fixed places of the plane, so that neighbouring fills run on. Ways between rows
    follow the outline, or lie below rows that come later where that is not much longer (spec 4.3).
    """
    if not len(area.points):
        return Stitches.none()
    heights = area.points[:, 1]
    v = levels(float(heights.min()), float(heights.max()), spacing) if at is None else at
    starts, u, edge, sign = crossings(area.points, area.offsets, v)
    row, first, last = inside_pairs(starts, sign, True)
    if not len(row):
        return Stitches.none()
    lo, hi = u[first], u[last]
    ends = np.stack([first, last], 1).reshape(-1)
    at_edge = area.points[edge[ends]]
    place = area.at[edge[ends]] + np.hypot(u[ends] - at_edge[:, 0], v[np.repeat(row, 2)] - at_edge[:, 1])
    ring = np.searchsorted(area.offsets, edge[ends], side="right") - 1
    order = np.argsort(place, kind="stable")
    tour, turned, _ = row_tour(len(row), order, ring, place, area.base, STARTS if len(row) < 5000 else 4)
    c, s = math.cos(angle), math.sin(angle)
    hint = (math.nan, math.nan) if start is None else (start[0] * c - start[1] * s, start[0] * s + start[1] * c)
    cut = tour_start(tour, turned, lo, hi, v, row, ring, place, area.base, *hint)
    tour, turned = np.roll(tour, -cut), np.roll(turned, -cut)
    number = np.floor(v / spacing).astype(np.int64)
    uv, kinds, run, ways, hidden, covered = emit(
        area.points,
        area.at,
        area.offsets,
        area.base,
        v,
        row,
        number,
        lo,
        hi,
        ring,
        place,
        tour,
        turned,
        length,
        stagger,
        stride(stagger),
        min(0.5, length / 4),
        jitter,
        np.uint64(key),
        travel == "hidden",
    )
    if kind != FILL:
        kinds = np.where(kinds == FILL, kind, kinds).astype(np.uint8)
    return Stitches(
        from_rows(uv, angle), kinds, run, {"connector_mm": ways, "hidden_mm": hidden, "covered_mm": covered}
    )

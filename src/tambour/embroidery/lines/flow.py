"""Flow: streamlines of even density along a field of directions.

Lines are grown from places at the wanted distance from what lies there already and end where they come too near
(Jobard and Lefer 1997, "Creating evenly-spaced streamlines of arbitrary density"), then pushed sideways until the
gaps on both their sides agree.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from tambour.core.arrays import B1x2, F8x2, F8x3, I8x1
from tambour.core.check import Array
from tambour.core.kernels import kernel
from tambour.core.paths import Paths
from tambour.embroidery.lines.even import even_out
from tambour.embroidery.lines.field import direction, field
from tambour.noise import key as name_key
from tambour.noise import uniform

STEP = 0.5  # of the spacing: between the points of a streamline
NEAR = (0.7, 1.0)  # of the spacing: a line ends where another is nearer, each line at its own value
SEED = (0.55, 0.7)  # of the spacing: a line may begin this far from the others, beside each line at its own value
CALIBRATION = 0.91  # lines are grown this much closer than wanted, for gaps are wider than they on average
ROUNDS = 2  # of pushing
SPREAD = 12  # points to both sides that a push is averaged over


@kernel
def inside_mask(points: F8x2, offsets: I8x1, x0: float, y0: float, cell: float, rows: int, columns: int) -> B1x2:
    """Which grid nodes lie inside rings (even-odd), row by row."""
    mask = np.zeros((rows, columns), np.bool_)
    for k in range(len(offsets) - 1):
        b = offsets[k + 1] - 1
        for a in range(offsets[k], offsets[k + 1]):
            ya, yb = points[a, 1], points[b, 1]
            if ya != yb:
                low, high = min(ya, yb), max(ya, yb)
                i0 = max(0, math.ceil((low - y0) / cell))
                for i in range(i0, rows):
                    y = y0 + i * cell
                    if y >= high:
                        break
                    x = points[a, 0] + (y - ya) * (points[b, 0] - points[a, 0]) / (yb - ya)
                    j0 = max(0, math.ceil((x - x0) / cell))
                    for j in range(j0, columns):
                        mask[i, j] = not mask[i, j]
            b = a
    return mask


@kernel
def free_of(
    x: float,
    y: float,
    near2: float,
    bx: float,
    by: float,
    size: float,
    head: Array,
    follow: Array,
    xy: Array,
    line: Array,
    at: Array,
    mine: int,
    position: int,
    skip: int,
) -> bool:
    """Whether no point is within the square root of ``near2`` of (x, y): of other lines, or of the same line farther
    back than ``skip`` points."""
    i, j = int((y - by) / size), int((x - bx) / size)
    rows, columns = head.shape
    for r in range(max(0, i - 1), min(rows, i + 2)):
        for c in range(max(0, j - 1), min(columns, j + 2)):
            k = head[r, c]
            while k >= 0:
                if line[k] != mine or abs(at[k] - position) > skip:
                    dx, dy = xy[k, 0] - x, xy[k, 1] - y
                    if dx * dx + dy * dy < near2:
                        return False
                k = follow[k]
    return True


@kernel
def streamlines(
    grid: F8x3,
    left: float,
    top: float,
    cell: float,
    mask: B1x2,
    mx: float,
    my: float,
    fine: float,
    spacing: float,
    step: float,
    near_low: float,
    near_high: float,
    seed_low: float,
    seed_high: float,
    first: F8x2,
    most: int,
    key: np.uint64,
) -> tuple[F8x2, I8x1]:
    """Evenly spaced streamlines: (xy (P, 2), line (P,), place in the line (P,)), sorted by line and place.

    mask, mx, my, fine : where lines may run, on a grid of its own; first : (F, 2) starting places, tried in order
    near, seed : how close to another line one ends, and may begin: between the low and the high number
    """
    rows = int((mask.shape[0] * fine) / spacing) + 3
    columns = int((mask.shape[1] * fine) / spacing) + 3
    head = np.full((rows, columns), -1, np.int64)
    follow = np.full(most, -1, np.int64)
    xy = np.empty((most, 2))
    line = np.empty(most, np.int64)
    at = np.empty(most, np.int64)
    n = 0
    count = 0
    queue = 0
    trial = 0
    skip = int(3 * spacing / step)
    while n < most - 4:
        # The next starting place: beside the points that lie there already, then the given ones.
        sx, sy = 0.0, 0.0
        found = False
        while queue < 2 * n and not found:
            k, side = queue // 2, 1.0 - 2.0 * (queue % 2)
            queue += 1
            if at[k] % 2:
                continue
            dx, dy = direction(grid, left, top, cell, xy[k, 0], xy[k, 1], 1.0, 0.0)
            sx, sy = xy[k, 0] - side * dy * spacing, xy[k, 1] + side * dx * spacing
            found = True
            share = uniform(np.uint64(key), np.uint64((1 << 40) + 2 * line[k] + (1 if side > 0 else 0)))
            open_at = seed_low + (seed_high - seed_low) * share
            i, j = int((sy - my) / fine + 0.5), int((sx - mx) / fine + 0.5)
            if (
                i < 0
                or j < 0
                or i >= mask.shape[0]
                or j >= mask.shape[1]
                or not mask[i, j]
                or not free_of(sx, sy, open_at * open_at, mx, my, spacing, head, follow, xy, line, at, -1, 0, 0)
            ):
                found = False
        while not found and trial < len(first):
            sx, sy = first[trial, 0], first[trial, 1]
            trial += 1
            i, j = int((sy - my) / fine + 0.5), int((sx - mx) / fine + 0.5)
            if 0 <= i < mask.shape[0] and 0 <= j < mask.shape[1] and mask[i, j]:
                found = free_of(sx, sy, seed_high * seed_high, mx, my, spacing, head, follow, xy, line, at, -1, 0, 0)
        if not found:
            break
        begin = n
        # Every line ends at another nearness, so that where lines draw together they do not all end in one place.
        near2 = (near_low + (near_high - near_low) * uniform(np.uint64(key), np.uint64(count + trial))) ** 2
        for way in range(2):
            x, y = sx, sy
            px, py = (1.0, 0.0) if way == 0 else (-1.0, 0.0)
            dx, dy = direction(grid, left, top, cell, x, y, px, py)
            if way == 1:
                ax, ay = direction(grid, left, top, cell, x, y, 1.0, 0.0)
                dx, dy = -ax, -ay
            place = 0
            if way == 0:
                xy[n, 0], xy[n, 1], line[n], at[n] = x, y, count, 0
                n += 1
            while n < most - 4:
                hx, hy = direction(grid, left, top, cell, x + 0.5 * step * dx, y + 0.5 * step * dy, dx, dy)
                nx, ny = x + step * hx, y + step * hy
                i, j = int((ny - my) / fine + 0.5), int((nx - mx) / fine + 0.5)
                if i < 0 or j < 0 or i >= mask.shape[0] or j >= mask.shape[1] or not mask[i, j]:
                    break
                place += 1 if way == 0 else -1
                if not free_of(nx, ny, near2, mx, my, spacing, head, follow, xy, line, at, count, place, skip):
                    break
                dx, dy = direction(grid, left, top, cell, nx, ny, hx, hy)
                x, y = nx, ny
                xy[n, 0], xy[n, 1], line[n], at[n] = x, y, count, place
                n += 1
                if abs(place) > 100000:
                    break
        # Lines of one or two points are dropped; the others become visible to those that follow.
        if n - begin < 3:
            n = begin
            continue
        for k in range(begin, n):
            i, j = int((xy[k, 1] - my) / spacing), int((xy[k, 0] - mx) / spacing)
            follow[k] = head[i, j]
            head[i, j] = k
        count += 1
    out = np.empty((n, 2))
    of = np.empty(n, np.int64)
    m = 0
    k = 0
    while k < n:
        e = k
        while e < n and line[e] == line[k]:
            e += 1
        split = k
        while split < e and at[split] >= 0:
            split += 1
        for i in range(e - 1, split - 1, -1):
            out[m], of[m] = xy[i], line[i]
            m += 1
        for i in range(k, split):
            out[m], of[m] = xy[i], line[i]
            m += 1
        k = e
    return out, of


@kernel
def relax(
    xy: F8x2,
    line: I8x1,
    grid: F8x3,
    left: float,
    top: float,
    cell: float,
    x0: float,
    y0: float,
    spacing: float,
    rounds: int,
    share: float,
) -> None:
    """Push points across the field until the gaps to both neighbouring lines agree: xy is changed in place.

    Gaps wider than 1.6 spacings count as that, so that lines beside a hole move into it only so far. Moves are
    averaged along the line.
    """
    n = len(xy)
    columns = 0
    rows = 0
    for k in range(n):
        columns = max(columns, int((xy[k, 0] - x0) / spacing) + 3)
        rows = max(rows, int((xy[k, 1] - y0) / spacing) + 3)
    move = np.zeros((n, 2))
    even = np.zeros((n, 2))
    follow = np.empty(n, np.int64)
    reach = 1.6 * spacing
    for _ in range(rounds):
        head = np.full((rows, columns), -1, np.int64)
        for k in range(n):
            i = min(max(int((xy[k, 1] - y0) / spacing), 0), rows - 1)
            j = min(max(int((xy[k, 0] - x0) / spacing), 0), columns - 1)
            follow[k] = head[i, j]
            head[i, j] = k
        for k in range(n):
            x, y = xy[k, 0], xy[k, 1]
            dx, dy = direction(grid, left, top, cell, x, y, 1.0, 0.0)
            right, wrong = reach, reach
            i, j = int((y - y0) / spacing), int((x - x0) / spacing)
            for r in range(max(0, i - 2), min(rows, i + 3)):
                for c in range(max(0, j - 2), min(columns, j + 3)):
                    q = head[r, c]
                    while q >= 0:
                        if line[q] != line[k]:
                            ex, ey = xy[q, 0] - x, xy[q, 1] - y
                            along, across = ex * dx + ey * dy, ey * dx - ex * dy
                            if abs(along) < 0.6 * spacing:
                                if across > 0:
                                    right = min(right, across)
                                else:
                                    wrong = min(wrong, -across)
                        q = follow[q]
            push = 0.0
            if right < reach or wrong < reach:
                push = 0.5 * (right - wrong)
                if right >= reach or wrong >= reach:
                    # One side open: towards the wanted distance only.
                    push = (right - spacing) if right < reach else (spacing - wrong)
                    push *= 0.5
            push = min(max(push, -0.25 * spacing), 0.25 * spacing)
            move[k, 0], move[k, 1] = -dy * push * share, dx * push * share
        for k in range(n):
            sx, sy, m = 0.0, 0.0, 0
            for q in range(max(0, k - SPREAD), min(n, k + SPREAD + 1)):
                if line[q] == line[k]:
                    sx += move[q, 0]
                    sy += move[q, 1]
                    m += 1
            even[k, 0], even[k, 1] = sx / m, sy / m
        for k in range(n):
            xy[k, 0] += even[k, 0]
            xy[k, 1] += even[k, 1]


def flow(area: Any, spacing: float, guide: Paths | None, angle: float, seed: str) -> list[Array]:
    """Streamlines that fill a shapely polygon evenly, ``spacing`` mm apart on average, as polylines (n, 2)."""
    from tambour.embroidery.lines.net import clipped

    x0, y0, x1, y1 = area.bounds
    # Lines grow in the area widened by a spacing and are cut at its outline afterwards, so that they end on it.
    wide = spacing
    bounds = (x0 - 2 * wide, y0 - 2 * wide, x1 + 2 * wide, y1 + 2 * wide)
    grid, left, top, cell = field(bounds, guide, angle, seed)
    fine = max(0.25 * spacing, max(x1 - x0, y1 - y0) / 2500)
    rows, columns = math.ceil((bounds[3] - bounds[1]) / fine), math.ceil((bounds[2] - bounds[0]) / fine)
    grown = area.buffer(wide)
    import shapely

    parts = [p for p in shapely.get_parts(grown) if p.geom_type == "Polygon"]
    loops = [shapely.get_coordinates(r)[:-1] for p in parts for r in (p.exterior, *p.interiors)]
    points = np.ascontiguousarray(np.concatenate(loops))
    offsets = np.r_[0, np.cumsum([len(p) for p in loops])]
    mask = inside_mask(points, offsets, bounds[0], bounds[1], fine, rows, columns)
    # Starting places: the middle first, then a grid over all.
    sx, sy = np.meshgrid(np.arange(bounds[0], bounds[2], 0.8 * spacing), np.arange(bounds[1], bounds[3], 0.8 * spacing))
    spread = np.c_[sx.reshape(-1), sy.reshape(-1)]
    c = shapely.get_coordinates(area.representative_point())
    step = STEP * spacing
    most = int(3 * grown.area / (step * spacing)) + 1000
    pitch = spacing * CALIBRATION
    xy, line = streamlines(
        grid,
        left,
        top,
        cell,
        mask,
        bounds[0],
        bounds[1],
        fine,
        pitch,
        step,
        NEAR[0] * pitch,
        NEAR[1] * pitch,
        SEED[0] * pitch,
        SEED[1] * pitch,
        np.ascontiguousarray(np.concatenate([c, spread])),
        most,
        np.uint64(name_key(seed, "flow ends")),
    )
    relax(xy, line, grid, left, top, cell, bounds[0] - wide, bounds[1] - wide, spacing, ROUNDS, 0.3)
    xy = even_out(xy, line, area, spacing, grid, left, top, cell)
    cuts = np.flatnonzero(np.diff(line)) + 1
    return clipped([p for p in np.split(xy, cuts) if len(p) > 2], area)

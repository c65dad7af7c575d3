"""Flow: streamlines of even density along a field of directions.

Lines are grown from places at the wanted distance from what lies there already and end where they come too near
(Jobard and Lefer 1997, "Creating evenly-spaced streamlines of arbitrary density"), then pushed sideways until the
gaps on both their sides agree.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from tambour.core.check import Array
from tambour.core.kernels import kernel
from tambour.core.paths import Paths
from tambour.noise import key as name_key
from tambour.noise import stream, uniform

STEP = 0.5  # of the spacing: between the points of a streamline
NEAR = (0.7, 1.0)  # of the spacing: a line ends where another is nearer, each line at its own value
SEED = (0.55, 0.7)  # of the spacing: a line may begin this far from the others, beside each line at its own value
CALIBRATION = 0.91  # lines are grown this much closer than wanted, for gaps are wider than they on average
ROUNDS = 2  # of pushing
ROUGH = 0.1  # how much an uneven push is held against it
SPREAD = 12  # points to both sides that a push is averaged over
GRID = 160  # nodes of the field along the longer side


def field(
    bounds: tuple[float, float, float, float], guide: Paths | None, angle: float, seed: str
) -> tuple[Array, float, float, float]:
    """Directions on a grid: ((rows, columns, 2) of (cos 2a, sin 2a), left, top, cell); a is measured in drawing space.

    With guide lines the field is the smoothest one that follows them (Laplace's equation for the doubled angle);
    without, it swings gently round ``angle``.
    """
    x0, y0, x1, y1 = bounds
    cell = max(x1 - x0, y1 - y0, 1e-6) / (GRID - 3)
    columns, rows = math.ceil((x1 - x0) / cell) + 3, math.ceil((y1 - y0) / cell) + 3
    left, top = x0 - cell, y0 - cell
    x, y = np.meshgrid(left + cell * np.arange(columns), top + cell * np.arange(rows))
    if guide is None or not len(guide):
        phase = stream(seed, "flow").random(4) * 2 * math.pi
        size = 0.5 * max(x1 - x0, y1 - y0)
        swing = 0.35 * (
            np.sin(x / size * 1.7 + y / size * 0.9 + phase[0]) + np.sin(y / size * 1.9 - x / size * 0.6 + phase[1])
        )
        a = -angle + swing
        return np.ascontiguousarray(np.stack([np.cos(2 * a), np.sin(2 * a)], -1)), left, top, cell
    value = np.zeros((rows, columns, 2))
    fixed = np.zeros((rows, columns))
    for line in guide:
        d = np.diff(line, axis=0)
        size = np.hypot(*d.T)
        for p, v, s in zip(line[:-1], d, size):
            if s < 1e-9:
                continue
            n = max(1, math.ceil(s / (0.5 * cell)))
            at = p + (np.arange(n)[:, None] + 0.5) / n * v
            c = np.clip(np.round((at - [left, top]) / cell).astype(int), 0, [columns - 1, rows - 1])
            a = 2 * math.atan2(v[1], v[0])
            np.add.at(value, (c[:, 1], c[:, 0]), [math.cos(a), math.sin(a)])
            np.add.at(fixed, (c[:, 1], c[:, 0]), 1.0)
    held = fixed > 0
    value[held] /= np.maximum(np.hypot(*value[held].T)[:, None], 1e-9)
    return _smooth(value, held), left, top, cell


def _smooth(value: Array, held: Array) -> Array:
    """Laplace's equation with the held nodes given (a sparse solve), free at the sheet's edge; unit length again."""
    from scipy.sparse import coo_matrix, diags
    from scipy.sparse.linalg import spsolve

    rows, columns = held.shape
    n = rows * columns
    index = np.arange(n).reshape(rows, columns)
    a = np.concatenate([index[:, :-1].reshape(-1), index[:-1].reshape(-1)])
    b = np.concatenate([index[:, 1:].reshape(-1), index[1:].reshape(-1)])
    ones = np.ones(len(a))
    joined = coo_matrix((np.r_[ones, ones], (np.r_[a, b], np.r_[b, a])), shape=(n, n)).tocsr()
    laplace = diags(np.asarray(joined.sum(1)).reshape(-1)) - joined
    free = ~held.reshape(-1)
    given = value.reshape(-1, 2)[~free]
    inner = laplace.tocsr()[free][:, free].tocsc()
    side = -laplace.tocsr()[free][:, ~free] @ given
    out = value.reshape(-1, 2).copy()
    out[free] = np.column_stack([spsolve(inner, side[:, 0]), spsolve(inner, side[:, 1])])
    out /= np.maximum(np.hypot(*out.T)[:, None], 1e-9)
    return np.ascontiguousarray(out.reshape(rows, columns, 2))


@kernel
def direction(grid: Any, left: Any, top: Any, cell: Any, x: Any, y: Any, px: Any, py: Any) -> Any:
    """The field's direction at (x, y), bilinear in the doubled angle, on the side of (px, py)."""
    rows, columns = grid.shape[0], grid.shape[1]
    u, v = (x - left) / cell, (y - top) / cell
    i = min(max(int(v), 0), rows - 2)
    j = min(max(int(u), 0), columns - 2)
    f, g = min(max(u - j, 0.0), 1.0), min(max(v - i, 0.0), 1.0)
    c = (1 - g) * ((1 - f) * grid[i, j, 0] + f * grid[i, j + 1, 0]) + g * (
        (1 - f) * grid[i + 1, j, 0] + f * grid[i + 1, j + 1, 0]
    )
    s = (1 - g) * ((1 - f) * grid[i, j, 1] + f * grid[i, j + 1, 1]) + g * (
        (1 - f) * grid[i + 1, j, 1] + f * grid[i + 1, j + 1, 1]
    )
    a = 0.5 * math.atan2(s, c)
    dx, dy = math.cos(a), math.sin(a)
    if dx * px + dy * py < 0:
        return -dx, -dy
    return dx, dy


@kernel
def inside_mask(points: Any, offsets: Any, x0: Any, y0: Any, cell: Any, rows: Any, columns: Any) -> Any:
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
    x: Any,
    y: Any,
    near2: Any,
    bx: Any,
    by: Any,
    size: Any,
    head: Any,
    follow: Any,
    xy: Any,
    line: Any,
    at: Any,
    mine: Any,
    position: Any,
    skip: Any,
) -> Any:
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
    grid: Any,
    left: Any,
    top: Any,
    cell: Any,
    mask: Any,
    mx: Any,
    my: Any,
    fine: Any,
    spacing: Any,
    step: Any,
    near: Any,
    seed: Any,
    first: Any,
    most: Any,
    key: Any,
) -> Any:
    """Evenly spaced streamlines: (xy (P, 2), line (P,), place in the line (P,)), sorted by line and place.

    mask, mx, my, fine : where lines may run, on a grid of its own; first : (F, 2) starting places, tried in order
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
            open_at = seed[0] + (seed[1] - seed[0]) * share
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
                found = free_of(sx, sy, seed[1] * seed[1], mx, my, spacing, head, follow, xy, line, at, -1, 0, 0)
        if not found:
            break
        begin = n
        # Every line ends at another nearness, so that where lines draw together they do not all end in one place.
        near2 = (near[0] + (near[1] - near[0]) * uniform(np.uint64(key), np.uint64(count + trial))) ** 2
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
    xy: Any,
    line: Any,
    grid: Any,
    left: Any,
    top: Any,
    cell: Any,
    x0: Any,
    y0: Any,
    spacing: Any,
    rounds: Any,
    share: Any,
) -> Any:
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


def even_out(
    xy: Array, line: Array, area: Any, spacing: float, grid: Array, left: float, top: float, cell: float
) -> Array:
    """Points moved across their lines so that thread per area becomes the same everywhere: (P, 2).

    In cells of 2 mm the displacement u is sought with n n : grad u = density / wanted - 1 (n across the lines), smooth
    along the lines and small (least squares): where lines crowd they spread, without an end more or less.
    """
    import shapely
    from scipy.sparse import coo_matrix, diags, hstack, identity, vstack
    from scipy.sparse.linalg import cg

    from tambour.embroidery.facts import density_map

    size = max(2.0, 5 * spacing)
    x0, y0, x1, y1 = area.bounds
    x0, y0 = x0 - size, y0 - size
    bounds = (x0, y0, x1 + size, y1 + size)
    rows, columns = max(1, math.ceil((bounds[3] - y0) / size)), max(1, math.ceil((bounds[2] - x0) / size))
    if rows * columns > 40_000:
        return xy
    gx, gy = np.meshgrid(x0 + size * np.arange(columns), y0 + size * np.arange(rows))
    shapely.prepare(area)
    boxes = shapely.box(gx, gy, gx + size, gy + size)
    touched = shapely.intersects(area, boxes)
    index = np.full((rows, columns), -1)
    index[touched] = np.arange(touched.sum())
    n = int(touched.sum())

    def difference(axis: int) -> Any:
        """Central differences between touched cells, one-sided at the rim."""
        i, j, v = [], [], []
        low, high = np.full_like(index, -1), np.full_like(index, -1)
        if axis == 0:
            low[:, 1:], high[:, :-1] = index[:, :-1], index[:, 1:]
        else:
            low[1:], high[:-1] = index[:-1], index[1:]
        me, lo, hi = index[touched], low[touched], high[touched]
        a, b = np.where(lo >= 0, lo, me), np.where(hi >= 0, hi, me)
        gap = ((lo >= 0).astype(float) + (hi >= 0)) * size
        w = np.where(gap > 0, 1 / np.maximum(gap, 1e-9), 0)
        i, j, v = np.r_[me, me], np.r_[b, a], np.r_[w, -w]
        return coo_matrix((v, (i, j)), shape=(n, n)).tocsr()

    dx, dy = difference(0), difference(1)
    middle = np.c_[gx[touched], gy[touched]] + size / 2
    tangent = directions(grid, left, top, cell, np.ascontiguousarray(middle))
    tx, ty = diags(tangent[:, 0]), diags(tangent[:, 1])
    nx, ny = diags(-tangent[:, 1]), diags(tangent[:, 0])
    across = nx @ dx + ny @ dy
    along = tx @ dx + ty @ dy
    spread = hstack([nx @ across, ny @ across])
    zero = coo_matrix((n, n))
    smooth = vstack([hstack([along, zero]), hstack([zero, along])])
    rough = vstack([hstack([dx, zero]), hstack([dy, zero]), hstack([zero, dx]), hstack([zero, dy])])
    slide = hstack([tx, ty])
    left_side = (
        spread.T @ spread
        + 0.3 * smooth.T @ smooth
        + ROUGH * rough.T @ rough
        + 0.02 * slide.T @ slide
        + 1e-4 * identity(2 * n)
    ).tocsr()
    scale = diags(1 / left_side.diagonal())
    inner = shapely.contains(area, boxes)[touched]
    wanted = 1 / spacing
    same = np.flatnonzero(np.diff(line) == 0)
    fine = size / 8
    j, i = np.meshgrid(np.arange(8 * columns) // 8, np.arange(8 * rows) // 8)
    wet = shapely.contains_xy(
        area.buffer(spacing),
        *(
            g.reshape(-1)
            for g in np.meshgrid(x0 + fine * (np.arange(8 * columns) + 0.5), y0 + fine * (np.arange(8 * rows) + 0.5))
        ),
    )
    share = np.bincount((i * columns + j).reshape(-1), wet, rows * columns).reshape(rows, columns)[touched] / 64
    pieces = np.c_[xy[same], xy[same + 1]]
    thread = density_map(pieces, np.ones(len(pieces)), bounds, size)[:rows, :columns][touched]
    excess = np.clip(
        np.where(inner, thread / wanted - 1, np.where(share > 0.5, thread / (share * wanted) - 1, 0)), -0.5, 0.5
    )
    u = cg(left_side, spread.T @ excess, rtol=1e-3, maxiter=120, M=scale)[0].reshape(2, n).T * 0.9
    field_of = np.zeros((rows, columns, 2))
    field_of[touched] = u
    return xy + _sample(field_of, (xy - [x0 + size / 2, y0 + size / 2]) / size)


def _sample(values: Array, at: Array) -> Array:
    """Bilinear values (P, k) of a grid (rows, columns, k) at (column, row) places."""
    rows, columns = values.shape[:2]
    j = np.clip(at[:, 0].astype(int), 0, max(columns - 2, 0))
    i = np.clip(at[:, 1].astype(int), 0, max(rows - 2, 0))
    f, g = np.clip(at[:, 0] - j, 0, 1)[:, None], np.clip(at[:, 1] - i, 0, 1)[:, None]
    j1, i1 = np.minimum(j + 1, columns - 1), np.minimum(i + 1, rows - 1)
    return (1 - g) * ((1 - f) * values[i, j] + f * values[i, j1]) + g * ((1 - f) * values[i1, j] + f * values[i1, j1])


@kernel
def directions(grid: Any, left: Any, top: Any, cell: Any, at: Any) -> Any:
    """The field's direction (P, 2) at many places."""
    out = np.empty_like(at)
    for k in range(len(at)):
        out[k, 0], out[k, 1] = direction(grid, left, top, cell, at[k, 0], at[k, 1], 1.0, 0.0)
    return out


def flow(area: Any, spacing: float, guide: Paths | None, angle: float, seed: str) -> list[Array]:
    """Streamlines that fill a shapely polygon evenly, ``spacing`` mm apart on average, as polylines (n, 2)."""
    from tambour.embroidery.net import clipped

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
        grid, left, top, cell, mask, bounds[0], bounds[1], fine, pitch, step, (NEAR[0] * pitch, NEAR[1] * pitch), (SEED[0] * pitch, SEED[1] * pitch),
        np.ascontiguousarray(np.concatenate([c, spread])), most, np.uint64(name_key(seed, "flow ends")),
    )  # fmt: skip
    relax(xy, line, grid, left, top, cell, bounds[0] - wide, bounds[1] - wide, spacing, ROUNDS, 0.3)
    xy = even_out(xy, line, area, spacing, grid, left, top, cell)
    cuts = np.flatnonzero(np.diff(line)) + 1
    return clipped([p for p in np.split(xy, cuts) if len(p) > 2], area)

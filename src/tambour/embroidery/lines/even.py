"""Evening out: lines moved sideways until thread per area is the same everywhere."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from tambour.core.check import Array
from tambour.embroidery.lines.field import directions

ROUGH = 0.1  # how much an uneven push is held against it


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

    from tambour.embroidery.lines.density import density_map

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

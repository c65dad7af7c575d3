"""Fields of directions: along guide lines, or gently swinging; a direction has no sense, so angles are doubled."""

from __future__ import annotations

import math

import numpy as np

from tambour.core.arrays import F8x2, F8x3
from tambour.core.check import Array
from tambour.core.kernels import kernel
from tambour.core.paths import Paths
from tambour.noise import stream

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
def direction(
    grid: F8x3, left: float, top: float, cell: float, x: float, y: float, px: float, py: float
) -> tuple[float, float]:
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
def directions(grid: F8x3, left: float, top: float, cell: float, at: F8x2) -> F8x2:
    """The field's direction (P, 2) at many places."""
    out = np.empty_like(at)
    for k in range(len(at)):
        out[k, 0], out[k, 1] = direction(grid, left, top, cell, at[k, 0], at[k, 1], 1.0, 0.0)
    return out

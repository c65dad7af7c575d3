"""Thread on cloth: points bound and moved a second, against plain NumPy and SciPy in the same run.

    python bench/embroidery_cloth.py

Prints one table: millions of points a second (the best of five), and how many times the rows of the plain ways.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Any

import numpy as np

from tambour.core.mesh import Binding
from tambour.embroidery.cloth.bind import bind_nearest, bind_ray, crossings, deform, net
from tambour.embroidery.cloth.thread import curves
from tambour.geometry.closest import nearest, tree
from tambour.geometry.surface import vertex_normals


def best(work: Callable[[], Any], times: int = 5) -> float:
    work()
    made = []
    for _ in range(times):
        start = time.perf_counter()
        work()
        made.append(time.perf_counter() - start)
    return min(made)


def cloth(n: int = 71, size: float = 120.0) -> tuple[np.ndarray, np.ndarray]:
    """A wavy sheet of 2·(n - 1)² triangles (9,800 for 71)."""
    side = np.linspace(-size / 2, size / 2, n)
    x, y = np.meshgrid(side, side)
    v = np.stack([x, y, 6 * np.sin(x / 12) * np.cos(y / 17)], -1).reshape(-1, 3)
    at = np.arange(n * n).reshape(n, n)
    a, b, c, d = at[:-1, :-1].ravel(), at[:-1, 1:].ravel(), at[1:, 1:].ravel(), at[1:, :-1].ravel()
    return v, np.vstack([np.c_[a, b, c], np.c_[a, c, d]])


def plain_move(b: Binding, v: np.ndarray, f: np.ndarray, n: np.ndarray) -> np.ndarray:
    """What a good NumPy user writes for the ride."""
    w = np.column_stack([1 - b.uv.sum(axis=1), b.uv])
    face = f[b.face]
    up = np.einsum("qi,qik->qk", w, n[face])
    up *= (b.elevation / np.linalg.norm(up, axis=1))[:, None]
    return np.einsum("qi,qik->qk", w, v[face]) + up


def main() -> None:
    v, f = cloth()
    normals = vertex_normals(v, f)
    corner = v[f]
    y = np.repeat(np.arange(-50, 50, 0.1), 33)
    x = np.tile(np.arange(-50, 49, 3.0), 1000)
    a = np.stack([x, y], axis=1)
    b = a + np.array([3.0, 0.0])

    def laid() -> Any:
        return net(corner[..., :2], corner[..., 2], np.arange(len(f)), f)

    made_net = laid()
    cuts = crossings(made_net, a, b)
    made = curves(a, b, radius=0.2, cuts=cuts)
    bound = bind_ray(made_net, made.plan, made.height)
    count = len(made.plan)
    out = deform(bound, f, v, normals)
    some = np.arange(0, count, 2)
    points = out[some]
    box = tree(v, f)

    rows: list[tuple[str, int, float, str]] = []

    def row(name: str, n: int, seconds: float, against: tuple[int, float] | None = None) -> None:
        ratio = "" if against is None else f"{(n / seconds) / (against[0] / against[1]):8.1f} x"
        rows.append((name, n, n / seconds / 1e6, ratio))

    few = made.plan[:: max(1, count // 20_000)]
    t_find = best(lambda: find_plainly(few, corner), 2)
    row("find faces, NumPy (every triangle per block)", len(few), t_find)
    row(
        "net of the cloth and bind by ray",
        count,
        best(lambda: bind_ray(laid(), made.plan, made.height)),
        (len(few), t_find),
    )
    row("bind by ray", count, best(lambda: bind_ray(made_net, made.plan, made.height)), (len(few), t_find))
    t_centres = best(lambda: nearest_centres(v, f, points), 2)
    row("nearest centre of a face, SciPy tree (not exact)", len(points), t_centres)
    row("nearest point", len(points), best(lambda: nearest(box, points), 3), (len(points), t_centres))
    row(
        "bind by nearest point, tree and all",
        len(points),
        best(lambda: bind_nearest(v, f, normals, points), 3),
        (len(points), t_centres),
    )
    t_move = best(lambda: plain_move(bound, v, f, normals), 3)
    row("move, NumPy einsum", count, t_move)
    row("move", count, best(lambda: deform(bound, f, v, normals, out)), (count, t_move))
    row(
        "vertex normals and move (a frame)",
        count,
        best(lambda: deform(bound, f, v, vertex_normals(v, f), out)),
        (count, t_move),
    )
    row("cut at faces and lay curves", count, best(lambda: curves(a, b, radius=0.2, cuts=crossings(made_net, a, b))))

    on = deform(Binding(bound.face, bound.uv, np.zeros(count)), f, v, normals)
    error = np.abs(np.linalg.norm(out - on, axis=1) - np.abs(bound.elevation)).max()
    print(f"{len(f):,} triangles, {len(a):,} stitches, {count:,} points, thread 0.4 mm")
    for name, n, rate, ratio in rows:
        print(f"{name:<52}{n:>10,} points {rate:9.3f} M/s {ratio}")
    print(f"largest error of the elevation: {error:.1e} mm")
    print(f"largest error of a point bound by nearest: {nearest_error(v, f, normals, points):.1e} mm")


def find_plainly(points: np.ndarray, corner: np.ndarray) -> np.ndarray:
    """The faces of points by trying every triangle, block by block."""
    a, e, g = corner[:, 0, :2], corner[:, 1, :2] - corner[:, 0, :2], corner[:, 2, :2] - corner[:, 0, :2]
    det = e[:, 0] * g[:, 1] - e[:, 1] * g[:, 0]
    found = np.empty(len(points), np.int64)
    for k in range(0, len(points), 500):
        d = points[k : k + 500, None] - a
        u = (d[..., 0] * g[:, 1] - d[..., 1] * g[:, 0]) / det
        w = (e[:, 0] * d[..., 1] - e[:, 1] * d[..., 0]) / det
        found[k : k + 500] = np.minimum(np.minimum(u, w), 1 - u - w).argmax(axis=1)
    return found


def nearest_centres(v: np.ndarray, f: np.ndarray, points: np.ndarray) -> np.ndarray:
    from scipy.spatial import cKDTree

    return np.asarray(cKDTree(v[f].mean(axis=1)).query(points)[1])


def nearest_error(v: np.ndarray, f: np.ndarray, normals: np.ndarray, points: np.ndarray) -> float:
    back = deform(bind_nearest(v, f, normals, points), f, v, normals)
    return float(np.linalg.norm(back - points, axis=1).max())


if __name__ == "__main__":
    main()

"""Ground: the fabric with all the yarn on it, as something to lay eyes, thread, felt and hair on."""

from __future__ import annotations

from dataclasses import dataclass, field
from itertools import pairwise

import numpy as np

from tambour.core.arrays import F8x1, F8x2, I8x1
from tambour.core.check import Array
from tambour.core.kernels import kernel
from tambour.core.strands import Strands
from tambour.geometry.closest import Tree, nearest, tree
from tambour.geometry.motion import length
from tambour.geometry.surface import vertex_normals

LIFT = 0.93
"""Quantile of the yarn's heights over the fabric that counts as its top where something only rests on it."""


@dataclass(eq=False)
class Ground:
    """The fabric's surface and what lies on it; all in mm.

    triangles : of the fabric; faces (F, 3), normals (V, 3) at its vertices
    balls : (B, 4) middle and radius of balls that the yarn, and what was laid on it, are made of
    stitch : the stitch's width
    lift : how high the yarn's top lies over the fabric's surface
    """

    triangles: Tree
    faces: Array
    normals: Array
    balls: Array
    stitch: float
    lift: float = 0.0
    laid: list[Array] = field(default_factory=list)

    def foot(self, points: Array) -> tuple[Array, Array, Array]:
        """For points (P, 3): the nearest places of the fabric (P, 3), its normals there, the heights over it (P,)."""
        face, uv, _ = nearest(self.triangles, points)
        corner = self.triangles.corner[face].reshape(-1, 3, 3)
        weight = np.stack([1 - uv.sum(1), uv[:, 0], uv[:, 1]], axis=1)[:, :, None]
        base = (weight * corner).sum(1)
        normal = unit((weight * self.normals[self.faces[face]]).sum(1))
        return base, normal, ((points - base) * normal).sum(1)

    def top(self, points: Array, normals: Array, reach: float | None = None) -> Array:
        """How high over points (P, 3) of the fabric, along ``normals``, yarn and what was laid on it reach (P,).

        reach : what is higher than this belongs to another part that stands there; None takes 1.3 stitches
        """
        reach = 1.3 * self.stitch if reach is None else reach
        middle = points.mean(0)
        far = float(np.sqrt(((points - middle) ** 2).sum(1).max())) + reach + 0.5 * self.stitch
        out = np.full(len(points), -np.inf)
        for balls in (self.balls, *self.laid):
            near = balls[_within(balls, middle, far)]
            _over(np.ascontiguousarray(points), np.ascontiguousarray(normals), near, reach, -0.6 * self.stitch, out)
        return np.where(np.isfinite(out), out, self.lift)

    def covered(self, points: Array, normals: Array) -> Array:
        """How high over places (P, 3) of the fabric what was laid on it reaches (P,); 0 where nothing lies."""
        out = np.zeros(len(points))
        for balls in self.laid:
            _over(np.ascontiguousarray(points), np.ascontiguousarray(normals), balls, 1.3 * self.stitch, -np.inf, out)
        return out

    def lay(self, points: Array, radius: float | Array) -> None:
        """What is laid later lies on balls about ``points`` (P, 3) too."""
        self.laid.append(np.column_stack([points, np.broadcast_to(radius, len(points))]))

    def walk(self, point: Array, directions: Array, distance: Array) -> tuple[Array, Array]:
        """Straight walks over the fabric: places and normals (D, S, 3) after ``distance`` (D, S) mm, rising.

        point : (3,) the start, on the fabric; directions : (D, 3), about along it
        """
        count = len(directions)
        base, normal, _ = self.foot(np.repeat(point[None], count, 0))
        heading = unit(directions - (directions * normal).sum(1, keepdims=True) * normal)
        places, normals = np.zeros((*distance.shape, 3)), np.zeros((*distance.shape, 3))
        gone = np.zeros(count)
        for s in range(distance.shape[1]):
            ahead = distance[:, s] - gone
            pieces = max(1, int(np.ceil(ahead.max() / (0.25 * self.stitch))))
            for _ in range(pieces):
                base, normal, _ = self.foot(base + heading * (ahead / pieces)[:, None])
                heading = unit(heading - (heading * normal).sum(1, keepdims=True) * normal)
            gone = distance[:, s]
            places[:, s], normals[:, s] = base, normal
        return places, normals

    def line(self, points: Array, step: float) -> tuple[Array, Array]:
        """A line over the fabric through ``points`` (K, 3), K ≥ 2: places (P, 3) about ``step`` mm apart, normals."""
        runs: list[Array] = []
        for a, b in pairwise(points):
            count = max(2, int(np.ceil(length(b - a) / step)) + 1)
            run = a + (b - a) * np.linspace(0, 1, count)[:, None]
            for _ in range(3):  # drawn tight within the fabric
                run[1:-1] = 0.25 * run[:-2] + 0.5 * run[1:-1] + 0.25 * run[2:]
                run[1:-1] = self.foot(run[1:-1])[0] if count > 2 else run[1:-1]
            runs.append(run if not runs else run[1:])
        whole = np.concatenate(runs)
        return whole, self.foot(whole)[1]


def ground(vertices: Array, faces: Array, yarn: Strands, stitch: float) -> Ground:
    """The ground of a fabric (V, 3), (F, 3) with its ``yarn``; stitch : the stitch's width, mm."""
    faces = np.ascontiguousarray(faces, np.int32)
    normals = vertex_normals(vertices, faces)
    made = Ground(tree(vertices, faces), faces, normals, balls(yarn), stitch)
    used = np.unique(faces)
    some = used[:: max(1, len(used) // 400)]
    rise = np.full(len(some), -np.inf)
    near = np.ascontiguousarray(made.balls[:: max(1, len(made.balls) // 60_000)])
    _over(np.ascontiguousarray(vertices[some]), np.ascontiguousarray(normals[some]), near, stitch, 0.0, rise)
    rise = rise[np.isfinite(rise)]
    made.lift = float(np.quantile(rise, LIFT)) if len(rise) else 0.5 * stitch
    return made


def balls(yarn: Strands) -> Array:
    """Balls (B, 4) along strands, no further apart than half their radius."""
    coords, ends, radius = yarn.paths.coords, yarn.paths.offsets, yarn.radius
    if not len(coords):
        return np.zeros((0, 4))
    step = np.zeros(len(coords))
    step[:-1] = length(np.diff(coords, axis=0))
    step[ends[1:][ends[1:] > 0] - 1] = 0.0
    times = np.maximum(1, np.ceil(step / (0.5 * radius))).astype(np.int64)
    begin = np.concatenate([[0], np.cumsum(times)])
    of = np.repeat(np.arange(len(coords)), times)
    part = ((np.arange(len(of)) - begin[of]) / times[of])[:, None]
    after = np.minimum(of + 1, len(coords) - 1)
    return np.column_stack([(1 - part) * coords[of] + part * coords[after], radius[of]])


def unit(v: Array) -> Array:
    """Rows (P, 3) as unit vectors; zero stays zero."""
    length = np.sqrt((v**2).sum(-1, keepdims=True))
    return np.asarray(np.divide(v, length, out=np.zeros_like(v), where=length > 1e-12))


@kernel
def _within(balls: F8x2, middle: F8x1, far: float) -> I8x1:
    """Numbers of the balls (B, 4) whose middles are less than ``far`` from ``middle`` (3,)."""
    found = np.empty(len(balls), np.int64)
    count = 0
    for b in range(len(balls)):
        dx, dy, dz = balls[b, 0] - middle[0], balls[b, 1] - middle[1], balls[b, 2] - middle[2]
        if dx * dx + dy * dy + dz * dz < far * far:
            found[count] = b
            count += 1
    return found[:count].copy()


@kernel
def _over(points: F8x2, normals: F8x2, balls: F8x2, reach: float, low: float, out: F8x1) -> None:
    """Raise ``out`` (P,) to the height over each point, along its normal, of the balls that stand there."""
    for p in range(len(points)):
        for b in range(len(balls)):
            dx, dy, dz = balls[b, 0] - points[p, 0], balls[b, 1] - points[p, 1], balls[b, 2] - points[p, 2]
            rise = dx * normals[p, 0] + dy * normals[p, 1] + dz * normals[p, 2]
            if rise <= out[p] - balls[b, 3] or rise > reach or rise < low:
                continue
            beside = balls[b, 3] * balls[b, 3] - (dx * dx + dy * dy + dz * dz - rise * rise)
            if beside > 0.0:
                out[p] = max(out[p], rise + beside**0.5)

"""Distance: how far one surface lies from another, laid upon each other by a turn and a shift, never scaled."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from tambour.core.check import Array
from tambour.geometry.closest import Tree, nearest, tree
from tambour.geometry.motion import eigen, fit, turned
from tambour.geometry.surface import face_normals

SAMPLES = 2000
"""Points on each of the two surfaces that are measured from."""
SPARED = 4
"""Of so many points one is enough to lay the surfaces upon each other."""
TURNS = 12
"""How often the surfaces are laid upon each other anew, at the most."""
STILL = 2e-5
"""A move of this share of the size, rms, and less, ends that."""
SOFT = 1e-6
"""What a way that changes no distance (a ball turned) weighs, against the stiffest: it is not gone."""


@dataclass(frozen=True, eq=False, slots=True)
class Distance:
    """How far two surfaces lie from each other, in the unit of the points, each from the other.

    mean, p95, largest : over points even on both; size : the diagonal of the target's box
    turn (3, 3), shift (3,) : what brings the made surface upon the target: turn x + shift
    """

    mean: float
    p95: float
    largest: float
    size: float
    turn: Array
    shift: Array

    def plain(self, unit: float = 1.0) -> dict[str, float]:
        """As reports hold it: in stitches of ``unit``, and in per cent of the size."""
        per = 100.0 / max(self.size, 1e-12)
        return {
            "mean": round(self.mean / unit, 4),
            "p95": round(self.p95 / unit, 4),
            "largest": round(self.largest / unit, 4),
            "mean_percent": round(self.mean * per, 3),
            "p95_percent": round(self.p95 * per, 3),
            "largest_percent": round(self.largest * per, 3),
        }


@dataclass(frozen=True, eq=False, slots=True)
class Target:
    """A surface to be measured against, again and again: its triangles, points even on it, and a tree to find them by."""

    vertices: Array
    faces: Array
    points: Array
    normals: Array
    tree: Tree
    size: float

    @classmethod
    def of(cls, vertices: Array, faces: Array, samples: int = SAMPLES) -> Target:
        """The target of a mesh with vertices (V, 3) and faces (F, 3), F ≥ 1."""
        vertices = np.ascontiguousarray(vertices, np.float64)
        size = float(np.sqrt((np.ptp(vertices[np.unique(faces)], axis=0) ** 2).sum()))
        return cls(
            vertices,
            faces,
            spread(vertices, faces, samples),
            face_normals(vertices, faces),
            tree(vertices, faces),
            size,
        )


def spread(vertices: Array, faces: Array, count: int) -> Array:
    """Points (count, 3) even over a mesh, always the same: an equal share of the area each, by the golden ratios within."""
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    area = np.sqrt((np.cross(b - a, c - a) ** 2).sum(1))
    upto = np.cumsum(area)
    at = (np.arange(count) + 0.5) / count * upto[-1]
    face = np.minimum(np.searchsorted(upto, at), len(faces) - 1)
    k = np.arange(count)
    u, v = (0.5 + 0.7548776662466927 * k) % 1.0, (0.5 + 0.5698402909980532 * k) % 1.0
    over = u + v > 1.0
    u, v = np.where(over, 1.0 - u, u)[:, None], np.where(over, 1.0 - v, v)[:, None]
    return a[face] + u * (b - a)[face] + v * (c - a)[face]


def distance(
    target: Target,
    vertices: Array,
    faces: Array,
    start: tuple[Array, Array] | None = None,
    samples: int = SAMPLES,
    moves: bool = True,
) -> Distance:
    """How far the surface of ``vertices`` (V, 3) and ``faces`` (F, 3) lies from ``target``, laid upon it as near as may be.

    start : a turn and a shift to begin with, such as :func:`tambour.geometry.motion.fit` gives of nodes and where they
        belong; None: as they lie. moves : whether it is moved from there at all
    """
    turn, shift = (np.eye(3), np.zeros(3)) if start is None else start
    vertices = np.ascontiguousarray(vertices, np.float64)
    own = spread(vertices, faces, samples)
    made = tree(vertices, faces)
    corners, normals = vertices[faces], face_normals(vertices, faces)
    near: tuple[Array | None, Array | None] = (None, None)
    some, aims = own[::SPARED], target.points[::SPARED]
    for _ in range(TURNS if moves else 0):
        lain = turned(some, turn) + shift
        face, uv, there = nearest(target.tree, lain, near[0])
        seen, at, back = nearest(made, turned(aims - shift, turn.T), near[1])
        near = face, seen
        goal = _point(target.vertices[target.faces[face]], uv)
        moving = turned(np.concatenate([some, _point(corners[seen], at)]), turn) + shift
        fixed = np.concatenate([goal, aims])
        out = np.concatenate([target.normals[face], turned(normals[seen], turn)])
        # What lies far off is another limb, or none: it shall not turn the whole.
        far = np.concatenate([there, back])
        new, to = slid(moving, fixed, out, 1.0 / np.maximum(far, np.median(far) + 1e-12))
        moved = math.sqrt(float((((turned(lain, new) + to) - lain) ** 2).sum(1).mean()))
        turn, shift = new @ turn, turned(shift, new) + to
        if moved < STILL * target.size:
            break
    there = nearest(target.tree, turned(own, turn) + shift)[2]
    back = nearest(made, turned(target.points - shift, turn.T))[2]
    every = np.concatenate([there, back])
    return Distance(
        0.5 * (float(there.mean()) + float(back.mean())),
        float(np.quantile(every, 0.95)),
        float(every.max()),
        target.size,
        turn,
        shift,
    )


def facing_points(target: Target, x: Array, faces: Array) -> tuple[Array, Array, Array, Array]:
    """Where a made surface and ``target`` face each other, seen from either: points (P, 3) of the made one, the node (P,) that each is
    at, and the points (P, 3) of the target nearest to them with their normals."""
    face, uv, _ = nearest(target.tree, x)
    seen, at, _ = nearest(tree(x, faces), target.points)
    own, _, _ = nearest(target.tree, target.points)
    return (
        np.concatenate([x, _point(x[faces[seen]], at)]),
        np.concatenate([np.arange(len(x)), faces[seen, 0]]),
        np.concatenate([_point(target.vertices[target.faces[face]], uv), target.points]),
        np.concatenate([target.normals[face], target.normals[own]]),
    )


def outside(target: Target, points: Array) -> Array:
    """How far (N,) points (N, 3) lie outside of ``target``; inside is negative."""
    face, uv, far = nearest(target.tree, points)
    at = _point(target.vertices[target.faces[face]], uv)
    return np.asarray(far * np.sign(((points - at) * target.normals[face]).sum(1)))


def slid(moving: Array, fixed: Array, out: Array, weight: Array) -> tuple[Array, Array]:
    """The turn and shift that bring points ``moving`` nearest to planes through ``fixed`` with normals ``out``, all (K, 3).

    Chen and Medioni, "Object modelling by registration of multiple range images" (1992): points may slide along the
    planes, so few turns are needed. The step is that of small angles, as a true rotation.
    """
    middle = moving.mean(0)
    arm = moving - middle
    terms = np.column_stack([np.cross(arm, out), out])
    miss = ((fixed - moving) * out).sum(1) * weight
    value, rows = eigen((weight[:, None, None] * terms[:, :, None] * terms[:, None, :]).sum(0))
    right = (terms * miss[:, None]).sum(0)
    step = ((rows * right).sum(1) / (value + SOFT * value[0]) * rows.T).sum(1)
    goal = arm + np.cross(step[:3], arm)
    turn, _ = fit(arm, goal, np.ones(len(arm)))
    return turn, middle + step[3:] - turned(middle, turn)


def _point(corners: Array, uv: Array) -> Array:
    """The points (P, 3) at weights ``uv`` (P, 2) of the second and third of corners (P, 3, 3)."""
    u, v = uv[:, :1], uv[:, 1:]
    return np.asarray((1.0 - u - v) * corners[:, 0] + u * corners[:, 1] + v * corners[:, 2])

"""What moves in a glTF file: nodes, morph targets and skins, sampled into frames (glTF 2.0, 3.7.3, 3.11, appendix C)."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from tambour.core.check import Array
from tambour.core.mesh import Mesh

RATE = 24
"""Frames per second where a file's own key times are not evenly spaced."""
_MOST = 20_000

Accessor = Callable[[int], Array]
Pose = dict[tuple[int, str], Array]


@dataclass(frozen=True, slots=True)
class _Track:
    """One animated property of a node: key times (K,) and values (K, …), or (3K, …) where they are cubic."""

    node: int
    path: str
    times: Array
    values: Array
    kind: str

    def at(self, t: float) -> Array:
        times = self.times
        k = int(np.clip(np.searchsorted(times, t, side="right") - 1, 0, len(times) - 1))
        if self.kind == "CUBICSPLINE":
            v = self.values.reshape(3 * len(times), -1)
            if k + 1 >= len(times) or t <= times[k]:
                return np.asarray(v[3 * k + 1])
            d = times[k + 1] - times[k]
            s = (t - times[k]) / d
            a, b = 2 * s**3 - 3 * s**2 + 1, s**3 - 2 * s**2 + s
            c, e = -2 * s**3 + 3 * s**2, s**3 - s**2
            made = a * v[3 * k + 1] + d * b * v[3 * k + 2] + c * v[3 * k + 4] + d * e * v[3 * k + 3]
            return np.asarray(made / np.linalg.norm(made) if self.path == "rotation" else made)
        v = self.values.reshape(len(times), -1)
        if self.kind == "STEP" or k + 1 >= len(times) or t <= times[k]:
            return np.asarray(v[k])
        s = (t - times[k]) / (times[k + 1] - times[k])
        if self.path != "rotation":
            return np.asarray(v[k] + s * (v[k + 1] - v[k]))
        a, b = v[k], v[k + 1]
        dot = float(a @ b)
        b, dot = (-b, -dot) if dot < 0 else (b, dot)
        if dot > 0.9995:
            made = a + s * (b - a)
        else:
            angle = np.arccos(dot)
            made = (np.sin((1 - s) * angle) * a + np.sin(s * angle) * b) / np.sin(angle)
        return np.asarray(made / np.linalg.norm(made))


def with_motion(mesh: Mesh, head: dict[str, Any], accessor: Accessor) -> Mesh:
    """The mesh that was read from a file's scene, with the frames of the file's first animation; as it is without one.

    accessor : index → values (N, width)
    """
    if not head.get("animations"):
        return mesh
    tracks = []
    animation = head["animations"][0]
    for channel in animation["channels"]:
        if "node" not in channel["target"]:
            continue
        sampler = animation["samplers"][channel["sampler"]]
        times = accessor(sampler["input"])[:, 0].astype(np.float64)
        values = accessor(sampler["output"]).astype(np.float64)
        if not len(times) or (np.diff(times) < 0).any():
            raise ValueError("an animation's times do not rise")
        kind = sampler.get("interpolation", "LINEAR")
        tracks.append(_Track(channel["target"]["node"], channel["target"]["path"], times, values, kind))
    if not tracks:
        return mesh
    times, step = _times(tracks)
    parts = _parts(head, accessor)
    if len(times) < 2 or sum(len(p[2]) for p in parts) != len(mesh.vertices):
        return mesh

    def frames() -> Iterator[Array]:
        for t in times:
            yield _pose(head, accessor, parts, {(k.node, k.path): k.at(float(t)) for k in tracks})

    rest = _pose(head, accessor, parts, {})
    for t in (times[0], times[-1]):  # what is broken shall break here, not while frames are made
        if not np.isfinite(_pose(head, accessor, parts, {(k.node, k.path): k.at(float(t)) for k in tracks})).all():
            raise ValueError("its animation leads to no place")
    return replace(mesh, vertices=rest, frames=frames, frame_count=len(times), seconds_per_frame=step)


def _times(tracks: list[_Track]) -> tuple[Array, float]:
    """The frames' times: the keys' own when they are even, else RATE a second."""
    keys = np.unique(np.concatenate([k.times for k in tracks]).round(5))
    step = np.diff(keys)
    if len(keys) > 2 and step.max() < 1.02 * step.min() and len(keys) <= _MOST:
        return keys, float(step.mean())
    span = float(keys[-1] - keys[0])
    count = int(min(_MOST, max(2, round(span * RATE) + 1)))
    return np.linspace(keys[0], keys[-1], count), span / (count - 1) if span > 0 else 1 / RATE


def _parts(head: dict[str, Any], accessor: Accessor) -> list[tuple[int, dict[str, Any], Array]]:
    """(node, primitive, points) in the order in which the scene's reader joins them."""
    nodes, scenes = head.get("nodes", []), head.get("scenes")
    roots = scenes[head.get("scene", 0)].get("nodes", []) if scenes else range(len(nodes))
    stack = list(reversed(list(roots)))
    made: list[tuple[int, dict[str, Any], Array]] = []
    while stack and len(made) < 100_000:
        index = stack.pop()
        node = nodes[index]
        stack += list(reversed(node.get("children", [])))
        for primitive in head["meshes"][node["mesh"]]["primitives"] if "mesh" in node else ():
            points = accessor(primitive["attributes"]["POSITION"]).astype(np.float64)
            size = len(points) if "indices" not in primitive else head["accessors"][primitive["indices"]]["count"]
            if primitive.get("mode", 4) in (4, 5, 6) and size >= 3:
                made.append((index, primitive, points))
    return made


def _local(node: dict[str, Any], index: int, pose: Pose) -> Array:
    if "matrix" in node and not any((index, p) in pose for p in ("translation", "rotation", "scale")):
        return np.array(node["matrix"], np.float64).reshape(4, 4).T
    x, y, z, w = pose.get((index, "rotation"), node.get("rotation", (0, 0, 0, 1)))
    made = np.eye(4)
    made[:3, :3] = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
    ]
    made[:3, :3] *= np.asarray(pose.get((index, "scale"), node.get("scale", (1, 1, 1))))
    made[:3, 3] = pose.get((index, "translation"), node.get("translation", (0, 0, 0)))
    return made


def _pose(
    head: dict[str, Any], accessor: Accessor, parts: list[tuple[int, dict[str, Any], Array]], pose: Pose
) -> Array:
    """All points of the scene (V, 3), mm, in a pose."""
    nodes = head["nodes"]
    above = {c: k for k, node in enumerate(nodes) for c in node.get("children", [])}
    cache: dict[int, Array] = {}

    def world(k: int) -> Array:
        chain = [k]
        while chain[-1] in above and above[chain[-1]] not in cache and len(chain) < 500:
            chain.append(above[chain[-1]])
        for j in reversed(chain):
            own = _local(nodes[j], j, pose)
            cache[j] = cache[above[j]] @ own if j in above and above[j] in cache else own
        return cache[k]

    made = []
    for index, primitive, points in parts:
        node = nodes[index]
        moved = points
        if primitive.get("targets"):
            default = node.get(
                "weights", head["meshes"][node["mesh"]].get("weights", [0.0] * len(primitive["targets"]))
            )
            for weight, target in zip(pose.get((index, "weights"), default), primitive["targets"]):
                if weight and "POSITION" in target:
                    moved = moved + weight * accessor(target["POSITION"])
        if "skin" in node and "JOINTS_0" in primitive["attributes"]:
            skin = head["skins"][node["skin"]]
            joints = np.stack([world(j) for j in skin["joints"]])
            if "inverseBindMatrices" in skin:
                bind = accessor(skin["inverseBindMatrices"]).astype(np.float64).reshape(-1, 4, 4)
                joints = joints @ bind.transpose(0, 2, 1)
            which = accessor(primitive["attributes"]["JOINTS_0"]).astype(np.int64)
            share = accessor(primitive["attributes"]["WEIGHTS_0"]).astype(np.float64)
            matrix = (share[:, :, None, None] * joints[which]).sum(axis=1)
            moved = np.einsum("vij,vj->vi", matrix[:, :3, :3], moved) + matrix[:, :3, 3]
        else:
            place = world(index)
            moved = moved @ place[:3, :3].T + place[:3, 3]
        made.append(moved * 1000)
    return np.concatenate(made)

"""Scenes as files: glTF with morph targets, OBJ (one a frame), NPZ, and a shaded picture.

glTF has no curves, so thread becomes tubes there and in OBJ files; USD (``files.usd``) and NPZ keep the curves.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from tambour.color import linear
from tambour.core.check import Array
from tambour.core.errors import TambourError
from tambour.core.mesh import Mesh
from tambour.core.paths import Paths
from tambour.core.scene import Scene
from tambour.core.strands import Strands
from tambour.files.glb import INDEX, VERTEX, Body
from tambour.files.sink import Sink
from tambour.geometry.surface import closed, vertex_normals
from tambour.geometry.tube import sweep

BUDGET = 50_000_000
"""Largest moving .glb, bytes: morph targets repeat every vertex in every frame."""


def positions(thing: Mesh | Strands) -> Iterator[Array]:
    """Every frame's points of a mesh or of strands, one at a time."""
    if isinstance(thing, Mesh):
        yield from thing.positions()
    elif thing.frames is None:
        yield thing.paths.coords
    else:
        yield from thing.frames()


def tubes(strands: Strands, sides: int) -> tuple[Mesh, Any]:
    """Strands as tubes without the ends that lie below the cloth, and a function from a frame's points to its tubes."""
    coords, offsets = strands.paths.coords, np.asarray(strands.paths.offsets)
    hole, share = np.arange(len(coords)), np.zeros(len(coords))
    if "height" in strands.point_data:
        # The end below the cloth is drawn back to the needle hole.
        count = np.diff(offsets)
        first, last = offsets[:-1][count > 3], offsets[1:][count > 3] - 1
        hole[first], hole[last] = first + 1, last - 1
        a = np.asarray(strands.point_data["height"], np.float64)
        below = (a < 0) & (a[hole] > a)
        share[below] = -a[below] / (a[hole] - a)[below]

    def shape(points: Array) -> Mesh:
        drawn = points + share[:, None] * (points[hole] - points)
        at = Strands(Paths(drawn, offsets), strands.radius, strands.color)
        return sweep(at, sides=sides, material="thread", side=_bends(points, offsets))

    return shape(coords), shape


def _bends(points: Array, offsets: Array) -> Array | None:
    """Where strands bend first, the direction across that bend (N, 3): it moves with the cloth. None for strands of
    fewer than four points."""
    if len(offsets) < 2 or np.diff(offsets).min() < 4:
        return None
    first = offsets[:-1]
    a, b, c = points[first], points[first + 1], points[first + 3]
    return np.asarray(np.cross(b - a, c - b))


def _material(name: str, color: Array | None, open_: bool) -> dict[str, Any]:
    """A material by its group's name: thread has the sheen of a textile."""
    thread = name == "thread"
    base = [1.0, 1.0, 1.0, 1.0] if color is None else [*np.round(linear(color / 255.0), 5).tolist(), 1.0]
    made: dict[str, Any] = {
        "name": name,
        "pbrMetallicRoughness": {
            "baseColorFactor": base,
            "metallicFactor": 0,
            "roughnessFactor": 0.5 if thread else 0.95,
        },
        "extensions": {
            "KHR_materials_sheen": {
                "sheenColorFactor": [0.35, 0.35, 0.35] if thread else [0.12, 0.12, 0.12],
                "sheenRoughnessFactor": 0.35 if thread else 0.8,
            }
        },
    }
    if open_:
        made["doubleSided"] = True
    return made


def write_glb(value: Scene, sink: Sink) -> None:
    """A .glb in metres: a node for each thing, tubes for strands, a morph target for every frame after the first.

    Raises TambourError when a moving scene needs more than BUDGET bytes with tubes of three sides and a target for every
    fourth frame.
    """
    moving = value.frame_count > 1
    sides, every = _affordable(value, sink) if moving else (6, 1)
    body = Body()
    nodes: list[dict[str, Any]] = []
    meshes: list[dict[str, Any]] = []
    materials: list[dict[str, Any]] = []
    channels: list[dict[str, Any]] = []
    samplers: list[dict[str, Any]] = []
    times = None
    for name, thing in zip(value.names, value.things):
        still, shape = (thing, None) if isinstance(thing, Mesh) else tubes(thing, sides)
        frames = (
            [still.vertices] if thing.frame_count == 1 and isinstance(thing, Mesh) and thing.frames is None else None
        )
        if frames is None:
            keys = set(_keys(value.frame_count, every))
            held = (p for k, p in enumerate(positions(thing)) if k in keys)
            frames = [p if shape is None else shape(p).vertices for p in held]
        kind = "cloth" if isinstance(thing, Mesh) else "thread"
        reach = max((float(np.abs(f - frames[0]).max()) for f in frames), default=1.0) or 1.0
        unit = reach if len(frames) > 1 else 1000.0  # mm in one unit of the node
        attributes = {
            "POSITION": body.add((frames[0] / unit).astype(np.float32), target=VERTEX, bounds=True),
            "NORMAL": body.add(_normals(frames[0], still.faces), target=VERTEX),
        }
        plain = None
        if still.color is not None and (still.color == still.color[:1]).all() and len(still.color):
            plain = still.color[0]
        elif still.color is not None:
            rgba = np.full((len(still.color), 4), 65535, np.uint16)
            rgba[:, :3] = np.round(linear(np.arange(256) / 255.0) * 65535).astype(np.uint16)[still.color]
            attributes["COLOR_0"] = body.add(rgba, target=VERTEX, normalized=True)
        # The cloth's uv has no texture to serve: viewers would carry it for nothing.
        index = np.uint16 if len(still.vertices) < 65535 else np.uint32
        primitive: dict[str, Any] = {
            "attributes": attributes,
            "indices": body.add(still.faces.ravel().astype(index), target=INDEX),
            "material": len(materials),
            "mode": 4,
        }
        mesh: dict[str, Any] = {"name": name, "primitives": [primitive]}
        node: dict[str, Any] = {"name": name, "mesh": len(meshes)}
        if unit != 1000.0:
            node["scale"] = [unit / 1000] * 3
        if len(frames) > 1:
            primitive["targets"] = _targets(body, frames, still.faces, unit)
            mesh["weights"] = [0.0] * (len(frames) - 1)
            if times is None:
                count = len(frames)
                keyed = np.array(_keys(value.frame_count, every))
                times = body.add((keyed * value.seconds_per_frame).astype(np.float32), bounds=True)
                one = body.add(np.eye(count, count - 1, -1, dtype=np.float32).ravel())
                samplers.append({"input": times, "output": one, "interpolation": "LINEAR"})
            channels.append({"sampler": 0, "target": {"node": len(nodes), "path": "weights"}})
        nodes.append(node)
        meshes.append(mesh)
        materials.append(_material(kind, plain, not closed(still.faces)))
    scene: dict[str, Any] = {
        "extensionsUsed": ["KHR_materials_sheen", *(["KHR_mesh_quantization"] if channels else [])],
        "scene": 0,
        "scenes": [{"nodes": list(range(len(nodes)))}],
        "nodes": nodes,
        "meshes": meshes,
        "materials": materials,
    }
    if channels:
        scene["extensionsRequired"] = ["KHR_mesh_quantization"]
        scene["animations"] = [{"name": "frames", "channels": channels, "samplers": samplers}]
    sink.put(body.file(scene))


def _keys(count: int, every: int) -> list[int]:
    """The frames that are written: every so many of ``count``, and the last."""
    return sorted({*range(0, count, every), count - 1})


def _affordable(value: Scene, sink: Sink) -> tuple[int, int]:
    """With how many sides of tubes, six to three, and with each how manyth frame, up to the fourth, a moving scene keeps
    to the budget; between two frames that are written a viewer moves everything straight."""
    for sides, every in ((6, 1), (5, 1), (4, 1), (3, 1), (5, 2), (4, 2), (3, 2), (3, 3), (3, 4)):
        need, written = 0, len(_keys(value.frame_count, every))
        for thing in value.things:
            if isinstance(thing, Mesh):
                vertices = len(thing.vertices)
            else:
                vertices = (len(thing.paths.coords) + 2 * len(thing.paths)) * sides + 2 * len(thing.paths)
            # Three shorts padded to eight bytes and a normal of three bytes padded to four, in every frame.
            need += vertices * (12 * (written - 1) + 44 + 12 * sides // 3)
        if need <= BUDGET:
            return sides, every
    raise TambourError(
        f"{value.frame_count} frames of this scene need about {need / 1e6:.0f} MB as .glb, more than {BUDGET / 1e6:.0f}",
        hint="write .usdc, which holds curves, or use fewer {--frames}",
        where=str(sink.path),
    )


def _normals(vertices: Array, faces: Array) -> Array:
    made = np.zeros((len(vertices), 3), np.float32)
    made[:] = vertex_normals(vertices, faces)
    return made


def _targets(body: Body, frames: list[Array], faces: Array, unit: float) -> list[dict[str, int]]:
    """Morph targets: differences from the first frame, positions in 16 bits of the node's unit, normals in 8."""
    first, normal = frames[0], vertex_normals(frames[0], faces)
    made = []
    for frame in frames[1:]:
        moved = np.round((frame - first) / unit * 32767).astype(np.int16)
        turned = np.round(np.clip(vertex_normals(frame, faces) - normal, -1, 1) * 127).astype(np.int8)
        made.append(
            {
                "POSITION": body.add(moved, target=VERTEX, bounds=True, normalized=True),
                "NORMAL": body.add(turned, target=VERTEX, normalized=True),
            }
        )
    return made


def joined(value: Scene, sides: int = 6) -> Iterator[Mesh]:
    """Every frame of a scene as one mesh, its things as groups "cloth" and "thread"."""
    shapes = [(t, None) if isinstance(t, Mesh) else tubes(t, sides) for t in value.things]
    moves = [positions(t) for t in value.things]
    last: list[Array] = []
    for _ in range(value.frame_count):
        last = [next(m, last[k] if last else np.zeros(0)) for k, m in enumerate(moves)]
        parts = []
        for (still, shape), points in zip(shapes, last):
            parts.append((still, points) if shape is None else (still, shape(points).vertices))
        yield _one(value, parts)


def _one(value: Scene, parts: list[tuple[Mesh, Array]]) -> Mesh:
    starts = np.cumsum([0, *(len(v) for _, v in parts)])
    grey = np.array([226, 221, 212], np.uint8)
    colors = [np.tile(grey, (len(v), 1)) if m.color is None else m.color for m, v in parts]
    uvs = [np.zeros((len(v), 2)) if m.uv is None else m.uv for m, v in parts]
    group = [np.full(len(m.faces), int(k >= len(value.meshes)), np.int32) for k, (m, _) in enumerate(parts)]
    return Mesh(
        np.concatenate([v for _, v in parts]),
        np.concatenate([m.faces + s for (m, _), s in zip(parts, starts)]),
        color=np.concatenate(colors),
        uv=np.concatenate(uvs),
        face_group=np.concatenate(group),
        group_names=("cloth", "thread"),
    )


def write_obj(value: Scene, sink: Sink) -> None:
    """OBJ files in mm: one, or for a moving scene one a frame, ``name.0001.obj`` and so on."""
    from tambour.files.mesh import write_obj

    many = value.frame_count > 1
    for k, mesh in enumerate(joined(value, sides=5)):
        write_obj(mesh, sink.beside(f"{sink.path.stem}.{k + 1:04d}") if many else sink)


def write_npz(value: Scene, sink: Sink) -> None:
    """NumPy arrays in mm: for each thing ``NAME.points`` (T, N, 3) float32, then its ``faces``, or its ``offsets``,
    ``radius``, ``color`` and attributes; and ``seconds_per_frame``."""
    arrays: dict[str, Array] = {"seconds_per_frame": np.array(value.seconds_per_frame)}
    for name, thing in zip(value.names, value.things):
        arrays[f"{name}.points"] = np.stack([p.astype(np.float32) for p in positions(thing)])
        if isinstance(thing, Mesh):
            arrays[f"{name}.faces"] = thing.faces
            continue
        arrays[f"{name}.offsets"] = thing.paths.offsets
        arrays[f"{name}.radius"], arrays[f"{name}.color"] = thing.radius.astype(np.float32), thing.color
        for key, rows in (*thing.strand_data.items(), *thing.point_data.items()):
            arrays[f"{name}.{key}"] = np.asarray(rows)
    with sink.stream() as stream:
        np.savez_compressed(stream, **arrays)  # type: ignore[arg-type]


def write_picture(value: Scene, sink: Sink) -> None:
    """The first frame, shaded; upright things are seen from the front, what lies from above."""
    from tambour.files.picture import write_picture
    from tambour.render.raster import picture

    mesh = next(joined(value))
    a, b, c = (mesh.vertices[mesh.faces[:, k]] for k in range(3))
    cross = np.cross(b - a, c - a)
    out, area = cross.sum(axis=0), np.linalg.norm(cross, axis=1).sum()
    lies = np.linalg.norm(out) > 0.1 * area and abs(out[1]) > 0.7 * np.linalg.norm(out)
    made = picture(mesh, width=1400, azimuth=np.radians(22), elevation=np.radians(48 if lies else 10))
    write_picture(made, sink)

"""glTF 2.0 (Khronos, 2021; ISO/IEC 12113) written: .glb. Metres there, millimetres here; `gltf` reads it."""

from __future__ import annotations

import json
import struct
from typing import Any

import numpy as np

from tambour.color import linear
from tambour.core.check import Array
from tambour.core.mesh import Mesh
from tambour.files.sink import Sink
from tambour.geometry.surface import closed, vertex_normals

TYPES = {5120: np.int8, 5121: np.uint8, 5122: np.int16, 5123: np.uint16, 5125: np.uint32, 5126: np.float32}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT2": 4, "MAT3": 9, "MAT4": 16}
_CODES = {np.dtype(kind): code for code, kind in TYPES.items()}
VERTEX, INDEX = 34962, 34963
# Groups whose uv are turns of a twist (see geometry.tube), not places on a texture.
_TURNS = {"yarn", "cotton", "acrylic", "mohair", "plied", "thread"}
_SHORT = 65535  # vertices that 16-bit indices reach, 65535 itself being spoken for
_ROUGH = {"thread": 0.55, "glass": 0.12, "": 0.8}


class Body:
    """The binary chunk of a .glb as it grows, with the views and accessors into it."""

    def __init__(self) -> None:
        self.chunks: list[bytes] = []
        self.size = 0
        self.views: list[dict[str, Any]] = []
        self.accessors: list[dict[str, Any]] = []

    def add(self, values: Array, *, target: int | None = None, bounds: bool = False, normalized: bool = False) -> int:
        """The accessor's index of an array (N,) or (N, 2…4) of a type that glTF knows; rows of a vertex attribute
        whose bytes are no multiple of four are padded to one."""
        values = np.ascontiguousarray(values)
        raw, size = values.tobytes(), values.dtype.itemsize * (1 if values.ndim == 1 else values.shape[1])
        stride = size + -size % 4
        if target == VERTEX and stride != size:
            rows = np.zeros((len(values), stride), np.uint8)
            rows[:, :size] = values.view(np.uint8).reshape(len(values), size)
            raw = rows.tobytes()
        view: dict[str, Any] = {"buffer": 0, "byteOffset": self.size, "byteLength": len(raw)}
        if target:
            view["target"] = target
        if target == VERTEX and stride != size:
            view["byteStride"] = stride
        raw += b"\0" * (-len(raw) % 4)
        self.chunks.append(raw)
        self.size += len(raw)
        self.views.append(view)
        accessor: dict[str, Any] = {
            "bufferView": len(self.views) - 1,
            "componentType": _CODES[values.dtype],
            "count": len(values),
            "type": "SCALAR" if values.ndim == 1 else f"VEC{values.shape[1]}",
        }
        if normalized:
            accessor["normalized"] = True
        if bounds and len(values):
            low, high = values.min(0), values.max(0)
            accessor |= {"min": np.atleast_1d(low).tolist(), "max": np.atleast_1d(high).tolist()}
        self.accessors.append(accessor)
        return len(self.accessors) - 1

    def file(self, scene: dict[str, Any]) -> bytes:
        """The whole .glb of a scene that refers to the accessors made so far."""
        head = {"asset": {"version": "2.0", "generator": "tambour"}, **scene}
        if self.views:
            head |= {"buffers": [{"byteLength": self.size}], "bufferViews": self.views, "accessors": self.accessors}
        text = json.dumps(head, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        parts = [struct.pack("<II", len(text), 0x4E4F534A), text]
        if self.views:
            parts += [struct.pack("<II", self.size, 0x004E4942), *self.chunks]
        return struct.pack("<III", 0x46546C67, 2, 12 + sum(map(len, parts))) + b"".join(parts)


def _spelt(mesh: Mesh) -> tuple[Array, Array] | None:
    """The colours (K, 3) of a mesh whose faces have one each, and each face's (F,); None with more than 64 or mixed
    ones. Such colours are written with the material: eight bytes a vertex less."""
    if mesh.color is None or not len(mesh.faces):
        return None
    code = mesh.color.astype(np.int64) @ np.array([65536, 256, 1])
    corner = code[mesh.faces]
    if (corner != corner[:, :1]).any():
        return None
    tones = np.unique(corner[:, 0])
    if len(tones) > 64:
        return None
    tone = np.searchsorted(tones, corner[:, 0])
    return np.stack([tones >> 16, tones >> 8 & 255, tones & 255], axis=1).astype(np.uint8), tone


def primitives(mesh: Mesh, body: Body) -> tuple[list[dict[str, Any]], list[dict[str, Any]]]:
    """The primitives and materials of a mesh, added to ``body``: one of each per group of faces and colour.

    Where runs of faces name neighbouring vertices (tubes do), primitives are cut so that 16-bit indices reach.
    """
    attributes: dict[str, tuple[Array, dict[str, bool]]] = {
        "POSITION": ((mesh.vertices / 1000).astype(np.float32), {"bounds": True})
    }
    if mesh.smooth:
        attributes["NORMAL"] = vertex_normals(mesh.vertices, mesh.faces).astype(np.float32), {}
    if mesh.uv is not None and not _TURNS & set(mesh.group_names):
        attributes["TEXCOORD_0"] = mesh.uv.astype(np.float32), {}
    spelt = _spelt(mesh)
    if mesh.color is not None and spelt is None:
        # Linear light as the specification asks, in 16 bits, which keep every one of the 256 codes apart.
        light = np.round(linear(np.arange(256) / 255.0) * 65535).astype(np.uint16)
        rgba = np.full((len(mesh.color), 4), 65535, np.uint16)
        rgba[:, :3] = light[mesh.color]
        attributes["COLOR_0"] = rgba, {"normalized": True}
    group = np.zeros(len(mesh.faces), np.int32) if mesh.face_group is None else mesh.face_group
    names = mesh.group_names if mesh.face_group is not None else ("",)
    tones, tone = (np.zeros((1, 3), np.uint8), np.zeros(len(mesh.faces), np.int64)) if spelt is None else spelt
    made: list[dict[str, Any]] = []
    materials: list[dict[str, Any]] = []
    kind = group.astype(np.int64) * len(tones) + tone
    for k in np.unique(kind).tolist():
        number, part = divmod(k, len(tones))
        name, faces = names[number], mesh.faces[kind == k]
        surface: dict[str, Any] = {"metallicFactor": 0, "roughnessFactor": _ROUGH.get(name, 1.0)}
        if spelt is not None:
            surface["baseColorFactor"] = [*np.round(linear(tones[part] / 255.0), 6).tolist(), 1]
        material: dict[str, Any] = {"pbrMetallicRoughness": surface}
        if name:
            material["name"] = name
        if not closed(faces):
            material["doubleSided"] = True
        named = np.zeros(len(mesh.vertices), bool)
        named[faces] = True
        used, faces = np.flatnonzero(named), (np.cumsum(named) - 1)[faces]
        for begin, end, low, high in _runs(faces, len(used)):
            own = used[low:high]
            stretch = {key: body.add(values[own], target=VERTEX, **how) for key, (values, how) in attributes.items()}
            short = np.uint16 if high - low <= _SHORT else np.uint32
            indices = body.add((faces[begin:end] - low).ravel().astype(short), target=INDEX)
            made.append({"attributes": stretch, "indices": indices, "material": len(materials), "mode": 4})
        materials.append(material)
    return made, materials


def _runs(faces: Array, count: int) -> list[tuple[int, int, int, int]]:
    """Stretches (first face, end, first vertex, end) of faces whose vertices 16-bit indices reach, or one of them all
    where that would take many."""
    if count <= _SHORT:
        return [(0, len(faces), 0, count)]
    low, high = faces.min(1), faces.max(1)
    runs, at = [], 0
    while at < len(faces):
        least, most = np.minimum.accumulate(low[at : at + 200_000]), np.maximum.accumulate(high[at : at + 200_000])
        end = int(np.searchsorted(most - least, _SHORT))
        runs.append((at, at + end, int(least[end - 1]), int(most[end - 1]) + 1))
        at += end
        if len(runs) > 2 + 6 * count // _SHORT:
            return [(0, len(faces), 0, count)]
    return runs


def write_mesh(value: Mesh, sink: Sink) -> None:
    """A .glb: positions in metres, colours as linear light, a primitive and a material for every group of faces."""
    body = Body()
    if not len(value.faces):
        sink.put(body.file({"scene": 0, "scenes": [{}]}))
        return
    made, materials = primitives(value, body)
    scene = {
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": made}],
        "materials": materials,
    }
    sink.put(body.file(scene))

"""glTF 2.0 (Khronos, 2021; ISO/IEC 12113) read: .glb and .gltf. Metres there, millimetres here; `glb` writes it."""

from __future__ import annotations

import base64
import binascii
import json
import struct
from dataclasses import replace
from pathlib import Path
from typing import Any
from urllib.parse import unquote

import numpy as np

from tambour.color import coded
from tambour.core.check import Array
from tambour.core.errors import LawError, TambourError
from tambour.core.mesh import Mesh
from tambour.files import MOVING
from tambour.files.glb import TYPES, WIDTHS
from tambour.files.gltf_motion import with_motion
from tambour.files.painted import Paint, painted, texture

_MOST_NODES = 100_000
_MOST_VALUES = 50_000_000
"""Nodes visited and points shown above which a file is refused: a few bytes can claim any number of either."""
_STILL = "its pictures are left out, for it moves: it has the plain colours of its materials and vertices"


def read_mesh(path: Path) -> Mesh:
    """The triangles of a glTF file's scene, in mm, with their colours, uv (of the first set) and materials' names, and the frames of
    its first animation (nodes, morph targets, skins). Textures become colours of a still scene; of one that moves they are left
    out, as ``doubts`` tell.

    Raises TambourError when the file is broken, holds no triangles, or needs an extension that is not read here.
    """
    try:
        head, chunk = _open(path)
        needs = [name for name in head.get("extensionsRequired", []) if name != "KHR_mesh_quantization"]
        if needs:
            raise TambourError(
                f"this glTF file needs {', '.join(needs)}, which is not read here",
                hint="export it without compression",
                where=str(path),
            )
        buffers = [_buffer(b, chunk, path) for b in head.get("buffers", [])]
        return with_motion(_scene(head, buffers, path), head, lambda index: _accessor(head, buffers, index))
    except TambourError:
        raise
    except (KeyError, IndexError, ValueError, TypeError, AttributeError, struct.error, RecursionError, LawError) as bad:
        raise TambourError(
            f"this is not a glTF 2.0 file that can be read ({type(bad).__name__}: {bad})", where=str(path)
        ) from None


def _open(path: Path) -> tuple[dict[str, Any], bytes]:
    raw = path.read_bytes()
    if raw[:4] != b"glTF":
        return json.loads(raw), b""
    version, length = struct.unpack_from("<II", raw, 4)
    if version != 2 or length > len(raw):
        raise ValueError("wrong version or length in its header")
    chunks: dict[int, bytes] = {}
    at = 12
    while at + 8 <= length:
        size, kind = struct.unpack_from("<II", raw, at)
        chunks.setdefault(kind, raw[at + 8 : at + 8 + size])
        at += 8 + size
    return json.loads(chunks[0x4E4F534A]), chunks.get(0x004E4942, b"")


def _buffer(buffer: dict[str, Any], chunk: bytes, path: Path) -> bytes:
    uri = buffer.get("uri")
    if uri is None:
        return chunk
    if uri.startswith("data:"):
        try:
            return base64.b64decode(uri.split(",", 1)[1], validate=True)
        except binascii.Error as error:
            raise ValueError(f"embedded data: {error}") from None
    beside = (path.parent / unquote(uri)).resolve()
    if path.parent.resolve() not in beside.parents:
        raise TambourError(f'its data "{uri}" lies outside its own folder', where=str(path))
    if not beside.exists():
        raise TambourError(f'its data file "{uri}" is missing', hint=f"put it beside {path.name}", where=str(path))
    if not beside.is_file() or beside.stat().st_size > MOVING:
        raise TambourError(f'its data "{uri}" is no file, or more than {MOVING // 1_000_000} MB', where=str(path))
    return beside.read_bytes()


def _accessor(head: dict[str, Any], buffers: list[bytes], index: int) -> Array:
    """Values (N, width) of an accessor, in its own type, or float64 in 0…1 (-1…1) when it is normalised."""
    accessor = head["accessors"][index]
    kind, width, count = np.dtype(TYPES[accessor["componentType"]]), WIDTHS[accessor["type"]], accessor["count"]
    if isinstance(count, bool) or not isinstance(count, int) or not 0 <= count <= _MOST_VALUES:
        raise ValueError("an accessor counts more values than a file can hold")
    values = np.zeros((count, width) if "bufferView" not in accessor else (0, width), kind)
    if "bufferView" in accessor:
        values = _view(head, buffers, accessor["bufferView"], accessor.get("byteOffset", 0), kind, width, count)
    if "sparse" in accessor:
        sparse = accessor["sparse"]
        at, new = sparse["indices"], sparse["values"]
        rows = _view(
            head,
            buffers,
            at["bufferView"],
            at.get("byteOffset", 0),
            np.dtype(TYPES[at["componentType"]]),
            1,
            sparse["count"],
        )
        values = values.copy()
        values[rows[:, 0]] = _view(
            head, buffers, new["bufferView"], new.get("byteOffset", 0), kind, width, sparse["count"]
        )
    if accessor.get("normalized"):
        return np.asarray(np.maximum(values.astype(np.float64) / np.iinfo(values.dtype.str).max, -1))
    return values


def _view(
    head: dict[str, Any], buffers: list[bytes], index: int, offset: int, kind: np.dtype[Any], width: int, count: int
) -> Array:
    view = head["bufferViews"][index]
    item = kind.itemsize * width
    stride = view.get("byteStride", item)
    start = view.get("byteOffset", 0) + offset
    raw = buffers[view["buffer"]]
    if count < 0 or stride < item or start < 0 or (count and start + stride * (count - 1) + item > len(raw)):
        raise ValueError("an accessor reaches past the end of its data")
    return np.ndarray((count, width), kind.newbyteorder("<"), raw, start, (stride, kind.itemsize)).astype(kind)


def _matrix(node: dict[str, Any]) -> Array:
    if "matrix" in node:
        return np.array(node["matrix"], np.float64).reshape(4, 4).T
    x, y, z, w = node.get("rotation", (0, 0, 0, 1))
    made = np.eye(4)
    made[:3, :3] = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
    ]
    made[:3, :3] *= np.array(node.get("scale", (1, 1, 1)))
    made[:3, 3] = node.get("translation", (0, 0, 0))
    return made


def _scene(head: dict[str, Any], buffers: list[bytes], path: Path) -> Mesh:
    nodes = head.get("nodes", [])
    scenes = head.get("scenes")
    roots = scenes[head.get("scene", 0)].get("nodes", []) if scenes else range(len(nodes))
    stack = [(k, np.eye(4), 0) for k in reversed(list(roots))]
    vertices, faces, colors, uvs, groups, names = [], [], [], [], [], []
    on, paints, lost = list[Array](), dict[int, Paint](), dict[str, None]()
    total, drawn, visited = 0, 0, 0
    while stack:
        index, above, depth = stack.pop()
        visited += 1
        if depth > 500 or visited > _MOST_NODES:
            raise ValueError("its nodes contain each other")
        node = nodes[index]
        place = above @ _matrix(node)
        stack += [(k, place, depth + 1) for k in reversed(node.get("children", []))]
        if "mesh" not in node:
            continue
        for primitive in head["meshes"][node["mesh"]]["primitives"]:
            drawn += 1
            if drawn > 100_000:
                raise ValueError("its nodes contain each other")
            points = _accessor(head, buffers, primitive["attributes"]["POSITION"]).astype(np.float64)
            index_of = primitive.get("indices")
            order = (
                np.arange(len(points))
                if index_of is None
                else _accessor(head, buffers, index_of)[:, 0].astype(np.int64)
            )
            triangles = _triangles(order, primitive.get("mode", 4))
            if not len(triangles):
                continue
            if np.linalg.det(place[:3, :3]) < 0:
                triangles = triangles[:, ::-1]
            material = head.get("materials", [{}])[primitive.get("material", 0)] if "material" in primitive else {}
            vertices.append((points @ place[:3, :3].T + place[:3, 3]) * 1000)
            faces.append(triangles + total)
            colors.append(_color(head, buffers, primitive["attributes"], material, len(points)))
            uv = primitive["attributes"].get("TEXCOORD_0")
            uvs.append(None if uv is None else _accessor(head, buffers, uv).astype(np.float64))
            name = str(material.get("name", ""))
            if name not in names:
                names.append(name)
            groups.append(np.full(len(triangles), names.index(name), np.int32))
            number = -1 if uv is None else _texture(material)
            if number not in paints:
                paints[number] = Paint(picture=None if number < 0 else _picture(head, buffers, number, path))
            if paints[number].picture is None and "baseColorTexture" in material.get("pbrMetallicRoughness", {}):
                lost.setdefault(f"the picture of its material {name} is left out: {_why(uv is None, number)}")
            on.append(np.full(len(triangles), list(paints).index(number)))
            total += len(points)
            if total > _MOST_VALUES:
                raise ValueError("its nodes show more points than fit into memory")
    if not faces:
        raise TambourError("there are no triangles in this file", where=str(path))
    plain = all(c is None for c in colors)
    white = [np.full((len(v), 3), 255, np.uint8) if c is None else c for v, c in zip(vertices, colors)]
    mapped = all(u is not None for u in uvs)
    known = [np.zeros((len(v), 2)) if u is None else u for v, u in zip(vertices, uvs)]
    mesh = Mesh(
        np.concatenate(vertices),
        np.concatenate(faces),
        color=None if plain else np.concatenate(white),
        uv=np.concatenate(known),
        face_group=np.concatenate(groups),
        group_names=tuple(names),
        doubts=tuple(lost),
    )
    if any(p.picture is not None for p in paints.values()):
        if head.get("animations"):  # its frames are of the vertices that it has; painting cuts it finer
            mesh = replace(mesh, doubts=(*lost, _STILL))
        else:
            mesh = painted(mesh, np.concatenate(on), list(paints.values()))
    return mesh if mapped else replace(mesh, uv=None)


def _texture(material: dict[str, Any]) -> int:
    """The number of the texture that gives a material its colour by the first set of uv; -1 for none."""
    said = material.get("pbrMetallicRoughness", {}).get("baseColorTexture")
    return -1 if said is None or said.get("texCoord", 0) != 0 else int(said["index"])


def _why(bare: bool, number: int) -> str:
    """Why a texture cannot be seen."""
    if bare:
        return "its points have no place on it"
    return "its places are those of a second set" if number < 0 else "its format is not read here"


def _picture(head: dict[str, Any], buffers: list[bytes], number: int, path: Path) -> Array | None:
    """The picture of a texture; None where another format stands in for it that is not read here."""
    source = head["textures"][number].get("source")
    if source is None:
        return None
    image = head["images"][source]
    if "bufferView" not in image:
        return texture(_buffer(image, b"", path), path)
    view = head["bufferViews"][image["bufferView"]]
    begin = view.get("byteOffset", 0)
    return texture(buffers[view["buffer"]][begin : begin + view["byteLength"]], path)


def _triangles(order: Array, mode: int) -> Array:
    if mode == 4:
        return order[: len(order) // 3 * 3].reshape(-1, 3)
    if mode == 5:
        strip = np.stack([order[:-2], order[1:-1], order[2:]], axis=1) if len(order) > 2 else np.zeros((0, 3), np.int64)
        strip[1::2] = strip[1::2, ::-1]
        return strip
    if mode == 6 and len(order) > 2:
        return np.stack([np.full(len(order) - 2, order[0]), order[1:-1], order[2:]], axis=1)
    return np.zeros((0, 3), np.int64)


def _color(
    head: dict[str, Any], buffers: list[bytes], attributes: dict[str, int], material: dict[str, Any], count: int
) -> Array | None:
    """sRGB (count, 3) uint8: the vertices' colours times the material's, or None when neither is given."""
    factor = material.get("pbrMetallicRoughness", {}).get("baseColorFactor")
    if factor is None and "COLOR_0" not in attributes:
        return None
    light = np.ones((count, 3))
    if "COLOR_0" in attributes:
        light = _accessor(head, buffers, attributes["COLOR_0"]).astype(np.float64)[:, :3]
    if factor is not None:
        light = light * np.array(factor[:3], np.float64)
    return np.round(coded(np.clip(light, 0, 1)) * 255).astype(np.uint8)

"""Meshes in the plain formats: OBJ (text), PLY and STL (binary). All in millimetres. And a mesh's picture."""

from __future__ import annotations

import struct
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from tambour.core.check import Array
from tambour.core.errors import LawError, TambourError
from tambour.core.mesh import Mesh
from tambour.core.picture import Picture
from tambour.files.mtl import Material, materials
from tambour.files.painted import painted
from tambour.files.sink import Sink

_PLY_TYPES = {
    **dict.fromkeys(("char", "int8"), "i1"),
    **dict.fromkeys(("uchar", "uint8"), "u1"),
    **dict.fromkeys(("short", "int16"), "i2"),
    **dict.fromkeys(("ushort", "uint16"), "u2"),
    **dict.fromkeys(("int", "int32"), "i4"),
    **dict.fromkeys(("uint", "uint32"), "u4"),
    **dict.fromkeys(("float", "float32"), "f4"),
    **dict.fromkeys(("double", "float64"), "f8"),
}


def write_picture(value: Mesh, sink: Sink) -> None:
    """The mesh, shaded, in the pixel format of the suffix."""
    from tambour.files.picture import write_picture
    from tambour.render.raster import picture

    made: Picture = picture(value)
    write_picture(made, sink)


def _faulty(path: Path, kind: str, why: object) -> TambourError:
    return TambourError(f"this is not a {kind} file that can be read ({why})", where=str(path))


def _mesh(path: Path, vertices: Array, faces: Array, color: Array | None = None, **more: Any) -> Mesh:
    if not len(faces):
        raise TambourError("there are no triangles in this file", where=str(path))
    try:
        return Mesh(vertices, faces, color=color, **more)
    except LawError as error:
        raise TambourError(f"its triangles make no sense ({error})", where=str(path)) from None


# OBJ -----------------------------------------------------------------------------------------------------------------


def write_obj(value: Mesh, sink: Sink) -> None:
    """OBJ with a group per group of faces; colours follow the coordinates as 0…1 sRGB, as most programs read them."""
    lines = ["# tambour, millimetres"]
    rows = value.vertices.tolist()
    if value.color is None:
        lines += [f"v {x:.5f} {y:.5f} {z:.5f}" for x, y, z in rows]
    else:
        # 256 codes, spelt once.
        code = [f"{k / 255:.4f}".rstrip("0").rstrip(".") for k in range(256)]
        lines += [
            f"v {x:.5f} {y:.5f} {z:.5f} {code[r]} {code[g]} {code[b]}"
            for (x, y, z), (r, g, b) in zip(rows, value.color.tolist())
        ]
    if value.uv is not None:
        lines += [f"vt {u:.5f} {v:.5f}" for u, v in value.uv.tolist()]
    group = np.zeros(len(value.faces), np.int32) if value.face_group is None else value.face_group
    form = "f {0}/{0} {1}/{1} {2}/{2}" if value.uv is not None else "f {} {} {}"
    for number, name in enumerate(value.group_names or ("",)):
        if name:
            lines.append(f"g {name}")
        lines += [form.format(*row) for row in (value.faces[group == number] + 1).tolist()]
    sink.put(("\n".join(lines) + "\n").encode())


def read_obj(path: Path) -> Mesh:
    """OBJ: vertices (with colours, if all have them), texture coordinates, faces cut into fans, groups; and the colours and
    pictures of its materials, where their ``.mtl`` lies beside it; what of these is not seen is told in ``doubts``.

    Raises TambourError naming the line that is wrong.
    """
    points: list[list[float]] = []
    textures: list[list[float]] = []
    corners: dict[tuple[int, int], int] = {}
    spelt: dict[
        str, int
    ] = {}  # a corner's words, which come again in each of its faces; not of those counted backwards
    faces: list[tuple[int, int, int]] = []
    groups: list[int] = []
    names = {"": 0}
    group = 0
    wears, worn, libraries = {"": 0}, list[int](), list[str]()
    material = 0
    text = path.read_bytes().decode("utf-8", errors="replace").replace("\\\n", " ")
    for number, line in enumerate(text.splitlines(), 1):
        words = (line.split("#", 1)[0] if "#" in line else line).split()
        try:
            if not words:
                continue
            if words[0] == "v":
                points.append([float(w) for w in words[1:7]])
                if len(points[-1]) < 3:
                    raise ValueError("a vertex needs three numbers")
            elif words[0] == "vt":
                textures.append([float(words[1]), float(words[2]) if len(words) > 2 else 0.0])
            elif words[0] in ("g", "o", "usemtl"):
                group = names.setdefault(" ".join(words[1:]), len(names))
                if words[0] == "usemtl":
                    material = wears.setdefault(" ".join(words[1:]), len(wears))
            elif words[0] == "mtllib":
                libraries.append(" ".join(words[1:]))
            elif words[0] == "f":
                ring = []
                for word in words[1:]:
                    if (corner := spelt.get(word)) is not None:
                        ring.append(corner)
                        continue
                    index = word.split("/")
                    v = int(index[0])
                    t = int(index[1]) if len(index) > 1 and index[1] else 0
                    v, t = v - 1 if v > 0 else len(points) + v, t - 1 if t > 0 else len(textures) + t if t else -1
                    if not 0 <= v < len(points) or t >= len(textures):
                        raise ValueError("a face names a vertex that is not there")
                    ring.append(corners.setdefault((v, t), len(corners)))
                    if "-" not in word:
                        spelt[word] = ring[-1]
                faces += [(ring[0], ring[k], ring[k + 1]) for k in range(1, len(ring) - 1)]
                groups += [group] * max(0, len(ring) - 2)
                worn += [material] * max(0, len(ring) - 2)
        except (ValueError, IndexError) as error:
            raise _faulty(path, "OBJ", f"line {number}: {error}") from None
    keys = list(corners)
    color = None
    if points and all(len(p) >= 6 for p in points):
        rgb = np.clip(np.array([points[v][3:6] for v, _ in keys]).reshape(-1, 3), 0, 1)
        color = np.round(rgb * 255).astype(np.uint8)
    on = np.array([t for _, t in keys], np.int64)
    uv = np.array([[0.0, 0.0], *textures])[on + 1]
    vertices = np.array([points[v][:3] for v, _ in keys]).reshape(-1, 3)
    mesh = _mesh(path, vertices, np.array(faces).reshape(-1, 3), color, face_group=groups, group_names=tuple(names))
    return _dressed(replace(mesh, uv=uv), on >= 0, np.array(worn), tuple(wears), *materials(path, libraries))


def _dressed(
    mesh: Mesh, mapped: Array, worn: Array, wears: tuple[str, ...], known: dict[str, Material], doubts: list[str]
) -> Mesh:
    """``mesh`` in its materials' colours, and what of them is not seen beside ``doubts``; uv only where every vertex is ``mapped`` (V,).

    worn : (F,) what each face wears, of the names ``wears``
    """
    own = [known.get(name, Material()) for name in wears]
    pictured = np.array([m.picture is not None for m in own])
    keep = mesh if mapped.all() else replace(mesh, uv=None)
    if mesh.color is not None:
        if pictured[worn].any():
            doubts.append("its vertices have colours of their own: the pictures of its materials are left out")
        return replace(keep, doubts=tuple(doubts))
    if known and (lost := sorted(set(wears) - known.keys() - {""})):
        doubts.append(f"there is no material {', '.join(lost[:5])}: what wears it is white")
    if not known.keys() & set(wears):
        return replace(keep, doubts=tuple(doubts))
    bare = ~mapped[mesh.faces].all(axis=1)
    if count := int((bare & pictured[worn]).sum()):
        doubts.append(f"{count} faces have no place on the picture of their material, and take its plain colour")
    paints = [m.paint() for m in own] + [m.paint(mapped=False) for m in own]
    assert mesh.uv is not None
    up = painted(replace(mesh, uv=mesh.uv * [1, -1] + [0, 1]), worn + len(own) * bare, paints)
    assert up.uv is not None
    return replace(up, uv=up.uv * [1, -1] + [0, 1] if mapped.all() else None, doubts=tuple(doubts))


# PLY -----------------------------------------------------------------------------------------------------------------


def write_ply(value: Mesh, sink: Sink) -> None:
    """Binary PLY, little-endian: float coordinates, uchar sRGB colours, triangles."""
    fields = [("x", "<f4"), ("y", "<f4"), ("z", "<f4")]
    head = ["ply", "format binary_little_endian 1.0", "comment tambour, millimetres"]
    head += [f"element vertex {len(value.vertices)}", *(f"property float {axis}" for axis in "xyz")]
    if value.color is not None:
        fields += [("r", "u1"), ("g", "u1"), ("b", "u1")]
        head += [f"property uchar {name}" for name in ("red", "green", "blue")]
    head += [f"element face {len(value.faces)}", "property list uchar int vertex_indices", "end_header"]
    rows = np.zeros(len(value.vertices), fields)
    for axis, name in enumerate("xyz"):
        rows[name] = value.vertices[:, axis]
    if value.color is not None:
        for channel, name in enumerate("rgb"):
            rows[name] = value.color[:, channel]
    triangles = np.zeros(len(value.faces), [("n", "u1"), ("v", "<i4", (3,))])
    triangles["n"] = 3
    triangles["v"] = value.faces
    sink.put("\n".join([*head, ""]).encode() + rows.tobytes() + triangles.tobytes())


def read_ply(path: Path) -> Mesh:
    """PLY, text or binary of either byte order: vertices, colours (red, green, blue), polygons cut into fans.

    Raises TambourError for a file that is broken or has no faces.
    """
    raw = path.read_bytes()
    try:
        end = raw.index(b"end_header")
        start = raw.index(b"\n", end) + 1
        lines = [line.split() for line in raw[:end].decode("ascii", errors="replace").splitlines()]
        if lines[0] != ["ply"]:
            raise ValueError("it does not begin with ply")
        form = next(words[1] for words in lines if words[:1] == ["format"])
        order = {"ascii": "", "binary_little_endian": "<", "binary_big_endian": ">"}[form]
        elements: list[tuple[str, int, list[list[str]]]] = []
        for words in lines:
            if words[:1] == ["element"]:
                elements.append((words[1], int(words[2]), []))
            elif words[:1] == ["property"]:
                elements[-1][2].append(words[1:])
        tables = _ply_text(raw[start:], elements) if not order else _ply_binary(raw, start, elements, order)
        table, columns = tables["vertex"]
        vertices = table[:, [columns.index(axis) for axis in "xyz"]]
        color = None
        if {"red", "green", "blue"} <= set(columns):
            rgb = table[:, [columns.index(name) for name in ("red", "green", "blue")]]
            kinds = {p[-1]: p[0] for name, _, props in elements if name == "vertex" for p in props}
            scale = 255.0 if kinds["red"] in ("float", "double", "float32", "float64") else 1.0
            color = np.clip(np.round(rgb * scale), 0, 255).astype(np.uint8)
        faces = np.array(tables["faces"]).reshape(-1, 3)
    except (ValueError, KeyError, IndexError, StopIteration, struct.error, OverflowError) as error:
        raise _faulty(path, "PLY", error) from None
    return _mesh(path, vertices, faces, color)


def _fan(ring: list[int]) -> list[list[int]]:
    return [[ring[0], ring[k], ring[k + 1]] for k in range(1, len(ring) - 1)]


def _length(told: Any) -> int:
    """How long a list is; one that is shorter than nothing would lead back, and never end."""
    size = int(told)
    if size < 0:
        raise ValueError(f"a list of {size}")
    return size


def _ply_text(raw: bytes, elements: list[tuple[str, int, list[list[str]]]]) -> dict[str, Any]:
    lines = iter(raw.decode("ascii", errors="replace").splitlines())
    tables: dict[str, Any] = {"faces": []}
    for name, count, properties in elements:
        rows = []
        for _ in range(count):
            words = next(lines).split()
            row, at = [], 0
            for prop in properties:
                if prop[0] == "list":
                    size = _length(words[at])
                    if prop[-1] in ("vertex_indices", "vertex_index"):
                        tables["faces"] += _fan([int(w) for w in words[at + 1 : at + 1 + size]])
                    at += 1 + size
                else:
                    row.append(float(words[at]))
                    at += 1
            rows.append(row)
        if name == "vertex":
            tables[name] = np.array(rows), [p[-1] for p in properties if p[0] != "list"]
    return tables


def _ply_binary(raw: bytes, at: int, elements: list[tuple[str, int, list[list[str]]]], order: str) -> dict[str, Any]:
    tables: dict[str, Any] = {"faces": []}
    for name, count, properties in elements:
        if all(p[0] != "list" for p in properties):
            kind = np.dtype([(p[-1], order + _PLY_TYPES[p[0]]) for p in properties])
            rows = np.frombuffer(raw, kind, count, at)
            at += kind.itemsize * count
            if name == "vertex":
                columns = [p[-1] for p in properties]
                tables[name] = np.stack([rows[c].astype(np.float64) for c in columns], axis=1), columns
            continue
        if len(properties) == 1:
            # Nearly every file: triangles only, which lie evenly.
            prop = properties[0]
            kind = np.dtype([("n", order + _PLY_TYPES[prop[1]]), ("v", order + _PLY_TYPES[prop[2]], (3,))])
            if at + kind.itemsize * count <= len(raw):
                rows = np.frombuffer(raw, kind, count, at)
                if (rows["n"] == 3).all():
                    at += kind.itemsize * count
                    if prop[-1] in ("vertex_indices", "vertex_index"):
                        tables["faces"] = rows["v"].astype(np.int64)
                    continue
        for _ in range(count):
            for prop in properties:
                if prop[0] != "list":
                    at += np.dtype(_PLY_TYPES[prop[0]]).itemsize
                    continue
                size = _length(np.frombuffer(raw, order + _PLY_TYPES[prop[1]], 1, at)[0])
                at += np.dtype(_PLY_TYPES[prop[1]]).itemsize
                ring = np.frombuffer(raw, order + _PLY_TYPES[prop[2]], size, at).tolist()
                at += np.dtype(_PLY_TYPES[prop[2]]).itemsize * size
                if prop[-1] in ("vertex_indices", "vertex_index"):
                    tables["faces"] += _fan(ring)
    return tables


# STL -----------------------------------------------------------------------------------------------------------------

_STL = np.dtype([("normal", "<f4", (3,)), ("corner", "<f4", (3, 3)), ("spare", "<u2")])


def write_stl(value: Mesh, sink: Sink) -> None:
    """Binary STL; it knows no colours."""
    rows = np.zeros(len(value.faces), _STL)
    rows["corner"] = value.vertices[value.faces]
    from tambour.geometry.surface import face_normals

    rows["normal"] = face_normals(value.vertices, value.faces)
    sink.put(b"tambour, millimetres".ljust(80) + struct.pack("<I", len(rows)) + rows.tobytes())


def read_stl(path: Path) -> Mesh:
    """STL, binary or text; corners at the same place become one vertex.

    Raises TambourError for a file that is broken or empty.
    """
    raw = path.read_bytes()
    try:
        if len(raw) >= 84 and len(raw) == 84 + 50 * struct.unpack_from("<I", raw, 80)[0]:
            corners = np.frombuffer(raw, _STL, offset=84)["corner"].reshape(-1, 3)
        else:
            words = raw.decode("ascii", errors="replace").split()
            if not words or words[0].lower() != "solid":
                raise ValueError("its length is not what its header says")
            at = [k for k, word in enumerate(words) if word.lower() == "vertex"]
            corners = np.array([[float(w) for w in words[k + 1 : k + 4]] for k in at], np.float32).reshape(-1, 3)
        if len(corners) % 3:
            raise ValueError("a triangle is not whole")
        vertices, inverse = np.unique(corners, axis=0, return_inverse=True)
    except (ValueError, IndexError, struct.error) as error:
        raise _faulty(path, "STL", error) from None
    return _mesh(path, vertices.astype(np.float64), inverse.reshape(-1, 3), smooth=False)

"""Mesh files: what is written is read again, by us and as the formats say; broken files are told, not followed."""

from __future__ import annotations

import base64
import json
import struct
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from PIL import Image

from tambour import files, run
from tambour.core.check import Array
from tambour.core.errors import TambourError
from tambour.core.mesh import Mesh


def tetrahedron(**more: object) -> Mesh:
    """A corner of a cube, awkward numbers in it."""
    points = np.array([[0, 0, 0], [1 / 3, 0, 0], [0, 123.456, 0], [0, 0, -7e-3]])
    faces = np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])[:, ::-1]
    return Mesh(points, faces, **more)  # type: ignore[arg-type]


def painted() -> Mesh:
    return tetrahedron(
        color=np.array([[0, 1, 255], [9, 10, 11], [128, 3, 77], [255, 255, 254]], np.uint8),
        uv=np.array([[0, 0], [0.5, 2], [-1, 1 / 3], [7, 0]]),
        face_group=np.array([0, 1, 1, 0]),
        group_names=("felt", "lining"),
    )


@pytest.mark.parametrize("suffix", [".glb", ".obj", ".ply", ".stl"])
@pytest.mark.parametrize("mesh", [tetrahedron(), painted()], ids=["plain", "painted"])
def test_what_is_written_is_read_again(tmp_path: Path, mesh: Mesh, suffix: str) -> None:
    path = tmp_path / f"m{suffix}"
    files.write(mesh, path)
    back = files.read(path, ["Mesh"])
    np.testing.assert_allclose(corners(back), corners(mesh), atol=1e-5)
    if mesh.color is not None and suffix != ".stl":
        np.testing.assert_array_equal(spread(back, back.color), spread(mesh, mesh.color))
    if mesh.uv is not None and suffix in (".glb", ".obj"):
        np.testing.assert_allclose(spread(back, back.uv), spread(mesh, mesh.uv), atol=1e-5)
        named = sorted(back.group_names[g] for g in back.face_group)
        assert named == sorted(mesh.group_names[g] for g in mesh.face_group)


def order(mesh: Mesh) -> np.ndarray:
    """Faces begun at their least corner, in the order of their corners: equal for equal surfaces."""
    ring = mesh.vertices[mesh.faces].round(4)
    first = np.lexsort(ring.reshape(-1, 3).T[::-1]).argsort().reshape(-1, 3).argmin(1)
    turned = (first[:, None] + np.arange(3)) % 3
    flat = np.take_along_axis(ring, turned[..., None], axis=1).reshape(-1, 9)
    sequence = np.lexsort(flat.T[::-1])
    return np.take_along_axis(mesh.faces, turned, axis=1)[sequence]


def corners(mesh: Mesh) -> np.ndarray:
    return mesh.vertices[order(mesh)]


def spread(mesh: Mesh, values: np.ndarray) -> np.ndarray:
    return values[order(mesh)]


def test_glb_is_laid_out_as_its_specification_asks(tmp_path: Path) -> None:
    path = tmp_path / "m.glb"
    files.write(painted(), path)
    raw = path.read_bytes()
    magic, version, length = struct.unpack_from("<4sII", raw)
    assert (magic, version, length) == (b"glTF", 2, len(raw)) and length % 4 == 0
    size, kind = struct.unpack_from("<I4s", raw, 12)
    head = json.loads(raw[20 : 20 + size])
    assert kind == b"JSON" and head["asset"]["version"] == "2.0"
    body, kind = struct.unpack_from("<I4s", raw, 20 + size)
    assert kind == b"BIN\0" and head["buffers"][0]["byteLength"] == body == len(raw) - 28 - size
    attributes = head["meshes"][0]["primitives"][0]["attributes"]
    position = head["accessors"][attributes["POSITION"]]
    np.testing.assert_allclose(position["max"], [1 / 3000, 0.123456, 0], rtol=1e-6)
    for accessor in head["accessors"]:
        view = head["bufferViews"][accessor["bufferView"]]
        assert view["byteOffset"] % 4 == 0
    color = head["accessors"][attributes["COLOR_0"]]
    assert color["normalized"] and color["type"] == "VEC4"
    start = 28 + size + head["bufferViews"][color["bufferView"]]["byteOffset"]
    light = np.frombuffer(raw, "<u2", 16, start).reshape(4, 4) / 65535
    # IEC 61966-2-1: 128 of 255 is 0.2159 of the light.
    assert abs(light[2, 0] - 0.21586) < 1e-4 and (light[:, 3] == 1).all()


def test_whole_colours_go_with_the_material(tmp_path: Path) -> None:
    one = tetrahedron()
    two = Mesh(
        np.vstack([one.vertices, one.vertices + 500]),
        np.vstack([one.faces, one.faces + 4]),
        color=np.repeat(np.array([[12, 13, 14], [200, 1, 0]], np.uint8), 4, axis=0),
    )
    files.write(two, tmp_path / "m.glb")
    raw = (tmp_path / "m.glb").read_bytes()
    assert b"COLOR_0" not in raw and raw.count(b"baseColorFactor") == 2
    back = files.read(tmp_path / "m.glb", ["Mesh"])
    np.testing.assert_array_equal(spread(back, back.color), spread(two, two.color))


@pytest.mark.parametrize("mixed", [False, True])
def test_large_meshes_are_cut_for_short_indices(tmp_path: Path, mixed: bool) -> None:
    n = 70_000
    x = np.arange(n + 2.0)
    points = np.stack([x, np.sin(x), x % 2], axis=1)
    k = np.arange(n)
    faces = np.stack([k, k + 1, k + 2], axis=1)
    if mixed:
        faces = np.random.default_rng(0).permutation(faces)
    mesh = Mesh(points, faces, smooth=False)
    files.write(mesh, tmp_path / "m.glb")
    back = files.read(tmp_path / "m.glb", ["Mesh"])
    np.testing.assert_allclose(back.vertices[back.faces], points[faces], rtol=1e-6, atol=1e-4)
    size = (tmp_path / "m.glb").stat().st_size
    assert (size < n * 19) != mixed


def test_same_mesh_same_bytes(tmp_path: Path) -> None:
    for suffix in (".glb", ".obj", ".ply", ".stl"):
        files.write(painted(), tmp_path / f"a{suffix}")
        files.write(painted(), tmp_path / f"b{suffix}")
        assert (tmp_path / f"a{suffix}").read_bytes() == (tmp_path / f"b{suffix}").read_bytes()


def test_gltf_with_places_strips_and_data_within(tmp_path: Path) -> None:
    points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]], "<f4").tobytes()
    head = {
        "asset": {"version": "2.0"},
        "scenes": [{"nodes": [0]}],
        "nodes": [
            {"children": [1], "translation": [0, 0, 2]},
            {"mesh": 0, "scale": [1, 1, -1], "rotation": [0, 0, 1, 0]},
        ],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "mode": 5, "material": 0}]}],
        "materials": [{"name": "red", "pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, 1]}}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"}],
        "bufferViews": [{"buffer": 0, "byteLength": 48}],
        "buffers": [{"byteLength": 48, "uri": "data:;base64," + base64.b64encode(points).decode()}],
    }
    path = tmp_path / "m.gltf"
    path.write_text(json.dumps(head))
    mesh = files.read(path, ["Mesh"])
    np.testing.assert_allclose(mesh.vertices[3], [-1000, -1000, 2000])
    assert mesh.group_names == ("red",) and (mesh.color == [255, 0, 0]).all()
    a, b, c = mesh.vertices[mesh.faces[0]]
    # A mirroring node turns the faces, so that outside stays outside.
    assert np.cross(b - a, c - a)[2] < 0
    head["buffers"] = [{"byteLength": 48, "uri": "../m.bin"}]
    path.write_text(json.dumps(head))
    with pytest.raises(TambourError, match="outside its own folder"):
        files.read(path, ["Mesh"])


def test_text_forms_and_polygons(tmp_path: Path) -> None:
    (tmp_path / "m.ply").write_text(
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
        "element face 1\nproperty list uchar int vertex_index\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n"
    )
    (tmp_path / "m.obj").write_text("o square\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf -4 -3 -2 -1\n")
    (tmp_path / "m.stl").write_text(
        "solid s\n"
        + "".join(
            f"facet normal 0 0 1\nouter loop\nvertex {a}\nvertex {b}\nvertex {c}\nendloop\nendfacet\n"
            for a, b, c in [("0 0 0", "1 0 0", "1 1 0"), ("0 0 0", "1 1 0", "0 1 0")]
        )
        + "endsolid s\n"
    )
    made = [files.read(tmp_path / name, ["Mesh"]) for name in ("m.ply", "m.obj", "m.stl")]
    for mesh in made:
        assert mesh.faces.shape == (2, 3) and len(mesh.vertices) == 4
        np.testing.assert_allclose(corners(mesh), corners(made[0]))


@pytest.mark.parametrize("suffix", [".glb", ".gltf", ".obj", ".ply", ".stl"])
def test_what_is_no_mesh_is_told(tmp_path: Path, suffix: str) -> None:
    path = tmp_path / f"m{suffix}"
    for raw in (
        b"",
        b"hello",
        b"glTF\2\0\0\0\xff\xff\xff\xff",
        b"ply\nformat ascii 1.0\nelement vertex 9\nend_header\n",
        b"f 1 2 3\n",
        b"v 1 2\n",
        b"{}",
        b'{"nodes": [{"children": [0]}], "scenes": [{"nodes": [0]}]}',
    ):
        path.write_bytes(raw)
        with pytest.raises(TambourError):
            files.read(path, ["Mesh"])


@pytest.mark.slow
@given(st.data())
def test_damaged_files_give_a_mesh_or_an_error(tmp_path_factory: pytest.TempPathFactory, data: st.DataObject) -> None:
    suffix = data.draw(st.sampled_from([".glb", ".obj", ".ply", ".stl"]))
    path = tmp_path_factory.mktemp("damaged") / f"m{suffix}"
    files.write(painted(), path)
    raw = bytearray(path.read_bytes())
    for _ in range(data.draw(st.integers(1, 4))):
        raw[data.draw(st.integers(0, len(raw) - 1))] = data.draw(st.integers(0, 255))
    path.write_bytes(raw[: data.draw(st.integers(0, len(raw)))] if data.draw(st.booleans()) else raw)
    try:
        mesh = files.read(path, ["Mesh"])
    except TambourError:
        return
    assert np.isfinite(mesh.vertices).all()


@pytest.mark.parametrize("suffix", ["obj", "ply", "stl", "glb"])
def test_a_mesh_as_far_as_the_stars_is_refused(tmp_path: Path, suffix: str, monkeypatch: pytest.MonkeyPatch) -> None:
    far = np.array([[0, 0, 1e30], [1, 0, 0], [0, 1, 0]])
    with monkeypatch.context() as patched:
        patched.setattr("tambour.core.mesh.FARTHEST", 10**300)
        files.write(Mesh(far, [[0, 1, 2]]), tmp_path / f"a.{suffix}")
    with pytest.raises(TambourError, match=r"a\.\w+: .*Mesh\.vertices"):
        files.read(tmp_path / f"a.{suffix}", ("Mesh",))


def test_empty_mesh_is_still_a_glb(tmp_path: Path) -> None:
    files.write(Mesh(np.zeros((0, 3)), np.zeros((0, 3), np.int32)), tmp_path / "m.glb")
    with pytest.raises(TambourError, match="no triangles"):
        files.read(tmp_path / "m.glb", ["Mesh"])


@pytest.mark.slow
def test_a_few_bytes_cannot_claim_any_number_of_nodes_or_points(tmp_path: Path) -> None:
    nodes = [{"children": [k + 1, k + 1]} for k in range(60)] + [{}]
    bombs = {
        "nodes": {"scenes": [{"nodes": [0]}], "nodes": nodes},
        **{
            str(count): {
                "scenes": [{"nodes": [0]}],
                "nodes": [{"mesh": 0}],
                "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
                "accessors": [{"componentType": 5126, "type": "VEC3", "count": count}],
            }
            for count in (3_000_000_000, 10**15, 10**30, -1, 1.5, True, "9")
        },
    }
    for name, head in bombs.items():
        (tmp_path / "a.gltf").write_text(json.dumps({"asset": {"version": "2.0"}, "scene": 0, **head}))
        with pytest.raises(TambourError) as caught:
            files.read(tmp_path / "a.gltf", ("Mesh",))
        assert "not a glTF 2.0 file" in str(caught.value), name


def chequered(path: Path, pixels: Array) -> None:
    Image.fromarray(pixels.astype(np.uint8)).save(path)


def square() -> tuple[Array, Array, Array]:
    """Two triangles, 10 mm wide, and where their corners lie on a picture, from its upper left corner."""
    x = np.array([[0.0, 0.0, 0.0], [10.0, 0.0, 0.0], [10.0, 10.0, 0.0], [0.0, 10.0, 0.0]])
    uv = np.array([[0.0, 1.0], [1.0, 1.0], [1.0, 0.0], [0.0, 0.0]])
    return x, np.array([[0, 1, 2], [0, 2, 3]]), uv


QUARTERS = np.kron(np.array([[[200, 0, 0], [0, 200, 0]], [[0, 0, 200], [240, 240, 240]]]), np.ones((8, 8, 1)))
"""Red and green above, blue and white below."""


def looks(mesh: Mesh) -> list[tuple[int, ...]]:
    """The colours in the middles of the four quarters: red, green, blue, white."""
    assert mesh.color is not None
    near = [
        ((mesh.vertices[:, :2] - at) ** 2).sum(1).argmin() for at in ([2.5, 7.5], [7.5, 7.5], [2.5, 2.5], [7.5, 2.5])
    ]
    return [tuple(mesh.color[k].tolist()) for k in near]


SEEN = [(200, 0, 0), (0, 200, 0), (0, 0, 200), (240, 240, 240)]


def test_an_obj_has_the_colours_and_the_picture_of_its_materials(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    x, faces, uv = square()
    lines = [
        "mtllib a.mtl",
        *(f"v {a} {b} {c}" for a, b, c in x.tolist()),
        *(f"vt {u} {1 - v}" for u, v in uv.tolist()),
    ]
    lines += ["usemtl skin", *("f " + " ".join(f"{k + 1}/{k + 1}" for k in f) for f in faces.tolist())]
    (tmp_path / "a.obj").write_text("\n".join(lines))
    plain = files.read(tmp_path / "a.obj", ("Mesh",))
    assert plain.color is None and len(plain.faces) == 2  # its materials are not there
    (tmp_path / "a.mtl").write_text("newmtl skin\nKd 0.5 0.25 0\n")
    assert {tuple(c) for c in files.read(tmp_path / "a.obj", ("Mesh",)).color.tolist()} == {(128, 64, 0)}
    (tmp_path / "a.mtl").write_text("newmtl skin\nKd 0.5 0.25 0\nmap_Kd skin.png\n")
    chequered(tmp_path / "skin.png", QUARTERS)
    made = files.read(tmp_path / "a.obj", ("Mesh",))
    assert looks(made) == SEEN
    assert made.uv is not None and made.uv.min() >= 0 and np.ptp(made.vertices, axis=0).tolist() == [10.0, 10.0, 0.0]
    monkeypatch.setattr("tambour.files.painted.PIXELS", 100)
    with pytest.raises(TambourError, match="16 × 16 pixels"):
        files.read(tmp_path / "a.obj", ("Mesh",))
    (tmp_path / "skin.png").write_bytes(b"no picture")
    with pytest.raises(TambourError, match="the picture of its surface cannot be read"):
        files.read(tmp_path / "a.obj", ("Mesh",))


def dressed(tmp_path: Path, mtl: str | None, faces: str = "f 1/1 2/2 3/3 4/4", library: str = "a.mtl") -> Mesh:
    """A square of 10 mm that wears ``skin`` of ``a.mtl``, read from an OBJ."""
    x = "v 0 0 0", "v 10 0 0", "v 10 10 0", "v 0 10 0", "vt 0 0", "vt 1 0", "vt 1 1", "vt 0 1"
    (tmp_path / "a.obj").write_text("\n".join([f"mtllib {library}", *x, "usemtl skin", faces]))
    if mtl is not None:
        (tmp_path / "a.mtl").write_text(f"newmtl skin\n{mtl}\n")
    made: Mesh = files.read(tmp_path / "a.obj", ("Mesh",))
    return made


@pytest.mark.parametrize("mtl", ["Kd 0.5 0.25 0\nmap_Kd skin.png", "map_Kd skin.png\nKd 0.5 0.25 0"])
def test_a_picture_stands_for_the_tone_in_either_order(tmp_path: Path, mtl: str) -> None:
    chequered(tmp_path / "skin.png", QUARTERS)
    made = dressed(tmp_path, mtl)
    assert looks(made) == SEEN and made.doubts == ()


@pytest.mark.parametrize(
    "said, at",
    [
        ("my skin.png", "my skin.png"),
        ("in\\my skin.png", "in/my skin.png"),
        ("C:\\models\\bear\\my skin.png", "my skin.png"),
        ("-clamp on -bm 1 my skin.png", "my skin.png"),
        ("-mm 0 1 in/my skin.png", "in/my skin.png"),
    ],
)
def test_a_picture_is_found_however_its_name_is_spelt(tmp_path: Path, said: str, at: str) -> None:
    (tmp_path / "in").mkdir()
    chequered(tmp_path / at, QUARTERS)
    made = dressed(tmp_path, f"map_Kd {said}")
    assert looks(made) == SEEN and made.doubts == ()


def test_what_of_materials_is_not_seen_is_told(tmp_path: Path) -> None:
    chequered(tmp_path / "skin.png", QUARTERS)
    assert "its materials b.mtl are not beside it" in " ".join(dressed(tmp_path, None, library="b.mtl").doubts)
    gone = dressed(tmp_path, "Kd 0.5 0.25 0\nmap_Kd other skin.png")
    assert gone.color is not None and {tuple(c) for c in gone.color.tolist()} == {(128, 64, 0)}
    assert gone.doubts == ("the picture other skin.png of its material skin is not beside it, and is left out",)
    assert "-s of the picture" in dressed(tmp_path, "map_Kd -s 2 2 1 skin.png").doubts[0]
    two = "usemtl fur\nf 1/1 2/2 3/3\nusemtl skim\nf 1/1 3/3 4/4"
    assert dressed(tmp_path, "newmtl fur", two).doubts == ("there is no material skim: what wears it is white",)
    # The second triangle has no place on the picture; the first keeps it.
    half = dressed(tmp_path, "Kd 0.5 0.25 0\nmap_Kd skin.png", "f 1/1 2/2 3/3\nf 1 3 4")
    assert half.doubts == ("1 faces have no place on the picture of their material, and take its plain colour",)
    assert half.color is not None and half.uv is None
    seen = {
        tuple(c) for c in half.color[np.unique(half.faces[half.vertices[half.faces][:, :, 1].mean(1) < 2])].tolist()
    }
    assert {SEEN[2], SEEN[3]} <= seen
    tail = half.vertices[half.faces].mean(1)
    assert {tuple(c) for c in half.color[half.faces[tail[:, 1] > tail[:, 0] + 0.1]].reshape(-1, 3).tolist()} == {
        (128, 64, 0)
    }


def test_a_material_outside_of_its_folder_is_not_opened(tmp_path: Path) -> None:
    (tmp_path / "in").mkdir()
    (tmp_path / "a.mtl").write_text("newmtl skin\nKd 1 0 0\n")
    (tmp_path / "in" / "a.obj").write_text("mtllib ../a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl skin\nf 1 2 3\n")
    assert files.read(tmp_path / "in" / "a.obj", ("Mesh",)).color is None


def pictured(tmp_path: Path, **more: Any) -> Mesh:
    """A square whose material has a picture, read from a glTF file."""
    x, faces, uv = square()
    chequered(tmp_path / "skin.png", QUARTERS)
    raw = [(x / 1000).astype("<f4").tobytes(), uv.astype("<f4").tobytes(), faces.astype("<u2").tobytes()]
    raw += [(tmp_path / "skin.png").read_bytes()]
    offsets = np.cumsum([0, *map(len, raw)]).tolist()
    head = {
        "asset": {"version": "2.0"},
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0}]}],
        "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
        "textures": [{"source": 0}],
        "images": [{"bufferView": 3, "mimeType": "image/png"}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
            {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC2"},
            {"bufferView": 2, "componentType": 5123, "count": 6, "type": "SCALAR"},
        ],
        "bufferViews": [{"buffer": 0, "byteOffset": a, "byteLength": len(r)} for a, r in zip(offsets, raw)],
        "buffers": [{"byteLength": offsets[-1], "uri": "a.bin"}],
    }
    (tmp_path / "a.bin").write_bytes(b"".join(raw))
    (tmp_path / "a.gltf").write_text(json.dumps(head | more))
    made: Mesh = files.read(tmp_path / "a.gltf", ("Mesh",))
    return made


def test_a_gltf_has_the_picture_of_its_material(tmp_path: Path) -> None:
    made = pictured(tmp_path)
    assert looks(made) == SEEN and made.doubts == ()


def test_a_gltf_tells_which_pictures_are_left_out(tmp_path: Path) -> None:
    assert "for it moves" in pictured(tmp_path, animations=[{"channels": [], "samplers": []}]).doubts[0]
    second = pictured(
        tmp_path, materials=[{"name": "fur", "pbrMetallicRoughness": {"baseColorTexture": {"index": 0, "texCoord": 1}}}]
    )
    assert second.doubts == ("the picture of its material fur is left out: its places are those of a second set",)
    assert "its format is not read here" in pictured(tmp_path, textures=[{}]).doubts[0]


def test_what_a_model_does_not_show_is_told_by_the_run(tmp_path: Path) -> None:
    dressed(tmp_path, None)
    made = run.make("embroidery", None, run.craft("embroidery").params(text="I", cloth=str(tmp_path / "a.obj")))
    assert any("its materials a.mtl are not beside it" in str(w) for w in made.progress.warnings)

"""Scenes as files: USD, glTF with morph targets, OBJ sequences, NPZ; and meshes that move, read back."""

from __future__ import annotations

import json
import struct
from dataclasses import replace

import numpy as np
import pytest

from tambour import files
from tambour.core.errors import TambourError
from tambour.core.scene import Scene
from tambour.embroidery.cloth.place import lay, place
from tambour.embroidery.cloth.sheets import cloth
from tambour.files import scene as scenes
from tambour.files.glb import INDEX, VERTEX, Body
from tambour.files.scene import joined, tubes
from tambour.files.usd import unpack

ROWS = np.array([(x, y, x + 3.0, y) for y in np.arange(-4, 4, 0.4) for x in (-6.0, -3.0, 0.0, 3.0)])


def scene(frames: int = 4, name: str = "flag") -> Scene:
    mesh = cloth(name, 40, 30, frames)
    color = np.tile(np.array([[180, 30, 40]], np.uint8), (len(ROWS), 1))
    color[::2] = (20, 60, 150)
    count = np.arange(len(ROWS))
    thread = lay(
        mesh,
        place(mesh),
        ROWS[:, :2],
        ROWS[:, 2:],
        radius=0.2,
        theta=np.pi / 3,
        color=color,
        data={"id": count.astype(np.int32), "seconds": count * 0.1, "region": count // 4},
    )
    white = np.full((len(mesh.vertices), 3), 230, np.uint8)
    return Scene((replace(mesh, color=white),), (thread,), ("cloth", "thread"))


@pytest.mark.parametrize("suffix", ["usdc", "usda"])
def test_usd_says_what_renderers_ask(tmp_path, suffix):
    pxr = pytest.importorskip("pxr")
    from pxr import Usd, UsdGeom, UsdShade

    made, path = scene(), tmp_path / f"a.{suffix}"
    files.write(made, path)
    stage = Usd.Stage.Open(str(path))
    assert UsdGeom.GetStageMetersPerUnit(stage) == pytest.approx(0.001)
    assert UsdGeom.GetStageUpAxis(stage) == "Y"
    assert stage.GetDefaultPrim().GetPath() == "/embroidery"
    assert (stage.GetStartTimeCode(), stage.GetEndTimeCode()) == (0, 3)
    assert stage.GetTimeCodesPerSecond() == pytest.approx(24)
    curves = UsdGeom.BasisCurves(stage.GetPrimAtPath("/embroidery/thread"))
    strands = made.strands[0]
    assert curves.GetTypeAttr().Get() == "linear"
    assert list(curves.GetWidthsAttr().Get()) == pytest.approx([0.4])  # a diameter
    assert not curves.GetWidthsAttr().GetTimeSamples()
    assert np.array_equal(curves.GetCurveVertexCountsAttr().Get(), np.diff(strands.paths.offsets))
    for k, frame in enumerate(strands.frames()):
        assert np.allclose(np.array(curves.GetPointsAttr().Get(k)), frame, atol=1e-4)
        low, high = np.array(curves.GetExtentAttr().Get(k))
        assert np.allclose([low, high], [frame.min(axis=0) - 0.2, frame.max(axis=0) + 0.2], atol=1e-4)
    api = UsdGeom.PrimvarsAPI(curves)
    assert api.GetPrimvar("id").GetInterpolation() == "uniform"
    assert len(api.GetPrimvar("u").Get()) == len(strands.paths.coords)
    assert len(api.GetPrimvar("rest").Get()) == len(strands.paths.coords)
    material = UsdShade.MaterialBindingAPI(curves.GetPrim()).ComputeBoundMaterial()[0]
    assert material.ComputeSurfaceSource()[0].GetIdAttr().Get() == "UsdPreviewSurface"
    assert pxr is not None


def test_usd_is_read_as_a_cloth_that_moves(tmp_path):
    pytest.importorskip("pxr")
    made, path = scene(), tmp_path / "a.usdc"
    files.write(made, path)
    back = files.read(path, ("Mesh",))
    assert back.frame_count == 4
    assert np.array_equal(back.faces, made.meshes[0].faces)
    for a, b in zip(back.positions(), made.meshes[0].positions()):
        assert np.allclose(a, b, atol=1e-4)
    for name, raw in (
        ("b.usda", b"#usda 1.0\n(\n defaultPrim = "),
        ("c.usdc", b"PXR-USDC" + bytes(90)),
        ("d.usd", b""),
    ):
        (tmp_path / name).write_bytes(raw)
        with pytest.raises(TambourError, match="USD"):
            unpack(tmp_path / name, str(tmp_path))


@pytest.mark.parametrize("suffix", ["usdc", "glb", "npz"])
def test_same_scene_same_bytes(tmp_path, suffix):
    if suffix == "usdc":
        pytest.importorskip("pxr")
    for name in "ab":
        files.write(scene(2), tmp_path / f"{name}.{suffix}")
    assert (tmp_path / f"a.{suffix}").read_bytes() == (tmp_path / f"b.{suffix}").read_bytes()


def test_glb_morphs_come_back_as_frames(tmp_path):
    made, path = scene(), tmp_path / "a.glb"
    files.write(made, path)
    back = files.read(path, ("Mesh",))
    assert back.frame_count == 4
    assert back.seconds_per_frame == pytest.approx(1 / 24, rel=1e-3)
    assert set(back.group_names) == {"cloth", "thread"}
    cloth_size = len(made.meshes[0].vertices)
    _, shape = tubes(made.strands[0], 6)
    wanted = zip(made.meshes[0].positions(), made.strands[0].frames())
    for frame, (mesh, points) in zip(back.positions(), wanted):
        assert np.abs(frame[:cloth_size] - mesh).max() < 0.002  # 16 bits of the farthest way
        assert np.abs(frame[cloth_size:] - shape(points).vertices).max() < 0.002


def test_glb_in_its_own_words(tmp_path):
    path = tmp_path / "a.glb"
    files.write(scene(), path)
    raw = path.read_bytes()
    head = json.loads(raw[20 : 20 + struct.unpack_from("<I", raw, 12)[0]])
    assert head["asset"]["version"] == "2.0"
    assert {m["name"] for m in head["materials"]} == {"cloth", "thread"}
    assert "KHR_materials_sheen" in head["materials"][1]["extensions"]
    assert len(head["meshes"][1]["primitives"][0]["targets"]) == 3
    assert "images" not in head  # so coordinates of a texture would be carried for nothing
    assert not any("TEXCOORD_0" in p["attributes"] for m in head["meshes"] for p in m["primitives"])
    for view in head["bufferViews"]:
        assert view["byteOffset"] % 4 == 0
        assert view.get("byteStride", 4) % 4 == 0
    files.write(scene(1, "wave"), path)
    assert files.read(path, ("Mesh",)).frame_count == 1


def test_a_moving_glb_keeps_to_its_budget(tmp_path, monkeypatch):
    monkeypatch.setattr(scenes, "BUDGET", 100_000)
    with pytest.raises(TambourError, match="usdc") as caught:
        files.write(scene(9), tmp_path / "a.glb")
    assert "MB" in str(caught.value)
    assert not (tmp_path / "a.glb").exists()
    monkeypatch.setattr(scenes, "BUDGET", 1_500_000)
    files.write(scene(9), tmp_path / "a.glb")
    assert (tmp_path / "a.glb").stat().st_size <= 1_500_000


def test_a_glb_that_would_be_too_large_holds_every_second_frame(tmp_path, monkeypatch):
    made = scene(9)
    files.write(made, tmp_path / "whole.glb")
    need = (tmp_path / "whole.glb").stat().st_size
    monkeypatch.setattr(scenes, "BUDGET", need // 3)
    files.write(made, tmp_path / "less.glb")
    a, b = (files.read(tmp_path / f"{n}.glb", ("Mesh",)) for n in ("whole", "less"))
    assert (tmp_path / "less.glb").stat().st_size <= need // 3
    assert a.frame_count == 9 and b.frame_count < 9
    assert (a.frame_count - 1) * a.seconds_per_frame == pytest.approx((b.frame_count - 1) * b.seconds_per_frame)
    last = [list(m.positions())[-1] for m in (a, b)]
    assert np.allclose(last[0].min(0), last[1].min(0), atol=0.3) and np.allclose(
        last[0].max(0), last[1].max(0), atol=0.3
    )


def test_tubes_begin_at_the_needle_hole():
    made = scene(1, "flat")
    tube, _ = tubes(made.strands[0], 8)
    assert tube.vertices[:, 2].min() > -0.2
    assert made.strands[0].paths.coords[:, 2].min() == pytest.approx(-0.1)


@pytest.mark.slow
def test_obj_sequence_there_and_back(tmp_path):
    made = scene(3)
    files.write(made, tmp_path / "a.obj")
    assert sorted(p.name for p in tmp_path.iterdir()) == [f"a.000{k}.obj" for k in (1, 2, 3)]
    back = files.read(tmp_path / "a.0001.obj", ("Mesh",))
    assert back.frame_count == 3
    for a, b in zip(back.positions(), joined(made, sides=5)):
        used = np.zeros(len(b.vertices), bool)
        used[b.faces] = True
        assert len(a) == used.sum()
        assert np.allclose(np.sort(a[:, 0]), np.sort(b.vertices[used][:, 0]), atol=1e-4)
    lines = (tmp_path / "a.0003.obj").read_text().splitlines()
    first = next(k for k, line in enumerate(lines) if line.startswith("f "))
    lines[first], lines[first + 1] = lines[first + 1], lines[first]
    (tmp_path / "a.0003.obj").write_text("\n".join(lines))
    with pytest.raises(TambourError, match="faces"):
        list(files.read(tmp_path / "a.0001.obj", ("Mesh",)).positions())


def test_npz_there_and_back(tmp_path):
    made, path = scene(3), tmp_path / "a.npz"
    files.write(made, path)
    with np.load(path) as held:
        assert held["thread.points"].shape == (3, len(made.strands[0].paths.coords), 3)
        assert np.array_equal(held["thread.id"], made.strands[0].strand_data["id"])
    back = files.read(path, ("Mesh",))
    assert back.frame_count == 3
    for a, b in zip(back.positions(), made.meshes[0].positions()):
        assert np.allclose(a, b, atol=1e-4)
    for raw in (b"", b"PK\x03\x04", b"\x93NUMPY"):
        path.write_bytes(raw)
        with pytest.raises(TambourError):
            files.read(path, ("Mesh",))
    np.savez(path, what=np.zeros(3))
    with pytest.raises(TambourError, match="no mesh"):
        files.read(path, ("Mesh",))


def test_a_skin_is_sampled(tmp_path):
    """Two joints, the upper turning by a right angle: points bound to it turn about its foot."""
    body = Body()
    points = np.array([[0, 0, 0], [0.01, 0, 0], [0, 0.02, 0], [0.01, 0.02, 0]], np.float32)
    bind = np.stack([np.eye(4), np.eye(4)]).astype(np.float32)
    bind[1, 3, 1] = -0.01  # column-major: the upper joint stands at 10 mm
    half = np.sqrt(0.5)
    turn = np.array([[0, 0, 0, 1], [0, 0, half, half]], np.float32)
    attributes = {
        "POSITION": body.add(points, target=VERTEX, bounds=True),
        "JOINTS_0": body.add(np.array([[0, 0, 0, 0]] * 2 + [[1, 0, 0, 0]] * 2, np.uint8), target=VERTEX),
        "WEIGHTS_0": body.add(np.tile(np.array([[1, 0, 0, 0]], np.float32), (4, 1)), target=VERTEX),
    }
    head = {
        "scene": 0,
        "scenes": [{"nodes": [0, 1]}],
        "nodes": [
            {"mesh": 0, "skin": 0},
            {"children": [2]},
            {"translation": [0, 0.01, 0]},
        ],
        "meshes": [
            {
                "primitives": [
                    {
                        "attributes": attributes,
                        "indices": body.add(np.array([0, 1, 2, 1, 3, 2], np.uint16), target=INDEX),
                    }
                ]
            }
        ],
        "skins": [{"joints": [1, 2], "inverseBindMatrices": body.add(bind.reshape(2, 16))}],
        "animations": [
            {
                "channels": [{"sampler": 0, "target": {"node": 2, "path": "rotation"}}],
                "samplers": [{"input": body.add(np.array([0, 1], np.float32), bounds=True), "output": body.add(turn)}],
            }
        ],
    }
    path = tmp_path / "a.glb"
    raw = body.file(head).replace(b'"type":"VEC16"', b'"type":"MAT4" ')
    path.write_bytes(raw)
    made = files.read(path, ("Mesh",))
    frames = list(made.positions())
    assert made.frame_count == 25
    assert np.allclose(frames[0], points * 1000, atol=1e-4)
    assert np.allclose(frames[-1], [[0, 0, 0], [10, 0, 0], [-10, 10, 0], [-10, 20, 0]], atol=1e-3)


def test_without_the_library_one_line_says_so(tmp_path, monkeypatch):
    monkeypatch.setitem(__import__("sys").modules, "pxr.Gf", None)
    with pytest.raises(TambourError, match="usd-core") as caught:
        files.write(scene(1), tmp_path / "a.usdc")
    assert "tambour[usd]" in caught.value.problems[0].hint


def test_broken_meshes_are_one_line(tmp_path):
    """Damaged moving .glb and .npz files: a mesh whose frames all stand, or one line."""
    rng = np.random.default_rng(3)
    for suffix in ("glb", "npz"):
        path, bad = tmp_path / f"a.{suffix}", tmp_path / f"b.{suffix}"
        files.write(scene(2), path)
        raw = path.read_bytes()
        for k in range(60):
            data = bytearray(raw)
            if k % 3 == 0:
                data = data[: rng.integers(0, len(data))]
            else:
                top = len(data) if k % 3 == 1 else min(len(data), 4000)
                for _ in range(rng.integers(1, 20)):
                    data[rng.integers(0, top)] = rng.integers(0, 256)
            bad.write_bytes(bytes(data))
            try:
                for frame in files.read(bad, ("Mesh",)).positions():
                    assert frame.shape[1] == 3
            except TambourError as error:
                assert len(error.problems) == 1

"""glTF written by hand: what other programs write and ours do not, each with what it should come to."""

from __future__ import annotations

import base64
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tambour import files
from tambour.core.check import Array
from tambour.core.errors import TambourError
from tambour.core.mesh import Mesh

CORNERS = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [-1, 1, 0]], np.float32)
KINDS = {"float32": 5126, "uint16": 5123, "uint32": 5125, "uint8": 5121}
WIDTHS = {1: "SCALAR", 3: "VEC3", 4: "VEC4", 16: "MAT4"}


class Book:
    """A glTF file as it is put together."""

    def __init__(self, **more: Any) -> None:
        self.raw = b""
        self.head: dict[str, Any] = {"asset": {"version": "2.0"}, "bufferViews": [], "accessors": [], **more}

    def view(self, values: Array) -> int:
        self.head["bufferViews"].append({"buffer": 0, "byteOffset": len(self.raw), "byteLength": values.nbytes})
        self.raw += values.tobytes() + bytes(-values.nbytes % 4)
        return len(self.head["bufferViews"]) - 1

    def put(self, values: Any, kind: str = "float32", **more: Any) -> int:
        values = np.atleast_1d(np.asarray(values, kind))
        width = values.shape[1] if values.ndim == 2 else 1
        told = {"componentType": KINDS[kind], "type": WIDTHS[width], "count": len(values), **more}
        self.head["accessors"].append({"bufferView": self.view(values), **told})
        return len(self.head["accessors"]) - 1

    def read(self, path: Path) -> Mesh:
        data = base64.b64encode(self.raw).decode()
        self.head.setdefault("buffers", [{"byteLength": len(self.raw), "uri": f"data:;base64,{data}"}])
        path.write_text(json.dumps(self.head))
        made: Mesh = files.read(path, ("Mesh",))
        return made


def one(mode: int = 4, order: Any = (0, 1, 2), points: Array = CORNERS, **node: Any) -> Book:
    made = Book(nodes=[{"mesh": 0, **node}], scenes=[{"nodes": [0]}])
    primitive = {"attributes": {"POSITION": made.put(points)}, "indices": made.put(order, "uint16"), "mode": mode}
    made.head["meshes"] = [{"primitives": [primitive]}]
    return made


def moved(path: str, times: Any, values: Any, kind: str = "LINEAR") -> Book:
    made = one()
    sampler = {"input": made.put(times), "output": made.put(values), "interpolation": kind}
    made.head["animations"] = [
        {"samplers": [sampler], "channels": [{"sampler": 0, "target": {"node": 0, "path": path}}]}
    ]
    return made


@pytest.mark.parametrize(
    ("mode", "order", "faces"),
    [
        (6, [0, 1, 2, 3, 4], [[0, 1, 2], [0, 2, 3], [0, 3, 4]]),
        (5, [0, 1, 3, 2], [[0, 1, 3], [2, 3, 1]]),
        (4, [0, 1, 2, 3], [[0, 1, 2]]),
    ],
)
def test_strips_and_fans_are_their_triangles(
    mode: int, order: list[int], faces: list[list[int]], tmp_path: Path
) -> None:
    assert one(mode, order).read(tmp_path / "a.gltf").faces.tolist() == faces


@pytest.mark.parametrize(("mode", "order"), [(1, [0, 1, 2]), (5, [0, 1]), (6, [0, 1])])
def test_lines_and_less_than_a_triangle_are_none(mode: int, order: list[int], tmp_path: Path) -> None:
    with pytest.raises(TambourError, match="no triangles"):
        one(mode, order).read(tmp_path / "a.gltf")


def test_sparse_values_lie_over_the_plain_ones(tmp_path: Path) -> None:
    made = one()
    rows, values = made.view(np.array([2, 4], np.uint16)), made.view(np.array([[5, 5, 5], [6, 6, 6]], np.float32))
    made.head["accessors"][0]["sparse"] = {
        "count": 2,
        "indices": {"bufferView": rows, "componentType": 5123},
        "values": {"bufferView": values},
    }
    assert np.allclose(
        made.read(tmp_path / "a.gltf").vertices[:5] / 1000, [[0, 0, 0], [1, 0, 0], [5, 5, 5], [0, 1, 0], [6, 6, 6]]
    )
    del made.head["accessors"][0]["bufferView"]  # what lies below is nought then
    assert np.allclose(made.read(tmp_path / "b.gltf").vertices[:3] / 1000, [[0, 0, 0], [0, 0, 0], [5, 5, 5]])


def test_a_node_that_mirrors_by_its_matrix_keeps_its_outside(tmp_path: Path) -> None:
    matrix = np.diag([-1.0, 1, 1, 1])
    matrix[:3, 3] = 2, 0, 0
    made = one(matrix=matrix.T.ravel().tolist()).read(tmp_path / "a.gltf")
    assert np.allclose(made.vertices[:3] / 1000, [[2, 0, 0], [1, 0, 0], [1, 1, 0]])
    assert made.faces.tolist() == [[2, 1, 0]]


def test_a_cubic_way_is_hermites(tmp_path: Path) -> None:
    """Value, tangent in and out at two keys; at a half: (p + q) / 2 + d (m - n) / 8."""
    p, q, m, n = np.zeros(3), np.array([4.0, 0, 0]), np.array([8.0, 0, 0]), np.array([0.0, 8, 0])
    made = moved("translation", [0, 1], [[0, 0, 0], p, m, n, q, [0, 0, 0]], "CUBICSPLINE").read(tmp_path / "a.gltf")
    frames = [f[0] / 1000 for f in made.positions()]
    assert np.allclose(frames[0], p) and np.allclose(frames[-1], q)
    assert np.allclose(frames[len(frames) // 2], (p + q) / 2 + (m - n) / 8, atol=1e-6) and len(frames) % 2


def test_a_cubic_turn_stays_a_turn(tmp_path: Path) -> None:
    none, half = [0, 0, 0, 1.0], [0, 0, 2**-0.5, 2**-0.5]
    still = [0, 0, 0, 0.0]
    made = moved("rotation", [0, 1], [still, none, still, still, half, still], "CUBICSPLINE").read(tmp_path / "a.gltf")
    for frame in made.positions():
        assert np.allclose(np.linalg.norm(frame[1] - frame[0]), 1000)


@pytest.mark.parametrize("far", [0.001, 1.0])
def test_turns_go_evenly_and_the_short_way(far: float, tmp_path: Path) -> None:
    """Nearly the same turn, and its opposite sign."""
    end = [0, 0, -np.sin(far / 2), -np.cos(far / 2)]
    made = moved("rotation", [0, 1], [[0, 0, 0, 1], end]).read(tmp_path / "a.gltf")
    angles = [np.arctan2(f[1, 1], f[1, 0]) for f in made.positions()]
    assert np.allclose(angles, np.linspace(0, far, len(angles)), atol=1e-6)


def test_steps_stand_still_between(tmp_path: Path) -> None:
    made = moved("translation", [0, 0.5, 2], [[0, 0, 0], [1, 0, 0], [2, 0, 0]], "STEP").read(tmp_path / "a.gltf")
    assert sorted({round(float(f[0, 0]) / 1000, 6) for f in made.positions()}) == [0, 1, 2]


@pytest.mark.parametrize("times", [[0.0], [0.0, 0.0]])
def test_an_animation_of_one_moment_is_none_or_still(times: list[float], tmp_path: Path) -> None:
    made = moved("scale", times, [[2.0, 2, 2]] * len(times)).read(tmp_path / "a.gltf")
    assert all(np.allclose(f[1], made.vertices[1]) or np.allclose(f[1], 2 * made.vertices[1]) for f in made.positions())


def test_what_moves_nothing_that_is_there_leaves_it_still(tmp_path: Path) -> None:
    made = moved("translation", [0, 1], [[0, 0, 0], [1, 0, 0]])
    del made.head["animations"][0]["channels"][0]["target"]["node"]
    assert made.read(tmp_path / "a.gltf").frame_count == 1


@pytest.mark.parametrize(
    ("times", "values", "word"),
    [([1, 0], [[0, 0, 0], [1, 0, 0]], "do not rise"), ([0, 1], [[0, 0, 0], [np.inf, 0, 0]], "no place")],
)
def test_an_animation_that_makes_no_sense_is_refused(times: Any, values: Any, word: str, tmp_path: Path) -> None:
    with pytest.raises(TambourError, match=rf"a\.gltf: .*{word}"):
        moved("translation", times, values).read(tmp_path / "a.gltf")


def test_a_skin_without_bind_matrices_and_a_child_of_a_moved_node(tmp_path: Path) -> None:
    made = moved("translation", [0, 1], [[0, 0, 0], [3, 0, 0]])
    made.head["nodes"] = [
        {"children": [1], "matrix": np.eye(4).ravel().tolist()},
        {"mesh": 0, "matrix": np.eye(4).ravel().tolist()},
    ]
    last = list(made.read(tmp_path / "a.gltf").positions())[-1]
    assert np.allclose(last[0] / 1000, [3, 0, 0])
    attributes = made.head["meshes"][0]["primitives"][0]["attributes"]
    attributes["JOINTS_0"] = made.put(np.zeros((5, 4)), "uint8")
    attributes["WEIGHTS_0"] = made.put(np.tile([1.0, 0, 0, 0], (5, 1)))
    made.head["skins"] = [{"joints": [0]}]
    made.head["nodes"][1]["skin"] = 0
    del made.head["buffers"]
    last = list(made.read(tmp_path / "b.gltf").positions())[-1]
    assert np.allclose(last[0] / 1000, [3, 0, 0])


@pytest.mark.parametrize(
    ("uri", "word"),
    [
        ("data:;base64,@@@", "embedded data"),
        ("gone.bin", "is missing"),
        ("../out.bin", "outside its own folder"),
        ("folder", "is no file"),
        ("large.bin", "more than"),
    ],
)
def test_data_that_is_not_to_be_had_is_told(
    uri: str, word: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("tambour.files.gltf.MOVING", 100)
    (tmp_path / "folder").mkdir()
    (tmp_path / "large.bin").write_bytes(bytes(101))
    made = one()
    made.head["buffers"] = [{"byteLength": 9, "uri": uri}]
    with pytest.raises(TambourError, match=rf"a\.gltf: .*{word}"):
        made.read(tmp_path / "a.gltf")


def test_an_extension_that_it_cannot_do_without_is_named(tmp_path: Path) -> None:
    made = one()
    made.head["extensionsRequired"] = ["KHR_mesh_quantization", "KHR_draco_mesh_compression"]
    with pytest.raises(TambourError, match="needs KHR_draco_mesh_compression, which") as caught:
        made.read(tmp_path / "a.gltf")
    assert "without compression" in str(caught.value)

"""The values' laws: what the constructors promise, and that they name the field when it is broken."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tambour.core.chart import Chart, Gauge
from tambour.core.digest import digest
from tambour.core.drawing import Drawing, Groups, Styles
from tambour.core.errors import LawError
from tambour.core.mesh import Binding, Mesh
from tambour.core.palette import Palette
from tambour.core.paths import Paths
from tambour.core.picture import Picture
from tambour.core.strands import Strands
from tambour.core.thread import END, JUMP, STITCH, Thread, ThreadPlan

BLACK = Styles.of(((0, 0, 0, 255), None, 0))
LINE = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]])
PAIR = Palette(np.array([[0, 0, 0], [255, 255, 255]]))


@given(st.lists(st.integers(0, 6), max_size=8))
def test_paths_keep_what_they_are_given(lengths: list[int]) -> None:
    lines = [np.arange(2 * n, dtype=float).reshape(n, 2) for n in lengths]
    paths = Paths.of(lines)
    assert len(paths) == len(lines)
    assert all(np.array_equal(a, b) for a, b in zip(paths, lines))
    assert paths.coords.flags.c_contiguous and paths.coords.dtype == np.float64


BROKEN: list[tuple[str, Any]] = [
    ("Paths.coords", lambda: Paths(np.zeros((3, 4)), [0, 3])),
    ("Paths.coords", lambda: Paths([[0.0, np.nan]], [0, 1])),
    ("Paths.offsets", lambda: Paths(LINE, [0, 2])),
    ("Paths.offsets", lambda: Paths(LINE, [0, 2, 1, 3])),
    ("Paths.parts", lambda: Paths(LINE, [0, 3], [0, 2])),
    ("Drawing.style", lambda: Drawing(Paths.of([LINE]), [1], BLACK, [1, 1])),
    ("Drawing.group", lambda: Drawing(Paths.of([LINE]), [0], BLACK, [1, 1], [0])),
    ("Drawing.unit", lambda: Drawing(Paths.of([LINE]), [0], BLACK, [1, 1], unit=0)),
    ("Groups.parent", lambda: Groups(("a", "b"), ("", ""), [1, -1])),
    ("Groups", lambda: Groups(("a", "a"), ("", ""), [-1, -1])),
    ("Picture.rgba", lambda: Picture(np.zeros((2, 2, 3), np.uint8))),
    ("Palette", lambda: Palette([[0, 0, 0], [0, 0, 0]])),
    ("Chart.cells", lambda: Chart([[0, 2]], PAIR)),
    ("Chart.cells: row 1", lambda: Chart([[0, 1, 1], [0, 1, 2]], Palette([[0, 0, 0], [1, 1, 1], [2, 2, 2]]))),
    ("Chart.locked", lambda: Chart([[0, 1]], PAIR, locked=[[True]])),
    ("Gauge", lambda: Gauge(0, 30)),
    ("ThreadPlan.command", lambda: ThreadPlan([[0, 0]], [STITCH], [0], (Thread((0, 0, 0)),))),
    ("ThreadPlan.xy", lambda: ThreadPlan([[0, 0], [9, 0], [9, 0]], [1, 0, 5], [0, 0, 0], (Thread((0, 0, 0)),), 8.0)),
    ("Mesh.faces", lambda: Mesh(np.zeros((2, 3)), [[0, 1, 2]])),
    ("Mesh.color", lambda: Mesh(np.zeros((3, 3)), [[0, 1, 2]], np.zeros((2, 3)))),
    ("Mesh.vertices", lambda: Mesh(np.full((3, 3), -1e308), [[0, 1, 2]])),
    ("Mesh.frames", lambda: Mesh(np.zeros((3, 3)), [[0, 1, 2]], frames=np.full((2, 3, 3), 1e10))),
    ("Binding.uv", lambda: Binding([0], [[0.0, 0.0, 0.0]], [0.0])),
    ("Strands.paths", lambda: Strands(Paths.of([LINE]), [1.0] * 3, [[0, 0, 0]])),
]


@pytest.mark.parametrize(("field", "make"), BROKEN, ids=[f"{k}-{f}" for k, (f, _) in enumerate(BROKEN)])
def test_a_broken_law_is_named(field: str, make: Any) -> None:
    with pytest.raises(LawError, match=f"^{field}"):
        make()


def test_a_jump_may_be_longer_than_a_stitch() -> None:
    plan = ThreadPlan(
        [[0, 0], [90, 0], [95, 0], [95, 0]], [JUMP, JUMP, STITCH, END], [0] * 4, (Thread((0, 0, 0)),), 7.0
    )
    assert len(plan) == 4


def test_frames_are_given_one_at_a_time() -> None:
    rest = np.zeros((3, 3))
    still = Mesh(rest, [[0, 1, 2]])
    assert [f.shape for f in still.positions()] == [(3, 3)]
    stored = Mesh(rest, [[0, 1, 2]], frames=np.zeros((4, 3, 3)))
    assert stored.frame_count == len(list(stored.positions())) == 4
    made = Mesh(rest, [[0, 1, 2]], frames=lambda: (rest + k for k in range(5)), frame_count=5)
    assert sum(1 for _ in made.positions()) == sum(1 for _ in made.positions()) == 5


def test_digest_is_of_the_content() -> None:
    a, b = Paths.of([LINE]), Paths.of([LINE.copy()])
    assert digest(a) == digest(b) != digest(Paths.of([LINE + 1]))
    assert digest({"a": 1, "b": (1.0, None)}) == digest({"b": (1.0, None), "a": 1})
    assert digest([1, 23]) != digest([12, 3])
    with pytest.raises(TypeError):
        digest(object())


def test_a_moving_mesh_has_a_digest() -> None:
    """A model that moves, read from a glTF file, has its frames as a function: asked for its identity, we fell over it."""
    points, faces = np.eye(3), np.array([[0, 1, 2]])

    def moving(by: float) -> Mesh:
        return Mesh(points, faces, frames=lambda: iter([points, by * points]), frame_count=2)

    assert digest(moving(2.0)) == digest(moving(2.0)) != digest(moving(3.0))

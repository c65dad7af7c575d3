"""Cloths, places, and thread that lies on them."""

from __future__ import annotations

import numpy as np
import pytest

from tambour.core.errors import TambourError
from tambour.core.mesh import Mesh
from tambour.embroidery.cloth.place import lay, place
from tambour.embroidery.cloth.sheets import CLOTHS, cloth, sheet
from test_embroidery_bind import ball

ROWS = np.array([(-9.0 + 0.3 * (k % 3), y, 9.0, y) for k, y in enumerate(np.arange(-9, 9, 0.4))])


def thread(mesh: Mesh, rows: np.ndarray = ROWS, where=None, **more):
    count = np.arange(len(rows))
    return lay(
        mesh,
        where or place(mesh, **more),
        rows[:, :2],
        rows[:, 2:],
        radius=0.2,
        theta=np.pi / 3,
        color=np.zeros((len(rows), 3), np.uint8),
        data={"id": count, "seconds": count * 0.1},
    )


@pytest.mark.parametrize("name", ["wave", "flag"])
def test_bending_cloth_keeps_its_length(name):
    made = cloth(name, 80, 60, frames=5)
    nx = len(np.unique(made.vertices[:, 0]))
    for frame in made.positions():
        step = np.linalg.norm(np.diff(frame.reshape(-1, nx, 3), axis=1), axis=2)
        flat = np.diff(made.vertices.reshape(-1, nx, 3)[..., 0], axis=1)
        assert np.allclose(step, flat, atol=1e-9)


@pytest.mark.parametrize("name", CLOTHS)
def test_cloths_have_frames_and_face_the_viewer(name):
    made = cloth(name, 90, 50, frames=3)
    assert sum(1 for _ in made.positions()) == (1 if name == "flat" else 3)
    a, b, c = (made.vertices[made.faces[:, k]] for k in range(3))
    assert (np.cross(b - a, c - a)[:, 2] > 0).all()
    again = [f.copy() for f in cloth(name, 90, 50, frames=3).positions()]
    assert all(np.array_equal(p, q) for p, q in zip(again, made.positions()))


@pytest.mark.parametrize("mode", ["uv", "projector", "point"])
def test_a_flat_cloth_takes_the_design_as_it_is(mode):
    made = thread(sheet(60, 40), mode=mode)
    low, high = made.paths.coords.min(axis=0), made.paths.coords.max(axis=0)
    assert np.allclose([low[0], high[0]], [-9, 9], atol=0.3)
    assert np.allclose([low[1], high[1]], [-8.6, 9], atol=0.3)  # y down becomes y up
    assert high[2] == pytest.approx(0.2)
    assert low[2] == pytest.approx(-0.1)


def test_offset_rotation_and_scale():
    flat = sheet(80, 80)
    made = thread(flat, where=place(flat, offset=(10.0, 5.0), rotate=np.pi / 2, scale=0.5))
    middle = (made.paths.coords.min(axis=0) + made.paths.coords.max(axis=0)) / 2
    assert np.allclose(middle[:2], [10, -5], atol=0.3)
    assert np.ptp(made.paths.coords[:, 1]) == pytest.approx(9, abs=0.3)


def test_curves_are_cut_at_every_face():
    mesh = cloth("flat", 70, 50)
    made = thread(mesh)
    flat = sheet(70, 50)
    step = np.diff(np.unique(flat.vertices[:, 0]))[0]
    # On a grid of squares with diagonals a row crosses two edges a cell at least.
    assert np.diff(made.paths.offsets).min() > 2 * 17 / step


def test_attributes_ride_through_all_frames():
    made = thread(cloth("flag", 70, 50, frames=4))
    frames = list(made.frames())
    assert len(frames) == made.frame_count == 4
    assert all(len(f) == len(made.paths.coords) for f in frames)
    assert np.array_equal(frames[0], made.paths.coords)
    assert set(made.strand_data) == {"id", "seconds"}
    assert set(made.point_data) == {"u", "rest", "height"}
    assert np.abs(made.point_data["rest"][:, 2] - made.point_data["height"]).max() < 1e-9
    assert not np.allclose(frames[0], frames[2])


@pytest.mark.parametrize("mode", ["point", "projector"])
def test_a_closed_shape_is_embroidered_round_its_side(mode):
    wide = np.array([(-26.0, y, 26.0, y) for y in np.arange(-5, 5, 1.0)])
    stitches = np.array([(x, y, x + 4, y) for _, y, _, _ in wide for x in np.arange(-28, 28, 4.0)])
    made = thread(ball(25, 40), stitches, mode=mode)
    far = np.linalg.norm(made.paths.coords, axis=1)
    assert len(made.paths) == len(stitches)
    assert far.min() > 24
    assert far.max() < 25.5


def test_what_does_not_fit_is_said():
    small = sheet(15, 15)
    for mode in ("uv", "projector", "point"):
        with pytest.raises(TambourError, match="beyond"):
            thread(small, mode=mode)
    with pytest.raises(TambourError, match="uv"):
        place(ball(), "uv")
    with pytest.raises(TambourError, match="group"):
        place(small, group="front")

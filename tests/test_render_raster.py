"""Meshes drawn: the kernels against plain NumPy, light where it belongs, the same bytes every time."""

from __future__ import annotations

import numpy as np
import pytest

from tambour.core.mesh import Mesh
from tambour.core.paths import Paths
from tambour.core.strands import Strands
from tambour.crochet.finish.features import joined
from tambour.geometry.surface import vertex_normals
from tambour.geometry.tube import sweep
from tambour.render import light, raster
from tambour.render.camera import look
from tambour.render.cover import cover, turn


def cover_plainly(x, y, z, faces, shape, side):  # type: ignore[no-untyped-def]
    """The same as the kernel, a face at a time over the whole picture."""
    near, face = np.full(shape, -np.inf), np.full(shape, -1)
    row, column = np.mgrid[: shape[0], : shape[1]] + 0.5
    for f, (a, b, c) in enumerate(faces):
        area = (x[b] - x[a]) * (y[c] - y[a]) - (y[b] - y[a]) * (x[c] - x[a])
        if area == 0 or area * side < 0:
            continue
        wb = ((column - x[a]) * (y[c] - y[a]) - (row - y[a]) * (x[c] - x[a])) / area
        wc = ((row - y[a]) * (x[b] - x[a]) - (column - x[a]) * (y[b] - y[a])) / area
        zed = z[a] + wb * (z[b] - z[a]) + wc * (z[c] - z[a])
        over = (wb >= 0) & (wc >= 0) & (wb + wc <= 1) & (zed > near)
        near[over], face[over] = zed[over], f
    return near, face


@pytest.mark.parametrize("side", [-1, 0, 1])
def test_cover_is_its_plain_twin(side: int) -> None:
    rng = np.random.default_rng(7)
    x, y, z = rng.uniform(-20, 90, 120), rng.uniform(-20, 70, 120), rng.uniform(1, 2, 120)
    faces = rng.integers(0, 120, (60, 3)).astype(np.int32)
    near, face = np.full((50, 70), -np.inf, np.float32), np.full((50, 70), -1, np.int32)
    cover(x, y, z, faces, near, face, np.full(60, side, np.int8))
    expected = cover_plainly(x, y, z, faces, (50, 70), side)
    assert (face == expected[1]).mean() > 0.999  # a sample exactly on an edge may go either way
    same = face == expected[1]
    np.testing.assert_allclose(near[same], expected[0][same], rtol=1e-5)


def test_cover_leaves_no_crack_and_no_face_out_of_sight() -> None:
    # A fan of many thin triangles fills its square: each sample belongs to one of them.
    angles = np.linspace(0, 2 * np.pi, 400)
    x = np.concatenate([[50.0], 50 + 200 * np.cos(angles)])
    y = np.concatenate([[50.0], 50 + 200 * np.sin(angles)])
    k = np.arange(1, 400)
    faces = np.stack([np.zeros(399), k, k + 1], axis=1).astype(np.int32)
    near, face = np.full((100, 100), -np.inf, np.float32), np.full((100, 100), -1, np.int32)
    cover(x, y, np.ones(401), faces, near, face, np.zeros(399, np.int8))
    assert (face >= 0).all()


def test_turn_is_a_matrix_product() -> None:
    rng = np.random.default_rng(1)
    points, axes = rng.normal(size=(40, 3)), rng.normal(size=(3, 3))
    np.testing.assert_allclose(turn(points, axes), axes @ points.T, rtol=1e-12)


@pytest.mark.parametrize(("azimuth", "elevation", "height"), [(0, 0, 300), (1, 0.5, None), (-2.5, 1.4, 90)])
def test_camera_sees_every_point_and_fills_the_picture(azimuth: float, elevation: float, height: int | None) -> None:
    rng = np.random.default_rng(3)
    points = rng.normal(size=(500, 3)) * [30, 60, 20] + [100, -40, 7]
    camera = look(points, width=200, height=height, azimuth=azimuth, elevation=elevation, lens=0.5)
    x, y, z = camera.axes @ (points - camera.eye).T
    assert (z < 0).all()
    column, row = x / -z * camera.scale / (camera.width / 2), y / -z * camera.scale / (camera.height / 2)
    reach = max(np.ptp(column), np.ptp(row)) / 2
    assert np.abs([column, row]).max() <= 0.861 and reach > 0.859
    np.testing.assert_allclose(camera.axes @ camera.axes.T, np.eye(3), atol=1e-12)


def sphere(rows: int = 24, radius: float = 20.0) -> Mesh:
    a, b = np.meshgrid(
        np.linspace(0, np.pi, rows + 1), np.linspace(0, 2 * np.pi, 2 * rows, endpoint=False), indexing="ij"
    )
    points = np.stack([np.sin(a) * np.cos(b), np.cos(a), -np.sin(a) * np.sin(b)], axis=-1).reshape(-1, 3) * radius
    i, j = np.mgrid[:rows, : 2 * rows]
    across = (j + 1) % (2 * rows)
    p, q, r, s = (
        k.ravel()
        for k in (i * 2 * rows + j, i * 2 * rows + across, (i + 1) * 2 * rows + across, (i + 1) * 2 * rows + j)
    )
    return Mesh(points, np.concatenate([np.stack([p, s, r], 1), np.stack([p, r, q], 1)]))


def test_a_sphere_is_round_lit_from_above_and_stands_in_its_shadow() -> None:
    mesh = sphere()
    made = raster.picture(mesh, width=160, height=160, elevation=0.3)
    bare = raster.picture(mesh, width=160, height=160, elevation=0.3, ground=False)
    tone = made.rgba[..., :3].mean(-1)
    assert tone[45, 70] > tone[115, 90] + 20
    # Under it the floor is darker than without it; at the upper corners there is no difference.
    assert (made.rgba[152, 90:120, :3].astype(int) < bare.rgba[152, 90:120, :3].astype(int) - 15).all()
    np.testing.assert_array_equal(made.rgba[0], bare.rgba[0])
    assert (made.rgba[..., 3] == 255).all()


def test_what_is_hidden_from_the_lamp_is_darker() -> None:
    floor = np.array([[-50, 0, -50], [-50, 0, 50], [50, 0, 50], [50, 0, -50]], float)
    roof = floor * [0.5, 1, 0.5] + [0, 25, 0]
    faces = np.array([[0, 1, 2], [0, 2, 3]])
    one = Mesh(floor, faces, smooth=False)
    two = Mesh(np.vstack([floor, roof]), np.vstack([faces, faces + 4]), smooth=False)
    made = light.shine(two.vertices, two.faces, *light.studio(0.0), size=200, threads=1, shut=np.zeros(4, np.int8))
    lit = [
        sum(
            light.seen(k, *p, made.axes, made.origin, made.texel, made.direction, made.depth, 0.5)
            for k in range(50)
            if made.direction[k, 1] > 0
        )
        for p in ([0.0, 0.1, 0.0], [-48.0, 0.1, 48.0])
    ]
    above = int((made.direction[:, 1] > 0).sum())
    assert lit[0] < 0.5 * lit[1] and lit[1] >= 0.8 * above
    assert (raster.picture(one, width=60).rgba != raster.picture(two, width=60).rgba).any()


@pytest.mark.slow
def test_same_bytes_whatever_the_number_of_threads(monkeypatch: pytest.MonkeyPatch) -> None:
    mesh = sphere(12)
    made = []
    for count in (1, 2, 5):
        monkeypatch.setattr(raster, "WORKERS", count)
        made.append(raster.picture(mesh, width=90).rgba.tobytes())
    assert made[0] == made[1] == made[2]


def test_a_surface_without_a_rim_looks_the_same_from_its_outside_alone() -> None:
    # Beside an open sheet; with the groups' faces told apart, and without.
    line = np.array([[-15.0, 3, 0], [0, -4, 9], [15, 6, 0]])
    ball = sweep(Strands(Paths.of([line], 3), np.full(3, 9.0), np.full((1, 3), 128, np.uint8)), sides=12)
    sheet = np.array([[-40, -22, -40], [-40, -22, 40], [40, -22, 40], [40, -22, -40]], float)
    points = np.vstack([ball.vertices, sheet])
    faces = np.vstack([ball.faces, np.array([[0, 1, 2], [0, 2, 3]]) + len(ball.vertices)])
    group = np.repeat(np.array([0, 1], np.int32), [len(ball.faces), 2])
    told = Mesh(points, faces, face_group=group, group_names=("ball", "sheet"))
    assert raster.shut(told).tolist() == [1] * len(ball.faces) + [0, 0]
    untold = Mesh(points, faces, face_group=group.clip(0, 0), group_names=("both",))
    assert not raster.shut(untold).any()
    below, above = (raster.shine(m.vertices, m.faces, *light.studio(0.3, 7, 3), size=90, threads=1, shut=raster.shut(m))
                    for m in (told, untold))  # fmt: skip
    assert (below.depth == above.depth).mean() > 0.999
    for elevation in (0.4, -0.6):  # the sheet is seen from both of its sides
        one, other = (raster.picture(m, width=90, ground=False, elevation=elevation).rgba for m in (told, untold))
        assert (one == other).all(axis=2).mean() > 0.99


@pytest.mark.slow
def test_colours_are_the_meshes_own() -> None:
    points = sphere(12)
    for color in ((200, 40, 40), (40, 160, 60), (250, 250, 250), (12, 12, 14)):
        mesh = Mesh(
            points.vertices, points.faces, color=np.broadcast_to(np.array(color, np.uint8), points.vertices.shape)
        )
        pixel = raster.picture(mesh, width=80, height=80).rgba[40, 52, :3].astype(int)
        assert np.abs(pixel - color).max() < 45, (color, pixel)


def test_yarn_is_as_thick_as_it_is_whatever_hangs_from_it() -> None:
    """Measured over all of a mesh, cut fur's many thin strands were the yarn's radius, and it was drawn without its fibres."""
    line = np.array([[-30.0, 0, 0], [0, 0, 0], [30, 0, 0]])
    thin = [line + np.array([0.0, 0.5 * k, 9.0]) for k in range(40)]
    rods = [
        sweep(
            Strands(Paths.of(lines), np.full(3 * len(lines), r), np.zeros((len(lines), 3), np.uint8)),
            sides=24,
            material=name,
        )
        for lines, r, name in (([line], 6.0, "yarn"), (thin, 0.4, "plied"))
    ]
    plate = Mesh(line, np.array([[0, 1, 2]]), face_group=np.zeros(1, np.int32), group_names=("felt",))
    both = joined([*rods, plate])
    assert raster.radii(both)[:2] == pytest.approx([6.0, 0.4], rel=0.05)
    assert raster.radii(both)[2] == pytest.approx(0.4, rel=0.05)
    np.testing.assert_array_equal(raster.radii(plate), [0.0])


def test_empty_and_flat_meshes_are_drawn() -> None:
    empty = raster.picture(Mesh(np.zeros((0, 3)), np.zeros((0, 3), np.int32)), width=40)
    assert len(np.unique(empty.rgba[0], axis=0)) == 1
    flat = Mesh(np.array([[0, 0, 0], [0, 0, 1], [1, 0, 0.0]]), np.array([[0, 1, 2], [1, 1, 2]]))
    assert raster.picture(flat, width=40, elevation=1.2).rgba.std() > 1


def test_normals_point_outward() -> None:
    mesh = sphere()
    inner = np.abs(mesh.vertices[:, 1]) < 19.9
    normals = vertex_normals(mesh.vertices, mesh.faces)[inner]
    np.testing.assert_allclose((normals * mesh.vertices[inner]).sum(1) / 20, 1, atol=0.01)


def test_light_is_the_same_whether_things_come_at_once_or_one_after_the_other() -> None:
    one, two = sphere(12), sphere(9)
    points = np.vstack([one.vertices, two.vertices + np.array([30.0, 5.0, 0.0])])
    faces = np.vstack([one.faces, two.faces + len(one.vertices)])
    at_once = light.shine(
        points, faces, *light.studio(0.4, 7, 3), size=90, threads=1, shut=np.ones(len(faces), np.int8)
    )
    made = light.unbroken(points, *light.studio(0.4, 7, 3), size=90)
    for some in (one.faces, two.faces + len(one.vertices)):
        light.stand(made, points, some, np.ones(len(some), np.int8), threads=2)
    np.testing.assert_array_equal(made.depth, at_once.depth)
    sky, lamp = (
        light.unbroken(points, *(v[own] for v in light.studio(0.4, 7, 3)), size=90)
        for own in (slice(0, 7), slice(7, 10))
    )
    for part in (sky, lamp):
        light.stand(part, points, faces, np.ones(len(faces), np.int8), threads=1)
    np.testing.assert_array_equal(light.together(sky, lamp).depth, at_once.depth)
    mesh = Mesh(points, faces)
    pictures = [raster.picture(mesh, width=80, azimuth=0.4, ground=False, lit=lit).rgba for lit in (at_once, made)]
    np.testing.assert_array_equal(*pictures)


def test_pixels_are_those_of_the_film_to_the_nearest_code() -> None:
    shade = np.random.default_rng(1).gamma(0.7, 0.5, (64, 64, 4)).astype(np.float32)
    shade[0, :4] = [[0.0] * 4, [1e-6] * 4, [15.9] * 4, [400.0] * 4]
    exact = raster.coded(raster.film(shade[..., :3].astype(float))) * 255
    made = raster._developed(shade)
    assert np.abs(made[..., :3] - exact).max() < 0.6 + 255 * 0.2 / 16
    dim = shade[..., :3] < 4
    assert np.abs(made[..., :3] - exact)[dim].max() < 0.52
    assert (made[..., 3] == 255).all()


@pytest.mark.parametrize("lean", [-0.4, 0.4])
def test_plies_of_pale_yarn_are_told_by_a_dark_line_however_it_leans(lean: float) -> None:
    """Its hollows threw their light back, and a leg of a V whose plies the lamp did not cast was smooth (the line had .71 of the light)."""
    t = np.linspace(-8.0, 8.0, 60)
    paths = Paths(np.stack([lean * t, t, 0.0 * t], axis=1), np.array([0, 60]))
    yarn = sweep(Strands(paths, np.full(60, 4.0), np.array([[245, 245, 245]], np.uint8)), sides=20, lay=4.6)
    seen = (
        raster.picture(yarn, width=240, height=320, azimuth=0.0, elevation=0.0, ground=False).rgba[..., 1].astype(float)
    )
    rows = np.arange(60, 260)
    middle = seen[rows, np.rint(120 + (160 - rows) * lean).astype(int)]
    even = np.convolve(middle, np.ones(9) / 9, "valid")
    assert np.quantile(even, 0.05) < 0.69 * np.quantile(even, 0.95)

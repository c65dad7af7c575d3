"""Photos: framed as the raster frames, lit from above, the same bytes by any number of threads, with grain."""

from __future__ import annotations

import subprocess
import sys
from dataclasses import replace
from math import radians
from typing import Any

import numpy as np

from tambour import run as runner
from tambour.color import linear
from tambour.core.mesh import Mesh
from tambour.render import photo, raster, room, tables
from tambour.render.camera import THREE_QUARTER
from tambour.render.tables import TABLES


def sphere(color: tuple[int, int, int] = (120, 160, 90)) -> Mesh:
    """A ball of radius 10 about the origin, by latitude and longitude."""
    rows, columns = 24, 32
    up, turn = np.meshgrid(np.linspace(0, np.pi, rows), np.arange(columns) * 2 * np.pi / columns, indexing="ij")
    points = 10 * np.stack([np.sin(up) * np.sin(turn), np.cos(up), np.sin(up) * np.cos(turn)], axis=-1).reshape(-1, 3)
    i, j = np.meshgrid(np.arange(rows - 1), np.arange(columns), indexing="ij")
    a, b = i * columns + j, i * columns + (j + 1) % columns
    faces = np.concatenate([np.stack([a, a + columns, b], -1), np.stack([b, a + columns, b + columns], -1)])
    return Mesh(points, faces.reshape(-1, 3), color=np.full((len(points), 3), color, np.uint8))


def test_the_option_chooses_the_default_view_of_pictures() -> None:
    crochet = runner.craft("crochet")

    def views(photo: bool) -> list[str]:
        names = ["a.png", "a.jpg", "a.glb", "a.photo.png", "a.yarn.png"]
        return [o.view for o in runner.outputs(crochet, names, "", crochet.prefer(crochet.params(photo=photo)))]

    assert views(False) == ["toy", "toy", "yarn", "photo", "yarn"]
    assert views(True) == ["photo", "photo", "yarn", "photo", "yarn"]


def test_a_ball_is_lit_from_above_and_stands_where_the_raster_puts_it() -> None:
    made = photo.picture(sphere(), width=64, height=64, samples=2, lights=30).rgba.astype(float)
    view = {"azimuth": THREE_QUARTER[0], "elevation": THREE_QUARTER[1], "lens": radians(26.0), "margin": photo.ROOM}
    drawn = raster.shot(sphere(), width=64, height=64, samples=2, lights=5, **view).light[..., 3]
    green = [made[..., 1] - made[..., 0] > 8, drawn > 0.5]
    assert (green[0] != green[1]).mean() < 0.04
    rows = np.flatnonzero(green[0][:, 32])
    top, bottom = made[rows[3] : rows[3] + 8, 24:40, :3], made[rows[-1] - 10 : rows[-1] - 2, 24:40, :3]
    assert linear(top / 255).mean() > 1.2 * linear(bottom / 255).mean()
    # The colour is the mesh's: in full light its hue is kept.
    lit = made[rows[3] : rows[3] + 8, 24:40, :3].mean((0, 1))
    assert lit[1] > lit[0] > lit[2]
    # The wall is pale; the table is brown, and darker in the shadow beside the foot.
    assert made[2:6, :, :3].mean() > 200
    table = np.concatenate([made[-6:, :8, :3], made[-6:, -8:, :3]], axis=1)
    assert (table[..., 0] > table[..., 2] + 20).all()
    under = made[rows[-1] + 1 : rows[-1] + 4, 24:60, :3].mean(-1)
    assert under.min() < 0.8 * np.median(table.mean(-1))


COIL = """
import numpy as np
from tambour.core.paths import Paths
from tambour.core.strands import Strands
from tambour.geometry.tube import sweep
from tambour.render.photo import picture

turn = np.linspace(0, 6, 80)
line = np.stack([8 * np.cos(turn), 2 * turn, 8 * np.sin(turn)], axis=1)
coil = Strands(Paths.of([line]), np.full(80, 2.0), np.array([[180, 60, 40]], np.uint8))
shot = picture(sweep(coil), width=64, samples=2, lights=30).rgba
"""
ALONE = "import os\nif hasattr(os, 'sched_setaffinity'):\n    os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})\n"


def test_the_same_bytes_in_any_process_and_by_any_number_of_threads() -> None:
    shots = []
    for _ in range(2):
        names: dict[str, Any] = {}
        exec(COIL, names)
        shots.append(names["shot"].tobytes())
    code = ALONE + COIL + "import sys\nsys.stdout.buffer.write(shot.tobytes())\n"
    shots.append(subprocess.run([sys.executable, "-c", code], capture_output=True, check=True).stdout)
    assert shots[0] == shots[1] == shots[2]


def test_an_empty_mesh_is_the_bare_table() -> None:
    made = photo.picture(Mesh(np.zeros((0, 3)), np.zeros((0, 3), np.int32)), width=16, samples=2, lights=30).rgba[
        ..., :3
    ]
    assert made.min() > 90


def moved(mesh: Mesh, x: float, y: float, z: float) -> Mesh:
    return Mesh(mesh.vertices + np.array((x, y, z)), mesh.faces, color=mesh.color)


def test_what_stands_beside_is_seen_soft_and_moves_nothing() -> None:
    """The thing is framed without it, and stays as it is drawn; the table takes its shadow."""
    asked: dict[str, Any] = {"width": 96, "height": 96, "samples": 2, "lights": 30, "azimuth": 0.0, "elevation": 0.2}
    alone = photo.picture(sphere(), **asked).rgba[..., :3].astype(int)
    other = moved(sphere((200, 40, 40)), -14.0, 0.0, -24.0)
    both = photo.picture(sphere(), beside=other, **asked).rgba[..., :3].astype(int)
    red = (both[..., 0] - both[..., 1] > 60) & (alone[..., 0] - alone[..., 1] < 40)
    assert red[:, :40].sum() > 150 and red[:, 60:].sum() == 0
    # The thing's own pixels are those of before, but for a little of light and grain.
    middle = np.abs(both - alone)[34:62, 40:66]
    assert np.median(middle) <= 3
    # With a wide lens its rim before the wall is softer than with a narrow one (not where the thing is before it: that has a rim too).
    rims, top = [], int(np.flatnonzero(red.any(1))[0])
    for open in (0.002, 0.2):
        rows = (
            photo.picture(sphere(), beside=other, open=open, **asked).rgba[max(top - 20, 0) : top + 10, :8].astype(int)
        )
        rims.append(int(np.abs(np.diff(rows[..., 0] - rows[..., 1], axis=0)).max()))
    assert rims[1] < 0.7 * rims[0]


def test_the_wall_shows_the_windows_light_on_its_far_side() -> None:
    """Aslant, out of focus, on the side that the window is not on; a sheet that bends up shows none."""
    for name, table in TABLES.items():
        wall = room.wall(120, 90, replace(table, room=())).sum(2)
        assert wall.shape == (90, 120) and (wall > 0.0).all()
        steps = np.abs(np.diff(wall, axis=1))
        if table.wall is None:
            assert steps.max() < 1e-12, name
            continue
        right = steps[:40, 75:].max() > 2.0 * steps[:40, :45].max()
        assert right == (table.side > 0.0), name
        assert steps.max() < 0.2 * wall.mean()  # soft: no edge is drawn


def test_a_wall_is_not_empty_and_far_out_of_focus() -> None:
    """To both sides of the thing in the middle stands something of a room, on every wall something else, and none has an edge."""
    seen = []
    for name, table in TABLES.items():
        if table.wall is None:
            assert not table.room
            continue
        full, bare = room.wall(120, 90, table), room.wall(120, 90, replace(table, room=()))
        off = np.abs(full - bare).max(2) > 0.06 * bare.mean()
        assert min(off[:, :45].sum(), off[:, 75:].sum()) > 60, name
        assert np.abs(np.diff(full, axis=1)).max() < 0.35 * bare.mean(), name
        seen.append(off)
        assert (full == room.wall(120, 90, table)).all()
    assert all((a ^ b).sum() > 200 for k, a in enumerate(seen) for b in seen[:k])


def test_pores_of_wood_stand_in_patches_and_are_not_alike() -> None:
    """As many to each square, all as long and as dark, they looked stamped."""
    for grain in ("wood", "painted"):
        fine = tables.tile(grain)[1, : tables.SIDE]
        strokes = fine > np.quantile(fine, 0.985)
        each = strokes.reshape(16, 64, 16, 64).sum((1, 3))
        assert each.std() > 0.57 * each.mean(), grain


def test_linen_has_no_two_threads_alike() -> None:
    """Threads of one width, straight from end to end, are a screen's pattern: along one thread's place another is met."""
    fine = tables.tile("linen")[1, : tables.SIDE]
    shift = tables.SIDE // tables.THREADS * 2
    apart = [
        np.corrcoef(fine[:, :128].ravel(), np.roll(fine, k * shift, 0)[:, :128].ravel())[0, 1] for k in (8, 16, 24)
    ]
    assert max(apart) < 0.5


def test_a_thin_sheet_has_no_dark_halo_on_the_table() -> None:
    """On the window's side what lies flat throws no shadow; away from it a narrow one."""
    flat = sphere((220, 215, 205))
    flat = Mesh(flat.vertices * (2.0, 0.06, 2.0), flat.faces, color=flat.color)
    made = raster.shot(
        flat, width=120, height=120, azimuth=0.0, elevation=radians(76.0), lens=radians(26.0), samples=2, lights=60,
        table="painted", margin=photo.ROOM, cells=photo.CELLS,
    )  # fmt: skip
    cover, table = made.light[..., 3], made.behind.sum(2)
    row = np.flatnonzero(cover[60] > 0.5)
    left, right = table[60, row[0] - 4 : row[0] - 1].mean(), table[60, row[-1] + 2 : row[-1] + 5].mean()
    # The window of this table stands to the right or left as the table says.
    lit, shaded = (left, right) if TABLES["painted"].side > 0.0 else (right, left)
    far = np.median(table[60, 4:12])
    assert lit > 0.80 * far and shaded < lit


def test_shadows_are_cooler_than_what_the_window_lights() -> None:
    """Daylight is warmer than what the room sends back: shadows of one grey with all else look computed."""
    from tambour.render.light import window

    for name, table in TABLES.items():
        way, weight, key = table.lit(0.0, 80, 20)
        lamp, sky = weight[key].sum(0), weight[~key & (way[:, 1] > 0.0)].sum(0)  # the table sends up what is warm
        cooler = (sky[2] / sky[0]) / (lamp[2] / lamp[0])
        assert (cooler - 1.0) * np.sign(table.warm) > 0.02, name
    assert window(0.0, warm=1.0)[1][-1, 0] > window(0.0, warm=0.0)[1][-1, 0]


def test_a_shadow_is_as_soft_as_what_throws_it_is_high_above_the_table_however_tall_the_thing_is() -> None:
    from tambour.render.light import floor_light, stand, unbroken

    def edges(high: float) -> float:
        """How far, mm, the light of one lamp goes from dark to bright beyond a wide plate's edge."""
        x = np.array([-100.0, 100.0])
        corners = np.array([(a, high, b) for a in x for b in x])
        plate = Mesh(corners, np.array([[0, 1, 3], [0, 3, 2]], np.int32))
        down = np.array([[0.0, 1.0, 0.0]])
        far = np.array([[-140.0, 0.0, -140.0], [140.0, 0.0, 140.0]])
        lit = unbroken(np.vstack([corners, far]), down, np.ones((1, 3)), np.ones(1, np.bool_), size=1024)
        stand(lit, plate.vertices, plate.faces, raster.shut(plate), threads=1)
        share, plot = floor_light(lit, far[0], far[1] + (0.0, 80.0, 0.0), cells=800, taps=32)
        line = share[400, :, 0]
        return float(((line > 0.1) & (line < 0.9)).sum() * plot[2])

    low, high = edges(2.0), edges(80.0)
    assert low < 3.0 and high > 4.0 * low


def test_a_grey_thing_by_the_window_is_grey() -> None:
    """The camera's white is the window's: pictures had one warm cast over all that was in them."""
    made = photo.picture(sphere((150, 150, 150)), width=64, height=64, samples=2, lights=30)
    red, _, blue = linear(made.rgba[24:34, 24:40, :3] / 255.0).mean((0, 1))
    assert 0.95 < red / blue < 1.06

"""Photos: framed as the raster frames, lit from above, the same bytes by any number of threads, with grain."""

from __future__ import annotations

import subprocess
import sys
from math import radians
from typing import Any

import numpy as np

from tambour import run as runner
from tambour.color import linear
from tambour.core.mesh import Mesh
from tambour.render import photo, raster
from tambour.render.camera import THREE_QUARTER


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

"""Closed: where a last round is drawn together no hole shows what lies under the yarn."""

from __future__ import annotations

from math import radians

import numpy as np
from scipy.ndimage import distance_transform_edt

from tambour.core.errors import Text
from tambour.core.progress import Progress
from tambour.crochet.params import CrochetParams
from tambour.crochet.plush import make
from tambour.crochet.yarn.fabric import mesh, strands
from tambour.render.camera import look
from tambour.render.cover import cover, turn
from tambour.render.raster import shut

BALL = """R1: MR(6)
R2: 6 inc
R3: [sc, inc] x 6
R4: [2 sc, inc] x 6
R5: [3 sc, inc] x 6
5: 30 sc
: [3 sc, dec] x 6
: [2 sc, dec] x 6
: [sc, dec] x 6
: 6 dec
FO
"""


ARM = """R1: MR(6)
R2-R9: 3 sc, 3 hdc
FO
"""


def widest(text: str, *sides: tuple[float, float]) -> float:
    """The widest stretch of the lining that is seen from ``sides`` (azimuth, elevation in degrees), in widths of the yarn."""
    made = make(Text(text), CrochetParams(), Progress())
    graph, x = made.built.graph, made.positions
    led = strands(graph, x)
    drawn = mesh(graph, x, made=led)
    yarn, found = 2.0 * float(np.median(led.radius)), []
    for azimuth, elevation in sides:
        camera = look(
            drawn.vertices,
            width=900,
            height=900,
            azimuth=radians(azimuth),
            elevation=radians(elevation),
            lens=radians(26),
        )
        u, v, w = turn(drawn.vertices - camera.eye, camera.axes)
        near = 1.0 / np.maximum(-w, 1e-9)
        depth = np.full((camera.height, camera.width), -np.inf, np.float32)
        face = np.full(depth.shape, -1, np.int32)
        u, v = u * near * camera.scale + camera.width / 2, camera.height / 2 - v * near * camera.scale
        cover(u, v, near, drawn.faces, depth, face, -shut(drawn))
        seen = (face >= 0) & (drawn.face_group[face] == drawn.group_names.index("lining"))
        wide = np.where(seen, 2.0 * distance_transform_edt(seen) / (camera.scale * np.maximum(depth, 1e-9)), 0.0)
        found.append(float(wide.max()) / yarn)
    return max(found)


def test_a_drawn_together_end_shows_no_hole_wider_than_a_third_of_the_yarn() -> None:
    assert widest(BALL, (0.0, 88.0)) < 1.0 / 3.0


def test_between_the_stitches_one_sees_the_yarn_behind_and_not_the_lining() -> None:
    """It lay amid the fabric, before the strands behind, and showed between the legs of half doubles in thin arms."""
    assert widest(ARM, *((60.0 * k, 12.0 * (k % 2)) for k in range(6))) < 0.25


def test_no_hole_of_a_stuffed_ball_is_wider_than_a_fifth_of_the_yarn() -> None:
    """Between the legs of its Vs, and about its decreases, one looked through to the lining: a third of the yarn and more."""
    assert widest(BALL, *((60.0 * k, 50.0 * (-1) ** k) for k in range(6))) < 0.2

"""One call of every kernel on a tiny drawing, so that no measured stage holds their loading."""

from __future__ import annotations

import numpy as np

from tambour.core.drawing import Drawing, Groups, Styles
from tambour.core.paths import Paths
from tambour.core.progress import Progress
from tambour.core.thread import END, STITCH, Thread, ThreadPlan
from tambour.embroidery.looks.preview import picture
from tambour.embroidery.looks.scene import scene
from tambour.embroidery.params import EmbroideryParams
from tambour.embroidery.plan.design import piece_of
from tambour.embroidery.plan.facts import facts
from tambour.embroidery.plan.make import make

FAMILIES = ("tatami", "contour", "flow", "meander", "satin")


def warm() -> None:
    """Embroider a notched 12 mm square with an edge, once in each way that has kernels of its own."""
    ring = np.array([[0, 0], [12, 0], [12, 12], [7, 12], [6, 3], [5, 12], [0, 12], [0, 0]], np.float64)
    n = len(FAMILIES)
    drawing = Drawing(
        Paths.of([ring + np.array([20.0 * k, 0]) for k in range(n)]),
        np.zeros(n),
        Styles.of(((0, 0, 0, 255), (9, 9, 9, 255), 1.5)),
        np.array([20.0 * n, 12.0]),
        np.arange(n),
        Groups(FAMILIES, FAMILIES, np.full(n, -1), np.zeros(n, bool), tuple({"tambour-stitch": f} for f in FAMILIES)),
    )
    facts(make(drawing, EmbroideryParams(row_spacing=1, motif_size=2), Progress()))
    # And two stitches as a machine holds them, seen and laid on cloth.
    xy = np.array([[0, 0], [3, 0], [3, 3], [3, 3]], np.float64)
    command = np.array([STITCH, STITCH, STITCH, END], np.uint8)
    plan = ThreadPlan(xy, command, np.zeros(4, np.int16), (Thread((0, 0, 0)),), None, {"colours": ""})
    picture(plan, pixels_per_mm=1)
    scene(piece_of(plan, EmbroideryParams(), Progress()))

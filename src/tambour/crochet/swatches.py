"""Swatches: the sheet that shows every specimen near to, with its name."""

from __future__ import annotations

from math import pi, radians
from typing import TYPE_CHECKING, Final

from tambour.crochet.specimens import TABLE

if TYPE_CHECKING:
    from tambour.core.drawing import Drawing
    from tambour.core.mesh import Mesh
    from tambour.core.picture import Picture
    from tambour.crochet.piece import Plush

WIDE: Final = 46.0
"""Width of a specimen on the sheet, mm."""
PIXELS: Final = 420
ACROSS: Final = 6
FLAT: Final = 0.3
"""What is less deep than so much of its width is a swatch."""
LIGHTS: Final = 30
INSIDE: Final = ("flo",)
"""Specimens that one looks into."""
SEAMS: Final = ("joined",)
"""Specimens that show where their rounds are joined."""


def sheet(piece: Plush) -> Drawing:
    """Every specimen, or the one that was asked for, near to, with its name; mm. Each is made as ``piece`` was asked to be."""
    from tambour.core.progress import Progress
    from tambour.crochet.plush import make
    from tambour.render.page import GREY, Page

    asked = piece.params.specimen
    names = list(TABLE) if asked in (None, "all") else [str(asked)]
    across, high = min(ACROSS, len(names)), WIDE + 10.0
    down = -(-len(names) // across)
    page = Page(across * (WIDE + 4.0) + 12.0, down * high + 12.0)
    for k, name in enumerate(names):
        made = make(None, piece.params.model_copy(update={"specimen": name, "photo": False}), Progress())
        x, y = 8.0 + k % across * (WIDE + 4.0), 8.0 + k // across * high
        page.image(near(made, PIXELS), x, y, WIDE, WIDE, photo=True)
        page.text(TABLE[name][0], x, y + WIDE + 4.0, 3.0)
        page.text(name, x, y + WIDE + 7.4, 2.4, color=GREY)
    return page.drawing(title="stitches")


def near(piece: Plush, width: int) -> Picture:
    """A small piece as large as it fits a square picture: a swatch from its right side, a disc from above."""
    import numpy as np

    from tambour.crochet.looks import toy
    from tambour.crochet.page.pictures import lies
    from tambour.crochet.page.portrait import face_down, turned
    from tambour.render.raster import picture

    wide, _, deep = np.ptp(piece.positions, axis=0).tolist()
    flat = deep < FLAT * wide
    azimuth, elevation = (0.0, radians(70.0)) if lies(piece) else (pi, radians(4.0)) if flat else (0.3, radians(14.0))
    if piece.params.specimen in INSIDE:
        elevation = radians(43.0)
    if piece.params.specimen in SEAMS:
        azimuth = seam(piece)
    shown = toy(piece)
    if flat and not lies(piece):
        shown = level(shown, piece)
    if face_down(piece):
        shown = turned(shown)
    return picture(shown, width=width, height=width, azimuth=azimuth, elevation=elevation, lights=LIGHTS)


def seam(piece: Plush) -> float:
    """Radians to where rounds are joined."""
    from math import atan2

    from tambour.core.graph import JOIN

    graph = piece.built.graph
    where = piece.positions[graph.edges[graph.edge_kind == JOIN].ravel()] - piece.positions.mean(0)
    x, _, z = where.mean(0).tolist()
    return atan2(x, z)


def level(mesh: Mesh, piece: Plush) -> Mesh:
    """A mesh of a swatch turned so that the chain it was begun on lies level."""
    from dataclasses import replace
    from math import atan2, cos, sin

    import numpy as np

    from tambour.core.graph import ROOT

    graph = piece.built.graph
    first = np.flatnonzero((graph.round == graph.round.min()) & (graph.peculiarity != ROOT))
    x, y = (piece.positions[first, k] - piece.positions[first, k].mean() for k in (0, 1))
    turn = 0.5 * atan2(2.0 * float((x * y).sum()), float((x * x - y * y).sum()))
    turned = np.array([[cos(turn), sin(turn), 0.0], [-sin(turn), cos(turn), 0.0], [0.0, 0.0, 1.0]])
    return replace(mesh, vertices=mesh.vertices @ turned.T)

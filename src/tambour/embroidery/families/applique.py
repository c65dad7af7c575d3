"""What is sewn for hands: appliqué patches with their stops, a basting box, a knockdown below everything."""

from __future__ import annotations

import math

import numpy as np

from tambour.core.check import Array
from tambour.core.paths import Paths
from tambour.embroidery.columns.satin import zigzag
from tambour.embroidery.columns.stroke import from_stroke, stroke_stitches
from tambour.embroidery.families.tatami import tatami
from tambour.embroidery.lines.fill import rings
from tambour.embroidery.lines.least import tidy
from tambour.embroidery.lines.run import TOLERANCE
from tambour.embroidery.params import EmbroideryParams
from tambour.embroidery.piece import RUNNING, UNDERLAY, Region
from tambour.embroidery.regions.flat import stroked
from tambour.embroidery.regions.read import KNOCKED, ROOM
from tambour.embroidery.stitches import Stitches, line_stitches

COVER = 3.0  # mm, width of the satin over a patch's edge
TACK = 1.2  # mm, width of the zigzag that holds a patch
BASTE = 6.0  # mm, stitch of the basting box


def applique(region: Region) -> list[list[Stitches]]:
    """The stages of a patch, with a stop of the machine between them.

    Placement line (lay the patch on it), tack-down zigzag just inside (then trim the patch close to it), satin cover.
    """
    outlines = [r for r in region.paths if len(r) > 3]
    p = region.params
    place = [line_stitches(r, p.length, RUNNING, TOLERANCE) for r in outlines]
    tack = []
    for r in outlines:
        for column in from_stroke(r, TACK):
            xy = zigzag(column.left, column.right, 2.0, 0.0, 0.0, 0.0, 0.0, 0.0, np.uint64(0))
            tack.append(Stitches.of(xy, RUNNING))
    width = region.width if region.width > 0 else COVER
    cover = [stroke_stitches(from_stroke(r, width), p, region.id) for r in outlines]
    return [[tidy(thread, p.min_length) for thread in stage] for stage in (place, tack, cover)]


def basting_box(low: Array, high: Array) -> Stitches:
    """Long running stitches round the design: they hold the cloth, and are pulled out afterwards."""
    (x0, y0), (x1, y1) = low - ROOM, high + ROOM
    return line_stitches(np.array([[x0, y0], [x1, y0], [x1, y1], [x0, y1], [x0, y0]]), BASTE, RUNNING, 0.0)


def knockdown(regions: tuple[Region, ...], p: EmbroideryParams) -> list[Stitches]:
    """Thin rows, 45° from the fills', under the whole design and ``KNOCKED`` mm round it."""
    import shapely

    from tambour.geometry.areas import of_shapely, to_shapely

    shapes = [a for r in regions if r.role == "area" for a in to_shapely(r.paths)]
    shapes += [a for r in regions if r.role != "area" for a in stroked(r, r.paths, max(r.width, p.thread))]
    whole = of_shapely(shapely.union_all(shapes).buffer(KNOCKED))
    made = []
    if whole is not None and whole.parts is not None:
        angle = math.radians((p.angle or 0.0) + 45)
        for a, b in zip(whole.parts[:-1].tolist(), whole.parts[1:].tolist()):
            area = rings(Paths.of([whole[i] for i in range(a, b)]), angle)
            thin = tatami(area, angle, max(1.2, 3 * p.row_spacing), 4.0, kind=UNDERLAY)
            made.append(tidy(thin, p.min_length))
    return made

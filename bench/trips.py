"""Round trips: patterns of ours, their plush as a surface, a pattern made of that, and how far its plush lies from the first.

python bench/trips.py [NAME …]   (of examples/crochet: ball, mushroom, bear; scikit-image, of the extra dev)
"""

from __future__ import annotations

import math
import sys
import time
from pathlib import Path

import numpy as np

from tambour.core.check import Array
from tambour.core.errors import Text
from tambour.core.mesh import Mesh
from tambour.core.progress import Progress
from tambour.crochet.params import CrochetParams
from tambour.crochet.plush import make
from tambour.geometry.closest import nearest, tree

CELL = 0.6
"""Width of the grid's cells, in stitches."""
CLOSED = 2.0
"""Gaps between parts up to twice as many cells wide are filled."""
EXAMPLES = Path(__file__).parent.parent / "examples" / "crochet"


def skin(vertices: Array, faces: Array, cell: float, close_: float) -> Mesh:
    """What one sees of fabric that may have parts within parts, as one closed surface: inside is where it winds about."""
    from scipy.ndimage import distance_transform_edt
    from skimage.measure import label, marching_cubes

    low = vertices.min(0) - 3.0 * cell
    count = np.ceil((vertices.max(0) + 3.0 * cell - low) / cell).astype(int)
    axes = [low[k] + cell * np.arange(count[k]) for k in range(3)]
    grid = np.stack(np.meshgrid(*axes, indexing="ij"), -1).reshape(-1, 3)
    far = nearest(tree(vertices, faces), grid)[2]
    close = far < 1.8 * cell
    inside = np.zeros(len(grid), bool)
    inside[close] = winding(grid[close], vertices[faces]) > 0.5
    # Away from the fabric a region is all inside or all outside: the one that reaches the corner is outside.
    region = label(~close.reshape(count), connectivity=1).ravel()
    for k in range(1, int(region.max()) + 1):
        cells = np.flatnonzero(region == k)
        inside[cells] = winding(grid[cells[:1]], vertices[faces])[0] > 0.5
    field = np.where(inside, -far, far).reshape(count)
    if close_:  # gaps narrower than twice that are filled: where parts touch there would be holes through the whole
        filled = distance_transform_edt(field < close_ * cell)
        outer = distance_transform_edt(~(field < close_ * cell))
        field = np.minimum(field, (close_ - np.where(filled > 0, filled - 0.5, 0.5 - outer)) * cell)
    body = label(field < 0.0)
    sizes = np.bincount(body.ravel())[1:]
    field[(body > 0) & (body != 1 + int(sizes.argmax()))] = cell
    field = np.where(np.abs(field) < 0.05 * cell, np.copysign(0.05 * cell, field), field)  # no corners in one place
    x, f, _, _ = marching_cubes(field, 0.0)
    return Mesh(x * cell + low, f[:, ::-1].copy())


def winding(points: Array, corners: Array) -> Array:
    """How often (P,) a surface of triangles (F, 3, 3) winds about points (P, 3), of open ones a share (Van Oosterom and Strackee 1983)."""
    made = np.zeros(len(points))
    for begin in range(0, len(points), 400):
        a, b, c = (corners[None, :, k] - points[begin : begin + 400, None] for k in range(3))
        la, lb, lc = (np.sqrt((v**2).sum(2)) for v in (a, b, c))
        top = (a * np.cross(b, c)).sum(2)
        below = la * lb * lc + (a * b).sum(2) * lc + (b * c).sum(2) * la + (c * a).sum(2) * lb
        made[begin : begin + 400] = 2.0 * np.arctan2(top, below).sum(1) / (4.0 * math.pi)
    return made


def main(names: list[str]) -> None:
    """Print a line for each."""
    for name in names or ["ball", "mushroom", "bear"]:
        first = make(Text((EXAMPLES / f"{name}.acl").read_text(), f"{name}.acl"), CrochetParams(), Progress())
        graph = first.built.graph
        model = skin(
            first.positions,
            graph.faces[first.built.shell],
            CELL * first.stitch[0],
            0.0 if len(graph.parts) == 1 else CLOSED,
        )
        began, told = time.process_time(), Progress()
        piece = make(model, CrochetParams(stitches=len(graph)), told)
        assert piece.aim is not None
        found, seconds = piece.aim.distance, time.process_time() - began
        print(
            f"{name}: {len(graph)} stitches became {len(piece.built.graph)} in {len(piece.aim.parts)} parts; mean "
            f"{found['mean']:.3f}, 95 % {found['p95']:.2f}, largest {found['largest']:.2f} stitches; {seconds:.0f} s of processor",
            flush=True,
        )


if __name__ == "__main__":
    main(sys.argv[1:])

"""Making: the piece growing stitch by stitch in its yarn, as a row of pictures."""

from __future__ import annotations

from collections.abc import Iterator
from math import radians
from typing import TYPE_CHECKING, Final

if TYPE_CHECKING:
    from tambour.core.mesh import Mesh
    from tambour.core.picture import Picture
    from tambour.core.strands import Strands
    from tambour.crochet.piece import Plush

FRAMES: Final = 48
"""Pictures that the making is shown in, at the most one for each stitch."""
WIDTH: Final = 480
"""Pixels along a side: films are square, as telephones show them."""
LIGHTS: Final = 16
ABOVE: Final = 14.0, 58.0
"""From how high one looks at what stands, and at what lies flat, degrees."""


def making(piece: Plush, *, frames: int = FRAMES, width: int = WIDTH) -> Iterator[Picture]:
    """The piece upright in ``frames`` square pictures, in the order of work; the last one is whole, with its face."""
    from tambour.crochet.looks import yarn
    from tambour.crochet.page.pictures import lies
    from tambour.crochet.piece import not_empty
    from tambour.render.camera import THREE_QUARTER
    from tambour.render.raster import picture

    not_empty(piece)
    whole = yarn(piece, detail=fineness(piece))
    total = len(piece.built.graph)
    count = max(2, min(frames, total))
    for k in range(1, count + 1):
        mesh = whole if k == count else upto(piece, -(-total * k // count))
        yield picture(
            mesh,
            width=width,
            height=width,
            azimuth=THREE_QUARTER[0],
            elevation=radians(ABOVE[lies(piece)]),
            lights=LIGHTS,
            frame=whole.vertices,
        )


def fineness(piece: Plush) -> str:
    """How round the yarn is: a small piece fills its pictures with few stitches, whose tubes would show their six sides. Rounder by its
    sides alone: all frames show the same strands."""
    from tambour.crochet.yarn.fabric import NEAR

    small = piece.params.detail == "medium" and len(piece.built.graph) < NEAR
    return "high" if small else piece.params.detail


def upto(piece: Plush, stitches: int) -> Mesh:
    """The piece's yarn when so many of its nodes are worked, over as much of its lining."""
    from dataclasses import replace

    from tambour.crochet.yarn.fabric import mesh

    graph = piece.built.graph
    done = replace(graph, faces=graph.faces[(graph.faces < stitches).all(1)])
    return mesh(
        done,
        piece.positions,
        detail=fineness(piece),
        made=worked(piece.yarn, stitches),
        material=piece.params.material,
    )


def worked(yarn: Strands, stitches: int) -> Strands:
    """Strands as far as the yarn of the first ``stitches`` nodes goes; seams, which belong to their later node, too."""
    import numpy as np

    from tambour.core.paths import Paths
    from tambour.core.strands import Strands

    ends, stitch = np.asarray(yarn.paths.offsets), yarn.point_data["stitch"]
    later = np.flatnonzero(stitch >= stitches)
    # A strand goes on to its first point of a stitch that is still to come.
    first = np.searchsorted(later, ends[:-1])
    upto = np.minimum(np.append(later, len(stitch))[first], ends[1:])
    keep = np.arange(len(stitch)) < np.repeat(upto, np.diff(ends))
    paths = Paths(yarn.paths.coords[keep], np.concatenate([[0], np.cumsum(upto - ends[:-1])]))
    return Strands(paths, yarn.radius[keep], yarn.color, source=yarn.source, point_data={"stitch": stitch[keep]})

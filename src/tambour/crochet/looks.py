"""Looks: a piece as meshes (in its yarn, with its doubts in red, as a bare surface), path-traced, and as data."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any, Final

from tambour.crochet.piece import Plush, not_empty

if TYPE_CHECKING:
    from tambour.core.mesh import Mesh
    from tambour.core.picture import Picture

DOUBT: Final = (206, 42, 38)
PALE: Final = (228, 224, 216)
"""Colours of the picture of a tech edit: stitches that it doubts, and what the others are mixed with."""


def yarn(piece: Plush) -> Mesh:
    """The piece in yarn, with its face: every stitch swept to tubes, over a dark lining."""
    from tambour.crochet.finish.features import joined, meshes
    from tambour.crochet.yarn.fabric import mesh

    not_empty(piece)
    detail = piece.params.detail
    face, led = meshes(piece.built, piece.positions, piece.yarn, detail=detail, upright=piece.upright)
    worked = mesh(piece.built.graph, piece.positions, detail=detail, made=led, material=piece.params.material)
    return joined([worked, *face]) if face else worked


def checked(piece: Plush) -> Mesh:
    """The piece in pale yarn, what the tech edit doubts in red."""
    import numpy as np

    from tambour.crochet.graph.check import doubtful, size_edit, tech_edit
    from tambour.crochet.yarn.fabric import mesh

    not_empty(piece)
    graph, problems = piece.built.graph, tech_edit(piece.built)
    wrong = doubtful(piece.built, [*problems, *size_edit(piece.built, tuple(np.ptp(piece.positions, axis=0)))])
    color = np.where(wrong[:, None], DOUBT, (0.25 * graph.color + 0.75 * np.array(PALE)).astype(np.uint8))
    return mesh(replace(graph, color=color.astype(np.uint8)), piece.positions, detail=piece.params.detail)


def photo(piece: Plush) -> Picture:
    """The piece in yarn, path-traced."""
    from tambour.render.photo import picture

    return picture(yarn(piece))


def surface(piece: Plush) -> Mesh:
    """The fabric that bounds the piece, as a mesh through its stitches; closed for every closed part."""
    from tambour.crochet.yarn.surface import mesh

    not_empty(piece)
    graph = piece.built.graph
    return mesh(replace(graph, faces=graph.faces[piece.built.shell]), piece.positions)


def graph(piece: Plush) -> dict[str, Any]:
    """The graph and its shape as plain data, positions in mm."""
    from tambour.core.graph import BACK, BLO, FLO, FRONT, ROOT, TIP

    g = piece.built.graph
    odd = {ROOT: "root", TIP: "tip", FLO: "FLO", BLO: "BLO"}
    loops = {FRONT: "front", BACK: "back"}
    return {
        "craft": "crochet",
        "parts": [{"name": p.name, "start": p.start, "end": p.end} for p in g.parts],
        "nodes": {
            "kind": [g.kinds[k] for k in g.kind],
            "part": g.part.tolist(),
            "color": g.color.tolist(),
            "parent": g.parent.tolist(),
            "round": g.round.tolist(),
            "loop": [loops.get(int(k), "both") for k in g.loop],
            "peculiarity": [odd.get(int(k)) for k in g.peculiarity],
            "plane": [None if min(p) < 0 else p for p in g.plane.tolist()],
            "span": g.span.tolist(),
        },
        "edges": g.edges.tolist(),
        "sewn": piece.built.sewn.tolist(),
        "centroids": piece.centroids.tolist(),
        "positions": piece.positions.tolist(),
        "faces": g.faces.tolist(),
        "stitch_mm": list(piece.stitch),
    }

"""Facts: what the report says of a piece."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from tambour.core.rgb import hexed

if TYPE_CHECKING:
    from tambour.crochet.piece import Aim, Plush


def facts(piece: Plush) -> dict[str, Any]:
    """What the report says: counts, size, how the shape was reached, and where the fabric is tight."""
    import numpy as np

    from tambour.crochet.finish.features import materials
    from tambour.crochet.finish.joining import assembly
    from tambour.crochet.maker import size
    from tambour.crochet.maker.left_open import left_open
    from tambour.crochet.printed.choose import account
    from tambour.crochet.settle.forces import lengths

    built, g, shape = piece.built, piece.built.graph, piece.shape
    x, width = piece.positions, piece.stitch[0]
    kinds, counts = np.unique(g.kind, return_counts=True)

    measured = size.report(piece)
    ml = shape.volume * width**3 / 1000.0
    stretch = lengths(x, g.edges) / (g.rest * piece.params.link_distance) - 1.0 if len(g.edges) else np.zeros(0)
    tension: dict[str, Any] = {"mean": 0.0, "worst": 0.0, "node": None, "at": None}
    if len(stretch):
        k = int(abs(stretch).argmax())
        node = int(g.edges[k, 0])
        line, column = built.pattern.text.place(int(g.span[node, 0]))
        tension = {
            "mean": round(float(stretch.mean()), 5),
            "worst": round(float(stretch[k]), 5),
            "node": node,
            "at": f"{built.pattern.text.name}:{line}:{column}",
        }
    said = sum(w.line.stated is not None for w in built.worked)
    checked = (
        f"no mistake found: {sum(not r.aside for r in built.rounds)} rounds, {said} stated counts"
        if piece.params.check
        else None
    )
    return {
        **({"check": checked} if checked else {}),
        **account(built.pattern),
        **left_open(piece),
        "nodes": len(g),
        "edges": len(g.edges),
        "stitches": {g.kinds[k]: int(n) for k, n in zip(kinds, counts)},
        "parts": [
            {
                "name": p.name,
                "nodes": p.end - p.start,
                "size_mm": [measured["parts"][k][side]["mm"] for side in ("width", "height", "depth")],
                "volume_ml": round(float(ml[k]), 3),
                "stuffing": p.stuffing,
            }
            for k, p in enumerate(g.parts)
        ],
        "rounds": [{"part": r.part, "number": r.number, "stitches": r.count} for r in built.rounds if not r.aside],
        **(_aim(piece.aim) if piece.aim is not None else {}),
        "size": measured,
        "size_mm": [measured[side]["mm"] for side in ("width", "height", "depth")],
        "size_in": [measured[side]["in"] for side in ("width", "height", "depth")],
        "volume_ml": round(float(ml.sum()), 3),
        "features": materials(built, x),
        **({} if piece.params.check else _yarn(piece)),
        "stitch_mm": list(piece.stitch),
        "stuffing": piece.stuffing,
        "start": piece.start,
        "residual": shape.residual,
        "settled": shape.settled,
        "evaluations": shape.evaluations,
        "tension": tension,
        "assembly": (
            assembly(piece.joining, shape.joined, x) if piece.joining is not None and shape.joined is not None else []
        ),
    }


def _aim(aim: Aim) -> dict[str, Any]:
    """How far the plush lies from its model."""
    d = aim.distance
    names = {"mean": "mean", "p95": "95 %", "largest": "largest"}
    said = ", ".join(
        f"{name} {d[key]:.2g} stitches ({d[key + '_percent']:.2g} % of its size)" for key, name in names.items()
    )
    stood = {"stands": aim.stands} if aim.stands else {}
    return {**stood, "off_the_model": said, "distance": d, "distance_of_parts": aim.parts, "history": aim.history}


def _yarn(piece: Plush) -> dict[str, Any]:
    """What it takes of yarn and all else; a tech edit tells of the pattern alone."""
    from tambour.crochet.maker.materials import lengths, materials

    metres = lengths(piece)
    return {
        "yarn": [
            {"color": hexed(shade), "metres": round(m, 2), "yards": round(m / 0.9144, 2)} for shade, m in metres.items()
        ],
        "materials": materials(piece),
        "yarn_metres": round(sum(metres.values()), 2),
    }

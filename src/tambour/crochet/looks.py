"""Looks: a piece as meshes (in its yarn, with its doubts in red, as a bare surface), and as data."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any, Final

from tambour.crochet.piece import Plush, not_empty

if TYPE_CHECKING:
    from tambour.core.mesh import Mesh
    from tambour.crochet.graph.built import Built
    from tambour.crochet.language.finishes import Finish
    from tambour.crochet.places.names import Made

LEAST: Final = 0.1
"""A toy beside the largest one has so much of its stitches or more."""
BESIDE: Final = 0.12
"""A thing beside the toy is shown that has so much of its stitches."""
_REST: Final = frozenset(
    "edging piece side back front top bottom half section gusset lining border step abbreviation strip strand".split()
)
"""Words of parts that are pieces of something, and no thing for themselves."""
DOUBT: Final = (206, 42, 38)
PALE: Final = (228, 224, 216)
"""Colours of the picture of a tech edit: stitches that it doubts, and what the others are mixed with."""


def yarn(piece: Plush, *, detail: str | None = None) -> Mesh:
    """The piece in yarn, with its face: every stitch swept to tubes, over a dark lining; detail : else what was asked for."""
    from tambour.crochet.finish.features import joined, meshes
    from tambour.crochet.yarn.fabric import mesh

    not_empty(piece)
    detail = detail or piece.params.detail
    face, led = meshes(piece.built, piece.positions, piece.yarn, detail=detail, upright=piece.upright)
    worked = mesh(piece.built.graph, piece.positions, detail=detail, made=led, material=piece.params.material)
    return joined([worked, *face]) if face else worked


def toy(piece: Plush, *, detail: str | None = None, azimuth: float = 0.0) -> Mesh:
    """The piece in yarn as pictures show it: only the parts that are :func:`in_sight`; detail : else as fits its size;
    azimuth : of who looks, radians."""
    import numpy as np

    from tambour.core.paths import Paths
    from tambour.crochet.finish.features import joined, meshes
    from tambour.crochet.graph.spots import whole
    from tambour.crochet.table import gathered
    from tambour.crochet.yarn.fabric import NEAR, mesh

    parts = in_sight(piece)
    if detail is None:
        near = piece.params.detail == "medium" and len(piece.built.graph) < NEAR
        detail = "near" if near else piece.params.detail
    if parts is None and not piece.built.pattern.terms:
        return yarn(piece, detail=detail)
    if parts is None:
        parts = list(range(len(piece.built.graph.parts)))
    graph, led = piece.built.graph, piece.yarn
    wanted = np.zeros(len(graph), bool)
    for k in parts:
        first, last = whole(graph, k)
        wanted[first:last] = True
    shift = gathered(graph, piece.positions, wanted, azimuth)
    positions = piece.positions + shift
    ends, stitch = led.paths.offsets, led.point_data["stitch"]
    keep = np.flatnonzero(np.minimum.reduceat(wanted[stitch], ends[:-1]))
    points = np.concatenate([np.arange(ends[k], ends[k + 1]) for k in keep])
    made = replace(
        led,
        paths=Paths(
            led.paths.coords[points] + shift[stitch[points]], np.concatenate([[0], np.cumsum(np.diff(ends)[keep])])
        ),
        radius=led.radius[points],
        color=led.color[keep],
        source=led.source[keep] if led.source is not None and len(led.source) else led.source,
        point_data={name: values[points] for name, values in led.point_data.items()},
    )
    face, made = meshes(_faced(piece.built, parts), positions, made, detail=detail, upright=piece.upright)
    fabric = replace(graph, faces=graph.faces[wanted[graph.faces].all(1)])
    worked = mesh(fabric, positions, detail=detail, made=made, material=piece.params.material)
    return joined([worked, *face]) if face else worked


def _faced(built: Built, parts: list[int]) -> Built:
    """``built`` without the eyes and stitches of parts that are not in sight: they would lie on the floor."""
    from tambour.crochet.graph.spots import Spots
    from tambour.crochet.language.finishes import Placed, Tie, spots_of

    known, pattern = Spots(built).parts, built.pattern
    seen = set(parts)

    def there(record: Finish) -> bool:
        return isinstance(record, (Placed, Tie)) or known.get(spots_of(record)[0].part) in seen

    return replace(built, pattern=replace(pattern, finish=tuple(r for r in pattern.finish if there(r))))


def _thing(part: Made) -> bool:
    """Whether a part that is sewn to nothing may be a thing beside the toy: a cup, a star; neither clothes nor limbs nor a rest."""
    import re

    named = not re.fullmatch(r"(?:part|piece)(?:_\w+)?|", part.name) and not _REST & set(part.words)
    return named and not part.worn and part.kind in ("", "bow")


def _without_rests(piece: Plush, filled: list[int]) -> list[int] | None:
    """The parts of a pattern that sews nothing together, as a doll's clothes, without edgings and scraps; None for all."""
    import re

    from tambour.crochet.places.names import Made

    parts, sections = piece.built.graph.parts, piece.built.pattern.parts
    made = {k: Made(sections[piece.built.parts[k].section].name, 1) for k in filled}
    size = {k: parts[k].end - parts[k].start for k in filled}
    of = piece.built.graph.part
    sewn = {int(of[n]) for a, b in piece.built.sewn.tolist() if of[a] != of[b] for n in (a, b)}
    kept = [
        k
        for k in filled
        if k in sewn
        or (
            not (_REST & set(made[k].words) and size[k] < max(size.values()))
            and not re.fullmatch(r"(?:part|piece)_\w+", made[k].name)
            and size[k] > BESIDE * max(size.values())
        )
    ]
    return kept if 0 < len(kept) < len(filled) else None


def in_sight(piece: Plush) -> list[int] | None:
    """The parts that pictures of a printed pattern's toy show; None for all of them.

    Clothes, limbs and unnamed parts that nothing places would only stand beside it.
    """
    import re

    from tambour.crochet.places.names import Made
    from tambour.crochet.settle.arrange import clusters

    graph, pattern = piece.built.graph, piece.built.pattern
    filled = [k for k, part in enumerate(graph.parts) if part.end > part.start]
    if not pattern.terms:
        return None
    if piece.joining is None or not piece.joining.joins:
        return _without_rests(piece, filled)
    label = clusters(graph)
    at = {k: int(label[graph.parts[k].start]) for k in filled}
    name = {k: pattern.parts[piece.built.parts[k].section].name for k in filled}
    of = [Made(name[k], 1) if k in name else Made("", 1) for k in range(len(graph.parts))]
    aside = {k for k in filled if of[k].kind or of[k].worn or re.fullmatch(r"(?:part|piece)(?:_\w+)?|", name[k])}
    aside -= {
        int(graph.part[n]) for a, b in piece.built.sewn.tolist() for n in (a, b) if graph.part[a] != graph.part[b]
    }
    from tambour.crochet.language.finishes import Eye

    known = piece.joining.spots.parts
    aside -= {known[r.spot.part] for r in pattern.finish if isinstance(r, Eye)}  # a star with eyes is a toy
    bare = [k for k in filled if not of[k].worn] or filled
    main = at[max(bare, key=lambda k: (of[k].kind in ("head", "body"), graph.parts[k].end - graph.parts[k].start))]
    seated = {k for k in filled if k not in aside or of[k].kind in ("head", "body")}
    size = {c: sum(graph.parts[k].end - graph.parts[k].start for k in filled if at[k] == c) for c in at.values()}
    toys = {main, *(at[k] for k in seated if list(at.values()).count(at[k]) > 1 and size[at[k]] > LEAST * size[main])}
    if sum(c == main for c in at.values()) > 2:
        # A toy is there: what is sewn to nothing is no part of it, unless it is a thing for itself.
        things = {k for k in filled if _thing(of[k]) and size[at[k]] > BESIDE * size[main]}
        aside = set(filled) - things
    kept = [k for k in filled if k not in aside or at[k] in toys]
    return kept if len(kept) < len(filled) else None


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

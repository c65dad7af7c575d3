"""Plush: the piece that crochet makes, and its making."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cache
from typing import TYPE_CHECKING, Any

from tambour.core.check import Array
from tambour.core.errors import TambourError, Text
from tambour.core.progress import Progress
from tambour.crochet.params import CrochetParams

if TYPE_CHECKING:
    from tambour.core.mesh import Mesh
    from tambour.core.picture import Picture
    from tambour.core.strands import Strands
    from tambour.crochet.finish.joining import Joining
    from tambour.crochet.finish.shape import Shape
    from tambour.crochet.graph.build import Built
    from tambour.crochet.maker.gauge import Gauge


DRAWN_TIGHT = 0.606
"""Yarn that hands take, as a share of the yarn that is drawn. The drawn yarn is led so that it nowhere touches itself,
13.2 widths to a single crochet in the round (13.1 in a tube, 13.3 in a ball, 13.0 in a disc); hands press it together
to 8 (:data:`tambour.crochet.maker.gauge.IN_A_STITCH`)."""

DOUBT, PALE = (206, 42, 38), (228, 224, 216)
"""Colours of the picture of a tech edit: stitches that it doubts, and what the others are mixed with."""


@dataclass(frozen=True, eq=False, slots=True)
class Plush:
    """A pattern in its shape.

    built : the pattern worked; params : what was asked for; stitch : width and height of a single crochet, mm
    gauge : where that size comes from; stuffing, start : what the options and the pattern together chose
    shape : how the shape was reached, in stitches; positions (N, 3) and centroids (C, 3) : the same in mm
    yarn : the yarn of every stitch, in mm
    joining : what was sewn on and where, None where the pattern says nothing of it
    """

    built: Built
    params: CrochetParams
    stitch: tuple[float, float]
    gauge: Gauge
    stuffing: str
    start: str
    shape: Shape
    positions: Array
    centroids: Array
    yarn: Strands
    joining: Joining | None = None

    @property
    def upright(self) -> Array | None:
        """Which way is up on every part (P, 3), None where all stand as they were worked."""
        return None if self.shape.joined is None else self.shape.joined.upright


def make(source: Text, params: CrochetParams, progress: Progress) -> Plush:
    """The plush of a pattern's text; TambourError with all that is wrong in it."""
    from tambour.crochet.finish import features
    from tambour.crochet.finish.joining import crowded, prepare
    from tambour.crochet.finish.pose import pose
    from tambour.crochet.finish.twist import twisted
    from tambour.crochet.graph.build import build
    from tambour.crochet.maker.gauge import gauge
    from tambour.crochet.printed.choose import read

    if params.photo:
        from tambour.render.photo import tracer

        tracer()  # what is missing is told before the work, not after it
    with progress.stage("parse"):
        pattern = read(source, max_stitches=params.max_stitches, strict=params.strict)
    known = gauge(params, pattern.stated)
    stitch = (known.width, known.height)
    with progress.stage("build"):
        built = pose(build(pattern, stitch=stitch, strict=params.strict), params.pose)
        joining = prepare(built)
    if params.check:
        from tambour.crochet.graph.check import tech_edit

        found = tech_edit(built)
        if found:
            raise TambourError(found)
    for warning in built.warnings:
        progress.warn(warning)
    for warning in joining.doubts if joining is not None else ():
        progress.warn(warning)
    # Only now: a mistake in the pattern is told at once, not when the kernels are loaded.
    with progress.stage("start"):
        warm()
        if features.present(built):
            features.warm()
    for warning in [*(crowded(joining) if joining is not None else []), *twisted(built)]:
        progress.warn(warning)
    return _shaped(built, joining, params, known, progress)


def _shaped(built: Built, joining: Joining | None, params: CrochetParams, known: Gauge, progress: Progress) -> Plush:
    """The plush of a pattern that was worked."""
    import numpy as np

    from tambour.crochet.finish.features import doubts
    from tambour.crochet.finish.joining import with_seams
    from tambour.crochet.finish.shape import Task, simulate
    from tambour.crochet.settle.body import centroid_counts
    from tambour.crochet.yarn.fabric import strands

    stitch = (known.width, known.height)
    if joining is not None and joining.steps:
        built = replace(built, graph=with_seams(built.graph, joining.pinched, stitch[0]))
    with progress.stage("settle"):
        start = params.start or built.initializer or "rounds"
        stuffing = params.stuffing or "pressure"
        # Sheets inside the piece are fabric, but do not bound its volume.
        shell = replace(built.graph, faces=built.graph.faces[built.shell])
        counts = centroid_counts(shell, params, [part.centroids for part in built.parts])
        snug = stuffing == "pressure" and params.solver == "settle"
        shape = simulate(Task(shell, params, stitch[0], stuffing, start, counts, snug, joining), progress.step)
        if shape.joined is not None:
            pairs = np.concatenate(shape.joined.seams) if shape.joined.seams else np.zeros((0, 2), int)
            built = replace(built, graph=with_seams(built.graph, pairs, stitch[0]))
    if not shape.settled:
        progress.warn(
            f"the shape is not quite at rest: the largest force left is {shape.residual:.2g} stitches",
            "it may still be good to look at; --tolerance sets the goal, --no-contact is easier to settle",
        )
    if shape.hurried and params.solver == "steps":
        progress.warn(
            f"{params.steps} steps do not finish the building", "the last nodes were placed at once; take more --steps"
        )
    elif shape.hurried:
        progress.warn(
            "building one by one was cut short: the last nodes were placed at once", "--start rounds is faster"
        )
    x, c = shape.x * stitch[0], shape.c * stitch[0]
    if params.solver == "settle" and built.up == "start" and shape.joined is None:
        x, c = x * (-1.0, -1.0, 1.0), c * (-1.0, -1.0, 1.0)  # half a turn, the front stays in front
    if params.check:
        from tambour.crochet.graph.check import size_edit

        if found := size_edit(built, tuple(np.ptp(x, axis=0))):
            raise TambourError(found)
    for doubt in doubts(built, x):
        progress.warn(doubt)
    with progress.stage("fabric"):
        yarn = strands(built.graph, x, detail=params.detail)
    return Plush(built, params, stitch, known, stuffing, start, shape, x, c, yarn, joining)


def yarn(piece: Plush) -> Mesh:
    """The piece in yarn, with its face: every stitch swept to tubes, over a dark lining."""
    from tambour.crochet.finish.features import joined, meshes
    from tambour.crochet.yarn.fabric import mesh

    not_empty(piece)
    detail = piece.params.detail
    face, led = meshes(piece.built, piece.positions, piece.yarn, detail=detail, upright=piece.upright)
    worked = mesh(piece.built.graph, piece.positions, detail=detail, made=led)
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


def not_empty(piece: Plush) -> None:
    """Refuses a piece without a stitch, for views that show one."""
    if not len(piece.built.graph):
        raise TambourError(
            "the pattern makes no stitch: there is nothing to show",
            hint="begin with a magic ring: a line such as : MR(6)",
            where=piece.built.pattern.text.name,
        )


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


def facts(piece: Plush) -> dict[str, Any]:
    """What the report says: counts, size, how the shape was reached, and where the fabric is tight."""
    import numpy as np

    from tambour.crochet.finish.features import materials
    from tambour.crochet.finish.joining import assembly
    from tambour.crochet.maker import size
    from tambour.crochet.maker.materials import lengths as metres
    from tambour.crochet.maker.materials import materials as needed
    from tambour.crochet.printed.choose import account
    from tambour.crochet.settle.forces import lengths

    built, g, shape = piece.built, piece.built.graph, piece.shape
    x, width = piece.positions, piece.stitch[0]
    kinds, counts = np.unique(g.kind, return_counts=True)

    measured = size.report(piece)
    length = metres(piece)
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
    checked = f"no mistake found: {len(built.rounds)} rounds, {said} stated counts" if piece.params.check else None
    return {
        **({"check": checked} if checked else {}),
        **account(built.pattern),
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
        "rounds": [{"part": r.part, "number": r.number, "stitches": r.count} for r in built.rounds],
        "size": measured,
        "size_mm": [measured[side]["mm"] for side in ("width", "height", "depth")],
        "size_in": [measured[side]["in"] for side in ("width", "height", "depth")],
        "volume_ml": round(float(ml.sum()), 3),
        "yarn": [
            {"color": "#{:02x}{:02x}{:02x}".format(*shade), "metres": round(m, 2), "yards": round(m / 0.9144, 2)}
            for shade, m in length.items()
        ],
        "features": materials(built, x),
        "materials": needed(piece),
        "yarn_metres": round(sum(length.values()), 2),
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


@cache
def warm() -> None:
    """Load every kernel, once, by shaping a tiny piece in every way."""
    from tambour.crochet.finish.joining import prepare
    from tambour.crochet.graph.build import build
    from tambour.crochet.language.parse import parse
    from tambour.crochet.maker.gauge import gauge

    one = "== a ==\n@stuffing = light\n: MR(6)\n: BLO, 6 inc\n: 12 sc\n: 6 dec\nFO\n"
    other = "== b ==\n@stuffing = none\n: MR(6)\n: 6 inc\n2: 12 sc\nplace(b, a, round=2)\n"
    built = build(parse(Text(one + other)))
    joining = prepare(built)
    for stuffing in ("pressure", "centroid", "skeleton"):
        known = gauge(CrochetParams(), {})
        piece = _shaped(built, joining, CrochetParams(stuffing=stuffing, tolerance=0.1), known, Progress())
    facts(piece)
    yarn(piece)
    surface(piece)

"""Plush: a pattern's text becomes the piece; the whole flow on one page."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from tambour.core.errors import Problem, TambourError, Text
from tambour.core.progress import Progress
from tambour.crochet.params import CrochetParams
from tambour.crochet.piece import Plush, mirrored

if TYPE_CHECKING:
    from tambour.core.drawing import Drawing
    from tambour.core.mesh import Mesh as Model
    from tambour.crochet.finish.joining import Joining
    from tambour.crochet.finish.shape import Look
    from tambour.crochet.graph.built import Built
    from tambour.crochet.yarns import Gauge


def make(source: Text | Drawing | Model | None, params: CrochetParams, progress: Progress) -> Plush:
    """The plush of a pattern's text, of the pattern that drawn profiles or a model become, or of a specimen; TambourError
    with all that is wrong in it."""
    if (source is None) == (params.specimen is None):
        both = source is not None
        raise TambourError(
            "a specimen needs no pattern" if both else "crochet needs a source",
            hint="leave out the pattern, or {--specimen}" if both else "name a pattern, or take {--specimen} all",
        )
    if source is None:
        from tambour.crochet.specimens import text

        source = Text(text(str(params.specimen)), f"{params.specimen}.acl")
    from tambour.core.mesh import Mesh

    if isinstance(source, Mesh):
        if params.target is not None:
            progress.warn("has no effect on a model: the plush is compared with the model itself", where="{--target}")
        piece = _modelled(source, params, progress)
        return mirrored(piece) if params.hand == "left" else piece
    built, joining, known = _built(_text(source, params, progress), params, progress)
    if "material" not in params.model_fields_set and "fibre" in built.pattern.stated:
        params = params.model_copy(update={"material": built.pattern.stated["fibre"][0]})
    piece = _shaped(built, joining, params, known, progress)
    if params.hand == "left":
        piece = mirrored(piece)
    if params.target is None:
        return piece
    if not len(piece.built.graph.faces[piece.built.shell]):
        progress.warn("has no effect: nothing of this pattern is a surface", where="{--target}")
        return piece
    from tambour.crochet.model.aim import sought

    with progress.stage("compare"):
        return replace(piece, aim=sought(params.target, piece))


def _modelled(mesh: Model, params: CrochetParams, progress: Progress) -> Plush:
    """The plush of the pattern that a model becomes, and how far it lies from the model."""
    from tambour.crochet.model.compare import aimed
    from tambour.crochet.model.design import design

    made = design(mesh, params, progress, mesh.name or "model")
    built, joining, known = _built(made.text, params, progress)
    piece = _shaped(built, joining, params, known, progress)
    with progress.stage("compare"):
        return replace(piece, aim=aimed(made, piece))


def _text(source: Text | Drawing, params: CrochetParams, progress: Progress) -> Text:
    """The text of what is a text; of a drawing or a formula that of the bodies it turns; with what is to be redrawn."""
    turned = not isinstance(source, Text)
    if isinstance(source, Text) and source.text.lstrip()[:1] == "r":
        from tambour.crochet.model.outline import is_formula

        turned = is_formula(source)
    for name in (*(() if turned else ("stitches", "height")), "tip", "model_up", "model_front", "colors"):
        if getattr(params, name) is not None:
            option = name.replace("_", "-")
            what = "a profile" if turned else "a pattern"
            progress.warn(f"has no effect on {what}: it is for models (.stl .obj .ply .glb)", where=f"{{--{option}}}")
    if turned:
        from tambour.crochet.model.drawn import drawn

        with progress.stage("model"):
            source = drawn(source, params, progress)
    assert isinstance(source, Text)
    if params.reshape is None:
        return source
    from tambour.crochet.model.drawn import redrawn

    plain = params.model_copy(update={"check": False, "strict": False})
    built, _, known = _built(source, plain, Progress())
    with progress.stage("model"):
        return redrawn(built, plain, (known.width, known.height), progress)


def worked(source: Text, params: CrochetParams) -> tuple[Built, list[Problem]]:
    """A pattern's text worked, stitch by stitch, with all that is doubtful, the tech edit's doubts among it; nothing
    is shaped. TambourError with all that is wrong."""
    from tambour.crochet.graph.check import tech_edit

    progress = Progress()
    built, _, _ = _built(source, params.model_copy(update={"check": False}), progress)
    return built, [*progress.warnings, *(replace(p, warning=True) for p in tech_edit(built))]


def _built(source: Text, params: CrochetParams, progress: Progress) -> tuple[Built, Joining | None, Gauge]:
    """A pattern's text worked, what is sewn on how, and the gauge."""
    from tambour.crochet.finish.joining import crowded, prepare, prepare_what_stands
    from tambour.crochet.finish.poised import doubts
    from tambour.crochet.finish.pose import pose
    from tambour.crochet.finish.twist import twisted
    from tambour.crochet.graph.build import build
    from tambour.crochet.graph.check import miscounted
    from tambour.crochet.graph.spots import Spots
    from tambour.crochet.maker.gauge import gauge, odd_hook
    from tambour.crochet.printed.choose import read

    with progress.stage("parse"):
        pattern = read(
            source,
            max_stitches=params.max_stitches,
            strict=params.strict,
            high=lambda stated: gauge(params, stated).height,
            size=params.size,
        )
    known = gauge(params, pattern.stated)
    stitch = (known.width, known.height)
    with progress.stage("build"):
        built = pose(build(pattern, stitch=stitch, strict=params.strict), params.pose)
        if pattern.terms and not params.strict:
            built, joining = prepare_what_stands(built)
        else:
            joining = prepare(built)
    said = [*built.pattern.unread, *built.warnings]
    if (doubt := odd_hook(known)) is not None:
        progress.warn(*doubt)
    if joining is not None:
        said += [*joining.doubts, *crowded(joining)]
    said += [*twisted(built), *(doubts(Spots(built)) if any(part.stands for part in built.pattern.parts) else ())]
    if params.check:
        from tambour.crochet.graph.check import tech_edit

        if found := tech_edit(built):
            known_of = {(p.message, p.span) for p in found}
            told = [replace(p, warning=True) for p in dict.fromkeys(said) if (p.message, p.span) not in known_of]
            raise TambourError(sorted([*found, *told], key=_first_told))
    for warning in sorted(dict.fromkeys(said), key=lambda p: not miscounted(p)):
        progress.warn(warning)
    return built, joining, known


def _first_told(problem: Problem) -> tuple[bool, bool, int]:
    """Mistakes of counts before all others, and these before doubts, each in the order of the text."""
    from tambour.crochet.graph.check import miscounted

    return not miscounted(problem), problem.warning, problem.span.start if problem.span else 0


def _shaped(built: Built, joining: Joining | None, params: CrochetParams, known: Gauge, progress: Progress) -> Plush:
    """The plush of a pattern that was worked."""
    import numpy as np

    from tambour.crochet.finish.features import doubts
    from tambour.crochet.finish.joining import flat_parts, with_seams
    from tambour.crochet.finish.placing import standing
    from tambour.crochet.finish.poised import set_up
    from tambour.crochet.finish.pulled import pulled
    from tambour.crochet.finish.shape import Task, carried, seen, simulate
    from tambour.crochet.graph.spots import Spots
    from tambour.crochet.settle.body import centroid_counts
    from tambour.crochet.table import laid_out

    stitch = (known.width, known.height)
    if joining is not None and joining.joins:
        built = replace(built, graph=with_seams(built.graph, joining.pinched, stitch[0]))
    start = params.start or built.initializer or "rounds"
    if start == "one-by-one":
        _told_ahead(len(built.graph), params, progress)
    with progress.stage("settle"):
        stuffing = params.stuffing or "pressure"
        # Sheets inside the piece are fabric, but do not bound its volume.
        shell = replace(pulled(built, built.graph), faces=built.graph.faces[built.shell])
        counts = centroid_counts(shell, params, [part.centroids for part in built.parts])
        snug = stuffing == "pressure" and params.solver == "settle"
        usual = params.bending == CrochetParams.model_fields["bending"].default
        several = len(built.parts) > 1 or joining is not None
        laid = flat_parts(built) if several and not built.pattern.exact and usual else frozenset()

        def tell(look: Look) -> None:
            progress.step(look.done, look.total)
            progress.look(lambda: seen(look, stitch[0]))

        shape = simulate(Task(shell, params, stitch[0], stuffing, start, counts, snug, joining, laid), tell)
        if shape.joined is not None:
            pairs = np.concatenate(shape.joined.seams) if shape.joined.seams else np.zeros((0, 2), int)
            built = replace(built, graph=with_seams(built.graph, pairs, stitch[0]))
    if not shape.settled:
        progress.warn(
            f"the shape is not quite at rest: the largest force left is {shape.residual:.2g} stitches",
            "it may still be good to look at; {--tolerance} sets the goal, {--no-contact} is easier to settle",
        )
    if shape.hurried and params.solver == "steps":
        progress.warn(
            f"{params.steps} steps do not finish the building",
            "the last nodes were placed at once; take more {--steps}",
        )
    elif shape.hurried:
        progress.warn(
            "building one by one was cut short: the last nodes were placed at once", "{--start} rounds is faster"
        )
    x, c = shape.x * stitch[0], shape.c * stitch[0]
    if params.solver == "settle" and shape.joined is None:
        x, c = standing(x, built.up), standing(c, built.up)
        if shape.task is not None and any(part.stands for part in built.pattern.parts):
            up = set_up(Spots(built), x)
            x, c = up, carried(shape.task, x, up, c)
    if params.solver == "settle" and not built.pattern.exact:
        x = laid_out(built, x)
    if params.check:
        from tambour.crochet.graph.check import size_edit

        if found := size_edit(built, tuple(np.ptp(x, axis=0))):
            raise TambourError(found)
    for doubt in doubts(built, x):
        progress.warn(doubt)
    piece = Plush(built, params, stitch, known, stuffing, start, shape, x, c, joining)
    if built.pattern.terms and params.solver == "settle" and joining is not None and joining.joins:
        from tambour.crochet.finish.sound import told
        from tambour.crochet.looks import in_sight

        for doubt in told(built, x, in_sight(piece), piece.upright):
            progress.warn(doubt)
    return piece


def _told_ahead(nodes: int, params: CrochetParams, progress: Progress) -> None:
    """Tell before the first step what building so many nodes one by one will not finish."""
    from tambour.crochet.finish.shape import BUILDING
    from tambour.crochet.settle.plain_steps import USUAL

    usual, longest = nodes * min(USUAL, params.wait_steps), nodes * params.wait_steps
    if params.solver == "steps" and params.steps < usual:
        progress.ahead(
            f"building {nodes} nodes one by one may take {usual} steps, {longest} at the most: {params.steps} may not be enough",
            "take more {--steps}, or let fewer {--wait-steps} pass before the next node",
        )
    elif params.solver == "settle" and usual * (nodes // 2 + 200) > BUILDING:
        progress.ahead(
            f"building {nodes} nodes one by one takes too long: it will be cut short, and the last ones placed at once",
            "{--start} rounds is faster",
        )

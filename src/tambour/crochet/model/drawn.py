"""Drawn: a drawing of profiles, or a formula, becomes the text of a pattern; what is to be reshaped gets its new text."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from tambour.core.drawing import Drawing
from tambour.core.errors import TambourError, Text

if TYPE_CHECKING:
    from tambour.core.progress import Progress
    from tambour.crochet.graph.built import Built
    from tambour.crochet.params import CrochetParams


def drawn(source: Drawing | Text, params: CrochetParams, progress: Progress) -> Text:
    """The pattern of bodies of revolution, in tambour's own language, made for the gauge that ``params`` say."""
    from tambour.crochet.maker.gauge import gauge
    from tambour.crochet.model.lathe import lathe, sized
    from tambour.crochet.model.outline import formula, outlines
    from tambour.crochet.model.rounds import printed

    known = gauge(params, {})
    stitch = (known.width, known.height)
    name = source.name if isinstance(source, Text) else source.about.get("title", "") or "the drawing"
    found = [formula(source)] if isinstance(source, Text) else outlines(source, name, progress.warn)
    parts, problems, used = [], [], set()
    for k, outline in enumerate(found):
        called = "".join(c if c.isalnum() else " " for c in outline.name).strip() or f"Part {k + 1}"
        while called in used:
            called += " too"
        used.add(called)
        try:
            made = lathe(
                sized(outline, params, stitch), stitch, name=called if len(found) > 1 else "Body", warn=progress.warn
            )
            parts.append(made)
        except TambourError as error:
            problems += [p if p.where else replace(p, where=name) for p in error.problems]
    if problems:
        raise TambourError(problems)
    lead = [f"Turned from a profile, for single crochets of {stitch[0]:.3g} x {stitch[1]:.3g} mm."]
    return printed(parts, name=name, lead=lead)


def redrawn(built: Built, params: CrochetParams, stitch: tuple[float, float], progress: Progress) -> Text:
    """The text of ``built`` with what ``--reshape`` redraws."""
    from tambour.crochet.model.outline import outlines
    from tambour.crochet.model.reshape import reshaped

    found = outlines(params.reshape, "{--reshape}", progress.warn)
    return reshaped(built, found, params.reshape_part or "", params, stitch, progress.warn)

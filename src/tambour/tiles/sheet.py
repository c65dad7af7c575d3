"""Sheet: a plotter's sheet of the endless scroll, with marks that tell where the next one continues it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tambour.core.progress import Progress
from tambour.work.piece import Done, Job
from tambour.work.piece import make as make_piece

if TYPE_CHECKING:
    from tambour.core.check import Array
    from tambour.core.drawing import Drawing
    from tambour.core.picture import Picture

LAYER = "registration"


def make(job: Job, laid: Mapping[str, Path], progress: Progress | None = None) -> Done:
    """The sheet that the job's parameter ``sheets`` numbers."""
    from tambour.run import craft

    ink = craft("ink")
    views = dict(ink.views)
    for name in ("scroll", "sheet", "plot"):
        views[name] = replace(views[name], make=whole)
    views["picture"] = replace(views["picture"], make=picture)
    return make_piece(job, laid, progress, replace(ink, views=views))


def whole(piece: Any) -> Drawing:
    """The sheet of a plot of one sheet, with its marks."""
    from tambour.ink.plotter import job

    (drawing,) = job.drawings(piece)
    return marked(drawing, piece.scroll.params.margin)


def picture(piece: Any) -> Picture:
    """The same on white."""
    from tambour.render import flat

    return flat.picture(replace(whole(piece), background=(255, 255, 255, 255)), width=piece.scroll.params.pixels)


def marked(drawing: Drawing, margin: float) -> Drawing:
    """The sheet with :func:`crosses` on a layer of their own, the last: another pen may draw it, or none."""
    import numpy as np

    lines = crosses(float(drawing.size[0]), float(drawing.size[1]), margin)
    paths, groups, number = drawing.paths, drawing.groups, len(drawing.groups)
    return replace(
        drawing,
        paths=replace(
            paths,
            coords=np.concatenate([paths.coords, *lines]),
            offsets=np.concatenate([paths.offsets, paths.offsets[-1] + 2 * np.arange(1, len(lines) + 1)]),
        ),
        style=np.concatenate([drawing.style, np.full(len(lines), len(drawing.styles) - 1, np.int32)]),
        group=np.concatenate([drawing.group, np.full(len(lines), number, np.int32)]),
        groups=replace(
            groups,
            ids=(*groups.ids, LAYER),
            names=(*groups.names, f"{number + 1} {LAYER}"),
            parent=np.append(groups.parent, np.int32(-1)),
            layer=np.append(groups.layer, True),
            data=(*groups.data, {}) if groups.data else (),
            zero=np.append(groups.zero, 0.0) if len(groups.zero) else groups.zero,
        ),
    )


def crosses(width: float, height: float, margin: float) -> list[Array]:
    """Lines (2, 2) of four crosses, mm: above and below where the drawing begins and ends.

    Where those at the right of a sheet lie over those at the left of the next, the scroll goes on without a gap.
    """
    import numpy as np

    arm = min(3.0, 0.35 * margin)
    made = []
    for x in (margin, width - margin):
        for y in (margin / 2, height - margin / 2):
            made.append(np.array([(x - arm, y), (x + arm, y)]))
            made.append(np.array([(x, y - arm), (x, y + arm)]))
    return made

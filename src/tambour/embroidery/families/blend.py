"""Blend: a fill in two threads, one thinning out along the way as the other grows."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from tambour.core.progress import Progress
from tambour.embroidery.piece import Region

ROWS = ("tatami", "gradient")
OPEN = 2.2  # times the first distance between rows is the last, when it is not given


def blended(found: Sequence[Region], progress: Progress) -> tuple[Region, ...]:
    """Regions with each fill that asks for a second colour as two, the second sewn over the first from the other end."""
    made: list[Region] = []
    for region in found:
        p = region.params
        made.append(region)
        if p.blend is None:
            continue
        if region.role != "area" or region.stitch not in ROWS:
            progress.warn(
                f"{region.id} is {region.stitch}, and is sewn in one thread",
                hint="{--stitch} tatami",
                where="{--blend}",
            )
            continue
        end = p.row_spacing_end or OPEN * p.row_spacing
        first = p.model_copy(update={"row_spacing_end": end, "blend": None})
        second = first.model_copy(update={"angle": (p.angle or 0.0) + 180, "underlay": "none"})
        rgb = tuple(int(p.blend[i : i + 2], 16) for i in (1, 3, 5))
        made[-1] = replace(region, stitch="gradient", params=first)
        made.append(replace(region, id=f"{region.id} (blend)", stitch="gradient", params=second, color=rgb))  # type: ignore[arg-type]
    return tuple(made)

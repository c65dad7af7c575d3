"""Decide: what nobody asked for of a region: here the angle of its rows."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from tambour.embroidery.lines.angle import angle
from tambour.embroidery.piece import Region


def angled(found: Sequence[Region]) -> tuple[Region, ...]:
    """Regions with rows along each one's own shape, and apart from those of the one before."""
    made: list[Region] = []
    for region in found:
        beside = [made[-1].params.angle] if made else []
        own = angle(region.paths, 1.0, beside)
        made.append(replace(region, params=region.params.model_copy(update={"angle": own})))
    return tuple(made)

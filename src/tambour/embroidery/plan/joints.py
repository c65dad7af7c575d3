"""Joints: where lines of one thread meet: which of them end below which, so that satin does not lie on satin."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from tambour.embroidery.families.choose import stroke, union
from tambour.embroidery.piece import Region

MOST = 5000
"""Lines above which joints are not sought."""


def joints(found: Sequence[Region], sequence: Sequence[int]) -> dict[int, Any]:
    """For each satin line, the shapely area of those that the same thread sews after it and that touch it.

    Only what is sewn before the thread is next changed counts: what comes later may lie on another colour.
    """
    import shapely

    lines = [k for k in sequence if found[k].role == "line" and found[k].stitch == "satin"]
    if not 1 < len(lines) <= MOST:
        return {}
    block = np.cumsum(
        [k > 0 and found[b].color != found[a].color for k, (a, b) in enumerate(zip([0, *sequence], sequence))]
    )
    of = dict(zip(sequence, block.tolist()))
    boxes = [_box(found[k]) for k in lines]
    tree = shapely.STRtree(boxes)
    shapes: dict[int, Any] = {}
    made: dict[int, Any] = {}
    for i, k in enumerate(lines):
        later = [lines[j] for j in tree.query(boxes[i]).tolist() if j > i and of[lines[j]] == of[k]]
        for j in [j for j in later if j not in shapes]:
            shapes[j] = union([stroke(line, found[j]) for line in found[j].paths])
        if later:
            made[k] = union([shapes[j] for j in later])
    return made


def _box(region: Region) -> Any:
    import shapely

    low, high = region.paths.coords.min(0) - region.width / 2, region.paths.coords.max(0) + region.width / 2
    return shapely.box(*low, *high)

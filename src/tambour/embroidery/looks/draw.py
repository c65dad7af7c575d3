"""The plan as lines: one shape per unbroken thread, grouped by thread colour."""

from __future__ import annotations

from typing import Any

import numpy as np

from tambour.core.drawing import Drawing, Groups, Styles
from tambour.core.paths import Paths
from tambour.core.rgb import hexed
from tambour.core.thread import COMMANDS, STITCH
from tambour.embroidery.piece import KINDS, Piece

MARGIN = 5.0  # mm


def stitch_lines(piece: Piece) -> Drawing:
    """The needle's way as a Drawing in mm: polylines of a thread's width, a layer per thread."""
    plan = piece.plan
    sewn = plan.command == STITCH
    first = np.flatnonzero(sewn & ~np.r_[False, sewn[:-1]])
    last = np.flatnonzero(sewn & ~np.r_[sewn[1:], False])
    lines = [plan.xy[max(0, a - 1) : b + 1] for a, b in zip(first, last)]
    thread = plan.thread[first]
    low, high = plan.xy[sewn].min(0) - MARGIN, plan.xy[sewn].max(0) + MARGIN
    styles = Styles.of(*((None, (*t.rgb, 255), 0.75 * piece.params.thread) for t in plan.threads))
    names = tuple(t.name or hexed(t.rgb) for t in plan.threads)
    groups = Groups(
        tuple(f"thread-{k + 1}" for k in range(len(names))), names, np.full(len(names), -1), np.ones(len(names), bool)
    )
    return Drawing(
        Paths.of(lines), thread, styles, high - low, thread, groups, origin=low, background=(255, 255, 255, 255)
    )


def stitch_table(piece: Piece) -> dict[str, Any]:
    """The plan as data: threads, and every needle point with its command, thread, region and kind."""
    plan = piece.plan
    return {
        "threads": [
            {"rgb": list(t.rgb), "name": t.name, "catalogue": t.catalogue, "code": t.code} for t in plan.threads
        ],
        "commands": list(COMMANDS),
        "kinds": list(KINDS),
        "regions": [r.id for r in piece.regions],
        "x_mm": np.round(plan.xy[:, 0], 4),
        "y_mm": np.round(plan.xy[:, 1], 4),
        "command": plan.command,
        "thread": plan.thread,
        "region": piece.region,
        "kind": piece.kind,
        "elevation_mm": np.round(piece.elevation, 4),
        "rows": piece.rows,
    }

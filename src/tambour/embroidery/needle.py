"""Needle points changed by hand on the made piece: moved, taken out, put in; numbered as ``-o x.stitches.json`` numbers them."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from pydantic import Field

from tambour.core.errors import Problem, TambourError
from tambour.core.params import Params, length
from tambour.core.progress import Progress
from tambour.craft import Change

FARTHEST = 1000.0
"""mm that a needle point may be from the hoop's middle."""


class Needle(Params):
    """A needle point is moved, taken out, or another is put in after it."""

    point: int = Field(ge=0, le=100_000_000)
    """Its number, from 0, in the piece as it is made from the drawing; later edits do not change numbers."""
    to: str = Field(max_length=60)
    """X,Y in mm from the hoop's middle, y down: moved there; +X,Y: put in after it; none: taken out."""


_PLACE = re.compile(r"(\+?)\(?\s*([-\d.eE]+\s*(?:mm|cm|in)?)\s*,\s*([-\d.eE]+\s*(?:mm|cm|in)?)\s*\)?")


def _needled(piece: Any, edits: Sequence[Needle], progress: Progress) -> Any:
    """The piece with its needle points changed; what lies over what is found anew."""
    import numpy as np

    from tambour.core.thread import STITCH
    from tambour.embroidery.plan.layers import elevation, layers

    plan = piece.plan
    problems: list[Problem] = []
    xy, gone = plan.xy.copy(), np.zeros(len(plan), np.bool_)
    put: list[tuple[int, float, float]] = []
    for edit in edits:
        where = f"{{--edit}} needle:{edit.point}={edit.to}"
        if edit.point >= len(plan) or plan.command[edit.point] != STITCH:
            what = f"there is no needle point {edit.point}"
            problems.append(Problem(what, f"0 to {len(plan) - 1}; commands and jumps have none", where=where))
            continue
        if edit.to.strip() == "none":
            gone[edit.point] = True
            continue
        found = _PLACE.fullmatch(edit.to.strip())
        try:
            x, y = (float(length(found[k])) for k in (2, 3)) if found else (math.inf, math.inf)
        except ValueError:
            x = y = math.inf
        if not max(abs(x), abs(y)) <= FARTHEST:
            problems.append(Problem(f"{edit.to!r} is no place", "X,Y in mm, +X,Y or none", where=where))
        elif found and found[1]:
            put.append((edit.point, x, y))
        else:
            xy[edit.point] = x, y
    if problems:
        raise TambourError(problems)
    order = np.r_[np.arange(len(plan)), np.array([p for p, _, _ in put], np.int64)]
    taken = np.argsort(order + 0.5 * (np.arange(len(order)) >= len(plan)), kind="stable")
    taken = taken[~np.r_[gone, np.zeros(len(put), np.bool_)][taken]]
    source = order[taken]
    xy = np.concatenate([xy, np.array([[x, y] for _, x, y in put]).reshape(-1, 2)])[taken]
    made = replace(plan, xy=xy, command=plan.command[source], thread=plan.thread[source])
    starts = np.zeros(len(plan) + 1, np.bool_)
    starts[piece.rows] = True
    # A run begins where its first point that is left stands; what was put in belongs to the run of the point before it.
    run = np.cumsum(starts[:-1])[source]
    rows = np.r_[0, np.flatnonzero(np.diff(run)) + 1, len(source)].astype(np.int64)
    region, kind = piece.region[source], piece.kind[source]
    lies = elevation(made, layers(region, kind), piece.params.thread)
    _doubted(made, progress)
    return replace(piece, plan=made, region=region, kind=kind, elevation=lies, rows=rows)


def _doubted(plan: Any, progress: Progress) -> None:
    import numpy as np

    from tambour.core.thread import STITCH

    step = np.hypot(*np.diff(plan.xy, axis=0).T)
    sewn = (plan.command[1:] == STITCH) & (plan.command[:-1] == STITCH)
    long = np.flatnonzero(sewn & (step > 12.1))
    if len(long):
        x, y = plan.xy[long[0] + 1].tolist()
        progress.warn(f"{len(long)} stitch(es) are longer than 12.1 mm, at ({x:.1f}, {y:.1f})", where="{--edit} needle")


NEEDLE = Change("needle points, one by one", Needle, "{point}={to}", after=_needled)

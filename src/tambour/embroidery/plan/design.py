"""A design that comes from a machine file: a piece without regions, to be seen, converted and laid on cloth."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tambour.core.check import Array
from tambour.core.progress import Progress
from tambour.core.thread import JUMP, STITCH, ThreadPlan
from tambour.embroidery.params import EmbroideryParams
from tambour.embroidery.piece import FILL, RUNNING, Piece
from tambour.embroidery.plan.layers import elevation
from tambour.embroidery.regions.catalogue import with_catalogue


def runs(plan: ThreadPlan) -> Array:
    """Offsets (S + 1,) of runs of one command that do not turn by more than 60 degrees."""
    step = np.diff(plan.xy, axis=0, prepend=plan.xy[:1])
    angle = np.arctan2(step[:, 1], step[:, 0])
    turn = np.abs(np.angle(np.exp(1j * np.diff(angle, prepend=angle[:1]))))
    begins = np.r_[True, (plan.command[1:] != plan.command[:-1]) | (turn[1:] > np.pi / 3)]
    return np.r_[np.flatnonzero(begins), len(plan)].astype(np.int64)


def piece_of(plan: ThreadPlan, params: EmbroideryParams, progress: Progress) -> Piece:
    """The piece of a plan as a machine file holds it.

    ``--width`` scales it: the stitches stay as many as they are, so that more than a tenth is a doubt.
    """
    for line in plan.about.get("doubts", "").splitlines():
        progress.warn(line, where=plan.about.get("format", ""))
    if plan.about.get("colours") == "not in the file":
        progress.warn(
            "the file holds no colours: the shades are ours",
            hint="the machine's own are what you thread",
            where=plan.about.get("format", ""),
        )
    sewn = plan.xy[plan.command == STITCH]
    if params.width is not None and np.ptp(sewn[:, 0]) > 0:
        scale = params.width / float(np.ptp(sewn[:, 0]))
        if not 0.9 <= scale <= 1.1:
            progress.warn(
                f"the design is scaled by {scale:.2f}: its stitches grow with it, and stand {1 / scale:.2f} times as dense",
                hint="machine files are made for one size; start from the drawing",
                where="{--width}",
            )
        plan = replace(plan, xy=plan.xy * scale)
    plan = with_catalogue(plan, params.catalogue)
    step = np.r_[0.0, np.hypot(*np.diff(plan.xy, axis=0).T)]
    kind = np.where((plan.command == JUMP) | (step < 1.0), RUNNING, FILL).astype(np.uint8)
    region = plan.thread.astype(np.int32) * 0 - 1
    # What was a layer to its digitiser is not in the file: each colour, and in it what is sewn within a minute.
    layer = plan.thread.astype(np.int64) * 1_000_000 + np.cumsum(plan.command == STITCH) // 700
    lies = elevation(plan, layer, params.thread)
    return Piece(None, (), params, plan, region, kind, lies, runs(plan))

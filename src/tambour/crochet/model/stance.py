"""Stance: how a body of a model stands, said by two of its stitches: the one on top, and the one in front."""

from __future__ import annotations

import numpy as np

from tambour.core.check import Array
from tambour.core.graph import ROOT, TIP
from tambour.crochet.finish.poised import turn
from tambour.crochet.graph.build import build
from tambour.crochet.graph.spots import Spots
from tambour.crochet.model.rounds import Rounds, pattern
from tambour.geometry.motion import fit, length, turned

MOST = 120
"""Stitches that are looked at for each, those that lie nearest to where it should."""
CLEAR = 0.05
"""How far off, in radians, a stitch that says itself where it is may be worth taking before one that is nearest by a hair."""


def stands(part: Rounds, x: Array, goal: Array) -> tuple[tuple[int, int], tuple[int, int]] | None:
    """Round and stitch of what is on top and of what is in front when a body at rest at ``x`` (N, 3) lies as at ``goal`` (N, 3), y up,
    z ahead: the two by which it is turned so most nearly; None of one without stitches."""
    spots = Spots(build(pattern([part])))
    built = spots.built
    plain = np.flatnonzero(~np.isin(built.graph.peculiarity, (ROOT, TIP)))
    if not len(plain):
        return None
    to, _ = fit(x, goal, np.ones(len(x)))
    off = turned(x - x.mean(0), to)[plain]
    off = off / np.maximum(length(off)[:, None], 1e-9)
    tops, fronts = (np.argsort(-off[:, k], kind="stable")[:MOST] for k in (1, 2))
    made = turn(*np.broadcast_arrays(off[tops][:, None], off[fronts][None]))
    away = np.arccos(np.clip(0.5 * (np.trace(made, axis1=2, axis2=3) - 1.0), -1.0, 1.0))
    # Of pairs that say it as well the stitches that lie where they are said to be.
    away = away + CLEAR * (2.0 - off[tops][:, 1][:, None] - off[fronts][:, 2][None])
    best = np.unravel_index(int(away.argmin()), away.shape)
    return _place(spots, int(plain[tops[best[0]]])), _place(spots, int(plain[fronts[best[1]]]))


def _place(spots: Spots, node: int) -> tuple[int, int]:
    """The number of a node's round, and of its stitch in it."""
    k = int(spots.built.graph.round[node])
    return spots.built.rounds[k].number, int(np.flatnonzero(spots.stitches(k) == node)[0]) + 1

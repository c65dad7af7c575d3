"""Curves: a piece's yarn as curves in space, with what look development asks of them: where along, how it is twisted, which stitch."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from tambour.core.scene import Scene
    from tambour.crochet.piece import Plush

PLIES = 4
LAY = 6.0
"""Diameters of the yarn in which its plies turn once about it."""


def curves(piece: Plush) -> Scene:
    """The yarn as one set of curves, mm. Of every point: ``st`` (turns of the lay along the yarn, 0), ``twist`` (degrees that
    the plies have turned), ``stitch``, ``round`` (-1 for seams); of every curve: ``ply``, how many plies it has."""
    from tambour.core.scene import Scene
    from tambour.crochet.piece import not_empty

    not_empty(piece)
    yarn = piece.yarn
    coords, offsets = yarn.paths.coords, np.asarray(yarn.paths.offsets)
    step = np.r_[0.0, np.sqrt((np.diff(coords, axis=0) ** 2).sum(axis=1))]
    step[offsets[:-1]] = 0.0
    # The twist is the yarn's own: where it is pressed thinner it is not twisted more.
    turns = np.cumsum(step) / (LAY * 2 * float(yarn.radius.max(initial=0.0) or 1.0))
    turns -= np.repeat(turns[offsets[:-1]], np.diff(offsets))
    stitch = np.asarray(yarn.point_data["stitch"])
    worked = np.where(stitch >= 0, piece.built.graph.round[np.maximum(stitch, 0)], -1)
    told = {
        "st": np.c_[turns, np.zeros(len(turns))].astype(np.float32),
        "twist": (360 * turns).astype(np.float32),
        "stitch": stitch.astype(np.int32),
        "round": worked.astype(np.int32),
    }
    ply = {"ply": np.full(len(yarn.paths), PLIES, np.int32)}
    return Scene((), (replace(yarn, point_data=told, strand_data=ply),), ("yarn",), root="crochet")

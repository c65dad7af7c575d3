"""Covered: what lies under a sewn-on end is not seen; all else is."""

from __future__ import annotations

import numpy as np

from crochet_toys import TEXT_BALL
from tambour.core.errors import Text
from tambour.core.progress import Progress
from tambour.crochet.finish.covered import seen
from tambour.crochet.params import CrochetParams
from tambour.crochet.piece import Plush
from tambour.crochet.plush import make

HORN = "== Horn ==\nR1: MR(6)\nR2: 6 inc\nR3-R6: 12 sc\n"


def made(text: str) -> Plush:
    return make(Text(text), CrochetParams(), Progress())


def test_what_lies_under_an_end_is_not_seen_and_all_else_is() -> None:
    piece = made(TEXT_BALL + HORN + "place(Horn, Ball, round=6, stitch=12)\n")
    graph, x = piece.built.graph, piece.positions
    assert piece.shape.joined is not None
    shell = graph.faces[piece.built.shell]
    kept = set(map(tuple, seen(graph, x, piece.shape.joined, shell).tolist()))
    hidden = np.array([face for face in shell.tolist() if tuple(face) not in kept])
    rim = x[np.unique(piece.shape.joined.seams[0][:, 0])]
    radius = np.sqrt(((rim - rim.mean(0)) ** 2).sum(1)).mean()
    assert (graph.part[hidden] == 0).all()  # of the ball, not of the horn
    assert np.sqrt(((x[hidden].mean(1) - rim.mean(0)) ** 2).sum(1)).max() < 1.2 * radius
    a, b, c = (x[hidden[:, k]] for k in range(3))
    area = 0.5 * np.sqrt((np.cross(b - a, c - a) ** 2).sum(1)).sum()
    assert 0.3 < area / (np.pi * radius**2) < 1.3


def test_of_a_part_by_itself_all_is_seen() -> None:
    piece = made(TEXT_BALL)
    shell = piece.built.graph.faces[piece.built.shell]
    assert (seen(piece.built.graph, piece.positions, None, shell) == shell).all()

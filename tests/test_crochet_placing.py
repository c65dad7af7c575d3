"""Placing: spots by round and stitch are points of the fabric, with directions; wrong ones are told with their places."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from tambour.core.errors import Text
from tambour.core.progress import Progress
from tambour.crochet.build import build
from tambour.crochet.finish import Eye, Spot
from tambour.crochet.params import CrochetParams
from tambour.crochet.parse import parse
from tambour.crochet.placing import frames
from tambour.crochet.plush import Plush, make
from tambour.crochet.spots import Spots, numbers

BALL = """== Head ==
R1: MR(6) (6)
R2: 6 inc (12)
R3: [sc, inc] x 6 (18)
R4: [2 sc, inc] x 6 (24)
R5-R9: 24 sc (24)
R10: [2 sc, dec] x 6 (18)
R11: [sc, dec] x 6 (12)
R12: 6 dec (6)
FO
"""


@cache
def toy(text: str) -> Plush:
    return make(Text(text), CrochetParams(), Progress())


def test_rounds_bear_the_numbers_that_are_written() -> None:
    assert numbers(build(parse(Text(BALL)))) == list(range(1, 13))
    assert numbers(build(parse(Text(": MR(6)\n: 6 inc\n2: 12 sc\n")))) == [1, 2, 3, 4]
    assert numbers(build(parse(Text("R5: MR(6)\nR6-R8: 6 sc\n")))) == [5, 6, 7, 8]
    assert numbers(build(parse(Text("ch 7\nturn\nR1: 6 sc\nturn\nR2: 6 sc\n")))) == [0, 1, 2]


def test_a_whole_stitch_is_its_node_and_shares_are_between() -> None:
    built = build(parse(Text(BALL)))
    spots, first = Spots(built), built.rounds[5].first
    assert spots.place(Spot("Head", 6, 1)).nodes == (first,)
    assert spots.place(Spot("Head", 6, 24)).nodes == (first + 23,)
    between = spots.place(Spot("Head", 6, 24.25))
    assert between.nodes == (first + 23, first) and between.weights == (0.75, 0.25)
    assert spots.place(Spot("Head", 0, None)).nodes == (0,)
    assert spots.place(Spot("Head", 13, None)).nodes == (len(built.graph) - 1,)
    # Plain rounds stand stitch on stitch; where two become one, the one stands on both.
    up = spots.place(Spot("Head", 6.5, 5))
    assert up.nodes == (first + 4, built.rounds[6].first + 4) and up.weights == (0.5, 0.5)
    row = built.rounds[9].first
    assert spots.place(Spot("Head", 9.5, 3.5)).nodes == (built.rounds[8].first + 2, built.rounds[8].first + 3, row + 2)


def test_frames_lie_on_the_fabric() -> None:
    piece = toy(BALL)
    x = piece.positions
    spots = [Spot("Head", r, None) for r in (3, 5.5, 7, 8.5, 11)] + [Spot("Head", 7, 1), Spot("Head", 0, None)]
    points, normals, along, up = frames(piece.built, x, spots)
    for a, b, dot in ((normals, normals, 1), (along, along, 1), (along, up, 0), (up, normals, 0), (along, normals, 0)):
        assert (a * b).sum(1) == pytest.approx(dot, abs=1e-9)
    assert np.cross(along, up) == pytest.approx(normals)
    middle = x.mean(0)
    assert (((points - middle) * normals).sum(1) > 0.8 * np.linalg.norm(points - middle, axis=1)).all()
    # No stitch said: the front. Its first stitch: the back.
    assert (normals[1:4, 2] > 0.8).all() and normals[5, 2] < -0.8 and normals[6, 1] < -0.9
    assert (up[1:4, 1] > 0.7).all() and (along[1:4, 0] > 0.8).all()
    # A part that leans: up leans with it.
    turned = np.array([[1.0, 0.0, 0.0]])
    assert (frames(piece.built, x, spots[2:3], turned).up[:, 0] > 0.8).all()


def test_wrong_spots_are_told_at_their_places() -> None:
    text = (
        BALL + "eye(Head, round=14)\neye(Head, round=6, stitch=25)\neye(Head, round=12.5)\nembroider(Head, 3:2, 4:30)\n"
    )
    pattern = parse(Text(text))
    told = list(Spots(build(pattern)).problems(pattern.finish))
    assert [(p.span and text[p.span.start : p.span.end], p.message) for p in told] == [
        ("Head", '"Head" has no round 14'),
        ("Head", 'round 6 of "Head" has 24 stitches, not 25'),
        ("4:30", 'round 4 of "Head" has 24 stitches, not 30'),
    ]
    assert isinstance(pattern.finish[0], Eye)

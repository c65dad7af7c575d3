"""Threads pulled through: they hold two places as near as is said, never push, and are printed so that they read back."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from crochet_toys import TEXT_BALL
from tambour.core.errors import TambourError, Text
from tambour.core.progress import Progress
from tambour.crochet.graph.spots import Spots
from tambour.crochet.language.finishes import Tie
from tambour.crochet.page.instructions import plain
from tambour.crochet.params import CrochetParams
from tambour.crochet.piece import Plush
from tambour.crochet.plush import make
from tambour.crochet.printed.choose import read
from tambour.crochet.settle import forces
from tambour.crochet.words.table import TERMS


@cache
def made(*lines: str) -> Plush:
    return make(Text(TEXT_BALL + "".join(line + "\n" for line in lines)), CrochetParams(), Progress())


def apart(piece: Plush, one: tuple[int, int], other: tuple[int, int]) -> float:
    spots = Spots(piece.built)
    a, b = (piece.positions[spots.stitches(k - 1)[s - 1]] for k, s in (one, other))
    return float(np.sqrt(((a - b) ** 2).sum()))


def test_two_places_are_as_near_as_is_said() -> None:
    free, tied = made(), made("tie(Ball, 6:1, 6:13, apart=22)")
    assert apart(free, (6, 1), (6, 13)) > 34.0
    assert apart(tied, (6, 1), (6, 13)) == pytest.approx(22.0, abs=2.5)  # wool gives way
    assert apart(tied, (6, 7), (6, 19)) > apart(free, (6, 7), (6, 19)) + 1.0  # the stuffing goes aside
    assert tied.shape.settled
    assert len(tied.built.graph.edges) == len(free.built.graph.edges)  # a thread is no fabric


def test_a_slack_thread_does_nothing() -> None:
    a, b = made().built.graph.edges.T
    slack, free = (
        np.sqrt(((one.positions[a] - one.positions[b]) ** 2).sum(1))
        for one in (made("tie(Ball, 6:1, 6:13, apart=60)"), made())
    )
    np.testing.assert_allclose(slack, free, atol=0.05)  # mm; the whole may lie turned a little


def test_the_pull_is_a_spring_that_only_pulls() -> None:
    x = np.array([[0.0, 0.0, 0.0], [3.0, 4.0, 0.0], [0.0, 0.0, 2.0]])
    D = np.zeros((3, 3))
    forces.thread(x, np.array([[1, 0], [2, 0]], np.int32), np.array([4.0, 2.5]), D)
    np.testing.assert_allclose(D, [[0.6, 0.8, 0.0], [-0.6, -0.8, 0.0], [0.0, 0.0, 0.0]])


@pytest.mark.parametrize("code", list(TERMS))
def test_it_is_printed_so_that_it_reads_back(code: str) -> None:
    line = "tie(Ball, 6:1, 7.5:13, apart=22)"
    shown = plain(make(Text(TEXT_BALL + line), CrochetParams(terms=code, stuffing="none"), Progress()))
    assert [type(f) for f in read(shown).finish] == [Tie], TERMS[code].sentences["tie"]
    (tie,) = read(shown).finish
    assert [(s.part, s.round, s.stitch) for s in tie.spots] == [("Ball", 6.0, 1.0), ("Ball", 7.5, 13.0)]
    assert tie.apart == 22.0


@pytest.mark.parametrize(
    "line, word",
    [
        ("tie(Ball, 6:1, apart=9)", "from one place to another"),
        ("tie(Ball, 6:1, 6:3)", "from one place to another"),
        ("tie(Ball, 6:1, 6:3, 6:5, apart=9)", "from one place to another"),
        ("tie(Ball, 6, 7:3, apart=9)", "needs its stitch"),
        ("tie(Ball, 6:1, 6:5, apart=-1)", "does not fit apart"),
        ("tie(Ball, 6:1, 6:5, apart=9, color=red)", "nothing that tie takes"),
        ("tie(Bell, 6:1, 6:5, apart=9)", 'no part "Bell"'),
        ("tie(Ball, 46:1, 6:5, apart=9)", "46"),
    ],
)
def test_what_is_wrong_is_told(line: str, word: str) -> None:
    with pytest.raises(TambourError, match=word):
        made(line)

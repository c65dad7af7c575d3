"""From a model to a pattern: rounds and their text, and how far two surfaces lie from each other."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tambour.core.check import Array
from tambour.crochet.graph.build import build
from tambour.crochet.language.parse import parse
from tambour.crochet.model.distance import Target, distance
from tambour.crochet.model.rounds import Round, Rounds, even, pattern, printed
from tambour.geometry.motion import turned


def globe(radius: float, rings: int = 24, tall: float = 1.0) -> tuple[Array, Array]:
    """A ball, ``tall`` times as high as it is wide."""
    around = 2 * rings
    lat, long = np.meshgrid(np.pi * np.arange(rings + 1) / rings, 2 * np.pi * np.arange(around) / around, indexing="ij")
    x = radius * np.stack([np.sin(lat) * np.cos(long), tall * np.cos(lat), np.sin(lat) * np.sin(long)], -1)
    k = np.arange(around)
    faces = []
    for r in range(rings):
        a, b = r * around + k, r * around + (k + 1) % around
        faces += [np.column_stack([a, b, b + around])] if r else []
        faces += [np.column_stack([a, b + around, a + around])] if r < rings - 1 else []
    return x.reshape(-1, 3), np.concatenate(faces)


@given(st.integers(4, 60), st.integers(2, 120), st.floats(0, 1))
def test_even_rounds_take_up_the_round_below_and_have_what_was_wanted(below: int, wanted: int, turn: float) -> None:
    made = even(below, wanted, turn)
    assert made.takes == below
    assert made.makes == min(max(wanted, math.ceil(below / 3)), 3 * below)


@settings(max_examples=12)
@given(st.lists(st.integers(4, 30), min_size=1, max_size=8), st.sampled_from(["", "BLO", "FLO"]))
def test_rounds_printed_and_read_again_are_the_same_graph(counts: list[int], loop: str) -> None:
    rounds, below = [], 6
    for wanted in counts:
        one = even(below, wanted)
        rounds.append(Round(one.words, loop))
        below = one.makes
    part = Rounds("Head", 6, tuple(rounds), closed=below <= 12, color=(180, 20, 30))
    plain, shown = build(pattern([part])), build(parse(printed([part])))
    assert part.counts() == [r.count for r in plain.rounds]
    assert not plain.warnings and not shown.warnings
    for name in ("kind", "parent", "loop", "color", "edges", "faces", "round"):
        assert (getattr(plain.graph, name) == getattr(shown.graph, name)).all(), name


def test_a_surface_lies_on_itself_however_it_was_moved() -> None:
    x, faces = globe(10.0, tall=1.5)
    a, b = 0.2, 0.1
    turn = np.array([[math.cos(a), -math.sin(a), 0], [math.sin(a), math.cos(a), 0], [0, 0, 1]])
    turn = turn @ np.array([[1, 0, 0], [0, math.cos(b), -math.sin(b)], [0, math.sin(b), math.cos(b)]])
    found = distance(Target.of(x, faces), turned(x, turn) + np.array([3.0, -1.0, 2.0]), faces)
    assert found.mean < 0.02 and found.largest < 0.1


@pytest.mark.parametrize("wider", [0.9, 1.1])
def test_distance_is_not_made_smaller_by_scaling(wider: float) -> None:
    x, faces = globe(10.0)
    found = distance(Target.of(x, faces), wider * x, faces)
    assert found.mean == pytest.approx(10.0 * abs(wider - 1.0), rel=0.02)
    assert found.plain(2.0)["mean"] == pytest.approx(found.mean / 2.0, abs=1e-4)


def test_a_limb_that_is_missing_is_seen_from_the_target() -> None:
    x, faces = globe(10.0)
    limb, own = globe(2.0)
    both = np.concatenate([x, limb + np.array([14.0, 0, 0])]), np.concatenate([faces, own + len(x)])
    found = distance(Target.of(*both), x, faces)
    assert found.largest == pytest.approx(6.0, abs=0.3)
    assert found.mean < 0.3

"""What is set down lies on a facet of its hull, its middle above it."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.spatial import ConvexHull

from tambour.geometry.stance import beside, righted, set_down


def turned(x: np.ndarray, degrees: float) -> np.ndarray:
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return x @ np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]]).T


BOX = np.array([(x, y, z) for x in (-1.0, 1.0) for y in (-2.0, 2.0) for z in (-1.5, 1.5)])


@pytest.mark.parametrize("tilt", [-11.0, -3.0, 0.0, 4.0, 11.5])
def test_a_tilted_box_stands_again(tilt: float) -> None:
    x = turned(BOX, tilt)
    assert x @ set_down(x, 12.0).T == pytest.approx(BOX, abs=1e-9)


def test_what_would_turn_further_or_is_flat_stays() -> None:
    assert (set_down(turned(BOX, 14.0), 12.0) == np.eye(3)).all()
    assert (set_down(BOX * [1.0, 0.0, 1.0], 12.0) == np.eye(3)).all()
    assert (set_down(np.empty((0, 3)), 12.0) == np.eye(3)).all()


def test_it_lies_on_a_facet_that_bears_its_middle() -> None:
    chance, stood = np.random.default_rng(5), 0
    for _ in range(60):
        x = chance.normal(size=(int(chance.integers(8, 300)), 3)) * chance.uniform(0.3, 2.0, 3)
        turn = set_down(x, 25.0)
        assert turn @ turn.T == pytest.approx(np.eye(3), abs=1e-12)
        assert turn[1, 1] >= math.cos(math.radians(25.0)) - 1e-12
        if (turn == np.eye(3)).all():
            continue
        stood += 1
        y = x @ turn.T
        low = y[y[:, 1] < y[:, 1].min() + 1e-6]
        assert len(low) >= 3
        borne = ConvexHull(np.vstack([low[:, [0, 2]], y.mean(0)[[0, 2]]]))
        assert len(low) not in borne.vertices  # the middle is within the corners it stands on
    assert stood > 20


def beast(lean: float) -> np.ndarray:
    """A trunk on four legs, leaning ahead by so many degrees."""
    legs = [(x, y, z) for x in (-1.0, 1.0) for y in np.linspace(0.0, 4.0, 9) for z in (-2.0, 2.0)]
    trunk = [(x, y, z) for x in (-1.0, 1.0) for y in (4.0, 5.0, 6.0) for z in np.linspace(-3.0, 3.0, 13)]
    c, s = math.cos(math.radians(lean)), math.sin(math.radians(lean))
    return np.array([*legs, *trunk]) @ np.array([[1.0, 0.0, 0.0], [0.0, c, -s], [0.0, s, c]]).T


@pytest.mark.parametrize("lean", [-55.0, -45.0, 45.0, 55.0])
def test_a_toy_that_would_fall_on_its_back_or_its_nose_is_righted(lean: float) -> None:
    x = beast(lean)
    looks = np.array([[0.0, -math.sin(math.radians(lean)), math.cos(math.radians(lean))]])
    assert beside(x, 0.0) > 0.12
    turn = righted(x, looks)
    assert beside(x, turn) < 0.06 and math.degrees(turn) == pytest.approx(-lean, abs=25.0)


def test_what_stands_stays_and_no_face_is_turned_to_the_sky() -> None:
    ahead = np.array([[0.0, 0.0, 1.0]])
    assert righted(beast(0.0), ahead) == 0.0
    # On one leg behind its middle it would rest on its back: its face would look up, so a hand holds it.
    leg = np.array([(0.0, h, -2.0) for h in np.linspace(0.0, 4.0, 12)])
    x = np.vstack(
        [
            leg,
            leg + np.array([0.0, 4.0, 0.0]),
            np.array([(s, 8.0, z) for s in (-1, 1) for z in np.linspace(-2.0, 4.0, 40)]),
        ]
    )
    turn = righted(x, ahead)
    assert math.cos(turn) > 0.5

"""Turns, main axes and least squares against LAPACK's, and what they promise where LAPACK's choice is arbitrary."""

from __future__ import annotations

import numpy as np
import pytest

from tambour import noise
from tambour.geometry import motion


def points(name: str, n: int) -> np.ndarray:
    return noise.stream("motion", name).normal(size=(n, 3))


def kabsch(moving: np.ndarray, fixed: np.ndarray, weight: np.ndarray) -> np.ndarray:
    w = weight / weight.sum()
    a, b = w @ moving, w @ fixed
    u, _, v = np.linalg.svd((w[:, None] * (moving - a)).T @ (fixed - b))
    return np.asarray(v.T @ np.diag([1.0, 1.0, np.linalg.det(v.T @ u.T)]) @ u.T)


@pytest.mark.parametrize("n", [3, 4, 20])
@pytest.mark.parametrize("flat", [False, True])
def test_fit_is_kabsch(n: int, flat: bool) -> None:
    moving, fixed = points("moving", n), points("fixed", n)
    moving[:, 1] *= not flat
    weight = np.linspace(0.5, 2.0, n)
    turn, shift = motion.fit(moving, fixed, weight)
    np.testing.assert_allclose(turn, kabsch(moving, fixed, weight), atol=1e-12)
    np.testing.assert_allclose(turn @ turn.T, np.eye(3), atol=1e-14)
    w = weight / weight.sum()
    np.testing.assert_allclose(turn @ (w @ moving) + shift, w @ fixed, atol=1e-14)


def test_fit_of_points_on_a_line_or_in_one_place_turns_no_more_than_it_must() -> None:
    turn, shift = motion.fit(np.zeros((2, 3)), np.ones((2, 3)), np.ones(2))
    np.testing.assert_allclose(turn, np.eye(3), atol=1e-15)
    np.testing.assert_allclose(shift, 1.0)
    line = np.outer(np.arange(5.0), [1.0, 0, 0])
    turn, _ = motion.fit(line, np.outer(np.arange(5.0), [0, 1.0, 0]), np.ones(5))
    np.testing.assert_allclose(turn, [[0, -1, 0], [1, 0, 0], [0, 0, 1]], atol=1e-12)


def test_axes_are_the_singular_vectors() -> None:
    x = points("axes", 40) * (1.0, 3.0, 0.5)
    spread, rows = motion.axes(x)
    _, size, v = np.linalg.svd(x - x.mean(0), full_matrices=False)
    np.testing.assert_allclose(spread, size, rtol=1e-12)
    np.testing.assert_allclose(abs((rows * v).sum(1)), 1.0, atol=1e-12)
    assert (rows[np.arange(3), abs(rows).argmax(1)] > 0).all()


def test_least_squares_is_lapacks_and_takes_twins_for_one() -> None:
    t = np.linspace(0, 6, 30)
    terms = np.column_stack([np.ones(30), np.cos(t), np.sin(t)])
    values = points("values", 10).ravel()
    wanted = terms @ np.linalg.lstsq(terms, values, rcond=None)[0]
    np.testing.assert_allclose(motion.least_squares(terms, values), wanted, atol=1e-12)
    np.testing.assert_allclose(motion.least_squares(terms[:, [0, 1, 2, 2]], values), wanted, atol=1e-12)


def test_turned_and_dot_are_the_products() -> None:
    x, turn = points("x", 7), points("turn", 3)
    np.testing.assert_allclose(motion.turned(x, turn), x @ turn.T, atol=1e-14)
    np.testing.assert_allclose(motion.turned(x[0], turn), turn @ x[0], atol=1e-14)
    np.testing.assert_allclose(motion.dot(x, x), (x * x).sum(1), atol=1e-14)

"""Near points and assignments, against SciPy's tree and its solver."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.optimize import linear_sum_assignment
from scipy.spatial import cKDTree

from tambour.geometry.closest import tree
from tambour.geometry.near import assigned, nearest


@pytest.mark.parametrize("axes", [2, 3])
@given(seed=st.integers(0, 2**32 - 1), n=st.integers(0, 20), m=st.integers(1, 60), k=st.integers(1, 8))
def test_the_nearest_are_those_of_a_tree(axes: int, seed: int, n: int, m: int, k: int) -> None:
    rng, k = np.random.default_rng(seed), min(k, m)
    points, there = rng.normal(size=(n, axes)), rng.normal(size=(m, axes)) * rng.choice([0.01, 1, 100], axes)
    far, index = nearest(points, there, k)
    want, _ = cKDTree(there).query(points, range(1, k + 1)) if n else (np.zeros((0, k)), None)
    assert np.allclose(far, want, rtol=1e-12, atol=0)
    assert np.allclose(np.linalg.norm(points[:, None] - there[index], axis=2), want, rtol=1e-9)
    assert all(len(set(row)) == k for row in index.tolist())


def test_of_equally_near_ones_the_first_come_first() -> None:
    square = np.array([[1.0, 1], [-1, 1], [-1, -1], [1, -1], [1, 1]])
    assert nearest(np.zeros((1, 2)), square, 5)[1].tolist() == [[0, 1, 2, 3, 4]]
    assert nearest(np.zeros((1, 2)), square, 2)[1].tolist() == [[0, 1]]


@given(seed=st.integers(0, 2**32 - 1), m=st.integers(0, 12), more=st.integers(0, 12), small=st.booleans())
def test_an_assignment_costs_no_more_than_the_least(seed: int, m: int, more: int, small: bool) -> None:
    rng = np.random.default_rng(seed)
    cost = rng.integers(0, 4, (m, m + more)).astype(float) if small else rng.normal(size=(m, m + more))
    mine = assigned(cost)
    assert len(set(mine.tolist())) == m
    rows, theirs = linear_sum_assignment(cost)
    assert cost[np.arange(m), mine].sum() == pytest.approx(cost[rows, theirs].sum(), abs=1e-9)


def test_a_mesh_without_faces_is_refused() -> None:
    with pytest.raises(ValueError, match="without faces"):
        tree(np.zeros((3, 3)), np.zeros((0, 3), np.int64))

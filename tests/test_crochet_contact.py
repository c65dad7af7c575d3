"""Contact: the pair list against brute force, the force against its plain twin."""

from __future__ import annotations

import numpy as np
import pytest

import crochet_plain as plain
import crochet_toys as toys
from tambour import noise
from tambour.crochet.settle import contact


@pytest.mark.parametrize("size", [0.6, 2.0, 40.0])
def test_every_pair_within_reach_is_listed_once(size: float) -> None:
    toy = toys.ball(3, 3)
    n = len(toy)
    x = noise.stream("contact", str(size)).normal(size=(n, 3)) * size
    x[0] = [1e7, 0.0, 0.0]  # far-flung nodes are no burden
    offsets, neighbours = contact.ragged(n, toy.edges, np.zeros(len(toy.edges), bool))
    out, reach = np.empty((n * n, 2), np.int32), np.empty(n * n)
    count = contact.pairs(x, offsets, neighbours, 1.0, 0.7, 0.5, out, reach)
    found = {(int(i), int(j)): h for (i, j), h in zip(out[:count], reach[:count])}
    assert len(found) == count
    beside = [set(neighbours[offsets[i] : offsets[i + 1]].tolist()) for i in range(n)]
    for i in range(n):
        for j in range(i):
            h = 0.7 if beside[i] & beside[j] or any(beside[k] & beside[j] for k in beside[i]) else 1.0
            listed = j not in beside[i] and np.linalg.norm(x[i] - x[j]) < h + 0.5
            assert found.get((i, j), 0.0) == (h if listed else 0.0)


def test_contact_is_the_formula() -> None:
    toy = toys.ball(3, 3)
    n = len(toy)
    x = noise.stream("contact", "force").normal(size=(n, 3))
    offsets, neighbours = contact.ragged(n, toy.edges, np.zeros(len(toy.edges), bool))
    out, reach = np.empty((n * n, 2), np.int32), np.empty(n * n)
    count = contact.pairs(x, offsets, neighbours, 1.0, 0.7, 0.5, out, reach)
    D = np.zeros_like(x)
    contact.contact(x, out[:count], reach[:count], 0.3, D)
    np.testing.assert_allclose(D, plain.contact(x, toy.edges, 1.0, 0.7, 0.3), rtol=1e-10, atol=1e-12)
    np.testing.assert_allclose(D.sum(0), 0.0, atol=1e-10)


def test_a_short_buffer_asks_for_more() -> None:
    x = noise.stream("contact", "short").normal(size=(40, 3)) * 0.3
    offsets, neighbours = contact.ragged(40, np.zeros((0, 2), np.int32), np.zeros(0, bool))
    few, room = np.empty((3, 2), np.int32), np.empty(3)
    assert contact.pairs(x, offsets, neighbours, 1.0, 0.7, 0.5, few, room) > 3


def test_across_a_seam_only_the_stitches_sewn_are_joined() -> None:
    edges, sewn = np.array([[1, 0], [2, 1], [3, 2], [4, 3]], np.int32), np.array([False, False, True, False])
    offsets, neighbours = contact.ragged(5, edges, sewn)
    x = np.zeros((5, 3))
    x[:, 0] = np.arange(5) * 0.1
    out, reach = np.empty((20, 2), np.int32), np.empty(20)
    count = contact.pairs(x, offsets, neighbours, 1.2, 1.0, 0.5, out, reach)
    found = {tuple(p): h for p, h in zip(out[:count].tolist(), reach[:count])}
    assert found == {(2, 0): 1.0, (3, 0): 1.2, (3, 1): 1.2, (4, 0): 1.2, (4, 1): 1.2, (4, 2): 1.2}

"""Contact: the pair list against brute force, the force against its plain twin."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

import crochet_plain as plain
import crochet_toys as toys
from tambour import noise
from tambour.crochet.settle import contact


@pytest.mark.parametrize(("size", "block"), [(0.6, 2048), (2.0, 2048), (2.0, 7), (40.0, 2048)])
def test_every_pair_within_reach_is_listed_once(size: float, block: int, monkeypatch: pytest.MonkeyPatch) -> None:
    toy = toys.ball(3, 3)
    n = len(toy)
    x = noise.stream("contact", str(size)).normal(size=(n, 3)) * size
    x[0] = [1e7, 0.0, 0.0]  # far-flung nodes are no burden
    offsets, neighbours = contact.ragged(n, toy.edges, np.zeros(len(toy.edges), bool))
    monkeypatch.setattr(contact, "BLOCK", block)
    pairs, reach = contact.pairs(x, offsets, neighbours, 1.0, 0.7, 0.5)
    found = {(int(i), int(j)): h for (i, j), h in zip(pairs, reach)}
    assert len(found) == len(pairs)
    assert (np.diff(pairs[:, 0]) >= 0).all()
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
    D = np.zeros_like(x)
    contact.contact(x, *contact.pairs(x, offsets, neighbours, 1.0, 0.7, 0.5), 0.3, D)
    np.testing.assert_allclose(D, plain.contact(x, toy.edges, 1.0, 0.7, 0.3), rtol=1e-10, atol=1e-12)
    np.testing.assert_allclose(D.sum(0), 0.0, atol=1e-10)


def test_a_heap_of_stitches_finds_room_for_all_its_pairs() -> None:
    x = noise.stream("contact", "short").normal(size=(40, 3)) * 0.1
    offsets, neighbours = contact.ragged(40, np.zeros((0, 2), np.int32), np.zeros(0, bool))
    assert len(contact.pairs(x, offsets, neighbours, 1.0, 0.7, 0.5)[0]) == 40 * 39 // 2


def test_across_a_seam_only_the_stitches_sewn_are_joined() -> None:
    edges, sewn = np.array([[1, 0], [2, 1], [3, 2], [4, 3]], np.int32), np.array([False, False, True, False])
    offsets, neighbours = contact.ragged(5, edges, sewn)
    x = np.zeros((5, 3))
    x[:, 0] = np.arange(5) * 0.1
    pairs, reach = contact.pairs(x, offsets, neighbours, 1.2, 1.0, 0.5)
    found = {tuple(p): h for p, h in zip(pairs.tolist(), reach)}
    assert found == {(2, 0): 1.0, (3, 0): 1.2, (3, 1): 1.2, (4, 0): 1.2, (4, 1): 1.2, (4, 2): 1.2}


def test_a_stitch_that_is_sewn_to_one_two_edges_away_still_leads_on_from_there() -> None:
    edges, sewn = np.array([[1, 0], [2, 1], [3, 2], [2, 0]], np.int32), np.array([False, False, False, True])
    offsets, neighbours = contact.ragged(4, edges, sewn)
    starts, nodes = contact.about(offsets, neighbours)
    told = [set(nodes[a:b].tolist()) for a, b in pairwise(starts.tolist())]
    assert told == [set(), {~0}, {~1, 0, ~0}, {~2, 1, 0}]
    pairs, reach = contact.pairs(np.zeros((4, 3)), offsets, neighbours, 1.2, 1.0, 0.5)
    assert {tuple(p): h for p, h in zip(pairs.tolist(), reach)} == {(3, 1): 1.0, (3, 0): 1.0}


def test_what_is_about_each_stitch_finds_room_however_much_hangs_together() -> None:
    n = 60  # each with each
    edges = np.array([(i, j) for i in range(n) for j in range(i)], np.int32)
    for sewn in (False, True):
        starts, nodes = contact.about(*contact.ragged(n, edges, np.full(len(edges), sewn)))
        assert all(set(nodes[starts[i] : starts[i + 1]].tolist()) == {~j for j in range(i)} for i in range(n))

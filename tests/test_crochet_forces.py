"""Kernels of the fabric's forces against their plain twins; the laws that they keep."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import crochet_plain as plain
import crochet_toys as toys
from tambour import noise
from tambour.core import graph as g
from tambour.crochet.settle import forces


def shaken(n: int, name: str, size: float = 1.0) -> np.ndarray:
    return noise.stream("crochet", name).normal(size=(n, 3)) * size


@pytest.mark.parametrize("cubic", [True, False])
def test_link_is_the_formula(cubic: bool) -> None:
    toy = toys.ball(2, 2)
    x = shaken(len(toy), "link", 2.0)
    x[5] = x[4]  # two nodes in one place leave each other alone
    rest = np.linspace(0.5, 2.0, len(toy.edges))
    D = np.zeros_like(x)
    forces.link(x, toy.edges, rest, cubic, D)
    np.testing.assert_allclose(D, plain.link(x, toy.edges, rest, cubic), rtol=1e-12, atol=1e-13)
    np.testing.assert_allclose(D.sum(0), 0.0, atol=1e-11)


def test_link_of_the_seed_at_some_distances() -> None:
    edges, rest = np.array([[1, 0]], np.int32), np.ones(1)
    for r, pull in [(1.0, 0.0), (0.5, (-0.5 / 1.25) ** 3), (3.0, (2.0 / 2.5) ** 3)]:
        D = np.zeros((2, 3))
        forces.link(np.array([[0.0, 0, 0], [r, 0, 0]]), edges, rest, True, D)
        np.testing.assert_allclose(D[:, 0], [pull, -pull], rtol=1e-12)


def test_single_loop_is_the_formula() -> None:
    toy = toys.ball(2, 2)
    nodes = np.array([20, 21, 22], np.int32)
    plane = toy.plane.copy()
    plane[nodes] = [[9, 8, 2], [10, 9, 3], [8, 8, 2]]
    kind = toy.peculiarity.copy()
    kind[nodes] = [g.BLO, g.FLO, g.BLO]
    toy = replace(toy, plane=plane, peculiarity=kind)
    x = shaken(len(toy), "loops")
    D = np.zeros_like(x)
    forces.single_loop(x, nodes, toy.plane[nodes], np.array([0.05, -0.05, 0.05]), D)
    np.testing.assert_allclose(D, plain.single_loop(x, toy, 0.05), rtol=1e-12, atol=1e-15)
    assert not D[22].any(), "three points on a line push nothing"


def test_fold_is_the_single_loop_with_the_answer_of_the_fabric_and_has_an_energy() -> None:
    nodes, planes, strength = np.array([3], np.int32), np.array([[0, 1, 2]], np.int32), np.array([0.05])
    flat = np.array([[0.0, 0, 0], [1, 0, 0], [0, -1, 0], [0, 1, 0]])

    def fold(x: np.ndarray, strength: np.ndarray = strength) -> np.ndarray:
        D = np.zeros_like(x)
        forces.fold(x, nodes, planes, strength, D)
        return D

    for height in (-0.4, -0.2, 0.0, 0.1, 0.29, 0.31, 0.9):
        x = flat.copy()
        x[3, 2] = -height  # the back loop's side is -z here
        D = fold(x)
        one_sided = np.zeros_like(x)
        forces.single_loop(x, nodes, planes, strength, one_sided)
        np.testing.assert_allclose(D[3], one_sided[3] * max(1 - abs(height) / forces.LEAN, 0.0), atol=1e-15)
        np.testing.assert_allclose(D.sum(0), 0.0, atol=1e-15)
        np.testing.assert_allclose(np.cross(x, D).sum(0), 0.0, atol=1e-15)
        np.testing.assert_allclose(fold(x, -strength), -D, atol=1e-15)
    assert fold(flat).any()

    # A force with an energy has a symmetric derivative.
    x = flat + 0.1 * shaken(4, "fold")
    assert fold(x).any()
    H, h = np.zeros((12, 12)), 1e-6
    for k in range(12):
        step = np.zeros(12)
        step[k] = h
        H[k] = (fold(x + step.reshape(4, 3)) - fold(x - step.reshape(4, 3))).ravel() / (2 * h)
    np.testing.assert_allclose(H, H.T, atol=1e-9)
    flat[1] = [0, 1, 0]
    assert not fold(flat).any(), "three points on a line have no side"


def test_bend_is_the_formula_and_leaves_straight_lines_alone() -> None:
    triples = np.array([[0, 1, 2], [1, 2, 3]], np.int32)
    x = shaken(4, "bend")
    D = np.zeros_like(x)
    forces.bend(x, triples, np.array([0.5, 0.25]), D)
    np.testing.assert_allclose(D, plain.bend(x, triples[:1], 0.5) + plain.bend(x, triples[1:], 0.25), rtol=1e-12)
    D = np.zeros_like(x)
    forces.bend(np.arange(12.0).reshape(4, 3), triples, np.ones(2), D)
    np.testing.assert_allclose(D, 0.0, atol=1e-14)


@pytest.mark.parametrize(
    "text",
    [
        ": MR(6), join\n: ch, 6 inc, join\n: ch, [sc, inc] x 6, join\n",
        ": ch 8, turn\n: 7 sc\n3: turn, ch, 7 sc\n: turn, 3 sc, ch 2, sk, 3 sc\n",
    ],
)
def test_what_is_kept_straight(text: str) -> None:
    """Against the plain rule, where yarn turns corners and rounds are joined."""
    from tambour.core.errors import Text
    from tambour.crochet.graph.build import build
    from tambour.crochet.language.parse import parse
    from tambour.crochet.settle.straight import straight

    graph = build(parse(Text("@stuffing = none\n" + text))).graph
    triples, stiffness = straight(graph, np.zeros(1), 0.05)
    wanted, shares = plain.straight(graph, len(graph))
    assert sorted((*t, round(s, 9)) for t, s in zip(triples.tolist(), stiffness.tolist())) == sorted(
        (*map(int, t), round(0.05 * s, 9)) for t, s in zip(wanted, shares)
    )

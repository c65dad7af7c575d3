"""First positions: rings, turned the right way round, and parts where they belong."""

from __future__ import annotations

import numpy as np
import pytest

import crochet_plain as plain
import crochet_toys as toys
from tambour import noise
from tambour.crochet.graph import layout
from tambour.crochet.settle import arrange


def test_a_round_is_a_ring_above_the_one_before() -> None:
    toy = toys.tube(24, 10)
    x = layout.rounds(toy, toy.rest / 5.0)
    section = layout.sections(toy)
    assert section[0] == 0 and section[-1] == section[-2] + 1, "root and tip stand alone"
    assert not x[0].any()
    heights = []
    for s in range(1, section[-1]):
        ring = x[section == s]
        radius = np.hypot(ring[:, 0], ring[:, 2])
        np.testing.assert_allclose(radius, len(ring) / (2 * np.pi), rtol=1e-9)
        heights.append(ring[:, 1].mean())
        assert np.ptp(ring[:, 1]) < 1e-12
    rise = np.diff(heights)
    assert (rise > 0.29).all() and (abs(rise[4:12] - 1.0) < 1e-9).all()


@pytest.mark.parametrize("toy", [toys.ball(3, 3), toys.ball(9, 9), toys.tube(12, 8)])
def test_the_outside_is_outside(toy) -> None:
    assert plain.volume_of(layout.rounds(toy, toy.rest / 5.0), toy.faces) > 0


def test_stitches_stand_over_theirs() -> None:
    toy = toys.tube(12, 6)
    x = layout.rounds(toy, toy.rest / 5.0)
    for i in range(60, 90):
        assert np.linalg.norm(x[i] - x[toy.parent[i]]) < 1.05


def test_centroids_divide_the_axis() -> None:
    toy = toys.tube(24, 20)
    x = layout.rounds(toy, toy.rest / 5.0)
    c = layout.on_axis(x, 0, len(toy), 4)
    assert np.ptp(np.diff(c[:, 1])) < 1e-9 and abs(c[:, [0, 2]]).max() < 0.5


def test_fit_finds_the_motion() -> None:
    draw = noise.stream("fit")
    a = draw.normal(size=(9, 3))
    turn, _ = np.linalg.qr(draw.normal(size=(3, 3)))
    turn *= np.sign(np.linalg.det(turn))
    found, shift = arrange.fit(a, a @ turn.T + 4.0, np.ones(9))
    np.testing.assert_allclose(found, turn, atol=1e-12)
    np.testing.assert_allclose(shift, 4.0, atol=1e-12)
    mirrored, _ = arrange.fit(a, -a, np.ones(9))
    assert np.linalg.det(mirrored) > 0.99, "never a reflection"

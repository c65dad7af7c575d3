"""Round ends: the geometry that the seed article's figure 3 implies, and both readings of it."""

from __future__ import annotations

import numpy as np
import pytest

from tambour.embroidery.cloth.thread import curves

R = 0.2


def one(length: float = 3.0, theta: float = np.pi / 3, **more):
    made = curves(np.zeros((1, 2)), np.array([[length, 0.0]]), radius=R, theta=theta, **more)
    return made.plan[:, 0], made.height


@pytest.mark.parametrize("theta", np.radians([20.0, 45.0, 60.0, 89.0]))
@pytest.mark.parametrize("ends", ["exact", "bleed"])
def test_the_seed_points(theta, ends):
    x, y = one(4.0, theta, ends=ends, arc=0)
    inset = R / np.sin(theta) if ends == "exact" else 0.0
    s, e = inset, 4.0 - inset
    foot = 2 * R / np.sin(theta) - R * np.sin(theta)
    wanted = [
        (s - foot, -R * np.cos(theta)),
        (s - R * np.sin(theta), R * np.cos(theta)),
        (s, R),
        (e, R),
        (e + R * np.sin(theta), R * np.cos(theta)),
        (e + foot, -R * np.cos(theta)),
    ]
    assert np.allclose(np.c_[x, y], wanted, atol=1e-12)
    # The tangent: slope θ, length 2r·cotθ, half of it below the cloth, square to the radius.
    p0, p1 = np.array(wanted[0]), np.array(wanted[1])
    assert np.isclose(np.arctan2(*(p1 - p0)[::-1]), theta)
    assert np.isclose(np.hypot(*(p1 - p0)), 2 * R / np.tan(theta))
    assert np.isclose((p1 - p0) @ (p1 - [s, 0]), 0, atol=1e-12)
    hole = (p0 + p1) / 2
    assert np.allclose(hole, [0.0 if ends == "exact" else -R / np.sin(theta), 0.0], atol=1e-12)


def test_the_arc_lies_on_the_circle():
    x, y = one(arc=5)
    near = x < 1.0
    on = np.hypot(x[near][1:] - R / np.sin(np.pi / 3), y[near][1:])
    assert np.allclose(on, R)


def test_short_stitches_are_removed():
    least = 2 * R / np.sin(np.pi / 3)
    end = np.array([[least - 1e-6, 0], [least + 1e-6, 0], [2.0, 0], [0, 0]])
    made = curves(np.zeros((4, 2)), end, radius=R)
    assert made.stitch.tolist() == [1, 2]
    assert curves(np.zeros((0, 2)), np.zeros((0, 2)), radius=R).stitch.size == 0


def test_what_lies_below_lifts_the_flat_and_keeps_the_holes():
    base = np.array([0.5])
    made = curves(np.zeros((1, 2)), np.array([[3.0, 0.0]]), radius=R, base=base, arc=0)
    x, y = made.plan[:, 0], made.height
    assert y.max() == pytest.approx(0.7)
    hole = x[0] + (x[1] - x[0]) * (0 - y[0]) / (y[1] - y[0])
    assert hole == pytest.approx(0.0, abs=1e-9)
    short = curves(np.zeros((1, 2)), np.array([[0.6, 0.0]]), radius=R, base=np.array([5.0]), arc=0)
    assert short.height.max() == pytest.approx(5.2)
    assert (np.diff(short.plan[:, 0]) >= -1e-9).all()


def test_curves_follow_their_direction_and_u_rises():
    rng = np.random.default_rng(1)
    start = rng.uniform(-9, 9, (200, 2))
    end = start + rng.uniform(-4, 4, (200, 2))
    cuts = (np.arange(201, dtype=np.int64) * 2, np.sort(rng.uniform(0, 1, (200, 2)), axis=1).ravel())
    made = curves(start, end, radius=R, cuts=cuts)
    for k, s in enumerate(made.stitch):
        part = slice(made.offsets[k], made.offsets[k + 1])
        way = (end[s] - start[s]) / np.linalg.norm(end[s] - start[s])
        off = made.plan[part] - start[s]
        assert np.abs(off[:, 0] * way[1] - off[:, 1] * way[0]).max() < 1e-9
        assert (np.diff(off @ way) > -1e-9).all()
        u = made.u[part]
        assert u[0] == 0
        assert u[-1] == pytest.approx(1)
        assert (np.diff(u) > 0).all()

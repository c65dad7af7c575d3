"""What lies flat in the hand: the middle of unstuffed rounds that grow as a circle does."""

from __future__ import annotations

import numpy as np
import pytest

from tambour.core.errors import Text
from tambour.core.progress import Progress
from tambour.crochet.params import CrochetParams
from tambour.crochet.piece import Plush
from tambour.crochet.plush import make
from tambour.crochet.settle import forces
from tambour.crochet.settle.laid import _hinges, _weights


def piece(grows: int, wall: str = "") -> Plush:
    rounds = [": MR(6)", ": 6 inc", *(f": [{n} sc, inc] x 6" for n in range(1, grows - 1))]
    rows = [f": {wall}{6 * grows} sc", *[f": {6 * grows} sc"] * 6] if wall else []
    return make(Text("\n".join(["@stuffing = none", *rounds, *rows])), CrochetParams(), Progress())


def heights(made: Plush, upto: int) -> np.ndarray:
    """How far stitches of the first rounds lie off their own plane, mm, from the lowest to the highest; and across it."""
    x = made.positions[made.built.graph.round <= upto]
    off = x - x.mean(0)
    _, _, axes = np.linalg.svd(off, full_matrices=False)
    return np.ptp(off @ axes.T, axis=0)


def test_what_keeps_a_plane_pulls_nothing_in_it_and_is_the_slope_of_its_energy() -> None:
    rng = np.random.default_rng(3)
    at = rng.uniform(-2.0, 2.0, (9, 2))
    faces = np.array([[0, 1, 2], [1, 3, 2], [2, 3, 4], [3, 5, 4], [4, 5, 6], [5, 7, 6], [6, 7, 8]])
    hinges = _hinges(faces)
    assert len(hinges) == 6 and {frozenset(h[:2].tolist()) for h in hinges} >= {frozenset((1, 2)), frozenset((6, 7))}
    weights = _weights(at[hinges])
    # Turned, drawn out and moved: a plane is a plane.
    sheet = at @ rng.uniform(-1.0, 1.0, (2, 3)) + [3.0, -1.0, 2.0]
    D = np.zeros((9, 3))
    forces.flat(sheet, hinges.astype(np.int32), weights, 2.0, D)
    np.testing.assert_allclose(D, 0.0, atol=1e-12)
    x, step = rng.normal(size=(9, 3)), 1e-6 * rng.normal(size=(9, 3))

    def energy(p: np.ndarray) -> float:
        return float(((weights[:, :, None] * p[hinges]).sum(1) ** 2).sum())

    D[:] = 0.0
    forces.flat(x, hinges.astype(np.int32), weights, 2.0, D)
    assert -(D * step).sum() == pytest.approx((energy(x + step) - energy(x - step)) / 2.0, rel=1e-6)


def test_a_disc_lies_flat() -> None:
    assert heights(piece(6), 5)[2] < 0.1


@pytest.mark.slow
def test_a_basket_keeps_a_flat_base_and_a_straight_wall() -> None:
    made = piece(6, "BLO, ")
    side, _, deep = heights(made, 5)
    assert side > 50.0 and deep < 2.5, "a cone of 10 mm before"
    graph, x = made.built.graph, made.positions
    rounds = [x[graph.round == k] for k in range(7, 12)]
    middles = np.array([r.mean(0) for r in rounds])
    axis = (middles[-1] - middles[0]) / np.linalg.norm(middles[-1] - middles[0])
    wide = [float(np.linalg.norm(np.cross(r - r.mean(0), axis), axis=1).mean()) for r in rounds]
    assert max(wide) < 1.02 * min(wide)
    base = x[graph.round <= 5] - x[graph.round <= 5].mean(0)
    _, _, axes = np.linalg.svd(base, full_matrices=False)
    assert abs(axes[2] @ axis) > 0.995, "it stands upright"


@pytest.mark.parametrize("grows", [3, 5, 6])
@pytest.mark.parametrize("loop", ["BLO", "FLO"])
@pytest.mark.parametrize("every", [False, True])
@pytest.mark.parametrize("ends", ["", ", join, ch"])
def test_a_basket_is_as_wide_above_as_below(grows: int, loop: str, every: bool, ends: str) -> None:
    """However many of its wall's rounds are in that loop: where all were, each leaned on the one below, and a wall of seven came in
    by a tenth; and however its rounds end: where they were joined, no base lay flat."""
    rounds = ["MR(6)", "6 inc", *(f"[{n} sc, inc] x 6" for n in range(1, grows - 1))]
    wall = [f"{loop}, {6 * grows} sc", *[f"{loop + ', ' if every else ''}{6 * grows} sc"] * 6]
    text = "\n".join(["@stuffing = none", *(f": {one}{ends}" for one in (*rounds, *wall))])
    made = make(Text(text), CrochetParams(), Progress())
    assert made.shape.settled
    x = made.positions / made.stitch[0]
    rings = [x[r.first : r.last + 1] for r in made.built.rounds if r.last > r.first]
    base, walls = x[: made.built.rounds[grows - 1].last + 1], rings[grows:]
    off = base - base.mean(0)
    _, _, axes = np.linalg.svd(off, full_matrices=False)
    assert np.ptp(off @ axes[2]) < 1 / 3
    axis = walls[-1].mean(0) - walls[0].mean(0)
    axis /= np.linalg.norm(axis)
    wide = [float(np.linalg.norm(np.cross(r - r.mean(0), axis), axis=1).mean()) for r in walls]
    assert max(wide) < 1.03 * min(wide)


@pytest.mark.parametrize("ends", [", join, ch", ", join"])
def test_a_disc_of_joined_rounds_lies_flat(ends: str) -> None:
    rounds = ["MR(6)", "6 inc", *(f"[{n} sc, inc] x 6" for n in range(1, 5))]
    text = "@stuffing = none\n" + ", join, ch\n".join(f": {one}" for one in rounds) + ends
    made = make(Text(text), CrochetParams(), Progress())
    assert made.shape.settled
    assert heights(made, 5)[2] < 0.1


def test_a_bowl_stays_a_bowl() -> None:
    """Where the wall is worked in both loops nothing says that its maker wanted an edge."""
    assert heights(piece(5, " "), 4)[2] > 5.0


def test_an_open_tube_stands_upright() -> None:
    """Along the work and across it alone its stitches shear: it leaned by ten degrees."""
    rows = "\n".join(["@stuffing = none", ": 24 ch, join, ch", *[": 24 sc, join, ch"] * 6, ": 24 sc, join"])
    made = make(Text(rows), CrochetParams(), Progress())
    graph, x = made.built.graph, made.positions
    rounds = [x[graph.round == k] for k in range(1, 8)]
    axis = rounds[-1].mean(0) - rounds[0].mean(0)
    _, _, axes = np.linalg.svd(rounds[3] - rounds[3].mean(0), full_matrices=False)
    assert abs(axes[2] @ axis) > 0.998 * np.linalg.norm(axis)

"""Pressed: yarn gives way to yarn: nothing goes through anything, and nothing is lost."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from tambour.core import threads
from tambour.core.errors import Text
from tambour.core.paths import Paths
from tambour.core.progress import Progress
from tambour.core.strands import Strands
from tambour.crochet.params import CrochetParams
from tambour.crochet.plush import make
from tambour.crochet.yarn.fabric import GROOVE, LAY
from tambour.crochet.yarn.pressed import FULLER, LEAST, pressed
from tambour.geometry.tube import MEAN, sweep

SIDES = 24


def strands(*lines: np.ndarray, radius: float = 1.0) -> Strands:
    paths = Paths.of(lines, 3)
    return Strands(paths, np.full(len(paths.coords), radius), np.zeros((len(lines), 3), np.uint8))


def line(y: float, *, across: bool = False) -> np.ndarray:
    x = np.linspace(-6.0, 6.0, 49)
    still = np.zeros_like(x)
    return np.stack([still, still + y, x] if across else [x, still + y, still], axis=1)


def tubes(made: Strands) -> tuple[np.ndarray, np.ndarray]:
    """The vertices as swept and as pressed."""
    swept = sweep(made, sides=SIDES).vertices
    return swept, pressed(made, swept, SIDES, 1.0)


def section(vertices: np.ndarray, number: int) -> np.ndarray:
    """The ring (SIDES, 2) in the middle of a strand along x, about its own line."""
    ring = 1 + SIDES * 25 + number * (SIDES * 51 + 2)
    return vertices[ring : ring + SIDES, 1:]


def area(ring: np.ndarray) -> float:
    y, z = ring.T
    return 0.5 * abs(float((y * np.roll(z, -1) - z * np.roll(y, -1)).sum()))


def test_two_that_lie_side_by_side_are_flat_between_them_and_keep_their_yarn() -> None:
    before, after = tubes(strands(line(0.0), line(1.2)))
    low, high = section(after, 0), section(after, 1)
    assert section(before, 0)[:, 0].max() == pytest.approx(1.0)
    assert low[:, 0].max() < 0.6 < high[:, 0].min()
    # Round at its shoulders, fuller where it is free, but not by more than it may be.
    assert 1.02 < -low[:, 0].min() <= FULLER + 1e-9
    assert 0.88 * area(section(before, 0)) < area(low) < area(section(before, 0))
    np.testing.assert_allclose(low[:, 0], 1.2 - np.sort(high[:, 0])[np.argsort(np.argsort(-low[:, 0]))], atol=1e-9)


def test_one_that_crosses_another_leaves_it_room() -> None:
    _, after = tubes(strands(line(0.0), line(0.9, across=True)))
    assert section(after, 0)[:, 0].max() < 0.45
    # Away from there it is as it was.
    end = after[1 + SIDES * 3 : 1 + SIDES * 4]
    assert np.hypot(end[:, 1], end[:, 2]) == pytest.approx(1.0)


@pytest.mark.parametrize(("far", "most"), [(0.9, 0.03), (1.1, 0.03), (1.3, 0.03), (1.6, 0.05)])
def test_a_dent_has_no_edge(far: float, most: float) -> None:
    """Every ring was pressed for itself: where a strand came under another its outline broke off at the rim of the dent, as if cut.

    And nothing comes out of a dent for that: no ring stands further out than half way to the other strand.
    """
    _, after = tubes(strands(line(0.0), line(far, across=True)))
    rings = after[1 + SIDES : 1 + SIDES * 50].reshape(49, SIDES, 3)
    out = np.hypot(rings[..., 1], rings[..., 2])
    rim = -np.diff(out, 2, axis=0)  # how sharply each corner's line turns in, from ring to ring
    assert rim.max() < most
    assert out[24].min() < 0.1 + far / 2  # it is a dent still
    assert section(after, 0)[:, 0].max() <= far / 2 + 1e-9


def test_what_has_its_room_stays_as_it_was_and_something_is_left_of_all() -> None:
    before, after = tubes(strands(line(0.0), line(2.01)))
    np.testing.assert_array_equal(before, after)
    _, after = tubes(strands(line(0.0), line(0.1)))
    assert np.hypot(*section(after, 0).T).min() >= LEAST - 1e-9
    nothing = strands(np.zeros((1, 3)))
    assert tubes(nothing)[1].shape == (0, 3)


BALL = ": MR(6)\n: 6 inc\n: [sc, inc] x 6 (18)\n: 18 sc\n: 18 sc\n: [sc, dec] x 6 (12)\n: 6 dec (6)\nFO\n"


def sunk(made: Strands, vertices: np.ndarray, sides: int) -> np.ndarray:
    """How much nearer, plainly, in radii of each, every corner of some rings lies to another stretch of the yarn than to its own."""
    coords, out = made.paths.coords, []
    for i in range(40, len(coords) - 40, 23):
        ring = vertices[1 + sides * (i + 1) : 1 + sides * (i + 2)]
        other = np.abs(np.arange(len(coords)) - i) > 12
        own = np.linalg.norm(ring - coords[i], axis=1) / made.radius[i]
        out.append(own - (np.linalg.norm(ring[:, None] - coords[other], axis=2) / made.radius[other]).min(1))
    return np.array(out)


def test_in_a_toy_no_yarn_goes_through_yarn(monkeypatch: pytest.MonkeyPatch) -> None:
    made = make(Text(BALL), CrochetParams(), Progress()).yarn
    assert len(made.color) == 1
    swept = sweep(made, sides=10).vertices
    many = pressed(made, swept, 10, 1.6)
    before, after = sunk(made, swept, 10), sunk(made, many, 10)
    assert (before > 0.3).mean() > 0.15  # drawn as round tubes they go deep into each other
    assert (after > 0.1).mean() < 0.01
    monkeypatch.setattr(threads, "WORKERS", 1)
    np.testing.assert_array_equal(many, pressed(made, swept, 10, 1.6))


def test_plies_are_seen_where_yarn_is_pressed() -> None:
    """Each corner was pressed for itself: where strands lie against each other the grooves between plies were pressed away, and legs were smooth."""
    made = strands(line(0.0), line(1.2))
    swept = sweep(made, sides=48, plies=4, groove=GROOVE, lay=LAY).vertices
    ridge = 1.0 + GROOVE * (1.0 - MEAN)
    after = pressed(made, swept, 48, 1.0, ridge)
    free = pressed(
        strands(line(0.0)),
        sweep(strands(line(0.0)), sides=48, plies=4, groove=GROOVE, lay=LAY).vertices,
        48,
        1.0,
        ridge,
    )
    rings = [v[1 + 48 * 5 : 1 + 48 * 45].reshape(40, 48, 3)[..., 1:] for v in (after, free)]
    size = [np.hypot(ring[..., 0], ring[..., 1]) for ring in rings]
    towards = rings[0][..., 0] > 0.9 * size[0]
    depth = [float(np.ptp(each[towards]) / each[towards].max()) for each in size]
    assert size[0][towards].max() < 0.65 < size[1][towards].max()
    assert depth[0] > 0.9 * depth[1] > 0.1


@pytest.mark.parametrize("name", ["rows", "posts"])
def test_what_a_photo_of_few_stitches_shows_has_its_room_hairpins_too(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Asked of the strands that are swept: long segments hide how near a hairpin comes to itself."""
    from tambour.crochet.yarn import fabric
    from tambour.crochet.yarn.clearance import distances
    from tambour.crochet.yarn.loops import RATIO

    piece = make(None, CrochetParams(specimen=name), Progress())
    swept: list[Strands] = []
    tubes = fabric.sweep

    def seen(made: Strands, **asked: Any) -> Any:
        swept.append(made)
        return tubes(made, **asked)

    monkeypatch.setattr(fabric, "sweep", seen)
    fabric.mesh(piece.built.graph, piece.positions, detail="photo", made=piece.yarn)
    thick = piece.built.graph.stitch_width * RATIO
    paths = swept[0].paths
    near, _ = distances(paths.coords, np.asarray(paths.offsets), thick, 0.9 * thick)
    assert len(near) == 0

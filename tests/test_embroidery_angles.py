"""Areas' limbs at sharp corners: what goes through, what ends below it, and dots."""

import numpy as np
import pytest
import shapely

from tambour.embroidery.columns.medial import limbs

F = [(0, 0), (3, 0), (3, 12), (10, 12), (10, 14), (0, 14)]
"""A stem 3 mm wide and 14 high, and an arm of 2 mm at its top."""


def column_area(column):
    quads = np.stack([column.left[:-1], column.left[1:], column.right[1:], column.right[:-1]], axis=1)
    return shapely.union_all(shapely.make_valid(shapely.polygons(quads)))


@pytest.mark.parametrize("turn", [0, 33, 90])
@pytest.mark.parametrize("mirror", [1, -1])
def test_a_stem_goes_through_its_corner_and_the_arm_ends_below_it(turn, mirror):
    area = shapely.affinity.rotate(shapely.affinity.scale(shapely.Polygon(F), mirror, 1, origin=(0, 0)), turn)
    made, left = limbs(area, 14)
    assert len(made) == 2 and left.is_empty
    stem = max(made, key=lambda limb: np.median(np.hypot(*(limb.column.left - limb.column.right).T)))
    (arm,) = [limb for limb in made if limb is not stem]
    assert len(stem.through) == 1 and stem.through[0][0] in (arm.start, arm.end)
    # No fan: the stem's stitches lie one way all along it, the corner's too.
    across = stem.column.left - stem.column.right
    way = np.unwrap(2 * np.arctan2(across[:, 1], across[:, 0])) / 2
    assert np.ptp(way) < np.radians(12)
    bare = area.difference(shapely.union_all([column_area(limb.column) for limb in made]))
    assert bare.buffer(-0.2).is_empty


@pytest.mark.parametrize("radius", [4.0, 7.0])
def test_a_round_bend_stays_one_limb(radius):
    arch = shapely.LineString(
        [(0, 0), (0, 10)] + [(radius - radius * np.cos(t), 10 + radius * np.sin(t)) for t in np.linspace(0, np.pi, 40)]
    )
    made, _ = limbs(arch.buffer(1.5, cap_style="flat"), 14)
    assert len(made) == 1 and not made[0].through


@pytest.mark.parametrize("dot", [shapely.Point(3, 4).buffer(2.2), shapely.box(0, 0, 4, 4), shapely.box(0, 0, 4.4, 3.8)])
def test_a_dot_is_one_column_straight_across_it(dot):
    (limb,), left = limbs(dot, 14)
    assert left.is_empty
    across = limb.column.left - limb.column.right
    way = np.unwrap(2 * np.arctan2(across[:, 1], across[:, 0])) / 2
    assert np.ptp(way) < np.radians(8) and np.hypot(*across.T).min() > 0.4
    assert dot.difference(column_area(limb.column)).buffer(-0.15).is_empty


def test_a_disc_wider_than_satin_may_be_is_no_dot():
    made, left = limbs(shapely.Point(0, 0).buffer(30), 14)
    assert not made and left.area > 2800
    assert limbs(shapely.Point(0, 0).buffer(6.9), 14)[1].is_empty


@pytest.mark.parametrize(
    "radius, cut, bar",
    [(6, 0.5, (-30, -0.75, -9, 0.75)), (7, 0.4, (-5.25, -30, -3.75, -4.2)), (8, 0.4, (-6, -30, -4.5, -4.8))],
)
def test_a_bar_that_runs_into_a_bend_does_not_part_it(radius, cut, bar):
    # A round bow, and a thin bar that meets its outside: corners there are, but not those of the bend.
    t = np.linspace(cut * np.pi, (2 - cut) * np.pi, 60)
    bow = shapely.LineString(radius * np.c_[np.cos(t), np.sin(t)]).buffer(3.5, cap_style="flat")
    made, _ = limbs(bow.union(shapely.box(*bar)), 14)
    assert len(made) == 2  # the bow and the bar


@pytest.mark.parametrize("wide", [2.0, 4.0, 6.0])
def test_a_frame_open_below_is_three_bars(wide):
    area = shapely.box(0, 0, 40, 30) - shapely.box(wide, wide, 40 - wide, 40)
    made, left = limbs(area, 14)
    assert len(made) == 3 and left.is_empty and sum(len(limb.through) for limb in made) == 2


N = "525,320 705,320 705,390 780,335 880,310 960,330 1010,390 1030,480 1030,790 898,790 898,480 880,420 840,390 790,385 705,425"
"""The letter n of a face with serifs, a fortieth of a millimetre to the unit: its last places are ``STEM``."""
STEM = "705,790 570,790 570,362 525,355"


def test_a_stem_goes_through_between_its_serif_and_its_arch():
    area = shapely.Polygon([tuple(float(v) / 40 for v in p.split(",")) for p in f"{N} {STEM}".split()])
    made, _ = limbs(area, 14)
    tall = [limb for limb in made if np.ptp(limb.column.middle[:, 1]) > 6]
    stem = min(tall, key=lambda limb: limb.column.middle[:, 0].mean())
    across = stem.column.left - stem.column.right
    assert np.ptp(np.unwrap(2 * np.arctan2(across[:, 1], across[:, 0])) / 2) < np.radians(12)
    assert np.ptp(stem.column.middle[:, 1]) > 11.3  # all its 11.75 mm, to the very top


def test_a_tulip_is_not_parted_at_its_crotch():
    # Two petals that meet at the crotch turn back: what went through one would leave the tip below both.
    petals = [shapely.Point(0, 0).buffer(1, quad_segs=32)] * 2
    petals = [
        shapely.affinity.rotate(shapely.affinity.scale(p, 2.9, 7), t, origin=(0, -7)) for p, t in zip(petals, (24, -24))
    ]
    tulip = shapely.union_all(petals).union(shapely.Polygon([(-3, -4), (3, -4), (0, -8)]))
    made, _ = limbs(tulip, 14)
    assert not any(limb.through for limb in made)


@pytest.mark.parametrize("radius", [0.02, 0.1, 0.24, 0.26, 0.3, 0.5, 1.0])
def test_dots_of_any_size_are_sewn_or_left_but_never_break(radius):
    for dot in (shapely.Point(3, 4).buffer(radius), shapely.box(0, 0, radius, 1.1 * radius)):
        made, left = limbs(dot, 14)
        assert all(np.isfinite(limb.column.middle).all() for limb in made)
        assert made or not left.is_empty

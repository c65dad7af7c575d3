"""Lines of one thread that meet end to end: sewn as one, corners and all; what lies between them stays where it is."""

import numpy as np
import pytest
import shapely

from tambour.core.paths import Paths
from tambour.embroidery.columns.ends import ended
from tambour.embroidery.columns.satin import Column, side_to_side
from tambour.embroidery.columns.stroke import from_stroke
from tambour.embroidery.params import EmbroideryParams
from tambour.embroidery.piece import Region
from tambour.embroidery.regions.strung import strung

P = EmbroideryParams()


def line(*at, width=3.0, color=(0, 0, 0), **more):
    return Region("l", Paths.of([np.array(at, float)]), "satin", color, P, "line", width, cap=0, join=0, **more)


def block(low, high, color):
    ring = np.array([low, (high[0], low[1]), high, (low[0], high[1])], float)
    return Region("b", Paths(ring, np.array([0, 4]), np.array([0, 1])), "tatami", color, P)


def drawn(regions):
    return shapely.union_all([shapely.LineString(p).buffer(r.width / 2) for r in regions for p in r.paths])


@pytest.mark.parametrize("turned", [(0, 0), (0, 1), (1, 0), (1, 1)])
@pytest.mark.parametrize("gap", [0.0, 0.6])
def test_two_lines_that_share_an_end_are_one_whichever_way_they_were_drawn(turned, gap):
    legs = [[(0, 0), (20, 0)], [(20, gap), (20, 15)]]
    found = [line(*leg[:: -1 if back else 1]) for leg, back in zip(legs, turned)]
    (one,) = strung(found)
    (way,) = one.paths
    assert len(way) == 3 and way[1] == pytest.approx((20, 0), abs=0.01)
    assert len(from_stroke(way, 3.0, 0)) == 2  # parted at its corner


def test_of_three_ends_the_straightest_pair_goes_on():
    made = strung([line((0, 0), (10, 0)), line((10, 0), (12, 10)), line((10, 0), (25, 1))])
    ends = sorted(tuple(np.round(p[[0, -1]].reshape(-1)).tolist()) for r in made for p in r.paths)
    assert len(ends) == 2 and any({0.0, 25.0} <= set(e) for e in ends)


def test_a_triangle_of_three_lines_is_closed():
    at = [(0, 0), (20, 0), (10, 18)]
    (one,) = strung([line(at[k], at[(k + 1) % 3]) for k in range(3)])
    (way,) = one.paths
    assert (way[0] == way[-1]).all() and len(way) == 4


@pytest.mark.parametrize(
    "other",
    [{"width": 4.0}, {"color": (255, 0, 0)}, {"start": (0.0, 0.0)}, {"rank": 1}, {"flags": frozenset({"whole"})}],
)
def test_other_lines_and_those_that_a_hand_placed_stay_by_themselves(other):
    assert len(strung([line((0, 0), (20, 0)), line((20, 0), (20, 15), **other)])) == 2


def test_what_lies_between_two_lines_stays_between_them():
    one, two = line((0, 0), (20, 0)), line((20, 0), (20, 15))
    below_both = strung([one, block((3, -5), (12, 5), (255, 0, 0)), two])
    # The first lies under the block, the second does not: both go before it.
    assert [r.role for r in below_both] == ["line", "area"]
    assert [r.role for r in strung([one, block((15, 4), (30, 12), (255, 0, 0)), two])] == ["area", "line"]
    assert len(strung([one, block((3, -5), (30, 12), (255, 0, 0)), two])) == 3


def test_a_line_that_ends_short_of_one_beside_it_is_led_on_as_far():
    made = strung([line((0, 0), (0, 20)), line((0.2, -10), (0.2, 18))])
    assert sorted(p[:, 1].max() for r in made for p in r.paths) == [20, 20]
    assert sorted(p[:, 1].min() for r in made for p in r.paths) == [-10, 0]


@pytest.mark.parametrize("seed", range(8))
def test_nothing_that_was_drawn_is_lost(seed):
    rng = np.random.default_rng(seed)
    grid = [(x, y) for x in (0.0, 14.0, 28.0) for y in (0.0, 14.0, 28.0)]
    found = []
    for _ in range(7):
        a, b = rng.choice(9, 2, replace=False)
        found.append(line(grid[a], (20 * rng.random(), 20 * rng.random()), grid[b]))
    made = strung(found)
    assert len(made) < len(found)
    assert drawn(found).symmetric_difference(drawn(made)).buffer(-0.03).is_empty


@pytest.mark.parametrize("width", [1.5, 4.0, 9.0])
def test_a_round_end_is_round_and_its_threads_lie_no_closer_than_elsewhere(width):
    (column,) = ended(from_stroke(np.array([(0.0, 0), (12, 0)]), width), width / 2, 0)
    rim = np.concatenate([column.left, column.right[::-1]])
    far = shapely.distance(shapely.LineString([(0, 0), (12, 0)]), shapely.points(rim))
    tip = rim[np.abs(rim[:, 0] - 6) > 6.01]
    assert far == pytest.approx(width / 2, abs=0.01)
    assert np.abs(tip[:, 0] - 6).max() > 6 + width / 2 - max(0.1, 0.03 * width)
    flat = EmbroideryParams(pull=0, pull_percent=0)
    at = side_to_side(Column(column.left, column.right), flat, "a").xy
    step = np.abs(np.diff(at[:, 0]))[3:-3]
    assert step.min() > 0.25 * flat.row_spacing / 2

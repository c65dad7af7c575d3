"""Contours of columns and fills: cut ends flush, sides on the outline, limbs that leave a wide part cleanly, gaps left open."""

import numpy as np
import pytest
import shapely
import shapely.affinity

from tambour.core.paths import Paths
from tambour.embroidery.columns.medial import limbs
from tambour.embroidery.families.decide import divided
from tambour.embroidery.params import EmbroideryParams
from tambour.embroidery.piece import AUTO, Region
from tambour.embroidery.regions.gaps import SHOWN, opened
from tambour.geometry.areas import of_shapely, to_shapely

P = EmbroideryParams()


def region(area, **more):
    return Region("a", of_shapely(area), more.pop("stitch", AUTO), more.pop("color", (0, 0, 0)), P, **more)


def outline(column):
    return shapely.Polygon(np.concatenate([column.left, column.right[::-1]]))


@pytest.mark.parametrize("slant", [-2.5, -1.5, 0.0, 1.5, 2.5])
@pytest.mark.parametrize("turn", [0, 35, 160])
def test_a_limb_s_last_stitch_lies_along_the_edge_that_it_ends_in(slant, turn):
    bar = shapely.Polygon([(0, 0), (40, 0), (40 + slant, 5), (0, 5)])
    (limb,), left = limbs(shapely.affinity.rotate(bar, turn, (0, 0)), 14.0)
    ends = np.array([[limb.column.left[k], limb.column.right[k]] for k in (0, -1)])
    edge = shapely.affinity.rotate(shapely.LineString([(40, 0), (40 + slant, 5)]), turn, (0, 0))
    off = min(shapely.hausdorff_distance(shapely.LineString(end), edge) for end in ends)
    assert off < 0.1 and left.area < 0.1
    across = np.hypot(*(limb.column.left - limb.column.right).T)
    assert across.min() > 4.5  # and they fan into it without a jump
    assert np.hypot(*np.diff(limb.column.left, axis=0).T).max() < 0.5


def test_a_round_end_is_not_cut():
    (limb,), _ = limbs(shapely.LineString([(0, 0), (30, 0)]).buffer(2.5), 14.0)
    assert np.hypot(*(limb.column.left - limb.column.right).T)[[0, -1]].max() < 4.5


def test_the_sides_of_a_plain_limb_are_its_outline_s():
    swoosh = shapely.Polygon([(0, 2), (10, -3), (40, -1), (60, -10), (41, 5), (14, 6)])
    (limb,), _ = limbs(swoosh, 14.0)
    assert outline(limb.column).symmetric_difference(swoosh).area < 0.01 * swoosh.area


def test_a_limb_is_parted_from_a_wide_part_without_a_flare_or_a_strip_along_it():
    wide = shapely.Point(0, 0).buffer(14)
    tail = shapely.LineString([(0, -9), (20, -11), (50, -11)]).buffer(1.8, cap_style="flat")
    parts = divided(shapely.union(wide, tail).buffer(1.5).buffer(-3).buffer(1.5))  # its corners filled in
    assert len(parts) == 2
    limb = min(parts, key=lambda p: p.area)
    widest = 2 * shapely.maximum_inscribed_circle(limb, 0.05).length
    assert widest < 1.4 * 3.6 and limb.buffer(-0.8).buffer(0.9).contains(limb.buffer(-0.1).simplify(0.05).buffer(-0.4))


@pytest.mark.parametrize("wide", [0.2, 0.45, 0.7])
def test_a_hair_line_between_areas_of_one_colour_is_as_wide_as_thread_needs(wide):
    one, two = shapely.box(0, 0, 20, 30), shapely.box(20 + wide, 0, 40, 30)
    made, count = opened([region(one), region(two)])
    shapes = [shapely.union_all(to_shapely(r.paths)) for r in made]
    assert count == 1 and shapes[0].distance(shapes[1]) == pytest.approx(SHOWN + 2 * P.pull, abs=0.05)
    slit = shapely.box(0, 0, 40, 30).difference(shapely.box(20, 3, 20 + wide, 27))
    (cut,), count = opened([region(slit)])
    assert count == 1 and cut.paths.coords[(cut.paths.coords[:, 0] > 5) & (cut.paths.coords[:, 0] < 35)].size


@pytest.mark.parametrize(
    "two",
    [
        region(shapely.box(20.02, 0, 40, 30)),  # a seam
        region(shapely.box(22, 0, 40, 30)),  # wide enough
        region(shapely.box(20.3, 0, 40, 30), color=(255, 0, 0)),
        region(shapely.box(20.3, 0, 40, 30), flags=frozenset({"letter"})),
        region(shapely.box(20.3, 28, 40, 50)),  # hardly beside it
    ],
)
def test_other_gaps_stay_as_they_are(two):
    given = (region(shapely.box(0, 0, 20, 30)), two)
    assert opened(given) == (given, 0)


def test_a_gap_that_a_line_covers_is_none():
    line = Region("l", Paths.of([np.array([(20.15, 0), (20.15, 30)])]), "satin", (9, 9, 9), P, "line", 3.0)
    given = (region(shapely.box(0, 0, 20, 30)), region(shapely.box(20.3, 0, 40, 30)), line)
    assert opened(given) == (given, 0)

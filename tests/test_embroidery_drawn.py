"""Areas that are lines of one width become lines; fills and the lines of their colour along their edges become one mass."""

import math

import numpy as np
import pytest
import shapely

from tambour.core.paths import Paths
from tambour.embroidery.params import EmbroideryParams
from tambour.embroidery.piece import AUTO, Region
from tambour.embroidery.plan.drawn import drawn, lines_of
from tambour.embroidery.plan.massed import massed
from tambour.geometry.areas import of_shapely

P = EmbroideryParams()
CAPS, JOINS = ("round", "flat"), ("round", "mitre")


def bend(turn: float, leg: float = 20.0):
    t = math.radians(turn)
    return np.array([(-leg, 0), (0, 0), (leg * math.cos(t), leg * math.sin(t))])


def region(area, stitch=AUTO, **more):
    paths = of_shapely(area)
    assert paths is not None
    return Region("a", paths, stitch, (0, 0, 0), P, **more)


def stroked(lines, width, cap, join):
    return shapely.union_all(
        [shapely.LineString(x).buffer(width / 2, cap_style=CAPS[cap], join_style=JOINS[join]) for x in lines]
    )


@pytest.mark.parametrize("cap", [0, 1])
@pytest.mark.parametrize("join", [0, 1])
@pytest.mark.parametrize("turn", [0, 30, 75, -85])
def test_the_outline_of_a_stroke_is_that_stroke_again(turn, join, cap):
    line = bend(turn)
    found = lines_of(shapely.LineString(line).buffer(2.0, cap_style=CAPS[cap], join_style=JOINS[join]))
    assert found is not None
    (again,), width, kind, _ = found
    assert width == pytest.approx(4.0, rel=0.02) and kind == cap
    assert shapely.hausdorff_distance(shapely.LineString(again), shapely.LineString(line)) < 0.12


@pytest.mark.parametrize("turn", [140, 155])
def test_lines_that_run_together_share_their_corner(turn):
    found = lines_of(shapely.LineString(bend(turn)).buffer(2.0))
    assert found is not None and len(found[0]) == 2
    assert all(np.hypot(*line[[0, -1]].T).min() < 0.05 for line in found[0])


@pytest.mark.parametrize("turn", [60, 90, 125])
def test_three_lines_that_meet_are_lines_again(turn):
    drawn_lines = [bend(0), np.array([(0, 0), bend(turn)[2]])]
    found = lines_of(stroked(drawn_lines, 4.0, 0, 0))
    assert found is not None
    assert len(found[0]) in (2, 3)
    again = stroked(found[0], found[1], 0, 0)
    assert again.symmetric_difference(stroked(drawn_lines, 4.0, 0, 0)).buffer(-0.05).area < 0.05


def test_a_ring_is_a_closed_line_and_keeps_its_corners():
    square = shapely.LinearRing([(0, 0), (30, 0), (30, 20), (0, 20)])
    found = lines_of(square.buffer(1.5, join_style="mitre"))
    assert found is not None
    (again,), width, _, join = found
    assert (again[0] == again[-1]).all() and width == pytest.approx(3.0, rel=0.02) and join == 1
    assert shapely.hausdorff_distance(shapely.LinearRing(again[:-1]), square) < 0.1


@pytest.mark.parametrize(
    "shape",
    [
        shapely.box(0, 0, 20, 12),
        shapely.Polygon([(0, 0), (40, 1), (40, 2), (0, 7)]),  # tapers
        shapely.Point(0, 0).buffer(5),
        shapely.union(shapely.LineString([(0, 0), (30, 0)]).buffer(2), shapely.Point(30, 0).buffer(6)),  # a spoon
    ],
)
def test_what_is_no_line_stays_an_area(shape):
    assert lines_of(shape) is None
    (one,) = drawn([region(shape)])
    assert one.role == "area"


@pytest.mark.parametrize("more", [{"stitch": "tatami"}, {"flags": frozenset({"letter"})}, {"rank": 1}])
def test_what_a_hand_chose_and_letters_stay_as_they_are(more):
    given = region(shapely.LineString(bend(90)).buffer(2.0), **more)
    assert drawn([given]) == (given,)
    assert drawn([region(shapely.LineString(bend(90)).buffer(2.0))])[0].role == "line"


def outline(ring, width=3.0, **more):
    return Region("o", Paths.of([np.array(ring, float)]), "satin", (0, 0, 0), P, "line", width, cap=0, join=0, **more)


def test_an_outline_of_its_fill_s_colour_is_part_of_the_fill():
    ring = [(0, 0), (20, 0), (20, 20), (0, 20), (0, 0)]
    (one,) = massed([region(shapely.Polygon(ring)), outline(ring)])
    assert one.role == "area"
    assert np.ptp(one.paths.coords, axis=0) == pytest.approx((23, 23), abs=0.1)


def test_only_the_stretch_along_the_fill_becomes_part_of_it():
    ring = [(0, 0), (20, 0), (20, 20), (0, 20)]
    made = massed([region(shapely.Polygon(ring)), outline([(0, 20), (0, 0), (20, 0), (50, 0)])])
    assert sorted(r.role for r in made) == ["area", "line"]
    line = next(r for r in made if r.role == "line")
    assert line.paths.coords[:, 0].min() == pytest.approx(20, abs=2) and line.paths.coords[:, 0].max() == 50


def test_a_line_that_only_touches_a_fill_stays_a_line():
    bar = shapely.box(0, 0, 8, 30)
    made = massed([region(bar), outline([(-20, 30), (30, 30)])])
    assert [r.role for r in made] == ["area", "line"] and np.ptp(made[1].paths.coords[:, 0]) == 50


def test_thin_fills_and_other_colours_keep_their_outlines():
    thin = [(0, 0), (20, 0), (20, 1), (0, 1), (0, 0)]
    square = [(0, 0), (20, 0), (20, 20), (0, 20), (0, 0)]
    other = Region("o", Paths.of([np.array(square, float)]), "satin", (9, 0, 0), P, "line", 3.0)
    assert len(massed([region(shapely.Polygon(square)), other])) == 2
    assert [r.role for r in massed([region(shapely.Polygon(thin)), outline(thin, 9.0)])] == ["area", "line"]


def test_what_lies_between_a_fill_and_its_outline_still_shows():
    square = [(0, 0), (20, 0), (20, 20), (0, 20), (0, 0)]
    face = Region("f", of_shapely(shapely.box(5, 10, 15, 30)), AUTO, (200, 150, 100), P)
    made = massed([region(shapely.Polygon(square)), face, outline(square)])
    black = next(r for r in made if r.color == (0, 0, 0) and r.role == "area")
    from tambour.embroidery.regions.flat import shape

    assert made.index(black) > 0 and shape(black).intersection(shapely.box(6, 11.6, 14, 18.4)).area < 0.1

"""What is chosen where nothing was asked for: satin, tatami or a line by the width of limbs, and angles by shape."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import shapely
import shapely.affinity

from tambour.core.drawing import Drawing, Groups, Styles
from tambour.core.paths import Paths
from tambour.core.progress import Progress
from tambour.embroidery.families.decide import stitch_of
from tambour.embroidery.lines.angle import angle, spans
from tambour.embroidery.params import EmbroideryParams
from tambour.embroidery.piece import FILL, RUNNING, SATIN
from tambour.embroidery.plan.make import make


def drawn(*polygons, data=None):
    rings, parts = [], [0]
    for p in polygons:
        rings += [np.array(r.coords) for r in (p.exterior, *p.interiors)]
        parts.append(len(rings))
    paths, n = Paths.of(rings), len(polygons)
    ids = tuple(f"p{k}" for k in range(n))
    groups = Groups(ids, ids, np.full(n, -1), np.zeros(n, bool), tuple(data or {} for _ in ids))
    return Drawing(
        Paths(paths.coords, paths.offsets, np.array(parts)),
        np.zeros(n),
        Styles.of(((0, 0, 0, 255), None, 0.0)),
        np.array([100.0, 100.0]),
        np.arange(n),
        groups,
    )


@pytest.mark.parametrize(
    "wide, kind", [(1.5, "satin"), (6.5, "satin"), (9.0, "satin"), (15.0, "tatami"), (30.0, "tatami")]
)
@pytest.mark.parametrize("turn", [0, 30, 77])
def test_a_bar_is_satin_up_to_its_width(wide, kind, turn):
    bar = shapely.affinity.rotate(shapely.box(0, 0, 60, wide), turn)
    assert stitch_of(bar) == kind


def test_a_disc_is_filled_and_a_ring_is_satin():
    disc = shapely.Point(0, 0).buffer(12)
    assert stitch_of(disc) == stitch_of(shapely.Point(0, 0).buffer(3)) == "tatami"
    assert stitch_of(shapely.Point(0, 0).buffer(2)) == "satin"  # no tatami narrower than 5 mm
    assert stitch_of(disc.difference(shapely.Point(0, 0).buffer(7))) == "satin"


def test_parts_of_one_shape_are_chosen_one_by_one():
    both = Drawing(
        *(lambda d: (Paths(d.paths.coords, d.paths.offsets, np.array([0, 2])), np.zeros(1)))(
            drawn(shapely.box(0, 0, 40, 40), shapely.box(50, 0, 53, 40))
        ),
        Styles.of(((0, 0, 0, 255), None, 0.0)),
        np.array([60.0, 40.0]),
    )
    made = make(both, EmbroideryParams(), Progress())
    assert sorted(r.stitch for r in made.regions) == ["satin", "tatami"]
    assert {SATIN, FILL} <= set(np.unique(made.kind).tolist())


def test_what_was_asked_for_stays():
    bar, square = shapely.box(0, 0, 40, 3), shapely.box(0, 10, 40, 50)
    made = make(
        drawn(bar, square, data={"tambour-stitch": "contour", "tambour-angle": "20"}), EmbroideryParams(), Progress()
    )
    assert [(r.stitch, r.params.angle) for r in made.regions] == [("contour", 20.0)] * 2
    made = make(drawn(bar), EmbroideryParams(stitch="tatami"), Progress())
    assert made.regions[0].stitch == "tatami"


def test_a_hair_is_a_line_there_and_back():
    made = make(drawn(shapely.box(0, 0, 30, 0.6)), EmbroideryParams(locks=False), Progress())
    kinds = made.kind[made.plan.command == 0]
    assert (kinds == RUNNING).mean() > 0.9 and 15 < len(kinds) < 60


@pytest.mark.parametrize("turn", [0, 30, 60, 105])
def test_rows_run_along_a_long_shape(turn):
    shape = shapely.affinity.rotate(shapely.box(-30, -8, 30, 8), -turn, origin=(0, 0))  # y down
    got = angle(spans(Paths.of([np.array(shape.exterior.coords)]), 1.0))
    assert min(abs(got - turn) % 180, 180 - abs(got - turn) % 180) <= 15


def two(*polygons):
    """Areas of which every second is red."""
    styles = Styles.of(((0, 0, 0, 255), None, 0.0), ((200, 0, 0, 255), None, 0.0))
    return replace(drawn(*polygons), styles=styles, style=np.arange(len(polygons)) % 2)


def test_neighbours_of_other_colours_lie_in_other_directions():
    made = make(two(shapely.box(0, 0, 20, 20), shapely.box(20, 0, 40, 20)), EmbroideryParams(), Progress())
    a, b = (r.params.angle for r in made.regions)
    assert min(abs(a - b) % 180, 180 - abs(a - b) % 180) >= 30


def test_areas_of_one_colour_lie_in_one_direction_unless_that_suits_one_far_worse():
    tile = shapely.Polygon([(0, 0), (20, 8), (16, 24), (2, 20)])
    tiles = [shapely.affinity.translate(shapely.affinity.scale(tile, s), 30 * k) for k, s in enumerate((1, -1, 1))]
    made = make(drawn(*tiles), EmbroideryParams(), Progress())
    assert len({r.params.angle for r in made.regions}) == 1
    bars = [shapely.box(0, 0, 60, 14), shapely.box(80, 0, 94, 60)]
    assert len({r.params.angle for r in make(drawn(*bars), EmbroideryParams(), Progress()).regions}) == 2


def test_the_bands_of_a_flag_are_sewn_one_way():
    bands = two(*(shapely.box(0, 10 * k, 60, 10 * k + 9.98) for k in range(4)), shapely.box(0, 40, 60, 70))
    assert {r.stitch for r in make(bands, EmbroideryParams(), Progress()).regions} == {"tatami"}
    alone = make(drawn(shapely.box(0, 0, 60, 10)), EmbroideryParams(), Progress())
    assert [r.stitch for r in alone.regions] == ["satin"]

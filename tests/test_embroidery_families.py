"""Every family of stitches: one thread per area, inside it, no stitch too long, covered where it promises to."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest
import shapely

from tambour import files
from tambour.core.drawing import Drawing, Groups, Styles
from tambour.core.paths import Paths
from tambour.core.progress import Progress
from tambour.core.thread import COLOR, JUMP, STITCH
from tambour.embroidery.params import EmbroideryParams
from tambour.embroidery.piece import FILL, LOCK, SATIN, TRAVEL, UNDERLAY
from tambour.embroidery.plan.facts import facts, steps
from tambour.embroidery.plan.make import make

PITCH = 0.5
COVERING = ("tatami", "contour", "spiral", "radial", "guided", "flow")


def leaf():
    """A leaf of 34 x 20 mm with a notch and a round hole."""
    t = np.linspace(0, 2 * math.pi, 120, endpoint=False)
    outline = np.c_[17 * np.cos(t), 10 * np.sin(t) * (1 - 0.35 * np.cos(t)) + 2.5 * np.exp(-8 * (np.cos(t) - 0.1) ** 2)]
    s = t[::-4]
    return [outline, np.c_[-5 + 3 * np.cos(s), 0.5 + 3 * np.sin(s)]]


def drawing(lines, fill=(20, 60, 120, 255), stroke=None, width=0.0, data=None):
    paths = Paths.of([np.concatenate([line, line[:1]]) for line in lines])
    groups = Groups(("it",), ("it",), np.array([-1]), np.zeros(1, bool), (data or {},))
    return Drawing(
        Paths(paths.coords, paths.offsets, np.array([0, len(lines)])),
        np.zeros(1),
        Styles.of((fill, stroke, width)),
        np.array([40.0, 30.0]),
        np.zeros(1),
        groups,
    )


def piece(family, **params):
    return make(
        drawing(leaf()), EmbroideryParams(stitch=family, row_spacing=PITCH, underlay="none", **params), Progress()
    )


@pytest.mark.parametrize("family", [*COVERING, "gradient", "meander", "ripple", "cross"])
def test_family_is_one_thread_inside(family):
    made = piece(family, locks=False)
    told = facts(made)
    assert told["outside"] == 0
    assert (made.plan.command == JUMP).sum() == 1  # to the beginning
    assert told["longest_mm"] <= 3.0 + 1e-9
    assert told["stitches"] > 20


@pytest.mark.slow
@pytest.mark.parametrize("family", COVERING)
def test_family_covers(family):
    made = piece(family, locks=False)
    xy, _ = steps(made)
    lines = shapely.linestrings(xy.reshape(-1, 2, 2))
    middle = (leaf()[0].min(0) + leaf()[0].max(0)) / 2
    area = shapely.Polygon(leaf()[0] - middle, [leaf()[1] - middle])
    inner = area.buffer(-PITCH / 2)
    p = np.random.Generator(np.random.PCG64(2)).uniform(inner.bounds[:2], inner.bounds[2:], (20_000, 2))
    p = shapely.points(p[shapely.contains_xy(inner, p)])
    far = shapely.distance(p, lines[shapely.STRtree(lines).nearest(p)])
    # A gap is the widest circle that no thread enters: 1.5 pitches; flow is even on average only (see the docs).
    if family == "flow":
        assert np.quantile(far, 0.995) <= 0.75 * PITCH
    else:
        assert 2 * far.max() <= 1.5 * PITCH


def test_gradient_rows_draw_apart_downwards_to_up():
    made = piece("gradient", locks=False)
    rows = np.unique(np.round(made.plan.xy[(made.kind == FILL) & (made.plan.command == STITCH)][:, 1], 6))
    gap = np.diff(rows)[::-1]
    assert gap[0] == pytest.approx(PITCH, rel=0.15) and gap[-1] == pytest.approx(3 * PITCH, rel=0.15)
    assert (np.diff(gap) > 0).mean() > 0.95


def test_meander_never_crosses_itself():
    made = piece("meander", locks=False, motif_size=1.5)
    line = shapely.LineString(made.plan.xy[made.plan.command == STITCH])
    assert line.is_simple or shapely.LineString(line.coords[:-1]).is_simple


def test_cross_stitch_sews_every_leg_twice():
    made = piece("cross", locks=False, motif_size=4.0)
    xy, end = steps(made)
    legs = xy[made.kind[end] == FILL]
    legs = legs[np.hypot(*(legs[:, 2:] - legs[:, :2]).T) > 1e-9]
    assert np.allclose(np.abs(legs[:, 2:] - legs[:, :2]), 2.0)
    keys = {}
    for leg in np.round(legs, 6).tolist():
        key = tuple(sorted((tuple(leg[:2]), tuple(leg[2:]))))
        keys[key] = keys.get(key, 0) + 1
    assert set(keys.values()) == {2}


def test_underlay_comes_first_and_lies_inside():
    made = make(drawing(leaf()), EmbroideryParams(row_spacing=PITCH), Progress())
    kinds = made.kind[made.plan.command == STITCH]
    assert (kinds == UNDERLAY).sum() > 20
    assert np.flatnonzero(kinds == UNDERLAY).max() < np.flatnonzero(kinds == FILL).min() + 5
    assert facts(made)["outside"] == 0 and facts(made)["jumps"] <= 1


def test_pull_widens_a_fill():
    plain, wide = (make(drawing(leaf()), EmbroideryParams(pull=p, underlay="none"), Progress()) for p in (0.0, 0.4))
    assert np.ptp(wide.plan.xy[:, 0]) == pytest.approx(np.ptp(plain.plan.xy[:, 0]) + 0.8, abs=0.15)


def test_satin_of_an_area_goes_from_side_to_side():
    bar = [np.array([[0, 0], [30, 0], [30, 4], [0, 4]], float)]
    made = make(drawing(bar), EmbroideryParams(stitch="satin", pull=0.0), Progress())
    xy, end = steps(made)
    satin = xy[made.kind[end] == SATIN]
    size = np.hypot(satin[:, 2] - satin[:, 0], satin[:, 3] - satin[:, 1])
    assert np.median(size) == pytest.approx(4, abs=0.1)
    assert 60 < len(satin) < 200 and facts(made)["jumps"] <= 1


def test_wide_satin_is_split_without_a_line_of_needle_points():
    made = make(
        drawing([np.array([[0, 0], [30, 0], [30, 10], [0, 10]], float)]), EmbroideryParams(stitch="satin"), Progress()
    )
    assert facts(made)["longest_mm"] <= 7.0 + 1e-6
    xy = made.plan.xy[(made.kind == SATIN) & (made.plan.command == STITCH)]
    inner = xy[np.abs(xy[:, 1]) < 4]
    assert len(np.unique(np.round(inner[:, 1], 1))) >= 3


def test_a_broad_line_is_satin_a_thin_one_running():
    line = np.array([[0, 0], [10, 0], [10, 10], [0, 10]], float)
    for width, kind in ((2.0, SATIN), (0.5, 2)):
        made = make(
            drawing([line], None, (9, 9, 9, 255), width),
            EmbroideryParams(underlay="none", locks=False, pull=0.0),
            Progress(),
        )
        assert set(np.unique(made.kind[made.plan.command == STITCH])) <= {kind, 4} | ({kind})
        if kind == SATIN:
            xy, _end = steps(made)
            size = np.hypot(xy[:, 2] - xy[:, 0], xy[:, 3] - xy[:, 1])
            assert np.median(size) == pytest.approx(2.0, abs=0.1)


def test_bean_sews_every_stitch_an_odd_number_of_times():
    line = np.array([[0, 0], [20, 0], [20, 10]], float)
    made = make(
        drawing([line], None, (9, 9, 9, 255), 0.4, {"tambour-stitch": "bean"}),
        EmbroideryParams(locks=False),
        Progress(),
    )
    xy, _ = steps(made)
    xy = xy[np.hypot(xy[:, 2] - xy[:, 0], xy[:, 3] - xy[:, 1]) > 1e-9]
    same = xy[0::3], xy[1::3], xy[2::3]
    assert np.allclose(same[0], same[2]) and np.allclose(same[0], same[1][:, [2, 3, 0, 1]])


def test_applique_stops_twice_and_covers_the_edge():
    made = make(drawing(leaf()[:1]), EmbroideryParams(applique=True), Progress())
    told = facts(made)
    assert told["stops"] == 2 and (made.kind == SATIN).sum() > 100


def test_a_knockdown_is_of_the_cloths_colour_and_a_stop_of_its_own():
    made = make(drawing(leaf()), EmbroideryParams(fabric="towel", ground="#336699"), Progress())
    cloth, *design = made.plan.threads
    assert cloth.rgb == (0x33, 0x66, 0x99) and cloth.name == "as the cloth" and cloth not in design
    kinds = [set(made.kind[(made.plan.thread == t) & (made.plan.command == STITCH)].tolist()) for t in (0, 1)]
    assert kinds[0] <= {UNDERLAY, TRAVEL, LOCK} and (made.plan.command == COLOR).sum() == 1
    assert FILL in kinds[1] or SATIN in kinds[1]


def test_basting_and_knockdown_come_first():
    made = make(drawing(leaf()), EmbroideryParams(baste=True, knockdown=True), Progress())
    sewn = made.plan.command == STITCH
    assert (made.region[sewn][:10] == -1).all()
    box = made.plan.xy[sewn][:20]
    assert np.ptp(made.plan.xy[sewn][:, 0]) == pytest.approx(np.ptp(leaf()[0][:, 0]) + 10, abs=0.2) and len(box)


@pytest.mark.slow
@pytest.mark.parametrize("guide", [True, False])
def test_flow_follows_its_guide(guide):
    from tambour.embroidery.lines.field import direction, field
    from tambour.embroidery.lines.flow import flow

    area = shapely.Polygon(leaf()[0], [leaf()[1]])
    line = Paths.of([np.c_[np.linspace(-16, 16, 30), 4 * np.sin(np.linspace(-2, 2, 30))]]) if guide else None
    lines = flow(area, PITCH, line, 0.2, "a")
    grid, left, top, cell = field((*(np.array(area.bounds[:2]) - 1), *(np.array(area.bounds[2:]) + 1)), line, 0.2, "a")
    off = []
    for p in lines:
        for a, b in itertools.pairwise(p):
            d = b - a
            n = np.hypot(*d)
            if n > 0.1:
                x, y = direction(grid, left, top, cell, *((a + b) / 2), *d)
                off.append(math.degrees(math.acos(min(1.0, (x * d[0] + y * d[1]) / n))))
    assert np.median(off) <= 5


@pytest.mark.parametrize("high, rows", [(6, False), (20, True)])
def test_narrow_areas_have_no_rows_below_but_the_edge_walk(tmp_path, high, rows):
    (tmp_path / "a.svg").write_text(
        f'<svg xmlns="http://www.w3.org/2000/svg" width="60mm" height="40mm"><rect width="180" height="{high / 25.4 * 96}"/></svg>'
    )
    made = make(files.read(tmp_path / "a.svg", ("Drawing",)), EmbroideryParams(stitch="tatami", angle=0), Progress())
    under = made.plan.xy[(made.kind == UNDERLAY) & (made.plan.command == STITCH)]
    inside = (high / 2 - np.abs(under[:, 1]) > 2.5) & (
        np.abs(under[:, 0]) < 20
    )  # farther from the edges than their walk
    assert len(under) > 20 and inside.any() == rows

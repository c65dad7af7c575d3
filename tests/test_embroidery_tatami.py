"""The star of the promise: routed without a jump, inside, even, covered."""

from __future__ import annotations

import math

import numpy as np
import pytest
import shapely

from tambour.core.paths import Paths
from tambour.embroidery.families.tatami import tatami
from tambour.embroidery.lines.density import density_map
from tambour.embroidery.lines.fill import rings
from tambour.embroidery.lines.least import tidy
from tambour.embroidery.lines.route import LINE, adjacency, euler, ring_edges
from tambour.embroidery.piece import FILL, TRAVEL
from tambour.embroidery.plan.facts import full_cells
from tambour.embroidery.stitches import Stitches

ANGLE = math.radians(30)


def star(vertices=1000):
    """Spec 4.2: nine tips, a rippled edge, four round holes; 12,817 mm²."""
    t = np.linspace(0, 2 * np.pi, int(vertices * 0.9), endpoint=False)
    r = 40 + 50 * np.abs(2 * ((t * 9 / (2 * np.pi)) % 1) - 1) + 1.5 * np.sin(61 * t) + 0.6 * np.sin(223 * t + 1)
    lines = [100 + r[:, None] * np.c_[np.cos(t), np.sin(t)]]
    s = np.linspace(0, 2 * np.pi, vertices // 40, endpoint=False)[::-1]
    for x, y, size in ((100, 100, 14), (128, 100, 7), (76, 112, 7), (100, 72, 8)):
        lines.append(np.c_[x + size * np.cos(s), y + size * np.sin(s)])
    return lines


@pytest.fixture(scope="module")
def area():
    return shapely.Polygon(star()[0], star()[1:])


@pytest.fixture(scope="module", params=["outline", "hidden"])
def filled(request):
    lines = [np.concatenate([line, line[:1]]) for line in star()]
    made = tatami(rings(Paths.of(lines), ANGLE), ANGLE, 0.4, 3.0, travel=request.param)
    return request.param, tidy(made, 0.3, rings(Paths.of(lines))), made


@pytest.mark.slow
def test_star_is_one_thread_inside_its_outline(filled, area):
    how, made, whole = filled
    step = np.hypot(*np.diff(made.xy, axis=0).T)
    assert step.max() <= 3.0 + 1e-9  # no jumps: nothing is longer than a stitch
    lines = shapely.linestrings(np.stack([made.xy[:-1], made.xy[1:]], 1))
    # Short stitches are joined only where what takes their place stays inside; one corner of 13,000 leaves no way.
    assert (step < 0.3 - 1e-9).sum() <= 1 and step.min() > 0.2
    assert shapely.contains(area.buffer(0.05), lines).all()
    plain = np.stack([whole.xy[:-1], whole.xy[1:]], 1)
    assert shapely.contains(area.buffer(0.05), shapely.linestrings(plain)).all()
    assert made.facts["connector_mm"] <= 1200
    if how == "hidden":
        assert made.facts["covered_mm"] > 0.7 * made.facts["hidden_mm"] > 50


@pytest.mark.slow
def test_star_is_even(filled, area):
    _, made, _ = filled
    bounds = area.bounds
    full = full_cells([area], bounds)
    pieces = np.c_[made.xy[:-1], made.xy[1:]]
    rows = density_map(pieces, (made.kind[1:] == FILL).astype(float), bounds)[full]
    every = density_map(pieces, np.ones(len(pieces)), bounds)[full]
    assert rows.std() / rows.mean() <= 0.015
    assert every.std() / every.mean() <= 0.03
    assert abs(rows.mean() - 2.5) < 0.01


def test_star_is_covered(filled, area):
    _, made, _ = filled
    lines = shapely.linestrings(np.stack([made.xy[:-1], made.xy[1:]], 1))
    p = np.random.Generator(np.random.PCG64(3)).uniform(area.bounds[:2], area.bounds[2:], (30_000, 2))
    p = shapely.points(p[shapely.contains_xy(area, p)])
    near = shapely.STRtree(lines).nearest(p)
    assert shapely.distance(p, lines[near]).max() <= 0.6


def test_needle_points_are_staggered_and_locked_to_the_plane():
    square = np.array([[0, 0], [20, 0], [20, 8], [0, 8], [0, 0]], float)
    one = tatami(rings(Paths.of([square])), 0.0, 0.5, 2.0)
    two = tatami(rings(Paths.of([square + np.array([7.3, 0])])), 0.0, 0.5, 2.0)
    for made in (one, two):
        inner = made.xy[(made.kind == FILL) & (made.xy[:, 0] > 9) & (made.xy[:, 0] < 18.6)]
        row = np.floor(inner[:, 1] / 0.5).astype(int)
        off = (inner[:, 0] - (row % 4) / 4 * 2.0) % 2.0
        assert len(inner) > 50 and np.allclose(np.minimum(off, 2.0 - off), 0, atol=1e-9)


def test_euler_walk_uses_every_edge_once_and_is_connected():
    draw = np.random.Generator(np.random.PCG64(8))
    for _ in range(30):
        spans = int(draw.integers(2, 40))
        at = np.sort(draw.uniform(0, 100, 2 * spans))
        order = draw.permutation(2 * spans)
        place = np.empty(2 * spans)
        place[order] = at
        a, b, length = ring_edges(order, np.zeros(2 * spans, np.int64), place, np.array([0.0, 100.0]))
        ea, eb = np.r_[2 * np.arange(spans), a], np.r_[2 * np.arange(spans) + 1, b]
        kind = np.r_[np.full(spans, LINE), np.ones(len(a))].astype(np.int8)
        offsets, edge = adjacency(2 * spans, ea, eb)
        assert (np.diff(offsets) % 2 == 0).all()
        walk, begin = euler(0, ea, eb, np.r_[np.zeros(spans), length], kind, offsets, edge)
        assert sorted(walk.tolist()) == list(range(len(ea)))
        end = np.where(ea[walk] == begin, eb[walk], ea[walk])
        assert (end[:-1] == begin[1:]).all() and end[-1] == begin[0]


def test_doubled_outline_is_the_shorter_half():
    order = np.arange(4)
    at = np.array([0.0, 1.0, 10.0, 11.0])
    _, _, length = ring_edges(order, np.zeros(4, np.int64), at, np.array([0.0, 20.0]))
    assert length.sum() == 20 + 2  # once round, and the two short pieces again


def test_travel_and_rows_are_told_apart(filled):
    _, made, _ = filled
    assert set(np.unique(made.kind)) == {FILL, TRAVEL}
    assert (np.diff(made.run) >= 0).all()


def test_short_stitches_are_joined_inside_their_area_only():
    # A notch from above: without rings the two points beside its tip become one stitch across bare cloth.
    notch = np.array([[0, 0], [10, 0], [10, 6], [5.5, 6], [5, 1], [4.5, 6], [0, 6]], float)
    area = rings(Paths.of([np.concatenate([notch, notch[:1]])]))
    xy = np.array([[0, 3], [4.6, 3], [4.9, 0.98], [5.1, 0.98], [5.4, 3], [10, 3]])
    thread = Stitches.of(xy, FILL)
    solid = shapely.Polygon(notch).buffer(0.06)
    for least in (0.3, 2.5):
        made = tidy(thread, least, area)
        assert solid.contains(shapely.LineString(made.xy))
        assert len(tidy(thread, least)) <= len(made)
    assert not solid.contains(shapely.LineString(tidy(thread, 2.5).xy))  # the rings are what holds it
    assert len(tidy(thread, 0.0, area)) == len(xy)

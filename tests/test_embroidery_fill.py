"""Rows of a fill: against Shapely, against a plain twin, and what the seed says of their number."""

from __future__ import annotations

import math

import numpy as np
import pytest
import shapely

from tambour.core.paths import Paths
from tambour.embroidery.lines.fill import crossings, from_rows, inside_pairs, levels, rings, rows, to_rows
from tambour.embroidery.lines.ways import way


def closed(*lines):
    return Paths.of([np.concatenate([line, line[:1]]) for line in lines])


def blob(draw, center, radius, n):
    """A star-shaped ring with n corners."""
    angle = np.sort(draw.uniform(0, 2 * math.pi, n))
    return center + (radius * draw.uniform(0.45, 1, n))[:, None] * np.c_[np.cos(angle), np.sin(angle)]


def polygon(draw):
    """A concave polygon with up to three holes that do not touch, as rings and as Shapely's."""
    outer = blob(draw, np.zeros(2), 20.0, int(draw.integers(5, 14)))
    area = shapely.Polygon(outer)
    if not area.is_valid:
        return None
    holes = []
    for _ in range(int(draw.integers(0, 4))):
        hole = blob(draw, draw.uniform(-10, 10, 2), float(draw.uniform(1, 4)), int(draw.integers(3, 7)))
        one = shapely.Polygon(hole)
        if one.is_valid and area.contains(one.buffer(0.01)):
            area = area.difference(one)
            if area.geom_type != "Polygon":
                return None
            holes.append(hole)
    return [outer, *holes], area


@pytest.mark.slow
def test_rows_equal_shapely_on_ten_thousand_polygons_with_holes():
    draw = np.random.Generator(np.random.PCG64(5))
    done = worst = 0
    while done < 10_000:
        made = polygon(draw)
        if made is None:
            continue
        outlines, area = made
        angle = float(draw.uniform(0, math.pi))
        span = rows(closed(*outlines), angle, 7.7)
        if not len(span.row):
            continue
        done += 1
        turned = shapely.transform(area, lambda p, angle=angle: to_rows(p, angle))
        v = span.levels
        ends = np.stack([np.c_[np.full(len(v), -60.0), v], np.c_[np.full(len(v), 60.0), v]], 1)
        pieces, row = shapely.get_parts(shapely.intersection(turned, shapely.linestrings(ends)), return_index=True)
        box = shapely.bounds(pieces)
        long = box[:, 2] - box[:, 0] > 1e-9
        wanted = np.c_[row, box[:, 0], box[:, 2]][long]
        wanted = wanted[np.lexsort((wanted[:, 1], wanted[:, 0]))]
        got = np.c_[span.row, span.u][span.u[:, 1] - span.u[:, 0] > 1e-9]
        assert got.shape == wanted.shape and (got[:, 0] == wanted[:, 0]).all()
        worst = max(worst, float(np.abs(got - wanted).max(initial=0)))
    assert worst < 1e-6


def plain_rows(lines, heights, evenodd):
    """The twin: every edge against every row, in plain Python."""
    found = []
    for k, v in enumerate(heights):
        hits = []
        for line in lines:
            for a, b in zip(line, np.roll(line, -1, 0)):
                if min(a[1], b[1]) <= v < max(a[1], b[1]):
                    hits.append((a[0] + (v - a[1]) * (b[0] - a[0]) / (b[1] - a[1]), 1 if b[1] > a[1] else -1))
        hits.sort()
        assert len(hits) % 2 == 0
        winding = 0
        for u, sign in hits:
            before, winding = winding, 1 - winding if evenodd else winding + sign
            if before == 0 and winding != 0:
                begin = u
            elif before != 0 and winding == 0:
                found.append((k, begin, u))
    return np.array(found).reshape(-1, 3)


@pytest.mark.parametrize("evenodd", [True, False])
def test_crossing_rings_by_both_rules_equal_the_plain_twin(evenodd):
    draw = np.random.Generator(np.random.PCG64(6))
    for _ in range(40):
        lines = [draw.uniform(0, 20, (int(draw.integers(3, 9)), 2)) for _ in range(int(draw.integers(1, 4)))]
        span = rows(closed(*lines), 0.0, 1.3, evenodd=evenodd)
        wanted = plain_rows(lines, span.levels, evenodd)
        assert np.array_equal(span.row, wanted[:, 0])
        assert np.allclose(span.u, wanted[:, 1:], atol=1e-9)


def test_vertices_and_flat_edges_on_a_row_leave_no_odd_row():
    comb = np.array([[0, 0], [10, 0], [10, 5], [8, 5], [7, 2], [6, 5], [4, 5], [4, 2], [2, 2], [2, 5], [0, 5]], float)
    area = rings(closed(comb))
    starts, u, _, sign = crossings(area.points, area.offsets, np.array([0.0, 2.0, 5.0, 2.0 + 1e-12]))
    assert (np.diff(starts) % 2 == 0).all()
    row, first, last = inside_pairs(starts, sign, True)
    assert (u[last] >= u[first]).all() and set(row.tolist()) >= {0, 1}


def test_free_rows_are_as_many_as_the_seed_says_and_locked_rows_tile():
    for tall in (0.9, 1.0, 3.3, 10.0):
        assert len(levels(0.0, tall, 0.4, locked=False)) == math.floor(tall / 0.4 + 1e-9)
    together = levels(0.0, 20.0, 0.4)
    assert np.allclose(np.r_[levels(0.0, 7.1, 0.4), levels(7.1, 20.0, 0.4)], together)


def test_row_frame_turns_back():
    p = np.random.Generator(np.random.PCG64(1)).uniform(-5, 5, (50, 2))
    assert np.allclose(from_rows(to_rows(p, 0.7), 0.7), p)
    # Counter-clockwise as seen, y down: at 90 degrees a row runs up.
    assert np.allclose(from_rows(np.array([[1.0, 0.0]]), math.pi / 2), [[0, -1]])


@pytest.mark.slow
def test_a_way_stays_inside_through_any_neck():
    """From ring to ring through bridges narrower than any row: the way never leaves the area."""
    draw = np.random.default_rng(1)
    for neck in (0.4, 0.1, 0.03):
        discs = [
            shapely.Point(12 * k, 5 * (k % 2)).buffer(5).difference(shapely.Point(12 * k, 5 * (k % 2)).buffer(3.6))
            for k in range(4)
        ]
        bars = [
            shapely.LineString([(12 * k + 4.4, 5 * (k % 2)), (12 * k + 7.6, 5 * ((k + 1) % 2))]).buffer(neck / 2)
            for k in range(3)
        ]
        shape = shapely.union_all([*discs, *bars])
        area = rings(Paths.of([np.array(r.coords) for r in (shape.exterior, *shape.interiors)]))
        for _ in range(20):
            a, b = (shape.exterior.interpolate(t, normalized=True).coords[0] for t in draw.random(2))
            line = shapely.LineString(way(area, np.array(a), np.array(b)))
            assert line.difference(shape.buffer(0.06)).length < 1e-9, neck


def test_needle_points_outside_by_their_pull_are_joined_straight():
    """On a towel they stand half a millimetre outside: a way that enters the area there was led along a row of it."""
    area = rings(Paths.of([np.array([[0.0, 0], [20, 0], [20, 10], [0, 10], [0, 0]])]))
    a, b = np.array([8.0, -0.5]), np.array([8.3, 2.1])
    assert len(way(area, a, b, pull=0.5)) == 2 < len(way(area, a, b))

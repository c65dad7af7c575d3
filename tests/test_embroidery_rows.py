"""Fills of rows at their edges, and what lies on what: the run along the rim, needle points like a honeycomb, true curves."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import shapely
import shapely.affinity

from tambour import files
from tambour.core.progress import Progress
from tambour.core.thread import STITCH
from tambour.embroidery.columns.stroke import from_stroke
from tambour.embroidery.families.decide import divided
from tambour.embroidery.families.tatami import stride
from tambour.embroidery.params import EmbroideryParams
from tambour.embroidery.piece import FILL
from tambour.embroidery.plan.make import make
from tambour.embroidery.plan.order import order


def made(tmp_path: Path, inner: str, box: float = 60, **params):
    file = tmp_path / "a.svg"
    file.write_text(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {box} {box}">{inner}</svg>')
    return make(files.read(file, ("Drawing",)), EmbroideryParams(**params), Progress())


def cover(piece):
    """What thread of 0.4 mm covers."""
    plan = piece.plan
    end = np.flatnonzero((plan.command[1:] == STITCH) & (plan.command[:-1] == STITCH)) + 1
    lines = shapely.linestrings(np.stack([plan.xy[end - 1], plan.xy[end]], axis=1))
    return shapely.union_all(shapely.buffer(lines, 0.2, cap_style="flat", quad_segs=2)).buffer(0.01)


def from_edge(piece, edge):
    """mm (n,) from places of a drawn edge to the edge of what is sewn."""
    at = shapely.line_interpolate_point(edge, np.arange(0, edge.length, 0.1))
    return shapely.distance(at, cover(piece).boundary)


@pytest.mark.parametrize("angle", [0, 37])
def test_rows_end_on_the_edge_that_was_drawn(tmp_path, angle):
    disc = '<ellipse cx="30" cy="30" rx="14" ry="9"/>'
    edge = shapely.affinity.scale(shapely.Point(0, 0).buffer(1, quad_segs=64), 14, 9).boundary
    how = {"width": 28, "angle": angle, "pull": 0, "push": 0, "stitch": "tatami"}
    with_run, without = (from_edge(made(tmp_path, disc, **how, rim=rim), edge) for rim in (True, False))
    assert np.percentile(with_run, 95) < 0.13 and with_run.max() < 0.22
    assert np.percentile(without, 95) > 0.2  # so it was: steps as deep as a row is wide


def test_the_run_costs_few_stitches_and_lies_below_the_rows(tmp_path):
    disc = '<circle cx="30" cy="30" r="10"/>'
    with_run, without = (made(tmp_path, disc, width=20, rim=rim) for rim in (True, False))
    assert abs(len(with_run.plan) - len(without.plan)) < 0.06 * len(without.plan)
    first = int(np.argmax(with_run.kind == FILL))
    rim = shapely.Point(0, 0).buffer(9.9).boundary
    near = shapely.distance(shapely.points(with_run.plan.xy), rim) < 0.35
    assert near[:first].sum() > 20  # at the rim before the first row


def test_needle_points_of_neighbouring_rows_lie_like_a_honeycomb(tmp_path):
    piece = made(tmp_path, '<rect width="60" height="60"/>', width=40, angle=0, stitch="tatami")
    xy = piece.plan.xy[(piece.kind == FILL) & (np.abs(piece.plan.xy) < 12).all(axis=1)]
    apart = [np.sort(np.hypot(*(xy - p).T))[1] for p in xy[::7]]
    assert min(apart) > 1.05  # of 1.18 that is possible at one point in 1.2 mm²; quarters of a stitch had 0.85
    assert [stride(n) for n in (1, 2, 3, 4, 5, 8, 13)] == [1, 1, 1, 1, 2, 3, 5]


@pytest.mark.parametrize("box", [24, 512])
def test_a_circle_of_an_icon_is_a_circle_however_small_its_file(tmp_path, box):
    ring = (
        f'<circle cx="{box / 2}" cy="{box / 2}" r="{box * 0.4}" fill="none" stroke="#000" stroke-width="{box / 12}"/>'
    )
    piece = made(tmp_path, ring, box, width=90)
    away = np.hypot(*piece.regions[0].paths.coords.T)
    middle = np.hypot(*((piece.regions[0].paths.coords[1:] + piece.regions[0].paths.coords[:-1]) / 2).T)
    assert np.ptp(away) < 0.02 and away.mean() - middle.min() < 0.05


def test_a_round_join_is_sewn_round_and_a_mitre_pointed():
    corner = np.array([(-20.0, 0), (0, 0), (0, 20)])

    def reach(join):
        ends = np.concatenate([side for c in from_stroke(corner, 4.0, join) for side in (c.left, c.right)])
        return float((ends @ np.array([1, -1]) / np.sqrt(2)).max())

    assert reach(1) == pytest.approx(2 * np.sqrt(2), abs=0.05)
    assert reach(0) == pytest.approx(2.0, abs=0.08)


def test_a_line_that_ends_on_another_of_its_thread_lies_below_it(tmp_path):
    ring = '<circle cx="30" cy="30" r="20"/>'
    spoke = '<path d="M30 30V10"/>'
    for inner in (ring + spoke, spoke + ring):
        piece = made(tmp_path, f'<g fill="none" stroke="#000" stroke-width="4">{inner}</g>', width=44)
        closed = [bool((r.paths[0][0] == r.paths[0][-1]).all()) for r in piece.regions]
        assert [closed[k] for k in order(piece.regions, "auto")] == [False, True]
        assert [len(r.paths) for r in piece.regions] == [1, 1]  # neither is cut where the other lies on it


def test_a_hidden_part_that_hangs_on_by_its_rim_is_not_sewn(tmp_path):
    stripes = "".join(
        f'<rect x="5" y="{y}" width="50" height="{50 - y}" fill="{c}"/>'
        for y, c in ((5, "red"), (20, "#fff"), (35, "blue"))
    )
    frame = '<rect x="5" y="5" width="50" height="45" fill="none" stroke="#000" stroke-width="2"/>'
    piece = made(tmp_path, stripes + frame, width=60)
    red = next(r for r in piece.regions if r.color == (255, 0, 0))
    assert np.ptp(red.paths.coords[:, 1]) < 15 * 60 / 52 + 6


@pytest.mark.parametrize(
    "inner",
    [
        '<circle cx="30" cy="30" r="1.5" fill="none" stroke="#000" stroke-width="3"/>',
        '<polygon fill="#000" stroke="#000" stroke-width="1.8" points="30,24 33.5,35 24,28.4 36,28.4 26.5,35"/>',
    ],
)
def test_a_dot_drawn_as_a_ring_and_a_star_are_filled(tmp_path, inner):
    piece = made(tmp_path, inner, width=10)
    assert [(r.role, r.stitch) for r in piece.regions] == [("area", "tatami")]


def test_a_ring_with_a_hole_stays_a_line(tmp_path):
    ring = '<circle cx="30" cy="30" r="3" fill="none" stroke="#000" stroke-width="3"/>'
    assert made(tmp_path, ring, width=9).regions[0].role == "line"


def test_a_thin_frame_that_hangs_on_a_wide_part_is_satin_by_itself(tmp_path):
    shape = '<path fill-rule="evenodd" d="M0 0H60V60H0ZM20 3V57H57V3Z"/>'
    piece = made(tmp_path, shape, width=80)
    assert sorted((r.stitch, len(r.paths)) for r in piece.regions) == [("satin", 1), ("tatami", 1)]
    below = made(tmp_path, shape + '<circle cx="10" cy="10" r="2.8" fill="red"/>', width=80)
    assert below.regions[0].stitch == "tatami" and len(below.regions) == 2  # what lies below others stays whole


@pytest.mark.parametrize("length", [20, 40, 80])
def test_a_horn_that_tapers_off_is_part_of_what_it_grows_from(length):
    head = shapely.Point(0, 0).buffer(12)
    assert len(divided(head.union(shapely.Polygon([(0, -8), (0, 8), (length, 0)])))) == 1
    assert len(divided(head.union(shapely.box(0, -2, length + 12, 2)))) == 2


def test_an_outline_of_a_thousand_places_is_sewn_with_few(tmp_path):
    t = np.linspace(0, 2 * np.pi, 5000)
    ring = " ".join(f"{30 + 20 * np.cos(a):.6f},{30 + 20 * np.sin(a):.6f}" for a in t)
    piece = made(tmp_path, f'<polygon points="{ring}"/>', width=40)
    assert len(piece.regions[0].paths.coords) < 250
    assert np.hypot(*piece.regions[0].paths.coords.T) == pytest.approx(20, abs=0.02)


def test_a_stroke_that_is_hidden_for_the_most_part_is_one_with_its_fill(tmp_path):
    disc = '<circle cx="30" cy="30" r="20" fill="#b1cc33" stroke="#b1cc33" stroke-width="4"/>'
    arc = '<path d="M30 10A20 20 0 1 1 10 30" fill="none" stroke="#000" stroke-width="4"/>'
    assert [r.role for r in made(tmp_path, disc + arc, width=60).regions] == ["area", "line"]
    assert [r.role for r in made(tmp_path, disc, width=60).regions] == ["area"]  # one mass: no ridge that nobody drew


def test_a_line_that_a_fill_and_a_line_of_its_own_thread_hide_is_not_sewn(tmp_path):
    low = '<path d="M9 20H30" stroke="#000" stroke-width="2"/>'
    over = '<path d="M10 19H40V40H14Z" fill="green"/><path d="M7 12L15 43" stroke="#000" stroke-width="4"/>'
    assert [r.role for r in made(tmp_path, low + over, width=60).regions] == ["area", "line"]

"""Lines as satin columns: corners that are real, closed lines, and where lines of one thread meet."""

import math
from pathlib import Path

import numpy as np
import pytest
import shapely

from tambour import files
from tambour.core.progress import Progress
from tambour.core.thread import JUMP, STITCH, TRIM
from tambour.embroidery.columns import ends, stroke
from tambour.embroidery.columns.ends import ended
from tambour.embroidery.columns.satin import side_to_side
from tambour.embroidery.columns.stroke import closed, covered, from_stroke, trimmed
from tambour.embroidery.params import EmbroideryParams
from tambour.embroidery.piece import SATIN
from tambour.embroidery.plan.make import make


def area(column):
    quads = np.stack([column.left[:-1], column.left[1:], column.right[1:], column.right[:-1]], axis=1)
    return shapely.union_all(shapely.make_valid(shapely.polygons(quads)))


def made(tmp_path: Path, inner: str, **params):
    file = tmp_path / "a.svg"
    file.write_text(
        '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 60 60" width="60mm" height="60mm"><g fill="none" stroke="#000"'
        f' stroke-width="3" stroke-linecap="round" stroke-linejoin="round">{inner}</g></svg>'
    )
    return make(files.read(file, ("Drawing",)), EmbroideryParams(**params), Progress())


@pytest.mark.parametrize("jog", [0.0, 0.01, 0.3])
def test_a_jog_far_smaller_than_the_line_is_wide_is_no_corner(jog):
    line = np.array([(0, 0), (10, 0), (10, jog), (10.05, jog), (20, jog), (20, jog / 2)], float)
    (column,) = from_stroke(line, 3.0)
    assert np.ptp(column.middle[:, 0]) > 19.5


def test_a_step_as_large_as_the_line_is_wide_is_two_corners():
    line = np.array([(0, 0), (10, 0), (10, 3), (20, 3)], float)
    assert len(from_stroke(line, 3.0)) == 3


@pytest.mark.parametrize("first", [0, 1, 2])
def test_a_closed_line_is_parted_at_every_corner_wherever_it_begins(first):
    corners = np.roll(np.array([(0, 0), (0, 20), (17, 10)], float), first, axis=0)
    line = np.concatenate([corners, corners[:1]])
    columns = from_stroke(line, 2.0)
    assert len(columns) == 3 and closed(line, 2.0) and closed(np.r_[line, [line[-1] + 0.1]], 2.0)
    assert not closed(line[:-1], 2.0)
    lengths = sorted(float(np.hypot(*np.diff(c.middle, axis=0).T).sum()) for c in columns)
    assert lengths[0] > 18  # each a whole side, none bent round a corner


def angle(turn: float, leg: float = 26.0):
    t = math.radians(turn)
    return np.array([(-leg, 0), (0, 0), (leg * math.cos(t), leg * math.sin(t))])


@pytest.mark.parametrize("join", [0, 1])
@pytest.mark.parametrize("width", [3.0, 6.0, 9.0])
@pytest.mark.parametrize("turn", [80, 90, -120, 140])
def test_the_columns_of_a_corner_part_at_its_bisector(turn, width, join):
    line = angle(turn)
    one, other = from_stroke(line, width, join)
    drawn = shapely.LineString(line).buffer(width / 2, cap_style="flat", quad_segs=32)
    sewn = shapely.union(area(one), area(other))
    assert drawn.difference(sewn).buffer(-0.15).is_empty  # no bare spot of .3 mm
    if join == 0:
        assert sewn.difference(drawn.buffer(0.05)).area < 0.01
        for column in (one, other):
            assert covered(column).difference(area(column).buffer(0.05)).area < 0.02
    double = shapely.intersection(area(one), area(other)).area
    seam = width / 2 * (1 / math.cos(math.radians(turn / 2)) + 1)  # from the inner corner to the round outer one
    tip = 0.4 * width / 2  # the laps widen by 0.4 mm on the way to the outer corner
    assert double < 1.1 * (0.4 * seam + tip)


@pytest.mark.parametrize("width", [3.0, 6.0, 9.0])
@pytest.mark.parametrize("turn", [80, 90, -120])
def test_a_round_corner_has_no_nick_where_its_columns_meet_outside(turn, width):
    # The columns taper to nothing there: the needle points of both must reach as near to the tip as rows lie apart.
    line = angle(turn)
    made = [side_to_side(c, EmbroideryParams(pull=0), "corner").xy for c in from_stroke(line, width, 0)]
    out = -np.array([math.cos(math.radians(turn)) - 1, math.sin(math.radians(turn))])
    tip = width / 2 * out / np.hypot(*out)
    assert all(np.hypot(*(xy - tip).T).min() < 0.3 for xy in made)


@pytest.mark.parametrize("turn", [70, 100, -133])
def test_a_tight_round_turn_is_a_corner_with_its_outline_as_drawn(turn):
    # Legs of 20 mm, between them an arc of .55 half widths: no fan of stitches from one place, none outside, none bare.
    half, t = 4.0, math.radians(abs(turn))
    at = np.linspace(0, t, 7)
    arc = 0.55 * half * np.c_[np.sin(at), (1 - np.cos(at)) * np.sign(turn)]
    end = arc[-1] + 20 * np.array([math.cos(t), math.sin(t) * np.sign(turn)])
    line = np.concatenate([[(-20, 0)], arc, [end]])
    columns = from_stroke(line, 2 * half, 0)
    assert len(columns) == 2
    drawn = shapely.LineString(line).buffer(half, cap_style="flat", quad_segs=32)
    sewn = shapely.union_all([area(c) for c in columns])
    assert drawn.difference(sewn).buffer(-0.15).is_empty
    assert sewn.difference(drawn.buffer(0.1)).area < 0.02


@pytest.mark.parametrize("legs", [(26.0, 3.0), (3.0, 26.0)])
def test_a_leg_too_short_for_the_bisector_is_capped_and_nothing_is_bare(legs):
    line = angle(120) * np.array([[legs[0] / 26], [0], [legs[1] / 26]])
    drawn = shapely.LineString(line).buffer(3.0, cap_style="flat")
    assert drawn.difference(shapely.union_all([area(c) for c in from_stroke(line, 6.0, 0)])).buffer(-0.15).is_empty


@pytest.mark.parametrize("sweep", [60, 100, 150])
def test_a_leg_that_bends_back_across_the_bisector_leaves_no_tip_bare(sweep):
    t = np.radians(np.linspace(0, sweep, 150))
    bend = np.c_[-2 - 8 * np.sin(t), 8 * (1 - np.cos(t))][::-1]
    line = np.vstack([bend, angle(140)[1:]])
    drawn = shapely.LineString(line).buffer(1.5, cap_style="flat", quad_segs=32)
    sewn = shapely.union_all([area(c) for c in from_stroke(line, 3.0, 0)])
    assert drawn.difference(sewn).buffer(-0.15).is_empty


@pytest.mark.parametrize("turn", [76, 90])
def test_stitches_that_shorten_towards_a_bisector_reach_the_outer_side(turn):
    for column in from_stroke(angle(turn), 6.0, 0):
        at = side_to_side(column, EmbroideryParams(pull=0, pull_percent=0, jagged=0, row_spacing=0.33), "a").xy
        near = shapely.points(at[np.hypot(*at.T) < 6])
        rails = [shapely.distance(shapely.LineString(rail), near) for rail in (column.left, column.right)]
        assert len(near) > 10 and np.minimum(*rails).max() < 0.02


def test_what_a_column_surely_covers_lies_within_it():
    bend = np.c_[np.linspace(0, 20, 50), 3 * np.sin(np.linspace(0, 3, 50))]
    for cap in (0, 1, 2):
        (column,) = ended(from_stroke(bend, 2.4), 1.2, cap)
        assert covered(column).difference(area(column).buffer(0.05)).area < 0.02
        assert covered(column).area > 0.75 * area(column).area


def test_a_column_ends_below_the_one_that_hides_its_end():
    (across,) = from_stroke(np.array([(-10.0, 0), (10, 0)]), 4.0)
    (stem,) = ended(from_stroke(np.array([(0.0, 0), (0, 15)]), 3.0), 1.5, 0)
    cut = trimmed(stem, covered(across))
    assert cut is not None
    assert cut.middle[:, 1].min() == pytest.approx(2.0 - 0.4, abs=0.15)
    assert (area(stem) - area(cut)).difference(area(across).buffer(0.06)).area < 1e-6  # nothing seen is lost
    assert trimmed(across, covered(stem)) is not None
    assert trimmed(stem, shapely.box(-5, -5, 5, 30)) is None


def satin(piece):
    end = np.flatnonzero((piece.plan.command[1:] == STITCH) & (piece.kind[1:] == SATIN)) + 1
    return shapely.linestrings(np.stack([piece.plan.xy[end - 1], piece.plan.xy[end]], axis=1))


def most(piece) -> int:
    """The most satin stitches over any of many places about the middle."""
    lines = satin(piece)
    x, y = np.meshgrid(np.arange(24, 36, 0.7) - 30, np.arange(24, 36, 0.7) - 30)
    cells = shapely.points(x.ravel(), y.ravel()).__array__()
    tree = shapely.STRtree(lines)
    found = tree.query(shapely.buffer(cells, 0.6), predicate="intersects")[0]
    return int(np.bincount(found).max())


def test_lines_of_one_thread_that_meet_in_a_point_do_not_pile_up(tmp_path):
    spokes = [
        f'<path d="M30 30L{30 + 22 * math.cos(a):.3f} {30 + 22 * math.sin(a):.3f}"/>' for a in (0.1, 1.7, 3.2, 4.8)
    ]
    one = most(made(tmp_path, spokes[0]))
    assert most(made(tmp_path, "".join(spokes))) <= 3.4 * one  # of the four that lie there; at first it was all of them


def test_a_line_with_corners_is_one_thread_without_jumps(tmp_path):
    for width in ("1.6", "3", "5"):  # each with its own underlay, which ends here or there
        piece = made(tmp_path, f'<path stroke-width="{width}" d="M10 10L40 20L12 30L45 40L10 50"/>')
        sewn = piece.plan.command == STITCH
        first, last = np.flatnonzero(sewn)[[0, -1]]
        assert not np.isin(piece.plan.command[first:last], (JUMP, TRIM)).any()


@pytest.mark.parametrize("path", ["M10 10L50 50M50 12L10 48", "M10 50L30 12L50 50", "M10 30H50M30 30V50M12 12L30 30"])
def test_what_is_left_out_below_other_thread_is_not_seen(tmp_path, path, monkeypatch):
    line = f'<path stroke-width="4" d="{path}"/>'
    piece = made(tmp_path, line)
    thread = shapely.union_all(shapely.buffer(satin(piece), 0.32))
    strokes = shapely.union_all([shapely.LineString(p).buffer(2) for p in piece.regions[0].paths])
    assert strokes.buffer(-0.3).difference(thread).area < 0.02
    less = shapely.length(satin(piece)).sum()
    monkeypatch.setattr(stroke, "KEPT", 100.0)  # so far below that nothing is
    monkeypatch.setattr(ends, "HAIRPIN", 0.0)  # nor are corners parted
    assert less < 0.985 * shapely.length(satin(made(tmp_path, line))).sum()

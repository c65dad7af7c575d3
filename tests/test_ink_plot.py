"""The plotter: hidden lines against Shapely, routes against brute force, sheets that continue, files others read."""

from __future__ import annotations

import os
import re
import subprocess
import sys
import tomllib
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
import shapely

from tambour import files
from tambour.core.errors import TambourError
from tambour.core.progress import Progress
from tambour.ink.params import Ink
from tambour.ink.plan import scroll
from tambour.ink.plotter import job as plot
from tambour.ink.plotter.hand import contours, dabs, passes, pressed, zigzags
from tambour.ink.plotter.hidden import visible
from tambour.ink.plotter.layers import Layer, grey, pens, refilled
from tambour.ink.plotter.path import cut, simplified, strung, tour
from tambour.ink.plotter.redraw import hiding, lines
from tambour.run import run


def ends_of(sizes):
    return np.concatenate([[0], np.cumsum(sizes)]).astype(np.int64)


def stars(rng, count, points=19):
    """Simple polygons of uneven radius about random centres."""
    angle = np.sort(rng.uniform(0, 2 * np.pi, (count, points)), axis=1)
    far = rng.uniform(2, 12, (count, 1)) * rng.uniform(0.4, 1, (count, points))
    centre = rng.uniform(0, 220, (count, 1, 2))
    return (centre + far[..., None] * np.stack([np.cos(angle), np.sin(angle)], 2)).reshape(-1, 2)


def along(rng, coords, offsets, count):
    """Random points on lines, and the line of each."""
    step = np.hypot(*np.diff(coords, axis=0).T)
    step[offsets[1:-1] - 1] = 0
    segment = rng.choice(len(step), count, p=step / step.sum())
    t = rng.uniform(0, 1, count)[:, None]
    return coords[segment] * (1 - t) + coords[segment + 1] * t, np.searchsorted(offsets, segment, "right") - 1


def hidden_by(points, order, polygons, rank):
    """Whether each point lies in a polygon of higher rank, and how far it is from any such outline (Shapely)."""
    tree = shapely.STRtree(polygons)
    at = shapely.points(points)
    i, j = tree.query(at, "intersects")
    later = rank[j] > order[i]
    covered = np.zeros(len(points), bool)
    covered[i[later]] = True
    i, j = tree.query(at, "dwithin", distance=1e-6)
    edge = np.zeros(len(points), bool)
    close = shapely.distance(at[i], shapely.boundary(polygons[j])) < 1e-6
    close &= rank[j] > order[i]
    edge[i[close]] = True
    return covered, edge


@pytest.mark.slow
def test_hidden_lines_of_20000_points_agree_with_shapely():
    rng = np.random.default_rng(4)
    count = 1500
    outlines, rank = stars(rng, count), np.arange(count, dtype=np.int64)
    ends = ends_of([19] * count)
    polygons = shapely.polygons(outlines.reshape(count, 19, 2))
    rings = np.insert(outlines.reshape(count, 19, 2), 19, outlines.reshape(count, 19, 2)[:, 0], axis=1).reshape(-1, 2)
    offsets = ends_of([20] * count)
    coords, pieces, source = visible(rings, offsets, rank, outlines, ends, rank)
    # Nothing hidden is drawn.
    points, piece = along(rng, coords, pieces, 20_000)
    covered, edge = hidden_by(points, rank[source[piece]], polygons, rank)
    assert not (covered & ~edge).any()
    # Nothing visible is lost, and nothing is drawn that was not there.
    points, line = along(rng, rings, offsets, 20_000)
    covered, edge = hidden_by(points, rank[line], polygons, rank)
    drawn = [shapely.MultiLineString([]) for _ in range(count)]
    for k in range(count):
        mine = [coords[pieces[p] : pieces[p + 1]] for p in np.flatnonzero(source == k)]
        drawn[k] = shapely.MultiLineString(mine) if mine else drawn[k]
    away = shapely.distance(shapely.points(points), np.array(drawn)[line])
    seen = ~covered & ~edge
    assert seen.sum() > 3000 and (away[seen] < 1e-7).all()
    assert not (away[covered & ~edge] < 1e-9).any()


@pytest.fixture(scope="module")
def tile():
    return scroll.make(None, Ink(seed="7", span=512), Progress()).marks()


def winding(points, ring):
    a, b = ring, np.roll(ring, -1, axis=0)
    x, y = points[:, None, 0], points[:, None, 1]
    up, down = (a[:, 1] <= y) & (b[:, 1] > y), (a[:, 1] > y) & (b[:, 1] <= y)
    side = (b[:, 0] - a[:, 0]) * (y - a[:, 1]) - (x - a[:, 0]) * (b[:, 1] - a[:, 1])
    return (up & (side > 0)).sum(1) - (down & (side < 0)).sum(1)


@pytest.mark.slow
def test_hidden_lines_of_a_tile_agree_with_brute_force(tile):
    rng = np.random.default_rng(5)
    drawn = lines(tile, 1.1)
    outlines, ends, opaque = hiding(tile, 1.1)
    coords, pieces, source = visible(drawn.coords, drawn.offsets, drawn.order, outlines, ends, opaque)
    points, piece = along(rng, coords, pieces, 20_000)
    order = drawn.order[source[piece]]
    wrong = np.zeros(len(points), bool)
    for k, at in enumerate(opaque):
        ring = outlines[ends[k] : ends[k + 1]]
        near = np.flatnonzero((order < at) & ((points > ring.min(0)) & (points < ring.max(0))).all(1))
        if len(near):
            inside = winding(points[near], ring) != 0
            edge = shapely.LinearRing(ring)
            wrong[near] |= inside & (shapely.distance(shapely.points(points[near]), edge) > 1e-7)
    assert not wrong.any()
    # What is left and what is lost make the whole.
    shown = np.bincount(source, np.add.reduceat(np.r_[steps(coords, pieces), 0], pieces[:-1]), len(drawn.order))
    whole = np.add.reduceat(np.r_[steps(drawn.coords, drawn.offsets), 0], drawn.offsets[:-1])
    assert (shown <= whole + 1e-6).all() and 0.2 < shown.sum() / whole.sum() < 1


def steps(coords, offsets):
    step = np.hypot(*np.diff(coords, axis=0).T)
    step[offsets[1:-1] - 1] = 0
    return step


def test_a_hatch_covers_what_its_tone_asks():
    from tambour.ink.plotter.hatch import hatched

    square = np.array([(0.0, 0), (100, 0), (100, 100), (0, 100)])
    for level in (0.0, 1.0, 3.0):
        segments, _ = hatched(square, np.array([0, 4]), 1.0, np.array([level]), 0.7)
        length = np.hypot(segments[:, 2] - segments[:, 0], segments[:, 3] - segments[:, 1]).sum()
        assert length * 2**level == pytest.approx(10_000, rel=0.06)


def ribbon(width, n=41, long=100.0):
    """A stroke's outline as the press leaves it, of half a sine's breadth."""
    t = np.linspace(0, 1, n)
    half = 0.5 * width * np.sin(np.pi * t)
    there, back = np.stack([long * t, half], 1), np.stack([long * t, -half], 1)
    return np.concatenate([there, back[-2::-1]])


@pytest.mark.parametrize(("width", "passed"), [(0.4, 1), (1.0, 1), (3.0, 3), (5.0, 5)])
def test_a_black_stroke_is_as_many_passes_in_one_line_as_it_is_wide(width, passed):
    outline = ribbon(width)
    one = np.array([1.0])
    coords, ends, source = passes(outline, np.array([0, len(outline)]), one, 0.5 * one, 1.0)
    assert source.tolist() == [0] and len(ends) == 2
    # In the middle every pass crosses once, side by side; towards the ends there are fewer.
    x, y = coords.T
    across = [y[i] for i in range(len(x) - 1) if min(x[i], x[i + 1]) < 51.0 < max(x[i], x[i + 1])]
    assert len(across) == passed
    assert np.allclose(np.diff(np.sort(across)), 0.85, atol=0.1)
    assert (np.abs(y) <= max(0.0, width / 2 - 0.5) + 1e-9).all()
    assert len([i for i in range(len(x) - 1) if min(x[i], x[i + 1]) < 3.0 < max(x[i], x[i + 1])]) <= 2


def test_a_wash_is_lines_apart():
    outline = ribbon(20.0)
    coords, ends, _ = passes(outline, np.array([0, len(outline)]), np.array([0.2]), np.array([0.5]), 1.0)
    middles = np.sort([coords[a:b, 1][(b - a) // 2] for a, b in pairwise(ends)])
    assert len(middles) > 2 and np.diff(middles).min() > 2.0


def test_a_pen_that_swells_is_lowered_by_the_breadth():
    outline = ribbon(3.2)
    coords, ends, source, press = pressed(outline, np.array([0, len(outline)]), np.array([1.0]), 1.0, 3)
    assert press.tolist() == [0, 1, 2, 1, 0] and set(source.tolist()) == {0}
    # The pieces follow one another without a gap.
    assert (coords[ends[1:-1]] == coords[ends[1:-1] - 1]).all()
    assert steps(coords, ends).sum() == pytest.approx(100.0)


def facets(tone, columns=40, rows=8, high=80.0):
    """A far range of even facets under a level crest, as the element draws it; their tones."""
    quads = []
    for i in range(columns):
        for r in range(rows):
            a, b, top, low = 10.0 * i, 10.0 * (i + 1), high * r / rows, high * (r + 1) / rows
            quads.append([(a, top), (b, top), (b, low), (a, low), (a, top)])
    return np.array(quads, float).reshape(-1, 2), ends_of([5] * columns * rows), np.tile(tone, columns)


def test_a_far_range_is_lines_along_its_crest_the_closer_the_darker():
    rows = []
    for dark in (0.1, 0.2):
        coords, ends, tone = facets(np.full(8, dark))
        out, offsets, number = contours(coords, ends, tone, 1.0)
        level = [out[a:b, 1].mean() for a, b in pairwise(offsets)]
        assert number.tolist() == list(range(len(number))) and level[0] == 0.0
        assert np.allclose(np.diff(level), 1.0 / dark)
        rows.append(len(level))
    assert rows[1] > 1.8 * rows[0]
    # Paler towards the foot: the lines lie further apart there.
    coords, ends, tone = facets(np.linspace(0.3, 0.05, 8))
    out, offsets, _ = contours(coords, ends, tone, 1.0)
    apart = np.diff([out[a:b, 1].mean() for a, b in pairwise(offsets)])
    assert apart[-1] > 2 * apart[0]


def test_touches_that_follow_one_another_are_one_line():
    axes = np.array([[(0.0, 0), (10, 0)], [(0, -3), (8, -3)], [(90, 0), (99, 0)]])
    wide, turns, groups = np.full(3, 3.0), np.array([2, 1, 1]), np.array([0, 3])
    _, ends, source = dabs(axes, wide, turns, groups, 1.0, 20.0)
    assert len(ends) == 3 and source.tolist() == [0, 0]
    coords, ends, _ = zigzags(axes[:2], wide[:2], np.array([3, 3]), np.array([0, 2]), 20.0, 0.0)
    assert (
        len(ends) == 2 and (np.diff(coords[:, 1]) <= 0).all() and (np.diff(np.sign(np.diff(coords[:, 0]))) != 0).all()
    )


def test_a_pen_is_filled_again_between_two_lines():
    coords = np.array([(0.0, 0), (30, 0), (0, 1), (30, 1), (0, 2), (100, 2), (0, 3), (30, 3)])
    layer = Layer(coords, np.array([0, 2, 4, 6, 8]), pause=True)
    pieces, drawn = refilled(layer, 70.0, 0.0)
    assert [p.down for p in pieces] == [60.0, 100.0, 30.0] and drawn == 30.0
    assert all(p.pause for p in pieces) and (np.concatenate([p.coords for p in pieces]) == coords).all()
    # What was drawn at another height counts; a pen that is dry is filled first, and an endless one never.
    pieces, _ = refilled(Layer(coords, layer.offsets), 70.0, 60.0)
    assert [p.down for p in pieces] == [30.0 + 30.0, 100.0, 30.0] and pieces[0].pause
    assert refilled(layer, 0.0, 60.0) == ([layer], 250.0)


def walk(rng, count=300, size=12):
    starts = rng.uniform(0, 100, (count, 1, 2))
    return (starts + np.cumsum(rng.normal(0, 2, (count, size, 2)), 1)).reshape(-1, 2), ends_of([size] * count)


def test_cutting_keeps_what_lies_within():
    coords, offsets = walk(np.random.default_rng(1))
    box = shapely.box(20, 10, 70, 80)
    out, ends, source = cut(coords, offsets, 20.0, 10.0, 70.0, 80.0)
    whole = shapely.MultiLineString([coords[a:b] for a, b in pairwise(offsets)])
    assert steps(out, ends).sum() == pytest.approx(sum(shapely.length(shapely.intersection(whole.geoms, box))))
    assert (out >= (20 - 1e-9, 10 - 1e-9)).all() and (out <= (70 + 1e-9, 80 + 1e-9)).all()
    assert (np.diff(source) >= 0).all()


def test_simplified_lines_stay_within_the_tolerance():
    coords, offsets = walk(np.random.default_rng(2))
    out, ends = simplified(coords, offsets, 0.5)
    assert len(out) < len(coords)
    for k in range(len(offsets) - 1):
        left = shapely.LineString(out[ends[k] : ends[k + 1]])
        mine = coords[offsets[k] : offsets[k + 1]]
        assert (shapely.distance(shapely.points(mine), left) <= 0.5 + 1e-9).all()
        assert (out[ends[k]] == mine[0]).all() and (out[ends[k + 1] - 1] == mine[-1]).all()


def test_the_tour_goes_to_the_nearest_end():
    coords, offsets = walk(np.random.default_rng(3))
    heads, tails = coords[offsets[:-1]], coords[offsets[1:] - 1]
    order, turned = tour(heads, tails, -5.0, 3.0)
    assert sorted(order) == list(range(len(heads)))
    at, left = np.array([-5.0, 3.0]), np.ones(len(heads), bool)
    for i, back in zip(order, turned):
        away = np.minimum(*(np.hypot(*(ends - at).T) for ends in (heads, tails)))
        mine = np.hypot(*((tails if back else heads)[i] - at))
        assert mine == pytest.approx(away[left].min())
        left[i], at = False, (heads if back else tails)[i]
    out, ends = strung(coords, offsets, order, turned, 0.0, -5.0, 3.0)
    assert steps(out, ends).sum() == pytest.approx(steps(coords, offsets).sum())


def test_a_closed_line_begins_at_the_pen_and_touching_lines_become_one():
    square = np.array([(1.0, 1), (9, 1), (9, 9), (1, 9), (1, 1), (9, 9), (15, 9)])
    offsets = np.array([0, 5, 7])
    out, ends = strung(square, offsets, np.array([0, 1]), np.zeros(2, bool), 0.1, 10.0, 10.0)
    assert out[0].tolist() == [9, 9] and len(ends) == 2 and out[-1].tolist() == [15, 9]


def made(**told):
    return plot.make(None, Ink.of({"plotter": True, "seed": "7", **told}), Progress())


@pytest.fixture(scope="module")
def booklet():
    return made(sheets="0..1", pens=2, from_=-5200.0)


@pytest.mark.parametrize("first", [3, -5])
@pytest.mark.slow
def test_sheets_made_alone_continue_line_for_line(first):
    left, right = (made(sheets=str(k), pens=2, page="a5", margin="8mm") for k in (first, first + 1))
    sheet, seam, met = left.sheets[0], left.sheets[0].box[2], 0
    drawn = plot.unhidden(left.scroll, left.scroll.params.nib / sheet.scale)
    points = (drawn.coords - (sheet.x, sheet.y)) * sheet.scale + (sheet.left, sheet.top)
    for one, other in zip(left.pages[0], right.pages[0]):
        a, b = one.coords[one.coords[:, 0] == seam, 1], other.coords[other.coords[:, 0] == 8.0, 1]
        for here, there in ((a, b), (b, a)):
            for y in here:
                # To the file's thousandths; within the tolerance a line may end or turn, with nothing on the other side.
                met += np.abs(there - y).min() < 2e-3
                assert np.abs(there - y).min() < 2e-3 or np.abs(points - (seam, y)).max(1).min() < plot.TOLERANCE
    assert met > 100


@pytest.mark.parametrize("page", ["a3", "letter", "300x100mm"])
def test_a_window_of_no_said_length_fills_its_sheet(page):
    from tambour.ink.plan.wholes import HEIGHT
    from tambour.ink.plotter.sheet import inner, laid, windowed

    params = windowed(Ink(plotter=True, page=page), HEIGHT)
    (sheet,) = laid(params, params.from_, 0.0, params.span, HEIGHT)
    width, height = inner(params)
    left, top, right, bottom = sheet.box
    assert (right - left, bottom - top) == pytest.approx((width, height))
    for said in (Ink(plotter=True, page=page, span=3000), Ink(plotter=True, page=page, specimen="pine")):
        assert windowed(said, HEIGHT) is said


@pytest.mark.slow
def test_a_sheet_alone_is_the_sheet_of_the_booklet(booklet):
    alone = made(sheets="1", pens=2, from_=-5200.0)
    for a, b in zip(alone.pages[0], booklet.pages[1]):
        assert a.lifts == b.lifts and a.coords == pytest.approx(b.coords, abs=1e-6)


def test_all_stays_on_the_page_and_pens_share_by_tone(booklet):
    for page in booklet.pages:
        for pen in page:
            assert pen.lifts and (pen.coords >= 10 - 1e-9).all() and (pen.coords <= (287 + 1e-9, 200 + 1e-9)).all()
    assert pens(np.array([0.02, 0.33, 0.34, 0.67, 1.0]), 3).tolist() == [0, 0, 1, 2, 2]
    # The palest is drawn first, and shown paler.
    assert grey(0, 3) > grey(1, 3) > grey(2, 3) == 0


def test_the_budget_is_kept_and_what_matters_stays():
    full, less = made(span=1900, from_=900.0), made(span=1900, from_=900.0, budget="6min")
    assert plot.facts(full)["minutes"] > 9
    assert 5 < plot.facts(less)["minutes"] <= 6 and less.thinned > 0
    report = plot.facts(less)["pens"][0]
    assert report["lifts"] < plot.facts(full)["pens"][0]["lifts"]


@pytest.mark.slow
def test_layers_are_numbered_and_other_software_agrees(tmp_path):
    vpype = pytest.importorskip("vpype")
    out = tmp_path / "a.svg"
    report = run("ink", None, Ink(plotter=True, seed="31", from_=700, span=700, pens=2, frame=True), [out])
    labels = re.findall(r'inkscape:groupmode="layer" inkscape:label="([^"]*)"', out.read_text())
    assert [name[:2] for name in labels] == ["1 ", "!2", "% "]
    document = vpype.read_multilayer_svg(str(out), 0.01)
    assert document.page_size == pytest.approx((297 * 96 / 25.4, 210 * 96 / 25.4))
    for pen in report["pens"]:
        layer = document.layers[pen["pen"]]
        assert layer.length() * 25.4 / 96 / 1000 == pytest.approx(pen["down_m"], rel=0.002)
        assert layer.pen_up_length()[0] * 25.4 / 96 / 1000 == pytest.approx(pen["up_m"], rel=0.002)
        assert len(layer) == pen["lifts"]


def test_layers_tell_the_axidraw_when_to_wait_and_how_to_hold_the_pen(tmp_path):
    out = tmp_path / "a.svg"
    told = {"seed": "31", "from_": 700, "span": 600, "pens": 2, "swell": 2, "heights": "60..20", "refill": "5m"}
    report = run("ink", None, Ink.of({"plotter": True, **told}), [out])
    labels = re.findall(r'inkscape:groupmode="layer" inkscape:label="([^"]*)"', out.read_text())
    codes = [re.match(r"(!?)(\d+)\+H(\d+)\+S(\d+) pen (\d) ", label) for label in labels]
    assert [int(c[2]) for c in codes] == list(range(1, len(labels) + 1))
    assert {(c[3], c[4]) for c in codes} == {("60", "25"), ("20", "12")}
    # Waits for the second pen, and whenever five metres are drawn.
    first = next(i for i, c in enumerate(codes) if c[5] == "2")
    assert codes[first][1] == "!" and not codes[0][1] and sum(c[1] == "!" for c in codes) == report["pauses"]
    assert report["pauses"] >= 1 + sum(int(pen["down_m"] / 5) for pen in report["pens"])
    page = made(**told).pages[0]
    assert all(layer.down <= 5000 for layer in page)


@pytest.mark.slow
def test_vpype_draws_the_scroll_by_itself(tmp_path):
    vpype = pytest.importorskip("vpype")
    root = Path(__file__).parents[1]
    entry = tomllib.loads((root / "pyproject.toml").read_text())["project"]["entry-points"]["vpype.plugins"]
    info = tmp_path / "tambour_plugin-0.dist-info"
    info.mkdir()
    (info / "METADATA").write_text("Metadata-Version: 2.1\nName: tambour-plugin\nVersion: 0\n")
    lines_ = "".join(f"{name} = {place}\n" for name, place in entry.items())
    (info / "entry_points.txt").write_text(f"[vpype.plugins]\n{lines_}")
    out = tmp_path / "v.svg"
    words = ["tambour-ink", "--seed", "7", "--span", "500", "--pens", "2", "linesort", "write", str(out)]
    paths = os.pathsep.join([str(tmp_path), str(root / "src")])
    call = [sys.executable, "-c", "from vpype_cli import cli; cli()"]
    environment = {**os.environ, "PYTHONPATH": paths}
    done = subprocess.run([*call, *words], env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    document, wanted = vpype.read_multilayer_svg(str(out), 0.01), made(span=500, pens=2)
    assert document.page_size == pytest.approx((297 * 96 / 25.4, 210 * 96 / 25.4), rel=1e-4)
    for k, pen in enumerate(wanted.pages[0], 1):
        assert document.layers[k].length() * 25.4 / 96 == pytest.approx(pen.down, rel=0.002)
    done = subprocess.run([*call, "tambour-ink", "--page", "a9"], env=environment, capture_output=True, text=True)
    assert done.returncode and "there is no page" in done.stderr


def test_hpgl_holds_the_same_lines(tmp_path):
    made_ = made(span=700, frame=True)
    drawing = plot.whole(made_)
    files.write(drawing, tmp_path / "a.hpgl")
    text = (tmp_path / "a.hpgl").read_text()
    assert text.startswith("IN;") and set(re.findall(r"SP\d", text)) == {"SP0", "SP1"}
    way = [np.array(re.findall(r"-?\d+", line), float).reshape(-1, 2) for line in text.split("\n") if "PD" in line]
    (pen,) = made_.pages[0]
    assert len(way) == pen.lifts
    got = np.concatenate(way) / 40
    assert np.abs(got[:, 0] - pen.coords[:, 0]).max() <= 0.0126
    assert np.abs(210 - got[:, 1] - pen.coords[:, 1]).max() <= 0.0126


def test_a_booklet_is_a_file_each(booklet, tmp_path):
    for suffix in (".svg", ".plt"):
        files.write(plot.whole(booklet), tmp_path / f"a{suffix}", "Drawing")
        assert {p.name for p in tmp_path.glob(f"*{suffix}")} == {f"a-1{suffix}", f"a-2{suffix}"}


def test_a_plotter_that_does_not_reach_is_said():
    for told, warned in (({"model": "v3"}, 0), ({"model": "v3", "page": "a3"}, 1), ({"page": "a3"}, 0)):
        progress = Progress()
        plot.make(None, Ink(plotter=True, specimen="rock", **told), progress)
        assert len(progress.warnings) == warned


@pytest.mark.parametrize(
    ("told", "word"),
    [
        ({"page": "a9"}, "there is no page"),
        ({"page": "1x1mm"}, "not between"),
        ({"margin": 105}, "leaves nothing"),
        ({"heights": "50"}, "no pair of heights"),
        ({"heights": "30..50"}, "the pressed pen is the lower"),
        ({"sheets": "9..0"}, "the first sheet comes first"),
        ({"sheets": "many"}, "does not number sheets"),
        ({"sheets": "0", "plotter": False}, "--plotter"),
        ({"sheets": "0", "specimen": "rock"}, "one sheet"),
    ],
)
def test_what_cannot_be_plotted_is_said(told, word):
    with pytest.raises(TambourError, match=word):
        Ink.of({"plotter": True, **told})


def test_hpgl_without_plotter_is_said(tmp_path):
    with pytest.raises(TambourError, match="--plotter"):
        run("ink", None, Ink(seed="7", span=100), [tmp_path / "a.hpgl"])


def test_the_same_lines_every_time():
    a, b = made(span=400), made(span=400)
    assert (a.pages[0][0].coords == b.pages[0][0].coords).all()

"""Promises that docstrings make, each held against a law of its own: written after faults planted there had lived."""

from __future__ import annotations

import math
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
import shapely
from hypothesis import example, given
from hypothesis import strategies as st

from tambour import files
from tambour.color import family, nearest_distinct, oklab
from tambour.core.chart import Chart
from tambour.core.errors import Span, TambourError, Text
from tambour.core.palette import Palette
from tambour.core.paths import Paths
from tambour.core.progress import Progress
from tambour.core.thread import END, STITCH, TRIM
from tambour.crochet.finish.placing import Frames
from tambour.crochet.finish.sewing import End, ways
from tambour.crochet.graph.build import build
from tambour.crochet.graph.check import size_edit, tech_edit
from tambour.crochet.language.finishes import Placed, Spot
from tambour.crochet.language.parse import parse
from tambour.crochet.maker.gauge import gauge
from tambour.crochet.page import flow as page_flow
from tambour.crochet.page.symbols import strokes
from tambour.crochet.params import CrochetParams
from tambour.crochet.printed.heads import heads
from tambour.crochet.printed.pattern import read_printed
from tambour.crochet.printed.tokens import rows
from tambour.crochet.printed.wordings.vocabulary import vocabulary
from tambour.crochet.yarns import SQUARE, WEIGHTS, class_of, swatch_of
from tambour.embroidery import CRAFT as EMBROIDERY
from tambour.embroidery.columns.stroke import from_stroke
from tambour.embroidery.params import EmbroideryParams
from tambour.embroidery.piece import LOCK, Region
from tambour.embroidery.plan.facts import outside
from tambour.embroidery.plan.order import order
from tambour.files import exp
from tambour.files.records import Records
from tambour.files.svg import css
from tambour.files.svg.path import fitted
from tambour.files.svg.read import read_drawing
from tambour.geometry.surface import face_normals
from tambour.ink.params import Ink
from tambour.ink.plotter.sheet import TRAVEL, reach
from tambour.knit.hands.yarn import amounts
from tambour.knit.params import KnitParams
from tambour.knit.solve.floats import limit_of
from tambour.render import light
from tambour.render.camera import look
from tambour.render.page import PAPERS

# -- embroidery ---------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("degrees", [-120, -90, 80, 90, 130])
def test_columns_meet_along_the_bisector_of_their_corner(degrees):
    half, turn = 1.0, math.radians(degrees)
    leg = np.linspace(0, 20, 41)
    line = np.concatenate([np.c_[leg - 20, 0 * leg], np.c_[leg[1:] * math.cos(turn), leg[1:] * math.sin(turn)]])
    first, second = from_stroke(line, 2 * half)
    if abs(degrees) > 105:
        # Too sharp for a mitre: both columns end on the bisector, at the round corner, and leave no cloth bare about it.
        out = np.array([1 - math.cos(turn), -math.sin(turn)]) / math.hypot(1 - math.cos(turn), math.sin(turn))
        for end in ((first.left[-1] + first.right[-1]) / 2, (second.left[0] + second.right[0]) / 2):
            assert abs(end[0] * out[1] - end[1] * out[0]) < 0.1 and 0.75 * half < end @ out <= half
        # Rails are needle points: thread reaches half its width, 0.2 mm, beyond them.
        sewn = shapely.union_all(
            [shapely.Polygon(np.concatenate([c.left, c.right[::-1]])).buffer(0) for c in (first, second)]
        )
        assert sewn.buffer(0.15).contains(shapely.Point(0, 0).buffer(0.95 * half))
        return
    # Both sides of a mitre lie on the bisector: as far along it as half the width allows, and no further than 1.2.
    far = min(1 / abs(math.cos(turn / 2)), math.hypot(1, 1.2)) * half
    bisector = np.array([-math.sin(turn / 2), math.cos(turn / 2)])
    for side, sign in (("left", 1), ("right", -1)):
        one, other = getattr(first, side)[-1], getattr(second, side)[0]
        assert np.allclose(one, other, atol=0.06), side
        assert np.allclose(one, sign * far * bisector, atol=0.06), side
    inner = "left" if turn > 0 else "right"
    assert getattr(first, inner)[-1][0] < -0.5 * half  # the inner side is the shorter one


@pytest.mark.parametrize("radius", [0.7, 1.0, 3.0, 8.0])
def test_in_a_bend_the_inner_points_stay_at_its_centre(radius):
    half = 1.5
    angle = np.linspace(0, math.pi, 200)
    bend = np.c_[radius * np.sin(angle), radius * (1 - np.cos(angle))]  # turns left about (0, radius)
    before = np.c_[np.linspace(-6, 0, 30)[:-1], np.zeros(29)]
    (column,) = from_stroke(np.concatenate([before, bend]), 2 * half)
    on = (column.middle[:, 0] > 0.5 * radius) if radius > half else (column.right[:, 0] > 0.8 * (radius + half))
    inner = np.hypot(*(column.left[on] - (0, radius)).T)
    outer = np.hypot(*(column.right[on] - (0, radius)).T)
    wide = np.hypot(*(column.left[on] - column.right[on]).T)
    if radius < half:
        assert (wide < half + 1.15 * radius).all() and (wide > half + 0.6 * radius).all()
        assert (inner < 0.35 * half).all()
    else:
        assert np.allclose(inner, max(0.0, radius - half), atol=0.12) and np.allclose(outer, radius + half, atol=0.12)


def _square(x, y, color, size=10.0):
    ring = np.array([(x, y), (x + size, y), (x + size, y + size), (x, y + size), (x, y)], float)
    paths = Paths(ring, np.array([0, 5]), np.array([0, 1]))
    return Region("", paths, "tatami", color, EmbroideryParams())


RED, BLUE = (200, 0, 0), (0, 0, 200)


def test_what_overlaps_in_one_colour_is_sewn_in_the_order_of_the_file():
    # The last is nearest to where the hoop begins, and would be taken first if the order did not matter.
    far, near = _square(30, 30, RED, 20.0), _square(22, 22, RED, 20.0)
    assert order([far, near], "auto") == [0, 1]
    assert order([near, far], "auto") == [0, 1]
    apart = [_square(60, 60, RED), _square(2, 2, RED)]
    assert order(apart, "auto") == [1, 0]  # what does not overlap goes the short way
    assert order([_square(0, 0, RED), _square(5, 5, BLUE), _square(8, 8, RED)], "auto") == [0, 1, 2]
    assert order([_square(0, 0, RED), _square(50, 0, BLUE), _square(90, 0, RED)], "auto") == [0, 2, 1]


def test_stitches_outside_their_region_are_counted(tmp_path):
    path = tmp_path / "square.svg"
    path.write_text(
        '<svg xmlns="http://www.w3.org/2000/svg" width="40mm" height="40mm" viewBox="0 0 40 40">'
        '<path id="a" fill="#a22" d="M5 5h30v30h-30z"/></svg>'
    )
    params = EmbroideryParams(underlay="none", pull=0, locks=False)
    piece = EMBROIDERY.make(read_drawing(path), params, Progress())
    edge = np.abs(piece.plan.xy).max()
    assert edge == pytest.approx(15.0, abs=0.1) and len(outside(piece)) == 0
    inner = np.flatnonzero((piece.plan.command == STITCH) & (np.abs(piece.plan.xy).max(1) < 10))[50]
    for reach_of, count in ((0.03, 0), (0.4, 2), (2.0, 2)):  # 0.05 mm, and half of the least stitch, are borne
        xy = piece.plan.xy.copy()
        xy[inner] = (15.0 + reach_of, xy[inner, 1])
        assert len(outside(replace(piece, plan=replace(piece.plan, xy=xy)))) == count, reach_of


# -- machine files, units, plotters ---------------------------------------------------------------------------------


def test_exp_writes_the_bytes_that_machines_know():
    xy = np.array([(10, 0), (10, 0), (10, 5), (10, 5)])
    made = exp.encode(Records(xy, np.array([STITCH, TRIM, STITCH, END], np.uint8), np.zeros(4, np.int16)))
    assert made == bytes([10, 0, 0x80, 0x80, 0x07, 0x00, 0, 0xFB])  # a trim is 80 80 07 00; y up is positive


@pytest.mark.parametrize(
    ("said", "mm"), [("72pt", 25.4), ("1in", 25.4), ('2"', 50.8), ("2.5cm", 25.0), ("0.1m", 100.0), ("3mm", 3.0)]
)
def test_units_of_length(said, mm):
    assert CrochetParams(stitch_width=said).stitch_width == pytest.approx(mm, rel=1e-12)


@pytest.mark.parametrize(("said", "seconds"), [("90s", 90.0), ("20min", 1200.0), ("3h", 10800.0)])
def test_units_of_time(said, seconds):
    assert Ink(plotter=True, budget=said).budget == seconds


@pytest.mark.parametrize("name", TRAVEL)
def test_a_plotter_is_held_to_its_width_and_to_its_height(name):
    wide, high = TRAVEL[name]
    for page, short in (
        (f"{wide}x{high}mm", False),
        (f"{wide + 30}x{high}mm", True),
        (f"{max(wide, high + 30)}x{high + 30}mm", True),
    ):
        progress = Progress()
        reach(Ink(plotter=True, page=page, margin=10, model=name), progress)
        assert bool(progress.warnings) is short, page


# -- crochet --------------------------------------------------------------------------------------------------------


def told(text):
    return [p.message for p in tech_edit(build(parse(Text(text))))]


def test_a_round_that_ends_in_a_slip_stitch_may_leave_stitches():
    begin = ": MR(6)\n: 6 inc\n: [sc, inc] x 6\n"
    assert not any("unworked" in m for m in told(begin + ": 9 sc, slst\n: 10 sc\n"))
    assert any("leaves 8 of the 18" in m for m in told(begin + ": 10 sc\n: 10 sc\n"))


def test_the_largest_of_several_stated_sizes_is_the_one_that_counts():
    def found(words, size):
        pattern = replace(build(parse(Text(": MR(6)\n"))).pattern, stated={"size": (words, Span(0, 1))})
        return size_edit(SimpleNamespace(pattern=pattern), size)

    assert not found("10 cm tall, 4 cm wide", (70.0, 101.0, 65.0))
    (wrong,) = found("10 cm tall, 4 cm wide", (40.0, 60.0, 40.0))
    assert "says 10.0 cm" in wrong.message
    assert not found("10 cm tall", (40.0, 85.0, 40.0)) and found("10 cm tall", (40.0, 78.0, 40.0))  # a fifth is near
    (wrong,) = found("4 cm wide, 10 cm tall", (40.0, 60.0, 40.0))
    assert "says 10.0 cm" in wrong.message


@given(
    st.lists(st.tuples(st.integers(3, 60), st.integers(0, 9), st.booleans()), min_size=1, max_size=30),
    st.integers(80, 250),
)
@example([(40, 0, False), (40, 0, False)], 82)
@example([(40, 2, True), (40, 2, False)], 82)
def test_columns_of_the_booklet_hold_what_stands_in_them(sizes, room):
    chunks = [
        page_flow.Chunk([page_flow.Atom(float(h), lambda *a: None, float(above))], "t", first)
        for h, above, first in sizes
    ]
    columns = page_flow._pack(chunks, float(room))
    assert [c for column in columns for c in column] == chunks
    for column in columns:
        again = 0.0 if column[0].first else page_flow.AGAIN
        assert again + column[0].height + sum(c.above + c.height for c in column[1:]) <= room + 1e-9


@given(st.integers(-360, 360))
def test_a_ring_is_turned_counter_clockwise_as_one_looks_at_its_place(degrees):
    # A place on the front of the toy: out of it is +z, right +x, up +y; at 0 the front looks down.
    frame = Frames(np.zeros((1, 3)), *(np.array([v], float) for v in ((0, 0, 1), (1, 0, 0), (0, 1, 0))))
    placed = Placed("a", Spot("b", 1.0, None), across=float(degrees))
    axis, front = ways(placed, End(np.arange(6), True, np.zeros((0, 2), int)), frame)
    a = math.radians(degrees)
    assert np.allclose(axis, (0, 0, 1)) and np.allclose(front, (math.sin(a), -math.cos(a), 0), atol=1e-12)


def test_the_shopping_list_holds_yarn_for_sewing_on():
    from tambour.crochet.maker.materials import SPARE, lengths, materials
    from tambour.crochet.plush import make

    two = "== a ==\n: MR(6)\n: 6 inc\n: 12 sc\n: 6 dec\nFO\n== b ==\n: MR(6)\n: 6 sc\nplace(b, a, round=2)\n"
    piece = make(Text(two), CrochetParams(tolerance=0.2), Progress())
    needed = materials(piece)
    bought = sum(y["metres"] for y in needed["yarn"])
    kind = WEIGHTS[piece.gauge.weight]
    for colour in needed["yarn"]:
        assert colour["grams"] == pytest.approx(colour["metres"] / kind.metres * 100, abs=0.06)
        assert colour["skeins"] == math.ceil(colour["grams"] / kind.skein)
    assert bought == pytest.approx((sum(lengths(piece).values()) + 0.3) * SPARE, abs=0.06)  # one tail of 30 cm
    long = ": MR(6)\n: 6 inc\n: 12 inc\n" + ": 24 sc\n" * 80
    (much,) = materials(make(Text(long), CrochetParams(yarn="super-bulky", solver="none"), Progress()))["yarn"]
    assert much["skeins"] == math.ceil(much["grams"] / WEIGHTS["super-bulky"].skein) > 1


def test_the_width_of_a_stitch_is_that_of_the_gauge():
    # Rows are 4 mm high, stitches 5 mm wide: only edges along the yarn tell the width.
    graph = build(parse(Text(": MR(6)\n: 6 inc\n: 12 sc\n: 12 sc\n")), stitch=(5.0, 4.0)).graph
    assert graph.stitch_width == pytest.approx(5.0, rel=0.02)


@pytest.mark.parametrize(("number", "is_one"), [(7, True), (100_000, True), (100_001, False), (4_000_000_000, False)])
def test_numbers_of_rounds_have_a_bound(number, is_one):
    tokens = vocabulary("us").read(rows(f"Rnd {number}: 6 sc in magic ring (6)")[0].tokens)
    assert bool(heads(tokens)) is is_one


# -- colour and light -----------------------------------------------------------------------------------------------


@given(st.lists(st.tuples(*[st.integers(0, 255)] * 3), min_size=1, max_size=6), st.integers(0, 255))
def test_the_nearest_distinct_counts_hue_double_and_lightness_half(colors, seed):
    palette = np.random.default_rng(seed).integers(0, 256, (7, 3)).astype(np.uint8)
    rgb = np.array(colors, np.uint8)
    free = set(range(len(palette)))
    known: dict[tuple[int, ...], int] = {}
    for color, chosen in zip(rgb, nearest_distinct(rgb, palette).tolist()):
        if tuple(color.tolist()) in known:
            assert chosen == known[tuple(color.tolist())]  # one colour stays one
            continue
        known[tuple(color.tolist())] = chosen
        (light_, a, b), cost = oklab(color[None])[0], {}
        for k in free:
            lk, ak, bk = oklab(palette[k : k + 1])[0]
            chroma, chroma_k = math.hypot(a, b), math.hypot(ak, bk)
            angle = math.atan2(b, a) - math.atan2(bk, ak)
            hue = 2 * math.sqrt(chroma * chroma_k) * abs(math.sin(angle / 2))  # as CIE's ΔH is defined
            cost[k] = (0.5 * (light_ - lk)) ** 2 + (chroma - chroma_k) ** 2 + (2 * hue) ** 2
        assert chosen in free and cost[chosen] == pytest.approx(min(cost.values()), abs=1e-9)
        free.discard(chosen)


@pytest.mark.parametrize("azimuth", [0.0, 0.9, -2.0, math.pi])
def test_the_lamp_stands_to_the_left_of_and_above_the_camera(azimuth):
    camera = look(np.eye(3), width=100, height=100, azimuth=azimuth, elevation=0.2, lens=0.5)
    towards, weight, key = light.studio(azimuth)
    right, up, back = (towards[key] @ axis for axis in camera.axes)
    assert (right < -0.1).all() and (up > 0.2).all() and back.mean() > 0.2
    assert weight[key].sum() > 0 and key.sum() == 10


def test_a_camera_leaves_a_margin_about_what_it_sees():
    points = np.random.default_rng(3).normal(size=(200, 3)) * (30.0, 10.0, 20.0)
    camera = look(points, width=400, height=300, azimuth=0.4, elevation=0.3, lens=0.5)
    right, up, back = ((points - camera.eye) @ camera.axes.T).T
    across = np.abs(right / -back * camera.scale) / (camera.width / 2)
    down = np.abs(up / -back * camera.scale) / (camera.height / 2)
    assert (back < 0).all() and max(across.max(), down.max()) == pytest.approx(0.86, abs=0.01)


def test_normals_of_small_faces_are_units():
    corner = np.array([(0, 0, 0), (1e-3, 0, 0), (0, 1e-3, 0)])
    assert np.allclose(face_normals(corner, np.array([(0, 1, 2), (0, 1, 1)])), [(0, 0, 1), (0, 0, 0)])


# -- words, units and tables ------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("said", "px"), [("1in", 96), ("25.4mm", 96), ("72pt", 96), ("6pc", 96), ("101.6q", 96), ("2em", 20), ("2ex", 10)]
)
def test_lengths_of_css(said, px):
    assert css.length(said, em=10.0) == pytest.approx(px)


def test_a_view_box_meets_or_covers_its_place():
    for how, scale in (("xMidYMid meet", 2.0), ("xMidYMid slice", 3.0), ("", 2.0)):
        placed = fitted([0.0, 0.0, 10.0, 10.0], 0.0, 0.0, 20.0, 30.0, how)
        assert placed[0, 0] == placed[1, 1] == scale
        assert np.allclose(placed @ (5, 5, 1), (10, 15))  # middle on middle


@pytest.mark.parametrize("count", [2, 3, 4, 5, 16, 17])
def test_charts_of_any_number_of_colours_are_read_back(count, tmp_path):
    palette = Palette(
        np.column_stack([np.arange(count) * 14, np.full(count, 9), 255 - np.arange(count) * 14]).astype(np.uint8)
    )
    rows = np.stack([np.array([(k) % count, (k + 1) % count] * 3, np.uint8) for k in range(count)])
    files.write(Chart(rows, palette), tmp_path / "a.png", "Chart")
    again = files.read(tmp_path / "a.png", ["Chart"])
    assert (again.palette.rgb[again.cells] == palette.rgb[rows]).all()


def test_classes_of_yarn_by_the_names_that_bands_bear():
    # Craft Yarn Council: 1 sock, fingering; 2 sport; 3 DK, light worsted; 4 worsted, aran; 5 chunky; 6 super bulky.
    for number, names in enumerate(
        ("lace", "sock fingering 4-ply", "sport 5-ply", "dk 8-ply", "worsted aran 10-ply", "bulky chunky 12-ply")
    ):
        assert {WEIGHTS[class_of(name)].number for name in names.split()} == {number}, names
    assert class_of("light worsted") == "dk" and class_of("super chunky") == "super-bulky"


def test_a_flat_circle_lies_flat():
    # A round of a flat disc grows by 6 stitches, and by 2 pi heights.
    assert pytest.approx(2 * math.pi * SQUARE) == 6 * 1.0
    known = gauge(CrochetParams(yarn="dk"), {})
    assert known.height == pytest.approx(known.width * 3 / math.pi)


def test_plain_names_of_plain_colours():
    from PIL import ImageColor

    for name in ("black", "white", "gray", "red", "orange", "yellow", "green", "blue", "purple", "pink"):
        assert family(ImageColor.getrgb(name)[:3]) == name
    assert family((120, 70, 30)) == "brown"
    assert family((255, 120, 0)) == family((240, 150, 40)) == "orange"


def made_of(text):
    return [r.count for r in build(read_printed(Text("Rnd 1: 6 sc in magic ring (6)\n" + text), strict=True)).rounds]


def test_repeats_of_printed_rounds():
    for said in ("[2 sc, inc] twice", "[2 sc, inc] 2 times", "[2 sc, inc] x 2", "{2 sc, inc} twice"):
        assert made_of(f"Rnd 2: {said} (8)\n") == [6, 8], said
    with pytest.raises(TambourError, match="at least once"):
        read_printed(Text("Rnd 1: 6 sc in magic ring (6)\nRnd 2: [2 sc, inc] x 0 (6)\n"), strict=True)


def test_the_foot_of_a_post_stitch_goes_right_in_front_and_left_behind():
    for kind, sign in (("fpdc", 1), ("bpdc", -1), ("fpsc", 1), ("bpsc", -1)):
        foot = np.array(strokes(kind, 2.0)[-1])
        assert (sign * foot[:, 0]).max() > 0.15 and (sign * foot[:, 0]).min() > -0.05, kind


def test_papers_halve_from_size_to_size():
    # ISO 216: each is the one before, halved across its longer side, to the millimetre.
    for large, small in (("a2", "a3"), ("a3", "a4"), ("a4", "a5")):
        (wide, high), (w, h) = PAPERS[large], PAPERS[small]
        assert h == wide and w == math.floor(high / 2)


def test_rounds_that_grow_by_six_stitches_lie_flat_where_one_size_is_known():
    # A ring at r heights from the middle is 2πr heights long and has 6r stitches.
    for words in ("20 sc = 10 cm", "22 rounds = 10 cm"):
        width, height = swatch_of(words)
        assert 6 * width == pytest.approx(2 * math.pi * height), words


def test_normals_have_length_one_however_small_the_triangle():
    corners = np.array([(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)])
    for size in (1e-3, 1.0, 1e3):
        assert face_normals(size * corners, np.array([(0, 1, 2)])) == pytest.approx(np.array([(0.0, 0.0, 1.0)]))


def test_yards_and_skeins_of_knitting():
    chart = Chart(
        (np.indices((40, 60)).sum(0) % 2).astype(np.uint8), Palette(np.array([(0, 0, 0), (255, 255, 255)], np.uint8))
    )
    for one in amounts(chart, "dk", skein_grams=1.7):
        assert one.yards == pytest.approx(one.metres * 1.0936, rel=1e-4)
        assert one.skeins == math.ceil(one.grams / 1.7) > 1


def test_a_longest_float_holds_whole_stitches():
    for said, whole in (("2.5cm", 6), ("2.4cm", 5), ("30mm", 7)):  # a stitch is 4.17 mm wide
        assert limit_of(KnitParams(gauge="24x32", max_float=said)) == whole


def test_locks_are_short_and_changes_take_their_time(tmp_path):
    times, locks = [], []
    for fill in ("#00a", "#a22"):
        path = tmp_path / "two.svg"
        path.write_text(
            '<svg xmlns="http://www.w3.org/2000/svg" width="60mm" height="30mm" viewBox="0 0 60 30">'
            f'<path fill="#a22" d="M2 2h12v12h-12z"/><path fill="{fill}" d="M40 2h12v12h-12z"/></svg>'
        )
        piece = EMBROIDERY.make(read_drawing(path), EmbroideryParams(underlay="none"), Progress())
        told_of = EMBROIDERY.facts(piece)
        times.append(told_of["machine_seconds"] - told_of["stitches"] / 700 * 60 - 7 * told_of["trims"])
        end = np.flatnonzero(piece.kind == LOCK)
        locks.append(np.hypot(*(piece.plan.xy[end] - piece.plan.xy[end - 1]).T))
    assert times[0] - times[1] == pytest.approx(45, abs=2)  # a change of colour
    assert all(len(one) > 4 and np.median(one) <= 0.7 + 1e-6 for one in locks)


def test_what_the_tech_edit_doubts_is_red():
    from tambour.crochet.looks import checked
    from tambour.crochet.plush import make

    text = ": MR(6)\n: 6 inc\n: [sc, inc] x 6\n: 10 sc\n: 10 sc\n"
    color = checked(make(Text(text), CrochetParams(solver="none"), Progress())).color.astype(int)
    red = (color[:, 0] > 150) & (color[:, 1:3].max(1) < 90)
    assert 0.02 < red.mean() < 0.6


def test_chains_that_stand_for_a_stitch_are_as_long_as_it_is_high() -> None:
    from tambour.crochet.language.stitches import HEIGHTS, STANDING, STITCHES

    assert STANDING == {
        "ch1sc": "sc",
        "ch2hdc": "hdc",
        "ch3dc": "dc",
        "ch4tr": "tr",
        "ch5dtr": "dtr",
    }  # Craft Yarn Council
    for chain, stitch in STANDING.items():
        assert STITCHES[chain].moves[-1].height == HEIGHTS[stitch]

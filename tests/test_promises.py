"""Promises that docstrings make, each held against a law of its own: written after faults planted there had lived."""

from __future__ import annotations

import math
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tambour.color import nearest_distinct, oklab
from tambour.core.errors import Span, Text
from tambour.core.paths import Paths
from tambour.core.progress import Progress
from tambour.core.thread import END, STITCH, TRIM
from tambour.crochet.finish.placing import Frames
from tambour.crochet.finish.sewing import End, turned
from tambour.crochet.graph.build import build
from tambour.crochet.graph.check import size_edit, tech_edit
from tambour.crochet.language.finishes import Placed, Spot
from tambour.crochet.language.parse import parse
from tambour.crochet.page import flow as page_flow
from tambour.crochet.params import CrochetParams
from tambour.crochet.printed.heads import heads
from tambour.crochet.printed.tokens import rows
from tambour.crochet.printed.vocabulary import vocabulary
from tambour.embroidery import CRAFT as EMBROIDERY
from tambour.embroidery.columns.satin import from_stroke
from tambour.embroidery.params import EmbroideryParams
from tambour.embroidery.piece import Region
from tambour.embroidery.plan.facts import outside
from tambour.embroidery.plan.sequence import order
from tambour.files import exp
from tambour.files.records import Records
from tambour.files.svg.read import read_drawing
from tambour.ink.params import Ink
from tambour.ink.plotter.sheet import TRAVEL, reach
from tambour.render import light
from tambour.render.camera import look

# -- embroidery ---------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("degrees", [-120, -90, 80, 90, 130])
def test_columns_meet_along_the_bisector_of_their_corner(degrees):
    half, turn = 1.0, math.radians(degrees)
    leg = np.linspace(0, 20, 41)
    line = np.concatenate([np.c_[leg - 20, 0 * leg], np.c_[leg[1:] * math.cos(turn), leg[1:] * math.sin(turn)]])
    first, second = from_stroke(line, 2 * half)
    # Both sides of a mitre lie on the bisector: as far along it as half the width allows, and no further than 1.2.
    far = min(1 / abs(math.cos(turn / 2)), math.hypot(1, 1.2)) * half
    bisector = np.array([-math.sin(turn / 2), math.cos(turn / 2)])
    for side, sign in (("left", 1), ("right", -1)):
        one, other = getattr(first, side)[-1], getattr(second, side)[0]
        if abs(math.tan(turn / 2)) <= 1.2:
            assert np.allclose(one, other, atol=0.06), side
            assert np.allclose(one, sign * far * bisector, atol=0.06), side
        else:
            assert abs(one[0] - sign * -math.copysign(1.2, turn) * half) < 0.06, side  # as slanted as is allowed
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
    assert edge == pytest.approx(15.0, abs=0.1) and outside(piece) == 0
    inner = np.flatnonzero((piece.plan.command == STITCH) & (np.abs(piece.plan.xy).max(1) < 10))[50]
    for reach_of, count in ((0.03, 0), (0.08, 2), (0.4, 2)):  # SLACK is 0.05 mm
        xy = piece.plan.xy.copy()
        xy[inner] = (15.0 + reach_of, xy[inner, 1])
        assert outside(replace(piece, plan=replace(piece.plan, xy=xy))) == count, reach_of


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
    (wrong,) = found("4 cm wide, 10 cm tall", (40.0, 60.0, 40.0))
    assert "says 10.0 cm" in wrong.message


@given(
    st.lists(st.tuples(st.integers(3, 60), st.integers(0, 9), st.booleans()), min_size=1, max_size=30),
    st.integers(80, 250),
)
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
    axis, front = turned(placed, End(np.arange(6), True, np.zeros((0, 2), int)), frame)
    a = math.radians(degrees)
    assert np.allclose(axis, (0, 0, 1)) and np.allclose(front, (math.sin(a), -math.cos(a), 0), atol=1e-12)


def test_the_shopping_list_holds_yarn_for_sewing_on():
    from tambour.crochet.maker.materials import SPARE, lengths, materials
    from tambour.crochet.plush import make

    two = "== a ==\n: MR(6)\n: 6 inc\n: 12 sc\n: 6 dec\nFO\n== b ==\n: MR(6)\n: 6 sc\nplace(b, a, round=2)\n"
    piece = make(Text(two), CrochetParams(tolerance=0.2), Progress())
    bought = sum(y["metres"] for y in materials(piece)["yarn"])
    assert bought == pytest.approx((sum(lengths(piece).values()) + 0.3) * SPARE, abs=0.06)  # one tail of 30 cm


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
    for color, chosen in zip(rgb, nearest_distinct(rgb, palette).tolist()):
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

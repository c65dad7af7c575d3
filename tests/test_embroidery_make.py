"""The craft's promises on a whole drawing."""

from __future__ import annotations

import json
import re
from dataclasses import replace

import numpy as np
import pytest
import shapely
from click.testing import CliRunner

from tambour import files
from tambour.cli import tambour
from tambour.core.paths import Paths
from tambour.core.progress import Progress
from tambour.core.thread import COLOR, END, JUMP, STITCH, TRIM
from tambour.embroidery.params import EmbroideryParams
from tambour.embroidery.piece import SATIN, Region
from tambour.embroidery.plan.facts import outside, steps
from tambour.embroidery.plan.layers import layers
from tambour.embroidery.plan.make import make
from tambour.embroidery.regions.flat import shape

SQUARES = """<svg xmlns="http://www.w3.org/2000/svg" width="60mm" height="30mm" viewBox="0 0 60 30">
<g data-tambour-angle="45"><path id="left" fill="#a22" d="M2 2h20v20h-20z"/></g>
<path id="right" fill="navy" fill-rule="evenodd" d="M30 2h25v25h-25z M38,8h8v8h-8z"/></svg>"""


def report(tmp_path, svg, *options):
    (tmp_path / "in.svg").write_text(svg)
    out, rep = tmp_path / "out.json", tmp_path / "report.json"
    result = CliRunner().invoke(
        tambour, ["embroidery", str(tmp_path / "in.svg"), "-o", str(out), "--report", str(rep), *options]
    )
    assert result.exit_code == 0, result.output
    return json.loads(rep.read_text()), json.loads(out.read_text())


def test_two_fills_have_one_jump_and_lie_inside(tmp_path):
    facts, plan = report(tmp_path, SQUARES, "--underlay", "none", "--pull", "0", "--push", "0")
    assert facts["jumps"] == 1 and facts["trims"] == 2 and facts["outside"] == 0
    assert facts["density"]["rows_cv"] < 0.015
    assert facts["longest_mm"] <= 3 + 1e-9
    command = np.array(plan["command"])
    assert command[-1] == END and (command[:-1] != END).all()
    xy = np.c_[plan["x_mm"], plan["y_mm"]]
    assert abs(xy[command == STITCH].mean(0)).max() < 5 and (command == JUMP).sum() >= 1


def test_a_region_overrides_the_angle(tmp_path):
    _, plan = report(tmp_path, SQUARES, "--underlay", "none", "--no-locks", "--min-length", "0")
    xy = np.c_[plan["x_mm"], plan["y_mm"]]
    region, kind = np.array(plan["region"]), np.array(plan["kind"])
    for k, slope in ((plan["regions"].index("left"), -1.0), (plan["regions"].index("right"), 0.0)):
        end = np.flatnonzero((region == k) & (kind == 0))
        d = xy[end] - xy[end - 1]
        long = np.hypot(*d.T) > 1
        assert np.allclose(d[long, 1] / d[long, 0], slope, atol=1e-3)


COMES_BACK = """<svg xmlns="http://www.w3.org/2000/svg" width="60mm" height="20mm" viewBox="0 0 60 20">
<path d="M0 0h20v20h-20z" fill="#000"/><path d="M5 5h50v10h-50z" fill="#fff"/><path d="M8 8h10v4h-10z" fill="#000"/>
<path d="M10 9h4v2h-4z" fill="#fff"/></svg>"""


@pytest.mark.slow
@pytest.mark.parametrize("suffix", ["pes", "jef", "sew", "vp3"])
def test_a_colour_that_comes_back_is_the_same_thread(tmp_path, suffix):
    (tmp_path / "in.svg").write_text(COMES_BACK)
    piece = make(files.read(tmp_path / "in.svg", ("Drawing",)), EmbroideryParams(underlay="none"), Progress())
    assert [t.rgb for t in piece.plan.threads] == [(0, 0, 0), (255, 255, 255)]
    changes = int((piece.plan.command == COLOR).sum())
    assert changes == 3
    files.write(piece.plan, tmp_path / f"out.{suffix}")
    back = files.read(tmp_path / f"out.{suffix}", ("ThreadPlan",))
    assert len(back.threads) == 2 and int((back.command == COLOR).sum()) == changes
    held = back.thread[back.command == STITCH]
    assert held.tolist() == piece.plan.thread[piece.plan.command == STITCH].tolist()


STROKES = """<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 72 72"><g fill="none" stroke="#000" stroke-width="{}">
<path d="M10 12 L60 12 L60 60"/><circle cx="30" cy="40" r="14"/></g></svg>"""


@pytest.mark.parametrize("width", [0.4, 2, 6])
def test_the_width_asked_for_is_that_of_all_thread(tmp_path, width):
    facts, _ = report(tmp_path, STROKES.format(width), "--width", "60mm", "--pull", "0")
    assert facts["width_mm"] == pytest.approx(60, rel=0.01)


@pytest.mark.parametrize("motif", ["e", "diamond", "star"])
def test_the_figures_of_a_motif_are_within_the_width_asked_for(tmp_path, motif):
    """An E-stitch asked for at 60 mm was sewn 63.9 mm wide: its prongs stood out."""
    told = ("--stitch", "motif", "--motif", motif, "--width", "60mm", "--pull", "0")
    facts, _ = report(tmp_path, STROKES.format(0.4), *told)
    assert facts["width_mm"] == pytest.approx(60, rel=0.01)


def test_a_hoop_takes_what_it_says_would_fit(tmp_path):
    (tmp_path / "in.svg").write_text(STROKES.format(6))
    command = ["embroidery", str(tmp_path / "in.svg"), "-o", str(tmp_path / "o.json"), "--hoop", "50x40", "--width"]
    told = CliRunner().invoke(tambour, [*command, "80mm"], standalone_mode=False)
    size = re.search(r"--width\}? ([\d.]+mm) would fit", str(told.exception.problems[0].hint))
    facts, _ = report(tmp_path, STROKES.format(6), "--hoop", "50x40", "--width", size[1], "--pull", "0")
    assert facts["width_mm"] <= 50.3 and facts["height_mm"] <= 40.3 and facts["height_mm"] > 38.5


@pytest.mark.parametrize("more", [["--knockdown"], ["--baste"], ["--knockdown", "--baste"], []])
def test_what_is_sewn_beyond_the_design_must_fit_into_the_hoop_too(tmp_path, more):
    (tmp_path / "in.svg").write_text(STROKES.format(6))
    command = ["embroidery", str(tmp_path / "in.svg"), "-o", str(tmp_path / "o.json"), "--hoop", "50x40", *more]
    told = CliRunner().invoke(tambour, [*command, "--width", "49.8mm"], standalone_mode=False)
    size = re.search(r"--width\}? ([\d.]+mm) would fit", str(told.exception.problems[0].hint))
    facts, _ = report(tmp_path, STROKES.format(6), "--hoop", "50x40", "--width", size[1], *more)
    assert facts["width_mm"] <= 50.1 and facts["height_mm"] <= 40.1 and facts["height_mm"] > 38.5


def test_a_hoop_that_takes_no_width_at_all_is_told_to_be_larger(tmp_path):
    """``--width -0.5mm would fit`` stood there: the basting box alone is wider."""
    (tmp_path / "in.svg").write_text(STROKES.format(6))
    command = ["embroidery", str(tmp_path / "in.svg"), "-o", str(tmp_path / "o.json"), "--baste", "--width", "30mm"]
    told = CliRunner().invoke(tambour, [*command, "--hoop", "10x10"], standalone_mode=False)
    hint = str(told.exception.problems[0].hint)
    hoop = re.search(r"larger {--hoop}: (\d+x\d+) would take it", hint)
    assert "would fit" not in hint
    assert CliRunner().invoke(tambour, [*command, "--hoop", hoop[1]]).exit_code == 0


def test_basting_and_knockdown_are_sewn_in_one_thread(tmp_path):
    facts, _ = report(tmp_path, SQUARES, "--knockdown", "--baste")
    apart, _ = report(tmp_path, SQUARES, "--knockdown")
    assert facts["color_changes"] == apart["color_changes"] == 2


LETTERS = """<svg xmlns="http://www.w3.org/2000/svg" width="60mm" height="60mm" viewBox="0 0 60 60">
<text x="5" y="30" font-size="{}">Abc</text></svg>"""


@pytest.mark.parametrize(
    "font, options",
    [
        (8, ["--width", "9mm"]),
        (8, ["--text", "Hallo", "--text-size", "20mm", "--width", "30mm"]),
        (20, ["--text", "Hallo", "--text-size", "2mm"]),
        (None, ["--text", "Hallo", "--text-size", "8mm", "--width", "9mm"]),
        (None, ["--text", "Hallo", "--text-size", "3mm"]),
    ],
)
def test_what_small_letters_are_told_makes_them_large_enough(tmp_path, font, options):
    (tmp_path / "in.svg").write_text(LETTERS.format(font))
    source = [str(tmp_path / "in.svg")] if font else []
    command = ["embroidery", *source, "-o", str(tmp_path / "o.json"), "--report", str(tmp_path / "r.json"), *options]

    def told(*more):
        assert CliRunner().invoke(tambour, [*command, *more]).exit_code == 0
        problems = json.loads((tmp_path / "r.json").read_text())["problems"]
        return [p for p in problems if p["message"].startswith("capitals of")]

    (small,) = told()
    flag, size = re.fullmatch(r"{?(--[a-z-]+)}? (\d+mm)", small["hint"]).groups()
    assert not told(flag, size)


def test_how_large_an_icon_is_sewn_is_told(tmp_path):
    (tmp_path / "in.svg").write_text(
        '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 48 48"><path d="M2 2h44v44h-44z"/></svg>'
    )
    drawing = files.read(tmp_path / "in.svg", ("Drawing",))
    for width, count in ((None, 1), (11.6, 0)):
        progress = Progress()
        make(drawing, EmbroideryParams(width=width), progress)
        assert (
            sum(w.message.startswith("sewn 11.6 x 11.6 mm") and "--width" in w.hint for w in progress.warnings) == count
        )


def test_what_is_not_looked_for_among_many_regions_is_told(tmp_path, monkeypatch):
    for module in ("plan.make", "plan.overlap", "families.decide"):
        monkeypatch.setattr(f"tambour.embroidery.{module}.MANY", 1)
    (tmp_path / "in.svg").write_text(SQUARES)
    drawing = files.read(tmp_path / "in.svg", ("Drawing",))

    def said(**more):
        progress = Progress()
        make(drawing, EmbroideryParams(**more), progress)
        return " ".join(w.message for w in progress.warnings if "2 regions" in w.message)

    assert all(word in said() for word in ("hidden", "touch", "hair lines", "joined", "below their neighbours"))
    assert "hidden" not in said(keep_hidden=True) and "joined" in said(keep_hidden=True)


def test_a_stray_stitch_does_not_allow_itself(tmp_path):
    """With a pull in per cent the longest stitch said how far one may stand outside: a stray one, any distance."""
    bar = SQUARES.replace("M2 2h20v20h-20z", "M2 2h3v20h-3z")
    (tmp_path / "in.svg").write_text(bar)
    drawing = files.read(tmp_path / "in.svg", ("Drawing",))
    piece = make(drawing, EmbroideryParams(stitch="satin", pull_percent=8.0), Progress())
    assert piece.regions[0].role == "area" and not len(outside(piece))
    at = int(np.flatnonzero((piece.region == 0) & (piece.kind == SATIN))[6])
    xy = piece.plan.xy.copy()
    xy[at] += np.sign(xy[at] - xy[at - 1]) * [0.7, 0]
    assert len(outside(replace(piece, plan=replace(piece.plan, xy=xy))))


@pytest.mark.parametrize("cap, beyond", [(0, 3), (1, 0), (2, 3)])
def test_a_line_covers_what_it_is_sewn_on(cap, beyond):
    line = Region(
        "a", Paths.of([np.array([[0.0, 0], [20, 0]])]), "satin", (0, 0, 0), EmbroideryParams(), "line", 6.0, cap=cap
    )
    assert shape(line).bounds == pytest.approx((-beyond, -3, 20 + beyond, 3))
    assert shape(line).area == pytest.approx(120 + (0, 0, 36)[cap] + (np.pi * 9 if cap == 0 else 0), abs=0.1)


def test_basting_is_cut_before_the_design(tmp_path):
    (tmp_path / "in.svg").write_text(STROKES.format(6))
    piece = make(files.read(tmp_path / "in.svg", ("Drawing",)), EmbroideryParams(width=40.0, baste=True), Progress())
    first = int(np.flatnonzero((piece.plan.command == STITCH) & (piece.region >= 0))[0])
    assert TRIM in piece.plan.command[:first].tolist()


def test_thread_lies_in_sewing_order(tmp_path):
    """A later stitch lies above every earlier one of another layer that it crosses, but for where they dive."""
    (tmp_path / "in.svg").write_text(STROKES.format(6).replace('fill="none"', 'fill="#c33"'))
    piece = make(
        files.read(tmp_path / "in.svg", ("Drawing",)), EmbroideryParams(width=30.0, keep_hidden=True), Progress()
    )
    xy, end = steps(piece)
    size = np.hypot(xy[:, 2] - xy[:, 0], xy[:, 3] - xy[:, 1])
    xy, end, size = xy[size > 1], end[size > 1], size[size > 1]
    cut = (0.4 / size)[:, None] * (xy[:, 2:] - xy[:, :2])
    lines = shapely.linestrings(np.stack([xy[:, :2] + cut, xy[:, 2:] - cut], 1))
    a, b = shapely.STRtree(lines).query(lines, predicate="crosses")
    group = layers(piece.region, piece.kind)[end]
    pairs = (a > b) & (group[a] != group[b])
    assert pairs.sum() > 1000
    assert (
        piece.elevation[end[a[pairs]]] > piece.elevation[end[b[pairs]]]
    ).mean() > 0.98  # heights stand in cells of half a thread

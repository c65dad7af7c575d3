"""The craft as a whole: what is promised on the command line, and what the report says."""

from __future__ import annotations

import hashlib
import json
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from tambour.cli import main
from tambour.core.chart import Chart
from tambour.core.errors import TambourError
from tambour.core.palette import Palette
from tambour.core.picture import Picture
from tambour.core.progress import Progress
from tambour.knit.params import KnitParams
from tambour.knit.picture import tone
from tambour.knit.solve import exact, floats
from tambour.knit.solve.edit import resolve
from tambour.knit.solve.make import make

METHODS = ("random-walk", "min-conflict", "gsat", "hybrid", "texture", "exact", "perceptual")


def scene(rows=48, stitches=60):
    y, x = np.mgrid[:rows, :stitches]
    grey = 128 + 120 * np.sin(x / 11 + np.cos(y / 9) * 2) * np.cos(y / 17)
    return np.clip(grey, 0, 255).astype(np.uint8)


def picture(grey):
    return Picture(np.dstack([grey] * 3 + [np.full_like(grey, 255)]))


def made(grey=None, **params):
    told = Progress()
    return make(picture(scene() if grey is None else grey), KnitParams(**params), told), told


def lawful(cells, limit, ring=False, knit=None, relaxed=None, free=False):
    """The law told by strings: no solver's code, no kernel."""
    for r, row in enumerate(cells):
        kept = [x for x in range(len(row)) if knit is None or knit[r, x]]
        text = "".join("-" if relaxed is not None and relaxed[r, x] else "01"[row[x]] for x in kept)
        if free:
            text = text.lstrip(text[:1]).rstrip(text[-1:]) if len(set(text)) > 1 else ""
        if ring and len(kept) > limit:
            text += text[:limit]
        if "0" * (limit + 1) in text or "1" * (limit + 1) in text:
            return False
    return True


@pytest.mark.parametrize("how", ["threshold", "ordered", "floyd-steinberg", "atkinson"])
def test_every_method_begins_from_what_none_writes(how):
    none, _ = made(method="none", start=how)
    assert (none.chart.cells == none.start).all() and none.figures["flips"] == 0
    for method in METHODS:
        piece, _ = made(method=method, start=how)
        assert (piece.start == none.chart.cells).all()
        assert piece.figures["flips"] == (piece.chart.cells != piece.start).sum()
        assert piece.figures["conflicts_before"] == none.figures["conflicts"]


@pytest.mark.parametrize("limit", [1, 2, 4, 9, 15])
@pytest.mark.parametrize(
    "how", [{}, {"edges": "free"}, {"round": True}, {"repeat": "24", "stitches": 72}, {"border": 2}, {"gauge": "24x32"}]
)
def test_no_output_breaks_the_law(limit, how):
    for method in ("exact", "perceptual"):
        piece, _ = made(method=method, max_float=limit, **how)
        ring, free = bool(how.get("round") or how.get("repeat")), "edges" in how
        assert lawful(piece.chart.cells, limit, ring, free=free)
        assert piece.figures["violations"] == 0 and piece.figures["conflicts"] == 0
        if how.get("repeat"):
            assert (piece.chart.cells[:, :24] == piece.chart.cells[:, 48:]).all()


def test_masks_are_kept():
    rng = np.random.default_rng(0)
    masks = {n: (rng.random((48, 60)) < p) for n, p in (("shape", 0.9), ("relax", 0.1), ("lock", 0.1))}
    given = {n: picture(np.where(m, 255, 0).astype(np.uint8)) for n, m in masks.items()}
    up = {n: m[::-1] for n, m in masks.items()}
    for method in ("exact", "perceptual"):
        piece, _ = made(method=method, start="ordered", **given)
        chart = piece.chart
        assert (chart.no_stitch == ~up["shape"]).all() and (chart.relaxed == up["relax"]).all()
        kept = up["lock"] & up["shape"]
        assert (chart.cells == piece.start)[kept].all()
        assert lawful(chart.cells, 4, knit=up["shape"], relaxed=up["relax"])
        assert piece.figures["stitches"] == up["shape"].sum()


def test_locks_that_cannot_be_are_named():
    with pytest.raises(TambourError, match="the floats in row 2 would be longer than"):
        lock = np.zeros((3, 20), np.uint8)
        lock[1, 4:12] = 255
        make(picture(np.zeros((3, 20), np.uint8)), KnitParams(lock=picture(lock), tone="raw"), Progress())
    with pytest.raises(TambourError, match="edge stitches of one colour"):
        made(edge_stitches=6)


def test_a_length_is_a_limit_at_the_gauge():
    assert made(max_float="2.5cm", gauge="24x32")[0].limit == 6
    assert made(max_float="1in", gauge="28x36")[0].limit == 7
    with pytest.raises(TambourError, match="needs --gauge"):
        KnitParams.of({"max_float": "2cm"})
    with pytest.raises(TambourError, match="less than one stitch"):
        made(max_float="1mm", gauge="24x32")
    for wrong in ("0", "x", "-3", "0cm", "4.5"):
        with pytest.raises(TambourError, match="--max-float"):
            KnitParams.of({"max_float": wrong})


def test_keep_goes_from_best_tone_to_fewest_flips():
    pieces = [made(keep=k, tone="raw")[0] for k in (0, 0.01, 0.1, 1)]
    flips = [p.figures["flips"] for p in pieces]
    assert flips == sorted(flips, reverse=True)
    assert flips[-1] == floats.fewest(pieces[0].start, 4)


def test_soft_limits_are_traded_for_flips():
    dear, cheap = (made(method="exact", soft=s, tone="raw")[0].figures for s in (100, 0.05))
    assert dear["violations"] == 0 and cheap["violations"] > 0 and cheap["flips"] < dear["flips"]


def test_advice_and_gauge_are_said():
    said = [str(w) for w in made(scene() // 128 * 255, method="gsat", stitches=60, start="threshold")[1].warnings]
    assert any("GSAT alone" in w for w in said) and any("--gauge 24x32" in w for w in said)
    assert not made(stitches=60, gauge="24x32")[1].warnings
    drawing = np.full((48, 60), 255, np.uint8)
    drawing[10:40, 20:22] = 0
    piece, _ = made(drawing)
    assert piece.figures["kind"] == "line drawing" and piece.figures["start"] == "2 tones"
    assert piece.params.method == "exact" and lawful(piece.chart.cells, 4)


def test_edits_are_solved_again():
    for method in ("exact", "perceptual", "gsat", "none"):
        piece, _ = made(method=method)
        before = piece.chart.cells.copy()
        again = resolve(piece, [(20, 30, 1 - int(before[20, 30])), (21, 0, 1 - int(before[21, 0]))])
        assert again.chart.cells[20, 30] != before[20, 30] and again.chart.cells[21, 0] != before[21, 0]
        assert (piece.chart.cells == before).all()
        changed = np.flatnonzero((again.chart.cells != before).any(1))
        if method != "perceptual":
            assert set(changed) == {20, 21}
        if method in ("exact", "perceptual"):
            assert lawful(again.chart.cells, 4)
        third = resolve(again, [(20, 31, int(again.chart.cells[20, 31]))])
        assert third.chart.cells[20, 30] == again.chart.cells[20, 30]
        if method in ("exact", "perceptual"):  # the row is the chart's, not that of the part which is solved again
            with pytest.raises(TambourError, match="the floats in row 21 would be longer than 4 stitches"):
                resolve(piece, [(20, x, 1) for x in range(9, 18)])
    with pytest.raises(TambourError, match="there is no stitch 99"):
        resolve(piece, [(0, 99, 1)])
    with pytest.raises(TambourError, match="not knitted with colour 7"):
        resolve(piece, [(0, 9, 7)])


def test_a_chart_is_mended_or_checked():
    rng = np.random.default_rng(3)
    cells = (rng.random((12, 30)) < 0.2).astype(np.uint8)
    chart = Chart(cells, Palette(np.array([[200, 30, 30], [250, 250, 240]], np.uint8), ("red", "cream")))
    checked = make(chart, KnitParams(check=True), Progress())
    assert (checked.chart.cells == cells).all() and checked.figures["conflicts"] > 0
    mended = make(chart, KnitParams(method="exact"), Progress())
    assert lawful(mended.chart.cells, 4) and mended.figures["flips"] == floats.fewest(cells, 4)
    assert mended.chart.palette.names == ("red", "cream")


def run(*words):
    with pytest.raises(SystemExit) as left:
        main([str(w) for w in words])
    return left.value.code


def test_the_command_line(tmp_path, capsys):
    Image.fromarray(scene()).save(tmp_path / "photo.jpg")
    report = tmp_path / "r.json"
    out = tmp_path / "chart.png"
    assert run("knit", tmp_path / "photo.jpg", "--stitches", 40, "-o", out, "--report", report, "--quiet") == 0
    told = json.loads(report.read_text())
    assert {"stitches", "conflicts", "consistent", "flips", "longest_float", "violations", "seconds"} <= set(told)
    assert {"start", "read", "tone", "start_assignment", "solve", "write"} <= set(told["seconds"])
    with Image.open(out) as image:
        assert image.size == (40, 32) and len(image.convert("RGB").getcolors()) == 2
        pixels = np.asarray(image.convert("L")) // 255
    assert lawful(pixels, 4) and told["stitches"] == pixels.size and told["violations"] == 0
    before = out.read_bytes()
    assert run("knit", "--check", out, "--report", report, "--quiet") == 0
    told = json.loads(report.read_text())
    assert told["conflicts"] == 0 and told["flips"] == 0 and told["consistent"] == 100 and out.read_bytes() == before
    assert run("knit", "--check", "--max-float", 2, out, "--report", report, "--quiet") == 0
    assert json.loads(report.read_text())["conflicts"] > 0
    assert run("knit", "--check", tmp_path / "photo.jpg", "--quiet") == 2
    assert "a chart has a few" in capsys.readouterr().err


@pytest.mark.parametrize("shape", [(1, 1), (1, 2), (3, 1), (1, 20000), (20000, 1)])
def test_the_smallest_and_the_longest(shape):
    grey = np.full(shape, 90, np.uint8)
    for method in ("none", "exact", "perceptual"):
        piece, _ = made(grey, method=method, rows=shape[0], stitches=shape[1])
        assert piece.chart.cells.shape == shape
        assert method == "none" or lawful(piece.chart.cells, 4)


@pytest.mark.slow
def test_bytes_do_not_depend_on_threads_or_processes(monkeypatch):
    from tambour.core import threads

    code = (
        "import hashlib, numpy as np; from tests.test_knit_craft import made, scene;"
        "print([hashlib.sha256(made(scene(300, 200), method=m, tone='raw')[0].chart.cells.tobytes()).hexdigest()"
        " for m in ('exact', 'perceptual')])"
    )
    root = Path(__file__).resolve().parent.parent
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, cwd=root)
    found = {done.stdout.strip()}
    for workers in (1, 3):
        monkeypatch.setattr(threads, "WORKERS", workers)
        pieces = [made(scene(300, 200), method=m, tone="raw")[0].chart.cells for m in ("exact", "perceptual")]
        found.add(str([hashlib.sha256(cells.tobytes()).hexdigest() for cells in pieces]))
    assert len(found) == 1


def test_lined_up_flips_are_few():
    y, x = np.mgrid[:120, :150]
    t = (0.5 + 0.5 * np.sin(x / 31 + np.cos(y / 27))).astype(np.float32)
    from tambour.knit.solve import measure
    from tambour.knit.solve import paper2013 as paper
    from tambour.knit.task import Task

    task = Task(t, tone.assign(t, "floyd-steinberg", 0.5), 4)
    ours = measure.lined_up(exact.solve(task) != task.start)
    theirs = measure.lined_up(paper.solve(task, "gsat", KnitParams()) != task.start)
    assert ours <= 20 and theirs > 4 * ours


def test_a_drawing_is_knitted_as_its_picture_is(tmp_path: Path) -> None:
    from tambour import files
    from tambour.render.flat import picture
    from tambour.run import make as made

    drawn = "examples/embroidery/heart.svg"
    files.write(picture(files.read(drawn, ("Drawing",))), tmp_path / "heart.png")
    params = KnitParams(stitches=30)
    one, two = (made("knit", source, params).piece.chart for source in (drawn, tmp_path / "heart.png"))
    assert (
        (one.cells == two.cells).all() and (one.palette.rgb == two.palette.rgb).all() and len(set(one.cells.flat)) > 1
    )


def test_areas_that_a_hand_marks_are_relaxed_or_matter_as_masks_do(tmp_path: Path) -> None:
    """``relax:`` and ``matter:`` are the masks that hold the same rectangle; what is not within the chart is told."""
    from tambour.run import make as made

    Image.fromarray(scene()).save(tmp_path / "p.png")
    rows, stitches = made("knit", tmp_path / "p.png", KnitParams(stitches=30, technique="stranded")).piece.chart.shape
    light = np.zeros((rows, stitches), np.uint8)
    light[rows - 14 : rows - 4, stitches - 22 : stitches - 5] = 255  # rows 5 to 14, stitches 6 to 22
    Image.fromarray(light).save(tmp_path / "mask.png")
    for kind, name in (("relax", "relax"), ("matter", "weights")):
        marked = made(
            "knit", tmp_path / "p.png", KnitParams(stitches=30, technique="stranded"), [f"{kind}:5,6,10,17"]
        ).piece
        params = KnitParams(stitches=30, technique="stranded", **{name: str(tmp_path / "mask.png")})
        masked = made("knit", tmp_path / "p.png", params).piece
        assert (marked.chart.cells == masked.chart.cells).all()
        if kind == "relax":
            assert marked.chart.relaxed is not None and (marked.chart.relaxed[::-1] == (light > 0)).all()
        with pytest.raises(TambourError, match="not within the chart"):
            made("knit", tmp_path / "p.png", KnitParams(stitches=30), [f"{kind}:5,6,10,97"])
    with pytest.raises(TambourError, match="no picture to follow"):
        made("knit", "examples/knit/band.csv", None, ["relax:1,1,2,2"])
    flat = made("knit", tmp_path / "p.png", KnitParams(stitches=30, technique="intarsia"), ["relax:1,1,2,2"])
    assert any("changes nothing" in w.message for w in flat.progress.warnings)

"""The craft from text to files: options, report, views, and that no pattern brings it down."""

from __future__ import annotations

import json
import time
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from tambour.core.errors import TambourError, Text
from tambour.core.picture import Picture
from tambour.core.progress import Progress
from tambour.crochet import CRAFT
from tambour.crochet.looks import graph
from tambour.crochet.maker.facts import facts
from tambour.crochet.maker.gauge import gauge
from tambour.crochet.params import CrochetParams
from tambour.crochet.piece import Plush
from tambour.crochet.plush import make
from tambour.run import run

BALL = "R1: MR(6)\nR2: 6 inc (12)\nR3: [sc, inc] x 6 (18)\n3: 18 sc (18)\n: [sc, dec] x 6 (12)\n: 6 dec (6)\nFO\n"
SEWN = """== body ==
color(120, 160, 80)
: MR(6)
: 6 inc
: [sc, inc] x 6, mark(a)
: 6 sc, mark(b), 12 sc
: 18 sc
: [sc, dec] x 6
: 6 dec
FO
== ear (make 2) ==
@stuffing = none
: MR(6)
: 6 inc
: sc, mark(c), 11 sc, mark(d)
== seams ==
sew(c.1, a)
sew(c.2, b)
"""


def made(text: str, **options) -> Plush:
    return make(Text(text), CrochetParams(**options), Progress())


def test_a_ball_from_text(tmp_path: Path) -> None:
    source = tmp_path / "ball.acl"
    source.write_text(BALL)
    report = run("crochet", source, CrochetParams(), [tmp_path / "ball.json"])
    assert {"nodes", "edges", "residual", "evaluations", "warnings", "seconds", "stitches", "parts", "rounds"} <= set(
        report
    )
    assert {"size_mm", "size_in", "tension", "volume_ml", "yarn"} <= set(report)
    assert {"start", "parse", "build", "settle", "write"} <= set(report["seconds"])
    assert report["nodes"] == 110 and report["warnings"] == [] and report["settled"]
    data = json.loads((tmp_path / "ball.json").read_text())
    assert list(data) == ["craft", "parts", "nodes", "edges", "sewn", "centroids", "positions", "faces", "stitch_mm"]
    assert list(data["nodes"]) == ["kind", "part", "color", "parent", "round", "loop", "peculiarity", "plane", "span"]
    assert all(i > j for i, j in data["edges"]) and len(data["positions"]) == report["nodes"]
    assert data["nodes"]["peculiarity"][0] == "root" and data["nodes"]["peculiarity"][-1] == "tip"
    start, end = data["nodes"]["span"][20]
    assert BALL[start:end] == "inc"
    # A ruler finds half the fabric's thickness beyond the stitches on either side.
    assert np.ptp(np.array(data["positions"]), axis=0).max() == pytest.approx(max(report["size_mm"]) - 3.3, abs=0.2)


def test_the_same_report_again_is_the_same_piece() -> None:
    one, two = made(BALL), made(BALL)
    assert one.positions.tobytes() == two.positions.tobytes()
    assert facts(one) == facts(two)


def test_gauge_is_size() -> None:
    base = facts(made(BALL))["size_mm"]
    assert facts(made(BALL, stitch_width="10mm", stitch_height="1cm"))["size_mm"] == pytest.approx(
        [2 * v for v in base], abs=0.05
    )
    assert gauge(CrochetParams(gauge="20x25"), {}).width == 5.0
    assert gauge(CrochetParams(gauge="20x25"), {}).height == 4.0
    with pytest.raises(TambourError, match="such as 20x22"):
        CrochetParams.of({"gauge": "many"})


def test_a_gauge_circle_measures_what_it_says() -> None:
    circle = "@stuffing = none\n: MR(6)\n: 6 inc\n" + "".join(f": [{k} sc, inc] x 6\n" for k in (1, 2, 3))
    size = sorted(facts(made(circle, gauge_circle="51mm"))["size_mm"])
    assert size[2] == pytest.approx(51, rel=0.05) and size[1] == pytest.approx(51, rel=0.05)


def test_the_pattern_speaks_and_options_win() -> None:
    assert made("@initializer = obo\n" + BALL, solver="none").start == "one-by-one"
    assert made("@initializer = obo\n" + BALL, start="rounds", solver="none").start == "rounds"
    assert len(made("@centroids = 3\n" + BALL, stuffing="centroid").centroids) == 3
    assert len(made("@centroids = 3\n" + BALL, stuffing="centroid", centroids=1).centroids) == 1
    light, firm = (made(f"@stuffing = {word}\n" + BALL).shape.volume[0] for word in ("light", "firm"))
    assert firm > 1.1 * light


def test_sewn_parts_end_outside_one_another_at_their_seams() -> None:
    piece = made(SEWN)
    g, x = piece.built.graph, piece.positions
    assert [p.name for p in g.parts] == ["body", "ear 1", "ear 2", "seams"] and piece.shape.settled
    for i, j in piece.built.sewn:
        assert np.linalg.norm(x[i] - x[j]) < 1.2 * piece.stitch[0]
    body = x[g.parts[0].start : g.parts[0].end]
    for ear in g.parts[1:3]:
        off = np.linalg.norm(x[ear.start : ear.end] - body.mean(0), axis=1)
        assert off.min() > 0.5 * np.linalg.norm(body - body.mean(0), axis=1).min()


def test_no_two_unconnected_stitches_are_nearer_than_half_a_stitch() -> None:
    for text in (BALL, SEWN, "@stuffing = none\n: MR(6)\n: 6 inc\n3: [inc] around\n"):
        piece = made(text)
        g, x = piece.built.graph, piece.positions / piece.stitch[0]
        joined = set(map(tuple, g.edges.tolist()))
        far = np.linalg.norm(x[:, None] - x[None], axis=2)
        near = [(i, j) for i, j in np.argwhere(np.tril(far < 0.5, -1)).tolist() if (i, j) not in joined]
        assert not near, near[:5]


def test_empty_and_tiny_patterns_have_shapes() -> None:
    for text in ("", "# nothing\n", "MR(3)\n", ": ch(5)\n", "MR(1)\n", ": MR(2)\n: 2 sc\n", ": ch(1)\n"):
        for stuffing in ("pressure", "centroid", "skeleton", "none"):
            piece = made(text, stuffing=stuffing)
            assert np.isfinite(piece.positions).all()
            facts(piece)
            graph(piece)


@pytest.mark.slow
def test_warnings_reach_the_report() -> None:
    progress = Progress()
    make(Text(BALL.replace("(18)", "(17)", 1)), CrochetParams(), progress)
    assert any("17" in str(w) and "18" in str(w) for w in progress.warnings)
    with pytest.raises(TambourError):
        made(BALL.replace("(18)", "(17)", 1), strict=True)
    progress = Progress()
    make(Text(BALL), CrochetParams(tolerance=1e-300), progress)
    assert any("not quite at rest" in str(w) for w in progress.warnings)


@pytest.mark.slow
def test_views_exist_for_their_suffixes(monkeypatch: pytest.MonkeyPatch) -> None:
    grey = Picture(np.full((4, 4, 4), 128, np.uint8))
    monkeypatch.setattr("tambour.render.raster.picture", lambda *_, **__: grey)  # what they show: tests of the sides
    piece = made(BALL, solver="none")
    for name, view in CRAFT.views.items():
        if name in ("photo", "page", "making", "compare"):
            # An extra, and minutes: tests/test_render_photo.py; a booklet: tests/test_crochet_page.py; pictures one after
            # the other: tests/test_crochet_making.py; what a model alone has: tests/test_crochet_model.py
            continue
        value = view.make(piece)
        assert type(value).__name__ == view.value, name


@st.composite
def mutations(draw: st.DrawFn) -> str:
    """A pattern with a few of its characters or lines dropped, doubled, swapped or replaced."""
    text = draw(st.sampled_from([BALL, SEWN]))
    for _ in range(draw(st.integers(1, 4))):
        a = draw(st.integers(0, max(len(text) - 1, 0)))
        b = min(len(text), a + draw(st.integers(0, 12)))
        way = draw(st.integers(0, 3))
        if way == 0:
            text = text[:a] + text[b:]
        elif way == 1:
            text = text[:b] + text[a:b] + text[b:]
        elif way == 2:
            text = text[:a] + draw(st.sampled_from("0123456789():,[]x@=#\n sincdehftro")) + text[a + 1 :]
        else:
            lines = text.split("\n")
            i, j = draw(st.integers(0, len(lines) - 1)), draw(st.integers(0, len(lines) - 1))
            lines[i], lines[j] = lines[j], lines[i]
            text = "\n".join(lines)
    return text


@settings(max_examples=60, deadline=None, derandomize=True, suppress_health_check=list(HealthCheck))
@given(mutations(), st.sampled_from(["pressure", "centroid", "skeleton"]))
@pytest.mark.slow
def test_mutations_give_a_piece_or_a_located_error(text: str, stuffing: str) -> None:
    began = time.process_time()
    try:
        piece = made(text, max_stitches=20_000, stuffing=stuffing)
    except TambourError as error:
        assert all(p.span is not None for p in error.problems)
    else:
        assert np.isfinite(piece.positions).all()
        facts(piece)
    assert time.process_time() - began < 10.0


def test_yarn_is_measured_by_colour() -> None:
    told = facts(made("color(255, 0, 0)\n" + BALL))["yarn"]
    assert told[0]["color"] == "#ff0000" and all(y["metres"] > 0 for y in told)
    # Unravelled swatches: a single crochet takes about eight times its width in yarn.
    assert 110 * 0.005 * 7 < sum(y["metres"] for y in told) < 110 * 0.005 * 9.5


@pytest.mark.slow
def test_a_side_is_seen_from_there() -> None:
    from tambour.crochet.page.portrait import SIDES, portrait

    assert set(SIDES) <= set(CRAFT.views)
    piece = made(BALL, solver="none")
    views = {side: portrait(piece, side, width=120, height=120).rgba for side in SIDES}
    assert all((one[..., :3] != 255).any() for one in views.values())
    assert len({one.tobytes() for one in views.values()}) == len(SIDES)


def test_only_who_looks_at_yarn_or_asks_for_it_has_it_led(monkeypatch: pytest.MonkeyPatch) -> None:
    from tambour.crochet import looks
    from tambour.crochet.yarn import fabric

    def refuse(*given: object, **options: object) -> None:
        raise AssertionError("yarn was led")

    monkeypatch.setattr(fabric, "strands", refuse)
    text = Text(": MR(6)\n: 6 inc\n: 12 sc\n: 6 dec\nFO\n")
    piece = make(text, CrochetParams(check=True), Progress())
    assert facts(piece)["size_mm"] and looks.surface(piece) and looks.graph(piece)
    with pytest.raises(AssertionError):
        looks.yarn(piece)


def test_building_that_steps_may_not_finish_is_told_before_the_first_of_them() -> None:
    text = Text(": MR(6)\n: 6 inc\n: 6 dec\nFO\n")
    for steps, told in ((20, True), (3000, False)):
        progress = Progress()
        params = CrochetParams(start="one-by-one", solver="steps", steps=steps, wait_steps=100)
        make(text, params, progress)
        assert any("one by one may take" in w.message for w in progress.warnings) == told, steps


def test_building_that_would_be_cut_short_is_told_before_it(monkeypatch: pytest.MonkeyPatch) -> None:
    """It was told when all was done, and its last nodes were on a heap."""
    from tambour.crochet.finish import shape

    text, params = Text(": MR(6)\n: 6 inc\n: 6 dec\nFO\n"), CrochetParams(start="one-by-one")
    for bound, told in ((1000, True), (shape.BUILDING, False)):
        monkeypatch.setattr(shape, "BUILDING", bound)
        progress, ahead = Progress(), []
        monkeypatch.setattr(progress, "ahead", lambda *words, heard=ahead: heard.append(words[0]))
        make(text, params, progress)
        assert any("it will be cut short" in word for word in ahead) == told, bound


def test_a_long_wait_is_told_before_it(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Warnings were printed at the end: who stopped a building after some minutes had never read how long it takes."""
    from tambour.cli import main
    from tambour.crochet.finish import shape

    file, heard = tmp_path / "ball.acl", []
    file.write_text(": MR(6)\n: 6 inc\n")
    words = ["crochet", str(file), "-o", str(tmp_path / "ball.json")]
    words += ["--start", "one-by-one", "--solver", "steps", "--steps", "20"]
    with pytest.raises(SystemExit):
        main(words)
    assert capsys.readouterr().err.count("may not be enough") == 1

    def stopped(*_: object) -> None:
        heard.append(capsys.readouterr().err)
        raise TambourError("stopped")

    monkeypatch.setattr(shape, "simulate", stopped)
    with pytest.raises(SystemExit):
        main(words)
    assert "20 may not be enough" in heard[0]

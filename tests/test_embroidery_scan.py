"""Photos as a scan of lines; fills in two threads; lines that a hand laid, or that their width makes bold; small text."""

from __future__ import annotations

import numpy as np
import pytest

from tambour import files, run
from tambour.core.picture import Picture
from tambour.core.progress import Progress
from tambour.core.thread import COLOR, STITCH
from tambour.embroidery.lines.density import density_map
from tambour.embroidery.params import EmbroideryParams
from tambour.embroidery.piece import FILL, RUNNING, SATIN, UNDERLAY
from tambour.embroidery.plan.facts import steps
from tambour.embroidery.plan.make import make
from tambour.embroidery.regions.scan import BAND, parted, pitch_of


def grey(value, size=120):
    return np.dstack([np.full((size, size, 3), value, np.uint8), np.full((size, size), 255, np.uint8)])


@pytest.mark.parametrize("cover", [0.4, 0.6, 0.8, 1.0])
def test_the_pitch_gives_the_cover(cover):
    p = float(pitch_of(np.array([cover]), 0.4)[0])
    assert 0.4 * np.hypot(BAND, p) / (BAND * p) == pytest.approx(cover, rel=1e-6)


def test_a_scan_lays_more_thread_where_the_picture_is_darker():
    steps_of = np.repeat(np.array([250, 190, 120, 10], np.uint8), 40)
    rgba = np.dstack([np.tile(steps_of, (120, 1))] * 3 + [np.full((120, 160), 255, np.uint8)])
    made = make(Picture(rgba), EmbroideryParams(style="scan", width=80.0), Progress())
    xy, _ = steps(made)
    low = xy.reshape(-1, 2).max(0) - (80, 60)  # the darkest stripe reaches the picture's corner
    cells = density_map(xy, np.ones(len(xy)), (low[0], low[1], low[0] + 80, low[1] + 60), 1.0)
    of = [float(cells[5:-5, a:b].mean()) for a, b in ((5, 15), (25, 35), (45, 55), (62, 74))]
    assert of == sorted(of) and of[-1] > 1.5 * of[1] > 0
    size = np.hypot(xy[:, 2] - xy[:, 0], xy[:, 3] - xy[:, 1])
    assert set(made.kind[made.plan.command == STITCH]) <= {RUNNING, 5} and size.max() < 3.6


def test_cloth_and_threads_mix_to_the_picture():
    rgb = np.full((40, 60, 3), 1.0)
    rgb[:, :20] = (0.8, 0.1, 0.1)
    rgb[:, 20:40] = (0.1, 0.2, 0.7)
    small = np.dstack([rgb, np.ones((40, 60))])
    threads, cover = parted(small, 2, EmbroideryParams(ground="#ffffff"))
    red = int(np.argmax([t[0] for t in threads]))
    assert cover[red][20, 10] > 0.85 > 0.15 > cover[red][20, 30] and cover[1 - red][20, 30] > 0.85
    assert cover[:, 20, 55].max() < 0.1 and (cover.sum(0) <= 1.1 + 1e-9).all()


@pytest.mark.slow
def test_five_threads_at_most_and_equal_bytes_each_time():
    draw = np.random.Generator(np.random.PCG64(5))
    rgba = np.dstack(
        [np.kron(draw.integers(0, 255, (6, 6, 3)), np.ones((20, 20, 1))), np.full((120, 120, 1), 255)]
    ).astype(np.uint8)
    params = EmbroideryParams(style="scan", width=60.0, colors=9)
    one, two = (make(Picture(rgba), params, Progress()) for _ in range(2))
    assert 1 < len(one.plan.threads) <= 5 and (one.plan.xy == two.plan.xy).all()
    assert (one.plan.command == COLOR).sum() == len(one.plan.threads) - 1


def svg(tmp_path, inner, size="60mm"):
    path = tmp_path / "a.svg"
    path.write_text(
        f'<svg xmlns="http://www.w3.org/2000/svg" xmlns:inkstitch="http://inkstitch.org/namespace" width="{size}" height="{size}" viewBox="0 0 60 60">{inner}</svg>'
    )
    return files.read(path, ("Drawing",))


def test_a_blend_thins_one_thread_out_as_the_other_grows(tmp_path):
    drawing = svg(
        tmp_path,
        '<path d="M0 0H50V40H0Z" fill="#e63946" data-tambour-blend="#ffb703" data-tambour-angle="0" data-tambour-stitch="tatami"/>',
    )
    made = make(drawing, EmbroideryParams(), Progress())
    assert [t.rgb for t in made.plan.threads] == [(230, 57, 70), (255, 183, 3)]
    y = [made.plan.xy[(made.kind == FILL) & (made.plan.thread == k), 1] for k in (0, 1)]
    share = [[((v > a) & (v < b)).mean() for a, b in ((-20, -10), (10, 20))] for v in y]
    up, down = (s[0] / s[1] for s in share)
    assert max(up, down) > 1.4 and min(up, down) < 1 / 1.4
    assert not ((made.kind == UNDERLAY) & (made.plan.thread == 1)).any()
    progress = Progress()
    make(svg(tmp_path, '<path d="M0 0H50V3H0Z" data-tambour-blend="#ffb703"/>'), EmbroideryParams(), progress)
    assert "one thread" in str(progress.warnings)


def test_lines_are_run_bold_or_satin_by_their_width(tmp_path):
    lines = "".join(
        f'<path d="M5 {10 * k + 5}H55" stroke="#000" stroke-width="{w}"/>' for k, w in enumerate((0.3, 0.8, 1.4))
    )
    assert [r.stitch for r in make(svg(tmp_path, lines), EmbroideryParams(order="file"), Progress()).regions] == [
        "running",
        "bean",
        "satin",
    ]


def test_manual_stitches_lie_where_they_were_laid(tmp_path):
    line = '<path d="M5 5 L9 5 L9.6 5 L10 8 L40 8" inkstitch:stroke_method="manual_stitch" fill="none" stroke="#000" stroke-width=".3"/>'
    made = make(svg(tmp_path, line), EmbroideryParams(locks=False), Progress())
    xy = made.plan.xy[made.plan.command == STITCH]
    step = np.diff(xy, axis=0)
    assert np.allclose(step[:3], [[4, 0], [0.6, 0], [0.4, 3]], atol=1e-6)
    assert np.allclose(step[3:], [10, 0], atol=1e-6) and len(step) == 6  # 30 mm are three stitches


def test_small_text_of_a_drawing_is_sewn_by_its_size(tmp_path):
    for size, underlay in ((5.5, "none"), (11, "center")):  # capitals of 4 and 8 mm
        made = make(
            svg(tmp_path, f'<text x="2" y="30" font-size="{size}" font-weight="bold">Rosa</text>'),
            EmbroideryParams(),
            Progress(),
        )
        assert {r.stitch for r in made.regions} == {"satin"} and {r.params.underlay for r in made.regions} == {underlay}
    large = make(svg(tmp_path, '<text x="2" y="50" font-size="50">R</text>'), EmbroideryParams(), Progress())
    assert large.regions[0].params.underlay == "auto"


def test_satin_and_fill_keep_the_angle(tmp_path):
    drawing = svg(tmp_path, '<path id="leaf" d="M5 5H50V10H5Z" fill="#080"/>')
    found = []
    for stitch in ("tatami", "satin", "contour", "tatami"):
        edits = ["region:leaf.angle=37", f"region:leaf.stitch={stitch}"]
        found.append(run.make("embroidery", drawing, EmbroideryParams(), edits).piece)
    assert [[round(np.degrees(r.turn), 6) for r in made.regions] for made in found] == [[37.0]] * 4
    assert [made.regions[0].stitch for made in found] == ["tatami", "satin", "contour", "tatami"]
    assert (found[0].plan.xy == found[-1].plan.xy).all() and (found[1].kind == SATIN).any()

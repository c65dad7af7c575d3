"""What makes a chart recognisable: the prepared picture, its regions, their grounds, the eye, and floats that are caught."""

from __future__ import annotations

import re
from itertools import pairwise, product
from pathlib import Path

import numpy as np
import pytest
from scipy.ndimage import label, zoom

from tambour.color import oklab
from tambour.core.chart import Chart, Gauge
from tambour.core.palette import Palette
from tambour.core.picture import Picture
from tambour.core.progress import Progress
from tambour.knit.hands.working import catches, longest_span
from tambour.knit.params import KnitParams
from tambour.knit.picture import grounds, prepare, regions, shades
from tambour.knit.solve import exact, measure, percept, sight
from tambour.knit.solve.edit import resolve
from tambour.knit.solve.floats import limit_of
from tambour.knit.solve.make import make
from tambour.knit.task import Task
from tambour.knit.views import facts


def photo(rows=96, stitches=80, seed=1):
    """Shaded discs on a ground that fades, with grain."""
    y, x = np.mgrid[:rows, :stitches]
    rgb = np.stack([225 - y * 0.7 - x * 0.5, 230 - y * 0.6 - x * 0.5, 235 - y * 0.5 - x * 0.5], -1)
    for cy, cx, r, tint in ((40, 30, 22, (60, 40, 50)), (66, 56, 18, (120, 110, 60)), (38, 24, 5, (240, 240, 230))):
        far = np.hypot((y - cy) * 0.75, x - cx)
        rgb[far < r] = np.array(tint) * (1 - 0.2 * (far[far < r] / r)[:, None])
    grain = np.random.default_rng(seed).normal(0, 4, (rows, stitches, 1))
    return np.clip(rgb + grain, 0, 255).astype(np.uint8)


def lawful(cells, limit):
    """The law told by strings."""
    texts = ["".join(map(str, row)) for row in np.asarray(cells).tolist()]
    return not any(c * (limit + 1) in text for text in texts for c in "01")


def piece_of(rgb, **params):
    rgba = np.dstack([rgb, np.full(rgb.shape[:2], 255, np.uint8)])
    return make(Picture(rgba), KnitParams(**params), Progress())


def test_the_style_is_chosen_and_its_reason_given():
    drawing = np.full((60, 60, 3), 255, np.uint8)
    drawing[20:40, 28:31] = 0
    art = np.zeros((60, 60, 3), np.uint8)
    art[10:50, 5:25], art[10:30, 25:50], art[30:50, 30:55] = (90, 90, 200), (250, 210, 60), (200, 40, 40)
    art[:10], art[50:] = (230, 230, 230), (120, 120, 120)
    for rgb, params, style, kind in (
        (drawing, {}, "graphic", "line drawing"),
        (art, {}, "graphic", "flat art"),
        (photo(), {}, "graphic", "photograph"),
        (photo(200, 180), {"stitches": 180, "yarns": 2}, "tonal", "photograph"),
        (photo(200, 180), {"stitches": 180, "floats": "caught"}, "graphic", "photograph"),
        (photo(), {"seen_from": "10m", "yarns": 2}, "tonal", "photograph"),
        (photo(), {"method": "exact"}, "plain", "photograph"),
        (photo(), {"detail": 1.0}, "plain", "photograph"),
        (photo(), {"keep": 0.1}, "tonal", "photograph"),
        (photo(), {"style": "texture"}, "texture", "photograph"),
    ):
        told = piece_of(rgb, **params).figures
        assert (told["style"], told["kind"]) == (style, kind), params
        assert told["why"].startswith(style + ":")


@pytest.mark.parametrize("limit", range(1, 12))
@pytest.mark.parametrize("style", ["graphic", "texture", "tonal"])
def test_every_style_keeps_the_law(limit, style):
    piece = piece_of(photo(40, 50), style=style, max_float=str(limit), gauge="24x32")
    assert lawful(piece.chart.cells, limit) and piece.figures["violations"] == 0


@pytest.mark.parametrize("ground", ["lice", "diagonal", "brick", "stripe"])
def test_lice_stand_in_order_and_away_from_borders(ground):
    y, x = np.mgrid[:90, :90]
    rgb = np.where((np.hypot(y - 45, x - 45) < 30)[..., None], (30, 30, 60), (240, 235, 220)).astype(np.uint8)
    piece = piece_of(rgb, max_float="5", ground=ground)
    flips = piece.chart.cells != piece.start
    move = grounds.shift(6, 1.0, ground)
    phases = np.bincount(((x + move * y) % 6)[flips], minlength=6)
    assert phases[0] > 0.75 * flips.sum()  # one lattice through the whole piece, the same inside and outside
    border = np.zeros_like(flips)
    edge = piece.start[:, 1:] != piece.start[:, :-1]
    border[:, 1:] |= edge
    border[:, :-1] |= edge
    assert (flips & border).sum() <= 0.02 * flips.sum()
    if ground != "stripe":
        assert measure.lone(piece.chart.cells)[flips].mean() > 0.95
    else:
        assert measure.upright(piece.chart.cells) > 100


def test_a_lattice_is_the_widest_there_is():
    for period, squash in product(range(2, 13), (1.0, 1.33)):
        near = {}
        for move in range(1, period):
            dots = [
                (dx, dy / squash)
                for dy in range(-period, period + 1)
                for dx in range(-period, period + 1)
                if (dx + move * dy) % period == 0 and (dx, dy) != (0, 0)
            ]
            near[move] = min(np.hypot(*d) for d in dots)
        assert near[grounds.shift(period, squash, "lice")] == pytest.approx(max(near.values()))


def test_the_solver_finds_the_least_weight_of_lice():
    """Brute force over all lawful rows of 12."""
    rng = np.random.default_rng(5)
    rows = [r for r in product((0, 1), repeat=12) if lawful([r], 3)]
    for _ in range(10):
        found = rng.integers(0, 3, (1, 12))
        start, weights, _ = grounds.laid(found, 3, 3, 1.0, "lice")
        cells = exact.solve(Task(start.astype(np.float32), start, 3, weights=weights))
        price = np.round(weights[0] * 1000)
        costs = [(price * (np.array(r) != start[0])).sum() for r in [tuple(cells[0]), *rows]]
        assert costs[0] == min(costs[1:])


def test_cuts_are_the_best_there_are():
    t = np.random.default_rng(2).random((40, 50)).astype(np.float32) ** 2
    for tones in (2, 3):
        at, share = regions.cuts(t, tones)
        v = np.floor(t * regions.BINS) / regions.BINS

        def within(at, v=v):
            groups = np.digitize(v, at)
            return sum(v[groups == k].var() * (groups == k).sum() for k in np.unique(groups))

        grid = [k / regions.BINS for k in range(1, regions.BINS)]
        best = min(within(c) for c in product(grid, repeat=tones - 1) if list(c) == sorted(c))
        assert within(at) == pytest.approx(best)
        assert 1 - best / (v.var() * v.size) == pytest.approx(share)


def test_regions_have_clean_borders():
    t = prepare.prepared(photo(), KnitParams(), 1.33, False)
    assert t.min() >= 0 and t.max() <= 1
    found, tones = regions.divided(t, None, False)
    assert tones == 3 and set(np.unique(found)) == {0, 1, 2}
    for k in range(3):
        island, _ = label(found == k, np.ones((3, 3)))
        assert np.bincount(island.ravel())[1:].min() > 1  # no single stitches
    piece = piece_of(photo(), gauge="24x32", technique="stranded")
    assert measure.facts(piece)["alone"] <= 2.0


def test_soft_lines_are_no_third_tone():
    """A thin line that falls between two stitches is grey in both."""
    t = np.ones((50, 50), np.float32)
    t[:, 4::8], t[:, 5::8], t[20:36, 30:46] = 0.5, 0.45, 0.0
    assert regions.cuts(t, 2)[1] < regions.ENOUGH
    found, tones = regions.divided(t, None, True)
    assert tones == 2 and set(np.unique(found)) == {0, 1}
    t[2:18, 2:18] = 0.5
    assert regions.divided(t, None, True)[1] == 3


def test_colours_of_one_lightness_stay_apart():
    rgb = np.zeros((40, 40, 3), np.uint8)
    rgb[:, :20], rgb[:, 20:] = (205, 92, 92), (70, 140, 190)
    grey = prepare.lightness(rgb)
    light = oklab(rgb)[0, :, 0]
    assert abs(light[0] - light[-1]) < 0.03 < 0.06 < abs(float(grey[0, 0] - grey[0, -1]))


def test_the_eye_is_the_one_published():
    """The kernel against a direct transform; the likeness against a second telling of it."""
    gauge = Gauge(24.0, 32.0)
    eye = sight.eye(5, gauge, 8.0)
    got = np.einsum("sa,sd->da", eye.across, eye.down)
    f = np.maximum(sight.frequencies((256, 256), gauge, 8.0), 8.0)
    h = 2.6 * (0.0192 + 0.114 * f) * np.exp(-((0.114 * f) ** 1.1))
    true = np.fft.ifft2(h * h).real[: got.shape[0], : got.shape[1]]
    assert np.abs(got / got[0, 0] - true / true[0, 0]).max() < 1e-3
    rng = np.random.default_rng(1)
    chart, picture = rng.integers(0, 2, (30, 24)), rng.random((30, 24))
    a = np.kron(chart.astype(float), np.ones((4, 4)))
    b = zoom(picture, 4, order=1, grid_mode=True, mode="nearest")
    degrees = np.degrees(1 / 2.0)
    f = np.hypot(*np.meshgrid(np.fft.fftfreq(96, 0.1 / 24 / 4 * degrees), np.fft.fftfreq(120, 0.1 / 32 / 4 * degrees)))
    h = 2.6 * (0.0192 + 0.114 * f) * np.exp(-((0.114 * f) ** 1.1))
    h[0, 0] = 0
    x, y = (np.fft.ifft2(np.fft.fft2(v - v.mean()) * h).real for v in (a, b))
    assert sight.likenesses(chart, picture, gauge, [2.0])[0] == pytest.approx(np.corrcoef(x.ravel(), y.ravel())[0, 1])
    assert sight.likenesses(chart, chart, None, [4.0])[0] > 0.5


@pytest.mark.slow
def test_sweeps_never_raise_the_energy_of_that_eye():
    rng = np.random.default_rng(3)
    aim = rng.random((20, 26)).astype(np.float32)
    eye = sight.eye(4, Gauge(24.0, 32.0), 6.0)
    down, across = eye.down.shape[1] - 1, eye.across.shape[1] - 1
    kernel = np.zeros((2 * down + 1, 2 * across + 1))
    for dy, dx in product(range(-down, down + 1), range(-across, across + 1)):
        kernel[dy + down, dx + across] = (eye.down[:, abs(dy)] * eye.across[:, abs(dx)]).sum()
    from scipy.signal import convolve2d

    def energy(cells):
        e = cells.astype(float) - aim
        return float((e * convolve2d(e, kernel, "same")).sum())

    task = Task(aim, np.zeros(aim.shape, np.uint8), 4)
    seen = [energy(percept.solve(task, eye, sweeps=n)) for n in (1, 2, 3, 6)]
    assert all(b <= a + 1e-3 for a, b in pairwise(seen))


def test_caught_floats_leave_the_picture_alone():
    piece = piece_of(photo(), floats="caught", gauge="24x32", max_float="5")
    chart, told = piece.chart, {**piece.figures, **facts(piece)}
    assert (chart.cells == piece.start).all() and told["flips"] == 0 and told["violations"] == 0
    assert told["longest_float"] > 5 and told["longest_span"] <= 5 and told["catches"] > 0
    marks = catches(chart, 5)
    free = 0
    for row, here in zip(chart.cells, marks):
        for stitch in range(1, 80):
            free = 1 if row[stitch] != row[stitch - 1] or stitch == 1 else free + 1
            free = 0 if here[stitch] else free
            assert free <= 5 or len(set(row.tolist())) == 1
    assert told["longest_span"] == longest_span(chart, 5, marks)
    above = marks[1:] & marks[:-1]
    assert above.sum() <= 0.02 * marks.sum()  # staggered


def test_limits_by_use():
    for params, limit in (
        ({}, 4),
        ({"gauge": "24x32"}, 6),
        ({"gauge": "16x22"}, 4),
        ({"gauge": "40x50"}, 7),
        ({"use": "mitten", "gauge": "30x34"}, 3),
        ({"machine": "kh930-ayab"}, 5),
        ({"max_float": "9"}, 9),
    ):
        assert limit_of(KnitParams(**params)) == limit


def test_what_one_sees_as_lines():
    cells = np.zeros((12, 30), np.uint8)
    cells[2:8, 5] = 1  # a bar of six
    cells[1:12:2, 20] = 1  # a dotted column of six
    cells[4, 12] = cells[8, 14] = 1
    assert measure.upright(cells) == pytest.approx(1000 * 12 / 360)
    assert measure.lone(cells).sum() == 8
    palette = Palette(np.array([[0, 0, 0], [255, 255, 255]], np.uint8), ("a", "b"))
    assert longest_span(Chart(cells, palette), 4, np.zeros(cells.shape, np.bool_)) == 30 - 6


def test_edits_in_a_ground_touch_their_rows_alone():
    piece = piece_of(photo(), gauge="24x32", max_float="5")
    again = resolve(piece, [(30, 40, 1 - int(piece.chart.cells[30, 40]))])
    changed = np.flatnonzero((again.chart.cells != piece.chart.cells).any(1))
    assert changed.tolist() == [30] and lawful(again.chart.cells, 5)
    assert again.figures["style"] == "graphic" and again.textured is not None


def test_light_on_clear_is_not_a_blank_chart():
    rgba = np.zeros((40, 40, 4), np.uint8)
    rgba[12:30, 8:30] = 255
    told = Progress()
    piece = make(Picture(rgba), KnitParams(floats="caught"), told)
    assert piece.chart.cells[15:25, 10:28].all() and not piece.chart.cells[:8].any()
    assert "light on clear" in str(told.warnings[0])
    rgba[..., :3] = 0
    assert not make(Picture(rgba), KnitParams(floats="caught"), Progress()).chart.cells[15:25, 10:28].any()


def test_flat_art_gets_its_own_colours():
    art = np.zeros((40, 40, 3), np.uint8)
    art[:, :10], art[:, 10:22], art[:, 22:30], art[:, 30:] = (200, 40, 40), (196, 42, 44), (240, 205, 160), (20, 20, 20)
    art[30:] = (250, 240, 225)
    found = shades.few(art, 4)
    assert {s.rgb for s in found} == {(196, 42, 44), (240, 205, 160), (20, 20, 20), (250, 240, 225)}
    assert shades.few(photo(), 4) == []


def test_what_a_style_has_no_part_for_is_said():
    told = Progress()
    rgba = np.dstack([photo(40, 40), np.full((40, 40), 255, np.uint8)])
    make(Picture(rgba), KnitParams(style="graphic", threshold=0.6), told)
    assert "they are for plain" in str(told.warnings[0])


def test_a_limit_of_one_is_answered():
    told = Progress()
    rgba = np.dstack([photo(20, 20), np.full((20, 20), 255, np.uint8)])
    make(Picture(rgba), KnitParams(max_float="1"), told)
    assert "every row is a check" in str(told.warnings[0])


def test_the_example_of_the_docs_runs(monkeypatch):
    """The Python of docs/knit.md, as it stands there."""
    here = Path(__file__).resolve().parents[1]
    monkeypatch.chdir(here)
    for code in re.findall(r"```python\n(.*?)```", (here / "docs" / "knit.md").read_text(), re.S):
        exec(compile(code, "docs/knit.md", "exec"), {})

"""Tone mapping, and the start assignments against plain twins."""

from __future__ import annotations

import numpy as np
import pytest

from tambour.knit.params import KnitParams
from tambour.knit.picture import tone
from tambour.knit.solve import texture
from tambour.knit.solve.floats import measure
from tambour.knit.task import Task


def floyd(t, level):
    """Floyd-Steinberg on a copy of the picture, row 0 on top: the twin."""
    a, out = t.astype(float).copy(), np.zeros(t.shape, np.uint8)
    for y in range(t.shape[0]):
        for x in range(t.shape[1]):
            out[y, x] = a[y, x] >= level
            e = a[y, x] - out[y, x]
            for dx, dy, w in ((1, 0, 7), (-1, 1, 3), (0, 1, 5), (1, 1, 1)):
                if 0 <= x + dx < t.shape[1] and y + dy < t.shape[0]:
                    a[y + dy, x + dx] += e * w / 16
    return out


def atkinson(t, level):
    a, out = t.astype(float).copy(), np.zeros(t.shape, np.uint8)
    for y in range(t.shape[0]):
        for x in range(t.shape[1]):
            out[y, x] = a[y, x] >= level
            e = (a[y, x] - out[y, x]) / 8
            for dx, dy in ((1, 0), (2, 0), (-1, 1), (0, 1), (1, 1), (0, 2)):
                if 0 <= x + dx < t.shape[1] and y + dy < t.shape[0]:
                    a[y + dy, x + dx] += e
    return out


@pytest.mark.parametrize("name, twin", [("floyd-steinberg", floyd), ("atkinson", atkinson)])
def test_error_diffusion_has_a_twin(name, twin):
    rng = np.random.default_rng(3)
    for shape in ((1, 1), (1, 9), (8, 1), (13, 17)):
        t = rng.random(shape).astype(np.float32)
        assert (tone.assign(t, name, 0.5)[::-1] == twin(t[::-1], 0.5)).all()


def test_thresholds_and_bayer():
    t = np.linspace(0, 1, 64, dtype=np.float32).reshape(8, 8)
    assert (tone.assign(t, "threshold", 0.25) == (t > 0.25)).all()
    flat = tone.assign(np.full((64, 64), 0.3, np.float32), "ordered", 0.5)
    assert flat.mean() == pytest.approx(0.3, abs=0.01)
    assert sorted((tone.bayer(1) * 4 - 0.5).astype(int).ravel().tolist()) == [0, 1, 2, 3]


@pytest.mark.parametrize("limit", [2, 4, 7])
def test_tones_are_drawn_into_reach(limit):
    t = np.array([[0, 0.5, 1]], np.float32)
    raw = tone.toned(t.copy(), KnitParams(tone="raw"), limit)
    full = tone.toned(t.copy(), KnitParams(tone="reachable"), limit)
    half = tone.toned(t.copy(), KnitParams(tone=0.5), limit)
    assert raw.tolist() == t.tolist()
    assert full[0] == pytest.approx([1 / (limit + 1), 0.5, limit / (limit + 1)])
    assert half == pytest.approx((raw + full) / 2)


def test_detail_keeps_fine_contrast():
    x = np.arange(96)
    t = (0.5 + 0.35 * np.sign(x - 48) + 0.05 * (-1.0) ** x)[None].repeat(96, 0).astype(np.float32)
    plain = tone.toned(t.copy(), KnitParams(), 4)
    kept = tone.toned(t.copy(), KnitParams(detail=1), 4)
    fine = np.abs(np.diff(kept[40, 5:40])).mean(), np.abs(np.diff(plain[40, 5:40])).mean()
    assert fine[0] > 1.3 * fine[1] and kept.min() >= 0.2 - 1e-6 and kept.max() <= 0.8 + 1e-6


def test_light_and_contrast():
    rgb = np.full((2, 2, 3), 188, np.uint8)
    assert tone.brightness(rgb, "code")[0, 0] == pytest.approx(188 / 255, abs=1e-6)
    assert tone.brightness(rgb, "linear")[0, 0] == pytest.approx(0.503, abs=2e-3)
    colour = np.array([[[255, 0, 0], [0, 255, 0], [0, 0, 255]]], np.uint8)
    assert tone.brightness(colour, "code")[0] == pytest.approx([0.299, 0.587, 0.114], abs=1e-6)
    t = tone.toned(np.array([[0.4, 0.6]], np.float32), KnitParams(tone="raw", contrast=2, brightness=0.1), 4)
    assert t[0] == pytest.approx([0.4, 0.8])


def test_drawings_and_photographs_are_told_apart():
    rng = np.random.default_rng(1)
    drawing = np.ones((80, 80), np.float32)
    drawing[20:60, 38:42] = 0.05
    drawing[38:42, 10:70] = 0
    assert tone.recognise(drawing) == "line drawing"
    assert tone.recognise(1 - drawing) == "line drawing"
    photograph = np.clip(np.linspace(0, 1, 80)[None] + 0.1 * rng.standard_normal((80, 80)), 0, 1).astype(np.float32)
    assert tone.recognise(photograph) == "photograph"
    assert tone.recognise(np.full((5, 5), 0.5, np.float32)) == "photograph"


@pytest.mark.parametrize("patches", ["ready", "noise"])
def test_patches_are_lawful_and_as_bright_as_asked(patches):
    params = KnitParams(start="patches", patches=patches)
    for limit in (2, 4, 6):
        tiles = texture.ready(limit) if patches == "ready" else texture.noise(limit, params)
        assert len(tiles) == texture.LEVELS
        for tile, mean in zip(tiles, texture.levels(limit)):
            wide = np.tile(tile, (1, 12))
            task = Task(np.zeros(wide.shape, np.float32), wide, limit)
            assert measure(task, wide).conflicts == 0
            assert tile.mean() == pytest.approx(float(mean), abs=0.09)


def test_marked_patches_come_from_the_picture():
    rng = np.random.default_rng(2)
    t = np.clip(0.5 + 0.1 * rng.standard_normal((40, 60)), 0.2, 0.8).astype(np.float32)
    params = KnitParams(start="patches", patches="marked", patch_from="4,4,12,10")
    out = texture.assign(t, 4, params)
    assert out.shape == t.shape and 0.35 < out.mean() < 0.65

"""Cloth: each stitch in its own colour, the back mirrored, floats as long as they are."""

from __future__ import annotations

import numpy as np
import pytest

from tambour.core.chart import Chart, Gauge
from tambour.core.palette import Palette
from tambour.knit.sheets.distance import distance
from tambour.knit.sheets.fabric import back, cell, front, pixels

WOOL = Palette(np.array([[235, 225, 205], [30, 40, 110]], np.uint8), ("natural", "indigo"))


def chart_of(rows: int, stitches: int, seed: int = 0, **fields: object) -> Chart:
    cells = np.random.default_rng(seed).integers(0, 2, (rows, stitches)).astype(np.uint8)
    return Chart(cells, WOOL, **fields)  # type: ignore[arg-type]


def test_a_cell_is_lit_by_its_neighbours_alone() -> None:
    one = cell(16, 1.25)
    assert one.light.shape[1:] == (13, 16) and (0, 0) in one.neighbours
    whole = one.light.sum(axis=0)
    assert (whole > 0).mean() > 0.97  # stranded cloth is dense: hardly a hole
    own = one.light[one.neighbours.index((0, 0))].sum() / whole.sum()
    assert 0.4 < own < 0.9
    # The stitch is a V: its two legs mirror each other, but for the light from the left.
    mine = one.light[one.neighbours.index((0, 0))] > 0
    assert (mine == mine[:, ::-1]).mean() > 0.93


def test_each_stitch_shows_its_yarn() -> None:
    chart = chart_of(12, 15, gauge=Gauge(22, 30))
    picture = front(chart, 16)
    high = picture.rgba.shape[0] // 12
    assert picture.rgba.shape[1] == 15 * 16 and picture.pixel == pytest.approx(100 / 22 / 16)
    mean = picture.rgba[..., :3].reshape(12, high, 15, 16, 3).mean(axis=(1, 3))[::-1]
    rgb = chart.palette.rgb.astype(float)
    nearest = np.abs(mean[..., None, :] - rgb * 0.8).sum(axis=-1).argmin(axis=-1)
    assert (nearest == chart.cells).mean() > 0.95


def test_the_back_is_the_front_turned_over_with_floats() -> None:
    cells = np.zeros((9, 30), np.uint8)
    cells[4, 5] = cells[4, 18] = 1
    chart = Chart(cells, WOOL)
    plain = back(Chart(cells * 0, WOOL), width=12).rgba[..., :3].astype(int)
    seen = back(chart, anchored=False, width=12).rgba[..., :3].astype(int)
    changed = np.abs(seen - plain).sum(axis=-1) > 60
    columns = np.flatnonzero(changed.any(axis=0)) / 12
    # Between the two stitches of the second yarn, mirrored: from column 30 - 19 to 30 - 5, and their own bumps.
    assert columns.min() == pytest.approx(30 - 19, abs=0.7) and columns.max() == pytest.approx(30 - 5, abs=0.7)
    blue = (seen[..., 2] - seen[..., 0] > 15).any(axis=0)
    run = np.flatnonzero(blue)
    assert (np.diff(run) == 1).mean() > 0.97  # one unbroken strand of the indigo yarn
    assert np.ptp(run) / 12 == pytest.approx(14, abs=0.8)


def test_edges_without_stitch_show_the_table() -> None:
    absent = np.zeros((8, 8), np.bool_)
    absent[:, :3] = True
    picture = front(chart_of(8, 8, no_stitch=absent), 12).rgba
    assert picture[:, :12, :3].min() > 200 and picture[:, 50:80, :3].min() < 120


@pytest.mark.slow
def test_pictures_keep_to_a_size_and_their_bytes() -> None:
    assert pixels(chart_of(10, 10), 1.0) == 28
    big = chart_of(500, 500)
    picture = front(big)
    assert 3e6 < picture.rgba[..., 0].size < 9e6
    small = chart_of(6, 9, circular=True)
    assert (back(small).rgba == back(small).rgba).all()


@pytest.mark.parametrize("light", [False, True])
def test_from_a_distance_target_and_knitting_stand_side_by_side(light: bool) -> None:
    chart = Chart(np.indices((40, 60)).sum(axis=0).astype(np.uint8) % 2, WOOL, gauge=Gauge(22, 30))
    tone = np.full((40, 60), 0.5, np.float32)
    drawing = distance(chart, np.full((40, 60, 3), 128, np.uint8), tone, light)
    assert len(drawing.images) == 6 and [w.text for w in drawing.labels if w.bold] == ["source", "aimed at", "knitted"]
    knitted = drawing.images[5].picture.rgba[..., :3].astype(int)
    assert np.ptp(knitted.reshape(-1, 3), axis=0).max() <= 3  # a check melts into one tone
    if not light:
        assert np.abs(knitted - drawing.images[4].picture.rgba[..., :3]).max() <= 3
    assert "seen from about" in drawing.labels[0].text or any("seen from about" in w.text for w in drawing.labels)

"""Machines: limits said plainly, and a card that tells how to set up."""

from __future__ import annotations

import numpy as np
import pytest

from tambour.core.chart import Chart
from tambour.core.palette import Palette
from tambour.knit.machines.limits import MODELS, check, end_needles, needles, period, steps
from tambour.knit.params import KnitParams
from tambour.knit.sheets.setup import card

WOOL = Palette(np.array([[240, 230, 210], [30, 40, 90]], np.uint8), ("natural", "indigo"))


def chart_of(rows: int, stitches: int, **fields: object) -> Chart:
    cells = np.random.default_rng(0).integers(0, 2, (rows, stitches)).astype(np.uint8)
    return Chart(cells, WOOL, **fields)  # type: ignore[arg-type]


@pytest.mark.slow
def test_the_params_know_the_same_machines() -> None:
    schema = KnitParams.model_json_schema()["properties"]["machine"]
    assert sorted(schema["anyOf"][0]["enum"]) == sorted(MODELS)


def test_limits_are_said_at_once() -> None:
    wide = chart_of(4, 250, no_stitch=np.eye(4, 250, dtype=bool), circular=True)
    text = "\n".join(map(str, check(wide, "kh930-ayab")))
    assert "200 needles" in text and "--stitches 200" in text and "by hand" in text and "knits flat" in text
    assert check(chart_of(4, 200), "kh930-ayab") == []
    assert "112 needles" in str(check(chart_of(4, 113), "kh270-ayab")[0])
    assert "repeats every 24" in str(check(chart_of(4, 50), "brother-card")[0])
    three = Chart(np.array([[0, 1], [0, 2]], np.uint8), Palette(np.array([[0] * 3, [9] * 3, [99] * 3], np.uint8)))
    assert "two yarns" in str(check(three, "kh940-disk")[0]) and check(three, "kniterate") == []


def test_needles_are_counted_from_the_middle() -> None:
    assert needles(120) == "L60 to R60" and needles(121) == "L61 to R60"


def test_repeats_of_a_card() -> None:
    unit = np.random.default_rng(1).integers(0, 2, (5, 8)).astype(np.uint8)
    assert period(Chart(np.tile(unit, (1, 6)), WOOL)) == 8
    assert period(Chart(np.tile(unit, (1, 7))[:, :50], WOOL)) == 8
    assert period(chart_of(5, 50)) == 0
    assert period(chart_of(5, 24)) == 24


def test_the_card_tells_colours_edges_and_the_side_that_faces_you() -> None:
    chart = chart_of(30, 60)
    words = " ".join(steps(chart, "kh930-ayab", anchored=True))
    assert "L30 to R30" in words and "KC I (" in words and "purl side faces you" in words
    main = "natural" if (chart.cells == 0).sum() >= (chart.cells == 1).sum() else "indigo"
    assert f"Feeder A (needles not selected): MC {main}" in words
    assert f"{end_needles(chart)} of 60" in words
    assert "KC II" in " ".join(steps(chart, "kh930-ayab", anchored=False))
    assert "point cams" in " ".join(steps(chart, "silver-reed-card", anchored=True))


@pytest.mark.parametrize("name", sorted(MODELS))
def test_every_machine_has_a_card_that_fits_its_page(name: str) -> None:
    from tambour.render.type import typeface

    skia = pytest.importorskip("skia")
    drawing = card(chart_of(48, 24), name, True, "Test")
    assert len(drawing.images) == 2
    right, left = (it.picture.rgba for it in drawing.images)
    assert (right == left[:, ::-1]).all()
    for label in drawing.labels:
        width = skia.Font(typeface(label.bold), 100).measureText(label.text) * label.size / 100
        assert label.x + width <= 148 - 4 and label.y <= 210
    for it in drawing.images:
        assert it.y + it.height <= 205

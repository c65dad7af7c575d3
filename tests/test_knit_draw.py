"""The printed chart: every stitch on some page, numbers where knitters look for them, pages that render."""

from __future__ import annotations

from typing import get_args

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tambour import files
from tambour.color import luminance
from tambour.core.chart import Chart, Gauge
from tambour.core.drawing import Drawing
from tambour.core.errors import TambourError
from tambour.core.palette import Palette
from tambour.knit.hands.yarn import amounts
from tambour.knit.sheets.draw import Look, float_sheet, sheet_of, sign
from tambour.knit.sheets.fabric import front
from tambour.knit.sheets.pages import MARGIN, OVERLAP, Paper, Words, booklet, layout

WOOL = Palette(np.array([[240, 230, 210], [30, 40, 90]], np.uint8), ("natural", "indigo"))


def chart_of(rows: int, stitches: int, seed: int = 0, **fields: object) -> Chart:
    cells = np.random.default_rng(seed).integers(0, 2, (rows, stitches)).astype(np.uint8)
    return Chart(cells, WOOL, **fields)  # type: ignore[arg-type]


def book(chart: Chart, look: Look | None = None, **options: object) -> tuple[Drawing, ...]:
    words = Words("Test piece", 4, 4, "dk")
    return booklet(chart, look or Look(limit=4), words, amounts(chart), front(chart, 4), **options)  # type: ignore[arg-type]


@given(
    rows=st.integers(1, 300),
    stitches=st.integers(1, 300),
    page=st.sampled_from(sorted(get_args(Paper))),
    aspect=st.sampled_from([1.0, 1.36, 0.8]),
    large=st.booleans(),
)
@settings(max_examples=60)
def test_tiles_cover_the_chart_and_fit_the_page(
    rows: int, stitches: int, page: str, aspect: float, large: bool
) -> None:
    plan = layout(chart_of(rows, stitches), page, aspect, large)  # type: ignore[arg-type]
    seen = np.zeros((rows, stitches), int)
    for w in plan.windows:
        assert 0 <= w.bottom < w.top <= rows and 0 <= w.left < w.right <= stitches
        seen[w.bottom : w.top, w.left : w.right] += 1
        assert (w.right - w.left) * plan.cell[0] <= plan.page[0] - 2 * MARGIN + 1e-6
        assert (w.top - w.bottom) * plan.cell[1] <= plan.page[1] - 2 * MARGIN + 1e-6
    assert seen.min() >= 1
    assert plan.cell[0] / plan.cell[1] == pytest.approx(aspect)  # gauge-true
    assert min(plan.cell) >= (6.4 if large else 2.7)
    if len(plan.windows) > 1:
        first, second = plan.windows[0], plan.windows[1]
        shared = second.right - first.left if plan.across > 1 else first.top - second.bottom
        assert shared == OVERLAP


def test_large_cells_are_larger() -> None:
    chart = chart_of(90, 90)
    small, large = layout(chart), layout(chart, large=True)
    assert min(large.cell) > 1.5 * min(small.cell) and len(large.windows) > len(small.windows)


def test_numbers_stand_on_the_working_side() -> None:
    drawing = sheet_of(chart_of(12, 8), Look(cell=(5, 5)))
    left = {label.text for label in drawing.labels if label.x < 14 and label.anchor == "end"}
    right = {label.text for label in drawing.labels if label.x > 14 + 40 and label.anchor == "start"}
    assert left == {str(n) for n in range(2, 13, 2)} and right == {str(n) for n in range(1, 13, 2)}
    drawing = sheet_of(chart_of(12, 8, circular=True), Look(cell=(5, 5)))
    assert not [label for label in drawing.labels if label.x < 14 and label.anchor == "end"]
    right = {label.text for label in drawing.labels if label.x > 14 + 40 and label.anchor == "start"}
    assert right == {str(n) for n in range(1, 13)}
    row = [label for label in drawing.labels if label.anchor == "middle"]
    assert [label.text for label in sorted(row, key=lambda it: -it.x)] == [str(n) for n in range(1, 9)]
    assert {label.text for label in drawing.labels if label.bold} >= {"10"}


def test_signs_tell_colours_apart_without_colour() -> None:
    palette = Palette(np.array([[v, v, v] for v in (10, 80, 150, 220)], np.uint8))
    cells = np.array([[0, 1, 0, 0], [0, 2, 0, 2], [3, 0, 3, 0]], np.uint8)
    chart = Chart(cells, palette)
    assert len({sign(chart, c) for c in range(4)}) == 4
    drawing = sheet_of(chart, Look(cells="symbol"))
    filled = drawing.styles.fill[drawing.style][:, :3]
    assert (luminance(filled[drawing.styles.fill[drawing.style][:, 3] > 0]) < 0.05).all()  # ink alone


def test_every_colour_and_sign_is_drawn_at_its_stitch() -> None:
    chart = chart_of(9, 7, 3)
    drawing = sheet_of(chart, Look(cell=(5.0, 4.0)))
    marks = np.zeros(chart.shape, bool)
    for shape in range(len(drawing)):
        first, last = drawing.paths.parts[shape], drawing.paths.parts[shape + 1]  # type: ignore[index]
        for ring in range(first, last):
            xy = drawing.paths[ring]
            wide, high = np.ptp(xy, axis=0)
            if wide == pytest.approx(high) and 1.5 < wide < 2.2 and len(xy) == 17:  # the dot
                x, y = (xy.min(axis=0) + xy.max(axis=0)) / 2
                c, r = (x - 14) / 5 - 0.5, (16 - 8 + 9 * 4 - y) / 4 - 0.5
                if -0.1 < c < 7 and -0.1 < r < 9:
                    marks[round(r), round(c)] = True
    less = int(np.bincount(chart.cells.ravel()).argmin())
    assert (marks == (chart.cells == less)).all()


@pytest.mark.slow
def test_the_booklet_is_a_pdf_of_whole_pages(tmp_path) -> None:
    pdfium = pytest.importorskip("pypdfium2")
    chart = chart_of(120, 110, gauge=Gauge(22, 30))
    pages = book(chart, Look(limit=4, dominant=1), swatch=True)
    files.write(pages, tmp_path / "book.pdf", "Drawing")
    document = pdfium.PdfDocument(tmp_path / "book.pdf")
    assert len(document) == len(pages)
    texts = []
    for page, drawing in zip(document, pages):
        assert sorted(page.get_size()) == pytest.approx(sorted(s * 72 / 25.4 for s in (210, 297)), abs=1)
        for label in drawing.labels:
            assert -0.1 <= label.x <= drawing.size[0] and 0 <= label.y <= drawing.size[1], label
        texts.append(page.get_textpage().get_text_bounded())
        image = np.asarray(page.render(scale=0.5).to_pil().convert("L"))
        assert image.std() > 5  # something is on it
    assert "Test piece" in texts[0] and "dominant" in texts[0] and " m / " in texts[0]
    assert "swatch" in texts[1] and "--gauge" in texts[1]
    tiles = len(layout(chart, "a4", 30 / 22).windows)
    assert all("rows" in t and "stitches" in t for t in texts[2 : 2 + tiles]) and len(pages) > 2 + tiles
    assert "catch at" in texts[2 + tiles] and "behind" in texts[-1]
    files.write(pages, tmp_path / "again.pdf", "Drawing")
    assert (tmp_path / "book.pdf").read_bytes() == (tmp_path / "again.pdf").read_bytes()


def test_no_list_without_long_floats() -> None:
    chart = Chart(np.tile([[0, 1], [1, 0]], (15, 15)).astype(np.uint8), WOOL)
    assert len(book(chart)) == 2


def test_float_sheet_counts() -> None:
    chart = Chart(np.array([[1, 0, 0, 0, 0, 0, 0, 1, 1, 1]], np.uint8), WOOL)
    words = " ".join(label.text for label in float_sheet(chart, Look(limit=4)).labels)
    assert "3 to 4 stitches: 1" in words and "above 4: to be caught: 1" in words and "longest 6" in words


def test_shaped_and_repeating_charts_are_drawn() -> None:
    absent = np.zeros((20, 48), np.bool_)
    absent[:, :3] = absent[15:, 40:] = True
    chart = chart_of(20, 48, no_stitch=absent, circular=True)
    drawing = sheet_of(chart, Look(repeat=24, limit=3))
    words = [label.text for label in drawing.labels]
    assert "no stitch: skip this square" in words and "repeat of 24 stitches" in words


def test_what_nobody_prints_is_refused() -> None:
    huge = Chart(np.zeros((1100, 1000), np.uint8), WOOL)
    shown, words = front(chart_of(2, 2)), Words("Huge", 4, 4, "dk")
    for draw in (
        lambda: sheet_of(huge, Look()),
        lambda: float_sheet(huge, Look()),
        lambda: booklet(huge, Look(), words, [], shown),
    ):
        with pytest.raises(TambourError, match="too many to draw"):
            draw()

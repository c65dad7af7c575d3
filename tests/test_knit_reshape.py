"""Rows and columns that come in and go, and runs of stitches: as numbers in numpy, with the law kept."""

from __future__ import annotations

import numpy as np
import pytest

from tambour.core.chart import Chart, Gauge
from tambour.core.errors import TambourError
from tambour.core.palette import Palette
from tambour.knit.piece import Piece
from tambour.run import craft, make

WOOL = Palette(np.array([[20, 30, 90], [240, 230, 210], [180, 30, 30]], np.uint8))
WHAT = craft("knit")


def made(cells: np.ndarray, *edits: str, **values: object) -> Piece:
    chart = Chart(cells.astype(np.uint8), WOOL if cells.max() > 1 else Palette(WOOL.rgb[:2]))
    piece: Piece = make(WHAT, chart, WHAT.params.of(values), edits).piece
    return piece


def lawful(seed: int, rows: int = 9, stitches: int = 11) -> np.ndarray:
    """Cells whose runs are short."""
    shade = np.random.default_rng(seed).integers(0, 2, (rows, stitches))
    shade[:, ::3], shade[:, 1::3] = 0, 1
    return shade


@pytest.mark.parametrize("seed", range(4))
def test_rows_and_columns_come_in_and_go_as_in_numpy(seed):
    cells, at, n = lawful(seed), 2 + seed, 1 + seed
    assert (made(cells, f"rows:{at}={n}").chart.cells == np.insert(cells, [at - 1] * n, cells[at - 1], 0)).all()
    assert (made(cells, f"rows:{at}=-{n}").chart.cells == np.delete(cells, range(at - 1, at - 1 + n), 0)).all()
    mirror = cells[:, ::-1]
    wider = np.insert(mirror, [at - 1] * n, mirror[:, at - 1 : at], 1)[:, ::-1]
    free = {"method": "none"}  # stitches alike beside each other may be too many: the law is another test's
    assert (made(cells, f"columns:{at}={n}", **free).chart.cells == wider).all()
    narrower = np.delete(mirror, range(at - 1, at - 1 + n), 1)[:, ::-1]
    assert (made(cells, f"columns:{at}=-{n}", **free).chart.cells == narrower).all()
    assert (made(cells, "rows:10=2").chart.cells[-3:] == cells[-1]).all()
    assert (made(cells, f"rows:{at}={n}", f"rows:{at}=-{n}").chart.cells == cells).all()


def test_the_law_holds_afterwards_and_what_was_held_stays():
    piece = made(lawful(1), "stitch:4,3=2", "columns:3=9", "run:5,1,4=1", max_float=4)
    assert piece.figures["violations"] == 0
    assert piece.chart.locked is not None
    assert piece.chart.locked[3].nonzero()[0].tolist() == [8]  # the stitch that was third is held, its copies are not
    assert piece.chart.locked[4].nonzero()[0].tolist() == [16, 17, 18, 19]
    assert (piece.chart.cells[4, 16:] == 0).all() and piece.chart.cells[3, 8] == 1


def test_a_picture_s_chart_keeps_its_stitches_when_rows_come_in():
    from tambour.core.picture import Picture

    grey = np.tile(np.linspace(0, 255, 40, dtype=np.uint8), (30, 1))
    picture = Picture(np.dstack([grey] * 3 + [np.full_like(grey, 255)]))
    params = WHAT.params.of({"stitches": 20})
    plain: Piece = make(WHAT, picture, params).piece
    taller: Piece = make(WHAT, picture, params, ["rows:3=2", "rows:1=-1"]).piece
    cells = plain.chart.cells
    assert (taller.chart.cells == np.delete(np.insert(cells, [2, 2], cells[2], 0), 0, 0)).all()


def test_what_was_asked_of_a_chart_holds_when_it_grows():
    """The limit of its use, its gauge, and yarns that are told by the colours they had."""
    grown = made(lawful(1), "columns:3=9", use="mitten", gauge="24x32", yarn=("poppy=#141e5a",))
    assert grown.limit == grown.figures["max_float"] == 3 and grown.figures["violations"] == 0
    assert grown.figures["longest_float"] <= 3 and grown.chart.gauge == Gauge(24, 32)
    assert grown.chart.palette.names[0] == "poppy"


def test_a_chart_keeps_floats_that_are_caught_and_tells_what_it_does_not_heed():
    cells = np.zeros((4, 30), np.uint8)
    cells[1:3, 12:15] = 1
    assert (made(cells, floats="caught").chart.cells == cells).all()
    assert (made(cells).chart.cells != cells).any()
    told = make(
        WHAT, Chart(cells, Palette(WOOL.rgb[:2])), WHAT.params.of({"stitches": 9, "border": 2, "gauge": "20x30"})
    )
    assert [w.where for w in told.progress.warnings] == ["{--stitches}", "{--border}"]


def test_a_blank_picture_is_told():
    from tambour.core.picture import Picture

    blank, spot = np.zeros((20, 20, 4), np.uint8), np.full((20, 20, 4), 255, np.uint8)
    spot[5:9, 5:9, :3] = 0
    told = [make(WHAT, Picture(p), WHAT.params.of({"gauge": "24x32"})).progress.warnings for p in (blank, spot)]
    assert ["one colour" in str(w) for w in told[0]] == [True] and not told[1]


@pytest.mark.parametrize("edit", ["rows:30=1", "rows:1=-9", "rows:1=-20", "columns:13=1", "rows:10=-1", "run:3,9,9=1"])
def test_what_is_not_there_is_told(edit):
    with pytest.raises(TambourError):
        made(lawful(2), edit)

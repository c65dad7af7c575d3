"""Views: every one of every odd chart gives its file, or says why not."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from tambour.core.chart import Chart, Gauge
from tambour.core.errors import TambourError
from tambour.core.palette import Palette
from tambour.core.picture import Picture
from tambour.knit.params import KnitParams
from tambour.knit.views import VIEWS
from tambour.run import run

WOOL = Palette(np.array([[240, 230, 210], [30, 40, 90]], np.uint8), ("natural", "indigo"))
THREE = Palette(np.array([[240, 230, 210], [30, 40, 90], [170, 40, 40]], np.uint8))
CHECK = (np.indices((24, 24)).sum(axis=0) % 2).astype(np.uint8)
CHARTS = {
    "one stitch": Chart(np.zeros((1, 1), np.uint8), WOOL),
    "one colour": Chart(np.zeros((5, 9), np.uint8), Palette(np.array([[9, 9, 9]], np.uint8))),
    "a column": Chart(CHECK[:, :1], WOOL),
    "a round": Chart(CHECK[:1, :6], WOOL, circular=True),
    "shaped": Chart(CHECK[:8, :8], WOOL, no_stitch=np.eye(8, dtype=np.bool_)),
    "empty rows": Chart(CHECK[:4, :6], WOOL, no_stitch=np.indices((4, 6))[0] % 2 == 0),
    "plain": Chart(CHECK, WOOL, gauge=Gauge(20, 20)),
    "intarsia": Chart(np.arange(24)[None].repeat(9, 0).astype(np.uint8) // 8, THREE, technique="intarsia"),
    "jacquard": Chart(np.arange(9)[None].repeat(9, 0).astype(np.uint8) % 3, THREE, technique="jacquard"),
}
TECHNIQUE = (
    "double bed",
    "knitted round",
    "knitout is not",
    "laid in by hand",
    "two yarns",
    "two colours",
    "needs two",
    "24",
)
SUFFIX = {
    "Chart": (".png", ".csv"),
    "Disk": (".img", ".dat"),
    "dict": (".json",),
    "Drawing": (".pdf",),
    "Text": (".txt",),
    "Packed": (".pack",),
}
EXPECTED = ("too few for a machine", "shaped chart", "knits flat", "leave stitches out", "the disk holds", *TECHNIQUE)


@pytest.mark.slow
@pytest.mark.parametrize("name", CHARTS)
def test_every_view_of_odd_charts(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    refused = []
    if name != "plain":  # what a mesh looks like is slow, and no other where the chart is odd
        grey = Picture(np.full((4, 4, 4), 128, np.uint8))
        monkeypatch.setattr("tambour.render.raster.picture", lambda *_, **__: grey)
    for view, it in VIEWS.items():
        for suffix in SUFFIX.get(it.value, (".png",)):
            params = KnitParams(check=True, swatch=True, machine="kniterate" if view == "card" else None)
            try:
                run("knit", CHARTS[name], params, [tmp_path / f"x.{view}{suffix}"])
            except TambourError as error:
                assert any(words in str(error) for words in EXPECTED), error
                refused.append(f"{view}{suffix}")
            else:
                assert list(tmp_path.glob(f"x.{view}*{suffix}"))
    if name == "plain":
        assert refused == ["worn.png", "separated.png", "separated.csv"]


def test_the_machine_card_wants_a_machine(tmp_path: Path) -> None:
    with pytest.raises(TambourError, match="say which"):
        run("knit", CHARTS["plain"], KnitParams(check=True), [tmp_path / "x.card.pdf"])
    with pytest.raises(TambourError, match="112 needles"):
        wide = Chart(np.tile(CHECK, (1, 5)), WOOL)
        run("knit", wide, KnitParams(check=True, machine="kh270-ayab"), [tmp_path / "x.png"])
    assert list(tmp_path.iterdir()) == []


def test_the_report_counts_yarn_and_catches(tmp_path: Path) -> None:
    cells = CHECK.copy()
    cells[5, 3:14] = 0
    report = run("knit", Chart(cells, WOOL, gauge=Gauge(20, 20)), KnitParams(check=True), [tmp_path / "x.png"])
    assert report["catches"] == 2 and report["ladders"] == 0
    assert [y["role"] for y in report["yarn"]] == ["MC", "CC"]
    assert {"name", "stitches", "metres", "yards", "grams", "skeins"} <= set(report["yarn"][0])

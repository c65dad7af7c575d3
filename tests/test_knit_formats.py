"""Charts in files: what is written is read back by readers written here from the published layouts."""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from PIL import Image

from tambour import files
from tambour.core.chart import Chart, Disk, Gauge
from tambour.core.errors import TambourError
from tambour.core.palette import Palette
from tambour.files.brother import memory
from tambour.knit.machines.interchange import dak, silverknit
from tambour.knit.sheets.punchcard import card, holes

WOOL = Palette(np.array([[240, 230, 210], [30, 40, 90]], np.uint8), ("natural", "indigo"), ("N1", ""))
FOUR = Palette(np.array([[240, 230, 210], [30, 40, 90], [200, 60, 50], [90, 140, 80]], np.uint8), ("a", "b", "c", "d"))


def random_chart(rows: int, stitches: int, seed: int = 0, **fields: object) -> Chart:
    cells = np.random.default_rng(seed).integers(0, 2, (rows, stitches)).astype(np.uint8)
    return Chart(cells, WOOL, **fields)  # type: ignore[arg-type]


@st.composite
def charts(draw: st.DrawFn) -> Chart:
    rows, stitches = draw(st.integers(1, 7)), draw(st.integers(1, 19))
    rng = np.random.default_rng(draw(st.integers(0, 2**32)))
    yarns = draw(st.sampled_from([2, 4]))
    pairs = np.array([rng.choice(yarns, 2, replace=False) for _ in range(rows)])
    cells = np.take_along_axis(pairs, rng.integers(0, 2, (rows, stitches)), axis=1).astype(np.uint8)
    masks = {
        name: rng.random((rows, stitches)) < 0.3 for name in ("no_stitch", "relaxed", "locked") if draw(st.booleans())
    }
    return Chart(
        cells,
        WOOL if yarns == 2 else FOUR,
        circular=draw(st.booleans()),
        gauge=draw(st.sampled_from([None, Gauge(22, 30.5)])),
        **masks,
    )


def same(a: Chart, b: Chart, masks: tuple[str, ...] = ("no_stitch", "relaxed", "locked")) -> None:
    kept = np.ones(a.cells.shape, np.bool_) if a.no_stitch is None else ~a.no_stitch
    assert (a.palette.rgb[a.cells][kept] == b.palette.rgb[b.cells][kept]).all()
    for name in masks:
        mine, other = (np.zeros(a.cells.shape) if m is None else m for m in (getattr(a, name), getattr(b, name)))
        assert (mine == other).all(), name


@pytest.mark.slow
@given(chart=charts())
def test_a_project_is_lossless(chart: Chart, tmp_path_factory: pytest.TempPathFactory) -> None:
    path = tmp_path_factory.mktemp("p") / "chart.json"
    files.write(chart, path)
    back = files.read(path, ("Chart",))
    same(chart, back)
    assert (back.cells == chart.cells).all() and back.palette.codes == chart.palette.codes
    assert back.palette.names == chart.palette.names
    assert back.circular == chart.circular and back.gauge == chart.gauge


@pytest.mark.slow
@given(chart=charts())
def test_pixels_and_tables_come_back(chart: Chart, tmp_path_factory: pytest.TempPathFactory) -> None:
    folder = tmp_path_factory.mktemp("p")
    files.write(chart, folder / "chart.png")
    back = files.read(folder / "chart.png", ("Chart",))
    same(chart, back, ("no_stitch",))
    assert back.circular == chart.circular and back.gauge == chart.gauge and back.palette.names == chart.palette.names
    if chart.no_stitch is None or not chart.no_stitch.all():
        files.write(chart, folder / "chart.csv")
        same(chart, files.read(folder / "chart.csv", ("Chart",)), ("no_stitch",))


def test_the_png_is_what_loaders_want(tmp_path) -> None:
    chart = random_chart(5, 9)
    files.write(chart, tmp_path / "chart.png")
    image = Image.open(tmp_path / "chart.png")
    assert image.mode == "P" and image.size == (9, 5)
    raw = (tmp_path / "chart.png").read_bytes()
    assert raw[24] == 1 and raw[25] == 3  # IHDR: one bit a pixel, indexed
    assert (np.asarray(image) == chart.cells[::-1]).all()  # upright: the cast-on row is the lowest
    assert (np.asarray(image.convert("RGB")) == chart.palette.rgb[chart.cells[::-1]]).all()


def test_charts_of_other_programs_are_read(tmp_path) -> None:
    Image.fromarray(np.array([[255, 0, 255], [0, 0, 255]], np.uint8)).save(tmp_path / "grey.png")
    chart = files.read(tmp_path / "grey.png", ("Chart",))
    assert chart.cells.tolist() == [[1, 1, 0], [0, 1, 0]]  # the lightest is the ground
    (tmp_path / "table.csv").write_text("x;.;.\n.;x;x\n")
    chart = files.read(tmp_path / "table.csv", ("Chart",))
    assert chart.cells.tolist() == [[0, 1, 1], [1, 0, 0]] and chart.palette.names == (".", "x")


@pytest.mark.parametrize(
    ("name", "content", "words"),
    [
        ("a.json", "{", "not JSON"),
        ("b.json", "[]", "not a chart"),
        ("c.json", '{"format": "tambour chart 1"}', "'rows' is missing"),
        ("d.json", json.dumps({**random_chart(2, 3).plain(), "cells": {"1": "01", "2": "010"}}), "holds 2 stitches"),
        ("d2.json", json.dumps({**random_chart(2, 3).plain(), "cells": {"1": "010"}}), "holds 1 rows"),
        ("e.csv", "1,0,1\n1,0\n", "row 2 of the table has 2 fields"),
        ("f.csv", "", "empty"),
        ("g.csv", "1,2,3\n", "holds 3 colours"),
        ("h.png", "no", "cannot be read"),
        ("i.k", "knit + f1 1\n", "begins with"),
    ],
)
def test_what_is_no_chart_is_said(tmp_path, name: str, content: str, words: str) -> None:
    (tmp_path / name).write_text(content)
    with pytest.raises(TambourError, match=words):
        files.read(tmp_path / name, ("Chart",))


def test_a_photograph_is_no_chart(tmp_path) -> None:
    noise = np.random.default_rng(0).integers(0, 255, (20, 20, 3)).astype(np.uint8)
    Image.fromarray(noise).save(tmp_path / "photo.png")
    with pytest.raises(TambourError, match="a picture, not a chart"):
        files.read(tmp_path / "photo.png", ("Chart",))


def test_a_picture_cut_amid_its_pixels_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "a.png"
    files.write(Chart(np.zeros((3, 4), np.uint8), WOOL), path)
    raw = path.read_bytes()
    path.write_bytes(raw[: raw.index(b"IDAT") + 6])  # cut amid its pixels
    with pytest.raises(TambourError, match="cannot be read"):
        files.read(path, ("Chart",))


# --- SilverKnit and DesignaKnit text


def test_more_yarns_than_a_text_holds_are_refused() -> None:
    def of(count: int) -> Chart:
        shades = np.repeat(np.arange(count, dtype=np.uint8)[:, None] * 20, 3, axis=1)
        return Chart(np.arange(count, dtype=np.uint8)[:, None].repeat(12, axis=1), Palette(shades))

    with pytest.raises(TambourError, match=r"holds two yarns, this chart has 3"):
        silverknit(of(3))
    with pytest.raises(TambourError, match=r"holds ten yarns, this palette 11"):
        dak(of(11), "x")
    assert "Yarn 9 :" in dak(of(10), "x").text


def test_silverknit_text_is_read_back() -> None:
    chart = random_chart(6, 11, 3)
    head, *rows = silverknit(chart).text.splitlines()
    assert head == "SilverKnit" and set("".join(rows)) <= {"7", "8"}
    main = np.bincount(chart.cells.ravel()).argmax()
    read = np.array([[int(c) - 7 for c in row] for row in reversed(rows)])
    assert ((read == 0) == (chart.cells == main)).all()


def test_dak_text_is_read_back() -> None:
    chart = random_chart(6, 11, 4, gauge=Gauge(24, 32))
    lines = dak(chart, "Test").text.splitlines()
    assert lines[0] == "FILE FORMAT : DAK" and lines[-1] == "END"

    def block(name: str, until: str) -> list[str]:
        return lines[lines.index(name) + 1 : lines.index(until)]

    told = dict(line.split(" : ", 1) for line in lines if " : " in line)
    assert told["Stitches"] == "0" and int(lines[lines.index("Rows : 6") - 1].split()[-1]) == 11
    palette = {}
    for line in block("YARN PALETTE", "STITCH SYMBOLS"):
        found = re.fullmatch(r"Yarn (\S+) : (\d+),(\d+),(\d+)(?: (.*))?", line)
        assert found
        palette[found[1]] = tuple(map(int, found.groups()[1:4]))
    yarns = block("YARNS", "YARN PALETTE")
    rgb = np.array([[palette[c] for c in row] for row in reversed(yarns)])
    assert (rgb == chart.palette.rgb[chart.cells]).all()
    symbols = block("STITCH SYMBOLS", "STITCH PATTERN NOTES")
    assert [len(s) for s in symbols] == [11] * 6 and set("".join(symbols)) == {"."}
    tension = lines.index("MAIN TENSIONS")
    assert lines[tension + 1].endswith("= 24".replace("= ", "=  ")) and lines[tension + 2].endswith("32")


def test_text_formats_say_what_they_cannot_hold() -> None:
    shaped = random_chart(3, 4, no_stitch=np.eye(3, 4, dtype=bool))
    with pytest.raises(TambourError, match="leave stitches out"):
        silverknit(shaped)
    assert " " in dak(shaped, "x").text.split("YARNS\n")[1].splitlines()[0] + dak(shaped, "x").text.splitlines()[17]


# --- Brother's disk, read from its published memory map


def read_disk(image: bytes) -> dict[int, np.ndarray]:
    """Pattern number → stitches (R, C), as the machine holds them: top row first, right to left."""
    found = {}
    for k in range(98):
        entry = image[7 * k : 7 * k + 7]
        digits = entry[2:].hex()
        if digits == "5" * 10:
            break
        rows, stitches, number = int(digits[:3]), int(digits[3:6]), int(digits[7:])
        offset = int.from_bytes(entry[:2], "big")
        if rows == 0:
            assert number == 901 + len(found)  # the entry that ends the list names the next free number
            break
        last = len(image) - 1 - offset
        memo = (rows + 1) // 2
        assert image[last - memo + 1 : last + 1] == bytes(memo)
        per = (stitches + 3) // 4
        size = (per * rows + 1) // 2
        nibbles = image[last - memo - size + 1 : last - memo + 1].hex()[-per * rows :]
        found[number] = np.array(
            [
                [int(b) for b in f"{int(nibbles[i * per : i * per + per], 16):0{4 * per}b}"[-stitches:]]
                for i in range(rows)
            ]
        )
    return found


@pytest.mark.parametrize(("rows", "stitches"), [(1, 1), (4, 4), (5, 6), (9, 9), (7, 200), (60, 24), (150, 120)])
def test_the_disk_is_read_back(tmp_path, rows: int, stitches: int) -> None:
    chart = random_chart(rows, stitches, rows)
    files.write(Disk(chart), tmp_path / "chart.dat")
    files.write(Disk(chart), tmp_path / "chart.img")
    image = (tmp_path / "chart.dat").read_bytes()
    assert len(image) == 32 * 1024
    disk = (tmp_path / "chart.img").read_bytes()
    assert len(disk) == 80 * 1024 + 80 * 12 and disk[: 32 * 1024] == image
    count = np.bincount(chart.cells.ravel(), minlength=2)
    second = 1 if count[1] <= count[0] else 0
    if (count > 0).all():
        assert (read_disk(image)[901][::-1, ::-1] == (chart.cells == second)).all()
    assert image[0x7FEA:0x7FEC].hex() == "1901" and image[0x7FFF] == 2
    top = int.from_bytes(image[0x7F0A:0x7F0C], "big")  # offset of the pattern's first byte
    assert int.from_bytes(image[0x7F00:0x7F02], "big") == top + 1 == int.from_bytes(image[0x7F04:0x7F06], "big")
    assert int.from_bytes(image[0x7F06:0x7F08], "big") == 0x0120


@pytest.mark.parametrize(
    ("drawn", "data"),
    [
        (["----", "-XX-", "-XX-", "----"], "0660"),
        (["X----X", "------", "--XX--", "X----X", "-XXXX-"], "21000c211e"),
        (
            [
                "XXXXXXXXX",
                "X-------X",
                "X-XXXXX-X",
                "X-X---X-X",
                "X-X-X-X-X",
                "X-X---X-X",
                "X-XXXXX-X",
                "X-------X",
                "XXXXXXXXX",
            ],
            "01ff10117d14515514517d1011ff",
        ),
    ],
)
def test_the_published_patterns_give_the_published_bytes(drawn: list[str], data: str) -> None:
    marks = np.array([[c == "X" for c in row] for row in drawn])[::-1].astype(np.uint8)
    if marks.mean() > 0.5:  # the yarn that knits less is selected: here it must be the X
        with_ground = np.hstack([marks, np.zeros_like(marks)])
        marks, cut = with_ground, True
    else:
        cut = False
    image = memory(Disk(Chart(marks, WOOL)))
    if not cut:
        memo = (len(drawn) + 1) // 2
        last = 0x7EDF - memo
        assert image[last - len(data) // 2 + 1 : last + 1].hex() == data
    else:
        assert (read_disk(image)[901][::-1, ::-1] == marks).all()


def read_930(image: bytes) -> np.ndarray:
    """The first pattern of a KH-930's file, as Steve Conklin's notes have it: nibbles downwards from 0x06DF, past the memo."""
    digits = image[2:7].hex()
    rows, stitches = int(digits[:3]), int(digits[3:6])
    assert digits[7:] == "901" and image[0x07EA:0x07EC].hex() == "1901"
    last, per = 0x06DF - (rows + 1) // 2, (stitches + 3) // 4
    nibbles = [image[last - k // 2] >> 4 * (k % 2) & 15 for k in range(rows * per)]
    return np.array([[nibbles[r * per + x // 4] >> x % 4 & 1 for x in range(stitches)] for r in range(rows)])


@pytest.mark.parametrize(("rows", "stitches"), [(4, 4), (5, 7), (33, 24), (60, 60), (38, 200)])
def test_the_smaller_machines_disk_is_read_back_by_its_own_notes(tmp_path, rows: int, stitches: int) -> None:
    chart = random_chart(rows, stitches, rows)
    files.write(Disk(chart, 2), tmp_path / "chart.dat")
    files.write(Disk(chart, 2), tmp_path / "chart.img")
    image = (tmp_path / "chart.dat").read_bytes()
    assert len(image) == 2048 and (tmp_path / "chart.img").read_bytes()[:2048] == image
    second = int(np.bincount(chart.cells.ravel(), minlength=2)[1] <= chart.cells.size / 2)
    assert (read_930(image) == (chart.cells == second)).all()
    assert (read_disk(image)[901][::-1, ::-1] == (chart.cells == second)).all()  # as the larger machine's is read
    with pytest.raises(TambourError, match="memory has 1074"):
        memory(Disk(random_chart(60, 200), 2))


def test_the_disk_says_what_it_cannot_hold() -> None:
    with pytest.raises(TambourError) as caught:
        memory(Disk(random_chart(1200, 230)))
    text = str(caught.value)
    assert "200 needles" in text and "999" in text and "bytes" in text


# --- the punch card, measured on the drawing that is cut


def rings(path: Path) -> list[tuple[float, float, float]]:
    """Every closed ring of an SVG as centre and width."""
    found = []
    for d in re.findall(r' d="([^"]+)"', path.read_text()):
        for part in re.split(r"[Mm]", d)[1:]:
            numbers = np.array([float(n) for n in re.findall(r"-?\d*\.?\d+(?:e-?\d+)?", part)])
            xy = numbers[: len(numbers) // 2 * 2].reshape(-1, 2)
            low, high = xy.min(axis=0), xy.max(axis=0)
            found.append((*((low + high) / 2), high[0] - low[0]))
    return found


@pytest.mark.parametrize("mirror", [True, False])
def test_the_card_is_read_back(tmp_path, mirror: bool) -> None:
    unit = (np.random.default_rng(5).random((20, 24)) < 0.4).astype(np.uint8)
    chart = Chart(np.hstack([unit, unit, unit[:, :1]]), WOOL)
    files.write(card(chart, "brother", mirror), tmp_path / "card.svg")
    svg = (tmp_path / "card.svg").read_text()
    assert 'width="142mm"' in svg
    height = 2 * 12.5 + 39 * 5.0  # 20 rows twice make at least 36
    assert f'height="{height:g}mm"' in svg
    punched = np.zeros((40, 24), bool)
    lap = 0
    for x, y, wide in rings(tmp_path / "card.svg"):
        column, row = (x - 19.25) / 4.5, (height - 12.5 - y) / 5
        if abs(wide - 3.5) < 0.1 and abs(column - round(column)) < 0.02 and 0 <= round(column) < 24:
            if 0 <= round(row) < 40:
                assert abs(row - round(row)) < 0.02
                punched[round(row), round(column)] = True
            else:
                lap += 1
    second = 1 if (chart.cells == 1).sum() <= (chart.cells == 0).sum() else 0
    want = np.tile(unit == second, (2, 1))
    assert (punched == (want[:, ::-1] if mirror else want)).all()
    assert lap == 4 * 24  # two full rows beyond either end


def test_row_numbers_stand_where_the_eye_is() -> None:
    chart = Chart(np.tile([[0, 1]], (40, 12)).astype(np.uint8), WOOL)
    for brand, below in (("brother", 7), ("silver-reed", 5)):
        drawing = card(chart, brand)  # type: ignore[arg-type]
        height = float(drawing.size[1])
        one = next(label for label in drawing.labels if label.text == "1")
        assert round((height - 12.5 - (one.y - 0.9)) / 5) == below


def test_a_card_wants_a_repeat() -> None:
    with pytest.raises(TambourError, match="repeats every 24"):
        holes(random_chart(10, 50))
    assert holes(Chart(np.tile([[0, 1, 1, 0]], (9, 3)).astype(np.uint8), WOOL)).shape == (36, 24)


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("circular", [False, True])
def test_a_lawful_chart_comes_out_as_it_went_in(tmp_path, seed: int, circular: bool) -> None:
    from tambour.run import run

    cells = np.random.default_rng(seed).integers(0, 2, (6, 12)).astype(np.uint8)
    cells[:, 2::3] = 1 - cells[:, 1::3]  # no run above three, or four round the seam
    chart = Chart(cells, WOOL, circular=circular, gauge=Gauge(24, 31))
    files.write(chart, tmp_path / "in.json")
    outs = [tmp_path / f"out{suffix}" for suffix in (".json", ".png", ".csv", ".k")]
    report = run("knit", tmp_path / "in.json", out=outs)
    assert report["flips"] == 0 and report["violations"] == 0
    same(chart, files.read(outs[0], ("Chart",)))
    for path in outs:
        back = files.read(path, ("Chart",))
        assert (back.palette.rgb[back.cells] == chart.palette.rgb[chart.cells]).all(), path.suffix
        if path.suffix != ".csv":
            assert back.circular == circular
        if path.suffix in (".json", ".png"):
            assert back.gauge == chart.gauge

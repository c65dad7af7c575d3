"""Tiles: each is made of the seed and its number alone, and meets its neighbours; pages, archives, sheets and hoops over them.

TAMBOUR_TILES says how many tiles the heavy test makes (2000 by hand, and 300 of SVG; 24 by default).
"""

from __future__ import annotations

import io
import os
import re
import shutil
import zipfile
from collections.abc import Callable
from importlib import import_module
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

from tambour.core.errors import TambourError
from tambour.run import craft, run
from tambour.sweep.plan import Piece
from tambour.tiles import hoop, overview, sheet
from tambour.tiles.leave import into_folder, into_zip
from tambour.tiles.plan import tiles
from tambour.work.local import Local
from tambour.work.piece import Done

COUNT = int(os.environ.get("TAMBOUR_TILES", "24"))
CHROMIUM = shutil.which("chromium") or shutil.which("google-chrome")


def alone(piece: Piece) -> Done:
    """A tile made in this process, of nothing but its job."""
    module, _, name = piece.job.how.partition(":")
    done: Done = getattr(import_module(module), name)(piece.job, {})
    return done


def into(folder: Path, *words: Any, **options: Any) -> Path:
    plan, _ = tiles(*words, **options)
    made = list(into_folder(plan, folder, Local(2)))
    assert [r.reason for r in made] == [""] * len(made)
    return folder


@pytest.mark.slow
def test_a_tile_is_a_window_of_the_scroll(tmp_path: Path) -> None:
    into(tmp_path, "7", -2, 5, [".png", ".svg"], ["season=autumn"])
    for k in (-2, 1):
        params = craft("ink").params(seed="7", season="autumn", from_=512.0 * k, span=512.0, pixels=512)
        run("ink", None, params, [tmp_path / "own.png", tmp_path / "own.svg"])
        for kind in (".png", ".svg"):
            assert (tmp_path / f"tile={k}{kind}").read_bytes() == (tmp_path / f"own{kind}").read_bytes()
    with Image.open(tmp_path / "tile=0.png") as picture:
        assert picture.size == (512, 700)


@pytest.mark.slow
def test_neighbours_meet(tmp_path: Path) -> None:
    plan, _ = tiles("7", 4, 2, [".png"])
    pair = [np.asarray(Image.open(io.BytesIO(alone(p).files[f"{p.name}.png"])).convert("RGB")) for p in plan.pieces()]
    params = craft("ink").params(seed="7", from_=512.0 * 4, span=1024.0, pixels=1024)
    run("ink", None, params, [tmp_path / "both.png"])
    both = np.asarray(Image.open(io.BytesIO((tmp_path / "both.png").read_bytes())).convert("RGB"))
    away = np.abs(np.concatenate(pair, axis=1).astype(int) - both).max(axis=2)
    assert (away > 8).mean() < 1e-3 and away[:, 508:516].mean() < 1.0


def test_from_afar_every_tile_is_where_it_belongs() -> None:
    first, count = -5, 13
    colour = {k: (20 * (k + 6), 255 - 15 * (k + 6), 90) for k in range(first, first + count)}

    def small(k: int) -> bytes:
        made = io.BytesIO()
        Image.new("RGB", (overview.WIDE, overview.HIGH), colour[k]).save(made, "WEBP", lossless=True)
        return made.getvalue()

    found = dict(overview.pictures(first, count, small))
    top = overview.levels(first, count)
    assert {name.split("/")[1] for name in found} == {str(z) for z in range(2, top + 1)}
    for name, raw in found.items():
        z, j = int(name.split("/")[1]), int(Path(name).stem)
        picture = Image.open(io.BytesIO(raw)).convert("RGB")
        assert picture.width == 512 and abs(picture.height - 700 / 2**z) < 1
        for k in range(max(first, j << z), min(first + count, (j + 1) << z)):
            x = int((k - (j << z) + 0.5) * 512 / 2**z)
            away = np.abs(np.subtract(picture.getpixel((x, picture.height // 2)), colour[k]))
            assert away.max() < 12, (name, k)
    one = list(overview.pictures(3, 1, lambda k: small(0)))
    assert [name for name, _ in one] == []


@pytest.mark.skipif(CHROMIUM is None, reason="needs chromium")
@pytest.mark.slow
def test_the_page_shows_the_tiles_without_a_network(tmp_path: Path) -> None:
    from playwright.sync_api import sync_playwright

    into(tmp_path, "7", 3, 9, [".png"])
    with sync_playwright() as it:
        browser = it.chromium.launch(executable_path=CHROMIUM, args=["--no-sandbox", "--disable-gpu"])
        page = browser.new_page(viewport={"width": 1024, "height": 700})
        asked: list[str] = []
        errors: list[str] = []
        page.on("request", lambda r: asked.append(r.url))
        page.on("pageerror", lambda e: errors.append(str(e)))
        page.on("requestfailed", lambda r: errors.append(r.url))
        page.goto((tmp_path / "scroll.html").as_uri())
        page.wait_for_function("[...document.images].length >= 2 && [...document.images].every((i) => i.complete)")
        seen = np.asarray(Image.open(io.BytesIO(page.screenshot())).convert("RGB")).astype(int)
        raw = (tmp_path / "tile=3.png").read_bytes()
        tile = np.asarray(Image.open(io.BytesIO(raw)).convert("RGB")).astype(int)
        assert np.abs(seen[:600, :512] - tile[:600]).mean() < 2
        page.click("#all")
        page.wait_for_function("[...document.images].some((i) => i.src.includes('afar/') && i.complete)")
        page.keyboard.press("+")
        page.mouse.wheel(0, -400)
        page.keyboard.press("End")
        page.wait_for_timeout(300)
        assert "3 to 11" in str(page.text_content("#place"))
        browser.close()
    assert errors == [] and {u.partition(":")[0] for u in asked} == {"file"}


def test_the_page_asks_for_nothing_else(root: Path) -> None:
    text = overview.page(0, 4, ".png", "</script><b>", (1, 2, 3)).decode()
    assert "</script><b>" not in text and not re.search(r"https?:|@import|//[a-z]+\.", text)


@pytest.mark.slow
def test_an_archive_holds_what_the_folder_does_and_is_the_same_each_time(tmp_path: Path) -> None:
    folder = into(tmp_path / "folder", "7", 0, 5, [".png"])
    for name in ("a.zip", "b.zip"):
        plan, _ = tiles("7", 0, 5, [".png"])
        assert len(list(into_zip(plan, tmp_path / name, Local(2)))) == 5
    assert (tmp_path / "a.zip").read_bytes() == (tmp_path / "b.zip").read_bytes()
    with zipfile.ZipFile(tmp_path / "a.zip") as archive:
        held = {name: archive.read(name) for name in archive.namelist()}
    own = {"reports", ".tambour-lock", "index.csv"}
    found = {str(p.relative_to(folder)): p.read_bytes() for p in folder.rglob("*") if p.is_file()}
    assert held == {name: raw for name, raw in found.items() if name.split("/")[0] not in own}
    broken, _ = tiles("7", 0, 3, [".png"], ["mist=0.2"], pixels=8192)
    with pytest.raises(TambourError, match="took more"):
        from tambour.work.limit import Limit

        list(into_zip(broken, tmp_path / "c.zip", Local(1, Limit(seconds=0.05))))
    assert not (tmp_path / "c.zip").exists()


@pytest.mark.slow
def test_sheets_tell_where_the_next_one_continues() -> None:
    plan, _ = tiles("7", 3, 2, [".svg", ".hpgl"], ["plotter=yes", "page=a5", "margin=8mm", "pens=2"])
    marks, margin, width, height = [], 8.0, 210.0, 148.0
    for piece in plan.pieces():
        files = alone(piece).files
        text = files[f"{piece.name}.svg"].decode()
        (group,) = re.findall(rf'<g[^>]*id="{sheet.LAYER}".*?</g>', text, re.S)
        assert 'inkscape:label="3 registration"' in group
        found = [tuple(map(float, re.findall(r"-?\d+\.?\d*", d))) for d in re.findall(r' d="([^"]+)"', group)]
        assert sum(len(f) for f in found) >= 16
        marks.append(found)
        assert "SP3;" in files[f"{piece.name}.hpgl"].decode()
    assert marks[0] == marks[1]
    lines = np.array(sheet.crosses(width, height, margin))
    middle = lines.mean(axis=1)
    assert sorted(set(middle[:, 0])) == [margin, width - margin] and sorted(set(middle[:, 1])) == [4.0, height - 4.0]
    assert lines.min() > 0 and lines[:, :, 0].max() < width and lines[:, :, 1].max() < height
    # None lies in what is drawn.
    assert ((lines[:, :, 1] < margin) | (lines[:, :, 1] > height - margin)).all()


def read(raw: bytes, reader: Any) -> Any:
    """Needle points of a machine file in mm, by a reader that is not ours."""
    pattern = reader.EmbPattern()
    reader.DstReader.read(io.BytesIO(raw), pattern)
    return np.array([(x / 10, y / 10) for x, y, c in pattern.stitches if c & 0xFF == reader.STITCH])


def edges(number: int) -> dict[int, Any]:
    """Where lines cross the left (0) and right (1) edge of a hoop of 90 mm, mm from the top."""
    from tambour.core.progress import Progress
    from tambour.ink.plan import scroll
    from tambour.ink.plotter.job import unhidden

    params = craft("ink").params(
        seed="7", plotter=True, nib=0.4, from_=700.0 * number - hoop.REACH, span=700.0 + 2 * hoop.REACH
    )
    seen = unhidden(scroll.make(None, params, Progress()), 0.4 / (90 / 700))
    found: dict[int, list[float]] = {0: [], 1: []}
    for a, b in pairwise(seen.offsets):
        for part, ends in hoop.parted((seen.coords[a:b] - (700.0 * number, 0.0)) * 90 / 700, 90.0, 90.0):
            for edge in set(ends):
                found[edge] += [float(y) for x, y in part[[0, -1]] if abs(x - 90.0 * edge) < 1e-9]
    return {edge: np.sort(ys) for edge, ys in found.items()}


@pytest.mark.parametrize("name", ["pystitch", "pyembroidery"])
@pytest.mark.slow
def test_hoops_abut(name: str) -> None:
    reader = pytest.importorskip(name)
    plan, _ = tiles("7", 3, 5, [".dst"])
    points = [read(alone(p).files[f"{p.name}.dst"], reader) for p in plan.pieces()]
    crossing = 0
    for k, (a, b) in enumerate(pairwise(points)):
        right, left = edges(3 + k)[1], edges(4 + k)[0]
        assert np.allclose(right, left, atol=1e-9)
        assert apart(a, b, right) <= 0.1, k
        assert len(right) == 0 or apart(a, b + np.array([0.0, 0.3]), right) > 0.1  # the measure can fail
        crossing += len(right)
    assert crossing > 40
    for found in points:
        assert np.abs(found).max() < 50  # within the hoop


def apart(a: Any, b: Any, crossing: Any) -> float:
    """The farthest that a needle point lies from where a line crosses, of the hoop before (a) and behind (b), mm."""
    worst = 0.0
    for y in crossing:
        for found, x in ((a, 45.0), (b, -45.0)):
            worst = max(worst, float(np.abs(found - (x, y - 45.0)).max(axis=1).min()))
    return worst


def test_a_line_is_parted_alike_from_both_sides() -> None:
    """Random walks about an edge: what one hoop leaves the other sews, each crossing in both, nothing shorter than a stitch."""
    rng = np.random.default_rng(5)
    for _ in range(200):
        line = np.cumsum(rng.normal(0, 0.5, (40, 2)), axis=0) + np.array([90.0, 45.0])
        here, there = hoop.parted(line, 90.0, 90.0), hoop.parted(line - (90.0, 0.0), 90.0, 90.0)
        ends = [
            sorted(round(float(p[i, 1]), 9) for p, e in found for i in (0, -1) if abs(p[i, 0] - x) < 1e-9 and e)
            for found, x in ((here, 90.0), (there, 0.0))
        ]
        assert ends[0] == ends[1]
        whole = np.hypot(*np.diff(line, axis=0).T).sum()
        parts = [float(np.hypot(*np.diff(p, axis=0).T).sum()) for p, _ in here + there]
        assert np.isclose(sum(parts), whole) and min(parts) >= min(hoop.LEAST, whole) - 1e-9


@pytest.mark.slow
def test_all_that_is_wrong_is_told_at_once(tambour: Callable[..., Any], tmp_path: Path) -> None:
    made = tambour("tiles", "--first", 10**10, "-o", ".xyz", "--set", "seesaw=1", "--set", "span=3", "--limit", "1")
    assert made.returncode == 2 and "Traceback" not in made.stderr
    for said in (
        "a folder is wanted",
        'no "xyz"'.replace('"xyz', '".xyz'),
        'no parameter "seesaw"',
        "is not set so here",
        "are numbered",
        "neither memory nor time",
    ):
        assert said in made.stderr, said
    for words, said in (
        (["-o", ".dst", "-o", ".png"], "hoops are made by themselves"),
        (["-o", ".hpgl"], "add --set plotter=yes"),
        (["-o", ".svg", "--set", "plotter=yes", "--set", "margin=1mm"], "in the margin"),
        (["--set", "season=sommer"], "summer"),
    ):
        made = tambour("tiles", "-o", tmp_path / "out", *words)
        assert made.returncode == 2 and said in made.stderr, made.stderr


@pytest.mark.slow
@pytest.mark.parametrize(("kind", "count"), [(".png", COUNT), (".svg", max(8, COUNT * 3 // 20))])
def test_any_tile_drawn_alone_is_the_same(kind: str, count: int, tmp_path: Path, tambour: Callable[..., Any]) -> None:
    import subprocess
    import sys
    import time

    began = time.perf_counter()
    words = ["tiles", "--seed", "7", "--count", str(count), "-o", str(tmp_path / "out"), "-o", kind]
    made = subprocess.run([sys.executable, "-m", "tambour", *words], capture_output=True, text=True)
    took = time.perf_counter() - began
    assert made.returncode == 0, made.stderr
    plan, _ = tiles("7", 0, count, [kind])
    size = sum(p.stat().st_size for p in (tmp_path / "out").glob(f"tile=*{kind}"))
    assert len(list((tmp_path / "out").glob(f"tile=*{kind}"))) == count
    print(f"{count} {kind} tiles in {took:.1f} s, {size / count / 1000:.0f} kB each")
    for k in np.random.default_rng(1).permutation(count)[:50].tolist():
        piece = plan.piece(k)
        name = f"{piece.name}{kind}"
        assert alone(piece).files[name] == (tmp_path / "out" / name).read_bytes(), name

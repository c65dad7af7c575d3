"""Sweeps: every combination once, named by what it is made of, equal to what the command makes, whole whatever happens."""

from __future__ import annotations

import csv
import json
import os
import re
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from contextlib import closing
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from PIL import Image

import tambour.sweep.plan as plans
from tambour.core.errors import TambourError
from tambour.run import craft, run
from tambour.sweep import sweep
from tambour.sweep.axes import axes, combinations, values
from tambour.sweep.course import Pool, course, planned
from tambour.sweep.folder import Folder, Row
from tambour.work.limit import Limit
from tambour.work.local import KEPT, Local, _laid
from tambour.work.piece import Job


@pytest.fixture
def photos(tmp_path: Path) -> Path:
    """A folder of three small pictures, and a file that is none."""
    folder = tmp_path / "photos"
    folder.mkdir()
    for k, name in enumerate(("a", "b", "c")):
        grid = np.indices((24, 24)).sum(0) // (3 + k) % 2 * 200 + 20
        Image.fromarray(grid.astype(np.uint8)).save(folder / f"{name}.png")
    (folder / "notes.docx").write_bytes(b"none of ours")
    return folder


def index(folder: Path) -> list[dict[str, str]]:
    with (folder / "index.csv").open(newline="") as table:
        return list(csv.DictReader(table))


def whole(folder: Path) -> None:
    """The index tells of all that there is, every file is as long as its report says, and nothing else lies about."""
    rows = index(folder)
    reports = {p.stem: json.loads(p.read_bytes()) for p in (folder / "reports").iterdir()}
    assert sorted(row["key"] for row in rows) == sorted(told["key"] for told in reports.values())
    listed = {name for row in rows for name in row["files"].split(";") if name}
    own = {"index.csv", "sheet.png", "sheet.html", ".tambour-lock"}
    assert {p.name for p in folder.iterdir() if p.is_file()} - own == listed
    for told in reports.values():
        for name, size in zip(told.get("files", ()), told.get("sizes", ()), strict=True):
            assert (folder / name).stat().st_size == size
    assert not list(folder.glob(".tambour-[!l]*"))


@given(st.integers(-50, 50), st.integers(0, 30), st.sampled_from(["1", "2", "0.25", "0.1"]))
def test_ranges_go_from_first_to_last(first: int, count: int, step: str) -> None:
    last = first + count
    found = [float(v) for v in values(f"{first}..{last}..{step}")]
    assert found[0] == first and last - float(step) < found[-1] <= last
    assert np.allclose(np.diff(found), float(step))


def test_values_are_lists_ranges_and_json() -> None:
    assert values("3, 4,5") == ["3", "4", "5"] and values("0..3") == ["0", "1", "2", "3"]
    assert values('["a,b", "c"]') == ["a,b", "c"] and values("a..b") == ["a..b"]
    for bad in ("", "5..1", "1..5..0", "[1,", "0..99999999"):
        with pytest.raises(ValueError):
            values(bad)


def test_every_combination_once_and_alike_values_told() -> None:
    found, doubts = axes(craft("ink"), ["span=300,300.0,400", "seed=0..4", "from=-10"])
    made = [tuple(c.values()) for c in combinations(found)]
    assert len(made) == len(set(made)) == 10 and list(found) == ["span", "seed", "from_"]
    assert [str(d) for d in doubts] == ["--set span: warning: 300.0 is 300, and is made once"]


def test_all_that_is_wrong_is_told_at_once(tmp_path: Path, tambour: Callable[..., Any]) -> None:
    words = ["--set", "max-flot=3", "--set", "stitches=0,40,x", "--set", "max_float=9..1", "-o", ".xyz", "--limit", "5"]
    made = tambour("sweep", "knit", tmp_path / "none.png", *words, "--jobs", "2", "--cluster", "2")
    assert made.returncode == 2 and "Traceback" not in made.stderr
    for said in (
        "a folder is wanted", "say two things", 'no parameter "max-flot"', 'did you mean "max_float"', "stitches",
        "a range goes up", "no such file", '"5" is neither memory nor time', 'makes no ".xyz" files',
    ):  # fmt: skip
        assert said in made.stderr, said
    assert list(tmp_path.iterdir()) == []


def test_what_has_no_effect_is_told(tmp_path: Path) -> None:
    *_, doubts = planned("ink", [], ["nib=0.3,0.5", "plotter=no,yes"], [], [], "", False)
    assert [str(d) for d in doubts] == ["--nib: warning: has no effect without --plotter, in 1 of 4 combinations"]


TEXTS = st.text(min_size=1, max_size=200)


@given(st.lists(TEXTS, min_size=2, max_size=8, unique=True))
def test_names_are_as_different_as_what_they_name(seeds: list[str]) -> None:
    names = [plans._name("ink", {"seed": s}, craft("ink").views) for s in seeds]
    assert len(set(names)) == len(seeds)
    for name in names:
        assert len(name.encode()) <= plans.LONGEST + 1 and not re.search(r'[/\\:*?"<>|;\x00-\x1f]', name)
        assert Path(name).suffix[1:] not in craft("ink").views


def test_sources_of_one_name_are_told_apart() -> None:
    labels = [label for _, label in plans._labelled(["x/a.png", "y/a.png", "x/a.jpg", "b.png", "A.PNG"])]
    assert len({label.casefold() for label in labels}) == 5 and labels[3] == "b"


def test_no_name_and_no_reason_is_taken_for_a_formula(tmp_path: Path) -> None:
    for name in (b"=1+1", b"-rf", b"+x", b"@sum", b"\xff"):
        (tmp_path / f"{os.fsdecode(name)}.png").write_bytes(b"")
    made, (doubt,) = plans.plan(craft("knit"), [str(tmp_path)], {}, [".csv"], [])
    names = [piece.name for piece in made.pieces()]
    assert len(set(names)) == 4 and all(name[0] not in "=+-@" for name in names)
    assert doubt.message == "1 of 5 files are left out, 1 for their names: one holds bytes that are no text"
    row = Row("a", "k", "knit", "+s.png", "{}", "failed", "=cmd|' /C calc'!A0", 0.0, None, ("@a",), (1,), (".csv",))
    assert [cell for cell in map(str, row.told()) if cell and cell[0] in "=+-@\t\r"] == []


def test_a_key_is_all_that_the_piece_is_made_of(photos: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def keys(source: Path, **options: Any) -> list[str]:
        made, *_ = planned(
            "knit", [source], options.pop("axes", ["stitches=20"]), [".png"], options.pop("edits", []), "", False
        )
        return [piece.key for piece in made.pieces()]

    plain = keys(photos / "a.png")
    (photos / "deep").mkdir()
    (photos / "deep" / "a.png").write_bytes((photos / "a.png").read_bytes())
    assert keys(photos / "deep" / "a.png") == plain
    others = [keys(photos / "b.png"), keys(photos / "a.png", axes=["stitches=21"])]
    others.append(keys(photos / "a.png", edits=["stitch:1,1=CC"]))
    stash = photos / "yarn.csv"
    for text in ("red,#ff0000,100,50\nwhite,#ffffff,100,50\n", "blue,#0000ff,100,50\nwhite,#ffffff,100,50\n"):
        stash.write_text(text)
        others.append(keys(photos / "a.png", axes={"stitches": [20], "stash": [str(stash)]}))
    monkeypatch.setattr(plans, "__version__", "99")
    others.append(keys(photos / "a.png"))
    assert len({plain[0], *(k[0] for k in others)}) == 1 + len(others)


@pytest.mark.slow
def test_pieces_are_what_the_command_makes_and_are_made_once(photos: Path, tmp_path: Path) -> None:
    out = tmp_path / "new" / "out"
    found = {"stitches": [20, 24], "max_float": [3]}

    def go(**options: Any) -> list[str]:
        made = list(sweep("knit", [photos], found, out, (".png", ".json", ".back.png"), **options))
        return sorted(r.status for r in made)

    assert go() == ["made"] * 6
    whole(out)
    made_at = {p.name: p.stat().st_mtime_ns for p in (out / "reports").iterdir()}
    for source in photos.glob("*.png"):
        for stitches in (20, 24):
            for longest in (3,):
                name = f"{source.stem}-stitches={stitches}-max_float={longest}"
                params = craft("knit").params(stitches=stitches, max_float=longest)
                alone = [tmp_path / f"alone{kind}" for kind in (".png", ".json", ".back.png")]
                told = run("knit", source, params, alone)
                for file in alone:
                    assert (out / file.name.replace("alone", name)).read_bytes() == file.read_bytes()
                kept = json.loads((out / "reports" / f"{name}.json").read_bytes())
                same = set(told) - {"files", "seconds", "kernels"}
                assert {k: kept[k] for k in same} == json.loads(json.dumps({k: told[k] for k in same}, default=list))
    assert go() == ["kept"] * 6
    assert made_at == {p.name: p.stat().st_mtime_ns for p in (out / "reports").iterdir()}
    # What was cut short, or lost, is made again; so is all of it when asked.
    cut = out / "b-stitches=20-max_float=3.png"
    cut.write_bytes(cut.read_bytes()[:-1])
    (out / "c-stitches=20-max_float=3.json").unlink()
    assert go() == ["kept"] * 4 + ["made"] * 2
    assert go(again=True) == ["made"] * 6
    whole(out)
    # Another kind of file is not there yet.
    again = list(sweep("knit", [photos / "a.png"], {"stitches": [20], "max_float": [3]}, out, (".png", ".txt")))
    assert [r.status for r in again] == ["made"]


@pytest.mark.slow
def test_sheets_show_every_piece_and_ask_no_network(photos: Path, tmp_path: Path) -> None:
    (photos / "<b>bad.png").write_bytes(b"no picture")
    found = list(sweep("knit", [photos], ["stitches=20"], tmp_path / "out", (".json",)))
    text = (tmp_path / "out" / "sheet.html").read_text()
    assert text.count("<figure") == len(found) == 4 and "<b>" not in text
    assert not re.search(r"https?:|//|@import|url\(", text)
    with Image.open(tmp_path / "out" / "sheet.png") as sheet:
        assert len(sheet.convert("RGB").getcolors(1 << 24) or ()) > 20


@pytest.mark.slow
def test_a_poisoned_source_is_listed_and_the_rest_stands(
    photos: Path, tmp_path: Path, tambour: Callable[..., Any]
) -> None:
    raw = (photos / "a.png").read_bytes()
    (photos / "b.png").write_bytes(raw[:60] + b"\0" * 40)
    (photos / "c.png").unlink()
    (photos / "c.png").mkdir()
    (photos / "=cmd.png").write_bytes(raw)
    sources = [photos / "a.png", photos / "b.png", "=cmd.png"]
    words = ["--set", "stitches=20", "-o", tmp_path / "out", "-o", ".png"]
    made = tambour("sweep", "knit", *sources, *words, cwd=photos)
    assert made.returncode == 1 and "Traceback" not in made.stderr
    assert f"b-stitches=20: failed: {photos}/b.png: this is not a picture" in made.stderr
    rows = {Path(row["source"]).name: row for row in index(tmp_path / "out")}
    assert {name: row["status"] for name, row in rows.items()} == {
        "a.png": "made",
        "b.png": "failed",
        "=cmd.png": "made",
    }
    assert rows["=cmd.png"]["source"] == "./=cmd.png" and "not a picture" in rows["b.png"]["reason"]
    whole(tmp_path / "out")
    # It is tried again, as its reason may be gone.
    (photos / "b.png").write_bytes(raw)
    made = tambour("sweep", "knit", *sources, *words, cwd=photos)
    assert made.returncode == 0 and "1 made, 2 finished before" in made.stdout


@pytest.mark.slow
def test_a_piece_that_breaks_its_limit_is_listed(tmp_path: Path) -> None:
    found = list(sweep("ink", axes={"seed": [1], "span": [300, 2_000_000]}, files=[".svg"], jobs=1, limit="4s"))
    assert [(r.chosen["span"], r.status) for r in found] == [(300, "made"), (2_000_000, "failed")]
    assert "took more than 4 seconds" in found[1].reason
    found = list(
        sweep("ink", axes={"seed": [1], "span": [400, 40_000]}, files=[".pdf"], jobs=1, limit="400MB", sheet=False)
    )
    assert [r.status for r in found] == ["made", "failed"] and "memory" in found[1].reason
    assert Limit.of("1.5GiB, 2min") == Limit(3 << 29, 120.0)


@pytest.mark.slow
def test_a_worker_that_is_killed_is_replaced_and_its_piece_made(photos: Path) -> None:
    made, *_ = planned("knit", [photos], ["stitches=20..40"], [".png"], [], "", False)
    pool = Local(2)
    found = []
    for k, result in enumerate(course(made, None, pool)):
        found.append(result)
        if k in (4, 40):
            next(iter(pool._hands)).process.kill()
    assert [r.reason for r in found] == [""] * 63 and pool._made > 2
    assert {r.name: r.data for r in found} == {
        r.name: r.data for r in sweep("knit", [photos], ["stitches=20..40"], files=[".png"], jobs=1)
    }


def started(*words: Any, **options: Any) -> subprocess.Popen[str]:
    command = [sys.executable, "-m", "tambour", "sweep", *map(str, words)]
    return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, **options)


def grown(folder: Path, count: int) -> None:
    end = time.monotonic() + 120
    while len(list((folder / "reports").glob("*.json"))) < count:
        assert time.monotonic() < end
        time.sleep(0.01)


@pytest.mark.slow
def test_two_sweeps_into_one_folder_lose_nothing(photos: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    words = ["-o", out, "-o", ".png", "-o", ".json", "--jobs", "1"]
    one = started("knit", photos, "--set", "stitches=20..34", *words)
    two = started("knit", photos, "--set", "stitches=28..40", *words)
    for process in (one, two):
        told = process.communicate(timeout=300)
        assert process.returncode == 0, told
    assert len(index(out)) == 63
    whole(out)


@pytest.mark.slow
def test_killed_hard_it_goes_on_where_it_was(photos: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    words = ["knit", photos, "--set", "stitches=20..39", "-o", out, "-o", ".png", "-o", ".json"]
    process = started(*words)
    grown(out, 12)
    process.kill()
    process.communicate()
    kept = {p.name: p.stat().st_mtime_ns for p in (out / "reports").iterdir()}
    assert 12 <= len(kept) < 60
    process = started(*words)
    said, _ = process.communicate(timeout=300)
    assert process.returncode == 0 and f"{60 - len(kept)} made, {len(kept)} finished before" in said
    now = {p.name: p.stat().st_mtime_ns for p in (out / "reports").iterdir()}
    assert len(now) == 60 and {name: now[name] for name in kept} == kept
    whole(out)


@pytest.mark.slow
@pytest.mark.parametrize(("number", "code"), [(signal.SIGINT, 130), (signal.SIGTERM, 143)])
def test_interrupted_it_leaves_whole_files(photos: Path, tmp_path: Path, number: signal.Signals, code: int) -> None:
    out = tmp_path / "out"
    process = started("knit", photos, "--set", "stitches=20..60", "-o", out, "-o", ".png", start_new_session=True)
    grown(out, 5)
    os.killpg(process.pid, number)  # as a terminal does
    _, said = process.communicate(timeout=60)
    assert process.returncode == code and "no file is left half written" in said and "Traceback" not in said
    assert 5 <= len(index(out)) < 123
    whole(out)


@pytest.mark.slow
def test_a_full_disk_is_told_and_the_index_is_true(tmp_path: Path) -> None:
    out = tmp_path / "out"
    words = ["--set", "seed=2,0", "--set", "span=300", "--jobs", "1", "-o", out, "-o", ".svg", "--no-sheet"]
    process = started(
        "ink",
        *words,
        preexec_fn=lambda: __import__("resource").setrlimit(7 if sys.platform == "darwin" else 1, (400_000,) * 2),
    )
    _, said = process.communicate(timeout=120)
    assert process.returncode == 2 and "Traceback" not in said
    assert "cannot be written: " in said and "what is made stands in index.csv" in said
    assert [row["params"] for row in index(out)] == ['{"seed": "2", "span": "300"}']
    whole(out)


@pytest.mark.slow
def test_a_report_makes_its_piece_again(photos: Path, tmp_path: Path, tambour: Callable[..., Any]) -> None:
    out = tmp_path / "out"
    (made,) = sweep("knit", [photos / "a.png"], ["stitches=20"], out, (".png",))
    again = tambour("run", out / "reports" / f"{made.name}.json", "-o", tmp_path / "again.png")
    assert again.returncode == 0, again.stderr
    assert (tmp_path / "again.png").read_bytes() == (out / made.files[0]).read_bytes()


@pytest.mark.slow
def test_pieces_of_several_files_are_finished_too(tmp_path: Path) -> None:
    for status in ("made", "kept"):
        axes = {"plotter": [True], "sheets": ["0..1"], "page": ["a5"]}
        (made,) = sweep("ink", axes=axes, out=tmp_path, files=[".svg"], sheet=False)
        assert made.status == status and [Path(f).stem[-2:] for f in made.files] == ["-1", "-2"]


def test_pieces_do_not_lie_among_their_sources(photos: Path, tmp_path: Path) -> None:
    (tmp_path / "link").symlink_to(photos)
    before = {p.name: p.read_bytes() for p in photos.iterdir()}
    for out in (photos, tmp_path / "link"):
        with pytest.raises(TambourError, match="among their sources"):
            list(sweep("knit", [photos / "a.png"], out=out, files=[".png"]))
    assert {p.name: p.read_bytes() for p in photos.iterdir()} == before


def test_how_far_it_is_and_how_long_it_takes() -> None:
    from tambour.sweep.command import Tally
    from tambour.sweep.course import Result

    tally = Tally(103, True)
    for k in range(21):
        tally.count(Result(f"{k}", f"{k}", "", "made" if k else "kept", {}))
    tally.first = 0.0
    assert tally.line(9.5) == "21 of 103, 1 finished before · 2 pieces a second · 41 s left"


def test_a_folder_that_is_a_file_is_refused(tmp_path: Path) -> None:
    (tmp_path / "out").write_text("")
    with pytest.raises(TambourError, match="this is a file"):
        list(sweep("ink", axes={"span": [300]}, out=tmp_path / "out"))


@pytest.mark.slow
def test_reports_of_others_are_left_alone(tmp_path: Path) -> None:
    list(sweep("ink", axes={"span": [300]}, out=tmp_path))
    for k, raw in enumerate((b"", b"{}", b"[1]", b'{"key": 1', b"\xff")):
        (tmp_path / "reports" / f"strange{k}.json").write_bytes(raw)
    with Folder(tmp_path) as folder:
        assert len(folder.index()) == 1


@pytest.mark.skipif(not Path("/proc").is_dir(), reason="a process's environment is looked at")
@pytest.mark.slow
def test_a_worker_keeps_the_memory_that_it_will_want_again(monkeypatch: pytest.MonkeyPatch) -> None:
    # Dask tells its own to give it back at once: small pieces took half as long again.
    monkeypatch.setenv("MALLOC_TRIM_THRESHOLD_", "65536")
    with closing(Local(1)) as pool:
        assert pool.submit(Job("ink", {"span": 64.0}, ["a.svg"])).result().reason == ""
        (hand,) = pool._hands
        assert b"MALLOC_TRIM" not in Path(f"/proc/{hand.process.pid}/environ").read_bytes()


def test_what_a_piece_needs_lies_there_whatever_went_before(tmp_path: Path) -> None:
    """A spoilt file found it: the fifth new source took the place of the one that lay there longest, which this piece needs too."""
    first = {"a.png": b"first"}
    for number in range(12):
        new = {**first, "b.png": b"%d" % number}
        laid = _laid(tmp_path, new)
        assert {name: Path(place).read_bytes() for name, place in laid.items()} == new
        assert len(list(tmp_path.iterdir())) <= KEPT + 3
    again = {name: b"%d" % number for name, number in (("b.png", 11), ("c.png", 12))}
    assert {name: Path(place).read_bytes() for name, place in _laid(tmp_path, again).items()} == again


def test_the_local_pool_is_a_pool() -> None:
    pool: Pool = Local(1)
    pool.close()
    pool.close()


@pytest.mark.parametrize("meanwhile", [0.0, 0.002, 0.004, 0.008])
def test_a_pool_closed_while_its_workers_start_leaves_nothing_behind(meanwhile: float) -> None:
    """Cancelled in the making of its pipes, a process was never told to have ended: its job waited, and so did the pool."""
    pool = Local(2)
    jobs = [pool.submit(Job("ink", {"span": 64.0}, ["a.svg"])) for _ in range(3)]
    time.sleep(meanwhile)
    pool.close()
    assert [job.cancelled() for job in jobs] == [True] * 3
    assert all(hand.process.returncode is not None for hand in pool._hands if hasattr(hand, "process"))

"""Every craft × an example, no file, a missing file, a broken file, an unknown option: codes and words."""

from __future__ import annotations

import contextlib
import io
import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from tambour.cli import main
from tambour.run import CRAFTS, craft

# Craft → (a quick command on an example, files that are broken inputs of its suffix).
TABLE: dict[str, tuple[str, dict[str, bytes]]] = {
    "crochet": (
        "{examples}/crochet/ball.acl --solver none -o {out}/a.json",
        {"bad.acl": b"R1: MR(6), 6 sx\nR2: 3 inc)"},
    ),
    "knit": ("{examples}/knit/rose.png -o {out}/a.json -o {out}/a.png", {"bad.png": b"\x89PNG\r\n\x1a\nhello"}),
    "ink": ("--seed 1 --span 300 -o {out}/a.json", {}),
    "embroidery": (
        "{examples}/embroidery/logo.svg -o {out}/a.dst -o {out}/a.json",
        {"bad.svg": b"<svg><path d='M0 0'"},
    ),
}


def call(words: str) -> tuple[int, str]:
    said = io.StringIO()
    with pytest.raises(SystemExit) as left, contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
        main(words.split())
    return int(left.value.code or 0), said.getvalue()


def test_every_craft_is_in_the_table() -> None:
    assert set(TABLE) == set(CRAFTS)


@pytest.mark.parametrize("name", TABLE)
def test_an_example_becomes_its_files_and_a_report(name: str, tmp_path: Path, root: Path) -> None:
    words = TABLE[name][0].format(examples=root / "examples", out=tmp_path)
    code, said = call(f"{name} {words} --report {tmp_path}/r.json")
    assert code == 0, said
    report = json.loads((tmp_path / "r.json").read_text())
    assert list(report)[:5] == ["craft", "version", "edition", "params", "source"]
    assert {"start", "write"} <= set(report["seconds"])
    assert report["files"] and all(Path(f).stat().st_size for f in report["files"])
    made = {f: Path(f).read_bytes() for f in report["files"]}
    for f in report["files"]:
        Path(f).unlink()
    code, said = call(f"run {tmp_path}/r.json")
    assert code == 0, said
    assert all(Path(f).read_bytes() == data for f, data in made.items()), "a report makes the same bytes again"


@pytest.mark.parametrize("name", TABLE)
def test_broken_files_are_refused_with_their_place(name: str, tmp_path: Path) -> None:
    for file, data in TABLE[name][1].items():
        (tmp_path / file).write_bytes(data)
        code, said = call(f"{name} {tmp_path / file}")
        assert code == 2
        assert str(tmp_path / file) in said and "Traceback" not in said


@pytest.mark.parametrize("name", TABLE)
def test_missing_sources_and_unknown_words(name: str, tmp_path: Path) -> None:
    if craft(name).reads:
        code, said = call(f"{name} {tmp_path}/none{next(iter(TABLE[name][1]))[3:]}")
        assert code == 2 and "no such file" in said
    code, said = call(f"{name} --no-such-option")
    assert code == 2 and "no such option '--no-such-option'\n  " in said and "Usage" not in said
    code, said = call(f"{name} {'x.svg' if craft(name).reads else ''} -o {tmp_path}/a.nothing")
    assert code == 2 and "makes no" in said, said
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("name", TABLE)
def test_help_names_every_option_and_view(name: str) -> None:
    code, said = call(f"{name} --help")
    assert code == 0
    what = craft(name)
    flags = {"--" + f.rstrip("_").replace("_", "-") for f in what.params.asked()}
    assert all(flag in said for flag in flags)
    assert all(view in said for view in what.views)
    assert all(what.params.help(name) for name in what.params.model_fields), "every option says what it does"


@pytest.mark.parametrize("name", ["sweep", "tiles", "studio", "examples", "formats"])
def test_help_keeps_the_lines_of_its_examples(name: str) -> None:
    code, said = call(f"{name} --help")
    assert code == 0 and "\\b" not in said
    # Nothing follows an example but another in a line of its own.
    assert all(line.index("tambour ") == 2 for line in said.splitlines()[1:] if f"tambour {name} " in line)


def shell(line: str, folder: Path) -> subprocess.CompletedProcess[str]:
    line = line.replace("tambour", f"{sys.executable} -m tambour")
    return subprocess.run(["bash", "-c", line], cwd=folder, capture_output=True, text=True, timeout=300)


@pytest.mark.slow
def test_streams_that_are_full_or_closed(tmp_path: Path) -> None:
    full = shell("tambour formats > /dev/full", tmp_path)
    assert full.returncode == 2 and full.stderr == "cannot be printed: No space left on device\n"
    piped = shell("tambour formats | true; exit ${PIPESTATUS[0]}", tmp_path)
    assert piped.returncode == 0 and not piped.stderr
    closed = shell("tambour ink --span 300 -o a.svg <&- >&- 2>&-", tmp_path)
    assert closed.returncode == 0
    assert (tmp_path / "a.svg").read_text().startswith("<svg") and (tmp_path / "a.svg").read_text().endswith("</svg>\n")


@pytest.mark.slow
def test_a_process_may_be_copied_after_a_run(tmp_path: Path) -> None:
    """Threads of OpenMP once ended each copy: no pool may outlive its work."""
    code = (
        "import os, sys\nfrom tambour.run import run, craft\np = craft('ink').params(span=600)\n"
        "run('ink', None, p, ['a.svg'])\npid = os.fork()\nrun('ink', None, p, [f'b{pid == 0}.svg'])\n"
        "sys.exit(os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1]) if pid else 0)\n"
    )
    made = subprocess.run([sys.executable, "-c", code], cwd=tmp_path, capture_output=True, text=True, timeout=300)
    assert made.returncode == 0, made.stderr
    assert len({p.read_bytes() for p in tmp_path.glob("*.svg")}) == 1 and len(list(tmp_path.glob("*.svg"))) == 3


@pytest.mark.slow
def test_a_number_of_threads_that_is_none_is_told(tmp_path: Path) -> None:
    for bad in ("x", "0", "-1", "9" * 5000):
        told = shell(f"TAMBOUR_THREADS={bad} tambour ink --span 300", tmp_path)
        assert told.returncode == 2 and told.stderr == "TAMBOUR_THREADS: wanted a number of threads from 1 to 256\n"


BALL = b": MR(6)\n: 6 inc (12)\n: 6 dec (6)\nFO\n"


def piped(*words: str, given: bytes = b"", cwd: Path) -> subprocess.CompletedProcess[bytes]:
    return subprocess.run(
        [sys.executable, "-m", "tambour", *words], input=given, capture_output=True, cwd=cwd, check=False
    )


@pytest.mark.slow
def test_standard_input_and_output_are_files(tmp_path: Path, root: Path) -> None:
    (tmp_path / "ball.acl").write_bytes(BALL)
    piped("crochet", "ball.acl", "-o", "ball.svg", cwd=tmp_path)
    made = piped("crochet", "-", "-o", "-.svg", "-o", "ball.graph.json", given=BALL, cwd=tmp_path)
    assert (
        made.returncode == 0 and made.stdout.replace(b"&lt;stdin&gt;", b"ball") == (tmp_path / "ball.svg").read_bytes()
    )
    assert sorted(p.name for p in tmp_path.iterdir()) == ["ball.acl", "ball.graph.json", "ball.svg"]
    rose = (root / "examples" / "knit" / "rose.png").read_bytes()
    chart = piped("knit", "-", "--stitches", "12", "-o", "-.csv", given=rose, cwd=tmp_path)
    assert chart.returncode == 0 and chart.stdout.count(b"\n") > 5 and b"#" in chart.stdout, chart.stderr
    wrong = piped("crochet", "-", "--check", given=b": MR(6)\n: 6 inx (12)\n", cwd=tmp_path)
    assert wrong.returncode == 2 and b"<stdin>:2:" in wrong.stderr and not wrong.stdout


def test_standard_output_takes_one_file_of_a_kind(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Any) -> None:
    monkeypatch.chdir(tmp_path)
    for words, told in (
        (["-o", "-"], "such as: -o -.svg"),
        (["-o", "-.svg", "-o", "-.png"], "standard output takes one file"),
    ):
        with pytest.raises(SystemExit) as left:
            main(["ink", "--seed", "1", "--span", "60", *words])
        assert left.value.code == 2 and told in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []


def test_a_folder_that_is_gone_is_told(tmp_path: Path) -> None:
    gone = tmp_path / "gone"
    gone.mkdir()
    command = f"cd {gone} && rmdir {gone} && {sys.executable} -m tambour formats"
    ran = subprocess.run(["bash", "-c", command], capture_output=True, text=True)
    assert ran.returncode == 2 and ran.stderr == "the folder that you are in is not there any more; go to another\n"


def test_a_verdict_is_one_line_and_how_a_piece_was_reached_is_told_where_all_is_asked_for(tmp_path: Path) -> None:
    """What a designer cannot use stood between what she asked for: forces, evaluations, nodes."""
    egg = tmp_path / "egg.txt"
    egg.write_text(
        "Egg\n\nYarn: DK, cream\n\nRnd 1: 6 sc in magic ring (6)\nRnd 2: inc x 6 (12)\nRnd 3: dec x 6 (6)\nFasten off.\n"
    )
    code, said = call(f"crochet {egg} --check")
    assert (code, said.splitlines()) == (0, ["check: no mistake found: 3 rounds, 3 stated counts"]), said
    inner = ("nodes:", "edges:", "residual:", "evaluations:")
    _, said = call(f"crochet {egg} -o {tmp_path}/egg.json")
    assert "yarn metres:" in said and "wrote" in said
    assert not [word for word in inner if word in said], said
    _, said = call(f"crochet {egg} -o {tmp_path}/egg.json --verbose")
    assert not [word for word in inner if word not in said], said
    _, said = call(f"crochet {egg} --check --verbose")
    assert "nodes:" in said

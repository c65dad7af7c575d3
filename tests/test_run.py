"""Run, params and the command line, on a craft of the tests' own: what holds for every craft."""

from __future__ import annotations

import json
from pathlib import Path
from types import SimpleNamespace
from typing import Any, Literal

import click
import pytest
from click.testing import CliRunner
from pydantic import Field

from tambour import cli
from tambour import run as runner
from tambour.core.drawing import Drawing, Styles
from tambour.core.errors import TambourError, Text
from tambour.core.params import Degrees, Duration, Length, Params, file
from tambour.core.paths import Paths
from tambour.core.progress import Progress, Stopped
from tambour.craft import Craft, View


class WeaveParams(Params):
    """Parameters of a craft that exists in the tests alone."""

    width: Length = Field(default=100, gt=0, le=1000)
    """Width of the cloth."""
    angle: Degrees = 0
    """Angle of the twill."""
    ends: int = Field(default=10, ge=2)
    """Warp ends."""
    structure: Literal["plain", "twill"] = "plain"
    """Weave structure."""
    fringe: bool = False
    """Leave a fringe."""
    budget: Duration | None = None
    """Longest time at the loom."""
    draft: Any = file("Text", "A draft to follow.")
    colors: tuple[str, ...] = ()
    """Colours, in order."""


def weave(source: Text | None, params: WeaveParams, progress: Progress) -> dict[str, Any]:
    with progress.stage("weave"):
        for k in range(params.ends):
            progress.step(k, params.ends)
        if params.ends == 13:
            raise ZeroDivisionError("a fault of ours")
        if params.ends == 12:
            progress.warn("twelve ends are few", hint="take more")
    return {"params": params, "text": source.text if source else ""}


def cloth(piece: dict[str, Any]) -> Drawing:
    width = piece["params"].width
    return Drawing(Paths.of([[[0, 0], [width, width]]]), [0], Styles.of((None, (0, 0, 0, 255), 1)), [width, width])


def bad_view(piece: dict[str, Any]) -> Drawing:
    raise TambourError("this view cannot be made of it")


WEAVE = Craft(
    "weave",
    "a draft becomes cloth",
    WeaveParams,
    ("Text",),
    weave,
    {
        "cloth": View(cloth, "Drawing", "the cloth", (".svg", ".png")),
        "back": View(cloth, "Drawing", "its back"),
        "bad": View(bad_view, "Drawing", "never"),
        "draft": View(lambda piece: Text(piece["text"]), "Text", "the draft", (".txt",)),
    },
    facts=lambda piece: {"ends": piece["params"].ends},
    optional_source=True,
)


@pytest.fixture(autouse=True)
def table(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(runner.CRAFTS, "weave", ("test_run:WEAVE", "a draft becomes cloth"))
    monkeypatch.setattr(runner, "craft", lambda name: WEAVE)


def call(*words: str | Path) -> tuple[int, str]:
    said = CliRunner().invoke(click.Command("t", callback=lambda: cli.main([str(w) for w in words])), [])
    return said.exit_code, said.output


def test_units_are_understood_at_the_surface() -> None:
    made = WeaveParams.of({"width": "2.5cm", "angle": "30deg", "budget": "3h"})
    assert (made.width, made.angle, made.budget) == (25.0, 30.0, 10800.0)
    assert WeaveParams.of({"width": "1in"}).width == pytest.approx(25.4)
    assert WeaveParams.of({"width": 7}).width == 7


def test_everything_wrong_is_said_at_once() -> None:
    with pytest.raises(TambourError) as caught:
        WeaveParams.of({"width": "2 miles", "ends": "1", "structure": "satin", "colour": "red"})
    said = str(caught.value).split("\n")
    assert len(said) == 5
    assert said[0].startswith("--width: '2 miles' is not a number with one of the units mm, cm")
    assert said[1] == "--ends: input should be greater than or equal to 2 (got '1')"
    assert said[3:] == ["--colour: there is no such parameter", '  did you mean "colors"?']


def test_infinite_and_missing_numbers_are_refused() -> None:
    for word in ("inf", "nan", "1e999", ""):
        with pytest.raises(TambourError):
            WeaveParams.of({"width": word})


def test_keys_depend_on_content_only() -> None:
    a = WeaveParams(draft=Text("x", "a.txt"))
    assert a.key() == WeaveParams(draft=Text("x", "a.txt")).key() != WeaveParams(draft=Text("y", "a.txt")).key()
    assert WeaveParams(width=7).key() != WeaveParams(width=8).key()
    assert hash(WeaveParams(width=7)) == hash(WeaveParams(width=7))


def test_outputs_are_read_by_suffix_and_view() -> None:
    def views(*names: str) -> list[tuple[str, str]]:
        return [(o.path.name, o.view) for o in runner.outputs(WEAVE, names, "shawl")]

    assert views("a.svg", "a.back.svg", "a.txt") == [("a.svg", "cloth"), ("a.back.svg", "back"), ("a.txt", "draft")]
    assert views("v1.2.png", "my.front.svg") == [("v1.2.png", "cloth"), ("my.front.svg", "cloth")]
    assert views(".svg") == [("shawl.svg", "cloth")]
    with pytest.raises(TambourError) as caught:
        runner.outputs(WEAVE, ["a.xyz", "nowhere/a.svg", "a.draft.svg"], "")
    assert len(caught.value.problems) == 3


def test_a_report_is_enough_to_make_the_piece_again(tmp_path: Path) -> None:
    (tmp_path / "draft.txt").write_text("1 2 1 2")
    out, report = tmp_path / "a.svg", tmp_path / "r.json"
    code, said = call(
        "weave", tmp_path / "draft.txt", "-o", out, "--report", report, "--width", "5cm", "--ends", 12, "--fringe"
    )
    assert code == 0, said
    assert "warning: twelve ends are few" in said
    told = json.loads(report.read_text())
    assert list(told)[:5] == ["craft", "version", "edition", "params", "source"]
    assert told["params"]["width"] == 50 and told["params"]["fringe"] is True
    assert set(told["seconds"]) == {"start", "read", "weave", "view", "write"}
    first = out.read_bytes()
    out.unlink()
    code, said = call("run", report)
    assert code == 0 and out.read_bytes() == first and "warning: twelve ends are few" in said, said


def test_file_fields_are_read_for_make(tmp_path: Path) -> None:
    (tmp_path / "d.txt").write_text("draft")
    params = WeaveParams(draft=str(tmp_path / "d.txt"))
    assert runner.load_files(params).draft.text == "draft"
    made = runner.run(WEAVE, None, params)
    assert made["params"]["draft"].endswith("d.txt")
    code, said = call("weave", "--draft", tmp_path / "none.txt")
    assert code == 2 and "no such file" in said


@pytest.mark.parametrize(
    ("words", "code", "said"),
    [
        (("--width", "-3"), 2, "--width: input should be greater than 0"),
        (("--structure", "satin"), 2, "satin"),
        (("--stucture", "plain"), 2, "did you mean"),
        (("none.txt",), 2, "there is no such file"),
        (("--ends", "13"), 1, "This is a fault of tambour"),
        (("-o", "x.xyz"), 2, "weave makes no"),
    ],
)
def test_bad_input_has_one_word_and_a_code(words: tuple[str, ...], code: int, said: str) -> None:
    left, text = call("weave", *words)
    assert left == code, text
    assert said in text
    assert ("Traceback" in text) == (code == 1)


def test_nothing_is_written_or_overwritten_when_one_view_fails(tmp_path: Path) -> None:
    (tmp_path / "a.svg").write_text("old")
    code, _ = call("weave", "-o", tmp_path / "a.svg", "-o", tmp_path / "a.bad.svg")
    assert code == 2
    assert {p.name: p.read_text() for p in tmp_path.iterdir()} == {"a.svg": "old"}


def test_help_tells_units_bounds_and_views() -> None:
    _, said = call("weave", "--help")
    text = " ".join(said.split())
    assert "--width MM" in text and "[default: 100] [> 0, ≤ 1000]" in text
    assert "--fringe / --no-fringe" in text and "[plain|twill]" in text
    assert "draft the draft (.txt)" in text


def test_stages_do_not_count_twice(monkeypatch: pytest.MonkeyPatch) -> None:
    now = [0.0]
    monkeypatch.setattr("tambour.core.progress.time", SimpleNamespace(perf_counter=lambda: now[0]))
    progress = Progress()
    with progress.stage("outer"):
        now[0] += 1.0
        with progress.stage("inner"):
            now[0] += 3.0
        now[0] += 0.5
    assert progress.seconds == {"outer": 1.5, "inner": 3.0}


def test_files_in_each_others_way_are_told_before_any_work(tmp_path: Path) -> None:
    source, out = tmp_path / "d.txt", tmp_path / "a.svg"
    source.write_text("draft")
    for words, said in [
        (("-o", out, "-o", out), "asked for twice"),
        (("-o", source), "this is the source"),
        (("-o", source / "a.svg"), "is a file"),
        (("-o", out, "--report", out), "overwrite"),
        (("-o", out, "--report", tmp_path), "folder"),
        (("-o", out, "--report", source / "r.json"), "folder does not exist"),
        (("-o", tmp_path / f"{'n' * 300}.svg"), "cannot be written"),
        (("-o", out, "--structure", "plain", "--draft", "\udcff"), "no text"),
    ]:
        code, text = call("weave", source, *words)
        assert code == 2 and said in text and "Traceback" not in text, text
        assert sorted(p.name for p in tmp_path.iterdir()) == ["d.txt"] and source.read_text() == "draft"


def test_a_report_that_cannot_be_written_takes_the_files_with_it(tmp_path: Path) -> None:
    (tmp_path / "a.svg").write_text("old")
    code, text = call("weave", "-o", tmp_path / "a.svg", "-o", tmp_path / "b.svg", "--report", "/dev/full")
    assert code == 2 and text.startswith("/dev/full: cannot be written: No space left"), text
    assert {p.name: p.read_text() for p in tmp_path.iterdir()} == {"a.svg": "old"}


def test_what_is_made_once_can_be_written_often(tmp_path: Path) -> None:
    made = runner.make(WEAVE, Text("1 2"), WeaveParams(width=30))
    one = runner.write(made, [tmp_path / "a.svg"])
    other = runner.write(made, [tmp_path / "b.svg", tmp_path / "b.txt"], tmp_path / "r.json")
    assert one["files"] == [str(tmp_path / "a.svg")] and len(other["files"]) == 2
    assert (tmp_path / "a.svg").read_bytes() == (tmp_path / "b.svg").read_bytes()
    assert json.loads((tmp_path / "r.json").read_text())["source"] == one["source"]
    whole = runner.run(WEAVE, Text("1 2"), WeaveParams(width=30), [tmp_path / "a.svg"])
    assert {k: v for k, v in whole.items() if k != "seconds"} == {k: v for k, v in one.items() if k != "seconds"}


@pytest.mark.parametrize(
    "text",
    [
        "[" * 100_000,
        "{}",
        '{"craft": ["ink"]}',
        '{"craft": "weave", "params": [1], "source": null}',
        '{"craft": "weave", "params": {}, "source": {"path": 7}}',
        '{"craft": "weave", "params": {}, "source": null, "files": "a.svg"}',
        '{"craft": "weave", "params": {}, "source": {"sha256": 5}}',
        '{"craft": "weave", "params": {}, "source": null, "edits": "leave:x"}',
    ],
)
def test_what_is_no_report_is_told(text: str, tmp_path: Path) -> None:
    (tmp_path / "r.json").write_text(text)
    code, said = call("run", tmp_path / "r.json")
    assert code == 2 and "not a report" in said, said


def test_who_watches_sees_and_who_leaves_stops(tmp_path: Path) -> None:
    seen: list[Any] = []
    progress = Progress(watch=seen.append)
    asked = []
    for k in range(1000):
        progress.look(lambda k=k: asked.append(k) or k)  # type: ignore[misc,func-returns-value]
    assert seen == asked and seen[0] == 0 and len(seen) < 1000, "looked at now and then, and made only then"
    Progress().look(lambda: pytest.fail("nobody looks"))

    def leave(stage: str, done: int, total: int) -> None:
        if done == 3:
            raise Stopped

    (tmp_path / "a.svg").write_text("old")
    with pytest.raises(Stopped):
        runner.run(WEAVE, None, WeaveParams(), [tmp_path / "a.svg"], Progress(leave))
    assert {p.name: p.read_text() for p in tmp_path.iterdir()} == {"a.svg": "old"}


def test_a_report_from_a_stranger_writes_beside_itself_or_here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    theirs, mine = tmp_path / "theirs", tmp_path / "mine"
    theirs.mkdir()
    mine.mkdir()
    monkeypatch.chdir(mine)
    told = {"craft": "weave", "params": {}, "source": None}
    for name in ("../evil.svg", str(tmp_path / "evil.svg")):
        (theirs / "r.json").write_text(json.dumps({**told, "files": ["a.svg", name]}))
        code, said = call("run", theirs / "r.json")
        assert code == 2 and "would write elsewhere" in said and f"-o {name}" in said, said
    assert [p.name for p in tmp_path.rglob("*.svg")] == []
    code, said = call("run", theirs / "r.json", "-o", tmp_path / "good.svg")
    assert code == 0 and (tmp_path / "good.svg").exists(), said
    for name in ("here.svg", str(theirs / "beside.svg")):
        (theirs / "r.json").write_text(json.dumps({**told, "files": [name]}))
        assert call("run", theirs / "r.json")[0] == 0
    assert sorted(p.name for p in tmp_path.rglob("*.svg")) == ["beside.svg", "good.svg", "here.svg"]


def test_names_that_no_disk_should_hold_are_refused(tmp_path: Path) -> None:
    for bad in ("a\x00.svg", "\ud800.svg", "\x1b[2J.svg", "x" * 20_000 + ".svg"):
        told = {"craft": "weave", "params": {}, "source": None, "files": [bad]}
        (tmp_path / "r.json").write_text(json.dumps(told))
        code, said = call("run", tmp_path / "r.json")
        assert code == 2 and "the name of an output" in said and "\x1b" not in said, said
        (tmp_path / "r.json").write_text(json.dumps({**told, "source": {"path": bad}, "files": []}))
        code, said = call("run", tmp_path / "r.json")
        assert code == 2 and "the name of the source" in said, said

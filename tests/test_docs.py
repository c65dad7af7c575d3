"""The README and the pages of docs: their commands are commands, their code runs, their links and modules are there."""

from __future__ import annotations

import contextlib
import io
import os
import re
import shlex
import shutil
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tambour import examples, run
from tambour.cli import main, tambour
from tambour.core.errors import TambourError

ROOT = Path(__file__).resolve().parent.parent
PAGES = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", ROOT / "CHANGELOG.md", *sorted((ROOT / "docs").glob("*.md"))]
CRAFTS = ("crochet", "knit", "ink", "embroidery")


def blocks(page: Path, kind: str) -> list[str]:
    return re.findall(rf"^```{kind}\n(.*?)^```", page.read_text(encoding="utf-8"), re.M | re.S)


def commands(page: Path) -> list[str]:
    """The commands of a page, without the words behind them that explain them."""
    lines = [line for block in blocks(page, "") for line in block.splitlines() if line.startswith("tambour ")]
    return [re.split(r"\s{3,}|\s+# ", line)[0] for line in lines]


# The recipes' commands build on each other: they are run whole, below.
COMMANDS = [pytest.param(c, id=f"{p.stem}: {c[8:60]}") for p in PAGES if p.stem != "recipes" for c in commands(p)]
CODE = [pytest.param(c, id=f"{p.stem} {k}") for p in PAGES for k, c in enumerate(blocks(p, "python"))]


class Reached(Exception):
    """A command was understood, its files were read, and the piece would be made now."""


@pytest.fixture
def workplace(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder as the pages have it before them: the examples, and files of one's own under the names they use."""
    from tambour import files
    from tambour.core.mesh import Mesh

    monkeypatch.chdir(tmp_path)
    for path in examples.copy(tmp_path / "examples"):
        with contextlib.suppress(shutil.SameFileError):
            shutil.copyfile(path, tmp_path / path.name)
    for name in ("photo.jpg", "landscape.jpg"):
        shutil.copyfile("fells.jpg", name)
    for name in ("drawing.png", "name.png"):
        shutil.copyfile("cat.png", name)
    for name in ("Lora.ttf", "SomeHan.otf"):
        shutil.copyfile(ROOT / "src" / "tambour" / "render" / "fonts" / "Inter-Regular.otf", name)
    (tmp_path / "my-fonts" / "marigold").mkdir(parents=True)  # a font for Ink/Stitch
    (tmp_path / "my-fonts" / "marigold" / "font.json").write_text('{"name": "Marigold"}')
    letters = "".join(
        f'<g inkscape:label="GlyphLayer-{c}"><path d="M5 0 V-60" stroke="red" stroke-width="9"/></g>' for c in "Ana"
    )
    (tmp_path / "my-fonts" / "marigold" / "ltr.svg").write_text(
        '<svg xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape"'
        f' width="90" height="90">{letters}</svg>'
    )
    chart = files.read(tmp_path / "band.csv", ["Chart"])
    files.write(chart, tmp_path / "chart.png", "Chart")
    (tmp_path / "cat.json").write_text(__import__("json").dumps(chart.plain()))
    plan = files.read(tmp_path / "boat.dst", ["ThreadPlan"])
    for name in ("old.pes", "old.vp3"):
        files.write(plan, tmp_path / name, "ThreadPlan")
    corners = np.array([(0, 0, 0), (60, 0, 0), (60, 60, 0), (0, 60, 10)], float)
    files.write(Mesh(corners, np.array([(0, 1, 2), (0, 2, 3)])), tmp_path / "plush.surface.glb", "Mesh")
    files.write(Mesh(corners, np.array([(0, 1, 2), (0, 2, 3), (0, 3, 1), (1, 3, 2)])), tmp_path / "bunny.stl", "Mesh")
    half = '<path id="Head" d="M0 5 C20 5 33 18 37 35 C42 60 30 80 19 80" fill="none" stroke="black"/>'
    for name in ("pear.svg", "head.svg", "bear.outline.svg"):
        (tmp_path / name).write_text(
            f'<svg xmlns="http://www.w3.org/2000/svg" width="80mm" height="90mm" viewBox="0 0 80 90">{half}</svg>'
        )
    return tmp_path


@pytest.mark.parametrize("command", COMMANDS)
@pytest.mark.slow
def test_a_command_of_the_docs_is_one(command: str, workplace: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    words = shlex.split(command)[1:]
    if words[0] == "studio":  # it would serve until somebody closes it
        assert tambour.commands["studio"].make_context("studio", words[1:]).params
        return
    if words[0] in ("sweep", "tiles"):  # its pieces would be made in other processes: all is judged, nothing is made
        monkeypatch.setattr("tambour.sweep.course.pool", lambda *given: None)
        for place in ("sweep.course.course", "tiles.leave.into_folder", "tiles.leave.into_zip"):
            monkeypatch.setattr(f"tambour.{place}", lambda *given: iter(()))
    known = run.craft

    def stopped(name: str) -> object:
        def make(*given: object) -> None:
            raise Reached

        return replace(known(name), make=make)

    monkeypatch.setattr(run, "craft", stopped)
    said = io.StringIO()
    try:
        with contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
            main(words)
    except SystemExit as left:
        # Reached passes through main as a fault of ours, and is told as one; nothing else may stop a command.
        assert "Reached" in said.getvalue() or (words[0] not in CRAFTS and left.code == 0), said.getvalue()
    if words[0] in CRAFTS:
        what = known(words[0])
        out = [words[k + 1] for k, w in enumerate(words) if w == "-o"]
        given = {"photo": True} if "--photo" in words else {}
        run.outputs(what, out, "name", what.prefer(what.params(**given)))


@pytest.mark.slow
@pytest.mark.parametrize("command", [pytest.param(c, id=c[8:60]) for c in commands(ROOT / "README.md")])
def test_the_commands_of_the_readme_do_what_they_say(command: str, workplace: Path) -> None:
    words = shlex.split(command)[1:]
    with pytest.raises(SystemExit) as left:
        main(words)
    assert left.value.code == 0
    assert all(Path(words[k + 1]).exists() for k, w in enumerate(words) if w in ("-o", "--report"))


RECIPES = blocks(ROOT / "docs" / "recipes.md", "")


@pytest.mark.slow
@pytest.mark.parametrize("recipe", [pytest.param(r, id=r.split()[1] + str(k)) for k, r in enumerate(RECIPES)])
def test_the_recipes_do_what_they_say(recipe: str, workplace: Path) -> None:
    for line in recipe.splitlines():
        words = shlex.split(line)[1:]
        with pytest.raises(SystemExit) as left:
            main(words)
        assert left.value.code == 0, line
        assert all(Path(words[k + 1]).exists() for k, w in enumerate(words) if w == "-o")


@pytest.mark.slow
@pytest.mark.parametrize("code", CODE)
def test_code_of_the_docs_runs(code: str, workplace: Path) -> None:
    exec(compile(code, "<docs>", "exec"), {})


@pytest.mark.parametrize("page", PAGES, ids=lambda p: p.stem)
def test_links_and_modules_are_there(page: Path) -> None:
    text = page.read_text(encoding="utf-8")
    for target in re.findall(r"\]\(([^)\s]+)\)", text):
        if "://" not in target:
            path, _, anchor = target.partition("#")
            other = page.parent / path if path else page
            assert other.exists(), target
            heads = re.findall(r"^#+ (.*)$", other.read_text(encoding="utf-8"), re.M) if anchor else []
            assert not anchor or anchor in [re.sub(r"[^\w\- ]", "", h.lower()).replace(" ", "-") for h in heads], target
    source = ROOT / "src" / "tambour"
    craft = next((c for c in CRAFTS if page.stem.startswith(c)), "")
    for name in re.findall(r"`((?:[\w-]+/)*[\w-]+\.(?:py|toml))`", text):
        assert any((base / name).exists() for base in (ROOT, source, source / craft, ROOT / "docs")), name


def test_the_examples_are_copied_and_nothing_is_overwritten(tmp_path: Path) -> None:
    made = examples.copy(tmp_path / "new" / "place")
    assert {p.suffix for p in made} >= {".acl", ".txt", ".svg", ".jpg", ".png", ".csv", ".dst"} and len(made) > 30
    assert not any(p.suffix == ".py" for p in made)
    assert examples.copy(tmp_path / "new" / "place") == made  # once more is the same
    frog = tmp_path / "new" / "place" / "crochet" / "frog.acl"
    frog.write_text("mine")
    with pytest.raises(TambourError, match="another file"):
        examples.copy(tmp_path / "new" / "place")
    assert frog.read_text() == "mine"


@pytest.mark.slow
def test_the_wheel_holds_examples_and_languages(tmp_path: Path) -> None:
    import subprocess
    import sys
    import zipfile

    pytest.importorskip("hatchling")
    made = subprocess.run(
        [sys.executable, "-m", "hatchling", "build", "-t", "wheel", "-d", str(tmp_path)],
        cwd=ROOT,
        capture_output=True,
        text=True,
        env=os.environ,
    )
    assert made.returncode == 0, made.stderr
    (wheel,) = tmp_path.glob("*.whl")
    names = set(zipfile.ZipFile(wheel).namelist())
    kept = {f"tambour/examples/{p.relative_to(ROOT / 'examples')}" for p in (ROOT / "examples").rglob("*.acl")}
    assert (
        kept <= names and "tambour/crochet/words/de.toml" in names and "tambour/crochet/language/pattern.lark" in names
    )

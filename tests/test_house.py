"""The house itself: floors, sizes of rooms, what is loaded when, no paths of one machine."""

from __future__ import annotations

import importlib.util
import os
import re
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import tambour as package
from tambour.run import CRAFTS

HEAVY = {"numpy", "numba", "scipy", "shapely", "skia", "PIL", "pydantic", "lark", "rich", "pystitch", "fontTools"}


def loaded(code: str) -> set[str]:
    """The heavy packages that a program leaves loaded."""
    text = f"{code}\nimport sys; print(' '.join(sys.modules))"
    made = subprocess.run([sys.executable, "-c", text], capture_output=True, text=True, check=True)
    return HEAVY & set(made.stdout.split())


def test_help_loads_nothing_heavy() -> None:
    code = "import sys\nfrom tambour.cli import main\ntry: main(['--help'])\nexcept SystemExit: pass"
    assert loaded(code) == set()
    assert loaded("import tambour") == set()


def test_help_of_a_craft_loads_no_kernels() -> None:
    for name in CRAFTS:
        code = f"from tambour.cli import main\ntry: main(['{name}', '--help'])\nexcept SystemExit: pass"
        assert loaded(code) <= {"pydantic"}, name


def test_floors_hold(root: Path) -> None:
    made = subprocess.run(["lint-imports"], cwd=root, capture_output=True, text=True, env=_path())
    assert made.returncode == 0, made.stdout


def _path() -> dict[str, str]:
    return os.environ | {"PATH": f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"}


def test_every_craft_is_in_the_floors_contract(root: Path) -> None:
    assert "crochet | knit | ink | embroidery | files" in (root / "pyproject.toml").read_text()


def test_public_names_are_there() -> None:
    assert all(getattr(package, name) is not None for name in package.__all__)
    assert "numpy" not in dir(package)


def test_every_lazy_name_is_there() -> None:
    from tambour.craft import Lazy
    from tambour.run import craft

    named = [f for c in map(craft, CRAFTS) for f in [c.make, c.facts, c.warm, *(v.make for v in c.views.values())]]
    assert all(callable(f.found) for f in named if isinstance(f, Lazy))


def test_the_list_of_rooms_is_true(root: Path) -> None:
    spec = importlib.util.spec_from_file_location("rooms", root / "docs" / "rooms.py")
    assert spec and spec.loader
    rooms = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(rooms)
    assert rooms.text() == (root / "docs" / "rooms.md").read_text(), "run python docs/rooms.py"


def test_rooms_are_small(root: Path) -> None:
    lines = {p: len(p.read_text().splitlines()) for p in (root / "src").rglob("*.py")}
    assert max(lines.values()) <= 500, max(lines, key=lambda p: lines[p])


def test_no_machine_and_no_unfinished_work_is_named(root: Path) -> None:
    folders = ("src", "docs", "tests", "bench", "examples", ".ci")
    texts = [p for f in folders for p in (root / f).rglob("*") if p.suffix in {".py", ".md", ".acl", ".lark", ""}]
    bad = re.compile(
        r"/(?:wo" + r"rk|tm" + r"p|ro" + r"ot|home)/[A-Za-z.]|\b(?:TO" + r"DO|FIX" + r"ME)\b|NotImpl" + "ementedError"
    )
    for path in texts:
        if path.is_file() and "__pycache__" not in path.parts:
            assert not bad.search(path.read_text()), path


def test_a_cache_that_cannot_be_written_is_not_fatal(root: Path, tmp_path: Path) -> None:
    code = (
        "import numpy as np\nfrom tambour import noise\n"
        "assert noise.uniform(np.uint64(3), np.uint64(5)) == noise.uniform(np.uint64(3), np.uint64(5))"
    )
    (tmp_path / "file").write_text("")
    env = os.environ | {"NUMBA_CACHE_DIR": str(tmp_path / "file" / "cache")}
    made = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, env=env)
    assert made.returncode == 0, made.stderr


def test_version_and_unknown_commands(tambour: Callable[..., subprocess.CompletedProcess[str]]) -> None:
    assert tambour("--version").stdout.startswith("tambour, version 0.")
    made = tambour("crotchet")
    assert made.returncode == 2 and 'did you mean "crochet"' in made.stderr

"""The house itself: floors, sizes of rooms, what is loaded when, no paths of one machine."""

from __future__ import annotations

import ast
import importlib
import importlib.util
import os
import re
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

import tambour as package
from tambour.core.kernels import signature
from tambour.files import WRITE, can_write
from tambour.run import CRAFTS, craft

HEAVY = {"numpy", "numba", "scipy", "shapely", "skia", "PIL", "pydantic", "rich", "pystitch", "fontTools"}


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

    named = [f for c in map(craft, CRAFTS) for f in [c.make, c.facts, *(v.make for v in c.views.values())]]
    assert all(callable(f.found) for f in named if isinstance(f, Lazy))


def test_the_list_of_rooms_is_true(root: Path) -> None:
    spec = importlib.util.spec_from_file_location("rooms", root / "docs" / "rooms.py")
    assert spec and spec.loader
    rooms = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(rooms)
    assert rooms.text() == (root / "docs" / "rooms.md").read_text(), "run python docs/rooms.py"
    there = {p.stem for p in (root / "src" / "tambour").iterdir() if p.suffix == ".py" or (p / "__init__.py").exists()}
    assert set(rooms.FLOORS) == there - {"__init__", "__main__"}, "a floor is missing in docs/rooms.py"


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


def _called(root: Path) -> dict[str, set[str]]:
    """The kernels that modules of ours name outside kernels, and those modules."""
    paths = {p: ".".join(p.relative_to(root / "src").with_suffix("").parts) for p in (root / "src").rglob("*.py")}
    paths |= {p: f"{f}.{p.stem}" for f in ("tests", "bench") for p in (root / f).rglob("*.py")}
    trees = {name.removesuffix(".__init__"): ast.parse(p.read_text()) for p, name in paths.items()}

    def marked(node: ast.AST) -> bool:
        return isinstance(node, ast.FunctionDef) and any(
            ast.unparse(d) in ("kernel", "inner") for d in node.decorator_list
        )

    kernels = {
        f"{m}.{n.name}" for m, t in trees.items() for n in t.body if marked(n) and isinstance(n, ast.FunctionDef)
    }
    called: dict[str, set[str]] = {}
    for module, tree in trees.items():
        names = {k.rpartition(".")[2]: k for k in kernels if k.rpartition(".")[0] == module}
        for node in ast.walk(tree):
            if isinstance(node, ast.ImportFrom) and node.module:
                names |= {a.asname or a.name: f"{node.module}.{a.name}" for a in node.names}
        outside = [n for n in tree.body if not marked(n)]
        for node in (n for top in outside for n in ast.walk(top)):
            if isinstance(node, ast.Name) and names.get(node.id) in kernels:
                called.setdefault(names[node.id], set()).add(module)
            if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name):
                full = f"{names.get(node.value.id)}.{node.attr}"
                if full in kernels:
                    called.setdefault(full, set()).add(module)
    return called


@pytest.mark.slow  # every module, test and bench is parsed
def test_kernels_that_python_calls_declare_their_types(root: Path) -> None:
    called = _called(root)
    assert len(called) > 100
    for full in sorted(called):
        module, _, name = full.rpartition(".")
        made = getattr(importlib.import_module(module), name)
        assert signature(getattr(made, "py_func", made)) is not None, f"{full}, called in {called[full]}"


def test_benches_and_examples_name_what_is_there() -> None:
    gone, root = [], Path(__file__).resolve().parent.parent
    for path in [*(root / "bench").glob("*.py"), *(root / "examples").rglob("*.py")]:
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("tambour"):
                module = importlib.import_module(str(node.module))
                gone += [
                    f"{path.name}:{node.lineno} {node.module}.{a.name}"
                    for a in node.names
                    if not hasattr(module, a.name) and importlib.util.find_spec(f"{node.module}.{a.name}") is None
                ]
    assert not gone


def test_what_a_view_is_written_as_has_a_writer_and_what_is_written_a_view() -> None:
    seen = {
        (suffix, view.value, f"{name}'s view {called}")
        for name in CRAFTS
        for called, view in craft(name).views.items()
        for suffix in view.suffixes
    }
    assert [where for suffix, kind, where in sorted(seen) if not can_write(suffix, kind)] == []
    # Pictures and pages in another coat have no view of their own: `-o NAME.VIEW.tif` asks for them.
    coats = {".bmp", ".tif", ".tiff", ".html"}
    assert {suffix for suffix, _ in WRITE} - {suffix for suffix, *_ in seen} == coats


def test_nothing_is_written_but_through_the_sink(root: Path) -> None:
    """Who opens a path to write, and why it is no piece: a library's writer that is given a path passes over a full disk."""
    known = {
        "cli/process.py": "standard input, kept to be read; what is printed goes nowhere",
        "files/sink.py": "the sink",
        "files/usd.py": "arrays that a process of its own hands over",
        "studio/pool.py": "what users give, in the folder of a worker",
        "studio/serve.py": "the token, for its owner's eyes",
        "studio/worker.py": "what a worker hands over",
        "work/local.py": "what a job's source is, in the folder of a worker",
        "work/worker.py": "answers, on its pipe",
    }
    found = set()
    source = root / "src" / "tambour"
    for path in source.rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text())):
            if not isinstance(node, ast.Call):
                continue
            called = node.func.attr if isinstance(node.func, ast.Attribute) else getattr(node.func, "id", "")
            modes = [
                a.value for a in (*node.args[:2], *(k.value for k in node.keywords)) if isinstance(a, ast.Constant)
            ]
            opens = called in ("open", "fdopen", "FileIO") and any(
                isinstance(m, str) and re.fullmatch(r"[waxrb+t]*[wax+][b+t]*", m) for m in modes
            )
            if called in ("write_bytes", "write_text", "FILEWStream", "imsave") or opens:
                found.add(path.relative_to(source).as_posix())
    assert found - {"files/film.py"} == set(known), "av.open of film.py writes into memory"

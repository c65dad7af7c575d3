"""Examples in docstrings: every one does what it says, and every public function has one."""

from __future__ import annotations

import doctest
import inspect
import re
from importlib import import_module
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

from tambour.examples import copy

ROOT = Path(__file__).resolve().parents[1]
SOURCES = sorted((ROOT / "src" / "tambour").rglob("*.py"))
SHOWN = [p for p in SOURCES if re.search(r"^ *>>> ", p.read_text(encoding="utf-8"), re.MULTILINE)]


def name(path: Path) -> str:
    return ".".join(path.relative_to(ROOT / "src").with_suffix("").parts).removesuffix(".__init__")


@pytest.fixture(scope="module")
def desk(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder where somebody has said `tambour examples examples`."""
    folder = tmp_path_factory.mktemp("desk")
    copy(folder / "examples")
    return folder


@pytest.mark.parametrize("path", SHOWN, ids=name)
def test_an_example_does_what_it_says(path: Path, desk: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(desk)
    module = import_module(name(path))
    finder = doctest.DocTestFinder(exclude_empty=True)
    runner = doctest.DocTestRunner(verbose=False)
    said: list[str] = []
    for test in finder.find(module, name(path)):
        runner.run(test, out=said.append)
    assert not runner.failures, "".join(said)
    assert runner.tries


def public() -> dict[str, Any]:
    """What the book's reference lists, with the methods and properties of its classes."""
    found: dict[str, Any] = {}
    page = (ROOT / "docs" / "api.md").read_text(encoding="utf-8")
    for where, members in re.findall(r"^::: ([\w.]+)\n +options:\n +members: \[(.*)\]", page, re.MULTILINE):
        module: ModuleType = import_module(where)
        for member in members.split(", "):
            thing = getattr(module, member)
            found[f"{where}.{member}"] = thing
            for called, part in vars(thing).items() if inspect.isclass(thing) else ():
                part = part.fget if isinstance(part, property) else getattr(part, "__func__", part)
                if inspect.isfunction(part) and not called.startswith("_") and part.__module__ == where:
                    found[f"{where}.{member}.{called}"] = part
    return found


def test_every_public_function_has_an_example() -> None:
    listed = public()
    assert len(listed) > 60
    assert [called for called, thing in listed.items() if ">>> " not in (thing.__doc__ or "")] == []


def test_all_that_is_promised_is_listed() -> None:
    import tambour

    listed = {called.rsplit(".", 1)[1] for called in public()}
    assert set(tambour.__all__) - {"__version__", "CRAFTS"} <= listed

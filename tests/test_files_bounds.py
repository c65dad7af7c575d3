"""Every reader has a bound, and says so in place of going on: the bounds made small, each meets a file beyond it."""

from __future__ import annotations

import zipfile
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest

from tambour import files
from tambour.core.errors import TambourError
from test_files_sink import value

NEST = "<g>" * 9 + '<path d="M0 0h9v9z"/>' + "</g>" * 9
SVG = (
    '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 90 90" width="90mm" height="90mm">'
    f'<g id="a">{NEST}<circle cx="5" cy="5" r="4"/></g><use href="#a"/><use href="#a" x="9"/></svg>'
)
BOUNDS = [
    ("picture", "LARGEST", 100, "a.png"),
    ("svg.tree", "LARGEST", 100, "a.svg"),
    ("svg.tree", "MOST", 5, "a.svg"),
    ("svg.tree", "DEEPEST", 6, "a.svg"),
    ("svg.read", "POINTS", 8, "a.svg"),
    ("svg.read", "COPIES", 1, "a.svg"),
    ("records", "_LARGEST", 100, "a.dst"),
    ("records", "_LARGEST", 100, "a.pes"),
    ("glb", "_MOST_NODES", 0, "a.glb"),
    ("glb", "_MOST_VALUES", 2, "a.glb"),
    ("document", "_MOST", 100, "a.docx"),
    ("document", "_MOST", 100, "a.odt"),
    ("font", "LARGEST", 1000, "a.otf"),
]


def laid(path: Path, root: Path) -> Path:
    """A plain file of the kind, small as such files go."""
    if path.suffix == ".svg":
        path.write_text(SVG)
    elif path.suffix == ".otf":
        path.write_bytes((root / "src/tambour/render/fonts/Inter-Regular.otf").read_bytes())
    elif path.suffix in (".docx", ".odt"):
        with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as made:
            made.writestr("word/document.xml" if path.suffix == ".docx" else "content.xml", "<a>" + "x" * 4000 + "</a>")
    else:
        kind = {".png": "Picture", ".glb": "Mesh"}.get(path.suffix, "ThreadPlan")
        files.write(value(kind), path, kind)
    return path


def read(path: Path) -> Any:
    if path.suffix == ".otf":
        from tambour.files.font import read_font

        return read_font(path)
    return files.read(
        path, ("Picture", "Drawing", "ThreadPlan", "Mesh", "Text") if path.suffix != ".png" else ("Picture",)
    )


@pytest.mark.parametrize(("module", "bound", "small", "name"), BOUNDS)
def test_what_is_beyond_a_readers_bound_is_refused_with_its_place(
    module: str, bound: str, small: int, name: str, root: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = laid(tmp_path / name, root)
    if path.suffix not in (".docx", ".odt"):  # those are no documents, but their packing
        read(path)
    monkeypatch.setattr(import_module(f"tambour.files.{module}"), bound, small)
    with pytest.raises(TambourError) as caught:
        read(path)
    assert str(path) in str(caught.value) and len(caught.value.problems) == 1, str(caught.value)

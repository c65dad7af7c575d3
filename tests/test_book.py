"""The book: docs as a site, built without a warning; every page has its place in it."""

from __future__ import annotations

import importlib.util
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent


def test_every_page_stands_in_the_book() -> None:
    listed = set(re.findall(r"[\w-]+\.md", (ROOT / "mkdocs.yml").read_text(encoding="utf-8")))
    assert listed == {p.name for p in (ROOT / "docs").glob("*.md")}


def test_the_gallery_is_what_its_pictures_are_made_by() -> None:
    spec = importlib.util.spec_from_file_location("pictures", ROOT / "docs" / "pictures.py")
    assert spec is not None and spec.loader is not None
    pictures = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(pictures)
    assert (ROOT / "docs" / "gallery.md").read_text(encoding="utf-8") == pictures.gallery()


@pytest.mark.slow
def test_the_book_is_built_without_a_warning(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    commands = pytest.importorskip("mkdocs.commands.build")
    config = pytest.importorskip("mkdocs.config")
    monkeypatch.chdir(ROOT)
    commands.build(
        config.load_config(str(ROOT / "mkdocs.yml"), strict=True, site_dir=str(tmp_path))
    )  # strict: a warning ends it
    api = (tmp_path / "api.html").read_text(encoding="utf-8")
    for name in ("tambour.run.run", "tambour.core.chart.Chart", "tambour.files.write"):
        assert f'id="{name}"' in api
    assert "blockquote" not in api and api.count('class="gp"') > 100, "examples are shown as Python's dialogue"

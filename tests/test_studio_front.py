"""The page's modules keep their floors and sizes, and nothing in them that its policy forbids."""

import gzip
import re
from pathlib import Path

import pytest

WEB = Path(__file__).parents[1] / "src" / "tambour" / "studio" / "web"
JS = WEB / "js"
CRAFTS = ("crochet", "knit", "ink", "embroidery")
MODULES = sorted(JS.rglob("*.js"))
IMPORT = re.compile(r"""(?:from|import)\s*\(?\s*["'](\.[^"']+)["']""")


def imports(module: Path) -> list[str]:
    return [
        (module.parent / found).resolve().relative_to(WEB).as_posix() for found in IMPORT.findall(module.read_text())
    ]


@pytest.mark.parametrize("module", MODULES, ids=lambda m: m.relative_to(JS).as_posix())
def test_floors(module):
    room = module.relative_to(JS).parts[0]
    for found in imports(module):
        assert found.startswith("lib/") or (WEB / found).is_file(), f"imports {found}, which is not there"
        if room in ("gl", "pack.js"):
            assert found.startswith("js/gl/") or (room == "gl" and found == "js/pack.js"), (
                f"{room} knows nothing of ours"
            )
        if room in CRAFTS:
            assert not any(found.startswith(f"js/{other}/") for other in CRAFTS if other != room), "crafts never meet"


def test_sizes():
    for path in [*MODULES, *WEB.glob("css/*.css"), *WEB.glob("*.html")]:
        assert len(path.read_text().splitlines()) <= 500, path


def test_nothing_that_the_policy_forbids():
    for path in [*MODULES, *WEB.glob("*.html")]:
        text = path.read_text()
        inside = re.sub(
            r"const page = `.*?`;", "", text, flags=re.DOTALL
        )  # the shop's page has no server, and no policy
        for what in (r"\sstyle=", r"<style", r"\son[a-z]+=\"", r"https?://(?!www\.w3\.org)", r"\beval\(", r"innerHTML"):
            assert not re.search(what, inside), f"{path.name}: {what}"
        assert not re.findall(r"<script(?![^>]*src=)", inside if path.suffix == ".html" else "")


def test_weight():
    """All that the first page needs, gzipped: 0.35 MB."""
    lib = WEB / "lib"
    if not lib.is_dir():
        pytest.skip("the page is not built: python front/build.py")
    sent = [p for p in WEB.rglob("*") if p.is_file() and p.name not in ("NOTICES", "made.json")]
    assert sum(len(gzip.compress(p.read_bytes())) for p in sent) < 350_000

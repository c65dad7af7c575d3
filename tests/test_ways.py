"""Kernels built, compiled by Numba and plain give the same files: every golden case (by Numba at night), and small pieces of each craft."""

from __future__ import annotations

import importlib.util
import json
import os
import shlex
import subprocess
import sys
from pathlib import Path

import pytest

from night import NIGHT

PROGRAM = """
import contextlib, io, json, sys
from pathlib import Path
from tambour.cli import main
from tambour.core.kernels import RAN
for line in Path(sys.argv[1]).read_text().splitlines():
    said = io.StringIO()
    try:
        with contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
            main(json.loads(line))
    except SystemExit as end:
        assert not end.code, line + said.getvalue()
print(*sorted(set(RAN.values())))
"""

BALL = ": MR(6)\n: 6 inc (12)\n: 12 sc (12)\n: 6 dec (6)\nFO\n"
HEART = '<svg xmlns="http://www.w3.org/2000/svg" width="9mm" height="6mm"><path d="M1 1h7v3h-5z" fill="#c33"/></svg>'
SMALL = [
    "crochet {here}/ball.acl --report {out}/ball.check.json",
    "crochet {here}/ball.acl -o {out}/ball.glb -o {out}/ball.graph.json",
    "knit {examples}/knit/fells.jpg --stitches 30 -o {out}/fells.csv",
    "knit {examples}/knit/rose.png --stitches 24 --style tonal -o {out}/tonal.csv -o {out}/tonal.png",
    "knit {examples}/knit/rose.png --stitches 16 --style tonal --keep 0.1 -o {out}/kept.csv",
    "knit {examples}/knit/rose.png --stitches 12 --style tonal --round -o {out}/round.csv",
    "ink --seed 7 --span 120 -o {out}/ink.svg",
    "embroidery {here}/patch.svg -o {out}/patch.dst -o {out}/patch.png",
]
"""Pieces small enough for plain Python that go through what goldens leave out: settling, yarn, pictures of cloth, rows in single precision."""

PICTURE = """
import numpy as np
from tambour.core.kernels import RAN
from tambour.core.paths import Paths
from tambour.core.strands import Strands
from tambour.geometry.tube import sweep
from tambour.render import raster
t = np.linspace(0.0, 6.0, 9)
ring = Paths(np.stack([8 * np.cos(t), 3 + 2 * np.sin(t), 8 * np.sin(t)], axis=1), np.array([0, 9]))
yarn = Strands(ring, np.full(9, 2.0), np.array([[200, 90, 60]], np.uint8))
made = raster.picture(sweep(yarn, plies=4, wander=0.09), width=12, samples=1, lights=5, table='oak')
print(made.rgba.tobytes().hex(), *sorted(set(RAN.values())))
"""
"""A ring of hairy yarn on a wooden table: the kernels of pictures, which no file of the small pieces asks for."""


def made(way: str, folder: Path, root: Path, golden: bool = True) -> dict[str, bytes]:
    """All files that the golden commands and the small ones leave, by their names; reports without what a run measures."""
    (folder / "ball.acl").write_text(BALL)
    (folder / "patch.svg").write_text(HEART)
    jobs = [
        (path.read_text(), path.parent, f"{path.parts[-3]}-{path.parts[-2]}")
        for path in sorted((root / "tests" / "golden").glob("*/*/command.txt"))
        if golden
    ]
    jobs += [(words, folder, "small") for words in SMALL]
    lines = []
    for words, case, name in jobs:
        out = folder / name
        out.mkdir(exist_ok=True)
        lines.append(json.dumps(shlex.split(words.format(out=out, case=case, here=folder, examples=root / "examples"))))
    (folder / "jobs").write_text("\n".join(lines))
    ran = subprocess.run(
        [sys.executable, "-c", PROGRAM, str(folder / "jobs")],
        env=os.environ | {"TAMBOUR_KERNELS": way}, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert ran.returncode == 0, ran.stderr
    assert ran.stdout.split() == ([] if way == "python" else [way]), ran.stdout
    found = {}
    for path in sorted(p for p in folder.rglob("*") if p.is_file() and p.parent != folder):
        content = path.read_bytes()
        if path.name == "ball.check.json":
            report = json.loads(content)
            content = json.dumps(
                {k: v for k, v in report.items() if k not in ("seconds", "kernels", "source")}
            ).encode()
        found[str(path.relative_to(folder))] = content.replace(str(folder).encode(), b"")
    return found


@pytest.fixture(scope="module")
def native(root: Path, tmp_path_factory: pytest.TempPathFactory) -> dict[str, bytes]:
    if importlib.util.find_spec("tambour.core._native") is None:
        pytest.skip("kernels are not built here")
    return made("native", tmp_path_factory.mktemp("native"), root)


@pytest.mark.slow
@pytest.mark.parametrize("way", ["python", "numba"])
def test_files_are_the_same_whichever_way_kernels_run(
    way: str, native: dict[str, bytes], root: Path, tmp_path: Path
) -> None:
    golden = NIGHT or way == "python"  # Numba compiles for two minutes what the golden pieces ask for: by night
    other = made(way, tmp_path, root, golden)
    assert native.keys() >= other.keys() and len(other) >= (40 if golden else 10)
    assert not golden or native.keys() == other.keys()
    assert [name for name in other if native[name] != other[name]] == []


@pytest.mark.slow
@pytest.mark.parametrize(
    "way", ["python", pytest.param("numba", marks=pytest.mark.skipif(not NIGHT, reason="by night"))]
)
def test_pictures_are_the_same_whichever_way_kernels_run(way: str) -> None:
    if importlib.util.find_spec("tambour.core._native") is None:
        pytest.skip("kernels are not built here")
    said = [
        subprocess.run(
            [sys.executable, "-c", PICTURE],
            env=os.environ | {"TAMBOUR_KERNELS": each}, capture_output=True, text=True, check=True,
        ).stdout.split()
        for each in ("native", way)
    ]  # fmt: skip
    assert said[0][1:] == ["native"] and said[1][1:] == ([] if way == "python" else [way])
    assert said[0][0] == said[1][0] and len(set(bytes.fromhex(said[0][0]))) > 20

"""Golden cases: a folder tests/golden/<craft>/<case>/ is a test.

``command.txt`` holds the words after ``tambour``, with {out} for an output folder, {case} for the case's folder and
{examples} for the examples; every other file is what the command must leave in {out} under that name. Texts are equal
when their words are equal and their numbers agree to 1e-6 of the largest (or to the number in a file ``tolerance``);
pictures are not compared. ``pytest --update-golden`` records them anew.
"""

from __future__ import annotations

import contextlib
import io
import re
import shlex
from pathlib import Path

import pytest

from tambour.cli import main

HERE = Path(__file__).parent / "golden"
CASES = sorted(p.parent for p in HERE.glob("*/*/command.txt"))
NUMBER = re.compile(r"-?(?:\d+\.\d*|\.\d+|\d+)(?:[eE][-+]?\d+)?")
ASIDE = {"command.txt", "tolerance"}
VOLATILE = re.compile(r'^ {2}"(?:seconds|version|files)": .*(?:\n {4}.*)*(?:\n {2}[}\]],?)?\n', re.M)


def difference(made: str, golden: str, tolerance: float) -> str:
    """What differs between two texts, or an empty string."""
    made, golden = VOLATILE.sub("", made), VOLATILE.sub("", golden)
    if NUMBER.sub("#", made) != NUMBER.sub("#", golden):
        for n, (a, b) in enumerate(zip(NUMBER.sub("#", made).split("\n"), NUMBER.sub("#", golden).split("\n")), 1):
            if a != b:
                return f"line {n}: {a[:200]!r}, golden {b[:200]!r}"
        return f"{made.count(chr(10))} lines, golden {golden.count(chr(10))}"
    ours, theirs = ([float(n) for n in NUMBER.findall(t)] for t in (made, golden))
    size = max(map(abs, theirs), default=0.0)
    for k, (a, b) in enumerate(zip(ours, theirs)):
        # The last digit of a rounded number may fall either way.
        if abs(a - b) > tolerance * max(size, 1.0) + 1.01e-3 * (a != round(a)):
            return f"number {k}: {a}, golden {b}"
    return ""


def run(case: Path, out: Path, root: Path) -> None:
    words = (case / "command.txt").read_text().format(out=out, case=case, examples=root / "examples")
    said = io.StringIO()
    with pytest.raises(SystemExit) as left, contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
        main(shlex.split(words))
    assert left.value.code == 0, said.getvalue()


@pytest.mark.parametrize("case", CASES, ids=lambda p: f"{p.parent.name}/{p.name}")
def test_case(case: Path, tmp_path: Path, root: Path, request: pytest.FixtureRequest) -> None:
    run(case, tmp_path, root)
    golden = [p for p in sorted(case.iterdir()) if p.name not in ASIDE]
    if request.config.getoption("--update-golden"):
        for path in golden:
            path.unlink()
        for path in sorted(tmp_path.iterdir()):
            if path.suffix not in {".png", ".glb", ".pdf"}:
                (case / path.name).write_text(VOLATILE.sub("", path.read_text()))
        return
    assert golden, f"{case} holds no golden file: record it with pytest --update-golden"
    tolerance = float((case / "tolerance").read_text()) if (case / "tolerance").exists() else 1e-6
    for path in golden:
        wrong = difference((tmp_path / path.name).read_text(), path.read_text(), tolerance)
        assert not wrong, f"{path.name}: {wrong}"


def test_the_comparison_can_fail() -> None:
    text = '{"nodes": 434, "size": [100.0, 60.25], "craft": "crochet"}'
    assert not difference(text, text, 1e-6)
    assert not difference(text, text.replace("60.25", "60.25001"), 1e-6)
    assert difference(text, text.replace("434", "435"), 1e-6)
    assert difference(text, text.replace("60.25", "60.29"), 1e-6)
    assert difference(text, text.replace("nodes", "edges"), 1e-6)

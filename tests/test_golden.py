"""Golden cases: a folder tests/golden/<craft>/<case>/ is a test.

``command.txt`` holds the words after ``tambour``, with {out} for an output folder, {case} for the case's folder and
{examples} for the examples; every other file is what the command must leave in {out} under that name. Texts are equal
when their words are equal and their numbers agree: each to 1e-6 (or the number in a file ``tolerance``) of the largest
number that stands under the same word, for those share a unit, and to one of its own last digit where it was rounded.
A file ``slow`` says why the case is slow. Pictures are not compared. ``pytest --update-golden`` records them anew.
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
CASES = [
    pytest.param(
        p.parent, marks=[pytest.mark.slow] if (p.parent / "slow").exists() else [], id=f"{p.parts[-3]}/{p.parts[-2]}"
    )
    for p in sorted(HERE.glob("*/*/command.txt"))
]
NUMBER = re.compile(r"-?(?:\d+\.\d*|\.\d+|\d+)(?:[eE][-+]?\d+)?")
NAMED = re.compile(rf"([A-Za-z_][\w-]*)|({NUMBER.pattern})")
ROUNDED = 4  # decimals up to which a number counts as rounded
LEAST = 1e-3  # numbers under a word that are all smaller are told apart as if one were so large
ASIDE = {"command.txt", "tolerance", "slow"}
VOLATILE = re.compile(r'^ {2}"(?:seconds|version|files)": .*(?:\n {4}.*)*(?:\n {2}[}\]],?)?\n', re.M)


def difference(made: str, golden: str, tolerance: float) -> str:
    """What differs between two texts, or an empty string."""
    made, golden = VOLATILE.sub("", made), VOLATILE.sub("", golden)
    if NUMBER.sub("#", made) != NUMBER.sub("#", golden):
        for n, (a, b) in enumerate(zip(NUMBER.sub("#", made).split("\n"), NUMBER.sub("#", golden).split("\n")), 1):
            if a != b:
                return f"line {n}: {a[:200]!r}, golden {b[:200]!r}"
        return f"{made.count(chr(10))} lines, golden {golden.count(chr(10))}"
    ours, theirs = (numbers(t) for t in (made, golden))
    sizes: dict[str, float] = {}
    for word, spelt in theirs:
        sizes[word] = max(sizes.get(word, LEAST), abs(float(spelt)))
    for (_, a), (word, b) in zip(ours, theirs):
        digits = len(b.partition(".")[2]) if "e" not in b.lower() else ROUNDED + 1
        last = 1.01 * 10.0**-digits if 0 < digits <= ROUNDED else 0.0
        if abs(float(a) - float(b)) > tolerance * sizes[word] + last:
            return f"{word}: {a}, golden {b}"
    return ""


def numbers(text: str) -> list[tuple[str, str]]:
    """All numbers of a text, each with the last word before it: a key, an attribute, a command of a path."""
    found, word = [], ""
    for name, number in NAMED.findall(text):
        word = name or word
        if number:
            found.append((word, number))
    return found


def run(case: Path, out: Path, root: Path) -> None:
    words = (case / "command.txt").read_text().format(out=out, case=case, examples=root / "examples")
    said = io.StringIO()
    with pytest.raises(SystemExit) as left, contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
        main(shlex.split(words))
    assert left.value.code == 0, said.getvalue()


@pytest.mark.parametrize("case", CASES)
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
    text = '{"nodes": 434, "size": [100.0, 60.25], "ratio": 0.51234567891, "share": 0.25, "craft": "crochet"}'
    assert not difference(text, text, 1e-6)
    assert not difference(text, text.replace("60.25", "60.26"), 1e-6)  # one of its last digit
    assert not difference(text, text.replace("0.51234567891", "0.51234567893"), 1e-6)
    for good, bad in (
        ("434", "435"),
        ("60.25", "60.29"),
        ("0.51234567891", "0.51235"),  # however large the sizes are
        ("0.25", "0.27"),
        ("nodes", "edges"),
    ):
        assert difference(text.replace(good, bad), text, 1e-6), bad
    path = '<path d="M10.25 20.5L1000.125 3"/><circle r="0.125"/>'
    assert difference(path.replace("0.125", "0.128"), path, 1e-6)
    assert not difference(path.replace("1000.125", "1000.126"), path, 1e-6)

"""Every knitting example runs, makes its files, and keeps its floats."""

from __future__ import annotations

import json
import shlex
from pathlib import Path

import numpy as np
import pytest

from tambour import files
from tambour.cli import main
from tambour.knit.hands.working import floats

EXAMPLES = Path(__file__).resolve().parents[1] / "examples"
COMMANDS = [
    line
    for line in (EXAMPLES / "knit" / "commands.txt").read_text().splitlines()
    if line.strip() and not line.startswith("# ")
]


@pytest.mark.slow
@pytest.mark.parametrize("line", COMMANDS, ids=lambda line: Path(shlex.split(line)[1]).stem)
def test_example(line: str, tmp_path: Path) -> None:
    words = [w.format(examples=EXAMPLES, out=tmp_path) for w in shlex.split(line)]
    small = [w for w in words if not w.endswith((".fabric.png", ".back.png", ".distance.png"))]
    words = [w for k, w in enumerate(words) if w in small and not (w == "-o" and words[k + 1] not in small)]
    words += ["-o", str(tmp_path / "chart.json"), "--report", str(tmp_path / "report.json")]
    with pytest.raises(SystemExit) as left:
        main(words)
    assert left.value.code == 0
    report = json.loads((tmp_path / "report.json").read_text())
    assert report["violations"] == 0 and report["conflicts"] == 0
    assert all(Path(name).stat().st_size > 200 for name in report["files"])
    chart = files.read(tmp_path / "chart.json", ("Chart",))
    limit = report["max_float"]
    assert floats(chart, anchored=True).length.max() <= limit
    assert report["catches"] == 0
    assert all(0 < y["metres"] < 2000 for y in report["yarn"]) and len(report["yarn"]) == len(np.unique(chart.cells))


def test_there_are_six_examples() -> None:
    assert len(COMMANDS) == 6

"""The workflows of a public host: they are YAML of the kind that it reads, and what they run is there."""

from __future__ import annotations

import os
import re
import subprocess
from itertools import product
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).resolve().parents[1]
FLOWS = sorted((ROOT / ".github" / "workflows").glob("*.yml"))


def steps(flow: Any) -> list[str]:
    """The commands of all jobs, once for each cell of their matrix."""
    found = []
    for job in flow["jobs"].values():
        matrix = job.get("strategy", {}).get("matrix", {})
        for values in product(*matrix.values()):
            cell = dict(zip(matrix, values))
            for step in job["steps"]:
                assert ("run" in step) != ("uses" in step), step
                if "run" in step:
                    found.append(
                        re.sub(r"\$\{\{ matrix\.(\w+) \}\}", lambda m, cell=cell: str(cell[m[1]]), step["run"])
                    )
    return found


@pytest.mark.parametrize("path", FLOWS, ids=lambda p: p.stem)
def test_what_a_workflow_runs_is_there(path: Path) -> None:
    flow = pytest.importorskip("yaml").safe_load(path.read_text(encoding="utf-8"))
    assert {"name", "jobs"} <= set(flow) and flow.get("on", flow.get(True))  # YAML takes "on" for true
    for job in flow["jobs"].values():
        assert job["runs-on"] and job["timeout-minutes"] > 0 and job["steps"][0]["uses"].startswith("actions/checkout@")
    lines = steps(flow)
    assert lines and not any("${{" in line for line in lines)
    for line in lines:
        if line.startswith("make "):
            ran = subprocess.run(
                ["make", "-n", *line.split()[1:]], cwd=ROOT, capture_output=True, text=True, check=False
            )
            assert ran.returncode == 0 and "pytest" in ran.stdout, ran.stderr
            named = re.findall(r"tests/[\w/.]+", ran.stdout)
            assert all((ROOT / one).exists() for one in named)
        else:
            assert os.access(ROOT / line, os.X_OK), line

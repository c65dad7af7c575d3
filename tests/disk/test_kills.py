"""Kills: a command that ends in its midst leaves all old files or all new ones, and what a killed one leaves the next run clears.

TAMBOUR_KILLS says how many commands are killed (200 by ``make disk``; 8 by default).
"""

from __future__ import annotations

import json
import os
import random
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

pytestmark = pytest.mark.slow
KILLS = int(os.environ.get("TAMBOUR_KILLS", "8"))
CRAFTS = {
    "crochet": ("crochet {examples}/crochet/coaster.acl", ("o.graph.json", "o.txt", "o.svg")),
    "embroidery": ("embroidery {examples}/embroidery/patch.svg", ("o.dst", "o.pes", "o.svg")),
    "ink": ("ink --seed 7 --span 300", ("o.svg", "o.png", "o.json")),
    "knit": ("knit {examples}/knit/rose.png --stitches 40", ("o.png", "o.csv", "o.svg")),
}


def held(folder: Path, names: list[str]) -> dict[str, bytes]:
    """The files there; of a report its words but for what a run measures."""
    found = {name: (folder / name).read_bytes() for name in names if (folder / name).exists()}
    if (report := found.get("report.json", b"old")) != b"old":
        told = {k: v for k, v in json.loads(report).items() if k != "seconds"}
        found["report.json"] = json.dumps(told).encode()
    return found


@pytest.mark.parametrize("craft", CRAFTS)
def test_a_killed_command_leaves_all_old_files_or_all_new(craft: str, root: Path, tmp_path: Path) -> None:
    words, outs = CRAFTS[craft]
    names = [*outs, "report.json"]
    command = [sys.executable, "-m", "tambour", *words.format(examples=root / "examples").split()]
    command += [w for name in outs for w in ("-o", name)] + ["--report", "report.json", "--quiet"]

    def started() -> subprocess.Popen[bytes]:
        return subprocess.Popen(command, cwd=tmp_path, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)

    began = time.monotonic()
    said = started().communicate()[1]
    took = time.monotonic() - began
    new, old = held(tmp_path, names), dict.fromkeys(names, b"old")
    assert set(new) == set(names), said.decode()
    draw = random.Random(craft)
    ends = set()
    for k in range(max(1, KILLS // len(CRAFTS))):
        for name in names:
            (tmp_path / name).write_bytes(b"old")
        number = (signal.SIGKILL, signal.SIGTERM, signal.SIGINT, signal.SIGHUP)[k % 4]
        running = started()
        # Half of them when files are being made, half at any time.
        last, soon = time.monotonic() + took * draw.uniform(0.3, 1.1), draw.random() < 0.5
        while time.monotonic() < last and running.poll() is None:
            if soon and any(tmp_path.glob(".tambour-*")):
                time.sleep(draw.uniform(0, 0.02))
                break
            time.sleep(0.0005)
        running.send_signal(number)
        said = running.communicate()[1]
        assert b"Traceback" not in said, said.decode()
        litter = {p.name for p in tmp_path.iterdir()} - set(names)
        if number == signal.SIGKILL:
            assert all(name.startswith(".tambour-") for name in litter)
            if litter:  # what the next run does first: it ends what was begun, or clears it away
                started().communicate()
                assert {p.name for p in tmp_path.iterdir()} == set(names)
                continue
        else:
            assert not litter
        now = held(tmp_path, names)
        assert now in (old, new), (number, {n: len(raw) for n, raw in now.items()})
        ends.add(now == new)
    assert KILLS < 40 or ends == {True, False} or ends == {False}

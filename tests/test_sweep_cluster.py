"""Sweeps on Dask: the same bytes as one after another here, whoever is killed.

TAMBOUR_PIECES says how many pieces the heavy tests make (500 by hand; 40 by default).
"""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

from tambour.core.errors import TambourError
from tambour.sweep import sweep
from tambour.sweep.course import planned
from tambour.work import cluster
from tambour.work.cluster import Cluster
from tambour.work.limit import Limit
from tambour.work.piece import make

pytest.importorskip("distributed")
pytestmark = pytest.mark.slow
PIECES = int(os.environ.get("TAMBOUR_PIECES", "40"))


@pytest.fixture(scope="module")
def dask() -> Iterator[Any]:
    """A cluster of two workers, each a process with one thread."""
    from distributed import LocalCluster

    with LocalCluster(
        n_workers=2, threads_per_worker=1, processes=True, dashboard_address="127.0.0.1:0", silence_logs=50
    ) as made:
        yield made


@pytest.fixture
def photos(tmp_path: Path) -> Path:
    """Pictures to knit, a tenth as many as there are pieces; and a poisoned one."""
    folder = tmp_path / "photos"
    folder.mkdir()
    for k in range(PIECES // 10):
        grid = np.indices((24, 24)).sum(0) // (2 + k % 7) % 2 * 200 + k % 50
        Image.fromarray(grid.astype(np.uint8)).save(folder / f"p{k:03}.png")
    return folder


AXES = {"stitches": list(range(20, 30)), "gauge": ["24x32"]}
KINDS = (".png", ".json")


def serial(photos: Path) -> dict[str, bytes]:
    """Every file that the pieces have, made one after another in this process."""
    plan, *_ = planned("knit", [photos], AXES, KINDS, [], "", False)
    made: dict[str, bytes] = {}
    for piece in plan.pieces():
        if not piece.reason:
            laid = {name: Path(name) for name in piece.job.blobs}
            try:
                made.update(make(piece.job, laid).files)
            except TambourError:
                continue
    return made


def left(out: Path) -> dict[str, bytes]:
    return {p.name: p.read_bytes() for p in out.iterdir() if p.name.startswith("p") and p.is_file()}


def test_a_worker_killed_in_the_midst_costs_nothing(dask: Any, photos: Path, tmp_path: Path) -> None:
    poison = photos / "poison.png"
    poison.write_bytes((photos / "p000.png").read_bytes()[:40] + bytes(40))
    out = tmp_path / "out"
    statuses: list[str] = []
    began, spent = time.perf_counter(), time.process_time()
    for k, result in enumerate(
        sweep("knit", [photos], AXES, out, KINDS, scheduler=dask.scheduler_address, sheet=False)
    ):
        statuses.append(result.status)
        if k == PIECES // 2:
            os.kill(next(iter(dask.workers.values())).process.pid, signal.SIGKILL)
        assert result.status == "made" or ("poison" in result.source and "not a picture" in result.reason)
    took = time.perf_counter() - began
    print(f"{len(statuses)} pieces in {took:.1f} s, {time.process_time() - spent:.1f} processor seconds of the client")
    assert sorted(statuses) == ["failed"] * 10 + ["made"] * PIECES
    assert left(out) == serial(photos)


def test_a_client_killed_hard_goes_on_where_it_was(dask: Any, photos: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    words = ["knit", photos, "--set", "stitches=20..29", "--set", "gauge=24x32", "-o", out, "-o", ".png", "-o", ".json"]
    words += ["--scheduler", dask.scheduler_address]
    command = [sys.executable, "-m", "tambour", "sweep", *map(str, words)]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    reports = out / "reports"
    end = time.monotonic() + 300
    while not reports.exists() or len(list(reports.glob("*.json"))) < PIECES // 2:
        assert time.monotonic() < end and process.poll() is None, process.communicate()
        time.sleep(0.01)
    process.kill()
    process.communicate()
    kept = {p.name: p.stat().st_mtime_ns for p in reports.iterdir()}
    assert PIECES // 2 <= len(kept) < PIECES
    done = subprocess.run(command, capture_output=True, text=True, timeout=600)
    assert done.returncode == 0, done.stderr
    assert f"{PIECES - len(kept)} made, {len(kept)} finished before" in done.stdout
    now = {p.name: p.stat().st_mtime_ns for p in reports.iterdir()}
    assert {name: now[name] for name in kept} == kept and len(now) == PIECES
    assert left(out) == serial(photos)


def test_a_cluster_of_our_own_gives_the_same_and_stops_when_asked(photos: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    words = ["knit", photos, "--set", "stitches=20..59", "-o", out, "-o", ".png", "--cluster", "2", "--no-sheet"]
    command = [sys.executable, "-m", "tambour", "sweep", *map(str, words)]
    options: Any = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True, "start_new_session": True}
    process = subprocess.Popen(command, **options)
    end = time.monotonic() + 120
    while not (out / "reports").exists() or len(list((out / "reports").glob("*.json"))) < 5:
        assert time.monotonic() < end and process.poll() is None, process.communicate()
        time.sleep(0.01)
    os.killpg(process.pid, signal.SIGINT)  # as a terminal does
    _, said = process.communicate(timeout=60)
    assert process.returncode == 130 and said.strip().endswith("interrupted; no file is left half written"), said
    for report in (out / "reports").iterdir():
        told = json.loads(report.read_bytes())
        assert [(out / f).stat().st_size for f in told["files"]] == told["sizes"]


def test_a_limit_holds_there_too(dask: Any) -> None:
    address = dask.scheduler_address
    axes = {"seed": [1], "span": [300, 2_000_000]}
    found = list(sweep("ink", axes=axes, files=[".svg"], limit="4s", scheduler=address))
    assert sorted((r.chosen["span"], r.status) for r in found) == [(300, "made"), (2_000_000, "failed")]
    assert "took more than 4 seconds" in next(r.reason for r in found if r.reason)


def test_what_is_no_cluster_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    from distributed import LocalCluster

    monkeypatch.setattr(cluster, "SECONDS", 1.0)
    with pytest.raises(TambourError, match="no scheduler answers"):
        Cluster("tcp://127.0.0.1:1")
    with pytest.raises(TambourError, match="no scheduler answers"):
        Cluster("nonsense://x")
    empty = LocalCluster(n_workers=0, processes=False, dashboard_address="127.0.0.1:0", silence_logs=50)
    with empty, pytest.raises(TambourError, match="the cluster has no workers"):
        Cluster(empty.scheduler_address)
    job = next(planned("ink", [], ["span=300"], [], [], "", False)[0].pieces()).job
    assert "has tambour" in cluster.pieces([job], Limit(), "0.0")[0].reason

"""Full disks: every kind of file, cut short at many places, leaves the old files as they were and says so.

TAMBOUR_PLACES says at how many places each is cut (64 by ``make disk``; 6 by default).
"""

from __future__ import annotations

import os
import resource
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from tambour import files
from tambour.core.errors import TambourError
from test_files_sink import GREY, holds, value

pytestmark = pytest.mark.slow
PLACES = int(os.environ.get("TAMBOUR_PLACES", "6"))
ENTRIES = sorted(files.WRITE)
BLOCK = 4096


@contextmanager
def full_after(size: int) -> Iterator[None]:
    """A disk that takes no file beyond ``size`` bytes."""
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, hard))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))


def places(most: int, step: int = 1) -> list[int]:
    """Sizes from 0 to below ``most``, its last among them, so many as PLACES says."""
    last = most - 1
    return sorted({0, step, last} | {last * k // max(1, PLACES - 1) // step * step for k in range(PLACES)})


def made(suffix: str, kind: str, folder: Path, monkeypatch: pytest.MonkeyPatch) -> dict[str, bytes]:
    """What the entry writes; the folder then holds old files in the places of all of it."""
    monkeypatch.setattr("tambour.render.raster.picture", lambda *_, **__: GREY)  # what a mesh looks like is slow
    if suffix.startswith(".usd"):
        pytest.importorskip("pxr")
    if suffix == ".mp4":
        pytest.importorskip("av")
    files.write(value(kind), folder / f"a{suffix}", kind)
    whole = holds(folder)
    assert whole and all(whole.values())
    for name in whole:
        (folder / name).write_bytes(b"old")
    return whole


@pytest.mark.parametrize(("suffix", "kind"), ENTRIES)
def test_a_file_cut_anywhere_is_told_and_the_old_ones_stay(
    suffix: str, kind: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    whole = made(suffix, kind, tmp_path, monkeypatch)
    path, old = tmp_path / f"a{suffix}", holds(tmp_path)
    for size in places(max(map(len, whole.values()))):
        with full_after(size), pytest.raises(TambourError) as caught:
            files.write(value(kind), path, kind)
        assert "cannot be written" in str(caught.value) and str(tmp_path) in str(caught.value)
        assert holds(tmp_path) == old
    files.write(value(kind), path, kind)
    assert holds(tmp_path) == whole, "and the same bytes once there is room"


@pytest.fixture(scope="module")
def small(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    """A disk of a megabyte, where one may be mounted."""
    folder = tmp_path_factory.mktemp("small")
    try:
        subprocess.run(["mount", "-t", "tmpfs", "-o", "size=1m", "tmpfs", folder], check=True, capture_output=True)
    except (OSError, subprocess.CalledProcessError):
        pytest.skip("no disk may be mounted here")
    yield folder
    subprocess.run(["umount", folder], check=True)


@pytest.mark.parametrize(("suffix", "kind"), ENTRIES)
def test_a_disk_without_room_is_told_and_the_old_files_stay(
    suffix: str, kind: str, small: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    whole = made(suffix, kind, tmp_path, monkeypatch)
    out, fill = small / f"{suffix[1:]}-{kind}", small / "fill"
    out.mkdir()
    told = 0
    for room in places(sum(map(len, whole.values())), BLOCK):
        for name in whole:
            (out / name).write_bytes(b"old")
        old, disk = holds(out), os.statvfs(small)
        fill.write_bytes(bytes(max(0, disk.f_bavail * disk.f_frsize - room) // BLOCK * BLOCK))
        try:
            files.write(value(kind), out / f"a{suffix}", kind)
        except TambourError as error:
            told += 1
            assert "cannot be written" in str(error) and holds(out) == old
        else:
            assert holds(out) == whole
        fill.unlink()
    for place in out.iterdir():
        place.unlink()
    assert told, "with no room at all nothing can be written"

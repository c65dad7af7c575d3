"""Files appear whole and together, or not at all, whatever happens at which step; full disks and killed commands are in ``disk``."""

from __future__ import annotations

import errno
import os
import shutil
import signal
import stat
import subprocess
import sys
import tempfile
import threading
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tambour import files
from tambour.core.chart import Chart, Disk
from tambour.core.errors import TambourError, Text
from tambour.core.packed import Packed
from tambour.core.palette import Palette
from tambour.core.picture import Picture
from tambour.core.reveal import Reveal
from tambour.files.sink import PREFIX, Kept, Room, Writing, sweep, undisturbed
from test_files import HOUSE
from test_files_machine import design
from test_files_mesh import painted

GREY = Picture(np.tile(np.arange(48, dtype=np.uint8)[:, None, None], (1, 32, 4)) | np.uint8(128))


def value(kind: str) -> Any:
    """A value of the kind, anew each time: streams can be written once."""
    if kind == "Scene":
        from test_files_usd import scene

        return scene(2)
    if kind in ("Chart", "Disk"):
        cells = (np.indices((12, 24)).sum(axis=0) % 3 > 1).astype(np.uint8)
        chart = Chart(cells, Palette(np.array([[0, 0, 0], [255, 255, 255]], np.uint8)))
        return chart if kind == "Chart" else Disk(chart)
    return {
        "Text": Text("R1: MR(6)\n" * 40),
        "dict": {"numbers": list(range(200))},
        "Drawing": HOUSE,
        "Picture": GREY,
        "ThreadPlan": design(),
        "Pictures": iter([GREY, GREY]),
        "Reveal": Reveal(HOUSE, 1.0, 3),
        "Mesh": painted(),
        "Packed": Packed({"points": np.arange(600.0).reshape(-1, 3), "on": np.ones(9, np.bool_)}, {"unit": "stitch"}),
    }[kind]


def holds(folder: Path) -> dict[str, bytes]:
    return {p.name: p.read_bytes() if p.is_file() else b"/" for p in folder.iterdir()}


def test_modes_links_and_pipes_stay_what_they_are(tmp_path: Path) -> None:
    private, target, link, pipe = (tmp_path / n for n in ("private.txt", "target.txt", "link.txt", "pipe.txt"))
    private.write_text("old")
    private.chmod(0o600)
    target.write_text("old")
    link.symlink_to("target.txt")
    (tmp_path / "to-come.txt").symlink_to("came.txt")
    os.mkfifo(pipe)
    read: list[str] = []
    reader = threading.Thread(target=lambda: read.append(pipe.read_text()), daemon=True)  # else a fault hangs
    reader.start()
    for path in (private, link, pipe, tmp_path / "to-come.txt", tmp_path / "new.txt"):
        files.write(Text("new" * 50_000), path)
    reader.join(10)
    assert read == ["new" * 50_000] and stat.S_ISFIFO(pipe.stat().st_mode)
    assert stat.S_IMODE(private.stat().st_mode) == 0o600
    assert link.is_symlink() and target.read_text() == (tmp_path / "came.txt").read_text() == "new" * 50_000
    mask = os.umask(0)
    os.umask(mask)
    assert stat.S_IMODE((tmp_path / "new.txt").stat().st_mode) == 0o666 & ~mask
    assert not list(tmp_path.glob(f"{PREFIX}*"))


def test_a_ring_of_links_is_no_place(tmp_path: Path) -> None:
    (tmp_path / "a.txt").symlink_to("b.txt")
    (tmp_path / "b.txt").symlink_to("a.txt")
    with pytest.raises(TambourError, match=r"a\.txt: cannot be written: "):
        files.write(Text("new"), tmp_path / "a.txt")
    assert (tmp_path / "a.txt").is_symlink() and sorted(p.name for p in tmp_path.iterdir()) == ["a.txt", "b.txt"]


def test_a_device_without_room_puts_everything_back(tmp_path: Path) -> None:
    (tmp_path / "a.txt").write_text("old")
    (tmp_path / "full.txt").symlink_to("/dev/full")
    with Writing() as writing:
        for name in ("a.txt", "b.txt", "full.txt"):
            files.leave(Text("new"), writing.sink(tmp_path / name))
        with pytest.raises(TambourError, match=rf"full\.txt: cannot be written: {os.strerror(errno.ENOSPC)}"):
            writing.commit()
    assert (tmp_path / "a.txt").read_text() == "old" and not (tmp_path / "b.txt").exists()


def test_a_companion_in_anothers_place_leaves_all_as_it_was(tmp_path: Path) -> None:
    (tmp_path / "q.txt").write_text("old")
    (tmp_path / "p-2.svg").mkdir()
    with Writing() as writing, pytest.raises(TambourError, match=r"p-2\.svg: this is a folder"):
        files.leave(Text("new"), writing.sink(tmp_path / "q.txt"))
        files.leave((HOUSE, HOUSE), writing.sink(tmp_path / "p.svg"), "Drawing")
    assert holds(tmp_path) == {"q.txt": b"old", "p-2.svg": b"/"}
    with Writing() as writing, pytest.raises(TambourError, match=r"p-1\.svg: this file would be written twice"):
        files.leave(HOUSE, writing.sink(tmp_path / "p-1.svg"))
        files.leave((HOUSE,), writing.sink(tmp_path / "p.svg"), "Drawing")
    assert holds(tmp_path) == {"q.txt": b"old", "p-2.svg": b"/"}


def test_a_library_that_asks_for_a_number_gets_none(tmp_path: Path) -> None:
    with Writing() as writing, writing.sink(tmp_path / "a.bin").stream() as out, pytest.raises(OSError):
        out.fileno()


KILLS = """
import os, signal, sys
from pathlib import Path
from tambour.cli.process import stoppable
from tambour.core.progress import Stopped
from tambour.files.sink import Writing

class Counted:
    def __init__(self): self.left = -1; self.seen = 0
    def __call__(self, event, args):
        if event.split(".")[0] in ("os", "open", "shutil", "tempfile", "fcntl") and event != "os.kill":
            self.seen += 1
            if self.seen == self.left:
                os.kill(os.getpid(), self.number)

hook = Counted()
sys.addaudithook(hook)
NAMES = ["x/a", "x/b", "y/c", "x/report"]

def write(word):
    with Writing() as writing:
        for name in NAMES:
            writing.sink(name).put(word)
        writing.commit()

def child(number, at):
    hook.number, hook.left, hook.seen = number, at, 0
    try:
        with stoppable():
            write(b"new")
    except (Stopped, KeyboardInterrupt):
        os._exit(3)
    os._exit(0 if hook.seen < at else 4)

def held(): return sorted((str(p), p.read_bytes()) for p in Path(".").rglob("*") if p.is_file())

for name in ("SIGTERM", "SIGHUP", "SIGINT", "SIGKILL"):
    at, most = 0, 0
    while True:
        at += 1
        for place in NAMES:
            Path(place).parent.mkdir(exist_ok=True)
            Path(place).write_bytes(b"old")
        if at % 2:
            Path("x/b").unlink()  # a file that was not there before
        old = held()
        new = [(n, b"new") for n in sorted(NAMES)]
        pid = os.fork()
        if not pid:
            child(getattr(signal, name), at)
        _, status = os.waitpid(pid, 0)
        litter = sorted(map(str, Path(".").rglob(".tambour-*")))
        if name == "SIGKILL":
            for parent in ("x", "y"):  # what the next run in these folders does first
                from tambour.files.sink import sweep
                sweep(Path(parent))
        else:
            assert not litter, (name, at, litter)
        assert not list(Path(".").rglob(".tambour-*")), (name, at)
        now = held()
        mixed = [n for n, word in now if word == b"new"]
        assert all(word in (b"old", b"new") for _, word in now), (name, at, "half")
        whole = now in (old, new)
        if name == "SIGKILL":  # each folder is whole; that both are is more than a dead process can promise
            for folder in ("x/", "y/"):
                part = [p for p in now if p[0].startswith(folder)]
                assert part in ([p for p in old if p[0].startswith(folder)], [p for p in new if p[0].startswith(folder)]), (at, now)
        else:
            assert whole, (name, at, now)
            if os.WEXITSTATUS(status) == 0:
                assert now == new
        if os.WIFEXITED(status) and os.WEXITSTATUS(status) == 0:
            break
    print(name, at - 1)
"""


@pytest.mark.slow
def test_a_kill_at_any_step_leaves_all_or_nothing(tmp_path: Path) -> None:
    made = subprocess.run([sys.executable, "-c", KILLS], cwd=tmp_path, capture_output=True, text=True, timeout=300)
    assert made.returncode == 0, made.stdout + made.stderr
    steps = dict(line.split() for line in made.stdout.splitlines())
    assert set(steps) == {"SIGTERM", "SIGHUP", "SIGINT", "SIGKILL"} and min(map(int, steps.values())) > 40, steps


def test_what_has_changed_since_a_kill_is_left_alone(tmp_path: Path) -> None:
    with Writing() as writing:
        for name in ("a.txt", "b.txt"):
            (tmp_path / name).write_text("old")
            files.leave(Text("new"), writing.sink(tmp_path / name))
        (room,) = (r for r in tmp_path.glob(f"{PREFIX}*"))
        (room / "whole").write_bytes(b"a.txt\0b.txt")
        os.link(tmp_path / "b.txt", room / "old" / "b.txt")
        os.replace(room / "new" / "a.txt", tmp_path / "a.txt")  # and here it was killed
        os.rename(room, tmp_path / f"{PREFIX}dead")
    (tmp_path / "b.txt").unlink()
    (tmp_path / "b.txt").write_text("written by hand")
    files.write(Text("c"), tmp_path / "c.txt")
    assert holds(tmp_path) == {"a.txt": b"new", "b.txt": b"written by hand", "c.txt": b"c"}


def test_two_writers_at_once_do_not_sweep_each_other(tmp_path: Path) -> None:
    with Writing() as one, Writing() as other:
        one.sink(tmp_path / "a.txt").put(b"one")
        other.sink(tmp_path / "b.txt").put(b"other")
        one.sink(tmp_path / "c.txt").put(b"one")
        other.commit()
        one.commit()
    assert holds(tmp_path) == {"a.txt": b"one", "b.txt": b"other", "c.txt": b"one"}


def test_a_stream_that_did_not_take_all_says_so(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    with Writing() as writing:
        stream = writing.sink(tmp_path / "a.bin").stream()
        stream.write(b"abcdef")
        short = os.stat_result((*os.stat(tmp_path)[:6], 3, *os.stat(tmp_path)[7:]))
        with monkeypatch.context() as patched, pytest.raises(OSError, match="Input/output"):
            patched.setattr(os, "fstat", lambda number: short)
            stream.close()
        stream.close()  # a second time is nothing
    assert holds(tmp_path) == {}


def test_where_names_and_locks_are_not_to_be_had(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Disks without second names, systems without locks, and a file that one may not write."""
    place = tmp_path / "a.txt"
    place.write_text("old")
    monkeypatch.setattr(os, "link", no)
    monkeypatch.setitem(sys.modules, "fcntl", None)
    with Writing() as writing:
        writing.sink(place).put(b"new")
        writing.commit()
    assert holds(tmp_path) == {"a.txt": b"new"}
    monkeypatch.setattr(os, "access", lambda *_: False)
    with Writing() as writing, pytest.raises(TambourError, match="cannot be written: Permission denied"):
        writing.sink(place).put(b"newer")
    assert holds(tmp_path) == {"a.txt": b"new"}


def no(*_: object) -> None:
    raise OSError(errno.EPERM, os.strerror(errno.EPERM))


def test_a_place_that_becomes_a_folder_puts_everything_back(tmp_path: Path) -> None:
    (tmp_path / "a.txt").write_text("old")
    with Writing() as writing:
        for name in ("a.txt", "b.txt", "c.txt"):
            writing.sink(tmp_path / name).put(b"new")
        (tmp_path / "c.txt").mkdir()
        with pytest.raises(TambourError, match="Is a directory"):
            writing.commit()
    assert holds(tmp_path) == {"a.txt": b"old", "c.txt": b"/"}


def test_a_move_that_fails_puts_everything_back(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "a.txt").write_text("old")
    replace = os.replace

    def failing(here: Any, there: Any) -> None:
        if Path(there).name == "c.txt":
            raise OSError(errno.EIO, os.strerror(errno.EIO))
        replace(here, there)

    with Writing() as writing:
        for name in ("a.txt", "b.txt", "c.txt"):
            writing.sink(tmp_path / name).put(b"new")
        monkeypatch.setattr(os, "replace", failing)
        with pytest.raises(TambourError, match=r"c\.txt: cannot be written"):
            writing.commit()
    assert holds(tmp_path) == {"a.txt": b"old"}


def test_what_a_dead_process_had_not_begun_to_move_is_left(tmp_path: Path) -> None:
    room = tmp_path / f"{PREFIX}dead"
    (room / "new").mkdir(parents=True)
    (room / "new" / "a.txt").write_text("new")
    (room / "whole").write_bytes(b"a.txt")
    (tmp_path / "a.txt").write_text("old")
    sweep(tmp_path)
    assert holds(tmp_path) == {"a.txt": b"old"}


def test_what_a_dead_process_began_to_move_is_moved_to_its_end(tmp_path: Path) -> None:
    room = tmp_path / f"{PREFIX}dead"
    for folder in ("new", "old"):
        (room / folder).mkdir(parents=True)
    (room / "whole").write_bytes(b"a.txt\0b.txt")
    (room / "new" / "b.txt").write_text("new")
    (tmp_path / "a.txt").write_text("new")
    (tmp_path / "b.txt").write_text("old")
    os.link(tmp_path / "b.txt", room / "old" / "b.txt")
    sweep(tmp_path)
    assert holds(tmp_path) == {"a.txt": b"new", "b.txt": b"new"}


def test_where_a_disk_knows_no_locks_nothing_is_swept(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    import fcntl

    def no_locks(*_: object) -> None:
        raise OSError(errno.ENOLCK, os.strerror(errno.ENOLCK))

    (tmp_path / f"{PREFIX}other").mkdir()
    monkeypatch.setattr(fcntl, "flock", no_locks)
    with Writing() as writing:
        writing.sink(tmp_path / "a.txt").put(b"new")
        assert writing.paths == [tmp_path / "a.txt"]
        writing.commit()
    assert holds(tmp_path) == {"a.txt": b"new", f"{PREFIX}other": b"/"}


def test_a_room_swept_before_it_was_locked_is_made_anew(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    make = tempfile.mkdtemp
    first = True

    def swept(**where: Any) -> str:
        nonlocal first
        made = make(**where)
        if first:
            os.rmdir(made)
        first = False
        return made

    monkeypatch.setattr(tempfile, "mkdtemp", swept)
    room = Room.beside(tmp_path)
    assert room.folder.is_dir() and not first
    # Another that took its place in the same moment is not ours either.
    with monkeypatch.context() as patched:
        patched.setattr(os.path, "samestat", lambda *_: False)
        other = Room.beside(tmp_path)
    assert other.lock is None
    other.clear()
    room.clear()
    assert holds(tmp_path) == {}


def test_a_room_that_another_command_is_sweeping_is_not_taken(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Two commands begin in one folder: one sees the other's room before it is locked, locks it, and clears it away a moment later."""
    import fcntl

    make, taken = tempfile.mkdtemp, []

    def seen(**where: Any) -> str:
        made = make(**where)
        if not taken:
            taken.append((made, os.open(made, os.O_RDONLY)))
            fcntl.flock(taken[0][1], fcntl.LOCK_EX)
        return made

    monkeypatch.setattr(tempfile, "mkdtemp", seen)
    with Writing() as writing:
        writing.sink(tmp_path / "a.txt").put(b"new")
        folder, lock = taken[0]
        shutil.rmtree(folder)
        os.close(lock)
        writing.commit()
    assert holds(tmp_path) == {"a.txt": b"new"}


def test_signals_wait_until_all_is_moved() -> None:
    heard: list[int] = []
    before = signal.signal(signal.SIGTERM, lambda number, frame: heard.append(number))
    try:
        with undisturbed():
            signal.raise_signal(signal.SIGTERM)
            assert heard == []
        assert heard == [signal.SIGTERM]
    finally:
        signal.signal(signal.SIGTERM, before)


def test_other_threads_hear_no_signals() -> None:
    done: list[bool] = []

    def there() -> None:
        with undisturbed():
            done.append(True)

    other = threading.Thread(target=there)
    other.start()
    other.join()
    assert done


def test_a_writer_may_go_back_in_its_file(tmp_path: Path) -> None:
    with Writing() as writing:
        with writing.sink(tmp_path / "a.bin").stream() as out:
            out.write(b"....end")
            out.seek(0)
            out.write(b"head")
        writing.commit()
    assert holds(tmp_path) == {"a.bin": b"headend"}


def test_what_goes_to_no_disk_is_held_by_its_place() -> None:
    with Kept() as kept:
        kept.sink("a.txt").put(b"a")
        with kept.sink("b/c.txt").stream() as out:
            out.write(b"c")
            out.close()
        with pytest.raises(TambourError, match="written twice"):
            kept.sink("a.txt").put(b"again")
        with kept.sink("d.txt").folder() as room, kept.sink("e.txt").folder() as other:
            assert room.parent == other.parent and room.is_dir()
        kept.commit()
        assert kept.files == {"a.txt": b"a", "b/c.txt": b"c"} and kept.paths == [Path("a.txt"), Path("b/c.txt")]
    assert not room.exists()

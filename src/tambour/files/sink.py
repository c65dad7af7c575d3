"""Sink: the one way bytes leave a writer, checked byte for byte; and Writing: many files, all of them or none.

No writer opens a path, and no path goes to a library's own writer: those pass over what a full disk does to them.
"""

from __future__ import annotations

import errno
import io
import os
import shutil
import signal
import stat
import tempfile
import threading
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path
from types import TracebackType
from typing import IO, Any

from tambour.core.errors import TambourError

PREFIX = ".tambour-"
"""How the names of the hidden folders begin in which files are made beside their places."""
SIGNALS = tuple(getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP") if hasattr(signal, name))


class Stream(io.BufferedWriter):
    """A new file that is written as its bytes come. Closing it raises OSError unless all of them are on the disk."""

    def __init__(self, path: Path) -> None:
        self._file = io.FileIO(path, "wb")
        super().__init__(self._file, 1 << 20)
        self._at = self._end = 0

    def fileno(self) -> int:
        """None: libraries that find a file's number write past this stream."""
        raise io.UnsupportedOperation("a sink's stream has no number")

    def write(self, data: Any, /) -> int:
        """As of any stream; every byte is taken."""
        made = super().write(data)
        self._at += made
        self._end = max(self._end, self._at)
        return made

    def seek(self, offset: int, whence: int = 0, /) -> int:
        """As of any stream."""
        self._at = super().seek(offset, whence)
        return self._at

    def close(self) -> None:
        """Put everything on the disk and see that it is there."""
        if self.closed:
            return
        number = self._file.fileno()
        try:
            self.flush()
            os.fsync(number)
            if os.fstat(number).st_size != self._end:
                raise OSError(errno.EIO, os.strerror(errno.EIO))
        finally:
            self._file.close()


@dataclass(frozen=True, slots=True)
class Sink:
    """Where a writer leaves one file of ``writing``. ``path`` is its place in the end: for its name and for messages."""

    path: Path
    writing: Writing

    @property
    def suffix(self) -> str:
        """The suffix, in small letters: ``.svg``."""
        return self.path.suffix.lower()

    def put(self, data: bytes) -> None:
        """The whole file."""
        with self.stream() as out:
            out.write(data)

    def stream(self) -> IO[bytes]:
        """The file as it comes; close it (``with``)."""
        return self.writing.stream(self.path)

    @contextmanager
    def folder(self) -> Iterator[Path]:
        """A private folder for a library that can write to nothing but a path; ``put`` what it made there."""
        with refused(self.path), tempfile.TemporaryDirectory(dir=self.writing.room(self.path.parent).folder) as name:
            yield Path(name)

    def beside(self, stem: str) -> Sink:
        """A companion: the same place and suffix, another stem."""
        return Sink(self.path.with_name(stem + self.path.suffix), self.writing)


@dataclass(slots=True)
class Room:
    """A hidden folder beside some places: ``new/NAME`` is made there, ``old/NAME`` is what stood at the place.

    ``whole`` in it names (between zero bytes) the files that stood in ``new`` when the last of all was finished. The
    folder is locked as long as its process lives.
    """

    folder: Path
    lock: int | None

    @staticmethod
    def beside(parent: Path) -> Room:
        """A new folder beside places in ``parent``, where what the dead have left is cleared away."""
        sweep(parent)
        while True:
            folder = Path(tempfile.mkdtemp(prefix=PREFIX, dir=parent))
            with suppress(BlockingIOError):  # somebody sweeps it this moment, before it could be locked
                lock = _locked(folder)
                if lock is not None or folder.is_dir():
                    break  # else somebody swept it
        for name in ("new", "old"):
            (folder / name).mkdir()
        return Room(folder, lock)

    def clear(self) -> None:
        """Remove it with all that is in it."""
        shutil.rmtree(self.folder, ignore_errors=True)
        if self.lock is not None:
            os.close(self.lock)


def _locked(folder: Path) -> int | None:
    """The open, locked folder; None where it is gone, or locks are not to be had. BlockingIOError: another process holds it."""
    try:
        import fcntl

        number = os.open(folder, os.O_RDONLY | os.O_DIRECTORY)
    except (ImportError, OSError):
        return None
    try:
        fcntl.flock(number, fcntl.LOCK_EX | fcntl.LOCK_NB)
        if os.path.samestat(os.fstat(number), os.stat(folder)):
            return number
    except OSError as error:
        os.close(number)
        if isinstance(error, BlockingIOError):
            raise
        return None
    os.close(number)
    return None


def sweep(parent: Path) -> None:
    """Remove what processes that were killed have left in a folder.

    Where one was killed amid the moving of its files, the rest of them follow first, if nothing has changed since.
    """
    for folder in parent.glob(f"{PREFIX}*"):
        try:
            lock = _locked(folder)
        except BlockingIOError:
            continue  # its process lives
        if lock is None:
            continue
        with suppress(OSError):
            _follow(folder, parent)
        shutil.rmtree(folder, ignore_errors=True)
        os.close(lock)


def _follow(folder: Path, parent: Path) -> None:
    names = [os.fsdecode(n) for n in (folder / "whole").read_bytes().split(b"\0")]
    left = [n for n in names if (folder / "new" / n).exists()]
    if len(left) == len(names):
        return  # none was moved: the old ones stand
    for name in left:
        old, place = folder / "old" / name, parent / name
        if old.exists() != place.exists() or (old.exists() and not os.path.samefile(old, place)):
            return
    for name in left:
        os.replace(folder / "new" / name, parent / name)


@contextmanager
def undisturbed() -> Iterator[None]:
    """Signals that would end the process wait until the end of this."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    came: list[int] = []
    before = {s: h for s in SIGNALS if (h := signal.getsignal(s)) is not signal.SIG_IGN}
    for s in before:
        signal.signal(s, lambda number, frame: came.append(number))
    try:
        yield
    finally:
        for s, handler in before.items():
            signal.signal(s, signal.SIG_DFL if handler is None else handler)
        for number in came:
            signal.raise_signal(number)


@dataclass(slots=True)
class _File:
    asked: Path
    place: Path  # symbolic links followed
    made: Path
    room: Room | None  # None: the place is a pipe or a device, which is written into
    moved: bool = False

    @property
    def old(self) -> Path:
        assert self.room is not None
        return self.room.folder / "old" / self.place.name


class Writing:
    """Files that appear together, or not at all.

    Used as ``with Writing() as w: … w.sink(path) …; w.commit()``. Each file is made in a hidden folder beside its place;
    ``commit`` moves all of them there, and puts everything back as it was when that fails or is interrupted. Modes are
    kept, symbolic links and pipes written through.
    """

    def __init__(self) -> None:
        self._rooms: dict[Path, Room] = {}
        self._files: dict[Path, _File] = {}

    def __enter__(self) -> Writing:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, at: TracebackType | None) -> None:
        self.clear()

    @property
    def paths(self) -> list[Path]:
        """The places asked for so far, in order."""
        return [f.asked for f in self._files.values()]

    def sink(self, path: str | Path) -> Sink:
        """Where a writer leaves the file that shall stand at ``path``."""
        return Sink(Path(path), self)

    def stream(self, path: Path) -> IO[bytes]:
        """The new file for ``path``; TambourError where none can stand."""
        try:
            place = Path(os.path.realpath(path) if path.is_symlink() else path)
            key = place.parent.resolve() / place.name
            if place.is_symlink():  # a ring of links
                raise OSError(errno.ELOOP, os.strerror(errno.ELOOP))
            if key in self._files:
                raise TambourError("this file would be written twice", hint="name it differently", where=str(path))
            mode = os.stat(place).st_mode if place.exists() else stat.S_IFREG
            if stat.S_ISDIR(mode):
                raise TambourError("this is a folder, name a file in it", where=str(path))
            if place.exists() and not os.access(place, os.W_OK):
                raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))
            whole = stat.S_ISREG(mode)
            parent = key.parent if whole else Path(tempfile.gettempdir())
            room = self.room(parent)
            name = place.name if whole else f"{len(self._files)}"
            made = room.folder / "new" / name if whole else room.folder / name
            stream = Stream(made)
            if whole and place.exists():
                shutil.copymode(place, made)
            self._files[key] = _File(path, place, made, room if whole else None)
            return stream
        except OSError as error:
            raise cannot(path, error) from None

    def room(self, parent: Path) -> Room:
        """The hidden folder in ``parent``."""
        parent = parent.resolve()
        if parent not in self._rooms:
            with undisturbed():
                self._rooms[parent] = Room.beside(parent)
        return self._rooms[parent]

    def commit(self) -> None:
        """Move every file to its place; on any failure none. Raises TambourError with the place that failed."""
        try:
            with undisturbed():
                whole = [f for f in self._files.values() if f.room is not None]
                for f in whole:
                    with refused(f.asked):
                        _keep(f)
                for room in self._rooms.values():
                    names = [os.fsencode(f.place.name) for f in whole if f.room is room]
                    with refused(room.folder.parent), Stream(room.folder / "whole") as mark:
                        mark.write(b"\0".join(names))
                for f in whole:
                    with refused(f.asked):
                        f.moved = True
                        os.replace(f.made, f.place)
                for parent in self._rooms:
                    settle(parent)
            for f in self._files.values():
                if f.room is None:
                    with refused(f.asked):
                        _pour(f)
        except BaseException:
            with undisturbed():
                for f in self._files.values():
                    if f.moved:
                        _back(f)
            raise

    def clear(self) -> None:
        """Remove what is left of the making."""
        with undisturbed():
            for room in self._rooms.values():
                room.clear()
            self._rooms.clear()


def _keep(f: _File) -> None:
    """A second name for what stands at the place, or a copy where a disk knows no second names."""
    if not f.place.exists():
        return
    try:
        os.link(f.place, f.old)
    except OSError:
        shutil.copy2(f.place, f.old)


def _back(f: _File) -> None:
    with suppress(OSError):
        if f.old.exists():
            os.replace(f.old, f.place)
        elif not f.made.exists():
            f.place.unlink()


def settle(parent: Path) -> None:
    """Put a folder's new names on the disk, where folders can be told to."""
    with suppress(OSError):
        number = os.open(parent, os.O_RDONLY)
        try:
            os.fsync(number)
        finally:
            os.close(number)


def _pour(f: _File) -> None:
    """Write into a pipe or a device."""
    number = os.open(f.place, os.O_WRONLY)
    try:
        with f.made.open("rb") as made:
            while part := made.read(1 << 16):
                while part:
                    part = part[os.write(number, part) :]
    finally:
        os.close(number)


class _Page(io.BytesIO):
    """A file of ``Kept``; closing it leaves its bytes there."""

    def __init__(self, kept: dict[str, bytes], name: str) -> None:
        super().__init__()
        self._kept, self._name = kept, name

    def close(self) -> None:
        if not self.closed:
            self._kept[self._name] = self.getvalue()
        super().close()


class Kept(Writing):
    """Files that go to no disk: ``files`` holds the bytes of each by its place, in the order that they were begun."""

    def __init__(self) -> None:
        super().__init__()
        self.files: dict[str, bytes] = {}

    @property
    def paths(self) -> list[Path]:
        """The places asked for so far, in order."""
        return [Path(name) for name in self.files]

    def stream(self, path: Path) -> IO[bytes]:
        """The new file for ``path``; TambourError where it is there."""
        if str(path) in self.files:
            raise TambourError("this file would be written twice", hint="name it differently", where=str(path))
        self.files[str(path)] = b""
        return _Page(self.files, str(path))

    def room(self, parent: Path) -> Room:
        """A folder for libraries that can write to nothing but a path."""
        if not self._rooms:
            self._rooms[Path()] = Room(Path(tempfile.mkdtemp(prefix=PREFIX)), None)
        return self._rooms[Path()]

    def commit(self) -> None:
        """Nothing: the bytes are there."""


@contextmanager
def refused(path: Path) -> Iterator[None]:
    """What the disk refuses inside becomes a TambourError about ``path``."""
    try:
        yield
    except OSError as error:
        raise cannot(path, error) from None


def cannot(path: Path, error: OSError) -> TambourError:
    """The words for a file that the disk refuses."""
    return TambourError(f"cannot be written: {error.strerror or error}", where=str(path))

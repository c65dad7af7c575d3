"""Folder: where a sweep leaves its pieces: files, a report each, and an index that is always made from the reports.

A report is moved to its place after all the files it names, so what has a report is whole. Several sweeps may write
into one folder: a lock is held while things are moved, and while the index is made.
"""

from __future__ import annotations

import csv
import io
import itertools
import json
import os
import re
import threading
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from tambour.core.errors import TambourError
from tambour.files.sink import Room, Stream, refused, settle, undisturbed
from tambour.sweep.plan import Piece
from tambour.work.piece import Done

COLUMNS = ("key", "craft", "source", "params", "status", "reason", "seconds", "score", "files")
FORMULA = ("=", "+", "-", "@", "\t", "\r")
REPORTS, THUMBS, INDEX, LOCK = "reports", "thumbs", "index.csv", ".tambour-lock"


@dataclass(frozen=True, slots=True)
class Row:
    """What the index says of a piece, and its ``name``; ``score`` is its mean distance from the shape that was aimed at, in
    stitches of crochet, None where there is none; ``sizes`` are the bytes of its ``files``, ``kinds`` what was asked for."""

    name: str
    key: str
    craft: str
    source: str
    params: str
    status: str
    reason: str
    seconds: float
    score: float | None
    files: tuple[str, ...]
    sizes: tuple[int, ...]
    kinds: tuple[str, ...]

    @classmethod
    def of(cls, name: str, told: Mapping[str, Any]) -> Row:
        """The row of a report."""
        spent = told.get("seconds") or {}
        return cls(
            name,
            str(told["key"]),
            str(told["craft"]),
            str((told.get("source") or {}).get("path", "")),
            json.dumps(told["set"], ensure_ascii=False),
            str(told["status"]),
            str(told.get("reason", "")),
            round(sum(spent.values()), 6),
            None if "distance" not in told else float(told["distance"]["mean"]),
            tuple(map(str, told.get("files", ()))),
            tuple(map(int, told.get("sizes", ()))),
            tuple(map(str, told.get("kinds", ()))),
        )

    def told(self) -> list[Any]:
        """The columns of the index; a table must not take a text for a formula."""
        texts = [self.key, self.craft, self.source, self.params, self.status, self.reason, ";".join(self.files)]
        safe = [f"'{text}" if text[:1] in FORMULA else text for text in texts]
        return [*safe[:-1], self.seconds, "" if self.score is None else self.score, safe[-1]]


class Folder:
    """The folder of a sweep. Used as ``with Folder(path) as folder``; what the disk refuses is a TambourError."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self._seen: dict[str, tuple[tuple[int, int, int], Row]] = {}
        self._number = itertools.count()
        self._alone = threading.Lock()
        with refused(path):
            if path.exists() and not path.is_dir():
                raise TambourError("this is a file: name a folder", where=str(path))
            for place in (path, path / REPORTS, path / THUMBS):
                place.mkdir(parents=True, exist_ok=True)
        with refused(path), undisturbed():
            self._room = Room.beside(path)

    def __enter__(self) -> Folder:
        return self

    def __exit__(self, *error: object) -> None:
        with undisturbed():
            self._room.clear()

    def row(self, name: str) -> Row | None:
        """What the report called ``name`` says; None where there is none that can be read."""
        place = self.path / REPORTS / f"{name}.json"
        try:
            now = place.stat()
        except OSError:
            self._seen.pop(name, None)
            return None
        stamp = (now.st_mtime_ns, now.st_size, now.st_ino)
        if name not in self._seen or self._seen[name][0] != stamp:
            try:
                self._seen[name] = (stamp, Row.of(name, json.loads(place.read_bytes())))
            except (OSError, ValueError, KeyError, TypeError, AttributeError, RecursionError):
                self._seen.pop(name, None)
                return None
        return self._seen[name][1]

    def rows(self) -> list[Row]:
        """All that reports say, by name: numbers in names in the order of numbers."""
        with os.scandir(self.path / REPORTS) as found:
            names = [e.name[:-5] for e in found if e.name.endswith(".json")]
        for gone in self._seen.keys() - set(names):
            del self._seen[gone]
        return [row for name in sorted(names, key=_natural) if (row := self.row(name)) is not None]

    def finished(self, row: Row | None, wanted: Sequence[str]) -> bool:
        """Whether a piece was made, with all the kinds of files that are wanted, and they are still there whole."""
        if row is None or row.status != "made" or not set(wanted) <= set(row.kinds):
            return False
        try:
            return all((self.path / f).stat().st_size == size for f, size in zip(row.files, row.sizes, strict=True))
        except (OSError, ValueError):
            return False

    def put(self, piece: Piece, done: Done) -> Row:
        """Leave a piece, or the report of why there is none."""
        from tambour.files.text import dumps

        told = report(piece, done)
        new: dict[Path, bytes] = {self.path / name: raw for name, raw in done.files.items()}
        if done.thumb:
            new[self.path / THUMBS / f"{piece.name}.webp"] = done.thumb
        place = self.path / REPORTS / f"{piece.name}.json"
        new[place] = dumps(told).encode()
        made: list[tuple[Path, Path]] = []
        try:
            for at, raw in new.items():
                with refused(at):
                    aside = self._room.folder / "new" / str(next(self._number))
                    made.append((aside, at))
                    with Stream(aside) as out:
                        out.write(raw)
            with refused(place), undisturbed(), self._locked():
                with suppress(FileNotFoundError):
                    place.unlink()  # it tells of files that go now
                for aside, at in made:
                    os.replace(aside, at)
                now = place.stat()
                row = Row.of(piece.name, told)
                self._seen[piece.name] = ((now.st_mtime_ns, now.st_size, now.st_ino), row)
        except BaseException:
            for aside, _ in made:
                aside.unlink(missing_ok=True)
            raise
        return row

    def index(self) -> list[Row]:
        """Make ``index.csv`` from the reports; gives its rows."""
        place = self.path / INDEX
        with refused(place), undisturbed(), self._locked():
            rows = self.rows()
            text = io.StringIO()
            table = csv.writer(text, lineterminator="\n")
            table.writerow(COLUMNS)
            table.writerows(row.told() for row in rows)
            self.leave(place, text.getvalue().encode())
            settle(self.path)
        return rows

    def leave(self, place: Path, raw: bytes) -> None:
        """A file of the folder's own, whole or not at all."""
        with refused(place):
            aside = self._room.folder / "new" / place.name
            try:
                with Stream(aside) as out:
                    out.write(raw)
                os.replace(aside, place)
            finally:
                aside.unlink(missing_ok=True)

    @contextmanager
    def _locked(self) -> Iterator[None]:
        """Nobody else moves anything in the folder meanwhile: no other thread, and no process where systems know locks."""
        with self._alone:
            try:
                import fcntl
            except ImportError:
                yield
                return
            number = os.open(self.path / LOCK, os.O_RDWR | os.O_CREAT, 0o666)
            try:
                fcntl.flock(number, fcntl.LOCK_EX)
                yield
            finally:
                os.close(number)


def report(piece: Piece, done: Done) -> dict[str, Any]:
    """The report of a piece: what was measured, its key, what was set, how it ended; sizes are bytes of the files, kinds those asked for."""
    from tambour import __version__

    head = {"key": piece.key, "status": "failed" if done.reason else "made", "set": dict(piece.chosen)}
    if not done.reason:
        kinds = [name.removeprefix(piece.name) for name in piece.job.out]
        return {**head, **done.report, "sizes": [len(raw) for raw in done.files.values()], "kinds": kinds}
    job = piece.job
    source = None if job.source is None else {"path": job.source}
    made_of = {"version": __version__, "params": dict(job.params), "source": source, "edits": list(job.edits)}
    told = {**head, "reason": done.reason, "craft": job.craft, **made_of}
    return {**told, "fault": done.fault} if done.fault else told


def _natural(name: str) -> list[tuple[int, float, str]]:
    """A name's words and numbers, so that 10 comes after 9, and -1 before 0."""
    parts = re.split(r"((?:(?<==)-)?\d+(?:\.\d+)?)", name)
    return [(0, float(p), "") if k % 2 else (1, 0.0, p) for k, p in enumerate(parts)]

"""Library: pieces, their revisions and files, in one SQLite file. The only module that speaks SQL.

One thread owns the connection; every change is one transaction, on the disk before it is acknowledged.
"""

from __future__ import annotations

import asyncio
import json
import secrets
import sqlite3
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass
from hashlib import sha256
from pathlib import Path
from typing import Any, TypeVar

from tambour.core.errors import TambourError
from tambour.studio import limits

VERSION = 1
"""Of the tables; a library of a younger tambour is refused, an older one is brought here by ``migrations/N.sql``."""
_LETTERS = "abcdefghijklmnopqrstuvwxyz234567"
_HERE = Path(__file__).parent
T = TypeVar("T")


class Missing(Exception):
    """There is no such piece or revision."""


class Conflict(Exception):
    """The head is another one than the caller thinks, or there is nothing to go to."""


class Full(Exception):
    """The disk takes no more; what was there is there."""


@dataclass(frozen=True, slots=True)
class Content:
    """What a piece is made of.

    name, source : of its source: a file's name and the digest of its bytes, or None
    params : what was set, plain; files : field → {"name", "sha256"}; edits : as data
    """

    name: str | None
    source: str | None
    params: Mapping[str, Any]
    files: Mapping[str, Mapping[str, str]]
    edits: tuple[Mapping[str, Any], ...]
    edition: int
    version: str


@dataclass(frozen=True, slots=True)
class Revision:
    """A state of a piece. ``next`` : the revision that redo leads to."""

    id: int
    piece: str
    parent: int | None
    next: int | None
    at: int
    said: str
    content: Content


@dataclass(frozen=True, slots=True)
class Piece:
    """A piece; times in milliseconds since 1970. ``thumb`` : the revision that its picture is of."""

    id: str
    craft: str
    title: str
    made: int
    changed: int
    head: int
    thumb: int | None
    binned: int | None


@dataclass(frozen=True, slots=True)
class Place:
    """How far the making of a piece has come: a step and a unit of ``live``; ``at`` when it was said."""

    step: int
    unit: int
    at: int


_PLAIN = {ord(c): f"\\{c}" for c in "\\%_"}
"""What SQL would read in a word, as itself."""


def now() -> int:
    """Milliseconds since 1970."""
    return int(time.time() * 1000)


def is_id(text: str) -> bool:
    """Whether a text could be a piece's id."""
    return len(text) == 26 and all(c in _LETTERS for c in text)


class Library:
    """The file at ``path``, opened; made when it is not there. TambourError when it cannot be used."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self._thread = ThreadPoolExecutor(1, "library")
        try:
            self.call(self._open)
        except BaseException:
            self._thread.shutdown()
            raise

    async def do(self, work: Callable[..., T], *given: Any) -> T:
        """One of the methods below, in the library's thread."""
        return await asyncio.get_running_loop().run_in_executor(self._thread, work, *given)

    def call(self, work: Callable[..., T], *given: Any) -> T:
        """The same, waited for."""
        return self._thread.submit(work, *given).result()

    def close(self) -> None:
        """Let the file go."""
        self.call(lambda: self._db.close())
        self._thread.shutdown()

    def _open(self) -> None:
        where = str(self.path)
        try:
            self.path.parent.mkdir(parents=True, exist_ok=True)
            self._db = sqlite3.connect(self.path, isolation_level=None, timeout=20.0)
            self._db.execute("PRAGMA journal_mode=WAL")
            self._db.execute("PRAGMA synchronous=FULL")
            self._db.execute("PRAGMA foreign_keys=ON")
            found = int(self._db.execute("PRAGMA user_version").fetchone()[0])
            if found > VERSION:
                raise TambourError(
                    f"this library is of a younger tambour (its tables are of version {found}, known are {VERSION})",
                    hint="use that tambour, or name another file: --library PATH",
                    where=where,
                )
            with self._change():
                # Two that start at once: the second finds the tables.
                found = int(self._db.execute("PRAGMA user_version").fetchone()[0])
                for number in range(found, VERSION):
                    name = "schema.sql" if number == 0 else f"migrations/{number}.sql"
                    for statement in _statements((_HERE / name).read_text("utf-8")):
                        self._db.execute(statement)
                    self._db.execute(f"PRAGMA user_version={VERSION if number == 0 else number + 1}")
                    if number == 0:
                        break
            self._sweep()
        except sqlite3.DatabaseError as error:
            raise TambourError(
                f"this library cannot be opened: {error}", hint="name another file: --library PATH", where=where
            ) from None
        except OSError as error:
            raise TambourError(f"cannot be opened: {error.strerror}", where=where) from None

    @contextmanager
    def _change(self) -> Iterator[None]:
        """One transaction: all of it, or nothing."""
        try:
            self._db.execute("BEGIN IMMEDIATE")
            try:
                yield
            except BaseException:
                if self._db.in_transaction:  # a full disk ends it by itself
                    self._db.execute("ROLLBACK")
                raise
            self._db.execute("COMMIT")
        except sqlite3.OperationalError as error:
            if self._db.in_transaction:
                self._db.execute("ROLLBACK")
            if getattr(error, "sqlite_errorcode", 0) & 0xFF in (sqlite3.SQLITE_FULL, sqlite3.SQLITE_IOERR):
                raise Full(str(error)) from None
            raise

    # -- blobs ------------------------------------------------------------------------------------------------------

    def keep(self, raw: bytes) -> str:
        """Keep bytes; gives their digest."""
        with self._change():
            return self._keep(raw)

    def _keep(self, raw: bytes) -> str:
        name = sha256(raw).hexdigest()
        self._db.execute("INSERT OR IGNORE INTO blob VALUES (?, ?, ?)", (name, raw, len(raw)))
        return name

    def blob(self, name: str) -> bytes:
        """The bytes of a digest. Raises Missing."""
        row = self._db.execute("SELECT bytes FROM blob WHERE sha256 = ?", (name,)).fetchone()
        if row is None:
            raise Missing
        return bytes(row[0])

    def size(self, name: str) -> int:
        """How many bytes a digest stands for. Raises Missing."""
        row = self._db.execute("SELECT size FROM blob WHERE sha256 = ?", (name,)).fetchone()
        if row is None:
            raise Missing
        return int(row[0])

    # -- pieces -----------------------------------------------------------------------------------------------------

    def add(
        self, craft: str, title: str, content: Content, raw: bytes | None = None, own: bool = False
    ) -> tuple[Piece, Revision]:
        """A new piece with its first revision; ``raw``: the bytes of its source, where they are not kept yet; ``own``: where its
        craft has one of its title already it is numbered, "Bear 2"."""
        with self._change():
            title = self._own(craft, title) if own else title
            at, name = now(), "".join(secrets.choice(_LETTERS) for _ in range(26))
            self._db.execute(
                "INSERT INTO piece (id, craft, title, made, changed) VALUES (?, ?, ?, ?, ?)",
                (name, craft, title, at, at),
            )
            revision = self._insert(name, None, content, raw, "", at)
            return self.piece(name), self.revision(revision)

    def _own(self, craft: str, title: str) -> str:
        """The title, or with the first number that is free."""
        taken = "SELECT 1 FROM piece WHERE craft = ? AND title = ? AND binned IS NULL"
        number, own = 1, title
        while self._db.execute(taken, (craft, own)).fetchone():
            number += 1
            own = f"{title} {number}"
        return own

    def piece(self, name: str) -> Piece:
        """The piece of an id. Raises Missing."""
        row = self._db.execute(
            "SELECT id, craft, title, made, changed, head, thumb, binned FROM piece WHERE id = ?", (name,)
        ).fetchone()
        if row is None:
            raise Missing
        return Piece(*row)

    def pieces(self, after: tuple[int, str] | None, most: int, binned: bool, words: Sequence[str] = ()) -> list[Piece]:
        """Pieces, the last changed first, from behind ``after`` (changed, id) on; ``words``: all are in their titles."""
        wanted = [f"%{w.translate(_PLAIN)}%" for w in words]
        rows = self._db.execute(
            "SELECT id, craft, title, made, changed, head, thumb, binned FROM piece"
            " WHERE (binned IS NOT NULL) = ? AND (? IS NULL OR changed < ? OR (changed = ? AND id > ?))"
            + " AND title LIKE ? ESCAPE '\\'" * len(wanted)
            + " ORDER BY changed DESC, id LIMIT ?",
            (binned, *(after[:1] * 3 if after else (None,) * 3), after[1] if after else None, *wanted, most),
        )
        return [Piece(*row) for row in rows]

    def alter(self, name: str, title: str | None, binned: bool | None) -> Piece:
        """Another title; into the bin, or out of it. Raises Missing."""
        with self._change():
            self.piece(name)
            if title is not None:
                self._db.execute("UPDATE piece SET title = ? WHERE id = ?", (title, name))
            if binned is not None:
                self._db.execute("UPDATE piece SET binned = ? WHERE id = ?", (now() if binned else None, name))
            return self.piece(name)

    # -- revisions --------------------------------------------------------------------------------------------------

    def revision(self, number: int) -> Revision:
        """The revision of a number. Raises Missing."""
        row = self._db.execute(
            "SELECT id, piece, parent, next, at, said, name, source, params, files, edits, edition, version"
            " FROM revision WHERE id = ?",
            (number,),
        ).fetchone()
        if row is None:
            raise Missing
        name, source, params, files, edits, edition, version = row[6:]
        told = Content(name, source, json.loads(params), json.loads(files), tuple(json.loads(edits)), edition, version)
        number, piece, parent, following, at, said = row[:6]
        return Revision(number, piece, parent, following, at, said, told)

    def history(self, piece: str, most: int = 500) -> list[Revision]:
        """The revisions of a piece, the youngest first. Raises Missing."""
        self.piece(piece)
        rows = self._db.execute("SELECT id FROM revision WHERE piece = ? ORDER BY id DESC LIMIT ?", (piece, most))
        return [self.revision(row[0]) for row in rows.fetchall()]

    def revise(
        self, piece: str, base: int, content: Content, raw: bytes | None, said: str, merge: bool, still: bool = False
    ) -> tuple[Piece, Revision]:
        """A revision upon ``base``, which must be the head (else Conflict). ``merge``: in the place of a head that is
        no older than what counts as one go of typing; ``still``: in its place in any case, so that there is as much
        to undo and to redo as before."""
        with self._change():
            head = self.piece(piece).head
            if head != base:
                raise Conflict("this was changed elsewhere in the meantime")
            old, at = self.revision(base), now()
            alone = self._db.execute("SELECT count(*) FROM revision WHERE parent = ?", (base,)).fetchone()[0] == 0
            replaced = merge and alone and old.parent is not None and at - old.at < limits.MERGED
            made = self._insert(
                piece, old.parent if replaced or still else base, content, raw, old.said if still else said, at
            )
            if still:
                self._db.execute("UPDATE revision SET next = ? WHERE id = ?", (old.next, made))
                self._db.execute("UPDATE revision SET parent = ? WHERE parent = ?", (made, base))
            if replaced or still:
                self._db.execute("DELETE FROM revision WHERE id = ?", (base,))
            return self.piece(piece), self.revision(made)

    def _insert(self, piece: str, parent: int | None, content: Content, raw: bytes | None, said: str, at: int) -> int:
        source = content.source if raw is None else self._keep(raw)
        for name in [source, *(it["sha256"] for it in content.files.values())]:
            if name is not None:
                self.size(name)
        made = self._db.execute(
            "INSERT INTO revision (piece, parent, name, source, params, files, edits, edition, version, at, said)"
            " VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
            (
                piece,
                parent,
                content.name,
                source,
                _json(content.params),
                _json(content.files),
                _json(content.edits),
                content.edition,
                content.version,
                at,
                said,
            ),
        ).lastrowid
        assert made is not None
        if parent is not None:
            self._db.execute("UPDATE revision SET next = ? WHERE id = ?", (made, parent))
        self._db.execute("UPDATE piece SET head = ?, changed = ? WHERE id = ?", (made, at, piece))
        return made

    def go(self, piece: str, to: str | int) -> tuple[Piece, Revision]:
        """Move the head: "undo", "redo", or to a revision. Raises Missing, Conflict where there is nothing."""
        with self._change():
            head = self.revision(self.piece(piece).head)
            if isinstance(to, int):
                target = self.revision(to)
                if target.piece != piece:
                    raise Missing
                self._db.execute(
                    "WITH RECURSIVE up(id, parent) AS (SELECT id, parent FROM revision WHERE id = ?"
                    " UNION ALL SELECT r.id, r.parent FROM revision r JOIN up ON r.id = up.parent)"
                    " UPDATE revision SET next = (SELECT id FROM up WHERE parent = revision.id)"
                    " WHERE id IN (SELECT parent FROM up)",
                    (to,),
                )
                at: int | None = to
            else:
                at = head.parent if to == "undo" else head.next
            if at is None:
                raise Conflict(f"there is nothing to {to}")
            self._db.execute("UPDATE piece SET head = ?, changed = ? WHERE id = ?", (at, now(), piece))
            return self.piece(piece), self.revision(at)

    # -- pictures and places ----------------------------------------------------------------------------------------

    def show(self, revision: int, raw: bytes) -> None:
        """Keep a small picture of a revision as its piece's."""
        with self._change():
            name = self._keep(raw)
            self._db.execute(
                "UPDATE piece SET thumb = ?1, picture = ?2 WHERE id = (SELECT piece FROM revision WHERE id = ?1)",
                (revision, name),
            )

    def picture(self, revision: int) -> bytes | None:
        """The small picture of a revision, where its piece has it."""
        row = self._db.execute("SELECT picture FROM piece WHERE thumb = ?", (revision,)).fetchone()
        return None if row is None or row[0] is None else self.blob(row[0])

    def place(self, piece: str, put: Place | None = None) -> Place | None:
        """How far a piece is made; a place that is put counts when it is the later one. Raises Missing."""
        self.piece(piece)
        if put is not None:
            with self._change():
                self._db.execute(
                    "INSERT INTO place VALUES (?1, ?2, ?3, ?4) ON CONFLICT (piece) DO"
                    " UPDATE SET step = ?2, unit = ?3, at = ?4 WHERE at <= ?4",
                    (piece, put.step, put.unit, put.at),
                )
        row = self._db.execute("SELECT step, unit, at FROM place WHERE piece = ?", (piece,)).fetchone()
        return None if row is None else Place(*row)

    def _sweep(self) -> None:
        """What has lain in the bin for long goes, with the bytes that nothing holds any more."""
        with self._change():
            before = now() - limits.BINNED_DAYS * 86_400_000
            self._db.execute("UPDATE piece SET head = NULL WHERE binned < ?", (before,))
            gone = self._db.execute("DELETE FROM piece WHERE binned < ?", (before,)).rowcount
            if gone:
                self._db.execute(
                    "DELETE FROM blob WHERE sha256 NOT IN (SELECT source FROM revision WHERE source IS NOT NULL)"
                    " AND sha256 NOT IN (SELECT picture FROM piece WHERE picture IS NOT NULL)"
                    " AND sha256 NOT IN (SELECT json_extract(value, '$.sha256') FROM revision, json_each(files))"
                )


def _json(value: Any) -> str:
    return json.dumps(value, ensure_ascii=False, separators=(",", ":"))


def _statements(text: str) -> Iterator[str]:
    """The statements of a file, one by one: ``executescript`` would end the transaction."""
    held = ""
    for line in text.splitlines(keepends=True):
        held += line
        if sqlite3.complete_statement(held):
            yield held
            held = ""

"""Export: a library as one archive of plain files: every piece with all its revisions as JSON, and their sources."""

from __future__ import annotations

import json
import zipfile
from collections.abc import Iterator
from dataclasses import asdict
from pathlib import Path

from tambour.core.errors import TambourError
from tambour.files.sink import Writing
from tambour.studio import limits
from tambour.studio.library import Library, Piece

EVERY = 10**9


def export(library: Path, to: Path) -> int:
    """Write the archive ``to``; gives how many pieces it holds, those in the bin among them.

    ``pieces/ID.json`` : the piece and its revisions, the youngest first; ``files/SHA256`` : what they are made of.
    """
    if not library.is_file():
        raise TambourError("there is no library yet", hint="--library PATH names another", where=str(library))
    held = Library(library)
    try:
        pieces = list(held.call(lambda: list(_pieces(held))))
        blobs: set[str] = set()
        with Writing() as writing:
            with (
                writing.sink(to).stream() as file,
                zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive,
            ):
                for piece in pieces:
                    revisions = held.call(held.history, piece.id, EVERY)
                    for it in (revision.content for revision in revisions):
                        blobs |= {name for name in [it.source, *(f["sha256"] for f in it.files.values())] if name}
                    told = {**asdict(piece), "revisions": [asdict(revision) for revision in revisions]}
                    archive.writestr(f"pieces/{piece.id}.json", json.dumps(told, indent=1, ensure_ascii=False))
                for name in sorted(blobs):
                    archive.writestr(f"files/{name}", held.call(held.blob, name))
            writing.commit()
        return len(pieces)
    finally:
        held.close()


def _pieces(library: Library) -> Iterator[Piece]:
    for binned in (False, True):
        after = None
        while found := library.pieces(after, limits.LISTED, binned):
            yield from found
            after = (found[-1].changed, found[-1].id)

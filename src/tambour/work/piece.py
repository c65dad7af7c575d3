"""Piece: a piece to make, told so that it can be made anywhere: bytes come in, bytes go out, and no disk is asked."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tambour.core.errors import Problem, TambourError, Text
from tambour.core.progress import Progress

if TYPE_CHECKING:
    from tambour.craft import Craft

PICTURES = (".png", ".jpg", ".jpeg", ".webp")
"""Suffixes of files that a small picture is made from."""


@dataclass(frozen=True, slots=True)
class Job:
    """A piece to make.

    params : plain values ; files : the fields that name files → a name in ``blobs``
    source : a name in ``blobs``, or None ; edits : as data
    out : the names of the files wanted, each with its suffix ; thumb : pixels of a small picture's longer side, or 0
    blobs : name, as its owner gave it → content
    how : the function that makes it, as "module:name": it takes the job, where its blobs lie, and a Progress
    """

    craft: str
    params: Mapping[str, Any]
    out: Sequence[str] = ()
    source: str | None = None
    files: Mapping[str, str] = field(default_factory=dict)
    edits: Sequence[Any] = ()
    thumb: int = 0
    blobs: Mapping[str, bytes] = field(default_factory=dict, repr=False)
    how: str = "tambour.work.piece:make"


@dataclass(frozen=True, slots=True)
class Done:
    """What became of a job.

    report : what was measured ; files : name → content ; thumb : a small picture as WebP, or nothing
    reason : why there is no piece, or nothing ; fault : the traceback, where it was a fault of tambour's
    """

    report: Mapping[str, Any] = field(default_factory=dict, repr=False)
    files: Mapping[str, bytes] = field(default_factory=dict, repr=False)
    thumb: bytes = field(default=b"", repr=False)
    reason: str = ""
    fault: str = ""


def make(job: Job, laid: Mapping[str, Path], progress: Progress | None = None, what: Craft | None = None) -> Done:
    """Make the piece; TambourError for what cannot be used.

    laid : where the job's blobs lie, each under its own last name; what is told and written has the given names
    what : the craft, where it is not simply the one that the job names
    """
    from tambour.files.sink import Kept
    from tambour.files.text import dumps
    from tambour.run import craft, write
    from tambour.run import make as make_piece

    what, progress = what or craft(job.craft), progress or Progress()
    try:
        params = what.params.of({**job.params, **{name: str(laid[blob]) for name, blob in job.files.items()}})
        source = None
        if job.source is not None:
            with progress.stage("read"):
                source = _source(laid[job.source], laid[job.source].stat().st_mtime_ns, tuple(what.reads))
            if isinstance(source, Text):
                source = replace(source, name=job.source)
        made = make_piece(what, source, params, job.edits, progress)
        kept = Kept()
        report = write(made, job.out, into=kept)
        thumb = _thumb(made, kept.files, job.thumb) if job.thumb else b""
    except TambourError as error:
        raise TambourError([_renamed(p, laid) for p in error.problems]) from None
    told = dumps(report)
    for given, place in laid.items():
        told = told.replace(json.dumps(str(place))[1:-1], json.dumps(given, ensure_ascii=False)[1:-1])
    report = json.loads(told)
    if job.source is not None:
        report["source"] = {"path": job.source, **report["source"]}
    return Done(report, kept.files, thumb)


@lru_cache(maxsize=1)
def _source(path: Path, changed: int, kinds: tuple[str, ...]) -> Any:
    """A source's value: pieces of one source follow each other, and it is read once for them. ``changed`` tells files apart."""
    from tambour import files

    return files.read(path, kinds)


def _renamed(problem: Problem, laid: Mapping[str, Path]) -> Problem:
    """The problem with given names in the place of where things were laid."""
    where, message, hint = problem.where, problem.message, problem.hint
    for given, place in laid.items():
        where, message, hint = (text.replace(str(place), given) for text in (where, message, hint))
    return replace(problem, where=where, message=message, hint=hint)


def _thumb(made: Any, kept: Mapping[str, bytes], side: int) -> bytes:
    """From the first picture that was made, else of the piece itself."""
    from tambour.work.thumbs import shrunk, thumb

    for name, raw in kept.items():
        if name.lower().endswith(PICTURES):
            return shrunk(raw, side)
    return thumb(made.craft.name, made.piece, side)

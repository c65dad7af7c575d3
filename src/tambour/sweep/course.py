"""Course: a sweep as it goes: what is finished is passed over, the rest is made by a pool, results come as they come."""

from __future__ import annotations

import time
from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from contextlib import ExitStack, closing, suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any, Protocol

if TYPE_CHECKING:
    from tambour.core.errors import Problem
    from tambour.sweep.folder import Folder
    from tambour.sweep.plan import Piece, Plan
    from tambour.work.limit import Limit
    from tambour.work.piece import Done, Job

INDEX_SECONDS = 2.0
"""Time between two makings of the index while a sweep goes on; and twenty times as long as the last took."""
WRITERS = 4
"""Threads that leave files."""


class Pool(Protocol):
    """Where pieces are made."""

    @property
    def width(self) -> int:
        """How many at once, as things stand."""

    def submit(self, job: Job) -> Future[Done]:
        """What will become of a job."""

    def close(self) -> None:
        """End whatever is being made."""


@dataclass(frozen=True, slots=True)
class Result:
    """A piece of a sweep.

    status : "made", "kept" (it was finished before) or "failed" (``reason`` says why)
    chosen : what was set for it ; seconds : spent on it, of the worker ; files : names in the folder
    report : what was measured (empty where it was kept) ; data, thumb : the files' bytes and a small picture, where there is no folder
    """

    key: str
    name: str
    source: str
    status: str
    chosen: Mapping[str, Any]
    reason: str = ""
    seconds: float = 0.0
    files: tuple[str, ...] = ()
    report: Mapping[str, Any] = field(default_factory=dict, repr=False)
    data: Mapping[str, bytes] = field(default_factory=dict, repr=False)
    thumb: bytes = field(default=b"", repr=False)


def sweep(
    craft: str,
    sources: Sequence[str | Path] = (),
    axes: Mapping[str, Any] | Sequence[str] = (),
    out: str | Path | None = None,
    files: Sequence[str] = (),
    edits: Sequence[Any] = (),
    jobs: int | None = None,
    limit: str = "",
    again: bool = False,
    sheet: bool = True,
    scheduler: str = "",
    cluster: int = 0,
) -> Iterator[Result]:
    """Make every source with every combination of values; results come as they are ready, in any order.

    craft : its name
    sources : files, and folders of files; none for a craft that needs none
    axes : field → values (``{"max_float": [3, 4, 5]}``), or texts as the command takes them (``"seed=0..9"``)
    out : the folder that pieces, reports, ``index.csv`` and the contact sheets go to; None: results hold the bytes
    files : kinds of files, such as ``.png`` or ``.back.png``
    edits : changed by hand on every piece, see :meth:`tambour.craft.Craft.edits`
    jobs : processes; as many as there are processors when None
    limit : memory and time of each piece: ``"2GB,60s"``
    again : make what is finished once more
    sheet : make ``sheet.png`` and ``sheet.html``, with small pictures
    scheduler, cluster : a Dask scheduler's address, or how many workers of a Dask cluster on this machine

    Raises TambourError for what cannot be, before anything is made, and where the folder cannot be written. A piece
    that fails is a result. Leaving the iterator (``close``, ``break``) ends what is being made.

    >>> from tambour.sweep import sweep
    >>> for made in sweep("ink", axes={"seed": ["1"], "span": [100]}, jobs=1):
    ...     print(made.name, made.status)
    ink-seed=1-span=100 made
    """
    made, limited, _, _ = planned(craft, sources, axes, files, edits, limit, sheet and out is not None, out)
    return course(made, out, pool(jobs, limited, scheduler, cluster), again, sheet)


def planned(
    craft: str,
    sources: Sequence[str | Path],
    axes: Mapping[str, Any] | Sequence[str],
    files: Sequence[str],
    edits: Sequence[Any],
    limit: str,
    thumbs: bool,
    out: str | Path | None = None,
) -> tuple[Plan, Limit, int, list[Problem]]:
    """The plan, the limit, how many pieces there are, and warnings. TambourError with all that is wrong at once."""
    from tambour.core.errors import Problem as Told
    from tambour.core.errors import TambourError
    from tambour.run import craft as named
    from tambour.run import outputs
    from tambour.sweep.axes import axes as read
    from tambour.sweep.axes import judged
    from tambour.sweep.plan import plan
    from tambour.work.limit import Limit as Limited
    from tambour.work.thumbs import SIDE

    what = named(craft)
    problems: list[Problem] = []
    doubts: list[Problem] = []
    found: Mapping[str, Sequence[Any]] = {}
    limited, made = Limited(), None
    try:
        found, doubts = read(what, axes)
    except TambourError as error:
        problems += error.problems
    try:
        limited = Limited.of(limit) if limit else limited
    except TambourError as error:
        problems += error.problems
    try:
        made, left = plan(what, list(map(str, sources)), found, files, edits, SIDE if thumbs else 0)
        doubts = [*doubts, *left]
    except TambourError as error:
        problems += error.problems
    try:
        outputs(what, [f"piece{kind}" for kind in files if kind.startswith(".")], "")
    except TambourError as error:
        problems += error.problems
    if made is not None and out is not None:
        home = Path(out).resolve()
        among = [path for path, _ in made.sources if path is not None and Path(path).resolve().parent == home]
        if among:
            told = "the pieces would lie among their sources"
            problems.append(Told(told, f"name another folder: {among[0]} is in this one", where=str(out)))
    if problems or made is None:
        raise TambourError(problems)
    count, more = judged(what, found, files)
    return made, limited, count * len(made.sources), [*doubts, *more]


def pool(jobs: int | None = None, limit: Limit | None = None, scheduler: str = "", cluster: int = 0) -> Pool:
    """Where pieces are made: processes here, or a Dask cluster."""
    if scheduler or cluster:
        from tambour.work.cluster import Cluster

        return Cluster(scheduler, cluster, limit)
    from tambour.work.local import Local

    return Local(jobs, limit)


class Pieces(Protocol):
    """What is to be made: every piece, and the kinds of files wanted of each."""

    @property
    def out(self) -> Sequence[str]:
        """Suffixes, with or without a view."""

    def pieces(self) -> Iterator[Piece]:
        """Every piece, one after the other."""


def course(
    plan: Pieces, out: str | Path | None, pool: Pool, again: bool = False, sheet: bool = True
) -> Iterator[Result]:
    """The results of a plan. The pool is closed in the end."""
    from tambour.core.errors import Problem, TambourError
    from tambour.sweep.folder import Folder as Kept

    with ExitStack() as stack:
        stack.enter_context(closing(pool))
        folder = None if out is None else stack.enter_context(Kept(Path(out)))
        if folder is None:
            yield from _made(plan.pieces(), pool, None)
            return
        try:
            yield from _made(_left(plan, folder, again), pool, folder)
        except TambourError as error:  # the disk refuses: what is there stays true, and is told if that can be written
            told = Problem("the sweep is stopped: what is made stands", "make room, and run the same again")
            with suppress(TambourError):
                folder.index()
                told = Problem("the sweep is stopped: what is made stands in index.csv", told.hint)
            raise TambourError([*error.problems, told]) from None
        except BaseException:
            with suppress(TambourError):
                folder.index()
            raise
        rows = folder.index()
        if sheet:
            from tambour.sweep.contact import contact

            contact(folder, rows)


def _left(plan: Pieces, folder: Folder, again: bool) -> Iterator[Piece | Result]:
    """The pieces that are to be made; of those that are finished, the result."""
    known = {} if again else {row.key: row for row in folder.rows() if row.status == "made"}
    for piece in plan.pieces():
        # By its own name it is looked for now: another sweep may have made it meanwhile.
        own = None if again or piece.reason else folder.row(piece.name)
        row = own if own is not None and own.key == piece.key else known.get(piece.key)
        if row is not None and folder.finished(row, plan.out):
            source = piece.job.source or ""
            yield Result(piece.key, row.name, source, "kept", piece.chosen, "", row.seconds, row.files)
        else:
            yield piece


def _made(pieces: Iterator[Piece | Result] | Iterator[Piece], pool: Pool, folder: Folder | None) -> Iterator[Result]:
    """Results as they come. A few more than are made at once wait, so that no worker does.

    Files are left by threads: a disk takes many at once in about the time of one, and they are whole in the end.
    """
    waiting: dict[Future[Done], Piece] = {}
    leaving: set[Future[Result]] = set()
    indexed, pause = time.monotonic(), INDEX_SECONDS
    more = True
    with ThreadPoolExecutor(WRITERS) as writers:

        def ended(piece: Piece, done: Done) -> None:
            leaving.add(writers.submit(_result, piece, done, folder))

        while more or waiting or leaving:
            while more and len(waiting) < 2 * pool.width + 1 and len(leaving) < 2 * WRITERS:
                one = next(pieces, None)
                if one is None:
                    more = False
                elif isinstance(one, Result):
                    yield one
                elif one.reason:
                    ended(one, _refusal(one.reason))
                else:
                    waiting[pool.submit(one.job)] = one
            running: list[Future[Any]] = [*waiting, *leaving]
            for future in wait(running, return_when=FIRST_COMPLETED).done:
                if future in leaving:
                    leaving.discard(future)
                    yield future.result()
                else:
                    ended(waiting.pop(future), future.result())
            if folder is not None and time.monotonic() - indexed > pause:
                began = time.monotonic()
                folder.index()
                indexed = time.monotonic()
                pause = max(INDEX_SECONDS, 20 * (indexed - began))


def _refusal(reason: str) -> Done:
    from tambour.work.piece import Done as Ended

    return Ended(reason=reason)


def _result(piece: Piece, done: Done, folder: Folder | None) -> Result:
    """Leave a piece in the folder, and tell of it."""
    spent = round(sum((done.report.get("seconds") or {}).values()), 6)
    status = "failed" if done.reason else "made"
    if folder is not None:
        folder.put(piece, done)
    return Result(
        piece.key,
        piece.name,
        piece.job.source or "",
        status,
        piece.chosen,
        done.reason,
        spent,
        tuple(done.files),
        done.report,
        {} if folder is not None else done.files,
        b"" if folder is not None else done.thumb,
    )

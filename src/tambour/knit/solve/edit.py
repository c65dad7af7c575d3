"""Edit: set stitches by hand and solve again what that concerns."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

import numpy as np

from tambour.core.check import Array
from tambour.core.errors import Problem, TambourError
from tambour.core.progress import Progress
from tambour.knit.params import KnitParams
from tambour.knit.piece import Piece
from tambour.knit.solve import coloured, exact, floats, percept
from tambour.knit.solve.assemble import State, assemble
from tambour.knit.solve.stages import priced, seen_task, sight_of
from tambour.knit.task import PLAIN, Task


def resolve(piece: Piece, edits: Iterable[tuple[int, int, int]], progress: Progress | None = None) -> Piece:
    """The piece with stitches set by hand and, in stranded knitting, the rows that this concerns solved again.

    edits : (row, stitch, palette entry) each; row 0 is the cast-on row. The stitches become locked.

    Under ``exact`` and the paper's methods only the edited rows are solved again (exactly); ``perceptual`` also lets the
    rows that see them follow; ``none`` and ``check`` change nothing else. Raises TambourError for an edit outside the
    chart, of a colour that its row does not have, or that leaves no lawful row.
    """
    if piece.chart.behind is not None:
        raise TambourError(
            "stitches of two pictures hold each other: none is set by hand",
            hint="a yarn's colour can be",
            where="{--edit}",
        )
    if piece.chart.technique != "stranded":
        return coloured.edited(piece, list(edits), progress or Progress())
    state: State = piece.state
    task, params = state.task, piece.params
    rows, stitches = state.cells.shape
    locked = task.locked.copy() if task.locked.size else np.zeros((rows, stitches), np.bool_)
    cells, start = state.cells.copy(), task.start.copy()
    touched = np.zeros(rows, np.bool_)
    problems = []
    for r, x, colour in edits:
        if not (0 <= r < rows and 0 <= x < piece.chart.cells.shape[1]):
            problems.append(Problem(f"there is no stitch {x} in row {r}", f"{rows} rows of {stitches} stitches"))
        elif colour not in state.pairs[r]:
            problems.append(
                Problem(f"row {r} is not knitted with colour {colour}", f"it has {state.pairs[r].tolist()}")
            )
        else:
            x %= stitches
            cells[r, x] = start[r, x] = int(colour == state.pairs[r, 1])
            locked[r, x] = touched[r] = True
    if problems:
        raise TambourError(problems)
    task = replace(task, start=start, locked=locked)
    if params.method == "perceptual" and not params.check:
        eye = sight_of(task.limit, params)
        reach = eye.down.shape[1] - 1
        low = max(0, int(touched.argmax()) - 2 * reach)
        high = min(rows, rows - int(touched[::-1].argmax()) + 2 * reach)
        part = seen_task(task, params).rows(low, high)
        solve_part(part, cells[low:high], touched[low:high], eye, params, task)
    elif params.method != "none" and not params.check:
        for r in np.flatnonzero(touched).tolist():
            low, high = max(0, r - 2), min(rows, r + 3)
            was = cells.copy() if params.method == "diffused" else start
            line = replace(task, start=np.where(touched[:, None], was, task.start)).rows(r, r + 1)
            cells[r : r + 1] = exact.solve(line)
    before = floats.measure(task, task.start)
    again = assemble(
        replace(state, task=task, cells=cells),
        piece.chart.palette,
        piece.kind,
        piece.figures["start"],
        params,
        before,
        Progress(),
    )
    kept = {k: piece.figures[k] for k in ("style", "why", "technique", "suggested", "seen_from") if k in piece.figures}
    return replace(again, textured=piece.textured, figures={**kept, **again.figures})


def solve_part(part: Task, cells: Array, touched: Array, eye: percept.Eye, params: KnitParams, whole: Task) -> None:
    """Solve the touched rows of ``cells`` in place, then once more the rows that see them."""
    keep = 1.0 if priced(whole, params) else 0.0
    if part.ring:
        # A round is solved between stitches that stay: make the edited ones lawful first.
        for r in np.flatnonzero(touched).tolist():
            line = replace(part.rows(r, r + 1), start=cells[r : r + 1].copy(), weights=PLAIN)
            cells[r : r + 1] = exact.solve(line)
    percept.solve(part, eye, keep, 2, cells=cells, dirty=touched)

"""Row by row: each row against every lawful one, what is left over against its sum, the laws by the independent check."""

import itertools

import numpy as np
import pytest

from tambour.core.picture import Picture
from tambour.core.progress import Progress
from tambour.knit import CRAFT
from tambour.knit.params import KnitParams
from tambour.knit.solve import diffused, floats
from tambour.knit.solve.edit import resolve
from tambour.knit.task import NONE, Task


def lawful(row, f, ring, relaxed):
    """No f + 1 equal stitches in a row none of which is relaxed."""
    n = len(row)
    starts = range(n) if ring and n > f else range(n - f)
    windows = ([(s + k) % n for k in range(f + 1)] for s in starts)
    return not any(len({row[x] for x in w}) == 1 and not any(relaxed[x] for x in w) for w in windows)


@pytest.mark.parametrize("ring", [False, True])
def test_a_row_is_the_nearest_of_all_lawful_rows(ring):
    rng = np.random.default_rng(3)
    for _ in range(40):
        n, f = int(rng.integers(4, 11)), int(rng.integers(1, 4))
        tone = rng.random((1, n)).astype(np.float32) ** 3
        start = rng.integers(0, 2, (1, n)).astype(np.uint8)
        locked, relaxed = rng.random((1, n)) < 0.1, rng.random((1, n)) < 0.15
        every = [
            row
            for row in itertools.product((0, 1), repeat=n)
            if lawful(row, f, ring, relaxed[0]) and all(row[x] == start[0, x] for x in np.flatnonzero(locked[0]))
        ]
        if not every:
            continue
        task = Task(tone, start, f, ring=ring, locked=locked, relaxed=relaxed)
        row = diffused.solve(task)[0]
        assert tuple(row.tolist()) in every
        best = min(float(((np.array(r) - tone[0]) ** 2).sum()) for r in every)
        assert float(((row - tone[0]) ** 2).sum()) == pytest.approx(best, abs=1e-5)


@pytest.mark.parametrize("level", [0.25, 0.4, 0.5, 0.7])
def test_what_a_row_cannot_show_comes_to_the_next(level):
    task = Task(np.full((60, 60), level, np.float32), np.zeros((60, 60), np.uint8), 4)
    cells = diffused.solve(task)
    assert cells.mean() == pytest.approx(level, abs=0.01)
    assert (np.abs(np.add.accumulate(cells[::-1].mean(1) - level)) < 0.75).all()  # not at the end only


def test_every_law_holds_and_an_edit_leaves_the_rest():
    rgba = np.full((40, 50, 4), 255, np.uint8)
    rgba[..., :3] = np.linspace(0, 255, 50)[None, :, None]
    cases = (
        {},
        {"edges": "free", "edge_run": 9},
        {"round": True},
        {"max_float": "1"},
        {"repeat": "10"},
        {"tone": "raw"},
    )
    for more in cases:
        piece = CRAFT.make(Picture(rgba), KnitParams(method="diffused", stitches=50, **more), Progress())
        assert piece.figures["violations"] == 0 and floats.measure(piece.state.task, piece.state.cells).violations == 0
    assert piece.state.task.knit is NONE
    was = piece.chart.cells
    again = resolve(piece, [(20, 25, 1 - int(was[20, 25]))]).chart.cells
    assert again[20, 25] != was[20, 25] and (np.delete(again, 20, 0) == np.delete(was, 20, 0)).all()
    assert (again[20] != was[20]).sum() <= 6

"""The float limit, and the fewest flips that meet it."""

from __future__ import annotations

from itertools import groupby

import numpy as np
import pytest

from tambour.knit.solve import exact, floats
from tambour.knit.task import Task


def runs(row, ring=False):
    """(colour, length) of each run, told by plain Python: the checker that shares nothing with the solvers."""
    found = [(int(c), len(list(g))) for c, g in groupby(row)]
    if ring and len(found) > 1 and found[0][0] == found[-1][0]:
        found[0] = (found[0][0], found[0][1] + found.pop()[1])
    return found


def random_task(rng, rows=6, **more):
    stitches = int(rng.integers(3, 40))
    start = (rng.random((rows, stitches)) < rng.choice([0.05, 0.2, 0.5, 0.9])).astype(np.uint8)
    return Task(np.zeros(start.shape, np.float32), start, int(rng.integers(2, 8)), **more)


def test_measure_tells_runs_conflicts_and_windows():
    rng = np.random.default_rng(1)
    for _ in range(60):
        task = random_task(rng, ring=bool(rng.integers(2)))
        cells = task.start
        lengths = [n for row in cells for _, n in runs(row, task.ring)]
        found = floats.measure(task, cells)
        long = [n for n in lengths if n > task.limit]
        whole = [n for row in cells for _, n in runs(row, task.ring) if n == len(row)] if task.ring else []
        extra = sum(task.limit for n in whole if n > task.limit)
        assert found.stitches == cells.size and found.conflicts == sum(long)
        assert found.violations == sum(n - task.limit for n in long) + extra
        assert found.longest == max(lengths)
        assert found.histogram.sum() == len(lengths)


@pytest.mark.parametrize("limit", [2, 3, 4, 7])
def test_the_exact_chart_is_lawful_and_has_the_closed_form_s_flips(limit):
    rng = np.random.default_rng(limit)
    for _ in range(25):
        start = (rng.random((9, int(rng.integers(1, 70)))) < rng.choice([0, 0.1, 0.5, 0.95])).astype(np.uint8)
        task = Task(np.zeros(start.shape, np.float32), start, limit)
        cells = exact.solve(task)
        assert max(n for row in cells for _, n in runs(row)) <= limit
        assert (cells != start).sum() == floats.fewest(start, limit)
        assert floats.fewest(start, limit) == sum(n // (limit + 1) for row in start for _, n in runs(row))

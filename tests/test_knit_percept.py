"""The row-exact step of the perceptual solver against brute force, and the energy's promises."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest

from tambour.knit import floats, percept
from tambour.knit.task import Task


def energy(cells, tone, sight, knit=None):
    """E by its definition: the error filtered over the plane, in plain NumPy, double precision."""
    e = cells.astype(float) - tone
    if knit is not None:
        e = np.where(knit, e, 0)
    total = 0.0
    rows, stitches = e.shape
    for across, down in zip(sight.across.astype(float), sight.down.astype(float)):
        a = np.array(
            [[across[abs(i - j)] if abs(i - j) < len(across) else 0 for j in range(stitches)] for i in range(stitches)]
        )
        d = np.array([[down[abs(i - j)] if abs(i - j) < len(down) else 0 for j in range(rows)] for i in range(rows)])
        total += (e * (d @ e @ a)).sum()
    return total


def random_case(rng, stitches):
    rows = int(rng.integers(1, 5))
    tone = rng.random((rows, stitches)).astype(np.float32)
    cells = (rng.random((rows, stitches)) < 0.5).astype(np.uint8)
    start = (rng.random((rows, stitches)) < 0.5).astype(np.uint8)
    more = {}
    if rng.random() < 0.4:
        more["free"] = True
        if rng.random() < 0.5:
            more["cap"] = int(rng.integers(1, stitches + 1))
    if rng.random() < 0.25:
        more["relaxed"] = rng.random((rows, stitches)) < 0.2
    if rng.random() < 0.25:
        more["locked"] = rng.random((rows, stitches)) < 0.1
    if rng.random() < 0.2:
        more["soft"] = 0.05
    if rng.random() < 0.3:
        more["weights"] = rng.random((rows, stitches)).astype(np.float32)
    return Task(tone, start, int(rng.integers(1, 6)), **more), cells


@pytest.mark.parametrize("seed", range(4))
def test_a_row_is_the_best_of_all_rows(seed):
    rng = np.random.default_rng(seed)
    for _ in range(55):
        task, cells = random_case(rng, int(rng.integers(4, 12)))
        keep = 0.05 if task.weights.size else 0.0
        y = int(rng.integers(len(cells)))
        sight = percept.eye(task.limit, scales=((1.0, 1.0), (0.6, 0.1)), radius=3)
        if task.locked.size:
            cells[task.locked] = task.start[task.locked]

        def cost(row, cells=cells, y=y, task=task, sight=sight, keep=keep):
            chart = cells.copy()
            chart[y] = row
            value = energy(chart, task.tone, sight)
            if keep:
                value += keep * (task.weights * (chart != task.start))[y].sum()
            wrong = floats.measure(task.rows(y, y + 1), chart[y : y + 1]).violations
            return value + (wrong * task.soft if task.soft else (1e9 if wrong else 0))

        held = task.locked[y] if task.locked.size else np.zeros(cells.shape[1], bool)
        every = [
            r for r in map(np.array, product((0, 1), repeat=cells.shape[1])) if (r[held] == task.start[y][held]).all()
        ]
        least = min(cost(r) for r in every)
        if least > 1e8:
            continue
        dirty = np.zeros(len(cells), np.bool_)
        dirty[y] = True
        solved = percept.solve(task, sight, keep, 1, cells=cells.copy(), dirty=dirty)
        assert (np.delete(solved, y, 0) == np.delete(cells, y, 0)).all()
        assert cost(solved[y]) == pytest.approx(least, abs=2e-5)

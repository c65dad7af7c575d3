"""The row-exact step of the perceptual solver against brute force, and the energy's promises."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest

from tambour.knit.solve import floats, percept
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


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(4))
def test_a_row_is_the_best_of_all_rows(seed):
    rng = np.random.default_rng(seed)
    for _ in range(52):
        task, cells = random_case(rng, int(rng.integers(4, 11)))
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


@pytest.mark.slow
def test_masked_rows_are_the_best_too():
    """A shape that narrows at its sides: brute force over the knitted stitches alone."""
    rng = np.random.default_rng(9)
    for _ in range(25):
        stitches, rows = int(rng.integers(6, 12)), 3
        knit = np.zeros((rows, stitches), np.bool_)
        for r in range(rows):
            a = int(rng.integers(0, 3))
            knit[r, a : stitches - int(rng.integers(0, 3))] = True
        tone = rng.random((rows, stitches)).astype(np.float32)
        task = Task(tone, np.zeros((rows, stitches), np.uint8), int(rng.integers(2, 5)), knit=knit)
        cells = (rng.random((rows, stitches)) < 0.5).astype(np.uint8) * knit
        sight = percept.eye(task.limit, scales=((1.1, 1.0), (0.7, 0.1)), radius=3)
        solved = percept.solve(task, sight, 0.0, 1, cells=cells.copy(), dirty=np.arange(rows) == 1)
        at = np.flatnonzero(knit[1])
        least = np.inf
        for bits in product((0, 1), repeat=len(at)):
            chart = cells.copy()
            chart[1, at] = bits
            if not floats.measure(task.rows(1, 2), chart[1:2]).violations:
                least = min(least, energy(chart, tone, sight, knit))
        assert energy(solved, tone, sight, knit) == pytest.approx(least, abs=2e-5)


def ring_energy(cells, tone, sight):
    """E of a tube: rows close upon themselves."""
    e = cells.astype(float) - tone
    rows, n = e.shape
    total = 0.0
    for across, down in zip(sight.across.astype(float), sight.down.astype(float)):
        a = np.zeros((n, n))
        for i in range(n):
            for k in range(-len(across) + 1, len(across)):
                a[i, (i + k) % n] += across[abs(k)]
        d = np.array([[down[abs(i - j)] if abs(i - j) < len(down) else 0 for j in range(rows)] for i in range(rows)])
        total += (e * (d @ e @ a)).sum()
    return total


@pytest.mark.parametrize("ring", [False, True])
def test_sweeps_never_raise_the_energy(ring):
    rng = np.random.default_rng(11)
    tone = np.clip(rng.random((20, 34)) * 0.3 + np.linspace(0, 0.8, 34), 0, 1).astype(np.float32)
    task = Task(tone, np.zeros(tone.shape, np.uint8), 3, ring=ring)
    sight = percept.eye(3)
    measure = ring_energy if ring else energy
    cells = percept.solve(task, sight, sweeps=1)
    last = measure(cells, tone, sight)
    for _ in range(4):
        cells = percept.solve(task, sight, sweeps=1, cells=cells, dirty=np.ones(20, np.bool_))
        now = measure(cells, tone, sight)
        assert now <= last + 1e-4
        assert floats.measure(task, cells).violations == 0
        last = now


@pytest.mark.parametrize("stitches", [3, 5, 9, 16, 17, 25])
def test_rounds_of_any_size_are_lawful_and_bright_as_they_should(stitches):
    tone = np.full((12, stitches), 0.4, np.float32)
    task = Task(tone, np.zeros(tone.shape, np.uint8), 2, ring=True)
    cells = percept.solve(task, percept.eye(2))
    assert floats.measure(task, cells).violations == 0
    assert cells.mean() == pytest.approx(0.4, abs=0.08)


def test_the_kernel_sums_to_what_the_eye_keeps():
    """The two scales' autocorrelations sum to their weights, and are even and positive definite by construction."""
    sight = percept.eye(4)
    for across, down, (_, weight) in zip(sight.across, sight.down, percept.SCALES):
        assert across[0] + 2 * across[1:].sum() == pytest.approx(1, abs=1e-5)
        assert down[0] + 2 * down[1:].sum() == pytest.approx(weight, abs=1e-5)
        assert (np.fft.rfft(np.r_[across, across[:0:-1]]).real > -1e-6).all()

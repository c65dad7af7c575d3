"""The proven minimum against a solver of another kind (OR-Tools CP-SAT), in every kind of row."""

from __future__ import annotations

import numpy as np
import pytest

from tambour.core.errors import TambourError
from tambour.knit.solve import exact, floats
from tambour.knit.task import Task

EMPTY = np.zeros((0, 0), np.bool_)


def oracle(task, y):
    """(least cost in thousandths, None when impossible) of row ``y``: a boolean per stitch, a clause per window."""
    from ortools.sat.python import cp_model

    model = cp_model.CpModel()
    knitted = [x for x in range(task.start.shape[1]) if not task.knit.size or task.knit[y, x]]
    n, f = len(knitted), task.limit
    loose = [bool(task.relaxed.size and task.relaxed[y, x]) for x in knitted]
    bit = [model.NewBoolVar(f"b{k}") for k in range(n)]
    price = []
    for k, x in enumerate(knitted):
        flip = bit[k] if not task.start[y, x] else 1 - bit[k]
        if task.locked.size and task.locked[y, x]:
            model.Add(flip == 0)
        price.append(round(float(task.weights[y, x] if task.weights.size else 1) * 1000) * flip)
    starts = range(n) if task.ring and n > f else range(n - f)
    for s in starts:
        window = [(s + i) % n for i in range(f + 1)]
        if any(loose[k] for k in window):
            continue
        total = sum(bit[k] for k in window)
        escape = []
        if task.free:
            # The window may be of one colour if all before it, or all after it, is of that colour too, and short enough.
            cap = min(task.cap, n)
            for edge in (0, 1):
                for colour in (0, 1):
                    for size in range(s + f + 1 if edge == 0 else n - s, cap + 1):
                        inside = bit[:size] if edge == 0 else bit[n - size :]
                        beyond = (
                            [bit[size]] if edge == 0 and size < n else [bit[n - size - 1]] if edge and size < n else []
                        )
                        e = model.NewBoolVar("")
                        for b in inside:
                            model.Add(b == colour).OnlyEnforceIf(e)
                        for b in beyond:
                            model.Add(b == 1 - colour).OnlyEnforceIf(e)
                        escape.append(e)
        if task.soft is not None:
            long = model.NewBoolVar("")
            escape.append(long)
            price.append(round(task.soft * 1000) * long)
        model.Add(total + sum(escape) >= 1)
        model.Add(total - sum(escape) <= f)
    model.Minimize(sum(price))
    solver = cp_model.CpSolver()
    solver.parameters.num_workers = 1
    return round(solver.ObjectiveValue()) if solver.Solve(model) == cp_model.OPTIMAL else None


def case(rng):
    """A random task of one row, of a random kind."""
    n = int(rng.integers(4, 22))
    limit = int(rng.integers(1, 6))
    start = (rng.random((1, n)) < rng.choice([0.05, 0.3, 0.6, 0.95])).astype(np.uint8)
    mask = {}
    if rng.random() < 0.3:
        mask["knit"] = rng.random((1, n)) < 0.8
    if rng.random() < 0.3:
        mask["relaxed"] = rng.random((1, n)) < 0.15
    if rng.random() < 0.3:
        mask["locked"] = rng.random((1, n)) < 0.2
    if rng.random() < 0.4:
        mask["weights"] = rng.integers(0, 5000, (1, n)).astype(np.float32) / 1000
    if rng.random() < 0.2:
        mask["soft"] = float(rng.integers(100, 3000)) / 1000
    kind = rng.integers(4)
    if kind == 1:
        mask["free"] = True
        if rng.random() < 0.5:
            mask["cap"] = int(rng.integers(1, n + 1))
    if kind == 2:
        mask["ring"] = True
    return Task(np.zeros((1, n), np.float32), start, limit, **mask)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(8))
def test_no_solver_finds_less(seed):
    rng = np.random.default_rng(seed)
    for _ in range(45):
        task = case(rng)
        least = oracle(task, 0)
        short = task.ring and (task.knit.sum() if task.knit.size else task.start.size) <= task.limit
        if least is None:
            with pytest.raises(TambourError, match="the floats in row 1 would be longer than"):
                exact.solve(task)
            continue
        cells = exact.solve(task)
        flips = (cells != task.start) & (task.knit if task.knit.size else True)
        cost = (np.round((task.weights if task.weights.size else np.ones_like(task.tone)) * 1000) * flips).sum()
        found = floats.measure(task, cells)
        cost += 0 if task.soft is None else round(task.soft * 1000) * found.violations
        assert cost == (0 if short else least), task
        if task.soft is None:
            assert found.violations == 0
        if task.locked.size:
            assert not (flips & task.locked).any()


@pytest.mark.slow
def test_repeats_are_rounds():
    """A motif of 24 that repeats: the oracle sees three copies bound together, the solver one closed row."""
    from ortools.sat.python import cp_model

    rng = np.random.default_rng(5)
    for _ in range(12):
        start = (rng.random((1, 24)) < rng.choice([0.1, 0.5])).astype(np.uint8)
        task = Task(np.zeros(start.shape, np.float32), start, 4, ring=True)
        model = cp_model.CpModel()
        bit = [model.NewBoolVar("") for _ in range(24)]
        wide = bit * 3 + bit[:1]
        for s in range(len(wide) - 4):
            model.Add(sum(wide[s : s + 5]) >= 1)
            model.Add(sum(wide[s : s + 5]) <= 4)
        model.Minimize(sum(b if not v else 1 - b for b, v in zip(bit, start[0])))
        solver = cp_model.CpSolver()
        assert solver.Solve(model) == cp_model.OPTIMAL
        assert (exact.solve(task) != start).sum() == round(solver.ObjectiveValue())


def test_tidy_trades_flips_for_order():
    """A white sheet between two posts: the fewest flips stand in columns; a few more do not."""
    from tambour.knit.solve import measure

    start = np.ones((40, 46), np.uint8)
    start[:, [0, -1]] = 0
    task = Task(start.astype(np.float32), start, 4)
    fewest, tidy = exact.solve(task), exact.solve(task, tidy=3)
    assert (fewest != start).sum() == floats.fewest(start, 4) == 8 * 40
    assert floats.measure(task, tidy).violations == 0
    assert (tidy != start).sum() <= 1.25 * 8 * 40
    assert measure.lined_up(fewest != start) > 900 and measure.lined_up(tidy != start) < 100

"""Every element: its golden, its size against the original's, and its bounds under any parameters in range."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tambour.ink.brush import press
from tambour.ink.brush.desk import Desk
from tambour.ink.elements import (
    banks,
    bushes,
    cun,
    hamlet,
    hills,
    houses,
    people,
    pines,
    ranges,
    rocks,
    sky,
    specimens,
    trees,
    water,
    willows,
)
from tambour.ink.ground.kinds import SPECIMENS
from tambour.ink.ground.marks import Marks

GOLDEN = Path(__file__).parent / "data" / "ink_elements.json"
ORIGINAL = {
    # Mean polygons and points of the original (dossier 1.7 to 1.11, 3), and how far ours may be from them.
    "juniper": (11, 209, 1.05),
    "sapling": (5, 105, 1.05),
    "fir": (73, 1532, 1.05),
    "pine": (576, 13_700, 2.0),
    "cedar": (228, 6_800, 2.2),
    "plum": (390, 9_400, 2.5),
    "bush": (168, 672, 1.4),
    "reed": (29, 600, 1.6),
    "rock": (31, 706, 1.5),
    "figure": (13, 440, 1.2),
}
"""Counts are stated for each element with the original's default sizes."""


def _drawn(name: str, stream: int, how: tuple[Any, ...] | None = None, kernel: Any = None) -> Marks:
    shown = specimens.table()[name]
    desk = Desk.of("ink", 1)
    desk.draw(kernel or shown.kernel, ("test", name, stream), name, 0.0, 0.0, *(shown.how if how is None else how))
    return desk.inked()


@pytest.mark.parametrize("name", ORIGINAL)
def test_counts_are_near_the_original(name: str) -> None:
    drawn = [_drawn(name, k) for k in range(24)]
    polygons, points, factor = ORIGINAL[name]
    assert polygons / factor <= np.mean([len(m) for m in drawn]) <= polygons * factor
    assert points / factor <= np.mean([len(m.coords) for m in drawn]) <= points * factor


def test_a_hill_and_its_waters_have_the_originals_weight() -> None:
    # 190 polygons of its own (1.8), with ours for washes, the lifted skyline and moss; water: 9 polygons, 2161 points (1.11).
    own = []
    for k in range(24):
        m = _drawn("hill", k, (165.0, 500.0, hills.CONE, 0.0, cun.HEMP, 150, 1.0, 0.0, 0.0, 0.0))
        own.append([(m.element == 0).sum(), 2 * np.diff(m.spines)[m.element == 0].sum()])
    polygons, points = np.mean(own, 0)
    assert 150 < polygons < 260
    assert 2600 < points < 7000  # 64 columns where the original has 50, and the washes
    m = _drawn("water", 1, (2.0, 400.0, 9))
    assert len(m) == 9
    assert 1500 < len(m.coords) < 2600


def _summary(m: Marks) -> list[float]:
    return [len(m), len(m.coords), len(m.elements), *m.coords.sum(0).tolist(), *m.elements.bounds[0].tolist()]


def test_every_specimen_is_as_it_was(request: pytest.FixtureRequest) -> None:
    found = {name: _summary(specimens.specimen(name, "golden")) for name in specimens.table()}
    assert set(found) | {"all"} == set(SPECIMENS)
    if request.config.getoption("--update-golden"):
        GOLDEN.parent.mkdir(exist_ok=True)
        rows = ",\n".join(f"{json.dumps(k)}: {json.dumps([round(x, 6) for x in v])}" for k, v in found.items())
        GOLDEN.write_text("{\n" + rows + "\n}\n")
    golden = json.loads(GOLDEN.read_text())
    assert set(golden) == set(found)
    for name, want in golden.items():
        np.testing.assert_allclose(found[name], want, rtol=1e-6, atol=1e-4, err_msg=name)


def _draw_any(rng: np.random.Generator, k: int) -> tuple[Marks, float, float, float]:
    """An element with parameters anywhere in range, and how far it may reach: to the side, up, down."""
    _, forms, _, loops = press.tools()
    h, w, unit = rng.uniform(20, 400), rng.uniform(20, 600), rng.random()
    n = int(rng.integers(1, 7))
    kinds: list[tuple[str, Any, tuple[Any, ...], float, float, float]] = [
        ("juniper", trees.juniper, (h, 6 * unit, unit), 60 * unit + 40, h + 20, 20),
        ("sapling", trees.sapling, (h, w, n, unit), 4 * n + h + w, 4 * n + h, 4 * n + h),
        ("fir", trees.fir, (h, 9 * unit, unit, unit), 150, h + 40, 40),
        ("rock", rocks.rock, (h, w, 40, 9 * unit), 1.3 * w + 40, 1.3 * h + 40, 0.6 * h + 40),
        ("water", water.water, (4 * unit, w, n), w + 10, 30, 6 * n + 10),
        ("hill", hills.hill, (h, w, n, 2 * unit - 1, n % 3, 200, 1.0, 1.0, 1.0, 1.0), 0.6 * w + 200, h + 300, 260),
        ("hamlet", hamlet.hamlet, (w, n, 1.0, 1.0, 1.0), 0.7 * w + 140, 260, 60),
        ("bridge", hamlet.bridge, (w, 1.0, 1.0), 0.7 * w + 90, 160, 60),
        ("bank", banks.bank, (100.0, w + 300, unit, 1.0, 1.0, 1.0, 1.0, forms, loops), w + 900, 900, 400),
        ("range", ranges.distant, (h, w, unit), w + 10, h + 10, 30),
        ("pine", pines.pine, (h, 6.0), 2 * h + 60, 2 * h + 60, 2 * h + 60),
        ("cedar", pines.cedar, (h, 5.0), 2 * h + 60, 2 * h + 60, h + 60),
        ("willow", willows.willow, (h, 4.0), 1.3 * h + 30, 1.3 * h + 30, 0.1 * h + 30),
        ("plum", pines.plum, (h, 6.0, unit), 4 * h + 60, 4 * h + 60, 2 * h + 60),
        ("bush", bushes.bush, (h, 9 * unit, 0.5, forms, loops), 160, h + 60, 60),
        ("reed", bushes.reed, (h, 2 * unit), 2 * h + 20, 2 * h + 20, h + 20),
        ("hut", houses.hut, (h, w, unit, 9 * unit, n % 3), 0.6 * w + h + 40, 1.3 * h + 40, 0.3 * h + 60),
        ("house", houses.house, (h, w, unit, 9 * unit, n, n % 4, n > 3), w + 20, 1.7 * h * n + 60, 60),
        ("pagoda", houses.pagoda, (h, w, n), w + 40, 1.6 * h * n + 2.5 * h, w),
        ("pavilion", houses.pavilion, (h, w, n), w + 40, 1.7 * h * n + 2 * h, w),
        ("pylon", houses.pylon, (h, w), 1.5 * w, 1.3 * h, 20),
        (
            "figure",
            people.figure,
            (2 * unit, 1.0, n % 3, 5 * unit, n % 5),
            700 * unit + 9,
            480 * unit + 9,
            60 * unit + 9,
        ),
        ("boat", people.boat, (w, unit, -1.0, n > 2), w + 300, 300, 60),
        ("birds", sky.birds, (n,), 160, 60, 60),
        ("waterfall", sky.waterfall, (h, 20 * unit), 60 + 0.2 * h, h + 40, 40),
        ("mist", sky.mist, (unit, w), 2 * w + 60, 200, 200),
        ("moon", sky.moon, (h,), 3 * h, 3 * h, 3 * h),
        ("sun", sky.sun, (h,), 3 * h, 3 * h, 3 * h),
    ]
    name, kernel, how, side, up, down = kinds[k % len(kinds)]
    how = tuple(float(v) if isinstance(v, np.floating) else v for v in how)
    return _drawn(name, k, how, kernel), side, up, down


@pytest.mark.slow
def test_a_thousand_draws_of_parameters_stay_in_bounds() -> None:
    rng = np.random.default_rng(11)
    for k in range(1000):
        marks, side, up, down = _draw_any(rng, k)  # Marks refuses NaN
        left, top, right, low = marks.elements.bounds[0]
        assert np.isfinite(marks.elements.bounds).all()
        name = marks.elements.id[0]
        assert left >= -side and right <= side, (name, left, right, side)
        assert top >= -up and low <= down, (name, top, low, up, down)
        assert (marks.elements.bounds[0, :2] <= marks.coords.min(0)).all()
        assert (marks.elements.bounds[0, 2:] >= marks.coords.max(0)).all()


def test_outlines_hide_and_lines_do_not() -> None:
    m = _drawn("hill", 3)
    assert m.kind[0] == 0 or m.elements.parent[m.element[0]] >= 0, "behind the body only what grows behind the crest"
    bodies = np.flatnonzero(m.kind == 0)
    assert len(bodies)
    assert (m.fill[bodies, 1] == 255).sum() >= 1
    lines = m.kind == 6
    assert (m.fill[lines, 1] == 0).all()
    spine = np.diff(m.spines)
    assert (spine[m.kind == 4] == 2).all()
    # There and back along the way, each of whose steps is cut into one to four.
    pieces = ((np.diff(m.offsets)[m.kind == 3] + 1) / 2 - 1) / (spine[m.kind == 3] - 1)
    assert set(np.unique(pieces)) <= {1.0, 2.0, 3.0, 4.0}

"""The scroll is endless and addressable: any window, in any order, in any process, holds the same elements."""

from __future__ import annotations

import hashlib
import subprocess
import sys
from itertools import pairwise

import numpy as np
import pytest
from scipy.spatial import cKDTree

from tambour.core.progress import Progress
from tambour.ink.brush.stroke import lattice
from tambour.ink.elements import hills
from tambour.ink.ground.codes import BOAT, HILL
from tambour.ink.ground.joined import roots
from tambour.ink.ground.marks import Marks
from tambour.ink.params import Ink
from tambour.ink.plan import scroll
from tambour.ink.plan.scenes import HIGH, border, distance, scene
from tambour.ink.plan.whole import Planned, Rules
from tambour.ink.plan.wholes import TILE, tile
from tambour.noise import key


def _make(**given: object) -> scroll.Scroll:
    return scroll.make(None, Ink(**given), Progress())


def _content(marks: Marks) -> dict[str, str]:
    """Whole's id → digest of all its marks with their parts."""
    root = roots(marks.elements.parent)[marks.element]
    found: dict[str, str] = {}
    for e in np.flatnonzero(marks.elements.parent < 0):
        k = np.flatnonzero(root == e)
        h = hashlib.sha256()
        for i in k:
            h.update(marks.coords[marks.offsets[i] : marks.offsets[i + 1]].tobytes())
        for column in (marks.kind, marks.fill, marks.stroke, marks.edge, marks.tint):
            h.update(column[k].tobytes())
        found[marks.elements.id[e]] = h.hexdigest()
    return found


def _order(marks: Marks) -> list[str]:
    return [name for name, above in zip(marks.elements.id, marks.elements.parent.tolist()) if above < 0]


def test_window_equals_its_tiles_drawn_alone_in_any_order() -> None:
    whole = _make(seed="a place", from_=0.0, span=4096.0).marks()
    content, order = _content(whole), _order(whole)
    alone: dict[str, str] = {}
    for k in np.random.default_rng(3).permutation(8).tolist():
        marks = _make(seed="a place", from_=float(k * TILE), span=float(TILE)).marks()
        mine = _content(marks)
        assert all(alone.setdefault(name, d) == d for name, d in mine.items())
        # Painter's order is the same in every window.
        assert [n for n in order if n in mine] == _order(marks)
    assert alone == content


@pytest.mark.slow
def test_another_process_draws_the_same() -> None:
    code = (
        "from tests.test_ink_scroll import _make, _content;"
        "import json; print(json.dumps(_content(_make(seed='p', from_=-700.0, span=900.0).marks())))"
    )
    out = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    import json

    assert json.loads(out.stdout) == _content(_make(seed="p", from_=-700.0, span=900.0).marks())


def _skylines(found: list[Planned]) -> np.ndarray:
    """(H, 64) the skylines of planned hills, each scaled to 1."""
    made = []
    for p in found:
        rng = np.array([key(*p.stream), 0], np.uint64)
        grid = np.empty((hills.LAYERS, hills.COLUMNS, 2))
        hills.ridge(lattice(rng), rng, grid, p.how[0], p.how[1], p.how[2], p.how[3])
        made.append(-grid[0, :, 1] / p.how[0])
    return np.array(made)


def _nearest(lines: np.ndarray) -> np.ndarray:
    """(H,) how far the nearest other skyline lies, root mean square of heights."""
    return cKDTree(lines).query(lines, 2)[0][:, 1] / np.sqrt(lines.shape[1])


@pytest.mark.slow
def test_no_skyline_recurs_in_a_hundred_thousand_units() -> None:
    found = [p for k in range(200) for p in tile(Rules("endless"), k) if p.kind == HILL]
    assert len(found) > 500
    for unlike in ({p.id for p in found}, {p.stream for p in found}, {p.how for p in found}):
        assert len(unlike) == len(found)
    # As unlike as hills of one scroll and of another, whose seeds have nothing in common: twins would lie at 0.
    other = [p for k in range(200) for p in tile(Rules("elsewhere"), k) if p.kind == HILL]
    mine, theirs = _nearest(_skylines(found)), _nearest(_skylines(other))
    assert mine.min() > 0.005 and theirs.min() > 0.005
    assert _nearest(np.concatenate([_skylines(found), _skylines(other)])).min() > 0.004


def test_a_whole_stands_in_one_tile_only() -> None:
    rules = Rules("endless")
    for m in range(-6, 6):
        for p in scene(rules, m):
            k = int(p.x // TILE)
            assert sum(p in tile(rules, j) for j in range(k - 2, k + 3)) == 1


@pytest.mark.slow
def test_scenes_are_never_of_their_neighbours_kind_and_follow_one_another() -> None:
    for seed in range(20):
        rules = Rules(str(seed))
        kinds = [distance(rules, m) for m in range(-40, 40)]
        assert all(a != b for a, b in pairwise(kinds))
        assert set(kinds) == {0, 1, 2}
        long = np.diff([border(rules, m) for m in range(-40, 40)])
        assert (long >= 1500).all() and (long <= 3000).all()
        assert len({p.how[4] for m in range(-40, 40) for p in scene(rules, m) if p.kind == HILL}) == 2


def test_the_host_stands_over_its_guests_and_the_near_is_darker() -> None:
    for seed in range(20):
        rules = Rules(str(seed))
        for m in range(-9, 9):
            peaks = sorted((p.how[0] for p in scene(rules, m) if p.kind == HILL), reverse=True)
            if distance(rules, m) == HIGH:
                assert peaks[0] >= 1.5 * peaks[1]
        near = np.array([(p.y, p.ink) for m in range(-9, 9) for p in scene(rules, m) if p.kind == HILL])
        assert (np.diff(near[np.argsort(near[:, 0]), 1]) >= 0).all()


def test_reading_from_the_left_mirrors_the_order() -> None:
    # The bank that closes a high scene lies at its end: on the left when one reads from the right.
    rtl, ltr = Rules("way"), Rules("way", reading="ltr")
    for m in range(-9, 9):
        a, b = border(rtl, m), border(rtl, m + 1)
        for p, q in zip(scene(rtl, m), scene(ltr, m)):
            if p.kind == q.kind == BOAT:
                assert p.x - a == pytest.approx(b - q.x)


def test_streamed_is_whole() -> None:
    made = _make(seed="stream", span=1500.0)
    parts = list(scroll.streamed(made))
    whole = scroll.whole(made)
    assert sum(len(p) for p in parts) == len(whole) == made.polygons
    assert [i for p in parts for i in p.groups.ids] == list(whole.groups.ids)


def test_the_plan_holds_what_the_window_shows() -> None:
    made = _make(seed="plan", from_=900.0, span=700.0)
    assert [p.id for p in made.planned] == _order(made.marks())


@pytest.mark.slow
def test_people_have_a_reason() -> None:
    """Boats, huts, hamlets and bridges are where people are: about the original's 1.1 in a thousand units."""
    made = [_make(seed=str(seed), from_=0.0, span=20_000.0).elements for seed in range(3)]
    people = sum(e.get("figure", 0) for e in made) / 60
    assert 0.8 < people < 2.5
    assert all(e.get("hamlet", 0) >= 3 and e.get("boat", 0) >= 5 for e in made)

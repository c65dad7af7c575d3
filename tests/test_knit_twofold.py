"""Two pictures on one cloth: rows against every row there is, the laws by counting, the piece through its files."""

import itertools

import numpy as np
import pytest
from PIL import Image

from tambour.core.chart import Chart
from tambour.core.errors import LawError, TambourError
from tambour.core.palette import Palette
from tambour.core.picture import Picture
from tambour.core.progress import Progress
from tambour.knit import CRAFT
from tambour.knit.hands.jacquard import back_cells
from tambour.knit.machines.limits import check
from tambour.knit.params import KnitParams
from tambour.knit.solve import faces, twofold


def lawful(row, yarns, use, cross):
    """Both laws, window by window, as they are written."""
    row, n = list(row), len(row)
    return all(len(set(row[t : t + use])) == yarns for t in range(n - use + 1)) and all(
        any({i % 2 for i in range(t, t + cross) if row[i] == k} == {0, 1} for k in range(yarns))
        for t in range(n - cross + 1)
    )


def test_rows_are_the_best_of_all_rows():
    rng = np.random.default_rng(1)
    proven = tried = 0
    for trial in range(70):
        yarns = int(rng.integers(2, 4))
        n = int(rng.integers(1, 9 if yarns == 3 else 13))
        use, cross = yarns + int(rng.integers(0, 4)), int(rng.integers(4, 9))
        cost = rng.random((n, yarns))
        if trial % 2:  # one yarn wants to stay in front, one behind: the law of crossing bites
            cost[::2, 0] += 0.9
            cost[1::2, 1] += 0.9
        every = [r for r in itertools.product(range(yarns), repeat=n) if lawful(r, yarns, use, cross)]
        room = twofold.Room.of(n, yarns, use, cross)
        if not every:
            with pytest.raises(TambourError, match="no row was found"):
                twofold.solve(cost, room)
            continue
        row, sure = twofold.solve(cost, room)
        best = min(cost[np.arange(n), list(r)].sum() for r in every)
        assert lawful(row, yarns, use, cross), trial
        found = cost[np.arange(n), row].sum()
        assert found == pytest.approx(best, abs=1e-4) if sure else found >= best - 1e-4
        proven, tried = proven + sure, tried + 1
    assert proven >= 0.9 * tried > 30


def best_by_every_state(cost, use, cross):
    """The least cost of a lawful row, by all states there are: last uses of the yarns, and where the last crossing begins."""
    n, yarns = cost.shape
    states = {((-1,) * yarns, -1): 0.0}
    for t in range(n):
        after = {}
        for (last, pair), paid in states.items():
            for k in range(yarns):
                begun = max(pair, last[k]) if last[k] >= 0 and (t - last[k]) % 2 else pair
                now = (*last[:k], t, *last[k + 1 :])
                if min(now) >= t - use + 1 - (t < use - 1) and (t < cross - 1 or begun > t - cross):
                    after[now, begun] = min(after.get((now, begun), np.inf), paid + cost[t, k])
        states = after
    return min(states.values())


@pytest.mark.parametrize(
    "yarns, use, cross, n", [(2, 4, 9, 60), (3, 4, 7, 60), (3, 5, 8, 40), (4, 5, 9, 30), (4, 6, 6, 24)]
)
def test_long_rows_with_many_windows_open_are_the_best_by_every_state(yarns, use, cross, n):
    rng = np.random.default_rng(use)
    room = twofold.Room.of(n, yarns, use, cross)  # kept from row to row: what a row leaves there is not the next one's
    for faces_apart in (0.0, 0.6, 3.0):
        cost = rng.random((n, yarns))
        cost[::2, : yarns // 2] += faces_apart
        cost[1::2, yarns // 2 :] += faces_apart
        row, sure = twofold.solve(cost, room)
        assert lawful(row, yarns, use, cross) and sure
        assert cost[np.arange(n), row].sum() == pytest.approx(best_by_every_state(cost, use, cross), abs=1e-3)


@pytest.mark.slow
def test_any_number_of_yarns_has_a_room():
    for yarns in range(1, 9):
        use = min(yarns + 4, twofold.widest(yarns))
        row, sure = twofold.solve(np.random.default_rng(yarns).random((40, yarns)), twofold.Room.of(40, yarns, use, 24))
        assert lawful(row, yarns, use, 24) and sure


def photo(rows, stitches, seed):
    small = np.random.default_rng(seed).integers(0, 256, (7, 7, 3), dtype=np.uint8)
    return np.asarray(Image.fromarray(small).resize((stitches, rows), Image.Resampling.BICUBIC))


def opaque(rgb):
    return Picture(np.dstack([rgb, np.full(rgb.shape[:2], 255, np.uint8)]))


def made(**params):
    asked = KnitParams(stitches=24, behind=opaque(photo(90, 100, 2)), yarns=3, **params)
    return CRAFT.make(opaque(photo(90, 100, 1)), asked, Progress())


def test_two_pictures_keep_both_laws_and_go_through_files(tmp_path):
    piece = made(gauge="24x30")
    chart = piece.chart
    assert (chart.technique, chart.backing) == ("jacquard", "picture") and (back_cells(chart) == chart.behind).all()
    line = np.stack([chart.cells, chart.behind], 2).reshape(len(chart.cells), -1)
    assert all(lawful(row, 3, 7, 24) for row in line.tolist())
    assert faces.laws(line, 3, 7, 24) == (0, 0) and piece.figures["rows_proven"] > 0
    for fault in (slice(0, 5), slice(0, 24, 2)):
        broken = line.copy()
        broken[3, fault] = 0
        assert lawful(broken[3].tolist(), 3, 7, 24) == (faces.laws(broken[3:4], 3, 7, 24) == (0, 0))
    assert Chart.of(chart.plain()).plain() == chart.plain()
    assert "behind" not in Chart(chart.cells, chart.palette, technique="jacquard").plain()


def test_a_two_faced_piece_can_be_seen_saved_and_opened_again():
    piece = made(gauge="24x30")
    for name in ("live", "steps", "written", "back", "fabric", "pattern", "separated", "stitches", "project"):
        assert CRAFT.views[name].make(piece) is not None
    assert CRAFT.facts(piece)["violations"] == 0
    again = CRAFT.make(Chart.of(piece.chart.plain()), KnitParams(), Progress())
    assert again.chart.plain() == piece.chart.plain()
    assert (CRAFT.views["live"].make(again).arrays["pairs"] == [0, 1, 2]).all()
    stitch = CRAFT.changes["stitch"]
    with pytest.raises(TambourError, match="hold each other"):
        stitch.after(piece, [stitch.params(row=3, stitch=4, yarn="1")], Progress())


def test_each_face_shows_its_picture_from_its_own_side():
    dark, light = np.zeros((40, 40, 3), np.uint8), np.full((40, 40, 3), 255, np.uint8)
    dark[:, :20] = 255  # front: light on the left; behind: light on the left as seen from there
    asked = KnitParams(stitches=30, technique="jacquard", colors=("#000000", "#ffffff"), behind=opaque(dark))
    chart = CRAFT.make(opaque(light), asked, Progress()).chart
    assert chart.cells.mean() > 0.6
    assert chart.behind[:, 15:].mean() > 0.65 > 0.35 > chart.behind[:, :15].mean()  # mirrored on the needles


def test_a_needle_of_either_bed_knits_its_own_yarn_in_knitout():
    from tambour.knit.machines.knitout import told

    piece = made(machine="kniterate")
    text = told(piece.chart, "kniterate", None).text
    rows = text.split(";row ")[1:]
    for r in (0, 7):
        knits = [line.split() for line in rows[r].split("\n") if line.startswith("knit")]
        for bed, cells in (("f", piece.chart.cells), ("b", piece.chart.behind)):
            found = {int(k[2][1:]): int(k[3]) - 1 for k in knits if k[2][0] == bed}
            assert [found[c] for c in range(24)] == cells[r].tolist()


def test_what_cannot_be_is_said():
    with pytest.raises(TambourError, match="cannot all be used in 2 stitches"):
        made(use_within=2)
    with pytest.raises(TambourError, match="more than can be solved exactly"):
        twofold.Room.of(40, 7, 17, 24)
    with pytest.raises(ValueError, match="jacquard"):
        made(technique="intarsia")
    with pytest.raises(LawError, match="behind"):
        Chart(np.zeros((2, 2), np.uint8), Palette(np.zeros((1, 3), np.uint8)), technique="jacquard", backing="picture")
    assert "two beds" in str(check(made().chart, "kh930-ayab")[0])

"""Intarsia and jacquard: areas solved exactly row by row, yarns as a person would choose them, bobbins, what machines are told."""

from __future__ import annotations

from itertools import groupby, product

import numpy as np
import pytest

from tambour import files
from tambour.core.chart import Chart, Gauge
from tambour.core.errors import TambourError
from tambour.core.palette import Palette
from tambour.core.picture import Picture
from tambour.core.progress import Progress
from tambour.knit import CRAFT
from tambour.knit.hands.bobbins import ENDS, bobbins, most
from tambour.knit.hands.working import catches, crossed, floats
from tambour.knit.hands.yarn import amounts
from tambour.knit.machines.limits import check, end_needles, hookups, separated, steps
from tambour.knit.params import KnitParams
from tambour.knit.picture import shades, wools
from tambour.knit.solve import areas
from tambour.knit.solve.edit import resolve

NONE = np.zeros((0, 0), np.bool_)
FIVE = Palette(np.array([[20, 20, 20], [190, 40, 40], [60, 120, 60], [210, 180, 130], [245, 240, 230]], np.uint8))


def picture(rgb):
    return Picture(np.dstack([rgb, np.full(rgb.shape[:2], 255, np.uint8)]))


def barn(rows=60, stitches=50):
    """A red barn with a dark door on grass, a pale sky behind it: four colours, hard edges."""
    rgb = np.zeros((rows, stitches, 3), np.uint8)
    rgb[:35], rgb[35:] = FIVE.rgb[4], FIVE.rgb[2]
    rgb[15:48, 10:40] = FIVE.rgb[1]
    rgb[30:48, 20:29] = FIVE.rgb[0]
    return rgb


def grained(rgb, amount=9):
    noise = np.random.default_rng(3).normal(0, amount, (*rgb.shape[:2], 1))
    return np.clip(rgb + noise, 0, 255).astype(np.uint8)


def made(rgb, **params):
    return CRAFT.make(picture(rgb), KnitParams(**params), Progress())


def widths(row):
    return [len(list(run)) for _, run in groupby(row)]


def cost_of(row, cost, gate):
    borders = sum(gate[i] for i in range(1, len(row)) if row[i] != row[i - 1])
    return sum(cost[i, c] for i, c in enumerate(row)) + borders


@pytest.mark.parametrize("least", [1, 2, 3, 4])
def test_a_row_is_the_best_of_all_whose_areas_are_wide_enough(least):
    """Brute force over every row of three yarns."""
    rng = np.random.default_rng(least)
    for n in (1, 2, 3, 5, 8):
        cost = rng.random((1, n, 3)).astype(np.float32)
        gate = (rng.random((1, n)) / 2).astype(np.float32)
        cells = np.zeros((1, n), np.uint8)
        areas.sweep(cost, gate, gate, least, NONE, cells, 0)
        rows = [r for r in product(range(3), repeat=n) if min(widths(r)) >= min(least, n)]
        best = min(cost_of(r, cost[0], gate[0]) for r in rows)
        assert tuple(cells[0]) in rows and cost_of(cells[0], cost[0], gate[0]) == pytest.approx(best, rel=1e-5)


def test_sweeps_never_raise_the_energy():
    rng = np.random.default_rng(7)
    cost = rng.random((14, 15, 4)).astype(np.float32)
    across, up = (rng.random((14, 15)).astype(np.float32) / 3 for _ in range(2))
    cells = np.ascontiguousarray(cost.argmin(2), np.uint8)
    areas.sweep(cost, across, up, 3, NONE, cells, 0)  # lawful from here on

    def energy():
        rows = sum(cost_of(cells[y], cost[y], across[y]) for y in range(14))
        return rows + up[1:][cells[1:] != cells[:-1]].sum()

    before = energy()
    for turn in range(1, 6):
        areas.sweep(cost, across, up, 3, NONE, cells, turn)
        assert energy() <= before + 1e-4
        before = energy()
    assert all(min(widths(row)) >= 3 for row in cells.tolist())


def test_intarsia_has_areas_of_three_and_the_pictures_own_yarns():
    piece = made(barn(), technique="intarsia")
    assert {tuple(c) for c in piece.chart.palette.rgb.tolist()} == {tuple(c) for c in FIVE.rgb[[0, 1, 2, 4]].tolist()}
    assert (piece.chart.palette.rgb[piece.chart.cells[::-1]] == barn()).all()
    told = {**piece.figures, **CRAFT.facts(piece)}
    assert told["technique"] == "intarsia" and told["longest_float"] == 0 and told["catches"] == 0
    # By hand: grass, of which one side takes a new bobbin; the barn left and right of its door; the door; two of sky.
    assert told["most_bobbins"] == 5 and told["bobbins"] == 7
    photo = made(grained(barn(), 25), technique="intarsia")
    assert len(photo.chart.palette) == 5
    assert all(min(widths(row)) >= 3 for row in photo.chart.cells.tolist())


def test_soft_edges_of_flat_art_are_no_yarns():
    """Two rows of mixed colour where areas meet, as any resampling leaves them."""
    rgb = barn()
    rgb[35] = (rgb[34].astype(int) + rgb[36]) // 2
    rgb[15] = (rgb[14].astype(int) + rgb[16]) // 2
    piece = made(rgb, technique="intarsia")
    assert len(piece.chart.palette) == 4
    assert len(shades.few(rgb, 8)) == 4


def test_yarns_are_few_and_far_apart():
    piece = made(grained(barn(), 12), technique="intarsia", yarns=4)
    far = [
        np.linalg.norm(a - b)
        for i, a in enumerate(wools.seen(piece.chart.palette.rgb))
        for b in wools.seen(piece.chart.palette.rgb)[:i]
    ]
    assert min(far) >= wools.APART
    near = [np.abs(piece.chart.palette.rgb.astype(int) - c).sum(1).min() for c in FIVE.rgb[[0, 1, 2, 4]].astype(int)]
    assert max(near) < 60  # each colour of the barn has its yarn
    card = made(barn(), technique="intarsia", yarns=4, card="wool")
    assert set(card.chart.palette.names) <= {name for name, _ in shades.CARDS["wool"]}


def test_bobbins_go_on_with_the_area_that_they_share_most_with():
    cells = np.array([[0] * 12, [0] * 4 + [1] * 4 + [0] * 4, [0] * 3 + [1] * 6 + [0] * 3, [0] * 12], np.uint8)
    chart = Chart(cells, FIVE, technique="intarsia")
    found = bobbins(chart)
    # The ground is parted by the motif: one side goes on, the other takes a new bobbin; above, one of them goes on.
    assert sorted((b.color, b.first, b.last, b.stitches) for b in found) == [(0, 0, 3, 31), (0, 1, 2, 7), (1, 1, 2, 10)]
    assert sum(b.stitches for b in found) == cells.size and most(chart) == (3, 1)


def test_jacquard_takes_any_yarns_in_a_row_and_both_backs():
    for back, times in (("birdseye", 1), ("stripes", 4)):
        piece = made(barn(), technique="jacquard", back=back)
        assert piece.chart.backing == back and len(piece.chart.palette) == 4
        flat = amounts(Chart(piece.chart.cells, piece.chart.palette, technique="intarsia"), "dk")
        both = amounts(piece.chart, "dk")
        plain = sum(a.metres for a in flat) - 7 * ENDS
        hidden = sum(a.metres for a in both) / plain - 1
        assert hidden == pytest.approx(times)


def test_tones_of_jacquard_are_true_from_afar():
    rgb = np.repeat(np.linspace(20, 235, 200)[None, :, None], 160, axis=0).repeat(3, axis=2).astype(np.uint8)
    piece = made(rgb, technique="jacquard", style="tonal", colors=("#000000", "#ffffff"), stitches=200)
    from tambour.color import linear

    for part in np.array_split(np.arange(200), 5):
        seen = piece.chart.cells[:, part].mean()
        assert seen == pytest.approx(float(linear(rgb[0, part, 0] / 255).mean()), abs=0.03)


def test_what_is_for_stranded_knitting_is_refused():
    for params, words in (
        ({"round": True}, "flat"),
        ({"floats": "caught"}, "no floats"),
        ({"method": "gsat"}, "stranded"),
        ({"style": "plain"}, "graphic"),
    ):
        with pytest.raises(ValueError, match=words):
            KnitParams(technique="intarsia", **params)


def test_a_stitch_set_by_hand_is_that_stitch_alone_and_what_one_does_about_it_is_told(tmp_path):
    piece = made(barn(), technique="intarsia")
    changed = CRAFT.changes["stitch"]
    codes = ["#{:02x}{:02x}{:02x}".format(*c) for c in piece.chart.palette.rgb.tolist()]
    told = Progress()
    alone = changed.after(piece, [changed.params(row=50, stitch=25, yarn=codes[0])], told)
    assert np.argwhere(alone.chart.cells != piece.chart.cells).tolist() == [[49, 25]]
    assert alone.figures["embroidered"] == 1 and alone.figures["violations"] == 0
    assert "one stitch stands alone" in str(told.warnings[0]) and "duplicate stitch" in str(told.warnings[0])
    three = [changed.params(row=50, stitch=s, yarn=codes[k]) for s, k in ((24, 0), (25, 1), (26, 0))]
    assert changed.after(piece, three, Progress()).chart.cells[49, 24:27].tolist() == [0, 1, 0]
    area = [changed.params(row=50, stitch=s, yarn=codes[0]) for s in (24, 25, 26)]
    quiet = Progress()
    assert changed.after(alone, area, quiet).figures["embroidered"] == 0 and not quiet.warnings

    # It stays as drawn when rows come in, and when the chart goes to a file and comes back.
    rows = CRAFT.changes["rows"]
    more = rows.after(alone, [rows.params(at=10, count=2)], Progress())
    assert (more.chart.cells == np.insert(alone.chart.cells, [9, 9], alone.chart.cells[9], 0)).all()
    files.write(alone.chart, tmp_path / "chart.json")
    back = CRAFT.make(files.read(tmp_path / "chart.json", ("Chart",)), KnitParams(), Progress())
    assert (back.chart.cells == alone.chart.cells).all() and back.figures["embroidered"] == 1


@pytest.mark.parametrize("suffix", [".json", ".png"])
def test_more_than_two_in_a_row_come_back_from_a_file(tmp_path, suffix):
    cells = np.random.default_rng(2).integers(0, 5, (8, 9)).astype(np.uint8)
    chart = Chart(cells, FIVE, technique="jacquard", backing="stripes", gauge=Gauge(20, 30))
    files.write(chart, tmp_path / f"chart{suffix}")
    back = files.read(tmp_path / f"chart{suffix}", ("Chart",))
    assert (back.cells == cells).all() and (back.technique, back.backing) == ("jacquard", "stripes")


def test_end_needles_are_known_to_the_solver():
    y, x = np.mgrid[:50, :60]
    rgb = np.where((np.hypot(y - 25, x - 30) < 18)[..., None], (20, 20, 60), (240, 240, 230)).astype(np.uint8)
    free, known = made(rgb), made(rgb, machine="kh930-ayab")
    assert end_needles(free.chart) > 40 and end_needles(known.chart) == 0
    assert known.figures["violations"] == 0
    assert "differ" not in " ".join(steps(known.chart, "kh930-ayab", True))


def test_a_full_bed_is_not_told_to_cast_on_more():
    cells = (np.arange(200)[None] + np.arange(30)[:, None]) % 3 == 0
    chart = Chart(cells.astype(np.uint8), FIVE)
    assert "198 stitches" in " ".join(steps(chart, "kh930-ayab", True))
    assert "Cast on one stitch more" in " ".join(
        steps(Chart(cells[:, :150].astype(np.uint8), FIVE), "kh930-ayab", True)
    )


def test_machines_take_as_many_yarns_as_they_have():
    cells = np.random.default_rng(5).integers(0, 5, (30, 40)).astype(np.uint8)
    five = Chart(cells, FIVE, technique="jacquard")
    assert not check(five, "kh930-ayab") and not check(five, "kniterate")
    assert "5 yarns" in str(check(five, "kh940-disk")[0])
    assert "laid in by hand" in str(check(Chart(cells, FIVE, technique="intarsia"), "kh930-ayab")[0])
    said = " ".join(steps(five, "kh930-ayab", True))
    assert "Ribber" in said and "5 colours" in said


def test_separated_rows_are_a_line_for_each_yarn():
    cells = np.array([[0, 1, 2, 1], [2, 2, 0, 0]], np.uint8)
    lines = separated(Chart(cells, FIVE, technique="jacquard"))
    texts = ["".join("#."[v] for v in row) for row in lines.cells.tolist()]
    assert texts == ["#...", ".#.#", "..#.", "..##", "....", "##.."]
    with pytest.raises(TambourError, match="double bed"):
        separated(Chart(cells[:1, :2], FIVE))


def test_floats_are_hooked_onto_needles_of_their_own_colour():
    """Every needle that the list names stands under the float, and knits its yarn in the next row unless it is starred."""
    rng = np.random.default_rng(8)
    cells = (rng.random((30, 60)) < 0.35).astype(np.uint8)
    cells[10:14, 20:45] = 0
    chart = Chart(cells, FIVE)
    limit = 4
    text = hookups(chart, limit, True, "trial").text
    assert "row 11:" in text
    same = np.ones(cells.shape, np.float32)
    same[:-1] = cells[1:] == cells[:-1]
    marks = catches(chart, limit, True, 20 * same)
    named = sum(line.count("L") + line.count("R") for line in text.splitlines() if line.startswith("row "))
    assert named == marks.sum() and text.count("*") - 1 == (marks & (same > 0)).sum()
    assert not (marks[1:] & marks[:-1]).any()
    long = floats(chart, True, limit)
    for row, start, length in zip(long.row.tolist(), long.start.tolist(), long.length.tolist()):
        at = np.flatnonzero(marks[row, crossed(chart, row, start, length)])
        assert np.diff([-1, *at, length]).max() - 1 <= limit


def test_a_stitch_by_hand_changes_no_other() -> None:
    """A row solved again from the picture brought back, 40 stitches away, small areas that had been given to their neighbours."""
    rng = np.random.default_rng(7)
    y, x = np.mgrid[:48, :60]
    light = 90 + 60 * np.sin(x / 9 + y / 17) + 40 * np.cos(y / 7) + rng.normal(0, 18, (48, 60))
    rgb = np.clip(light[..., None] * [1.0, 0.8, 0.6] + [0, 20, 60], 0, 255).astype(np.uint8)
    piece = made(rgb, technique="intarsia", yarns=4, style="graphic")
    cells = piece.chart.cells
    for r, at in [(5, 7), (17, 30), (24, 44), (33, 52), (41, 3)]:
        colour = (int(cells[r, at]) + 1) % len(piece.chart.palette)
        now = resolve(piece, [(r, at, colour)]).chart.cells
        rows, columns = np.nonzero(now != cells)
        assert now[r, at] == colour and (rows.tolist(), columns.tolist()) == ([r], [at])

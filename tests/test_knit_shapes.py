"""Motifs and shapes: arrangements, repeats, yokes, hats and mittens, sizes, and how they look worn."""

from __future__ import annotations

import numpy as np
import pytest

from tambour.core.chart import Chart, Gauge
from tambour.core.errors import TambourError
from tambour.core.palette import Palette
from tambour.core.picture import Picture
from tambour.core.progress import Progress
from tambour.knit import CRAFT
from tambour.knit.hands.sizes import table
from tambour.knit.params import KnitParams
from tambour.knit.picture import shapes
from tambour.knit.sheets.worn import SIDE, from_above

WOOL = Palette(np.array([[30, 40, 90], [240, 230, 210]], np.uint8))


def motif(rows=30, stitches=12, seed=4):
    light = np.random.default_rng(seed).random((rows, stitches)) < 0.7
    rgb = np.where(light[..., None], 255, 0).astype(np.uint8).repeat(3, axis=2)
    return Picture(np.dstack([rgb, np.full((rows, stitches), 255, np.uint8)]))


def made(**params):
    return CRAFT.make(motif(), KnitParams(**params), Progress())


def rings(chart):
    """Every round as a string of its stitches, twice round."""
    keep = np.ones(chart.shape, np.bool_) if chart.no_stitch is None else ~chart.no_stitch
    return ["".join(map(str, row[k].tolist())) * 2 for row, k in zip(chart.cells, keep)]


@pytest.mark.parametrize("how", ["mirror", "half-drop", "turn"])
def test_a_motif_stands_beside_itself_and_keeps_the_law_round_the_seam(how):
    piece = made(repeat="12", arrange=how, stitches=72, max_float="4", round=True)
    assert piece.repeat == (24, 0) and piece.chart.shape == (30, 72)
    assert (piece.chart.cells == np.tile(piece.chart.cells[:, :24], 3)).all()
    assert not any(c * 5 in row for row in rings(piece.chart) for c in "01" if len(set(row)) > 1)
    source = motif().rgba[::-1, :, 0] > 127
    other = {"mirror": source[:, ::-1], "half-drop": np.roll(source, 15, axis=0), "turn": source[::-1, ::-1]}[how]
    seen = piece.picture[..., 0] > 127
    assert (seen[:, :12] == source).all() and (seen[:, 12:24] == other).all()


def test_mirrored_charts_are_symmetric_where_the_law_lets_them():
    plain, whole = (made(repeat="12", arrange="mirror", max_float="4", method=m) for m in ("exact", "gsat"))
    same = (plain.chart.cells == plain.chart.cells[:, ::-1]).all(1)
    assert same.mean() > 0.9 and plain.figures["violations"] == 0
    assert whole.figures["violations"] == 0


def test_the_repeat_of_a_picture_is_found():
    tiled = Picture(np.tile(motif().rgba, (1, 5, 1)))
    piece = CRAFT.make(tiled, KnitParams(repeat="auto", stitches=60), Progress())
    assert piece.repeat == (12, 0) and piece.chart.shape == (30, 60)
    told = Progress()
    assert CRAFT.make(motif(), KnitParams(repeat="auto"), told).repeat == (12, 0)
    assert "no repeat" in str(told.warnings[0])


@pytest.mark.parametrize("shape", ["yoke", "hat", "mitten"])
@pytest.mark.parametrize("wide", [12, 13, 24])
def test_shapes_narrow_upwards_and_evenly(shape, wide):
    knit = shapes.TEMPLATES[shape](40, wide)
    count = knit.sum(1)
    assert count[0] == wide and (np.diff(count) <= 0).all() and 0 < count[-1] <= wide / 2.9
    middle = [np.abs((np.flatnonzero(row) - (wide - 1) / 2).mean()) for row in knit]
    assert max(middle) <= 0.51


def test_a_yoke_draws_its_picture_in_and_keeps_the_law():
    piece = made(repeat="12", arrange="mirror", shape="yoke", round=True, max_float="4", gauge="24x30", rows=30)
    assert (~piece.chart.no_stitch).sum(1).tolist()[::29] == [24, 8]
    assert piece.figures["violations"] == 0
    assert not any(c * 5 in row for row in rings(piece.chart) for c in "01" if len(set(row)) > 1)
    bars = np.zeros((10, 12, 3), np.uint8)
    bars[:, 6:] = 255
    drawn = shapes.drawn_in(bars, shapes.yoke(10, 12))
    assert (drawn[-1, 4:6] == 0).all() and (drawn[-1, 6:8] == 255).all()  # both halves are there, narrower
    with pytest.raises(ValueError, match="border"):
        KnitParams(shape="yoke", border=2)


def test_what_is_worn_is_knitted_in_the_round_unless_it_is_said_otherwise():
    assert KnitParams(shape="hat").round and KnitParams(shape="mitten").round
    for flat in ({"round": False}, {"technique": "intarsia"}, {"machine": "kh930-ayab"}, {"edges": "free"}):
        assert not KnitParams(shape="yoke", **flat).round
    assert not KnitParams(shape=motif()).round and not KnitParams().round


def test_a_hat_of_odd_proportions_and_yarns_that_are_nowhere_are_told():
    def told(**params):
        progress = Progress()
        CRAFT.make(motif(), KnitParams(repeat="12", max_float="4", **params), progress)
        return [w.message for w in progress.warnings]

    assert "this hat is 10.0 cm high, and 50.0 cm round" in told(shape="hat", stitches=120, gauge="24x30", rows=30)
    assert not told(shape="hat", stitches=120, gauge="24x30", rows=60)
    yarns = {"colors": ("#1e285a", "#f0e6d2", "#b5532a")}
    assert told(gauge="24x30", **yarns) == ["no stitch is of #b5532a"]


def test_sizes_are_whole_repeats_nearest_to_their_width():
    found = table(Gauge(24, 30), (24, 0))
    for rows in found.values():
        for _, cm, stitches, repeats in rows:
            assert stitches == 24 * repeats and (repeats == 2 or abs(stitches / 2.4 - cm) <= 5.0 + 1e-9)
    piece = made(repeat="12", gauge="24x30", stitches=24)
    assert CRAFT.facts(piece)["sizes"]["yoke"]["M"] == 288


@pytest.mark.slow
def test_a_yoke_from_above_has_its_rounds_in_order():
    """Three bands of colour become three rings; the neck stays open."""
    cells = np.repeat(np.array([0, 1, 0], np.uint8), 10)[:, None].repeat(24, axis=1)
    picture = from_above(Chart(cells, WOOL, gauge=Gauge(24, 30), circular=True), 1200.0, "dk", True)
    middle = picture.rgba[SIDE // 2, :, :3].astype(int).sum(1)
    outer = SIDE / 2.08
    inner = outer * (1 - 100 / 190.99)  # 30 rows of 3.33 mm of a radius of 1200 mm / 2 pi
    for share, dark in ((1 / 6, True), (1 / 2, False), (5 / 6, True)):
        at = int(SIDE / 2 + outer - share * (outer - inner))
        assert (np.median(middle[at - 8 : at + 8]) < 330) == dark
    assert picture.rgba[SIDE // 2, SIDE // 2, :3].tolist() == [231, 228, 222]
    with pytest.raises(TambourError, match="knitted round"):
        CRAFT.views["worn"].make(made())


def test_a_steek_is_a_check_about_the_beginning_of_the_round():
    for steek in (5, 6):
        piece = made(stitches=40, round=True, steek=steek, max_float="4", rows=30)
        cells, left = piece.chart.cells, steek // 2
        edge = np.concatenate([cells[:, 40 - (steek - left) :], cells[:, :left]], axis=1)
        assert edge.shape == (30, steek) and (np.diff(edge.astype(int), axis=1) != 0).all()
        assert (np.diff(edge.astype(int), axis=0) != 0).all() and piece.figures["violations"] == 0
        assert not any(c * 5 in row for row in rings(piece.chart) for c in "01")
        text = CRAFT.views["written"].make(piece).text
        assert f"the first {steek - left} and the last {left} stitches" in " ".join(text.split())
    with pytest.raises(ValueError, match="round"):
        KnitParams(steek=5)
    with pytest.raises(TambourError, match="none of 6 for the picture"):
        made(stitches=6, round=True, steek=6)


@pytest.mark.parametrize(("stitches", "wide"), [(30, 5), (40, 9), (48, 9), (60, 13)])
def test_a_mitten_has_a_thumb(stitches, wide):
    assert shapes.widest(stitches) == wide
    piece = made(stitches=stitches, rows=60, shape="mitten", round=True, max_float="4", gauge="26x32")
    assert piece.chart.shape == (60, stitches + wide) and piece.figures["violations"] == 0
    gusset = (~piece.chart.no_stitch)[:, stitches:]
    count = gusset.sum(1)
    first, last = np.flatnonzero(count)[[0, -1]]
    assert (first, last) == (7, 24) and count[first] == 1 and count[last] == wide
    assert set(np.diff(count[first : last + 1]).tolist()) <= {0, 2}
    text = " ".join(CRAFT.views["written"].make(piece).text.split())
    assert (
        f"first {wide} stitches of the chart, rounds 8 to 25" in text and f"put its {wide} stitches on a thread" in text
    )
    bare = made(stitches=stitches, rows=60, shape="mitten", round=True, max_float="4", gauge="26x32", gusset=0)
    assert bare.chart.shape == (60, stitches) and "Thumb" not in CRAFT.views["written"].make(bare).text
    tiled = made(stitches=48, rows=60, repeat="12", shape="mitten", round=True, max_float="4")
    assert tiled.repeat is None and (tiled.picture[5, :12] == tiled.picture[5, 36:48]).all()


@pytest.mark.slow
def test_a_motif_is_shown_on_hat_mitten_and_yoke():
    """Upright bars of the motif stay upright on the hat and the mitten, and become rays of the yoke."""
    bars = np.zeros((20, 12), np.uint8)
    bars[:, 6:] = 1
    chart = Chart(bars, WOOL, gauge=Gauge(24, 30))
    from tambour.knit.sheets.tiled import garments

    seen = garments(chart, 12, "dk").rgba[..., :3].astype(int).sum(2)
    assert seen.shape == (800, garments(chart, None, "dk").rgba.shape[1])

    def changes(line):
        line = line[np.abs(line - 690) > 3]  # the ground is 231 + 228 + 222 = 681 … off it: the cloth
        return int((np.abs(np.diff((line > 330).astype(int)))).sum())

    hat, yoke = seen[500, :560], seen[:, -800:]
    assert changes(hat) >= 8
    at = np.linspace(0, 2 * np.pi, 4000)
    ring = yoke[(400 + 330 * np.sin(at)).astype(int), (400 + 330 * np.cos(at)).astype(int)]
    assert 2 * 20 <= changes(ring) <= 2 * 30  # about 24 repeats of 12 round a yoke of 120 cm

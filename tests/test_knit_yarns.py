"""More than two yarns: pairs, switching, shade cards and stashes."""

from __future__ import annotations

from itertools import combinations, pairwise, product

import numpy as np
import pytest
from scipy.ndimage import zoom

from tambour.core.errors import TambourError, Text
from tambour.core.picture import Picture
from tambour.core.progress import Progress
from tambour.knit import CRAFT
from tambour.knit.params import KnitParams
from tambour.knit.picture import shades
from tambour.knit.solve import blocks, percept, yarns
from tambour.knit.solve.make import make
from tambour.knit.task import Task


def flag(rows=36, stitches=48):
    """Bands of sky, grass and a barn: a picture that no two yarns can show."""
    rgb = np.zeros((rows, stitches, 3), np.uint8)
    rgb[: rows // 2] = (120, 170, 230)
    rgb[rows // 2 :] = (60, 120, 40)
    rgb[rows // 4 : 3 * rows // 4, stitches // 3 : 2 * stitches // 3] = (170, 30, 30)
    rgb[: rows // 6, -8:] = (250, 240, 160)
    return Picture(np.dstack([rgb, np.full((rows, stitches), 255, np.uint8)]))


def made(**params):
    told = Progress()
    return make(flag(), KnitParams(**params), told), told


def rows_of(piece):
    return [sorted(set(row.tolist())) for row in piece.chart.cells]


def longest(cells):
    change = np.diff(np.pad(cells.astype(int), ((0, 0), (1, 1)), constant_values=-1), axis=1) != 0
    return max(int(np.diff(np.flatnonzero(row)).max()) for row in change)


@pytest.mark.parametrize("method", ["perceptual", "exact", "none", "gsat"])
def test_two_yarns_in_a_row_and_no_long_float(method):
    piece, _ = made(yarns=4, method=method)
    assert len(piece.chart.palette) == 4
    assert all(len(row) <= 2 for row in rows_of(piece))
    if method != "none":
        assert longest(piece.chart.cells) <= 4 and piece.figures["violations"] == 0
    else:
        assert (piece.chart.cells == piece.start).all()


def test_more_yarns_show_more():
    two, four = made(yarns=3)[0].figures["colour_psnr"], made(yarns=5)[0].figures["colour_psnr"]
    assert four > two


def test_switching_costs_and_limits():
    changes = [made(yarns=4, switch=s)[0].figures["switches"] for s in (0, 1000)]
    assert changes[1] <= changes[0]
    for most in (0, 1, 3):
        piece, _ = made(yarns=4, max_switches=most)
        pairs = piece.state.pairs
        assert (pairs[1:] != pairs[:-1]).any(1).sum() <= most == piece.params.max_switches


def test_in_the_round_and_with_a_mask():
    mask = np.full((36, 48, 4), 255, np.uint8)
    mask[:12, :16] = 0
    piece, _ = made(yarns=3, round=True, shape=Picture(mask))
    assert piece.figures["violations"] == 0 and piece.chart.no_stitch is not None and piece.chart.circular


def test_the_row_of_each_pair_is_the_best_there_is():
    """pair_rows against brute force over all rows of all pairs, energy from its definition."""
    rng = np.random.default_rng(4)
    for _ in range(12):
        rows, stitches, limit = 3, int(rng.integers(4, 9)), int(rng.integers(1, 4))
        aim = rng.random((rows, stitches, 3)).astype(np.float32)
        space = rng.random((3, 3)).astype(np.float32)
        possible = np.array(list(combinations(range(3), 2)), np.uint8)
        error = (rng.random((rows, stitches, 3)) - 0.5).astype(np.float32)
        eye = percept.eye(limit, scales=((1.0, 1.0), (0.6, 0.2)), radius=2)
        error[1] = 0
        task = Task(aim[..., 0].copy(), np.zeros((rows, stitches), np.uint8), limit)
        costs = np.zeros((rows, len(possible)))
        yarns.table_of(task, aim, space, possible, eye, error, costs)
        base = yarns.energy(error, eye)
        for k, (a, b) in enumerate(possible):
            least = np.inf
            for bits in product((0, 1), repeat=stitches):
                row = np.array(bits)
                if longest(row[None]) > limit:
                    continue
                trial = error.copy()
                trial[1] = space[[a, b]][row] - aim[1]
                least = min(least, yarns.energy(trial, eye) - base)
            assert costs[1, k] == pytest.approx(least, abs=2e-4)


def test_the_pairs_of_rows_are_the_best_for_their_costs():
    rng = np.random.default_rng(5)
    for _ in range(30):
        costs = rng.random((5, 3))
        price = float(rng.random()) / 2
        most = [None, 0, 1, 2][rng.integers(4)]

        def cost(path, costs=costs, price=price):
            return sum(costs[y, k] for y, k in enumerate(path)) + price * sum(a != b for a, b in pairwise(path))

        paths = [p for p in product(range(3), repeat=5) if most is None or sum(a != b for a, b in pairwise(p)) <= most]
        found = blocks.over_rows(costs, price, most)
        assert cost(found.tolist()) == pytest.approx(min(map(cost, paths)))


def test_a_stash_is_read_and_its_mistakes_are_named():
    text = Text(
        "name, colour, metres, grams\nred, #aa2020, 120, 50\nsky,#88bbee,,\ngrass,#3c7828,80.5,25\n", "stash.csv"
    )
    red, sky, grass = shades.stash(text)
    assert red == shades.Shade("red", (170, 32, 32), 120, 50) and sky.metres is None and grass.grams == 25
    wrong = Text("name,colour,metres\nred,crimson,1\nblue,#0000ff,much\n", "stash.csv")
    with pytest.raises(TambourError) as error:
        shades.stash(wrong)
    assert "stash.csv:2:1: 'crimson' is not a colour" in str(error.value) and "'much' is not a number" in str(
        error.value
    )
    with pytest.raises(TambourError, match="first line must name the columns"):
        shades.stash(Text("red,#ff0000\n", "s"))
    piece, _ = made(yarns=3, stash=text)
    assert sorted(piece.chart.palette.names) == ["grass", "red", "sky"]
    with pytest.raises(TambourError, match="4 yarns are wanted, there are 3"):
        made(yarns=4, stash=text)
    told = Progress()
    short = Text("name;colour;metres\nred;#aa2020;3\nsky;#88bbee;\ngrass;#3c7828;4000\n", "stash.csv")
    CRAFT.make(flag(), KnitParams(yarns=3, stash=short, gauge="24x30"), told)
    assert [str(w) for w in told.warnings if "run out" in str(w)] and "red will run out" in str(told.warnings[-1])


def test_cards_colours_and_contrast():
    piece, _ = made(yarns=5, card="wool")
    names = {n for n, _ in shades.CARDS["wool"]}
    assert set(piece.chart.palette.names) <= names
    two, told = made(yarns=2, colors=("#808080", "#8a8a8a"))
    assert len(told.warnings) == 1 and "faint" in str(told.warnings[0])
    assert two.chart.palette.rgb.tolist() == [[128] * 3, [138] * 3]
    with pytest.raises(TambourError, match="none can share a row"):
        made(yarns=3, colors=("#808080", "#828282", "#848484"))
    two, _ = made(yarns=2, card="natural")
    assert shades.contrast(*(tuple(c) for c in two.chart.palette.rgb.tolist())) > 8
    assert shades.contrast((0, 0, 0), (255, 255, 255)) == pytest.approx(21)


def test_what_two_yarns_alone_can_do_is_said():
    with pytest.raises(TambourError, match="--border: this is for two yarns"):
        made(yarns=3, border=2)


def test_flat_art_keeps_its_pairs_over_blocks_of_rows():
    """A red barn under a pale sky, on grass: two changes of pair, at the barn's top and foot, and areas as they are."""
    rgb = np.zeros((60, 48, 3), np.uint8)
    rgb[:40], rgb[40:] = (235, 235, 240), (40, 90, 40)
    rgb[12:40, 14:34] = (170, 30, 30)
    source = Picture(np.dstack([rgb, np.full((60, 48), 255, np.uint8)]))
    piece = make(source, KnitParams(yarns=3, max_float="5"), Progress())
    assert piece.figures["style"] == "graphic" and piece.figures["switches"] <= 2
    assert longest(piece.chart.cells) <= 5 and all(len(row) <= 2 for row in rows_of(piece))
    shown = piece.chart.palette.rgb[piece.start[::-1]]
    assert (shown == rgb).all()  # before lice, every stitch has its own colour
    lice = piece.chart.cells != piece.start
    assert 0 < lice.mean() < 0.2


def test_a_photograph_that_more_than_two_yarns_cut_into_bands_is_told():
    rgb = np.asarray(zoom(np.random.default_rng(4).integers(0, 256, (6, 5, 3)), (14, 14, 1), order=1), np.uint8)
    rgb = np.clip(rgb + np.random.default_rng(5).normal(0, 4, rgb.shape), 0, 255).astype(np.uint8)
    source = Picture(np.dstack([rgb, np.full(rgb.shape[:2], 255, np.uint8)]))
    for count in (2, 3):
        told = Progress()
        piece = make(source, KnitParams(stitches=60, yarns=count), told)
        said = [w for w in told.warnings if "across the photograph" in w.message]
        assert piece.figures["style"] == "graphic" and len(said) == (count == 3 and piece.figures["switches"] > 0)
    assert piece.figures["switches"] > 0 and "{--yarns} 2" in said[0].hint
    assert not [w for w in made(yarns=3)[1].warnings if "across the photograph" in w.message]  # flat art

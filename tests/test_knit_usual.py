"""What a picture becomes where nothing was said: its width, its technique, its colours."""

import io

import numpy as np
import pytest
from PIL import Image, ImageDraw

from tambour.core.picture import Picture
from tambour.core.progress import Progress
from tambour.knit import CRAFT
from tambour.knit.params import KnitParams
from tambour.knit.picture import usual
from tambour.knit.picture.layout import lay


def picture(rgb):
    return Picture(np.dstack([rgb, np.full(rgb.shape[:2], 255, np.uint8)]))


def photo(rows=400, stitches=400, seed=2):
    rng = np.random.default_rng(seed)
    small = rng.integers(0, 256, (9, 9, 3), dtype=np.uint8)
    return np.asarray(Image.fromarray(small).resize((stitches, rows), Image.Resampling.BICUBIC))


def sprite(rows, columns, seed):
    """Pixels by chance in five colours, in lumps, as sprites are."""
    rng = np.random.default_rng(seed)
    colours = np.array([(250, 250, 245), (30, 30, 40), (200, 40, 50), (60, 120, 200), (240, 200, 60)], np.uint8)
    return colours[rng.choice(5, (rows, columns), p=(0.4, 0.2, 0.15, 0.15, 0.1))]


def drawn(size, smooth=1):
    image = Image.new("RGB", (size * smooth, size * smooth), (255, 255, 255))
    draw = ImageDraw.Draw(image)
    s = size * smooth / 400
    draw.ellipse([60 * s, 50 * s, 330 * s, 340 * s], fill=(200, 30, 40))
    draw.polygon([(20 * s, 380 * s), (200 * s, 120 * s), (370 * s, 390 * s)], fill=(200, 30, 40))
    return np.asarray(image.resize((size, size), Image.Resampling.BOX))


def laid(rgb, **params):
    told = Progress()
    return lay(picture(rgb), KnitParams(**params), told), [str(p) for p in told.warnings]


@pytest.mark.parametrize(
    ("params", "stitches"),
    [
        ({}, 80),
        ({"gauge": "30x40"}, 100),
        ({"gauge": "18x24"}, 60),
        ({"use": "child"}, 60),
        ({"use": "mitten"}, 48),
        ({"use": "blanket", "gauge": "20x28"}, 150),
    ],
)
def test_a_dropped_photograph_is_as_wide_as_its_use_wants_and_that_is_told_once(params, stitches):
    found, told = laid(photo(), **params)
    gauge = [float(n) for n in params.get("gauge", "1x1").split("x")]
    assert found.picture.shape[:2] == (round(stitches * gauge[1] / gauge[0]), stitches)
    assert len(told) == 1 and f"{stitches} stitches wide" in told[0] and "--stitches" in told[0]


def test_tall_pictures_are_narrower_and_small_ones_are_not_enlarged():
    assert laid(photo(900, 300))[0].picture.shape[:2] == (120, 40)
    small, told = laid(photo(60, 50))
    assert small.picture.shape[:2] == (60, 50) and told == []
    assert laid(photo(60, 50), gauge="24x32")[0].picture.shape[:2] == (80, 50)
    assert laid(photo(), stitches=400)[0].picture.shape[:2] == (400, 400)
    assert laid(drawn(400))[0].picture.shape[1] == 80  # two colours without soft edges, and no chart


@pytest.mark.parametrize("factor", [2, 3, 5, 7.3, 12.5, 17])
@pytest.mark.parametrize("noisy", [False, True])
@pytest.mark.slow
def test_pixel_art_has_a_stitch_for_a_pixel_however_it_was_enlarged(factor, noisy):
    for seed, shape in enumerate(((16, 16), (24, 32), (41, 29))):
        pixels = sprite(*shape, seed)
        image = Image.fromarray(pixels)
        big = image.resize((round(shape[1] * factor), round(shape[0] * factor)), Image.Resampling.NEAREST)
        if noisy:
            raw = io.BytesIO()
            big.save(raw, "JPEG", quality=90, subsampling=0)
            big = Image.open(raw).convert("RGB")
            if factor < 5:
                continue  # of blocks below JPEG's own the colours are not to be had back
        found, told = laid(np.asarray(big))
        seen = found.picture[::-1]
        assert seen.shape == pixels.shape and "pixel art" in told[0]
        assert np.abs(seen.astype(int) - pixels).max() <= (24 if noisy else 0)
        assert not noisy or len(np.unique(seen.reshape(-1, 3), axis=0)) == 5
        assert laid(pixels)[0].picture.shape == pixels.shape


def test_what_only_looks_like_pixel_art():
    flag = np.zeros((300, 450, 3), np.uint8)
    flag[:, 150:300], flag[:, 300:] = 255, (200, 30, 30)
    for rgb in (flag, photo(), drawn(400), drawn(400, 4), drawn(96, 4), np.full((300, 300, 3), 90, np.uint8)):
        assert usual.lattice(rgb) is None
    mosaic = np.kron(photo(40, 40)[::1], np.ones((8, 8, 1), np.uint8))
    assert usual.lattice(mosaic) == (40, 40)  # a photograph made of squares is taken square by square


def test_charts_keep_their_stitches_at_any_width():
    runs = np.random.default_rng(5).integers(1, 6, (30, 397))
    cells = np.stack([np.repeat(np.arange(397) % 2, row)[:397] for row in runs])
    chart = np.where(cells[..., None], 255, 0).astype(np.uint8).repeat(3, 2)
    assert laid(chart)[0].picture.shape[:2] == (30, 397)


@pytest.mark.slow
def test_colours_are_those_that_a_person_sees():
    def made(rgb, **params):
        piece = CRAFT.make(picture(rgb), KnitParams(**params), Progress())
        return piece.chart.technique, [tuple(c) for c in piece.chart.palette.rgb.tolist()], piece

    red = drawn(400, 4)
    assert made(red)[:2] == ("stranded", [(200, 30, 40), (255, 255, 255)])
    grey = np.asarray(Image.fromarray(photo()).convert("L").convert("RGB"))
    assert made(grey)[:2] == ("stranded", [(0, 0, 0), (255, 255, 255)])
    technique, colours, _ = made(photo())
    assert technique == "intarsia" and len(colours) == 5
    for said in ({"floats": "caught"}, {"max_float": "5"}, {"round": True}, {"yarns": 2}, {"use": "mitten"}):
        assert made(photo(), **said)[0] == "stranded"
    pixels = sprite(24, 24, 7)
    technique, colours, piece = made(np.kron(pixels, np.ones((9, 9, 1), np.uint8)))
    assert technique == "intarsia" and (piece.chart.palette.rgb[piece.chart.cells[::-1]] == pixels).all()
    assert piece.figures["violations"] == 0 and piece.figures["embroidered"] > 0


@pytest.mark.parametrize(
    "more, words",
    [
        ({"rows": 30, "gauge": "24x32"}, ("44% lower", "{--rows} 53 ")),
        ({"rows": 80, "gauge": "24x32"}, ("50% taller", "{--rows} 53 ")),
        ({"rows": 30}, ("25% lower", "{--rows} 40 ")),
        ({"rows": 53, "gauge": "24x32"}, None),
        ({"rows": 53}, None),  # by a gauge in the knitter's head
        ({"rows": 40}, None),
        ({"gauge": "24x32"}, None),
    ],
)
def test_rows_that_squash_the_picture_are_told(more, words):
    told = Progress()
    lay(picture(photo(200, 200)), KnitParams(stitches=40, **more), told)
    said = [w for w in told.warnings if "than it is" in w.message]
    assert len(said) == (words is not None)
    if words:
        assert words[0] in said[0].message and words[1] in said[0].hint + " "
        rows = int(said[0].hint.split()[1])
        assert (
            lay(picture(photo(200, 200)), KnitParams(stitches=40, **more | {"rows": rows}), told).picture.shape[0]
            == rows
        )
        assert len([w for w in told.warnings if "than it is" in w.message]) == 1

"""Pictures become stitches: size, gauge, crop, turn, alpha, masks."""

from __future__ import annotations

import numpy as np
import pytest

from tambour.core.errors import TambourError
from tambour.core.picture import Picture
from tambour.core.progress import Progress
from tambour.knit.params import KnitParams
from tambour.knit.picture import resample
from tambour.knit.picture.layout import lay


def picture(rgb, alpha=255):
    rgb = np.asarray(rgb, np.uint8)
    if rgb.ndim == 2:
        rgb = np.dstack([rgb] * 3)
    return Picture(np.dstack([rgb, np.full(rgb.shape[:2], alpha, np.uint8)]))


def ramp(height, width):
    return picture(np.add.outer(np.arange(height), np.arange(width)) * 255 // (height + width))


def test_without_a_size_a_pixel_is_a_stitch():
    source = ramp(7, 5)
    laid = lay(source, KnitParams(), Progress())
    assert (laid.picture[::-1] == source.rgba[..., :3]).all()


@pytest.mark.parametrize(
    "params, expected",
    [
        ({"stitches": 60}, (45, 60)),
        ({"rows": 90}, (90, 120)),
        ({"stitches": 60, "rows": 10}, (10, 60)),
        ({"stitches": 60, "gauge": "20x30"}, (68, 60)),  # rows are flatter than stitches are wide: more of them
        ({"rows": 30, "gauge": "20x30"}, (30, 27)),
        ({}, (300, 400)),
    ],
)
def test_size(params, expected):
    assert resample.size(KnitParams(**params), 400, 300) == expected


def test_too_many_stitches_are_refused():
    with pytest.raises(TambourError, match="too many"):
        resample.size(KnitParams(), 20001, 2)
    with pytest.raises(TambourError, match="too many"):
        resample.size(KnitParams(), 19000, 19000)
    assert resample.size(KnitParams(), 20000, 1) == (1, 20000)


def test_a_stitch_is_the_mean_of_what_it_covers():
    rng = np.random.default_rng(0)
    rgb = rng.integers(0, 256, (12, 20, 3), dtype=np.uint8)
    mean = rgb.reshape(4, 3, 5, 4, 3).astype(float).mean((1, 3))
    assert np.abs(resample.resample(rgb, 4, 5) - mean).max() <= 1.01


def test_crop_and_quarter_turns():
    source = ramp(9, 14)
    rgb = source.rgba[..., :3]
    part = lay(source, KnitParams(crop="2,1,6,5"), Progress()).picture[::-1]
    assert (part == rgb[1:6, 2:8]).all()
    turned = lay(source, KnitParams(rotate="90"), Progress()).picture[::-1]
    assert (turned == np.rot90(rgb)).all()
    sideways = lay(source, KnitParams(direction="vertical"), Progress()).picture[::-1]
    assert (sideways == np.rot90(rgb, -1)).all()
    with pytest.raises(TambourError, match="beyond the picture of 14 x 9"):
        lay(source, KnitParams(crop="10,0,5,5"), Progress())


def test_what_is_clear_shows_white():
    rgb = np.zeros((3, 3, 3), np.uint8)
    assert (lay(picture(rgb, alpha=0), KnitParams(), Progress()).picture == 255).all()
    assert (lay(picture(rgb, alpha=128), KnitParams(), Progress()).picture == 127).all()


@pytest.mark.parametrize("angle", [-30, -10, 12, 25, 40])
def test_strokes_are_lined_up(angle):
    """Bars turned by an angle are found to need the turn back (rows and columns count alike)."""
    from PIL import Image

    bars = np.repeat(np.tile(np.repeat([0, 255], 12), 10)[None], 240, 0).astype(np.uint8)
    turned = np.asarray(Image.fromarray(np.dstack([bars] * 3)).rotate(angle, Image.Resampling.BICUBIC))[60:180, 60:180]
    found = resample.straightening(turned)
    assert abs((found + angle + 45) % 90 - 45) < 1.5


def test_masks_fit_the_chart_or_the_picture():
    source = ramp(20, 40)
    small = np.zeros((5, 10), np.uint8)
    small[:, 5:] = 255
    large = np.kron(small, np.ones((4, 4), np.uint8))
    for mask in (small, large):
        laid = lay(source, KnitParams(stitches=10, relax=picture(mask)), Progress())
        assert (laid.relaxed == (small[::-1] > 127)).all()
    framed = lay(source, KnitParams(stitches=10, border=1, shape=picture(large)), Progress())
    assert framed.knit.shape == (6, 10) and framed.knit[0].all() and not framed.knit[1:-1, 1:4].any()
    with pytest.raises(TambourError, match="the mask is 7 x 3"):
        lay(source, KnitParams(stitches=10, lock=picture(np.zeros((3, 7)))), Progress())
    with pytest.raises(TambourError, match="nothing to knit"):
        lay(source, KnitParams(stitches=10, shape=picture(np.zeros((5, 10)))), Progress())


def test_repeats_must_come_out_even():
    source = ramp(20, 48)
    laid = lay(source, KnitParams(repeat="24+1", stitches=73), Progress())
    assert laid.picture.shape[1] == 24 and laid.tiled(laid.picture).shape[1] == 73
    with pytest.raises(TambourError, match="74 stitches are not a multiple of 24 plus 1") as error:
        lay(source, KnitParams(repeat="24+1", stitches=74), Progress())
    assert "73 and 97" in str(error.value)


def test_saliency_finds_the_odd_one():
    rgb = np.full((64, 96, 3), 200, np.uint8)
    rgb[...] -= np.random.default_rng(0).integers(0, 40, (64, 96, 1), dtype=np.uint8)
    rgb[20:32, 60:72] = 10
    weights = lay(picture(rgb), KnitParams(focus="saliency", stitches=96), Progress()).weights[::-1]
    assert weights.min() >= 1 and weights.max() <= 10
    assert weights[18:34, 58:74].mean() > 2 * np.delete(weights, np.s_[50:80], 1).mean()

"""Colour against an independent library."""

from __future__ import annotations

import numpy as np
import pytest
from coloraide import Color

from tambour import color
from tambour.core.rgb import colored, css_colors


def test_oklab_agrees_with_coloraide() -> None:
    rng = np.random.default_rng(1)
    for rgb in rng.integers(0, 256, (40, 3)).astype(np.uint8):
        oracle = Color("srgb", (rgb / 255).tolist()).convert("oklab").coords()
        assert np.abs(color.oklab(rgb) - oracle).max() < 2e-4


def test_there_and_back() -> None:
    rgb = np.random.default_rng(2).integers(0, 256, (500, 3)).astype(np.uint8)
    assert np.array_equal(color.from_oklab(color.oklab(rgb)), rgb)
    x = np.linspace(0, 1, 1001)
    assert np.abs(color.coded(color.linear(x)) - x).max() < 1e-7


def test_luminance_of_black_and_white() -> None:
    assert np.allclose(color.luminance(np.array([[0, 0, 0], [255, 255, 255]], np.uint8)), [0, 1])


def test_names_and_codes_of_colours_are_those_of_css() -> None:
    from PIL import ImageColor

    assert css_colors() == {name: ImageColor.getrgb(name)[:3] for name in ImageColor.colormap}
    for text in ("Teal", "#F80", "#ff8800", "#FF8800", "rebeccapurple"):
        assert colored(text) == ImageColor.getrgb(text)[:3]
    for text in ("", "#", "#ff", "#ffff", "#fffff", "#ff 00 0", "#gggggg", "tealish", "#ff88000"):
        with pytest.raises(ValueError):
            colored(text)

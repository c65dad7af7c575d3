"""Drawings that draw themselves: every shape once, in order, and the end is the drawing."""

from __future__ import annotations

import re
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from PIL import Image

from tambour import files
from tambour.core.drawing import Drawing, Label, Placed, Styles
from tambour.core.paths import Paths
from tambour.core.picture import Picture
from tambour.core.reveal import Reveal, stretch
from tambour.files.svg import write as svg
from tambour.render import flat

BLACK = Styles.of(((0, 0, 0, 120), None, 0), ((200, 30, 20, 255), (0, 0, 0, 255), 0.2))


def scene(lengths: list[int]) -> Drawing:
    rng = np.random.default_rng(len(lengths))
    paths = Paths.of([rng.random((n, 2)) * 10 for n in lengths])
    grain = Picture(np.full((4, 4, 4), [120, 90, 60, 30], np.uint8))
    return Drawing(
        paths,
        np.arange(len(paths)) % 2,
        BLACK,
        [10, 6],
        background=(240, 230, 210, 255),
        labels=(Label("end", 5, 5, 1),),
        images=(Placed(grain, 0, 0, 10, 6, glaze=True),),
    )


@given(st.lists(st.integers(2, 9), min_size=1, max_size=30), st.integers(1, 12))
def test_every_shape_is_drawn_once_and_in_order(lengths: list[int], steps: int) -> None:
    drawing = scene(lengths)
    cuts = Reveal(drawing, 5.0, steps).shares()
    assert cuts[0] == 0 and cuts[-1] == len(drawing) and (np.diff(cuts) >= 0).all()
    pieces = [stretch(drawing, a, b) for a, b in pairwise(cuts)]
    assert np.array_equal(np.concatenate([p.paths.coords for p in pieces]), drawing.paths.coords)
    assert np.array_equal(np.concatenate([p.style for p in pieces]), drawing.style)


def test_the_last_frame_is_the_picture() -> None:
    drawing = scene([5] * 40)
    shown = list(flat.frames(Reveal(drawing, 5.0, 7), 300))
    assert len(shown) == 7
    assert np.abs(shown[-1].rgba.astype(int) - flat.picture(drawing, width=300).rgba).max() <= 1
    inked = [int((p.rgba[..., :3].min(axis=2) < 100).sum()) for p in shown]
    assert inked == sorted(inked) and inked[0] < inked[-1]


def test_an_svg_that_paints_itself_holds_the_drawing(tmp_path: Path) -> None:
    drawing = replace(scene([4] * 30), images=())
    files.write(Reveal(drawing, 6.0, 10), tmp_path / "a.svg")
    text = (tmp_path / "a.svg").read_text()
    ways = re.findall(r'<path d="([^"]+)"', text)
    assert ways == re.findall(r'<path d="([^"]+)"', svg.text(drawing))
    delays = [float(d) for d in re.findall(r"animation-delay:([\d.]+)s", text)]
    assert delays == sorted(delays) and len(delays) == 10 and delays[-1] == pytest.approx(5.4)
    assert "script" not in text and "http" not in text.replace("http://www.", "")


@pytest.mark.slow
def test_gif_and_frames(tmp_path: Path) -> None:
    value = Reveal(scene([5] * 12), 2.0, 4)
    files.write(value, tmp_path / "a.gif")
    with Image.open(tmp_path / "a.gif") as image:
        assert getattr(image, "n_frames", 1) == 4
    files.write(value, tmp_path / "b.png")
    assert [p.name for p in sorted(tmp_path.glob("b*"))] == ["b-1.png", "b-2.png", "b-3.png", "b-4.png"]

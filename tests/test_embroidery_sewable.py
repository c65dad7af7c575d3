"""What a machine would stumble over is told with its number and place, and is an error for those who ask."""

from __future__ import annotations

import re

import numpy as np
import pytest

from tambour import files
from tambour.core.errors import TambourError
from tambour.core.progress import Progress
from tambour.embroidery.params import EmbroideryParams, hoop_size
from tambour.embroidery.plan.make import make

HEAD = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 60 60" width="60mm" height="60mm">'


def piece(tmp_path, body, **params):
    (tmp_path / "in.svg").write_text(HEAD + body + "</svg>")
    progress = Progress()
    made = make(files.read(tmp_path / "in.svg", ("Drawing",)), EmbroideryParams(**params), progress)
    return made, [w.message for w in progress.warnings]


SQUARE = '<path d="M5 5h50v50h-50z" fill="{}"/>'


def test_a_plain_design_passes_in_silence(tmp_path):
    _, said = piece(tmp_path, SQUARE.format("red"), check=True)
    assert said == []


def test_many_layers_are_told_with_their_place(tmp_path):
    spot = '<path d="M30 30h8v8h-8z" fill="#{:06x}"/>'
    many = "".join(spot.format(k * 4000) for k in range(30))
    _, said = piece(tmp_path, SQUARE.format("red") + many, keep_hidden=True)
    points = next(s for s in said if "needle points" in s)
    covers = next(s for s in said if "covers" in s)
    threads = next(s for s in said if "threads" in s)
    x, y = map(int, re.findall(r"\((-?\d+), (-?\d+)\)", covers)[0])
    assert 0 <= x <= 8 and 0 <= y <= 8
    assert int(points.split()[0]) > 100 and threads.startswith("31 threads")
    with pytest.raises(TambourError) as caught:
        piece(tmp_path, SQUARE.format("red") + many, keep_hidden=True, check=True)
    assert len(caught.value.problems) == len(said) >= 3
    made, said = piece(tmp_path, SQUARE.format("red") + many)
    assert len(made.plan.threads) == 2 and said == ["29 shape(s) lie hidden below others and were left out"]


def test_a_design_of_a_few_millimetres_is_told(tmp_path):
    assert any(
        "the design is 5.0 x" in s for s in piece(tmp_path, SQUARE.format("red"), width=5.0, pull=0.0, push=0.0)[1]
    )


def test_colours_of_a_drawing_are_reduced_to_the_nearest(tmp_path):
    row = '<path d="M{} 2h6v40h-6z" fill="{}"/>'
    shades = ["#ff0000", "#f80000", "#0000ff", "#0808ff", "#101010"]
    made, _ = piece(tmp_path, "".join(row.format(2 + 8 * k, c) for k, c in enumerate(shades)), colors=3)
    got = {t.rgb for t in made.plan.threads}
    assert len(got) == 3 and (16, 16, 16) in got
    color = [r.color for r in made.regions]
    assert color[0] == color[1] and color[2] == color[3]


def test_hoops_by_name_have_their_true_field():
    assert hoop_size("4x4") == hoop_size("4x4in") == (100, 100)
    assert hoop_size("5x7") == (130, 180) and hoop_size("6x10") == (160, 260)
    assert hoop_size("100x100") == (100, 100) and np.allclose(hoop_size("3x3in"), 76.2)


def test_a_quarter_turn_that_fits_is_told(tmp_path):
    wide = '<path d="M0 10h60v20h-60z" fill="red"/>'
    with pytest.raises(TambourError) as caught:
        piece(tmp_path, wide, width=150.0, hoop="5x7")
    assert "180x130" in caught.value.problems[0].hint
    piece(tmp_path, wide, width=150.0, hoop="180x130")

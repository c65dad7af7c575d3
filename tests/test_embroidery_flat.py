"""The drawing made flat: translucency mixed, hidden parts left out with what the cloth's pull needs, equal neighbours one."""

from __future__ import annotations

import base64
import io

import numpy as np
import pytest
import shapely
from PIL import Image

from tambour import files
from tambour.core.progress import Progress
from tambour.core.thread import STITCH
from tambour.embroidery.params import EmbroideryParams
from tambour.embroidery.plan import overlap
from tambour.embroidery.plan.make import make
from tambour.embroidery.regions.flat import UNDER, shape

HEAD = '<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="100mm" viewBox="0 0 100 100">'


def sewn(tmp_path, body, **how):
    path = tmp_path / "a.svg"
    path.write_text(HEAD + body + "</svg>")
    progress = Progress()
    piece = make(files.read(path, ("Drawing",)), EmbroideryParams(**how), progress)
    return piece, " ".join(w.message for w in progress.warnings)


def test_what_shines_through_is_mixed_with_what_is_below(tmp_path):
    piece, _ = sewn(
        tmp_path,
        '<rect width="40" height="40" fill="#0000ff"/><rect x="20" width="40" height="40" fill="#ff0000" fill-opacity=".5"/>',
    )
    colors = {r.color for r in piece.regions}
    assert colors == {(0, 0, 255), (128, 0, 127), (255, 127, 127)} or colors == {
        (0, 0, 255),
        (127, 0, 128),
        (255, 128, 128),
    }


def test_what_nobody_sees_is_left_out_and_told(tmp_path):
    body = '<rect width="40" height="40" fill="red"/><rect x="5" y="5" width="9" height="9" opacity=".03"/>'
    piece, said = sewn(tmp_path, body + '<rect width="40" height="40" fill="lime"/>')
    assert {r.color for r in piece.regions} == {(0, 255, 0)}
    assert "1 shape(s) are too faint" in said and "1 shape(s) lie hidden" in said
    piece, said = sewn(tmp_path, body + '<rect width="40" height="40" fill="lime"/>', keep_hidden=True)
    assert {r.color for r in piece.regions} == {(255, 0, 0), (0, 255, 0)} and "hidden" not in said


def test_a_wide_cover_makes_a_hole_that_reaches_below_it_and_a_narrow_one_none(tmp_path):
    below = '<rect width="60" height="40" fill="red"/>'
    wide, _ = sewn(tmp_path, below + '<circle cx="30" cy="20" r="10" fill="lime"/>')
    red = next(shape(r) for r in wide.regions if r.color == (255, 0, 0))
    hole = shapely.Polygon(shapely.get_parts(red)[0].interiors[0])
    assert hole.area > np.pi * (10 - UNDER - overlap.UNDER - overlap.NEAR - 0.1) ** 2
    assert shapely.Point(0, 0).buffer(10 - UNDER + 0.05).contains(hole)  # the cloth's pull opens no gap
    narrow, _ = sewn(tmp_path, below + '<rect x="28" width="4" height="40" fill="lime"/>')
    assert not any(
        p.interiors or len(shapely.get_parts(shape(r))) > 1 for r in narrow.regions for p in shapely.get_parts(shape(r))
    )


def test_equal_neighbours_are_one_region_unless_something_lies_between(tmp_path):
    a, b = '<rect width="20" height="20" fill="red"/>', '<rect x="20" width="20" height="20" fill="red"/>'
    assert len(sewn(tmp_path, a + b)[0].regions) == 1
    between = '<rect x="5" y="5" width="30" height="4" fill="blue"/>'
    piece, _ = sewn(tmp_path, a + between + b)
    assert sum(r.color == (255, 0, 0) for r in piece.regions) == 2


@pytest.mark.slow
def test_gradients_come_in_few_threads_and_say_so(tmp_path):
    stops = "".join(f'<stop offset="{k / 9}" stop-color="hsl({40 * k},90%,50%)"/>' for k in range(10))
    body = f'<linearGradient id="g">{stops}</linearGradient><rect width="90" height="40" fill="url(#g)"/>'
    body += (
        body.replace('id="g"', 'id="h"').replace("#g", "#h").replace("90%", "40%").replace("<rect ", '<rect y="45" ')
    )
    piece, said = sewn(tmp_path, body)
    assert len(piece.plan.threads) == 15 and "15 threads take them" in said
    assert len(sewn(tmp_path, body, colors=4)[0].plan.threads) == 4


def test_a_picture_inside_is_traced_in_its_place(tmp_path):
    pixels = np.full((40, 40, 4), 0, np.uint8)
    pixels[10:30, 10:30] = (200, 20, 20, 255)
    out = io.BytesIO()
    Image.fromarray(pixels).save(out, "PNG")
    image = f'<image x="10" y="20" width="40" height="40" href="data:image/png;base64,{base64.b64encode(out.getvalue()).decode()}"/>'
    frame = '<rect width="100" height="100" fill="none" stroke="#000" stroke-width=".3"/>'
    piece, _ = sewn(tmp_path, image + frame)
    (red,) = [r for r in piece.regions if r.color[0] > 150]
    low, high = red.paths.coords.min(0), red.paths.coords.max(0)
    assert np.allclose(
        [*low, *high], [-30, -20, -10, 0], atol=0.8
    )  # 20 … 40 and 30 … 50 of the sheet, whose middle is 50


def test_round_ends_of_strokes_are_sewn_round(tmp_path):
    line = '<path d="M20 20h40" stroke="#000" stroke-width="4" fill="none" {}/>'
    wide = {}
    for cap in ("butt", "round", "square"):
        piece, _ = sewn(tmp_path, line.format(f'stroke-linecap="{cap}"'), pull=0, push=0)
        at = piece.plan.xy[(piece.plan.command == STITCH) & (piece.kind == 1)]
        wide[cap] = np.ptp(at[:, 0]), np.ptp(at[np.abs(at[:, 0]) > np.abs(at[:, 0]).max() - 0.3, 1])
    assert wide["butt"][0] == pytest.approx(40, abs=0.6)
    assert wide["round"][0] == pytest.approx(44, abs=0.9) and wide["square"][0] == pytest.approx(44, abs=0.6)
    assert wide["round"][1] < 3 < wide["square"][1]

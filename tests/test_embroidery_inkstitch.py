"""Files of Ink/Stitch's users give the stitches that their attributes ask for; order, trims and stops."""

from __future__ import annotations

import numpy as np
import pytest

from tambour import files
from tambour.core.errors import TambourError
from tambour.core.progress import Progress
from tambour.core.thread import COLOR, JUMP, STITCH, STOP, TRIM
from tambour.embroidery.params import EmbroideryParams
from tambour.embroidery.piece import FILL, RUNNING, SATIN, UNDERLAY
from tambour.embroidery.plan.facts import facts, steps
from tambour.embroidery.plan.make import make

HEAD = (
    '<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" '
    'xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" xmlns:inkstitch="http://inkstitch.org/namespace" '
    'width="100mm" height="80mm" viewBox="0 0 100 80">'
)


def piece(tmp_path, body, **params):
    (tmp_path / "a.svg").write_text(HEAD + body + "</svg>")
    return make(files.read(tmp_path / "a.svg", ("Drawing",)), EmbroideryParams(**params), Progress())


def test_fill_attributes(tmp_path):
    made = piece(
        tmp_path,
        '<path id="f" d="M10 10h30v20h-30z" fill="#800" inkstitch:auto_fill="true" inkstitch:angle="60" '
        'inkstitch:row_spacing_mm="0.5" inkstitch:max_stitch_length_mm="2" inkstitch:staggers="3" inkstitch:fill_underlay="false"/>',
    )
    p = made.regions[0].params
    assert (p.angle, p.row_spacing, p.length, p.stagger, p.underlay) == (60, 0.5, 2, 3, "none")
    xy, end = steps(made)
    d = (xy[:, 2:] - xy[:, :2])[made.kind[end] == FILL]
    long = np.hypot(*d.T) > 1.5  # a step from row to row: 0.5 mm / sin 30°, and the pull at both ends
    angle = np.degrees(np.arctan2(-d[long, 1], d[long, 0])) % 180
    assert np.allclose(angle, 60, atol=0.01)
    assert np.hypot(*d.T).max() <= 2 + 1e-9 and (made.kind == UNDERLAY).sum() == 0
    assert facts(made)["density"]["rows_mean"] == pytest.approx(2.0, rel=0.02)


def test_satin_column_with_rungs(tmp_path):
    made = piece(
        tmp_path,
        '<path id="s" style="fill:none;stroke:#000" inkstitch:satin_column="true" inkstitch:zigzag_spacing_mm="0.5" '
        'inkstitch:center_walk_underlay="true" d="M10 10 H50 M10 14 H60 M12 8 L12 16 M40 8 L50 16"/>',
        split=12.0,
        pull=0.0,
    )
    assert made.regions[0].role == "rails" and made.regions[0].params.row_spacing == 0.5
    xy = made.plan.xy[(made.kind == SATIN) & (made.plan.command == STITCH)]
    assert np.allclose(np.unique(np.round(xy[:, 1] - xy[:, 1].min(), 3)), [0, 4], atol=0.01)
    top, low = xy[xy[:, 1] < xy[:, 1].mean()][:, 0], xy[xy[:, 1] > xy[:, 1].mean()][:, 0]
    # The second rung ties 42.5 above to 47.5 below: opposite of 40 is 12 + 28 * 35.5 / 30.5 = 44.6.
    at = np.sort(low)[np.searchsorted(np.sort(top), np.sort(top)[0] + 30)]
    assert at - np.sort(low)[0] == pytest.approx(34.6, abs=0.8)
    assert (made.kind == UNDERLAY).sum() > 5


def test_running_and_bean(tmp_path):
    made = piece(
        tmp_path,
        '<path id="r" d="M10 10H40" stroke="#000" fill="none" stroke-width=".4" inkstitch:stroke_method="running_stitch" inkstitch:running_stitch_length_mm="1.5"/>'
        '<path id="b" d="M10 20H40" stroke="#000" fill="none" stroke-width="3" inkstitch:stroke_method="running_stitch" inkstitch:bean_stitch_repeats="1"/>',
        locks=False,
    )
    xy, end = steps(made)
    size = np.hypot(*(xy[:, 2:] - xy[:, :2]).T)
    first = size[(made.region[end] == 0) & (size > 0)]
    assert len(first) == 20 and np.allclose(first, 1.5)
    assert {r.stitch for r in made.regions} == {"running", "bean"}
    assert (made.kind[end] == RUNNING).all()


def test_trim_and_stop_by_attribute_and_by_symbol(tmp_path):
    square = '<path id="{}" d="M{} 10h5v5h-5z" fill="#000" {}/>'
    made = piece(
        tmp_path,
        square.format("a", 10, 'inkstitch:trim_after="true"')
        + square.format("b", 16, "")
        + square.format("c", 22, 'inkstitch:stop_after="true"')
        + square.format("d", 28, "")
        + '<g inkscape:label="command"><path inkscape:connection-start="#u" inkscape:connection-end="#b" d="M0 0 1 1"/>'
        '<use id="u" xlink:href="#inkstitch_trim" x="18" y="3"/></g>',
        order="file",
        trim=50.0,
    )
    command, region = made.plan.command, made.region
    assert (command == STOP).sum() == 1 and (command == TRIM).sum() == 4
    assert set(region[command == TRIM].tolist()) == {0, 1, 2, 3}


def test_ignored_objects_and_guides_are_not_sewn(tmp_path):
    made = piece(
        tmp_path,
        '<path id="x" d="M0 0h5v5h-5z" fill="#000"/><g><path id="f" d="M10 10h30v20h-30z" fill="#800" inkstitch:fill_method="guided_fill"/>'
        '<path d="M5 15 L50 25" style="stroke:#00f;fill:none;marker-start:url(#inkstitch-guide-line-marker)"/></g>'
        '<path inkscape:connection-start="#u" inkscape:connection-end="#x" d="M0 0 1 1"/><use id="u" xlink:href="#inkstitch_ignore_object" x="1" y="1"/>',
        underlay="none",
    )
    assert [r.id for r in made.regions] == ["f"] and made.regions[0].guide is not None
    xy, end = steps(made)
    d = (xy[:, 2:] - xy[:, :2])[made.kind[end] == FILL]
    long = np.hypot(*d.T) > 2
    assert np.allclose(d[long, 1] / d[long, 0], 10 / 45, atol=0.02)


def test_colours_are_gathered_but_what_lies_on_top_stays_there(tmp_path):
    square = '<path id="{}" d="M{} 10h{w}v{w}h-{w}z" fill="{}"/>'
    body = "".join(square.format(f"p{k}", 10 * k, c, w=6) for k, c in enumerate(["red", "blue", "red", "blue", "red"]))
    made = piece(tmp_path, body)
    assert (made.plan.command == COLOR).sum() == 1
    made = piece(tmp_path, body, order="file")
    assert (made.plan.command == COLOR).sum() == 4
    layered = (
        square.format("low", 10, "red", w=20)
        + square.format("mid", 12, "blue", w=10)
        + square.format("top", 14, "red", w=4)
    )
    made = piece(tmp_path, layered)
    first = [int(np.flatnonzero(made.region == k)[0]) for k in range(3)]
    assert first == sorted(first) and (made.plan.command == COLOR).sum() == 2


def test_wrong_values_name_their_object(tmp_path):
    with pytest.raises(TambourError) as error:
        piece(
            tmp_path,
            '<path id="f" d="M10 10h30v20h-30z" inkstitch:angle="wide"/><path id="g" d="M10 40h30v20h-30z" data-tambour-stitch="knots" data-tambour-lenght="3"/>',
        )
    text = str(error.value)
    assert "f: inkstitch:angle" in text and "g: data-tambour-stitch" in text and "lenght" in text


def test_hoop_and_width(tmp_path):
    body = '<path d="M10 10h60v30h-60z"/>'
    with pytest.raises(TambourError, match="would fit"):
        piece(tmp_path, body, hoop="50x50")
    made = piece(tmp_path, body, width=45.0, hoop="50x50")
    assert facts(made)["width_mm"] == pytest.approx(45 + 2 * made.params.pull, abs=0.2)  # before the cloth draws in
    assert "50x50" in facts(made)["hoops"] and facts(piece(tmp_path, body))["hoops"][0] == "100x100"
    assert np.allclose((made.plan.xy.min(0) + made.plan.xy.max(0)) / 2, 0, atol=0.3)


@pytest.mark.parametrize(
    "body",
    [
        "",
        '<path d="M0 0h5"/>',
        '<path d="M0 0h5v0z"/>',
        '<rect width="3000" height="3000"/>',
        '<rect width="0.1" height="0.1"/>',
    ],
)
def test_drawings_that_cannot_be_embroidered_say_why(tmp_path, body):
    with pytest.raises(TambourError):
        piece(tmp_path, body)


def test_jumps_longer_than_trim_are_cut_and_ends_are_tied(tmp_path):
    body = '<path d="M10 10h5v5h-5z"/><path d="M40 10h5v5h-5z"/>'
    made = piece(tmp_path, body)
    command = made.plan.command
    jump = np.flatnonzero(command == JUMP)
    runs = np.split(jump, np.flatnonzero(np.diff(jump) > 1) + 1)
    for run in runs[1:]:
        assert command[run[0] - 1] == TRIM
    assert (made.kind == 5).sum() >= 4 * 2
    assert piece(tmp_path, body, trim=100.0).plan.command.tolist().count(TRIM) == 1

"""Needle points changed by hand; machines by name; borders; the red layer; letters of one size sewn one way."""

from __future__ import annotations

import numpy as np
import pytest

from tambour import files
from tambour.core.errors import TambourError
from tambour.core.progress import Progress
from tambour.core.thread import COLOR, STITCH
from tambour.embroidery.columns.satin import Column, zigzag
from tambour.embroidery.columns.stroke import from_stroke
from tambour.embroidery.looks.scene import check, preview
from tambour.embroidery.needle import NEEDLE, Needle
from tambour.embroidery.params import EmbroideryParams
from tambour.embroidery.piece import LOCK, RUNNING, SATIN, UNDERLAY
from tambour.embroidery.plan.facts import facts
from tambour.embroidery.plan.make import make

HEAD = '<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="100mm" viewBox="0 0 100 100">'
SQUARE = '<path d="M10 10h30v30h-30z" fill="#c22"/>'


def sewn(tmp_path, body, **how):
    path = tmp_path / "a.svg"
    path.write_text(HEAD + body + "</svg>")
    progress = Progress()
    return make(files.read(path, ("Drawing",)), EmbroideryParams(**how), progress), progress


def test_needle_points_are_moved_put_in_and_taken_out(tmp_path):
    piece, progress = sewn(tmp_path, SQUARE)
    at = np.flatnonzero((piece.plan.command == STITCH) & (piece.kind == 0))
    a, b, c = at[10], at[40], at[70]
    edits = [Needle(point=a, to="1,2"), Needle(point=b, to="none"), Needle(point=c, to="+0.5cm, -1")]
    made = NEEDLE.after(piece, edits, progress)
    assert len(made.plan) == len(piece.plan)
    assert made.plan.xy[a].tolist() == [1, 2]
    assert made.plan.xy[c].tolist() == [5, -1] and made.plan.xy[c - 1].tolist() == piece.plan.xy[c].tolist()
    left = np.delete(piece.plan.xy, [a, b], axis=0)
    assert np.array_equal(np.delete(made.plan.xy, [a, c], axis=0), left)
    first, last = made.strands()
    assert (first < last).all() and facts(made)["stitches"] == facts(piece)["stitches"]
    again = NEEDLE.after(piece, [Needle(point=a, to="{},{}".format(*piece.plan.xy[a].tolist()))], progress)
    assert np.array_equal(again.plan.xy, piece.plan.xy) and np.array_equal(again.rows, piece.rows)
    assert np.allclose(again.elevation, piece.elevation)


def test_wrong_needle_edits_are_told_together(tmp_path):
    piece, progress = sewn(tmp_path, SQUARE)
    jump = int(np.flatnonzero(piece.plan.command != STITCH)[0])
    with pytest.raises(TambourError) as error:
        NEEDLE.after(
            piece, [Needle(point=jump, to="1,1"), Needle(point=9_999_999, to="1,1"), Needle(point=3, to="x")], progress
        )
    assert len(error.value.problems) == 3
    NEEDLE.after(piece, [Needle(point=int(np.flatnonzero(piece.kind == 0)[9]), to="80,80")], progress)
    assert "longer than 12.1 mm" in progress.warnings[-1].message


def test_a_machine_is_its_field_and_its_needles(tmp_path):
    with pytest.raises(TambourError, match="brother-se600 100 x 100"):
        sewn(tmp_path, SQUARE, width=120.0, machine="brother-se600")
    assert sewn(tmp_path, SQUARE, width=120.0, machine="Brother-PE800")[0].params.machine == "brother-pe800"
    with pytest.raises(ValueError, match="not one of"):
        EmbroideryParams(machine="brother-pe9")
    many = "".join(f'<path d="M{8 * k} 0h6v40h-6z" fill="hsl({30 * k},80%,50%)"/>' for k in range(8))
    _, progress = sewn(tmp_path, many, machine="brother-pr680w")
    assert any("8 threads, and 6 needles" in w.message for w in progress.warnings)


def test_a_border_is_satin_of_its_width_inside_the_edge(tmp_path):
    piece, _ = sewn(tmp_path, SQUARE, stitch="tatami", border=2.0, pull=0.0, push=0.0)
    satin = piece.plan.xy[(piece.kind == SATIN) & (piece.plan.command == STITCH)]
    assert np.abs(satin).max() == pytest.approx(15, abs=0.1)
    assert np.abs(satin).max(axis=1).min() == pytest.approx(13, abs=0.15)
    assert (
        np.flatnonzero(piece.kind == SATIN).min() > np.flatnonzero(piece.kind == 0).max()
    ) and piece.plan.command.tolist().count(COLOR) == 0


@pytest.mark.slow
def test_the_red_layer_lies_where_it_is_too_full(tmp_path):
    spot = "".join(f'<path d="M20 20h4v4h-4z" fill="#{k * 7000:06x}"/>' for k in range(1, 12))
    piece, _ = sewn(tmp_path, SQUARE + spot, keep_hidden=True)
    red, plain = check(piece).rgba.astype(int), preview(piece).rgba.astype(int)
    j, i = np.nonzero((red != plain).any(axis=2))
    scale = red.shape[1] / (np.ptp(piece.plan.xy[piece.plan.command == STITCH][:, 0]) + 12)
    assert len(j) and abs(i.mean() / scale - 6 - 12) < 2 and abs(j.mean() / scale - 6 - 12) < 2
    empty, _ = sewn(tmp_path, SQUARE)
    assert np.array_equal(check(empty).rgba, preview(empty).rgba)


@pytest.mark.parametrize("size", [4.0, 6.0, 9.0])
def test_letters_of_one_size_are_sewn_one_way(size):
    made = make(None, EmbroideryParams(text="Rag&g 8", text_size=size), Progress())
    kinds = set(np.unique(made.kind[made.kind != LOCK]).tolist())
    assert not {SATIN, RUNNING} <= kinds
    assert (UNDERLAY in kinds) == (size >= 5)


def test_small_holes_are_told(tmp_path):
    _, progress = sewn(tmp_path, '<path fill-rule="evenodd" d="M10 10h30v30h-30z M20 20h.6v.6h-.6z"/>', check=False)
    assert any("a hole is so small" in w.message for w in progress.warnings)


def test_stitches_of_a_tight_bend_end_where_they_would_crowd():
    turn = np.linspace(0, np.pi, 400)[:, None]
    ring = np.c_[np.cos(turn), np.sin(turn)]
    fan = Column(0.05 * ring, 6.0 * ring)
    xy = zigzag(fan.left, fan.right, 0.4, 0.25, 0.45, 0.0, 0.0, 0.0, np.uint64(0))
    inner = np.hypot(*xy[::2].T)
    for radius in (0.8, 1.5, 2.5):  # threads that reach farther in than this, side by side round the bend
        assert np.pi * radius / (inner < radius).sum() > 0.18
    straight = zigzag(
        np.c_[turn * 9, 0 * turn], np.c_[turn * 9, 0 * turn + 3], 0.2, 0.25, 0.45, 0.0, 0.0, 0.0, np.uint64(0)
    )
    assert set(np.unique(straight[:, 1].round(9))) == {0.0, 3.0}


def test_a_sharp_corner_of_a_line_has_no_fork():
    line = np.array([[0.0, 0.0], [20.0, 0.0], [2.0, 4.0]])
    columns = from_stroke(line, 3.0)
    assert len(columns) == 2
    for column in columns:
        points = np.concatenate([column.left, column.right])
        assert np.hypot(*(points - line[1]).T)[points[:, 0] > 20].max() < 1.8


def test_the_e_stitch_has_its_prongs_on_one_side(tmp_path):
    line = '<path d="M20 20h40" fill="none" stroke="#000" stroke-width=".5"/>'
    piece, _ = sewn(tmp_path, line, stitch="motif", motif="e", motif_size=4.0)
    at = piece.plan.xy[(piece.plan.command == STITCH) & (piece.kind == RUNNING)]
    prongs = np.unique(at[np.abs(at[:, 1] - at[:, 1].min()) < 0.01][:, 0].round(3))
    assert (
        np.ptp(at[:, 1]) == pytest.approx(2, abs=0.05)
        and len(prongs) == 10
        and np.allclose(np.diff(prongs), 4, atol=0.05)
    )


def test_letters_of_text_are_kerned():
    wide = {
        t: facts(make(None, EmbroideryParams(text=t, text_size=20.0), Progress()))["width_mm"] for t in ("AV", "A", "V")
    }
    from tambour.geometry.glyphs import glyph
    from tambour.render.type import font_bytes

    em = 20.0 / 0.727
    assert wide["AV"] < wide["A"] + wide["V"] - 0.5 and glyph(font_bytes(True), "A").advance * em > wide["A"] - 2

"""Views of a whole piece: scene, density, simulator, worksheet; designs from machine files; catalogues; layers."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

from tambour import files
from tambour.core.drawing import Drawing, Styles
from tambour.core.errors import TambourError
from tambour.core.paths import Paths
from tambour.core.progress import Progress
from tambour.core.thread import COLOR, END, STITCH, STOP, Thread, ThreadPlan
from tambour.embroidery import CRAFT
from tambour.embroidery.looks.scene import density, machine, scene, simulate
from tambour.embroidery.looks.worksheet import blocks, worksheet
from tambour.embroidery.params import EmbroideryParams
from tambour.embroidery.piece import Piece
from tambour.embroidery.plan.design import piece_of
from tambour.embroidery.plan.layers import PRESSED, elevation
from tambour.embroidery.regions.catalogue import TABLES, catalogue, matched, screen

SQUARES = [np.array([[x, 0], [x + 9, 0], [x + 9, 12], [x, 12], [x, 0]], float) for x in (0.0, 11.0)]


def made(**params) -> Piece:
    styles = Styles.of(((176, 32, 48, 255), None, 0.0), ((30, 58, 110, 255), None, 0.0))
    drawing = Drawing(Paths.of(SQUARES), np.arange(2), styles, np.array([20.0, 12.0]), about={"title": "two squares"})
    return CRAFT.make(drawing, EmbroideryParams(**params), Progress())


@pytest.fixture(scope="module")
def piece() -> Piece:
    return made(cloth="flag", frames=3)


def test_scene_has_cloth_and_every_stitch(piece):
    it = scene(piece)
    assert it.names == ("cloth", "thread")
    assert it.frame_count == 3
    thread = it.strands[0]
    assert set(thread.strand_data) == {"id", "region", "thread", "seconds", "kind"}
    assert (np.diff(thread.strand_data["seconds"]) > 0).all()
    ids = thread.strand_data["id"]
    rest = thread.point_data["rest"]
    middle = (piece.plan.xy.min(axis=0) + piece.plan.xy.max(axis=0)) / 2
    first = rest[thread.paths.offsets[:-1]][:, :2] * [1, -1] + middle
    # A stitch begins under its needle point, to the slope of its end.
    assert np.hypot(*(first - piece.plan.xy[ids - 1]).T).max() < 0.3
    sizes = [len(f) for f in thread.frames()]
    assert sizes == [len(rest)] * 3


def test_scene_on_a_mesh_of_ones_own(piece):
    from test_embroidery_bind import ball

    it = scene(made(cloth=ball(30, 40), place="point", place_at="0,10,29", underlay="none"))
    far = np.linalg.norm(it.strands[0].paths.coords, axis=1)
    assert far.min() > 29
    assert far.max() < 31.5
    assert it.strands[0].paths.coords[:, 2].min() > 20
    with pytest.raises(TambourError, match="group"):
        scene(made(cloth=ball(), place_group="head"))


def test_bad_places_are_refused_by_their_option():
    for name, value in (("place_offset", "1"), ("place_at", "1,2"), ("ground", "white"), ("place_offset", "a,b")):
        with pytest.raises(TambourError) as caught:
            EmbroideryParams.of({name: value})
        assert caught.value.problems[0].where == "{--" + name.replace("_", "-") + "}"


def test_density_is_thread_over_area(piece):
    picture = density(piece)
    assert picture.pixel == pytest.approx(1 / 8)
    bare = picture.rgba[2, 2, :3]
    middle = picture.rgba[picture.rgba.shape[0] // 2, picture.rgba.shape[1] // 4, :3]
    assert tuple(bare) == (246, 244, 238)
    assert int(middle[1]) < 220


def test_simulation_grows_to_the_whole(piece):
    frames = list(simulate(piece, 5, 200))
    assert len(frames) == 5
    red = [(f.rgba[..., 0].astype(int) - f.rgba[..., 1] > 60).sum() for f in frames]
    assert red[0] > 0
    assert all(a <= b + 60 for a, b in pairwise(red[:4]))


def test_worksheet_lists_blocks_and_shows_true_size(piece):
    listed = blocks(piece.plan)
    assert [b["begins"] for b in listed] == ["start", "color"]
    assert sum(b["stitches"] for b in listed) == (piece.plan.command == STITCH).sum()
    pages = worksheet(piece)
    assert len(pages) == 2
    assert any(label.text == "two squares" for label in pages[0].labels)
    ink = pages[1].paths.coords
    assert ink[:, 0].min() >= 0
    assert ink[:, 0].max() <= pages[1].size[0]
    # True size: the frame around the needle points is as wide as they are.
    width = np.ptp(piece.plan.xy[:, 0])
    frames = [np.ptp(p[:, 0]) for p in pages[1].paths if len(p) == 5]
    assert any(abs(w - width) < 0.01 for w in frames)


def test_a_machine_file_is_a_source(tmp_path, piece):
    for suffix in ("dst", "pes"):
        files.write(machine(piece), tmp_path / f"a.{suffix}")
        plan = files.read(tmp_path / f"a.{suffix}", ("ThreadPlan",))
        progress = Progress()
        again = CRAFT.make(plan, EmbroideryParams(cloth="wave"), progress)
        assert (again.plan.command == STITCH).sum() == (piece.plan.command == STITCH).sum()
        assert len(progress.warnings) == (suffix == "dst")  # the colours are ours
        assert scene(again).strands[0].color.shape[1] == 3
        assert CRAFT.facts(again)["stitches"] > 100
    files.write(machine(again), tmp_path / "b.exp")
    wide = piece_of(plan, EmbroideryParams(width=50), progress)
    sewn = wide.plan.xy[wide.plan.command == STITCH]
    assert np.ptp(sewn[:, 0]) == pytest.approx(50)
    assert "scaled" in str(progress.warnings[-1])


@pytest.mark.parametrize("name", TABLES)
def test_catalogues_hold_threads_that_can_be_bought(name):
    held = catalogue(name)
    assert len(held) >= 28
    assert all(t.catalogue and t.name for t in held)
    chosen = matched(held[:5], name)
    assert [t.rgb for t in chosen] == [t.rgb for t in held[:5]]


def test_codes_are_what_stands_on_a_spool():
    """They were places in the machines' memory: 1 for Brother's 007."""
    brother = {t.name: t.code for t in catalogue("brother")}
    assert brother["Prussian Blue"] == "007" and brother["Black"] == "900" and brother["Fresh Green"] == "027"
    assert len(set(brother.values())) == len(brother) == 61  # none twice, and none for a step of appliqué
    assert not any(t.code for t in catalogue("viking"))
    assert {s["code"] for s in screen((Thread((14, 31, 124)),))} == {"1"}  # the machine's own


@pytest.mark.parametrize("fabric, word", [("knit", "cut-away"), ("towel", "water-soluble")])
def test_the_sheet_names_the_stabiliser_of_the_fabric(fabric, word):
    assert any(
        f"for {fabric}" in label.text and word in label.text for label in worksheet(made(fabric=fabric))[0].labels
    )


def test_two_colours_stay_two():
    near = (Thread((200, 30, 40)), Thread((202, 30, 40)))
    a, b = matched(near, "brother")
    assert a != b
    assert [s["rgb"] for s in screen(near)] == [list(a.rgb), list(b.rgb)]


def test_catalogue_reaches_the_plan():
    it = made(catalogue="brother")
    assert {t.catalogue for t in it.plan.threads} == {"Brother"}


def test_layers_lie_on_each_other_and_rows_do_not():
    def rows(flip: bool) -> np.ndarray:
        y = np.repeat(np.arange(0, 8, 0.4), 2)
        x = np.tile([0.0, 8, 8, 0], 10)
        return np.c_[y, x] if flip else np.c_[x, y]

    xy = np.vstack([rows(False), rows(True), [[8.0, 8]]])
    n = len(xy)
    command = np.full(n, STITCH, np.uint8)
    command[40], command[-1] = COLOR, END
    plan = ThreadPlan(xy, command, (np.arange(n) >= 40).astype(np.int16), (Thread((0, 0, 0)), Thread((9, 9, 9))))
    lies = elevation(plan, plan.thread, 0.4)
    assert lies[:39].max() == 0
    assert lies[45:75].mean() == pytest.approx(PRESSED * 0.4, rel=0.05)
    assert elevation(plan, np.zeros(n), 0.4)[45:75].mean() > 0.1  # crossing is enough


def test_stops_stand_in_the_programme():
    xy = np.array([[0, 0], [3, 0], [3, 0], [6, 0], [9, 0], [9, 0]], float)
    command = np.array([STITCH, STITCH, STOP, STITCH, STITCH, END], np.uint8)
    plan = ThreadPlan(xy, command, np.zeros(6, np.int16), (Thread((0, 0, 0)),))
    assert [(b["begins"], b["stitches"]) for b in blocks(plan)] == [("start", 2), ("stop", 2)]

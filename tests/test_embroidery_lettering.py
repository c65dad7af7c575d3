"""Letters from a font, satin by their middle lines; pictures traced to areas."""

from __future__ import annotations

import json
import string
from itertools import pairwise

import numpy as np
import pytest
import shapely

from night import NIGHT
from tambour import files
from tambour.core.drawing import Drawing, Styles
from tambour.core.errors import TambourError
from tambour.core.font import Font
from tambour.core.paths import Paths
from tambour.core.picture import Picture
from tambour.core.progress import Progress
from tambour.core.thread import STITCH
from tambour.embroidery.columns.medial import limbs
from tambour.embroidery.params import EmbroideryParams
from tambour.embroidery.piece import LOCK, RUNNING, SATIN, TRAVEL
from tambour.embroidery.plan.facts import facts
from tambour.embroidery.plan.make import make
from tambour.embroidery.regions.face import letter
from tambour.embroidery.regions.trace import outlines, traced
from tambour.geometry.glyphs import capital_height, glyph
from tambour.render.type import font_bytes


def test_letters_are_satin_without_a_jump_inside_a_letter():
    made = make(None, EmbroideryParams(text="nR", text_size=15.0), Progress())
    told = facts(made)
    assert [r.stitch for r in made.regions] == ["satin", "satin"]
    assert told["jumps"] == 1  # from letter to letter
    assert (made.kind == SATIN).mean() > 0.5
    assert told["height_mm"] == pytest.approx(15, abs=0.5)


def test_columns_cover_a_letter():
    shape = glyph(font_bytes(True), "H")
    area = shapely.Polygon(shape.rings[0] * 20)
    found, left = limbs(area, 14.0)
    quads = [shapely.Polygon([*m.column.left, *m.column.right[::-1]]).buffer(0.15) for m in found]
    assert shapely.union_all(quads).intersection(area).area > 0.93 * area.area and left.area < 0.05 * area.area
    assert len(found) == 3 and sum(len(m.through) for m in found) == 2  # two stems go through, the bar ends at both


def test_a_stem_runs_straight_past_the_bars_that_meet_it():
    # An E of strokes 3 mm wide: the stem's middle line leans nowhere, and no chord of it reaches into the middle bar.
    bars = [shapely.box(0, y, 12, y + 3) for y in (0, 9, 18)]
    area = shapely.union_all([shapely.box(0, 0, 3, 21), *bars])
    found, _ = limbs(area, 14.0)
    stem = max(found, key=lambda m: np.ptp(m.column.middle[:, 1]))
    inner = np.abs(stem.column.middle[:, 1] - 10.5) < 4
    assert inner.sum() > 10
    assert np.abs(stem.column.middle[inner, 0] - 1.5).max() < 0.12
    assert np.hypot(*(stem.column.left - stem.column.right).T)[inner].max() < 3.3
    assert np.abs(np.diff(stem.column.middle[inner], axis=0)).max() < 0.3


def test_a_ring_is_one_closed_column():
    ring = shapely.Point(0, 0).buffer(10, quad_segs=32).difference(shapely.Point(0, 0).buffer(7, quad_segs=32))
    found, _ = limbs(ring, 14.0)
    assert len(found) == 1
    column = found[0].column
    assert np.allclose(np.hypot(*(column.left - column.right).T), 3, atol=0.15)


def test_fonts_are_read_and_broken_ones_refused(tmp_path):
    (tmp_path / "a.otf").write_bytes(font_bytes())
    font = files.read(tmp_path / "a.otf", ("Font",))
    assert 0.6 < capital_height(font.data) < 0.8
    made = make(None, EmbroideryParams(text="i", text_size=10.0, font=font), Progress())
    assert len(made.regions) == 1
    for data in (b"hello", b"OTTO" + b"\0" * 100, font_bytes()[:5000]):
        (tmp_path / "b.otf").write_bytes(data)
        with pytest.raises(TambourError):
            files.read(tmp_path / "b.otf", ("Font",))


def test_missing_letters_are_said_and_no_letters_refused():
    progress = Progress()
    make(None, EmbroideryParams(text="a\u4e2d", text_size=10.0), progress)
    assert "\u4e2d" in str(progress.warnings[0])
    with pytest.raises(TambourError):
        make(None, EmbroideryParams(text="  "), Progress())
    with pytest.raises(TambourError):
        make(None, EmbroideryParams(), Progress())


def middles(made):
    """The middle of each region's box, in the order of the letters."""
    return np.array([(r.paths.coords.min(0) + r.paths.coords.max(0)) / 2 for r in made.regions])


@pytest.mark.parametrize("font", [None, "columns"])
@pytest.mark.parametrize("arc", [40.0, -40.0])
def test_letters_stand_on_a_circle_or_hang_in_it(arc, font):
    params = EmbroideryParams(text="OOOOO", text_size=10.0, text_arc=arc, font=font, order="file", min_length=0.0)
    made = middles(make(None, params, Progress()))
    turn, x = made - made[2], (made - made[2])[:, 0]
    assert (np.diff(x) > 0).all() and np.allclose(x, -x[::-1], atol=0.05)  # read from left to right, symmetrical
    assert (np.sign(turn[[0, 1, 3, 4], 1]) == np.sign(arc)).all()  # down from a top, up from a bottom
    # The letters' middles lie on one circle, half a letter outside the baseline's, or inside it.
    (a, b), (c, d) = made[0] - made[2], made[4] - made[2]
    chord, rise = (c - a) / 2, abs(b + d) / 2
    assert (chord**2 + rise**2) / (2 * rise) == pytest.approx(abs(arc) + np.sign(arc) * 5, abs=0.25)
    with pytest.raises(TambourError, match="circle"):
        make(None, params.model_copy(update={"text_arc": np.sign(arc) * 6.0}), Progress())


def test_letters_stand_on_a_line_of_the_drawing(tmp_path):
    (tmp_path / "a.svg").write_text(
        '<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="100mm" viewBox="0 0 100 100">'
        '<rect width="100" height="100" fill="#eee"/>'
        '<path d="M10 90 L90 10" data-tambour-role="baseline" fill="none" stroke="red"/></svg>'
    )
    drawing = files.read(tmp_path / "a.svg", ("Drawing",))
    made = make(drawing, EmbroideryParams(text="OOO", text_size=8.0, order="file", keep_hidden=True), Progress())
    assert len(made.regions) == 4  # the line itself is not sewn
    step = np.diff(middles(made)[1:], axis=0)
    assert np.allclose(step[:, 1], -step[:, 0], atol=0.02) and (step[:, 0] > 3).all()
    with pytest.raises(TambourError, match="2 lines of text"):
        make(drawing, EmbroideryParams(text="O\\nO"), Progress())


def test_the_face_of_columns_has_every_letter_and_sews_each_stroke_as_one():
    for char in string.ascii_letters + string.digits + ".,:;!?'\"-+=/()&@#*_" + "äéñçÖåž":
        strokes = letter(char)
        assert strokes is not None, char
        assert all(np.isfinite(line).all() and len(line) > 1 for line in strokes.lines)
    for size, kinds in ((15.0, {"satin"}), (2.9, {"running"})):
        made = make(None, EmbroideryParams(text="Hn8", text_size=size, font="columns"), Progress())
        assert {r.stitch for r in made.regions} == kinds
        assert facts(made)["height_mm"] == pytest.approx(size, rel=0.06)
    progress = Progress()
    make(None, EmbroideryParams(text="a\u4e2d", font="columns"), progress)
    assert "\u4e2d" in str(progress.warnings[0])


RAILS = 'inkstitch:satin_column="True" fill="none" stroke="#0a0"'


def stitch_font(folder, **told):
    """A font as Ink/Stitch keeps it: A is a column with rungs longer than its rails, B a dashed line that is sewn whole."""
    given = {
        "name": "Two",
        "leading": 60,
        "horiz_adv_x": {"A": 30.0},
        "horiz_adv_x_default": 40.0,
        "horiz_adv_x_space": 20.0,
    }
    given |= {"kerning_pairs": {"A B": 4.0}, "min_scale": 0.8, "max_scale": 1.2, "default_variant": "ltr", **told}
    (folder / "font.json").write_text(json.dumps(given))
    (folder / "ltr.svg").write_text(
        '<svg xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape"'
        ' xmlns:sodipodi="http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd" xmlns:inkstitch="http://inkstitch.org/namespace"'
        ' width="100" height="100" viewBox="0 0 100 100"><sodipodi:namedview>'
        '<sodipodi:guide position="0,30" orientation="0,1" inkscape:label="baseline"/></sodipodi:namedview>'
        '<g inkscape:groupmode="layer" inkscape:label="GlyphLayer-A" style="display:none">'
        f'<path d="M2 70 L2 60 M26 70 L26 60 M0 64 L28 64 M0 67 L28 67 M0 61 L28 61" {RAILS}/></g>'
        '<g inkscape:groupmode="layer" inkscape:label="GlyphLayer-B" style="display:none">'
        '<path d="M2 70 L2 40" inkstitch:running_stitch_length_mm="2" fill="none" stroke="#00a" stroke-dasharray="1 1"/></g></svg>'
    )
    return folder / "font.json"


def test_a_font_of_ink_stitch_is_read_and_set(tmp_path):
    font = files.read(stitch_font(tmp_path), ("Font",))
    px = 25.4 / 96
    assert set(font.letters) == {"A", "B"} and font.capital == pytest.approx(20 * px)  # the median of A's and B's
    progress = Progress()
    made = make(None, EmbroideryParams(text="AB b", text_size=font.capital, font=font, order="file"), progress)
    a, b = made.regions[:2]
    assert (a.role, a.stitch, b.stitch) == ("rails", "satin", "running") and not progress.warnings
    assert len(b.paths) == 1  # dashes are only how it is shown
    x = [r.paths.coords[:, 0].min() / px for r in made.regions]
    assert x[1] - x[0] == pytest.approx(30 - 4 + 2, abs=0.05)  # A reaches from its rungs' end at 0; B begins at 2
    assert x[2] - x[1] == pytest.approx(40 + 20, abs=0.05)  # a small letter that is missing takes the capital
    assert made.regions[0].paths.coords[:, 1].max() == pytest.approx(
        b.paths.coords[:, 1].max(), abs=0.05
    )  # one baseline
    # Side to side across the rails, 24 px apart: the rungs are the longer lines, and are none.
    wide = np.hypot(*np.diff(made.plan.xy[made.kind == SATIN], axis=0).T)
    assert np.median(wide) == pytest.approx(24 * px + 2 * made.params.pull, abs=0.2)
    make(None, EmbroideryParams(text="A", text_size=30.0, font=font), progress)
    assert "made for" in str(progress.warnings[-1])


@pytest.mark.parametrize("broken", ["[]", "{", '{"leading": "wide"}', '{"kerning_pairs": [1]}'])
def test_broken_fonts_of_ink_stitch_are_one_line(tmp_path, broken):
    stitch_font(tmp_path).write_text(broken)
    with pytest.raises(TambourError, match=r"font\.json"):
        files.read(tmp_path / "font.json", ("Font",))
    stitch_font(tmp_path)
    (tmp_path / "ltr.svg").unlink()
    with pytest.raises(TambourError, match="no letters"):
        files.read(tmp_path / "font.json", ("Font",))


def picture():
    y, x = np.mgrid[0:120, 0:160] / 120.0
    rgb = np.full((120, 160, 3), 250, np.uint8)
    rgb[np.hypot(x - 0.6, y - 0.5) < 0.35] = (200, 60, 40)
    rgb[np.hypot(x - 0.6, y - 0.5) < 0.12] = (20, 40, 120)
    return Picture(np.dstack([rgb, np.full((120, 160), 255, np.uint8)]))


def test_a_picture_has_a_straight_rim():
    """Where two colours meet there, and at its corners; islands stay inside."""
    y, x = np.mgrid[0:400, 0:500] / 5 + 0.1  # mm
    rgb = np.where((x < 40 + 3 * np.sin(y / 4))[..., None], (200, 60, 40), (240, 240, 230)).astype(np.uint8)
    rgb[np.hypot(x - 20, y - 20) < 3] = (20, 40, 120)
    made = traced(
        Picture(np.dstack([rgb, np.full((400, 500), 255, np.uint8)])), EmbroideryParams(width=100.0, colors=3)
    )
    parts = made.paths.parts
    areas = [
        shapely.Polygon(made.paths[int(a)], [made.paths[i] for i in range(int(a) + 1, int(b))])
        for a, b in pairwise(parts)
    ]
    assert len(areas) == 3 and all(a.is_valid for a in areas)
    whole = shapely.union_all(areas, grid_size=1e-6)
    assert whole.symmetric_difference(shapely.box(0, 0, 100, made.size[1])).area < 1e-3


def test_a_picture_becomes_its_areas_on_cloth():
    made = traced(picture(), EmbroideryParams(width=80.0, colors=3))
    colors = made.styles.fill[made.style][:, :3].astype(int)
    assert len(made) == 2 and abs(colors - [[200, 60, 40], [20, 40, 120]]).max() < 12
    parts = made.paths.parts
    disc = shapely.Polygon(made.paths[int(parts[0])], [made.paths[i] for i in range(int(parts[0]) + 1, int(parts[1]))])
    r = 80 / 160 * 120
    assert disc.area == pytest.approx(np.pi * ((0.35 * r) ** 2 - (0.12 * r) ** 2), rel=0.05)
    told = facts(make(picture(), EmbroideryParams(width=60.0, colors=3, row_spacing=1.0), Progress()))
    assert told["color_changes"] == 1 and told["width_mm"] == pytest.approx(60 * 0.35 * 2 * 0.75, rel=0.05)


def test_outlines_of_a_mask_enclose_its_cells():
    mask = np.random.Generator(np.random.PCG64(3)).random((14, 17)) < 0.5
    area = sum(
        0.5 * float((p[:, 0] * np.roll(p[:, 1], -1) - np.roll(p[:, 0], -1) * p[:, 1]).sum()) for p in outlines(mask)
    )
    assert area == mask.sum()
    assert sum(len(p) for p in outlines(mask)) == (
        np.abs(np.diff(np.pad(mask, 1).astype(int), axis=0)).sum()
        + np.abs(np.diff(np.pad(mask, 1).astype(int), axis=1)).sum()
    )


def test_a_see_through_picture_has_nothing_to_sew():
    with pytest.raises(TambourError):
        make(Picture(np.zeros((20, 20, 4), np.uint8)), EmbroideryParams(), Progress())


def faces():
    """Three typefaces: the shipped one in two weights, and the one that Pillow carries."""
    from PIL import ImageFont

    held = ImageFont.load_default(20).path
    return {"regular": font_bytes(False), "bold": font_bytes(True), "pillow": held.getvalue()}


def sewn(letters, face, size):
    made = make(None, EmbroideryParams(text=letters, text_size=size, font=Font(face)), Progress())
    assert (made.kind == SATIN).any() or (made.kind == RUNNING).any(), (letters, size)


@pytest.mark.parametrize("size", [4.0, 15.0])
@pytest.mark.parametrize("face", ["regular", "bold", "pillow"])
@pytest.mark.slow
def test_letters_that_once_broke_are_sewn(face, size):
    sewn("Bft#&X", faces()[face], size)


@pytest.mark.slow
@pytest.mark.parametrize("size", [4.0, 6.0, 10.0, 15.0, 25.0])
@pytest.mark.parametrize("face", ["regular", "bold", "pillow"])
def test_every_letter_of_three_faces_is_sewn(face, size):
    """By day each letter at two of the five sizes, others for each face; by night at all."""
    data = faces()[face]
    step = 1 if NIGHT else 3
    begin = (4, 6, 10, 15, 25).index(int(size)) + len(face)
    for char in (string.ascii_letters + string.digits + "&#?!@%")[begin % step :: step]:
        sewn(char, data, size)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(4))
def test_satin_of_any_shape_is_thread(seed):
    """Blots of discs and bars, with holes and necks: columns or what they leave, never a fault."""
    draw = np.random.default_rng(seed)
    for _ in range(8):
        at, size = draw.uniform(0, 20, (6, 2)), draw.uniform(0.3, 5, 6)
        shapes = [shapely.Point(p).buffer(r) for p, r in zip(at[:3], size)]
        shapes += [shapely.LineString([a, b]).buffer(0.3 * r) for a, b, r in zip(at, np.roll(at, 1, 0), size)]
        area = shapely.union_all(shapes).difference(shapely.Point(at[4]).buffer(1.0))
        rings = [np.array(r.coords) for p in shapely.get_parts(area) for r in (p.exterior, *p.interiors)]
        paths = Paths.of(rings)
        drawing = Drawing(
            Paths(paths.coords, paths.offsets, np.array([0, len(rings)])),
            np.zeros(1),
            Styles.of(((0, 0, 0, 255), None, 0.0)),
            np.array([30.0, 30.0]),
        )
        made = make(drawing, EmbroideryParams(stitch="satin", width=40.0), Progress())
        assert len(made.plan) > 10


@pytest.mark.slow
def test_traced_pictures_are_rows_not_ways(root):
    """Few short stitches, few long ways (turns from row to row left out), and none below the least."""
    source = files.read(root / "examples" / "embroidery" / "bear.jpg", ("Picture",))
    made = make(source, EmbroideryParams(colors=5, width=60.0), Progress())
    end = np.flatnonzero(made.plan.command[1:] == 0) + 1
    size = np.hypot(*(made.plan.xy[end] - made.plan.xy[end - 1]).T)
    rows = (made.kind[end] != LOCK) & (size > 1e-9)
    assert (size[rows] < 0.4).mean() < 0.05
    assert (size[rows] < 0.3 - 1e-9).mean() < 0.001
    assert size[(made.kind[end] == TRAVEL) & (size > 0.8)].sum() < 0.10 * size.sum()


def test_the_bar_of_an_h_lies_below_one_stem_and_ends_at_the_other():
    piece = make(None, EmbroideryParams(text="H", text_size=25, pull=0, pull_percent=0), Progress())
    end = np.flatnonzero((piece.plan.command[1:] == STITCH) & (piece.kind[1:] == SATIN)) + 1
    a, b = piece.plan.xy[end - 1], piece.plan.xy[end]
    bar = (np.abs(a - b)[:, 1] > 2) & (np.abs(a - b)[:, 0] < 1)  # its stitches run up and down, the stems' to and fro
    x = np.abs((a + b)[bar, 0] / 2)
    inner = np.abs(a[~bar, 0]).min()  # where the stems begin
    left, right = (x[(a + b)[bar, 0] * sign > 0].max() for sign in (-1, 1))
    assert min(left, right) < inner + 0.6 and max(left, right) > inner + 1


@pytest.mark.parametrize("paint", ['fill="none"', 'fill="none" stroke="#000"', 'style="fill:none;stroke:none"', ""])
def test_text_stands_on_a_line_that_nobody_sees_too(tmp_path, paint):
    path = f'<path d="M10 80 Q100 0 190 80" {paint} data-tambour-role="baseline"/>'
    box = 'xmlns="http://www.w3.org/2000/svg" viewBox="0 0 200 100" width="200mm" height="100mm"'
    (tmp_path / "a.svg").write_text(f'<svg {box}>{path}<circle cx="100" cy="80" r="10"/></svg>')
    drawing = files.read(tmp_path / "a.svg", ("Drawing",))
    letters = make(drawing, EmbroideryParams(text="OOO", text_size=12), Progress()).regions
    tops = [float(r.paths.coords[:, 1].min()) for r in letters if "letter" in r.flags]
    dot = next(r for r in letters if "letter" not in r.flags)
    assert len(letters) == 4 and max(tops) < float(dot.paths.coords[:, 1].min())  # above the dot, on the arch


@pytest.mark.parametrize("size, told", [(2.5, True), (3.9, True), (4.1, False), (12, False)])
def test_letters_too_small_to_be_read_are_told_as_text_and_in_a_drawing(tmp_path, size, told):
    progress = Progress()
    make(None, EmbroideryParams(text="abc", text_size=size), progress)
    assert any("few letters can be read" in str(w) for w in progress.warnings) == told
    box = 'xmlns="http://www.w3.org/2000/svg" viewBox="0 0 50 20" width="50mm" height="20mm"'
    (tmp_path / "a.svg").write_text(f'<svg {box}><text x="2" y="15" font-size="{size / 0.7273:.3f}">abc</text></svg>')
    progress = Progress()
    make(files.read(tmp_path / "a.svg", ("Drawing",)), EmbroideryParams(), progress)
    assert any("few letters can be read" in str(w) for w in progress.warnings) == told

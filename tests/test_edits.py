"""Edits: one spelling in every craft, checked, in the report, and made again from it."""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
import pytest

from tambour.core.drawing import Drawing, Styles
from tambour.core.errors import TambourError, Text
from tambour.core.paths import Paths
from tambour.core.picture import Picture
from tambour.run import CRAFTS, craft, make
from test_cli import call


def ramp() -> Picture:
    rgba = np.full((20, 24, 4), 255, np.uint8)
    rgba[..., :3] = np.linspace(0, 255, 24)[None, :, None]
    return Picture(rgba)


def squares() -> Drawing:
    side = np.array([[0, 0], [12, 0], [12, 12], [0, 12], [0, 0]], float)
    paths = Paths.of([side, side + np.array([20.0, 0.0])])
    return Drawing(paths, [0, 1], Styles.of(((200, 0, 0, 255), None, 0), ((0, 0, 200, 255), None, 0)), [32, 12])


def test_every_craft_says_what_can_be_changed() -> None:
    for name in CRAFTS:
        for kind, change in craft(name).changes.items():
            assert change.help and (change.before is None) != (change.after is None), kind
            assert {f"{{{f}}}" for f in change.params.model_fields if f != "edition"} == set(
                re.findall(r"\{\w+\}", change.words)
            )
            _, said = call(f"{name} --help")
            assert f"{kind}:" in " ".join(said.split())


def test_text_and_data_are_one() -> None:
    what = craft("knit")
    (kind, one), (_, other) = what.edits(["stitch:12,30=CC", {"edit": "stitch", "row": 12, "stitch": 30, "yarn": "CC"}])
    assert kind == "stitch" and one == other


@pytest.mark.parametrize(
    ("name", "edit", "said"),
    [
        ("knit", "stich:1,2=CC", 'knit has no edit "stich"'),
        ("knit", "stitch:1,2", "its form is stitch:ROW,STITCH=YARN"),
        ("knit", "stitch:x,2=CC", "--edit stitch:x,2=CC: row"),
        ("knit", {"edit": "stitch", "row": 1, "stitch": 2}, "required"),
        ("knit", {"edit": "stitch", "row": 1, "stitch": 2, "yarn": "MC", "odd": 1}, "no such parameter"),
        ("knit", ["stitch"], 'knit has no edit ""'),
        ("knit", 7, 'knit has no edit ""'),
        ("knit", "stitch:1,2=\x1b[2J", "a control character"),
        ("ink", "leave", "cannot be read"),
        ("crochet", "pose:Arm.1.lean=3", "angle"),
    ],
)
def test_an_edit_that_cannot_be_is_told(name: str, edit: object, said: str) -> None:
    with pytest.raises(TambourError) as caught:
        craft(name).edits([edit])  # type: ignore[list-item]
    text = str(caught.value)
    assert text.startswith("--edit ") and said in text and "\x1b" not in text


def test_a_stitch_is_set_and_counted_as_charts_are() -> None:
    params = craft("knit").params(stitches=24, method="exact")
    plain = make("knit", ramp(), params).piece.chart
    row, stitch = 3, 24  # the leftmost one, dark in the ramp
    code = "#{:02x}{:02x}{:02x}".format(*plain.palette.rgb[1].tolist())
    for yarn in ("2", code):
        made = make("knit", ramp(), params, [f"stitch:{row},{stitch}={yarn}"])
        assert made.piece.chart.cells[2, 0] == 1 != plain.cells[2, 0]
        assert (made.piece.chart.cells[3:] == plain.cells[3:]).all() and (
            made.piece.chart.cells[:2] == plain.cells[:2]
        ).all()
        assert made.edits == [{"edit": "stitch", "row": 3, "stitch": 24, "yarn": yarn}]
        assert made.piece.figures["conflicts"] == 0
    main = make("knit", ramp(), params, ["stitch:3,24=MC"]).piece
    other = make("knit", ramp(), params, ["stitch:3,24=CC"]).piece
    assert main.chart.cells[2, 0] == main.background != other.chart.cells[2, 0]
    for wrong in ("stitch:99,1=MC", "stitch:1,25=MC", "stitch:1,1=red", "stitch:1,1=3"):
        with pytest.raises(TambourError, match="--edit stitch"):
            make("knit", ramp(), params, [wrong])


def test_a_region_is_stitched_another_way() -> None:
    plain = make("embroidery", squares(), craft("embroidery").params()).piece
    made = make(
        "embroidery", squares(), craft("embroidery").params(), ["region:2.angle=45", "region:2.stitch=contour"]
    ).piece
    assert plain.regions[1].params.angle != 45 and plain.regions[1].stitch != "contour"
    first, second = made.regions
    assert (first.params.angle, first.stitch) == (plain.regions[0].params.angle, plain.regions[0].stitch)
    assert (second.params.angle, second.stitch) == (45, "contour")
    # Reports and the studio call a shape without an id by its number.
    named = f"region:{plain.regions[1].id}.stitch=contour"
    again = make("embroidery", squares(), craft("embroidery").params(), [named, named]).piece
    assert [r.stitch for r in again.regions] == [plain.regions[0].stitch, "contour"]
    for wrong in ("region:3.angle=45", "region:1.angel=45", "region:1.angle=x", "region:1.font=a.ttf"):
        with pytest.raises(TambourError, match="--edit region"):
            make("embroidery", squares(), craft("embroidery").params(), [wrong])


def test_a_whole_is_left_out() -> None:
    params = craft("ink").params(seed="7", span=1500)
    piece = make("ink", None, params).piece
    gone = piece.planned[len(piece.planned) // 2].id
    made = make("ink", None, params, [f"leave:{gone}"]).piece
    assert [p.id for p in made.planned] == [p.id for p in piece.planned if p.id != gone]
    assert made.polygons < piece.polygons
    with pytest.raises(TambourError, match="--edit leave:hill-nowhere: stands nowhere here"):
        make("ink", None, params, ["leave:hill-nowhere"])


def test_a_part_is_posed_as_by_params(root: Path) -> None:
    source = Text((root / "examples/crochet/bear.acl").read_text(), "bear.acl")
    what = craft("crochet")
    made = make("crochet", source, what.params(solver="none"), ["pose:Arm.1.tilt=40", "pose:Arm.1.towards=20"]).piece
    old = make("crochet", source, what.params(solver="none", pose=("Arm.1 tilt=40 towards=20",))).piece
    plain = make("crochet", source, what.params(solver="none")).piece
    assert (made.positions == old.positions).all() and not (made.positions == plain.positions).all()
    with pytest.raises(TambourError, match=r"--edit pose: no part"):
        make("crochet", source, what.params(solver="none"), ["pose:Wing.tilt=40"])


def test_edits_are_in_the_report_and_made_again(tmp_path: Path) -> None:
    words = f"ink --seed 7 --span 900 -o {tmp_path}/a.json"
    assert call(words)[0] == 0
    ids = [w["id"] for w in json.loads((tmp_path / "a.json").read_text())["wholes"]]
    (tmp_path / "e.json").write_text(json.dumps([{"edit": "leave", "whole": ids[0]}]))
    code, said = call(f"{words} --edits {tmp_path}/e.json --edit leave:{ids[1]} --report {tmp_path}/r.json")
    assert code == 0, said
    first = (tmp_path / "a.json").read_bytes()
    assert [w["id"] for w in json.loads(first)["wholes"]] == ids[2:]
    report = json.loads((tmp_path / "r.json").read_text())
    assert report["edits"] == [{"edit": "leave", "whole": w} for w in ids[:2]]
    (tmp_path / "a.json").unlink()
    assert call(f"run {tmp_path}/r.json")[0] == 0 and (tmp_path / "a.json").read_bytes() == first
    assert call(f"{words} --edits {tmp_path}/r.json")[0] == 0 and (tmp_path / "a.json").read_bytes() == first


@pytest.mark.parametrize("text", ["", "{}", '{"edits": 7}', "7", "[" * 10_000, "\xff"])
def test_what_is_no_list_of_edits_is_told(text: str, tmp_path: Path) -> None:
    (tmp_path / "e.json").write_text(text, encoding="latin-1")
    code, said = call(f"ink --edits {tmp_path}/e.json")
    assert code == 2 and "this is no list of edits" in said, said
    assert call(f"ink --edits {tmp_path}/none.json")[0] == 2


def test_a_yarn_takes_another_colour_and_the_chart_stays() -> None:
    from tambour.core.picture import Picture

    rgba = np.full((20, 24, 4), 255, np.uint8)
    rgba[6:14, 8:16, :3] = 0
    plain = make("knit", Picture(rgba)).piece.chart
    piece = make("knit", Picture(rgba), edits=["yarn:MC=poppy", "yarn:CC=#102030"]).piece
    assert (piece.chart.cells == plain.cells).all()
    assert piece.chart.palette.rgb.tolist() == [[0x10, 0x20, 0x30], [0xC6, 0x28, 0x28]]
    with pytest.raises(TambourError, match="no such yarn") as told:
        make("knit", Picture(rgba), edits=["yarn:CC9=popy"])
    assert len(told.value.problems) == 2


def test_a_yarn_is_recoloured_while_it_is_made_as_by_an_edit() -> None:
    from tambour.core.picture import Picture
    from tambour.knit.params import KnitParams

    rgba = np.full((20, 30, 4), 255, np.uint8)
    rgba[5:15, 10:20, :3] = 0
    edited = make("knit", Picture(rgba), edits=["yarn:MC=poppy", "yarn:CC=#102030"]).piece.chart
    told = make("knit", Picture(rgba), KnitParams(yarn=("poppy=MC", "#102030=CC"))).piece.chart
    assert told.plain() == edited.plain()
    with pytest.raises(TambourError, match="no such yarn"):
        make("knit", Picture(rgba), KnitParams(yarn=("#102030=CC9",)))
    with pytest.raises(ValueError, match="#aa3322=MC"):
        make("knit", Picture(rgba), KnitParams(yarn=("MC",)))

"""What a hand says of regions: where one is begun and ended, its rails, what comes after it, the order of sewing."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from tambour.core.errors import TambourError
from tambour.embroidery.piece import Piece
from tambour.run import craft, make

WHAT = craft("embroidery")
SQUARES = (
    '<svg xmlns="http://www.w3.org/2000/svg" width="60mm" height="30mm" viewBox="0 0 60 30">'
    '<path id="red" d="M2 5h14v14h-14z" fill="#b03030"/><path id="blue" d="M20 5h14v14h-14z" fill="#3030b0"/>'
    '<path id="gold" d="M40 5h14v14h-14z" fill="#b09030"/></svg>'
)


@pytest.fixture
def drawing(tmp_path: Path) -> Path:
    (tmp_path / "squares.svg").write_text(SQUARES)
    return tmp_path / "squares.svg"


def sewn(drawing: Path, *edits: str) -> Piece:
    piece: Piece = make(WHAT, drawing, WHAT.params.of({}), edits).piece
    return piece


def sequence(piece: Piece) -> list[str]:
    """Ids of regions in the order that they are sewn in."""
    first = [int(np.flatnonzero(piece.region == k)[0]) for k in range(len(piece.regions))]
    return [piece.regions[k].id for k in np.argsort(first)]


def own(piece: Piece, name: str) -> np.ndarray:
    from tambour.core.thread import STITCH

    k = [r.id for r in piece.regions].index(name)
    return piece.plan.xy[(piece.region == k) & (piece.plan.command == STITCH)]


def test_regions_are_sewn_in_the_order_that_is_said(drawing):
    assert sequence(sewn(drawing, "order:gold | red | blue")) == ["gold", "red", "blue"]
    assert sequence(sewn(drawing, "order:blue|gold|red")) == ["blue", "gold", "red"]
    plain = sequence(sewn(drawing))
    assert sequence(sewn(drawing, f"order:{plain[2]}|{plain[0]}")) == [plain[2], plain[1], plain[0]]
    with pytest.raises(TambourError, match="no such region"):
        sewn(drawing, "order:green|red")


def test_who_is_sewn_before_what_it_lies_on_is_told(tmp_path):
    (tmp_path / "on.svg").write_text(SQUARES.replace("M20 5", "M8 8"))
    what, params = WHAT, WHAT.params.of({})
    said = make(what, tmp_path / "on.svg", params, ["order:blue|red|gold"]).progress.warnings
    assert any("blue lies on red" in w.message for w in said)
    fine = make(what, tmp_path / "on.svg", params, ["order:gold|red|blue"]).progress.warnings
    assert not any("lies on" in w.message for w in fine)


@pytest.mark.parametrize("corner", [(-1, -1), (1, -1), (1, 1), (-1, 1)])
def test_a_region_begins_and_ends_where_it_is_said(drawing, corner):
    usual = own(sewn(drawing), "blue")
    low, high = usual.min(0), usual.max(0)
    at = np.where(np.array(corner) > 0, high, low)
    across = low + high - at
    told = [f"region:blue.start={at[0]:.2f},{at[1]:.2f}", f"region:blue.end={across[0]:.2f},{across[1]:.2f}"]
    piece = make(WHAT, drawing, WHAT.params.of({}), told)
    made = own(piece.piece, "blue")
    assert np.hypot(*(made[0] - at)) < 2.5 and np.hypot(*(made[-1] - across)) < 2.5
    assert not any("asked to" in w.message for w in piece.progress.warnings)


def test_a_place_that_the_rows_do_not_lead_to_is_told(drawing):
    said = make(WHAT, drawing, WHAT.params.of({}), ["region:blue.end=60,60"]).progress.warnings
    assert any("blue does not end where it was asked to" in w.message for w in said)


def test_rails_make_a_satin_column_between_them(drawing):
    made = sewn(drawing, "region:red.rails=-25,-6 -15,-6; -25,6 -20,3 -15,6")
    region = next(r for r in made.regions if r.id == "red")
    assert (region.role, region.stitch) == ("rails", "satin") and len(region.paths) == 2
    xy = own(made, "red")
    assert xy[:, 1].min() < -5.5 and xy[:, 1].max() > 5.0
    middle = xy[np.abs(xy[:, 0] + 20) < 0.6]
    assert middle[:, 1].max() < 4.2  # the lower rail bends in there


def test_stops_and_cuts_after_a_region(drawing):
    plain, stopped = sewn(drawing), sewn(drawing, "region:blue.stop=true", "region:red.trim=true")
    from tambour.core.thread import STOP

    assert (plain.plan.command == STOP).sum() == 0 and (stopped.plan.command == STOP).sum() == 1


@pytest.mark.parametrize(
    "edit", ["region:red.start=here", "region:red.rails=1,2 3,4", "region:red.end=1e9,0", "region:red.start=nan,1"]
)
def test_what_is_no_place_is_told(drawing, edit):
    with pytest.raises(TambourError, match=r"no place|two rails"):
        sewn(drawing, edit)


def test_shapes_of_one_group_have_names_of_their_own(tmp_path):
    """What reports and the studio call a shape is what an edit changes, before and after it, and the group's id means all."""
    import re

    (tmp_path / "group.svg").write_text(
        re.sub(r' id="\w+"', "", SQUARES).replace("<path", '<g id="color"><path', 1).replace("</svg>", "</g></svg>")
    )
    drawing = tmp_path / "group.svg"
    names = ["color/1", "color/2", "color/3"]

    def stitches(*edits: str) -> list[str]:
        regions = sewn(drawing, *edits).regions
        assert [r.id for r in regions] == names
        return [r.stitch for r in regions]

    fill = stitches()[0]
    assert stitches("region:color/2.stitch=contour") == [fill, "contour", fill]
    twice = stitches("region:color/2.stitch=contour", "region:color/2.angle=30", "region:3.stitch=spiral")
    assert twice == [fill, "contour", "spiral"]
    assert stitches("region:color.stitch=contour") == ["contour"] * 3
    assert sequence(sewn(drawing, "order:color/3|color/1|color/2")) == ["color/3", "color/1", "color/2"]

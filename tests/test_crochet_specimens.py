"""Specimens: every stitch as a small piece that anybody can ask for; and the left hand, which works all in the mirror."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tambour.core.errors import TambourError, Text
from tambour.core.graph import BACK, FRONT
from tambour.core.progress import Progress
from tambour.crochet import handed
from tambour.crochet.graph.build import build
from tambour.crochet.language.parse import parse
from tambour.crochet.language.stitches import BUMPS, HEIGHTS
from tambour.crochet.page.diagram import diagram
from tambour.crochet.params import CrochetParams
from tambour.crochet.plush import make
from tambour.crochet.specimens import TABLE, text
from tambour.crochet.swatches import sheet
from tambour.crochet.yarn import lead

BALL = "@stuffing = firm\n: MR(6)\n: 6 inc (12)\n: [sc, inc] x 6 (18)\n: BLO, 18 sc (18)\n: 18 sc\n: [sc, dec] x 6 (12)\n: 6 dec (6)\nFO\n"


@pytest.mark.parametrize("name", TABLE)
def test_a_specimen_is_worked_and_shows_its_stitch(name: str) -> None:
    built = build(parse(Text(text(name))))
    assert all("approximated" in w.message for w in built.warnings), built.warnings
    if name in HEIGHTS or name in BUMPS or name in ("picot", "crab", "spike", "loopst", "fur", "fpdc", "bpdc"):
        assert name in [built.graph.kinds[k] for k in built.graph.kind]


def test_all_specimens_are_one_pattern_with_a_part_for_each() -> None:
    built = build(parse(Text(text("all"))))
    assert len(built.graph.parts) == len(TABLE)


@pytest.mark.slow
def test_the_sheet_names_what_it_shows() -> None:
    drawing = sheet(make(None, CrochetParams(specimen="ch", detail="low"), Progress()))
    assert {label.text for label in drawing.labels} == {"ch", "chain"}
    assert len(drawing.images) == 1


def test_what_no_specimen_is_and_what_needs_one() -> None:
    with pytest.raises(ValueError, match='no specimen "bobbel"'):
        CrochetParams(specimen="bobbel")
    with pytest.raises(TambourError, match="needs no pattern"):
        make(Text(BALL), CrochetParams(specimen="sc"), Progress())
    with pytest.raises(TambourError, match="needs a source"):
        make(None, CrochetParams(), Progress())


def test_a_stitch_around_a_post_stands_before_the_fabric_or_behind_it() -> None:
    """A fifth of a stitch before the others it was lost among their ropes."""
    ahead = {}
    for name in ("fpdc", "bpdc"):
        graph = build(parse(Text(text(name)))).graph
        led = lead.way(graph, "over")
        inside = (led.at[:, 1] > 0.2) & (led.at[:, 1] < 1.0)
        for kind in (name, "dc"):
            own = led.at[inside & (graph.kind[led.cell] == graph.kinds.index(kind))]
            ahead[kind] = float(own[:, 2].mean())
        assert abs(ahead[name] - ahead["dc"]) > 0.25 and (ahead[name] > ahead["dc"]) == (name == "fpdc")


def test_popcorns_are_no_bobbles() -> None:
    """A popcorn's whole stitches show their tops in front: its yarn stands out more, and there is more of it."""
    graph = [build(parse(Text(text(name)))).graph for name in ("bobble", "popcorn")]
    led = [lead.way(g) for g in graph]
    far = [float(np.abs(way.at[:, 2]).max()) for way in led]
    assert far[1] > 1.15 * far[0]
    assert len(led[1].cell) > len(led[0].cell)


@pytest.mark.parametrize("name, times", [("rows", 0), ("hdc", 0), ("dc", 1), ("tr", 2)])
def test_a_tall_stitch_shows_its_yarn_overs_across_its_post(name: str, times: int) -> None:
    """A double is told from a treble by them: so often the yarn comes out furthest in front of the post, above its foot."""
    graph = build(parse(Text(text(name)))).graph
    led = lead.way(graph)
    kind = "sc" if name == "rows" else name
    for i in np.flatnonzero(graph.kind == graph.kinds.index(kind))[:8].tolist():
        w = led.at[led.cell == i, 2]
        assert int(((w[1:-1] > 0.45) & (w[1:-1] > w[:-2]) & (w[1:-1] > w[2:])).sum()) == times


def test_the_loop_that_front_loops_leave_free_stands_out_inside() -> None:
    graph = build(parse(Text(text("flo")))).graph
    led = lead.way(graph)
    free = np.zeros(len(graph), np.bool_)
    free[graph.parent[graph.loop == FRONT]] = True
    worked = np.flatnonzero(graph.kind == graph.kinds.index("sc"))

    def deepest(above: float) -> np.ndarray:
        return np.array([led.at[(led.cell == i) & (led.at[:, 1] > above), 2].min() for i in worked.tolist()])

    heads, free = deepest(0.9), free[worked]
    assert free.sum() >= 50
    # A fifth of a stitch further in than other heads lie, a yarn's width; and before the bumps below those, which are what else is seen inside (but for where the yarn ends).
    assert heads[free].max() < -0.5 and heads[~free].min() > -0.31
    assert heads[free].max() < np.quantile(deepest(-1.0)[~free], 0.05) - 0.05


def test_the_left_hand_makes_the_mirror_image() -> None:
    right, left = (make(Text(BALL), CrochetParams(hand=hand), Progress()) for hand in ("right", "left"))
    graph = left.built.graph
    np.testing.assert_array_equal(left.positions, right.positions * (-1, 1, 1))
    # The outside stays outside: faces turn around with the mirror.
    a, b, c = (left.positions[graph.faces[:, k]] for k in range(3))
    assert np.einsum("ij,ij->", a, np.cross(b, c)) > 0
    own = graph.plane[(graph.loop == BACK) & (graph.plane.min(1) >= 0)]
    for here, there in zip(own, right.built.graph.plane[(graph.loop == BACK) & (graph.plane.min(1) >= 0)]):
        assert here.tolist() == there[[0, 2, 1]].tolist()
    # The yarn follows, point for point.
    np.testing.assert_array_equal(left.yarn.paths.coords, right.yarn.paths.coords * (-1, 1, 1))
    np.testing.assert_array_equal(left.yarn.radius, right.yarn.radius)


def test_a_picture_of_the_left_hands_piece_is_the_mirror_image_of_the_right_hands() -> None:
    """Single stitches lay out of line otherwise, and the window was on the same side of both."""
    right, left = (make(Text(BALL), CrochetParams(hand=hand, detail="low"), Progress()) for hand in ("right", "left"))
    np.testing.assert_array_equal(handed.whole(left).rgba, handed.whole(right).rgba[:, ::-1])
    np.testing.assert_array_equal(handed.left(left).rgba, handed.right(right).rgba[:, ::-1])


def test_charts_for_the_left_hand_go_clockwise_and_their_numbers_stay_readable() -> None:
    built = build(parse(Text(BALL)))
    right, left = diagram(built), diagram(built, left=True)
    assert left.size.tolist() == right.size.tolist()
    patches = [left.paths[i].mean(0) for i in np.flatnonzero(left.styles.fill[left.style, 3] > 0)[:6]]
    middle = np.mean(patches, axis=0)
    angles = np.unwrap([math.atan2(-(y - middle[1]), x - middle[0]) for x, y in patches])
    assert (np.diff(angles) < 0).all()
    numbers = [[(label.text, round(label.y, 3)) for label in d.labels if label.text.isdigit()] for d in (right, left)]
    assert numbers[0] == numbers[1]


@pytest.mark.parametrize("name", ["ch", "hdc", "crab", "granny"])
def test_yarn_is_led_through_a_specimen(name: str) -> None:
    graph = build(parse(Text(text(name)))).graph
    led = lead.way(graph)
    worked = set(np.flatnonzero(lead.roles(graph)).tolist())
    assert worked <= set(led.cell.tolist()) and np.isfinite(led.at).all()

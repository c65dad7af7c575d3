"""Charts: every stitch once, counter-clockwise, increases as legs from one place."""

import math
from itertools import pairwise

import numpy as np
import pytest

from tambour.core.errors import Text
from tambour.crochet.graph.build import build
from tambour.crochet.language.parse import parse
from tambour.crochet.page.chart import Chart, charts
from tambour.crochet.page.diagram import CELL, diagram
from tambour.crochet.page.symbols import NAMES, post, strokes

BALL = ": MR(6)\n: 6 inc (12)\n: [sc, inc] x 6 (18)\n: [sc, dec] x 6 (12)\n: 6 dec (6)\nFO\n"
ROWS = ": ch 9, turn\n: 8 sc\n: turn, ch, 8 sc\n: turn, ch 2, [dcinc, dc] x 4\n"
BRANCHED = ": MR(6)\n: 6 inc\nmark(a)\n: BLO, 6 dec\nFO\ngoto(a)\n: FLO, 12 inc\n"


def made(text):
    return build(parse(Text(text, "toy.acl")))


@pytest.mark.parametrize("text", [BALL, ROWS, BRANCHED])
def test_every_stitch_stands_in_one_chart(text):
    built = made(text)
    own = [n for chart in charts(built) for n in chart.cells if n not in chart.base]
    virtual = {built.graph.kinds.index(k) for k in ("ring", "tip") if k in built.graph.kinds}
    stitches = [n for n in range(len(built.graph)) if built.graph.kind[n] not in virtual]
    assert sorted(own) == stitches


def test_rounds_go_counter_clockwise_from_the_centre():
    (chart,) = charts(made(BALL))
    for this in chart.rounds:
        at = [chart.cells[n].at for n in range(this.first, this.last + 1)]
        assert all(b > a for a, b in pairwise(at)) and at[-1] - at[0] < math.tau
    radii = [chart.cells[r.first].low for r in chart.rounds]
    assert radii == sorted(radii)
    # Page coordinates are y down: counter-clockwise as seen is up from the right.
    drawing = diagram(made(": MR(4)\n"))
    patches = [drawing.paths[i].mean(0) for i in np.flatnonzero(drawing.styles.fill[drawing.style, 3] > 0)[:4]]
    middle = np.mean(patches, axis=0)
    angles = np.unwrap([math.atan2(-(y - middle[1]), x - middle[0]) for x, y in patches])
    assert (np.diff(angles) > 0).all()


def test_a_round_lies_over_the_stitches_it_is_worked_into():
    built = made(BALL)
    (chart,) = charts(built)
    for node in range(7, 19):  # increases: half a place beside their anchor
        apart = chart.cells[node].at - chart.cells[int(built.graph.parent[node])].at
        assert abs((apart + math.pi) % math.tau - math.pi) < math.tau / 12


def test_rows_go_back_and_forth():
    (chart,) = charts(made(ROWS))
    assert chart.rows
    ways = [np.sign(chart.cells[r.last].at - chart.cells[r.last - 3].at) for r in chart.rounds]
    assert ways == [1, -1, 1, -1]


def test_the_drawing_holds_all_and_fits_its_sheet():
    for text in (BALL, ROWS, BRANCHED, "", ": MR(1)\n", "== A (make 3) ==\n: MR(5)\n"):
        drawing = diagram(made(text))
        assert (drawing.paths.coords >= 0).all() and (drawing.paths.coords <= drawing.size).all()
        for label in drawing.labels:
            assert 0 <= label.x <= drawing.size[0] and 0 <= label.y <= drawing.size[1]
    assert sum(label.text == "A, make 3" for label in diagram(made("== A (make 3) ==\n: MR(5)\n")).labels) == 1


def test_an_oval_is_drawn_along_its_chain():
    built = made(": oval(12), 10 sc, inc3, 9 sc, inc (24)\n: 24 sc")
    (chart,) = charts(built)
    assert [n for n, cell in chart.cells.items() if cell.line is not None] == list(range(11))
    for this in chart.rounds[1:]:
        cells = [chart.cells[n] for n in range(this.first, this.last + 1)]
        places = [chart.spot(c.at, (c.low + c.high) / 2) for c in cells]
        beside = [*pairwise(places), (places[-1], places[0])]
        gaps = [math.dist(a, b) for a, b in beside]
        assert max(gaps) < 1.35 * min(gaps)
        assert sum(a[0] * b[1] - a[1] * b[0] for a, b in beside) > 0  # counter-clockwise
        for n in range(this.first, this.first + 9):
            under = chart.cells[int(built.graph.parent[n])]
            x = chart.spot(under.at, under.high)[0] if under.line is None else under.line
            assert abs(chart.spot(chart.cells[n].at, 1.0)[0] - x) < 1.0


def test_way_and_at_are_inverse():
    chart = Chart(0, False, half=2.5)
    for up in (0.5, 3.0):
        for at in np.linspace(-3, 20, 47):
            assert abs(chart.at(chart.way(at, up), up) - at) < 1e-9
        step = [math.dist(chart.spot(a, up), chart.spot(a + 1e-6, up)) / 1e-6 for a in (0.3, 2.0, 6.0)]
        assert np.allclose(step, [chart.stretch(a, up) for a in (0.3, 2.0, 6.0)], rtol=1e-4)


def test_symbols():
    assert [len(strokes(k, 1.0)) for k in ("sc", "ch", "hdc", "dc", "tr", "bud", "attach")] == [2, 1, 2, 3, 4, 2, 0]
    assert len({str(strokes(k, 2.0)) for k in NAMES}) >= len(NAMES) - 1  # told from one another
    foot, head = (0.0, 0.0), (0.0, 2.0)
    shaft, top, bar = post(foot, head, 1)
    assert shaft == [foot, head] and top[0][1] == top[1][1] == 2.0 and 0 < bar[0][1] < bar[1][1] < 2
    assert CELL > 0

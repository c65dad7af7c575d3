"""What the cloth does to stitches, and what is sewn against it."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tambour import files
from tambour.core.drawing import Drawing, Styles
from tambour.core.errors import TambourError
from tambour.core.paths import Paths
from tambour.core.progress import Progress
from tambour.core.thread import STITCH
from tambour.embroidery.fabric import FABRICS, MOST, calibrated, widened
from tambour.embroidery.families.rows import swept
from tambour.embroidery.params import EmbroideryParams
from tambour.embroidery.piece import FILL, SATIN
from tambour.embroidery.plan.facts import steps
from tambour.embroidery.plan.make import make

BAR = np.array([[0, 0], [30, 0], [30, 20], [0, 20], [0, 0]], float)
COLUMN = np.array([[0, 0], [30, 0], [30, 4], [0, 4], [0, 0]], float)


def sewn(shape, kind, **params):
    """The stitches (S, 4) of a shape that are of a kind."""
    paths = Paths(shape, np.array([0, len(shape)]), np.array([0, 1]))
    drawing = Drawing(paths, np.zeros(1), Styles.of(((10, 20, 30, 255), None, 0.0)), shape.max(0))
    made = make(drawing, EmbroideryParams(underlay="none", locks=False, **params), Progress())
    xy, end = steps(made)
    return xy[made.kind[end] == kind]


@pytest.mark.parametrize("angle", [0.0, 30.0, 90.0])
def test_rows_are_longer_at_both_ends_and_the_outer_ones_stay_back(angle):
    turn = np.radians(angle)
    along, across = np.array([np.cos(turn), -np.sin(turn)]), np.array([np.sin(turn), np.cos(turn)])
    reach = {}
    for pull, push in ((0.0, 0.0), (0.5, 0.0), (0.0, 0.5)):
        found = sewn(BAR, FILL, stitch="tatami", angle=angle, pull=pull, push=push).reshape(-1, 2)
        reach[pull, push] = np.ptp(found @ along), np.ptp(found @ across)
    (u, v), longer, back = reach[0.0, 0.0], reach[0.5, 0.0], reach[0.0, 0.5]
    assert longer == (pytest.approx(u + 1.0, abs=0.05), pytest.approx(v, abs=0.05))
    assert back[1] == pytest.approx(v - 1.0, abs=0.41)  # to a row
    assert back[0] <= u + 1e-6


def test_a_column_is_wider_along_its_stitches_and_shorter_at_its_ends():
    plain = sewn(COLUMN, SATIN, stitch="satin", pull=0.0, push=0.0)
    pulled = sewn(COLUMN, SATIN, stitch="satin", pull=0.3, pull_percent=5.0, push=0.4)
    size = [float(np.median(np.hypot(*(s[:, 2:] - s[:, :2]).T))) for s in (plain, pulled)]
    assert size[1] - size[0] == pytest.approx(2 * widened(4.0, 0.3, 5.0), abs=0.03)
    # Measured on the middles of stitches: the pull lengthens them across the column only.
    wide = [float(np.ptp((s[:, 0] + s[:, 2]) / 2)) for s in (plain, pulled)]
    assert wide[0] - wide[1] == pytest.approx(0.8, abs=0.25)


def test_no_side_is_drawn_out_by_more_than_a_millimetre():
    assert widened(12.0, 0.5, 30.0) == MOST
    size = [
        np.hypot(*(s[:, 2:] - s[:, :2]).T)
        for s in (sewn(COLUMN, SATIN, stitch="satin", pull=p, pull_percent=q) for p, q in ((0.0, 0.0), (0.9, 30.0)))
    ]
    assert np.median(size[1]) - np.median(size[0]) == pytest.approx(2 * MOST, abs=0.03)


@given(st.floats(0, 0.6), st.floats(0, 20), st.lists(st.integers(6, 120), min_size=2, max_size=8, unique=True))
def test_a_card_gives_back_the_law_it_was_sewn_under(pull, percent, tenths):
    text = ",".join(f"{w / 10}={max(w / 20, w / 10 - 2 * pull - w / 10 * percent / 100):.6f}" for w in tenths)
    if any(2 * pull + w / 10 * percent / 100 > w / 20 for w in tenths):
        return  # shrunk to less than half
    found = calibrated(text)
    assert found["pull"] == pytest.approx(pull, abs=2e-3)
    assert found["pull_percent"] == pytest.approx(percent, abs=0.1)


def test_a_fabric_sets_what_is_not_given():
    towel = EmbroideryParams(fabric="towel")
    assert {k: getattr(towel, k) for k in FABRICS["towel"]} == FABRICS["towel"]
    assert EmbroideryParams(fabric="towel", pull=0.1, knockdown=False).pull == 0.1
    assert not EmbroideryParams(fabric="towel", knockdown=False).knockdown
    assert (
        EmbroideryParams() == EmbroideryParams(fabric="cotton") == EmbroideryParams(**EmbroideryParams().model_dump())
    )
    card = EmbroideryParams(fabric="knit", measured="2=1.7,6=5.5")
    assert (card.pull, card.pull_percent, card.push) == (0.1, 5.0, FABRICS["knit"]["push"])
    with pytest.raises(TambourError, match=r"--measured: .*2=0\.2"):
        EmbroideryParams.of({"measured": "2=0.2"})


def test_a_region_may_lie_on_another_fabric(tmp_path):
    (tmp_path / "a.svg").write_text(
        '<svg xmlns="http://www.w3.org/2000/svg" width="60mm" height="30mm" viewBox="0 0 60 30">'
        '<path id="a" d="M2 2h20v20h-20z"/><path id="b" data-tambour-fabric="knit" d="M30 2h20v20h-20z"/></svg>'
    )
    made = make(files.read(tmp_path / "a.svg", ("Drawing",)), EmbroideryParams(), Progress())
    assert [r.params.pull for r in made.regions] == [FABRICS["cotton"]["pull"], FABRICS["knit"]["pull"]]


def test_the_width_asked_for_is_that_of_the_finished_piece():
    paths = Paths(BAR, np.array([0, len(BAR)]), np.array([0, 1]))
    drawing = Drawing(paths, np.zeros(1), Styles.of(((10, 20, 30, 255), None, 0.0)), BAR.max(0))
    made = make(drawing, EmbroideryParams(width=40.0, pull=0.5, stitch="tatami", angle=0.0), Progress())
    wide = np.ptp(made.plan.xy[made.plan.command == STITCH, 0])
    assert wide == pytest.approx(41.0, abs=0.1)
    with pytest.raises(TambourError, match=r"41\.0 x"):
        make(drawing, EmbroideryParams(width=40.0, pull=0.5, hoop="40x40"), Progress())


def test_what_is_swept_holds_every_step_of_the_way():
    import shapely
    from shapely.affinity import translate

    ring = shapely.Point(0, 0).buffer(10).difference(shapely.Point(2, 1).buffer(4))
    by = np.array([1.5, -0.7])
    found = swept(ring, by)
    steps_of = shapely.union_all([translate(ring, *(by * t)) for t in np.linspace(-1, 1, 400)])
    assert found.symmetric_difference(steps_of).area < 0.02


@pytest.mark.slow
def test_the_card_fits_a_small_hoop_and_is_sewn_as_drawn():
    params = EmbroideryParams(test_card=True, fabric="towel", knockdown=False, hoop="100x100")
    assert (params.pull, params.push) == (0.0, 0.0)
    made = make(None, params, Progress())
    xy, end = steps(made)
    by_name = {r.id: k for k, r in enumerate(made.regions)}
    for width in (1.0, 2.0, 4.0, 6.0):
        mine = xy[(made.region[end] == by_name[f"column {width:g}"]) & (made.kind[end] == SATIN)]
        assert np.median(np.hypot(*(mine[:, 2:] - mine[:, :2]).T)) == pytest.approx(width, abs=0.1)
    assert len(made.plan.threads) == 2


def test_a_fill_goes_on_below_what_is_sewn_over_its_edge():
    import shapely

    from tambour.embroidery.plan.overlap import UNDER
    from tambour.geometry.areas import to_shapely

    shapes = [
        BAR + np.array(at) for at in ((0, 0), (30.1, 0), (31.5, 40))
    ]  # the second meets the first, the third none
    paths = Paths(np.concatenate(shapes), np.array([0, 5, 10, 15]), np.arange(4))
    colors = Styles.of(*(((c, 20, 30, 255), None, 0.0) for c in (10, 90, 170)))
    drawing = Drawing(paths, np.arange(3), colors, np.array([62.0, 60.0]))
    made = make(drawing, EmbroideryParams(stitch="tatami", angle=0.0), Progress())
    first, second, third = (shapely.union_all(to_shapely(r.paths)) for r in made.regions)
    assert first.intersection(second).area == pytest.approx(20 * (UNDER + 0.2), rel=0.1)
    assert second.area == pytest.approx(600, rel=1e-6) and third.area == pytest.approx(600, rel=1e-6)
    assert first.difference(second).area == pytest.approx(600, rel=1e-3)


def test_an_arm_as_high_as_the_rows_stay_back_is_a_line_and_no_fault():
    square = [(0, 0), (20, 0), (20, 8), (32, 8), (32, 8.5), (20, 8.5), (20, 20), (0, 20), (0, 0)]
    assert len(sewn(np.array(square, float), FILL, stitch="tatami", angle=0.0, push=0.25))


def test_a_thread_of_nothing_may_come_first():
    from tambour.embroidery.plan.sequence import Layout
    from tambour.embroidery.stitches import join

    layout = Layout(EmbroideryParams())
    layout.stitches(join([]), 0)
    assert layout.here is None

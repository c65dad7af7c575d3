"""First positions: rings, turned the right way round, and parts where they belong."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import crochet_plain as plain
import crochet_toys as toys
from tambour import noise
from tambour.core.errors import Text
from tambour.crochet.graph import layout
from tambour.crochet.graph.build import build
from tambour.crochet.params import CrochetParams
from tambour.crochet.plush import worked
from tambour.crochet.printed.pattern import read_printed
from tambour.crochet.settle import arrange

EXAMPLES = Path(__file__).parents[1] / "examples" / "crochet"


def test_a_round_is_a_ring_above_the_one_before() -> None:
    toy = toys.tube(24, 10)
    x = layout.rounds(toy, toy.rest / 5.0)
    section = layout.sections(toy)
    assert section[0] == 0 and section[-1] == section[-2] + 1, "root and tip stand alone"
    assert not x[0].any()
    heights = []
    for s in range(1, section[-1]):
        ring = x[section == s]
        radius = np.hypot(ring[:, 0], ring[:, 2])
        np.testing.assert_allclose(radius, len(ring) / (2 * np.pi), rtol=1e-9)
        heights.append(ring[:, 1].mean())
        assert np.ptp(ring[:, 1]) < 1e-12
    rise = np.diff(heights)
    assert (rise > 0.29).all() and (abs(rise[4:12] - 1.0) < 1e-9).all()


@pytest.mark.parametrize("toy", [toys.ball(3, 3), toys.ball(9, 9), toys.tube(12, 8)])
def test_the_outside_is_outside(toy) -> None:
    assert plain.volume_of(layout.rounds(toy, toy.rest / 5.0), toy.faces) > 0


def test_stitches_stand_over_theirs() -> None:
    toy = toys.tube(12, 6)
    x = layout.rounds(toy, toy.rest / 5.0)
    for i in range(60, 90):
        assert np.linalg.norm(x[i] - x[toy.parent[i]]) < 1.05


def test_centroids_divide_the_axis() -> None:
    toy = toys.tube(24, 20)
    x = layout.rounds(toy, toy.rest / 5.0)
    c = layout.on_axis(x, 0, len(toy), 4)
    assert np.ptp(np.diff(c[:, 1])) < 1e-9 and abs(c[:, [0, 2]]).max() < 0.5


def test_fit_finds_the_motion() -> None:
    draw = noise.stream("fit")
    a = draw.normal(size=(9, 3))
    turn, _ = np.linalg.qr(draw.normal(size=(3, 3)))
    turn *= np.sign(np.linalg.det(turn))
    found, shift = arrange.fit(a, a @ turn.T + 4.0, np.ones(9))
    np.testing.assert_allclose(found, turn, atol=1e-12)
    np.testing.assert_allclose(shift, 4.0, atol=1e-12)
    mirrored, _ = arrange.fit(a, -a, np.ones(9))
    assert np.linalg.det(mirrored) > 0.99, "never a reflection"


_TYPED = """== A ==
R1: MR(6) (6)
R2: {two}
R3: {three}
== B (make 2) ==
R1: MR(6) (6)
R2: 6 inc (12)
R3: 12 sc (12)
"""


@pytest.mark.parametrize("turned", [False, True])
@pytest.mark.slow
def test_parts_that_are_remembered_stand_as_if_they_were_laid_out_anew(turned) -> None:
    """One who types changes a part at a time: whatever was laid out before, a layout is that of its own text."""
    pairs = [
        (two, three)
        for two in ("6 inc (12)", "6 sc (6)", "[sc, inc] x 3 (9)")
        for three in ("12 sc", "12 hdc", "3 sc, ch 2, 4 sc, turn, 4 sc")
    ]
    texts = [_TYPED.format(two=two, three=three) for two, three in pairs]
    texts += [path.read_text() for path in sorted(EXAMPLES.glob("*.txt")) + sorted(EXAMPLES.glob("*.acl"))]
    for text in reversed(texts) if turned else texts:
        graph = worked(Text(text, "t.acl" if text.startswith("==") else "t.txt"), CrochetParams())[0].graph
        beside = layout.rounds(graph, graph.rest / graph.stitch_width)
        again = layout.rounds(graph, graph.rest / graph.stitch_width)
        kept = dict(layout._laid)
        layout._laid.clear()
        alone = layout.rounds(graph, graph.rest / graph.stitch_width)
        layout._laid.update(kept)
        assert (beside == alone).all() and (again == alone).all()


def test_the_stitch_that_joins_a_round_does_not_make_a_toy_lean():
    """It is not worked into: the middle of what is lay beside the middle of the round, and twenty rounds leant by twelve degrees."""
    rounds_ = "".join(
        f"Rnd {k}: Ch 1. 1 sc in each st around. Join with sl st to first sc. 30 sc.\n" for k in range(6, 26)
    )
    begin = "Rnd 1: 6 sc in magic ring. Join with sl st to first sc. 6 sc.\n" + "".join(
        f"Rnd {k}: Ch 1. *1 sc in each of next {k - 2} sts. 2 sc in next st. Rep from * around. Join with sl st to first sc. {6 * k} sc.\n"
        for k in range(2, 6)
    )
    built = build(read_printed(Text(f"BALL\n{begin}{rounds_}Fasten off.\n", "ball.txt")))
    graph = built.graph
    x = layout.rounds(graph, graph.rest / graph.stitch_width)
    last = built.rounds[-1]
    middle = x[last.first : last.last + 1].mean(0)
    assert np.hypot(middle[0], middle[2]) < 0.1 * middle[1]

"""A pattern written back is in standard terms and makes the same graph."""

from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from tambour.core.errors import TambourError, Text
from tambour.crochet.graph.build import build
from tambour.crochet.language.parse import parse
from tambour.crochet.page.own import pattern
from tambour.crochet.printed.restated import restated

EXAMPLES = sorted((Path(__file__).resolve().parents[1] / "examples" / "crochet").glob("*.acl"))
FIELDS = ("part", "color", "parent", "round", "loop", "direction", "height", "peculiarity", "plane", "edges")
MORE = ("edge_kind", "rest", "faces", "anchors", "anchor_offsets", "previous")


def same(text):
    """Build, write, build again; the written text."""
    one = build(parse(Text(text)))
    again = pattern(one)
    two = build(parse(again, strict=True), strict=True)  # what we state must be right
    assert [one.graph.kinds[k] for k in one.graph.kind] == [two.graph.kinds[k] for k in two.graph.kind]
    assert one.graph.parts == two.graph.parts and one.sewn.tolist() == two.sewn.tolist()
    for name in FIELDS + MORE:
        assert np.array_equal(getattr(one.graph, name), getattr(two.graph, name)), name
    assert pattern(two).text == again.text
    return again.text


def test_standard_terms():
    text = same(
        "MR(6)\n:6inc\n# a tube\n: [sc, inc] around\n2: 9sc\n: 9 sc\ncolor(#ff0000)\n: 2 sc, 2 sc, dec, 4 sc, dec\n"
    )
    assert text == (
        "R1: MR(6) (6)\nR2: 6 inc (12)\nR3: [sc, inc] x 6 (18)\nR4-R6: 9 sc (18)\n"
        "color(255, 0, 0)\nR7: [4 sc, dec] x 2 (16)\n"
    )


@pytest.mark.parametrize(
    "text",
    [
        "== Arm (make 3) ==\n@stuffing = light\n: MR(5)\n2: 5 sc, mark(t)\n".replace("2: 5", ": 5")
        + "== Body ==\n@centroids = 2\n: MR(6), mark(b)\n: 6 sc\nFO\nsew(t.2, b)\n",
        "define puff(height 2) = 3 pull through, pull over # round\n: MR(6)\n: [puff, ch] x 6\n",
        ": ch 8, turn\n: 7 sc\n3: turn, ch, 7 sc\n: turn, ch 3, 7 dc\n",
        ": MR(6), join\n: ch, 6 inc, join\n: ch, [FLO, sc, BLO, sc, color(blue)] x 6, join\n",
        ": MR(6)\nmark(a)\n: MR(6)\nmark(b)\n: attach(a), 6 sc, attach(b, merge), 6 sc\n",
        "@tip_from_fo = false\n: MR(6)\n: slst, FO, mark(h)\ngoto(h)\n: 5 sc\n",
        ": MR(6)\n: 6 inc\n: mark(x), 6 sc, mark(y), attach(x, 3)\n: [sc, inc] around\ngoto(y)\n: sc around\n",
    ],
)
def test_written_back(text):
    same(text)


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda p: p.stem)
def test_examples_written_back(path):
    same(path.read_text(encoding="utf-8"))


ITEM = st.sampled_from(["sc", "2 sc", "inc", "dec", "hdc", "3 dc", "ch", "sk", "slst", "BLO", "color(red)", "tr2tog"])
ROUND = st.lists(ITEM, min_size=1, max_size=6).flatmap(
    lambda items: st.sampled_from([f": {', '.join(items)}", f": [{', '.join(items)}] x 2", f"2: {', '.join(items)}"])
)


@settings(max_examples=150, deadline=None, suppress_health_check=list(HealthCheck), derandomize=True)
@given(st.integers(3, 12), st.lists(ROUND, max_size=6))
@pytest.mark.slow
def test_whatever_builds_is_written_back(ring, rounds):
    text = "\n".join([f": MR({ring})", *rounds])
    try:
        build(parse(Text(text)))
    except TambourError:
        return
    same(text)


def test_finishing_is_written_back():
    text = (
        "== Head ==\nR1: MR(6)\nR2-R9: 6 sc\n== Ear (make 2) ==\nR1: MR(6)\n"
        "place(Ear.1, Head, round=3.5, stitch=2, tilt=20, towards=90, across=-12.5, flat)\nplace(Ear.2, Head, round=3.25, by=1)\n"
        "eye(Head, round=4.5, stitch=4, size=9)\neye(Head, round=4, stitch=0, size=7.5, color=#0a0b0c)\n"
        "embroider(Head, 5:1, 5.5:2, 5:3, color=white, width=3)\nembroider(Head, 6)\nfelt(Head, heart, round=7, stitch=1, "
        "width=12, height=9, turn=30, color=#ff8800)\nfelt(Head, round=7)\nhair(Head, 1:1, 1:6, count=20, length=45, color=#654321)\n"
    )
    one = parse(Text(text))
    assert len(one.finish) == 9 and parse(pattern(one)).finish == one.finish
    assert "place(Ear.2, Head, round=3.25, by=1)" in same(text)


def test_written_numbers_are_kept():
    text = pattern(parse(Text(": MR(6)\nR7: 6 inc\nR8-R9: 12 sc\nR10: 12 sc\n: 12 sc\n"))).text
    assert [line.split(":")[0] for line in text.splitlines()] == ["R1", "R7", "R8-R11"]


def test_printed_patterns_become_the_language():
    text = (
        "## Abbreviations (US terms)\n\n- sc = single crochet\n\n## Special stitches\n\n- puff (height 2) = 3 pull up a loop, "
        "yarn over and draw through\n- vee = 2 puff, ch\n\n## Tête & cou\n\nRnd 1: 6 sc in magic ring (6)\nRnd 2: [vee, sc] x 3\n\n"
        "## Ear 1 (make 2)\n\nRnd 1: 6 sc in magic ring (6)\n\n## Assembly\n\n- Sew Ear 1 2 to Tête & cou, Rnd 2, st 3.\n"
    )
    one = restated(Text(text))
    again = pattern(one)
    assert "== Tete cou ==" in again.text and "== Ear _1 (make 2) ==" in again.text
    assert "define puff (height 2) = 3 pull through, pull over\ndefine vee = 2 puff, ch\n" in again.text
    assert "place(Ear _1.2, Tete cou, round=2, stitch=3)" in again.text
    two = build(parse(again))
    assert np.array_equal(build(one).graph.edges, two.graph.edges)
    assert np.array_equal(build(one).graph.height, two.graph.height)

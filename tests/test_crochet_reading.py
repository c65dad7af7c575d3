"""Printed patterns are read to the graph that their twins in tambour's own language give."""

import time
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from tambour.core.errors import TambourError, Text
from tambour.crochet.build import build
from tambour.crochet.parse import parse
from tambour.crochet.printed import NOTHING, read_printed
from tambour.crochet.reading import account, read

MAKERS = sorted((Path(__file__).resolve().parent / "data" / "makers").glob("*.txt"))
FIELDS = ("part", "color", "parent", "round", "loop", "direction", "height", "peculiarity", "edges", "faces")


def same(printed, own):
    """Both texts build the same graph; the printed one as read, and its warnings."""
    one, two = build(printed), build(own)
    assert [one.graph.kinds[k] for k in one.graph.kind] == [two.graph.kinds[k] for k in two.graph.kind]
    assert [p.name for p in one.graph.parts] == [p.name for p in two.graph.parts]
    for name in FIELDS:
        assert np.array_equal(getattr(one.graph, name), getattr(two.graph, name)), name
    return one


@pytest.mark.parametrize("path", MAKERS, ids=lambda p: p.stem)
def test_makers(path):
    pattern = read(Text(path.read_text(encoding="utf-8"), path.name))
    assert not [p for p in pattern.warnings if "look" in p.message]
    twin = path.with_suffix(".acl")
    if twin.exists():
        built = same(pattern, read(Text(twin.read_text(encoding="utf-8"), twin.name)))
    else:
        built = build(pattern)
    assert not [w for w in built.warnings if "the pattern says" in w.message]


PROSE = [
    "1. Mix 2 cups of flour with 1 egg.\n2. Knead for 10 minutes.\n3. Bake at 200 degrees (fan 180) for 30 min.\n",
    "Round 3 of the championship begins on Sunday. Row 7, seats 4-9, are still free.\nTickets: 12 pounds.\n",
    "Row 1: K2, P2, rep from * to end.\nRow 2: Purl.\nRows 3-10: As rows 1 and 2.\nCast off. (24 sts)\n",
    "<html><body><div class='x'>Hello &amp; goodbye</div><script>for (i = 0; i < 6; i++) {}</script></body></html>\n",
    "def f(x):\n    return [x * 2 for x in (1, 2, 3)]\n",
    "\x00\x01\x02PK\x03\x04 binary \ufffd\ufffd\n",
    "(((((([[[[[[{{{{{{ * * * * 6 6 6 6\n",
]


@pytest.mark.parametrize("text", PROSE)
def test_no_instructions(text):
    with pytest.raises(TambourError) as told:
        read(Text(text, "story.txt"))
    assert len(told.value.problems) == 1 and told.value.problems[0].message == NOTHING


WORDS = st.sampled_from(
    [
        "Rnd",
        "1",
        ":",
        "6",
        "sc",
        "in",
        "magic",
        "ring",
        "(",
        ")",
        "[",
        "]",
        "{",
        "}",
        "*",
        "x",
        "12",
        "rep",
        "from",
        "around",
        "inc",
        "dec",
        ",",
        ".",
        ";",
        "-",
        "=",
        "next",
        "st",
        "each",
        "of",
        "2",
        "3",
        "turn",
        "join",
        "ch",
        "change",
        "to",
        "white",
        "BLO",
        "with",
        "fasten",
        "off",
        "skip",
        "same",
        "repeat",
        "times",
        "twice",
        "first",
        "last",
        "make",
        "##",
        "**",
        "hook",
    ]
)


@settings(max_examples=300, deadline=None, suppress_health_check=list(HealthCheck), derandomize=True)
@given(st.lists(st.lists(WORDS, max_size=14).map(" ".join), max_size=6).map("\n".join))
def test_whatever_is_written_is_read_or_told(text):
    try:
        pattern = read_printed(Text("Rnd 1: 6 sc in MR (6)\nRnd 2: " + text))
        build(pattern)
    except TambourError as told:
        assert all(0 <= p.span.start <= p.span.end <= len(text) + 30 for p in told.problems if p.span)


@settings(max_examples=200, deadline=None, suppress_health_check=list(HealthCheck), derandomize=True)
@given(st.text(max_size=300))
def test_any_text(text):
    try:
        build(read(Text(text, "any.txt")))
    except TambourError as told:
        assert told.problems


def test_noise_is_refused_quickly():
    line = "the quick brown fox 12 jumps (over) *the* lazy dog, row 3: again and again. "
    for text in (line * 1400, "Rnd 3: foo bar\n" * 7000, "(" * 100_000, "* " * 50_000, "sc, " * 25_000, "a" * 100_000):
        begin = time.perf_counter()
        with pytest.raises(TambourError):
            build(read(Text(text, "noise.txt")))
        assert time.perf_counter() - begin < 0.2 * len(text) / 10_000 * 2  # a busy machine may take twice as long


def test_the_report_says_what_was_read():
    text = "Ball (UK terms)\nHook: 3 mm\nA lovely thing for a rainy day.\nRnd 1: 6 dc in MR (6)\nRnd 2: 2 dc in each st (12)\n"
    said = account(read(Text(text)))
    assert said["terms"] == "uk" and said["passed_over"] == 1 and said["not_understood"] == []
    assert said["stated"] == {"title": "Ball (UK terms)", "hook": "3 mm"}
    assert account(parse(Text(": MR(6)\n"))) == {}
